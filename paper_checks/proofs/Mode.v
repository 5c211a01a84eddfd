(** Which mode follows at a contact v1 = v2, right after t0: with the load m2 (u - a2 x - a1 v1)/M, the friction that
    sticking needs, the pair sticks if the load is within b, and slips with the load's sign if it is beyond b. The
    force need only be known from t0 on, for a while, and be continuous from the right at t0: a jump at t0 decides
    with its later value. *)
From InertialPair Require Import Dini Pair Stick Chase Forced Response Bounded Arcs.

Section Mode.
Variables m1 m2 a1 a2 b : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Let M := m1 + m2.
Let kap := M / (m1 * m2).
Variables U u x v1 v2 s : R -> R.
Variables t0 d0 : R.
Hypotheses (H : forced m1 m2 a1 a2 b U x v1 v2 s) (Ht0 : 0 <= t0) (Hd0 : 0 < d0)
  (DU : forall t, t0 <= t < t0 + d0 -> rderiv U t (u t))
  (Cu : forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (u (t0 + h) - u t0) <= e)
  (Meet : v1 t0 = v2 t0).
Let w t := v1 t - v2 t.
(** the load *)
Definition load t := m2 * (u t - a2 * x t - a1 * v1 t) / (m1 + m2).

(** it is continuous from the right *)
Lemma load_near e : 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (load (t0 + h) - load t0) <= e.
Proof.
  intros He. assert (Mp : 0 < M) by (unfold M; lra). set (k := 1 + a2 + a1). assert (Kp : 0 < k) by (unfold k; lra).
  set (e' := M / m2 * e / k). assert (He' : 0 < e').
  { apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. apply Rdiv_lt_0_compat; auto. }
  destruct (Cu e' He') as (d1 & D1 & K1). destruct (f_cx _ _ _ _ _ _ _ _ _ _ H t0 Ht0 e' He') as (d2 & D2 & K2).
  destruct (f_cv _ _ _ _ _ _ _ _ _ _ H t0 Ht0 e' He') as (d3 & D3 & K3).
  exists (Rmin d1 (Rmin d2 d3)). pose proof (Rmin_l d1 (Rmin d2 d3)). pose proof (Rmin_r d1 (Rmin d2 d3)).
  pose proof (Rmin_l d2 d3). pose proof (Rmin_r d2 d3). split; [repeat apply Rmin_glb_lt; auto|]. intros h Hh.
  specialize (K1 h ltac:(lra)). assert (Dh : Rabs (t0 + h - t0) < Rmin d2 d3) by (rewrite Rabs_pos_eq; lra).
  specialize (K2 (t0 + h) ltac:(lra) ltac:(lra)). specialize (K3 (t0 + h) ltac:(lra) ltac:(lra)).
  set (du := u (t0 + h) - u t0) in *. set (dx := x (t0 + h) - x t0) in *. set (dv := v1 (t0 + h) - v1 t0) in *.
  replace (load (t0 + h) - load t0) with (m2 / M * (du - a2 * dx - a1 * dv)) by (unfold load, du, dx, dv, M; field;
    unfold M in Mp; lra).
  replace e with (m2 / M * (k * e')) by (unfold e'; field; unfold k in *; lra).
  apply abs_scal; [apply Rlt_le, Rdiv_lt_0_compat; auto|]. apply Rabs_inv in K1. apply Rabs_def2 in K2.
    apply Rabs_def2 in K3.
  unfold k. apply Rabs_le. split; nra.
Qed.

(** how the relative velocity changes: by the load, and by friction *)
Lemma rate_w t : t0 <= t < t0 + d0 ->
  little (fun h => w (t + h) - w t - kap * load t * h + b * kap * (s (t + h) - s t)).
Proof.
  intros Ht. pose proof (moves_slip m1 m2 a1 a2 b Hm1 Hm2 _ U x v1 v2 s H t (u t) ltac:(lra) (DU t Ht)) as R.
  eapply little_ext; [|exact R]. intros h. unfold w, kap, load, M. field. repeat split; lra.
Qed.

(** kappa is positive *)
Lemma kappa_pos : 0 < kap.
Proof. unfold kap, M. apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; auto]. Qed.

(** beyond b by g the relative velocity is driven at the rate kappa g at least, whatever friction does *)
Lemma driven t k g : t0 <= t < t0 + d0 -> k = 1 \/ k = -1 -> b + g <= k * load t ->
  dini_le (fun r => -1 * (k * w r)) t (- (kap * g)).
Proof.
  intros Ht Hk G e He. pose proof kappa_pos as Kp. destruct (rate_w t Ht e He) as (d & Hd & K). exists d. split; auto.
    intros h Hh.
  specialize (K h Hh). apply Rabs_inv in K. pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H t (t + h) ltac:(lra)) as L.
    apply Rabs_inv in L.
  set (ds := s (t + h) - s t) in *. set (dw := w (t + h) - w t) in *.
  assert (Ds : k * ds <= h) by (destruct Hk; subst k; lra).
  assert (F : b * kap * (k * ds) <= b * kap * h) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra).
  assert (G' : kap * (b + g) * h <= kap * (k * load t) * h) by (apply Rmult_le_compat_r; [lra|];
    apply Rmult_le_compat_l; lra).
  replace (-1 * (k * w (t + h)) - -1 * (k * w t)) with (- (k * dw)) by (unfold dw; ring).
  assert (Q : - (e * h) <= k * (dw - kap * load t * h + b * kap * ds)) by (destruct Hk; subst k; lra). lra.
Qed.

(** within b, friction brings the relative velocity back *)
Lemma held t k : t0 <= t < t0 + d0 -> k = 1 \/ k = -1 -> k * load t <= b -> 0 < k * w t ->
  dini_le (fun r => k * w r) t 0.
Proof.
  intros Ht Hk G W. pose proof (q_slip m1 m2 a1 a2 b _ U x v1 v2 s H t ltac:(lra) k Hk W) as S.
  eapply rderiv_dini; [|apply rderiv_scal, (moves_rate m1 m2 a1 a2 b Hm1 Hm2 _ U x v1 v2 s H t (u t) k ltac:(lra)
    (DU t Ht) S)].
  fold (load t) M. fold kap. pose proof kappa_pos. destruct Hk; subst k; nra.
Qed.

(** the relative velocity is continuous *)
Lemma cont_w : cont w.
Proof. apply cont_minus; [apply (f_cv _ _ _ _ _ _ _ _ _ _ H)|exact (moves_cv2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H)]. Qed.

(** a load beyond b: slip, with its sign *)
Theorem slips_at k : k = 1 \/ k = -1 -> b < k * load t0 -> exists d, 0 < d /\ forall t, t0 < t < t0 + d ->
  0 < k * (v1 t - v2 t).
Proof.
  intros Hk G. set (g := (k * load t0 - b) / 2). assert (Gp : 0 < g) by (unfold g; lra). pose proof kappa_pos as Kp.
  destruct (load_near g Gp) as (d & Hd & K). smaller d d0. intros t Ht.
  assert (Q : -1 * (k * w t) - -1 * (k * w t0) <= - (kap * g) * (t - t0)).
  { apply (dini_slope (fun r => -1 * (k * w r))); [apply cont_scal, cont_scal, cont_w|lra|]. intros r Hr.
    apply driven; [lra|auto|].
    specialize (K (r - t0) ltac:(lra)). replace (t0 + (r - t0)) with r in K by ring. apply Rabs_inv in K.
    unfold g in *. destruct Hk; subst k; lra. }
  assert (W0 : w t0 = 0) by (unfold w; lra). rewrite W0 in Q.
    assert (0 < kap * g * (t - t0)) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  unfold w in Q. lra.
Qed.

(** a load below b cannot start a slip forwards *)
Lemma not_ahead k : k = 1 \/ k = -1 -> k * load t0 < b -> exists d, 0 < d <= d0 /\ forall t, t0 <= t < t0 + d ->
  k * (v1 t - v2 t) <= 0.
Proof.
  intros Hk G. destruct (load_near (b - k * load t0)) as (d & Hd & K); [lra|].
  set (c := Rmin d d0). assert (c <= d) by apply Rmin_l. assert (c <= d0) by apply Rmin_r.
  assert (Cp : 0 < c) by (apply Rmin_glb_lt; auto). exists c. split; [lra|].
  intros t Ht. change (k * w t <= 0). apply le_epsilon. intros e He. rewrite Rplus_0_l.
  apply (barrier_until (fun r => k * w r) e t0 t); [apply cont_scal, cont_w|lra|unfold w; rewrite Meet; lra|].
  intros r Hr Wr. specialize (K (r - t0) ltac:(lra)). replace (t0 + (r - t0)) with r in K by ring. apply Rabs_inv in K.
  apply held; [lra|auto|destruct Hk; subst k; lra|lra].
Qed.

(** a load within b: stick *)
Theorem sticks_at : Rabs (load t0) < b -> exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t.
Proof.
  intros G. pose proof (Rle_abs (load t0)). pose proof (Rle_abs (- load t0)) as A. rewrite Rabs_Ropp in A.
  destruct (not_ahead 1 (or_introl eq_refl) ltac:(lra)) as (d & Hd & K).
  destruct (not_ahead (-1) (or_intror eq_refl) ltac:(lra)) as (d' & Hd' & K').
  smaller d d'. intros t Ht.
  specialize (K t ltac:(lra)). specialize (K' t ltac:(lra)). lra.
Qed.

(** *** A load at the edge: k load = b. Beside the motion with the constant acceleration k beta, in which both modes
    agree, *)
(** what the force asks beyond b: its first derivative that is not 0 decides *)
Definition beyond k t := k * u t - a2 * (k * x t0 + k * v1 t0 * (t - t0) + b / m2 * (t - t0) ^ 2 / 2)
  - a1 * (k * v1 t0 + b / m2 * (t - t0)) - (m1 + m2) * (b / m2).

(** beside that motion: where and how fast body 1 is ahead of it, and body 2 *)
Definition place k t := k * x t - (k * x t0 + k * v1 t0 * (t - t0) + b / m2 * (t - t0) ^ 2 / 2).
Definition lead k t := k * v1 t - (k * v1 t0 + b / m2 * (t - t0)).
Definition ahead2 k t := k * (v2 t - v2 t0) - b / m2 * (t - t0).
(** their momentum *)
Definition gain k t := m1 * (k * w t) + M * ahead2 k t.
(** what the load exceeds the edge by, on the scale of the force *)
Definition excess k t := beyond k t - a1 * lead k t - a2 * place k t.

Lemma excess_of_load k t : k * load t - b = m2 / M * excess k t.
Proof. unfold excess, lead, place, beyond, load, M. field. lra. Qed.
Lemma lead_split k t : lead k t = k * w t + ahead2 k t.
Proof. unfold lead, w, ahead2. rewrite Meet. ring. Qed.
Lemma place_rate k t : 0 <= t -> rderiv (place k) t (lead k t).
Proof.
  intros Ht. apply rderiv_minus; [apply rderiv_scal, (f_x _ _ _ _ _ _ _ _ _ _ H); lra|].
  apply rderiv_of_derive. auto_derive; auto. field; lra.
Qed.
Lemma cont_place k : cont (place k).
Proof.
  apply cont_minus; [apply cont_scal, (f_cx _ _ _ _ _ _ _ _ _ _ H)|].
  apply cont_of_derive with (fun t => k * v1 t0 + b / m2 * (t - t0)). intros t. auto_derive; auto. field; lra.
Qed.
(** the momentum has the rate of the excess in every mode, and is 0 at the contact *)
Lemma gain_rate k t : 0 <= t -> rderiv U t (u t) -> rderiv (gain k) t (excess k t).
Proof.
  intros Ht HU. apply rderiv_ext with (fun r => k * ((m1 * v1 r + b * s r - U r) + U r + (m2 * v2 0 - b * s 0))
    - (M * (k * v2 t0) + M * (b / m2) * (r - t0))).
  - intros r Hr. rewrite <- (f_v2 _ _ _ _ _ _ _ _ _ _ H r) by lra. unfold gain, w, ahead2, M. ring.
  - eapply rderiv_eq; [|apply rderiv_minus; [apply rderiv_scal, rderiv_plus; [apply rderiv_plus;
      [apply (f_v1 _ _ _ _ _ _ _ _ _ _ H); auto|exact HU]|apply rderiv_const]|
      apply rderiv_of_derive; auto_derive; auto; reflexivity]].
    unfold excess, beyond, place, lead, M. field. lra.
Qed.
Lemma cont_gain k : cont (gain k).
Proof.
  assert (C2 : cont v2) by exact (moves_cv2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H).
  apply cont_plus; apply cont_scal; [apply cont_scal, cont_w|].
  apply cont_minus; [apply cont_scal, cont_minus; auto using cont_const|].
  apply cont_of_derive with (fun _ => b / m2). intros; auto_derive; auto; ring.
Qed.
Lemma gain_0 k : gain k t0 = 0.
Proof. unfold gain, w, ahead2. rewrite Meet. ring. Qed.
(** body 2 was ahead and falls behind, as friction gives it at most the acceleration b/m2 *)
Lemma ahead2_sign k t : k = 1 \/ k = -1 -> 0 <= t -> (t <= t0 -> 0 <= ahead2 k t) /\ (t0 <= t -> ahead2 k t <= 0).
Proof.
  intros Hk Ht. assert (P : 0 < b / m2) by (apply Rdiv_lt_0_compat; auto).
  replace (ahead2 k t) with (b / m2 * (k * (s t - s t0) - (t - t0))).
  2: { unfold ahead2. rewrite (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H t0 t Ht0 Ht). ring. }
  pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H) as L. split; intros Hl.
  - specialize (L t t0 ltac:(lra)). apply Rabs_inv in L. apply Rmult_le_pos; [lra|]. destruct Hk; subst k; lra.
  - specialize (L t0 t ltac:(lra)). apply Rabs_inv in L.
    assert (k * (s t - s t0) - (t - t0) <= 0) by (destruct Hk; subst k; lra). nra.
Qed.

(** a product of a function with an upper right derivative and one that is not negative *)
Lemma dini_mult f g t l g1 : dini_le f t l -> big (fun h => f (t + h) - f t) -> rderiv g t g1 -> 0 <= g t ->
  dini_le (fun r => f r * g r) t (l * g t + f t * g1).
Proof.
  intros F B G Gp e He.
  destruct (little_plus _ _ (big_mult _ _ B (rderiv_big _ _ _ G)) (little_scal (f t) _ G) (e / 2)) as (d1 & D1 & K1);
    [lra|].
  destruct (F (e / 2 / (g t + 1))) as (d2 & D2 & K2); [apply Rdiv_lt_0_compat; lra|].
  smaller d1 d2. intros h Hh.
  specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). apply Rabs_inv in K1. cbv beta in K1.
  assert (Q : (f (t + h) - f t) * g t <= (l + e / 2 / (g t + 1)) * h * g t) by (apply Rmult_le_compat_r; lra).
  assert (e / 2 / (g t + 1) * g t <= e / 2).
  { replace (e / 2) with (e / 2 / (g t + 1) * (g t + 1)) at 2 by (field; lra).
    apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat|]; lra. }
  assert (e / 2 / (g t + 1) * g t * h <= e / 2 * h) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(** where the force asks more than b right after, the pair slips: body 1 gains on body 2 what the force asks beyond b,
    less what the spring and the damper take of that gain, which is less at first *)
Theorem slips_at_edge k : k = 1 \/ k = -1 -> k * load t0 = b -> (forall t, t0 < t < t0 + d0 -> 0 < beyond k t) ->
  exists d, 0 < d /\ forall t, t0 < t < t0 + d -> 0 < k * (v1 t - v2 t).
Proof.
  intros Hk Tie Pp. assert (Hk' : - k = 1 \/ - k = -1) by (destruct Hk; [right|left]; lra).
  destruct (not_ahead (- k) Hk' ltac:(lra)) as (d1 & Hd1 & NA). pose proof kappa_pos as Kp.
    assert (Mp : 0 < M) by (unfold M; lra).
  set (c := (a1 + a2) / m1). assert (C0 : 0 < c) by (apply Rdiv_lt_0_compat; lra).
  set (d := Rmin d1 (Rmin 1 (/ (2 * c)))). exists d.
  assert (Hd : 0 < d /\ d <= d1 /\ d <= 1 /\ c * d <= / 2).
  { assert (0 < / (2 * c)) by (apply Rinv_0_lt_compat; lra). unfold d. pose proof (Rmin_l d1 (Rmin 1 (/ (2 * c)))).
    pose proof (Rmin_r d1 (Rmin 1 (/ (2 * c)))). pose proof (Rmin_l 1 (/ (2 * c))). pose proof (Rmin_r 1 (/ (2 * c))).
    split; [repeat apply Rmin_glb_lt; lra|]. repeat split; try lra.
    replace (/ 2) with (c * / (2 * c)) by (field; lra). apply Rmult_le_compat_l; lra. }
  split; [lra|]. intros T HT.
  set (W := fun t => k * w t). set (y := place k). set (y' := lead k).
  set (A := fun t => 1 - c * (T - t)). set (B := fun t => - (a2 / m1) * ((T - t) - c * (T - t) ^ 2 / 2)).
  assert (DA : forall t, rderiv A t c) by (intros t; apply rderiv_of_derive; unfold A; auto_derive; auto; ring).
  assert (DB : forall t, rderiv B t (a2 / m1 * A t)).
  { intros t. apply rderiv_of_derive. unfold A, B. auto_derive; auto. field; lra. }
  assert (Wn : forall t, t0 <= t < T -> 0 <= W t) by (intros t Ht; specialize (NA t ltac:(lra)); unfold W, w; lra).
  assert (Yw : forall t, t0 <= t -> y' t <= W t).
  { intros t Ht. unfold y', W. rewrite lead_split. pose proof (proj2 (ahead2_sign k t Hk ltac:(lra)) Ht). lra. }
  assert (Gain : forall t, t0 <= t < T -> dini_le (fun r => -1 * W r) t (- ((beyond k t - a2 * y t - a1 * y' t) / m1))).
  { intros t Ht. replace (- ((beyond k t - a2 * y t - a1 * y' t) / m1)) with (- (kap * (k * load t - b))).
    - apply driven; [lra|auto|]. lra.
    - rewrite excess_of_load. unfold excess, y, y', kap, M. field. repeat split; lra. }
  assert (BW : forall t, t0 <= t < T -> big (fun h => -1 * W (t + h) - -1 * W t)).
  { intros t Ht. apply big_ext with (fun h => - k * ((v1 (t + h) - v2 (t + h)) - (v1 t - v2 t)));
    [intros h; unfold W, w; ring|]. apply big_scal, (moves_gap_big m1 m2 a1 a2 b Hm1 Hm2 1 U x v1 v2 s) with (u t);
    [apply (forced_moves m1 m2 a1 a2 b), H|lra|apply DU; lra]. }
  set (Phi := fun t => -1 * W t * A t + y t * - B t).
  assert (DPhi : forall t, t0 <= t < T -> dini_le Phi t (- (A t * beyond k t / m1))).
  { intros t Ht. assert (At : 0 <= A t <= 1) by (unfold A; split; nra).
    pose proof (dini_mult _ A t _ c (Gain t Ht) (BW t Ht) (DA t) ltac:(lra)) as Q1.
    assert (Q2 : rderiv (fun t => y t * - B t) t (y' t * - B t + y t * - (a2 / m1 * A t))).
    { apply (rderiv_mult y (fun r => - B r)); [apply place_rate; lra|].
      apply rderiv_ext with (fun r => -1 * B r); [intros;
      ring|].
      eapply rderiv_eq; [|apply rderiv_scal, DB]. ring. }
    intros e He. destruct (Q1 (e / 2)) as (e1 & E1 & K1); [lra|]. destruct (Q2 (e / 2)) as (e2 & E2 & K2); [lra|].
    smaller e1 e2. intros h Hh.
    specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). apply Rabs_inv in K2. cbv beta in K1. unfold Phi.
    assert (Rate : - ((beyond k t - a2 * y t - a1 * y' t) / m1) * A t + -1 * W t * c + (y' t * - B t + y t * - (a2 /
      m1 * A t)) <= - (A t * beyond k t / m1)); [|nra].
    assert (Bn : 0 <= - B t <= a2 / m1 * (T - t)).
    { assert (Cz : 0 <= c * (T - t) <= / 2).
      { split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (c * d); [apply Rmult_le_compat_l; lra|lra]. }
      assert (Z : 0 <= (T - t) - c * (T - t) * (T - t) / 2 <= T - t) by (split; nra).
      assert (0 < a2 / m1) by (apply Rdiv_lt_0_compat; auto).
      replace (- B t) with (a2 / m1 * ((T - t) - c * (T - t) * (T - t) / 2)) by (unfold B; field; lra).
      split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra]. }
    pose proof (Yw t ltac:(lra)) as Y1. pose proof (Wn t Ht) as W0.
    assert (P1 : y' t * (a1 / m1 * A t - B t) <= W t * (a1 / m1 * A t - B t)).
    { apply Rmult_le_compat_r; auto. assert (0 <= a1 / m1) by (apply Rmult_le_pos; [auto|apply Rlt_le,
      Rinv_0_lt_compat; auto]). nra. }
    assert (P2 : W t * (a1 / m1 * A t - B t) <= W t * c).
    { apply Rmult_le_compat_l; auto. unfold c. replace ((a1 + a2) / m1) with (a1 / m1 * 1 + a2 / m1 * 1) by (field;
      lra).
      assert (0 <= a1 / m1) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat; auto]).
      assert (0 < a2 / m1) by (apply Rdiv_lt_0_compat; auto). nra. }
    replace (- ((beyond k t - a2 * y t - a1 * y' t) / m1) * A t + -1 * W t * c + (y' t * - B t + y t * - (a2 / m1 * A
      t))) with (- (A t * beyond k t / m1) + (y' t * (a1 / m1 * A t - B t) - W t * c)) by (field; lra). lra. }
  assert (CPhi : cont Phi).
  { assert (CA : cont A) by (apply cont_of_derive with (fun _ => c); intros; unfold A; auto_derive; auto; ring).
    assert (CB : cont B) by (apply cont_of_derive with (fun t => a2 / m1 * A t); intros; unfold A, B; auto_derive;
      auto; field; lra).
    assert (Cy : cont y) by exact (cont_place k).
    apply cont_plus; apply cont_mult; auto; [apply cont_scal, cont_scal, cont_w|].
    apply cont_ext with (fun r => -1 * B r); [intros; ring|apply cont_scal; auto]. }
  assert (P0 : Phi t0 = 0) by (unfold Phi, W, y, place, w; rewrite Meet; field; lra).
  assert (PT : Phi T = - W T) by (unfold Phi, A, B; replace (T - T) with 0 by ring; field; lra).
  assert (Ap : forall t, t0 <= t < T -> 0 < A t) by (intros t Ht; unfold A; nra).
  assert (Q0 : beyond k t0 = 0).
  { replace (beyond k t0) with (M / m2 * (k * load t0 - b)) by (unfold beyond, load, M; field; unfold M in Mp; lra).
    rewrite Tie. ring. }
  assert (Down : forall p q, t0 <= p <= q -> q <= T -> Phi q <= Phi p).
  { intros p q Hp Hq. apply dini_mono; auto; [lra|]. intros t Ht e He.
    destruct (DPhi t ltac:(lra) e He) as (h1 & H1 & K). exists h1.
    split; auto. intros h Hh. specialize (K h Hh). assert (0 <= A t * beyond k t / m1); [|nra].
    specialize (Ap t ltac:(lra)). apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; auto]. apply Rmult_le_pos;
      [lra|].
    destruct (Req_dec t t0) as [->|N]; [lra|]. apply Rlt_le, Pp; lra. }
  change (0 < W T). apply Rnot_le_lt. intros N. set (r := (t0 + T) / 2). assert (Hr : t0 < r < T) by (unfold r; lra).
  assert (Flat : forall t, r <= t <= T -> Phi t = 0).
  { intros t Ht. pose proof (Down t0 t ltac:(lra) ltac:(lra)). pose proof (Down t T ltac:(lra) ltac:(lra)). lra. }
  set (l := A r * beyond k r / m1). assert (Lp : 0 < l).
  { apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; [apply Ap; lra|apply Pp; lra]. }
  destruct (DPhi r ltac:(lra) (l / 2)) as (h1 & H1 & K); [lra|]. set (h := Rmin (h1 / 2) (T - r)).
  assert (h <= h1 / 2) by apply Rmin_l. assert (h <= T - r) by apply Rmin_r. assert (0 < h) by (apply Rmin_glb_lt; lra).
  specialize (K h ltac:(lra)). rewrite !Flat in K by lra. fold l in K. nra.
Qed.

(** while it slips forwards the relative velocity rises as the load exceeds b *)
Lemma rise_le k r c : k = 1 \/ k = -1 -> 0 <= r -> 0 < c <= d0 ->
  (forall t, t0 <= t < t0 + c -> 0 < k * w t -> kap * (k * load t - b) <= r) ->
  forall t, t0 <= t < t0 + c -> k * w t <= r * (t - t0).
Proof.
  intros Hk Hr Hc G t Ht. apply le_epsilon. intros e He.
  assert (Q : k * w t - r * (t - t0) <= e); [|lra].
  apply (barrier_until (fun z => k * w z - r * (z - t0)) e t0 t); [|lra|unfold w; rewrite Meet; lra|].
  - apply cont_minus; [apply cont_scal, cont_w|]. apply cont_of_derive with (fun _ => r).
    intros; auto_derive; auto; ring.
  - intros z Hz Wz. assert (Up : 0 <= r * (z - t0)) by (apply Rmult_le_pos; lra). assert (Wp : 0 < k * w z) by lra.
    specialize (G z ltac:(lra) Wp).
    pose proof (q_slip m1 m2 a1 a2 b _ U x v1 v2 s H z ltac:(lra) k Hk Wp) as S.
    apply rderiv_dini with (k * (kap * (load z - b * k)) - r); [destruct Hk; subst k; lra|].
    apply rderiv_minus; [apply rderiv_scal, (moves_rate m1 m2 a1 a2 b Hm1 Hm2 _ U x v1 v2 s H z (u z) k
      ltac:(lra) (DU z ltac:(lra)) S)|].
    apply rderiv_of_derive. auto_derive; auto; ring.
Qed.

(** where the force asks ever less than b right after, the pair sticks: what the spring and the damper give back is
  less than that *)
Theorem sticks_at_edge k : k = 1 \/ k = -1 -> k * load t0 = b ->
  (forall r t, t0 <= r <= t -> t < t0 + d0 -> beyond k t <= beyond k r) ->
  exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t.
Proof.
  intros Hk Tie Mono. assert (Hk' : - k = 1 \/ - k = -1) by (destruct Hk; [right|left]; lra).
  destruct (not_ahead (- k) Hk' ltac:(lra)) as (d1 & Hd1 & NA). pose proof kappa_pos as Kp.
    assert (Mp : 0 < M) by (unfold M; lra).
  destruct (load_near 1 ltac:(lra)) as (d2 & Hd2 & Near).
  set (c := (a1 + a2) / m1). assert (C0 : 0 < c) by (apply Rdiv_lt_0_compat; lra).
  set (K := (a1 + a2) / M). assert (K0 : 0 < K) by (apply Rdiv_lt_0_compat; lra).
  assert (KC : 0 < K * (c + 2)) by (apply Rmult_lt_0_compat; lra).
  set (d := Rmin (Rmin d1 d2) (Rmin 1 (/ (4 * (K * (c + 2)))))).
  assert (Hd : 0 < d /\ d <= d1 /\ d <= d2 /\ d <= 1 /\ K * (c + 2) * d <= / 4).
  { assert (0 < / (4 * (K * (c + 2)))) by (apply Rinv_0_lt_compat; lra). unfold d.
    pose proof (Rmin_l (Rmin d1 d2) (Rmin 1 (/ (4 * (K * (c + 2)))))).
      pose proof (Rmin_r (Rmin d1 d2) (Rmin 1 (/ (4 * (K * (c + 2)))))).
    pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
    pose proof (Rmin_l 1 (/ (4 * (K * (c + 2))))). pose proof (Rmin_r 1 (/ (4 * (K * (c + 2))))).
    split; [repeat apply Rmin_glb_lt; lra|]. repeat split; try lra.
    replace (/ 4) with (K * (c + 2) * / (4 * (K * (c + 2)))) by (field; split; lra). apply Rmult_le_compat_l; lra. }
  set (W := fun t => k * w t). set (q := ahead2 k). set (y := place k). set (y' := lead k). set (E := gain k).
  set (f := fun t => - (a1 * y' t + a2 * y t)).
  assert (Split : forall t, y' t = W t + q t) by exact (lead_split k).
  assert (Dy : forall t, t0 <= t -> rderiv y t (y' t)) by (intros t Ht; apply place_rate; lra).
  assert (Cy : cont y) by exact (cont_place k).
  assert (Y0 : y t0 = 0 /\ y' t0 = 0) by (unfold y, y', place, lead; split; field; lra).
  assert (Load : forall t, kap * (k * load t - b) = (beyond k t + f t) / m1).
  { intros t. rewrite excess_of_load. unfold excess, f, y, y', kap, M. field. repeat split; lra. }
  assert (Qn : forall t, t0 <= t -> q t <= 0) by (intros t Ht; apply ahead2_sign; auto; lra).
  assert (Wn : forall t, t0 <= t < t0 + d -> 0 <= W t) by (intros t Ht; specialize (NA t ltac:(lra)); unfold W, w; lra).
  assert (DE : forall t, t0 <= t < t0 + d0 -> rderiv E t (beyond k t + f t)).
  { intros t Ht. apply rderiv_eq with (excess k t); [unfold excess, f, y, y'; ring|].
    apply gain_rate; [lra|apply DU; lra]. }
  assert (CE : cont E) by exact (cont_gain k). assert (E0 : E t0 = 0) by exact (gain_0 k).
  assert (B0 : beyond k t0 = 0).
  { replace (beyond k t0) with (M / m2 * (k * load t0 - b)) by (unfold beyond, load, M; field; lra). rewrite Tie.
    ring. }
  (* what a bound S of f up to T gives back *)
  assert (Better : forall T S, t0 < T < t0 + d -> 0 <= S -> (forall t, t0 <= t < T -> f t <= S) ->
    forall t, t0 <= t < T -> f t <= / 4 * (- beyond k T + S)).
  { intros T S HT HS Bd. set (pi := - beyond k T).
    assert (Pi : forall t, t0 <= t <= T -> - pi <= beyond k t <= 0).
    { intros t Ht. pose proof (Mono t T ltac:(lra) ltac:(lra)). pose proof (Mono t0 t ltac:(lra) ltac:(lra)).
      unfold pi. lra. }
    assert (Pp : 0 <= pi) by (destruct (Pi t0 ltac:(lra)); lra).
    assert (W1 : forall t, t0 <= t < T -> W t <= S / m1 * (t - t0)).
    { intros t Ht. apply (rise_le k (S / m1) (T - t0) Hk); [apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat;
      auto]|lra| |lra].
      intros r Hr _. rewrite Load. specialize (Bd r ltac:(lra)). destruct (Pi r ltac:(lra)).
      apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; auto|lra]. }
    set (g := S / m1). assert (Gp : 0 <= g) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat; auto]).
    assert (Gs : forall t, t0 <= t < T -> g * (t - t0) <= g) by (intros t Ht; rewrite <- (Rmult_1_r g) at 2;
      apply Rmult_le_compat_l; lra).
    assert (Yu : forall t, t0 <= t < T -> y t <= g * (t - t0)).
    { intros t Ht. assert (y t - y t0 <= g * (t - t0)); [|lra]. apply (dini_slope y); auto; [lra|]. intros r Hr.
      eapply rderiv_dini; [|apply Dy; lra]. rewrite Split. pose proof (W1 r ltac:(lra)). pose proof (Qn r ltac:(lra)).
      pose proof (Gs r ltac:(lra)). fold g in H0. lra. }
    assert (Cg : (a1 + a2) * g = c * S) by (unfold c, g; field; lra).
    assert (Fl : forall t, t0 <= t < T -> - (c * S) <= f t).
    { intros t Ht. pose proof (W1 t Ht) as W2. fold g in W2. pose proof (Qn t ltac:(lra)). pose proof (Gs t Ht).
      pose proof (Yu t Ht).
      unfold f. rewrite Split, <- Cg. assert (a1 * (W t + q t) <= a1 * g) by (apply Rmult_le_compat_l; lra).
      assert (a2 * y t <= a2 * g) by (apply Rmult_le_compat_l; lra). lra. }
    assert (El : forall t, t0 <= t < T -> - ((pi + c * S) * (t - t0)) <= E t).
    { intros t Ht. assert (-1 * E t - -1 * E t0 <= (pi + c * S) * (t - t0)); [|lra].
      apply (dini_slope (fun r => -1 * E r)); auto using cont_scal; [lra|]. intros r Hr.
      eapply rderiv_dini; [|apply rderiv_scal, DE; lra]. destruct (Pi r ltac:(lra)). pose proof (Fl r ltac:(lra)).
        lra. }
    set (G := (pi + (c + 1) * S) / M). assert (G0 : 0 <= G).
    { apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; auto]. assert (0 <= (c + 1) * S) by (apply Rmult_le_pos;
      lra). lra. }
    assert (Ql : forall t, t0 <= t < T -> - (G * (t - t0)) <= q t).
    { intros t Ht. apply Rmult_le_reg_l with M; auto. pose proof (El t Ht) as E1. pose proof (W1 t Ht) as W2.
      assert (m1 * W t <= S * (t - t0)).
      { replace (S * (t - t0)) with (m1 * (S / m1 * (t - t0))) by (field; lra). apply Rmult_le_compat_l; lra. }
      unfold E, gain in E1. fold (W t) (q t) in E1.
      replace (M * - (G * (t - t0))) with (- ((pi + c * S) * (t - t0)) - S * (t - t0)) by (unfold G;
        field; lra). lra. }
    assert (Gs' : forall t, t0 <= t < T -> G * (t - t0) <= G) by (intros t Ht; rewrite <- (Rmult_1_r G) at 2;
      apply Rmult_le_compat_l; lra).
    assert (Yl : forall t, t0 <= t < T -> - (G * (t - t0)) <= y t).
    { intros t Ht. assert (-1 * y t - -1 * y t0 <= G * (t - t0)); [|lra].
      apply (dini_slope (fun r => -1 * y r)); auto using cont_scal; [lra|]. intros r Hr.
      eapply rderiv_dini; [|apply rderiv_scal, Dy; lra]. rewrite Split. pose proof (Ql r ltac:(lra)).
        pose proof (Wn r ltac:(lra)).
      pose proof (Gs' r ltac:(lra)). lra. }
    intros t Ht. pose proof (Ql t Ht). pose proof (Yl t Ht). pose proof (Wn t ltac:(lra)).
    assert (F1 : f t <= (a1 + a2) * (G * (t - t0))).
    { unfold f. rewrite Split. assert (a1 * - (G * (t - t0)) <= a1 * (W t + q t)) by (apply Rmult_le_compat_l; lra).
      assert (a2 * - (G * (t - t0)) <= a2 * y t) by (apply Rmult_le_compat_l; lra). lra. }
    replace ((a1 + a2) * (G * (t - t0))) with (K * (t - t0) * pi + K * (c + 1) * (t - t0) * S) in F1 by (unfold G, K;
      field; lra).
    assert (Kd : K * (c + 2) * (t - t0) <= / 4).
    { apply Rle_trans with (K * (c + 2) * d); [apply Rmult_le_compat_l; lra|lra]. }
    assert (0 <= K * (t - t0)) by (apply Rmult_le_pos; lra). assert (0 <= K * (t - t0) * c) by (apply Rmult_le_pos;
      lra).
    assert (K * (t - t0) * pi <= / 4 * pi) by (apply Rmult_le_compat_r; lra).
    assert (K * (c + 1) * (t - t0) * S <= / 4 * S) by (apply Rmult_le_compat_r; lra). lra. }
  (* so the least such bound is at most a third of what the force lacks *)
  assert (Third : forall T, t0 < T < t0 + d -> forall t, t0 <= t < T -> f t <= / 3 * - beyond k T).
  { intros T HT. destruct (completeness (fun z => z = 0 \/ exists t, t0 <= t < T /\ z = f t)) as (S & Ub & Lub).
    { exists (m1 * kap + - beyond k T). intros z [->|(t & Ht & ->)].
      - pose proof (Mono t0 T ltac:(lra) ltac:(lra)). assert (0 < m1 * kap) by (apply Rmult_lt_0_compat; auto). lra.
      - pose proof (Mono t T ltac:(lra) ltac:(lra)). specialize (Near (t - t0) ltac:(lra)).
        replace (t0 + (t - t0)) with t in Near by ring.
        apply Rabs_inv in Near. assert (k * load t - b <= 1) by (destruct Hk; subst k; lra).
        assert (kap * (k * load t - b) <= kap * 1) by (apply Rmult_le_compat_l; lra). rewrite Load in H2.
        assert (beyond k t + f t <= m1 * kap); [|lra].
        replace (beyond k t + f t) with (m1 * ((beyond k t + f t) / m1)) by (field; lra). apply Rmult_le_compat_l;
          lra. }
    { exists 0. auto. }
    assert (S0 : 0 <= S) by (apply Ub; auto). assert (Bd : forall t, t0 <= t < T -> f t <= S) by (intros t Ht;
      apply Ub; eauto).
    pose proof (Better T S HT S0 Bd) as Q. pose proof (Mono t0 T ltac:(lra) ltac:(lra)).
    assert (S <= / 4 * (- beyond k T + S)) by (apply Lub; intros z [->|(t & Ht & ->)]; [lra|auto]).
    intros t Ht. specialize (Bd t Ht). lra. }
  assert (Low : forall T, t0 < T < t0 + d -> f T <= / 3 * - beyond k T).
  { intros T HT. apply Rnot_lt_le. intros N. assert (Cf : cont f).
    { apply cont_ext with (fun t => -1 * (a1 * y' t + a2 * y t)); [intros; unfold f; ring|].
      apply cont_scal, cont_plus; apply cont_scal; auto. apply cont_minus; [apply cont_scal,
        (f_cv _ _ _ _ _ _ _ _ _ _ H)|].
      apply cont_of_derive with (fun _ => b / m2). intros; auto_derive; auto; ring. }
    destruct (Cf T ltac:(lra) (f T - / 3 * - beyond k T)) as (e & He & Q); [lra|].
    set (r := Rmax t0 (T - e / 2)). assert (t0 <= r) by apply Rmax_l. assert (T - e / 2 <= r) by apply Rmax_r.
    assert (r < T) by (apply Rmax_lub_lt; lra). specialize (Q r ltac:(lra)). rewrite (Rabs_left (r - T)) in Q by lra.
    specialize (Q ltac:(lra)). apply Rabs_def2 in Q. pose proof (Third T HT r ltac:(lra)). lra. }
  exists d. split; [lra|]. intros t Ht.
  assert (W t <= 0 * (t - t0)).
  { apply (rise_le k 0 d Hk); [lra|lra| |lra]. intros r Hr _. rewrite Load.
    destruct (Req_dec r t0) as [->|N].
    - rewrite B0. unfold f. destruct Y0 as (-> & ->). replace ((0 + - (a1 * 0 + a2 * 0)) / m1) with 0 by (field; lra).
      lra.
    - pose proof (Low r ltac:(lra)). pose proof (Mono t0 r ltac:(lra) ltac:(lra)).
      assert (beyond k r + f r <= 0) by lra. assert (0 < / m1) by (apply Rinv_0_lt_compat; auto).
      apply Rmult_le_0_r; lra. }
  pose proof (Wn t Ht). unfold W, w in *. destruct Hk; subst k; lra.
Qed.

(** *** The rule for ties: the first derivative that is not 0 decides *)
Variables (P : nat -> R -> R) (n : nat) (k : R).
Hypotheses (Hk : k = 1 \/ k = -1) (Tie : k * load t0 = b) (DP : forall i t, is_derive (P i) t (P (S i) t))
  (P0 : forall t, t0 <= t < t0 + d0 -> beyond k t = P 0%nat t) (Flat : forall i, (i < n)%nat -> P i t0 = 0).

(** a sign of the n-th derivative right after t0 is that of all lower ones *)
Lemma all_below g d : g = 1 \/ g = -1 -> (forall t, t0 <= t < t0 + d -> 0 < g * P n t) ->
  forall i, (i <= n)%nat -> forall t, t0 < t < t0 + d -> 0 < g * P i t.
Proof.
  intros Hg Pn i Hi. remember (n - i)%nat as j eqn:Ej. revert i Hi Ej. induction j as [|j IH]; intros i Hi Ej t Ht.
  - replace i with n by lia. apply Pn. lra.
  - replace 0 with (g * P i t0) by (rewrite Flat by lia; ring).
    destruct (MVT_cor2 (fun t => g * P i t) (fun t => g * P (S i) t) t0 t) as (c & Ec & Hc); [lra| |].
    { intros c _. apply is_derive_Reals, is_derive_scal, DP. }
    pose proof (IH (S i) ltac:(lia) ltac:(lia) c ltac:(lra)) as Pc.
    assert (0 < g * P (S i) c * (t - t0)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
(** it keeps that sign for a while *)
Lemma sign_stays g : g = 1 \/ g = -1 -> 0 < g * P n t0 -> exists d, 0 < d <= d0 /\ forall t, t0 <= t < t0 + d ->
  0 < g * P n t.
Proof.
  intros Hg Pn. assert (C : cont (fun t => g * P n t)).
  { apply cont_of_derive with (fun t => g * P (S n) t). intros t. apply is_derive_scal, DP. }
  destruct (C t0 Ht0 (g * P n t0) Pn) as (d & Hd & K). exists (Rmin d d0). pose proof (Rmin_l d d0).
    pose proof (Rmin_r d d0).
  split; [split; [apply Rmin_glb_lt; auto|auto]|]. intros t Ht. specialize (K t ltac:(lra)).
  rewrite Rabs_pos_eq in K by lra. specialize (K ltac:(lra)). apply Rabs_def2 in K. lra.
Qed.
End Mode.

(** positive: slip; negative: stick *)
Theorem tie_rule m1 m2 a1 a2 b U u x v1 v2 s t0 d0 (P : nat -> R -> R) n k :
  0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b -> forced m1 m2 a1 a2 b U x v1 v2 s -> 0 <= t0 -> 0 < d0 ->
  (forall t, t0 <= t < t0 + d0 -> rderiv U t (u t)) ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (u (t0 + h) - u t0) <= e) ->
  v1 t0 = v2 t0 -> k = 1 \/ k = -1 -> k * load m1 m2 a1 a2 u x v1 t0 = b ->
  (forall i t, is_derive (P i) t (P (S i) t)) ->
  (forall t, t0 <= t < t0 + d0 -> beyond m1 m2 a1 a2 b u x v1 t0 k t = P 0%nat t) ->
  (forall i, (i < n)%nat -> P i t0 = 0) ->
  (0 < P n t0 -> exists d, 0 < d /\ forall t, t0 < t < t0 + d -> 0 < k * (v1 t - v2 t)) /\
  (P n t0 < 0 -> exists d, 0 < d /\ forall t, t0 <= t < t0 + d -> v1 t = v2 t).
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb H Ht0 Hd0 DU Cu Meet Hk Tie DP P0 Flat.
  assert (Part : forall d, 0 < d <= d0 -> forall t, t0 <= t < t0 + d -> rderiv U t (u t)) by (intros; apply DU; lra).
  split; intros Pn.
  - destruct (sign_stays t0 d0 Ht0 Hd0 P n DP 1 (or_introl eq_refl)) as (d & Hd & Sg); [lra|].
    apply (slips_at_edge m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u x v1 v2 s t0 d H Ht0 ltac:(lra) (Part d Hd) Cu Meet k Hk
      Tie).
    intros t Ht. rewrite P0 by lra. rewrite <- (Rmult_1_l (P 0%nat t)).
    apply (all_below t0 P n DP Flat 1 d (or_introl eq_refl) Sg 0%nat ltac:(lia) t Ht).
  - destruct (sign_stays t0 d0 Ht0 Hd0 P n DP (-1) (or_intror eq_refl)) as (d & Hd & Sg); [lra|].
    apply (sticks_at_edge m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u x v1 v2 s t0 d H Ht0 ltac:(lra) (Part d Hd) Cu Meet k
      Hk Tie).
    intros r t Hr Ht. rewrite !P0 by lra. destruct n as [|m].
    + (* the tie itself says that the force asks b and no more *)
      exfalso. rewrite <- P0 in Pn by lra. assert (Mp : 0 < m1 + m2) by lra.
      replace (beyond m1 m2 a1 a2 b u x v1 t0 k t0) with ((m1 + m2) / m2 * (k * load m1 m2 a1 a2 u x v1 t0 - b)) in Pn
        by (unfold beyond, load; field; lra). rewrite Tie in Pn. lra.
    + destruct (Req_dec r t) as [->|N]; [lra|]. destruct (MVT_cor2 (P 0%nat) (P 1%nat) r t) as (c & Ec & Hc); [lra| |].
      { intros c _. apply is_derive_Reals, DP. }
      pose proof (all_below t0 P (S m) DP Flat (-1) d (or_intror eq_refl) Sg 1%nat ltac:(lia) c ltac:(lra)) as Pc.
      assert (0 < -1 * P 1%nat c * (t - r)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
