"""Damped scenes in float64: bounds that hold, energy that is accounted for, grazes and horizons called uncertain."""

import math
from fractions import Fraction
from itertools import pairwise
from random import Random

import pytest
from hypothesis import event, example, given, settings
from reaching import LeftOut, reaching
from strategies import viscous_scenes

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.audit.draws import KINDS
from numerics.errors import NumericsError
from numerics.run.one import run_scene
from numerics.scene import Pair, Scene, State

EVENTS = 20
EXACTLY_CRITICAL = [
    Scene(Pair(1, 1, 1, 1, a1=2), State(x1=1, v1=5), until=20),  # slip
    Scene(Pair(1, 1, 2, 1, a1=4), State("0.3", 2, 0, -3), until=20),  # stick
]
REDUCED = ("tau", "X", "V", "Z")


def solved(scene):
    try:
        return run_scene(scene, Float64(), EVENTS)
    except NumericsError:
        return None


def excesses(scene, found):
    """How many times its bound each error is, against 60 digits; None where nothing is claimed or known."""
    if found is None or not found.certain:
        return None
    try:
        truth = run_scene(scene, Ball(60), EVENTS)
    except NumericsError:
        return None
    assert truth.event_kinds == found.event_kinds
    pairs = []
    with truth.arithmetic.context():
        for number, bound in zip(REDUCED, ("late", "x", "v", "place"), strict=True):
            pairs += zip(
                found.record.numbers(number), found.record.codes(bound), truth.record.numbers(number), strict=True
            )
        for number, bound in (("X", "x"), ("V1", "v1"), ("V2", "v2"), ("Z", "place"), ("w", "w")):
            pairs.append((found.record.end(number), found.record.end_code(f"{bound}_error"), truth.record.end(number)))
        losses = [segment.losses(segment.length) for segment in truth.segments]
        for index, name in enumerate(("spent", "damped")):
            taken = sum((loss[index] for loss in losses), truth.arithmetic.number(0))
            pairs.append((found.record.end(name), found.record.end_code(f"{name}_error"), taken))
        offs = [(float(abs(true - float(value)).upper()), float(bound)) for value, bound, true in pairs]
    return [off / bound if bound > 0.0 else math.inf * off if off else 0.0 for off, bound in offs]


@given(viscous_scenes())
@example(EXACTLY_CRITICAL[0])
@example(EXACTLY_CRITICAL[1])
def test_the_bounds_hold(scene):
    ratios = excesses(scene, solved(scene))
    event("nothing claimed" if ratios is None else "claimed")
    assert max(ratios or [0.0]) <= 1.0


@pytest.mark.parametrize("kind", KINDS)
def test_the_bounds_hold_at_the_extremes_of_the_audit(kind):
    random, claimed = Random(f"viscous {kind}"), 0
    for _ in range(max(30, settings().max_examples // 5)):
        scene = KINDS[kind](random)
        if scene.pair.a1 == 0:
            pair, damping = scene.pair, Fraction(10) ** random.randint(-8, 2)
            a1 = damping * Fraction(math.sqrt(pair.a2 * pair.mass))
            scene = Scene(Pair(pair.m1, pair.m2, pair.a2, pair.b, a1), scene.initial, scene.until)
        ratios = excesses(scene, solved(scene))
        claimed += ratios is not None
        assert max(ratios or [0.0]) <= 1.0, scene
    assert claimed > 0 or kind == "near critical"


def test_an_error_that_the_bounds_do_not_know_of_is_noticed():
    scene = Scene(Pair(2, 1, 3, 1, a1=1), State("-0.3", "1.1", 0, -3), until=20)
    moved = Scene(scene.pair, State("-0.3", Fraction(11, 10) * (1 + Fraction(1, 10**12)), 0, -3), until=20)
    assert max(excesses(scene, solved(scene))) <= 1.0
    assert max(excesses(scene, solved(moved))) > 1.0


@reaching
@given(viscous_scenes())
def test_what_is_lost_is_what_was_taken(scene):
    found = solved(scene)
    if found is None or not found.certain:
        raise LeftOut
    record = found.record
    before, after, taken = record.end("w0"), record.end("w"), record.end("spent") + record.end("damped")
    allowed = sum(record.end_code(f"{name}_error") for name in ("w", "spent", "damped"))
    assert abs(before - after - taken) <= allowed + 1e-15 * (abs(before) + abs(after) + taken)


def test_a_graze_is_called_uncertain():
    """Between two starts the guard of a slip just touches zero: next to it no sequence may be called certain."""
    pair = Pair(1, 1, 1, 1, a1="0.01")

    def first_event(v1):
        found = run_scene(Scene(pair, State(-3, v1, 0, -20), until=100), Float64(), EVENTS)
        return found.record.number(0, "tau"), found.certain

    starts = [Fraction(i, 16) for i in range(-64, 65)]
    low, high = next((a, b) for a, b in pairwise(starts) if abs(first_event(a)[0] - first_event(b)[0]) > 1)
    assert first_event(low)[1]
    assert first_event(high)[1]
    for _ in range(60):
        middle = (low + high) / 2
        time = first_event(middle)[0]
        nearer_low = abs(time - first_event(low)[0]) < abs(time - first_event(high)[0])
        low, high = (middle, high) if nearer_low else (low, middle)
    assert not first_event(low)[1]
    assert not first_event(high)[1]


@pytest.mark.parametrize("event", [0, 1, 2])
def test_an_event_next_to_the_horizon_is_called_uncertain(event):
    pair, initial = Pair(2, 1, 3, 1, a1="0.1"), State("-0.3", "2.1", 0, -3)
    time = Fraction(run_scene(Scene(pair, initial, 20), Float64(), EVENTS).events[event].t)

    def certain(off):
        return run_scene(Scene(pair, initial, time * (1 + off)), Float64(), EVENTS).certain

    assert not any(certain(sign * Fraction(1, 10**17)) for sign in (-1, 0, 1))
    assert all(certain(sign * Fraction(1, 10**9)) for sign in (-1, 1))
