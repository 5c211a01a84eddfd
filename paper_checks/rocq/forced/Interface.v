(** An interface of changing strength: friction of at most b(t) against the slip, where b may depend on the time, on the
    place of body 1, on the displacement and on the speed of the slip. What parts two motions is only that their
    strengths differ; there is one motion from every start; and what stays above some strength brings every slip to rest. *)
From InertialPair Require Import Dini PaidRates Pair Stick TurnedFrame Pursuit Forced.

Section Interface.
Context (m1 m2 a1 a2 : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2).
Let M := m1 + m2.
Let kap := M / (m1 * m2).
Let energy := energy m1 m2 a2.

(** F is the impulse of friction, b t its strength at the time t *)
Record rubs (b U x v1 v2 F : R -> R) : Prop := {
  r_cap : forall t, 0 <= t -> forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
    Rabs (F (t + h) - F t) <= (b t + e) * h;
  r_slip : forall t, 0 <= t -> forall k, k = 1 \/ k = -1 -> 0 < k * (v1 t - v2 t) -> rderiv F t (k * b t);
  r_cU : cont U;
  r_cx : cont x;
  r_cv : cont v1;
  r_cF : cont F;
  r_x : forall t, 0 <= t -> rderiv x t (v1 t);
  r_v1 : forall t, 0 <= t -> rderiv (fun r => m1 * v1 r + F r - U r) t (- (a2 * x t + a1 * v1 t));
  r_v2 : forall t, 0 <= t -> m2 * v2 t - F t = m2 * v2 0 - F 0 }.

(** what is known of such a motion *)
Ltac rubs_fact := first [eapply r_cx; eassumption | eapply r_cv; eassumption | eapply r_cU; eassumption
  | eapply r_cF; eassumption | eapply r_x; [eassumption|lra] | eapply r_v1; [eassumption|lra]].
Ltac motion ::= first [rubs_fact | forced_fact].

(** friction's impulse is as fast as its strength allows *)
Lemma cap_lip f c r t : cont f -> 0 <= r <= t -> (forall u, r <= u < t -> forall e, 0 < e -> exists d, 0 < d /\
  forall h, 0 < h < d -> Rabs (f (u + h) - f u) <= (c + e) * h) -> Rabs (f t - f r) <= c * (t - r).
Proof.
  intros C Hr Ca. apply abs_by. intros k Hk. rewrite Rmult_minus_distr_l.
  apply (dini_slope (fun t => k * f t)); [continuous|auto|]. intros u Hu e He.
  destruct (Ca u Hu e He) as (d & Hd & K). exists d; split; auto. intros h Hh. eapply Rle_trans; [|apply (K h Hh)].
  rewrite <- Rmult_minus_distr_l, <- (Rabs_sign k) by auto. apply Rle_abs.
Qed.

(** [interface-one-strength] A friction of one strength at all times: the motions under a force, and only they. *)
Theorem rubs_constant b U x v1 v2 F : 0 < b -> rubs (fun _ => b) U x v1 v2 F <-> forced m1 m2 a1 a2 b U x v1 v2 (fun t => F t / b).
Proof.
  intros Hb. set (s := fun t => F t / b). replace F with (fun t => b * s t).
  2: { apply FunctionalExtensionality.functional_extensionality. intros t. unfold s. field. lra. }
  clearbody s. split.
  - intros [Ca Sl CU Cx Cv CF X V W].
    assert (S : forall t k, rderiv (fun t => b * s t) t (k * b) -> rderiv s t k).
    { intros t k D. apply rderiv_ext with (fun t => / b * (b * s t)); [intros|rate]; field; lra. }
    constructor; auto.
    + intros r t Hr. apply Rmult_le_reg_l with b; auto. rewrite <- (Rabs_pos_eq b) at 1 by lra.
      rewrite <- Rabs_mult, Rmult_minus_distr_l. apply (cap_lip (fun t => b * s t)); auto.
      intros; apply Ca; lra.
    + intros. apply S, Sl; auto; lra.
    + intros. apply S, Sl; auto; lra.
  - intros H. pose proof (forced_moving _ _ _ _ _ _ _ _ _ _ H) as Mo. constructor; try apply H.
    + intros t Ht e He. exists 1. split; [lra|]. intros h Hh.
      pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H t (t + h) ltac:(lra)).
      rewrite <- Rmult_minus_distr_l, Rabs_mult, Rabs_pos_eq by lra. nra.
    + intros t Ht k Hk G. apply rderiv_eq with (b * k); [ring|].
      apply rderiv_scal, (q_slip _ _ _ _ _ _ _ _ _ _ _ Mo); auto.
    + continuous.
Qed.

Section One.
Context (b U x v1 v2 F : R -> R) (H : rubs b U x v1 v2 F).

Lemma rubs_big t : 0 <= t -> big (fun h => F (t + h) - F t).
Proof.
  intros Ht. destruct (r_cap _ _ _ _ _ _ H t Ht 1 Rlt_0_1) as (d & Hd & K). pose proof (Rabs_pos (b t)).
  exists (Rabs (b t) + 1), d. repeat split; try lra. intros h Hh. specialize (K h Hh). pose proof (Rle_abs (b t)). nra.
Qed.
Lemma rubs_v2 t h : 0 <= t -> 0 < h -> v2 (t + h) - v2 t = 1 / m2 * (F (t + h) - F t).
Proof.
  intros Ht Hh. pose proof (r_v2 _ _ _ _ _ _ H t Ht). pose proof (r_v2 _ _ _ _ _ _ H (t + h) ltac:(lra)).
  apply Rmult_eq_reg_l with m2; [|lra]. replace (m2 * (1 / m2 * (F (t + h) - F t))) with (F (t + h) - F t) by (field; lra). lra.
Qed.
Lemma rubs_cv2 : cont v2.
Proof.
  apply cont_ext with (fun u => (v2 0 - / m2 * F 0) + / m2 * F u).
  { intros u Hu. pose proof (r_v2 _ _ _ _ _ _ H u Hu) as Q. apply Rmult_eq_reg_l with m2; [|lra]. field_simplify; lra. }
  continuous.
Qed.
(** of either sign *)
Lemma rubs_cap c t : 0 <= t -> dini_le (fun u => c * F u) t (Rabs c * b t).
Proof.
  intros Ht e He. pose proof (Rabs_pos c). destruct (r_cap _ _ _ _ _ _ H t Ht (e / (Rabs c + 1))) as (d & Hd & K);
    [positive|].
  exists d. split; auto. intros h Hh. rewrite <- Rmult_minus_distr_l. eapply Rle_trans; [apply Rle_abs|].
  rewrite Rabs_mult.
  eapply Rle_trans; [apply Rmult_le_compat_l; [auto|apply (K h Hh)]|].
  assert (Rabs c * (e / (Rabs c + 1)) <= e); [|nra]. unfold Rdiv. rewrite <- Rmult_assoc. undivide (Rabs c + 1). nra.
Qed.
Lemma rubs_power t : 0 <= t -> little (fun h => (F (t + h) - F t) * (v1 t - v2 t) - b t * Rabs (v1 t - v2 t) * h).
Proof. intros Ht. apply friction_power, (r_slip _ _ _ _ _ _ H t Ht). Qed.

(** [interface-energy-rate] With a friction of the strength $b(t)$, whatever it depends on, $\dot
    E=u\,v_1-a_1v_1^2-b(t)|v_1-v_2|$, where the impulse has the rate $u$ from the right. *)
Theorem interface_energy_rate t u : 0 <= t -> rderiv U t u -> rderiv (fun t => energy (x t) (v1 t) (v2 t)) t
  (u * v1 t - a1 * v1 t ^ 2 - b t * Rabs (v1 t - v2 t)).
Proof.
  intros Ht HU. assert (V : rderiv (fun r => m1 * v1 r + 1 * F r) t (u - (a2 * x t + a1 * v1 t))).
  { eapply little_ext; [|exact (little_plus _ _ (r_v1 _ _ _ _ _ _ H t Ht) HU)]. intros h; simpl; ring. }
  eapply little_ext; [|exact (little_minus _ _ (energy_increment m1 m2 a2 1 Hm1 Hm2 x v1 v2 F t _ (r_x _ _ _ _ _ _ H t
    Ht) V (fun h Hh => rubs_v2 t h Ht Hh) (rubs_big t Ht)) (rubs_power t Ht))]. intros h. unfold energy. ring.
Qed.
Lemma rubs_cE : cont (fun t => energy (x t) (v1 t) (v2 t)).
Proof. pose proof rubs_cv2. destruct H. apply energy_cont; auto. Qed.
End One.

Section Two.
Context (b U x v1 v2 F b' U' x' v1' v2' F' : R -> R) (H : rubs b U x v1 v2 F) (H' : rubs b' U' x' v1' v2' F').
Let D t := energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t).
Let w t := v1 t - v2 t.
Let w' t := v1' t - v2' t.

Lemma rubs_cD : cont D.
Proof.
  pose proof (rubs_cv2 _ _ _ _ _ _ H). pose proof (rubs_cv2 _ _ _ _ _ _ H'). apply energy_cont; continuous.
Qed.

(** the increment of the distance, but for friction *)
Lemma rubs_D_increment t du : 0 <= t -> rderiv (fun r => U r - U' r) t du ->
  little (fun h => D (t + h) - D t - (du * (v1 t - v1' t) - a1 * (v1 t - v1' t) ^ 2) * h
    + ((F (t + h) - F t) - (F' (t + h) - F' t)) * (w t - w' t)).
Proof.
  intros Ht HU. assert (V : rderiv (fun r => m1 * (v1 r - v1' r) + 1 * (F r - F' r)) t
    (du - (a2 * (x t - x' t) + a1 * (v1 t - v1' t)))).
  { eapply little_ext; [|exact (little_plus _ _ (little_minus _ _ (r_v1 _ _ _ _ _ _ H t Ht) (r_v1 _ _ _ _ _ _ H' t Ht))
    HU)]. intros h; simpl; ring. }
  eapply little_ext; [|refine (energy_increment m1 m2 a2 1 Hm1 Hm2 (fun r => x r - x' r) (fun r => v1 r - v1' r)
    (fun r => v2 r - v2' r) (fun r => F r - F' r) t _ (rderiv_minus _ _ _ _ _ (r_x _ _ _ _ _ _ H t Ht) (r_x _ _ _ _ _ _ H' t Ht)) V _ _)].
  - intros h. unfold D, energy, w, w'. ring.
  - intros h Hh. pose proof (rubs_v2 _ _ _ _ _ _ H t h Ht Hh). pose proof (rubs_v2 _ _ _ _ _ _ H' t h Ht Hh). lra.
  - eapply big_ext; [|exact (big_minus _ _ (rubs_big _ _ _ _ _ _ H t Ht) (rubs_big _ _ _ _ _ _ H' t Ht))].
    intros h; simpl; ring.
Qed.

(** only the difference of the strengths parts them *)
Theorem interface_parts t du : 0 <= t -> rderiv (fun r => U r - U' r) t du -> dini_le D t
  (du * (v1 t - v1' t) - a1 * (v1 t - v1' t) ^ 2 - (b t - b' t) * (Rabs (w t) - Rabs (w' t))).
Proof.
  intros Ht HU. assert (G : rderiv (fun u => D u - (w' t * F u + w t * F' u)) t
    (du * (v1 t - v1' t) - a1 * (v1 t - v1' t) ^ 2 - b t * Rabs (w t) - b' t * Rabs (w' t))).
  { eapply little_ext; [|exact (little_minus _ _ (little_minus _ _ (rubs_D_increment t du Ht HU)
    (rubs_power _ _ _ _ _ _ H t Ht))
      (rubs_power _ _ _ _ _ _ H' t Ht))]. intros h. unfold w, w'. ring. }
  apply (dini_ext (fun u => (w' t * F u + w t * F' u) + (D u - (w' t * F u + w t * F' u)))); [intros; ring|].
  eapply dini_eq; [|exact (dini_plus _ _ _ _ _ (dini_add _ _ _ _ _ (rubs_cap _ _ _ _ _ _ H (w' t) t Ht)
    (rubs_cap _ _ _ _ _ _ H' (w t) t Ht)) G)]. ring.
Qed.

(** [interface-distance-rate] Where the frictions $f,\tilde f$ of two motions exist from the right,
    $\tfrac12\tfrac{d}{dt}N^2=(u-\tilde u)(v_1-\tilde v_1)-a_1(v_1-\tilde v_1)^2-(f-\tilde f)(\dot z-\dot{\tilde z})$.
    *)
Theorem interface_distance_rate t du f f' : 0 <= t -> rderiv (fun r => U r - U' r) t du -> rderiv F t f -> rderiv F' t f' ->
  rderiv D t (du * (v1 t - v1' t) - a1 * (v1 t - v1' t) ^ 2 - (f - f') * (w t - w' t)).
Proof.
  intros Ht HU Df Df'.
  eapply little_ext; [|exact (little_minus _ _ (rubs_D_increment t du Ht HU) (little_scal (w t - w' t) _ (little_minus _ _ Df Df')))].
  intros h. cbv beta. ring.
Qed.
End Two.

(** [interface-contraction] Two motions under one force with a friction of one strength $b$ along both, as any $b(t)$
    has, never move apart in the energy norm. *)
Theorem interface_contraction b U x v1 v2 F x' v1' v2' F' r t : rubs b U x v1 v2 F -> rubs b U x' v1' v2' F' -> 0 <= r <= t ->
  energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t) <= energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r).
Proof.
  intros H H' Hr. apply (dini_mono (fun t => energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t))); auto.
  { exact (rubs_cD _ _ _ _ _ _ _ _ _ _ _ _ H H'). }
  intros u Hu. eapply dini_weaken; [|exact (interface_parts _ _ _ _ _ _ _ _ _ _ _ _ H H' u 0
    ltac:(lra) (rderiv_same U u))].
  assert (0 <= a1 * (v1 u - v1' u) ^ 2) by positive. lra.
Qed.

(** a product by two squares *)
Lemma product_below p q a k P : 0 < a -> 0 < k -> q ^ 2 <= k * P -> Rabs p * Rabs q <= sqrt (k / a) * (a * p ^ 2 + P).
Proof.
  intros Ha Hk Hq. set (r := sqrt (k / a)). assert (Er : r * r = k / a) by (apply sqrt_sqrt, Rlt_le; positive).
  assert (Ea : a * (r * r) = k) by (rewrite Er; field; lra). rewrite <- (pow2_abs p). rewrite <- (pow2_abs q) in Hq.
  set (u := Rabs p) in *. set (v := Rabs q) in *. apply Rmult_le_reg_l with (a * r); [positive|].
  replace (a * r * (r * (a * u ^ 2 + P))) with ((a * r * u) ^ 2 + a * (r * r) * P) by ring. rewrite Ea.
  pose proof (pow2_ge_0 (a * r * u - v)). pose proof (pow2_ge_0 (a * r * u + v)). lra.
Qed.
Lemma gap_below dx dv dw : (dv - dw) ^ 2 <= kap * (2 * energy dx dv dw - a2 * dx ^ 2).
Proof.
  unfold energy, Pair.energy, kap, M. apply Rmult_le_reg_l with (m1 * m2); [positive|].
  replace (m1 * m2 * ((m1 + m2) / (m1 * m2) * (2 * (a2 * dx ^ 2 / 2 + m1 * dv ^ 2 / 2 + m2 * dw ^ 2 / 2) - a2 * dx ^ 2)))
    with ((m1 + m2) * (m1 * dv ^ 2 + m2 * dw ^ 2)) by (field; lra). pose proof (pow2_ge_0 (m1 * dv + m2 * dw)). nra.
Qed.
Let kap_pos : 0 < kap := ltac:(unfold kap, M; positive).
Lemma root_growth y g t : 0 <= t -> 0 <= y 0 -> y t <= exp (2 * g * t) * y 0 -> sqrt (y t) <= exp (g * t) * sqrt (y 0).
Proof.
  intros Ht P Q. pose proof (exp_pos (g * t)). rewrite <- (sqrt_square (exp (g * t))) by lra. rewrite <- sqrt_mult by (nra || auto).
  apply sqrt_le_1_alt. rewrite <- exp_plus. replace (g * t + g * t) with (2 * g * t) by ring. auto.
Qed.

Section Growth.
Context (b U x v1 v2 F b' x' v1' v2' F' : R -> R) (H : rubs b U x v1 v2 F) (H' : rubs b' U x' v1' v2' F').
Let N2 t := 2 * energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t).
Let w t := v1 t - v2 t.
Let w' t := v1' t - v2' t.
Context (l : R) (Hl : 0 <= l).

Let N2_pos t : 0 <= N2 t.
Proof. pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x t - x' t) (v1 t - v1' t) (v2 t - v2' t)). unfold N2, energy. lra. Qed.
Let N2_cont : cont N2.
Proof. apply cont_scal. exact (rubs_cD _ _ _ _ _ _ _ _ _ _ _ _ H H'). Qed.
Let N2_dini t k : 0 <= t -> - (b t - b' t) * (Rabs (w t) - Rabs (w' t)) <= k -> dini_le N2 t (2 * k).
Proof.
  intros Ht Hk. refine (dini_weaken _ _ (2 * _) _ _ (dini_scal 2 _ _ _ Rlt_0_2
    (interface_parts _ _ _ _ _ _ _ _ _ _ _ _ H H' t 0 Ht
    (rderiv_same U t)))). fold (w t) (w' t). assert (0 <= a1 * (v1 t - v1' t) ^ 2) by positive. lra.
Qed.
Let apart t : Rabs (Rabs (w t) - Rabs (w' t)) <= Rabs (w t - w' t) := Rabs_triang_inv2 _ _.
Let gap t : (w t - w' t) ^ 2 <= kap * (N2 t - a2 * (x t - x' t) ^ 2).
Proof.
  replace (w t - w' t) with ((v1 t - v1' t) - (v2 t - v2' t)) by (unfold w, w'; ring). apply gap_below.
Qed.
Let by_slopes t c : 0 <= c -> Rabs (b t - b' t) <= c -> - (b t - b' t) * (Rabs (w t) - Rabs (w' t)) <= c * Rabs (w t - w' t).
Proof.
  intros Hc K. apply Rle_trans with (1 := Rle_abs _). rewrite Rabs_mult, Rabs_Ropp.
  apply Rmult_le_compat; auto using Rabs_pos.
Qed.

(** [growth-by-place] Where $|b-\tilde b|\leqslant\ell|x_1-\tilde x_1|$ along two motions: $N(t)\leqslant e^{\gamma
    t}N(0)$, $\gamma=\ell\sqrt{(m_1+m_2)/(m_1m_2a_2)}$. *)
Theorem growth_by_place t : 0 <= t -> (forall t, 0 <= t -> Rabs (b t - b' t) <= l * Rabs (x t - x' t)) ->
  sqrt (N2 t) <= exp (l * sqrt ((m1 + m2) / (m1 * m2 * a2)) * t) * sqrt (N2 0).
Proof.
  intros Ht K. set (r := sqrt ((m1 + m2) / (m1 * m2 * a2))). apply root_growth; auto.
  apply in_proportion; auto. intros u Hu. rewrite !Rmult_assoc. apply N2_dini; auto.
  eapply Rle_trans; [apply (by_slopes u _ (Rmult_le_pos _ _ Hl (Rabs_pos (x u - x' u))) (K u Hu))|].
  rewrite Rmult_assoc. apply Rmult_le_compat_l; auto.
  pose proof (product_below (x u - x' u) _ a2 kap _ Ha2 kap_pos (gap u)) as Q.
  replace (kap / a2) with ((m1 + m2) / (m1 * m2 * a2)) in Q by (unfold kap, M; field; lra). fold r in Q. lra.
Qed.

(** [growth-by-speed] Where $b$ falls by at most $\ell$ times the increase of $|\dot z|$: $N(t)\leqslant e^{\gamma
    t}N(0)$, $\gamma=\ell(m_1+m_2)/(m_1m_2)$. *)
Theorem growth_by_speed t : 0 <= t -> (forall t, 0 <= t ->
  - l * (Rabs (w t) - Rabs (w' t)) ^ 2 <= (b t - b' t) * (Rabs (w t) - Rabs (w' t))) ->
  sqrt (N2 t) <= exp (l * (m1 + m2) / (m1 * m2) * t) * sqrt (N2 0).
Proof.
  intros Ht K. replace (l * (m1 + m2) / (m1 * m2)) with (l * kap) by (unfold kap, M; field; lra).
  apply root_growth; auto. apply in_proportion; auto. intros u Hu. rewrite !Rmult_assoc.
  apply N2_dini; auto. apply Rle_trans with (l * (Rabs (w u) - Rabs (w' u)) ^ 2); [specialize (K u Hu); lra|].
  apply Rmult_le_compat_l; auto. pose proof (apart u) as A. rewrite <- (pow2_abs (Rabs (w u) - Rabs (w' u))).
  pose proof (Rabs_pos (Rabs (w u) - Rabs (w' u))). pose proof (gap u) as G. rewrite <- (pow2_abs (w u - w' u)) in G.
  assert (Rabs (Rabs (w u) - Rabs (w' u)) ^ 2 <= Rabs (w u - w' u) ^ 2) by (apply pow_incr; lra).
  assert (0 <= kap * (a2 * (x u - x' u) ^ 2)) by positive. lra.
Qed.

(** [growth-by-state] Where $|b-\tilde b|\leqslant\ell(|x_1-\tilde x_1|+|z-\tilde z|+||\dot z|-|\dot{\tilde z}||)$
    along two motions, $N^2+(z-\tilde z)^2$ grows at most as $e^{2\gamma t}$,
    $\gamma=\ell\sqrt{\kappa/a_2}+(\ell+1)\sqrt\kappa+\ell\kappa$. *)
Theorem growth_by_state z z' t : cont z -> cont z' -> (forall t, 0 <= t -> rderiv z t (w t)) ->
  (forall t, 0 <= t -> rderiv z' t (w' t)) -> 0 <= t -> (forall t, 0 <= t ->
    Rabs (b t - b' t) <= l * (Rabs (x t - x' t) + Rabs (z t - z' t) + Rabs (Rabs (w t) - Rabs (w' t)))) ->
  N2 t + (z t - z' t) ^ 2 <= exp (2 * (l * sqrt (kap / a2) + (l + 1) * sqrt kap + l * kap) * t) * (N2 0 + (z 0 - z' 0) ^ 2).
Proof.
  intros Cz Cz' Dz Dz' Ht K. set (ra := sqrt (kap / a2)). set (r := sqrt kap). assert (Sa : 0 <= ra) by apply sqrt_pos.
  apply (in_proportion (fun u => N2 u + (z u - z' u) ^ 2)); auto.
  { continuous. }
  intros u Hu. set (p := z u - z' u). set (q := w u - w' u). set (o := x u - x' u). pose proof (apart u) as Ap.
  fold q in Ap. pose proof (gap u) as G. fold q o in G. pose proof (pow2_ge_0 p).
  assert (Sum : 0 <= l * (Rabs o + Rabs p + Rabs q)) by positive.
  assert (Kb : Rabs (b u - b' u) <= l * (Rabs o + Rabs p + Rabs q)).
  { eapply Rle_trans; [apply K; auto|]. fold o p. apply Rmult_le_compat_l; auto. lra. }
  eassert (Dp : rderiv (fun u => (z u - z' u) ^ 2) u _) by rates. cbv beta in Dp. fold p q in Dp.
  eapply dini_weaken; [|exact (dini_plus _ _ _ _ _ (N2_dini u _ Hu (by_slopes u _ Sum Kb)) Dp)]. fold p q.
  assert (Kp : 0 <= kap * (a2 * o ^ 2)) by positive. assert (Gq : q ^ 2 <= kap * N2 u) by lra.
  pose proof (product_below p q 1 kap (N2 u) Rlt_0_1 kap_pos Gq) as Q. replace (kap / 1) with kap in Q by field.
  fold r in Q. pose proof (product_below o q a2 kap _ Ha2 kap_pos G) as Q'. rewrite <- (pow2_abs q) in Gq.
  pose proof (Rle_abs (p * q)) as A. rewrite Rabs_mult in A. set (Y := N2 u + p ^ 2) in *.
  assert (Q1 : l * (Rabs o * Rabs q) <= l * (ra * Y)) by (apply Rmult_le_compat_l; [auto|]; eapply Rle_trans; [exact
    Q'|]; apply Rmult_le_compat_l; [auto|unfold Y; lra]).
  assert (Q2 : l * (Rabs p * Rabs q) <= l * (r * Y)) by (apply Rmult_le_compat_l; [auto|unfold Y; lra]).
  assert (Q3 : l * (Rabs q ^ 2) <= l * (kap * Y)) by (apply Rmult_le_compat_l; [auto|]; eapply Rle_trans; [exact Gq|];
    apply Rmult_le_compat_l; [lra|unfold Y; lra]). assert (Q4 : p * q <= r * Y) by (unfold Y; lra).
  lra.
Qed.
End Growth.

(** *** Two forces: the root of twice the distance grows at most by the integral of their difference over sqrt m1 *)

(** [interface-input-to-state] With a friction of one strength $b(t)$, under two forces: $N(t)\leqslant
    N(r)+m_1^{-1/2}\int_r^t|u-\tilde u|$, $\frac12N^2$ the energy of the difference. *)
Theorem interface_input_to_state b U U' x v1 v2 F x' v1' v2' F' du J r t :
  rubs b U x v1 v2 F -> rubs b U' x' v1' v2' F' -> (forall t, 0 <= t -> rderiv (fun r => U r - U' r) t (du t)) -> cont J ->
  (forall t, 0 <= t -> rderiv J t (Rabs (du t))) -> 0 <= r <= t ->
  sqrt (2 * energy (x t - x' t) (v1 t - v1' t) (v2 t - v2' t)) <=
  sqrt (2 * energy (x r - x' r) (v1 r - v1' r) (v2 r - v2' r)) + (J t - J r) / sqrt m1.
Proof.
  intros H H' HU CJ HJ Hr. apply (pushed_apart m1 m2 a2 Hm1 Hm2 Ha2 (fun t => x t - x' t) (fun t => v1 t - v1' t) (fun t
    => v2 t - v2' t) du); auto; [exact (rubs_cD _ _ _ _ _ _ _ _ _ _ _ _ H H')|].
  split; [apply HJ; lra|]. eapply dini_weaken; [|exact (interface_parts _ _ _ _ _ _ _ _ _ _ _ _ H H' u _
    ltac:(lra) (HU u ltac:(lra)))].
  pose proof (pow2_ge_0 (v1 u - v1' u)). nra.
Qed.

(** where the forces are bounded the velocity of body 1 is Lipschitz *)
Section Lipschitz.
Variables (b U x v1 v2 F : R -> R) (B G hi : R).
Hypotheses (H : rubs b U x v1 v2 F) (Bd : forall t, 0 <= t -> Rabs (a2 * x t + a1 * v1 t) <= B /\ b t <= hi)
  (LU : forall r t, 0 <= r <= t -> Rabs (U t - U r) <= G * (t - r)).
Lemma impulse_lip r t : 0 <= r <= t -> Rabs (F t - F r) <= hi * (t - r).
Proof.
  intros Hr. apply cap_lip; [apply (r_cF _ _ _ _ _ _ H)|auto|]. intros u Hu e He.
  destruct (r_cap _ _ _ _ _ _ H u ltac:(lra) e He) as (d & Hd & K). exists d; split; auto. intros h Hh.
  eapply Rle_trans; [apply K; auto|]. destruct (Bd u ltac:(lra)). apply Rmult_le_compat_r; lra.
Qed.
Lemma body1_lip r t : 0 <= r <= t -> Rabs (v1 t - v1 r) <= / m1 * (B + G + hi) * (t - r).
Proof.
  intros Hr. assert (LA : Rabs ((m1 * v1 t + F t - U t) - (m1 * v1 r + F r - U r)) <= B * (t - r)).
  { apply (lip_of_rderiv (fun u => m1 * v1 u + F u - U u) (fun u => - (a2 * x u + a1 * v1 u))); auto.
    - continuous.
    - intros u Hu. rewrite Rabs_Ropp. split; [apply (r_v1 _ _ _ _ _ _ H)|apply Bd]; auto. }
  pose proof (LU r t Hr) as L. pose proof (impulse_lip r t Hr) as LF.
  replace (v1 t - v1 r) with (/ m1 * ((m1 * v1 t + F t - U t) - (m1 * v1 r + F r - U r) - (F t - F r) + (U t - U r)))
    by (field; lra).
  rewrite Rmult_assoc. apply abs_scal; [apply Rlt_le; positive|]. apply Rabs_inv in LA, LF, L. apply Rabs_le. lra.
Qed.
Lemma slip_lip r t : 0 <= r <= t -> Rabs ((v1 t - v2 t) - (v1 r - v2 r)) <= (/ m1 * (B + G + hi) + / m2 * hi) * (t - r).
Proof.
  intros Hr. pose proof (body1_lip r t Hr) as L1. pose proof (r_v2 _ _ _ _ _ _ H r ltac:(lra)) as E1.
  pose proof (r_v2 _ _ _ _ _ _ H t ltac:(lra)) as E2. assert (L2 : Rabs (v2 t - v2 r) <= / m2 * (hi * (t - r))).
  { replace (v2 t - v2 r) with (/ m2 * (F t - F r)) by (replace (F t - F r) with (m2 * (v2 t - v2 r)) by lra; field; lra).
    apply abs_scal; [apply Rlt_le; positive|apply impulse_lip, Hr]. }
  apply Rabs_inv in L1, L2. apply Rabs_le. lra.
Qed.
End Lipschitz.

(** a motion under a force has one strength; one that sticks, and needs a share of it only, that share *)
Lemma forced_rubs b U x v1 v2 s : 0 < b -> forced m1 m2 a1 a2 b U x v1 v2 s ->
  rubs (fun _ => b) U x v1 v2 (fun t => b * s t).
Proof.
  intros Hb H. apply rubs_constant; auto. replace (fun t => b * s t / b) with s; auto.
  apply FunctionalExtensionality.functional_extensionality. intros t. field. lra.
Qed.
Lemma stuck_rubs b rho U y v r : 0 < b -> forced m1 m2 a1 a2 b U y v v r ->
  (forall p q, 0 <= p <= q -> Rabs (r q - r p) <= rho * (q - p)) -> rubs (fun _ => b * rho) U y v v (fun t => b * r t).
Proof.
  intros Hb H Easy. pose proof (moves_cs _ _ _ _ _ _ _ _ _ _ _ H) as Cr. destruct H as [_ _ _ CU Cy Cv Y V W].
  constructor; auto using cont_scal; [|intros; lra]. exists 1. split; [lra|]. intros h Hh.
  rewrite <- Rmult_minus_distr_l. pose proof (Easy t (t + h) ltac:(lra)) as L.
  apply Rle_trans with (b * (rho * h)); [apply abs_scal; lra|nra].
Qed.

(** *** Without a force, friction that stays above some strength brings the slip to rest, whatever it depends on *)

(** [interface-synchronises] Without a force, with a strength between $b_{\min}>0$ and $b_{\max}$, whatever it depends
    on: $\dot E\leqslant-b_{\min}|\dot z|$, $\dot z\to 0$, and $z$ has a limit. *)
Theorem interface_synchronises b x v1 v2 F z lo hi : rubs b (fun _ => 0) x v1 v2 F -> 0 < lo ->
  (forall t, 0 <= t -> lo <= b t <= hi) -> cont z -> (forall t, 0 <= t -> rderiv z t (v1 t - v2 t)) ->
  (forall t, 0 <= t -> dini_le (fun t => energy (x t) (v1 t) (v2 t)) t (- lo * Rabs (v1 t - v2 t))) /\
  (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (v1 t - v2 t) <= e) /\
  exists zl, forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (z t - zl) <= e.
Proof.
  intros H Hlo Hb Cz Dz. set (w := fun t => v1 t - v2 t). set (E := fun t => energy (x t) (v1 t) (v2 t)).
  pose proof (rubs_cv2 _ _ _ _ _ _ H) as C2. assert (C1 : cont v1) by continuous.
  assert (Cx : cont x) by continuous. assert (Fall : forall t, 0 <= t -> dini_le E t (- lo * Rabs (w t))).
  { intros t Ht. eapply rderiv_dini; [|exact (interface_energy_rate _ _ _ _ _ _ H t 0 Ht (rderiv_const 0 t))].
    fold (w t). pose proof (Rabs_pos (w t)). specialize (Hb t Ht). nra. }
  assert (Paid : forall k r t, k = 1 \/ k = -1 -> 0 <= r <= t -> E t + k * lo * z t <= E r + k * lo * z r).
  { intros k r t Hk Hr. apply (dini_mono (fun u => E u + k * lo * z u)); [|auto|].
    - apply cont_plus; [exact (rubs_cE _ _ _ _ _ _ H)|continuous].
    - intros u Hu. pose proof (rderiv_scal (k * lo) _ _ _ (Dz u ltac:(lra))) as D.
      eapply dini_weaken; [|exact (dini_plus _ _ _ _ _ (Fall u ltac:(lra)) D)].
      fold (w u). rewrite <- (Rabs_sign k) by auto. pose proof (Rle_abs (k * w u)). nra. }
  assert (Em : forall r t, 0 <= r <= t -> E t <= E r).
  { intros r t Hr. pose proof (Paid 1 r t ltac:(auto) Hr). pose proof (Paid (-1) r t ltac:(auto) Hr). lra. }
  split; [exact Fall|]. split.
  - set (X := sqrt (2 * E 0 / a2)). set (V := sqrt (2 * E 0 / m1)).
    set (K := / m1 * (a2 * X + a1 * V + 0 + hi) + / m2 * hi). pose proof (Hb 0 (Rle_refl 0)).
    assert (0 <= X) by apply sqrt_pos. assert (0 <= V) by apply sqrt_pos. assert (0 <= a2 * X + a1 * V) by positive.
    apply (slip_vanishes m1 m2 a2 lo Hm1 Hm2 Ha2 Hlo x v1 v2 Cx C1 C2) with (K := K); [|unfold K; positive|].
    + intros t Ht. eapply dini_eq; [|exact (Fall t Ht)]. fold (w t). ring.
    + apply (slip_lip b (fun _ => 0) x v1 v2 F (a2 * X + a1 * V) 0 hi H).
      * intros u Hu. pose proof (Em 0 u ltac:(lra)) as Q. apply energy_within in Q as (Bx & Bv & _); auto.
        split; [|apply Hb; auto]. eapply Rle_trans; [apply Rabs_triang|].
        apply Rplus_le_compat; apply abs_scal; auto; lra.
      * intros p q Hp. rewrite Rminus_0_r, Rabs_R0. lra.
  - destruct (paid_converges E lo (fun t _ => energy_pos m1 m2 a2 Hm1 Hm2 Ha2 _ _ _) Em Hlo z)
      as (zl & _ & Lim); [|exists zl; exact Lim].
    intros r t Hr. rewrite <- (Rabs_pos_eq lo) by lra. rewrite <- Rabs_mult. apply abs_by. intros k Hk.
    pose proof (Paid k r t Hk Hr). lra.
Qed.

(** with a friction of one strength, too *)
Corollary solution_synchronises b x v1 v2 s : 0 < b -> solution m1 m2 a1 a2 b x v1 v2 s ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (v1 t - v2 t) <= e.
Proof.
  intros Hb H. pose proof (forced_rubs b _ x v1 v2 s Hb (proj2 (free_case _ _ _ _ _ _ _ _ _) H)) as R.
  pose proof (rubs_cv2 _ _ _ _ _ _ R). assert (C : cont (fun t => v1 t - v2 t)) by continuous.
  apply (interface_synchronises _ x v1 v2 _ (integral (fun t => v1 t - v2 t)) b b R Hb); [intros; lra|apply integral_cont, C|].
  intros t Ht. exact (integral_rderiv (fun t => v1 t - v2 t) t C Ht).
Qed.
End Interface.

(** behind the section, too *)
Ltac rubs_fact := first [eapply r_cx; eassumption | eapply r_cv; eassumption | eapply r_cU; eassumption
  | eapply r_cF; eassumption | eapply r_x; [eassumption|lra] | eapply r_v1; [eassumption|lra]].
Ltac motion ::= first [rubs_fact | forced_fact].
