(** Captive level and, with a1 > 0, the way to rest: E decays exponentially, and the pair sticks for ever in finite
    time. *)
From InertialPair Require Import Dini PaidRates Pair Stick.

Section Captive.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let Mp : 0 < M. Proof. unfold M; lra. Qed.
(** at or below the captive level, S is met only inside the strip |a2 x + a1 v| <= b M / m2 *)
Definition captive (e : R) := 2 * e * (a2 + a1 ^ 2 / M) <= (b * M / m2) ^ 2.

(** the load at the mean velocity is inside the strip, by Cauchy-Schwarz, on S or not *)
Lemma captive_load x v1 v2 : captive (energy m1 m2 a2 x v1 v2) ->
  - (b * M / m2) <= a2 * x + a1 * ((m1 * v1 + m2 * v2) / M) <= b * M / m2.
Proof.
  intros C. apply sq_le_abs; [positive|]. eapply Rle_trans; [|exact C]. apply Rminus_le_0.
  replace (_ - _) with (a2 / M * (a1 * x - (m1 * v1 + m2 * v2)) ^ 2 + (a2 + a1 ^ 2 / M) * (m1 * m2 / M) * (v1 -
    v2) ^ 2).
  2: { unfold energy, M in *. field. lra. } positive.
Qed.

Section One.
Context (x v1 v2 s : R -> R) (H : solution m1 m2 a1 a2 b x v1 v2 s).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Let w t := v1 t - v2 t.

Let Mo := proj1 (solution_moves _ _ _ _ _ _ _ _ _) H.

Let E_mono r t : 0 <= r <= t -> E t <= E r.
Proof. exact (energy_decreases m1 m2 a1 a2 b Hm1 Hm2 Ha1 Hb _ _ _ _ H r t). Qed.

Let steep : 0 < a2 + a1 ^ 2 / M.
Proof. assert (0 <= a1 ^ 2 / M) by positive. lra. Qed.
(** a lower level is captive too *)
Lemma captive_less e e' : e' <= e -> captive e -> captive e'.
Proof. unfold captive. intros. nra. Qed.

(** [captive-sticks] On $S$ below the captive level the pair sticks permanently. *)
Theorem captive_sticks t0 : 0 <= t0 -> v1 t0 = v2 t0 -> captive (E t0) -> forall t, t0 <= t -> v1 t = v2 t.
Proof.
  intros Ht W C t Hu. cut (Rabs (v1 t - v2 t) <= 0); [intros Q; apply Rabs_inv in Q; lra|]. apply abs_by. intros k Hk.
  apply (moves_behind m1 m2 a1 a2 b Hm1 Hm2 _ _ _ _ _ _ Mo t0 t k); [lra|auto|rewrite W; lra|]. intros q Hq Slip.
  exists 0. split; [apply rderiv_dini with (k * 0); [lra|apply rderiv_scal, rderiv_const]|].
  assert (Cq : captive (E q)) by (apply captive_less with (E t0); auto; apply E_mono; lra).
  pose proof (captive_load _ _ _ Cq) as Q. fold M. set (V := (m1 * v1 q + m2 * v2 q) / M) in *.
  assert (Lk : - k * (a2 * x q + a1 * V) <= b * M / m2) by (destruct Hk; subst k; lra).
  apply (Rmult_le_compat_l m2) in Lk; [|lra]. replace (m2 * (b * M / m2)) with (b * M) in Lk by (field; lra).
  replace (v1 q) with (V + m2 / M * (v1 q - v2 q)) by (unfold V, M; field; lra).
  assert (0 <= m2 * (a1 * (m2 / M) * (k * (v1 q - v2 q)))) by positive. lra.
Qed.

(** [captive-merges] Once its energy is below the captive level, a solution sticks permanently after a bounded time.
    *)
Theorem captive_merges T : 0 <= T -> captive (E T) ->
  exists t0, T <= t0 <= T + 2 * sqrt (2 * E T * m2) / b /\ forall t, t0 <= t -> v1 t = v2 t.
Proof.
  intros HT C. destruct (contact m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s T H HT) as (t0 & Ht & W).
  exists t0; split; auto. apply captive_sticks; auto; [lra|]. apply captive_less with (E T); auto. apply E_mono; lra.
Qed.

End One.
End Captive.

(** ** a1 > 0 *)
Section Viscous.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let Mp : 0 < M. Proof. unfold M; lra. Qed.
Let energy := energy m1 m2 a2.

(** a small enough factor *)
Lemma small_enough p q : 0 <= p -> 0 < q -> exists e, 0 < e /\ forall c, 0 <= c <= e -> c * p <= q.
Proof.
  intros Hp Hq. exists (q / (p + 1)); split; [positive|]. intros c Hc.
  apply Rle_trans with (q / (p + 1) * (p + 1)); [apply Rmult_le_compat; lra|right; field; lra].
Qed.

(** |x P| <= (1/a2 + M) E *)
Lemma cross_bound x v1 v2 : Rabs (x * (m1 * v1 + m2 * v2)) <= (/ a2 + M) * energy x v1 v2.
Proof.
  assert (Ha : 0 < / a2) by positive.
  assert (A : x ^ 2 + (m1 * v1 + m2 * v2) ^ 2 <= 2 * ((/ a2 + M) * energy x v1 v2)).
  { apply Rminus_le_0.
    replace (_ - _) with (/ a2 * (m1 * v1 ^ 2 + m2 * v2 ^ 2) + M * (a2 * x ^ 2) + m1 * m2 * (v1 - v2) ^ 2) by
      (unfold energy, Pair.energy, M; field; lra).
    positive. }
  pose proof (pow2_ge_0 (x + (m1 * v1 + m2 * v2))). pose proof (pow2_ge_0 (x - (m1 * v1 + m2 * v2))). apply Rabs_le.
  nra.
Qed.

(** The strict Lyapunov function E + c x P, for c small on {E <= E0}: its rate is at most -2c/3 times itself. *)
Lemma rate_bound E0 : 0 <= E0 -> exists c, 0 < c /\ c * (/ a2 + M) <= 1 / 2 /\ forall x v1 v2,
  energy x v1 v2 <= E0 ->
  (- b * Rabs (v1 - v2) - a1 * v1 ^ 2) + c * (v1 * (m1 * v1 + m2 * v2) + x * - (a2 * x + a1 * v1))
  <= - (2 * c / 3) * (energy x v1 v2 + c * (x * (m1 * v1 + m2 * v2))).
Proof.
  intros HE. assert (Ha : 0 < / a2) by positive. assert (Sq : 0 <= a1 ^ 2 / (2 * a2)) by positive.
  (* a bound R of the slip, which makes its friction at least quadratic *)
  set (R := 1 + 2 * (2 * E0 / m1) + 2 * (2 * E0 / m2)). assert (R1 : 0 <= 2 * E0 / m1) by positive.
  assert (R2 : 0 <= 2 * E0 / m2) by positive. assert (HR : 1 <= R) by (unfold R; lra).
  destruct (small_enough ((/ a2 + M) + R * (3 / 2 * m2) + (5 / 2 * M + a1 ^ 2 / (2 * a2)))
    (Rmin (1 / 2) (Rmin b a1))) as (c & Hc & K); [positive|positive|]. min_bounds (Rmin (1 / 2) (Rmin b a1)).
  specialize (K c ltac:(lra)). assert (0 < R * (3 / 2 * m2)) by positive. exists c. split; [auto|].
  assert (K1 : c * (/ a2 + M) <= 1 / 2) by nra. assert (K2 : c * (R * (3 / 2 * m2)) <= b) by nra.
  assert (K3 : c * (5 / 2 * M + a1 ^ 2 / (2 * a2)) <= a1) by nra. clear K. split; [auto|]. intros x v1 v2 B.
  assert (En : energy x v1 v2 = a2 * x ^ 2 / 2 + m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2) by reflexivity.
  pose proof (cross_bound x v1 v2) as CB. apply Rabs_inv in CB. set (e := energy x v1 v2) in *.
  assert (Ep : 0 <= e) by (exact (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 x v1 v2)).
  assert (Cross : c * (x * (m1 * v1 + m2 * v2)) <= e / 2) by nra.
  set (r := Rabs (v1 - v2)). assert (R0 : 0 <= r) by apply Rabs_pos.
  assert (Rr : (v1 - v2) ^ 2 = r * r) by (unfold r, Rabs; destruct Rcase_abs; ring).
  assert (Slip : 3 / 2 * (c * m2) * (v1 - v2) ^ 2 <= b * r).
  { assert (V1 : v1 ^ 2 <= 2 * E0 / m1) by (undivide m1; nra).
    assert (V2 : v2 ^ 2 <= 2 * E0 / m2) by (undivide m2; nra).
    assert (r <= R) by (pose proof (pow2_ge_0 (v1 + v2)); unfold R in *; nra). rewrite Rr.
    assert (0 <= c * (3 / 2 * m2) * r) by positive. nra. }
  assert (Young : - (c * (a1 * (x * v1))) <= c * (a2 * x ^ 2 / 2) + c * (a1 ^ 2 / (2 * a2)) * v1 ^ 2).
  { apply Rminus_le_0. replace (_ - _) with (c * (/ (2 * a2) * (a2 * x + a1 * v1) ^ 2)) by (field; lra).
    positive. }
  assert (c * (5 / 2 * M + a1 ^ 2 / (2 * a2)) * v1 ^ 2 <= a1 * v1 ^ 2) by scale.
  assert (2 * c / 3 * (c * (x * (m1 * v1 + m2 * v2))) <= 2 * c / 3 * (e / 2)) by scale.
  assert (0 <= c * m2 * (v1 + (v1 - v2)) ^ 2) by positive.
  assert (0 <= c * m1 * v1 ^ 2) by positive. unfold e, energy, Pair.energy, M in *. lra.
Qed.

(** [viscous-decay] With $a_1>0$: $E(t)\leqslant 3E(0)\,e^{-kt}$, with one $k>0$ for all initial energies below a
    level. *)
Theorem decay E0 : 0 <= E0 -> exists k, 0 < k /\ forall x v1 v2 s, solution m1 m2 a1 a2 b x v1 v2 s ->
  energy (x 0) (v1 0) (v2 0) <= E0 -> forall t, 0 <= t ->
  energy (x t) (v1 t) (v2 t) <= 3 * energy (x 0) (v1 0) (v2 0) * exp (- k * t).
Proof.
  intros HE. destruct (rate_bound E0 HE) as (c & Hc & Small & Rate). set (k := 2 * c / 3).
  exists k; split; [unfold k; lra|]. intros x v1 v2 s H B t Ht.
  set (E := fun t => energy (x t) (v1 t) (v2 t)). set (P := fun t => m1 * v1 t + m2 * v2 t).
  set (L := fun t => E t + c * (x t * P t)). assert (Em : forall u, 0 <= u -> E u <= E0).
  { intros u Hu. eapply Rle_trans; [|exact B].
    apply (energy_decreases m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Hb _ _ _ _ H); lra. }
  assert (PR : forall u, 0 <= u -> rderiv P u (- (a2 * x u + a1 * v1 u))).
  { intros u Hu. apply rderiv_ext with (fun r => (m1 * v1 r + b * s r) + (m2 * v2 0 - b * s 0)).
    { intros r Hr. unfold P. pose proof (s_v2 _ _ _ _ _ _ _ _ _ H r ltac:(lra)). lra. }
    eapply rderiv_eq; [|apply rderiv_plus; [apply (s_v1 _ _ _ _ _ _ _ _ _ H u Hu)|apply rderiv_const]]. ring. }
  assert (CL : cont L).
  { apply cont_plus; [exact (moves_cE m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H)|].
    apply cont_scal, cont_mult; [apply (s_cx _ _ _ _ _ _ _ _ _ H)|].
    apply cont_plus; apply cont_scal; [apply (s_cv _ _ _ _ _ _ _ _ _ H)|exact (moves_cv2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _
      H)]. }
  assert (Q : L t <= exp (- k * t) * L 0).
  { set (L' := fun u => (- b * Rabs (v1 u - v2 u) - a1 * v1 u ^ 2) + c * (v1 u * P u + x u * - (a2 * x u + a1 * v1 u))).
    apply in_proportion; auto. intros u Hu. apply rderiv_dini with (L' u); [exact (Rate _ _ _ (Em u Hu))|].
    apply rderiv_plus; [exact (energy_rate m1 m2 a1 a2 b Hm1 Hm2 _ _ _ _ H u Hu)|].
    apply rderiv_scal, rderiv_mult; [apply (s_x _ _ _ _ _ _ _ _ _ H)|apply PR]; lra. }
  assert (LB : forall u, E u / 2 <= L u <= 3 / 2 * E u).
  { intros u. pose proof (cross_bound (x u) (v1 u) (v2 u)) as CB. apply Rabs_inv in CB. fold (P u) (E u) in CB.
    assert (Ep : 0 <= E u) by (exact (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 _ _ _)).
    assert (D : c * ((/ a2 + M) * E u) <= E u / 2) by nra. unfold L. split; nra. }
  pose proof (LB t). pose proof (LB 0). pose proof (exp_pos (- k * t)). change (E t <= 3 * E 0 * exp (- k * t)). nra.
Qed.

(** [viscous-rest] With $a_1>0$: one time after which every solution that starts below a level sticks permanently. *)
Theorem rest E0 e : 0 <= E0 -> 0 < e -> exists T, 0 <= T /\ forall x v1 v2 s, solution m1 m2 a1 a2 b x v1 v2 s ->
  energy (x 0) (v1 0) (v2 0) <= E0 -> forall t, T <= t -> energy (x t) (v1 t) (v2 t) <= e /\ v1 t = v2 t.
Proof.
  intros HE He. destruct (decay E0 HE) as (k & Hk & D). assert (Sp : 0 <= a1 ^ 2 / M) by positive.
  assert (Tp : 0 < b * M / m2) by positive.
  destruct (small_enough (2 * (a2 + a1 ^ 2 / M)) ((b * M / m2) ^ 2)) as (l & Hl & Cl); [lra|nra|].
  set (d := Rmin e l). assert (Hd : 0 < d) by positive.
  assert (de : d <= e) by apply Rmin_l. assert (dl : d <= l) by apply Rmin_r.
  set (T0 := 3 * E0 / d / k). assert (HT0 : 0 <= T0).
  { unfold T0. repeat (apply Rmult_le_pos; [|positive]). lra. }
  set (T := T0 + 2 * sqrt (2 * d * m2) / b). assert (HS : 0 <= 2 * sqrt (2 * d * m2) / b) by positive.
  exists T; split; [unfold T; lra|]. intros x v1 v2 s H B t Ht. assert (HE0 : energy (x T0) (v1 T0) (v2 T0) <= d).
  { eapply Rle_trans; [apply (D x v1 v2 s H B T0 HT0)|]. replace (- k * T0) with (- (k * T0)) by ring. rewrite exp_Ropp.
    pose proof (exp_pos (k * T0)). apply Rmult_le_reg_r with (exp (k * T0)); auto.
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. assert (1 + k * T0 <= exp (k * T0)) by apply exp_ineq1_le.
    assert (d * (k * T0) = 3 * E0) by (unfold T0; field; lra). nra. }
  assert (Cap : captive m1 m2 a1 a2 b (energy (x T0) (v1 T0) (v2 T0))).
  { assert (0 <= energy (x T0) (v1 T0) (v2 T0)) by (exact (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 _ _ _)).
    specialize (Cl (energy (x T0) (v1 T0) (v2 T0)) ltac:(lra)). unfold captive. fold M. lra. }
  destruct (captive_merges m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Ha2 Hb x v1 v2 s H T0 HT0 Cap) as (t0 & Ht0 & W).
  assert (Sq : sqrt (2 * energy (x T0) (v1 T0) (v2 T0) * m2) <= sqrt (2 * d * m2)).
  { apply sqrt_le_1_alt, Rmult_le_compat_r; [lra|]. scale. }
  assert (Sb : 2 * sqrt (2 * energy (x T0) (v1 T0) (v2 T0) * m2) / b <= 2 * sqrt (2 * d * m2) / b).
  { scale. }
  fold energy in Ht0. unfold T in Ht. split; [|apply W; lra].
  assert (Q := energy_decreases m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Hb _ _ _ _ H T0 t ltac:(lra)). fold energy in Q. lra.
Qed.
End Viscous.
