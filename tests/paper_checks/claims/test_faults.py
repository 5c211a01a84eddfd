"""A fault in a step, in a point, in what is printed or in theory turns the rows that rest on it."""

from functools import cache

import pytest

from paper_checks.claims.beyond import long_time, merging_share
from paper_checks.claims.section_3 import convergence, near_critical
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide

from .conftest import CHECKS
from .faults import planted

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


@pytest.fixture(autouse=True)
def runs_are_remembered(monkeypatch):
    """Long runs in numbers are the same in every test but those that plant a fault in them."""
    for module, name, remembered in REMEMBERED:
        monkeypatch.setattr(module, name, remembered)


@pytest.mark.parametrize(("row", "place", "fault"), [*planted()])
def test_a_fault_in_a_step_or_a_point_turns_its_row(plant, row, place, fault):
    """Found by deciding: a case that raises is undecided too, and may say only that the fault broke the program."""
    plant(place, fault)
    finding = decide(CHECKS[row], Context())
    assert "did not run to its end" not in finding.reason
    assert finding.verdict is Verdict.UNDECIDED
