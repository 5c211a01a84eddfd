"""A fault in a step, in a point, in what is printed or in theory turns the rows that rest on it."""

from functools import cache

import pytest

from paper_checks.claims import convergence, long_time, merging_share, near_critical
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide

from . import faults_in_the_paper, faults_in_theorems
from .conftest import CHECKS
from .faults import doubled, halved, negated, other_sign

LENGTHY = {
    *faults_in_theorems.FAULTS,
    *("infinitely-many-crossings", "dichotomy", "relative-displacement-limit", "global-stability", "stick-durations"),
    *("slip-durations", "exits-near-endpoints", "no-merging-near-critical", "slower-than-exponential"),
    *("rate-one-over-t", "viscous-energy-rate", "viscous-origin-stable", "synchronisation-all-parameters"),
    *("finite-time-then-alternation", "viscous-accelerates", "two-descriptions", "acceleration-bound"),
}
"""Rows that are slow to decide: one of their faults in every run, the others in the long one."""


def planted():
    """Every fault, by its row and the name that it changes."""
    for row, places in (faults_in_the_paper.FAULTS | faults_in_theorems.FAULTS).items():
        faults = [
            (place, one) for place, some in places.items() for one in (some if isinstance(some, tuple) else [some])
        ]
        for number, (place, fault) in enumerate(faults):
            target = place if place.startswith("theory.") else f"paper_checks.claims.{place}"
            late = [pytest.mark.long] * (row in LENGTHY and number > 0)
            yield pytest.param(row, target, fault, id=f"{row}-{place}-{number}", marks=late)


REMEMBERED = [
    (module, name, cache(getattr(module, name)))
    for module, *names in (
        (near_critical, "enclosed_rate"),
        (convergence, "dichotomy_samples"),
        (long_time, "constant_found_again"),
        (merging_share, "random_states", "bands"),
    )
    for name in names
]


@pytest.fixture
def runs_are_remembered(monkeypatch):
    """Long runs in numbers are the same in every test but those that plant a fault in them."""
    for module, name, remembered in REMEMBERED:
        monkeypatch.setattr(module, name, remembered)


def verdict(row):
    """Found by deciding: a case that raises is undecided too, and may say only that the fault broke the program."""
    finding = decide(CHECKS[row], Context())
    assert "The check failed" not in finding.reason
    return finding.verdict


@pytest.mark.usefixtures("runs_are_remembered")
@pytest.mark.parametrize(("row", "target", "fault"), list(planted()))
def test_a_fault_in_a_step_or_a_point_turns_its_row(plant, row, target, fault):
    plant(target, fault)
    assert verdict(row) is Verdict.UNDECIDED


IN_THEORY = [
    ("energy.half_width", doubled, ("critical-energy",)),
    ("energy.half_width", halved, ("supercritical-arcs",)),
    ("filippov.slip", other_sign, ("vector-fields", "transversality-strip", "return-alternatives")),
    ("filippov.guard", negated, ("transversality-outside", "transversality-strip", "return-alternatives")),
    ("filippov.load_threshold", halved, ("supercritical-arcs",)),
]


@pytest.mark.parametrize(("name", "fault", "turned"), IN_THEORY)
def test_a_fault_in_theory_turns_the_rows_that_rest_on_it(plant, name, fault, turned):
    plant(f"theory.{name}", fault)
    assert {verdict(row) for row in turned} == {Verdict.UNDECIDED}
