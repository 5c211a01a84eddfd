"""Merging and creeping, decided in closed form for every mass ratio (a1 = 0, reduced coordinates).

A slip from a ray of slip angle 2 phi has the push h and the depth c = 2 (1 - C), C = phi cot(phi). The excess after it
is q (h^2 - r c^2): the pair merges exactly where R = h/c has R^2 <= r. All expressions are exact,
dimensionless, and hold for 0 < phi < pi.
"""

from functools import cache

from sympy import Expr, Symbol, cos, expand, sin, sqrt

from theory.excursion import angle, half_tangent_form
from theory.fraction import factored
from theory.linear import root
from theory.symbols import diff, h_value, theta

share = Symbol("r", positive=True)  # m2/(m1 + m2), here independent of q: the statements are for every value in (0, 1)


def half_angle_form(expression: Expr) -> Expr:
    """An expression in phi, sin phi, cos phi as a fraction in phi and tan(phi/2): 0 exactly if the expression is."""
    return half_tangent_form(expression.subs(angle, theta))


def cotangent() -> Expr:
    """Cot phi in sin and cos."""
    return cos(angle) / sin(angle)


def centre() -> Expr:
    """C = phi cot phi, below 1: half the depth is 1 - C."""
    return angle * cotangent()


def over_q(gap_value: Expr, push_value: Expr) -> Expr:
    """w/q of a state on S with gap d and push u: 2 d + d^2 + u^2 - r d^2."""
    return 2 * gap_value + (1 - share) * gap_value**2 + push_value**2


def ray_push() -> Expr:
    """h in the half angle: (phi - sin phi cos phi)/sin^2 phi."""
    return (angle - sin(angle) * cos(angle)) / sin(angle) ** 2


@cache
def ratio() -> Expr:
    """R = h/c: an excursion from a ray merges exactly if R^2 <= r."""
    return ray_push() / (2 * (1 - centre()))


@cache
def ratio_slope_residual() -> Expr:
    """dR/dphi - (1/sin^2 phi - 2 R^2): 0. R falls exactly where 2 R^2 sin^2 phi > 1."""
    return half_angle_form(diff(ratio(), angle) - (1 / sin(angle) ** 2 - 2 * ratio() ** 2))


def turning_parts() -> tuple[Expr, Expr]:
    """A = phi - sin phi cos phi and B = sin phi - phi cos phi, both positive."""
    return angle - sin(angle) * cos(angle), sin(angle) - angle * cos(angle)


@cache
def turning_residual() -> Expr:
    """2 R^2 sin^2 phi - A^2/(2 B^2): 0, so R falls exactly where A > sqrt(2) B."""
    first, second = turning_parts()
    return half_angle_form(2 * ratio() ** 2 * sin(angle) ** 2 - first**2 / (2 * second**2))


def turning_function() -> Expr:
    """K = A - sqrt(2) B: its one zero phi* in (0, pi) is where R is least."""
    first, second = turning_parts()
    return first - sqrt(2) * second


def turning_slope() -> tuple[Expr, Expr]:
    """K' as sin phi > 0 times 2 sin phi - sqrt(2) phi, which is positive and then negative on (0, pi]."""
    return sin(angle), 2 * sin(angle) - sqrt(2) * angle


@cache
def turning_slope_residual() -> Expr:
    """K' minus its factors: 0."""
    first, second = turning_slope()
    return expand(expand(diff(turning_function(), angle)).subs(cos(angle) ** 2, 1 - sin(angle) ** 2) - first * second)


def critical_share() -> Expr:
    """r* = 1/(2 sin^2 phi*) as a function of the root phi*: there R^2 = r*."""
    return 1 / (2 * sin(angle) ** 2)


@cache
def critical_mass_ratio() -> Expr:
    """m1/m2 = (1 - r*)/r* at the threshold: -cos(2 phi*), the slip angle's own cosine."""
    return factored(root(share * (1 + h_value) - 1, h_value).subs(share, critical_share()))


@cache
def critical_mass_ratio_residual() -> Expr:
    """(1 - r*)/r* + cos(theta*): 0."""
    return half_angle_form(critical_mass_ratio() + cos(2 * angle))
