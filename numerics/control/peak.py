"""The largest size of a function on an interval, enclosed by branch and bound."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb

from numerics.arithmetic.ball import undecided

_MOST_PARTS = 20_000


def largest_size(
    function: Callable[[arb, int], arb], start: arb, end: arb, digits: int, enough: arb | None = None
) -> tuple[arb, arb]:
    """Return an enclosure of max |f| over an interval to about `digits` digits, and where it is reached.

    A coarser one serves as soon as it is above `enough`. `function` encloses f, f' or f'' (0, 1, 2) over a ball. The
    interval is halved; parts that cannot hold the largest value are dropped. Raises EventUndecided.
    """

    def bound(low: arb, high: arb) -> arb:
        """Return an upper bound of |f| on a part, by Taylor's theorem where that is the better one."""
        part = low.union(high)
        middle, h = part.mid(), part - part.mid()
        wide = function(middle, 0) + h * function(middle, 1) + h * h / 2 * function(part, 2)
        return abs(function(part, 0)).upper().min(abs(wide).upper())

    parts, best, where = [(start.lower(), end.upper())], arb(-1), start
    while 0 < len(parts) <= _MOST_PARTS and all(low < high for low, high in parts):
        halves = []
        for low, high in parts:
            middle = ((low + high) / 2).mid()
            halves += [(low, middle), (middle, high)]
        for t in (*(low for low, _ in halves), end.upper()):
            if (here := abs(function(t, 0)).lower()) > best:
                best, where = here, t
        bounded = [(half, bound(*half)) for half in halves]
        parts = [half for half, most in bounded if most > best]
        most = max([best, *(most for _, most in bounded)])
        if most - best <= most * arb(10) ** -digits or (enough is not None and best > enough):
            return best.union(most), where
    raise undecided("how large does the acceleration get?", best)
