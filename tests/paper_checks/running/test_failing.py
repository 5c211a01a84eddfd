"""Of what fails, the cause comes first: the lowest step, once, with all the claims that it turns."""

from dataclasses import replace

from paper_checks.evidence.claim import Claim, because
from paper_checks.evidence.evidence import Evidence, EvidenceKind, argument
from paper_checks.evidence.finding import Verdict
from paper_checks.running import rows as running
from paper_checks.running.failing import lowest
from paper_checks.running.runner import Context

GOOD = Evidence(EvidenceKind.EXACT, "sympy", "the field is as printed", True)
CAUSE = Evidence(EvidenceKind.EXACT, "sympy", "the energy falls", False, value="difference 2 at b = 1")
OTHER = replace(CAUSE, statement="the strip is closed", value="")
KERNEL = Evidence(EvidenceKind.KERNEL, "Coq", "the theorem energy-rate", False, value="refused")
ABOVE = argument("So it stops.", GOOD, CAUSE)


def claims(**cases):
    return [
        Claim(name, "III", "w", "s.", Verdict.HOLDS, case=lambda steps=steps: because("r", *steps))
        for name, steps in cases.items()
    ]


def rows(**cases):
    return running.rows(claims(**cases), Context())


def test_the_lowest_failing_step_comes_first_with_all_claims_that_it_turns():
    found = lowest(rows(a=(KERNEL,), b=(OTHER,), c=(ABOVE,), d=(argument("And so.", ABOVE),), fine=(GOOD,)))
    assert [one.statement for one in found] == [CAUSE.statement, OTHER.statement, KERNEL.statement]
    assert [one.claims for one in found] == [("c", "d"), ("b",), ("a",)]
    assert found[0].value == CAUSE.value


def test_a_step_on_more_others_comes_later_though_it_turns_more_claims():
    high = replace(OTHER, rests_on=(GOOD,))
    found = lowest(rows(a=(high,), b=(high,), c=(CAUSE,)))
    assert [one.statement for one in found] == [CAUSE.statement, OTHER.statement]


def test_what_a_claim_raises_is_told_with_the_place_where_it_was_raised():
    """@example of a found fault: "The check failed." stood in fifty rows."""

    def breaks():
        raise ZeroDivisionError("no width")

    def breaks_in_a_claim():
        exec(compile("breaks()", "energy.py", "exec"), {"__name__": "theory.energy", "breaks": breaks})

    broken = [Claim(name, "III", "w", "s.", Verdict.HOLDS, case=breaks_in_a_claim) for name in ("a", "b")]
    (found,) = lowest(running.rows(broken, Context()))
    assert found.statement == "theory.energy.<module> raised ZeroDivisionError: no width"
    assert found.claims == ("a", "b")
