(** The time of a cycle is pi/Omega up to a constant times w^(3/2),
  w the excess of its exit: the orders sqrt w and w cancel.

    By `RateBounds.cycle_angles`, with u = h(p), u' that of the next exit and rho^2 = 1 + q u'^2: rho is 1 up to
    u^2/2, and u' is u up to r c^2/u. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap TurningFunction FollowArc Cycle ExitOrbit
  RateBounds.

Section Time.
Variables m1 m2 a2 : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2).
Let q := m1 / (m1 + m2).
Let r := m2 / (m1 + m2).
Let om := omega m1 m2 a2.

(** [cycle-time-sharp] With $r\,c^2<h^2$ the time of a cycle differs from $\pi/\Omega$ by at most $\tfrac{27}{2}\sqrt
    q\,h^3/\Omega$ where $h=\sqrt{w/q}\leqslant\tfrac{2}{3}$: by a constant times $w^{3/2}$. *)
Theorem cycle_time_sharp p : ok m1 m2 p -> hh p <= 2 / 3 ->
  Rabs (om * cyc m1 m2 a2 p - PI) <= 27 / 2 * sqrt q * hh p ^ 3.
Proof.
  intros Hok Hu. pose proof (ok_pi m1 m2 p Hok) as Hp. destruct (ok_push m1 m2 Hm1 Hm2 p Hp Hu) as (_ & C1 & P3).
  destruct (cycle_between m1 m2 a2 Hm1 Hm2 Ha2 p Hp Hu) as (Lo & _). fold q om in Lo.
  destruct (cycle_angles m1 m2 a2 Hm1 Hm2 Ha2 p Hp Hu) as (EA & U' & HA & HB). fold q om in EA, HA, HB.
  destruct (next_ok m1 m2 Hm1 Hm2 p Hok) as (Hn & En). fold r in En. pose proof (hh_pos _ (ok_pi m1 m2 _ Hn)) as N0.
  pose proof (hh_pos p Hp) as U0. pose proof (depth_pos p Hp) as C0. pose proof (depth_upper p Hp) as C2.
  pose proof (back p (proj1 Hok)) as P2. pose proof (q_pos m1 m2 Hm1 Hm2) as Q0. pose proof (r_pos m1 m2 Hm1 Hm2) as R0.
  pose proof (qr_one m1 m2 Hm1 Hm2) as QR. fold q r in Q0, R0, QR.
  set (u' := hh (next m1 m2 p)) in *. set (u := hh p) in *. set (c := depth p) in *. set (rho := amp m1 m2 (u' ^ 2)) in *.
  assert (Y2 : 0 < u' ^ 2) by positive. assert (Sq : 0 < sqrt q) by positive. apply Rabs_le. split.
  - assert (q * c / (1 - q * c) <= 3 * (q * (3 / 2 * u ^ 2))).
    { assert (q * c <= q * (3 / 2 * u ^ 2)) by scale. assert (0 < q * c <= 2 / 3) by (split; [positive|nra]).
      undivide (1 - q * c). assert (0 < q * (3 / 2 * u ^ 2)) by positive. nra. }
    assert (sqrt q * (2 * p - u) <= sqrt q * (2 * u)) by scale. assert (0 < q * c / (1 - q * c)) by (assert (q * c < 1) by nra; positive).
    assert (sqrt q * (2 * p - u) * (q * c / (1 - q * c)) <= sqrt q * (2 * u) * (3 * (q * (3 / 2 * u ^ 2)))).
    { apply Rmult_le_compat; [positive|lra|lra|lra]. }
    assert (q * (sqrt q * u ^ 3) <= 1 * (sqrt q * u ^ 3)) by (apply Rmult_le_compat_r; [apply Rlt_le; positive|lra]).
    assert (0 < sqrt q * u ^ 3) by positive. lra.
  - assert (R1 : 1 <= rho) by (apply amp_ge; auto; lra).
      assert (R2 : rho * rho = 1 + q * u' ^ 2) by (apply amp_sq; auto; lra).
    assert (R3 : rho - 1 <= u ^ 2 / 2). { assert (u' ^ 2 <= u ^ 2) by (apply pow_incr; lra). nra. }
    assert (Du : u - u' <= 9 / 4 * u ^ 3).
    { apply Rmult_le_reg_r with u; auto. assert ((u - u') * u <= u ^ 2 - u' ^ 2) by nra.
      assert (c ^ 2 <= (3 / 2 * u ^ 2) ^ 2) by (apply pow_incr; lra). assert (r * c ^ 2 <= 1 * c ^ 2) by (apply Rmult_le_compat_r; [positive|lra]).
      lra. }
    assert (I : forall y, 0 <= y <= 2 * u -> sqrt q * y - sqrt q * u ^ 3 <= sqrt q * y / rho).
    { intros y Hy. undivide rho. replace (sqrt q * y) with (sqrt q * y * 1) at 2 by ring.
      assert (sqrt q * y * (rho - 1) <= sqrt q * (2 * u) * (u ^ 2 / 2)) by (apply Rmult_le_compat; [positive|lra|scale|lra]).
      assert (0 <= sqrt q * u ^ 3 * (rho - 1)) by positive. lra. }
    pose proof (I u' ltac:(lra)). pose proof (I (2 * p - u) ltac:(lra)).
    assert (sqrt q * (u - u') <= sqrt q * (9 / 4 * u ^ 3)) by scale. assert (0 < sqrt q * u ^ 3) by positive. lra.
Qed.
End Time.
