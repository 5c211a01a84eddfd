(** A cycle lasts no less than half a turn: in the slip the pair turns less than a stuck one by what the slip costs, and
    that is gained by the next exit, which is slower. *)
From InertialPair Require Import Dini Excursion ReturnMap AlternatingAngles RateBounds.

(** what a cycle takes beyond pi/Omega, times Omega, by its half angle ([cycle_time_exact]) *)
Definition delay r p := let s := (depth p / hh p) ^ 2 in let q := 1 - r in
  sqrt q * (2 * p) - atan (sqrt q * (hh p * sqrt (1 - r * s))) - atan (sqrt q * (2 * p - hh p) / (1 - q * depth p)).

(** at the angle of a quarter turn *)
Lemma quarter : hh (PI / 4) = PI / 2 - 1 /\ depth (PI / 4) = 2 - PI / 2.
Proof.
  unfold hh, depth. rewrite sin_PI4, cos_PI4. assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (0 < sqrt 2) by positive. split; [|field; lra].
  assert (S4 : 1 / sqrt 2 * (1 / sqrt 2) = / 2) by (field_simplify_eq; [nra|lra]).
  replace ((1 / sqrt 2) ^ 2) with (1 / sqrt 2 * (1 / sqrt 2)) by ring. rewrite S4. field.
Qed.

Section HalfTurn.
Context (r p : R) (Hr : 0 < r < 1) (Hp : 0 < p <= PI / 4).
Context (q := 1 - r) (a := sqrt q) (u := hh p) (c := depth p).
(** place and momentum of the pair in a slip, by its angle, and what the slip has cost *)
Let x t := r + q * (cos t + u * sin t).
Let m t := a * (q * (u * cos t - sin t) + r * (u - t)).
Let paid t := q * r * (u * (t - sin t) - t ^ 2 / 2 + 1 - cos t).
Let aq : a * a = q. Proof. apply sqrt_sqrt. unfold q. lra. Qed.
Let a_pos : 0 < a <= 1.
Proof. split; [apply sqrt_lt_R0; unfold q; lra|]. rewrite <- sqrt_1. apply sqrt_le_1_alt. unfold q. lra. Qed.
Let p_pi : 0 < p < PI. Proof. lra. Qed.
Let small : 0 < u <= 2 / 3 /\ 0 < c <= / 2.
Proof.
  pose proof (hh_pos p p_pi). pose proof (depth_pos p p_pi). pose proof pi_below.
  destruct quarter as (E1 & E2).
  pose proof PI2_3_2. pose proof (rising_le PI hh p (PI / 4) hh_incr ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (rising_le PI depth p (PI / 4) depth_incr ltac:(lra) ltac:(lra) ltac:(lra)). unfold u, c. lra.
Qed.

(** the slip goes on up to its angle, and the place stays above half of that of the ray *)
Lemma on_the_way t : 0 <= t <= 2 * p -> 0 <= u * (1 - cos t) - (t - sin t) /\ / 2 <= x t.
Proof.
  intros Ht. destruct (Req_dec t 0) as [->|N]. { unfold x. rewrite cos_0, sin_0. unfold q. lra. } set (v := t / 2).
  replace t with (2 * v) in * by (unfold v; field). pose proof (sin_gt_0 v ltac:(lra) ltac:(lra)) as S.
  pose proof (cos_ge_0 v ltac:(lra) ltac:(lra)) as Cv. assert (Le : hh v <= u /\ depth v <= c)
    by (split; [apply (rising_le PI hh v p hh_incr)|apply (rising_le PI depth v p depth_incr)]; lra).
  assert (E1 : hh v * (2 * sin v * sin v) = 2 * (v - sin v * cos v)) by (unfold hh; field; lra).
  assert (E2 : hh v * (2 * sin v * cos v) = 2 * sin v * sin v - depth v).
  { unfold hh, depth. trig v. }
  rewrite sin_2a, cos_2a_sin. split.
  - assert (hh v * (2 * sin v * sin v) <= u * (2 * sin v * sin v)) by nra. lra.
  - unfold x. rewrite sin_2a, cos_2a_sin. assert (0 <= 2 * sin v * cos v) by nra.
    assert (hh v * (2 * sin v * cos v) <= u * (2 * sin v * cos v)) by nra. unfold q. nra.
Qed.

(** so the pair turns by no more than the slip's angle and half of what it loses *)
Lemma turn_lost : atan (a * u) + atan (a * (2 * p - u) / (1 - q * c)) <= a * (2 * p) + q * r * c ^ 2 / 2.
Proof.
  set (g t := atan (m t / x t) + a * t + paid t). set (W t := u * (1 - cos t) - (t - sin t)).
  assert (Rise : g 0 <= g (2 * p)).
  { destruct (MVT_cor2 g (fun t => q * r * W t * ((m t + (x t ^ 2 + m t ^ 2)) / (x t ^ 2 + m t ^ 2))) 0 (2 * p) ltac:(lra)) as (t & E & Ht).
    { intros t Ht. destruct (on_the_way t Ht) as (_ & X). apply is_derive_Reals. unfold g, paid, m, x, W.
      auto_derive; [unfold x in X; lra|]. unfold x in X. assert (Er : r = 1 - a * a) by (rewrite aq; unfold q; ring).
      rewrite <- aq in *. rewrite Er in *. field. split; [|lra]. match goal with |- ?z ^ 2 + ?w ^ 2 <> 0 => assert (0 <
        z ^ 2) by (apply pow_lt; lra); pose proof (pow2_ge_0 w); lra end. }
    destruct (on_the_way t ltac:(lra)) as (Wp & X). assert (0 < x t ^ 2) by positive. pose proof (pow2_ge_0 (m t)).
    assert (Q : 0 <= m t + (x t ^ 2 + m t ^ 2)).
    { pose proof (pow2_ge_0 (m t + / 2)). assert (/ 2 * / 2 <= x t * x t) by nra. lra. }
    assert (0 <= q * r * W t * ((m t + (x t ^ 2 + m t ^ 2)) / (x t ^ 2 + m t ^ 2)) * (2 * p - 0)) by positive. lra. }
  pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S.
  assert (Eu : u * (1 - cos (2 * p)) = 2 * p - sin (2 * p)) by (rewrite cos_2a_sin, sin_2a; unfold u, hh; field; lra).
  assert (Ec : cos (2 * p) + u * sin (2 * p) = 1 - c).
  { rewrite cos_2a_sin, sin_2a. unfold u, c, hh, depth. trig p. }
  unfold g in Rise. replace (m 0 / x 0) with (a * u) in Rise by (unfold m, x, q; rewrite cos_0, sin_0; field; lra).
  replace (m (2 * p) / x (2 * p)) with (- (a * (2 * p - u) / (1 - q * c))) in Rise.
  2: { unfold m, x. rewrite Ec. replace (u * cos (2 * p) - sin (2 * p)) with (u - 2 * p) by lra. unfold q. field. nra. }
  rewrite atan_opp in Rise. replace (paid 0) with 0 in Rise by (unfold paid; rewrite cos_0, sin_0; field).
  assert (Pd : paid (2 * p) = q * r * c ^ 2 / 2).
  { unfold paid. pose proof (back_identity p p_pi) as B. fold u c in B. replace (c ^ 2) with (2 * c + 4 * p * u - 4 * p ^ 2) by lra.
    replace c with (1 - (cos (2 * p) + u * sin (2 * p))) by lra. field. }
  lra.
Qed.

(** the next exit is slower by enough to make up for that *)
Theorem delay_pos : 0 <= delay r p.
Proof.
  destruct small as (U & C). pose proof turn_lost as T. unfold delay. fold q a u c. set (z := (c / u) ^ 2).
  assert (Z : r * z * u ^ 2 = r * c ^ 2) by (unfold z; field; lra). assert (Z0 : 0 <= r * z) by positive.
  pose proof (depth_upper p p_pi) as Du. fold u c in Du. assert (c ^ 2 <= (3 / 2 * u ^ 2) ^ 2) by nra.
  assert (Z1 : r * z < 1) by nra. set (w := u * sqrt (1 - r * z)). assert (Sq : 0 <= sqrt (1 - r * z) <= 1).
  { split; [apply sqrt_pos|]. rewrite <- sqrt_1 at 2. apply sqrt_le_1_alt. lra. }
  assert (W : 0 <= w <= u) by (unfold w; nra).
  assert (W2 : u ^ 2 - w ^ 2 = r * c ^ 2) by (unfold w; rewrite Rpow_mult_distr, pow2_sqrt by lra; lra).
  assert (Gain : q * r * c ^ 2 / 2 <= atan (a * u) - atan (a * w)).
  { assert (N : w <> u) by (intros E; rewrite E in W2; assert (0 < r * c ^ 2) by positive; lra).
    assert (Lt : a * w < a * u) by (apply Rmult_lt_compat_l; lra). assert (aw : 0 <= a * w) by positive.
    destruct (MVT_cor2 atan (fun t => / (1 + t ^ 2)) (a * w) (a * u) Lt) as (t & E & Ht).
    { intros t Ht. apply is_derive_Reals. rewrite <- Rsqr_pow2. apply is_derive_atan. }
    rewrite E. replace (q * r * c ^ 2 / 2) with ((a * u + a * w) / 2 * (a * u - a * w)) by (rewrite (Rmult_assoc q), <- W2, <- aq; field).
    apply Rmult_le_compat_r; [lra|]. apply Rmult_le_reg_r with (1 + t ^ 2); [nra|]. rewrite Rinv_l by nra.
    assert (a * u <= 2 / 3) by nra. assert (t ^ 2 <= 4 / 9) by nra. nra. }
  lra.
Qed.
End HalfTurn.
