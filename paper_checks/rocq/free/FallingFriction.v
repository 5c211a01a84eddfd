(** Friction that falls with the speed. Where it falls, two slips move apart at a positive rate, whatever the damper of
  body 1:
    damping cannot save contraction. Where it falls by a jump, a stick can be left at any time: a continuum of motions.
      *)
From InertialPair Require Import Dini Pair Stick Arcs WellPosed SwitchingSurface StaticFriction.

Section Falling.
Variables m1 m2 a1 a2 : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2).

(** [falling-parts] Where friction falls with speed at a constant slope, the difference of two slips has an
    exponentially growing mode, whatever the damper of body 1. *)
Theorem slips_part f' : f' < 0 -> exists l x0 v0 w0, 0 < l /\ w0 <> 0 /\
  forall t, is_derive (fun t => x0 * exp (l * t)) t (v0 * exp (l * t)) /\
    is_derive (fun t => v0 * exp (l * t)) t ((- a2 * (x0 * exp (l * t)) - a1 * (v0 * exp (l * t))
      - f' * (v0 * exp (l * t) - w0 * exp (l * t))) / m1) /\
    is_derive (fun t => w0 * exp (l * t)) t (f' * (v0 * exp (l * t) - w0 * exp (l * t)) / m2).
Proof.
  intros Hf. set (M := m1 + m2).
  set (p := fun l => m1 * m2 * l ^ 3 + (a1 * m2 + f' * M) * l ^ 2 + (a2 * m2 + f' * a1) * l + f' * a2).
  assert (Mp : 0 < m1 * m2) by nra. assert (P0 : p 0 < 0) by (unfold p; nra).
  set (K := 1 + (- f' * M - f' * a1 - f' * a2) / (m1 * m2)). assert (HM : 0 < M) by positive.
  assert (K1 : 1 < K). { unfold K. assert (0 < (- f' * M - f' * a1 - f' * a2) / (m1 * m2)); [|lra]. apply
    Rdiv_lt_0_compat; nra. }
  assert (PK : 0 < p K).
  { assert (E : m1 * m2 * K = m1 * m2 + (- f' * M - f' * a1 - f' * a2)) by (unfold K; field; lra).
    assert (K2 : 1 <= K ^ 2) by nra. assert (KK : K <= K ^ 2) by nra. assert (0 <= a1 * m2 * K ^ 2) by positive.
    assert (0 <= a2 * m2 * K) by positive.
    assert (f' * a1 * K ^ 2 <= f' * a1 * K) by (assert (f' * a1 <= 0) by nra; nra).
    assert (f' * a2 * K ^ 2 <= f' * a2) by (assert (f' * a2 <= 0) by nra; nra).
    replace (p K) with (m1 * m2 * K * K ^ 2 + (a1 * m2 + f' * M) * K ^ 2 + (a2 * m2 + f' * a1) * K + f' * a2) by (unfold
      p; ring).
    rewrite E. assert (0 < m1 * m2 * K ^ 2) by nra. lra. }
  assert (Cp : continuity p) by (unfold p; reg). destruct (IVT p 0 K Cp ltac:(lra) P0 PK) as (l & Hl & Z).
  assert (L0 : 0 < l) by (destruct (Req_dec l 0) as [->|]; lra).
  exists l, (m2 * l + f'), (l * (m2 * l + f')), (f' * l). split; [auto|]. split; [nra|]. intros t.
  split; [|split]; auto_derive; auto; try ring.
  - apply Rmult_eq_reg_l with m1; [|lra]. apply Rminus_diag_uniq.
    match goal with |- ?a = 0 => replace a with (exp (l * t) * p l) by (unfold p, M; field; lra) end. rewrite Z. ring.
  - field. lra.
Qed.
End Falling.

Section Jump.
Variables m1 m2 a2 bs bk : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hk : 0 < bk).
Let X := X m1 m2 a2.
Let V := V m1 m2 a2.
Let om := omega m1 m2 a2.

(** [jump-ill-posed] With two coefficients of friction and $a_1=0$ a stick with a load between them can end at each of
    a continuum of times. *)
Theorem sticks_left_at_will x0 v0 : bk < Rabs (stick_load m1 m2 0 a2 x0 v0) < bs -> exists D, 0 < D /\
  forall T, 0 <= T < D -> exists x v1 v2 s, two_frictions m1 m2 0 a2 bs bk x v1 v2 s /\ x 0 = x0 /\ v1 0 = v0 /\ v2 0 =
    v0 /\
    (forall t, 0 <= t <= T -> v1 t = v2 t) /\ exists d, 0 < d /\ forall t, T < t < T + d -> v1 t <> v2 t.
Proof.
  intros Hl. assert (Mp : 0 < m1 + m2) by lra. pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as Op. fold om in Op.
  pose proof (omega_sq m1 m2 a2 Hm1 Hm2 Ha2) as O2. fold om in O2.
  assert (CX : cont (X x0 v0)) by (eapply cont_of_derive; intros; apply derive_X; auto).
  assert (CV : cont (V x0 v0)) by (eapply cont_of_derive; intros; apply derive_V; auto).
  assert (X00 : X x0 v0 0 = x0) by (unfold X, Stick.X; rewrite Rmult_0_r, cos_0, sin_0; ring).
  assert (V00 : V x0 v0 0 = v0) by (unfold V, Stick.V; rewrite Rmult_0_r, cos_0, sin_0; ring).
  set (c := m2 * a2 / (m1 + m2)). assert (Cp : 0 < c) by (unfold c; apply Rdiv_lt_0_compat; nra).
  assert (Load : forall x v, Rabs (stick_load m1 m2 0 a2 x v) = c * Rabs x).
  { intros x v. unfold stick_load. replace (- (m2 * (a2 * x + 0 * v)) / (m1 + m2)) with (- (c * x)) by (unfold c; field;
    lra). rewrite Rabs_Ropp, Rabs_mult, Rabs_pos_eq; lra. }
  rewrite Load in Hl.
  destruct (Dini.cont_abs _ CX 0 (Rle_refl 0) (Rmin (c * Rabs x0 - bk) (bs - c * Rabs x0) / c)) as (D & HD & Near).
  { positive. }
  assert (Between : forall t, 0 <= t < D -> bk < c * Rabs (X x0 v0 t) < bs).
  { intros t Ht. specialize (Near t ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)). rewrite X00 in Near.
    apply Rmult_lt_compat_l with (r := c) in Near; auto. set (e := Rmin (c * Rabs x0 - bk) (bs - c * Rabs x0)) in *.
    replace (c * (e / c)) with e in Near by (field; lra). rewrite <- (Rabs_pos_eq c), <- Rabs_mult in Near by lra.
    apply Rabs_def2 in Near. assert (e <= c * Rabs x0 - bk) by apply Rmin_l. assert (e <= bs - c * Rabs x0) by apply
      Rmin_r. lra. }
  exists D. split; auto. intros T HT.
  destruct (existence m1 m2 0 a2 bk (X x0 v0 T) (V x0 v0 T) (V x0 v0 T) Hm1 Hm2 (Rle_refl 0) Ha2 Hk) as (y & w1 & w2 & r
    & H & Y0 & W1 & W2).
  set (f := fun t => m2 / bk * V x0 v0 t). assert (Rf : forall t, rderiv f t (- (c / bk) * X x0 v0 t)).
  { intros t. apply rderiv_eq with (m2 / bk * (- (om * om) * X x0 v0 t)); [rewrite O2; unfold c; field; lra|].
    apply rderiv_scal, rderiv_of_derive, derive_V; auto. }
  set (jx := join T (X x0 v0) y). set (jv := join T (V x0 v0) w1). set (jw := join T (V x0 v0) w2).
  assert (Before : forall t, t <= T -> jx t = X x0 v0 t /\ jv t = V x0 v0 t /\ jw t = V x0 v0 t).
  { intros t Ht. unfold jx, jv, jw. rewrite !join_before by (auto; lra). auto. }
  assert (After : forall t, T <= t -> jv t = w1 (t - T) /\ jw t = w2 (t - T)).
  { intros t Ht. unfold jv, jw. rewrite !join_after by lra. auto. }
  exists jx, jv, jw, (join T f (fun t => f T + (r t - r 0))).
  split; [|destruct (Before 0 ltac:(lra)) as (-> & -> & ->); split; [auto|split; [auto|split; [auto|split]]]].
  - apply two_frictions_moves; auto. apply joined; auto; [lra|constructor; auto|].
    + intros p q Hp Hq. apply (lip_between f (fun t => - (c / bk) * X x0 v0 t)); [apply cont_scal, CV|auto|].
      intros u Hu. split; [apply Rf|]. pose proof (Between u ltac:(lra)) as (_ & Bu). apply Rabs_le_between.
      rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (c / bk)) by positive.
      apply Rmult_le_reg_l with bk; auto. replace (bk * (bs / bk)) with bs by (field; lra).
      replace (bk * (c / bk * Rabs (X x0 v0 u))) with (c * Rabs (X x0 v0 u)) by (field; lra). lra.
    + intros t _ k _ W. lra.
    + intros t _. apply rderiv_of_derive, derive_X; auto.
    + intros t _. apply rderiv_ext with (fun u => m1 * V x0 v0 u + bk * f u); [intros; ring|].
      apply rderiv_eq with (m1 * (- (om * om) * X x0 v0 t) + bk * (- (c / bk) * X x0 v0 t)).
      { rewrite O2. unfold c. field. lra. }
      apply rderiv_plus; apply rderiv_scal; [apply rderiv_of_derive, derive_V; auto|apply Rf].
    + intros t _. unfold f. field; lra.
    + apply solution_moves in H. destruct H as [L P Cy Cw Dy Dw W]. constructor; auto. intros p q Hp.
      eapply Rle_trans; [apply L; auto|]. apply Rmult_le_compat_r; [lra|]. undivide bk.
      specialize (Between 0 ltac:(lra)). lra.
  - intros t Ht. destruct (Before t ltac:(lra)) as (_ & -> & ->). auto.
  - destruct (slips_beyond m1 m2 a2 bk Hm1 Hm2 Ha2 Hk y w1 w2 r H 0 (Rle_refl 0)) as (d & Hd & Sl); [rewrite W1, W2;
    auto| |].
    + intros In. apply Rabs_le in In. rewrite Y0 in In. pose proof (Between T ltac:(lra)) as (Bu & _).
      unfold L in In. apply Rmult_le_compat_l with (r := c) in In; [|lra].
      replace (c * (bk * (m1 + m2) / (a2 * m2))) with bk in In by (unfold c; field; lra). lra.
    + exists d. split; auto. intros t Ht. destruct (After t ltac:(lra)) as (-> & ->). specialize (Sl (t - T)
      ltac:(lra)).
      intros E. rewrite E in Sl. replace (w2 (t - T) - w2 (t - T)) with 0 in Sl by ring. rewrite Rmult_0_r in Sl. lra.
Qed.
End Jump.
