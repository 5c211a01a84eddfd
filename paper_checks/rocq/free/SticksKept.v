(** Static friction bs above kinetic bk: from every state a motion that keeps its sticks exists. A stick is a motion of the
    pair with the friction bs until its load is bs, a slip one with the friction bk until the next contact. As each slip
    from a contact costs a fixed energy, these are finitely many pieces. *)
From InertialPair Require Import Dini Pair Stick Pursuit Arcs WellPosed EnergyLimit StaticFriction.

Section Kept.
Variables m1 m2 a1 a2 bs bk : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hk : 0 < bk) (Hs : bk < bs).
Context (energy := energy m1 m2 a2) (load := stick_load m1 m2 a1 a2).
Let jumping := jumping m1 m2 a1 a2 bs bk.
Let until T := moves_until m1 m2 a1 a2 bk T (bs / bk) (fun _ => 0).

(** a motion that keeps its sticks until a time *)
Definition keeps_until T (x v1 v2 : R -> R) := forall t, 0 <= t < T -> v1 t = v2 t -> Rabs (load (x t) (v1 t)) < bs ->
  exists d, 0 < d /\ t + d <= T /\ forall u, t <= u <= t + d -> v1 u = v2 u.
(** there is a motion from a state *)
Definition starts x0 p q := exists x v1 v2 s, jumping x v1 v2 s /\ x 0 = x0 /\ v1 0 = p /\ v2 0 = q.

(** one piece before another *)
Lemma piece_first T x v1 v2 s : 0 <= T -> until T x v1 v2 s -> keeps_until T x v1 v2 -> starts (x T) (v1 T) (v2 T) ->
  starts (x 0) (v1 0) (v2 0).
Proof.
  intros HT U K (y & w1 & w2 & z & J & Y0 & W1 & W2). symmetry in Y0, W1, W2.
  pose proof (jumping_moves _ _ _ _ _ _ Hk _ _ _ _ (j_two _ _ _ _ _ _ _ _ _ _ J)) as Mz.
  pose proof (joined m1 m2 a1 a2 bk T (bs / bk) (fun _ => 0) x v1 v2 s y w1 w2 z HT U Mz Y0 W1 W2) as Mj.
  exists (join T x y), (join T v1 w1), (join T v2 w2), (join T s (fun t => s T + (z t - z 0))).
  split; [|rewrite !join_before by auto; auto]. constructor; [apply two_frictions_moves; auto|].
  intros t Ht. destruct (Rlt_dec t T) as [L|L].
  - rewrite !(join_before T) by (auto; lra). intros Meet Ld. destruct (K t ltac:(lra) Meet Ld) as (d & Hd & Hd' & Q).
    exists d. split; auto. intros u Hu. rewrite !(join_before T) by (auto; lra). auto.
  - rewrite !(join_after T) by lra. intros Meet Ld.
    destruct (j_keeps _ _ _ _ _ _ _ _ _ _ J (t - T) ltac:(lra) Meet Ld) as (d & Hd & Q).
    exists d. split; auto. intros u Hu. rewrite !(join_after T) by lra. apply Q. lra.
Qed.

(** a motion of the pair with the friction bk is one with both *)
Lemma kinetic x v1 v2 s : solution m1 m2 a1 a2 bk x v1 v2 s -> two_frictions m1 m2 a1 a2 bs bk x v1 v2 s.
Proof. intros [L P N CX CV X V W]. constructor; auto. intros r t Hr. pose proof (L r t Hr). nra. Qed.
Lemma kinetic_until T x v1 v2 s : 0 <= T -> solution m1 m2 a1 a2 bk x v1 v2 s -> until T x v1 v2 s.
Proof.
  intros HT H. destruct (jumping_moves _ _ _ _ _ _ Hk _ _ _ _ (kinetic _ _ _ _ H)) as [L P CX CV X V W].
  constructor; auto; intros; [apply P; lra|apply X; lra|apply V; lra|apply W; lra].
Qed.

(** *** a slip from a contact with the load bs or more: it goes on to the next contact, and costs *)
Lemma launch e x v1 v2 s : solution m1 m2 a1 a2 bk x v1 v2 s -> energy (x 0) (v1 0) (v2 0) <= e ->
  v1 0 = v2 0 -> bs <= Rabs (load (x 0) (v1 0)) ->
  exists q, 0 < q /\ v1 q = v2 q /\ (forall u, 0 < u < q -> v1 u <> v2 u) /\
    energy (x q) (v1 q) (v2 q) <= energy (x 0) (v1 0) (v2 0) - least_loss m1 m2 a1 a2 bs bk e.
Proof.
  intros H He Meet Edge. pose proof (kinetic _ _ _ _ H) as H2. set (w := fun t => v1 t - v2 t).
  set (h0 := least_slip m1 m2 a1 a2 bs bk e).
  pose proof (slip_pos m1 m2 a1 a2 bs bk Hm1 Hm2 Ha1 Ha2 Hk Hs _ _ _ _ H2 e He : 0 < h0) as H0.
  assert (Side : exists k, (k = 1 \/ k = -1) /\ bs <= k * load (x 0) (v1 0)).
  { unfold Rabs in Edge. destruct (Rcase_abs (load (x 0) (v1 0))); [exists (-1)|exists 1]; split; auto; lra. }
  destruct Side as (k & Hk' & Ek).
  pose proof (gains m1 m2 a1 a2 bs bk Hm1 Hm2 Ha1 Ha2 Hk Hs _ _ _ _ H2 e He 0 k (Rle_refl 0) Hk' Ek) as Fast.
  pose proof (loses m1 m2 a1 a2 bs bk Hm1 Hm2 Ha1 Ha2 Hk Hs _ _ _ _ H2 e He 0 k (Rle_refl 0) Hk' Ek) as Dear.
  rewrite Rplus_0_l in Fast, Dear. change (least_slip _ _ _ _ _ _ _) with h0 in Fast, Dear.
  pose proof (jumping_moves _ _ _ _ _ _ Hk _ _ _ _ H2) as Mv. set (kap := (m1 + m2) / (m1 * m2)) in *.
  assert (Kp : 0 < kap) by positive. assert (Cw : cont w) by exact (jumping_cw _ _ _ _ _ _ Hm2 Hk _ _ _ _ H2).
  (* it leaves the contact at once *)
  destruct (moves_slip m1 m2 a1 a2 bk Hm1 Hm2 _ _ _ _ _ _ Mv 0 0 (Rle_refl 0) (rderiv_const 0 0) (kap * ((bs -
    bk) / 2))
    ltac:(positive)) as (d & Hd & Near). fold kap in Near.
  replace ((0 - a2 * x 0 - a1 * v1 0) / m1) with (kap * load (x 0) (v1 0)) in Near
    by (unfold kap, load, stick_load; field; lra).
  assert (Pos : forall u, 0 < u <= h0 -> 0 < k * w u).
  { intros u Hu. set (p := Rmin u (d / 2)). assert (P : 0 < p) by positive. assert (p <= u) by apply Rmin_l.
    assert (p <= d / 2) by apply Rmin_r. assert (Wp : 0 < k * w p).
    { specialize (Near p ltac:(lra)). rewrite Rplus_0_l in Near. apply Rabs_inv in Near.
      pose proof (s_lip _ _ _ _ _ _ _ _ _ H 0 p ltac:(lra)) as Li. apply Rabs_inv in Li.
      assert (0 <= kap * bk * (p - k * (s p - s 0))) by (apply Rmult_le_pos; [positive|destruct Hk'; subst k;
        lra]).
      assert (0 <= kap * p * (k * load (x 0) (v1 0) - bs)) by positive.
      assert (0 < kap * p * (bs - bk)) by positive.
      unfold w. destruct Hk'; subst k; lra. }
    destruct (Req_dec p u) as [Eq|Np]; [rewrite <- Eq; auto|].
    pose proof (Fast p u ltac:(lra) ltac:(lra) Wp) as G. fold (w u) in G.
    assert (0 < kap * ((bs - bk) / 2) * (u - p)) by positive. lra. }
  destruct (moves_contact m1 m2 a1 a2 bk Hm1 Hm2 Ha1 Ha2 Hk _ _ _ _ _ h0 Mv ltac:(lra)) as (t & Ht & Zt).
  pose proof (Pos h0 ltac:(lra)) as Wh.
  destruct (first_zero w h0 t Cw ltac:(lra)) as (q & Hq & Zq & Sl); [unfold w at 2; rewrite Zt; lra|intros Z; rewrite Z in Wh; lra|].
  exists q. split; [lra|]. split; [unfold w in Zq; lra|]. split.
  - intros u Hu Eu. assert (Zu : w u = 0) by (unfold w; lra). destruct (Rle_dec u h0).
    + pose proof (Pos u ltac:(lra)) as P. rewrite Zu in P. lra.
    + pose proof (Sl u ltac:(lra)) as P. rewrite Zu in P. lra.
  - pose proof (Dear (h0 / 2) ltac:(lra) (Pos (h0 / 2) ltac:(lra))) as L.
    pose proof (jumping_decreases m1 m2 a1 a2 bs bk Hm1 Hm2 Ha1 Hk _ _ _ _ H2 h0 q ltac:(lra)) as D.
    rewrite (Rplus_0_l h0) in L. exact (Rle_trans _ _ _ D L).
Qed.

(** *** a stick with a load below bs: for ever, or until the load is bs *)
Lemma stay x v1 v2 s : solution m1 m2 a1 a2 bs x v1 v2 s -> v1 0 = v2 0 -> forall T, 0 <= T ->
  (forall t, 0 <= t < T -> Rabs (load (x t) (v1 t)) < bs) -> forall t, 0 <= t <= T -> v1 t = v2 t.
Proof.
  intros H Meet T HT Low t Ht. assert (Key : forall k, k = 1 \/ k = -1 -> k * (v1 t - v2 t) <= 0).
  { intros k Hk'. apply (moves_behind m1 m2 a1 a2 bs Hm1 Hm2 _ _ _ _ _ _ H 0 t k); [lra|auto|rewrite Meet; lra|].
    intros u Hu. exists 0. split; [eapply rderiv_dini; [|apply rderiv_scal, (rderiv_const 0 u)]; lra|].
    pose proof (Low u ltac:(lra)) as L. apply Rabs_def2 in L.
    replace (m2 * _) with (k * load (x u) (v1 u) * (m1 + m2)) by (unfold load, stick_load; field; lra). nra. }
  pose proof (Key 1 ltac:(auto)). pose proof (Key (-1) ltac:(auto)). lra.
Qed.

(** that stick as a piece of a motion with both frictions *)
Lemma stick_until x v1 v2 s T : solution m1 m2 a1 a2 bs x v1 v2 s -> (forall t, 0 <= t < T -> v1 t = v2 t) ->
  until T x v1 v2 (fun t => bs / bk * s t).
Proof.
  intros H St. assert (Eb : forall y, bk * (bs / bk * y) = bs * y) by (intros; field; lra). constructor.
  - intros r t Hr _. replace (bs / bk * s t - bs / bk * s r) with (bs / bk * (s t - s r)) by ring.
    apply abs_scal; [apply Rlt_le, Rdiv_lt_0_compat; lra|apply (s_lip _ _ _ _ _ _ _ _ _ H); auto].
  - intros t Ht k _ Kw. rewrite St in Kw by auto. lra.
  - apply (s_cx _ _ _ _ _ _ _ _ _ H).
  - apply (s_cv _ _ _ _ _ _ _ _ _ H).
  - intros t Ht. apply (s_x _ _ _ _ _ _ _ _ _ H). lra.
  - intros t Ht. apply rderiv_ext with (fun r => m1 * v1 r + bs * s r); [intros; rewrite Eb; ring|].
    apply (s_v1 _ _ _ _ _ _ _ _ _ H). lra.
  - intros t Ht. rewrite !Eb. apply (s_v2 _ _ _ _ _ _ _ _ _ H). lra.
Qed.

(** from contacts, by the number of slips that the energy can pay for *)
Section Paid.
Variable e : R.
Let e0 := least_loss m1 m2 a1 a2 bs bk e.
Variable n : nat.
Hypothesis Fewer : forall x0 v0, energy x0 v0 v0 <= e -> energy x0 v0 v0 <= (INR n - 1) * e0 -> starts x0 v0 v0.

(** with the load bs or more *)
Lemma from_edge x0 v0 : energy x0 v0 v0 <= e -> energy x0 v0 v0 <= INR n * e0 -> bs <= Rabs (load x0 v0) -> starts x0 v0 v0.
Proof.
  intros He Hn Edge. destruct (existence m1 m2 a1 a2 bk x0 v0 v0 Hm1 Hm2 Ha1 Ha2 Hk) as (x & v1 & v2 & s & H & X0 & V10 & V20).
  rewrite <- X0, <- V10 in Edge. assert (He' : energy (x 0) (v1 0) (v2 0) <= e) by (rewrite X0, V10, V20;
    auto).
  destruct (launch e x v1 v2 s H He' ltac:(lra) Edge) as (q & Hq & Mq & Sl & Cost). fold e0 in Cost.
  rewrite X0, V10, V20 in Cost. rewrite X0, V10 in Edge.
  assert (St : starts (x 0) (v1 0) (v2 0)); [|rewrite X0, V10, V20 in St; exact St].
  apply (piece_first q x v1 v2 s); [lra|apply kinetic_until; auto; lra| |].
  - intros t Ht Meet Ld. exfalso. destruct (Req_dec t 0) as [->|N]; [rewrite X0, V10 in Ld; lra|]. apply (Sl t); [lra|auto].
  - rewrite <- Mq in Cost |- *.
    pose proof (loss_pos m1 m2 a1 a2 bs bk Hm1 Hm2 Ha1 Ha2 Hk Hs _ _ _ _ (kinetic _ _ _ _ H) e He' : 0 < e0).
    apply Fewer; lra.
Qed.

(** with any load *)
Lemma from_contact x0 v0 : energy x0 v0 v0 <= e -> energy x0 v0 v0 <= INR n * e0 -> starts x0 v0 v0.
Proof.
  intros He Hn. destruct (Rlt_dec (Rabs (load x0 v0)) bs) as [Low|N]; [|apply from_edge; auto; lra].
  destruct (existence m1 m2 a1 a2 bs x0 v0 v0 Hm1 Hm2 Ha1 Ha2 ltac:(lra)) as (x & v1 & v2 & s & H & X0 & V10 & V20).
  pose proof (solution_moving _ _ _ _ _ _ _ _ _ H) as Mv.
  assert (St : starts (x 0) (v1 0) (v2 0)); [|rewrite X0, V10, V20 in St; exact St].
  destruct (Classical_Prop.classic (exists t, 0 <= t /\ bs <= Rabs (load (x t) (v1 t)))) as [(q & Hq & Lq)|No].
  - (* until the load is bs *)
    set (f := fun t => bs - Rabs (load (x t) (v1 t))). assert (Cf : cont f).
    { apply cont_minus; [apply cont_const|]. apply (cont_abs (fun t => load (x t) (v1 t))).
      apply cont_ext with (fun t => - (m2 * a2 / (m1 + m2)) * x t - m2 * a1 / (m1 + m2) * v1 t).
      { intros; unfold load, stick_load; field; lra. }
      apply cont_minus; apply cont_scal; [apply (s_cx _ _ _ _ _ _ _ _ _ H)|apply (s_cv _ _ _ _ _ _ _ _ _ H)]. }
    assert (F0 : 0 < f 0) by (unfold f; rewrite X0, V10; lra). assert (Fq' : f q <= 0) by (unfold f; lra).
    assert (Fq : f 0 * f q <= 0) by nra.
    destruct (first_zero f 0 q Cf ltac:(lra) Fq ltac:(lra)) as (T & HT & ZT & Before).
    assert (Lt : forall t, 0 <= t < T -> Rabs (load (x t) (v1 t)) < bs).
    { intros t Ht. specialize (Before t Ht).
      assert (P : 0 < f t) by (apply Rmult_lt_reg_l with (f 0); lra). unfold f in P. lra. }
    assert (Stay : forall t, 0 <= t <= T -> v1 t = v2 t) by (apply (stay x v1 v2 s H ltac:(lra) T); auto; lra).
    apply (piece_first T x v1 v2 (fun t => bs / bk * s t)); [lra|apply stick_until; auto; intros; apply Stay; lra| |].
    + intros t Ht Meet _. exists ((T - t) / 2). split; [lra|]. split; [lra|]. intros u Hu. apply Stay. lra.
    + rewrite <- (Stay T) by lra. pose proof (free_decreases m1 m2 a1 a2 bs Hm1 Hm2 Ha1 ltac:(lra) _ _ _ _ _ Mv 0 T ltac:(lra)) as D.
      cbv beta in D. rewrite <- (Stay T), X0, V10, V20 in D by lra. apply from_edge; unfold energy in *; try lra.
      unfold f in ZT. lra.
  - (* for ever *)
    assert (Stay : forall t, 0 <= t -> v1 t = v2 t).
    { intros t Ht. apply (stay x v1 v2 s H ltac:(lra) t); auto; [|lra]. intros u Hu. apply Rnot_le_lt. intros L.
      apply No. exists u. split; [lra|auto]. }
    exists x, v1, v2, (fun t => bs / bk * s t). split; [|auto]. constructor.
    + apply two_frictions_moves; auto. assert (U : forall T, until T x v1 v2 (fun t => bs / bk * s t))
        by (intros T; apply stick_until; auto; intros; apply Stay; lra).
      constructor; [intros r t Hr; apply (u_lip _ _ _ _ _ _ _ _ _ _ _ _ (U t)); lra|
        intros t Ht; apply (u_slip _ _ _ _ _ _ _ _ _ _ _ _ (U (t + 1))); lra|apply (s_cx _ _ _ _ _ _ _ _ _ H)|
        apply (s_cv _ _ _ _ _ _ _ _ _ H)|intros t Ht; apply (u_x _ _ _ _ _ _ _ _ _ _ _ _ (U (t + 1))); lra|
        intros t Ht; apply (u_v1 _ _ _ _ _ _ _ _ _ _ _ _ (U (t + 1))); lra|
        intros t Ht; apply (u_v2 _ _ _ _ _ _ _ _ _ _ _ _ (U t)); lra].
    + exists 1. split; [lra|]. intros u Hu. apply Stay. lra.
Qed.
End Paid.

(** *** from every state there is a motion that keeps its sticks *)

(** [static-kept] With static friction above kinetic there is, from every state, a free motion that keeps its sticks.
    *)
Theorem sticks_kept x0 p q : exists x v1 v2 s, jumping x v1 v2 s /\ x 0 = x0 /\ v1 0 = p /\ v2 0 = q.
Proof.
  set (e := energy x0 p q).
  destruct (existence m1 m2 a1 a2 bk x0 p q Hm1 Hm2 Ha1 Ha2 Hk) as (x & v1 & v2 & s & H & X0 & V10 & V20).
  pose proof (solution_moving _ _ _ _ _ _ _ _ _ H) as Mv. assert (Pay : 0 < least_loss m1 m2 a1 a2 bs bk e).
  { apply (loss_pos m1 m2 a1 a2 bs bk Hm1 Hm2 Ha1 Ha2 Hk Hs _ _ _ _ (kinetic _ _ _ _ H)).
    rewrite X0, V10, V20. apply Rle_refl. }
  assert (All : forall n y v, energy y v v <= e -> energy y v v <= INR n * least_loss m1 m2 a1 a2 bs bk e -> starts y v v).
  { induction n as [|n IH]; intros y v He Hn; apply (from_contact e _) with (2 := Hn) || idtac; auto.
    - apply (from_contact e O); auto. intros y' v' _ Neg. simpl in Neg.
      pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 y' v' v'). unfold energy in Neg. lra.
    - apply (from_contact e (S n)); auto. intros y' v' He' Hn'. apply IH; auto. rewrite S_INR in Hn'. lra. }
  assert (Con : forall y v, energy y v v <= e -> starts y v v).
  { intros y v He. destruct (nat_above e _ Pay) as (n & Hn). apply (All n); lra. }
  destruct (Req_dec p q) as [<-|Npq]; [apply Con; unfold e; lra|].
  (* until the first contact *)
  destruct (moves_contact m1 m2 a1 a2 bk Hm1 Hm2 Ha1 Ha2 Hk _ _ _ _ _ 0 Mv (Rle_refl 0)) as (t & Ht & Zt).
  set (w := fun t => v1 t - v2 t). assert (Cw : cont w) by exact (jumping_cw _ _ _ _ _ _ Hm2 Hk _ _ _ _
    (kinetic _ _ _ _ H)).
  assert (W0 : w 0 <> 0) by (unfold w; rewrite V10, V20; lra).
  destruct (first_zero w 0 t Cw ltac:(lra)) as (T & HT & ZT & Before); [unfold w at 2; rewrite Zt; lra|auto|].
  assert (St : starts (x 0) (v1 0) (v2 0)); [|rewrite X0, V10, V20 in St; exact St].
  apply (piece_first T x v1 v2 s); [lra|apply kinetic_until; auto; lra| |].
  - intros u Hu Meet _. specialize (Before u Hu). unfold w in Before at 2. rewrite Meet in Before. lra.
  - assert (M : v1 T = v2 T) by (unfold w in ZT; lra). rewrite <- M. apply Con.
    pose proof (free_decreases m1 m2 a1 a2 bk Hm1 Hm2 Ha1 Hk _ _ _ _ _ Mv 0 T ltac:(lra)) as D. cbv beta in D.
    rewrite <- M, X0, V10, V20 in D. exact D.
Qed.
End Kept.
