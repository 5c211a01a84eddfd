(** The fastest transfer of body 2 over D, from rest to rest in 2 tau, tau = sqrt (m2 D/b): which amplitude of the
    force it needs, stuck, and if the bodies may slip (a1 = 0). *)
From InertialPair Require Import Forced.

(** A mass m beside a constant pull c, under a force of at most F, is tested with a solution G of its equation that runs
    backwards, and is not negative, and its integral K: what that gains *)
Lemma tested m a1 a2 c j F U y w G K r t : 0 < m -> j = 1 \/ j = -1 -> 0 <= r <= t -> cont U -> cont y -> cont w ->
  (forall p q, 0 <= p <= q -> Rabs (U q - U p) <= F * (q - p)) ->
  (forall q, r <= q < t -> rderiv y q (w q) /\ rderiv (fun q => m * w q - U q) q (- (a2 * y q + a1 * w q) - c)) ->
  (forall q, is_derive K q (- G q)) -> (forall q, is_derive G q ((a2 * K q + a1 * G q) / m)) ->
  (forall q, r <= q <= t -> 0 <= G q) ->
  j * (m * w t * G t - a2 * (y t * K t) - (m * w r * G r - a2 * (y r * K r))) <= (F - j * c) * (K r - K t).
Proof.
  intros Hm Hj Hr CU Cy Cw L D DK DG P.
  set (f q := j * U q * G q + (j * ((m * w q - U q) * G q - a2 * (y q * K q)) + (F - j * c) * K q)).
  cut (f t <= f r); [unfold f; lra|]. apply dini_mono; [unfold f; continuous|auto|]. intros q Hq.
  destruct (D q Hq) as (Dy & Dw).
  pose proof (dini_lip_mult (fun q => j * U q) G q F _ (t - q) ltac:(lra) ltac:(lra) ltac:(intros p q' Hp; cbv beta;
    rewrite <- Rmult_minus_distr_l, Rabs_sign by auto; auto) ltac:(intros; apply P; lra)
      (rderiv_of_derive _ _ _ (DG q))) as Du.
  eassert (Dr : rderiv (fun q => j * ((m * w q - U q) * G q - a2 * (y q * K q)) + (F - j * c) * K q) q _) by rates.
  eapply dini_eq; [|exact (dini_plus _ _ _ _ _ Du Dr)]. cbv beta. field. lra.
Qed.

Section Transfer.
Context (m1 m2 a1 a2 b D : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (HD : 0 < D).
(** half of the least time *)
Definition half_time := sqrt (m2 * D / b).
Let tau := half_time.
Let be := b / m2.

Lemma be_pos : 0 < be. Proof. positive. Qed.
Lemma tau_pos : 0 < tau. Proof. apply sqrt_lt_R0, Rdiv_lt_0_compat; auto. positive. Qed.
(** D is run through at the acceleration beta and back *)
Lemma tau_sq : be * (tau * tau) = D.
Proof.
  unfold tau, half_time. rewrite sqrt_sqrt. { unfold be. field; lra. } apply Rlt_le, Rdiv_lt_0_compat; auto. positive.
Qed.

(** *** Stuck *)
(** the force of the stuck transfer ([least_time_attained]) *)
Definition stuck_force t := (m1 + m2) * push m2 b half_time t + a1 * bang m2 b half_time t
  + a2 * (run m2 b half_time t - run m2 b half_time 0).

(** in each of its phases the sides of the kinks are known *)
Ltac phase := unfold stuck_force; fold tau; unfold push, bang, run, side; fold be; repeat (destruct Rle_dec; try lra);
  unfold Rabs; repeat (destruct Rcase_abs; try lra); field.
(** while it accelerates *)
Lemma force_first t : 0 <= t < tau -> stuck_force t = (m1 + m2) * be + a1 * (be * t) + a2 * (be * t ^ 2 / 2).
Proof. intros Ht. phase. Qed.
(** while it brakes *)
Lemma force_then t : tau <= t < 2 * tau ->
  stuck_force t = - ((m1 + m2) * be) + a1 * (be * (2 * tau - t)) + a2 * (D - be * (2 * tau - t) ^ 2 / 2).
Proof. intros Ht. pose proof tau_pos. rewrite <- tau_sq. phase. Qed.
(** at the target *)
Lemma force_last t : 2 * tau <= t -> stuck_force t = a2 * D.
Proof. intros Ht. pose proof tau_pos. rewrite <- tau_sq. phase. Qed.

(** [stuck-transfer-amplitude] The amplitude of the force of the fastest stuck transfer over $D$ from $x_1=0$. *)
Theorem stuck_amplitude F : (forall t, 0 <= t -> Rabs (stuck_force t) <= F) <->
  (m1 + m2) * (b / m2) + a1 * sqrt (b / m2 * D) + a2 * D / 2 <= F /\ a2 * D <= F /\
  (a1 ^ 2 * (b / m2) <= a2 ^ 2 * D -> a2 * D + a1 ^ 2 * (b / m2) / (2 * a2) - (m1 + m2) * (b / m2) <= F).
Proof.
  pose proof tau_pos as Tp. pose proof be_pos as Bp. pose proof tau_sq as T2. fold be.
  assert (Sq : sqrt (be * D) = be * tau).
  { rewrite <- T2. replace (be * (be * (tau * tau))) with ((be * tau) ^ 2) by ring. apply sqrt_pow2. nra. }
  rewrite Sq. assert (HD2 : a2 * D / 2 = a2 * (be * tau ^ 2 / 2)) by (rewrite <- T2; field).
  assert (M0 : 0 < (m1 + m2) * be) by positive. assert (Cond : a1 ^ 2 * be <= a2 ^ 2 * D <-> a1 <= a2 * tau).
  { rewrite <- T2. replace (a2 ^ 2 * (be * (tau * tau))) with ((a2 * tau) ^ 2 * be) by ring.
    assert (0 < a2 * tau) by positive. split; intros Q.
    - apply sq_le_abs; [lra|]. apply Rmult_le_reg_r with be; auto.
    - apply Rmult_le_compat_r; [lra|]. apply pow_incr. lra. }
  rewrite Cond. split.
  - intros H. assert (HDF : a2 * D <= F).
    { specialize (H (2 * tau) ltac:(lra)). rewrite force_last in H by lra. apply Rabs_inv in H. lra. }
    split; [|split; [auto|]].
    + rewrite HD2. set (f := fun t => (m1 + m2) * be + a1 * (be * t) + a2 * (be * t ^ 2 / 2)). change (f tau <= F).
      apply (cont_le f F 0 tau); [|lra|].
      * apply cont_of_derive with (fun t => a1 * be + a2 * (be * t)). intros t. unfold f. auto_derive; auto. field.
      * intros t Ht. specialize (H t ltac:(lra)). rewrite force_first in H by lra. apply Rabs_inv in H. unfold f. lra.
    + intros Little.
      destruct (Req_dec a1 0) as [Z|N]. { rewrite Z. replace (0 ^ 2 * be / (2 * a2)) with 0 by (field; lra). lra. }
      assert (R0 : 0 < a1 / a2) by positive. assert (R1 : a1 / a2 <= tau) by (undivide a2; lra).
      specialize (H (2 * tau - a1 / a2) ltac:(lra)). rewrite force_then in H by lra. apply Rabs_inv in H.
      replace (2 * tau - (2 * tau - a1 / a2)) with (a1 / a2) in H by ring.
      replace (a2 * D + a1 ^ 2 * be / (2 * a2) - (m1 + m2) * be)
        with (- ((m1 + m2) * be) + a1 * (be * (a1 / a2)) + a2 * (D - be * (a1 / a2) ^ 2 / 2)) by (field; lra). lra.
  - intros (F1 & F2 & F3) t Ht. rewrite HD2 in F1.
    destruct (Rlt_dec t tau) as [l|l]; [|destruct (Rlt_dec t (2 * tau)) as [l'|l']].
    + rewrite force_first by lra. assert (0 <= a1 * (be * t)) by positive.
      assert (0 <= a2 * (be * t ^ 2 / 2)) by positive.
      assert (0 <= be * (tau - t) * (a1 + a2 * ((tau + t) / 2))) by positive. apply Rabs_le. lra.
    + rewrite force_then by lra. set (r := 2 * tau - t). assert (Hr : 0 < r <= tau) by (unfold r; lra).
      assert (A1 : 0 <= a1 * (be * r)) by positive.
      assert (r ^ 2 <= tau * tau) by nra. assert (A2 : 0 <= a2 * (D - be * r ^ 2 / 2)).
      { apply Rmult_le_pos; [lra|]. rewrite <- T2. nra. }
      assert (P1 : 0 <= a1 * (be * tau)) by positive. assert (P2 : 0 <= a2 * (be * tau ^ 2 / 2)) by positive.
      apply Rabs_le. split; [lra|]. destruct (Rle_dec a1 (a2 * tau)) as [Little|Much].
      * specialize (F3 Little). eapply Rle_trans; [|exact F3].
        replace (- ((m1 + m2) * be) + a1 * (be * r) + a2 * (D - be * r ^ 2 / 2))
          with (a2 * D + a1 ^ 2 * be / (2 * a2) - (m1 + m2) * be - be / (2 * a2) * (a1 - a2 * r) ^ 2) by (field; lra).
        assert (0 <= be / (2 * a2) * (a1 - a2 * r) ^ 2); [|lra]. apply Rmult_le_pos; [|positive].
        apply Rlt_le, Rdiv_lt_0_compat; lra.
      * eapply Rle_trans; [|exact F1].
        assert (0 <= be * (tau - r) * (a1 - a2 * (tau + r) / 2)). { apply Rmult_le_pos; nra. }
        replace (a2 * (D - be * r ^ 2 / 2)) with (a2 * D - a2 * be * r ^ 2 / 2) by field. rewrite <- T2. nra.
    + rewrite force_last by lra. assert (0 < a2 * D) by positive. apply Rabs_le. lra.
Qed.

(** *** With slip *)
(** body 2 arrives in the least time only at full acceleration *)
Lemma fastest U x v1 v2 s x2 : forced m1 m2 a1 a2 b U x v1 v2 s -> cont x2 -> (forall t, 0 <= t ->
  rderiv x2 t (v2 t)) ->
  v2 0 = 0 -> v2 (2 * tau) = 0 -> x2 (2 * tau) - x2 0 = D -> forall t, 0 <= t <= tau -> v2 t = be * t.
Proof.
  intros H C R Z0 ZT ED t Ht. pose proof tau_pos as Tp. pose proof be_pos as Bp. pose proof tau_sq as T2.
  assert (L : forall p q, 0 <= p <= q -> Rabs (v2 q - v2 p) <= be * (q - p)).
  { intros p q Hp. exact (only_gentle m1 m2 a1 a2 b Hm2 Hb _ _ _ _ _ p q H Hp). }
  pose proof (travel x2 v2 be t Bp ltac:(lra) C R L) as A.
  pose proof (travel (fun u => x2 (t + u)) (fun u => v2 (t + u)) be (2 * tau - t) Bp ltac:(lra)) as B.
  specialize (B ltac:(apply cont_shift; auto; lra) ltac:(intros; apply rderiv_earlier, R; lra)
    ltac:(intros p q Hp; replace (q - p) with (t + q - (t + p)) by ring; apply L; lra)).
  cbv beta in B. rewrite Rplus_0_r in B. replace (t + (2 * tau - t)) with (2 * tau) in B by ring.
  rewrite Z0 in A. rewrite ZT in B. pose proof (L 0 t ltac:(lra)) as Lt. rewrite Z0 in Lt. apply Rabs_inv in Lt.
  set (q := v2 t / be) in *. assert (Eq : v2 t = be * q) by (unfold q; field; lra). rewrite Eq in *.
  replace ((be * q - 0) / be) with q in A by (field; lra). replace ((0 - be * q) / be) with (- q) in B by (field; lra).
  assert (Hq : q <= t) by (apply Rmult_le_reg_l with be; lra).
  assert (K : 0 <= be * ((q - t) * (tau - (t + q) / 2))) by (rewrite <- T2 in ED; nra).
  assert (K' : 0 <= (q - t) * (tau - (t + q) / 2)) by (apply Rmult_le_reg_l with be; lra).
  f_equal. destruct (Req_dec q t) as [|N]; auto. exfalso. assert (0 < (t - q) * (tau - (t + q) / 2)) by positive. lra.
Qed.

(** [arrival-needs] To bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, a force needs an
    amplitude of at least $b+\beta\tau/g(\tau)$, where $g$ is body 1's impulse response and $g'\geqslant 0$ up to
    $\tau$. *)
Theorem arrival_needs (g g' : R -> R) U x v1 v2 s x2 F : (forall t, is_derive g t (g' t)) ->
  (forall t, is_derive g' t (- (a2 * g t + a1 * g' t) / m1)) -> g 0 = 0 -> g' 0 = / m1 ->
  (forall t, 0 <= t <= tau -> 0 <= g' t) -> 0 < g tau ->
  (forall r t, 0 <= r <= t -> Rabs (U t - U r) <= F * (t - r)) -> forced m1 m2 a1 a2 b U x v1 v2 s ->
  x 0 = 0 -> v1 0 = 0 -> v2 0 = 0 -> cont x2 -> (forall t, 0 <= t -> rderiv x2 t (v2 t)) ->
  x2 (2 * tau) - x2 0 = D -> v2 (2 * tau) = 0 -> b + be * tau / g tau <= F.
Proof.
  intros Dg Dg' G0 G0' Gp Gt LU H X0 V0 W0 C R ED ZT. pose proof tau_pos as Tp. pose proof be_pos as Bp.
  pose proof (fastest _ _ _ _ _ _ H C R W0 ZT ED) as Full. assert (Es : forall t, 0 <= t <= tau -> s t = s 0 + t).
  { intros t Ht. pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H 0 t ltac:(lra) ltac:(lra)) as Q. rewrite Full,
    W0 in Q by lra. fold be in Q. apply Rmult_eq_reg_l with be; lra. }
  assert (Ahead : be * tau <= v1 tau).
  { rewrite <- (Full tau) by lra. cut (v2 tau - v1 tau <= 0); [lra|].
    apply (cont_le (fun t => v2 t - v1 t) 0 0 tau); [|lra|].
    { continuous. }
    intros t Ht. apply Rnot_lt_le. intros N. assert (S1 : rderiv s t 1).
    { apply rderiv_near with (fun u => s 0 + u) (tau - t); [lra|intros; symmetry; apply Es; lra|].
      apply rderiv_of_derive. auto_derive; auto. }
    pose proof (rderiv_unique _ _ _ _ S1 (f_neg _ _ _ _ _ _ _ _ _ _ H t ltac:(lra) ltac:(lra))). lra. }
  pose proof (tested m1 a1 a2 b 1 F U x v1 (fun t => g' (tau - t)) (fun t => g (tau - t)) 0 tau Hm1 ltac:(auto)
    ltac:(lra)
    ltac:(continuous) ltac:(continuous) ltac:(continuous) LU) as Q. cbv beta in Q.
  replace (tau - tau) with 0 in Q by ring. replace (tau - 0) with tau in Q by ring. rewrite X0, V0, G0, G0' in Q.
  assert (be * tau <= (F - b) * g tau).
  { apply Rle_trans with (1 := Ahead). replace (v1 tau) with (m1 * v1 tau * / m1) by (field; lra).
    assert (1 * (m1 * v1 tau * / m1 - a2 * (x tau * 0) - (m1 * 0 * g' tau - a2 * (0 * g tau))) <= (F - 1 * b) *
      (g tau - 0)); [apply Q|lra].
    - intros t Ht. split; [rates|].
      apply rderiv_near with (fun u => m1 * v1 u + b * s u - U u - b * (s 0 + u)) (tau - t); [lra| |rate; ring].
      intros u Hu. rewrite (Es u) by lra. ring.
    - intros t. derive. unfold Rminus. ring.
    - intros t. derive. unfold Rminus. field. lra.
    - intros t Ht. apply Gp. lra. }
  cut (be * tau / g tau <= F - b); [lra|]. undivide (g tau). auto.
Qed.
End Transfer.
