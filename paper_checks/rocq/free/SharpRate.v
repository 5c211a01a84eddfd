(** From one exit on: E > E_cr for ever, the exits obey the return map, and t (E - E_cr) tends to the sharp constant. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle ExitOrbit.

(** the inverse of a root *)
Lemma root_inv M a : 0 < M -> 0 < a -> / sqrt (a / M) = sqrt (M / a).
Proof.
  intros HM Ha. assert (P : 0 < sqrt (a / M)) by positive.
  apply Rmult_eq_reg_r with (sqrt (a / M)); [|lra]. rewrite Rinv_l by lra.
    rewrite <- sqrt_mult_alt by positive.
  replace (M / a * (a / M)) with 1 by (field; lra). rewrite sqrt_1; auto.
Qed.

Section Sharp.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Context (M := m1 + m2) (q := m1 / M) (r := m2 / M) (om := omega m1 m2 a2) (Ecr := Ecr m1 m2 a2 b)
  (E := fun t => energy m1 m2 a2 (x t) (v1 t) (v2 t)).
(** the sharp constant *)
Definition rate := 4 * PI / 9 * (m1 / m2) * sqrt ((m1 + m2) / a2).

Context (q_pos : 0 < q := q_pos m1 m2 Hm1 Hm2) (r_pos : 0 < r := r_pos m1 m2 Hm1 Hm2)
  (om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2).
Lemma Ecr_pos : 0 < Ecr.
Proof. unfold Ecr. rewrite Ecr_L by auto. pose proof (pow_lt _ 2 (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb)). nra. Qed.
(** the push of a level above E_cr *)
Lemma level_push e : Ecr < e -> let u := sqrt ((e / Ecr - 1) / q) in 0 < u /\ e = Ecr * (1 + q * u ^ 2).
Proof.
  intros He u. pose proof Ecr_pos. assert (1 < e / Ecr) by (undivide Ecr; lra).
  assert (D : 0 < (e / Ecr - 1) / q) by (apply Rdiv_lt_0_compat; [lra|auto]). split; [apply sqrt_lt_R0; auto|].
  unfold u. rewrite pow2_sqrt by lra. field. split; lra.
Qed.
Lemma E_falls u t : 0 <= u <= t -> E t <= E u.
Proof. exact (energy_decreases m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb x v1 v2 s H u t). Qed.

Section FromRay.
Variables k t0 p : R.
Hypotheses (Hk : k = 1 \/ k = -1) (Ht : 0 <= t0) (Hp : ok m1 m2 p) (HR : on_ray m1 m2 a2 b k (hh p) x v1 v2 t0).
Context (ph := orb m1 m2 p) (y := fun n => hh (ph n) ^ 2) (tm := tim m1 m2 a2 t0 p)
  (cy := fun n => cyc m1 m2 a2 (ph n)).

(** every half angle of the orbit is one of short excursions above E_cr *)
Lemma ph_ok n : ok m1 m2 (ph n). Proof. apply orb_ok; auto. Qed.
Lemma ph_pi n : 0 < ph n < PI. Proof. exact (ok_pi m1 m2 _ (ph_ok n)). Qed.
(** the return map *)
Lemma y_step n : y (S n) = y n - r * depth (ph n) ^ 2.
Proof. exact (proj2 (next_ok m1 m2 Hm1 Hm2 (ph n) (ph_ok n))). Qed.
(** one cycle more *)
Lemma tm_S n : tm (S n) = tm n + cy n. Proof. reflexivity. Qed.
(** the exit times do not decrease *)
Lemma tm_up n : tm n <= tm (S n). Proof. apply tim_mono; auto. Qed.
Lemma tm_from n : t0 <= tm n. Proof. apply tim_start; auto. Qed.
(** the energy at the exits *)
Lemma exit_level n : E (tm n) = Ecr * (1 + q * y n).
Proof. exact (exit_energy m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 p Hk H Ht Hp HR n). Qed.
Lemma y_plus n : 0 < y n. Proof. apply pow_lt, hh_pos, ph_pi. Qed.
(** a slip, and a stick in S0 until the next one *)
Lemma cycle_at n : let sl := 2 * ph n / o1 m1 a2 in let k' := k * (-1) ^ n in (k' = 1 \/ k' = -1) /\
  on_ray m1 m2 a2 b k' (hh (ph n)) x v1 v2 (tm n) /\ 0 < sl /\ tm n + sl < tm (S n) /\
  (forall t, tm n < t < tm n + sl -> k' * v1 t < k' * v2 t) /\
  (forall t, tm n + sl <= t <= tm (S n) -> v1 t = v2 t /\ - L m1 m2 a2 b <= x t <= L m1 m2 a2 b).
Proof.
  intros sl k'. pose proof (sides k n Hk) as Sk. pose proof (tm_from n) as T0. pose proof (ph_ok n) as Ok.
  pose proof (exits m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 p Hk H Ht Hp HR n : on_ray m1 m2 a2 b k' _ x v1
    v2 _) as On.
  destruct (cycle m1 m2 a2 b Hm1 Hm2 Ha2 Hb k' x v1 v2 s (tm n) (ph n) Sk H ltac:(lra) Ok On) as (_ & _ & Sl &
    St).
  pose proof (cyc_long m1 m2 a2 Hm1 Hm2 Ha2 (ph n) Ok) as Lo. rewrite tm_S. unfold cy. fold sl in Sl, St, Lo.
  repeat (split; [auto; lra|]). split; intros t Hu; replace t with (tm n + (t - tm n)) by ring; [apply
    Sl|apply St]; lra.
Qed.

(** they tend to 0 *)
Theorem level_to_zero : is_lim_seq y 0. Proof. exact (y_to_zero r r_pos ph ph_pi y_step). Qed.
(** at the rate of the return map *)
Theorem level_rate : is_lim_seq (fun n => INR n * y n) (4 / (9 * r)). Proof.
  exact (ReturnMap.sharp r r_pos ph ph_pi y_step). Qed.

(** cycle times *)
Theorem cycle_limit : is_lim_seq (fun n => tm (S n) - tm n) (PI / om).
Proof.
  apply is_lim_seq_ext with cy. { intros n. rewrite tm_S. ring. }
  apply lim_within with (2 := root_to_zero r r_pos ph ph_pi y_step (6 * sqrt q / om)). intros n.
  pose proof (cycle_time m1 m2 a2 Hm1 Hm2 Ha2 (ph n) (ph_ok n)) as Q. fold M in Q. fold q om (cy n) in Q.
  rewrite sqrt_pow2 by (apply Rlt_le, hh_pos, ph_pi). assert (0 < / om) by positive.
  replace (cy n - PI / om) with ((om * cy n - PI) * / om) by (field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ om)) by lra.
  replace (6 * sqrt q / om * hh (ph n)) with (6 * sqrt q * hh (ph n) * / om) by (field; lra).
  apply Rmult_le_compat_r; [lra|exact Q].
Qed.
(** the cycle time tends to pi/Omega *)
Lemma cy_limit : is_lim_seq cy (PI / om).
Proof. apply is_lim_seq_ext with (fun n => tm (S n) - tm n); [|apply cycle_limit]. intros n. rewrite tm_S. ring. Qed.

(** the slips get short, the sticks tend to a half period: the sequence of times of Section III *)
Theorem slip_time : is_lim_seq (fun n => 2 * ph n / o1 m1 a2) 0.
Proof.
  pose proof (o1_pos m1 a2 Hm1 Ha2). apply is_lim_seq_ext with (fun n => 2 / o1 m1 a2 * ph n). { intros n; field; lra. }
  replace (Finite 0) with (Rbar_mult (2 / o1 m1 a2) 0) by (simpl; f_equal; ring).
  apply is_lim_seq_scal_l. exact (phi_to_zero r r_pos ph ph_pi y_step).
Qed.
(** so the stick tends to pi/Omega *)
Theorem stick_time : is_lim_seq (fun n => tm (S n) - (tm n + 2 * ph n / o1 m1 a2)) (PI / om).
Proof.
  apply is_lim_seq_ext with (fun n => tm (S n) - tm n - 2 * ph n / o1 m1 a2). { intros n; ring. }
  replace (Finite (PI / om)) with (Finite (PI / om - 0)) by (f_equal; ring).
    apply is_lim_seq_minus'; [apply cycle_limit|apply slip_time].
Qed.

(** so the n-th exit time over n tends to pi/Omega *)
Theorem time_rate : is_lim_seq (fun n => tm n / INR n) (PI / om).
Proof. exact (steps_mean tm (PI / om) cycle_limit). Qed.
Lemma tm_inf : is_lim_seq tm p_infty.
Proof.
  apply is_lim_seq_ext_loc with (fun n => INR n * (tm n / INR n)).
  { exists 1%nat. intros n Hn. field. apply not_0_INR. lia. }
  apply is_lim_seq_mult with p_infty (PI / om); [apply is_lim_seq_INR|apply time_rate|]. apply is_Rbar_mult_p_infty_pos.
  apply Rdiv_lt_0_compat; auto. apply PI_RGT_0.
Qed.
Lemma tm_above B : exists n, B < tm n.
Proof. pose proof tm_inf as T. apply is_lim_seq_spec in T. destruct (T B) as (n & K). exists n. apply K; auto. Qed.

(** *** No merging: E > E_cr at every time *)

(** [never-merges] From an exit ray with slip angle up to $\pi$ and $r\,c^2<h^2$ the energy stays above $E_{cr}$ at
    all later times. *)
Theorem never_merges t : 0 <= t -> Ecr < E t.
Proof.
  intros Hu. destruct (tm_above t) as (n & Hn). pose proof (E_falls t (tm n) ltac:(lra)) as F. rewrite exit_level in F.
  pose proof Ecr_pos. pose proof (y_plus n).
    assert (0 < Ecr * (q * y n)) by positive. lra.
Qed.

(** every later time lies in some cycle *)
Lemma in_cycle N t : tm N <= t -> exists n, (N <= n)%nat /\ tm n <= t <= tm (S n).
Proof.
  intros HN. assert (Or : forall j, (exists n, (N <= n)%nat /\ tm n <= t <= tm (S n)) \/ tm (N + j) <= t).
  { induction j as [|j [E'|L]]; [right; rewrite Nat.add_0_r; auto|auto|]. rewrite Nat.add_succ_r.
    destruct (Rle_dec (tm (S (N + j))) t); [auto|left; exists (N + j)%nat; split; [lia|lra]]. }
  pose proof tm_inf as T. apply is_lim_seq_spec in T. destruct (T t) as (n & K).
  specialize (K (N + n)%nat ltac:(lia)). destruct (Or n); [auto|lra].
Qed.

(** *** The sharp law in the time *)
Theorem sharp_from_ray : is_lim (fun t => t * (E t - Ecr)) p_infty (Ecr * rate).
Proof.
  pose proof Ecr_pos as E0. set (F n := Ecr * q * y n). assert (C0 : 0 < Ecr * q) by positive.
  assert (Fp : forall n, 0 < F n /\ E (tm n) - Ecr = F n).
  { intros n. pose proof (y_plus n). rewrite exit_level. unfold F. split; [positive|ring]. }
  assert (F0 : is_lim_seq F 0).
  { replace (Finite 0) with (Rbar_mult (Ecr * q) 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l, level_to_zero. }
  assert (G : is_lim_seq (fun n => tm n * F n) (Ecr * rate)).
  { replace (Ecr * rate) with (PI / om * (Ecr * q * (4 / (9 * r)))).
    2: { unfold rate. rewrite <- root_inv by lra. fold M. change (sqrt (a2 / M)) with om. unfold q, r.
      assert (0 < M) by positive. field. repeat split; lra. }
    apply is_lim_seq_ext_loc with (fun n => tm n / INR n * (Ecr * q * (INR n * y n))).
    { exists 1%nat. intros n Hn. unfold F. field. apply not_0_INR. lia. }
    apply is_lim_seq_mult'; [apply time_rate|apply (is_lim_seq_scal_l _ (Ecr * q) (4 / (9 * r))), level_rate]. }
  assert (Up : is_lim_seq (fun n => tm (S n) * F n) (Ecr * rate)).
  { apply is_lim_seq_ext with (fun n => tm n * F n + cy n * F n). { intros n. rewrite tm_S. ring. }
    replace (Ecr * rate) with (Ecr * rate + PI / om * 0) by ring. apply is_lim_seq_plus'; auto.
    apply is_lim_seq_mult'; [apply cy_limit|auto]. }
  assert (Lo : is_lim_seq (fun n => tm n * F (S n)) (Ecr * rate)).
  { apply is_lim_seq_ext with (fun n => tm (S n) * F (S n) - cy n * F (S n)). { intros n. rewrite tm_S. ring. }
    replace (Ecr * rate) with (Ecr * rate - PI / om * 0) by ring.
    apply is_lim_seq_minus'; [apply (is_lim_seq_incr_1 (fun n => tm n * F n)); auto|].
    apply is_lim_seq_mult'; [apply cy_limit|apply (is_lim_seq_incr_1 F); auto]. }
  apply is_lim_spec. intros eps. apply is_lim_seq_spec in Up. apply is_lim_seq_spec in Lo.
  destruct (Up eps) as (N1 & K1). destruct (Lo eps) as (N2 & K2). exists (tm (Nat.max N1 N2)). intros t Hlt.
  destruct (in_cycle (Nat.max N1 N2) t ltac:(lra)) as (n & Hn & Hb1 & Hb2). specialize (K1 n ltac:(lia)).
  specialize (K2 n ltac:(lia)). pose proof (tm_from n) as T0. pose proof (E_falls (tm n) t ltac:(lra)) as F1.
  pose proof (E_falls t (tm (S n)) ltac:(lra)) as F2. destruct (Fp n) as (P1 & Q1), (Fp (S n)) as (P2 & Q2).
  apply Rabs_def2 in K1. apply Rabs_def2 in K2. assert (t * (E t - Ecr) <= t * F n) by scale.
  assert (t * F n <= tm (S n) * F n) by scale. assert (t * F (S n) <= t * (E t - Ecr)) by scale.
  assert (tm n * F (S n) <= t * F (S n)) by scale. apply Rabs_def1; lra.
Qed.
(** *** Bounds in the time, from the exit at t0: by what 1/y gains in a cycle, and by how long a cycle takes *)
Theorem between a A Tl Tu t : 0 <= a -> 0 <= A -> 0 < Tl -> (forall n, a <= / y (S n) - / y n <= A) ->
  (forall n, Tl <= om * cy n <= Tu) -> t0 <= t ->
  / y 0 + a * (om * (t - t0) / Tu - 1) <= / ((E t / Ecr - 1) / q) <= / y 0 + A * (om * (t - t0) / Tl + 1).
Proof.
  intros Ha HA HTl Gain Time Hu. destruct (in_cycle 0 t Hu) as (n & _ & B1 & B2). pose proof Ecr_pos as E0.
  pose proof (y_plus (S n)) as Y1. pose proof (tm_from n) as T0. pose proof (E_falls (tm n) t ltac:(lra)) as F1.
  pose proof (E_falls t (tm (S n)) ltac:(lra)) as F2. rewrite exit_level in F1, F2.
  set (yt := (E t / Ecr - 1) / q). assert (EY : E t = Ecr * (1 + q * yt)) by (unfold yt; field; lra).
  rewrite EY in F1, F2. apply Rmult_le_reg_l in F1; auto. apply Rmult_le_reg_l in F2; auto.
  assert (G1 : yt <= y n) by (apply Rmult_le_reg_l with q; [auto|lra]).
  assert (G2 : y (S n) <= yt) by (apply Rmult_le_reg_l with q; [auto|lra]).
  assert (I1 : / y n <= / yt) by (apply Rinv_le_contravar; lra).
  assert (I2 : / yt <= / y (S n)) by (apply Rinv_le_contravar; lra).
  pose proof (steps_between (fun n => / y n) a A Gain) as Ga.
  pose proof (steps_between (fun n => om * tm n) Tl Tu) as Ti.
  specialize (Ti ltac:(intros i; cbv beta; rewrite tm_S; specialize (Time i); lra)). pose proof (Ga n).
  pose proof (Ti n). specialize (Ga (S n)). specialize (Ti (S n)). cbv beta in *. change (tm 0) with t0 in *.
  rewrite S_INR in *. pose proof (Time 0%nat).
  assert (om * tm n <= om * t <= om * tm (S n)) by (split; scale).
  assert (om * (t - t0) / Tu <= INR n + 1) by (undivide Tu; lra).
  assert (INR n <= om * (t - t0) / Tl) by (undivide Tl; lra).
  assert (a * (om * (t - t0) / Tu - 1) <= a * INR n) by scale.
  assert (A * (INR n + 1) <= A * (om * (t - t0) / Tl + 1)) by scale. lra.
Qed.
Lemma push_below n : hh (ph n) <= hh p.
Proof.
  apply (rising_le PI); [exact hh_incr|apply ph_pi|exact (phi_0 r r_pos ph ph_pi y_step n)|exact (proj2 (ph_pi
    0))].
Qed.
End FromRay.
End Sharp.
