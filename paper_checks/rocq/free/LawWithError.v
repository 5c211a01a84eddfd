(** The 1/t law with its logarithm: C/w + pi B ln w grows along the exits as the time does, up to what the bounds of one
    cycle leave: they telescope. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap Cycle ExitOrbit SharpRate RateBounds CycleLength.

(** what a cycle adds to 1/(al y) + B ln y beyond 1, al = 9/4 r, B = 1 - 2/(5 r), by its half angle *)
Definition gain r p := let s := (depth p / hh p) ^ 2 in
  4 / 9 * (s / hh p ^ 2) / (1 - r * s) - 1 + (1 - 2 / (5 * r)) * ln (1 - r * s).

Section Law.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (q := m1 / (m1 + m2)) (r := m2 / (m1 + m2)) (om := omega m1 m2 a2).
Context (x v1 v2 s : R -> R) (H : solution m1 m2 0 a2 b x v1 v2 s).
Let w t := energy m1 m2 a2 (x t) (v1 t) (v2 t) / Ecr m1 m2 a2 b - 1.

(** [law-with-error] From a ray with $y_0\leqslant(\pi/2-1)^2$, given $g\leqslant\pi G/c^2$, $\pi G/(r\,c^2)\leqslant
    g'$ and $F\,(1+\sqrt{1-rs})/(h\,s)\leqslant f$ at all slip angles up to $\pi/2$, with $g\leqslant 0\leqslant
    g',f$: $(g\,y_0-f\sqrt{y_0})/r\leqslant R_n\leqslant g'y_0$ at every exit. *)
Theorem law_with_error lo hi long : lo <= 0 <= hi -> 0 <= long ->
  (forall p, 0 < p <= PI / 4 -> let s := (depth p / hh p) ^ 2 in lo * depth p ^ 2 <= PI * gain r p <= hi * (r * depth p ^ 2) /\
    delay r p * (1 + sqrt (1 - r * s)) <= long * (hh p * s)) ->
  forall k t0 p, k = 1 \/ k = -1 -> 0 <= t0 -> 0 < p < PI -> hh p <= PI / 2 - 1 -> on_ray m1 m2 a2 b k (hh p) x v1 v2 t0 ->
  forall n, let t := tim m1 m2 a2 t0 p n in let y0 := hh p ^ 2 in let C := 4 * PI * q / (9 * r) in let B := 1 - 2 / (5 * r) in
  w t0 = q * y0 /\ on_ray m1 m2 a2 b (k * (-1) ^ n) (hh (orb m1 m2 p n)) x v1 v2 t /\
  (lo * y0 - long * sqrt y0) / r <= C / w t + PI * B * ln (w t / w t0) - (C / w t0 + om * (t - t0)) <=
  hi * y0.
Proof.
  intros Lo Sh Bounds k t0 p Hk Ht Hp Hh HR n t y0 C B. pose proof PI_4 as P4. pose proof PI2_3_2 as P3.
  pose proof pi_below.
  destruct (ok_push m1 m2 Hm1 Hm2 p Hp ltac:(lra)) as (Hok & _).
  pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. pose proof (r_pos m1 m2 Hm1 Hm2) as R0. pose proof (qr_one m1 m2 Hm1 Hm2) as QR.
  fold q r in Q0, R0, QR.
  set (ph := orb m1 m2 p). set (y i := hh (ph i) ^ 2). assert (Ok : forall i, ok m1 m2 (ph i)) by (intros; apply orb_ok; auto).
  assert (Pi : forall i, 0 < ph i < PI) by (intros; apply (ok_pi m1 m2), Ok).
  assert (U : forall i, 0 < hh (ph i)) by (intros; apply hh_pos, Pi).
  assert (Y : forall i, 0 < y i) by (intros; apply pow_lt, U).
  assert (Push : forall i, hh (ph i) <= hh p) by (intros i; exact (push_below m1 m2 Hm1 Hm2 p Hok i)).
  assert (Quarter : forall i, 0 < ph i <= PI / 4).
  { intros i. split; [apply Pi|]. apply hh_le; [apply Pi|lra|]. rewrite (proj1 quarter). pose proof (Push i).
    lra. }
  assert (W : forall i, w (tim m1 m2 a2 t0 p i) = q * y i).
  { intros i. pose proof (exit_level m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H k t0 p Hk Ht Hok HR i) as E. cbv beta in E.
    unfold w. rewrite E. fold q. unfold y, ph. pose proof (SharpRate.Ecr_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb). field. lra. }
  assert (W0 : w t0 = q * y0) by exact (W 0%nat). split; [exact W0|].
  split; [exact (exits m1 m2 a2 b Hm1 Hm2 Ha2 Hb k x v1 v2 s t0 p Hk H Ht Hok HR n)|].
  (* one cycle *)
  assert (Step : forall i, C / (q * y (S i)) - C / (q * y i) + PI * B * ln (y (S i) / y i) - om * cyc m1 m2 a2 (ph i) =
    PI * gain r (ph i) - delay r (ph i) /\
    lo * (y i - y (S i)) <= r * (PI * gain r (ph i)) /\ PI * gain r (ph i) <= hi * (y i - y (S i)) /\
    0 <= delay r (ph i) /\ r * delay r (ph i) <= long * (sqrt (y i) - sqrt (y (S i)))).
  { intros i. destruct (Bounds (ph i) (Quarter i)) as (Bg & Bd). pose proof (delay_pos r (ph i) ltac:(lra) (Quarter i)) as Dp. pose proof (next_ok m1 m2 Hm1 Hm2 (ph i) (Ok i)) as (_ & En).
    change (hh (next m1 m2 (ph i)) ^ 2) with (y (S i)) in En. fold r (y i) in En.
    pose proof (proj1 (cycle_angles m1 m2 a2 Hm1 Hm2 Ha2 (ph i) (Pi i) ltac:(pose proof (Push i); lra))) as Cy.
    change (hh (next m1 m2 (ph i))) with (hh (ph (S i))) in Cy. fold q om in Cy. unfold delay, gain in *.
    replace (1 - r) with q in * by lra. pose proof (Y i) as Yi. pose proof (Y (S i)) as Y'. pose proof (U i) as Ui.
    pose proof (U (S i)) as U'. set (c := depth (ph i)) in *. set (u := hh (ph i)) in *. set (z := (c / u) ^ 2) in *.
    assert (Z : r * z * y i = r * c ^ 2) by (unfold z, y; fold u; field; lra).
    assert (Ys : y (S i) = y i * (1 - r * z)) by lra.
    assert (S0 : 0 < 1 - r * z) by (apply Rmult_lt_reg_l with (y i); lra).
    assert (Ru : sqrt (y i) = u) by (apply sqrt_pow2; lra). assert (Ru' : sqrt (y (S i)) = u * sqrt (1 - r * z)).
    { rewrite Ys, sqrt_mult_alt, Ru by lra. auto. }
    assert (Eu : hh (ph (S i)) = u * sqrt (1 - r * z)) by (rewrite <- Ru'; symmetry; apply sqrt_pow2; lra). rewrite Eu in Cy.
    assert (Sz : 0 < sqrt (1 - r * z)) by positive. assert (Sz2 : sqrt (1 - r * z) * sqrt (1 - r * z) = 1 - r * z) by (apply sqrt_sqrt; lra).
    split; [|split; [|split; [|split]]].
    - rewrite Cy, Ys. replace (y i * (1 - r * z) / y i) with (1 - r * z) by (field; lra). unfold C, B.
      change (u ^ 2) with (y i). field. lra.
    - replace (lo * (y i - y (S i))) with (r * (lo * c ^ 2)) by (rewrite En; ring). apply Rmult_le_compat_l; lra.
    - replace (hi * (y i - y (S i))) with (hi * (r * c ^ 2)) by (rewrite En; ring). lra.
    - exact Dp.
    - rewrite Ru, Ru'. set (D := sqrt q * _ - _ - _) in *. set (S := sqrt (1 - r * z)) in *.
      assert (E : forall g, r * (g * (u * z)) = g * (u - u * S) * (1 + S)).
      { intros g. replace (g * (u - u * S) * (1 + S)) with (g * u * (1 - S * S)) by ring. rewrite Sz2. ring. }
      apply Rmult_le_reg_r with (1 + S); [lra|]. rewrite <- E, (Rmult_assoc r D). apply Rmult_le_compat_l; lra. }
  assert (Z0 : 0 < y0) by exact (Y 0%nat).
  assert (Sum : forall i, let R := C / (q * y i) + PI * B * ln (y i / y0) - (C / (q * y0) + om * (tim m1 m2 a2 t0 p i - t0)) in
    lo * (y0 - y i) - long * (sqrt y0 - sqrt (y i)) <= r * R /\ R <= hi * (y0 - y i)).
  { induction i as [|i IH]; cbv zeta in *.
    - change (y 0%nat) with y0. replace (y0 / y0) with 1 by (field; lra). rewrite ln_1. simpl tim. lra.
    - change (tim m1 m2 a2 t0 p (S i)) with (tim m1 m2 a2 t0 p i + cyc m1 m2 a2 (ph i)).
      destruct (Step i) as (E & G & G' & D & D'). pose proof (Y i) as Yi. pose proof (Y (S i)) as Y'.
      assert (L : ln (y (S i) / y0) = ln (y (S i) / y i) + ln (y i / y0)).
      { rewrite <- ln_mult by positive. f_equal. field. lra. }
      rewrite L. set (t' := tim m1 m2 a2 t0 p i) in *. set (R' := C / (q * y i) + _ - _) in IH.
      replace (C / (q * y (S i)) + PI * B * (ln (y (S i) / y i) + ln (y i / y0)) - (C / (q * y0) + om * (t' + cyc m1 m2 a2 (ph i) - t0)))
        with (R' + (PI * gain r (ph i) - delay r (ph i))) by (rewrite <- E; unfold R'; ring). lra. }
  pose proof (Sum n) as Sn. rewrite <- (W n), <- W0 in Sn. fold t in Sn.
  assert (Yn : 0 < y n <= y0). { split; [apply Y|]. apply pow_incr. pose proof (Push n). pose proof (U n). lra. }
  assert (Sq : 0 < sqrt (y n) <= sqrt y0) by (split; [positive|apply sqrt_le_1_alt; lra]).
  replace (w t / w t0) with (y n / y0) by (unfold t; rewrite W, W0; field; split; lra). set (R' := C / w t + _ - _) in *.
  assert (lo * y0 <= lo * (y0 - y n)) by nra. assert (hi * (y0 - y n) <= hi * y0) by nra.
  assert (long * (sqrt y0 - sqrt (y n)) <= long * sqrt y0) by nra. split; [apply Rle_div_l|]; lra.
Qed.
End Law.
