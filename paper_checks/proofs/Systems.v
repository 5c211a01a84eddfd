(** M q'' + C q' + K q + B^T f = u with the friction f in d psi (B q'), as an instance of `Inclusion`: bodies in any
  number
    of directions, chains, a surface; the dampers C may be any monotone ones. M^-1 is written as an operator of its own.
      *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Inclusion.
Local Open Scope R_scope.

Section Systems.
Context {V W : ModuleSpace R_AbsRing}.
Variables (dot : V -> V -> R) (dotw : W -> W -> R) (M Mi C K : V -> V) (B : V -> W) (Bt : W -> V).

(** the matrices of a system: K and M symmetric, 0 <= K, 0 <= M = Mi^-1, dampers that take energy, Bt the transpose of B
  *)
Record mechanical : Prop := {
  k_form : inner (fun v w => dot (K v) w);
  m_form : inner (fun v w => dot (M v) w);
  dot_inner : inner dot;
  dotw_inner : inner dotw;
  m_inverse : forall f w, dot (M (Mi f)) w = dot f w;
  c_takes : forall v w, 0 <= dot (minus (C v) (C w)) (minus v w);
  b_transposed : forall f v, dot (Bt f) v = dotw f (B v) }.
Hypothesis S : mechanical.

(** twice the energy, as an inner product of the states (q, q') *)
Definition state_ip (y z : V * V) := dot (K (fst y)) (fst z) + dot (M (snd y)) (snd z).
Definition flow (y : V * V) : V * V := (snd y, Mi (opp (plus (K (fst y)) (C (snd y))))).
Definition impulse (I : R -> V) t : V * V := (zero, Mi (I t)).

(** motions, with the impulses U of the force and F of friction *)
Definition moves (U : R -> V) (F : R -> W) (q v : R -> V) :=
  driven state_ip flow (impulse U) (impulse (fun t => Bt (F t))) (fun t => (q t, v t)).
Definition inclusion (psi : W -> R) U F q v := moves U F q v /\ forall t, 0 <= t -> drags dotw psi F (B (v t)) t.

Lemma state_inner : inner state_ip.
Proof.
  destruct S as [Ks Ms _ _ _ _ _]. unfold state_ip. constructor.
  - intros y z. rewrite (ip_sym _ Ks), (ip_sym _ Ms). auto.
  - intros (q, v) (p, w) (o, u). pose proof (ip_plus _ Ks q p o) as Q. pose proof (ip_plus _ Ms v w u) as Q'. cbv beta
    in Q, Q'.
    change (dot (K (plus q p)) o + dot (M (plus v w)) u = dot (K q) o + dot (M v) u + (dot (K p) o + dot (M w) u)). lra.
  - intros c (q, v) (p, w). pose proof (ip_scal _ Ks c q p) as Q. pose proof (ip_scal _ Ms c v w) as Q'. cbv beta in Q,
    Q'.
    change (dot (K (scal c q)) p + dot (M (scal c v)) w = c * (dot (K q) p + dot (M v) w)). lra.
  - intros y. pose proof (ip_pos _ Ks (fst y)). pose proof (ip_pos _ Ms (snd y)). lra.
Qed.

(** the power of an impulse of friction is the one that it has at the contact *)
Lemma friction_work F t u (z : V * V) : state_ip (minus (impulse (fun t => Bt (F t)) u) (impulse (fun t => Bt (F t)) t))
  z =
  dotw (minus (F u) (F t)) (B (snd z)).
Proof.
  rewrite (ip_minus _ state_inner). unfold state_ip, impulse; simpl. rewrite !(m_inverse S), !(b_transposed S).
  rewrite (ip_minus _ (dotw_inner S)). ring.
Qed.
Lemma b_minus f v w : dotw f (B (minus v w)) = dotw f (minus (B v) (B w)).
Proof.
  rewrite <- (b_transposed S), (ip_sym _ (dot_inner S)), (ip_minus _ (dot_inner S)), !(ip_sym _ (dot_inner S) _ (Bt f)),
    !(b_transposed S), (ip_sym _ (dotw_inner S) f (minus _ _)), (ip_minus _ (dotw_inner S)), !(ip_sym _ (dotw_inner S) _
      f). ring.
Qed.

(** springs are neutral, dampers take *)
Lemma flow_monotone : monotone state_ip flow.
Proof.
  intros (q, v) (p, w). pose proof (c_takes S v w) as T. rewrite (ip_minus _ state_inner). unfold state_ip, flow; simpl.
  rewrite !(m_inverse S), !(ip_opp _ (dot_inner S)), !(ip_plus _ (dot_inner S)). rewrite (ip_minus _ (dot_inner S)) in
    T.
  change (snd (minus (q, v) (p, w))) with (minus v w). change (fst (minus (q, v) (p, w))) with (minus q p).
  set (dv := minus v w) in *. set (dq := minus q p).
  assert (Q : dot (K v) dq - dot (K w) dq = dot (K q) dv - dot (K p) dv).
  { pose proof (ip_minus _ (k_form S) v w dq) as Q1. pose proof (ip_minus _ (k_form S) q p dv) as Q2. cbv beta in Q1,
    Q2.
    fold dv in Q1. fold dq in Q2. rewrite <- Q1, <- Q2. apply (ip_sym _ (k_form S)). }
  change (plus q (opp p)) with dq. change (plus v (opp w)) with dv. lra.
Qed.

(** so it is an inclusion in the space of states, with phi (q, q') = psi (B q') *)
Theorem inclusion_motion psi U F q v : inclusion psi U F q v ->
  motion state_ip flow (fun y => psi (B (snd y))) (impulse U) (impulse (fun t => Bt (F t))) (fun t => (q t, v t)).
Proof.
  intros (H & L). split; [exact H|]. intros t Ht z e He. destruct (L t Ht (B (snd z)) e He) as (d & Hd & Q).
  exists d; split; auto. intros h Hh. rewrite friction_work. change (snd (minus z (q t, v t))) with (minus (snd z) (v
    t)).
  rewrite b_minus. apply Q; auto.
Qed.

(** T1: two motions never part by more than the impulse of the difference of their forces *)
Theorem system_defects psi U F q v U' F' q' v' d J r t : inclusion psi U F q v -> inclusion psi U' F' q' v' ->
  (forall u, 0 <= u -> vderiv state_ip (fun r => minus (impulse U r) (impulse U' r)) u (d u)) -> cont J ->
  (forall u, 0 <= u -> rderiv J u (norm state_ip (d u))) -> 0 <= r <= t ->
  norm state_ip (minus (q t, v t) (q' t, v' t)) <= norm state_ip (minus (q r, v r) (q' r, v' r)) + (J t - J r).
Proof.
  intros H H' Hd CJ HJ Hr. exact (defects_add state_ip state_inner flow _ _ _ _ _ _ _ flow_monotone
    (inclusion_motion _ _ _ _ _ H) (inclusion_motion _ _ _ _ _ H') d J r t Hd CJ HJ Hr).
Qed.

(** under one force they never part *)
Theorem system_contracts psi U F q v F' q' v' r t : inclusion psi U F q v -> inclusion psi U F' q' v' -> 0 <= r <= t ->
  norm state_ip (minus (q t, v t) (q' t, v' t)) <= norm state_ip (minus (q r, v r) (q' r, v' r)).
Proof.
  intros H H' Hr. exact (contracts state_ip state_inner flow _ _ _ _ _ _ r t flow_monotone
    (inclusion_motion _ _ _ _ _ H) (inclusion_motion _ _ _ _ _ H') Hr).
Qed.

(** T2: whatever brakes with a power of at least beta |B q'| synchronises, unique or not *)
Theorem system_synchronises F q v beta J : (forall w, 0 <= dot (C w) w) -> 0 < beta -> moves (fun _ => zero) F q v ->
  (forall t, 0 <= t -> brakes dotw (beta * norm dotw (B (v t))) F (B (v t)) t) ->
  cont J -> (forall t, 0 <= t -> rderiv J t (norm dotw (B (v t)))) ->
  (forall t, 0 <= t -> beta * (J t - J 0) <= state_ip (q 0, v 0) (q 0, v 0) / 2) /\
  (forall z, (forall r t, 0 <= r <= t -> Rabs (z t - z r) <= J t - J r) -> exists zl,
    (forall t, 0 <= t -> beta * Rabs (z t - zl) <= state_ip (q t, v t) (q t, v t) / 2) /\
    forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (z t - zl) <= e) /\
  (forall k, 0 < k -> (forall r t, 0 <= r <= t -> Rabs (norm dotw (B (v t)) - norm dotw (B (v r))) <= k * (t - r)) ->
    forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm dotw (B (v t)) <= e).
Proof.
  intros Di Hb H Br CJ HJ.
  apply (brakes_synchronise state_ip state_inner flow (impulse (fun t => Bt (F t))) (fun t => (q t, v t)) beta
    (fun t => norm dotw (B (v t)))); auto.
  - intros (p, w). pose proof (Di w). unfold state_ip, flow; simpl. rewrite (m_inverse S), (ip_opp _ (dot_inner S)),
      (ip_plus _ (dot_inner S)). pose proof (ip_sym _ (k_form S) w p) as Q. cbv beta in Q. rewrite Q. lra.
  - destruct H as [L Co Ra]. constructor; auto. intros t Ht e He. destruct (Ra t Ht e He) as (d & Hd & Q). exists d;
    split; auto.
    intros h Hh. eapply Rle_trans; [|apply (Q h Hh)]. apply (norm_by _ state_inner); [apply norm_pos|]. intros w.
    eapply Rle_trans; [|apply (cauchy _ state_inner)]. apply Req_le.
    rewrite !(ip_minus _ state_inner). unfold impulse. ring.
  - intros t Ht. apply norm_pos.
  - intros t Ht e He. destruct (Br t Ht e He) as (d & Hd & Q). exists d; split; auto. intros h Hh. rewrite
    friction_work.
    apply Q; auto.
Qed.
End Systems.
