"""Drawn scenes of every kind of extreme: no sequence of events is wrong and no bound is exceeded, or says nothing."""

from dataclasses import replace
from fractions import Fraction
from random import Random

import draws
import numpy as np
import pytest
from flint import arb
from hypothesis import given
from plane_paths import overlap
from reaching import LeftOut, reaching
from strategies import extreme_scenes

from numerics import NumericsError, PlaneScene, PlaneTrajectory, Scene, load_scene, solve
from numerics.trajectory.status import Status

CASES = [(kind, way) for kind in extreme_scenes for way in ("float64", "ball")]
CASES.remove(("friction of the state", "float64"))  # which refuses them
MOST_LOOSE = 1e4


def solved(scene, arithmetic, digits=None):
    return solve(scene, arithmetic=arithmetic, digits=digits, max_events=30, max_digits=2000)


def with_truth(scene, arithmetic):
    """A run of a scene, and the same in balls of more digits."""
    try:
        run = solved(scene, arithmetic, 15 if arithmetic == "ball" else None)
        truth = solved(scene, "ball", 30 if isinstance(scene, PlaneScene) else 60)
    except NumericsError:
        raise LeftOut from None
    if run.status is Status.SEQUENCE_OPEN:
        raise LeftOut
    return run, truth


def numbers(run):
    """Times, states and energies of a run, as floats or balls."""
    if isinstance(run, PlaneTrajectory):
        return [*run.t, *run.y.flat]
    ends = [*run.final_state, run.final_energy, run.final.w, run.dissipated]
    return [*run.event_times, *run.event_states.T.flat, *ends]


def bounds(run):
    """Bounds on the errors of these floats."""
    if isinstance(run, PlaneTrajectory):
        return [*run.t_error, *run.y_error.flat]
    known = run.accuracy
    return [*known.t, *known.y.flat, *known.final, known.energy, known.energy_excess, known.dissipated]


def enclosures(run):
    """These numbers as balls, floats with their bounds as radii; on a surface loads and directions too, which are."""
    inner = [(*event.direction, *event.load) for event in run.events if isinstance(run, PlaneTrajectory)]
    found = numbers(run)
    return inner, found if run.arithmetic.name == "ball" else [*map(arb, found, bounds(run))]


def agree(run, truth):
    """Whether two runs have the same modes, and no number of one is off by more than the bounds of both."""
    with truth.context():
        modes = [(*one.modes, one.final_mode) for one in (run, truth)]
        return modes[0] == modes[1] and overlap(enclosures(run), enclosures(truth))


def later(scene, by):
    """The scene with a horizon that is longer by a part."""
    until, parts = scene.until * (1 + by), ("pair", "x1", "v1", "x2", "v2", "force", "friction")
    if isinstance(scene, Scene):
        return replace(scene, until=until)
    return PlaneScene(until=until, **{name: getattr(scene, name) for name in parts})


@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
@pytest.mark.parametrize("name", ["velocities", "forced-ramp", "plane-circle-merges", "plane-box"])
def test_a_run_of_a_scene_that_is_off_by_little_is_seen(name, arithmetic):
    scene = load_scene(name)
    run, truth = with_truth(scene, arithmetic)
    assert agree(run, truth)
    assert not agree(with_truth(later(scene, Fraction(1, 10**7)), arithmetic)[0], truth)


@pytest.mark.long
@pytest.mark.parametrize(("kind", "arithmetic"), CASES)
def test_no_sequence_is_wrong_and_no_bound_exceeded(kind, arithmetic):
    @reaching
    @given(extreme_scenes[kind])
    def hold(scene):
        assert agree(*with_truth(scene, arithmetic))

    hold()


def looseness(run, truth):
    """The largest radius over the largest error, both in N^2 = x1.A2 x1 + v1.M1 v1 + v2.M2 v2, of events and end."""
    pair = run.scene.pair
    a2, m1, m2 = (np.array(given, dtype=float) for given in (pair.a2, pair.m1, pair.m2))

    def norm(states):
        x, v, _, w = states.reshape(4, pair.axes, -1)
        return np.sqrt(np.sum(x * (a2 @ x), 0) + m1 @ v**2 + m2 @ w**2).max()

    with truth.context():
        errors = [float(abs(x.mid() - true).upper()) for x, true in zip(run.y.flat, truth.y.flat, strict=True)]
    return norm(np.array([float(x.rad()) for x in run.y.flat])) / norm(np.array(errors))


@pytest.mark.long
@pytest.mark.parametrize("seed", range(6))
def test_radii_of_an_ellipsoid_are_not_loose(seed):
    """Stiff slips had radii 20,000 times the errors when the defects of all steps were added in N."""
    assert looseness(*with_truth(draws.surface(Random(seed)), "ball")) < MOST_LOOSE
