(** The shape of an excursion by its angle: h increases from 0 to infinity and is convex, the depth c increases with it
    from 0 to infinity and is concave in h^2; which slips end where, and by which ray the pair leaves next. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap FollowArc Cycle SlipFromGap ExitOrbit
  SharpRate AlternatingAngles SharpLaw.

(** *** h *)
(** its rate *)
Definition h1 u := (2 - 2 * cos u - u * sin u) / (1 - cos u) ^ 2.
(** and the rate of that *)
Definition h2 u := (u * (2 + cos u) - 3 * sin u) / (1 - cos u) ^ 2.
Lemma h_derive u : 0 < u < 2 * PI -> is_derive h u (h1 u).
Proof. exact (h_rate u). Qed.
Lemma h1_derive u : 0 < u < 2 * PI -> is_derive h1 u (h2 u).
Proof.
  intros Hu. pose proof (one_cos u Hu).
  assert (E : h2 u = ((sin u - u * cos u) * (1 - cos u) - 2 * (2 - 2 * cos u - u * sin u) * sin u) / (1 - cos u) ^ 3).
  { replace ((sin u - u * cos u) * (1 - cos u) - 2 * (2 - 2 * cos u - u * sin u) * sin u)
      with ((1 - cos u) * (u * (2 + cos u) - 3 * sin u)) by (circle u; nsatz). unfold h2. field. lra. }
  rewrite E. unfold h1. auto_derive; [apply Rgt_not_eq; nra|]. field. lra.
Qed.
Lemma h1_pos u : 0 < u < 2 * PI -> 0 < h1 u.
Proof. intros Hu. apply Rdiv_lt_0_compat; [apply N_pos; auto|apply pow_lt, one_cos; auto]. Qed.
Lemma h2_pos u : 0 < u < 2 * PI -> 0 < h2 u.
Proof.
  intros Hu. apply Rdiv_lt_0_compat; [pose proof (cusa_strict u Hu); lra|apply pow_lt, one_cos; auto].
Qed.
Lemma h_small u : 0 < u <= PI -> h u <= u.
Proof. intros Hu. pose proof (one_cos u ltac:(lra)). undivide (1 - cos u). pose proof (g_nonneg u ltac:(lra)). lra. Qed.

(** *** c *)
Definition c u := depth (u / 2).
Lemma c_derive u : 0 < u < 2 * PI -> is_derive c u (h u).
Proof.
  intros Hu. pose proof (sin_gt_0 (u / 2) ltac:(lra) ltac:(lra)).
  replace (h u) with (hh (u / 2)) by (rewrite hh_h by lra; f_equal; field). unfold c, depth, hh.
  auto_derive; change (u * / 2) with (u / 2); [lra|trig (u / 2)].
Qed.
Lemma h_pos u : 0 < u < 2 * PI -> 0 < h u.
Proof. intros Hu. replace u with (2 * (u / 2)) by field. rewrite <- hh_h by lra. apply hh_pos. lra. Qed.

Lemma c_increases : rising (2 * PI) c.
Proof. intros u v Hu L Hv. apply (climbs c h); [auto| |]; intros t Ht; [apply c_derive|apply h_pos]; lra. Qed.
(** every value that is taken at an angle is taken at no other one by a function that rises *)
Lemma one_angle (f : R -> R) y : rising (2 * PI) f -> (exists u, 0 < u < 2 * PI /\ f u = y) ->
  exists! u, 0 < u < 2 * PI /\ f u = y.
Proof.
  intros Up (u & Hu & E). exists u. split; auto. intros v (Hv & E'). apply (rising_one (2 * PI) f); auto. lra.
Qed.

(** the depth takes every value *)
Lemma depth_ex y : 0 < y -> exists p, 0 < p < PI /\ depth p = y.
Proof.
  intros Hy. set (p0 := Rmin (y / 8) (1 / 2)). pose proof PI2_1.
  assert (P0 : 0 < p0 <= 1 / 2 /\ p0 <= y / 8) by (unfold p0, Rmin; destruct Rle_dec; lra).
  set (F := fun p => 2 * (sin p - p * cos p) - y * sin p).
  assert (E : forall p, 0 < p < PI -> 0 < sin p /\ F p = sin p * (depth p - y)).
  { intros p Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). split; auto. unfold F, depth. field. lra. }
  destruct (IVT F p0 PI) as (z & Hz & Z); [unfold F; reg|lra| | |].
  - destruct (E p0 ltac:(lra)) as (Sp & ->). assert (depth p0 < y); [|nra].
    pose proof (depth_upper p0 ltac:(lra)) as U. pose proof (hh_pos p0 ltac:(lra)). rewrite hh_h in * by lra.
    pose proof (h_small (2 * p0) ltac:(lra)). nra.
  - unfold F. rewrite sin_PI, cos_PI. lra.
  - assert (z <> PI) by (intros ->; unfold F in Z; rewrite sin_PI, cos_PI in Z; lra). exists z. split; [lra|].
    destruct (E z ltac:(lra)) as (Sp & R). apply Rmult_eq_reg_l with (sin z); lra.
Qed.

(** [excursion-rise] $h$ increases on $(0,2\pi)$, takes every positive value once and has $h''>0$; $h-d\cot(\theta/2)$
    increases for every $d\geqslant 0$. *)
Theorem rise : (forall u, 0 < u < 2 * PI -> is_derive h u (h1 u) /\ 0 < h1 u /\ is_derive h1 u (h2 u) /\ 0 < h2 u) /\
  (forall y, 0 < y -> exists! u, 0 < u < 2 * PI /\ h u = y) /\ (forall u, 0 < u < 2 * PI -> 0 < h u) /\
  (forall d p p', 0 <= d -> 0 < p -> p < p' -> p' < PI -> push d p < push d p').
Proof.
  split; [intros u Hu; auto using h_derive, h1_pos, h1_derive, h2_pos|]. split; [|split; [exact h_pos|exact push_incr]].
  intros y Hy. apply one_angle; [exact h_increases|]. destruct (half_ex y Hy) as (p & Hp & E). exists (2 * p).
  rewrite <- hh_h by auto. split; [lra|auto].
Qed.

(** [excursion-depth] $c'=h$; $c$ takes every positive value once on $(0,2\pi)$ and is concave as a function of $h^2$.
    *)
Theorem deepens : (forall u, 0 < u < 2 * PI -> is_derive c u (h u) /\ 0 < c u) /\
  (forall y, 0 < y -> exists! u, 0 < u < 2 * PI /\ c u = y) /\
  (forall u v w, 0 < u -> u < v -> v < w -> w < 2 * PI ->
    (c w - c v) * (h v ^ 2 - h u ^ 2) <= (c v - c u) * (h w ^ 2 - h v ^ 2)).
Proof.
  pose proof PI_RGT_0. split; [intros u Hu; split; [apply c_derive; auto|apply depth_pos; lra]|]. split.
  - intros y Hy. apply one_angle; [apply c_increases|]. destruct (depth_ex y Hy) as (p & Hp & E).
    exists (2 * p). unfold c. replace (2 * p / 2) with p by field. split; [lra|auto].
  - intros u v w Hu Huv Hvw Hw. pose proof (h1_pos v ltac:(lra)) as Dv. set (k := / (2 * h1 v)). assert (Kp : 0 < k) by (unfold k; positive).
    assert (Mono : rising (2 * PI) h1).
    { intros r t Hr Hrt Ht. apply (climbs h1 h2); [auto| |]; intros z Hz; [apply h1_derive|apply h2_pos]; lra.
        }
    assert (D : forall t, 0 < t < 2 * PI -> is_derive (fun t => c t - k * h t ^ 2) t (h t * (1 - h1 t / h1 v))).
    { intros t Ht. evar_last; [apply (is_derive_minus c (fun t => k * h t ^ 2)); [apply c_derive; auto|
        apply is_derive_scal, (is_derive_pow h 2), h_derive; auto]|].
      unfold minus, plus, opp, scal; simpl; unfold mult; simpl. unfold k. field. lra. }
    assert (Left : k * (h v ^ 2 - h u ^ 2) <= c v - c u).
    { cut (c u - k * h u ^ 2 <= c v - k * h v ^ 2); [lra|].
      apply (rises (fun t => c t - k * h t ^ 2) (fun t => h t * (1 - h1 t / h1 v))); [lra|intros; apply D;
        lra|].
      intros t Ht. pose proof (h_pos t ltac:(lra)). pose proof (Mono t v ltac:(lra) ltac:(lra) ltac:(lra)).
      apply Rmult_le_pos; [lra|]. cut (h1 t / h1 v <= 1); [lra|undivide (h1 v); lra]. }
    assert (Right : c w - c v <= k * (h w ^ 2 - h v ^ 2)).
    { cut (- (c v - k * h v ^ 2) <= - (c w - k * h w ^ 2)); [lra|].
      apply (rises (fun t => - (c t - k * h t ^ 2)) (fun t => - (h t * (1 - h1 t / h1 v)))); [lra| |]; intros
        t Ht.
      - apply (is_derive_opp (fun t => c t - k * h t ^ 2)), D. lra.
      - pose proof (h_pos t ltac:(lra)). pose proof (Mono v t ltac:(lra) ltac:(lra) ltac:(lra)).
        assert (1 <= h1 t / h1 v) by (undivide (h1 v); lra).
        assert (0 <= h t * (h1 t / h1 v - 1)) by positive. lra. }
    pose proof (h_increases u v Hu Huv ltac:(lra)). pose proof (h_increases v w ltac:(lra) Hvw Hw). pose proof (h_pos u ltac:(lra)).
    assert (P1 : 0 <= h v ^ 2 - h u ^ 2) by nra. assert (P2 : 0 <= h w ^ 2 - h v ^ 2) by nra.
    apply Rle_trans with (k * (h w ^ 2 - h v ^ 2) * (h v ^ 2 - h u ^ 2)); [apply Rmult_le_compat_r; auto|].
    replace (k * (h w ^ 2 - h v ^ 2) * (h v ^ 2 - h u ^ 2)) with (k * (h v ^ 2 - h u ^ 2) * (h w ^ 2 - h v ^ 2)) by ring.
    apply Rmult_le_compat_r; auto.
Qed.

Section Excursions.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (M := m1 + m2) (q := m1 / M) (o1 := o1 m1 a2) (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b)
  (ray := ray m1 m2 a2 b) (sol := solution m1 m2 0 a2 b).

(** an excursion from a ray: it ends at its angle, its depth and its loss *)
Lemma excursion k x v1 v2 s t p : k = 1 \/ k = -1 -> sol x v1 v2 s -> 0 <= t -> 0 < p < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t ->
  let e := t + 2 * p / o1 in (forall u, t < u < e -> k * v1 u < k * v2 u) /\ v1 e = v2 e /\ k * (x t - x e) = L * (q * depth p) /\
  energy m1 m2 a2 (x t) (v1 t) (v2 t) - energy m1 m2 a2 (x e) (v1 e) (v2 e) = Ecr * (q * (m2 / M * depth p ^ 2)).
Proof.
  intros Hk H Ht Hp On e. pose proof On as (X0 & V0 & W0).
  destruct (ray_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t p Hk H Ht Hp On) as (Sg & Ev & A & _ & En).
  fold o1 e M L in Sg, Ev, A, En. fold q Ecr in A, En. fold L in X0.
  pose proof (ray_level m1 m2 a2 b Hm1 Hm2 Ha2 (hh p)) as R.
  fold M q L Ecr in R. rewrite <- X0, <- V0 in R at 1. rewrite <- W0, energy_side in R by auto.
  split; [exact Sg|]. split; [exact Ev|]. lra.
Qed.

(** [excursions-grow] Of two excursions from a ray the faster one lasts longer, goes deeper and loses more energy. *)
Theorem grow_together k x v1 v2 s t p k' x' v1' v2' s' t' p' : k = 1 \/ k = -1 -> k' = 1 \/ k' = -1 -> sol x v1 v2 s ->
  sol x' v1' v2' s' -> 0 <= t -> 0 <= t' -> 0 < p -> p < p' -> p' < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t ->
  on_ray m1 m2 a2 b k' (hh p') x' v1' v2' t' -> let e := t + 2 * p / o1 in let e' := t' + 2 * p' / o1 in
  (forall u, t < u < e -> k * v1 u < k * v2 u) /\ v1 e = v2 e /\ (forall u, t' < u < e' -> k' * v1' u < k' * v2' u) /\ v1' e' = v2' e' /\
  k * v1 t < k' * v1' t' /\ e - t < e' - t' /\ k * (x t - x e) < k' * (x' t' - x' e') /\
  energy m1 m2 a2 (x t) (v1 t) (v2 t) - energy m1 m2 a2 (x e) (v1 e) (v2 e) <
  energy m1 m2 a2 (x' t') (v1' t') (v2' t') - energy m1 m2 a2 (x' e') (v1' e') (v2' e').
Proof.
  intros Hk Hk' H H' Ht Ht' Hp Hpp Hp' On On' e e'. assert (O : 0 < o1) by (apply o1_pos; auto).
  destruct (excursion k x v1 v2 s t p Hk H Ht ltac:(lra) On) as (S & V & D & E).
  destruct (excursion k' x' v1' v2' s' t' p' Hk' H' Ht' ltac:(lra) On') as (S' & V' & D' & E'). fold e in S, V, D, E. fold e' in S', V', D', E'.
  pose proof (hh_incr p p' Hp Hpp Hp') as Hh. pose proof (depth_incr p p' Hp Hpp Hp') as Dc.
  pose proof (depth_pos p ltac:(lra)) as Dp. assert (Lp : 0 < L) by (apply L_pos; auto).
  assert (Qp : 0 < q) by positive. assert (Ep : 0 < Ecr) by (unfold Ecr; apply Ecr_pos; auto).
  repeat (split; [auto; fail|]). rewrite D, D', E, E'. split; [|split; [|split]].
  - destruct On as (_ & -> & _), On' as (_ & -> & _). apply Rmult_lt_compat_l; [positive|auto].
  - unfold e, e'. assert (2 * p / o1 < 2 * p' / o1) by (apply Rmult_lt_compat_r; [positive|lra]). lra.
  - repeat (apply Rmult_lt_compat_l; auto).
  - assert (depth p ^ 2 < depth p' ^ 2) by nra. assert (r2 : 0 < m2 / M) by positive.
    repeat (apply Rmult_lt_compat_l; auto).
Qed.

(** [one-contact] Every slip from $S$ with a gap $d\geqslant 0$ and a push $\nu$ ($\nu>0$ if $d=0$) ends at the one
    angle with $\nu=h-d\cot(\theta/2)$. *)
Theorem one_contact k d u x v1 v2 s t : k = 1 \/ k = -1 -> sol x v1 v2 s -> 0 <= t -> 0 <= d -> (d = 0 -> 0 < u) ->
  at_gap m1 m2 a2 b k d u x v1 v2 t -> exists! p, 0 < p < PI /\ push d p = u /\
  (forall t', t < t' < t + 2 * p / o1 -> k * v1 t' < k * v2 t') /\ v1 (t + 2 * p / o1) = v2 (t + 2 * p / o1).
Proof.
  intros Hk H Ht Hd Hu G. assert (Ex : exists p, 0 < p < PI /\ push d p = u).
  { destruct (Req_dec d 0) as [->|N]; [|destruct (push_root d u ltac:(lra)) as (p & P & _); eauto].
    destruct (proj1 (proj2 rise) u (Hu eq_refl)) as (th & (Hth & E) & _). exists (th / 2).
    rewrite push_0, hh_h by lra. replace (2 * (th / 2)) with th by field. split; [lra|auto]. }
  destruct Ex as (p & Hp & E). exists p. split.
  - rewrite <- E in G. destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t d p Hk H Ht Hd Hp G) as (_ & S & _ & B & C & _).
    repeat (split; [auto; fail|]). fold o1 in B, C. destruct Hk; subst k; lra.
  - intros p' (Hp' & E' & _). apply (rising_one PI (push d)); auto; [|lra]. intros u1 u2.
    apply push_incr; auto.
Qed.

(** One angle v in (0, 2 pi) has tan v = v; up to it a pair that re-entered S0 above E_cr leaves by the other ray, beyond
    it by the same. *)
Let turn v := sin v - v * cos v.
Lemma turn_falls u v : PI < u -> u < v -> v < 2 * PI -> turn v < turn u.
Proof.
  intros Hu Huv Hv. apply Ropp_lt_cancel. apply (climbs (fun t => - turn t) (fun t => - (t * sin t))); [auto|
    |]; intros t Ht.
  - unfold turn. auto_derive; auto. ring.
  - pose proof (sin_lt_0 t ltac:(lra) ltac:(lra)). nra.
Qed.
Lemma turns_until u v : 0 < u < 2 * PI -> 0 < v < 2 * PI -> turn v = 0 -> (u < v -> 0 < turn u) /\ (v < u -> turn u < 0).
Proof.
  intros Hu Hv Z. assert (Early : forall t, 0 < t <= PI -> 0 < turn t).
  { intros t Ht. unfold turn. destruct (Req_dec t PI) as [->|]; [rewrite sin_PI, cos_PI; lra|apply g_pos; lra]. }
  assert (PI < v) by (apply Rnot_le_lt; intros N; specialize (Early v ltac:(lra)); lra). split; intros Huv.
  - destruct (Rle_dec u PI) as [Le|]; [apply Early; lra|]. pose proof (turn_falls u v ltac:(lra) Huv ltac:(lra)). lra.
  - pose proof (turn_falls v u ltac:(lra) Huv ltac:(lra)). lra.
Qed.
(** [turning-angle] $\sin\theta=\theta\cos\theta$ has one solution $\theta_v$ in $(0,2\pi)$. *)
Theorem turning_angle : exists! v, 0 < v < 2 * PI /\ turn v = 0.
Proof.
  pose proof PI_RGT_0. destruct (IVT (fun t => - turn t) PI (2 * PI)) as (v & Hv & Z); [unfold turn; reg|lra| | |].
  - unfold turn. rewrite sin_PI, cos_PI. lra.
  - unfold turn. rewrite sin_2PI, cos_2PI. lra.
  - assert (v <> 2 * PI) by (intros ->; unfold turn in Z; rewrite sin_2PI, cos_2PI in Z; lra).
    exists v. split; [split; lra|]. intros w (Hw & Zw). destruct (turns_until w v Hw ltac:(lra) ltac:(lra)) as (A & B).
    destruct (Rtotal_order v w) as [L1|[|L1]]; auto; exfalso; [specialize (B L1)|specialize (A L1)]; lra.
Qed.

(** [leaves-by] After an excursion from a ray that re-enters $S_0$ above $E_{cr}$ the pair leaves by the other ray if
    $\theta<\theta_v$, and by the same if $\theta>\theta_v$. *)
Theorem leaves_by k x v1 v2 s t p v : k = 1 \/ k = -1 -> sol x v1 v2 s -> 0 <= t -> 0 < p < PI ->
  on_ray m1 m2 a2 b k (hh p) x v1 v2 t -> depth p <= 2 / q -> 0 < hh p ^ 2 - m2 / M * depth p ^ 2 ->
  0 < v < 2 * PI -> sin v = v * cos v -> let e := t + 2 * p / o1 in
  (2 * p < v -> exists t2 u, e <= t2 /\ 0 < u /\ on_ray m1 m2 a2 b (- k) u x v1 v2 t2 /\ forall r, e <= r <= t2 -> v1 r = v2 r) /\
  (v < 2 * p -> exists t2 u, e <= t2 /\ 0 < u /\ on_ray m1 m2 a2 b k u x v1 v2 t2 /\ forall r, e <= r <= t2 -> v1 r = v2 r).
Proof.
  intros Hk H Ht Hp On De Hy Hv Zv e. assert (O : 0 < o1) by (apply o1_pos; auto). assert (Qp : 0 < q) by positive.
  assert (Lp : 0 < L) by (apply L_pos; auto). assert (He : 0 <= e) by (unfold e; assert (0 < 2 * p / o1) by positive; lra).
  destruct (ray_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t p Hk H Ht Hp On) as (_ & Ve & A & B & En).
  fold o1 e M L in Ve, A, B, En. fold q ray Ecr in A, B, En. assert (Xe : - L <= x e <= L).
  { apply (lands m1 m2 a2 b Hm1 Hm2 Ha2 Hb k _ 0 p Hk (Rle_refl 0) Hp); rewrite Rplus_0_r; [exact A|auto]. }
  set (y := hh p ^ 2 - m2 / M * depth p ^ 2) in *.
assert (Sy : 0 < sqrt y) by positive. assert (Ey : sqrt y ^ 2 = y) by (apply pow2_sqrt; lra).
rewrite <- Ey in En.
  assert (Sg : forall j, j = 1 \/ j = -1 -> j * v1 e < 0 ->
    exists t2 u, e <= t2 /\ 0 < u /\ on_ray m1 m2 a2 b (- j) u x v1 v2 t2 /\ forall r, e <= r <= t2 -> v1 r = v2 r).
  { intros j Hj N. destruct (to_ray_side m1 m2 a2 b Hm1 Hm2 Ha2 Hb j x v1 v2 s e (sqrt y) Hj H He Ve Xe N Sy En)
      as (t2 & T2 & R & St). exists t2, (sqrt y). split; [lra|]. split; [auto|]. split; [exact R|apply St]. }
  assert (Ray : forall z, ray z = b / (m2 * o1) * z) by auto. assert (K : 0 < b / (m2 * o1)) by positive.
  assert (Tz : turn v = 0) by (unfold turn; lra). destruct (turns_until (2 * p) v ltac:(lra) Hv Tz) as (Up & Down).
  (* the speed there has the sign of h - theta, which is that of - turn theta *)
  assert (Hh : (2 * p - hh p) * (1 - cos (2 * p)) = turn (2 * p)).
  { rewrite hh_h by lra. unfold h, turn. field. pose proof (one_cos (2 * p) ltac:(lra)). lra. }
  pose proof (one_cos (2 * p) ltac:(lra)) as Oc. rewrite Ray in B. split; intros Lt.
  - apply Sg; auto. assert (0 < 2 * p - hh p) by nra. assert (0 < b / (m2 * o1) * (2 * p - hh p)) by positive. lra.
  - assert (N : 2 * p - hh p < 0) by nra. assert (0 < b / (m2 * o1) * (hh p - 2 * p)) by positive.
    destruct (Sg (- k) ltac:(destruct Hk; [right|left]; lra)) as (t2 & u & T2 & U & R & St); [rewrite Ropp_mult_distr_l_reverse, B; lra|].
    rewrite Ropp_involutive in R. eauto 8.
Qed.
End Excursions.
