(** Contacts and stuck motions (a1 = 0 from the second section on): every solution meets S in bounded time; the
    ellipses on S up to E_cr are solutions; on S at such a level a solution moves along its ellipse for ever, and the
    energy distance to it never grows. *)
From InertialPair Require Import Dini Pair.

Section Contact.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** every trajectory meets S again, within a bounded time, or it would stay off S for longer than that *)
Lemma moves_contact c x v1 v2 s T : moves m1 m2 a1 a2 b c (fun _ => 0) x v1 v2 s -> 0 <= T ->
  exists t, T <= t <= T + 2 * sqrt (2 * energy m1 m2 a2 (x T) (v1 T) (v2 T) * m2) / b /\ v1 t = v2 t.
Proof.
  intros H HT. set (tau := 2 * sqrt (2 * energy m1 m2 a2 (x T) (v1 T) (v2 T) * m2) / b).
  set (w := fun t => v1 t - v2 t).
  assert (Dw : forall q, T <= q -> (forall u, T <= u < q -> 0 < w T * w u) -> q - T <= tau).
  { intros q Hq O. apply (free_dwell m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb c x v1 v2 s H); [lra|].
    destruct (Rlt_dec 0 (w T)); [left|right]; intros u Hu; specialize (O u Hu); unfold w in *; nra. }
  assert (Ht : 0 <= tau) by positive. destruct (Req_dec (w T) 0) as [Z|N]; [exists T; unfold w in Z; lra|].
  destruct (Classical_Prop.classic (exists q, T <= q <= T + tau + 1 /\ w T * w q <= 0)) as [(q & Hq & Nq)|No].
  - destruct (first_zero w T q) as (z & Hz & Z & O); auto; [|lra|].
    { apply cont_minus; [apply (q_cv _ _ _ _ _ _ _ _ _ _ _ H)|exact (moves_cv2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H)]. }
    exists z. specialize (Dw z ltac:(lra) O). unfold w in Z. lra.
  - specialize (Dw (T + tau + 1) ltac:(lra)). cut (T + tau + 1 - T <= tau); [lra|]. apply Dw. intros u Hu.
    apply Rnot_le_lt. intros Nu. apply No. exists u. lra.
Qed.
(** [contact] Every solution meets $S$ in every time window of length $2\sqrt{2Em_2}/b$, so infinitely often. *)
Theorem contact x v1 v2 s T : solution m1 m2 a1 a2 b x v1 v2 s -> 0 <= T ->
  exists t, T <= t <= T + 2 * sqrt (2 * energy m1 m2 a2 (x T) (v1 T) (v2 T) * m2) / b /\ v1 t = v2 t.
Proof. intros H. exact (moves_contact 1 x v1 v2 s T H). Qed.
End Contact.

Section Stick.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).

(** *** The stuck ellipse (a1 = 0) *)
Definition omega := sqrt (a2 / (m1 + m2)).
(** the half width of S0 *)
Definition L := b * (m1 + m2) / (a2 * m2).
(** the critical energy *)
Definition Ecr := b ^ 2 * (m1 + m2) ^ 2 / (2 * a2 * m2 ^ 2).
(** the stuck motion: its place *)
Definition X x0 v0 t := x0 * cos (omega * t) + v0 / omega * sin (omega * t).
(** and its speed *)
Definition V x0 v0 t := v0 * cos (omega * t) - x0 * omega * sin (omega * t).

Lemma omega_pos : 0 < omega.
Proof. apply sqrt_lt_R0, Rdiv_lt_0_compat; lra. Qed.
Lemma omega_sq : omega * omega = a2 / (m1 + m2).
Proof. apply sqrt_sqrt, Rlt_le, Rdiv_lt_0_compat; lra. Qed.
Lemma L_pos : 0 < L.
Proof. unfold L; apply Rdiv_lt_0_compat; nra. Qed.
(** E_cr is the spring's energy at the half width *)
Lemma Ecr_L : Ecr = a2 * L ^ 2 / 2.
Proof. unfold Ecr, L; field; lra. Qed.

Lemma derive_X x0 v0 t : is_derive (X x0 v0) t (V x0 v0 t).
Proof. pose proof omega_pos. unfold X, V. auto_derive; auto. field; lra. Qed.
Lemma derive_V x0 v0 t : is_derive (V x0 v0) t (- (omega * omega) * X x0 v0 t).
Proof. pose proof omega_pos. unfold X, V. auto_derive; auto. field; lra. Qed.

(** a stuck motion keeps its energy *)
Lemma ellipse_energy x0 v0 t : energy m1 m2 a2 (X x0 v0 t) (V x0 v0 t) (V x0 v0 t) = energy m1 m2 a2 x0 v0 v0.
Proof.
  pose proof omega_pos. pose proof omega_sq as Q. pose proof (sin2_cos2 (omega * t)) as SC. unfold Rsqr in SC.
  assert (M : a2 = (m1 + m2) * (omega * omega)) by (rewrite Q; field; lra).
  unfold energy, X, V. set (c := cos (omega * t)) in *. set (n := sin (omega * t)) in *. rewrite M.
  replace ((m1 + m2) * (omega * omega) * (x0 * c + v0 / omega * n) ^ 2 / 2 + m1 * (v0 * c - x0 * omega * n) ^ 2 /
    2 + m2 * (v0 * c - x0 * omega * n) ^ 2 / 2)
    with (((m1 + m2) * (omega * omega) * x0 ^ 2 / 2 + m1 * v0 ^ 2 / 2 + m2 * v0 ^ 2 / 2) * (n * n + c * c)) by
      (field; lra).
  rewrite SC; ring.
Qed.

(** up to E_cr it stays inside S0 *)
Lemma on_surface_inside x v : energy m1 m2 a2 x v v <= Ecr -> - L <= x <= L.
Proof.
  rewrite Ecr_L. unfold energy. intros H. pose proof L_pos. assert (x ^ 2 <= L ^ 2) by nra. split; nra.
Qed.

(** [ellipse-solution] Every ellipse on $S$ with energy up to $E_{cr}$ is a solution: the stuck pair. *)
Theorem ellipse_solution x0 v0 : energy m1 m2 a2 x0 v0 v0 <= Ecr ->
  solution m1 m2 0 a2 b (X x0 v0) (V x0 v0) (V x0 v0) (fun t => m2 / b * V x0 v0 t).
Proof.
  intros HE.
  assert (RS : forall t, rderiv (fun t => m2 / b * V x0 v0 t) t (m2 / b * (- (omega * omega) * X x0 v0 t))).
  { intros t. apply rderiv_scal, rderiv_of_derive, derive_V. }
  assert (CX : cont (X x0 v0)) by (eapply cont_of_derive; intros; apply derive_X).
  assert (CV : cont (V x0 v0)) by (eapply cont_of_derive; intros; apply derive_V).
  assert (Sl : forall t, -1 <= m2 / b * (- (omega * omega) * X x0 v0 t) <= 1).
  { intros t. rewrite omega_sq. assert (In := on_surface_inside (X x0 v0 t) (V x0 v0 t)). rewrite ellipse_energy in In.
    specialize (In HE). unfold L in In. set (k := m2 / b * (a2 / (m1 + m2))). assert (0 < k) by positive.
    assert (k * (b * (m1 + m2) / (a2 * m2)) = 1) by (unfold k; field; lra).
    replace (m2 / b * (- (a2 / (m1 + m2)) * X x0 v0 t)) with (- (k * X x0 v0 t)) by (unfold k; ring). nra. }
  constructor; auto.
  - intros r t Hr. rewrite <- (Rmult_1_l (t - r)).
    eapply (lip_between (fun t => m2 / b * V x0 v0 t)); [apply cont_scal, CV|auto|]. intros u _.
    split; [apply RS|apply Sl].
  - intros; lra.
  - intros; lra.
  - intros; apply rderiv_of_derive, derive_X.
  - intros t Ht. apply rderiv_ext with (fun u => (m1 + m2) * V x0 v0 u).
    { intros; field; lra. }
    apply rderiv_eq with ((m1 + m2) * (- (omega * omega) * X x0 v0 t)). { rewrite omega_sq; field; lra. }
    apply rderiv_scal, rderiv_of_derive, derive_V.
  - intros t Ht. field; lra.
Qed.

(** *** Capture: on S with E <= E_cr the pair moves along the ellipse for ever *)

(** [capture] A solution on $S$ with energy up to $E_{cr}$ moves along its ellipse permanently. *)
Theorem capture x v1 v2 s t0 : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 ->
  v1 t0 = v2 t0 -> energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) <= Ecr ->
  forall u, 0 <= u -> x (t0 + u) = X (x t0) (v1 t0) u /\ v1 (t0 + u) = V (x t0) (v1 t0) u /\
    v2 (t0 + u) = V (x t0) (v1 t0) u.
Proof.
  intros H Ht Ev HE u Hu. rewrite <- Ev in HE.
  pose proof (ellipse_solution _ _ HE) as HS. pose proof (solution_later m1 m2 0 a2 b x v1 v2 s t0 Ht H) as Sh.
  apply (unique m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb _ _ _ _ _ _ _ _ 0 Sh HS); try lra.
  all: unfold X, V; rewrite ?Rplus_0_r, Rmult_0_r, cos_0, sin_0, <- ?Ev; ring.
Qed.

(** [merging] Once its energy is at most $E_{cr}$, a solution merges with an ellipse within a bounded time. *)
Theorem merging x v1 v2 s T : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= T ->
  energy m1 m2 a2 (x T) (v1 T) (v2 T) <= Ecr ->
  exists t0, T <= t0 <= T + 2 * sqrt (2 * energy m1 m2 a2 (x T) (v1 T) (v2 T) * m2) / b /\
  energy m1 m2 a2 (x t0) (v1 t0) (v1 t0) <= Ecr /\
  forall u, 0 <= u -> x (t0 + u) = X (x t0) (v1 t0) u /\ v1 (t0 + u) = V (x t0) (v1 t0) u /\
    v2 (t0 + u) = V (x t0) (v1 t0) u.
Proof.
  intros H HT HE. destruct (contact m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb x v1 v2 s T H HT) as (t0 & Ht & Ev).
  assert (ED : energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) <= energy m1 m2 a2 (x T) (v1 T) (v2 T)).
  { apply (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H); lra. }
  exists t0; split; [auto|]. split; [rewrite <- Ev in ED; lra|]. apply (capture x v1 v2 s t0); auto; lra.
Qed.

(** [ellipse-stable] The energy distance of a solution to a stuck motion never grows. *)
Theorem ellipse_stable x0 v0 x v1 v2 s r t : energy m1 m2 a2 x0 v0 v0 <= Ecr ->
  solution m1 m2 0 a2 b x v1 v2 s -> 0 <= r <= t ->
  energy m1 m2 a2 (x t - X x0 v0 t) (v1 t - V x0 v0 t) (v2 t - V x0 v0 t) <=
  energy m1 m2 a2 (x r - X x0 v0 r) (v1 r - V x0 v0 r) (v2 r - V x0 v0 r).
Proof.
  intros HE H Hr.
  exact (contraction m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ H (ellipse_solution x0 v0 HE) r t Hr).
Qed.
End Stick.
