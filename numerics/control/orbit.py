"""A periodic motion under a periodic force: from a guess of its events to a proved enclosure, with its multipliers.

Unknown are time, position and common velocity (t, x1, v) at each event. A slip must end at the next event with v1 = v2
= v, a stick phase with Lambda = s b. An interval Newton step in balls proves that one solution lies in the box; then
the modes are proved: s w > 0 inside each slip of sign s, |Lambda| < b inside each stick phase.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

import flint
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.linear import V1, V2, X1, X2, LinearMode, Motion, value
from numerics.control.modes_proved import require_slip, require_stick
from numerics.control.variation import across
from numerics.errors import EventUndecided
from numerics.scene import Pair, Piece

_STEPS = 40
"""Newton steps from a guess before it counts as none."""


@dataclass(frozen=True)
class Drive:
    """A pair under a friction b and a periodic force: sines and a constant, all multiples of `frequency` (0: none)."""

    pair: Pair
    b: Fraction
    piece: Piece
    frequency: Fraction

    @property
    def period(self) -> arb:
        """Return T = 2 pi/frequency, s."""
        return 2 * arb.pi() / Ball.number(self.frequency)

    @property
    def is_odd(self) -> bool:
        """Return whether u - c changes its sign after half a period, c its constant part; exact."""
        return all((one.omega / self.frequency) % 2 == 1 for one in self.piece.sines)

    def mode(self, side: int) -> LinearMode:
        """Return the mode `side` under this force."""
        return LinearMode(self.pair, self.b, side, self.piece)


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
    def travel(self) -> arb:
        """Return how far body 2 gets in a period, m."""
        return sum((self.motion(leg).at(after.t - leg.t)[X2, 0] for leg, after in self.turns), arb(0))

    @property
    def stuck_time(self) -> arb:
        """Return how long the pair sticks in a period, s."""
        return sum((after.t - leg.t for leg, after in self.turns if leg.side == 0), arb(0))

    def multipliers(self) -> list[flint.acb]:
        """Return the Floquet multipliers of (x1, v1, v2), largest first. Raises EventUndecided."""
        turns = self.turns
        sticks = [k for k, leg in enumerate(self.legs) if leg.side == 0]
        first = sticks[0] if sticks else 0
        total = arb_mat([[1, 0], [0, 1], [0, 1]]) if sticks else arb_mat([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        for leg, after in (*turns[first:], *turns[:first]):
            total = across(self.motion(leg), after.t - leg.t, self.motion(after)) * total
        if sticks:
            (a, b), (c, d), _ = total.tolist()
            return [*_eigenvalues_of_two(a, b, c, d), flint.acb(0)]
        return _eigenvalues(total)


def solve_orbit(guess: Orbit) -> Orbit:
    """Return the proved enclosure of the periodic motion next to a guess, its modes proved. Raises EventUndecided."""
    vector = arb_mat([[one.mid()] for leg in guess.legs for one in (leg.t, leg.x, leg.v)])
    tiny = arb(10) ** -(working_digits() - 4)
    before: arb | None = None
    for _ in range(_STEPS):
        miss, slopes = _equations(guess, vector)
        step = _solved(slopes, miss)
        vector = (vector - step).mid()
        size = _largest(step)
        if size <= tiny or (before is not None and size >= before and size < 10 * tiny.sqrt()):
            break
        before = size
    found = _proved(guess, vector)
    prove_modes(found)
    return found


def _proved(guess: Orbit, middle: arb_mat) -> Orbit:
    """Return the orbit in a box about a point by an interval Newton step that maps the box into itself."""
    miss, slopes = _equations(guess, middle)
    step = _solved(slopes, miss)
    for factor in (4, 64, 4096):
        box = arb_mat([[m + arb(0, factor * abs(s).upper())] for m, s in zip(middle, step, strict=True)])
        image = middle - _solved(_equations(guess, box)[1], miss)
        if all(
            old.contains_interior(new) or old == new for old, new in zip(box.entries(), image.entries(), strict=True)
        ):
            return _with(guess, image)
    raise EventUndecided("is there a periodic motion with these events?", _largest(step).str(6), working_digits())


def prove_modes(orbit: Orbit) -> None:
    """Raise EventUndecided unless the motion is proved to be in the mode of each leg between its events."""
    earlier = (orbit.legs[-1], *orbit.legs[:-1])
    for before, (leg, after) in zip(earlier, orbit.turns, strict=True):
        length = after.t - leg.t
        if not length > 0:
            raise EventUndecided("are the events in this order?", length.str(6), working_digits())
        if leg.side:
            require_slip(orbit.motion(leg), length, from_stick=before.side == 0)
        else:
            require_stick(orbit.motion(leg), length, after.side)


def _with(guess: Orbit, vector: arb_mat) -> Orbit:
    """Return the orbit whose unknowns are these."""
    numbers = vector.entries()
    legs = [Leg(leg.side, *numbers[3 * k : 3 * k + 3]) for k, leg in enumerate(guess.legs)]
    return Orbit(guess.drive, tuple(legs))


def _equations(guess: Orbit, vector: arb_mat) -> tuple[arb_mat, arb_mat]:
    """Return what each leg misses its end by, and the derivatives of that by the unknowns."""
    orbit, size = _with(guess, vector), 3 * len(guess.legs)
    miss, slopes = arb_mat(size, 1), arb_mat(size, size)
    for k, (leg, after) in enumerate(orbit.turns):
        motion, ahead = orbit.motion(leg), 3 * ((k + 1) % len(guess.legs))
        flow = motion.flow(after.t - leg.t)
        z = flow * motion.begin
        begun = motion.rate(motion.begin)
        for place in range(4):
            begun[place, 0] = arb(0)  # the state is an unknown of its own; the force goes on by itself
        # by the time of the start, its position and velocity, and the time of the end
        columns = [flow * begun - motion.rate(z), _columns(flow, (X1,)), _columns(flow, (V1, V2)), motion.rate(z)]
        mode = orbit.drive.mode(leg.side)
        rows = [((X1, Fraction(1)),), ((V1, Fraction(1)),), ((V2, Fraction(1)),) if leg.side else mode.load]
        targets = [after.x, after.v, after.v if leg.side else after.side * Ball.number(orbit.drive.b)]
        for n, (row, target) in enumerate(zip(rows, targets, strict=True)):
            miss[3 * k + n, 0] = value(row, z) - target
            for place, column in zip((3 * k, 3 * k + 1, 3 * k + 2, ahead), columns, strict=True):
                slopes[3 * k + n, place] += value(row, column)
            if n < 2 or leg.side:
                slopes[3 * k + n, ahead + min(n + 1, 2)] -= 1
    return miss, slopes


def _columns(flow: arb_mat, places: Sequence[int]) -> arb_mat:
    """Return the sum of some columns."""
    size = flow.nrows()
    return arb_mat([[sum((flow[row, place] for place in places), arb(0))] for row in range(size)])


def _solved(slopes: arb_mat, miss: arb_mat) -> arb_mat:
    try:
        return slopes.solve(miss)
    except ZeroDivisionError:
        raise EventUndecided("is the periodic motion isolated?", "a singular matrix", working_digits()) from None


def _largest(step: arb_mat) -> arb:
    return max((abs(one).upper() for one in step.entries()), default=arb(0))


def _eigenvalues_of_two(a: arb, b: arb, c: arb, d: arb) -> list[flint.acb]:
    """Return the eigenvalues of a 2x2 matrix, the larger first."""
    half, product = (a + d) / 2, a * d - b * c
    rest = (a - d) * (a - d) / 4 + b * c
    if rest > 0:
        large = half + rest.sqrt() if half > 0 else half - rest.sqrt()
        return [flint.acb(large), flint.acb(product / large)]
    if rest < 0:
        return [flint.acb(half, (-rest).sqrt()), flint.acb(half, -(-rest).sqrt())]
    raise EventUndecided("are the multipliers real?", rest.str(6), working_digits())


def _eigenvalues(matrix: arb_mat) -> list[flint.acb]:
    try:
        found = flint.acb_mat(matrix).eig()
    except ValueError:
        raise EventUndecided("are the multipliers apart?", "equal or close", working_digits()) from None
    return sorted(found, key=lambda one: -float(abs(one).mid()))
