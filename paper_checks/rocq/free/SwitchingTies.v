(** Ties: equations (3) and (4) of the paper are what `theory/` derives. A test prints each expression of the
    theory and looks for it in the statement. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Switching.

(** Equations (3) and (4) of the paper at one time, without a control. *)
Theorem tie_switching : forall m1 m2 a1 a2 b (x v1 v2 : R -> R) t, 0 < m2 -> Switching.switched m1 m2 a1 a2 b x v1 v2 t <->
  exists a a' : R, is_derive x t (v1 t) /\ is_derive v1 t a /\ is_derive v2 t a' /\ ((a * (m1 + (m2 * (1 + ((-1) * (Rabs (Switching.sgn ((v1 t) + ((-1) * (v2 t)))))))))) + ((v1 t) * a1) + ((x t) * a2) + (b * (Switching.sgn ((v1 t) + ((-1) * (v2 t)))))) = 0 /\ ((b * (Switching.sgn ((v1 t) + ((-1) * (v2 t))))) + ((-1) * a' * m2) + (a * m2 * (1 + ((-1) * (Switching.sgn (((-1) * b * (/ m2)) + (Rabs a))))) * ((1 / 2) + ((-1 / 2) * (Rabs (Switching.sgn ((v1 t) + ((-1) * (v2 t))))))))) = 0.
Proof. intros m1 m2 a1 a2 b x v1 v2 t Hm; split; intros (a & a' & X & V & W & E3 & E4); exists a, a'; assert (E1 : ((v1 t) + ((-1) * (v2 t))) = v1 t - v2 t) by ring; assert (E2 : (((-1) * b * (/ m2)) + (Rabs a)) = Rabs a - b / m2) by (field; lra);
  rewrite ?E1, ?E2 in *; repeat (split; [assumption|]); split; lra. Qed.
