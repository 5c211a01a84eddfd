(** The relative motion of the bodies in a tube of the energy distance: how far the relative velocities differ, and
    that the displacement is not seen. *)
From InertialPair Require Import Dini Pair Forced.

(** [ring-factor] $|v_1-v_2|\leqslant\sqrt\kappa\,N$, $\kappa=(m_1+m_2)/(m_1m_2)$, and no smaller factor suffices. *)
Theorem ring_factor m1 m2 a2 : 0 < m1 -> 0 < m2 -> 0 < a2 ->
  (forall x v1 v2, (v1 - v2) ^ 2 <= (m1 + m2) / (m1 * m2) * (2 * energy m1 m2 a2 x v1 v2)) /\
  forall c, (forall x v1 v2, (v1 - v2) ^ 2 <= c * (2 * energy m1 m2 a2 x v1 v2)) -> (m1 + m2) / (m1 * m2) <= c.
Proof.
  intros Hm1 Hm2 Ha2. assert (Mp : 0 < m1 * m2) by positive. split.
  - intros x v1 v2. replace ((m1 + m2) / (m1 * m2) * (2 * energy m1 m2 a2 x v1 v2)) with
      ((v1 - v2) ^ 2 + ((m1 * v1 + m2 * v2) ^ 2 + (m1 + m2) * a2 * x ^ 2) / (m1 * m2)) by (unfold energy; field; lra).
    assert (0 <= ((m1 * v1 + m2 * v2) ^ 2 + (m1 + m2) * a2 * x ^ 2) / (m1 * m2)); [|lra].
    apply Rmult_le_pos; [|positive]. pose proof (pow2_ge_0 (m1 * v1 + m2 * v2)).
    assert (0 <= (m1 + m2) * a2 * x ^ 2); [|lra]. positive.
  - (* both bodies with opposite momenta *)
    intros c H. specialize (H 0 m2 (- m1)). apply Rmult_le_reg_r with (m1 * m2 * (m1 + m2)); [positive|].
    replace ((m1 + m2) / (m1 * m2) * (m1 * m2 * (m1 + m2))) with ((m2 - - m1) ^ 2) by (field; lra).
    replace (c * (m1 * m2 * (m1 + m2))) with (c * (2 * energy m1 m2 a2 0 m2 (- m1))) by (unfold energy; field). exact H.
Qed.

(** [displacement-unseen] A shift of the initial position of body 2 shifts the relative displacement by as much at all
    times. *)
Theorem displacement_unseen m1 m2 a1 a2 b U x v1 v2 s z x' v1' v2' s' z' : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0
  < b ->
  forced m1 m2 a1 a2 b U x v1 v2 s -> forced m1 m2 a1 a2 b U x' v1' v2' s' -> x' 0 = x 0 -> v1' 0 = v1 0 -> v2' 0 =
    v2 0 ->
  cont z -> cont z' -> (forall t, 0 <= t -> rderiv z t (v2 t)) -> (forall t, 0 <= t -> rderiv z' t (v2' t)) ->
  forall t, 0 <= t -> (x' t - z' t) - (x t - z t) = (x' 0 - z' 0) - (x 0 - z 0) /\ v1' t - v2' t = v1 t - v2 t.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb H H' X0 V0 W0 Cz Cz' Dz Dz' t Ht.
  pose proof (forced_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ 0 H' H (Rle_refl 0) X0 V0 W0) as Same.
  destruct (Same t Ht) as (Ex & Ev & Ew). split; [|lra].
  assert (Q : (z' t - z t) - (z' 0 - z 0) = 0 * (t - 0)); [|lra].
  apply (rderiv_line (fun r => z' r - z r)); [continuous|lra|]. intros r Hr.
  rate. destruct (Same r ltac:(lra)) as (_ & _ & ->). ring.
Qed.
