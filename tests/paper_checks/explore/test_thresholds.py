"""The thresholds of a sine that the page tells, against those of `numerics`, which are those of `theory`."""

from itertools import product

import pytest

from numerics import Pair, thresholds

POINTS = [*product((0.125, 1.0, 6.0), (0.02, 0.3, 0.8, 3.0), (0.2, 0.9, 1.7, 8.0)), (1.0, 0.0, 0.7), (3.0, 0.0, 4.1)]
POINTS.append((1 / 3, 0.0, 2.0))  # at resonance: 4/pi
POINTS.append((1.0, 0.0, 0.2))  # at an odd multiple, where a free oscillation flattens the peaks


def test_they_are_those_of_numerics(ask):
    for (ratio, zeta, omega), told in zip(POINTS, ask("thresholds", POINTS=POINTS), strict=True):
        r = round(1 / (1 + ratio), 15)
        found = thresholds(Pair(m1=1 - r, m2=r, a2=1, b=r, a1=2 * zeta), omega)  # L = Omega = M = 1, so that b = r
        stuck = found.exception or found.entrainment
        assert told == pytest.approx([float(stuck) / r, float(found.non_stop) / r], rel=1e-10), (ratio, zeta, omega)
