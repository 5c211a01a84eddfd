"""Damped scenes in float64: bounds that hold, energy that is accounted for, grazes and horizons called uncertain."""

import math
from fractions import Fraction
from itertools import pairwise
from random import Random

import pytest
from hypothesis import event, example, given
from reaching import LeftOut, reaching
from strategies import viscous_scenes

from numerics import Pair, Scene, State, solve
from numerics.arithmetic.ball import Ball
from numerics.audit.draws import KINDS
from numerics.errors import EventUndecided, NumericsError
from numerics.trajectory.run import run_scene

EVENTS = 20
EXACTLY_CRITICAL = [
    Scene(Pair(1, 1, 1, 1, a1=2), State(x1=1, v1=5), until=20),  # slip
    Scene(Pair(1, 1, 2, 1, a1=4), State("0.3", 2, 0, -3), until=20),  # stick
]


def in_float64(scene):
    return solve(scene, arithmetic="float64", max_events=EVENTS)


def excesses(scene, found):
    """How many times its bound each error is, against 60 digits of a scene."""
    truth, bounds = run_scene(scene, Ball(60), EVENTS), found.accuracy
    assert truth.event_kinds == found.event_kinds
    pairs = [*zip(found.event_times, truth.event_times, bounds.t, strict=True)]
    pairs += zip(found.event_states.T.ravel(), truth.event_states.T.ravel(), bounds.y.ravel(), strict=True)
    pairs += zip(found.final_state, truth.final_state, bounds.final, strict=True)
    pairs.append((found.final_energy, truth.final_energy, bounds.energy))
    pairs.append((found.final.w, truth.final.w, bounds.energy_excess))
    pairs.append((found.dissipated, truth.dissipated, bounds.dissipated))
    with truth.arithmetic.context():
        offs = [(float(abs(true - float(value)).upper()), float(bound)) for value, true, bound in pairs]
    return [off / bound if bound > 0.0 else math.inf * off if off else 0.0 for off, bound in offs]


@reaching
@given(viscous_scenes())
@example(EXACTLY_CRITICAL[0])
@example(EXACTLY_CRITICAL[1])
def test_the_bounds_hold(scene):
    try:
        ratios = excesses(scene, in_float64(scene))
    except NumericsError:
        raise LeftOut from None
    event("claimed")
    assert max(ratios) <= 1.0


@pytest.mark.parametrize("kind", KINDS)
def test_the_bounds_hold_at_the_extremes_of_the_audit(kind):
    random, claimed = Random(f"viscous {kind}"), 0
    for _ in range(30):
        scene = KINDS[kind](random)
        if scene.pair.a1 == 0:
            pair, damping = scene.pair, Fraction(10) ** random.randint(-8, 2)
            a1 = damping * Fraction(math.sqrt(pair.a2 * pair.mass))
            scene = Scene(
                Pair(pair.m1, pair.m2, pair.a2, pair.b, a1),
                scene.initial,
                scene.until,
                force=scene.force,
                friction=scene.friction,
            )
        try:
            ratios = excesses(scene, in_float64(scene))
        except NumericsError:
            continue
        claimed += 1
        assert max(ratios) <= 1.0, scene
    assert claimed > 0 or kind == "near critical"


def test_an_error_that_the_bounds_do_not_know_of_is_noticed():
    scene = Scene(Pair(2, 1, 3, 1, a1=1), State("-0.3", "1.1", 0, -3), until=20)
    moved = Scene(scene.pair, State("-0.3", Fraction(11, 10) * (1 + Fraction(1, 10**12)), 0, -3), until=20)
    assert max(excesses(scene, in_float64(scene))) <= 1.0
    assert max(excesses(scene, in_float64(moved))) > 1.0


@reaching
@given(viscous_scenes())
def test_what_is_lost_is_what_was_taken(scene):
    try:
        found = in_float64(scene)
    except NumericsError:
        raise LeftOut from None
    before, after, taken = float(scene.energy), found.final_energy, found.dissipated
    allowed = found.accuracy.energy + found.accuracy.dissipated
    assert abs(before - after - taken) <= allowed + 1e-15 * (abs(before) + abs(after) + taken)


def test_a_graze_is_called_uncertain():
    """Between two starts the guard of a slip just touches zero: next to it float64 may not claim either sequence."""
    pair = Pair(1, 1, 1, 1, a1="0.01")

    def scene(v1):
        return Scene(pair, State(-3, v1, 0, -20), until=100)

    def first_event(v1):
        return float(solve(scene(v1), arithmetic="ball", max_events=1).events[0].t.mid())

    starts = [Fraction(i, 16) for i in range(-64, 65)]
    low, high = next((a, b) for a, b in pairwise(starts) if abs(first_event(a) - first_event(b)) > 1)
    for v1 in (low, high):
        assert in_float64(scene(v1)).certain
    early, late = first_event(low), first_event(high)
    for _ in range(60):
        middle = (low + high) / 2
        time = first_event(middle)
        low, high = (middle, high) if abs(time - early) < abs(time - late) else (low, middle)
    for v1 in (low, high):
        with pytest.raises(EventUndecided):
            in_float64(scene(v1))


@pytest.mark.parametrize("event", [0, 1, 2])
def test_an_event_next_to_the_horizon_is_called_uncertain(event):
    pair, initial = Pair(2, 1, 3, 1, a1="0.1"), State("-0.3", "2.1", 0, -3)
    time = Fraction(in_float64(Scene(pair, initial, 20)).events[event].t)
    for sign in (-1, 0, 1):
        with pytest.raises(EventUndecided):
            in_float64(Scene(pair, initial, time * (1 + sign * Fraction(1, 10**17))))
    for sign in (-1, 1):
        assert in_float64(Scene(pair, initial, time * (1 + sign * Fraction(1, 10**9)))).certain
