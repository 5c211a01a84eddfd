(** The friction pair: what a solution is; two solutions never move apart in the energy norm, so they are unique; the
    rate of the energy; and how long a stay off S can last. With damping a1 >= 0 throughout. *)
From Coq Require Import Reals Lra Psatz.
From InertialPair Require Import Dini.
Local Open Scope R_scope.

(** *** What friction and inertia do in a short time *)

(** s is at the time t the impulse of the set-valued sign of w *)
Definition pushes (s : R -> R) (w t : R) :=
  (forall h, 0 < h -> - h <= s (t + h) - s t <= h) /\ (0 < w -> rderiv s t 1) /\ (w < 0 -> rderiv s t (-1)).

(** a 1-Lipschitz impulse moves by O(h) *)
Lemma pushes_big s w t : pushes s w t -> big (fun h => s (t + h) - s t).
Proof. intros (L & _). exists 1, 1; repeat split; try lra. intros h Hh. apply Rabs_le. specialize (L h). lra. Qed.

(** if w' < w then s rises at least as fast as s': either w > 0 and s rises with slope 1, or w' < 0 and s' falls with
  slope -1 *)
Lemma friction_order s s' w w' t : pushes s w t -> pushes s' w' t -> w' < w ->
  forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> - e * h <= (s (t + h) - s t) - (s' (t + h) - s' t).
Proof.
  intros (L & P & _) (L' & _ & N') W e He. destruct (Rlt_dec 0 w) as [Pos|].
  - destruct (P Pos e He) as (d & Hd & K). exists d; split; auto. intros h Hh. specialize (K h Hh).
    specialize (L' h ltac:(lra)). apply Rabs_inv in K. lra.
  - destruct (N' ltac:(lra) e He) as (d & Hd & K). exists d; split; auto. intros h Hh. specialize (K h Hh).
    specialize (L h ltac:(lra)). apply Rabs_inv in K. lra.
Qed.

(** friction is monotone: the increments of two impulses against the relative velocities *)
Lemma friction_monotone s s' w w' t : pushes s w t -> pushes s' w' t ->
  forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
  - e * h <= ((s (t + h) - s t) - (s' (t + h) - s' t)) * (w - w').
Proof.
  intros H H' e He. set (q := w - w'). pose proof (Rabs_pos q).
  assert (He1 : 0 < e / (Rabs q + 1)) by (apply Rdiv_lt_0_compat; lra).
  assert (Q : e / (Rabs q + 1) * Rabs q <= e).
  { replace e with (e / (Rabs q + 1) * (Rabs q + 1)) at 2 by (field; lra). apply Rmult_le_compat_l; lra. }
  destruct (Rtotal_order q 0) as [Lt|[Eq|Gt]].
  - destruct (friction_order s' s w' w t H' H ltac:(unfold q in Lt; lra) _ He1) as (d & Hd & K).
    exists d; split; auto. intros h Hh. specialize (K h Hh). rewrite Rabs_left in * by auto.
    set (e1 := e / (- q + 1)) in *. nra.
  - exists 1; split; [lra|]. intros h Hh. rewrite Eq. nra.
  - destruct (friction_order s s' w w' t H H' ltac:(unfold q in Gt; lra) _ He1) as (d & Hd & K).
    exists d; split; auto. intros h Hh. specialize (K h Hh). rewrite Rabs_pos_eq in * by lra.
    set (e1 := e / (q + 1)) in *. nra.
Qed.

(** the power of friction *)
Lemma friction_power s w t : pushes s w t -> little (fun h => (s (t + h) - s t) * w - Rabs w * h).
Proof.
  intros (_ & P & N). destruct (Rtotal_order w 0) as [Lt|[->|Gt]].
  - eapply little_ext; [|exact (little_scal w _ (N Lt))]. intros h; simpl. rewrite Rabs_left by lra. ring.
  - eapply little_ext; [|exact little_0]. intros h; simpl. rewrite Rabs_R0; ring.
  - eapply little_ext; [|exact (little_scal w _ (P Gt))]. intros h; simpl. rewrite Rabs_pos_eq by lra. ring.
Qed.

Section Pair.
Variables m1 m2 a1 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** [s] is the impulse of the set-valued sign, s t = int_0^t sigma: sigma in [-1,1] a.e. is [s_lip];
    sigma = +-1 a.e. on the open sets {v1 > v2}, {v1 < v2} is [s_pos], [s_neg]. *)
Record solution (x v1 v2 s : R -> R) : Prop := {
  s_lip : forall r t, 0 <= r <= t -> Rabs (s t - s r) <= t - r;
  s_pos : forall t, 0 <= t -> v2 t < v1 t -> rderiv s t 1;
  s_neg : forall t, 0 <= t -> v1 t < v2 t -> rderiv s t (-1);
  s_cx : cont x;
  s_cv : cont v1;
  s_x : forall t, 0 <= t -> rderiv x t (v1 t);
  s_v1 : forall t, 0 <= t -> rderiv (fun u => m1 * v1 u + b * s u) t (- (a2 * x t + a1 * v1 t));
  s_v2 : forall t, 0 <= t -> m2 * v2 t - b * s t = m2 * v2 0 - b * s 0 }.

(** the energy E of the pair *)
Definition energy (x v1 v2 : R) := a2 * x ^ 2 / 2 + m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2.

(** how the energy changes when body 1 has the force l beside friction, and body 2 friction alone *)
Lemma energy_increment x v1 v2 s t l : rderiv x t (v1 t) -> rderiv (fun r => m1 * v1 r + b * s r) t l ->
  (forall h, 0 < h -> v2 (t + h) - v2 t = b / m2 * (s (t + h) - s t)) -> big (fun h => s (t + h) - s t) ->
  little (fun h => energy (x (t + h)) (v1 (t + h)) (v2 (t + h)) - energy (x t) (v1 t) (v2 t)
    - (l + a2 * x t) * v1 t * h + b * ((s (t + h) - s t) * (v1 t - v2 t))).
Proof.
  intros X V W S. unfold rderiv in X, V.
  set (ex := fun h => x (t + h) - x t - v1 t * h) in *.
  set (ev := fun h => m1 * v1 (t + h) + b * s (t + h) - (m1 * v1 t + b * s t) - l * h) in *.
  set (ds := fun h => s (t + h) - s t) in *.
  set (dx := fun h => ex h + v1 t * h). set (dv := fun h => / m1 * (ev h + l * h - b * ds h)).
  set (dw := fun h => b / m2 * ds h).
  assert (BX : big dx) by (apply big_plus; [apply little_big; auto|apply big_scal, big_id]).
  assert (BV : big dv).
  { apply big_scal, big_minus; [|apply big_scal; auto]. apply big_plus; [apply little_big;
    auto|apply big_scal, big_id]. }
  assert (BW : big dw) by (apply big_scal; auto).
  set (rest := fun h => a2 * x t * ex h + v1 t * ev h + a2 / 2 * (dx h * dx h) + m1 / 2 * (dv h * dv h)
    + m2 / 2 * (dw h * dw h)).
  assert (LR : little rest) by (unfold rest; repeat apply little_plus; apply little_scal; auto; apply big_mult; auto).
  intros e He. destruct (LR e He) as (d & Hd & K). exists d; split; auto. intros h Hh. specialize (K h Hh).
  match goal with |- Rabs ?y <= _ => replace y with (rest h); auto end.
  replace (x (t + h)) with (x t + dx h) by (unfold dx, ex; ring).
  replace (v1 (t + h)) with (v1 t + dv h) by (unfold dv, ev, ds; field; lra).
  replace (v2 (t + h)) with (v2 t + dw h) by (specialize (W h ltac:(lra)); unfold dw, ds; lra).
  unfold energy, rest. fold (ds h). unfold dx at 1 2, dv at 1 2, dw at 1 2. unfold dx, dv, dw. field. split; lra.
Qed.

(** the energy distance of two motions: the elastic terms cancel, friction only takes away *)
Lemma distance_dini x v1 v2 s x' v1' v2' s' t l : rderiv x t (v1 t) -> rderiv x' t (v1' t) ->
  rderiv (fun r => m1 * (v1 r - v1' r) + b * (s r - s' r)) t l ->
  (forall h, 0 < h -> v2 (t + h) - v2 t = b / m2 * (s (t + h) - s t)) ->
  (forall h, 0 < h -> v2' (t + h) - v2' t = b / m2 * (s' (t + h) - s' t)) ->
  pushes s (v1 t - v2 t) t -> pushes s' (v1' t - v2' t) t ->
  dini_le (fun r => energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r)) t ((l + a2 * (x t - x' t)) * (v1 t - v1' t)).
Proof.
  intros X X' V W W' S S' e He.
  destruct (energy_increment (fun r => x r - x' r) (fun r => v1 r - v1' r) (fun r => v2 r - v2' r) (fun r => s r - s' r)
    t l) with (eps := e / 2) as (d1 & Hd1 & K1); try lra.
  - apply rderiv_minus; auto.
  - exact V.
  - intros h Hh. specialize (W h Hh). specialize (W' h Hh). lra.
  - eapply big_ext; [|exact (big_minus _ _ (pushes_big _ _ _ S) (pushes_big _ _ _ S'))]. intros h; simpl; ring.
  - destruct (friction_monotone s s' _ _ t S S' (e / (2 * b))) as (d2 & Hd2 & K2); [apply Rdiv_lt_0_compat; lra|].
    exists (Rmin d1 d2); split; [apply Rmin_glb_lt; auto|]. intros h Hh. pose proof (Rmin_l d1 d2).
    pose proof (Rmin_r d1 d2).
    specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). cbv beta in K1. apply Rabs_inv in K1.
    apply Rmult_le_compat_l with (r := b) in K2; [|lra].
    replace (b * (- (e / (2 * b)) * h)) with (- (e / 2) * h) in K2 by (field; lra).
    match type of K1 with _ <= _ + b * ?f <= _ => match type of K2 with _ <= b * ?g => replace f with g in K1 by ring
      end end.
    lra.
Qed.

(** the impulse is continuous *)
Lemma cont_s x v1 v2 s : solution x v1 v2 s -> cont s.
Proof. intros H. apply (lip_cont s 1); [lra|]. intros. rewrite Rmult_1_l. apply (s_lip _ _ _ _ H); auto. Qed.

(** v2 is continuous, as m2 v2 - b s is constant *)
Lemma cont_v2 x v1 v2 s : solution x v1 v2 s -> cont v2.
Proof.
  intros H. apply cont_ext with (fun u => (v2 0 - b / m2 * s 0) + b / m2 * s u).
  { intros u Hu. pose proof (s_v2 _ _ _ _ H u Hu). apply Rmult_eq_reg_l with m2; [|lra].
    replace (m2 * (v2 0 - b / m2 * s 0 + b / m2 * s u)) with ((m2 * v2 0 - b * s 0) + b * s u) by (field; lra). lra. }
  apply cont_plus; [apply cont_const|]. apply cont_scal. apply (cont_s _ _ _ _ H).
Qed.

(** body 2 is moved by friction alone *)
Lemma driven_v2 x v1 v2 s t : solution x v1 v2 s -> 0 <= t -> forall h, 0 < h -> v2 (t + h) - v2 t = b / m2 * (s (t +
  h) - s t).
Proof.
  intros H Ht h Hh. pose proof (s_v2 _ _ _ _ H (t + h) ltac:(lra)). pose proof (s_v2 _ _ _ _ H t Ht).
  apply Rmult_eq_reg_l with m2; [|lra]. replace (m2 * (b / m2 * (s (t + h) - s t))) with (b * (s (t + h) - s t)) by
    (field; lra). lra.
Qed.
(** friction, as it pushes it *)
Lemma solution_pushes x v1 v2 s t : solution x v1 v2 s -> 0 <= t -> pushes s (v1 t - v2 t) t.
Proof.
  intros H Ht. split; [|split; intros W; [apply (s_pos _ _ _ _ H)|apply (s_neg _ _ _ _ H)]; lra].
  intros h Hh. apply Rabs_inv. replace h with (t + h - t) at 2 by ring. apply (s_lip _ _ _ _ H). lra.
Qed.

(** a solution from a later time on is a solution *)
Lemma shift_solution x v1 v2 s t0 : 0 <= t0 -> solution x v1 v2 s ->
  solution (fun u => x (t0 + u)) (fun u => v1 (t0 + u)) (fun u => v2 (t0 + u)) (fun u => s (t0 + u)).
Proof.
  intros Ht H. destruct H.
  assert (RS : forall f t l, rderiv f (t0 + t) l -> rderiv (fun u => f (t0 + u)) t l).
  { intros f t l F. eapply little_ext; [|exact F]. intros h; simpl. rewrite Rplus_assoc. auto. }
  constructor.
  - intros r t Hr. replace (t - r) with (t0 + t - (t0 + r)) by ring. apply s_lip0; lra.
  - intros; apply RS, s_pos0; [lra|auto].
  - intros; apply RS, s_neg0; [lra|auto].
  - apply cont_shift; auto.
  - apply cont_shift; auto.
  - intros; apply RS, s_x0; lra.
  - intros t Hu. apply (RS (fun u => m1 * v1 u + b * s u)), s_v3; lra.
  - intros t Hu. rewrite Rplus_0_r. rewrite (s_v4 (t0 + t)), (s_v4 t0) by lra. auto.
Qed.

(** *** Contraction in the energy norm *)
Section Two.
Variables x v1 v2 s x' v1' v2' s' : R -> R.
Hypotheses (H : solution x v1 v2 s) (H' : solution x' v1' v2' s').
Let D t := energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t).

(** the energy distance is continuous *)
Lemma cont_D : cont D.
Proof.
  destruct H, H'.
  assert (cont (fun t => x t - x' t)) by (apply cont_minus; auto).
  assert (cont (fun t => v1 t - v1' t)) by (apply cont_minus; auto).
  assert (cont (fun t => v2 t - v2' t)) by (apply cont_minus; eapply cont_v2; eauto).
  apply cont_ext with (fun t => a2 / 2 * ((x t - x' t) * (x t - x' t)) + m1 / 2 * ((v1 t - v1' t) * (v1 t - v1' t))
    + m2 / 2 * ((v2 t - v2' t) * (v2 t - v2' t))).
  { intros; unfold D, energy; field. }
  repeat apply cont_plus; apply cont_scal; apply cont_mult; auto.
Qed.

(** its upper right derivative is at most 0: the elastic terms cancel, damping and friction only take away *)
Lemma D_dini t : 0 <= t -> dini_le D t 0.
Proof.
  intros Ht e He.
  assert (V : rderiv (fun r => m1 * (v1 r - v1' r) + b * (s r - s' r)) t (- (a2 * (x t - x' t) + a1 * (v1 t - v1' t)))).
  { eapply little_ext; [|exact (little_minus _ _ (s_v1 _ _ _ _ H t Ht) (s_v1 _ _ _ _ H' t Ht))].
    intros h; simpl; ring. }
  destruct (distance_dini _ _ _ _ _ _ _ _ _ _ (s_x _ _ _ _ H t Ht) (s_x _ _ _ _ H' t Ht) V (driven_v2 _ _ _ _ t H Ht)
    (driven_v2 _ _ _ _ t H' Ht) (solution_pushes _ _ _ _ t H Ht) (solution_pushes _ _ _ _ t H' Ht) e He) as (d & Hd &
      K).
  exists d; split; auto. intros h Hh. specialize (K h Hh). unfold D. pose proof (pow2_ge_0 (v1 t - v1' t)).
  assert (0 <= a1 * (v1 t - v1' t) ^ 2 * h) by (apply Rmult_le_pos; [apply Rmult_le_pos; auto|lra]). lra.
Qed.

(** so it never grows *)
Theorem contraction r t : 0 <= r <= t -> D t <= D r.
Proof. intros Hr. apply dini_mono; auto. apply cont_D. intros u Hu. apply D_dini; lra. Qed.
End Two.

(** the energy is not negative *)
Lemma energy_pos x v1 v2 : 0 <= energy x v1 v2.
Proof. unfold energy. pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 v1). pose proof (pow2_ge_0 v2). nra. Qed.

(** and 0 only at rest *)
Lemma energy_zero x v1 v2 : energy x v1 v2 <= 0 -> x = 0 /\ v1 = 0 /\ v2 = 0.
Proof.
  unfold energy. intros E. pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 v1). pose proof (pow2_ge_0 v2).
  assert (x ^ 2 = 0) by nra. assert (v1 ^ 2 = 0) by nra. assert (v2 ^ 2 = 0) by nra.
  repeat split; apply Rsqr_0_uniq; unfold Rsqr; lra.
Qed.

(** *** Forward uniqueness *)
Theorem unique x v1 v2 s x' v1' v2' s' t0 : solution x v1 v2 s -> solution x' v1' v2' s' -> 0 <= t0 ->
  x t0 = x' t0 -> v1 t0 = v1' t0 -> v2 t0 = v2' t0 ->
  forall t, t0 <= t -> x t = x' t /\ v1 t = v1' t /\ v2 t = v2' t.
Proof.
  intros H H' Ht X V W t Hu. pose proof (contraction _ _ _ _ _ _ _ _ H H' t0 t ltac:(lra)) as C. simpl in C.
  rewrite X, V, W in C. replace (energy (x' t0 - x' t0) (v1' t0 - v1' t0) (v2' t0 - v2' t0)) with 0 in C by
    (unfold energy; field).
  apply energy_zero in C. lra.
Qed.

(** *** Energy: dE/dt = - b |v1 - v2| - a1 v1^2 at every time (right derivative) *)
Section One.
Variables x v1 v2 s : R -> R.
Hypothesis H : solution x v1 v2 s.
Let E t := energy (x t) (v1 t) (v2 t).

(** the work of friction, and of the damper *)
Theorem energy_rate t : 0 <= t -> rderiv E t (- b * Rabs (v1 t - v2 t) - a1 * v1 t ^ 2).
Proof.
  intros Ht. pose proof (solution_pushes _ _ _ _ t H Ht) as S. eapply little_ext; [|exact (little_minus _ _
    (energy_increment x v1 v2 s t _ (s_x _ _ _ _ H t Ht) (s_v1 _ _ _ _ H t Ht) (driven_v2 _ _ _ _ t H Ht) (pushes_big
      _ _ _ S)) (little_scal b _ (friction_power _ _ _ S)))].
  intros h. unfold E. cbv beta. ring.
Qed.

(** the energy is continuous *)
Lemma cont_E : cont E.
Proof.
  apply cont_ext with (fun t => a2 / 2 * (x t * x t) + m1 / 2 * (v1 t * v1 t) + m2 / 2 * (v2 t * v2 t)).
  { intros; unfold E, energy; field. }
  destruct H. repeat apply cont_plus; apply cont_scal; apply cont_mult; auto; eapply cont_v2; eauto.
Qed.

(** so the energy never increases *)
Theorem energy_decreases r t : 0 <= r <= t -> E t <= E r.
Proof.
  intros Hr. apply (rderiv_mono E r t (fun u => - b * Rabs (v1 u - v2 u) - a1 * v1 u ^ 2)); auto. apply cont_E.
  intros u Hu. split; [apply energy_rate; lra|]. pose proof (Rabs_pos (v1 u - v2 u)).
    pose proof (pow2_ge_0 (v1 u)). nra.
Qed.

(** *** A stay off S is short *)
Lemma slip_impulse r t k : 0 <= r <= t -> (k = 1 \/ k = -1) -> (forall u, r <= u < t -> 0 < k * (v1 u - v2 u)) ->
  s t - s r = k * (t - r).
Proof.
  intros Hr Hk O.
  assert (RD : forall u, r <= u < t -> rderiv s u k).
  { intros u Hu. pose proof (O u Hu). destruct Hk; subst k; [apply (s_pos _ _ _ _ H)|apply (s_neg _ _ _ _ H)]; lra. }
  pose proof (cont_s _ _ _ _ H) as C.
  assert (s t - s r <= k * (t - r)).
  { apply dini_slope; auto. intros u Hu. eapply rderiv_dini; [|apply RD; auto]. lra. }
  assert (- s t - - s r <= - k * (t - r)).
  { apply (dini_slope (fun u => - s u)); auto.
    { apply cont_ext with (fun u => -1 * s u); [intros; ring|apply cont_scal; auto]. }
    intros u Hu. apply rderiv_dini with (-1 * k); [lra|].
      apply rderiv_ext with (fun u => -1 * s u); [intros; ring|]. apply rderiv_scal; auto. }
  lra.
Qed.

(** the velocity of body 2 changes at a constant rate and is bounded by the energy *)
Theorem dwell r t : 0 <= r <= t ->
  (forall u, r <= u < t -> v2 u < v1 u) \/ (forall u, r <= u < t -> v1 u < v2 u) ->
  t - r <= 2 * sqrt (2 * E r * m2) / b.
Proof.
  intros Hr O.
  assert (Sq : (s t - s r) ^ 2 = (t - r) ^ 2).
  { destruct O as [O|O]; [rewrite (slip_impulse r t 1)|rewrite (slip_impulse r t (-1))]; auto; try ring;
    intros u Hu; specialize (O u Hu); lra. }
  pose proof (energy_decreases r t Hr) as De.
  assert (B : forall u, r <= u -> E u <= E r -> Rabs (m2 * v2 u) <= sqrt (2 * E r * m2)).
  { intros u _ Hu. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr.
    unfold E at 1, energy in Hu. pose proof (pow2_ge_0 (x u)). pose proof (pow2_ge_0 (v1 u)).
    assert (m2 * v2 u ^ 2 <= 2 * E r) by nra. replace (m2 * v2 u * (m2 * v2 u)) with (m2 * v2 u ^ 2 * m2) by ring.
    apply Rmult_le_compat_r; lra. }
  pose proof (B r ltac:(lra) ltac:(lra)) as B1. pose proof (B t ltac:(lra) De) as B2.
  apply Rabs_inv in B1. apply Rabs_inv in B2.
  pose proof (s_v2 _ _ _ _ H r ltac:(lra)) as W1. pose proof (s_v2 _ _ _ _ H t ltac:(lra)) as W2.
  assert (AB : b * (t - r) <= 2 * sqrt (2 * E r * m2)).
  { assert (Z : b * (s t - s r) = m2 * v2 t - m2 * v2 r) by lra.
    assert (T : s t - s r = t - r \/ s t - s r = - (t - r)).
    { assert ((s t - s r - (t - r)) * (s t - s r + (t - r)) = 0) as M by nra.
      apply Rmult_integral in M. lra. }
    destruct T as [T|T]; rewrite T in Z; lra. }
  apply Rmult_le_reg_l with b; auto. replace (b * (2 * sqrt (2 * E r * m2) / b)) with (2 * sqrt (2 * E r * m2)) by
    (field; lra). auto.
Qed.
End One.
End Pair.
