"""Every formula of every clause: a changed sign, factor, exponent or relation turns its row."""

from dataclasses import replace
from functools import cache

import pytest
import sympy as sp
from flint import arb

from paper_checks.claims import CLAIMS, claim_named
from paper_checks.decide import smt
from paper_checks.decide.deciders import condition, decimal, equals, fails_at, holds_at, implied
from paper_checks.errors import LedgerError
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Verdict
from paper_checks.running.planting import faults, places, planted
from theory.symbols import b, m1, m2, v1

WITH_FORMULAS = sorted({claim.id for claim, *_ in places(CLAIMS)})


ask_once = cache(smt.ask)


@pytest.fixture(autouse=True)
def the_solvers_remember(monkeypatch):
    monkeypatch.setattr(smt, "ask", ask_once)


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


@pytest.mark.parametrize("name", sorted(LENGTHY))
def test_each_formula_of_a_row_with_many_faults_stands(name):
    """@example of a hole: a fault in theory that such a formula alone shows turned nothing but long tests."""
    assert [one.latex for *_, one in places([claim_named(name)]) if one.evidence().passed is not True] == []


def test_every_formula_has_a_fault():
    assert all(any(True for _ in faults(formula)) for *_, formula in places(CLAIMS))


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


def kinds(formula):
    return {kind for kind, _ in faults(formula)}


def test_signs_factors_exponents_and_relations_are_changed():
    equation = Formula("E", "=", b**2 / m1 - m2, equals(lambda: b**2 / m1 - m2))
    assert kinds(equation) == {"sign", "factor", "exponent"}
    assert kinds(Formula(b, ">", 0, implied())) == {"inequality"}
    assert kinds(Formula(b, "<=", m1, holds_at({}), false=True)) == {"negation"}
    assert kinds(Formula("n", "=", sp.Matrix([0, 1, -b]), equals(lambda: 0))) == {"sign", "factor", "exponent"}


def test_a_change_that_changes_nothing_is_no_fault():
    assert all(wrong.right != sp.Abs(v1) for _, wrong in faults(Formula("E", "=", sp.Abs(v1), equals(lambda: v1))))


def test_a_sharp_inequality_is_the_one_derived_on_each_side():
    derived = condition(lambda: sp.Le(b, m1, evaluate=False))
    right = Formula(b, "<=", m1, derived, sharp=True)
    assert right.evidence().passed
    assert all(wrong.evidence().passed is not True for _, wrong in faults(right))
    for wrong in (replace(right, right=m2), replace(right, left=m2)):
        assert wrong.evidence().passed is False


def test_a_false_formula_fails_at_a_point_and_its_negation_does_not():
    false = Formula(b, "<=", m1, fails_at({b: 2, m1: 1}), false=True)
    assert false.evidence().passed is True
    assert [wrong.evidence().passed for _, wrong in faults(false)] == [False]
    assert Formula(b, "<=", m1, fails_at({m1: 1}), false=True).evidence().passed is None


@pytest.mark.parametrize(
    ("digits", "passed"),
    [("0.79263", True), ("0.79264", False), ("0.79262", False), ("0.79261", False), ("0.792631", None)],
)
def test_digits_are_those_of_the_enclosed_value(digits, passed):
    value = decimal(lambda: arb("0.792631").union(arb("0.792639")))
    found = Formula("x", "=...", sp.Rational(digits), value)
    assert (found.latex, found.evidence().passed) == (rf"x={digits}\ldots", passed)


def test_places_and_formulas_must_agree():
    with pytest.raises(LedgerError, match="differ from the places"):
        clause("c", "«a» and «b».", a=Formula("E", "=", b, equals(lambda: b)))
    with pytest.raises(LedgerError, match="none of"):
        Formula("E", "==", b, equals(lambda: b))
