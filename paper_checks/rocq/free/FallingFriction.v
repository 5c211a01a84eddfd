(** Friction that falls with the speed. Where it falls, two slips move apart at a positive rate, whatever the damper of
    body 1. Where it falls by a jump, a stick can be left at any time: a continuum of motions. *)
From InertialPair Require Import Dini Pair Stick Arcs WellPosed SwitchingSurface StaticFriction SticksKept.

Section Falling.
Context (m1 m2 a1 a2 : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2).

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
    assert (KK : K <= K ^ 2) by nra. assert (0 <= a1 * m2 * K ^ 2) by positive. assert (0 <= a2 * m2 * K) by positive.
    assert (f' * a1 * K ^ 2 <= f' * a1 * K) by (assert (f' * a1 <= 0) by nra; nra).
    assert (f' * a2 * K ^ 2 <= f' * a2) by (assert (f' * a2 <= 0) by nra; nra).
    replace (p K) with (m1 * m2 * K * K ^ 2 + (a1 * m2 + f' * M) * K ^ 2 + (a2 * m2 + f' * a1) * K + f' * a2)
      by (unfold p; ring). rewrite E. assert (0 < m1 * m2 * K ^ 2) by nra. lra. }
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
Context (m1 m2 a2 bs bk : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hk : 0 < bk).

(** [jump-ill-posed] With two coefficients of friction and $a_1=0$ a stick with a load between them can end at each of
    a continuum of times. *)
Theorem sticks_left_at_will x0 v0 : bk < Rabs (stick_load m1 m2 0 a2 x0 v0) < bs -> exists D, 0 < D /\
  forall T, 0 <= T < D -> exists x v1 v2 s, two_frictions m1 m2 0 a2 bs bk x v1 v2 s /\ x 0 = x0 /\ v1 0 = v0 /\ v2 0 =
    v0 /\
    (forall t, 0 <= t <= T -> v1 t = v2 t) /\ exists d, 0 < d /\ forall t, T < t < T + d -> v1 t <> v2 t.
Proof.
  intros Hl. destruct (existence m1 m2 0 a2 bs x0 v0 v0 Hm1 Hm2 (Rle_refl 0) Ha2 ltac:(lra))
    as (x & v1 & v2 & s & H & X0 & V0 & W0). set (c := m2 * a2 / (m1 + m2)). assert (Cp : 0 < c) by positive.
  assert (Load : forall x v, Rabs (stick_load m1 m2 0 a2 x v) = c * Rabs x).
  { intros y v. unfold stick_load. replace (- (m2 * (a2 * y + 0 * v)) / (m1 + m2)) with (- (c * y)) by (unfold c; field;
    lra). rewrite Rabs_Ropp, Rabs_mult, Rabs_pos_eq; lra. }
  rewrite Load in Hl. set (e := Rmin (c * Rabs x0 - bk) (bs - c * Rabs x0)).
  destruct (Dini.cont_abs _ (s_cx _ _ _ _ _ _ _ _ _ H) 0 (Rle_refl 0) (e / c)) as (D & HD & Near); [positive|].
  assert (Between : forall t, 0 <= t < D -> bk < c * Rabs (x t) < bs).
  { intros t Ht. specialize (Near t ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)). rewrite X0 in Near.
    apply Rmult_lt_compat_l with (r := c) in Near; auto. replace (c * (e / c)) with e in Near by (field; lra).
    rewrite <- (Rabs_pos_eq c), <- Rabs_mult in Near by lra. apply Rabs_def2 in Near.
    assert (e <= c * Rabs x0 - bk) by apply Rmin_l. assert (e <= bs - c * Rabs x0) by apply Rmin_r. lra. }
  exists D. split; auto. intros T HT. assert (St : forall t, 0 <= t <= T -> v1 t = v2 t).
  { apply (stay m1 m2 0 a2 bs Hm1 Hm2 x v1 v2 s H); [lra|lra|]. intros t Ht. rewrite Load. apply Between. lra. }
  destruct (existence m1 m2 0 a2 bk (x T) (v1 T) (v2 T) Hm1 Hm2 (Rle_refl 0) Ha2 Hk) as (y & w1 & w2 & r & K & Y0 & W1 &
    W2). assert (E : forall t, 0 <= t <= T -> join T x y t = x t /\ join T v1 w1 t = v1 t /\ join T v2 w2 t = v2 t).
  { intros t Ht. rewrite !join_before by (auto; lra). auto. }
  exists (join T x y), (join T v1 w1), (join T v2 w2), (join T (fun t => bs / bk * s t) (fun t => bs / bk * s T + (r t -
    r 0))). split; [|destruct (E 0 ltac:(lra)) as (-> & -> & ->); split; [auto|split; [auto|split; [auto|split]]]].
  - apply two_frictions_moves; auto. refine (joined m1 m2 0 a2 bk T (bs / bk) (fun _ => 0) x v1 v2 (fun t => bs / bk * s
      t) y w1 w2 r _ _ _ _ _ _); auto; [lra|apply stick_until; auto; [lra|intros; apply St; lra]|apply jumping_moves,
      kinetic; auto; lra].
  - intros t Ht. destruct (E t Ht) as (_ & -> & ->). auto.
  - destruct (slips_beyond m1 m2 a2 bk Hm1 Hm2 Ha2 Hk y w1 w2 r K 0 (Rle_refl 0)) as (d & Hd & Sl).
    { rewrite W1, W2. apply St. lra. }
    { intros In. apply Rabs_le in In. rewrite Y0 in In. pose proof (Between T ltac:(lra)). unfold L in In.
      apply Rmult_le_compat_l with (r := c) in In; [|lra].
      replace (c * (bk * (m1 + m2) / (a2 * m2))) with bk in In by (unfold c; field; lra). lra. }
    exists d. split; auto. intros t Ht Et. rewrite !join_after in Et by lra. specialize (Sl (t - T) ltac:(lra)).
    rewrite Et in Sl. nra.
Qed.
End Jump.
