(** Forward Euler with any friction in [-b, b] that has the sign of the slip: its distance from the motion grows like
    sqrt (h t), with a constant that its own steps tell. *)
From InertialPair Require Import Dini Pair Rates.

Section EulerLaw.
Context (m1 m2 a1 a2 b h : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (Hh : 0 < h).

(** the acceleration of body 1 under the friction b g *)
Definition pull X V1 g := (- (a2 * X) - a1 * V1 - b * g) / m1.
(** forward Euler with the step h *)
Record euler (X V1 V2 g : nat -> R) : Prop := {
  e_x : forall n, X (S n) = X n + h * V1 n;
  e_1 : forall n, V1 (S n) = V1 n + h * pull (X n) (V1 n) (g n);
  e_2 : forall n, V2 (S n) = V2 n + h * (b * g n / m2);
  e_g : forall n, -1 <= g n <= 1 /\ (V2 n < V1 n -> g n = 1) /\ (V1 n < V2 n -> g n = -1) }.

(** Cauchy and Schwarz in the energy norm *)
Lemma energy_schwarz p q r p' q' r' C C' : 0 <= C -> 0 <= C' ->
  a2 * p ^ 2 + m1 * q ^ 2 + m2 * r ^ 2 <= C ^ 2 -> a2 * p' ^ 2 + m1 * q' ^ 2 + m2 * r' ^ 2 <= C' ^ 2 ->
  a2 * p * p' + m1 * q * q' + m2 * r * r' <= C * C'.
Proof.
  intros HC HC' Q Q'. set (y := a2 * p * p' + m1 * q * q' + m2 * r * r').
  assert (S : y ^ 2 <= (a2 * p ^ 2 + m1 * q ^ 2 + m2 * r ^ 2) * (a2 * p' ^ 2 + m1 * q' ^ 2 + m2 * r' ^ 2)).
  { unfold y. pose proof (pow2_ge_0 (p * q' - q * p')) as S1. pose proof (pow2_ge_0 (p * r' - r * p')) as S2.
    pose proof (pow2_ge_0 (q * r' - r * q')) as S3. assert (0 < a2 * m1) by positive. assert (0 < a2 * m2) by positive.
    assert (0 < m1 * m2) by positive. apply (Rmult_le_compat_l (a2 * m1)) in S1; [|lra].
    apply (Rmult_le_compat_l (a2 * m2)) in S2; [|lra]. apply (Rmult_le_compat_l (m1 * m2)) in S3; [|lra]. nra. }
  assert (N : forall u v w, 0 <= a2 * u ^ 2 + m1 * v ^ 2 + m2 * w ^ 2).
  { intros u v w. pose proof (pow2_ge_0 u). nra. }
  assert (y ^ 2 <= (C * C') ^ 2).
  { eapply Rle_trans; [exact S|]. rewrite Rpow_mult_distr. apply Rmult_le_compat; auto. }
  apply sq_le_abs; [apply Rmult_le_pos; auto|auto].
Qed.

(** one step, from the time 0 of the motion *)
Section Step.
Context (x v1 v2 s : R -> R) (H : solution m1 m2 a1 a2 b x v1 v2 s).
Variables X V1 V2 g C C' : R.
Hypotheses (Hg : -1 <= g <= 1) (Hp : V2 < V1 -> g = 1) (Hn : V1 < V2 -> g = -1) (HC : 0 <= C) (HC' : 0 <= C').
Context (A1 := pull X V1 g) (A2 := b * g / m2).
Hypotheses (Speed : a2 * V1 ^ 2 + m1 * A1 ^ 2 + m2 * A2 ^ 2 <= C ^ 2)
  (Lip : forall r t, 0 <= r <= t -> a2 * (x t - x r) ^ 2 + m1 * (v1 t - v1 r) ^ 2 + m2 * (v2 t - v2 r) ^ 2 <=
    (C' * (t - r)) ^ 2).
Context (dx := fun t => X + t * V1 - x t) (d1 := fun t => V1 + t * A1 - v1 t)
  (d2 := fun t => V2 + t * A2 - v2 t) (D := fun t => energy m1 m2 a2 (dx t) (d1 t) (d2 t)).

(** the distance from the motion along the chord grows at the rate t C (C + C') at most *)
Lemma step_dini t : 0 <= t -> dini_le D t (t * (C * (C + C'))).
Proof.
  intros Ht e He. pose proof (s_x _ _ _ _ _ _ _ _ _ H t Ht) as RX. pose proof (s_v1 _ _ _ _ _ _ _ _ _ H t Ht) as RV.
  unfold rderiv in RX, RV. set (ex := fun k => x (t + k) - x t - v1 t * k) in *.
  set (ev := fun k => m1 * v1 (t + k) + b * s (t + k) - (m1 * v1 t + b * s t) - - (a2 * x t + a1 * v1 t) * k) in *.
  set (ds := fun k => s (t + k) - s t).
  (* how far the chord and the motion go apart *)
  set (Dx := fun k => (V1 - v1 t) * k - ex k).
  set (D1 := fun k => (A1 + (a2 * x t + a1 * v1 t) / m1) * k - / m1 * (ev k - b * ds k)).
  set (D2 := fun k => A2 * k - b / m2 * ds k). pose proof (solution_moving _ _ _ _ _ _ _ _ _ H) as Hm.
  assert (Bs : big ds) by exact (moves_big _ _ _ _ _ _ _ _ _ _ _ Hm t Ht).
  assert (Bd : big Dx /\ big D1 /\ big D2).
  { pose proof (little_big _ RX). pose proof (little_big _ RV).
    repeat split; repeat first [assumption | apply big_minus | apply big_scal | apply big_id]. }
  assert (Dk : forall k, 0 < k -> Dx k = k * V1 - (x (t + k) - x t) /\ D1 k = k * A1 - (v1 (t + k) - v1 t) /\
    D2 k = k * A2 - (v2 (t + k) - v2 t)).
  { intros k Hk. pose proof (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ Hm t (t + k) Ht ltac:(lra)) as W2.
    unfold Dx, D1, D2, ex, ev, ds. repeat split; [ring|field; lra|lra]. }
  set (w := v1 t - v2 t).
  assert (P1 : pushes (fun k => g * k) (V1 - V2) t).
  { split.
    - intros k Hk. replace (g * (t + k) - g * t) with (g * k) by ring. nra.
    - intros k Hk Kw. assert (Eg : g = k) by (destruct Hk; subst k; [apply Hp|apply Hn]; lra). rewrite Eg.
      apply rderiv_of_derive. auto_derive; auto. ring. }
  assert (P2 : pushes s w t).
  { split; [|apply (q_slip _ _ _ _ _ _ _ _ _ _ _ Hm t Ht)]. intros k Hk.
    pose proof (s_lip _ _ _ _ _ _ _ _ _ H t (t + k) ltac:(lra)) as L. apply Rabs_inv in L. lra. }
  destruct (friction_monotone _ _ _ _ t P1 P2 (e / (4 * b))) as (e1 & He1 & K1); [positive|].
  set (rest := fun k => a2 / 2 * (Dx k * Dx k) + m1 / 2 * (D1 k * D1 k) + m2 / 2 * (D2 k * D2 k)
    - a2 * (X - x t) * ex k - (V1 - v1 t) * ev k).
  assert (LR : little rest).
  { unfold rest. apply little_minus; [apply little_minus; [repeat apply little_plus|]|]; apply little_scal; auto;
      apply big_mult; apply Bd. }
  destruct (LR (e / 4)) as (e2 & He2 & K2); [lra|]. smaller e1 e2. intros k Hk.
  specialize (K1 k ltac:(lra)). specialize (K2 k ltac:(lra)). apply Rabs_inv in K2.
  destruct (Dk k ltac:(lra)) as (Ex & E1 & E2).
  assert (ID : D (t + k) - D t = rest k - a1 * (V1 - v1 t) ^ 2 * k - b * ((g * k - ds k) * (V1 - V2 - w))
    + t * (a2 * V1 * Dx k + m1 * A1 * D1 k + m2 * A2 * D2 k)).
  { unfold D, energy. replace (dx (t + k)) with (dx t + Dx k) by (rewrite Ex; unfold dx; ring).
    replace (d1 (t + k)) with (d1 t + D1 k) by (rewrite E1; unfold d1; ring).
    replace (d2 (t + k)) with (d2 t + D2 k) by (rewrite E2; unfold d2; ring).
    assert (F1 : m1 * D1 k = - (a2 * (X - x t) + a1 * (V1 - v1 t)) * k - b * (g * k - ds k) - ev k).
    { unfold D1, A1, pull. field. lra. }
    assert (F2 : m2 * D2 k = b * (g * k - ds k)) by (unfold D2, A2; field; lra).
    transitivity (a2 * (X - x t) * Dx k + (V1 - v1 t) * (m1 * D1 k) + (V2 - v2 t) * (m2 * D2 k)
      + t * (a2 * V1 * Dx k + m1 * A1 * D1 k + m2 * A2 * D2 k)
      + (a2 / 2 * (Dx k * Dx k) + m1 / 2 * (D1 k * D1 k) + m2 / 2 * (D2 k * D2 k))).
    { unfold dx, d1, d2. field. }
    rewrite F1, F2. unfold rest. change (Dx k) with ((V1 - v1 t) * k - ex k) at 1. unfold w. ring. }
  assert (CS : a2 * V1 * Dx k + m1 * A1 * D1 k + m2 * A2 * D2 k <= C * (C + C') * k).
  { assert (Q : a2 * V1 * - (x (t + k) - x t) + m1 * A1 * - (v1 (t + k) - v1 t) + m2 * A2 * - (v2 (t + k) - v2 t) <= C *
      (C' * k)).
    { apply energy_schwarz; auto; [apply Rmult_le_pos; lra|]. pose proof (Lip t (t + k) ltac:(lra)) as L. lra. }
    assert (S : k * (a2 * V1 ^ 2 + m1 * A1 ^ 2 + m2 * A2 ^ 2) <= k * C ^ 2) by (apply Rmult_le_compat_l; lra).
    rewrite Ex, E1, E2. lra. }
  apply (Rmult_le_compat_l t) in CS; auto.
  assert (Mo : b * ((g * k - ds k) * (V1 - V2 - w)) >= - (e / 4) * k).
  { apply Rle_ge. replace (- (e / 4) * k) with (b * (- (e / (4 * b)) * k)) by (field; lra). apply Rmult_le_compat_l; [lra|].
    replace (g * k - ds k) with (g * (t + k) - g * t - (s (t + k) - s t)) by (unfold ds; ring). exact K1. }
  pose proof (pow2_ge_0 (V1 - v1 t)) as Sq. apply (Rmult_le_compat_l a1) in Sq; auto.
  apply (Rmult_le_compat_r k) in Sq; [|lra]. nra.
Qed.

(** so over a step by h^2 C (C + C') / 2 *)
Lemma step_grows : D h <= D 0 + h * (h * (C * (C + C')) / 2).
Proof.
  set (c := C * (C + C')). assert (Cd : cont D).
  { pose proof (s_cx _ _ _ _ _ _ _ _ _ H). pose proof (s_cv _ _ _ _ _ _ _ _ _ H).
    assert (cont v2) by exact (moves_cv2 _ _ _ _ _ Hm2 _ _ _ _ _ _ (solution_moving _ _ _ _ _ _ _ _ _ H)).
    apply energy_cont; continuous. }
  assert (Q : D h - c / 2 * (h * h) <= D 0 - c / 2 * (0 * 0)); [|lra].
  apply (dini_mono (fun t => D t - c / 2 * (t * t))); [|lra|].
  - apply cont_minus; auto. apply cont_of_derive with (fun t => c * t). intros t. auto_derive; auto. field.
  - intros t Ht e He. destruct (step_dini t ltac:(lra) (e / 2)) as (e1 & He1 & K1); [lra|].
    assert (Rd : rderiv (fun t => c / 2 * (t * t)) t (c * t)) by (apply rderiv_of_derive; auto_derive; auto; field).
    destruct (Rd (e / 2)) as (e2 & He2 & K2); [lra|]. smaller e1 e2. intros k Hk. specialize (K1 k ltac:(lra)).
    specialize (K2 k ltac:(lra)). apply Rabs_inv in K2. fold c in K1. lra.
Qed.
End Step.

(** *** Euler's law: twice the energy distance after n steps is at most that before them and h t C (C + C'), t = n h, where
    C bounds the speed of Euler's steps in the energy norm, and C' that of the motion *)

(** [euler-law] Forward Euler with the step $h$ and a friction in $[-b,b]$ of the sign of the slip: $N(t)^2\leqslant
    N(0)^2+h\,t\,C(C+C')$, $C$ and $C'$ the speeds of its steps and of the motion in the energy norm. *)
Theorem euler_law X V1 V2 g x v1 v2 s C C' : euler X V1 V2 g -> solution m1 m2 a1 a2 b x v1 v2 s -> 0 <= C -> 0 <= C' ->
  (forall r t, 0 <= r <= t -> a2 * (x t - x r) ^ 2 + m1 * (v1 t - v1 r) ^ 2 + m2 * (v2 t - v2 r) ^ 2 <= (C' * (t - r)) ^ 2) ->
  forall n, (forall k, (k < n)%nat -> a2 * V1 k ^ 2 + m1 * pull (X k) (V1 k) (g k) ^ 2 + m2 * (b * g k / m2) ^ 2 <= C ^ 2) ->
  2 * energy m1 m2 a2 (X n - x (INR n * h)) (V1 n - v1 (INR n * h)) (V2 n - v2 (INR n * h)) <=
  2 * energy m1 m2 a2 (X O - x 0) (V1 O - v1 0) (V2 O - v2 0) + h * (INR n * h) * (C * (C + C')).
Proof.
  intros [Ex E1 E2 Eg] H HC HC' Lip. induction n as [|n IH]; intros Sp.
  { rewrite !Rmult_0_l. lra. }
  specialize (IH ltac:(intros k Hk; apply Sp; lia)). set (t := INR n * h) in *.
  assert (Ht : 0 <= t) by (apply Rmult_le_pos; [apply pos_INR|lra]).
  destruct (Eg n) as (G0 & G1 & G2).
  pose proof (step_grows _ _ _ _ (solution_later _ _ _ _ _ x v1 v2 s t Ht H) (X n) (V1 n) (V2 n) (g n) C C' G0 G1 G2 HC HC' (Sp n ltac:(lia))) as Q.
  cbv beta in Q. specialize (Q ltac:(intros r u Hr; replace (u - r) with (t + u - (t + r)) by ring; apply Lip; lra)).
  rewrite !Rmult_0_l, !Rplus_0_r in Q. rewrite S_INR, Ex, E1, E2.
  replace ((INR n + 1) * h) with (t + h) by (unfold t; ring). lra.
Qed.
End EulerLaw.
