"""What the page is made of: what stands first, provenance, the kernel's words."""

from pathlib import Path

import pytest

from paper_checks.claims import CLAIMS, claim_named
from paper_checks.evidence.claim import FREE, Kind
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.proofs.audit import recorded
from paper_checks.report.content import kernel, opening, trust
from paper_checks.report.content.blocks import Cards
from paper_checks.running.runner import Row


def settled(name):
    """A row that holds as recorded."""
    claim, step = claim_named(name), Evidence(EvidenceKind.EXACT, "sympy", "$1=1$", True)
    if claim.recorded is Verdict.HOLDS:
        return Row(claim, Finding(claim.recorded, "So it is. And more.", (step,)))
    both = step.as_counterexample(), step.as_correction()
    return Row(claim, Finding(claim.recorded, "It is not so. And more.", both, "It is so.", "$1\\neq 0$."))


def test_results_are_shown_only_with_the_verdict_on_record(rows):
    assert not [block for one in opening.front(rows) for block in one.blocks if isinstance(block, Cards)]


def cards(names, section):
    """The texts of the cards of a section of the first page."""
    (found,) = [one for one in opening.front([*map(settled, names)]) if one.id == section]
    return [text for block in found.blocks if isinstance(block, Cards) for _, text, _ in block.items]


def test_the_numbers_of_the_first_page_are_computed():
    failed = {"synchronisation-time": "2.31 mm/s", "start-at-6mm-sticks": "needs 0.6 N; friction gives at most 0.5 N"}
    told = cards(failed, "refuted")
    assert all(number in text for number, text in zip(failed.values(), told, strict=True))
    assert "0.79263" not in Path(opening.__file__).read_text(encoding="utf-8")
    told = " ".join(cards(opening.NEW, "results"))
    assert "0.79263" in told
    assert "E_{cr} m_{1}" in told
    assert "«" not in told


@pytest.mark.parametrize("claim", [one for one in CLAIMS if one.kind is Kind.THEOREM], ids=lambda claim: claim.id)
def test_a_theorem_is_said_to_be_without_a_damper_where_the_kernel_has_none(claim):
    """What a theorem of the free pair assumes is read off from its statements: 0 in the damper's place."""
    statements = [recorded().theorems[name].statement for one in claim.clauses for name in one.kernel]
    zeros = [dict(kernel.zeros(text)) for text in statements if "Pair.solution" in text]
    if claim.assuming == FREE:
        assert all(one == {"Pair.solution": "a_1"} for one in zeros)
        assert not any("Forced.forced" in text for text in statements)
    else:
        assert any("u" in str(one.shown) for one in claim.clauses)


def test_the_provenance_says_how_to_install_as_the_readme_does():
    readme = (Path(__file__).parents[3] / "README.md").read_text(encoding="utf-8")
    assert readme.partition("```sh\n")[2].partition("\n```")[0] == trust.INSTALL


@pytest.mark.parametrize(
    ("text", "typed"),
    [("If $x>0$, «f».", True), ("For $t\\to\\infty$, «f».", True), ("«f» at $x_1$, and 2 > 1.", False)],
)
def test_a_relation_that_is_typed_beside_the_formulas_is_counted(text, typed):
    assert trust.has_typed_relation(clause("part", text, f=Formula("a", "=", "b", decide=lambda _: None))) == typed
