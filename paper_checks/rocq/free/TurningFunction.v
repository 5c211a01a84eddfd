(** The one root of K in (0, pi], without numerics. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Excursion ReturnMap.

(** the turning function *)
Definition K p := (p - sin p * cos p) - sqrt 2 * (sin p - p * cos p).
(** the factor of its slope that changes sign *)
Definition k p := 2 * sin p - sqrt 2 * p.

Lemma derive_K p : is_derive K p (sin p * k p).
Proof. unfold K, k. auto_derive; auto. pose proof (sin2_cos2 p) as SC. unfold Rsqr in SC. nra. Qed.
Lemma cont_K : cont K. Proof. eapply cont_of_derive. apply derive_K. Qed.
Lemma cont_k : cont k.
Proof. apply cont_of_derive with (fun p => 2 * cos p - sqrt 2). intros t. unfold k. auto_derive; auto. ring. Qed.

(** the mean value theorem for it *)
Lemma mvt_K u v : u < v -> exists t, u < t < v /\ K v - K u = sin t * k t * (v - u).
Proof.
  intros Huv. destruct (MVT_cor2 K (fun t => sin t * k t) u v Huv) as (t & E & Ht).
  { intros t _. apply is_derive_Reals, derive_K. } exists t; auto.
Qed.

Lemma turn : exists p1, 0 < p1 < PI /\ (forall t, 0 < t < p1 -> 0 < k t) /\ (forall t, p1 < t < PI -> k t < 0).
Proof.
  pose proof PI2_1 as P1. pose proof (sqrt_sqrt 2 ltac:(lra)). pose proof (sqrt_pos 2).
  assert (S2 : 1 < sqrt 2 < 3 / 2) by nra.
  assert (E : forall t, 0 < t -> k t = 2 * t * (sin t / t - sqrt 2 / 2)) by (intros; unfold k; field; lra).
  destruct (cont_IVT k (1 / 2) PI cont_k) as (p1 & Hp & Z); [lra| |].
  { pose proof (sin_above (1 / 2) ltac:(lra)). assert (0 < k (1 / 2)) by (unfold k; lra).
    assert (k PI < 0) by (unfold k; rewrite sin_PI; nra). nra. }
  assert (p1 < PI) by (destruct (Req_dec p1 PI) as [->|]; [unfold k in Z; rewrite sin_PI in Z; nra|lra]).
  rewrite E in Z by lra. apply Rmult_integral in Z. exists p1. repeat split; try lra; intros t Ht; rewrite E by lra.
  - pose proof (sinc_strict t p1 ltac:(lra) ltac:(lra) ltac:(lra)). apply Rmult_lt_0_compat; lra.
  - pose proof (sinc_strict p1 t ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (0 < 2 * t * (sqrt 2 / 2 - sin t / t)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** [turning-point] The turning function has one zero $\varphi^*$ in $(0,\pi]$. *)
Theorem root : exists p, 0 < p < PI /\ K p = 0 /\ (forall q, 0 < q < p -> 0 < K q) /\ (forall q, p < q <= PI ->
  K q < 0).
Proof.
  destruct turn as (p1 & H1 & Up & Down). assert (S2 : 1 < sqrt 2). { rewrite <- sqrt_1 at 1. apply sqrt_lt_1; lra. }
  assert (K0 : K 0 = 0) by (unfold K; rewrite sin_0; ring).
  assert (KP : K PI < 0). { unfold K. rewrite sin_PI, cos_PI. nra. } assert (A : forall q, 0 < q <= p1 -> 0 < K q).
  { intros q Hq. destruct (mvt_K 0 q ltac:(lra)) as (t & Ht & E). pose proof (Up t ltac:(lra)).
    pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)). assert (0 < sin t * k t) by positive. nra. }
  assert (B : forall u v, p1 <= u -> u < v -> v <= PI -> K v < K u).
  { intros u v Hu Huv Hv. destruct (mvt_K u v Huv) as (t & Ht & E).
    pose proof (Down t ltac:(lra)). pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)).
      assert (sin t * k t < 0) by nra. nra. }
  pose proof (A p1 ltac:(lra)) as K1. destruct (cont_IVT K p1 PI cont_K) as (p & Hp & Z); [lra|nra|].
  assert (p1 < p < PI). { destruct (Req_dec p p1); [subst p; lra|]. destruct (Req_dec p PI); [subst p; lra|]. lra. }
  exists p. repeat split; auto; try lra.
  - intros q Hq. destruct (Rle_dec q p1); [apply A; lra|]. rewrite <- Z. apply B; lra.
  - intros q Hq. rewrite <- Z. apply B; lra.
Qed.

(** it alone is this zero *)
Lemma signs p : 0 < p <= PI -> K p = 0 -> (forall q, 0 < q < p -> 0 < K q) /\ (forall q, p < q <= PI -> K q < 0).
Proof.
  intros Hp Z. destruct root as (p' & Hp' & Z' & Le & Ri). assert (p' = p) as ->; [|auto].
  destruct (Rtotal_order p p') as [L|[|L]]; auto; [specialize (Le p ltac:(lra))|specialize (Ri p ltac:(lra))]; lra.
Qed.

(** *** the ratio h/c and the threshold of merging *)
Definition ratio p := hh p / depth p.
(** the ratio without fractions in it *)
Lemma ratio_AB p : 0 < p < PI -> ratio p = (p - sin p * cos p) / (2 * sin p * (sin p - p * cos p)).
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). pose proof (g_pos p Hp). unfold ratio, hh, depth.
    field. repeat split; lra.
Qed.
(** its slope has the sign of -K *)
Lemma derive_ratio p : 0 < p < PI ->
  is_derive (fun p => (p - sin p * cos p) / (2 * sin p * (sin p - p * cos p))) p
    ((2 * (sin p - p * cos p) ^ 2 - (p - sin p * cos p) ^ 2) / (2 * sin p ^ 2 * (sin p - p * cos p) ^ 2)).
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos p Hp) as G. auto_derive; [nra|].
  circle p. field_simplify_eq; [simpl; nsatz|lra].
Qed.

(** h/c falls strictly while K > 0 and rises strictly while K < 0 *)
Lemma ratio_step p q : 0 < p -> p < q -> q < PI ->
  ((forall t, p < t < q -> 0 < K t) -> ratio q < ratio p) /\ ((forall t, p < t < q -> K t < 0) -> ratio p < ratio q).
Proof.
  intros H0 Hpq Hq. rewrite !ratio_AB by lra.
  set (f := fun p => (p - sin p * cos p) / (2 * sin p * (sin p - p * cos p))).
    change (((forall t, p < t < q -> 0 < K t) -> f q < f p) /\ ((forall t, p < t < q -> K t < 0) -> f p < f q)).
  set (df := fun p => (2 * (sin p - p * cos p) ^ 2 - (p - sin p * cos p) ^ 2) / (2 * sin p ^ 2 * (sin p - p * cos
    p) ^ 2)).
  destruct (MVT_cor2 f df p q Hpq) as (t & E & Ht). { intros t Ht. apply is_derive_Reals, derive_ratio; lra. }
  assert (Den : 0 < / (2 * sin t ^ 2 * (sin t - t * cos t) ^ 2)).
  { pose proof (pow_lt _ 2 (sin_gt_0 t ltac:(lra) ltac:(lra))). pose proof (pow_lt _ 2 (g_pos t ltac:(lra))).
    positive. }
  assert (Sq : 2 * (sin t - t * cos t) ^ 2 - (t - sin t * cos t) ^ 2 = - K t * (t - sin t * cos t + sqrt 2 * (sin
    t - t * cos t))).
  { unfold K. pose proof (sqrt_sqrt 2 ltac:(lra)) as Q.
    replace (2 * (sin t - t * cos t) ^ 2) with (sqrt 2 * sqrt 2 * (sin t - t * cos t) ^ 2) by (rewrite Q; ring). ring. }
  assert (Pos : 0 < t - sin t * cos t + sqrt 2 * (sin t - t * cos t)).
  { pose proof (A_pos t ltac:(lra)). pose proof (g_pos t ltac:(lra)). assert (0 < sqrt 2) by positive. nra. }
  assert (Ed : df t = - K t * ((t - sin t * cos t + sqrt 2 * (sin t - t * cos t)) * / (2 * sin t ^ 2 * (sin t - t
    * cos t) ^ 2))).
  { unfold df. nra. }
  rewrite Ed in E.
  set (w := (t - sin t * cos t + sqrt 2 * (sin t - t * cos t)) * / (2 * sin t ^ 2 * (sin t - t * cos t) ^ 2)) in *.
  split; intros S; specialize (S t Ht).
  - assert (0 < K t * w * (q - p)) by positive. lra.
  - assert (0 < - K t * w * (q - p)) by positive. lra.
Qed.

(** so it is least at the zero of K *)
Theorem ratio_least p q : 0 < p < PI -> K p = 0 -> 0 < q < PI -> ratio p <= ratio q.
Proof.
  intros Hp Z Hq. destruct (signs p ltac:(lra) Z) as (Le & Ri). destruct (Rtotal_order q p) as [Lt|[->|Gt]]; [|lra|];
    apply Rlt_le; [apply (ratio_step q p)|apply (ratio_step p q)]; try lra; intros t Ht; [apply Le|apply Ri]; lra.
Qed.

(** there it is known *)
Lemma ratio_root p : 0 < p < PI -> K p = 0 -> ratio p ^ 2 = / (2 * sin p ^ 2).
Proof.
  intros Hp Z. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos p Hp) as G.
  rewrite ratio_AB by auto. unfold K in Z. replace (p - sin p * cos p) with (sqrt 2 * (sin p - p * cos p)) by lra.
  replace ((sqrt 2 * (sin p - p * cos p) / (2 * sin p * (sin p - p * cos p))) ^ 2) with (sqrt 2 * sqrt 2 / (4 *
    sin p ^ 2)) by (field; lra).
  rewrite sqrt_sqrt by lra. field. lra.
Qed.

(** [merging-threshold] $h^2>r\,c^2$ at all slip angles below $2\pi$ exactly if $m_1/m_2>-\cos 2\varphi^*$; else not
    at $2\varphi^*$. *)
Theorem threshold : exists p, 0 < p < PI /\ K p = 0 /\ (forall q, 0 < q <= PI -> K q = 0 -> q = p) /\
  (forall r, 0 < r -> r < / (2 * sin p ^ 2) -> forall q, 0 < q < PI -> 0 < hh q ^ 2 - r * depth q ^ 2) /\
  (forall r, / (2 * sin p ^ 2) <= r -> hh p ^ 2 - r * depth p ^ 2 <= 0) /\
  (forall m1 m2, 0 < m1 -> 0 < m2 -> (m2 / (m1 + m2) < / (2 * sin p ^ 2) <-> - cos (2 * p) < m1 / m2)).
Proof.
  destruct root as (p & Hp' & Z & Le & Ri).
  pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos p Hp') as G.
  pose proof (ratio_root p Hp' Z) as R2. assert (Rel : forall q, 0 < q < PI -> hh q ^ 2 = ratio q ^ 2 * depth q ^ 2).
  { intros q Hq. pose proof (depth_pos q Hq). unfold ratio. field. lra. }
  exists p. split; [auto|]. split; [auto|]. split.
  { intros q Hq Zq. destruct (Rtotal_order q p) as [Lt|[|Gt]]; auto;
    [pose proof (Le q ltac:(lra))|pose proof (Ri q ltac:(lra))]; lra. }
  split; [|split].
  - intros r Hr Hlt q Hq. rewrite Rel by auto. pose proof (ratio_least p q Hp' Z Hq) as Q.
    assert (0 < ratio p) by (apply Rdiv_lt_0_compat; [apply hh_pos|apply depth_pos]; auto).
    assert (ratio p ^ 2 <= ratio q ^ 2) by nra. pose proof (pow_lt _ 2 (depth_pos q Hq)). nra.
  - intros r Hr. rewrite Rel by auto. nra.
  - intros m1 m2 H1 H2. assert (S2 : 0 < sin p ^ 2) by positive. rewrite cos_2a_sin.
    assert (E1 : m2 / (m1 + m2) * (2 * sin p ^ 2) * (m1 + m2) = 2 * m2 * sin p ^ 2) by (field; lra).
    assert (E2 : m1 / m2 * m2 = m1) by (field; lra).
    assert (E3 : / (2 * sin p ^ 2) * (2 * sin p ^ 2) = 1) by (field; lra).
    split; intros Q.
    + apply Rmult_lt_compat_r with (r := 2 * sin p ^ 2) in Q; [|lra]. nra.
    + apply Rmult_lt_reg_r with (2 * sin p ^ 2); [lra|]. nra.
Qed.
