(** Below the critical share r* = 1/(2 sin^2 phi* ) no slip from S ends at or below E_cr, whatever its gap and its push.

    In D = depth + gap the level after a slip is a parabola, h^2 - 2 (1 - h k) D + (k^2 + q) D^2 with k = cot p,
      and D is at least the depth c. Where k^2 + 2 q >= 1 it rises from D = c on,
      where it is the level after an excursion from a ray,
    which is positive. Elsewhere its least value, h^2 - (1 - h k)^2/(k^2 + q), falls in p up to the angle with
    k^2 + 2 q = 1, and there it is again the level after an excursion from a ray. *)
From InertialPair Require Import Dini Excursion ReturnMap TurningFunction ExitOrbit SlipFromGap AlternatingAngles.

Section Share.
Context (q : R) (Hq : 0 < q < 1).
Let r := 1 - q.

(** the level after a slip with half angle p, as a function of D, and its least value *)
Definition parabola p D := hh p ^ 2 - 2 * (1 - hh p * ct p) * D + (ct p ^ 2 + q) * D ^ 2.
(** and its least value *)
Definition least p := hh p ^ 2 - (1 - hh p * ct p) ^ 2 / (ct p ^ 2 + q).

Lemma leading_pos p : 0 < ct p ^ 2 + q.
Proof. nra. Qed.

(** the parabola is its least value and a square *)
Lemma parabola_least p D : least p <= parabola p D.
Proof.
  pose proof (leading_pos p) as A. unfold least, parabola. set (a := ct p ^ 2 + q) in *. set (w := 1 - hh p * ct p).
  assert (0 <= (a * D - w) ^ 2 / a) by positive.
  replace (hh p ^ 2 - 2 * w * D + a * D ^ 2) with (hh p ^ 2 - w ^ 2 / a + (a * D - w) ^ 2 / a) by (field; lra). lra.
Qed.

(** beyond D = c, where it is the level after an excursion from a ray *)
Lemma parabola_ray p d : 0 < p < PI -> parabola p (depth p + d) =
  hh p ^ 2 - r * depth p ^ 2 + d * (depth p * (ct p ^ 2 + 2 * q - 1) + d * (ct p ^ 2 + q)).
Proof. intros Hp. pose proof (half_depth p Hp) as I. unfold parabola, r. rewrite <- I. ring. Qed.

(** the least value at the angle where k^2 + 2 q = 1 *)
Lemma least_at_turn p : 0 < p < PI -> ct p ^ 2 + 2 * q = 1 -> least p = hh p ^ 2 - r * depth p ^ 2.
Proof.
  intros Hp E. pose proof (half_depth p Hp) as I. unfold least, r.
  replace (1 - hh p * ct p) with (depth p * (1 + ct p ^ 2) / 2) by lra.
    replace (ct p ^ 2) with (1 - 2 * q) by lra. field. lra.
Qed.

(** the slope of the least value: all factors but (k^2 + 2 q - 1) are positive *)
Definition slope p := depth p * (1 + ct p ^ 2) / (ct p ^ 2 + q) ^ 2 * (ct p ^ 2 + 2 * q - 1) * (q * hh p + ct p).
Lemma derive_least p : 0 < p < PI -> is_derive least p (slope p).
Proof.
  intros Hp. pose proof (leading_pos p) as A. pose proof (half_depth p Hp) as I.
  pose proof (derive_hh p Hp) as H. pose proof (derive_ct p Hp) as C. unfold least. auto_derive.
  - repeat split; [eexists; exact H|eexists; exact H|eexists; exact C|eexists; exact C|lra].
  - replace (Derive (fun x => hh x) p) with (depth p * (1 + ct p ^ 2)) by (symmetry; apply is_derive_unique; exact H).
    replace (Derive (fun x => ct x) p) with (- (1 + ct p ^ 2)) by (symmetry; apply is_derive_unique; exact C).
    unfold slope. set (h := hh p) in *. set (c := depth p) in *. set (k := ct p) in *.
    assert (E : c = 2 * (1 - h * k) / (1 + k ^ 2)) by (rewrite <- I; field; pose proof (pow2_ge_0 k); lra). rewrite E.
    field. split; lra.
Qed.

(** q h + k = (q p + r sin p cos p)/sin^2 p is positive if r <= PI/(1 + PI) *)
Lemma push_positive p : r * (1 + PI) <= PI -> 0 < p < PI -> 0 < q * hh p + ct p.
Proof.
  intros Hr Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S.
  replace (q * hh p + ct p) with ((q * p + r * (sin p * cos p)) * / sin p ^ 2) by (unfold hh, ct, r; field; lra).
  apply Rmult_lt_0_compat; [|positive]. unfold r in *. destruct (Rle_dec p (PI / 2)) as [n|n].
  - pose proof (cos_ge_0 p ltac:(lra) ltac:(lra)). assert (0 < q * p) by positive.
    assert (0 <= (1 - q) * (sin p * cos p)) by positive. lra.
  - assert (- (1 / 2) <= sin p * cos p).
    { pose proof (sin2_cos2 p) as SC. unfold Rsqr in SC. pose proof (pow2_ge_0 (sin p + cos p)). lra. }
    assert (q * (PI / 2) < q * p) by nra. assert ((1 - q) * (- (1 / 2)) <= (1 - q) * (sin p * cos p)) by nra. lra.
Qed.

(** the angle beyond pi/2 with k^2 + 2 q = 1 *)
Lemma turn_ex : 2 * q < 1 -> exists t, PI / 2 < t < PI /\ ct t ^ 2 + 2 * q = 1 /\ ct t < 0.
Proof.
  intros Hs. set (ka := sqrt (1 - 2 * q)). assert (K0 : 0 < ka) by positive.
  assert (KK : ka * ka = 1 - 2 * q) by (apply sqrt_sqrt; lra). pose proof (atan_bound (- ka)).
  assert (atan (- ka) < 0) by (rewrite <- atan_0; apply atan_increasing; lra).
  exists (PI / 2 - atan (- ka)). rewrite ct_atan. repeat split; nra.
Qed.

(** No level is below the least one of excursions from a ray. *)
Lemma above_rays p d : r * (1 + PI) <= PI -> (forall p, 0 < p < PI -> 0 < hh p ^ 2 - r * depth p ^ 2) ->
  0 < p < PI -> 0 <= d -> 0 < parabola p (depth p + d).
Proof.
  intros Hr Rays Hp Hd. destruct (Rle_dec 1 (ct p ^ 2 + 2 * q)) as [n|n].
  { rewrite parabola_ray by auto. pose proof (Rays p Hp). pose proof (depth_pos p Hp).
    pose proof (leading_pos p).
    assert (0 <= d * (depth p * (ct p ^ 2 + 2 * q - 1) + d * (ct p ^ 2 + q))) by positive. lra. }
  apply Rnot_le_lt in n. pose proof (pow2_ge_0 (ct p)). destruct turn_ex as (t & Ht & Et & Ct); [lra|].
  apply Rlt_le_trans with (least p); [|apply parabola_least]. assert (Pt : p < t).
  { apply Rnot_le_lt. intros N. pose proof (ct_le t p ltac:(lra) N ltac:(lra)). nra. }
  assert (Fall : least t <= least p).
  { apply Ropp_le_cancel, (rises (fun p => - least p) (fun u => - slope u)); [lra| |]; intros u Hu;
      [apply (is_derive_opp least), derive_least; lra|].
    pose proof (ct_falls p u ltac:(lra) ltac:(lra) ltac:(lra)).
    pose proof (ct_falls u t ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (U : ct u ^ 2 + 2 * q <= 1) by (assert (ct p < - ct t) by nra; nra).
    pose proof (push_positive u Hr ltac:(lra)). pose proof (depth_pos u ltac:(lra)). pose proof (pow2_ge_0 (ct u)).
    unfold slope. set (F := depth u * (1 + ct u ^ 2) / (ct u ^ 2 + q) ^ 2).
    assert (0 <= F * (1 - (ct u ^ 2 + 2 * q)) * (q * hh u + ct u)); [|lra]. apply Rmult_le_pos; [positive|]; lra. }
  rewrite least_at_turn in Fall by lra. pose proof (Rays t ltac:(lra)). lra.
Qed.
End Share.

(** [no-low-level] For $m_1/m_2>-\cos 2\varphi^*$: no slip from $S$, whatever its gap and initial speed, ends at or
    below $E_{cr}$. *)
Theorem no_low_level : exists ps, 0 < ps < PI /\ K ps = 0 /\ forall m1 m2, 0 < m1 -> 0 < m2 ->
  - cos (2 * ps) < m1 / m2 ->
  forall p d, 0 < p < PI -> 0 <= d -> 0 < level m1 m2 p d.
Proof.
  destruct threshold as (ps & Hps & Z & _ & Up & _ & Iff). exists ps. split; [auto|]. split; [auto|].
  intros m1 m2 H1 H2 Hr p d Hp Hd. apply Iff in Hr; auto. set (q := m1 / (m1 + m2)).
  assert (R : m2 / (m1 + m2) = 1 - q) by (unfold q; field; lra). rewrite R in Hr.
  assert (R0 : 0 < m2 / (m1 + m2)) by positive.
    assert (Q0 : 0 < q) by positive.
  specialize (Up (1 - q) ltac:(lra) Hr). change (0 < parabola q p (depth p + d)). apply above_rays; auto; try lra.
  (* the excursion of half angle pi/2 bounds the share: r < PI^2/16 *)
   pose proof pi_below. specialize (Up (PI / 2) ltac:(lra)). rewrite hh_half_pi in Up.
   assert (De : depth (PI / 2) = 2) by (unfold depth; rewrite sin_PI2, cos_PI2; field). nra.
Qed.
