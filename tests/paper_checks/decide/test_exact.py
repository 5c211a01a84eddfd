"""Identities pass, near misses fail at a point, and a silent simplifier is no pass; values at points are sympy's."""

from fractions import Fraction

import pytest
import sympy as sp
from flint import fmpq
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import elementary_expressions

from paper_checks.decide import exact
from paper_checks.decide.at_point import at_point
from paper_checks.decide.balls import precision
from paper_checks.decide.exact import identity
from paper_checks.decide.normal_form import is_zero
from paper_checks.evidence.evidence import EvidenceKind

from .formulas import ASKED, asked, formula, m, n, x


@pytest.mark.parametrize("text", ASKED["zeros"])
def test_what_is_0_by_the_rules_is_found_and_a_fault_in_any_part_of_it(text):
    zero = formula(text)
    assert is_zero(zero)
    for place, part in enumerate(zero.args):
        for fault in (-part, 2 * part, part**2, part + sp.Rational(1, 10**9)):
            wrong = sp.Add(*zero.args[:place], fault, *zero.args[place + 1 :])
            assert not is_zero(wrong), wrong


@given(st.data())
def test_the_same_expression_written_in_another_way_is_the_same(data):
    expression = data.draw(elementary_expressions())
    for rewritten in (sp.expand(expression), sp.together(expression), sp.expand_trig(expression)):
        assert is_zero(sp.Add(expression, -rewritten, evaluate=False))


@given(elementary_expressions(), elementary_expressions())
def test_it_is_not_0_where_a_value_is_not(first, second):
    """Also where both differ in little: the first with a part of it doubled."""
    one, other = sp.symbols("x y", positive=True)
    for difference in (
        first - second,
        first - first.xreplace({one: 2 * one}),
        first - first.xreplace({sp.sin(one): sp.cos(one)}),
    ):
        with precision(60):
            value = at_point(difference, {one: sp.Rational(7, 5), other: sp.Rational(3, 11)})
        vanishes = value == 0 if isinstance(value, fmpq) else value.contains(0)
        assert is_zero(difference) == bool(vanishes)


@pytest.mark.parametrize(("sides", "passed"), asked("identities"))
def test_identities_pass_near_misses_fail_at_a_point_and_the_rest_is_open(sides, passed):
    left, right = map(formula, sides)
    evidence = identity("identity", left, right)
    assert evidence == identity("identity", left, right)
    assert (evidence.passed, evidence.kind) == (passed, EvidenceKind.EXACT)
    assert evidence.cases >= 5 or passed is False
    assert evidence.value.startswith(
        {True: "left minus right simplifies", False: "difference ", None: "the simplifier"}[passed]
    )


@pytest.mark.parametrize("nowhere", [1 / (sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1), sp.erf(x)], ids=str)
def test_a_simplifier_without_a_point_is_no_pass(nowhere, monkeypatch):
    monkeypatch.setattr(exact, "simplifies_to_zero", lambda difference: True)
    evidence = identity("matrix", sp.Matrix([x, nowhere]), sp.Matrix([x, 0]))
    assert (evidence.passed, evidence.value) == (None, "1 of the differences could be evaluated nowhere")


@given(elementary_expressions())
@example(sp.Min(sp.sin(m), sp.cos(n)) + 2 * sp.Max(sp.sin(m), sp.cos(n)))
def test_a_value_at_a_point_is_the_one_of_sympy(expression):
    point = {one: sp.Rational(7, 5) if one.name in "xm" else sp.Rational(3, 11) for one in expression.free_symbols}
    with precision(30):
        value = at_point(expression, point)
    value = Fraction(int(value.p), int(value.q)) if isinstance(value, fmpq) else value.mid()
    assert complex(value) == pytest.approx(complex(expression.subs(point).evalf(30)), rel=1e-12, abs=1e-12)
