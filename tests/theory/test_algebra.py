"""The algebra beneath theory, against sympy's own: lowest terms, roots of linear equations, series, half tangents."""

import pytest
from hypothesis import example, given, settings
from strategies import trigonometric_quotients
from sympy import Piecewise, Symbol, cancel, cos, expand, limit, pi, series, sin

from theory import excursion, power_series
from theory.fraction import factored, in_lowest_terms
from theory.linear import root
from theory.power_series import taylor
from theory.symbols import a2, b, m1, m2, q, theta, v1, x1

free = Symbol("c", real=True)


@given(trigonometric_quotients())
@example((a2**2 - b**2) / (a2 * m1 + b * m1))
def test_lowest_terms_are_written_as_cancel_writes_them(expression):
    assert in_lowest_terms(expression) == cancel(expression)


def test_products_are_found_in_what_is_left_and_a_division_by_zero_is_refused():
    assert factored((a2 * m1 + b * m1) / (a2**2 - b**2)) == m1 / (a2 - b)
    with pytest.raises(ZeroDivisionError):
        in_lowest_terms(b / (x1 - (2 * x1 - x1) + (m1 + m2) ** 2 - m1**2 - 2 * m1 * m2 - m2**2))


@pytest.mark.parametrize("expression", [a2 * x1**2 - b, a2 * v1, cos(x1)])
def test_what_is_not_linear_is_refused(expression):
    with pytest.raises(ValueError, match="is not linear in x1"):
        root(expression, x1)


@given(trigonometric_quotients())
@example(free / (2 + free * theta))
@example(theta**7)
@settings(max_examples=5)
def test_series_of_quotients_of_trigonometric_polynomials(expression):
    assert power_series._by_division(expression, theta, 4) is not None
    by_sympy = series(expression, theta, 0, 4).removeO()
    assert expand(taylor(expression, theta, 4) - by_sympy) == 0


def test_a_pole_is_no_polynomial_and_the_zero_of_a_denominator_takes_orders_away():
    for expression in (1 / theta, cos(theta) / (1 - cos(theta)), 1 / theta**20):
        assert power_series._by_division(expression, theta, 4) is None
    deep = (1 - cos(theta)) ** 5
    assert taylor(deep * (1 + theta) / deep.subs(cos(theta), 1 - theta**2 / 2), theta, 2) == theta + 1


def test_what_has_no_series_by_division_is_refused_where_sympy_may_not_end():
    """A sign turned in eq (4) gave such expressions, and a run of all claims did not end."""
    with pytest.raises(ValueError, match="by cases"):
        taylor(Piecewise((theta, theta > q), (sin(theta), True)), theta, 4)
    for inner, outer in ((1 / theta, theta), (sin(theta), 1 / theta)):
        with pytest.raises(ValueError, match="finite at 0"):
            power_series.reverted(inner, theta, 4, outer)


def test_the_half_tangent_form_decides():
    decided = excursion.half_tangent_form
    assert decided(sin(2 * theta) - 2 * sin(theta) * cos(theta)) == decided(sin(theta) ** 2 + cos(theta) ** 2 - 1) == 0
    assert 0 not in {decided(sin(theta) - theta), decided(1 - cos(theta))}
    assert limit(excursion.h(), theta, pi) == pi / 2
