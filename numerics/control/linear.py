"""One mode under one piece of force as a linear system z' = A z, its flow by the exponential of a ball matrix.

z = (x1, v1, x2, v2, 1, p0, ..., pd, s1, c1, ...): the state in SI units, the constant, the polynomial of the piece with
its derivatives, and each sine beside its cosine. A is exact, resonance is no special case, and a flow over a ball of
times encloses the flow at each of them. This is an evidence of its own: it shares no closed form with flows/.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

import flint
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import precision
from numerics.scene import Pair, Piece

X1, V1, X2, V2, ONE, FIRST = range(6)
Row = tuple[tuple[int, Fraction], ...]
"""A linear function of z: pairs (place, coefficient)."""
W: Row = ((V1, Fraction(1)), (V2, Fraction(-1)))
"""The relative velocity w = v1 - v2."""
_REMAINDER_BITS = 80
MOST_CUTS = 2_000
"""Into so many parts an interval is cut before a sign on it counts as undecided."""


@dataclass(frozen=True)
class LinearMode:
    """A pair in the mode `side` (+1, -1: the sign of w; 0: stick) at friction b, under one piece of force."""

    pair: Pair
    b: Fraction
    side: int
    piece: Piece

    @property
    def size(self) -> int:
        """Return the number of components of z."""
        return FIRST + len(self.piece.polynomial) + 2 * len(self.piece.sines)

    @property
    def force(self) -> Row:
        """Return u as a linear function of z."""
        first = FIRST + len(self.piece.polynomial)
        sines = [(first + 2 * k, Fraction(1)) for k in range(len(self.piece.sines))]
        return (*([(FIRST, Fraction(1))] if self.piece.polynomial else []), *sines)

    @property
    def load(self) -> Row:
        """Return Lambda = m2 (u - a2 x1 - a1 v1)/M, the friction force that sticking needs, N."""
        share = self.pair.m2 / self.pair.mass
        own = (X1, -share * self.pair.a2), (V1, -share * self.pair.a1)
        return (*((place, share * factor) for place, factor in self.force), *own)

    def generator(self) -> list[list[Fraction]]:
        """Return A, exact."""
        rows = [[Fraction(0)] * self.size for _ in range(self.size)]
        pair = self.pair
        mass = pair.m1 if self.side else pair.mass
        rows[X1][V1] = rows[X2][V2] = Fraction(1)
        for place, factor in ((X1, -pair.a2), (V1, -pair.a1), (ONE, -self.side * self.b), *self.force):
            rows[V1][place] += factor / mass
        if self.side:
            rows[V2][ONE] = self.side * self.b / pair.m2
        else:
            rows[V2] = list(rows[V1])
        for k in range(len(self.piece.polynomial) - 1):
            rows[FIRST + k][FIRST + k + 1] = Fraction(1)
        for place, sine in zip(self._sine_places, self.piece.sines, strict=True):
            rows[place][place + 1], rows[place + 1][place] = sine.omega, -sine.omega
        return rows

    @property
    def _sine_places(self) -> range:
        return range(FIRST + len(self.piece.polynomial), self.size, 2)

    def start(self, state: Sequence[arb], t: arb) -> arb_mat:
        """Return z at time t (s) with the state (x1, v1, x2, v2)."""
        number = Ball.number
        since, terms = t - number(self.piece.start), self.piece.polynomial
        z = [*state, arb(1)]
        for order in range(len(terms)):
            value = arb(0)
            for k in range(len(terms) - 1, order - 1, -1):
                value = value * since + number(terms[k] * math.perm(k, order))
            z.append(value)
        for sine in self.piece.sines:
            parts = (number(sine.omega) * t + number(sine.phase)).sin_cos()
            z.extend(number(sine.amplitude) * one for one in parts)
        return arb_mat([[one] for one in z])

    def motion(self, state: Sequence[arb], t: arb) -> Motion:
        """Return the motion that starts at time t (s) with the state (x1, v1, x2, v2)."""
        return Motion(self, matrix(self.generator()), self.start(state, t))


@dataclass(frozen=True)
class Motion:
    """z(t) = exp(A t) z(0), t (s) from the start of the motion; everything enclosed."""

    mode: LinearMode
    matrix: arb_mat
    begin: arb_mat

    def flow(self, t: arb) -> arb_mat:
        """Return exp(A t)."""
        return (self.matrix * t).exp()

    def at(self, t: arb) -> arb_mat:
        """Return z(t)."""
        return self.flow(t) * self.begin

    def state(self, t: arb) -> tuple[arb, arb, arb, arb]:
        """Return (x1, v1, x2, v2) at t."""
        z = self.at(t)
        return z[X1, 0], z[V1, 0], z[X2, 0], z[V2, 0]

    def rate(self, z: arb_mat) -> arb_mat:
        """Return z' = A z."""
        return self.matrix * z

    def over(self, t: arb) -> Stretched:
        """Return the motion over a ball of times, for the ranges of rows and of their derivatives."""
        return Stretched(self.matrix, self.at(t.mid()), t - t.mid())

    def range(self, row: Row, t: arb, order: int = 0) -> arb:
        """Return an enclosure of the order-th derivative of a row over a ball of times, by Taylor's theorem."""
        return self.over(t).range(row, order)


class Stretched:
    """A motion over a ball of times: z in its middle, and enclosures of derivatives of rows over the whole of it."""

    def __init__(self, matrix: arb_mat, middle: arb_mat, h: arb) -> None:
        """Keep z in the middle; `h` is the ball of times, counted from the middle."""
        self.matrix, self.h, self.derivatives = matrix, h, [middle]
        # what bounds a remainder needs few digits
        with precision(min(flint.ctx.prec, _REMAINDER_BITS)):
            self.bends = [(matrix * h).exp() * middle]

    def _taken(self, kept: list[arb_mat], order: int) -> arb_mat:
        while len(kept) <= order:
            kept.append(self.matrix * kept[-1])
        return kept[order]

    def range(self, row: Row, order: int = 0) -> arb:
        """Return an enclosure of the order-th derivative of a row over the ball of times, by Taylor's theorem."""
        here, slope = (value(row, self._taken(self.derivatives, order + n)) for n in (0, 1))
        if self.h.is_zero():
            return here
        bend = value(row, self._taken(self.bends, order + 2))
        return here + self.h * slope + (self.h * self.h / 2) * bend


def value(row: Row, z: arb_mat) -> arb:
    """Return the value of a linear function of z."""
    total = arb(0)
    for place, factor in row:
        total += Ball.number(factor) * z[place, 0]
    return total


def matrix(rows: Sequence[Sequence[Fraction]]) -> arb_mat:
    """Return an exact matrix as balls."""
    return arb_mat([[Ball.number(one) for one in row] for row in rows])


def between(low: arb, high: arb) -> arb:
    """Return the ball from the least point of one ball to the greatest of another."""
    return low.lower().union(high.upper())


def is_positive_on(function: Callable[[arb], arb], start: arb, end: arb, most: int = MOST_CUTS) -> bool:
    """Return whether an enclosure of a function is proved positive over [start, end], cut in halves where needed."""
    waiting, cuts = [(start.lower(), end.upper())], 0
    while waiting:
        low, high = waiting.pop()
        if function(low.union(high)) > 0:
            continue
        cuts += 1
        middle = ((low + high) / 2).mid()
        if cuts > most or function(middle) < 0 or not (low < middle < high):
            return False
        waiting += [(middle, high), (low, middle)]
    return True
