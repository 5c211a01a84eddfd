"""Transfers from rest to rest: planned forces against the independent reference, bounds by what no control can do."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import mpmath
import pytest
from control_scenes import DAMPED, FREE, referred
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import decimals

from numerics.arithmetic.ball import Ball
from numerics.control import transfer as transfers
from numerics.control.transfer import Road, fastest_transfer
from numerics.errors import InvalidScene
from numerics.scene import Force, Pair, Piece, Scene, State


def at_rest(pair: Pair) -> Scene:
    return Scene(pair, State(x2="0.25"), 1)


def arrived(found):
    """x2 less its goal, v1 and v2 at the end, whether it stuck, by the independent reference."""
    # the slip transfer stays 10^-20 inside its limits: that must not look like a tie
    run = referred(found.scene, digits=80)
    with Ball(36).context():
        start = Ball.number(found.scene.initial.x2 + found.distance)
        return run.x2 - start, run.v1, run.v2, not run.events and run.mode == 0


PLANS = [
    (FREE, {"distance": "0.01"}, Road.STUCK),
    (DAMPED, {"distance": "-0.01"}, Road.STUCK),
    (DAMPED, {"distance": "0.01", "margin": "0.25"}, Road.STUCK),
    (FREE, {"distance": "0.001", "amplitude": "1.08"}, Road.SLIP),
    (DAMPED, {"distance": "0.001", "amplitude": "1.12"}, Road.SLIP),
    (FREE, {"distance": "-0.001", "amplitude": "0.5"}, Road.BANG_BANG),
    (FREE, {"distance": "0.0005", "amplitude": "0.3", "margin": "0.2"}, Road.BANG_BANG),
]


@pytest.mark.parametrize(("pair", "plan", "road"), PLANS)
def test_a_transfer_arrives_at_rest_by_the_reference(pair, plan, road):
    found = fastest_transfer(at_rest(pair), **plan)
    assert found.road is road
    off, v1, v2, stuck = arrived(found)
    assert abs(off) < 1e-19
    assert abs(v1) + abs(v2) < 1e-18
    assert stuck == (road is not Road.SLIP)
    if "amplitude" in plan:
        limit = Fraction(plan["amplitude"])
        until = float(found.scene.until)
        assert all(abs(found.scene.force(until * k / 500)) <= float(limit) * (1 + 1e-12) for k in range(500))


def test_times_and_amplitudes_are_their_formulas_in_another_arithmetic():
    found = fastest_transfer(at_rest(DAMPED), "0.001", digits=30)
    with mpmath.workdps(40):
        b, m, k, d, a = mpmath.mpf("0.5"), 1, 200, mpmath.mpf("0.001"), 3
        tau = mpmath.sqrt(d * m / b)
        path = mpmath.odefun(lambda t, y: [y[1], 1 - k * y[0] - a * y[1]], 0, [0, 0])
        g = path(tau)[1]  # the velocity after a unit step is the impulse response
        least = b + b / m * tau / g
        stuck = max(2 * b + a * tau * b + k * d / 2, k * d)
        for ball, value in ((found.bound, 2 * tau), (found.least_amplitude, least), (found.stuck_amplitude, stuck)):
            assert abs(mpmath.mpf(ball.mid().str(35, radius=False)) / value - 1) < mpmath.mpf(10) ** -28


@given(decimals(-4, -3, 2), st.integers(1, 9))
@settings(max_examples=8)
def test_more_force_is_never_slower(distance, part):
    """Of the amplitudes for which a transfer is known, none takes longer than a smaller one, none beats the bound."""
    known = fastest_transfer(at_rest(FREE), distance)
    times = []
    for k in range(1, 10):
        amplitude = Fraction(float(known.stuck_amplitude)) * k / 5 * Fraction(part + 20, 21)
        found = fastest_transfer(at_rest(FREE), distance, amplitude=amplitude)
        if found.time is not None:
            assert not found.time < found.bound
            times.append(found.time)
    assert all(not two > one for one, two in pairwise(times))


def test_body_1_meets_body_2_just_before_half_time_with_a_thousandth_less():
    """Below U_min the bodies meet before half time, above it after: the least amplitude is at its edge."""
    far = Fraction(1, 1000)
    with Ball(30).context():
        least = Fraction(float(transfers.least_amplitude(FREE, far)))
        half = float(Ball.number(far * 2).sqrt())
    contacts = []
    for factor in ("0.999", "1.001"):
        push = Force((Piece(0, (least * Fraction(factor),)),))
        run = referred(Scene(FREE, State(), 1, force=push))
        contacts.append(float(run.events[0].t))
    assert contacts[0] < half < contacts[1]
    assert contacts[1] - contacts[0] < 0.05 * half


def test_a_wrong_factor_in_the_least_amplitude_is_found_out(monkeypatch):
    right = transfers.least_amplitude
    monkeypatch.setattr(transfers, "least_amplitude", lambda pair, far: right(pair, far) * arb("0.98"))
    found = fastest_transfer(at_rest(FREE), "0.001", amplitude="1.08")
    assert abs(arrived(found)[0]) > 1e-9


def test_between_the_amplitudes_it_says_that_the_least_time_is_open():
    found = fastest_transfer(at_rest(FREE), "0.01", amplitude="1.5")
    assert found.road is Road.OPEN
    assert found.scene is None
    assert "whether slipping meets the bound with less is open" in found.fastest  # g' < 0 before half time
    weaker = fastest_transfer(at_rest(FREE), "0.001", amplitude=1)
    assert weaker.road is Road.OPEN
    assert "no control meets the bound with less than 1.03496 N" in weaker.fastest


def test_where_the_impulse_response_turns_no_least_amplitude_is_claimed():
    """Heavy damping: g' < 0 before half time."""
    found = fastest_transfer(at_rest(Pair("0.8", "1.9", 64, "0.25", 40)), "0.02", amplitude=3)
    assert found.road is Road.OPEN
    assert found.least_amplitude is None
    assert "whether slipping meets the bound with less is open" in found.fastest


@pytest.mark.parametrize(
    ("wrong", "named"),
    [
        ({"distance": 0}, "distance"),
        ({"distance": "x"}, "distance"),
        ({"distance": 1, "margin": 1}, "margin"),
        ({"distance": 1, "amplitude": 0}, "amplitude"),
    ],
)
def test_bad_transfers_are_refused(wrong, named):
    with pytest.raises(InvalidScene, match=named):
        fastest_transfer(at_rest(FREE), **wrong)
    with pytest.raises(InvalidScene, match="rest"):
        fastest_transfer(Scene(FREE, State(v1=1), 1), 1)
    with pytest.raises(InvalidScene, match="force"):
        fastest_transfer(Scene(FREE, State(), 1, force=Force.step(0, 1)), 1)
