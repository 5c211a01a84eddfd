(** What a periodic response moves body 2 on by in one period: the integral of its velocity, and nothing where the
    force repeats with the opposite sign after half a period. *)
From InertialPair Require Import Dini Pursuit Forced BoundedMotions Arcs.

(** [drift] The position of body 2 changes by the integral of its velocity. *)
Theorem drift v2 z t : cont v2 -> cont z -> (forall r, 0 <= r -> rderiv z r (v2 r)) -> 0 <= t -> z t - z 0 = integral
  v2 t.
Proof.
  intros C Cz Dz Ht. assert (Q : (z t - integral v2 t) - (z 0 - integral v2 0) = 0 * (t - 0)).
  { apply (rderiv_line (fun r => z r - integral v2 r)); [continuous|lra|]. intros r Hr. rate. ring. }
  rewrite integral_0 in Q. lra.
Qed.

(** [no-drift] With $a_1>0$, if the force changes its sign after half a period, so does the periodic response, and
    body 2 returns. *)
Theorem no_drift m1 m2 a1 a2 b U G T x v1 v2 s z : 0 < m1 -> 0 < m2 -> 0 < a1 -> 0 < a2 -> 0 < b -> 0 <= G -> 0 < T ->
  (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)) -> (forall t, 0 <= t -> U (T + t) - U T = - (U t - U
    0)) ->
  forced m1 m2 a1 a2 b U x v1 v2 s ->
  (forall t, 0 <= t -> x (2 * T + t) = x t /\ v1 (2 * T + t) = v1 t /\ v2 (2 * T + t) = v2 t) ->
  cont z -> (forall r, 0 <= r -> rderiv z r (v2 r)) ->
  (forall t, 0 <= t -> x (T + t) = - x t /\ v1 (T + t) = - v1 t /\ v2 (T + t) = - v2 t) /\ z (2 * T) = z 0.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb HG HT LU Anti H Pe Cz Dz.
  (* the mirror image of the later motion is a motion under this force *)
  assert (H' : forced m1 m2 a1 a2 b U (fun t => - x (T + t)) (fun t => - v1 (T + t)) (fun t => - v2 (T + t))
    (fun t => - s (T + t))).
  { apply forced_half_turn; auto; lra. }
  assert (Same : forall t, 0 <= t -> x t = - x (T + t) /\ v1 t = - v1 (T + t) /\ v2 t = - v2 (T + t)).
  { apply (periodic_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ G (2 * T) H H' HG LU); [lra| |];
    intros t Ht.
    - rewrite Rplus_comm. apply Pe; auto.
    - destruct (Pe (T + t) ltac:(lra)) as (E1 & E2 & E3). replace (T + (t + 2 * T)) with (2 * T + (T + t)) by ring.
      lra. }
  split; [intros t Ht; specialize (Same t Ht); lra|].
  assert (Q : (z (T + T) + z T) - (z (T + 0) + z 0) = 0 * (T - 0)).
  { apply (rderiv_line (fun r => z (T + r) + z r)); [continuous|lra|]. intros r Hr.
    specialize (Same r ltac:(lra)). apply rderiv_eq with (v2 (T + r) + v2 r); [lra|].
    apply rderiv_plus; [apply rderiv_earlier|]; apply Dz; lra. }
  rewrite Rplus_0_r in Q. replace (T + T) with (2 * T) in Q by ring. lra.
Qed.
