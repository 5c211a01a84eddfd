"""The claims are complete, in paper order, and literal; each is found where it is."""

import re

import pytest

from paper_checks.claims import CLAIMS, SUBJECTS, in_order
from paper_checks.errors import LedgerError
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.finding import Verdict


def claim(name="a", **changes):
    return Claim(**{"id": name, "section": "II", "where": "w", "said": "s", "recorded": Verdict.HOLDS} | changes)


ORDER = ["Abstract", "I", "II", "III", "IV", "V", "Theorems"]


def test_the_sections_come_in_paper_order():
    sections = [claim.section for claim in CLAIMS]
    assert sections == sorted(sections, key=ORDER.index)
    assert [sections.count(name) for name in ORDER] == [1, 3, 6, 25, 13, 9, 26]


def test_every_statement_is_a_sentence_with_balanced_mathematics():
    for row in CLAIMS:
        assert row.statement.endswith("."), row.id
        assert row.statement.count("$") % 2 == 0, row.id
        assert row.where, row.id


@pytest.mark.parametrize("name", ["", "Upper", "two words", "-a", "a--b", "a#b"])
def test_an_id_must_be_fit_for_an_anchor(name):
    with pytest.raises(LedgerError, match="claim id"):
        claim(name)


def test_an_id_is_taken_once():
    with pytest.raises(LedgerError, match="taken twice: a"):
        in_order([claim("a"), claim("b")], [claim("a")])


def test_ids_and_places_carry_no_number_of_another_figure():
    for row in CLAIMS:
        assert not re.search(r"figure-\d", row.id)
        assert not any(label in row.where + row.statement for label in ("(e1)", "(e2)", "(e3)", "edot", "(trans"))


def test_every_claim_is_in_the_module_that_makes_its_case():
    assert all(claim.case and claim.case.__module__ in SUBJECTS for claim in CLAIMS)
