"""Scenes under signals: ties, long sticks, many digits, a force of zero, slips that end at once."""

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from inclusion import overlap
from reaching import LeftOut, reaching
from scene_files import scenes_in
from sixty_digits import forced_scene
from strategies import MODERATE, pairs, states

from numerics import EventUndecided, Force, NumericsError, OutOfRange, Pair, Piece, Scene, State, solve
from numerics.arithmetic.precision import precision
from numerics.trajectory.status import Status


def run(scene, digits=30, **how):
    return solve(scene, arithmetic="ball", digits=digits, **how)


TIED = {"at-rest": Pair(1, "inf", 0, 1, b_static="1.5"), "without": Pair(1, 2, 0, 0), "slippery": Pair(1, 1, 0, "0.01")}
TIES = """
at-rest  0 | 1.5           | 0
at-rest  0 | 1.5 1         | 1
at-rest  0 | 1.5 -1        | 0
at-rest  0 | 2             | 1
without  1 | 0             | 0
without  1 | 0 1           | 1
without  1 | 0 -1          | -1
without  1 | 0 0 -1        | -1
slippery 0 | sine 1 1 1/3  | 1
slippery 0 | sine 1 1 -1/3 | -1
slippery 0 | sine 1 1 -7   | -1
"""
"""A pair and its speed; the coefficients of the force, or amplitude, frequency and phase of a sine; the mode."""


@pytest.mark.parametrize("row", TIES.strip().splitlines())
def test_a_tie_is_decided_by_the_first_derivative_of_the_load_and_a_sine_by_its_phase(row):
    """At static friction, without friction, and from rest."""
    (name, v), (kind, *numbers), (mode,) = map(str.split, row.split("|"))
    force = Force.sine(*numbers) if kind == "sine" else Force([Piece(0, (kind, *numbers))])
    assert run(Scene(TIED[name], State(v1=v, v2=v), "0.01", force=force)).signs == [int(mode)]


def test_long_sticks_on_a_belt_and_under_every_signal_are_gone_through_at_once():
    still, shaken = scenes_in("long-sticks").values()
    assert run(still).status is Status.STUCK_FOR_EVER
    assert overlap(run(shaken, 40), run(shaken, 80))


@pytest.mark.parametrize(("a2", "way"), [("1e-900", "float64"), ("1e900", "float64"), ("1e900", "ball")])
def test_rates_out_of_all_proportion_are_refused_in_one_line(a2, way):
    """@example of a found fault: ZeroDivisionError."""
    scene = Scene(Pair(1, 1, a2, "0.05", a1=1), State(), 3, force=Force.sine("0.45", 5))
    with pytest.raises(NumericsError, match=r"\A.*\Z"):
        solve(scene, arithmetic=way)


def test_more_digits_than_a_float_has_decades_are_reached_at_once():
    """Beyond 308 digits what is rough is 0: it once ended Newton's method early, and no precision was enough."""
    scene = forced_scene("sine-stick-slip")
    few, many = (run(scene, n, max_digits=500) for n in (360, 400))
    with precision(2000):
        assert overlap(few, many)
        assert max(one.rad() for one in few.event_times) < arb("1e-355")


@reaching
@given(pairs(MODERATE, damped=None), st.data())
def test_a_force_of_zero_is_no_force(pair, data):
    """Two engines answer: that of the free pair, and that of every scene."""
    free = Scene(pair, data.draw(states(pair)), 2)
    forced = free.replace(force=Force((Piece(0), Piece(1))))
    try:
        assert overlap(*(run(scene, 15, max_events=30, max_digits=100) for scene in (free, forced)))
    except (EventUndecided, OutOfRange):
        raise LeftOut from None


def test_what_begins_at_a_tie_of_high_order_may_end_soon():
    """With u = 2 b + c t^2/2 - d t^3/6 and a soft spring a slip begins at once and ends at 4 c/d, nearly."""
    for arithmetic in ("ball", "float64"):
        found = solve(scenes_in("far-out")["it-slips-shortly-from-a-tie"], arithmetic=arithmetic)
        assert found.signs == [1, 0, -1]
        assert abs(float(found.event_times[0]) - 4 / 60) < 1e-7


def test_a_slip_that_ends_exactly_where_the_force_jumps_ends_by_itself():
    for how in ("reverses", "sticks"):
        assert solve(forced_scene(f"jump-at-contact-{how}")).events[0].cause == "guard"
