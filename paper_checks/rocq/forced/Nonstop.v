(** A sinusoidal force u = F sin (om t + phi) so strong that the pair never sticks: the motion that slips one way for
  half a period and then the other way exists exactly from one amplitude on, U**. With damping a1 >= 0.

    Body 1 then feels the force and a push -b, +b that is turned round after each half period.
      Its motion is the response to
    the sinusoid minus b times k, where k is its response to the push 1 of that kind: k and its speed change sign over
      half a period. What is left to choose is the phase; v1 = v2 at the turn fixes one part of the response,
      and v1 > v2 afterwards asks at least so much of the other. *)
From InertialPair Require Import Dini Pair Stick EnergyLimit Forced Arcs.

(** the impulse of F sin (om t + phi) *)
Definition wave F om phi t := F / om * (cos phi - cos (om * t + phi)).

Lemma derive_wave F om phi t : 0 < om -> is_derive (wave F om phi) t (F * sin (om * t + phi)).
Proof. intros Hom. unfold wave. auto_derive; auto. field; lra. Qed.
(** the same from the right *)
Lemma rderiv_wave F om phi t : 0 < om -> rderiv (wave F om phi) t (F * sin (om * t + phi)).
Proof. intros Hom. apply rderiv_of_derive, derive_wave; auto. Qed.
Lemma cont_wave F om phi : 0 < om -> cont (wave F om phi).
Proof. intros Hom. exact (cont_of_derive _ _ (fun t => derive_wave F om phi t Hom)). Qed.
(** it repeats with the opposite sign *)
Lemma wave_half F om phi t : 0 < om -> wave F om phi (PI / om + t) - wave F om phi (PI / om) = - (wave F om phi t -
  wave F om phi 0).
Proof.
  intros Hom. unfold wave. replace (om * (PI / om + t) + phi) with (om * t + phi + PI) by (field; lra).
  replace (om * (PI / om) + phi) with (phi + PI) by (field; lra). rewrite !neg_cos, Rmult_0_r, Rplus_0_l. ring.
Qed.
(** and is F-Lipschitz *)
Lemma wave_lip F om phi r t : 0 <= F -> 0 < om -> 0 <= r <= t ->
  Rabs (wave F om phi t - wave F om phi r) <= F * (t - r).
Proof.
  intros HF Hom Hr. apply (lip_of_rderiv (wave F om phi) (fun t => F * sin (om * t + phi))); auto using cont_wave.
  intros u _. split; [apply rderiv_wave; auto|]. pose proof (SIN_bound (om * u + phi)). apply Rabs_le. nra.
Qed.

(** what is positive inside an interval is not negative at its ends *)
Lemma ends_nonneg f p q : cont f -> 0 <= p < q -> (forall t, p < t < q -> 0 < f t) -> 0 <= f p /\ 0 <= f q.
Proof.
  intros C Hp P. split.
  - apply Rnot_lt_le. intros N. destruct (C p ltac:(lra) (- f p)) as (d & Hd & K); [lra|].
    set (h := Rmin (d / 2) ((q - p) / 2)). least h. assert (0 < h) by positive.
    specialize (P (p + h) ltac:(lra)). specialize (K (p + h) ltac:(lra) ltac:(apply Rabs_def1; lra)).
    apply Rabs_def2 in K. lra.
  - assert (-1 * f q <= 0); [|lra]. apply (cont_le (fun t => -1 * f t) 0 ((p + q) / 2) q); [apply cont_scal, C|lra|].
    intros t Ht. specialize (P t ltac:(lra)). lra.
Qed.

Lemma rderiv_0 f r t : cont f -> 0 <= r <= t -> (forall u, r <= u < t -> rderiv f u 0) -> f t = f r.
Proof. intros C Hr D. pose proof (rderiv_line f 0 r t C Hr D). lra. Qed.

(** while body 1 is the faster one the impulse of friction grows like time *)
Lemma slip_clock m1 m2 a1 a2 b U x v1 v2 s p q : forced m1 m2 a1 a2 b U x v1 v2 s -> 0 <= p < q ->
  (forall t, p < t < q -> v2 t < v1 t) -> forall t, p <= t <= q -> s t = s p + (t - p).
Proof.
  intros H Hp P t Ht. pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H) as L.
  pose proof (moves_cs _ _ _ _ _ _ _ _ _ _ _ H) as Cs. destruct (Req_dec t p) as [->|N]; [ring|]. apply Rle_antisym.
  - pose proof (L p t ltac:(lra)) as B. apply Rabs_inv in B. lra.
  - apply le_epsilon. intros e He. destruct (ends_nonneg (fun r => s t - s r - (t - r) + e) p t) as (A & _);
      [continuous|lra| |lra].
    intros r Hr. rewrite (moves_impulse m1 m2 a1 a2 b _ _ _ _ _ _ H r t 1); auto; [lra|lra|].
    intros u Hu. specialize (P u ltac:(lra)). lra.
Qed.

(** a slip forwards begins where the load is at least b *)
Lemma exit_load m1 m2 a1 a2 b U x v1 v2 s p q u : 0 < m1 -> 0 < m2 -> forced m1 m2 a1 a2 b U x v1 v2 s -> 0 <= p < q ->
  (forall t, p < t < q -> v2 t < v1 t) -> v1 p = v2 p -> rderiv U p u ->
    (m1 + m2) * (b / m2) <= u - a2 * x p - a1 * v1 p.
Proof.
  intros Hm1 Hm2 H Hp Slip Meet DU. pose proof (slip_clock _ _ _ _ _ _ _ _ _ _ p q H Hp Slip) as Clock.
  assert (Ds : rderiv s p 1).
  { apply rderiv_near with (fun r => s p + (r - p)) (q - p); [lra|intros; symmetry; apply Clock; lra|].
    apply rderiv_of_derive. auto_derive; auto; ring. }
  set (l := u - a2 * x p - a1 * v1 p - (m1 + m2) * (b / m2)). assert (Rw : rderiv (fun t => m1 * (v1 t - v2 t)) p l).
  { eapply rderiv_eq; [|apply rderiv_scal, (moves_rate m1 m2 a1 a2 b Hm1 Hm2 _ U x v1 v2 s H p u 1 ltac:(lra) DU Ds)].
    unfold l. field; lra. }
  apply Rnot_lt_le. intros N. assert (Nl : l < 0) by (unfold l; lra).
  destruct (Rw (- l / 2)) as (d & Hd & Q); [lra|]. set (h := Rmin (d / 2) ((q - p) / 2)). least h.
  assert (0 < h) by positive.
  specialize (Q h ltac:(lra)). apply Rabs_inv in Q. rewrite Meet in Q. specialize (Slip (p + h) ltac:(lra)).
  assert (0 < m1 * (v1 (p + h) - v2 (p + h))) by positive. assert (l * h < 0) by nra. lra.
Qed.

Section Nonstop.
Context (m1 m2 a1 a2 b om : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om).

(** the square of body 1's dynamic stiffness *)
Definition Z1 := (a2 - m1 * om ^ 2) ^ 2 + (a1 * om) ^ 2.
(** the part of the response in phase, which v1 = v2 at the turn fixes; h' = k'(0) *)
Definition turn h' := b / om * (h' - PI / (2 * m2 * om)).
(** the least size of the part out of phase for which v1 > v2 after the turn; h = k(0) *)
Definition leave h h' := b * ((m1 + m2) / m2 - a2 * h - a1 * h') / (m1 * om ^ 2).
(** U** *)
Definition Fslip h h' := sqrt (Z1 * (turn h' ^ 2 + leave h h' ^ 2)).
(** the relative velocity in the half period after the turn, when the part out of phase has the size p *)
Definition slipping (k' : R -> R) p t :=
  om * (turn (k' 0) * cos (om * t) + p * sin (om * t)) - b * k' t - b / m2 * (t - PI / (2 * om)).

(** a motion under F sin (om t + phi) that slips forwards in (0, pi/om) and repeats with the opposite sign *)
Definition nonstop F phi x v1 v2 s := forced m1 m2 a1 a2 b (wave F om phi) x v1 v2 s /\
  (forall t, 0 < t < PI / om -> v2 t < v1 t) /\
  forall t, 0 <= t -> x (PI / om + t) = - x t /\ v1 (PI / om + t) = - v1 t /\ v2 (PI / om + t) = - v2 t.

Let T := PI / om.
Lemma half_pos : 0 < T.
Proof. pose proof PI_RGT_0. positive. Qed.

(** an arc that slips forwards, and whose state changes its sign over half a period, is the half of one *)
Lemma nonstop_arc F phi X V1 V2 :
  forced_arc m1 m2 a1 a2 b T (fun t => F * sin (om * t + phi)) X V1 V2 (fun _ => 1) ->
  (forall t, 0 < t < T -> V2 t < V1 t) -> X T = - X 0 -> V1 T = - V1 0 -> V2 T = - V2 0 -> exists x v1 v2 s,
  nonstop F phi x v1 v2 s /\ forall t, 0 <= t <= T -> x t = X t /\ v1 t = V1 t /\ v2 t = V2 t.
Proof.
  intros Arc Ahead EX E1 E2. pose proof half_pos as HT.
  destruct (arc_begins m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb (wave F om phi) _ X V1 V2 _ T ltac:(lra)
    (cont_wave F om phi Hom) (fun t _ => rderiv_wave F om phi t Hom) Arc) as (x & v1 & v2 & s & H & E).
  exists x, v1, v2, s. split; [split; [auto|split]|auto].
  - intros t Ht. fold T in Ht. destruct (E t ltac:(lra)) as (_ & -> & ->). auto.
  - destruct (E 0 ltac:(lra)) as (X0 & V10 & V20), (E T ltac:(lra)) as (XT & V1T & V2T).
    apply (antiperiodic m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb (wave F om phi) x v1 v2 s T); auto; try congruence.
    { lra. }
    intros t _. apply wave_half; auto.
Qed.

Variables k k' : R -> R.
Hypotheses (Dk : forall t, is_derive k t (k' t)) (Dk' : forall t, is_derive k' t ((1 - a1 * k' t - a2 * k t) / m1))
  (Ek : k (PI / om) = - k 0) (Ek' : k' (PI / om) = - k' 0) (HZ : 0 < Z1) (Hl : 0 < leave (k 0) (k' 0)).

Lemma turn_0 : om * turn (k' 0) - b * k' 0 = - (b / m2 * (T / 2)).
Proof. unfold turn, T. field; lra. Qed.

(** after the turn body 1 is driven on: its velocity swings freely, and the energy of that does not grow *)
Lemma leaves : 0 < leave (k 0) (k' 0).
Proof.
  pose proof half_pos. set (y := fun t => 1 - a1 * k' t - a2 * k t).
  assert (Le : a2 * m1 * k' T ^ 2 + y T ^ 2 <= a2 * m1 * k' 0 ^ 2 + y 0 ^ 2).
  { apply (rderiv_mono (fun t => a2 * m1 * k' t ^ 2 + y t ^ 2) 0 T (fun t => - (2 * a1 / m1 * y t ^ 2)));
      [continuous|lra|].
    intros t _. split; [rate; unfold y; field; lra|]. assert (0 <= 2 * a1 / m1 * y t ^ 2) by positive. lra. }
  unfold y, T in Le. rewrite Ek, Ek' in Le. unfold leave. assert (0 < m1 / m2) by positive.
  replace ((m1 + m2) / m2) with (1 + m1 / m2) by (field; lra). apply Rdiv_lt_0_compat; [|positive].
  apply Rmult_lt_0_compat; lra.
Qed.

(** enough: the response with that phase is an arc that obeys the law *)
Theorem nonstop_exists F : Fslip (k 0) (k' 0) <= F -> (forall t, 0 < t < T -> 0 < slipping k' (leave (k 0) (k' 0)) t) ->
  exists phi x v1 v2 s, nonstop F phi x v1 v2 s.
Proof.
  intros HF Side. pose proof half_pos as HT. set (A := turn (k' 0)) in *. set (Bs := leave (k 0) (k' 0)) in *.
  assert (Zp : 0 < Z1 * (A ^ 2 + Bs ^ 2)). { apply Rmult_lt_0_compat; auto. pose proof (pow2_ge_0 A). nra. }
  assert (Fp : 0 < F). { pose proof (sqrt_lt_R0 _ Zp). unfold Fslip in HF. fold A Bs in HF. lra. }
  assert (F2 : Z1 * (A ^ 2 + Bs ^ 2) <= F ^ 2).
  { unfold Fslip in HF. fold A Bs in HF. rewrite <- (sqrt_sqrt (Z1 * (A ^ 2 + Bs ^ 2))) by lra.
    pose proof (sqrt_pos (Z1 * (A ^ 2 + Bs ^ 2))). nra. }
  assert (Q : Bs ^ 2 <= F ^ 2 / Z1 - A ^ 2).
  { apply Rmult_le_reg_l with Z1; auto. replace (Z1 * (F ^ 2 / Z1 - A ^ 2)) with (F ^ 2 - Z1 * A ^ 2) by (field; lra).
    lra. }
  set (B := sqrt (F ^ 2 / Z1 - A ^ 2)). assert (B2 : B * B = F ^ 2 / Z1 - A ^ 2) by (apply sqrt_sqrt; nra).
  assert (BBs : Bs <= B). { rewrite <- (sqrt_pow2 Bs) by lra. apply sqrt_le_1_alt; auto. }
  set (S := (a2 - m1 * om ^ 2) * A + a1 * om * B). set (C := - (a2 - m1 * om ^ 2) * B + a1 * om * A).
  assert (SC : S ^ 2 + C ^ 2 = F ^ 2).
  { transitivity (Z1 * (A ^ 2 + B * B)); [unfold S, C, Z1; ring|]. rewrite B2. field; lra. }
  destruct (polar S C F 1 0 Fp ltac:(lra) SC) as (phi & _ & ES & EC). rewrite Rmult_1_l in ES, EC.
  assert (Eu : forall t, F * sin (om * t + phi) = S * sin (om * t) + C * cos (om * t)).
  { intros t. rewrite sin_plus, <- ES, <- EC. ring. }
  set (X := fun t => A * sin (om * t) - B * cos (om * t) - b * k t).
  set (V1 := fun t => om * (A * cos (om * t) + B * sin (om * t)) - b * k' t).
  set (V2 := fun t => b / m2 * (t - T / 2)). assert (OT : om * T = PI) by (unfold T; field; lra).
  assert (Ahead : forall t, 0 < t < T -> V2 t < V1 t).
  { intros t Ht. pose proof (Side t Ht) as Sl. unfold slipping in Sl. fold A Bs in Sl.
    assert (0 < sin (om * t)) by (apply sin_gt_0; [nra|rewrite <- OT; apply Rmult_lt_compat_l; lra]).
    assert (Bs * sin (om * t) <= B * sin (om * t)) by scale.
    unfold V1, V2. replace (PI / (2 * om)) with (T / 2) in Sl by (unfold T; field; lra). nra. }
  assert (Arc : forced_arc m1 m2 a1 a2 b T (fun t => F * sin (om * t + phi)) X V1 V2 (fun _ => 1)).
  { apply slip_arc; auto.
    - intros t. unfold X, V1. derive. ring.
    - intros t. rewrite Eu. unfold X, V1. derive. unfold S, C. field; lra.
    - intros t. unfold V2. auto_derive; auto. field; lra.
    - intros t Ht. destruct (Req_dec t 0) as [->|N]; [|specialize (Ahead t ltac:(lra)); lra].
      unfold V1, V2. rewrite Rmult_0_r, cos_0, sin_0. pose proof turn_0. fold A in H. lra. }
  destruct (nonstop_arc F phi X V1 V2 Arc Ahead) as (x & v1 & v2 & s & H & _);
    [| | |exists phi, x, v1, v2, s; auto].
  - unfold X. rewrite OT, Rmult_0_r, cos_0, sin_0, cos_PI, sin_PI. unfold T. rewrite Ek. ring.
  - unfold V1. rewrite OT, Rmult_0_r, cos_0, sin_0, cos_PI, sin_PI. unfold T. rewrite Ek'. ring.
  - unfold V2. field; lra.
Qed.

(** a free response whose state changes sign over half a period is none: damping would take energy; without
    it two products with k do not change, and say so *)
Lemma no_free_response z z' : cont z -> cont z' -> (forall t, 0 <= t < T -> rderiv z t (z' t)) ->
  (forall t, 0 <= t < T -> rderiv (fun u => m1 * z' u) t (- (a2 * z t + a1 * z' t))) -> z T = - z 0 -> z' T = - z' 0 ->
  z 0 = 0 /\ z' 0 = 0.
Proof.
  intros C C' D D' E E'. pose proof half_pos as HT. destruct (Req_dec a1 0) as [Z0|N].
  - assert (K1 : a2 * (m1 * z' T * k T) - a2 * m1 * (z T * k' T) - m1 * z' T
      = a2 * (m1 * z' 0 * k 0) - a2 * m1 * (z 0 * k' 0) - m1 * z' 0).
    { apply (rderiv_0 (fun t => a2 * (m1 * z' t * k t) - a2 * m1 * (z t * k' t) - m1 * z' t) 0 T);
        [continuous|lra|].
      intros t Ht. rate. rewrite Z0. field. lra. }
    assert (K2 : m1 * z' T * k' T + a2 * (z T * k T) - z T = m1 * z' 0 * k' 0 + a2 * (z 0 * k 0) - z 0).
    { apply (rderiv_0 (fun t => m1 * z' t * k' t + a2 * (z t * k t) - z t) 0 T); [continuous|lra|].
      intros t Ht. rate. rewrite Z0. field. lra. }
    fold T in Ek, Ek'. rewrite E, E', Ek, Ek' in K1, K2. split; [lra|]. apply Rmult_eq_reg_l with m1; lra.
  - set (e := fun t => a2 / 2 * (z t * z t) + / (2 * m1) * (m1 * z' t * (m1 * z' t))).
    assert (Ce : cont e) by continuous. assert (De : forall t, 0 <= t < T -> rderiv e t (- a1 * (z' t) ^ 2)).
    { intros t Ht. unfold e. rate. field; lra. }
    assert (Le : forall r t, 0 <= r <= t -> t <= T -> e t <= e r).
    { intros r t Hr Ht. apply (rderiv_mono e r t (fun t => - a1 * (z' t) ^ 2)); auto. intros q Hq. split; [apply De;
      lra|]. pose proof (pow2_ge_0 (z' q)). nra. }
    assert (Te : e T = e 0) by (unfold e; rewrite E, E'; ring). assert (Z : forall t, 0 <= t < T -> z' t = 0).
    { intros t Ht. assert (K : rderiv e t 0).
      { apply rderiv_near with (fun _ => e 0) (T - t); [lra| |apply rderiv_const]. intros q Hq.
        pose proof (Le 0 q ltac:(lra) ltac:(lra)). pose proof (Le q T ltac:(lra) ltac:(lra)). lra. }
      pose proof (rderiv_unique _ _ _ _ (De t Ht) K). apply Rmult_integral in H. destruct H as [H|H]; [lra|].
      apply Rsqr_0_uniq. unfold Rsqr. lra. }
    split; [|apply Z; lra]. assert (z T = z 0); [|lra]. apply rderiv_0; auto; [lra|]. intros q Hq.
    eapply rderiv_eq; [apply (Z q Hq)|apply D; auto].
Qed.

(** needed: the motion is the response with that phase, as there is no other whose state changes sign *)
Theorem nonstop_needs F phi x v1 v2 s : 0 <= F -> nonstop F phi x v1 v2 s -> Fslip (k 0) (k' 0) <= F.
Proof.
  intros HF (H & Pos & Anti). change (PI / om) with T in Pos, Anti. pose proof half_pos as HT.
  pose proof (slip_clock _ _ _ _ _ _ _ _ _ _ 0 T H ltac:(lra) Pos) as Clock.
  assert (Ds : forall t, 0 <= t < T -> rderiv s t 1).
  { intros t Ht. apply rderiv_near with (fun u => s 0 + (u - 0)) (T - t); [lra|intros; symmetry; apply Clock; lra|].
    apply rderiv_of_derive. auto_derive; auto; ring. }
  pose proof (moves_cv2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H) as Cv2. pose proof (f_cv _ _ _ _ _ _ _ _ _ _ H) as Cv.
  pose proof (f_cx _ _ _ _ _ _ _ _ _ _ H) as Cx.
  destruct (Anti 0 (Rle_refl 0)) as (X0 & V0 & W0). rewrite Rplus_0_r in X0, V0, W0. assert (Meet : v1 0 = v2 0).
  { destruct (ends_nonneg (fun t => v1 t - v2 t) 0 T) as (A & B); [apply cont_minus; auto|lra|intros t Ht;
    specialize (Pos t Ht); lra|]. lra. }
  assert (V20 : v2 0 = - (b / m2 * (T / 2))).
  { pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H 0 T ltac:(lra) ltac:(lra)) as Q.
    rewrite (Clock T) in Q by lra. lra. }
  set (S := F * cos phi). set (C := F * sin phi).
  set (A := ((a2 - m1 * om ^ 2) * S + a1 * om * C) / Z1). set (B := ((a2 - m1 * om ^ 2) * C - a1 * om * S) / Z1).
  assert (ES : S = (a2 - m1 * om ^ 2) * A - a1 * om * B) by (unfold A, B, Z1 in *; field; lra).
  assert (EC : C = (a2 - m1 * om ^ 2) * B + a1 * om * A) by (unfold A, B, Z1 in *; field; lra).
  assert (SC : F ^ 2 = Z1 * (A ^ 2 + B ^ 2)).
  { transitivity (S ^ 2 + C ^ 2); [|rewrite ES, EC; unfold Z1; ring]. pose proof (sin2_cos2 phi) as Q. unfold Rsqr in Q.
    unfold S, C. transitivity (F ^ 2 * (sin phi * sin phi + cos phi * cos phi)); [rewrite Q; ring|ring]. }
  set (X := fun t => A * sin (om * t) + B * cos (om * t) - b * k t).
  set (V := fun t => om * (A * cos (om * t) - B * sin (om * t)) - b * k' t).
  assert (DX : forall t, is_derive X t (V t)).
  { intros t. unfold X, V. derive. ring. }
  assert (DV : forall t, is_derive V t ((F * sin (om * t + phi) - a2 * X t - a1 * V t - b) / m1)).
  { intros t. rewrite sin_plus. unfold X, V. derive.
    replace (F * (sin (om * t) * cos phi + cos (om * t) * sin phi)) with (S * sin (om * t) + C * cos (om * t))
      by (unfold S, C; ring). rewrite ES, EC. field; lra. }
  assert (OT : om * T = PI) by (unfold T; field; lra).
  assert (Dv : forall t, 0 <= t < T -> rderiv (fun u => m1 * v1 u) t (F * sin (om * t + phi) - b - (a2 * x t + a1 * v1
    t))).
  { intros t Ht. apply rderiv_ext with (fun u => (m1 * v1 u + b * s u - wave F om phi u) + (wave F om phi u - b * s u)).
    { intros; ring. }
    pose proof (rderiv_wave F om phi t Hom). rate. ring. }
  destruct (no_free_response (fun t => x t - X t) (fun t => v1 t - V t)) as (ZX & ZV).
  { pose proof (cont_of_derive _ _ DX). continuous. } { pose proof (cont_of_derive _ _ DV). continuous. }
  { intros t Ht. apply rderiv_minus; [apply (f_x _ _ _ _ _ _ _ _ _ _ H); lra|apply rderiv_of_derive, DX]. }
  { intros t Ht. apply rderiv_ext with (fun u => m1 * v1 u - m1 * V u); [intros; ring|].
    eapply rderiv_eq; [|apply rderiv_minus; [apply Dv; auto|apply rderiv_scal, rderiv_of_derive, DV]]. field; lra. }
  { rewrite X0. unfold X. rewrite OT, Rmult_0_r, cos_0, sin_0, cos_PI, sin_PI. unfold T. rewrite Ek. ring. }
  { rewrite V0. unfold V. rewrite OT, Rmult_0_r, cos_0, sin_0, cos_PI, sin_PI. unfold T. rewrite Ek'. ring. }
  unfold X in ZX. unfold V in ZV. rewrite Rmult_0_r, cos_0, sin_0 in ZX, ZV.
  assert (EA : A = turn (k' 0)). { pose proof turn_0. apply Rmult_eq_reg_l with om; lra. }
  assert (Up : (m1 + m2) * (b / m2) <= C - a2 * x 0 - a1 * v1 0).
  { pose proof (exit_load _ _ _ _ _ _ _ _ _ _ 0 T _ Hm1 Hm2 H ltac:(lra) Pos Meet (rderiv_wave F om phi 0 Hom)) as Q.
    rewrite Rmult_0_r, Rplus_0_l in Q. exact Q. }
  assert (HB : leave (k 0) (k' 0) <= - B).
  { unfold leave. assert (O2 : 0 < m1 * om ^ 2) by positive. apply Rmult_le_reg_l with (m1 * om ^ 2); auto.
    replace (m1 * om ^ 2 * (b * ((m1 + m2) / m2 - a2 * k 0 - a1 * k' 0) / (m1 * om ^ 2)))
      with (b + m1 * (b / m2) - b * (a2 * k 0) - b * (a1 * k' 0)) by (field; lra).
    assert (Ex : a2 * x 0 = a2 * B - b * (a2 * k 0)) by (replace (x 0) with (B - b * k 0) by lra; ring).
    assert (Ev : a1 * v1 0 = a1 * om * A - b * (a1 * k' 0)) by (replace (v1 0) with (om * A - b * k' 0) by lra; ring).
    replace ((m1 + m2) * (b / m2)) with (b + m1 * (b / m2)) in Up by (field; lra). rewrite Ex, Ev, EC in Up. lra. }
  unfold Fslip. rewrite <- EA, <- (sqrt_pow2 F) by auto. apply sqrt_le_1_alt. rewrite SC. apply Rmult_le_compat_l;
    [lra|]. nra.
Qed.

(** [nonstop-iff] $a_1\geqslant 0$: a motion that slips one way for half a period, and then is its own negative,
    exists exactly from $U_{**}$ on, if $A>0$ and its relative velocity keeps its sign at $U_{**}$. *)
Theorem nonstop_iff F : 0 <= F -> (forall t, 0 < t < T -> 0 < slipping k' (leave (k 0) (k' 0)) t) ->
  (exists phi x v1 v2 s, nonstop F phi x v1 v2 s) <-> Fslip (k 0) (k' 0) <= F.
Proof.
  intros HF Side. split.
  - intros (phi & x & v1 & v2 & s & H). exact (nonstop_needs F phi x v1 v2 s HF H).
  - intros Q. apply nonstop_exists; auto.
Qed.
End Nonstop.
