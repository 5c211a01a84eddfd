(** From every contact beyond the ends of S0 the pair comes back to S0 after finitely many slips, for every mass ratio.

    Each slip that crosses S0 moves body 1 by more than 2 L, so it lasts some time, so its depth is not small,
      so it costs a fixed amount of energy. *)
From InertialPair Require Import Dini Pair Stick EnergyLimit Excursion ReturnMap FollowArc Cycle SlipFromGap
  ExitOrbit
  SharpRate AlternatingAngles.

(** t1 is the next contact after t0; t is the first contact in [-l, l] after t0, all earlier ones being crossings *)
Definition contact_after (v1 v2 : R -> R) t0 t1 := t0 < t1 /\ (forall t, t0 < t < t1 -> v1 t <> v2 t) /\ v1 t1 = v2 t1.
(** the inductive definition *)
Inductive first_reentry (l : R) (x v1 v2 : R -> R) : R -> R -> Prop :=
  | fr_in t0 t1 : contact_after v1 v2 t0 t1 -> - l <= x t1 <= l -> first_reentry l x v1 v2 t0 t1
  | fr_cross t0 t1 t : contact_after v1 v2 t0 t1 -> ~ (- l <= x t1 <= l) -> first_reentry l x v1 v2 t1 t ->
    first_reentry l x v1 v2 t0 t.
(** there is only one next contact *)
Lemma contact_unique v1 v2 t0 t1 t1' : contact_after v1 v2 t0 t1 -> contact_after v1 v2 t0 t1' -> t1 = t1'.
Proof.
  intros (A & B & C) (A' & B' & C'). destruct (Rtotal_order t1 t1') as [Lt|[|Gt]]; auto; exfalso;
    [apply (B' t1)|apply (B t1')]; auto.
Qed.

(** what a first re-entry is: a later contact in the strip *)
Lemma first_reentry_in l x v1 v2 t0 t : first_reentry l x v1 v2 t0 t -> t0 < t /\ v1 t = v2 t /\ - l <= x t <= l.
Proof.
  induction 1 as [t0 t1 (A & _ & B) I|t0 t1 t (A & _ & _) _ _ (B & C & D)]; [auto|]. split; [lra|auto].
Qed.

Section Return.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (r := m2 / (m1 + m2)) (o1 := o1 m1 a2) (L := L m1 m2 a2 b)
  (Ecr := Ecr m1 m2 a2 b) (q0 : 0 < q := q_pos m1 m2 Hm1 Hm2) (L0 : 0 < L := L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb)
  (E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) (O0 : 0 < o1 := o1_pos m1 a2 Hm1 Ha2).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Let Emono t u : 0 <= t <= u -> E u <= E t := E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t u.

(** the energy at a gap and a push *)
Lemma gap_level k d u t : k = 1 \/ k = -1 -> at_gap m1 m2 a2 b k d u x v1 v2 t ->
  E t = Ecr * (1 + q * (u ^ 2 + 2 * d + q * d ^ 2)).
Proof.
  intros Hk (A & B & C). pose proof (ray_level m1 m2 a2 b Hm1 Hm2 Ha2 u) as R. unfold E, Ecr.
  rewrite <- (energy_side m1 m2 a2 k), A, B, C by auto. rewrite Ecr_L in R |- * by auto. fold q L in R |- *.
  unfold energy in R |- *. lra.
Qed.

(** every contact beyond S0 is at some gap and some push *)
Lemma beyond_gap t : v1 t = v2 t -> ~ (- L <= x t <= L) ->
  exists k d u, (k = 1 \/ k = -1) /\ 0 < d /\ at_gap m1 m2 a2 b k d u x v1 v2 t.
Proof.
  intros Ev N. assert (K : exists k, (k = 1 \/ k = -1) /\ L < k * x t)
    by (destruct (Rlt_dec L (x t)); [exists 1|exists (-1)]; split; auto; lra). destruct K as (k & Hk & HL).
  exists k, ((k * x t / L - 1) / q), (k * v1 t * (m2 * o1) / b). split; [auto|]. split.
  - apply Rdiv_lt_0_compat; auto. assert (1 < k * x t / L); [|lra]. undivide L. lra.
  - unfold at_gap, ray. fold q L o1. rewrite Ev. repeat split; field; repeat split; lra.
Qed.

(** body 1 moves no faster than all its energy allows *)
Lemma path t u e : 0 <= t <= u -> E t <= e -> Rabs (x u - x t) <= sqrt (2 * e / m1) * (u - t).
Proof.
  intros Ht He. apply (lip_between x v1); [apply (s_cx _ _ _ _ _ _ _ _ _ H)|auto|]. intros w Hw.
  split; [apply (s_x _ _ _ _ _ _ _ _ _ H); lra|]. apply Rabs_inv, Forced.root_bound; auto.
  apply (Forced.energy_parts m1 m2 a2 Hm1 Hm2 Ha2 (x w) (v1 w) (v2 w)), Rle_trans with (2 := He), Emono. lra.
Qed.

(** so a slip that crosses has a half angle of at least this *)
Definition least_angle e := Rmin 1 (o1 * L / sqrt (2 * e / m1)).
Lemma least_angle_in e : 0 < e -> 0 < least_angle e < PI.
Proof.
  intros He. pose proof PI2_1. assert (V0 : 0 < sqrt (2 * e / m1)) by positive.
  pose proof (Rmin_l 1 (o1 * L / sqrt (2 * e / m1))). split; [|unfold least_angle; lra].
  apply Rmin_glb_lt; [lra|]. apply Rdiv_lt_0_compat; auto. positive.
Qed.
(** the way is more than 2 L *)
Lemma crossing_long k d p t0 e : k = 1 \/ k = -1 -> 0 <= t0 -> 0 <= d -> 0 < p < PI -> E t0 <= e -> 0 < e ->
  at_gap m1 m2 a2 b k d (push d p) x v1 v2 t0 -> 2 / q < depth p + d -> least_angle e <= p.
Proof.
  intros Hk Ht Hd Hp He Hep HG HD. assert (T0 : 0 < 2 * p / o1) by positive.
  destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 d p Hk H Ht Hd Hp HG) as (_ & _ & A & _).
  destruct HG as (A0 & _). fold o1 q L in A, A0. pose proof (path t0 (t0 + 2 * p / o1) e ltac:(lra) He) as P.
  set (t1 := t0 + 2 * p / o1) in *. set (V := sqrt (2 * e / m1)) in *. assert (Far : 2 * L <= Rabs (x t1 - x t0)).
  { assert (Q : 2 < q * (depth p + d)). { apply Rmult_lt_reg_l with (/ q); [positive|].
      rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l by lra. lra. }
    assert (0 <= q * d) by positive. assert (L * 2 <= L * (q * d + q * (depth p + d))) by scale.
    destruct Hk; subst k; unfold Rabs; destruct Rcase_abs; lra. }
  replace (t1 - t0) with (2 * p / o1) in P by (unfold t1; ring). fold V. apply Rle_trans with (1 := Rmin_r _ _).
  undivide V. apply Rmult_le_reg_r with (2 / o1); [positive|]. replace (o1 * L * (2 / o1)) with (2 * L) by (field; lra).
  lra.
Qed.

(** and it costs at least this *)
Definition least_cost e := Ecr * (q * r) * depth (least_angle e) ^ 2.
Lemma least_cost_pos e : 0 < e -> 0 < least_cost e.
Proof.
  intros He. apply Rmult_lt_0_compat; [|apply pow_lt, depth_pos, least_angle_in; auto].
  apply Rmult_lt_0_compat; [exact E0|positive].
Qed.
(** by the depth of at least that angle *)
Lemma crossing_costs k d p t0 e : k = 1 \/ k = -1 -> 0 <= t0 -> 0 <= d -> 0 < p < PI -> E t0 <= e -> 0 < e ->
  at_gap m1 m2 a2 b k d (push d p) x v1 v2 t0 -> 2 / q < depth p + d ->
  E (t0 + 2 * p / o1) <= E t0 - least_cost e.
Proof.
  intros Hk Ht Hd Hp He Hep HG HD. pose proof (crossing_long k d p t0 e Hk Ht Hd Hp He Hep HG HD) as Long.
  destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 d p Hk H Ht Hd Hp HG) as (_ & _ & _ & _ & _ & B).
  fold o1 q Ecr in B. pose proof (gap_level k d (push d p) t0 Hk HG) as A. rewrite level_loss in B by auto.
  fold q r in B. pose proof (least_angle_in e Hep) as P0. pose proof (depth_pos (least_angle e) P0) as D0.
  pose proof (rising_le PI depth _ _ depth_incr (proj1 P0) Long (proj2 Hp)) as D1.
  assert (D2 : depth (least_angle e) ^ 2 <= depth p * (depth p + 2 * d)).
  { assert (depth (least_angle e) ^ 2 <= depth p ^ 2) by (apply pow_incr; lra). assert (0 <= depth p * d) by positive.
    lra. }
  change (energy m1 m2 a2 (x (t0 + 2 * p / o1)) (v1 (t0 + 2 * p / o1)) (v2 (t0 + 2 * p / o1)))
    with (E (t0 + 2 * p / o1)) in B. unfold least_cost.
  assert (Ecr * (q * r) * depth (least_angle e) ^ 2 <= Ecr * (q * r) * (depth p * (depth p + 2 * d))) by scale. lra.
Qed.

(** the next contact after a slip *)
Lemma slip_contact k d p t0 : k = 1 \/ k = -1 -> 0 <= t0 -> 0 <= d -> 0 < p < PI ->
  at_gap m1 m2 a2 b k d (push d p) x v1 v2 t0 -> contact_after v1 v2 t0 (t0 + 2 * p / o1).
Proof.
  intros Hk Ht Hd Hp HG. assert (T0 : 0 < 2 * p / o1) by positive.
  destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 d p Hk H Ht Hd Hp HG) as (_ & Sg & _ & B & C &
    _).
  fold o1 in Sg, B, C. split; [lra|]. split; [intros t Hu E'; specialize (Sg t Hu); rewrite E' in Sg;
    lra|destruct Hk; subst k; lra].
Qed.

(** so crossings end: by induction on how many the energy can still pay *)
Lemma returns_paid e n : 0 < e -> forall k d u t0, k = 1 \/ k = -1 -> 0 <= t0 -> (0 < d \/ (d = 0 /\ 0 < u)) ->
  at_gap m1 m2 a2 b k d u x v1 v2 t0 -> E t0 <= e -> E t0 < INR n * least_cost e -> exists t,
    first_reentry L x v1 v2 t0 t /\ t <= t0 + INR n * (2 * PI / o1).
Proof.
  intros Hep. induction n as [|n IH]; intros k d u t0 Hk Ht Hd HG He En.
  { pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x t0) (v1 t0) (v2 t0)). unfold E in *. simpl in En. lra. }
  destruct (push_at d u Hd) as (p & Hp & <-). assert (D0 : 0 <= d) by lra. pose proof (pos_INR n).
  pose proof (slip_contact k d p t0 Hk Ht D0 Hp HG) as Ct. rewrite S_INR in *.
  assert (T1 : 0 < 2 * p / o1 <= 2 * PI / o1) by (split; [positive|scale; lra]).
  destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 d p Hk H Ht D0 Hp HG) as (_ & _ & A & _).
  fold o1 L q in A. set (t1 := t0 + 2 * p / o1) in *. destruct (Rle_dec (depth p + d) (2 / q)) as [In|Out].
  { exists t1. split; [apply fr_in; [auto|]|unfold t1; nra].
    exact (lands m1 m2 a2 b Hm1 Hm2 Ha2 Hb k _ d p Hk D0 Hp A In). }
  apply Rnot_le_lt in Out. pose proof (crossing_costs k d p t0 e Hk Ht D0 Hp He Hep HG Out) as Drop.
  fold t1 in Drop. pose proof (least_cost_pos e Hep) as Cost. assert (T1' : 0 <= t1) by (unfold t1; lra).
  destruct (crossing m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 d p Hk H Ht D0 Hp HG Out) as (D' & _ & G' & _).
  fold q o1 in D', G'. fold t1 in G'.
  destruct (IH (- k) _ _ t1 ltac:(lra) T1' (or_introl D') G' ltac:(lra) ltac:(lra)) as (t & F & Soon).
  exists t. split; [|unfold t1 in Soon; lra]. apply fr_cross with t1; auto. intros I.
  destruct G' as (X1 & _). fold q L in X1. assert (0 < L * (q * (depth p + d - 2 / q))) by positive.
  destruct Hk; subst k; lra.
Qed.

(** [first-re-entry] From beyond $S_0$, or from an exit ray, a solution returns to $S_0$ after finitely many slips,
    for every mass ratio. *)
Theorem returns k d u t0 : k = 1 \/ k = -1 -> 0 <= t0 -> (0 < d \/ (d = 0 /\ 0 < u)) ->
  at_gap m1 m2 a2 b k d u x v1 v2 t0 -> exists t, first_reentry L x v1 v2 t0 t.
Proof.
  intros Hk Ht Hd HG. pose proof (gap_level k d u t0 Hk HG) as A. assert (Ep : 0 < E t0).
  { rewrite A. apply Rmult_lt_0_compat; [exact E0|]. assert (0 <= q * (u ^ 2 + 2 * d + q * d ^ 2)) by positive. lra. }
  pose proof (least_cost_pos (E t0) Ep) as C. destruct (nat_above (E t0) _ C) as (n & Hn).
  destruct (returns_paid (E t0) n Ep k d u t0) as (t & F & _); auto; try lra. exists t; auto.
Qed.
End Return.
