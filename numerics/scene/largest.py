"""The largest size of a function on an interval, by branch and bound; a piece of a signal as such a function."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import arb, arb_poly, fmpq

from numerics.scene.pieces import Piece

_MOST_PARTS = 20_000
_INSIDE = arb("0.382")
"""Where a part is looked at, too: at halves of halves of a period sines of decimal frequencies have one phase."""


def largest_size(
    function: Callable[[arb, int], arb], start: arb, end: arb, digits: int, enough: arb | None = None
) -> tuple[arb, arb]:
    """Return an enclosure of max |f| over an interval to about `digits` digits, and where it is reached.

    A coarser one serves where it is above `enough`, and where more takes too long; where |f| is nowhere above `enough`,
    nor is what is returned. `function` encloses f, f' or f'' (0, 1, 2) over a ball. The interval is halved; parts that
    cannot hold the largest value are dropped.
    """

    def bound(low: arb, high: arb) -> arb:
        """Return an upper bound of |f| on a part, by Taylor's theorem where that is the better one."""
        part = low.union(high)
        plain = abs(function(part, 0)).upper()
        if enough is not None and plain <= enough:
            return plain
        middle, h = part.mid(), part - part.mid()
        wide = function(middle, 0) + h * function(middle, 1) + h * h / 2 * function(part, 2)
        return plain.min(abs(wide).upper())

    parts, best, where = [(start.lower(), end.upper())], arb(-1), start
    most = best
    while 0 < len(parts) <= _MOST_PARTS and all(low < high for low, high in parts):
        halves = []
        for low, high in parts:
            middle = ((low + high) / 2).mid()
            halves += [(low, middle), (middle, high)]
        looked_at = [*(low for low, _ in halves), end.upper()]
        if enough is not None:
            looked_at += [(low + (high - low) * _INSIDE).mid() for low, high in halves]
        for t in looked_at:
            if (here := abs(function(t, 0)).lower()) > best:
                best, where = here, t
        bounded = [(half, bound(*half)) for half in halves]
        floor = best if enough is None else best.max(enough)
        parts = [half for half, top in bounded if top > floor]
        most = max([best, *(top for _, top in bounded)])
        if most - best <= most * arb(10) ** -digits or (enough is not None and best > enough):
            break
    return best.union(most), where


def over(piece: Piece) -> Callable[..., arb]:
    """Return a piece, or a derivative of it, as a function of a ball of times (s) and the order; in present digits."""
    begin, polynomial = ball(piece.start), arb_poly(list(map(ball, piece.polynomial)))
    sines = [(ball(one.amplitude), ball(one.omega), ball(one.phase)) for one in piece.sines]

    def at(t: arb, order: int = 0) -> arb:
        turn, slope = order * arb.pi() / 2, polynomial
        for _ in range(order):
            slope = slope.derivative()
        waves = (size * omega**order * (omega * t + phase + turn).sin() for size, omega, phase in sines)
        return sum(waves, slope(t - begin))

    return at


def ball(value: Fraction) -> arb:
    """Return a ball that contains an exact rational."""
    return arb(fmpq(value.numerator, value.denominator))
