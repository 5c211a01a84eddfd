"""The page's solver, in headless Chromium, against `numerics.solve`, which test_oracle.py holds against 60 digits."""

from dataclasses import asdict
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from chromium import faults, planted
from scene_files import mirrored
from sixty_digits import forced_scene

from numerics import Force, Pair, Piece, Scene, Sine, State, solve
from paper_checks.explore.page import SOLVER, source
from paper_checks.explore.scenes import reduced

CLOSE = 5e-10
FAULTS = faults("solver")
FORCED = """constant-force huge-omega mass-ratio-1e-6 mass-ratio-1e6 near-resonance-in-stick resonance-in-slip
resonance-in-slip-damped resonance-in-stick sine-at-threshold sine-at-threshold-damped
sine-barely-below-threshold sine-below-threshold sine-below-threshold-damped sine-just-above-threshold
sine-just-below-threshold sine-non-stop sine-stick-slip"""
"""Scenes under a constant or a sine (tests/forced). Left out: forces of 1e9 b and more, where binary64 has few digits,
and one that is above the threshold by 1e-20."""


def scene_of(ratio, zeta, X, V1, V2, constant=0, amplitude=0, omega=1, law="filippov"):
    """The pair with L = Omega = M = 1: its SI numbers are the reduced ones. The force is over b."""
    ratio, zeta, constant, amplitude = map(Fraction, (ratio, zeta, constant, amplitude))
    q = ratio / (1 + ratio)
    pair = Pair(q, 1 - q, 1, 1 - q, 2 * zeta)
    force = Force([Piece(0, [pair.b * constant], [Sine(pair.b * amplitude, omega)])])
    return Scene(pair, State(X, V1, 0, V2), 40, law, force=force if constant or amplitude else Force())


@pytest.fixture(scope="module")
def scenes():
    lines = Path(__file__).with_name("explored.txt").read_text("utf-8").splitlines()
    forced = [*map(forced_scene, FORCED.split())]
    return [*(scene_of(*line.split()) for line in lines if line[0] != "#"), *forced, *map(mirrored, forced)]


@pytest.fixture(scope="module")
def rights(scenes):
    return [*map(solve, scenes)]


@pytest.fixture(scope="module")
def answers(ask, scenes) -> dict:
    """What the page's solver says of every scene, and the first one of which it says something else with a fault."""
    program, given = source(SOLVER), [asdict(reduced(one)) for one in scenes]
    return ask("solve", PROGRAM=program, SCENES=given, FAULTY=planted(program, FAULTS))


def is_off(found, right):
    """Whether the page's answer has another itinerary, or an event or a final state off by more than CLOSE."""
    if not isinstance(found, dict) or found["modes"] != right.signs:
        return True
    length, rate, _ = right.floats(list(right.units))
    speed, (x1, v1, *_) = length * rate, right.floats(right.event_states)
    events = np.column_stack([right.floats(right.event_times) * rate, x1 / length, v1 / speed])
    final = right.floats(list(right.final_state)) / [length, speed, length, speed]
    said = [*(number for event in found["events"] for number in event), *found["final"]]
    return not np.allclose(said, [*events.ravel(), *final], rtol=CLOSE, atol=CLOSE)


def test_events_are_those_of_the_exact_integrator_also_mirrored(answers, rights):
    """With a negative amplitude the bounds of derivatives were negative, and roots were stepped over."""
    assert not [
        n for n, (found, right) in enumerate(zip(answers["right"], rights, strict=True)) if is_off(found, right)
    ]
    assert sum(len(one.row_times) for one in rights) > 2200


@pytest.mark.parametrize("number", range(len(FAULTS)), ids=[wrong for _, wrong in FAULTS])
def test_a_fault_in_the_program_is_seen(answers, rights, number):
    place, found = answers["faulty"][number]
    assert is_off(found, rights[place])
