"""Whole runs of the kernel whose starts are off by far more than rounding, and of every signal: true, or in doubt."""

from contextlib import suppress
from fractions import Fraction
from random import Random

import numpy as np
import pytest
from draws import brought
from hypothesis import given
from kernel_runs import BOUNDS, STATE, a_scene, a_weakened_scene, errors, in_stick, moved, run
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import grazes

from numerics import EventUndecided, OutOfRange, Pair, Scene, Signal, State, solve
from numerics.arithmetic.compiled import can_compile
from numerics.linear.record import AT, How
from numerics.trajectory.status import Status

OURS = 1e-13
"""What both runs of a comparison round, relative to 1."""
RUNS, BROUGHT, SHARP = (200, 10, 0.4) if can_compile() else (30, 6, 0.3)
TAKEN = slice(AT["friction"], AT["ledger_error"])


def quotients(one, two):
    """Differences over the first run's bounds: of (t, x1, v1, x2, v2) at events, the end's state, the ledger."""
    assert one.modes == two.modes

    def over(a, b, bounds):
        return np.maximum(0, abs(a - b) - OURS * (1 + abs(a))) / np.maximum(bounds, 1e-300)

    late = over(one.times, two.times, one.events[:, BOUNDS[0]])
    at_events = over(one.events[:, STATE], two.events[:, STATE], one.events[:, BOUNDS[1:]])
    end = over(one.end[STATE], two.end[STATE], one.end[BOUNDS[1:]])
    taken = over(one.end[TAKEN], two.end[TAKEN], one.end[AT["ledger_error"]] + two.end[AT["ledger_error"]])
    return np.hstack([np.column_stack([late, at_events]).max(0, initial=0), end, taken.max()])


@pytest.mark.parametrize(("drawn", "seed", "share"), [(a_scene, 17, 0.8), (a_weakened_scene, 18, 0.6)])
def test_who_begins_within_the_errors_keeps_within_the_bounds_which_are_sharp(drawn, seed, share):
    """Or the run is in doubt. Without new digits of the second run: it is off by rounding alone."""
    random, largest, compared = np.random.default_rng(seed), np.zeros(10), 0
    for _ in range(RUNS):
        scene = drawn(random)
        by = errors(random, scene)
        one = run(scene, by)
        if one.modes is None:
            continue
        corner = random.choice([-1, 1], 4) if random.random() < 0.7 else random.uniform(-1, 1, 4)
        found = quotients(one, run(moved(scene, in_stick(scene, corner * np.array(by, float)))))
        assert found.max() <= 1, (found, scene, by)
        largest, compared = np.maximum(largest, found), compared + 1
    assert compared > share * RUNS
    assert (largest[:9] > SHARP).all()


@pytest.mark.parametrize("side", [1, -1])
def test_a_belt_may_have_given_other_power_until_a_late_contact(side):
    """Until then it gives 1 W, from then on 0.1 W."""
    scene = Scene(Pair(1, "inf", 1, 1), State(v1="0.9"), "0.115", belt=Signal.constant(1))
    by = (0, Fraction(side, 1000), 0, 0)
    assert quotients(run(scene, by), run(moved(scene, by))).max() <= 1


# long sticks


CALM, LOUD = scenes_in("calm"), scenes_in("loud")


@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
@pytest.mark.parametrize("scene", [*CALM.values(), *LOUD.values()])
def test_a_stick_is_for_ever_where_the_load_stays_below_b_and_not_where_it_comes_to_exceed_it(scene, arithmetic):
    """@example of a fault that survived: half of the steady load of a force that grows as t^2."""
    status = None
    with suppress(EventUndecided):
        status = solve(scene, arithmetic=arithmetic, max_events=1).status
    assert (status is Status.STUCK_FOR_EVER) is (scene in CALM.values())


def test_a_planted_error_that_may_reach_b_ends_a_calm_stick():
    scene = CALM["a-sine"]
    assert [run(scene, (0, size, 0, size)).how == How.STUCK for size in (1e-8, 1e-5)] == [True, False]


# against balls


def is_decided(scene, **how):
    """Whether float64 decides a scene; then every number is within its bound, by balls."""
    with suppress(EventUndecided, OutOfRange):
        found = solve(scene, max_events=60, **how or {"arithmetic": "float64"})
        assert not found.certain or found.check().right, scene
        return found.certain
    return False


def test_scenes_of_new_kinds_are_those_of_balls_within_their_bounds():
    scenes = [scene for one in range(BROUGHT) if (scene := brought(Random(one))).pair.b]
    assert sum(map(is_decided, scenes)) > 0.7 * len(scenes)


@pytest.mark.parametrize("scene", [*CALM.values(), *scenes_in("belts").values()])
def test_a_belt_that_cancels_and_a_long_stick_are_those_of_balls(scene):
    """@example of found faults: v2 off by three times its bound at an event, and a belt's terms left out of w."""
    assert is_decided(scene)


@pytest.mark.parametrize(("name", "scene"), scenes_in("certain-and-wrong").items())
def test_what_was_certain_and_wrong_is_right_or_in_doubt(name, scene):
    is_decided(scene)
    assert is_decided(scene, digits=12)


@reaching
@given(grazes())
def test_a_graze_is_decided_rightly_or_not_at_all(scene):
    if not is_decided(scene):
        raise LeftOut
