(** The first re-entry after an exit, after any number of crossings, merges exactly if the half angle of the exit is
    in one interval: if it is the first landing by the return map, and after a crossing it is above E_cr. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle SlipFromGap AlternatingAngles AfterOneSlip
  AlternatingSlips Reentry ReturnToS0.

Section Equivalence.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (pc : R) (Hpc : PI / 2 < pc < PI) (Dc : depth pc = 2 / (m1 / (m1 + m2))) (HK : / sqrt 3 <= - ct pc).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).

(** after a crossing the pair is beyond S0 *)
Lemma crossed_out t p : crossed m1 m2 a2 b pc x v1 v2 t p -> ~ (- L m1 m2 a2 b <= x t <= L m1 m2 a2 b).
Proof.
  intros (k & d & Hk & Hd & _ & _ & (Ex & _)) N. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0.
    pose proof (q_pos m1 m2 Hm1 Hm2) as Q0.
  assert (0 < L m1 m2 a2 b * (m1 / (m1 + m2) * d)) by positive. destruct Hk; subst k; lra.
Qed.
(** after a crossing the first re-entry is above E_cr *)
Lemma after_crossing t0 t : first_reentry (L m1 m2 a2 b) x v1 v2 t0 t -> 0 <= t0 -> forall p,
  crossed m1 m2 a2 b pc x v1 v2 t0 p ->
  0 <= t /\ v1 t = v2 t /\ Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t).
Proof.
  induction 1 as [t0 t1 C1 I1|t0 t1 t C1 O1 F IH]; intros Ht p Cr;
    destruct (next_contact m1 m2 a2 b Hm1 Hm2 Ha2 Hb pc Hpc Dc HK x v1 v2 s H t0 p Ht Cr) as (C & Or);
    cbv zeta in *; rewrite <- (contact_unique _ _ _ _ _ C1 C) in Or; destruct C1 as (T1 & _ & Ev).
  - destruct Or as [(p' & Cr' & _)|(_ & _ & HE & _)]; [exfalso; exact (crossed_out t1 p' Cr' I1)|].
    split; [lra|auto].
  - destruct Or as [(p' & Cr' & _)|(_ & I1 & _)]; [|contradiction]. apply (IH ltac:(lra) p' Cr').
Qed.

(** the first re-entry after an exit with the half angle p sticks for ever exactly if hh^2 <= r depth^2 *)
Theorem first_reentry_iff k t0 t p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI ->
  on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 ->
  first_reentry (L m1 m2 a2 b) x v1 v2 t0 t -> ((forall u, 0 <= u -> v1 (t + u) = v2 (t + u)) <->
    hh p ^ 2 <= m2 / (m1 + m2) * depth p ^ 2).
Proof.
  intros Hk Ht Hp HR F. destruct (merges_at_first_landing m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hp
    HR) as (Sg & Ev & Ex & En & Iff & Dp).
  pose proof (proj1 (ray_gap m1 m2 a2 b k _ x v1 v2 t0) HR) as HG. rewrite <- push_0 in HG.
  pose proof (slip_contact m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k 0 p t0 Hk Ht (Rle_refl 0) Hp HG) as C.
  pose proof (proj1 C) as T0. inversion F as [t0' t1 C1 I1|t0' t1 t' C1 O1 F1]; subst.
  - rewrite (contact_unique _ _ _ _ _ C1 C). exact Iff.
  - pose proof (contact_unique _ _ _ _ _ C1 C) as T. subst t1. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0.
    pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. assert (Lg : pc < p).
    { apply (crosses_long (m1 / (m1 + m2)) p pc); auto; [lra|]. apply Rnot_le_lt. intros N. apply O1.
      apply (lands m1 m2 a2 b Hm1 Hm2 Ha2 Hb k _ 0 p Hk (Rle_refl 0) Hp); rewrite Rplus_0_r; [exact Ex|lra]. }
    destruct (enter m1 m2 a2 b Hm1 Hm2 Ha2 Hb pc Hpc Dc HK x v1 v2 s H k t0 p Hk Ht Hp HR Lg) as (p' & _ & Cr).
    destruct (after_crossing _ _ F1 ltac:(lra) p' Cr) as (Ht' & Ev' & HE). split; intros Q.
    + exfalso. apply (sticks_iff m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H t Ht' Ev') in Q. lra.
    + exfalso. specialize (Dp Q). rewrite <- Dc in Dp. pose proof (depth_incr pc p ltac:(lra) Lg ltac:(lra)). lra.
Qed.
End Equivalence.
