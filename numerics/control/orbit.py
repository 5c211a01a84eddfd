"""A periodic motion under a periodic force: from a guess of its events to a proved enclosure, with its multipliers.

The period map takes (x1, v1, v2) at one time to that a period later. The engine follows it in balls, from a point or
from a box of starts at once: then all of them have these events, and the product of the derivatives of legs and events,
each over all states there, encloses the derivative of the map over the box.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import count
from typing import NamedTuple

from flint import acb, acb_mat, arb, arb_mat

from numerics.arithmetic.ball import Ball, undecided, working_digits
from numerics.control.answers import KEPT_DIGITS, number, rounded, rounded_up
from numerics.errors import NotSettled
from numerics.linear.flow import Motion, motion_in
from numerics.linear.model import V1, V2, X1
from numerics.linear.system import LinearMode, LocalNorm
from numerics.scene import Force, Pair, Piece, Scene, Sine, State
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.run import run_scene
from numerics.trajectory.saltation import Chain
from numerics.trajectory.trajectory import Trajectory
from numerics.trajectory.variation import Leg, legs

_log = logging.getLogger(__name__)
_STEPS = 20
"""Newton steps from a guess before it counts as none."""
STATE = X1, V1, V2
"""What a force by pieces acts on: x2 follows from these."""
State3 = Sequence[arb]
"""x1, v1, v2."""


@dataclass(frozen=True, repr=False)
class PeriodicDrive(ShortRepr):
    """A pair under a periodic force: sines and a constant (N), t from the start of the run."""

    pair: Pair
    piece: Piece

    @property
    def frequency(self) -> Fraction:
        """Return the greatest frequency of which all are multiples, rad/s; 0 without sines."""
        return Force((self.piece,)).frequency or Fraction(0)

    @property
    def period(self) -> arb:
        """Return T = 2 pi/frequency, s."""
        return 2 * arb.pi() / number(self.frequency)

    @property
    def is_odd(self) -> bool:
        """Return whether u - c changes its sign after half a period, c its constant part; exact."""
        return all((one.omega / self.frequency) % 2 == 1 for one in self.piece.sines)

    @property
    def norm(self) -> LocalNorm:
        """Return N of differences of two motions, N^2 = a2 x1^2 + m1 v1^2 + m2 v2^2, in the arithmetic's context."""
        return LocalNorm(LinearMode.under(self.pair, 1, self.piece))

    @property
    def rest(self) -> Fraction:
        """Return where the constant part of the force holds body 1, m."""
        return sum(self.piece.polynomial, Fraction(0)) / self.pair.a2

    def one_period(self, begin: Fraction, at: Sequence[Fraction], digits: int = KEPT_DIGITS) -> Scene:
        """Return a period from a time (s) and (x1, v1, v2) on as a scene; it is rounded up to so many digits."""
        # a constant part of a phase beyond a turn is kept: the sine is the same function of time
        sines = [Sine(one.amplitude, one.omega, one.phase + one.omega * begin) for one in self.piece.sines]
        force, (x1, v1, v2) = Force((Piece(0, self.piece.polynomial, sines),)), at
        return Scene(self.pair, State(x1, v1, 0, v2), until=rounded_up(self.period, digits), force=force)


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


class Box(Ball):
    """Balls to which an exact number is known within a radius: a run in them holds for a whole box of starts."""

    def __init__(self, digits: int, radius: arb) -> None:
        """Fix precision and radius, the same in m and in m/s."""
        super().__init__(digits)
        self.radius = radius

    def number(self, value: Fraction | int) -> arb:  # type: ignore[override]
        """Return a ball of that radius about an exact rational."""
        return Ball.number(value) + arb(0, self.radius)


def follow(
    drive: PeriodicDrive, begin: Fraction, start: Sequence[Fraction], most: int, radius: arb | int = 0
) -> tuple[list[Leg], Trajectory]:
    """Return the period after a time (s) of all motions within a radius of a start (x1, v1, v2), and as it was run.

    From v1 = v2 these are stuck ones. Raises EventUndecided, NotSettled if there are more than `most` events.
    """
    scene = drive.one_period(begin, start, working_digits())
    run = run_scene(scene, Box(working_digits(), arb(radius)), most + 1)
    if len(run.events) > most:
        raise NotSettled(
            f"a period of {float(drive.period):.4g} s has more than {most} events, a fifth of max_events; raise "
            "max_events, or use frequencies with a shorter common period"
        )
    parts, t = legs(run), number(begin)
    ends = [*(one.start for one in parts[1:]), drive.period]
    found = [
        one._replace(start=t + one.start, end=t + end, mode=LinearMode.under(drive.pair, one.side, drive.piece))
        for one, end in zip(parts, ends, strict=True)
    ]
    return found, run


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
    period, (first, *legs) = drive.period, over.parts
    travel = over.end[2] - first.state[2]
    legs[-1] = legs[-1]._replace(end=first.end + period)
    turns = [math.floor(float(one.start / period)) for one in legs]
    k = min(range(len(legs)), key=lambda k: (legs[k].side != 1, float(legs[k].start - turns[k] * period)))
    place = legs[k].state[2]
    moved = [later(one, ((m < k) - turns[k]) * period, (m < k) * travel - place) for m, one in enumerate(legs)]
    return Orbit(drive, (*moved[k:], *moved[:k]), travel, over.slopes)
