(** Without damping the bound on an arrival in the least time is sharp: the least amplitude is b + m1 beta theta / sin
  theta,
    theta = om1 tau <= pi/2. The force is +F until tau and -F from then on; body 1 runs ahead, is met at tau,
      and falls behind. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick Existence Forced ForcedExistence Arcs Nonstop Undamped Transfer.
Local Open Scope R_scope.

Section Arrival.
Variables m1 m2 a2 b D : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (HD : 0 < D).
Let tau := half_time m2 b D.
Let be := b / m2.
Let o := sqrt (a2 / m1).
Let th := o * tau.
(** body 2 arrives at the distance D, at rest, in the least time, under a force of size F at most, from rest *)
Definition arrives F := exists U x v1 v2 s x2, (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r)) /\
  forced m1 m2 0 a2 b U x v1 v2 s /\ cont x2 /\ (forall t, 0 <= t -> rderiv x2 t (v2 t)) /\
  x 0 = 0 /\ v1 0 = 0 /\ v2 0 = 0 /\ x2 0 = 0 /\ x2 (2 * half_time m2 b D) = D /\ v2 (2 * half_time m2 b D) = 0.
Hypothesis Hth : sqrt (a2 / m1) * half_time m2 b D <= PI / 2.

Let c := be * tau / sin th.
Let Fm := b + m1 * be * th / sin th.

(** the angle *)
Lemma th_eq : th = o * tau. Proof. reflexivity. Qed.

(** all positive *)
Lemma signs : 0 < tau /\ 0 < be /\ 0 < o /\ 0 < th <= PI / 2 /\ 0 < sin th /\ 0 < c.
Proof.
  pose proof (tau_pos m2 b D Hm2 Hb HD) as T. pose proof (be_pos m2 b Hm2 Hb) as B.
    pose proof (own_pos m1 a2 Hm1 Ha2) as O.
  fold be in B. fold tau in T. fold o in O. assert (H : 0 < th) by (unfold th; nra). fold o tau th in Hth.
    pose proof PI_RGT_0.
  assert (S : 0 < sin th) by (apply sin_gt_0; lra). assert (0 < c) by (unfold c; apply Rdiv_lt_0_compat; nra).
    repeat split; auto; lra.
Qed.

(** the force by the amplitude c of body 1's speed *)
Lemma Fm_c : Fm = b + m1 * o * c.
Proof. destruct signs as (Tp & Bp & Op & Hh & Sp & Cp). unfold Fm, c. replace th with (o * tau) at 1 by reflexivity.
  field; lra. Qed.

(** it is positive *)
Lemma Fm_pos : 0 < Fm.
Proof.
  destruct signs as (Tp & Bp & Op & Hh & Sp & Cp). rewrite Fm_c. assert (0 < m1 * o) by nra.
  assert (0 < m1 * o * c) by (apply Rmult_lt_0_compat; auto). lra.
Qed.

(** the force pushes, and from tau on it pulls *)
Let U t := Fm * (tau - Rabs (t - tau)).
Let X t := c / o * (1 - cos (o * t)).
Let V t := c * sin (o * t).
Let X' t := c / o * ((2 - cos th) * cos (o * t) + sin th * sin (o * t) - 1).
Let V' t := c * (sin th * cos (o * t) - (2 - cos th) * sin (o * t)).

(** body 1 under the push *)
Lemma derive_first t : is_derive X t (V t) /\ is_derive V t ((Fm - a2 * X t - 0 * V t - b * 1) / m1).
Proof.
  destruct signs as (Tp & Bp & Op & Hh & Sp & Cp). pose proof (own_sq m1 a2 Hm1 Ha2) as O2. fold o in O2. split.
  - unfold X, V. auto_derive; auto. field; lra.
  - unfold X, V. auto_derive; auto. rewrite <- O2, Fm_c. field; repeat split; lra.
Qed.
(** body 1 under the pull *)
Lemma derive_then t : is_derive X' t (V' t) /\ is_derive V' t ((- Fm - a2 * X' t - 0 * V' t - b * -1) / m1).
Proof.
  destruct signs as (Tp & Bp & Op & Hh & Sp & Cp). pose proof (own_sq m1 a2 Hm1 Ha2) as O2. fold o in O2. split.
  - unfold X', V'. auto_derive; auto. field; lra.
  - unfold X', V'. auto_derive; auto. rewrite <- O2, Fm_c. field; repeat split; lra.
Qed.

(** the force is bounded *)
Lemma U_lip F r t : Fm <= F -> 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r).
Proof.
  intros HF Hr. destruct signs as (Tp & Bp & Op & Hh & Sp & Cp).
  pose proof Fm_pos.
  unfold U. replace (Fm * (tau - Rabs (t - tau)) - Fm * (tau - Rabs (r - tau))) with (Fm * (Rabs (r - tau) - Rabs (t -
    tau))) by ring.
  apply Rle_trans with (Fm * (t - r)); [|apply Rmult_le_compat_r; lra]. apply abs_scal; [lra|]. apply Rabs_le.
  unfold Rabs. repeat destruct Rcase_abs; lra.
Qed.
(** it pushes, then pulls *)
Lemma U_rate t : rderiv U t (Fm * (0 - side (t - tau))).
Proof. unfold U. apply rderiv_scal, rderiv_minus; [apply rderiv_const|apply rderiv_Rabs]. Qed.

(** body 1 runs ahead of body 2 *)
Lemma ahead t : 0 <= t <= tau -> be * t <= V t.
Proof.
  intros Ht. destruct signs as (Tp & Bp & Op & Hh & Sp & Cp). pose proof (chord (o * t) th) as Q. unfold th in Q at 1.
  specialize (Q ltac:(nra) ltac:(pose proof PI_RGT_0; lra)). unfold V, c. apply Rmult_le_reg_r with (o * sin th);
    [nra|].
  replace (be * tau / sin th * sin (o * t) * (o * sin th)) with (be * (th * sin (o * t))) by (rewrite th_eq at 1;
    field; lra).
  replace (be * t * (o * sin th)) with (be * (o * t * sin th)) by ring. apply Rmult_le_compat_l; lra.
Qed.
(** and then falls behind it *)
Lemma behind t : 0 <= t <= tau -> V' t <= be * (tau - t).
Proof.
  intros Ht. destruct signs as (Tp & Bp & Op & Hh & Sp & Cp). pose proof (chord (o * t) th) as Q. unfold th in Q at 1.
  specialize (Q ltac:(nra) ltac:(pose proof PI_RGT_0; lra)).
  assert (Sy : 0 <= sin (o * t)) by (apply sin_ge_0; [nra|]; pose proof PI_RGT_0; assert (o * t <= th) by (unfold th;
    nra); lra).
  pose proof (COS_bound (o * t)) as Cy. pose proof (COS_bound th) as Ct.
  assert (0 <= th * sin th * (1 - cos (o * t))) by (apply Rmult_le_pos; [nra|lra]).
  assert (0 <= th * sin (o * t) * (1 - cos th)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]).
  assert (K : th * (sin th * cos (o * t) - (2 - cos th) * sin (o * t)) <= sin th * (th - o * t)) by lra.
  unfold V', c. apply Rmult_le_reg_r with (o * sin th); [nra|].
  replace (be * tau / sin th * (sin th * cos (o * t) - (2 - cos th) * sin (o * t)) * (o * sin th))
    with (be * (th * (sin th * cos (o * t) - (2 - cos th) * sin (o * t)))) by (rewrite th_eq at 1; field; lra).
  replace (be * (tau - t) * (o * sin th)) with (be * (sin th * (th - o * t))) by (rewrite th_eq at 2; ring).
    apply Rmult_le_compat_l; lra.
Qed.

(** enough *)
Lemma arrival_attained F : Fm <= F -> arrives F.
Proof.
  intros HF. destruct signs as (Tp & Bp & Op & Hh & Sp & Cp).
  assert (CU : cont U). { apply (lip_cont U Fm).
    - pose proof Fm_pos. lra.
    - intros r t Hr. apply U_lip; auto; lra. }
  assert (A1 : forced_arc m1 m2 0 a2 b tau (fun _ => Fm) X V (fun t => be * t) (fun _ => 1)).
  { constructor; try (intros t; apply derive_first).
    - intros t. auto_derive; auto. unfold be. field; lra.
    - intros t Ht. split; [lra|]. split; [auto|]. pose proof (ahead t ltac:(lra)). lra. }
  assert (A2 : forced_arc m1 m2 0 a2 b tau (fun _ => - Fm) X' V' (fun t => be * (tau - t)) (fun _ => -1)).
  { constructor; try (intros t; apply derive_then).
    - intros t. auto_derive; auto. unfold be. field; lra.
    - intros t Ht. split; [lra|]. split; [|auto]. pose proof (behind t ltac:(lra)). lra. }
  assert (Pushes : forall t, 0 <= t < tau -> rderiv U t Fm).
  { intros t Ht. eapply rderiv_eq; [|apply U_rate]. unfold side. destruct Rle_dec; lra. }
  destruct (arc_begins m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb U (fun _ => Fm) X V _ _ tau ltac:(lra) CU Pushes A1)
    as (x & v1 & v2 & s & H & E).
  destruct (E 0 ltac:(lra)) as (X0 & V0 & W0). destruct (E tau ltac:(lra)) as (XT & VT & WT).
  unfold X in XT. unfold V in VT. fold th in XT, VT.
  assert (E2 : forall t, 0 <= t <= tau -> v2 (tau + t) = be * (tau - t)).
  { intros t Ht. apply (follow_arc m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb U (fun _ => - Fm) x v1 v2 s X' V'
      (fun t => be * (tau - t)) (fun _ => -1) tau tau); auto; try lra.
    - intros r Hr. eapply rderiv_eq; [|apply U_rate]. unfold side. destruct Rle_dec; lra.
    - rewrite XT. unfold X'. rewrite Rmult_0_r, cos_0, sin_0. ring.
    - rewrite VT. unfold V'. rewrite Rmult_0_r, cos_0, sin_0. ring. }
  pose proof (forced_cv2 m1 m2 0 a2 b Hm2 _ _ _ _ _ H) as Cv2.
  exists U, x, v1, v2, s, (integral v2). split; [intros r t Hr; apply U_lip; auto|]. split; [auto|].
  split; [apply integral_cont; auto|]. split; [intros t Ht; apply integral_rderiv; auto|].
  split; [rewrite X0; unfold X; rewrite Rmult_0_r, cos_0; field; lra|].
  split; [rewrite V0; unfold V; rewrite Rmult_0_r, sin_0; ring|]. split; [rewrite W0; ring|]. split;
    [apply integral_0|]. fold tau. split.
  - pose proof (tau_sq m2 b D Hm2 Hb HD) as T2. fold tau be in T2.
    assert (K1 : integral v2 tau - be * tau ^ 2 / 2 = integral v2 0 - be * 0 ^ 2 / 2).
    { apply (rderiv_0 (fun t => integral v2 t - be * t ^ 2 / 2) 0 tau); [|lra|].
      - apply cont_minus; [apply integral_cont; auto|]. apply cont_of_derive with (fun t => be * t). intros t.
        auto_derive; auto. field.
      - intros t Ht. apply rderiv_eq with (v2 t - be * t); [destruct (E t ltac:(lra)) as (_ & _ & ->); ring|].
        apply rderiv_minus; [apply integral_rderiv; auto; lra|apply rderiv_of_derive]. auto_derive; auto. field. }
    assert (K2 : integral v2 (2 * tau) + be * (2 * tau - 2 * tau) ^ 2 / 2 = integral v2 tau + be * (2 * tau - tau) ^ 2
      / 2).
    { apply (rderiv_0 (fun t => integral v2 t + be * (2 * tau - t) ^ 2 / 2) tau (2 * tau)); [|lra|].
      - apply cont_plus; [apply integral_cont; auto|]. apply cont_of_derive with (fun t => - be * (2 * tau - t)).
        intros t. auto_derive; auto. field.
      - intros t Ht. apply rderiv_eq with (v2 t + - be * (2 * tau - t)).
        + pose proof (E2 (t - tau) ltac:(lra)) as Q. replace (tau + (t - tau)) with t in Q by ring. rewrite Q. ring.
        + apply rderiv_plus; [apply integral_rderiv; auto; lra|apply rderiv_of_derive]. auto_derive; auto. field. }
    rewrite integral_0 in K1. rewrite <- T2. nra.
  - replace (2 * tau) with (tau + tau) by ring. rewrite E2 by lra. ring.
Qed.

(** the least amplitude *)
Theorem least_amplitude F : arrives F <-> b + m1 * (b / m2) * (sqrt (a2 / m1) * half_time m2 b D) / sin (sqrt (a2 /
  m1) * half_time m2 b D) <= F.
Proof.
  fold o tau be th. fold Fm. split; [|apply arrival_attained].
  intros (U' & x & v1 & v2 & s & x2 & LU & H & C & R & X0 & V0 & W0 & Y0 & YT & WT).
  destruct signs as (Tp & Bp & Op & Hh & Sp & Cp). pose proof (own_sq m1 a2 Hm1 Ha2) as O2. fold o in O2.
  pose proof (arrival_needs m1 m2 0 a2 b D Hm1 Hm2 Hb HD (fun t => sin (o * t) / (m1 * o)) (fun t => cos (o * t) / m1)
    U' x v1 v2 s x2 F) as Q. cbv beta in Q. fold tau be th in Q.
  replace Fm with (b + be * tau / (sin th / (m1 * o))) by (unfold Fm; rewrite th_eq at 2; field; lra). apply Q; auto.
  - intros t. auto_derive; auto. field; lra.
  - intros t. auto_derive; auto. rewrite <- O2. field; lra.
  - rewrite Rmult_0_r, sin_0. field; lra.
  - rewrite Rmult_0_r, cos_0. field; lra.
  - intros t Ht. assert (0 <= o * t <= th) by (unfold th; nra). apply Rmult_le_pos; [apply cos_ge_0; lra|].
    apply Rlt_le, Rinv_0_lt_compat; auto.
  - apply Rdiv_lt_0_compat; [auto|nra].
  - fold tau in YT. lra.
Qed.
End Arrival.
