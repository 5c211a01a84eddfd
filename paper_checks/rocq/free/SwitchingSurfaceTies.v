(** Ties: the rates of the relative velocity beside S are what `theory/` derives. A test prints each expression of the
    theory and looks for it in the statement. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini SwitchingSurface.

(** [tie-rate-above] The rate of the relative velocity above $S$: the field's normal component. *)
Theorem tie_rate_above : forall m1 m2 a2 b x : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> normal_rate m1 m2 a2 b (1) x = ((-1) * (/ m1) * (/ m2) * ((b * m1) + (b * m2) + (x * a2 * m2))).
Proof. intros; unfold normal_rate; field; lra. Qed.

(** [tie-rate-below] The rate of the relative velocity below $S$: the field's normal component. *)
Theorem tie_rate_below : forall m1 m2 a2 b x : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> normal_rate m1 m2 a2 b (-1) x = ((-1) * (/ m1) * (/ m2) * (((-1) * b * m1) + ((-1) * b * m2) + (x * a2 * m2))).
Proof. intros; unfold normal_rate; field; lra. Qed.
