(** One cycle: slip from an exit ray, landing inside the strip, stick along an ellipse to the opposite ray. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Pair Stick Excursion FollowArc.

Section Cycle.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (M := m1 + m2) (q := m1 / M) (r := m2 / M) (om := omega m1 m2 a2) (L := L m1 m2 a2 b)
  (Ecr := Ecr m1 m2 a2 b).

(** o1: frequency of the slip; ray u: speed on the exit ray in the reduced unit, so that E = E_cr (1 + q u^2) there *)
Definition o1 := sqrt (a2 / m1).
(** the speed on an exit ray for the push u *)
Definition ray u := b / (m2 * o1) * u.
(** the state on the exit ray of the side k = 1 or -1 *)
Definition on_ray k u (x v1 v2 : R -> R) t := k * x t = L /\ k * v1 t = ray u /\ k * v2 t = ray u.

Lemma o1_pos : 0 < o1. Proof. apply sqrt_lt_R0, Rdiv_lt_0_compat; lra. Qed.
Lemma o1_sq : a2 = m1 * (o1 * o1). Proof. unfold o1. rewrite sqrt_sqrt; [field; lra|].
  apply Rlt_le, Rdiv_lt_0_compat; lra. Qed.
Lemma q_pos : 0 < q. Proof. positive. Qed.
Lemma r_pos : 0 < r. Proof. positive. Qed.
Lemma qr_one : q + r = 1. Proof. unfold q, r, M; field; lra. Qed.
Lemma ray_pos u : 0 < u -> 0 < ray u.
Proof. intros. pose proof o1_pos. unfold ray. positive. Qed.
Lemma Mom : a2 = M * (om * om).
Proof. unfold om, M. rewrite (omega_sq m1 m2 a2) by auto. field; lra. Qed.
Lemma L_o1 : L = b * M / (m1 * (o1 * o1) * m2).
Proof. unfold L. rewrite o1_sq at 1. auto. Qed.

(** the level of the speed ray u on the surface at x = +-L *)
Lemma ray_level u : energy m1 m2 a2 L (ray u) (ray u) = Ecr * (1 + q * u ^ 2).
Proof.
  unfold Ecr. rewrite Ecr_L by auto. fold L. pose proof o1_pos. unfold energy, ray. rewrite L_o1. rewrite o1_sq.
    unfold q, M. field. repeat split; lra.
Qed.

(** *** Stick: the arc of an ellipse above E_cr inside the strip *)
Definition Cx al rho t := L * rho * cos (al + om * t).
(** its speed *)
Definition Cv al rho t := - (L * rho * om * sin (al + om * t)).
(** on it the load stays within b from an angle al in the strip to the edge *)
Lemma arc_inside al rho t : 1 <= rho -> 0 <= al -> rho * cos al <= 1 -> 0 <= t <= (acos (- / rho) - al) / om ->
  -1 <= rho * cos (al + om * t) <= 1.
Proof.
  intros Hr Ha Hc Ht. pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O. fold om in O.
  assert (Th : t * om <= acos (- / rho) - al) by (apply Rle_div_r; lra). assert (0 <= om * t) by positive.
  assert (Ir : - 1 <= - / rho <= 1) by (assert (0 < / rho <= / 1) by (split; [positive|apply Rinv_le_contravar; lra]);
    lra). pose proof (acos_bound (- / rho)). assert (cos (al + om * t) <= cos al) by (apply cos_decr_1; lra).
  assert (C : cos (acos (- / rho)) <= cos (al + om * t)) by (apply cos_decr_1; lra). rewrite cos_acos in C by lra.
  assert (rho * - / rho = -1) by (field; lra). nra.
Qed.
(** the arc obeys the law until then *)
Lemma stick_arc al rho : 1 <= rho -> 0 <= al -> rho * cos al <= 1 ->
  arc m1 m2 a2 b ((acos (- / rho) - al) / om) (Cx al rho) (Cv al rho) (Cv al rho)
    (fun t => m2 / b * (- (om * om) * Cx al rho t)).
Proof.
  intros Hr Ha Hc. pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O. fold om in O. pose proof Mom as Mo.
  constructor; [| | |intros t Ht; split; [|lra]].
  - intros t. unfold Cx, Cv. auto_derive; auto. ring.
  - intros t. unfold Cx, Cv. auto_derive; auto. rewrite Mo. unfold M. field. lra.
  - intros t. unfold Cx, Cv. auto_derive; auto. field. lra.
  - pose proof (arc_inside al rho t Hr Ha Hc ltac:(lra)).
    replace (m2 / b * (- (om * om) * Cx al rho t)) with (- (rho * cos (al + om * t))); [lra|]. unfold Cx, L, Stick.L.
    rewrite Mo at 1. unfold M. field. repeat split; lra.
Qed.
(** its level *)
Lemma arc_level al rho t : energy m1 m2 a2 (Cx al rho t) (Cv al rho t) (Cv al rho t) = Ecr * (rho * rho).
Proof.
  unfold Ecr. rewrite Ecr_L by auto. fold L. unfold energy, Cx, Cv. rewrite Mom. unfold M.
  transitivity ((m1 + m2) * (om * om) * L ^ 2 / 2 * (rho * rho) * (sin (al + om * t) ^ 2 + cos (al + om * t) ^ 2));
    [field|]. rewrite <- !Rsqr_pow2, sin2_cos2. field.
Qed.
(** on S the level and the place give the speed to the left *)
Lemma same_speed y v w : energy m1 m2 a2 y v v = energy m1 m2 a2 y w w -> v <= 0 -> w <= 0 -> v = w.
Proof.
  unfold energy. intros E Hv Hw. assert (Z : (m1 + m2) * ((v - w) * (v + w)) = 0) by lra. apply Rmult_integral in Z.
  destruct Z as [|Z]; [lra|]. apply Rmult_integral in Z. lra.
Qed.

(** rho: amplitude over L at the level y = w/q *)
Definition amp y := sqrt (1 + q * y).
Lemma amp_sq y : 0 <= y -> amp y * amp y = 1 + q * y.
Proof. intros. apply sqrt_sqrt. positive. Qed.
Lemma amp_ge y : 0 <= y -> 1 <= amp y.
Proof. intros. pose proof q_pos. rewrite <- sqrt_1 at 1. apply sqrt_le_1_alt. nra. Qed.

(** the data of the stick from (L z, v), v < 0, at the level y = u^2: it starts there and ends on the ray x = -L with
    speed ray u *)
Lemma stick_ends z v u : 0 < u -> -1 <= z <= 1 -> v < 0 -> energy m1 m2 a2 (L * z) v v = Ecr * (1 + q * u ^ 2) ->
  let rho := amp (u ^ 2) in let al := acos (z / rho) in let T := (acos (- / rho) - al) / om in
  1 < rho /\ 0 <= al /\ rho * cos al = z /\ 0 <= T < PI / om /\
  Cx al rho 0 = L * z /\ Cv al rho 0 = v /\ Cx al rho T = - L /\ Cv al rho T = - ray u.
Proof.
  intros Hu Hz Hv En rho al T. pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O. fold om in O. pose proof q_pos as Q0.
  pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0. fold L in L0. assert (U2 : 0 < q * u ^ 2) by positive.
  assert (R1 : 1 <= rho) by (apply amp_ge; positive).
  assert (R2 : rho * rho = 1 + q * u ^ 2) by (apply amp_sq; positive). assert (R3 : 1 < rho) by nra.
  assert (Ir : 0 < / rho < 1) by (split; [positive|rewrite <- Rinv_1; apply Rinv_lt_contravar; lra]).
  assert (Zr : - / rho <= z / rho <= / rho) by nra. pose proof (acos_bound (z / rho)) as Ab. fold al in Ab.
  pose proof (acos_bound (- / rho)) as Ag. assert (Ca : cos al = z / rho) by (apply cos_acos; lra).
  assert (Cg : cos (acos (- / rho)) = - / rho) by (apply cos_acos; lra).
  assert (Ord : al <= acos (- / rho)) by (apply cos_decr_0; lra).
  assert (Al0 : 0 < al) by (destruct (Req_dec al 0) as [E|]; [rewrite E, cos_0 in Ca|]; lra).
  assert (Rc : rho * cos al = z) by (rewrite Ca; field; lra).
  assert (Ang : al + om * T = acos (- / rho)) by (unfold T; field; lra).
  assert (Neg : forall t, 0 <= al + om * t <= PI -> Cv al rho t <= 0).
  { intros t Ht. unfold Cv. pose proof (sin_ge_0 (al + om * t) ltac:(lra) ltac:(lra)).
    assert (0 <= L * rho * om * sin (al + om * t)) by positive. lra. }
  assert (X0 : Cx al rho 0 = L * z) by (unfold Cx; rewrite Rmult_0_r, Rplus_0_r, Rmult_assoc, Rc; auto).
  assert (XT : Cx al rho T = - L) by (unfold Cx; rewrite Ang, Cg; field; lra). do 3 (split; [lra|]).
  split; [split; [positive|apply Rmult_lt_compat_r; [positive|lra]]|]. split; [auto|split; [|split; [auto|]]].
  - pose proof (arc_level al rho 0) as E. rewrite X0, R2, <- En in E. apply same_speed with (1 := E); [apply Neg|]; lra.
  - pose proof (arc_level al rho T) as E. rewrite XT, R2, <- ray_level in E. pose proof (ray_pos u Hu).
    apply (same_speed L); [rewrite <- (Ropp_involutive L)|apply Neg|]; try lra. unfold energy in *. lra.
Qed.

(** [stick-arc] On $S_0$ above $E_{cr}$ and moving to the left every solution sticks until it reaches the left exit
    ray, at a time in closed form. *)
Theorem stick x v1 v2 s t0 z u : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> 0 < u ->
  x t0 = L * z -> -1 <= z <= 1 -> v1 t0 < 0 -> v2 t0 = v1 t0 ->
  energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) = Ecr * (1 + q * u ^ 2) ->
  let T := (acos (- / amp (u ^ 2)) - acos (z / amp (u ^ 2))) / om in
  0 <= T < PI / om /\ on_ray (-1) u x v1 v2 (t0 + T) /\
  (forall t, 0 <= t <= T -> v1 (t0 + t) = v2 (t0 + t) /\ - L <= x (t0 + t) <= L).
Proof.
  intros H Ht Hu Ex Hz Hv Ev En T. rewrite Ex, Ev in En.
  destruct (stick_ends z (v1 t0) u Hu Hz Hv En) as (R3 & Al & Rc & HT & X0 & V0 & XT & VT). fold T in HT, XT, VT.
  pose proof (stick_arc _ _ (Rlt_le _ _ R3) Al) as A. rewrite Rc in A. specialize (A (proj2 Hz)).
  pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0. fold L in L0. assert (F := follow m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1
    v2 s _ _ _ _ _ t0 H A Ht ltac:(congruence) ltac:(congruence) ltac:(congruence)). fold T in F. split; [auto|]. split.
  - destruct (F T ltac:(lra)) as (G0 & G1 & G2). unfold on_ray. lra.
  - intros t Hu'. destruct (F t Hu') as (G0 & G1 & G2). rewrite G0. unfold Cx.
    pose proof (arc_inside _ _ t (Rlt_le _ _ R3) Al ltac:(lra) Hu'). split; nra.
Qed.
End Cycle.
