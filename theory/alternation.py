"""Long and short slips in turn: what follows where a slip from S crosses S instead of re-entering S0 (a1 = 0).

With k = cot(theta/2), algebraically independent of theta, h = (theta (1 + k^2) - 2 k)/2 and c = 2 - theta k are
polynomials. A slip with gap d at its start ends at D = d + c beyond its edge with the push u' = theta - u; it crosses
if D > 2/q, and the next one starts with the gap e = D - 2/q. theta_c has c = 2/q; kappa = -cot(theta_c/2), and
2 pi - theta_c is where short slips end. All expressions are exact and dimensionless; each residual is 0.
"""

from functools import cache

from sympy import Expr, Integer, Symbol, cancel, cos, cot, diff, expand, pi, sin

from theory.excursion import h
from theory.return_map import depth, landing, push
from theory.symbols import q, theta

half_cotangent = Symbol("k", real=True)  # cot(theta/2)
reach = Symbol("D", positive=True)  # d + c
critical_cotangent = Symbol("kappa", positive=True)  # -cot(theta_c/2)
critical_angle = Symbol("theta_c", positive=True)
supplement = Symbol("psi", positive=True)  # pi - theta_c/2, so that kappa = cot(psi)


@cache
def in_cotangent(expression: Expr) -> Expr:
    """An expression in theta, sin, cos and cot(theta/2) as a polynomial in theta and k, where it is one."""
    k = half_cotangent
    circle = {sin(theta): 2 * k / (1 + k**2), cos(theta): (k**2 - 1) / (1 + k**2), cot(theta / 2): k}
    return expand(cancel(expression.subs(circle, simultaneous=True)))


def rise() -> Expr:
    """h as a polynomial in theta and k."""
    return in_cotangent(h())


def depth_of() -> Expr:
    """c as a polynomial in theta and k."""
    return in_cotangent(depth())


def rate(expression: Expr) -> Expr:
    """Derivative in theta of a polynomial in theta and k, as k' = -(1 + k^2)/2."""
    k = half_cotangent
    return expand(diff(expression, theta) - (1 + k**2) / 2 * diff(expression, k))


def next_push() -> Expr:
    """u' = theta - u = h + k D: the push of the slip after a crossing."""
    return rise() + half_cotangent * reach


def next_push_residual() -> Expr:
    """The same from ``theory.return_map`` with u = h - d k and d = D - c, mirrored, minus this."""
    start = rise() - (reach - depth_of()) * half_cotangent
    return expand(-landing().push.subs(push, start) - next_push())


def next_gap() -> Expr:
    """e = D - 2/q: how far beyond the other edge."""
    return reach - 2 / q


def falling_part_residual() -> Expr:
    """(h + 2 k/q)' - (c - 2/q)(1 + k^2)/2."""
    part = rise() + 2 * half_cotangent / q
    return expand(rate(part) - (depth_of() - 2 / q) * (1 + half_cotangent**2) / 2)


def long_to_short() -> Expr:
    """The contact function of the next slip at 2 pi - theta_c, less its rise there, for the least D = c."""
    at_least = next_gap().subs(reach, depth_of()) * critical_cotangent
    return expand(-at_least - next_push().subs(reach, depth_of()))


def long_to_short_slope_residual() -> Expr:
    """Its derivative in theta minus h (-k - kappa): it grows from theta_c on, where -k >= kappa."""
    return expand(rate(long_to_short()) - rise() * (-half_cotangent - critical_cotangent))


def spread_residual() -> Expr:
    """The contact function at any D minus that at D = c is (-k - kappa)(D - c), never negative for a long slip."""
    at = -next_gap() * critical_cotangent - next_push()
    return expand(at - long_to_short() - (-half_cotangent - critical_cotangent) * (reach - depth_of()))


def at_critical_angle(expression: Expr) -> Expr:
    """An expression at theta = theta_c, where k = -kappa and 2/q = c = 2 + theta_c kappa."""
    place = {theta: critical_angle, half_cotangent: -critical_cotangent}
    return expand(expression.subs(q, 2 / (2 + critical_angle * critical_cotangent)).subs(place))


def rise_of_supplement() -> Expr:
    """h at 2 pi - theta_c, where k = kappa."""
    return expand(rise().subs({theta: 2 * pi - critical_angle, half_cotangent: critical_cotangent}))


def margin() -> Expr:
    """P = pi (1 + kappa^2) - theta_c."""
    return pi * (1 + critical_cotangent**2) - critical_angle


def long_margin_residual() -> Expr:
    """The contact function of the next slip at 2 pi - theta_c after the slip theta_c minus P."""
    return expand(rise_of_supplement() + at_critical_angle(long_to_short()) - margin())


def short_margin_residual() -> Expr:
    """h + 2 k/q at 2 pi - theta_c minus h(theta_c) + P: what the push after a short crossing exceeds."""
    part = rise_of_supplement() + 2 * critical_cotangent / q
    part = part.subs(q, 2 / (2 + critical_angle * critical_cotangent))
    return expand(part - at_critical_angle(rise()) - margin())


def push_residual() -> Expr:
    """u' - kappa e - (h + 2 k/q) - (k - kappa) e."""
    left = next_push() - critical_cotangent * next_gap()
    right = rise() + 2 * half_cotangent / q + (half_cotangent - critical_cotangent) * next_gap()
    return expand(left - right)


def landing_excess() -> Expr:
    """w'/q at the end of a slip in S0: h^2 - 2 (1 - h k) D + (k^2 + q) D^2."""
    product = rise() * half_cotangent
    return rise() ** 2 - 2 * (1 - product) * reach + (half_cotangent**2 + q) * reach**2


def landing_excess_residual() -> Expr:
    """The excess over q of the gap -D and the push h + k D, 2 d + q d^2 + u^2, minus this."""
    return expand(-2 * reach + q * reach**2 + next_push() ** 2 - landing_excess())


def margin_in_supplement() -> Expr:
    """P with theta_c = 2 (pi - psi), kappa = cot psi: pi/sin^2 psi - 2 pi + 2 psi, which is 0 at psi = pi/3."""
    return pi / sin(supplement) ** 2 - 2 * pi + 2 * supplement


def margin_in_supplement_residual() -> Expr:
    """P at these minus this, times sin^2 psi."""
    place = {critical_cotangent: cos(supplement) / sin(supplement), critical_angle: 2 * pi - 2 * supplement}
    difference = (margin().subs(place) - margin_in_supplement()) * sin(supplement) ** 2
    return expand(expand(difference).subs(cos(supplement) ** 2, Integer(1) - sin(supplement) ** 2))
