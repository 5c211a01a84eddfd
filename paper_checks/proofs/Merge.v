(** The other side: which exits merge at the first landing, for solutions; the threshold of Turning.v. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick Excursion Rate Turning Slip Cycle Orbit Sharp Law.
Local Open Scope R_scope.

Section Merge.
Variables m1 m2 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Variables x v1 v2 s : R -> R.
Hypothesis H : solution m1 m2 0 a2 b x v1 v2 s.

(** the first landing, for every half angle p < pi and either side: on S, at the level of the return map *)
Theorem first_landing k t0 p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 ->
  let t1 := t0 + 2 * p / o1 m1 a2 in v1 t1 = v2 t1 /\
  energy m1 m2 a2 (x t1) (v1 t1) (v2 t1) = Ecr m1 m2 a2 b * (1 + m1 / (m1 + m2) * (hh p ^ 2 - m2 / (m1 + m2) *
    depth p ^ 2)).
Proof.
  intros Hk Ht Hp HR t1. rewrite <- (landing_energy m1 m2 a2 b Hm1 Hm2 Ha2 p Hp). destruct Hk; subst k.
  - destruct (slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t0 p H Ht Hp HR) as (_ & Lx & L1 & L2). fold t1 in Lx, L1, L2.
    rewrite Lx, L1, L2. auto.
  - apply ray_mirror in HR. replace (- -1) with 1 in HR by ring.
    destruct (slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb _ _ _ _ t0 p (mirror m1 m2 a2 b _ _ _ _ H) Ht Hp HR) as (_ & Lx & L1 & L2).
    cbv beta in Lx, L1, L2. fold t1 in Lx, L1, L2. rewrite <- Lx, <- L1 at 1. rewrite <- L2. split; [lra|].
      unfold energy. field.
Qed.

(** y1 <= 0: it merges at the first landing *)
Theorem merges_at_landing k t0 p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 ->
  hh p ^ 2 <= m2 / (m1 + m2) * depth p ^ 2 -> let t1 := t0 + 2 * p / o1 m1 a2 in
  forall u, 0 <= u -> x (t1 + u) = X m1 m2 a2 (x t1) (v1 t1) u /\ v1 (t1 + u) = V m1 m2 a2 (x t1) (v1 t1) u /\
    v2 (t1 + u) = V m1 m2 a2 (x t1) (v1 t1) u.
Proof.
  intros Hk Ht Hp HR Hy t1. destruct (first_landing k t0 p Hk Ht Hp HR) as (Ev & En). fold t1 in Ev, En.
  pose proof (o1_pos m1 a2 Hm1 Ha2). assert (0 < 2 * p / o1 m1 a2) by (apply Rdiv_lt_0_compat; lra).
  apply (capture m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t1 H); auto; [unfold t1; lra|]. rewrite En.
  pose proof (q_pos m1 m2 Hm1 Hm2). assert (E0 : 0 < Ecr m1 m2 a2 b).
  { rewrite Ecr_L by auto. pose proof (pow_lt _ 2 (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb)). nra. }
  set (y := hh p ^ 2 - m2 / (m1 + m2) * depth p ^ 2) in *. assert (y <= 0) by (unfold y; lra).
  assert (m1 / (m1 + m2) * y <= 0) by nra. nra.
Qed.

(** From S0, at a level with theta <= pi (E <= E_cr (1 + q pi^2/4)): the solution never merges exactly if r c^2 <
  h^2. *)
Theorem merges_iff t0 p : 0 <= t0 -> v1 t0 = v2 t0 -> - L m1 m2 a2 b <= x t0 <= L m1 m2 a2 b -> 0 < p <= PI / 2 ->
  energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) = Ecr m1 m2 a2 b * (1 + m1 / (m1 + m2) * hh p ^ 2) ->
  ((forall t, 0 <= t -> Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t)) <->
    m2 / (m1 + m2) * depth p ^ 2 < hh p ^ 2).
Proof.
  intros Ht Ev Hx Hp En. assert (P : 0 < p < PI) by (pose proof PI_RGT_0; lra).
  destruct (start_level m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t0 (hh p) H Ht Ev Hx (hh_pos p P) En) as (k & t1 & Hk
    & T1 & HR).
  split.
  - intros Up. destruct (first_landing k t1 p Hk ltac:(lra) P HR) as (_ & E1).
    pose proof (o1_pos m1 a2 Hm1 Ha2). assert (0 < 2 * p / o1 m1 a2) by (apply Rdiv_lt_0_compat; lra).
    specialize (Up (t1 + 2 * p / o1 m1 a2) ltac:(lra)). rewrite E1 in Up. pose proof (q_pos m1 m2 Hm1 Hm2).
      pose proof (Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb).
    destruct (Rlt_dec (m2 / (m1 + m2) * depth p ^ 2) (hh p ^ 2)) as [|N]; auto. exfalso.
    set (y := hh p ^ 2 - m2 / (m1 + m2) * depth p ^ 2) in *. assert (y <= 0) by (unfold y; lra).
    assert (m1 / (m1 + m2) * y <= 0) by nra. nra.
  - intros Y. exact (never_merges m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk ltac:(lra) (conj Hp Y) HR).
Qed.
End Merge.

(** The threshold for solutions: above -cos 2p the first landing of every exit (p < pi) stays above E_cr;
    up to it, every solution on the exit ray with the half angle p merges at its first landing. *)
Theorem threshold_of_solutions : exists p, 0 < p < PI /\ K p = 0 /\ forall m1 m2 a2 b, 0 < m1 -> 0 < m2 ->
  0 < a2 -> 0 < b ->
  forall x v1 v2 s k t0, solution m1 m2 0 a2 b x v1 v2 s -> k = 1 \/ k = -1 -> 0 <= t0 ->
  (- cos (2 * p) < m1 / m2 -> forall p', 0 < p' < PI -> on_ray m1 m2 a2 b k (hh p') x v1 v2 t0 ->
     let t1 := t0 + 2 * p' / o1 m1 a2 in Ecr m1 m2 a2 b < energy m1 m2 a2 (x t1) (v1 t1) (v2 t1)) /\
  (m1 / m2 <= - cos (2 * p) -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 -> let t1 := t0 + 2 * p / o1 m1 a2 in
     forall u, 0 <= u -> x (t1 + u) = X m1 m2 a2 (x t1) (v1 t1) u /\ v1 (t1 + u) = V m1 m2 a2 (x t1) (v1 t1) u /\
       v2 (t1 + u) = V m1 m2 a2 (x t1) (v1 t1) u).
Proof.
  destruct threshold as (p & Hp & Z & _ & Up & Lo & Iff). exists p. split; [auto|]. split; [auto|].
  intros m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s k t0 H Hk Ht. split.
  - intros Hr p' Hp' HR t1. destruct (first_landing m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p' Hk Ht Hp' HR) as
    (_ & En). fold t1 in En. rewrite En.
    apply Iff in Hr; auto. assert (R0 : 0 < m2 / (m1 + m2)) by (apply Rdiv_lt_0_compat; lra).
    pose proof (Up _ R0 Hr p' Hp') as Y. assert (Q0 : 0 < m1 / (m1 + m2)) by (apply Rdiv_lt_0_compat; lra).
    assert (E0 : 0 < Ecr m1 m2 a2 b). { rewrite Ecr_L by auto.
      pose proof (pow_lt _ 2 (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb)). nra. }
    pose proof (Rmult_lt_0_compat _ _ Q0 Y) as QY. pose proof (Rmult_lt_0_compat _ _ E0 QY). lra.
  - intros Hr HR. apply (merges_at_landing m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hp HR).
    assert (hh p ^ 2 - m2 / (m1 + m2) * depth p ^ 2 <= 0); [|lra]. apply Lo.
    destruct (Rle_dec (/ (2 * sin p ^ 2)) (m2 / (m1 + m2))) as [|N]; auto. exfalso.
      assert (- cos (2 * p) < m1 / m2) by (apply Iff; auto; lra). lra.
Qed.
