(** Tracking with a damper: the velocities, and the place of body 1, tend to the reference. *)
From InertialPair Require Import Dini Pair Pursuit Forced BoundedMotions.

Section Tracking.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).

(** [tracks] With $a_1>0$, under the force of the stuck motion along a reference with $|\ddot
    x_{\mathrm{ref}}|\leqslant b/m_2$, but for a constant, if it is bounded: $v_1$, $v_2$ and $x_1$ of every motion
    tend to the velocity of the reference, and to its place but for the constant. *)
Theorem tracks r r' x0 G x v1 v2 s : 0 < a1 -> cont r -> (forall t, 0 <= t -> rderiv r t (r' t)) ->
  (forall p q, 0 <= p <= q -> Rabs (r' q - r' p) <= b / m2 * (q - p)) ->
  let U t := (m1 + m2) * r' t + a1 * r t + a2 * integral (fun u => x0 + r u - r 0) t in
  0 <= G -> (forall p q, 0 <= p <= q -> Rabs (U q - U p) <= G * (q - p)) -> forced m1 m2 a1 a2 b U x v1 v2 s ->
  forced m1 m2 a1 a2 b U (fun t => x0 + r t - r 0) r' r' (fun t => m2 / b * r' t) /\
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    Rabs (v1 t - r' t) <= e /\ Rabs (v2 t - r' t) <= e /\ Rabs (x t - (r t + (x0 - r 0))) <= e.
Proof.
  intros A1 Cr Dr Lr U HG LU H. pose proof (trackable m1 m2 a1 a2 b Hm2 Hb x0 r r' Cr Dr Lr) as F.
  split; [exact F|]. intros e He.
  destruct (energy_close m1 m2 a2 Hm1 Hm2 Ha2 e He) as (E & HE & Small).
  destruct (approach m1 m2 a1 a2 b Hm1 Hm2 A1 Ha2 Hb _ _ _ _ _ _ _ _ _ G H F HG LU E HE) as (T & HT & K).
  exists T. split; [auto|]. intros t Ht. destruct (Small _ _ _ (K t Ht)) as (X & V & W). split; [auto|].
  split; [auto|]. replace (x t - (r t + (x0 - r 0))) with (x t - (x0 + r t - r 0)) by ring. auto.
Qed.
End Tracking.
