"""The last time at which a motion is on its ring, searched backwards in balls over each stretch of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import precision, working_digits
from numerics.control.legs import stretches
from numerics.control.linear import X1, X2, Motion, Row, W
from numerics.control.orbit import Orbit
from numerics.control.settled import Settled
from numerics.errors import EventUndecided

Z: Row = ((X1, Fraction(1)), (X2, Fraction(-1)))
_SEARCH_BITS = 96


def last_on_ring(trajectory: Any, known: Settled, radius: Fraction, rate: Fraction) -> arb:
    """Return the last time (s) at which the motion is on the ring before the time from which on it is inside; or 0."""
    squared, weight = Ball.number(radius**2), Ball.number(1 / rate**2)
    for stretch in reversed(list(stretches(trajectory))):
        if not stretch.start < known.since:
            continue
        for start, length, distance in reversed(list(_distances(stretch.motion, stretch.start, stretch.length, known))):
            found = _last_in(distance, length, squared, weight)
            if found is not None:
                return start + found
    return arb(0)


Apart = tuple[arb, arb, arb, arb]
"""z - z*, w - w* and their derivatives over a ball of times."""
Distance = Callable[[arb], Apart]


def _distances(motion: Motion, start: arb, length: arb, known: Settled) -> Iterator[tuple[arb, arb, Distance]]:
    """Yield the parts of a stretch in which the periodic motion has one mode: start, length, and the distance in it."""
    if known.orbit is None:
        limit = known.limit

        def distance(t: arb) -> Apart:
            here = motion.over(t)
            return here.range(Z) - limit, here.range(W), here.range(Z, 1), here.range(W, 1)

        yield start, length, distance
        return
    for begin, end, other, moved in timeline(known.orbit, start, start + length):
        first, last = later(begin, start), -later(-end, -(start + length))
        yield first, last - first, _apart(motion, first - start, other, first - begin, known.limit + moved)


def _apart(motion: Motion, passed: arb, other: Motion, ahead: arb, limit: arb) -> Distance:
    """Return the distance of two motions, each from some time after its start on; z less a limit."""

    def distance(t: arb) -> Apart:
        here, there = motion.over(passed + t), other.over(ahead + t)
        z, w, slide, change = (here.range(row, n) - there.range(row, n) for n in (0, 1) for row in (Z, W))
        return z - limit, w, slide, change

    return distance


def timeline(orbit: Orbit, start: arb, end: arb) -> Iterator[tuple[arb, arb, Motion, arb]]:
    """Yield the legs of a periodic motion that meet [start, end]: begin, end, motion, and how far x2 was before it, m.

    The last is -x2 at its begin, counted from the first event: z of the motion lacks it.
    """
    period = orbit.drive.period
    count = math.floor(float((start - orbit.legs[0].t) / period)) - 1
    while True:
        moved = count * orbit.travel
        for leg, after in orbit.turns:
            motion, begin = orbit.motion(leg), leg.t + count * period
            if begin > end:
                return
            if after.t + count * period > start:
                yield begin, after.t + count * period, motion, -moved
            moved = moved + motion.at(after.t - leg.t)[X2, 0]
        count += 1


def later(one: arb, two: arb) -> arb:
    """Return the later of two times. Raises EventUndecided."""
    if one >= two:
        return one
    if one < two:
        return two
    raise EventUndecided("which of these two events is the later one?", (one - two).str(6), working_digits())


def _last_in(apart: Distance, length: arb, squared: arb, weight: arb) -> arb | None:
    """Return the last time in a stretch at which D = (z - z*)^2 + (w - w*)^2/rate^2 - R^2 is 0; None if D < 0."""

    def over(t: arb) -> tuple[arb, arb]:
        z, w, slide, change = apart(t)
        return z * z + weight * w * w - squared, 2 * (z * slide + weight * w * change)

    waiting = [(arb(0), length.upper())]
    smallest = length.upper() * arb(2) ** (-working_digits())
    while waiting:
        low, high = waiting.pop()
        # telling inside from outside needs few digits
        with precision(min(flint.ctx.prec, _SEARCH_BITS)):
            part, rate = over(low.union(high))
            if part < 0:
                continue
            left, right = over(low)[0], over(high)[0]
        if right > 0:
            raise EventUndecided("is the motion inside the ring here?", right.str(6), working_digits())
        if rate < 0 and left > 0:
            return _crossing(over, low, high)
        if not (rate < 0 or rate > 0) or left.contains(0):
            if high - low < smallest:
                raise EventUndecided("does the motion touch the ring?", part.str(6), working_digits())
            middle = ((low + high) / 2).mid()
            waiting += [(low, middle), (middle, high)]
    return None


def _crossing(over: Callable[[arb], tuple[arb, arb]], low: arb, high: arb) -> arb:
    """Return an enclosure of the one zero of a falling function between two times, by Newton's interval step."""
    part = low.union(high)
    for _ in range(200):
        middle = part.mid()
        step = middle - over(middle)[0] / over(part)[1]
        if not step.overlaps(part):
            raise EventUndecided("where is the motion on the ring?", part.str(6), working_digits())
        smaller = step.intersection(part)
        if smaller.rad() > part.rad() * arb("0.9"):
            return smaller
        part = smaller
    return part
