(** The pair in the plane under a rotating force, round friction: while U <= U* it moves on a circle, stuck; above, body
  2 slips at a constant speed given by a quadratic. So there is no regime of sticking and slipping in turn: U** = U*. *)
From InertialPair Require Import Dini EnergyLimit.

Section Rotating.
Context (m1 m2 a1 a2 b om : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om).

(** |D|^2 and |D_M|^2 of the dynamic stiffness of body 1 and of the stuck pair *)
Definition stiffness m := (a2 - m * om ^ 2) ^ 2 + (a1 * om) ^ 2.
(** the amplitude up to which it sticks *)
Definition Ustar_plane := b * sqrt (stiffness (m1 + m2)) / (m2 * om ^ 2).

(** a vector of length r that turns with the force *)
Definition along r ph t := r * cos (om * t + ph).
Definition across r ph t := r * sin (om * t + ph).

(** motions in the plane with friction of the constant length f: slip of speed rho along it, or none *)
Record circular U f rho (q q' v v' w w' g g' : R -> R) : Prop := {
  c_q : forall t, is_derive q t (v t) /\ is_derive q' t (v' t);
  c_v : forall t, is_derive v t ((U * cos (om * t) - a2 * q t - a1 * v t - g t) / m1) /\
                  is_derive v' t ((U * sin (om * t) - a2 * q' t - a1 * v' t - g' t) / m1);
  c_w : forall t, is_derive w t (g t / m2) /\ is_derive w' t (g' t / m2);
  c_f : forall t, g t ^ 2 + g' t ^ 2 = f ^ 2;
  c_s : forall t, f * (v t - w t) = rho * g t /\ f * (v' t - w' t) = rho * g' t }.

(** what ties the speed to the amplitude *)
Definition balance U f rho := (m2 * om ^ 2 * U) ^ 2 =
  f ^ 2 * stiffness (m1 + m2) + 2 * a1 * m2 ^ 2 * om ^ 4 * f * rho + m2 ^ 2 * om ^ 2 * stiffness m1 * rho ^ 2.

(** [rotating-motion] Under a rotating force there is a motion with a friction of constant size and the constant speed
    $\rho$ of slip that solves a quadratic. *)
Theorem circular_motion U f rho : 0 < U -> 0 < f -> 0 <= rho -> balance U f rho ->
  exists q q' v v' w w' g g', circular U f rho q q' v v' w w' g g'.
Proof.
  intros HU Hf Hr Ba. assert (O2 : 0 < om ^ 2) by nra.
  (* u in the frame of the friction: U e^(-i ph) = X + i Z *)
  set (X := f + (a2 - m1 * om ^ 2) * (- f / (m2 * om ^ 2)) + a1 * om * (rho / om)).
  set (Z := - (a2 - m1 * om ^ 2) * (rho / om) + a1 * om * (- f / (m2 * om ^ 2))). assert (Q : X ^ 2 + Z ^ 2 = U ^ 2).
  { unfold balance, stiffness in Ba. apply Rmult_eq_reg_l with ((m2 * om ^ 2) ^ 2); [|apply pow_nonzero; nra].
    replace ((m2 * om ^ 2) ^ 2 * U ^ 2) with ((m2 * om ^ 2 * U) ^ 2) by ring. rewrite Ba. unfold X, Z. field. lra. }
  destruct (polar X (- Z) U 1 0 HU Rlt_0_1) as (p & _ & Cp & Sp); [lra|]. rewrite Rmult_1_l in Cp, Sp.
  exists (fun t => rho / om * sin (om * t + p) - f / (m2 * om ^ 2) * cos (om * t + p)),
    (fun t => - (rho / om) * cos (om * t + p) - f / (m2 * om ^ 2) * sin (om * t + p)),
    (fun t => rho * cos (om * t + p) + f / (m2 * om) * sin (om * t + p)),
    (fun t => rho * sin (om * t + p) - f / (m2 * om) * cos (om * t + p)),
    (fun t => f / (m2 * om) * sin (om * t + p)), (fun t => - (f / (m2 * om)) * cos (om * t + p)),
    (along f p), (across f p). assert (UC : forall t, U * cos (om * t) = X * cos (om * t + p) - Z * sin (om * t + p) /\
    U * sin (om * t) = X * sin (om * t + p) + Z * cos (om * t + p)).
  { intros t. replace (om * t) with (om * t + p - p) at 1 4 by ring. rewrite cos_minus, sin_minus. nra. }
  unfold along, across. constructor; intros t; try destruct (UC t) as (-> & ->).
  - split; auto_derive; auto; field; lra.
  - split; auto_derive; auto; unfold X, Z; field; lra.
  - split; auto_derive; auto; field; lra.
  - pose proof (sin2_cos2 (om * t + p)) as SC. unfold Rsqr in SC. nra.
  - split; ring.
Qed.

Lemma stiffness_pos m : 0 <= stiffness m.
Proof. unfold stiffness. positive. Qed.

(** [rotating-threshold] Unless $a_1=0$ and body 1 alone is in resonance: the equation of rotating-motion has a stuck
    circle up to $U^*$, and exactly above it one positive speed of slip under the friction $b$. *)
Theorem one_threshold U : 0 < U -> 0 < stiffness m1 ->
  (U <= Ustar_plane -> exists f, 0 < f <= b /\ U * b = f * Ustar_plane /\ balance U f 0) /\
  ((exists rho, 0 < rho /\ balance U b rho) <-> Ustar_plane < U) /\
  forall r r', 0 <= r -> 0 <= r' -> balance U b r -> balance U b r' -> r = r'.
Proof.
  intros HU D1. assert (O2 : 0 < om ^ 2) by nra. assert (O4 : 0 < om ^ 4) by nra. set (q := sqrt (stiffness (m1 + m2))).
  assert (Qq : q * q = stiffness (m1 + m2)) by (apply sqrt_sqrt, stiffness_pos). set (u := m2 * om ^ 2 * U).
  assert (Us : b * q = m2 * om ^ 2 * Ustar_plane) by (unfold Ustar_plane; fold q; field; lra).
  set (B := 2 * a1 * m2 ^ 2 * om ^ 4 * b). set (A := m2 ^ 2 * om ^ 2 * stiffness m1).
  assert (M2 : 0 < m2 ^ 2) by positive. assert (HB : 0 <= B) by positive. assert (HA : 0 < A) by positive.
  assert (Up : 0 < u) by positive. assert (Qp : 0 <= b * q) by positive.
  assert (Ba : forall r, balance U b r <-> u ^ 2 = (b * q) ^ 2 + B * r + A * r ^ 2).
  { intros r. unfold balance, A, B, u. rewrite <- Qq. split; intros E; rewrite E; ring. }
  split; [|split].
  - intros Le. exists (b * U / Ustar_plane). split; [split; [positive|undivide Ustar_plane; scale]|].
    split; [field; lra|]. unfold balance. fold u. rewrite <- Qq. replace u with (b * U / Ustar_plane * q); [ring|].
    transitivity (b * q * U / Ustar_plane); [field; lra|]. rewrite Us. unfold u. field. lra.
  - assert (Lt : Ustar_plane < U <-> b * q < u).
    { rewrite Us. unfold u. split; [intros; scale|apply Rmult_lt_reg_l; positive]. }
    rewrite Lt. split.
    + intros (r & Hr & Er). apply Ba in Er. assert (0 < A * r ^ 2) by positive. assert (0 <= B * r) by positive. nra.
    + intros L. set (c := u ^ 2 - (b * q) ^ 2). set (w := sqrt (B ^ 2 + 4 * A * c)). assert (Cp : 0 < c) by (unfold c; nra).
      assert (Ac : 0 < A * c) by positive.
      assert (Ew : w * w = B ^ 2 + 4 * A * c) by (apply sqrt_sqrt; pose proof (pow2_ge_0 B); lra).
      assert (Wp : 0 <= w) by positive. assert (Wb : B < w) by nra. exists ((w - B) / (2 * A)). split; [positive|].
      apply Ba. apply Rminus_diag_uniq_sym. apply Rmult_eq_reg_l with (4 * A); [|lra].
      replace (4 * A * ((b * q) ^ 2 + B * ((w - B) / (2 * A)) + A * ((w - B) / (2 * A)) ^ 2 - u ^ 2))
        with (w * w - B ^ 2 - 4 * A * c) by (unfold c; field; lra). lra.
  - intros r r' Hr Hr' E E'. apply Ba in E. apply Ba in E'. apply Rminus_diag_uniq.
    assert (Z : (r - r') * (B + A * (r + r')) = 0) by lra. apply Rmult_integral in Z. nra.
Qed.

(** *** A friction of the speed (S5): the characteristic function at 0 has the sign of dU/drho *)
Definition g_s := a1 * om ^ 2 / stiffness m1.
Definition g_a := om * (a2 - m1 * om ^ 2) / stiffness m1 - 1 / (m2 * om).
(** X(0), where friction is f and grows at the rate f' *)
Definition X0 f f' rho := (1 + f' * g_s) * (1 + f / rho * g_s) + f' * (f / rho) * g_a ^ 2.
(** the force that turns with slip rho, squared *)
Definition force2 f rho := (f ^ 2 * stiffness (m1 + m2) + 2 * a1 * m2 ^ 2 * om ^ 4 * f * rho
  + m2 ^ 2 * om ^ 2 * stiffness m1 * rho ^ 2) / (m2 * om ^ 2) ^ 2.

(** [rotating-characteristic] With friction that depends on the speed, the characteristic function at 0 is
    $X(0)=\frac{\omega^2}{2\rho|D|^2}\frac{d(U^2)}{d\rho}$. *)
Theorem characteristic_at_zero f f' rho : 0 < stiffness m1 -> 0 < rho -> is_derive f rho f' ->
  is_derive (fun r => force2 (f r) r) rho (2 * rho * stiffness m1 / om ^ 2 * X0 (f rho) f' rho).
Proof.
  intros HD Hr Hf. assert (Ex : ex_derive f rho) by (exists f'; auto). unfold force2. auto_derive; [repeat split;
    auto|]. replace (Derive (fun x => f x) rho) with f' by (symmetry; apply is_derive_unique; auto).
  unfold X0, g_s, g_a. unfold stiffness in *. field. repeat split; lra.
Qed.
End Rotating.
