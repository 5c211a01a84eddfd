(** The last sentences of Section III, as theorems: the times of exit and entry, and c1/t <= E - E_cr <= c2/t. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle ExitOrbit SharpRate SharpLaw.

Section Paper.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (om := omega m1 m2 a2) (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b) (en := energy m1 m2 a2)
  (q := m1 / (m1 + m2)) (q_pos : 0 < q := q_pos m1 m2 Hm1 Hm2)
  (om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2) (E0 : 0 < Ecr := Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb).
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
  set (tm := tim m1 m2 a2 t0 p). set (sl := fun n => 2 * ph n / o1 m1 a2). assert (T0 : forall n, t0 <= tm n)
    by (intros; apply tim_start; auto). assert (Cy : forall n, 0 < sl n /\ tm n + sl n < tm (S n) /\
    (forall t, tm n < t < tm n + sl n -> v1 t <> v2 t) /\
    (forall t, tm n + sl n <= t <= tm (S n) -> v1 t = v2 t /\ - L <= x t <= L)).
  { intros n. destruct (cycle_at m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hp HR n) as (_ & _ & A & B
      & C & D).
    repeat (split; [assumption|]). split; [intros t Hu E; specialize (C t Hu); rewrite E in C; lra|exact D]. }
  exists (fun n => tm n + sl n), (fun n => tm (S n)).
  split; [intros n; pose proof (T0 n); destruct (Cy n); lra|]. split; [intros n; destruct (Cy (S n)); lra|].
  split.
  { apply is_lim_seq_le_p_loc with tm; [exists O; intros n _; destruct (Cy n); lra|].
    exact (tm_inf m1 m2 a2 Hm1 Hm2 Ha2 t0 p Hp). }
  split; [intros n; apply Cy|]. split; [intros n; apply (Cy (S n))|]. split.
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
  intros Ev Hx w w0 K HW T t HT. assert (0 < K) by (unfold K; positive). pose proof PI2_3_2.
  destruct (below_over_t m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s 0 H (Rle_refl 0) Ev Hx HW : _ /\ sqrt w0 <=
    1 / 2 /\ K * w0 < 1 / 2 /\ forall t, 0 < t ->
    0 < w t <= (PI + 6 * sqrt w0) / (K * (1 - 3 / 8 * w0 / q) ^ 12 * om) / (t - 0))
    as (_ & S1 & KW & Be).
  destruct (Be t ltac:(lra)) as (Wt & Le). rewrite Rminus_0_r in Le. split; [|exact Le].
  assert (HW' : 0 < w0 <= 4 / 9 * q) by lra. assert (P6 : 6 * sqrt w0 < PI) by lra.
  pose proof (proj2 (two_sided m1 m2 a2 b
    Hm1 Hm2 Ha2 Hb x v1 v2 s 0 H (Rle_refl 0) Ev Hx HW' t ltac:(lra)) P6 : / w t <= / w0 + K / (1 - K * w0) *
      (om * (t - 0) / (PI - 6 * sqrt w0) + 1)) as Up.
  rewrite Rminus_0_r in Up. assert (0 < PI - 6 * sqrt w0) by lra. assert (0 < K / (1 - K * w0)) by positive.
  set (D := PI - 6 * sqrt w0) in *. set (A := / w0 + K / (1 - K * w0)). assert (0 < A) by positive.
  replace (/ (A / T + K / (1 - K * w0) * om / D) / t) with (/ ((A / T + K / (1 - K * w0) * om / D) * t))
    by (rewrite Rinv_mult; reflexivity). rewrite <- (Rinv_inv (w t)). apply Rinv_le_contravar; [positive|].
  apply Rle_trans with (1 := Up). assert (A / T * T <= A / T * t) by scale.
  replace (A / T * T) with A in * by (field; lra). unfold A in *. lra.
Qed.
End Paper.
