(** The limit of the relative displacement; stability of the set of stuck motions; explicit time to fall. *)
From InertialPair Require Import Dini Pair PaidRates.

Section Corollaries.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (x v1 v2 s z : R -> R) (H : solution m1 m2 a1 a2 b x v1 v2 s).
Hypotheses (Cz : cont z) (Dz : forall t, 0 <= t -> rderiv z t (v1 t - v2 t)).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).

(** [displacement-paid] $b\,|z(t)-z(r)|\leqslant E(r)-E(t)$ for the relative displacement $z=x_1-x_2$ and $r\leqslant
    t$, with or without damping. *)
Theorem displacement_paid r t : 0 <= r <= t -> b * Rabs (z t - z r) <= E r - E t.
Proof.
  intros Hr. assert (Q : forall k, k = 1 \/ k = -1 -> k * b * z t + E t <= k * b * z r + E r).
  { intros k Hk. apply (rderiv_mono (fun u => k * b * z u + E u) r t
      (fun u => k * b * (v1 u - v2 u) + (- b * Rabs (v1 u - v2 u) - a1 * v1 u ^ 2))); auto.
    - apply cont_plus; [apply cont_scal; auto|]. exact (moves_cE m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H).
    - intros u Hu. split.
      + apply rderiv_plus; [apply rderiv_scal, Dz; lra|]. apply (energy_rate m1 m2 a1 a2 b Hm1 Hm2 _ _ _ _ H); lra.
      + unfold Rabs; destruct Rcase_abs; destruct Hk; subst k; nra. }
  pose proof (Q 1 (or_introl eq_refl)). pose proof (Q (-1) (or_intror eq_refl)). unfold Rabs; destruct Rcase_abs; lra.
Qed.

(** [displacement-limit] The relative displacement $x_1-x_2$ has a limit. *)
Theorem displacement_limit : exists zl, forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (z t - zl) <= e.
Proof.
  destruct (paid_converges E b) with (z := z) as (zl & _ & Lim); auto.
  - intros t _. apply energy_pos; auto.
  - exact (energy_decreases m1 m2 a1 a2 b Hm1 Hm2 Ha1 Hb _ _ _ _ H).
  - exact displacement_paid.
  - exists zl. exact Lim.
Qed.
End Corollaries.
