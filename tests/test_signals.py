"""Scenes of all five signals in balls: values of an independent solver, closed forms, drawn scenes, boxes of starts."""

import json
import random
from fractions import Fraction
from pathlib import Path

import pytest
from enclosed_runs import events, numbers, run, same
from flint import arb
from scene_files import scenes_in
from signals_reference import follow

from numerics import EventUndecided, Force, Friction, Pair, Piece, Scene, Sine, State
from numerics.arithmetic.ball import Ball
from numerics.control.orbit import Box
from numerics.linear.record import How

SCENES = scenes_in("signals")
RIGHT = json.loads((Path(__file__).parent / "scenes" / "signals" / "answers.json").read_text())
"""By signals_reference.py: the first mode; of each event the time, the mode that follows, the state; the last state."""


def right(scene, record, answer, within):
    """Whether events and states are those of an answer."""
    first, known, final = answer
    ours = [[row.mode, *(float(one) for one in numbers(scene, row))] for row in events(record)]
    last = [float(one) for one in numbers(scene, record.end)[1:]]
    assert [record.rows[0].mode, *(one[0] for one in ours)] == [first, *(mode for _, mode, _ in known)]
    for (_, *found), (t, _, state) in zip(ours, known, strict=True):
        assert found == pytest.approx([t, *state], abs=within)
    assert last == pytest.approx(final, abs=within)
    return True


@pytest.mark.parametrize("name", SCENES)
def test_events_and_states_are_the_right_ones(name):
    scene = SCENES[name]
    one, two = run(scene, 30), run(scene, 60)
    assert right(scene, one, RIGHT[name], 1e-10)
    assert same((scene, one), (scene, two))


def test_the_right_values_are_those_of_the_reference():
    for name in ("belt-and-wall", "no-spring"):
        assert right(SCENES[name], run(SCENES[name], 30), follow(SCENES[name]), 1e-10)


def test_newmarks_block_slides_as_far_as_he_says():
    """Under a pulse A m for t0, friction mu m: (A - mu) t0^2/2 and then v0^2/(2 mu) further, v0 = (A - mu) t0."""
    scene = SCENES["newmark-block"]
    found = run(scene, 30)
    A, mu, t0 = 4, 2, Fraction(1, 2)
    v0 = (A - mu) * t0
    (stop,) = events(found)
    assert numbers(scene, stop)[0].overlaps(Ball.number(t0 + v0 / mu))
    assert found.end.x1.overlaps(Ball.number(v0 * t0 / 2 + v0**2 / (2 * mu)))
    assert found.end.v1.contains(0)
    assert found.how is How.STUCK


def test_a_block_on_a_belt_sticks_until_its_spring_bears_static_friction_and_slips_with_the_kinetic_one():
    """a1 = 0: from stick at x = b_s/a2 on it swings about b/a2 and sticks again at the mirrored place."""
    a2, b, most, c = 30, 1, Fraction(3, 2), Fraction(1, 10)
    scene = Scene(Pair(1, "inf", a2, b, b_static=most), State(v1=c), 6, belt=Force([Piece(0, (c,))]))
    leaves, sticks, again = events(run(scene, 40, 3))
    assert [leaves.mode, leaves.order, sticks.mode, again.mode] == [-1, 1, 0, -1]
    assert numbers(scene, leaves)[0].overlaps(Ball.number(most / a2 / c))
    assert sticks.x1.overlaps(Ball.number(2 * b / Fraction(a2) - most / a2))
    omega = Ball.number(a2).sqrt()
    angle = arb.pi() - (Ball.number((most - b) / a2) * omega / Ball.number(c)).atan()
    assert (numbers(scene, sticks)[0] - numbers(scene, leaves)[0] - 2 * angle / omega).contains(0)


@pytest.mark.parametrize(("pulls", "follows"), [(("1.5",), 0), (("1.5", 1), 1), (("1.5", -1), 0), ((2,), 1)])
def test_a_tie_at_static_friction_is_decided_by_the_first_derivative(pulls, follows):
    """It slips at once with a rate of its own, b_s - b."""
    scene = Scene(Pair(1, "inf", 0, 1, b_static="1.5"), State(), 1, force=Force([Piece(0, pulls)]))
    found = run(scene, 40)
    assert (found.rows[0].mode, found.rows[0].order) == (follows, 1 if follows else found.rows[0].order)


@pytest.mark.parametrize(("load", "modes"), [((), [0]), ((0, 1), [1]), ((0, -1), [-1]), ((0, 0, -1), [-1])])
def test_without_friction_nothing_sticks_but_what_bears_no_load(load, modes):
    scene = Scene(Pair(1, 2, 0, 0), State(v1=1, v2=1), 1, force=Force([Piece(0, load)]))
    assert [row.mode for row in run(scene, 40).rows] == modes


def test_a_belt_that_jumps_ends_a_stick_and_may_reverse_a_slip():
    belt = Force([Piece(0), Piece(1, ("0.5",)), Piece("1.01", ("-0.5",)), Piece("1.02", ("-0.5",), ())])
    scene = Scene(Pair(1, "inf", 10, 1), State(), 2, belt=belt)
    found = run(scene, 40)
    assert [(row.mode, row.event, row.jump) for row in found.rows[:4]] == [
        (0, False, True),
        (-1, True, True),
        (1, True, True),
        (1, False, True),
    ]


def test_long_sticks_on_a_belt_and_under_every_signal_are_gone_through_at_once():
    still = Scene(Pair(1, "inf", 30, 1, "0.1", b_static="1.6"), State("0.01", "0.1"), 10**9)
    assert run(still).how is How.STUCK
    wall, pull = Force([Piece(0, (), [Sine("0.01", 40)])]), Force([Piece(0, (1,), [Sine("0.1", 3)])])
    shaken = Scene(Pair(1, 2, 30, 1, "0.1"), State("0.01", "0.1"), 10**6, force_2=pull, wall=wall)
    assert same((shaken, run(shaken, 40)), (shaken, run(shaken, 80)))


def drawn(draw):
    """A scene with all that there is: ground or belt, no spring, static friction, b(t), forces, a wall."""

    def number(low, high):
        return Fraction(draw.randint(round(low * 1000), round(high * 1000)), 1000)

    def signal(size, most=3):
        starts = sorted({number(0.1, 3) if k else Fraction(0) for k in range(draw.randint(0, most))})
        sines = [[Sine(number(-size, size), number(0.5, 12), number(-3, 3))][: draw.randint(0, 1)] for _ in starts]
        terms = [[number(-size, size) for _ in range(draw.randint(0, 3))] for _ in starts]
        return Force([Piece(*one) for one in zip(starts, terms, sines, strict=True)])

    is_fixed, a1, b, none = draw.random() < 0.45, draw.choice([0, number(0.01, 5)]), number(0.1, 3), Force()
    static = b * number(1.05, 2) if draw.random() < 0.4 else None
    pair = Pair(number(0.2, 5), "inf" if is_fixed else number(0.2, 5), draw.choice([0, number(1, 200)]), b, a1, static)
    waves = Piece(0, (b,), [Sine(b * number(0.1, 0.9), number(0.5, 9), number(-3, 3))])
    friction = draw.choice([[], [waves], [(number(0.2, 1), draw.choice([0, number(0.1, 3)])), (2, number(0.1, 3))]])
    v = number(-1, 1)
    state = State(number(-0.3, 0.3), v, number(-0.3, 0.3), 0 if is_fixed else draw.choice([v, number(-1, 1)]))
    acting = {"force_2": none if is_fixed else signal(3), "belt": signal(0.5) if is_fixed else none}
    wall = signal(0.2, 1 if a1 else 3)
    return Scene(pair, state, 3, force=signal(6), friction=Friction(friction), wall=wall, **acting)


@pytest.mark.parametrize("seed", range(24))
def test_drawn_scenes_are_those_of_the_reference(seed):
    scene = drawn(random.Random(seed))
    found = run(scene, 30)
    assert right(scene, found, follow(scene), 1e-8)
    assert same((scene, found), (scene, run(scene, 60)))


def test_who_starts_within_a_box_stays_in_what_is_said_of_it():
    """From its corners; where more holds at rest, a motion that leaves a stick later parts from one that did not."""
    told = 0
    for seed in range(80):
        draw = random.Random(seed)
        scene, by = drawn(draw), Fraction(1, 10 ** draw.choice([3, 4, 6, 8]))
        x1, v1, x2, v2 = (by * draw.choice([-1, 1]) for _ in range(4))
        at, is_stuck = scene.initial, scene.initial.v1 == scene.initial.v2
        v1, v2 = (0 if is_stuck else v1, 0) if scene.pair.is_fixed else (v1, v1 if is_stuck else v2)
        start = State(at.x1 + x1, at.v1 + v1, at.x2 + x2, at.v2 + v2)
        other = Scene(
            scene.pair, start, 3, "filippov", scene.force, scene.friction, scene.force_2, scene.belt, scene.wall
        )
        try:
            wide = run(scene, 40, 12, lambda digits, by=by: Box(digits, Ball.number(by)))
            if not wide.rows[0].order:
                assert same((scene, wide), (other, run(other, 60, 12)))
                told += 1
        except EventUndecided:
            pass
    assert told > 50
