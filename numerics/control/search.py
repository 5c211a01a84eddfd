"""The search for the periodic motion: one that is found is proved.

The pair is followed over periods from some starts; Newton's method on the period map (`solve_from`) ends each search.
One motion is enough; response.py says when it is the only one.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import undecided
from numerics.control.answers import number, rounded
from numerics.control.orbit import Orbit, PeriodicDrive, State3, follow, middle, solve_from, state_at, without_x2
from numerics.control.stuck import stuck_motion
from numerics.errors import EventUndecided, InvalidScene, OutOfRange

_log = logging.getLogger(__name__)
MAX_EVENTS, _SHARE = 10_000, 5
"""Limit on events, and which part of it a period may have: its equations take longer than a run."""
_LOST = (EventUndecided, InvalidScene, OutOfRange)
"""What ends a search from one start: nothing is claimed of it."""
_BEGIN, _DIGITS = Fraction(1234567, 10**7), 20
"""At this part of a period searches begin; that many digits of a state are followed from period to period."""
Start = tuple[Fraction, State3, int]
"""A time (s), (x1, v1, v2) there, and how many periods are followed from it before Newton's method begins."""


def search(drive: PeriodicDrive, max_events: int) -> Orbit:
    """Return a periodic motion with events, proved.

    Raises NotSettled where a period has more than a fifth of `max_events` events, else what ended the first search.
    """
    failures = list[Exception]()
    for begin, at, periods in _starts(drive):
        _log.info("following %d periods of %.4g s", periods, drive.period)
        try:
            return _found_from(drive, begin, at, periods, max_events // _SHARE)
        except _LOST as error:
            failures.append(error)
    raise failures[0]


def _found_from(drive: PeriodicDrive, begin: Fraction, at: State3, periods: int, most: int) -> Orbit:
    """Return the periodic motion to which a start leads.

    The pair is followed period by period, each from a rounded state: bounds that grow over many would say nothing.
    """
    for _ in range(periods):
        parts, _ = follow(drive, begin, [rounded(one, _DIGITS) for one in at], most)
        at = without_x2(state_at(parts[-1], parts[-1].end))
    if len(parts) == 1:
        raise undecided("has a period an event?", "none")
    return solve_from(drive, *middle(parts), most)


def _starts(drive: PeriodicDrive) -> Iterator[Start]:
    """Yield where searches begin: slipping, next to the stuck response, and with body 2 at rest."""
    t = rounded(drive.period * number(_BEGIN), _DIGITS)
    # it slips at once: a pair that would stay stuck elsewhere does not hide the motion
    far = number(2 * drive.pair.half_width), arb(0), arb(0)
    yield t, far, 4
    yield from _breaking(drive)
    if (creeping := _creeping(drive)) is not None:
        yield creeping
    alone = stuck_motion(drive, number(t), drive.pair.m1)
    free = far if alone is None else (alone[0], alone[1], arb(0))
    for periods in (4, 12, 48):
        yield t, free, periods
    for periods in (16, 64, 256):
        yield t, far, periods


def _breaking(drive: PeriodicDrive) -> Iterator[Start]:
    """Yield the stuck response where its load is least: that it breaks by too short slips, no other start sees."""
    times = [rounded(drive.period * k / 8) for k in range(1, 8)]
    motions = [(t, motion) for t in times if (motion := stuck_motion(drive, number(t))) is not None]
    if motions:
        t, (x, v, *_) = min(motions, key=lambda one: abs(float(one[1][2])))
        yield t, (x, v, v), 1


def _creeping(drive: PeriodicDrive) -> Start | None:
    """Return about how the bodies pass the rest position, if a weak sine near resonance makes them slip.

    The stuck pair swings as x1 = -A cos(p - phi) under U sin p, U sin phi = -(a2 - M omega^2) A. What is left of U cos
    phi beside damping friction takes, near the critical orbit by A^2 = L^2 (1 + w), w^2 = 4 pi (U cos phi - a1 omega L)
    m1/(9 b M), L the half-width. Approximate, of the sine next to resonance.
    """
    pair = drive.pair
    sine = min(drive.piece.sines, key=lambda one: abs((pair.a2 - pair.mass * one.omega**2) / one.amplitude))
    L, U, omega = pair.half_width, abs(sine.amplitude), number(sine.omega)
    across = number((pair.mass * sine.omega**2 - pair.a2) * L / U)
    along = (1 - across * across).sqrt() - number(pair.a1 * sine.omega * L / U)
    if not along > 0:  # nor if the root is none
        return None
    square = along * arb.pi() * number(4 * U * pair.m1 / (9 * pair.b * pair.mass))
    v = number(L * sine.omega if sine.amplitude > 0 else -L * sine.omega) * (1 + square.sqrt()).sqrt()
    t = rounded((arb.pi() / 2 + across.asin() - number(sine.phase)) / omega)
    return t, (number(drive.rest), v, v), 1
