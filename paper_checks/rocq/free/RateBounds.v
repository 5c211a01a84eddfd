(** From an exit with y0 = w0/q <= 4/9 on, w = E/E_cr - 1 lies between two explicit functions of time: 1/y gains between
    a and A in every cycle, and a cycle lasts between T- and T+, all four from the first excursion. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap TurningFunction Cycle SlipFromGap ExitOrbit
  SharpRate AlternatingAngles.

(** *** Two functions of the half angle: c/h^2 falls, 2 p - h grows *)
Lemma depth_share p p0 : 0 < p -> p <= p0 -> p0 < PI -> depth p0 / hh p0 ^ 2 <= depth p / hh p ^ 2.
Proof.
  intros H0 Hp H1. apply Ropp_le_cancel. apply (rises (fun p => - (depth p / hh p ^ 2))
    (fun p => 2 * (depth p ^ 2 * (1 + ct p ^ 2) - hh p ^ 2) / hh p ^ 3)); [auto| |]; intros u Hu;
    pose proof (hh_pos u ltac:(lra)) as U.
  - evar_last. { apply (is_derive_opp (fun p => depth p / hh p ^ 2)), is_derive_div; [apply derive_depth; lra|
      apply is_derive_pow, derive_hh; lra|simpl; nra]. }
    unfold opp; simpl. field. lra.
  - pose proof (sin_gt_0 u ltac:(lra) ltac:(lra)) as S.
    assert (G : u - sin u * cos u <= 2 * (sin u - u * cos u)).
    { assert (u < PI) by lra. from_zero u (fun u => 2 * sin u * (u - sin u)). intros t Ht.
      pose proof (sin_ge_0 t ltac:(lra) ltac:(lra)). pose proof (sin_below t ltac:(lra)). positive. }
    assert (Le : hh u ^ 2 <= depth u ^ 2 * (1 + ct u ^ 2)); [|positive].
    replace (depth u ^ 2 * (1 + ct u ^ 2)) with ((2 * (sin u - u * cos u) / sin u ^ 2) ^ 2)
      by (unfold depth, ct; trig u). apply pow_incr. split; [positive|].
      apply Rmult_le_compat_r; [positive|lra].
Qed.
Lemma inward_grows p p0 : 0 < p -> p <= p0 -> p0 <= PI / 2 -> 2 * p - hh p <= 2 * p0 - hh p0.
Proof.
  intros H0 Hp H1. apply (rises (fun p => 2 * p - hh p) (fun u => 2 * ((u - sin u * cos u) * cos u / sin u ^
    3)));
    [auto|intros u Hu; slope u|]. intros u Hu. pose proof (A_pos u ltac:(lra)).
  pose proof (sin_gt_0 u ltac:(lra) ltac:(lra)) as S. pose proof (cos_ge_0 u ltac:(lra) ltac:(lra)). positive.
Qed.

(** the depth, the push and the half angle: the speed at re-entry *)
Lemma back_identity p : 0 < p < PI -> (2 * p - hh p) ^ 2 = hh p ^ 2 + 2 * depth p - depth p ^ 2.
Proof. intros Hp. unfold hh, depth. trig p. Qed.
(** an arc cosine is between its sine and its tangent *)
Lemma acos_between z : 0 < z <= 1 -> sqrt (1 - z ^ 2) <= acos z <= sqrt (1 - z ^ 2) / z.
Proof.
  intros Hz. pose proof (acos_bound z) as B. pose proof (cos_acos z ltac:(lra)) as C.
  replace (sqrt (1 - z ^ 2)) with (sin (acos z)) by (rewrite sin_acos by lra; f_equal; unfold Rsqr; ring).
  split; [apply sin_below; lra|]. undivide z. rewrite <- C at 2. set (a := acos z) in *.
  destruct (Req_dec a 0) as [->|N]; [rewrite sin_0; lra|].
  assert (a < PI) by (destruct (Req_dec a PI) as [E|]; [rewrite E, cos_PI in C|]; lra).
  pose proof (g_pos a ltac:(lra)). lra.
Qed.

Section Bounds.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (r := m2 / (m1 + m2)) (om := omega m1 m2 a2)
  (q_pos : 0 < q := q_pos m1 m2 Hm1 Hm2) (r_pos : 0 < r := r_pos m1 m2 Hm1 Hm2).
Let qr : q + r = 1 := qr_one m1 m2 Hm1 Hm2.

(** pushes up to 2/3, and their depths *)
Lemma ok_push p : 0 < p < PI -> hh p <= 2 / 3 -> ok m1 m2 p /\ depth p <= 2 / 3 /\ 2 * p - hh p <= 2 * hh p.
Proof.
  intros Hp Hh. pose proof (depth_upper p Hp). pose proof (hh_below p Hp). pose proof PI2_1.
  assert (hh p ^ 2 <= (2 / 3) ^ 2) by nra. split; [|lra]. apply ok_small; auto; [split; [lra|]|fold r; nra].
  apply hh_le; auto; [lra|]. rewrite hh_half_pi. lra.
Qed.

(** *** A cycle: its slip, and its stick between two angles *)
Theorem cycle_angles p : 0 < p < PI -> hh p <= 2 / 3 -> let u' := hh (next m1 m2 p) in let rho := amp m1 m2 (u' ^ 2) in
  let A := atan (sqrt q * u') in let B := atan (sqrt q * (2 * p - hh p) / (1 - q * depth p)) in
  om * cyc m1 m2 a2 p = PI + sqrt q * (2 * p) - A - B /\ u' <= hh p /\ sqrt q * u' / rho <= A <= sqrt q * u' /\
  sqrt q * (2 * p - hh p) / rho <= B <= sqrt q * (2 * p - hh p) / (1 - q * depth p).
Proof.
  intros Hp Hh u' rho A B. destruct (ok_push p Hp Hh) as (Hok & C1 & _). destruct (next_ok m1 m2 Hm1 Hm2 p Hok) as (Hn & En).
  fold r in En. pose proof (hh_pos _ (ok_pi m1 m2 _ Hn)) as N0. pose proof (hh_pos p Hp) as U0.
  pose proof (depth_pos p Hp) as C0. pose proof (back p (proj1 Hok)) as P2. pose proof (back_identity p Hp) as Bk.
  pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O0. fold om in O0. pose proof (o1_pos m1 a2 Hm1 Ha2) as O1.
  unfold cyc, A, B. fold q om u'. fold u' in En, N0. set (u := hh p) in *. set (c := depth p) in *. fold rho. assert (Y2 : 0 < u' ^ 2) by positive.
  assert (R1 : 1 <= rho) by (apply amp_ge; auto; lra).
  assert (R2 : rho * rho = 1 + q * u' ^ 2) by (apply amp_sq; auto; lra).
  assert (I1 : 0 < / rho <= 1). { split; [positive|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (0 <= c ^ 2) by positive. assert (U' : u' <= u) by nra. assert (Sq : 0 < sqrt q) by positive.
  assert (SS : sqrt q * sqrt q = q) by (apply sqrt_sqrt; lra). assert (Qc : 0 < q * c < 1) by nra.
  assert (Angle : forall z w, 0 < z <= 1 -> 0 <= w -> z ^ 2 + q * w ^ 2 = rho * rho ->
    acos (z / rho) = atan (sqrt q * w / z) /\ sqrt q * w / rho <= atan (sqrt q * w / z) <= sqrt q * w / z).
  { intros z w Hz Hw E. assert (Z : 0 < z / rho <= 1) by (split; [positive|unfold Rdiv; nra]). pose proof (acos_between _ Z) as Bt.
    assert (Root : sqrt (1 - (z / rho) ^ 2) = sqrt q * w / rho).
    { replace (1 - (z / rho) ^ 2) with ((sqrt q * w / rho) ^ 2); [apply sqrt_pow2; positive|].
      replace ((sqrt q * w / rho) ^ 2) with (sqrt q * sqrt q * w ^ 2 / (rho * rho)) by (field; lra). rewrite SS.
      replace (q * w ^ 2) with (rho * rho - z ^ 2) by lra. field. lra. }
    assert (Eq : sqrt (1 - (z / rho) ^ 2) / (z / rho) = sqrt q * w / z) by (rewrite Root; field; lra).
    assert (At : acos (z / rho) = atan (sqrt q * w / z)) by (rewrite acos_atan, Rsqr_pow2, Eq by lra; auto).
    rewrite Eq, Root, At in Bt. auto. }
  destruct (Angle 1 u') as (A1 & A2); [lra|lra|lra|]. rewrite Rdiv_1 in A1, A2.
  destruct (Angle (1 - q * c) (2 * p - u)) as (B1 & B2); [lra|lra|rewrite R2, En, Bk; replace r with (1 - q) by lra; ring|].
  split; [|auto]. rewrite acos_opp, <- B1. replace (/ rho) with (1 / rho) by lra. rewrite A1.
  pose proof (om_o1 m1 m2 a2 Hm1 Hm2 Ha2) as Oo. fold q om in Oo. rewrite <- Oo. field. lra.
Qed.
(** [cycle-time-exact] From a ray with $h\leqslant\tfrac{2}{3}$ a cycle takes $(\pi+\sqrt q\,\theta-\arctan(\sqrt
    q\sqrt{h^2-r\,c^2})-\arctan\frac{\sqrt q\,(\theta-h)}{1-q\,c})/\Omega$. *)
Theorem cycle_time_exact p : 0 < p < PI -> hh p <= 2 / 3 -> om * cyc m1 m2 a2 p = PI + sqrt q * (2 * p) -
  atan (sqrt q * sqrt (hh p ^ 2 - r * depth p ^ 2)) - atan (sqrt q * (2 * p - hh p) / (1 - q * depth p)).
Proof.
  intros Hp Hh. destruct (ok_push p Hp Hh) as (Hok & _). destruct (next_ok m1 m2 Hm1 Hm2 p Hok) as (Hn & En). fold r in En.
  rewrite <- En, sqrt_pow2 by (apply Rlt_le, hh_pos, (ok_pi m1 m2); auto). apply (cycle_angles p Hp Hh).
Qed.
(** its time, by its first excursion *)
Theorem cycle_between p : 0 < p < PI -> hh p <= 2 / 3 ->
  PI - sqrt q * (2 * p - hh p) * (q * depth p / (1 - q * depth p)) <= om * cyc m1 m2 a2 p <= PI + sqrt q * (2 * p).
Proof.
  intros Hp Hh. destruct (ok_push p Hp Hh) as (Hok & C1 & _). destruct (cycle_angles p Hp Hh) as (-> & Le & HA & HB).
  set (B := atan (_ / _)) in *. destruct (next_ok m1 m2 Hm1 Hm2 p Hok) as (Hn & _).
  pose proof (hh_pos _ (ok_pi m1 m2 _ Hn)). pose proof (back p (proj1 Hok)).
  assert (R1 : 1 <= amp m1 m2 (hh (next m1 m2 p) ^ 2)) by (apply amp_ge; auto; positive).
  assert (Qc : q * depth p < 1) by nra. split.
  - replace (sqrt q * (2 * p - hh p) * (q * depth p / (1 - q * depth p))) with
      (sqrt q * (2 * p - hh p) / (1 - q * depth p) - sqrt q * (2 * p - hh p)) by (field; lra).
    assert (sqrt q * hh (next m1 m2 p) <= sqrt q * hh p) by scale. lra.
  - assert (0 <= sqrt q * hh (next m1 m2 p) / amp m1 m2 (hh (next m1 m2 p) ^ 2)) by positive.
    assert (0 <= sqrt q * (2 * p - hh p) / amp m1 m2 (hh (next m1 m2 p) ^ 2)) by positive. lra.
Qed.

Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let w t := energy m1 m2 a2 (x t) (v1 t) (v2 t) / Ecr m1 m2 a2 b - 1.

(** *** The bounds: all later cycles are bounded by the first *)

Section First.
Variables k t0 p : R.
Hypotheses (Hk : k = 1 \/ k = -1) (Ht : 0 <= t0) (Hp : 0 < p < PI) (Hh : hh p <= 2 / 3)
  (HR : on_ray m1 m2 a2 b k (hh p) x v1 v2 t0).
Context (y0 := hh p ^ 2) (c0 := depth p) (a := r * c0 ^ 2 / y0 ^ 2) (A := 9 / 4 * r / (1 - r * c0 ^ 2 / y0))
  (Tu := PI + sqrt q * (2 * p)) (Tl := PI - sqrt q * (2 * p - hh p) * (q * c0 / (1 - q * c0))).
Lemma level_between t : t0 <= t ->
  / y0 + a * (om * (t - t0) / Tu - 1) <= / (w t / q) <= / y0 + A * (om * (t - t0) / Tl + 1).
Proof.
  destruct (ok_push p Hp Hh) as (Hok & C1 & Dp). pose proof (hh_pos p Hp) as U0.
  pose proof (depth_pos p Hp : 0 < c0) as C0. change (depth p) with c0 in C1. pose proof PI2_3_2 as P3.
  assert (Y0 : 0 < y0) by positive.
  assert (Loss : r * c0 ^ 2 / y0 < 1) by (destruct Hok as (_ & K); undivide y0; fold r c0 y0 in K; lra).
  assert (A0 : 0 <= A) by (unfold A; apply Rlt_le, Rdiv_lt_0_compat; lra). assert (a0 : 0 <= a) by positive.
  assert (Qc : forall c, 0 < c <= c0 -> 0 < q * c <= 2 / 3) by (intros c Hc; split; [positive|nra]).
  assert (Part : forall c, 0 < c <= c0 -> 0 < q * c / (1 - q * c) <= q * c0 / (1 - q * c0) /\
    q * c / (1 - q * c) <= 2).
  { intros c Hc. pose proof (Qc c Hc). pose proof (Qc c0 ltac:(lra)). assert (q * c <= q * c0) by scale.
    split; [split; [positive|]|undivide (1 - q * c); lra].
    apply Rmult_le_compat; [lra|positive|lra|apply Rinv_le_contravar; lra]. }
  assert (S1 : 0 < sqrt q <= 1) by (split; [positive|rewrite <- sqrt_1; apply sqrt_le_1_alt; lra]).
  assert (TlP : 0 < Tl). { destruct (Part c0 ltac:(lra)) as ((G & _) & G2). unfold Tl. pose proof (back p (proj1 Hok)).
    assert (sqrt q * (2 * p - hh p) <= 1 * (4 / 3)) by (apply Rmult_le_compat; lra). nra. }
  set (ph := orb m1 m2 p). assert (Ok : forall n, ok m1 m2 (ph n)) by (intros; apply orb_ok; auto).
  assert (Pi : forall n, 0 < ph n < PI) by (intros; apply (ok_pi m1 m2), Ok).
  assert (Step : forall n, hh (ph (S n)) ^ 2 = hh (ph n) ^ 2 - r * depth (ph n) ^ 2)
    by (intros n; apply (next_ok m1 m2 Hm1 Hm2 (ph n) (Ok n))).
  assert (Le : forall n, 0 < ph n <= p) by (intros n; split; [apply Pi|exact (phi_0 r r_pos ph Pi Step n)]).
  assert (Push : forall n, hh (ph n) <= hh p) by (intros n; exact (push_below m1 m2 Hm1 Hm2 p Hok n)).
  assert (Cn : forall n, 0 < depth (ph n) <= c0).
  { intros n. split; [apply depth_pos, Pi|]. pose proof (Le n).
    apply (rising_le PI depth (ph n) p depth_incr); lra. }
  assert (Gain : forall n, a <= / hh (ph (S n)) ^ 2 - / hh (ph n) ^ 2 <= A).
  { intros n. assert (Y' : 0 < hh (ph (S n)) ^ 2) by (apply pow_lt, hh_pos, Pi).
    specialize (Step n). set (yn := hh (ph n) ^ 2) in *. set (y' := hh (ph (S n)) ^ 2) in *. set (c := depth (ph n)) in *.
    pose proof (Cn n) as Hc. assert (0 < r * c ^ 2) by positive. replace (/ y' - / yn) with (r * c ^ 2 / yn ^ 2 * (yn /
      y')) by (replace (r * c ^ 2) with (yn - y') by lra; field; lra).
    pose proof (depth_share (ph n) p ltac:(apply Le) ltac:(apply Le) ltac:(lra)) as Sh. fold c0 y0 c yn in Sh.
    assert (c / yn <= 3 / 2) by (undivide yn; apply depth_upper, Pi).
    assert (R1 : a <= r * c ^ 2 / yn ^ 2 <= 9 / 4 * r).
    { unfold a. replace (r * c0 ^ 2 / y0 ^ 2) with (r * (c0 / y0) ^ 2) by (field; lra).
      replace (r * c ^ 2 / yn ^ 2) with (r * (c / yn) ^ 2) by (field; lra). assert (0 < c0 / y0) by positive. split; [scale; apply pow_incr; lra|].
      replace (9 / 4 * r) with (r * (3 / 2) ^ 2) by field. scale. apply pow_incr; lra. }
    assert (R2 : 1 <= yn / y') by (undivide y'; lra).
    assert (R3 : yn / y' <= / (1 - r * c0 ^ 2 / y0)).
    { replace (yn / y') with (/ (1 - r * c ^ 2 / yn)) by (replace y' with (yn - r * c ^ 2) by lra; field; lra).
      apply Rinv_le_contravar; [lra|].
      pose proof (ratio_falls (ph n) p ltac:(apply Le) ltac:(apply Le) (proj2 (proj1 Hok))) as Ra.
      assert (c / hh (ph n) <= c0 / hh p).
      { rewrite <- (Rinv_inv (c / hh (ph n))), <- (Rinv_inv (c0 / hh p)). apply Rinv_le_contravar; [positive|].
        rewrite !Rinv_div. exact Ra. }
      assert ((c / hh (ph n)) ^ 2 <= (c0 / hh p) ^ 2) by (apply pow_incr; split; [pose proof (hh_pos _ (Pi n)); positive|auto]).
      assert (r * (c / hh (ph n)) ^ 2 <= r * (c0 / hh p) ^ 2) by scale. pose proof (hh_pos _ (Pi n)).
      replace (r * c ^ 2 / yn) with (r * (c / hh (ph n)) ^ 2) by (unfold yn; field; lra).
      replace (r * c0 ^ 2 / y0) with (r * (c0 / hh p) ^ 2) by (unfold y0; field; lra). lra. }
    split; [rewrite <- (Rmult_1_r a); apply Rmult_le_compat; lra|]. apply Rmult_le_compat; lra. }
  assert (Time : forall n, Tl <= om * cyc m1 m2 a2 (ph n) <= Tu).
  { intros n. destruct (cycle_between (ph n) (Pi n) ltac:(pose proof (Push n); lra)) as (T1 & T2). pose proof (Le n) as L.
    destruct (Part _ (Cn n)) as (G & _). pose proof (inward_grows (ph n) p ltac:(lra) ltac:(lra) (proj2 (proj1 Hok))).
    pose proof (back (ph n) (proj1 (Ok n))). split.
    - apply Rle_trans with (2 := T1). apply Rplus_le_compat_l, Ropp_le_contravar.
      apply Rmult_le_compat; [positive|lra|scale|lra].
    - apply Rle_trans with (1 := T2). apply Rplus_le_compat_l. scale. }
  intros Hu. exact (between m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hok HR a A Tl Tu t a0 A0 TlP
    Gain Time Hu).
Qed.
End First.

(** [rate-bounds] From an exit ray with $y_0\leqslant\tfrac{4}{9}$ on, $w$ lies between $q/(1/y_0+A(s/T_-+1))$ and
    $q/(1/y_0+a'(s/T_+-1))$, the constants explicit in the first excursion. *)
Theorem rate_bounds k t0 p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI -> hh p <= 2 / 3 ->
  on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 -> let y0 := hh p ^ 2 in let c0 := depth p in
  let a := r * c0 ^ 2 / y0 ^ 2 in let A := 9 / 4 * r / (1 - r * c0 ^ 2 / y0) in
  let Tu := PI + sqrt q * (2 * p) in let Tl := PI - sqrt q * (2 * p - hh p) * (q * c0 / (1 - q * c0)) in
  w t0 = q * y0 /\ forall t, t0 <= t ->
  q / (/ y0 + A * (om * (t - t0) / Tl + 1)) <= w t <= q / (/ y0 + a * (om * (t - t0) / Tu - 1)).
Proof.
  intros Hk Ht Hp Hh HR y0 c0 a A Tu Tl. destruct (ok_push p Hp Hh) as (Hok & _).
  pose proof (hh_pos p Hp) as U0.
  pose proof (SharpRate.Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as E0. assert (Y0 : 0 < y0) by (unfold y0; positive).
  pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2 : 0 < om) as O0. pose proof (depth_pos p Hp : 0 < c0) as C0.
  pose proof PI_RGT_0. assert (Wt : forall t, w t = q * (w t / q)) by (intros; field; lra). split.
  { pose proof (exit_level m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hok HR 0 :
      energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) = Stick.Ecr m1 m2 a2 b * (1 + q * y0)) as E. unfold w. rewrite E.
        field. lra. }
  intros t Hu. pose proof (never_merges m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hok HR t ltac:(lra)) as NM.
  assert (Wp : 0 < w t / q). { apply Rdiv_lt_0_compat; auto. apply Rlt_Rminus. undivide (Stick.Ecr m1 m2 a2 b). lra. }
  pose proof (level_between k t0 p Hk Ht Hp Hh HR t Hu) as B. fold y0 c0 in B. fold a A Tu Tl in B.
  assert (Den : 0 < / y0 + a * (om * (t - t0) / Tu - 1)).
  { assert (Loss : r * c0 ^ 2 / y0 < 1) by (destruct Hok as (_ & K); undivide y0; fold r c0 y0 in K; lra).
    assert (a < / y0). { unfold a. replace (r * c0 ^ 2 / y0 ^ 2) with (r * c0 ^ 2 / y0 * / y0) by (field;
      lra).
      rewrite <- (Rmult_1_l (/ y0)) at 2. scale. }
    assert (0 <= a * (om * (t - t0) / Tu)) by (unfold a, Tu; positive). lra. }
  rewrite (Wt t). rewrite <- (Rinv_inv (w t / q)).
  split; apply Rmult_le_compat_l; try lra; apply Rinv_le_contravar; lra.
Qed.
End Bounds.
