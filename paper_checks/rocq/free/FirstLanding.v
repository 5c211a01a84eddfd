(** The other side: which exits merge at the first landing, for solutions; the threshold of TurningFunction.v. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap TurningFunction FollowArc Cycle ExitOrbit
  SharpRate SharpLaw AfterOneSlip.

Section Merge.
Variables m1 m2 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Variables x v1 v2 s : R -> R.
Hypothesis H : solution m1 m2 0 a2 b x v1 v2 s.

(** [merges-iff] From $S_0$ with slip angle up to $\pi$: $E>E_{cr}$ at all later times exactly if $r\,c^2<h^2$. *)
Theorem merges_iff t0 p : 0 <= t0 -> v1 t0 = v2 t0 -> - L m1 m2 a2 b <= x t0 <= L m1 m2 a2 b -> 0 < p <= PI / 2 ->
  energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) = Ecr m1 m2 a2 b * (1 + m1 / (m1 + m2) * hh p ^ 2) ->
  ((forall t, 0 <= t -> Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t)) <->
    m2 / (m1 + m2) * depth p ^ 2 < hh p ^ 2).
Proof.
  intros Ht Ev Hx Hp En. assert (P : 0 < p < PI) by (pose proof PI_RGT_0; lra).
  destruct (to_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H t0 (hh p) Ht Ev Hx (hh_pos p P) En)
    as (k & t1 & Hk & T1 & HR & _).
  split.
  - intros Up. destruct (merges_at_first_landing m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk ltac:(lra) P HR)
      as (_ & _ & _ & E1 & _).
    pose proof (o1_pos m1 a2 Hm1 Ha2). assert (0 < 2 * p / o1 m1 a2) by positive.
    specialize (Up (t1 + 2 * p / o1 m1 a2) ltac:(lra)). rewrite E1 in Up. pose proof (q_pos m1 m2 Hm1 Hm2).
      pose proof (Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb).
    destruct (Rlt_dec (m2 / (m1 + m2) * depth p ^ 2) (hh p ^ 2)) as [|N]; auto. exfalso.
    set (y := hh p ^ 2 - m2 / (m1 + m2) * depth p ^ 2) in *. assert (y <= 0) by (unfold y; lra).
    assert (m1 / (m1 + m2) * y <= 0) by nra. nra.
  - intros Y. exact (never_merges m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t1 p Hk ltac:(lra) (conj Hp Y) HR).
Qed.
End Merge.
