"""The normal form is 0 only for what is 0: it agrees with values at points, and lets no near miss through."""

from fractions import Fraction

import pytest
import sympy as sp
from flint import acb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import elementary_expressions

from paper_checks.decide.at_point import NotEvaluatedError, at_point
from paper_checks.decide.balls import precision
from paper_checks.decide.normal_form import is_zero

x, y = sp.symbols("x y", positive=True)
root = sp.sqrt(x + y)

ZEROS = [
    sp.sin(2 * x) - 2 * sp.sin(x) * sp.cos(x),
    sp.cos(x - 3 * y) - sp.cos(x) * sp.cos(3 * y) - sp.sin(x) * sp.sin(3 * y),
    sp.sin(x / 2) ** 2 - (1 - sp.cos(x)) / 2,
    sp.tan(x) * sp.cos(x) - 1 / sp.cot(x) * sp.cos(x),
    1 / root - root / (x + y),
    root**3 - (x + y) * root,
    sp.sqrt(1 + root) ** 2 - 1 - root,
    (sp.Min(x, y) + 1) ** 2 - sp.Min(x, y) ** 2 - 2 * sp.Min(x, y) - 1,
    sp.sin(root) ** 2 / x + sp.cos(root) ** 2 / x - 1 / x,
    x * sp.Abs(y / x - 1) - sp.Abs(x - y),
]


@pytest.mark.parametrize("zero", ZEROS, ids=str)
def test_what_is_0_by_the_rules_is_found(zero):
    assert is_zero(zero)


@pytest.mark.parametrize("zero", ZEROS, ids=str)
@pytest.mark.parametrize(
    "fault", [lambda one: -one, lambda one: 2 * one, lambda one: one**2, lambda one: one + sp.Rational(1, 10**9)]
)
def test_a_fault_in_any_part_of_it_is_not(zero, fault):
    for place, part in enumerate(zero.args):
        wrong = sp.Add(*zero.args[:place], fault(part), *zero.args[place + 1 :])
        assert not is_zero(wrong), wrong


@pytest.mark.parametrize(
    "open_still",
    [sp.sqrt(x**2 + 2 * x + 1) - x - 1, sp.atan(x) + sp.atan(1 / x) - sp.pi / 2, sp.Pow(0, -1, evaluate=False)],
    ids=str,
)
def test_what_the_rules_do_not_reach_stays_open(open_still):
    assert not is_zero(open_still)


@given(st.data())
def test_the_same_expression_written_in_another_way_is_the_same(data):
    expression = data.draw(elementary_expressions())
    for rewritten in (sp.expand(expression), sp.together(expression), sp.expand_trig(expression)):
        assert is_zero(sp.Add(expression, -rewritten, evaluate=False))


@given(elementary_expressions(), elementary_expressions())
def test_it_is_not_0_where_a_value_is_not(first, second):
    """Also where both differ in little: the first with a part of it doubled."""
    for difference in (
        first - second,
        first - first.xreplace({x: 2 * x}),
        first - first.xreplace({sp.sin(x): sp.cos(x)}),
    ):
        with precision(60):
            value = at_point(difference, {x: sp.Rational(7, 5), y: sp.Rational(3, 11)})
        vanishes = value == 0 if isinstance(value, fmpq) else value.contains(0)
        assert vanishes or not is_zero(difference)
        assert is_zero(difference) or not vanishes


@given(elementary_expressions())
@example(sp.Min(sp.sin(x), sp.cos(x)) + 2 * sp.Max(sp.sin(x), sp.cos(x)))
def test_a_value_at_a_point_is_the_one_of_sympy(expression):
    point = {x: sp.Rational(7, 5), y: sp.Rational(3, 11)}
    with precision(30):
        value = at_point(expression, point)
    known = expression.subs(point).evalf(30)
    value = Fraction(int(value.p), int(value.q)) if isinstance(value, fmpq) else value.mid()
    assert complex(value) == pytest.approx(complex(known), rel=1e-12, abs=1e-12)


def test_two_letters_of_one_name_are_two():
    other = sp.Symbol(x.name, complex=True)
    assert is_zero(sp.Add(x, -x, evaluate=False))
    assert str(x - other) in {"x - x", "-x + x"}
    assert not (is_zero(x - other))
    assert not (is_zero(other - x))


def test_a_value_is_exact_while_it_can_be():
    point = {x: sp.Rational(9, 4), y: sp.Rational(7, 4)}
    assert at_point(1 / sp.sqrt(x) + sp.Min(x, y) - sp.Abs(y - x) + sp.sqrt(x + y) ** 3, point) == fmpq(2, 3) + fmpq(
        37, 4
    )
    assert (at_point(sp.sqrt(x), {x: sp.Rational(4, 3)}) ** 2).contains(fmpq(4, 3))
    with pytest.raises(ZeroDivisionError):
        at_point(1 / (x - sp.Rational(9, 4)), point)
    with pytest.raises(NotEvaluatedError):
        at_point(sp.erf(x / 3), point)
    assert at_point(sp.floor(-x / 3) + sp.ceiling(sp.sqrt(y)), point) == 1


def test_a_root_of_a_negative_number_is_complex():
    assert at_point(sp.sqrt(x - 2), {x: sp.Rational(1)}) == acb(0, 1)
