(** Every solution tends to one stuck motion; it merges with it in finite time or it is on the critical ellipse. *)
From InertialPair Require Import Dini Pair Stick TurnedFrame EnergyLimit Interface.

Section Dichotomy.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).

Context (E := fun t => energy m1 m2 a2 (x t) (v1 t) (v2 t)) (X := X m1 m2 a2) (V := V m1 m2 a2)
  (distance := fun x0 v0 t => energy m1 m2 a2 (x t - X x0 v0 t) (v1 t - V x0 v0 t) (v2 t - V x0 v0 t)).

(** [convergence] Every solution tends to one stuck motion. *)
Theorem convergence : exists x0 v0, energy m1 m2 a2 x0 v0 v0 <= Ecr m1 m2 a2 b /\
  (forall t, 0 <= t -> energy m1 m2 a2 x0 v0 v0 <= E t) /\
  (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> E t <= energy m1 m2 a2 x0 v0 v0 + e) /\
  (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> distance x0 v0 t <= e).
Proof.
  destruct (E_limit m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H) as (l & _ & Hl & Hlim).
  pose proof (limit_not_above m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H l Hl Hlim) as HL.
  destruct (tends m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 (s_cx _ _ _ _ _ _ _ _ _ H) (s_cv _ _ _ _ _ _ _ _ _ H)
    (moves_cv2 m1 m2 0 a2 b Hm2 _ _ _ _ _ _ H) (s_x _ _ _ _ _ _ _ _ _ H) (P_rate m1 m2 a2 b x v1 v2 s H)
    (E_pays m1 m2 a2 b Hm1 Hm2 x v1 v2 s H)
    (solution_synchronises m1 m2 0 a2 Hm1 Hm2 (Rle_refl 0) Ha2 b x v1 v2 s Hb H)) as (x0 & v0 & To & En).
  exists x0, v0. rewrite (En l Hl Hlim). auto.
Qed.

(** [dichotomy] Every solution merges in finite time with an ellipse, or stays above $E_{cr}$ and tends to one motion
    on the critical one. *)
Theorem dichotomy : (exists t0 x0 v0, 0 <= t0 /\ energy m1 m2 a2 x0 v0 v0 <= Ecr m1 m2 a2 b /\
     forall u, 0 <= u -> x (t0 + u) = X x0 v0 u /\ v1 (t0 + u) = V x0 v0 u /\ v2 (t0 + u) = V x0 v0 u) \/
  (exists x0 v0, energy m1 m2 a2 x0 v0 v0 = Ecr m1 m2 a2 b /\ (forall t, 0 <= t -> Ecr m1 m2 a2 b < E t) /\
     forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> distance x0 v0 t <= e).
Proof.
  destruct (Classical_Prop.classic (exists T, 0 <= T /\ E T <= Ecr m1 m2 a2 b)) as [(T & HT & HE)|N].
  - left. destruct (merging m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s T H HT HE) as (t0 & Ht & He & K).
    exists t0, (x t0), (v1 t0). split; [lra|]. split; [exact He|]. exact K.
  - right. destruct convergence as (x0 & v0 & H1 & H2 & H3 & H4).
    assert (Up : forall t, 0 <= t -> Ecr m1 m2 a2 b < E t).
    { intros t Ht. destruct (Rlt_dec (Ecr m1 m2 a2 b) (E t)); auto. exfalso; apply N; exists t; split; auto; lra. }
    exists x0, v0. split; [|split; auto].
    destruct (Rlt_dec (energy m1 m2 a2 x0 v0 v0) (Ecr m1 m2 a2 b)) as [Lt|]; [|lra]. exfalso.
    destruct (H3 ((Ecr m1 m2 a2 b - energy m1 m2 a2 x0 v0 v0) / 2)) as (T & HT & K); [lra|].
    pose proof (K T ltac:(lra)). pose proof (Up T HT). lra.
Qed.
End Dichotomy.
