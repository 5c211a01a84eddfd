(** Sentences of Sections III and V that follow at once: after each stay off S either S0 or a crossing, the places of
    exits and entries, the decay slower than every exponential, and synchronisation for all parameters. *)
From InertialPair Require Import Dini Pair Stick EnergyLimit Dichotomy Viscous Excursion ReturnMap FollowArc Cycle
  ExitOrbit SharpRate SharpLaw OneOverT.
From InertialPair Require Import ReturnToS0 SwitchingSurface Interface.

Section Free.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let w t := v1 t - v2 t.
Let CW : cont w.
Proof. apply cont_minus; [apply (s_cv _ _ _ _ _ _ _ _ _ H)|exact (moves_cv2 m1 m2 0 a2 b Hm2 _ _ _ _ _ _ H)]. Qed.

(** the first contact after a time off S *)
Lemma first_contact t : 0 <= t -> w t <> 0 -> exists t1, t < t1 /\ w t1 = 0 /\ forall u, t <= u < t1 -> 0 < w t * w u.
Proof.
  intros Ht Hw. destruct (contact m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb x v1 v2 s t H Ht) as (tc & Tc & Ec).
  assert (Z : w tc = 0) by (unfold w; lra).
  destruct (first_zero w t tc CW) as (t1 & Q & R); [lra|rewrite Z; lra|auto|]. exists t1. split; [lra|auto].
Qed.

(** a stay below S does not end at x > L: there the relative velocity falls *)
Lemma ends_left t t1 : 0 <= t < t1 -> w t1 = 0 -> (forall u, t <= u < t1 -> w u < 0) -> x t1 <= L.
Proof.
  intros Ht Z Neg. destruct (Rle_dec (x t1) L) as [|N]; auto.
  destruct (s_cx _ _ _ _ _ _ _ _ _ H t1 ltac:(lra) (x t1 - L) ltac:(lra)) as (d & Hd & K).
  destruct (just_before t t1 d) as (u & Hu & Near); [lra|auto|].
  assert (F : w t1 <= w u).
  { apply (rderiv_mono w u t1 (fun r => normal_rate m1 m2 a2 b (-1) (x r)) CW); [lra|]. split.
    - apply (rate_below m1 m2 a2 b Hm1 Hm2 x v1 v2 s H r); [lra|]. pose proof (Neg r ltac:(lra)) as Q.
      unfold w in Q. lra.
    - apply Rlt_le. apply (transversal_beyond m1 m2 a2 b Hm1 Hm2 Ha2 Hb (x r) (-1)); [right; auto|]. fold L.
      pose proof (K r ltac:(lra) ltac:(apply Rabs_def1; lra)) as Q. apply Rabs_def2 in Q. lra. }
  pose proof (Neg u ltac:(lra)). lra.
Qed.
End Free.

(** [return-alternatives] From $v_1<v_2$ every solution reaches $S_0$, or $S$ beyond its left edge, from where it
    passes into $v_1>v_2$ at once. *)
Theorem return_alternatives m1 m2 a2 b x v1 v2 s t : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b ->
  solution m1 m2 0 a2 b x v1 v2 s ->
  0 <= t -> v1 t < v2 t -> exists t1, t < t1 /\ (forall u, t <= u < t1 -> v1 u < v2 u) /\ v1 t1 = v2 t1 /\
    (- L m1 m2 a2 b <= x t1 <= L m1 m2 a2 b \/
     (x t1 < - L m1 m2 a2 b /\ exists T, 0 < T /\ forall u, t1 < u < t1 + T -> v2 u < v1 u)).
Proof.
  intros H1 H2 Ha Hb H Ht Hv.
  destruct (first_contact m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H t Ht ltac:(lra)) as (t1 & T1 & Z & Sg).
  assert (Neg : forall u, t <= u < t1 -> v1 u < v2 u). { intros u Hu. specialize (Sg u Hu). nra. }
  exists t1. split; [auto|]. split; [auto|]. split; [lra|]. assert (X : x t1 <= L m1 m2 a2 b).
  { apply (ends_left m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H t t1); auto; try lra. intros u Hu. specialize (Neg u Hu). lra. }
  destruct (Rle_dec (- L m1 m2 a2 b) (x t1)) as [|N]; [left; auto|right]. apply Rnot_le_lt in N. split; [auto|].
  destruct (slips_beyond m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H t1 ltac:(lra) ltac:(lra) ltac:(lra)) as (T & HT & K).
  exists T. split; [auto|]. intros u Hu. specialize (K u Hu). nra.
Qed.
(** [return-alternatives-mirror] From $v_1>v_2$ every solution reaches $S_0$, or $S$ beyond its right edge, from where
    it passes into $v_1<v_2$ at once. *)
Theorem return_alternatives_mirror m1 m2 a2 b x v1 v2 s t : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b ->
  solution m1 m2 0 a2 b x v1 v2 s ->
  0 <= t -> v2 t < v1 t -> exists t1, t < t1 /\ (forall u, t <= u < t1 -> v2 u < v1 u) /\ v1 t1 = v2 t1 /\
    (- L m1 m2 a2 b <= x t1 <= L m1 m2 a2 b \/
     (L m1 m2 a2 b < x t1 /\ exists T, 0 < T /\ forall u, t1 < u < t1 + T -> v1 u < v2 u)).
Proof.
  intros H1 H2 Ha Hb H Ht Hv.
  destruct (return_alternatives m1 m2 a2 b _ _ _ _ t H1 H2 Ha Hb (mirror m1 m2 a2 b _ _ _ _ H) Ht ltac:(cbv beta; lra))
    as (t1 & T1 & A & B & [C|(C & T & HT & K)]); cbv beta in *; exists t1; (split; [auto|]);
    (split; [intros u Hu; specialize (A u Hu); lra|]); (split; [lra|]); [left; lra|right; split; [lra|]].
  exists T. split; [auto|]. intros u Hu. specialize (K u Hu). lra.
Qed.

(** [synchronisation] $v_1-v_2\to 0$ for all $m_1,m_2,a_2,b>0$, $a_1\geqslant 0$ and from every start. *)
Theorem relative_velocity_vanishes m1 m2 a1 a2 b x v1 v2 s : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b ->
  solution m1 m2 a1 a2 b x v1 v2 s -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    Rabs (v1 t - v2 t) <= e.
Proof.
  intros H1 H2 A1 Ha Hb. exact (solution_synchronises m1 m2 a1 a2 H1 H2 A1 Ha b x v1 v2 s Hb).
Qed.

(** [slower-than-exponential] The excess energy of a solution that never merges is eventually above every decaying
    exponential. *)
Theorem slower_than_exponential m1 m2 a2 b x v1 v2 s : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b ->
  solution m1 m2 0 a2 b x v1 v2 s ->
  (forall t, 0 <= t -> Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t)) ->
  forall C k, 0 < k -> exists T, forall t, T <= t ->
    C * exp (- (k * t)) <= energy m1 m2 a2 (x t) (v1 t) (v2 t) - Ecr m1 m2 a2 b.
Proof.
  intros H1 H2 Ha Hb H Up C k Hk. pose proof (sharp_law m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H Up) as Law.
  pose proof (Ecr_pos m1 m2 a2 b H1 H2 Ha Hb) as E0. set (l := Ecr m1 m2 a2 b * rate m1 m2 a2) in *.
  assert (L0 : 0 < l). { apply Rmult_lt_0_compat; auto. pose proof PI_RGT_0. apply Rmult_lt_0_compat; [|positive].
  apply Rmult_lt_0_compat; [lra|positive]. }
  apply is_lim_spec in Law. destruct (Law (mkposreal (l / 2) ltac:(lra))) as (M & HM). simpl in HM.
  exists (Rmax (Rmax 1 (M + 1)) (8 * Rabs C / (k ^ 2 * l))). intros t Ht.
  pose proof (Rmax_l (Rmax 1 (M + 1)) (8 * Rabs C / (k ^ 2 * l))).
  pose proof (Rmax_r (Rmax 1 (M + 1)) (8 * Rabs C / (k ^ 2 * l))). pose proof (Rmax_l 1 (M + 1)).
  pose proof (Rmax_r 1 (M + 1)). specialize (HM t ltac:(lra)). apply Rabs_def2 in HM.
  set (D := energy m1 m2 a2 (x t) (v1 t) (v2 t) - Ecr m1 m2 a2 b) in *. assert (Ex : k ^ 2 * t ^ 2 / 4 <= exp (k * t)).
  { replace (k * t) with (k * t / 2 + k * t / 2) by field. rewrite exp_plus.
    assert (Kt : 0 < k * t) by positive. pose proof (exp_ineq1 (k * t / 2) ltac:(lra)).
    replace (k ^ 2 * t ^ 2 / 4) with (k * t / 2 * (k * t / 2)) by field. apply Rmult_le_compat; lra. }
  assert (X0 : 0 < exp (k * t)) by apply exp_pos. rewrite exp_Ropp. apply Rmult_le_reg_r with (exp (k * t)); auto.
  rewrite Rmult_assoc, Rinv_l by lra. assert (Q : 8 * Rabs C <= t * (k ^ 2 * l)).
  { apply Rmult_le_reg_r with (/ (k ^ 2 * l)); [positive|].
    replace (t * (k ^ 2 * l) * / (k ^ 2 * l)) with t by (field; split; lra). lra. }
  assert (Dp : l / 2 <= t * D) by lra. pose proof (Rle_abs C). nra.
Qed.
