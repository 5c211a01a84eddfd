"""The search for periodic motions: as many as are found, each proved, attracting or not.

The pair is followed over periods from some starts; Newton's method on the period map (`solve_from`) ends each search. A
pair that is followed does not see how the stuck response breaks where the force is a little above what friction holds,
by too short slips: a search begins there, too.

With one b one motion is enough (response.py says when it is the only one). Where B falls two motions part, in every
norm, so nothing says that there is one: a stuck motion, a slipping one and one between them that others leave may share
a force. From states between those that were found few periods lead to such a one. What is found exists; there may be
more.

Where B falls nowhere and a1 > 0 there is one, and every motion tends to it: N still shrinks, and two motions at a
constant distance have the same v1, so that F and F* differ by a constant. That is 0, else v2 - v2* would grow, or w =
w* and v2 = v2*. So x1 = x1*, w = w* + D, and F is the same on both: with D > 0, -D < w* < 0 would give F of opposite
signs, and a w* that is never there keeps F >= b, or F <= -b, for ever, while that of a periodic motion has the mean 0.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

from flint import arb

from numerics.arithmetic.ball import Ball, undecided, working_digits
from numerics.control.answers import number, rounded
from numerics.control.attraction import passage_at
from numerics.control.orbit import Orbit, PeriodicDrive, State3, in_order, solve_from, within
from numerics.control.stuck import next_to_the_stuck_response, stuck_state
from numerics.errors import EventUndecided, InvalidScene, NotSettled, OutOfRange
from numerics.trajectory.run import run_scene
from numerics.trajectory.variation import legs

_log = logging.getLogger(__name__)
MAX_EVENTS, _SHARE = 10_000, 5
"""Cap on events, and which part of it a period may have: its equations take longer than a run."""
_PERIODS, _MANY = (4, 12, 48), (16, 64, 256)
"""So many periods are followed from a start, one batch after the other; at the end of each Newton's method begins."""
_BETWEEN, _FEW = 8, (2, 2)
"""Into so many parts the way between two motions is cut; few periods lead from there to what nearly all leave again."""
_LOST = (EventUndecided, InvalidScene, OutOfRange)
"""What ends a search from one start: nothing is claimed of it."""
_PHASE, _DIGITS = Fraction(1234567, 10**7), 20
"""At this part of a period motions are compared; that many digits of a state are followed from period to period."""


def search(drive: PeriodicDrive, *, sticks: bool, max_events: int) -> tuple[list[Orbit], int]:
    """Return periodic motions with events, proved and all different, and how many starts were tried.

    One, unless there may be several that matter; `sticks`: the stuck response exists. Raises NotSettled where a period
    has more than a fifth of `max_events` events or, if there may be several, none is found and none sticks; else what
    ended the first search.
    """
    found, failures, starts = list[Orbit](), list[Exception](), 0
    is_enough = drive.weakening is None or drive.has_one_motion

    def look(begin: Fraction, at: Sequence[arb], periods: Sequence[int]) -> None:
        nonlocal starts
        if found and is_enough:
            return
        starts += 1
        try:
            one = _followed(drive, begin, at, periods, max_events // _SHARE, sticks=sticks)
        except _LOST as error:
            failures.append(error)
            return
        for new in (one, mirrored(one)) if drive.is_odd and not is_enough else (one,):
            if all(apart(new, other) for other in found):
                found.append(new)

    t = rounded(drive.period * number(_PHASE), _DIGITS)
    # it slips at once: a pair that would stay stuck elsewhere does not hide the motion
    far = number(2 * drive.pair.half_width), arb(0), arb(0)
    look(t, far, _PERIODS[:1])
    for begin, at in next_to_the_stuck_response(drive):
        look(begin, at, (0,))
    free = stuck_state(drive, number(t), drive.pair.m1)
    if free is not None:
        look(t, (*free[:2], arb(0)), _PERIODS)
        # body 2 may be carried along for ever, even by a force that favours no side
        if not is_enough:
            look(t, (*free[:2], abs(free[1]) / 2), _PERIODS)
    if not found:
        look(t, far, _MANY)
    if is_enough and not found:
        raise failures[0]
    if not is_enough:
        states = [_state(one, t) for one in found]
        stuck = stuck_state(drive, number(t)) if sticks else None
        for one, two in combinations([*states, *([stuck] if stuck else [])], 2):
            for part in range(1, _BETWEEN):
                look(t, [a + (b - a) * part / _BETWEEN for a, b in zip(one, two, strict=True)], _FEW)
    if not (found or sticks):
        raise NotSettled(
            f"no motion with the period of the force was found from {starts} starts; others may have a longer one or "
            f"none; the first search ended with: {failures[0]}"
        )
    return found, starts


def mirrored(orbit: Orbit) -> Orbit:
    """Return the motion opposite to one under a force that is odd but for a constant, half a period later."""
    late, centre = orbit.drive.period / 2, 2 * number(orbit.drive.rest)
    turned = []
    for leg in orbit.legs:
        x1, v1, x2, v2 = leg.state
        turned.append(leg._replace(side=-leg.side, start=leg.start + late, state=(centre - x1, -v1, -x2, -v2)))
    return Orbit(orbit.drive, in_order(turned, orbit.drive.period))


def apart(one: Orbit, two: Orbit) -> bool:
    """Return whether two motions are proved to differ, by their states at one time."""
    t = rounded(one.drive.period * number(_PHASE), _DIGITS)
    return any(not a.overlaps(b) for a, b in zip(_state(one, t), _state(two, t), strict=True))


def _state(orbit: Orbit, t: Fraction) -> State3:
    """Return (x1, v1, v2) of a periodic motion at a time, s. Raises EventUndecided next to an event."""
    there = passage_at(orbit, number(t))
    return within(there.motion, number(t) - there.begin)


def _followed(
    drive: PeriodicDrive,
    begin: Fraction,
    at: Sequence[arb],
    periods: Sequence[int],
    most: int,
    *,
    sticks: bool,
) -> Orbit:
    """Return the periodic motion to which (x1, v1, v2) at a time (s) leads, proved. Raises one of _LOST, NotSettled.

    The pair is followed period by period, each from a rounded state: bounds that grow over many would say nothing. A
    period without an event ends the search if the pair may stick for ever (`sticks`); else it breaks later, but a whole
    batch of them takes too long. `most`: the most events of a period.
    """
    for count in periods:
        guess = None if count else (begin, at)
        _log.info("following %d periods of %.4g s", count, drive.period)
        for _ in range(count):
            at, found = _one_period(drive, begin, at, most)
            guess = found or guess
            if found is None and sticks:
                guess = None
                break
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
