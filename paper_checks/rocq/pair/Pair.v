(** The friction pair: what a solution is; two solutions never move apart in the energy norm, so they are unique; the
    rate of the energy; and how long a stay off S can last. With damping a1 >= 0 throughout. *)
From InertialPair Require Import Dini.

(** *** What friction and inertia do in a short time *)

(** where w > 0 the impulse s rises with slope 1, and where w < 0 it falls with slope -1 *)
Definition opposes (s : R -> R) (w t : R) := forall k, k = 1 \/ k = -1 -> 0 < k * w -> rderiv s t k.
(** s is at the time t the impulse of the set-valued sign of w *)
Definition pushes (s : R -> R) (w t : R) := (forall h, 0 < h -> - h <= s (t + h) - s t <= h) /\ opposes s w t.

(** the power of a friction of the strength b *)
Lemma friction_power b F w t : (forall k, k = 1 \/ k = -1 -> 0 < k * w -> rderiv F t (k * b)) ->
  little (fun h => (F (t + h) - F t) * w - b * Rabs w * h).
Proof.
  intros P. assert (Q : forall k, k = 1 \/ k = -1 -> 0 < k * w -> Rabs w = k * w ->
    little (fun h => (F (t + h) - F t) * w - b * Rabs w * h)).
  { intros k Hk Kw ->. eapply little_ext; [|exact (little_scal w _ (P k Hk Kw))]. intros h; simpl. ring. }
  destruct (Rtotal_order w 0) as [N|[->|N]].
  - apply (Q (-1)); [auto|lra|rewrite Rabs_left; lra].
  - eapply little_ext; [|exact little_0]. intros h; simpl. rewrite Rabs_R0; ring.
  - apply (Q 1); [auto|lra|rewrite Rabs_pos_eq; lra].
Qed.
(** the same of an impulse of the sign *)
Lemma opposes_power s w t : opposes s w t -> little (fun h => (s (t + h) - s t) * w - 1 * Rabs w * h).
Proof. intros P. apply friction_power. intros k Hk W. rewrite Rmult_1_r. auto. Qed.

(** friction is monotone: the increments of two impulses against the relative velocities; each supplies its own velocity
    with all its power, and the other one with no more than that *)
Lemma friction_monotone s s' w w' t : pushes s w t -> pushes s' w' t ->
  forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
  - e * h <= ((s (t + h) - s t) - (s' (t + h) - s' t)) * (w - w').
Proof.
  intros (L & P) (L' & P') e He.
  apply (soon (little_plus _ _ (opposes_power s w t P) (opposes_power s' w' t P') e He)). intros h Hh K.
  apply Rabs_inv in K.
  assert (B : forall y z, - h <= y <= h -> y * z <= Rabs z * h).
  { intros y z Hy. unfold Rabs. destruct Rcase_abs; nra. }
  pose proof (B _ w' (L h Hh)). pose proof (B _ w (L' h Hh)). lra.
Qed.

Section Pair.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

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
  intros X V W S. set (ex := fun h => x (t + h) - x t - v1 t * h) in *.
  set (ev := fun h => m1 * v1 (t + h) + b * s (t + h) - (m1 * v1 t + b * s t) - l * h) in *.
  set (ds := fun h => s (t + h) - s t) in *. set (dx := fun h => ex h + v1 t * h).
  set (dv := fun h => / m1 * (ev h + l * h - b * ds h)). set (dw := fun h => b / m2 * ds h).
  assert (BX : big dx) by (apply big_plus; [apply little_big; auto|apply big_scal, big_id]). assert (BV : big dv).
  { apply big_scal, big_minus; [|apply big_scal; auto]. apply big_plus; [apply little_big;
    auto|apply big_scal, big_id]. }
  assert (BW : big dw) by (apply big_scal; auto).
  set (rest := fun h => a2 * x t * ex h + v1 t * ev h + a2 / 2 * (dx h * dx h) + m1 / 2 * (dv h * dv h)
    + m2 / 2 * (dw h * dw h)).
  assert (LR : little rest) by (unfold rest; repeat apply little_plus; apply little_scal; auto; apply big_mult; auto).
  intros e He. destruct (LR e He) as (d & Hd & K). exists d; split; auto. intros h Hh.
  match goal with |- Rabs ?y <= _ => replace y with (rest h); auto end.
  replace (x (t + h)) with (x t + dx h) by (unfold dx, ex; ring).
  replace (v1 (t + h)) with (v1 t + dv h) by (unfold dv, ev, ds; field; lra).
  replace (v2 (t + h)) with (v2 t + dw h) by (specialize (W h ltac:(lra)); unfold dw, ds; lra). unfold energy, rest.
  fold (ds h). unfold dx, dv, dw. field. split; lra.
Qed.

Lemma energy_cont x v1 v2 : cont x -> cont v1 -> cont v2 -> cont (fun t => energy (x t) (v1 t) (v2 t)).
Proof.
  intros. apply cont_ext with (fun t => a2 / 2 * (x t * x t) + m1 / 2 * (v1 t * v1 t) + m2 / 2 * (v2 t * v2 t)).
  { intros; unfold energy; field. } repeat apply cont_plus; apply cont_scal; apply cont_mult; auto.
Qed.

Lemma energy_pos x v1 v2 : 0 <= energy x v1 v2.
Proof. unfold energy. positive. Qed.

Lemma energy_zero x v1 v2 : energy x v1 v2 <= 0 -> x = 0 /\ v1 = 0 /\ v2 = 0.
Proof.
  unfold energy. intros E. assert (x ^ 2 = 0) by nra. assert (v1 ^ 2 = 0) by nra. assert (v2 ^ 2 = 0) by nra.
  repeat split; apply Rsqr_0_uniq; unfold Rsqr; lra.
Qed.

(** no distance, no difference *)
Lemma energy_apart x v1 v2 x' v1' v2' y w z : energy (x - x') (v1 - v1') (v2 - v2') <= energy (y - y) (w - w) (z - z) ->
  x = x' /\ v1 = v1' /\ v2 = v2'.
Proof.
  intros E. replace (energy (y - y) (w - w) (z - z)) with 0 in E by (unfold energy; field). apply energy_zero in E. lra.
Qed.

(** *** What all motions have in common: friction with the impulse b s, no faster than c b, opposes the slip; the force
    on body 1 has the impulse U *)
Record moves (c : R) (U x v1 v2 s : R -> R) : Prop := {
  q_lip : forall r t, 0 <= r <= t -> Rabs (s t - s r) <= c * (t - r);
  q_slip : forall t, 0 <= t -> opposes s (v1 t - v2 t) t;
  q_cx : cont x;
  q_cv : cont v1;
  q_x : forall t, 0 <= t -> rderiv x t (v1 t);
  q_v1 : forall t, 0 <= t -> rderiv (fun r => m1 * v1 r + b * s r - U r) t (- (a2 * x t + a1 * v1 t));
  q_v2 : forall t, 0 <= t -> m2 * v2 t - b * s t = m2 * v2 0 - b * s 0 }.

(** the slip has either direction *)
Lemma opposes_both s (v1 v2 : R -> R) t : (v2 t < v1 t -> rderiv s t 1) -> (v1 t < v2 t -> rderiv s t (-1)) ->
  opposes s (v1 t - v2 t) t.
Proof. intros P N k [->| ->] W; [apply P|apply N]; lra. Qed.

(** no force: the solutions, and only they *)
Lemma solution_moves x v1 v2 s : solution x v1 v2 s <-> moves 1 (fun _ => 0) x v1 v2 s.
Proof.
  assert (Z : forall t l, rderiv (fun r => m1 * v1 r + b * s r - 0) t l <-> rderiv (fun r => m1 * v1 r + b * s r) t l).
  { split; apply rderiv_ext; intros; ring. }
  split; intros [].
  - constructor; auto using opposes_both; intros; [rewrite Rmult_1_l; auto|apply Z; auto].
  - constructor; auto; intros; [rewrite <- (Rmult_1_l (t - r)); auto|..|apply Z; auto].
    + apply q_slip0; auto; lra.
    + apply q_slip0; auto; lra.
Qed.

Lemma solution_moving x v1 v2 s : solution x v1 v2 s -> moves 1 (fun _ => 0) x v1 v2 s.
Proof. apply solution_moves. Qed.

Section One.
Context (c : R) (U x v1 v2 s : R -> R) (H : moves c U x v1 v2 s).
Let E t := energy (x t) (v1 t) (v2 t).

(** the impulse of friction moves by O(h) *)
Lemma moves_big t : 0 <= t -> big (fun h => s (t + h) - s t).
Proof.
  intros Ht. exists (Rabs c + 1), 1. pose proof (Rabs_pos c). repeat split; try lra. intros h Hh.
  pose proof (q_lip _ _ _ _ _ _ H t (t + h) ltac:(lra)). pose proof (Rle_abs c). nra.
Qed.
Lemma moves_cs : cont s.
Proof.
  apply (lip_cont s c); [|apply (q_lip _ _ _ _ _ _ H)]. pose proof (q_lip _ _ _ _ _ _ H 0 1 ltac:(lra)).
  pose proof (Rabs_pos (s 1 - s 0)). lra.
Qed.
(** body 2 is moved by friction alone *)
Lemma moves_v2 r t : 0 <= r -> 0 <= t -> v2 t - v2 r = b / m2 * (s t - s r).
Proof.
  intros Hr Ht. pose proof (q_v2 _ _ _ _ _ _ H r Hr). pose proof (q_v2 _ _ _ _ _ _ H t Ht).
  apply Rmult_eq_reg_l with m2; [|lra]. replace (m2 * (b / m2 * (s t - s r))) with (b * (s t - s r)) by (field; lra).
  lra.
Qed.
Lemma moves_cv2 : cont v2.
Proof.
  apply cont_ext with (fun u => (v2 0 - b / m2 * s 0) + b / m2 * s u).
  { intros u Hu. pose proof (moves_v2 0 u ltac:(lra) Hu). lra. }
  apply cont_plus; [apply cont_const|apply cont_scal, moves_cs].
Qed.
(** the relative velocity, but for friction *)
Lemma moves_slip t u : 0 <= t -> rderiv U t u ->
  rderiv (fun r => v1 r - v2 r + b * ((m1 + m2) / (m1 * m2)) * s r) t ((u - a2 * x t - a1 * v1 t) / m1).
Proof.
  intros Ht HU. apply rderiv_ext with (fun r => / m1 * (m1 * v1 r + b * s r - U r + U r) - (v2 t - b / m2 * s t)).
  { intros r Hr. pose proof (moves_v2 t r Ht ltac:(lra)). replace (v2 r) with (v2 t + b / m2 * (s r - s t)) by lra.
    field; lra. }
  apply rderiv_eq with (/ m1 * (- (a2 * x t + a1 * v1 t) + u) - 0); [field; lra|].
  apply rderiv_minus; [|apply rderiv_const]. apply rderiv_scal, rderiv_plus; auto. apply (q_v1 _ _ _ _ _ _ H t Ht).
Qed.
(** and with it, where its impulse has the right derivative l *)
Lemma moves_rate t u l : 0 <= t -> rderiv U t u -> rderiv s t l -> rderiv (fun r => v1 r - v2 r) t
  ((m1 + m2) / (m1 * m2) * (m2 * (u - a2 * x t - a1 * v1 t) / (m1 + m2) - b * l)).
Proof.
  intros Ht HU S.
  apply rderiv_ext with (fun r => v1 r - v2 r + b * ((m1 + m2) / (m1 * m2)) * s r - b * ((m1 + m2) / (m1 * m2)) * s r).
  { intros; ring. }
  apply rderiv_eq with ((u - a2 * x t - a1 * v1 t) / m1 - b * ((m1 + m2) / (m1 * m2)) * l); [field; lra|].
  apply rderiv_minus; [apply moves_slip; auto|apply rderiv_scal; auto].
Qed.
(** in a slip the impulse is the time *)
Lemma moves_impulse r t k : 0 <= r <= t -> k = 1 \/ k = -1 -> (forall u, r <= u < t -> 0 < k * (v1 u - v2 u)) ->
  s t - s r = k * (t - r).
Proof. intros Hr Hk O. apply rderiv_line; auto using moves_cs. intros u Hu. apply (q_slip _ _ _ _ _ _ H); auto; lra.
Qed.
(** while spring, damper and force ask at most b of friction in a slip of one direction, none begins *)
Lemma moves_behind r t k : 0 <= r <= t -> k = 1 \/ k = -1 -> k * (v1 r - v2 r) <= 0 ->
  (forall q, r <= q < t -> 0 < k * (v1 q - v2 q) -> exists f, dini_le (fun y => k * U y) q f /\
    m2 * (f - k * (a2 * x q + a1 * v1 q)) <= b * (m1 + m2)) -> k * (v1 t - v2 t) <= 0.
Proof.
  intros Hr Hk W L. apply le_epsilon. intros e He. rewrite Rplus_0_l.
  apply (barrier_until (fun y => k * (v1 y - v2 y)) e r t); [|lra|lra|].
  { apply cont_scal, cont_minus; [apply (q_cv _ _ _ _ _ _ H)|apply moves_cv2]. }
  intros q Hq Pos. destruct (L q Hq ltac:(lra)) as (f & Du & Lf). set (o := b * ((m1 + m2) / m2)).
  pose proof (dini_plus _ _ _ _ _ Du (rderiv_minus _ _ _ _ _ (rderiv_scal k _ _ _ (q_v1 _ _ _ _ _ _ H q ltac:(lra)))
    (rderiv_scal (o * k) _ _ _ (q_slip _ _ _ _ _ _ H q ltac:(lra) k Hk ltac:(lra))))) as D.
  assert (N : f + (k * - (a2 * x q + a1 * v1 q) - o * k * k) <= 0).
  { apply Rmult_le_reg_l with m2; auto. replace (o * k * k) with o by (destruct Hk; subst k; ring).
    replace (m2 * (f + _)) with (m2 * (f - k * (a2 * x q + a1 * v1 q)) - b * (m1 + m2)) by (unfold o; field; lra). lra.
  }
  intros g Hg. destruct (D (m1 * g)) as (d & Hd & K); [positive|]. exists d. split; auto. intros h Hh.
  specialize (K h Hh). pose proof (moves_v2 q (q + h) ltac:(lra) ltac:(lra)) as V. cbv beta in K |- *.
  apply Rmult_le_reg_l with m1; auto.
  match type of K with ?l <= _ => replace (m1 * _) with l at 1 by (replace (v2 (q + h)) with (v2 q + b / m2 *
    (s (q + h) - s q)) by lra; unfold o; field; lra) end. nra.
Qed.

(** the work of the force, of the damper and of friction *)
Lemma moves_energy_rate t u : 0 <= t -> rderiv U t u -> rderiv E t (u * v1 t - a1 * v1 t ^ 2 - b * Rabs (v1 t - v2 t)).
Proof.
  intros Ht HU. assert (V : rderiv (fun r => m1 * v1 r + b * s r) t (u - (a2 * x t + a1 * v1 t))).
  { eapply little_ext; [|exact (little_plus _ _ (q_v1 _ _ _ _ _ _ H t Ht) HU)]. intros h; simpl; ring. }
  eapply little_ext; [|exact (little_minus _ _ (energy_increment x v1 v2 s t _ (q_x _ _ _ _ _ _ H t Ht) V (fun h Hh =>
    moves_v2 t (t + h) Ht ltac:(lra)) (moves_big t Ht)) (little_scal b _ (opposes_power s _ t
    (q_slip _ _ _ _ _ _ H t Ht))))]. intros h. unfold E. ring.
Qed.
Lemma moves_cE : cont E.
Proof. pose proof moves_cv2. destruct H. apply energy_cont; auto. Qed.
End One.

(** *** Without a force: dE/dt = - b |v1 - v2| - a1 v1^2 at every time (right derivative) *)
Section Free.
Context (c : R) (x v1 v2 s : R -> R) (H : moves c (fun _ => 0) x v1 v2 s).
Let E t := energy (x t) (v1 t) (v2 t).

(** the work of friction, and of the damper *)
Lemma free_energy_rate t : 0 <= t -> rderiv E t (- b * Rabs (v1 t - v2 t) - a1 * v1 t ^ 2).
Proof.
  intros Ht. eapply rderiv_eq; [|exact (moves_energy_rate _ _ _ _ _ _ H t 0 Ht (rderiv_const 0 t))]. ring.
Qed.

Lemma free_decreases r t : 0 <= r <= t -> E t <= E r.
Proof.
  intros Hr. apply (rderiv_mono E r t (fun u => - b * Rabs (v1 u - v2 u) - a1 * v1 u ^ 2)); auto.
  { exact (moves_cE _ _ _ _ _ _ H). }
  intros u Hu. split; [apply free_energy_rate; lra|]. pose proof (Rabs_pos (v1 u - v2 u)). nra.
Qed.

(** a stay off S is short: the velocity of body 2 changes at a constant rate and is bounded by the energy *)
Lemma free_dwell r t : 0 <= r <= t ->
  (forall u, r <= u < t -> v2 u < v1 u) \/ (forall u, r <= u < t -> v1 u < v2 u) ->
  t - r <= 2 * sqrt (2 * E r * m2) / b.
Proof.
  intros Hr O. assert (T : s t - s r = 1 * (t - r) \/ s t - s r = -1 * (t - r)).
  { destruct O as [O|O]; [left|right]; apply (moves_impulse _ _ _ _ _ _ H); auto; intros u Hu; specialize (O u Hu);
      lra. }
  pose proof (free_decreases r t Hr) as De.
  assert (B : forall u, r <= u -> E u <= E r -> Rabs (m2 * v2 u) <= sqrt (2 * E r * m2)).
  { intros u _ Hu. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. unfold E at 1, energy in Hu.
    assert (m2 * v2 u ^ 2 <= 2 * E r) by nra. replace (m2 * v2 u * (m2 * v2 u)) with (m2 * v2 u ^ 2 * m2) by ring.
    apply Rmult_le_compat_r; lra. }
  pose proof (B r ltac:(lra) ltac:(lra)) as B1. pose proof (B t ltac:(lra) De) as B2.
  apply Rabs_inv in B1. apply Rabs_inv in B2.
  pose proof (q_v2 _ _ _ _ _ _ H r ltac:(lra)) as W1. pose proof (q_v2 _ _ _ _ _ _ H t ltac:(lra)) as W2.
  assert (Z : b * (s t - s r) = m2 * v2 t - m2 * v2 r) by lra. undivide b. destruct T as [T|T]; rewrite T in Z; lra.
Qed.
End Free.

(** a motion from a later time on *)
Lemma moves_later c U x v1 v2 s t0 : 0 <= t0 -> moves c U x v1 v2 s -> moves c (fun u => U (t0 + u))
  (fun u => x (t0 + u)) (fun u => v1 (t0 + u)) (fun u => v2 (t0 + u)) (fun u => s (t0 + u)).
Proof.
  intros Ht [L P CX CV X V W]. constructor; auto using cont_shift.
  - intros r t Hr. replace (t - r) with (t0 + t - (t0 + r)) by ring. apply L; lra.
  - intros t Hu k Hk Sl. apply rderiv_earlier, P; auto; lra.
  - intros; apply rderiv_earlier, X; lra.
  - intros t Hu. apply (rderiv_earlier (fun u => m1 * v1 u + b * s u - U u)), V; lra.
  - intros t Hu. rewrite Rplus_0_r, (W (t0 + t)), (W t0) by lra. auto.
Qed.
(** its mirror image, under the opposite force: all terms are odd *)
Lemma moves_mirror c U x v1 v2 s : moves c U x v1 v2 s -> moves c (fun t => - U t)
  (fun t => - x t) (fun t => - v1 t) (fun t => - v2 t) (fun t => - s t).
Proof.
  intros [L P CX CV X V W]. constructor; auto using cont_opp, rderiv_opp.
  - intros r t Hr. replace (- s t - - s r) with (- (s t - s r)) by ring. rewrite Rabs_Ropp; auto.
  - intros t Ht k Hk Sl. apply rderiv_eq with (- - k); [ring|]. apply rderiv_opp, P; [auto|lra|lra].
  - intros t Ht. apply rderiv_ext with (fun u => - (m1 * v1 u + b * s u - U u)); [intros; ring|].
    apply rderiv_eq with (- - (a2 * x t + a1 * v1 t)); [ring|]. apply rderiv_opp; auto.
  - intros t Ht. specialize (W t Ht). lra.
Qed.

(** both of solutions *)
Lemma solution_later x v1 v2 s t0 : 0 <= t0 -> solution x v1 v2 s ->
  solution (fun u => x (t0 + u)) (fun u => v1 (t0 + u)) (fun u => v2 (t0 + u)) (fun u => s (t0 + u)).
Proof. rewrite !solution_moves. apply (moves_later 1 (fun _ => 0)). Qed.
Lemma solution_mirror x v1 v2 s : solution x v1 v2 s ->
  solution (fun t => - x t) (fun t => - v1 t) (fun t => - v2 t) (fun t => - s t).
Proof.
  rewrite !solution_moves. intros H. apply moves_mirror in H. destruct H as [L P CX CV X V W]. constructor; auto.
  intros t Ht. apply rderiv_ext with (fun r => m1 * - v1 r + b * - s r - - 0); [intros; ring|auto].
Qed.

(** *** Two motions *)
Section Two.
Context (U U' x v1 v2 s x' v1' v2' s' : R -> R) (H : moves 1 U x v1 v2 s) (H' : moves 1 U' x' v1' v2' s').
Let D t := energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t).

Lemma moves_cD : cont D.
Proof.
  apply energy_cont; apply cont_minus; [apply (q_cx _ _ _ _ _ _ H)|apply (q_cx _ _ _ _ _ _ H')|apply (q_cv _ _ _ _ _ _ H)|
    apply (q_cv _ _ _ _ _ _ H')|exact (moves_cv2 _ _ _ _ _ _ H)|exact (moves_cv2 _ _ _ _ _ _ H')].
Qed.

(** D' <= du dv1 - a1 dv1^2: the elastic terms cancel, friction only takes away, the impulses of the two forces enter
  only
    through their difference *)
Lemma moves_D_dini t du : 0 <= t -> rderiv (fun r => U r - U' r) t du ->
  dini_le D t (du * (v1 t - v1' t) - a1 * (v1 t - v1' t) ^ 2).
Proof.
  intros Ht HU. assert (V : rderiv (fun r => m1 * (v1 r - v1' r) + b * (s r - s' r)) t
    (du - (a2 * (x t - x' t) + a1 * (v1 t - v1' t)))).
  { eapply little_ext; [|exact (little_plus _ _ (little_minus _ _ (q_v1 _ _ _ _ _ _ H t Ht) (q_v1 _ _ _ _ _ _ H' t Ht))
    HU)]. intros h; simpl; ring. }
  set (w := v1 t - v1' t - (v2 t - v2' t)).
  apply (dini_increment D t _ (fun h => b * ((s (t + h) - s' (t + h) - (s t - s' t)) * w))).
  { eapply little_ext; [|refine (energy_increment (fun r => x r - x' r) (fun r => v1 r - v1' r)
      (fun r => v2 r - v2' r) (fun r => s r - s' r) t _ _ V _ _)].
    - intros h. unfold D, w. ring.
    - apply rderiv_minus; [apply (q_x _ _ _ _ _ _ H t Ht)|apply (q_x _ _ _ _ _ _ H' t Ht)].
    - intros h Hh. pose proof (moves_v2 _ _ _ _ _ _ H t (t + h) Ht ltac:(lra)).
      pose proof (moves_v2 _ _ _ _ _ _ H' t (t + h) Ht ltac:(lra)). lra.
    - eapply big_ext; [|exact (big_minus _ _ (moves_big _ _ _ _ _ _ H t Ht) (moves_big _ _ _ _ _ _ H' t Ht))].
      intros h; simpl; ring. }
  intros e He. assert (Pu : forall U x v1 v2 s, moves 1 U x v1 v2 s -> pushes s (v1 t - v2 t) t).
  { intros V1 y w1 w2 z [L P _ _ _ _ _]. split; [|auto]. intros h Hh. apply Rabs_inv.
    replace h with (1 * (t + h - t)) at 2 by ring. apply L. lra. }
  apply (soon (friction_monotone s s' _ _ t (Pu _ _ _ _ _ H) (Pu _ _ _ _ _ H') (e / b) ltac:(positive))).
  intros h Hh K. replace (- e * h) with (b * (- (e / b) * h)) by (field; lra). unfold w. scale.
Qed.

(** *** Contraction in the energy norm: under one force the distance never grows *)
Lemma moves_contraction r t : (forall u, U u = U' u) -> 0 <= r <= t -> D t <= D r.
Proof.
  intros E Hr. apply dini_mono; auto using moves_cD. intros u Hu. assert (Z : rderiv (fun r => U r - U' r) u 0).
  { apply rderiv_ext with (fun _ => 0); [intros q _; rewrite E; ring|apply rderiv_const]. }
  apply dini_weaken with (2 := moves_D_dini u 0 ltac:(lra) Z). assert (0 <= a1 * (v1 u - v1' u) ^ 2) by positive. lra.
Qed.
End Two.

(** [contraction] The flow is non-expansive in the energy norm, with or without damping. *)
Theorem contraction x v1 v2 s x' v1' v2' s' : solution x v1 v2 s -> solution x' v1' v2' s' -> forall r t, 0 <= r <= t ->
  energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r).
Proof.
  intros H H' r t. apply solution_moves in H, H'.
  exact (moves_contraction _ _ _ _ _ _ _ _ _ _ H H' r t (fun _ => eq_refl)).
Qed.

(** *** Forward uniqueness *)

(** [uniqueness] Two solutions that meet coincide from then on, with or without damping. *)
Theorem unique x v1 v2 s x' v1' v2' s' t0 : solution x v1 v2 s -> solution x' v1' v2' s' -> 0 <= t0 ->
  x t0 = x' t0 -> v1 t0 = v1' t0 -> v2 t0 = v2' t0 ->
  forall t, t0 <= t -> x t = x' t /\ v1 t = v1' t /\ v2 t = v2' t.
Proof.
  intros H H' Ht X V W t Hu. pose proof (contraction _ _ _ _ _ _ _ _ H H' t0 t ltac:(lra)) as C.
  rewrite X, V, W in C. exact (energy_apart _ _ _ _ _ _ _ _ _ C).
Qed.

(** *** Energy: dE/dt = - b |v1 - v2| - a1 v1^2 at every time (right derivative) *)
Section Solution.
Context (x v1 v2 s : R -> R) (H : solution x v1 v2 s).
Let E t := energy (x t) (v1 t) (v2 t).
Let Mo := solution_moving _ _ _ _ H.

(** [energy-rate] $\dot E=-b|v_1-v_2|-a_1v_1^2$ at every time, from the right. *)
Theorem energy_rate t : 0 <= t -> rderiv E t (- b * Rabs (v1 t - v2 t) - a1 * v1 t ^ 2).
Proof. exact (free_energy_rate _ _ _ _ _ Mo t). Qed.
(** [energy-decreases] The energy never increases, with or without damping. *)
Theorem energy_decreases r t : 0 <= r <= t -> E t <= E r.
Proof. exact (free_decreases _ _ _ _ _ Mo r t). Qed.
End Solution.
End Pair.

(** what is proved of all motions holds of solutions *)
Coercion solution_moving : solution >-> moves.
