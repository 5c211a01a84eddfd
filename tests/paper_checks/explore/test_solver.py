"""The page's solver, in headless Chromium: against `numerics.solve`, and against answers in 60 digits."""

import pytest
from chromium import faults, planted
from explored_scenes import FORCED_NAMES, SCENES, explored, for_page

from numerics import solve
from paper_checks.explore.page import SOLVER, source

CLOSE = 1e-9
FAULTS = faults("solver")


@pytest.fixture(scope="module")
def answers(ask) -> dict:
    """What the page's solver says of every scene, and the first one of which it says something else with a fault."""
    program, scenes = source(SOLVER), [*map(for_page, SCENES)]
    forced = [explored(name)[0] for name in FORCED_NAMES]
    return ask("solve", PROGRAM=program, SCENES=scenes, FAULTY=planted(program, FAULTS), FORCED=forced)


def differs(found, run) -> bool:
    """Whether the page's answer has another itinerary, or a time or a final value that is off by more than CLOSE."""
    if not isinstance(found, dict) or found["modes"] != [mode.sign for mode in run.modes]:
        return True
    right = [float(one) for one in (*run.event_times, *run.final_state)]
    return [*found["times"][1:], *found["final"]] != pytest.approx(right, rel=CLOSE, abs=CLOSE)


def test_events_and_states_are_those_of_the_exact_integrator(answers):
    found = answers["right"][: len(SCENES)]
    assert not [scene for scene, one in zip(SCENES, found, strict=True) if differs(one, solve(scene))]
    assert sum(len(one["modes"]) for one in found) > 1900


@pytest.fixture(scope="module")
def forced() -> dict:
    return {name: explored(name)[1] for name in FORCED_NAMES}


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
        assert differs(found, solve(SCENES[place]))
        return
    rights = [*forced.values(), *(one.mirrored for one in forced.values())]
    assert is_off(found, rights[place - len(SCENES)])
