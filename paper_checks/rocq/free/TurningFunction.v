(** The one root of K in (0, pi], without numerics. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Excursion ReturnMap.

(** the turning function *)
Definition K p := (p - sin p * cos p) - sqrt 2 * (sin p - p * cos p).
Lemma cont_K : cont K. Proof. eapply cont_of_derive; intros; unfold K; auto_derive; [auto|reflexivity]. Qed.
(** by a quotient that falls *)
Definition turned p := (p - sin p * cos p) / (sin p - p * cos p).
Lemma g_until_pi p : 0 < p <= PI -> 0 < sin p - p * cos p.
Proof. intros [H [L| ->]]; [apply g_pos; auto|rewrite sin_PI, cos_PI; lra]. Qed.
Lemma turned_falls p q : 0 < p -> p < q -> q <= PI -> turned q < turned p.
Proof.
  intros Hp Hpq Hq. apply Ropp_lt_cancel. apply (climbs (fun u => - turned u) (fun u =>
    sin u * (u ^ 2 + u * (sin u * cos u) - 2 * sin u ^ 2) / (sin u - u * cos u) ^ 2)); [auto| |]; intros t Ht;
    pose proof (g_until_pi t ltac:(lra)) as G.
  - unfold turned. auto_derive; [lra|]. circle t. field_simplify_eq; [simpl; nsatz|lra].
  - apply Rdiv_lt_0_compat; [|positive]. apply Rmult_lt_0_compat; [apply sin_gt_0; lra|].
    apply Rle_lt_trans with (0 ^ 2 + 0 * (sin 0 * cos 0) - 2 * sin 0 ^ 2); [rewrite sin_0; lra|].
    apply (climbs (fun u => u ^ 2 + u * (sin u * cos u) - 2 * sin u ^ 2)
      (fun u => (2 * u * (2 + cos (2 * u)) - 3 * sin (2 * u)) / 2)); [lra|dern|].
    intros u Hu. pose proof (cusa_strict (2 * u) ltac:(lra)). lra.
Qed.
Lemma K_turned q : 0 < q <= PI -> 0 < sin q - q * cos q /\ K q = (sin q - q * cos q) * (turned q - sqrt 2).
Proof. intros Hq. pose proof (g_until_pi q Hq). split; [auto|]. unfold K, turned. field. lra. Qed.

(** [turning-point] The turning function has one zero $\varphi^*$ in $(0,\pi]$. *)
Theorem root : exists p, 0 < p < PI /\ K p = 0 /\ (forall q, 0 < q < p -> 0 < K q) /\ (forall q, p < q <= PI ->
  K q < 0).
Proof.
  pose proof PI2_3_2. assert (S : 1 < sqrt 2 < 3 / 2)
    by (pose proof (sqrt_sqrt 2 ltac:(lra)); pose proof (sqrt_pos 2); nra).
  assert (KP : K PI < 0) by (unfold K; rewrite sin_PI, cos_PI; nra).
  assert (KH : 0 < K (PI / 2)) by (unfold K; rewrite sin_PI2, cos_PI2; lra).
  destruct (cont_IVT K (PI / 2) PI cont_K) as (p & Hp & Z); [lra|nra|]. exists p.
  assert (p <> PI) by (intros ->; lra). destruct (K_turned p) as (G & Ep); [lra|].
  assert (turned p = sqrt 2) by nra. split; [lra|]. split; [auto|].
  split; intros q Hq; destruct (K_turned q ltac:(lra)) as (Gq & ->);
    [pose proof (turned_falls q p)|pose proof (turned_falls p q)]; nra.
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
    (- K p * ((p - sin p * cos p + sqrt 2 * (sin p - p * cos p)) / (2 * sin p ^ 2 * (sin p - p * cos p) ^
      2))).
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos p Hp) as G. auto_derive; [nra|].
  pose proof (sqrt_sqrt 2 ltac:(lra)) as Q. unfold K. set (w := sqrt 2) in *. clearbody w. circle p.
  field_simplify_eq; [simpl; nsatz|lra].
Qed.

(** h/c falls strictly while K > 0 and rises strictly while K < 0 *)
Lemma ratio_step p q : 0 < p -> p < q -> q < PI ->
  ((forall t, p < t < q -> 0 < K t) -> ratio q < ratio p) /\ ((forall t, p < t < q -> K t < 0) -> ratio p < ratio q).
Proof.
  intros H0 Hpq Hq. rewrite !ratio_AB by lra.
  edestruct (mean (fun p => (p - sin p * cos p) / (2 * sin p * (sin p - p * cos
    p)))) as (t & Ht & E); [exact Hpq|intros t Ht; apply derive_ratio; lra|]. cbv beta in E.
  pose proof (A_pos t ltac:(lra)). pose proof (g_pos t ltac:(lra)).
  pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)).
  set (w := _ / _) in E at 3. assert (W : 0 < w) by (unfold w; positive).
  split; intros S; specialize (S t Ht); [assert (0 < K t * w * (q - p)) by positive|
    assert (0 < - K t * w * (q - p)) by positive]; lra.
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

(** the share of body 2 beside the least ratio, as the critical mass ratio beside that of the masses *)
Lemma ratio_share p m1 m2 : 0 < p < PI -> K p = 0 -> 0 < m1 -> 0 < m2 ->
  0 < m2 / (m1 + m2) * ratio p ^ 2 /\
  m2 / (m1 + m2) - ratio p ^ 2 = (- cos (2 * p) - m1 / m2) * (m2 / (m1 + m2) * ratio p ^ 2).
Proof.
  intros Hp Z H1 H2. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S.
  rewrite (ratio_root p Hp Z), cos_2a_sin.
  split; [|field; lra]. apply Rmult_lt_0_compat; [positive|apply Rinv_0_lt_compat; nra].
Qed.

(** [merging-threshold] $h^2>r\,c^2$ at all slip angles below $2\pi$ exactly if $m_1/m_2>-\cos 2\varphi^*$; else not
    at $2\varphi^*$. *)
Theorem threshold : exists p, 0 < p < PI /\ K p = 0 /\ (forall q, 0 < q <= PI -> K q = 0 -> q = p) /\
  (forall r, 0 < r -> r < / (2 * sin p ^ 2) -> forall q, 0 < q < PI -> 0 < hh q ^ 2 - r * depth q ^ 2) /\
  (forall r, / (2 * sin p ^ 2) <= r -> hh p ^ 2 - r * depth p ^ 2 <= 0) /\
  (forall m1 m2, 0 < m1 -> 0 < m2 -> (m2 / (m1 + m2) < / (2 * sin p ^ 2) <-> - cos (2 * p) < m1 / m2)).
Proof.
  destruct root as (p & Hp' & Z & Le & Ri).
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
  - intros m1 m2 H1 H2. destruct (ratio_share p m1 m2 Hp' Z H1 H2) as (P & E). rewrite R2 in P, E.
    split; intros; nra.
Qed.
