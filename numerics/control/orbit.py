"""A periodic motion under a periodic force: its search, its proved enclosure, its multipliers.

The period map takes (x1, v1, v2) at one time to that a period later. The engine follows it in balls, from a point or
from a box of starts at once: then all of them have these events, and the product of the derivatives of legs and events,
each over all states there, encloses the derivative of the map over the box.

The pair is followed over periods from some starts; Newton's method on the period map (`solve_from`) ends each search.
One motion is enough; response.py says when it is the only one.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import count, islice
from typing import NamedTuple

from flint import acb, acb_mat, arb, arb_mat

from numerics.arithmetic.ball import Ball, undecided, working_digits
from numerics.control.answers import number, rounded
from numerics.control.drive import PeriodicDrive, stuck_motion
from numerics.control.thresholds import NonStop, impedance, odd_ratio
from numerics.errors import EventUndecided, InvalidScene, NotSettled, OutOfRange
from numerics.linear.flow import Motion, motion_in
from numerics.linear.system import LinearMode
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.run import run_scene
from numerics.trajectory.saltation import Chain
from numerics.trajectory.trajectory import Trajectory
from numerics.trajectory.variation import Leg, legs

_log = logging.getLogger(__name__)
_STEPS = 20
"""Newton steps from a guess before it counts as none."""
State3 = Sequence[arb]
"""x1, v1, v2."""
MAX_EVENTS, _SHARE = 10_000, 5
"""Limit on events, and which part of it a period may have: its equations take longer than a run."""
_LOST = (EventUndecided, InvalidScene, OutOfRange)
"""What ends a search from one start: nothing is claimed of it."""
_BEGIN, _DIGITS = Fraction(1234567, 10**7), 20
"""At this part of a period searches begin; that many digits of a state are followed from period to period."""
Start = tuple[Fraction, State3, int]
"""A time (s), (x1, v1, v2) there, and how many periods are followed from it before Newton's method begins."""


def motion_of(leg: Leg) -> Motion:
    """Return the motion of a leg, with the time since its start."""
    return motion_in(leg.mode, leg.state, leg.start)


def state_at(leg: Leg, t: arb) -> tuple[arb, arb, arb, arb]:
    """Return (x1, v1, x2, v2) of a leg at a time, s; v2 is v1 in a stick."""
    x1, v1, x2, v2, *_ = motion_of(leg).at(t - leg.start).entries()
    return x1, v1, x2, v2 if leg.side else v1


def later(leg: Leg, time: arb | int, further: arb | int) -> Leg:
    """Return the same leg later by a time (s) after which the force is the same, and body 2 further on (m)."""
    x1, v1, x2, v2 = leg.state
    return leg._replace(start=leg.start + time, end=leg.end + time, state=(x1, v1, x2 + further, v2))


def middle(parts: Sequence[Leg]) -> tuple[Fraction, State3]:
    """Return a time (s) in the middle of the longest passage, and (x1, v1, v2) there."""
    longest = max(parts, key=lambda one: float(one.end - one.start))
    t = rounded((longest.start + longest.end) / 2)
    return t, without_x2(state_at(longest, number(t)))


def without_x2(state: Sequence[arb]) -> State3:
    """Return (x1, v1, v2) of (x1, v1, x2, v2)."""
    return state[0], state[1], state[3]


@dataclass(frozen=True, repr=False)
class Orbit(ShortRepr):
    """A periodic motion by its legs in order of time, each from an event; after the last the first begins again.

    x2 is 0 at the first event; body 2 gets on by `travel` (m) in a period. `slopes`: the derivative of (x1, v1, v2) by
    that a period before, at some time.
    """

    drive: PeriodicDrive = field(repr=False)
    legs: tuple[Leg, ...] = field(repr=False)
    travel: arb
    slopes: arb_mat = field(repr=False)

    def multipliers(self) -> list[acb]:
        """Return the Floquet multipliers of (x1, v1, v2), largest first. Raises EventUndecided."""
        found = eigenvalues(self.slopes)
        # where the pair sticks v2 goes with v1: w dies in a finite time
        return [*found[:2], acb(0)] if any(one.side == 0 for one in self.legs) else found

    def between(self, start: arb, end: arb) -> Iterator[Leg]:
        """Yield the legs that meet [start, end], in order, and perhaps one at either edge."""
        period = self.drive.period
        for turn in count(math.floor(float((start - self.legs[0].start) / period)) - 1):
            for leg in self.legs:
                there = later(leg, turn * period, turn * self.travel)
                if there.start > end:
                    return
                if there.end > start:
                    yield there

    def passage_at(self, t: arb) -> Leg:
        """Return the leg of a time t (s) that is no event. Raises EventUndecided."""
        found = list(self.between(t, t))
        if len(found) != 1 or not found[0].start <= t:
            raise undecided("in which leg is this time?", t)
        return found[0]


def follow(
    drive: PeriodicDrive, begin: Fraction, start: Sequence[Fraction], most: int, radius: arb | int = 0
) -> tuple[list[Leg], Trajectory]:
    """Return the period after a time (s) of all motions within a radius of a start (x1, v1, v2), and as it was run.

    From v1 = v2 these are stuck ones. Raises EventUndecided, NotSettled if there are more than `most` events.
    """
    scene = drive.one_period(begin, start, working_digits())
    run = run_scene(scene, Ball(working_digits(), radius), most + 1)
    if len(run.events) > most:
        raise NotSettled(
            f"a period of {float(drive.period):.4g} s has more than {most} events, a fifth of max_events; raise "
            "max_events, or use frequencies with a shorter common period"
        )
    t = number(begin)
    parts = [later(one, t, 0)._replace(mode=LinearMode.under(drive.pair, one.side, drive.piece)) for one in legs(run)]
    parts[-1] = parts[-1]._replace(end=t + drive.period)
    return parts, run


class Round(NamedTuple):
    """A period of all motions of a box: its passages, its end (x1, v1, x2, v2), and (x1, v1, v2) there by the start."""

    parts: list[Leg]
    end: tuple[arb, arb, arb, arb]
    slopes: arb_mat


def one_round(
    drive: PeriodicDrive, begin: Fraction, start: Sequence[Fraction], most: int, radius: arb | int = 0
) -> Round:
    """Return a period as `follow` does, differentiated.

    Raises EventUndecided, too, unless it has events and comes back to the mode it begins in.
    """
    parts, run = follow(drive, begin, start, most, radius)
    last = parts[-1]
    if len(parts) == 1 or parts[0].side != last.side or not last.end > last.start:
        raise undecided("does the pair come back after a period?", f"after {len(parts)} legs")
    chain = Chain(run.scene, legs(run), ("x1", "v1", "v2"))
    x1, v1, _, v2 = chain.at(len(parts) - 1, last.end - last.start).tolist()
    return Round(parts, state_at(last, last.end), arb_mat([x1, v1, v2]))


def eigenvalues(matrix: arb_mat) -> list[acb]:
    """Return the eigenvalues of a real matrix, largest first. Raises EventUndecided."""
    try:
        found = acb_mat(matrix).eig()
    except ValueError:
        raise undecided("are the eigenvalues apart?", "equal or close") from None
    for k, one in enumerate(found):
        # its conjugate is an eigenvalue, too: if no other ball can hold that, it is real
        if one.imag.contains(0) and not any(one.conjugate().overlaps(other) for other in found if other is not one):
            found[k] = acb(one.real)
    return sorted(found, key=lambda one: (float(f"{-float(abs(one).mid()):.9g}"), -float(one.imag.mid())))


def solve_orbit(drive: PeriodicDrive, guess: Orbit) -> Orbit:
    """Return the proved enclosure of a periodic motion near another one. Raises EventUndecided."""
    return solve_from(drive, *middle(guess.legs), 2 * len(guess.legs))


def solve_from(drive: PeriodicDrive, begin: Fraction, at: State3, most: int) -> Orbit:
    """Return a periodic motion near (x1, v1, v2) at a time (s), proved; a period has at most so many events.

    By Newton's method on the period map, then an interval Newton step over a box that the engine follows as a whole:
    where it leads into the box one periodic motion begins there. Raises EventUndecided, NotSettled.
    """
    tiny, before = arb(10) ** -(working_digits() - 4), arb.pos_inf()
    for _ in range(_STEPS):
        start = [rounded(one, working_digits()) for one in at]
        once = one_round(drive, begin, start, most)
        _log.info("solving a periodic motion of %d events to %d digits", len(once.parts) - 1, working_digits())
        missed = [end - number(one) for end, one in zip(without_x2(once.end), start, strict=True)]
        step = _newton_step(once, missed)
        at, size = [number(one) + move for one, move in zip(start, step, strict=True)], _largest(step)
        if once.parts[0].side == 0:
            at[2] = at[1]
        if size <= tiny or (size >= before and size < 10 * tiny.sqrt()):
            break
        before = size
    _log.info("proving the modes between %d events", len(once.parts) - 1)
    for factor in (4, 64, 4096):
        wide = one_round(drive, begin, start, most, factor * size)
        if _largest(_newton_step(wide, missed)) < factor * size:
            return _in_order(drive, wide)
    raise undecided("is there a periodic motion with these events?", size)


def _newton_step(over: Round, missed: Sequence[arb]) -> list[arb]:
    """Return what leads from a start to one that comes back, if its end misses it by so much. Raises EventUndecided.

    From a stuck start both columns of velocities count: the step keeps v1 = v2, as what is missed does.
    """
    unit = arb_mat([[int(row == column) for column in range(3)] for row in range(3)])
    try:
        return list((unit - over.slopes).solve(arb_mat([[one] for one in missed])).entries())
    except ZeroDivisionError:
        raise undecided("is the periodic motion isolated?", "a singular matrix") from None


def _largest(step: Sequence[arb]) -> arb:
    return max(abs(one).upper() for one in step)


def _in_order(drive: PeriodicDrive, over: Round) -> Orbit:
    """Return a round as an orbit, from the first slip + (else any leg) on that begins in [0, period)."""
    first, *legs, last = over.parts
    last = last._replace(end=first.end + drive.period)
    found = Orbit(drive, (*legs, last), over.end[2] - first.state[2], over.slopes)
    begun = (one for one in found.between(arb(0), drive.period) if one.start >= 0)
    first = min(begun, key=lambda one: (one.side != 1, float(one.start)))
    all_legs = islice(found.between((first.start + first.end) / 2, arb.pos_inf()), len(found.legs))
    return replace(found, legs=tuple(later(one, 0, -first.state[2]) for one in all_legs))


def search(drive: PeriodicDrive, max_events: int) -> Orbit:
    """Return a periodic motion with events, proved.

    The pair is followed period by period, each from a rounded state: bounds that grow over many would say nothing.
    Raises NotSettled where a period has more than a fifth of `max_events` events, else what ended the first search.
    """
    failures, most = list[Exception](), max_events // _SHARE
    for begin, start, periods in _starts(drive):
        at = start
        _log.info("following %d periods of %.4g s", periods, drive.period)
        try:
            for _ in range(periods):
                parts, _ = follow(drive, begin, [rounded(one, _DIGITS) for one in at], most)
                at = without_x2(state_at(parts[-1], parts[-1].end))
            if len(parts) == 1:
                raise undecided("has a period an event?", "none")
            return solve_from(drive, *middle(parts), most)
        except _LOST as error:
            failures.append(error)
    raise failures[0]


def _starts(drive: PeriodicDrive) -> Iterator[Start]:
    """Yield where searches begin: in a slip with two reversals a period, next to the stuck response, body 2 at rest."""
    if (passing := _passing(drive)) is not None:
        yield passing
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


def _passing(drive: PeriodicDrive) -> Start | None:
    """Return where a slip of sign + begins that reverses twice a period under one sine, if U >= U** (thresholds.py)."""
    pair, (sine, *others) = drive.pair, drive.piece.sines
    below = impedance(pair, pair.m1, sine.omega)
    if others or below == 0 or odd_ratio(pair, pair.m1, sine.omega) is not None:
        return None
    motion, U = NonStop(pair, sine.omega), number(sine.amplitude)
    R = ((U / motion.reach) ** 2 - motion.V**2).sqrt()
    if not motion.least <= R:
        return None
    # the sine moves body 1 at R sin(tau) - V cos(tau), tau the angle since
    turn = (acb(R, -motion.V) * below / (acb(0, 1) * motion.omega * U)).arg()
    x1 = motion.fading[0, 0] + number(drive.rest - pair.b / pair.a2) - R / motion.omega
    v = -motion.beta * motion.half / 2
    return rounded((turn - number(sine.phase)) / motion.omega, _DIGITS), (x1, v, v), 1


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
