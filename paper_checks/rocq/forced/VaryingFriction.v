(** A friction that changes in time, by pieces: b1 for the time T1, then b2 for T2, ..., and b from then on. A motion
    of such a pair is one of constant friction in each piece. *)
From Coq Require Import List.
From InertialPair Require Import Dini Forced.

(** the motions with the pieces (friction, duration) and the friction b behind the last *)
Fixpoint varying m1 m2 a1 a2 (pieces : list (R * R)) b (U x v1 v2 : R -> R) : Prop :=
  match pieces with
  | nil => exists s, forced m1 m2 a1 a2 b U x v1 v2 s
  | (b1, T) :: later => (exists y w1 w2 s, forced m1 m2 a1 a2 b1 U y w1 w2 s /\
      forall t, 0 <= t <= T -> x t = y t /\ v1 t = w1 t /\ v2 t = w2 t) /\
    varying m1 m2 a1 a2 later b (fun t => U (T + t)) (fun t => x (T + t)) (fun t => v1 (T + t)) (fun t => v2 (T + t))
  end.
