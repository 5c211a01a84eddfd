(** On S0 the energy alone decides who ever merges: all starts of one energy above E_cr come to the same exit ray, or to
    its mirror image. *)
From Coq Require Import Classical.
From InertialPair Require Import Dini Pair Stick Excursion FollowArc Cycle CycleLength SharpRate SharpLaw AfterOneSlip
  WellPosed.

Section OneEnergy.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (Ecr := Ecr m1 m2 a2 b).

(** at the time t0 the solution is on S0 with the energy e *)
Definition from_S0 e (x v1 v2 : R -> R) t0 := (exists s, solution m1 m2 0 a2 b x v1 v2 s) /\ 0 <= t0 /\ v1 t0 = v2 t0 /\
  - L m1 m2 a2 b <= x t0 <= L m1 m2 a2 b /\ energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) = e.
(** it sticks permanently from some time on *)
Definition merges (v1 v2 : R -> R) := exists T, 0 <= T /\ forall t, T <= t -> v1 t = v2 t.

(** on one exit ray, or on both: the same ever after, but for the sign *)
Lemma from_ray k k' u x v1 v2 s x' v1' v2' s' t t' : solution m1 m2 0 a2 b x v1 v2 s -> solution m1 m2 0 a2 b x' v1' v2' s' ->
  k = 1 \/ k = -1 -> k' = 1 \/ k' = -1 -> 0 <= t -> 0 <= t' -> on_ray m1 m2 a2 b k u x v1 v2 t ->
  on_ray m1 m2 a2 b k' u x' v1' v2' t' -> merges v1 v2 -> merges v1' v2'.
Proof.
  intros H H' Hk Hk' Ht Ht' (X & V & W) (X' & V' & W') (T & HT & St).
  pose proof (solution_later m1 m2 0 a2 b x v1 v2 s t Ht H) as S. pose proof (solution_later m1 m2 0 a2 b x' v1' v2' s' t' Ht' H') as S'.
  assert (Q : forall r, 0 <= r -> v1 (t + r) = v2 (t + r) -> v1' (t' + r) = v2' (t' + r)).
  { intros r Hr Ev. destruct (unique m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb _ _ _ _ _ _ _ _ 0 (sided m1 m2 a2 b k _ _
      _ _ Hk S) (sided m1 m2 a2 b k' _ _ _ _ Hk' S') (Rle_refl 0)) with (t := r) as (_ & E1 & E2); rewrite ?Rplus_0_r;
      try lra. rewrite Ev in E1. destruct Hk'; subst k'; lra. }
  exists (t' + T). split; [lra|]. intros r Hr. replace r with (t' + (r - t')) by ring. apply Q; [lra|]. apply St. lra.
Qed.

(** one that starts with an energy merges if another one does *)
Lemma one_fate e x v1 v2 t x' v1' v2' t' : Ecr < e -> from_S0 e x v1 v2 t -> from_S0 e x' v1' v2' t' ->
  merges v1 v2 -> merges v1' v2'.
Proof.
  intros He ((s & H) & Ht & Ev & Hx & En) ((s' & H') & Ht' & Ev' & Hx' & En').
  destruct (level_push m1 m2 a2 b Hm1 Hm2 Ha2 Hb e He) as (Up & E). set (u := sqrt _) in *. rewrite E in En, En'.
  destruct (to_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H t _ Ht Ev Hx Up En) as (k & r & Hk & Hr & R & _).
  destruct (to_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x' v1' v2' s' H' t' _ Ht' Ev' Hx' Up En') as (k' & r' & Hk' & Hr' & R' & _).
  apply (from_ray k k' u x v1 v2 s x' v1' v2' s' r r' H H'); auto; lra.
Qed.

(** [merging-energies] Of the solutions that are on $S_0$ with one energy above $E_{cr}$ all merge, or none; for
    $0<w\leqslant q(\pi/2-1)^2$ none; and no interval of energies that merge contains two with one between them that
    does not. *)
Theorem merging_energies :
  let all e := forall x v1 v2 t, from_S0 e x v1 v2 t -> merges v1 v2 in
  let none e := forall x v1 v2 t, from_S0 e x v1 v2 t -> ~ merges v1 v2 in
  (forall e, Ecr < e -> all e \/ none e) /\
  (forall e, 0 < e / Ecr - 1 <= q * (PI / 2 - 1) ^ 2 -> none e) /\
  (forall e1 e e2, 0 <= e1 <= e -> e <= e2 -> none e -> ~ forall e', e1 <= e' <= e2 -> all e').
Proof.
  intros all none. pose proof (Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as E0. fold Ecr in E0. split; [|split].
  - intros e He. destruct (classic (exists x v1 v2 t, from_S0 e x v1 v2 t /\ merges v1 v2)) as [(x & v1 & v2 & t & F & M)|No].
    + left. intros x' v1' v2' t' F'. exact (one_fate e x v1 v2 t x' v1' v2' t' He F F' M).
    + right. intros x v1 v2 t F M. apply No. exists x, v1, v2, t. auto.
  - intros e Low x v1 v2 t ((s & H) & Ht & Ev & Hx & En) (T & HT & St). pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. fold q in Q0.
    assert (P : PI / 2 - 1 <= 2 / 3) by (pose proof pi_below; lra). pose proof PI2_1 as P1.
    assert (R : 0 < m2 / (m1 + m2) < 1) by (split; [positive|undivide (m1 + m2); lra]).
    assert (S : small m1 m2 a2 b e).
    { split; fold Ecr q; [apply Rle_trans with (q * (PI / 2 - 1) ^ 2); [lra|apply Rmult_le_compat_l; nra]|].
      apply Rle_lt_trans with (q * (4 / 9)); [apply Rle_trans with (q * (PI / 2 - 1) ^ 2); [lra|apply Rmult_le_compat_l; nra]|].
      replace (4 * q / (9 * (m2 / (m1 + m2)))) with (q * (4 / 9) / (m2 / (m1 + m2))) by (field; lra). undivide (m2 / (m1 + m2)). nra. }
    assert (Up : Ecr < e). { replace e with (Ecr + Ecr * (e / Ecr - 1)) by (field; lra). assert (0 < Ecr * (e / Ecr - 1)) by positive. lra. }
    rewrite <- En in S, Up. destruct (no_merging_from_S0 m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t H Ht Ev Hx Up S) as (NM & _).
    pose proof (proj1 (sticks_iff m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H T HT (St T (Rle_refl T))) ltac:(intros u Hu; apply St; lra)).
    specialize (NM T HT). lra.
  - intros e1 e e2 H1 H2 No All. destruct (existence m1 m2 0 a2 b 0 (sqrt (2 * e / (m1 + m2))) (sqrt (2 * e / (m1 + m2))))
      as (x & v1 & v2 & s & H & X & V & W); auto; [lra|]. assert (F : from_S0 e x v1 v2 0).
    { split; [exists s; exact H|]. rewrite X, V, W. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb). repeat split; try lra.
      unfold energy. assert (0 <= 2 * e / (m1 + m2)) by positive. rewrite pow2_sqrt by auto. field. lra. }
    exact (No _ _ _ _ F (All e ltac:(lra) _ _ _ _ F)).
Qed.
End OneEnergy.
