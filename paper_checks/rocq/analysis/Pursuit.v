(** Tools for existence: a function that chases another one as fast as a bound B of its increments allows, as a supremum
    of subsolutions (Perron); integrals of functions that are continuous on [0, +oo); the fixed point of a map of two
    functions that halves their distances. *)
From InertialPair Require Import Dini.

(** the least upper bound as a number (no choice) *)
Lemma lub_real (A : R -> Prop) m M : A m -> (forall y, A y -> y <= M) ->
  (forall y, A y -> y <= real (Lub_Rbar A)) /\ (forall B, (forall y, A y -> y <= B) -> real (Lub_Rbar A) <= B).
Proof.
  intros Am AM. destruct (completeness A) as (l & Ub & Lub); [exists M; exact AM|eauto|]. assert (E : Lub_Rbar A = l).
  { apply is_lub_Rbar_unique. split; [exact Ub|]. intros [B| |] HB; simpl; [apply Lub; exact HB|auto|exact (HB m Am)]. }
  rewrite E. auto.
Qed.

(** a bound times a factor *)
Lemma abs_scal c y B : 0 <= c -> Rabs y <= B -> Rabs (c * y) <= c * B.
Proof. intros Hc HB. rewrite Rabs_mult, (Rabs_pos_eq c) by auto. scale. Qed.

(** ** The pursuer: from 0, towards c, where it is not there with all the speed that B allows *)
Section Pursuit.
Context (B c : R -> R) (CB : cont B) (MB : forall r t, 0 <= r <= t -> B r <= B t).

(** subsolutions on [0, t]: their increments are at most those of B, and above c they fall as B rises *)
Definition below t (z : R -> R) :=
  z 0 <= 0 /\ (forall p q, 0 <= p <= q -> q <= t -> - (B q - B p) <= z q - z p <= B q - B p) /\
  forall p q, 0 <= p <= q -> q <= t -> (forall u, p <= u <= q -> c u < z u) -> z q <= z p - (B q - B p).

(** the pursuer: the supremum of them *)
Definition pursuit t := real (Lub_Rbar (fun y => exists z, below t z /\ y = z t)).

(** what falls as B rises is one of them *)
Lemma below_fall t : below t (fun u => B 0 - B u).
Proof. split; [lra|]. split; intros p q Hp Hq; pose proof (MB p q Hp); intros; lra. Qed.

(** it is their least upper bound *)
Lemma pursuit_lub t : 0 <= t -> (forall z, below t z -> z t <= pursuit t) /\
  (forall y, (forall z, below t z -> z t <= y) -> pursuit t <= y).
Proof.
  intros Ht. destruct (lub_real (fun y => exists z, below t z /\ y = z t) (B 0 - B t) (B t - B 0)) as (U & L).
  { exists (fun u => B 0 - B u); split; auto. apply below_fall. }
  { intros y (z & (Z & Lz & _) & ->). specialize (Lz 0 t ltac:(lra) ltac:(lra)). lra. }
  split; [intros z Hz; apply U; exists z; auto|]. intros y Hy. apply L. intros y' (z & Hz & ->). auto.
Qed.

(** a subsolution may go on falling as B rises, and rising with it as long as it stays below c *)
Lemma below_on z r t k : 0 <= r <= t -> below r z ->
  k = -1 \/ (k = 1 /\ forall u, r <= u <= t -> z r + (B u - B r) <= c u) ->
  below t (fun u => if Rle_dec u r then z u else z r + k * (B u - B r)).
Proof.
  intros Hr (Z & Lz & Fz) Hk. split; [destruct (Rle_dec 0 r); lra|]. split.
  - intros p q Hp Hq. pose proof (MB p q Hp) as Mp. destruct (Rle_dec p r), (Rle_dec q r); try lra.
    + apply Lz; lra.
    + pose proof (Lz p r ltac:(lra) ltac:(lra)). pose proof (MB r q ltac:(lra)). destruct Hk as [->|(-> & _)]; lra.
    + destruct Hk as [->|(-> & _)]; lra.
  - intros p q Hp Hq O. destruct (Rle_dec q r) as [Q|Q].
    { destruct (Rle_dec p r); [|lra]. apply Fz; try lra. intros u Hu. specialize (O u Hu).
      destruct (Rle_dec u r); lra. }
    destruct Hk as [->|(-> & Bl)].
    + destruct (Rle_dec p r); [|lra]. assert (z r <= z p - (B r - B p)); [|lra].
      apply Fz; try lra. intros u Hu. specialize (O u ltac:(lra)). destruct (Rle_dec u r); lra.
    + specialize (O q ltac:(lra)). destruct (Rle_dec q r); [lra|]. specialize (Bl q ltac:(lra)). lra.
Qed.
Lemma below_less r t z : r <= t -> below t z -> below r z.
Proof. intros Hr (Z & Lz & Fz). repeat split; auto; intros; try (apply Lz; lra). apply Fz; auto; lra. Qed.

Lemma pursuit_0 : pursuit 0 = 0.
Proof.
  destruct (pursuit_lub 0 (Rle_refl 0)) as (U & L). apply Rle_antisym.
  - apply L. intros z (Z & _). auto.
  - specialize (U _ (below_fall 0)). lra.
Qed.

(** its increments are at most those of B *)
Lemma pursuit_lip r t : 0 <= r <= t -> - (B t - B r) <= pursuit t - pursuit r <= B t - B r.
Proof.
  intros Hr. destruct (pursuit_lub r ltac:(lra)) as (Ur & Lr). destruct (pursuit_lub t ltac:(lra)) as (Ut & Lt). split.
  - assert (pursuit r <= pursuit t + (B t - B r)); [|lra]. apply Lr. intros z Hz.
    pose proof (Ut _ (below_on z r t (-1) Hr Hz (or_introl eq_refl))) as Q. cbv beta in Q.
    destruct (Rle_dec t r); [replace t with r in * by lra|]; lra.
  - assert (pursuit t <= pursuit r + (B t - B r)); [|lra]. apply Lt. intros z Hz.
    pose proof (Ur z (below_less r t z ltac:(lra) Hz)). destruct Hz as (_ & Lz & _).
    specialize (Lz r t ltac:(lra) ltac:(lra)). lra.
Qed.
Lemma pursuit_cont : cont pursuit.
Proof.
  intros t Ht e He. destruct (CB t Ht e He) as (d & Hd & K). exists d; split; auto. intros s Hs Hd'.
  specialize (K s Hs Hd'). apply Rabs_def2 in K. destruct (Rle_dec s t) as [Le|].
  - pose proof (pursuit_lip s t ltac:(lra)). apply Rabs_def1; lra.
  - pose proof (pursuit_lip t s ltac:(lra)). apply Rabs_def1; lra.
Qed.

Hypothesis Cc : cont c.
(** near a time at which it is g away from c *)
Let near t g : 0 <= t -> 0 < g -> exists d, 0 < d /\ forall u, t <= u < t + d -> Rabs (c u - c t) < g / 4 /\ B u - B t < g / 8.
Proof.
  intros Ht Hg. destruct (Cc t Ht (g / 4)) as (d1 & H1 & K1); [lra|].
  destruct (CB t Ht (g / 8)) as (d2 & H2 & K2); [lra|]. smaller d1 d2. intros u Hu.
  assert (A : Rabs (u - t) < Rmin d1 d2) by (rewrite Rabs_pos_eq; lra). split; [apply K1; lra|].
  specialize (K2 u ltac:(lra) ltac:(lra)). apply Rabs_def2 in K2. lra.
Qed.

(** apart from c it moves as B does, towards c *)
Lemma pursuit_moves t k be : 0 <= t -> k = 1 \/ k = -1 -> 0 < k * (c t - pursuit t) -> rderiv B t be ->
  rderiv pursuit t (k * be).
Proof.
  intros Ht Hk Apart DB. set (g := k * (c t - pursuit t)) in *. destruct (near t g Ht Apart) as (d & Hd & K).
  apply rderiv_near with (fun u => pursuit t + k * (B u - B t)) d; auto.
  - intros u Hu. destruct (Req_dec u t) as [->|N]; [ring|]. destruct (K u Hu) as (_ & Bu).
    pose proof (pursuit_lip t u ltac:(lra)) as Li. destruct (pursuit_lub t Ht) as (U & L).
    destruct (pursuit_lub u ltac:(lra)) as (U' & L'). destruct Hk as [-> | ->].
    + assert (pursuit t <= pursuit u - (B u - B t)); [|lra]. apply L. intros z Hz. pose proof (U z Hz).
      assert (Q : below u (fun v => if Rle_dec v t then z v else z t + 1 * (B v - B t))).
      { apply below_on; auto; [lra|]. right; split; auto. intros v Hv. destruct (K v ltac:(lra)) as (Cv & Bv).
        apply Rabs_def2 in Cv. unfold g in *. lra. }
      pose proof (U' _ Q) as W. cbv beta in W. destruct (Rle_dec u t); lra.
    + assert (pursuit u <= pursuit t - (B u - B t)); [|lra]. apply L'. intros z Hz.
      pose proof (U z (below_less t u z ltac:(lra) Hz)). destruct Hz as (_ & Lz & Fz).
      destruct (Rle_dec (z u) (pursuit t - (B u - B t))) as [|No]; auto. assert (z u <= z t - (B u - B t)); [|lra].
      apply Fz; try lra. intros v Hv. specialize (Lz v u ltac:(lra) ltac:(lra)). destruct (K v ltac:(lra)) as (Cv & _).
      pose proof (MB t v ltac:(lra)). apply Rabs_def2 in Cv. unfold g in *. lra.
  - apply rderiv_eq with (0 + k * (be - 0)); [ring|].
    apply rderiv_plus; [apply rderiv_const|apply rderiv_scal, rderiv_minus; [auto|apply rderiv_const]].
Qed.
End Pursuit.

(** two pursuers part by no more than what they chase, and the integral A of the difference of their speeds *)
Lemma pursuits_near B B' c c' be be' A M t : cont B -> cont B' -> cont c -> cont c' -> cont A ->
  (forall r t, 0 <= r <= t -> B r <= B t) -> (forall r t, 0 <= r <= t -> B' r <= B' t) -> (forall u, 0 <= A u) -> 0 <= M -> 0 <= t ->
  (forall u, 0 <= u < t -> rderiv B u (be u) /\ rderiv B' u (be' u) /\ exists a, Rabs (be u - be' u) <= a /\ rderiv A u a) ->
  (forall u, 0 <= u <= t -> c u <= c' u + M) -> pursuit B c t <= pursuit B' c' t + M + A t.
Proof.
  intros CB CB' Cc Cc' CA MB MB' A0 HM Ht D Near. apply le_epsilon. intros e He.
  assert (pursuit B c t - pursuit B' c' t - A t <= M + e); [|lra].
  apply (barrier_until (fun u => pursuit B c u - pursuit B' c' u - A u) (M + e) 0 t); [|lra| |].
  - repeat apply cont_minus; auto using pursuit_cont.
  - rewrite !pursuit_0 by auto. specialize (A0 0). lra.
  - intros u Hu Far. specialize (A0 u). destruct (D u Hu) as (DB & DB' & a & Ha & DA). specialize (Near u ltac:(lra)).
    apply Rabs_inv in Ha.
    assert (exists G g, g <= a /\ rderiv G u g /\ forall h, 0 < h -> pursuit B c (u + h) - pursuit B' c' (u + h) -
      (pursuit B c u - pursuit B' c' u) <= G (u + h) - G u) as (G & g & Hg & DG & Le).
    { destruct (Rlt_dec (c u) (pursuit B c u)) as [Up|No].
      - exists (fun u => pursuit B c u + B' u), (-1 * be u + be' u). split; [lra|]. split.
        + apply rderiv_plus; [apply pursuit_moves; auto; lra|auto].
        + intros h Hh. pose proof (pursuit_lip B' c' MB' u (u + h) ltac:(lra)). lra.
      - exists (fun u => B u - pursuit B' c' u), (be u - 1 * be' u). split; [lra|]. split.
        + apply rderiv_minus; [auto|apply pursuit_moves; auto; lra].
        + intros h Hh. pose proof (pursuit_lip B c MB u (u + h) ltac:(lra)). lra. }
    intros q Hq. destruct (rderiv_minus _ _ _ _ _ DG DA q Hq) as (d & Hd & K). exists d. split; auto. intros h Hh.
    specialize (K h Hh). specialize (Le h ltac:(lra)). apply Rabs_inv in K. nra.
Qed.

Lemma rderiv_exact f t l d : 0 < d -> (forall h, 0 < h < d -> f (t + h) - f t = l * h) -> rderiv f t l.
Proof. intros Hd F e He. exists d; split; auto. intros h Hh. rewrite Rminus_diag_eq, Rabs_R0 by auto. nra. Qed.

(** ** Integrals of functions that are continuous on [0, +oo) *)
Definition integral (f : R -> R) (t : R) : R := RInt (fun u => f (Rmax 0 u)) 0 t.

Lemma integral_derive f t : cont f -> is_derive (integral f) t (f (Rmax 0 t)).
Proof.
  intros C. apply (is_derive_RInt (fun u => f (Rmax 0 u)) (integral f) 0 t); [|apply cont_iff; auto].
  exists (mkposreal 1 Rlt_0_1). intros u _. apply (RInt_correct (V := R_CompleteNormedModule)).
  apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros r _. apply (proj1 (cont_iff f) C).
Qed.

Lemma integral_rderiv f t : cont f -> 0 <= t -> rderiv (integral f) t (f t).
Proof. intros C Ht. pose proof (rderiv_of_derive _ _ _ (integral_derive f t C)) as Q.
  rewrite Rmax_right in Q by lra. auto. Qed.

Lemma integral_cont f : cont f -> cont (integral f).
Proof. intros C. apply cont_of_derive with (fun t => f (Rmax 0 t)). intros; apply integral_derive; auto. Qed.

Lemma integral_0 f : integral f 0 = 0.
Proof. unfold integral. rewrite RInt_point. reflexivity. Qed.

(** the weight exp (l t) makes integration a contraction *)
Lemma integral_near f g D l t : cont f -> cont g -> 0 < l -> 0 <= t ->
  (forall u, 0 <= u <= t -> Rabs (f u - g u) <= D * exp (l * u)) ->
    Rabs (integral f t - integral g t) <= D / l * exp (l * t).
Proof.
  intros Cf Cg Hl Ht B. assert (HD : 0 <= D). { pose proof (B 0 ltac:(lra)) as Q. rewrite Rmult_0_r, exp_0 in Q.
    pose proof (Rabs_pos (f 0 - g 0)). lra. }
  assert (Dl : 0 <= D / l) by positive.
  assert (RE : forall u, is_derive (fun u => D / l * exp (l * u)) u (D * exp (l * u))). { intros u.
    auto_derive; auto. field; lra. }
  apply abs_by. intros k Hk. assert (Q : k * (integral f t - integral g t) - D / l * exp (l * t) <= 0).
  { apply Rle_trans with (k * (integral f 0 - integral g 0) - D / l * exp (l * 0)).
    2: { rewrite !integral_0, Rmult_0_r, exp_0. lra. }
    apply (rderiv_mono (fun u => k * (integral f u - integral g u) - D / l * exp (l * u)) 0 t (fun u => k * (f u -
      g u) - D * exp (l * u))); [|lra|].
    - apply cont_minus; [apply cont_scal, cont_minus; apply integral_cont; auto|]. eapply cont_of_derive; exact RE.
    - intros u Hu. split.
      + apply rderiv_minus; [apply rderiv_scal, rderiv_minus; apply integral_rderiv; auto; lra|].
        apply rderiv_of_derive, RE.
      + pose proof (B u ltac:(lra)) as W. apply Rabs_inv in W. destruct Hk; subst k; lra. }
  lra.
Qed.

(** powers of 1/2 become small *)
Lemma small q e : 0 < q -> 0 < e -> exists n, q * (/ 2) ^ n < e.
Proof.
  intros Hq He. destruct (pow_lt_1_zero (/ 2)) with (y := e / q) as (n & N).
  { rewrite Rabs_pos_eq; lra. } { positive. }
  exists n. specialize (N n (le_n n)). rewrite Rabs_pos_eq in N by (apply pow_le; lra).
  apply Rmult_lt_compat_l with (r := q) in N; auto. replace (q * (e / q)) with e in N by (field; lra). auto.
Qed.

Lemma cont_bounded f t : cont f -> 0 <= t -> exists B, forall u, 0 <= u <= t -> Rabs (f u) <= B.
Proof.
  intros C Ht. set (g := fun u => Rabs (f (Rmax 0 u))). assert (CG : forall u, 0 <= u <= t -> continuity_pt g u).
  { intros u _. apply continuity_pt_filterlim. apply (proj1 (cont_iff _) (cont_abs f C)). }
  destruct (continuity_ab_maj g 0 t Ht CG) as (m & Hm & _). exists (g m). intros u Hu. specialize (Hm u Hu).
  unfold g in Hm at 1. rewrite Rmax_right in Hm by lra. auto.
Qed.

(** a sequence whose steps are halved each time comes to its limit at that rate *)
Lemma halving (a : nat -> R) c : (forall n, Rabs (a (S n) - a n) <= c * (/ 2) ^ n) ->
  forall n, Rabs (real (Lim_seq a) - a n) <= 2 * c * (/ 2) ^ n.
Proof.
  intros St n. set (lo := fun n => a n - 2 * c * (/ 2) ^ n). set (hi := fun n => a n + 2 * c * (/ 2) ^ n).
  assert (Near : forall j, lo j <= lo (S j) /\ hi (S j) <= hi j /\ lo j <= a j <= hi j).
  { intros j. specialize (St j). pose proof (Rabs_pos (a (S j) - a j)). apply Rabs_inv in St.
    unfold lo, hi; simpl. lra. }
  destruct (ex_lim_seq_adj lo hi) as ((l & Hl) & (k & Hk) & E); try apply Near.
  { apply is_lim_seq_ext with (fun j => 4 * c * (/ 2) ^ j); [intros; unfold lo, hi; ring|].
    replace (Finite 0) with (Rbar_mult (4 * c) 0) by (simpl; f_equal; ring).
    apply is_lim_seq_scal_l, is_lim_seq_geom. rewrite Rabs_pos_eq; lra. }
  rewrite (is_lim_seq_unique _ _ Hl), (is_lim_seq_unique _ _ Hk) in E. injection E as <-.
  rewrite (is_lim_seq_unique a l) by (apply (is_lim_seq_le_le lo a hi); auto; apply Near).
  pose proof (is_lim_seq_incr_compare _ _ Hl (fun j => proj1 (Near j)) n).
  pose proof (is_lim_seq_decr_compare _ _ Hk (fun j => proj1 (proj2 (Near j))) n).
  unfold lo, hi in *. apply Rabs_le. simpl. lra.
Qed.

(** ** The fixed point of a map of several functions that halves their distances, weighed by exp (lam t) *)
Section Fixed.
Variables (next : (bool -> R -> R) -> bool -> R -> R) (lam : R).
Hypotheses (Hl : 0 <= lam) (Cn : forall f, (forall i, cont (f i)) -> forall i, cont (next f i)).
Hypothesis Half : forall f g D T, (forall i, cont (f i)) -> (forall i, cont (g i)) -> 0 <= D ->
  (forall i u, 0 <= u <= T -> Rabs (f i u - g i u) <= D * exp (lam * u)) ->
  forall i t, 0 <= t <= T -> Rabs (next f i t - next g i t) <= D / 2 * exp (lam * t).

Fixpoint iterate n : bool -> R -> R := match n with O => fun _ _ => 0 | S n => next (iterate n) end.
Lemma iterate_cont n i : cont (iterate n i).
Proof. revert i. induction n; intros i; simpl; [apply cont_const|apply Cn; auto]. Qed.

Let steps T : 0 <= T -> exists C, 0 < C /\ forall n i t, 0 <= t <= T ->
  Rabs (iterate (S n) i t - iterate n i t) <= C * (/ 2) ^ n * exp (lam * t).
Proof.
  intros HT.
  destruct (cont_bounded (fun t => Rabs (iterate 1 true t) + Rabs (iterate 1 false t)) T) as (B & HB); auto.
  { apply cont_plus; apply cont_abs, iterate_cont. }
  assert (B1 : forall i t, 0 <= t <= T -> Rabs (iterate 1 i t) <= B).
  { intros i t Ht. specialize (HB t Ht). apply Rabs_inv in HB. pose proof (Rabs_pos (iterate 1 true t)).
    pose proof (Rabs_pos (iterate 1 false t)). destruct i; lra. }
  pose proof (B1 true 0 ltac:(lra)). pose proof (Rabs_pos (iterate 1 true 0)). exists (1 + B). split; [lra|].
  induction n as [|n IH]; intros i t Ht.
  - rewrite Rminus_0_r. pose proof (exp_ineq1_le (lam * t)). assert (0 <= lam * t) by positive.
    specialize (B1 i t Ht). simpl pow. nra.
  - replace ((1 + B) * (/ 2) ^ S n) with ((1 + B) * (/ 2) ^ n / 2) by (simpl; field).
    apply (Half (iterate (S n)) (iterate n) _ T); auto using iterate_cont. apply Rmult_le_pos; [lra|apply pow_le; lra].
Qed.

Let limit i t := real (Lim_seq (fun n => iterate n i t)).
Let limit_near T : 0 <= T -> exists C, 0 < C /\ forall n i t, 0 <= t <= T ->
  Rabs (limit i t - iterate n i t) <= C * (/ 2) ^ n.
Proof.
  intros HT. destruct (steps T HT) as (C & HC & St). pose proof (exp_pos (lam * T)).
  exists (2 * (C * exp (lam * T))). split; [positive|]. intros n i t Ht.
  apply (halving (fun n => iterate n i t)). intros j. eapply Rle_trans; [apply St; auto|].
  assert (exp (lam * t) <= exp (lam * T)).
  { destruct (Req_dec (lam * t) (lam * T)) as [->|N]; [lra|]. apply Rlt_le, exp_increasing. nra. }
  rewrite !Rmult_assoc, (Rmult_comm (exp _)). repeat apply Rmult_le_compat_l; auto; [lra|apply pow_le; lra].
Qed.
Let limit_cont i : cont (limit i).
Proof.
  intros t Ht e He. destruct (limit_near (t + 1) ltac:(lra)) as (C & HC & Near).
  destruct (small C (e / 3)) as (n & Hn); [lra|lra|].
  destruct (iterate_cont n i t Ht (e / 3)) as (d & Hd & Kd); [lra|]. smaller d 1. intros u Hu Hd1.
  specialize (Kd u Hu ltac:(lra)). assert (Q : Rabs (u - t) < 1) by lra. apply Rabs_def2 in Q, Kd.
  pose proof (Near n i u ltac:(lra)) as B. pose proof (Near n i t ltac:(lra)) as B'. apply Rabs_inv in B, B'.
  apply Rabs_def1; lra.
Qed.

Theorem fixed_point : exists f, (forall i, cont (f i)) /\ forall i t, 0 <= t -> next f i t = f i t.
Proof.
  exists limit. split; [exact limit_cont|]. intros i t Ht. apply cond_eq. intros e He.
  destruct (limit_near t Ht) as (C & HC & Near). pose proof (exp_pos (lam * t)).
  destruct (small (C * (exp (lam * t) + 1)) e) as (n & Hn); [positive|auto|].
  pose proof (pow_le (/ 2) n ltac:(lra)). assert (D : 0 <= C * (/ 2) ^ n) by positive.
  assert (A : Rabs (next limit i t - iterate (S n) i t) <= C * (/ 2) ^ n / 2 * exp (lam * t)).
  { apply (Half limit (iterate n) _ t); auto using iterate_cont; [|lra]. intros j u Hu.
    specialize (Near n j u Hu). pose proof (exp_ineq1_le (lam * u)). assert (0 <= lam * u) by positive. nra. }
  pose proof (Near (S n) i t ltac:(lra)) as Q. simpl pow in Q. apply Rabs_inv in A, Q. apply Rabs_def1; nra.
Qed.
End Fixed.
