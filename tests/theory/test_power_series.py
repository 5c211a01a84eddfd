"""Taylor polynomials by power series are those of sympy's own, whatever is given."""

import pytest
from hypothesis import given, settings
from strategies import trigonometric_quotients
from sympy import Symbol, asin, cancel, cos, exp, expand, series, sin, sqrt, symbols

from theory import power_series
from theory.power_series import taylor
from theory.symbols import epsilon, q, theta

free = Symbol("c", real=True)
x, y = symbols("x y")


def by_sympy(expression, variable, order):
    return expand(series(expression, variable, 0, order).removeO())


@given(trigonometric_quotients())
@settings(max_examples=5)
def test_quotients_of_trigonometric_polynomials(expression):
    assert power_series._by_division(expression, theta, 4) is not None
    assert expand(taylor(expression, theta, 4) - by_sympy(expression, theta, 4)) == 0


@pytest.mark.parametrize(
    ("expression", "variable"),
    [
        ((theta - sin(theta)) / (1 - cos(theta)), theta),
        (sqrt(q) * (theta * cos(theta) - sin(theta)) ** 2 / (1 - cos(theta)), theta),
        (free / (2 + free * theta), theta),
        (asin(theta), theta),
        (sin(y) * x, x),
        (exp(x) / (1 + x), x),
        (epsilon * sqrt(1 + q * epsilon**2), epsilon),
        (x**7, x),
    ],
)
def test_what_is_no_such_quotient_comes_from_sympy(expression, variable):
    assert expand(taylor(expression, variable, 6) - by_sympy(expression, variable, 6)) == 0


def test_a_pole_is_no_polynomial():
    for expression in (1 / theta, cos(theta) / (1 - cos(theta)), 1 / theta**20):
        assert power_series._by_division(expression, theta, 4) is None


def test_the_zero_of_a_denominator_takes_orders_away():
    deep = (1 - cos(theta)) ** 5
    assert taylor(deep * (1 + theta) / deep.subs(cos(theta), 1 - theta**2 / 2), theta, 2) == theta + 1


def test_a_series_is_reverted_and_composed_again():
    """sin x = u, so x = asin u and cos x = sqrt(1 - u^2), whatever stands beside them."""
    for outer, expected in ((theta, asin(theta)), (free * cos(theta) + theta, free * sqrt(1 - theta**2) + asin(theta))):
        found = power_series.reverted(sin(theta), theta, 8, outer)
        series_of = by_sympy(expected, theta, 8)
        assert [expand(one - series_of.coeff(theta, n)) for n, one in enumerate(found)] == [0] * 8
    inner = theta + free * theta**2 - theta**3 / (1 + q)
    for outer in (asin(theta), sqrt(1 + theta)):
        found = power_series.composed(outer, theta, 6, inner)
        assert cancel(found - by_sympy(outer.subs(theta, inner), theta, 6)) == 0
