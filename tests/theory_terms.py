"""What `theory/` derives, in Gallina: the expressions that the statements of the ties (`*Ties.v`) have to contain."""

from collections.abc import Iterator

import sympy as sp
from gallina import term

from theory import energy, excursion, filippov, forced, forced_control, merging, near_critical, return_map, scaling
from theory import forced_response as response
from theory.closed_forms import DampingRegime, rate, rates, solution
from theory.model import driven_equation, driving_equation, free_system
from theory.symbols import (
    E0,
    a1,
    a2,
    acceleration1,
    acceleration2,
    b,
    epsilon,
    m1,
    m2,
    q,
    t,
    theta,
    u,
    v1,
    v1_0,
    v2,
    v2_0,
    x1,
    x1_0,
)

Terms = tuple[str, ...]
LETTERS = {one: one.name for one in (m1, m2, a1, a2, b, t)} | {
    x1: "x",
    v1: "v1",
    v2: "v2",
    E0: "e",
    theta: "u",
    excursion.angle: "p",
    energy.sigma: "sg",
    return_map.gap: "d",
    return_map.push: "u",
}
ALONG = LETTERS | {x1: "(x t)", v1: "(v1 t)", v2: "(v2 t)", acceleration1: "a", acceleration2: "a'"}
STICK = LETTERS | {rate: "(omega m1 m2 a2)", x1_0: "x0", v1_0: "v0"}
FORCED = LETTERS | {
    response.omega: "om",
    response.square_place: "h",
    response.square_speed: "h'",
    response.natural: "(sqrt (a2 / m1))",
    response.decline: "(Waves.fade m1 a1)",
    response.swing: "(ring_frequency m1 a1 a2)",
    response.decayed: "(exp (- (Waves.fade m1 a1 * (PI / om))))",
    forced_control.path: "D",
    forced_control.r_place: "(run m2 b (half_time m2 b D) t - run m2 b (half_time m2 b D) 0)",
    forced_control.r_speed: "(bang m2 b (half_time m2 b D) t)",
    forced_control.r_acceleration: "(push m2 b (half_time m2 b D) t)",
    forced_control.half_time: "(half_time m2 b D)",
    forced_control.angle: "(sqrt (a2 / m1) * half_time m2 b D)",
    sp.Symbol("g", positive=True): "(g (half_time m2 b D))",
}
DAMPED = FORCED | {
    response.square_place: "(turn_place m1 a1 a2 om)",
    response.square_speed: "(turn_speed m1 a1 a2 om)",
}


def terms() -> dict[str, Terms]:
    """The expressions of each tie, in the order of its statement."""
    return dict([*_pair(), *_slips(), *_excursions(), *_forced(), *_thresholds(), *_transfers()])


def _pair() -> Iterator[tuple[str, Terms]]:
    smooth, friction = _forces(free_system(energy.sigma))
    guard = term(filippov.guard(), ALONG)
    pieces = (f"{force} * s t) t {part}" for force, part in zip(friction[:2], smooth[:2], strict=True))
    last = f"{friction[2]} * s t = m2 * v2 0 - {friction[2]} * s 0 + {smooth[2]} * t"
    yield "tie_solution", (f"0 < {guard}", f"{guard} < 0", *pieces, last)
    signs = (term(one.subs(u, 0), ALONG) for one in (driving_equation(), driven_equation()))
    yield "tie_switching", tuple(f"{one} = 0" for one in signs)
    stick = solution("stick", DampingRegime.UNDAMPED)
    yield from _equal(
        LETTERS,
        tie_energy=energy.energy(),
        tie_dwell_time=energy.dwell_time_bound(),
        tie_half_width=filippov.half_width(),
        tie_critical_energy=energy.critical_energy(),
        tie_stick_frequency=scaling.stick_frequency(),
        tie_slip_frequency=rates("slip-", DampingRegime.UNDAMPED)[rate],
        tie_rate_above=filippov.transversality(1),
        tie_rate_below=filippov.transversality(-1),
    )
    yield "tie_captive", (f"e <= {term(energy.captive_energy(), LETTERS)}",)
    yield from _equal(STICK, tie_stick_place=stick.x1, tie_stick_speed=stick.v1)


def _forces(field: sp.Matrix) -> tuple[list[str], list[str]]:
    """The forces without friction, and the factors of friction's direction."""
    forces = [sp.expand(mass * entry) for mass, entry in zip((1, m1, m2), field, strict=True)]
    smooth = [term(force.subs({energy.sigma: 0, u: 0}), ALONG) for force in forces]
    return smooth, [term(sp.diff(force, energy.sigma), LETTERS) for force in forces]


def _equal(letters: dict[sp.Symbol, str], **derived: sp.Expr) -> Iterator[tuple[str, Terms]]:
    for name, expression in derived.items():
        yield name, (f"= {term(expression, letters)}.",)


def _slips() -> Iterator[tuple[str, Terms]]:
    unit = scaling.half_width() * scaling.stick_frequency() * sp.sqrt(m1 / (m1 + m2))
    yield from _equal(LETTERS, tie_ray=unit * return_map.push)
    slip = solution("slip-", DampingRegime.UNDAMPED)
    for start, gap in (("slip", "0"), ("gap", "d")):
        place, speed = f"(L m1 m2 a2 b * (1 + m1 / (m1 + m2) * {gap}))", "(ray m1 m2 a2 b u)"
        letters = LETTERS | {rate: "(o1 m1 a2)", x1_0: place, v1_0: speed, v2_0: speed}
        for name, expression in (("place", slip.x1), ("speed", slip.v1), ("driven", slip.v2)):
            yield from _equal(letters, **{f"tie_{start}_{name}": expression})


def _excursions() -> Iterator[tuple[str, Terms]]:
    half, share = {theta: 2 * excursion.angle}, m1 / (m1 + m2)
    contact = return_map.contact_condition().subs(return_map.push, 0).subs(half)
    after = return_map.return_map_of_angle()[1].subs(half).subs(q, share)
    change = (return_map.landing().excess_change / q).subs(half)
    level = merging.over_q(return_map.gap, contact).subs(merging.share, 1 - q) + change
    law = near_critical.rate_constant() / energy.critical_energy()
    yield from _equal(
        LETTERS,
        tie_h=excursion.h(),
        tie_half_angle_h=excursion.h().subs(half),
        tie_depth=return_map.depth().subs(half),
        tie_push=contact,
        tie_level=level.subs(q, share),
        tie_slip_time=excursion.duration_in_si().subs(half),
        tie_rate=sp.powsimp(sp.expand(law)),
        tie_turning_function=sp.expand(merging.turning_function()),
        tie_ratio=merging.ratio(),
        tie_critical_mass_ratio=merging.critical_mass_ratio(),
    )
    yield "tie_return_map", (f"= half (sqrt {term(after, LETTERS)}).",)
    # the stick from (X, V) on S to the ray at the speed eps: X = rho cos(B), V = - rho sin(B) and -1 = rho cos(A)
    letters = LETTERS | {x1_0: "z", v1_0: "v", epsilon: "e"}
    yield "tie_stick_rotation", tuple(f"= {term(one, letters)}" for one in near_critical.stick_rotation())


def _forced() -> Iterator[tuple[str, Terms]]:
    field = forced.forced_system(energy.sigma)
    smooth, friction = _forces(field)
    push = term(sp.diff(sp.expand(m1 * field[1]), u), LETTERS)
    guard = term(filippov.guard(), ALONG)
    last = f"{friction[2]} * s t = m2 * v2 0 - {friction[2]} * s 0"
    first = f"rderiv x t {smooth[0]}"
    yield "tie_forced", (f"0 < {guard}", first, f"{friction[1]} * s t - {push} * U t) t {smooth[1]}", last)


def _thresholds() -> Iterator[tuple[str, Terms]]:
    in_phase, out_of_phase = response.non_stop_parts()
    squared = response.non_stop_amplitude_squared()
    place, speed = response.square_wave()
    yield from _equal(
        FORCED,
        tie_entrained_amplitude=response.entrained_amplitude(),
        tie_turn=in_phase,
        tie_leave=-out_of_phase,
        tie_non_stop_undamped=response.undamped_non_stop_amplitude_squared(),
        tie_turn_place=place,
        tie_turn_speed=speed,
    )
    yield "tie_non_stop_amplitude", (f"= sqrt {term(squared, FORCED)}.",)
    yield "tie_non_stop_damped", (f"= sqrt {term(squared, DAMPED)}.",)


def _transfers() -> Iterator[tuple[str, Terms]]:
    yield from _equal(
        FORCED, tie_half_time=forced_control.least_time() / 2, tie_stuck_force=forced_control.stuck_force()
    )
    at_turn, at_rest, late = (term(one, FORCED) for one in forced_control.stuck_amplitudes())
    peak = term(forced_control.late_peak(), FORCED)
    yield "tie_stuck_amplitude", (f"{at_turn} <= F", f"{at_rest} <= F", f"0 <= {peak} -> {late} <= F")
    yield "tie_least_amplitude", (f"{term(forced_control.slipping_amplitude(), FORCED)} <= F.",)
    yield "tie_least_amplitude_undamped", (f"{term(forced_control.undamped_slipping_amplitude(), FORCED)} <= F.",)
