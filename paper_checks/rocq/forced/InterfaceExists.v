(** An interface of changing strength has one motion from every start: where the strength is a function of time that has
    a continuous integral, and where it depends with bounded slopes on the place, the displacement and the speed. *)
From InertialPair Require Import Dini Pair Stick Pursuit Forced Interface.

Section Exists.
Variables m1 m2 a1 a2 x0 v10 v20 : R.
Context (U : R -> R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (CU : cont U).
Let k := / m1 + / m2.
Let kp : 0 < k. Proof. unfold k. positive. Qed.

(** x by v1 *)
Definition place v t := x0 + integral v t.
(** m1 v1 + b s by v1: the momentum without friction, with the force's impulse *)
Definition force v t := m1 * v10 + (U t - U 0) - a2 * integral (place v) t - a1 * integral v t.
Lemma place_cont v : cont v -> cont (place v).
Proof. intros. apply cont_plus; [apply cont_const|apply integral_cont; auto]. Qed.
Lemma force_cont v : cont v -> cont (force v).
Proof.
  intros C. pose proof (place_cont v C). unfold force. continuous.
Qed.

(** the strength by the velocity of body 1 (true) and the impulse of friction (false), and its integral *)
Variables bs Bs : (bool -> R -> R) -> R -> R.
Let conts (f : bool -> R -> R) := forall i, cont (f i).
Let near D lam T (f g : bool -> R -> R) := forall i u, 0 <= u <= T -> Rabs (f i u - g i u) <= D * exp (lam * u).
Variable K : R.
Hypotheses (HK : 0 <= K) (Strong : forall f, conts f -> cont (Bs f) /\ forall t, 0 <= t -> rderiv (Bs f) t (bs f t) /\ 0 <= bs f t)
  (Slopes : forall lam D T f g, 1 <= lam -> 0 <= D -> conts f -> conts g -> near D lam T f g ->
    forall u, 0 <= u <= T -> Rabs (bs f u - bs g u) <= K * D * exp (lam * u)).

Let push f t := force (f true) t.
Let aim f t := (push f t / m1 - v20) / k.
Let rub f := pursuit (Bs f) (aim f).
Let next f (i : bool) t := if i then (push f t - rub f t) / m1 else rub f t.

Let push_cont f : conts f -> cont (push f).
Proof. intros C. apply force_cont; auto. Qed.
Let aim_cont f : conts f -> cont (aim f).
Proof.
  intros C. pose proof (push_cont f C). unfold aim. continuous.
Qed.
Let Bs_grows f : conts f -> forall r t, 0 <= r <= t -> Bs f r <= Bs f t.
Proof.
  intros C r t Hr. destruct (Strong f C) as (CB & DB). assert (- Bs f t <= - Bs f r); [|lra].
  apply (rderiv_mono (fun t => - Bs f t) r t (fun t => - bs f t)); auto using cont_opp.
  intros u Hu. destruct (DB u ltac:(lra)). split; [apply rderiv_opp; auto|lra].
Qed.
Let rub_cont f : conts f -> cont (rub f).
Proof. intros C. apply pursuit_cont; [apply Strong; auto|apply Bs_grows; auto]. Qed.
Let next_cont f : conts f -> conts (next f).
Proof.
  intros C. pose proof (push_cont f C). pose proof (rub_cont f C). intros [|]; unfold next; continuous.
Qed.

Let C1 := (a2 + a1) / (m1 * k) + K.
Let lam := 1 + 2 * C1 + 2 * ((a2 + a1 + C1) / m1).
Let C1p : 0 <= C1. Proof. unfold C1. assert (0 < (a2 + a1) / (m1 * k)) by positive. lra. Qed.
Let lam1 : 1 <= lam. Proof. unfold lam. assert (0 <= (a2 + a1 + C1) / m1) by positive. lra. Qed.

Let next_near f g D T : conts f -> conts g -> 0 <= D -> near D lam T f g ->
  forall i t, 0 <= t <= T -> Rabs (next f i t - next g i t) <= D / 2 * exp (lam * t).
Proof.
  intros Cf Cg HD N. set (e := D / lam). assert (He : 0 <= e) by (unfold e; positive). assert (Ee : e * lam = D) by (unfold e; field; lra).
  assert (I1 : forall u, 0 <= u <= T -> Rabs (integral (f true) u - integral (g true) u) <= e * exp (lam * u)).
  { intros u Hu. apply integral_near; auto; [lra|lra|]. intros; apply (N true); lra. }
  assert (I2 : forall u, 0 <= u <= T -> Rabs (integral (place (f true)) u - integral (place (g true)) u) <= e * exp (lam * u)).
  { intros u Hu. eapply Rle_trans; [apply (integral_near _ _ e lam u); auto using place_cont; [lra|lra|]|].
    - intros r Hr. unfold place. replace (x0 + integral (f true) r - (x0 + integral (g true) r)) with
        (integral (f true) r - integral (g true) r) by ring. apply I1; lra.
    - apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|]. undivide lam. nra. }
  assert (P : forall u, 0 <= u <= T -> Rabs (push f u - push g u) <= (a2 + a1) * e * exp (lam * u)).
  { intros u Hu. replace (push f u - push g u) with (- (a2 * (integral (place (f true)) u - integral (place (g true)) u)
      + a1 * (integral (f true) u - integral (g true) u))) by (unfold push, force; ring).
    rewrite Rabs_Ropp. eapply Rle_trans; [apply Rabs_triang|].
    pose proof (abs_scal a2 _ _ ltac:(lra) (I2 u Hu)). pose proof (abs_scal a1 _ _ Ha1 (I1 u Hu)). lra. }
  assert (F : forall t, 0 <= t <= T -> Rabs (rub f t - rub g t) <= C1 * e * exp (lam * t)).
  { intros t Ht. set (Mt := / (m1 * k) * ((a2 + a1) * e * exp (lam * t))). set (A := fun u => K * e * exp (lam * u)).
    assert (mk : 0 < / (m1 * k)) by positive. pose proof (exp_pos (lam * t)).
    assert (Near : forall u, 0 <= u <= t -> Rabs (aim f u - aim g u) <= Mt).
    { intros u Hu. replace (aim f u - aim g u) with (/ (m1 * k) * (push f u - push g u)) by (unfold aim; field; lra).
      apply abs_scal; [lra|]. eapply Rle_trans; [apply P; lra|]. apply Rmult_le_compat_l; [positive|].
      apply exp_mono, Rmult_le_compat_l; lra. }
    assert (DA : forall u, is_derive A u (K * D * exp (lam * u)))
      by (intros u; unfold A; auto_derive; auto; rewrite <- Ee; ring).
    assert (CA : cont A) by continuous.
    assert (AP : forall u, 0 <= A u) by (intros u; unfold A; pose proof (exp_pos (lam * u)); positive).
    assert (Mp : 0 <= Mt) by (unfold Mt; positive). replace (C1 * e * exp (lam * t)) with (Mt + A t)
      by (unfold C1, Mt, A; field; lra).
    assert (Side : forall f g, conts f -> conts g -> near D lam T f g -> (forall u, 0 <= u <= t -> Rabs (aim f u - aim g u) <= Mt) ->
      rub f t - rub g t <= Mt + A t).
    { clear f g Cf Cg N I1 I2 P Near. intros f g Cf Cg N Near. destruct (Strong f Cf) as (CB & DB), (Strong g Cg) as (CB' & DB').
      pose proof (pursuits_near (Bs f) (Bs g) (aim f) (aim g) (bs f) (bs g) A Mt t CB CB' (aim_cont f Cf) (aim_cont g Cg) CA
        (Bs_grows f Cf) (Bs_grows g Cg) AP Mp ltac:(lra)) as Q. assert (rub f t <= rub g t + Mt + A t); [|lra]. apply Q.
      - intros u Hu. split; [apply DB; lra|]. split; [apply DB'; lra|]. exists (K * D * exp (lam * u)).
        split; [|apply rderiv_of_derive, DA].
        apply (Slopes lam D T); auto; lra.
      - intros u Hu. specialize (Near u Hu). apply Rabs_inv in Near. lra. }
    pose proof (Side f g Cf Cg N Near). pose proof (Side g f Cg Cf ltac:(intros i u Hu; rewrite Rabs_minus_sym; apply N; auto)
      ltac:(intros u Hu; rewrite Rabs_minus_sym; apply Near; auto)). apply Rabs_le. lra. }
  intros i t Ht. pose proof (exp_pos (lam * t)). assert (Dl : forall c, 0 <= c -> 2 * c <= lam -> c * e * exp (lam * t) <= D / 2 * exp (lam * t)).
  { intros c Hc Hl. apply Rmult_le_compat_r; [lra|]. rewrite <- Ee. nra. }
  assert (Q : 0 <= (a2 + a1 + C1) / m1) by positive. destruct i; unfold next.
  - eapply Rle_trans; [|apply (Dl ((a2 + a1 + C1) / m1)); auto; unfold lam; lra].
    replace ((push f t - rub f t) / m1 - (push g t - rub g t) / m1) with (/ m1 * ((push f t - push g t) + - (rub f t - rub g t))) by (field; lra).
    replace ((a2 + a1 + C1) / m1 * e * exp (lam * t)) with (/ m1 * ((a2 + a1) * e * exp (lam * t) + C1 * e * exp (lam * t))) by (field; lra).
    apply abs_scal; [apply Rlt_le; positive|]. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp.
    pose proof (P t Ht). pose proof (F t Ht). lra.
  - eapply Rle_trans; [apply F; auto|]. apply Dl; [auto|unfold lam; lra].
Qed.

(** a motion whose strength is that of its own course *)
Theorem rubs_exists : exists f, conts f /\
  rubs m1 m2 a1 a2 (bs f) U (place (f true)) (f true) (fun t => v20 + / m2 * f false t) (f false) /\
  f true 0 = v10 /\ f false 0 = 0.
Proof.
  destruct (fixed_point next lam ltac:(lra) next_cont next_near) as (f & C & Fix). exists f. split; [exact C|].
  assert (E : forall t, 0 <= t -> m1 * f true t + f false t = push f t /\ f false t = rub f t).
  { intros t Ht. rewrite <- (Fix true t Ht), <- (Fix false t Ht). unfold next. split; [field; lra|auto]. }
  destruct (Strong f C) as (CB & DB). pose proof (Bs_grows f C) as MB.
  assert (F0 : f false 0 = 0) by (rewrite (proj2 (E 0 (Rle_refl 0))); apply pursuit_0; auto).
  split; [constructor; auto|split; auto].
  - intros t Ht e He. destruct (proj1 (DB t Ht) e He) as (d & Hd & Q). exists d; split; auto. intros h Hh.
    rewrite (proj2 (E t Ht)), (proj2 (E (t + h) ltac:(lra))). specialize (Q h Hh). apply Rabs_inv in Q.
    pose proof (pursuit_lip (Bs f) (aim f) MB t (t + h) ltac:(lra)). apply Rabs_le. fold (rub f) in *. lra.
  - intros t Ht j Hj Sl. apply rderiv_ext with (rub f); [intros u Hu; symmetry; apply E; lra|].
    apply pursuit_moves; auto; [|apply DB; auto]. destruct (E t Ht) as (E1 & E2). fold (rub f). rewrite <- E2.
    assert (W : f true t - (v20 + / m2 * f false t) = k * (aim f t - f false t)).
    { unfold aim. rewrite <- E1. unfold k. field. repeat split; lra. }
    cbv beta in Sl. rewrite W in Sl. apply Rmult_lt_reg_l with k; auto. rewrite Rmult_0_r. lra.
  - apply place_cont; auto.
  - intros t Ht. pose proof (C true). unfold place. rate. ring.
  - intros t Ht. apply rderiv_ext with (fun u => (m1 * v10 - U 0) - a2 * integral (place (f true)) u - a1 * integral (f true) u).
    { intros u Hu. rewrite (proj1 (E u ltac:(lra))). unfold push, force. ring. }
    pose proof (C true). pose proof (place_cont _ (C true)). rate. ring.
  - intros t Ht. rewrite F0. field. lra.
  - pose proof (proj1 (E 0 (Rle_refl 0))) as Q. rewrite F0 in Q. unfold push, force in Q. rewrite !integral_0 in Q.
    apply Rmult_eq_reg_l with m1; lra.
Qed.
End Exists.

Section Interfaces.
Context (m1 m2 a1 a2 : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2).
Let rubs := rubs m1 m2 a1 a2.

(** [interface-well-posed] With a friction of at most $b(t)\geqslant 0$ against the slip, where $b$ is the rate from
    the right of a continuous function, there is exactly one motion from every initial state. *)
Theorem interface_well_posed b B U x0 v10 v20 : cont U -> cont B -> (forall t, 0 <= t -> rderiv B t (b t) /\ 0 <= b t) ->
  exists x v1 v2 F, (rubs b U x v1 v2 F /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2' F', rubs b U x' v1' v2' F' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t.
Proof.
  intros CU CB DB. destruct (rubs_exists m1 m2 a1 a2 x0 v10 v20 U Hm1 Hm2 Ha1 Ha2 CU (fun _ => b) (fun _ => B) 0)
    as (f & C & H & V0 & F0); [lra|auto| |].
  { intros lam D T f g _ HD _ _ _ u Hu. rewrite Rminus_diag_eq, Rabs_R0 by auto. pose proof (exp_pos (lam * u)). lra. }
  exists (place x0 (f true)), (f true), (fun t => v20 + / m2 * f false t), (f false).
  split; [split; [exact H|]; split; [unfold place; rewrite integral_0; ring|split; [auto|rewrite F0; ring]]|].
  intros x' v1' v2' F' H' X' V' W' t Ht.
  pose proof (interface_contraction m1 m2 a1 a2 Hm1 Hm2 Ha1 b U _ _ _ _ _ _ _ _ 0 t H' H ltac:(lra)) as Q. cbv beta in Q.
  rewrite X', V', W', V0, F0 in Q. replace (place x0 (f true) 0) with x0 in Q by (unfold place; rewrite integral_0; ring).
  replace (v20 - (v20 + / m2 * 0)) with (v20 - v20) in Q by ring. exact (energy_apart m1 m2 a2 Hm1 Hm2 Ha2 _ _ _ _ _ _ _ _ _ Q).
Qed.

(** a motion with the displacement z whose friction has the strength be (x, z, |v1 - v2|) *)
Definition rubs_by_state (be : R -> R -> R -> R) U x v1 v2 z F := cont z /\
  (forall t, 0 <= t -> rderiv z t (v1 t - v2 t)) /\ rubs (fun t => be (x t) (z t) (Rabs (v1 t - v2 t))) U x v1 v2 F.

(** [state-well-posed] With a strength $b\geqslant 0$ that depends on $x_1$, $z$ and $|\dot z|$ with bounded slopes
    there is exactly one motion from every initial state. *)
Theorem state_well_posed be l U x0 v10 v20 z0 : cont U -> 0 <= l -> (forall x z s, 0 <= be x z s) ->
  (forall x z s x' z' s', Rabs (be x z s - be x' z' s') <= l * (Rabs (x - x') + Rabs (z - z') + Rabs (s - s'))) ->
  exists x v1 v2 z F, (rubs_by_state be U x v1 v2 z F /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20 /\ z 0 = z0) /\
  forall x' v1' v2' z' F', rubs_by_state be U x' v1' v2' z' F' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 -> z' 0 = z0 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t /\ z' t = z t.
Proof.
  intros CU Hl Pos Lip. set (conts := fun f : bool -> R -> R => forall i, cont (f i)).
  set (X := fun f : bool -> R -> R => place x0 (f true)). set (w := fun (f : bool -> R -> R) t => f true t - (v20 + / m2 * f false t)).
  set (Z := fun f t => z0 + integral (w f) t). set (bs := fun f t => be (X f t) (Z f t) (Rabs (w f t))).
  assert (Cw : forall f, conts f -> cont (w f)).
  { intros f C. pose proof (C true). pose proof (C false). unfold w. continuous. }
  assert (CX : forall f, conts f -> cont (X f)) by (intros f C; apply place_cont; auto).
  assert (CZ : forall f, conts f -> cont (Z f)) by (intros f C; apply cont_plus; [apply cont_const|apply integral_cont; auto]).
  assert (Cb : forall f, conts f -> cont (bs f)).
  { intros f C t Ht e He. set (q := e / (3 * (l + 1))). assert (Hq : 0 < q) by (unfold q; positive).
    destruct (CX f C t Ht q Hq) as (d1 & H1 & K1). destruct (CZ f C t Ht q Hq) as (d2 & H2 & K2).
    destruct (cont_abs _ (Cw f C) t Ht q Hq) as (d3 & H3 & K3). exists (Rmin d1 (Rmin d2 d3)). split; [positive|].
    intros s Hs Hd. pose proof (Rmin_l d1 (Rmin d2 d3)). pose proof (Rmin_r d1 (Rmin d2 d3)). pose proof (Rmin_l d2 d3).
    pose proof (Rmin_r d2 d3). specialize (K1 s Hs ltac:(lra)). specialize (K2 s Hs ltac:(lra)). specialize (K3 s Hs ltac:(lra)).
    eapply Rle_lt_trans; [apply Lip|]. assert (Eq : q * (3 * (l + 1)) = e) by (unfold q; field; lra). nra. }
  set (c := 1 + / m2). assert (i2 : 0 < / m2) by positive.
  destruct (rubs_exists m1 m2 a1 a2 x0 v10 v20 U Hm1 Hm2 Ha1 Ha2 CU bs (fun f => integral (bs f)) (l * (1 + c + c)))
    as (f & C & H & V0 & F0); [unfold c; positive| | |].
  { intros f C. split; [apply integral_cont, Cb; auto|]. intros t Ht. split; [apply integral_rderiv; auto; apply Cb; auto|apply Pos]. }
  { intros lam D T f g Hlam HD Cf Cg N u Hu. eapply Rle_trans; [apply Lip|]. pose proof (exp_pos (lam * u)).
    assert (W : forall r, 0 <= r <= u -> Rabs (w f r - w g r) <= c * D * exp (lam * r)).
    { intros r Hr. replace (w f r - w g r) with ((f true r - g true r) + - (/ m2 * (f false r - g false r))) by (unfold w; ring).
      eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. pose proof (N true r ltac:(lra)).
      pose proof (abs_scal (/ m2) _ _ ltac:(lra) (N false r ltac:(lra))). unfold c. lra. }
    assert (Q : forall q, 0 <= q -> q / lam * exp (lam * u) <= q * exp (lam * u)).
    { intros q Hq. apply Rmult_le_compat_r; [lra|]. undivide lam. nra. }
    assert (I1 : Rabs (X f u - X g u) <= D * exp (lam * u)).
    { unfold X, place. replace (x0 + integral (f true) u - (x0 + integral (g true) u)) with (integral (f true) u - integral (g true) u) by ring.
      eapply Rle_trans; [apply (integral_near _ _ D lam u); auto; [lra|lra|]|apply Q; auto]. intros; apply (N true); lra. }
    assert (I2 : Rabs (Z f u - Z g u) <= c * D * exp (lam * u)).
    { unfold Z. replace (z0 + integral (w f) u - (z0 + integral (w g) u)) with (integral (w f) u - integral (w g) u) by ring.
      eapply Rle_trans; [apply (integral_near _ _ (c * D) lam u); auto; lra|apply Q]. unfold c; positive. }
    pose proof (Rabs_triang_inv2 (w f u) (w g u)). pose proof (W u ltac:(lra)).
    replace (l * (1 + c + c) * D * exp (lam * u)) with (l * (D * exp (lam * u) + c * D * exp (lam * u) + c * D * exp (lam * u))) by ring.
    apply Rmult_le_compat_l; lra. }
  exists (X f), (f true), (fun t => v20 + / m2 * f false t), (Z f), (f false).
  assert (X0 : X f 0 = x0) by (unfold X, place; rewrite integral_0; ring). assert (Z00 : Z f 0 = z0) by (unfold Z; rewrite integral_0; ring).
  assert (DZ : forall t, 0 <= t -> rderiv (Z f) t (w f t)).
  { intros t Ht. pose proof (Cw f C). unfold Z. rate. ring. }
  split; [split; [split; [auto|split; [exact DZ|exact H]]|rewrite F0; repeat split; auto; ring]|].
  intros x' v1' v2' z' F' (Cz' & Dz' & H') X' V' W' Z' t Ht.
  pose proof (growth_by_state m1 m2 a1 a2 Hm1 Hm2 Ha1 Ha2 _ _ _ _ _ _ _ _ _ _ _ H' H l Hl z' (Z f) t Cz' (CZ f C) Dz' DZ Ht
    (fun u _ => Lip _ _ _ _ _ _)) as Q. cbv beta in Q. change (place x0 (f true)) with (X f) in Q. rewrite X', V', W', Z', X0, V0, F0, Z00 in Q.
  replace (v20 - (v20 + / m2 * 0)) with 0 in Q by ring. rewrite (Rminus_diag_eq x0), (Rminus_diag_eq v10), (Rminus_diag_eq z0) in Q by auto.
  replace (2 * energy m1 m2 a2 0 0 0 + 0 ^ 2) with 0 in Q by (unfold energy; field). rewrite Rmult_0_r in Q.
  set (dx := x' t - X f t) in *. pose proof (pow2_ge_0 (z' t - Z f t)).
  pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 dx (v1' t - f true t) (v2' t - (v20 + / m2 * f false t))).
  destruct (energy_zero m1 m2 a2 Hm1 Hm2 Ha2 dx (v1' t - f true t) (v2' t - (v20 + / m2 * f false t)) ltac:(lra)) as (E1 & E2 & E3).
  assert (E4 : (z' t - Z f t) ^ 2 = 0) by lra. assert (z' t - Z f t = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
  unfold dx in E1. repeat split; lra.
Qed.
End Interfaces.
