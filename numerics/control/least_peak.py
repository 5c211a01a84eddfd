"""The stuck motion from rest to rest over D in the time T with the least max |u|.

Without a limit u changes its sign at the zeros of a w with M w'' = a1 w' - a2 w: at s and, if a1^2 < 4 M a2, every half
period later. From that optimal.py searches for the motion with |a| <= beta. The end alone needs u = a2 D + M a, that is
a2 D - M beta or more however long the time is: where more time brings nothing no such motion is found.
"""

from __future__ import annotations

from fractions import Fraction

import flint
from flint import arb

from numerics.arithmetic.ball import working_digits
from numerics.control.optimal import Arc, Motion, Row, Search
from numerics.control.thresholds import pushed
from numerics.errors import NotSettled
from numerics.scene import Pair, Piece
from numerics.scene.decimals import short

_ROUNDED = 8
"""At the limit of friction u may be above its peak in the last of its decimals, so many."""


class LeastPeak(Search):
    """max |u/M|."""

    least = "peak"

    def start(self) -> tuple[arb, arb]:
        """Return q(0), r(0) of the w that is 0 at s: the impulse response of the stuck pair backwards from there."""
        pair = self.pair
        push = pushed(Pair(pair.mass, 1, pair.a2, 1, pair.a1))
        square = self.k - self.c * self.c / 4
        every = arb.pi() / square.sqrt() if square > 0 else self.T

        def ends(s: arb) -> tuple[arb, arb]:
            """Return x and v at T under a force of 1 N that changes its sign at s and so on."""
            x, v, _ = push(self.T)
            for k in range(int(float(self.T / every)) + 1):
                if (since := self.T - s - k * every) > 0:
                    place, speed, _ = push(since)
                    x, v = x - 2 * (-1) ** k * place, v - 2 * (-1) ** k * speed
            return x, v

        low, high = arb(0), every.min(self.T)
        begins = ends(low)[1] > 0
        for _ in range(flint.ctx.prec):
            s = ((low + high) / 2).mid()
            low, high = (s, high) if (ends(s)[1] > 0) == begins else (low, s)
        peak = self.far / ends(s)[0]
        _, g, slope = push(s)
        q, r = -g, slope + self.c * g
        scale = peak / self.mass / (q * q + r * r / self.k).sqrt()
        return (q * scale).mid(), (r * scale).mid()

    def sign(self, q: arb) -> int:
        """Return that of -q."""
        return -1 if q > 0 else 1

    def rows(self, arc: Arc) -> tuple[Row, Row]:
        """Return u/M = sign P and w = -q, at the limit u/M = side limit + c v + k x and w = 0."""
        if arc.side:
            return [self.k, self.c, 0, 0, 0, arc.side], [0] * 6
        return [0, 0, 0, 0, arc.sign, 0], [0, 0, -1, 0, 0, 0]

    def cost(self, found: Motion) -> arb:
        """Return P."""
        return self.size(found.q, found.r)

    def most_velocity(self, cost: arb) -> arb:
        """Return T cost."""
        return self.T * cost

    def from_below(self, gain: arb, found: Motion) -> arb:
        """Return gain/int |w|."""
        parts = [(part.w, 0 if part.arc.side else part.arc.sign, length) for _, length, part in self.lengths(found)]
        return gain / sum((self.total(*one)[0] for one in parts), arb(0))


def least_peak(pair: Pair, far: Fraction, until: Fraction) -> tuple[list[Piece], arb, arb, bool]:
    """Return the force by pieces, its peak, the least one of all that stick, N, and whether friction is at its limit.

    In pieces at that limit the peak is exceeded in the last working digits at most. Raises NotSettled.
    """
    search = LeastPeak(pair, far, until)
    try:
        found = search.force()
        peak = search.mass * search.cost(found)
        high = peak * (1 + arb(10) ** (_ROUNDED - working_digits()))
        limited = [(length, search.mass * part.u) for _, length, part in search.lengths(found) if part.arc.side]
        for length, u in limited:  # it is below its peak, but for the rounding of its decimals
            search.require_never_negative(high - u, length)
            search.require_never_negative(high + u, length)
        _, least = search.bound(found)
    except NotSettled as error:
        end = pair.a2 * far - pair.mass * search.most
        if end <= 0:
            raise
        raise NotSettled(
            f"{error}; with any time the end needs a peak of {short(end)} N, a2 D less what friction may brake with, "
            "(1 - margin) M b/m2, and from some time on more brings nothing"
        ) from error
    return search.pieces(found), peak, search.mass * least, bool(limited)
