(** A slip that turns with the force, under a friction that depends on the speed: where more slip needs less force,
    X(0) < 0, the linearised equations in turning axes have a solution that grows like exp (lam t), lam > 0. *)
From InertialPair Require Import Dini RotatingForce.

Section Unstable.
Variables m1 m2 a1 a2 f f' rho om : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hom : 0 < om)
  (HD : 0 < stiffness a1 a2 om m1).

(** a small motion exp (lam t) beside it, in axes that turn with the force, the first of them along the slip; friction
    gains f' per speed along the slip, and turns with the slip across it *)
Record grows (lam q q' v v' w w' g g' : R) : Prop := {
  g_place : lam * q - om * q' = v /\ lam * q' + om * q = v';
  g_body1 : m1 * (lam * v - om * v') = - (a2 * q + a1 * v + g) /\ m1 * (lam * v' + om * v) = - (a2 * q' + a1 * v' + g');
  g_body2 : m2 * (lam * w - om * w') = g /\ m2 * (lam * w' + om * w) = g';
  g_friction : g = f' * (v - w) /\ g' = f / rho * (v' - w') }.

(** the dynamic stiffness of body 1 at lam + i om: its parts, and the square of its size *)
Let Kr l := m1 * (l ^ 2 - om ^ 2) + a1 * l + a2.
Let Ki l := (2 * m1 * l + a1) * om.
Let N l := Kr l ^ 2 + Ki l ^ 2.
(** the mobility of the contact: both parts of mu/K + 1/(m2 mu), mu = lam + i om *)
Let Gr l := (l * Kr l + om * Ki l) / N l + l / (m2 * (l ^ 2 + om ^ 2)).
Let Gi l := (om * Kr l - l * Ki l) / N l - om / (m2 * (l ^ 2 + om ^ 2)).
(** the determinant of the two conditions on friction *)
Let X l := (1 + f' * Gr l) * (1 + f / rho * Gr l) + f' * (f / rho) * Gi l ^ 2.
(** without denominators it is a polynomial *)
Let d l := N l * (m2 * (l ^ 2 + om ^ 2)).
Let nr l := (l * Kr l + om * Ki l) * (m2 * (l ^ 2 + om ^ 2)) + l * N l.
Let ni l := (om * Kr l - l * Ki l) * (m2 * (l ^ 2 + om ^ 2)) - om * N l.
Let Y l := (d l + f' * nr l) * (d l + f / rho * nr l) + f' * (f / rho) * ni l ^ 2.

(** no root of body 1 alone grows *)
Lemma N_pos l : 0 <= l -> 0 < N l.
Proof.
  intros Hl. destruct (Req_dec l 0) as [->|Hn].
  - unfold stiffness in HD. unfold N, Kr, Ki. nra.
  - assert (0 < Ki l) by (unfold Ki; apply Rmult_lt_0_compat; nra). unfold N. nra.
Qed.

(** it has the sign of the determinant *)
Lemma Y_X l : 0 <= l -> Y l = d l ^ 2 * X l.
Proof.
  intros Hl. pose proof (N_pos l Hl). assert (0 < l ^ 2 + om ^ 2) by nra.
  unfold Y, X, Gr, Gi. replace (d l) with (N l * (m2 * (l ^ 2 + om ^ 2))) by reflexivity. unfold nr, ni.
  set (k := f / rho). field. repeat split; lra.
Qed.

(** at 0 it is X(0) *)
Lemma X_0 : X 0 = X0 m1 m2 a1 a2 om f f' rho.
Proof.
  unfold X, X0. assert (E : N 0 = stiffness a1 a2 om m1) by (unfold N, Kr, Ki, stiffness; ring).
  replace (Gr 0) with (g_s m1 a1 a2 om). 2: { unfold Gr, g_s. rewrite E. unfold Kr, Ki. field. repeat split; nra. }
  replace (Gi 0) with (g_a m1 m2 a1 a2 om). 2: { unfold Gi, g_a. rewrite E. unfold Kr, Ki. field. repeat split; nra. }
  reflexivity.
Qed.

(** far out the mobility vanishes *)
Lemma mobility_small l : 1 <= l -> 2 * om <= l -> Rabs (Gr l) <= (4 / m1 + 1 / m2) / l /\ Rabs (Gi l) <= (4 / m1 + 1 / m2) / l.
Proof.
  intros H1 H2. assert (HK : m1 * l ^ 2 / 2 <= Kr l).
  { unfold Kr. assert (0 <= a1 * l) by nra.
    assert (m1 * (l ^ 2 / 2) <= m1 * (l ^ 2 - om ^ 2)) by (apply Rmult_le_compat_l; nra). lra. }
  assert (L2 : 0 < m1 * l ^ 2) by positive. assert (Ip : 0 <= Ki l) by (unfold Ki; apply Rmult_le_pos; nra).
  pose proof (N_pos l ltac:(lra)) as Np. assert (S0 : 0 < l ^ 2 + om ^ 2) by positive. set (a := Kr l / N l).
  set (e := Ki l / N l). set (c := / (m2 * (l ^ 2 + om ^ 2))). assert (0 <= a) by positive. assert (0 <= e) by positive.
  assert (0 <= c) by positive.
  assert (B : forall y, 0 <= y -> y * (m1 * l ^ 2) <= 2 * N l -> y / N l <= 2 / (m1 * l ^ 2)).
  { intros y Hy Q. undivide (m1 * l ^ 2).
    replace (y / N l * (m1 * l ^ 2)) with (y * (m1 * l ^ 2) / N l) by (field; lra). undivide (N l). exact Q. }
  assert (Ba : a <= 2 / (m1 * l ^ 2)) by (apply B; [lra|unfold N; nra]).
  assert (Be : e <= 2 / (m1 * l ^ 2)) by (apply B; [lra|pose proof (pow2_ge_0 (Kr l - Ki l)); unfold N; nra]).
  assert (Bc : c <= 1 / (m2 * l ^ 2)).
  { unfold c, Rdiv. rewrite Rmult_1_l. apply Rinv_le_contravar; [positive|]. apply Rmult_le_compat_l; nra. }
  assert (Sum : l * (a + e + c) <= (4 / m1 + 1 / m2) / l).
  { replace ((4 / m1 + 1 / m2) / l) with (l * (2 / (m1 * l ^ 2) + 2 / (m1 * l ^ 2) + 1 / (m2 * l ^ 2))) by (field; lra).
    apply Rmult_le_compat_l; lra. }
  replace (Gr l) with (l * a + om * e + l * c) by (unfold Gr, a, e, c; field; lra).
  replace (Gi l) with (om * a - l * e - om * c) by (unfold Gi, a, e, c; field; lra). split; apply Rabs_le; nra.
Qed.

Lemma X_far : exists l, 0 < l /\ 0 < X l.
Proof.
  set (C := 4 / m1 + 1 / m2). set (p := Rabs f'). set (q := Rabs (f / rho)). assert (Pp : 0 <= p) by positive.
  assert (Qp : 0 <= q) by positive. set (l := 1 + 2 * om + 4 * C * (p + q)). assert (CP : 0 <= C * (p + q)) by positive.
  assert (L1 : 1 <= l) by (unfold l; lra). exists l. destruct (mobility_small l L1 ltac:(unfold l; lra)) as (Ga & Gb).
  fold C in Ga, Gb. assert (S1 : forall z y, Rabs z <= p + q -> Rabs y <= C / l -> Rabs (z * y) <= / 4).
  { intros z y Hz Hy. rewrite Rabs_mult. apply Rle_trans with ((p + q) * (C / l)).
    - apply Rmult_le_compat; auto using Rabs_pos.
    - replace ((p + q) * (C / l)) with ((p + q) * C / l) by (field; lra). undivide l. unfold l. lra. }
  pose proof (S1 f' _ ltac:(fold p; lra) Ga) as A1. pose proof (S1 (f / rho) _ ltac:(fold q; lra) Ga) as A2.
  pose proof (S1 f' _ ltac:(fold p; lra) Gb) as A3. pose proof (S1 (f / rho) _ ltac:(fold q; lra) Gb) as A4.
  apply Rabs_inv in A1. apply Rabs_inv in A2. unfold X.
  assert (A5 : Rabs (f' * (f / rho) * Gi l ^ 2) <= / 4 * / 4).
  { replace (f' * (f / rho) * Gi l ^ 2) with (f' * Gi l * (f / rho * Gi l)) by ring. rewrite Rabs_mult.
    apply Rmult_le_compat; auto using Rabs_pos. }
  apply Rabs_inv in A5. nra.
Qed.

(** [rotating-unstable] Where $X(0)<0$, the equations linearised about the slip that rotates with the force have a
    solution that grows like $e^{\lambda t}$, $\lambda>0$. *)
Theorem repels : X0 m1 m2 a1 a2 om f f' rho < 0 -> exists lam q q' v v' w w' g g', 0 < lam /\
  grows lam q q' v v' w w' g g' /\ (g <> 0 \/ g' <> 0).
Proof.
  intros Neg. destruct X_far as (L & HL & XL). rewrite <- X_0 in Neg.
  assert (Dp : forall l, 0 <= l -> 0 < d l).
  { intros l Hl. pose proof (N_pos l Hl). unfold d. apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. nra. }
  assert (CY : cont Y).
  { eapply cont_of_derive. intros t. unfold Y, nr, ni, d, N, Kr, Ki. auto_derive; auto. reflexivity. }
  destruct (cont_IVT Y 0 L CY ltac:(lra)) as (l & Hl & Zl).
  { rewrite !Y_X by lra. pose proof (Dp 0 ltac:(lra)). pose proof (Dp L ltac:(lra)). assert (0 < d 0 ^ 2) by positive.
    assert (d 0 ^ 2 * X 0 < 0) by nra. assert (0 < d L ^ 2 * X L) by positive. nra. }
  rewrite Y_X in Zl by lra. assert (0 < d l ^ 2) by (pose proof (Dp l ltac:(lra)); positive).
  assert (Xl : X l = 0) by nra. assert (Lp : 0 < l) by (destruct (Req_dec l 0) as [E|]; [rewrite E in Xl|]; lra).
  assert (Null : exists g g', (g <> 0 \/ g' <> 0) /\ (1 + f' * Gr l) * g - f' * Gi l * g' = 0 /\
    f / rho * Gi l * g + (1 + f / rho * Gr l) * g' = 0).
  { destruct (Req_dec (1 + f' * Gr l) 0) as [E2|E2]; [destruct (Req_dec (f' * Gi l) 0) as [E1|E1]|].
    1: { exists 1, 0. assert (Gz : Gi l = 0) by (apply Rmult_integral in E1; nra). rewrite E2, Gz. lra. }
    all: exists (f' * Gi l), (1 + f' * Gr l); split; [auto|split; [ring|rewrite <- Xl; unfold X; ring]]. }
  destruct Null as (g & g' & NZ & R1 & R2). pose proof (N_pos l ltac:(lra)) as Np.
  assert (S0 : 0 < l ^ 2 + om ^ 2) by nra. set (q := - (g * Kr l + g' * Ki l) / N l).
  set (q' := - (g' * Kr l - g * Ki l) / N l). set (v := l * q - om * q'). set (v' := l * q' + om * q).
  set (w := (g * l + g' * om) / (m2 * (l ^ 2 + om ^ 2))). set (w' := (g' * l - g * om) / (m2 * (l ^ 2 + om ^ 2))).
  exists l, q, q', v, v', w, w', g, g'. split; [auto|split; [|auto]].
  assert (Vw : v - w = - (Gr l * g - Gi l * g')) by (unfold v, w, q, q', Gr, Gi; field; lra).
  assert (Vw' : v' - w' = - (Gr l * g' + Gi l * g)) by (unfold v', w', q, q', Gr, Gi; field; lra).
  assert (Body : Kr l * q - Ki l * q' = - g /\ Kr l * q' + Ki l * q = - g').
  { unfold q, q'. split; unfold N; field; fold (N l); lra. }
  constructor; [split; reflexivity| |split; unfold w, w'; field; lra|rewrite Vw, Vw'; split; lra].
  split; unfold v, v', Kr, Ki in *; lra.
Qed.
End Unstable.
