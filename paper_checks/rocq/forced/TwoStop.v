(** A sinusoidal force between U* and U**: motions that slip and stick once in each half period. The state at the exit
    and the two parts of the force solve a linear system: the load is b at the exit, v1 = v2 again at the end of the
    slip, and the state has changed sign after half a period. A solution of it is such a motion exactly if v1 > v2 in
    the slip and the load stays within b in the stick. *)
From InertialPair Require Import Dini Pair Forced Arcs Nonstop RuleOfModes.

Section TwoStop.
Variables m1 m2 a1 a2 b om F phi ts : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (Hom : 0 < om) (Hts : 0 < ts < PI
  / om).
Let T := PI / om.
Let M := m1 + m2.
Let u t := F * sin (om * t + phi).

(** a motion under F sin (om t + phi) that slips forwards in (0, ts), sticks until pi/om and repeats with the opposite
    sign *)
Definition two_stop x v1 v2 s := forced m1 m2 a1 a2 b (wave F om phi) x v1 v2 s /\
  (forall t, 0 < t < ts -> v2 t < v1 t) /\ (forall t, ts <= t <= PI / om -> v1 t = v2 t) /\
  forall t, 0 <= t -> x (PI / om + t) = - x t /\ v1 (PI / om + t) = - v1 t /\ v2 (PI / om + t) = - v2 t.

(** body 1 in a slip, with the place X and the speed V *)
Definition slips (X V : R -> R) := (forall t, is_derive X t (V t)) /\
  forall t, is_derive V t ((F * sin (om * t + phi) - a2 * X t - a1 * V t - b) / m1).
(** the stuck pair, with the place Y and the speed W *)
Definition sticks (Y W : R -> R) := (forall t, is_derive Y t (W t)) /\
  forall t, is_derive W t ((F * sin (om * t + phi) - a2 * Y t - a1 * W t) / (m1 + m2)).

(** the load of the stuck pair *)
Let load Y W t := m2 * (u t - a2 * Y t - a1 * W t) / M.

(** [two-stop-exists] A slip and a stick whose ends meet, and meet with the opposite sign after half a period, are a
    periodic motion if $v_1>v_2$ in the slip and $|\Lambda|\leqslant b$ in the stick. *)
Theorem two_stop_exists X V Y W : slips X V -> sticks Y W ->
  Y ts = X ts -> W ts = V ts -> V ts = V 0 + b / m2 * ts -> Y (PI / om) = - X 0 -> W (PI / om) = - V 0 ->
  (forall t, 0 < t < ts -> V 0 + b / m2 * t < V t) ->
  (forall t, ts <= t < PI / om -> Rabs (m2 * (F * sin (om * t + phi) - a2 * Y t - a1 * W t) / (m1 + m2)) <= b) ->
  exists x v1 v2 s, two_stop x v1 v2 s /\ (forall t, 0 <= t <= ts -> x t = X t /\ v1 t = V t) /\
    forall t, ts <= t <= PI / om -> x t = Y t /\ v1 t = W t.
Proof.
  intros (DX & DV) (DY & DW) EY EW Meet ET ET' Slip Load. pose proof Hts as Ht0.
  change (PI / om) with T in Ht0, ET, ET', Load |- *. assert (Mp : 0 < M) by positive.
  assert (A1 : forced_arc m1 m2 a1 a2 b ts u X V (fun t => V 0 + b / m2 * t) (fun _ => 1)).
  { apply slip_arc; auto.
    - intros t. rewrite Rmult_1_r. apply DV.
    - intros t. auto_derive; auto. field; lra.
    - intros t Ht. destruct (Req_dec t 0) as [->|Nz]; [lra|]. specialize (Slip t ltac:(lra)). lra. }
  assert (A2 : forced_arc m1 m2 a1 a2 b (T - ts) (fun t => u (t + ts)) (fun t => Y (t + ts)) (fun t => W (t + ts))
    (fun t => W (t + ts)) (fun t => load Y W (t + ts) / b)).
  { apply (stuck_arc m1 m2 a1 a2 b Hm1 Hm2 Hb (T - ts) (fun t => u (t + ts)) (fun t => Y (t + ts))
      (fun t => W (t + ts))).
    - intros t. derive. ring.
    - intros t. derive. unfold u. field. lra.
    - intros t Ht. pose proof (Load (t + ts) ltac:(lra)) as B. apply Rabs_inv in B. exact B. }
  destruct (arc_begins m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb (wave F om phi) u X V _ _ ts ltac:(lra) (cont_wave F om phi Hom)
    (fun t _ => rderiv_wave F om phi t Hom) A1) as (x & v1 & v2 & s & H & E).
  destruct (E 0 ltac:(lra)) as (X0 & V10 & V20). destruct (E ts ltac:(lra)) as (Xs & V1s & V2s).
  assert (E2 : forall t, ts <= t <= T -> x t = Y t /\ v1 t = W t /\ v2 t = W t).
  { intros t Ht. pose proof (follow_arc m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb (wave F om phi) (fun t => u (t + ts)) x v1 v2 s
      (fun t => Y (t + ts)) (fun t => W (t + ts)) (fun t => W (t + ts)) (fun t => load Y W (t + ts) / b) (T - ts) ts
        ltac:(lra) ltac:(lra)) as Q.
    specialize (Q ltac:(intros r Hr; cbv beta; replace (r - ts + ts) with r by ring; apply rderiv_wave; auto) A2 H).
    cbv beta in Q. rewrite Rplus_0_l in Q. specialize (Q ltac:(lra) ltac:(lra) ltac:(lra) (t - ts) ltac:(lra)).
    replace (ts + (t - ts)) with t in Q by ring. replace (t - ts + ts) with t in Q by ring. auto. }
  exists x, v1, v2, s. split; [|split; [intros t Ht; destruct (E t Ht) as (-> & -> & _); auto|
    intros t Ht; destruct (E2 t Ht) as (-> & -> & _); auto]].
  split; [auto|]. split; [|split].
  - intros t Ht. destruct (E t ltac:(lra)) as (_ & -> & ->). apply Slip; auto.
  - intros t Ht. destruct (E2 t Ht) as (_ & -> & ->). auto.
  - destruct (E2 T ltac:(lra)) as (XT & V1T & V2T).
    apply (antiperiodic m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb (wave F om phi) x v1 v2 s T ltac:(lra)); auto; try lra.
    intros t _. apply wave_half; auto.
Qed.

(** [two-stop-needs] A motion that slips and sticks once in each half period, and is its own negative after it, leaves
    stick at $\Lambda=b$, gains $bt_s/m_2$ of velocity in the slip, and has $|\Lambda|\leqslant b$ in the stick. *)
Theorem two_stop_needs x v1 v2 s : two_stop x v1 v2 s ->
  F * sin phi - a1 * v1 0 - a2 * x 0 = (m1 + m2) * (b / m2) /\ v1 0 = v2 0 /\ v1 ts = v1 0 + b / m2 * ts /\
  forall t, ts <= t < PI / om -> Rabs (m2 * (F * sin (om * t + phi) - a2 * x t - a1 * v1 t) / (m1 + m2)) <= b.
Proof.
  intros (H & Slip & St & Anti). pose proof Hts as Ht0.
  change (PI / om) with T in Ht0, St, Anti |- *. assert (Mp : 0 < M) by positive.
  destruct (Anti 0 (Rle_refl 0)) as (X0 & V0 & W0). rewrite Rplus_0_r in X0, V0, W0.
  pose proof (moves_cv2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H) as Cv2. pose proof (f_cv _ _ _ _ _ _ _ _ _ _ H) as Cv.
  pose proof (f_cx _ _ _ _ _ _ _ _ _ _ H) as Cx. assert (Meet : v1 0 = v2 0) by (pose proof (St T ltac:(lra)); lra).
  pose proof (slip_clock _ _ _ _ _ _ _ _ _ _ 0 ts H ltac:(lra) Slip) as Clock.
  assert (V2 : forall t, 0 <= t <= ts -> v2 t = v2 0 + b / m2 * t).
  { intros t Ht. pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H 0 t ltac:(lra) ltac:(lra)) as Q.
    rewrite (Clock t) in Q by lra. lra. }
  assert (Load : forall t, ts <= t < T -> Rabs (m2 * (u t - a2 * x t - a1 * v1 t) / M) <= b).
  { intros t Ht. apply (RuleOfModes.stuck_load m1 m2 a1 a2 b Hm1 Hm2 Hb (wave F om phi) u x v1 v2 s H t (T - t)); try lra.
    - apply rderiv_wave; auto.
    - intros r Hr. apply St. lra. }
  split; [|split; [auto|split; [|exact Load]]].
  - apply Rle_antisym.
    + (* the load just before pi/om, where all has the opposite sign *)
      assert (Q0 : - (m2 * (u T - a2 * x T - a1 * v1 T) / M) <= b).
      { apply (cont_le (fun t => - (m2 * (u t - a2 * x t - a1 * v1 t) / M)) b ts T); [|lra|].
        - continuous.
        - intros t Ht. pose proof (Load t Ht) as B. apply Rabs_inv in B. lra. }
      assert (ut : u T = - (F * sin phi)).
      { unfold u, T. replace (om * (PI / om) + phi) with (phi + PI) by (field; lra). rewrite neg_sin. ring. }
      rewrite ut, X0, V0 in Q0. apply Rmult_le_reg_l with (m2 / M); [positive|].
      replace (m2 / M * ((m1 + m2) * (b / m2))) with b by (unfold M; field; unfold M in Mp; lra).
      replace (m2 * (- (F * sin phi) - a2 * - x 0 - a1 * - v1 0) / M) with (- (m2 / M * (F * sin phi - a1 * v1 0 - a2
        * x 0))) in Q0 by (field; lra). lra.
    + pose proof (exit_load _ _ _ _ _ _ _ _ _ _ 0 ts _ Hm1 Hm2 H ltac:(lra) Slip Meet (rderiv_wave F om phi 0 Hom)) as
      Q. rewrite Rmult_0_r, Rplus_0_l in Q. lra.
  - pose proof (V2 ts ltac:(lra)). pose proof (St ts ltac:(lra)). lra.
Qed.
End TwoStop.
