"""The force under which body 2 follows a reference r(t), or the pieces that require more than friction can give.

Body 2 has only the friction: x2 = r needs |r''| <= b/m2, and the pair sticks while it is less. Stuck all the way,

    u = M r'' + a1 r' + a2 (r + x1(0) - r(0)),    from x2(0) = r(0) and v1(0) = v2(0) = r'(0)

r and r' must not jump, but for what rounded phases make of them.

The force of a polynomial with sines is one again; where a damper asks for a cosine, its phase pi/2 is rounded to 60
digits.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

from flint import arb

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball, proved_sign
from numerics.control.answers import number, rounded
from numerics.errors import InvalidScene
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.polynomial_root import first_crossing
from numerics.linear.sine_form import SineForm
from numerics.linear.ties import force_form
from numerics.scene import Force, Pair, Piece, Scene, Sine
from numerics.scene.decimals import require_digits, short
from numerics.scene.largest import largest_size, over
from numerics.scene.model import require_plain
from numerics.scene.short_repr import ShortRepr

_PHASE_DIGITS = 60
_FEW_BITS, _BITS = 64, 512
_ROUNDED_DIGITS = 13
"""Sines that nearly cancel, to so many digits, jump since a phase or time was rounded: 1 - cos begins with -pi/2."""
_LOST_DIGITS = 10
"""Of the working digits, so many are not asked of the largest acceleration: they are what a search may lose."""


@dataclass(frozen=True, repr=False)
class Demand(ShortRepr):
    """The friction that a piece of the reference requires between the times `start` and `end` (s), at one `b` (N).

    `number`: of the piece, from 1; `force`: max m2 |r''| there, N, an enclosure; `at`: a time (s) at which it is
    reached up to the digits requested; `possible`: whether it is at most b.
    """

    number: int
    start: Fraction
    end: Fraction
    b: Fraction
    force: arb
    at: arb
    possible: bool

    @property
    def too_much(self) -> arb:
        """Return by how much the force is more than friction gives, N, an enclosure; below 0 where it is less."""
        return self.force - number(self.b)


@dataclass(frozen=True, repr=False)
class Tracking(ShortRepr):
    """The demands of a reference, and the scene whose force makes body 2 follow it, None if a demand exceeds b.

    `share`: max m2 |r''|/b, dimensionless, an enclosure. `force_error`: upper bound on int |u - exact u| dt (N s), from
    rounded phases, and sqrt(m1) times the norm N of what they make r jump by; the error of the motion is at most
    force_error/sqrt(m1) in the norm N (sqrt J).
    `digits`: right digits of each number.

    >>> from numerics import load_reference, load_scene
    >>> found = track(load_scene("at-rest"), load_reference("too-fast"), digits=8)
    >>> found.scene, found.share.str(6, radius=False), found.is_at_limit, found.force_error
    (None, '1.15470', True, 0.0)
    >>> [(one.number, float(one.start), float(one.end), float(one.b), one.possible) for one in found.demands]
    [(1, 0.0, 1.0, 0.5, False), (2, 1.0, 4.0, 0.5, True)]
    >>> found.demands[0].force.str(6, radius=False), found.demands[0].at.str(6, radius=False)
    ('0.577350', '0.211325')
    """

    reference: tuple[Piece, ...]
    demands: tuple[Demand, ...]
    scene: Scene | None
    share: arb
    force_error: float
    digits: int

    @property
    def is_at_limit(self) -> bool:
        """Return whether the reference is not proved to stay strictly below the limit of friction."""
        return not all(one.force < number(one.b) for one in self.demands)

    @property
    def sticks(self) -> bool:
        """Return whether the bodies never slip on the way: at the limit rounded phases may let them."""
        return not (self.is_at_limit and self.force_error > 0)

    def goal(self, scene: Scene) -> tuple[arb, arb]:
        """Return where body 2 is to be at the horizon of its scene, and the size beside which an error counts, m."""
        place = over(Force(self.reference).piece_at(scene.until))(number(scene.until))
        return place, abs(place).max(arb(1))


def track(
    scene: Scene, reference: Force | Sequence[Piece], *, digits: int = 15, max_digits: int | None = None
) -> Tracking:
    """Return how body 2 of a scene follows a reference (m, a signal or its pieces) until the scene's horizon.

    The force is u = M r'' + a1 r' + a2 (r + x1(0) - r(0)), which needs m2 |r''| <= b(t); it replaces the scene's own.
    Raises InvalidScene (r or r' jumps by more than a rounded phase explains, or does not start at x2(0), v2(0)),
    EventUndecided (m2 |r''| touches b where that cannot be decided exactly), TypeError, ValueError (digits).

    >>> from numerics import load_reference, load_scene
    >>> found = track(load_scene("at-rest"), load_reference("s-curve"))
    >>> found.scene.force.starts, found.share.str(6, radius=False)
    ((Fraction(0, 1), Fraction(2, 1)), '0.288675')
    """
    require_plain("track", scene, "tracking")
    require_digits(digits, max_digits=max_digits)
    reference = reference.pieces if isinstance(reference, Force) else reference
    missed = _missed(scene, reference)
    starts, pieces = [one.start for one in reference], pieces_of(replace(scene, force=Force(reference)))
    parts = [(bisect_right(starts, one.start), one) for one in pieces]  # cut where b jumps, too

    def attempt(arithmetic: Ball) -> tuple[tuple[Demand, ...], list[arb]]:
        found = tuple(_demand(scene.pair.m2, *part, arithmetic.digits - _LOST_DIGITS) for part in parts)
        return found, [one.force if one.possible else one.too_much for one in found]

    demands = to_digits(attempt, digits, max_digits)
    share, followed, error = max((one.force / number(one.b) for one in demands), key=float), None, 0.0
    if all(one.possible for one in demands):
        apart = Force((Piece(0, (scene.initial.x1 - scene.initial.x2,)),))
        path = Force(one for one in reference if one.start < scene.until) + apart
        followed = replace(scene, force=stuck_force(scene.pair, path))
        sizes = (
            abs(scene.pair.a1 * sine.omega * sine.amplitude) * one.length for _, one in parts for sine in one.sines
        )
        error = float(number(sum(sizes, Fraction(0))).upper()) * 10.0 ** (1 - _PHASE_DIGITS) + missed
    return Tracking(tuple(reference), demands, followed, share, error, digits)


def _missed(scene: Scene, reference: Sequence[Piece]) -> float:
    """Return what jumps that come from rounded phases count as in the force, N s.

    Raises InvalidScene unless the reference is continuous with its velocity, and starts where body 2 is, but for these.
    """
    if not isinstance(reference, Sequence) or not all(isinstance(one, Piece) for one in reference):
        raise TypeError("track takes a reference, a Force or a tuple of Pieces, in m; use load_reference(...)")
    if not reference or reference[0].start != 0:
        raise InvalidScene("a reference must begin at from = 0; give its first piece there")
    Force(reference)  # in order of time
    scene.require_filippov("tracking")
    at, pair, total = scene.initial, scene.pair, arb(0)
    if at.v1 != at.v2:
        raise InvalidScene(f"v1 = {short(at.v1)} and v2 = {short(at.v2)} must be equal: body 2 follows a stuck body 1")
    for order, (name, start, weight) in enumerate((("r", at.x2, pair.a2), ("r'", at.v2, pair.mass))):
        ends = [force_form(one, after.start - one.start, order) for one, after in pairwise(reference)]
        for piece, before in zip(reference, [SineForm(start), *ends], strict=True):
            begun = force_form(piece, Fraction(0), order)
            jump = begun - before
            size, off = sum(abs(c) for part in jump.parts.values() for c in part), jump.enclosed(_BITS).abs_upper()
            total += number(weight * pair.m1).sqrt() * off
            if off > number(size) / 10**_ROUNDED_DIGITS:
                left, right = (float(side.rounded(_FEW_BITS)) for side in (before, begun))
                raise InvalidScene(
                    f"{name} jumps from {left:g} to {right:g} at t = {short(piece.start)}; no force can follow "
                    "that: make it begin with x2(0) and v2(0) of body 2, and continuous"
                )
    return float(total.upper())


def _demand(m2: Fraction, index: int, piece: ExactPiece, digits: int) -> Demand:
    bend, limit, end = acceleration(piece), piece.b / m2, piece.start + piece.length
    once = end if bend.frequency is None else min(end, piece.start + 7 / bend.frequency)  # more than a period
    peak, where = largest_size(over(bend), number(piece.start), number(once), digits)
    possible = is_within(bend, limit, piece.length)
    if possible is None:
        possible = proved_sign(number(limit) - peak, "is the acceleration within the limit of friction?") >= 0
    found = Demand(index, piece.start, end, piece.b, number(m2) * peak, where, possible)
    if not possible:
        proved_sign(found.too_much, "by how much does a piece ask too much?")
    return found


def acceleration(path: Piece | ExactPiece) -> Piece:
    """Return x'' of a path x (m), m/s^2, exact."""
    sines = [Sine(-one.amplitude * one.omega**2, one.omega, one.phase) for one in path.sines]
    return Piece(path.start, [math.perm(k, 2) * c for k, c in enumerate(path.polynomial)][2:], sines)


def stuck_force(pair: Pair, path: Force) -> Force:
    """Return u = M x'' + a1 x' + a2 x of a stuck pair on a path x (m), cosines as sines whose phase is rounded."""
    with Ball(_PHASE_DIGITS + 20).context():
        quarter = rounded(arb.pi() / 2, _PHASE_DIGITS)
    velocity = []
    for one in path.pieces:
        sines = [Sine(sine.omega * sine.amplitude, sine.omega, sine.phase + quarter) for sine in one.sines]
        velocity.append(Piece(one.start, [k * c for k, c in enumerate(one.polynomial)][1:], sines))
    return pair.a2 * path + pair.a1 * Force(velocity) + pair.mass * Force(map(acceleration, path.pieces))


def is_within(piece: Piece, limit: Fraction, length: Fraction) -> bool | None:
    """Return whether |f| <= limit over [start, start + length] as far as that is decided exactly, else None.

    For a polynomial it always is; with sines only where sum |A| + max |polynomial| <= limit.
    """
    left = limit - sum(abs(one.amplitude) for one in piece.sines)
    first, *others = piece.polynomial or [Fraction(0)]
    sides = ([left + first, *others], [left - first, *(-c for c in others)])
    is_small = left >= 0 and all(is_never_negative(one, length) for one in sides)
    return is_small or (None if piece.sines else False)


def is_never_negative(coefficients: Sequence[Fraction], length: Fraction) -> bool:
    """Return whether sum c_k t^k >= 0 for all 0 <= t <= length, double zeros included; exact.

    >>> is_never_negative([Fraction(1), Fraction(-2), Fraction(1)], Fraction(2))  # (1 - t)^2
    True
    >>> is_never_negative([Fraction(1), Fraction(-2), Fraction(999, 1000)], Fraction(2))
    False
    """
    if first_crossing([coefficients], Fraction(0), length)[0] < length:
        return False
    # it keeps its sign inside, and one of so many points is no zero
    many, value = len(coefficients) + 1, Force((Piece(0, coefficients),))
    return all(value(length * k / many) >= 0 for k in range(1, many))
