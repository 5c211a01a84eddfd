(** Free motions in closed form: from one event to the next the state is a wave. When a wave is positive,
    its first root, and what a motion does until then: a slip up to its next contact, a stick up to its edge.
    Damping may be below, at or beyond its critical value. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick Chase Forced ForcedExistence Arcs.
Local Open Scope R_scope.

(** *** Waves *)
(** the cosine and the sine of a frequency whose square is d, which need not be positive: cos (w u) and sin (w u) / w,
    cosh (w u) and sinh (w u) / w, or 1 and u *)
Definition cosine d u :=
  if Rlt_dec 0 d then cos (sqrt (Rabs d) * u) else if Rlt_dec d 0 then cosh (sqrt (Rabs d) * u) else 1.
(** the sine *)
Definition sine d u :=
  if Rlt_dec 0 d then sin (sqrt (Rabs d) * u) / sqrt (Rabs d)
  else if Rlt_dec d 0 then sinh (sqrt (Rabs d) * u) / sqrt (Rabs d) else u.

(** the frequency *)
Lemma frequency_sq d : d <> 0 -> 0 < sqrt (Rabs d) /\ sqrt (Rabs d) * sqrt (Rabs d) = Rabs d.
Proof. intros N. pose proof (Rabs_pos_lt d N). split; [apply sqrt_lt_R0; auto|apply sqrt_sqrt; lra]. Qed.
(** the derivative of the cosine *)
Lemma derive_cosine d u : is_derive (cosine d) u (- (d * sine d u)).
Proof.
  unfold cosine, sine. destruct (Rlt_dec 0 d) as [P|P]; [|destruct (Rlt_dec d 0) as [N|N]].
  - destruct (frequency_sq d ltac:(lra)) as (W & E). rewrite (Rabs_pos_eq d) in * by lra. set (w := sqrt d) in *.
    clearbody w. subst d. auto_derive; auto. field; lra.
  - destruct (frequency_sq d ltac:(lra)) as (W & E). rewrite (Rabs_left d) in * by lra. set (w := sqrt (- d)) in *.
    clearbody w. replace d with (- (w * w)) by lra. unfold cosh, sinh. auto_derive; auto. field; lra.
  - assert (d = 0) as -> by lra. auto_derive; auto. ring.
Qed.
(** and of the sine *)
Lemma derive_sine d u : is_derive (sine d) u (cosine d u).
Proof.
  unfold cosine, sine. destruct (Rlt_dec 0 d) as [P|P]; [|destruct (Rlt_dec d 0) as [N|N]].
  1, 2: destruct (frequency_sq d ltac:(lra)) as (W & _); unfold cosh, sinh; auto_derive; auto; field; lra.
  auto_derive; auto.
Qed.
(** the cosine now *)
Lemma cosine_0 d : cosine d 0 = 1.
Proof. unfold cosine, cosh. repeat destruct Rlt_dec; rewrite ?Rmult_0_r, ?Ropp_0, ?exp_0, ?cos_0; lra. Qed.
(** the sine now *)
Lemma sine_0 d : sine d 0 = 0.
Proof.
  unfold sine, sinh. repeat destruct Rlt_dec; auto; destruct (frequency_sq d ltac:(lra));
    rewrite Rmult_0_r, ?Ropp_0, ?exp_0, ?sin_0; field; lra.
Qed.

(** u -> still + drift u + exp (- decay u) (even cosine u + odd sine u); over the reals, and over intervals *)
Record wave (T : Type) := Wave { still : T; drift : T; even : T; odd : T; decay : T; square : T }.
Arguments Wave {T}. Arguments still {T}. Arguments drift {T}. Arguments even {T}. Arguments odd {T}.
Arguments decay {T}. Arguments square {T}.

(** its value at the time u *)
Definition val (f : wave R) u := still f + drift f * u +
  exp (- (decay f * u)) * (even f * cosine (square f) u + odd f * sine (square f) u).
(** its derivative is a wave *)
Definition slope (f : wave R) := Wave (drift f) 0 (odd f - decay f * even f)
  (- (square f * even f) - decay f * odd f) (decay f) (square f).

(** as said *)
Lemma derive_val f u : is_derive (val f) u (val (slope f) u).
Proof.
  pose proof (derive_cosine (square f) u) as C. pose proof (derive_sine (square f) u) as S.
  assert (EC : Derive (fun t => cosine (square f) t) u = - (square f * sine (square f) u)).
  { apply is_derive_unique, C. }
  assert (ES : Derive (fun t => sine (square f) t) u = cosine (square f) u) by (apply is_derive_unique, S).
  unfold val, slope; simpl. auto_derive; [repeat split; eexists; eauto|]. rewrite EC, ES. ring.
Qed.

(** its value now *)
Lemma val_0 f : val f 0 = still f + even f.
Proof. unfold val. rewrite !Rmult_0_r, Ropp_0, exp_0, cosine_0, sine_0. ring. Qed.

(** *** Positive on an interval *)
(** the mean value theorem *)
Lemma val_mean f p q : p < q -> exists c, p < c < q /\ val f q - val f p = val (slope f) c * (q - p).
Proof.
  intros Hp. destruct (MVT_cor2 (val f) (val (slope f)) p q Hp) as (c & E & Hc).
  - intros c _. apply is_derive_Reals, derive_val.
  - exists c; auto.
Qed.

Section Positive.
Variables (f : wave R) (p q : R).
Hypotheses (Hp : 0 < val f p) (Hq : 0 < val f q).

(** a rising one, from its start *)
Lemma rising_positive : (forall u, p <= u <= q -> 0 <= val (slope f) u) -> forall u, p <= u <= q -> 0 < val f u.
Proof.
  intros S u Hu. destruct (Req_dec u p) as [->|]; auto. destruct (val_mean f p u ltac:(lra)) as (c & Hc & E).
  specialize (S c ltac:(lra)). nra.
Qed.
(** a falling one, from its end *)
Lemma falling_positive : (forall u, p <= u <= q -> val (slope f) u <= 0) -> forall u, p <= u <= q -> 0 < val f u.
Proof.
  intros S u Hu. destruct (Req_dec u q) as [->|]; auto. destruct (val_mean f u q ltac:(lra)) as (c & Hc & E).
  specialize (S c ltac:(lra)). nra.
Qed.
(** a concave one, from both *)
Lemma concave_positive : (forall u, p <= u <= q -> val (slope (slope f)) u <= 0) -> forall u, p <= u <= q ->
  0 < val f u.
Proof.
  intros S u Hu. destruct (Rlt_dec 0 (val f u)); auto. exfalso.
  assert (u <> p) by (intros ->; lra). assert (u <> q) by (intros ->; lra).
  destruct (val_mean f p u ltac:(lra)) as (c & Hc & E). destruct (val_mean f u q ltac:(lra)) as (d & Hd & F).
  destruct (val_mean (slope f) c d ltac:(lra)) as (e & He & G). specialize (S e ltac:(lra)).
  assert (val (slope f) c < 0) by nra. assert (0 < val (slope f) d) by nra. nra.
Qed.
End Positive.

(** from 0 on, if it rises at first *)
Lemma leaves_zero f d : 0 <= val f 0 -> (forall u, 0 <= u <= d -> 0 < val (slope f) u) -> forall u, 0 < u <= d ->
  0 < val f u.
Proof.
  intros Z S u Hu. destruct (val_mean f 0 u ltac:(lra)) as (c & Hc & E). specialize (S c ltac:(lra)). nra.
Qed.

(** the first root of a continuous function that is positive for a while *)
Lemma first_root f lo hi : continuity f -> 0 < lo <= hi -> (forall u, 0 < u <= lo -> 0 < f u) -> f hi <= 0 ->
  exists tau, lo < tau <= hi /\ f tau = 0 /\ forall u, 0 < u < tau -> 0 < f u.
Proof.
  intros C Hl P N. set (A := fun r => lo <= r <= hi /\ forall u, 0 < u <= r -> 0 < f u).
  destruct (completeness A) as (c & Ub & Lub).
  { exists hi. intros r (Hr & _); lra. } { exists lo. split; [lra|auto]. }
  assert (Hc : lo <= c <= hi). { split; [apply Ub; split; [lra|auto]|]. apply Lub. intros r (Hr & _); lra. }
  assert (Before : forall u, 0 < u < c -> 0 < f u).
  { intros u Hu. destruct (Rlt_dec 0 (f u)); auto. exfalso. assert (c <= u); [|lra]. apply Lub. intros r (_ & Q).
    destruct (Rle_dec r u); auto. exfalso. specialize (Q u ltac:(lra)). lra. }
  assert (Z : f c = 0).
  { destruct (Rtotal_order (f c) 0) as [Neg|[Z|Pos]]; auto; exfalso.
    - destruct (C c (- f c) ltac:(lra)) as (d & Hd & K). set (u := Rmax (c / 2) (c - d / 2)).
      assert (c / 2 <= u) by apply Rmax_l. assert (c - d / 2 <= u) by apply Rmax_r.
      assert (u < c) by (apply Rmax_lub_lt; lra). specialize (Before u ltac:(lra)).
      assert (Q : Rabs (f u - f c) < - f c).
      { apply K. split; [split; [exact I|lra]|]. simpl. unfold R_dist. rewrite Rabs_left; lra. }
      apply Rabs_def2 in Q. lra.
    - assert (c < hi) by (destruct (Req_dec c hi) as [->|]; lra).
      destruct (C c (f c) Pos) as (d & Hd & K). set (u := Rmin hi (c + d / 2)).
      assert (u <= hi) by apply Rmin_l. assert (u <= c + d / 2) by apply Rmin_r.
      assert (c < u) by (apply Rmin_glb_lt; lra). assert (u <= c); [|lra]. apply Ub. split; [lra|]. intros r Hr.
      destruct (Rlt_dec r c); [apply Before; lra|]. destruct (Req_dec r c) as [->|]; auto.
      assert (Q : Rabs (f r - f c) < f c).
      { apply K. split; [split; [exact I|lra]|]. simpl. unfold R_dist. rewrite Rabs_pos_eq; lra. }
      apply Rabs_def2 in Q. lra. }
  exists c. repeat split; auto; [|lra]. destruct (Req_dec c lo) as [->|]; [|lra]. specialize (P lo ltac:(lra)). lra.
Qed.

(** the first root of a wave *)
Lemma wave_root f lo hi : 0 < lo <= hi -> (forall u, 0 < u <= lo -> 0 < val f u) -> val f hi <= 0 ->
  exists tau, lo < tau <= hi /\ val f tau = 0 /\ forall u, 0 < u < tau -> 0 < val f u.
Proof.
  apply first_root. intros u. apply derivable_continuous_pt. exists (val (slope f) u). apply is_derive_Reals,
    derive_val.
Qed.

(** *** The two kinds of motion *)
(** the rate at which the free swing of a mass m decays *)
Definition fade (m a1 : R) := a1 / (2 * m).

Section Motion.
Variables m1 m2 a1 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** the mass m on spring and damper about the place c, from the state (x, v) *)
Definition swing m c x v := Wave c 0 (x - c) (v + fade m a1 * (x - c)) (fade m a1) (a2 / m - fade m a1 * fade m a1).

(** it starts at x *)
Lemma swing_start m c x v : val (swing m c x v) 0 = x.
Proof. rewrite val_0. unfold swing; simpl. ring. Qed.
(** with the speed v *)
Lemma swing_speed m c x v : val (slope (swing m c x v)) 0 = v.
Proof. rewrite val_0. unfold swing; simpl. ring. Qed.
(** and obeys the law of motion *)
Lemma swing_law m c x v u : 0 < m -> m * val (slope (slope (swing m c x v))) u
  = a2 * (c - val (swing m c x v) u) - a1 * val (slope (swing m c x v)) u.
Proof.
  intros Hm. unfold val, slope, swing; simpl. set (d := a2 / m - fade m a1 * fade m a1) in *.
  set (g := fade m a1) in *. assert (E2 : a2 = m * (d + g * g)) by (unfold d; field; lra).
  assert (E1 : a1 = 2 * m * g) by (unfold g, fade; field; lra). clearbody d g. rewrite E1, E2. ring.
Qed.

Let M := m1 + m2.

(** a slip with v1 - v2 of the sign k: body 1 *)
Definition slide k x v1 := swing m1 (- (k * b / a2)) x v1.
(** k (v1 - v2) *)
Definition guard k x v1 v2 := let f := slope (slide k x v1) in
  Wave (- (k * v2)) (- (b / m2)) (k * even f) (k * odd f) (decay f) (square f).
(** a stick: both bodies *)
Definition stuck x v := swing M 0 x v.
(** what friction has left towards the side k *)
Definition grip k x v := let f := slope (slope (stuck x v)) in
  Wave (b / m2) 0 (- (k * even f)) (- (k * odd f)) (decay f) (square f).

(** as said *)
Lemma val_guard k x v1 v2 u : k = 1 \/ k = -1 ->
  val (guard k x v1 v2) u = k * (val (slope (slide k x v1)) u - (v2 + k * b / m2 * u)).
Proof.
  intros Hk. unfold guard. set (f := slope (slide k x v1)). assert (S : still f = 0) by reflexivity.
  assert (D : drift f = 0) by reflexivity. clearbody f. unfold val; simpl. rewrite S, D. destruct Hk; subst k; field;
    lra.
Qed.
(** as said *)
Lemma val_grip k x v u : val (grip k x v) u = b / m2 - k * val (slope (slope (stuck x v))) u.
Proof. unfold val, grip, stuck; simpl. ring. Qed.

(** at a contact it is 0 *)
Lemma guard_touch k x v : k = 1 \/ k = -1 -> val (guard k x v v) 0 = 0.
Proof. intros Hk. rewrite val_guard by auto. unfold slide. rewrite swing_speed by auto. destruct Hk; subst k; ring.
  Qed.
(** how it starts *)
Lemma guard_slope k x v1 v2 : k = 1 \/ k = -1 -> m1 * val (slope (guard k x v1 v2)) 0
  = - (k * (a2 * x + a1 * v1)) - b * M / m2.
Proof.
  intros Hk. replace (val (slope (guard k x v1 v2)) 0) with (k * val (slope (slope (slide k x v1))) 0 - b / m2).
  - replace (m1 * (k * val (slope (slope (slide k x v1))) 0 - b / m2))
      with (k * (m1 * val (slope (slope (slide k x v1))) 0) - m1 * b / m2) by (field; lra).
    unfold slide. rewrite swing_law, swing_start, swing_speed by auto. unfold M. destruct Hk; subst k; field; lra.
  - unfold val, guard; simpl. ring.
Qed.
(** on the edge towards k it starts at 0 with slope 0 *)
Lemma guard_edge k x v : k = 1 \/ k = -1 -> a2 * x + a1 * v = - (k * (b * M / m2)) -> val (slope (guard k x v v)) 0 = 0.
Proof.
  intros Hk E. pose proof (guard_slope k x v v Hk) as S. rewrite E in S. apply Rmult_eq_reg_l with m1; [|lra].
  rewrite S. destruct Hk; subst k; ring.
Qed.

(** there friction has nothing left for a stick *)
Lemma grip_edge k x v : k = 1 \/ k = -1 -> a2 * x + a1 * v = - (k * (b * M / m2)) -> val (grip k x v) 0 = 0.
Proof.
  intros Hk E. assert (HM : 0 < M) by (unfold M; lra). pose proof (swing_law M 0 x v 0 HM) as L.
  rewrite val_grip. unfold stuck. rewrite swing_start, swing_speed in L.
  replace (val (slope (slope (swing M 0 x v))) 0) with (k * (b / m2)).
  - destruct Hk; subst k; ring.
  - apply Rmult_eq_reg_l with M; [|lra]. rewrite L.
    replace (a2 * (0 - x) - a1 * v) with (- (a2 * x + a1 * v)) by ring. rewrite E. field. lra.
Qed.

Section Along.
Variables x v1 v2 s : R -> R.
Hypothesis H : solution m1 m2 a1 a2 b x v1 v2 s.
Variable t0 : R.
Hypothesis Ht0 : 0 <= t0.

(** a motion follows any arc that obeys the law of friction *)
Lemma along X V1 V2 g T : 0 <= T -> forced_arc m1 m2 a1 a2 b T (fun _ => 0) X V1 V2 g ->
  x t0 = X 0 -> v1 t0 = V1 0 -> v2 t0 = V2 0 ->
  forall u, 0 <= u <= T -> x (t0 + u) = X u /\ v1 (t0 + u) = V1 u /\ v2 (t0 + u) = V2 u.
Proof.
  intros HT A. apply (follow_arc m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb (fun _ => 0) (fun _ => 0) x v1 v2 s X V1 V2 g T
    t0); auto.
  - intros t _. apply rderiv_const.
  - apply free_case; auto.
Qed.

(** as long as the guard is not negative, a motion slips *)
Theorem slip_phase k T : k = 1 \/ k = -1 -> 0 <= T ->
  (forall u, 0 <= u < T -> 0 <= val (guard k (x t0) (v1 t0) (v2 t0)) u) -> forall u, 0 <= u <= T ->
  x (t0 + u) = val (slide k (x t0) (v1 t0)) u /\ v1 (t0 + u) = val (slope (slide k (x t0) (v1 t0))) u /\
  v2 (t0 + u) = v2 t0 + k * b / m2 * u.
Proof.
  intros Hk HT G.
  apply (along (val (slide k (x t0) (v1 t0))) (val (slope (slide k (x t0) (v1 t0)))) (fun u => v2 t0 + k * b / m2 * u)
    (fun _ => k)); auto; unfold slide.
  - constructor.
    + intros t. apply derive_val.
    + intros t. replace ((0 - a2 * val (swing m1 (- (k * b / a2)) (x t0) (v1 t0)) t - a1
      * val (slope (swing m1 (- (k * b /
        a2)) (x t0) (v1 t0))) t - b * k) / m1) with (val (slope (slope (swing m1 (- (k * b / a2)) (x t0) (v1 t0)))) t);
        [apply derive_val|].
      apply Rmult_eq_reg_l with m1; [|lra]. rewrite swing_law by auto. field; lra.
    + intros t. auto_derive; auto. field; lra.
    + intros t Ht. specialize (G t Ht). rewrite val_guard in G by auto. unfold slide in G.
      destruct Hk; subst k; (split; [lra|split; intros; lra]).
  - rewrite swing_start; auto.
  - rewrite swing_speed; auto.
  - ring.
Qed.

(** as long as friction holds, a motion sticks *)
Theorem stick_phase T : 0 <= T -> v1 t0 = v2 t0 ->
  (forall u, 0 <= u < T -> 0 <= val (grip 1 (x t0) (v1 t0)) u /\ 0 <= val (grip (-1) (x t0) (v1 t0)) u) ->
  forall u, 0 <= u <= T -> x (t0 + u) = val (stuck (x t0) (v1 t0)) u /\
  v1 (t0 + u) = val (slope (stuck (x t0) (v1 t0))) u /\ v2 (t0 + u) = val (slope (stuck (x t0) (v1 t0))) u.
Proof.
  intros HT Ev G. set (f := stuck (x t0) (v1 t0)) in *. assert (HM : 0 < M) by (unfold M; lra).
  assert (L : forall t, M * val (slope (slope f)) t = - (a2 * val f t) - a1 * val (slope f) t).
  { intros t. unfold f, stuck. rewrite swing_law by auto. ring. }
  apply (along (val f) (val (slope f)) (val (slope f)) (fun t => m2 / b * val (slope (slope f)) t)); auto.
  - constructor.
    + intros t. apply derive_val.
    + intros t. replace ((0 - a2 * val f t - a1 * val (slope f) t - b * (m2 / b * val (slope (slope f)) t)) / m1)
        with (val (slope (slope f)) t); [apply derive_val|].
      apply Rmult_eq_reg_l with m1; [|lra]. specialize (L t). unfold M in L. field_simplify; lra.
    + intros t. replace (b * (m2 / b * val (slope (slope f)) t) / m2) with (val (slope (slope f)) t) by (field; lra).
      apply derive_val.
    + intros t Ht. specialize (G t Ht). rewrite !val_grip in G. fold f in G. split; [|split; intros; lra].
      assert (0 < m2 / b) by (apply Rdiv_lt_0_compat; auto). assert (E : m2 / b * (b / m2) = 1) by (field; lra). nra.
  - unfold f, stuck. rewrite swing_start; auto.
  - unfold f, stuck. rewrite swing_speed; auto.
  - unfold f, stuck. rewrite swing_speed; auto.
Qed.

(** *** Phases with their ends *)
(** The slip to the next contact: the guard is positive until lo and not positive at hi. *)
Theorem slip_until k lo hi : k = 1 \/ k = -1 -> 0 < lo <= hi -> 0 <= val (guard k (x t0) (v1 t0) (v2 t0)) 0 ->
  (forall u, 0 < u <= lo -> 0 < val (guard k (x t0) (v1 t0) (v2 t0)) u) ->
  val (guard k (x t0) (v1 t0) (v2 t0)) hi <= 0 -> exists u, lo < u <= hi /\
  (forall r, 0 < r < u -> 0 < k * (v1 (t0 + r) - v2 (t0 + r))) /\ v1 (t0 + u) = v2 (t0 + u) /\
  x (t0 + u) = val (slide k (x t0) (v1 t0)) u /\ v2 (t0 + u) = v2 t0 + k * b / m2 * u.
Proof.
  intros Hk Hl Z P N. destruct (wave_root _ lo hi Hl P N) as (u & Hu & E & Q).
  assert (Nn : forall r, 0 <= r < u -> 0 <= val (guard k (x t0) (v1 t0) (v2 t0)) r).
  { intros r Hr. destruct (Req_dec r 0) as [->|]; auto. apply Rlt_le, Q; lra. }
  assert (F := slip_phase k u Hk ltac:(lra) Nn). exists u. split; [lra|].
  assert (D : forall r, 0 <= r <= u -> k * (v1 (t0 + r) - v2 (t0 + r)) = val (guard k (x t0) (v1 t0) (v2 t0)) r).
  { intros r Hr. destruct (F r Hr) as (_ & -> & ->). rewrite val_guard by auto. auto. }
  split; [|split].
  - intros r Hr. rewrite D by lra. apply Q; lra.
  - pose proof (D u ltac:(lra)) as Du. rewrite E in Du. destruct Hk; subst k; lra.
  - destruct (F u ltac:(lra)) as (? & _ & ?); auto.
Qed.

(** The stick to the edge towards k: friction has something left on both sides until lo, on the other one until hi, and
    nothing left on this one at hi. *)
Theorem stick_until k lo hi : k = 1 \/ k = -1 -> 0 < lo <= hi -> v1 t0 = v2 t0 -> 0 <= val (grip k (x t0) (v1 t0)) 0 ->
  (forall u, 0 < u <= lo -> 0 < val (grip k (x t0) (v1 t0)) u) ->
  (forall u, 0 <= u <= hi -> 0 <= val (grip (- k) (x t0) (v1 t0)) u) ->
  val (grip k (x t0) (v1 t0)) hi <= 0 -> exists u, lo < u <= hi /\
  (forall r, 0 <= r <= u -> v1 (t0 + r) = v2 (t0 + r)) /\
  a2 * x (t0 + u) + a1 * v1 (t0 + u) = - (k * (b * M / m2)) /\
  x (t0 + u) = val (stuck (x t0) (v1 t0)) u /\ v1 (t0 + u) = val (slope (stuck (x t0) (v1 t0))) u.
Proof.
  intros Hk Hl Ev Z P O N. assert (HM : 0 < M) by (unfold M; lra).
  destruct (wave_root _ lo hi Hl P N) as (u & Hu & E & Q).
  assert (Nn : forall r, 0 <= r < u -> 0 <= val (grip k (x t0) (v1 t0)) r).
  { intros r Hr. destruct (Req_dec r 0) as [->|]; auto. apply Rlt_le, Q; lra. }
  assert (Both : forall r, 0 <= r < u -> 0 <= val (grip 1 (x t0) (v1 t0)) r /\ 0 <= val (grip (-1) (x t0) (v1 t0)) r).
  { intros r Hr. specialize (O r ltac:(lra)). specialize (Nn r Hr).
    destruct Hk; subst k; [|replace (- -1) with 1 in O by ring]; replace (- (1)) with (-1) in * by ring; auto. }
  assert (F := stick_phase u ltac:(lra) Ev Both). exists u. split; [lra|].
  destruct (F u ltac:(lra)) as (Fx & F1 & _). repeat split; auto.
  - intros r Hr. destruct (F r Hr) as (_ & -> & ->). auto.
  - rewrite Fx, F1. rewrite val_grip in E. pose proof (swing_law M 0 (x t0) (v1 t0) u HM) as L.
    fold (stuck (x t0) (v1 t0)) in L.
    set (acc := val (slope (slope (stuck (x t0) (v1 t0)))) u) in *.
    replace (k * (b * M / m2)) with (M * (k * (b / m2))) by (field; lra).
    replace (k * (b / m2)) with (k * (k * acc)) by (f_equal; lra). destruct Hk; subst k; lra.
Qed.
End Along.
End Motion.
