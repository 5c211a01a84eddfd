(** Long and short slips alternate: the identities and inequalities of one slip after another, in the half angle p
    (theta = 2 p, k = cot p, c the depth, D = c + gap). A slip is long if its depth alone reaches the other end of S0.
    After a long slip that crosses, the next contact function at the mirror angle is at least P = pi (1 + k^2) - theta;
    after a short one that crosses, the next push exceeds that of the shortest long slip by at least P. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Excursion ReturnMap SlipFromGap.

Lemma derive_ct p : 0 < p < PI -> is_derive ct p (- (1 + ct p ^ 2)).
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. unfold ct. auto_derive; [lra|]. field. lra.
Qed.
(** h' = c (1 + k^2), in the half angle *)
Lemma derive_hh p : 0 < p < PI -> is_derive hh p (depth p * (1 + ct p ^ 2)).
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. unfold hh, depth, ct.
  auto_derive; [apply Rgt_not_eq; nra|trig p].
Qed.
(** c' = 2 h, in the half angle *)
Lemma derive_depth p : 0 < p < PI -> is_derive depth p (2 * hh p).
Proof. intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. unfold hh, depth. auto_derive; [lra|trig p]. Qed.
(** A2 *)
Theorem derive_push_next q p : 0 < q -> 0 < p < PI ->
  is_derive (fun p => hh p + 2 * ct p / q) p ((depth p - 2 / q) * (1 + ct p ^ 2)).
Proof.
  intros Hq Hp. apply (is_derive_ext (fun p => plus (hh p) (scal (2 / q) (ct p)))).
  { intros t. unfold plus, scal; simpl. unfold mult; simpl. field. lra. }
  replace ((depth p - 2 / q) * (1 + ct p ^ 2)) with (plus (depth p * (1 + ct p ^ 2)) (scal (2 / q) (- (1 + ct p ^ 2)))).
  2:{ unfold plus, scal; simpl. unfold mult; simpl. ring. }
  apply (is_derive_plus hh (fun p => scal (2 / q) (ct p))); [apply derive_hh; auto|]. apply (is_derive_scal ct).
    apply derive_ct; auto.
Qed.

(** P = pi (1 + k^2) - theta *)
Definition Pf p := PI * (1 + ct p ^ 2) - 2 * p.
(** the slope of P *)
Definition dP p := - (2 * PI * ct p * (1 + ct p ^ 2)) - 2.
Lemma derive_P p : 0 < p < PI -> is_derive Pf p (dP p).
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. unfold Pf, dP, ct. auto_derive; [lra|]. field. lra.
Qed.
Lemma ct_half_pi : ct (PI / 2) = 0. Proof. unfold ct. rewrite cos_PI2, sin_PI2. field. Qed.
(** the slope increases beyond pi/2: P is convex there *)
Lemma dP_incr u v : PI / 2 <= u -> u < v -> v < PI -> dP u < dP v.
Proof.
  intros. pose proof (ct_falls u v ltac:(lra) ltac:(lra) ltac:(lra)) as F. assert (U : ct u <= 0).
  { rewrite <- ct_half_pi. destruct (Req_dec (PI / 2) u) as [<-|]; [lra|]. apply Rlt_le, ct_falls; lra. }
  unfold dP. set (A := - ct u). set (B := - ct v). assert (0 <= A < B) by (unfold A, B; lra).
  replace (- (2 * PI * ct u * (1 + ct u ^ 2)) - 2) with (2 * PI * (A * (1 + A ^ 2)) - 2) by (unfold A; ring).
  replace (- (2 * PI * ct v * (1 + ct v ^ 2)) - 2) with (2 * PI * (B * (1 + B ^ 2)) - 2) by (unfold B; ring).
  assert (A * (1 + A ^ 2) < B * (1 + B ^ 2)). { assert (A ^ 2 <= B ^ 2) by nra. nra. }
  assert (2 * PI * (A * (1 + A ^ 2)) < 2 * PI * (B * (1 + B ^ 2))) by nra. lra.
Qed.
Lemma ct_2PI3 : ct (2 * (PI / 3)) = - / sqrt 3.
Proof. unfold ct. rewrite cos_2PI3, sin_2PI3. pose proof (sqrt_lt_R0 3 ltac:(lra)). field. lra. Qed.
(** P vanishes at pi/2 and at 2 pi/3 *)
Lemma P_zeros : Pf (PI / 2) = 0 /\ Pf (2 * (PI / 3)) = 0.
Proof.
  unfold Pf. rewrite ct_half_pi, ct_2PI3. pose proof (sqrt_lt_R0 3 ltac:(lra)). split; [field|].
  replace ((- / sqrt 3) ^ 2) with (/ (sqrt 3 * sqrt 3)) by (field; lra). rewrite sqrt_sqrt by lra. field.
Qed.
(** A3: P is convex with the zeros pi/2 and 2 pi/3 *)
Theorem P_sign p : PI / 2 < p < PI -> (0 <= Pf p <-> / sqrt 3 <= - ct p).
Proof.
  intros Hp. destruct P_zeros as (Z1 & Z2). set (z := 2 * (PI / 3)) in *.
  assert (Hz : PI / 2 < z < PI) by (unfold z; lra).
  assert (Mvt : forall u v, PI / 2 <= u -> u < v -> v < PI -> exists t, Pf v - Pf u = dP t * (v - u) /\ u < t < v).
  { intros u v Hu Huv Hv. apply (MVT_cor2 Pf dP u v Huv). intros t Ht. apply is_derive_Reals, derive_P; lra. }
  assert (Iff : 0 <= Pf p <-> z <= p).
  { split; intros Q.
    - destruct (Rle_dec z p) as [|n]; auto. exfalso.
      destruct (Mvt (PI / 2) p ltac:(lra) ltac:(lra) ltac:(lra)) as (t1 & E1 & T1).
      destruct (Mvt p z ltac:(lra) ltac:(lra) ltac:(lra)) as (t2 & E2 & T2).
      pose proof (dP_incr t1 t2 ltac:(lra) ltac:(lra) ltac:(lra)). assert (0 <= dP t1) by nra.
      assert (dP t2 <= 0) by nra. lra.
    - destruct (Req_dec z p) as [<-|]; [lra|].
      destruct (Mvt (PI / 2) z ltac:(lra) ltac:(lra) ltac:(lra)) as (t1 & E1 & T1).
      destruct (Mvt z p ltac:(lra) ltac:(lra) ltac:(lra)) as (t2 & E2 & T2).
      pose proof (dP_incr t1 t2 ltac:(lra) ltac:(lra) ltac:(lra)). assert (dP t1 = 0) by nra.
      assert (0 < dP t2 * (p - z)) by positive. lra. }
  rewrite Iff. assert (C : / sqrt 3 = - ct z) by (unfold z; rewrite ct_2PI3; ring). split; intros Q.
  - destruct (Req_dec z p) as [<-|]; [lra|]. pose proof (ct_falls z p ltac:(lra) ltac:(lra) ltac:(lra)). lra.
  - destruct (Rle_dec z p) as [|n]; auto. pose proof (ct_falls p z ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(** the mirror angle theta~ = 2 pi - theta: k~ = - k, h~ + h = pi (1 + k^2); and 2 h - theta = - k c *)
Lemma ct_mirror p : 0 < p < PI -> ct (PI - p) = - ct p.
Proof. intros Hp. unfold ct. rewrite sin_PI_x, Rtrigo_facts.cos_pi_minus. unfold Rdiv. ring. Qed.
(** h at the mirror angle: h~ + h = pi (1 + k^2) *)
Lemma hh_mirror p : 0 < p < PI -> hh (PI - p) + hh p = PI * (1 + ct p ^ 2).
Proof. intros Hp. unfold hh, ct. rewrite sin_PI_x, Rtrigo_facts.cos_pi_minus. trig p. Qed.
Lemma two_hh p : 0 < p < PI -> 2 * p - 2 * hh p = ct p * depth p.
Proof. intros Hp. pose proof (next_push 0 p Hp) as Q. rewrite push_0 in Q. lra. Qed.
(** the depth increases *)
Lemma depth_incr p p' : 0 < p -> p < p' -> p' < PI -> depth p < depth p'.
Proof.
  intros. destruct (MVT_cor2 depth (fun t => 2 * hh t) p p' ltac:(lra)) as (t & E & Ht).
  { intros t Ht. apply is_derive_Reals, derive_depth; lra. }
  pose proof (hh_pos t ltac:(lra)). assert (0 < 2 * hh t * (p' - p)) by positive. lra.
Qed.
Section Alternate.
Context (q pc : R) (Hq : 0 < q) (Hpc : PI / 2 < pc < PI) (Dc : depth pc = 2 / q).

(** (a) after a long slip (p >= pc) that crosses, the next contact function at theta~ is at least P *)
Lemma long_value d p : 0 <= d -> pc <= p < PI -> Pf pc <= push (depth p + d - 2 / q) (PI - pc) - (2 * p - push d p).
Proof.
  intros Hd Hp. assert (K : ct p <= ct pc). { destruct (Req_dec pc p) as [<-|]; [lra|]. apply Rlt_le, ct_falls; lra. }
  set (G := fun p => hh (PI - pc) + hh p - 2 * p + ct pc * (depth p - 2 / q)).
  assert (G0 : G pc = Pf pc). { unfold G, Pf. rewrite Dc. pose proof (hh_mirror pc ltac:(lra)). lra. }
  assert (GI : G pc <= G p).
  { destruct (Req_dec pc p) as [<-|]; [lra|].
    destruct (MVT_cor2 G (fun t => depth t * (1 + ct t ^ 2) - 2 + ct pc * (2 * hh t)) pc p ltac:(lra)) as (t & E & Ht).
    { intros t Ht. apply is_derive_Reals. pose proof (derive_hh t ltac:(lra)) as A.
      pose proof (derive_depth t ltac:(lra)) as B. unfold G. auto_derive.
      - repeat split; [eexists; exact A|eexists; exact B].
      - replace (Derive (fun x => hh x) t) with (depth t * (1 + ct t ^ 2)) by (symmetry; apply is_derive_unique;
        exact A).
        replace (Derive (fun x => depth x) t) with (2 * hh t) by (symmetry; apply is_derive_unique; exact B). ring. }
    rewrite half_depth in E by lra. pose proof (ct_falls pc t ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (hh_pos t ltac:(lra)).
    assert (0 <= hh t * (ct pc - ct t)) by positive.
    assert (0 <= (2 * (1 - hh t * ct t) - 2 + ct pc * (2 * hh t)) * (p - pc)) by positive. lra. }
  rewrite <- G0. apply Rle_trans with (1 := GI). unfold push, G. rewrite ct_mirror by lra.
  pose proof (two_hh p ltac:(lra)). assert (0 <= d * (ct pc - ct p)) by positive. lra.
Qed.
(** so the next slip is short *)
Theorem long_to_short d p p' : 0 <= Pf pc -> 0 <= d -> pc <= p < PI -> 0 < p' < PI ->
  push (depth p + d - 2 / q) p' = 2 * p - push d p -> p' <= PI - pc.
Proof.
  intros HP Hd Hp Hp' E. pose proof (long_value d p Hd Hp) as V. destruct (Rle_dec p' (PI - pc)) as [|n]; auto. exfalso.
  assert (De : 2 / q <= depth p). { rewrite <- Dc. destruct (Req_dec pc p) as [<-|]; [lra|].
    apply Rlt_le, depth_incr; lra. }
  pose proof (push_incr (depth p + d - 2 / q) (PI - pc) p' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(** (b) after a short slip (p <= pi - pc) that crosses, u' - kappa_c e >= h_c + P *)
Lemma short_value d p : 0 < p <= PI - pc -> 2 / q <= depth p + d ->
  hh pc + Pf pc <= (2 * p - push d p) + ct pc * (depth p + d - 2 / q).
Proof.
  intros Hp HD. rewrite next_push by lra. set (e := depth p + d - 2 / q).
  replace (depth p + d) with (e + 2 / q) by (unfold e; ring). pose proof (ct_mirror pc ltac:(lra)) as Cm.
  assert (K : - ct pc <= ct p). { rewrite <- Cm. destruct (Req_dec p (PI - pc)) as [->|]; [lra|].
    apply Rlt_le, ct_falls; lra. }
  set (F := fun p => hh p + 2 * ct p / q). assert (FI : F (PI - pc) <= F p).
  { destruct (Req_dec p (PI - pc)) as [->|]; [lra|].
    destruct (MVT_cor2 F (fun t => (depth t - 2 / q) * (1 + ct t ^ 2)) p (PI - pc) ltac:(lra)) as (t & E & Ht).
    { intros t Ht. apply is_derive_Reals, derive_push_next; lra. }
    assert (depth t < 2 / q). { rewrite <- Dc. apply depth_incr; lra. }
    assert (0 <= (2 / q - depth t) * (1 + ct t ^ 2) * (PI - pc - p)) by positive. lra. }
  assert (Fv : F (PI - pc) = hh pc + Pf pc).
  { unfold F. rewrite Cm. pose proof (hh_mirror pc ltac:(lra)). pose proof (two_hh pc ltac:(lra)) as T. rewrite Dc in T.
    unfold Pf. lra. }
  rewrite <- Fv. apply Rle_trans with (1 := FI). unfold F. assert (0 <= (ct p + ct pc) * e) by positive. lra.
Qed.
(** so the next slip is long *)
Theorem short_to_long d p p' : 0 <= Pf pc -> 0 < p <= PI - pc -> 2 / q <= depth p + d -> 0 < p' < PI ->
  push (depth p + d - 2 / q) p' = 2 * p - push d p -> pc <= p'.
Proof.
  intros HP Hp HD Hp' E. pose proof (short_value d p Hp HD) as V. destruct (Rle_dec pc p') as [|n]; auto. exfalso.
  pose proof (push_incr (depth p + d - 2 / q) p' pc ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as I.
  unfold push at 2 in I. lra.
Qed.
End Alternate.
