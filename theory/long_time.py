"""The energy after a long time: the Abel equation of the return map to leading order, and what it says of w (a1 = 0).

From ray to ray y = w/q goes to F(y) = y - a y^2 + b y^3 - ... in reduced time pi + O(y^(3/2)). With
A(y) = 1/(a y) + B ln y and B = 1 - b/a^2 the step A(F) - A is 1 + O(y^2), so A grows by 1 per excursion up to a sum
that converges; pi A grows as the time does. Solving it for y gives the expansion in reduced time, logarithm included.
"""

from functools import cache

from sympy import Expr, Symbol, expand, fraction

from theory.fraction import in_lowest_terms
from theory.linear import root
from theory.near_critical import cycle_limit
from theory.return_map import return_map_series, scaled_excess
from theory.symbols import q

step = Symbol("a", positive=True)
curvature = Symbol("b", positive=True)
logarithm = Symbol("Lambda", real=True)  # ln(a tau/pi)
phase = Symbol("K", real=True)  # beta(y_0) - tau_0, one number per trajectory
inverse_time = Symbol("x", positive=True)  # 1/tau


@cache
def map_coefficients() -> tuple[Expr, Expr]:
    """(a, b) of F(y) = y - a y^2 + b y^3 - ..., exact in the mass ratio: 9 r/4 and 81 r/40."""
    polynomial = expand(return_map_series())
    return in_lowest_terms(-polynomial.coeff(scaled_excess, 2)), in_lowest_terms(polynomial.coeff(scaled_excess, 3))


def logarithm_weight() -> Expr:
    """B = 1 - b/a^2, the coefficient of ln y in the Abel function: 1 - 2/(5 r)."""
    first, second = map_coefficients()
    return in_lowest_terms(1 - second / first**2)


@cache
def leading_coefficient() -> Expr:
    """C = lim tau w = q pi/a = 4 pi q/(9 r)."""
    return in_lowest_terms(q * cycle_limit() / map_coefficients()[0])


def balanced_share() -> Expr:
    """The share r = m2/M at which the logarithm vanishes: 2/5, that is m1/m2 = 3/2."""
    return 1 - root(fraction(logarithm_weight())[0], q)
