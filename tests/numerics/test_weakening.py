"""Friction that depends on the state: whether it is the motion, across digits, at ties, and what is refused."""

from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from hypothesis import given
from inclusion import motion, overlap
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import weakened_scenes

from numerics import (
    EventUndecided,
    Force,
    Friction,
    OutOfRange,
    Pair,
    Scene,
    State,
    Weakening,
    solve,
)
from numerics.linear.enclosed import EnclosedRun
from numerics.trajectory.curve import sampled

mpl.use("Agg")

PAIR = Pair(1, 1, 200, "0.5")
FALLING = Weakening([("0.05", "0.3")], "0.4")
BY_PLACE = Weakening([("0.05", "0.3")], "0.4", [("-0.02", "-0.1"), (0, 0), ("0.02", "0.1")])


def weakened(weakening: Weakening, until: object = 2, force: Force | None = None, **at: object) -> Scene:
    """The pair of these tests with a friction of the state."""
    return Scene(PAIR, State(**at), until, force=force or Force(), friction=Friction((), weakening))


SCENES, BALLS = scenes_in("weakened"), scenes_in("followed-in-balls")
BISTABLE, JUMPING = SCENES["bistable"], SCENES["jumping"]


ON_A_KNOT = {
    "of speed, above it": weakened(FALLING, v1="0.05"),
    "of speed, below it": weakened(FALLING, x1="-0.1", v1="0.05"),
    "of speed and of the load": weakened(FALLING, x1="-0.01", v1="0.05"),
    "of place": weakened(BY_PLACE, x1="0.02", v1="0.3"),
    "of place, of body 2": weakened(BY_PLACE, v2="0.3"),
    "of place, in a stick": weakened(BY_PLACE, 3, Force.sine(2, 5), x2="0.02", x1="0.02"),
    "of neither, but at no rational speed: |w| = 0.3 - 0.2 sin 1": Scene(
        Pair(1, "inf", 20, 3),
        State("0.02", "0.3"),
        until=2,
        friction=Friction((), Weakening([("0.1", 2), (1, "2.2")], place=[("-0.1", "-0.2"), ("0.5", "0.4")])),
        belt=Force.sine("0.2", 3, 1),
    ),
}


@pytest.mark.parametrize("scene", [weakened(BY_PLACE, 1, v1="0.5"), *SCENES.values(), *ON_A_KNOT.values()])
def test_what_is_found_is_the_motion(scene: Scene):
    assert motion(scene).success


@reaching
@given(weakened_scenes())
def test_a_table_that_says_nothing_changes_nothing(scene: Scene):
    try:
        one, two = (
            solve(replace(scene, friction=Friction(scene.friction.steps, table)), arithmetic="ball", digits=40)
            for table in (None, Weakening())
        )
    except (EventUndecided, OutOfRange):  # so many digits do not tell what comes
        raise LeftOut from None
    assert overlap(one, two)


def test_crossings_of_knots_are_no_events_and_everything_else_reads_the_run():
    run = solve(JUMPING, digits=20)
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
    solve(Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 1, friction=Friction(weakening=weakening)), digits=15)
    assert len(bounds) > 4
    assert min(bounds) > 0


def test_a_steep_fall_is_solved():
    steep = solve(weakened(Weakening([("0.00002", "0.3")], "0.4"), v1="0.3"), arithmetic="ball", digits=24)
    assert steep.success


@pytest.mark.parametrize("scene", [*SCENES.values(), *BALLS.values(), *ON_A_KNOT.values()])
def test_float64_follows_them_as_balls_do(scene):
    run = solve(scene)
    assert (run.arithmetic.name, run.tried) == ("float64", "")
    assert run.right_digits > 8
    assert run.check().right
