(** Capture under a force: once the friction that sticking needs stays below b by a margin, the pair sticks after a
    bounded time and for ever. Then: a1 > 0, F < F*: every motion under F sin (om t) sticks for ever and tends to the
    response. *)
From InertialPair Require Import Dini Pair Pursuit Forced Entrainment BoundedMotions.

Section Catch.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let kap := M / (m1 * m2).
Variables U u x v1 v2 s : R -> R.
Variables T g : R.
Hypotheses (H : forced m1 m2 a1 a2 b U x v1 v2 s) (HU : forall t, 0 <= t -> rderiv U t (u t)) (HT : 0 <= T) (Hg : 0 < g)
  (Load : forall t, T <= t -> Rabs (m2 * (u t - a2 * x t - a1 * v1 t) / M) <= b - g).
Let w t := v1 t - v2 t.

(** off contact |w| falls at the rate kappa g at least *)
Lemma slip_falls t k : T <= t -> k = 1 \/ k = -1 -> 0 < k * w t -> dini_le (fun r => k * w r) t (- (kap * g)).
Proof.
  intros Ht Hk Hw. assert (Mp : 0 < M) by positive. assert (Kp : 0 < kap) by positive.
  pose proof (q_slip m1 m2 a1 a2 b _ U x v1 v2 s H t ltac:(lra) k Hk Hw) as S. pose proof (Load t Ht) as L.
  eapply rderiv_dini; [|apply rderiv_scal, (moves_rate m1 m2 a1 a2 b Hm1 Hm2 _ U x v1 v2 s H t (u t) k ltac:(lra) (HU t
    ltac:(lra)) S)].
  fold M. fold kap. set (l := m2 * (u t - a2 * x t - a1 * v1 t) / M) in *. apply Rabs_inv in L.
  replace (k * (kap * (l - b * k))) with (kap * (k * l - b)) by (destruct Hk; subst k; ring).
  rewrite <- Ropp_mult_distr_r_reverse. apply Rmult_le_compat_l; [lra|]. destruct Hk; subst k; lra.
Qed.

(** while it slips, |v1 - v2| falls at least at a fixed rate *)
Theorem catch t : T + Rabs (w T) / (kap * g) <= t -> v1 t = v2 t.
Proof.
  intros Ht. assert (0 < kap) by (unfold kap, M; positive). assert (0 < kap * g) by positive.
  pose proof (Rabs_pos (w T)).
  assert (0 <= Rabs (w T) / (kap * g)) by positive. assert (Start : Rabs (w T) <= kap * g * (t - T)).
  { replace (Rabs (w T)) with (kap * g * (Rabs (w T) / (kap * g))) by (field; lra). scale. }
  assert (Key : forall k, k = 1 \/ k = -1 -> k * w t <= 0).
  { intros k Hk. cut (k * w t + kap * g * (t - t) <= 0); [lra|].
    apply (barrier_until (fun r => k * w r + kap * g * (r - t)) 0 T t); [continuous|lra| |].
    - pose proof (Rle_abs (k * w T)). rewrite Rabs_sign in * by auto. lra.
    - intros r Hr Up. assert (0 < kap * g * (t - r)) by (apply Rmult_lt_0_compat; lra).
      eassert (R : rderiv (fun r => kap * g * (r - t)) r _) by rates.
      eapply dini_eq; [|exact (dini_plus _ _ _ _ _ (slip_falls r k ltac:(lra) Hk ltac:(lra)) R)]. lra. }
  pose proof (Key 1 ltac:(auto)). pose proof (Key (-1) ltac:(auto)). unfold w in *. lra.
Qed.
End Catch.

Section Sync.
Variables m1 m2 a1 a2 b F om : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b) (HF : 0 <= F) (Hom : 0 < om).
Let M := m1 + m2.

Lemma Z_pos : 0 < Z m1 m2 a1 a2 om.
Proof. unfold Z. assert (0 < a1 * om) by positive.
  pose proof (pow2_ge_0 (a2 - (m1 + m2) * om ^ 2)). assert (0 < (a1 * om) ^ 2) by nra. lra. Qed.

(** [entrains] With $a_1>0$ every motion tends to the stuck response to a sinusoidal force of amplitude up to $U_*$.
    *)
Theorem entrains x v1 v2 s : F <= Fstar m1 m2 a1 a2 b om -> forced m1 m2 a1 a2 b (drive F om) x v1 v2 s ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
  energy m1 m2 a2 (x t - rX m1 m2 a1 a2 F om t) (v1 t - rV m1 m2 a1 a2 F om t) (v2 t - rV m1 m2 a1 a2 F om t) <= e.
Proof.
  intros HS H. pose proof Z_pos as HZ.
  exact (approach m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ F H (entrained m1 m2 a1 a2 b F om Hm2 Hb HF
    Hom HZ HS) HF (drive_lip F om HF Hom)).
Qed.

(** [synchronises] With $a_1>0$ every motion under a sinusoidal force of amplitude below $U_*$ sticks permanently
    after a finite time. *)
Theorem synchronises x v1 v2 s : F < Fstar m1 m2 a1 a2 b om -> forced m1 m2 a1 a2 b (drive F om) x v1 v2 s ->
  exists T, 0 <= T /\ forall t, T <= t -> v1 t = v2 t.
Proof.
  intros HS H. pose proof Z_pos as HZ. pose proof (sqrt_lt_R0 _ HZ) as Sz. assert (O2 : 0 < om ^ 2) by nra.
    assert (Mp : 0 < M) by positive.
  set (R0 := F / sqrt (Z m1 m2 a1 a2 om)).
    assert (Q : 0 < om ^ 2 / sqrt (Z m1 m2 a1 a2 om)) by positive.
  assert (Bl : om ^ 2 * R0 < b / m2).
  { replace (om ^ 2 * R0) with (om ^ 2 / sqrt (Z m1 m2 a1 a2 om) * F) by (unfold R0; field; lra).
    replace (b / m2) with (om ^ 2 / sqrt (Z m1 m2 a1 a2 om) * Fstar m1 m2 a1 a2 b om) by (unfold Fstar; field;
      lra). scale. }
  apply Rmult_lt_compat_l with (r := m2) in Bl; auto. replace (m2 * (b / m2)) with b in Bl by (field; lra).
  set (g := (b - m2 * (om ^ 2 * R0)) / 2). assert (Hg : 0 < g) by (unfold g; lra).
  set (d := M * g / m2 / (a1 + a2)). assert (Hd : 0 < d) by (unfold d; repeat apply Rdiv_lt_0_compat; nra).
  destruct (energy_close m1 m2 a2 Hm1 Hm2 Ha2 d Hd) as (e & He & Small).
  destruct (entrains x v1 v2 s ltac:(lra) H e He) as (T & HT & Near).
  exists (T + Rabs (v1 T - v2 T) / (M / (m1 * m2) * g)). split.
  { assert (0 < M / (m1 * m2) * g) by positive. assert (0 <= Rabs (v1 T - v2 T) / (M / (m1 * m2) * g)); [|lra].
      apply Rmult_le_pos; [apply Rabs_pos|positive]. }
  apply (catch m1 m2 a1 a2 b Hm1 Hm2 (drive F om) (fun t => F * sin (om * t)) x v1 v2 s T g H); auto.
  { intros; apply rderiv_of_derive, derive_drive; auto. }
  intros t Ht. cbv beta. fold M. destruct (Small _ _ _ (Near t Ht)) as (By & Bp & _).
  set (y := x t - rX m1 m2 a1 a2 F om t) in *. set (p := v1 t - rV m1 m2 a1 a2 F om t) in *.
  pose proof (balance m1 m2 a1 a2 F om HZ t) as Ba. pose proof (rX_bound m1 m2 a1 a2 F om HF HZ t) as BX. fold R0 in BX.
  replace (m2 * (F * sin (om * t) - a2 * x t - a1 * v1 t) / M) with (- (m2 * (om ^ 2 * rX m1 m2 a1 a2 F om t) + m2
    / M * (a2 * y + a1 * p))) by (rewrite <- Ba; unfold y, p, M; field; lra).
  rewrite Rabs_Ropp. eapply Rle_trans; [apply Rabs_triang|].
  pose proof (abs_scal m2 _ _ ltac:(lra) (abs_scal (om ^ 2) _ _ ltac:(lra) BX)) as N1.
  assert (N2 : Rabs (m2 / M * (a2 * y + a1 * p)) <= m2 / M * ((a1 + a2) * d)).
  { apply abs_scal; [positive|]. eapply Rle_trans; [apply Rabs_triang|].
    pose proof (abs_scal a2 _ _ ltac:(lra) By). pose proof (abs_scal a1 _ _ ltac:(lra) Bp). lra. }
  replace (m2 / M * ((a1 + a2) * d)) with g in N2 by (unfold d; field; lra). unfold g in *. lra.
Qed.
End Sync.
