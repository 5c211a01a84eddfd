"""A periodic motion under a periodic force: from a guess of its events to a proved enclosure, with its multipliers.

Unknown are time, position and common velocity (t, x1, v1) at each event. A slip must end at the next event with v1 = v2
= v, a stick phase with Lambda = s b. An interval Newton step in balls proves that one solution lies in the box; then
the modes are proved: s w > 0 inside each slip of sign s, |Lambda| < b inside each stick phase.

Each equation joins the unknowns of one event to those of the next. With d_k what Newton's step adds to them, miss_k +
A_k d_k + B_k d_(k+1) = 0, so that each d_(k+1) is an affine map of d_k. Products of these maps are taken as a tree: a
periodic motion contracts, so they stay small, and a radius grows by a factor a level, not a factor an event.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from flint import acb, acb_mat, arb, arb_mat

from numerics.arithmetic.ball import Ball, working_digits
from numerics.control.answers import KEPT_DIGITS, Claim, End, Tell, number, rounded, silent, undecided
from numerics.linear.system import MOST_CUTS, ONE, V1, V2, X1, X2, LinearMode, Motion, Row, W, is_positive_on, value
from numerics.scene import Force, Pair, Piece, Scene, Sine, State

_STEPS = 40
"""Newton steps from a guess before it counts as none."""
STATE = X1, V1, V2
"""What a force by pieces acts on: x2 follows from these."""


@dataclass(frozen=True)
class Drive:
    """A pair under a periodic force: sines and a constant (N), t from the start of the run."""

    pair: Pair
    piece: Piece

    @cached_property
    def frequency(self) -> Fraction:
        """Return the greatest frequency of which all are multiples, rad/s; 0 without sines."""
        return Force((Piece(0, (), self.piece.sines),)).frequency or Fraction(0)

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

    def mode(self, side: int) -> LinearMode:
        """Return the mode `side` under this force."""
        return LinearMode(self.pair, self.pair.b, side, self.piece)

    def one_period(self, begin: Fraction, state: Sequence[arb], digits: int) -> Scene:
        """Return a period from a time (s) and a state (x1, v1, x2, v2) on as a scene, in decimals of so many digits."""
        x1, v1, _, v2 = (rounded(one, digits) for one in state)
        # a constant part of a phase beyond a turn is kept: the sine is the same function of time
        sines = [Sine(one.amplitude, one.omega, one.phase + one.omega * begin) for one in self.piece.sines]
        force = Force((Piece(0, self.piece.polynomial, sines),))
        return Scene(self.pair, State(x1, v1, 0, v2), rounded(self.period, digits), force=force)


@dataclass(frozen=True)
class Leg:
    """One mode of a periodic motion: its side (0 sticks), the time of its first event (s), x1 and v1 = v2 there."""

    side: int
    t: arb
    x: arb
    v: arb


@dataclass(frozen=True)
class Orbit:
    """A periodic motion by its legs in order of time; the first begins again a period after it began."""

    drive: Drive
    legs: tuple[Leg, ...]

    @property
    def turns(self) -> list[tuple[Leg, Leg]]:
        """Return each leg with the one after it; that of the last one begins a period later than the first."""
        first = self.legs[0]
        after = (*self.legs[1:], replace(first, t=first.t + self.drive.period))
        return list(zip(self.legs, after, strict=True))

    def motion(self, leg: Leg) -> Motion:
        """Return the motion of a leg, x2 counted from its start."""
        return self.drive.mode(leg.side).motion((leg.x, leg.v, arb(0), leg.v), leg.t)

    @cached_property
    def places(self) -> list[arb]:
        """Return x2 where each leg begins, and a period after the first, counted from that one, m."""
        found = [arb(0)]
        for leg, after in self.turns:
            found.append(found[-1] + self.motion(leg).at(after.t - leg.t)[X2, 0])
        return found

    @property
    def travel(self) -> arb:
        """Return how far body 2 gets in a period, m."""
        return self.places[-1]

    @property
    def stuck_time(self) -> arb:
        """Return how long the pair sticks in a period, s."""
        return sum((after.t - leg.t for leg, after in self.turns if leg.side == 0), arb(0))

    def multipliers(self) -> list[acb]:
        """Return the Floquet multipliers of (x1, v1, v2), largest first. Raises EventUndecided."""
        turns = self.turns
        first = next((k for k, leg in enumerate(self.legs) if leg.side == 0), 0)
        order = (*turns[first:], *turns[:first])
        total = _products([across(self.motion(leg), after.t - leg.t, self.motion(after)) for leg, after in order])[-1]
        if self.legs[first].side:
            return _eigenvalues(total)
        # where the pair sticks v2 goes with v1: w dies in a finite time
        rows = (total * arb_mat([[1, 0], [0, 1], [0, 1]])).tolist()
        return [*_eigenvalues(arb_mat(rows[:2])), acb(0)]

    def claim(self, digits: int = 15) -> Claim:
        """Return that one period, from inside the first leg on, has these modes and comes back.

        Time and state of that start are rounded to decimals; by the contraction of N nothing of it grows.
        """
        kept, (leg, after) = max(digits + 3, KEPT_DIGITS), self.turns[0]
        with Ball(2 * digits + 20).context():
            begin = rounded((leg.t + after.t) / 2)
            x1, v1, x2, v2 = self.motion(leg).state(number(begin) - leg.t)
            scene = self.drive.one_period(begin, (x1, v1, x2, v2 if leg.side else v1), kept)
            near = (abs(x1) + abs(v1) + abs(v2)) * arb(10) ** (3 - digits)
            state = (("x1", 0, x1), ("v1", 1, v1), ("v2", 3, v2))
            ends = tuple(End(f"{name} after a period", place, one, near) for name, place, one in state)
        return Claim(scene, ends, (*(one.side for one in self.legs), leg.side), digits)


def across(motion: Motion, length: arb, after: Motion) -> arb_mat:
    """Return the derivative of (x1, v1, v2) after the event that ends a motion by that at its start (saltation).

    Both at fixed times: a later event lets the earlier mode act longer. `after` is the motion that the event begins.
    """
    flow = motion.flow(length)
    if motion.mode.side == 0:
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


def solve_orbit(guess: Orbit, tell: Tell = silent) -> Orbit:
    """Return the proved enclosure of the periodic motion next to a guess, its modes proved. Raises EventUndecided."""
    tell(f"solving a periodic motion of {len(guess.legs)} events to {working_digits()} digits")
    orbit = _with(guess, [one.mid() for one in _unknowns(guess)])
    tiny, before = arb(10) ** -(working_digits() - 4), arb.pos_inf()
    for _ in range(_STEPS):
        step = _newton_step(orbit, orbit)
        orbit = _with(orbit, [(old + move).mid() for old, move in zip(_unknowns(orbit), step, strict=True)])
        size = _largest(step)
        if size <= tiny or (size >= before and size < 10 * tiny.sqrt()):
            break
        before = size
        _require_order(orbit)
    found = _enclosed(orbit)
    tell(f"proving the modes between {len(guess.legs)} events")
    prove_modes(found)
    return found


def _require_order(orbit: Orbit) -> None:
    """Raise EventUndecided if some event of a guess comes before the one that it follows: Newton went astray."""
    for leg, after in orbit.turns:
        if not after.t > leg.t:
            raise undecided("are the events in this order?", (after.t - leg.t))


def _unknowns(orbit: Orbit) -> list[arb_mat]:
    return [arb_mat([[leg.t], [leg.x], [leg.v]]) for leg in orbit.legs]


def _with(orbit: Orbit, unknowns: Sequence[arb_mat]) -> Orbit:
    """Return the orbit whose unknowns are these."""
    legs = [Leg(leg.side, *some.entries()) for leg, some in zip(orbit.legs, unknowns, strict=True)]
    return Orbit(orbit.drive, tuple(legs))


def _largest(columns: Sequence[arb_mat]) -> arb:
    return max(abs(one).upper() for column in columns for one in column.entries())


def _enclosed(middle: Orbit) -> Orbit:
    """Return the orbit in a box about a point by an interval Newton step that maps the box into itself."""
    points, steps = _unknowns(middle), _newton_step(middle, middle)
    for factor in (4, 64, 4096):
        around = [arb_mat([[arb(0, factor * abs(one).upper())] for one in step.entries()]) for step in steps]
        box = [point + wide for point, wide in zip(points, around, strict=True)]
        moves = _newton_step(middle, _with(middle, box))
        images = [point + move for point, move in zip(points, moves, strict=True)]
        if all(old.contains(new) for old, new in zip(box, images, strict=True)):
            return _with(middle, images)
    raise undecided("is there a periodic motion with these events?", _largest(steps))


def _links(orbit: Orbit, box: Orbit) -> list[tuple[arb_mat, arb_mat]]:
    """Return [A | miss] and B of the equation of each leg: missed by an orbit, with its derivatives over a box."""
    rows_after = ((-1, 0), (0, -1), (0, 0))
    found = []
    for (at, target), (leg, after) in zip(orbit.turns, box.turns, strict=True):
        motion = box.motion(leg)
        flow = motion.flow(after.t - leg.t)
        rows: list[Row] = [((X1, Fraction(1)),), ((V1, Fraction(1)),), guard(motion.mode, after.side)]
        begun, ended = motion.rate(motion.begin), motion.rate(flow * motion.begin)
        for place in range(4):
            begun[place, 0] = arb(0)  # the state is an unknown of its own; the force goes on by itself
        units = [arb_mat([[int(row in places)] for row in range(motion.mode.size)]) for places in ((X1,), (V1, V2))]
        columns = (flow * begun - ended, *(flow * one for one in units))
        z, targets = orbit.motion(at).at(target.t - at.t), (target.x, target.v, arb(0))
        right = [
            [*(value(row, c) for c in columns), value(row, z) - one] for row, one in zip(rows, targets, strict=True)
        ]
        ahead = [[value(row, ended), *other] for row, other in zip(rows, rows_after, strict=True)]
        found.append((arb_mat(right), arb_mat(ahead)))
    return found


def guard(mode: LinearMode, exit_side: int) -> Row:
    """Return the row of z that is 0 where a mode ends: w, or Lambda - exit_side b."""
    return W if mode.side else (*mode.load, (ONE, -exit_side * mode.b))


def _newton_step(orbit: Orbit, box: Orbit) -> list[arb_mat]:
    """Return an enclosure of what leads from an orbit to the one in a box that misses no equation, EventUndecided."""
    unit = arb_mat([[0, 0, 0, 1]]).tolist()
    try:
        maps = [arb_mat([*ahead.solve(-right).tolist(), *unit]) for right, ahead in _links(orbit, box)]
        reached = _products(maps)
        around = reached[-1].tolist()[:3]
        left = arb_mat([[int(row == column) - around[row][column] for column in range(3)] for row in range(3)])
        first = left.solve(arb_mat([[row[3]] for row in around]))
    except ZeroDivisionError:
        raise undecided("is the periodic motion isolated?", "a singular matrix") from None
    begin = arb_mat([*first.tolist(), [1]])
    return [first, *(arb_mat((one * begin).tolist()[:3]) for one in reached[:-1])]


def _products(maps: Sequence[arb_mat]) -> list[arb_mat]:
    """Return maps[0], maps[1] maps[0], maps[2] maps[1] maps[0], ... by a tree of products."""
    if len(maps) == 1:
        return list(maps)
    pairs = _products([after * before for before, after in zip(maps[::2], maps[1::2], strict=False)])
    return [maps[0]] + [pairs[k // 2] if k % 2 else maps[k] * pairs[k // 2 - 1] for k in range(1, len(maps))]


class Effort(NamedTuple):
    """Into how many parts an interval is cut, and how often a stretch at its ends is halved, before it is given up."""

    cuts: int
    halvings: int


THOROUGH, QUICK = Effort(MOST_CUTS, 40), Effort(64, 12)
"""For a point, whose proof needs it; for a whole box of states, where a smaller box is the better way."""


def prove_modes(orbit: Orbit) -> None:
    """Raise EventUndecided unless the motion is proved to be in the mode of each leg between its events."""
    _require_order(orbit)
    for before, (leg, after) in zip((orbit.legs[-1], *orbit.legs[:-1]), orbit.turns, strict=True):
        require_mode(orbit.motion(leg), after.t - leg.t, 1 if before.side else 2, after.side)


def require_mode(motion: Motion, end: arb, zeros: int, exit_side: int, effort: Effort = THOROUGH) -> None:
    """Raise EventUndecided unless a motion is proved to be in its mode for 0 < t < end.

    A slip, s w > 0, ends with w = 0 and begins with so many zeros of w: 2 after a stick phase, 1 after a crossing, 0
    from inside. A stick phase, |Lambda| < b, ends with Lambda = exit_side b.
    """
    mode = motion.mode
    if mode.side:
        rows = [(_times(W, mode.side), zeros, 1)]
    else:
        rows = [(_times(guard(mode, side), -side), 0, int(side == exit_side)) for side in (1, -1)]
    if not all(is_positive_inside(motion, row, end, first, last, effort) for row, first, last in rows):
        raise undecided("is the pair in this mode all the time between its events?", "w or load")


def is_positive_inside(
    motion: Motion, row: Row, end: arb, zeros_at_start: int = 0, zeros_at_end: int = 0, effort: Effort = THOROUGH
) -> bool:
    """Return whether a row of z is proved positive for 0 < t < end.

    At the start it vanishes with its first `zeros_at_start` - 1 derivatives, likewise at the end: there the next
    derivative decides, over a stretch that is halved until it does.
    """

    def stretch(order: int, side: int) -> arb | None:
        """Return a length from the start (side = 1) or the end (-1) on over which the row is proved positive."""
        long = (end / 4).mid() if order else arb(0)
        for _ in range(effort.halvings if order else 0):
            part = (arb(0), long) if side > 0 else (end - long, end)
            if is_positive_on(lambda t: side**order * motion.range(row, t, order), *part, most=8):
                return long
            long /= 2
        return None if order else long

    left, right = stretch(zeros_at_start, 1), stretch(zeros_at_end, -1)
    if left is None or right is None:
        return False
    inside = left, end - right
    return bool(left >= end - right or is_positive_on(lambda t: motion.range(row, t), *inside, effort.cuts))


def _times(row: Row, factor: int) -> Row:
    return tuple((place, factor * one) for place, one in row)
