(** Which mode follows at a contact v1 = v2, right after t0: with the load m2 (u - a2 x - a1 v1)/M,
  the friction that sticking
    needs, the pair sticks if the load is within b, and slips with the load's sign if it is beyond b.
      The force need only be known
    from t0 on, for a while, and be continuous from the right at t0: a jump at t0 decides with its later value. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick Existence Forced Response Bounded Arcs.
Local Open Scope R_scope.

Section Mode.
Variables m1 m2 a1 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let kap := M / (m1 * m2).
Variables U u x v1 v2 s : R -> R.
Variables t0 d0 : R.
Hypotheses (H : forced m1 m2 a1 a2 b U x v1 v2 s) (Ht0 : 0 <= t0) (Hd0 : 0 < d0)
  (DU : forall t, t0 <= t < t0 + d0 -> rderiv U t (u t))
  (Cu : forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (u (t0 + h) - u t0) <= e)
  (Meet : v1 t0 = v2 t0).
Let w t := v1 t - v2 t.
(** the load *)
Definition load t := m2 * (u t - a2 * x t - a1 * v1 t) / (m1 + m2).

(** it is continuous from the right *)
Lemma load_near e : 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (load (t0 + h) - load t0) <= e.
Proof.
  intros He. assert (Mp : 0 < M) by (unfold M; lra). set (k := 1 + a2 + a1). assert (Kp : 0 < k) by (unfold k; lra).
  set (e' := M / m2 * e / k). assert (He' : 0 < e').
  { apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. apply Rdiv_lt_0_compat; auto. }
  destruct (Cu e' He') as (d1 & D1 & K1). destruct (f_cx _ _ _ _ _ _ _ _ _ _ H t0 Ht0 e' He') as (d2 & D2 & K2).
  destruct (f_cv _ _ _ _ _ _ _ _ _ _ H t0 Ht0 e' He') as (d3 & D3 & K3).
  exists (Rmin d1 (Rmin d2 d3)). pose proof (Rmin_l d1 (Rmin d2 d3)). pose proof (Rmin_r d1 (Rmin d2 d3)).
  pose proof (Rmin_l d2 d3). pose proof (Rmin_r d2 d3). split; [repeat apply Rmin_glb_lt; auto|]. intros h Hh.
  specialize (K1 h ltac:(lra)). assert (Dh : Rabs (t0 + h - t0) < Rmin d2 d3) by (rewrite Rabs_pos_eq; lra).
  specialize (K2 (t0 + h) ltac:(lra) ltac:(lra)). specialize (K3 (t0 + h) ltac:(lra) ltac:(lra)).
  set (du := u (t0 + h) - u t0) in *. set (dx := x (t0 + h) - x t0) in *. set (dv := v1 (t0 + h) - v1 t0) in *.
  replace (load (t0 + h) - load t0) with (m2 / M * (du - a2 * dx - a1 * dv)) by (unfold load, du, dx, dv, M; field;
    unfold M in Mp; lra).
  replace e with (m2 / M * (k * e')) by (unfold e'; field; unfold k in *; lra).
  apply abs_scal; [apply Rlt_le, Rdiv_lt_0_compat; auto|]. apply Rabs_inv in K1. apply Rabs_def2 in K2.
    apply Rabs_def2 in K3.
  unfold k. apply Rabs_le. split; nra.
Qed.

(** how the relative velocity changes: by the load, and by friction *)
Lemma rate_w t : t0 <= t < t0 + d0 ->
  little (fun h => w (t + h) - w t - kap * load t * h + b * kap * (s (t + h) - s t)).
Proof.
  intros Ht. pose proof (f_v1 _ _ _ _ _ _ _ _ _ _ H t ltac:(lra)) as V. pose proof (DU t Ht) as D. unfold rderiv in V,
    D.
  intros e He. destruct (little_scal (/ m1) _ (little_plus _ _ V D) e He) as (d & Hd & K). exists d. split; auto.
    intros h Hh.
  specialize (K h Hh). cbv beta in K. eapply Rle_trans; [apply Req_le|exact K]. f_equal.
  pose proof (forced_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ t (t + h) H ltac:(lra) ltac:(lra)) as E.
  unfold w. replace (v2 (t + h)) with (v2 t + b / m2 * (s (t + h) - s t)) by lra. unfold kap, load, M. field.
    repeat split; lra.
Qed.

(** kappa is positive *)
Lemma kappa_pos : 0 < kap.
Proof. unfold kap, M. apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; auto]. Qed.

(** beyond b by g the relative velocity is driven at the rate kappa g at least, whatever friction does *)
Lemma driven t k g : t0 <= t < t0 + d0 -> k = 1 \/ k = -1 -> b + g <= k * load t ->
  dini_le (fun r => -1 * (k * w r)) t (- (kap * g)).
Proof.
  intros Ht Hk G e He. pose proof kappa_pos as Kp. destruct (rate_w t Ht e He) as (d & Hd & K). exists d. split; auto.
    intros h Hh.
  specialize (K h Hh). apply Rabs_inv in K. pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H t (t + h) ltac:(lra)) as L.
    apply Rabs_inv in L.
  set (ds := s (t + h) - s t) in *. set (dw := w (t + h) - w t) in *.
  assert (Ds : k * ds <= h) by (destruct Hk; subst k; lra).
  assert (F : b * kap * (k * ds) <= b * kap * h) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra).
  assert (G' : kap * (b + g) * h <= kap * (k * load t) * h) by (apply Rmult_le_compat_r; [lra|];
    apply Rmult_le_compat_l; lra).
  replace (-1 * (k * w (t + h)) - -1 * (k * w t)) with (- (k * dw)) by (unfold dw; ring).
  assert (Q : - (e * h) <= k * (dw - kap * load t * h + b * kap * ds)) by (destruct Hk; subst k; lra). lra.
Qed.

(** within b, friction brings the relative velocity back *)
Lemma held t k : t0 <= t < t0 + d0 -> k = 1 \/ k = -1 -> k * load t <= b -> 0 < k * w t ->
  dini_le (fun r => k * w r) t 0.
Proof.
  intros Ht Hk G W e He. pose proof kappa_pos as Kp. unfold w in W.
  assert (S : rderiv s t k) by (destruct Hk; subst k; [apply (f_pos _ _ _ _ _ _ _ _ _ _ H)|apply (f_neg _ _ _ _ _ _ _
    _ _ _ H)]; lra).
  destruct (little_minus _ _ (rate_w t Ht) (little_scal (b * kap) _ S) e He) as (d & Hd & K). exists d. split; auto.
    intros h Hh.
  specialize (K h Hh). cbv beta in K. apply Rabs_inv in K.
  assert (G' : kap * (k * load t) * h <= kap * b * h) by (apply Rmult_le_compat_r; [lra|]; apply Rmult_le_compat_l;
    lra).
  destruct Hk; subst k; lra.
Qed.

(** the relative velocity is continuous *)
Lemma cont_w : cont w.
Proof. apply cont_minus; [apply (f_cv _ _ _ _ _ _ _ _ _ _ H)|exact (forced_cv2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ H)]. Qed.

(** a load beyond b: slip, with its sign *)
Theorem slips_at k : k = 1 \/ k = -1 -> b < k * load t0 -> exists d, 0 < d /\ forall t, t0 < t < t0 + d ->
  0 < k * (v1 t - v2 t).
Proof.
  intros Hk G. set (g := (k * load t0 - b) / 2). assert (Gp : 0 < g) by (unfold g; lra). pose proof kappa_pos as Kp.
  destruct (load_near g Gp) as (d & Hd & K). exists (Rmin d d0). pose proof (Rmin_l d d0). pose proof (Rmin_r d d0).
  split; [apply Rmin_glb_lt; auto|]. intros t Ht.
  assert (Q : -1 * (k * w t) - -1 * (k * w t0) <= - (kap * g) * (t - t0)).
  { apply (dini_slope (fun r => -1 * (k * w r))); [apply cont_scal, cont_scal, cont_w|lra|]. intros r Hr.
    apply driven; [lra|auto|].
    specialize (K (r - t0) ltac:(lra)). replace (t0 + (r - t0)) with r in K by ring. apply Rabs_inv in K.
    unfold g in *. destruct Hk; subst k; lra. }
  assert (W0 : w t0 = 0) by (unfold w; lra). rewrite W0 in Q.
    assert (0 < kap * g * (t - t0)) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  unfold w in Q. lra.
Qed.

(** a load within b: stick *)
Theorem sticks_at : Rabs (load t0) < b -> exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t.
Proof.
  intros G. destruct (load_near (b - Rabs (load t0))) as (d & Hd & K); [lra|].
  set (c := Rmin d d0). pose proof (Rmin_l d d0). pose proof (Rmin_r d d0). fold c in H0, H1.
  assert (Cp : 0 < c) by (apply Rmin_glb_lt; auto). exists c. split; auto.
  assert (Key : forall k, k = 1 \/ k = -1 -> forall t, t0 <= t < t0 + c -> k * w t <= 0).
  { intros k Hk t Ht. set (W := fun h => k * w (t0 + Rmin h (t - t0))).
    assert (CW : cont W).
    { apply cont_scal. apply (cont_path (fun h => w (t0 + h)) (fun h => Rmin h (t - t0))).
      - intros h Hh. apply Rmin_glb; lra.
      - intros p q. unfold Rmin. repeat destruct Rle_dec; apply Rabs_le; unfold Rabs; destruct Rcase_abs; lra.
      - apply (cont_shift w); auto. apply cont_w. }
    assert (Wt : W (t - t0) <= 0).
    { apply le_epsilon. intros e He. rewrite Rplus_0_l. apply (barrier W e CW); [|intros h Hh Wh|lra].
      - unfold W. rewrite Rmin_left, Rplus_0_r by lra. unfold w. rewrite Meet. lra.
      - destruct (Rlt_dec h (t - t0)) as [l|l].
        + unfold W in Wh. rewrite Rmin_left in Wh by lra. intros p Hp.
          specialize (K h ltac:(lra)). apply Rabs_inv in K. pose proof (Rle_abs (load t0)).
            pose proof (Rle_abs (- load t0)) as A.
          rewrite Rabs_Ropp in A.
          destruct (held (t0 + h) k ltac:(lra) Hk ltac:(destruct Hk; subst k; lra) ltac:(lra) p Hp) as (q & Hq & Q).
          exists (Rmin q (t - t0 - h)). pose proof (Rmin_l q (t - t0 - h)). pose proof (Rmin_r q (t - t0 - h)).
          split; [apply Rmin_glb_lt; lra|]. intros z Hz. specialize (Q z ltac:(lra)). unfold W.
          rewrite !Rmin_left by lra. replace (t0 + (h + z)) with (t0 + h + z) by ring. exact Q.
        + intros p Hp. exists 1. split; [lra|]. intros z Hz. unfold W. rewrite !Rmin_right by lra. nra. }
    unfold W in Wt. rewrite Rmin_left in Wt by lra. replace (t0 + (t - t0)) with t in Wt by ring. auto. }
  intros t Ht. pose proof (Key 1 (or_introl eq_refl) t Ht). pose proof (Key (-1) (or_intror eq_refl) t Ht).
    unfold w in *. lra.
Qed.
End Mode.
