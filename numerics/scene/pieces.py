"""What acts on the pair: the force u(t) on body 1 by pieces, polynomials plus sines; friction in time and by the state.

Everything is an exact rational.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise, zip_longest
from typing import Any, TypeVar

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, exact_decimal, keep, listed, positive, put, short, shown
from numerics.scene.short_repr import ShortRepr

MAX_COEFFICIENTS, MAX_SINES, MAX_PIECES = 64, 1000, 100_000
"""The first two in one piece of force; the last in one force or friction."""
MAX_POINTS = 1000
_B = TypeVar("_B")
_TWO_COEFFICIENTS = (
    "friction at rest above that in slip, without a slope between them, is ill-posed: for a load between the two stick "
    "and slip are both solutions at every instant; take B continuous, however steep"
)


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
        remedy = "turn the signs of amplitude, omega and phase, or write a constant as polynomial = [u]"
        put(self, omega=positive(omega, "omega", remedy))


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Piece(ShortRepr):
    """u(t) from `start` (s) until the next piece: sum_k polynomial[k] (t - start)^k plus the sines. Exact, N.

    Raises InvalidScene for a start < 0, more than 64 coefficients or more than 1000 sines.

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
        require_all("sines", kept, Sine, "Sine(amplitude, omega, phase)")
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
        """Return the same function of time as a piece with another start; exact."""
        if start == self.start:
            return self
        return Piece(start, shifted(self.polynomial, start - self.start), self.sines)


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Force(ShortRepr):
    """The force u(t) on body 1, N: pieces in order of their start (s); u = 0 before the first piece.

    Exact. f + g and c f are forces again. Raises InvalidScene.

    >>> (Force.step(1, 2) + Force.ramp(0, 2, 4))(Fraction(3, 2))
    Fraction(5, 1)
    >>> force = 2 * Force.sine("0.35", 5) + Force.trapezoid(2, 1, 1, 0, "0.2")
    >>> force.piece_at(Fraction(5, 2)).polynomial, force.pieces[0].sines
    ((Fraction(0, 1), Fraction(1, 5)), (Sine(amplitude=0.7, omega=5),))
    >>> force.starts, force.frequency, Force.sweep(1, [5, 6], 2).pieces[1]
    ((Fraction(0, 1), Fraction(2, 1), Fraction(3, 1), Fraction(4, 1)), None, Piece(start=2, sines=(Sine(...),)))
    """

    pieces: tuple[Piece, ...]

    def __init__(self, pieces: Iterable[Piece] = ()) -> None:
        """Keep the pieces; each starts after the one before it."""
        kept = tuple(listed("pieces", pieces))
        require_all("pieces", kept, Piece, "Piece(start, polynomial, sines)")
        require_order("force", [one.start for one in kept])
        put(self, pieces=kept)

    @classmethod
    def step(cls, at: Exact, height: Exact) -> Force:
        """Return 0 before the time `at` (s), `height` (N) from then on."""
        return cls((Piece(at, (height,)),))

    @classmethod
    def ramp(cls, start: Exact, end: Exact, height: Exact) -> Force:
        """Return the force that grows linearly from 0 at `start` to `height` (N) at `end` > start, and stays there."""
        first = exact_decimal(start, "start")
        return cls._edge(first, _length(exact_decimal(end, "end") - first, "end - start"), height)

    @classmethod
    def _edge(cls, at: Fraction, length: Fraction, height: Exact) -> Force:
        """Return the force that gets from 0 to a height within a time, at once if that is 0, and stays there."""
        top = exact_decimal(height, "height")
        rise = (Piece(at, (0, top / length)),) if length else ()
        return cls((*rise, Piece(at + length, (top,))))

    @classmethod
    def trapezoid(cls, start: Exact, rise: Exact, hold: Exact, fall: Exact, height: Exact) -> Force:
        """Return the force that rises for `rise` s, stays at `height` (N) for `hold` s and falls for `fall` s to 0.

        rise, hold, fall >= 0, not all 0; a part of length 0 is left out.
        """
        parts = {"rise": rise, "hold": hold, "fall": fall}
        lengths = {name: exact_decimal(one, name) for name, one in parts.items()}
        for name, one in lengths.items():
            if one < 0:
                raise InvalidScene(f"{name} = {short(one)} must be >= 0; give a duration in seconds")
        up, stay, down = lengths.values()
        _length(up + stay + down, "rise + hold + fall")
        at = exact_decimal(start, "start")
        return cls._edge(at, up, height) + -cls._edge(at + up + stay, down, height)

    @classmethod
    def sine(cls, amplitude: Exact, omega: Exact, phase: Exact = 0, start: Exact = 0) -> Force:
        """Return amplitude sin(omega t + phase) from `start` (s) on; t from the start of the run."""
        return cls((Piece(start, (), (Sine(amplitude, omega, phase),)),))

    @classmethod
    def sweep(cls, amplitude: Exact, omegas: Iterable[Exact], duration: Exact, start: Exact = 0) -> Force:
        """Return sines of stepped frequency, `duration` (s) each, with continuous phase; the last one does not end."""
        length = _length(duration, "duration")
        at, phase, before, pieces = exact_decimal(start, "start"), Fraction(0), Fraction(0), []
        for one in listed("omegas", omegas):
            omega = exact_decimal(one, "omega")
            phase += (before - omega) * at
            pieces.append(Piece(at, (), (Sine(amplitude, omega, phase),)))
            at, before = at + length, omega
        return cls(pieces)

    @property
    def starts(self) -> tuple[Fraction, ...]:
        """Return when the pieces begin, s."""
        return tuple(one.start for one in self.pieces)

    def piece_at(self, t: Fraction, side: int = 1) -> Piece:
        """Return the piece that acts just after (side = 1) or just before (-1) the time t (s)."""
        find = bisect_right if side > 0 else bisect_left
        index = find(self.pieces, t, key=lambda one: one.start)
        return self.pieces[index - 1] if index else Piece(0)

    def __call__(self, t: Exact, side: int = 1) -> Fraction | float:
        """Return u(t) (N): exact if the piece has no sine, else binary64. `side` = -1: the left limit at t."""
        time = exact_decimal(t, "t")
        piece = self.piece_at(time, side)
        value = Fraction(0)
        for coefficient in reversed(piece.polynomial):
            value = value * (time - piece.start) + coefficient
        if not piece.sines:
            return value
        return math.fsum(
            [float(value), *(float(s.amplitude) * math.sin(float(s.omega * time + s.phase)) for s in piece.sines)]
        )

    @property
    def frequency(self) -> Fraction | None:
        """The largest omega (rad/s) of which all frequencies are multiples, exact; the period is 2 pi/omega.

        None unless the force is one piece from 0 on, of sines and at most a constant.
        """
        if len(self.pieces) != 1 or self.pieces[0].start > 0 or len(self.pieces[0].polynomial) > 1:
            return None
        omegas = [one.omega for one in self.pieces[0].sines]
        if not omegas:
            return None
        below = math.lcm(*(one.denominator for one in omegas))
        return Fraction(math.gcd(*(int(one * below) for one in omegas)), below)

    def __add__(self, other: Force) -> Force:
        """Return the sum; it has the jumps of both."""
        if not isinstance(other, Force):
            return NotImplemented
        starts = sorted({*self.starts, *other.starts})
        return Force(_summed(*(one.piece_at(start).moved(start) for one in (self, other))) for start in starts)

    def __rmul__(self, factor: Exact) -> Force:
        """Return the force times an exact number."""
        by = exact_decimal(factor, "factor")
        return Force(
            Piece(
                one.start,
                [by * c for c in one.polynomial],
                [Sine(by * s.amplitude, s.omega, s.phase) for s in one.sines],
            )
            for one in self.pieces
        )

    def __neg__(self) -> Force:
        """Return the opposite force."""
        return -1 * self


@dataclass(frozen=True, slots=True, init=False, repr=False)
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
                why = f"a jump of B is ill-posed; give |w| > {short(w)}, however little" if w else _TWO_COEFFICIENTS
                raise InvalidScene(f"speed has a second B = {short(b)} at |w| = {short(w)}: {why}")
        for one, two in pairwise(places):
            if two[0] <= one[0]:
                raise InvalidScene(
                    f"place has z = {short(two[0])} after {short(one[0])}; give points in order, with one C at each z"
                )
        put(self, speed=speeds, place=places)
        keep(self, last_slope=last_slope)


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Friction(ShortRepr):
    """The friction force b by pieces, (start in s, b in N), in order; before the first one the pair's b. Exact.

    `weakening`: its dependence on speed and displacement; b is then the friction at rest where C = 0.

    >>> friction = Friction([(4, "0.08")])
    >>> friction.pieces, friction.starts, friction.weakening
    (((Fraction(4, 1), Fraction(2, 25)),), (Fraction(4, 1),), None)
    """

    pieces: tuple[tuple[Fraction, Fraction], ...]
    weakening: Weakening | None

    def __init__(self, pieces: Iterable[tuple[Exact, Exact]] = (), weakening: Weakening | None = None) -> None:
        """Read the pieces; raises InvalidScene unless every b > 0 and each starts after the one before it."""
        if not isinstance(weakening, Weakening | None):
            raise InvalidScene(f"weakening = {shown(weakening)} must be a Weakening; build one first")
        put(self, pieces=friction_pieces(listed("pieces", pieces), lambda b: positive(b, "b")), weakening=weakening)

    @property
    def starts(self) -> tuple[Fraction, ...]:
        """Return when the pieces begin, s."""
        return tuple(start for start, _ in self.pieces)


def _summed(one: Piece, two: Piece) -> Piece:
    """Return the sum of two pieces that begin at the same time; equal sines become one."""
    coefficients = map(sum, zip_longest(one.polynomial, two.polynomial, fillvalue=Fraction(0)))
    sines: dict[tuple[Fraction, Fraction], Fraction] = {}
    for sine in (*one.sines, *two.sines):
        key = sine.omega, sine.phase
        sines[key] = sines.get(key, Fraction(0)) + sine.amplitude
    return Piece(one.start, coefficients, [Sine(amplitude, *key) for key, amplitude in sines.items()])


def require_all(name: str, values: Iterable[Any], kind: type, how: str) -> None:
    """Raise InvalidScene, with the first that is wrong, unless all values are of a kind."""
    for k, one in enumerate(values):
        if not isinstance(one, kind):
            raise InvalidScene(f"{name}[{k}] = {shown(one)} must be a {kind.__name__}; build {how} first")


def _length(value: Exact, name: str) -> Fraction:
    return positive(value, name, "give a duration in seconds")


def two_coefficients(key: str) -> InvalidScene:
    """Return the error for a friction with one coefficient at rest and another one in slip."""
    return InvalidScene(f"{key}: {_TWO_COEFFICIENTS}, as [weakening] speed = [[|w|, B], ...]")


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
        raise InvalidScene(f"{what} has {len(starts)} pieces; at most {MAX_PIECES} are read; leave some out")
    for index, (one, two) in enumerate(pairwise(starts), start=1):
        if two <= one:
            raise InvalidScene(
                f"piece {index + 1} of {what} has from = {short(two)}, not after {short(one)}; put them in order"
            )


def friction_pieces(given: Iterable[Any], read: Callable[[Any], _B]) -> tuple[tuple[Fraction, _B], ...]:
    """Return pieces of friction in order, exact: when each begins, s, and its b as it is read."""
    kept = []
    for piece in given:
        try:
            start, b = piece
        except (TypeError, ValueError):
            raise InvalidScene(f"{shown(piece)} is no piece of friction; give a pair (start, b)") from None
        kept.append((not_before_zero("a piece of friction", start), read(b)))
    require_order("friction", [start for start, _ in kept])
    return tuple(kept)
