"""The page's solver, in headless Chromium: against `numerics.solve`, and against answers in 60 digits."""

from pathlib import Path

import pytest
from chromium import asked
from explored_scenes import FORCED_NAMES, SCENES, forced_scene

from numerics import solve
from paper_checks.explore.page import SOLVER, source

CLOSE = 1e-9
FAULTS = (
    ("start.V2 + s * t,", "start.V2 - s * t,"),
    ("rest = force.constant - s * r", "rest = force.constant - 1.001 * s * r"),
    ("if (start.leaves) list[2] = s;", "if (start.leaves) list[2] = 1.001 * s;"),
    ("side: found.which === 0 ? 1 : -1", "side: 1"),
    ("return Math.abs(p) < 1 ? STICK : side;", "return Math.abs(p) < 1.01 ? STICK : side;"),
    ("y[2] * y[2] + y[3] * y[3] <= 1;", "y[2] * y[2] + y[3] * y[3] <= 1.05;"),
    ("square * size < 1 - 1e-9", "square * size < 2"),
    ("h * (g2 / 2 - h * bound / 6)", "h * (g2 / 2 - h * bound / 60)"),
    ("fade * -Math.expm1(-2 * lean * t) / (2 * lean)", "fade * -Math.expm1(-2 * lean * t) / lean"),
    ("rate * side > 0 ? side", "rate * side > 0.5 ? side"),
    ("TOUCH = 1e-13", "TOUCH = 0"),
    ("TIE = 1e-13", "TIE = 1e-7"),
    ("- V - 2 * pair.zeta * p;", "- V;"),
    ("lean * t < 1e-9", "lean * t < 1e-4"),
    ("drive = Math.abs(of.sine.amplitude) * of.sine.omega ** 3", "drive = of.sine.amplitude * of.sine.omega ** 3"),
    ("size / rate * (fast", "size / rate * (1.0001 * fast"),
    ("re * sine - im", "re * sine + im"),
)
"""Changes of the program, each of which a comparison has to see."""


@pytest.fixture(scope="module")
def answers(whole, tmp_path_factory) -> dict:
    """What the page's solver says of every scene, and the first one of which it says something else with a fault."""
    program, scenes = source(SOLVER), [one.for_page() for one in SCENES]
    assert all(program.count(right) == 1 for right, _ in FAULTS)
    faulty = [program.replace(right, wrong) for right, wrong in FAULTS]
    question, folder = Path(__file__).with_name("solve.js"), tmp_path_factory.mktemp("solver")
    forced = [forced_scene(name)[0] for name in FORCED_NAMES]
    return asked(whole, question, folder, PROGRAM=program, SCENES=scenes, FAULTY=faulty, FORCED=forced)


def differs(found, run) -> bool:
    """Whether the page's answer has another itinerary, or a time or a final value that is off by more than CLOSE."""
    if not isinstance(found, dict) or found["modes"] != [mode.sign for mode in run.modes]:
        return True
    pairs = [*zip(found["times"][1:], run.event_times, strict=True), *zip(found["final"], run.final_state, strict=True)]
    return not all(abs(ours - float(theirs)) <= CLOSE * max(1, abs(float(theirs))) for ours, theirs in pairs)


def test_events_and_states_are_those_of_the_exact_integrator(answers):
    found = answers["right"][: len(SCENES)]
    assert not [scene for scene, one in zip(SCENES, found, strict=True) if differs(one, solve(scene.scene()))]
    assert sum(len(one["modes"]) for one in found) > 1900


@pytest.fixture(scope="module")
def forced() -> dict:
    return {name: forced_scene(name)[1] for name in FORCED_NAMES}


def is_off(found, right) -> bool:
    """Whether the page's answer has another itinerary, or an event that is off by more than CLOSE."""
    if not isinstance(found, dict) or found["modes"] != right.modes:
        return True
    return any(found["events"][n] != pytest.approx(row, rel=CLOSE, abs=CLOSE) for n, row in right.rows.items())


def test_under_a_force_the_events_are_those_of_60_digits(answers, forced):
    found = dict(zip(FORCED_NAMES, answers["right"][len(SCENES) :], strict=False))
    assert not [name for name in FORCED_NAMES if is_off(found[name], forced[name])]
    assert sum(len(one.rows) for one in forced.values()) > 150


def test_what_points_the_other_way_moves_the_other_way(answers, forced):
    """With a negative amplitude the bounds of derivatives were negative, and roots were stepped over."""
    found = dict(zip(FORCED_NAMES, answers["right"][-len(FORCED_NAMES) :], strict=True))
    assert not [name for name in FORCED_NAMES if is_off(found[name], forced[name].mirrored)]


@pytest.mark.parametrize("number", range(len(FAULTS)), ids=[wrong for _, wrong in FAULTS])
def test_a_fault_in_the_program_is_seen(answers, forced, number):
    place, found = answers["faulty"][number]
    if place < len(SCENES):
        assert differs(found, solve(SCENES[place].scene()))
        return
    rights = [*forced.values(), *(one.mirrored for one in forced.values())]
    assert is_off(found, rights[place - len(SCENES)])
