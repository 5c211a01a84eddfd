(** Existence under a force: the interface of one strength. *)
From InertialPair Require Import Dini Pair Forced Interface InterfaceExists.

Lemma forced_existence m1 m2 a1 a2 b x0 v10 v20 U : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b -> cont U ->
  exists x v1 v2 s, forced m1 m2 a1 a2 b U x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb CU.
  destruct (interface_well_posed m1 m2 a1 a2 Hm1 Hm2 Ha1 Ha2 (fun _ => b) (fun t => b * t) U x0 v10 v20 CU)
    as (x & v1 & v2 & F & (H & St) & _).
  - apply cont_scal, (lip_cont _ 1); [lra|]. intros r t Hr. rewrite Rabs_pos_eq; lra.
  - intros t Ht. split; [|lra]. apply rderiv_of_derive. auto_derive; auto. ring.
  - exists x, v1, v2, (fun t => F t / b). split; [apply rubs_constant|]; auto.
Qed.

(** [forced-well-posed] Under any force with a continuous impulse there is exactly one solution from every initial
    state. *)
Theorem forced_well_posed m1 m2 a1 a2 b U x0 v10 v20 : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b -> cont U ->
  exists x v1 v2 s, (forced m1 m2 a1 a2 b U x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2' s', forced m1 m2 a1 a2 b U x' v1' v2' s' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t /\ s' t - s' 0 = s t - s 0.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb CU. destruct (forced_existence m1 m2 a1 a2 b x0 v10 v20 U Hm1 Hm2 Ha1 Ha2 Hb CU) as (x
    & v1 & v2 & s & H & X & V & W).
  exists x, v1, v2, s. split; [auto|]. intros x' v1' v2' s' H' X' V' W' t Ht.
  destruct (forced_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ 0 H' H ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra) t Ht) as (X1 & V1 & W1).
  repeat split; auto. pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H 0 t ltac:(lra) Ht) as Q.
  pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H' 0 t ltac:(lra) Ht) as Q'.
  rewrite W in Q. rewrite W1, W' in Q'. apply Rmult_eq_reg_l with (b / m2); [lra|].
    apply Rgt_not_eq, Rdiv_lt_0_compat; auto.
Qed.
