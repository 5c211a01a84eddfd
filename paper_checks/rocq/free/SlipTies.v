(** Ties: a slip, its exit and re-entry, the return map and the constant of the sharp law are what `theory/` derives. A test prints each expression of the
    theory and looks for it in the statement. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Stick Excursion ReturnMap TurningFunction Cycle ExitOrbit SlipFromGap SharpRate.

(** every square root of a parameter as a letter of its own *)
Ltac root y := let w := fresh "w" in let E := fresh "E" in let P := fresh "P" in
  assert (P : 0 < sqrt y) by (apply sqrt_lt_R0; lra); assert (E : sqrt y * sqrt y = y) by (apply sqrt_sqrt; lra);
  set (w := sqrt y) in *; clearbody w.
Ltac circle p := let SC := fresh "SC" in pose proof (sin2_cos2 p) as SC; unfold Rsqr in SC.

(** the slip, by its frequency *)
Ltac of_slip G := intros; unfold G, ray, L; match goal with t : R |- context [o1 ?m ?a] =>
  pose proof (o1_pos m a ltac:(lra) ltac:(lra)); assert (Q : a = m * (o1 m a * o1 m a)) by (apply o1_sq; lra);
  set (o := o1 m a) in *; clearbody o; subst a; rewrite ?(Rmult_comm t o) end; field; repeat split; lra.

(** [tie-slip-frequency] The frequency of slip. *)
Theorem tie_slip_frequency : forall m1 a2 : R, 0 < m1 -> 0 < a2 -> o1 m1 a2 = ((sqrt a2) * (/ (sqrt m1))).
Proof. intros; unfold o1; rewrite sqrt_div_alt by lra; field; apply Rgt_not_eq, sqrt_lt_R0; lra. Qed.

(** [tie-ray] The speed on an exit ray: $h$, in units of $L\Omega\sqrt q$. *)
Theorem tie_ray : forall m1 m2 a2 b u : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> ray m1 m2 a2 b u = (u * b * (/ (sqrt a2)) * (sqrt m1) * (/ m2)).
Proof. intros; unfold ray, o1; rewrite sqrt_div_alt by lra. root m1. root a2. field. lra. Qed.

(** [tie-slip-place] Slip from the ray: place (driven: of body 2). *)
Theorem tie_slip_place : forall m1 m2 a2 b d u t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> Gx m1 m2 a2 b 0 u t = ((b * (/ a2)) + ((ray m1 m2 a2 b u) * (/ (o1 m1 a2)) * (sin (t * (o1 m1 a2)))) + ((/ a2) * (((-1) * b) + ((L m1 m2 a2 b * (1 + m1 / (m1 + m2) * 0)) * a2)) * (cos (t * (o1 m1 a2))))).
Proof. of_slip Gx. Qed.

(** [tie-gap-place] Slip from $S$ at the gap $d$: place (driven: of body 2). *)
Theorem tie_gap_place : forall m1 m2 a2 b d u t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> Gx m1 m2 a2 b d u t = ((b * (/ a2)) + ((ray m1 m2 a2 b u) * (/ (o1 m1 a2)) * (sin (t * (o1 m1 a2)))) + ((/ a2) * (((-1) * b) + ((L m1 m2 a2 b * (1 + m1 / (m1 + m2) * d)) * a2)) * (cos (t * (o1 m1 a2))))).
Proof. of_slip Gx. Qed.

(** [tie-slip-speed] Slip from the ray: speed (driven: of body 2). *)
Theorem tie_slip_speed : forall m1 m2 a2 b d u t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> G1 m1 m2 a2 b 0 u t = (((ray m1 m2 a2 b u) * (cos (t * (o1 m1 a2)))) + ((-1) * (o1 m1 a2) * (/ a2) * (((-1) * b) + ((L m1 m2 a2 b * (1 + m1 / (m1 + m2) * 0)) * a2)) * (sin (t * (o1 m1 a2))))).
Proof. of_slip G1. Qed.

(** [tie-gap-speed] Slip from $S$ at the gap $d$: speed (driven: of body 2). *)
Theorem tie_gap_speed : forall m1 m2 a2 b d u t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> G1 m1 m2 a2 b d u t = (((ray m1 m2 a2 b u) * (cos (t * (o1 m1 a2)))) + ((-1) * (o1 m1 a2) * (/ a2) * (((-1) * b) + ((L m1 m2 a2 b * (1 + m1 / (m1 + m2) * d)) * a2)) * (sin (t * (o1 m1 a2))))).
Proof. of_slip G1. Qed.

(** [tie-slip-driven] Slip from the ray: driven (driven: of body 2). *)
Theorem tie_slip_driven : forall m1 m2 a2 b d u t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> G2 m1 m2 a2 b u t = ((ray m1 m2 a2 b u) + ((-1) * t * b * (/ m2))).
Proof. of_slip G2. Qed.

(** [tie-gap-driven] Slip from $S$ at the gap $d$: driven (driven: of body 2). *)
Theorem tie_gap_driven : forall m1 m2 a2 b d u t : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> G2 m1 m2 a2 b u t = ((ray m1 m2 a2 b u) + ((-1) * t * b * (/ m2))).
Proof. of_slip G2. Qed.

(** [tie-h] $h$: the push whose slip has the angle $\theta$. *)
Theorem tie_h : forall u : R, 1 - cos u <> 0 -> h u = ((/ ((-1) + (cos u))) * (((-1) * u) + (sin u))).
Proof. intros; unfold h; field; lra. Qed.

(** [tie-half-angle-h] The same in the half angle. *)
Theorem tie_half_angle_h : forall p : R, 0 < p < PI -> hh p = ((/ ((-1) + (cos (2 * p)))) * (((-2) * p) + (sin (2 * p)))).
Proof. intros; pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)); circle p; rewrite hh_h by auto; unfold h; rewrite cos_2a_sin; field; nra. Qed.

(** [tie-depth] The depth of an excursion. *)
Theorem tie_depth : forall p : R, 0 < p < PI -> depth p = (2 + ((-2) * p * (cos p / sin p))).
Proof. intros; pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)); unfold depth; field; lra. Qed.

(** [tie-push] The push whose slip from the gap $d$ has the half angle $\varphi$. *)
Theorem tie_push : forall d p : R, 0 < p < PI -> push d p = (((/ ((-1) + (cos (2 * p)))) * (((-2) * p) + (sin (2 * p)))) + ((-1) * d * (cos p / sin p))).
Proof. intros; pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)); unfold push, ct; rewrite tie_half_angle_h by auto; field; rewrite ?cos_2a_sin; split; nra. Qed.

(** [tie-return-map] The return map, in the half angle. *)
Theorem tie_return_map : forall m1 m2 p : R, 0 < m1 -> 0 < m2 -> 0 < p < PI -> next m1 m2 p = half (sqrt (((/ (((-1) + (cos (2 * p))) ^ 2)) * ((((-2) * p) + (sin (2 * p))) ^ 2)) + ((-1) * ((2 + ((-2) * p * (cos p / sin p))) ^ 2) * (1 + ((-1) * m1 * (/ (m1 + m2))))))).
Proof. intros; pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)); unfold next; rewrite tie_half_angle_h, tie_depth by auto; do 2 f_equal; field; rewrite ?cos_2a_sin; repeat split; nra. Qed.

(** [tie-level] The energy level at the end of a slip from the gap $d$. *)
Theorem tie_level : forall m1 m2 p d : R, 0 < m1 -> 0 < m2 -> 0 < p < PI -> level m1 m2 p d = (((((/ ((-1) + (cos (2 * p)))) * (((-2) * p) + (sin (2 * p)))) + ((-1) * d * (cos p / sin p))) ^ 2) + (2 * d) + (m1 * (d ^ 2) * (/ (m1 + m2))) + ((-1) * (1 + ((-1) * m1 * (/ (m1 + m2)))) * (2 + ((-2) * p * (cos p / sin p))) * (2 + (2 * d) + ((-2) * p * (cos p / sin p))))).
Proof. intros m1 m2 p d H1 H2 Hp. pose proof (half_depth p Hp) as Id. pose proof (tie_depth p Hp) as Ed.
  pose proof (tie_half_angle_h p Hp) as Eh. unfold level. unfold ct in *. rewrite <- Eh.
  set (k := cos p / sin p) in *. set (h := hh p) in *. set (c := depth p) in *.
  replace (-2 * p * k) with (c - 2) by lra. apply Rminus_diag_uniq.
  rewrite <- (Rmult_0_r (c + 2 * d)). replace 0 with (c * (1 + k ^ 2) - 2 * (1 - h * k)) at 1 by lra. unfold Rdiv. ring. Qed.

(** [tie-slip-time] The duration of an excursion. *)
Theorem tie_slip_time : forall m1 a2 p : R, 0 < m1 -> 0 < a2 -> 2 * p / o1 m1 a2 = (2 * p * (/ (sqrt a2)) * (sqrt m1)).
Proof. intros; unfold o1; rewrite sqrt_div_alt by lra. root m1. root a2. field. lra. Qed.

(** [tie-stick-rotation] The stick between two excursions, as the difference of two arc cosines. *)
Theorem tie_stick_rotation : forall z v e rho : R, 0 < rho -> v <= 0 -> 0 <= e -> z ^ 2 + v ^ 2 = rho ^ 2 -> 1 + e ^ 2 = rho ^ 2 ->
  cos (acos (- / rho) - acos (z / rho)) = ((/ ((v ^ 2) + (z ^ 2))) * (((-1) * z) + ((-1) * v * e))) /\
  sin (acos (- / rho) - acos (z / rho)) = ((/ ((v ^ 2) + (z ^ 2))) * (((-1) * v) + (z * e))).
Proof. intros z v e rho R V E Z O.
  assert (I : / rho * rho = 1) by (apply Rinv_l; lra). assert (P : 0 < / rho) by positive. assert (B1 : -1 <= - / rho <= 1) by nra. assert (B2 : -1 <= z / rho <= 1) by nra.
  rewrite cos_minus, sin_minus, !cos_acos, !sin_acos by auto.
  assert (S1 : sqrt (1 - (- / rho)²) = e / rho).
  { rewrite <- (sqrt_Rsqr (e / rho)) by (apply Rmult_le_pos; lra). f_equal. unfold Rsqr, Rdiv.
    replace (e * / rho * (e * / rho)) with ((rho ^ 2 - 1) * / rho * / rho) by (rewrite <- O; ring). field. lra. }
  assert (S2 : sqrt (1 - (z / rho)²) = - v / rho).
  { rewrite <- (sqrt_Rsqr (- v / rho)) by (apply Rmult_le_pos; lra). f_equal. unfold Rsqr, Rdiv.
    replace (- v * / rho * (- v * / rho)) with ((rho ^ 2 - z ^ 2) * / rho * / rho) by (rewrite <- Z; ring). field. lra. }
  rewrite S1, S2. split; (replace (v ^ 2 + z ^ 2) with (rho ^ 2) by (rewrite <- Z; ring)); field; lra. Qed.

(** [tie-rate] The constant of the sharp law, in units of the critical energy. *)
Theorem tie_rate : forall m1 m2 a2 b : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> rate m1 m2 a2 = ((4 / 9) * PI * m1 * (/ (sqrt a2)) * (/ m2) * (sqrt (m1 + m2))).
Proof. intros; unfold rate; rewrite sqrt_div_alt by lra. root a2. field. lra. Qed.

(** [tie-turning-function] The function whose zero is where $h/c$ turns. *)
Theorem tie_turning_function : forall p : R, K p = (p + ((-1) * (sqrt 2) * (sin p)) + ((-1) * (cos p) * (sin p)) + (p * (sqrt 2) * (cos p))).
Proof. intros; unfold K; ring. Qed.

(** [tie-ratio] $h/c$ in the half angle. *)
Theorem tie_ratio : forall p : R, 0 < p < PI -> ratio p = ((/ (2 + ((-2) * p * (/ (sin p)) * (cos p)))) * (/ ((sin p) ^ 2)) * (p + ((-1) * (cos p) * (sin p)))).
Proof. intros; pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). pose proof (g_pos p ltac:(lra)).
  rewrite ratio_AB by auto. field. repeat split; try lra; nra. Qed.

(** [tie-critical-mass-ratio] The critical mass ratio by the zero of the turning function. *)
Theorem tie_critical_mass_ratio : forall p : R, - cos (2 * p) = ((-1) + (2 * ((sin p) ^ 2))).
Proof. intros; rewrite cos_2a_sin; ring. Qed.
