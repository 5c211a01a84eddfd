(** Long and short slips alternate: the identities and inequalities of one slip after another, in the half angle p
    (theta = 2 p, k = cot p, c the depth, D = c + gap). A slip is long if its depth alone reaches the other end of S0.
    After a long slip that crosses, the next contact function at the mirror angle is at least P = pi (1 + k^2) - theta;
    after a short one that crosses, the next push exceeds that of the shortest long slip by at least P. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Excursion ReturnMap SlipFromGap.

(** the slope of what is made of h, c and k *)
Ltac slope p := let S := fresh in pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S; unfold hh, depth, ct;
  auto_derive;
  [repeat split; auto; apply Rgt_not_eq; nra|trig p].
Lemma derive_ct p : 0 < p < PI -> is_derive ct p (- (1 + ct p ^ 2)).
Proof. intros Hp. slope p. Qed.
(** h' = c (1 + k^2), in the half angle *)
Lemma derive_hh p : 0 < p < PI -> is_derive hh p (depth p * (1 + ct p ^ 2)).
Proof. intros Hp. slope p. Qed.
(** c' = 2 h, in the half angle *)
Lemma derive_depth p : 0 < p < PI -> is_derive depth p (2 * hh p).
Proof. intros Hp. slope p. Qed.

(** the depth increases *)
Lemma depth_incr : rising PI depth.
Proof.
  intros p q Hp L Hq. apply (climbs depth (fun t => 2 * hh t)); [auto|intros t Ht; apply derive_depth; lra|].
  intros t Ht. pose proof (hh_pos t ltac:(lra)). lra.
Qed.
Lemma ct_2PI3 : ct (2 * (PI / 3)) = - / sqrt 3.
Proof. unfold ct. rewrite cos_2PI3, sin_2PI3. pose proof (sqrt_lt_R0 3 ltac:(lra)). field. lra. Qed.

(** P = pi (1 + k^2) - theta *)
Definition Pf p := PI * (1 + ct p ^ 2) - 2 * p.
(** A3: it has the sign of pi k - 2 + c (p - pi/2), which rises and is 0 at 2 pi/3 *)
Theorem P_sign p : PI / 2 < p < PI -> (0 <= Pf p <-> / sqrt 3 <= - ct p).
Proof.
  intros Hp. set (g := fun u => PI * - ct u - 2 + depth (u - PI / 2)).
  assert (G : forall u, PI / 2 < u < PI -> 0 < - ct u /\ Pf u = - ct u * g u).
  { intros u Hu. pose proof (sin_gt_0 u ltac:(lra) ltac:(lra)). pose proof (cos_lt_0 u ltac:(lra) ltac:(lra)).
    assert (Sa : sin (u - PI / 2) = - cos u) by (rewrite <- sin_shift, <- sin_neg; f_equal; ring).
    assert (Ca : cos (u - PI / 2) = sin u) by (rewrite <- cos_shift, <- cos_neg; f_equal; ring).
    unfold g, Pf, ct, depth. rewrite Sa, Ca. split; [|field; lra].
    replace (- (cos u / sin u)) with (- cos u / sin u) by (field; lra). positive. }
  assert (R : forall u v, PI / 2 < u -> u < v -> v < PI -> g u < g v /\ - ct u < - ct v).
  { intros u v Hu L Hv. pose proof (ct_falls u v ltac:(lra) L Hv).
    pose proof (depth_incr (u - PI / 2) (v - PI / 2) ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (PI * - ct u < PI * - ct v) by (apply Rmult_lt_compat_l; lra). unfold g. lra. }
  pose proof (sqrt_lt_R0 3 ltac:(lra)) as S3. set (z := 2 * (PI / 3)).
  assert (Cz : ct z = - / sqrt 3) by apply ct_2PI3. assert (Hz : PI / 2 < z < PI) by (unfold z; lra).
  destruct (G p Hp) as (K & ->), (G z Hz) as (Kz & Ez). assert (Pz : Pf z = 0).
  { unfold Pf. rewrite Cz. replace ((- / sqrt 3) ^ 2) with (/ (sqrt 3 * sqrt 3)) by (field; lra).
    rewrite sqrt_sqrt by lra. unfold z. field. }
  assert (Gz : g z = 0) by nra. replace (/ sqrt 3) with (- ct z) by lra. clear - R Hp Hz K Gz.
  destruct (Rtotal_order p z) as [L|[->|L]]; [destruct (R p z); try lra| |destruct (R z p); try lra]; split;
    intros; nra.
Qed.

(** the mirror angle theta~ = 2 pi - theta: k~ = - k, h~ + h = pi (1 + k^2); and 2 h - theta = - k c *)
Lemma ct_mirror p : 0 < p < PI -> ct (PI - p) = - ct p.
Proof. intros Hp. unfold ct. rewrite sin_PI_x, Rtrigo_facts.cos_pi_minus. unfold Rdiv. ring. Qed.
(** h at the mirror angle: h~ + h = pi (1 + k^2) *)
Lemma hh_mirror p : 0 < p < PI -> hh (PI - p) + hh p = PI * (1 + ct p ^ 2).
Proof. intros Hp. unfold hh, ct. rewrite sin_PI_x, Rtrigo_facts.cos_pi_minus. trig p. Qed.
Lemma two_hh p : 0 < p < PI -> 2 * p - 2 * hh p = ct p * depth p.
Proof. intros Hp. pose proof (next_push 0 p Hp) as Q. rewrite push_0 in Q. lra. Qed.
Section Alternate.
Context (q pc : R) (Hpc : PI / 2 < pc < PI) (Dc : depth pc = 2 / q).

(** (a) after a long slip (p >= pc) that crosses, the next contact function at theta~ is at least P *)
Lemma long_value d p : 0 <= d -> pc <= p < PI -> Pf pc <= push (depth p + d - 2 / q) (PI - pc) - (2 * p - push d p).
Proof.
  intros Hd Hp. pose proof (ct_le pc p ltac:(lra) ltac:(lra) ltac:(lra)) as K.
  assert (G : hh pc + ct pc * depth pc - 2 * pc <= hh p + ct pc * depth p - 2 * p).
  { apply (rises (fun t => hh t + ct pc * depth t - 2 * t) (fun t => 2 * hh t * (ct pc - ct t))); [lra| |];
      intros t Ht.
    - generalize (ct pc). intros k. slope t.
    - pose proof (ct_le pc t ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (hh_pos t ltac:(lra)). positive. }
  rewrite Dc in G. pose proof (hh_mirror pc ltac:(lra)). pose proof (two_hh p ltac:(lra)). unfold push, Pf.
  rewrite ct_mirror by lra. assert (0 <= d * (ct pc - ct p)) by positive. lra.
Qed.
(** so the next slip is short *)
Theorem long_to_short d p p' : 0 <= Pf pc -> 0 <= d -> pc <= p < PI -> 0 < p' < PI ->
  push (depth p + d - 2 / q) p' = 2 * p - push d p -> p' <= PI - pc.
Proof.
  intros HP Hd Hp Hp' E. pose proof (long_value d p Hd Hp) as V. destruct (Rle_dec p' (PI - pc)) as [|n]; auto. exfalso.
  pose proof (rising_le PI depth pc p depth_incr ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (push_incr (depth p + d - 2 / q) (PI - pc) p' ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(** (b) after a short slip (p <= pi - pc) that crosses, u' - kappa_c e >= h_c + P *)
Lemma short_value d p : 0 < p <= PI - pc -> 2 / q <= depth p + d ->
  hh pc + Pf pc <= (2 * p - push d p) + ct pc * (depth p + d - 2 / q).
Proof.
  intros Hp HD. rewrite next_push by lra. set (e := depth p + d - 2 / q).
  replace (depth p + d) with (e + 2 / q) by (unfold e; ring). pose proof (ct_mirror pc ltac:(lra)) as Cm.
  pose proof (ct_le p (PI - pc) ltac:(lra) ltac:(lra) ltac:(lra)) as K.
  assert (F : hh (PI - pc) + 2 / q * ct (PI - pc) <= hh p + 2 / q * ct p).
  { apply Ropp_le_cancel. apply (rises (fun t => - (hh t + 2 / q * ct t)) (fun t => (2 / q - depth t) * (1 +
      ct t ^ 2)));
      [lra| |]; intros t Ht; [generalize (2 / q); intros k; slope t|].
    pose proof (rising_le PI depth t pc depth_incr ltac:(lra) ltac:(lra) ltac:(lra)). rewrite <- Dc.
    positive. }
  pose proof (hh_mirror pc ltac:(lra)). pose proof (two_hh pc ltac:(lra)) as T. rewrite Dc in T.
  rewrite Cm in F, K. unfold Pf. assert (0 <= (ct p + ct pc) * e) by positive. lra.
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
