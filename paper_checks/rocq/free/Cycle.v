(** One cycle: slip from an exit ray, landing inside the strip, stick along an ellipse to the opposite ray. *)
From Coq Require Import Nsatz.
From InertialPair Require Import Dini Pair Stick Excursion FollowArc.

Section Cycle.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let q := m1 / M.
Let r := m2 / M.
Let om := omega m1 m2 a2.
Let L := L m1 m2 a2 b.
Let Ecr := Ecr m1 m2 a2 b.

(** o1: frequency of the slip; ray u: speed on the exit ray in the reduced unit, so that E = E_cr (1 + q u^2) there *)
Definition o1 := sqrt (a2 / m1).
(** the speed on an exit ray for the push u *)
Definition ray u := b / (m2 * o1) * u.
(** the state on the exit ray of the side k = 1 or -1 *)
Definition on_ray k u (x v1 v2 : R -> R) t := k * x t = L /\ k * v1 t = ray u /\ k * v2 t = ray u.

Lemma o1_pos : 0 < o1. Proof. apply sqrt_lt_R0, Rdiv_lt_0_compat; lra. Qed.
Lemma o1_sq : a2 = m1 * (o1 * o1). Proof. unfold o1. rewrite sqrt_sqrt; [field; lra|].
  apply Rlt_le, Rdiv_lt_0_compat; lra. Qed.
Lemma q_pos : 0 < q. Proof. unfold q, M; apply Rdiv_lt_0_compat; lra. Qed.
Lemma r_pos : 0 < r. Proof. unfold r, M; apply Rdiv_lt_0_compat; lra. Qed.
Lemma qr_one : q + r = 1. Proof. unfold q, r, M; field; lra. Qed.
Lemma ray_pos u : 0 < u -> 0 < ray u.
Proof. intros. pose proof o1_pos. unfold ray. apply Rmult_lt_0_compat; auto. apply Rdiv_lt_0_compat; auto.
  apply Rmult_lt_0_compat; auto. Qed.
Lemma Mom : a2 = M * (om * om).
Proof. unfold om, M. rewrite (omega_sq m1 m2 a2) by auto. field; lra. Qed.
Lemma L_o1 : L = b * M / (m1 * (o1 * o1) * m2).
Proof. unfold L, Stick.L. fold M. rewrite o1_sq at 1. auto. Qed.

(** E = E_cr (1 + q u^2) on the surface at x = +-L exactly for the speed ray u *)
Lemma level_speed v u : energy m1 m2 a2 L v v = Ecr * (1 + q * u ^ 2) -> v ^ 2 = ray u ^ 2.
Proof.
  intros E. unfold Ecr in E. rewrite Ecr_L in E by auto. fold L in E. pose proof o1_pos.
  assert (Z : M / 2 * (v ^ 2 - ray u ^ 2) = 0).
  { replace (M / 2 * (v ^ 2 - ray u ^ 2)) with (energy m1 m2 a2 L v v - (a2 * L ^ 2 / 2 + M / 2 * ray u ^ 2)) by
    (unfold energy, M; field).
    rewrite E. unfold ray. rewrite L_o1. rewrite o1_sq. unfold q, M. field. repeat split; lra. }
  assert (0 < M) by positive. apply Rmult_integral in Z. lra.
Qed.
Lemma ray_level u : energy m1 m2 a2 L (ray u) (ray u) = Ecr * (1 + q * u ^ 2).
Proof.
  unfold Ecr. rewrite Ecr_L by auto. fold L. pose proof o1_pos. unfold energy, ray. rewrite L_o1. rewrite o1_sq.
    unfold q, M. field. repeat split; lra.
Qed.

(** *** Stick: the arc of an ellipse above E_cr inside the strip *)
Definition Cx al rho t := L * rho * cos (al + om * t).
(** its speed *)
Definition Cv al rho t := - (L * rho * om * sin (al + om * t)).
(** the arc obeys the law from the angle al to the edge: the friction that sticking needs stays in [-1, 1] *)
Lemma stick_arc al rho : 1 <= rho -> 0 <= al -> rho * cos al <= 1 ->
  arc m1 m2 a2 b ((acos (- / rho) - al) / om) (Cx al rho) (Cv al rho) (Cv al rho) (fun t => m2 / b * (- (om * om)
    * Cx al rho t)).
Proof.
  intros Hr Ha Hc. pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O. fold om in O. pose proof Mom as Mo.
  assert (M0 : 0 < M) by positive. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0. fold L in L0. constructor.
  - intros t. unfold Cx, Cv. auto_derive; auto. ring.
  - intros t. unfold Cx, Cv. auto_derive; auto. rewrite Mo. unfold M. field. lra.
  - intros t. unfold Cx, Cv. auto_derive; auto. field. lra.
  - intros t Ht. split; [|split; intros; lra].
    assert (Ir : 0 < / rho <= 1). { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1.
      apply Rinv_le_contravar; lra. }
    assert (Th : al <= al + om * t <= acos (- / rho)).
    { split; [assert (0 <= om * t) by positive; lra|].
      apply Rplus_le_reg_l with (- al). replace (- al + (al + om * t)) with (om * t) by ring.
      replace (- al + acos (- / rho)) with (om * ((acos (- / rho) - al) / om)) by (field; lra).
        apply Rmult_le_compat_l; lra. }
    pose proof (acos_bound (- / rho)) as Ab. assert (C1 : cos (al + om * t) <= cos al). { apply cos_decr_1; lra. }
    assert (C2 : - / rho <= cos (al + om * t)). { rewrite <- (cos_acos (- / rho)) at 1 by lra. apply cos_decr_1; lra. }
    assert (K : m2 / b * (om * om) * L = 1). { unfold L, Stick.L. rewrite Mo at 1. unfold M. field. repeat split; lra. }
    assert (K2 : -1 <= rho * cos (al + om * t) <= 1).
    { split; [|apply Rle_trans with (rho * cos al); auto; apply Rmult_le_compat_l; lra].
      replace (-1) with (rho * - / rho) by (field; lra). scale. }
    replace (m2 / b * (- (om * om) * Cx al rho t)) with (- (m2 / b * (om * om) * L * (rho * cos (al + om * t))))
      by (unfold Cx; ring).
    rewrite K. lra.
Qed.

(** rho: amplitude over L at the level y = w/q *)
Definition amp y := sqrt (1 + q * y).
Lemma amp_sq y : 0 <= y -> amp y * amp y = 1 + q * y.
Proof. intros. pose proof q_pos. apply sqrt_sqrt. assert (0 <= q * y) by positive. lra. Qed.
Lemma amp_ge y : 0 <= y -> 1 <= amp y.
Proof. intros. pose proof q_pos. unfold amp. rewrite <- sqrt_1 at 1. apply sqrt_le_1_alt.
  assert (0 <= q * y) by positive. lra. Qed.

(** the data of the stick from (L z, v), v < 0, at the level y = u^2: it starts there and ends on the ray x = -L with
    speed ray u *)
Lemma stick_ends z v u : 0 < u -> -1 <= z <= 1 -> v < 0 -> energy m1 m2 a2 (L * z) v v = Ecr * (1 + q * u ^ 2) ->
  let rho := amp (u ^ 2) in let al := acos (z / rho) in let T := (acos (- / rho) - al) / om in
  1 < rho /\ 0 < al < PI /\ rho * cos al = z /\ al + om * T = acos (- / rho) /\ cos (acos (- / rho)) = - / rho /\
    0 <= T < PI / om /\
  Cx al rho 0 = L * z /\ Cv al rho 0 = v /\ Cx al rho T = - L /\ Cv al rho T = - ray u.
Proof.
  intros Hu Hz Hv En rho al T.
  pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O. fold om in O. pose proof Mom as Mo. pose proof q_pos as Q0.
  assert (M0 : 0 < M) by positive. pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0. fold L in L0.
  assert (U2 : 0 < u ^ 2) by positive.
  assert (R1 : 1 <= rho) by (apply amp_ge; lra). assert (R2 : rho * rho = 1 + q * u ^ 2) by (apply amp_sq; lra).
  assert (R3 : 1 < rho). { assert (0 < q * u ^ 2) by positive.
    destruct (Req_dec rho 1) as [E|]; [|lra]. rewrite E in R2. lra. }
  assert (Ir : 0 < / rho < 1). { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1.
    apply Rinv_lt_contravar; lra. }
  assert (Zr : - / rho <= z / rho <= / rho). { unfold Rdiv. split; [|]; nra. }
  pose proof (acos_bound (z / rho)) as Ab. fold al in Ab. pose proof (acos_bound (- / rho)) as Ag.
  assert (Ca : cos al = z / rho) by (apply cos_acos; lra).
    assert (Cg : cos (acos (- / rho)) = - / rho) by (apply cos_acos; lra).
  assert (Ord : al <= acos (- / rho)). { apply cos_decr_0; lra. }
  assert (Al0 : 0 < al). { destruct (Req_dec al 0) as [E|]; [|lra]. rewrite E, cos_0 in Ca. lra. }
  assert (AlP : al < PI). { destruct (Req_dec al PI) as [E|]; [|lra]. rewrite E, cos_PI in Ca. lra. }
  assert (HT : 0 <= T < PI / om).
  { unfold T. split; [positive|]. apply Rmult_lt_compat_r; [positive|]. lra. }
  assert (Rc : rho * cos al = z) by (rewrite Ca; field; lra).
  assert (Ang : al + om * T = acos (- / rho)) by (unfold T; field; lra).
  assert (Sp : forall g, 0 <= g -> 0 <= L * rho * om * g).
  { intros g Hg. apply Rmult_le_pos; auto. apply Rmult_le_pos; [|lra]. positive. }
  repeat (split; [auto; fail|]). split; [|split; [|split]].
  - unfold Cx. rewrite Rmult_0_r, Rplus_0_r, Rmult_assoc, Rc. auto.
  - unfold Cv. rewrite Rmult_0_r, Rplus_0_r. pose proof (sin2_cos2 al) as SC. unfold Rsqr in SC.
    assert (Sa : 0 <= sin al) by (apply sin_ge_0; lra). specialize (Sp _ Sa).
    assert (Sq : v ^ 2 = (L * rho * om * sin al) ^ 2); [|nra].
    assert (Z : M / 2 * (v ^ 2 - (L * rho * om * sin al) ^ 2) = 0); [|apply Rmult_integral in Z; lra].
    unfold Ecr in En. rewrite Ecr_L in En by auto. fold L in En.
    replace (M / 2 * (v ^ 2 - (L * rho * om * sin al) ^ 2)) with
      (energy m1 m2 a2 (L * z) v v - a2 * (L * z) ^ 2 / 2 - M * (om * om) * L ^ 2 / 2 * (rho * rho * (sin al * sin al)))
      by (unfold energy, M; field).
    rewrite En, <- Mo. replace (sin al * sin al) with (1 - cos al * cos al) by lra.
    replace (rho * rho * (1 - cos al * cos al)) with (rho * rho - (rho * cos al) * (rho * cos al)) by ring.
      rewrite Rc, R2. field.
  - unfold Cx. rewrite Ang, Cg. field. lra.
  - unfold Cv. rewrite Ang. f_equal. pose proof (sin2_cos2 (acos (- / rho))) as SC. unfold Rsqr in SC. rewrite Cg in SC.
    set (sg := sin (acos (- / rho))) in *. assert (Sg : 0 <= sg) by (apply sin_ge_0; lra). specialize (Sp _ Sg).
    pose proof (ray_pos u Hu). assert (Sq : (L * rho * om * sg) ^ 2 = ray u ^ 2); [|nra].
    apply level_speed. unfold Ecr. rewrite Ecr_L by auto. fold L.
    replace (energy m1 m2 a2 L (L * rho * om * sg) (L * rho * om * sg)) with
      (a2 * L ^ 2 / 2 + M * (om * om) * L ^ 2 / 2 * (rho * rho * (sg * sg))) by (unfold energy, M; field).
    replace (sg * sg) with (1 - / rho * / rho) by lra.
    replace (rho * rho * (1 - / rho * / rho)) with (rho * rho - 1) by (field; lra). rewrite R2, <- Mo. field.
Qed.

(** [stick-arc] On $S_0$ above $E_{cr}$ and moving to the left every solution sticks until it reaches the left exit
    ray, at a time in closed form. *)
Theorem stick x v1 v2 s t0 z u : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> 0 < u ->
  x t0 = L * z -> -1 <= z <= 1 -> v1 t0 < 0 -> v2 t0 = v1 t0 ->
  energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) = Ecr * (1 + q * u ^ 2) ->
  let T := (acos (- / amp (u ^ 2)) - acos (z / amp (u ^ 2))) / om in
  0 <= T < PI / om /\ on_ray (-1) u x v1 v2 (t0 + T) /\
  (forall t, 0 <= t <= T -> v1 (t0 + t) = v2 (t0 + t) /\ - L <= x (t0 + t) <= L).
Proof.
  intros H Ht Hu Ex Hz Hv Ev En. rewrite Ex, Ev in En.
  destruct (stick_ends z (v1 t0) u Hu Hz Hv En) as (R3 & Al & Rc & Ang & Cg & HT & X0 & V0 & XT & VT).
  set (rho := amp (u ^ 2)) in *. set (al := acos (z / rho)) in *. set (T := (acos (- / rho) - al) / om) in *.
    intros T'. change T' with T. clear T'.
  pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as O. fold om in O.
    pose proof (L_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb) as L0. fold L in L0.
  assert (A := stick_arc al rho ltac:(lra) ltac:(lra) ltac:(lra)). fold T in A.
  assert (F := follow m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s _ _ _ _ _ t0 H A Ht ltac:(congruence) ltac:(congruence)
    ltac:(congruence)).
  split; [auto|]. split.
  - destruct (F T ltac:(lra)) as (G0 & G1 & G2). unfold on_ray. rewrite G0, G1, G2, XT, VT. repeat split; ring.
  - intros t Hu'. destruct (F t Hu') as (G0 & G1 & G2). split; [rewrite G1, G2; auto|]. rewrite G0. unfold Cx.
    pose proof (acos_bound (- / rho)) as Ag. assert (Th : al <= al + om * t <= acos (- / rho)).
    { split; [assert (0 <= om * t) by positive; lra|]. rewrite <- Ang.
      apply Rplus_le_compat_l, Rmult_le_compat_l; lra. }
    assert (C1 : cos (al + om * t) <= cos al) by (apply cos_decr_1; lra).
    assert (C2 : - / rho <= cos (al + om * t)) by (rewrite <- Cg; apply cos_decr_1; lra).
    assert (K2 : -1 <= rho * cos (al + om * t) <= 1).
    { split; [|apply Rle_trans with (rho * cos al); [apply Rmult_le_compat_l|]; lra].
      replace (-1) with (rho * - / rho) by (field; lra). scale. }
    rewrite Rmult_assoc. split; nra.
Qed.
End Cycle.
