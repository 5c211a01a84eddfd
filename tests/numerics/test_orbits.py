"""How a periodic motion is found and proved, what holds for all motions next to it, and when it is given up."""

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from math import sqrt

import numpy as np
import pytest
from control_scenes import DAMPED, UNEVEN, answer, started
from flint import arb, arb_mat
from scene_files import scenes_in

from numerics import EventUndecided, Piece, response
from numerics.arithmetic.ball import Ball
from numerics.control import orbit, ring
from numerics.control.orbit import middle, one_round, solve_orbit, state_at
from numerics.control.ring import slide_left

ORBITS = {
    "that slips": lambda: answer(UNEVEN, "5").orbit,
    "that sticks": lambda: answer(UNEVEN, "3").orbit,
}
both = pytest.mark.parametrize("of", ORBITS)


@both
def test_the_slopes_of_a_period_hold_over_the_whole_box(of):
    """The difference of two runs of a box is a slope in between times that of their starts (mean value)."""
    found, radius = ORBITS[of](), Fraction(1, 10**5)
    for leg in sorted(found.legs, key=lambda leg: float(leg.end - leg.start))[-2:]:
        t = middle([leg])[0]
        start = started(found, t)
        with Ball(25).context():
            slopes = one_round(found.drive, t, start, 8, Ball.number(radius)).slopes
            centre = one_round(found.drive, t, start, 8).end
            slips = ((1, 1, -1), (1, -1, 1)) if start[1] != start[2] else ()
            for signs in ((1, 1, 1), (-1, 1, 1), *slips):
                by = [radius * sign for sign in signs]
                end = one_round(found.drive, t, [a + b for a, b in zip(start, by, strict=True)], 8).end
                moved = [end[k] - centre[k] for k in (0, 1, 3)]
                bound = (slopes * arb_mat([[Ball.number(one)] for one in by])).entries()
                assert all(one.overlaps(two) for one, two in zip(bound, moved, strict=True))


def test_a_period_that_ends_in_another_mode_than_it_began_in_is_refused():
    """It begins as a slip where the motion sticks; a period later that is over."""
    found = ORBITS["that sticks"]()
    with Ball(25).context():
        t = middle([next(leg for leg in found.legs if leg.side == 0)])[0]
        x1, v1, v2 = started(found, t)
        with pytest.raises(EventUndecided, match="come back"):
            one_round(found.drive, t, [x1, v1, v2 + Fraction(1, 1000)], 8)


@both
def test_events_that_no_motion_has_are_not_proved(of):
    """Under so weak a force nothing slips."""
    found = ORBITS[of]()
    piece = Piece(0, (), [replace(found.drive.piece.sines[0], amplitude="0.2")])
    with Ball(25).context(), pytest.raises(EventUndecided):
        solve_orbit(replace(found.drive, piece=piece), found)


def test_a_motion_is_proved_by_what_the_period_map_does_to_a_box_not_to_a_point(monkeypatch):
    """Here it takes the steps of Newton's method 5000 times as far: just out of the largest box."""

    def wide(*asked):
        found, unit = one_round(*asked), arb_mat(np.eye(3).tolist())
        return found if len(asked) == 4 else found._replace(slopes=unit - (unit - found.slopes) * arb("2e-4"))

    found = answer(DAMPED, "0.5").orbit
    monkeypatch.setattr(orbit, "one_round", wide)
    with Ball(20).context(), pytest.raises(EventUndecided):
        solve_orbit(found.drive, found)


# what is left to slide next to it


@pytest.mark.parametrize("factor", [0.5, 0.99, 1])
def test_what_is_left_holds_the_sum_of_a_map_that_shrinks_by_a_known_factor(factor, monkeypatch):
    """dz is a factor times what it was, a period later: int |w - w*| dt is sqrt(kappa) T eps/(1 - factor) at most.

    The box that is followed holds every state within reach: N of one number alone is root a2, m1 or m2 times it.
    """
    found, reach, radii = ORBITS["that slips"](), arb("1e-6"), []
    slopes = orbit.Round([], (), factor * arb_mat(np.eye(3).tolist()))
    monkeypatch.setattr(ring, "one_round", lambda *given: radii.append(given[4]) or slopes)
    with Ball(20).context():
        t = Ball.number(middle(found.legs)[0])
        if factor < 1:
            kappa = float(UNEVEN.mass / (UNEVEN.m1 * UNEVEN.m2))
            longest = sqrt(kappa) * float(found.drive.period) * 1e-6 / (1 - factor)
            assert float(slide_left(found, t, reach)) >= longest
        else:
            with pytest.raises(EventUndecided, match="shrink"):
                slide_left(found, t, reach)
        for k in range(3):
            only = [radii[0] if place == k else arb(0) for place in range(3)]
            assert found.drive.norm.of((*only[:2], arb(0), only[2])) >= reach


@pytest.mark.parametrize("percent", [-300, -47, 0, 38, 120])
def test_a_drifting_motion_goes_on_where_the_leg_before_ends(percent):
    """x2 is carried from leg to leg, and from period to period by the drift."""
    found = response(scenes_in("periodic")["a-weaker-force-that-is-not-odd"], digits=20).orbit
    with Ball(20).context():
        assert found.legs[0].state[2].contains(0)
        assert found.legs[0].state[2].rad() < 1e-15
        t = found.drive.period * percent / 100 + arb("0.00123")
        legs = list(found.between(t - found.drive.period / 3, t + found.drive.period / 3))
        for before, after in pairwise(legs):
            for one, two in zip(state_at(before, before.end), after.state, strict=True):
                assert (one - two).contains(0)
        now, later = (state_at(found.passage_at(one), one) for one in (t, t + found.drive.period))
        assert (later[2] - now[2] - found.travel).contains(0)
        assert abs(found.travel) > 1e-6
