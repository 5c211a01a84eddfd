(** a1 > 0: under a periodic bounded force there is exactly one periodic motion of (x, v1, v2), and every motion tends
    to it. The states of any motion at 0, P, 2P, ... have a cluster point z (bounded), consecutive ones approach each
    other, and the period map does not increase distances: so it fixes z. *)
From Coq Require Import ConstructiveEpsilon.
From InertialPair Require Import Dini Pair Forced ForcedExistence BoundedMotions Arcs.

(** a bounded sequence converges along some phi with n <= phi n *)
Lemma subseq (u : nat -> R) B : (forall n, Rabs (u n) <= B) -> exists l (phi : nat -> nat), (forall n,
  (n <= phi n)%nat) /\
  forall e, 0 < e -> exists N, forall n, (N <= n)%nat -> Rabs (u (phi n) - l) < e.
Proof.
  intros HB. destruct (Bolzano_Weierstrass u (fun c => - B <= c <= B) (compact_P3 (- B) B)) as (l & A).
  { intros n. apply Rabs_inv, HB. }
  assert (Ex : forall n, exists m, (n <= m)%nat /\ Rabs (u m - l) < / (INR n + 1)).
  { intros n. assert (P : 0 < / (INR n + 1)) by (apply Rinv_0_lt_compat; pose proof (pos_INR n); lra).
    destruct (A (disc l (mkposreal _ P)) n) as (m & Hm & D). { exists (mkposreal _ P). intros y Hy; exact Hy. }
      exists m. split; [exact Hm|exact D]. }
  set (phi := fun n => proj1_sig (constructive_indefinite_ground_description_nat (fun m => (n <= m)%nat /\
    Rabs (u m - l) < / (INR n + 1))
    (fun m => ltac:(destruct (Compare_dec.le_dec n m), (Rlt_dec (Rabs (u m - l)) (/ (INR n + 1))); [left;
      auto|right; tauto|right; tauto|right; tauto])) (Ex n))).
  assert (Ph : forall n, (n <= phi n)%nat /\ Rabs (u (phi n) - l) < / (INR n + 1)).
  { intros n. unfold phi. match goal with |- context [proj1_sig ?z] => destruct z as (m & Hm); simpl; auto end. }
  exists l, phi. split; [intros n; apply Ph|]. intros e He.
  destruct (archimed_cor1 e He) as (N & HN & Np). exists N. intros n Hn. destruct (Ph n) as (_ & Q).
    eapply Rlt_le_trans; [exact Q|].
  apply Rle_trans with (/ INR N); [|lra]. apply Rinv_le_contravar; [apply lt_0_INR; lia|]. apply le_INR in Hn. lra.
Qed.

(** three bounded sequences have a common cluster point *)
Lemma cluster (u v w : nat -> R) B : (forall n, Rabs (u n) <= B /\ Rabs (v n) <= B /\ Rabs (w n) <= B) ->
  exists x y z, forall e N, 0 < e -> exists n, (N <= n)%nat /\ Rabs (u n - x) < e /\ Rabs (v n - y) < e /\
    Rabs (w n - z) < e.
Proof.
  intros HB. destruct (subseq u B) as (x & f & Hf & Cf); [intros; apply HB|].
  destruct (subseq (fun n => v (f n)) B) as (y & g & Hg & Cg); [intros; apply HB|].
  destruct (subseq (fun n => w (f (g n))) B) as (z & h & Hh & Ch); [intros; apply HB|].
  exists x, y, z. intros e N He. destruct (Cf e He) as (N1 & C1). destruct (Cg e He) as (N2 & C2).
    destruct (Ch e He) as (N3 & C3).
  set (n := (N + N1 + N2 + N3)%nat). pose proof (Hh n). pose proof (Hg (h n)). pose proof (Hf (g (h n))).
  exists (f (g (h n))). repeat split; [unfold n in *; lia|apply C1; unfold n in *; lia|apply C2; unfold n in *;
    lia|apply C3; unfold n in *; lia].
Qed.

Section Periodic.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 < a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let forced := forced m1 m2 a1 a2 b.
Let energy := energy m1 m2 a2.

(** a triangle inequality for the energy *)
Lemma energy_3 x y z x' y' z' x'' y'' z'' p q r : energy (x - p) (y - q) (z - r) <=
  3 * (energy (x - x') (y - y') (z - z') + energy (x' - x'') (y' - y'') (z' - z'')
    + energy (x'' - p) (y'' - q) (z'' - r)).
Proof.
  assert (S : forall m c d e f, 0 < m -> m * (c - f) ^ 2 <= m *
    (3 * ((c - d) ^ 2 + (d - e) ^ 2 + (e - f) ^ 2))).
  { intros m c d e f Hm. apply Rmult_le_compat_l; [lra|]. pose proof (pow2_ge_0 (c - d - (d - e))).
    pose proof (pow2_ge_0 (d - e - (e - f))). pose proof (pow2_ge_0 (c - d - (e - f))). lra. }
  unfold energy, Pair.energy. pose proof (S a2 x x' x'' p Ha2). pose proof (S m1 y y' y'' q Hm1).
  pose proof (S m2 z z' z'' r Hm2). lra.
Qed.

(** the impulse of a force of period P *)
Variables (U : R -> R) (G P : R).
Hypotheses (HG : 0 <= G) (LU : forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)) (HP : 0 < P)
  (PU : forall t, 0 <= t -> U (P + t) - U P = U t - U 0).

(** a motion after a while is a motion, if the force repeats then *)
Lemma forced_again S x v1 v2 s : 0 <= S -> (forall t, 0 <= t -> U (S + t) - U S = U t - U 0) ->
  forced U x v1 v2 s ->
  forced U (fun u => x (S + u)) (fun u => v1 (S + u)) (fun u => v2 (S + u)) (fun u => s (S + u)).
Proof.
  intros HS E H. apply (forced_ext m1 m2 a1 a2 b (fun u => U (S + u))); [|apply forced_shift; auto].
  intros t Ht. rewrite Rplus_0_r, E by auto. auto.
Qed.
(** as it does after any number of periods *)
Lemma force_again n t : 0 <= t -> U (INR n * P + t) - U (INR n * P) = U t - U 0.
Proof.
  revert t. induction n as [|n IH]; intros t Ht; [simpl; rewrite Rmult_0_l, Rplus_0_l; auto|].
  assert (HnP : 0 <= INR n * P) by (pose proof (pos_INR n); nra). rewrite S_INR.
  replace ((INR n + 1) * P + t) with (P + (INR n * P + t)) by ring.
  replace ((INR n + 1) * P) with (P + INR n * P) by ring.
  pose proof (PU (INR n * P + t) ltac:(lra)). pose proof (PU (INR n * P) HnP). specialize (IH t Ht). lra.
Qed.

(** the motion from the cluster point is periodic *)
Theorem periodic_exists : exists x v1 v2 s, forced U x v1 v2 s /\
  forall t, 0 <= t -> x (P + t) = x t /\ v1 (P + t) = v1 t /\ v2 (P + t) = v2 t.
Proof.
  assert (CU : cont U) by (apply (lip_cont U G); auto).
  destruct (forced_existence m1 m2 a1 a2 b 0 0 0 U Hm1 Hm2 ltac:(lra) Ha2 Hb CU) as (x & v1 & v2 & s & H & _).
  destruct (bounded m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ G H HG LU) as (B & HB).
  assert (HnP : forall n, 0 <= INR n * P) by (intros n; pose proof (pos_INR n); nra).
  destruct (cluster (fun n => x (INR n * P)) (fun n => v1 (INR n * P)) (fun n => v2 (INR n * P)) B) as (p & q & r & Cl).
  { intros n. apply HB; auto. }
  destruct (forced_existence m1 m2 a1 a2 b p q r U Hm1 Hm2 ltac:(lra) Ha2 Hb CU) as (y & w1 & w2 & z & H' & Y0 &
    W10 & W20).
  exists y, w1, w2, z. split; auto. assert (Fix : energy (y P - p) (w1 P - q) (w2 P - r) <= 0).
  { apply le_epsilon. intros e He. rewrite Rplus_0_l.
    destruct (approach m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ G
      (forced_again P _ _ _ _ ltac:(lra) PU H) H HG LU (e / 9)) as (T & HT & Near); [lra|].
    set (d := Rmin 1 (e / 9 / (a2 + m1 + m2))). assert (Hd : 0 < d) by positive. least d.
    destruct (one_turn P T HP HT) as (N & u & ET & Hu). destruct (Cl d (S N) Hd) as (n & Hn & C1 & C2 & C3).
    assert (HnT : T <= INR n * P) by (apply le_INR in Hn; rewrite S_INR in Hn; nra).
    assert (E1 : energy (x (INR n * P) - p) (v1 (INR n * P) - q) (v2 (INR n * P) - r) <= e / 9).
    { assert (Sq : forall m k, 0 < m -> Rabs k < d -> m * k ^ 2 <= m * d).
      { intros m k Hm Hk. apply Rabs_def2 in Hk. apply Rmult_le_compat_l; [lra|nra]. }
      assert (Dm : d * (a2 + m1 + m2) <= e / 9) by (apply Rle_div_r; lra). unfold energy, Pair.energy.
      pose proof (Sq _ _ Ha2 C1). pose proof (Sq _ _ Hm1 C2). pose proof (Sq _ _ Hm2 C3). lra. }
    pose proof (Near (INR n * P) HnT) as E2. fold energy in E2.
    assert (E3 : energy (y P - x (P + INR n * P)) (w1 P - v1 (P + INR n * P)) (w2 P - v2 (P + INR n * P)) <= e / 9).
    { pose proof (forced_contraction m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Hb _ _ _ _ _ _ _ _ _ 0 P H'
        (forced_again (INR n * P) _ _ _ _ (HnP n) (force_again n) H) ltac:(lra)) as Q.
      cbv beta in Q. rewrite Y0, W10, W20, Rplus_0_r, (Rplus_comm (INR n * P) P) in Q. fold energy in Q.
      eapply Rle_trans; [exact Q|]. eapply Rle_trans; [|exact E1]. apply Req_le. unfold energy, Pair.energy. field. }
    pose proof (energy_3 (y P) (w1 P) (w2 P) (x (P + INR n * P)) (v1 (P + INR n * P)) (v2 (P + INR n * P))
      (x (INR n * P)) (v1 (INR n * P)) (v2 (INR n * P)) p q r). lra. }
  apply (energy_zero m1 m2 a2 Hm1 Hm2 Ha2) in Fix. intros t Ht.
  apply (forced_unique m1 m2 a1 a2 b Hm1 Hm2 ltac:(lra) Ha2 Hb _ _ _ _ _ _ _ _ _ 0
    (forced_again P _ _ _ _ ltac:(lra) PU H') H');
    cbv beta; rewrite ?Rplus_0_r; lra.
Qed.

(** [periodic-response] With $a_1>0$ a periodic bounded force has exactly one periodic motion, and it attracts every
    motion. *)
Theorem response : exists x v1 v2 s, forced U x v1 v2 s /\
  (forall t, 0 <= t -> x (P + t) = x t /\ v1 (P + t) = v1 t /\ v2 (P + t) = v2 t) /\
  forall x' v1' v2' s', forced U x' v1' v2' s' ->
  (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> energy (x' t - x t) (v1' t - v1 t) (v2' t - v2 t) <= e) /\
  ((forall t, 0 <= t -> x' (P + t) = x' t /\ v1' (P + t) = v1' t /\ v2' (P + t) = v2' t) ->
    forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t).
Proof.
  destruct periodic_exists as (x & v1 & v2 & s & H & Pe). exists x, v1, v2, s. split; [auto|split; [auto|]].
    intros x' v1' v2' s' H'. split.
  - exact (approach m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ G H' H HG LU).
  - intros Pe'. apply (periodic_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ G P H' H HG LU HP);
    intros t Ht; rewrite Rplus_comm; auto.
Qed.
End Periodic.
