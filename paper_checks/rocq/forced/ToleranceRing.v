(** The tolerance ring under a force: the energy distance of two motions never grows, so a tube around one of them has
    one entry time for the other and is never left; in it the relative velocities differ by a bounded amount. *)
From InertialPair Require Import Dini Pair Forced BoundedMotions RelativeMotion.

(** a continuous function that never grows and comes down to e: from one time on it is there, and before it is not *)
Lemma one_entry f e r : cont f -> (forall p q, 0 <= p <= q -> f q <= f p) -> 0 <= r -> f r <= e ->
  exists T, 0 <= T /\ forall t, 0 <= t -> (f t <= e <-> T <= t).
Proof.
  intros C Mono Hr Fr. destruct (Rle_dec (f 0) e) as [F0|F0].
  { exists 0. split; [lra|]. intros t Ht. split; intros _; [auto|]. pose proof (Mono 0 t ltac:(lra)). lra. }
  destruct (first_zero (fun u => f u - e) 0 r) as (T & HT & Z & B); [apply cont_minus; auto using
    cont_const|lra|nra|lra|].
  exists T. split; [lra|]. intros t Ht. split; [|intros HTt; pose proof (Mono T t ltac:(lra)); lra].
  intros Ft. apply Rnot_lt_le. intros N. specialize (B t ltac:(lra)). cbv beta in B. nra.
Qed.

Section Ring.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** the relative velocity is seen by the energy: (p - q)^2 <= kappa (m1 p^2 + m2 q^2), kappa = M/(m1 m2) *)
Lemma relative x p q e : energy m1 m2 a2 x p q <= e -> Rabs (p - q) <= sqrt (2 * ((m1 + m2) / (m1 * m2)) * e).
Proof.
  intros E. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr.
  pose proof (proj1 (ring_factor m1 m2 a2 Hm1 Hm2 Ha2) x p q) as Q.
  assert (Hk : 0 < (m1 + m2) / (m1 * m2)) by positive. apply (Rmult_le_compat_l ((m1 + m2) / (m1 * m2))) in E; lra.
Qed.

(** [tolerance-ring] With $a_1>0$ and a bounded force every motion enters a tube around another one at some time, and
    stays; from then on it is in the ring of relative velocities. *)
Theorem ring U x v1 v2 s x' v1' v2' s' G e : forced m1 m2 a1 a2 b U x v1 v2 s -> forced m1 m2 a1 a2 b U x' v1' v2' s' ->
  0 <= G -> (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)) -> 0 < e ->
  exists T, 0 <= T /\
  (forall t, 0 <= t -> (energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= e <-> T <= t)) /\
  forall t, T <= t -> Rabs ((v1 t - v2 t) - (v1' t - v2' t)) <= sqrt (2 * ((m1 + m2) / (m1 * m2)) * e).
Proof.
  intros H H' HG LU He.
  destruct (approach m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ G H H' HG LU e He) as (r & Hr & Q).
  destruct (one_entry (fun t => energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t)) e r) as (T & HT & One);
    auto.
  - exact (moves_cD m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ _ _ _ _ H H').
  - intros p q Hp. exact (forced_contraction m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Hb _ _ _ _ _ _ _ _ _ p q H H' Hp).
  - apply Q; lra.
  - exists T. split; [auto|]. split; [exact One|]. intros t Ht.
    replace (v1 t - v2 t - (v1' t - v2' t)) with (v1 t - v1' t - (v2 t - v2' t)) by ring.
    apply (relative (x t - x' t)). apply One; lra.
Qed.
End Ring.
