"""U* and U** against the linear systems that they come from, in another arithmetic; their special frequencies."""

from fractions import Fraction

import numpy as np
import pytest
from control_scenes import referred, under
from flint import arb

from numerics import Pair, response
from numerics.arithmetic.ball import Ball
from numerics.control.thresholds import edges, thresholds


def test_resonances_are_exact():
    assert thresholds(Pair(1, 1, 200, "0.5"), 10).entrainment.is_zero()
    assert thresholds(Pair(1, 1, 100, "0.5"), 10, digits=30).non_stop.overlaps(2 / arb.pi())
    assert not thresholds(Pair(1, 1, 900, "0.5"), 10).non_stop.is_finite()  # friction drives body 1 at 3 omega
    assert thresholds(Pair(1, 1, 1800, "0.5", "0.001"), 10).exception is None
    near_one = thresholds(Pair(1, 1, 100, "0.5"), "10.00000000000000000001", digits=15).non_stop
    assert abs(near_one - Ball.number(Fraction(636619772367581343, 10**18))) < 1e-15


@pytest.mark.parametrize("odd", [3, 5, 7])
def test_a_free_oscillation_lets_the_pair_stick_up_to_a_larger_amplitude(odd):
    """Omega = n omega: from the start that flattens its peaks the reference sticks up to U*/cos(pi/(2 n))."""
    pair, omega = Pair(1, 1, 2 * (10 * odd) ** 2, "0.5"), 10
    known = thresholds(pair, omega)
    assert (known.exception * (arb.pi() / (2 * odd)).cos()).overlaps(known.entrainment)
    for factor, sticks in (("0.999999", True), ("1.000001", False)):
        amplitude = Fraction(float(known.exception)) * Fraction(factor)
        # x'' = -omega^2 A (sin + c sin(n omega t)) with c = +-sin(pi/(2 n))/n, whose peaks are the lowest
        A = float(amplitude) / (float(pair.a2) - 2 * omega**2)
        c = -((-1) ** ((odd - 1) // 2)) * np.sin(np.pi / (2 * odd)) / odd
        speed = Fraction(float(A * omega * (1 + c / odd)))
        scene = under(pair, amplitude, omega).replace(v1=speed, v2=speed, until=3)
        assert (not referred(scene, digits=40).events) == sticks


@pytest.mark.parametrize("omega", ["1e-6", "1e-29", "1e-30", "1e-60"])
def test_a_very_slow_sine_has_finite_thresholds(omega):
    """Body 1 rests at -b/a2 by each reversal: omega^2 U** tends to a2 b hypot(pi/(2 m2), (M + m2)/(m1 m2))."""
    slow = Pair(m1=1, m2=1, a2=200, b="0.05", a1=1)
    found = thresholds(slow, omega)
    # h = -1/a2, h' = 0
    limit = 10 * (arb.pi() ** 2 / 4 + 9).sqrt()
    assert abs(found.non_stop * Ball.number(Fraction(omega) ** 2) / limit - 1) < 1e-6
    assert found.non_stop.rad() < abs(found.non_stop) * 1e-15


# the edge of the non-stop regime


@pytest.mark.parametrize(("omega", "edge"), [("4.624", 28.5085), ("20", None)])
def test_the_edge_of_the_non_stop_regime_lies_where_the_sign_is_kept(omega, edge):
    """U** is not enough at 4.624 rad/s; above body 1's own frequency, without a damper, it is."""
    pair, omega = Pair(1, 1, 200, "0.5"), Fraction(omega)
    with Ball(20).context():
        _, needed, found = (float(one) for one in edges(pair, omega))
    assert found == pytest.approx(edge or needed, rel=1e-4)
    for factor, never_stops in ((0.998, False), (1.002, True)):
        run = response(under(pair, Fraction(found * factor), omega), digits=8)
        assert ([leg.side for leg in run.orbit.legs] == [1, -1]) is never_stops
