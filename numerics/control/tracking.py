"""The force under which body 2 follows a reference r(t), or which part of the reference asks too much of the interface.

Body 2 has only the friction: x2 = r needs |r''| <= b/m2, and the pair sticks while it is less. Stuck all the way,

    u = M r'' + a1 r' + a2 (r + x1(0) - r(0)),    from x2(0) = r(0) and v1(0) = v2(0) = r'(0); r, r' must not jump.

The force of a polynomial with sines is one again; where a damper asks for a cosine, its phase pi/2 is rounded to 60
digits.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.asked import to_digits
from numerics.control.rounding import rounded
from numerics.control.signals import Derivative, ends, largest_size
from numerics.errors import EventUndecided, InvalidScene
from numerics.scene import Force, Pair, Piece, Scene, Sine
from numerics.scene.decimals import short

_PHASE_DIGITS = 60


@dataclass(frozen=True)
class Demand:
    """What a piece of the reference asks of the interface between two times (s) at one b (N).

    `force`: the largest m2 |r''| there, N, an enclosure; `at`: a time (s) at which it is all but reached.
    """

    number: int
    start: Fraction
    end: Fraction
    b: Fraction
    force: arb
    at: arb
    possible: bool


@dataclass(frozen=True)
class Tracking:
    """The demands of a reference, and the scene whose force makes body 2 follow it, None if some demand is too much.

    `share`: the largest m2 |r''|/b of all, an enclosure. `force_error`: int |u - exact u| dt at most (N s), from phases
    rounded; the motion is then off by at most force_error/sqrt(m1) in the norm N (sqrt J).
    """

    reference: tuple[Piece, ...]
    demands: tuple[Demand, ...]
    scene: Scene | None
    share: arb
    force_error: float
    digits: int

    @property
    def is_at_limit(self) -> bool:
        """Return whether the reference is not proved to stay below the limit of friction."""
        return not all(one.force < Ball.number(one.b) for one in self.demands)


def track(scene: Scene, reference: tuple[Piece, ...], *, digits: int = 15, max_digits: int | None = None) -> Tracking:
    """Return how body 2 of a scene follows a reference (pieces in m) until the scene's horizon.

    The scene's own force is replaced, its friction in time counts. Raises InvalidScene (a jump of r or r', another
    start), EventUndecided (an acceleration that touches the limit where that cannot be decided exactly).
    """
    _require(scene, reference)
    demands = to_digits(lambda _: _demands(scene, reference, digits), digits, max_digits)
    share = max((one.force / Ball.number(one.b) for one in demands), key=float)
    planned, error = None, 0.0
    if all(one.possible for one in demands):
        force, error = _force(scene, reference)
        planned = Scene(scene.pair, scene.initial, scene.until, scene.law, force, scene.friction)
    return Tracking(reference, demands, planned, share, error, digits)


def _require(scene: Scene, reference: tuple[Piece, ...]) -> None:
    """Raise InvalidScene unless the reference is continuous with its velocity and starts where body 2 is."""
    if not reference or reference[0].start != 0:
        raise InvalidScene("a reference must begin at from = 0; give its first piece there")
    Force(reference)  # in order of time
    at = scene.initial
    if at.v1 != at.v2:
        raise InvalidScene(f"v1 = {short(at.v1)} and v2 = {short(at.v2)} must be equal: body 2 follows a stuck body 1")
    for order, name, body in ((0, "r", at.x2), (1, "r'", at.v2)):
        if Derivative.of(reference[0], order).at(Fraction(0)) != ({Fraction(0): body} if body else {}):
            value = float(Derivative.of(reference[0], order)(arb(0)).mid())
            raise InvalidScene(
                f"{name}(0) = {value:g} must be exactly {('x2', 'v2')[order]}(0) = {short(body)}; change either"
            )
        for number, (one, two) in enumerate(pairwise(reference), start=2):
            before, after = Derivative.of(one, order), Derivative.of(two, order)
            if before.at(two.start) != after.at(two.start):
                values = [float(side(Ball.number(two.start)).mid()) for side in (before, after)]
                raise InvalidScene(
                    f"{name} jumps from {values[0]:g} to {values[1]:g} at t = {short(two.start)}, where piece {number} "
                    "of the reference begins; no force can follow that, make it continuous"
                )


def _demands(scene: Scene, reference: tuple[Piece, ...], digits: int) -> tuple[tuple[Demand, ...], list[arb]]:
    found = []
    for number, (piece, end) in enumerate(ends(reference, scene.until), start=1):
        for start, stop, b in _at_one_friction(scene, piece.start, end):
            found.append(_demand(scene.pair, number, piece.moved(start), stop, b, digits))
    return tuple(found), [one.force for one in found]


def _at_one_friction(scene: Scene, start: Fraction, end: Fraction) -> Iterator[tuple[Fraction, Fraction, Fraction]]:
    """Yield the parts of an interval over which b is constant, with that b."""
    inner = [at for at in scene.friction.starts if start < at < end]
    for low, high in pairwise([start, *inner, end]):
        held = [b for at, b in scene.friction.pieces if at <= low]
        yield low, high, held[-1] if held else scene.pair.b


def _demand(pair: Pair, number: int, piece: Piece, end: Fraction, b: Fraction, digits: int) -> Demand:
    acceleration, limit = Derivative.of(piece, 2), b / pair.m2
    peak, where = largest_size(acceleration, piece.start, end, digits + 2)
    possible = acceleration.is_within(limit, end - piece.start)
    if possible is None:
        over = peak - Ball.number(limit)
        if over.contains(0) and not over.is_zero():
            raise EventUndecided("is the acceleration within the limit of friction?", over.str(6), working_digits())
        possible = bool(over <= 0)
    return Demand(number, piece.start, end, b, Ball.number(pair.m2) * peak, where, possible)


def _force(scene: Scene, reference: tuple[Piece, ...]) -> tuple[Force, float]:
    """Return the force of the stuck motion, and a bound on the integral of what rounded phases change in it."""
    pair = scene.pair
    with Ball(_PHASE_DIGITS + 20).context():
        quarter = rounded(arb.pi() / 2, _PHASE_DIGITS)
    pieces, error = [], 0.0
    for piece, end in ends(reference, scene.until):
        pieces.append(_force_piece(pair, piece, scene.initial.x1 - scene.initial.x2, quarter))
        size = sum(abs(float(pair.a1 * one.amplitude * one.omega)) for one in piece.sines)
        error += size * 10.0 ** (1 - _PHASE_DIGITS) * float(end - piece.start)
    return Force(pieces), error


def _force_piece(pair: Pair, piece: Piece, offset: Fraction, quarter: Fraction) -> Piece:
    p = piece.polynomial
    terms = [Fraction(0)] * max(len(p), 1)
    for order, factor in enumerate((pair.a2, pair.a1, pair.mass)):
        for k in range(order, len(p)):
            terms[k - order] += factor * p[k] * math.perm(k, order)
    terms[0] += pair.a2 * offset
    sines = []
    for one in piece.sines:
        sines.append(Sine((pair.a2 - pair.mass * one.omega**2) * one.amplitude, one.omega, one.phase))
        sines.append(Sine(pair.a1 * one.omega * one.amplitude, one.omega, one.phase + quarter))
    return Piece(piece.start, terms, sines)
