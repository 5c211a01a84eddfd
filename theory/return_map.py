"""Every slip that starts on S, in closed form; the return map from ray to ray (a1 = 0, reduced coordinates).

Mirror the pair so that the slip starts at X = 1 + q d, V1 = V2 = sqrt(q) nu with d >= 0 and v1 < v2; on the ray l_+
d = 0.  With the depth c(theta) = 2 - theta cot(theta/2) and h of ``theory.excursion`` it ends at the one angle in
(0, 2 pi) with

    h(theta) - d cot(theta/2) = nu

and there d' = -(d + c), nu' = nu - theta, w' = w - q r c (c + 2 d), duration sqrt(q) theta. From a ray, with y = w/q,
y = h^2 and y' = h^2 - r c^2: the mass ratio enters as a factor only. All expressions are exact unless said otherwise.
"""

from dataclasses import dataclass
from functools import cache

from sympy import Expr, Integer, Rational, Symbol, cos, cot, expand, sin, sqrt

from theory.excursion import h, half_tangent_form, slip_from_outside
from theory.power_series import reverted
from theory.scaling import excess
from theory.symbols import V1, V2, X, diff, epsilon, overshoot, put, q, r, theta

gap = Symbol("d", nonnegative=True)  # (X - 1)/q at the start
push = Symbol("nu", real=True)  # V1/sqrt(q) at the start
scaled_excess = Symbol("y", positive=True)  # w/q


def depth() -> Expr:
    """c(theta) = 2 - theta cot(theta/2): how far inside its edge a slip from a ray ends, X' = 1 - q c."""
    return 2 - theta * cot(theta / 2)


def half_cotangent() -> Expr:
    """cot(theta/2) in sin and cos of theta."""
    return (1 + cos(theta)) / sin(theta)


def contact_condition() -> Expr:
    """h(theta) - d cot(theta/2) - nu: zero exactly at the end of the slip."""
    return h() - gap * cot(theta / 2) - push


@cache
def reduced_guard() -> Expr:
    """(V1 - V2)/sqrt(q) along a slip from S, in d, nu and theta; negative while it lasts."""
    start = {overshoot: q * gap, epsilon: sqrt(q) * push}
    return expand(put(slip_from_outside().guard, start) / sqrt(q))


def in_trigonometry(expression: Expr) -> Expr:
    """Write cot(theta/2) as (1 + cos theta)/sin theta, so that ``half_tangent_form`` decides."""
    return expression.subs(cot(theta / 2), half_cotangent())


@cache
def contact_slope() -> tuple[Expr, Expr]:
    """Derivative of the contact condition in theta as two terms: h' > 0 and d/(2 sin^2(theta/2)) >= 0."""
    return diff(h(), theta), gap / (1 - cos(theta))


@cache
def contact_slope_residual() -> Expr:
    """The derivative minus both terms: 0."""
    return half_tangent_form(diff(in_trigonometry(contact_condition()), theta) - sum(contact_slope()))


@dataclass(frozen=True)
class Landing:
    """Where a slip from S ends: gap d', push nu', and w' - w (dimensionless, exact)."""

    gap: Expr
    push: Expr
    excess_change: Expr


def landing() -> Landing:
    """d' = -(d + c), nu' = nu - theta, w' - w = -q r c (c + 2 d)."""
    return Landing(-(gap + depth()), push - theta, -q * r * depth() * (depth() + 2 * gap))


@cache
def landing_residuals() -> tuple[Expr, Expr, Expr]:
    """Closed form of the slip at its end minus ``landing``: three zeros."""
    contact = h() - gap * half_cotangent()
    start = {overshoot: q * gap, epsilon: sqrt(q) * contact}
    path = slip_from_outside()
    position, velocity = (put(one, start) for one in (path.X, path.V2))
    before = put(excess(), {X: 1 + q * gap, V1: sqrt(q) * contact, V2: sqrt(q) * contact})
    after = put(excess(), {X: position, V1: velocity, V2: velocity})
    claimed = landing()
    return (
        half_tangent_form((position - 1) / q - in_trigonometry(claimed.gap)),
        half_tangent_form(velocity / sqrt(q) - claimed.push.subs(push, contact)),
        half_tangent_form(after - before - in_trigonometry(claimed.excess_change)),
    )


@cache
def depth_slope_residual() -> Expr:
    """c' - h: 0."""
    return half_tangent_form(diff(in_trigonometry(depth()), theta) - h())


def return_map_of_angle() -> tuple[Expr, Expr]:
    """(y, y') of an excursion from a ray as functions of its slip angle: h^2 and h^2 - r c^2, with y = w/q."""
    return h() ** 2, h() ** 2 - r * depth() ** 2


@cache
def return_map_slope_residual() -> Expr:
    """dy'/dy - (1 - r (1 - cos theta)): 0."""
    before, after = (in_trigonometry(one) for one in return_map_of_angle())
    return half_tangent_form(diff(after, theta) / diff(before, theta) - (1 - r * (1 - cos(theta))))


@cache
def depth_series(order: int) -> tuple[Rational, ...]:
    """Coefficients of c as a power series in y = h^2, c_1 y + c_2 y^2 + ... + c_order y^order; exact rationals.

    c is even in theta, and so in u = h(theta).
    """
    coefficients = reverted(h(), theta, 2 * order + 1, in_trigonometry(depth()))
    return tuple(map(Rational, coefficients[2::2]))


@cache
def return_map_series(order: int = 8) -> Expr:
    """y' as a polynomial in y up to y^order with coefficients in r; approximate: higher terms dropped."""
    inner = sum((c * scaled_excess ** (n + 1) for n, c in enumerate(depth_series(order - 1))), Integer(0))
    squared = expand(inner**2)
    kept = sum((squared.coeff(scaled_excess, n) * scaled_excess**n for n in range(2, order + 1)), Integer(0))
    return scaled_excess - r * kept
