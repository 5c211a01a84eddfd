(** Any slip that starts on S at or beyond the end of the strip: gap d >= 0, push u; it ends where hh p - d cot p =
    u. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap FollowArc Cycle.

(** k = cot p *)
Definition ct p := cos p / sin p.
(** the push whose slip from the gap d has the half angle p *)
Definition push d p := hh p - d * ct p.

Lemma ct_falls p q : 0 < p -> p < q -> q < PI -> ct q < ct p.
Proof.
  intros. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (sin_gt_0 q ltac:(lra) ltac:(lra)) as S'.
  assert (E : ct p - ct q = sin (q - p) / (sin p * sin q)). { rewrite sin_minus. unfold ct. field. lra. }
  assert (0 < sin (q - p) / (sin p * sin q)) by (apply Rdiv_lt_0_compat;
    [apply sin_gt_0; lra|apply Rmult_lt_0_compat; auto]). lra.
Qed.
Lemma ct_le p q : 0 < p -> p <= q -> q < PI -> ct q <= ct p.
Proof. intros Hp [L|<-] Hq; [apply Rlt_le, ct_falls|]; lra. Qed.
Lemma ct_atan c : ct (PI / 2 - atan c) = c.
Proof. unfold ct. rewrite sin_shift, cos_shift. apply tan_atan. Qed.
(** h - d cot increases from -oo to +oo: one root *)
Lemma push_incr d p q : 0 <= d -> 0 < p -> p < q -> q < PI -> push d p < push d q.
Proof.
  intros Hd H0 Hpq Hq. pose proof (hh_incr p q H0 Hpq Hq). pose proof (ct_falls p q H0 Hpq Hq). unfold push.
  assert (d * ct q <= d * ct p) by nra. lra.
Qed.
(** what is below u at one angle is u at another *)
Lemma push_ex d u p0 : 0 < p0 < PI -> push d p0 < u -> {p | 0 < p < PI /\ push d p = u}.
Proof.
  intros Hp P. set (F := fun p => p - sin p * cos p - d * (sin p * cos p) - u * sin p ^ 2).
  assert (E : forall p, 0 < p < PI -> 0 < sin p ^ 2 /\ F p = sin p ^ 2 * (push d p - u)).
  { intros p Hq. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). split; [positive|].
    unfold F, push, hh, ct. field. lra. }
  destruct (IVT F p0 PI) as (z & Hz & Z); [unfold F; reg|lra|destruct (E p0 Hp) as (Q & ->); nra| |].
  { unfold F. rewrite sin_PI. lra. }
  assert (z <> PI) by (intros ->; unfold F in Z; rewrite sin_PI in Z; lra). exists z. split; [lra|].
  destruct (E z ltac:(lra)) as (Q & R). apply Rmult_eq_reg_l with (sin z ^ 2); lra.
Qed.
(** one half angle for each push *)
Theorem push_root d u : 0 < d -> exists! p, 0 < p < PI /\ push d p = u.
Proof.
  intros Hd. assert (Ex : exists p, 0 < p < PI /\ push d p = u).
  { (* as the cotangent goes to infinity *)
    set (c := (PI / 2 + Rabs u + 1) / d). pose proof PI_RGT_0. pose proof (Rabs_pos u). pose proof (Rle_abs (- u)) as Au.
    rewrite Rabs_Ropp in Au. assert (Hc : 0 < c) by positive.
    assert (Ec : d * c = PI / 2 + Rabs u + 1) by (unfold c; field; lra). pose proof (atan_bound c).
    assert (0 < atan c) by (rewrite <- atan_0; apply atan_increasing; auto). set (p0 := PI / 2 - atan c).
    destruct (push_ex d u p0) as (p & P); [unfold p0; lra| |exists p; auto].
    assert (hh p0 < hh (PI / 2)) as Hh by (apply hh_incr; unfold p0; lra).
    replace (hh (PI / 2)) with (PI / 2) in Hh by (unfold hh; rewrite sin_PI2, cos_PI2; field). unfold push.
    unfold p0 at 2. rewrite ct_atan. lra. }
  destruct Ex as (p & Hp & E). exists p. split; [auto|]. intros p' (Hp' & E').
  apply (rising_one PI (push d)); auto; [|lra]. intros u1 u2. apply push_incr. lra.
Qed.
(** without a gap the push is h *)
Lemma push_0 p : push 0 p = hh p. Proof. unfold push. ring. Qed.

(** A1: theta - u = h + k D, with D = c + d, k = cot p, theta = 2 p, u = h - k d *)
Theorem next_push d p : 0 < p < PI -> 2 * p - push d p = hh p + ct p * (depth p + d).
Proof. intros Hp. unfold push, hh, ct, depth. trig p. Qed.

(** derivatives in p: h' = c (1 + k^2), k' = -(1 + k^2), c' = 2 h; so (h + 2 k/q)' = (c - 2/q)(1 + k^2) (twice the one
    in theta) *)
(** 1 - h k = c (1 + k^2) / 2 *)
Lemma half_depth p : 0 < p < PI -> depth p * (1 + ct p ^ 2) = 2 * (1 - hh p * ct p).
Proof. intros Hp. unfold hh, ct, depth. trig p. Qed.

Section Gap.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (M := m1 + m2) (q := m1 / M) (r := m2 / M) (o1 := o1 m1 a2) (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2
  b)
  (ray := ray m1 m2 a2 b).

(** on S on the side k, a gap q d beyond the end of the strip, moving outwards at the speed ray u *)
Definition at_gap k d u (x v1 v2 : R -> R) t := k * x t = L * (1 + q * d) /\ k * v1 t = ray u /\ k * v2 t = ray u.
(** an exit ray is a gap of 0 *)
Lemma ray_gap k u x v1 v2 t : on_ray m1 m2 a2 b k u x v1 v2 t <-> at_gap k 0 u x v1 v2 t.
Proof. unfold on_ray, at_gap. rewrite Rmult_0_r, Rplus_0_r, Rmult_1_r. tauto. Qed.
(** the slip from a gap: place of body 1 *)
Definition Gx d u t := b / a2 + b * m1 / (a2 * m2) * ((1 + d) * cos (o1 * t) + u * sin (o1 * t)).
(** its speed *)
Definition G1 d u t := b / (m2 * o1) * (u * cos (o1 * t) - (1 + d) * sin (o1 * t)).
(** the speed of body 2 *)
Definition G2 u t := b / (m2 * o1) * (u - o1 * t).

(** the guard v1 - v2 is a positive multiple of push d (theta/2) - u *)
Lemma guard d u t : 0 < o1 * t < 2 * PI ->
  G1 d u t - G2 u t = b / (m2 * o1) * (2 * sin (o1 * t / 2) ^ 2) * (push d (o1 * t / 2) - u).
Proof.
  intros Th. assert (O : 0 < o1) by (apply o1_pos; auto). set (z := o1 * t / 2).
  assert (Ez : o1 * t = 2 * z) by (unfold z; field). pose proof (sin_gt_0 z ltac:(lra) ltac:(lra)) as S. unfold G1, G2.
  rewrite Ez, cos_2a_sin, sin_2a. unfold push, hh, ct. field. lra.
Qed.
(** v1 < v2 until the half angle p *)
Lemma gap_sign d p t : 0 <= d -> 0 < p < PI -> 0 < t < 2 * p / o1 -> G1 d (push d p) t < G2 (push d p) t.
Proof.
  intros Hd Hp Ht. assert (O : 0 < o1) by (apply o1_pos; auto). assert (Th : 0 < o1 * t < 2 * p).
  { split; [apply Rmult_lt_0_compat; lra|]. replace (2 * p) with (o1 * (2 * p / o1)) by (field; lra).
    apply Rmult_lt_compat_l; lra. }
  pose proof (guard d (push d p) t ltac:(lra)) as G.
  pose proof (push_incr d (o1 * t / 2) p Hd ltac:(lra) ltac:(lra) ltac:(lra)) as I.
  pose proof (pow_lt _ 2 (sin_gt_0 (o1 * t / 2) ltac:(lra) ltac:(lra))) as S.
  assert (0 < b / (m2 * o1) * (2 * sin (o1 * t / 2) ^ 2)) by positive. nra.
Qed.
(** the slip obeys the law until then *)
Lemma gap_arc d p : 0 <= d -> 0 < p < PI ->
  arc m1 m2 a2 b (2 * p / o1) (Gx d (push d p)) (G1 d (push d p)) (G2 (push d p)) (fun _ => -1).
Proof.
  intros Hd Hp. assert (O : 0 < o1) by (apply o1_pos; auto).
    assert (Q : a2 = m1 * (o1 * o1)) by (apply o1_sq; auto). constructor.
  - intros t. unfold Gx, G1. auto_derive; auto. rewrite Q. field. repeat split; lra.
  - intros t. unfold Gx, G1. auto_derive; auto. field. repeat split; lra.
  - intros t. unfold G2. auto_derive; auto. field. repeat split; lra.
  - split; [lra|]. split; [|auto]. intros N. destruct (Req_dec t 0) as [Z|Z].
    + rewrite Z in N. unfold G1, G2 in N. rewrite Rmult_0_r, cos_0, sin_0 in N. lra.
    + pose proof (gap_sign d p t Hd Hp ltac:(lra)). lra.
Qed.

(** it ends at X = 1 - q D, both speeds - ray (h + k D), D = c + d *)
Lemma gap_end d p : 0 < p < PI -> let D := depth p + d in
  Gx d (push d p) (2 * p / o1) = L * (1 - q * D) /\
  G1 d (push d p) (2 * p / o1) = - ray (hh p + ct p * D) /\ G2 (push d p) (2 * p / o1) = - ray (hh p + ct p * D).
Proof.
  intros Hp D. assert (O : 0 < o1) by (apply o1_pos; auto).
  assert (A1 : push d p - 2 * p = - (hh p + ct p * D)) by (unfold D; rewrite <- next_push; auto; ring).
  assert (E1 : push d p * (1 - 2 * sin p * sin p) - (1 + d) * (2 * sin p * cos p) = push d p - 2 * p)
    by (unfold push, hh, ct; trig p). assert (E2 : (1 + d) * (1 - 2 * sin p * sin p) + push d p * (2 * sin p * cos p) =
    1 - D) by (unfold D, push, hh, ct, depth; trig p). unfold Gx, G1, G2.
  replace (o1 * (2 * p / o1)) with (2 * p) by (field; lra). rewrite cos_2a_sin, sin_2a, E1, E2, A1.
  unfold ray, Cycle.ray. fold o1. split; [|split; ring]. unfold L, Stick.L, q, M. field. repeat split; lra.
Qed.

(** the energy at X = 1 - q D and the speed ray w: E_cr (1 + q y'), y' = w^2 - 2 D + q D^2 *)
Definition level p d := let D := depth p + d in hh p ^ 2 - 2 * (1 - hh p * ct p) * D + (ct p ^ 2 + q) * D ^ 2.
(** that level, computed *)
Lemma gap_energy p d : let D := depth p + d in
  energy m1 m2 a2 (L * (1 - q * D)) (- ray (hh p + ct p * D)) (- ray (hh p + ct p * D)) = Ecr * (1 + q * level p d).
Proof.
  intros D. set (w := hh p + ct p * D). pose proof (ray_level m1 m2 a2 b Hm1 Hm2 Ha2 w) as R. fold M q L ray in R.
  fold Ecr in R. assert (R1 : energy m1 m2 a2 (L * (1 - q * D)) (- ray w) (- ray w) = energy m1 m2 a2 L (ray w) (ray w)
    + Ecr * ((1 - q * D) ^ 2 - 1)).
  { unfold Ecr. rewrite Ecr_L by auto. fold L. unfold energy. field. }
  rewrite R1, R. unfold level, w. fold D. ring.
Qed.

(** [gap-slip] A slip from $S$ with a gap and the initial speed of an angle, in closed form up to that angle, where it
    ends. *)
Theorem gap_slip k x v1 v2 s t0 d p : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> 0 <= d ->
  0 < p < PI ->
  at_gap k d (push d p) x v1 v2 t0 -> let t1 := t0 + 2 * p / o1 in let D := depth p + d in
  (forall u, 0 <= u <= 2 * p / o1 -> k * x (t0 + u) = Gx d (push d p) u /\ k * v1 (t0 + u) = G1 d (push d p) u /\
    k * v2 (t0 + u) = G2 (push d p) u) /\
  (forall t, t0 < t < t1 -> k * v1 t < k * v2 t) /\
  k * x t1 = L * (1 - q * D) /\ k * v1 t1 = - ray (hh p + ct p * D) /\ k * v2 t1 = - ray (hh p + ct p * D) /\
  energy m1 m2 a2 (x t1) (v1 t1) (v2 t1) = Ecr * (1 + q * level p d).
Proof.
  intros Hk H Ht Hd Hp HG t1 D. assert (O : 0 < o1) by (apply o1_pos; auto).
    assert (T0 : 0 < 2 * p / o1) by positive.
  assert (F : forall u, 0 <= u <= 2 * p / o1 -> k * x (t0 + u) = Gx d (push d p) u /\
    k * v1 (t0 + u) = G1 d (push d p) u /\ k * v2 (t0 + u) = G2 (push d p) u).
  { destruct HG as (Ex & Ey & Ez). apply (follow m1 m2 a2 b Hm1 Hm2 Ha2 Hb _ _ _ _ _ _ _ _ _ t0 (sided m1 m2 a2 b k _ _
      _ _ Hk H) (gap_arc d p Hd Hp) Ht).
    - rewrite Ex. unfold Gx. rewrite Rmult_0_r, cos_0, sin_0. unfold L, Stick.L, q, M. field. lra.
    - rewrite Ey. unfold G1, ray, Cycle.ray. fold o1. rewrite Rmult_0_r, cos_0, sin_0. ring.
    - rewrite Ez. unfold G2, ray, Cycle.ray. fold o1. ring. }
  destruct (gap_end d p Hp) as (Lx & L1 & L2). fold D in Lx, L1, L2.
    destruct (F (2 * p / o1) ltac:(lra)) as (A & B & C). fold t1 in A, B, C.
  rewrite Lx in A. rewrite L1 in B. rewrite L2 in C. split; [exact F|]. split.
  { intros t Hu. destruct (F (t - t0) ltac:(unfold t1 in Hu; lra)) as (_ & A' & B').
    replace (t0 + (t - t0)) with t in A', B' by ring. rewrite A', B'. apply gap_sign; auto. unfold t1 in Hu; lra. }
  repeat (split; [auto; fail|]). rewrite <- (gap_energy p d). fold D. rewrite <- A. rewrite <- B at 1. rewrite <- C.
  symmetry. apply energy_side; auto.
Qed.

(** it ends in S0 if it goes no further than the width of S0 *)
Lemma lands k y d p : k = 1 \/ k = -1 -> 0 <= d -> 0 < p < PI -> k * y = L * (1 - q * (depth p + d)) ->
  depth p + d <= 2 / q -> - L <= y <= L.
Proof.
  intros Hk Hd Hp E HD. pose proof (depth_pos p Hp). pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. fold M q in Q0.
  pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0. fold L in L0. apply Rle_div_r in HD; [|lra].
  assert (0 < q * (depth p + d)) by (apply Rmult_lt_0_compat; lra).
  assert (- L <= k * y <= L) by (rewrite E; split; nra). destruct Hk; subst k; lra.
Qed.

(** [crossing] A slip that ends beyond the other end of $S_0$ is followed by one of the other sign. *)
Theorem crossing k x v1 v2 s t0 d p : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> 0 <= d ->
  0 < p < PI ->
  at_gap k d (push d p) x v1 v2 t0 -> 2 / q < depth p + d ->
  let t1 := t0 + 2 * p / o1 in let d' := depth p + d - 2 / q in let u' := 2 * p - push d p in
  0 < d' /\ (forall t, t0 < t < t1 -> k * v1 t < k * v2 t) /\ at_gap (- k) d' u' x v1 v2 t1 /\
    u' = hh p + ct p * (depth p + d) /\
  exists p', 0 < p' < PI /\ push d' p' = u' /\ (forall p2, 0 < p2 < PI -> push d' p2 = u' -> p2 = p') /\
    (forall t, t1 < t < t1 + 2 * p' / o1 -> k * v2 t < k * v1 t) /\ v1 (t1 + 2 * p' / o1) = v2 (t1 + 2 * p' / o1).
Proof.
  intros Hk H Ht Hd Hp HG HD t1 d' u'. assert (O : 0 < o1) by (apply o1_pos; auto).
  assert (T0 : 0 < 2 * p / o1) by positive.
  destruct (gap_slip k x v1 v2 s t0 d p Hk H Ht Hd Hp HG) as (_ & Sg & A & B & C & _). fold t1 in Sg, A, B, C.
  assert (D0 : 0 < d') by positive. assert (U : u' = hh p + ct p * (depth p + d)) by (apply next_push; auto).
  assert (Q0 : 0 < q) by positive. assert (G : at_gap (- k) d' u' x v1 v2 t1).
  { rewrite <- U in B, C. split; [|split; lra]. replace (- k * x t1) with (- (k * x t1)) by ring. rewrite A. unfold d'.
    field. lra. }
  assert (Hk' : - k = 1 \/ - k = -1) by lra. repeat (split; [auto; fail|]).
  destruct (push_root d' u' D0) as (p' & (Hp' & E) & Un). exists p'. split; [auto|]. split; [auto|]. split.
  - symmetry. apply Un; auto.
  - rewrite <- E in G. destruct (gap_slip (- k) x v1 v2 s t1 d' p' Hk' H ltac:(unfold t1;
    lra) ltac:(lra) Hp' G) as (_ & S2 & _ & B2 & C2 & _).
    split; [intros t Hu; specialize (S2 t Hu); lra|]. destruct Hk; subst k; lra.
Qed.

(** the level after a slip is the level before it minus r c (c + 2 d) *)
Lemma level_loss p d : 0 < p < PI ->
  level p d = push d p ^ 2 + 2 * d + q * d ^ 2 - r * (depth p * (depth p + 2 * d)).
Proof.
  intros Hp. unfold level, push. replace r with (1 - q) by (unfold q, r, M; field; lra).
  generalize q. intros q'. unfold hh, ct, depth. trig p.
Qed.
(** with no gap that of the return map *)
Lemma level_0 p : 0 < p < PI -> level p 0 = hh p ^ 2 - r * depth p ^ 2.
Proof. intros Hp. rewrite level_loss, push_0 by auto. ring. Qed.

(** *** From an exit ray, without a gap: every solution slips until the half angle p with hh p = u *)
Let on_ray := on_ray m1 m2 a2 b.

(** where it ends, and at which level: that of the return map *)
Lemma ray_slip k x v1 v2 s t0 p : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 ->
  0 < p < PI -> on_ray k (hh p) x v1 v2 t0 -> let t1 := t0 + 2 * p / o1 in
  (forall t, t0 < t < t1 -> k * v1 t < k * v2 t) /\ v1 t1 = v2 t1 /\ k * x t1 = L * (1 - q * depth p) /\
  k * v1 t1 = - ray (2 * p - hh p) /\
  energy m1 m2 a2 (x t1) (v1 t1) (v2 t1) = Ecr * (1 + q * (hh p ^ 2 - r * depth p ^ 2)).
Proof.
  intros Hk H Ht Hp HR t1. apply ray_gap in HR. rewrite <- (push_0 p) in HR.
  destruct (gap_slip k x v1 v2 s t0 0 p Hk H Ht (Rle_refl 0) Hp HR)
    as (_ & Sg & A & B & C & En). fold o1 t1 in Sg, A, B, C, En. rewrite <- next_push, push_0 in B, C by auto.
  rewrite Rplus_0_r in A.
  rewrite level_0 in En by auto. repeat (split; [auto; fail|]). split; [destruct Hk; subst k; lra|auto].
Qed.

(** [slip-arc] From the right exit ray with the exit speed $h$ of an angle every solution slips up to that angle, and
    ends where the closed form says. *)
Theorem slip x v1 v2 s t0 p : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> 0 < p < PI -> on_ray 1 (hh p) x v1 v2 t0 ->
  (forall u, 0 < u < 2 * p / o1 -> v1 (t0 + u) < v2 (t0 + u)) /\
  x (t0 + 2 * p / o1) = L * (1 - q * depth p) /\
  v1 (t0 + 2 * p / o1) = ray (hh p - 2 * p) /\ v2 (t0 + 2 * p / o1) = ray (hh p - 2 * p).
Proof.
  intros H Ht Hp HR. destruct (ray_slip 1 x v1 v2 s t0 p (or_introl eq_refl) H Ht Hp HR) as (Sg & Ev & A & B &
    _).
  split; [intros u Hu; specialize (Sg (t0 + u) ltac:(lra)); lra|]. unfold ray, Cycle.ray in *.
  repeat split; lra.
Qed.
End Gap.
