"""Periodic motions where friction depends on the speed: each by another integrator, and what is said of the rest."""

from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from control_scenes import DAMPED, middle, started, under
from flint import arb, arb_mat

from numerics import (
    EventUndecided,
    Force,
    Friction,
    InvalidScene,
    Pair,
    Piece,
    Scene,
    Sine,
    State,
    Weakening,
    ring_entry,
)
from numerics.arithmetic.ball import Ball
from numerics.control.answers import rounded, solved_again
from numerics.control.coexisting import apart, mirrored
from numerics.control.orbit import Orbit, one_round, solve_orbit
from numerics.control.response import PeriodicMotions, Regime, response, steady_drive
from tests.state_reference import reference

FALLING = Weakening([("0.3", "0.15")])
LIGHTLY = Pair(1, 1, 200, "0.5", "0.2")


def falling(amplitude: object, omega: object, weakening: Weakening = FALLING, pair: Pair = LIGHTLY) -> PeriodicMotions:
    """The motions that are found under one sine."""
    return response(under(pair, amplitude, omega, friction=Friction((), weakening)), digits=10)


@cache
def bistable() -> PeriodicMotions:
    return falling("0.45", 14)


@cache
def two_that_attract() -> PeriodicMotions:
    return falling("0.45", 13)


ALL = [(bistable, 0), (bistable, 1), (bistable, 2), (two_that_attract, 0), (two_that_attract, 1), (two_that_attract, 2)]


def returned(scene: Scene, *by: float) -> np.ndarray:
    """(x1, v1, v2) after the scene by the other integrator; its start moved."""
    at = scene.initial
    x1, v1, v2 = (Fraction(move) + one for move, one in zip(by or (0, 0, 0), (at.x1, at.v1, at.v2), strict=True))
    return reference(replace(scene, initial=State(x1, v1, 0, v2))).y[[0, 1, 3]]


def test_a_stuck_motion_a_slipping_one_and_one_between_that_others_leave_are_found():
    found = bistable()
    assert [one.regime for one in found.motions] == [Regime.ENTRAINED, Regime.NON_STOP, Regime.NON_STOP]
    assert "may be more" in found.sentence
    assert not found.is_all
    sizes = [float(abs(one.multipliers[0])) for one in found.motions]
    assert [one > 1 for one in sizes] == [False, True, False]
    assert [one.attraction.split(" ")[-2:] for one in found.motions[1:]] == [["leave", "it"], ["to", "it"]]
    assert all("every motion" not in one.attraction for one in found.motions)


@pytest.mark.parametrize(("of", "number"), ALL)
def test_each_comes_back_by_another_integrator(of, number):
    found = of().motions[number]
    scene = found.one_period()
    at = np.array([float(one) for one in (scene.initial.x1, scene.initial.v1, scene.initial.v2)])
    assert np.allclose(returned(scene), at, rtol=0, atol=1e-9)
    assert solved_again(found) is not None or found.orbit is None


@pytest.mark.parametrize(("of", "number"), [(bistable, 1), (two_that_attract, 0)])
def test_multipliers_are_those_of_the_other_integrator(of, number):
    found = of().motions[number]
    scene, step = found.one_period(), 1e-5
    columns = [(returned(scene, *step * e) - returned(scene, *-step * e)) / (2 * step) for e in np.eye(3)]
    expected = sorted(abs(np.linalg.eigvals(np.array(columns).T)))
    assert sorted(float(abs(one).mid()) for one in found.multipliers) == pytest.approx(expected, abs=2e-5)


def test_two_that_attract_are_found_beside_each_other():
    tend = [one for one in two_that_attract().motions if one.attraction.endswith("tend to it")]
    assert {one.regime for one in tend} == {Regime.STICK_SLIP, Regime.NON_STOP}
    assert len(two_that_attract().motions) == 3
    assert two_that_attract().entrainment < arb("0.45")


def test_a_table_that_says_nothing_leaves_the_one_motion_and_its_sentence():
    one, plain = falling("0.5", 12, Weakening(), DAMPED), response(under(DAMPED, "0.5"))
    assert one.is_all
    assert "no other" in one.sentence
    assert one.motions[0].attraction == plain.attraction == "every motion tends to it"
    for ours, theirs in zip(one.motions[0].orbit.legs, plain.orbit.legs, strict=True):
        assert ours.t.overlaps(theirs.t)
        assert ours.x.overlaps(theirs.x)


def test_where_friction_only_rises_one_motion_is_all():
    found = falling("0.5", 12, Weakening([("0.01", "0.51")], "0.4"), DAMPED)
    assert found.is_all
    assert len(found.motions) == 1
    assert len(found.motions[0].orbit.legs) > len(found.motions[0].orbit.events)
    stuck = falling("0.1", 12, Weakening([("0.1", "0.6")], "0.4"), DAMPED)
    assert (stuck.is_all, stuck.motions[0].regime) == (True, Regime.ENTRAINED)


def test_the_last_friction_scales_the_table():
    doubled = Weakening([("0.3", "0.3")])
    late = Scene(
        Pair(1, 1, 200, 1, "0.2"), State(), 2, force=Force.sine("0.45", 14), friction=Friction([(1, "0.5")], doubled)
    )
    assert steady_drive(late) == bistable().drive


def test_a_motion_that_is_not_its_own_opposite_is_found_with_that():
    for found in bistable().motions[1:]:
        drive, legs = found.orbit.drive, found.orbit.legs
        assert not apart(found.orbit, mirrored(found.orbit))
        pushed = replace(drive, piece=Piece(0, (20,), drive.piece.sines))  # by 20 N: 0.1 m
        moved = Orbit(pushed, tuple(replace(one, x=one.x + arb("0.1")) for one in legs))
        assert not apart(moved, mirrored(moved))
    orbit = bistable().motions[1].orbit
    assert apart(orbit, Orbit(orbit.drive, tuple(replace(one, x=one.x + arb("1e-6")) for one in orbit.legs)))


@pytest.mark.long
def test_a_force_that_favours_no_side_may_carry_body_2_along_for_ever_to_either_side():
    """With one b and a1 > 0 the only motion is its own opposite and does not travel."""
    light = Pair("0.163", "0.74", 200, "4.892", "0.199")
    found = falling(20, 17, Weakening([("0.0192", "3.5242"), ("0.6982", "1.3174")]), light)
    carried = [one for one in found.motions if abs(one.drift) > 1 and one.attraction.endswith("tend to it")]
    one, two = (one.drift for one in carried)
    assert (one + two).contains(0)
    for motion in carried:
        period = motion.one_period()
        assert reference(period).y[2] / float(period.until) == pytest.approx(float(motion.drift), rel=1e-9)
    drives = {mirrored(one.orbit).legs[0].x.str(9) for one in carried}
    assert drives == {one.orbit.legs[0].x.str(9) for one in carried}


def test_a_box_on_both_sides_of_a_knot_is_not_followed():
    orbit = bistable().motions[2].orbit
    knot = next(k for k, leg in enumerate(orbit.legs) if leg.v - leg.v2 > arb("0.299"))
    leg, after = orbit.turns[knot]
    t = rounded(leg.t + (after.t - leg.t) / 100)
    start = started(orbit, t)
    with Ball(25).context():
        assert one_round(orbit.drive, t, start, arb("1e-9"), 4).slopes.nrows() == 3
        with pytest.raises(EventUndecided):
            one_round(orbit.drive, t, start, 2 * abs(leg.v - leg.v2 - Ball.number(start[1] - start[2])), 4)


@pytest.mark.parametrize(("of", "number"), [(bistable, 1), (two_that_attract, 1)])
def test_the_slopes_of_a_period_hold_over_the_whole_box(of, number):
    """The difference of two runs of a box is a slope in between times that of their starts (mean value)."""
    orbit, radius = of().motions[number].orbit, Fraction(1, 10**5)
    longest = max(range(len(orbit.legs)), key=lambda k: float(orbit.turns[k][1].t - orbit.turns[k][0].t))
    t = middle(orbit, longest)
    start = started(orbit, t)
    with Ball(25).context():
        slopes = one_round(orbit.drive, t, start, Ball.number(radius), 4).slopes
        thinner = arb_mat([[one.mid() for one in row] for row in slopes.tolist()])
        centre = one_round(orbit.drive, t, start, arb(0), 4).end
        slips = ((1, 1, -1), (1, -1, 1)) if start[1] != start[2] else ()
        for signs in ((1, 1, 1), (-1, 1, 1), *slips):
            by = [radius * sign for sign in signs]
            end = one_round(orbit.drive, t, [a + b for a, b in zip(start, by, strict=True)], arb(0), 4).end
            for matrix, holds in ((slopes, True), (thinner, False)):
                bound = (matrix * arb_mat([[Ball.number(one)] for one in by])).entries()
                assert all(one.overlaps(a - b) for one, a, b in zip(bound, end, centre, strict=True)) is holds


def test_a_motion_that_another_force_has_is_not_proved_of_this_one():
    weaker = replace(bistable().drive, piece=Piece(0, (), [Sine("0.2", 14)]))
    with Ball(25).context(), pytest.raises(EventUndecided):
        solve_orbit(Orbit(weaker, bistable().motions[2].orbit.legs))


def test_resonance_grows_only_above_the_most_that_friction_can_be():
    free, force = Pair(1, 1, 100, "0.5"), "0.8"
    grows = falling(force, 10, Weakening([("0.3", "0.6")]), free)
    assert (grows.is_all, grows.motions[0].regime) == (True, Regime.GROWS)
    assert abs(grows.motions[0].growth - (arb("0.8") - 4 * arb("0.6") / arb.pi()) / 2) < 1e-10
    assert falling(force, 10, Weakening([], "0.4"), free).motions[0].regime is not Regime.GROWS


def test_the_picture_names_each_motion_and_what_friction_can_be():
    law, plane = bistable().plot().axes
    assert law.get_xlabel() == plane.get_ylabel() == "$v_1 - v_2$ (m/s)"
    assert (law.get_ylabel(), plane.get_xlabel()) == ("friction on body 2 (N)", "$x_1$ (m)")
    names = ["1: entrained", "2: non-stop, which others leave", "3: non-stop"]
    assert [line.get_label() for line in plane.lines] == names
    slip, given = law.lines[2], law.lines[-1]
    at = np.abs(slip.get_xdata()) > 1e-3
    expected = np.interp(slip.get_xdata()[at], *given.get_data())
    assert np.allclose(slip.get_ydata()[at], expected, atol=1e-3)


def test_what_is_not_worked_out_is_refused():
    by_place = Friction((), Weakening([], 0, [("0.01", "0.1")]))
    with pytest.raises(InvalidScene, match="x1 - x2"):
        response(under(LIGHTLY, "0.4", friction=by_place))
    with pytest.raises(InvalidScene, match="tolerance ring"):
        ring_entry(under(LIGHTLY, "0.4", friction=Friction((), FALLING)), "0.01")
    with pytest.raises(InvalidScene, match="no force"):
        response(Scene(LIGHTLY, State(), 1, friction=Friction((), FALLING)))
