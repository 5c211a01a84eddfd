"""Sensitivities against differences of solves, and against other arithmetics."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from finite_differences import ball, deviations
from flint import arb
from hypothesis import given, settings
from strategies import near_critical, scenes

from numerics.errors import EventUndecided, NumericsError
from numerics.scene import Law, Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.comparison import as_fraction
from numerics.trajectory.derivatives import WRT
from numerics.trajectory.sensitivity import sensitivities
from numerics.trajectory.variation import Variation

PAPER = Pair(1, 1, 200, "0.5")


LIGHT = Pair("0.1", 1, 200, "0.5")


STUCK = State("0.002", "0.15", 0, "0.15")


FAR = State("0.7", -4, 0, 1)


SMOOTH = {
    "slip": Scene(PAPER, State(v1="0.15"), 5),
    "crossings": Scene(LIGHT, State("0.1", "0.3", 0, -1), 3),
    "crossings from S": Scene(LIGHT, State("0.3", "0.3", 0, "0.3"), 3),
    "far above E_cr": Scene(PAPER, State(1, 3, 0, -2), 8),
    "stick": Scene(PAPER, STUCK, 3),
    "stuck for ever": Scene(PAPER, State("0.002", "0.01", 0, "0.01"), 3),
    "literal law": Scene(PAPER, State("0.05", "0.3", 0, -1), 3, Law.THREE_VALUED_SGN),
    "damped": Scene(Pair(1, 1, 200, "0.5", 1), State(v1="0.35", v2="-0.2"), 3),
    "damped, from S": Scene(Pair(1, 1, 200, "0.5", 1), State("0.05", "0.35", 0, "0.35"), 3),
    "damped, from stick": Scene(Pair(1, 1, 200, "0.5", "0.1"), STUCK, 3),
    "critical stick": Scene(Pair(1, 1, 2, "0.5", 4), FAR, 3),
    "critical slip": Scene(Pair(1, 2, 1, "0.5", 2), FAR, 8),
    "just below critical": Scene(Pair(1, 2, 1, "0.5", "1.99999999"), FAR, 8),
    "just above critical": Scene(Pair(1, 2, 1, "0.5", "2.00000001"), FAR, 8),
    "overdamped": Scene(Pair(1, 2, 1, "0.5", 12), State("3.7", -4, 0, 1), 20),
    "overdamped, long slip": Scene(Pair(1, 2, 1, "0.1", 3), State(1, -4, 0, 30), 900),
    "underdamped, long slip": Scene(Pair(1, 2, 1, "0.1", "0.05"), State(1, -4, 0, 30), 900),
}


NEAR = {
    "from a ray": Scene(PAPER, State("0.005", "5e-5", 0, "5e-5"), 3),
    "from inside": Scene(PAPER, State("0.003", "0.0400000625", 0, "0.0400000625"), 3),
}


@pytest.mark.parametrize("name", SMOOTH)
def test_differences_of_solves(name):
    for found in deviations(SMOOTH[name]):
        assert found.events_compared, found
        assert found.size < 1e-15, found


@pytest.mark.parametrize("name", NEAR)
def test_differences_near_the_critical_orbit(name):
    """At w = 1e-6 the derivatives themselves change on that scale."""
    assert abs(float(NEAR[name].energy_excess)) < 1e-5
    for found in deviations(NEAR[name]):
        assert found.events_compared, found
        assert found.size < 1e-14, found


@given(scenes(periods=(1, 1), exponents=(-1, 1)))
@settings(max_examples=8)
def test_differences_of_random_solves(scene):
    compare(scene)


@given(scenes(damped=True, periods=(1, 1), exponents=(-1, 1)))
@settings(max_examples=8)
def test_differences_of_random_damped_solves(scene):
    compare(scene)


def compare(scene):
    try:
        found = deviations(scene)
    except NumericsError:
        return  # a neighbour, or the scene itself, sits on a tie
    for one in found:
        # neighbours of a tie differ from it by the step and by a power of the step from 4/3 to 2, with large factors
        tie = not one.events_compared or on_the_edge(scene)
        assert one.size < (1e-3 if tie else 1e-12), one


def on_the_edge(scene):
    pair, at = scene.pair, scene.initial
    return at.v1 == at.v2 and abs(pair.a2 * at.x1 + pair.a1 * at.v1) == pair.a2 * pair.half_width


@pytest.mark.parametrize(
    "state",
    [State("0.003", "0.04", 0, "0.04"), State("0.005", 0, 0, 0), State("-0.004", "0.03", 0, "0.03")],
    ids=["turning outwards", "at rest on the edge", "on the other side"],
)
@pytest.mark.parametrize("mass", [1, 2, 3])
def test_the_critical_orbit_is_differentiable(state, mass):
    """Neighbours on one side slip for ever, on the other never: both agree with the stuck pair to first order."""
    pair = Pair(2 - Fraction(mass, 2), Fraction(mass, 2), 200, Fraction(mass, 4))
    scene = Scene(pair, state, 3)
    assert scene.energy_excess == 0
    for found in deviations(scene):
        assert found.size < 1e-7, found


def test_a_start_on_a_ray_and_its_neighbours_on_either_side():
    scene = Scene(PAPER, State("0.005", "0.1", 0, "0.1"), 3)
    for found in deviations(scene):
        assert found.events_compared
        assert found.size < 1e-15, found


def test_a_wrong_derivative_is_found_out(monkeypatch):
    """Without the rows of its numbers a motion moves with its start alone."""
    honest = Variation._system
    monkeypatch.setattr(Variation, "_system", lambda *given: (honest(*given)[0], 0 * honest(*given)[1]))
    assert max(found.size for found in deviations(SMOOTH["critical slip"])) > 1e-3


def test_an_event_needs_how_its_guard_moves(monkeypatch):
    """An exit comes where the load is b: it moves with b, and not with the state alone."""
    honest = Variation.guard

    def forgetful(self, *given):
        by_state, by_numbers, rate = honest(self, *given)
        return by_state, 0 * by_numbers, rate

    monkeypatch.setattr(Variation, "guard", forgetful)
    assert max(found.size for found in deviations(SMOOTH["stick"])) > 1e-3


ALL = SMOOTH | NEAR


def every(found):
    return np.concatenate([array.ravel() for array in (found.t, found.y, found.final, found.energy)])


@pytest.mark.parametrize("name", ALL)
def test_balls_contain_the_derivatives(name):
    low, high = (solve(ALL[name], arithmetic="ball", digits=digits) for digits in (15, 120))
    points = solve(ALL[name], arithmetic="mpmath", digits=80)
    with high.arithmetic.context():
        wide, narrow, middle = (every(sensitivities(one)) for one in (low, high, points))
        for one, two, point in zip(wide, narrow, middle, strict=True):
            assert one.overlaps(two)
            assert abs(two - ball(as_fraction(point))) < arb("1e-50") * (1 + abs(two))
        assert max(one.rad() for one in wide) < arb("1e-15") * max(abs(one) for one in narrow)


@pytest.mark.parametrize("name", ALL)
def test_float64_is_close(name):
    """Where float64 is in doubt solve climbs, up to balls: what may be 0 in those is enclosed, to no digit."""
    trajectory = solve(ALL[name])
    found, balls = sensitivities(trajectory), sensitivities(solve(ALL[name], digits=20, arithmetic="ball"))
    ours, theirs = (every(one).reshape(-1, len(WRT)) for one in (found, balls))
    if trajectory.arithmetic.name == "ball":
        assert all(one.overlaps(two) for one, two in zip(ours.flat, theirs.flat, strict=True))
        return
    ours = np.vectorize(lambda one: float(getattr(one, "mid", lambda: one)()), otypes=[float])(ours)
    true = np.array([[float(one.mid()) for one in row] for row in theirs])
    assert (np.abs(ours - true) <= 4e-16 * np.abs(true).max(axis=0)).all()


@given(near_critical(exponents=(3, 12)))
def test_near_critical_sensitivities_are_enclosed_and_close(scene):
    balls, floats = sensitivities(solve(scene, digits=20, arithmetic="ball")), sensitivities(solve(scene))
    true = np.array([[float(one.mid()) for one in row] for row in balls.t])
    assert (np.abs(floats.t - true) <= 4e-16 * np.abs(true).max(axis=0)).all()


def test_shapes_and_cap():
    trajectory = solve(SMOOTH["slip"], max_events=3)
    found = sensitivities(trajectory)
    assert (found.t.shape, found.y.shape, found.final.shape, found.energy.shape) == ((3, 9), (3, 4, 9), (4, 9), (9,))
    assert found.t.dtype == float
    assert np.abs(found.final - found.y[-1]).max() < 1e-13 * np.abs(found.final).max()
    whole = sensitivities(solve(SMOOTH["slip"]))
    assert (found.t == whole.t[:3]).all()
    none = sensitivities(solve(SMOOTH["stuck for ever"], digits=20, arithmetic="ball"))
    assert (none.t.shape, none.y.shape, none.t.dtype) == ((0, 9), (0, 4, 9), object)


def test_an_event_next_to_the_horizon_is_before_it_or_after_it():
    """In float64 it falls on the horizon; the truth is on one side, and if it is not that of float64, it is said."""
    pair = Pair("0.5", "0.5", 4, "0.5")  # Omega = 2: times are halved exactly
    first = solve(Scene(pair, State(v1="1.5"), 5)).events[0].t
    scene = Scene(pair, State(v1="1.5"), Fraction(*first.as_integer_ratio()))
    trajectory, true = solve(scene), solve(scene, arithmetic="ball")
    if true.modes == trajectory.modes:
        assert sensitivities(trajectory).t.shape == (len(true.events), 9)
    else:
        with pytest.raises(EventUndecided, match="those of the trajectory"):
            sensitivities(trajectory)
