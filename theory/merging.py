"""Merging and creeping, decided in closed form for every mass ratio (a1 = 0, reduced coordinates).

A slip from S of slip angle 2 phi is a rotation of (1 + d, u) in which the guard ends where it began, so start and end
lie symmetrically: with the half path T = (d - d')/2 and C = phi cot(phi),

    1 + d = C + T,   u = phi - T cot(phi),   1 + d' = C - T,   u' = -phi - T cot(phi).

The excess after it, w'/q = ``next_excess()``, is a quadratic in T; d >= 0 means T >= 1 - C, with equality on the ray.
The pair merges exactly where it is not positive. All expressions are exact, dimensionless, and hold for 0 < phi < pi.
"""

from functools import cache

from sympy import Expr, Symbol, cos, diff, expand, factor, sin, solve, sqrt

from theory.excursion import angle, half_tangent_form
from theory.return_map import depth, gap, in_trigonometry, landing, push
from theory.symbols import h_value, q, theta

half_path = Symbol("T", real=True)
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


def slip_start() -> tuple[Expr, Expr]:
    """(d, u) at the start of the slip with half angle phi and half path T."""
    return centre() + half_path - 1, angle - half_path * cotangent()


def slip_end() -> tuple[Expr, Expr]:
    """(d', u') at its end."""
    return centre() - half_path - 1, -angle - half_path * cotangent()


def over_q(gap_value: Expr, push_value: Expr) -> Expr:
    """w/q of a state on S with gap d and push u: 2 d + d^2 + u^2 - r d^2."""
    return 2 * gap_value + (1 - share) * gap_value**2 + push_value**2


@cache
def slip_residuals() -> tuple[Expr, ...]:
    """Contact condition, end and change of excess of ``theory.return_map`` at these starts: four zeros."""
    start, end = slip_start(), slip_end()
    at = {gap: start[0], push: start[1], theta: 2 * angle}
    claimed = landing()
    # h = (phi - sin phi cos phi)/sin^2 phi: ``contact_condition`` in the half angle
    contact = ray_push() - start[0] * cotangent() - start[1]
    ends = [in_trigonometry(one).subs(at, simultaneous=True) for one in (claimed.gap, claimed.push)]
    change = in_trigonometry(claimed.excess_change / q).subs(at, simultaneous=True).subs(q, 1 - share)
    residuals = (contact, ends[0] - end[0], ends[1] - end[1], over_q(*end) - over_q(*start) - change)
    return tuple(half_angle_form(one) for one in residuals)


@cache
def next_excess() -> Expr:
    """w'/q = T^2 (1/sin^2 phi - r) - 2 r T (1 - C) + phi^2 + C^2 - 1 - r (1 - C)^2."""
    square = sin(angle) ** 2
    shortfall = 1 - centre()
    return (
        half_path**2 * (1 / square - share)
        - 2 * share * half_path * shortfall
        + angle**2
        + centre() ** 2
        - 1
        - share * shortfall**2
    )


@cache
def next_excess_residual() -> Expr:
    """The excess of the end state over q minus ``next_excess``: 0."""
    return half_angle_form(over_q(*slip_end()) - next_excess())


@cache
def vertex() -> Expr:
    """The half path at which w' is least, solved from its derivative: r (1 - C)/(1/sin^2 phi - r)."""
    return solve(diff(next_excess(), half_path), half_path)[0]


@cache
def vertex_residual() -> Expr:
    """T_v/(1 - C) - r sin^2 phi/(1 - r sin^2 phi): 0, so T_v <= 1 - C exactly if 2 r sin^2 phi <= 1."""
    part = share * sin(angle) ** 2
    return half_angle_form(vertex() / (1 - centre()) - part / (1 - part))


def least_excess() -> Expr:
    """The least w'/q over all half paths: phi^2 + C^2 - 1 - r (1 - C)^2/(1 - r sin^2 phi)."""
    shortfall = 1 - centre()
    return angle**2 + centre() ** 2 - 1 - share * shortfall**2 / (1 - share * sin(angle) ** 2)


@cache
def least_excess_residual() -> Expr:
    """w'/q at the vertex minus ``least_excess``: 0."""
    return half_angle_form(next_excess().subs(half_path, vertex()) - least_excess())


def least_excess_slope() -> tuple[Expr, ...]:
    """Its derivative in phi in factors: 2, 1 - C, 1/sin^2, 1 - 2 r sin^2, phi - r (phi - sin cos), (1 - r sin^2)^-2.

    Where 2 r sin^2 phi > 1 the fourth is negative and all others are positive: the least excess falls there.
    """
    part = share * sin(angle) ** 2
    return (
        2 * (1 - centre()),
        1 / sin(angle) ** 2,
        1 - 2 * part,
        angle - share * (angle - sin(angle) * cos(angle)),
        1 / (1 - part) ** 2,
    )


@cache
def least_excess_slope_residual() -> Expr:
    """The derivative of ``least_excess`` minus the product of its factors: 0."""
    product = 1
    for one in least_excess_slope():
        product *= one
    return half_angle_form(diff(least_excess(), angle) - product)


def ray_push() -> Expr:
    """h in the half angle: (phi - sin phi cos phi)/sin^2 phi."""
    return (angle - sin(angle) * cos(angle)) / sin(angle) ** 2


def ray_excess() -> Expr:
    """w'/q of the excursion from the ray: h^2 - r c^2."""
    return ray_push() ** 2 - 4 * share * (1 - centre()) ** 2


@cache
def ray_residuals() -> tuple[Expr, Expr, Expr]:
    """u - h and w'/q - (h^2 - r c^2) at T = 1 - C, and the depth c - 2 (1 - C): three zeros."""
    ray = {half_path: 1 - centre()}
    return (
        half_angle_form(slip_start()[1].subs(ray) - ray_push()),
        half_angle_form(next_excess().subs(ray) - ray_excess()),
        half_angle_form(in_trigonometry(depth()).subs(theta, 2 * angle) - 2 * (1 - centre())),
    )


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
    return factor(solve(share * (1 + h_value) - 1, h_value)[0].subs(share, critical_share()))


@cache
def critical_mass_ratio_residual() -> Expr:
    """(1 - r*)/r* + cos(theta*): 0."""
    return half_angle_form(critical_mass_ratio() + cos(2 * angle))
