(** A pair turned back by the angle Omega t of its common oscillation: in this frame it moves only by slip, and slip is
    paid for. So where the energy pays and the slip vanishes, it tends to an oscillation that sticks. This is of a motion as
    of the difference of two motions under one force. *)
From InertialPair Require Import Dini PaidRates Pair Stick Pursuit.

Section Turned.
Context (m1 m2 a2 c : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hc : 0 < c).
Variables x v1 v2 : R -> R.
Let M := m1 + m2.
Let om := omega m1 m2 a2.
Let w t := v1 t - v2 t.
Let P t := m1 * v1 t + m2 * v2 t.
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Let kap := m2 / (M * c).
Hypotheses (Cx : cont x) (C1 : cont v1) (C2 : cont v2) (Dx : forall t, 0 <= t -> rderiv x t (v1 t))
  (DP : forall t, 0 <= t -> rderiv P t (- a2 * x t)) (Pays : forall t, 0 <= t -> dini_le E t (- (c * Rabs (w t)))).

(** the place in the frame that turns with the pair, from a phase on *)
Definition turned phi t := x t * cos (omega m1 m2 a2 * t + phi) -
  (m1 * v1 t + m2 * v2 t) / ((m1 + m2) * omega m1 m2 a2) * sin (omega m1 m2 a2 * t + phi).

Let om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2.
Let Ma : a2 = M * (om * om).
Proof. unfold om, M. rewrite omega_sq by auto. field. lra. Qed.
Let kap_pos : 0 < kap. Proof. unfold kap, M. positive. Qed.
Let Cw : cont w. Proof. apply cont_minus; auto. Qed.

Let cont_E : cont E. Proof. apply energy_cont; auto. Qed.
Let E_mono r t : 0 <= r <= t -> E t <= E r.
Proof.
  intros Hr. apply dini_mono; auto. intros u Hu. apply dini_weaken with (2 := Pays u ltac:(lra)).
  assert (0 <= c * Rabs (w u)) by positive. lra.
Qed.

(** at any phase by two of them *)
Lemma turned_phase phi t : turned phi t = turned 0 t * cos phi - turned (- (PI / 2)) t * sin phi.
Proof.
  unfold turned. rewrite Rplus_0_r, !cos_plus, !sin_plus, cos_neg, sin_neg, cos_PI2, sin_PI2. ring.
Qed.

(** it changes only by slip *)
Lemma turned_rate phi t : 0 <= t -> rderiv (turned phi) t (m2 / M * w t * cos (om * t + phi)).
Proof.
  intros Ht. apply rderiv_ext with (fun u => x u * cos (om * u + phi) - / (M * om) * (P u * sin (om * u + phi))).
  { intros; unfold turned. fold om M. unfold P. field. unfold M. lra. }
  eapply rderiv_eq; [|apply rderiv_minus; [apply rderiv_mult; [apply Dx, Ht|]|apply rderiv_scal,
    rderiv_mult; [apply DP, Ht|]]; apply rderiv_of_derive; auto_derive; auto; reflexivity].
  unfold w, P. rewrite Ma. unfold M. field. lra.
Qed.

(** and the energy pays for every change of it *)
Lemma paid phi r t : 0 <= r <= t -> Rabs (turned phi t - turned phi r) <= kap * (E r - E t).
Proof.
  intros Hr. assert (Ct : cont (turned phi)).
  { apply cont_minus; apply cont_mult; auto; [| |].
    - apply cont_of_derive with (fun t => - om * sin (om * t + phi)). intros u; unfold om; auto_derive; auto. ring.
    - apply cont_ext with (fun u => / (M * om) * P u); [intros; unfold P, Rdiv; fold M om; ring|].
      apply cont_scal, cont_plus; apply cont_scal; auto.
    - apply cont_of_derive with (fun t => om * cos (om * t + phi)). intros u; unfold om; auto_derive; auto. ring. }
  apply abs_by. intros k Hk. cut (kap * E t + k * turned phi t <= kap * E r + k * turned phi r); [lra|].
  apply (dini_mono (fun u => kap * E u + k * turned phi u)); auto using cont_plus, cont_scal. intros u Hu.
  eapply dini_weaken; [|exact (dini_plus _ _ _ _ _ (dini_scal kap _ _ _ kap_pos (Pays u ltac:(lra)))
    (rderiv_scal k _ _ _ (turned_rate phi u ltac:(lra))))].
  replace (kap * - (c * Rabs (w u))) with (- (m2 / M * Rabs (w u))) by (unfold kap, M; field; repeat split; lra).
  assert (k * (w u * cos (om * u + phi)) <= Rabs (w u)).
  { pose proof (COS_bound (om * u + phi)). unfold Rabs; destruct Rcase_abs; destruct Hk; subst k; nra. }
  assert (0 < m2 / M) by (unfold M; positive). nra.
Qed.

(** the energy beside an oscillation that sticks *)
Lemma energy_beside a d t : energy m1 m2 a2 (x t - X m1 m2 a2 a (om * d) t) (v1 t - V m1 m2 a2 a (om * d) t)
    (v2 t - V m1 m2 a2 a (om * d) t)
  = a2 / 2 * ((turned 0 t - a) ^ 2 + (turned (- (PI / 2)) t - d) ^ 2) + m1 * m2 / (2 * M) * w t ^ 2.
Proof.
  unfold turned. fold om M. fold (P t). rewrite Rplus_0_r.
  replace (om * t + - (PI / 2)) with (- (PI / 2 - om * t)) by ring. rewrite cos_neg, sin_neg, cos_shift, sin_shift.
  unfold X, V. fold om. pose proof (sin2_cos2 (om * t)) as SC. unfold Rsqr in SC.
  replace (x t - (a * cos (om * t) + om * d / om * sin (om * t)))
    with (x t - (a * cos (om * t) + d * sin (om * t))) by (field; lra). set (co := cos (om * t)) in *.
  set (si := sin (om * t)) in *. set (p := P t / (M * om)). set (f1 := x t - (a * co + d * si)).
  set (f2 := p - (d * co - a * si)).
  replace (x t * co - p * si - a) with (f1 * co - f2 * si + a * (si * si + co * co - 1)) by (unfold f1, f2; ring).
  replace (x t * si - p * - co - d) with (f1 * si + f2 * co + d * (si * si + co * co - 1)) by (unfold f1, f2; ring).
  rewrite SC. replace ((f1 * co - f2 * si + a * (1 - 1)) ^ 2 + (f1 * si + f2 * co + d * (1 - 1)) ^ 2) with
    ((f1 ^ 2 + f2 ^ 2) * (si * si + co * co)) by ring. rewrite SC. unfold energy, f2, p. rewrite Ma. unfold w, P, M.
  field. lra.
Qed.

(** as the energy by itself *)
Lemma energy_turned t : E t = a2 / 2 * (turned 0 t ^ 2 + turned (- (PI / 2)) t ^ 2) + m1 * m2 / (2 * M) * w t ^ 2.
Proof.
  pose proof (energy_beside 0 0 t) as Q. rewrite !Rminus_0_r in Q. rewrite <- Q. unfold E, X, V. fold om.
  f_equal; field; lra.
Qed.

(** a slip whose velocity cannot jump vanishes *)
Lemma slip_vanishes K : 0 < K -> (forall r t, 0 <= r <= t -> Rabs (w t - w r) <= K * (t - r)) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (w t) <= e.
Proof.
  intros HK Lw. set (J := integral (fun t => Rabs (w t))). pose proof (cont_abs _ Cw) as Ca.
  apply (paid_vanishes E c (fun t _ => energy_pos m1 m2 a2 Hm1 Hm2 Ha2 _ _ _) E_mono Hc (fun t => Rabs (w t)) J K);
    auto.
  - apply integral_cont, Ca.
  - intros t Ht. split; [apply Rabs_pos|apply (integral_rderiv _ t Ca Ht)].
  - intros r t Hr. eapply Rle_trans; [apply Rabs_triang_inv2|auto].
  - intros r t. apply (path_paid E c (fun t => Rabs (w t))); auto.
Qed.

(** where it vanishes, there is one oscillation to which the pair tends, and its energy is the limit *)
Theorem tends : (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (w t) <= e) -> exists x0 v0,
  (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x t - X m1 m2 a2 x0 v0 t) (v1 t - V m1 m2 a2 x0 v0 t) (v2 t - V m1 m2 a2 x0 v0 t) <= e) /\
  forall l, (forall t, 0 <= t -> l <= E t) -> (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> E t <= l + e) ->
    energy m1 m2 a2 x0 v0 v0 = l.
Proof.
  intros Vw. destruct (dec_limit E E_mono ltac:(intros; apply energy_pos; auto)) as (l & _ & Below & Lim).
  assert (Li : forall f g, (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (f t - g) <= e) -> is_lim f
    p_infty g).
  { intros f g Q. apply is_lim_spec. intros e. destruct (Q (e / 2)) as (T & _ & K); [pose proof (cond_pos e); lra|].
    exists T. intros t Ht. specialize (K t ltac:(lra)). pose proof (cond_pos e). lra. }
  assert (LE : forall l, (forall t, 0 <= t -> l <= E t) -> (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> E
    t <= l + e) -> is_lim E p_infty l).
  { intros l' B Q. apply Li. intros e He. destruct (Q e He) as (T & HT & K). exists T. split; auto. intros t Ht.
    specialize (K t Ht). specialize (B t ltac:(lra)). apply Rabs_le. lra. }
  assert (LT : forall phi, exists g : R, is_lim (turned phi) p_infty g).
  { intros phi. destruct (paid_limit E (turned phi) kap l (Rlt_le _ _ kap_pos) Below (paid phi)) as (g & Ng). exists g.
    apply Li. intros e He. destruct (Lim (e / kap)) as (T & HT & K); [positive|]. exists T. split; auto. intros t Ht.
    specialize (K t Ht). eapply Rle_trans; [apply Ng; lra|]. replace e with (kap * (e / kap)) by (field; lra).
    apply Rmult_le_compat_l; lra. }
  assert (Lw : is_lim w p_infty 0) by (apply Li; intros e He; destruct (Vw e He) as (T & HT & K); exists T; split; auto;
    intros t Ht; rewrite Rminus_0_r; auto).
  destruct (LT 0) as (a & La). destruct (LT (- (PI / 2))) as (d & Ld). exists a, (om * d).
  assert (Lq : forall a' d', is_lim (fun t => a2 / 2 * ((turned 0 t - a') ^ 2 + (turned (- (PI / 2)) t - d') ^ 2)
    + m1 * m2 / (2 * M) * w t ^ 2) p_infty (a2 / 2 * ((a - a') ^ 2 + (d - d') ^ 2))).
  { intros a' d'.
    assert (S : forall f (g g' : R), is_lim f p_infty g ->
      is_lim (fun t => (f t - g') ^ 2) p_infty ((g - g') ^ 2)).
    { intros f g g' Lf. apply (is_lim_comp_continuous f (fun y => (y - g') ^ 2)); auto.
      apply @ex_derive_continuous. auto_derive; auto. }
    replace (Finite (a2 / 2 * ((a - a') ^ 2 + (d - d') ^ 2))) with
      (Finite (a2 / 2 * ((a - a') ^ 2 + (d - d') ^ 2) + m1 * m2 / (2 * M) * (0 - 0) ^ 2)) by (f_equal; ring).
    apply is_lim_plus'; [apply (is_lim_scal_l _ (a2 / 2) p_infty ((a - a') ^ 2 + (d - d') ^ 2)), is_lim_plus'; apply S;
      auto|]. apply (is_lim_ext (fun t => m1 * m2 / (2 * M) * (w t - 0) ^ 2)); [intros; rewrite Rminus_0_r; auto|].
    apply (is_lim_scal_l _ (m1 * m2 / (2 * M)) p_infty ((0 - 0) ^ 2)), S, Lw. }
  split.
  - intros e He. pose proof (Lq a d) as Q. rewrite !Rminus_diag_eq in Q by auto. apply is_lim_spec in Q.
    destruct (Q (mkposreal e He)) as (T & K). exists (Rmax 0 (T + 1)). pose proof (Rmax_l 0 (T + 1)).
    pose proof (Rmax_r 0 (T + 1)). split; auto. intros t Ht. rewrite energy_beside. specialize (K t ltac:(lra)).
    simpl pos in K. apply Rabs_def2 in K. lra.
  - intros l' B Q. assert (El : Finite (a2 / 2 * ((a - 0) ^ 2 + (d - 0) ^ 2)) = Finite l').
    { rewrite <- (is_lim_unique _ _ _ (LE l' B Q)), <- (is_lim_unique _ _ _ (Lq 0 0)). apply Lim_ext. intros t.
      rewrite !Rminus_0_r. apply energy_turned. }
    injection El as El. rewrite <- El. unfold energy. rewrite Ma. unfold M. field.
Qed.
End Turned.
