(** Ties: the law, the energy, the half width of S0, the critical energy and the closed form of stick are what `theory/` derives. A test prints each expression of the
    theory and looks for it in the statement. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Pair Stick Viscous.

(** [tie-solution] A solution obeys the equations of motion of the theory, with an impulse that follows the sign of
    its guard. *)
Theorem tie_solution : forall m1 m2 a1 a2 b (x v1 v2 s : R -> R), solution m1 m2 a1 a2 b x v1 v2 s <->
  ((forall r t, 0 <= r <= t -> Rabs (s t - s r) <= t - r) /\
   (forall t, 0 <= t -> 0 < ((v1 t) + ((-1) * (v2 t))) -> rderiv s t 1) /\ (forall t, 0 <= t -> ((v1 t) + ((-1) * (v2 t))) < 0 -> rderiv s t (-1)) /\
   cont x /\ cont v1 /\
   (forall t, 0 <= t -> rderiv (fun t => x t - 0 * s t) t (v1 t)) /\
   (forall t, 0 <= t -> rderiv (fun t => m1 * v1 t - ((-1) * b) * s t) t (((-1) * (v1 t) * a1) + ((-1) * (x t) * a2))) /\
   (forall t, 0 <= t -> m2 * v2 t - b * s t = m2 * v2 0 - b * s 0 + 0 * t)).
Proof. assert (Re : forall f g t l k, (forall r, f r = g r) -> l = k -> rderiv f t l -> rderiv g t k).
  { intros f g t l k E -> D. apply rderiv_ext with f; auto. }
  intros; split.
  - intros [L P N CX CV X V W]. repeat split; auto; intros t Ht; try (intros; apply P; lra); try (intros; apply N; lra).
    + apply (Re x _ t (v1 t)); auto. intros; ring.
    + eapply Re; [| |exact (V t Ht)]; [intros; cbv beta|]; ring.
    + pose proof (W t Ht). lra.
  - intros (L & P & N & CX & CV & X & V & W). constructor; auto; intros t Ht; try (intros; apply P; lra);
      try (intros; apply N; lra).
    + apply (Re _ x t (v1 t)) with (3 := X t Ht); auto. intros; ring.
    + eapply Re; [| |exact (V t Ht)]; [intros; cbv beta|]; ring.
    + pose proof (W t Ht). lra. Qed.

(** [tie-energy] The energy. *)
Theorem tie_energy : forall m1 m2 a2 x v1 v2 : R, energy m1 m2 a2 x v1 v2 = (((1 / 2) * a2 * (x ^ 2)) + ((1 / 2) * m1 * (v1 ^ 2)) + ((1 / 2) * m2 * (v2 ^ 2))).
Proof. intros; unfold energy; field; lra. Qed.

(** [tie-dwell-time] The longest stay off $S$. *)
Theorem tie_dwell_time : forall m2 b e : R, 0 < m2 -> 0 < b -> 0 <= e -> 2 * sqrt (2 * e * m2) / b = (2 * (sqrt 2) * (sqrt e) * (/ b) * (sqrt m2)).
Proof. intros; rewrite !sqrt_mult by nra; field; lra. Qed.

(** [tie-half-width] The half width $L$ of the sliding region. *)
Theorem tie_half_width : forall m1 m2 a2 b : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> L m1 m2 a2 b = (b * (/ a2) * (/ m2) * (m1 + m2)).
Proof. intros; unfold L; field; lra. Qed.

(** [tie-critical-energy] The critical energy. *)
Theorem tie_critical_energy : forall m1 m2 a2 b : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> Ecr m1 m2 a2 b = ((1 / 2) * (/ a2) * (b ^ 2) * (/ (m2 ^ 2)) * ((m1 + m2) ^ 2)).
Proof. intros; unfold Ecr; field; lra. Qed.

(** [tie-captive] With damping: the level whose ellipse lies in the sliding region. *)
Theorem tie_captive : forall m1 m2 a1 a2 b e : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 <= a1 -> (captive m1 m2 a1 a2 b e <-> e <= ((1 / 2) * (b ^ 2) * (/ (m2 ^ 2)) * ((m1 + m2) ^ 3) * (/ ((a1 ^ 2) + (a2 * m1) + (a2 * m2))))).
Proof. intros. unfold captive.
  assert (W : 0 < a2 + a1 ^ 2 / (m1 + m2)) by (assert (0 <= a1 ^ 2 / (m1 + m2)) by positive; lra).
  match goal with |- _ <-> e <= ?t => assert (E : t = (b * (m1 + m2) / m2) ^ 2 / (2 * (a2 + a1 ^ 2 / (m1 + m2)))) end.
  { field. repeat split; try lra. pose proof (pow2_ge_0 a1). nra. }
  rewrite E, <- Rle_div_r by lra. replace (e * (2 * (a2 + a1 ^ 2 / (m1 + m2)))) with
    (2 * e * (a2 + a1 ^ 2 / (m1 + m2))) by ring. reflexivity. Qed.

(** [tie-stick-frequency] The frequency of stick. *)
Theorem tie_stick_frequency : forall m1 m2 a2 : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> omega m1 m2 a2 = ((sqrt a2) * (/ (sqrt (m1 + m2)))).
Proof. intros; unfold omega; rewrite sqrt_div_alt by lra; field; apply Rgt_not_eq, sqrt_lt_R0; lra. Qed.

(** [tie-stick-place] Stick: the place of both bodies. *)
Theorem tie_stick_place : forall m1 m2 a2 x0 v0 t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> X m1 m2 a2 x0 v0 t = ((x0 * (cos (t * (omega m1 m2 a2)))) + (v0 * (/ (omega m1 m2 a2)) * (sin (t * (omega m1 m2 a2))))).
Proof. intros; pose proof (omega_pos m1 m2 a2 ltac:(lra) ltac:(lra) ltac:(lra)); unfold X, V; rewrite ?(Rmult_comm t); field; lra. Qed.

(** [tie-stick-speed] Stick: the speed of both bodies. *)
Theorem tie_stick_speed : forall m1 m2 a2 x0 v0 t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> V m1 m2 a2 x0 v0 t = ((v0 * (cos (t * (omega m1 m2 a2)))) + ((-1) * x0 * (omega m1 m2 a2) * (sin (t * (omega m1 m2 a2))))).
Proof. intros; pose proof (omega_pos m1 m2 a2 ltac:(lra) ltac:(lra) ltac:(lra)); unfold X, V; rewrite ?(Rmult_comm t); field; lra. Qed.
