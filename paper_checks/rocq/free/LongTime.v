(** The 1/t law up to tau^(-3/2): along the exits of a motion that never merges w = C/tau (1 - (pi B ln(al tau/pi) + K)/tau +
    O(tau^(-3/2))), given bounds of one cycle as in `LawWithError.v`. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle ExitOrbit SharpRate SharpLaw RateBounds
  CycleLength LawWithError.

(** a logarithm near 1, and of a fourth power *)
Lemma ln_near x : / 2 <= x -> Rabs (ln x) <= 2 * Rabs (x - 1).
Proof.
  intros Hx. pose proof (exp_ineq1_le (ln x)) as U. rewrite exp_ln in U by lra. pose proof (exp_ineq1_le (ln (/ x))) as L.
  rewrite exp_ln in L by positive. rewrite ln_Rinv in L by lra.
  assert (I : / x - 1 = (1 - x) * / x) by (field; lra). assert (0 < / x <= 2) by (split; [positive|rewrite <- (Rinv_inv 2); apply Rinv_le_contravar; lra]).
  apply Rabs_le. unfold Rabs. destruct Rcase_abs; nra.
Qed.
Lemma ln_fourth s : 1 <= s -> 0 <= ln (s ^ 4) <= 4 * s.
Proof.
  intros Hs. rewrite ln_pow by lra. simpl INR. pose proof (exp_ineq1_le (ln s)) as U. rewrite exp_ln in U by lra.
  assert (0 <= ln s) by (rewrite <- ln_1; apply ln_le; lra). lra.
Qed.

(** v = tau + K + D ln(v/C) + e, solved for tau/v *)
Lemma solved C D K e0 : 0 < C -> 0 <= e0 -> exists A s0, 1 <= s0 /\ forall s v, s0 <= s -> s ^ 4 / 2 <= v <= 2 * s ^ 4 ->
  Rabs (v - (s ^ 4 + K + D * ln (v / C))) <= e0 / s ^ 2 -> Rabs (s ^ 4 / v - 1 + (K + D * ln (s ^ 4 / C)) / s ^ 4) <= A / s ^ 6.
Proof.
  intros HC He. pose proof (Rabs_pos D). pose proof (Rabs_pos K). pose proof (Rabs_pos (ln C)).
  set (A1 := Rabs K + Rabs D * (4 + Rabs (ln C))). assert (0 <= A1) by (unfold A1; assert (0 <= Rabs D * (4 + Rabs (ln C))) by (apply Rmult_le_pos; lra); lra).
  set (A2 := 2 * (A1 + e0)). set (A3 := 2 * Rabs D * A2 + e0).
  exists (A3 + 2 * A2 ^ 2), (1 + 4 * Rabs D). split; [lra|]. intros s v Hs Hv E.
  assert (S1 : 1 <= s) by lra. pose proof (ln_fourth s S1) as L4. set (y := / s). assert (Y : 0 < y <= 1).
  { unfold y. split; [positive|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (Ys : s * y = 1) by (unfold y; field; lra). assert (T4 : 0 < s ^ 4) by positive.
  set (x := v / s ^ 4). assert (X : / 2 <= x <= 2) by (unfold x; split; [undivide (s ^ 4)|undivide (s ^ 4)]; lra).
  set (L := K + D * ln (s ^ 4 / C)). set (rho := D * ln x + (v - (s ^ 4 + K + D * ln (v / C)))).
  assert (Lb : Rabs L <= A1 * s).
  { unfold L. rewrite ln_div by auto. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
    assert (Rabs (ln (s ^ 4) - ln C) <= (4 + Rabs (ln C)) * s).
    { eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, Rabs_pos_eq by lra. nra. }
    assert (Rabs D * Rabs (ln (s ^ 4) - ln C) <= Rabs D * ((4 + Rabs (ln C)) * s)) by scale. unfold A1. nra. }
  assert (Ev : x - 1 = (L + rho) * y ^ 4).
  { unfold rho, L, x, y. rewrite (ln_div v C), (ln_div (s ^ 4) C) by lra. replace (ln (v / s ^ 4)) with (ln v - ln (s ^ 4)) by (rewrite ln_div; lra).
    field. lra. }
  assert (Rb : Rabs rho <= 2 * Rabs D * Rabs (x - 1) + e0 * y ^ 2).
  { unfold rho. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
    - rewrite Rabs_mult. pose proof (ln_near x (proj1 X)). assert (Rabs D * Rabs (ln x) <= Rabs D * (2 * Rabs (x - 1))) by scale. lra.
    - eapply Rle_trans; [exact E|]. right. unfold y. field. lra. }
  assert (Dy : Rabs D * y <= / 4).
  { replace (/ 4) with (/ 4 * (s * y)) by (rewrite Ys; ring). rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
  assert (P2 : 0 < y ^ 2) by positive. assert (P3 : 0 < y ^ 3) by positive. assert (P4 : 0 < y ^ 4 <= y).
  { split; [positive|]. replace (y ^ 4) with (y * (y * (y * y))) by ring. nra. }
  assert (P6 : y ^ 6 <= y ^ 3) by (replace (y ^ 6) with (y ^ 3 * y ^ 3) by ring; assert (y ^ 3 <= 1) by nra; nra).
  pose proof (Rabs_pos (x - 1)) as X0. assert (Xb : Rabs (x - 1) <= A2 * y ^ 3).
  { assert (Q : Rabs (x - 1) <= (A1 * s + (2 * Rabs D * Rabs (x - 1) + e0 * y ^ 2)) * y ^ 4).
    { rewrite Ev at 1. rewrite Rabs_mult, (Rabs_pos_eq (y ^ 4)) by lra. apply Rmult_le_compat_r; [lra|].
      eapply Rle_trans; [apply Rabs_triang|lra]. }
    replace ((A1 * s + (2 * Rabs D * Rabs (x - 1) + e0 * y ^ 2)) * y ^ 4) with
      (A1 * (s * y) * y ^ 3 + 2 * (Rabs D * y ^ 4) * Rabs (x - 1) + e0 * y ^ 6) in Q by ring. rewrite Ys in Q.
    assert (Rabs D * y ^ 4 <= / 4) by (apply Rle_trans with (Rabs D * y); [scale; lra|lra]).
    assert (2 * (Rabs D * y ^ 4) * Rabs (x - 1) <= 2 * / 4 * Rabs (x - 1)) by (apply Rmult_le_compat_r; lra).
    assert (e0 * y ^ 6 <= e0 * y ^ 3) by scale. unfold A2. lra. }
  assert (A2p : 0 <= A2) by (unfold A2; lra). assert (Rb' : Rabs rho <= A3 * y ^ 2).
  { eapply Rle_trans; [exact Rb|]. assert (y ^ 3 <= y ^ 2) by nra. assert (A2 * y ^ 3 <= A2 * y ^ 2) by scale.
    assert (2 * Rabs D * Rabs (x - 1) <= 2 * Rabs D * (A2 * y ^ 2)) by (apply Rmult_le_compat_l; lra). unfold A3. lra. }
  assert (Id : s ^ 4 / v - 1 + L / s ^ 4 = - rho * y ^ 4 + (x - 1) ^ 2 / x).
  { replace (s ^ 4 / v) with (/ x) by (unfold x; field; lra). replace (L / s ^ 4) with (L * y ^ 4) by (unfold y; field; lra).
    replace (/ x - 1) with (- (x - 1) + (x - 1) ^ 2 / x) by (field; lra). rewrite Ev at 1. ring. }
  rewrite Id. replace ((A3 + 2 * A2 ^ 2) / s ^ 6) with (A3 * y ^ 2 * y ^ 4 + (A2 * y ^ 3) ^ 2 * 2) by (unfold y; field; lra).
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
  - rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (y ^ 4)) by lra. apply Rmult_le_compat_r; lra.
  - unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ x)), <- RPow_abs by positive.
    apply Rmult_le_compat; [apply pow2_ge_0|positive|apply pow_incr; lra|].
    rewrite <- (Rinv_inv 2). apply Rinv_le_contravar; lra.
Qed.

(** what moves from n on by at most f n, f -> 0, has a limit within f n *)
Lemma within_limit (R f : nat -> R) : is_lim_seq f 0 -> (forall n j, Rabs (R (n + j)%nat - R n) <= f n) ->
  exists K, forall n, Rabs (R n - K) <= f n.
Proof.
  intros F Near. assert (Ca : ex_lim_seq_cauchy R).
  { intros e. apply is_lim_seq_spec in F. assert (He : 0 < e / 2) by (pose proof (cond_pos e); lra).
    destruct (F (mkposreal _ He)) as (N & KN). exists N. intros n m Hn Hm. specialize (KN N (le_n N)). simpl in KN. rewrite Rminus_0_r in KN.
    pose proof (Near N (n - N)%nat) as A. pose proof (Near N (m - N)%nat) as B. replace (N + (n - N))%nat with n in A by lia.
    replace (N + (m - N))%nat with m in B by lia. pose proof (Rle_abs (f N)).
    replace (R n - R m) with ((R n - R N) - (R m - R N)) by ring. eapply Rle_lt_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
  apply ex_lim_seq_cauchy_corr in Ca. destruct Ca as (K & L). exists K. intros n.
  assert (L' : is_lim_seq (fun j => Rabs (R n - R (n + j)%nat)) (Rabs (R n - K))).
  { apply (is_lim_seq_abs (fun j => R n - R (n + j)%nat) (R n - K)). apply is_lim_seq_minus'; [apply is_lim_seq_const|].
    apply (is_lim_seq_incr_n R n) in L. apply is_lim_seq_ext with (2 := L). intros j. f_equal. lia. }
  apply (is_lim_seq_le _ (fun _ => f n) _ (f n)) with (2 := L') (3 := is_lim_seq_const _). intros j. rewrite Rabs_minus_sym. apply Near.
Qed.

Section Law.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (r := m2 / (m1 + m2)) (om := omega m1 m2 a2) (C := 4 * PI * q / (9 * r))
  (B := 1 - 2 / (5 * r)).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let w t := energy m1 m2 a2 (x t) (v1 t) (v2 t) / Ecr m1 m2 a2 b - 1.
Context (lo hi long : R) (Lo : lo <= 0 <= hi) (Long : 0 <= long).
Hypothesis Bounds : forall p, 0 < p <= PI / 4 -> let s := (depth p / hh p) ^ 2 in
  lo * depth p ^ 2 <= PI * gain r p <= hi * (r * depth p ^ 2) /\
  delay r p * (1 + sqrt (1 - r * s)) <= long * (hh p * s).

(** from a later exit on it is the same orbit *)
Lemma shifted t0 p n j : orb m1 m2 (orb m1 m2 p n) j = orb m1 m2 p (n + j) /\
  tim m1 m2 a2 (tim m1 m2 a2 t0 p n) (orb m1 m2 p n) j = tim m1 m2 a2 t0 p (n + j).
Proof.
  induction j as [|j (IH1 & IH2)]; [rewrite Nat.add_0_r; auto|]. rewrite Nat.add_succ_r. simpl. rewrite IH1, IH2. auto.
Qed.

Theorem long_time_from_ray k t0 p : k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI -> hh p <= PI / 2 - 1 ->
  on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 -> exists K A T, forall n, let t := tim m1 m2 a2 t0 p n in T <= t ->
  Rabs (w t * (om * t) / C - 1 + (PI * B * ln (9 / 4 * r * (om * t) / PI) + K) / (om * t)) <= A / (om * t * sqrt (om * t)).
Proof.
  intros Hk Ht Hp Hh HR. pose proof pi_below. destruct (ok_push m1 m2 Hm1 Hm2 p Hp ltac:(lra)) as (Hok & _).
  pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. pose proof (r_pos m1 m2 Hm1 Hm2) as R0. fold q r in Q0, R0.
  pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O0. fold om in O0. pose proof PI_RGT_0 as P0.
  assert (C0 : 0 < C) by (unfold C; positive).
  set (y n := hh (orb m1 m2 p n) ^ 2). set (tm := tim m1 m2 a2 t0 p).
  assert (Y : forall n, 0 < y n <= 1).
  { intros n. pose proof (hh_pos _ (ok_pi m1 m2 _ (orb_ok m1 m2 Hm1 Hm2 p n Hok))). pose proof (push_below m1 m2 Hm1 Hm2 p Hok n).
    unfold y. split; [positive|]. nra. }
  set (ka := (- lo + long) / r + hi). assert (Ka : 0 <= ka) by (unfold ka; assert (0 <= (- lo + long) / r) by (apply Rdiv_le_0_compat; lra); lra).
  set (R n := C / w (tm n) + PI * B * ln (w (tm n) / w t0) - (C / w t0 + om * (tm n - t0))).
  assert (Ok : forall n, ok m1 m2 (orb m1 m2 p n)) by (intros; apply orb_ok; auto).
  assert (T0 : forall n, t0 <= tm n) by (intros; apply tim_start; auto).
  assert (From : forall n j, w (tm n) = q * y n /\
    Rabs (C / w (tm (n + j)%nat) + PI * B * ln (w (tm (n + j)%nat) / w (tm n)) - (C / w (tm n) + om * (tm (n + j)%nat - tm n))) <= ka * sqrt (y n)).
  { intros n j. destruct (law_with_error m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H lo hi long Lo Long Bounds _ (tm n) (orb
      m1 m2 p n) (sides k n Hk) ltac:(pose proof (T0 n); lra) (ok_pi m1 m2 _ (Ok n)) ltac:(pose proof (push_below m1 m2
      Hm1 Hm2 p Hok n); lra) (exits m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 p Hk H Ht Hok HR n) j) as (Wn & _ & Bd).
    split; [exact Wn|]. fold q r in Bd. fold C B om in Bd. pose proof (proj2 (shifted t0 p n j) : tim m1 m2 a2 (tm n) (orb m1 m2 p n) j = tm (n + j)%nat) as Sh.
    rewrite Sh in Bd. fold (w (tm (n + j)%nat)) (w (tm n)) in Bd. change (hh (orb m1 m2 p n) ^ 2) with (y n) in Bd.
    pose proof (Y n) as Yn. set (z := sqrt (y n)) in *.
    assert (Z : 0 < z <= 1) by (unfold z; split; [positive|rewrite <- sqrt_1; apply sqrt_le_1_alt; lra]).
    assert (Z2 : z * z = y n) by (apply sqrt_sqrt; lra). assert (Yz : y n <= z) by nra.
    assert (E1 : - ((- lo + long) / r * z) <= (lo * y n - long * z) / r).
    { replace (- ((- lo + long) / r * z)) with ((lo * z - long * z) / r) by (field; lra). apply Rmult_le_compat_r; [positive|]. nra. }
    assert (E2 : hi * y n <= hi * z) by scale. assert (0 <= hi * z) by positive.
    assert (0 <= (- lo + long) / r * z) by (apply Rmult_le_pos; [apply Rdiv_le_0_compat|]; lra). unfold ka.
    apply Rabs_le. split; lra. }
  assert (W : forall n, w (tm n) = q * y n) by (intros n; apply (From n O)).
  assert (Wp : forall n, 0 < w (tm n)) by (intros n; rewrite W; apply Rmult_lt_0_compat; [auto|apply Y]).
  assert (W0 : 0 < w t0) by exact (Wp O).
  destruct (within_limit R (fun n => ka * sqrt (y n))) as (K & KR).
  { replace (Finite 0) with (Rbar_mult ka (sqrt 0)) by (simpl; rewrite sqrt_0; f_equal; ring). apply is_lim_seq_scal_l.
    apply is_lim_seq_continuous; [apply continuity_pt_sqrt; lra|]. exact (level_to_zero m1 m2 Hm1 Hm2 p Hok). }
  { intros n j. eapply Rle_trans; [|apply (From n j)]. right. f_equal. unfold R.
    replace (ln (w (tm (n + j)%nat) / w t0)) with (ln (w (tm (n + j)%nat) / w (tm n)) + ln (w (tm n) / w t0)); [ring|].
    pose proof (Wp n). pose proof (Wp (n + j)%nat). rewrite <- ln_mult by positive. f_equal. field. lra. }
  set (K1 := K + C / w t0 - om * t0 + PI * B * ln (w t0)). set (e0 := ka * sqrt (2 * C / q)).
  destruct (solved C (PI * B) K1 e0 C0) as (A & s0 & Hs0 & Sol). { unfold e0. apply Rmult_le_pos; [auto|apply sqrt_pos]. }
  pose proof (sharp_from_ray m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hok HR) as Lim.
  pose proof (SharpRate.Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as E0.
  assert (Lim' : exists T, forall t, T < t -> 2 / 3 * C <= om * t * w t <= 2 * C).
  { apply is_lim_spec in Lim. assert (He : 0 < Ecr m1 m2 a2 b * C / (3 * om)) by positive. destruct (Lim (mkposreal _ He)) as (T & LT). exists T. intros t Hlt.
    specialize (LT t Hlt). simpl in LT. apply Rabs_def2 in LT.
    assert (Ra : Ecr m1 m2 a2 b * rate m1 m2 a2 = Ecr m1 m2 a2 b * C / om).
    { unfold rate. rewrite <- root_inv by lra. change (sqrt (a2 / (m1 + m2))) with om. unfold C, q, r. field. repeat split; lra. }
    rewrite Ra in LT. assert (Ew : om * t * w t = om / Ecr m1 m2 a2 b * (t * (energy m1 m2 a2 (x t) (v1 t) (v2 t) - Ecr m1 m2 a2 b))) by (unfold w; field; lra).
    rewrite Ew. set (g := t * _) in *. assert (0 < om / Ecr m1 m2 a2 b) by positive.
    replace (2 / 3 * C) with (om / Ecr m1 m2 a2 b * (Ecr m1 m2 a2 b * C / om - Ecr m1 m2 a2 b * C / (3 * om))) by (field; lra).
    replace (2 * C) with (om / Ecr m1 m2 a2 b * (2 * (Ecr m1 m2 a2 b * C / om))) by (field; lra).
    assert (0 < Ecr m1 m2 a2 b * C / om) by positive.
    assert (Ecr m1 m2 a2 b * C / (3 * om) = Ecr m1 m2 a2 b * C / om / 3) by (field; lra). split; apply Rmult_le_compat_l; lra. }
  destruct Lim' as (T1 & LT). exists (K1 - PI * B * ln q), A, (Rmax (T1 + 1) (s0 ^ 4 / om)). intros n t HT.
  pose proof (Rmax_l (T1 + 1) (s0 ^ 4 / om)). pose proof (Rmax_r (T1 + 1) (s0 ^ 4 / om)).
  set (tau := om * t). assert (S4 : s0 ^ 4 <= tau).
  { unfold tau. replace (s0 ^ 4) with (om * (s0 ^ 4 / om)) by (field; lra). apply Rmult_le_compat_l; lra. }
  assert (Tau : 1 <= tau) by (apply Rle_trans with (2 := S4); rewrite <- (pow1 4); apply pow_incr; lra).
  set (sq := sqrt (sqrt tau)). assert (Sq2 : sq ^ 2 = sqrt tau) by (unfold sq; apply pow2_sqrt, sqrt_pos).
  assert (Sq4 : sq ^ 4 = tau) by (replace (sq ^ 4) with ((sq ^ 2) ^ 2) by ring; rewrite Sq2; apply pow2_sqrt; lra).
  assert (Sq0 : s0 <= sq).
  { apply Rnot_lt_le. intros N. assert (0 <= sq) by apply sqrt_pos. assert (sq ^ 4 < s0 ^ 4); [|lra].
    replace (sq ^ 4) with ((sq * sq) * (sq * sq)) by ring. replace (s0 ^ 4) with ((s0 * s0) * (s0 * s0)) by ring.
    assert (sq * sq < s0 * s0) by nra. assert (0 <= sq * sq) by nra. nra. }
  pose proof (LT t ltac:(lra)) as Lw. fold tau in Lw. pose proof (Wp n) as Wn. fold tm in t. fold t in Wn.
  set (v := C / w t). assert (Ev : w t = C / v) by (unfold v; field; lra). assert (Vp : 0 < v) by (unfold v; positive).
  assert (Vb : tau / 2 <= v <= 2 * tau).
  { unfold v. split; [undivide (w t); lra|undivide (w t); lra]. }
  specialize (Sol sq v Sq0). rewrite Sq4 in Sol. specialize (Sol Vb).
  assert (Eq : v - (tau + K1 + PI * B * ln (v / C)) = R n - K).
  { unfold R. fold t. rewrite Ev. replace (C / (C / v)) with v by (field; lra).
    replace (ln (C / v / w t0)) with (- ln (v / C) - ln (w t0)).
    - unfold K1, tau. ring.
    - rewrite !ln_div by positive. ring. }
  assert (Err : Rabs (v - (tau + K1 + PI * B * ln (v / C))) <= e0 / sq ^ 2).
  { rewrite Eq. eapply Rle_trans; [apply KR|]. unfold e0, Rdiv. rewrite Rmult_assoc. apply Rmult_le_compat_l; [auto|].
    rewrite Sq2. replace (sqrt (2 * C * / q) * / sqrt tau) with (sqrt (2 * C / q / tau)).
    2: { unfold Rdiv at 1. rewrite sqrt_mult_alt, <- sqrt_inv by positive. auto. }
    apply sqrt_le_1_alt. apply Rmult_le_reg_l with q; auto. rewrite <- W. fold t. rewrite Ev.
    replace (q * (2 * C / q / tau)) with (2 * C / tau) by (field; lra). replace (C / v) with (C * / v) by auto.
    assert (/ v <= 2 / tau); [|apply Rle_trans with (C * (2 / tau)); [scale|right; field; lra]].
    replace (2 / tau) with (/ (tau / 2)) by (field; lra). apply Rinv_le_contravar; lra. }
  specialize (Sol Err). replace (w t * tau / C) with (tau / v) by (rewrite Ev; field; lra).
  replace (PI * B * ln (9 / 4 * r * tau / PI) + (K1 - PI * B * ln q)) with (K1 + PI * B * ln (tau / C)).
  - replace (tau * sqrt tau) with (sq ^ 6) by (replace (sq ^ 6) with (sq ^ 4 * sq ^ 2) by ring; rewrite Sq4, Sq2; auto). exact Sol.
  - replace (9 / 4 * r * tau / PI) with (tau / C * q) by (unfold C; field; repeat split; lra). rewrite ln_mult by positive. ring.
Qed.

(** [long-time] A solution that never merges comes to exits where $w=\frac{C}{\tau}(1-\frac{\pi
    B\ln(\alpha\tau/\pi)+K}{\tau}+O(\tau^{-3/2}))$, given the bounds of law-with-error. *)
Theorem long_time : (forall t, 0 <= t -> Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t)) ->
  exists k t0 p, (k = 1 \/ k = -1) /\ 0 <= t0 /\ ok m1 m2 p /\ on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 /\
  exists K A T, forall n, let t := tim m1 m2 a2 t0 p n in T <= t ->
  Rabs (w t * (om * t) / C - 1 + (PI * B * ln (9 / 4 * r * (om * t) / PI) + K) / (om * t)) <= A / (om * t * sqrt (om * t)).
Proof.
  intros Up. pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. fold q in Q0. pose proof (SharpRate.Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as E0.
  destruct (strip m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H Up (Ecr m1 m2 a2 b * (q / 4))) as (t & Ht & Ev & Hx & HE); [positive|].
  destruct (start m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t H Ht Ev Hx (Up t Ht)) as (k & t1 & p & Hk & T1 & Hp & HR & EP).
  { apply small_simple; auto. fold q. nra. }
  pose proof (ok_pi m1 m2 p Hp) as Pp. pose proof (hh_pos p Pp) as U. pose proof PI2_3_2. fold q in EP.
  assert (hh p <= / 2). { rewrite EP in HE. assert (Le : Ecr m1 m2 a2 b * q * hh p ^ 2 <= Ecr m1 m2 a2 b * q * / 4) by lra.
    apply Rmult_le_reg_l in Le; [|positive]. nra. }
  exists k, t1, p. split; [auto|]. split; [lra|]. split; [auto|]. split; [exact HR|].
  apply (long_time_from_ray k t1 p); auto; lra.
Qed.
End Law.
