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
  intros Ht e He. pose proof (f_x _ _ _ _ _ _ _ _ _ _ H t Ht) as X. pose proof (f_v1 _ _ _ _ _ _ _ _ _ _ H t Ht) as V.
    unfold rderiv in X, V.
  match type of X with little ?f => set (ex := f) in * end. match type of V with little ?f => set (ev := f) in * end.
  set (k := fun h => (U (t + h) - U t) - b * (s (t + h) - s t)). assert (Bk : forall h, 0 < h -> Rabs (k h) <= g * h).
  { intros h Hh. pose proof (LU t (t + h) ltac:(lra)) as L1.
    pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H t (t + h) ltac:(lra)) as L2.
    replace (t + h - t) with h in * by ring. apply Rabs_inv in L1. apply Rabs_inv in L2. unfold k, g.
      apply Rabs_le. split; nra. }
  assert (Kb : big k). { exists g, 1. repeat split; try lra; [unfold g; lra|]. intros h Hh. apply Bk; lra. }
  set (dX := fun h => ex h + v1 t * h). set (dV := fun h => / m1 * (ev h + (- (a2 * x t + a1 * v1 t)) * h + k h)).
  assert (BX : big dX). { apply big_plus; [apply little_big; auto|apply big_scal, big_id]. }
  assert (BV : big dV). { apply big_scal, big_plus; auto.
    apply big_plus; [apply little_big; auto|apply big_scal, big_id]. }
  set (rest := fun h => a2 * x t * ex h + c * m1 * v1 t * ex h + (v1 t + c * x t) * ev h + a2 / 2 * (dX h * dX h)
    + m1 / 2 * (dV h * dV h) + c * m1 * (dX h * dV h)).
  assert (LR : little rest).
  { unfold rest. repeat apply little_plus; apply little_scal; auto; apply big_mult; auto. }
  destruct (LR e He) as (d & Hd & K). exists d; split; auto. intros h Hh. specialize (K h Hh).
    apply Rabs_inv in K. specialize (Bk h ltac:(lra)).
  assert (EX : x (t + h) = x t + dX h) by (unfold dX, ex; ring).
  assert (EV : v1 (t + h) = v1 t + dV h) by (unfold dV, ev, k; field; lra).
  assert (ID : W (t + h) - W t = rest h + (- a1 * v1 t ^ 2 + c * m1 * v1 t ^ 2 - c * a2 * x t ^ 2 - c * a1 * (x t
    * v1 t)) * h + (v1 t + c * x t) * k h).
  { unfold W. rewrite EX, EV. unfold rest. unfold dX at 1 2 3 4, dV at 1 2 3 4. unfold dX, dV. field. lra. }
  rewrite ID. assert (Q : (v1 t + c * x t) * k h <= (Rabs (v1 t) + c * Rabs (x t)) * (g * h)).
  { eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; auto.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult, (Rabs_pos_eq c) by lra. lra. }
  lra.
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
  pose proof (pow2_abs (v1 t)) as Av. pose proof (pow2_abs (x t)) as Ax. pose proof (W_below t) as (_ & Wu).
  assert (S1 : g * Rabs (v1 t) <= a1 / 4 * v1 t ^ 2 + g ^ 2 / a1).
  { rewrite <- Av. set (z := Rabs (v1 t)). replace (g ^ 2 / a1) with (a1 / 4 * (2 * g / a1) ^ 2) by (field; lra).
    replace (g * z) with (a1 / 4 * (2 * z * (2 * g / a1))) by (field; lra).
      pose proof (pow2_ge_0 (z - 2 * g / a1)) as S. apply (Rmult_le_compat_l (a1 / 4)) in S; [|lra]. lra. }
  assert (S2 : g * Rabs (x t) <= a2 / 4 * x t ^ 2 + g ^ 2 / a2).
  { rewrite <- Ax. set (z := Rabs (x t)). replace (g ^ 2 / a2) with (a2 / 4 * (2 * g / a2) ^ 2) by (field; lra).
    replace (g * z) with (a2 / 4 * (2 * z * (2 * g / a2))) by (field; lra).
      pose proof (pow2_ge_0 (z - 2 * g / a2)) as S. apply (Rmult_le_compat_l (a2 / 4)) in S; [|lra]. lra. }
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
  assert (Hc : 0 < c) by positive. assert (L1 : c <= 1) by (eapply Rle_trans; [apply Rmin_l|apply Rmin_l]).
  assert (L2 : c <= a1 / (4 * m1)) by (eapply Rle_trans; [apply Rmin_l|apply Rmin_r]).
  assert (L3 : c <= a2 / (2 * a1)) by (eapply Rle_trans; [apply Rmin_r|apply Rmin_l]).
  assert (L4 : c <= a2 / (4 * m1)) by (eapply Rle_trans; [apply Rmin_r|apply Rmin_r]).
  assert (c1 : c * m1 <= a1 / 4). { replace (a1 / 4) with (a1 / (4 * m1) * m1) by (field; lra).
    apply Rmult_le_compat_r; lra. }
  assert (c2 : c * a1 <= a2 / 2). { replace (a2 / 2) with (a2 / (2 * a1) * a1) by (field; lra).
    apply Rmult_le_compat_r; lra. }
  assert (c3 : c * (c * m1) <= a2 / 4). { replace (a2 / 4) with (a2 / (4 * m1) * m1) by (field; lra).
    apply Rle_trans with (1 * (c * m1)); [apply Rmult_le_compat_r; nra|]. rewrite Rmult_1_l.
      apply Rmult_le_compat_r; lra. }
  destruct (W_bounded U x v1 v2 s G H HG LU c Hc c1 c2 c3) as (C & HC).
  assert (Ia : 0 < / a2) by positive. assert (Im : 0 < / m1) by positive.
  assert (E : forall t, 0 <= t -> 0 <= a2 * x t ^ 2 /\ 0 <= m1 * v1 t ^ 2 /\ a2 * x t ^ 2 + m1 * v1 t ^ 2 <= 4 * C).
  { intros t Ht. pose proof (W_below x v1 c c3 t) as (Q & _). specialize (HC t Ht). cbv beta in Q, HC.
    pose proof (pow2_ge_0 (x t)). pose proof (pow2_ge_0 (v1 t)). repeat split; [nra|nra|lra]. }
  assert (C0 : 0 <= C) by (destruct (E 0 ltac:(lra)); lra).
  set (B := 4 * C * (/ a2 + / m1) + 1). assert (HB : 1 <= B) by (unfold B; nra).
  assert (Sq : forall m z, 0 < m -> m * z ^ 2 <= 4 * C -> / m <= / a2 + / m1 -> Rabs z <= B).
  { intros m z Hm Q I. assert (0 < / m) by positive. apply Rabs_le, sq_le_abs; [lra|].
    assert (z ^ 2 <= B); [|nra]. replace (z ^ 2) with (/ m * (m * z ^ 2)) by (field; lra).
    apply Rle_trans with (/ m * (4 * C)); [scale|]. unfold B. nra. }
  assert (Bv : forall t, 0 <= t -> Rabs (x t) <= B /\ Rabs (v1 t) <= B).
  { intros t Ht. destruct (E t Ht) as (E1 & E2 & E3). split; [apply (Sq a2)|apply (Sq m1)]; auto; lra. }
  set (V := Rabs (v2 0) + B + 1). pose proof (Rabs_pos (v2 0)).
    pose proof (moves_cv2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H) as Cv.
  assert (Hk : 0 < b / m2) by positive. assert (Rv : forall t k, 0 <= t -> rderiv s t k -> rderiv v2 t (b / m2 * k))
    by (intros; eapply (forced_v2_rate m1 m2 a1 a2 b); eauto).
  assert (Up : forall t, 0 <= t -> v2 t <= V).
  { apply barrier; auto; [unfold V; pose proof (Rle_abs (v2 0)); lra|]. intros t Ht Hv.
    destruct (Bv t Ht) as (_ & Q). apply Rabs_inv in Q.
    eapply rderiv_dini; [|apply (Rv t (-1)); auto; apply (f_neg _ _ _ _ _ _ _ _ _ _ H); auto; unfold V in Hv;
      lra]. lra. }
  assert (Lo : forall t, 0 <= t -> -1 * v2 t <= V).
  { apply (barrier (fun t => -1 * v2 t)); auto using cont_scal; [unfold V; pose proof (Rle_abs (- v2 0)) as Q;
    rewrite Rabs_Ropp in Q; lra|]. intros t Ht Hv. destruct (Bv t Ht) as (_ & Q). apply Rabs_inv in Q.
    eapply rderiv_dini; [|apply rderiv_scal, (Rv t 1); auto; apply (f_pos _ _ _ _ _ _ _ _ _ _ H); auto;
      unfold V in Hv; lra]. lra. }
  exists V. intros t Ht. destruct (Bv t Ht). repeat split; try (unfold V; lra). specialize (Up t Ht).
    specialize (Lo t Ht). apply Rabs_le; lra.
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
  apply (approach_bounded m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U x v1 v2 s x' v1' v2' s' G (Rmax B B')); auto; intros t Ht;
    pose proof (Rmax_l B B'); pose proof (Rmax_r B B');
      [destruct (Q t Ht) as (? & ? & ?)|destruct (Q' t Ht) as (? & ? & ?)]; repeat split; lra.
Qed.

(** so there is at most one motion of a given period *)
Corollary periodic_unique U x v1 v2 s x' v1' v2' s' G P : forced U x v1 v2 s -> forced U x' v1' v2' s' ->
  0 <= G -> (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)) -> 0 < P ->
  (forall t, 0 <= t -> x (t + P) = x t /\ v1 (t + P) = v1 t /\ v2 (t + P) = v2 t) ->
  (forall t, 0 <= t -> x' (t + P) = x' t /\ v1' (t + P) = v1' t /\ v2' (t + P) = v2' t) ->
  forall t, 0 <= t -> x t = x' t /\ v1 t = v1' t /\ v2 t = v2' t.
Proof.
  intros H H' HG LU HP Pe Pe' t Ht. set (D := fun t => energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t)).
  assert (PD : forall n, D (t + INR n * P) = D t).
  { induction n as [|n IH]; [simpl; rewrite Rmult_0_l, Rplus_0_r; auto|]. rewrite <- IH, S_INR.
    replace (t + (INR n + 1) * P) with (t + INR n * P + P) by ring.
    assert (0 <= t + INR n * P) by (pose proof (pos_INR n); nra).
    destruct (Pe (t + INR n * P)) as (E1 & E2 & E3); auto. destruct (Pe' (t + INR n * P)) as (E1' & E2' & E3'); auto.
    unfold D. rewrite E1, E2, E3, E1', E2', E3'. auto. }
  assert (D0 : D t <= 0).
  { apply le_epsilon. intros e He. rewrite Rplus_0_l.
    destruct (approach _ _ _ _ _ _ _ _ _ G H H' HG LU e He) as (T & HT & Q).
    destruct (nfloor_ex (T / P)) as (n & _ & Hn). { positive. }
    rewrite <- (PD (S n)). apply Q. rewrite S_INR. apply Rmult_lt_compat_r with (r := P) in Hn; auto.
    replace (T / P * P) with T in Hn by (field; lra). lra. }
  unfold D in D0. apply (energy_zero m1 m2 a2 Hm1 Hm2 Ha2) in D0. lra.
Qed.
End Bounded.
