(** Every start on S0 slightly above E_cr, and every solution that never merges: no merging, and the sharp law. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap EnergyLimit Dichotomy FollowArc Cycle ExitOrbit
  SharpRate ReturnToS0.

Section Law.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let q := m1 / M.
Let r := m2 / M.
Let om := omega m1 m2 a2.
Let L := L m1 m2 a2 b.
Let Ecr := Ecr m1 m2 a2 b.
Let en := energy m1 m2 a2.
Let q_pos : 0 < q := q_pos m1 m2 Hm1 Hm2.
Let r_pos : 0 < r := r_pos m1 m2 Hm1 Hm2.
Let om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2.
Let L0 : 0 < L := L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb.
Let E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb.

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
  intros H Ht Ev Hx w w0 K HW t Hu. pose proof PI_RGT_0 as P0.
  assert (EW : en (x t0) (v1 t0) (v2 t0) = Ecr * (1 + w0)) by (unfold w0, w; field; lra).
  assert (HE : Ecr < en (x t0) (v1 t0) (v2 t0)) by nra.
  assert (Sm : small (en (x t0) (v1 t0) (v2 t0))) by (apply small_simple; rewrite EW; apply Rmult_le_compat_l; lra).
  destruct (start x v1 v2 s t0 H Ht Ev Hx HE Sm) as (k & t1 & p & Hk & T1 & Hp & HR & EP).
  pose proof (ok_pi m1 m2 p Hp) as Pp. pose proof (hh_pos p Pp) as H0. assert (W0 : w0 = q * hh p ^ 2) by nra.
  assert (Y0 : hh p ^ 2 = w0 / q) by (rewrite W0; field; lra). assert (De : 6 * sqrt q * hh p = 6 * sqrt w0).
  { rewrite W0, sqrt_mult_alt by lra. rewrite <- Rsqr_pow2, sqrt_Rsqr by lra. ring. }
  pose proof (sqrt_pos w0) as S0.
  (* the constant of the lower bound *)
  set (sg := 1 - 3 / 8 * w0 / q). assert (Wq : w0 / q <= 4 / 9) by nra. assert (Sg : 0 <= sg <= sin p / p).
  { assert (Es : sg = 1 - 3 / 8 * hh p ^ 2) by (rewrite Y0; unfold sg; field; lra). split; [rewrite Es, Y0; lra|].
    pose proof (sin_above p ltac:(lra)) as Sa. pose proof (hh_below p Pp) as Hbl.
    assert (p ^ 2 <= (3 / 2 * hh p) ^ 2) by (apply pow_incr; lra). undivide p.
    apply Rle_trans with (p - p ^ 3 / 6); auto. replace (p - p ^ 3 / 6) with ((1 - p ^ 2 / 6) * p) by field. scale. }
  assert (Sg12 : sg ^ 12 <= (sin p / p) ^ 12) by (apply pow_incr; auto). assert (K0 : 0 < K) by positive.
  assert (Kq : 9 / 4 * r = q * K) by (unfold K, q, r, M; field; lra).
  assert (KY : q * K * (w0 / q) = K * w0) by (field; lra). assert (KW : K * w0 < 1).
  { pose proof (qr_one m1 m2 Hm1 Hm2) as QR. fold M q r in QR. rewrite <- KY, <- Kq. nra. }
  set (c := K * sg ^ 12). assert (C0 : 0 <= c) by (apply Rmult_le_pos; [lra|apply pow_le; lra]).
  set (A := K / (1 - K * w0)). assert (KK : 0 < A) by (apply Rdiv_lt_0_compat; lra).
  pose proof (never_merges m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk ltac:(lra) Hp HR t ltac:(lra)) as N.
  fold en Ecr in N. assert (EWt : en (x t) (v1 t) (v2 t) = Ecr * (1 + w t)) by (unfold w; field; lra).
  assert (Wt : 0 < w t) by (apply Rmult_lt_reg_l with Ecr; lra). assert (Wd : w t <= w0).
  { apply Rmult_le_reg_l with Ecr; auto. pose proof (E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t0 t ltac:(lra)) as F.
    fold en in F. lra. }
  assert (Id : / w0 <= / w t) by (apply Rinv_le_contravar; auto).
  assert (ToT : om * (t1 - t0) <= PI) by (replace PI with (om * (PI / om)) by (field; lra); scale; lra).
  set (T := PI + 6 * sqrt w0). set (T' := PI - 6 * sqrt w0).
  (* from the first exit on *)
  assert (Ray : t1 <= t -> / w0 + K * (sin p / p) ^ 12 * (om * (t - t1) / T - 1) <= / w t /\
    (0 < T' -> / w t <= / w0 + A * (om * (t - t1) / T' + 1))).
  { intros G.
    destruct (two_sided_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk ltac:(lra) Hp HR t G) as (Lo & Up).
    change (orb m1 m2 p 0) with p in Lo, Up. fold om M in Lo, Up. fold q r in Lo, Up. fold Ecr in Lo, Up.
    rewrite De, Kq, Y0 in Lo, Up. rewrite KY in Up. fold T T' in Lo, Up.
    change (energy m1 m2 a2 (x t) (v1 t) (v2 t) / Ecr - 1) with (w t) in Lo, Up.
    replace (/ (w0 / q)) with (q * / w0) in Lo, Up by (field; lra).
    replace (/ (w t / q)) with (q * / w t) in Lo, Up by (field; lra). split; [|intros Hd; specialize (Up ltac:(unfold T'
      in Hd; lra) KW)]; apply Rmult_le_reg_l with q; auto; [|unfold A]; lra. }
  split.
  - set (n0 := om * (t - t0) / T - 2). assert (N0 : n0 * T = om * (t - t0) - 2 * T) by (unfold n0, T; field; lra).
    destruct (Rle_dec n0 0) as [Np|Np]; [assert (0 <= c * - n0) by positive; lra|].
    assert (0 < n0 * T) by (apply Rmult_lt_0_compat; unfold T; lra).
    destruct Ray as (Lo & _); [apply Rmult_le_reg_l with om; auto; unfold T in *; lra|].
    assert (N1 : (om * (t - t1) / T - 1 - n0) * T = T - om * (t1 - t0)) by (unfold n0, T; field; lra).
    set (n1 := om * (t - t1) / T - 1) in *. assert (0 <= n1 - n0) by (unfold T in *; nra).
    assert (c * n0 <= K * (sin p / p) ^ 12 * n1) by (apply Rmult_le_compat; try lra; scale). lra.
  - intros Hd. assert (T0 : 0 < T') by (unfold T'; lra). destruct (Rle_dec t1 t) as [G|G].
    + destruct (Ray G) as (_ & Up). specialize (Up T0).
      assert (om * (t - t1) / T' <= om * (t - t0) / T') by (apply Rmult_le_compat_r; [positive|scale; lra]).
      assert (A * (om * (t - t1) / T' + 1) <= A * (om * (t - t0) / T' + 1)) by (apply Rmult_le_compat_l; lra). lra.
    + (* on the first ellipse *)
      assert (W1 : w0 <= w t).
      { apply Rmult_le_reg_l with Ecr; auto.
        pose proof (E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t t1 ltac:(lra)) as F. fold en in F.
        pose proof (ray_energy m1 m2 a2 b Hm1 Hm2 Ha2 k (hh p) x v1 v2 t1 Hk HR) as RE. fold en M q Ecr in RE. lra. }
      assert (/ w t <= / w0) by (apply Rinv_le_contravar; lra). assert (0 <= om * (t - t0)) by positive.
      assert (0 <= A * (om * (t - t0) / T' + 1)) by positive. lra.
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
