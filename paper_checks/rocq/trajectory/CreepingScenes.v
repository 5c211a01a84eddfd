(** The starts of the paper's Figs. 3 (b), 4 (b), 5 (a) and 5 (b) with v1 > 0 alone: what becomes of them for all
  times. *)
From Coq Require Import Reals QArith Qreals List.
From Interval.Float Require Import Specific_ops Specific_stdz.
From Interval.Interval Require Import Float_full.
From Interval Require Import Tactic.
From InertialPair Require Import Dini Pair Stick Pursuit TurningFunction Dichotomy MergingByMassRatio Fading Waves
  Trajectory Velocities FirstAdhesion.
Import ListNotations.

Definition no_event := Event Stick (0, 0)%Q (0, 0)%Q (0, 0)%Q (0, 0)%Q.
Definition answer := [(Steady 0%Q [] [], Steady 0%Q [] [])].

(** *** Tables: the mode until an event; bounds of the time, of both places, and of the common velocity *)
Section Tables.
Local Open Scope Q_scope.
Definition events_b02 := [
  Event (Slip true) (0.095442259404, 0.095442259405) (0.00956778855882, 0.00956778855883)
    (0.00091092248802, 0.00091092248803) (0.01908845188, 0.019088451881);
  Event (Slip false) (0.314307457217, 0.314307457218) (-0.00749601091217, -0.00749601091216)
    (0.00029852280352, 0.00029852280353) (-0.024684587682, -0.024684587681);
  Event (Slip true) (0.539730242783, 0.539730242784) (0.00556993214211, 0.00556993214212)
    (-0.000184402487, -0.00018440248699) (0.020399969431, 0.020399969432);
  Event (Slip false) (0.758596178325, 0.758596178326) (-0.00349817040859, -0.00349817040858)
    (-0.00050977386642, -0.00050977386641) (-0.023373217678, -0.023373217677);
  Event (Slip true) (0.984017879164, 0.984017879165) (0.00157206681759, 0.0015720668176)
    (-0.00069711002834, -0.00069711002833) (0.02171112249, 0.021711122491)].
Definition ending_b02 := Ending Stick 1 (0.00189754649445, 0.00189754649446) (0.018932616772, 0.018932616773)
    (-0.00037163035148, -0.00037163035147) (0.018932616772, 0.018932616773) (0, 0) false.
Definition events_b05 := [
  Event (Slip true) (0.076878757091, 0.076878757092) (0.00805282288702, 0.00805282288703)
    (0.00147758582299, 0.001477585823) (0.038439378545, 0.038439378546);
  Event (Slip false) (0.276302590324, 0.276302590325) (-0.00191023259273, -0.00191023259272)
    (-0.00079915227557, -0.00079915227556) (-0.061272538071, -0.06127253807)].
Definition ending_b05 := Ending Stick 0.3 (-0.00329529553819, -0.00329529553818) (-0.055075634441, -0.05507563444)
    (-0.00218421522104, -0.00218421522103) (-0.055075634441, -0.05507563444) (0, 0) false.
Definition events_021 := [
  Event (Slip true) (0.0850603922969, 0.085060392297) (0.0122548606254, 0.0122548606255)
    (0.0018088175844, 0.0018088175845) (0.042530196148, 0.042530196149)].
Definition ending_021 := Ending (Slip false) 0.1 (0.0126686166428, 0.0126686166429) (0.012654084841, 0.012654084842)
    (0.0023884040608, 0.0023884040609) (0.035060392296, 0.035060392297) (-0.022406307455, -0.022406307454) false.

(** the program accepts them *)
Lemma accepted_b02 : C.check F.PtoP (F.PtoP 24) 64 (from_speed 0.15 0.2) 72 answer events_b02 ending_b02 [
  Hit 72 0.095442259404802027471 0.095442259404802027539 true;
  Hit 72 0.21886519781297710557 0.21886519781297710573 false;
  Hit 72 0.22542278556555585806 0.22542278556555585834 true;
  Hit 72 0.21886593554243692501 0.21886593554243692545 false;
  Hit 72 0.22542170083891308262 0.2254217008389130837 true;
  Last 72 0.0159821208353150015] = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma accepted_b05 : C.check F.PtoP (F.PtoP 24) 64 (from_speed 0.15 0.5) 72 answer events_b05 ending_b05 [
  Hit 72 0.07687875709183152789 0.076878757091831527958 true;
  Hit 72 0.19942383323217747165 0.19942383323217747193 false;
  Last 72 0.0236974096759910005] = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma accepted_021 : C.check F.PtoP (F.PtoP 24) 64 (from_speed 0.21 0.5) 72 answer events_021 ending_021 [
  Hit 72 0.085060392296908212236 0.085060392296908212304 true;
  Last 72 0.0149396077030917878] = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
End Tables.


(** What becomes of a pair with the friction B: after n crossings of S it first sticks, at a time between lo and hi,
  at an
    energy above E_cr; from then on it sticks and slips in turn, never faster than f. *)
Definition creeps B n lo hi f (x v1 v2 : R -> R) := exists ta contacts, lo <= ta <= hi /\ length contacts = n /\
  NoDup contacts /\ (forall u, In u contacts <-> 0 <= u < ta /\ v1 u = v2 u) /\ sticks_and_slips ta f v1 v2 /\
  (forall t, 0 <= t -> Ecr 1 1 200 B < energy 1 1 200 (x t) (v1 t) (v2 t)).

(** it does, if a table has it enter S0 with such an energy *)
Lemma table_creeps B n lo hi f x v1 x2 v2 s slips now later e : 0 < B -> solution 1 1 0 200 B x v1 v2 s ->
  length slips = n -> unfolds x v1 x2 v2 0 (slips ++ now :: later) e -> v1 0 <> v2 0 ->
  (forall m, In m (slips ++ [now]) -> mode_until m <> Stick) -> lo <= Q2R (fst (time now)) -> Q2R (snd (time now)) <=
    hi ->
  (forall y v, within (place now) y -> within (speed now) v -> let g := (100 * y ^ 2 + v ^ 2) / (B ^ 2 / 100) - 1 in
    - (B / 100) <= y <= B / 100 /\ 0 < g <= (314 / 100) ^ 2 / 8 /\
    B / (1 * sqrt (200 / 1)) * (2 * (sqrt (g / (1 / 2)) - atan (sqrt (g / (1 / 2))))) <= f) ->
  creeps B n lo hi f x v1 v2.
Proof.
  intros HB H <- U N S Lo Hi Num. apply entry in U; auto.
  destruct U as (ta & times & T0 & Wa & Xa & Va & Ea & Ln & Nd & Cs & _). destruct (Num _ _ Xa Va) as (Hx & Hg & Hf).
  assert (P : 314 / 100 < PI) by interval with (i_prec 60).
  assert (Ee : energy 1 1 200 (x ta) (v1 ta) (v2 ta) = 100 * x ta ^ 2 + v1 ta ^ 2) by (rewrite <- Ea; unfold energy;
    field). assert (Ec : Ecr 1 1 200 B = B ^ 2 / 100) by (unfold Ecr; field). assert (B2 : 0 < B ^ 2) by positive.
  assert (F := fades 1 1 200 B Rlt_0_1 Rlt_0_1 ltac:(lra) HB x v1 v2 s H ta ltac:(lra) Ea). cbv zeta in F.
  replace (1 / (1 + 1)) with (1 / 2) in F by field. rewrite Ee, Ec in F. destruct F as (F & Up).
  - unfold L. lra.
  - nra.
  - apply Rmult_lt_reg_r with (/ (B ^ 2 / 100)); [positive|]. rewrite Rinv_r by lra. unfold Rdiv in Hg at 1. lra.
  - rewrite <- (sqrt_Rsqr (PI / 2)) by lra. apply sqrt_le_1_alt. unfold Rsqr. undivide (1 / 2). nra.
  - exists ta, times. split; [unfold within in Wa; lra|]. split; [exact Ln|].
    split; [exact Nd|]. split; [exact Cs|]. split.
    + destruct F as (te & tau & A1 & A2 & A3 & A4 & A5 & A6 & A7 & A8). exists te, tau. repeat (split; [assumption|]).
      intros t Ht. apply Rle_trans with (1 := A8 t Ht). exact Hf.
    + intros t Ht. rewrite Ec. exact (Up t Ht).
Qed.

Ltac of_bounds := simpl; unfold Q2R; simpl; lra.
Ltac of_table H U := eapply table_creeps with (2 := H) (4 := U); [lra|reflexivity|lra|intros m Hm; simpl in Hm;
  repeat (destruct Hm as [<-|Hm]; [discriminate|]); contradiction|of_bounds|of_bounds|intros ? ? Y V;
    unfold within in Y, V;
  simpl in Y, V; unfold Q2R in Y, V; simpl in Y, V; cbv zeta; repeat split; first [lra | interval with (i_prec 60)]].

(** [creeps-b-0.05] The scene of Fig. 5 (a): 20 crossings, first adhesion at 4.549769... s, and from then on sticks
    and slips in turn without end, above $E_{cr}$, each slip slower than the one before, none faster than 2.3202 mm/s.
    *)
Theorem creeps_b005 x v1 v2 s : solution 1 1 0 200 (5 / 100) x v1 v2 s -> x 0 = 0 -> v1 0 = 15 / 100 -> v2 0 = 0 ->
  creeps (5 / 100) 20 (4549769 / 10 ^ 6) (4549770 / 10 ^ 6) (23202 / 10 ^ 7) x v1 v2.
Proof.
  intros H X0 V1 V2. pose proof (trajectory x v1 (integral v2) v2 (speed_motion 0.15 0.05 x v1 v2 s H X0 V1 V2)) as U.
  change the_events with (firstn 20 the_events ++ nth 20 the_events no_event :: skipn 21 the_events) in U.
  of_table H U.
Qed.
(** [creeps-b-0.2] The same with $b=0.2$: 4 crossings, first adhesion at 0.984017... s, none faster than 10.219 mm/s
    from then on. *)
Theorem creeps_b02 x v1 v2 s : solution 1 1 0 200 (2 / 10) x v1 v2 s -> x 0 = 0 -> v1 0 = 15 / 100 -> v2 0 = 0 ->
  creeps (2 / 10) 4 (984017 / 10 ^ 6) (984018 / 10 ^ 6) (10219 / 10 ^ 6) x v1 v2.
Proof.
  intros H X0 V1 V2. assert (U := C.sound _ _ _ _ _ _ _ _ _ accepted_b02 x v1 (integral v2) v2 (speed_motion 0.15 0.2
    x v1 v2 s H X0 V1 V2)).
  change events_b02 with (firstn 4 events_b02 ++ nth 4 events_b02 no_event :: [])%list in U. of_table H U.
Qed.
(** [creeps-b-0.5] The same with $b=0.5$, as in Fig. 4 (b): 1 crossing, first adhesion at 0.276302... s, none faster
    than 20.381 mm/s from then on. *)
Theorem creeps_b05 x v1 v2 s : solution 1 1 0 200 (5 / 10) x v1 v2 s -> x 0 = 0 -> v1 0 = 15 / 100 -> v2 0 = 0 ->
  creeps (5 / 10) 1 (276302 / 10 ^ 6) (276303 / 10 ^ 6) (20381 / 10 ^ 6) x v1 v2.
Proof.
  intros H X0 V1 V2. assert (U := C.sound _ _ _ _ _ _ _ _ _ accepted_b05 x v1 (integral v2) v2 (speed_motion 0.15 0.5
    x v1 v2 s H X0 V1 V2)).
  change events_b05 with (firstn 1 events_b05 ++ nth 1 events_b05 no_event :: [])%list in U. of_table H U.
Qed.

(** [itinerary-creeps] $m_1=m_2=1$, $a_2=200$, $b=0.5$, $\dot x_1(0)=0.21$: the energy stays above $E_{cr}$, and the
    motion tends to one on the critical ellipse. *)
Theorem itinerary_creeps x v1 v2 s : solution 1 1 0 200 (5 / 10) x v1 v2 s -> x 0 = 0 -> v1 0 = 21 / 100 -> v2 0 = 0 ->
  (forall t, 0 <= t -> Ecr 1 1 200 (5 / 10) < energy 1 1 200 (x t) (v1 t) (v2 t)) /\
  exists x0 v0, energy 1 1 200 x0 v0 v0 = Ecr 1 1 200 (5 / 10) /\ forall e, 0 < e -> exists T, 0 <= T /\
    forall t, T <= t ->
    energy 1 1 200 (x t - X 1 1 200 x0 v0 t) (v1 t - V 1 1 200 x0 v0 t) (v2 t - V 1 1 200 x0 v0 t) <= e.
Proof.
  intros H X0 V1 V2. assert (U := C.sound _ _ _ _ _ _ _ _ _ accepted_021 x v1 (integral v2) v2 (speed_motion 0.21 0.5
    x v1 v2 s H X0 V1 V2)).
  destruct U as (t0 & T0 & _ & Wx & _ & _ & Ev & _). unfold within in Wx. simpl in Wx. unfold Q2R in Wx. simpl in Wx.
  destruct heavy_never_merges as (ps & Hps & Z & Never).
  assert (Up : forall t, 0 <= t -> Ecr 1 1 200 (5 / 10) < energy 1 1 200 (x t) (v1 t) (v2 t)).
  { assert (R : - cos (2 * ps) < 1 / 1).
    { assert (Ne : ps <> PI / 2) by (intros ->; unfold K in Z; rewrite sin_PI2, cos_PI2 in Z;
        pose proof PI2_3_2; assert (sqrt 2 < 3 / 2) by interval with (i_prec 60); lra).
      rewrite cos_2a_cos. assert (cos ps <> 0); [|nra]. intros C0. apply Ne.
      apply cos_inj; [lra|lra|]. rewrite C0, cos_PI2. reflexivity. }
    assert (L : forall t, t0 <= t -> Ecr 1 1 200 (5 / 10) < energy 1 1 200 (x t) (v1 t) (v2 t)).
    { apply (Never 1 1 200 (5 / 10) Rlt_0_1 Rlt_0_1 ltac:(lra) ltac:(lra) R x v1 v2 s t0 H ltac:(lra) Ev).
      assert (X1 : 12 / 1000 <= x t0) by lra. pose proof (pow2_ge_0 (v1 t0)). pose proof (pow2_ge_0 (v2 t0)).
      assert ((12 / 1000) ^ 2 <= x t0 ^ 2) by nra. unfold Ecr, energy. lra. }
    intros t Ht. destruct (Rle_dec t0 t); [apply L; auto|]. apply Rlt_le_trans with (1 := L t0 (Rle_refl _)).
    apply (energy_decreases 1 1 0 200 (5 / 10) Rlt_0_1 Rlt_0_1 (Rle_refl 0) ltac:(lra) x v1 v2 s H); lra. }
  split; [exact Up|].
  destruct (dichotomy 1 1 200 (5 / 10) Rlt_0_1 Rlt_0_1 ltac:(lra) ltac:(lra) x v1 v2 s H) as [(tm & x0 & v0 & Hm & He
    & Q)|(x0 & v0 & He & _ & Q)].
  - exfalso. specialize (Up tm Hm). destruct (Q 0 ltac:(lra)) as (K1 & K2 & K3). rewrite Rplus_0_r in K1, K2, K3.
    rewrite K1, K2, K3, ellipse_energy in Up; lra.
  - exists x0, v0. split; [exact He|exact Q].
Qed.
