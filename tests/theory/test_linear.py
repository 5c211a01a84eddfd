"""The root of a linear equation is that of sympy's `solve`; what is not linear is refused."""

import pytest
from sympy import cancel, cos, solve, sqrt

from theory.linear import root
from theory.symbols import a2, b, m1, m2, theta, v1, x1


@pytest.mark.parametrize(
    "expression",
    [a2 * x1 - b * (m1 + m2) / m2, (x1 - v1) ** 2 - (x1 + v1) ** 2 + b, (x1 + 1) * sqrt(a2) + cos(theta) * x1],
)
def test_the_root_is_the_one_of_solve(expression):
    (expected,) = solve(expression, x1)
    assert cancel(root(expression, x1) - expected) == 0


@pytest.mark.parametrize("expression", [a2 * x1**2 - b, a2 * v1, cos(x1)])
def test_what_is_not_linear_is_refused(expression):
    with pytest.raises(ValueError, match="is not linear in x1"):
        root(expression, x1)
