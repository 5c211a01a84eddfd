(** M q'' + C q' + K q + B^T f = u with the friction f in d psi (B q'), as an instance of `Inclusion`: bodies in any
  number
    of directions, chains, a surface; the dampers C may be any monotone ones. M^-1 is written as an operator of its own.
      *)
From InertialPair Require Import Dini Pair Forced MonotoneInclusion.

Section Systems.
Context {V W : ModuleSpace R_AbsRing}.
Variables (dot : V -> V -> R) (dotw : W -> W -> R) (M Mi C K : V -> V) (B : V -> W) (Bt : W -> V).

(** the matrices of a system: K and M symmetric, 0 <= K, 0 <= M = Mi^-1, Bt the transpose of B *)
Record mechanical : Prop := {
  k_form : inner (fun v w => dot (K v) w);
  m_form : inner (fun v w => dot (M v) w);
  dot_inner : inner dot;
  dotw_inner : inner dotw;
  m_inverse : forall f w, dot (M (Mi f)) w = dot f w;
  b_transposed : forall f v, dot (Bt f) v = dotw f (B v) }.
Hypothesis S : mechanical.
(** dampers that part two states at most at the rate c: a friction that falls with the speed is one, too *)
Definition dampers c := forall v w, - (c * dot (M (minus v w)) (minus v w)) <= dot (minus (C v) (C w)) (minus v w).

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
  destruct S as [Ks Ms _ _ _ _]. unfold state_ip. constructor.
  - intros y z. rewrite (ip_sym _ Ks), (ip_sym _ Ms). auto.
  - intros (q, v) (p, w) (o, u). pose proof (ip_plus _ Ks q p o) as Q. pose proof (ip_plus _ Ms v w u) as Q'. cbv beta
    in Q, Q'.
    change (dot (K (plus q p)) o + dot (M (plus v w)) u = dot (K q) o + dot (M v) u + (dot (K p) o + dot (M w) u)). lra.
  - intros c (q, v) (p, w). pose proof (ip_scal _ Ks c q p) as Q. pose proof (ip_scal _ Ms c v w) as Q'. cbv beta in Q,
    Q'. change (dot (K (scal c q)) p + dot (M (scal c v)) w = c * (dot (K q) p + dot (M v) w)). lra.
  - intros y. pose proof (ip_pos _ Ks (fst y)). pose proof (ip_pos _ Ms (snd y)). lra.
Qed.

(** the power of an impulse of friction is the one that it has at the contact *)
Lemma friction_work F t u (z : V * V) : state_ip (minus (impulse (fun t => Bt (F t)) u) (impulse (fun t => Bt (F t)) t))
  z = dotw (minus (F u) (F t)) (B (snd z)).
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

(** springs are neutral *)
Lemma flow_rate c : 0 <= c -> dampers c ->
  forall y z, state_ip (minus (flow y) (flow z)) (minus y z) <= c * state_ip (minus y z) (minus y z).
Proof.
  intros Hc Da (q, v) (p, w). pose proof (Da v w) as T. pose proof (ip_pos _ (k_form S) (minus q p)) as Kp.
  cbv beta in Kp. assert (Kc : 0 <= c * dot (K (minus q p)) (minus q p)) by positive. rewrite (ip_minus _ state_inner).
  unfold state_ip, flow; simpl. rewrite !(m_inverse S), !(ip_opp _ (dot_inner S)), !(ip_plus _ (dot_inner S)).
  rewrite (ip_minus _ (dot_inner S)) in T. set (dv := minus v w) in *. set (dq := minus q p).
  assert (Q : dot (K v) dq - dot (K w) dq = dot (K q) dv - dot (K p) dv).
  { pose proof (ip_minus _ (k_form S) v w dq) as Q1. pose proof (ip_minus _ (k_form S) q p dv) as Q2. cbv beta in Q1,
    Q2. fold dv in Q1. fold dq in Q2. rewrite <- Q1, <- Q2. apply (ip_sym _ (k_form S)). }
  change (plus q (opp p)) with dq. change (plus v (opp w)) with dv. fold dq in Kc. lra.
Qed.
Lemma flow_monotone : dampers 0 -> monotone state_ip flow.
Proof. intros Da y z. pose proof (flow_rate 0 (Rle_refl 0) Da y z) as Q. rewrite Rmult_0_l in Q. exact Q. Qed.

(** so it is an inclusion in the space of states, with phi (q, q') = psi (B q') *)
Theorem inclusion_motion psi U F q v : inclusion psi U F q v ->
  motion state_ip flow (fun y => psi (B (snd y))) (impulse U) (impulse (fun t => Bt (F t))) (fun t => (q t, v t)).
Proof.
  intros (H & L). split; [exact H|]. intros t Ht z e He. apply (soon (L t Ht (B (snd z)) e He)). intros h _.
  rewrite friction_work. change (snd (minus z (q t, v t))) with (minus (snd z) (v t)). rewrite b_minus. auto.
Qed.

(** [system-defects] Two motions of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$ and $C$ monotone,
    under two forces separate by at most the integral of the norm of $M^{-1}(u-\tilde u)$. *)
Theorem system_defects psi U F q v U' F' q' v' d J r t : dampers 0 -> inclusion psi U F q v -> inclusion psi U' F' q' v'
  ->
  (forall u, 0 <= u -> vderiv state_ip (fun r => minus (impulse U r) (impulse U' r)) u (d u)) -> cont J ->
  (forall u, 0 <= u -> rderiv J u (norm state_ip (d u))) -> 0 <= r <= t ->
  norm state_ip (minus (q t, v t) (q' t, v' t)) <= norm state_ip (minus (q r, v r) (q' r, v' r)) + (J t - J r).
Proof.
  intros Da H H' Hd CJ HJ Hr. exact (defects_add state_ip state_inner flow _ _ _ _ _ _ _ (flow_monotone Da)
    (inclusion_motion _ _ _ _ _ H) (inclusion_motion _ _ _ _ _ H') d J r t Hd CJ HJ Hr).
Qed.

(** [system-contraction] The flow of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$, $C$ monotone and
    friction bounded, is non-expansive in the energy norm. *)
Theorem system_contracts psi U F q v F' q' v' r t : dampers 0 -> inclusion psi U F q v -> inclusion psi U F' q' v' -> 0
  <= r <= t ->
  norm state_ip (minus (q t, v t) (q' t, v' t)) <= norm state_ip (minus (q r, v r) (q' r, v' r)).
Proof.
  intros Da H H' Hr. exact (contracts state_ip state_inner flow _ _ _ _ _ _ r t (flow_monotone Da)
    (inclusion_motion _ _ _ _ _ H) (inclusion_motion _ _ _ _ _ H') Hr).
Qed.

(** [system-parts] Where the dampers supply a power of at most $c|v|^2$, as friction that falls with speed does, two
    motions separate at most like $e^{ct}$. *)
Theorem system_parts c psi U F q v F' q' v' t : 0 <= c -> dampers c -> inclusion psi U F q v -> inclusion psi U F' q' v'
  ->
  0 <= t -> norm state_ip (minus (q t, v t) (q' t, v' t)) <= exp (c * t) * norm state_ip (minus (q 0, v 0) (q' 0, v'
    0)).
Proof.
  intros Hc Da H H' Ht. exact (parts_at_most state_ip state_inner c flow _ _ _ _ _ _ t Hc (flow_rate c Hc Da)
    (inclusion_motion _ _ _ _ _ H) (inclusion_motion _ _ _ _ _ H') Ht).
Qed.

(** [system-synchronises] Without a force, $M,K\geqslant 0$ and dissipative dampers, any bounded friction with a power
    of at least $\beta|Bq'|$: $\int|Bq'|\leqslant E(0)/\beta$, the displacement converges, and $Bq'\to 0$ where
    $|Bq'|$ is Lipschitz. *)
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
  - intros (p, w). pose proof (Di w). unfold state_ip, flow; simpl.
    rewrite (m_inverse S), (ip_opp _ (dot_inner S)), (ip_plus _ (dot_inner S)).
    pose proof (ip_sym _ (k_form S) w p) as Q. lra.
  - destruct H as [L Co Ra]. constructor; auto. intros t Ht e He. apply (soon (Ra t Ht e He)). intros h _.
    apply Rle_trans, (norm_le _ state_inner). intros w. rewrite !(ip_minus _ state_inner). unfold impulse.
    ring.
  - intros t Ht. apply norm_pos.
  - intros t Ht e He. apply (soon (Br t Ht e He)). intros h _. rewrite friction_work. auto.
Qed.
End Systems.

(** *** The pair is the instance with one direction *)
Section OnePair.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
(** states (x, v1, v2) *)
Definition pair_ip (y z : R * R * R) := a2 * (fst (fst y) * fst (fst z)) + m1 * (snd (fst y) * snd (fst z)) + m2 * (snd
  y * snd z).
Definition pair_flow (y : R * R * R) := (snd (fst y), - (a2 * fst (fst y) + a1 * snd (fst y)) / m1, 0).
Definition pair_friction (y : R * R * R) := b * Rabs (snd (fst y) - snd y).

Lemma pair_inner : inner pair_ip.
Proof.
  unfold pair_ip. constructor.
  - intros. ring.
  - intros. unfold plus; simpl. unfold plus; simpl. ring.
  - intros c y z. change (a2 * (c * fst (fst y) * fst (fst z)) + m1 * (c * snd (fst y) * snd (fst z)) + m2 * (c * snd y
    * snd z) = c * (a2 * (fst (fst y) * fst (fst z)) + m1 * (snd (fst y) * snd (fst z)) + m2 * (snd y * snd z))). ring.
  - intros y. nra.
Qed.
Let Y := prod_ModuleSpace R_AbsRing (prod_ModuleSpace R_AbsRing R_ModuleSpace R_ModuleSpace) R_ModuleSpace.
Lemma pair_minus f g k f' g' k' : @minus Y (f, g, k) (f', g', k') = (f - f', g - g', k - k').
Proof. reflexivity. Qed.
Lemma pair_plus f g k f' g' k' : @plus Y (f, g, k) (f', g', k') = (f + f', g + g', k + k').
Proof. reflexivity. Qed.
Lemma pair_scal c f g k : @scal R_AbsRing Y c (f, g, k) = (c * f, c * g, c * k).
Proof. reflexivity. Qed.
(** small components, small norm *)
Let C := a2 + m1 + m2 + 1.
Lemma pair_norm f g k : norm pair_ip (f, g, k) <= C * (Rabs f + Rabs g + Rabs k).
Proof.
  set (e := Rabs f + Rabs g + Rabs k). pose proof (Rabs_pos f). pose proof (Rabs_pos g). pose proof (Rabs_pos k).
  assert (Sq : forall u, Rabs u <= e -> u * u <= e * e) by (intros u Hu; apply Rabs_inv in Hu; nra).
  pose proof (Sq f ltac:(unfold e; lra)). pose proof (Sq g ltac:(unfold e; lra)).
  pose proof (Sq k ltac:(unfold e; lra)). assert (0 <= e) by (unfold e; lra).
  rewrite <- (sqrt_pow2 (C * e)) by (unfold C; positive). apply sqrt_le_1_alt. unfold pair_ip; simpl.
  apply Rle_trans with ((a2 + m1 + m2) * (e * e)); [nra|]. replace (C * e * (C * e * 1)) with (C * C * (e * e)) by ring.
  unfold C. apply Rmult_le_compat_r; nra.
Qed.

(** [pair-inclusion] The pair under a force is the case with one direction. *)
Theorem pair_is_an_inclusion U x v1 v2 s : forced m1 m2 a1 a2 b U x v1 v2 s ->
  motion pair_ip pair_flow pair_friction (fun t => (0, U t / m1, 0)) (fun t => (0, b / m1 * s t, - (b / m2 * s t)))
    (fun t => (x t, v1 t, v2 t)).
Proof.
  intros H. assert (B1 : 0 < b / m1) by positive. assert (B2 : 0 < b / m2) by positive. split; [constructor|].
  - exists (C * (b / m1 + b / m2)). intros r t Hr. pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H r t Hr) as L.
    rewrite pair_minus. eapply Rle_trans; [apply pair_norm|]. rewrite Rmult_assoc.
    apply Rmult_le_compat_l; [unfold C; lra|]. rewrite Rminus_diag_eq, Rabs_R0 by auto.
    replace (- (b / m2 * s t) - - (b / m2 * s r)) with (- (b / m2 * (s t - s r)))
      by ring. rewrite <- Rmult_minus_distr_l, Rabs_Ropp, !Rabs_mult, !(Rabs_pos_eq (b / _)) by lra. nra.
  - intros t Ht e He. set (g := fun u => C * (Rabs (x u - x t) + Rabs (v1 u - v1 t) + Rabs (v2 u - v2 t))).
    assert (Cg : cont g) by (unfold g; continuous). destruct (Cg t Ht e He) as (d & Hd & K).
    exists d; split; auto. intros u Hu Hd'. specialize (K u Hu Hd'). apply Rabs_def2 in K. rewrite pair_minus.
    eapply Rle_lt_trans; [apply pair_norm|]. fold (g u).
    replace (g t) with 0 in K by (unfold g; rewrite !Rminus_diag_eq, Rabs_R0 by auto; ring). lra.
  - intros t Ht. apply vlittle_norm.
    eapply little_le; [|exact (little_scal C _ (little_plus _ _ (little_abs _ (f_x _ _ _ _ _ _ _ _ _ _ H t Ht))
      (little_abs _ (little_scal (/ m1) _ (f_v1 _ _ _ _ _ _ _ _ _ _ H t Ht)))))]. intros h Hh.
    rewrite Rabs_pos_eq by apply norm_pos. eapply Rle_trans; [|apply Rle_abs]. unfold pair_flow; simpl fst; simpl snd.
    rewrite !pair_plus, !pair_minus, pair_scal, pair_minus. eapply Rle_trans; [apply pair_norm|]. apply Req_le. f_equal.
    pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H t (t + h) Ht ltac:(lra)) as W.
    match goal with |- _ + Rabs ?c = _ => replace c with 0 by lra end. rewrite Rabs_R0, Rplus_0_r.
    f_equal; f_equal; field; lra.
  - intros t Ht z e He. pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H) as L.
    apply (soon (opposes_power s _ t (q_slip m1 m2 a1 a2 b _ _ _ _ _ _ H t Ht) (e / b) ltac:(positive))).
    intros h Hh K. apply Rabs_inv in K. specialize (L t (t + h) ltac:(lra)). apply Rabs_inv in L.
    destruct z as ((z1, z2), z3). rewrite !pair_minus. unfold pair_ip, pair_friction; simpl.
    set (ds := s (t + h) - s t) in *. match goal with |- ?a <= _ => replace a with
      (b * (ds * (z2 - z3)) - b * (ds * (v1 t - v2 t))) by (unfold ds; field; lra) end.
    assert (Q : ds * (z2 - z3) <= h * Rabs (z2 - z3)).
    { pose proof (Rle_abs (ds * (z2 - z3))) as Q. rewrite Rabs_mult in Q. assert (Rabs ds <= h) by (apply Rabs_le; lra).
      pose proof (Rabs_pos (z2 - z3)). nra. }
    apply Rmult_le_compat_l with (r := b) in Q; [|lra]. assert (K' : b * (- (e / b * h)) <= b * (ds * (v1 t - v2 t) -
      Rabs (v1 t - v2 t) * h)) by scale. replace (b * (- (e / b * h))) with (- (e * h)) in K' by (field; lra). lra.
Qed.
End OnePair.
