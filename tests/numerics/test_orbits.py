"""How a periodic motion is found and proved: its equations, its modes, its multipliers, and when it is given up."""

from fractions import Fraction

import pytest
from control_scenes import DAMPED, middle, started, under
from flint import arb, arb_mat
from hypothesis import example, given, settings
from hypothesis import strategies as st
from strategies import decimals

from numerics import EventUndecided, Force, NotSettled, Pair, Piece, Scene, Sine, State
from numerics.arithmetic.ball import Ball
from numerics.control.answers import solved_again
from numerics.control.orbit import Orbit, one_round, solve_orbit
from numerics.control.response import Regime, response, steady_drive
from numerics.linear.system import LinearMode, W, is_positive_on


@pytest.mark.parametrize("radius", ["0.1", "1"])
def test_a_box_whose_motions_have_other_events_is_not_followed(radius):
    orbit = response(under(DAMPED, "0.5")).orbit
    begin = middle(orbit)
    start = started(orbit, begin)
    with Ball(20).context():
        assert one_round(orbit.drive, begin, start, arb("1e-6"), 4).slopes.nrows() == 3
        with pytest.raises(EventUndecided):
            one_round(orbit.drive, begin, start, arb(radius), 4)


def test_events_that_no_motion_has_are_not_proved():
    """Those of a stick-slip motion, under a force for which the pair is entrained."""
    legs = response(under(DAMPED, "0.5")).orbit.legs
    with Ball(20).context(), pytest.raises(EventUndecided):
        solve_orbit(Orbit(steady_drive(under(DAMPED, "0.2")), legs))


def test_a_motion_is_proved_by_what_the_period_map_does_to_a_box_not_to_a_point(monkeypatch):
    def wide(*asked):
        found = one_round(*asked)
        return found if asked[3] == 0 else found._replace(slopes=found.slopes + arb_mat(3, 3, [arb(0, 9)] * 9))

    orbit = response(under(DAMPED, "0.5")).orbit
    monkeypatch.setattr("numerics.control.orbit.one_round", wide)
    with Ball(20).context(), pytest.raises(EventUndecided):
        solve_orbit(orbit)


def test_many_events_in_a_period_are_solved_together():
    """5 and 5.5 rad/s: some 30 events in 4 pi seconds, solved as one ring of equations."""
    pair = Pair(1, 1, 200, "0.05", 1)
    found = response(Scene(pair, State(), 1, force=Force.sine("0.3", 5) + Force.sine("0.3", "5.5")))
    assert len(found.orbit.legs) > 30
    assert solved_again(found).final_mode.sign == found.orbit.legs[0].side


def test_a_light_body_1_takes_no_finer_parts_for_ever():
    """Its own rates are 10^6/s and 200/s; the slip is 0.2 s long."""
    found = response(under(Pair("1e-6", 1, 200, "0.05", 1), "0.6", 5))
    assert found.regime is Regime.STICK_SLIP
    assert solved_again(found).final_mode is not None


@pytest.mark.parametrize(
    ("omega", "max_events", "said"), [("7.000000001", 500, "100 events, a fifth"), ("15", 27, "5 events, a fifth")]
)
def test_what_does_not_settle_within_the_cap_is_said_at_once(omega, max_events, said):
    scene = Scene(Pair(1, 1, 200, "0.05", 1), State(), 1, force=Force.sine("0.3", 5) + Force.sine("0.3", omega))
    with pytest.raises(NotSettled, match=said):
        response(scene, max_events=max_events)


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


def test_a_slip_that_turns_back_in_between_is_not_called_a_slip():
    """w falls below 0 and comes back: its ends alone do not say so."""
    with Ball(20).context():
        mode = LinearMode(Pair(1, 1, 1, "0.01"), Fraction(1, 100), 1, Piece(0, (), [Sine(1, 20)]))
        motion = mode.motion([arb(0), arb("0.05"), arb(0), arb(0)], arb(0))
        period = 2 * arb.pi() / 20
        assert is_positive_on(lambda t: motion.range(W, t), arb(0), period)
        backwards = mode.motion([arb(0), arb("0.02"), arb(0), arb("0.06")], arb(0))
        assert not is_positive_on(lambda t: backwards.range(W, t), arb(0), period)
