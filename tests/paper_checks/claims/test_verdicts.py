"""Every claim: its verdict is the one on record, and every formula of its finding can be read."""

import pytest

from paper_checks.evidence.claim import Kind

from .conftest import CHECKS, unreadable


@pytest.mark.parametrize("claim_id", CHECKS)
def test_the_verdict_is_the_one_on_record(claim_id):
    """Past the paper a row may rest on the kernel: where that is missing it is unchecked, and says so."""
    finding = CHECKS[claim_id].decide()
    waits = CHECKS[claim_id].kind is Kind.THEOREM and finding.missing == "the proof kernel"
    assert waits or finding.verdict.value == CHECKS[claim_id].recorded.value, finding.missing
    assert unreadable(finding) == []
