"""A body on a spring, without a damper, on a belt or on the ground: what is exactly on an edge is decided exactly."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given
from inclusion import motion
from scene_files import scenes_in
from strategies import starts_by_the_edge

from numerics import Force, Pair, Scene, State, solve
from numerics.linear.modes import Mode
from numerics.trajectory.status import Status

M1, A2, B = Fraction(2), Fraction(50), Fraction(4)
OMEGA, EDGE = 5.0, B / A2


def on_the_ground(start, **more):
    return Scene(Pair(m1=M1, m2="inf", a2=A2, b=B, **more), State(x1=start), until=20)


def half_swings(start, held):
    """Return where body 1 turns, until it is held: each swing is about the edge on its side."""
    places = [start]
    while abs(places[-1]) > held:
        places.append((2 * EDGE if places[-1] > 0 else -2 * EDGE) - places[-1])
    return places


@given(starts_by_the_edge())
@example(Fraction(5))
@example(Fraction(3))
@example(Fraction(-7))
@example(Fraction(1))
@example(Fraction(11, 2))
def test_on_the_ground_it_turns_and_rests_where_the_half_swings_end(ratio):
    """At an odd multiple of the edge it comes to rest exactly on the edge, where friction just holds it."""
    places = half_swings(ratio * EDGE, EDGE)
    run = solve(on_the_ground(ratio * EDGE), digits=20)
    assert [float(one) for one in run.event_times] == pytest.approx(np.pi / OMEGA * np.arange(1, len(places)))
    assert [float(one.y[0]) for one in run.events] == pytest.approx([float(one) for one in places[1:]], abs=1e-15)
    assert (run.status, run.final_mode) == (Status.STUCK_FOR_EVER, Mode.STICK)
    assert float(run.final.x1) == pytest.approx(float(places[-1]), abs=1e-15)


def test_static_friction_holds_what_comes_to_rest_exactly_at_its_limit():
    run = solve(on_the_ground(5 * EDGE, b_static=3 * B), digits=20)
    assert float(run.final.x1) == pytest.approx(float(-3 * EDGE))
    assert run.status is Status.STUCK_FOR_EVER


@pytest.mark.parametrize("scene", scenes_in("cycles").values())
def test_a_cycle_that_only_touches_the_speed_of_the_belt_goes_on(scene):
    """After its exit it is a circle of the belt's speed about the edge, without another event.

    So if the wall moves, and if a force grows at a constant rate.
    """
    run = motion(scene)
    assert run.success
    assert run.modes[-1] is (Mode.SLIP_MINUS if scene.belt.pieces else Mode.SLIP_PLUS)
    assert float(run.event_times[-1]) < 1


def test_a_force_that_grows_as_the_wall_draws_back_lets_the_body_rest():
    """It starts at the edge, and the load stays as it is."""
    scene = on_the_ground(-EDGE).replace(until=10, force=Force.ramp(0, 10, 150), wall=Force.ramp(0, 10, -3))
    run = solve(scene, digits=20)
    assert (run.events, run.final_mode) == ((), Mode.STICK)


@pytest.mark.parametrize(("speed", "then"), [("0.32", []), ("0.321", []), ("1", []), ("0.3199", ["stick", "slip-"])])
def test_a_swing_that_just_reaches_the_speed_of_the_belt_or_does_not_goes_on(speed, then):
    """From rest it swings about the edge b/a2, at most at omega b/a2 = 0.32 m/s: a slower belt catches it."""
    run = motion(on_the_ground(0).replace(b="3.2", until=10, belt=Force.step(0, speed)))
    assert (run.success, [one.after for one in run.events]) == (True, then)
