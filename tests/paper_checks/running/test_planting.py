"""Every formula of every clause: a changed sign, factor, exponent or relation turns its row."""

from dataclasses import replace

import pytest
import sympy as sp
from flint import arb

from paper_checks.claims import CLAIMS, claim_named
from paper_checks.decide.deciders import decimal, equals, fails_at, implied, sharp
from paper_checks.errors import LedgerError
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Verdict
from paper_checks.running.planting import faults, places, planted
from theory.symbols import b, m1, m2, v1

WITH_FORMULAS = sorted({claim.id for claim, *_ in places(CLAIMS)})


pytestmark = pytest.mark.usefixtures("the_solvers_remember")
LENGTHY = {"uniform-rate", "forced-no-zeno", "entrainment-threshold"}
"""Rows with many faults, each slow to decide; the `long` tests plant them."""


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long) if name in LENGTHY else name for name in WITH_FORMULAS]
)
def test_each_formula_stands_and_each_fault_turns_it(name):
    claims = [claim_named(name)]
    assert [formula.latex for *_, formula in places(claims) if formula.evidence().passed is not True] == []
    found = list(planted(claims))
    assert found
    assert [one for one in found if not one.turned] == []


def test_every_formula_stands_and_has_a_fault():
    """@example of a hole: a fault in theory that a formula alone shows turned nothing but long tests."""
    for claim, _, name, formula in places(CLAIMS):
        assert claim.id not in LENGTHY or formula.evidence().passed is True, name
        assert any(True for _ in faults(formula)), name


def test_a_formula_that_nothing_turns_is_reported_wherever_it_stands():
    """As decided by nobody: each planted fault in the claim, and in its correction, passes."""
    passes = Evidence(EvidenceKind.EXACT, "sympy", "all", True)
    for decided, turned in ((lambda _: passes, False), (lambda _: replace(passes, passed=None), True), (raises, False)):
        said, corrected = (clause(name, "«e».", e=Formula("E", "=", b, decided)) for name in ("said", "corrected"))
        found = list(planted([Claim("a-claim", "III", "(8)", (said,), Verdict.REFUTED, correction=(corrected,))]))
        assert {one.clause for one in found} == {"said", "corrected"}
        assert {one.turned for one in found} == {turned}


def raises(formula):
    raise ArithmeticError("not decided")


EQUATION = {"sign", "factor", "exponent"}
SHARP = sharp(b, "<=", m1, lambda: (b, "<=", m1))


@pytest.mark.parametrize(
    ("formula", "kinds"),
    [
        *(
            (Formula("E", "=", right, equals(lambda right=right: right)), EQUATION)
            for right in (b**2 / m1 - m2, sp.Matrix([0, 1, -b]), sp.Abs(v1))  # |-v1| is no fault
        ),
        (Formula(b, ">", 0, implied()), {"inequality"}),
        (Formula(b, "<=", m1, fails_at({b: 2, m1: 1}), false=True), {"negation"}),
        (SHARP, {"inequality", *EQUATION}),
    ],
)
def test_signs_factors_exponents_and_relations_are_changed_and_turn_what_stands(formula, kinds):
    assert formula.evidence().passed is True
    assert {kind for kind, _ in faults(formula)} == kinds
    assert [wrong for _, wrong in faults(formula) if wrong.evidence().passed is True] == []


def test_each_side_of_a_sharp_inequality_counts_and_what_is_not_settled_at_a_point_does_not_fail_there():
    for wrong in (replace(SHARP, right=m2), replace(SHARP, left=m2)):
        assert wrong.evidence().passed is False
    assert Formula(b, "<=", m1, fails_at({m1: 1}), false=True).evidence().passed is None


@pytest.mark.parametrize(
    ("digits", "passed"),
    [("0.79263", True), ("0.79264", False), ("0.79262", False), ("0.79261", False), ("0.792631", None)],
)
def test_digits_are_those_of_the_enclosed_value(digits, passed):
    found = decimal("x", digits, lambda: arb("0.792631").union(arb("0.792639")))
    assert (found.latex, found.evidence().passed) == (rf"x={digits}\ldots", passed)


def test_places_and_formulas_must_agree():
    with pytest.raises(LedgerError, match="differ from the places"):
        clause("c", "«a» and «b».", a=Formula("E", "=", b, equals(lambda: b)))
    with pytest.raises(LedgerError, match="none of"):
        Formula("E", "==", b, equals(lambda: b))
