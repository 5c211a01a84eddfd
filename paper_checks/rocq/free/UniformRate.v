(** What the law E - E_cr ~ 1/t owes to the energy at the start. The upper constant depends on it alone: E - E_cr <=
    c/t, one c for all motions that start below a level and never merge. The lower one does not: of every energy above
    E_cr there are motions that come to S0 within a fixed time as close to E_cr as one likes, and never merge. *)
From InertialPair Require Import Dini Pair Stick Excursion EnergyLimit Cycle SharpRate SharpLaw ReturnToS0 Forced Arcs.

Section Uniform.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (Ecr := Ecr m1 m2 a2 b) (L := L m1 m2 a2 b) (o1 := o1 m1 a2) (be := b / m2)
  (energy := energy m1 m2 a2).

(** A slip that ends at x = b/a2, where body 1 alone would rest, with the speed v: traced back, body 1 swings about
    that place and is never faster than v, while body 2 was faster by beta at each unit of time. *)
Lemma traced_back v T : 0 < v -> 0 <= T -> exists x v1 v2 s, solution m1 m2 0 a2 b x v1 v2 s /\
  x 0 = b / a2 - v / o1 * sin (o1 * T) /\ v1 0 = v * cos (o1 * T) /\ v2 0 = v + be * T /\ x T = b / a2 /\ v1 T = v /\
    v2 T = v.
Proof.
  intros Hv HT. assert (O : 0 < o1) by (apply o1_pos; auto). assert (O2 : m1 * (o1 * o1) = a2).
  { unfold o1, Cycle.o1. rewrite sqrt_sqrt by positive. field; lra. }
  assert (A : forced_arc m1 m2 0 a2 b T (fun _ => 0) (fun t => b / a2 + v / o1 * sin (o1 * (t - T))) (fun t => v * cos
    (o1 * (t - T))) (fun t => v - be * (t - T)) (fun _ => -1)).
  { constructor.
    - intros t. auto_derive; auto. unfold Rminus. field; lra.
    - intros t. auto_derive; auto. rewrite <- O2. unfold Rminus. field; lra.
    - intros t. auto_derive; auto. unfold be. field; lra.
    - intros t Ht. split; [lra|]. split; [|auto]. intros W. exfalso. pose proof (COS_bound (o1 * (t - T))) as C.
      assert (v * cos (o1 * (t - T)) <= v * 1) by nra. assert (0 < be * (T - t)) by positive. lra. }
  destruct (arc_begins m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb (fun _ => 0) _ _ _ _ _ T HT (cont_const 0)
    (fun t _ => rderiv_const 0 t) A) as (x & v1 & v2 & s & H & E).
  exists x, v1, v2, s. split; [apply free_case; auto|]. destruct (E 0 ltac:(lra)) as (-> & -> & ->).
  destruct (E T ltac:(lra)) as (-> & -> & ->). replace (T - T) with 0 by ring. rewrite Rmult_0_r, sin_0, cos_0.
  replace (o1 * (0 - T)) with (- (o1 * T)) by ring. rewrite sin_neg, cos_neg. repeat split; try ring.
Qed.

(** [no-uniform-lower-rate] From every energy above $E_{cr}$ some solutions never merge and are arbitrarily close to
    $E_{cr}$ from the time $\sqrt{2E(0)m_2}/b$ on. *)
Theorem no_lower_constant E0 e : Ecr < E0 -> 0 < e -> exists x v1 v2 s, solution m1 m2 0 a2 b x v1 v2 s /\
  energy (x 0) (v1 0) (v2 0) = E0 /\ (forall t, 0 <= t -> Ecr < energy (x t) (v1 t) (v2 t)) /\
  forall t, sqrt (2 * E0 * m2) / b <= t -> energy (x t) (v1 t) (v2 t) <= Ecr * (1 + e).
Proof.
  intros HE He. assert (O : 0 < o1) by (apply o1_pos; auto). assert (Ep : 0 < Ecr) by (apply Ecr_pos; auto).
  set (q := m1 / (m1 + m2)). assert (Q : 0 < q) by positive. set (d := Rmin (Rmin e (4 / 9 * q)) (E0 / Ecr - 1)).
  assert (Hd : 0 < d /\ d <= e /\ d <= 4 / 9 * q /\ Ecr * (1 + d) <= E0).
  { assert (K : 0 < E0 / Ecr - 1) by (apply Rlt_Rminus; undivide Ecr; lra).
    min_bounds (Rmin (Rmin e (4 / 9 * q)) (E0 / Ecr - 1)). unfold d. split; [positive|].
    repeat split; try lra.
    apply Rle_trans with (Ecr * (1 + (E0 / Ecr - 1))); [scale; lra|right; field; lra]. }
  assert (EL : Ecr = a2 * L ^ 2 / 2) by (apply Ecr_L; auto). assert (HL : 0 < b / a2 <= L).
  { split; [positive|]. undivide (a2 * m2). replace (b / a2 * (a2 * m2)) with (b * m2) by (field; lra). nra. }
  set (v := sqrt ((2 * (Ecr * (1 + d)) - a2 * (b / a2) ^ 2) / (m1 + m2))).
  assert (Vp : 0 < (2 * (Ecr * (1 + d)) - a2 * (b / a2) ^ 2) / (m1 + m2)).
  { apply Rdiv_lt_0_compat; [|lra]. assert ((b / a2) ^ 2 <= L ^ 2) by nra.
    assert (a2 * (b / a2) ^ 2 <= a2 * L ^ 2) by (apply Rmult_le_compat_l; lra). assert (0 < Ecr * d) by positive. lra. }
  assert (Hv : 0 < v) by positive.
  assert (V2 : v * v = (2 * (Ecr * (1 + d)) - a2 * (b / a2) ^ 2) / (m1 + m2)) by (apply sqrt_sqrt; lra).
  assert (Ec : energy (b / a2) v v = Ecr * (1 + d)).
  { unfold energy, Pair.energy. replace (a2 * (b / a2) ^ 2 / 2 + m1 * v ^ 2 / 2 + m2 * v ^ 2 / 2)
      with (a2 * (b / a2) ^ 2 / 2 + (m1 + m2) / 2 * (v * v)) by (field; lra). rewrite V2. field. lra. }
  set (Tm := sqrt (2 * E0 * m2) / b). assert (HTm : 0 < Tm) by positive.
  set (f := fun T => energy (b / a2 - v / o1 * sin (o1 * T)) (v * cos (o1 * T)) (v + be * T) - E0).
  destruct (cont_IVT f 0 Tm) as (T & HT & FT).
  { apply cont_of_derive with (fun T => a2 * (b / a2 - v / o1 * sin (o1 * T)) * (- v * cos (o1 * T))
      - m1 * (v * cos (o1 * T)) * (v * o1 * sin (o1 * T)) + m2 * (v + be * T) * be). intros t. unfold f, energy,
        Pair.energy.
    auto_derive; auto. field; lra. }
  { lra. }
  { assert (F0 : f 0 <= 0).
    { unfold f. rewrite !Rmult_0_r, sin_0, cos_0, Rmult_0_r, Rmult_1_r, Rminus_0_r, Rplus_0_r. lra. }
    assert (F1 : 0 <= f Tm).
    { unfold f, energy, Pair.energy. assert (B : be * Tm = sqrt (2 * E0 * m2) / m2) by (unfold be, Tm; field; lra).
      assert (S2 : sqrt (2 * E0 * m2) * sqrt (2 * E0 * m2) = 2 * E0 * m2) by (apply sqrt_sqrt; nra).
      assert (B2 : m2 * (be * Tm) ^ 2 / 2 = E0).
      { rewrite B. replace (m2 * (sqrt (2 * E0 * m2) / m2) ^ 2 / 2) with (sqrt (2 * E0 * m2) * sqrt (2 * E0 * m2) / (2
        * m2)) by (field; lra). rewrite S2. field; lra. }
      assert (0 < be * Tm) by positive. assert ((be * Tm) ^ 2 <= (v + be * Tm) ^ 2) by (apply pow_incr; lra).
      assert (m2 * (be * Tm) ^ 2 <= m2 * (v + be * Tm) ^ 2) by scale.
      assert (0 <= a2 * (b / a2 - v / o1 * sin (o1 * Tm)) ^ 2) by positive.
      assert (0 <= m1 * (v * cos (o1 * Tm)) ^ 2) by positive. lra. }
    nra. }
  destruct (traced_back v T Hv ltac:(lra)) as (x & v1 & v2 & s & H & X0 & V10 & V20 & XT & V1T & V2T).
  exists x, v1, v2, s. split; [auto|]. split; [rewrite X0, V10, V20; unfold f in FT; lra|].
  assert (ET : energy (x T) (v1 T) (v2 T) = Ecr * (1 + d)) by (rewrite XT, V1T, V2T; auto).
  destruct (no_merging_from_S0 m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s T H) as (NM & _); try lra.
  { fold L. lra. } { fold energy Ecr. nra. }
  { apply small_simple; auto. fold energy Ecr q. rewrite ET. scale. }
  split; [exact NM|]. intros t Ht.
  pose proof (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H T t ltac:(lra)) as M.
  change (energy (x t) (v1 t) (v2 t) <= energy (x T) (v1 T) (v2 T)) in M. rewrite ET in M. eapply Rle_trans;
    [exact M|]. scale.
Qed.

(** *** The upper constant *)
(** [settling-time] For each level above $E_{cr}$ there is one time after which every solution that starts below
    another level is below it. *)
Theorem settles e l : Ecr < l -> exists T, 0 <= T /\ forall x v1 v2 s, solution m1 m2 0 a2 b x v1 v2 s ->
  energy (x 0) (v1 0) (v2 0) <= e -> energy (x T) (v1 T) (v2 T) <= l.
Proof.
  intros Hl. pose proof (toll_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb l Hl) as D. set (d := toll m1 m2 a2 b l) in *.
  pose proof (spell_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb e l Hl) as W0. set (W := spell m1 m2 a2 b e l) in *.
  destruct (nat_above e d D) as (n & Hn). exists (INR n * W).
  split; [apply Rmult_le_pos; [apply pos_INR|auto]|].
  intros x v1 v2 s H HE. set (E := fun t => energy (x t) (v1 t) (v2 t)). change (E 0 <= e) in HE.
  assert (Mono : forall r t, 0 <= r <= t -> E t <= E r)
    by exact (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H).
  assert (Step : forall k, E (INR k * W) <= l \/ E (INR k * W) <= e - INR k * d).
  { induction k as [|k IH]; [right; simpl; rewrite !Rmult_0_l; lra|]. pose proof (pos_INR k). rewrite S_INR.
    assert (0 <= INR k * W) by positive. replace ((INR k + 1) * W) with (INR k * W + W) by ring.
    destruct (Rle_dec l (E (INR k * W + W))) as [Hi|Lo]; [right|left; lra].
    pose proof (Mono 0 (INR k * W) ltac:(lra)).
    pose proof (toll_paid m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H e l (INR k * W) Hl ltac:(lra) ltac:(change (E
      (INR k * W)
      <= e); lra) Hi : E (INR k * W + W) <= E (INR k * W) - d) as Q. lra. }
  pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x (INR n * W)) (v1 (INR n * W)) (v2 (INR n * W)) : 0 <= E (INR
    n * W)).
  destruct (Step n); [auto|lra].
Qed.

(** and by another one it has been on S0 below l *)
Theorem enters e l : 0 < e -> Ecr < l -> exists T, 0 <= T /\ forall x v1 v2 s, solution m1 m2 0 a2 b x v1 v2 s ->
  energy (x 0) (v1 0) (v2 0) <= e -> exists t, 0 <= t <= T /\ v1 t = v2 t /\ - L <= x t <= L /\ energy (x t) (v1 t)
    (v2 t) <= l.
Proof.
  intros He Hl. destruct (settles e l Hl) as (T & HT & Set_).
  pose proof (least_cost_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb e He) as C. set (c := least_cost m1 m2 a2 b e) in *.
  destruct (nat_above e c C) as (n & Hn).
  assert (O : 0 < o1) by (apply o1_pos; auto). pose proof PI_RGT_0 as P0. pose proof (pos_INR n) as N0.
  assert (R0 : 0 <= INR n * (2 * PI / o1)) by positive.
  assert (D0 : 0 <= 2 * sqrt (2 * e * m2) / b) by positive.
  exists (T + 2 * sqrt (2 * e * m2) / b + INR n * (2 * PI / o1)). split; [lra|]. intros x v1 v2 s H HE.
  set (E := fun t => energy (x t) (v1 t) (v2 t)). change (E 0 <= e) in HE.
  assert (Mono : forall r t, 0 <= r <= t -> E t <= E r)
    by exact (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H).
  pose proof (Set_ x v1 v2 s H HE) as ET. change (E T <= l) in ET.
  destruct (contact m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb x v1 v2 s T H HT) as (tc & Htc & Ev).
  change (Pair.energy m1 m2 a2 (x T) (v1 T) (v2 T)) with (E T) in Htc.
  assert (Htc' : tc <= T + 2 * sqrt (2 * e * m2) / b).
  { assert (2 * sqrt (2 * E T * m2) / b <= 2 * sqrt (2 * e * m2) / b); [|lra]. pose proof (Mono 0 T ltac:(lra)).
    apply Rmult_le_compat_r; [positive|]. apply Rmult_le_compat_l; [lra|].
      apply sqrt_le_1_alt. nra. }
  pose proof (Mono T tc ltac:(lra)) as Ec. destruct (Classical_Prop.classic (- L <= x tc <= L)) as [In|Out].
  { exists tc. split; [lra|]. split; [auto|]. split; [auto|]. change (E tc <= l). lra. }
  destruct (beyond_gap m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 tc Ev Out) as (k & d & u & Hk & Hd & HG).
  pose proof (Mono 0 tc ltac:(lra)) as E0.
  destruct (returns_paid m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H e n He k d u tc Hk ltac:(lra) (or_introl Hd) HG) as (t
    & F & Soon).
  { change (E tc <= e). lra. } { change (E tc < INR n * c). lra. }
  destruct (first_reentry_in _ _ _ _ _ _ F) as (Ht & Ev' & In). fold o1 in Soon. exists t. split; [lra|]. split;
    [auto|]. split; [exact In|].
  pose proof (Mono tc t ltac:(lra)). change (E t <= l). lra.
Qed.

(** [uniform-upper-rate] $E/E_{cr}-1\leqslant c/t$ with one $c$ for all solutions that start below a level and never
    merge. *)
Theorem uniform_upper e : Ecr < e -> exists c, 0 < c /\ forall x v1 v2 s, solution m1 m2 0 a2 b x v1 v2 s ->
  energy (x 0) (v1 0) (v2 0) <= e -> (forall t, 0 <= t -> Ecr < energy (x t) (v1 t) (v2 t)) ->
  forall t, 0 < t -> energy (x t) (v1 t) (v2 t) / Ecr - 1 <= c / t.
Proof.
  intros He. assert (Ep : 0 < Ecr) by (apply Ecr_pos; auto). set (q := m1 / (m1 + m2)).
  assert (Q : 0 < q) by positive.
  destruct (enters e (Ecr * (1 + 2 / 9 * q)) ltac:(lra) ltac:(nra)) as (T & HT & In).
  set (om := omega m1 m2 a2). assert (Om : 0 < om) by (apply omega_pos; auto). pose proof PI_RGT_0 as P0.
  set (K := 9 / 4 * (m2 / m1)). assert (K0 : 0 < K) by positive.
  set (C := (PI + 3) / (K * (11 / 12) ^ 12 * om)). assert (C0 : 0 < C) by (unfold C; positive).
  assert (Ee : 0 < e / Ecr) by positive. exists (2 * C + e / Ecr * (2 * T + 1)).
  split; [assert (0 < e / Ecr * (2 * T + 1)) by positive; lra|].
  intros x v1 v2 s H HE NM t Ht. set (w := fun t => energy (x t) (v1 t) (v2 t) / Ecr - 1).
  change (w t <= (2 * C + e / Ecr * (2 * T + 1)) / t).
  assert (0 <= e / Ecr * (2 * T + 1)) by (apply Rmult_le_pos; lra). undivide t.
  destruct (Rlt_dec (2 * T + 1) t) as [Late|Early].
  - destruct (In x v1 v2 s H HE) as (t1 & Ht1 & Ev & Hx & El). set (w0 := w t1).
    assert (W0 : 0 < w0 <= 2 / 9 * q).
    { pose proof (NM t1 ltac:(lra)). unfold w0, w. split; [apply Rlt_Rminus; undivide Ecr; lra|].
      cut (energy (x t1) (v1 t1) (v2 t1) / Ecr <= 1 + 2 / 9 * q); [lra|undivide Ecr; lra]. }
    destruct (below_over_t m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t1 H ltac:(lra) Ev Hx W0 : 0 < 1 - 3 / 8 * w0 /
      q /\
      sqrt w0 <= 1 / 2 /\ _ /\ forall t, t1 < t -> 0 < w t <= (PI + 6 * sqrt w0) / (K * (1 - 3 / 8 * w0 / q) ^
        12 * om) /
      (t - t1)) as (Sg & S1 & _ & Be). destruct (Be t ltac:(lra)) as (Wt & Le). apply Rle_div_r in Le; [|lra].
    apply Rle_trans with (2 * (w t * (t - t1))); [nra|].
    apply Rle_trans with (2 * C); [apply Rmult_le_compat_l; [lra|]; apply Rle_trans with (1 := Le)|lra].
    assert (F : (11 / 12) ^ 12 <= (1 - 3 / 8 * w0 / q) ^ 12).
    { apply pow_incr. split; [lra|]. cut (w0 / q <= 2 / 9); [lra|undivide q; lra]. }
    pose proof (sqrt_pos w0). apply Rmult_le_compat; [lra|apply Rlt_le; positive|lra|].
    apply Rinv_le_contravar; [positive|]. apply Rmult_le_compat_r; [lra|scale].
  - pose proof (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H 0 t ltac:(lra)) as M.
    change (energy (x t) (v1 t) (v2 t) <= energy (x 0) (v1 0) (v2 0)) in M. assert (W : w t <= e / Ecr).
    { unfold w. cut (energy (x t) (v1 t) (v2 t) / Ecr <= e / Ecr); [lra|].
      apply Rmult_le_compat_r; [positive|lra]. }
    apply Rle_trans with (e / Ecr * t); [scale|]. assert (e / Ecr * t <= e / Ecr * (2 * T + 1)) by scale. lra.
Qed.
End Uniform.
