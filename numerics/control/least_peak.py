"""The stuck motion from rest to rest over D in the time T with the least max |u|, friction below its limit.

u changes its sign at the zeros of a w with M w'' = a1 w' - a2 w: at s and, if a1^2 < 4 M a2, every half period later.
For every u that arrives int w u = mu D with mu = a1 w - M w' at T, hence max |u| int |w| >= |mu| D; U sgn w attains it.
Under U sgn w, U int |w| = mu x1 + M w v1 at T: the bound does not rest on how well s is known.
"""

from __future__ import annotations

from fractions import Fraction

import flint
from flint import arb

from numerics.control.answers import number, rounded
from numerics.control.thresholds import pushed
from numerics.scene import Pair, Piece


class Switched:
    """The forces of 1 N that change their sign at s and every half period later; `bound` holds whatever s is."""

    def __init__(self, pair: Pair, until: Fraction) -> None:
        """Take the stuck pair as one body, and the time."""
        self.T, self.push = number(until), pushed(Pair(pair.mass, 1, pair.a2, 1, pair.a1))
        square = pair.a2 / pair.mass - (pair.a1 / (2 * pair.mass)) ** 2
        self.every = arb.pi() / number(square).sqrt() if square > 0 else self.T

    def turns(self, s: arb) -> list[arb]:
        """Return when the sign changes, s."""
        every = (s + k * self.every for k in range(int(float(self.T / self.every)) + 1))
        return [t for t in every if t < self.T]

    def ends(self, s: arb) -> tuple[arb, arb]:
        """Return x1 and v1 at T, m and m/s."""
        x, v, _ = self.push(self.T)
        for k, t in enumerate(self.turns(s)):
            place, speed, _ = self.push(self.T - t)
            x, v = x - 2 * (-1) ** k * place, v - 2 * (-1) ** k * speed
        return x, v

    def bound(self, far: Fraction, s: arb) -> arb:
        """Return a lower bound on max |u| of all forces that arrive, N: the w of s has |mu| D = U int |w| at least."""
        x, v = self.ends(s)
        _, g, slope = self.push(self.T - s)  # w is g backwards in time from s: w = -g, mu = M g' at T
        return abs(slope * number(far) / (slope * x - g * v))


def least_peak(pair: Pair, far: Fraction, until: Fraction) -> tuple[list[Piece], arb, arb, bool]:
    """Return the force by pieces, its peak, the least one of all that stick, N, and that friction is below its limit.

    Where it is not, the bodies slip under this force, which is for the caller to see.
    """
    switched = Switched(pair, until)
    low, high = arb(0), switched.every.min(switched.T)
    begins = switched.ends(low)[1] > 0
    for _ in range(flint.ctx.prec):
        s = ((low + high) / 2).mid()
        low, high = (s, high) if (switched.ends(s)[1] > 0) == begins else (low, s)
    peak = rounded(number(far) / switched.ends(s)[0])
    starts = [Fraction(0), *map(rounded, switched.turns(s))]
    pieces = [Piece(t, (peak * (-1) ** k,)) for k, t in enumerate(starts)]
    return pieces, abs(number(peak)), switched.bound(far, s), False
