(** The paper's case study, m1 = m2 = 1, a1 = 0, a2 = 200, b = 1/2: S0 ends at 5 mm. Its sentences about the start, as
    theorems: at rest at 6 mm the pair slips at once, at rest up to 5 mm it never does. *)
From InertialPair Require Import Dini Pair Stick AfterOneSlip SwitchingSurface.

(** the half width of S0 is 5 mm, 1/2 mm for b = 0.05 *)
Lemma half_width_example : L 1 1 200 (1 / 2) = 5 / 1000.
Proof. unfold L. lra. Qed.

(** [slips-from-rest] Case study, $b=0.5$: released at rest at $x_1>5$ mm every solution slips at once. *)
Theorem slips_from_rest x v1 v2 s : solution 1 1 0 200 (1 / 2) x v1 v2 s -> v1 0 = 0 -> v2 0 = 0 -> 5 / 1000 < x 0 ->
  exists T, 0 < T /\ forall t, 0 < t < T -> v1 t < v2 t.
Proof.
  intros H V1 V2 X. pose proof half_width_example as Lw. destruct (slips_beyond 1 1 200 (1 / 2) ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra) x v1 v2 s H 0) as (T & HT & K); try lra. exists T. split; auto. intros t Ht.
  specialize (K t ltac:(lra)). destruct (Rlt_dec (v1 t) (v2 t)) as [|N]; auto. exfalso. apply Rnot_lt_le in N.
  assert (0 <= x 0 * (v1 t - v2 t)) by positive. lra.
Qed.

(** [slips-from-6-mm] Case study, $b=0.5$: released at rest at 6 mm every solution slips at once. *)
Theorem six_millimetres x v1 v2 s : solution 1 1 0 200 (1 / 2) x v1 v2 s -> x 0 = 6 / 1000 -> v1 0 = 0 -> v2 0 = 0 ->
  exists T, 0 < T /\ forall t, 0 < t < T -> v1 t < v2 t.
Proof. intros H X V1 V2. apply (slips_from_rest x v1 v2 s H V1 V2). lra. Qed.

(** [sticks-from-rest] Released at rest inside $S_0$ every solution sticks permanently. *)
Theorem rest_inside m1 m2 a2 b x v1 v2 s : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> solution m1 m2 0 a2 b x v1 v2 s ->
  v1 0 = 0 -> v2 0 = 0 -> - L m1 m2 a2 b <= x 0 <= L m1 m2 a2 b -> forall t, 0 <= t -> v1 t = v2 t.
Proof.
  intros H1 H2 Ha Hb H V1 V2 X t Ht. assert (E : energy m1 m2 a2 (x 0) (v1 0) (v2 0) <= Ecr m1 m2 a2 b).
  { rewrite Ecr_L by auto. unfold energy. rewrite V1, V2. assert (x 0 ^ 2 <= L m1 m2 a2 b ^ 2) by nra.
    assert (a2 * x 0 ^ 2 <= a2 * L m1 m2 a2 b ^ 2) by nra. lra. }
  apply (sticks_iff m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H 0) with (u := t) in E; try lra. rewrite Rplus_0_l in E. exact E.
Qed.
(** [sticks-from-5-mm] Case study, $b=0.5$: released at rest up to 5 mm every solution sticks permanently. *)
Theorem five_millimetres x v1 v2 s : solution 1 1 0 200 (1 / 2) x v1 v2 s -> v1 0 = 0 -> v2 0 = 0 ->
  - (5 / 1000) <= x 0 <= 5 / 1000 -> forall t, 0 <= t -> v1 t = v2 t.
Proof.
  intros H V1 V2 X. apply (rest_inside 1 1 200 (1 / 2) x v1 v2 s); auto; try lra. rewrite half_width_example. lra.
Qed.
