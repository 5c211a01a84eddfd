(** A friction by pieces in time: the rate of the energy with the friction of the time, and two forces. *)
From Coq Require Import List.
From InertialPair Require Import Dini Pair Stick Pursuit Forced ForcedExistence Arcs VaryingFriction.

(** the friction at a time, of the pieces (friction, duration) and the friction b behind the last *)
Fixpoint friction (pieces : list (R * R)) b t :=
  match pieces with
  | nil => b
  | (b1, T) :: later => if Rlt_dec t T then b1 else friction later b (t - T)
  end.

Section Pieces.
Variables m1 m2 a1 a2 : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2).

(** E' = u v1 - a1 v1^2 - b(t) |v1 - v2| *)
Theorem varying_energy_rate pieces b : 0 < b -> sound pieces -> forall U x v1 v2 t u,
  varying m1 m2 a1 a2 pieces b U x v1 v2 -> 0 <= t -> rderiv U t u ->
  rderiv (fun t => energy m1 m2 a2 (x t) (v1 t) (v2 t)) t
    (u * v1 t - a1 * v1 t ^ 2 - friction pieces b t * Rabs (v1 t - v2 t)).
Proof.
  intros Hb. induction pieces as [|(b1, T) later IH]; intros So U x v1 v2 t u H Ht HU.
  - destruct H as (s & H). exact (forced_energy_rate m1 m2 a1 a2 b Hm1 Hm2 U x v1 v2 s t u H Ht HU).
  - destruct (So (b1, T) (or_introl eq_refl)) as (Hb1 & HT). simpl in Hb1, HT.
    destruct H as ((y & w1 & w2 & s & F & E) & H). simpl. destruct (Rlt_dec t T) as [l|l].
    + destruct (E t ltac:(lra)) as (_ & E1 & E2). rewrite E1, E2.
      apply (rderiv_near (fun t => energy m1 m2 a2 (y t) (w1 t) (w2 t)) _ t _ (T - t)); [lra| |].
      * intros r Hr. destruct (E r ltac:(lra)) as (-> & -> & ->). auto.
      * exact (forced_energy_rate m1 m2 a1 a2 b1 Hm1 Hm2 U y w1 w2 s t u F Ht HU).
    + assert (Et : T + (t - T) = t) by ring.
      assert (HU' : rderiv (fun r => U (T + r)) (t - T) u) by (apply rderiv_earlier; rewrite Et; auto).
      pose proof (IH (fun z Hz => So z (or_intror Hz)) _ _ _ _ (t - T) u H ltac:(lra) HU') as Q. cbv beta in Q.
      rewrite Et in Q. apply rderiv_later in Q. eapply rderiv_ext; [|exact Q]. intros r Hr. cbv beta.
      replace (T + (r - T)) with r by ring. auto.
Qed.

(** two forces: the root of twice the energy distance grows at most by the integral of their difference over sqrt m1 *)
Theorem varying_input_to_state pieces b : 0 < b -> sound pieces -> forall U U' x v1 v2 x' v1' v2' du J,
  varying m1 m2 a1 a2 pieces b U x v1 v2 -> varying m1 m2 a1 a2 pieces b U' x' v1' v2' ->
  (forall t, 0 <= t -> rderiv (fun r => U r - U' r) t (du t)) -> cont J -> (forall t, 0 <= t -> rderiv J t (Rabs (du
    t))) ->
  forall r t, 0 <= r <= t ->
  sqrt (2 * energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t)) <=
  sqrt (2 * energy m1 m2 a2 (x r - x' r) (v1 r - v1' r) (v2 r - v2' r)) + (J t - J r) / sqrt m1.
Proof.
  intros Hb. induction pieces as [|(b1, T) later IH]; intros So U U' x v1 v2 x' v1' v2' du J H H' HU CJ HJ r t Hr.
  - destruct H as (s & H), H' as (s' & H').
    apply (input_to_state m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ _ H H' du J); auto.
    intros u Hu. split; [apply HU|apply HJ]; lra.
  - destruct (So (b1, T) (or_introl eq_refl)) as (Hb1 & HT). simpl in Hb1, HT.
    destruct H as ((y & w1 & w2 & s & F & E) & H), H' as ((y' & w1' & w2' & s' & F' & E') & H').
    set (N := fun t => sqrt (2 * energy m1 m2 a2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t))).
    assert (First : forall p q, 0 <= p <= q -> q <= T -> N q <= N p + (J q - J p) / sqrt m1).
    { intros p q Hp Hq. unfold N. destruct (E p ltac:(lra)) as (-> & -> & ->), (E q ltac:(lra)) as (-> & -> & ->),
        (E' p ltac:(lra)) as (-> & -> & ->), (E' q ltac:(lra)) as (-> & -> & ->).
      apply (input_to_state m1 m2 a1 a2 b1 Hm1 Hm2 Ha1 Ha2 Hb1 _ _ _ _ _ _ _ _ _ _ F F' du J); auto.
      intros u Hu. split; [apply HU|apply HJ]; lra. }
    assert (Then : forall p q, T <= p <= q -> N q <= N p + (J q - J p) / sqrt m1).
    { intros p q Hp. pose proof (IH (fun z Hz => So z (or_intror Hz)) _ _ _ _ _ _ _ _ (fun t => du (T + t)) (fun t =>
      J (T + t)) H H') as Q.
      cbv beta in Q. specialize (Q ltac:(intros z Hz; apply (rderiv_earlier (fun r => U r - U' r)), HU;
        lra) ltac:(apply cont_shift; auto)
        ltac:(intros z Hz; apply rderiv_earlier, HJ; lra) (p - T) (q - T) ltac:(lra)).
      replace (T + (q - T)) with q in Q by ring. replace (T + (p - T)) with p in Q by ring. exact Q. }
    change (N t <= N r + (J t - J r) / sqrt m1).
    destruct (Rle_dec t T) as [l|l]; [apply First; lra|]. destruct (Rle_dec T r) as [l'|l']; [apply Then; lra|].
    pose proof (Then T t ltac:(lra)) as Q1. pose proof (First r T ltac:(lra) ltac:(lra)) as Q2.
    replace ((J t - J r) / sqrt m1) with ((J T - J r) / sqrt m1 + (J t - J T) / sqrt m1) by (unfold Rdiv; ring). lra.
Qed.
End Pieces.
