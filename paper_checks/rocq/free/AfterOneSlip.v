(** Solutions after one slip: re-entries into S0 and crossings, exits on the rays, and which slips from S0 merge where
    they land. *)
From InertialPair Require Import Dini Pair Stick EnergyLimit Excursion ReturnMap Cycle SharpRate SharpLaw SlipFromGap.

Section Cross.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (M := m1 + m2) (q := m1 / M) (r := m2 / M) (om := omega m1 m2 a2) (o1 := o1 m1 a2)
  (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Let sticks t := forall u, 0 <= u -> v1 (t + u) = v2 (t + u).

Context (q0 : 0 < q := q_pos m1 m2 Hm1 Hm2) (L0 : 0 < L := L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb)
  (E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) (O0 : 0 < o1 := o1_pos m1 a2 Hm1 Ha2).
Let Emono t u : 0 <= t <= u -> E u <= E t := E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t u.

Let level_le y : Ecr * (1 + q * y) <= Ecr <-> y <= 0.
Proof. assert (P : 0 < Ecr * q) by positive. split; nra. Qed.

(** [sticks-iff] On $S$ the pair sticks permanently exactly if its energy is at most $E_{cr}$. *)
Theorem sticks_iff t : 0 <= t -> v1 t = v2 t -> (sticks t <-> E t <= Ecr).
Proof.
  intros Ht Ev. split.
  - intros S. assert (C : forall T, t <= T -> E T - E t = 0 * (T - t)).
    { intros T HT. apply rderiv_line; [exact (moves_cE m1 m2 0 a2 b Hm2 _ _ x v1 v2 s H)|lra|]. intros u Hu.
      eapply rderiv_eq; [|exact (energy_rate m1 m2 0 a2 b Hm1 Hm2 x v1 v2 s H u ltac:(lra))].
      specialize (S (u - t) ltac:(lra)). replace (t + (u - t)) with u in S by ring. rewrite S.
      replace (v2 u - v2 u) with 0 by ring. rewrite Rabs_R0. ring. }
    destruct (dichotomy_energy m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H) as [(T & HT & HE)|(_ & Lim)];
      [fold Ecr in HE|fold Ecr in Lim].
    + destruct (Rle_dec t T) as [n|n].
      * specialize (C T n). unfold E in *. lra.
      * pose proof (Emono T t ltac:(lra)). unfold E in *. lra.
    + destruct (Rle_dec (E t) Ecr) as [|n]; auto. exfalso. destruct (Lim ((E t - Ecr) / 2) ltac:(lra)) as (T & HT & K).
      pose proof (Rmax_l T t). pose proof (Rmax_r T t). specialize (K (Rmax T t) ltac:(lra)).
        pose proof (C (Rmax T t) ltac:(lra)). unfold E in *. lra.
  - intros HE u Hu. destruct (capture m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t H Ht Ev HE u Hu) as (_ & A & B). rewrite A.
    auto.
Qed.

(** [re-entry] A slip from $S$ with a gap and the initial speed of an angle that ends in $S_0$ sticks there
    permanently exactly if its energy is not above $E_{cr}$. *)
Theorem reentry k t0 d p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 <= d -> 0 < p < PI ->
  at_gap m1 m2 a2 b k d (push d p) x v1 v2 t0 -> depth p + d <= 2 / q ->
  let t1 := t0 + 2 * p / o1 in let y := level m1 m2 p d in
  (forall t, t0 < t < t1 -> k * v1 t < k * v2 t) /\ v1 t1 = v2 t1 /\ - L <= x t1 <= L /\ E t1 = Ecr * (1 + q * y) /\
  (sticks t1 <-> y <= 0) /\
  (y <= 0 -> forall u, 0 <= u -> x (t1 + u) = X m1 m2 a2 (x t1) (v1 t1) u /\
    v1 (t1 + u) = V m1 m2 a2 (x t1) (v1 t1) u /\ v2 (t1 + u) = V m1 m2 a2 (x t1) (v1 t1) u) /\
  (0 < y -> Ecr < E t1 /\ exists k' t2, (k' = 1 \/ k' = -1) /\ t1 <= t2 < t1 + PI / om /\
     on_ray m1 m2 a2 b k' (sqrt y) x v1 v2 t2 /\ forall t, t1 <= t <= t2 -> v1 t = v2 t).
Proof.
  intros Hk Ht Hd Hp HG HD t1 y.
  destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 d p Hk H Ht Hd Hp HG) as (_ & Sg & A & B & C & En).
  fold o1 t1 in Sg, A, B, C, En. assert (Ev : v1 t1 = v2 t1) by (destruct Hk; subst k; lra).
  assert (Hx : - L <= x t1 <= L) by exact (lands m1 m2 a2 b Hm1 Hm2 Ha2 Hb k _ d p Hk Hd Hp A HD).
  change (E t1 = Ecr * (1 + q * y)) in En. assert (T1 : 0 <= t1) by positive.
  assert (Iff : E t1 <= Ecr <-> y <= 0) by (rewrite En; apply level_le). repeat (split; [auto; fail|]).
  split; [rewrite sticks_iff; auto|]. split.
  - intros Y. apply (capture m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t1 H); auto. apply Iff; auto.
  - intros Y. split; [apply Rnot_le_lt; intros N; apply Iff in N; lra|].
    destruct (to_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H t1 (sqrt y)) as (k' & t2 & A1 & A2 & A3 & A4); auto.
    + positive.
    + change (E t1 = Ecr * (1 + q * sqrt y ^ 2)). rewrite En, pow2_sqrt; lra.
    + exists k', t2. repeat (split; [auto; fail|]). intros t Hu. apply A4; auto.
Qed.

(** [first-landing] From a ray with the exit speed of an angle: one slip up to that angle, to the energy
    $E_{cr}(1+q(h^2-r\,c^2))$, and merging there exactly if $h^2\leqslant r\,c^2$. *)
Theorem merges_at_first_landing k t0 p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI ->
  on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 ->
  let t1 := t0 + 2 * p / o1 in
  (forall t, t0 < t < t1 -> k * v1 t < k * v2 t) /\ v1 t1 = v2 t1 /\ k * x t1 = L * (1 - q * depth p) /\
  E t1 = Ecr * (1 + q * (hh p ^ 2 - r * depth p ^ 2)) /\
  (sticks t1 <-> hh p ^ 2 <= r * depth p ^ 2) /\ (hh p ^ 2 <= r * depth p ^ 2 -> depth p <= 2 / q).
Proof.
  intros Hk Ht Hp HR t1. assert (T0 : 0 < 2 * p / o1) by positive.
  destruct (ray_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 p Hk H Ht Hp HR) as (Sg & Ev & A & _ & En).
  change (E t1 = Ecr * (1 + q * (hh p ^ 2 - r * depth p ^ 2))) in En. fold o1 t1 L M in Sg, Ev, A.
  fold q in A.
set (y := hh p ^ 2 - r * depth p ^ 2) in *.
  assert (Iff : E t1 <= Ecr <-> hh p ^ 2 <= r * depth p ^ 2) by (rewrite En, level_le; unfold y; split; intros; lra).
  repeat (split; [auto; fail|]). split; [rewrite sticks_iff; auto; unfold t1; lra|].
  (* E <= E_cr on S forces the place into [-L, L] *)
  intros Q. apply Iff in Q. unfold E in Q. rewrite <- Ev in Q. apply (on_surface_inside m1 m2 a2 b Hm1 Hm2 Ha2 Hb) in Q.
  fold L in Q. undivide q. nra.
Qed.

(** [ray-crossing] From a ray with the exit speed of an angle whose depth is above $2/q$ the pair crosses $S$ and
    slips on with the other sign. *)
Theorem ray_crossing k t0 p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 ->
  2 / q < depth p ->
  let t1 := t0 + 2 * p / o1 in let d := depth p - 2 / q in let u := 2 * p - hh p in
  0 < d /\ (forall t, t0 < t < t1 -> k * v1 t < k * v2 t) /\
  k * x t1 = - L * (1 + q * d) /\ k * x t1 < - L /\ at_gap m1 m2 a2 b (- k) d u x v1 v2 t1 /\
  exists p', 0 < p' < PI /\ push d p' = u /\ (forall p2, 0 < p2 < PI -> push d p2 = u -> p2 = p') /\
    (forall t, t1 < t < t1 + 2 * p' / o1 -> k * v2 t < k * v1 t) /\ v1 (t1 + 2 * p' / o1) = v2 (t1 + 2 * p' / o1).
Proof.
  intros Hk Ht Hp HR HD t1 d u. apply ray_gap in HR. rewrite <- push_0 in HR.
  destruct (crossing m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 0 p Hk H Ht (Rle_refl 0) Hp HR) as (A & B & C & _ & F).
  { fold M. fold q. lra. }
  fold M in A, C, F. fold q o1 in A, B, C, F. fold t1 in B, C, F. rewrite Rplus_0_r in A, C, F. fold d in A, C, F.
  rewrite (push_0 p) in C, F.
  assert (P : k * x t1 = - L * (1 + q * d)). { destruct C as (C & _). fold M in C. fold q L in C. lra. }
  assert (0 < L * (q * d)) by positive. repeat (split; [auto; fail|]). split; [rewrite P; lra|].
  split; [exact C|exact F].
Qed.
End Cross.
