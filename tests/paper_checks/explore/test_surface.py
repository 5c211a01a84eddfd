"""The solver of the page's second tab, in headless Chromium, against `numerics.solve` on the scenes that it writes."""

import tomllib
from dataclasses import asdict, replace
from itertools import chain
from pathlib import Path

import pytest
from chromium import faults, planted

from numerics import PlanePair, solve
from numerics.control.rotating import rotating_response
from numerics.scene.file import load_scene, parse_scene
from paper_checks.explore.page import SOLVER, source
from paper_checks.explore.surfaces import OWN_SURFACES, ReducedSurface, reduced_surface

CLOSE = 1e-9
KEPT = tomllib.loads(Path(__file__).with_name("surfaces.toml").read_text("utf-8"))
SCENES = (
    *(replace(one.scene, until=min(6.0, one.scene.until)) for one in OWN_SURFACES),
    *(ReducedSurface(**{"until": 8} | one) for one in KEPT["scenes"]),
)
FAULTS = faults("surface")


@pytest.fixture(scope="module")
def answers(ask) -> dict:
    program, scenes = source((*SOLVER, "scene_file")), [asdict(one) for one in SCENES]
    return ask("solve_above", PROGRAM=program, SCENES=scenes, FAULTY=planted(program, FAULTS))


@pytest.fixture(scope="module")
def runs(answers) -> list:
    return [solve(parse_scene(one["file"])) for one in answers["right"]]


def differs(found, run) -> bool:
    """Whether the page's answer has another itinerary, or a time or a final value that is off by more than CLOSE."""
    if not isinstance(found, dict) or found["modes"] != [*run.modes]:
        return True
    right = [float(one) for one in chain(run.event_times, *run.final_state)]
    return [*chain(found["times"], *found["final"])] != pytest.approx(right, rel=CLOSE, abs=CLOSE)


def test_events_and_states_are_those_of_numerics(answers, runs):
    found = answers["right"]
    assert not [scene for scene, one, run in zip(SCENES, found, runs, strict=True) if differs(one, run)]
    assert sum(len(one["modes"]) for one in found) > 45


@pytest.mark.parametrize("number", range(len(FAULTS)), ids=[wrong for _, wrong in FAULTS])
def test_a_fault_in_the_program_is_seen(answers, runs, number):
    scene, found = answers["faulty"][number]
    assert differs(found, runs[scene])


def test_a_force_that_goes_round_is_answered_as_in_closed_form(answers):
    turning = [(one, found["turning"]) for one, found in zip(SCENES, answers["right"], strict=True) if one.omega]
    assert len(turning) == 4
    for one, found in turning:
        if one.zeta == 0:
            continue  # at that frequency it resonates
        pair = PlanePair(str(one.ratio), 1, str(1 + one.ratio), 1, str(2 * one.zeta * (1 + one.ratio)))
        right = rotating_response(pair, str(one.size), str(one.omega), 20)
        assert (found["edge"], found["speed"]) == pytest.approx((float(right.threshold), float(right.speed)), abs=1e-14)


def test_what_is_not_the_same_in_all_directions_is_not_shown():
    found = reduced_surface(load_scene("plane-circle-merges"))
    assert [*found.V1] == pytest.approx([0, 1.01])
    for name in ("plane-box", "plane-slip-turns", "plane-rotating-force"):
        with pytest.raises(ValueError, match="isotropic pairs"):
            reduced_surface(load_scene(name))
