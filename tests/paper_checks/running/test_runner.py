"""A case's failure is its row's verdict and no one else's; of what fails, the lowest step comes first, once."""

from dataclasses import replace

import pytest

from paper_checks.errors import ToolMissingError
from paper_checks.evidence.claim import Claim, because
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, argument
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.running.failing import lowest
from paper_checks.running.rows import Progress, rows
from paper_checks.running.runner import Context, Row, decide, exit_code

PASSED = Evidence(EvidenceKind.EXACT, "sympy", "a = a", True)


def claim(name, case=None, said="s.", recorded=Verdict.HOLDS):
    return Claim(name, "II", "w", said, recorded, case=case)


def raising(error):
    def case():
        raise error

    return case


def holds():
    return because("So it is.", PASSED)


def drawing(seed):
    assert seed == 7
    return holds()


def undecidable(formula):
    raise ZeroDivisionError("by $0$")


@pytest.mark.parametrize("debug", [False, True])
def test_each_claim_is_decided_whatever_becomes_of_the_others(debug, capsys):
    """An exception is undecided, in a formula too; a missing tool and a missing case are unchecked; else it holds."""
    formula = clause("whole", "«it».", it=Formula("E", "=", 0, undecidable))
    claims = [
        claim("raises", raising(ZeroDivisionError("by $0$"))),
        claim("drawn", drawing),
        claim("formula", holds, (formula,)),
        claim("tool", raising(ToolMissingError("z3 is not installed"))),
        claim("nothing"),
    ]
    told, shown = [], Progress()
    shown.begun = told.append
    found = rows(claims, Context(seed=7, debug=debug), 1, shown)
    assert [row.claim for row in found] == told == claims
    assert all(row.seconds >= 0 for row in found)
    bad, fine, missing = Verdict.UNDECIDED, Verdict.HOLDS, Verdict.UNCHECKED
    assert [row.finding.verdict for row in found] == [bad, fine, bad, missing, missing]
    assert all(r"ZeroDivisionError: by \$0\$" in row.finding.reason for row in found if row.finding.verdict is bad)
    assert found[3].finding.missing == "z3 is not installed"
    assert ("Traceback" in capsys.readouterr().err) is debug


@pytest.mark.parametrize("answer", [None, True, "holds", PASSED])
def test_an_answer_that_makes_no_case_is_undecided(answer):
    assert decide(claim("a", lambda: answer), Context()).verdict is Verdict.UNDECIDED


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


# of what fails, the cause comes first

GOOD = Evidence(EvidenceKind.EXACT, "sympy", "the field is as printed", True)
CAUSE = Evidence(EvidenceKind.EXACT, "sympy", "the energy falls", False, value="difference 2 at b = 1")
OTHER = replace(CAUSE, statement="the strip is closed", value="")
KERNEL = Evidence(EvidenceKind.KERNEL, "Coq", "the theorem energy-rate", False, value="refused")
ABOVE = argument("So it stops.", GOOD, CAUSE)


def failing(**cases):
    """What fails of claims with these steps, the lowest first."""
    claims = [claim(name, lambda steps=steps: because("r", *steps)) for name, steps in cases.items()]
    return lowest(rows(claims, Context()))


def test_the_lowest_failing_step_comes_first_with_all_claims_that_it_turns():
    found = failing(a=(KERNEL,), b=(OTHER,), c=(ABOVE,), d=(argument("And so.", ABOVE),), fine=(GOOD,))
    assert [one.statement for one in found] == [CAUSE.statement, OTHER.statement, KERNEL.statement]
    assert [one.claims for one in found] == [("c", "d"), ("b",), ("a",)]
    assert found[0].value == CAUSE.value


def test_a_step_on_more_others_comes_later_though_it_turns_more_claims():
    high = replace(OTHER, rests_on=(GOOD,))
    found = failing(a=(high,), b=(high,), c=(CAUSE,))
    assert [one.statement for one in found] == [CAUSE.statement, OTHER.statement]


def test_what_a_claim_raises_is_told_with_the_place_where_it_was_raised():
    """@example of a found fault: "The check failed." stood in fifty rows."""

    def breaks_in_a_claim():
        breaks = raising(ZeroDivisionError("no width"))
        exec(compile("breaks()", "energy.py", "exec"), {"__name__": "theory.energy", "breaks": breaks})

    (found,) = lowest(rows([claim(name, breaks_in_a_claim) for name in ("a", "b")], Context()))
    assert found.statement == "theory.energy.<module> raised ZeroDivisionError: no width"
    assert found.claims == ("a", "b")
