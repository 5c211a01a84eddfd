(** What a stuck pair can do under the equations (3), (4): follow the velocities that ask for less than all of the
    friction; so it takes body 2 from rest to rest over any way, in every time that exceeds the least one. *)
From InertialPair Require Import Dini Pursuit Forced AlmostEverywhere Filippov Switching.

Section Literal.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** The force of a stuck pair along a velocity v with the acceleration c. *)
Let place x0 v t := x0 + integral v t.
Let push_of x0 (v c : R -> R) t := (m1 + m2) * c t + a1 * v t + a2 * place x0 v t.

(** With the acceleration below the limit (3), (4) are met. *)
Lemma literal_force (v c : R -> R) x0 : ac v -> almost (fun t => is_derive v t (c t)) ->
  almost (fun t => Rabs (c t) < b / m2) -> switching m1 m2 a1 a2 b (push_of x0 v c) (place x0 v) v v.
Proof.
  intros Av Dv Sm. pose proof (cont_ac _ Av) as Cv.
  assert (Cx : cont (place x0 v)) by (unfold place; continuous).
  assert (Rx : forall t, 0 <= t -> rderiv (place x0 v) t (v t)) by (intros t Ht; unfold place; rate; ring).
  split; [exact (ac_of_rderiv _ v Cx Cv Rx)|]. repeat (split; [auto|]).
  generalize (almost_and _ _ almost_later (almost_and _ _ Dv Sm)). apply almost_impl. intros t _ (Ht & D & Hc).
  exists (c t), (c t). split; [exact (derive_of_rderiv _ v t Cx Cv Rx Ht)|split; [auto|split; [auto|]]].
  replace (v t - v t) with 0 by ring. destruct (sgn_cases 0) as [(L & _)|[(L & _)|(_ & ->)]]; try lra.
  destruct (sgn_cases (Rabs (c t) - b / m2)) as [(L & _)|[(_ & ->)|(L & _)]]; try lra. rewrite Rabs_R0.
  unfold push_of. split; [ring|field].
Qed.

(** [literal-reference] A pair that sticks has the velocity $v$ under (3), (4) and some force exactly if $v$ is
    absolutely continuous with $|\dot v|<b/m_2$ at almost every time, wherever body 1 starts. *)
Theorem literal_reference (v : R -> R) x0 : (exists u x, switching m1 m2 a1 a2 b u x v v /\ x 0 = x0) <->
  ac v /\ almost (fun t => exists c : R, is_derive v t c /\ Rabs c < b / m2).
Proof.
  split.
  - intros (u & x & Sw & _). apply forced_switching_iff in Sw; auto. destruct Sw as (F & L). split; [apply F|].
    generalize (almost_and _ _ L (stuck_at m1 m2 a1 a2 b Hm1 Hm2 Hb _ _ _ _ F)). apply almost_impl.
    intros t _ (Lt & St). destruct (St eq_refl) as (c & _ & D & _ & Ld & _). exists c. split; [auto|].
    rewrite Ld, Rabs_mult, (Rabs_pos_eq m2) in Lt by lra. undivide m2. lra.
  - intros (Av & Sm). exists (push_of x0 v (Derive v)), (place x0 v).
    split; [|unfold place; rewrite integral_0; ring]. apply literal_force; auto; revert Sm; apply almost_impl;
      intros t _ (c & D & Hc); [apply Derive_correct; eexists; exact D|rewrite (is_derive_unique _ _ _ D); auto].
Qed.
End Literal.

(** *** From rest to rest *)
(** away from c the distance from c is a straight line *)
Lemma side_near c t : t <> c -> exists d, 0 < d /\ forall r, t - d < r < t + d ->
  side (r - c) = side (t - c) /\ Rabs (r - c) = Rabs (t - c) + side (t - c) * (r - t).
Proof.
  intros N. exists (Rabs (t - c)). split; [apply Rabs_pos_lt; lra|]. intros r Hr. unfold side.
  destruct (Rle_dec 0 (t - c)); [rewrite (Rabs_pos_eq (t - c)) in * by lra|rewrite (Rabs_left (t - c)) in * by lra];
    destruct (Rle_dec 0 (r - c)); try lra; [rewrite Rabs_pos_eq|rewrite Rabs_left]; lra.
Qed.

(** [literal-transfer] Under (3), (4) a stuck pair takes body 2 from rest to rest over any $D$ of either sign in any
    time above $2\sqrt{m_2|D|/b}$, and stays, under a force that is continuous at almost every time. *)
Theorem literal_transfer m1 m2 a1 a2 b x0 y0 D T : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b ->
  2 * sqrt (m2 * Rabs D / b) < T -> exists u U x v y, integral_of u U /\ almost (continuous u) /\
  switching m1 m2 a1 a2 b u x v v /\ cont y /\ (forall t, 0 <= t -> rderiv y t (v t)) /\
  x 0 = x0 /\ v 0 = 0 /\ y 0 = y0 /\ forall t, T <= t -> v t = 0 /\ y t = y0 + D.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb HT. set (tau := T / 2). set (A := D / tau ^ 2).
  assert (Q0 : 0 <= m2 * Rabs D / b) by positive. pose proof (sqrt_pos (m2 * Rabs D / b)) as Sp.
  assert (Ht : 0 < tau) by positive. assert (Lim : Rabs A < b / m2).
  { assert (Q : m2 * Rabs D / b < tau ^ 2).
    { rewrite <- (sqrt_sqrt (m2 * Rabs D / b)) by auto. unfold tau in *. nra. }
    unfold A. rewrite Rabs_div, (Rabs_pos_eq (tau ^ 2)) by (try apply pow2_ge_0; nra).
    undivide (tau ^ 2). replace (Rabs D) with (b / m2 * (m2 * Rabs D / b)) by (field; lra). scale. }
  set (v := fun t => A * bang 1 1 tau t). set (c := fun t => A * push 1 1 tau t).
  set (y := fun t => y0 + A * (run 1 1 tau t - run 1 1 tau 0)).
  assert (Lip : forall p q, 0 <= p <= q -> Rabs (bang 1 1 tau q - bang 1 1 tau p) <= 1 * (q - p)).
  { intros p q Hp. replace 1 with (1 / 1) at 5 by field. apply bang_lip; lra. }
  assert (Line : almost (fun t => 0 < t /\ exists d, 0 < d /\ forall r, t - d < r < t + d -> c r = c t /\
    v r = v t + c t * (r - t))).
  { generalize (almost_and _ _ almost_later (almost_and _ _ (almost_not (2 * tau)) (almost_not tau))).
    apply almost_impl. intros t _ (Pt & N2 & N1). split; [auto|]. destruct (side_near (2 * tau) t N2) as (d2 & Hd2 & K2).
    destruct (side_near tau t N1) as (d1 & Hd1 & K1). destruct (side_near 0 t ltac:(lra)) as (d & Hd & K).
    smaller d (Rmin d1 d2). intros r Hr.
    destruct (K r ltac:(lra)) as (S & B), (K1 r ltac:(lra)) as (S1 & B1), (K2 r ltac:(lra)) as (S2 & B2).
    unfold c, v, push, bang. rewrite S, S1, S2, B, B1, B2. split; field. }
  assert (Bc : forall t, 0 <= t -> Rabs (c t) <= Rabs A).
  { intros t Pt. unfold c. rewrite Rabs_mult. apply Rle_trans with (Rabs A * 1); [|lra].
    apply Rmult_le_compat_l; [apply Rabs_pos|]. exact (lip_rderiv _ 1 t _ Lip Pt (rderiv_bang 1 1 tau t)). }
  assert (Av : ac v).
  { apply ac_scal, ac_lip. intros S _. exists 1. split; [lra|]. intros r t Hr _. apply Lip, Hr. }
  pose proof (cont_ac v Av) as Cv.
  assert (Dv : almost (fun t => is_derive v t (c t))).
  { revert Line. apply almost_impl. intros t _ (_ & d & Hd & K).
    apply (derive_near (fun r => v t + c t * (r - t)) v t d); auto; [intros; symmetry; apply K; auto|].
    auto_derive; auto. ring. }
  set (x := fun t => x0 + integral v t). set (u := fun t => (m1 + m2) * c t + a1 * v t + a2 * x t).
  assert (Cx : cont x) by continuous. assert (Rx : forall t, 0 <= t -> rderiv x t (v t)) by (intros t Ht';
    rate; ring).
  set (U := fun t => (m1 + m2) * v t + (a1 * x t + a2 * integral x t)). exists u, U, x, v, y. split; [split|].
  { apply ac_plus; [apply ac_scal; auto|]. apply ac_plus; apply ac_scal; [exact (ac_of_rderiv x v Cx Cv Rx)|].
    apply (ac_of_rderiv (integral x) x); auto using integral_cont. intros t Ht'. apply integral_rderiv; auto. }
  { generalize (almost_and _ _ almost_later Dv). apply almost_impl. intros t _ (Pt & Dt). unfold u.
    pose proof (derive_of_rderiv x v t Cx Cv Rx Pt) as Dx. pose proof (derive_of_rderiv (integral x) x t (integral_cont
      x Cx) Cx (fun r Hr => integral_rderiv x r Cx Hr) Pt) as Di. rewrite Rplus_assoc.
    apply (is_derive_plus (fun t => (m1 + m2) * v t)); [apply (is_derive_scal v); auto|].
    apply (is_derive_plus (fun t => a1 * x t)); [apply (is_derive_scal x)|apply (is_derive_scal (integral x))]; auto. }
  split.
  { revert Line. apply almost_impl. intros t _ (Pt & d & Hd & K).
    assert (Dx : is_derive x t (v t)) by exact (derive_of_rderiv x v t Cx Cv Rx Pt).
    apply (continuous_ext_loc _ (fun r => (m1 + m2) * c t + a1 * (v t + c t * (r - t)) + a2 * x r)).
    { exists (mkposreal d Hd). intros r Hr. unfold ball in Hr; simpl in Hr; unfold AbsRing_ball, abs, minus, plus, opp in Hr;
        simpl in Hr. apply Rabs_def2 in Hr. unfold u. destruct (K r ltac:(lra)) as (-> & ->). reflexivity. }
    apply (ex_derive_continuous (fun r => (m1 + m2) * c t + a1 * (v t + c t * (r - t)) + a2 * x r)).
    eexists. auto_derive; [exists (v t); exact Dx|reflexivity]. }
  split; [apply (literal_force m1 m2 a1 a2 b v c x0 Av Dv); apply (almost_impl (fun t => 0 < t));
    auto using almost_later; intros t Pt _; eapply Rle_lt_trans; [apply Bc|]; auto|].
  assert (Ry : forall t, rderiv y t (v t)).
  { intros t. apply rderiv_eq with (0 + A * (bang 1 1 tau t - 0)); [unfold v; ring|]. apply rderiv_plus;
      [apply rderiv_const|]. apply rderiv_scal, rderiv_minus; [apply rderiv_run|apply rderiv_const]. }
  split.
  { unfold y, run. continuous. }
  split; [intros; apply Ry|]. split; [unfold x; rewrite integral_0; ring|]. split.
  { unfold v, bang. rewrite Rminus_0_r, Rabs_R0, !Rabs_left by lra. field. }
  split; [unfold y; ring|]. intros t Le. assert (2 * tau <= t) by (unfold tau; lra). split.
  - unfold v, bang. rewrite !Rabs_pos_eq by lra. field.
  - unfold y, run. rewrite !(Rabs_pos_eq (t - _)) by lra. rewrite (Rminus_0_r 0), Rabs_R0, !Rabs_left by lra.
    unfold A. field. lra.
Qed.
