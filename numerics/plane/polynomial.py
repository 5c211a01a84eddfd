"""Polynomials on 0 <= x <= 1 with balls for coefficients: bounds, and the first root."""

from __future__ import annotations

import math
from typing import Any

import flint
from flint import arb, arb_poly

_ANY, _ONE = arb(0, 1), arb(1)
_PARTS = 2**-40
"""Below this width nothing is looked for any more."""


def scaled(p: Any, by: arb) -> arb_poly:
    """Return p(by x) with midpoints for coefficients: the polynomial that is followed, exactly."""
    return midpoints(arb_poly(p)(arb_poly([0, by])))


def midpoints(p: Any) -> arb_poly:
    """Return the polynomial, or what there is of a series, with the midpoints of the coefficients."""
    return arb_poly([one.mid() for one in p.coeffs()])


def total(p: arb_poly) -> arb:
    """Return a bound on |p| on [0, 1]: a polynomial with the sizes of the coefficients is among p times [-1, 1]."""
    return (p * _ANY)(_ONE).upper()


def integral_bound(p: arb_poly) -> arb:
    """Return a bound on the integral of |p| over [0, 1], in the same way."""
    return (p * _ANY).integral()(_ONE).upper()


def on(p: arb_poly, a: float, b: float) -> tuple[arb, arb]:
    """Return p in the middle of [a, b], and a bound on how far it is from that on [a, b]; a and b have few bits."""
    q = p(arb_poly([(arb(a) + b) / 2, (arb(b) - a) / 2]))  # of a variable between -1 and 1
    return q[0], total(q - q[0])


def least(p: arb_poly) -> arb:
    """Return a lower bound of p on [0, 1], within a half of the least if that is > 0; else one that is not > 0."""
    found, waiting = arb("inf"), [(0.0, 1.0)]
    while waiting:
        a, b = waiting.pop()
        first, rest = on(p, a, b)
        low = (first - rest).lower()
        if 2 * low < first and b - a > 2**-10:
            if not (p(arb(a)) > 0 and p(arb(b)) > 0):
                return low
            middle = (a + b) / 2
            waiting += [(a, middle), (middle, b)]
        else:
            found = found.min(low)
    return found


def first_root(p: arb_poly, error: arb, start: float = 0.0) -> tuple[arb, arb] | bool | None:
    """Return where a function that p gives to `error` falls to 0 first after `start`: x and how far it may be off.

    None if it stays > 0; False if that is not decided. It is > 0 where p > error, < 0 where p < -error, and p itself
    falls between: so its first zero is there.
    """
    slope, waiting = p.derivative(), [(start, 1.0)]
    while waiting:
        a, b = waiting.pop()
        value, rest = on(p, a, b)
        if value - rest > error:
            continue
        steep, bend = on(slope, a, b)
        room = -steep - bend
        if steep > bend and p(arb(a)) > error:
            continue
        if room > 0:
            if p(arb(b)) > error:
                continue
            if p(arb(a)) > error and p(arb(b)) < -error:
                x = _newton(p, slope, arb(a), arb(b))
                return x, ((error + abs(p(x))) / room).upper()
        if b - a < _PARTS:
            return False
        middle = (a + b) / 2
        waiting += [(middle, b), (a, middle)]
    return None


def _newton(p: arb_poly, slope: arb_poly, low: arb, high: arb) -> arb:
    """Return about the root of a falling polynomial between two points."""
    x = (low + high) / 2
    for _ in range(300):
        value = p(x).mid()
        low, high = (x, high) if value > 0 else (low, x)
        after = (x - value / slope(x)).mid()
        if not low <= after <= high:
            after = ((low + high) / 2).mid()
        if abs(after - x) <= abs(x) * arb((1, -math.ceil(0.9 * flint.ctx.prec))) or after == x:
            return after
        x = after
    return x


def rise(p: arb_poly, value: arb) -> arb:
    """Return x in [0, 1] at which a rising polynomial has a value, about."""
    return _newton(value - p, -p.derivative(), arb(0), arb(1))


def log2(x: Any) -> float:
    """Return the logarithm of the size of a number, -inf for 0."""
    middle = abs(arb(x).mid())
    return -math.inf if middle.is_zero() else float(middle.log()) / math.log(2)


def two_to(power: float) -> arb:
    """Return 2^power, about."""
    return (arb(2) ** arb(power)).mid()
