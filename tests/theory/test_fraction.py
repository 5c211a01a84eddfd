"""An expression in lowest terms is what sympy's `cancel` makes of it, whole numerators and denominators expanded."""

import pytest
from hypothesis import given
from sympy import Integer, cancel, cos, sin, sqrt

from tests.strategies import trigonometric_quotients
from theory.fraction import factored, in_lowest_terms
from theory.symbols import a2, b, m1, m2, theta, x1

QUOTIENTS = [
    (a2**2 - b**2) / (a2 * m1 + b * m1),
    1 / (1 / m1 + 1 / m2) - m1 * m2 / (m1 + m2),
    (1 - cos(theta)) / (sin(theta) * (1 - cos(theta)) ** 2) + sqrt(a2) ** 3 / (a2 * sqrt(a2)),
    Integer(6) / 4,
]


@pytest.mark.parametrize("expression", QUOTIENTS)
def test_it_is_written_as_cancel_writes_it(expression):
    assert in_lowest_terms(expression) == cancel(expression)


@given(trigonometric_quotients())
def test_it_has_the_value_of_the_expression_and_no_common_factor(expression):
    found = in_lowest_terms(expression)
    assert cancel(found - expression) == 0
    assert in_lowest_terms(found) == found


def test_products_are_found_in_what_is_left():
    assert factored((a2 * m1 + b * m1) / (a2**2 - b**2)) == m1 / (a2 - b)


def test_a_division_by_zero_is_refused():
    with pytest.raises(ZeroDivisionError):
        in_lowest_terms(b / (x1 - (2 * x1 - x1) + (m1 + m2) ** 2 - m1**2 - 2 * m1 * m2 - m2**2))
