"""Polynomials on 0 <= x <= 1 with balls for coefficients: bounds, and the first root."""

from __future__ import annotations

import math
from typing import Any

from flint import arb, arb_poly

from numerics.arithmetic.root import approximate_root, first_fall

_ANY, _ONE = arb(0, 1), arb(1)
_SHORTEST = arb((1, -40))
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


def on(p: arb_poly, x: arb) -> arb:
    """Return an enclosure of p over a ball, by its polynomial about the midpoint."""
    if x.is_exact():
        return p(x)
    q = p(arb_poly([x.mid(), x.rad()]))  # of a variable between -1 and 1
    return q[0] + arb(0, total(q - q[0]))


def least(p: arb_poly) -> arb:
    """Return a lower bound of p on [0, 1], within a half of the least if that is > 0; else one that is not > 0."""
    found, waiting = arb("inf"), [(0.0, 1.0)]
    while waiting:
        a, b = waiting.pop()
        here = on(p, arb((a + b) / 2, (b - a) / 2))
        low = here.lower()
        if 2 * low < here.mid() and b - a > 2**-10:
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
    slope = p.derivative()
    found = first_fall(arb(start), _ONE, lambda x: (on(p, x), on(slope, x)), error, _SHORTEST)
    if not isinstance(found, tuple):
        return found
    x, room = _root(p, *found), (-on(slope, found[0].union(found[1]))).lower()
    missed = error + abs(p(x))
    # it falls as quickly at least as anywhere so near
    return x, (missed / room.max((-on(slope, x + arb(0, (missed / room).upper()))).lower())).upper()


def _root(p: arb_poly, low: arb, high: arb) -> arb:
    slope = p.derivative()
    return approximate_root(low, high, lambda x: (p(x), slope(x)))


def rise(p: arb_poly, value: arb) -> arb:
    """Return x in [0, 1] at which a rising polynomial has a value, about."""
    return _root(value - p, arb(0), _ONE)


def log2(x: Any) -> float:
    """Return the logarithm of the size of a number, -inf for 0."""
    middle = abs(arb(x).mid())
    return -math.inf if middle.is_zero() else float(middle.log()) / math.log(2)


def two_to(power: float) -> arb:
    """Return 2^power, about."""
    return (arb(2) ** arb(power)).mid()
