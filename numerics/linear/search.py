"""Where guards stay positive, and which of them falls through zero first: from polynomials, nothing is sampled.

On an interval a polynomial lies between the least and the greatest of its Bernstein coefficients. They are formed in
balls, so no rounding is lost, and what the polynomial leaves out is added to its bounds.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import flint
from flint import arb, arb_mat, arb_poly

from numerics.arithmetic.ball import Ball, widened

CLEAR, UNKNOWN = -1, -2
"""No guard vanishes; that is not proved. Otherwise the answer is the index of the guard that does."""
_RATIO, _BEHIND = arb("0.4873"), arb((1, -12))
"""Intervals are cut a little below their middle: a root at a round number is then seldom an end of one. When they are
shorter than the time behind them by the second factor, it is better to look again from there."""


class Curve(NamedTuple):
    """A function of time by a polynomial of so many terms, which leaves out `rest` t^terms at most.

    A guard is positive in a mode; its derivative of an `order`, of which all lower ones vanish at 0, is off by `margin`
    from that of the true motion. `row` says of which row it is, `kind` what it means (cells.py).
    """

    polynomial: arb_poly
    rest: arb
    terms: int
    margin: arb = arb(0)
    order: int = 0
    row: int = 0
    kind: int = 0

    def left_out(self, t: arb, order: int) -> arb:
        """Return a bound on what a derivative leaves out up to t."""
        return self.rest * (t ** (self.terms - order) * math.perm(self.terms, order))

    def derived(self, order: int) -> arb_poly:
        """Return a derivative of the polynomial."""
        found = self.polynomial
        for _ in range(order):
            found = found.derivative()
        return found

    def at(self, t: arb, order: int = 0) -> arb:
        """Return an enclosure of a derivative over a ball of times."""
        return widened(self.derived(order)(t), self.left_out(t.abs_upper(), order))


class Clear(NamedTuple):
    """Up to `since` no guard vanishes; in the interval h behind it one falls through zero once, if there is a `hit`."""

    since: arb
    h: arb
    hit: int = CLEAR


def bernstein(p: arb_poly, since: arb, h: arb) -> list[arb]:
    """Return the Bernstein coefficients of a polynomial from `since` on for a time h."""
    shifted = p(arb_poly([since, h])).coeffs() or [arb(0)]
    return (_bernstein_matrix(len(shifted) - 1, flint.ctx.prec) * arb_mat(len(shifted), 1, shifted)).entries()


@lru_cache(maxsize=64)
def _bernstein_matrix(degree: int, _: int) -> arb_mat:
    number, row = Ball.number, range(degree + 1)
    return arb_mat([[number(Fraction(math.comb(i, k), math.comb(degree, k))) for k in row] for i in row])


def look(curves: Sequence[Curve], since: arb, h: arb) -> int:
    """Return whether no curve vanishes behind `since` for a time h, or which one falls through zero there, once.

    At an end that counts the sign is proved, too.
    """
    hit, end = CLEAR, since + h
    for index, one in enumerate(curves):
        values, off = bernstein(one.derived(one.order), since, h), one.left_out(end, one.order) + one.margin
        if all(value > off for value in values):
            continue
        # the slope has the Bernstein coefficients n (b_k+1 - b_k)/h
        slack = one.left_out(end, 1) * h / max(1, len(values) - 1)
        if one.order or len(values) == 1 or not all(two - before < -slack for before, two in pairwise(values)):
            return UNKNOWN
        if values[-1] > off:
            continue
        if not -values[-1] > off or hit != CLEAR:
            return UNKNOWN
        hit = index
    return hit


def march(
    first: Sequence[Curve], later: Sequence[Curve], reach: arb, h: arb, least: arb, *, finds: bool = True
) -> Clear | None:
    """Return up to where no curve vanishes within reach, and what it finds there; None if digits do not tell anything.

    The first interval looked at has length h, and the `first` curves; behind it are the `later` ones. None is shorter
    than `least`.
    """
    since, curves = arb(0), first
    while h > least.max(since * _BEHIND):
        hit = look(curves, since, h)
        if hit == UNKNOWN or (hit != CLEAR and not finds):
            h = (h * _RATIO).mid()
        elif hit != CLEAR:
            return Clear(since, h, hit)
        elif not since + h < reach:
            return Clear(reach, reach)
        else:
            since, h, curves = (since + h).mid(), 2 * h, later
            left = (reach - since).upper()
            h = left if left < 2 * h else h
    return Clear(since, h) if since > 0 else None


def newton(curve: arb_poly, low: arb, high: arb, at: arb, settled: arb) -> arb:
    """Return the root of a falling function between low and high from a guess; a change below `settled` is the last."""
    slope = curve.derivative()
    for _ in range(2_000):
        value = curve(at).mid()
        if value > 0:
            low = at
        else:
            high = at
        change = (value / slope(at)).mid()
        after = (at - change).mid()
        if abs(change) < settled:
            return after
        at = after if low < after < high else ((low + high) / 2).mid()
    return at
