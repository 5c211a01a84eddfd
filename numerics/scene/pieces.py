"""The parts of what acts on the pair in time: sines, pieces of force, and pieces of friction. Exact rationals."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, exact_decimal, keep, listed, positive, put, short
from numerics.scene.short_repr import ShortRepr
from numerics.scene.weakening import Weakening

MAX_COEFFICIENTS, MAX_SINES, MAX_PIECES = 64, 1000, 100_000
"""The first two in one piece of force; the last in one force or friction."""


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Sine(ShortRepr):
    """amplitude sin(omega t + phase): N, rad/s > 0, rad; t (s) is counted from the start of the run. Exact.

    >>> sine = Sine("0.35", 5)
    >>> sine, sine.amplitude, sine.omega, sine.phase
    (Sine(amplitude=0.35, omega=5), Fraction(7, 20), Fraction(5, 1), Fraction(0, 1))
    """

    amplitude: Fraction
    omega: Fraction
    phase: Fraction

    def __init__(self, amplitude: Exact, omega: Exact, phase: Exact = 0) -> None:
        """Read the numbers; raises InvalidScene unless omega > 0."""
        keep(self, amplitude=amplitude, phase=phase)
        put(self, omega=positive(omega, "omega", "write a constant as polynomial = [u]"))


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Piece(ShortRepr):
    """u(t) from `start` (s) until the next piece: sum_k polynomial[k] (t - start)^k plus the sines. Exact, N.

    Raises InvalidScene for a start < 0 and for more terms than a piece may have.

    >>> piece = Piece(2, (0, "1/2"), (Sine("0.35", 5),))  # from 2 s on: (t - 2)/2 N and a sine
    >>> piece, piece.start, piece.polynomial[1], len(piece.sines)
    (Piece(start=2, polynomial=(0, 0.5), sines=(Sine(amplitude=0.35, omega=5),)), Fraction(2, 1), Fraction(1, 2), 1)
    >>> piece.moved(Fraction(4)).polynomial
    (Fraction(1, 1), Fraction(1, 2))
    """

    start: Fraction
    polynomial: tuple[Fraction, ...]
    sines: tuple[Sine, ...]

    def __init__(self, start: Exact, polynomial: Iterable[Exact] = (), sines: Iterable[Sine] = ()) -> None:
        """Read start and coefficients (N, N/s, N/s^2, ...)."""
        keep(self, start=start)
        not_before_zero("a piece of force", self.start)
        coefficients = [
            exact_decimal(one, f"polynomial[{k}]") for k, one in enumerate(listed("polynomial", polynomial))
        ]
        kept = tuple(listed("sines", sines))
        if not all(isinstance(one, Sine) for one in kept):
            raise InvalidScene("sines must be Sine(amplitude, omega, phase); build them first")
        for name, count, most in (
            ("coefficients", len(coefficients), MAX_COEFFICIENTS),
            ("sines", len(kept), MAX_SINES),
        ):
            if count > most:
                raise InvalidScene(f"a piece of force has {count} {name}; at most {most} are read; use more pieces")
        while coefficients and coefficients[-1] == 0:
            coefficients.pop()
        put(self, polynomial=tuple(coefficients), sines=tuple(one for one in kept if one.amplitude != 0))

    def moved(self, start: Fraction) -> Piece:
        """Return the same function of time as a piece that begins at another time; exact."""
        if start == self.start:
            return self
        return Piece(start, shifted(self.polynomial, start - self.start), self.sines)


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Friction(ShortRepr):
    """The friction force b by pieces, (start in s, b in N), in order; before the first one the pair's b. Exact.

    `weakening` says how friction depends on speed and place besides; b is then what it is at rest, for C = 0.

    >>> friction = Friction([(4, "0.08")])
    >>> friction.pieces, friction.starts, friction.weakening
    (((Fraction(4, 1), Fraction(2, 25)),), (Fraction(4, 1),), None)
    """

    pieces: tuple[tuple[Fraction, Fraction], ...]
    weakening: Weakening | None

    def __init__(self, pieces: Iterable[tuple[Exact, Exact]] = (), weakening: Weakening | None = None) -> None:
        """Read the pieces; raises InvalidScene unless every b > 0 and each starts after the one before it."""
        if not isinstance(weakening, Weakening | None):
            raise InvalidScene("weakening must be a Weakening(speed, last_slope, place); build it first")
        kept = []
        for one in listed("pieces", pieces):
            start, b = two_of(one)
            kept.append((not_before_zero("a piece of friction", start), positive(b, "b")))
        require_order("friction", [start for start, _ in kept])
        put(self, pieces=tuple(kept), weakening=weakening)

    @property
    def starts(self) -> tuple[Fraction, ...]:
        """Return when the pieces begin, s."""
        return tuple(start for start, _ in self.pieces)


def shifted(polynomial: tuple[Fraction, ...], by: Fraction) -> tuple[Fraction, ...]:
    """Return the coefficients of p(x + by), exact (Horner's scheme, repeated)."""
    found = list(polynomial)
    for first in range(len(found) - 1):
        for k in range(len(found) - 2, first - 1, -1):
            found[k] += by * found[k + 1]
    return tuple(found)


def not_before_zero(what: str, start: Exact) -> Fraction:
    """Return when a piece begins, s, exact and not before the run."""
    found = exact_decimal(start, "from")
    if found < 0:
        raise InvalidScene(f"from = {short(found)} of {what} must be >= 0; a run starts at t = 0")
    return found


def require_order(what: str, starts: list[Fraction]) -> None:
    """Raise InvalidScene unless every piece starts after the one before it."""
    if len(starts) > MAX_PIECES:
        raise InvalidScene(f"{what} has {len(starts)} pieces; at most {MAX_PIECES} are read")
    for index, (one, two) in enumerate(pairwise(starts), start=1):
        if two <= one:
            raise InvalidScene(
                f"piece {index + 1} of {what} has from = {short(two)}, not after {short(one)}; put them in order"
            )


def two_of(piece: Any) -> tuple[Any, Any]:
    """Return start and b of a piece of friction."""
    try:
        start, b = piece
    except (TypeError, ValueError):
        raise InvalidScene("a piece of friction is a pair (start, b); give two numbers") from None
    return start, b
