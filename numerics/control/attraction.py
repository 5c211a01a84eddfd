"""How a pair converges to its periodic motion: a contraction of the period map, proved over a neighbourhood.

From a time at which a trajectory is in a leg of the orbit and within eps of it in the norm N, both are followed as one
box of states that have the same events (`one_round`). The derivative of the period map over the box bounds how much a
period shrinks distances; N never grows in between. If k periods shrink it by theta < 1, then

    int |w - w*| dt <= sqrt(kappa) k T eps/(1 - theta)    from then on, as |w - w*| <= sqrt(kappa) N.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import count
from typing import NamedTuple

from flint import arb, arb_mat

from numerics.arithmetic.ball import exact_middle, undecided, working_digits
from numerics.control.answers import number, rounded
from numerics.control.orbit import Orbit, one_round, within
from numerics.linear.system import Motion
from numerics.scene import Pair

_DOUBLINGS = 10
"""The period map is taken up to 2^n times in a row until it shrinks all distances."""


class Passage(NamedTuple):
    """One motion between two times (s): in one mode, under one piece of force and one friction."""

    begin: arb
    end: arb
    motion: Motion

    def state(self, t: arb) -> tuple[arb, arb, arb, arb]:
        """Return (x1, v1, x2, v2) at a time, s."""
        return self.motion.state(t - self.begin)


def passages(orbit: Orbit, start: arb, end: arb) -> Iterator[Passage]:
    """Yield the legs of a periodic motion that meet [start, end], in order, and perhaps one at either edge.

    x2 is 0 at the first event of the orbit.
    """
    period = orbit.drive.period
    for turn in count(math.floor(float((start - orbit.legs[0].start) / period)) - 1):
        for place, leg in zip(orbit.places, orbit.legs, strict=False):
            begin, until = leg.start + turn * period, leg.end + turn * period
            if begin > end:
                return
            if until > start:
                yield Passage(begin, until, orbit.motion(leg, place + turn * orbit.travel))


def passage_at(orbit: Orbit, t: arb) -> Passage:
    """Return the leg in which the orbit is at a time t (s) that is no event of it. Raises EventUndecided."""
    found = list(passages(orbit, t, t))
    if len(found) != 1 or not found[0].begin <= t:
        raise undecided("in which leg is this time?", t)
    return found[0]


def slide_left(orbit: Orbit, t: arb, reach: arb) -> arb:
    """Return a bound of int |w - w*| dt from a time on, for all motions in the mode of the orbit within `reach` of it.

    Raises EventUndecided.
    """
    pair, slopes = orbit.drive.pair, _period_slopes(orbit, t, reach)
    for doubling in range(_DOUBLINGS):
        shrunk = _norm(pair, slopes)
        if shrunk < arb("0.9"):
            kappa = number(pair.mass / (pair.m1 * pair.m2)).sqrt()
            return (kappa * 2**doubling * orbit.drive.period * reach / (1 - shrunk)).upper()
        slopes = slopes * slopes
    raise undecided("does the period map shrink distances?", _norm(pair, slopes))


def _norm(pair: Pair, slopes: arb_mat) -> arb:
    """Return an upper bound of the norm of a linear map of (x1, v1, v2) that belongs to N (Frobenius)."""
    roots = [number(one).sqrt() for one in (pair.a2, pair.m1, pair.m2)]
    parts = (roots[row] * slopes[row, k] / roots[k] for row in range(3) for k in range(3))
    return sum((one * one for one in parts), arb(0)).abs_upper().sqrt()


def _period_slopes(orbit: Orbit, t: arb, reach: arb) -> arb_mat:
    """Return the derivative of (x1, v1, v2) a period after t by that at t, over the box within `reach` of the orbit.

    The middle of t counts.
    """
    pair, there = orbit.drive.pair, passage_at(orbit, t.mid())
    at = within(there.motion, t.mid() - there.begin)
    start = [rounded(one, working_digits()) for one in at]
    off = max(abs(one - number(near)).upper() for one, near in zip(at, start, strict=True))
    radius = (off + reach / number(min(pair.a2, pair.m1, pair.m2)).sqrt()).upper()
    return one_round(orbit.drive, exact_middle(t), start, radius, len(orbit.legs)).slopes
