"""What every trajectory does, over masses, stiffness, friction, damping and states of many magnitudes."""

from fractions import Fraction
from itertools import pairwise

import mpmath
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import MODERATE, horizon, near_critical, pairs, scenes, states

from numerics.errors import OutOfRange
from numerics.linear.modes import EventKind, Mode
from numerics.scene import Law, Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.comparison import distance, require_same_sequence
from numerics.trajectory.status import Status

CAP = 25
LIGHT_DRIVER = Scene(  # its contact after 1e-16 of reduced time was passed over in float64
    Pair(m1="1e-3", m2="4.2e12", a2=1, b=1, a1="409877.8"),
    State(x1="-1.00000000000000024", v2="4.8795e-7"),
    until="1.28e7",
)


def test_a_light_and_overdamped_driver_meets_at_once():
    require_same_sequence(solve(LIGHT_DRIVER), solve(LIGHT_DRIVER, digits=20, arithmetic="ball"))


def solved(scene, **how):
    return solve(scene, max_events=CAP, **how)


def dissipated(run):
    """What each segment takes, J: friction and viscosity."""
    return [segment.losses() for segment in run.segments]


@given(scenes(damped=None))
def test_energy_never_grows_and_the_ledger_closes_in_balls(scene):
    run = solved(scene, digits=15, arithmetic="ball")
    with run.arithmetic.context():
        for segment, (friction, viscous) in zip(run.segments, dissipated(run), strict=True):
            assert not friction < 0
            assert not viscous < 0
            assert (friction.is_zero()) == (segment.mode is Mode.STICK)
        for before, after, segment in zip(run.energy, run.energy[1:], run.segments, strict=False):
            assert not after > before
            if segment.mode is Mode.STICK and scene.pair.a1 == 0:
                assert after.overlaps(before)
        ledger = run.ledger
        assert ledger.residual.contains(0)
        assert ledger.residual.rad() <= ledger.initial * 1e-10
        assert (ledger.initial - ledger.final).overlaps(ledger.friction + ledger.viscous)


@reaching
@given(scenes((-6, 6), None))
@example(LIGHT_DRIVER)
def test_the_ledger_closes_to_rounding_in_float64(scene):
    try:
        run = solved(scene)
    except OutOfRange:  # some slip lasts more half oscillations than are inspected
        raise LeftOut from None
    ledger = run.ledger
    scale = ledger.initial + float(scene.pair.critical_energy)  # far below E_cr positions carry the rounding of L
    assert abs(ledger.residual) <= 1e-9 * scale
    assert ledger.friction >= -1e-12 * scale
    assert ledger.viscous >= -1e-12 * scale


@given(scenes(periods=(5, 40), size=(-1, 1)))
def test_the_dichotomy_of_the_undamped_pair(scene):
    """Merged with w <= 0, or w > 0 and falling at every excursion: never between."""
    run = solved(scene, digits=10, arithmetic="ball")
    with run.arithmetic.context():
        exits = [event for event in run.events if event.kind is EventKind.EXIT]
        assert all(event.reduced.w > 0 for event in exits)
        for one, two in pairwise(exits):
            assert two.reduced.w < one.reduced.w
        if run.status is Status.STUCK_FOR_EVER:
            assert run.modes[-1] is Mode.STICK
            assert not run.final.w > 0
        elif run.modes[-1] is Mode.STICK and run.success:
            assert run.final.w > 0


@given(scenes(damped=None), st.sampled_from(list(Law)))
def test_transitions_are_legal(scene, law):
    run = solved(Scene(scene.pair, scene.initial, scene.until, law), digits=12, arithmetic="ball")
    two_zeta = run.frame.two_zeta
    assert all(one is not two for one, two in zip(run.modes, run.modes[1:], strict=False))
    with run.arithmetic.context():
        for event in run.events:
            state = event.reduced
            load = state.X + two_zeta * state.V1
            assert (state.V1 - state.V2).contains(0)
            if event.kind is EventKind.ENTRY:
                assert event.before.sign != 0
                assert event.after is Mode.STICK
                assert law is Law.THREE_VALUED_SGN or not abs(load) > 1
            elif event.kind is EventKind.EXIT:
                side = -event.after.sign
                assert event.before is Mode.STICK
                assert law is Law.FILIPPOV
                assert (load - side).contains(0)
                assert side * (state.V1 - two_zeta * load) > 0  # out through the edge
                if scene.pair.a1 == 0:
                    assert event.y[0].overlaps(side * run.frame.length)
                    assert side * state.V1 > 0
            else:
                assert event.after.sign == -event.before.sign
                assert not -event.after.sign * load < 1
                assert law is Law.FILIPPOV


@given(scenes(damped=None))
def test_the_sign_of_v1_minus_v2_is_that_of_the_mode(scene):
    run = solved(scene, arithmetic="mpmath", digits=20)
    with run.arithmetic.context():
        for segment in run.segments:
            for part in range(1, 8):
                state = run.frame.reduced(segment.state(segment.length * part / 8))
                relative = state.V1 - state.V2
                if segment.mode is Mode.STICK:
                    assert relative == 0
                    assert abs(state.X + run.frame.two_zeta * state.V1) <= 1 + mpmath.mpf(10) ** -20
                else:
                    assert segment.mode.sign * relative > 0


@given(scenes(damped=None))
def test_every_segment_solves_its_equation(scene):
    """By differences of 4th order in 120 digits: m1 x1'' + a1 x1' + a2 x1 = -b s, m2 x2'' = b s; in stick M."""
    run = solve(scene, arithmetic="mpmath", digits=120, max_events=5)
    pair = scene.pair
    with run.arithmetic.context():
        m1, m2, a1, a2, b = (run.arithmetic.number(one) for one in (pair.m1, pair.m2, pair.a1, pair.a2, pair.b))
        for segment in run.segments:
            sign = segment.mode.sign
            length = segment.length
            rate = 1 + a1 / min(m1, m2) + mpmath.sqrt(a2 / m1)
            step = min(length, 1 / rate) * mpmath.mpf(10) ** -12

            def at(t, segment=segment):
                return segment.state(t)

            middle = length * 2 / 5
            states = [at(middle + k * step) for k in (-2, -1, 1, 2)]
            x1, v1, _, v2 = at(middle)
            derived = [(a - 8 * p + 8 * c - d) / (12 * step) for a, p, c, d in zip(*states, strict=True)]
            mass = m1 if sign else m1 + m2
            force = a2 * abs(x1) + a1 * abs(v1) + b
            tiny = mpmath.mpf(10) ** -30
            assert abs(mass * derived[1] + a1 * v1 + a2 * x1 + b * sign) <= tiny * force
            assert abs(derived[0] - v1) <= tiny * (abs(v1) + force / mass / rate)
            assert abs(derived[2] - v2) <= tiny * (abs(v2) + force / min(m1, m2) / rate)
            expected = b * sign / m2 if sign else derived[1]
            assert abs(derived[3] - expected) <= tiny * (abs(expected) + force / min(m1, m2))


@given(scenes(damped=None))
def test_the_sign_flip_commutes_with_solving_bit_for_bit(scene):
    at = scene.initial
    mirrored = Scene(scene.pair, State(-at.x1, -at.v1, -at.x2, -at.v2), scene.until, scene.law)
    for how in ({}, {"digits": 20}):
        one, two = solved(scene, **how), solved(mirrored, **how)
        swap = {Mode.STICK: Mode.STICK, Mode.SLIP_PLUS: Mode.SLIP_MINUS, Mode.SLIP_MINUS: Mode.SLIP_PLUS}
        assert [swap[mode] for mode in one.modes] == list(two.modes)
        with one.arithmetic.context():
            for a, b in zip(one.y.ravel(), two.y.ravel(), strict=True):
                assert a == -b or (how and a.overlaps(-b))
            for a, b in zip(one.t, two.t, strict=True):
                assert a == b or (how and a.overlaps(b))


@given(scenes(damped=None), *(st.integers(-20, 20) for _ in range(3)))
def test_units_commute_with_solving_bit_for_bit(scene, length, mass, time):
    """Powers of two: in units of 2^length m, 2^mass kg, 4^time s every float64 keeps its mantissa."""
    m, kg, s = Fraction(2) ** length, Fraction(2) ** mass, Fraction(4) ** time
    pair, at = scene.pair, scene.initial
    scaled = Scene(
        Pair(m1=pair.m1 * kg, m2=pair.m2 * kg, a2=pair.a2 * kg / s**2, b=pair.b * kg * m / s**2, a1=pair.a1 * kg / s),
        State(at.x1 * m, at.v1 * m / s, at.x2 * m, at.v2 * m / s),
        until=scene.until * s,
    )
    one, two = solved(scene), solved(scaled)
    assert one.modes == two.modes
    if one.arithmetic.name != "float64":  # solve has climbed next to a tie
        return
    assert [t * float(s) for t in one.t] == list(two.t)
    units = [float(m), float(m / s), float(m), float(m / s)]
    for row, other, unit in zip(one.y, two.y, units, strict=True):
        assert [value * unit for value in row] == list(other)


@given(scenes(MODERATE, None))
def test_the_three_arithmetics_agree(scene):
    balls = solved(scene, digits=20, arithmetic="ball")
    close = [
        abs(float(event.reduced.X.mid()) + float((balls.frame.two_zeta * event.reduced.V1).mid()))
        for event in balls.events
    ]
    assume(
        all(
            abs(load - 1) > 1e-6 or event.kind is EventKind.EXIT
            for load, event in zip(close, balls.events, strict=True)
        )
    )
    points = solved(scene, arithmetic="mpmath", digits=40)
    require_same_sequence(points, balls)
    with balls.arithmetic.context():
        scales = [max(abs(float(one.mid())) for one in row) for row in balls.y]
        for one, two in zip(points.y.T, balls.y.T, strict=True):
            for value, truth, scale in zip(one, two, scales, strict=True):
                assert float(distance(value, truth).upper()) <= 1e-18 * scale


@reaching
@settings(max_examples=settings().max_examples * 4)
@given(scenes(MODERATE, None, size=(-1, 0), periods=(1, 3)))
def test_float64_keeps_its_digits_where_the_scene_is_well_conditioned(scene):
    balls = solve(scene, digits=20, arithmetic="ball", max_events=4)
    if not balls.events or any(float(abs(event.reduced.w).mid()) < 1e-3 for event in balls.events):
        raise LeftOut
    if scene.pair.a1 > 0 and any(abs(edge(balls, event) - 1) < 1e-3 for event in balls.events):
        raise LeftOut
    floats = solve(scene, max_events=4)
    if floats.arithmetic.name == "ball":  # next to another sequence of events
        raise LeftOut
    require_same_sequence(floats, balls)
    with balls.arithmetic.context():
        for event, truth in zip(floats.events, balls.events, strict=True):
            slack = conditioning(balls, truth)
            assert float((distance(event.t, truth.t) / truth.t).upper()) <= 1e-12 * slack


def edge(run, event):
    return abs(float((event.reduced.X + run.frame.two_zeta * event.reduced.V1).mid()))


def conditioning(run, event) -> float:
    """How far an event moves when the guard does: 1 over the rate at which it is crossed, in reduced time."""
    index = run.events.index(event)
    segment = run.segments[index]
    tau = segment.length * run.frame.rate
    h = tau / 10**6
    before = run.frame.reduced(segment.state(segment.length * (1 - run.arithmetic.number(Fraction(1, 10**6)))))
    if event.before is Mode.STICK:
        return 100 / min(1.0, abs(float(event.reduced.V1.mid()) or 1e-9))
    return 100 * max(1.0, float((h / abs(before.V1 - before.V2)).mid()))


@reaching
@given(near_critical((3, 30)))
def test_near_critical_excursions_follow_the_expansion(scene):
    """w' = w - (9 r/(4 q)) w^2 + ...: the relative drop of an excursion over w tends to 9 r/(4 q)."""
    run = solved(scene, digits=40, arithmetic="ball")
    expected = Fraction(9, 4) * scene.pair.m2 / scene.pair.m1
    if expected * scene.energy_excess > Fraction(1, 100):
        raise LeftOut
    with run.arithmetic.context():
        excess = [event.reduced.w for event in run.events if event.kind is EventKind.EXIT]
        for one, two in pairwise(excess):
            w = float(one.mid())
            if w > 1e-18:
                size = float(expected) * (1 + (w * float(1 + 1 / (scene.pair.m1 / scene.pair.mass))) ** 0.5)
                assert float(((one - two) / (one * one)).mid()) == pytest.approx(float(expected), abs=0.6 * size)


@given(pairs(damped=True).flatmap(lambda pair: st.tuples(st.just(pair), states(pair))))
def test_a_damped_pair_ends_in_stick(case):
    pair, state = case
    run = solve(Scene(pair, state, until=horizon(pair, 1)), digits=10, arithmetic="ball", max_events=3)
    assert run.success is (run.status is not Status.EVENT_LIMIT)
    assert (run.status is Status.STUCK_FOR_EVER) <= (run.final_mode is Mode.STICK)
    assert (run.status is Status.EVENT_LIMIT) <= (len(run.events) == 3)
    with run.arithmetic.context():
        assert not run.final.w > run.arithmetic.number(Scene(pair, state, 1).energy_excess)
