"""Extremes: masses from 1e-300 to 1e300, excess energies down to 1e-1000, slips of 1e300 cycles, exact ties.

A typed refusal is an answer; a hang, a Python error or a wrong digit is not.
"""

from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import EXTREME, long_slips, near_critical, scenes

from numerics.errors import EventUndecided, NumericsError, OutOfRange
from numerics.linear.modes import EventKind
from numerics.scene import Law, Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.comparison import distance, require_same_sequence
from numerics.trajectory.status import Status

PAPER = {"m1": 1, "m2": 1, "a2": 200, "b": "0.5"}
PUSHED = State(v1="0.15")


def relative_errors(points, balls):
    """Relative errors of w and of v at every event, float64 or mpmath against balls."""
    for one, two in zip(points.events, balls.events, strict=True):
        for ours, truth in ((one.reduced.w, two.reduced.w), (one.reduced.V2, two.reduced.V2)):
            yield float((distance(ours, truth) / abs(truth)).upper())


@pytest.mark.parametrize("exponent", [-300, -30, -12, 12, 30, 300])
@pytest.mark.parametrize("name", list(PAPER))
def test_one_parameter_far_away(name, exponent):
    scene = Scene(Pair(**(PAPER | {name: f"1e{exponent}"})), PUSHED, until=5)
    balls = solve(scene, digits=50, arithmetic="ball", max_events=12)
    points = solve(scene, arithmetic="mpmath", digits=60, max_events=12)
    require_same_sequence(points, balls)
    with balls.arithmetic.context():
        assert max(relative_errors(points, balls)) < 1e-40
    try:
        floats = solve(scene, max_events=12)
    except OutOfRange:
        assert abs(exponent) == 300
    else:
        require_same_sequence(floats, balls)


@pytest.mark.parametrize("exponent", [3, 10, 50, 150, 300, 1000])
@pytest.mark.parametrize("at_rest", [True, False])
def test_just_above_the_critical_energy(exponent, at_rest):
    tiny = Fraction(1, 10**exponent)
    state = State(x1=Fraction(1, 200) + tiny) if at_rest else State(x1="0.005", v1=tiny, v2=tiny)
    scene = Scene(Pair(**PAPER), state, until=3)
    balls = solve(scene, digits=50, arithmetic="ball")
    assert balls.event_kinds == (EventKind.ENTRY, *(EventKind.EXIT, EventKind.ENTRY) * 9)
    excess = [event.reduced.w for event in balls.events if event.kind is EventKind.EXIT]
    with balls.arithmetic.context():
        assert all(w > 0 and w.rel_accuracy_bits() > 150 for w in excess)
        # nobody would see the decrease of 1e-1000 in one excursion: w^2 is far below the digits of w
        assert all(not later > earlier for earlier, later in pairwise(excess))
    try:
        floats = solve(scene)
    except OutOfRange:
        assert scene.energy_excess < Fraction(1, 10**190)
        return
    require_same_sequence(floats, balls)
    with balls.arithmetic.context():
        assert max(relative_errors(floats, balls)) < 1e-12


@reaching
@given(near_critical())
@example(Scene(Pair(**PAPER), State(x1="0.005", v1="1e-150", v2="1e-150"), until=3))
def test_near_critical_excess_keeps_its_digits_in_float64(scene):
    try:
        floats = solve(scene)
    except OutOfRange:
        assert scene.energy_excess < Fraction(1, 10**180)
        raise LeftOut from None
    balls = solve(scene, digits=20, arithmetic="ball")
    require_same_sequence(floats, balls)
    with balls.arithmetic.context():
        assert max(relative_errors(floats, balls)) < 1e-11


def test_the_excess_is_right_after_many_crossings():
    # w starts at 45 000: carried by subtraction it would keep the rounding of that number
    scene = Scene(Pair(1, 1, 200, "0.005"), PUSHED, until=100)
    balls = solve(scene, digits=20, arithmetic="ball", max_events=220)
    floats = solve(scene, max_events=220)
    require_same_sequence(floats, balls)
    with balls.arithmetic.context():
        assert max(relative_errors(floats, balls)) < 1e-11


@pytest.mark.parametrize("cycles", [9, 11, 30, 200])
@pytest.mark.parametrize("start", [0, "1e-12"])
def test_one_slip_of_very_many_cycles(cycles, start):
    b = Fraction(1, 10 ** (cycles - 2))
    scene = Scene(Pair(1, 1, 200, b), State(x1=start, v2="62.8"), until=Fraction(10) ** (cycles + 1))
    balls = solve(scene, digits=50, arithmetic="ball", max_events=10)
    if cycles <= 30:
        require_same_sequence(solve(scene, arithmetic="mpmath", digits=2 * cycles + 60, max_events=10), balls)
    assert balls.events[0].t > 10 ** (cycles - 1)
    for arithmetic, digits in (("float64", None), ("mpmath", 5)):
        try:
            solve(scene, arithmetic=arithmetic, digits=digits, max_events=10)
        except OutOfRange:
            assert cycles > 11


def test_a_phase_without_digits_is_refused():
    scene = Scene(Pair(1, 1, 200, "1e-28"), State(v2="62.8"), until="1e32")
    with pytest.raises(OutOfRange, match="ball"):
        solve(scene)


@reaching
@given(long_slips(turns=(0, 6)))
def test_long_slips_in_float64(scene):
    floats, balls = solve(scene, max_events=3), solve(scene, digits=15, arithmetic="ball", max_events=3)
    if any(abs(float(event.reduced.X.mid())) > 0.999 for event in balls.events):
        raise LeftOut  # close to a graze or to an edge of S0, where float64 may honestly go another way
    with balls.arithmetic.context():
        first, truth = floats.events[:1], balls.events[:1]
        assert all(abs(one.t - float(two.t.mid())) <= 1e-9 * one.t for one, two in zip(first, truth, strict=True))


@given(scenes(EXTREME, None, (-12, 12)), st.sampled_from(["float64", "ball"]))
def test_nothing_but_typed_errors(scene, arithmetic):
    try:
        trajectory = solve(scene, arithmetic=arithmetic, max_events=20, max_digits=400)
    except NumericsError:
        return
    assert len(trajectory.events) <= 20


@given(scenes((-12, 12), None), st.sampled_from(list(Law)))
def test_both_laws_end_within_the_cap(scene, law):
    scene = Scene(scene.pair, scene.initial, scene.until, law)
    trajectory = solve(scene, digits=10, arithmetic="ball", max_events=10)
    assert trajectory.success == (trajectory.status is not Status.EVENT_LIMIT)


@pytest.mark.parametrize("a1", ["1e-300", "1e-12", "28.2", "20", "40", "1e8", "1e150", "1e300"])
def test_damping_of_every_size(a1):
    scene = Scene(Pair(a1=a1, **PAPER), PUSHED, until=2)
    balls = solve(scene, digits=50, arithmetic="ball")
    points = solve(scene, arithmetic="mpmath", digits=60)
    require_same_sequence(points, balls)
    for arithmetic in ("float64", "double-double"):
        try:
            require_same_sequence(solve(scene, arithmetic=arithmetic), balls)
        except (EventUndecided, OutOfRange):
            assert a1 in ("1e-300", "1e150", "1e300")


@pytest.mark.parametrize("a1", [2, 3, 10])
@pytest.mark.parametrize(("x1", "v1", "v2"), [(-2, -2, -5), (0, 0, 20), (2, 5, -15), (0, -5, 15), (-5, -5, -25)])
def test_slips_without_oscillation_in_every_arithmetic(a1, x1, v1, v2):
    """Their guard has one turn at most; the next one is at infinity, which double-double took for no number."""
    scene = Scene(Pair(1, 1, 1, 1, a1), State(x1=x1, v1=v1, v2=v2), until=50)
    balls = solve(scene, digits=20, arithmetic="ball")
    for arithmetic in ("float64", "double-double", "mpmath"):
        require_same_sequence(solve(scene, arithmetic=arithmetic), balls)


@pytest.mark.parametrize("exponent", [10, 20, 30, 40, 60, 90])
@pytest.mark.parametrize("sign", [-1, 1])
@pytest.mark.parametrize(
    ("masses", "moved", "k", "start"),
    [((8, 7), 8, 2, ("-5.4", "-0.4", "3.4")), ((1, 5), 6, 1, ("5.1", "-1.1", "-1.1"))],
)
def test_next_to_critical_damping_no_event_is_lost(masses, moved, k, start, sign, exponent):
    """Where both rates of decay are one float, float64 lost the turn of the guard, or of the load, and was certain."""
    pair = Pair(*masses, a2=k * k * moved, b=1, a1=2 * k * moved * (1 + sign * Fraction(1, 10**exponent)))
    x1, v1, v2 = start
    scene = Scene(pair, State(x1=x1, v1=v1, v2=v2), until=30)
    balls = solve(scene, digits=20, arithmetic="ball")
    for arithmetic in ("float64", "double-double", "mpmath"):
        points = solve(scene, arithmetic=arithmetic)
        assert points.certain
        require_same_sequence(points, balls)


def test_an_exact_graze_with_irrational_data_is_undecided():
    # Body 1 swings with V1 = 1 about the slip equilibrium; the guard's first minimum is to be 0: no rational g does it,
    # but one within 1e-200 of it cannot be told from it at 100 digits, and is decided at 500.
    scene = grazing_scene(digits=200)
    with pytest.raises(EventUndecided, match="graze") as caught:
        solve(scene, digits=10, arithmetic="ball", max_digits=100)
    assert caught.value.digits >= 40
    assert caught.value.enclosure
    assert solve(scene, digits=10, arithmetic="ball", max_digits=500).events


def grazing_scene(digits: int) -> Scene:
    """X = -r s + ..., d = -1 (y = 0), u = 2: minimum of k at phase - lean + 2 pi j is 0 up to 10^-digits."""
    import mpmath

    with mpmath.workdps(digits + 20):
        # k(theta) = g - sin + 2 (1 - cos) - theta + sin = g + 2 (1 - cos) - theta with d = -1, u = 2
        # k' = 2 sin - 1: minimum at theta = pi/6 + 2 pi; k = 0 there for g = theta - 2 (1 - cos theta)
        theta = mpmath.pi / 6 + 2 * mpmath.pi
        g = theta - 2 * (1 - mpmath.cos(theta))
        guard = Fraction(mpmath.nstr(g, digits))
    # m1 = m2 = 1, a2 = 2, b = 1: L = 1, Omega = 1, q = r = 1/2; V = sqrt(q) u, and s = +1, sigma = -1:
    # x1 = -r = -1/2 gives d = -1; v1 = -sqrt(1/2) 2 is irrational, so masses are chosen with q = 1/4 instead
    pair = Pair(m1=1, m2=3, a2=4, b=3)  # M = 4, L = 1, Omega = 1, q = 1/4, sqrt q = 1/2
    return Scene(pair, State(x1=Fraction(-3, 4), v1=-1, v2=-1 - guard / 2), until=20)


def test_a_damped_motion_that_has_died_away_decides_nothing_by_its_signs():
    # after a long overdamped slip body 1 rests in its equilibrium to 20 000 digits; the load on a stuck pair likewise
    pair = Pair(m1="6.05", m2="5.889", a2=57867, b="6.896", a1=1662)
    run = solve(
        Scene(pair, State(x1="-0.000947", v1="0.0037", v2=-1282), until=3000),
        digits=15,
        arithmetic="ball",
        max_events=4,
    )
    assert run.status is Status.STUCK_FOR_EVER
    assert run.event_kinds[-1] is EventKind.ENTRY
