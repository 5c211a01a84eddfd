(** a1 > 0: two bounded solutions under the same Lipschitz impulse (bounded force) approach each other in the energy
    norm. Their distance D falls to a limit l. Damping makes dv1 -> 0, then dx -> 0 (else the momentum runs away), so
    dv2 tends to +-c with c^2 = 2 l / m2. If c > 0, the relative velocity of one pair stays c above the other's; each
    time that it crosses 0 both friction forces are at opposite limits for a while, and this costs a fixed part of
    dv2: so it crosses a last time, and then one body 2 is pulled to one side for ever. *)
From InertialPair Require Import Dini PaidRates Pair Stick Pursuit Forced Interface.

(** the last time at which a continuous function is not negative *)
Lemma last_nonneg w r t : cont w -> 0 <= r <= t -> 0 <= w r -> w t < 0 ->
  exists p, r <= p < t /\ 0 <= w p /\ forall u, p < u <= t -> w u < 0.
Proof.
  intros C Hr Wr Wt. assert (Back : cont (fun u => w (Rmax 0 (t - u)))).
  { apply cont_of_continuous. intros u _. apply (continuous_comp (fun u => t - u) (fun u => w (Rmax 0 u))).
    - apply @ex_derive_continuous. auto_derive. auto.
    - apply cont_iff, C. }
  destruct (first_zero _ 0 (t - r) Back) as (c & Hc & Z & Neg);
    rewrite ?Rminus_0_r, ?Rmax_right in * by lra; try lra.
  { replace (t - (t - r)) with r by ring. nra. }
  exists (t - c). split; [lra|]. split; [lra|]. intros u Hu. specialize (Neg (t - u) ltac:(lra)).
  cbv beta in Neg. replace (Rmax 0 (t - (t - u))) with u in Neg by (rewrite Rmax_right; lra). nra.
Qed.

Section Response.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let energy := energy m1 m2 a2.
Let forced := forced m1 m2 a1 a2 b.
Let Ha : 0 <= a1. Proof. lra. Qed.

(** a bounded pair is not pulled to one side for ever *)
Lemma no_pull U x v1 v2 s T B k : forced U x v1 v2 s -> 0 <= T -> (forall t, 0 <= t -> Rabs (v2 t) <= B) ->
  k = 1 \/ k = -1 ->
  ~ (forall t, T <= t -> 0 < k * (v1 t - v2 t)).
Proof.
  intros H HT HB Hk O. pose proof (HB T HT) as B0. pose proof (Rabs_pos (v2 T)).
  assert (Hbm : 0 < m2 / b) by positive. set (t := T + m2 / b * (2 * B + 1)). assert (Ht : T <= t) by (unfold t; nra).
  pose proof (moves_impulse m1 m2 a1 a2 b _ _ _ _ _ _ H T t k ltac:(lra) Hk ltac:(intros; apply O; lra)) as S.
  pose proof (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H T t HT ltac:(lra)) as V. rewrite S in V.
  replace (b / m2 * (k * (t - T))) with (k * (2 * B + 1)) in V by (unfold t; field; lra).
  pose proof (HB t ltac:(lra)) as B1. apply Rabs_inv in B0. apply Rabs_inv in B1. destruct Hk; subst k; lra.
Qed.

(** dv2 cannot stay near c > 0, or near - c *)
Lemma no_gap j U x v1 v2 s U' x' v1' v2' s' c d K B T : forced U x v1 v2 s -> forced U' x' v1' v2' s' ->
  j = 1 \/ j = -1 -> 0 < c -> 0 < K -> 0 <= T -> (forall t, 0 <= t -> Rabs (v2 t) <= B) ->
  (forall t, 0 <= t -> Rabs (v2' t) <= B) ->
  (forall r t, 0 <= r <= t -> Rabs ((v1' t - v2' t) - (v1' r - v2' r)) <= K * (t - r)) ->
  d <= c / 4 -> d < b / m2 * (c / (8 * K)) ->
  (forall t, T <= t -> c - d <= j * (v2 t - v2' t) <= c + d /\ Rabs (v1 t - v1' t) <= c / 4) -> False.
Proof.
  intros H H' Hj Hc HK HT B1 B2 L Hd Hd' G. set (w := fun t => j * (v1 t - v2 t)).
  set (w' := fun t => j * (v1' t - v2' t)). assert (Gap : forall t, T <= t -> w t <= w' t - c / 2).
  { intros t Ht. destruct (G t Ht) as (Q & P). apply Rabs_inv in P. unfold w, w'. destruct Hj; subst j; lra. }
  assert (Cw : cont w') by continuous. assert (NoCross : forall r t, T <= r <= t -> 0 <= w r -> 0 < w' t).
  { intros r t Hr Wr. apply Rnot_le_lt. intros N. pose proof (Gap r ltac:(lra)).
    destruct (first_zero w' r t Cw) as (p & Hp & Z & Pos); [lra|nra|lra|]. set (g := c / (8 * K)) in *.
    assert (Hg : 0 < g) by positive. assert (Eg : K * g = c / 8) by (unfold g; field; lra).
    assert (Near : forall u, r <= u <= p -> w' u <= K * (p - u)).
    { intros u Hu. pose proof (L u p ltac:(lra)) as Q. apply Rabs_inv in Q. unfold w' in *.
      destruct Hj; subst j; lra. }
    assert (Hr' : r < p - g).
    { apply Rnot_le_lt. intros N'. pose proof (Near r ltac:(lra)). assert (K * (p - r) <= K * g) by scale.
      lra. }
    assert (In : forall u, p - g <= u < p -> w u < 0 /\ 0 < w' u).
    { intros u Hu. specialize (Pos u ltac:(lra)). pose proof (Near u ltac:(lra)).
      pose proof (Gap u ltac:(lra)). assert (K * (p - u) <= K * g) by scale. split; [lra|nra]. }
    assert (Hj' : - j = 1 \/ - j = -1) by lra. unfold w, w' in In.
    pose proof (moves_impulse m1 m2 a1 a2 b _ _ _ _ _ _ H (p - g) p (- j) ltac:(lra) Hj' ltac:(intros u Hu;
      destruct (In u Hu); lra)) as S.
    pose proof (moves_impulse m1 m2 a1 a2 b _ _ _ _ _ _ H' (p - g) p j ltac:(lra) Hj ltac:(intros u Hu;
      destruct (In u Hu); lra)) as S'.
    pose proof (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H (p - g) p ltac:(lra) ltac:(lra)) as V.
    pose proof (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H' (p - g) p ltac:(lra) ltac:(lra)) as V'.
    rewrite S in V. rewrite S' in V'.
    destruct (G (p - g) ltac:(lra)) as (Q1 & _), (G p ltac:(lra)) as (Q2 & _). destruct Hj; subst j; lra. }
  destruct (Classical_Prop.classic (exists r, T <= r /\ 0 <= w r)) as [(r & Hr & Wr)|No].
  - apply (no_pull _ _ _ _ _ r B j H' ltac:(lra) B2 Hj). intros t Ht. apply (NoCross r t); auto.
  - apply (no_pull _ _ _ _ _ T B (- j) H HT B1 ltac:(lra)). intros t Ht. apply Rnot_le_lt. intros N. apply No.
    exists t. unfold w. split; lra.
Qed.

(** a bounded motion under a bounded force has a Lipschitz velocity of body 1, and relative velocity *)
Definition speed B G := / m1 * ((a2 + a1) * B + G + b) + / m2 * b.
Lemma lips U x v1 v2 s G B : forced U x v1 v2 s ->
  (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)) ->
  (forall t, 0 <= t -> Rabs (x t) <= B /\ Rabs (v1 t) <= B /\ Rabs (v2 t) <= B) -> forall r t, 0 <= r <= t ->
  Rabs (v1 t - v1 r) <= speed B G * (t - r) /\ Rabs ((v1 t - v2 t) - (v1 r - v2 r)) <= speed B G * (t - r).
Proof.
  intros H LU Bd r t Hr. pose proof (forced_rubs _ _ _ _ b _ _ _ _ _ Hb H) as R.
  assert (Q : forall u, 0 <= u -> Rabs (a2 * x u + a1 * v1 u) <= (a2 + a1) * B /\ b <= b).
  { intros u Hu. destruct (Bd u Hu) as (B1 & B2 & _). split; [|lra]. eapply Rle_trans; [apply Rabs_triang|].
    pose proof (abs_scal a2 _ _ ltac:(lra) B1). pose proof (abs_scal a1 _ _ Ha B2). lra. }
  pose proof (body1_lip m1 m2 a1 a2 Hm1 _ U x v1 v2 _ _ G b R Q LU r t Hr).
  pose proof (only_gentle m1 m2 a1 a2 b Hm2 Hb _ _ _ _ _ r t H Hr) as L. unfold Rdiv in L.
  assert (0 <= / m2 * b * (t - r)) by positive. unfold speed. split; by_sizes.
Qed.

(** *** Two bounded motions under one bounded force; their damper may be larger than a1, by [more] of the time *)
Section Two.
Variables U x v1 v2 s U' x' v1' v2' s' more : R -> R.
Variables G B A : R.
Hypotheses (H : forced U x v1 v2 s) (H' : forced U' x' v1' v2' s') (HG : 0 <= G)
  (More : forall t, 0 <= t -> 0 <= more t <= A /\ rderiv (fun r => U r - U' r) t (- (more t * (v1 t - v1' t))))
  (LU : forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r))
  (LU' : forall r t, 0 <= r <= t -> Rabs (U' t - U' r) <= G * (t - r))
  (Bd : forall t, 0 <= t -> Rabs (x t) <= B /\ Rabs (v1 t) <= B /\ Rabs (v2 t) <= B)
  (Bd' : forall t, 0 <= t -> Rabs (x' t) <= B /\ Rabs (v1' t) <= B /\ Rabs (v2' t) <= B).
Let D t := energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t).
Let y t := x t - x' t.
Let p t := v1 t - v1' t.
Let q t := v2 t - v2' t.
Let K := speed B G.

Let HB : 0 <= B.
Proof. destruct (Bd 0 (Rle_refl 0)) as (Q & _). pose proof (Rabs_pos (x 0)). lra. Qed.
Let HK : 0 < K.
Proof.
  assert (0 <= / m1 * ((a2 + a1) * B + G + b)) by positive. assert (0 < / m2 * b) by positive.
  unfold K, speed. lra.
Qed.

(** the energy distance falls by what the dampers take at least *)
Lemma D_dini t : 0 <= t -> dini_le D t (- (a1 * p t ^ 2)).
Proof.
  intros Ht. destruct (More t Ht) as (Hm & Rm).
  eapply dini_weaken; [|exact (moves_D_dini m1 m2 a1 a2 b Hm1 Hm2 Hb _ _ _ _ _ _ _ _ _ _ H H' t _ Ht Rm)].
  assert (0 <= more t * p t ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). unfold p in *. lra.
Qed.
Let D_cont : cont D. Proof. exact (moves_cD m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ _ _ _ _ H H'). Qed.
Lemma D_mono r t : 0 <= r <= t -> D t <= D r.
Proof.
  intros Hr. apply dini_mono; auto. intros u Hu. eapply dini_weaken; [|exact (D_dini u ltac:(lra))].
  assert (0 <= a1 * p u ^ 2) by positive. lra.
Qed.
Lemma D_pos t : 0 <= D t.
Proof. apply energy_pos; auto. Qed.

Lemma p_lip r t : 0 <= r <= t -> Rabs (p t - p r) <= 2 * K * (t - r).
Proof.
  intros Hr. destruct (lips _ _ _ _ _ G B H LU Bd r t Hr) as (L & _).
  destruct (lips _ _ _ _ _ G B H' LU' Bd' r t Hr) as (L' & _). unfold p, K. by_sizes.
Qed.

(** dv1 -> 0, as D pays for its square *)
Lemma p_to_0 e : 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (p t) <= e.
Proof.
  intros He. assert (Cp : cont (fun t => p t ^ 2)) by continuous.
  destruct (paid_vanishes D a1 (fun t _ => D_pos t) D_mono Ha1 (fun t => p t ^ 2)
    (integral (fun t => p t ^ 2))
    (8 * K * B + 1)) with (e := e ^ 2) as (T & HT & Q); [apply integral_cont, Cp| | | | |positive|].
  - intros t Ht. split; [positive|apply (integral_rderiv _ t Cp Ht)].
  - assert (0 <= 8 * K * B) by positive. lra.
  - intros r t Hr. replace (p t ^ 2 - p r ^ 2) with ((p t + p r) * (p t - p r)) by ring. rewrite Rabs_mult.
    apply Rle_trans with (4 * B * (2 * K * (t - r))); [apply Rmult_le_compat; auto using Rabs_pos, p_lip|lra].
    destruct (Bd r ltac:(lra)) as (_ & B1 & _), (Bd t ltac:(lra)) as (_ & B2 & _).
    destruct (Bd' r ltac:(lra)) as (_ & B3 & _), (Bd' t ltac:(lra)) as (_ & B4 & _). unfold p. by_sizes.
  - intros r t. apply (path_paid D a1 (fun t => p t ^ 2)); auto using D_dini.
  - exists T. split; auto. intros t Ht. apply Rabs_le, sq_le_abs; [lra|apply Q; auto].
Qed.

(** dx -> 0: else the momentum m1 dv1 + m2 dv2 would leave every bound *)
Lemma y_to_0 e : 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (y t) <= e.
Proof.
  intros He. set (CP := (m1 + m2) * (2 * B + 1)). assert (HCP : 0 < CP) by positive.
  set (P := fun u => m1 * p u + m2 * q u).
  set (L := 8 * CP / (a2 * e)). assert (Hae : 0 < a2 * e) by nra. assert (HL : 0 < L) by positive.
  assert (HA : 0 <= A) by (destruct (More 0 ltac:(lra)); lra).
  set (n := a2 * e / (2 * (a2 * L + (a1 + A)))). assert (Hn : 0 < n) by positive.
  assert (En : n * (a2 * L + (a1 + A)) = a2 * e / 2) by (unfold n; field; nra).
  destruct (p_to_0 n Hn) as (T & HT & Small). exists T; split; auto. intros t Ht.
  assert (Cy : cont y) by continuous. assert (CPc : cont P) by continuous.
  assert (RP : forall u, 0 <= u -> rderiv P u (- (a2 * y u + (a1 + more u) * p u))).
  { intros u Hu. apply rderiv_ext with
      (fun r => (m1 * v1 r + m2 * v2 r - U r) - (m1 * v1' r + m2 * v2' r - U' r) + (U r - U' r)).
    { intros; unfold P, p, q. ring. }
    pose proof (momentum _ _ _ _ _ _ _ _ _ _ u H Hu). pose proof (momentum _ _ _ _ _ _ _ _ _ _ u H' Hu).
    destruct (More u Hu) as (_ & Du). rate. unfold y, p. ring. }
  assert (Ry : forall u, 0 <= u -> rderiv y u (p u)).
  { intros u Hu. unfold y. rate. reflexivity. }
  assert (PB : forall u, 0 <= u -> - CP <= P u <= CP).
  { intros u Hu. destruct (Bd u Hu) as (_ & B1 & B2), (Bd' u Hu) as (_ & B1' & B2'). unfold P, p, q, CP.
    by_sizes. }
  apply abs_by. intros k Hk. destruct (Rle_dec (k * y t) e) as [|N]; auto. exfalso.
  assert (Yu : forall u, t <= u <= t + L -> e - n * L <= k * y u).
  { intros u Hu. pose proof (lip_between y p n t u Cy ltac:(lra) ltac:(intros r Hr; split;
      [apply Ry; lra|apply Rabs_inv, Small; lra])) as S.
    assert (n * (u - t) <= n * L) by scale. apply Rabs_inv in S. destruct Hk; subst k; lra. }
  assert (Q : k * P (t + L) - k * P t <= - (a2 * e / 2) * (t + L - t)).
  { apply (dini_slope (fun r => k * P r)); [apply cont_scal; auto|lra|]. intros r Hr.
    eapply rderiv_dini; [|apply rderiv_scal, RP; lra].
    pose proof (Small r ltac:(lra)) as S. apply Rabs_inv in S. specialize (Yu r ltac:(lra)).
    assert (a2 * (e - n * L) <= a2 * (k * y r)) by scale.
    destruct (More r ltac:(lra)) as (Hm & _).
    assert (- ((a1 + A) * n) <= (a1 + more r) * (k * p r)) by (assert (- n <= k * p r) by (destruct Hk; subst k; lra);
      nra).
    lra. }
  replace (- (a2 * e / 2) * (t + L - t)) with (- (4 * CP)) in Q by (unfold L; field; split; lra).
  pose proof (PB t ltac:(lra)). pose proof (PB (t + L) ltac:(lra)). destruct Hk; subst k; lra.
Qed.

(** the distance of two bounded solutions tends to 0 *)
Theorem approach_dampers e : 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
  energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= e.
Proof.
  intros He. destruct (dec_limit D D_mono (fun t _ => D_pos t)) as (l & Hl & Low & Lim).
  destruct (Req_dec l 0) as [L0|L0]. { destruct (Lim e He) as (T & HT & Q). exists T; split; auto. intros t Ht.
    specialize (Q t Ht). unfold D in Q. lra. }
  exfalso. set (c := sqrt (2 * l / m2)). assert (Hq : 0 < 2 * l / m2) by positive. assert (Hc : 0 < c) by positive.
    assert (Ec : m2 * (c * c) = 2 * l) by (unfold c; rewrite sqrt_sqrt by lra; field; lra).
  assert (Hcost : 0 < b / m2 * (c / (8 * K))) by positive. set (d := Rmin (c / 4) (b / m2 * (c / (8 * K)) / 2)).
  assert (d1 : d <= c / 4) by apply Rmin_l. assert (d2 : d <= b / m2 * (c / (8 * K)) / 2) by apply Rmin_r.
  assert (Hd : 0 < d) by positive. assert (Hcd0 : 0 < c * d) by positive.
  assert (Hcc : 0 < c * c) by positive. assert (dc : c * d <= c * c / 4) by nra.
  assert (Hcd : 0 < m2 * (c * d)) by positive. set (g := m2 * (c * d) / 2).
  assert (Ey : 0 < g / a2) by (apply Rdiv_lt_0_compat; unfold g; lra).
    assert (Ep : 0 < g / m1) by (apply Rdiv_lt_0_compat; unfold g; lra).
  destruct (y_to_0 (sqrt (g / a2))) as (T1 & HT1 & Y); [positive|].
  destruct (p_to_0 (sqrt (g / m1))) as (T2 & HT2 & P); [positive|].
  destruct (p_to_0 (c / 4)) as (T3 & HT3 & P'); [lra|]. destruct (Lim g) as (T4 & HT4 & Up); [unfold g; lra|].
  set (T := T1 + T2 + T3 + T4). assert (HT : 0 <= T) by positive.
  assert (Q : forall t, T <= t -> - (c * d) <= (v2 t - v2' t) ^ 2 - c * c <= c * d).
  { intros t Ht. specialize (Y t ltac:(unfold T in *; lra)). specialize (P t ltac:(unfold T in *; lra)).
    specialize (Up t ltac:(unfold T in *; lra)).
    specialize (Low t ltac:(lra)). unfold D, energy, Pair.energy in Up, Low.
    assert (SqB : forall m z, 0 < m -> 0 < g / m -> Rabs z <= sqrt (g / m) -> 0 <= m * z ^ 2 <= g).
    { intros m z Hm Hgm Hz. split; [positive|].
      replace g with (m * (sqrt (g / m) * sqrt (g / m))) by (rewrite sqrt_sqrt by lra; field; lra).
      apply Rmult_le_compat_l; [lra|]. apply Rabs_inv in Hz. nra. }
    pose proof (SqB a2 _ Ha2 Ey Y) as S1. pose proof (SqB m1 _ Hm1 Ep P) as S2. unfold y in S1. unfold p in S2. set (z := (v2 t - v2' t) ^ 2) in *.
    split; apply Rmult_le_reg_l with m2; auto; unfold g in *; lra. }
  assert (Near : forall z, 0 < z -> - (c * d) <= z ^ 2 - c * c <= c * d ->
    c - d <= z <= c + d) by (intros z Hz Hzz; split; [destruct (Rle_dec (c - d) z); auto; exfalso;
    assert (z * z < (c - d) * (c - d)) by nra; nra|destruct (Rle_dec z (c + d)); auto; exfalso;
    assert ((c + d) * (c + d) < z * z) by nra; nra]).
  assert (Cq : cont q) by continuous. assert (NZ : forall t, T <= t -> q t <> 0).
  { intros t Ht E. specialize (Q t Ht). unfold q in E. rewrite E in Q. lra. }
  assert (exists j, (j = 1 \/ j = -1) /\ forall t, T <= t -> 0 < j * q t) as (j & Hj & Sign).
  { pose proof (NZ T ltac:(lra)). exists (if Rlt_dec 0 (q T) then 1 else -1).
    split; [destruct Rlt_dec; auto|]. intros t Ht. apply Rnot_le_lt. intros N.
    destruct (cont_IVT q T t Cq) as (u & Hu & Zu); [lra| |apply (NZ u); lra]. destruct Rlt_dec; nra. }
  apply (no_gap j _ _ _ _ _ _ _ _ _ _ c d K B T H H'); auto; try lra.
  - intros; apply Bd; auto.
  - intros; apply Bd'; auto.
  - intros r t Hr. apply (lips _ _ _ _ _ G B H' LU' Bd' r t Hr).
  - intros t Ht. split; [|apply P'; unfold T in Ht; lra]. specialize (Q t Ht).
    apply Near; [apply Sign; auto|destruct Hj; subst j; lra].
Qed.
End Two.

End Response.

(** what stays within an energy distance of something bounded is bounded *)
Definition reach m1 m2 a2 D := sqrt (2 * D / a2) + sqrt (2 * D / m1) + sqrt (2 * D / m2).
Lemma beside m1 m2 a2 x v1 v2 x' v1' v2' B D : 0 < m1 -> 0 < m2 -> 0 < a2 ->
  energy m1 m2 a2 (x - x') (v1 - v1') (v2 - v2') <= D -> Rabs x' <= B /\ Rabs v1' <= B /\ Rabs v2' <= B ->
  Rabs x <= B + reach m1 m2 a2 D /\ Rabs v1 <= B + reach m1 m2 a2 D /\ Rabs v2 <= B + reach m1 m2 a2 D.
Proof.
  intros Hm1 Hm2 Ha2 Q Bd. apply (energy_within m1 m2 a2 Hm1 Hm2 Ha2) in Q. unfold reach.
  pose proof (sqrt_pos (2 * D / a2)). pose proof (sqrt_pos (2 * D / m1)). pose proof (sqrt_pos (2 * D / m2)).
  assert (Near : forall z z' y, Rabs (z - z') <= y -> Rabs z' <= B -> Rabs z <= B + y) by
    (intros; split_Rabs; lra).
  pose proof (Near x x' _ ltac:(apply Q) ltac:(apply Bd)).
  pose proof (Near v1 v1' _ ltac:(apply Q) ltac:(apply Bd)).
  pose proof (Near v2 v2' _ ltac:(apply Q) ltac:(apply Bd)). lra.
Qed.

(** *** A damper a(t) that is controlled in time *)
Section Controlled.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).

(** the damper is one more force, - a(t) v1, whose impulse V has in it *)
Definition controlled (a u x v1 v2 s : R -> R) := exists V, forced m1 m2 0 a2 b V x v1 v2 s /\
  forall t, 0 <= t -> rderiv V t (u t - a t * v1 t).

(** [controlled-contraction] Under a force and a damper $a_1(t)\geqslant 0$ whose impulses have them as rates from the
    right at every time, two motions never move apart in the energy norm. *)
Theorem controlled_contraction a u x v1 v2 s x' v1' v2' s' r t : (forall q, 0 <= q -> 0 <= a q) ->
  controlled a u x v1 v2 s -> controlled a u x' v1' v2' s' -> 0 <= r <= t ->
  energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= energy m1 m2 a2 (x r - x' r) (v1 r - v1' r) (v2 r - v2' r).
Proof.
  intros Pos (V & H & DV) (V' & H' & DV') Hr.
  apply (dini_mono (fun q => energy m1 m2 a2 (x q - x' q) (v1 q - v1' q) (v2 q - v2' q))); auto.
  { exact (moves_cD m1 m2 0 a2 b Hm2 _ _ _ _ _ _ _ _ _ _ H H'). }
  intros q Hq. eapply dini_weaken; [|exact (moves_D_dini m1 m2 0 a2 b Hm1 Hm2 Hb _ _ _ _ _ _ _ _ _ _ H H' q _ ltac:(lra)
    (rderiv_minus _ _ _ _ _ (DV q ltac:(lra)) (DV' q ltac:(lra))))].
  assert (0 <= a q * (v1 q - v1' q) ^ 2) by (apply Rmult_le_pos; [apply Pos; lra|apply pow2_ge_0]). nra.
Qed.

(** as a motion with the constant damper a1, under a force with the rest of it *)
Lemma controlled_constant a1 V x v1 v2 s : forced m1 m2 0 a2 b V x v1 v2 s ->
  forced m1 m2 a1 a2 b (fun t => V t + a1 * x t) x v1 v2 s.
Proof.
  intros [L P N CU CX CV X Q W]. constructor; auto.
  - continuous.
  - intros t Ht. apply rderiv_ext with (fun r => m1 * v1 r + b * s r - V r - a1 * x r); [intros; ring|].
    rate. ring.
Qed.

(** [controlled-approach] With a damper $a_1(t)$ between two positive bounds and a bounded force every motion tends to
    each that is bounded. *)
Theorem controlled_approach a u x v1 v2 s x' v1' v2' s' a1 A G B : 0 < a1 -> 0 <= G ->
  (forall t, 0 <= t -> a1 <= a t <= A /\ Rabs (u t) <= G) ->
  controlled a u x v1 v2 s -> controlled a u x' v1' v2' s' ->
  (forall t, 0 <= t -> Rabs (x' t) <= B /\ Rabs (v1' t) <= B /\ Rabs (v2' t) <= B) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= e.
Proof.
  intros Ha1 HG Hau C C' Bd'. assert (Pos : forall q, 0 <= q -> 0 <= a q) by (intros q Hq; destruct (Hau q Hq); lra).
  set (D := fun t => energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t)).
  assert (Mono : forall t, 0 <= t -> D t <= D 0) by (intros t Ht; apply (controlled_contraction a u _ _ _ s _ _ _ s'); auto; lra).
  destruct C as (V & H & DV), C' as (V' & H' & DV').
  assert (B0 : 0 <= B) by (destruct (Bd' 0 ltac:(lra)) as (Q & _); pose proof (Rabs_pos (x' 0)); lra).
  set (E := reach m1 m2 a2 (D 0)).
  assert (E0 : 0 <= E) by (unfold E, reach; repeat apply Rplus_le_le_0_compat; apply sqrt_pos).
  assert (Bd : forall t, 0 <= t -> Rabs (x t) <= B + E /\ Rabs (v1 t) <= B + E /\ Rabs (v2 t) <= B + E)
    by (intros t Ht; apply (beside m1 m2 a2 _ _ _ (x' t) (v1' t) (v2' t) B (D 0)); auto; exact (Mono t Ht)).
  assert (A0 : a1 <= A) by (destruct (Hau 0 ltac:(lra)); lra).
  assert (Lip : forall W y w1 w2 z, forced m1 m2 0 a2 b W y w1 w2 z -> (forall t, 0 <= t -> rderiv W t (u t - a t * w1 t)) ->
    (forall t, 0 <= t -> Rabs (w1 t) <= B + E) -> forall r t, 0 <= r <= t ->
    Rabs ((W t + a1 * y t) - (W r + a1 * y r)) <= (G + A * (B + E)) * (t - r)).
  { intros W y w1 w2 z HW DW Bw r t Hr. apply (lip_of_rderiv (fun q => W q + a1 * y q) (fun q => u q - (a q - a1) * w1 q)); auto.
    - continuous.
    - intros q Hq. split.
      + pose proof (DW q Hq). rate. ring.
      + destruct (Hau q Hq) as (Qa & Qu). unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|].
        apply Rplus_le_compat; auto. rewrite Rabs_Ropp, Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
        rewrite Rabs_pos_eq; lra. }
  assert (AB : 0 <= A * (B + E)) by (apply Rmult_le_pos; lra).
  apply (approach_dampers m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ x v1 v2 s _ x' v1' v2' s' (fun t => a t - a1)
    (G + A * (B + E)) (B + E) (A - a1) (controlled_constant a1 _ _ _ _ _ H) (controlled_constant a1 _ _ _ _ _ H')); auto.
  - lra.
  - intros t Ht. destruct (Hau t Ht). split; [lra|].
    pose proof (DV t Ht). pose proof (DV' t Ht). rate. ring.
  - apply (Lip V x v1 v2 s); auto. intros t Ht. apply Bd; auto.
  - apply (Lip V' x' v1' v2' s'); auto. intros t Ht. destruct (Bd' t Ht) as (_ & Q & _). lra.
  - intros t Ht. destruct (Bd' t Ht) as (b1 & b2 & b3). repeat split; lra.
Qed.
End Controlled.
