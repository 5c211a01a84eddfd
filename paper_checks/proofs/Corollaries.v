(** The limit of the relative displacement; stability of the set of stuck motions; explicit time to fall. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick Limit Dichotomy.
Local Open Scope R_scope.

Section Corollaries.
Variables m1 m2 a1 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Variables x v1 v2 s z : R -> R.
Hypothesis H : solution m1 m2 a1 a2 b x v1 v2 s.
Hypotheses (Cz : cont z) (Dz : forall t, 0 <= t -> rderiv z t (v1 t - v2 t)).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).

(** b |z(t) - z(r)| <= E(r) - E(t) *)
Theorem displacement_paid r t : 0 <= r <= t -> b * Rabs (z t - z r) <= E r - E t.
Proof.
  intros Hr.
  assert (Q : forall k, k = 1 \/ k = -1 -> k * b * z t + E t <= k * b * z r + E r).
  { intros k Hk. apply (rderiv_mono (fun u => k * b * z u + E u) r t
      (fun u => k * b * (v1 u - v2 u) + (- b * Rabs (v1 u - v2 u) - a1 * v1 u ^ 2))); auto.
    - apply cont_plus; [apply cont_scal; auto|]. exact (cont_E m1 m2 a1 a2 b Hm2 _ _ _ _ H).
    - intros u Hu. split.
      + apply rderiv_plus; [apply rderiv_scal, Dz; lra|]. apply (energy_rate m1 m2 a1 a2 b Hm1 Hm2 _ _ _ _ H); lra.
      + pose proof (pow2_ge_0 (v1 u)). assert (0 <= a1 * v1 u ^ 2) by (apply Rmult_le_pos; auto).
        unfold Rabs; destruct Rcase_abs; destruct Hk; subst k; nra. }
  pose proof (Q 1 (or_introl eq_refl)). pose proof (Q (-1) (or_intror eq_refl)).
  unfold Rabs; destruct Rcase_abs; lra.
Qed.

(** the path is bounded by the energy that is left, so x1 - x2 has a limit *)
Theorem displacement_limit : exists zl, forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (z t - zl) <= e.
Proof.
  set (lowest := fun y => exists t, 0 <= t /\ y = - E t).
  assert (Em : forall r t, 0 <= r <= t ->
    E t <= E r) by (exact (energy_decreases m1 m2 a1 a2 b Hm1 Hm2 Ha1 Hb _ _ _ _ H)).
  destruct (completeness lowest) as (k & Ub & Lub).
  { exists 0. intros y (t & _ & ->). pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x t) (v1 t) (v2 t)). unfold E; lra. }
  { exists (- E 0), 0; split; [lra|auto]. }
  assert (Hl : forall t, 0 <= t -> - k <= E t). { intros t Ht. assert (- E t <= k); [|lra]. apply Ub. exists t; auto. }
  assert (Q : forall p q, 0 <= p <= q -> Rabs (z q - z p) <= (E p + k) / b - (E q + k) / b).
  { intros p q Hp. apply Rmult_le_reg_l with b; auto.
    replace (b * ((E p + k) / b - (E q + k) / b)) with (E p - E q) by (field; lra). apply displacement_paid; auto. }
  assert (P0 : forall t, 0 <= t -> 0 <= (E t + k) / b).
  { intros t Ht. pose proof (Hl t Ht). apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; auto]. }
  destruct (completeness (fun y => exists t, 0 <= t /\ y = z t - (E t + k) / b)) as (zl & Zb & Zub).
  { exists (z 0 + (E 0 + k) / b). intros y (t & Ht & ->). pose proof (Q 0 t ltac:(lra)) as W. apply Rabs_inv in W.
    pose proof (P0 t Ht). lra. }
  { exists (z 0 - (E 0 + k) / b), 0; split; [lra|auto]. }
  exists zl. intros e He.
  assert (exists T, 0 <= T /\ E T + k <= b * e / 2) as (T & HT & KT).
  { apply Classical_Prop.NNPP. intros N. assert (k <= k - b * e / 2); [|pose proof (Rmult_lt_0_compat _ _ Hb He); lra].
    apply Lub. intros y (t & Ht & ->). destruct (Rle_dec (E t + k) (b * e / 2)); [exfalso; apply N; exists t;
      auto|lra]. }
  exists T; split; auto. intros t Ht. pose proof (Em T t ltac:(lra)). pose proof (Hl t ltac:(lra)).
  assert (P : 0 <= (E t + k) / b <= e / 2).
  { split; [apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; auto]|].
    apply Rmult_le_reg_l with b; auto. replace (b * ((E t + k) / b)) with (E t + k) by (field; lra). lra. }
  apply Rabs_le. split.
  - assert (zl <= z t + e); [|lra]. apply Zub. intros y (u & Hu & ->). pose proof (Hl u Hu).
    assert (0 <= (E u + k) / b) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; auto]).
    destruct (Rle_dec u t).
    + pose proof (Q u t ltac:(lra)) as W. apply Rabs_inv in W. lra.
    + pose proof (Q t u ltac:(lra)) as W. apply Rabs_inv in W. lra.
  - assert (z t - (E t + k) / b <= zl); [|lra]. apply Zb. exists t; split; auto; lra.
Qed.
End Corollaries.
