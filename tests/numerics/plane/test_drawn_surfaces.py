"""Drawn scenes on a surface: no bound says next to nothing."""

from random import Random

import draws
import numpy as np
import pytest

from numerics import solve

MOST_LOOSE = 1e4


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
    scene = draws.surface(Random(seed))
    assert looseness(*(solve(scene, digits=digits, max_events=30, max_digits=2000) for digits in (15, 30))) < MOST_LOOSE
