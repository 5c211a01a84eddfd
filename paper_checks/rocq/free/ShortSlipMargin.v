(** The one numerical inequality behind the merging set: a short slip that ends in S0 stays above E_cr, with the share q
    replaced by the least one at which the slip is short. By interval arithmetic away from p = 0. *)
From Interval Require Import Tactic.
From InertialPair Require Import Dini Excursion ReturnMap SlipFromGap.

(** in the middle, by interval arithmetic *)
Lemma margin_mid p : 7 / 10 <= p <= 16 / 10 ->
  0 < ((p - sin p * cos p) / (sin p * sin p)) * ((p - sin p * cos p) / (sin p * sin p))
    - (1 - 2 * ((p - sin p * cos p) / (sin p * sin p)) * (cos p / sin p)) * (1 + (PI - p) * (cos p / sin p)).
Proof. intros Hp. interval with (i_bisect p, i_taylor p, i_depth 14, i_prec 60). Qed.

(** [margin] The one numerical inequality of the merging set, enclosed in balls by the kernel. *)
Theorem margin p : 0 < p < PI / 2 -> (1 - 2 * hh p * ct p) * (1 + (PI - p) * ct p) < hh p ^ 2.
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (cos_gt_0 p ltac:(lra) ltac:(lra)) as C.
  assert (Kp : 0 < ct p) by (apply Rdiv_lt_0_compat; auto). pose proof (hh_pos p ltac:(lra)) as Hh.
  destruct (Rle_dec p (7 / 10)) as [n|n].
  - pose proof (hh_below p ltac:(lra)) as B. pose proof (sin_below p ltac:(lra)) as Sb. assert (Cb : 3 / 4 <= cos p).
    { replace p with (2 * (p / 2)) by field. rewrite cos_2a_sin. pose proof (sin_below (p / 2) ltac:(lra)).
      pose proof (sin_pos (p / 2) ltac:(lra)). nra. }
    assert (Kb : 3 / 4 <= p * ct p).
    { unfold ct. apply Rmult_le_reg_r with (sin p); auto.
      replace (p * (cos p / sin p) * sin p) with (p * cos p) by (field; lra). nra. }
    assert (1 <= 2 * hh p * ct p) by nra. assert (0 < (PI - p) * ct p) by positive. nra.
  - pose proof (margin_mid p) as M.
    assert (E : hh p = (p - sin p * cos p) / (sin p * sin p)) by (unfold hh; field; lra). rewrite <- E in M.
    fold (ct p) in M. assert (PI / 2 <= 16 / 10) by (interval with (i_prec 60)). lra.
Qed.
