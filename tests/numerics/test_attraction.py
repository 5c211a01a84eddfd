"""What is left to slide next to a periodic motion: a bound, held against maps and runs that are known."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cache
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from control_scenes import one_period, referred
from flint import arb, arb_mat
from hypothesis import given, settings
from hypothesis import strategies as st

from numerics import EventUndecided, Force, Pair, Scene, State, response
from numerics.arithmetic.ball import Ball
from numerics.control import attraction
from numerics.control.attraction import passage_at, passages, slide_left
from numerics.control.orbit import Orbit

UNEVEN = Pair(3, "0.5", 200, "0.5", 3)
STICKS, SLIPS = "3", "5"
"""Amplitudes at 12 rad/s under which this pair sticks twice a period, and not at all."""


@cache
def orbit_under(amplitude: str) -> Orbit:
    return response(Scene(UNEVEN, State(), 1, force=Force.sine(amplitude, 12))).orbit


def in_leg(orbit: Orbit, number: int) -> arb:
    """The middle of a leg."""
    leg, after = orbit.turns[number]
    return ((leg.t + after.t) / 2).mid()


def after_a_period(orbit: Orbit, t: Fraction, moved: np.ndarray) -> np.ndarray:
    """(x1, v1, v2) a period after a start beside the orbit at time t, by the independent reference."""
    end = referred(one_period(orbit, [Fraction(float(one)) for one in moved], t)).state()
    return np.array([float(end[0]), float(end[1]), float(end[3])])


@settings(max_examples=3)
@given(st.integers(500, 990))
def test_what_is_left_holds_the_sum_of_a_map_that_shrinks_by_a_known_factor(thousandths):
    """dz is a factor times what it was, a period later: int |w - w*| dt is sqrt(kappa) T eps/(1 - factor) at most."""
    factor, orbit, reach = thousandths / 1000, orbit_under(SLIPS), 1e-6
    kappa = float(UNEVEN.mass / (UNEVEN.m1 * UNEVEN.m2))
    longest = math.sqrt(kappa) * float(orbit.drive.period) * reach / (1 - factor)
    with pytest.MonkeyPatch.context() as patch, Ball(20).context():
        patch.setattr(attraction, "_period_slopes", lambda *_: factor * arb_mat(np.eye(3).tolist()))
        assert float(slide_left(orbit, in_leg(orbit, 0), arb(reach))) >= longest


def test_a_map_that_does_not_shrink_leaves_it_undecided():
    orbit = orbit_under(SLIPS)
    with pytest.MonkeyPatch.context() as patch, Ball(20).context():
        patch.setattr(attraction, "_period_slopes", lambda *_: arb_mat(np.eye(3).tolist()))
        with pytest.raises(EventUndecided, match="shrink"):
            slide_left(orbit, in_leg(orbit, 0), arb("1e-6"))


@pytest.mark.parametrize(("amplitude", "number"), [(SLIPS, 0), (STICKS, 0), (STICKS, 1)])
@settings(max_examples=3)
@given(st.lists(st.integers(-8, 8), min_size=3, max_size=3))
def test_the_slopes_of_a_period_hold_over_the_whole_box(amplitude, number, corner):
    """The difference of two runs beside the orbit is a slope in between times that of their starts (mean value)."""
    orbit, reach = orbit_under(amplitude), 2e-5
    t = Fraction(float(in_leg(orbit, number)))
    sizes = np.array([float(1 / math.sqrt(one)) for one in (UNEVEN.a2, UNEVEN.m1, UNEVEN.m2)]) * reach
    moved = np.array(corner) / 8 * sizes * 0.999
    if orbit.legs[number].side == 0:
        moved[2] = moved[1]
    found = after_a_period(orbit, t, moved) - after_a_period(orbit, t, np.zeros(3))
    with Ball(20).context():
        slopes = attraction._period_slopes(orbit, Ball.number(t), arb(reach))
        bound = slopes * arb_mat([[one] for one in moved.tolist()])
        for row in range(3):
            assert (bound[row, 0] + arb(0, 1e-13)).contains(arb(found[row])), (row, bound[row, 0], found[row])


def test_the_box_holds_every_state_within_reach(monkeypatch):
    """N of a difference in one number alone is root a2, m1 or m2 times it."""
    radii, reach = [], arb("1e-6")
    monkeypatch.setattr(attraction, "one_round", lambda *given: radii.append(given[3]) or SimpleNamespace(slopes=None))
    with Ball(20).context():
        attraction._period_slopes(orbit_under(SLIPS), in_leg(orbit_under(SLIPS), 0), reach)
        assert all(radii[0] ** 2 * Ball.number(one) >= reach**2 for one in (UNEVEN.a2, UNEVEN.m1, UNEVEN.m2))


@pytest.mark.parametrize(("amplitude", "number"), [(SLIPS, 0), (STICKS, 0), (STICKS, 1)])
def test_a_box_that_reaches_out_of_its_mode_is_undecided(amplitude, number):
    """Just before the event that ends a leg some of the states within reach have left its mode, others have not."""
    orbit = orbit_under(amplitude)
    with Ball(20).context():
        _, after = orbit.turns[number]
        t = after.t - arb("1e-5")
        attraction._period_slopes(orbit, t, arb("1e-9"))
        with pytest.raises(EventUndecided):
            attraction._period_slopes(orbit, t, arb("1e-4"))


@given(st.integers(-300, 300))
@settings(max_examples=10)
def test_a_drifting_motion_goes_on_where_the_leg_before_ends(percent):
    """x2 is carried from leg to leg, and from period to period by the drift."""
    orbit = drifting_orbit()
    with Ball(20).context():
        t = orbit.drive.period * percent / 100 + arb("0.00123")
        legs = list(passages(orbit, t - orbit.drive.period / 3, t + orbit.drive.period / 3))
        for before, after in pairwise(legs):
            for one, two in zip(before.state(before.end), after.state(after.begin), strict=True):
                assert (one - two).contains(0)
        now, later = (passage_at(orbit, one).state(one) for one in (t, t + orbit.drive.period))
        assert (later[2] - now[2] - orbit.travel).contains(0)
        assert abs(orbit.travel) > 1e-6


@cache
def drifting_orbit() -> Orbit:
    force = Force.sine("0.5", 12) + Force.sine("0.3", 24, 1)
    return response(Scene(Pair(1, 1, 200, "0.5", 3), State(), 1, force=force), digits=20).orbit
