(** Free motions in closed form: from one event to the next the state is a wave. When a wave is positive,
    its first root, and what a motion does until then: a slip up to its next contact, a stick up to its edge.
    Damping may be below, at or beyond its critical value. *)
From Coq Require Import List.
From InertialPair Require Import Dini Stick Forced Arcs.

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
Proof. intros N. pose proof (Rabs_pos_lt d N). split; [positive|apply sqrt_sqrt; lra]. Qed.
Lemma derive_cosine d u : is_derive (cosine d) u (- (d * sine d u)).
Proof.
  unfold cosine, sine. destruct (Rlt_dec 0 d) as [P|P]; [|destruct (Rlt_dec d 0) as [N|N]].
  - destruct (frequency_sq d ltac:(lra)) as (W & E). rewrite (Rabs_pos_eq d) in * by lra. set (w := sqrt d) in *.
    clearbody w. subst d. auto_derive; auto. field; lra.
  - destruct (frequency_sq d ltac:(lra)) as (W & E). rewrite (Rabs_left d) in * by lra. set (w := sqrt (- d)) in *.
    replace d with (- (w * w)) by lra. auto_derive; auto. field; lra.
  - assert (d = 0) as -> by lra. auto_derive; auto. ring.
Qed.
Lemma derive_sine d u : is_derive (sine d) u (cosine d u).
Proof.
  unfold cosine, sine. destruct (Rlt_dec 0 d) as [P|P]; [|destruct (Rlt_dec d 0) as [N|N]].
  1, 2: destruct (frequency_sq d ltac:(lra)) as (W & _); unfold cosh, sinh; auto_derive; auto; field; lra.
  auto_derive; auto.
Qed.
Lemma cosine_0 d : cosine d 0 = 1.
Proof. unfold cosine, cosh. repeat destruct Rlt_dec; rewrite ?Rmult_0_r, ?Ropp_0, ?exp_0, ?cos_0; lra. Qed.
Lemma sine_0 d : sine d 0 = 0.
Proof.
  unfold sine, sinh. repeat destruct Rlt_dec; auto; destruct (frequency_sq d ltac:(lra));
    rewrite Rmult_0_r, ?Ropp_0, ?exp_0, ?sin_0; field; lra.
Qed.

Set Implicit Arguments.
(** what is computed with: real numbers, or intervals of them *)
Record arith (T : Type) := Arith { zero : T; add : T -> T -> T; sub : T -> T -> T; mul : T -> T -> T; div : T -> T -> T;
  neg : T -> T; sin_of : T -> T; cos_of : T -> T }.
(** real numbers *)
Definition real := Arith 0 Rplus Rminus Rmult Rdiv Ropp sin cos.

(** t -> (in_sine + rise_sine t) sin (turn t + phase) + (in_cosine + rise_cosine t) cos (turn t + phase) *)
Record tone (T : Type) := Tone { in_sine : T; in_cosine : T; rise_sine : T; rise_cosine : T; turn : T; phase : T }.
(** a force, or what answers to it: a polynomial of t - from, and tones *)
Record steady (T : Type) := Steady { from : T; poly : list T; tones : list (tone T) }.
(** u -> still + drift u + exp (- decay u) (even cosine u + odd sine u) + answer (clock + u) *)
Record wave (T : Type) := Wave { still : T; drift : T; even : T; odd : T; decay : T; square : T; clock : T;
  answer : steady T }.
(** the numbers of a pair under a force: both masses and their sum, damper, spring, friction; decay and square of the free
    swing of body 1 and of both; how each answers to the force, and the force *)
Record kit (T : Type) := Kit { k1 : T; k2 : T; kM : T; ka1 : T; ka2 : T; kb : T; slow1 : T; stiff1 : T; slowM : T;
  stiffM : T; answer1 : steady T; answerM : steady T; force : steady T }.
Unset Implicit Arguments.

Section Computed.
Context {T : Type} (A : arith T).
Local Notation "x + y" := (add A x y).
Local Notation "x - y" := (sub A x y).
Local Notation "x * y" := (mul A x y).
Local Notation "x / y" := (div A x y).
Local Notation "- x" := (neg A x).

(** the value of a polynomial *)
Definition pval l u := fold_right (fun c r => c + u * r) (zero A) l.
(** of a tone *)
Definition tval z t := let a := turn z * t + phase z in
  (in_sine z + rise_sine z * t) * sin_of A a + (in_cosine z + rise_cosine z * t) * cos_of A a.
(** of both *)
Definition sval y t := fold_right (fun z r => tval z t + r) (pval (poly y) (t - from y)) (tones y).
(** the sum of two polynomials *)
Fixpoint padd l k := match l, k with c :: l, d :: k => c + d :: padd l k | nil, k => k | l, nil => l end.
(** derivatives *)
Fixpoint dpoly l := match l with c :: (_ :: _) as l => padd l (zero A :: dpoly l) | _ => nil end.
(** of a tone *)
Definition dtone z := Tone (rise_sine z - in_cosine z * turn z) (rise_cosine z + in_sine z * turn z)
  (- (rise_cosine z * turn z)) (rise_sine z * turn z) (turn z) (phase z).
(** of both *)
Definition dsteady y := Steady (from y) (dpoly (poly y)) (map dtone (tones y)).
(** with all coefficients changed *)
Definition scaled f (y : steady T) := Steady (from y) (map f (poly y))
  (map (fun z => Tone (f (in_sine z)) (f (in_cosine z)) (f (rise_sine z)) (f (rise_cosine z)) (turn z) (phase z))
    (tones y)).
(** the sign times the number *)
Definition signed (k : bool) x := if k then x else - x.

(** the derivative of a wave is a wave *)
Definition sloped f := Wave (drift f) (zero A) (odd f - decay f * even f)
  (- (square f * even f) - decay f * odd f) (decay f) (square f) (clock f) (dsteady (answer f)).
(** a mass on spring and damper about the place c, from the state (x, v) at the time t *)
Definition swing g d c y t x v := let z := x - c - sval y t in
  Wave c (zero A) z (v - sval (dsteady y) t + g * z) g d t y.

Variable K : kit T.
(** body 1 in a slip with v1 - v2 of the sign k *)
Definition slide k := swing (slow1 K) (stiff1 K) (- (signed k (kb K) / ka2 K)) (answer1 K).
(** body 2's velocity in it *)
Definition drive k v2 u := v2 + signed k (kb K) / k2 K * u.
(** k (v1 - v2) *)
Definition guard_of k f v2 := let f := sloped f in
  Wave (- signed k v2) (- (kb K / k2 K)) (signed k (even f)) (signed k (odd f)) (decay f) (square f) (clock f)
    (scaled (signed k) (answer f)).
(** of a state *)
Definition guard k t x v1 v2 := guard_of k (slide k t x v1) v2.
(** both bodies in a stick *)
Definition stuck := swing (slowM K) (stiffM K) (zero A) (answerM K).
(** what friction has left towards the side k *)
Definition grip_of k f := let f := sloped (sloped f) in
  Wave (kb K / k2 K) (zero A) (- signed k (even f)) (- signed k (odd f)) (decay f) (square f) (clock f)
    (scaled (fun c => - signed k c) (answer f)).
(** of a state *)
Definition grip k t x v := grip_of k (stuck t x v).
(** the place where a stick ends towards k at the time t with the velocity v *)
Definition edge k t v := (sval (force K) t - signed k (kb K * kM K / k2 K) - ka1 K * v) / ka2 K.
(** not negative: under a constant force a stick from (x, v) never comes to an edge *)
Definition spare t x v := let y := ka2 K * x - sval (force K) t in let l := kb K * kM K / k2 K in
  l * l - (y * y / ka2 K + kM K * (v * v)) * (ka2 K + ka1 K * ka1 K / kM K).
End Computed.
Notation slope := (sloped real).

Lemma is_derive_unique_at (f : R -> R) u k l : is_derive f u k -> is_derive f u l -> k = l.
Proof. intros D E. rewrite <- (is_derive_unique f u k D). apply is_derive_unique, E. Qed.
(** a sign *)
Definition sign (k : bool) := if k then 1 else -1.
Lemma signed_real k x : signed real k x = sign k * x.
Proof. destruct k; simpl; ring. Qed.

(** the value of a wave *)
Definition val f u := still f + drift f * u +
  exp (- (decay f * u)) * (even f * cosine (square f) u + odd f * sine (square f) u) + sval real (answer f) (clock f + u).

Lemma pval_cons c l u : pval real (c :: l) u = c + u * pval real l u. Proof. reflexivity. Qed.
Lemma pval_padd l : forall k u, pval real (padd real l k) u = pval real l u + pval real k u.
Proof.
  induction l as [|c l IH]; intros [|d k] u; cbn [padd]; rewrite ?pval_cons, ?IH; unfold pval; simpl; ring.
Qed.
Lemma derive_pval l : forall u, is_derive (pval real l) u (pval real (dpoly real l) u).
Proof.
  induction l as [|c l IH]; intros u.
  - apply (is_derive_const 0 u).
  - replace (pval real (dpoly real (c :: l)) u) with (pval real l u + u * pval real (dpoly real l) u).
    + apply (is_derive_ext (fun t => c + t * pval real l t)); [auto|]. derive. ring.
    + destruct l as [|d l]; [simpl; ring|]. change (dpoly real (c :: d :: l)) with
        (padd real (d :: l) (0 :: dpoly real (d :: l))). rewrite pval_padd, (pval_cons 0). ring.
Qed.
Lemma derive_sval y t : is_derive (sval real y) t (sval real (dsteady real y) t).
Proof.
  destruct y as [t0 l zs]. induction zs as [|z zs IH]; unfold sval in *; cbn [answer tones poly from dsteady map] in *.
  - rewrite <- (Rmult_1_l (pval _ (dpoly real l) _)).
    apply (is_derive_comp (pval real l) (fun t => t - t0)); [apply derive_pval|]. auto_derive; auto; ring.
  - apply (is_derive_plus (tval real z)); [|exact IH]. unfold tval, dtone; simpl. auto_derive; auto. ring.
Qed.
(** that of a scaled one *)
Lemma sval_scaled c y t : sval real (scaled (fun r => c * r) y) t = c * sval real y t.
Proof.
  destruct y as [t0 l zs]. unfold sval, scaled; cbn [tones poly from]. induction zs as [|z zs IH]; cbn [fold_right map].
  - induction l as [|d l IH]; cbn [map]; rewrite ?pval_cons, ?IH; unfold pval; simpl; ring.
  - rewrite IH. unfold tval; simpl. ring.
Qed.
(** only the values of the coefficients matter *)
Lemma scaled_ext {T} (f g : T -> T) y : (forall c, f c = g c) -> scaled f y = scaled g y.
Proof.
  intros E. unfold scaled. f_equal; apply map_ext; [auto|]. intros z. rewrite !E. auto.
Qed.

Lemma derive_val f (u : R) : is_derive (val f) u (val (slope f) u).
Proof.
  pose proof (derive_cosine (square f)). pose proof (derive_sine (square f)).
  pose proof (derive_sval (answer f)).
  unfold val, sloped; cbn [still drift even odd decay square clock answer]. cbn [add sub mul neg zero real].
  derive. ring.
Qed.

Lemma val_0 f : val f 0 = still f + even f + sval real (answer f) (clock f).
Proof. unfold val. rewrite !Rmult_0_r, Ropp_0, exp_0, cosine_0, sine_0, (Rplus_0_r (clock f)). ring. Qed.

(** *** Positive on an interval *)
(** the mean value theorem *)
Lemma val_mean f p q : p < q -> exists c, p < c < q /\ val f q - val f p = val (slope f) c * (q - p).
Proof. intros Hp. exact (mean_value _ _ p q Hp (derive_val f)). Qed.

Section Positive.
Context (f : wave R) (p q : R) (Hp : 0 < val f p) (Hq : 0 < val f q).

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
(** a convex one that rises at first, from its start *)
Lemma convex_positive : 0 <= val (slope f) p -> (forall u, p <= u <= q -> 0 <= val (slope (slope f)) u) ->
  forall u, p <= u <= q -> 0 < val f u.
Proof.
  intros Z S. apply rising_positive. intros u Hu. destruct (Req_dec u p) as [->|]; auto.
  destruct (val_mean (slope f) p u ltac:(lra)) as (c & Hc & E). specialize (S c ltac:(lra)). nra.
Qed.
(** a concave one, from both *)
Lemma concave_positive : (forall u, p <= u <= q -> val (slope (slope f)) u <= 0) -> forall u, p <= u <= q ->
  0 < val f u.
Proof.
  intros S u Hu. destruct (Rlt_dec 0 (val f u)); auto. assert (u <> p) by (intros ->; lra).
  assert (u <> q) by (intros ->; lra). destruct (val_mean f p u ltac:(lra)) as (c & Hc & E).
  destruct (val_mean f u q ltac:(lra)) as (d & Hd & F). destruct (val_mean (slope f) c d ltac:(lra)) as (e & He & G).
  specialize (S e ltac:(lra)). assert (val (slope f) c < 0) by nra. assert (0 < val (slope f) d) by nra. nra.
Qed.
End Positive.

(** from 0 on, if it rises at first *)
Lemma leaves_zero f d : 0 <= val f 0 -> (forall u, 0 <= u <= d -> 0 < val (slope f) u) -> forall u, 0 < u <= d ->
  0 < val f u.
Proof.
  intros Z S u Hu. destruct (val_mean f 0 u ltac:(lra)) as (c & Hc & E). specialize (S c ltac:(lra)). nra.
Qed.

(** the first root of a wave that is positive for a while *)
Lemma wave_root f lo hi : 0 < lo <= hi -> (forall u, 0 < u <= lo -> 0 < val f u) -> val f hi <= 0 ->
  exists tau, lo < tau <= hi /\ val f tau = 0 /\ forall u, 0 < u < tau -> 0 < val f u.
Proof.
  intros Hl P N. pose proof (P lo ltac:(lra)) as Pl.
  destruct (first_zero (val f) lo hi) as (tau & Ht & Z & B); [|lra|nra|lra|].
  { apply cont_of_derive with (val (slope f)), derive_val. }
  exists tau. split; [lra|]. split; [auto|]. intros u Hu. destruct (Rle_dec u lo); [apply P; lra|].
  specialize (B u ltac:(lra)). nra.
Qed.

(** *** The two kinds of motion *)
(** the rate at which the free swing of a mass m decays *)
Definition fade (m a1 : R) := a1 / (2 * m).

(** the mass m answers so to the force *)
Definition answers m a1 a2 y f := forall t,
  m * sval real (dsteady real (dsteady real y)) t + a1 * sval real (dsteady real y) t + a2 * sval real y t =
    sval real f t.

Section Motion.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Context (y1 yM push : steady R) (Hy1 : answers m1 a1 a2 y1 push) (HyM : answers M a1 a2 yM push).

(** the numbers of the pair *)
Definition real_kit := Kit m1 m2 (m1 + m2) a1 a2 b (fade m1 a1) (a2 / m1 - fade m1 a1 * fade m1 a1)
  (fade (m1 + m2) a1) (a2 / (m1 + m2) - fade (m1 + m2) a1 * fade (m1 + m2) a1) y1 yM push.
Let K := real_kit.
(** the free swing of the mass m *)
Definition swings m := swing real (fade m a1) (a2 / m - fade m a1 * fade m a1).

Lemma swing_start g d c y t x v : val (swing real g d c y t x v) 0 = x.
Proof. rewrite val_0. unfold swing; simpl. ring. Qed.
Lemma swing_speed g d c y t x v : val (slope (swing real g d c y t x v)) 0 = v.
Proof. rewrite val_0. unfold sloped, swing; simpl. ring. Qed.
(** and obeys the law of motion *)
Lemma swing_law m c y t x v u : 0 < m -> answers m a1 a2 y push -> m * val (slope (slope (swings m c y t x v))) u
  = sval real push (t + u) + a2 * (c - val (swings m c y t x v) u) - a1 * val (slope (swings m c y t x v)) u.
Proof.
  intros Hm Y. rewrite <- (Y (t + u)). unfold val, sloped, swings, swing; simpl.
  set (d := a2 / m - fade m a1 * fade m a1) in *. set (g := fade m a1) in *.
  assert (E2 : a2 = m * (d + g * g)) by (unfold d; field; lra).
  assert (E1 : a1 = 2 * m * g) by (unfold g, fade; field; lra). rewrite E1, E2. ring.
Qed.

Lemma val_guard k t x v1 v2 u :
  val (guard real K k t x v1 v2) u = sign k * (val (slope (slide real K k t x v1)) u - drive real K k v2 u).
Proof.
  unfold guard, guard_of, drive. set (f := slope (slide real K k t x v1)). assert (S : still f = 0) by reflexivity.
  assert (D : drift f = 0) by reflexivity. assert (C : clock f = t) by reflexivity. clearbody f.
  unfold val; cbn [still drift even odd decay square clock answer]. rewrite S, D, C.
  rewrite (scaled_ext _ (fun r => sign k * r)), sval_scaled by (intros; apply signed_real).
  destruct k; simpl; field; lra.
Qed.
Lemma val_grip k t x v u : val (grip real K k t x v) u = b / m2 - sign k * val (slope (slope (stuck real K t x v))) u.
Proof.
  unfold grip, grip_of. set (f := slope (slope (stuck real K t x v))). assert (S : still f = 0) by reflexivity.
  assert (D : drift f = 0) by reflexivity. assert (C : clock f = t) by reflexivity.
  unfold val; cbn [still drift even odd decay square clock answer]. rewrite S, D, C.
  rewrite (scaled_ext _ (fun r => - sign k * r)), sval_scaled by (intros; rewrite signed_real; simpl; ring).
  rewrite !signed_real. simpl. ring.
Qed.

(** the laws of motion *)
Lemma slide_law k t x v u : m1 * val (slope (slope (slide real K k t x v))) u =
  sval real push (t + u) - a2 * val (slide real K k t x v) u - a1 * val (slope (slide real K k t x v)) u - sign k * b.
Proof.
  change (slide real K k t x v) with (swings m1 (- (signed real k b / a2)) y1 t x v).
  rewrite (swing_law m1) by auto. rewrite signed_real. field; lra.
Qed.
(** of a stick *)
Lemma stuck_law t x v u : M * val (slope (slope (stuck real K t x v))) u =
  sval real push (t + u) - a2 * val (stuck real K t x v) u - a1 * val (slope (stuck real K t x v)) u.
Proof.
  assert (HM : 0 < M) by positive. change (stuck real K t x v) with (swings M 0 yM t x v).
  rewrite (swing_law M) by auto. ring.
Qed.
(** the starts *)
Lemma slide_start k t x v : val (slide real K k t x v) 0 = x /\ val (slope (slide real K k t x v)) 0 = v.
Proof. split; [apply swing_start|apply swing_speed]. Qed.
Lemma stuck_start t x v : val (stuck real K t x v) 0 = x /\ val (slope (stuck real K t x v)) 0 = v.
Proof. split; [apply swing_start|apply swing_speed]. Qed.

(** at a contact it is 0 *)
Lemma guard_touch k t x v : val (guard real K k t x v v) 0 = 0.
Proof. rewrite val_guard. unfold slide, drive. rewrite swing_speed. simpl. ring. Qed.
(** how it starts *)
Lemma guard_slope k t x v1 v2 : m1 * val (slope (guard real K k t x v1 v2)) 0
  = - (sign k * (a2 * x + a1 * v1 - sval real push t)) - b * M / m2.
Proof.
  assert (L := slide_law k t x v1 0). destruct (slide_start k t x v1) as (E0 & E1). rewrite E0, E1, Rplus_0_r in L.
  replace (val (slope (guard real K k t x v1 v2)) 0) with
    (sign k * val (slope (slope (slide real K k t x v1))) 0 - b / m2).
  - rewrite Rmult_minus_distr_l, <- Rmult_assoc, (Rmult_comm m1), Rmult_assoc, L.
    unfold M. destruct k; simpl; field; lra.
  - apply (is_derive_unique_at (val (guard real K k t x v1 v2)) 0); [|apply derive_val].
    apply (is_derive_ext (fun u => sign k * (val (slope (slide real K k t x v1)) u - drive real K k v2 u))).
    { symmetry. apply val_guard. }
    pose proof (derive_val (slope (slide real K k t x v1))). unfold drive; simpl. derive. rewrite signed_real.
    destruct k; simpl; field; lra.
Qed.
(** on the edge towards k it starts at 0 with slope 0 *)
Lemma guard_edge k t x v : a2 * x + a1 * v - sval real push t = - (sign k * (b * M / m2)) ->
  val (slope (guard real K k t x v v)) 0 = 0.
Proof.
  intros E. pose proof (guard_slope k t x v v) as S. rewrite E in S. apply Rmult_eq_reg_l with m1; [|lra].
  rewrite S. destruct k; simpl; field; lra.
Qed.

(** there friction has nothing left for a stick *)
Lemma grip_edge k t x v : a2 * x + a1 * v - sval real push t = - (sign k * (b * M / m2)) ->
  val (grip real K k t x v) 0 = 0.
Proof.
  intros E. assert (HM : 0 < M) by positive. pose proof (stuck_law t x v 0) as L.
  destruct (stuck_start t x v) as (E0 & E1). rewrite val_grip. rewrite E0, E1, Rplus_0_r in L.
  set (acc := val (slope (slope (stuck real K t x v))) 0) in *. assert (acc = sign k * (b / m2)) as ->.
  - nra.
  - destruct k; simpl; ring.
Qed.

(** the energy about the place of rest never grows, and with it no stick comes to an edge that is beyond its reach *)
Lemma grip_held k t x v u : (forall r, sval real push r = sval real push t) -> 0 <= spare real K t x v -> 0 <= u ->
  0 <= val (grip real K k t x v) u.
Proof.
  intros C S Hu. assert (HM : 0 < M) by positive. set (c := sval real push t) in *.
  set (X := stuck real K t x v). set (Y := fun r => a2 * val X r - c).
  set (E := fun r => Y r * Y r / a2 + M * (val (slope X) r * val (slope X) r)).
  assert (A : forall r, val (slope (slope X)) r = - (Y r + a1 * val (slope X) r) / M).
  { intros r. apply Rmult_eq_reg_l with M; [|lra]. unfold Y, X. rewrite stuck_law, C. field; lra. }
  assert (D : E u <= E 0).
  { assert (D : forall r, is_derive E r (- (2 * a1) * (val (slope X) r * val (slope X) r))).
    { intros r. pose proof (derive_val X). pose proof (derive_val (slope X)). unfold E, Y. derive. rewrite A.
      unfold Y. field; lra. }
    apply (rderiv_mono E 0 u (fun r => - (2 * a1) * (val (slope X) r * val (slope X) r))); [|lra|].
    - eapply cont_of_derive. exact D.
    - split; [apply rderiv_of_derive, D|nra]. }
  destruct (stuck_start t x v) as (X0 & V0). unfold E, Y in D. unfold X in D. rewrite X0, V0 in D.
  unfold spare, K, real_kit in S; cbn [add sub mul div real ka1 ka2 kM kb k2 force] in S. fold c M in S.
  rewrite val_grip, A. set (y := Y u) in *. set (w := val (slope X) u) in *. set (l := b * M / m2) in *.
  assert (Hl : 0 < l) by positive. assert (Q : (y + a1 * w) * (y + a1 * w) <= l * l).
  { assert (0 <= (a1 * y - a2 * M * w) * (a1 * y - a2 * M * w) / (a2 * M)).
    { apply Rmult_le_pos; [exact (Rle_0_sqr _)|apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; auto]. }
    assert (0 <= a1 * a1 / M) by positive. apply Rle_trans with ((y * y / a2 + M * (w * w)) * (a2 + a1 * a1 / M)).
    - apply Rminus_le_0. replace (_ - _) with ((a1 * y - a2 * M * w) * (a1 * y - a2 * M * w) / (a2 * M)); [auto|].
      field; lra.
    - eapply Rle_trans; [apply Rmult_le_compat_r; [lra|exact D]|]. lra. }
  assert (- l <= y + a1 * w <= l) as B by (split; nra).
  replace (b / m2 - sign k * (- (y + a1 * w) / M)) with ((l + sign k * (y + a1 * w)) / M) by (unfold l; field; lra).
  apply Rmult_le_pos; [destruct k; simpl; lra|positive].
Qed.
(** a place whose velocity is that of an arc *)
Lemma same_way y v X V t0 T : cont y -> 0 <= t0 -> 0 <= T -> (forall t, 0 <= t -> rderiv y t (v t)) ->
  (forall u, is_derive X u (V u)) -> (forall u, 0 <= u <= T -> v (t0 + u) = V u) -> y (t0 + T) = y t0 + (X T - X 0).
Proof.
  intros C Ht HT Y D E. assert (Cy : cont (fun u => y (t0 + u))) by continuous.
  pose proof (same_gain (fun u => y (t0 + u)) (fun u => v (t0 + u)) X V 0 T Cy ltac:(lra) D
    ltac:(intros u Hu; split;
    [apply rderiv_earlier, Y|apply E]; lra)) as Q. cbv beta in Q. rewrite Rplus_0_r in Q. lra.
Qed.

(** From lo to hi the motion runs along every arc on which it starts. *)
Definition obeys lo hi (x v1 v2 : R -> R) := forall t0 T X V1 V2 g, lo <= t0 -> 0 <= T -> t0 + T <= hi ->
  forced_arc m1 m2 a1 a2 b T (fun u => sval real push (t0 + u)) X V1 V2 g -> x t0 = X 0 -> v1 t0 = V1 0 ->
  v2 t0 = V2 0 -> forall u, 0 <= u <= T -> x (t0 + u) = X u /\ v1 (t0 + u) = V1 u /\ v2 (t0 + u) = V2 u.

Section Along.
Variables x v1 v2 : R -> R.
Context (first final : R) (H : obeys first final x v1 v2).
Context (t0 : R) (Ht0 : first <= t0).
Let guard k := guard real K k t0 (x t0) (v1 t0) (v2 t0).
Let grip k := grip real K k t0 (x t0) (v1 t0).
Let slide k := slide real K k t0 (x t0) (v1 t0).
Let stuck := stuck real K t0 (x t0) (v1 t0).

(** as long as the guard is not negative, a motion slips *)
Theorem slip_phase k T : 0 <= T -> t0 + T <= final -> (forall u, 0 <= u < T -> 0 <= val (guard k) u) ->
  forall u, 0 <= u <= T -> x (t0 + u) = val (slide k) u /\ v1 (t0 + u) = val (slope (slide k)) u /\
  v2 (t0 + u) = drive real K k (v2 t0) u.
Proof.
  intros HT HF G.
  apply (H t0 T (val (slide k)) (val (slope (slide k))) (drive real K k (v2 t0)) (fun _ => sign k)); auto.
  - apply slip_arc.
    + destruct k; auto.
    + apply derive_val.
    + intros t. replace (_ / m1) with (val (slope (slope (slide k))) t); [apply derive_val|].
      apply Rmult_eq_reg_l with m1; [|lra]. unfold slide. rewrite slide_law. field; lra.
    + intros t. unfold drive; simpl. rewrite signed_real. auto_derive; auto. field; lra.
    + intros t Ht. specialize (G t Ht). unfold guard in G. rewrite val_guard in G. exact G.
  - symmetry. apply slide_start.
  - symmetry. apply slide_start.
  - unfold drive; simpl. ring.
Qed.

(** as long as friction holds, a motion sticks *)
Theorem stick_phase T : 0 <= T -> t0 + T <= final -> v1 t0 = v2 t0 ->
  (forall u, 0 <= u < T -> 0 <= val (grip true) u /\ 0 <= val (grip false) u) ->
  forall u, 0 <= u <= T -> x (t0 + u) = val stuck u /\ v1 (t0 + u) = val (slope stuck) u /\
  v2 (t0 + u) = val (slope stuck) u.
Proof.
  intros HT HF Ev G. pose proof (stuck_law t0 (x t0) (v1 t0)) as L. fold stuck in L.
  assert (HM : 0 < M) by positive. eapply (H t0 T (val stuck) (val (slope stuck)) (val (slope stuck))); auto.
  - apply (stuck_arc m1 m2 a1 a2 b Hm1 Hm2 Hb); fold M.
    + apply derive_val.
    + intros t. rewrite <- L. replace (_ / M) with (val (slope (slope stuck)) t) by (field; lra).
      apply derive_val.
    + intros t Ht. rewrite <- L. specialize (G t Ht). unfold grip in G. rewrite !val_grip in G.
      fold stuck in G. simpl in G. set (acc := val (slope (slope stuck)) t) in *.
      replace (m2 * (M * acc) / M) with (m2 * acc) by (field; lra).
      assert (m2 * (b / m2) = b) by (field; lra). nra.
  - symmetry. apply stuck_start.
  - symmetry. apply stuck_start.
  - rewrite <- Ev. symmetry. apply stuck_start.
Qed.

(** A stick under a constant force, below the level that friction holds, is for ever. *)
Theorem stick_for_ever T : 0 <= T -> t0 + T <= final -> v1 t0 = v2 t0 -> (forall t, sval real push t = sval real push t0) ->
  0 <= spare real K t0 (x t0) (v1 t0) -> v1 (t0 + T) = v2 (t0 + T).
Proof.
  intros HT HF Ev C S. destruct (stick_phase T HT HF Ev) with (u := T) as (_ & -> & ->); auto; [|lra].
  split; apply grip_held; auto; lra.
Qed.
End Along.
End Motion.
