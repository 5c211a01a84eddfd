(** The pair beside a stuck motion that needs at most the share rho < 1 of friction: its slide is paid for by the energy
    distance. Then, without a damper: under F sin (om t), F < F*, every motion tends to one stuck motion. *)
From InertialPair Require PeriodicMotion.
From InertialPair Require Import Dini PaidRates Pair Stick TurnedFrame Pursuit Forced EnergyLimit Interface Entrainment.

Section Slide.
Context (m1 m2 a1 a2 b rho : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Variables U x v1 v2 s y v r : R -> R.
Hypotheses (H : forced m1 m2 a1 a2 b U x v1 v2 s) (H' : forced m1 m2 a1 a2 b U y v v r)
  (Easy : forall p q, 0 <= p <= q -> Rabs (r q - r p) <= rho * (q - p)).
Let w t := v1 t - v2 t.
Let D t := energy m1 m2 a2 (x t - y t) (v1 t - v t) (v2 t - v t).

(** D' <= - b (1 - rho) |w|: the motion's friction takes b |w|, the other's gives back at most rho of it *)
Lemma D_falls t : 0 <= t -> dini_le D t (- (b * (1 - rho) * Rabs (w t))).
Proof.
  intros Ht. eapply dini_weaken; [|exact (interface_parts m1 m2 a1 a2 Hm1 Hm2 _ _ _ _ _ _ _ _ _ _ _ _
    (forced_rubs _ _ _ _ b _ _ _ _ _ Hb H) (stuck_rubs _ _ _ _ b rho _ _ _ _ Hb H' Easy) t 0 Ht (rderiv_same U t))].
  cbv beta. rewrite (Rminus_diag_eq (v t)), Rabs_R0 by auto. assert (0 <= a1 * (v1 t - v t) ^ 2) by positive.
  unfold w. lra.
Qed.

(** *** the slide bound: b (1 - rho) times the path of the slip is at most the energy distance that is lost *)
Theorem slide p q : 0 <= p <= q -> b * (1 - rho) * (integral (fun t => Rabs (w t)) q - integral (fun t => Rabs (w t)) p)
  <= D p - D q.
Proof.
  apply (path_paid D (b * (1 - rho)) (fun t => Rabs (w t))); [|continuous|exact D_falls].
  exact (moves_cD _ _ _ _ _ Hm2 _ _ _ _ _ _ _ _ _ _ H H').
Qed.
End Slide.

(** *** Without a damper: every motion under F sin (om t), F < F*, tends to one stuck motion *)
Section Undamped.
Variables m1 m2 a2 b F om : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (HF : 0 <= F) (Hom : 0 < om)
  (HZ : 0 < Z m1 m2 0 a2 om) (Low : F < Fstar m1 m2 0 a2 b om).
Context (x v1 v2 s : R -> R) (H : forced m1 m2 0 a2 b (drive F om) x v1 v2 s).
Let M := m1 + m2.
Let Om := omega m1 m2 a2.
Let y := rX m1 m2 0 a2 F om.
Let v := rV m1 m2 0 a2 F om.
Let rho := F / Fstar m1 m2 0 a2 b om.
Let dx t := x t - y t.
Let d1 t := v1 t - v t.
Let d2 t := v2 t - v t.
Let w t := d1 t - d2 t.
Let D t := energy m1 m2 a2 (dx t) (d1 t) (d2 t).
Let P t := m1 * d1 t + m2 * d2 t.

Let M_pos : 0 < M. Proof. unfold M; lra. Qed.
Let Om_pos : 0 < Om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2.
Let Om_sq : Om * Om = a2 / M := omega_sq m1 m2 a2 Hm1 Hm2 Ha2.
Let Stuck : forced m1 m2 0 a2 b (drive F om) y v v (fun t => m2 / b * v t).
Proof. apply entrained; auto. lra. Qed.

(** the stuck response needs the share F / F* of friction *)
Lemma share p q : 0 <= p <= q -> Rabs (m2 / b * v q - m2 / b * v p) <= rho * (q - p).
Proof.
  intros Hp. pose proof (sqrt_lt_R0 _ HZ) as Sz. assert (O2 : 0 < om ^ 2) by nra.
  apply (lip_of_rderiv (fun t => m2 / b * v t) (fun t => m2 / b * (- om ^ 2 * y t))); auto.
  { apply cont_scal. eapply cont_of_derive; intros; apply derive_rV. }
  split; [apply rderiv_scal, rderiv_of_derive, derive_rV|].
  replace rho with (m2 / b * (om ^ 2 * (F / sqrt (Z m1 m2 0 a2 om)))) by (unfold rho, Fstar; field; repeat split; lra).
  apply abs_scal; [positive|]. rewrite <- Ropp_mult_distr_l, Rabs_Ropp. apply abs_scal; [lra|]. apply rX_bound; auto.
Qed.

(** that share is less than all of it *)
Lemma share_below : 0 <= rho < 1.
Proof.
  assert (0 < Fstar m1 m2 0 a2 b om) by lra. unfold rho. split; [positive|].
  apply Rmult_lt_reg_r with (Fstar m1 m2 0 a2 b om); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Let del := b * (1 - rho).
Let del_pos : 0 < del. Proof. pose proof share_below. apply Rmult_lt_0_compat; lra. Qed.

(** the distance falls at the rate delta |w| at least *)
Lemma D_pays t : 0 <= t -> dini_le D t (- (del * Rabs (w t))).
Proof.
  intros Ht. replace (w t) with (v1 t - v2 t) by (unfold w, d1, d2; ring).
  exact (D_falls m1 m2 0 a2 b rho Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ H Stuck share t Ht).
Qed.
Lemma D_mono p q : 0 <= p <= q -> D q <= D p.
Proof. exact (forced_contraction m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ _ p q H Stuck). Qed.

(** the common momentum, less that of the response, feels the spring alone *)
Lemma momentum_rate t : 0 <= t -> rderiv P t (- a2 * dx t).
Proof.
  intros Ht. apply rderiv_ext with (fun q => (m1 * v1 q + m2 * v2 q - drive F om q)
    - (m1 * v q + m2 * v q - drive F om q)).
  { intros. unfold P, d1, d2. ring. }
  pose proof (momentum _ _ _ _ _ _ _ _ _ _ t H Ht). pose proof (momentum _ _ _ _ _ _ _ _ _ _ t Stuck Ht).
  rate. unfold dx. ring.
Qed.

(** the relative velocity is Lipschitz, as all forces stay bounded *)
Lemma relative_lip : exists K, 0 < K /\ forall p q, 0 <= p <= q -> Rabs (w q - w p) <= K * (q - p).
Proof.
  set (X0 := sqrt (2 * D 0 / a2)). set (Y0 := F / sqrt (Z m1 m2 0 a2 om)).
  assert (Hx : forall t, 0 <= t -> Rabs (x t) <= Y0 + X0).
  { intros t Ht. replace (x t) with (y t + dx t) by (unfold dx; ring). eapply Rle_trans; [apply Rabs_triang|].
    apply Rplus_le_compat; [apply rX_bound; auto|].
    apply (energy_within m1 m2 a2 Hm1 Hm2 Ha2 _ _ _ _ (D_mono 0 t ltac:(lra))). }
  exists (/ m1 * (a2 * (Y0 + X0) + F + b) + / m2 * b). split.
  { assert (0 <= / m1 * (a2 * (Y0 + X0) + F + b)) by positive. assert (0 < / m2 * b) by positive. lra. }
  intros p q Hp. replace (w q - w p) with ((v1 q - v2 q) - (v1 p - v2 p)) by (unfold w, d1, d2; ring).
  apply (slip_lip m1 m2 0 a2 Hm1 Hm2 (fun _ => b) (drive F om) x v1 v2 _ (a2 * (Y0 + X0)) F b (forced_rubs _ _ _ _ b _ _ _ _ _ Hb H)); auto.
  - split; [|lra]. replace (a2 * x t + 0 * v1 t) with (a2 * x t) by ring. apply abs_scal; [lra|auto].
  - apply drive_lip; auto.
Qed.

(** the response and a free oscillation of the pair beside it: its place *)
Let yX x0 v0 t := y t + X m1 m2 a2 x0 v0 t.
(** and its speed *)
Let yV x0 v0 t := v t + V m1 m2 a2 x0 v0 t.

(** the motion tends to one of these *)
Lemma tends : exists x0 v0, forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
  energy m1 m2 a2 (x t - yX x0 v0 t) (v1 t - yV x0 v0 t) (v2 t - yV x0 v0 t) <= e.
Proof.
  assert (Cx : cont dx) by continuous. assert (C1 : cont d1) by continuous. assert (C2 : cont d2) by continuous.
  destruct relative_lip as (K & HK & Lip).
  destruct (tends m1 m2 a2 del Hm1 Hm2 Ha2 del_pos dx d1 d2 Cx C1 C2
    (fun t Ht => rderiv_minus _ _ _ _ _ (f_x _ _ _ _ _ _ _ _ _ _ H t Ht) (f_x _ _ _ _ _ _ _ _ _ _ Stuck t Ht)) momentum_rate D_pays
    (slip_vanishes m1 m2 a2 del Hm1 Hm2 Ha2 del_pos dx d1 d2 Cx C1 C2 D_pays K HK Lip)) as (x0 & v0 & To & _).
  exists x0, v0. intros e He. destruct (To e He) as (T & HT & Q). exists T. split; auto. intros t Ht. specialize (Q t Ht).
  eapply Rle_trans; [right|exact Q]. unfold yX, yV, dx, d1, d2. f_equal; ring.
Qed.

(** the speed of a free oscillation: bounded by its state at any time, and by it what it is from then on *)
Lemma speed_below p q t : Rabs (V m1 m2 a2 p q t) <= Rabs q + Om * Rabs p.
Proof.
  unfold V. fold Om. eapply Rle_trans; [apply Rabs_triang|].
  rewrite Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq Om) by lra.
  assert (0 <= Om * Rabs p) by (pose proof (Rabs_pos p); positive). pose proof (Rabs_pos q).
  assert (Rabs q * Rabs (cos (Om * t)) <= Rabs q * 1) by (scale; apply Rabs_le, COS_bound).
  assert (Om * Rabs p * Rabs (sin (Om * t)) <= Om * Rabs p * 1) by (scale; apply Rabs_le, SIN_bound). lra.
Qed.
Lemma speed_later p q r t : V m1 m2 a2 p q (t + r) = V m1 m2 a2 (X m1 m2 a2 p q r) (V m1 m2 a2 p q r) t.
Proof. unfold V, X. fold Om. rewrite Rmult_plus_distr_l, cos_plus, sin_plus. field. lra. Qed.

(** after some number of the force's periods, as late as one likes, the stuck motion nearly repeats itself:
    the states of the free oscillation then come near to some state again and again *)
Lemma nearly_repeats x0 v0 e N : 0 < e -> exists n, (N <= n)%nat /\ forall t, 0 <= t ->
  Rabs (yV x0 v0 (t + INR n * (2 * PI / om)) - yV x0 v0 t) <= e.
Proof.
  intros He. set (per := 2 * PI / om). set (p n := X m1 m2 a2 x0 v0 (INR n * per)).
  set (q n := V m1 m2 a2 x0 v0 (INR n * per)).
  assert (B : forall t, Rabs (X m1 m2 a2 x0 v0 t) <= sqrt (2 * energy m1 m2 a2 x0 v0 v0 / a2)).
  { intros t. apply (energy_within m1 m2 a2 Hm1 Hm2 Ha2 _ _ _ _
      (Req_le _ _ (ellipse_energy m1 m2 a2 Hm1 Hm2 Ha2 x0 v0 t))). }
  set (C := sqrt (2 * energy m1 m2 a2 x0 v0 v0 / a2) + (Rabs v0 + Om * Rabs x0)).
  destruct (PeriodicMotion.cluster p q (fun _ => 0) C) as (y0 & w0 & z0 & Near).
  { intros n. pose proof (B (INR n * per)). pose proof (speed_below x0 v0 (INR n * per)).
    pose proof (Rabs_pos (p n)). pose proof (Rabs_pos (q n)). fold (p n) (q n) in *. rewrite Rabs_R0.
    unfold C. lra. }
  set (d := e / (2 * (1 + Om))). assert (Hd : 0 < d) by positive.
  destruct (Near d 0%nat Hd) as (i & _ & I1 & I2 & _), (Near d (i + N)%nat Hd) as (j & Hj & J1 & J2 & _).
  exists (j - i)%nat. split; [lia|]. intros t _. unfold yV, v. rewrite rV_period, minus_INR by (auto; lia).
  replace (_ + _ - _) with (V m1 m2 a2 (p j - p i) (q j - q i) (t - INR i * per)).
  - eapply Rle_trans; [apply speed_below|]. apply Rabs_def2 in I1, I2, J1, J2.
    assert (Rabs (q j - q i) <= 2 * d) by (apply Rabs_le; lra).
    assert (Rabs (p j - p i) <= 2 * d) by (apply Rabs_le; lra).
    assert (Om * Rabs (p j - p i) <= Om * (2 * d)) by scale.
    assert (2 * d * (1 + Om) = e) by (unfold d; field; lra). lra.
  - transitivity (V m1 m2 a2 (p j) (q j) (t - INR i * per) - V m1 m2 a2 (p i) (q i) (t - INR i * per));
      [unfold V; ring|].
    unfold p, q. rewrite <- !speed_later. fold per. replace (t - INR i * per + INR i * per) with t by ring.
    replace (t - INR i * per + INR j * per) with (t + (INR j - INR i) * per) by ring. ring.
Qed.

(** so what the motion tends to asks for no more than b, and is a motion *)
Lemma limit_moves x0 v0 : (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x t - yX x0 v0 t) (v1 t - yV x0 v0 t) (v2 t - yV x0 v0 t) <= e) ->
  forced m1 m2 0 a2 b (drive F om) (yX x0 v0) (yV x0 v0) (yV x0 v0) (fun t => m2 / b * yV x0 v0 t).
Proof.
  intros To. assert (DX : forall t, is_derive (yX x0 v0) t (yV x0 v0 t)).
  { intros t. apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)); [apply derive_rX; auto|apply derive_X; auto]. }
  assert (DV : forall t, is_derive (yV x0 v0) t (- om ^ 2 * y t + - (Om * Om) * X m1 m2 a2 x0 v0 t)).
  { intros t. apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)); [apply derive_rV; auto|apply derive_V; auto]. }
  apply stuck_forced; auto.
  - apply (f_cU _ _ _ _ _ _ _ _ _ _ H).
  - eapply cont_of_derive; exact DX.
  - intros; apply rderiv_of_derive, DX.
  - intros t Ht. apply rderiv_eq with (M * (- om ^ 2 * y t + - (Om * Om) * X m1 m2 a2 x0 v0 t) - F * sin (om * t)).
    { pose proof (balance m1 m2 0 a2 F om HZ t) as Q. fold M in Q. fold y in Q.
      rewrite Om_sq. unfold yX. rewrite <- Q. field. lra. }
    apply rderiv_minus; [apply rderiv_scal|]; apply rderiv_of_derive; [apply DV|apply derive_drive; auto].
  - intros p q Hp. apply le_epsilon. intros e He.
    destruct (energy_close m1 m2 a2 Hm1 Hm2 Ha2 (e / 4) ltac:(lra)) as (E & HE & Small).
    destruct (To E HE) as (T & HT & Near).
    assert (Close : forall t, T <= t -> Rabs (v2 t - yV x0 v0 t) <= e / 4)
      by (intros t Ht; apply (Small _ _ _ (Near t Ht))).
    pose proof PI_RGT_0. assert (Pp : 0 < 2 * PI / om) by positive.
    destruct (nat_above T (2 * PI / om) Pp) as (N & HN).
    destruct (nearly_repeats x0 v0 (e / 4) N ltac:(lra)) as (n & Hn & Rep). set (S := INR n * (2 * PI / om)) in *.
    assert (HS : T <= S).
    { apply le_INR in Hn. assert (INR N * (2 * PI / om) <= S) by (apply Rmult_le_compat_r; lra). lra. }
    pose proof (Rep p ltac:(lra)) as E1. pose proof (Rep q ltac:(lra)) as E2.
    pose proof (Close (p + S) ltac:(lra)) as C1. pose proof (Close (q + S) ltac:(lra)) as C2.
    pose proof (only_gentle m1 m2 0 a2 b Hm2 Hb _ _ _ _ _ (p + S) (q + S) H ltac:(lra)) as G. by_sizes.
Qed.

(** *** a1 = 0, F < F*: the path of the slip is at most the energy distance from the stuck response over b times the unused share of F*,
    and the motion tends to one that sticks for ever *)

(** [undamped-entrained] With $a_1=0$ every motion under a sinusoidal force of amplitude below $U_*$ tends to one that
    sticks permanently, and $\int|\dot z|\,dt$ is at most the energy distance from the stuck response at $t=0$ over
    $b\,(1-U/U_{*})$. *)
Theorem undamped_entrained :
  (forall t, 0 <= t -> b * (1 - F / Fstar m1 m2 0 a2 b om) * integral (fun q => Rabs (v1 q - v2 q)) t <=
    energy m1 m2 a2 (x 0 - rX m1 m2 0 a2 F om 0) (v1 0 - rV m1 m2 0 a2 F om 0) (v2 0 - rV m1 m2 0 a2 F om 0)) /\
  exists p q r, forced m1 m2 0 a2 b (drive F om) p q q r /\ forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x t - p t) (v1 t - q t) (v2 t - q t) <= e.
Proof.
  split.
  - intros t Ht. pose proof (slide m1 m2 0 a2 b rho Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ H Stuck share 0 t
      ltac:(lra)) as Q. rewrite integral_0, Rminus_0_r in Q.
    eapply Rle_trans; [exact Q|]. pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x t - y t) (v1 t - v t) (v2 t - v t)).
    unfold y, v in *. lra.
  - destruct tends as (x0 & v0 & To). exists (yX x0 v0), (yV x0 v0), (fun t => m2 / b * yV x0 v0 t).
    split; [exact (limit_moves x0 v0 To)|exact To].
Qed.
End Undamped.
