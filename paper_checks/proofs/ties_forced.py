"""Ties under a force: the law, both thresholds, the square wave's response, the fastest transfer and its amplitudes."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from paper_checks.proofs.gallina import term
from paper_checks.proofs.tie import NAMES, PAIR, Tie, equal
from theory import energy, filippov, forced, forced_control
from theory import forced_response as response
from theory.symbols import m1, u, v1, v2, x1

SINE = f"{PAIR}0 < om -> "
LETTERS = NAMES | {
    response.omega: "om",
    response.square_place: "h",
    response.square_speed: "h'",
    response.natural: "(sqrt (a2 / m1))",
    response.decline: "(Waves.fade m1 a1)",
    response.swing: "(ring_frequency m1 a1 a2)",
    response.decayed: "(exp (- (Waves.fade m1 a1 * (PI / om))))",
    forced_control.path: "D",
    forced_control.r_place: "(x0 + run m2 b (half_time m2 b D) t)",
    forced_control.r_speed: "(bang m2 b (half_time m2 b D) t)",
    forced_control.r_acceleration: "(push m2 b (half_time m2 b D) t)",
}


def ties() -> Iterator[Tie]:
    """All of them."""
    yield from _law()
    yield from _thresholds()
    yield from _square_wave()
    yield from _transfer()


def _law() -> Iterator[Tie]:
    """The equations of motion, with impulses in the places of the friction's sign and of the force."""
    field = forced.forced_system(energy.sigma)
    along = NAMES | {x1: "(x t)", v1: "(v1 t)", v2: "(v2 t)"}
    force = sp.expand(m1 * field[1])
    smooth = term(force.subs({energy.sigma: 0, u: 0}), along)
    friction, push = (term(sp.diff(force, one), NAMES) for one in (energy.sigma, u))
    driven = term(sp.diff(sp.expand(sp.Symbol("m2", positive=True) * field[2]), energy.sigma), NAMES)
    guard = term(filippov.guard(), along)
    yield Tie(
        "tie_forced",
        "A motion under a force obeys the equations of the theory, with impulses of friction and of the force.",
        f"""forall m1 m2 a1 a2 b (U x v1 v2 s : R -> R), forced m1 m2 a1 a2 b U x v1 v2 s <->
  ((forall r t, 0 <= r <= t -> Rabs (s t - s r) <= t - r) /\\
   (forall t, 0 <= t -> 0 < {guard} -> rderiv s t 1) /\\ (forall t, 0 <= t -> {guard} < 0 -> rderiv s t (-1)) /\\
   cont U /\\ cont x /\\ cont v1 /\\
   (forall t, 0 <= t -> rderiv x t {term(field[0], along)}) /\\
   (forall t, 0 <= t -> rderiv (fun t => m1 * v1 t - {friction} * s t - {push} * U t) t {smooth}) /\\
   (forall t, 0 <= t -> m2 * v2 t - {driven} * s t = m2 * v2 0 - {driven} * s 0))""",
        """intros; split.
  - intros [L P N CU CX CV X V W]. split; [auto|]. split; [intros; apply P; lra|]. split; [intros; apply N; lra|].
    split; [auto|]. split; [auto|]. split; [auto|]. split; [auto|]. split; [|auto].
    intros t Ht. eapply rderiv_ext; [|eapply rderiv_eq; [|exact (V t Ht)]]; [intros; cbv beta; ring|ring].
  - intros (L & P & N & CU & CX & CV & X & V & W). constructor; auto.
    + intros; apply P; lra.
    + intros; apply N; lra.
    + intros t Ht. eapply rderiv_ext; [|eapply rderiv_eq; [|exact (V t Ht)]]; [intros; cbv beta; ring|ring].""",
    )


def _thresholds() -> Iterator[Tie]:
    """U*, and the parts of U**."""
    yield Tie(
        "tie_entrained_amplitude",
        "$U_*$, the amplitude up to which the stuck response is a motion.",
        equal("m1 m2 a1 a2 b om", SINE, "Fstar m1 m2 a1 a2 b om", response.entrained_amplitude(), LETTERS),
        """intros; unfold Fstar, Z. match goal with |- _ * sqrt ?x / _ = _ => match goal with |- context [sqrt ?y] =>
    lazymatch y with x => fail | _ => replace y with x by ring end end end. field; lra.""",
    )
    in_phase, out_of_phase = response.non_stop_parts()
    yield Tie(
        "tie_turn",
        "The part in phase of a motion that never stops.",
        equal("m1 m2 a2 b om h'", SINE, "turn m2 b om h'", in_phase, LETTERS),
        "intros; unfold turn; field; lra.",
    )
    yield Tie(
        "tie_leave",
        "The size of the part out of phase with which it leaves by an edge.",
        equal("m1 m2 a1 a2 b om h h'", SINE, "leave m1 m2 a1 a2 b om h h'", -out_of_phase, LETTERS),
        "intros; unfold leave; field; lra.",
    )
    yield Tie(
        "tie_non_stop_amplitude",
        "$U_{**}$, the amplitude that slip without a stop needs, by the response to the square wave.",
        f"forall m1 m2 a1 a2 b om h h' : R, {SINE}Fslip m1 m2 a1 a2 b om h h' = "
        f"sqrt {term(response.non_stop_amplitude_squared(), LETTERS)}",
        "intros; unfold Fslip, Z1, turn, leave; f_equal; field; lra.",
    )
    yield Tie(
        "tie_non_stop_undamped",
        "The same without a damper, in closed form.",
        f"forall m1 m2 a2 b om : R, {SINE}Fslip_undamped m1 m2 a2 b om ^ 2 = "
        f"{term(response.undamped_non_stop_amplitude_squared(), LETTERS)}",
        """intros; unfold Fslip_undamped. assert (W : 0 < sqrt (a2 / m1)) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; lra).
  assert (Q : a2 / m1 = sqrt (a2 / m1) ^ 2) by (rewrite pow2_sqrt; [auto|apply Rlt_le, Rdiv_lt_0_compat; lra]).
  rewrite !Rpow_mult_distr, pow2_abs. rewrite pow2_sqrt by (pose proof (pow2_ge_0 (om / sqrt (a2 / m1) * tan (PI * sqrt (a2 / m1) / (2 * om)) + PI * m1 / (2 * m2))); pose proof (pow2_ge_0 ((m1 + m2) / m2)); lra).
  replace (a2 / m1 - om ^ 2) with (sqrt (a2 / m1) ^ 2 - om ^ 2) by (rewrite <- Q; auto).
  match goal with |- context [tan ?x] => let y := fresh "y" in set (y := tan x) in *;
    repeat match goal with |- context [tan ?z] => replace (tan z) with y by (unfold y; f_equal; field; lra) end; clearbody y end.
  set (w := sqrt (a2 / m1)) in *; clearbody w. field; lra.""",
    )

    damped = LETTERS | {
        response.square_place: "(turn_place m1 a1 a2 om)",
        response.square_speed: "(turn_speed m1 a1 a2 om)",
    }
    yield Tie(
        "tie_non_stop_damped",
        "The same with a damper that lets body 1 swing.",
        f"forall m1 m2 a1 a2 b om : R, {SINE}0 < a1 -> a1 ^ 2 < 4 * m1 * a2 -> Fslip_damped m1 m2 a1 a2 b om = "
        f"sqrt {term(response.non_stop_amplitude_squared(), damped)}",
        "intros. rewrite <- Fslip_swing, swing_0, swing'_0 by lra. apply tie_non_stop_amplitude; lra.",
    )


def _square_wave() -> Iterator[Tie]:
    """Where a square wave of friction turns, with damping."""
    place, speed = response.square_wave()
    swings = f"{SINE}0 <= a1 -> a1 ^ 2 < 4 * (m1 * a2) -> 0 < weight m1 a1 a2 om -> "
    proof = """intros; unfold {0}, weight, cosh, sinh in *.
  assert (O : 0 < ring_frequency m1 a1 a2) by (apply sqrt_lt_R0; unfold Waves.fade;
    replace (a2 / m1 - (a1 / (2 * m1)) ^ 2) with ((4 * (m1 * a2) - a1 ^ 2) * / (4 * m1 ^ 2)) by (field; lra);
    apply Rmult_lt_0_compat; [lra|apply Rinv_0_lt_compat; nra]).
  assert (A : a2 = m1 * (Waves.fade m1 a1 ^ 2 + ring_frequency m1 a1 a2 ^ 2)) by (unfold ring_frequency;
    rewrite pow2_sqrt by (unfold Waves.fade; replace (a2 / m1 - (a1 / (2 * m1)) ^ 2) with ((4 * (m1 * a2) - a1 ^ 2) * / (4 * m1 ^ 2))
      by (field; lra); apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; nra]); field; lra).
  assert (E : 0 < exp (- (Waves.fade m1 a1 * (PI / om)))) by apply exp_pos.
  assert (I : exp (Waves.fade m1 a1 * (PI / om)) = / exp (- (Waves.fade m1 a1 * (PI / om)))) by (rewrite exp_Ropp; field; apply Rgt_not_eq, exp_pos).
  rewrite I in *.
  match goal with W : 0 < _ + cos ?x |- _ => set (c := cos x) in *; set (s := sin x) in *;
    repeat match goal with |- context [cos ?z] => replace (cos z) with c by (unfold c; f_equal; field; lra) end;
    repeat match goal with |- context [sin ?z] => replace (sin z) with s by (unfold s; f_equal; field; lra) end;
    clearbody c s end.
  set (d := exp (- (Waves.fade m1 a1 * (PI / om)))) in *; set (o := ring_frequency m1 a1 a2) in *; set (l := Waves.fade m1 a1) in *.
  clearbody d o l.
  match goal with W : 0 < (/ d + d) / 2 + c |- _ => assert (N : 0 < 1 + 2 * d * c + d ^ 2) by
    (replace (1 + 2 * d * c + d ^ 2) with (2 * d * ((/ d + d) / 2 + c)) by (field; lra); nra) end.
  {1}assert (K : 0 < l ^ 2 + o ^ 2) by (pose proof (pow2_ge_0 l); nra). field. repeat split; try lra;
  match goal with |- ?t <> 0 => first [replace t with (1 + 2 * d * c + d ^ 2) by ring; lra
    | replace t with (m1 * o * (1 + 2 * d * c + d ^ 2)) by ring | replace t with (m1 * o * (l ^ 2 + o ^ 2) * (1 + 2 * d * c + d ^ 2)) by ring] end;
  apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; lra."""
    yield Tie(
        "tie_turn_place",
        "The place of body 1 where the square wave turns.",
        equal("m1 m2 a1 a2 b om", swings, "turn_place m1 a1 a2 om", place, LETTERS),
        proof.replace("{0}", "turn_place").replace("{1}", "rewrite A at 1. "),
    )
    yield Tie(
        "tie_turn_speed",
        "Its velocity there.",
        equal("m1 m2 a1 a2 b om", swings, "turn_speed m1 a1 a2 om", speed, LETTERS),
        proof.replace("{0}", "turn_speed").replace("{1}", ""),
    )


def _transfer() -> Iterator[Tie]:
    """The least time of a transfer, and the force of the stuck one."""
    yield Tie(
        "tie_half_time",
        "Half the least time of a transfer.",
        equal("m2 b D", "0 < m2 -> 0 < b -> 0 < D -> ", "half_time m2 b D", forced_control.least_time() / 2, LETTERS),
        """intros; unfold half_time. rewrite sqrt_div_alt by lra. rewrite sqrt_mult by lra. field.
  apply Rgt_not_eq, sqrt_lt_R0; lra.""",
    )
    yield Tie(
        "tie_stuck_force",
        "The force of the fastest stuck transfer: that of the stuck pair along it.",
        equal(
            "m1 m2 a1 a2 b D t",
            "",
            "stuck_force m1 m2 a1 a2 b D t",
            forced_control.stuck_force(),
            LETTERS | {forced_control.r_place: "(run m2 b (half_time m2 b D) t - run m2 b (half_time m2 b D) 0)"},
        ),
        "intros; unfold stuck_force; ring.",
    )
    yield from _amplitudes()


def _amplitudes() -> Iterator[Tie]:
    """What a transfer asks of the force: the theorems on it, with the amplitudes of the theory in their statements."""
    at_turn, at_rest, late = (term(one, LETTERS) for one in forced_control.stuck_amplitudes())
    yield Tie(
        "tie_stuck_amplitude",
        "The amplitude of the fastest stuck transfer.",
        f"""forall m1 m2 a1 a2 b D F : R, {PAIR}0 <= a1 -> 0 < D ->
  (forall t, 0 <= t -> Rabs (stuck_force m1 m2 a1 a2 b D t) <= F) <->
  {at_turn} <= F /\\ {at_rest} <= F /\\ (0 <= {term(forced_control.late_peak(), LETTERS)} -> {late} <= F)""",
        """intros m1 m2 a1 a2 b D F Hm1 Hm2 Ha2 Hb Ha1 HD.
  rewrite (stuck_amplitude m1 m2 a1 a2 b D Hm1 Hm2 Ha1 Ha2 Hb HD F).
  assert (Z : sqrt (b / m2 * D) = sqrt D * sqrt b * / sqrt m2).
  { rewrite sqrt_mult_alt by (apply Rlt_le, Rdiv_lt_0_compat; lra). rewrite sqrt_div_alt by lra. unfold Rdiv. ring. }
  assert (S : 0 < sqrt m2) by (apply sqrt_lt_R0; lra). rewrite Z. root m2. clear Z.
  split; intros (A & B & C); (split; [|split; [|intros N; specialize (C ltac:(unfold Rdiv in *; lra))]]);
    unfold Rdiv in *; repeat match goal with A : ?x <= F |- ?y <= F => replace y with x by (field; lra); assumption end.""",
    )
    arrival = LETTERS | {
        forced_control.half_time: "(half_time m2 b D)",
        sp.Symbol("g", positive=True): "(g (half_time m2 b D))",
        forced_control.angle: "(sqrt (a2 / m1) * half_time m2 b D)",
    }
    yield Tie(
        "tie_least_amplitude",
        "The least amplitude with which body 2 arrives in the least time, by body 1's impulse response.",
        f"""forall m1 m2 a1 a2 b D F : R, {PAIR}0 <= a1 -> 0 < D -> forall g g' : R -> R,
  (forall t, is_derive g t (g' t)) -> (forall t, is_derive g' t (- (a2 * g t + a1 * g' t) / m1)) ->
  g 0 = 0 -> g' 0 = / m1 -> (forall t, 0 <= t <= half_time m2 b D -> 0 <= g' t) -> 0 < g (half_time m2 b D) ->
  (exists v, arrives m1 m2 a1 a2 b D F v) <-> {term(forced_control.slipping_amplitude(), arrival)} <= F""",
        """intros m1 m2 a1 a2 b D F Hm1 Hm2 Ha2 Hb Ha1 HD g g' Dg Dg' G0 G0' Gp Gt.
  rewrite (least_amplitude m1 m2 a1 a2 b D Hm1 Hm2 Ha1 Ha2 Hb HD g g' Dg Dg' G0 G0' Gp Gt F).
  match goal with |- ?x <= F <-> ?y <= F => replace y with x by (field; lra) end. reflexivity.""",
    )
    yield Tie(
        "tie_least_amplitude_undamped",
        "The same without a damper, by the angle that body 1 turns in half of that time.",
        f"""forall m1 m2 a2 b D F : R, {PAIR}0 < D -> sqrt (a2 / m1) * half_time m2 b D <= PI / 2 ->
  (exists v, arrives m1 m2 0 a2 b D F v) <-> {term(forced_control.undamped_slipping_amplitude(), arrival)} <= F""",
        """intros m1 m2 a2 b D F Hm1 Hm2 Ha2 Hb HD Hth.
  pose proof (least_amplitude_undamped m1 m2 a2 b D F Hm1 Hm2 Ha2 Hb HD) as Q. cbv zeta in Q. rewrite (Q Hth).
  assert (0 < sin (sqrt (a2 / m1) * half_time m2 b D)).
  { apply sin_gt_0; [apply Rmult_lt_0_compat; [apply sqrt_lt_R0, Rdiv_lt_0_compat|apply tau_pos]; auto|
      pose proof PI_RGT_0; lra]. }
  match goal with |- ?x <= F <-> ?y <= F => replace y with x by (field; lra) end. reflexivity.""",
    )
