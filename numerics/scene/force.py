"""The force u(t) on body 1, by pieces: on each a polynomial plus finitely many sines, everything an exact rational."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import zip_longest

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, exact_decimal, listed, positive, put, short
from numerics.scene.pieces import Piece, Sine, require_order
from numerics.scene.short_repr import ShortRepr


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Force(ShortRepr):
    """The force u(t) on body 1, N: pieces in order of their start (s); before the first one, and with none, u = 0.

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
        if not all(isinstance(one, Piece) for one in kept):
            raise InvalidScene("a force is made of Piece(start, polynomial, sines); build them first")
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

        rise, hold, fall >= 0, not all 0; where one of them is 0 that part is left out.
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
        """Return a staircase of sines, `duration` (s) each, whose phase goes on without a jump; the last one stays."""
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
        """Return the piece that holds right after (side = 1) or right before (-1) the time t (s)."""
        find = bisect_right if side > 0 else bisect_left
        index = find(self.pieces, t, key=lambda one: one.start)
        return self.pieces[index - 1] if index else Piece(0)

    def __call__(self, t: Exact, side: int = 1) -> Fraction | float:
        """Return u(t) (N); exact where no sine acts, else in binary64. `side` = -1: the value right before t."""
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
        """Return the greatest omega (rad/s) of which all frequencies are multiples, exact: the period is 2 pi/omega.

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


def _summed(one: Piece, two: Piece) -> Piece:
    """Return the sum of two pieces that begin at the same time; equal sines become one."""
    coefficients = map(sum, zip_longest(one.polynomial, two.polynomial, fillvalue=Fraction(0)))
    sines: dict[tuple[Fraction, Fraction], Fraction] = {}
    for sine in (*one.sines, *two.sines):
        key = sine.omega, sine.phase
        sines[key] = sines.get(key, Fraction(0)) + sine.amplitude
    return Piece(one.start, coefficients, [Sine(amplitude, *key) for key, amplitude in sines.items()])


def _length(value: Exact, name: str) -> Fraction:
    return positive(value, name, "give a duration in seconds")
