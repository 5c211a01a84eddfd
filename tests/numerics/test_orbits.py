"""How a periodic motion is found and proved: its equations, its modes, its multipliers, and when it is given up."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from control_scenes import DAMPED, under
from flint import arb, arb_mat
from hypothesis import example, given, settings
from hypothesis import strategies as st
from strategies import decimals, signed

from numerics.arithmetic.ball import Ball
from numerics.control.again import orbit_again
from numerics.control.cyclic import Link, newton_step
from numerics.control.linear import LinearMode, W
from numerics.control.orbit import Leg, Orbit, _eigenvalues_of_two, _proved, prove_modes
from numerics.control.response import Regime, response, steady_drive
from numerics.errors import EventUndecided, NotSettled
from numerics.scene import Force, Pair, Piece, Scene, Sine, State


@pytest.mark.parametrize("planted", ["side", "late"])
def test_a_false_mode_is_not_proved(planted):
    orbit = response(under(DAMPED, "0.5")).orbit
    legs = list(orbit.legs)
    legs[0] = replace(legs[0], side=-1) if planted == "side" else replace(legs[0], t=legs[1].t + 1)
    with pytest.raises(EventUndecided), Ball(20).context():
        prove_modes(Orbit(orbit.drive, tuple(legs)))


@pytest.mark.parametrize("amplitude", ["0.2", "5"])
def test_events_that_no_motion_has_are_not_proved(amplitude):
    """Those of a stick-slip motion, under a force for which there is none of the kind."""
    legs = [Leg(leg.side, leg.t.mid(), leg.x.mid(), leg.v.mid()) for leg in response(under(DAMPED, "0.5")).orbit.legs]
    drive = steady_drive(under(DAMPED, amplitude))
    with Ball(20).context(), pytest.raises(EventUndecided):
        _proved(Orbit(drive, tuple(legs)))


@given(*[signed(decimals(-3, 3))] * 4)
def test_the_larger_multiplier_comes_first(a, b, c, d):
    with Ball(20).context():
        numbers = [Ball.number(one) for one in (a, b, c, d)]
        try:
            large, small = _eigenvalues_of_two(*numbers)
        except EventUndecided:
            return
        assert not abs(large) < abs(small)
        assert (large + small - numbers[0] - numbers[3]).contains(0)
        assert (large * small - numbers[0] * numbers[3] + numbers[1] * numbers[2]).contains(0)


@given(st.integers(1, 9), st.integers(1, 10**6))
@settings(max_examples=8)
def test_a_step_around_the_ring_of_events_is_that_of_the_whole_matrix(count, seed):
    draw = np.random.default_rng(seed).uniform(-1, 1, (count, 3, 7)) + 2 * np.eye(3, 7, 4)
    links = [
        Link(arb_mat(one[:, :1].tolist()), arb_mat(one[:, 1:4].tolist()), arb_mat(one[:, 4:].tolist())) for one in draw
    ]
    steps = np.array([[float(x) for x in step.entries()] for step in newton_step(links)]).ravel()
    whole, missed = np.zeros((3 * count, 3 * count)), draw[:, :, 0].ravel()
    for k, one in enumerate(draw):
        rows, after = slice(3 * k, 3 * k + 3), (k + 1) % count
        whole[rows, 3 * k : 3 * k + 3] += one[:, 1:4]
        whole[rows, 3 * after : 3 * after + 3] += one[:, 4:]
    assert steps == pytest.approx(-np.linalg.solve(whole, missed), rel=1e-6, abs=1e-6)


def test_many_events_in_a_period_are_solved_together():
    """5 and 5.5 rad/s: some 30 events in 4 pi seconds, solved as one ring of equations."""
    pair = Pair(1, 1, 200, "0.05", 1)
    found = response(Scene(pair, State(), 1, force=Force.sine("0.3", 5) + Force.sine("0.3", "5.5")))
    assert len(found.orbit.legs) > 30
    assert orbit_again(found.orbit, 15).final_mode.sign == found.orbit.legs[0].side


def test_a_light_body_1_takes_no_finer_parts_for_ever():
    """Its own rates are 10^6/s and 200/s; the slip is 0.2 s long."""
    found = response(under(Pair("1e-6", 1, 200, "0.05", 1), "0.6", 5))
    assert found.regime is Regime.STICK_SLIP
    assert orbit_again(found.orbit, 15).final_mode is not None


@pytest.mark.parametrize(
    ("omega", "max_events", "said"), [("7.000000001", 500, "500 events, 2 periods"), ("15", 27, "a fifth")]
)
def test_what_does_not_settle_within_the_cap_is_said_at_once(omega, max_events, said):
    scene = Scene(Pair(1, 1, 200, "0.05", 1), State(), 1, force=Force.sine("0.3", 5) + Force.sine("0.3", omega))
    with pytest.raises(NotSettled, match=said):
        response(scene, max_events=max_events)


def test_who_waits_hears_what_is_done():
    heard: list[str] = []
    response(under(DAMPED, "0.5"), tell=heard.append)
    assert any("solving a periodic motion of 4 events" in one for one in heard)
    assert any("proving the modes" in one for one in heard)


def test_many_digits_are_solved_again_to_as_many():
    found = response(under(DAMPED, "0.5"), digits=120)
    assert orbit_again(found.orbit, 120).final_mode is not None


@given(decimals(-6, 6, 2), decimals(-2, 2, 2), st.sampled_from([0, 1, -1]), decimals(-3, 0, 2))
@example(Fraction(1, 10**6), Fraction(1), 1, Fraction(1, 10))
@settings(max_examples=25)
def test_a_range_over_times_holds_the_values_at_them(m1, a1, side, length):
    """Also where body 1 is so light that the bound by energy is the one that counts."""
    mode = LinearMode(Pair(m1, 1, 200, "0.5", a1), Fraction(1, 2), side, Piece(0, ["0.1", 1, -2], [Sine("0.3", 7)]))
    with Ball(30).context():
        v1 = arb("0.2")
        motion = mode.motion((arb("0.01"), v1, arb(0), v1 if side == 0 else arb(0)), arb("0.3"))
        begin, end = Ball.number(length), Ball.number(2 * length)
        for row, order in ((W, 0), (W, 1), (mode.load, 0), (mode.load, 1), (mode.load, 2)):
            wide = motion.range(row, begin.union(end), order)
            for k in range(5):
                assert wide.overlaps(motion.range(row, begin + (end - begin) * k / 4, order))
