"""The shipped problems of other people as pairs: closed forms, and the law itself."""

import math

import pytest
from inclusion import motion

from numerics import load_scene, solve
from numerics.scene.file import described_scenes

PROBLEMS = [name for name, what in described_scenes().items() if what.startswith("Your problem")]


def solved(name):
    return solve(load_scene(name), digits=12)


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_answer_obeys_the_law(name):
    """Of what goes on for ever the first events."""
    run = motion(load_scene(name), max_events=40)
    assert run.success or len(run.events) == 40


UP, DOWN, OMEGA = 9.81 * (0.6 + 0.4), 9.81 * (0.6 - 0.4), math.sqrt(40)
KNOWN = {
    "ground": ([3, 4.75], 59 / 48),
    "incline": ([3 / UP], 9 / (2 * UP) - DOWN * (1 - 3 / UP) ** 2 / 2),
    "friction-damper": ([k * math.pi / OMEGA for k in (1, 2, 3)], -0.005),
    "drill-string": ([(12000 - 50 * 2) / (473 * 2)], None),
    "newmark-block": (None, -0.0518582),  # as docs/your_problem.md says
    "conveyor": (None, 0.0142),
}
"""The first events, and where body 1 ends; friction takes as much of each half swing, and a rock holds a bit until the
string is wound up."""


def test_events_and_places_are_those_of_closed_forms():
    for name, (times, place) in KNOWN.items():
        run = solved(name)
        if times is not None:
            assert run.floats(run.event_times)[: len(times)].tolist() == pytest.approx(times, rel=1e-12)
        if place is not None:
            tolerance = 1e-4 if name == "conveyor" else 2e-6 if name == "newmark-block" else 1e-10
            assert float(run.final.x1) == pytest.approx(place, abs=tolerance)


@pytest.mark.long
def test_a_cycle_on_a_belt_goes_on_with_as_many_digits_as_lead_further():
    """Where friction falls errors grow: so long a run needs more digits than a tie is worth."""
    run = solve(load_scene("belt").replace(until=600))
    assert (run.success, run.arithmetic.digits) == (True, 1120)
