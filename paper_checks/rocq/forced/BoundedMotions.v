(** a1 > 0: under a bounded force (Lipschitz impulse) every motion is bounded, so any two of them approach each other,
    and there is at most one periodic motion. *)
From InertialPair Require Import Dini Pair Stick Forced Approach.

Section Bounded.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let forced := forced m1 m2 a1 a2 b.

(** W = a2 x^2/2 + m1 v1^2/2 + c m1 x v1 falls at the rate c/3, up to a constant *)
Section One.
Variables U x v1 v2 s : R -> R.
Variable G : R.
Hypotheses (H : forced U x v1 v2 s) (HG : 0 <= G) (LU : forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)).
Context (c : R) (Hc : 0 < c) (c1 : c * m1 <= a1 / 4) (c2 : c * a1 <= a2 / 2) (c3 : c * (c * m1) <= a2 / 4).
Let W t := a2 / 2 * (x t * x t) + m1 / 2 * (v1 t * v1 t) + c * m1 * (x t * v1 t).
Let g := G + b.

(** the rate of W, the Lyapunov function E of body 1 with a cross term *)
Lemma W_dini t : 0 <= t -> dini_le W t (- a1 * v1 t ^ 2 + c * m1 * v1 t ^ 2 - c * a2 * x t ^ 2 - c * a1 * (x t *
  v1 t) + g * (Rabs (v1 t) + c * Rabs (x t))).
Proof.
  intros Ht. set (P := fun u => m1 * v1 u + b * s u - U u). set (k := fun u => U u - b * s u).
  assert (Lk : forall h, 0 < h -> Rabs (k (t + h) - k t) <= g * h).
  { intros h Hh. pose proof (LU t (t + h) ltac:(lra)) as L1.
    pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H t (t + h) ltac:(lra)) as L2. unfold k, g. by_sizes. }
  assert (Bx : big (fun h => x (t + h) - x t)) by (eapply rderiv_big; rates). set (q := v1 t + c * x t).
  assert (Bv : big (fun h => v1 (t + h) - v1 t)).
  { apply big_ext with (fun h => / m1 * ((P (t + h) - P t) + (k (t + h) - k t))).
    - intros. unfold P, k. field. lra.
    - apply big_scal, big_plus; [eapply rderiv_big; unfold P; rates|]. exists g, 1.
      repeat split; [unfold g; lra|lra|intros; apply Lk; lra]. }
  eassert (DL : rderiv (fun u => (a2 * x t + c * m1 * v1 t) * x u + q * P u) t _) by (unfold P; rates).
  intros e He. destruct (little_plus _ _ DL (little_plus _ _ (little_scal (a2 / 2) _ (big_mult _ _ Bx Bx))
    (little_plus _ _ (little_scal (m1 / 2) _ (big_mult _ _ Bv Bv))
      (little_scal (c * m1) _ (big_mult _ _ Bx Bv)))) e He)
    as (d & Hd & K).
  exists d. split; auto. intros h Hh. specialize (K h Hh). apply Rabs_inv in K.
  assert (Q : q * (k (t + h) - k t) <= (Rabs (v1 t) + c * Rabs (x t)) * (g * h)).
  { eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult.
    apply Rmult_le_compat; try apply Rabs_pos; [|apply Lk; lra]. eapply Rle_trans; [apply Rabs_triang|].
    rewrite Rabs_mult, (Rabs_pos_eq c); lra. }
  unfold W, q, P, k in *. lra.
Qed.

(** W is between a quarter and three quarters of a2 x^2 + m1 v1^2 *)
Lemma W_below t : (a2 * x t ^ 2 + m1 * v1 t ^ 2) / 4 <= W t <= 3 / 4 * (a2 * x t ^ 2 + m1 * v1 t ^ 2).
Proof.
  assert (Cr : forall k, k = 1 \/ k = -1 -> k * (c * m1 * (x t * v1 t)) <= m1 / 4 * v1 t ^ 2 + a2 / 4 * x t ^ 2).
  { intros k Hk. assert (c * (c * m1) * x t ^ 2 <= a2 / 4 * x t ^ 2) by scale.
    pose proof (pow2_ge_0 (v1 t / 2 - k * c * x t)) as S. apply (Rmult_le_compat_l m1) in S; [|lra].
      destruct Hk; subst k; lra. }
  pose proof (Cr 1 ltac:(auto)). pose proof (Cr (-1) ltac:(auto)). unfold W. lra.
Qed.

(** that rate is at most a constant minus c/3 W *)
Lemma W_rate t : - a1 * v1 t ^ 2 + c * m1 * v1 t ^ 2 - c * a2 * x t ^ 2 - c * a1 * (x t * v1 t) + g * (Rabs (v1 t)
  + c * Rabs (x t)) <= g ^ 2 / a1 + c * (g ^ 2 / a2) - c / 3 * W t.
Proof.
  pose proof (W_below t) as (_ & Wu).
  assert (Y : forall m z, 0 < m -> g * Rabs z <= m / 4 * z ^ 2 + g ^ 2 / m).
  { intros m z Hm. rewrite <- (pow2_abs z). pose proof (pow2_ge_0 (Rabs z - 2 * g / m)) as S.
    apply (Rmult_le_compat_l (m / 4)) in S; [|lra].
    replace (g ^ 2 / m) with (m / 4 * (2 * g / m) ^ 2) by (field; lra).
    replace (g * Rabs z) with (m / 4 * (2 * Rabs z * (2 * g / m))) by (field; lra). lra. }
  pose proof (Y a1 (v1 t) Ha1) as S1. pose proof (Y a2 (x t) Ha2) as S2.
  apply (Rmult_le_compat_l c) in S2; [|lra].
  assert (S3 : - (c * a1 * (x t * v1 t)) <= c * (a2 / 2) * x t ^ 2 + a1 / 4 * v1 t ^ 2).
  { pose proof (pow2_ge_0 (v1 t / 2 + c * x t)) as S. apply (Rmult_le_compat_l a1) in S; [|lra].
    assert (c * (c * a1) * x t ^ 2 <= c * (a2 / 2) * x t ^ 2) by (apply Rmult_le_compat_r; [positive|scale]). lra. }
  assert (S4 : c * m1 * v1 t ^ 2 <= a1 / 4 * v1 t ^ 2) by scale. assert (0 <= a1 * v1 t ^ 2) by positive.
    apply (Rmult_le_compat_l (c / 3)) in Wu; [|lra]. lra.
Qed.

(** so W is bounded *)
Lemma W_bounded : exists C, forall t, 0 <= t -> W t <= C.
Proof.
  set (R0 := g ^ 2 / a1 + c * (g ^ 2 / a2)). exists (Rmax (W 0) (3 * R0 / c)). apply barrier; [|apply Rmax_l|].
  - continuous.
  - intros t Ht Hw. eapply dini_weaken; [|exact (W_dini t Ht)]. eapply Rle_trans; [apply W_rate|]. fold R0.
    pose proof (Rmax_r (W 0) (3 * R0 / c)). assert (R0 <= c / 3 * W t); [|lra].
    replace R0 with (c / 3 * (3 * R0 / c)) by (field; lra). scale.
Qed.
End One.

(** [forced-bounded] With $a_1>0$ every motion under a bounded force is bounded. *)
Theorem bounded U x v1 v2 s G : forced U x v1 v2 s -> 0 <= G -> (forall r t, 0 <= r <= t ->
  Rabs (U t - U r) <= G * (t - r)) ->
  exists B, forall t, 0 <= t -> Rabs (x t) <= B /\ Rabs (v1 t) <= B /\ Rabs (v2 t) <= B.
Proof.
  intros H HG LU. set (c := Rmin (Rmin 1 (a1 / (4 * m1))) (Rmin (a2 / (2 * a1)) (a2 / (4 * m1)))).
  assert (Hc : 0 < c) by positive. least c.
  assert (Un : forall y m, 0 < m -> c <= y / m -> c * m <= y) by (intros; apply Rle_div_r; auto).
  pose proof (Un a1 (4 * m1) ltac:(lra) ltac:(lra)). pose proof (Un a2 (2 * a1) ltac:(lra) ltac:(lra)).
  pose proof (Un a2 (4 * m1) ltac:(lra) ltac:(lra)). assert (c3 : c * (c * m1) <= a2 / 4) by nra.
  destruct (W_bounded U x v1 v2 s G H HG LU c Hc ltac:(lra) ltac:(lra) c3) as (C & HC).
  set (B := sqrt (4 * C / a2) + sqrt (4 * C / m1)). assert (0 <= B) by (unfold B; positive).
  assert (Bv : forall t, 0 <= t -> Rabs (x t) <= B /\ Rabs (v1 t) <= B).
  { intros t Ht. pose proof (W_below x v1 c c3 t) as (Q & _). specialize (HC t Ht). cbv beta in Q, HC.
    assert (0 <= a2 * x t ^ 2) by positive. assert (0 <= m1 * v1 t ^ 2) by positive.
    pose proof (root_bound a2 (x t) (4 * C) Ha2 ltac:(lra)). pose proof (sqrt_pos (4 * C / m1)).
    pose proof (root_bound m1 (v1 t) (4 * C) Hm1 ltac:(lra)). pose proof (sqrt_pos (4 * C / a2)).
    unfold B. lra. }
  set (V := Rabs (v2 0) + B + 1). pose proof (Rabs_pos (v2 0)). assert (0 < b / m2) by positive.
  assert (Up : forall k, k = 1 \/ k = -1 -> forall t, 0 <= t -> k * v2 t <= V).
  { intros k Hk. apply (barrier (fun t => k * v2 t)); [continuous| |].
    - pose proof (Rle_abs (k * v2 0)). rewrite Rabs_sign in * by auto. unfold V. lra.
    - intros t Ht Hv. destruct (Bv t Ht) as (_ & Q). apply Rabs_inv in Q. unfold V in Hv.
      pose proof (q_slip m1 m2 a1 a2 b _ U x v1 v2 s H t Ht (- k)) as S.
      eapply rderiv_dini; [|apply rderiv_scal, (forced_v2_rate _ _ _ _ _ Hm2 U x v1 v2 s t (- k) H Ht), S];
        destruct Hk; subst k; lra. }
  exists V. intros t Ht. destruct (Bv t Ht). repeat split; try (unfold V; lra). apply abs_by.
  intros k Hk. apply Up; auto.
Qed.

(** *** Any two motions under the same bounded force approach each other *)

(** [forced-approach] With $a_1>0$ any two motions under one bounded force approach each other. *)
Theorem approach U x v1 v2 s x' v1' v2' s' G : forced U x v1 v2 s -> forced U x' v1' v2' s' ->
  0 <= G -> (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= e.
Proof.
  intros H H' HG LU. destruct (bounded _ _ _ _ _ G H HG LU) as (B & Q).
    destruct (bounded _ _ _ _ _ G H' HG LU) as (B' & Q').
  apply (approach_dampers m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U x v1 v2 s U x' v1' v2' s' (fun _ => 0) G
    (Rmax B B') 0); auto; intros t Ht; pose proof (Rmax_l B B'); pose proof (Rmax_r B B').
  - split; [lra|]. apply rderiv_eq with 0; [ring|apply rderiv_same].
  - destruct (Q t Ht) as (? & ? & ?). lra.
  - destruct (Q' t Ht) as (? & ? & ?). lra.
Qed.

(** so there is at most one motion of a given period *)
Corollary periodic_unique U x v1 v2 s x' v1' v2' s' G P : forced U x v1 v2 s -> forced U x' v1' v2' s' ->
  0 <= G -> (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)) -> 0 < P ->
  (forall t, 0 <= t -> x (t + P) = x t /\ v1 (t + P) = v1 t /\ v2 (t + P) = v2 t) ->
  (forall t, 0 <= t -> x' (t + P) = x' t /\ v1' (t + P) = v1' t /\ v2' (t + P) = v2' t) ->
  forall t, 0 <= t -> x t = x' t /\ v1 t = v1' t /\ v2 t = v2' t.
Proof.
  intros H H' HG LU HP Pe Pe' t Ht. set (D := fun t => energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t)).
  assert (PD : forall n, D (INR n * P + t) = D t).
  { intros n. apply repeats; [lra| |auto]. intros r Hr. unfold D. rewrite (Rplus_comm P).
    destruct (Pe r Hr) as (-> & -> & ->), (Pe' r Hr) as (-> & -> & ->). auto. }
  assert (D0 : D t <= 0).
  { apply le_epsilon. intros e He. rewrite Rplus_0_l.
    destruct (approach _ _ _ _ _ _ _ _ _ G H H' HG LU e He) as (T & HT & Q).
    destruct (one_turn P T HP HT) as (n & u & -> & Hu). rewrite <- (PD (S n)). apply Q. rewrite S_INR. lra. }
  unfold D in D0. apply (energy_zero m1 m2 a2 Hm1 Hm2 Ha2) in D0. lra.
Qed.
End Bounded.
