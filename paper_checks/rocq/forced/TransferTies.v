(** Ties: the fastest transfer and the amplitudes that it needs are what `theory/` derives. A test prints each expression of the
    theory and looks for it in the statement. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Forced LeastTimeTransfer LeastAmplitude.

(** every square root of a parameter as a letter of its own *)
Ltac root y := let w := fresh "w" in let E := fresh "E" in let P := fresh "P" in
  assert (P : 0 < sqrt y) by (apply sqrt_lt_R0; lra); assert (E : sqrt y * sqrt y = y) by (apply sqrt_sqrt; lra);
  set (w := sqrt y) in *; clearbody w.

(** [tie-half-time] Half the least time of a transfer. *)
Theorem tie_half_time : forall m2 b D : R, 0 < m2 -> 0 < b -> 0 < D -> half_time m2 b D = ((sqrt D) * (/ (sqrt b)) * (sqrt m2)).
Proof. intros; unfold half_time. rewrite sqrt_div_alt by lra. rewrite sqrt_mult by lra. field.
  apply Rgt_not_eq, sqrt_lt_R0; lra. Qed.

(** [tie-stuck-force] The force of the fastest stuck transfer: that of the stuck pair along it. *)
Theorem tie_stuck_force : forall m1 m2 a1 a2 b D t : R, stuck_force m1 m2 a1 a2 b D t = (((push m2 b (half_time m2 b D) t) * m1) + ((push m2 b (half_time m2 b D) t) * m2) + ((bang m2 b (half_time m2 b D) t) * a1) + ((run m2 b (half_time m2 b D) t - run m2 b (half_time m2 b D) 0) * a2)).
Proof. intros; unfold stuck_force; ring. Qed.

(** [tie-stuck-amplitude] The amplitude of the fastest stuck transfer. *)
Theorem tie_stuck_amplitude : forall m1 m2 a1 a2 b D F : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 <= a1 -> 0 < D ->
  (forall t, 0 <= t -> Rabs (stuck_force m1 m2 a1 a2 b D t) <= F) <->
  (b + ((1 / 2) * D * a2) + (b * m1 * (/ m2)) + (a1 * (sqrt D) * (sqrt b) * (/ (sqrt m2)))) <= F /\ (D * a2) <= F /\ (0 <= ((D * (a2 ^ 2)) + ((-1) * b * (a1 ^ 2) * (/ m2))) -> (((-1) * b) + (D * a2) + ((-1) * b * m1 * (/ m2)) + ((1 / 2) * b * (a1 ^ 2) * (/ a2) * (/ m2))) <= F).
Proof. intros m1 m2 a1 a2 b D F Hm1 Hm2 Ha2 Hb Ha1 HD.
  rewrite (stuck_amplitude m1 m2 a1 a2 b D Hm1 Hm2 Ha1 Ha2 Hb HD F).
  assert (Z : sqrt (b / m2 * D) = sqrt D * sqrt b * / sqrt m2).
  { rewrite sqrt_mult_alt by (apply Rlt_le, Rdiv_lt_0_compat; lra). rewrite sqrt_div_alt by lra. unfold Rdiv. ring. }
  assert (S : 0 < sqrt m2) by (apply sqrt_lt_R0; lra). rewrite Z. root m2. clear Z.
  split; intros (A & B & C); (split; [|split; [|intros N; specialize (C ltac:(unfold Rdiv in *; lra))]]);
    unfold Rdiv in *; repeat match goal with A : ?x <= F |- ?y <= F => replace y with x by (field; lra); assumption end. Qed.

(** [tie-least-amplitude] The least amplitude with which body 2 arrives in the least time, by body 1's impulse
    response. *)
Theorem tie_least_amplitude : forall m1 m2 a1 a2 b D F : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 <= a1 -> 0 < D -> forall g g' : R -> R,
  (forall t, is_derive g t (g' t)) -> (forall t, is_derive g' t (- (a2 * g t + a1 * g' t) / m1)) ->
  g 0 = 0 -> g' 0 = / m1 -> (forall t, 0 <= t <= half_time m2 b D -> 0 <= g' t) -> 0 < g (half_time m2 b D) ->
  (exists v, arrives m1 m2 a1 a2 b D F v) <-> (b + (b * (half_time m2 b D) * (/ (g (half_time m2 b D))) * (/ m2))) <= F.
Proof. intros m1 m2 a1 a2 b D F Hm1 Hm2 Ha2 Hb Ha1 HD g g' Dg Dg' G0 G0' Gp Gt.
  rewrite (least_amplitude m1 m2 a1 a2 b D Hm1 Hm2 Ha1 Ha2 Hb HD g g' Dg Dg' G0 G0' Gp Gt F).
  match goal with |- ?x <= F <-> ?y <= F => replace y with x by (field; lra) end. reflexivity. Qed.

(** [tie-least-amplitude-undamped] The same without a damper, by the angle that body 1 turns in half of that time. *)
Theorem tie_least_amplitude_undamped : forall m1 m2 a2 b D F : R, 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> 0 < D -> sqrt (a2 / m1) * half_time m2 b D <= PI / 2 ->
  (exists v, arrives m1 m2 0 a2 b D F v) <-> ((/ m2) * (/ (sin (sqrt (a2 / m1) * half_time m2 b D))) * ((b * m1 * (sqrt (a2 / m1) * half_time m2 b D)) + (b * m2 * (sin (sqrt (a2 / m1) * half_time m2 b D))))) <= F.
Proof. intros m1 m2 a2 b D F Hm1 Hm2 Ha2 Hb HD Hth.
  pose proof (least_amplitude_undamped m1 m2 a2 b D F Hm1 Hm2 Ha2 Hb HD) as Q. cbv zeta in Q. rewrite (Q Hth).
  assert (0 < sin (sqrt (a2 / m1) * half_time m2 b D)).
  { apply sin_gt_0; [apply Rmult_lt_0_compat; [apply sqrt_lt_R0, Rdiv_lt_0_compat|apply tau_pos]; auto|
      pose proof PI_RGT_0; lra]. }
  match goal with |- ?x <= F <-> ?y <= F => replace y with x by (field; lra) end. reflexivity. Qed.
