"""A periodic motion under a periodic force: from a guess of its events to a proved enclosure, with its multipliers.

The period map takes (x1, v1, v2) at one time to that a period later. The engine follows it in balls, from a point or
from a box of starts at once: then all of them have these events, and the product of the derivatives of legs and events,
each over all states there, encloses the derivative of the map over the box.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import NamedTuple

from flint import acb, acb_mat, arb, arb_mat

from numerics.arithmetic.ball import Ball, undecided, working_digits
from numerics.arithmetic.precision import cached_property
from numerics.control.answers import KEPT_DIGITS, Prediction, number, rounded, rounded_up
from numerics.linear.model import V1, V2, X1, X2
from numerics.linear.pieces import pieces_of
from numerics.linear.system import LinearMode, Motion
from numerics.scene import Force, Pair, Piece, Scene, Sine, State
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.run import run_scene
from numerics.trajectory.variation import Leg, legs

_log = logging.getLogger(__name__)
_STEPS = 20
"""Newton steps from a guess before it counts as none."""
STATE = X1, V1, V2
"""What a force by pieces acts on: x2 follows from these."""
State3 = tuple[arb, arb, arb]
"""x1, v1, v2."""


@dataclass(frozen=True, repr=False)
class PeriodicDrive(ShortRepr):
    """A pair under a periodic force: sines and a constant (N), t from the start of the run."""

    pair: Pair
    piece: Piece

    @cached_property
    def _scene(self) -> Scene:
        return Scene(self.pair, State(), 1, force=Force((self.piece,)))

    @property
    def frequency(self) -> Fraction:
        """Return the greatest frequency of which all are multiples, rad/s; 0 without sines."""
        return self._scene.force.frequency or Fraction(0)

    @property
    def period(self) -> arb:
        """Return T = 2 pi/frequency, s."""
        return 2 * arb.pi() / number(self.frequency)

    @property
    def is_odd(self) -> bool:
        """Return whether u - c changes its sign after half a period, c its constant part; exact."""
        return all((one.omega / self.frequency) % 2 == 1 for one in self.piece.sines)

    @property
    def rest(self) -> Fraction:
        """Return where the constant part of the force holds body 1, m."""
        return sum(self.piece.polynomial, Fraction(0)) / self.pair.a2

    def motion(self, side: int, state: Sequence[arb], t: arb) -> Motion:
        """Return the motion from (x1, v1, x2, v2) at a time (s) in the mode `side`."""
        return LinearMode(self.pair, side, pieces_of(self._scene)[0]).motion(state, t)

    def one_period(self, begin: Fraction, at: Sequence[Fraction], digits: int) -> Scene:
        """Return a period from a time (s) and (x1, v1, v2) on as a scene; it is rounded up to so many digits."""
        # a constant part of a phase beyond a turn is kept: the sine is the same function of time
        sines = [Sine(one.amplitude, one.omega, one.phase + one.omega * begin) for one in self.piece.sines]
        force, (x1, v1, v2) = Force((Piece(0, self.piece.polynomial, sines),)), at
        return replace(self._scene, initial=State(x1, v1, 0, v2), until=rounded_up(self.period, digits), force=force)


@dataclass(frozen=True, repr=False)
class Orbit(ShortRepr):
    """A periodic motion by its legs in order of time, each from an event; after the last the first begins again.

    Their x2 say nothing.
    """

    drive: PeriodicDrive
    legs: tuple[Leg, ...]

    def motion(self, leg: Leg, x2: int | arb = 0) -> Motion:
        """Return the motion of a leg from a place of body 2 (m) on."""
        x1, v1, _, v2 = leg.state
        return self.drive.motion(leg.side, (x1, v1, arb(x2), v2), leg.start)

    @cached_property
    def places(self) -> list[arb]:
        """Return x2 where each leg begins, and a period after the first, counted from that one, m."""
        found = [arb(0)]
        for leg in self.legs:
            found.append(found[-1] + self.motion(leg).at(leg.end - leg.start)[X2, 0])
        return found

    @property
    def travel(self) -> arb:
        """Return how far body 2 gets in a period, m."""
        return self.places[-1]

    def multipliers(self) -> list[acb]:
        """Return the Floquet multipliers of (x1, v1, v2), largest first. Raises EventUndecided."""
        again = (*self.legs[1:], self.legs[0]._replace(start=self.legs[-1].end))
        maps = [
            across(self.motion(leg), leg.end - leg.start, self.motion(after))
            for leg, after in zip(self.legs, again, strict=True)
        ]
        first = next((k for k, leg in enumerate(self.legs) if leg.side == 0), 0)
        total = _product([*maps[first:], *maps[:first]])
        if self.legs[first].side:
            return _eigenvalues(total)
        # where the pair sticks v2 goes with v1: w dies in a finite time
        return [*_eigenvalues(in_stick(total)), acb(0)]

    def claim(self, digits: int) -> Prediction:
        """Return that one period, from inside the first leg on, has these modes and comes back.

        Time and state of that start are rounded to decimals, so far that what grows of it in a period does not count.
        """
        kept, leg = max(digits + 12, KEPT_DIGITS), self.legs[0]
        with Ball(2 * digits + 20).context():
            begin, at = self.middle(leg)
            scene = self.drive.one_period(begin, [rounded(one, kept) for one in at], kept)
            ends, sides = dict(zip(("x1", "v1", "v2"), at, strict=True)), [one.side for one in self.legs]
            return Prediction(scene, "after a period", ends, sum(map(abs, at), arb(0)), (*sides, leg.side))

    def middle(self, leg: Leg) -> tuple[Fraction, State3]:
        """Return a time (s) in the middle of a leg, and (x1, v1, v2) there."""
        t = rounded((leg.start + leg.end) / 2)
        return t, within(self.motion(leg), number(t) - leg.start)


def within(motion: Motion, t: arb) -> State3:
    """Return (x1, v1, v2) at a time (s) since the start of a motion; v2 is v1 in a stick."""
    x1, v1, _, v2 = motion.state(t)
    return x1, v1, v2 if motion.mode.side else v1


def across(motion: Motion, length: arb, after: Motion) -> arb_mat:
    """Return the derivative of (x1, v1, v2) after the event that ends a motion by that at its start (saltation).

    Both at fixed times: a later event lets the earlier mode act longer. `after` is the motion that the event begins.
    """
    flow = motion.flow(length)
    if motion.mode.side in {0, after.mode.side}:
        return state_part(flow)  # at an exit both modes have the same accelerations
    before, behind = motion.rate(flow * motion.begin), after.rate(after.begin)
    closing = before[V1, 0] - before[V2, 0]
    jump = [(before[place, 0] - behind[place, 0]) / closing for place in STATE]
    mixed = [[int(row == column) - jump[row] * (0, 1, -1)[column] for column in range(3)] for row in range(3)]
    return arb_mat(mixed) * state_part(flow)


def state_part(flow: arb_mat) -> arb_mat:
    """Return the rows and columns of a flow that belong to (x1, v1, v2)."""
    return arb_mat([[flow[row, column] for column in STATE] for row in STATE])


def _eigenvalues(matrix: arb_mat) -> list[acb]:
    """Return the eigenvalues of a real matrix, largest first. Raises EventUndecided."""
    try:
        found = acb_mat(matrix).eig()
    except ValueError:
        raise undecided("are the multipliers apart?", "equal or close") from None
    for k, one in enumerate(found):
        both = acb(one.real, arb(0, abs(one.imag).upper()))
        # its conjugate is an eigenvalue, too: if no other ball can hold that, it is real
        if one.imag.contains(0) and not any(both.overlaps(other) for other in found if other is not one):
            found[k] = acb(one.real)
    return sorted(found, key=lambda one: (float(f"{-float(abs(one).mid()):.9g}"), -float(one.imag.mid())))


def in_stick(slopes: arb_mat) -> arb_mat:
    """Return a derivative of (x1, v1, v2) by states that stick, v2 = v1: that of (x1, v1)."""
    return arb_mat((slopes * arb_mat([[1, 0], [0, 1], [0, 1]])).tolist()[:2])


def _product(maps: Sequence[arb_mat]) -> arb_mat:
    """Return the last map after all others; in pairs, so that a radius grows by a factor a level, not one a map."""
    while len(maps) > 1:
        pairs = [after * before for before, after in zip(maps[::2], maps[1::2], strict=False)]
        maps = [*pairs, *maps[2 * len(pairs) :]]
    return maps[0]


class Box(Ball):
    """Balls to which an exact number is known within a radius: a run in them holds for a whole box of starts."""

    def __init__(self, digits: int, radius: arb) -> None:
        """Fix precision and radius, the same in m and in m/s."""
        super().__init__(digits)
        self.radius = radius

    def number(self, value: Fraction | int) -> arb:  # type: ignore[override]
        """Return a ball of that radius about an exact rational."""
        return Ball.number(value) + arb(0, self.radius)


class Round(NamedTuple):
    """A period of all motions of a box: the mode it begins in and the legs after it; its end, and that by its start.

    Legs begin at times of the drive; `in_order` says when they end.
    """

    side: int
    legs: list[Leg]
    end: State3
    slopes: arb_mat


def one_round(drive: PeriodicDrive, begin: Fraction, start: Sequence[Fraction], radius: arb, most: int) -> Round:
    """Return the period after a time (s) of all motions within a radius of a start (x1, v1, v2); v1 = v2: stuck ones.

    Raises EventUndecided unless they have the same events, at most so many, and come back to the mode they begin in.
    """
    scene = drive.one_period(begin, start, working_digits())
    run = run_scene(scene, Box(working_digits(), radius), most)
    parts = legs(run)
    left = drive.period - parts[-1].start
    if not (run.reached and len(run.modes) > 1 and parts[0].side == parts[-1].side and left > 0):
        raise undecided("does the pair come back after a period?", f"after {len(parts)} legs")
    motions = [one.motion(scene) for one in parts]
    ended = zip(parts, motions, motions[1:], strict=False)
    maps = [across(one, part.end - part.start, two) for part, one, two in ended]
    maps.append(state_part(motions[-1].flow(left)))
    found = [one._replace(start=number(begin) + one.start) for one in parts[1:]]
    return Round(parts[0].side, found, within(motions[-1], left), _product(maps))


def solve_orbit(guess: Orbit) -> Orbit:
    """Return the proved enclosure of a periodic motion near a guess. Raises EventUndecided."""
    longest = max(guess.legs, key=lambda one: float(one.end - one.start))
    return solve_from(guess.drive, *guess.middle(longest), 2 * len(guess.legs))


def solve_from(drive: PeriodicDrive, begin: Fraction, at: Sequence[arb], most: int) -> Orbit:
    """Return a periodic motion near (x1, v1, v2) at a time (s), proved; a period has at most so many events.

    By Newton's method on the period map, then an interval Newton step over a box that the engine follows as a whole:
    where it leads into the box one periodic motion begins there. Raises EventUndecided.
    """
    tiny, before = arb(10) ** -(working_digits() - 4), arb.pos_inf()
    for _ in range(_STEPS):
        start = [rounded(one, working_digits()) for one in at]
        once = one_round(drive, begin, start, arb(0), most)
        _log.info("solving a periodic motion of %d events to %d digits", len(once.legs), working_digits())
        missed = [end - number(one) for end, one in zip(once.end, start, strict=True)]
        step = _newton_step(once, missed)
        at, size = [number(one) + move for one, move in zip(start, step, strict=True)], _largest(step)
        if size <= tiny or (size >= before and size < 10 * tiny.sqrt()):
            break
        before = size
    _log.info("proving the modes between %d events", len(once.legs))
    for factor in (4, 64, 4096):
        wide = one_round(drive, begin, start, factor * size, most)
        if _largest(_newton_step(wide, missed)) < factor * size:
            return Orbit(drive, in_order(wide.legs, drive.period))
    raise undecided("is there a periodic motion with these events?", size)


def in_order(legs: Sequence[Leg], period: arb) -> tuple[Leg, ...]:
    """Return the legs of a period from the first slip + (else any leg) on that begins in [0, period)."""
    early = [one._replace(start=one.start - period * math.floor(float(one.start / period))) for one in legs]
    first = min(early, key=lambda one: (one.side != 1, float(one.start)))
    late = [one if float(one.start) >= float(first.start) else one._replace(start=one.start + period) for one in early]
    late.sort(key=lambda one: float(one.start))
    ends = *(one.start for one in late[1:]), first.start + period
    return tuple(one._replace(end=end) for one, end in zip(late, ends, strict=True))


def _newton_step(over: Round, missed: Sequence[arb]) -> list[arb]:
    """Return what leads from a start to one that comes back, if its end misses it by so much. Raises EventUndecided."""
    slopes, count = (over.slopes, 3) if over.side else (in_stick(over.slopes), 2)
    unit = arb_mat([[int(row == column) for column in range(count)] for row in range(count)])
    try:
        found = (unit - slopes).solve(arb_mat([[one] for one in missed[:count]])).entries()
    except ZeroDivisionError:
        raise undecided("is the periodic motion isolated?", "a singular matrix") from None
    return [*found, *found[count - 1 : 2]]


def _largest(step: Sequence[arb]) -> arb:
    return max(abs(one).upper() for one in step)
