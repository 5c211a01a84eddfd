(** From an exit on slips and peaks fade: each slip is slower than the one before, at equal times after the exit, and so
    at its fastest, which is in closed form; the peaks of the velocity fall to that of the critical motion like 1/t. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle SlipFromGap ExitOrbit AfterOneSlip SharpRate
  SharpLaw OneOverT.

(** 2 sin^2 z (h - hh z) is at most 2 (h - atan h), its value at z = atan h *)
Lemma bulge z h : 0 <= h -> 0 < z <= PI / 2 -> 2 * sin z ^ 2 * (h - hh z) <= 2 * (h - atan h).
Proof.
  intros Hh Hz. set (a := atan h). pose proof (atan_bound h) as B. fold a in B.
  assert (A0 : 0 <= a) by (destruct Hh as [Hh|<-]; [apply Rlt_le; unfold a; rewrite <- atan_0; apply atan_increasing|
    unfold a; rewrite atan_0]; lra). assert (C : 0 < cos a) by (apply cos_gt_0; lra).
  pose proof (cos_ge_0 z ltac:(lra) ltac:(lra)) as Cz.
  assert (T : h * cos a = sin a) by (rewrite <- (tan_atan h) at 1; fold a; unfold tan; field; lra).
  pose proof (sin_gt_0 z ltac:(lra) ltac:(lra)) as S. apply Rmult_le_reg_r with (cos a); auto. apply Rminus_le_0.
  replace (_ - _) with (2 * (cos z * sin (a - z) - (a - z) * cos a)).
  2: { rewrite sin_minus, <- T. unfold hh. trig z. }
  destruct (Rle_dec z a) as [L|L].
  - pose proof (g_nonneg (a - z) ltac:(lra)) as G. assert (Ca : cos a <= cos z * cos (a - z)).
    { replace a with (z + (a - z)) at 1 by ring. rewrite cos_plus. pose proof (sin_pos (a - z) ltac:(lra)). nra. }
    assert ((a - z) * cos a <= (a - z) * (cos z * cos (a - z))) by nra.
    assert (cos z * ((a - z) * cos (a - z)) <= cos z * sin (a - z)) by nra. lra.
  - replace (a - z) with (- (z - a)) by ring. rewrite sin_neg. pose proof (sin_below (z - a) ltac:(lra)).
    assert (cos z <= cos a) by (apply cos_decr_1; lra). nra.
Qed.

(** From the time ta on the pair sticks until its first exit,
  and then slips and sticks in turn: it slips after the exits
    tau, and sticks from the entries te to the next exit. Each slip is slower than the one before at each time after its
    exit; none is faster than f. *)
Definition sticks_and_slips (ta f : R) (v1 v2 : R -> R) : Prop := exists te tau : nat -> R,
  ta <= tau 0%nat /\ (forall n, tau n < te n < tau (S n)) /\ is_lim_seq tau p_infty /\
  (forall t, ta <= t <= tau 0%nat -> v1 t = v2 t) /\ (forall n t, te n <= t <= tau (S n) -> v1 t = v2 t) /\
  (forall n t, tau n < t < te n -> v1 t <> v2 t) /\
  (forall n u, 0 < u < te (S n) - tau (S n) ->
    Rabs (v1 (tau (S n) + u) - v2 (tau (S n) + u)) < Rabs (v1 (tau n + u) - v2 (tau n + u))) /\
  forall t, ta <= t -> Rabs (v1 t - v2 t) <= f.

(** t (v - c) has the limit of t D, where D = (v^2 - c^2)/(2 c) *)
Lemma root_law (v : R -> R) c B : 0 < c -> 0 < B -> (forall t, 0 <= t -> c <= v t) ->
  is_lim (fun t => t * ((v t ^ 2 - c ^ 2) / (2 * c))) p_infty B -> is_lim (fun t => t * (v t - c)) p_infty B.
Proof.
  intros Hc HB Up Li. apply is_lim_spec. apply is_lim_spec in Li. intros eps. pose proof (cond_pos eps) as He.
  destruct (Li (mkposreal (eps / 2) ltac:(lra))) as (T & K').
  assert (K : forall t, T < t -> Rabs (t * ((v t ^ 2 - c ^ 2) / (2 * c)) - B) < eps / 2) by auto.
  exists (Rmax (Rmax T 1) ((B + eps) ^ 2 / (c * eps))). intros t Ht.
  pose proof (Rmax_l (Rmax T 1) ((B + eps) ^ 2 / (c * eps))).
  pose proof (Rmax_r (Rmax T 1) ((B + eps) ^ 2 / (c * eps))). pose proof (Rmax_l T 1). pose proof (Rmax_r T 1).
  specialize (K t ltac:(lra)). specialize (Up t ltac:(lra)). apply Rabs_def2 in K. set (d := v t - c) in *.
  assert (E : t * ((v t ^ 2 - c ^ 2) / (2 * c)) = t * d + t * d ^ 2 / (2 * c)) by (unfold d; field; lra).
  assert (Td : 0 <= t * d) by positive. assert (Sq : 0 <= t * d ^ 2 / (2 * c)) by positive.
  assert (t * d ^ 2 / (2 * c) <= eps / 2); [|apply Rabs_def1; lra]. undivide (2 * c).
  apply Rmult_le_reg_l with t; [lra|]. assert ((t * d) ^ 2 <= (B + eps) ^ 2) by (apply pow_incr; lra).
  assert (Q : (B + eps) ^ 2 / (c * eps) * (c * eps) <= t * (c * eps)) by scale.
  replace ((B + eps) ^ 2 / (c * eps) * (c * eps)) with ((B + eps) ^ 2) in Q by (field; lra). lra.
Qed.

Section Fading.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (o1 := o1 m1 a2) (om := omega m1 m2 a2) (L := L m1 m2 a2 b)
  (Ecr := Ecr m1 m2 a2 b) (Oo : 0 < o1 := o1_pos m1 a2 Hm1 Ha2)
  (Om : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2) (L0 : 0 < L := L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb)
  (Q0 : 0 < q := q_pos m1 m2 Hm1 Hm2) (E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb).

(** the fastest slip from a ray with the push h *)
Definition fastest h := b / (m2 * o1) * (2 * (h - atan h)).

Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Context (w := fun t => v1 t - v2 t) (E := fun t => energy m1 m2 a2 (x t) (v1 t) (v2 t)).

Section FromRay.
Variables k t0 p : R.
Hypotheses (Hk : k = 1 \/ k = -1) (Ht : 0 <= t0) (Hp : ok m1 m2 p) (HR : on_ray m1 m2 a2 b k (hh p) x v1 v2 t0).
Context (ph := orb m1 m2 p) (tm := tim m1 m2 a2 t0 p) (sl := fun n => 2 * ph n / o1)
  (side := fun n => k * (-1) ^ n).
Let P n : 0 < ph n < PI := ph_pi m1 m2 Hm1 Hm2 p Hp n.
Let T0 n : t0 <= tm n := tim_start m1 m2 a2 Hm1 Hm2 Ha2 t0 p n Hp.
Let Cy n := cycle_at m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hp HR n.
Let sides n : side n = 1 \/ side n = -1 := proj1 (Cy n).
(** on either the size is the same *)
Lemma side_abs n y : Rabs y = Rabs (side n * y).
Proof. rewrite Rabs_mult. destruct (sides n) as [->| ->]; [rewrite Rabs_R1|rewrite (Rabs_left (-1)) by lra]; ring. Qed.
(** the exits; a slip, and a stick until the next one *)
Lemma leaves n : on_ray m1 m2 a2 b (side n) (hh (ph n)) x v1 v2 (tm n). Proof. apply (Cy n). Qed.
Lemma lasts n : 0 < sl n /\ tm n + sl n < tm (S n). Proof. split; apply (Cy n). Qed.
Lemma slips n t : tm n < t < tm n + sl n -> side n * v1 t < side n * v2 t. Proof. apply (Cy n). Qed.
Lemma sticks n t : tm n + sl n <= t <= tm (S n) -> v1 t = v2 t /\ - L <= x t <= L. Proof. apply (Cy n). Qed.
(** the angles fall *)
Lemma angles_fall n : ph (S n) < ph n.
Proof.
  apply hh_sq; [apply P|apply P|].
  exact (ReturnMap.y_falls (m2 / (m1 + m2)) (r_pos m1 m2 Hm1 Hm2) ph P (y_step m1 m2 Hm1 Hm2 p Hp) n).
Qed.
Lemma angles_below n : ph n <= p.
Proof. exact (phi_0 (m2 / (m1 + m2)) (r_pos m1 m2 Hm1 Hm2) ph P (y_step m1 m2 Hm1 Hm2 p Hp) n). Qed.
(** body 1 in a slip, and where it ends *)
Lemma slip_motion n : side n * x (tm n + sl n) = L * (1 - q * depth (ph n)) /\ forall u, 0 <= u <= sl n ->
  side n * v1 (tm n + u) = b / (m2 * o1) * (hh (ph n) * cos (o1 * u) - sin (o1 * u)) /\
  (0 < u < sl n -> 0 < o1 * u / 2 < ph n /\ 0 < hh (ph n) - hh (o1 * u / 2) /\
    Rabs (w (tm n + u)) = b / (m2 * o1) * (2 * sin (o1 * u / 2) ^ 2 * (hh (ph n) - hh (o1 * u / 2)))).
Proof.
  pose proof (leaves n) as G. apply ray_gap in G. rewrite <- (push_0 (ph n)) in G. pose proof (T0 n).
    pose proof (P n) as Pn.
  destruct (gap_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb _ x v1 v2 s (tm n) 0 (ph n) (sides n) H ltac:(lra) (Rle_refl 0) Pn G)
    as (F & _ & X1 & _). rewrite Rplus_0_r in X1. split; [exact X1|]. intros u Hu. destruct (F u Hu) as (_ & A & B).
  split; [rewrite A; unfold G1; rewrite push_0; fold o1; ring|]. intros Hv. assert (Th : 0 < o1 * u < 2 * ph n).
  { split; [apply Rmult_lt_0_compat; lra|]. replace (2 * ph n) with (o1 * sl n) by (unfold sl; field; lra). scale. }
  split; [lra|]. pose proof (hh_incr (o1 * u / 2) (ph n) ltac:(lra) ltac:(lra) ltac:(lra)) as I. split; [lra|].
  pose proof (guard m1 m2 a2 b Hm1 Hm2 Ha2 0 (push 0 (ph n)) u ltac:(fold o1; lra)) as D. fold o1 in D.
  rewrite !push_0 in *. rewrite (side_abs n). unfold w. rewrite Rmult_minus_distr_l, A, B, D.
  rewrite Rabs_left1; [ring|].
  assert (0 <= b / (m2 * o1) * (2 * sin (o1 * u / 2) ^ 2) * (hh (ph n) - hh (o1 * u / 2))) by positive. lra.
Qed.

(** The exits tau and the entries te: the slips after the exits fade; none is faster than the first can be. *)
Lemma slips_fade : exists te tau : nat -> R, tau 0%nat = t0 /\ (forall n, tau n < te n < tau (S n)) /\
  is_lim_seq tau p_infty /\
  (forall n t, te n <= t <= tau (S n) -> v1 t = v2 t) /\ (forall n t, tau n < t < te n -> v1 t <> v2 t) /\
  (forall n u, 0 < u < te (S n) - tau (S n) ->
    Rabs (v1 (tau (S n) + u) - v2 (tau (S n) + u)) < Rabs (v1 (tau n + u) - v2 (tau n + u))) /\
  forall t, t0 <= t -> Rabs (v1 t - v2 t) <= fastest (hh p).
Proof.
  pose proof (P 0%nat) as P0. change (ph 0%nat) with p in P0. pose proof (hh_pos p P0) as Hh.
  assert (C0 : 0 < b / (m2 * o1)) by positive. assert (Ss : forall n, sl (S n) < sl n).
  { intros n. apply Rmult_lt_compat_r; [positive|]. pose proof (angles_fall n). lra. }
  exists (fun n => tm n + sl n), tm. split; [reflexivity|]. split; [intros n; pose proof (lasts n); lra|].
  split; [exact (tm_inf m1 m2 a2 Hm1 Hm2 Ha2 t0 p Hp)|]. split; [intros n t Hu; apply (sticks n t Hu)|].
  split; [intros n t Hu Eq; pose proof (slips n t Hu) as Q; rewrite Eq in Q; lra|].
  split.
  - intros n u Hu. assert (Hu' : 0 < u < sl (S n)) by lra. pose proof (Ss n). pose proof (P (S n)).
    destruct (proj2 (proj2 (slip_motion (S n)) u ltac:(lra)) Hu') as (Z & D & A).
    destruct (proj2 (proj2 (slip_motion n) u ltac:(lra)) ltac:(lra)) as (_ & _ & B).
    fold (w (tm (S n) + u)) (w (tm n + u)). rewrite A, B. apply Rmult_lt_compat_l; auto.
    pose proof (pow_lt _ 2 (sin_gt_0 (o1 * u / 2) ltac:(lra) ltac:(lra))). apply Rmult_lt_compat_l; [lra|].
    pose proof (hh_incr (ph (S n)) (ph n) ltac:(lra) (angles_fall n) (proj2 (P n))). lra.
  - assert (F1 : 0 <= fastest (hh p)).
    { pose proof (bulge (p / 2) (hh p) ltac:(lra) ltac:(lra)) as I.
      pose proof (hh_incr (p / 2) p ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (pow2_ge_0 (sin (p / 2))).
      apply Rmult_le_pos; [lra|]. apply Rle_trans with (2 := I). apply Rmult_le_pos; lra. }
    intros t Hu. destruct (in_cycle m1 m2 a2 Hm1 Hm2 Ha2 t0 p Hp 0%nat t Hu) as (n & _ & Ha & Hc). fold tm in Ha, Hc.
    fold (w t). replace t with (tm n + (t - tm n)) by ring. set (u := t - tm n) in *. destruct (Rle_dec u 0) as [Z|Z].
    { replace u with 0 by (unfold u in *; lra). rewrite Rplus_0_r. destruct (leaves n) as (_ & A & B). unfold w.
      replace (v1 (tm n) - v2 (tm n)) with 0 by (destruct (sides n) as [Es|Es]; rewrite Es in A, B; lra).
        rewrite Rabs_R0. auto. } destruct (Rlt_dec u (sl n)) as [I|I].
    + destruct (proj2 (proj2 (slip_motion n) u ltac:(lra)) ltac:(lra)) as (Z' & D & A). rewrite A.
      apply Rmult_le_compat_l; [lra|]. apply Rle_trans with (2 * sin (o1 * u / 2) ^ 2 * (hh p - hh (o1 * u / 2)));
        [|pose proof (proj2 (proj1 (orb_ok m1 m2 Hm1 Hm2 p n Hp))) as Pn2; fold (ph n) in Pn2; apply bulge; lra].
      apply Rmult_le_compat_l; [pose proof (pow2_ge_0 (sin (o1 * u / 2))); lra|].
      destruct (Req_dec (ph n) p) as [->|]; [lra|]. pose proof (angles_below n).
      pose proof (hh_incr (ph n) p ltac:(lra) ltac:(lra) ltac:(lra)). lra.
    + destruct (sticks n (tm n + u) ltac:(unfold u in *; lra)) as (Eq & _). unfold w.
        rewrite Eq, Rminus_diag_eq, Rabs_R0; auto.
Qed.

(** *** Peaks *)
Lemma stick_level n t : tm n + sl n <= t <= tm (S n) -> E t = Ecr * (1 + q * hh (ph (S n)) ^ 2).
Proof.
  intros Hu. pose proof (T0 n) as Tn. pose proof (lasts n) as Sn. destruct (merges_at_first_landing m1 m2 a2 b Hm1 Hm2
    Ha2 Hb x v1 v2 s H _ (tm n) (ph n) (sides n) ltac:(lra) (P n) (leaves n)) as (_ & _ & _ & E1 & _). fold o1 in E1.
  fold (sl n) q in E1. pose proof (y_step m1 m2 Hm1 Hm2 p Hp n) as En. fold ph in En.
  pose proof (ray_energy m1 m2 a2 b Hm1 Hm2 Ha2 _ _ x v1 v2 _ (sides (S n)) (leaves (S n))) as E2.
  pose proof (E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H (tm n + sl n) t ltac:(lra)) as F1.
  pose proof (E_falls m1 m2 a2 b Hm1 Hm2 Hb x v1 v2 s H t (tm (S n)) ltac:(lra)) as F2. cbv beta in F1, F2.
  unfold E. fold Ecr in E1, E2. fold q in E2. rewrite En in *. lra.
Qed.
(** the speed at the rest position at the level of the time, and its law *)
Let pk t := sqrt (2 * E t / (m1 + m2)).
Lemma peak_law : (forall t, 0 <= t -> Ecr < E t) ->
  is_lim (fun t => t * (pk t - L * om)) p_infty (L * om * rate m1 m2 a2 / 2).
Proof.
  intros Up. assert (Pk : forall t, pk t ^ 2 = 2 * E t / (m1 + m2)).
  { intros t. pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x t) (v1 t) (v2 t)) as Q.
    apply pow2_sqrt. positive. } assert (LO : (L * om) ^ 2 = 2 * Ecr / (m1 + m2)).
  { unfold Ecr. rewrite Ecr_L by auto. fold L. rewrite Rpow_mult_distr. replace (om ^ 2) with (om * om) by ring.
    unfold om. rewrite omega_sq by auto. lra. }
  assert (R0 : 0 < rate m1 m2 a2) by (unfold rate; pose proof PI_RGT_0; positive).
    apply root_law; [positive|positive| |].
  - intros t Hu. apply Rsqr_incr_0_var; [|unfold pk; positive]. rewrite !Rsqr_pow2, LO, Pk.
    apply Rmult_le_compat_r; [positive|]. pose proof (Up t Hu). lra.
  - pose proof (sharp_law m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H Up) as Sh.
    apply is_lim_ext_loc with (fun t => / ((m1 + m2) * (L * om)) * (t * (E t - Ecr))).
    + exists 0. intros t Hu. rewrite LO, Pk. field. repeat split; lra.
    + replace (Finite (L * om * rate m1 m2 a2 / 2)) with (Rbar_mult (/ ((m1 + m2) * (L * om))) (Ecr * rate m1 m2 a2)).
      { apply is_lim_scal_l. exact Sh. }
      simpl. f_equal. replace Ecr with ((m1 + m2) * (L * om) ^ 2 / 2) by (rewrite LO; field; lra). field.
      repeat split; lra.
Qed.

(** so it is for the largest speeds of late cycles *)
Lemma peaks_from_ray e : (forall t, 0 <= t -> Ecr < E t) -> 0 < e -> exists N, forall n, (N <= n)%nat ->
  exists t, tm n + sl n <= t <= tm (S n) /\ x t = 0 /\ (forall u,
    tm n + sl n <= u <= tm (S n) + sl (S n) -> Rabs (v1 u) <= Rabs (v1 t)) /\
    Rabs (t * (Rabs (v1 t) - L * om) - L * om * rate m1 m2 a2 / 2) <= e.
Proof.
  intros Up He. assert (Law := peak_law Up). apply is_lim_spec in Law. destruct (Law (mkposreal e He)) as (T & LT).
  assert (K1 := tm_inf m1 m2 a2 Hm1 Hm2 Ha2 t0 p Hp). apply is_lim_seq_spec in K1. destruct (K1 T) as (N1 & Q1').
  assert (K2 := level_to_zero m1 m2 Hm1 Hm2 p Hp). apply is_lim_seq_spec in K2.
  destruct (K2 (mkposreal (1 / 2) ltac:(lra))) as (N2 & Q2'). exists (Nat.max N1 N2). intros n Hn.
  specialize (Q1' n ltac:(lia)). specialize (Q2' n ltac:(lia)). change (T < tm n) in Q1'.
  change (Rabs (hh (ph n) ^ 2 - 0) < 1 / 2) in Q2'. apply Rabs_def2 in Q2'. pose proof (depth_upper _ (P n)) as D.
  destruct (slip_motion n) as (Xs & _). assert (Q1 : q <= 1) by (unfold q; undivide (m1 + m2); lra).
  pose proof (T0 n). pose proof (lasts n) as Sn. destruct (leaves (S n)) as (Xe & _). fold L in Xe.
  assert (KK : side (S n) = - side n) by (unfold side; simpl; ring). rewrite KK in Xe.
  destruct (cont_IVT (fun t => side n * x t) (tm n + sl n) (tm (S n))) as (t & Hu & Z).
  { apply cont_scal, (s_cx _ _ _ _ _ _ _ _ _ H). }
  { lra. }
  { replace (side n * x (tm (S n))) with (- L) by lra. assert (0 < 1 - q * depth (ph n)) by nra. nra. }
  assert (Xt : x t = 0) by (destruct (sides n) as [Ek|Ek]; rewrite Ek in Z; lra). destruct (sticks n t Hu) as (Ev & _).
  assert (Et : E t = (m1 + m2) * v1 t ^ 2 / 2) by (unfold E, energy; rewrite Xt, <- Ev; field).
  assert (Vt : Rabs (v1 t) = pk t).
  { unfold pk. rewrite Et. replace (2 * ((m1 + m2) * v1 t ^ 2 / 2) / (m1 + m2)) with (Rsqr (v1 t)) by (unfold Rsqr;
      field; lra). symmetry. apply sqrt_Rsqr_abs. } exists t. split; [auto|]. split; [auto|]. split.
  + intros u Hv. apply Rsqr_le_abs_0. rewrite !Rsqr_pow2. apply Rmult_le_reg_l with (m1 + m2); [lra|].
    replace ((m1 + m2) * v1 t ^ 2) with (2 * E t) by (rewrite Et; field). rewrite (stick_level n t Hu).
    destruct (Rle_dec u (tm (S n))) as [I|I].
    * rewrite <- (stick_level n u ltac:(lra)). destruct (sticks n u ltac:(lra)) as (Eu & _). unfold E, energy.
        rewrite <- Eu. assert (0 <= a2 * x u ^ 2) by positive. lra.
    * destruct (slip_motion (S n)) as (_ & V). destruct (V (u - tm (S n)) ltac:(lra)) as (V' & _).
        replace (tm (S n) + (u - tm (S n))) with u in V' by ring.
      assert (V2 : v1 u ^ 2 = (side (S n) * v1 u) ^ 2) by (destruct (sides (S n)) as [-> | ->]; ring). rewrite V2, V'.
      set (h := hh (ph (S n))). set (th := o1 * (u - tm (S n))). pose proof (sin2_cos2 th) as SC. unfold Rsqr in SC.
      assert (C2 : (m1 + m2) * (b / (m2 * o1)) ^ 2 = 2 * Ecr * q).
      { assert (Q : a2 = m1 * (o1 * o1)) by (apply o1_sq; auto). unfold Ecr, Stick.Ecr, q. rewrite Q at 1. field.
        repeat split; lra. } rewrite Rpow_mult_distr, <- Rmult_assoc, C2.
      assert (I2 : (h * cos th - sin th) ^ 2 <= h ^ 2 + 1).
      { replace (h ^ 2 + 1) with ((h ^ 2 + 1) * (sin th * sin th + cos th * cos th)) by (rewrite SC; ring).
        pose proof (pow2_ge_0 (h * sin th + cos th)). nra. }
      apply Rle_trans with (2 * Ecr * q * (h ^ 2 + 1)); [apply Rmult_le_compat_l; [positive|auto]|]. nra.
  + rewrite Vt. apply Rlt_le. exact (LT t ltac:(lra)).
Qed.
End FromRay.

(** From an entry into S0 above E_cr, with the push h up to pi/2 and (16/pi^2) m2/(m1 + m2) below 1,
  as where m2 <= m1. *)
Theorem fades ta : 0 <= ta -> v1 ta = v2 ta -> - L <= x ta <= L -> 16 * (m2 / (m1 + m2)) < PI ^ 2 ->
  let e := energy m1 m2 a2 (x ta) (v1 ta) (v2 ta) in let h := sqrt ((e / Ecr - 1) / q) in
  Ecr < e -> h <= PI / 2 -> sticks_and_slips ta (fastest h) v1 v2 /\
    forall t, 0 <= t -> Ecr < energy m1 m2 a2 (x t) (v1 t) (v2 t).
Proof.
  intros Ht Ev Hx Hr e h He Hh. destruct (level_push m1 m2 a2 b Hm1 Hm2 Ha2 Hb e He) as (H0 & Ee).
  destruct (half_spec h H0) as (Hp & Ep). set (p := half h) in *.
  assert (Pp : p <= PI / 2) by (apply hh_le; [lra|lra|rewrite Ep, hh_half_pi; lra]). assert (Ok : ok m1 m2 p).
  { split; [lra|]. apply (stays_above _ p (PI / 2)); [lra|lra|lra|]. rewrite hh_half_pi. unfold depth.
    rewrite sin_PI2, cos_PI2. lra. }
  destruct (to_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H ta h Ht Ev Hx H0 Ee) as (k & t0 & Hk & T0 & HR & St).
  rewrite <- Ep in HR. destruct (slips_fade k t0 p Hk ltac:(lra) Ok HR)
    as (te & tau & Z & Or & Li & Sk & Sl & Sp & Fa).
  split; [|exact (never_merges m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk ltac:(lra) Ok HR)]. exists te, tau.
  rewrite <- Ep. split; [lra|]. split; [auto|]. split; [auto|]. split; [intros r Hr'; apply St; lra|].
  split; [exact Sk|]. split; [exact Sl|]. split; [auto|]. intros r Hr'. destruct (Rle_dec t0 r); [apply Fa; auto|].
  destruct (St r ltac:(lra)) as (Eq & _). rewrite Eq, Rminus_diag_eq, Rabs_R0 by auto.
  apply Rle_trans with (2 := Fa t0 (Rle_refl t0)). apply Rabs_pos.
Qed.

(** [peaks-fall] Where a motion never merges, the peaks of $|v_1|$ between entries tend to $L\Omega$ like $1/t$: at
    late entries each is at $x_1=0$, in stick, and
    $t\,(|v_1|-L\Omega)\to\frac12L\Omega\cdot\frac{4\pi}{9}\frac{m_1}{m_2}\sqrt{M/a_2}$. *)
Theorem peaks_fall : (forall t, 0 <= t -> Ecr < E t) -> exists te tau : nat -> R, is_lim_seq te p_infty /\
  (forall n, 0 <= te n /\ te n < tau n < te (S n)) /\ (forall n t, te n <= t <= tau n -> v1 t = v2 t) /\
  (forall n t, tau n < t < te (S n) -> v1 t <> v2 t) /\ forall e, 0 < e -> exists N, forall n, (N <= n)%nat ->
    exists t, te n <= t <= tau n /\ x t = 0 /\ (forall u, te n <= u <= te (S n) -> Rabs (v1 u) <= Rabs (v1 t)) /\
      Rabs (t * (Rabs (v1 t) - L * om) - L * om * rate m1 m2 a2 / 2) <= e.
Proof.
  intros Up. destruct (reaches_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H Up) as (k & t0 & p & Hk & Ht & Hp & HR).
  set (te := fun n => tim m1 m2 a2 t0 p n + 2 * orb m1 m2 p n / o1).
  exists te, (fun n => tim m1 m2 a2 t0 p (S n)). pose proof (lasts k t0 p Hk Ht Hp HR) as La.
  split; [|split; [|split; [|split]]].
  - apply is_lim_seq_le_p_loc with (2 := tm_inf m1 m2 a2 Hm1 Hm2 Ha2 t0 p Hp). exists 0%nat. intros n _.
      pose proof (La n). unfold te. lra.
  - intros n. pose proof (tim_start m1 m2 a2 Hm1 Hm2 Ha2 t0 p n Hp). pose proof (La n). pose proof (La (S n)).
      unfold te. lra.
  - intros n t Hu. apply (sticks k t0 p Hk Ht Hp HR n t Hu).
  - intros n t Hu Eq. pose proof (slips k t0 p Hk Ht Hp HR (S n) t Hu) as Q. rewrite Eq in Q. lra.
  - intros e He. exact (peaks_from_ray k t0 p Hk Ht Hp HR e Up He).
Qed.
End Fading.
