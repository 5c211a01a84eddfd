"""How a periodic motion is found and proved, what holds for all motions next to it, and when it is given up."""

import math
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from control_scenes import DAMPED, UNEVEN, answer, middle, started
from flint import arb, arb_mat
from hypothesis import example, given, settings
from hypothesis import strategies as st
from strategies import decimals

from numerics import EventUndecided, Force, NotSettled, Pair, Piece, Scene, Sine, State, response
from numerics.arithmetic.ball import Ball
from numerics.control import attraction
from numerics.control.answers import rounded, solved_again
from numerics.control.attraction import passage_at, passages, slide_left
from numerics.control.orbit import Box, Orbit, one_round, solve_orbit
from numerics.control.response import Regime
from numerics.linear.system import LinearMode, W

ORBITS = {
    "that slips": lambda: answer(UNEVEN, "5").orbit,
    "that sticks": lambda: answer(UNEVEN, "3").orbit,
}


@pytest.mark.parametrize("of", ORBITS)
def test_the_slopes_of_a_period_hold_over_the_whole_box(of):
    """The difference of two runs of a box is a slope in between times that of their starts (mean value)."""
    orbit, radius = ORBITS[of](), Fraction(1, 10**5)
    legs = sorted(range(len(orbit.legs)), key=lambda k: float(orbit.legs[k].end - orbit.legs[k].start))
    for t in (middle(orbit, k) for k in legs[-2:]):
        start = started(orbit, t)
        with Ball(25).context():
            slopes = one_round(orbit.drive, t, start, Ball.number(radius), 8).slopes
            thinner = arb_mat([[one.mid() for one in row] for row in slopes.tolist()])
            centre = one_round(orbit.drive, t, start, arb(0), 8).end
            slips = ((1, 1, -1), (1, -1, 1)) if start[1] != start[2] else ()
            for signs in ((1, 1, 1), (-1, 1, 1), *slips):
                by = [radius * sign for sign in signs]
                end = one_round(orbit.drive, t, [a + b for a, b in zip(start, by, strict=True)], arb(0), 8).end
                for matrix, holds in ((slopes, True), (thinner, False)):
                    bound = (matrix * arb_mat([[Ball.number(one)] for one in by])).entries()
                    assert all(one.overlaps(a - b) for one, a, b in zip(bound, end, centre, strict=True)) is holds


@pytest.mark.parametrize("of", ORBITS)
def test_a_box_of_which_a_part_has_left_its_mode_is_not_followed(of):
    """Just before a leg ends."""
    orbit = ORBITS[of]()
    with Ball(25).context():
        for leg in orbit.legs:
            t = rounded(leg.end - arb("1e-5"))
            assert one_round(orbit.drive, t, started(orbit, t), arb("1e-9"), 8).slopes.nrows() == 3
            with pytest.raises(EventUndecided):
                one_round(orbit.drive, t, started(orbit, t), arb("1e-3"), 8)


def test_a_period_that_ends_in_another_mode_than_it_began_in_is_refused():
    """It begins as a slip where the motion sticks; a period later that is over."""
    orbit = ORBITS["that sticks"]()
    with Ball(25).context():
        stick = next(leg for leg in orbit.legs if leg.side == 0)
        t = rounded((stick.start + stick.end) / 2)
        x1, v1, v2 = started(orbit, t)
        with pytest.raises(EventUndecided, match="come back"):
            one_round(orbit.drive, t, [x1, v1, v2 + Fraction(1, 1000)], arb(0), 8)


@pytest.mark.parametrize(("of", "amplitude"), [("that sticks", "0.2"), ("that slips", "0.2")])
def test_events_that_no_motion_has_are_not_proved(of, amplitude):
    """Under so weak a force nothing slips."""
    orbit = ORBITS[of]()
    piece = Piece(0, (), [replace(orbit.drive.piece.sines[0], amplitude=amplitude)])
    with Ball(25).context(), pytest.raises(EventUndecided):
        solve_orbit(Orbit(replace(orbit.drive, piece=piece), orbit.legs))


def test_a_motion_is_proved_by_what_the_period_map_does_to_a_box_not_to_a_point(monkeypatch):
    """Here it takes the steps of Newton's method 10^5 times as far: out of any box."""

    def wide(*asked):
        found, unit = one_round(*asked), arb_mat(np.eye(3).tolist())
        return found if asked[3] == 0 else found._replace(slopes=unit - (unit - found.slopes) * arb("1e-5"))

    orbit = answer(DAMPED, "0.5").orbit
    monkeypatch.setattr("numerics.control.orbit.one_round", wide)
    with Ball(20).context(), pytest.raises(EventUndecided):
        solve_orbit(orbit)


@pytest.mark.parametrize(
    ("pair", "force", "least"),
    [
        (Pair(1, 1, 200, "0.05", 1), Force.sine("0.3", 5) + Force.sine("0.3", "5.5"), 30),  # in 4 pi seconds
        (Pair("1e-6", 1, 200, "0.05", 1), Force.sine("0.6", 5), 2),  # rates of 10^6/s and 200/s, slips of 0.2 s
    ],
)
def test_many_events_in_a_period_and_a_light_body_1_are_followed(pair, force, least):
    found = response(Scene(pair, State(), 1, force=force))
    assert found.regime is Regime.STICK_SLIP
    assert len(found.orbit.legs) > least
    assert solved_again(found).final_mode.sign == found.orbit.legs[0].side


@pytest.mark.parametrize(
    ("omega", "max_events", "said"), [("7.000000001", 500, "100 events, a fifth"), ("15", 27, "5 events, a fifth")]
)
def test_what_does_not_settle_within_the_cap_is_said_at_once(omega, max_events, said):
    scene = Scene(Pair(1, 1, 200, "0.05", 1), State(), 1, force=Force.sine("0.3", 5) + Force.sine("0.3", omega))
    with pytest.raises(NotSettled, match=said):
        response(scene, max_events=max_events)


@given(decimals(-6, 6, 2), decimals(-2, 2, 2), st.sampled_from([0, 1, -1]), decimals(-3, 0, 2))
@example(Fraction(1, 10**6), Fraction(1), 1, Fraction(1, 10))
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


# what is left to slide next to it


@pytest.mark.parametrize("factor", [0.5, 0.9, 0.99, 1])
def test_what_is_left_holds_the_sum_of_a_map_that_shrinks_by_a_known_factor(factor, monkeypatch):
    """dz is a factor times what it was, a period later: int |w - w*| dt is sqrt(kappa) T eps/(1 - factor) at most."""
    orbit, reach, kappa = ORBITS["that slips"](), 1e-6, float(UNEVEN.mass / (UNEVEN.m1 * UNEVEN.m2))
    monkeypatch.setattr(attraction, "_period_slopes", lambda *_: factor * arb_mat(np.eye(3).tolist()))
    with Ball(20).context():
        t = Ball.number(middle(orbit))
        if factor < 1:
            longest = math.sqrt(kappa) * float(orbit.drive.period) * reach / (1 - factor)
            assert float(slide_left(orbit, t, arb(reach))) >= longest
        else:
            with pytest.raises(EventUndecided, match="shrink"):
                slide_left(orbit, t, arb(reach))


def test_a_number_of_a_box_is_known_within_its_radius():
    box = Box(20, arb("1e-3"))
    with box.context():
        assert box.number(Fraction(2)).contains(arb("2.000999"))


def test_the_box_holds_every_state_within_reach(monkeypatch):
    """N of a difference in one number alone is root a2, m1 or m2 times it."""
    radii, reach, orbit = [], arb("1e-6"), ORBITS["that slips"]()
    monkeypatch.setattr(attraction, "one_round", lambda *given: radii.append(given[3]) or SimpleNamespace(slopes=None))
    with Ball(20).context():
        attraction._period_slopes(orbit, Ball.number(middle(orbit)), reach)
        assert all(radii[0] ** 2 * Ball.number(one) >= reach**2 for one in (UNEVEN.a2, UNEVEN.m1, UNEVEN.m2))


@given(st.integers(-300, 300))
@settings(max_examples=10)
def test_a_drifting_motion_goes_on_where_the_leg_before_ends(percent):
    """x2 is carried from leg to leg, and from period to period by the drift."""
    orbit = drifting()
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
def drifting() -> Orbit:
    force = Force.sine("0.5", 12) + Force.sine("0.3", 24, 1)
    return response(Scene(DAMPED, State(), 1, force=force), digits=20).orbit
