"""Drawn scenes on a surface: no sequence of events is wrong, no bound is exceeded, and none says nothing."""

from fractions import Fraction
from random import Random

import draws
import numpy as np
import pytest
from hypothesis import given
from plane_paths import agree
from reaching import LeftOut, reaching
from strategies import extreme_scenes

from numerics import NumericsError, load_scene, solve

MOST_LOOSE = 1e4


def with_truth(scene):
    """A run of a scene, and the same in balls of more digits."""
    try:
        return tuple(solve(scene, digits=digits, max_events=30, max_digits=2000) for digits in (15, 30))
    except NumericsError:
        raise LeftOut from None


def may_be_one(run, truth):
    """Whether two runs have the same modes, and no number of one is off by more than the bounds of both."""
    with truth.context():
        return agree(*((one.events, one._own_moments, one.final_mode) for one in (run, truth)))


@pytest.mark.parametrize("name", ["plane-circle-merges", "plane-box"])
def test_a_run_to_a_time_that_is_off_by_little_is_seen(name):
    scene = load_scene(name)
    run, truth = with_truth(scene)
    assert may_be_one(run, truth)
    assert not may_be_one(with_truth(scene.replace(until=scene.until * (1 + Fraction(1, 10**7))))[0], truth)


@pytest.mark.long
@pytest.mark.parametrize("kind", ["ellipsoid", "box"])
def test_no_sequence_is_wrong_and_no_bound_exceeded(kind):
    @reaching
    @given(extreme_scenes[kind])
    def hold(scene):
        assert may_be_one(*with_truth(scene))

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
    assert looseness(*with_truth(draws.surface(Random(seed)))) < MOST_LOOSE
