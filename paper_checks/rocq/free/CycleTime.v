(** The time of a cycle is pi/Omega up to a constant times w^(3/2),
  w the excess of its exit: the orders sqrt w and w cancel.

    In Omega t the slip takes 2 p sqrt q and the stick pi - A - B, with sin A = sqrt q u'/rho,
      sin B = sqrt q (2 p - u)/rho, where u = h(p), u' is that of the next exit, and rho^2 = 1 + q u'^2.
      A small angle is its sine up to its cube over 6, rho is 1 up to q u^2/2, and u' is u up to r c^2/u. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap TurningFunction FollowArc Cycle ExitOrbit
  SharpLaw.

(** an angle with sine y/rho, where 1/rho is 1 up to e, is y up to its cube and y e *)
Lemma angle_near a y rho e c : 0 <= a <= PI / 2 -> 1 <= rho -> 1 - / rho <= e -> 0 <= y <= c -> sin a = y / rho ->
  y - c * e <= a <= y + (2 * c) ^ 3 / 6.
Proof.
  intros Ha Hr He Hy S. pose proof PI2_1.
  assert (I : 0 < / rho <= 1) by (split; [apply Rinv_0_lt_compat; lra|rewrite <- Rinv_1; apply Rinv_le_contravar; lra]).
  assert (Sy : sin a <= y) by (rewrite S; unfold Rdiv; nra). pose proof (sin_below a ltac:(lra)) as Up. split.
  - assert (y * (1 - / rho) <= c * e) by (apply Rmult_le_compat; lra). unfold Rdiv in S. lra.
  - assert (A2 : a <= 2 * y). { destruct (Req_dec a 0) as [->|]; [lra|]. pose proof (sin_half a ltac:(lra)). lra. }
    pose proof (sin_above a ltac:(lra)). assert (a ^ 3 <= (2 * c) ^ 3) by (apply pow_incr; lra). lra.
Qed.

Section Time.
Variables m1 m2 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Let q := m1 / (m1 + m2).
Let r := m2 / (m1 + m2).
Let om := omega m1 m2 a2.

(** the depth, the push and the half angle *)
Lemma depth_hh p : 0 < p < PI -> depth p ^ 2 - 2 * depth p - 4 * p * hh p + 4 * p ^ 2 = 0.
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (sin2_cos2 p) as SC. unfold Rsqr in SC.
  unfold depth, hh. apply Rmult_eq_reg_r with (sin p ^ 2); [|apply pow_nonzero; lra].
  replace (((2 * (sin p - p * cos p) / sin p) ^ 2 - 2 * (2 * (sin p - p * cos p) / sin p) -
    4 * p * ((p - sin p * cos p) / sin p ^ 2) + 4 * p ^ 2) * sin p ^ 2)
    with (4 * p ^ 2 * (sin p * sin p + cos p * cos p - 1)) by (field; lra). rewrite SC. ring.
Qed.
(** the depth and the speed at re-entry *)
Lemma back_identity p : 0 < p < PI -> (2 * p - hh p) ^ 2 = hh p ^ 2 + 2 * depth p - depth p ^ 2.
Proof. intros Hp. pose proof (depth_hh p Hp). lra. Qed.

(** an arc cosine up to pi/2 and its sine *)
Lemma acos_first z : 0 <= z <= 1 -> 0 <= acos z <= PI / 2 /\ sin (acos z) = sqrt (1 - z ^ 2).
Proof.
  intros Hz. pose proof (acos_bound z) as B. split.
  - split; [lra|]. rewrite <- acos_0. apply cos_decr_0; try lra; try apply acos_bound. rewrite !cos_acos by lra. lra.
  - rewrite sin_acos by lra. f_equal. unfold Rsqr. ring.
Qed.

(** The cycle time, all terms together. *)
Theorem cycle_time_sharp p : ok m1 m2 p -> hh p <= 2 / 3 ->
  Rabs (om * cyc m1 m2 a2 p - PI) <= 27 / 2 * sqrt q * hh p ^ 3.
Proof.
  intros Hok Hu. pose proof (ok_pi m1 m2 p Hok) as Hp. destruct (next_ok m1 m2 Hm1 Hm2 p Hok) as (Hn & En).
  pose proof (hh_pos _ (ok_pi m1 m2 _ Hn)) as N0. pose proof (hh_pos p Hp) as U0.
  pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. pose proof (r_pos m1 m2 Hm1 Hm2) as R0.
    pose proof (qr_one m1 m2 Hm1 Hm2) as QR.
  pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O0. pose proof (o1_pos m1 a2 Hm1 Ha2) as O1.
  pose proof (depth_pos p Hp) as C0. pose proof (depth_upper p Hp) as C1. pose proof (hh_below p Hp) as P1.
  destruct Hok as (Hp2 & _). pose proof (back p Hp2) as P2. pose proof (back_identity p Hp) as Bk.
  fold q r in En, Q0, R0, QR. fold om in O0. unfold cyc. fold q. set (u' := hh (next m1 m2 p)) in *. fold om.
  set (u := hh p) in *. set (c := depth p) in *. set (rho := amp m1 m2 (u' ^ 2)).
  assert (S2 : u ^ 2 <= 4 / 9) by nra. assert (Y2 : 0 < u' ^ 2) by positive.
  assert (R1 : 1 <= rho) by (apply amp_ge; auto; lra).
    assert (R2 : rho * rho = 1 + q * u' ^ 2) by (apply amp_sq; auto; lra).
  assert (I : rho * / rho = 1) by (apply Rinv_r; lra).
  assert (I1 : 0 < / rho <= 1) by (split; [apply Rinv_0_lt_compat; lra|rewrite <- Rinv_1; apply Rinv_le_contravar;
    lra]).
  assert (C2 : 0 < c ^ 2) by positive. assert (U' : u' <= u) by nra. assert (R3 : 1 - / rho <= q * u ^ 2 / 2).
  { assert (rho - 1 <= q * u' ^ 2 / 2) by nra.
    assert (q * u' ^ 2 <= q * u ^ 2) by (apply Rmult_le_compat_l; [lra|apply pow_incr; lra]).
    replace (1 - / rho) with ((rho - 1) * / rho) by (rewrite Rmult_minus_distr_r, I; ring).
    apply Rle_trans with ((rho - 1) * 1); [scale|lra]. }
  assert (Sq : 0 < sqrt q) by positive. assert (SS : sqrt q * sqrt q = q) by (apply sqrt_sqrt; lra).
  assert (Qc : 0 < q * c <= 1). { split; [apply Rmult_lt_0_compat; auto|]. nra. }
  assert (ZB : 0 <= (1 - q * c) / rho <= 1) by (unfold Rdiv; split; [positive|]; nra).
  rewrite acos_opp. destruct (acos_first (/ rho) ltac:(lra)) as (A1 & A2). destruct (acos_first _ ZB) as (B1 & B2).
  set (A := acos (/ rho)) in *. set (B := acos ((1 - q * c) / rho)) in *. assert (SA : sin A = sqrt q * u' / rho).
  { rewrite A2. rewrite <- (sqrt_pow2 (sqrt q * u' / rho)) by positive. f_equal.
    replace ((sqrt q * u' / rho) ^ 2) with ((rho * rho - 1) * / rho * / rho) by (rewrite R2; unfold Rdiv;
      replace q with (sqrt q * sqrt q) at 1 by auto; ring).
    replace ((rho * rho - 1) * / rho * / rho) with (rho * / rho * (rho * / rho) - / rho ^ 2) by (field; lra).
    rewrite I. rewrite pow_inv. ring. }
  assert (SB : sin B = sqrt q * (2 * p - u) / rho).
  { rewrite B2. rewrite <- (sqrt_pow2 (sqrt q * (2 * p - u) / rho)) by positive. f_equal.
    replace ((sqrt q * (2 * p - u) / rho) ^ 2) with (sqrt q * sqrt q * (2 * p - u) ^ 2 * / rho * / rho) by (unfold
      Rdiv; ring).
    rewrite SS, Bk. replace (q * (u ^ 2 + 2 * c - c ^ 2)) with (rho * rho - (1 - q * c) ^ 2) by (rewrite R2, En;
      replace r with (1 - q) by lra; ring).
    replace ((rho * rho - (1 - q * c) ^ 2) * / rho * / rho) with (rho * / rho * (rho * / rho) - ((1 - q * c) /
      rho) ^ 2) by (field; lra).
    rewrite I. ring. }
  pose proof (angle_near A (sqrt q * u') rho (q * u ^ 2 / 2) (sqrt q * u) A1 R1 R3) as NA.
  pose proof (angle_near B (sqrt q * (2 * p - u)) rho (q * u ^ 2 / 2) (sqrt q * (2 * u)) B1 R1 R3) as NB.
  assert (Y1 : 0 <= sqrt q * u' <= sqrt q * u) by (split; [apply Rmult_le_pos|apply Rmult_le_compat_l]; lra).
  assert (Y3 : 0 <= sqrt q * (2 * p - u) <= sqrt q * (2 * u)) by (split;
    [apply Rmult_le_pos|apply Rmult_le_compat_l]; lra).
  specialize (NA Y1 SA). specialize (NB Y3 SB). assert (Du : u - u' <= r * (9 / 4) * u ^ 3).
  { apply Rmult_le_reg_r with u; auto. assert ((u - u') * u <= u ^ 2 - u' ^ 2) by nra.
    assert (c ^ 2 <= (3 / 2 * u ^ 2) ^ 2) by (apply pow_incr; lra).
    assert (r * c ^ 2 <= r * (3 / 2 * u ^ 2) ^ 2) by scale.
    replace (r * (9 / 4) * u ^ 3 * u) with (r * (3 / 2 * u ^ 2) ^ 2) by field. lra. }
  set (w := sqrt q * u ^ 3). assert (W : 0 < w) by positive. assert (Du' : sqrt q * u - sqrt q * u' <= 9 / 4 * r * w).
  { unfold w. replace (9 / 4 * r * (sqrt q * u ^ 3)) with (sqrt q * (r * (9 / 4) * u ^ 3)) by ring.
    rewrite <- Rmult_minus_distr_l. scale. }
  replace ((2 * (sqrt q * u)) ^ 3 / 6) with (4 / 3 * q * w) in NA by (unfold w;
    replace q with (sqrt q * sqrt q) at 1 by auto; field).
  replace ((2 * (sqrt q * (2 * u))) ^ 3 / 6) with (32 / 3 * q * w) in NB by (unfold w;
    replace q with (sqrt q * sqrt q) at 1 by auto; field).
  replace (sqrt q * u * (q * u ^ 2 / 2)) with (1 / 2 * q * w) in NA by (unfold w; field).
  replace (sqrt q * (2 * u) * (q * u ^ 2 / 2)) with (q * w) in NB by (unfold w; field).
  replace (om * (2 * p / o1 m1 a2 + (PI - A - B) / om) - PI) with (2 * p * (om / o1 m1 a2) - A - B) by (field; lra).
  unfold om. rewrite om_o1 by auto. fold q. replace (27 / 2 * sqrt q * u ^ 3) with (27 / 2 * w) by (unfold w; ring).
  assert (r * w <= w) by nra. assert (q * w <= w) by nra.
    assert (q * w + r * w = w) by (rewrite <- Rmult_plus_distr_r, QR; ring).
  apply Rabs_le. split; lra.
Qed.
End Time.
