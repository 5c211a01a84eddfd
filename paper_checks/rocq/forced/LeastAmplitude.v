(** The bound on an arrival in the least time is sharp, whatever the damping: the least amplitude is b + beta
    tau/g(tau), g body 1's response to a unit impulse, if g does not fall on [0, tau]; without damping b + m1 beta
    theta/sin theta, theta = om1 tau <= pi/2. The force is F until tau: body 1 runs ahead with the speed beta tau
    g(t)/g(tau), and is met at tau. From then on the force may be -F, and body 1 falls behind; or, where F allows it,
    the pair sticks at the limit, and both bodies come to rest. *)
From InertialPair Require Import Forced Arcs Nonstop NonstopUndamped LeastTimeTransfer.

Lemma rises f f' p q : p <= q -> (forall t, is_derive f t (f' t)) -> (forall t, p <= t <= q -> 0 <= f' t) -> f p <= f q.
Proof.
  intros Hp D P. destruct (Req_dec p q) as [->|N]; [lra|].
  destruct (mean_value f f' p q) as (c & Hc & E); [lra|auto|].
  specialize (P c ltac:(lra)). assert (0 <= f' c * (q - p)) by positive. lra.
Qed.

Section Arrival.
Context (m1 m2 a1 a2 b D : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (HD : 0 < D).
Let tau := half_time m2 b D.
Let be := b / m2.
(** from rest, under a force of size F at most, body 2 is at rest at the distance D after the least time,
  and body 1 has the speed v *)
Definition arrives F v := exists U x v1 v2 s x2, (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r)) /\
  forced m1 m2 a1 a2 b U x v1 v2 s /\ cont x2 /\ (forall t, 0 <= t -> rderiv x2 t (v2 t)) /\
  x 0 = 0 /\ v1 0 = 0 /\ v2 0 = 0 /\ x2 0 = 0 /\ x2 (2 * half_time m2 b D) = D /\ v2 (2 * half_time m2 b D) = 0 /\
  v1 (2 * half_time m2 b D) = v.

(** body 1's response to a unit impulse, which does not fall up to tau *)
Variables g g' : R -> R.
Hypotheses (Dg : forall t, is_derive g t (g' t)) (Dg' : forall t, is_derive g' t (- (a2 * g t + a1 * g' t) / m1))
  (G0 : g 0 = 0) (G0' : g' 0 = / m1) (Gp : forall t, 0 <= t <= half_time m2 b D ->
    0 <= g' t) (Gt : 0 < g (half_time m2 b D)).

(** the place reached under a unit push, and the response to a unit displacement *)
Let k t := (1 - m1 * g' t - a1 * g t) / a2.
Let c t := m1 * g' t + a1 * g t.
(** the speed at tau is shared out by the response *)
Let A := be * tau / g tau.
Let Fm := b + A.

(** the place reached grows at the response *)
Lemma derive_k t : is_derive k t (g t).
Proof. unfold k. derive. field. lra. Qed.
(** what is left of a displacement falls at the response *)
Lemma derive_c t : is_derive c t (- a2 * g t).
Proof. unfold c. derive. field. lra. Qed.

Lemma signs : 0 < tau /\ 0 < be /\ 0 < A.
Proof.
  pose proof (tau_pos m2 b D Hm2 Hb HD) as T. pose proof (be_pos m2 b Hm2 Hb) as B. fold be in B. fold tau in T, Gt.
  repeat split; auto. apply Rdiv_lt_0_compat; auto. positive.
Qed.
(** the response grows *)
Lemma g_pos t : 0 <= t <= tau -> 0 <= g t.
Proof. intros Ht. rewrite <- G0. apply (rises g g'); auto; [lra|]. intros r Hr. apply Gp. fold tau. lra. Qed.
(** ever more slowly *)
Lemma g'_falls p q : 0 <= p <= q -> q <= tau -> g' q <= g' p.
Proof.
  intros Hp Hq. cut (- g' p <= - g' q); [lra|].
  apply (rises (fun t => - g' t) (fun t => (a2 * g t + a1 * g' t) / m1)); [lra| |].
  - intros t. derive. field. lra.
  - intros t Ht. pose proof (g_pos t ltac:(lra)). pose proof (Gp t ltac:(fold tau; lra)).
    apply Rmult_le_pos; [|positive]. assert (0 <= a2 * g t) by positive. assert (0 <= a1 * g' t) by positive. lra.
Qed.
Lemma g_chord t : 0 <= t <= tau -> t * g tau <= tau * g t.
Proof.
  intros Ht. apply (chord_below g g'); auto. intros. apply g'_falls; auto.
Qed.
(** a unit displacement springs back *)
Lemma c_below t : 0 <= t <= tau -> c t <= 1.
Proof.
  intros Ht. assert (C0 : c 0 = 1) by (unfold c; rewrite G0, G0'; field; lra). rewrite <- C0. cut (- c 0 <= - c t);
    [lra|].
  apply (rises (fun t => - c t) (fun t => a2 * g t)); [lra| |].
  - intros r. replace (a2 * g r) with (opp (- a2 * g r)) by (unfold opp; simpl; ring). apply (is_derive_opp c),
    derive_c.
  - intros r Hr. apply Rmult_le_pos; [lra|apply g_pos; lra].
Qed.
(** the threshold is above the load that breaks adhesion *)
Lemma A_above : m1 * be <= A.
Proof.
  destruct signs as (Tp & Bp & Ap). fold tau in Gt. assert (g tau <= tau / m1).
  { destruct (mean_value g g' 0 tau Tp Dg) as (p & Hp & E).
    rewrite G0, !Rminus_0_r in E. pose proof (g'_falls 0 p ltac:(lra) ltac:(lra)) as F. rewrite G0' in F. rewrite E.
    replace (tau / m1) with (/ m1 * tau) by (field; lra). scale. }
  unfold A. undivide (g tau).
  replace (be * tau) with (m1 * be * (tau / m1)) by (field; lra). apply Rmult_le_compat_l; [nra|auto].
Qed.
Lemma A_meet : A * g tau = be * tau.
Proof. fold tau in Gt. unfold A. field. lra. Qed.

(** the first half, and any second half in which body 2 is slowed down all the time *)
Lemma halves F U2 u2 X' V' : Fm <= F -> U2 0 = 0 -> (forall r t, 0 <= r <= t -> Rabs (U2 t - U2 r) <= F * (t - r)) ->
  (forall t, 0 <= t < tau -> rderiv U2 t (u2 t)) ->
  forced_arc m1 m2 a1 a2 b tau u2 X' V' (fun t => be * (tau - t)) (fun _ => -1) -> X' 0 = A * k tau ->
    V' 0 = be * tau ->
  arrives F (V' tau).
Proof.
  intros HF U20 LU2 DU2 A2 EX EV. destruct signs as (Tp & Bp & Ap). pose proof A_above as Ab.
    assert (F0 : 0 < Fm) by positive.
  set (U := join tau (fun t => Fm * t) (fun t => Fm * tau + U2 t)).
  assert (J : Fm * tau = Fm * tau + U2 0) by (rewrite U20; ring).
  assert (LU : forall r t, 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r)).
  { intros r t. apply lip_join; auto; [lra| |]; intros p q Hp.
    - intros _. apply Rabs_le. split; nra.
    - replace (Fm * tau + U2 q - (Fm * tau + U2 p)) with (U2 q - U2 p) by ring. auto. }
  assert (CU : cont U) by (apply (lip_cont U F); [lra|auto]).
  assert (D1 : forall t, 0 <= t < tau -> rderiv U t Fm) by (intros; apply rderiv_join_before; [auto|lra|rate; ring]).
  assert (D2 : forall t, tau <= t < tau + tau -> rderiv U t (u2 (t - tau))).
  { intros t Ht. apply rderiv_join_after; [lra|]. pose proof (DU2 (t - tau) ltac:(lra)). rate. ring. }
  assert (A1 : forced_arc m1 m2 a1 a2 b tau (fun _ => Fm) (fun t => A * k t) (fun t => A * g t) (fun t => be * t)
    (fun _ => 1)).
  { apply slip_arc; auto.
    - intros t. apply (is_derive_scal k t A (g t)), derive_k.
    - intros t. replace ((Fm - a2 * (A * k t) - a1 * (A * g t) - b * 1) / m1) with (A * g' t)
      by (unfold Fm, k; field; lra).
      apply (is_derive_scal g t A (g' t)), Dg.
    - intros t. auto_derive; auto. unfold be. field; lra.
    - intros t Ht. pose proof (g_chord t ltac:(lra)). fold tau in Gt. cut (be * t <= A * g t); [lra|].
      apply Rmult_le_reg_r with (g tau); auto. replace (A * g t * g tau) with (be * (tau * g t))
        by (rewrite <- Rmult_assoc, <- A_meet; ring). rewrite Rmult_assoc. scale. }
  destruct (arc_begins m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U (fun _ => Fm) _ _ _ _ tau ltac:(lra) CU D1 A1) as (x & v1 &
    v2 & s & H & E).
  destruct (E 0 ltac:(lra)) as (X0 & V0 & W0). destruct (E tau ltac:(lra)) as (XT & VT & WT).
  assert (E2 : forall t, 0 <= t <= tau -> v1 (tau + t) = V' t /\ v2 (tau + t) = be * (tau - t)).
  { intros t Ht. apply (follow_arc m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u2 x v1 v2 s X' V' (fun t => be * (tau - t))
    (fun _ => -1) tau tau); auto; try lra. rewrite VT, EV. apply A_meet. }
  pose proof (moves_cv2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H) as Cv2. unfold arrives. fold tau.
  exists U, x, v1, v2, s, (integral v2). split; [auto|]. split; [auto|].
  split; [apply integral_cont; auto|]. split; [intros t Ht; apply integral_rderiv; auto|].
  split; [rewrite X0; unfold k; rewrite G0, G0'; field; lra|]. split; [rewrite V0, G0; ring|]. split; [rewrite W0;
    ring|].
  split; [apply integral_0|]. destruct (E2 tau ltac:(lra)) as (V2T & W2T). replace (2 * tau) with (tau + tau) by ring.
  split; [|split; [rewrite W2T; ring|auto]]. pose proof (tau_sq m2 b D Hm2 Hb HD) as T2. fold tau be in T2.
  assert (Gain : integral v2 tau + integral v2 (tau + tau) - (integral v2 0 + integral v2 (tau + 0))
    = be * tau * (tau - 0)).
  { apply (rderiv_line (fun t => integral v2 t + integral v2 (tau + t))); [continuous|lra|]. intros t Ht.
    destruct (E t ltac:(lra)) as (_ & _ & Q), (E2 t ltac:(lra)) as (_ & Q').
    apply rderiv_eq with (v2 t + v2 (tau + t)); [rewrite Q, Q'; ring|].
    apply rderiv_plus; [|apply rderiv_earlier]; apply integral_rderiv; auto; lra. }
  rewrite integral_0, Rplus_0_r in Gain. lra.
Qed.

(** enough: the force pulls in the second half, and body 1 falls behind *)
Lemma arrival_attained F : Fm <= F -> exists v, arrives F v.
Proof.
  intros HF. destruct signs as (Tp & Bp & Ap). pose proof A_above as Ab. assert (F0 : 0 < Fm) by positive.
    fold tau in Gt.
  set (X' := fun t => A * k tau * c t + m1 * (be * tau) * g t - A * k t).
  set (V' := fun t => A * k tau * (- a2 * g t) + m1 * (be * tau) * g' t - A * g t).
  exists (V' tau). apply (halves F (fun t => - Fm * t) (fun _ => - Fm) X' V'); auto; try ring.
  - intros r t Hr. replace (- Fm * t - - Fm * r) with (- (Fm * (t - r))) by ring.
    rewrite Rabs_Ropp, Rabs_pos_eq by positive. scale.
  - intros t Ht. apply rderiv_of_derive. auto_derive; auto. ring.
  - apply slip_arc; auto.
    + intros t. unfold X', V', c, k. derive. field. lra.
    + intros t. unfold X', V', Fm, c, k. derive. field. lra.
    + intros t. auto_derive; auto. unfold be. field; lra.
    + intros t Ht. pose proof (g_chord t ltac:(lra)) as C.
      pose proof (c_below t ltac:(lra)) as Cb. pose proof (g_pos t ltac:(lra)) as Gn.
      pose proof (g'_falls 0 tau ltac:(lra) ltac:(lra)) as Gf. rewrite G0' in Gf.
      assert (M1 : m1 * g' tau <= 1) by (replace 1 with (m1 * / m1) by (field; lra); apply Rmult_le_compat_l; lra).
      assert (EV : V' t = A * (g tau * c t + m1 * g' tau * g t - 2 * g t)).
      { unfold V'. rewrite <- A_meet. unfold c, k. field. lra. }
      assert (S1 : g tau * c t <= g tau * 1) by scale. assert (S2 : m1 * g' tau * g t <= 1 * g t) by scale.
      assert (S3 : A * (g tau * c t + m1 * g' tau * g t - 2 * g t) <= A * (g tau - g t)) by scale.
      assert (S4 : A * (g tau - g t) <= be * (tau - t)); [|lra]. apply Rmult_le_reg_r with tau; auto.
      replace (be * (tau - t) * tau) with (A * (g tau * (tau - t))) by (rewrite <- Rmult_assoc, A_meet; ring).
      rewrite Rmult_assoc. scale.
  - unfold X', c, k. rewrite G0, G0'. field; lra.
  - unfold V'. rewrite G0, G0'. field; lra.
Qed.

(** [least-amplitude] To bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, takes exactly
    $b+\beta\tau/g(\tau)$, where $g'\geqslant 0$ up to $\tau$. *)
Theorem least_amplitude F : (exists v, arrives F v) <-> b + b / m2 * half_time m2 b D / g (half_time m2 b D) <= F.
Proof.
  split; [|apply arrival_attained].
  intros (v & U' & x & v1 & v2 & s & x2 & LU & H & C & R & X0 & V0 & W0 & Y0 & YT & WT & _).
  apply (arrival_needs m1 m2 a1 a2 b D Hm1 Hm2 Hb HD g g' U' x v1 v2 s x2 F); auto. lra.
Qed.

(** [rest-to-rest] With that amplitude both bodies can be at rest then, if the stuck pair can brake with it in the
    second half. *)
Theorem rest_to_rest F : b + b / m2 * half_time m2 b D / g (half_time m2 b D) <= F ->
  (forall t, 0 <= t <= half_time m2 b D ->
    b / m2 * half_time m2 b D / g (half_time m2 b D) * (1 - m1 * g' (half_time m2 b D) - a1 * g (half_time m2 b D))
    + a2 * (b / m2 * (half_time m2 b D * t - t ^ 2 / 2)) + a1 * (b / m2 * (half_time m2 b D - t)) - (m1 + m2) * (b /
      m2) <= F) ->
  arrives F 0.
Proof.
  intros HF Peak. fold tau be A in HF, Peak. fold Fm in HF. destruct signs as (Tp & Bp & Ap). pose proof A_above as Ab.
  set (xt := A * k tau). assert (Ex : a2 * xt = A * (1 - m1 * g' tau - a1 * g tau)) by (unfold xt, k; field; lra).
  assert (Xp : 0 <= a2 * xt).
  { rewrite Ex. apply Rmult_le_pos; [lra|]. pose proof (c_below tau ltac:(lra)) as C. unfold c in C. lra. }
  assert (Eb : (m1 + m2) * be = m1 * be + b) by (unfold be; field; lra).
  set (X' := fun t => xt + be * (tau * t - t ^ 2 / 2)). set (V' := fun t => be * (tau - t)).
  set (u2 := fun t => a2 * X' t + a1 * V' t - (m1 + m2) * be).
  set (I := fun t => (a2 * xt - (m1 + m2) * be) * t + a2 * be * (tau * t ^ 2 / 2 - t ^ 3 / 6) + a1 * be * (tau * t - t
    ^ 2 / 2)).
  assert (DI : forall t, is_derive I t (u2 t)).
  { intros t. unfold I, u2, X', V'. auto_derive; auto. field. }
  assert (CI : cont I) by exact (cont_of_derive I _ DI). assert (B2 : forall t, 0 <= t <= tau -> - F <= u2 t <= F).
  { intros t Ht. assert (Q0 : 0 <= tau * t - t ^ 2 / 2) by nra.
    assert (Q1 : 0 <= a2 * (be * (tau * t - t ^ 2 / 2))) by positive.
    assert (Q2 : 0 <= a1 * (be * (tau - t))) by positive.
    specialize (Peak t Ht). unfold u2, X', V'. rewrite Rmult_plus_distr_l, Eb. unfold Fm in HF. rewrite <- Ex,
      Eb in Peak. lra. }
  assert (F0 : 0 <= F) by (unfold Fm in HF; lra).
  replace 0 with (V' tau) by (unfold V'; ring). apply (halves F (fun t => I (Rmin t tau)) u2 X' V' HF).
  - rewrite Rmin_left by lra. unfold I. field.
  - intros r t Hr. assert (Mn : 0 <= Rmin r tau <= Rmin t tau) by (unfold Rmin; repeat destruct Rle_dec; lra).
    assert (Rmin t tau - Rmin r tau <= t - r) by (unfold Rmin; repeat destruct Rle_dec; lra).
    eapply Rle_trans; [apply (lip_between I u2 F); auto|scale].
    intros q Hq. split; [apply rderiv_of_derive, DI|]. apply B2. pose proof (Rmin_r t tau). lra.
  - intros t Ht. apply rderiv_near with I (tau - t); [lra|intros r Hr; rewrite Rmin_left; auto;
    lra|apply rderiv_of_derive, DI].
  - apply slip_arc; auto.
    + intros t. unfold X', V'. auto_derive; auto. field.
    + intros t. unfold V' at 1. auto_derive; auto. unfold u2. rewrite Eb. field; lra.
    + intros t. auto_derive; auto. unfold be. field; lra.
    + intros t Ht. unfold V'. lra.
  - unfold X'. fold xt. field.
  - unfold V'. ring.
Qed.
End Arrival.

(** [least-amplitude-undamped] $a_1=0$, $\theta=\omega_1\tau\leqslant\pi/2$: to bring body 2 to rest at $D$ in the
    least time, from rest with $x_1=0$, takes exactly $b+m_1\beta\,\theta/\sin\theta$. *)
Corollary least_amplitude_undamped m1 m2 a2 b D F : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < D ->
  let th := sqrt (a2 / m1) * half_time m2 b D in th <= PI / 2 ->
  (exists v, arrives m1 m2 0 a2 b D F v) <-> b + m1 * (b / m2) * th / sin th <= F.
Proof.
  intros Hm1 Hm2 Ha2 Hb HD th Hth. pose proof (own_sq m1 a2 Hm1 Ha2) as O2. pose proof (own_pos m1 a2 Hm1 Ha2) as O.
  pose proof (tau_pos m2 b D Hm2 Hb HD) as T. set (o := sqrt (a2 / m1)) in *. set (tau := half_time m2 b D) in *.
  assert (Th : 0 < th) by (unfold th; apply Rmult_lt_0_compat; auto). pose proof PI_RGT_0.
  assert (Sp : 0 < sin th) by (apply sin_gt_0; lra). assert (Et : th = o * tau) by reflexivity.
  pose proof (least_amplitude m1 m2 0 a2 b D Hm1 Hm2 (Rle_refl 0) Ha2 Hb HD (fun t => sin (o * t) / (m1 * o)) (fun t
    => cos (o * t) / m1)) as Q.
  fold tau in Q. cbv beta in Q. rewrite <- Et in Q.
  replace (b + m1 * (b / m2) * th / sin th) with (b + b / m2 * tau / (sin th / (m1 * o))) by (rewrite Et at 2; field;
    lra). apply Q.
  - intros t. auto_derive; auto. field; lra.
  - intros t. auto_derive; auto. rewrite <- O2. field; lra.
  - rewrite Rmult_0_r, sin_0. field; lra.
  - rewrite Rmult_0_r, cos_0. field; lra.
  - intros t Ht. assert (0 <= o * t <= th) by (rewrite Et; split; [apply Rmult_le_pos|apply Rmult_le_compat_l]; lra).
    apply Rmult_le_pos; [apply cos_ge_0; lra|]. positive.
  - positive.
Qed.
