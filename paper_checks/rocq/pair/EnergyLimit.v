(** The energy tends to a limit of at most E_cr: turned back by the angle Omega t the state moves only by slip, and slip
    costs energy; above E_cr each turn would cost a fixed amount. *)
From InertialPair Require Import Dini Pair Stick TurnedFrame.

Lemma nat_above y d : 0 < d -> exists k : nat, y < INR k * d.
Proof.
  intros Hd. destruct (nfloor_ex (Rmax 0 (y / d)) (Rmax_l _ _)) as (n & _ & Hn). exists (S n). rewrite S_INR.
  pose proof (Rmax_r 0 (y / d)). replace y with (y / d * d) by (field; lra). scale.
Qed.

(** polar coordinates, at a time within one turn: the angle is measured from that at t0 *)
Lemma polar A B R om t0 : 0 < R -> 0 < om -> A ^ 2 + B ^ 2 = R ^ 2 ->
  exists t, t0 <= t <= t0 + 2 * PI / om /\ R * cos (om * t) = A /\ R * sin (om * t) = B.
Proof.
  intros HR Hom E. pose proof (sin2_cos2 (om * t0)) as SC. unfold Rsqr in SC. set (c := cos (om * t0)) in *.
  set (s := sin (om * t0)) in *. set (A' := A * c + B * s). set (B' := B * c - A * s).
  assert (E' : A' ^ 2 + B' ^ 2 = R ^ 2).
  { replace (A' ^ 2 + B' ^ 2) with ((A ^ 2 + B ^ 2) * (s * s + c * c)) by (unfold A', B'; ring). rewrite SC, E. ring. }
  assert (Hq : -1 <= A' / R <= 1).
  { assert (- R <= A' <= R) by (apply sq_le_abs; [lra|pose proof (pow2_ge_0 B'); lra]). split; undivide R; lra. }
  pose proof (acos_bound (A' / R)) as Hp. set (p := acos (A' / R)) in *. pose proof (sin2_cos2 p) as SCp.
  assert (Cp : R * cos p = A') by (unfold p; rewrite cos_acos by auto; field; lra). assert (Sp : R * sin p = Rabs B').
  { apply Rsqr_inj; [|apply Rabs_pos|].
    - apply Rmult_le_pos; [lra|apply sin_ge_0; lra].
    - rewrite <- Rsqr_abs. unfold Rsqr in *. nra. }
  assert (exists q, 0 <= q <= 2 * PI /\ R * cos q = A' /\ R * sin q = B') as (q & Hq' & C & S).
  { destruct (Rle_dec 0 B'); [exists p; rewrite Rabs_pos_eq in Sp by lra; lra|]. rewrite Rabs_left in Sp by lra.
    exists (2 * PI - p). rewrite cos_minus, sin_minus, cos_2PI, sin_2PI. lra. }
  exists (t0 + q / om). assert (0 <= q / om <= 2 * PI / om) by (split; [positive|undivide om; field_simplify; lra]).
  split; [lra|]. replace (om * (t0 + q / om)) with (om * t0 + q) by (field; lra). rewrite cos_plus, sin_plus. fold c s.
  split; [transitivity (c * (R * cos q) - s * (R * sin q))|transitivity (s * (R * cos q) + c * (R * sin q))]; try ring;
    rewrite C, S; [transitivity (A * (s * s + c * c))|transitivity (B * (s * s + c * c))]; try (unfold A', B'; ring);
    rewrite SC; ring.
Qed.

(** cos z >= 1 - z^2/2 *)
Lemma cos_below z : 0 <= z <= 1 -> 1 - z ^ 2 / 2 <= cos z.
Proof.
  intros Hz. replace z with (2 * (z / 2)) at 2 by field. rewrite cos_2a_sin.
  destruct (Req_dec z 0) as [->|N]. { replace (0 / 2) with 0 by field. rewrite sin_0. lra. }
  assert (sin (z / 2) < z / 2) by (apply sin_lt_x; lra). assert (0 <= sin (z / 2)).
  { pose proof PI2_1. apply sin_ge_0; lra. } nra.
Qed.

Section Limit.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).

Let M := m1 + m2.
Let om := omega m1 m2 a2.
Let w t := v1 t - v2 t.
Let P t := m1 * v1 t + m2 * v2 t.
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Let turned := turned m1 m2 a2 x v1 v2.
Let kap := m2 / (M * b).

Let om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2.
Let kap_pos : 0 < kap. Proof. unfold kap, M. positive. Qed.
Let Ha1 : 0 <= 0 := Rle_refl 0.

(** the momentum feels the spring alone *)
Lemma P_rate t : 0 <= t -> rderiv P t (- a2 * x t).
Proof.
  intros Ht. eapply rderiv_ext with (f := fun u => (m1 * v1 u + b * s u) + (m2 * v2 0 - b * s 0)).
  { intros u Hu. unfold P. pose proof (s_v2 _ _ _ _ _ _ _ _ _ H u ltac:(lra)). lra. }
  eapply rderiv_eq; [|apply rderiv_plus; [apply (s_v1 _ _ _ _ _ _ _ _ _ H t Ht)|apply rderiv_const]]. ring.
Qed.

Lemma cont_v : cont v2. Proof. exact (moves_cv2 m1 m2 0 a2 b Hm2 _ _ _ _ _ _ H). Qed.
Lemma cont_w : cont w.
Proof. apply cont_minus; [apply (s_cv _ _ _ _ _ _ _ _ _ H)|apply cont_v]. Qed.
Lemma cont_En : cont E. Proof. exact (moves_cE m1 m2 0 a2 b Hm2 _ _ _ _ _ _ H). Qed.
(** slip costs energy *)
Lemma E_rate t : 0 <= t -> rderiv E t (- b * Rabs (w t)).
Proof. intros Ht. eapply rderiv_eq; [|apply (energy_rate m1 m2 0 a2 b Hm1 Hm2 _ _ _ _ H t Ht)]. unfold w; ring. Qed.
Lemma E_mono r t : 0 <= r <= t -> E t <= E r.
Proof. exact (energy_decreases m1 m2 0 a2 b Hm1 Hm2 Ha1 Hb _ _ _ _ H r t). Qed.

(** energy pays for every change of the turned place *)
Lemma E_pays t : 0 <= t -> dini_le E t (- (b * Rabs (w t))).
Proof. intros Ht. eapply rderiv_dini; [|apply E_rate, Ht]. lra. Qed.
Lemma paid phi r t : 0 <= r <= t -> Rabs (turned phi t - turned phi r) <= kap * (E r - E t).
Proof.
  exact (paid m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 (s_cx _ _ _ _ _ _ _ _ _ H) (s_cv _ _ _ _ _ _ _ _ _ H) cont_v
    (s_x _ _ _ _ _ _ _ _ _ H) P_rate E_pays phi r t).
Qed.

(** outside the strip the relative velocity runs down at a positive rate *)
Lemma w_falls r t g : 0 <= r <= t -> (forall u, r <= u < t -> L m1 m2 a2 b + g <= x u) ->
  w t - w r <= - (a2 / m1 * g) * (t - r).
Proof.
  intros Hr Hx. pose proof (proj1 (solution_moves _ _ _ _ _ _ _ _ _) H) as Mo. set (k := b * ((m1 + m2) / (m1 * m2))).
  assert (Kp : 0 < k) by positive. assert (Q : (w t + k * s t) - (w r + k * s r) <= - (k + a2 / m1 * g) * (t - r)).
  { apply (dini_slope (fun u => w u + k * s u)); [|lra|].
    { apply cont_plus; [apply cont_w|apply cont_scal, (moves_cs _ _ _ _ _ _ _ _ _ _ _ H)]. }
    intros u Hu.
    eapply rderiv_dini; [|exact (moves_slip _ _ _ _ _ Hm1 Hm2 _ _ _ _ _ _ Mo u 0 ltac:(lra) (rderiv_const 0 u))].
    replace (k + a2 / m1 * g) with (a2 / m1 * (L m1 m2 a2 b + g)) by (unfold k, L; field; lra).
    replace ((0 - a2 * x u - 0 * v1 u) / m1) with (- (a2 / m1 * x u)) by (field; lra).
    apply Ropp_le_contravar, Rmult_le_compat_l; [positive|auto]. }
  pose proof (s_lip _ _ _ _ _ _ _ _ _ H r t Hr) as Ls. apply Rabs_inv in Ls. nra.
Qed.

(** so a stay outside costs energy *)
Lemma outside_costs r tau g : 0 <= r -> 0 < tau -> 0 < g -> (forall u, r <= u < r + tau -> L m1 m2 a2 b + g <= x u) ->
  b * (a2 / m1 * g) * tau ^ 2 / 8 <= E r - E (r + tau).
Proof.
  intros Hr Ht Hg Hx. set (c := a2 / m1 * g). set (m := r + tau / 2).
  assert (Fall : forall p q, r <= p <= q -> q <= r + tau -> w q - w p <= - c * (q - p)).
  { intros p q Hp Hq. apply w_falls; [lra|]. intros u Hu. apply Hx. lra. }
  assert (Pay : forall k p q, r <= p <= q -> (forall u, p <= u < q -> k * c * (u - m) <= Rabs (w u)) ->
    E q + k * (b * c / 2) * (q - m) ^ 2 <= E p + k * (b * c / 2) * (p - m) ^ 2).
  { intros k p q Hp Big. set (f := fun u => k * (b * c / 2) * (u - m) ^ 2).
    assert (Df : forall u, is_derive f u (k * b * c * (u - m))) by (intros u; unfold f; auto_derive; auto; field).
    apply (rderiv_mono (fun u => E u + f u) p q (fun u => - b * Rabs (w u) + k * b * c * (u - m))); [|lra|].
    - apply cont_plus; [apply cont_En|eapply cont_of_derive, Df].
    - intros u Hu. split; [apply rderiv_plus; [apply E_rate; lra|apply rderiv_of_derive, Df]|]. specialize (Big u Hu).
      nra. }
  pose proof (E_mono r m ltac:(unfold m; lra)). pose proof (E_mono m (r + tau) ltac:(unfold m; lra)).
  destruct (Rle_dec (w m) 0) as [W|W].
  - pose proof (Pay 1 m (r + tau) ltac:(unfold m; lra)) as Q. cut (E (r + tau) + 1 * (b * c / 2) * (r + tau - m) ^ 2 <=
      E m + 1 * (b * c / 2) * (m - m) ^ 2); [unfold m in *; lra|]. apply Q. intros u Hu.
    pose proof (Fall m u ltac:(unfold m in *; lra) ltac:(lra)). pose proof (Rle_abs (- w u)) as A.
    rewrite Rabs_Ropp in A. lra.
  - pose proof (Pay (-1) r m ltac:(unfold m; lra)) as Q. cut (E m + -1 * (b * c / 2) * (m - m) ^ 2 <=
      E r + -1 * (b * c / 2) * (r - m) ^ 2); [unfold m in *; lra|]. apply Q. intros u Hu.
    pose proof (Fall u m ltac:(lra) ltac:(unfold m; lra)). pose proof (Rle_abs (w u)). lra.
Qed.

(** E has a limit *)
Lemma E_limit : exists l, 0 <= l /\ (forall t, 0 <= t -> l <= E t) /\ forall e, 0 < e -> exists T, 0 <= T /\
  forall t, T <= t -> E t <= l + e.
Proof.
  apply (dec_limit E E_mono). intros t _. apply energy_pos; auto.
Qed.

(** *** Above E_cr energy is paid, again and again *)
(** how far the ellipse of the energy l reaches beyond the strip, by a quarter *)
Definition room l := (sqrt (2 * l / a2) - L m1 m2 a2 b) / 4.
(** how long the pair would stay out there *)
Definition outing l := Rmin 1 (2 * room l / sqrt (2 * l / a2)) / omega m1 m2 a2.
(** what it must pay for that, or for not going there *)
Definition toll l := Rmin (b * (a2 / m1 * room l) * outing l ^ 2 / 8 / 2) (room l / (2 * (m2 / ((m1 + m2) * b)))).
(** and within which time: a contact, a turn, and the stay *)
Definition spell e l := 2 * sqrt (2 * e * m2) / b + 2 * PI / omega m1 m2 a2 + outing l.

Lemma room_pos l : Ecr m1 m2 a2 b < l -> 0 < room l.
Proof.
  intros Hl. rewrite Ecr_L in Hl by auto. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb). unfold room.
  set (l0 := L m1 m2 a2 b) in *. assert (l0 < sqrt (2 * l / a2)); [|lra]. rewrite <- (sqrt_pow2 l0) by lra.
  apply sqrt_lt_1_alt. split; [positive|]. undivide a2. lra.
Qed.
Lemma outing_pos l : Ecr m1 m2 a2 b < l -> 0 < outing l.
Proof.
  intros Hl. pose proof (room_pos l Hl) as G. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as LP.
  apply Rdiv_lt_0_compat; auto. apply Rmin_glb_lt; [lra|]. apply Rdiv_lt_0_compat; [lra|]. unfold room in G. lra.
Qed.
Lemma toll_pos l : Ecr m1 m2 a2 b < l -> 0 < toll l.
Proof.
  intros Hl. pose proof (room_pos l Hl) as G. pose proof (outing_pos l Hl) as O.
  apply Rmin_glb_lt; [|apply Rdiv_lt_0_compat; [auto|fold M; fold kap; lra]]. positive.
Qed.

Lemma spell_pos e l : Ecr m1 m2 a2 b < l -> 0 <= spell e l.
Proof.
  intros Hl. pose proof (outing_pos l Hl) as O. pose proof PI_RGT_0. assert (0 < 2 * PI / omega m1 m2 a2) by positive.
  assert (0 <= 2 * sqrt (2 * e * m2) / b) by positive. unfold spell. lra.
Qed.

(** while the energy stays above l > E_cr, each such time costs the toll *)
Theorem toll_paid e l T : Ecr m1 m2 a2 b < l -> 0 <= T -> E T <= e -> l <= E (T + spell e l) ->
  E (T + spell e l) <= E T - toll l.
Proof.
  intros Hl HT He HlW. apply Rnot_lt_le. intros NP. pose proof (room_pos l Hl) as Hg.
  pose proof (outing_pos l Hl) as Htau. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as LP. set (W := spell e l) in *.
  set (d := toll l) in *. set (tau := outing l) in *. set (e0 := b * (a2 / m1 * room l) * tau ^ 2 / 8).
  assert (Hd1 : d <= e0 / 2) by apply Rmin_l. assert (Hd2 : d <= room l / (2 * kap)) by apply Rmin_r.
  set (g := room l) in *. set (R0 := sqrt (2 * l / a2)). set (LL := L m1 m2 a2 b) in *.
  assert (Eg : R0 = LL + 4 * g) by (unfold g, room; fold LL R0; field).
  set (z := Rmin 1 (2 * g / R0)). assert (Ez : tau = z / om) by reflexivity. assert (Hz1 : z <= 1) by apply Rmin_l.
  assert (Hz2 : z <= 2 * g / R0) by apply Rmin_r. assert (Hz3 : R0 * z <= 2 * g).
  { replace (2 * g) with (R0 * (2 * g / R0)) by (field; lra). apply Rmult_le_compat_l; lra. }
  assert (Hd3 : kap * d <= g / 2). { replace (g / 2) with (kap * (g / (2 * kap))) by (field; lra).
    apply Rmult_le_compat_l; lra. }
  destruct (contact m1 m2 0 a2 b Hm1 Hm2 Ha1 Ha2 Hb x v1 v2 s T H HT) as (tc & Htc & Ev).
  change (energy m1 m2 a2 (x T) (v1 T) (v2 T)) with (E T) in Htc.
  assert (Wc : w tc = 0) by (unfold w; lra). pose proof PI_RGT_0 as P0. assert (P1 : 0 < 2 * PI / om) by positive.
  assert (TW : tc + 2 * PI / om + tau <= T + W).
  { unfold W, spell. fold tau om. assert (2 * sqrt (2 * E T * m2) / b <= 2 * sqrt (2 * e * m2) / b); [|lra].
    apply Rmult_le_compat_r; [positive|]. apply Rmult_le_compat_l; [lra|]. apply sqrt_le_1_alt. nra. }
  assert (High : forall u, T <= u <= T + W -> l <= E u /\ E T - d < E u <= E T).
  { intros u Hu. pose proof (E_mono u (T + W) ltac:(lra)). pose proof (E_mono T u ltac:(lra)). lra. }
  pose proof (energy_turned m1 m2 a2 Hm1 Hm2 Ha2 x v1 v2 tc) as EAB. cbv beta in EAB. fold (E tc) (w tc) turned in EAB.
  rewrite Wc in EAB. pose proof (fun phi => turned_phase m1 m2 a2 x v1 v2 phi tc : turned phi tc = _) as Phase.
  fold turned in Phase. set (A := turned 0 tc) in *. set (B := turned (- (PI / 2)) tc) in *.
  set (R := sqrt (A ^ 2 + B ^ 2)).
  assert (Rsq : A ^ 2 + B ^ 2 = R ^ 2) by (symmetry; apply pow2_sqrt; positive).
  assert (HR : R0 <= R) by (apply sqrt_le_1_alt; undivide a2; destruct (High tc ltac:(lra)); lra).
  destruct (polar A B R om tc) as (ts & Hts & Cs & Ss); auto; [lra|].
  assert (Out : forall u, ts <= u < ts + tau -> LL + g <= x u).
  { intros u Hu. pose proof (paid (- (om * u)) tc u ltac:(lra)) as Qu.
    replace (turned (- (om * u)) u) with (x u) in Qu
      by (unfold turned, TurnedFrame.turned; fold om; rewrite Rplus_opp_r, cos_0, sin_0; ring).
    replace (turned (- (om * u)) tc) with (R * cos (om * (u - ts))) in Qu.
    2: { rewrite Phase, cos_neg, sin_neg. replace (om * (u - ts)) with (om * u - om * ts) by ring.
      rewrite <- Cs, <- Ss, cos_minus. ring. }
    destruct (High tc ltac:(lra)) as (_ & K1). destruct (High u ltac:(lra)) as (_ & K2).
    assert (KK : kap * (E tc - E u) <= g / 2). { apply Rle_trans with (kap * d); auto. scale. }
    assert (Zu : 0 <= om * (u - ts) <= z).
    { split; [apply Rmult_le_pos; lra|]. replace z with (om * tau) by (rewrite Ez; field; lra).
      apply Rmult_le_compat_l; lra. }
    pose proof (cos_below (om * (u - ts)) ltac:(lra)) as CB.
    set (q := cos (om * (u - ts))) in *. set (zu := om * (u - ts)) in *. assert (zu ^ 2 <= z).
    { apply Rle_trans with (zu * 1); [scale|lra]. }
    assert (Q : R0 - g <= R * q). { assert (R0 * (1 - z / 2) <= R * q) by (apply Rmult_le_compat; lra). lra. }
    apply Rabs_inv in Qu. lra. }
  pose proof (outside_costs ts tau g ltac:(lra) Htau Hg Out) as Cost. fold e0 in Cost.
  destruct (High ts ltac:(lra)) as (_ & K1). destruct (High (ts + tau) ltac:(lra)) as (_ & K2). lra.
Qed.

(** *** No level above E_cr is a limit *)

(** [energy-limit] The limit of the energy is at most $E_{cr}$. *)
Theorem limit_not_above l : (forall t, 0 <= t -> l <= E t) -> (forall e, 0 < e -> exists T, 0 <= T /\ forall t,
  T <= t -> E t <= l + e) ->
  l <= Ecr m1 m2 a2 b.
Proof.
  intros Hl Hlim. apply Rnot_lt_le. intros N. pose proof (toll_pos l N) as D.
  destruct (Hlim (toll l / 2)) as (T & HT & K); [lra|]. pose proof (spell_pos (E T) l N) as Sp.
  pose proof (Hl (T + spell (E T) l) ltac:(lra)) as High. pose proof (toll_paid (E T) l T N HT (Rle_refl _) High).
  specialize (K T ltac:(lra)). lra.
Qed.

(** *** The dichotomy, first form: E falls to a limit <= E_cr; once E <= E_cr the pair merges in bounded time. *)
Theorem dichotomy_energy : (exists T, 0 <= T /\ E T <= Ecr m1 m2 a2 b) \/
  ((forall t, 0 <= t -> Ecr m1 m2 a2 b < E t) /\ forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    E t <= Ecr m1 m2 a2 b + e).
Proof.
  destruct E_limit as (l & Hl0 & Hl & Hlim). pose proof (limit_not_above l Hl Hlim) as HL.
  destruct (Classical_Prop.classic (exists T, 0 <= T /\ E T <= Ecr m1 m2 a2 b)) as [|N]; [left; auto|right]. split.
  - intros t Ht. destruct (Rlt_dec (Ecr m1 m2 a2 b) (E t)); auto. exfalso; apply N; exists t; split; auto; lra.
  - intros e He. destruct (Hlim e He) as (T & HT & K). exists T; split; auto. intros t Hu. specialize (K t Hu). lra.
Qed.
End Limit.
