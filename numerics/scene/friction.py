"""Friction: its force b(t) >= 0 by pieces, and how it depends on speed and place. Everything is an exact rational."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from itertools import pairwise
from math import comb
from typing import Any, TypeVar

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, exact_decimal, keep, listed, nonnegative, put, short, shown
from numerics.scene.pieces import Piece, Signal, begun, require_order
from numerics.scene.short_repr import ShortRepr, record

MAX_POINTS = 1000
_DIGITS = 14
"""To which the least value of b(t) is looked for, at whatever precision flint has."""
_B = TypeVar("_B")
_AT_REST = "that is the b of the pair; for more friction at rest give it b_static, for less begin at |w| = 1e-6"


@record
class Weakening(ShortRepr):
    """Friction in slip, F = sgn(w) (B(|w|) + C(z)), w = v1 - v2 (m/s), z = x1 - x2 (m); at rest at most B(0) + C(z).

    B is the pair's b at w = 0, linear between the points `speed`, (|w| in m/s, B in N), and continues from the last
    one with `last_slope` (N s/m). C is linear between the points `place`, (z in m, C in N), and constant outside them.
    Where b changes in time, B and C are both scaled by b(t)/b. It is a part of the scene's friction:
    `Scene(pair, state, until, friction=Friction(weakening=falling))`. Exact. Raises InvalidScene.

    >>> falling = Weakening(speed=[("0.05", "0.3")], last_slope="0.4")
    >>> falling, falling.speed, falling.last_slope, falling.place
    (Weakening(speed=((0.05, 0.3),), last_slope=0.4), ((Fraction(1, 20), Fraction(3, 10)),), Fraction(2, 5), ())
    """

    speed: tuple[tuple[Fraction, Fraction], ...]
    last_slope: Fraction
    place: tuple[tuple[Fraction, Fraction], ...]

    def __init__(
        self,
        speed: Iterable[tuple[Exact, Exact]] = (),
        last_slope: Exact = 0,
        place: Iterable[tuple[Exact, Exact]] = (),
    ) -> None:
        """Read the points; both lists in order, B and C continuous."""
        speeds, places = _points(speed, "speed", "|w|", "B"), _points(place, "place", "z", "C")
        for (before, _), (w, b) in pairwise(((Fraction(0), Fraction(0)), *speeds)):
            if w < before:
                raise InvalidScene(f"speed has |w| = {short(w)} after {short(before)}; give points in order of |w| > 0")
            if w == before:
                why = f"a jump of B is ill-posed; give |w| > {short(w)}, however little" if w else _AT_REST
                raise InvalidScene(f"speed has a second B = {short(b)} at |w| = {short(w)}: {why}")
        for one, two in pairwise(places):
            if two[0] <= one[0]:
                raise InvalidScene(
                    f"place has z = {short(two[0])} after {short(one[0])}; give points in order, with one C at each z"
                )
        put(self, speed=speeds, place=places)
        keep(self, last_slope=last_slope)


@record
class Friction(ShortRepr):
    """The friction force b(t) >= 0 (N) by pieces, in order; before the first one the pair's b. Exact.

    A piece is a `Piece`, of a polynomial and sines, or (start in s, b in N) for a constant; or a signal has them, as
    `Friction(Force.samples(t, b))`. `weakening`: its dependence
    on speed and displacement; b is then the friction at rest where C = 0. Raises InvalidScene.

    >>> friction = Friction([(4, "0.08")])
    >>> friction, friction.steps, friction.starts, friction.is_stepwise, friction.weakening
    (Friction(pieces=(Piece(...),)), ((Fraction(4, 1), Fraction(2, 25)),), (Fraction(4, 1),), True, None)
    """

    pieces: tuple[Piece, ...]
    weakening: Weakening | None

    def __init__(
        self, pieces: Signal | Iterable[Piece | tuple[Exact, Exact]] = (), weakening: Weakening | None = None
    ) -> None:
        """Read the pieces, each of which starts after the one before it; or take those of a signal, as of samples."""
        if not isinstance(weakening, Weakening | None):
            raise InvalidScene(f"weakening = {shown(weakening)} must be a Weakening; build one first")

        def read(b: Any) -> Any:
            return b if isinstance(b, Piece) else nonnegative(b, "b")

        given = pieces.pieces if isinstance(pieces, Signal) else listed("pieces", pieces)
        found = friction_pieces(given, read)
        kept = tuple(b if isinstance(b, Piece) else Piece(start, (b,)) for start, b in found)
        put(self, pieces=kept, weakening=weakening)

    @property
    def starts(self) -> tuple[Fraction, ...]:
        """Return when the pieces begin, s."""
        return tuple(one.start for one in self.pieces)

    @property
    def is_stepwise(self) -> bool:
        """Whether every piece is one constant."""
        return all(one.constant is not None for one in self.pieces)

    @property
    def steps(self) -> tuple[tuple[Fraction, Fraction], ...]:
        """The pieces as (start in s, b in N). Raises InvalidScene unless every one is a constant."""
        found = []
        for one in self.pieces:
            if one.constant is None:
                raise InvalidScene(f"b(t) varies from t = {short(one.start)} s on; this needs b by constant steps")
            found.append((one.start, one.constant))
        return tuple(found)


def _points(given: Any, name: str, first: str, second: str) -> tuple[tuple[Fraction, Fraction], ...]:
    """Return points of a table, exact."""
    try:
        pairs = [(one, two) for one, two in given]
    except (TypeError, ValueError):
        raise InvalidScene(
            f"{name} = {shown(given)} must be points; write {name} = [[{first}, {second}], ...]"
        ) from None
    if len(pairs) > MAX_POINTS:
        raise InvalidScene(f"{name} has {len(pairs)} points; at most {MAX_POINTS} are read; leave some out")
    return tuple(
        (exact_decimal(one, f"{first} in {name}"), exact_decimal(two, f"{second} in {name}")) for one, two in pairs
    )


def friction_pieces(given: Iterable[Any], read: Callable[[Any], _B]) -> tuple[tuple[Fraction, _B], ...]:
    """Return pieces of friction in order: when each begins, s, and its b, or the whole Piece, as it is read."""
    kept, pieces = [], list(given)
    for piece in pieces:
        try:
            start, b = (piece.start, piece) if isinstance(piece, Piece) else piece
        except (TypeError, ValueError):
            raise InvalidScene(f"{shown(piece)} is no piece of friction; give a Piece or a pair (start, b)") from None
        at = begun(start)
        try:
            kept.append((at, read(b)))
        except InvalidScene as error:
            raise error if len(pieces) == 1 else InvalidScene(f"friction from {short(at)} s on: {error}") from None
    require_order("friction", [start for start, _ in kept])
    return tuple(kept)


def require_nonnegative(friction: Friction, until: Fraction) -> None:
    """Raise InvalidScene, with a time and the value there, unless b(t) >= 0 is proved up to `until` (s).

    Where the polynomial of a piece stays above the sum of the amplitudes, which b = 1 + sin t just does, that is exact.
    """
    for piece, end in zip(friction.pieces, (*friction.starts[1:], until), strict=False):
        length = min(end, until) - piece.start
        if length > 0 and least_of(piece.polynomial, length) < sum(abs(one.amplitude) for one in piece.sines):
            _prove_in_balls(piece, length)


def least_of(polynomial: tuple[Fraction, ...], length: Fraction) -> Fraction:
    """Return the least Bernstein coefficient of a polynomial on [0, length]: it is never less; exact."""
    degree = len(polynomial) - 1
    scaled = [c * length**k / comb(degree, k) for k, c in enumerate(polynomial)]
    terms = (sum(comb(i, k) * c for k, c in enumerate(scaled[: i + 1])) for i in range(degree + 1))
    return Fraction(min(terms, default=0))


def _prove_in_balls(piece: Piece, length: Fraction) -> None:
    """Prove it for some time from the start of a piece: what b falls short of a number above it is at most that."""
    from numerics.scene.largest import ball, largest_size, over  # flint, which most scenes do not need

    if piece.frequency:
        length = min(length, 7 / piece.frequency)  # more than a period
    above = sum((abs(c) * length**k for k, c in enumerate(piece.polynomial)), Fraction(0))
    begin, most = ball(piece.start), ball(above + sum(abs(one.amplitude) for one in piece.sines))
    b = over(piece)
    short_of, at = largest_size(
        lambda t, order: most * (not order) - b(t, order), begin, begin + ball(length), _DIGITS, most
    )
    if short_of <= most:
        return
    raise InvalidScene(
        f"friction from t = {short(piece.start)} s: b(t) >= 0 is not proved at t = {float(at):.6g} s, where only b >= "
        f"{float(most - short_of):.3g} N is known; raise its constant, or begin a piece where it touches 0"
    )
