"""A fault in a step, in a point, in what is printed or in theory turns the rows that rest on it."""

from functools import cache

import pytest

from paper_checks.claims.beyond import merging_share
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Context, decide, row

from .conftest import CHECKS
from .faults import planted


@pytest.fixture(autouse=True)
def runs_are_remembered(monkeypatch):
    """Long runs in numbers are the same in every test but those that plant a fault in them."""
    for name in ("random_states", "bands"):
        monkeypatch.setattr(merging_share, name, cache(getattr(merging_share, name)))


@pytest.mark.parametrize(("name", "place", "fault"), [*planted()])
def test_a_fault_in_a_step_or_a_point_turns_its_row(plant, name, place, fault):
    """Found by deciding: a case that raises is undecided too, and may say only that the fault broke the program."""
    plant(place, fault)
    finding = decide(CHECKS[name], Context())
    if finding.verdict is not Verdict.UNDECIDED:
        finding = row(CHECKS[name], finding, 0.0).finding
    assert "did not run to its end" not in finding.reason
    assert finding.verdict is Verdict.UNDECIDED
