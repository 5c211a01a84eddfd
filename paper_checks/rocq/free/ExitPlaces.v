(** The places of exits and entries of a solution that never merges: every exit is at an end of S0, the entry after it
    tends to the same end, and the speeds at both tend to 0. *)
From InertialPair Require Import Dini Pair Stick EnergyLimit Excursion ReturnMap OneOverT ReturnToS0 SwitchingSurface.

(** a sequence whose squares tend to 0 tends to 0 *)
Lemma from_squares u : is_lim_seq (fun n => u n ^ 2) 0 -> is_lim_seq u 0.
Proof.
  intros S. apply is_lim_seq_abs_0. apply is_lim_seq_ext with (fun n => sqrt (u n ^ 2)).
  { intros n. rewrite <- (sqrt_Rsqr_abs (u n)). f_equal. unfold Rsqr. ring. }
  rewrite <- sqrt_0. apply is_lim_seq_continuous; [apply continuity_pt_sqrt; lra|exact S].
Qed.

Section Ends.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Hypothesis up : forall t, 0 <= t -> Ecr < E t.

(** along times that go to infinity the energy tends to E_cr *)
Lemma energy_along t : is_lim_seq t p_infty -> is_lim_seq (fun n => E (t n)) Ecr.
Proof.
  intros T. apply is_lim_seq_spec. intros e. destruct e as (e & He). simpl.
  destruct (dichotomy_energy m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H) as [(T0 & HT & Lo)|(_ & Lim)].
  { specialize (up T0 HT). unfold E in up. fold Ecr in Lo. lra. }
  destruct (Lim (e / 2) ltac:(lra)) as (T0 & HT & K). fold Ecr in K. apply is_lim_seq_spec in T.
  destruct (T T0) as (N & HN). exists N. intros n Hn. specialize (HN n Hn). specialize (K (t n) ltac:(lra)).
  specialize (up (t n) ltac:(lra)). unfold E in *. apply Rabs_def1; lra.
Qed.

(** contacts that tend to the ends of S0 tend to rest *)
Lemma rest_along t : is_lim_seq t p_infty -> (forall n, v1 (t n) = v2 (t n)) ->
  is_lim_seq (fun n => Rabs (x (t n))) L ->
  is_lim_seq (fun n => v1 (t n)) 0.
Proof.
  intros T C X. apply from_squares. set (M := m1 + m2). assert (M0 : 0 < M) by positive.
  apply is_lim_seq_ext with (fun n => 2 / M * E (t n) - a2 / M * (Rabs (x (t n)) * Rabs (x (t n)))).
  { intros n. replace (Rabs (x (t n)) * Rabs (x (t n))) with (x (t n) ^ 2) by (unfold Rabs; destruct Rcase_abs; ring).
    unfold E, energy. rewrite <- (C n). unfold M. field. lra. }
  replace 0 with (2 / M * Ecr - a2 / M * (L * L)) by (unfold Ecr; rewrite Ecr_L by auto; fold L; field; lra).
  apply is_lim_seq_minus'.
  - apply (is_lim_seq_scal_l _ (2 / M) Ecr). apply energy_along; auto.
  - apply (is_lim_seq_scal_l _ (a2 / M) (L * L)). apply is_lim_seq_mult'; auto.
Qed.

(** [exits-near-endpoints] A solution that never merges leaves $S_0$ exactly where $|x_1|=L$; its entries tend to
    $|x_1|=L$, and the velocities at both to 0. *)
Theorem exits_near_endpoints : exists te tau : nat -> R,
  (forall n, 0 <= te n < tau n) /\ (forall n, tau n < te (S n)) /\ is_lim_seq te p_infty /\
  (forall n t, te n <= t <= tau n -> v1 t = v2 t /\ - L <= x t <= L) /\ (forall n t, tau n < t < te (S n) ->
    v1 t <> v2 t) /\
  (forall n, Rabs (x (tau n)) = L) /\ is_lim_seq (fun n => x (te (S n)) - x (tau n)) 0 /\
  is_lim_seq (fun n => v1 (tau n)) 0 /\ is_lim_seq (fun n => v1 (te (S n))) 0.
Proof.
  destruct (times m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H up) as (te & tau & O1 & O2 & TI & St & Off & _ & Sl).
  exists te, tau. do 5 (split; [assumption|]). assert (Con : forall n, v1 (tau n) = v2 (tau n) /\ - L <= x (tau n) <= L)
    by (intros n; apply (St n); pose proof (O1 n); lra). assert (En : forall n, v1 (te n) = v2 (te n) /\ - L <= x (te n)
    <= L) by (intros n; apply (St n); pose proof (O1 n); lra). assert (Ex : forall n, Rabs (x (tau n)) = L).
  { intros n. destruct (Con n) as (Ev & Hx). apply Classical_Prop.NNPP. intros N.
    assert (Nl : x (tau n) <> L) by (intros Q; apply N; rewrite Q; apply Rabs_pos_eq; lra).
    assert (Nr : x (tau n) <> - L) by (intros Q; apply N; rewrite Q, Rabs_Ropp; apply Rabs_pos_eq; lra).
    pose proof (O1 n). pose proof (O2 n).
    destruct (sticks_inside m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H (tau n) ltac:(lra) Ev Hx) as (T & HT & K);
      [intros Q; contradiction|intros Q; contradiction|].
    set (d := Rmin T (te (S n) - tau n)). assert (Hd : 0 < d) by positive.
    pose proof (Rmin_l T (te (S n) - tau n)). pose proof (Rmin_r T (te (S n) - tau n)). fold d in H2, H3.
    apply (Off n (tau n + d / 2)); [lra|]. apply K. lra. }
  assert (Df : is_lim_seq (fun n => x (te (S n)) - x (tau n)) 0).
  { set (V := sqrt (2 * E 0 / m1)). apply lim_within with (fun n => V * (te (S n) - tau n)).
    - intros n. rewrite Rminus_0_r. pose proof (O1 n). pose proof (O2 n).
      apply (path m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H (tau n) (te (S n)) (E 0)); [lra|].
      apply (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H). lra.
    - rewrite <- (Rmult_0_r V). apply (is_lim_seq_scal_l _ V 0). exact Sl. }
  split; [exact Ex|]. split; [exact Df|]. split.
  - apply rest_along; [|intros n; apply Con|].
    + apply is_lim_seq_le_p_loc with te; auto. exists O. intros n _. pose proof (O1 n). lra.
    + apply is_lim_seq_ext with (fun _ => L); [intros n; rewrite Ex; auto|apply is_lim_seq_const].
  - apply (rest_along (fun n => te (S n))); [|intros n; apply En|].
    + apply (is_lim_seq_incr_1 te). exact TI.
    + apply lim_within with (fun n => Rabs (x (te (S n)) - x (tau n))).
      * intros n. rewrite <- (Ex n). apply Rabs_triang_inv2.
      * apply (proj1 (is_lim_seq_abs_0 _)), Df.
Qed.
End Ends.
