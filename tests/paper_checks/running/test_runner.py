"""A case's failure is its row's verdict and no one else's."""

import pytest

from paper_checks.errors import ToolMissingError
from paper_checks.evidence.claim import Claim, because
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.running.runner import Context, Row, decide, exit_code, run

PASSED = Evidence(EvidenceKind.EXACT, "sympy", "a = a", True)


def claim(name, case=None, said="s.", recorded=Verdict.HOLDS):
    return Claim(name, "II", "w", said, recorded, case=case)


def raising(error):
    def case():
        raise error

    return case


def holds():
    return because("So it is.", PASSED)


def test_rows_come_in_the_claims_order_with_their_findings_and_progress_is_told(rows):
    told = []
    found = run([row.claim for row in rows], Context(), told.append)
    assert [(row.claim, row.finding) for row in found] == [(row.claim, row.finding) for row in rows]
    assert all(row.seconds >= 0 for row in found)
    assert told == [row.claim for row in rows]


def test_a_case_that_draws_at_random_sees_the_seed():
    seen = []

    def case(seed):
        seen.append(seed)
        return holds()

    assert decide(claim("a", case), Context(seed=7)).verdict is Verdict.HOLDS
    assert seen == [7]


def test_an_exception_is_undecided_and_isolated():
    first, second = run([claim("a", raising(ZeroDivisionError("by $0$"))), claim("b", holds)], Context())
    assert first.finding.verdict is Verdict.UNDECIDED
    assert r"ZeroDivisionError: by \$0\$" in first.finding.reason
    assert second.finding.verdict is Verdict.HOLDS


def test_a_formula_whose_decision_raises_makes_its_row_undecided():
    def decided(formula):
        raise ZeroDivisionError("no inverse")

    said = (clause("whole", "«it».", it=Formula("E", "=", 0, decided)),)
    (row,) = run([claim("a", holds, said)], Context())
    assert row.finding.verdict is Verdict.UNDECIDED
    assert "no inverse" in row.finding.reason


@pytest.mark.parametrize("debug", [False, True])
def test_what_fails_prints_its_traceback_where_that_is_asked_for(debug, capsys):
    decide(claim("a", raising(ZeroDivisionError("by 0"))), Context(debug=debug))
    assert ("Traceback" in capsys.readouterr().err) is debug


@pytest.mark.parametrize("answer", [None, True, "holds", PASSED])
def test_an_answer_that_makes_no_case_is_undecided(answer):
    assert decide(claim("a", lambda: answer), Context()).verdict is Verdict.UNDECIDED


def test_a_missing_tool_and_a_missing_case_are_unchecked():
    missing = decide(claim("a", raising(ToolMissingError("z3 is not installed"))), Context())
    assert (missing.verdict, missing.missing) == (Verdict.UNCHECKED, "z3 is not installed")
    assert decide(claim("a"), Context()).verdict is Verdict.UNCHECKED


@pytest.mark.parametrize("interruption", [KeyboardInterrupt, SystemExit])
def test_an_interruption_is_not_a_verdict(interruption):
    with pytest.raises(interruption):
        decide(claim("a", raising(interruption())), Context())


HOLDS = Finding(Verdict.HOLDS, "So it is.", (PASSED,))
OPEN = Finding(Verdict.UNDECIDED, "Samples.", missing="a proof")
UNCHECKED = decide(claim("a"), Context())


@pytest.mark.parametrize(
    ("findings", "code"),
    [([HOLDS, HOLDS], 0), ([HOLDS, OPEN], 1), ([HOLDS, UNCHECKED], 3), ([OPEN, UNCHECKED], 1), ([], 0)],
)
def test_exit_codes(findings, code):
    assert exit_code(Row(claim("a"), finding) for finding in findings) == code
