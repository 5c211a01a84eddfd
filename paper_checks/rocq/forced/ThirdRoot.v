(** A motion at critical resonance from period to period: X grows by c/X^2, its deviation V fades as 1/X, so X^3 grows as 3 c n. *)
From InertialPair Require Import Dini.

Section ThirdRoot.
Context (c k K : R) (Hc : 0 < c) (Hk : 0 < k) (HK : 0 < K).
(** V stays below M/X *)
Let M := 2 * K / k.

(** a period: V fades at the rate k/X but for K/X^2, and X gains c/X^2 but for smaller terms *)
Definition period_of_growth x v x' v' :=
  0 <= v' <= v - k * v / x + K / x ^ 2 /\ x <= x' /\ Rabs (x' - x - c / x ^ 2) <= (K * sqrt v + K / x) / x ^ 2.

Let X0 := 1 + k + 4 * c / k + M + (4 * K * (M + 1) / c) ^ 2 + 4 * K * (M + 1) / c.

Section Orbit.
Context (X V : nat -> R) (Start : X0 <= X O) (Still : V O = 0).
Hypothesis Gain : forall n, X0 <= X n -> 0 <= V n <= 1 -> period_of_growth (X n) (V n) (X (S n)) (V (S n)).

Let M0 : 0 < M.
Proof. unfold M. positive. Qed.
Let Large : 1 <= X0 /\ k <= X0 /\ 4 * c / k <= X0 /\ M <= X0.
Proof.
  assert (0 < 4 * c / k) by positive. assert (0 < 4 * K * (M + 1) / c) by positive. pose proof M0.
  assert (0 < (4 * K * (M + 1) / c) ^ 2) by positive. unfold X0. lra.
Qed.
(** sqrt (M/x) + 1/x is small *)
Let Small x : X0 <= x -> K * sqrt (M / x) + K / x <= c / 2.
Proof.
  intros Hx. destruct Large as (L1 & _). pose proof M0. set (g := 4 * K * (M + 1) / c).
  assert (G : 0 < g) by (unfold g; positive). assert (Gx : g ^ 2 + g <= x).
  { assert (0 < 4 * c / k) by positive. unfold X0 in Hx. fold g in Hx. lra. }
  assert (A : sqrt (M / x) <= (M + 1) / g).
  { rewrite <- (sqrt_pow2 ((M + 1) / g)) by positive. apply sqrt_le_1_alt. replace (((M + 1) / g) ^ 2) with ((M + 1) ^ 2 / g ^ 2) by (field; lra).
    apply Rmult_le_compat; [lra|apply Rlt_le; positive|nra|]. apply Rinv_le_contravar; [positive|lra]. }
  assert (B : / x <= / g) by (apply Rinv_le_contravar; [auto|]; pose proof (pow2_ge_0 g); lra).
  assert (Eg : (M + 1) / g = c / (4 * K)) by (unfold g; field; repeat split; lra).
  assert (Ei : / g <= (M + 1) / g) by (unfold Rdiv; assert (0 < / g) by positive; nra).
  rewrite Eg in A, Ei. apply (Rmult_le_compat_l K) in A; [|lra]. assert (B' : K * / x <= K * (c / (4 * K))) by (apply Rmult_le_compat_l; lra).
  replace (K * (c / (4 * K))) with (c / 4) in A, B' by (field; lra). unfold Rdiv at 2. lra.
Qed.

Let In n : X0 <= X n /\ 0 <= V n <= M / X n.
Proof.
  destruct Large as (L1 & L2 & L3 & L4). pose proof M0. induction n as [|n (I1 & I2 & I3)].
  { rewrite Still. split; [auto|split; [lra|]]. apply Rlt_le. positive. }
  set (x := X n) in *. set (v := V n) in *. assert (Px : 0 < x) by lra.
  assert (V1 : v <= 1). { apply Rle_trans with (1 := I3). undivide x. lra. }
  destruct (Gain n I1 (conj I2 V1)) as ((W0 & W) & Up & G). fold x v in W, Up, G. set (x' := X (S n)) in *. set (v' := V (S n)) in *.
  split; [lra|split; [auto|]]. assert (Px' : 0 < x') by lra.
  assert (Sq : sqrt v <= sqrt (M / x)) by (apply sqrt_le_1_alt; auto).
  assert (X2 : 0 < x ^ 2) by positive. assert (Ix : 0 < / x ^ 2) by positive.
  assert (Up2 : x' - x <= 2 * c * / x ^ 2).
  { apply Rabs_inv in G. pose proof (Small x I1). apply (Rmult_le_compat_l K) in Sq; [|lra].
    assert ((K * sqrt v + K / x) * / x ^ 2 <= c * / x ^ 2) by (apply Rmult_le_compat_r; lra). unfold Rdiv in *. lra. }
  assert (Vb : v' <= M / x - K / x ^ 2).
  { apply Rle_trans with (1 := W). assert (Fade : k / x <= 1) by (undivide x; lra).
    assert ((1 - k / x) * v <= (1 - k / x) * (M / x)) by (apply Rmult_le_compat_l; lra).
    replace (v - k * v / x) with ((1 - k / x) * v) by (field; lra).
    replace (M / x - K / x ^ 2) with ((1 - k / x) * (M / x) + K / x ^ 2) by (unfold M; field; lra). lra. }
  apply Rle_trans with (1 := Vb). undivide x'. replace ((M / x - K / x ^ 2) * x') with (M * (x' / x) - K * x' / x ^ 2) by (field; lra).
  assert (Q : x' / x <= 1 + 2 * c * / x ^ 3).
  { undivide x. replace ((1 + 2 * c * / x ^ 3) * x) with (x + 2 * c * / x ^ 2) by (field; lra). lra. }
  assert (Q2 : K / x <= K * x' / x ^ 2).
  { undivide (x ^ 2). replace (K / x * x ^ 2) with (K * x) by (field; lra). apply Rmult_le_compat_l; lra. }
  assert (Q3 : M * (2 * c * / x ^ 3) <= K / x).
  { replace (M * (2 * c * / x ^ 3)) with (K / x * (4 * c / k * / x ^ 2)) by (unfold M; field; repeat split; lra).
    rewrite <- (Rmult_1_r (K / x)) at 2. apply Rmult_le_compat_l; [apply Rlt_le; positive|].
    assert (4 * c / k <= x ^ 2) by nra. apply Rmult_le_reg_r with (x ^ 2); auto. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  apply (Rmult_le_compat_l M) in Q; lra.
Qed.

(** what the cube gains, by what X^2 (X' - X) is *)
Let g n := X n ^ 2 * (X (S n) - X n).
Let d n := X (S n) ^ 3 - X n ^ 3.
Let Pos n : 0 < X n.
Proof. destruct (In n), Large. lra. Qed.
Let Step n : Rabs (g n - c) <= K * sqrt (M * / X n) + K * / X n /\ c / 2 <= g n.
Proof.
  destruct (In n) as (I1 & I2 & I3), Large as (L1 & _ & _ & L4). pose proof (Pos n) as P. set (x := X n) in *.
  assert (V n <= 1). { apply Rle_trans with (1 := I3). undivide x. lra. }
  destruct (Gain n I1 ltac:(lra)) as (_ & _ & G). fold x in G. assert (X2 : 0 < x ^ 2) by positive.
  assert (B : Rabs (g n - c) <= K * sqrt (M * / x) + K * / x).
  { unfold g. fold x. replace (x ^ 2 * (X (S n) - x) - c) with (x ^ 2 * (X (S n) - x - c / x ^ 2)) by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (x ^ 2)) by lra. apply (Rmult_le_compat_l (x ^ 2)) in G; [|lra]. apply Rle_trans with (1 := G).
    replace (x ^ 2 * ((K * sqrt (V n) + K / x) / x ^ 2)) with (K * sqrt (V n) + K * / x) by (field; lra).
    apply Rplus_le_compat_r, Rmult_le_compat_l; [lra|]. apply sqrt_le_1_alt; auto. }
  split; [exact B|]. apply Rabs_inv in B. pose proof (Small x I1). unfold Rdiv in *. lra.
Qed.
Let Cube n : d n = 3 * g n + 3 * (g n ^ 2 * (/ X n) ^ 3) + g n ^ 3 * (/ X n) ^ 6.
Proof. pose proof (Pos n). unfold d, g. field. lra. Qed.

Let Sum n : sum_f_R0 d n = X (S n) ^ 3 - X O ^ 3.
Proof. induction n as [|n IH]; [reflexivity|]. rewrite tech5, IH. unfold d. ring. Qed.

(** *** X tends to infinity *)
Theorem grows : is_lim_seq X p_infty.
Proof.
  assert (Low : forall n, 3 * c / 2 * INR n <= X n ^ 3).
  { induction n as [|n IH]; [pose proof (Pos O); simpl (INR 0); assert (0 < X O ^ 3) by positive; lra|]. rewrite S_INR.
    destruct (Step n) as (_ & G). pose proof (Pos n). pose proof (Cube n) as E. unfold d in E.
    assert (0 < / X n) by positive. assert (0 <= g n ^ 2 * (/ X n) ^ 3) by (apply Rmult_le_pos; apply pow_le; lra).
    assert (0 <= g n ^ 3 * (/ X n) ^ 6) by (apply Rmult_le_pos; apply pow_le; lra). lra. }
  apply is_lim_seq_spec. intros B. destruct (nfloor_ex (2 * Rabs B ^ 3 / (3 * c) + 1)) as (n0 & _ & N).
  { assert (0 <= Rabs B ^ 3) by (apply pow_le, Rabs_pos). assert (0 <= 2 * Rabs B ^ 3 / (3 * c)) by (apply Rdiv_le_0_compat; lra). lra. }
  exists (S n0). intros n Hn. apply Rnot_le_lt. intros L. pose proof (Pos n).
  assert (X n ^ 3 <= Rabs B ^ 3) by (apply pow_incr; split; [lra|]; apply Rle_trans with (1 := L), Rle_abs).
  specialize (Low n). apply le_INR in Hn. rewrite S_INR in Hn.
  assert (3 * c / 2 * (2 * Rabs B ^ 3 / (3 * c) + 1) <= 3 * c / 2 * INR n) by (apply Rmult_le_compat_l; lra).
  replace (3 * c / 2 * (2 * Rabs B ^ 3 / (3 * c) + 1)) with (Rabs B ^ 3 + 3 * c / 2) in H1 by (field; lra). lra.
Qed.

Let Fades : is_lim_seq (fun n => / X n) 0.
Proof. assert (Q := is_lim_seq_inv _ _ grows). apply Q. discriminate. Qed.
(** *** the deviation fades *)
Theorem deviation_fades : is_lim_seq V 0.
Proof.
  apply is_lim_seq_le_le with (fun _ => 0) (fun n => M * / X n).
  - intros n. apply (In n).
  - apply is_lim_seq_const.
  - replace (Finite 0) with (Rbar_mult M 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l, Fades.
Qed.

Let Each : is_lim_seq d (3 * c).
Proof.
  assert (Rt : is_lim_seq (fun n => K * sqrt (M * / X n) + K * / X n) (K * sqrt (M * 0) + K * 0)).
  { apply is_lim_seq_plus'; apply is_lim_seq_mult'; try apply is_lim_seq_const; auto.
    apply (is_lim_seq_continuous sqrt); [apply continuity_pt_sqrt; lra|]. apply is_lim_seq_mult'; [apply is_lim_seq_const|auto]. }
  rewrite !Rmult_0_r, sqrt_0, Rmult_0_r, Rplus_0_r in Rt.
  assert (G : is_lim_seq g c).
  { assert (Z : is_lim_seq (fun n => g n - c) 0).
    { apply is_lim_seq_abs_0. apply is_lim_seq_le_le with (fun _ => 0) (fun n => K * sqrt (M * / X n) + K * / X n); auto using is_lim_seq_const.
      intros n. split; [apply Rabs_pos|apply (Step n)]. }
    apply is_lim_seq_ext with (fun n => g n - c + c); [intros; ring|]. replace (Finite c) with (Finite (0 + c)) by (f_equal; ring).
    apply is_lim_seq_plus'; auto using is_lim_seq_const. }
  apply is_lim_seq_ext with (fun n => 3 * g n + 3 * (g n ^ 2 * (/ X n) ^ 3) + g n ^ 3 * (/ X n) ^ 6); [intros n; symmetry; apply Cube|].
  replace (Finite (3 * c)) with (Finite (3 * c + 3 * (c ^ 2 * 0 ^ 3) + c ^ 3 * 0 ^ 6)) by (f_equal; ring).
  assert (Pw : forall (u : nat -> R) (l : R) m, is_lim_seq u l -> is_lim_seq (fun n => u n ^ m) (l ^ m)).
  { intros u l m Hu. induction m as [|m IH]; simpl; [apply is_lim_seq_const|]. apply is_lim_seq_mult'; auto. }
  repeat first [apply is_lim_seq_plus'|apply is_lim_seq_mult'|apply Pw|apply is_lim_seq_const|assumption].
Qed.

(** *** X^3 grows as 3 c n *)
Theorem third_root : is_lim_seq (fun n => X n ^ 3 / INR n) (3 * c).
Proof.
  assert (C : is_lim_seq (fun n => sum_f_R0 d (pred n) / INR n) (3 * c)).
  { apply is_lim_seq_Reals. apply Cesaro_1. apply is_lim_seq_Reals. exact Each. }
  assert (Z : is_lim_seq (fun n => X O ^ 3 * / INR n) 0).
  { replace (Finite 0) with (Rbar_mult (X O ^ 3) 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l.
    assert (Q := is_lim_seq_inv _ _ is_lim_seq_INR). simpl in Q. apply Q. discriminate. }
  replace (Finite (3 * c)) with (Finite (3 * c + 0)) by (f_equal; ring).
  apply is_lim_seq_ext_loc with (fun n => sum_f_R0 d (pred n) / INR n + X O ^ 3 * / INR n); [|apply is_lim_seq_plus'; auto].
  exists 1%nat. intros n Hn. destruct n; [inversion Hn|]. simpl pred. rewrite Sum. field. apply not_0_INR. discriminate.
Qed.
End Orbit.

(** *** the law: from some X0 on, at rest beside X, all of it *)

(** [third-root-law] For $c,\kappa,K>0$: if $X$ is large at first and $V=0$, and from step to step, while $X$ is large
    and $V\leqslant 1$, $X$ does not fall and gains $c/X^2$ within $(K\sqrt V+K/X)/X^2$, and $V\geqslant 0$ gains at
    most $-\kappa V/X+K/X^2$, then $X\to\infty$, $V\to 0$ and $X_n^3/n\to 3c$. *)
Theorem third_root_law : exists X0, 0 < X0 /\ forall X V : nat -> R, X0 <= X O -> V O = 0 ->
  (forall n, X0 <= X n -> 0 <= V n <= 1 -> period_of_growth (X n) (V n) (X (S n)) (V (S n))) ->
  is_lim_seq X p_infty /\ is_lim_seq V 0 /\ is_lim_seq (fun n => X n ^ 3 / INR n) (3 * c).
Proof.
  exists X0. split; [|intros X V S0 St G; split; [apply (grows X V S0 St G)|split; [apply (deviation_fades X V S0 St G)|apply (third_root X V S0 St G)]]].
  unfold X0. assert (0 < 4 * c / k) by positive. assert (0 < M) by (unfold M; positive). assert (0 < 4 * K * (M + 1) / c) by positive.
  assert (0 < (4 * K * (M + 1) / c) ^ 2) by positive. lra.
Qed.
End ThirdRoot.
