(** One excursion from an exit ray: h increases on (0, 2 pi), so each push has one slip angle; and the trigonometric
    inequalities in the half angle that bound its depth. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini.

(** pi, from seven terms of Leibniz's series *)
Lemma pi_below : PI <= 10 / 3.
Proof. pose proof (proj2 (PI_ineq 3)) as Q. unfold tg_alt, PI_tg in Q. simpl in Q. lra. Qed.

(** the mean value of a slope, and what its sign means *)
Lemma mean (f f' : R -> R) u v : u < v -> (forall t, u <= t <= v -> is_derive f t (f' t)) ->
  exists t, u < t < v /\ f v - f u = f' t * (v - u).
Proof.
  intros L D. destruct (MVT_cor2 f f' u v L) as (t & E & Ht); [|exists t; auto]. intros t Ht.
  apply is_derive_Reals, D, Ht.
Qed.
Lemma rises (f f' : R -> R) u v : u <= v -> (forall t, u <= t <= v -> is_derive f t (f' t)) ->
  (forall t, u < t < v -> 0 <= f' t) -> f u <= f v.
Proof. intros [L|<-] D S; [|lra]. destruct (mean f f' u v L D) as (t & Ht & E). specialize (S t Ht). nra. Qed.
Lemma climbs (f f' : R -> R) u v : u < v -> (forall t, u <= t <= v -> is_derive f t (f' t)) ->
  (forall t, u < t < v -> 0 < f' t) -> f u < f v.
Proof. intros L D S. destruct (mean f f' u v L D) as (t & Ht & E). specialize (S t Ht). nra. Qed.

(** a function that rises on (0, p) compares as its arguments do *)
Definition rising p f := forall u v, 0 < u -> u < v -> v < p -> f u < f v.
Lemma rising_le p f u v : rising p f -> 0 < u -> u <= v -> v < p -> f u <= f v.
Proof. intros F Hu [L|<-] Hv; [apply Rlt_le, F; auto|lra]. Qed.
Lemma rising_iff p f u v : rising p f -> 0 < u < p -> 0 < v < p -> (f u <= f v <-> u <= v) /\ (f u < f v <-> u
  < v).
Proof.
  intros F Hu Hv. pose proof (F u v (proj1 Hu)). pose proof (F v u (proj1 Hv)).
  destruct (Rtotal_order u v) as [L|[->|L]]; repeat split; lra.
Qed.
Lemma rising_one p f u v : rising p f -> 0 < u < p -> 0 < v < p -> f u = f v -> u = v.
Proof.
  intros F Hu Hv E. pose proof (rising_iff p f u v F Hu Hv). pose proof (rising_iff p f v u F Hv Hu). lra.
Qed.

Lemma sin_pos u : 0 <= u <= PI -> 0 <= sin u. Proof. intros; apply sin_ge_0; lra. Qed.

Lemma pow2e (z : R) : z ^ 2 = z * z. Proof. ring. Qed.
Lemma pow3e (z : R) : z ^ 3 = z * z * z. Proof. ring. Qed.
Ltac circle t := let SC := fresh "SC" in assert (SC : sin t * sin t + cos t * cos t = 1) by exact (sin2_cos2 t);
  set (s := sin t) in *; set (c := cos t) in *; clearbody s c; rewrite ?pow2e, ?pow3e.
(** an identity in sin p > 0 and cos p, by sin^2 + cos^2 = 1 *)
Ltac trig p := let S := fresh in let SC := fresh in
  assert (S : 0 < sin p) by (apply sin_gt_0; lra); pose proof (sin2_cos2 p : sin p * sin p + cos p * cos p = 1) as SC;
  clear - S SC; set (s := sin p) in *; set (c := cos p) in *; clearbody s c;
  first [field_simplify_eq; [simpl; nsatz|lra]|simpl; nsatz].
Ltac der := intros; auto_derive; [auto|field].
Ltac dern := let t := fresh "t" in intros t; intros; auto_derive; [auto|]; rewrite ?cos_2a_cos, ?sin_2a;
  circle t; field_simplify_eq; simpl; nsatz.
(** l <= r at u: they are equal at 0, and from there on the slope of r - l is not negative *)
Ltac from_zero u slope := intros; apply Rminus_le_0; match goal with |- 0 <= ?d =>
  match eval pattern u in d with ?f _ => apply Rle_trans with (f 0); [right; cbv beta; rewrite ?sin_0, ?cos_0;
    field|
    apply (rises f slope 0 u); [lra|first [solve [der] | dern]|cbv beta]] end end.

Lemma sin_below u : 0 <= u -> sin u <= u.
Proof. from_zero u (fun u => 1 - cos u). intros t _. pose proof (COS_bound t); lra. Qed.

(** sin u >= u - u^3/6 *)
Lemma sin_above u : 0 <= u <= PI -> u - u ^ 3 / 6 <= sin u.
Proof.
  from_zero u (fun u => cos u - (1 - u ^ 2 / 2)).
  intros t Ht. pose proof (sin_below (t / 2) ltac:(lra)). replace t with (2 * (t / 2)) at 1 by field.
  rewrite cos_2a_sin. pose proof (sin_pos (t / 2) ltac:(lra)). nra.
Qed.

(** g = sin - u cos *)
Lemma g_nonneg u : 0 <= u <= PI -> 0 <= sin u - u * cos u.
Proof. from_zero u (fun u => u * sin u). intros t Ht. apply Rmult_le_pos; [lra|apply sin_pos; lra]. Qed.
Lemma g_pos u : 0 < u < PI -> 0 < sin u - u * cos u.
Proof.
  intros Hu. apply Rle_lt_trans with (sin (u / 2) - u / 2 * cos (u / 2)). { apply g_nonneg; lra. }
  apply (climbs (fun u => sin u - u * cos u) (fun u => u * sin u)); [lra|der|].
  intros t Ht. apply Rmult_lt_0_compat; [|apply sin_gt_0]; lra.
Qed.
(** 2 - 2 cos u - u sin u, the numerator of h', is positive inside *)
Lemma N_pos u : 0 < u < 2 * PI -> 0 < 2 - 2 * cos u - u * sin u.
Proof.
  intros Hu. pose proof (g_pos (u / 2) ltac:(lra)). pose proof (sin_gt_0 (u / 2) ltac:(lra) ltac:(lra)).
  replace u with (2 * (u / 2)) by field. rewrite cos_2a_sin, sin_2a. nra.
Qed.

(** *** h increases on (0, 2 pi) *)
Definition h u := (u - sin u) / (1 - cos u).
Lemma one_cos u : 0 < u < 2 * PI -> 0 < 1 - cos u.
Proof.
  intros Hu. replace u with (2 * (u / 2)) by field. rewrite cos_2a_sin.
    pose proof (sin_gt_0 (u / 2) ltac:(lra) ltac:(lra)). nra.
Qed.
Lemma h_rate u : 0 < u < 2 * PI -> is_derive h u ((2 - 2 * cos u - u * sin u) / (1 - cos u) ^ 2).
Proof.
  intros Hu. pose proof (one_cos u Hu). unfold h. auto_derive; [lra|].
  replace (2 - 2 * cos u - u * sin u) with ((1 - cos u) * (1 - cos u) - (u - sin u) * sin u) by (circle u; nsatz).
  field. lra.
Qed.
(** [h-increases] $h$ increases on $(0,2\pi)$: no two slip angles have the same exit speed. *)
Theorem h_increases u v : 0 < u -> u < v -> v < 2 * PI -> h u < h v.
Proof.
  intros. eapply (climbs h); [auto|intros t Ht; apply h_rate; lra|].
  intros t Ht. apply Rdiv_lt_0_compat; [apply N_pos|apply pow_lt, one_cos]; lra.
Qed.

(** *** inequalities in the half angle *)
Lemma cusa_strict u : 0 < u < 2 * PI -> 3 * sin u < u * (2 + cos u).
Proof.
  intros Hu. cut (0 * (2 + cos 0) - 3 * sin 0 < u * (2 + cos u) - 3 * sin u); [rewrite sin_0; lra|].
  apply (climbs (fun u => u * (2 + cos u) - 3 * sin u) (fun u => 2 - 2 * cos u - u * sin u)); [lra|der|].
  intros t Ht. apply N_pos; lra.
Qed.
Lemma cusa u : 0 <= u < 2 * PI -> 3 * sin u <= u * (2 + cos u).
Proof. intros [[H|<-] Hu]; [apply Rlt_le, cusa_strict; auto|rewrite sin_0; lra]. Qed.
Lemma A_nonneg p : 0 <= p -> 0 <= p - sin p * cos p.
Proof. intros. pose proof (sin_below (2 * p) ltac:(lra)) as Q. rewrite sin_2a in Q. lra. Qed.
Lemma A_pos p : 0 < p < PI -> 0 < p - sin p * cos p.
Proof.
  intros Hp. apply Rle_lt_trans with (p / 2 - sin (p / 2) * cos (p / 2)). { apply A_nonneg; lra. }
  apply (climbs (fun u => u - sin u * cos u) (fun u => 2 * sin u ^ 2)); [lra|dern|].
  intros t Ht. pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)). nra.
Qed.
(** p - sin p cos p <= (2/3) p^3 *)
Lemma A_above p : 0 <= p <= PI -> p - sin p * cos p <= 2 / 3 * p ^ 3.
Proof.
  from_zero p (fun p => 2 * (p ^ 2 - sin p ^ 2)).
  intros t Ht. pose proof (sin_below t ltac:(lra)). pose proof (sin_pos t ltac:(lra)). nra.
Qed.
(** sin^3 p <= 3 (sin p - p cos p) *)
Lemma g_above_cube p : 0 <= p <= PI -> sin p ^ 3 <= 3 * (sin p - p * cos p).
Proof.
  from_zero p (fun p => 3 * sin p * (p - sin p * cos p)).
  intros t Ht. apply Rmult_le_pos; [pose proof (sin_pos t ltac:(lra)); lra|apply A_nonneg; lra].
Qed.
(** the inequality behind the lower bound of the depth *)
Lemma depth_above p : 0 <= p <= PI -> 4 * (sin p - p * cos p) * sin p ^ 3 <= 3 * (p - sin p * cos p) ^ 2.
Proof.
  from_zero p (fun p => 4 * sin p ^ 2 * (2 * p + p * 2 * cos (2 * p) + 2 * p - 3 * sin (2 * p))).
  intros t Ht. apply Rmult_le_pos. { positive. } pose proof (cusa (2 * t) ltac:(lra)). lra.
Qed.
