"""Each tie says that a definition of the proofs is the expression that `theory/` derives today."""

import re

import theory_terms

from paper_checks.proofs.audit import recorded
from paper_checks.proofs.sources import FOLDER
from theory import filippov

STATEMENT = re.compile(r"^Theorem (tie_\w+) : (.*?)\nProof", re.MULTILINE | re.DOTALL)
MACHINERY = {"Dini.cont", "Dini.little", "Dini.rderiv"}


def missing():
    """The expressions of the theory that a tie does not state, by its name."""
    texts = [path.read_text("utf-8") for path in sorted(FOLDER.rglob("*Ties.v"))]
    statements = {name: " ".join(said.split()) for text in texts for name, said in STATEMENT.findall(text)}
    expected = theory_terms.terms()
    assert statements.keys() == expected.keys()
    return {name: gone for name, terms in expected.items() if (gone := _without(terms, statements[name]))}


def _without(terms, statement):
    place = 0
    for term in terms:
        place = statement.find(term, place)
        if place < 0:
            return term
        place += len(term)
    return ""


def test_every_tie_states_what_the_theory_derives():
    assert missing() == {}


def test_another_expression_of_the_theory_is_found_missing(monkeypatch):
    width = filippov.half_width()
    monkeypatch.setattr(filippov, "half_width", lambda: 2 * width)
    assert missing().keys() == {"tie_half_width"}


def test_every_definition_of_the_sharp_law_is_tied():
    tied = set().union(*(recorded().definitions_of[tie] for tie in recorded().ties_of("sharp-law")))
    assert recorded().definitions_of["sharp-law"].keys() <= tied | MACHINERY
