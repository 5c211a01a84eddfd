(** Which mode follows at a contact v1 = v2, right after t0: with the load m2 (u - a2 x - a1 v1)/M, the friction that
    sticking needs, the pair sticks if the load is within b, and slips with the load's sign if it is beyond b. The
    force need only be known from t0 on, for a while, and be continuous from the right at t0: a jump at t0 decides
    with its later value. *)
From InertialPair Require Import Dini Pair Pursuit Forced.

Section Mode.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Variables U u x v1 v2 s : R -> R.
Variables t0 d0 : R.
Hypotheses (H : forced m1 m2 a1 a2 b U x v1 v2 s) (Ht0 : 0 <= t0) (Hd0 : 0 < d0)
  (DU : forall t, t0 <= t < t0 + d0 -> rderiv U t (u t))
  (Cu : forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (u (t0 + h) - u t0) <= e)
  (Meet : v1 t0 = v2 t0).
Let w t := v1 t - v2 t.
(** the load *)
Definition load t := m2 * (u t - a2 * x t - a1 * v1 t) / (m1 + m2).

(** it is continuous where the force is: among the times Q near t0 *)
Lemma load_near (Q : R -> Prop) e : 0 < e ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall q, Q q -> Rabs (q - t0) < d -> Rabs (u q - u t0) <= e) ->
  exists d, 0 < d /\ forall q, 0 <= q -> Q q -> Rabs (q - t0) < d -> Rabs (load q - load t0) <= e.
Proof.
  intros He Cq. assert (Mp : 0 < M) by positive. set (k := 1 + a2 + a1). assert (Kp : 0 < k) by (unfold k; lra).
  set (e' := M / m2 * e / k). assert (He' : 0 < e') by positive.
  destruct (Cq e' He') as (d1 & D1 & K1). destruct (f_cx _ _ _ _ _ _ _ _ _ _ H t0 Ht0 e' He') as (d2 & D2 & K2).
  destruct (f_cv _ _ _ _ _ _ _ _ _ _ H t0 Ht0 e' He') as (d3 & D3 & K3).
  smaller d1 (Rmin d2 d3). intros q Hq Qq Dq.
  specialize (K1 q Qq ltac:(lra)). specialize (K2 q Hq ltac:(lra)). specialize (K3 q Hq ltac:(lra)).
  replace (load q - load t0) with (m2 / M * ((u q - u t0) - a2 * (x q - x t0) - a1 * (v1 q - v1 t0)))
    by (unfold load, M; field; lra).
  replace e with (m2 / M * (k * e')) by (unfold e'; field; unfold k in *; lra).
  apply abs_scal; [positive|]. unfold k. by_sizes.
Qed.
Lemma load_after e : 0 < e -> exists d, 0 < d /\ forall q, t0 <= q < t0 + d -> Rabs (load q - load t0) <= e.
Proof.
  intros He. destruct (load_near (fun q => t0 <= q) e He) as (d & Hd & K).
  - intros e' He'. destruct (Cu e' He') as (d & Hd & K). exists d. split; auto. intros q Hq Dq. apply Rabs_def2 in Dq.
    replace q with (t0 + (q - t0)) by ring. apply K. lra.
  - exists d. split; auto. intros q Hq. apply K; [lra|lra|]. apply Rabs_def1; lra.
Qed.

Lemma cont_w : cont w.
Proof. continuous. Qed.

(** *** Beside the motion with the constant acceleration k b/m2, in which both modes agree *)
(** what the force asks beyond b: at an edge its first derivative that is not 0 decides *)
Definition beyond k t := k * u t - a2 * (k * x t0 + k * v1 t0 * (t - t0) + b / m2 * (t - t0) ^ 2 / 2)
  - a1 * (k * v1 t0 + b / m2 * (t - t0)) - (m1 + m2) * (b / m2).

(** beside that motion: where and how fast body 1 is ahead of it, and body 2 *)
Definition place k t := k * x t - (k * x t0 + k * v1 t0 * (t - t0) + b / m2 * (t - t0) ^ 2 / 2).
Definition lead k t := k * v1 t - (k * v1 t0 + b / m2 * (t - t0)).
Definition ahead2 k t := k * (v2 t - v2 t0) - b / m2 * (t - t0).
(** their momentum *)
Definition gain k t := m1 * (k * w t) + M * ahead2 k t.
(** what the load exceeds the edge by, on the scale of the force *)
Definition excess k t := beyond k t - a1 * lead k t - a2 * place k t.

Lemma excess_of_load k t : excess k t = M / m2 * (k * load t - b).
Proof. unfold excess, lead, place, beyond, load, M. field. lra. Qed.
Lemma lead_split k t : lead k t = k * w t + ahead2 k t.
Proof. unfold lead, w, ahead2. rewrite Meet. ring. Qed.
Lemma place_rate k t : 0 <= t -> rderiv (place k) t (lead k t).
Proof. intros Ht. unfold place. rate. unfold lead. field. lra. Qed.
Lemma cont_place k : cont (place k).
Proof. unfold place. continuous. Qed.
(** the momentum has the rate of the excess in every mode, and is 0 at the contact *)
Lemma gain_rate k t : 0 <= t -> rderiv U t (u t) -> rderiv (gain k) t (excess k t).
Proof.
  intros Ht HU. apply rderiv_ext with (fun r => k * ((m1 * v1 r + m2 * v2 r - U r) + U r)
    - (M * (k * v2 t0) + M * (b / m2) * (r - t0))).
  - intros r Hr. unfold gain, w, ahead2, M. ring.
  - pose proof (momentum _ _ _ _ _ _ _ _ _ _ t H Ht). rate. unfold excess, beyond, place, lead, M. field. lra.
Qed.
Lemma cont_gain k : cont (gain k).
Proof. unfold gain, ahead2. continuous. Qed.
Lemma gain_0 k : gain k t0 = 0.
Proof. unfold gain, w, ahead2. rewrite Meet. ring. Qed.
(** body 2 was ahead and falls behind, as friction gives it at most the acceleration b/m2 *)
Lemma ahead2_sign k t : k = 1 \/ k = -1 -> 0 <= t -> (t <= t0 -> 0 <= ahead2 k t) /\ (t0 <= t -> ahead2 k t <= 0).
Proof.
  intros Hk Ht. assert (P : 0 < b / m2) by positive.
  replace (ahead2 k t) with (b / m2 * (k * (s t - s t0) - (t - t0))).
  2: { unfold ahead2. rewrite (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H t0 t Ht0 Ht). ring. }
  pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H) as L. split; intros Hl.
  - specialize (L t t0 ltac:(lra)). apply Rabs_inv in L. apply Rmult_le_pos; [lra|]. destruct Hk; subst k; lra.
  - specialize (L t0 t ltac:(lra)). apply Rabs_inv in L.
    assert (k * (s t - s t0) - (t - t0) <= 0) by (destruct Hk; subst k; lra). nra.
Qed.
(** what it exceeds the edge by drives the momentum, and body 1 has more of it than both *)
Lemma gain_rises k c p q : 0 <= p <= q -> (forall t, p <= t < q -> rderiv U t (u t) /\ c <= excess k t) ->
  c * (q - p) <= gain k q - gain k p.
Proof.
  intros Hp Ex. pose proof (dini_slope (fun t => -1 * gain k t) (- c) p q (cont_scal (-1) _ (cont_gain k)) Hp) as Q.
  cut (-1 * gain k q - -1 * gain k p <= - c * (q - p)); [lra|]. apply Q. intros t Ht. destruct (Ex t Ht) as (HU & E).
  eapply rderiv_dini; [|apply rderiv_scal, gain_rate; [lra|exact HU]]. lra.
Qed.
Lemma gain_ahead k t : k = 1 \/ k = -1 -> t0 <= t -> 0 < gain k t -> 0 < k * (v1 t - v2 t).
Proof.
  intros Hk Ht G. pose proof (proj2 (ahead2_sign k t Hk ltac:(lra)) Ht). unfold gain, w, M in *.
  apply Rmult_lt_reg_l with m1; [auto|]. nra.
Qed.

(** [mode-slip] At a contact with $|\Lambda|>b$, where $u$ is continuous from the right, it slips at once, with the
    sign of the load $\Lambda$. *)
Theorem slips_at k : k = 1 \/ k = -1 -> b < k * load t0 -> exists d, 0 < d /\ forall t, t0 < t < t0 + d ->
  0 < k * (v1 t - v2 t).
Proof.
  intros Hk G. set (g := (k * load t0 - b) / 2). destruct (load_after g) as (d & Hd & K); [unfold g; lra|].
  smaller d d0. intros t Ht. apply gain_ahead; [auto|lra|]. pose proof (gain_rises k (M / m2 * g) t0 t ltac:(lra)) as Q.
  rewrite gain_0 in Q. assert (0 < M / m2 * g * (t - t0)) by positive. eapply Rlt_le_trans; [eassumption|].
  rewrite <- (Rminus_0_r (gain k t)). apply Q. intros r Hr. split; [apply DU; lra|]. rewrite excess_of_load.
  apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat; unfold M; lra|]. specialize (K r ltac:(lra)).
  apply Rabs_inv in K. unfold g in *. destruct Hk; subst k; lra.
Qed.

(** while the load is at most b no slip forwards begins *)
Lemma stays_behind k r t : k = 1 \/ k = -1 -> t0 <= r <= t -> t <= t0 + d0 -> k * w r <= 0 ->
  (forall q, r <= q < t -> k * load q <= b) -> k * w t <= 0.
Proof.
  intros Hk Hr Ht W L. apply (moves_behind m1 m2 a1 a2 b Hm1 Hm2 _ _ _ _ _ _ H r t k); auto; [lra|]. intros q Hq.
  exists (k * u q). split; [eapply rderiv_dini; [apply Rle_refl|apply rderiv_scal, DU; lra]|].
  replace (m2 * _) with (k * load q * (m1 + m2)) by (unfold load; field; lra). apply Rmult_le_compat_r; [lra|auto].
Qed.
Lemma not_ahead k : k = 1 \/ k = -1 -> k * load t0 < b -> exists d, 0 < d <= d0 /\ forall t, t0 <= t < t0 + d ->
  k * (v1 t - v2 t) <= 0.
Proof.
  intros Hk G. destruct (load_after (b - k * load t0)) as (d & Hd & K); [lra|].
  exists (Rmin d d0). min_bounds (Rmin d d0). split; [split; [positive|auto]|]. intros t Ht.
  apply (stays_behind k t0 t); [auto|lra|lra|unfold w; rewrite Meet; lra|]. intros r Hr. specialize (K r ltac:(lra)).
  apply Rabs_inv in K. destruct Hk; subst k; lra.
Qed.

(** [mode-stick] At a contact with $|\Lambda|<b$, where $u$ is continuous from the right, the pair sticks for a while.
    *)
Theorem sticks_at : Rabs (load t0) < b -> exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t.
Proof.
  intros G. pose proof (Rle_abs (load t0)). pose proof (Rle_abs (- load t0)) as A. rewrite Rabs_Ropp in A.
  destruct (not_ahead 1 (or_introl eq_refl) ltac:(lra)) as (d & Hd & K).
  destruct (not_ahead (-1) (or_intror eq_refl) ltac:(lra)) as (d' & Hd' & K'). smaller d d'. intros t Ht.
  specialize (K t ltac:(lra)). specialize (K' t ltac:(lra)). lra.
Qed.

(** *** The motion with that acceleration is one under the impulse Ut of a force, with the load at the edge.
    The two are as far apart as the forces: by the integral of what the force asks beyond b. *)
Let xt k t := x t0 + v1 t0 * (t - t0) + k * (b / m2) * (t - t0) ^ 2 / 2.
Let vt k t := v1 t0 + k * (b / m2) * (t - t0).
Let Ut k t := m1 * vt k t + b * (k * t) + a1 * xt k t
  + a2 * (x t0 * (t - t0) + v1 t0 * (t - t0) ^ 2 / 2 + k * (b / m2) * (t - t0) ^ 3 / 6).
(** g: the sign of what the force asks beyond b *)
Let asked g k t := g * (k * (U t - Ut k t - (U t0 - Ut k t0))).

Lemma at_edge k : k = 1 \/ k = -1 -> forced m1 m2 a1 a2 b (Ut k) (xt k) (vt k) (vt k) (fun t => k * t).
Proof.
  intros Hk. unfold Ut, xt, vt. constructor; try (intros; lra); try continuous.
  - intros r t Hr. destruct Hk; subst k; apply Rabs_le; lra.
  - intros t _. rate. field; lra.
  - intros t _. rate. field; lra.
  - intros t _. field; lra.
Qed.
Lemma asked_rate g k t : k = 1 \/ k = -1 -> t0 <= t < t0 + d0 -> rderiv (asked g k) t (g * beyond k t).
Proof.
  intros Hk Ht. unfold asked, Ut, xt, vt. rate. unfold beyond. destruct Hk; subst k; field; lra.
Qed.
Lemma cont_asked g k : k = 1 \/ k = -1 -> cont (asked g k).
Proof.
  intros Hk. pose proof (at_edge k Hk) as E. assert (cont (Ut k)) by continuous. unfold asked. continuous.
Qed.

(** so the spring and the damper give back less than that *)
Lemma given_back g k T : g = 1 \/ g = -1 -> k = 1 \/ k = -1 -> t0 <= T <= t0 + d0 -> T <= t0 + 1 ->
  (forall t, t0 <= t < T -> 0 <= g * beyond k t) -> (forall t, t0 <= t <= T -> 0 <= asked g k t <= asked g k T) /\
  forall t, t0 <= t <= T -> Rabs (excess k t - beyond k t) <= (a1 + a2) / m1 * asked g k T.
Proof.
  intros Hg Hk HT H1 Sg. assert (Start : asked g k t0 = 0) by (unfold asked; ring).
  assert (Up : forall r t, t0 <= r <= t -> t <= T -> asked g k r <= asked g k t).
  { intros r t Hr Ht. apply Ropp_le_cancel.
    apply (rderiv_mono (fun t => - asked g k t) r t (fun t => - (g * beyond k t)));
      [apply cont_opp, cont_asked; auto|lra|]. intros q Hq. specialize (Sg q ltac:(lra)).
    split; [apply rderiv_opp, asked_rate; auto; lra|lra]. }
  assert (Lead : forall t, t0 <= t <= T -> Rabs (lead k t) <= asked g k T / m1).
  { intros t Ht. pose proof (sqrt_lt_R0 _ Hm1) as Sm. pose proof (at_edge k Hk) as E.
    pose proof (energy_above m1 m2 a2 Hm1 Hm2 Ha2 (x t - xt k t) (v1 t - vt k t) (v2 t - vt k t)) as R.
    pose proof (pushed_apart m1 m2 a2 Hm1 Hm2 Ha2 (fun t => x t - xt k t) (fun t => v1 t - vt k t)
      (fun t => v2 t - vt k t) (fun t => k * beyond k t) (asked g k) t0 t
        (moves_cD _ _ _ _ _ Hm2 _ _ _ _ _ _ _ _ _ _ H E)
      (cont_asked g k Hk) ltac:(lra)) as Q. cbv beta zeta in Q.
    replace (energy m1 m2 a2 (x t0 - xt k t0) (v1 t0 - vt k t0) (v2 t0 - vt k t0)) with 0 in Q
      by (unfold energy, xt, vt; rewrite <- Meet; field; lra).
    rewrite Rmult_0_r, sqrt_0, Start, Rminus_0_r, Rplus_0_l in Q.
    replace (Rabs (lead k t)) with (Rabs (v1 t - vt k t)).
    2: { rewrite <- (Rabs_sign k) by auto. f_equal. unfold lead, vt. destruct Hk; subst k; ring. }
    apply Rmult_le_reg_l with (sqrt m1); auto. eapply Rle_trans; [exact R|]. eapply Rle_trans; [apply Q|].
    - intros r Hr. specialize (Sg r ltac:(lra)).
      assert (DD : rderiv (fun t => U t - Ut k t) r (k * beyond k r)).
      { unfold Ut, xt, vt. rate. unfold beyond, vt, xt. destruct Hk; subst k; field; lra. }
      split; [|eapply dini_weaken; [|exact
        (moves_D_dini _ _ _ _ _ Hm1 Hm2 Hb _ _ _ _ _ _ _ _ _ _ H E r _ ltac:(lra) DD)]].
      + apply rderiv_eq with (g * beyond k r); [|apply asked_rate; auto; lra]. symmetry.
        destruct Hk, Hg; subst k g; try rewrite Rabs_pos_eq by lra; try rewrite Rabs_left1 by lra; lra.
      + assert (0 <= a1 * (v1 r - vt k r) ^ 2) by positive. lra.
    - rewrite <- (sqrt_sqrt m1) at 3 by lra. apply Rmult_le_reg_r with (sqrt m1); auto. field_simplify; [|lra|lra].
      apply Up; lra. }
  split; [intros t Ht; rewrite <- Start; split; apply Up; lra|]. intros t Ht. specialize (Lead t Ht) as L1.
  assert (L2 : Rabs (place k t) <= asked g k T / m1).
  { replace (place k t) with (place k t - place k t0) by (unfold place; field; lra).
    eapply Rle_trans; [apply (lip_between (place k) (lead k) (asked g k T / m1) t0 t (cont_place k)); [lra|]|].
    - intros r Hr. split; [apply place_rate; lra|apply Rabs_inv, Lead; lra].
    - pose proof (Rabs_pos (lead k t)). nra. }
  replace (excess k t - beyond k t) with (- (a1 * lead k t + a2 * place k t)) by (unfold excess; ring).
  replace ((a1 + a2) / m1 * asked g k T) with (a1 * (asked g k T / m1) + a2 * (asked g k T / m1)) by (field; lra).
  by_sizes.
Qed.
Lemma beyond_0 k : k * load t0 = b -> beyond k t0 = 0.
Proof.
  intros Tie. pose proof (excess_of_load k t0) as E. rewrite Tie in E.
  replace (beyond k t0) with (excess k t0) by (unfold excess, lead, place; field; lra). lra.
Qed.

(** where the force asks more than b right after, the pair slips *)
Theorem slips_at_edge k : k = 1 \/ k = -1 -> k * load t0 = b -> (forall t, t0 < t < t0 + d0 -> 0 < beyond k t) ->
  exists d, 0 < d /\ forall t, t0 < t < t0 + d -> 0 < k * (v1 t - v2 t).
Proof.
  intros Hk Tie Pp. set (c := (a1 + a2) / m1). assert (C0 : 0 < c) by positive.
  assert (Hc : 0 < / (2 * c + 1)) by positive. smaller d0 (/ (2 * c + 1)). intros T HT.
  assert (Short : (2 * c + 1) * (T - t0) < 1).
  { apply Rlt_le_trans with ((2 * c + 1) * / (2 * c + 1)); [scale|right; field; lra]. }
  assert (Sg : forall t, t0 <= t < T -> 0 <= 1 * beyond k t).
  { intros t Ht. destruct (Req_dec t t0) as [->|N]; [rewrite beyond_0; auto; lra|specialize (Pp t ltac:(lra)); lra]. }
  destruct (given_back 1 k T (or_introl eq_refl) Hk ltac:(lra) ltac:(nra) Sg) as (Up & Back). fold c in Back.
  set (J := asked 1 k) in *. assert (Jp : 0 < J T).
  { set (r := (t0 + T) / 2). assert (Hr : t0 < r < T) by (unfold r; lra). pose proof (Pp r ltac:(lra)) as P.
    destruct (asked_rate 1 k r Hk ltac:(lra) (beyond k r / 2)) as (d & Hd & K); [lra|].
    set (h := Rmin (d / 2) (T - r)). pose proof (Rmin_l (d / 2) (T - r)). pose proof (Rmin_r (d / 2) (T - r)).
    assert (0 < h) by positive. fold h in H2, H3. specialize (K h ltac:(lra)). apply Rabs_inv in K.
    fold J in K. pose proof (Up r ltac:(lra)). pose proof (Up (r + h) ltac:(lra)). nra. }
  assert (G : - (c * J T) * (T - t0) <= gain k T - J T - (gain k t0 - J t0) <= c * J T * (T - t0)).
  { apply (between (fun t => gain k t - J t) (fun t => excess k t - 1 * beyond k t)); [|lra|].
    - apply cont_minus; [apply cont_gain|apply cont_asked; auto].
    - intros t Ht. split; [|rewrite Rmult_1_l; apply Rabs_inv, Back; lra].
      apply rderiv_minus; [apply gain_rate; [lra|apply DU; lra]|apply asked_rate; auto; lra]. }
  rewrite gain_0 in G. assert (J t0 = 0) by (unfold J, asked; ring). assert (0 < gain k T) by nra.
  apply gain_ahead; auto. lra.
Qed.

(** where it asks ever less than b right after, the pair sticks *)
Theorem sticks_at_edge k : k = 1 \/ k = -1 -> k * load t0 = b ->
  (forall r t, t0 <= r <= t -> t < t0 + d0 -> beyond k t <= beyond k r) ->
  exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t.
Proof.
  intros Hk Tie Mono. assert (Hk' : - k = 1 \/ - k = -1) by (destruct Hk; [right|left]; lra).
  destruct (not_ahead (- k) Hk' ltac:(lra)) as (d1 & Hd1 & NA). set (c := (a1 + a2) / m1).
  assert (C0 : 0 < c) by positive. assert (Hc : 0 < / (c + 1)) by positive.
  smaller d1 (/ (c + 1)). set (d := Rmin d1 (/ (c + 1))) in *. intros t Ht. specialize (NA t ltac:(lra)).
  pose proof (beyond_0 k Tie) as B0.
  assert (k * (v1 t - v2 t) <= 0); [|destruct Hk; subst k; lra].
  apply (stays_behind k t0 t); [auto|lra|lra|unfold w; rewrite Meet; lra|].
  intros T HT. assert (Short : (c + 1) * (T - t0) < 1).
  { apply Rlt_le_trans with ((c + 1) * / (c + 1)); [scale|right; field; lra]. }
  assert (Sg : forall r, t0 <= r < T -> 0 <= -1 * beyond k r /\ beyond k T <= beyond k r).
  { intros r Hr. pose proof (Mono t0 r ltac:(lra) ltac:(lra)). split; [lra|apply Mono; lra]. }
  destruct (given_back (-1) k T (or_intror eq_refl) Hk ltac:(lra) ltac:(nra)) as (_ & Back);
    [intros r Hr; apply Sg; auto|]. specialize (Back T ltac:(lra)). fold c in Back. apply Rabs_inv in Back.
  assert (J : 0 * (T - t0) <= asked (-1) k T - asked (-1) k t0 <= - beyond k T * (T - t0)).
  { apply (between _ (fun t => -1 * beyond k t)); [apply cont_asked; auto|lra|].
    intros r Hr. destruct (Sg r Hr). split; [apply asked_rate; auto; lra|lra]. }
  replace (asked (-1) k t0) with 0 in J by (unfold asked; ring). pose proof (Mono t0 T ltac:(lra) ltac:(lra)).
  pose proof (excess_of_load k T). assert (0 < M / m2) by (apply Rdiv_lt_0_compat; unfold M; lra).
  assert (c * asked (-1) k T <= c * (T - t0) * - beyond k T) by nra. assert (excess k T <= 0) by nra. nra.
Qed.

(** *** The rule for ties: the first derivative that is not 0 decides *)
Variables (P : nat -> R -> R) (n : nat) (k : R).
Hypotheses (Hk : k = 1 \/ k = -1) (Tie : k * load t0 = b) (DP : forall i t, is_derive (P i) t (P (S i) t))
  (P0 : forall t, t0 <= t < t0 + d0 -> beyond k t = P 0%nat t) (Flat : forall i, (i < n)%nat -> P i t0 = 0).

(** a sign of the n-th derivative right after t0 is that of all lower ones *)
Lemma all_below g d : g = 1 \/ g = -1 -> (forall t, t0 <= t < t0 + d -> 0 < g * P n t) ->
  forall i, (i <= n)%nat -> forall t, t0 < t < t0 + d -> 0 < g * P i t.
Proof.
  intros Hg Pn i Hi. remember (n - i)%nat as j eqn:Ej. revert i Hi Ej. induction j as [|j IH]; intros i Hi Ej t Ht.
  - replace i with n by lia. apply Pn. lra.
  - replace 0 with (g * P i t0) by (rewrite Flat by lia; ring).
    destruct (MVT_cor2 (fun t => g * P i t) (fun t => g * P (S i) t) t0 t) as (c & Ec & Hc); [lra| |].
    { intros c _. apply is_derive_Reals, is_derive_scal, DP. }
    pose proof (IH (S i) ltac:(lia) ltac:(lia) c ltac:(lra)) as Pc.
    assert (0 < g * P (S i) c * (t - t0)) by positive. lra.
Qed.
(** it keeps that sign for a while *)
Lemma sign_stays g : g = 1 \/ g = -1 -> 0 < g * P n t0 -> exists d, 0 < d <= d0 /\ forall t, t0 <= t < t0 + d ->
  0 < g * P n t.
Proof.
  intros Hg Pn. assert (C : cont (fun t => g * P n t)).
  { apply cont_of_derive with (fun t => g * P (S n) t). intros t. apply is_derive_scal, DP. }
  destruct (C t0 Ht0 (g * P n t0) Pn) as (d & Hd & K). exists (Rmin d d0). min_bounds (Rmin d d0).
  split; [split; [positive|auto]|]. intros t Ht. specialize (K t ltac:(lra)).
  rewrite Rabs_pos_eq in K by lra. specialize (K ltac:(lra)). apply Rabs_def2 in K. lra.
Qed.
End Mode.

(** [mode-tie] At a contact with $\Lambda=\pm b$, under a smooth force, the first nonzero derivative of the excess of
    the force over that which keeps the load at $\pm b$ decides. *)
Theorem tie_rule m1 m2 a1 a2 b U u x v1 v2 s t0 d0 (P : nat -> R -> R) n k :
  0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b -> forced m1 m2 a1 a2 b U x v1 v2 s -> 0 <= t0 -> 0 < d0 ->
  (forall t, t0 <= t < t0 + d0 -> rderiv U t (u t)) ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (u (t0 + h) - u t0) <= e) ->
  v1 t0 = v2 t0 -> k = 1 \/ k = -1 -> k * load m1 m2 a1 a2 u x v1 t0 = b ->
  (forall i t, is_derive (P i) t (P (S i) t)) ->
  (forall t, t0 <= t < t0 + d0 -> beyond m1 m2 a1 a2 b u x v1 t0 k t = P 0%nat t) ->
  (forall i, (i < n)%nat -> P i t0 = 0) ->
  (0 < P n t0 -> exists d, 0 < d /\ forall t, t0 < t < t0 + d -> 0 < k * (v1 t - v2 t)) /\
  (P n t0 < 0 -> exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t).
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb H Ht0 Hd0 DU Cu Meet Hk Tie DP P0 Flat.
  assert (Part : forall d, 0 < d <= d0 -> forall t, t0 <= t < t0 + d -> rderiv U t (u t)) by (intros; apply DU; lra).
  split; intros Pn.
  - destruct (sign_stays t0 d0 Ht0 Hd0 P n DP 1 (or_introl eq_refl)) as (d & Hd & Sg); [lra|].
    apply (slips_at_edge m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u x v1 v2 s t0 d H Ht0 ltac:(lra) (Part d Hd) Meet k Hk
      Tie).
    intros t Ht. rewrite P0 by lra. rewrite <- (Rmult_1_l (P 0%nat t)).
    apply (all_below t0 P n DP Flat 1 d (or_introl eq_refl) Sg 0%nat ltac:(lia) t Ht).
  - destruct (sign_stays t0 d0 Ht0 Hd0 P n DP (-1) (or_intror eq_refl)) as (d & Hd & Sg); [lra|].
    apply (sticks_at_edge m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u x v1 v2 s t0 d H Ht0 ltac:(lra) (Part d Hd) Cu Meet k
      Hk Tie).
    intros r t Hr Ht. rewrite !P0 by lra. destruct n as [|m].
    + (* the tie itself says that the force asks b and no more *)
      exfalso. rewrite <- P0 in Pn by lra. assert (Mp : 0 < m1 + m2) by lra.
      replace (beyond m1 m2 a1 a2 b u x v1 t0 k t0) with ((m1 + m2) / m2 * (k * load m1 m2 a1 a2 u x v1 t0 - b)) in Pn
        by (unfold beyond, load; field; lra). rewrite Tie in Pn. lra.
    + destruct (Req_dec r t) as [->|N]; [lra|]. destruct (MVT_cor2 (P 0%nat) (P 1%nat) r t) as (c & Ec & Hc); [lra| |].
      { intros c _. apply is_derive_Reals, DP. }
      pose proof (all_below t0 P (S m) DP Flat (-1) d (or_intror eq_refl) Sg 1%nat ltac:(lia) c ltac:(lra)) as Pc.
      assert (0 < -1 * P 1%nat c * (t - r)) by positive. lra.
Qed.
