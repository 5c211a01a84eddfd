(** A level above E_cr meets S0 in two arcs; each is run through by a motion, which leaves S0 at its end. *)
From InertialPair Require Import Dini Pair Stick WellPosed FollowArc Cycle ExitOrbit SharpRate SharpLaw
  SwitchingSurface.

Section TwoArcs.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b)
  (L0 : 0 < L := L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb).

(** the speed on S at the place y at the level e *)
Definition level_speed e y := sqrt ((2 * e - a2 * y ^ 2) / (m1 + m2)).

Section Level.
Context (e : R) (He : Ecr < e).
Let sp := level_speed e.

Lemma speed_pos y : - L <= y <= L -> 0 < sp L <= sp y /\ energy m1 m2 a2 y (sp y) (sp y) = e.
Proof.
  intros Hy. assert (y ^ 2 <= L ^ 2) by nra. assert (a2 * y ^ 2 <= a2 * L ^ 2) by nra.
  assert (HL : a2 * L ^ 2 < 2 * e) by (unfold Ecr in He; rewrite Ecr_L in He by auto; fold L in He; lra).
  split; [split|].
  - apply sqrt_lt_R0, Rdiv_lt_0_compat; lra.
  - apply sqrt_le_1_alt. apply Rmult_le_compat_r; [positive|lra].
  - unfold sp, level_speed, energy. rewrite pow2_sqrt; [field; lra|]. apply Rdiv_le_0_compat; lra.
Qed.
Lemma level_speeds y v : - L <= y <= L -> energy m1 m2 a2 y v v = e <-> v = sp y \/ v = - sp y.
Proof.
  intros Hy. destruct (speed_pos y Hy) as (P & Ey). split.
  - intros E. rewrite <- E in Ey. unfold energy in Ey. assert (Z : (m1 + m2) * ((v - sp y) * (v + sp y)) = 0) by lra.
    apply Rmult_integral in Z. destruct Z as [Z|Z]; [lra|]. apply Rmult_integral in Z. destruct Z; lra.
  - intros [->| ->]; apply eq_trans with (2 := Ey); unfold energy; field.
Qed.

(** The left arc: a motion from its right end runs through it to the left ray, and slips on. *)
Lemma run_left x v1 v2 s : solution m1 m2 0 a2 b x v1 v2 s -> x 0 = L -> v1 0 = - sp L -> v2 0 = - sp L ->
  exists T, 0 < T /\ x T = - L /\ (forall t, 0 <= t <= T -> - L <= x t <= L /\ v1 t = - sp (x t) /\
    v2 t = - sp (x t)) /\
    (forall r t, 0 <= r < t -> t <= T -> x t < x r) /\ (exists d, 0 < d /\ forall t, T < t < T + d -> v2 t < v1 t).
Proof.
  intros H X0 V0 W0. destruct (speed_pos L ltac:(lra)) as ((P & _) & EL).
  destruct (level_push m1 m2 a2 b Hm1 Hm2 Ha2 Hb e He) as (U & Eu). fold q Ecr in U, Eu. set (u := sqrt _) in *.
  assert (E00 : energy m1 m2 a2 (x 0) (v1 0) (v2 0) = e) by (rewrite X0, V0, W0, <- EL; unfold energy; field).
  destruct (to_ray_left m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s 0 u H) as (T & HT & (XT & VT & WT) & St); auto;
    try (fold L; lra).
  { rewrite E00. exact Eu. } fold L in XT, St. pose proof (ray_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb u U) as R0. exists T.
  assert (T0 : 0 < T) by (destruct (Req_dec T 0) as [Z|]; [rewrite Z, X0 in XT|]; lra).
  assert (ET : energy m1 m2 a2 (x T) (v1 T) (v2 T) = e).
  { rewrite Eu. apply (ray_energy m1 m2 a2 b Hm1 Hm2 Ha2 (-1) u x v1 v2 T); [auto|]. repeat split; fold L; lra. }
  assert (Et : forall t, 0 <= t <= T -> energy m1 m2 a2 (x t) (v1 t) (v1 t) = e).
  { intros t Ht. destruct (St t Ht) as (Ev & _). rewrite Ev at 2.
    pose proof (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H 0 t ltac:(lra)).
    pose proof (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H t T ltac:(lra)). lra. }
  assert (Neg : forall t, 0 <= t <= T -> v1 t = - sp (x t)).
  { intros t Ht. destruct (St t Ht) as (_ & Hx).
    destruct (proj1 (level_speeds (x t) (v1 t) Hx) (Et t Ht)) as [S|S]; auto. destruct (speed_pos (x t) Hx) as (Sp & _).
    destruct (cont_IVT v1 0 t (s_cv _ _ _ _ _ _ _ _ _ H)) as (c & Hc & Z); [lra|rewrite V0, S; nra|].
    destruct (St c ltac:(lra)) as (_ & Hxc). destruct (speed_pos (x c) Hxc) as (Sc & _).
    destruct (proj1 (level_speeds (x c) (v1 c) Hxc) (Et c ltac:(lra))); lra. }
  split; [auto|]. split; [lra|]. split; [|split].
  - intros t Ht. destruct (St t Ht) as (Ev & Hx). rewrite <- Ev. split; [auto|]. split; apply Neg; auto.
  - intros r t Hr Ht. assert (x t + sp L * t <= x r + sp L * r); [|nra].
    apply (rderiv_mono (fun w => x w + sp L * w) r t (fun w => v1 w + sp L)); [|lra|].
    + apply cont_plus; [exact (s_cx _ _ _ _ _ _ _ _ _ H)|apply (cont_of_derive _ (fun _ => sp L)); intros w;
        auto_derive; auto; ring].
    + intros w Hw. split.
      * apply rderiv_plus; [apply (s_x _ _ _ _ _ _ _ _ _ H); lra|]. apply rderiv_of_derive. auto_derive; auto. ring.
      * rewrite Neg by lra. destruct (St w ltac:(lra)) as (_ & Hx). destruct (speed_pos (x w) Hx). lra.
  - destruct (slips_on_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H T (-1)) as (d & Hd & K); auto; try (fold L; lra).
    exists d. split; [auto|]. intros t Ht. specialize (K t Ht). lra.
Qed.

(** [two-arcs] A level above $E_{cr}$ meets $S_0$ in two arcs, the graphs of a speed and of its negative over
    $[-L,L]$; each is run through by a motion, which slips at its end: from the left ray into $v_1>v_2$, from the
    right one into $v_1<v_2$. *)
Theorem two_arcs : (forall y, - L <= y <= L -> 0 < sp y) /\
  (forall y v, - L <= y <= L -> energy m1 m2 a2 y v v = e <-> v = sp y \/ v = - sp y) /\
  forall k, k = 1 \/ k = -1 -> exists x v1 v2 s T, solution m1 m2 0 a2 b x v1 v2 s /\ 0 < T /\
    (forall t, 0 <= t <= T -> - L <= x t <= L /\ v1 t = k * sp (x t) /\ v2 t = k * sp (x t)) /\
    (forall y, - L <= y <= L -> exists t, 0 <= t <= T /\ x t = y) /\ k * x T = L /\ 0 < k * v1 T /\
    exists d, 0 < d /\ forall t, T < t < T + d -> k * v1 t < k * v2 t.
Proof.
  split; [intros y Hy; destruct (speed_pos y Hy); lra|]. split; [exact level_speeds|].
  assert (Left : exists x v1 v2 s T, solution m1 m2 0 a2 b x v1 v2 s /\ x 0 = L /\ 0 < T /\ x T = - L /\
    (forall t, 0 <= t <= T -> - L <= x t <= L /\ v1 t = - sp (x t) /\ v2 t = - sp (x t)) /\
    exists d, 0 < d /\ forall t, T < t < T + d -> v2 t < v1 t).
  { destruct (well_posed m1 m2 0 a2 b L (- sp L) (- sp L) Hm1 Hm2 (Rle_refl 0) Ha2 Hb)
      as (x & v1 & v2 & s & (H & X0 & V0 & W0) & _). destruct (run_left x v1 v2 s H X0 V0 W0) as (T & A & B & C & _ &
        D). exists x, v1, v2, s, T. repeat (split; [assumption|]). auto. }
  destruct Left as (x & v1 & v2 & s & T & H & X0 & T0 & XT & St & d & Hd & K).
  assert (All : forall y, - L <= y <= L -> exists t, 0 <= t <= T /\ x t = y).
  { intros y Hy. destruct (cont_IVT (fun t => x t - y) 0 T) as (t & Ht & Z); [|lra|rewrite X0, XT; nra|].
    - apply cont_minus; [exact (s_cx _ _ _ _ _ _ _ _ _ H)|apply cont_const].
    - exists t. split; [auto|lra]. }
  destruct (speed_pos L ltac:(lra)) as ((P & _) & _). destruct (St T ltac:(lra)) as (_ & VT & _).
  assert (Even : forall y z, y ^ 2 = z ^ 2 -> sp y = sp z) by (intros y z E; unfold sp, level_speed; rewrite E; auto).
  rewrite XT, (Even (- L) L) in VT by ring. intros k Hk.
  exists (fun t => - k * x t), (fun t => - k * v1 t), (fun t => - k * v2 t), (fun t => - k * s t), T.
  split; [apply sided; [destruct Hk; [right|left]; lra|auto]|]. split; [auto|]. split; [|split; [|split; [|split]]].
  - intros t Ht. destruct (St t Ht) as (A & B & C).
    rewrite (Even (- k * x t) (x t)), B, C by (destruct Hk; subst k; ring). destruct Hk; subst k; lra.
  - intros y Hy. destruct (All (- k * y)) as (t & Ht & E); [destruct Hk; subst k; lra|]. exists t. split; [auto|].
    rewrite E. destruct Hk; subst k; ring.
  - destruct Hk; subst k; lra.
  - destruct Hk; subst k; lra.
  - exists d. split; [auto|]. intros t Ht. specialize (K t Ht). destruct Hk; subst k; lra.
Qed.
End Level.
End TwoArcs.
