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

(** no root of body 1 alone grows *)
Lemma N_pos l : 0 <= l -> 0 < N l.
Proof.
  intros Hl. destruct (Req_dec l 0) as [->|Hn].
  - unfold stiffness in HD. unfold N, Kr, Ki. nra.
  - assert (0 < Ki l) by (unfold Ki; apply Rmult_lt_0_compat; nra). unfold N. nra.
Qed.

(** at 0 it is X(0) *)
Lemma X_0 : X 0 = X0 m1 m2 a1 a2 om f f' rho.
Proof.
  unfold X, X0. assert (E : N 0 = stiffness a1 a2 om m1) by (unfold N, Kr, Ki, stiffness; ring).
  replace (Gr 0) with (g_s m1 a1 a2 om). 2: { unfold Gr, g_s. rewrite E. unfold Kr, Ki. field. repeat split; nra. }
  replace (Gi 0) with (g_a m1 m2 a1 a2 om). 2: { unfold Gi, g_a. rewrite E. unfold Kr, Ki. field. repeat split; nra. }
  reflexivity.
Qed.

(** far out the mobility vanishes: the dynamic stiffness has at least the real part m1 l mu of its inertia *)
Lemma mobility_small l : 0 < l -> Rabs (Gr l) <= (/ m1 + / m2) / l /\ Rabs (Gi l) <= (/ m1 + / m2) / l.
Proof.
  intros Hl. pose proof (N_pos l ltac:(lra)) as Np. set (p := l * Kr l + om * Ki l).
  set (q := om * Kr l - l * Ki l). set (s := l ^ 2 + om ^ 2). assert (Sp : 0 < s) by (unfold s; nra).
  assert (Lp : 0 < m1 * l) by positive. assert (E : p ^ 2 + q ^ 2 = s * N l) by (unfold p, q, s, N; ring).
  assert (Ep : p = m1 * l * s + (a1 * s + a2 * l)) by (unfold p, s, Kr, Ki; ring).
  assert (0 <= a1 * s + a2 * l) by positive. assert (0 <= m1 * l * s) by positive. pose proof (pow2_ge_0 q).
  assert (P : (m1 * l * s) ^ 2 <= p ^ 2) by (apply pow_incr; lra).
  assert (N1 : (m1 * l) ^ 2 * s <= N l) by (apply Rmult_le_reg_l with s; lra).
  assert (B : forall y c n, 0 < c -> 0 < n -> - n <= c * y <= n -> - / c <= y / n <= / c).
  { intros y c n Hc Hn Hy. split; [apply Rle_div_r|apply Rle_div_l]; auto; apply Rmult_le_reg_l with c; auto;
      field_simplify; lra. }
  assert (K : forall y, y ^ 2 <= s * N l -> - / (m1 * l) <= y / N l <= / (m1 * l)).
  { intros y Hy. apply B; auto. apply sq_le_abs; [lra|]. apply Rle_trans with ((m1 * l) ^ 2 * s * N l).
    - rewrite Rpow_mult_distr, Rmult_assoc. scale.
    - replace (N l ^ 2) with (N l * N l) by ring. scale. }
  pose proof (K p ltac:(nra)). pose proof (K q ltac:(nra)).
  pose proof (B l (m2 * l) (m2 * s) ltac:(positive) ltac:(positive) ltac:(unfold s; nra)).
  assert (Os : 0 <= l * om <= s) by (pose proof (pow2_ge_0 (l - om)); unfold s; split; nra).
  pose proof (B om (m2 * l) (m2 * s) ltac:(positive) ltac:(positive) ltac:(nra)).
  replace ((/ m1 + / m2) / l) with (/ (m1 * l) + / (m2 * l)) by (field; lra).
  split; apply Rabs_le; unfold Gr, Gi; fold p q s; lra.
Qed.

Lemma X_far : exists l, 0 < l /\ 0 < X l.
Proof.
  set (c := / m1 + / m2). set (z := 1 + Rabs f' + Rabs (f / rho)). pose proof (Rabs_pos f').
  pose proof (Rabs_pos (f / rho)). assert (Cp : 0 < c) by (unfold c; positive).
  assert (Zp : 0 < z) by (unfold z; lra). assert (Lp : 0 < 4 * c * z) by positive. exists (4 * c * z).
  split; [auto|]. destruct (mobility_small _ Lp) as (Ga & Gb). fold c in Ga, Gb.
  replace (c / (4 * c * z)) with (/ 4 * / z) in Ga, Gb by (field; lra). unfold X.
  assert (S : forall k y, Rabs k <= z -> Rabs y <= / 4 * / z -> - / 4 <= k * y <= / 4).
  { intros k y Hk Hy. apply Rabs_inv. rewrite Rabs_mult. replace (/ 4) with (z * (/ 4 * / z)) by (field; lra).
    apply Rmult_le_compat; auto using Rabs_pos. }
  pose proof (fun y => S f' y ltac:(unfold z; lra)) as S1.
  pose proof (fun y => S (f / rho) y ltac:(unfold z; lra)) as S2. pose proof (S1 _ Ga). pose proof (S1 _ Gb).
  pose proof (S2 _ Ga). pose proof (S2 _ Gb). nra.
Qed.

(** [rotating-unstable] Where $X(0)<0$, the equations linearised about the slip that rotates with the force have a
    solution that grows like $e^{\lambda t}$, $\lambda>0$. *)
Theorem repels : X0 m1 m2 a1 a2 om f f' rho < 0 -> exists lam q q' v v' w w' g g', 0 < lam /\
  grows lam q q' v v' w w' g g' /\ (g <> 0 \/ g' <> 0).
Proof.
  intros Neg. destruct X_far as (L & HL & XL). rewrite <- X_0 in Neg.
  assert (CX : cont X).
  { apply cont_of_continuous. intros l Hl. apply @ex_derive_continuous. pose proof (N_pos l Hl).
    assert (0 < m2 * (l ^ 2 + om ^ 2)) by (apply Rmult_lt_0_compat; nra). unfold X, Gr, Gi, N, Kr, Ki in *.
    auto_derive. repeat split; lra. }
  destruct (cont_IVT X 0 L CX ltac:(lra)) as (l & Hl & Xl); [nra|].
  assert (Lp : 0 < l) by (destruct (Req_dec l 0) as [E|]; [rewrite E in Xl|]; lra).
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
