"""The largest size of a function on an interval, by branch and bound; a piece of a signal as such a function."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

from flint import arb, arb_poly, fmpq

from numerics.scene.pieces import Piece

_MOST_PARTS = 20_000


def largest_size(
    function: Callable[[arb, int], arb], start: arb, end: arb, digits: int, enough: arb | None = None
) -> tuple[arb, arb]:
    """Return an enclosure of max |f| over an interval to about `digits` digits, and where it is reached.

    A coarser one serves where it is above `enough`, or not, and where more takes too long. `function` encloses f, f' or
    f'' (0, 1, 2) over a ball. The interval is halved; parts that cannot hold the largest value are dropped.
    """

    def bound(low: arb, high: arb) -> arb:
        """Return an upper bound of |f| on a part, by Taylor's theorem where that is the better one."""
        part = low.union(high)
        middle, h = part.mid(), part - part.mid()
        wide = function(middle, 0) + h * function(middle, 1) + h * h / 2 * function(part, 2)
        return abs(function(part, 0)).upper().min(abs(wide).upper())

    parts, best, where = [(start.lower(), end.upper())], arb(-1), start
    most = best
    while 0 < len(parts) <= _MOST_PARTS and all(low < high for low, high in parts):
        halves = []
        for low, high in parts:
            middle = ((low + high) / 2).mid()
            halves += [(low, middle), (middle, high)]
        for t in (*(low for low, _ in halves), end.upper()):
            if (here := abs(function(t, 0)).lower()) > best:
                best, where = here, t
        bounded = [(half, bound(*half)) for half in halves]
        parts = [half for half, top in bounded if top > best]
        most = max([best, *(top for _, top in bounded)])
        if most - best <= most * arb(10) ** -digits or (enough is not None and (best > enough or most <= enough)):
            break
    return best.union(most), where


def over(piece: Piece, t: arb, order: int = 0) -> arb:
    """Return an enclosure of a derivative of a piece over a ball of times (s)."""
    terms = [math.perm(k, order) * c for k, c in enumerate(piece.polynomial)][order:]
    total = arb_poly(list(map(ball, terms)))(t - ball(piece.start))
    for one in piece.sines:
        turned = ball(one.omega) * t + ball(one.phase) + order * arb.pi() / 2
        total += ball(one.amplitude * one.omega**order) * turned.sin()
    return total


def ball(value: Fraction) -> arb:
    """Return a ball that contains an exact rational."""
    return arb(fmpq(value.numerator, value.denominator))
