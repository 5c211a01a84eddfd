(** Who merges from S0, for every mass ratio, without a hypothesis on re-entries.

    For m1/m2 <= - cos (2 phi* ) the energies on S0 that merge at the first re-entry are exactly one closed interval
    above E_cr. For m1/m2 > - cos (2 phi* ) nothing that has touched S above E_cr ever merges: not after the first
    slip, nor after any later one. *)
From InertialPair Require Import Dini Pair Stick EnergyLimit Excursion ReturnMap TurningFunction FollowArc Cycle
  ExitOrbit SharpRate SharpLaw SlipFromGap AlternatingAngles AfterOneSlip.
From InertialPair Require Import LevelAfterSlip ReturnToS0.

(** the next contact is not later than the first re-entry *)
Lemma contact_first l x v1 v2 t0 t1 t : contact_after v1 v2 t0 t1 -> first_reentry l x v1 v2 t0 t -> t1 <= t.
Proof.
  intros C F. inversion F as [a c C1 I|a c d C1 O F1]; subst.
  - rewrite (contact_unique _ _ _ _ _ C C1). lra.
  - rewrite (contact_unique _ _ _ _ _ C C1). apply first_reentry_in in F1. lra.
Qed.

Section Rounds.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (o1 := o1 m1 a2) (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b)
  (E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) (O0 : 0 < o1 := o1_pos m1 a2 Hm1 Ha2).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Let Emono t u : 0 <= t <= u -> E u <= E t := E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t u.
(** a contact in S0 above E_cr *)
Let above t := 0 <= t /\ v1 t = v2 t /\ - L <= x t <= L /\ Ecr < E t.

(** From a contact in S0 above E_cr: stuck up to an exit ray, at the half angle of its energy, then a first re-entry. *)
Lemma round t0 : above t0 -> exists k te p t, (k = 1 \/ k = -1) /\ t0 <= te /\ 0 < p < PI /\
  E t0 = Ecr * (1 + q * hh p ^ 2) /\
  (forall t', t0 <= t' <= te -> v1 t' = v2 t' /\ - L <= x t' <= L) /\ on_ray m1 m2 a2 b k (hh p) x v1 v2 te /\
  first_reentry L x v1 v2 te t /\ te + 2 * p / o1 <= t.
Proof.
  intros (Ht & Ev & Hx & HE). destruct (level_push m1 m2 a2 b Hm1 Hm2 Ha2 Hb _ HE) as (U & En).
  destruct (half_ex _ U) as (p & Hp & Hu). rewrite <- Hu in En. fold q Ecr in En.
  destruct (to_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H t0 (hh p) Ht Ev Hx (hh_pos p Hp) En) as (k & te & Hk & Te
    & HR & St). destruct (returns m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k 0 (hh p) te Hk ltac:(lra) (or_intror (conj
    eq_refl (hh_pos p Hp))) (proj1 (ray_gap m1 m2 a2 b k (hh p) x v1 v2 te) HR)) as (t & F).
  exists k, te, p, t. split; [exact Hk|]. split; [lra|]. split; [exact Hp|]. split; [exact En|].
  split; [exact St|]. split; [exact HR|]. split; [exact F|].
  destruct (merges_at_first_landing m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k te p Hk ltac:(lra) Hp HR) as (Sg & Ec & _).
  assert (T0 : 0 < 2 * p / o1) by positive. apply (contact_first L x v1 v2 te); auto.
  split; [fold o1; lra|]. split; [|exact Ec]. intros t' Hu' Q. specialize (Sg t' Hu'). rewrite Q in Sg. lra.
Qed.

(** *** Below a level from which first re-entries stay above E_cr, E never comes down to it *)
Section Again.
Variable e : R.
Hypothesis again : forall k te p t, k = 1 \/ k = -1 -> 0 <= te -> 0 < p < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 te ->
  E te <= e -> first_reentry L x v1 v2 te t -> Ecr < E t.
(** one round takes at least a fixed time, unless the level is small: then E stays above E_cr anyway *)
Let tau := 2 * half (2 / 3) / o1.
(** so there is a next contact in S0 above E_cr, or the energy never comes down *)
Lemma next_above t0 : above t0 -> E t0 <= e -> (forall t, 0 <= t -> Ecr < E t) \/
  exists t, t0 + tau <= t /\ above t /\ E t <= e.
Proof.
  intros A Le. pose proof A as (Ht & Ev & Hx & HE). destruct (Rle_dec (E t0) (Ecr * (1 + 4 / 9 * q))) as [Sm|Bg].
  - left. apply (no_merging_from_S0 m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t0); auto. apply small_simple; auto.
  - right. apply Rnot_le_lt in Bg. destruct (round t0 A) as (k & te & p & t & Hk & Te & Hp & En & _ & HR & F & Tt).
    exists t. destruct (half_spec (2 / 3) ltac:(lra)) as (P3 & H3). set (p3 := half (2 / 3)) in *.
    assert (P : p3 <= p).
    { apply hh_le; auto. rewrite H3. pose proof (hh_pos p Hp). rewrite En in Bg.
      assert (EQ : 0 < Ecr * q) by positive.
      assert (Ecr * q * (4 / 9) < Ecr * q * hh p ^ 2) by lra. apply Rmult_lt_reg_l in H1; auto. nra. }
    assert (tau <= 2 * p / o1). { unfold tau, Rdiv.
      apply Rmult_le_compat_r; [positive|lra]. }
    destruct (first_reentry_in _ _ _ _ _ _ F) as (T1 & Ev1 & I1). pose proof (Emono t0 te ltac:(lra)).
    pose proof (Emono te t ltac:(lra)). split; [lra|]. split; [|lra]. repeat split; auto; try lra.
    apply (again k te p t); auto; lra.
Qed.
(** so it never does *)
Theorem stays_above t0 : above t0 -> E t0 <= e -> forall t, t0 <= t -> Ecr < E t.
Proof.
  intros A0 Le T HT.
  assert (P3 : 0 < tau). { destruct (half_spec (2 / 3) ltac:(lra)) as (P3 & _). apply Rdiv_lt_0_compat; lra. }
  assert (Far : forall n, (forall t, 0 <= t -> Ecr < E t) \/ exists t, t0 + INR n * tau <= t /\ above t /\ E t <= e).
  { induction n as [|n [All|(t & Hn & A & Lt)]]; [right; exists t0; simpl; split; [lra|auto]|left; exact All|].
    destruct (next_above t A Lt) as [All|(t' & Hn' & A')]; [left; exact All|right]. exists t'. rewrite S_INR.
      split; [lra|auto]. }
  destruct (nat_above (T - t0) tau P3) as (n & Hn).
    destruct (Far n) as [All|(t & Hn' & (_ & _ & _ & Up) & _)]; [apply All; destruct A0; lra|].
  apply Rlt_le_trans with (1 := Up). apply Emono. destruct A0. split; [lra|]. apply Rle_trans with (2 := Hn'). lra.
Qed.
End Again.

(** *** Heavy drivers: every slip ends above E_cr *)
Section Heavy.
Hypothesis high : forall p d, 0 < p < PI -> 0 <= d -> 0 < level m1 m2 p d.

(** so does the first re-entry, after any number of crossings *)
Lemma reentry_above t0 t : first_reentry L x v1 v2 t0 t -> forall k d u, k = 1 \/ k = -1 -> 0 <= t0 ->
  (0 < d \/ (d = 0 /\ 0 < u)) -> at_gap m1 m2 a2 b k d u x v1 v2 t0 -> above t.
Proof.
  induction 1 as [t0 t1 C I|t0 t1 t C O F IH]; intros k d u Hk Ht Hd HG.
  all: destruct (push_at d u Hd) as (p & Hp & <-); assert (D0 : 0 <= d) by lra; pose proof (contact_unique _ _
    _ _ _ C
    (slip_contact m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k d p t0 Hk Ht D0 Hp HG)) as T.
  all: destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 d p Hk H Ht D0 Hp HG) as (_ & _ & _ & _ & _
    & En).
  all: rewrite <- T in En; destruct C as (T1 & _ & Ev).
  all: assert (HE : Ecr < E t1) by (unfold E; rewrite En; fold q Ecr; pose proof (high p d Hp D0);
    assert (0 < Ecr * (q * level m1 m2 p d)) by positive; lra).
  - repeat split; auto; lra.
  - destruct (beyond_gap m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 t1 Ev O) as (k' & d' & u' & Hk' & Hd' & HG').
    apply (IH k' d' u'); auto. lra.
Qed.

(** Nothing that has touched S above E_cr comes down to E_cr. *)
Theorem never_down t0 : 0 <= t0 -> v1 t0 = v2 t0 -> Ecr < E t0 -> forall t, t0 <= t -> Ecr < E t.
Proof.
  intros Ht Ev HE T HT. assert (St : exists t1, t0 <= t1 /\ above t1).
  { destruct (Rle_dec (x t0) L) as [I1|N1]; [destruct (Rle_dec (- L) (x t0)) as [I2|N2]|].
    1: exists t0; repeat split; auto; lra.
    all: destruct (beyond_gap m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 t0 Ev ltac:(fold L; lra)) as (k & d & u & Hk & Hd & HG);
      destruct (returns m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k d u t0 Hk Ht (or_introl Hd) HG) as (t1 & F);
      exists t1; split; [apply first_reentry_in in F; lra|]; apply (reentry_above t0 t1 F k d u); auto. }
  destruct St as (t1 & Ht1 & A1). destruct (Rle_dec t1 T) as [Late|Early].
  - apply (stays_above (E t1)) with t1; auto; [|lra]. intros k te p t Hk Te Hp HR _ F.
    apply (reentry_above te t F k 0 (hh p)); auto; [right; split; [auto|apply hh_pos; auto]|]. apply ray_gap. exact HR.
  - destruct A1 as (_ & _ & _ & Up). apply Rlt_le_trans with (1 := Up). apply Emono. lra.
Qed.
End Heavy.
End Rounds.

(** [heavy-never-merges] For $m_1/m_2>-\cos 2\varphi^*$: no solution that has touched $S$ above $E_{cr}$ ever merges,
    after whatever number of slips. *)
Theorem heavy_never_merges : exists ps, 0 < ps < PI /\ K ps = 0 /\ forall m1 m2 a2 b, 0 < m1 -> 0 < m2 ->
  0 < a2 -> 0 < b ->
  - cos (2 * ps) < m1 / m2 -> forall x v1 v2 s t0, solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> v1 t0 = v2 t0 ->
  Ecr m1 m2 a2 b < energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) ->
  forall t, t0 <= t -> Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t).
Proof.
  destruct no_low_level as (ps & Hps & Z & Lev). exists ps. split; [auto|]. split; [auto|].
  intros m1 m2 a2 b H1 H2 Ha Hb Hr x v1 v2 s t0 H Ht Ev HE.
  exact (never_down m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H (Lev m1 m2 H1 H2 Hr) t0 Ht Ev HE).
Qed.
