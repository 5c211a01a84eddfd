"""A check's failure is its row's verdict and no one else's; several checks must agree."""

import pytest

from paper_checks.checks.registry import Context, Registry
from paper_checks.errors import ToolMissingError
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict, carried
from paper_checks.ledger import Claim
from paper_checks.running.runner import Row, decide, exit_code, joined, run

PASSED = Evidence(EvidenceKind.EXACT, "sympy", "a = a", True)
HOLDS = Finding(Verdict.HOLDS, "So it is.", (PASSED,), derivation=("step",), figure="f")
OPEN = Finding(Verdict.UNDECIDED, "Samples.", missing="a proof")


def claim(name, recorded=Verdict.HOLDS):
    return Claim(name, "II", "w", "s.", recorded)


def raising(error):
    def check(context):
        raise error

    return check


def test_rows_come_in_ledger_order_with_their_findings(rows, registry):
    found = run([row.claim for row in rows], registry, Context())
    assert [(row.claim, row.finding) for row in found] == [(row.claim, row.finding) for row in rows]
    assert all(row.seconds >= 0 for row in found)


def test_progress_is_told_before_each_claim(rows, registry):
    told = []
    run([row.claim for row in rows], registry, Context(), told.append)
    assert told == [row.claim for row in rows]


def test_a_check_sees_the_seed():
    seen = []
    decide([lambda context: seen.append(context.seed) or HOLDS], Context(seed=7))
    assert seen == [7]


def test_an_exception_is_undecided_and_isolated():
    registry = Registry(["a", "b"])
    registry.check("a")(raising(ZeroDivisionError("by $0$")))
    registry.check("b")(lambda context: HOLDS)
    first, second = run([claim("a"), claim("b")], registry, Context())
    assert first.finding.verdict is Verdict.UNDECIDED
    assert r"ZeroDivisionError: by \$0\$" in first.finding.reason
    assert second.finding is HOLDS


def test_a_formula_whose_decision_raises_makes_its_row_undecided():
    def decided(formula):
        raise ZeroDivisionError("no inverse")

    said = (clause("whole", "«it».", it=Formula("E", "=", 0, decided)),)
    registry = Registry(["a"])
    registry.check("a")(lambda context: HOLDS)
    (row,) = run([Claim("a", "II", "w", said, Verdict.HOLDS)], registry, Context())
    assert row.finding.verdict is Verdict.UNDECIDED
    assert "no inverse" in row.finding.reason


@pytest.mark.parametrize("answer", [None, True, "holds", PASSED])
def test_an_answer_that_is_no_finding_is_undecided(answer):
    finding = decide([lambda context: answer], Context())
    assert finding.verdict is Verdict.UNDECIDED
    assert "not a Finding" in finding.reason


def test_a_missing_tool_and_a_missing_check_are_unchecked():
    missing = decide([raising(ToolMissingError("z3 is not installed"))], Context())
    assert (missing.verdict, missing.missing) == (Verdict.UNCHECKED, "z3 is not installed")
    assert decide([], Context()).verdict is Verdict.UNCHECKED


@pytest.mark.parametrize("interruption", [KeyboardInterrupt, SystemExit])
def test_an_interruption_is_not_a_verdict(interruption):
    with pytest.raises(interruption):
        decide([raising(interruption())], Context())


def test_findings_that_agree_are_joined():
    finding = joined([HOLDS, Finding(Verdict.HOLDS, "Again.", (PASSED,), derivation=("more",))])
    assert finding.verdict is Verdict.HOLDS
    assert finding.reason == "So it is. Again."
    assert (len(finding.evidence), finding.derivation, finding.figure) == (2, ("step", "more"), "f")


def test_what_each_check_carries_is_carried():
    one, two = (Finding(Verdict.HOLDS, "r", (PASSED,), carried=(carried(name, PASSED),)) for name in ("one", "two"))
    assert [part.clause for part in joined([one, two]).carried] == ["one", "two"]


def test_findings_that_differ_are_undecided():
    finding = joined([HOLDS, OPEN])
    assert finding.verdict is Verdict.UNDECIDED
    assert "do not agree (holds, undecided)" in finding.reason


def test_one_missing_tool_leaves_the_row_unchecked():
    assert joined([HOLDS, decide([raising(ToolMissingError("z3"))], Context())]).verdict is Verdict.UNCHECKED


UNCHECKED = decide([], Context())


@pytest.mark.parametrize(
    ("findings", "code"),
    [([HOLDS, HOLDS], 0), ([HOLDS, OPEN], 1), ([HOLDS, UNCHECKED], 3), ([OPEN, UNCHECKED], 1), ([], 0)],
)
def test_exit_codes(findings, code):
    assert exit_code(Row(claim("a"), finding) for finding in findings) == code
