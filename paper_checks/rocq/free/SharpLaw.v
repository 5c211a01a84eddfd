(** Every start on S0 slightly above E_cr, and every solution that never merges: no merging, and the sharp law. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap EnergyLimit Dichotomy FollowArc Cycle ExitOrbit
  SharpRate RateBounds ReturnToS0.

Section Law.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (M := m1 + m2) (q := m1 / M) (r := m2 / M) (om := omega m1 m2 a2) (L := L m1 m2 a2 b)
  (Ecr := Ecr m1 m2 a2 b) (en := energy m1 m2 a2) (q_pos : 0 < q := q_pos m1 m2 Hm1 Hm2)
  (r_pos : 0 < r := r_pos m1 m2 Hm1 Hm2) (om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2)
  (L0 : 0 < L := L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) (E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb).

(** The relative excess w = E/E_cr - 1 is small: u = sqrt (w/q) <= pi/2, and w < 4 q/(9 r). *)
Definition small E := E / Ecr - 1 <= q * (PI / 2) ^ 2 /\ E / Ecr - 1 < 4 * q / (9 * r).
(** simpler: w <= 4q/9 is enough *)
Lemma small_simple E : E <= Ecr * (1 + 4 / 9 * q) -> small E.
Proof.
  intros HE. assert (W : E / Ecr - 1 <= 4 / 9 * q).
  { apply Rmult_le_reg_l with Ecr; auto. replace (Ecr * (E / Ecr - 1)) with (E - Ecr) by (field; lra). lra. }
  pose proof PI2_1. pose proof (qr_one m1 m2 Hm1 Hm2) as QR. fold M q r in QR. split.
  { assert (1 <= (PI / 2) ^ 2) by nra. assert (q * 1 <= q * (PI / 2) ^ 2) by nra. lra. }
  undivide (9 * r). nra.
Qed.

(** the half slip angle of a small level *)
Lemma level_angle E : Ecr < E -> small E -> exists p, ok m1 m2 p /\ E = Ecr * (1 + q * hh p ^ 2).
Proof.
  intros HE (Sm1 & Sm2). destruct (level_push m1 m2 a2 b Hm1 Hm2 Ha2 Hb E HE) as (U & EU). fold M Ecr in U, EU.
  fold q in U, EU. set (u := sqrt _) in *. assert (W : E / Ecr - 1 = q * u ^ 2) by (rewrite EU; field; lra).
  rewrite W in Sm1, Sm2. destruct (half_spec u U) as (Hp & Hh). exists (half u). split; [|rewrite Hh; exact EU].
  apply ok_small; auto.
  - split; [lra|]. pose proof PI_RGT_0. apply hh_le; [lra|lra|]. rewrite Hh, hh_half_pi.
    apply Rmult_le_reg_l in Sm1; [nra|auto].
  - fold M r. rewrite Hh. apply Rlt_div_r in Sm2; [|lra]. apply Rmult_lt_reg_l with q; auto. lra.
Qed.

(** [arc-to-left-ray] On $S_0$ above $E_{cr}$ and moving to the left every solution sticks until it reaches the left
    exit ray, at the same level. *)
Lemma to_ray_left y w1 w2 z t u : solution m1 m2 0 a2 b y w1 w2 z -> 0 <= t -> w1 t = w2 t -> - L <= y t <= L ->
  w1 t < 0 -> 0 < u ->
  energy m1 m2 a2 (y t) (w1 t) (w2 t) = Ecr * (1 + q * u ^ 2) ->
  exists t2, t <= t2 < t + PI / om /\ on_ray m1 m2 a2 b (-1) u y w1 w2 t2 /\ forall t', t <= t' <= t2 ->
    w1 t' = w2 t' /\ - L <= y t' <= L.
Proof.
  intros S Ht Ev Hx Hv Hu En.
  destruct (stick m1 m2 a2 b Hm1 Hm2 Ha2 Hb y w1 w2 z t (y t / L) u S Ht Hu) as (T1 & R1 & I1); auto.
  { fold L. field. lra. }
  { split; apply Rmult_le_reg_r with L; auto; replace (y t / L * L) with (y t) by (field; lra); lra. }
  match type of R1 with on_ray _ _ _ _ _ _ _ _ _ (t + ?TT) => set (T := TT) in * end. fold om in T1.
  exists (t + T). split; [lra|]. split; [auto|]. intros t' Ht'. specialize (I1 (t' - t) ltac:(lra)).
    replace (t + (t' - t)) with t' in I1 by ring. exact I1.
Qed.
(** to the other side as well *)
Lemma to_ray_side k y w1 w2 z t u : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b y w1 w2 z -> 0 <= t -> w1 t = w2 t ->
  - L <= y t <= L -> k * w1 t < 0 -> 0 < u -> energy m1 m2 a2 (y t) (w1 t) (w2 t) = Ecr * (1 + q * u ^ 2) ->
  exists t2, t <= t2 < t + PI / om /\ on_ray m1 m2 a2 b (- k) u y w1 w2 t2 /\
    forall t', t <= t' <= t2 -> w1 t' = w2 t' /\ - L <= y t' <= L.
Proof.
  intros Hk S Ht Ev Hx Hv Hu En.
  destruct (to_ray_left _ _ _ _ t u (sided m1 m2 a2 b k _ _ _ _ Hk S) Ht) as (t2 & A & B & C); auto.
  { rewrite Ev. reflexivity. }
    { destruct Hk; subst k; lra. } { rewrite <- En. unfold energy. destruct Hk; subst k; field. }
  exists t2. split; [auto|]. split; [unfold on_ray in *; lra|]. intros t' Ht'. specialize (C t' Ht').
  destruct Hk; subst k; lra.
Qed.
Section Ray.
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let E t := en (x t) (v1 t) (v2 t).
(** [arc-to-ray] On $S_0$ above $E_{cr}$ every solution sticks until it reaches one of the two exit rays. *)
Lemma to_ray t u : 0 <= t -> v1 t = v2 t -> - L <= x t <= L -> 0 < u -> E t = Ecr * (1 + q * u ^ 2) ->
  exists k t2, (k = 1 \/ k = -1) /\ t <= t2 < t + PI / om /\ on_ray m1 m2 a2 b k u x v1 v2 t2 /\
    forall t', t <= t' <= t2 -> v1 t' = v2 t' /\ - L <= x t' <= L.
Proof.
  intros Ht Ev Hx Hu En. destruct (Rtotal_order (v1 t) 0) as [N|[Z|P]].
  - destruct (to_ray_left x v1 v2 s t u H) as (t2 & A); auto. exists (-1), t2. tauto.
  - pose proof (Rmult_lt_0_compat _ _ E0 (Rmult_lt_0_compat _ _ q_pos (pow_lt _ 2 Hu))) as Q.
    assert (HE : Ecr < E t) by lra. unfold E, en, energy in HE. rewrite <- Ev in HE. unfold Ecr in HE.
    rewrite Ecr_L in HE by auto. fold L in HE. assert (x t ^ 2 <= L ^ 2) by nra. nra.
  - destruct (to_ray_side (-1) x v1 v2 s t u ltac:(auto) H) as (t2 & A); auto; [lra|].
    replace (- -1) with 1 in A by ring. exists 1, t2. tauto.
Qed.
End Ray.

(** the same at a small level, by its half angle *)
Theorem start x v1 v2 s t0 : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> v1 t0 = v2 t0 -> - L <= x t0 <= L ->
  Ecr < en (x t0) (v1 t0) (v2 t0) -> small (en (x t0) (v1 t0) (v2 t0)) ->
  exists k t1 p, (k = 1 \/ k = -1) /\ t0 <= t1 < t0 + PI / om /\ ok m1 m2 p /\ on_ray m1 m2 a2 b k (hh p) x v1 v2 t1 /\
    en (x t0) (v1 t0) (v2 t0) = Ecr * (1 + q * hh p ^ 2).
Proof.
  intros H Ht Ev Hx HE Sm. destruct (level_angle _ HE Sm) as (p & Hp & En).
  destruct (to_ray x v1 v2 s H t0 (hh p) Ht Ev Hx (hh_pos p (ok_pi m1 m2 p Hp)) En) as (k & t1 & Hk & T1 & HR & _).
  exists k, t1, p. auto.
Qed.

(** *** The claim of the paper: from S0, slightly above E_cr, no merging, ... *)

(** [no-merging-from-S0] From $S_0$ slightly above $E_{cr}$ a solution never merges, tends to one critical motion and
    obeys the sharp law. *)
Theorem no_merging_from_S0 x v1 v2 s t0 : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> v1 t0 = v2 t0 ->
  - L <= x t0 <= L ->
  Ecr < en (x t0) (v1 t0) (v2 t0) -> small (en (x t0) (v1 t0) (v2 t0)) ->
  (forall t, 0 <= t -> Ecr < en (x t) (v1 t) (v2 t)) /\
  (exists x0 v0, en x0 v0 v0 = Ecr /\ forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
     en (x t - X m1 m2 a2 x0 v0 t) (v1 t - V m1 m2 a2 x0 v0 t) (v2 t - V m1 m2 a2 x0 v0 t) <= e) /\
  is_lim (fun t => t * (en (x t) (v1 t) (v2 t) - Ecr)) p_infty (Ecr * rate m1 m2 a2).
Proof.
  intros H Ht Ev Hx HE Sm. destruct (start x v1 v2 s t0 H Ht Ev Hx HE Sm) as (k & t1 & p & Hk & T1 & Hp & HR & _).
  assert (T0 : 0 <= t1) by lra.
  pose proof (never_merges m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk T0 Hp HR) as NM.
  split; [exact NM|]. split; [|exact (sharp_from_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk T0 Hp HR)].
  destruct (dichotomy m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H) as [(tm & x0 & v0 & Hm & He & K)|(x0 & v0 & He & _ & K)].
  - specialize (NM tm Hm). destruct (K 0 ltac:(lra)) as (K1 & K2 & K3). rewrite Rplus_0_r in K1, K2, K3. cbv beta in NM.
    rewrite K1, K2, K3, ellipse_energy in NM by auto. lra.
  - exists x0, v0. split; [exact He|exact K].
Qed.

(** *** ... and explicit bounds of 1/w for w = E/E_cr - 1: both slopes tend to the sharp (9 m2/(4 m1)) omega/pi as
  w0 -> 0. *)

(** [two-sided-rate] Explicit bounds of $1/w$ along a solution from $S_0$ with $0<w_0\leqslant\tfrac{4}{9}q$, the
    upper one where $6\sqrt{w_0}<\pi$. *)
Theorem two_sided x v1 v2 s t0 : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> v1 t0 = v2 t0 -> - L <= x t0 <= L ->
  let w t := en (x t) (v1 t) (v2 t) / Ecr - 1 in let w0 := w t0 in let K := 9 / 4 * (m2 / m1) in
  0 < w0 <= 4 / 9 * q -> forall t, t0 <= t ->
  / w0 + K * (1 - 3 / 8 * w0 / q) ^ 12 * (om * (t - t0) / (PI + 6 * sqrt w0) - 2) <= / w t /\
  (6 * sqrt w0 < PI -> / w t <= / w0 + K / (1 - K * w0) * (om * (t - t0) / (PI - 6 * sqrt w0) + 1)).
Proof.
  intros H Ht Ev Hx w w0 K HW t Hu. pose proof PI2_3_2 as P0.
  assert (EW : forall t, en (x t) (v1 t) (v2 t) = Ecr * (1 + w t)) by (intros; unfold w; field; lra).
  assert (HE : Ecr < en (x t0) (v1 t0) (v2 t0)) by (rewrite EW; fold w0; nra).
  assert (Sm : small (en (x t0) (v1 t0) (v2 t0))) by (apply small_simple; rewrite EW; apply Rmult_le_compat_l;
    fold w0; lra).
  destruct (start x v1 v2 s t0 H Ht Ev Hx HE Sm) as (k & t1 & p & Hk & T1 & Hp & HR & EP).
  pose proof (ok_pi m1 m2 p Hp) as Pp. pose proof (hh_pos p Pp) as H0. rewrite EW in EP. fold w0 in EP.
  assert (W0 : w0 = q * hh p ^ 2) by (apply Rmult_eq_reg_l with Ecr; lra).
  assert (Y0 : hh p ^ 2 = w0 / q) by (rewrite W0; field; lra). assert (De : sqrt w0 = sqrt q * hh p).
  { rewrite W0, sqrt_mult_alt, sqrt_pow2 by lra. auto. }
  pose proof (sqrt_pos w0) as S0.
  pose proof (qr_one m1 m2 Hm1 Hm2) as QR. fold M q r in QR. assert (K0 : 0 < K) by positive.
  assert (Kq : 9 / 4 * r = q * K) by (unfold K, q, r, M; field; lra).
  assert (Wq : w0 / q <= 4 / 9) by (undivide q; lra).
  assert (KW : K * w0 < 1) by (rewrite W0, <- Rmult_assoc, (Rmult_comm K), <- Kq, Y0; nra).
  set (sg := 1 - 3 / 8 * w0 / q). set (c := K * sg ^ 12). set (A := K / (1 - K * w0)).
  set (T := PI + 6 * sqrt w0). set (T' := PI - 6 * sqrt w0).
  (* the first excursion *)
  assert (Hh : hh p <= 2 / 3) by nra. destruct (ok_push m1 m2 Hm1 Hm2 p Pp Hh) as (_ & C1 & Dp).
  pose proof (hh_below p Pp). pose proof (back p (proj1 Hp)).
  pose proof (depth_pos p Pp) as C0. pose proof (depth_upper p Pp) as C2. pose proof (depth_lower p Pp) as C3.
  rewrite Y0 in C2, C3. set (c0 := depth p) in *. assert (Sq : 0 < sqrt q) by positive.
  assert (Sg : 0 <= sg <= sin p / p).
  { assert (Es : sg = 1 - 3 / 8 * hh p ^ 2) by (rewrite Y0; unfold sg; field; lra). split; [rewrite Es, Y0; lra|].
    pose proof (sin_above p ltac:(lra)) as Sa. assert (p ^ 2 <= (3 / 2 * hh p) ^ 2) by (apply pow_incr; lra).
    undivide p.
    apply Rle_trans with (p - p ^ 3 / 6); auto. replace (p - p ^ 3 / 6) with ((1 - p ^ 2 / 6) * p) by field. scale. }
  assert (C : 0 <= c) by (apply Rmult_le_pos; [lra|apply pow_le; lra]).
  assert (A0 : 0 < A) by (apply Rdiv_lt_0_compat; lra).
  (* w falls, from w0 at the first exit *)
  pose proof (never_merges m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk ltac:(lra) Hp HR t ltac:(lra)) as N.
  pose proof (E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t0 t ltac:(lra)) as F. cbv beta in N, F.
  fold en Ecr in N, F. rewrite EW in N, F. rewrite EW in F. fold w0 in F.
  assert (Wt : 0 < w t) by (apply Rmult_lt_reg_l with Ecr; lra).
  assert (Wd : w t <= w0) by (apply Rmult_le_reg_l with Ecr; lra).
  assert (Id : / w0 <= / w t) by (apply Rinv_le_contravar; auto).
  assert (ToT : om * (t1 - t0) <= PI) by (replace PI with (om * (PI / om)) by (field; lra); scale; lra).
  set (a := r * c0 ^ 2 / (w0 / q) ^ 2). set (B := 9 / 4 * r / (1 - r * c0 ^ 2 / (w0 / q))).
  set (Tu := PI + sqrt q * (2 * p)). set (Tl := PI - sqrt q * (2 * p - hh p) * (q * c0 / (1 - q * c0))).
  assert (Ray : t1 <= t -> q / w0 + a * (om * (t - t1) / Tu - 1) <= q / w t <= q / w0 + B * (om * (t - t1) /
    Tl + 1)).
  { intros G. unfold a, B. rewrite <- (Rinv_div w0 q), <- (Rinv_div (w t) q), <- Y0.
    exact (level_between m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk ltac:(lra) Pp Hh HR t G). }
  split.
  - set (n0 := om * (t - t0) / T - 2). assert (N0 : n0 * T = om * (t - t0) - 2 * T) by (unfold n0, T; field; lra).
    destruct (Rle_dec n0 0) as [Np|Np]; [assert (0 <= c * - n0) by positive; lra|].
    assert (0 < n0 * T) by (apply Rmult_lt_0_compat; unfold T; lra).
    destruct Ray as (Lo & _); [apply Rmult_le_reg_l with om; auto; unfold T in *; lra|].
    assert (N1 : n0 + 1 <= om * (t - t1) / Tu).
    { assert (0 < Tu) by (unfold Tu; positive). undivide Tu.
      apply Rle_trans with ((n0 + 1) * T); [|unfold T in *; lra].
      apply Rmult_le_compat_l; [lra|]. unfold T, Tu. rewrite De.
      assert (sqrt q * (2 * p) <= sqrt q * (6 * hh p)) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Ka : q * c <= a).
    { unfold a. undivide ((w0 / q) ^ 2).
      replace (q * c * (w0 / q) ^ 2) with (r * (3 / 2 * sg ^ 6 * (w0 / q)) ^ 2).
      - assert (0 <= sg ^ 6 <= (sin p / p) ^ 6) by (split; [apply pow_le|apply pow_incr]; lra).
        assert (0 < w0 / q) by positive. scale. apply pow_incr. split; [positive|].
        apply Rle_trans with (2 := C3). apply Rmult_le_compat_r; lra.
      - transitivity (9 / 4 * r * sg ^ 12 * (w0 / q) ^ 2); [field; lra|rewrite Kq; unfold c; ring]. }
    assert (q * c * n0 <= a * (om * (t - t1) / Tu - 1)) by (apply Rmult_le_compat; try lra; positive).
    apply Rmult_le_reg_l with q; [auto|lra].
  - intros Hd. assert (T0 : 0 < T') by (unfold T'; lra). assert (0 <= om * (t - t0)) by positive.
    destruct (Rle_dec t1 t) as [G|G].
    + destruct (Ray G) as (_ & Up). assert (Ka : 0 <= B <= q * A).
      { assert (r * c0 ^ 2 / (w0 / q) <= K * w0).
        { undivide (w0 / q). replace (K * w0 * (w0 / q)) with (9 / 4 * r * (w0 / q) ^ 2) by (rewrite Kq;
            field; lra).
          replace (9 / 4 * r * (w0 / q) ^ 2) with (r * (3 / 2 * (w0 / q)) ^ 2) by (field; lra). scale.
          apply pow_incr. lra. }
        unfold A, B. rewrite Kq. split; [apply Rdiv_le_0_compat; [positive|lra]|]. unfold Rdiv.
        rewrite <- Rmult_assoc.
        apply Rmult_le_compat_l; [positive|]. apply Rinv_le_contravar; lra. }
      assert (TT : T' <= Tl).
      { assert (0 < q * c0 <= 1 * c0) by (split; [positive|apply Rmult_le_compat_r; lra]). unfold Tl, T'.
        rewrite De.
        assert (sqrt q * (2 * p - hh p) * (q * c0 / (1 - q * c0)) <= sqrt q * (2 * hh p) * 2); [|lra].
        apply Rmult_le_compat; [apply Rmult_le_pos; lra|apply Rdiv_le_0_compat; lra|scale|undivide (1 - q *
          c0); lra]. }
      assert (0 <= om * (t - t1) / Tl <= om * (t - t0) / T').
      { split; [apply Rdiv_le_0_compat; [positive|lra]|].
        apply Rmult_le_compat; [positive|apply Rlt_le, Rinv_0_lt_compat; lra|scale; lra|apply
          Rinv_le_contravar; auto]. }
      assert (B * (om * (t - t1) / Tl + 1) <= q * A * (om * (t - t0) / T' + 1)) by (apply Rmult_le_compat;
        lra).
      apply Rmult_le_reg_l with q; [auto|lra].
    + (* on the first ellipse *)
      pose proof (E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t t1 ltac:(lra)) as F'. cbv beta in F'.
      fold en in F'.
      rewrite (ray_energy m1 m2 a2 b Hm1 Hm2 Ha2 k (hh p) x v1 v2 t1 Hk HR : en _ _ _ = Ecr * (1 + q * hh p ^
        2)), EW in F'.
      assert (W1 : w0 <= w t) by (apply Rmult_le_reg_l with Ecr; lra).
      assert (/ w t <= / w0) by (apply Rinv_le_contravar; lra).
      assert (0 <= A * (om * (t - t0) / T' + 1)) by positive. lra.
Qed.

(** the lower bound, as one over the time: the first cycle is paid by the start *)
Corollary below_over_t x v1 v2 s t0 : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> v1 t0 = v2 t0 -> - L <= x
  t0 <= L ->
  let w t := en (x t) (v1 t) (v2 t) / Ecr - 1 in let w0 := w t0 in let K := 9 / 4 * (m2 / m1) in
  0 < w0 <= 2 / 9 * q -> 0 < 1 - 3 / 8 * w0 / q /\ sqrt w0 <= 1 / 2 /\ K * w0 < 1 / 2 /\
  forall t, t0 < t -> 0 < w t <= (PI + 6 * sqrt w0) / (K * (1 - 3 / 8 * w0 / q) ^ 12 * om) / (t - t0).
Proof.
  intros H Ht Ev Hx w w0 K HW. pose proof (qr_one m1 m2 Hm1 Hm2) as QR. fold M q r in QR.
  assert (K0 : 0 < K) by positive. assert (Kq : K * q = 9 / 4 * r) by (unfold K, q, r, M; field; lra).
  assert (KW : K * w0 < 1 / 2) by nra.
  assert (S1 : sqrt w0 <= 1 / 2) by (rewrite <- (sqrt_pow2 (1 / 2)) by lra; apply sqrt_le_1_alt; lra).
  assert (Sg : 0 < 1 - 3 / 8 * w0 / q <= 1).
  { assert (0 < w0 / q) by positive. assert (w0 / q <= 2 / 9) by (undivide q; lra). lra. }
  repeat (split; [lra|]). intros t Hu. assert (HW' : 0 < w0 <= 4 / 9 * q) by lra.
  pose proof (proj1 (two_sided x v1 v2 s t0 H Ht Ev Hx HW' t ltac:(lra)) :
    / w0 + K * (1 - 3 / 8 * w0 / q) ^ 12 * (om * (t - t0) / (PI + 6 * sqrt w0) - 2) <= / w t) as Lo.
  pose proof (sqrt_pos w0). pose proof PI_RGT_0. set (D := PI + 6 * sqrt w0) in *.
  assert (HD : 0 < D) by (unfold D; lra). set (c := K * _ ^ 12) in *.
  assert (C : 0 < c <= K).
  { pose proof (pow_incr _ 1 12 (conj (Rlt_le _ _ (proj1 Sg)) (proj2 Sg))) as S.
    split; [apply Rmult_lt_0_compat; [|apply pow_lt]|unfold c; nra]; lra. }
  assert (St : 2 * c <= / w0) by (apply Rmult_le_reg_r with w0; [lra|]; rewrite Rinv_l by lra; nra).
  assert (0 < t - t0) by lra. assert (Kd : 0 < c * (om * (t - t0) / D)) by positive.
  assert (P : 0 < / w t) by lra. rewrite <- (Rinv_inv (w t)). split; [apply Rinv_0_lt_compat, P|].
  replace (D / (c * om) / (t - t0)) with (/ (c * (om * (t - t0) / D))) by (field; repeat split; lra).
  apply Rinv_le_contravar; lra.
Qed.

(** *** Every solution that never merges comes back to S0 slightly above E_cr *)
(** its energy comes down to E_cr, so it does before a contact; from one beyond S0 it returns *)
Lemma strip x v1 v2 s : solution m1 m2 0 a2 b x v1 v2 s -> (forall t, 0 <= t -> Ecr < en (x t) (v1 t) (v2 t)) ->
  forall e, 0 < e -> exists t, 0 <= t /\ v1 t = v2 t /\ - L <= x t <= L /\ en (x t) (v1 t) (v2 t) <= Ecr + e.
Proof.
  intros H Up e He. destruct (dichotomy_energy m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H) as [(T & HT & N)|(_ & K)].
  { specialize (Up T HT). fold en Ecr in N. lra. }
  destruct (K e He) as (T & HT & KT).
  destruct (contact m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb x v1 v2 s T H HT) as (tc & Htc & Ev).
  destruct (Classical_Prop.classic (- L <= x tc <= L)) as [In|Out].
  { exists tc. split; [lra|]. split; [auto|]. split; [auto|]. apply KT. lra. }
  destruct (beyond_gap m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 tc Ev Out) as (k & d & u & Hk & Hd & HG).
  destruct (returns m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k d u tc Hk ltac:(lra) (or_introl Hd) HG) as (t & F).
  destruct (first_reentry_in _ _ _ _ _ _ F) as (Ht & Ev' & In). exists t.
  split; [lra|]. split; [auto|]. split; [auto|]. apply KT. lra.
Qed.

(** [sharp-law] $t\,(E-E_{cr})\to E_{cr}\tfrac{4\pi}{9}\tfrac{m_1}{m_2}\sqrt{M/a_2}$ for every solution that never
    merges. *)
Theorem sharp_law x v1 v2 s : solution m1 m2 0 a2 b x v1 v2 s -> (forall t, 0 <= t -> Ecr < en (x t) (v1 t) (v2 t)) ->
  is_lim (fun t => t * (en (x t) (v1 t) (v2 t) - Ecr)) p_infty (Ecr * rate m1 m2 a2).
Proof.
  intros H Up. destruct (strip x v1 v2 s H Up (Ecr * (4 / 9 * q))) as (t & Ht & Ev & Hx & HE).
  { positive. }
  apply (no_merging_from_S0 x v1 v2 s t); auto. apply small_simple. lra.
Qed.
End Law.
