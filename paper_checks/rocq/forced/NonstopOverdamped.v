(** U** for a pair with more than critical damping, a1^2 > 4 m1 a2: the response of body 1 to the square wave is a sum
  of two exponentials, and the least amplitude of a motion that never stops is the one of `Nonstop.v`. *)
From InertialPair Require Import Dini Nonstop.

Section Overdamped.
Context (m1 m2 a1 a2 b om : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om).
Hypothesis Hover : 4 * m1 * a2 < a1 ^ 2.
Let T := PI / om.

(** the slower and the faster rate *)
Definition slow := (- a1 + sqrt (a1 ^ 2 - 4 * m1 * a2)) / (2 * m1).
Definition fast := (- a1 - sqrt (a1 ^ 2 - 4 * m1 * a2)) / (2 * m1).
(** the response to the square wave in its first half period, and its speed *)
Definition part r q := 2 * q / (a2 * (r - q) * (1 + exp (r * (PI / om)))).
Definition creep t := 1 / a2 + part slow fast * exp (slow * t) + part fast slow * exp (fast * t).
Definition creep' t := part slow fast * slow * exp (slow * t) + part fast slow * fast * exp (fast * t).

Let root : 0 < sqrt (a1 ^ 2 - 4 * m1 * a2). Proof. apply sqrt_lt_R0. lra. Qed.
Let square : sqrt (a1 ^ 2 - 4 * m1 * a2) * sqrt (a1 ^ 2 - 4 * m1 * a2) = a1 ^ 2 - 4 * m1 * a2. Proof. apply sqrt_sqrt.
  lra. Qed.

Lemma rates : fast < slow < 0 /\ m1 * slow ^ 2 + a1 * slow + a2 = 0 /\ m1 * fast ^ 2 + a1 * fast + a2 = 0.
Proof.
  set (w := sqrt (a1 ^ 2 - 4 * m1 * a2)) in *. assert (w < a1) by nra. unfold slow, fast. fold w.
  assert (I : 0 < / (2 * m1)) by positive. unfold Rdiv. split; [split; nra|].
  split; apply Rmult_eq_reg_l with (4 * m1); try lra; field_simplify; try lra;
    replace (w ^ 2) with (a1 ^ 2 - 4 * m1 * a2) by (rewrite <- square; ring); field.
Qed.

Lemma derive_creep t : is_derive creep t (creep' t).
Proof. unfold creep, creep'. auto_derive; auto. ring. Qed.
Lemma derive_creep' t : is_derive creep' t ((1 - a1 * creep' t - a2 * creep t) / m1).
Proof.
  destruct rates as (_ & E1 & E2). unfold creep', creep. auto_derive; auto. apply Rmult_eq_reg_l with m1; [|lra].
  set (A := part slow fast * exp (slow * t)). set (B := part fast slow * exp (fast * t)).
  transitivity (A * (m1 * slow ^ 2) + B * (m1 * fast ^ 2)); [unfold A, B; ring|].
  transitivity (- A * (a1 * slow + a2) - B * (a1 * fast + a2)); [|unfold A, B; field; lra].
  replace (m1 * slow ^ 2) with (- (a1 * slow + a2)) by lra. replace (m1 * fast ^ 2) with (- (a1 * fast + a2)) by lra.
    ring.
Qed.

(** over half a period it changes its sign *)
Lemma creep_T : creep T = - creep 0 /\ creep' T = - creep' 0.
Proof.
  destruct rates as (Or & _). unfold creep, creep', part. fold T. rewrite !Rmult_0_r, exp_0.
  pose proof (exp_pos (slow * T)). pose proof (exp_pos (fast * T)). split; field; repeat split; lra.
Qed.

(** [nonstop-overdamped] $a_1^2>4m_1a_2$: the theorem nonstop-iff with $U_{**}$ in closed form, by two exponentials.
    *)
Theorem overdamped_iff F : 0 <= F -> (forall t, 0 < t < PI / om -> 0 < slipping m2 b om creep'
    (leave m1 m2 a1 a2 b om (creep 0) (creep' 0)) t) ->
  (exists phi x v1 v2 s, nonstop m1 m2 a1 a2 b om F phi x v1 v2 s) <-> Fslip m1 m2 a1 a2 b om (creep 0) (creep' 0) <= F.
Proof.
  intros HF Side. destruct creep_T as (E & E'). unfold T in E, E'.
  apply (nonstop_iff m1 m2 a1 a2 b om Hm1 Hm2 (Rlt_le _ _ Ha1) Ha2 Hb Hom creep creep' derive_creep derive_creep');
    auto.
  - unfold Z1. assert (0 < (a1 * om) ^ 2) by positive. pose proof (pow2_ge_0 (a2 - m1 * om ^ 2)). lra.
  - apply leaves; auto using derive_creep, derive_creep'. lra.
Qed.
End Overdamped.
