(** Existence without a force: the case U = 0 of `ForcedExistence.v`. *)
From InertialPair Require Import Dini Pair Forced ForcedExistence.

(** from every start there is a solution *)
Theorem existence m1 m2 a1 a2 b x0 v10 v20 : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b ->
  exists x v1 v2 s, solution m1 m2 a1 a2 b x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb.
  destruct (forced_existence m1 m2 a1 a2 b x0 v10 v20 (fun _ => 0) Hm1 Hm2 Ha1 Ha2 Hb (cont_const 0))
    as (x & v1 & v2 & s & H & St). exists x, v1, v2, s. split; [apply free_case|]; auto.
Qed.

(** [well-posed] From every initial state there is exactly one solution, with or without damping. *)
Theorem well_posed m1 m2 a1 a2 b x0 v10 v20 : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b ->
  exists x v1 v2 s, (solution m1 m2 a1 a2 b x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2' s', solution m1 m2 a1 a2 b x' v1' v2' s' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t /\ s' t - s' 0 = s t - s 0.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb.
  destruct (forced_well_posed m1 m2 a1 a2 b (fun _ => 0) x0 v10 v20 Hm1 Hm2 Ha1 Ha2 Hb (cont_const 0))
    as (x & v1 & v2 & s & (H & St) & Only).
  exists x, v1, v2, s. split; [split; [apply free_case|]; auto|]. intros x' v1' v2' s' H'. apply Only, free_case, H'.
Qed.
