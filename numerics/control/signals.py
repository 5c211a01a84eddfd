"""Derivatives of a piece of polynomial and sines: enclosed, compared exactly at a time, bounded on an interval."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.exact_sign import is_never_negative
from numerics.errors import EventUndecided
from numerics.scene import Piece

_MOST_PARTS = 20_000


@dataclass(frozen=True)
class Derivative:
    """The order-th derivative of a piece: a polynomial in t - start, and sines A sin(omega t + phase + turns pi/2)."""

    start: Fraction
    polynomial: tuple[Fraction, ...]
    sines: tuple[tuple[Fraction, Fraction, Fraction], ...]
    turns: int

    @classmethod
    def of(cls, piece: Piece, order: int) -> Derivative:
        """Return it; exact."""
        left = piece.polynomial[order:]
        polynomial = tuple(c * math.perm(k, order) for k, c in enumerate(left, start=order))
        sines = tuple((one.amplitude * one.omega**order, one.omega, one.phase) for one in piece.sines)
        return cls(piece.start, polynomial, sines, order % 4)

    def derivative(self) -> Derivative:
        """Return the derivative of it."""
        polynomial = tuple(k * c for k, c in enumerate(self.polynomial))[1:]
        sines = tuple((amplitude * omega, omega, phase) for amplitude, omega, phase in self.sines)
        return Derivative(self.start, polynomial, sines, (self.turns + 1) % 4)

    def __call__(self, t: arb) -> arb:
        """Return an enclosure over a ball of times (s)."""
        since, total = t - Ball.number(self.start), arb(0)
        for c in reversed(self.polynomial):
            total = total * since + Ball.number(c)
        for amplitude, omega, phase in self.sines:
            total += Ball.number(amplitude) * self._turned(Ball.number(omega) * t + Ball.number(phase))
        return total

    def _turned(self, angle: arb) -> arb:
        sine, cosine = angle.sin_cos()
        return (sine, cosine, -sine, -cosine)[self.turns]

    def at(self, t: Fraction) -> dict[Fraction, Fraction]:
        """Return the value at t as coefficients: of 1 under the key 0, else of the sine (or cosine) of a key > 0.

        By Lindemann and Weierstrass 1 and the sines (the cosines) of distinct rationals > 0 are independent over the
        rationals: two such values are equal exactly if their coefficients are.
        """
        found: dict[Fraction, Fraction] = {}
        since, value = t - self.start, Fraction(0)
        for c in reversed(self.polynomial):
            value = value * since + c
        terms = [(Fraction(0), value)]
        odd = self.turns % 2 == 0
        for amplitude, omega, phase in self.sines:
            angle = omega * t + phase
            signed = amplitude * (-1 if self.turns > 1 else 1) * (-1 if odd and angle < 0 else 1)
            terms.append((abs(angle), Fraction(0) if odd and angle == 0 else signed))
        for key, coefficient in terms:
            found[key] = found.get(key, Fraction(0)) + coefficient
        return {key: coefficient for key, coefficient in found.items() if coefficient}

    def is_within(self, limit: Fraction, length: Fraction) -> bool | None:
        """Return whether |f| <= limit over [start, start + length] as far as that is decided exactly, else None.

        For a polynomial it always is; with sines only where sum |A| + max |polynomial| <= limit.
        """
        left = limit - sum((abs(amplitude) for amplitude, _, _ in self.sines), Fraction(0))
        first, *others = self.polynomial or (Fraction(0),)
        below = [left - first, *(-c for c in others)]
        above = [left + first, *others]
        is_small = left >= 0 and all(is_never_negative(one, length) for one in (below, above))
        return is_small if is_small or not self.sines else None


def largest_size(function: Derivative, start: Fraction, end: Fraction, digits: int) -> tuple[arb, arb]:
    """Return an enclosure of max |f| over [start, end] to about `digits` digits, and a time of it.

    The interval is halved; parts that cannot hold the largest value are dropped. Raises EventUndecided.
    """
    slope = function.derivative()
    bend = slope.derivative()

    def reach(part: arb) -> arb:
        """Return an upper bound of |f| on a part, by Taylor's theorem where that is the better one."""
        middle, h = part.mid(), part - part.mid()
        wide = function(middle) + h * slope(middle) + (h * h / 2) * bend(part)
        return abs(function(part)).upper().min(abs(wide).upper())

    parts = [(Ball.number(start).lower(), Ball.number(end).upper())]
    best, where = max(((abs(function(edge)).lower(), edge) for edge in parts[0]), key=lambda one: float(one[0]))
    while parts:
        halves = [
            half
            for low, high in parts
            for middle in [((low + high) / 2).mid()]
            for half in ((low, middle), (middle, high))
        ]
        for _, middle in halves:
            here = abs(function(middle)).lower()
            if here > best:
                best, where = here, middle
        bounds = [reach(low.union(high)) for low, high in halves]
        parts = [half for half, bound in zip(halves, bounds, strict=True) if bound > best]
        most = max([best, *bounds])
        if most - best <= most * arb(10) ** -digits:
            return best.union(most), where
        if len(parts) > _MOST_PARTS or any(not low < ((low + high) / 2).mid() < high for low, high in parts):
            break
    raise EventUndecided("how large does the reference's acceleration get?", best.str(6), working_digits())


def ends(pieces: tuple[Piece, ...], until: Fraction) -> Iterator[tuple[Piece, Fraction]]:
    """Yield each piece that begins before `until` with the time at which it ends."""
    for index, piece in enumerate(pieces):
        if piece.start < until:
            after = pieces[index + 1].start if index + 1 < len(pieces) else until
            yield piece, min(after, until)
