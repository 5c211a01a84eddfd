(** Body 2 can keep an offset from its reference: m1 = m2 = a1 = a2 = b = 1 under the force sin t / 2, by a table of one
    event. *)
From Coq Require Import Reals QArith Qreals List.
From Interval.Float Require Import Specific_ops Specific_stdz.
From Interval.Interval Require Import Float_full.
From Interval Require Import Tactic.
From InertialPair Require Import Dini Pair Forced BoundedMotions ForcedCapture Waves Trajectory Velocities.
Import ListNotations.

Section Table.
Local Open Scope Q_scope.
Definition sine_scene := Scene 1 1 1 1 0 0 (-0.25) (-0.25) (Spell 0 1 (Steady 0 [] [Tone 0.5 0 0 0 1 0])) [].
Definition sine_events := [
  Event (Slip true) (0.1313681533, 0.1313681534) (-0.008068700834, -0.008068700833)
    (-0.274213242483, -0.274213242482) (-0.118631846628, -0.118631846627)].
Definition sine_ending := Ending Stick 0.2 (-0.01597053397, -0.015970533969) (-0.111437796499, -0.111437796498)
    (-0.28211507562, -0.282115075619) (-0.111437796499, -0.111437796498) (0, 0) false.
Lemma sine_accepted : C.check F.PtoP (F.PtoP 24) 64 sine_scene 72
  [(Steady 0 [] [Tone 0 (-0.5) 0 0 1 0], Steady 0 [] [Tone (-0.25) (-0.25) 0 0 1 0])] sine_events sine_ending [
  Hit 72 0.1313681533720056072 0.1313681533720056073 true;
  Last 72 0.0686318466279943929] = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
End Table.

(** the force, the reference and its velocity *)
Definition half_sine t := (1 - cos t) / 2.
Definition swing t := - (sin t + cos t) / 4.
Definition swing' t := - (cos t - sin t) / 4.
(** [keeps-offset] $m_1=m_2=a_1=a_2=b=1$, $u=\frac12\sin t$: the reference $-\frac14(\sin t+\cos t)$ is a motion, and
    one that starts with its $x_2$ and $v_2$, body 1 at rest at 0, takes on its velocities and keeps an offset of
    $x_2$ between $-266.2$ and $-266.1$ mm. *)
Theorem keeps_offset x v1 v2 s x2 : forced 1 1 1 1 1 half_sine x v1 v2 s -> cont x2 ->
  (forall t, 0 <= t -> rderiv x2 t (v2 t)) -> x 0 = 0 -> v1 0 = 0 -> x2 0 = swing 0 -> v2 0 = swing' 0 ->
  (exists s', forced 1 1 1 1 1 half_sine swing swing' swing' s') /\
  exists c, - (2662 / 10 ^ 4) <= c <= - (2661 / 10 ^ 4) /\ forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    Rabs (v1 t - swing' t) <= e /\ Rabs (v2 t - swing' t) <= e /\ Rabs (x2 t - swing t - c) <= e.
Proof.
  intros H Cx2 Dx2 X0 V0 P0 W0. pose proof Rlt_0_1 as One.
  assert (Eu : forall t, is_derive half_sine t (sin t / 2)) by (intros; unfold half_sine; auto_derive; auto; field).
  assert (Es : forall t, is_derive swing t (swing' t)) by (intros; unfold swing, swing'; auto_derive; auto; field).
  assert (Es' : forall t, is_derive swing' t ((sin t + cos t) / 4)) by (intros; unfold swing'; auto_derive; auto;
    field). pose proof (cont_of_derive _ _ Eu) as CU. pose proof (cont_of_derive _ _ Es) as Cs.
  pose proof (cont_of_derive _ _ Es') as Cs'.
  assert (F : forced 1 1 1 1 1 half_sine swing swing' swing' (fun t => 1 / 1 * swing' t)).
  { apply stuck_forced; auto using rderiv_of_derive.
    - intros t Ht. apply rderiv_eq with ((1 + 1) * ((sin t + cos t) / 4) - sin t / 2); [unfold swing, swing'; field|].
      apply rderiv_minus; [apply rderiv_scal|]; apply rderiv_of_derive; auto.
    - intros p q Hp. replace (1 / 1 * (q - p)) with (1 * (q - p)) by field.
      apply (lip_of_rderiv swing' (fun t => (sin t + cos t) / 4)); auto. intros u _.
      split; [apply rderiv_of_derive; auto|]. pose proof (SIN_bound u). pose proof (COS_bound u). apply Rabs_le. lra. }
  split; [eexists; exact F|]. assert (Mo : motion sine_scene x v1 x2 v2).
  { exists half_sine. unfold sine_scene; simpl. split; [auto|]. split.
    - intros t Ht. apply rderiv_eq with (2 := rderiv_of_derive _ _ _ (Eu t)). unfold sval, tval, pval; simpl.
      unfold Q2R; simpl. replace (1 * / 1 * t + 0 * / 1) with t by field. field.
    - unfold Q2R; simpl. split; [exists s; replace (1 * / 1) with 1 by field; exact H|]. unfold swing, swing' in P0, W0.
      rewrite sin_0, cos_0 in P0, W0. split; [auto|]. split; [auto|]. lra. }
  destruct (C.sound _ _ _ _ _ _ _ _ _ sine_accepted x v1 x2 v2 Mo) as (t1 & T1 & Wt & Wx & Wx2 & Wv & Ev & _).
  unfold within in Wt, Wx, Wx2, Wv. simpl in Wt, Wx, Wx2, Wv. unfold Q2R in Wt, Wx, Wx2, Wv. simpl in Wt, Wx, Wx2, Wv.
  (* from t1 on it is near to the reference, so the load stays within friction *)
  set (dx := fun t => x t - swing t). set (dv := fun t => v1 t - swing' t).
  assert (Near : forall t, t1 <= t -> dx t ^ 2 + dv t ^ 2 <= 1 / 10).
  { intros t Ht. pose proof (forced_contraction 1 1 1 1 1 One One ltac:(lra) One half_sine _ _ _ _ _ _ _ _ t1 t H F
      ltac:(lra)) as Q. rewrite <- Ev in Q. unfold energy in Q. fold (dx t) (dx t1) (dv t) (dv t1) in Q.
    pose proof (pow2_ge_0 (v2 t - swing' t)). assert (X1 : Rabs (dx t1) <= 273 / 1000).
    { unfold dx, swing. interval with (i_prec 60). }
    assert (V1 : Rabs (dv t1) <= 97 / 1000). { unfold dv, swing'. interval with (i_prec 60). }
    apply Rabs_inv in X1. apply Rabs_inv in V1. nra. }
  assert (St : forall t, t1 <= t -> v1 t = v2 t).
  { intros t Ht.
    apply (catch 1 1 1 1 1 One One half_sine (fun t => sin t / 2) x v1 v2 s t1 (1 / 4));
      auto using rderiv_of_derive; try lra.
    - intros r Hr. specialize (Near r Hr). pose proof (SIN_bound r). pose proof (COS_bound r).
      replace (1 * (sin r / 2 - 1 * x r - 1 * v1 r) / (1 + 1)) with ((sin r + cos r) / 4 - (dx r + dv r) / 2)
        by (unfold dx, dv, swing, swing'; field). pose proof (pow2_ge_0 (dx r - dv r)).
      assert (- (1 / 2) <= dx r + dv r <= 1 / 2) by (apply sq_le_abs; lra). apply Rabs_le. lra.
    - rewrite Ev, Rminus_diag_eq, Rabs_R0 by auto. unfold Rdiv. rewrite Rmult_0_l. lra. }
  exists (x2 t1 - x t1). split; [lra|]. intros e He.
  destruct (approach 1 1 1 1 1 One One One One One _ _ _ _ _ _ _ _ _ (1 / 2) H F ltac:(lra)) with (e := e ^ 2 / 2) as
    (T & HT & K); [|positive|].
  { intros p q Hp. apply (lip_of_rderiv half_sine (fun t => sin t / 2)); auto. intros u _.
    split; [apply rderiv_of_derive; auto|]. pose proof (SIN_bound u). apply Rabs_le. lra. }
  exists (Rmax T t1). pose proof (Rmax_l T t1). pose proof (Rmax_r T t1). split; [lra|]. intros t Ht.
  specialize (K t ltac:(lra)). unfold energy in K. pose proof (pow2_ge_0 (x t - swing t)).
  pose proof (pow2_ge_0 (v1 t - swing' t)). pose proof (pow2_ge_0 (v2 t - swing' t)).
  assert (Q : forall y, y ^ 2 <= e ^ 2 -> Rabs y <= e) by (intros y Hy; apply Rabs_le, sq_le_abs; lra).
  split; [apply Q; lra|]. split; [apply Q; lra|]. assert (Z : (x t - x2 t) - (x t1 - x2 t1) = 0 * (t - t1)).
  { apply (rderiv_line (fun u => x u - x2 u)); [apply cont_minus; [exact (f_cx _ _ _ _ _ _ _ _ _ _ H)|auto]|lra|].
    intros u Hu. apply rderiv_eq with (v1 u - v2 u); [rewrite St; lra|].
    apply rderiv_minus; [apply (f_x _ _ _ _ _ _ _ _ _ _ H); lra|apply Dx2; lra]. }
  replace (x2 t - swing t - (x2 t1 - x t1)) with (x t - swing t) by lra. apply Q. lra.
Qed.
