(** Long and short slips alternate, for solutions; a short slip that ends in S0 stays above E_cr if 1 - 2 h k < q
    h^2. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap TurningFunction Cycle MergingAngles SlipFromGap
  AlternatingAngles AfterOneSlip.
From InertialPair Require ExcursionShape.

(** (c), the algebra: the level is a quadratic in D; its least value is positive if 1 - 2 h k < q h^2 *)
Lemma level_pos m1 m2 p d : 0 < m1 -> 0 < m2 -> 1 - 2 * hh p * ct p < m1 / (m1 + m2) * hh p ^ 2 -> 0 < level m1 m2 p d.
Proof.
  intros H1 H2 Hc. assert (Q : 0 < m1 / (m1 + m2)) by positive. unfold level. set (q := m1 / (m1 + m2)) in *.
  set (D := depth p + d). set (h := hh p) in *. set (k := ct p) in *. assert (W : 0 < k ^ 2 + q) by nra.
  apply Rmult_lt_reg_l with (k ^ 2 + q); auto. pose proof (pow2_ge_0 ((k ^ 2 + q) * D - (1 - h * k))). lra.
Qed.

(** [alternation] Where the longest slip from a ray that ends in $S_0$ has an angle $2\varphi_c\geqslant 4\pi/3$: a
    crossing slip at least that long is followed by one of at most $2\pi-2\varphi_c$, and a crossing slip of at most
    that by one at least as long as the longest. *)
Theorem alternation m1 m2 a2 b x v1 v2 s k t0 d p pc : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> let q := m1 / (m1 + m2) in
  PI / 2 < pc < PI -> depth pc = 2 / q -> / sqrt 3 <= - ct pc ->
  k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> 0 <= d -> 0 < p < PI ->
  at_gap m1 m2 a2 b k d (push d p) x v1 v2 t0 -> 2 / q < depth p + d ->
  let t1 := t0 + 2 * p / o1 m1 a2 in let d' := depth p + d - 2 / q in
  exists p', 0 < p' < PI /\ 0 < d' /\ at_gap m1 m2 a2 b (- k) d' (push d' p') x v1 v2 t1 /\
    (pc <= p -> p' <= PI - pc) /\ (p <= PI - pc -> pc <= p').
Proof.
  intros H1 H2 Ha Hb q Hpc Dc HK Hk H Ht Hd Hp HG HD t1 d'.
  destruct (crossing m1 m2 a2 b H1 H2 Ha Hb k x v1 v2 s t0 d p Hk H Ht Hd Hp HG HD)
    as (D0 & _ & G & _ & p' & Hp' & E & _). rewrite <- E in G. exists p'. repeat (split; [auto; fail|]).
  assert (HP : 0 <= Pf pc) by (apply P_sign; auto). split; intros I.
  - exact (long_to_short q pc Hpc Dc d p p' HP Hd (conj I (proj2 Hp)) Hp' E).
  - exact (short_to_long q pc Hpc Dc d p p' HP (conj (proj1 Hp) I) (Rlt_le _ _ HD) Hp' E).
Qed.

(** from a ray only a long slip crosses *)
Lemma crosses_long q p pc : 0 < pc < PI -> depth pc = 2 / q -> 0 < p < PI -> (2 / q < depth p <-> pc < p).
Proof. intros Hpc <- Hp. apply (rising_iff PI depth pc p depth_incr Hpc Hp). Qed.

(** pc exists, between pi/2 and pi *)
Lemma pc_ex q : 0 < q < 1 -> exists pc, PI / 2 < pc < PI /\ depth pc = 2 / q.
Proof.
  intros Hq. destruct (ExcursionShape.depth_ex (2 / q)) as (p & Hp & E); [positive|]. exists p.
  pose proof PI_RGT_0. assert (D : depth (PI / 2) = 2) by (unfold depth; rewrite sin_PI2, cos_PI2; field).
  assert (1 < / q) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
  assert (PI / 2 < p) by (apply (proj2 (rising_iff PI depth (PI / 2) p depth_incr ltac:(lra) Hp)); lra).
  split; [lra|auto].
Qed.
