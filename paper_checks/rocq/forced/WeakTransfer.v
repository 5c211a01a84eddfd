(** Transfers under a weak force without a damper: within half a turn no force of at most F, 3 F <= b M/m2, breaks the
    pair, and two arcs, under F and then under -F, bring it to rest at D before any other one does. Each force is tested
    with a sine that has its sign on both arcs. *)
From InertialPair Require Import Stick Forced Arcs LeastTimeTransfer.

Section Weak.
Variables m1 m2 a2 b F : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (HF : 0 < F) (Weak : 3 * F <= b * (m1 + m2) / m2).
Let M := m1 + m2.
Let om := omega m1 m2 a2.
Let om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2.
Let a2_om : a2 = M * (om * om).
Proof. unfold om, M. rewrite (omega_sq m1 m2 a2) by auto. field. lra. Qed.

(** the cosines of the angles of both arcs *)
Lemma arc_cosines xi : 0 < xi <= 1 -> let c1 := 1 - xi / 2 - xi ^ 2 / 4 in
  let c2 := (1 + xi / 2 + xi ^ 2 / 4) / (1 + xi) in 0 < c1 < 1 /\ 0 < c2 < 1 /\ (1 + xi) * c2 = 2 - c1.
Proof.
  intros Xi c1 c2. assert (E : (1 + xi) * c2 = 2 - c1) by (unfold c1, c2; field; lra).
  repeat split; auto; unfold c1, c2 in *; nra.
Qed.

Section Motion.
Variables U x v1 v2 s : R -> R.
Hypotheses (H : forced m1 m2 0 a2 b U x v1 v2 s) (LU : forall r t, 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r)).
Hypotheses (X0 : x 0 = 0) (V0 : v1 0 = 0) (W0 : v2 0 = 0).

(** what a stuck pair gains beside a sine, at most F times the integral of its size *)
Let gained be t := M * v1 t * sin (be - om * t) + M * om * x t * cos (be - om * t).
Lemma paired j k be r t : (j = 1 \/ j = -1) -> (k = 1 \/ k = -1) -> 0 <= r <= t -> (forall q, r <= q <= t -> v1 q = v2 q) ->
  (forall q, r <= q <= t -> 0 <= k * sin (be - om * q)) ->
  j * (gained be t - gained be r) <= F * (k * (cos (be - om * t) - cos (be - om * r))) / om.
Proof.
  intros Hj Hk Hr St Sg. apply Rle_trans with (F * (k * (cos (be - om * t) - cos (be - om * r)) / om));
    [|right; field; lra].
  assert (MP : 0 < M) by (unfold M; lra).
  pose proof (tested M 0 a2 0 (j * k) F U x v1 (fun q => k * sin (be - om * q))
    (fun q => - k * cos (be - om * q) / om) r t
    MP ltac:(destruct Hj, Hk; subst j k; lra) Hr ltac:(continuous) ltac:(continuous) ltac:(continuous) LU) as Q.
  cbv beta in Q.
  rewrite a2_om in Q. eapply Rle_trans; [|eapply Rle_trans; [apply Q|right; field; lra]].
  - right. unfold gained. destruct Hk; subst k; field; lra.
  - intros q Hq. split; [rates|]. rewrite <- a2_om. apply rderiv_eq with (- (a2 * x q + 0 * v1 q)); [ring|].
    apply (stuck_needs m1 m2 0 a2 b U x v1 v2 s q (t - q) H); try lra. intros u Hu. apply St. lra.
  - intros q. auto_derive; auto. unfold Rminus. field. lra.
  - intros q. auto_derive; auto. unfold Rminus. field. lra.
  - exact Sg.
Qed.

(** stuck so far, within half a turn: body 1 is not beyond 1 - cos *)
Lemma place_within t : 0 <= t -> om * t <= PI -> (forall q, 0 <= q <= t -> v1 q = v2 q) -> a2 * Rabs (x t) <= F * (1 - cos (om * t)).
Proof.
  intros Ht Hp St. assert (B : forall j, j = 1 \/ j = -1 -> j * (a2 * x t) <= F * (1 - cos (om * t))).
  { intros j Hj. pose proof (paired j 1 (om * t) 0 t Hj (or_introl eq_refl) ltac:(lra) St) as Q. unfold gained in Q.
    replace (om * t - om * t) with 0 in Q by ring. replace (om * t - om * 0) with (om * t) in Q by ring. rewrite X0, V0, sin_0, cos_0 in Q.
    assert (Sg : forall q, 0 <= q <= t -> 0 <= 1 * sin (om * t - om * q)).
    { intros q Hq. assert (0 <= om * (t - q)) by (apply Rmult_le_pos; lra). assert (om * (t - q) <= om * t) by scale.
      rewrite Rmult_1_l. apply sin_ge_0; lra. }
    specialize (Q Sg). apply (Rmult_le_compat_l om) in Q; [|lra].
    replace (om * (F * (1 * (1 - cos (om * t))) / om)) with (F * (1 - cos (om * t))) in Q by (field; lra). rewrite a2_om. lra. }
  pose proof (B 1 ltac:(auto)). pose proof (B (-1) ltac:(auto)). unfold Rabs. destruct Rcase_abs; lra.
Qed.

(** while body 1 is within 2 F/a2, friction holds the pair *)
Lemma held r t k : k = 1 \/ k = -1 -> 0 <= r <= t -> (forall q, r <= q < t -> a2 * Rabs (x q) <= 2 * F) ->
  k * (v1 r - v2 r) <= 0 -> k * (v1 t - v2 t) <= 0.
Proof.
  intros Hk Hr B W. apply (moves_behind m1 m2 0 a2 b Hm1 Hm2 _ _ _ _ _ _ H r t k); auto. intros q Hq. exists F. split.
  - intros g Hg. exists 1. split; [lra|]. intros h Hh. pose proof (LU q (q + h) ltac:(lra)) as L. apply Rabs_inv in L.
    replace (q + h - q) with h in L by ring. destruct Hk; subst k; nra.
  - specialize (B q Hq). pose proof (Rle_abs (x q)). pose proof (Rle_abs (- x q)) as N. rewrite Rabs_Ropp in N.
    assert (- k * (a2 * x q) <= 2 * F) by (destruct Hk; subst k; nra).
    apply Rle_trans with (m2 * (3 * F)); [apply Rmult_le_compat_l; lra|].
    replace (b * (m1 + m2)) with (m2 * (b * (m1 + m2) / m2)) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

(** [weak-sticks] From rest at $x_1=0$ no force of at most $F$, $3F\leqslant bM/m_2$, breaks the undamped pair within
    $\pi/\Omega$. *)
Theorem sticks_half_turn t : 0 <= t -> om * t <= PI -> v1 t = v2 t.
Proof.
  intros Ht Hp.
  assert (Zero : forall q, (forall k, k = 1 \/ k = -1 -> k * (v1 q - v2 q) <= 0) -> v1 q = v2 q).
  { intros q B. pose proof (B 1 ltac:(auto)). pose proof (B (-1) ltac:(auto)). lra. }
  cut (forall r, 0 <= r <= t -> v1 r = v2 r); [intros St; apply St; lra|].
  apply (onward (fun t => forall r, 0 <= r <= t -> v1 r = v2 r) 0 t); try lra.
  - intros r Hr. replace r with 0 by lra. lra.
  - intros q Hq St r Hr. destruct (Rlt_dec r q) as [Lt|]; [apply (St r ltac:(lra)); lra|]. replace r with q by lra.
    apply Zero. intros k Hk. apply (cont_le (fun q => k * (v1 q - v2 q)) 0 0 q); [continuous|lra|].
    intros p Hp'. rewrite (St p) by lra. lra.
  - intros q Hq St. assert (Oq : 0 <= om * q < om * t) by (split; [apply Rmult_le_pos|apply Rmult_lt_compat_l]; lra).
    assert (Lt : a2 * Rabs (x q) < 2 * F).
    { apply Rle_lt_trans with (1 := place_within q ltac:(lra) ltac:(lra) St). assert (-1 < cos (om * q)); [|nra].
      rewrite <- cos_PI. apply cos_decreasing_1; lra. }
    destruct (cont_abs _ (f_cx _ _ _ _ _ _ _ _ _ _ H) q ltac:(lra) (2 * F / a2 - Rabs (x q))) as (d & Hd & K).
    { apply Rlt_Rminus. undivide a2. lra. }
    exists d. split; auto. intros u Hu r Hr. destruct (Rle_dec r q) as [|N]; [apply St; lra|].
    apply Zero. intros k Hk. apply (held q r k Hk); [lra| |rewrite St; lra].
    intros p Hp'. specialize (K p ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)). apply Rabs_def2 in K.
    assert (Le : Rabs (x p) < 2 * F / a2) by lra. apply Rlt_div_r in Le; lra.
Qed.

(** *** The least time *)
(** [weak-takes] Under such forces, where $a_2D\leqslant F$, from rest at $x_1=0$ to rest at $D$ takes at least the
    time of two arcs, under $F$ and then under $-F$. *)
Theorem weak_takes T D : 0 < D -> a2 * D <= F -> 0 <= T -> x T = D -> v1 T = 0 -> let xi := a2 * D / F in
  (acos (1 - xi / 2 - xi ^ 2 / 4) + acos ((1 + xi / 2 + xi ^ 2 / 4) / (1 + xi))) / om <= T.
Proof.
  intros HD Hold HT XT VT xi. assert (Xi : 0 < xi <= 1) by (unfold xi; split; [positive|undivide F; lra]).
  assert (EX : a2 * D = xi * F) by (unfold xi; field; lra). pose proof PI_RGT_0.
  set (c1 := 1 - xi / 2 - xi ^ 2 / 4). set (c2 := (1 + xi / 2 + xi ^ 2 / 4) / (1 + xi)).
  destruct (arc_cosines xi Xi) as (C1 & C2 & Ec). fold c1 c2 in C1, C2, Ec.
  assert (Ac : forall c, 0 < c < 1 -> 0 < acos c < PI / 2 /\ cos (acos c) = c).
  { intros c Hc. pose proof (cos_acos c ltac:(lra)) as E. pose proof (acos_bound c) as B. split; [|exact E]. split.
    - destruct (Req_dec (acos c) 0) as [Z|]; [rewrite Z, cos_0 in E|]; lra.
    - apply Rnot_le_lt. intros N. pose proof (cos_le_0 (acos c) ltac:(lra) ltac:(lra)). lra. }
  destruct (Ac c1 C1) as (A1 & E1). destruct (Ac c2 C2) as (A2 & E2). set (al := acos c1) in *. set (be := acos c2) in *.
  undivide om. rewrite (Rmult_comm T). apply Rnot_lt_le. intros Early.
  assert (St : forall q, 0 <= q <= T -> v1 q = v2 q).
  { intros q Hq. apply sticks_half_turn; [lra|]. apply Rle_trans with (om * T); [scale|]; lra. }
  assert (Start : gained al 0 = 0) by (unfold gained; rewrite X0, V0; ring).
  assert (End : om * gained al T = xi * F * cos (al - om * T)) by (unfold gained; rewrite XT, VT, <- EX, a2_om; ring).
  assert (Sine : forall k r t, (k = 1 /\ om * t <= al) \/ (k = -1 /\ al <= om * r) -> 0 <= r <= t -> t <= T ->
    om * (gained al t - gained al r) <= F * (k * (cos (al - om * t) - cos (al - om * r)))).
  { intros k r t Side Hr Ht. pose proof (paired 1 k al r t (or_introl eq_refl) ltac:(tauto) Hr ltac:(intros; apply St; lra)) as Q.
    apply Rle_trans with (om * (F * (k * (cos (al - om * t) - cos (al - om * r))) / om)); [|right; field; lra].
    apply Rmult_le_compat_l; [lra|]. rewrite <- (Rmult_1_l (gained al t - gained al r)). apply Q. intros q Hq.
    assert (om * r <= om * q <= om * t) by (split; scale). assert (om * t <= om * T) by scale.
    assert (0 <= om * r) by (apply Rmult_le_pos; lra). destruct Side as [(-> & S)|(-> & S)].
    - rewrite Rmult_1_l. apply sin_ge_0; lra.
    - replace (-1 * sin (al - om * q)) with (sin (om * q - al)) by (rewrite <- (Ropp_minus_distr al), sin_neg; ring).
      apply sin_ge_0; lra. }
  destruct (Rle_dec (om * T) al) as [Short|Long].
  - pose proof (Sine 1 0 T ltac:(auto) ltac:(lra) ltac:(lra)) as Q. rewrite Start, Rminus_0_r, End in Q. replace (al - om * 0) with al in Q by ring. rewrite E1 in Q.
    pose proof (COS_bound (al - om * T)). assert (xi * cos (al - om * T) <= cos (al - om * T) - c1) by nra. unfold c1 in *. nra.
  - set (t1 := al / om). assert (T1 : om * t1 = al) by (unfold t1; field; lra).
    assert (Ht1 : 0 <= t1 <= T) by (split; [unfold t1; positive|apply Rmult_le_reg_l with om; lra]).
    pose proof (Sine 1 0 t1 ltac:(left; split; [auto|lra]) ltac:(lra) ltac:(lra)) as Q1.
    pose proof (Sine (-1) t1 T ltac:(right; split; [auto|lra]) ltac:(lra) ltac:(lra)) as Q2.
    rewrite T1 in Q1, Q2. replace (al - al) with 0 in Q1, Q2 by ring. replace (al - om * 0) with al in Q1 by ring.
    rewrite cos_0 in Q1, Q2. rewrite Start, E1 in Q1.
    rewrite Rmult_minus_distr_l, End in Q2. assert (Q : (1 + xi) * cos (al - om * T) <= 2 - c1).
    { apply Rmult_le_reg_l with F; auto. lra. }
    assert (cos (al - om * T) <= c2) by (unfold c2, c1 in *; undivide (1 + xi); lra).
    assert (c2 < cos (om * T - al)) by (rewrite <- E2; apply cos_decreasing_1; lra).
    replace (om * T - al) with (- (al - om * T)) in H2 by ring. rewrite cos_neg in H2. lra.
Qed.
End Motion.

(** [weak-attained] Both arcs are a motion, and the pair can then be held there. *)
Theorem weak_attained D : 0 < D -> a2 * D <= F -> let xi := a2 * D / F in
  let t1 := acos (1 - xi / 2 - xi ^ 2 / 4) / om in let t2 := acos ((1 + xi / 2 + xi ^ 2 / 4) / (1 + xi)) / om in
  exists U x v1 v2 s, forced m1 m2 0 a2 b U x v1 v2 s /\ (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r)) /\
  x 0 = 0 /\ v1 0 = 0 /\ v2 0 = 0 /\ (forall t, t1 + t2 <= t -> x t = D /\ v1 t = 0 /\ v2 t = 0) /\
  (forall t, 0 <= t < t1 -> rderiv U t F) /\ (forall t, t1 <= t < t1 + t2 -> rderiv U t (- F)).
Proof.
  intros HD Hold xi t1 t2. assert (Xi : 0 < xi <= 1) by (unfold xi; split; [positive|undivide F; lra]).
  set (c1 := 1 - xi / 2 - xi ^ 2 / 4) in *. set (c2 := (1 + xi / 2 + xi ^ 2 / 4) / (1 + xi)) in *.
  destruct (arc_cosines xi Xi) as (C1 & C2 & E2). fold c1 c2 in C1, C2, E2.
  set (R := F / a2). assert (HR : 0 < R) by (unfold R; positive). assert (DR : D = xi * R) by (unfold xi, R; field; lra).
  assert (FR : F = M * (om * om) * R) by (rewrite <- a2_om; unfold R; field; lra).
  assert (MP : 0 < M) by (unfold M; lra).
  set (al := acos c1) in *. set (be := acos c2) in *. assert (O1 : om * t1 = al) by (unfold t1; field; lra).
  assert (O2 : om * t2 = be) by (unfold t2; field; lra). pose proof (acos_bound c1 : 0 <= al <= PI).
  pose proof (acos_bound c2 : 0 <= be <= PI).
  assert (T1 : 0 <= t1) by (unfold t1; positive). assert (T2 : 0 <= t2) by (unfold t2; positive).
  assert (Cal : cos al = c1) by (apply cos_acos; lra). assert (Cbe : cos be = c2) by (apply cos_acos; lra).
  assert (Sin : sin al = (1 + xi) * sin be).
  { pose proof (sin_ge_0 al ltac:(lra) ltac:(lra)) as Sa. pose proof (sin_ge_0 be ltac:(lra) ltac:(lra)) as Sb.
    pose proof (sin2_cos2 al) as Qa. pose proof (sin2_cos2 be) as Qb. unfold Rsqr in Qa, Qb. rewrite Cal in Qa. rewrite Cbe in Qb.
    apply (f_equal (Rmult ((1 + xi) ^ 2))) in Qb. pose proof (f_equal (fun z => z ^ 2) E2) as Qc.
    cbv beta in Qc. assert (sin al ^ 2 = ((1 + xi) * sin be) ^ 2) by (unfold c1 in Qa, Qc; lra).
    assert (0 <= (1 + xi) * sin be) by positive. nra. }
  (* the force: F, then -F, then a2 D *)
  set (U2 := join t2 (fun t => F * t1 - F * t) (fun t => F * t1 - F * t2 + a2 * D * t)).
  set (U := join t1 (fun t => F * t) U2). assert (J2 : F * t1 - F * t2 = F * t1 - F * t2 + a2 * D * 0) by ring.
  assert (J1 : F * t1 = U2 0) by (unfold U2; rewrite join_before by (auto; lra); ring). assert (0 < a2 * D) by positive.
  assert (LU : forall r t, 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r)).
  { intros r t. apply lip_join; auto; [|intros p q; apply lip_join; auto]; intros; apply Rabs_le; split; nra. }
  assert (CU : cont U) by (apply (lip_cont U F); [lra|auto]).
  assert (DU1 : forall t, 0 <= t < t1 -> rderiv U t F) by (intros; apply rderiv_join_before; [auto|lra|rate; ring]).
  assert (DU2 : forall t, t1 <= t < t1 + t2 -> rderiv U t (- F)).
  { intros. apply rderiv_join_after; [lra|]. apply rderiv_join_before; [auto|lra|rate; ring]. }
  assert (DU3 : forall t, t1 + t2 <= t -> rderiv U t (a2 * D))
    by (intros; do 2 (apply rderiv_join_after; [lra|]); rate; ring).
  (* the pair follows three arcs, stuck *)
  assert (Load : forall c z, - 2 <= c <= 2 -> - b <= m2 * (F * c * cos z) / M <= b).
  { intros c z Hc. pose proof (COS_bound z). assert (- 2 <= c * cos z <= 2) by (split; nra).
    assert (0 < m2 * F) by positive.
    assert (m2 * (3 * F) <= b * M) by (replace (b * M) with (m2 * (b * (m1 + m2) / m2)) by (unfold M; field; lra);
      scale).
    assert (m2 * F * -2 <= m2 * F * (c * cos z) <= m2 * F * 2) by (split; apply Rmult_le_compat_l; lra).
    split; undivide M; lra. }
  pose proof (stuck_arc m1 m2 0 a2 b Hm1 Hm2 Hb t1 (fun _ => F) (fun t => R * (1 - cos (om * t)))
    (fun t => R * (om * sin (om * t)))
    ltac:(intros; auto_derive; auto; ring) ltac:(intros; auto_derive; auto; rewrite a2_om, FR; unfold M; field; lra))
      as A1.
  pose proof (stuck_arc m1 m2 0 a2 b Hm1 Hm2 Hb t2 (fun _ => - F) (fun t => (1 + xi) * R * cos (be - om * t) - R)
    (fun t => (1 + xi) * R * (om * sin (be - om * t))) ltac:(intros; auto_derive; auto; unfold Rminus; ring)
    ltac:(intros; auto_derive; auto; rewrite a2_om, FR; unfold M, Rminus; field; lra)) as A2.
  destruct (arc_begins m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb U _ _ _ _ _ t1 T1 CU DU1 (A1 ltac:(intros t _; cbv beta;
    replace (F - _ - _) with (F * 1 * cos (om * t)) by (rewrite a2_om, FR; ring); apply Load; lra)))
      as (x & v1 & v2 & s & Mo & E).
  destruct (E 0 ltac:(lra)) as (X0 & V0 & W0). destruct (E t1 ltac:(lra)) as (Xt & Vt & Wt).
  rewrite Rmult_0_r, cos_0 in X0. rewrite Rmult_0_r, sin_0 in V0, W0. rewrite O1 in Xt, Vt, Wt.
  destruct (follow_arc m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb U (fun _ => - F) x v1 v2 s _ _ _ _ t2 t1 T2 T1 DU2 (A2
    ltac:(intros t _;
    cbv beta; replace (- F - _ - _) with (F * - (1 + xi) * cos (be - om * t)) by (rewrite a2_om, FR; ring);
      apply Load; lra)) Mo)
    with (t := t2) as (Xe & Ve & We); try lra; cbv beta; rewrite ?Rmult_0_r, ?Rminus_0_r, ?Cbe.
  { rewrite Xt, ?Cal. transitivity (R * ((1 + xi) * c2) - R); [rewrite E2|]; ring. } { rewrite Vt, ?Sin. ring.
    } { rewrite Wt, ?Sin. ring. }
  replace (be - om * t2) with 0 in Xe, Ve, We by lra. rewrite cos_0 in Xe. rewrite sin_0 in Ve, We.
  exists U, x, v1, v2, s.
  split; [auto|split; [auto|split; [lra|split; [lra|split; [lra|split; [|auto]]]]]]. intros t Ht.
  destruct (follow_arc m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb U (fun _ => a2 * D) x v1 v2 s (fun _ => D)
    (fun _ => 0) (fun _ => 0)
    (fun _ => 0) (t - (t1 + t2)) (t1 + t2)) with (t := t - (t1 + t2)) as (Xd & Vd & Wd); auto; try lra.
  { intros q Hq. apply DU3. lra. }
  { constructor; [| | |intros; lra]; intros q; auto_derive; auto; field; lra. }
  replace (t1 + t2 + (t - (t1 + t2))) with t in * by ring. lra.
Qed.
End Weak.
