(** A heavy damper on body 1: p = a2 x1 + a1 v1 relaxes to minus friction, so body 1 creeps, friction alone stops body 2,
    and where the two meet the load is within b: they stick permanently. *)
From InertialPair Require Import Dini Pair Stick Forced ModeAtContact LeastTimeTransfer.

(** what falls towards a level at a rate in proportion to its distance *)
Lemma relaxes f c l r t : cont f -> 0 <= r <= t -> 0 <= c -> (forall u, r <= u < t -> dini_le f u (- c * (f u - l))) ->
  f t - l <= exp (- (c * (t - r))) * (f r - l).
Proof.
  intros C Hr Hc D. set (g := fun u => exp (- (c * (u - r))) * (f r - l)). cut (f t + - (l + g t) <= 0); [unfold g; lra|].
  assert (Dg : forall u, is_derive (fun u => - (l + g u)) u (c * g u)).
  { intros u. unfold g. auto_derive; auto. unfold Rminus. ring. }
  apply (barrier_until (fun u => f u + - (l + g u)) 0 r t); auto.
  - apply cont_plus; [auto|exact (cont_of_derive _ _ Dg)].
  - unfold g. rewrite Rminus_diag_eq, Rmult_0_r, Ropp_0, exp_0 by auto. lra.
  - intros u Hu Up e He. destruct (dini_plus _ _ _ _ _ (D u Hu) (rderiv_of_derive _ _ _ (Dg u)) e He) as (d & Hd & K).
    exists d. split; auto. intros h Hh. specialize (K h Hh). assert (0 <= c * (f u + - (l + g u))) by positive. nra.
Qed.

(** an exponential falls faster than a power *)
Lemma exp_square y : 0 < y -> exp (- y) <= 4 / y ^ 2.
Proof.
  intros Hy. rewrite exp_Ropp. apply Rmult_le_reg_r with (exp y); [apply exp_pos|].
  rewrite Rinv_l by (pose proof (exp_pos y); lra). pose proof (exp_ineq1_le (y / 2)).
  assert (E : exp y = exp (y / 2) * exp (y / 2)) by (rewrite <- exp_plus; f_equal; field).
  replace 1 with (4 / y ^ 2 * (y ^ 2 / 4)) by (field; lra). apply Rmult_le_compat_l; [positive|nra].
Qed.

Section Heavy.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 a1 a2 b x v1 v2 s).
Let Fo := proj2 (free_case m1 m2 a1 a2 b x v1 v2 s) H.
Let p t := a2 * x t + a1 * v1 t.
Let w t := v1 t - v2 t.
Context (X V : R) (BX : forall t, 0 <= t -> - X <= x t <= X) (BV : forall t, 0 <= t -> - V <= v1 t <= V).

(** under friction of at least - c in a direction, from r to t, p comes down to c *)
Lemma load_relaxes k c r t : k = 1 \/ k = -1 -> 0 <= r <= t -> (forall u, r <= u < t -> dini_le (fun q => - k * s q) u c) ->
  k * p t - (b * c + a2 * V * m1 / a1)
  <= exp (- (a1 / m1 * (t - r))) * (k * p r - (b * c + a2 * V * m1 / a1)).
Proof.
  intros Hk Hr S. pose proof Fo. apply (relaxes (fun u => k * p u)); [continuous|auto|positive|]. intros u Hu.
  eassert (R : rderiv (fun u => k * a2 * x u + k * a1 / m1 * (m1 * v1 u + b * s u - 0)) u _) by rates.
  apply (dini_ext (fun u => a1 * b / m1 * (- k * s u) +
    (k * a2 * x u + k * a1 / m1 * (m1 * v1 u + b * s u - 0)))).
  { intros. unfold p. field. lra. }
  pose proof (dini_scal (a1 * b / m1) _ _ _ ltac:(positive) (S u Hu)) as Q.
  eapply dini_weaken; [|exact (dini_plus _ _ _ _ _ Q R)].
  destruct (BV u ltac:(lra)). assert (a2 * (k * v1 u) <= a2 * V) by (scale; destruct Hk; subst k; lra).
  replace (- (a1 / m1) * (k * p u - (b * c + a2 * V * m1 / a1)))
    with (a1 * b / m1 * c + a2 * V - a1 / m1 * (k * p u)) by (field; lra). unfold p. lra.
Qed.

Let C e := a2 * V * m1 + 4 * m1 ^ 2 / e ^ 2 * (a2 * X + V + b).

(** after a time e, but for the order 1/a1 *)
Lemma load_after e k c r t : 1 <= a1 -> 0 < e -> k = 1 \/ k = -1 -> -1 <= c -> 0 <= r -> r + e <= t ->
  (forall u, r <= u < t -> dini_le (fun q => - k * s q) u c) -> k * p t <= b * c + C e / a1.
Proof.
  intros A1 He Hk Hc Hr Ht S. pose proof (load_relaxes k c r t Hk ltac:(lra) S) as Q. destruct (BX r Hr) as (X1 & X2).
  destruct (BV r Hr) as (V1 & V2). set (g := a2 * V * m1 / a1) in *. assert (G0 : 0 <= g) by (unfold g; positive).
  assert (D : k * p r - (b * c + g) <= a1 * (a2 * X + V + b)).
  { assert (k * p r <= a2 * X + a1 * V) by (unfold p; destruct Hk; subst k; nra).
    assert (b * -1 <= b * c) by scale. assert (0 <= (a1 - 1) * (a2 * X + b)) by positive. lra. }
  assert (E : exp (- (a1 / m1 * (t - r))) <= 4 * m1 ^ 2 / (a1 ^ 2 * e ^ 2)).
  { apply Rle_trans with (exp (- (a1 / m1 * e))).
    - assert (a1 / m1 * e <= a1 / m1 * (t - r)) by (apply Rmult_le_compat_l; [positive|lra]).
      apply exp_mono. lra.
    - eapply Rle_trans; [apply exp_square; positive|]. right. field. lra. }
  assert (Z : 0 <= a1 * (a2 * X + V + b)) by positive. pose proof (exp_pos (- (a1 / m1 * (t - r)))).
  assert (F : exp (- (a1 / m1 * (t - r))) * (k * p r - (b * c + g)) <= 4 * m1 ^ 2 / (a1 ^ 2 * e ^ 2) * (a1 * (a2 * X + V
    + b))).
  { eapply Rle_trans; [apply Rmult_le_compat_l; [lra|exact D]|]. apply Rmult_le_compat_r; auto. }
  replace (C e / a1) with (g + 4 * m1 ^ 2 / (a1 ^ 2 * e ^ 2) * (a1 * (a2 * X + V + b))) by (unfold C, g; field; lra). lra.
Qed.

(** friction is at most b, and b against the slip *)
Lemma friction_dini k u : k = 1 \/ k = -1 -> 0 <= u -> dini_le (fun q => - k * s q) u 1.
Proof.
  intros Hk Hu e He. exists 1. split; [lra|]. intros h Hh.
  pose proof (s_lip _ _ _ _ _ _ _ _ _ H u (u + h) ltac:(lra)) as L. apply Rabs_inv in L. destruct Hk; subst k; nra.
Qed.

(** *** Body 1 is slow from the time e on, and the load within b M/m1 *)
Context (e : R) (A1 : 1 <= a1) (He : 0 < e).

Lemma load_bound t : e <= t -> - (b + C e / a1) <= p t <= b + C e / a1.
Proof.
  intros Ht. pose proof (fun k Hk => load_after e k 1 0 t A1 He Hk ltac:(lra) (Rle_refl 0) ltac:(lra)
    (fun u Hu => friction_dini k u Hk (proj1 Hu))) as Q. pose proof (Q 1 ltac:(auto)). pose proof (Q (-1) ltac:(auto)). lra.
Qed.

Lemma slow t : e <= t -> Rabs (v1 t) <= (a2 * X + b + C e) / a1.
Proof.
  intros Ht. pose proof (load_bound t Ht) as P. destruct (BX t ltac:(lra)) as (X1 & X2).
  destruct (BV t ltac:(lra)). assert (C0 : C e / a1 <= C e).
  { assert (0 <= C e) by (unfold C; positive). undivide a1. nra. }
  apply abs_by. intros k Hk. undivide a1. unfold p in P. destruct Hk; subst k; nra.
Qed.

(** in a slip that lasts p tends to minus friction *)
Lemma creeping k t : k = 1 \/ k = -1 -> 0 <= t - e -> (forall u, t - e <= u < t -> 0 < k * w u) -> Rabs (p t + b * k) <= C e / a1.
Proof.
  intros Hk Ht Sl. apply abs_by. intros j Hj. cut (j * p t <= b * (- j * k) + C e / a1); [lra|].
  apply (load_after e j (- j * k) (t - e) t A1 He Hj); [|lra|lra|].
  - destruct Hj, Hk; subst; lra.
  - intros u Hu. eapply rderiv_dini; [apply Rle_refl|]. apply rderiv_scal.
    apply (q_slip _ _ _ _ _ _ _ _ _ _ _ (solution_moving _ _ _ _ _ _ _ _ _ H)); [lra|exact Hk|exact (Sl u Hu)].
Qed.

(** a contact from then on is the last *)
Lemma sticks_then t1 t : C e / a1 <= b * m1 / m2 -> e <= t1 <= t -> w t1 = 0 -> w t = 0.
Proof.
  intros Sm Ht W. cut (forall k, k = 1 \/ k = -1 -> k * w t <= 0).
  { intros Q. pose proof (Q 1 ltac:(auto)). pose proof (Q (-1) ltac:(auto)). lra. }
  intros k Hk. apply (moves_behind _ _ _ _ _ Hm1 Hm2 _ _ _ _ _ _ H t1 t k); auto;
    [lra|fold (w t1); rewrite W; lra|].
  intros q Hq _. pose proof (load_bound q ltac:(lra)) as P. unfold p in P. exists 0.
  split; [eapply rderiv_dini; [apply Rle_refl|rate; ring]|].
  apply Rle_trans with (m2 * (b + b * m1 / m2)); [|right; field; lra]. scale. destruct Hk; subst k; lra.
Qed.

(** *** When they meet *)
Let D := (a2 * X + b + C e) / a1.

Lemma body2 r t : 0 <= r <= t -> Rabs (v2 t - v2 r) <= b / m2 * (t - r).
Proof.
  intros Hr. rewrite (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H r t) by lra.
  apply abs_scal; [apply Rlt_le; positive|apply (s_lip _ _ _ _ _ _ _ _ _ H); lra].
Qed.

(** by then body 2 has been stopped *)
Lemma meets : exists t1, e <= t1 <= 2 * e + m2 / b * D + m2 * Rabs (v2 0) / b /\ w t1 = 0.
Proof.
  assert (D0 : 0 <= D) by (eapply Rle_trans; [apply Rabs_pos|apply (slow e); lra]).
  assert (B0 : 0 <= m2 / b * D) by positive. assert (V0 : 0 <= m2 * Rabs (v2 0) / b) by positive.
  destruct (Req_dec (w e) 0) as [Z|N]; [exists e; split; [lra|auto]|].
  assert (Cw : cont w) by continuous.
  destruct (contact m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Ha2 Hb x v1 v2 s e H ltac:(lra)) as (q & Hq & Eq).
  destruct (first_zero w e q Cw ltac:(lra)) as (t1 & Ht1 & Z & Sg); auto. { unfold w at 2. rewrite Eq. lra. }
  exists t1. assert (exists k, (k = 1 \/ k = -1) /\ 0 < k * w e) as (k & Hk & Kw).
  { destruct (Rlt_dec 0 (w e)); [exists 1|exists (-1)]; split; auto; lra. }
  assert (Sl : forall u, e <= u < t1 -> 0 < k * w u).
  { intros u Hu. specialize (Sg u Hu). destruct Hk; subst k; nra. }
  pose proof (moves_impulse _ _ _ _ _ _ _ _ _ _ _ H e t1 k ltac:(lra) Hk Sl) as I.
  pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H e t1 ltac:(lra) ltac:(lra)) as W. rewrite I in W.
  pose proof (body2 0 e ltac:(lra)) as B. apply Rabs_inv in B. pose proof (slow t1 ltac:(lra)) as S. apply Rabs_inv in S. fold D in S.
  assert (E1 : v1 t1 = v2 t1) by (unfold w in Z; lra). assert (K1 : k * v2 t1 <= D) by (destruct Hk; subst k; lra).
  assert (Kd : t1 - e = m2 / b * (k * (v2 t1 - v2 e))).
  { rewrite W. destruct Hk; subst k; field; lra. }
  assert (Kv : - (k * v2 e) <= Rabs (v2 0) + b / m2 * e).
  { pose proof (Rle_abs (v2 0)). pose proof (Rle_abs (- v2 0)). rewrite Rabs_Ropp in *. destruct Hk; subst k; lra. }
  assert (m2 / b * (k * (v2 t1 - v2 e)) <= m2 / b * (D + (Rabs (v2 0) + b / m2 * e))) by (apply Rmult_le_compat_l; [positive|lra]).
  replace (m2 / b * (D + (Rabs (v2 0) + b / m2 * e))) with (m2 / b * D + m2 * Rabs (v2 0) / b + e) in * by (field; lra). lra.
Qed.

Lemma not_before T : 0 <= T -> (forall t, T <= t -> v1 t = v2 t) -> m2 * Rabs (v2 0) / b - m2 / b * D - e <= T.
Proof.
  intros HT St. set (t := Rmax T e). assert (T <= t) by apply Rmax_l. assert (e <= t) by apply Rmax_r.
  assert (t <= T + e) by (apply Rmax_lub; lra). pose proof (slow t ltac:(lra)) as S. rewrite (St t ltac:(lra)) in S.
  fold D in S. pose proof (body2 0 t ltac:(lra)) as B. pose proof (Rabs_triang_inv (v2 0) (v2 t)).
  rewrite (Rabs_minus_sym (v2 0)) in *. assert (m2 / b * (Rabs (v2 0) - D) <= t); [|lra].
  apply Rle_trans with (m2 / b * (b / m2 * t)); [|right; field; lra]. apply Rmult_le_compat_l; [positive|lra].
Qed.
End Heavy.

(** [heavy-damping] As $a_1\to\infty$, from a given state: from any time on $|v_1|$ is of the order $1/a_1$; in a slip of
    sign $\sigma$ that lasts any time $a_2x_1+a_1v_1$ tends to $-b\sigma$; and the time after which the pair sticks
    permanently tends to $m_2|v_2(0)|/b$. *)
Theorem heavy_damping m1 m2 a2 b x0 v10 v20 e : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < e ->
  exists A K, 0 < A /\ forall a1 x v1 v2 s, A <= a1 -> solution m1 m2 a1 a2 b x v1 v2 s ->
  x 0 = x0 -> v1 0 = v10 -> v2 0 = v20 ->
  (forall t, e <= t -> Rabs (v1 t) <= K / a1) /\
  (forall k t, k = 1 \/ k = -1 -> 0 <= t - e -> (forall u, t - e <= u < t -> 0 < k * (v1 u - v2 u)) ->
    Rabs (a2 * x t + a1 * v1 t - - b * k) <= e) /\
  (forall t, m2 * Rabs v20 / b + e <= t -> v1 t = v2 t) /\
  (forall T, 0 <= T -> (forall t, T <= t -> v1 t = v2 t) -> m2 * Rabs v20 / b - e <= T).
Proof.
  intros Hm1 Hm2 Ha2 Hb He. set (E0 := energy m1 m2 a2 x0 v10 v20).
  assert (HE : 0 <= E0) by exact (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 _ _ _).
  set (X := 1 + sqrt (2 * E0 / a2)). set (V := 1 + sqrt (2 * E0 / m1)).
  pose proof (sqrt_pos (2 * E0 / a2)) as X1. pose proof (sqrt_pos (2 * E0 / m1)) as V1.
  set (C := fun e => a2 * V * m1 + 4 * m1 ^ 2 / e ^ 2 * (a2 * X + V + b)).
  assert (C0 : forall e, 0 < e -> 0 < C e).
  { intros q Hq. unfold C, X, V. positive. }
  assert (X0 : 0 < a2 * X) by positive. set (K := fun e => a2 * X + b + C e).
  assert (K0 : forall e, 0 < e -> 0 < K e) by (intros q Hq; specialize (C0 q Hq); unfold K; lra). set (q := e / 4).
  assert (Hq : 0 < q) by (unfold q; lra). pose proof (C0 q Hq) as Cq. pose proof (K0 q Hq) as Kq.
  pose proof (C0 e He) as Ce. set (A := 1 + C e / e + C q / (b * m1 / m2) + K q * m2 / (b * q)).
  assert (P1 : 0 < C e / e) by positive. assert (P2 : 0 < C q / (b * m1 / m2)) by positive.
  assert (P3 : 0 < K q * m2 / (b * q)) by positive. exists A, (K e). split; [unfold A; lra|].
  intros a1 x v1 v2 s Large H Sx Sv Sw. unfold A in Large.
  assert (B : forall t, 0 <= t -> - X <= x t <= X /\ - V <= v1 t <= V).
  { intros t Ht. pose proof (energy_decreases m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Hb _ _ _ _ H 0 t ltac:(lra)) as De.
    cbv beta zeta in De. rewrite Sx, Sv, Sw in De. fold E0 in De.
    destruct (energy_within m1 m2 a2 Hm1 Hm2 Ha2 _ _ _ _ De) as (Qx & Qv & _). apply Rabs_inv in Qx, Qv.
    unfold X, V. lra. }
  assert (BX := fun t Ht => proj1 (B t Ht)). assert (BV := fun t Ht => proj2 (B t Ht)).
  assert (Ha1 : 0 < a1) by lra. assert (A1 : 1 <= a1) by lra.
  assert (S1 : C e / a1 <= e) by (undivide a1; replace (C e) with (e * (C e / e)) by (field; lra); apply Rmult_le_compat_l; lra).
  assert (S2 : C q / a1 <= b * m1 / m2).
  { undivide a1. replace (C q) with (b * m1 / m2 * (C q / (b * m1 / m2))) by (field; lra). apply Rmult_le_compat_l; [positive|lra]. }
  assert (S3 : m2 / b * (K q / a1) <= q).
  { replace (m2 / b * (K q / a1)) with (q * (K q * m2 / (b * q)) / a1) by (field; lra). undivide a1. apply Rmult_le_compat_l; lra. }
  split; [|split; [|split]].
  - intros t Ht. exact (slow m1 m2 a1 a2 b Hm1 Ha1 Ha2 Hb x v1 v2 s H X V BX BV e A1 He t Ht).
  - intros k t Hk Ht Sl. replace (a2 * x t + a1 * v1 t - - b * k) with (a2 * x t + a1 * v1 t + b * k) by ring.
    eapply Rle_trans; [|exact S1]. exact (creeping m1 m2 a1 a2 b Hm1 Ha1 Ha2 Hb x v1 v2 s H X V BX BV e A1 He k t Hk Ht Sl).
  - intros t Ht. destruct (meets m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s H X V BX BV q A1 Hq) as (t1 & Ht1 & Z).
    rewrite Sw in Ht1.
    assert (W : v1 t - v2 t = 0); [|lra].
    apply (sticks_then m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s H X V BX BV q A1 Hq t1 t S2); [|exact Z].
    split; [apply Ht1|]. destruct Ht1 as (_ & Up). fold (C q) (K q) in Up. unfold q in *. lra.
  - intros T HT St. pose proof (not_before m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s H X V BX BV q A1 Hq T HT St) as Lo.
    rewrite Sw in Lo. fold (C q) (K q) in Lo. unfold q in *. lra.
Qed.
