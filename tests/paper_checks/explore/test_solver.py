"""The page's solver, in headless Chromium: against `numerics.solve`, and against answers in 60 digits."""

import pytest
from chromium import faults, planted
from explored_scenes import FORCED_NAMES, SCENES, Answer, explored, for_page

from numerics import solve
from paper_checks.explore.page import SOLVER, source

CLOSE = 1e-9
FAULTS = faults("solver")


@pytest.fixture(scope="module")
def rights() -> list[Answer]:
    """What is right for each scene, for those under a force, and for what mirrors these."""
    forced = [explored(name)[1] for name in FORCED_NAMES]
    return [*(Answer.of(solve(scene)) for scene in SCENES), *forced, *(one.mirrored for one in forced)]


@pytest.fixture(scope="module")
def answers(ask) -> dict:
    """What the page's solver says of every scene, and the first one of which it says something else with a fault."""
    program, scenes = source(SOLVER), [*map(for_page, SCENES)]
    forced = [explored(name)[0] for name in FORCED_NAMES]
    return ask("solve", PROGRAM=program, SCENES=scenes, FAULTY=planted(program, FAULTS), FORCED=forced)


def is_off(found, right: Answer) -> bool:
    """Whether the page's answer has another itinerary, or an event or a final state off by more than CLOSE."""
    if not isinstance(found, dict) or found["modes"] != right.modes:
        return True
    rows = [*found["events"], found["final"]]
    return any(rows[n] != pytest.approx(row, rel=CLOSE, abs=CLOSE) for n, row in right.rows.items())


def test_events_are_those_of_the_exact_integrator_and_of_60_digits_also_mirrored(answers, rights):
    """With a negative amplitude the bounds of derivatives were negative, and roots were stepped over."""
    assert not [
        n for n, (found, right) in enumerate(zip(answers["right"], rights, strict=True)) if is_off(found, right)
    ]
    assert sum(len(one.rows) for one in rights) > 2200


@pytest.mark.parametrize("number", range(len(FAULTS)), ids=[wrong for _, wrong in FAULTS])
def test_a_fault_in_the_program_is_seen(answers, rights, number):
    place, found = answers["faulty"][number]
    assert is_off(found, rights[place])
