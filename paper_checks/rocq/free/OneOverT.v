(** The last sentences of Section III, as theorems: the times of exit and entry, and c1/t <= E - E_cr <= c2/t. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle ExitOrbit SharpRate SharpLaw.

Section Paper.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Let om := omega m1 m2 a2.
Let L := L m1 m2 a2 b.
Let Ecr := Ecr m1 m2 a2 b.
Let en := energy m1 m2 a2.
Let q := m1 / (m1 + m2).
Let q_pos : 0 < q := q_pos m1 m2 Hm1 Hm2.
Let om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2.
Let E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb.
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).

(** every solution that never merges comes to an exit ray at a small level *)
Theorem reaches_ray : (forall t, 0 <= t -> Ecr < en (x t) (v1 t) (v2 t)) ->
  exists k t1 p, (k = 1 \/ k = -1) /\ 0 <= t1 /\ ok m1 m2 p /\ on_ray m1 m2 a2 b k (hh p) x v1 v2 t1.
Proof.
  intros Up. destruct (strip m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H Up (Ecr * (4 / 9 * q))) as (t & Ht & Ev & Hx & HE).
  { positive. }
  destruct (start m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t H Ht Ev Hx (Up t Ht)) as (k & t1 & p & Hk & T1 & Hp & HR & _).
  { apply small_simple; auto. rewrite Rmult_plus_distr_l, Rmult_1_r. exact HE. }
  exists k, t1, p. split; [auto|]. split; [lra|]. auto.
Qed.

(** [exit-and-entry-times] For every solution that never merges: entries and exits alternate; stays on $S_0$ tend to
    $\pi/\Omega$, slips to 0. *)
Theorem times : (forall t, 0 <= t -> Ecr < en (x t) (v1 t) (v2 t)) ->
  exists te tau : nat -> R, (forall n, 0 <= te n < tau n) /\ (forall n, tau n < te (S n)) /\ is_lim_seq te p_infty /\
    (forall n t, te n <= t <= tau n -> v1 t = v2 t /\ - L <= x t <= L) /\
    (forall n t, tau n < t < te (S n) -> v1 t <> v2 t) /\
    is_lim_seq (fun n => tau n - te n) (PI * sqrt ((m1 + m2) / a2)) /\ is_lim_seq (fun n => te (S n) - tau n) 0.
Proof.
  intros Up. destruct (reaches_ray Up) as (k & t0 & p & Hk & Ht & Hp & HR). set (ph := orb m1 m2 p).
  set (tm := tim m1 m2 a2 t0 p). set (sl := fun n => 2 * ph n / o1 m1 a2).
  assert (Ok : forall n, ok m1 m2 (ph n)) by (intros; apply orb_ok; auto).
  assert (Sp : forall n, 0 < sl n) by (intros n; apply (cyc_long m1 m2 a2 Hm1 Hm2 Ha2 (ph n) (Ok n))).
  assert (T0 : forall n, t0 <= tm n) by (intros; apply tim_start; auto).
  assert (Cy : forall n, sl n < cyc m1 m2 a2 (ph n) /\
    (forall u, 0 < u < sl n -> k * (-1) ^ n * v1 (tm n + u) < k * (-1) ^ n * v2 (tm n + u)) /\
    (forall u, sl n <= u <= cyc m1 m2 a2 (ph n) -> v1 (tm n + u) = v2 (tm n + u) /\ - L <= x (tm n + u) <= L)).
  { intros n. pose proof (exits m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 p Hk H Ht Hp HR n) as Rn.
    destruct (cycle m1 m2 a2 b Hm1 Hm2 Ha2 Hb (k * (-1) ^ n) x v1 v2 s (tm n) (ph n) (sides k n Hk) H ltac:(pose proof
      (T0 n); lra) (Ok n) Rn) as (_ & _ & C). split; [apply (cyc_long m1 m2 a2 Hm1 Hm2 Ha2 (ph n) (Ok n))|exact C]. }
  assert (TS : forall n, tm (S n) = tm n + cyc m1 m2 a2 (ph n)) by auto.
  exists (fun n => tm n + sl n), (fun n => tm (S n)).
  split; [intros n; pose proof (T0 n); pose proof (Sp n); destruct (Cy n); rewrite TS; lra|].
  split; [intros n; pose proof (Sp (S n)); lra|]. split.
  { apply is_lim_seq_le_p_loc with tm; [exists O; intros n _; pose proof (Sp n); lra|].
    exact (tm_inf m1 m2 a2 Hm1 Hm2 Ha2 t0 p Hp). }
  split; [|split; [|split]].
  - intros n t Hu. rewrite TS in Hu. replace t with (tm n + (t - tm n)) by ring. apply (proj2 (proj2 (Cy n))). lra.
  - intros n t Hu E. destruct (Cy (S n)) as (_ & C & _). specialize (C (t - tm (S n)) ltac:(lra)).
    replace (tm (S n) + (t - tm (S n))) with t in C by ring. rewrite E in C. lra.
  - replace (PI * sqrt ((m1 + m2) / a2)) with (PI / om); [exact (stick_time m1 m2 a2 Hm1 Hm2 Ha2 t0 p Hp)|].
    rewrite <- root_inv by lra. reflexivity.
  - apply is_lim_seq_ext with (fun n => sl (S n)). { intros; ring. }
    apply (is_lim_seq_incr_1 sl). exact (slip_time m1 m2 a2 Hm1 Hm2 Ha2 p Hp).
Qed.

(** [one-over-t] From $S_0$ slightly above $E_{cr}$, for each $T>0$: $c_1/t\leqslant E/E_{cr}-1\leqslant c_2/t$ from
    $T$ on, explicit, $c_1$ by $T$. *)
Theorem one_over_t : v1 0 = v2 0 -> - L <= x 0 <= L ->
  let w t := en (x t) (v1 t) (v2 t) / Ecr - 1 in let w0 := w 0 in let K := 9 / 4 * (m2 / m1) in
  0 < w0 <= 2 / 9 * q -> forall T t, 0 < T <= t ->
  / ((/ w0 + K / (1 - K * w0)) / T + K / (1 - K * w0) * om / (PI - 6 * sqrt w0)) / t <= w t <=
  (PI + 6 * sqrt w0) / (K * (1 - 3 / 8 * w0 / q) ^ 12 * om) / t.
Proof.
  intros Ev Hx w w0 K HW T t HT.
  destruct (two_sided m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s 0 H (Rle_refl 0) Ev Hx) with (t := t) as (Lo & Up).
  { fold en Ecr q. change (0 < w0 <= 4 / 9 * q). lra. } { lra. }
  fold en Ecr q om in Lo, Up. change (en (x 0) (v1 0) (v2 0) / Ecr - 1) with w0 in Lo, Up.
  change (en (x t) (v1 t) (v2 t) / Ecr - 1) with (w t) in Lo, Up. fold K in Lo, Up. rewrite Rminus_0_r in Lo, Up.
  pose proof (qr_one m1 m2 Hm1 Hm2) as QR. pose proof (r_pos m1 m2 Hm1 Hm2). fold q in QR.
  assert (K0 : 0 < K) by (unfold K; positive).
  assert (Kq : K * q = 9 / 4 * (m2 / (m1 + m2))) by (unfold K, q; field; lra). assert (KW : 2 * (K * w0) < 1) by nra.
  assert (S1 : sqrt w0 <= 1 / 2).
  { rewrite <- (sqrt_pow2 (1 / 2)) by lra. apply sqrt_le_1_alt. lra. }
  pose proof (sqrt_pos w0). pose proof PI2_3_2. set (D := PI + 6 * sqrt w0) in *. set (D' := PI - 6 * sqrt w0) in *.
  assert (HD : 0 < D) by positive. assert (HD' : 0 < D') by positive. specialize (Up ltac:(lra)).
  assert (Kp : 0 < K / (1 - K * w0)) by positive. assert (OT : 0 < om * t) by positive.
  assert (Sg : 0 < 1 - 3 / 8 * w0 / q <= 1).
  { assert (0 < w0 / q) by positive. assert (w0 / q <= 2 / 9) by (undivide q; lra). lra. }
  set (c := K * (1 - 3 / 8 * w0 / q) ^ 12) in *. assert (C : 0 < c <= K).
  { pose proof (pow_incr _ 1 12 (conj (Rlt_le _ _ (proj1 Sg)) (proj2 Sg))) as S.
    split; [apply Rmult_lt_0_compat; [|apply pow_lt]|unfold c; nra]; lra. }
  (* the first cycle is paid by the start *)
  assert (St : 2 * c <= / w0) by (apply Rmult_le_reg_r with w0; [lra|]; rewrite Rinv_l by lra; nra).
  assert (Lo' : c * (om * t / D) <= / w t) by lra. assert (Kd : 0 < c * (om * t / D)) by positive.
  rewrite <- (Rinv_inv (w t)). split.
  - set (A := / w0 + K / (1 - K * w0)). replace (/ (A / T + K / (1 - K * w0) * om / D') / t) with (/ ((A / T + K / (1 -
      K * w0) * om / D') * t)) by (rewrite Rinv_mult; reflexivity). apply Rinv_le_contravar; [lra|].
    apply Rle_trans with (1 := Up). assert (A / T * T <= A / T * t) by scale.
    replace (A / T * T) with A in * by (field; lra). unfold A in *. lra.
  - replace (D / (c * om) / t) with (/ (c * (om * t / D))) by (field; repeat split; lra).
    apply Rinv_le_contravar; auto.
Qed.
End Paper.
