(** Motions with the force's period that slip one way for half of it and then the other way: half the difference of such
    a motion and of itself half a period later is one that repeats with the opposite sign. So U** is the least amplitude
    for these motions, too. *)
From InertialPair Require Import Dini Pair Forced Arcs Nonstop.

Section Mean.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** half the sum *)
Definition mean (f g : R -> R) t := / 2 * f t + / 2 * g t.

(** The mean of two motions under one force is one, if they always slip the same way. *)
Lemma forced_mean U x v1 v2 s y w1 w2 r : forced m1 m2 a1 a2 b U x v1 v2 s -> forced m1 m2 a1 a2 b U y w1 w2 r ->
  (forall t, 0 <= t -> (v2 t < v1 t /\ w2 t < w1 t) \/ (v1 t < v2 t /\ w1 t < w2 t) \/ (v1 t = v2 t /\ w1 t = w2 t)) ->
  forced m1 m2 a1 a2 b U (mean x y) (mean v1 w1) (mean v2 w2) (mean s r).
Proof.
  intros [L P N CU CX CV X V W] [L' P' N' _ CX' CV' X' V' W'] Same. unfold mean.
  constructor; auto using cont_plus, cont_scal, rderiv_plus, rderiv_scal.
  - intros p t Hp. specialize (L p t Hp). specialize (L' p t Hp). by_sizes.
  - intros t Ht Hv. apply rderiv_eq with (/ 2 * 1 + / 2 * 1); [field|]. destruct (Same t Ht) as [?|[?|?]]; try lra.
    apply rderiv_plus; apply rderiv_scal; [apply P|apply P']; tauto.
  - intros t Ht Hv. apply rderiv_eq with (/ 2 * -1 + / 2 * -1); [field|]. destruct (Same t Ht) as [?|[?|?]]; try lra.
    apply rderiv_plus; apply rderiv_scal; [apply N|apply N']; tauto.
  - intros t Ht. apply rderiv_ext with (fun u => / 2 * (m1 * v1 u + b * s u - U u) + / 2 * (m1 * w1 u + b * r u - U u)).
    { intros; field. }
    rate. field.
  - intros t Ht. specialize (W t Ht). specialize (W' t Ht). lra.
Qed.

(** a motion with the period of the force F sin (om t + phi) that slips forwards in the first half of it and backwards
    in the second *)
Definition by_halves om F phi x v1 v2 s := forced m1 m2 a1 a2 b (wave F om phi) x v1 v2 s /\
  (forall t, 0 <= t -> x (2 * (PI / om) + t) = x t /\ v1 (2 * (PI / om) + t) = v1 t /\ v2 (2 * (PI / om) + t) = v2 t) /\
  (forall t, 0 < t < PI / om -> v2 t < v1 t) /\ (forall t, PI / om < t < 2 * (PI / om) -> v1 t < v2 t).

(** what slips for ever with opposite signs slips by halves *)
Lemma nonstop_by_halves om F phi x v1 v2 s : 0 < om -> nonstop m1 m2 a1 a2 b om F phi x v1 v2 s ->
  by_halves om F phi x v1 v2 s.
Proof.
  intros Hom (H & Pos & Anti). pose proof (Rdiv_lt_0_compat _ _ PI_RGT_0 Hom) as HT.
  split; [auto|]. split; [|split; auto].
  - intros t Ht. destruct (Anti t Ht) as (E1 & E2 & E3). destruct (Anti (PI / om + t) ltac:(lra)) as (F1 & F2 & F3).
    replace (2 * (PI / om) + t) with (PI / om + (PI / om + t)) by ring. lra.
  - intros t Ht. destruct (Anti (t - PI / om) ltac:(lra)) as (_ & E2 & E3).
    replace (PI / om + (t - PI / om)) with t in E2, E3 by ring. specialize (Pos (t - PI / om) ltac:(lra)). lra.
Qed.

(** and the other way round, for half the difference *)
Theorem by_halves_nonstop om F phi x v1 v2 s : 0 < om -> by_halves om F phi x v1 v2 s ->
  exists x' v1' v2' s', nonstop m1 m2 a1 a2 b om F phi x' v1' v2' s'.
Proof.
  intros Hom (H & Pe & Fo & Ba). pose proof (Rdiv_lt_0_compat _ _ PI_RGT_0 Hom) as HT. set (T := PI / om) in *.
  assert (Cw : cont (fun t => v1 t - v2 t)) by continuous.
  assert (Ends : v1 0 = v2 0 /\ v1 T = v2 T).
  { destruct (ends_nonneg (fun t => v1 t - v2 t) 0 T Cw ltac:(lra) ltac:(intros t Ht; specialize (Fo t Ht); lra)) as
      (A & B).
    destruct (ends_nonneg (fun t => -1 * (v1 t - v2 t)) T (2 * T) ltac:(apply cont_scal; exact Cw) ltac:(lra)
      ltac:(intros t Ht; specialize (Ba t Ht); lra)) as (A' & B').
    destruct (Pe 0 (Rle_refl 0)) as (_ & E1 & E2). rewrite Rplus_0_r in E1, E2. lra. }
  assert (Signs : forall t, 0 <= t < 2 * T -> (v2 t < v1 t /\ v1 (T + t) < v2 (T + t)) \/
    (v1 t < v2 t /\ v2 (T + t) < v1 (T + t)) \/ (v1 t = v2 t /\ v1 (T + t) = v2 (T + t))).
  { intros t Ht. destruct (Req_dec t 0) as [->|]; [rewrite Rplus_0_r; tauto|]. destruct (Req_dec t T) as [->|].
    { destruct (Pe 0 (Rle_refl 0)) as (_ & E1 & E2). replace (T + T) with (2 * T + 0) by ring. rewrite E1, E2. tauto. }
    destruct (Rlt_dec t T); [left; split; [apply Fo|apply Ba]; lra|]. right; left. split; [apply Ba; lra|].
    destruct (Pe (t - T) ltac:(lra)) as (_ & E1 & E2). replace (2 * T + (t - T)) with (T + t) in E1, E2 by ring.
    rewrite E1, E2. apply Fo. lra. }
  assert (Many : forall n t, 0 <= t -> v1 (INR n * (2 * T) + t) = v1 t /\ v2 (INR n * (2 * T) + t) = v2 t).
  { intros n t Ht. split; apply repeats; auto; try lra; intros; apply Pe; auto. }
  set (U := wave F om phi) in *.
  assert (H' : forced m1 m2 a1 a2 b U (fun t => - x (T + t)) (fun t => - v1 (T + t)) (fun t => - v2 (T + t))
    (fun t => - s (T + t))).
  { apply forced_half_turn; auto; [lra|]. intros t Ht. exact (wave_half F om phi t Hom). }
  exists (mean x (fun t => - x (T + t))), (mean v1 (fun t => - v1 (T + t))), (mean v2 (fun t => - v2 (T + t))),
    (mean s (fun t => - s (T + t))). split; [|split].
  - apply forced_mean; auto. intros t Ht. destruct (one_turn (2 * T) t ltac:(lra) Ht) as (n & u & -> & Hu).
    destruct (Many n u (proj1 Hu)) as (E1 & E2), (Many n (T + u) ltac:(lra)) as (E3 & E4).
    replace (INR n * (2 * T) + (T + u)) with (T + (INR n * (2 * T) + u)) in E3, E4 by ring.
    destruct (Signs _ Hu) as [?|[?|?]]; [left|right; left|right; right]; lra.
  - intros t Ht. fold T in Ht. specialize (Fo t Ht). specialize (Ba (T + t) ltac:(lra)). unfold mean. lra.
  - intros t Ht. destruct (Pe t Ht) as (E1 & E2 & E3). unfold mean. fold T.
    replace (T + (T + t)) with (2 * T + t) by ring. rewrite E1, E2, E3. repeat split; field.
Qed.

(** [nonstop-by-halves] A motion with the force's period that slips one way for half of it and then the other way
    exists exactly where one exists that also repeats with the opposite sign; each for some phase of the force. *)
Corollary by_halves_iff om F : 0 < om -> (exists phi x v1 v2 s, by_halves om F phi x v1 v2 s) <->
  exists phi x v1 v2 s, nonstop m1 m2 a1 a2 b om F phi x v1 v2 s.
Proof.
  intros Hom. split; intros (phi & x & v1 & v2 & s & H).
  - exists phi. exact (by_halves_nonstop om F phi x v1 v2 s Hom H).
  - exists phi, x, v1, v2, s. apply nonstop_by_halves; auto.
Qed.

(** [nonstop-by-halves-needs] Below $U_{**}$ no motion with the force's period slips one way for half of it and then
    the other way, whatever the relative velocity does at $U_{**}$, if it leaves the turn there ($A>0$). *)
Corollary by_halves_needs om (k k' : R -> R) F phi x v1 v2 s : 0 < om -> (forall t, is_derive k t (k' t)) ->
  (forall t, is_derive k' t ((1 - a1 * k' t - a2 * k t) / m1)) -> k (PI / om) = - k 0 -> k' (PI / om) = - k' 0 ->
  0 < Z1 m1 a1 a2 om -> 0 < leave m1 m2 a1 a2 b om (k 0) (k' 0) -> 0 <= F -> by_halves om F phi x v1 v2 s ->
  Fslip m1 m2 a1 a2 b om (k 0) (k' 0) <= F.
Proof using Hm1 Hm2 Ha1 Ha2.
  intros Hom Dk Dk' Ek Ek' HZ Hl HF H. destruct (by_halves_nonstop om F phi x v1 v2 s Hom H) as (x' & v1' & v2' & s' &
    H').
  eapply nonstop_needs; eauto.
Qed.
End Mean.
