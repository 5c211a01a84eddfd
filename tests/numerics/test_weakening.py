"""Friction that depends on the state: whether it is the motion, across digits, and at ties."""

import numpy as np
import pytest
from hypothesis import given
from inclusion import motion, overlap
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import weakened_scenes
from three_scenes import PAPER

from numerics import (
    EventUndecided,
    Friction,
    OutOfRange,
    Pair,
    Scene,
    State,
    Weakening,
    solve,
)
from numerics.linear.cells import cells_of
from numerics.linear.enclosed import EnclosedRun
from numerics.linear.pieces import pieces_of
from numerics.trajectory.curve import sampled

SCENES, BALLS = scenes_in("weakened"), scenes_in("followed-in-balls")
ON_A_KNOT = [*scenes_in("on-a-knot").values(), scenes_in("belts")["at-an-irrational-speed"]]


@pytest.mark.parametrize("scene", [*SCENES.values(), *ON_A_KNOT])
def test_what_is_found_is_the_motion(scene: Scene):
    assert motion(scene).success


@reaching
@given(weakened_scenes())
def test_a_table_that_says_nothing_changes_nothing(scene: Scene):
    try:
        one, two = (
            solve(scene.replace(friction=Friction(scene.friction.steps, table)), arithmetic="ball", digits=40)
            for table in (None, Weakening())
        )
    except (EventUndecided, OutOfRange):  # so many digits do not tell what comes
        raise LeftOut from None
    assert overlap(one, two)


def test_crossings_of_knots_are_no_events_and_everything_else_reads_the_run():
    run = solve(SCENES["jumping"], digits=20)
    assert (run.arithmetic.name, run.tried) == ("ball", "20 are asked for")
    assert len(run.record.rows) > len(run.events) + 1
    assert all(event.before is not event.after for event in run.events)
    curve = sampled(run)
    assert np.isclose(curve.lost[0, -1], float(run.ledger.friction), rtol=1e-4)  # a sum over what is drawn


def test_a_knot_adds_to_the_errors_whether_friction_bends_up_or_down_behind_it(monkeypatch):
    """@example of a sign: the bound where it bends down was subtracted."""
    bounds, crossed = [], EnclosedRun.crossed
    monkeypatch.setattr(EnclosedRun, "crossed", lambda *given: (found := crossed(*given), bounds.append(found[1]))[0])
    weakening = Weakening(speed=[("0.02", "0.04"), ("0.1", "0.06")])
    solve(PAPER.replace(b="0.05", until=1, friction=Friction(weakening=weakening)), digits=15)
    assert len(bounds) > 4
    assert min(bounds) > 0


def test_a_steep_fall_is_solved():
    steep = SCENES["jumping"].replace(friction=Friction((), Weakening([("0.00002", "0.3")], "0.4")))
    assert solve(steep, arithmetic="ball", digits=24).success


def test_float64_follows_a_slope_whose_square_is_below_all_floats():
    run = solve(Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 1, friction=Friction((), Weakening((), "-1e-170"))))
    assert (run.arithmetic.name, run.tried) == ("float64", "")
    assert run.check().right


@pytest.mark.parametrize("scene", [*SCENES.values(), *BALLS.values(), *ON_A_KNOT])
def test_float64_follows_them_as_balls_do(scene):
    run = solve(scene)
    assert (run.arithmetic.name, run.tried) == ("float64", "")
    assert run.right_digits > 8
    assert run.check().right


def test_the_steepest_fall_and_pull_are_those_at_any_time():
    table = Weakening([("0.1", "0.3")], "0.1", [(0, 0), (1, "0.1")])
    scene = PAPER.replace(friction=Friction([(1, 2)], table))
    cells = cells_of(scene)
    found = [cells.branch(piece, 1, cell) for piece in pieces_of(scene) for _, cell in cells.all]
    assert (cells.falling, cells.pulling) == (-min(x.slope for x in found), max(abs(x.pull) for x in found))
