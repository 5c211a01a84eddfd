(** One excursion from an exit ray: h increases on (0, 2 pi), so each push has one slip angle; and the trigonometric
    inequalities in the half angle that bound its depth. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini.

(** pi, from seven terms of Leibniz's series *)
Lemma pi_below : PI <= 10 / 3.
Proof. pose proof (proj2 (PI_ineq 3)) as Q. unfold tg_alt, PI_tg in Q. simpl in Q. lra. Qed.

(** a smooth function, 0 at 0, with derivative >= 0 on [0, p) *)
Lemma from_zero (f f' : R -> R) p : (forall u, is_derive f u (f' u)) -> (forall u, 0 <= u < p -> 0 <= f' u) ->
  f 0 = 0 ->
  forall u, 0 <= u <= p -> 0 <= f u.
Proof.
  intros D S Z u Hu. assert (- f u <= - f 0); [|lra].
  apply (rderiv_mono (fun t => - f t) 0 u (fun t => -1 * f' t)); [|lra|].
  - apply cont_of_derive with (fun t => - f' t). intros t. apply (is_derive_opp f t). apply D.
  - intros t Ht. split; [|specialize (S t ltac:(lra)); lra]. apply rderiv_ext with (fun t => -1 * f t); [intros; ring|].
    apply rderiv_scal, rderiv_of_derive, D.
Qed.

Lemma sin_pos u : 0 <= u <= PI -> 0 <= sin u. Proof. intros; apply sin_ge_0; lra. Qed.

Lemma pow2e (z : R) : z ^ 2 = z * z. Proof. ring. Qed.
Lemma pow3e (z : R) : z ^ 3 = z * z * z. Proof. ring. Qed.
Ltac circle t := let SC := fresh "SC" in assert (SC : sin t * sin t + cos t * cos t = 1) by exact (sin2_cos2 t);
  set (s := sin t) in *; set (c := cos t) in *; clearbody s c; rewrite ?pow2e, ?pow3e.
(** an identity in sin p > 0 and cos p, by sin^2 + cos^2 = 1 *)
Ltac trig p := let S := fresh in let SC := fresh in
  assert (S : 0 < sin p) by (apply sin_gt_0; lra); pose proof (sin2_cos2 p : sin p * sin p + cos p * cos p = 1) as SC;
  clear - S SC; set (s := sin p) in *; set (c := cos p) in *; clearbody s c;
  first [field_simplify_eq; [simpl; nsatz|lra]|simpl; nsatz].
Ltac der := intros; auto_derive; [auto|ring].
Ltac dern := let t := fresh "t" in intros t; auto_derive; [auto|]; rewrite ?cos_2a_cos, ?sin_2a; circle t; nsatz.
Ltac zero := cbv beta; rewrite ?sin_0, ?cos_0; ring.

Lemma sin_below u : 0 <= u -> sin u <= u.
Proof.
  intros Hu. cut (0 <= u - sin u); [lra|].
  apply (from_zero (fun u => u - sin u) (fun u => 1 - cos u) u); [der| |zero|lra].
  intros t _. pose proof (COS_bound t); lra.
Qed.

(** sin u >= u - u^3/6 *)
Lemma sin_above u : 0 <= u <= PI -> u - u ^ 3 / 6 <= sin u.
Proof.
  intros Hu. cut (0 <= sin u - (u - u ^ 3 / 6)); [lra|].
  apply (from_zero (fun u => sin u - (u - u ^ 3 / 6)) (fun u => cos u - (1 - u ^ 2 / 2)) PI); auto.
  - intros t; auto_derive; auto. field.
  - intros t Ht. pose proof (sin_below (t / 2) ltac:(lra)). replace t with (2 * (t / 2)) at 1 by field.
    rewrite cos_2a_sin. pose proof (sin_pos (t / 2) ltac:(lra)). nra.
  - rewrite sin_0. field.
Qed.

(** g = sin - u cos *)
Lemma g_nonneg u : 0 <= u <= PI -> 0 <= sin u - u * cos u.
Proof.
  apply (from_zero (fun u => sin u - u * cos u) (fun u => u * sin u) PI); auto; [der| |zero].
  intros t Ht. apply Rmult_le_pos; [lra|apply sin_pos; lra].
Qed.
Lemma g_pos u : 0 < u < PI -> 0 < sin u - u * cos u.
Proof.
  intros Hu. apply Rle_lt_trans with (sin (u / 2) - u / 2 * cos (u / 2)). { apply g_nonneg; lra. }
  apply (incr_function (fun u => sin u - u * cos u) 0 PI (fun u => u * sin u)); try (simpl; lra); [der|].
  intros t Ht0 Ht1; simpl in Ht0, Ht1. apply Rmult_lt_0_compat; auto. apply sin_gt_0; auto.
Qed.
(** 2 - 2 cos u - u sin u >= 0, the numerator of h' *)
Lemma N_nonneg u : 0 <= u <= 2 * PI -> 0 <= 2 - 2 * cos u - u * sin u.
Proof.
  intros Hu. replace u with (2 * (u / 2)) by field. rewrite cos_2a_sin, sin_2a.
  pose proof (g_nonneg (u / 2) ltac:(lra)). pose proof (sin_pos (u / 2) ltac:(lra)). nra.
Qed.

(** *** h increases on (0, 2 pi) *)
Definition h u := (u - sin u) / (1 - cos u).
Lemma one_cos u : 0 < u < 2 * PI -> 0 < 1 - cos u.
Proof.
  intros Hu. replace u with (2 * (u / 2)) by field. rewrite cos_2a_sin.
    pose proof (sin_gt_0 (u / 2) ltac:(lra) ltac:(lra)). nra.
Qed.
(** the numerator of h' is positive inside *)
Lemma N_pos u : 0 < u < 2 * PI -> 0 < 2 - 2 * cos u - u * sin u.
Proof.
  intros Hu. pose proof (g_pos (u / 2) ltac:(lra)). pose proof (sin_gt_0 (u / 2) ltac:(lra) ltac:(lra)).
  replace u with (2 * (u / 2)) by field. rewrite cos_2a_sin, sin_2a. nra.
Qed.
Lemma h_rate u : 0 < u < 2 * PI -> is_derive h u ((2 - 2 * cos u - u * sin u) / (1 - cos u) ^ 2).
Proof.
  intros Hu. pose proof (one_cos u Hu). unfold h. auto_derive; [lra|].
  replace (2 - 2 * cos u - u * sin u) with ((1 - cos u) * (1 - cos u) - (u - sin u) * sin u) by (circle u; nsatz).
  field. lra.
Qed.
(** [h-increases] $h$ increases on $(0,2\pi)$: no two slip angles have the same exit speed. *)
Theorem h_increases u v : 0 < u -> u < v -> v < 2 * PI -> h u < h v.
Proof.
  apply (incr_function h 0 (2 * PI) (fun t => (2 - 2 * cos t - t * sin t) / (1 - cos t) ^ 2)); try (simpl; lra); intros
    t T0 T1; simpl in T0, T1; [apply h_rate; lra|]. apply Rdiv_lt_0_compat; [apply N_pos|apply pow_lt, one_cos]; lra.
Qed.

(** *** inequalities in the half angle *)
Lemma cusa u : 0 <= u <= 2 * PI -> 3 * sin u <= u * (2 + cos u).
Proof.
  intros. cut (0 <= u * (2 + cos u) - 3 * sin u); [lra|].
  apply (from_zero (fun u => u * (2 + cos u) - 3 * sin u) (fun u => 2 - 2 * cos u - u * sin u) (2 * PI)); auto;
    [der| |zero].
  intros; apply N_nonneg; lra.
Qed.
Lemma A_nonneg p : 0 <= p -> 0 <= p - sin p * cos p.
Proof.
  intros. pose proof (sin_below (2 * p) ltac:(lra)) as Q. rewrite sin_2a in Q. lra.
Qed.
Lemma A_pos p : 0 < p < PI -> 0 < p - sin p * cos p.
Proof.
  intros Hp. apply Rle_lt_trans with (p / 2 - sin (p / 2) * cos (p / 2)). { apply A_nonneg; lra. }
  apply (incr_function (fun u => u - sin u * cos u) 0 PI (fun u => 2 * sin u ^ 2)); try (simpl; lra).
  - intros t _ _. revert t. dern.
  - intros t Ht0 Ht1; simpl in Ht0, Ht1. pose proof (sin_gt_0 t Ht0 Ht1). nra.
Qed.
(** p - sin p cos p <= (2/3) p^3 *)
Lemma A_above p : 0 <= p <= PI -> p - sin p * cos p <= 2 / 3 * p ^ 3.
Proof.
  intros. cut (0 <= 2 * p ^ 3 - 3 * (p - sin p * cos p)); [lra|].
  apply (from_zero (fun p => 2 * p ^ 3 - 3 * (p - sin p * cos p)) (fun p => 6 * (p ^ 2 - sin p ^ 2)) PI); auto.
  - dern.
  - intros t Ht. pose proof (sin_below t ltac:(lra)). pose proof (sin_pos t ltac:(lra)). nra.
  - zero.
Qed.
(** sin^3 p <= 3 (sin p - p cos p) *)
Lemma g_above_cube p : 0 <= p <= PI -> sin p ^ 3 <= 3 * (sin p - p * cos p).
Proof.
  intros. cut (0 <= 3 * (sin p - p * cos p) - sin p ^ 3); [lra|].
  apply (from_zero (fun p => 3 * (sin p - p * cos p) - sin p ^ 3) (fun p => 3 * sin p * (p - sin p * cos p)) PI); auto.
  - dern.
  - intros t Ht. apply Rmult_le_pos; [pose proof (sin_pos t ltac:(lra)); lra|apply A_nonneg; lra].
  - zero.
Qed.
(** the inequality behind the lower bound of the depth *)
Lemma depth_above p : 0 <= p <= PI -> 4 * (sin p - p * cos p) * sin p ^ 3 <= 3 * (p - sin p * cos p) ^ 2.
Proof.
  intros. cut (0 <= 3 * (p - sin p * cos p) ^ 2 - 4 * (sin p - p * cos p) * sin p ^ 3); [lra|].
  apply (from_zero (fun p => 3 * (p - sin p * cos p) ^ 2 - 4 * (sin p - p * cos p) * sin p ^ 3)
    (fun p => 4 * sin p ^ 2 * (2 * p + p * 2 * cos (2 * p) + 2 * p - 3 * sin (2 * p))) PI); auto.
  - dern.
  - intros t Ht. apply Rmult_le_pos. { positive. } pose proof (cusa (2 * t) ltac:(lra)). lra.
  - zero.
Qed.
