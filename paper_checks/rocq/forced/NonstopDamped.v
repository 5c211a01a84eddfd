(** U** with damping that lets body 1 swing (a1^2 < 4 m1 a2): the response to the push that is turned round in closed
    form, and the motion that slips for ever, which then attracts every motion. *)
From InertialPair Require Import Waves Dini Pair Stick Pursuit Forced ForcedExistence Approach BoundedMotions Arcs
  Nonstop.
From InertialPair Require Import NonstopUndamped.

Section Damped.
Context (m1 m2 a1 a2 b om : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om).
Hypothesis Hosc : a1 ^ 2 < 4 * m1 * a2.

(** the frequency of body 1's free swing, which decays at the rate [fade m1 a1] *)
Definition ring_frequency := sqrt (a2 / m1 - fade m1 a1 ^ 2).
Let la := fade m1 a1.
Let od := ring_frequency.
Let T := PI / om.
(** the denominator of both: cosh (lambda T) + cos (omegad T), T half a period *)
Definition weight := cosh (fade m1 a1 * (PI / om)) + cos (ring_frequency * (PI / om)).
(** the place at the turn *)
Definition turn_place := - (sinh (fade m1 a1 * (PI / om)) - fade m1 a1 / ring_frequency *
  sin (ring_frequency * (PI / om))) / (a2 * weight).
(** the speed at the turn *)
Definition turn_speed := - sin (ring_frequency * (PI / om)) / (m1 * ring_frequency * weight).
Let h := turn_place.
Let h' := turn_speed.

(** both amplitudes of the swing that starts there *)
Let P := 1 - a2 * h.
Let Q := (la * P - a2 * h') / od.
(** the response to the push that is turned round: its place *)
Definition damped_swing t := / a2 * (1 - exp (- (la * t)) * (P * cos (od * t) + Q * sin (od * t))).
(** and its speed *)
Definition damped_swing' t := / a2 * exp (- (la * t)) * (a2 * h' * cos (od * t) + (la * Q + od * P) * sin (od * t)).

(** body 1 swings *)
Lemma od_pos : 0 < od.
Proof.
  unfold od, ring_frequency, fade. apply sqrt_lt_R0. replace (a2 / m1 - (a1 / (2 * m1)) ^ 2) with ((4 * m1 * a2 - a1 ^
    2) / (4 * m1 ^ 2)) by (field; lra).
  apply Rdiv_lt_0_compat; nra.
Qed.
(** its frequency without damping *)
Lemma od_sq : m1 * (od * od + la * la) = a2.
Proof.
  pose proof od_pos as O. unfold od, ring_frequency in *. destruct (Rle_dec (a2 / m1 - fade m1 a1 ^ 2) 0) as [N|N].
  - rewrite sqrt_neg_0 in O by auto. lra.
  - rewrite sqrt_sqrt by lra. unfold la. field; lra.
Qed.
Lemma la_m : 2 * m1 * la = a1.
Proof. unfold la, fade. field; lra. Qed.
Lemma la_pos : 0 < la.
Proof. apply Rdiv_lt_0_compat; lra. Qed.
Lemma T_pos : 0 < T.
Proof. apply Rdiv_lt_0_compat; [apply PI_RGT_0|auto]. Qed.
Lemma weight_pos : 0 < weight.
Proof.
  pose proof (Rmult_lt_0_compat _ _ la_pos T_pos). pose proof (COS_bound (od * T)). unfold weight, cosh.
  fold la od T. set (z := la * T) in *. pose proof (exp_pos (- z)). pose proof (exp_ineq1 z ltac:(lra)).
  assert (exp z * exp (- z) = 1) by (rewrite <- exp_plus, Rplus_opp_r, exp_0; auto).
  assert (0 < (exp z - 1) ^ 2) by positive. assert (1 < (exp z + exp (- z)) / 2) by nra. lra.
Qed.

Lemma derive_swing t : is_derive damped_swing t (damped_swing' t).
Proof. pose proof od_pos. unfold damped_swing, damped_swing'. auto_derive; auto. unfold Q. field; lra. Qed.
Lemma derive_swing' t : is_derive damped_swing' t ((1 - a1 * damped_swing' t - a2 * damped_swing t) / m1).
Proof.
  pose proof od_pos as O. unfold damped_swing, damped_swing'. auto_derive; auto. pose proof od_sq as E. rewrite <- la_m.
  rewrite <- E. unfold Q. rewrite <- E. assert (m1 * (od * od + la * la) <> 0) by (rewrite E; lra). field.
    repeat split; try lra. nra.
Qed.

Lemma swing_0 : damped_swing 0 = h.
Proof. unfold damped_swing. rewrite !Rmult_0_r, Ropp_0, exp_0, cos_0, sin_0. unfold P. field; lra. Qed.
Lemma swing'_0 : damped_swing' 0 = h'.
Proof. unfold damped_swing'. rewrite !Rmult_0_r, Ropp_0, exp_0, cos_0, sin_0. field; lra. Qed.

Lemma swing_T : damped_swing T = - h /\ damped_swing' T = - h'.
Proof.
  pose proof od_pos as O. pose proof weight_pos as W. pose proof od_sq as E.
  pose proof (exp_pos (- (la * T))). pose proof (sin2_cos2 (od * T)) as SC. unfold Rsqr in SC.
  assert (S2 : sin (od * T) ^ 2 = 1 - cos (od * T) ^ 2) by lra.
  unfold damped_swing, damped_swing', Q, P, h, h', turn_place, turn_speed, weight, cosh, sinh in W |- *.
  fold la od T in W |- *.
  replace (exp (la * T)) with (/ exp (- (la * T))) in W |- * by
    (rewrite exp_Ropp; field; apply Rgt_not_eq, exp_pos).
  set (e := exp (- (la * T))) in *. set (c := cos (od * T)) in *. set (n := sin (od * T)) in *.
  assert (N : 0 < 1 + 2 * e * c + e ^ 2).
  { replace (1 + 2 * e * c + e ^ 2) with (2 * e * ((/ e + e) / 2 + c)) by (field; lra). positive. }
  clearbody e c n. set (o := od) in *. set (l := la) in *. clearbody o l. rewrite <- E.
  split; (field [S2]; repeat split; try lra; nra).
Qed.

(** U** = b/(G om) sqrt ((pi/(2 m2 om) - h')^2 + ((M/m2 - a2 h - a1 h')/(m1 om))^2), 1/G = |a2 - m1 om^2 + i a1 om| *)
Definition Fslip_damped := b * sqrt ((a2 - m1 * om ^ 2) ^ 2 + (a1 * om) ^ 2) / om *
  sqrt ((PI / (2 * m2 * om) - turn_speed) ^ 2 + (((m1 + m2) / m2 - a2 * turn_place - a1 * turn_speed) / (m1 * om)) ^ 2).

(** the general threshold is this one *)
Lemma Fslip_swing : Fslip m1 m2 a1 a2 b om (damped_swing 0) (damped_swing' 0) = Fslip_damped.
Proof.
  rewrite swing_0, swing'_0. unfold Fslip, Fslip_damped. fold h h'. unfold turn, leave, Z1.
  set (A := PI / (2 * m2 * om) - h'). set (B := ((m1 + m2) / m2 - a2 * h - a1 * h') / (m1 * om)).
  replace ((b / om * (h' - PI / (2 * m2 * om))) ^ 2 + (b * ((m1 + m2) / m2 - a2 * h - a1 * h') / (m1 * om ^ 2)) ^ 2)
    with ((b / om) ^ 2 * (A ^ 2 + B ^ 2)) by (unfold A, B; field; lra).
  pose proof (pow2_ge_0 A). pose proof (pow2_ge_0 B). assert (0 < b / om) by positive.
  pose proof (pow2_ge_0 (a2 - m1 * om ^ 2)). pose proof (pow2_ge_0 (a1 * om)). pose proof (pow2_ge_0 (b / om)).
  rewrite sqrt_mult by (try apply Rmult_le_pos; lra). rewrite sqrt_mult by lra. rewrite sqrt_pow2 by lra. field; lra.
Qed.

(** [nonstop-damped] $a_1>0$, $a_1^2<4m_1a_2$: the theorem nonstop-iff with $U_{**}$ in closed form. *)
Theorem damped_iff F : 0 <= F -> (forall t, 0 < t < PI / om -> 0 < slipping m2 b om damped_swing'
    (leave m1 m2 a1 a2 b om turn_place turn_speed) t) ->
  (exists phi x v1 v2 s, nonstop m1 m2 a1 a2 b om F phi x v1 v2 s) <-> Fslip_damped <= F.
Proof.
  intros HF Side. rewrite <- Fslip_swing. destruct swing_T as (E & E').
  apply (nonstop_iff m1 m2 a1 a2 b om Hm1 Hm2 (Rlt_le _ _ Ha1) Ha2 Hb Hom damped_swing damped_swing' derive_swing
    derive_swing'); auto.
  - fold T. rewrite E, swing_0. auto.
  - fold T. rewrite E', swing'_0. auto.
  - unfold Z1. assert (0 < (a1 * om) ^ 2) by positive. pose proof (pow2_ge_0 (a2 - m1 * om ^ 2)). lra.
  - apply leaves; auto using derive_swing, derive_swing'; [lra|fold T..];
      rewrite ?E, ?E', ?swing_0, ?swing'_0; auto.
  - rewrite swing_0, swing'_0. auto.
Qed.
End Damped.

(** [nonstop-attracts] With $a_1>0$ a motion of nonstop-iff attracts every motion under its force. *)
Theorem nonstop_attracts m1 m2 a1 a2 b om F phi x v1 v2 s x' v1' v2' s' : 0 < m1 -> 0 < m2 -> 0 < a1 -> 0 < a2 ->
  0 < b ->
  0 < om -> 0 <= F -> nonstop m1 m2 a1 a2 b om F phi x v1 v2 s -> forced m1 m2 a1 a2 b (wave F om phi) x' v1' v2' s' ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x' t - x t) (v1' t - v1 t) (v2' t - v2 t) <= e.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb Hom HF (H & _) H'. apply (approach m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ F H'
    H HF).
  intros r t Hr. apply wave_lip; auto.
Qed.
