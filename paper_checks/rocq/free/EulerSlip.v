(** A step of forward Euler in a slip, without a damper: what it adds to the distance from a motion is of the order h^2. *)
From InertialPair Require Import Dini Pair Forced Arcs Excursion EulerLaw.

(** an arc of a circle against its tangent *)
Lemma arc_tangent y : 0 <= y -> (1 - cos y) ^ 2 + (y - sin y) ^ 2 <= (y ^ 2 / 2) ^ 2.
Proof.
  assert (C : forall z, 0 <= z -> 1 - z ^ 2 / 2 <= cos z).
  { from_zero z (fun u => u - sin u). intros u Hu. pose proof (sin_below u ltac:(lra)). lra. }
  assert (Q : 0 <= y -> y ^ 2 - 2 * (y * sin y) <= y ^ 4 / 4 - 2 + 2 * cos y).
  { from_zero y (fun u => u ^ 3 - 2 * u * (1 - cos u)). intros u Hu. pose proof (C u ltac:(lra)) as Cu.
    apply (Rmult_le_compat_l (2 * u)) in Cu; lra. }
  intros Hy. specialize (Q Hy). pose proof (sin2_cos2 y) as SC. unfold Rsqr in SC. nra.
Qed.

Section EulerSlip.
Variables m1 m2 a2 b om h : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om) (Tuned : a2 = m1 * om ^ 2) (Hh : 0 <= h).
Variables X V1 V2 g : R.
Context (A1 := pull m1 0 a2 b X V1 g) (A2 := b * g / m2).

(** the slip from the step's beginning, with its friction *)
Definition slip_x t := X + V1 / om * sin (om * t) + A1 / om ^ 2 * (1 - cos (om * t)).
Definition slip_v1 t := V1 * cos (om * t) + A1 / om * sin (om * t).
Definition slip_v2 t := V2 + A2 * t.

(** *** while that slip does not end within the step, it adds at most h^2 om B/2 to the distance from a motion *)

(** [euler-slip-step] For $a_1=0$, $\omega_1^2=a_2/m_1$: a step $h$ of forward Euler in which the slip with the
    friction at its beginning does not end adds at most $\frac12h^2\omega_1B$ to the energy distance from a motion,
    $B^2=a_2v_1^2+m_1\dot v_1^2$. *)
Theorem euler_slip_step x v1 v2 s N B : solution m1 m2 0 a2 b x v1 v2 s ->
  (forall t, 0 <= t < h -> -1 <= g <= 1 /\ (slip_v2 t < slip_v1 t -> g = 1) /\ (slip_v1 t < slip_v2 t -> g = -1)) ->
  0 <= N -> 0 <= B -> 2 * energy m1 m2 a2 (X - x 0) (V1 - v1 0) (V2 - v2 0) <= N ^ 2 -> a2 * V1 ^ 2 + m1 * A1 ^ 2 <= B ^ 2 ->
  2 * energy m1 m2 a2 (X + h * V1 - x h) (V1 + h * A1 - v1 h) (V2 + h * A2 - v2 h) <= (N + h ^ 2 * om * B / 2) ^ 2.
Proof.
  intros H Law HN HB D0 HB2.
  assert (Arc : forced_arc m1 m2 0 a2 b h (fun _ => 0) slip_x slip_v1 slip_v2 (fun _ => g)).
  { constructor.
    - intros t. unfold slip_x, slip_v1. auto_derive; auto. field. lra.
    - intros t. unfold slip_x, slip_v1, A1, pull. auto_derive; auto. rewrite Tuned. field. lra.
    - intros t. unfold slip_v2, A2. auto_derive; auto. field. lra.
    - exact Law. }
  destruct (arc_begins m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb (fun _ => 0) _ _ _ _ _ h Hh (cont_const 0)
    (fun t _ => rderiv_const 0 t) Arc) as (y & w1 & w2 & z & HY & Q).
  apply free_case in H; auto.
  pose proof (forced_contraction m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ _ 0 h HY H ltac:(lra)) as Near.
  destruct (Q 0 ltac:(lra)) as (Y0 & W10 & W20), (Q h ltac:(lra)) as (Yh & W1h & W2h).
  assert (D1 : 2 * energy m1 m2 a2 (slip_x h - x h) (slip_v1 h - v1 h) (slip_v2 h - v2 h) <= N ^ 2).
  { rewrite Y0, W10, W20, Yh, W1h, W2h in Near. apply Rle_trans with (2 := D0).
    replace (X - x 0) with (slip_x 0 - x 0) by (unfold slip_x; rewrite Rmult_0_r, sin_0, cos_0; field; lra).
    replace (V1 - v1 0) with (slip_v1 0 - v1 0) by (unfold slip_v1; rewrite Rmult_0_r, sin_0, cos_0; field; lra).
    replace (V2 - v2 0) with (slip_v2 0 - v2 0) by (unfold slip_v2; ring). lra. }
  (* what the step is off its slip *)
  set (p := om * h). assert (Hp : 0 <= p) by positive. set (M := h ^ 2 * om * B / 2). assert (HM : 0 <= M) by positive.
  set (ex := X + h * V1 - slip_x h). set (ev := V1 + h * A1 - slip_v1 h).
  assert (D2 : a2 * ex ^ 2 + m1 * ev ^ 2 + m2 * 0 ^ 2 <= M ^ 2).
  { replace (a2 * ex ^ 2 + m1 * ev ^ 2 + m2 * 0 ^ 2) with
      ((a2 * V1 ^ 2 + m1 * A1 ^ 2) * ((1 - cos p) ^ 2 + (p - sin p) ^ 2) / om ^ 2).
    2: { unfold ex, ev, slip_x, slip_v1. fold p. replace h with (p / om) by (unfold p; field; lra). rewrite Tuned. field. lra. }
    replace (M ^ 2) with (B ^ 2 * (p ^ 2 / 2) ^ 2 / om ^ 2) by (unfold M, p; field; lra).
    apply Rmult_le_compat_r; [apply Rlt_le; positive|]. apply Rmult_le_compat; [| |exact HB2|apply arc_tangent; auto].
    - nra.
    - positive. }
  assert (CS : a2 * (slip_x h - x h) * ex + m1 * (slip_v1 h - v1 h) * ev + m2 * (slip_v2 h - v2 h) * 0 <= N * M).
  { apply (energy_schwarz m1 m2 a2 Hm1 Hm2 Ha2 _ _ _ _ _ _ N M HN HM); auto. unfold energy in D1. lra. }
  replace (X + h * V1 - x h) with (slip_x h - x h + ex) by (unfold ex; ring).
  replace (V1 + h * A1 - v1 h) with (slip_v1 h - v1 h + ev) by (unfold ev; ring).
  replace (V2 + h * A2 - v2 h) with (slip_v2 h - v2 h) by (unfold slip_v2; ring). unfold energy in *. nra.
Qed.
End EulerSlip.
