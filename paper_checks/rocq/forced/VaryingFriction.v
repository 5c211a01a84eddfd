(** A friction that changes in time, by pieces: b1 for the time T1, then b2 for T2, ..., and b from then on. A motion
    of such a pair is one of constant friction in each piece; it exists from every start, it is the only one, and two
    of them never move apart in the energy norm. *)
From Coq Require Import List.
From InertialPair Require Import Dini Pair Stick Pursuit Forced ForcedExistence Arcs.

Section Varying.
Variables m1 m2 a1 a2 : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2).
Let energy := energy m1 m2 a2.

(** the motions with the pieces (friction, duration) and the friction b behind the last *)
Fixpoint varying (pieces : list (R * R)) b (U x v1 v2 : R -> R) : Prop :=
  match pieces with
  | nil => exists s, forced m1 m2 a1 a2 b U x v1 v2 s
  | (b1, T) :: later => (exists y w1 w2 s, forced m1 m2 a1 a2 b1 U y w1 w2 s /\
      forall t, 0 <= t <= T -> x t = y t /\ v1 t = w1 t /\ v2 t = w2 t) /\
    varying later b (fun t => U (T + t)) (fun t => x (T + t)) (fun t => v1 (T + t)) (fun t => v2 (T + t))
  end.

(** all pieces have a friction, and none has a negative duration *)
Definition sound (pieces : list (R * R)) := forall p, In p pieces -> 0 < fst p /\ 0 <= snd p.

(** two motions never move apart *)
Theorem varying_contraction pieces b : 0 < b -> sound pieces -> forall U x v1 v2 x' v1' v2',
  varying pieces b U x v1 v2 -> varying pieces b U x' v1' v2' -> forall r t, 0 <= r <= t ->
  energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r).
Proof.
  intros Hb. induction pieces as [|(b1, T) later IH]; intros So U x v1 v2 x' v1' v2' H H' r t Hr.
  - destruct H as (s & H), H' as (s' & H'). exact (forced_contraction m1 m2 a1 a2 b Hm1 Hm2 Ha1 Hb _ _ _ _ _ _ _ _ _ r
    t H H' Hr).
  - destruct (So (b1, T) (or_introl eq_refl)) as (Hb1 & HT). simpl in Hb1, HT.
    destruct H as ((y & w1 & w2 & s & F & E) & H), H' as ((y' & w1' & w2' & s' & F' & E') & H').
    assert (First : forall r t, 0 <= r <= t -> t <= T ->
      energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r)).
    { intros p q Hp Hq. destruct (E p ltac:(lra)) as (-> & -> & ->), (E q ltac:(lra)) as (-> & -> & ->),
        (E' p ltac:(lra)) as (-> & -> & ->), (E' q ltac:(lra)) as (-> & -> & ->).
      exact (forced_contraction m1 m2 a1 a2 b1 Hm1 Hm2 Ha1 Hb1 _ _ _ _ _ _ _ _ _ p q F F' Hp). }
    assert (Then : forall r t, T <= r <= t ->
      energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r)).
    { intros p q Hp. pose proof (IH (fun z Hz => So z (or_intror Hz)) _ _ _ _ _ _ _ H H' (p - T) (q - T) ltac:(lra))
      as Q. cbv beta in Q.
      replace (T + (q - T)) with q in Q by ring. replace (T + (p - T)) with p in Q by ring. exact Q. }
    destruct (Rle_dec t T) as [l|l]; [apply First; lra|]. destruct (Rle_dec T r) as [l'|l']; [apply Then; lra|].
    eapply Rle_trans; [apply (Then T t); lra|apply First; lra].
Qed.

(** only the times from 0 on matter *)
Lemma forced_equal b U x v1 v2 s x' v1' v2' : (forall t, 0 <= t -> x t = x' t /\ v1 t = v1' t /\ v2 t = v2' t) ->
  forced m1 m2 a1 a2 b U x v1 v2 s -> forced m1 m2 a1 a2 b U x' v1' v2' s.
Proof.
  intros E [L P N CU CX CV X V W]. constructor; auto.
  - intros t Ht. destruct (E t Ht) as (_ & <- & <-). auto.
  - intros t Ht. destruct (E t Ht) as (_ & <- & <-). auto.
  - apply cont_ext with x; auto. intros t Ht. apply E; auto.
  - apply cont_ext with v1; auto. intros t Ht. apply E; auto.
  - intros t Ht. destruct (E t Ht) as (_ & <- & _). apply rderiv_ext with x; auto. intros r Hr. apply E; lra.
  - intros t Ht. destruct (E t Ht) as (<- & <- & _). apply rderiv_ext with (fun r => m1 * v1 r + b * s r - U r); auto.
    intros r Hr. destruct (E r ltac:(lra)) as (_ & -> & _). auto.
  - intros t Ht. destruct (E t Ht) as (_ & _ & <-), (E 0 (Rle_refl 0)) as (_ & _ & <-). auto.
Qed.
(** in all pieces *)
Lemma varying_equal pieces b : sound pieces -> forall U x v1 v2 x' v1' v2', (forall t, 0 <= t ->
  x t = x' t /\ v1 t = v1' t /\ v2 t = v2' t) ->
  varying pieces b U x v1 v2 -> varying pieces b U x' v1' v2'.
Proof.
  induction pieces as [|(b1, T) later IH]; intros So U x v1 v2 x' v1' v2' E H.
  - destruct H as (s & H). exists s. apply (forced_equal b U x v1 v2); auto.
  - destruct (So (b1, T) (or_introl eq_refl)) as (_ & HT). simpl in HT. destruct H as ((y & w1 & w2 & s & F & K) & H).
    split.
    + exists y, w1, w2, s. split; [auto|]. intros t Ht. destruct (E t ltac:(lra)) as (<- & <- & <-). auto.
    + refine (IH (fun z Hz => So z (or_intror Hz)) _ _ _ _ _ _ _ _ H). intros t Ht. apply E. lra.
Qed.

(** from every start there is a motion *)
Lemma varying_exists pieces b : 0 < b -> sound pieces -> forall U x0 v10 v20, cont U ->
  exists x v1 v2, varying pieces b U x v1 v2 /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20.
Proof.
  intros Hb. induction pieces as [|(b1, T) later IH]; intros So U x0 v10 v20 CU.
  - destruct (forced_existence m1 m2 a1 a2 b x0 v10 v20 U Hm1 Hm2 Ha1 Ha2 Hb CU) as (x & v1 & v2 & s & H & St).
    exists x, v1, v2. split; [exists s; auto|auto].
  - destruct (So (b1, T) (or_introl eq_refl)) as (Hb1 & HT). simpl in Hb1, HT.
    destruct (forced_existence m1 m2 a1 a2 b1 x0 v10 v20 U Hm1 Hm2 Ha1 Ha2 Hb1 CU) as (y & w1 & w2 & s & F & Y0 & W10
      & W20).
    destruct (IH (fun z Hz => So z (or_intror Hz)) (fun t => U (T + t)) (y T) (w1 T) (w2 T) (cont_shift U T HT CU))
      as (z & u1 & u2 & H & Z0 & U10 & U20).
    exists (join T y z), (join T w1 u1), (join T w2 u2). split; [split|].
    + exists y, w1, w2, s. split; [auto|]. intros t Ht. rewrite !join_before by (auto; lra). auto.
    + refine (varying_equal later b (fun z Hz => So z (or_intror Hz)) _ _ _ _ _ _ _ _ H). intros t Ht.
      rewrite !join_after by lra. replace (T + t - T) with t by ring. auto.
    + rewrite !join_before by (auto; lra). auto.
Qed.

(** and only one *)
Theorem varying_well_posed pieces b U x0 v10 v20 : 0 < b -> sound pieces -> cont U ->
  exists x v1 v2, (varying pieces b U x v1 v2 /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2', varying pieces b U x' v1' v2' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t.
Proof.
  intros Hb So CU. destruct (varying_exists pieces b Hb So U x0 v10 v20 CU) as (x & v1 & v2 & H & X0 & V0 & W0).
  exists x, v1, v2. split; [auto|]. intros x' v1' v2' H' X0' V0' W0' t Ht.
  pose proof (varying_contraction pieces b Hb So U _ _ _ _ _ _ H' H 0 t ltac:(lra)) as C.
  rewrite X0, V0, W0, X0', V0', W0' in C. unfold energy in C.
  replace (Pair.energy m1 m2 a2 (x0 - x0) (v10 - v10) (v20 - v20)) with 0 in C by (unfold Pair.energy; field).
  apply (energy_zero m1 m2 a2 Hm1 Hm2 Ha2) in C. lra.
Qed.
End Varying.
