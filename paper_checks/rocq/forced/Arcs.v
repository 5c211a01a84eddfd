(** Motions under a force, put together from arcs: what starts on a smooth arc that obeys the law of friction runs
    along it; the mirror image of a motion; motions that repeat with the opposite sign. *)
From InertialPair Require Import Forced ForcedExistence.

(** continuity along a path of times that never runs faster than time *)
Lemma cont_path f c : (forall t, 0 <= t -> 0 <= c t) -> (forall r t, Rabs (c t - c r) <= Rabs (t - r)) -> cont f ->
  cont (fun t => f (c t)).
Proof.
  intros P L C t Ht e He. destruct (C (c t) (P t Ht) e He) as (d & Hd & K). exists d; split; auto. intros r Hr Hd1.
  apply K; auto. eapply Rle_lt_trans; [apply L|auto].
Qed.

(** f until T, and from then on g *)
Definition join T (f g : R -> R) t := if Rlt_dec t T then f t else g (t - T).

(** until T it is f *)
Lemma join_before T f g t : f T = g 0 -> t <= T -> join T f g t = f t.
Proof.
  intros E Ht. unfold join. destruct (Rlt_dec t T); auto. replace t with T by lra. rewrite Rminus_diag_eq; auto.
Qed.
(** from T on it is g *)
Lemma join_after T f g t : T <= t -> join T f g t = g (t - T).
Proof. intros Ht. unfold join. destruct (Rlt_dec t T); auto; lra. Qed.

(** continuous if the ends meet *)
Lemma cont_join T f g : 0 <= T -> f T = g 0 -> cont f -> cont g -> cont (join T f g).
Proof.
  intros HT E F G. apply cont_ext with (fun t => f (Rmin t T) + g (Rmax (t - T) 0) - g 0).
  - intros t Ht. destruct (Rle_dec t T).
    + rewrite join_before, Rmin_left, Rmax_right by (auto; lra). ring.
    + rewrite join_after, Rmin_right, Rmax_left by lra. rewrite E. ring.
  - apply cont_minus; [apply cont_plus|apply cont_const].
    + apply (cont_path f (fun t => Rmin t T)); auto.
      * intros t Ht. apply Rmin_glb; auto.
      * intros r t. unfold Rmin. repeat destruct Rle_dec; apply Rabs_le; unfold Rabs; destruct Rcase_abs; lra.
    + apply (cont_path g (fun t => Rmax (t - T) 0)); auto.
      * intros t Ht. apply Rmax_r.
      * intros r t. unfold Rmax. repeat destruct Rle_dec; apply Rabs_le; unfold Rabs; destruct Rcase_abs; lra.
Qed.

Lemma rderiv_join_before T f g t l : f T = g 0 -> t < T -> rderiv f t l -> rderiv (join T f g) t l.
Proof.
  intros E Ht. apply rderiv_near with (T - t); [lra|]. intros u Hu. symmetry. apply join_before; auto; lra.
Qed.
(** from T on *)
Lemma rderiv_join_after T f g t l : T <= t -> rderiv g (t - T) l -> rderiv (join T f g) t l.
Proof.
  intros Ht G. apply rderiv_ext with (fun u => g (u - T)); [|apply rderiv_later; auto].
  intros u Hu. symmetry. apply join_after; lra.
Qed.

(** Lipschitz if both are *)
Lemma lip_join T c f g r t : 0 <= T -> f T = g 0 -> (forall r t, 0 <= r <= t -> t <= T ->
  Rabs (f t - f r) <= c * (t - r)) ->
  (forall r t, 0 <= r <= t -> Rabs (g t - g r) <= c * (t - r)) -> 0 <= r <= t ->
  Rabs (join T f g t - join T f g r) <= c * (t - r).
Proof.
  intros HT E F G Hr. unfold join. destruct (Rlt_dec t T), (Rlt_dec r T); try lra.
  - apply F; lra.
  - replace (g (t - T) - f r) with ((g (t - T) - g 0) + (f T - f r)) by lra. eapply Rle_trans; [apply Rabs_triang|].
    pose proof (F r T ltac:(lra) (Rle_refl T)). pose proof (G 0 (t - T) ltac:(lra)). lra.
  - replace (t - r) with (t - T - (r - T)) by ring. apply G. lra.
Qed.

Section Arcs.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let forced := forced m1 m2 a1 a2 b.

(** a motion from a later time on, under the force from then on *)
Lemma forced_shift U x v1 v2 s t0 : 0 <= t0 -> forced U x v1 v2 s ->
  forced (fun u => U (t0 + u)) (fun u => x (t0 + u)) (fun u => v1 (t0 + u)) (fun u => v2 (t0 + u)) (fun u => s (t0 +
    u)).
Proof.
  unfold forced. rewrite !forced_moves. intros Ht (CU & H). split; [apply cont_shift; auto|apply moves_later; auto].
Qed.

(** the mirror image of a motion is one under the opposite force: all terms are odd *)
Lemma forced_mirror U x v1 v2 s : forced U x v1 v2 s ->
  forced (fun t => - U t) (fun t => - x t) (fun t => - v1 t) (fun t => - v2 t) (fun t => - s t).
Proof.
  unfold forced. rewrite !forced_moves. intros (CU & H). split; [apply cont_opp; auto|apply moves_mirror; auto].
Qed.

(** a motion until a time, of which friction may be c times as strong in a stick *)
Record moves_until T c (U x v1 v2 s : R -> R) : Prop := {
  u_lip : forall r t, 0 <= r <= t -> t <= T -> Rabs (s t - s r) <= c * (t - r);
  u_slip : forall t, 0 <= t < T -> opposes s (v1 t - v2 t) t;
  u_cx : cont x;
  u_cv : cont v1;
  u_x : forall t, 0 <= t < T -> rderiv x t (v1 t);
  u_v1 : forall t, 0 <= t < T -> rderiv (fun r => m1 * v1 r + b * s r - U r) t (- (a2 * x t + a1 * v1 t));
  u_v2 : forall t, 0 <= t <= T -> m2 * v2 t - b * s t = m2 * v2 0 - b * s 0 }.

(** and another one from there *)
Theorem joined T c U x v1 v2 s y w1 w2 z : 0 <= T -> moves_until T c U x v1 v2 s ->
  moves m1 m2 a1 a2 b c (fun t => U (T + t)) y w1 w2 z -> x T = y 0 -> v1 T = w1 0 -> v2 T = w2 0 ->
  moves m1 m2 a1 a2 b c U (join T x y) (join T v1 w1) (join T v2 w2) (join T s (fun t => s T + (z t - z 0))).
Proof.
  intros HT [Al As Ax Av Dx D1 A2] [Bl Bs Bx Bv Dy E1 B2] X0 V0 W0. set (g := fun t => s T + (z t - z 0)).
  assert (G : s T = g 0) by (unfold g; ring).
  assert (Early : forall t, t <= T -> join T x y t = x t /\ join T v1 w1 t = v1 t /\ join T v2 w2 t = v2 t /\
    join T s g t = s t) by (intros t Ht; rewrite !join_before by auto; auto).
  assert (Late : forall t, T <= t -> join T x y t = y (t - T) /\ join T v1 w1 t = w1 (t - T) /\
    join T v2 w2 t = w2 (t - T) /\ join T s g t = g (t - T)) by (intros t Ht; rewrite !join_after by auto; auto).
  assert (Lg : forall p q, 0 <= p <= q -> Rabs (g q - g p) <= c * (q - p)).
  { intros p q Hp. replace (g q - g p) with (z q - z p) by (unfold g; ring). auto. }
  assert (Rg : forall t k, rderiv z t k -> rderiv g t k).
  { intros t k D. unfold g. rate. ring. }
  constructor; auto using cont_join.
  - intros r t. apply lip_join; auto.
  - intros t Ht k Hk W. destruct (Rlt_dec t T) as [Lt|].
    + destruct (Early t ltac:(lra)) as (_ & Q1 & Q2 & _). rewrite Q1, Q2 in W. apply rderiv_join_before; auto.
      apply (As t ltac:(lra) k Hk W).
    + destruct (Late t ltac:(lra)) as (_ & Q1 & Q2 & _). rewrite Q1, Q2 in W. apply rderiv_join_after; [lra|].
      apply Rg, (Bs (t - T) ltac:(lra) k Hk W).
  - intros t Ht. destruct (Rlt_dec t T) as [Lt|].
    + destruct (Early t ltac:(lra)) as (_ & -> & _). apply rderiv_join_before; auto.
    + destruct (Late t ltac:(lra)) as (_ & -> & _). apply rderiv_join_after; [|apply Dy]; lra.
  - intros t Ht. destruct (Rlt_dec t T) as [Lt|].
    + destruct (Early t ltac:(lra)) as (-> & -> & _).
      apply rderiv_near with (fun r => m1 * v1 r + b * s r - U r) (T - t); [lra| |auto].
      intros r Hr. destruct (Early r ltac:(lra)) as (_ & -> & _ & ->). auto.
    + destruct (Late t ltac:(lra)) as (-> & -> & _).
      apply rderiv_ext with (fun r => m1 * w1 (r - T) + b * z (r - T) - U (T + (r - T)) + b * (s T - z 0)).
      { intros r Hr. destruct (Late r ltac:(lra)) as (_ & -> & _ & ->). unfold g.
        replace (T + (r - T)) with r by ring. ring. }
      apply rderiv_eq with (- (a2 * y (t - T) + a1 * w1 (t - T)) + 0); [ring|]. apply rderiv_plus;
        [|apply rderiv_const]. apply (rderiv_later (fun q => m1 * w1 q + b * z q - U (T + q))), E1. lra.
  - intros t Ht. destruct (Early 0 HT) as (_ & _ & -> & ->). destruct (Rle_dec t T) as [Le|].
    + destruct (Early t Le) as (_ & _ & -> & ->). auto.
    + destruct (Late t ltac:(lra)) as (_ & _ & -> & ->). pose proof (B2 (t - T) ltac:(lra)).
      pose proof (A2 T ltac:(lra)) as Q. rewrite W0 in Q. unfold g. lra.
Qed.

(** A smooth arc that obeys the law of friction on [0, T) under the force u: g is a selection of the set-valued sign. *)
Record forced_arc (T : R) (u X V1 V2 g : R -> R) : Prop := {
  fa_x : forall t, is_derive X t (V1 t);
  fa_v1 : forall t, is_derive V1 t ((u t - a2 * X t - a1 * V1 t - b * g t) / m1);
  fa_v2 : forall t, is_derive V2 t (b * g t / m2);
  fa_law : forall t, 0 <= t < T -> -1 <= g t <= 1 /\ (V2 t < V1 t -> g t = 1) /\ (V1 t < V2 t -> g t = -1) }.

(** a slip is one, with the selection of one sign, as long as it goes on *)
Lemma slip_arc T u X V V2 k : k = 1 \/ k = -1 -> (forall t, is_derive X t (V t)) ->
  (forall t, is_derive V t ((u t - a2 * X t - a1 * V t - b * k) / m1)) -> (forall t, is_derive V2 t (b * k / m2)) ->
  (forall t, 0 <= t < T -> 0 <= k * (V t - V2 t)) -> forced_arc T u X V V2 (fun _ => k).
Proof.
  intros Hk DX DV D2 S. constructor; auto. intros t Ht. specialize (S t Ht). destruct Hk; subst k; split; lra.
Qed.

(** and a stick, as long as its load is at most b *)
Lemma stuck_arc T u X V : (forall t, is_derive X t (V t)) ->
  (forall t, is_derive V t ((u t - a2 * X t - a1 * V t) / (m1 + m2))) ->
  (forall t, 0 <= t < T -> - b <= m2 * (u t - a2 * X t - a1 * V t) / (m1 + m2) <= b) ->
  forced_arc T u X V V (fun t => m2 * (u t - a2 * X t - a1 * V t) / (m1 + m2) / b).
Proof.
  intros DX DV L. constructor; auto.
  - intros t. replace (_ / m1) with ((u t - a2 * X t - a1 * V t) / (m1 + m2)) by (field; lra). auto.
  - intros t. replace (_ / m2) with ((u t - a2 * X t - a1 * V t) / (m1 + m2)) by (field; lra). auto.
  - intros t Ht. specialize (L t Ht). split; [split; [undivide b|undivide b]; lra|split; intros; lra].
Qed.

(** [arc-begins] A smooth arc that satisfies the friction law under a force is the beginning of a motion under that
    force. *)
Theorem arc_begins U u X V1 V2 g T : 0 <= T -> cont U -> (forall t, 0 <= t < T -> rderiv U t (u t)) ->
  forced_arc T u X V1 V2 g -> exists x v1 v2 s, forced U x v1 v2 s /\
  forall t, 0 <= t <= T -> x t = X t /\ v1 t = V1 t /\ v2 t = V2 t.
Proof.
  intros HT CU DU [AX AV AW Law].
  destruct (forced_existence m1 m2 a1 a2 b (X T) (V1 T) (V2 T) (fun t => U (T + t)) Hm1 Hm2 Ha1 Ha2 Hb (cont_shift _ _
    HT CU)) as (y & w1 & w2 & z & H & Y0 & W10 & W20). apply forced_moves in H.
  set (S := fun t => m2 / b * V2 t). assert (DS : forall t, rderiv S t (g t)).
  { intros t. unfold S. rate. field; lra. }
  exists (join T X y), (join T V1 w1), (join T V2 w2), (join T S (fun t => S T + (z t - z 0))).
  split; [|intros t Ht; rewrite !join_before by (auto; lra); auto].
  apply forced_moves. split; [auto|]. apply joined; [auto| |apply H|auto|auto|auto]. constructor.
  - intros r t Hr Ht. apply (lip_between S g); [continuous|auto|]. intros q Hq. split; [apply DS|apply Law; lra].
  - intros t Ht k Hk W. destruct (Law t Ht) as (_ & P & N). replace k with (g t); [apply DS|].
    destruct Hk; subst k; [apply P|apply N]; lra.
  - continuous.
  - continuous.
  - intros t Ht. rates.
  - intros t Ht. rate. field; lra.
  - intros t Ht. unfold S. field; lra.
Qed.

(** [follow-forced-arc] A motion under a force that meets the start of such an arc, at any time, follows it. *)
Theorem follow_arc U u x v1 v2 s X V1 V2 g T t0 : 0 <= T -> 0 <= t0 -> (forall t, t0 <= t < t0 + T ->
  rderiv U t (u (t - t0))) ->
  forced_arc T u X V1 V2 g -> forced U x v1 v2 s -> x t0 = X 0 -> v1 t0 = V1 0 -> v2 t0 = V2 0 ->
  forall t, 0 <= t <= T -> x (t0 + t) = X t /\ v1 (t0 + t) = V1 t /\ v2 (t0 + t) = V2 t.
Proof.
  intros HT Ht0 DU A H E0 E1 E2 t Ht. pose proof (forced_shift _ _ _ _ _ t0 Ht0 H) as Sh.
  destruct (arc_begins (fun t => U (t0 + t)) u X V1 V2 g T HT) as (y & w1 & w2 & z & H' & Q); auto.
  { apply (f_cU _ _ _ _ _ _ _ _ _ _ Sh). }
  { intros r Hr. apply rderiv_earlier. replace (u r) with (u (t0 + r - t0)) by (f_equal; ring). apply DU; lra. }
  destruct (Q 0 ltac:(lra)) as (Q0 & Q1 & Q2). destruct (Q t Ht) as (<- & <- & <-).
  apply (forced_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ 0 Sh H'); try lra; cbv beta;
    rewrite Rplus_0_r; congruence.
Qed.

(** under a force that repeats with the opposite sign the mirror image of the later motion is one *)
Lemma forced_half_turn U x v1 v2 s T : 0 <= T -> (forall t, 0 <= t -> U (T + t) - U T = - (U t - U 0)) ->
  forced U x v1 v2 s -> forced U (fun t => - x (T + t)) (fun t => - v1 (T + t)) (fun t => - v2 (T + t))
    (fun t => - s (T + t)).
Proof.
  intros HT PU H. apply (forced_ext m1 m2 a1 a2 b (fun t => - U (T + t))).
  - intros t Ht. specialize (PU t Ht). rewrite Rplus_0_r. lra.
  - apply (forced_mirror (fun t => U (T + t)) (fun t => x (T + t)) (fun t => v1 (T + t)) (fun t => v2 (T + t))
      (fun t => s (T + t))), forced_shift; auto.
Qed.

(** [antiperiodic] Under a force that repeats with the opposite sign, a motion whose state does so once does so from
    then on. *)
Theorem antiperiodic U x v1 v2 s T : 0 <= T -> (forall t, 0 <= t -> U (T + t) - U T = - (U t - U 0)) ->
  forced U x v1 v2 s -> x T = - x 0 -> v1 T = - v1 0 -> v2 T = - v2 0 ->
  forall t, 0 <= t -> x (T + t) = - x t /\ v1 (T + t) = - v1 t /\ v2 (T + t) = - v2 t.
Proof.
  intros HT PU H E0 E1 E2 t Ht. pose proof (forced_half_turn U x v1 v2 s T HT PU H) as Ha.
  pose proof (forced_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ 0 Ha H) as Q. cbv beta in Q.
  rewrite Rplus_0_r in Q. specialize (Q (Rle_refl _) ltac:(lra) ltac:(lra) ltac:(lra) t Ht). lra.
Qed.
End Arcs.
