"""The claims are complete, in paper order, and each is found where it is, with the verdict on record."""

from dataclasses import replace

import pytest

from paper_checks.claims import CLAIMS, SUBJECTS, in_order
from paper_checks.drawing.figures import FIGURES
from paper_checks.errors import LedgerError
from paper_checks.evidence.claim import Claim, Kind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.mathematics import prose

from .conftest import CHECKS

OF_THE_KERNEL = {
    *("ring-of-tolerance", "sgn-three-valued", "start-at-6mm-sticks", "start-with-speed-synchronises"),
    *("synchronisation-time", "damping-for-tracking", "varying-interface", "viscous-origin-stable"),
}
"""Claims of the paper that a theorem of the kernel decides, and nothing else as a whole."""
ORDER = ["Abstract", "I", "II", "III", "IV", "V", "Theorems"]


@pytest.mark.parametrize("claim_id", CHECKS)
def test_the_verdict_is_the_one_on_record_and_every_formula_can_be_set(claim_id):
    """Some rest on the kernel, most of them beyond the paper: where that is missing they are unchecked, and say so."""
    found = CHECKS[claim_id].decide()
    waits = found.missing == "the proof kernel"
    assert not waits or CHECKS[claim_id].kind is Kind.THEOREM or claim_id in OF_THE_KERNEL
    assert waits or found.verdict.value == CHECKS[claim_id].recorded.value, found.missing
    assert found.figure is None or found.figure in FIGURES
    evidence = [text for item in found.evidence for text in (item.statement, item.value, *item.assumptions)]
    texts = [found.reason, found.corrected or "", found.counterexample or "", *evidence]
    assert [text for text in texts if "<code>" in prose.html(text) or text.count("$") % 2] == []


def test_the_sections_come_in_paper_order_and_each_claim_is_in_the_module_that_makes_its_case():
    sections = [claim.section for claim in CLAIMS]
    assert sections == sorted(sections, key=ORDER.index)
    assert set(sections) == set(ORDER)
    assert all(claim.case and claim.case.__module__ in SUBJECTS for claim in CLAIMS)
    assert all(claim.where and claim.statement.endswith(".") for claim in CLAIMS)


def test_a_sentence_that_is_not_judged_has_a_reason_and_no_formula_that_nothing_would_check():
    judged = [claim for claim in CLAIMS if claim.recorded is not Verdict.NOT_JUDGED]
    assert {claim.id for claim in CLAIMS} - {claim.id for claim in judged} >= {
        "target-or-set-point",
        "transparent-view",
    }
    shown = next(one for claim in judged for one in claim.clauses if one.formulas)
    proved = next(one for claim in judged for one in claim.clauses if one.kernel)
    for quoted in (shown, proved):
        with pytest.raises(LedgerError, match="nothing would check"):
            Claim("a", "II", "w", (quoted,), Verdict.NOT_JUDGED)


@pytest.mark.parametrize("name", ["", "Upper", "two words", "-a", "a--b", "a#b"])
def test_an_id_must_be_fit_for_an_anchor_and_is_taken_once(name):
    with pytest.raises(LedgerError, match="claim id"):
        Claim(name, "II", "w", "s", Verdict.HOLDS)
    with pytest.raises(LedgerError, match="taken twice"):
        in_order(CLAIMS, [replace(CLAIMS[0], where=name)])
