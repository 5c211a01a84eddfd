(** A solution runs along any smooth arc that obeys the law of friction, as under a force ([follow_arc]); and the mirror
    image of a solution is one. *)
From InertialPair Require Import Dini Pair Forced Arcs.

Section Arc.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).

(** A smooth arc on all of R that obeys the law of friction on [0, T): g is a selection of the set-valued sign. *)
Record arc (T : R) (X V1 V2 g : R -> R) : Prop := {
  a_x : forall t, is_derive X t (V1 t);
  a_v1 : forall t, is_derive V1 t (- (a2 * X t + b * g t) / m1);
  a_v2 : forall t, is_derive V2 t (b * g t / m2);
  a_law : forall t, 0 <= t < T -> -1 <= g t <= 1 /\ (V2 t < V1 t -> g t = 1) /\ (V1 t < V2 t -> g t = -1) }.

(** [follow] A solution that meets the start of an explicit arc that satisfies the law follows it. *)
Theorem follow x v1 v2 s X V1 V2 g T t0 : solution m1 m2 0 a2 b x v1 v2 s -> arc T X V1 V2 g -> 0 <= t0 ->
  x t0 = X 0 -> v1 t0 = V1 0 -> v2 t0 = V2 0 ->
  forall u, 0 <= u <= T -> x (t0 + u) = X u /\ v1 (t0 + u) = V1 u /\ v2 (t0 + u) = V2 u.
Proof.
  intros H [AX AV AW Law] Ht E0 E1 E2 u Hu. apply free_case in H.
  assert (A : forced_arc m1 m2 0 a2 b T (fun _ => 0) X V1 V2 g).
  { constructor; auto. intros t. replace ((0 - a2 * X t - 0 * V1 t - b * g t) / m1) with (- (a2 * X t + b * g t) /
    m1) by (field; lra). apply AV. }
  apply (follow_arc m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb (fun _ => 0) (fun _ => 0) x v1 v2 s X V1 V2 g T t0);
    auto; [lra|].
  intros t _. apply rderiv_const.
Qed.

(** The mirror image of a solution is a solution. *)
Lemma mirror x v1 v2 s : solution m1 m2 0 a2 b x v1 v2 s ->
  solution m1 m2 0 a2 b (fun t => - x t) (fun t => - v1 t) (fun t => - v2 t) (fun t => - s t).
Proof. apply solution_mirror. Qed.
(** On either side it looks the same, and has the same energy. *)
Lemma energy_side k y v w : k = 1 \/ k = -1 -> energy m1 m2 a2 (k * y) (k * v) (k * w) = energy m1 m2 a2 y v
  w.
Proof. unfold energy. intros [->| ->]; field. Qed.
Lemma sided k x v1 v2 s : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s ->
  solution m1 m2 0 a2 b (fun t => k * x t) (fun t => k * v1 t) (fun t => k * v2 t) (fun t => k * s t).
Proof.
  assert (E : forall f g : R -> R, (forall t, f t = g t) -> f = g)
    by exact FunctionalExtensionality.functional_extensionality.
  assert (E1 : forall f : R -> R, (fun t => 1 * f t) = f) by (intros; apply E; intros; ring).
  assert (E2 : forall f : R -> R, (fun t => -1 * f t) = fun t => - f t) by (intros; apply E; intros; ring).
  intros [->| ->] H; [rewrite !E1|rewrite !E2]; auto using mirror.
Qed.
End Arc.
