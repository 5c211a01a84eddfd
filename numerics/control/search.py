"""The search for the periodic motion: one that is found is proved.

The pair is followed over periods from some starts; Newton's method on the period map (`solve_from`) ends each search. A
pair that is followed does not see how the stuck response breaks where the force is a little above what friction holds,
by too short slips: a search begins there, too. One motion is enough; response.py says when it is the only one.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator, Sequence
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball, undecided, working_digits
from numerics.control.answers import number, rounded
from numerics.control.orbit import Orbit, PeriodicDrive, State3, solve_from, within
from numerics.control.stuck import next_to_the_stuck_response, stuck_state
from numerics.errors import EventUndecided, InvalidScene, NotSettled, OutOfRange
from numerics.trajectory.run import run_scene
from numerics.trajectory.variation import legs

_log = logging.getLogger(__name__)
MAX_EVENTS, _SHARE = 10_000, 5
"""Limit on events, and which part of it a period may have: its equations take longer than a run."""
_PERIODS, _MANY = (4, 12, 48), (16, 64, 256)
"""So many periods are followed from a start, one batch after the other; at the end of each Newton's method begins."""
_LOST = (EventUndecided, InvalidScene, OutOfRange)
"""What ends a search from one start: nothing is claimed of it."""
_PHASE, _DIGITS = Fraction(1234567, 10**7), 20
"""At this part of a period searches begin; that many digits of a state are followed from period to period."""


def search(drive: PeriodicDrive, max_events: int) -> Orbit:
    """Return a periodic motion with events, proved.

    Raises NotSettled where a period has more than a fifth of `max_events` events, else what ended the first search.
    """
    failures = list[Exception]()
    for begin, at, periods in _starts(drive):
        try:
            return _followed(drive, begin, at, periods, max_events // _SHARE)
        except _LOST as error:
            failures.append(error)
    raise failures[0]


def _starts(drive: PeriodicDrive) -> Iterator[tuple[Fraction, State3, Sequence[int]]]:
    """Yield times (s), states (x1, v1, v2) there, and how many periods are followed from them."""
    t = rounded(drive.period * number(_PHASE), _DIGITS)
    # it slips at once: a pair that would stay stuck elsewhere does not hide the motion
    far = number(2 * drive.pair.half_width), arb(0), arb(0)
    yield t, far, _PERIODS[:1]
    for begin, at in next_to_the_stuck_response(drive):
        yield begin, at, (0,)
    free = stuck_state(drive, number(t), drive.pair.m1)
    if free is not None:
        yield t, (*free[:2], arb(0)), _PERIODS
    yield t, far, _MANY


def _followed(drive: PeriodicDrive, begin: Fraction, at: State3, periods: Sequence[int], most: int) -> Orbit:
    """Return the periodic motion to which (x1, v1, v2) at a time (s) leads, proved. Raises one of _LOST, NotSettled.

    The pair is followed period by period, each from a rounded state: bounds that grow over many would say nothing. A
    whole batch of periods without an event ends the search. `most`: the most events of a period.
    """
    for count in periods:
        guess = None if count else (begin, at)
        _log.info("following %d periods of %.4g s", count, drive.period)
        for _ in range(count):
            at, found = _one_period(drive, begin, at, most)
            guess = found or guess
        if guess is None:
            raise undecided("has a period an event?", "none")
        try:
            return solve_from(drive, *guess, most)
        except _LOST as error:
            lost = error
    raise lost


def _one_period(
    drive: PeriodicDrive, begin: Fraction, at: Sequence[arb], most: int
) -> tuple[State3, tuple[Fraction, State3] | None]:
    """Return the state a period after a time (s), and time and state in the middle of the longest leg on the way.

    None for these without an event. Raises one of _LOST, NotSettled where there are more events than `most`.
    """
    scene = drive.one_period(begin, [rounded(one, _DIGITS) for one in at], _DIGITS)
    run = run_scene(scene, Ball(working_digits()), most + 1)
    if len(run.events) > most:
        raise NotSettled(
            f"a period of {float(drive.period):.4g} s has more than {most} events, a fifth of max_events; raise "
            "max_events, or use frequencies with a shorter common period"
        )
    x1, v1, _, v2 = run.final_state
    last = x1, v1, v2 if run.final_mode.sign else v1
    if len(run.modes) == 1:
        return last, None
    longest = max(legs(run), key=lambda one: float(one.end - one.start))
    t = rounded(number(begin) + (longest.start + longest.end) / 2, _DIGITS)
    return last, (t, within(longest.motion(scene), number(t - begin) - longest.start))
