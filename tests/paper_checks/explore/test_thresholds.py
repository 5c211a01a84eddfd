"""The thresholds of a sine that the page tells, against those of `numerics`, which are those of `theory`."""

from itertools import product

import pytest

from numerics import Pair, thresholds

POINTS = [*product((0.125, 1.0, 6.0), (0.02, 0.3, 0.8, 3.0), (0.2, 0.9, 1.7, 8.0)), (1.0, 0.0, 0.7), (3.0, 0.0, 4.1)]
POINTS.append((1 / 3, 0.0, 2.0))  # at resonance: 4/pi
HARMONIC = (1.0, 0.0, 0.2)


@pytest.fixture(scope="module")
def told(ask) -> list[list[float]]:
    return ask("thresholds", POINTS=[*POINTS, HARMONIC])


def right(ratio: float, zeta: float, omega: float) -> list[float | None]:
    """The thresholds of the pair with L = Omega = M = 1, so that b = r, over b."""
    r = round(1 / (1 + ratio), 15)
    found = thresholds(Pair(m1=1 - r, m2=r, a2=1, b=r, a1=2 * zeta), omega)
    return [one and float(one) / r for one in (found.entrainment, found.non_stop, found.exception)]


def test_they_are_those_of_numerics(told):
    for point, found in zip(POINTS, told, strict=False):
        assert found == pytest.approx(right(*point)[:2], rel=1e-10), point


def test_a_free_oscillation_flattens_the_peaks_at_an_odd_multiple(told):
    assert told[-1][0] == pytest.approx(right(*HARMONIC)[2], rel=1e-12)
