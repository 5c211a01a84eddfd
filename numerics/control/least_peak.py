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
from numerics.control.thresholds import cosine_and_sine
from numerics.control.transfer import pushed
from numerics.scene import Pair, Piece


def least_peak(pair: Pair, far: Fraction, until: Fraction) -> tuple[list[Piece], arb, arb, bool]:
    """Return the force by pieces, its peak, the least one of all that stick, N, and that friction is below its limit.

    Where it is not, the bodies slip under this force, which is for the caller to see.
    """
    stuck, T = Pair(pair.mass, 1, pair.a2, 1, pair.a1), number(until)
    square = pair.a2 / pair.mass - (pair.a1 / (2 * pair.mass)) ** 2
    every = arb.pi() / number(square).sqrt() if square > 0 else T

    def turns(s: arb) -> list[arb]:
        return [s + k * every for k in range(int(float(T / every)) + 1) if s + k * every < T]

    def ends(s: arb) -> tuple[arb, arb]:
        """Return x1 and v1 at T for U = 1 N."""
        x, v, _ = pushed(stuck, T)
        for k, t in enumerate(turns(s)):
            place, speed, _ = pushed(stuck, T - t)
            x, v = x - 2 * (-1) ** k * place, v - 2 * (-1) ** k * speed
        return x, v

    low, high = arb(0), every.min(T)
    begins = ends(low)[1] > 0
    for _ in range(flint.ctx.prec):
        s = ((low + high) / 2).mid()
        low, high = (s, high) if (ends(s)[1] > 0) == begins else (low, s)
    x, v = ends(s)
    C, S = cosine_and_sine(square, T - s)
    mu = number(pair.mass) * C - number(pair.a1) * S / 2
    peak = rounded(number(far) / x)
    starts = [Fraction(0), *map(rounded, turns(s))]
    bound = mu * number(far) / (mu * x - number(pair.mass) * S * v)
    return [Piece(t, (peak * (-1) ** k,)) for k, t in enumerate(starts)], abs(number(peak)), abs(bound), False
