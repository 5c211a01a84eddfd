(** Where merging at the first landing is possible (m1/m2 <= - cos (2 phi* )), kappa_c >= 1/sqrt 3: so long and short
    slips alternate there. *)
From Interval Require Import Tactic.
From InertialPair Require Import Dini Excursion ReturnMap TurningFunction SlipFromGap AlternatingAngles.

(** phi* is above 1.89 *)
Lemma root_above ps : 0 < ps <= PI -> K ps = 0 -> 189 / 100 < ps.
Proof.
  intros Hp Z. destruct root as (p & Hp' & Zp & Le & Ri).
  assert (189 / 100 <= PI) by (interval with (i_prec 60)).
  assert (0 < K (189 / 100)) by (unfold K; interval with (i_prec 60)). apply Rnot_le_lt. intros N.
  assert (189 / 100 < p) by (apply Rnot_le_lt; intros [M|M]; [specialize (Ri (189 / 100))|rewrite M in Zp];
    lra).
  specialize (Le ps ltac:(lra)). lra.
Qed.

(** [kappa-large] Where merging is possible, the longest slip that ends in $S_0$ is longer than the angle $4\pi/3$. *)
Theorem kappa_large m1 m2 ps pc : 0 < m1 -> 0 < m2 -> 0 < ps < PI -> K ps = 0 -> m1 / m2 <= - cos (2 * ps) ->
  PI / 2 < pc < PI -> depth pc = 2 / (m1 / (m1 + m2)) -> / sqrt 3 < - ct pc.
Proof.
  intros H1 H2 Hps Z Hr Hpc Dc. pose proof (root_above ps ltac:(lra) Z) as A.
  assert (C : cos ps <= cos (189 / 100)) by (apply Rlt_le, cos_decreasing_1; lra).
  assert (C0 : cos (189 / 100) <= - 31 / 100) by (interval with (i_prec 60)). rewrite cos_2a_cos in Hr.
  assert (R1 : m1 / m2 <= 81 / 100) by nra. assert (R2 : m1 <= 81 / 100 * m2).
  { apply Rmult_le_reg_r with (/ m2); [positive|]. replace (81 / 100 * m2 * / m2) with (81 / 100) by (field; lra).
    exact R1. }
  assert (Q : 446 / 100 <= depth pc).
  { rewrite Dc. replace (2 / (m1 / (m1 + m2))) with (2 + 2 * (m2 / m1)) by (field; lra).
    assert (100 / 81 <= m2 / m1). { undivide m1. lra. } lra. }
  assert (D3 : depth (2 * (PI / 3)) < 446 / 100) by (interval with (i_prec 60)). assert (G : 2 * (PI / 3) < pc).
  { apply Rnot_le_lt. intros N.
    pose proof (rising_le PI depth pc (2 * (PI / 3)) depth_incr ltac:(lra) N ltac:(lra)). lra. }
  pose proof (ct_falls (2 * (PI / 3)) pc ltac:(lra) G ltac:(lra)) as F. rewrite ct_2PI3 in F. lra.
Qed.
