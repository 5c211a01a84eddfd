"""Scenes of all five signals in balls: values of an independent solver, closed forms, ties, long sticks."""

import json
from fractions import Fraction

import pytest
from inclusion import overlap
from scene_files import FOLDER, scenes_in
from scipy_reference import require

from numerics import Force, Pair, Piece, Scene, Sine, State, solve
from numerics.arithmetic.ball import Ball
from numerics.trajectory.status import Status

SCENES = scenes_in("signals")
RIGHT = json.loads((FOLDER / "signals" / "answers.json").read_text())
"""By scipy_reference.py: the first mode; of each event the time, the mode that follows, the state; the last state."""


def run(scene, digits=30):
    return solve(scene, arithmetic="ball", digits=digits)


@pytest.mark.parametrize("name", SCENES)
def test_events_and_states_are_the_right_ones(name):
    one, two = run(SCENES[name]), run(SCENES[name], 60)
    require(one, RIGHT[name], 1e-10)
    assert overlap(one, two)


def test_newmarks_block_slides_as_far_as_he_says():
    """Under a pulse A m for t0, friction mu m: (A - mu) t0^2/2 and then v0^2/(2 mu) further, v0 = (A - mu) t0."""
    found = run(SCENES["newmark-block"])
    A, mu, t0 = 4, 2, Fraction(1, 2)
    v0 = (A - mu) * t0
    (stop,) = found.event_times
    assert stop.overlaps(Ball.number(t0 + v0 / mu))
    assert found.final.x1.overlaps(Ball.number(v0 * t0 / 2 + v0**2 / (2 * mu)))
    assert found.final.v1.contains(0)
    assert found.status is Status.STUCK_FOR_EVER


@pytest.mark.parametrize(("pulls", "follows"), [(("1.5",), 0), (("1.5", 1), 1), (("1.5", -1), 0), ((2,), 1)])
def test_a_tie_at_static_friction_is_decided_by_the_first_derivative(pulls, follows):
    scene = Scene(Pair(1, "inf", 0, 1, b_static="1.5"), State(), 1, force=Force([Piece(0, pulls)]))
    assert run(scene).signs == [follows]


@pytest.mark.parametrize(("load", "modes"), [((), [0]), ((0, 1), [1]), ((0, -1), [-1]), ((0, 0, -1), [-1])])
def test_without_friction_nothing_sticks_but_what_bears_no_load(load, modes):
    assert run(Scene(Pair(1, 2, 0, 0), State(v1=1, v2=1), 1, force=Force([Piece(0, load)]))).signs == modes


@pytest.mark.parametrize("phase", ["1/3", "-1/3", -7])
def test_a_sine_pushes_to_the_side_of_its_phase(phase):
    push = Force([Piece(0, (), [Sine(1, 1, phase)])])
    assert run(Scene(Pair(1, 1, 0, "0.01"), State(), "0.01", force=push)).signs == [1 if phase == "1/3" else -1]


def test_a_belt_that_jumps_ends_a_stick_and_may_reverse_a_slip():
    belt = Force([Piece(0), Piece(1, ("0.5",)), Piece("1.01", ("-0.5",)), Piece("1.02", ("-0.5",), ())])
    found = run(Scene(Pair(1, "inf", 10, 1), State(), 2, belt=belt))
    assert found.signs == [0, -1, 1]
    assert found.floats(found.event_times).tolist() == [1, 1.01]
    assert [one.cause for one in found.events] == ["jump", "jump"]


def test_long_sticks_on_a_belt_and_under_every_signal_are_gone_through_at_once():
    still = Scene(Pair(1, "inf", 30, 1, "0.1", b_static="1.6"), State("0.01", "0.1"), 10**9)
    assert run(still).status is Status.STUCK_FOR_EVER
    wall, pull = Force([Piece(0, (), [Sine("0.01", 40)])]), Force([Piece(0, (1,), [Sine("0.1", 3)])])
    shaken = Scene(Pair(1, 2, 30, 1, "0.1"), State("0.01", "0.1"), 10**6, force_2=pull, wall=wall)
    assert overlap(run(shaken, 40), run(shaken, 80))
