(** U** without damping. The motion that slips for ever has a closed threshold, and above body 1's resonance the
    relative velocity keeps its sign by itself, so that the threshold decides alone. *)
From InertialPair Require Import Dini Forced Nonstop.

(** an increasing function, by its derivative inside *)
Lemma grows f f' p q : p < q -> (forall t, p <= t <= q -> is_derive f t (f' t)) -> (forall t, p < t < q ->
  0 < f' t) -> f p < f q.
Proof.
  intros Hp D P. destruct (MVT_cor2 f f' p q Hp) as (c & E & Hc); [intros; apply is_derive_Reals, D; auto|].
  specialize (P c Hc). assert (0 < f' c * (q - p)) by positive. lra.
Qed.

(** the chord from 0 lies below a concave function, such as the sine *)
Lemma chord_below f f' y z : f 0 = 0 -> (forall t, is_derive f t (f' t)) ->
  (forall p q, 0 <= p <= q -> q <= z -> f' q <= f' p) -> 0 <= y <= z -> y * f z <= z * f y.
Proof.
  intros F0 D Falls Hy. destruct (Req_dec y 0) as [->|N0]; [rewrite F0; lra|].
  destruct (Req_dec y z) as [->|N1]; [lra|]. destruct (mean_value f f' 0 y ltac:(lra) D) as (p & Hp & E).
  destruct (mean_value f f' y z ltac:(lra) D) as (q & Hq & E'). rewrite F0, !Rminus_0_r in E.
  specialize (Falls p q ltac:(lra) ltac:(lra)). assert (y * (z - y) * f' q <= y * (z - y) * f' p) by scale.
  replace (f z) with (f y + f' q * (z - y)) by lra. rewrite E. nra.
Qed.
Lemma chord y z : 0 <= y <= z -> z <= PI -> y * sin z <= z * sin y.
Proof.
  intros Hy Hz. apply (chord_below sin cos); auto using sin_0; [intros; auto_derive; auto; ring|].
  intros. apply cos_decr_1; lra.
Qed.

(** the tangent is convex: tan (r z) < r tan z *)
Lemma tangent r z : 0 < r < 1 -> 0 < z <= PI / 2 -> sin (r * z) * cos z < r * sin z * cos (r * z).
Proof.
  intros Hr Hz. apply Rminus_gt_0_lt.
  replace 0 with (r * sin 0 * cos (r * 0) - sin (r * 0) * cos 0) by (rewrite Rmult_0_r, sin_0; ring).
  apply (grows (fun y => r * sin y * cos (r * y) - sin (r * y) * cos y) (fun y => (1 - r ^ 2) * (sin y * sin (r *
    y)))); [lra| |].
  - intros t _. auto_derive; auto. ring.
  - intros t Ht. assert (0 < sin t) by (apply sin_gt_0; lra). assert (0 < sin (r * t)) by (apply sin_gt_0; nra).
    assert (0 < 1 - r ^ 2) by nra. apply Rmult_lt_0_compat; auto. positive.
Qed.

(** so sin (r y) / sin y grows up to pi/2 *)
Lemma sine_share r y : 0 < r < 1 -> 0 <= y <= PI / 2 -> sin (r * y) <= sin (r * (PI / 2)) * sin y.
Proof.
  intros Hr Hy. destruct (Req_dec y 0) as [->|N0]; [rewrite Rmult_0_r, sin_0; lra|].
  destruct (Req_dec y (PI / 2)) as [->|N1]; [rewrite sin_PI2; lra|]. assert (Sy : 0 < sin y) by (apply sin_gt_0; lra).
  assert (sin (r * y) / sin y < sin (r * (PI / 2)) / sin (PI / 2)).
  { apply (grows (fun t => sin (r * t) / sin t) (fun t => (r * sin t * cos (r * t) - sin (r * t) * cos t) / (sin t) ^
    2)); [lra| |].
    - intros t Ht. assert (0 < sin t) by (apply sin_gt_0; lra). auto_derive; [lra|]. field; lra.
    - intros t Ht. assert (0 < sin t) by (apply sin_gt_0; lra). pose proof (tangent r t Hr ltac:(lra)).
      apply Rdiv_lt_0_compat; [lra|nra]. }
  rewrite sin_PI2 in H. apply Rmult_lt_compat_r with (r := sin y) in H; auto.
  replace (sin (r * y) / sin y * sin y) with (sin (r * y)) in H by (field; lra). lra.
Qed.

(** a bound by sines *)
Lemma half_turn y : 0 < y < PI -> y < sin y + PI / 2 * (1 - cos y).
Proof.
  intros Hy. pose proof PI2_1. destruct (Rle_dec y (PI / 2)) as [L|L].
  - assert (Up : 0 < sin y + 1 - cos y - y).
    { replace 0 with (sin 0 + 1 - cos 0 - 0) by (rewrite sin_0, cos_0; ring).
      apply (grows (fun z => sin z + 1 - cos z - z) (fun z => cos z + sin z - 1)); [lra| |].
      - intros. auto_derive; auto. ring.
      - intros z Hz. assert (0 < sin z) by (apply sin_gt_0; lra). assert (0 < cos z) by (apply cos_gt_0; lra).
        pose proof (sin2_cos2 z) as I. unfold Rsqr in I. nra. }
    pose proof (COS_bound y). nra.
  - pose proof (chord (y - PI / 2) (PI / 2) ltac:(lra) ltac:(lra)) as C.
    rewrite sin_minus, sin_PI2, cos_PI2 in C. assert (0 < sin y) by (apply sin_gt_0; lra). lra.
Qed.
(** body 2's share of the relative velocity at U** *)
Lemma share_2 y : - (PI / 2) < y < PI / 2 -> 0 < PI / 2 * sin y - y + cos y.
Proof.
  intros Hy. pose proof (half_turn (y + PI / 2) ltac:(lra)) as Q.
  rewrite sin_plus, cos_plus, sin_PI2, cos_PI2 in Q. lra.
Qed.

(** body 1's share, below its resonance *)
Lemma share_1 r y : 0 < r < 1 -> - (PI / 2) < y < PI / 2 ->
  0 < r * cos (r * (PI / 2)) * cos y + sin (r * (PI / 2)) * sin y - sin (r * y).
Proof.
  intros Hr Hy. assert (Cy : 0 < cos y) by (apply cos_gt_0; lra). pose proof PI2_1 as P1.
  assert (Cr : 0 < cos (r * (PI / 2))) by (apply cos_gt_0; nra). destruct (Rle_dec 0 y) as [P|N].
  - pose proof (sine_share r y Hr ltac:(lra)). assert (0 < r * cos (r * (PI / 2)) * cos y) by positive. lra.
  - set (z := PI / 2 + y). assert (Hz : 0 < z <= PI / 2) by (unfold z; lra). replace y with (z - PI / 2) by (unfold z;
    ring).
    replace (r * (z - PI / 2)) with (r * z - r * (PI / 2)) by ring. rewrite (cos_minus z), (sin_minus z), sin_minus,
      cos_PI2, sin_PI2.
    set (c := cos (r * (PI / 2))) in *. set (q := sin (r * (PI / 2))).
    pose proof (tangent r z Hr Hz) as Tg. assert (Cz : 0 < cos (r * z)) by (apply cos_gt_0; nra).
    assert (Cmp : cos z <= cos (r * z)) by (apply cos_decr_1; nra). assert (Tn : sin (r * z) * c <= q * cos (r * z)).
    { cut (0 <= sin (r * (PI / 2) - r * z)); [rewrite sin_minus; fold c q; lra|]. apply sin_ge_0; nra. }
    apply Rmult_lt_reg_l with (cos (r * z)); auto.
    replace (cos (r * z) * (r * c * (cos z * 0 + sin z * 1) + q * (sin z * 0 - cos z * 1) - (sin (r * z) * c - cos (r
      * z) * q)))
      with (c * (r * sin z * cos (r * z) - sin (r * z) * cos z) + (cos (r * z) - cos z) * (q * cos (r * z) - sin (r *
        z) * c)) by ring.
    rewrite Rmult_0_r. assert (0 < c * (r * sin z * cos (r * z) - sin (r * z) * cos z)) by positive.
    assert (0 <= (cos (r * z) - cos z) * (q * cos (r * z) - sin (r * z) * c)) by positive. lra.
Qed.

Section Undamped.
Context (m1 m2 a2 b om : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om).
(** body 1's own frequency over that of the force *)
Let o1 := sqrt (a2 / m1).
Let al := PI * o1 / (2 * om).
Hypotheses (Hc : cos al <> 0) (HZ : a2 <> m1 * om ^ 2).

(** the response of body 1 to the push that is turned round: its place *)
Definition swing t := / a2 * (1 - cos (sqrt (a2 / m1) * (t - PI / (2 * om))) / cos (PI * sqrt (a2 / m1) / (2 * om))).
(** and its speed *)
Definition swing' t := / (m1 * sqrt (a2 / m1)) * (sin (sqrt (a2 / m1) * (t - PI / (2 * om))) / cos (PI * sqrt (a2 /
  m1) / (2 * om))).
Let k := swing.
Let k' := swing'.

(** U** = (b/om^2) |om1^2 - om^2| sqrt (((om/om1) tan (pi om1/(2 om)) + pi m1/(2 m2))^2 + (M/m2)^2) *)
Definition Fslip_undamped := b / om ^ 2 * Rabs (a2 / m1 - om ^ 2) *
  sqrt ((om / sqrt (a2 / m1) * tan (PI * sqrt (a2 / m1) / (2 * om)) + PI * m1 / (2 * m2)) ^ 2 + ((m1 + m2) / m2) ^ 2).

Lemma own_pos : 0 < o1. Proof. positive. Qed.
Lemma own_sq : m1 * (o1 * o1) = a2.
Proof. unfold o1. rewrite sqrt_sqrt by positive. field; lra. Qed.

Lemma derive_k t : is_derive k t (k' t).
Proof.
  pose proof own_pos. unfold k, k', swing, swing'; fold o1; fold al. auto_derive; auto. rewrite <- own_sq.
    unfold Rminus. field. repeat split; lra.
Qed.
Lemma derive_k' t : is_derive k' t ((1 - 0 * k' t - a2 * k t) / m1).
Proof.
  pose proof own_pos. unfold k, k', swing, swing'; fold o1; fold al. auto_derive; auto. rewrite Rmult_0_l.
    unfold Rminus. field. repeat split; lra.
Qed.
Lemma angle_0 : o1 * (0 - PI / (2 * om)) = - al. Proof. unfold al. field; lra. Qed.
Lemma angle_T : o1 * (PI / om - PI / (2 * om)) = al. Proof. unfold al. field; lra. Qed.
Lemma k_0 : k 0 = 0. Proof. unfold k, swing; fold o1; fold al. rewrite angle_0, cos_neg. field; lra. Qed.
Lemma k'_0 : k' 0 = - (tan al / (m1 * o1)).
Proof. pose proof own_pos. unfold k', swing', tan; fold o1; fold al. rewrite angle_0, sin_neg. field; repeat split;
  lra. Qed.

(** the general threshold is this one *)
Lemma Fslip_k : Fslip m1 m2 0 a2 b om (k 0) (k' 0) = Fslip_undamped.
Proof.
  pose proof own_pos. rewrite k_0, k'_0. unfold Fslip, Fslip_undamped. fold o1. fold al.
  set (A := om / o1 * tan al + PI * m1 / (2 * m2)). set (B := (m1 + m2) / m2).
  replace (Z1 m1 0 a2 om * (turn m2 b om (- (tan al / (m1 * o1))) ^ 2 + leave m1 m2 0 a2 b om 0 (- (tan al / (m1 *
    o1))) ^ 2)) with ((b / om ^ 2 * (a2 / m1 - om ^ 2)) ^ 2 * (A ^ 2 + B ^ 2)).
  - rewrite sqrt_mult by (try apply pow2_ge_0; pose proof (pow2_ge_0 A); pose proof (pow2_ge_0 B); lra). f_equal.
    rewrite <- Rsqr_pow2, sqrt_Rsqr_abs, Rabs_mult. f_equal. apply Rabs_pos_eq. apply Rlt_le, Rdiv_lt_0_compat; nra.
  - unfold A, B, turn, leave, Z1. field. repeat split; lra.
Qed.

(** [nonstop-undamped] $a_1=0$: the theorem nonstop-iff with $U_{**}$ in closed form, off the resonances of body 1. *)
Theorem undamped_iff F : 0 <= F -> (forall t, 0 < t < PI / om ->
  0 < slipping m2 b om swing' (leave m1 m2 0 a2 b om 0 (swing' 0)) t) ->
  (exists phi x v1 v2 s, nonstop m1 m2 0 a2 b om F phi x v1 v2 s) <-> Fslip_undamped <= F.
Proof.
  intros HF Side. rewrite <- Fslip_k. pose proof own_pos. assert (ET : k (PI / om) = - k 0).
  { rewrite k_0. unfold k, swing; fold o1; fold al. rewrite angle_T. field; lra. }
  assert (ET' : k' (PI / om) = - k' 0).
  { unfold k', swing'; fold o1; fold al. rewrite angle_T, angle_0, sin_neg. field; repeat split; lra. }
  apply (nonstop_iff m1 m2 0 a2 b om Hm1 Hm2 (Rle_refl 0) Ha2 Hb Hom k k' derive_k derive_k'); auto.
  - unfold Z1. assert (0 < (a2 - m1 * om ^ 2) ^ 2); [|nra]. assert (a2 - m1 * om ^ 2 <> 0) as N by lra.
    pose proof (Rsqr_pos_lt _ N) as Q. unfold Rsqr in Q. lra.
  - apply leaves; auto using derive_k, derive_k'. lra.
  - rewrite k_0. auto.
Qed.
End Undamped.

(** [nonstop-above-resonance] $a_1=0$ and $\omega$ above body 1's own frequency: the motion of nonstop-iff exists
    exactly from $U_{**}$ on, without a condition. *)
Theorem above_resonance m1 m2 a2 b om F : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> 0 <= F -> a2 < m1 * om ^ 2 ->
  (exists phi x v1 v2 s, nonstop m1 m2 0 a2 b om F phi x v1 v2 s) <-> Fslip_undamped m1 m2 a2 b om <= F.
Proof.
  intros Hm1 Hm2 Ha2 Hb Hom HF Ab. set (o1 := sqrt (a2 / m1)). set (r := o1 / om). pose proof PI_RGT_0 as P0.
  assert (Ho : 0 < o1) by (apply own_pos; auto). assert (Hr : 0 < r < 1).
  { split; [positive|]. pose proof (own_sq m1 a2 Hm1 Ha2) as Q. fold o1 in Q.
    assert (o1 < om). { apply Rnot_le_lt. intros N. assert (m1 * (om * om) <= m1 * (o1 * o1)) by (apply
      Rmult_le_compat_l; nra). nra. }
    apply Rmult_lt_reg_r with om; auto. unfold r. replace (o1 / om * om) with o1 by (field; lra). lra. }
  assert (Al : PI * o1 / (2 * om) = r * (PI / 2)) by (unfold r; field; lra).
  assert (Cr : 0 < cos (r * (PI / 2))) by (apply cos_gt_0; nra).
  apply undamped_iff; auto; fold o1; rewrite ?Al; try lra. intros t Ht. set (y := om * t - PI / 2).
  assert (Hy : - (PI / 2) < y < PI / 2).
  { unfold y. split; [nra|]. assert (om * t < om * (PI / om)) by scale.
    replace (om * (PI / om)) with PI in H by (field; lra). lra. }
  assert (K0 : / (m1 * o1) * (sin (o1 * (0 - PI / (2 * om))) / cos (r * (PI / 2))) = - (tan (r * (PI / 2)) / (m1 *
    o1))).
  { replace (o1 * (0 - PI / (2 * om))) with (- (r * (PI / 2))) by (unfold r; field; lra). rewrite sin_neg. unfold tan.
    field. repeat split; lra. }
  unfold slipping, swing'. fold o1. rewrite Al, K0.
  replace (om * t) with (y + PI / 2) by (unfold y; ring). rewrite cos_plus, sin_plus, cos_PI2, sin_PI2.
  replace (o1 * (t - PI / (2 * om))) with (r * y) by (unfold r, y; field; lra).
  replace (t - PI / (2 * om)) with (y / om) by (unfold y; field; lra).
  pose proof (share_1 r y Hr Hy) as S1. pose proof (share_2 y Hy) as S2.
  apply Rlt_le_trans with (b / (m1 * o1 * cos (r * (PI / 2))) * (r * cos (r * (PI / 2)) * cos y + sin (r * (PI / 2)) *
    sin y - sin (r * y))
    + b / (m2 * om) * (PI / 2 * sin y - y + cos y)).
  - apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; auto; apply Rdiv_lt_0_compat; auto;
    repeat apply Rmult_lt_0_compat; auto.
  - apply Req_le. unfold turn, leave, tan. assert (EO : o1 = r * om) by (unfold r; field; lra).
    clearbody y r o1. rewrite EO. field. repeat split; lra.
Qed.
