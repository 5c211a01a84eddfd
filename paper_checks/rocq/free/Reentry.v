(** After a crossing: every short slip that ends in S0 stays above E_cr; so does the first re-entry after any number
    of crossings. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle SlipFromGap AlternatingAngles AfterOneSlip
  AlternatingSlips ShortSlipMargin ReturnToS0.

(** p <= pi - pc gives q >= 1/(1 + (pi - p) k), so the margin holds *)
Lemma short_margin q pc p : 0 < q -> PI / 2 < pc < PI -> depth pc = 2 / q -> 0 < p <= PI - pc ->
  1 - 2 * hh p * ct p < q * hh p ^ 2.
Proof.
  intros Hq Hpc Dc Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S.
  pose proof (cos_gt_0 p ltac:(lra) ltac:(lra)) as C. assert (Kp : 0 < ct p) by (apply Rdiv_lt_0_compat; auto).
  pose proof (margin p ltac:(lra)) as M. assert (W : 0 < (PI - p) * ct p) by positive.
  assert (De : depth (PI - p) = 2 * (1 + (PI - p) * ct p)).
  { pose proof (two_hh (PI - p) ltac:(lra)) as T. rewrite ct_mirror in T by lra.
    pose proof (hh_mirror p ltac:(lra)) as Hm. apply Rmult_eq_reg_l with (ct p); [|lra].
    (* 2 (h~ + h) = 2 pi (1 + k^2); the theta's cancel *)
    
    assert (Q : hh p = p * (1 + ct p ^ 2) - ct p) by (unfold hh, ct; trig p). lra. }
  pose proof (rising_le PI depth pc (PI - p) depth_incr ltac:(lra) ltac:(lra) ltac:(lra)) as Le.
  rewrite Dc, De in Le. apply (Rle_div_l 2 _ q) in Le; [|lra]. set (w := 1 + (PI - p) * ct p) in *.
  apply Rmult_lt_reg_r with w; [unfold w; lra|]. apply Rlt_le_trans with (1 := M).
  assert (0 <= (w * q - 1) * hh p ^ 2) by positive. lra.
Qed.

(** the invariant of the slips after a crossing: a gap, and a half angle that is long or short *)
Definition crossed m1 m2 a2 b pc (x v1 v2 : R -> R) t p := exists k d, (k = 1 \/ k = -1) /\ 0 < d /\ 0 < p < PI /\
  (pc <= p \/ p <= PI - pc) /\
  at_gap m1 m2 a2 b k d (push d p) x v1 v2 t.

Section Reentry.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Let q := m1 / (m1 + m2).
Context (pc : R) (Hpc : PI / 2 < pc < PI) (Dc : depth pc = 2 / q) (HK : / sqrt 3 <= - ct pc).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let Q0 : 0 < q. Proof. apply q_pos; auto. Qed.

(** from a ray with p > pc it crosses, and the next slip is short *)
Theorem enter k t0 p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 -> pc < p ->
  exists p', p' <= PI - pc /\ crossed m1 m2 a2 b pc x v1 v2 (t0 + 2 * p / o1 m1 a2) p'.
Proof.
  intros Hk Ht Hp HR Hl. apply ray_gap in HR. rewrite <- push_0 in HR.
  assert (HD : 2 / q < depth p + 0). { pose proof (depth_incr pc p ltac:(lra) Hl ltac:(lra)). lra. }
  destruct (alternation m1 m2 a2 b x v1 v2 s k t0 0 p pc Hm1 Hm2 Ha2 Hb Hpc Dc HK Hk H Ht (Rle_refl 0) Hp HR HD)
    as (p' & Hp' & D' & G & A & _). exists p'. assert (p' <= PI - pc) by lra. split; [auto|].
  exists (- k), (depth p + 0 - 2 / q). split; [destruct Hk; [right|left]; lra|]. auto.
Qed.

(** after a crossing the next contact is either again a crossing, or in S0 above E_cr, whence it sticks up to a ray:
    no merging there *)
Theorem next_contact t0 p : 0 <= t0 -> crossed m1 m2 a2 b pc x v1 v2 t0 p -> let t1 := t0 + 2 * p / o1 m1 a2 in
  contact_after v1 v2 t0 t1 /\
  ((exists p', crossed m1 m2 a2 b pc x v1 v2 t1 p' /\ (pc <= p -> p' <= PI - pc) /\ (p <= PI - pc -> pc <= p')) \/
   (p <= PI - pc /\ - L m1 m2 a2 b <= x t1 <= L m1 m2 a2 b /\ Ecr m1 m2 a2 b < energy m1 m2 a2 (x t1) (v1 t1) (v2 t1) /\
    exists k u t2, (k = 1 \/ k = -1) /\ 0 < u /\ t1 <= t2 /\ on_ray m1 m2 a2 b k u x v1 v2 t2)).
Proof.
  intros Ht (k & d & Hk & Hd & Hp & Ls & HG) t1.
  split; [exact (slip_contact m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k d p t0 Hk Ht ltac:(lra) Hp HG)|].
  destruct (Rlt_dec (2 / q) (depth p + d)) as [HD|N].
  - left. destruct (alternation m1 m2 a2 b x v1 v2 s k t0 d p pc Hm1 Hm2 Ha2 Hb Hpc Dc HK Hk H Ht ltac:(lra) Hp HG
    HD) as (p' & Hp' & D' & G & A1 & A2).
    exists p'. split; [|auto]. exists (- k), (depth p + d - 2 / q). split; [destruct Hk; [right|left]; lra|].
      repeat (split; [auto; fail|]). split; [|auto].
    destruct Ls as [I|I]; [right; auto|left; auto].
  - right. apply Rnot_lt_le in N. assert (Sh : p <= PI - pc). { destruct Ls as [I|]; auto. exfalso.
      pose proof (rising_le PI depth pc p depth_incr ltac:(lra) I ltac:(lra)). lra. }
    destruct (reentry m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 d p Hk Ht ltac:(lra) Hp HG N) as (_ & _ & Hx & _
      & _ & _ & Up). assert (Y : 0 < level m1 m2 p d) by (apply level_pos; auto; apply (short_margin q pc); auto; lra).
    destruct (Up Y) as (HE & k' & t2 & Hk' & T2 & HR & _). fold t1 in HE, Hx, T2. repeat (split; [auto; fail|]).
    exists k', (sqrt (level m1 m2 p d)), t2. split; [auto|]. split; [positive|]. split; [lra|auto].
Qed.
End Reentry.
