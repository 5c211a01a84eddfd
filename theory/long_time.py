"""The energy after a long time: the Abel equation of the return map to leading order, and what it says of w (a1 = 0).

From ray to ray y = w/q goes to F(y) = y - a y^2 + b y^3 - ... in reduced time pi + O(y^(3/2)). With
A(y) = 1/(a y) + B ln y and B = 1 - b/a^2 the step A(F) - A is 1 + O(y^2), so A grows by 1 per excursion up to a sum
that converges; pi A grows as the time does. Solving it for y gives the expansion in reduced time, logarithm included.
"""

from functools import cache

from sympy import Expr, Symbol, expand, fraction, log, pi

from theory.fraction import in_lowest_terms
from theory.linear import root
from theory.near_critical import cycle_limit
from theory.power_series import composed, taylor
from theory.return_map import return_map_series, scaled_excess
from theory.symbols import diff, q

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
def abel_defect() -> Expr:
    """Coefficients of y^0 and y^1 of A(F(y)) - A(y) - 1, as one polynomial in y: 0."""
    y = scaled_excess
    image = y - step * y**2 + curvature * y**3
    shrink = in_lowest_terms(image / y)
    weight = 1 - curvature / step**2
    change = composed(log(1 + y), y, 2, shrink - 1)
    return expand(taylor(in_lowest_terms((1 / image - 1 / y) / step), y, 2) + weight * change - 1)


def reduced_excess() -> Expr:
    """y at reduced time tau = 1/x on an exit: (pi/(a tau)) (1 - (pi B Lambda + K)/tau), Lambda = ln(a tau/pi)."""
    weight = Symbol("B", real=True)
    return pi * inverse_time / step * (1 - (pi * weight * logarithm + phase) * inverse_time)


@cache
def expansion_defect() -> Expr:
    """pi A(y) - tau - K at ``reduced_excess``, its terms in 1/x and x^0: 0."""
    weight = Symbol("B", real=True)
    y = reduced_excess()
    # ln y = -Lambda + ln(1 - ...), as pi x/a = e^(-Lambda)
    inside = in_lowest_terms(y * step / (pi * inverse_time))
    first = taylor(in_lowest_terms(pi / (step * y) - 1 / inverse_time), inverse_time, 1)
    change = composed(log(1 + inverse_time), inverse_time, 1, inside - 1)
    return expand(first + pi * weight * (change - logarithm) - phase)


@cache
def leading_coefficient() -> Expr:
    """C = lim tau w = q pi/a = 4 pi q/(9 r)."""
    return in_lowest_terms(q * cycle_limit() / map_coefficients()[0])


@cache
def logarithm_coefficient() -> Expr:
    """Coefficient of -C ln(tau)/tau^2 in w: pi B = pi (1 - 2/(5 r))."""
    weight = Symbol("B", real=True)
    slope = diff(expand(reduced_excess() * step / pi), logarithm).coeff(inverse_time, 2)
    return in_lowest_terms((-slope).subs(weight, logarithm_weight()))


def balanced_share() -> Expr:
    """The share r = m2/M at which the logarithm vanishes: 2/5, that is m1/m2 = 3/2."""
    return 1 - root(fraction(logarithm_weight())[0], q)
