(** Ties: the amplitudes U* and U** and the response to the square wave are what `theory/` derives. A test prints each expression of the
    theory and looks for it in the statement. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Entrainment Nonstop NonstopUndamped NonstopDamped.

(** [tie-entrained-amplitude] $U_*$, the amplitude up to which the stuck response is a motion. *)
Theorem tie_entrained_amplitude : forall m1 m2 a1 a2 b om : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> Fstar m1 m2 a1 a2 b om = (b * (/ m2) * (/ (om ^ 2)) * (sqrt (((a2 + ((-1) * m1 * (om ^ 2)) + ((-1) * m2 * (om ^ 2))) ^ 2) + ((a1 ^ 2) * (om ^ 2))))).
Proof. intros; unfold Fstar, Z. match goal with |- _ * sqrt ?x / _ = _ => match goal with |- context [sqrt ?y] =>
    lazymatch y with x => fail | _ => replace y with x by ring end end end. field; lra. Qed.

(** [tie-turn] The part in phase of a motion that never stops. *)
Theorem tie_turn : forall m1 m2 a2 b om h' : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> turn m2 b om h' = ((1 / 2) * (/ m2) * (/ (om ^ 2)) * (((-1) * PI * b) + (2 * h' * b * m2 * om))).
Proof. intros; unfold turn; field; lra. Qed.

(** [tie-leave] The size of the part out of phase with which it leaves by an edge. *)
Theorem tie_leave : forall m1 m2 a1 a2 b om h h' : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> leave m1 m2 a1 a2 b om h h' = ((-1) * (/ m1) * (/ m2) * (/ (om ^ 2)) * (((-1) * b * m1) + ((-1) * b * m2) + (h * a2 * b * m2) + (h' * a1 * b * m2))).
Proof. intros; unfold leave; field; lra. Qed.

(** [tie-non-stop-amplitude] $U_{**}$, the amplitude that slip without a stop needs, by the response to the square
    wave. *)
Theorem tie_non_stop_amplitude : forall m1 m2 a1 a2 b om h h' : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> Fslip m1 m2 a1 a2 b om h h' = sqrt ((((a2 + ((-1) * m1 * (om ^ 2))) ^ 2) + ((a1 ^ 2) * (om ^ 2))) * (((1 / 4) * (/ (m2 ^ 2)) * (/ (om ^ 4)) * ((((-1) * PI * b) + (2 * h' * b * m2 * om)) ^ 2)) + ((/ (m1 ^ 2)) * (/ (m2 ^ 2)) * (/ (om ^ 4)) * ((((-1) * b * m1) + ((-1) * b * m2) + (h * a2 * b * m2) + (h' * a1 * b * m2)) ^ 2)))).
Proof. intros; unfold Fslip, Z1, turn, leave; f_equal; field; lra. Qed.

(** [tie-non-stop-undamped] The same without a damper, in closed form. *)
Theorem tie_non_stop_undamped : forall m1 m2 a2 b om : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> Fslip_undamped m1 m2 a2 b om ^ 2 = ((((m1 * ((sqrt (a2 / m1)) ^ 2)) + ((-1) * m1 * (om ^ 2))) ^ 2) * (((1 / 4) * (/ (m2 ^ 2)) * (/ (om ^ 4)) * ((((-1) * PI * b) + ((-2) * b * m2 * om * (/ m1) * (/ (sqrt (a2 / m1))) * (tan ((1 / 2) * PI * (sqrt (a2 / m1)) * (/ om))))) ^ 2)) + ((/ (m1 ^ 2)) * (/ (m2 ^ 2)) * (/ (om ^ 4)) * ((((-1) * b * m1) + ((-1) * b * m2)) ^ 2)))).
Proof. intros; unfold Fslip_undamped. assert (W : 0 < sqrt (a2 / m1)) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; lra).
  assert (Q : a2 / m1 = sqrt (a2 / m1) ^ 2) by (rewrite pow2_sqrt; [auto|apply Rlt_le, Rdiv_lt_0_compat; lra]).
  rewrite !Rpow_mult_distr, pow2_abs. rewrite pow2_sqrt by (pose proof (pow2_ge_0 (om / sqrt (a2 / m1) * tan (PI * sqrt (a2 / m1) / (2 * om)) + PI * m1 / (2 * m2))); pose proof (pow2_ge_0 ((m1 + m2) / m2)); lra).
  replace (a2 / m1 - om ^ 2) with (sqrt (a2 / m1) ^ 2 - om ^ 2) by (rewrite <- Q; auto).
  match goal with |- context [tan ?x] => let y := fresh "y" in set (y := tan x) in *;
    repeat match goal with |- context [tan ?z] => replace (tan z) with y by (unfold y; f_equal; field; lra) end; clearbody y end.
  set (w := sqrt (a2 / m1)) in *; clearbody w. field; lra. Qed.

(** [tie-non-stop-damped] The same with a damper that lets body 1 swing. *)
Theorem tie_non_stop_damped : forall m1 m2 a1 a2 b om : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> 0 < a1 -> a1 ^ 2 < 4 * m1 * a2 -> Fslip_damped m1 m2 a1 a2 b om = sqrt ((((a2 + ((-1) * m1 * (om ^ 2))) ^ 2) + ((a1 ^ 2) * (om ^ 2))) * (((1 / 4) * (/ (m2 ^ 2)) * (/ (om ^ 4)) * ((((-1) * PI * b) + (2 * (turn_speed m1 a1 a2 om) * b * m2 * om)) ^ 2)) + ((/ (m1 ^ 2)) * (/ (m2 ^ 2)) * (/ (om ^ 4)) * ((((-1) * b * m1) + ((-1) * b * m2) + ((turn_place m1 a1 a2 om) * a2 * b * m2) + ((turn_speed m1 a1 a2 om) * a1 * b * m2)) ^ 2)))).
Proof. intros. rewrite <- Fslip_swing, swing_0, swing'_0 by lra. apply tie_non_stop_amplitude; lra. Qed.

(** body 1's exponential, frequency, fading, cosine and sine as letters *)
Ltac letters := unfold turn_place, turn_speed, weight, cosh, sinh in *; lazymatch goal with
  Hm : 0 < ?m1, Ha : 0 < ?a2, D : ?a1 ^ 2 < 4 * (?m1 * ?a2), W : 0 < (exp ?p + _) / 2 + cos ?x |- _ =>
    pose proof (od_pos m1 a1 a2 Hm ltac:(lra)); pose proof (od_sq m1 a1 a2 Hm ltac:(lra));
    pose proof (exp_pos (- p));
    replace (exp p) with (/ exp (- p)) in * by (rewrite exp_Ropp; field; apply Rgt_not_eq, exp_pos);
    set (c := cos x) in *; set (s := sin x) in *;
    repeat match goal with |- context [cos ?z] => replace (cos z) with c by (unfold c; f_equal; field; lra) end;
    repeat match goal with |- context [sin ?z] => replace (sin z) with s by (unfold s; f_equal; field; lra) end;
    set (d := exp (- p)) in *; set (o := ring_frequency m1 a1 a2) in *; set (l := Waves.fade m1 a1) in *;
    clearbody c s d o l; assert (N : 0 < 1 + 2 * d * c + d ^ 2) by
      (replace (1 + 2 * d * c + d ^ 2) with (2 * d * ((/ d + d) / 2 + c)) by (field; lra); nra);
    assert (0 < l ^ 2 + o ^ 2) by (pose proof (pow2_ge_0 l); nra) end.
(** the denominators in them are not 0 *)
Ltac nonzero := field; repeat split; try lra; match goal with N : 0 < 1 + 2 * ?d * ?c + ?d ^ 2 |- ?t <> 0 =>
  first [replace t with (1 + 2 * d * c + d ^ 2) by ring; lra | apply Rgt_not_eq, Rlt_gt;
    match goal with M : 0 < ?m, O : 0 < ?o, K : 0 < ?l ^ 2 + ?o ^ 2 |- _ =>
      first [replace t with (m * o * (1 + 2 * d * c + d ^ 2)) by ring
        | replace t with (m * o * (l ^ 2 + o ^ 2) * (1 + 2 * d * c + d ^ 2)) by ring]; positive end] end.

(** [tie-turn-place] The place of body 1 where the square wave turns. *)
Theorem tie_turn_place : forall m1 m2 a1 a2 b om : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> 0 <= a1 -> a1 ^ 2 < 4 * (m1 * a2) -> 0 < weight m1 a1 a2 om -> turn_place m1 a1 a2 om = ((/ ((m1 * ((ring_frequency m1 a1 a2) ^ 3)) + (m1 * (ring_frequency m1 a1 a2) * ((Waves.fade m1 a1) ^ 2)) + (m1 * ((exp (- (Waves.fade m1 a1 * (PI / om)))) ^ 2) * ((ring_frequency m1 a1 a2) ^ 3)) + (m1 * (ring_frequency m1 a1 a2) * ((exp (- (Waves.fade m1 a1 * (PI / om)))) ^ 2) * ((Waves.fade m1 a1) ^ 2)) + (2 * (exp (- (Waves.fade m1 a1 * (PI / om)))) * m1 * ((ring_frequency m1 a1 a2) ^ 3) * (cos (PI * (ring_frequency m1 a1 a2) * (/ om)))) + (2 * (exp (- (Waves.fade m1 a1 * (PI / om)))) * m1 * (ring_frequency m1 a1 a2) * ((Waves.fade m1 a1) ^ 2) * (cos (PI * (ring_frequency m1 a1 a2) * (/ om)))))) * (((-1) * (ring_frequency m1 a1 a2)) + ((ring_frequency m1 a1 a2) * ((exp (- (Waves.fade m1 a1 * (PI / om)))) ^ 2)) + (2 * (exp (- (Waves.fade m1 a1 * (PI / om)))) * (Waves.fade m1 a1) * (sin (PI * (ring_frequency m1 a1 a2) * (/ om)))))).
Proof. intros; letters. subst a2. nonzero. Qed.

(** [tie-turn-speed] Its velocity there. *)
Theorem tie_turn_speed : forall m1 m2 a1 a2 b om : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < om -> 0 <= a1 -> a1 ^ 2 < 4 * (m1 * a2) -> 0 < weight m1 a1 a2 om -> turn_speed m1 a1 a2 om = ((-2) * (exp (- (Waves.fade m1 a1 * (PI / om)))) * (/ ((m1 * (ring_frequency m1 a1 a2)) + (m1 * (ring_frequency m1 a1 a2) * ((exp (- (Waves.fade m1 a1 * (PI / om)))) ^ 2)) + (2 * (exp (- (Waves.fade m1 a1 * (PI / om)))) * m1 * (ring_frequency m1 a1 a2) * (cos (PI * (ring_frequency m1 a1 a2) * (/ om)))))) * (sin (PI * (ring_frequency m1 a1 a2) * (/ om)))).
Proof. intros; letters. nonzero. Qed.
