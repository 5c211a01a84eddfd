(** A solution runs along any smooth arc that obeys the law of friction, by the contraction between the two; and the mirror
    image of a solution is one. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick Excursion Rate.
Local Open Scope R_scope.

Section Arc.
Variables m1 m2 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).

(** A smooth arc on all of R that obeys the law of friction on [0, T): g is a selection of the set-valued sign. *)
Record arc (T : R) (X V1 V2 g : R -> R) : Prop := {
  a_x : forall t, is_derive X t (V1 t);
  a_v1 : forall t, is_derive V1 t (- (a2 * X t + b * g t) / m1);
  a_v2 : forall t, is_derive V2 t (b * g t / m2);
  a_law : forall t, 0 <= t < T -> -1 <= g t <= 1 /\ (V2 t < V1 t -> g t = 1) /\ (V1 t < V2 t -> g t = -1) }.

Section Follow.
Variables x v1 v2 s X V1 V2 g : R -> R.
Variable T : R.
Hypotheses (H : solution m1 m2 0 a2 b x v1 v2 s) (A : arc T X V1 V2 g).
Let D t := energy m1 m2 a2 (x t - X t) (v1 t - V1 t) (v2 t - V2 t).

(** the energy distance to the arc is continuous *)
Lemma cont_gap : cont D.
Proof.
  assert (cont (fun t => x t - X t)). { apply cont_minus; [apply (s_cx _ _ _ _ _ _ _ _ _ H)|eapply cont_of_derive,
    (a_x _ _ _ _ _ A)]. }
  assert (cont (fun t => v1 t - V1 t)).
  { apply cont_minus; [apply (s_cv _ _ _ _ _ _ _ _ _ H)|]. exact (cont_of_derive V1 _ (a_v1 _ _ _ _ _ A)). }
  assert (cont (fun t => v2 t - V2 t)).
  { apply cont_minus; [exact (cont_v2 m1 m2 0 a2 b Hm2 _ _ _ _ H)|]. exact (cont_of_derive V2 _ (a_v2 _ _ _ _ _ A)). }
  apply cont_ext with (fun t => a2 / 2 * ((x t - X t) * (x t - X t)) + m1 / 2 * ((v1 t - V1 t) * (v1 t - V1 t))
    + m2 / 2 * ((v2 t - V2 t) * (v2 t - V2 t))).
  { intros; unfold D, energy; field. }
  repeat apply cont_plus; apply cont_scal; apply cont_mult; auto.
Qed.

(** friction is monotone, one impulse against the selection g *)
Lemma gap_friction t : 0 <= t < T -> forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
  - e * h <= (s (t + h) - s t - g t * h) * ((v1 t - v2 t) - (V1 t - V2 t)).
Proof.
  intros Ht e He. destruct (a_law _ _ _ _ _ A t Ht) as (G & Gp & Gn).
  set (w := v1 t - v2 t). set (W := V1 t - V2 t). pose proof (Rabs_pos (w - W)).
  set (e1 := e / (Rabs (w - W) + 1)). assert (He1 : 0 < e1) by (apply Rdiv_lt_0_compat; lra).
  assert (Q : e1 * Rabs (w - W) <= e).
  { replace e with (e1 * (Rabs (w - W) + 1)) by (unfold e1; field; lra). apply Rmult_le_compat_l; lra. }
  assert (Big : forall k h, Rabs k <= e1 * h -> 0 < h -> - e * h <= k * (w - W)).
  { intros k h Hk Hh. apply Rle_trans with (- Rabs (k * (w - W))); [|pose proof (Rle_abs (- (k * (w - W)))) as Z;
    rewrite Rabs_Ropp in Z; lra].
    rewrite Rabs_mult. assert (Rabs k * Rabs (w - W) <= e1 * h * Rabs (w - W)) by (apply Rmult_le_compat_r; lra). nra. }
  destruct (Rtotal_order w 0) as [Lt|[Eq|Gt]].
  - destruct (s_neg _ _ _ _ _ _ _ _ _ H t ltac:(lra) ltac:(unfold w in Lt; lra) e1 He1) as (d & Hd & K).
    exists d; split; auto. intros h Hh. specialize (Big _ h (K h Hh) ltac:(lra)). cbv beta in Big.
    assert (0 <= (- 1 - g t) * (w - W)).
    { destruct (Rlt_dec W 0) as [n|n]; [rewrite (Gn ltac:(unfold W in n; lra)); lra|]. nra. }
    set (z := s (t + h) - s t) in *. replace ((z - g t * h) * (w - W)) with ((z - -1 * h) * (w - W) + (- 1 - g t)
      * (w - W) * h) by ring. nra.
  - exists 1; split; [lra|]. intros h Hh. rewrite Eq.
    pose proof (s_lip _ _ _ _ _ _ _ _ _ H t (t + h) ltac:(lra)) as Lp. apply Rabs_inv in Lp.
    assert (0 <= (s (t + h) - s t - g t * h) * (0 - W)); [|nra].
    destruct (Rtotal_order W 0) as [n|[n|n]]; [rewrite (Gn ltac:(unfold W in n; lra)); nra|rewrite n;
      lra|rewrite (Gp ltac:(unfold W in n; lra)); nra].
  - destruct (s_pos _ _ _ _ _ _ _ _ _ H t ltac:(lra) ltac:(unfold w in Gt; lra) e1 He1) as (d & Hd & K).
    exists d; split; auto. intros h Hh. specialize (Big _ h (K h Hh) ltac:(lra)). cbv beta in Big.
    assert (0 <= (1 - g t) * (w - W)).
    { destruct (Rlt_dec 0 W) as [n|n]; [rewrite (Gp ltac:(unfold W in n; lra)); lra|]. nra. }
    set (z := s (t + h) - s t) in *. replace ((z - g t * h) * (w - W)) with ((z - 1 * h) * (w - W) + (1 - g t) *
      (w - W) * h) by ring. nra.
Qed.

(** it does not grow, as between two solutions *)
Lemma gap_dini t : 0 <= t < T -> dini_le D t 0.
Proof.
  intros Ht e He. pose proof (gap_friction t Ht) as FM.
  pose proof (s_x _ _ _ _ _ _ _ _ _ H t ltac:(lra)) as Lx. pose proof (s_v1 _ _ _ _ _ _ _ _ _ H t ltac:(lra)) as Lv.
  pose proof (rderiv_of_derive _ _ _ (a_x _ _ _ _ _ A t)) as LX.
    pose proof (rderiv_of_derive _ _ _ (a_v1 _ _ _ _ _ A t)) as LV.
  pose proof (rderiv_of_derive _ _ _ (a_v2 _ _ _ _ _ A t)) as LW. unfold rderiv in *.
  pose proof (big_lip _ (s_lip _ _ _ _ _ _ _ _ _ H) t ltac:(lra)) as S. pose proof (s_v2 _ _ _ _ _ _ _ _ _ H) as W.
  set (X0 := x t - X t). set (P0 := v1 t - V1 t). set (Q0 := v2 t - V2 t).
  set (ex := fun h => x (t + h) - x t - v1 t * h) in *. set (eX := fun h => X (t + h) - X t - V1 t * h) in *.
  set (ev := fun h => m1 * v1 (t + h) + b * s (t + h) - (m1 * v1 t + b * s t) - - (a2 * x t + 0 * v1 t) * h) in *.
  set (eV := fun h => V1 (t + h) - V1 t - - (a2 * X t + b * g t) / m1 * h) in *.
  set (eW := fun h => V2 (t + h) - V2 t - b * g t / m2 * h) in *.
  set (ds := fun h => s (t + h) - s t) in *.
  set (dX := fun h => ex h - eX h + P0 * h).
  set (dV := fun h => / m1 * (ev h - b * ds h) - eV h + (b * g t - a2 * X0) / m1 * h).
  set (dW := fun h => b / m2 * ds h - eW h + - (b * g t / m2) * h).
  assert (BX : big dX). { apply big_plus; [apply little_big, little_minus; auto|apply big_scal, big_id]. }
  assert (BV : big dV).
  { apply big_plus; [|apply big_scal, big_id]. apply big_minus; [|apply little_big; auto].
    apply big_scal, big_minus; [apply little_big; auto|apply big_scal; auto]. }
  assert (BW : big dW). { apply big_plus; [|apply big_scal, big_id].
    apply big_minus; [apply big_scal; auto|apply little_big; auto]. }
  set (rest := fun h => a2 * X0 * (ex h - eX h) + P0 * ev h + - (m1 * P0) * eV h + - (m2 * Q0) * eW h
     + a2 / 2 * (dX h * dX h) + m1 / 2 * (dV h * dV h) + m2 / 2 * (dW h * dW h)).
  assert (LR : little rest).
  { unfold rest. repeat apply little_plus; apply little_scal; auto; try (apply big_mult; auto).
    apply little_minus; auto. }
  destruct (LR (e / 2)) as (d1 & Hd1 & K1); [lra|].
  destruct (FM (e / (2 * b))) as (d2 & Hd2 & K2); [apply Rdiv_lt_0_compat; lra|].
  exists (Rmin d1 d2); split; [apply Rmin_glb_lt; auto|]. intros h Hh.
  pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
  specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). apply Rabs_inv in K1.
  assert (EX : x (t + h) - X (t + h) = X0 + dX h) by (unfold dX, X0, ex, eX, P0; ring).
  assert (EV : v1 (t + h) - V1 (t + h) = P0 + dV h) by (unfold dV, X0, P0, ev, eV, ds; field; lra).
  assert (EW : v2 (t + h) - V2 (t + h) = Q0 + dW h).
  { pose proof (W (t + h) ltac:(lra)). pose proof (W t ltac:(lra)). apply Rmult_eq_reg_l with m2; [|lra].
    unfold dW, Q0, eW, ds.
    replace (m2 * (v2 t - V2 t + (b / m2 * (s (t + h) - s t) - (V2 (t + h) - V2 t - b * g t / m2 * h) + - (b * g t
      / m2) * h))) with
      (m2 * v2 t - m2 * V2 (t + h) + b * (s (t + h) - s t)) by (field; lra). lra. }
  assert (ID : D (t + h) - D t = rest h - b * ((ds h - g t * h) * (P0 - Q0))).
  { unfold D. rewrite EX, EV, EW. fold X0 P0 Q0. unfold energy, rest. unfold dX at 1 2, dV at 1 2, dW at 1 2.
    unfold dX, dV, dW. field. split; lra. }
  rewrite ID.
  assert (K3 : - (e / 2) * h <= b * ((ds h - g t * h) * (P0 - Q0))).
  { replace (- (e / 2) * h) with (b * (- (e / (2 * b)) * h)) by (field; lra). apply Rmult_le_compat_l; [lra|].
    replace (P0 - Q0) with (v1 t - v2 t - (V1 t - V2 t)) by (unfold P0, Q0; ring). exact K2. }
  lra.
Qed.

(** so a solution that starts on the arc stays on it *)
Lemma follow0 : x 0 = X 0 -> v1 0 = V1 0 -> v2 0 = V2 0 -> forall t, 0 <= t <= T -> x t = X t /\ v1 t = V1 t /\
  v2 t = V2 t.
Proof.
  intros E0 E1 E2 t Ht.
  assert (C : D t <= D 0). { apply dini_mono; [apply cont_gap|lra|]. intros u Hu. apply gap_dini; lra. }
  unfold D in C. rewrite E0, E1, E2 in C.
  replace (energy m1 m2 a2 (X 0 - X 0) (V1 0 - V1 0) (V2 0 - V2 0)) with 0 in C by (unfold energy; field).
  apply energy_zero in C; auto. lra.
Qed.
End Follow.

(** Uniqueness on an interval: from a common state at t0 every solution runs along the arc until t0 + T. *)
Theorem follow x v1 v2 s X V1 V2 g T t0 : solution m1 m2 0 a2 b x v1 v2 s -> arc T X V1 V2 g -> 0 <= t0 ->
  x t0 = X 0 -> v1 t0 = V1 0 -> v2 t0 = V2 0 ->
  forall u, 0 <= u <= T -> x (t0 + u) = X u /\ v1 (t0 + u) = V1 u /\ v2 (t0 + u) = V2 u.
Proof.
  intros H A Ht E0 E1 E2 u Hu. pose proof (shift_solution m1 m2 0 a2 b x v1 v2 s t0 Ht H) as Sh.
  apply (follow0 _ _ _ _ _ _ _ _ _ Sh A); auto; rewrite Rplus_0_r; auto.
Qed.

(** The mirror image of a solution is a solution. *)
Lemma cont_opp f : cont f -> cont (fun t => - f t).
Proof. intros C. apply cont_ext with (fun t => -1 * f t); [intros; ring|apply cont_scal; auto]. Qed.
(** the right derivative of the opposite *)
Lemma rderiv_opp f t l : rderiv f t l -> rderiv (fun t => - f t) t (- l).
Proof. intros F. apply rderiv_ext with (fun t => -1 * f t); [intros; ring|].
  apply rderiv_eq with (-1 * l); [ring|]. apply rderiv_scal; auto. Qed.
(** all terms are odd *)
Lemma mirror x v1 v2 s : solution m1 m2 0 a2 b x v1 v2 s ->
  solution m1 m2 0 a2 b (fun t => - x t) (fun t => - v1 t) (fun t => - v2 t) (fun t => - s t).
Proof.
  intros [L P N CX CV X V W]. constructor; auto using cont_opp.
  - intros r t Hr. replace (- s t - - s r) with (- (s t - s r)) by ring. rewrite Rabs_Ropp; auto.
  - intros t Ht Hv. apply rderiv_eq with (- -1); [ring|]. apply rderiv_opp, N; lra.
  - intros t Ht Hv. apply rderiv_opp, P; lra.
  - intros t Ht. apply rderiv_opp; auto.
  - intros t Ht. apply rderiv_ext with (fun u => - (m1 * v1 u + b * s u)); [intros; ring|].
    apply rderiv_eq with (- - (a2 * x t + 0 * v1 t)); [ring|]. apply rderiv_opp; auto.
  - intros t Ht. specialize (W t Ht). lra.
Qed.
End Arc.
