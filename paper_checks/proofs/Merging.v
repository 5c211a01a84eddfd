(** Who merges from S0 at the first re-entry, without a hypothesis that there is one: for m1/m2 <= - cos (2 phi* )
    exactly the energies of one closed interval above E_cr. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick Excursion Rate Turning Slip Cycle Orbit Sharp Cross Return Heavy
  Equivalence.
Local Open Scope R_scope.

(** Up to the critical mass ratio the energies on S0 that merge at the first re-entry, after any number of crossings,
    are exactly one closed interval: each solution from S0 above E_cr sticks up to an exit ray at te, and re-enters S0
    at t, for ever or not. *)
Theorem merging_set_energies : exists ps, 0 < ps < PI /\ K ps = 0 /\
  forall m1 m2 a2 b, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> m1 / m2 <= - cos (2 * ps) ->
  exists El Eu, Ecr m1 m2 a2 b < El <= Eu /\ (m1 / m2 < - cos (2 * ps) -> El < Eu) /\
  forall x v1 v2 s t0, solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> v1 t0 = v2 t0 ->
    - L m1 m2 a2 b <= x t0 <= L m1 m2 a2 b ->
  Ecr m1 m2 a2 b < energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) ->
  exists te t, t0 <= te /\ (forall t', t0 <= t' <= te -> v1 t' = v2 t' /\ - L m1 m2 a2 b <= x t' <= L m1 m2 a2 b) /\
    first_reentry (L m1 m2 a2 b) x v1 v2 te t /\
    ((forall u, 0 <= u -> v1 (t + u) = v2 (t + u)) <-> El <= energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) <= Eu).
Proof.
  destruct merging_set as (ps & Hps & Z & Main). exists ps. split; [auto|]. split; [auto|].
  intros m1 m2 a2 b H1 H2 Ha Hb Hr. destruct (Main m1 m2 H1 H2 Hr) as (pl & pu & A1 & A2 & A3 & A4 & A5 & Iff).
  pose proof (q_pos m1 m2 H1 H2) as Q0. pose proof (Ecr_pos m1 m2 a2 b H1 H2 Ha Hb) as E0.
  set (q := m1 / (m1 + m2)) in *. set (Ec := Ecr m1 m2 a2 b) in *. set (lev := fun p => Ec * (1 + q * hh p ^ 2)).
  assert (Inc : forall p p', 0 < p < PI -> 0 < p' < PI -> p < p' -> lev p < lev p').
  { intros p p' Hp Hp' Lt. pose proof (hh_incr p p' ltac:(lra) Lt ltac:(lra)). pose proof (hh_pos p Hp). unfold lev.
    apply Rmult_lt_compat_l; auto. apply Rplus_lt_compat_l, Rmult_lt_compat_l; auto. nra. }
  assert (Le : forall p p', 0 < p < PI -> 0 < p' < PI -> (lev p <= lev p' <-> p <= p')).
  { intros p p' Hp Hp'. split; intros Q.
    - destruct (Rle_dec p p') as [|n]; auto. pose proof (Inc p' p Hp' Hp ltac:(lra)). lra.
    - destruct (Req_dec p p') as [->|]; [lra|]. apply Rlt_le, Inc; auto; lra. }
  exists (lev pl), (lev pu). split.
  { split; [|apply Le; lra]. unfold lev. pose proof (pow_lt _ 2 (hh_pos pl ltac:(lra))) as P.
    pose proof (Rmult_lt_0_compat _ _ E0 (Rmult_lt_0_compat _ _ Q0 P)). lra. }
  split; [intros Hlt; specialize (A5 Hlt); apply Inc; lra|].
  intros x v1 v2 s t0 H Ht Ev Hx HE.
  destruct (round m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H t0 (conj Ht (conj Ev (conj Hx HE))))
    as (k & te & p & t & Hk & Te & Hp & En & St & HR & F & _).
  exists te, t. split; [auto|]. split; [exact St|]. split; [exact F|].
  rewrite (Iff a2 b x v1 v2 s k te t p Ha Hb H Hk ltac:(lra) Hp HR F), En. fold q Ec.
    change (Ec * (1 + q * hh p ^ 2)) with (lev p).
  rewrite !Le by lra. tauto.
Qed.
