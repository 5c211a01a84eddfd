"""The bounds of float64 and double-double against 100 digits in scenes of every kind; an error beyond them is seen."""

import math
from fractions import Fraction

import pytest
from hypothesis import event, example, given
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import driven_scenes, free_scenes, viscous_scenes

from numerics import EventUndecided, NumericsError, Pair, Scene, State, load_scene, solve
from numerics.arithmetic.ball import Ball
from numerics.trajectory.comparison import distance
from numerics.trajectory.run import run_scene

EVENTS = 20
FOUND = scenes_in("bounded")


def by_name(scene, arithmetic="float64"):
    return solve(scene, arithmetic=arithmetic, max_events=EVENTS)


def excesses(scene, found):
    """How many times its bound each error is, against 100 digits of a scene."""
    truth, bounds = run_scene(scene, Ball(100), EVENTS), found.accuracy
    assert truth.event_kinds == found.event_kinds
    pairs = [*zip(found.event_times, truth.event_times, bounds.t, strict=True)]
    pairs += zip(found.event_states.T.ravel(), truth.event_states.T.ravel(), bounds.y.ravel(), strict=True)
    pairs += zip(found.final_state, truth.final_state, bounds.final, strict=True)
    pairs.append((found.final_energy, truth.final_energy, bounds.energy))
    pairs.append((found.final.w, truth.final.w, bounds.energy_excess))
    pairs.append((found.dissipated, truth.dissipated, bounds.dissipated))
    with truth.arithmetic.context():
        offs = [(float(distance(value, true).lower()), float(bound)) for value, true, bound in pairs]
    return [off / bound if bound > 0.0 else math.inf * off if off else 0.0 for off, bound in offs]


def claimed(scene, arithmetic):
    try:
        found = by_name(scene, arithmetic)
        ratios = excesses(scene, found)
    except NumericsError:
        raise LeftOut from None
    if not found.certain:
        raise LeftOut
    event("claimed")
    return max(ratios)


@pytest.mark.parametrize("arithmetic", ["float64", "double-double"])
@pytest.mark.parametrize("kind", [free_scenes, viscous_scenes, driven_scenes], ids=lambda kind: kind.__name__)
def test_the_bounds_hold(kind, arithmetic):
    @reaching
    @given(kind())
    @example(FOUND["a-last-step-of-no-time"])
    @example(FOUND["all-but-at-rest"])
    @example(FOUND["critical-damping-in-slip"])
    @example(FOUND["critical-damping-in-stick"])
    @example(FOUND["far-and-slow"])
    @example(FOUND["late"])
    @example(FOUND["light-and-overdamped-driver"])
    @example(FOUND["balanced-by-a-force"])
    @example(FOUND["slow-from-the-edge"])
    @example(load_scene("relative-motion-b05"))
    def hold(scene):
        assert claimed(scene, arithmetic) <= 1.0

    hold()


def test_an_error_that_the_bounds_do_not_know_of_is_noticed():
    scene = Scene(Pair(2, 1, 3, 1, a1=1), State("-0.3", "1.1", 0, -3), until=20)
    moved = Scene(scene.pair, State("-0.3", Fraction(11, 10) * (1 + Fraction(1, 10**12)), 0, -3), until=20)
    assert max(excesses(scene, by_name(scene))) <= 1.0
    assert max(excesses(scene, by_name(moved))) > 1.0


@pytest.mark.parametrize("event", [0, 1, 2])
def test_an_event_next_to_the_horizon_is_called_uncertain(event):
    pair, initial = Pair(2, 1, 3, 1, a1="0.1"), State("-0.3", "2.1", 0, -3)
    time = Fraction(by_name(Scene(pair, initial, 20)).events[event].t)
    for sign in (-1, 0, 1):
        with pytest.raises(EventUndecided):
            by_name(Scene(pair, initial, time * (1 + sign * Fraction(1, 10**17))))
    for sign in (-1, 1):
        assert by_name(Scene(pair, initial, time * (1 + sign * Fraction(1, 10**9)))).certain
