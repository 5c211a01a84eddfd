(** A sine at the frequency of body 1 alone, without a damper, of the amplitude 4 b/pi: just what friction takes. There
    is a family of motions that slip for ever, one way for half a period and then the other way; so every motion is
    bounded, and none attracts the others. *)
From InertialPair Require Import Dini Pair EnergyLimit Forced Approach Arcs Nonstop NonstopUndamped.

Section Edge.
Variables m1 m2 a2 b om : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om) (Tuned : a2 = m1 * om ^ 2).
(** the amplitude *)
Let F := 4 * b / PI.
(** half a period *)
Let T := PI / om.
(** how fast body 2 is at the turns *)
Let h := PI * b / (2 * m2 * om).
Let k := F / (2 * m1 * om).

(** one of the family: its place, and the velocities of both bodies, from a turn to the next *)
Definition edge_x c t := (F / 2 - m1 * om * h) / a2 * sin (om * t) - b / a2 - (c + k * (om * t)) * cos (om * t) / om.
Definition edge_v1 c t := (c + k * (om * t)) * sin (om * t) - h * cos (om * t).
Definition edge_v2 t := b / m2 * t - h.

(** a bound of sines *)
Lemma half_turn y : 0 <= y <= PI -> y <= sin y + PI / 2 * (1 - cos y).
Proof.
  intros Hy. pose proof PI2_1 as P2. destruct (Rle_dec y (PI / 2)) as [L|L].
  - destruct (MVT_gen (fun z => sin z + 1 - cos z - z) 0 y (fun z => cos z + sin z - 1)) as (z & Hz & E).
    { intros z _. auto_derive; auto. ring. }
    { intros z _. apply continuity_pt_filterlim, (ex_derive_continuous (fun z => sin z + 1 - cos z - z)). auto_derive. auto. }
    rewrite Rmin_left, Rmax_right in Hz by lra. rewrite sin_0, cos_0 in E. pose proof (COS_bound y).
    assert (0 <= sin z) by (apply sin_ge_0; lra). assert (0 <= cos z) by (apply cos_ge_0; lra).
    pose proof (sin2_cos2 z) as I. unfold Rsqr in I. assert (1 <= cos z + sin z) by nra. nra.
  - set (z := PI - y). replace y with (PI - z) by (unfold z; ring). rewrite sin_PI_x, Rtrigo_facts.cos_pi_minus.
    assert (Hz : 0 <= z < PI / 2) by (unfold z; lra). assert (0 <= sin z) by (apply sin_ge_0; lra).
    pose proof (chord (PI / 2 - z) (PI / 2) ltac:(lra) ltac:(lra)) as C. rewrite sin_PI2, sin_shift in C. lra.
Qed.

(** by how much it is faster than body 2 *)
Lemma edge_ahead c t : edge_v1 c t - edge_v2 t =
  (c + k * (om * t)) * sin (om * t) + b / (m2 * om) * (PI / 2 * (1 - cos (om * t)) - om * t).
Proof. unfold edge_v1, edge_v2, h. field. lra. Qed.

(** it does slip forwards: faster between the turns *)
Lemma edge_slips c t : b / (m2 * om) <= c -> 0 < t < T -> edge_v2 t < edge_v1 c t.
Proof.
  intros Hc Ht. pose proof PI_RGT_0 as P. assert (Hg : 0 < b / (m2 * om)) by positive. set (g := b / (m2 * om)) in *.
  assert (Kp : 0 < k) by (unfold k, F; positive). set (y := om * t).
  assert (Hy : 0 < y < PI). { unfold y, T in *. split; [positive|]. replace PI with (om * (PI / om)) by (field; lra).
    apply Rmult_lt_compat_l; lra. }
  assert (S : 0 < sin y) by (apply sin_gt_0; lra). pose proof (half_turn y ltac:(lra)) as G. apply (Rmult_le_compat_l g) in G; [|lra].
  assert (g * sin y <= c * sin y) by (apply Rmult_le_compat_r; lra). assert (0 < k * y * sin y) by positive.
  pose proof (edge_ahead c t) as E. fold g y in E. lra.
Qed.

(** and for no smaller c *)
Lemma edge_least c : (forall t, 0 < t < T -> edge_v2 t < edge_v1 c t) -> b / (m2 * om) <= c.
Proof.
  intros H. pose proof PI_RGT_0 as P. pose proof PI2_1 as P2. assert (Hg : 0 < b / (m2 * om)) by positive.
  set (g := b / (m2 * om)) in *. assert (Kp : 0 < k) by (unfold k, F; positive). destruct (Rle_dec g c) as [L|L]; auto. exfalso.
  set (c' := Rmax c 0). assert (C : c <= c' /\ 0 <= c' < g).
  { unfold c'. split; [apply Rmax_l|]. split; [apply Rmax_r|]. apply Rmax_lub_lt; lra. }
  set (q := k + g * (PI / 4)). assert (Q : 0 < q) by (unfold q; nra).
  set (y := Rmin 1 ((g - c') / (2 * q))). assert (Hy : 0 < y <= 1).
  { unfold y. split; [apply Rmin_pos; [lra|]; apply Rdiv_lt_0_compat; lra|apply Rmin_l]. }
  assert (Yq : q * y < g - c').
  { assert (y <= (g - c') / (2 * q)) as Y by apply Rmin_r. apply (Rmult_le_compat_l q) in Y; [|lra].
    replace (q * ((g - c') / (2 * q))) with ((g - c') / 2) in Y by (field; lra). lra. }
  assert (Ht : 0 < y / om < T). { unfold T. split; [positive|]. apply Rmult_lt_compat_r; [positive|lra]. }
  specialize (H _ Ht). pose proof (edge_ahead c (y / om)) as E. replace (om * (y / om)) with y in E by (field; lra). fold g in E.
  assert (S : 0 < sin y < y) by (split; [apply sin_gt_0; lra|apply sin_lt_x; lra]).
  pose proof (cos_below y ltac:(lra)) as B. assert ((c + k * y) * sin y <= (c' + k * y) * y).
  { apply Rle_trans with ((c' + k * y) * sin y); [apply Rmult_le_compat_r|apply Rmult_le_compat_l]; nra. }
  assert (g * (PI / 2 * (1 - cos y)) <= g * (PI / 2 * (y ^ 2 / 2))) by (apply Rmult_le_compat_l; [lra|apply Rmult_le_compat_l; lra]).
  assert (0 < (c' + k * y) * y + g * (PI / 2 * (y ^ 2 / 2)) - g * y) by lra.
  assert ((c' + k * y) * y + g * (PI / 2 * (y ^ 2 / 2)) - g * y = y * (q * y - (g - c'))) by (unfold q; field). nra.
Qed.

(** half a period as an arc of a motion *)
Lemma edge_arc c : b / (m2 * om) <= c -> forced_arc m1 m2 0 a2 b T (fun t => F * sin (om * t + 0)) (edge_x c) (edge_v1 c) edge_v2 (fun _ => 1).
Proof.
  intros Hc. pose proof PI_RGT_0 as P. apply slip_arc; auto.
  - intros t. unfold edge_x, edge_v1. auto_derive; auto. rewrite Tuned. unfold k, F, h. field. repeat split; lra.
  - intros t. unfold edge_x, edge_v1. auto_derive; auto. rewrite Rplus_0_r, Tuned. unfold k, F, h. field. repeat split; lra.
  - intros t. unfold edge_v2. auto_derive; auto. field. lra.
  - intros t Ht. destruct (Req_dec t 0) as [->|N]; [|pose proof (edge_slips c t Hc ltac:(lra)); lra].
    unfold edge_v1, edge_v2. rewrite !Rmult_0_r, sin_0, cos_0. lra.
Qed.

(** *** a motion that slips for ever, for these c *)

Lemma edge_motion c : b / (m2 * om) <= c -> exists x v1 v2 s, nonstop m1 m2 0 a2 b om F 0 x v1 v2 s /\
  forall t, 0 <= t <= T -> x t = edge_x c t /\ v1 t = edge_v1 c t /\ v2 t = edge_v2 t.
Proof.
  intros Hc. pose proof PI_RGT_0 as P. assert (HT : 0 < T) by (unfold T; positive).
  destruct (arc_begins m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb (wave F om 0) _ _ _ _ _ T ltac:(lra) (cont_wave F om 0 Hom)
    (fun t _ => rderiv_wave F om 0 t Hom) (edge_arc c Hc)) as (x & v1 & v2 & s & H & Q).
  exists x, v1, v2, s. split; auto. assert (OT : om * T = PI) by (unfold T; field; lra).
  assert (E0 : x T = - x 0 /\ v1 T = - v1 0 /\ v2 T = - v2 0).
  { destruct (Q 0 ltac:(lra)) as (-> & -> & ->), (Q T ltac:(lra)) as (-> & -> & ->).
    unfold edge_x, edge_v1, edge_v2. rewrite OT, sin_PI, cos_PI, !Rmult_0_r, sin_0, cos_0. rewrite Tuned.
    unfold k, F, h, T. repeat split; field; repeat split; lra. }
  split; [exact H|]. split.
  - intros t Ht. fold T in Ht. destruct (Q t ltac:(lra)) as (_ & -> & ->). apply edge_slips; auto.
  - fold T. apply (antiperiodic m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Ha2 Hb (wave F om 0) x v1 v2 s T); auto; try lra; try apply E0.
    intros t Ht. apply wave_half; auto.
Qed.

(** [resonance-edge] With $a_1=0$, under $u=\frac{4b}{\pi}\sin\omega_1t$ there is a family of motions that slip
    permanently, one way for half a period and then the other way, in closed form: for $c\geqslant\frac{b}{m_2\omega_1}$,
    and for no smaller $c$. *)
Theorem edge_family c : b / (m2 * om) <= c <-> exists x v1 v2 s, nonstop m1 m2 0 a2 b om F 0 x v1 v2 s /\
  forall t, 0 <= t <= T -> x t = edge_x c t /\ v1 t = edge_v1 c t /\ v2 t = edge_v2 t.
Proof.
  split; [apply edge_motion|]. intros (x & v1 & v2 & s & (_ & Slips & _) & Q). apply edge_least. intros t Ht.
  destruct (Q t ltac:(lra)) as (_ & <- & <-). apply Slips. unfold T in Ht. lra.
Qed.

(** *** so every motion is bounded *)

(** [resonance-edge-bounded] With $a_1=0$, every motion under $u=\frac{4b}{\pi}\sin\omega_1t$ is bounded. *)
Theorem edge_bounded x v1 v2 s : forced m1 m2 0 a2 b (wave F om 0) x v1 v2 s ->
  exists B, forall t, 0 <= t -> Rabs (x t) <= B /\ Rabs (v1 t) <= B /\ Rabs (v2 t) <= B.
Proof.
  intros H. pose proof PI_RGT_0 as P. assert (HT : 0 < T) by (unfold T; positive). assert (OT : om * T = PI) by (unfold T; field; lra).
  assert (Hh : b / (m2 * om) <= h).
  { unfold h. replace (PI * b / (2 * m2 * om)) with (PI / 2 * (b / (m2 * om))) by (field; lra). pose proof PI2_1.
    assert (0 < b / (m2 * om)) by positive. nra. }
  destruct (edge_motion h Hh) as (y & w1 & w2 & z & (Hy & _ & Anti) & Q). fold T in Anti.
  assert (Hp : 0 < h) by (unfold h; apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; nra).
  assert (Kp : 0 < k) by (unfold k, F; apply Rdiv_lt_0_compat; [apply Rdiv_lt_0_compat; nra|apply Rmult_lt_0_compat; nra]).
  set (q := Rabs ((F / 2 - m1 * om * h) / a2)). pose proof (Rabs_pos ((F / 2 - m1 * om * h) / a2)) as Q0. fold q in Q0.
  assert (Ba : 0 < b / a2) by positive. assert (Oi : 0 < / om) by positive.
  set (C := q + b / a2 + (h + k * PI) * (1 + / om) + h). assert (KP : 0 < k * PI) by positive.
  assert (Cp : 0 <= C). { unfold C. assert (0 <= (h + k * PI) * (1 + / om)) by (apply Rmult_le_pos; lra). lra. }
  assert (One : forall t, 0 <= t <= T -> Rabs (y t) <= C /\ Rabs (w1 t) <= C /\ Rabs (w2 t) <= C).
  { intros t Ht. destruct (Q t Ht) as (-> & -> & ->). unfold edge_x, edge_v1, edge_v2.
    assert (Hy2 : 0 <= om * t <= PI) by (rewrite <- OT; split; [positive|apply Rmult_le_compat_l; lra]).
    assert (S : Rabs (sin (om * t)) <= 1) by (apply Rabs_le, SIN_bound).
    assert (Co : Rabs (cos (om * t)) <= 1) by (apply Rabs_le, COS_bound).
    assert (G0 : 0 <= h + k * (om * t) <= h + k * PI) by (split; [apply Rplus_le_le_0_compat; [lra|positive]|nra]).
    assert (A1 : Rabs ((F / 2 - m1 * om * h) / a2 * sin (om * t)) <= q * 1)
      by (rewrite Rabs_mult; apply Rmult_le_compat_l; auto).
    assert (A2 : forall g, Rabs g <= 1 -> Rabs ((h + k * (om * t)) * g) <= h + k * PI).
    { intros g Hg. rewrite Rabs_mult, (Rabs_pos_eq (h + k * (om * t))) by lra. pose proof (Rabs_pos g). nra. }
    pose proof (A2 _ S) as A3. pose proof (A2 _ Co) as A4.
    assert (A5 : Rabs ((h + k * (om * t)) * cos (om * t) / om) <= (h + k * PI) * / om).
    { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ om)) by lra. apply Rmult_le_compat_r; lra. }
    assert (A6 : Rabs (h * cos (om * t)) <= h * 1) by (rewrite Rabs_mult, (Rabs_pos_eq h) by lra; apply Rmult_le_compat_l; lra).
    assert (A7 : 0 <= b / m2 * t <= 2 * h).
    { split; [positive|]. replace (2 * h) with (b / m2 * T) by (unfold h, T; field; lra). apply Rmult_le_compat_l; [positive|lra]. }
    assert (A8 : 0 <= (h + k * PI) * / om) by (apply Rmult_le_pos; lra).
    apply Rabs_inv in A1. apply Rabs_inv in A3. apply Rabs_inv in A5. apply Rabs_inv in A6.
    unfold C. repeat split; apply Rabs_le; lra. }
  assert (All : forall n t, 0 <= t <= T -> Rabs (y (INR n * T + t)) <= C /\ Rabs (w1 (INR n * T + t)) <= C /\ Rabs (w2 (INR n * T + t)) <= C).
  { induction n as [|n IH]; intros t Ht; [simpl; rewrite Rmult_0_l, Rplus_0_l; auto|].
    rewrite S_INR. replace ((INR n + 1) * T + t) with (T + (INR n * T + t)) by ring.
    destruct (Anti (INR n * T + t)) as (-> & -> & ->).
    { pose proof (pos_INR n). assert (0 <= INR n * T) by (apply Rmult_le_pos; lra). lra. }
    rewrite !Rabs_Ropp. auto. }
  assert (Bd : forall t, 0 <= t -> Rabs (y t) <= C /\ Rabs (w1 t) <= C /\ Rabs (w2 t) <= C).
  { intros t Ht. destruct (nfloor_ex (t / T)) as (n & N1 & N2); [positive|].
    apply Rmult_le_compat_r with (r := T) in N1; [|lra]. apply Rmult_lt_compat_r with (r := T) in N2; auto.
    replace (t / T * T) with t in * by (field; lra). replace t with (INR n * T + (t - INR n * T)) by ring. apply All. lra. }
  set (D := fun t => energy m1 m2 a2 (x t - y t) (v1 t - w1 t) (v2 t - w2 t)).
  assert (Mono : forall t, 0 <= t -> D t <= D 0)
    by (intros t Ht; apply (forced_contraction m1 m2 0 a2 b Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ _ 0 t H Hy); lra).
  exists (C + reach m1 m2 a2 (D 0)). intros t Ht.
  apply (beside m1 m2 a2 _ _ _ (y t) (w1 t) (w2 t) C (D 0)); auto. exact (Mono t Ht).
Qed.
End Edge.
