"""Next to both thresholds: two stops just within them, none just outside, and none without the condition at U**."""

from fractions import Fraction

import pytest

from numerics import Force, Pair, Scene, State, response, thresholds

TWO_STOPS, NO_STOP = [-1, 0, 0, 1], [-1, 1]
NEAR = Fraction(1, 10**5)


def ends(pair, omega):
    """Both thresholds, N, as rational numbers."""
    found = thresholds(pair, omega, digits=12)
    return [Fraction(one.mid().str(12, radius=False)) for one in (found.entrainment, found.non_stop)]


def modes(pair, amplitude, omega):
    """The modes of the periodic motion in a period, sorted; none where the pair sticks permanently."""
    orbit = response(Scene(pair, State(), 1, force=Force.sine(amplitude, omega)), digits=6).orbit
    return sorted(leg.side for leg in orbit.legs) if orbit else []


@pytest.mark.parametrize("damping", ["0", "0.5", "20", "80"])
@pytest.mark.parametrize("omega", ["7", "12"])
def test_two_stops_begin_and_end_at_the_thresholds(damping, omega):
    pair = Pair(1, 1, 200, "0.5", damping)
    first, last = ends(pair, omega)
    found = [modes(pair, end * (1 + side * NEAR), omega) for end in (first, last) for side in (-1, 1)]
    assert found == [[], TWO_STOPS, TWO_STOPS, NO_STOP]


def test_below_the_second_threshold_two_stops_need_the_condition_there():
    """Here the relative velocity changes its sign at U**: there are more turns below and above."""
    pair, omega = Pair("0.172", "0.653", "22.7", "0.28", "0.0988"), "1.82"
    last = ends(pair, omega)[1]
    assert modes(pair, last * (1 - NEAR), omega) != TWO_STOPS
    assert modes(pair, last * (1 + NEAR), omega) != NO_STOP
