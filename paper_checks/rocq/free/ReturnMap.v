(** Orbits of the return map y' = h^2 - r c^2: y_n -> 0 and n y_n -> 4/(9 r). *)
From InertialPair Require Import Dini Excursion.

Definition hh p := (p - sin p * cos p) / sin p ^ 2.          (* h in the half angle *)
Definition depth p := 2 * (sin p - p * cos p) / sin p.       (* c = 2 - theta cot(theta/2) *)

Lemma hh_h p : 0 < p < PI -> hh p = h (2 * p).
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). unfold hh, h. rewrite cos_2a_sin, sin_2a. field. nra.
Qed.
Lemma hh_incr p q : 0 < p -> p < q -> q < PI -> hh p < hh q.
Proof. intros. rewrite !hh_h by lra. apply h_increases; lra. Qed.
Lemma hh_pos p : 0 < p < PI -> 0 < hh p.
Proof. intros Hp. apply Rdiv_lt_0_compat; [apply A_pos; auto|]. apply pow_lt, sin_gt_0; lra. Qed.
(** as its square does *)
Lemma hh_sq p q : 0 < p < PI -> 0 < q < PI -> (hh p ^ 2 < hh q ^ 2 <-> p < q).
Proof.
  intros Hp Hq. pose proof (hh_pos p Hp). pose proof (hh_pos q Hq).
  rewrite <- (proj2 (rising_iff PI hh p q hh_incr Hp Hq)).
  split; intros; nra.
Qed.
Lemma depth_pos p : 0 < p < PI -> 0 < depth p.
Proof. intros Hp. apply Rdiv_lt_0_compat; [pose proof (g_pos p Hp); lra|apply sin_gt_0; lra]. Qed.

(** h >= (2/3) p *)
Lemma hh_below p : 0 < p < PI -> 2 / 3 * p <= hh p.
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (cusa (2 * p) ltac:(lra)) as C.
  rewrite sin_2a, cos_2a_sin in C. undivide (sin p ^ 2). nra.
Qed.

(** [depth-upper] The depth of an excursion is at most $\tfrac{3}{2}h^2$. *)
Theorem depth_upper p : 0 < p < PI -> depth p <= 3 / 2 * hh p ^ 2.
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (depth_above p ltac:(lra)) as Q.
  unfold depth, hh. apply Rmult_le_reg_r with (2 * sin p ^ 4). { positive. }
  replace (2 * (sin p - p * cos p) / sin p * (2 * sin p ^ 4)) with (4 * (sin p - p * cos p) * sin p ^ 3)
    by (field; lra). replace (3 / 2 * ((p - sin p * cos p) / sin p ^ 2) ^ 2 * (2 * sin p ^ 4))
    with (3 * (p - sin p * cos p) ^ 2) by (field; lra). auto.
Qed.

(** [depth-lower] The depth of an excursion is at least $\tfrac{3}{2}(\sin\varphi/\varphi)^6h^2$. *)
Theorem depth_lower p : 0 < p < PI -> 3 / 2 * (sin p / p) ^ 6 * hh p ^ 2 <= depth p.
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_above_cube p ltac:(lra)) as G.
  pose proof (A_above p ltac:(lra)) as A. pose proof (A_pos p Hp) as Ap. assert (D : 2 / 3 * sin p ^ 2 <= depth p).
  { undivide (sin p). lra. }
  apply Rle_trans with (2 := D). assert (P2 : (p - sin p * cos p) ^ 2 <= (2 / 3 * p ^ 3) ^ 2) by nra.
  unfold hh. replace (3 / 2 * (sin p / p) ^ 6 * ((p - sin p * cos p) / sin p ^ 2) ^ 2) with (3 / 2 * (sin p ^ 2 / p ^ 6)
    * (p - sin p * cos p) ^ 2) by (field; lra).
  replace (2 / 3 * sin p ^ 2) with (3 / 2 * (sin p ^ 2 / p ^ 6) * (2 / 3 * p ^ 3) ^ 2) by (field; lra).
  apply Rmult_le_compat_l; auto. positive.
Qed.

(** sin p/p decreases strictly *)
Lemma sinc_strict p q : 0 < p -> p < q -> q < PI -> sin q / q < sin p / p.
Proof.
  intros Hp Hpq Hq. apply Ropp_lt_cancel.
  apply (climbs (fun u => - (sin u / u)) (fun u => (sin u - u * cos u) / u ^ 2)); [lra| |]; intros t Ht.
  - auto_derive; [lra|]. field; lra.
  - apply Rdiv_lt_0_compat; [apply g_pos; lra|positive].
Qed.
Lemma sinc_decr p q : 0 < p -> p <= q -> q < PI -> sin q / q <= sin p / p.
Proof. intros Hp [L|<-] Hq; [apply Rlt_le, sinc_strict|]; lra. Qed.
Lemma sinc_pos p : 0 < p < PI -> 0 < sin p / p.
Proof. intros. apply Rdiv_lt_0_compat; [apply sin_gt_0|]; lra. Qed.

(** *** The half slip angle as a function of the exit speed: the inverse of hh *)
Lemma sin_half p : 0 < p <= PI / 2 -> p / 2 <= sin p.
Proof.
  intros Hp. pose proof (sinc_decr p (PI / 2) ltac:(lra) ltac:(lra) ltac:(lra)) as Q. rewrite sin_PI2 in Q.
    pose proof PI_4.
  assert (1 / 2 <= 1 / (PI / 2)).
  { undivide (PI / 2). lra. }
  assert (sin p / p * p = sin p) by (field; lra). nra.
Qed.

(** a sequence is on average what its steps tend to *)
Lemma steps_mean (u : nat -> R) (l : R) : is_lim_seq (fun n => u (S n) - u n) l -> is_lim_seq (fun n => u n / INR n) l.
Proof.
  intros D. assert (Sum : forall n, u (S n) = u O + sum_f_R0 (fun n => u (S n) - u n) n).
  { induction n as [|n IH]; simpl; [ring|]. rewrite <- Rplus_assoc, <- IH. ring. }
  assert (Z : is_lim_seq (fun n => u O * / INR n) 0).
  { replace (Finite 0) with (Rbar_mult (u O) 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l.
    assert (Q := is_lim_seq_inv _ _ is_lim_seq_INR). apply Q. discriminate. }
  assert (C : is_lim_seq (fun n => sum_f_R0 (fun n => u (S n) - u n) (pred n) / INR n) l) by (apply is_lim_seq_Reals,
    Cesaro_1, is_lim_seq_Reals, D). replace (Finite l) with (Finite (0 + l)) by (f_equal; ring).
  apply is_lim_seq_ext_loc with (2 := is_lim_seq_plus' _ _ _ _ Z C). exists 1%nat. intros n Hn.
  destruct n; [inversion Hn|]. rewrite Sum. simpl pred. field. apply not_0_INR; discriminate.
Qed.

(** and n steps go between n times their bounds *)
Lemma steps_between (u : nat -> R) lo hi : (forall n, lo <= u (S n) - u n <= hi) ->
  forall n, INR n * lo <= u n - u O <= INR n * hi.
Proof. intros D n. induction n as [|n IH]; [simpl; lra|]. rewrite S_INR. specialize (D n). lra. Qed.

(** what is closer to l than what tends to 0 *)
Lemma lim_within (u f : nat -> R) (l : R) : (forall n, Rabs (u n - l) <= f n) -> is_lim_seq f 0 -> is_lim_seq u l.
Proof.
  intros B F. apply is_lim_seq_spec. apply is_lim_seq_spec in F. intros e. destruct (F e) as (N & K). exists N.
  intros n Hn. specialize (K n Hn). rewrite Rminus_0_r in K. apply Rle_lt_trans with (2 := K).
  apply Rle_trans with (1 := B n), Rle_abs.
Qed.

(** a limit through a smooth function *)
Lemma lim_through (g : R -> R) u (l : R) : is_lim_seq u l -> ex_derive g l -> is_lim_seq (fun n => g (u n)) (g
  l).
Proof.
  intros U D. apply (is_lim_seq_continuous g); [|exact U].
  apply continuity_pt_filterlim, (ex_derive_continuous g), D.
Qed.

Section Orbit.
Context (r : R) (Hr : 0 < r).
Context (phi : nat -> R) (Hphi : forall n, 0 < phi n < PI).
Let y n := hh (phi n) ^ 2.
Hypothesis step : forall n, y (S n) = y n - r * depth (phi n) ^ 2.
Context (kappa := 9 / 4 * r) (si := fun n => sin (phi n) / phi n).

Lemma y_pos n : 0 < y n. Proof. apply pow_lt, hh_pos; auto. Qed.
(** each excursion loses at most kappa y^2 *)
Lemma loss_upper n : y n - y (S n) <= kappa * y n ^ 2.
Proof.
  rewrite step. pose proof (depth_upper _ (Hphi n)) as D. pose proof (depth_pos _ (Hphi n)). fold (y n) in D.
  assert (depth (phi n) ^ 2 <= (3 / 2 * y n) ^ 2) by nra. unfold kappa. nra.
Qed.
Lemma loss_lower n : kappa * si n ^ 12 * y n ^ 2 <= y n - y (S n).
Proof.
  rewrite step. pose proof (depth_lower _ (Hphi n)) as D. fold (y n) (si n) in D. pose proof (y_pos n).
  pose proof (pow_lt _ 6 (sinc_pos _ (Hphi n))) as S6. assert (0 < 3 / 2 * si n ^ 6 * y n) by positive.
  assert (Q : (3 / 2 * si n ^ 6 * y n) ^ 2 <= depth (phi n) ^ 2) by nra.
  replace (kappa * si n ^ 12 * y n ^ 2) with (r * (3 / 2 * si n ^ 6 * y n) ^ 2) by (unfold kappa; field).
  assert (r * (3 / 2 * si n ^ 6 * y n) ^ 2 <= r * depth (phi n) ^ 2) by nra. lra.
Qed.
(** the level falls *)
Theorem y_falls n : y (S n) < y n.
Proof. rewrite step. pose proof (pow_lt _ 2 (depth_pos _ (Hphi n))). nra. Qed.
Lemma phi_falls n : phi (S n) <= phi n.
Proof. apply Rlt_le, hh_sq; auto. exact (y_falls n). Qed.
Lemma phi_0 n : phi n <= phi 0%nat.
Proof. induction n; [lra|]. pose proof (phi_falls n); lra. Qed.
Lemma si_0 n : si 0%nat <= si n.
Proof. pose proof (Hphi n). pose proof (Hphi 0%nat). apply sinc_decr; try lra. apply phi_0. Qed.

Let d n := / y (S n) - / y n.
(** 1/y gains at least this *)
Lemma d_lower n : kappa * si n ^ 12 <= d n.
Proof.
  pose proof (y_pos (S n)) as Y'. pose proof (loss_lower n) as Q. pose proof (y_falls n). unfold d.
  replace (/ y (S n) - / y n) with ((y n - y (S n)) / (y n * y (S n))) by (field; lra).
  apply Rmult_le_reg_r with (y n * y (S n)). { positive. }
  replace ((y n - y (S n)) / (y n * y (S n)) * (y n * y (S n))) with (y n - y (S n)) by (field; lra). nra.
Qed.
Lemma d_upper n : kappa * y n < 1 -> d n <= kappa / (1 - kappa * y n).
Proof.
  intros K. pose proof (y_pos n) as Y. pose proof (y_pos (S n)) as Y'. pose proof (loss_upper n) as Q. unfold d.
  replace (/ y (S n) - / y n) with ((y n - y (S n)) / (y n * y (S n))) by (field; lra).
  assert (P1 : 0 < y n * (1 - kappa * y n)) by positive. assert (P2 : y n * (1 - kappa * y n) <= y (S n)) by nra.
  apply Rle_trans with (kappa * y n ^ 2 / (y n * y (S n))).
  { apply Rmult_le_compat_r; auto. positive. }
  replace (kappa * y n ^ 2 / (y n * y (S n))) with (kappa * y n * / y (S n)) by (field; lra).
  replace (kappa / (1 - kappa * y n)) with (kappa * y n * / (y n * (1 - kappa * y n))) by (field; lra).
  apply Rmult_le_compat_l. { positive. } apply Rinv_le_contravar; auto.
Qed.

(** the explicit bound *)
Theorem y_bound n : / y 0%nat + INR n * (kappa * si 0%nat ^ 12) <= / y n.
Proof.
  induction n. { simpl INR. lra. } rewrite S_INR. pose proof (d_lower n) as D. unfold d in D.
  assert (si 0%nat ^ 12 <= si n ^ 12). { apply pow_incr. split; [apply Rlt_le, sinc_pos; auto|apply si_0]. }
  assert (kappa * si 0%nat ^ 12 <= kappa * si n ^ 12) by (apply Rmult_le_compat_l; [unfold kappa; lra|auto]). lra.
Qed.

(** the level tends to 0, as 1/y gains a fixed amount *)
Theorem y_to_zero : is_lim_seq y 0.
Proof.
  set (al := kappa * si 0%nat ^ 12).
  assert (Hal : 0 < al) by (apply Rmult_lt_0_compat; [unfold kappa; lra|apply pow_lt, sinc_pos; auto]).
  assert (L : is_lim_seq (fun n => / y n) p_infty).
  { apply is_lim_seq_le_p_loc with (fun n => INR n * al).
    - exists 0%nat. intros n _. pose proof (y_bound n) as Q. fold al in Q.
      pose proof (Rinv_0_lt_compat _ (y_pos 0%nat)). lra.
    - apply is_lim_seq_mult with p_infty al; [apply is_lim_seq_INR|apply is_lim_seq_const|].
      apply is_Rbar_mult_p_infty_pos. exact Hal. }
  apply is_lim_seq_ext with (fun n => / / y n). { intros n. apply Rinv_involutive. pose proof (y_pos n); lra. }
  assert (Q := is_lim_seq_inv _ _ L). apply Q. discriminate.
Qed.

Lemma root_to_zero c : is_lim_seq (fun n => c * sqrt (y n)) 0.
Proof.
  replace (Finite 0) with (Rbar_mult c (sqrt 0)) by (simpl; rewrite sqrt_0; f_equal; ring).
  apply is_lim_seq_scal_l, is_lim_seq_continuous; [apply continuity_pt_sqrt; lra|apply y_to_zero].
Qed.
Lemma phi_to_zero : is_lim_seq phi 0.
Proof.
  apply lim_within with (2 := root_to_zero (3 / 2)). intros n. pose proof (Hphi n). pose proof (hh_below _ (Hphi n)).
  unfold y. rewrite sqrt_pow2, Rminus_0_r, Rabs_pos_eq; lra.
Qed.
(** so the gain of 1/y tends to kappa *)
Lemma d_limit : is_lim_seq d kappa.
Proof.
  assert (Sl : is_lim_seq si 1).
  { apply (is_lim_comp_seq (fun x => sin x / x) phi 0 1).
    - apply is_lim_sinc_0.
    - exists 0%nat. intros n _ E. injection E. pose proof (Hphi n). lra.
    - apply phi_to_zero. }
  pose proof (lim_through (fun z => kappa * z ^ 12) si 1 Sl ltac:(auto_derive; auto)) as Lo.
  pose proof (lim_through (fun z => kappa / (1 - kappa * z)) y 0 y_to_zero ltac:(auto_derive; lra)) as Up.
  cbv beta in Lo, Up. replace (kappa * 1 ^ 12) with kappa in Lo by ring.
  replace (kappa / (1 - kappa * 0)) with kappa in Up by field.
  assert (Ev : eventually (fun n => kappa * y n < 1)).
  { pose proof (lim_through (fun z => kappa * z) y 0 y_to_zero ltac:(auto_derive; auto)) as Z.
    apply is_lim_seq_spec in Z.
    destruct (Z (mkposreal 1 Rlt_0_1)) as (n0 & K). exists n0. intros n Hn. specialize (K n Hn). simpl in K.
    apply Rabs_def2 in K. lra. }
  apply is_lim_seq_le_le_loc with (fun n => kappa * si n ^ 12) (fun n => kappa / (1 - kappa * y n)); auto.
  destruct Ev as (n0 & K). exists n0. split; [apply d_lower|apply d_upper; auto].
Qed.

(** [return-map-rate] Along the return map $n\,y_n\to 4/(9r)$. *)
Theorem sharp : is_lim_seq (fun n => INR n * y n) (4 / (9 * r)).
Proof.
  assert (L := steps_mean (fun n => / y n) kappa d_limit).
  replace (Finite (4 / (9 * r))) with (Finite (/ kappa)) by (f_equal; unfold kappa; field; lra).
  apply is_lim_seq_ext_loc with (fun n => / (/ y n / INR n)).
  - exists 1%nat. intros n Hn. pose proof (y_pos n). assert (0 < INR n) by (apply lt_0_INR; auto). field. split; lra.
  - assert (Q := is_lim_seq_inv _ _ L). apply Q. intros E. injection E. unfold kappa. lra.
Qed.
End Orbit.
