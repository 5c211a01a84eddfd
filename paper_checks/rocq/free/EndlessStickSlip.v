(** For all parameters there is a solution that sticks and slips in turn for ever: start on S0 slightly above E_cr. *)
From InertialPair Require Import Dini Pair Stick Excursion Cycle SharpRate SharpLaw OneOverT WellPosed.

(** [stick-slip-for-ever] For all $m_1,m_2,a_2,b>0$ there is a solution that sticks and slips in turn without end. *)
Theorem stick_slip_for_ever m1 m2 a2 b : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> exists x v1 v2 s,
  solution m1 m2 0 a2 b x v1 v2 s /\ (forall t, 0 <= t -> Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t)) /\
  exists te tau : nat -> R, (forall n, 0 <= te n < tau n) /\ (forall n, tau n < te (S n)) /\ is_lim_seq te p_infty /\
    (forall n t, te n <= t <= tau n -> v1 t = v2 t) /\ (forall n t, tau n < t < te (S n) -> v1 t <> v2 t).
Proof.
  intros H1 H2 Ha Hb. pose proof (Ecr_pos m1 m2 a2 b H1 H2 Ha Hb) as E0.
  pose proof (L_pos m1 m2 a2 b H1 H2 Ha Hb) as L0. set (q := m1 / (m1 + m2)) in *. set (Ec := Ecr m1 m2 a2 b) in *.
  (* at the middle of S0, with the speed of the level 1 + 4 q/9 *)
  set (v := sqrt (2 * (Ec * (1 + 4 / 9 * q)) / (m1 + m2))).
  assert (V2 : v * v = 2 * (Ec * (1 + 4 / 9 * q)) / (m1 + m2)).
  { apply sqrt_sqrt. positive. }
  assert (En : energy m1 m2 a2 0 v v = Ec * (1 + 4 / 9 * q)).
  { unfold energy. replace (a2 * 0 ^ 2 / 2 + m1 * v ^ 2 / 2 + m2 * v ^ 2 / 2) with ((m1 + m2) * (v * v) / 2) by field.
    rewrite V2. field. lra. }
  destruct (well_posed m1 m2 0 a2 b 0 v v H1 H2 (Rle_refl 0) Ha Hb) as (x & v1 & v2 & s & (H & X0 & A0 & B0) & _).
  assert (Up : forall t, 0 <= t -> Ec < energy m1 m2 a2 (x t) (v1 t) (v2 t)).
  { apply (no_merging_from_S0 m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s 0 H); try lra.
    - fold Ec. rewrite X0, A0, B0. assert (0 < Ec * (4 / 9 * q)) by positive. lra.
    - apply small_simple; auto. rewrite X0, A0, B0. fold q Ec. lra. }
  exists x, v1, v2, s. split; [exact H|]. split; [exact Up|].
  destruct (times m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H Up) as (te & tau & O1 & O2 & TI & St & Off & _).
  exists te, tau. split; [exact O1|]. split; [exact O2|]. split; [exact TI|]. split; [|exact Off].
  intros n t Hu. apply (St n t Hu).
Qed.
