(** Ties: the law under a force is what `theory/` derives. A test prints each expression of the
    theory and looks for it in the statement. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Forced.

(** [tie-forced] A motion under a force obeys the equations of the theory, with impulses of friction and of the force.
    *)
Theorem tie_forced : forall m1 m2 a1 a2 b (U x v1 v2 s : R -> R), forced m1 m2 a1 a2 b U x v1 v2 s <->
  ((forall r t, 0 <= r <= t -> Rabs (s t - s r) <= t - r) /\
   (forall t, 0 <= t -> 0 < ((v1 t) + ((-1) * (v2 t))) -> rderiv s t 1) /\ (forall t, 0 <= t -> ((v1 t) + ((-1) * (v2 t))) < 0 -> rderiv s t (-1)) /\
   cont U /\ cont x /\ cont v1 /\
   (forall t, 0 <= t -> rderiv x t (v1 t)) /\
   (forall t, 0 <= t -> rderiv (fun t => m1 * v1 t - ((-1) * b) * s t - 1 * U t) t (((-1) * (v1 t) * a1) + ((-1) * (x t) * a2))) /\
   (forall t, 0 <= t -> m2 * v2 t - b * s t = m2 * v2 0 - b * s 0)).
Proof. intros; split.
  - intros [L P N CU CX CV X V W]. split; [auto|]. split; [intros; apply P; lra|]. split; [intros; apply N; lra|].
    split; [auto|]. split; [auto|]. split; [auto|]. split; [auto|]. split; [|auto].
    intros t Ht. eapply rderiv_ext; [|eapply rderiv_eq; [|exact (V t Ht)]]; [intros; cbv beta; ring|ring].
  - intros (L & P & N & CU & CX & CV & X & V & W). constructor; auto.
    + intros; apply P; lra.
    + intros; apply N; lra.
    + intros t Ht. eapply rderiv_ext; [|eapply rderiv_eq; [|exact (V t Ht)]]; [intros; cbv beta; ring|ring]. Qed.
