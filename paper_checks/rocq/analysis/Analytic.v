(** Analytic functions of time, as far as events need them: next to any time such a function is constant, or it rises,
    or it falls. Polynomials, sinusoids and their sums are analytic. *)
From Coq Require Import Classical List Wf_nat.
From InertialPair Require Import Dini.

(** f is analytic at t: near t it has derivatives P 0 = f, P 1, P 2, ... that grow no faster than those of a power
    series *)
Definition analytic_at (f : R -> R) (t : R) := exists (P : nat -> R -> R) d C K, 0 < d /\ 0 < C /\ 0 < K /\
  (forall r, Rabs (r - t) < d -> P 0%nat r = f r) /\
  forall i r, Rabs (r - t) < d -> is_derive (P i) r (P (S i) r) /\ Rabs (P i r) <= C * K ^ i * INR (fact i).

(** From t in the direction e (1: later, -1: earlier) f rises, or it never does *)
Definition one_way (f : R -> R) (t e : R) := exists d, 0 < d /\
  ((forall h, 0 < h < d -> f t < f (t + e * h)) \/
   (forall h h', 0 <= h <= h' -> h' < d -> f (t + e * h') <= f (t + e * h))).

(** *** All derivatives P i of a function near 0 *)
Section Derivatives.
Context (P : nat -> R -> R) (d : R) (Hd : 0 < d) (DP : forall i h, Rabs h < d -> is_derive (P i) h (P (S i) h)).

Lemma derivatives i j h : Rabs h < d -> is_derive_n (P i) j h (P (i + j)%nat h).
Proof.
  revert h. induction j as [|j IH]; intros h Hh; [rewrite Nat.add_0_r; reflexivity|]. rewrite Nat.add_succ_r.
  apply is_derive_ext_loc with (P (i + j)%nat); [|apply DP; auto]. assert (Hd' : 0 < d - Rabs h) by lra.
  exists (mkposreal _ Hd'). intros u Hu. change (Rabs (u - h) < d - Rabs h) in Hu. symmetry.
  apply is_derive_n_unique, IH. pose proof (Rabs_triang_inv u h). lra.
Qed.

(** Taylor, where the first j of them are 0 at 0 *)
Lemma taylor i j h : 0 < h < d -> (forall l, (l < j)%nat -> P (i + l)%nat 0 = 0) ->
  exists z, 0 < z <= h /\ P i h = h ^ j / INR (fact j) * P (i + j)%nat z.
Proof.
  intros Hh Z. assert (In : forall t, 0 <= t <= h -> Rabs t < d) by (intros t Ht; rewrite Rabs_pos_eq; lra).
  destruct j as [|j]; [exists h; split; [lra|]; rewrite Nat.add_0_r; simpl; field|].
  destruct (Taylor_Lagrange (P i) j 0 h) as (z & Hz & E); [lra| |].
  { intros t Ht [|k] _; [exact I|]. eexists. apply (derivatives i (S k)); auto. }
  exists z. split; [lra|].
  rewrite E, Rminus_0_r, (is_derive_n_unique _ _ _ _ (derivatives i (S j) z (In z ltac:(lra)))).
  rewrite sum_eq_R0; [ring|]. intros n Hn.
  rewrite (is_derive_n_unique _ _ _ _ (derivatives i n 0 (In 0 ltac:(lra)))), Z by lia. ring.
Qed.

(** where all are 0 at 0 the function is 0 as far as its power series converges *)
Lemma flat C K : 0 < C -> 0 < K -> (forall i h, Rabs h < d -> Rabs (P i h) <= C * K ^ i * INR (fact i)) ->
  (forall i, P i 0 = 0) -> forall h, 0 <= h < d -> K * h <= / 2 -> P 0%nat h = 0.
Proof.
  intros HC HK B Z h Hh Small. destruct (Req_dec h 0) as [->|Nz]; auto.
  apply Rabs_eq_0, Rle_antisym; [|apply Rabs_pos]. apply le_epsilon. intros e He.
  destruct (pow_lt_1_zero (/ 2) ltac:(rewrite Rabs_pos_eq; lra) (e / C) ltac:(positive)) as (n & Q).
  specialize (Q n ltac:(lia)). rewrite Rabs_pos_eq in Q by (apply pow_le; lra).
  destruct (taylor 0 n h ltac:(lra) ltac:(auto)) as (z & Hz & ->). change (0 + n)%nat with n.
  assert (Fn : 0 < INR (fact n)) by (apply lt_0_INR, lt_O_fact). assert (Hn : 0 < h ^ n / INR (fact n)) by positive.
  rewrite Rabs_mult, (Rabs_pos_eq (h ^ n / _)) by lra. specialize (B n z ltac:(rewrite Rabs_pos_eq; lra)).
  apply Rle_trans with (C * (K * h) ^ n).
  { replace (C * (K * h) ^ n) with (h ^ n / INR (fact n) * (C * K ^ n * INR (fact n)))
      by (rewrite Rpow_mult_distr; field; lra). scale. }
  assert (Pw : (K * h) ^ n <= (/ 2) ^ n) by (apply pow_incr; split; [positive|auto]).
  assert (C * (e / C) = e) by (field; lra). nra.
Qed.

(** one that never falls stays *)
Lemma never_rises c : 0 < c <= d -> (forall h, 0 < h < c -> P 1%nat h <= 0) -> forall h h', 0 <= h <= h' -> h' < c ->
  P 0%nat h' <= P 0%nat h.
Proof.
  intros Hc N h h' Hh Hh'. destruct (Req_dec h h') as [->|Ne]; [lra|].
  destruct (MVT_cor2 (P 0%nat) (P 1%nat) h h') as (u & E & Hu); [lra| |specialize (N u ltac:(lra)); nra].
  intros u Hu. apply is_derive_Reals, DP. rewrite Rabs_pos_eq; lra.
Qed.

(** the alternatives: the function rises, or it never does; the first derivative that is not 0 at 0 decides *)
Lemma rises_or_not C K : 0 < C -> 0 < K -> (forall i h, Rabs h < d -> Rabs (P i h) <= C * K ^ i * INR (fact i)) ->
  P 0%nat 0 = 0 -> exists c, 0 < c <= d /\
  ((forall h, 0 < h < c -> 0 < P 0%nat h) \/ (forall h h', 0 <= h <= h' -> h' < c -> P 0%nat h' <= P 0%nat h)).
Proof.
  intros HC HK B Z0. assert (R0 : Rabs 0 < d) by (rewrite Rabs_R0; auto).
  destruct (classic (exists n, P n 0 <> 0)) as [Ex|No].
  - destruct (dec_inh_nat_subset_has_unique_least_element (fun n => P n 0 <> 0) (fun n => classic _) Ex)
      as (n & (Pn & Least) & _).
    assert (Z : forall i, (i < n)%nat -> P i 0 = 0).
    { intros i Hi. apply NNPP. intros N. specialize (Least i N). lia. }
    assert (N1 : (1 <= n)%nat) by (destruct n; [contradiction|lia]).
    destruct (continuous_near (P n) 0 (Rabs (P n 0))) as (c & Hc & Near); [|apply Rabs_pos_lt; auto|].
    { apply @ex_derive_continuous. eexists. apply DP, R0. }
    exists (Rmin c d). pose proof (Rmin_l c d). pose proof (Rmin_r c d). split; [split; [positive|auto]|].
    assert (Sign : forall i h, (i <= n)%nat -> 0 < h < Rmin c d -> 0 < P n 0 * P i h).
    { intros i h Hi Hh. destruct (taylor i (n - i) h ltac:(lra)) as (z & Hz & ->); [intros l Hl; apply Z; lia|].
      replace (i + (n - i))%nat with n by lia. specialize (Near z ltac:(rewrite Rminus_0_r, Rabs_pos_eq; lra)).
      assert (0 < P n 0 * P n z) by (unfold Rabs in Near; repeat destruct Rcase_abs; nra).
      assert (Fn : 0 < INR (fact (n - i))) by (apply lt_0_INR, lt_O_fact).
      replace (P n 0 * (h ^ (n - i) / INR (fact (n - i)) * P n z)) with
        (h ^ (n - i) / INR (fact (n - i)) * (P n 0 * P n z)) by ring. positive. }
    destruct (Rdichotomy _ _ Pn) as [Neg|Pos]; [right|left].
    + apply never_rises; [split; [positive|auto]|]. intros h Hh. specialize (Sign 1%nat h N1 Hh). nra.
    + intros h Hh. specialize (Sign 0%nat h ltac:(lia) Hh). nra.
  - assert (Z : forall i, P i 0 = 0) by (intros i; apply NNPP; intros N; apply No; exists i; auto).
    assert (F : forall h, 0 <= h < Rmin d (/ (2 * K)) -> P 0%nat h = 0).
    { intros h Hh. pose proof (Rmin_l d (/ (2 * K))). pose proof (Rmin_r d (/ (2 * K))). apply (flat C K); auto; [lra|].
      replace (/ 2) with (K * / (2 * K)) by (field; lra). apply Rmult_le_compat_l; lra. }
    exists (Rmin d (/ (2 * K))). split; [split; [positive|apply Rmin_l]|]. right. intros h h' Hh Hh'.
    rewrite !F by lra. lra.
Qed.
End Derivatives.

(** *** Which functions are analytic *)

Lemma analytic_near f g t d : 0 < d -> (forall r, Rabs (r - t) < d -> f r = g r) -> analytic_at f t -> analytic_at g t.
Proof.
  intros Hd E (P & d' & C & K & Hd' & HC & HK & P0 & DP). exists P, (Rmin d d'), C, K.
  pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). split; [positive|]. split; auto. split; auto. split.
  - intros r Hr. rewrite <- E by lra. apply P0. lra.
  - intros i r Hr. apply DP. lra.
Qed.

Lemma analytic_derive f t : analytic_at f t -> exists l, is_derive f t l.
Proof.
  intros (P & d & C & K & Hd & HC & HK & P0 & DP). exists (P 1%nat t).
  apply is_derive_ext_loc with (P 0%nat); [|apply DP; rewrite Rminus_diag_eq, Rabs_R0; auto]. exists (mkposreal d Hd).
  auto.
Qed.

(** so it is continuous *)
Lemma analytic_continuous f t : analytic_at f t -> forall e, 0 < e -> exists d, 0 < d /\
  forall r, Rabs (r - t) < d -> Rabs (f r - f t) < e.
Proof.
  intros A e He. destruct (analytic_derive f t A) as (l & D). apply continuous_near; auto. apply @ex_derive_continuous.
  exists l. exact D.
Qed.

Lemma analytic_plus f g t : analytic_at f t -> analytic_at g t -> analytic_at (fun r => f r + g r) t.
Proof.
  intros (P & d & C & K & Hd & HC & HK & P0 & DP) (Q & d' & C' & K' & Hd' & HC' & HK' & Q0 & DQ).
  pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). pose proof (Rmax_l K K'). pose proof (Rmax_r K K').
  exists (fun i r => P i r + Q i r), (Rmin d d'), (C + C'), (Rmax K K').
  split; [positive|]. split; [lra|]. split; [lra|]. split; [intros r Hr; rewrite P0, Q0 by lra; auto|].
  intros i r Hr. destruct (DP i r ltac:(lra)) as (D & B), (DQ i r ltac:(lra)) as (D' & B').
  split; [apply (is_derive_plus (P i) (Q i)); auto|]. eapply Rle_trans; [apply Rabs_triang|].
  assert (F : 0 < INR (fact i)) by (apply lt_0_INR, lt_O_fact).
  assert (C * K ^ i * INR (fact i) <= C * Rmax K K' ^ i * INR (fact i)).
  { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [lra|]. apply pow_incr; lra. }
  assert (C' * K' ^ i * INR (fact i) <= C' * Rmax K K' ^ i * INR (fact i)).
  { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [lra|]. apply pow_incr; lra. }
  lra.
Qed.

Lemma analytic_scal c f t : analytic_at f t -> analytic_at (fun r => c * f r) t.
Proof.
  intros (P & d & C & K & Hd & HC & HK & P0 & DP). pose proof (Rabs_pos c).
  exists (fun i r => c * P i r), d, ((Rabs c + 1) * C), K. split; auto. split; [positive|]. split; auto.
  split; [intros r Hr; rewrite P0; auto|]. intros i r Hr. destruct (DP i r Hr) as (D & B).
  split; [apply is_derive_scal; auto|]. rewrite Rabs_mult, !Rmult_assoc.
  apply Rmult_le_compat; auto using Rabs_pos; lra.
Qed.

Lemma analytic_const c t : analytic_at (fun _ => c) t.
Proof.
  pose proof (Rabs_pos c). exists (fun i _ => match i with O => c | S _ => 0 end), 1, (Rabs c + 1), 1.
  split; [lra|]. split; [lra|]. split; [lra|]. split; [auto|]. intros i r _. split; [destruct i; auto_derive; auto|].
  rewrite pow1, Rmult_1_r. assert (1 <= INR (fact i)) by (apply (le_INR 1), lt_O_fact).
  destruct i; [|rewrite Rabs_R0]; nra.
Qed.

Lemma analytic_primitive f f' t : (forall r, is_derive f r (f' r)) -> analytic_at f' t -> analytic_at f t.
Proof.
  intros D (P & d & C & K & Hd & HC & HK & P0 & DP).
  destruct (continuous_near f t 1) as (d' & Hd' & Near); [apply @ex_derive_continuous; exists (f' t); apply D|lra|].
  set (K' := Rmax K 1). assert (K <= K') by apply Rmax_l. assert (1 <= K') by apply Rmax_r.
  set (C' := Rabs (f t) + 1 + C). pose proof (Rabs_pos (f t)).
  exists (fun i => match i with O => f | S i => P i end), (Rmin d d'), C', K'. pose proof (Rmin_l d d').
  pose proof (Rmin_r d d'). split; [positive|]. split; [unfold C'; lra|]. split; [lra|]. split; [auto|]. intros i r Hr.
  destruct i as [|i].
  - split; [rewrite P0 by lra; apply D|]. simpl. rewrite !Rmult_1_r. specialize (Near r ltac:(lra)).
    pose proof (Rabs_triang_inv (f r) (f t)). unfold C'. lra.
  - destruct (DP i r ltac:(lra)) as (Di & B). split; auto. eapply Rle_trans; [exact B|].
    assert (Pw : 0 < K ^ i) by positive. assert (0 <= INR (fact i)) by apply pos_INR.
    assert (INR (fact i) <= INR (fact (S i))) by (apply le_INR, fact_le; lia). assert (K ^ i <= K' ^ S i).
    { apply Rle_trans with (K' ^ i); [apply pow_incr; lra|]. apply Rle_pow; [auto|lia]. }
    apply Rmult_le_compat; auto; [positive|]. apply Rmult_le_compat; try lra. unfold C'. lra.
Qed.

(** powers of the time since a *)
Lemma analytic_power a n t : analytic_at (fun r => (r - a) ^ n) t.
Proof.
  induction n as [|n IH]; [exact (analytic_const 1 t)|].
  apply analytic_primitive with (fun r => INR (S n) * (r - a) ^ n); [|apply analytic_scal, IH].
  intros r. auto_derive; auto. change (match n with 0%nat => 1 | S _ => INR n + 1 end) with (INR (S n)).
  unfold Rminus. ring.
Qed.

Lemma analytic_sine om phi t : analytic_at (fun r => sin (om * r + phi)) t.
Proof.
  pose proof (Rabs_pos om). exists (fun i r => om ^ i * sin (om * r + phi + INR i * (PI / 2))), 1, 1, (Rabs om + 1).
  split; [lra|]. split; [lra|]. split; [lra|]. split; [intros r _; simpl; rewrite Rmult_0_l, Rplus_0_r; ring|].
  intros i r _. split.
  - rewrite S_INR. auto_derive; auto. replace (om * r + phi + (INR i + 1) * (PI / 2)) with (PI / 2 + (om * r + phi +
    INR i * (PI / 2))) by field. rewrite <- cos_sin. simpl. ring.
  - rewrite Rmult_1_l, Rabs_mult, <- RPow_abs. pose proof (pow_le (Rabs om) i (Rabs_pos _)).
    pose proof (pow_incr (Rabs om) (Rabs om + 1) i ltac:(lra)).
    assert (1 <= INR (fact i)) by (apply (le_INR 1), lt_O_fact).
    assert (Rabs (sin (om * r + phi + INR i * (PI / 2))) <= 1) by (apply Rabs_le, SIN_bound). nra.
Qed.

(** a function that runs from a on, forwards or backwards *)
Lemma analytic_from f a e t : e = 1 \/ e = -1 -> analytic_at f (a + e * t) -> analytic_at (fun r => f (a + e * r)) t.
Proof.
  intros He (P & d & C & K & Hd & HC & HK & P0 & DP). exists (fun i r => e ^ i * P i (a + e * r)), d, C, K.
  assert (E1 : forall i, Rabs (e ^ i) = 1).
  { intros i. rewrite <- RPow_abs. replace (Rabs e) with 1 by (unfold Rabs; destruct Rcase_abs; lra). apply pow1. }
  assert (In : forall r, Rabs (r - t) < d -> Rabs (a + e * r - (a + e * t)) < d).
  { intros r. replace (a + e * r - (a + e * t)) with (e ^ 1 * (r - t)) by ring. rewrite Rabs_mult, E1. lra. }
  repeat (split; [assumption|]). split; [intros r Hr; rewrite P0 by auto; ring|]. intros i r Hr.
  destruct (DP i _ (In r Hr)) as (D & B). split; [|rewrite Rabs_mult, E1, Rmult_1_l; auto]. evar_last.
  { apply is_derive_scal, (is_derive_comp (P i) (fun r => a + e * r)); [exact D|auto_derive; auto]. }
  unfold scal; simpl. unfold mult; simpl. ring.
Qed.

Lemma analytic_shift f t T : analytic_at f (T + t) -> analytic_at (fun r => f (T + r)) t.
Proof.
  intros A. apply (analytic_near (fun r => f (T + 1 * r)) _ t 1 Rlt_0_1); [intros; f_equal; ring|].
  apply analytic_from; auto. rewrite Rmult_1_l. auto.
Qed.

(** a function that is analytic at t goes one way next to it, on either side *)
Theorem analytic_one_way f t e : e = 1 \/ e = -1 -> analytic_at f t -> one_way f t e.
Proof.
  intros He A. assert (A0 : analytic_at (fun h => f (t + e * h)) 0).
  { apply analytic_from; auto. rewrite Rmult_0_r, Rplus_0_r. auto. }
  destruct (analytic_plus _ _ _ A0 (analytic_const (- f t) 0)) as (P & d & C & K & Hd & HC & HK & P0 & DP).
  assert (In : forall h, 0 <= h < d -> Rabs (h - 0) < d) by (intros; rewrite Rminus_0_r, Rabs_pos_eq; lra).
  destruct (rises_or_not P d Hd) with (C := C) (K := K) as (c & Hc & W); auto;
    try (intros; apply DP; rewrite Rminus_0_r; auto).
  { rewrite P0, Rmult_0_r, Rplus_0_r by (apply In; lra). ring. }
  exists c. split; [lra|]. destruct W as [W|W]; [left|right].
  - intros h Hh. specialize (W h Hh). rewrite P0 in W by (apply In; lra). lra.
  - intros h h' Hh Hh'. specialize (W h h' Hh Hh'). rewrite !P0 in W by (apply In; lra). lra.
Qed.

(** a polynomial, by its coefficients and powers, plus sinusoids, by amplitude, frequency and phase: a piece of a
  force *)
Definition piece (powers : list (R * nat)) (sines : list (R * R * R)) (r : R) :=
  fold_right (fun p z => fst p * r ^ snd p + z) 0 powers +
  fold_right (fun p z => fst (fst p) * sin (snd (fst p) * r + snd p) + z) 0 sines.

Theorem analytic_piece powers sines t : analytic_at (piece powers sines) t.
Proof.
  apply analytic_plus.
  - induction powers as [|(c, n) later IH]; simpl; [apply analytic_const|]. apply analytic_plus; auto.
    apply analytic_scal. apply (analytic_near (fun r => (r - 0) ^ n) _ t 1 Rlt_0_1).
    { intros r _. rewrite Rminus_0_r. auto. } apply analytic_power.
  - induction sines as [|((c, om), phi) later IH]; simpl; [apply analytic_const|]. apply analytic_plus; auto.
    apply analytic_scal, analytic_sine.
Qed.

(** *** Functions that are analytic by pieces *)

(** next to every time, on either side, u is an analytic function; at a time itself the later one is meant *)
Definition piecewise_analytic (u : R -> R) := forall t, 0 <= t -> exists f g d, 0 < d /\ analytic_at f t /\
  analytic_at g t /\
  (forall r, t <= r < t + d -> u r = g r) /\ (forall r, 0 <= r -> t - d < r < t -> u r = f r).


(** *** Polynomials plus sinusoids, by pieces, are such forces: the pieces begin at the times of a list *)
Fixpoint by_pieces (first : R -> R) (later : list (R * (R -> R))) (t : R) :=
  match later with
  | nil => first t
  | (t1, f) :: rest => if Rlt_dec t t1 then first t else by_pieces f rest t
  end.

Lemma by_pieces_analytic first later : (forall t, analytic_at first t) -> (forall p, In p later -> forall t,
  analytic_at (snd p) t) ->
  piecewise_analytic (by_pieces first later).
Proof.
  revert first. induction later as [|(t1, f) rest IH]; intros first A0 A.
  - intros t _. exists first, first, 1. repeat split; auto; lra.
  - intros t Ht. destruct (IH f (fun t => A (t1, f) (or_introl eq_refl) t) (fun p Hp => A p (or_intror Hp)) t Ht)
      as (f' & g' & d & Hd & Af & Ag & Eg & Ef).
    assert (Early : forall r, r < t1 -> by_pieces first ((t1, f) :: rest) r = first r)
      by (intros r Hr; simpl; destruct (Rlt_dec r t1); auto; lra).
    assert (Late : forall r, t1 <= r -> by_pieces first ((t1, f) :: rest) r = by_pieces f rest r)
      by (intros r Hr; simpl; destruct (Rlt_dec r t1); auto; lra).
    destruct (Rtotal_order t t1) as [Lt|[->|Gt]].
    + exists first, first, (t1 - t). repeat split; auto; try lra; intros; apply Early; lra.
    + exists first, g', d. repeat split; auto; intros; [rewrite Late by lra; auto|apply Early; lra].
    + exists f', g', (Rmin d (t - t1)). pose proof (Rmin_l d (t - t1)). pose proof (Rmin_r d (t - t1)).
      split; [positive|]. repeat split; auto; intros; rewrite Late by lra; [apply Eg|apply Ef]; lra.
Qed.

(** [scenes-analytic] Piecewise polynomials plus sinusoids are piecewise analytic. *)
Theorem scenes_are_analytic first later : piecewise_analytic (by_pieces (piece (fst first) (snd first))
  (map (fun p => (fst p, piece (fst (snd p)) (snd (snd p)))) later)).
Proof.
  apply by_pieces_analytic; [apply analytic_piece|]. intros p Hp t. apply in_map_iff in Hp. destruct Hp as (z & <- & _).
  apply analytic_piece.
Qed.
