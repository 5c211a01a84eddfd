"""Signals: functions of time by pieces, polynomials plus sines. Everything is an exact rational."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise, zip_longest
from typing import Any

from numerics.errors import InvalidScene
from numerics.scene.decimals import (
    Exact,
    exact_decimal,
    keep,
    listed,
    nonnegative,
    positive,
    put,
    require_one_of,
    short,
    shown,
)
from numerics.scene.short_repr import ShortRepr, record

_DURATION, _RUN = "give a duration in seconds", "a run starts at t = 0"
MAKERS = "Force.constant(3), Force.samples(t, u) and Force.sine(amplitude, omega) make a force"
MAX_COEFFICIENTS, MAX_SINES, MAX_PIECES = 64, 1000, 100_000
"""The first two in one piece; the last in one signal."""


@record
class Sine(ShortRepr):
    """amplitude sin(omega t + phase), rad/s > 0, rad; t (s) is counted from the start of the run. Exact.

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


@record
class Piece(ShortRepr):
    """A signal from `start` (s) until the next piece: sum_k polynomial[k] (t - start)^k plus the sines. Exact.

    Raises InvalidScene for a start < 0, more than 64 coefficients or more than 1000 sines.

    >>> piece = Piece(2, (0, "1/2"), (Sine("0.35", 5),))  # from 2 s on: (t - 2)/2 N and a sine
    >>> piece, piece.start, piece.polynomial[1], len(piece.sines)
    (Piece(start=2, polynomial=(0, 0.5), sines=(Sine(amplitude=0.35, omega=5),)), Fraction(2, 1), Fraction(1, 2), 1)
    >>> piece.moved(Fraction(4)).polynomial
    (Fraction(1, 1), Fraction(1, 2))
    >>> Piece(0, (3,)).constant, piece.constant, piece.frequency, Piece(0, (1,), (Sine(1, 4), Sine(1, 6))).frequency
    (Fraction(3, 1), None, None, Fraction(2, 1))
    """

    start: Fraction
    polynomial: tuple[Fraction, ...]
    sines: tuple[Sine, ...]

    def __init__(self, start: Exact, polynomial: Iterable[Exact] = (), sines: Iterable[Sine] = ()) -> None:
        """Read start and coefficients: those of a force are N, N/s, N/s^2, ..."""
        put(self, start=begun(start))
        coefficients = [
            exact_decimal(one, f"polynomial[{k}] of the piece from {self.start} s")
            for k, one in enumerate(listed("polynomial", polynomial))
        ]
        kept = tuple(listed("sines", sines))
        require_all("sines", kept, Sine, "Sine(amplitude, omega, phase)")
        for name, count, most in (
            ("coefficients", len(coefficients), MAX_COEFFICIENTS),
            ("sines", len(kept), MAX_SINES),
        ):
            if count > most:
                raise InvalidScene(f"a piece has {count} {name}; at most {most} are read; use more pieces")
        while coefficients and coefficients[-1] == 0:
            coefficients.pop()
        put(self, polynomial=tuple(coefficients), sines=tuple(one for one in kept if one.amplitude != 0))

    @property
    def constant(self) -> Fraction | None:
        """The value of a piece that is one constant, else None."""
        return None if self.sines or self.polynomial[1:] else sum(self.polynomial, Fraction(0))

    @property
    def frequency(self) -> Fraction | None:
        """The largest omega (rad/s) of which all frequencies are multiples, exact; the period is 2 pi/omega.

        None unless the piece is sines and at most a constant.
        """
        if not self.sines or self.polynomial[1:]:
            return None
        below = math.lcm(*(one.omega.denominator for one in self.sines))
        return Fraction(math.gcd(*(int(one.omega * below) for one in self.sines)), below)

    def moved(self, start: Fraction) -> Piece:
        """Return the same function of time as a piece with another start; exact."""
        if start == self.start:
            return self
        return Piece(start, shifted(self.polynomial, start - self.start), self.sines)


@record
class Signal(ShortRepr):
    """A function of time: pieces in order of their start (s), 0 before the first one. Exact. Raises InvalidScene.

    A force u(t) (N), on either body, the velocity of a belt (m/s), the displacement of the wall (m). `Force` is the
    same class by the name of its first use. f + g, f - g, c f and f/c are signals again.

    >>> (Force.step(1, 2) + Force.ramp(0, 2, 4))(Fraction(3, 2)), (Force.constant(3) - Force.constant(1) / 2)(1)
    (Fraction(5, 1), Fraction(5, 2))
    >>> force = 2 * Force.sine("0.35", 5) + Force.trapezoid(2, 1, 1, 0, "0.2")
    >>> force.piece_at(Fraction(5, 2)).polynomial, force.pieces[0].sines
    ((Fraction(0, 1), Fraction(1, 5)), (Sine(amplitude=0.7, omega=5),))
    >>> force.starts, force.frequency, Signal.sweep(1, [5, 6], 2).pieces[1]
    ((Fraction(0, 1), Fraction(2, 1), Fraction(3, 1), Fraction(4, 1)), None, Piece(start=2, sines=(Sine(...),)))
    >>> Signal.samples([0, "0.5", 1], [0, 1, 1])(0.25), Signal.samples([0, "0.5"], [2, 1], kind="hold")(0.25)
    (Fraction(1, 2), Fraction(2, 1))
    """

    pieces: tuple[Piece, ...]

    def __init__(self, pieces: Iterable[Piece] = ()) -> None:
        """Keep the pieces; each starts after the one before it."""
        kept = tuple(listed("pieces", pieces, f" of Pieces; {MAKERS}"))
        require_all("pieces", kept, Piece, f"Piece(start, polynomial, sines); {MAKERS}")
        require_order("a signal", [one.start for one in kept])
        put(self, pieces=kept)

    @classmethod
    def constant(cls, height: Exact) -> Signal:
        """Return `height` at all times."""
        return cls.step(0, height)

    @classmethod
    def step(cls, at: Exact, height: Exact) -> Signal:
        """Return 0 before the time `at` (s), `height` from then on."""
        return cls((Piece(at, (height,)),))

    @classmethod
    def ramp(cls, start: Exact, end: Exact, height: Exact) -> Signal:
        """Return the signal that grows linearly from 0 at `start` to `height` at `end` > start, and stays there."""
        first = exact_decimal(start, "start")
        return cls._edge(first, _length(exact_decimal(end, "end") - first, "end - start"), height)

    @classmethod
    def _edge(cls, at: Fraction, length: Fraction, height: Exact) -> Signal:
        """Return the signal that gets from 0 to a height within a time, at once if that is 0, and stays there."""
        top = exact_decimal(height, "height")
        rise = (Piece(at, (0, top / length)),) if length else ()
        return cls((*rise, Piece(at + length, (top,))))

    @classmethod
    def trapezoid(cls, start: Exact, rise: Exact, hold: Exact, fall: Exact, height: Exact) -> Signal:
        """Return the signal that rises for `rise` s, stays at `height` for `hold` s and falls for `fall` s to 0.

        rise, hold, fall >= 0, not all 0; a part of length 0 is left out.
        """
        parts = {"rise": rise, "hold": hold, "fall": fall}
        up, stay, down = (nonnegative(one, name, _DURATION) for name, one in parts.items())
        _length(up + stay + down, "rise + hold + fall")
        at = exact_decimal(start, "start")
        return cls._edge(at, up, height) + -cls._edge(at + up + stay, down, height)

    @classmethod
    def sine(cls, amplitude: Exact, omega: Exact, phase: Exact = 0, start: Exact = 0) -> Signal:
        """Return amplitude sin(omega t + phase) from `start` (s) on; t from the start of the run."""
        return cls((Piece(start, (), (Sine(amplitude, omega, phase),)),))

    @classmethod
    def sweep(cls, amplitude: Exact, omegas: Iterable[Exact], duration: Exact, start: Exact = 0) -> Signal:
        """Return sines of stepped frequency, `duration` (s) each, with continuous phase; the last one does not end."""
        length = _length(duration, "duration")
        at, phase, before, pieces = exact_decimal(start, "start"), Fraction(0), Fraction(0), []
        for one in listed("omegas", omegas):
            omega = exact_decimal(one, "omega")
            phase += (before - omega) * at
            pieces.append(Piece(at, (), (Sine(amplitude, omega, phase),)))
            at, before = at + length, omega
        return cls(pieces)

    @classmethod
    def samples(cls, t: Iterable[Exact], u: Iterable[Exact], kind: str = "linear", first_row: int = 1) -> Signal:
        """Return the signal through samples u at the times t (s): linear between them, or ("hold") as the one before.

        After the last sample its value stays. Errors name the row, counted from `first_row`.
        """
        require_one_of("kind", kind, ("linear", "hold"), InvalidScene)
        times, values = list(listed("t", t)), list(listed("u", u))
        for name, given in (("t", t), ("u", u)):
            masked = getattr(getattr(given, "mask", None), "any", None)  # of a column of pandas `mask` is a method
            if masked is not None and masked():
                raise InvalidScene(f"{name} has masked samples; leave their rows out, or fill them")
        if not times:
            raise InvalidScene("t has no samples; give at least one, and one of u for each")
        if len(times) != len(values):
            raise InvalidScene(f"t has {len(times)} samples and u {len(values)}; give one of u for each of t")
        knots: list[tuple[Fraction, Fraction]] = []
        for row, (time, value) in enumerate(zip(times, values, strict=True), first_row):
            at, least = nonnegative(time, f"t in row {row}", _RUN), knots[-1][0] if knots else Fraction(-1)
            if at <= least:
                raise InvalidScene(
                    f"t = {short(at)} in row {row} is not after {short(least)}; put rows in order, once each"
                )
            knots.append((at, exact_decimal(value, f"u in row {row}")))
        pieces = []
        for (at, now), (end, then) in pairwise([*knots, *knots[-1:]]):
            is_ramp = kind == "linear" and end > at
            pieces.append(Piece(at, (now, (then - now) / (end - at)) if is_ramp else (now,)))
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
        """Return the value at t (s): exact if the piece has no sine, else binary64. `side` = -1: the left limit."""
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
        """That of the one piece, from 0 on, that the signal is; else None."""
        return self.pieces[0].frequency if self.starts == (Fraction(0),) else None

    def __add__(self, other: Signal) -> Signal:
        """Return the sum; it has the jumps of both."""
        if not isinstance(other, Signal):
            raise TypeError(f"a signal and {shown(other)} do not add up; write Force.constant(3) for one of 3")
        starts = sorted({*self.starts, *other.starts})
        return Signal(_summed(*(one.piece_at(start).moved(start) for one in (self, other))) for start in starts)

    def __radd__(self, other: int) -> Signal:
        """Return the signal itself where a sum begins with 0, as that of Python does."""
        return self if isinstance(other, int) and other == 0 else self + other  # type: ignore[operator]

    def __rmul__(self, factor: Exact) -> Signal:
        """Return the signal times an exact number."""
        by = exact_decimal(factor, "factor")
        return Signal(
            Piece(
                one.start,
                [by * c for c in one.polynomial],
                [Sine(by * s.amplitude, s.omega, s.phase) for s in one.sines],
            )
            for one in self.pieces
        )

    __mul__ = __rmul__

    def __truediv__(self, divisor: Exact) -> Signal:
        """Return the signal divided by an exact number."""
        by = exact_decimal(divisor, "divisor")
        if not by:
            raise InvalidScene("divisor = 0 must not be 0; give another number")
        return self * (1 / by)

    def __neg__(self) -> Signal:
        """Return the opposite signal."""
        return -1 * self

    def __sub__(self, other: Signal) -> Signal:
        """Return the difference; it has the jumps of both."""
        return self + -1 * other


Force = Signal


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
    return positive(value, name, _DURATION)


def shifted(polynomial: tuple[Fraction, ...], by: Fraction) -> tuple[Fraction, ...]:
    """Return the coefficients of p(x + by), exact (Horner's scheme, repeated)."""
    found = list(polynomial)
    for first in range(len(found) - 1):
        for k in range(len(found) - 2, first - 1, -1):
            found[k] += by * found[k + 1]
    return tuple(found)


def begun(start: Exact) -> Fraction:
    """Return when a piece begins, s, exact and not before the run."""
    return nonnegative(start, "from", _RUN)


def require_order(what: str, starts: list[Fraction]) -> None:
    """Raise InvalidScene unless every piece starts after the one before it."""
    if len(starts) > MAX_PIECES:
        raise InvalidScene(f"{what} has {len(starts)} pieces; at most {MAX_PIECES} are read; leave some out")
    for index, (one, two) in enumerate(pairwise(starts), start=1):
        if two <= one:
            raise InvalidScene(
                f"piece {index + 1} of {what} has from = {short(two)}, not after {short(one)}; put them in order"
            )
