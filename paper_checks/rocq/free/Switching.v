(** The paper's equations (3), (4) without a control, which switch between the two modes by three-valued signs:
    absolutely continuous functions obey them at almost all times exactly if they are a solution in Filippov's sense.
    Isolated times, such as the simple zeros of a function, are a null set. *)
From Coq Require Import Cantor.
From InertialPair Require Import Dini Pair AlmostEverywhere Filippov.

(** *** Null sets *)
(** of two one *)
Lemma null_or N P : null N -> null P -> null (fun t => N t \/ P t).
Proof.
  intros HN HP e He. destruct (HN (e / 2) ltac:(lra)) as (a & b & Ab & Ac & As).
  destruct (HP (e / 2) ltac:(lra)) as (c & d & Cb & Cc & Cs).
  set (mix := fun (f g : nat -> R) n => if Nat.even n then f (Nat.div2 n) else g (Nat.div2 n)).
  assert (Even : forall f g n, mix f g (2 * n)%nat = f n).
  { intros f g n. unfold mix. rewrite Nat.even_mul, Nat.div2_double. auto. }
  assert (Odd : forall f g n, mix f g (S (2 * n)) = g n).
  { intros f g n. unfold mix. rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul, Nat.div2_succ_double. auto. }
  assert (Le : forall i, mix a c i <= mix b d i) by (intros i; unfold mix; destruct Nat.even; auto).
  exists (mix a c), (mix b d). split; [auto|split].
  - intros t [Nt|Pt].
    + destruct (Ac t Nt) as (n & Hn). exists (2 * n)%nat. rewrite !Even. auto.
    + destruct (Cc t Pt) as (n & Hn). exists (S (2 * n)). rewrite !Odd. auto.
  - intros n. set (g := fun i => mix b d i - mix a c i).
    assert (Twice : forall m, sum_f_R0 g (S (2 * m)) = sum_f_R0 (fun i => b i - a i) m + sum_f_R0 (fun i => d i - c i)
      m).
    { induction m as [|m IH].
      - unfold g. simpl. unfold mix; simpl. ring.
      - replace (S (2 * S m)) with (S (S (S (2 * m)))) by lia. rewrite (tech5 g (S (S (2 * m)))),
        (tech5 g (S (2 * m))), IH. rewrite !tech5. unfold g.
        replace (S (S (2 * m))) with (2 * S m)%nat by lia. rewrite !Even, !Odd. ring. }
    assert (Grow : forall m k, sum_f_R0 g m <= sum_f_R0 g (m + k)).
    { intros m. induction k as [|k IH]; [rewrite Nat.add_0_r; lra|]. rewrite Nat.add_succ_r, tech5.
      specialize (Le (S (m + k))). unfold g at 3. lra. }
    pose proof (Grow n (S n)) as G. replace (n + S n)%nat with (S (2 * n)) in G by lia. rewrite Twice in G.
    specialize (As n). specialize (Cs n). lra.
Qed.

(** isolated times *)
Lemma null_isolated (E : R -> Prop) :
  (forall t, E t -> 0 <= t /\ exists d, 0 < d /\ forall r, t - d < r < t + d -> E r -> r = t) -> null E.
Proof.
  intros Iso.
  (* every cell [k w, (k + 1) w) of every width w = 1 / (i + 1) is given a point,
    which is its time if it has only one *)
  set (low := fun n => INR (snd (of_nat n)) / (INR (fst (of_nat n)) + 1)).
  set (high := fun n => (INR (snd (of_nat n)) + 1) / (INR (fst (of_nat n)) + 1)).
  set (A := fun n r => r = low n \/ (E r /\ low n <= r < high n)).
  assert (Pos : forall n, 0 < INR (fst (of_nat n)) + 1) by (intros n; pose proof (pos_INR (fst (of_nat n))); lra).
  assert (Lh : forall n, low n < high n).
  { intros n. unfold low, high. apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; auto|lra]. }
  assert (Bound : forall n, bound (A n)).
  { intros n. exists (high n). intros r [->|(_ & Hr)]; [apply Rlt_le; auto|lra]. }
  assert (Some : forall n, exists r, A n r) by (intros n; exists (low n); left; auto).
  set (p := fun n => proj1_sig (completeness (A n) (Bound n) (Some n))).
  assert (In : forall t, E t -> exists n, t = p n).
  { intros t Et. destruct (Iso t Et) as (Ht & d & Hd & Only). destruct (nfloor_ex (1 / d)) as (i & Hi); [positive|].
    pose proof (pos_INR i) as Pi. destruct (nfloor_ex (t * (INR i + 1))) as (k & Hk); [positive|].
    set (n := to_nat (i, k)). exists n. assert (Ln : low n * (INR i + 1) = INR k).
    { unfold low, n. rewrite cancel_of_to. simpl. field. lra. }
    assert (Hn : high n * (INR i + 1) = INR k + 1).
    { unfold high, n. rewrite cancel_of_to. simpl. field. lra. }
    assert (Wd : 1 < d * (INR i + 1)).
    { assert (Q : d * (1 / d) = 1) by (field; lra). rewrite <- Q at 1. scale. }
    assert (In : low n <= t < high n) by (split; nra).
    symmetry. unfold p. destruct completeness as (c & Ub & Lub). simpl. apply Rle_antisym.
    + apply Lub. intros r [->|(Er & Hr)]; [lra|]. rewrite (Only r); auto; [lra|]. nra.
    + apply Ub. right. auto. }
  intros e He. destruct (null_points p e He) as (a & b & Ab & Ac & As). exists a, b. auto.
Qed.

(** the simple zeros of a function *)
Lemma null_simple_zeros f : null (fun t => 0 <= t /\ f t = 0 /\ exists l, l <> 0 /\ is_derive f t l).
Proof.
  apply null_isolated. intros t (Ht & Z & l & Nl & D). split; auto. apply is_derive_Reals in D.
  destruct (D (Rabs l) (Rabs_pos_lt l Nl)) as ((d & Hd) & K). simpl in K. exists d. split; auto.
    intros r Hr (_ & Zr & _).
  destruct (Req_dec r t) as [|N]; auto. exfalso. specialize (K (r - t) ltac:(lra)). replace (t + (r - t)) with r in K
    by ring.
  specialize (K ltac:(apply Rabs_def1; lra)). rewrite Z, Zr in K. replace ((0 - 0) / (r - t) - l) with (- l) in K
    by (field; lra).
  rewrite Rabs_Ropp in K. lra.
Qed.

(** *** The equations *)
(** the three-valued sign, eq. (1) *)
Definition sgn r := if Rlt_dec 0 r then 1 else if Rlt_dec r 0 then -1 else 0.

Section Switching.
Variables m1 m2 a1 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** eqs. (3) and (4) at one time, without a control: a and a' are the accelerations of the bodies *)
Definition switched (x v1 v2 : R -> R) t := exists a a' : R, is_derive x t (v1 t) /\ is_derive v1 t a /\
  is_derive v2 t a' /\ (m1 + m2 * (1 - Rabs (sgn (v1 t - v2 t)))) * a + a1 * v1 t + a2 * x t + b * sgn (v1 t - v2 t)
  = 0 /\
  m2 * a' = m2 * a * ((1 - Rabs (sgn (v1 t - v2 t))) / 2 * (1 - sgn (Rabs a - b / m2))) + b * sgn (v1 t - v2 t).

(** a solution of (3), (4): absolutely continuous, the equations met at almost all times *)
Definition switching x v1 v2 := ac x /\ ac v1 /\ ac v2 /\
  forall T, 0 <= T -> exists N, null N /\ forall t, 0 <= t <= T -> ~ N t -> switched x v1 v2 t.

(** the simple zeros of the relative velocity *)
Let turns (v1 v2 : R -> R) t := 0 <= t /\ v1 t - v2 t = 0 /\ exists l, l <> 0 /\ is_derive (fun u => v1 u - v2 u) t l.

(** where the relative velocity has no simple zero, equal velocities have equal rates *)
Lemma same_rates v1 v2 t (a a' : R) : ~ turns v1 v2 t -> 0 <= t -> v1 t = v2 t -> is_derive v1 t a ->
  is_derive v2 t a' -> a = a'.
Proof.
  intros No Ht Ev D1 D2. destruct (Req_dec a a') as [|Ne]; auto. exfalso. apply No. split; [auto|]. split; [lra|].
  exists (a - a'). split; [lra|]. exact (is_derive_minus v1 v2 t a a' D1 D2).
Qed.

(** the signs *)
Lemma sgn_cases r : (0 < r /\ sgn r = 1) \/ (r < 0 /\ sgn r = -1) \/ (r = 0 /\ sgn r = 0).
Proof. unfold sgn. destruct (Rlt_dec 0 r); [auto|]. destruct (Rlt_dec r 0); [auto|]. right; right. split; lra. Qed.

(** Every solution of (3), (4) is Filippov's. *)
Lemma switching_filippov x v1 v2 : switching x v1 v2 -> filippov m1 m2 a1 a2 b x v1 v2.
Proof.
  intros (Ax & A1 & A2 & In). split; [auto|split; [auto|split; [auto|]]]. intros T HT.
    destruct (In T HT) as (N & HN & Sw).
  exists (fun t => N t \/ turns v1 v2 t). split;
    [apply null_or; [auto|apply (null_simple_zeros (fun u => v1 u - v2 u))]|].
  intros t Ht No. destruct (Sw t Ht) as (a & a' & Dx & D1 & D2 & E3 & E4); [auto|].
  assert (Hbm : 0 < b / m2) by positive.
  destruct (sgn_cases (v1 t - v2 t)) as [(W & S)|[(W & S)|(W & S)]]; rewrite S in E3, E4.
  - rewrite Rabs_R1 in E3, E4. exists 1. repeat (split; [lra|]). split; [auto|split].
    + replace ((- a2 * x t - a1 * v1 t - b * 1) / m1) with a by (apply Rmult_eq_reg_l with m1;
      [field_simplify; lra|lra]); auto.
    + replace (b * 1 / m2) with a' by (apply Rmult_eq_reg_l with m2; [field_simplify; lra|lra]); auto.
  - rewrite Rabs_left in E3, E4 by lra. exists (-1). repeat (split; [lra|]). split; [auto|split].
    + replace ((- a2 * x t - a1 * v1 t - b * -1) / m1) with a by (apply Rmult_eq_reg_l with m1;
      [field_simplify; lra|lra]); auto.
    + replace (b * -1 / m2) with a' by (apply Rmult_eq_reg_l with m2; [field_simplify; lra|lra]); auto.
  - rewrite Rabs_R0 in E3, E4. assert (Eq : a = a').
    { apply (same_rates v1 v2 t); [intros Tu; apply No; auto|lra|lra|auto|auto]. }
    subst a'. assert (Small : Rabs a < b / m2).
    { destruct (sgn_cases (Rabs a - b / m2)) as [(L & Z)|[(L & Z)|(L & Z)]]; [exfalso|lra|exfalso];
        rewrite Z in E4; assert (a = 0) as -> by nra; rewrite Rabs_R0 in L; lra. }
    apply Rabs_def2 in Small. assert (Bk : -1 <= m2 / b * a <= 1).
    { assert (0 < m2 / b) by positive. assert (m2 / b * (b / m2) = 1) by (field; lra). nra. }
    exists (m2 / b * a). split; [lra|]. split; [lra|]. split; [lra|]. split; [auto|split].
    + replace ((- a2 * x t - a1 * v1 t - b * (m2 / b * a)) / m1) with a; auto.
      apply Rmult_eq_reg_l with m1; [field_simplify; lra|lra].
    + replace (b * (m2 / b * a) / m2) with a by (field; lra). auto.
Qed.

(** Every solution of Filippov's is one of (3), (4): only at the edges of the sliding region friction has nothing left
    in a stick, and the pair is there at isolated times. *)
Lemma filippov_switching x v1 v2 : filippov m1 m2 a1 a2 b x v1 v2 -> switching x v1 v2.
Proof.
  intros (Ax & A1 & A2 & In). split; [auto|split; [auto|split; [auto|]]]. intros T HT.
    destruct (In T HT) as (N & HN & Sw).
  assert (Hbm : 0 < b / m2) by positive. set (M := m1 + m2).
    assert (HM : 0 < M) by positive.
  set (simple := fun f t => 0 <= t /\ f t = 0 /\ exists l, l <> 0 /\ is_derive f t l).
  set (load := fun k u => a2 * x u + a1 * v1 u + k * (b * M / m2)).
    set (speed := fun k u => v1 u + k * (a1 * b / (a2 * m2))).
  exists (fun t => N t \/ turns v1 v2 t \/ (simple (load 1) t \/ simple (load (-1)) t) \/
    (simple (speed 1) t \/ simple (speed (-1)) t)).
  split.
  { repeat apply null_or; auto; apply null_simple_zeros. }
  intros t Ht No. destruct (Sw t Ht) as (g & Hg & Gp & Gn & Dx & D1 & D2); [auto|].
  set (a := (- a2 * x t - a1 * v1 t - b * g) / m1) in *.
  assert (Ux : Derive (fun u => x u) t = v1 t) by (apply is_derive_unique, Dx).
  assert (U1 : Derive (fun u => v1 u) t = a) by (apply is_derive_unique, D1). exists a, (b * g / m2). split;
    [auto|split; [auto|split; [auto|]]].
  destruct (sgn_cases (v1 t - v2 t)) as [(W & S)|[(W & S)|(W & S)]]; rewrite S.
  - assert (g = 1) by (apply Gp; lra). subst g. rewrite Rabs_R1. unfold a. split; field; lra.
  - assert (g = -1) by (apply Gn; lra). subst g. rewrite (Rabs_left (-1)) by lra. unfold a. split; field; lra.
  - rewrite Rabs_R0. assert (Eq : a = b * g / m2).
    { apply (same_rates v1 v2 t); [intros Tu; apply No; auto|lra|lra|auto|auto]. }
    assert (E3 : M * a + a1 * v1 t + a2 * x t = 0).
    { unfold M. rewrite Rmult_plus_distr_r. rewrite Eq at 2. unfold a. field; lra. }
    assert (Edge : forall k, k = 1 \/ k = -1 -> g <> k).
    { intros k Hk ->. assert (Ea : a = k * (b / m2)) by (rewrite Eq; field; lra).
      assert (Zl : load k t = 0) by (unfold load; rewrite Ea in E3; unfold M in *; lra).
      assert (Dl : is_derive (load k) t (a2 * v1 t + a1 * a)).
      { unfold load. auto_derive; [repeat split; eexists; eauto|]. rewrite Ux, U1. ring. }
      assert (Ds : is_derive (speed k) t a).
      { unfold speed. auto_derive; [eexists; eauto|]. rewrite U1. ring. }
      apply No. right; right. destruct (Req_dec (a2 * v1 t + a1 * a) 0) as [Z|Nz].
      - right. assert (simple (speed k) t); [|destruct Hk; subst k; auto]. split; [lra|]. split.
        + unfold speed. rewrite Ea in Z. apply Rmult_eq_reg_l with a2; [|lra]. rewrite Rmult_0_r, <- Z. field; lra.
        + exists a. split; auto. rewrite Ea. destruct Hk; subst k; lra.
      - left. assert (simple (load k) t); [|destruct Hk; subst k; auto]. split; [lra|]. split; [auto|]. eauto. }
    assert (Small : Rabs a < b / m2).
    { pose proof (Edge 1 ltac:(auto)). pose proof (Edge (-1) ltac:(auto)). rewrite Eq.
      replace (b * g / m2) with (g * (b / m2)) by (field; lra). apply Rabs_def1; nra. }
    destruct (sgn_cases (Rabs a - b / m2)) as [(L & Z)|[(L & Z)|(L & Z)]]; try lra. rewrite Z. split.
    + unfold M in E3. lra.
    + rewrite <- Eq. field.
Qed.

(** The solutions of the paper's equations (3), (4) without a control are Filippov's, and only they. *)
Theorem switching_iff x v1 v2 : switching x v1 v2 <-> filippov m1 m2 a1 a2 b x v1 v2.
Proof. split; [apply switching_filippov|apply filippov_switching]. Qed.
End Switching.
