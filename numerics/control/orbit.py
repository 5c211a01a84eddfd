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
from numerics.control.asked import Tell, silent
from numerics.control.cyclic import SIZE, Link, newton_step, prefixes
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
        order = (*turns[first:], *turns[:first])
        total = prefixes([across(self.motion(leg), after.t - leg.t, self.motion(after)) for leg, after in order])[-1]
        if sticks:
            (a, b), (c, d), _ = (total * arb_mat([[1, 0], [0, 1], [0, 1]])).tolist()
            return [*_eigenvalues_of_two(a, b, c, d), flint.acb(0)]
        return _eigenvalues(total)


def solve_orbit(guess: Orbit, tell: Tell = silent) -> Orbit:
    """Return the proved enclosure of the periodic motion next to a guess, its modes proved. Raises EventUndecided."""
    tell(f"solving a periodic motion of {len(guess.legs)} events to {working_digits()} digits")
    orbit = _moved(guess, None)
    tiny = arb(10) ** -(working_digits() - 4)
    before: arb | None = None
    for _ in range(_STEPS):
        step = newton_step(_links(orbit))
        orbit = _moved(orbit, step)
        size = max(abs(one).upper() for entry in step for one in entry.entries())
        if size <= tiny or (before is not None and size >= before and size < 10 * tiny.sqrt()):
            break
        before = size
        _require_order(orbit)
    found = _proved(orbit)
    tell(f"proving the modes between {len(guess.legs)} events")
    prove_modes(found)
    return found


def _require_order(orbit: Orbit) -> None:
    """Raise EventUndecided if some event of a guess comes before the one that it follows: Newton went astray."""
    for leg, after in orbit.turns:
        if after.t < leg.t:
            raise EventUndecided("are the events in this order?", (after.t - leg.t).str(6), working_digits())


def _moved(orbit: Orbit, steps: Sequence[arb_mat] | None) -> Orbit:
    """Return the orbit of exact numbers next to one, after a step if there is one."""
    moves = [arb_mat(SIZE, 1)] * len(orbit.legs) if steps is None else steps
    return _with(
        orbit,
        [
            arb_mat([[one.mid()] for one in (old + move).entries()])
            for old, move in zip(_unknowns(orbit), moves, strict=True)
        ],
    )


def _unknowns(orbit: Orbit) -> list[arb_mat]:
    return [arb_mat([[leg.t], [leg.x], [leg.v]]) for leg in orbit.legs]


def _with(orbit: Orbit, unknowns: Sequence[arb_mat]) -> Orbit:
    """Return the orbit whose unknowns are these."""
    legs = [Leg(leg.side, *some.entries()) for leg, some in zip(orbit.legs, unknowns, strict=True)]
    return replace(orbit, legs=tuple(legs))


def _proved(middle: Orbit) -> Orbit:
    """Return the orbit in a box about a point by an interval Newton step that maps the box into itself."""
    links, points = _links(middle), _unknowns(middle)
    steps = newton_step(links)
    for factor in (4, 64, 4096):
        box = [point + _about_zero(step, factor) for point, step in zip(points, steps, strict=True)]
        slopes = _links(_with(middle, box))
        moves = newton_step([wide._replace(miss=one.miss) for one, wide in zip(links, slopes, strict=True)])
        images = [point + move for point, move in zip(points, moves, strict=True)]
        if all(_is_inside(image, old) for image, old in zip(images, box, strict=True)):
            return _with(middle, images)
    size = max(abs(one).upper() for step in steps for one in step.entries())
    raise EventUndecided("is there a periodic motion with these events?", size.str(6), working_digits())


def _about_zero(step: arb_mat, factor: int) -> arb_mat:
    """Return a box about 0 that is `factor` times as wide as a step."""
    return arb_mat([[arb(0, factor * abs(one).upper())] for one in step.entries()])


def _is_inside(image: arb_mat, box: arb_mat) -> bool:
    pairs = zip(image.entries(), box.entries(), strict=True)
    return all(old.contains_interior(new) or bool(old == new) for new, old in pairs)


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


def _links(orbit: Orbit) -> list[Link]:
    """Return what each leg misses its end by, and the derivatives of that by the unknowns of both its events."""
    found = []
    for leg, after in orbit.turns:
        motion, is_slip = orbit.motion(leg), leg.side != 0
        flow = motion.flow(after.t - leg.t)
        z = flow * motion.begin
        begun, ended = motion.rate(motion.begin), motion.rate(z)
        for place in range(4):
            begun[place, 0] = arb(0)  # the state is an unknown of its own; the force goes on by itself
        by_time, by_place, by_speed = flow * begun - ended, _columns(flow, (X1,)), _columns(flow, (V1, V2))
        mode = orbit.drive.mode(leg.side)
        rows = [((X1, Fraction(1)),), ((V1, Fraction(1)),), ((V2, Fraction(1)),) if is_slip else mode.load]
        targets = [after.x, after.v, after.v if is_slip else after.side * Ball.number(orbit.drive.b)]
        met = (0, -1, 0), (0, 0, -1), (0, 0, -int(is_slip))
        miss = arb_mat([[value(row, z) - target] for row, target in zip(rows, targets, strict=True)])
        here = arb_mat([[value(row, one) for one in (by_time, by_place, by_speed)] for row in rows])
        ahead = arb_mat([[value(row, ended) + t, x, v] for row, (t, x, v) in zip(rows, met, strict=True)])
        found.append(Link(miss, here, ahead))
    return found


def _columns(flow: arb_mat, places: Sequence[int]) -> arb_mat:
    """Return the sum of some columns."""
    size = flow.nrows()
    return arb_mat([[sum((flow[row, place] for place in places), arb(0))] for row in range(size)])


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
