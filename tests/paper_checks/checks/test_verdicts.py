"""Every claim: its verdict is the one on record, and every formula of its finding can be read."""

import pytest

from .conftest import CHECKS, finding_of, recorded, unreadable


@pytest.mark.parametrize("claim_id", CHECKS)
def test_the_verdict_is_the_one_on_record(claim_id):
    finding = finding_of(CHECKS[claim_id])
    assert finding.verdict.value == recorded(claim_id), finding.missing
    assert unreadable(finding) == []
