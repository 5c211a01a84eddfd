"""Periodic motions: their enclosures against the independent reference, their multipliers against differences of it."""

from fractions import Fraction

import numpy as np
import pytest
from control_scenes import DAMPED, FREE, one_period, referred, under
from flint import arb
from hypothesis import example, given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, sine_scenes

from numerics import EventUndecided, Force, Friction, InvalidScene, Pair, Piece, Scene, Sine, State
from numerics.arithmetic.ball import Ball
from numerics.control.orbit import Orbit
from numerics.control.response import Regime, response, steady_drive
from numerics.control.stuck import stuck_state


def returned(orbit: Orbit, moved: tuple[Fraction, Fraction, Fraction] = (Fraction(0),) * 3) -> np.ndarray:
    """(x1, v1, v2) after a period less before, by the reference."""
    scene = one_period(orbit, moved)
    x1, v1, _, v2 = referred(scene).state()
    start = scene.initial
    with Ball(40).context():
        ends = zip((x1, v1, v2), (start.x1, start.v1, start.v2), strict=True)
        return np.array([float(end - Ball.number(at)) for end, at in ends])


@reaching
@given(sine_scenes())
@settings(max_examples=12)
def test_a_periodic_motion_comes_back_by_the_reference(case):
    scene, regime = case
    found = response(scene, digits=20)
    assert found.regime is regime
    if found.orbit is None:
        raise LeftOut
    assert all(abs(one) < 1 for one in found.multipliers)
    period, legs = one_period(found.orbit), found.orbit.legs
    run = referred(period)
    assert [event.after for event in run.events] == [leg.side for leg in (*legs[1:], legs[0])]
    with Ball(40).context():
        size = abs(legs[0].x) + abs(legs[0].v)
        for end, at in zip(run.state()[:2], (period.initial.x1, period.initial.v1), strict=True):
            assert abs(end - Ball.number(at)) < size * arb(10) ** -18


@given(decimals(-2, 1), decimals(-2, 1), decimals(-1, 2), decimals(-6, -2), st.sampled_from([0, "1e-5", "-0.5"]))
@settings(max_examples=5)
@example(Fraction(1), Fraction(1), Fraction(10), Fraction(1, 20_000_000), 0)
def test_a_weak_force_at_resonance_keeps_the_pair_next_to_its_critical_orbit(m1, m2, omega, share, apart):
    """U = share b; the sine is at the resonance of the stuck pair, or so far from it that friction holds no more."""
    off = 1 + Fraction(apart) * share * m2 / (2 * (m1 + m2))
    pair = Pair(m1, m2, (m1 + m2) * (omega / off) ** 2, 1)
    found = response(under(pair, share, omega), digits=12)
    assert found.regime is Regime.STICK_SLIP
    period, legs = one_period(found.orbit), found.orbit.legs
    with Ball(40).context():
        for end, at in zip(referred(period).state()[:2], (period.initial.x1, period.initial.v1), strict=True):
            assert abs(end - Ball.number(at)) < (abs(legs[0].x) + abs(legs[0].v)) * arb(10) ** -11


def test_a_stick_that_would_break_at_the_other_edge_is_no_stick():
    """Two stops a period solve all equations of events, but in the stick between them the load passes -b."""
    orbit = response(under(Pair(1, 1, 200, "0.5", "0.5"), "5.7754", 4)).orbit
    run = referred(one_period(orbit))
    assert [event.after for event in run.events] == [leg.side for leg in (*orbit.legs[1:], orbit.legs[0])]
    assert len(orbit.legs) == 8


def test_a_load_above_the_limit_for_a_ten_thousandth_of_a_period_is_seen():
    """It is above b by 10^-7 of it, and less than b on a grid of 4096 times: the pair is not entrained."""
    first = Force.sine("0.296901884674", 12, "-0.001293024")
    scene = Scene(DAMPED, State(), 1, force=first + Force.sine("0.148450942337", 24, "0.997413953"))
    drive = steady_drive(scene)
    with Ball(20).context():
        x1, v1, v2 = stuck_state(drive, arb(0))
        motion = drive.motion(0, (x1, v1, arb(0), v2), arb(0))
        loads = [abs(motion.range(motion.mode.load, drive.period * k / 4096)) for k in range(4096)]
        assert all(one < arb("0.5") for one in loads)
    try:
        regime = response(scene).regime
    except EventUndecided:
        return
    assert regime is not Regime.ENTRAINED


@pytest.mark.parametrize(("pair", "amplitude"), [(DAMPED, "0.5"), (DAMPED, "1.5"), (FREE, "0.4"), (FREE, "0.6")])
def test_multipliers_are_those_of_the_reference(pair, amplitude):
    """Central differences of the period map; only those tangent to stick if the motion starts in a stick phase."""
    found = response(under(pair, amplitude))
    step = Fraction(1, 10**8)
    columns = []
    for place in range(3):
        sides = [returned(found.orbit, tuple(s * step * (k == place) for k in range(3))) for s in (1, -1)]
        columns.append((sides[0] - sides[1]) / (2 * float(step)) + np.eye(3)[place])
    expected = sorted(abs(np.linalg.eigvals(np.array(columns).T)))
    assert sorted(float(abs(one).mid()) for one in found.multipliers) == pytest.approx(expected, abs=2e-6)


def test_the_last_piece_and_the_last_friction_decide():
    late = Force((Piece(0, ["7", "1"]), Piece(2, (), [Sine("0.5", 12)])))
    scene = Scene(Pair(1, 1, 200, 9, 3), State(), 5, force=late, friction=Friction([(1, "0.5")]))
    assert steady_drive(scene).pair.b == Fraction(1, 2)
    assert response(scene).orbit.legs[0].x.overlaps(response(under(DAMPED, "0.5")).orbit.legs[0].x)


def test_on_the_threshold_the_load_touches_and_has_no_multipliers():
    found = response(under(Pair(1, 1, 200, "0.5"), "0.5", 20))
    assert found.regime is Regime.ENTRAINED
    assert "free oscillation" in found.attraction
    at_edge = response(under(Pair(1, 1, 200, "0.5"), "0.75", 20))  # beside it no other motion sticks for ever
    assert (at_edge.multipliers, at_edge.attraction) == (None, "what tends to it is open; its load touches the limit")
    damped = Pair(1, 1, 68, "0.5", 5)  # at omega = 4: Z = |36 + 20 i|; with a1 = 12 it is |36 + 48 i| = 60
    exact = Pair(1, 1, 68, "0.5", 12)
    assert response(under(damped, "0.5", 4)).multipliers is not None
    assert response(under(exact, "1.875", 4)).multipliers is None
    assert response(under(exact, "1.8750000000001", 4)).regime is Regime.STICK_SLIP


@pytest.mark.parametrize("amplitude", ["0.22", "0.24"])
def test_a_force_and_its_opposite_have_the_same_regime(amplitude):
    """Their loads have other largest than smallest values: both edges count."""
    force = Force.sine(amplitude, 12, "1.5708") + Force.sine("0.3", 24, "1.2")
    assert len({response(Scene(DAMPED, State(), 1, force=one)).regime for one in (force, -force)}) == 1


@pytest.mark.parametrize(
    ("scene", "more", "said"),
    [
        (Scene(DAMPED, State(), 1, force=Force.step(0, 1)), {}, "periodic"),
        (Scene(DAMPED, State(), 1, force=Force.ramp(0, 1, 1)), {}, "periodic"),
        (under(DAMPED, 1, law="three-valued-sgn"), {}, "law"),
        (Scene(DAMPED, State(), 1, force=Force.sine(1, 3) + Force.sine(1, 5)), {"amplitude": 1}, "one sine"),
        (under(DAMPED, 1), {"amplitude": 0}, "amplitude"),
        (Scene(DAMPED, State(), 1), {"amplitude": 1}, "the scene has no force"),
        (Scene(DAMPED, State(), 1), {"omega": "inf"}, "^omega"),
    ],
)
def test_what_has_no_periodic_response_is_refused(scene, more, said):
    with pytest.raises(InvalidScene, match=said):
        response(scene, **more)


def test_a_scene_without_a_force_takes_the_sine_that_is_given():
    one, two = response(Scene(DAMPED, State(), 1), amplitude="0.2", omega=12), response(under(DAMPED, "0.2"))
    assert (one.drive, one.regime) == (two.drive, two.regime)


@given(decimals(-1, 1, 2), st.integers(0, 20))
@settings(max_examples=10)
def test_the_stuck_response_is_a_motion_of_the_stuck_pair(a1, tenths):
    """What it is at one time flows into what it is at a later one; the multipliers are those of the flow."""
    pair = Pair(1, 2, 200, 50, a1)
    scene = Scene(pair, State(), 1, force=Force.sine("0.3", 4, 1) + Force.sine("0.2", 6, "-0.7"))
    drive = steady_drive(scene)
    with Ball(20).context():
        t = drive.period * tenths / 10
        begun, there = stuck_state(drive, arb(0)), stuck_state(drive, t)
        x1, v1, v2 = begun
        flowed = drive.motion(0, (x1, v1, arb(0), v2), arb(0)).state(t)
        for place in (0, 1):
            assert (flowed[place] - there[place]).contains(0)
        first, second, _ = response(scene).multipliers
        left = (-Ball.number(pair.a1 / pair.mass) * drive.period).exp()
        assert (first * second - left).contains(0)


def test_a_drift_of_exactly_zero_is_said_only_where_no_other_motion_can_be():
    """Without a damper and without a stop nothing proves that the motion is the only one, odd as the force is."""
    damped, free = (response(under(pair, "2")) for pair in (DAMPED, FREE))
    assert damped.regime is free.regime is Regime.NON_STOP
    assert damped.drift.is_zero()
    assert free.drift.contains(0)
    assert not free.drift.is_zero()
    skewed = Scene(DAMPED, State(), 1, force=Force.sine("0.6", 12) + Force.sine("0.6", 24))
    assert not response(skewed, digits=8).drift.contains(0)


def test_resonance_of_body_1_grows_above_4b_over_pi():
    pair = Pair(1, 1, 100, "0.5")
    grows = response(under(pair, "0.7", 10))
    assert grows.regime is Regime.GROWS
    assert abs(grows.growth - (Ball.number(Fraction(7, 10)) - 2 / arb.pi()) / 2) < 1e-15
    assert response(under(pair, "0.6", 10)).regime is Regime.STICK_SLIP
