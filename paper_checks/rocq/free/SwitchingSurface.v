(** The switching surface S, its sliding region S0 and the critical energy, as statements about solutions (a1 = 0).

    At a contact the pair sticks for a while exactly if it is inside S0, or on an edge and does not move outwards;
      otherwise
    it slips at once, into the half-space of the transversality conditions. The ellipses on S up to E_cr are the only
    motions on S that last for ever. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle ExitOrbit SharpRate SharpLaw SlipFromGap
  AfterOneSlip ReturnToS0.

Section Surface.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b) (q0 : 0 < q := q_pos m1 m2 Hm1 Hm2)
  (L0 : 0 < L := L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) (E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb).

(** the rate of v1 - v2 in the slip of sign k: Phi_k . n_S *)
Definition normal_rate k x := - (a2 * m2 * x + k * b * (m1 + m2)) / (m1 * m2).

Section Solution.
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).

(** Off S: v1 - v2 has the rate of the slip of its sign. *)
Lemma rate_by_impulse t k : 0 <= t -> rderiv s t k -> rderiv (fun u => v1 u - v2 u) t (normal_rate k (x t)).
Proof.
  intros Ht S. pose proof (proj1 (solution_moves _ _ _ _ _ _ _ _ _) H) as Mo.
  eapply rderiv_eq; [|exact (moves_rate _ _ _ _ _ Hm1 Hm2 _ _ _ _ _ _ Mo t 0 k Ht (rderiv_const 0 t) S)].
  unfold normal_rate. field. lra.
Qed.
(** [rate-above] While $v_1>v_2$ the relative velocity has the rate $\Phi_+\cdot n_S$. *)
Theorem rate_above t : 0 <= t -> v2 t < v1 t -> rderiv (fun u => v1 u - v2 u) t (normal_rate 1 (x t)).
Proof. intros Ht Hv. apply rate_by_impulse; auto. apply (s_pos _ _ _ _ _ _ _ _ _ H); auto. Qed.
(** [rate-below] While $v_1<v_2$ the relative velocity has the rate $\Phi_-\cdot n_S$. *)
Theorem rate_below t : 0 <= t -> v1 t < v2 t -> rderiv (fun u => v1 u - v2 u) t (normal_rate (-1) (x t)).
Proof. intros Ht Hv. apply rate_by_impulse; auto. apply (s_neg _ _ _ _ _ _ _ _ _ H); auto. Qed.

(** [transversal-beyond] On $S$ beyond $S_0$ both rates have the sign of $-x_1$. *)
Theorem transversal_beyond y k : (k = 1 \/ k = -1) -> (L < y -> normal_rate k y < 0) /\ (y < - L ->
  0 < normal_rate k y).
Proof.
  intros Hk. assert (P : 0 < / (m1 * m2)) by positive.
  assert (Lm : L * (a2 * m2) = b * (m1 + m2)) by (unfold L, Stick.L; field; lra). assert (A0 : 0 < a2 * m2) by positive.
  unfold normal_rate. split; intros Hy.
  - assert (0 < (a2 * m2 * y + k * b * (m1 + m2)) * / (m1 * m2))
      by (apply Rmult_lt_0_compat; auto; destruct Hk; subst k; nra). lra.
  - apply Rmult_lt_0_compat; auto. destruct Hk; subst k; nra.
Qed.
(** [transversal-inside] Both fields point back to $S$ exactly in the interior of $S_0$, back or along it exactly on
    $S_0$. *)
Theorem transversal_inside y : (- L < y < L <-> normal_rate 1 y < 0 < normal_rate (-1) y) /\
  (- L <= y <= L <-> normal_rate 1 y <= 0 <= normal_rate (-1) y).
Proof.
  assert (P : 0 < m1 * m2) by positive. assert (A : 0 < a2 * m2) by positive.
  assert (E1 : normal_rate 1 y * (m1 * m2) = (- L - y) * (a2 * m2)) by (unfold normal_rate, L, Stick.L; field; lra).
  assert (E2 : normal_rate (-1) y * (m1 * m2) = (L - y) * (a2 * m2)) by (unfold normal_rate, L, Stick.L; field; lra).
  split; split; intros (B & C); split; nra.
Qed.

(** [slips-beyond] At a contact beyond $S_0$ every solution slips at once, with the sign of $-x_1$. *)
Theorem slips_beyond t : 0 <= t -> v1 t = v2 t -> ~ (- L <= x t <= L) ->
  exists T, 0 < T /\ forall u, t < u < t + T -> 0 < x t * (v2 u - v1 u).
Proof.
  intros Ht Ev N. destruct (beyond_gap m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 t Ev N) as (k & d & u & Hk & Hd & HG).
  destruct (push_root d u Hd) as (p & (Hp & <-) & _).
  destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t d p Hk H Ht ltac:(lra) Hp HG) as (_ & Sg & _).
  exists (2 * p / o1 m1 a2). pose proof (o1_pos m1 a2 Hm1 Ha2). split; [positive|].
  intros w Hw. specialize (Sg w Hw). destruct HG as (X & _). fold q L in X. assert (0 < L * (1 + q * d)) by positive.
  destruct Hk; subst k; nra.
Qed.

(** [slips-on-ray] On an edge of $S_0$, moving outwards, every solution slips at once, with $\dot z$ of the sign of
    $-x_1$. *)
Theorem slips_on_ray t k : k = 1 \/ k = -1 -> 0 <= t -> v1 t = v2 t -> k * x t = L -> 0 < k * v1 t ->
  exists T, 0 < T /\ forall u, t < u < t + T -> k * v1 u < k * v2 u.
Proof.
  intros Hk Ht Ev Hx Hv. pose proof (o1_pos m1 a2 Hm1 Ha2) as O.
  set (u := k * v1 t * (m2 * o1 m1 a2) / b). assert (Hu : 0 < u) by positive.
  destruct (half_ex u Hu) as (p & Hp & Ep). assert (HR : on_ray m1 m2 a2 b k (hh p) x v1 v2 t).
  { unfold on_ray, ray. rewrite Ep, <- Ev. unfold u. repeat split; auto; field; repeat split; lra. }
  destruct (merges_at_first_landing m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t p Hk Ht Hp HR) as (Sg & _).
  exists (2 * p / o1 m1 a2). split; [positive|exact Sg].
Qed.

(** [sticks-inside] On $S_0$, but for the exit rays, every solution sticks for a while. *)
Theorem sticks_inside t : 0 <= t -> v1 t = v2 t -> - L <= x t <= L -> (x t = L -> v1 t <= 0) -> (x t = - L ->
  0 <= v1 t) ->
  exists T, 0 < T /\ forall u, t <= u <= t + T -> v1 u = v2 u.
Proof.
  intros Ht Ev Hx Hr Hl. destruct (Rle_dec (E t) Ecr) as [Lo|Hi].
  { exists 1. split; [lra|]. intros u Hu.
    apply (sticks_iff m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H t Ht Ev) with (u := u - t) in Lo; [|lra].
    replace (t + (u - t)) with u in Lo by ring. exact Lo. }
  apply Rnot_le_lt in Hi. destruct (level_push m1 m2 a2 b Hm1 Hm2 Ha2 Hb (E t) Hi) as (Hu & En).
  set (u := sqrt _) in *.
  destruct (to_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H t u Ht Ev Hx Hu En) as (k & te & Hk & Te & (X & V & _) & St).
  exists (te - t). split; [|intros w Hw; apply St; lra]. destruct (Req_dec te t) as [->|]; [exfalso|lra].
  fold L in X. pose proof (ray_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb u Hu). destruct Hk; subst k;
    [specialize (Hr ltac:(lra))|specialize (Hl ltac:(lra))]; lra.
Qed.
End Solution.

(** [ellipse-iff] An ellipse on $S$ is a solution exactly if its energy is at most $E_{cr}$. *)
Theorem ellipse_iff x0 v0 : (exists s, solution m1 m2 0 a2 b (X m1 m2 a2 x0 v0) (V m1 m2 a2 x0 v0) (V m1 m2 a2 x0
  v0) s) <->
  energy m1 m2 a2 x0 v0 v0 <= Ecr.
Proof.
  split.
  - intros (s & H). assert (S := sticks_iff m1 m2 a2 b Hm1 Hm2 Ha2 Hb _ _ _ s H 0 (Rle_refl 0) eq_refl). cbv beta in S.
    rewrite ellipse_energy in S by auto. apply S. auto.
  - intros HE. eexists. apply ellipse_solution; auto.
Qed.
End Surface.
