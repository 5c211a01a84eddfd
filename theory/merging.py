"""Merging and creeping, decided in closed form for every mass ratio (a1 = 0, reduced coordinates).

A slip from a ray of slip angle 2 phi has the push h and the depth c = 2 (1 - C), C = phi cot(phi). The excess after it
is q (h^2 - r c^2): the pair merges exactly where R = h/c has R^2 <= r. All expressions are exact,
dimensionless, and hold for 0 < phi < pi.
"""

from functools import cache

from sympy import Expr, Symbol, cos, sin, sqrt

from theory.excursion import angle
from theory.fraction import factored
from theory.linear import root
from theory.symbols import h_value

share = Symbol("r", positive=True)  # m2/(m1 + m2), here independent of q: the statements are for every value in (0, 1)


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


def turning_parts() -> tuple[Expr, Expr]:
    """A = phi - sin phi cos phi and B = sin phi - phi cos phi, both positive."""
    return angle - sin(angle) * cos(angle), sin(angle) - angle * cos(angle)


def turning_function() -> Expr:
    """K = A - sqrt(2) B: its one zero phi* in (0, pi) is where R is least."""
    first, second = turning_parts()
    return first - sqrt(2) * second


def critical_share() -> Expr:
    """r* = 1/(2 sin^2 phi*) as a function of the root phi*: there R^2 = r*."""
    return 1 / (2 * sin(angle) ** 2)


@cache
def critical_mass_ratio() -> Expr:
    """m1/m2 = (1 - r*)/r* at the threshold: -cos(2 phi*), the slip angle's own cosine."""
    return factored(root(share * (1 + h_value) - 1, h_value).subs(share, critical_share()))
