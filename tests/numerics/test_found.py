"""Faults that were found once, by search or by a hostile reader; and at the extremes nothing comes but typed errors.

Ties through square roots, nearly critical damping, motions that have died away, events on the horizon.
"""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scene_files import scenes_in
from strategies import EXTREME, scenes
from three_scenes import PAPER

from numerics import (
    NumericsError,
    OutOfRange,
    PlanePair,
    PlaneScene,
    State,
    solve,
    solve_many,
)
from numerics.control.response import response
from numerics.trajectory.comparison import require_same_sequence
from numerics.trajectory.run import free_scene

FAR_OUT = scenes_in("far-out")


@given(scenes(EXTREME, None, (-12, 12)), st.sampled_from(["float64", "ball"]))
def test_nothing_but_typed_errors(scene, arithmetic):
    try:
        trajectory = solve(scene, arithmetic=arithmetic, max_events=20, max_digits=400)
    except NumericsError:
        return
    assert len(trajectory.events) <= 20


@pytest.mark.parametrize("scene", scenes_in("lost").values(), ids=scenes_in("lost"))
def test_no_event_is_lost_in_any_arithmetic(scene):
    balls = solve(scene, digits=20, arithmetic="ball")
    for arithmetic in ("float64", *["mpmath"] * free_scene(scene)):
        points = solve(scene, arithmetic=arithmetic)
        assert points.certain
        require_same_sequence(points, balls)


@pytest.mark.parametrize("scene", scenes_in("no-ties").values())
def test_a_zero_through_square_roots_is_no_tie(scene):
    balls, at = solve(scene, digits=30, arithmetic="ball"), scene.initial
    require_same_sequence(solve(scene), balls)
    nudged = State(at.x1, at.v1, at.x2, at.v2 + scene.pair.half_width / 10**30) if at.v1 != at.v2 else at
    require_same_sequence(solve(scene.replace(initial=nudged)), balls)


def test_energies_below_the_normal_numbers_have_no_digits_to_claim():
    assert solve(FAR_OUT["energies-below-the-normal-numbers"], digits=8).arithmetic.name != "float64"
    assert solve_many(1, 1, 1, 1e-158, v1=3e-158, until=4).dissipated_error > 0


def test_a_slip_of_many_turns_costs_no_digits():
    """Balls found its end to few digits, and needed 1152."""
    found = solve(FAR_OUT["a-slip-of-1e9-radians"], digits=300)
    assert found.arithmetic.digits < 400


def test_exponents_that_differ_by_many_magnitudes_are_told_apart():
    """A rotating force of 1e9 rad/s: the roots were sought at one precision, and flint's words came through."""
    found = response(PlaneScene(PlanePair(1, 1, 200, "0.5", 1), 1), amplitude=1, omega="1e9")
    assert [float(one.real) < 0 for one in found.exponents] == [True] * 6


def test_a_phase_lost_before_the_horizon_is_said():
    """Fig. 3's pair below E_cr: stuck for ever, but where on its orbit after 1e23 rad, or 1e17?"""
    scene, how = PAPER.replace(x1="0.003", v1="0.02", v2="-0.01", until="1e22"), {"arithmetic": "mpmath", "digits": 5}
    with pytest.raises(OutOfRange, match="ball"):
        solve(scene, arithmetic="float64")
    run, truth = solve(scene, **how), solve(scene, digits=15, arithmetic="ball")
    sooner, soon = (solve(scene.replace(until=until), **how) for until in (10**16, 5))
    said = ["keep no phase" in one.message for one in (run, truth, sooner, soon)]
    assert said == [True, False, True, False]
    assert float(run.reduced.final.w) == pytest.approx(truth.floats(truth.reduced.final.w), rel=1e-12)


@pytest.mark.parametrize("a1", ["1e-24", "1e-18"])
def test_a_damped_slip_of_1e22_radians_is_solved_in_balls(a1):
    """Also where it has died away. In one a float of the wait and its bound agree long before the wait is over."""
    scene = FAR_OUT["a-damped-slip-of-1e22-radians"].replace(a1=a1)
    balls, found = solve(scene, digits=30, arithmetic="ball", max_events=3), solve(scene, max_events=3)
    assert (found.modes, found.arithmetic.name) == (balls.modes, "ball")
    assert found.y[0, 0].overlaps(balls.y[0, 0])
