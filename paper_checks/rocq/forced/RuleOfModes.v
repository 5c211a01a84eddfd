(** The rest of the rule of modes: how slip and stick move under the load; the tie in which every derivative is 0;
    jumps of the force. *)
From InertialPair Require Import Dini Pair Stick Pursuit Forced Arcs ModeAtContact Analytic BeforeContact.

(** the derivatives of an analytic function are those of its series *)
Lemma derivatives f t : analytic_at f t -> exists (P : nat -> R -> R) d C K, 0 < d /\ 0 < C /\ 0 < K /\
  (forall r, Rabs (r - t) < d -> P 0%nat r = f r) /\ (forall i, P i t = Derive_n f i t) /\
  forall i r, Rabs (r - t) < d -> is_derive (P i) r (P (S i) r) /\ Rabs (P i r) <= C * K ^ i * INR (fact i).
Proof.
  intros (P & d & C & K & Hd & HC & HK & P0 & DP). exists P, d, C, K. do 3 (split; auto). split; auto. split; [|auto].
  assert (Same : forall i r, Rabs (r - t) < d -> P i r = Derive_n f i r).
  { induction i as [|i IH]; intros r Hr; [apply P0; auto|]. simpl.
    rewrite <- (is_derive_unique (P i) r _ (proj1 (DP i r Hr))).
    apply Derive_ext_loc. assert (Hp : 0 < d - Rabs (r - t)) by lra. exists (mkposreal _ Hp). intros q Hq. apply IH.
    change (Rabs (q - r) < d - Rabs (r - t)) in Hq. replace (q - t) with (q - r + (r - t)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|]. lra. }
  intros i. apply Same. rewrite Rminus_diag_eq, Rabs_R0; auto.
Qed.

Section Rule.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (U u x v1 v2 s : R -> R) (H : forced m1 m2 a1 a2 b U x v1 v2 s).
Let load := load m1 m2 a1 a2 u x v1.

(** [slip-rate] In slip the rate of the relative velocity is given by the load in excess of $\pm b$. *)
Theorem slip_rate t k : 0 <= t -> rderiv U t (u t) -> k = 1 \/ k = -1 -> 0 < k * (v1 t - v2 t) ->
  rderiv (fun r => v1 r - v2 r) t ((m1 + m2) / (m1 * m2) * (load t - k * b)).
Proof.
  intros Ht DU Hk W. pose proof (q_slip m1 m2 a1 a2 b _ U x v1 v2 s H t Ht k Hk W) as S.
  eapply rderiv_eq; [|exact (moves_rate m1 m2 a1 a2 b Hm1 Hm2 _ U x v1 v2 s H t (u t) k Ht DU S)].
  unfold load, ModeAtContact.load. ring.
Qed.

(** [stuck-load] While stuck body 2 has the acceleration $\Lambda/m_2$, and $|\Lambda|\leqslant b$. *)
Theorem stuck_load t d : 0 <= t -> 0 < d -> rderiv U t (u t) -> (forall r, t <= r < t + d -> v1 r = v2 r) ->
  rderiv v2 t (load t / m2) /\ Rabs (load t) <= b.
Proof.
  intros Ht Hd DU St. assert (D : rderiv v2 t (load t / m2)).
  { apply rderiv_near with (fun r => / (m1 + m2) * (((m1 + m2) * v1 r - U r) + U r)) d; [lra| |].
    - intros r Hr. rewrite (St r) by lra. field. lra.
    - pose proof (stuck_needs m1 m2 a1 a2 b _ _ _ _ _ t d H Hd St Ht). rate. unfold load, ModeAtContact.load. field.
      lra. }
  split; auto. pose proof (lip_rderiv v2 (b / m2) t _ (fun p q Hp => only_gentle m1 m2 a1 a2 b Hm2 Hb _ _ _ _ _ p q H
    Hp) Ht D) as B.
  replace (load t) with (m2 * (load t / m2)) by (field; lra). replace b with (m2 * (b / m2)) by (field; lra).
  apply abs_scal; lra.
Qed.

(** [mode-marginal] Where all these derivatives are 0 and the force is analytic, the pair sticks at the load $\pm b$,
    with the acceleration of the slip. *)
Theorem marginal t0 d0 g k : 0 <= t0 -> 0 < d0 -> (forall t, t0 <= t < t0 + d0 -> rderiv U t (u t)) ->
  (forall t, t0 <= t < t0 + d0 -> u t = g t) -> analytic_at g t0 -> v1 t0 = v2 t0 -> k = 1 \/ k = -1 ->
  (forall n, Derive_n (beyond m1 m2 a1 a2 b g x v1 t0 k) n t0 = 0) ->
  exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t /\ k * load t = b /\
    x t = x t0 + v1 t0 * (t - t0) + k * (b / m2) * (t - t0) ^ 2 / 2.
Proof.
  intros Ht0 Hd0 DU Eq A Meet Hk Flat. set (p := beyond m1 m2 a1 a2 b g x v1 t0 k) in *.
  destruct (derivatives p t0 (analytic_beyond m1 m2 a1 a2 b g x v1 t0 k Hm2 A)) as (P & d1 & C & K & Hd1 & HC & HK &
    P0 & Pd & DP).
  assert (In : forall h, Rabs h < d1 -> Rabs (t0 + h - t0) < d1).
  { intros h. replace (t0 + h - t0) with h by ring. auto. }
  assert (K2 : 0 < / (2 * K)) by positive.
  set (d := Rmin (Rmin d0 d1) (/ (2 * K))). pose proof (Rmin_l (Rmin d0 d1) (/ (2 * K))).
  pose proof (Rmin_r (Rmin d0 d1) (/ (2 * K))).
  pose proof (Rmin_l d0 d1). pose proof (Rmin_r d0 d1). fold d in H0, H1. assert (Hd : 0 < d) by positive.
  (* so the force asks just b for a while *)
  assert (Zero : forall t, t0 <= t < t0 + d -> p t = 0).
  { intros t Ht. rewrite <- P0 by (rewrite Rabs_pos_eq; lra).
    replace t with (t0 + (t - t0)) by ring. apply (flat (fun i h => P i (t0 + h)) d1) with (C := C) (K := K); auto;
      try lra.
    - intros i h Hh. destruct (DP i _ (In h Hh)) as (D & _). replace (P (S i) (t0 + h)) with (scal 1 (P (S i) (t0 +
      h))) by apply Rmult_1_l. apply (is_derive_comp (P i) (fun h => t0 + h)); auto. auto_derive; auto.
    - intros i h Hh. apply DP, In; auto.
    - intros i. rewrite Rplus_0_r, Pd. apply Flat.
    - replace (/ 2) with (K * / (2 * K)) by (field; lra). scale. }
  (* and the motion with the acceleration k b/m2 obeys the law *)
  set (X := fun h => x t0 + v1 t0 * h + k * (b / m2) * h ^ 2 / 2). set (V := fun h => v1 t0 + k * (b / m2) * h).
  assert (KK : k * k = 1) by (destruct Hk; subst k; ring).
  set (f := fun h => k * ((m1 + m2) * (b / m2)) + a2 * X h + a1 * V h).
  assert (Arc : forced_arc m1 m2 a1 a2 b d f X V V (fun _ => k)).
  { constructor.
    - intros h. unfold X, V. auto_derive; auto. field; lra.
    - intros h. unfold f, V at 1. auto_derive; auto. field; lra.
    - intros h. unfold V. auto_derive; auto. field; lra.
    - intros h Hh. split; [destruct Hk; subst k; lra|]. split; intros; lra. }
  assert (Asks : forall t, t0 <= t < t0 + d -> u t = f (t - t0)).
  { unfold f. intros t Ht. rewrite Eq by lra. specialize (Zero t Ht). unfold p, beyond in Zero.
    apply Rmult_eq_reg_l with k; [|destruct Hk; lra]. unfold X, V.
    replace (k * (k * ((m1 + m2) * (b / m2)) + a2 * (x t0 + v1 t0 * (t - t0) + k * (b / m2) * (t - t0) ^ 2 / 2) + a1
      * (v1 t0 + k * (b / m2) * (t - t0))))
      with (k * k * ((m1 + m2) * (b / m2)) + a2 * (k * x t0 + k * v1 t0 * (t - t0) + k * k * (b / m2) * (t - t0) ^ 2
        / 2)
        + a1 * (k * v1 t0 + k * k * (b / m2) * (t - t0))) by (field; lra). rewrite KK. lra. }
  exists d. split; auto. intros t Ht.
  destruct (follow_arc m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U f x v1 v2 s X V V (fun _ => k) d t0 (Rlt_le _ _ Hd) Ht0)
    with (t := t - t0) as (Ex & Ev1 & Ev2); try exact Arc; auto; try lra.
  { intros r Hr. rewrite <- Asks by auto. apply DU. lra. }
  { unfold X. field. lra. } { unfold V. ring. } { unfold V. lra. }
  replace (t0 + (t - t0)) with t in * by ring. split; [lra|]. split; [|rewrite Ex; unfold X; field; lra].
  unfold load, ModeAtContact.load. rewrite Asks, Ex, Ev1 by auto. unfold f.
  replace (k * (m2 * (k * ((m1 + m2) * (b / m2)) + a2 * X (t - t0) + a1 * V (t - t0) - a2 * X (t - t0) - a1 * V (t -
    t0)) / (m1 + m2))) with (k * k * b) by (field; lra). rewrite KK. ring.
Qed.

(** [jump-moves-strip] The state is continuous whatever the force does; a jump of the force moves the strip
    $|\Lambda|\leqslant b$. *)
Theorem jump_moves_strip : (cont x /\ cont v1 /\ cont v2) /\ forall j t,
  ModeAtContact.load m1 m2 a1 a2 (fun r => u r + j) (fun r => x r + j / a2) v1 t = load t.
Proof.
  split; [split; [|split]; continuous|intros j t; unfold load, ModeAtContact.load; field; lra].
Qed.
End Rule.

(** [damper-breaks] A free pair, stuck at $x_1=0$ with $v_1>0$, slips at once if $a_1>b(m_1+m_2)/(m_2v_1)$. *)
Theorem damper_breaks m1 m2 a1 a2 b x v1 v2 s t0 : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b ->
  solution m1 m2 a1 a2 b x v1 v2 s -> 0 <= t0 -> x t0 = 0 -> v1 t0 = v2 t0 -> 0 < v1 t0 ->
  b * (m1 + m2) / (m2 * v1 t0) < a1 -> exists d, 0 < d /\ forall t, t0 < t < t0 + d -> v1 t < v2 t.
Proof.
  intros Hm1 Hm2 Ha2 Hb H Ht0 X0 Meet Vp Strong. assert (Push : b * (m1 + m2) < a1 * (m2 * v1 t0)).
  { apply Rmult_lt_reg_r with (/ (m2 * v1 t0)); [positive|].
    replace (a1 * (m2 * v1 t0) * / (m2 * v1 t0)) with a1 by (field; lra). exact Strong. }
  assert (Ap : 0 < b * (m1 + m2) / (m2 * v1 t0)) by positive.
  destruct (slips_at m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Ha2 Hb (fun _ => 0) (fun _ => 0) x v1 v2 s t0 1
    (proj2 (free_case m1 m2 a1 a2 b x v1 v2 s) H) Ht0 Rlt_0_1 (fun t _ => rderiv_const 0 t)) with (k := -1)
    as (d & Hd & Slip); auto.
  - intros e He. exists 1. split; [lra|]. intros h Hh. rewrite Rminus_diag_eq, Rabs_R0; lra.
  - unfold load. rewrite X0. apply Rmult_lt_reg_r with (m1 + m2); [lra|].
    replace (-1 * (m2 * (0 - a2 * 0 - a1 * v1 t0) / (m1 + m2)) * (m1 + m2)) with (a1 * (m2 * v1 t0)) by (field; lra).
    exact Push.
  - exists d. split; auto. intros t Ht. specialize (Slip t Ht). lra.
Qed.
