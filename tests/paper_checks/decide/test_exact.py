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

x, y, m, n = *sp.symbols("x y", real=True), *sp.symbols("m n", positive=True)
k = sp.Symbol("k", integer=True)
root = sp.sqrt(m + n)

ZEROS = [
    sp.sin(2 * m) - 2 * sp.sin(m) * sp.cos(m),
    sp.cos(m - 3 * n) - sp.cos(m) * sp.cos(3 * n) - sp.sin(m) * sp.sin(3 * n),
    sp.sin(m / 2) ** 2 - (1 - sp.cos(m)) / 2,
    sp.tan(m) * sp.cos(m) - 1 / sp.cot(m) * sp.cos(m),
    1 / root - root / (m + n),
    root**3 - (m + n) * root,
    sp.sqrt(1 + root) ** 2 - 1 - root,
    (sp.Min(m, n) + 1) ** 2 - sp.Min(m, n) ** 2 - 2 * sp.Min(m, n) - 1,
    sp.sin(root) ** 2 / m + sp.cos(root) ** 2 / m - 1 / m,
    m * sp.Abs(n / m - 1) - sp.Abs(m - n),
]


@pytest.mark.parametrize("zero", ZEROS, ids=str)
def test_what_is_0_by_the_rules_is_found_and_a_fault_in_any_part_of_it(zero):
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


C, D = map(sp.Function, "cd")
v = sp.Symbol("v", negative=True)


@pytest.mark.parametrize(
    ("left", "right", "passed"),
    [
        ((x + y) ** 2, x**2 + 2 * x * y - y**2, False),
        (sp.sqrt(m**2), m, True),
        (sp.sqrt(x**2), x, False),
        (sp.cos(sp.pi * k) ** 2, 1, True),
        (sp.Matrix([x * (x + 1), 0]), sp.Matrix([x**2 + x, 0]), True),
        (sp.Matrix([x, y]), sp.Matrix([x, x]), False),
        (sp.Abs(x) ** 2, x**2, True),
        (sp.Abs(v) + sp.Abs(k), sp.Abs(k) - v, True),  # points meet the assumptions
        (m, sp.Symbol(m.name, complex=True), False),  # two letters of one name
        (sp.ceiling(m / 2), sp.floor(m / 2), False),
        (sp.sin(x) * (1 + sp.Rational(1, 10**70)), sp.sin(x), False),
        (sp.I * sp.exp(400), sp.I * sp.exp(400 + sp.Rational(1, 10**150)), False),
        (sp.Min(C(m), 1), 2 * sp.Min(C(m), 1), False),
        (C(m), C(2 * m), False),
        (C(m), D(m), False),
        (sp.sqrt(m**2 + 2 * m + 1), m + 1, None),  # neither normal form nor sympy decides it
        (sp.Matrix([m, sp.atan(m) + sp.atan(1 / m)]), sp.Matrix([m, sp.pi / 2]), None),
    ],
)
def test_identities_pass_near_misses_fail_at_a_point_and_the_rest_is_open(left, right, passed):
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
