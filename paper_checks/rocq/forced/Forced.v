(** The pair under a force on body 1: solutions, contraction, uniqueness, energy, what body 2 can follow, least time.
    The force enters through its impulse U (U' = u from the right): any continuous U is allowed, so jumps of u are. *)
From InertialPair Require Export Rates.

Lemma rderiv_unique f t l k : rderiv f t l -> rderiv f t k -> l = k.
Proof.
  intros F G. apply Rminus_diag_uniq. destruct (Req_dec (l - k) 0) as [|N]; auto. apply Rabs_pos_lt in N.
  destruct (little_minus _ _ G F (Rabs (l - k) / 2)) as (d & Hd & Q); [lra|]. specialize (Q (d / 2) ltac:(lra)).
  replace (f (t + d / 2) - f t - k * (d / 2) - (f (t + d / 2) - f t - l * (d / 2))) with ((l - k) * (d / 2)) in Q by
    ring. rewrite Rabs_mult, (Rabs_pos_eq (d / 2)) in Q by lra. nra.
Qed.

(** if D' <= j sqrt (2 D), then sqrt (2 D) grows at most by the integral J of j *)
Lemma root_grows D j J r t : cont D -> (forall u, 0 <= D u) -> cont J -> 0 <= r <= t ->
  (forall u, r <= u < t -> 0 <= j u /\ rderiv J u (j u) /\ dini_le D u (j u * sqrt (2 * D u))) ->
  sqrt (2 * D t) <= sqrt (2 * D r) + (J t - J r).
Proof.
  intros CD PD CJ Hr HJ. assert (Up : forall u, r <= u <= t -> J r <= J u).
  { intros u Hu. apply Ropp_le_cancel, (rderiv_mono (fun u => - J u) r u (fun u => - j u)); [continuous|lra|].
    intros q Hq. destruct (HJ q ltac:(lra)) as (Pj & Ju & _). split; [rates|lra]. }
  cut (sqrt (2 * D t) - J t <= sqrt (2 * D r) - J r); [lra|]. apply le_epsilon. intros e He.
  apply (barrier_until (fun u => sqrt (2 * D u) - J u) _ r t); [|auto|lra|].
  - apply cont_minus; auto. apply (cont_comp sqrt); [|continuous]. intros u _. apply continuity_pt_sqrt.
    specialize (PD u). lra.
  - intros u Hu Above. destruct (HJ u Hu) as (_ & Ju & HD). specialize (Up u ltac:(lra)).
    pose proof (sqrt_pos (2 * D r)).
    eapply dini_eq; [|exact (dini_plus _ _ _ _ _ (sqrt_dini (fun u => 2 * D u) u _
      ltac:(intros q; specialize (PD q); lra)
      ltac:(cbv beta; lra) (dini_scal 2 D u _ ltac:(lra) HD)) (rderiv_opp _ _ _ Ju))]. cbv beta. field. lra.
Qed.

(** sizes by squares *)
Lemma root_bound m z q : 0 < m -> m * z ^ 2 <= q -> Rabs z <= sqrt (q / m).
Proof.
  intros Hm Q. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. undivide m. lra.
Qed.

(** *** what a force can do: the root of twice the energy bounds the velocity of body 1, and grows at most by what the force
    pushes *)
Section Pushed.
Context (m1 m2 a2 : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2).
Lemma energy_above x v1 v2 : sqrt m1 * Rabs v1 <= sqrt (2 * energy m1 m2 a2 x v1 v2).
Proof.
  rewrite <- (sqrt_Rsqr_abs v1), <- sqrt_mult_alt by lra. apply sqrt_le_1_alt. unfold energy, Rsqr. nra.
Qed.
(** and what an energy bounds *)
Lemma energy_parts x v1 v2 E : energy m1 m2 a2 x v1 v2 <= E -> a2 * x ^ 2 <= 2 * E /\ m1 * v1 ^ 2 <= 2 * E /\
  m2 * v2 ^ 2 <= 2 * E.
Proof.
  unfold energy. intros Q. assert (0 <= a2 * x ^ 2) by positive. assert (0 <= m1 * v1 ^ 2) by positive.
  assert (0 <= m2 * v2 ^ 2) by positive. lra.
Qed.
Lemma energy_within x v1 v2 E : energy m1 m2 a2 x v1 v2 <= E ->
  Rabs x <= sqrt (2 * E / a2) /\ Rabs v1 <= sqrt (2 * E / m1) /\ Rabs v2 <= sqrt (2 * E / m2).
Proof. intros Q. apply energy_parts in Q. repeat split; apply root_bound; tauto. Qed.
(** where it is small, all is *)
Lemma energy_close e : 0 < e -> exists E, 0 < E /\ forall x v1 v2, energy m1 m2 a2 x v1 v2 <= E ->
  Rabs x <= e /\ Rabs v1 <= e /\ Rabs v2 <= e.
Proof.
  intros He. set (mu := Rmin a2 (Rmin m1 m2)). assert (0 < mu) by positive. least mu.
  exists (mu * e ^ 2 / 2). split; [positive|]. intros x v1 v2 Q. apply energy_within in Q.
  assert (S : forall m, mu <= m -> sqrt (2 * (mu * e ^ 2 / 2) / m) <= e).
  { intros m Hm. rewrite <- (sqrt_pow2 e) at 2 by lra. apply sqrt_le_1_alt. undivide m. nra. }
  pose proof (S a2 ltac:(lra)). pose proof (S m1 ltac:(lra)). pose proof (S m2 ltac:(lra)). lra.
Qed.
Lemma pushed_apart x v1 v2 du J r t : let D t := energy m1 m2 a2 (x t) (v1 t) (v2 t) in cont D -> cont J -> 0 <= r <= t ->
  (forall u, r <= u < t -> rderiv J u (Rabs (du u)) /\ dini_le D u (du u * v1 u)) ->
  sqrt (2 * D t) <= sqrt (2 * D r) + (J t - J r) / sqrt m1.
Proof.
  intros D CD CJ Hr HU. pose proof (sqrt_lt_R0 _ Hm1) as Sm.
  replace ((J t - J r) / sqrt m1) with (/ sqrt m1 * J t - / sqrt m1 * J r) by (field; lra).
  apply (root_grows D (fun u => / sqrt m1 * Rabs (du u)) (fun u => / sqrt m1 * J u)); auto using cont_scal.
  - intros u. apply (energy_pos m1 m2 a2 Hm1 Hm2 Ha2).
  - intros u Hu. destruct (HU u Hu) as (DJ & DD). split; [positive|split; [apply rderiv_scal; auto|]].
    eapply dini_weaken; [|exact DD]. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult.
    replace (Rabs (du u) * _) with (/ sqrt m1 * Rabs (du u) * (sqrt m1 * Rabs (v1 u))) by (field; lra).
    apply Rmult_le_compat_l; [positive|apply energy_above].
Qed.
End Pushed.

Section Forced.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let energy := energy m1 m2 a2.

(** as [solution], with the impulse U of the force taken from the momentum of body 1 *)
Record forced (U x v1 v2 s : R -> R) : Prop := {
  f_lip : forall r t, 0 <= r <= t -> Rabs (s t - s r) <= t - r;
  f_pos : forall t, 0 <= t -> v2 t < v1 t -> rderiv s t 1;
  f_neg : forall t, 0 <= t -> v1 t < v2 t -> rderiv s t (-1);
  f_cU : cont U;
  f_cx : cont x;
  f_cv : cont v1;
  f_x : forall t, 0 <= t -> rderiv x t (v1 t);
  f_v1 : forall t, 0 <= t -> rderiv (fun r => m1 * v1 r + b * s r - U r) t (- (a2 * x t + a1 * v1 t));
  f_v2 : forall t, 0 <= t -> m2 * v2 t - b * s t = m2 * v2 0 - b * s 0 }.

Lemma forced_moves U x v1 v2 s : forced U x v1 v2 s <-> cont U /\ moves m1 m2 a1 a2 b 1 U x v1 v2 s.
Proof.
  split.
  - intros []. split; auto. constructor; auto using opposes_both. intros. rewrite Rmult_1_l. auto.
  - intros (CU & [L P CX CV X V W]). constructor; auto.
    + intros r t Hr. rewrite <- (Rmult_1_l (t - r)). auto.
    + intros t Ht Sl. apply P; auto; lra.
    + intros t Ht Sl. apply P; auto; lra.
Qed.

Lemma forced_moving U x v1 v2 s : forced U x v1 v2 s -> moves m1 m2 a1 a2 b 1 U x v1 v2 s.
Proof. apply forced_moves. Qed.
Coercion forced_moving : forced >-> moves.

(** [free-case] Without a force the forced system is the free system. *)
Theorem free_case x v1 v2 s : forced (fun _ => 0) x v1 v2 s <-> solution m1 m2 a1 a2 b x v1 v2 s.
Proof. rewrite forced_moves, solution_moves. split; [tauto|auto using cont_const]. Qed.

(** only the increments of the impulse matter: a constant force impulse is no force *)
Lemma forced_ext U U' x v1 v2 s : (forall t, 0 <= t -> U' t - U' 0 = U t - U 0) -> forced U x v1 v2 s ->
  forced U' x v1 v2 s.
Proof.
  intros E []. constructor; auto.
  - apply cont_ext with (fun t => U t + (U' 0 - U 0)). { intros t Ht. specialize (E t Ht). lra. }
    apply cont_plus; [auto|apply cont_const].
  - intros t Ht. apply rderiv_ext with (fun r => m1 * v1 r + b * s r - U r + (U 0 - U' 0)).
    { intros r Hr. specialize (E r ltac:(lra)). lra. }
    rate; ring.
Qed.

(** *** Energy: E' = u v1 - a1 v1^2 - b |v1 - v2| wherever the impulse has the right derivative u *)

(** [forced-energy-rate] $\dot E=u\,v_1-a_1v_1^2-b|v_1-v_2|$, where the impulse has the rate $u$ from the right. *)
Theorem forced_energy_rate U x v1 v2 s t u : forced U x v1 v2 s -> 0 <= t -> rderiv U t u ->
  rderiv (fun t => energy (x t) (v1 t) (v2 t)) t (u * v1 t - a1 * v1 t ^ 2 - b * Rabs (v1 t - v2 t)).
Proof. intros H. exact (moves_energy_rate _ _ _ _ _ Hm1 Hm2 _ _ _ _ _ _ H t u). Qed.

(** *** Contraction, uniqueness: two solutions under the same force (any continuous impulse) *)

(** [forced-contraction] Under any force the flow is non-expansive in the energy norm. *)
Theorem forced_contraction U x v1 v2 s x' v1' v2' s' r t : forced U x v1 v2 s -> forced U x' v1' v2' s' ->
  0 <= r <= t ->
  energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r).
Proof.
  intros H H'. apply forced_moves in H, H'.
  exact (moves_contraction m1 m2 a1 a2 b Hm1 Hm2 Ha1 Hb _ _ _ _ _ _ _ _ _ _ (proj2 H) (proj2 H') r t (fun _ =>
    eq_refl)).
Qed.

(** equal states stay equal *)
Theorem forced_unique U x v1 v2 s x' v1' v2' s' t0 : forced U x v1 v2 s -> forced U x' v1' v2' s' -> 0 <= t0 ->
  x t0 = x' t0 -> v1 t0 = v1' t0 -> v2 t0 = v2' t0 -> forall t, t0 <= t -> x t = x' t /\ v1 t = v1' t /\ v2 t = v2' t.
Proof.
  intros H H' Ht X V W t Hu. pose proof (forced_contraction _ _ _ _ _ _ _ _ _ t0 t H H' ltac:(lra)) as C.
  rewrite X, V, W in C. exact (energy_apart m1 m2 a2 Hm1 Hm2 Ha2 _ _ _ _ _ _ _ _ _ C).
Qed.

(** *** What body 2 can follow *)

(** [driven-acceleration] Body 2 changes its velocity by at most $b/m_2$ times the time, whatever the force. *)
Theorem only_gentle U x v1 v2 s r t : forced U x v1 v2 s -> 0 <= r <= t -> Rabs (v2 t - v2 r) <= b / m2 * (t - r).
Proof.
  intros H Hr. rewrite (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H r t) by lra. apply abs_scal; [|apply (f_lip _ _ _ _ _ H); auto].
  apply Rlt_le, Rdiv_lt_0_compat; auto.
Qed.

(** the acceleration of body 2 by the rate of the impulse of friction *)
Lemma forced_v2_rate U x v1 v2 s t k : forced U x v1 v2 s -> 0 <= t -> rderiv s t k -> rderiv v2 t (b / m2 * k).
Proof.
  intros H Ht S. apply rderiv_ext with (fun u => (v2 t - b / m2 * s t) + b / m2 * s u).
  { intros u Hu. pose proof (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H t u Ht ltac:(lra)). lra. }
  rate; ring.
Qed.

(** [must-stick] At a time at which body 2 accelerates by less than $b/m_2$, $v_1=v_2$. *)
Theorem must_stick U x v1 v2 s t l : forced U x v1 v2 s -> 0 <= t -> rderiv v2 t l -> Rabs l < b / m2 -> v1 t = v2 t.
Proof.
  intros H Ht F B. assert (Hk : 0 < b / m2) by positive. assert (V : forall k, rderiv s t k -> l = b / m2 * k)
    by (intros k S; exact (rderiv_unique v2 t _ _ F (forced_v2_rate _ _ _ _ _ t k H Ht S))).
  destruct (Rtotal_order (v1 t) (v2 t)) as [Lt|[Eq|Gt]]; auto; exfalso.
  - rewrite (V _ (f_neg _ _ _ _ _ H t Ht Lt)) in B. rewrite Rabs_left in B; lra.
  - rewrite (V _ (f_pos _ _ _ _ _ H t Ht ltac:(lra))) in B. rewrite Rabs_pos_eq in B; lra.
Qed.

(** a stick that asks for no more than b: M v' = u - a2 x - a1 v, and v is b/m2-Lipschitz *)
Lemma stuck_forced U x v : cont U -> cont x -> (forall t, 0 <= t -> rderiv x t (v t)) ->
  (forall t, 0 <= t -> rderiv (fun r => M * v r - U r) t (- (a2 * x t + a1 * v t))) ->
  (forall p q, 0 <= p <= q -> Rabs (v q - v p) <= b / m2 * (q - p)) -> forced U x v v (fun t => m2 / b * v t).
Proof.
  intros CU Cx Dx Dv L. constructor; auto; try (intros; lra).
  - intros p q Hp. replace (m2 / b * v q - m2 / b * v p) with (m2 / b * (v q - v p)) by ring.
    replace (q - p) with (m2 / b * (b / m2 * (q - p))) by (field; lra). apply abs_scal; [positive|]; auto.
  - apply (lip_cont v (b / m2)); [positive|]; auto.
  - intros t Ht. apply rderiv_ext with (2 := Dv t Ht). intros; unfold M; field; lra.
  - intros t Ht. field; lra.
Qed.

(** every r with |r''| <= b/m2 (r' Lipschitz) is followed, stuck, under the impulse of M r'' + a1 r' + a2 (x0 + r -
    r(0)) *)
Theorem trackable x0 r r' : cont r -> (forall t, 0 <= t -> rderiv r t (r' t)) ->
  (forall p q, 0 <= p <= q -> Rabs (r' q - r' p) <= b / m2 * (q - p)) ->
  forced (fun t => M * r' t + a1 * r t + a2 * integral (fun u => x0 + r u - r 0) t)
    (fun t => x0 + r t - r 0) r' r' (fun t => m2 / b * r' t).
Proof.
  intros C R L. assert (Cr' : cont r') by (apply (lip_cont r' (b / m2)); [positive|]; auto).
  assert (Cx : cont (fun t => x0 + r t - r 0)) by continuous. apply stuck_forced; auto; [continuous| |].
  - intros t Ht. rate; ring.
  - intros t Ht. apply rderiv_ext with (fun u => - a1 * r u + - a2 * integral (fun u => x0 + r u - r 0) u).
    { intros u Hu. ring. }
    rate; ring.
Qed.

(** [trackable] From some initial state of body 1 some force makes body 2 follow a velocity exactly if that is
    $b/m_2$-Lipschitz. *)
Corollary trackable_iff v : (exists U x v1 s, forced U x v1 v s) <->
  forall p q, 0 <= p <= q -> Rabs (v q - v p) <= b / m2 * (q - p).
Proof.
  split.
  - intros (U & x & v1 & s & H) p q Hp. exact (only_gentle _ _ _ _ _ p q H Hp).
  - intros L. assert (Cv : cont v) by (apply (lip_cont v (b / m2)); [positive|]; auto).
    eexists _, _, v, _. apply (trackable 0 (integral v) v); auto using integral_cont, integral_rderiv.
Qed.

(** the force itself, where r' has a right derivative *)
Lemma tracking_force x0 r r' t l : cont r -> rderiv r t (r' t) -> rderiv r' t l -> 0 <= t ->
  rderiv (fun t => M * r' t + a1 * r t + a2 * integral (fun u => x0 + r u - r 0) t) t (M * l + a1 * r' t + a2 *
    (x0 + r t - r 0)).
Proof.
  intros. rate; ring.
Qed.

(** the rate of the momentum, but for the force *)
Lemma momentum U x v1 v2 s t : forced U x v1 v2 s -> 0 <= t ->
  rderiv (fun r => m1 * v1 r + m2 * v2 r - U r) t (- (a2 * x t + a1 * v1 t)).
Proof.
  intros H Ht. apply rderiv_ext with (fun r => m1 * v1 r + b * s r - U r + (m2 * v2 0 - b * s 0)).
  - intros r Hr. pose proof (f_v2 _ _ _ _ _ H r ltac:(lra)). lra.
  - destruct H. rate; ring.
Qed.
(** a stick leaves no choice: the force must be M v' + a1 v + a2 x *)
Theorem stuck_needs U x v1 v2 s t d : forced U x v1 v2 s -> 0 < d -> (forall r, t <= r < t + d -> v1 r = v2 r) ->
  0 <= t ->
  rderiv (fun r => M * v1 r - U r) t (- (a2 * x t + a1 * v1 t)).
Proof.
  intros H Hd St Ht. apply rderiv_near with (fun r => m1 * v1 r + m2 * v2 r - U r) d;
    [auto| |exact (momentum _ _ _ _ _ t H Ht)].
  intros r Hr. rewrite (St r) by lra. unfold M. ring.
Qed.

(** *** Where body 2 can be: the fastest ways to gain distance are full acceleration and then full braking *)
Lemma travel y w be T : 0 < be -> 0 <= T -> cont y -> (forall t, 0 <= t -> rderiv y t (w t)) ->
  (forall p q, 0 <= p <= q -> Rabs (w q - w p) <= be * (q - p)) ->
  y T - y 0 <= (w 0 + w T) * T / 2 + be / 4 * (T ^ 2 - ((w T - w 0) / be) ^ 2).
Proof.
  intros Hbe HT C R Lw. set (d := (w T - w 0) / be). assert (Ed : w T = w 0 + be * d) by (unfold d; field; lra).
  pose proof (Lw 0 T ltac:(lra)) as L0. apply Rabs_inv in L0. assert (Hd : - T <= d <= T) by (split; nra).
  set (p := (T + d) / 2). assert (Hp : 0 <= p <= T) by (unfold p; lra).
  pose proof (slower y w (fun u => w 0 * u + be * u ^ 2 / 2) (fun u => w 0 + be * u) 0 p C ltac:(lra)
    ltac:(intros; auto_derive; auto; field) ltac:(intros u Hu; pose proof (Lw 0 u ltac:(lra)) as Q; apply Rabs_inv in Q;
      split; [apply R|]; lra)) as A.
  pose proof (slower y w (fun u => - (w T * (T - u) + be * (T - u) ^ 2 / 2)) (fun u => w T + be * (T - u)) p T C
    ltac:(lra)
    ltac:(intros; auto_derive; auto; field) ltac:(intros u Hu; pose proof (Lw u T ltac:(lra)) as Q; apply Rabs_inv in Q;
      split; [apply R|]; lra)) as B. cbv beta in A, B.
  apply Rle_trans with (w 0 * p + be * p ^ 2 / 2 + (w T * (T - p) + be * (T - p) ^ 2 / 2)); [lra|].
  rewrite Ed. apply Req_le. unfold p. field.
Qed.

(** [reach] A bound on the position of body 2 at a time, whatever the force. *)
Theorem reach U x v1 v2 s x2 T : forced U x v1 v2 s -> cont x2 -> (forall t, 0 <= t -> rderiv x2 t (v2 t)) -> 0 <= T ->
  Rabs (x2 T - x2 0 - (v2 0 + v2 T) * T / 2) <= b / m2 / 4 * (T ^ 2 - ((v2 T - v2 0) * m2 / b) ^ 2).
Proof.
  intros H C R HT. apply abs_by. intros k Hk.
  pose proof (travel (fun u => k * x2 u) (fun u => k * v2 u) (b / m2) T ltac:(positive) HT ltac:(continuous)
    ltac:(intros; rates)
    ltac:(intros p q Hp; cbv beta; rewrite <- Rmult_minus_distr_l, Rabs_sign by auto;
      exact (only_gentle _ _ _ _ _ p q H Hp))) as A.
  cbv beta in A. replace (((k * v2 T - k * v2 0) / (b / m2)) ^ 2) with (((v2 T - v2 0) * m2 / b) ^ 2) in A
    by (destruct Hk; subst k; field; lra). lra.
Qed.

(** [least-time] From rest to rest over $D$ takes at least $2\sqrt{m_2D/b}$, whatever the force. *)
Theorem least_time U x v1 v2 s x2 T : forced U x v1 v2 s -> cont x2 -> (forall t, 0 <= t -> rderiv x2 t (v2 t)) ->
  0 <= T ->
  v2 0 = 0 -> v2 T = 0 -> 2 * sqrt (m2 * Rabs (x2 T - x2 0) / b) <= T.
Proof.
  intros H C R HT Z0 ZT. pose proof (reach _ _ _ _ _ _ _ H C R HT) as Q. rewrite Z0, ZT in Q.
  replace (x2 T - x2 0 - (0 + 0) * T / 2) with (x2 T - x2 0) in Q by field.
  replace (b / m2 / 4 * (T ^ 2 - ((0 - 0) * m2 / b) ^ 2)) with (b / m2 * (T / 2) ^ 2) in Q by (field; lra).
  cut (sqrt (m2 * Rabs (x2 T - x2 0) / b) <= T / 2); [lra|].
  rewrite <- (sqrt_pow2 (T / 2)) by lra. apply sqrt_le_1_alt.
  replace ((T / 2) ^ 2) with (m2 / b * (b / m2 * (T / 2) ^ 2)) by (field; lra).
  replace (m2 * Rabs (x2 T - x2 0) / b) with (m2 / b * Rabs (x2 T - x2 0)) by (field; lra).
  apply Rmult_le_compat_l; [positive|]; auto.
Qed.

(** the bang-bang motion with its kinks at 0, tau, 2 tau: y |y| / 2 has the derivative |y|, and |y| the right
    derivative +-1 *)
Definition side y := if Rle_dec 0 y then 1 else -1.
Lemma rderiv_Rabs c t : rderiv (fun u => Rabs (u - c)) t (side (t - c)).
Proof.
  unfold side. destruct (Rle_dec 0 (t - c)).
  - apply rderiv_exact with 1; [lra|]. intros h Hh. rewrite !Rabs_pos_eq by lra. ring.
  - apply rderiv_exact with (c - t); [lra|]. intros h Hh. rewrite !Rabs_left by lra. ring.
Qed.
Lemma rderiv_half c t : rderiv (fun u => (u - c) * Rabs (u - c) / 2) t (Rabs (t - c)).
Proof.
  intros e He. exists e; split; auto. intros h Hh. replace (t + h - c) with (t - c + h) by ring. set (y := t - c).
  apply Rabs_le. unfold Rabs. destruct (Rcase_abs (y + h)), (Rcase_abs y); split; nra.
Qed.

(** the sizes that it is made of *)
Ltac motion ::= first [apply rderiv_half | apply rderiv_Rabs].

(** the velocity of the fastest transfer: up, then down *)
Definition bang tau t := b / m2 * ((Rabs (t - 2 * tau) + Rabs (t - 0) - 2 * Rabs (t - tau)) / 2).
(** its place *)
Definition run tau t := b / m2 * (((t - 2 * tau) * Rabs (t - 2 * tau) / 2 + (t - 0) * Rabs (t - 0) / 2
  - 2 * ((t - tau) * Rabs (t - tau) / 2)) / 2).
(** its acceleration *)
Definition push tau t := b / m2 * ((side (t - 2 * tau) + side (t - 0) - 2 * side (t - tau)) / 2).

(** the velocity has that acceleration *)
Lemma rderiv_bang tau t : rderiv (bang tau) t (push tau t).
Proof. unfold bang, push. generalize (b / m2). intros c. rate. field. Qed.
(** the place has that velocity *)
Lemma rderiv_run tau t : rderiv (run tau) t (bang tau t).
Proof. unfold run, bang. generalize (b / m2). intros c. rate. field. Qed.
(** the velocity changes as fast as friction allows and no faster *)
Lemma bang_lip tau p q : 0 <= tau -> 0 <= p <= q -> Rabs (bang tau q - bang tau p) <= b / m2 * (q - p).
Proof.
  intros Ht Hp. unfold bang. rewrite <- Rmult_minus_distr_l. apply abs_scal; [positive|].
  unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(** [least-time-attained] The least time $2\sqrt{m_2D/b}$ from rest to rest over $D$ is attained. *)
Theorem least_time_attained x0 D : 0 < D -> exists U x v1 v2 s x2, forced U x v1 v2 s /\
  cont x2 /\ (forall t, 0 <= t -> rderiv x2 t (v2 t)) /\ x 0 = x0 /\ v1 0 = 0 /\ v2 0 = 0 /\ x2 0 = 0 /\
  (forall t, 2 * sqrt (m2 * D / b) <= t -> v1 t = 0 /\ v2 t = 0 /\ x2 t = D) /\
  forall t, 0 <= t -> v1 t = v2 t /\
    rderiv U t (M * push (sqrt (m2 * D / b)) t + a1 * bang (sqrt (m2 * D / b)) t + a2 * (x0 + x2 t)).
Proof.
  intros HD. assert (Hq : 0 < m2 * D / b) by positive. set (tau := sqrt (m2 * D / b)).
  assert (Ht : 0 < tau) by positive. assert (Sq : tau * tau = m2 * D / b) by (apply sqrt_sqrt; lra).
  assert (cont (fun t => t)) by (apply (lip_cont _ 1); [lra|]; intros; rewrite Rabs_pos_eq; lra).
  assert (C : cont (run tau)) by (unfold run; continuous).
  assert (L : forall p q, 0 <= p <= q -> Rabs (bang tau q - bang tau p) <= b / m2 * (q - p)) by (intros;
    apply bang_lip; lra).
  assert (B0 : bang tau 0 = 0). { unfold bang. rewrite Rminus_0_r, Rabs_R0, !Rabs_left by lra. field; lra. }
  exists (fun t => M * bang tau t + a1 * run tau t + a2 * integral (fun u => x0 + run tau u - run tau 0) t),
    (fun t => x0 + run tau t - run tau 0), (bang tau), (bang tau), (fun t => m2 / b * bang tau t),
      (fun t => run tau t - run tau 0).
  split; [apply trackable; auto using rderiv_run|]. split; [continuous|]. split.
  { intros t _. pose proof (rderiv_run tau t). rate; ring. }
  repeat split; auto; try ring.
  1, 2: unfold bang; rewrite !Rabs_pos_eq by lra; field; lra.
  - unfold run. rewrite !(Rabs_pos_eq (t - _)) by lra. rewrite (Rminus_0_r 0), Rabs_R0, !Rabs_left by lra.
    replace D with (b / m2 * (m2 * D / b)) by (field; lra). rewrite <- Sq. field; lra.
  - apply rderiv_eq with (M * push tau t + a1 * bang tau t + a2 * (x0 + run tau t - run tau 0)); [ring|].
    apply (tracking_force x0 (run tau) (bang tau)); auto using rderiv_run, rderiv_bang.
Qed.
End Forced.

(** what is known of a motion *)
Ltac forced_fact := first [eapply f_cv; eassumption | eapply f_cx; eassumption | eapply f_cU; eassumption
  | eapply moves_cs, forced_moving; eassumption | eapply moves_cv2; [|eapply forced_moving; eassumption]; assumption
  | eapply f_x; [eassumption|lra] | eapply f_v1; [eassumption|lra]].
Ltac motion ::= forced_fact.
