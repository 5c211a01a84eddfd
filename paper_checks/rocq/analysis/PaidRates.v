(** What grows at most in proportion; and what an energy pays for: it has a limit, and a rate that cannot jump comes to
    rest. *)
From InertialPair Require Import Dini Pursuit.

(** y' <= k y gives an exponential: y exp (- k t) does not rise *)
Lemma in_proportion y k t : 0 <= t -> cont y -> (forall u, 0 <= u -> dini_le y u (k * y u)) -> y t <= exp (k * t) * y 0.
Proof.
  intros Ht C D. assert (De : forall u, is_derive (fun u => exp (- k * u)) u (- k * exp (- k * u))).
  { intros u. auto_derive; auto. ring. }
  assert (Q : y t * exp (- k * t) <= y 0 * exp (- k * 0)).
  { apply (dini_mono (fun u => y u * exp (- k * u))); [apply cont_mult; auto; eapply cont_of_derive, De|lra|].
    intros u Hu e He. pose proof (exp_pos (- k * u)) as Ep. set (e' := e / (2 * exp (- k * u))).
    assert (He' : 0 < e') by positive. destruct (D u ltac:(lra) e' He') as (d & Hd & K).
    assert (R : rderiv (fun r => (y u + (k * y u + e') * (r - u)) * exp (- k * r)) u (e / 2)).
    { apply rderiv_of_derive. auto_derive; auto. unfold e', Rminus. rewrite Rplus_opp_r. field. lra. }
    destruct (R (e / 2) ltac:(lra)) as (d' & Hd' & K'). smaller d d'. intros h Hh. specialize (K h ltac:(lra)).
    specialize (K' h ltac:(lra)). apply Rabs_inv in K'. pose proof (exp_pos (- k * (u + h))).
    replace (u + h - u) with h in K' by ring. replace (u - u) with 0 in K' by ring. nra. }
  rewrite Rmult_0_r, exp_0 in Q. replace (y t) with (exp (k * t) * (y t * exp (- k * t))).
  - apply Rmult_le_compat_l; [apply Rlt_le, exp_pos|lra].
  - rewrite Rmult_comm, Rmult_assoc, <- exp_plus. replace (- k * t + k * t) with 0 by ring. rewrite exp_0. ring.
Qed.

(** a path that an energy pays for as it goes is paid for *)
Lemma paid_along E c f J r t : cont E -> cont J -> (forall u, 0 <= u -> rderiv J u (f u)) ->
  (forall u, 0 <= u -> dini_le E u (- (c * f u))) -> 0 <= r <= t -> c * (J t - J r) <= E r - E t.
Proof.
  intros CE CJ HJ D Hr. cut (E t + c * J t <= E r + c * J r); [lra|].
  apply (dini_mono (fun u => E u + c * J u)); auto using cont_plus, cont_scal. intros u Hu.
  eapply dini_weaken; [|exact (dini_plus _ _ _ _ _ (D u ltac:(lra)) (rderiv_scal c _ _ _ (HJ u ltac:(lra))))]. lra.
Qed.
Lemma path_paid E c f r t : cont E -> cont f -> (forall u, 0 <= u -> dini_le E u (- (c * f u))) -> 0 <= r <= t ->
  c * (integral f t - integral f r) <= E r - E t.
Proof. intros CE Cf. apply paid_along; auto using integral_cont. intros u Hu. apply integral_rderiv; auto. Qed.

(** what an energy pays for converges; at a rate that cannot jump it comes to rest *)
Section Paid.
Variables (E : R -> R) (c : R).
Hypotheses (Ep : forall t, 0 <= t -> 0 <= E t) (Em : forall r t, 0 <= r <= t -> E t <= E r) (Hc : 0 < c).

(** what moves only at the cost of energy has a limit *)
Lemma paid_converges z : (forall r t, 0 <= r <= t -> c * Rabs (z t - z r) <= E r - E t) -> exists zl,
  (forall t, 0 <= t -> c * Rabs (z t - zl) <= E t) /\
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (z t - zl) <= e.
Proof.
  intros Pay. destruct (dec_limit E Em Ep) as (l & L0 & Lo & Lim). assert (Ic : 0 < / c) by positive.
  assert (Back : forall u v, u <= / c * v <-> c * u <= v).
  { intros u v. split; intros Q; [apply Rmult_le_reg_l with (/ c)|apply Rmult_le_reg_l with c]; auto;
    rewrite <- Rmult_assoc; [rewrite Rinv_l|rewrite Rinv_r]; lra. }
  destruct (paid_limit E z (/ c) l) as (zl & B); [lra|auto|intros r t Hr; apply Back; auto|].
  exists zl. split. { intros t Ht. pose proof (proj1 (Back _ _) (B t Ht)). lra. }
  intros e He. destruct (Lim (c * e)) as (T & HT & K); [nra|]. exists T; split; auto. intros t Ht.
  specialize (K t Ht). apply Rle_trans with (1 := B t ltac:(lra)). apply Rmult_le_reg_l with c; auto.
  rewrite <- Rmult_assoc, Rinv_r; lra.
Qed.

(** a Lipschitz rate f of a path J that the energy pays for tends to 0 *)
Lemma paid_vanishes f J K : cont J -> (forall t, 0 <= t -> 0 <= f t /\ rderiv J t (f t)) -> 0 < K ->
  (forall r t, 0 <= r <= t -> Rabs (f t - f r) <= K * (t - r)) -> (forall r t, 0 <= r <= t -> c * (J t - J r) <= E r - E
    t) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> f t <= e.
Proof.
  intros CJ HJ HK Lf Pay e He. destruct (dec_limit E Em Ep) as (l & _ & Lo & Lim).
  assert (Hd : 0 < e / (2 * K)) by positive. destruct (Lim (c * (e / 2 * (e / (2 * K))) / 2)) as (T & HT & Near).
  { positive. }
  exists T; split; auto. intros t Ht. apply Rnot_lt_le. intros N. set (d := e / (2 * K)) in *.
  assert (K * d = e / 2) by (unfold d; field; lra).
  destruct (between J f (e / 2) (f t + K * d) t (t + d) CJ) as (Q & _); [lra| |].
  { intros u Hu. split; [apply HJ; lra|]. pose proof (Lf t u ltac:(lra)) as L. apply Rabs_inv in L.
    assert (K * (u - t) <= K * d) by scale. lra. }
  pose proof (Pay t (t + d) ltac:(lra)) as P. pose proof (Near t Ht). pose proof (Lo (t + d) ltac:(lra)).
  assert (c * (e / 2 * d) <= c * (J (t + d) - J t)) by (apply Rmult_le_compat_l; lra).
  assert (0 < c * (e / 2 * d)) by positive. lra.
Qed.
End Paid.
