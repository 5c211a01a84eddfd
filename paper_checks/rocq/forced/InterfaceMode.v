(** The rule of the modes for an interface whose strength changes, with the strength from the time of the contact on; and
    with a strength that is constant by pieces events do not accumulate. *)
From InertialPair Require Import Dini Forced ForcedExistence Arcs ModeAtContact Analytic Modes BeforeContact
  FinitelyManyModes RuleOfModes Interface.

Section InterfaceMode.
Context (m1 m2 a1 a2 : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2).

(** a motion from a later time on *)
Lemma rubs_later b U x v1 v2 F t0 : 0 <= t0 -> rubs m1 m2 a1 a2 b U x v1 v2 F ->
  rubs m1 m2 a1 a2 (fun t => b (t0 + t)) (fun t => U (t0 + t)) (fun t => x (t0 + t)) (fun t => v1 (t0 + t))
    (fun t => v2 (t0 + t)) (fun t => F (t0 + t)).
Proof.
  intros Ht [Ca Sl CU Cx Cv CF X V W]. constructor; auto using cont_shift.
  - intros t Hs e He. destruct (Ca (t0 + t) ltac:(lra) e He) as (d & Hd & K). exists d. split; auto.
    intros h Hh. rewrite <- Rplus_assoc. auto.
  - intros t Hs k Hk G. apply rderiv_earlier, Sl; auto; lra.
  - intros t Hs. apply rderiv_earlier, X. lra.
  - intros t Hs. apply (rderiv_earlier (fun r => m1 * v1 r + F r - U r)), V. lra.
  - intros t Hs. rewrite (W (t0 + t)), (W (t0 + 0)) by lra. auto.
Qed.
(** while the strength is constant, a motion is one under a force with this friction *)
Lemma rubs_forced b U x v1 v2 F t0 d b0 : rubs m1 m2 a1 a2 b U x v1 v2 F -> 0 <= t0 -> 0 < d -> 0 < b0 ->
  (forall t, t0 <= t < t0 + d -> b t = b0) -> exists y w1 w2 s, forced m1 m2 a1 a2 b0 (fun t => U (t0 + t)) y w1 w2 s /\
  forall t, 0 <= t <= d -> y t = x (t0 + t) /\ w1 t = v1 (t0 + t) /\ w2 t = v2 (t0 + t).
Proof.
  intros H Ht0 Hd Hb0 Eb. pose proof (rubs_later b U x v1 v2 F t0 Ht0 H) as R.
  destruct (forced_existence m1 m2 a1 a2 b0 (x t0) (v1 t0) (v2 t0) (fun t => U (t0 + t)) Hm1 Hm2 Ha1 Ha2 Hb0
    (r_cU _ _ _ _ _ _ _ _ _ _ R)) as (y & w1 & w2 & s & Fo & Y0 & V0 & W0).
  exists y, w1, w2, s. split; [auto|]. intros t Ht.
  pose proof (forced_rubs m1 m2 a1 a2 b0 _ _ _ _ _ Hb0 Fo) as R0.
  assert (Q : energy m1 m2 a2 (y t - x (t0 + t)) (w1 t - v1 (t0 + t)) (w2 t - v2 (t0 + t))
    <= energy m1 m2 a2 (y 0 - x (t0 + 0)) (w1 0 - v1 (t0 + 0)) (w2 0 - v2 (t0 + 0))).
  { apply (dini_mono (fun t => energy m1 m2 a2 (y t - x (t0 + t)) (w1 t - v1 (t0 + t)) (w2 t - v2 (t0 + t)))).
    - exact (rubs_cD m1 m2 a1 a2 Hm2 _ _ _ _ _ _ _ _ _ _ _ _ R0 R).
    - lra.
    - intros u Hu. eapply dini_weaken; [|exact
        (interface_parts m1 m2 a1 a2 Hm1 Hm2 _ _ _ _ _ _ _ _ _ _ _ _ R0 R u 0
        ltac:(lra) (rderiv_same _ u))].
      cbv beta. rewrite Eb by lra. assert (0 <= a1 * (w1 u - v1 (t0 + u)) ^ 2) by positive. lra. }
  rewrite Y0, V0, W0, Rplus_0_r in Q. exact (energy_apart m1 m2 a2 Hm1 Hm2 Ha2 _ _ _ _ _ _ _ _ _ Q).
Qed.

(** [interface-rule] Where the strength $b$ is constant for a while from a contact on: stick for $|\Lambda|<b$, slip
    with the sign of $\Lambda$ for $|\Lambda|>b$, at $\Lambda=\pm b$ the first nonzero derivative, and stick at the
    edge where all are 0 and the force is analytic. *)
Theorem interface_rule b U u x v1 v2 F t0 d b0 : rubs m1 m2 a1 a2 b U x v1 v2 F -> 0 <= t0 -> 0 < d -> 0 < b0 ->
  (forall t, t0 <= t < t0 + d -> b t = b0 /\ rderiv U t (u t)) ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (u (t0 + h) - u t0) <= e) -> v1 t0 = v2 t0 ->
  let load := load m1 m2 a1 a2 u x v1 in
  let sticks := exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t in
  let slips k := exists d, 0 < d /\ forall t, t0 < t < t0 + d -> 0 < k * (v1 t - v2 t) in
  (Rabs (load t0) < b0 -> sticks) /\ forall k, k = 1 \/ k = -1 ->
  (b0 < k * load t0 -> slips k) /\ (k * load t0 = b0 ->
    (forall (P : nat -> R -> R) n, (forall i t, is_derive (P i) t (P (S i) t)) ->
      (forall t, t0 <= t < t0 + d -> beyond m1 m2 a1 a2 b0 u x v1 t0 k t = P 0%nat t) -> (forall i, (i < n)%nat -> P i t0 = 0) ->
      (0 < P n t0 -> slips k) /\ (P n t0 < 0 -> sticks)) /\
    (forall g, (forall t, t0 <= t < t0 + d -> u t = g t) -> analytic_at g t0 ->
      (forall n, Derive_n (beyond m1 m2 a1 a2 b0 g x v1 t0 k) n t0 = 0) ->
      exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t /\ k * load t = b0)).
Proof.
  intros H Ht0 Hd Hb0 On Cu Meet load sticks slips.
  destruct (rubs_forced b U x v1 v2 F t0 d b0 H Ht0 Hd Hb0 (fun t Ht => proj1 (On t Ht))) as (y & w1 & w2 & s & Fo & E).
  set (ut := fun t => u (t0 + t)). assert (DU : forall t, 0 <= t < 0 + d -> rderiv (fun t => U (t0 + t)) t (ut t)).
  { intros t Ht. apply rderiv_earlier, On. lra. }
  assert (Cu' : forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (ut (0 + h) - ut 0) <= e).
  { intros e He. destruct (Cu e He) as (q & Hq & K). exists q; split; auto. intros h Hh. unfold ut. rewrite Rplus_0_l, Rplus_0_r. auto. }
  destruct (E 0 ltac:(lra)) as (Y0 & W1 & W2). rewrite Rplus_0_r in Y0, W1, W2.
  assert (Meet' : w1 0 = w2 0) by lra.
  assert (Lo : forall t, 0 <= t <= d -> ModeAtContact.load m1 m2 a1 a2 ut y w1 t = load (t0 + t)).
  { intros t Ht. destruct (E t Ht) as (E1 & E2 & _). unfold load, ModeAtContact.load, ut. rewrite E1, E2. auto. }
  assert (L0 : ModeAtContact.load m1 m2 a1 a2 ut y w1 0 = load t0) by (rewrite Lo, Rplus_0_r by lra; auto).
  assert (St : (exists d, 0 < d /\ forall t, 0 <= t < 0 + d -> w1 t = w2 t) -> sticks).
  { intros (q & Hq & K). exists (Rmin q d). split; [positive|]. intros t Ht. pose proof (Rmin_l q d). pose proof (Rmin_r q d).
    specialize (K (t - t0) ltac:(lra)). destruct (E (t - t0) ltac:(lra)) as (_ & E1 & E2).
    replace (t0 + (t - t0)) with t in * by ring. lra. }
  assert (Sl : forall k, (exists d, 0 < d /\ forall t, 0 < t < 0 + d -> 0 < k * (w1 t - w2 t)) -> slips k).
  { intros k (q & Hq & K). exists (Rmin q d). split; [positive|]. intros t Ht. pose proof (Rmin_l q d). pose proof (Rmin_r q d).
    specialize (K (t - t0) ltac:(lra)). destruct (E (t - t0) ltac:(lra)) as (_ & E1 & E2).
    replace (t0 + (t - t0)) with t in * by ring. rewrite E1, E2 in K. auto. }
  assert (Be : forall g k t, beyond m1 m2 a1 a2 b0 (fun t => g (t0 + t)) y w1 0 k t = beyond m1 m2 a1 a2 b0 g x v1 t0 k (t0 + t)).
  { intros g k t. unfold beyond. rewrite Y0, W1. replace (t0 + t - t0) with (t - 0) by ring. auto. }
  split; [intros L; apply St; apply (sticks_at m1 m2 a1 a2 b0 Hm1 Hm2 Ha1 Ha2 _ ut y w1 w2 s 0 d Fo (Rle_refl 0) Hd DU Cu' Meet'); rewrite L0; auto|].
  intros k Hk. split; [intros L; apply Sl; apply (slips_at m1 m2 a1 a2 b0 Hm1 Hm2 Ha1 Ha2 Hb0 _ ut y w1 w2 s 0 d Fo (Rle_refl 0) Hd DU Cu' Meet' k Hk); rewrite L0; auto|].
  intros Tie. split.
  - intros P n DP EP Z. set (Pt := fun i t => P i (t0 + t)). assert (P0 : forall i, Pt i 0 = P i t0) by (intros i; unfold Pt; rewrite Rplus_0_r; auto).
    assert (DPt : forall i t, is_derive (Pt i) t (Pt (S i) t)).
    { intros i t. pose proof (DP i). unfold Pt. derive. ring. }
    pose proof (tie_rule m1 m2 a1 a2 b0 _ ut y w1 w2 s 0 d Pt n k Hm1 Hm2 Ha1 Ha2 Hb0 Fo (Rle_refl 0) Hd DU Cu' Meet' Hk) as T.
    rewrite L0, P0 in T. destruct T as (T1 & T2); auto.
    + intros t Ht. unfold ut. rewrite Be. apply EP. lra.
    + intros i Hi. rewrite P0. auto.
  - intros g Eg A Flat. destruct (marginal m1 m2 a1 a2 b0 Hm1 Hm2 Ha1 Ha2 Hb0 _ ut y w1 w2 s Fo 0 d (fun t => g (t0 + t)) k
      (Rle_refl 0) Hd DU) as (q & Hq & K); auto.
    + intros t Ht. apply Eg. lra.
    + apply analytic_shift. rewrite Rplus_0_r. auto.
    + intros n. rewrite (Derive_n_ext _ (fun t => beyond m1 m2 a1 a2 b0 g x v1 t0 k (t + t0))) by (intros t; rewrite Be, Rplus_comm; auto).
      rewrite Derive_n_comp_trans, Rplus_0_l. auto.
    + exists (Rmin q d). split; [positive|]. intros t Ht. pose proof (Rmin_l q d). pose proof (Rmin_r q d).
      destruct (K (t - t0) ltac:(lra)) as (K1 & K2 & _). destruct (E (t - t0) ltac:(lra)) as (_ & E1 & E2).
      rewrite Lo in K2 by lra. replace (t0 + (t - t0)) with t in * by ring. lra.
Qed.

(** [interface-no-zeno] Under a piecewise analytic force and with a strength $b>0$ that is constant on pieces,
    finitely many in every bounded time, every bounded time interval has finitely many mode changes. *)
Theorem interface_no_zeno b U u x v1 v2 F T : rubs m1 m2 a1 a2 b U x v1 v2 F -> (forall t, 0 <= t -> rderiv U t (u t)) ->
  piecewise_analytic u -> (forall t, 0 <= t -> exists c c' d, 0 < c /\ 0 < c' /\ 0 < d /\
    (forall r, t <= r < t + d -> b r = c) /\ (forall r, 0 <= r -> t - d < r < t -> b r = c')) -> 0 <= T ->
  finitely_many_modes v1 v2 0 T.
Proof.
  intros H DU A Pc HT.
  assert (Local : forall c t0 d, 0 <= t0 -> 0 < d -> 0 < c -> (forall r, t0 <= r < t0 + d -> b r = c) -> exists y w1 w2 s,
    forced m1 m2 a1 a2 c (fun t => U (t0 + t)) y w1 w2 s /\ (forall t, 0 <= t -> rderiv (fun t => U (t0 + t)) t (u (t0 + t))) /\
    forall t, 0 <= t <= d -> w1 t = v1 (t0 + t) /\ w2 t = v2 (t0 + t)).
  { intros c t0 d Ht0 Hd Hc E. destruct (rubs_forced b U x v1 v2 F t0 d c H Ht0 Hd Hc E) as (y & w1 & w2 & s & Fo & Eq).
    exists y, w1, w2, s. split; [exact Fo|]. split; [intros t Ht; apply rderiv_earlier, DU; lra|]. intros t Ht. apply Eq; auto. }
  assert (Shift : forall (w1 w2 : R -> R) t0 d p q, (forall t, 0 <= t <= d -> w1 t = v1 (t0 + t) /\ w2 t = v2 (t0 + t)) -> 0 <= p -> q <= d ->
    one_mode w1 w2 p q -> one_mode v1 v2 (t0 + p) (t0 + q)).
  { intros w1 w2 t0 d p q Eq Hp Hq [O|[O|O]]; [left|right; left|right; right]; intros t Ht; specialize (O (t - t0) ltac:(lra));
      destruct (Eq (t - t0) ltac:(lra)) as (E1 & E2); replace (t0 + (t - t0)) with t in * by ring; lra. }
  apply modes_by_compactness; auto; intros t Ht.
  - destruct (A t ltac:(lra)) as (f & g & d & Hd & _ & Ag & Eg & _). destruct (Pc t ltac:(lra)) as (c & _ & d' & Hc & _ & Hd' & Ec & _).
    destruct (Local c t d' ltac:(lra) Hd' Hc Ec) as (y & w1 & w2 & s & Fo & DU' & Eq).
    destruct (mode_after m1 m2 a1 a2 c Hm1 Hm2 Ha1 Ha2 Hc _ _ y w1 w2 s Fo DU' 0 (fun r => g (t + r)) d (Rle_refl 0) Hd) as (q & Hq & O).
    { apply analytic_shift. rewrite Rplus_0_r. auto. } { intros r Hr. apply Eg. lra. }
    exists (Rmin q d'). split; [positive|]. pose proof (Rmin_l q d'). pose proof (Rmin_r q d'). rewrite <- (Rplus_0_r t) at 1.
    apply (Shift w1 w2 t d'); auto; [lra|]. apply (one_mode_within w1 w2 0 (0 + q)); auto; lra.
  - destruct (A t ltac:(lra)) as (f & g & d & Hd & Af & _ & _ & Ef). destruct (Pc t ltac:(lra)) as (_ & c & d' & _ & Hc & Hd' & _ & Ec).
    set (l := Rmin (d' / 2) t). assert (Hl : 0 < l) by positive. pose proof (Rmin_l (d' / 2) t). pose proof (Rmin_r (d' / 2) t). fold l in H0, H1.
    destruct (Local c (t - l) l ltac:(lra) Hl Hc) as (y & w1 & w2 & s & Fo & DU' & Eq). { intros r Hr. apply Ec; lra. }
    assert (End : t - l + l = t) by ring. destruct (Eq l ltac:(lra)) as (E1 & E2). rewrite End in E1, E2.
    assert (B : exists q, 0 < q <= l /\ one_mode w1 w2 (l - q) l).
    { destruct (Req_dec (w1 l) (w2 l)) as [Meet|Apart].
      - destruct (mode_before m1 m2 a1 a2 c Hm1 Hm2 Ha1 Ha2 Hc _ _ y w1 w2 s Fo DU' l Hl Meet (fun r => f (t - l + r)) d Hd) as (q & Hq & O).
        { apply analytic_shift. rewrite End. auto. } { intros r Hr0 Hr. apply Ef; lra. }
        exists (Rmin q l). pose proof (Rmin_l q l). pose proof (Rmin_r q l). split; [split; [positive|lra]|].
        apply (one_mode_within w1 w2 (l - q) l); auto; lra.
      - pose proof (cont_w m1 m2 a1 a2 c Hm2 _ y w1 w2 s Fo) as Cw. destruct (apart_nearby w1 w2 l Cw ltac:(lra) Apart) as (q & Hq & K).
        exists (Rmin q l). pose proof (Rmin_l q l). pose proof (Rmin_r q l). split; [split; [positive|lra]|].
        apply no_zero_one_sign; [exact Cw|lra|]. intros r Hr. apply K; [lra|]. rewrite Rabs_left; lra. }
    destruct B as (q & Hq & O). exists q. split; [lra|]. replace (t - q) with (t - l + (l - q)) by ring. rewrite <- End at 2.
    apply (Shift w1 w2 (t - l) l); auto; lra.
Qed.
End InterfaceMode.
