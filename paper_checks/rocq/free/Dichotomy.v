(** Every solution tends to one stuck motion; it merges with it in finite time or it is on the critical ellipse. *)
From InertialPair Require Import Dini Pair Stick EnergyLimit.

Section Dichotomy.
Variables m1 m2 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Variables x v1 v2 s : R -> R.
Hypothesis H : solution m1 m2 0 a2 b x v1 v2 s.

Let M := m1 + m2.
Let om := omega m1 m2 a2.
Let w t := v1 t - v2 t.
Let P t := m1 * v1 t + m2 * v2 t.
Let E t := energy m1 m2 a2 (x t) (v1 t) (v2 t).
Let A t := x t * cos (om * t) - P t / (M * om) * sin (om * t).
Let B t := x t * sin (om * t) + P t / (M * om) * cos (om * t).
Let kap := m2 / (M * b).
Let X := X m1 m2 a2.
Let V := V m1 m2 a2.
Let distance x0 v0 t := energy m1 m2 a2 (x t - X x0 v0 t) (v1 t - V x0 v0 t) (v2 t - V x0 v0 t).

(** [convergence] Every solution tends to one stuck motion. *)
Theorem convergence : exists x0 v0, energy m1 m2 a2 x0 v0 v0 <= Ecr m1 m2 a2 b /\
  (forall t, 0 <= t -> energy m1 m2 a2 x0 v0 v0 <= E t) /\
  (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> E t <= energy m1 m2 a2 x0 v0 v0 + e) /\
  (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> distance x0 v0 t <= e).
Proof.
  pose proof (omega_pos m1 m2 a2 Hm1 Hm2 Ha2) as om_pos. pose proof (omega_sq m1 m2 a2 Hm1 Hm2 Ha2) as om_sq.
  fold om in om_pos, om_sq. fold M in om_sq. assert (M_pos : 0 < M) by positive.
  assert (kap_pos : 0 < kap). { unfold kap; apply Rdiv_lt_0_compat; auto. positive. }
  assert (Ma : a2 = M * (om * om)) by (rewrite om_sq; field; lra).
  destruct (E_limit m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H) as (l & Hl0 & Hl & Hlim).
  pose proof (limit_not_above m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H l Hl Hlim) as HL.
  change (forall t, 0 <= t -> l <= E t) in Hl.
    change (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> E t <= l + e) in Hlim.
  destruct (paid_limit E A kap l (Rlt_le _ _ kap_pos) Hl (A_paid m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H)) as (a & HA).
  destruct (paid_limit E B kap l (Rlt_le _ _ kap_pos) Hl (B_paid m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H)) as (c & HB).
  exists a, (om * c). assert (En : energy m1 m2 a2 a (om * c) (om * c) = a2 / 2 * (a ^ 2 + c ^ 2)).
  { unfold energy. rewrite Ma. unfold M. field. }
  assert (Con : forall T, 0 <= T -> exists t, T <= t /\
    w t = 0) by (exact (contact' m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s H)).
  assert (EAB : forall t, E t = a2 / 2 * (A t ^ 2 + B t ^ 2) + m1 * m2 / (2 * M) * w t ^ 2) by (exact (E_AB m1 m2
    a2 Hm1 Hm2 Ha2 x v1 v2)).
  assert (El : a2 / 2 * (a ^ 2 + c ^ 2) = l).
  { set (d := a2 / 2 * (a ^ 2 + c ^ 2) - l). destruct (Req_dec d 0) as [|Nd]; [unfold d in *; lra|exfalso].
    set (C := 1 + a2 * kap * (Rabs a + Rabs c + 1 + kap)). pose proof (Rabs_pos a). pose proof (Rabs_pos c).
    assert (HC : 0 < C). { unfold C. assert (0 < a2 * kap) by positive. nra. }
    assert (Dp : 0 < Rabs d) by (apply Rabs_pos_lt; auto).
    set (e := Rmin 1 (Rabs d / (2 * C))). assert (He : 0 < e) by positive.
    assert (He1 : e <= 1) by apply Rmin_l. assert (He2 : e <= Rabs d / (2 * C)) by apply Rmin_r.
    assert (He3 : C * e <= Rabs d / 2). { replace (Rabs d / 2) with (C * (Rabs d / (2 * C))) by (field; lra).
      apply Rmult_le_compat_l; lra. }
    destruct (Hlim e He) as (T & HT & KT). destruct (Con T HT) as (t & Ht & Wt).
    pose proof (EAB t) as Q. rewrite Wt in Q. pose proof (HA t ltac:(lra)) as QA. pose proof (HB t ltac:(lra)) as QB.
    pose proof (KT t Ht). pose proof (Hl t ltac:(lra)). assert (ke : kap * (E t - l) <= kap * e) by scale.
    assert (Sq : forall F g, Rabs (F - g) <= kap * e -> Rabs (F ^ 2 - g ^ 2) <= kap * e * (2 * Rabs g + kap)).
    { intros F g HF. replace (F ^ 2 - g ^ 2) with ((F - g) * (2 * g + (F - g))) by ring. rewrite Rabs_mult.
      apply Rmult_le_compat; auto using Rabs_pos. eapply Rle_trans; [apply Rabs_triang|].
        rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
      assert (kap * e <= kap * 1) by scale. lra. }
    assert (SA := Sq (A t) a ltac:(lra)). assert (SB := Sq (B t) c ltac:(lra)). apply Rabs_inv in SA.
      apply Rabs_inv in SB.
    assert (Rabs d <= C * e); [|lra].
    assert (Dd : d = (E t - l) - a2 / 2 * ((A t ^ 2 - a ^ 2) + (B t ^ 2 - c ^ 2))) by (unfold d; rewrite Q; ring).
    assert (Up : Rabs (a2 / 2 * ((A t ^ 2 - a ^ 2) + (B t ^ 2 - c ^ 2))) <= a2 * kap * (Rabs a + Rabs c + kap) * e).
    { rewrite Rabs_mult, (Rabs_pos_eq (a2 / 2)) by lra.
      replace (a2 * kap * (Rabs a + Rabs c + kap) * e) with (a2 / 2 * (kap * e * (2 * Rabs a + kap) + kap * e * (2
        * Rabs c + kap))) by field.
      apply Rmult_le_compat_l; [lra|]. apply Rabs_le; lra. }
    apply Rabs_inv in Up. assert (0 < a2 * kap * e) by positive. rewrite Dd. apply Rabs_le. unfold C. lra. }
  assert (Cl : energy m1 m2 a2 a (om * c) (om * c) = l) by lra. rewrite Cl.
  split; [auto|]. split; [auto|]. split; [auto|]. intros e He.
  set (C := a2 * kap ^ 2). assert (HC : 0 < C) by positive.
  set (e1 := Rmin 1 (e / C)). assert (He1 : 0 < e1) by positive.
  assert (e1 <= 1) by apply Rmin_l. assert (e1 <= e / C) by apply Rmin_r.
  assert (C * e1 <= e). { apply Rle_trans with (C * (e / C)); [scale|right; field; lra]. }
  destruct (Hlim e1 He1) as (T & HT & KT). destruct (Con T HT) as (tc & Htc & Wc).
  exists tc; split; [lra|]. intros t Ht. assert (St : distance a (om * c) t <= distance a (om * c) tc).
  { apply (ellipse_stable m1 m2 a2 b Hm1 Hm2 Ha2 Hb a (om * c) x v1 v2 s tc t); auto; lra. }
  apply Rle_trans with (1 := St).
  pose proof (x_AB m1 m2 a2 x v1 v2 tc) as XT. pose proof (P_AB m1 m2 a2 Hm1 Hm2 Ha2 x v1 v2 tc) as PT.
  change (x tc = A tc * cos (om * tc) + B tc * sin (om * tc)) in XT.
  change (P tc = M * om * (B tc * cos (om * tc) - A tc * sin (om * tc))) in PT.
  assert (V1 : v1 tc = om * (B tc * cos (om * tc) - A tc * sin (om * tc))).
  { apply Rmult_eq_reg_l with M; [|lra]. unfold P in PT. unfold w in Wc.
    replace (v2 tc) with (v1 tc) in PT by lra. unfold M in *; lra. }
  assert (V2 : v2 tc = v1 tc) by (unfold w in Wc; lra).
  assert (Dc : distance a (om * c) tc = a2 / 2 * ((A tc - a) ^ 2 + (B tc - c) ^ 2)).
  { unfold distance. rewrite V2, XT, V1. unfold X, V, Stick.X, Stick.V. fold om.
    pose proof (sin2_cos2 (om * tc)) as SC. unfold Rsqr in SC.
    set (co := cos (om * tc)) in *. set (si := sin (om * tc)) in *. unfold energy. rewrite Ma.
    replace (om * c / om) with c by (field; lra).
    replace (M * (om * om) / 2 * ((A tc - a) ^ 2 + (B tc - c) ^ 2)) with (M * (om * om) / 2 * ((A tc - a) ^ 2 + (B
      tc - c) ^ 2) * (si * si + co * co)) by (rewrite SC; ring).
    unfold M. field. }
  rewrite Dc. pose proof (HA tc ltac:(lra)) as QA. pose proof (HB tc ltac:(lra)) as QB.
  pose proof (KT tc Htc). pose proof (Hl tc ltac:(lra)).
  assert (Sq : forall z, Rabs z <= kap * (E tc - l) -> z ^ 2 <= kap ^ 2 * e1).
  { intros z Hz. rewrite <- (pow2_abs z). assert (Rabs z <= kap * e1). { eapply Rle_trans; [exact Hz|].
    apply Rmult_le_compat_l; lra. }
    pose proof (Rabs_pos z). assert (Rabs z ^ 2 <= (kap * e1) ^ 2) by (apply pow_incr; lra).
    assert ((kap * e1) ^ 2 <= kap ^ 2 * e1). { rewrite Rpow_mult_distr.
      apply Rmult_le_compat_l; [positive|]. nra. } lra. }
  pose proof (Sq _ QA). pose proof (Sq _ QB).
  apply Rle_trans with (a2 / 2 * (kap ^ 2 * e1 + kap ^ 2 * e1)). { scale. }
  replace (a2 / 2 * (kap ^ 2 * e1 + kap ^ 2 * e1)) with (C * e1) by (unfold C; field). auto.
Qed.

(** [dichotomy] Every solution merges in finite time with an ellipse, or stays above $E_{cr}$ and tends to one motion
    on the critical one. *)
Theorem dichotomy : (exists t0 x0 v0, 0 <= t0 /\ energy m1 m2 a2 x0 v0 v0 <= Ecr m1 m2 a2 b /\
     forall u, 0 <= u -> x (t0 + u) = X x0 v0 u /\ v1 (t0 + u) = V x0 v0 u /\ v2 (t0 + u) = V x0 v0 u) \/
  (exists x0 v0, energy m1 m2 a2 x0 v0 v0 = Ecr m1 m2 a2 b /\ (forall t, 0 <= t -> Ecr m1 m2 a2 b < E t) /\
     forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> distance x0 v0 t <= e).
Proof.
  destruct (Classical_Prop.classic (exists T, 0 <= T /\ E T <= Ecr m1 m2 a2 b)) as [(T & HT & HE)|N].
  - left. destruct (merging m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s T H HT HE) as (t0 & Ht & He & K).
    exists t0, (x t0), (v1 t0). split; [lra|]. split; [exact He|]. exact K.
  - right. destruct convergence as (x0 & v0 & H1 & H2 & H3 & H4).
    assert (Up : forall t, 0 <= t -> Ecr m1 m2 a2 b < E t).
    { intros t Ht. destruct (Rlt_dec (Ecr m1 m2 a2 b) (E t)); auto. exfalso; apply N; exists t; split; auto; lra. }
    exists x0, v0. split; [|split; auto].
    destruct (Rlt_dec (energy m1 m2 a2 x0 v0 v0) (Ecr m1 m2 a2 b)) as [Lt|]; [|lra]. exfalso.
    destruct (H3 ((Ecr m1 m2 a2 b - energy m1 m2 a2 x0 v0 v0) / 2)) as (T & HT & K); [lra|].
    pose proof (K T ltac:(lra)). pose proof (Up T HT). lra.
Qed.
End Dichotomy.
