(** U** with damping that lets body 1 swing (a1^2 < 4 m1 a2): the response to the push that is turned round in closed
    form, and the motion that slips for ever, which then attracts every motion. *)
From InertialPair Require Import Waves Dini Pair Stick Pursuit Forced ForcedExistence Approach BoundedMotions Arcs
  Nonstop.
From InertialPair Require Import NonstopUndamped.

(** z <= sinh z and 1 < cosh z for z > 0 *)
Lemma sinh_above z : 0 < z -> z < sinh z.
Proof.
  intros Hz. assert (E : forall y, 0 < y -> 1 < cosh y).
  { intros y Hy. pose proof cosh_0 as C0. rewrite <- C0. apply (grows cosh sinh); auto.
    - intros t _. apply is_derive_Reals, derivable_pt_lim_cosh.
    - intros t Ht. rewrite <- sinh_0. apply sinh_lt; lra. }
  cut (0 < sinh z - z); [lra|]. replace 0 with (sinh 0 - 0) by (rewrite sinh_0; ring).
  apply (grows (fun t => sinh t - t) (fun t => cosh t - 1)); auto.
  - intros t _. unfold sinh, cosh. auto_derive; auto. field.
  - intros t Ht. specialize (E t ltac:(lra)). lra.
Qed.

(** the size of a sine *)
Lemma sine_below z : 0 < z -> - z < sin z < z.
Proof.
  intros Hz. pose proof (SIN_bound z). pose proof PI2_1. split; [|apply sin_lt_x; auto].
  destruct (Rle_dec z 1); [|lra]. assert (0 < sin z); [apply sin_gt_0; lra|lra].
Qed.

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
  unfold weight. pose proof la_pos. pose proof T_pos. assert (0 < la * T) by nra. pose proof (sinh_above _ H1) as S.
  pose proof (COS_bound (od * T)). unfold la, T, od in *.
  set (z := fade m1 a1 * (PI / om)) in *. pose proof (exp_pos (- z)). unfold sinh, cosh in *.
    pose proof (exp_ineq1 z ltac:(lra)).
  assert (exp z * exp (- z) = 1) by (rewrite <- exp_plus, Rplus_opp_r, exp_0; auto).
  assert (1 < (exp z + exp (- z)) / 2); [|lra]. assert (0 < (exp z - 1) ^ 2) by positive. nra.
Qed.

Lemma derive_swing t : is_derive damped_swing t (damped_swing' t).
Proof. pose proof od_pos. unfold damped_swing, damped_swing'. auto_derive; auto. unfold Q. field; lra. Qed.
Lemma derive_swing' t : is_derive damped_swing' t ((1 - a1 * damped_swing' t - a2 * damped_swing t) / m1).
Proof.
  pose proof od_pos as O. unfold damped_swing, damped_swing'. auto_derive; auto. pose proof od_sq as E. rewrite <- la_m.
  rewrite <- E. unfold Q. rewrite <- E. assert (m1 * (od * od + la * la) <> 0) by (rewrite E; lra). field.
    repeat split; try lra. nra.
Qed.

(** the exponential by hyperbolic functions *)
Lemma exp_half : exp (- (la * T)) = cosh (la * T) - sinh (la * T).
Proof. unfold cosh, sinh. field. Qed.
(** the unit hyperbola *)
Lemma cosh_sinh z : cosh z * cosh z - sinh z * sinh z = 1.
Proof.
  unfold cosh, sinh. transitivity (exp z * exp (- z)); [field|]. rewrite <- exp_plus, Rplus_opp_r, exp_0. auto.
Qed.

Lemma swing_0 : damped_swing 0 = h.
Proof. unfold damped_swing. rewrite !Rmult_0_r, Ropp_0, exp_0, cos_0, sin_0. unfold P. field; lra. Qed.
Lemma swing'_0 : damped_swing' 0 = h'.
Proof. unfold damped_swing'. rewrite !Rmult_0_r, Ropp_0, exp_0, cos_0, sin_0. field; lra. Qed.

Lemma swing_T : damped_swing T = - h /\ damped_swing' T = - h'.
Proof.
  pose proof od_pos as O. pose proof weight_pos as W. pose proof od_sq as E.
  assert (W1 : weight = cosh (la * T) + cos (od * T)) by reflexivity.
  assert (E1 : a2 * h = - (sinh (la * T) - la / od * sin (od * T)) / weight) by (unfold h, turn_place; fold la od T;
    field; lra).
  assert (E2 : a2 * h' = - (od * od + la * la) / od * sin (od * T) / weight) by (rewrite <- E; unfold h', turn_speed;
    fold la od T; field; lra).
  pose proof (cosh_sinh (la * T)) as CH. pose proof (sin2_cos2 (od * T)) as SC. unfold Rsqr in SC.
  assert (K : (cosh (la * T) - sinh (la * T)) * (P * cos (od * T) + Q * sin (od * T)) = 1 + a2 * h).
  { unfold Q, P. rewrite E1, E2. set (c := cos (od * T)) in *. set (n := sin (od * T)) in *.
    set (ch := cosh (la * T)) in *. set (sh := sinh (la * T)) in *. apply Rmult_eq_reg_r with weight; [|lra].
    transitivity ((ch - sh) * ((ch + sh) * (c + la / od * n) + (n * n + c * c))).
    - rewrite W1. field. rewrite <- W1. lra.
    - rewrite SC. transitivity ((ch * ch - sh * sh) * (c + la / od * n) + ch - sh); [ring|]. rewrite CH.
      rewrite W1. field. rewrite <- W1. lra. }
  assert (K' : (cosh (la * T) - sinh (la * T)) * (a2 * h' * cos (od * T) + (la * Q + od * P) * sin (od * T)) = - (a2 *
    h')).
  { unfold Q, P. rewrite E1, E2. set (c := cos (od * T)) in *. set (n := sin (od * T)) in *.
    set (ch := cosh (la * T)) in *. set (sh := sinh (la * T)) in *. apply Rmult_eq_reg_r with weight; [|lra].
    transitivity ((od * od + la * la) / od * n * ((ch - sh) * (ch + sh))).
    - rewrite W1. field. rewrite <- W1. lra.
    - replace ((ch - sh) * (ch + sh)) with (ch * ch - sh * sh) by ring. rewrite CH. field. lra. }
  unfold damped_swing, damped_swing'. rewrite exp_half. split.
  - rewrite K. field; lra.
  - rewrite Rmult_assoc, K'. field; lra.
Qed.

(** at the turn the swing asks nothing of the friction: a2 h + a1 h' <= 0 *)
Lemma turn_load : a2 * h + a1 * h' <= 0.
Proof.
  pose proof od_pos as O. pose proof weight_pos as W. pose proof la_pos as L. pose proof T_pos as HT.
  replace (a2 * h + a1 * h') with (- ((sinh (la * T) + la / od * sin (od * T)) / weight))
    by (rewrite <- la_m; unfold h, h', turn_place, turn_speed; fold la od T; field; lra).
  assert (0 <= (sinh (la * T) + la / od * sin (od * T)) / weight); [|lra]. apply Rmult_le_pos; [|positive].
  pose proof (sinh_above (la * T) ltac:(nra)) as S. pose proof (sine_below (od * T) ltac:(nra)) as (B & _).
  assert (la / od * - (od * T) < la / od * sin (od * T)) by scale.
  replace (la / od * - (od * T)) with (- (la * T)) in H by (field; lra). lra.
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
  - rewrite swing_0, swing'_0. unfold leave. apply Rdiv_lt_0_compat; [|positive].
    apply Rmult_lt_0_compat; auto. pose proof turn_load. assert (0 < (m1 + m2) / m2) by positive.
      lra.
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
