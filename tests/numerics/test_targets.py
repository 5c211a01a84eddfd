"""Hypothesis aims: at the largest error in ulp, the smallest excess, the nearest miss of the edge of S0."""

import math
from fractions import Fraction

import pytest
from flint import arb
from hypothesis import given, settings, target
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, pairs, scaled_speed, scenes

from numerics.arithmetic import elementary
from numerics.arithmetic.ball import Ball
from numerics.errors import OutOfRange
from numerics.free.contact import contact
from numerics.linear.modes import EventKind, Mode
from numerics.scene import Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.comparison import distance, require_same_sequence

BALLS, TRUTH = Ball(90), Ball(400)
"""The second keeps its digits where the definitions cancel."""
ULP = 4
"""Every stable formula is right to so many units in the last place."""
FORMULAS = {
    "versine": (elementary.versine, lambda x: 1 - x.cos()),
    "sine_deficit": (elementary.sine_deficit, lambda x: x - x.sin()),
    "cosine_deficit": (elementary.cosine_deficit, lambda x: x * x / 2 - 1 + x.cos()),
    "lag": (lambda x: elementary.lag(x / 2), lambda x: (x / 2).sin() - x / 2 * (x / 2).cos()),
    "rise": (elementary.rise, lambda x: (x - x.sin()) / (1 - x.cos())),
    "depth": (elementary.depth, lambda x: 2 - x * (x / 2).cot()),
}
more = settings(max_examples=10 * settings().max_examples)


def ulps(value: float, truth: arb) -> float:
    """|value - truth| in units of the last place of the truth."""
    return float(distance(value, truth).mid()) / math.ulp(abs(float(truth.mid())))


def angles(lowest: int) -> st.SearchStrategy[float]:
    """Angles in (0, 2 pi), their exponent drawn first; `lowest` leaves their powers normal numbers."""
    exponents = st.integers(lowest, 1)
    return st.builds(lambda m, e: min(m * 2.0**e, 6.28), st.floats(1, 3.14), exponents)


@pytest.mark.parametrize("name", FORMULAS)
def test_the_largest_error_of_each_formula(name):
    @more
    @given(angles(-250 if name == "cosine_deficit" else -330))
    def error_is_small(theta):
        computed, definition = FORMULAS[name]
        with TRUTH.context():
            error = ulps(computed(theta), definition(arb(theta)))
        target(error, label="ulp")
        assert error <= ULP

    error_is_small()


@more
@given(st.floats(1, 10), st.integers(-300, 3), st.floats(0, 10), st.integers(-300, 3))
def test_the_largest_error_of_a_contact(push, of_push, gap, of_gap):
    """Angle and depth of a slip from the surface; the root adds its own rounding to that of the formulas."""
    push, gap = push * 2.0**of_push, gap * 2.0**of_gap
    with BALLS.context():
        (theta, depth, _), (true_theta, true_depth, _) = contact(gap, push), contact(arb(gap), arb(push))
        error = max(ulps(theta, true_theta), ulps(depth, true_depth))
    target(error, label="ulp")
    assert error <= 4 * ULP


@st.composite
def almost_critical(draw) -> Scene:
    """On the edge and moving out, or just beyond the edge at rest, with w down to 1e-190."""
    pair, side = draw(pairs()), draw(st.sampled_from([-1, 1]))
    tiny = draw(decimals(-95, -2))
    if draw(st.booleans()):
        state = State(side * pair.half_width * (1 + tiny * tiny), x2=1)
    else:
        v = side * scaled_speed(pair, tiny)
        state = State(side * pair.half_width, v, 0, v)
    period = 7 / (scaled_speed(pair, Fraction(1)) / pair.half_width)
    return Scene(pair, state, until=period)


@reaching
@more
@given(almost_critical())
def test_the_smallest_excess_keeps_its_digits(scene):
    balls = solve(scene, digits=20, arithmetic="ball", max_events=6)
    try:
        floats = solve(scene, arithmetic="float64", max_events=6)
    except OutOfRange:
        assert scene.energy_excess < Fraction(1, 10**180)
        raise LeftOut from None
    require_same_sequence(floats, balls)
    exits = [event.reduced.w for event in balls.events if event.kind is EventKind.EXIT] or [balls.final.w]
    with balls.arithmetic.context():
        smallest = min(float(abs(w).log().mid()) for w in exits)
        errors = [
            float((distance(one.reduced.w, two.reduced.w) / abs(two.reduced.w)).upper())
            for one, two in zip(floats.events, balls.events, strict=True)
        ]
    target(-smallest, label="-log w")
    assert max(errors, default=0) <= 1e-11


@more
@given(scenes(damped=None, size=(-1, 0), periods=(1, 2)))
def test_the_nearest_miss_of_the_edge_is_decided(scene):
    """A slip that lands next to |P| = 1 sticks or crosses: balls decide it, and ten times the digits say the same."""
    run = solve(scene, digits=12, arithmetic="ball", max_events=4)
    better = solve(scene, digits=120, arithmetic="ball", max_events=4)
    assert run.modes == better.modes
    misses = [1.0]
    with better.arithmetic.context():
        for event in better.events:
            if event.kind is EventKind.EXIT:
                continue
            load = abs(event.reduced.X + better.frame.two_zeta * event.reduced.V1)
            assert (load < 1) == (event.after is Mode.STICK)
            misses.append(float(abs(load - 1).mid()))
    target(-math.log(min(misses) + 1e-300), label="-log of the distance from the edge")
