"""How a pair closes in on its periodic motion for good: a contraction of the period map, proved over a neighbourhood.

From a time at which a trajectory is in a leg of the orbit and within eps of it in the norm N, both are followed as one
box of states, leg by leg: every state of the box has the same events. The derivative of the period map over the box
bounds how much a period shrinks distances; N never grows in between. If k periods shrink it by theta < 1, then

    int |w - w*| dt <= sqrt(kappa) k T eps/(1 - theta)    from then on, N(y) = sqrt(kappa) |w| at most.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from flint import arb, arb_mat

from numerics.control.answers import number, undecided
from numerics.control.orbit import QUICK, Leg, Orbit, across, guard, require_mode, state_part
from numerics.linear.system import Motion
from numerics.scene import Pair

_DOUBLINGS = 10
"""The period map is taken up to 2^n times in a row until it shrinks all distances."""


class Passage(NamedTuple):
    """A leg of a periodic motion as it passes: its number, begin and end (s), motion, and x2 where it begins (m).

    The motion counts its x2 from there; x2 is 0 at the first event of the orbit.
    """

    leg: int
    begin: arb
    end: arb
    motion: Motion
    x2: arb

    def state(self, t: arb) -> tuple[arb, arb, arb, arb]:
        """Return (x1, v1, x2, v2) at a time, s."""
        x1, v1, moved, v2 = self.motion.state(t - self.begin)
        return x1, v1, self.x2 + moved, v2


def passages(orbit: Orbit, start: arb, end: arb) -> Iterator[Passage]:
    """Yield the legs of a periodic motion that meet [start, end], in order, and perhaps one at either edge."""
    period = orbit.drive.period
    count = math.floor(float((start - orbit.legs[0].t) / period)) - 1
    while True:
        for k, (leg, after) in enumerate(orbit.turns):
            begin, until = leg.t + count * period, after.t + count * period
            if begin > end:
                return
            if until > start:
                yield Passage(k, begin, until, orbit.motion(leg), orbit.places[k] + count * orbit.travel)
        count += 1


def passage_at(orbit: Orbit, t: arb) -> Passage:
    """Return the leg in which the orbit is at a time t (s) that is no event of it. Raises EventUndecided."""
    found = list(passages(orbit, t, t))
    if len(found) != 1 or not found[0].begin <= t:
        raise undecided("in which leg is this time?", t)
    return found[0]


def distance(pair: Pair, one: Sequence[arb], two: Sequence[arb]) -> arb:
    """Return N of the difference of two states (x1, v1, x2, v2): sqrt(a2 dx1^2 + m1 dv1^2 + m2 dv2^2)."""
    parts = ((pair.a2, 0), (pair.m1, 1), (pair.m2, 3))
    return sum((number(weight) * abs(one[k] - two[k]).upper() ** 2 for weight, k in parts), arb(0)).sqrt().upper()


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
    weights = [number(one).sqrt() for one in (pair.a2, pair.m1, pair.m2)]
    places = [(row, column) for row in range(3) for column in range(3)]
    parts = [abs(weights[row] * slopes[row, column] / weights[column]).upper() for row, column in places]
    return sum((one * one for one in parts), arb(0)).sqrt()


def _period_slopes(orbit: Orbit, t: arb, reach: arb) -> arb_mat:
    """Return the derivative of (x1, v1, v2) after a period by that before, over the box within `reach` of the orbit."""
    drive, start = orbit.drive, passage_at(orbit, t)
    legs, since = [*orbit.turns[start.leg :], *orbit.turns[: start.leg]], t - start.begin
    side, here = legs[0][0].side, legs[0][0].t + since
    x1, v1, _, v2 = start.state(t)
    x, v, other = (
        one + arb(0, (reach / number(weight).sqrt()).upper())
        for one, weight in ((x1, drive.pair.a2), (v1, drive.pair.m1), (v2, drive.pair.m2))
    )
    motion, zeros = drive.mode(side).motion((x, v, arb(0), other if side else v), here), 0
    total = arb_mat([[1, 0, 0], [0, 1, 0], [0, int(side == 0), int(side != 0)]])
    for leg, after in legs:
        nominal = after.t if after.t > here else after.t + drive.period
        end = _event_time(motion, nominal - here, after)
        require_mode(motion, end, zeros, after.side, QUICK)
        x, v, *_ = motion.state(end)
        begun, zeros = drive.mode(after.side).motion((x, v, arb(0), v), here + end), 1 if leg.side else 2
        total = across(motion, end, begun) * total
        motion, here = begun, here + end
    return state_part(motion.flow(since)) * total


def _event_time(motion: Motion, near: arb, after: Leg) -> arb:
    """Return an enclosure of when each state of a box meets its next event, by an interval Newton step."""
    row, middle = guard(motion.mode, after.side), near.mid()
    miss = motion.range(row, middle)
    width = abs(miss / motion.range(row, middle, 1)).upper()
    for factor in (2, 8, 32):
        region = middle + arb(0, (factor * width).upper())
        step = middle - miss / motion.range(row, region, 1)
        if region.contains_interior(step):
            return step
    raise undecided("do all motions of the box meet this event?", miss)
