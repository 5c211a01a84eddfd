(** The paper's Fig. 5 (m1 = m2 = 1, a2 = 200, b = 0.05, started at rest but for v1 = 0.15;
    its events until t = 4.7 are those of Velocities.v): when the pair first sticks, for how long,
    and that it slips at t = 4.7, where the paper has it stick. *)
From Coq Require Import QArith Qreals List.
From InertialPair Require Import Dini Pair Pursuit Forced Waves Trajectory Velocities.
Import ListNotations.

(** slips at the head of a table: the velocities agree only where one of them ends *)
Lemma slips_first x v1 x2 v2 now later e : forall slips t, unfolds x v1 x2 v2 t (slips ++ now :: later) e ->
  (forall m, In m (slips ++ [now]) -> mode_until m <> Stick) -> exists ta contacts, t < ta /\
  within (time now) ta /\ within (place now) (x ta) /\ within (speed now) (v1 ta) /\ v1 ta = v2 ta /\
  length contacts = length slips /\ NoDup contacts /\ (forall u, In u contacts <-> t < u < ta /\ v1 u = v2 u) /\
  unfolds x v1 x2 v2 ta later e.
Proof.
  induction slips as [|m slips IH]; intros t (t1 & Ht & W & X & _ & V & E & Md & U) S.
  all: assert (Apart : forall u, t < u < t1 -> v1 u <> v2 u) by (intros u Hu Q; specialize (Md u Hu);
    specialize (S _ (or_introl eq_refl)); destruct mode_until as [[|]|]; simpl in Md; [lra|lra|congruence]).
  - exists t1, []. do 6 (split; [auto|]). split; [constructor|]. split; [|exact U]. intros u.
    split; [intros []|intros (Hu & Q); exact (Apart u Hu Q)].
  - destruct (IH t1 U (fun m Hm => S m (or_intror Hm))) as (ta & cs & Ha & A & B & C & D & Ln & Nd & Cs & U').
    exists ta, (t1 :: cs). split; [lra|]. do 4 (split; [auto|]). split; [simpl; auto|]. split; [|split; [|auto]].
    + constructor; auto. intros Q. apply Cs in Q. lra.
    + intros u. simpl. rewrite Cs. split; [intros [<-|(Hu & Q)]; split; auto; lra|intros (Hu & Q)].
      destruct (Rtotal_order u t1) as [L|[->|G]]; [destruct (Apart u ltac:(lra) Q)|auto|right; split; [lra|auto]].
Qed.

(** among finitely many times is none in some part of every interval *)
Lemma gap (l : list R) : forall p q, p < q -> exists u, p < u < q /\ ~ In u l.
Proof.
  induction l as [|r l IH]; intros p q Hp.
  - exists ((p + q) / 2). split; [lra|auto].
  - destruct (Rlt_dec p r) as [Pr|Pr].
    + destruct (IH p (Rmin r q)) as (u & Hu & N); [apply Rmin_glb_lt; auto|]. pose proof (Rmin_l r q).
      pose proof (Rmin_r r q). exists u. split; [lra|]. intros [->|I]; [lra|auto].
    + destruct (IH p q Hp) as (u & Hu & N). exists u. split; [lra|]. intros [->|I]; [lra|auto].
Qed.

(** from rest but for the speed V of body 1, with the friction B *)
Definition from_speed V B := Scene 1 1 0 200 0 V 0 0 (Spell 0 B (Steady 0%Q [] [])) [].
(** a solution from such a start is a motion of the scene *)
Lemma speed_motion V B x v1 v2 s : solution 1 1 0 200 (Q2R B) x v1 v2 s -> x 0 = 0 -> v1 0 = Q2R V -> v2 0 = 0 ->
  motion (from_speed V B) x v1 (integral v2) v2.
Proof.
  intros H X0 V1 V2. pose proof (proj2 (free_case 1 1 0 200 (Q2R B) x v1 v2 s) H) as F.
  assert (Cv : cont v2) by exact (moves_cv2 1 1 0 200 (Q2R B) Rlt_0_1 _ _ _ _ _ _ F).
  exists (fun _ => 0). unfold from_speed; simpl. split; [apply cont_const|]. split; [intros t _; apply rderiv_const|].
  rewrite X0, V1, V2, integral_0. unfold Q2R at 1 2 3 4; simpl. replace (1 * / 1) with 1 by field.
  replace (0 * / 1) with 0 by field. replace (200 * / 1) with 200 by field. split; [exists s; exact F|].
  split; [apply integral_cont; auto|]. split; [intros; apply integral_rderiv; auto|]. unfold Q2R; simpl. lra.
Qed.

(** slips at the head of a table, after a start in slip: the first time at which the velocities agree but at single
    instants is not before the last of them ends *)
Lemma entry x v1 x2 v2 slips now later e : unfolds x v1 x2 v2 0 (slips ++ now :: later) e -> v1 0 <> v2 0 ->
  (forall m, In m (slips ++ [now]) -> mode_until m <> Stick) ->
  exists ta contacts, 0 < ta /\ within (time now) ta /\ within (place now) (x ta) /\ within (speed now) (v1 ta) /\
    v1 ta = v2 ta /\
    length contacts = length slips /\ NoDup contacts /\ (forall u, In u contacts <-> 0 <= u < ta /\ v1 u = v2 u) /\
      unfolds x v1 x2 v2 ta later e.
Proof.
  intros U N S. destruct (slips_first _ _ _ _ _ _ _ _ _ U S) as (ta & cs & A & B & C & D & E & Ln & Nd & Cs & U').
  exists ta, cs. repeat (split; [assumption|]). split; [|auto]. intros u. rewrite Cs.
  split; intros (Hu & Q); split; auto; [lra|]. destruct (Req_dec u 0) as [->|]; [contradiction|lra].
Qed.

(** [first-adhesion] The scene of Fig. 5: every solution sticks from 4.549769479... s to 4.579537997... s, not before,
    slips until 4.771754480... s, including 4.7 s, and sticks again. *)
Theorem first_adhesion x v1 v2 s : solution 1 1 0 200 (5 / 100) x v1 v2 s -> x 0 = 0 -> v1 0 = 15 / 100 -> v2 0 = 0 ->
  exists ta tb tc td contacts, 45497694797 / 10 ^ 10 <= ta <= 45497694798 / 10 ^ 10 /\
  45795379975 / 10 ^ 10 <= tb <= 45795379977 / 10 ^ 10 /\ 47717544800 / 10 ^ 10 <= tc <= 47717544802 / 10 ^ 10 /\
  49110237173 / 10 ^ 10 <= td <= 49110237174 / 10 ^ 10 /\
  length contacts = 20%nat /\ (forall u, 0 <= u < ta -> (v1 u = v2 u <-> In u contacts)) /\
  (forall p q, 0 <= p < q -> q <= ta -> exists u, p < u < q /\ v1 u <> v2 u) /\
  (forall u, ta <= u <= tb -> v1 u = v2 u) /\ (forall u, tb < u < tc -> v1 u < v2 u) /\
  (forall u, tc <= u <= td -> v1 u = v2 u).
Proof.
  intros H X0 V1 V2. pose proof (trajectory _ _ _ _ (speed_motion 0.15 0.05 x v1 v2 s H X0 V1 V2)) as U.
  change the_events with (firstn 20 the_events ++ nth 20 the_events (Event Stick (0, 0) (0, 0) (0, 0) (0, 0))%Q ::
    skipn 21 the_events) in U.
  apply entry in U; [|lra|intros m Hm; simpl in Hm; repeat (destruct Hm as [<-|Hm]; [discriminate|]); contradiction].
  destruct U as (ta & times & T0 & Wa & _ & _ & Ea & Ln & _ & Cs' & U).
  assert (Cs : forall u, 0 <= u < ta -> (v1 u = v2 u <-> In u times)) by (intros u Hu; rewrite Cs'; tauto).
  destruct U as (tb & Hb & Wb & _ & _ & _ & Eb & Mb & U). destruct U as (tc & Hc & Wc & _ & _ & _ & Ec & Mc & U).
  destruct U as (td & Hd & Wd & _ & _ & _ & Ed & Md & _). unfold within in Wa, Wb, Wc, Wd. simpl in Wa, Wb, Wc, Wd.
  unfold Q2R in Wa, Wb, Wc, Wd. simpl in Wa, Wb, Wc, Wd. exists ta, tb, tc, td, times. do 4 (split; [lra|]).
  split; [auto|]. split; [auto|]. split; [|split; [|split]].
  - intros p q Hp Hq. destruct (gap times p q ltac:(lra)) as (u & Hu & N). exists u. split; [lra|].
    rewrite Cs by lra. auto.
  - intros u Hu. destruct (Req_dec u ta) as [->|]; auto. destruct (Req_dec u tb) as [->|]; auto. apply Mb; lra.
  - intros u Hu. apply Mc; lra.
  - intros u Hu. destruct (Req_dec u tc) as [->|]; auto. destruct (Req_dec u td) as [->|]; auto. apply Md; lra.
Qed.
