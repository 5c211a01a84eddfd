"""One mode under one piece of the signals, z' = A z: its exact matrices, z in balls, the norm of differences.

z and A are those of model.py; in a slip s the block of b in z is multiplied by s. Resonance is no special case.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, magnitude_bits
from numerics.arithmetic.precision import cached_property
from numerics.linear.model import (
    CONSTANT,
    FIRST,
    FRICTION,
    KINETIC,
    LOAD,
    SLIP,
    STICK,
    V1,
    V2,
    X1,
    X2,
    Bodies,
    Cell,
    Layout,
    ModeRows,
    add_signal,
    exact_rows,
)
from numerics.linear.pieces import ExactPiece, polynomial_at
from numerics.scene import Pair, Piece, Sine
from numerics.scene.short_repr import ShortRepr

Row = tuple[tuple[int, Fraction], ...]
"""A linear function of z: pairs (place, coefficient)."""
W: Row = ((V1, Fraction(1)), (V2, Fraction(-1)))
Z: Row = ((X1, Fraction(1)), (X2, Fraction(-1)))
"""The relative velocity w = v1 - v2, and x1 - x2."""
BallRow = Sequence[tuple[int, arb]]


def sparse(row: Iterable[Any]) -> Row:
    """Return a row without what is 0."""
    return tuple((place, factor) for place, factor in enumerate(row) if factor)


class BallDrive:
    """The signals of a piece in balls: polynomials, and of each sine amplitude, omega, and phase where it begins."""

    def __init__(self, piece: ExactPiece) -> None:
        """Take a piece; the present precision is that of its numbers."""
        number = Ball.number
        self.signals = [
            (
                [number(c) for c in one.polynomial],
                [(number(s.amplitude), number(s.omega), number(s.omega * piece.start + s.phase)) for s in one.sines],
            )
            for one in piece.signals
        ]

    def at(self, local: arb, side: int) -> list[arb]:
        """Return the blocks of z at a time in the piece (s), in a mode `side`."""
        signed = list(zip([1] * FRICTION + [side or 1], self.signals, strict=True))
        found = [sign * polynomial_at(one, local, k) for sign, (one, _) in signed for k in range(len(one))]
        for sign, (_, sines) in signed:
            for amplitude, omega, phase in sines:
                found += [sign * amplitude * one for one in (phase + omega * local).sin_cos()]
        return found


@dataclass(frozen=True, repr=False)
class LinearMode(ShortRepr):
    """A pair in the mode `side` (+1, -1: the sign of w; 0: stick) under a piece of the signals."""

    pair: Pair
    side: int
    piece: ExactPiece
    cell: Cell = CONSTANT

    @classmethod
    def under(cls, pair: Pair, side: int, force: Piece) -> LinearMode:
        """Return the mode under one piece of a force on body 1 and the pair's b."""
        nothing, start = Piece(0), force.start
        return cls(
            pair, side, ExactPiece(start, Fraction(0), (force, nothing, nothing, nothing, Piece(0, (pair.b,))), True)
        )

    @classmethod
    def like(cls, pair: Pair, side: int, layout: Layout, cell: Cell = CONSTANT) -> LinearMode:
        """Return the mode under signals of this layout, all of their numbers 1."""
        ones = (Piece(0, (1,) * terms, [Sine(1, w) for w in waves]) for terms, waves in zip(*layout, strict=True))
        return cls(pair, side, ExactPiece(Fraction(0), Fraction(1), tuple(ones), True), cell)

    @property
    def layout(self) -> Layout:
        """Return the places of z."""
        return self.piece.layout

    @property
    def rows(self) -> ModeRows:
        """Return the exact matrices of both modes."""
        return exact_rows(self.pair, self.layout, self.cell)

    @property
    def size(self) -> int:
        """Return the number of components of z."""
        return self.layout.size

    def signal(self, which: int) -> Row:
        """Return a signal as a linear function of z."""
        row = [Fraction(0)] * self.size
        add_signal(row, self.layout.blocks[which], Fraction(1))
        return sparse(row)

    @property
    def friction(self) -> Row:
        """Return F, the friction force on body 2, N; of a slip."""
        return sparse(self.rows.others[KINETIC])

    @property
    def load(self) -> Row:
        """Return Lambda, the friction force that sticking needs, N."""
        return sparse(self.rows.others[LOAD])

    @property
    def guards(self) -> tuple[Row, ...]:
        """Return the rows that are positive in the mode, but for the sign of a slip."""
        return (W,) if self.side else tuple(map(sparse, self.rows.guards[STICK]))

    @property
    def mass(self) -> Fraction:
        """Return the mass that the spring moves, kg: body 1 alone in slip and beside a belt, both in stick."""
        return self.pair.m1 if self.side or self.pair.is_fixed else self.pair.mass

    def generator(self) -> list[list[Fraction]]:
        """Return A, exact."""
        return [list(row) for row in self.rows.A[SLIP if self.side else STICK]]

    @cached_property
    def entry_bits(self) -> int:
        """Return e where no entry of A is above 2^e."""
        largest = max(abs(one) for row in self.generator() for one in row)
        return largest.numerator.bit_length() - largest.denominator.bit_length() + 1

    def squarings(self, t: arb) -> int:
        """Return how often a time must be halved for the flow over it to be a small matrix."""
        upper = t.abs_upper()
        return max(0, self.entry_bits + 6 + magnitude_bits(upper)) if upper > 0 and upper.is_finite() else 0

    @property
    def sine_places(self) -> range:
        """Return where each sine stands in z, its cosine one place on."""
        return range(FIRST + sum(self.layout.terms), self.size, 2)

    @property
    def amplitudes(self) -> list[Fraction]:
        """Return those of the sines."""
        return [one.amplitude for signal in self.piece.signals for one in signal.sines]

    def begin(self, state: Sequence[arb], t: arb) -> list[arb]:
        """Return z at time t (s), where (x1, v1, x2, v2) is a state."""
        return [*state, *BallDrive(self.piece).at(t - Ball.number(self.piece.start), self.side)]


class LocalNorm:
    """N^2 = a2 x1^2 + m1 v1^2 + m2 v2^2 + g (x1 - x2)^2 of differences of motions in one mode and cell; g = |pull|.

    With kappa^2 = 1/m1 + 1/m2: |v1 - v2| <= kappa N, and (N^2/2)' = -a1 v1^2 - slope w^2 + (g - pull) w z. So N grows
    like exp(mu t) at most, mu = kappa^2 max(0, -slope) + kappa (g - pull)/(2 sqrt(g)), with any g >= |pull|. A itself
    is at most `fastest` in N, which no sine exceeds either. A body 2 of infinite mass counts for nothing.

    Derivatives of a motion obey z' = A z too, and what is no part of N pushes them (`sizes`): the signals, and a body
    that goes with the signals alone, as body 2 does in a slip, unless friction depends on the state.
    """

    def __init__(self, mode: LinearMode, g: Fraction | None = None) -> None:
        """Form the constants, in the present precision."""
        (slope, pull, _), pair, number = mode.cell if mode.side else CONSTANT, mode.pair, Ball.number
        g = abs(pull) if g is None else g
        bodies = Bodies.of(pair)
        self.mode, self.is_fixed = mode, pair.is_fixed
        self.root_a2, self.root_m1, self.root_g = (number(one).sqrt() for one in (pair.a2, pair.m1, g))
        self.root_m2 = arb(0) if self.is_fixed else number(pair.m2).sqrt()
        self.kappa, self.root_mass = number(bodies.inverse_1 + bodies.inverse_2).sqrt(), number(mode.mass).sqrt()
        square = self.kappa * self.kappa
        pulled = self.kappa * number((g - pull) / 2) / self.root_g if g else arb(0)
        self.mu = square * number(max(Fraction(0), -slope)) + pulled
        self.load = number(bodies.share_2**2 * (pair.a2 + pair.a1**2 / pair.m1)).sqrt()
        """Of Lambda."""
        own = number(pair.a1 / mode.mass) + number(pair.a2 / mode.mass).sqrt()
        self.fastest = own + square * number(abs(slope)) + self.kappa * self.root_g
        for omegas in mode.layout.omegas:
            for omega in omegas:
                self.fastest = self.fastest.max(number(omega))
        A = mode.generator()
        on_state = {V: any(A[V][:FIRST]) for V in (V1, V2)}
        masses = (self.root_m1, self.root_m2) if mode.side else (self.root_mass, self.root_mass)
        self.moved = {V: root for V, root in zip((V1, V2), masses, strict=True) if on_state[V]}
        """The bodies that the state accelerates, not the signals alone, and the roots of what moves with them."""
        kept = [place for V in self.moved for place in (V - 1, V)]
        self.pushes = {V: [(k, abs(number(c))) for k, c in sparse(A[V]) if k not in kept] for V in (V2, V1)}
        self.blocks = [range(first, first + terms) for first, terms, *_ in mode.layout.blocks.tolist()]

    def of(self, state: Sequence[arb]) -> arb:
        """Return N of (x1, v1, x2, v2)."""
        x1, v1, x2, v2 = state
        return length(self.root_a2 * x1, self.root_m1 * v1, self.root_m2 * v2, self.root_g * (x1 - x2))

    def most(self, row: Sequence[arb]) -> arb:
        """Return a bound on the row of (x1, v1, x2, v2) of a difference whose N is 1; of stick both bodies move as one.

        What N does not know (places without a spring, body 2 of infinite mass) the row must not depend on either.
        """
        x1, v1, x2, v2 = row[:4]
        roots = self.root_a2, self.root_m1 if self.mode.side else self.root_mass, self.root_m2, self.root_g
        return length(*(a / root for a, root in zip((x1 + x2, v1, v2, x2), roots, strict=True) if root > 0))

    def growth(self, h: arb) -> arb:
        """Return by which factor N may grow in a time h."""
        return arb(1) if self.mu.is_zero() else (self.mu * h).exp().upper()

    def sizes(self, z: Sequence[arb], h: arb) -> list[arb]:
        """Return bounds on what is in a derivative of z, the first or a later one, for a time h, from its value on."""
        found = [abs(one).upper() for one in z]
        for block in self.blocks:
            for k in block:
                found[k] = sum((found[m] * h ** (m - k) / math.factorial(m - k) for m in range(k, block.stop)), arb(0))
        for k in self.mode.sine_places:
            found[k] = found[k + 1] = length(z[k], z[k + 1])
        for V in self.pushes:
            if V not in self.moved:
                found[V] += h * dot(self.pushes[V], found)
                found[V - 1] += h * found[V]
        if self.moved:
            kept = [one if k | 1 in self.moved else arb(0) for k, one in enumerate(z[:FIRST])]
            pushed = length(*(root * dot(self.pushes[V], found) for V, root in self.moved.items()))
            reached = self.growth(h) * (self.of(kept) + h * pushed)
            for V, root in self.moved.items():
                found[V] = reached / root
                found[V - 1] += h * found[V]
        return [one.upper() for one in found]


def length(*numbers: arb) -> arb:
    """Return a bound on the root of the sum of squares."""
    return sum((one * one for one in numbers), arb(0)).abs_upper().sqrt().upper()


def dot(row: BallRow, z: Sequence[arb]) -> arb:
    """Return the value of a row."""
    return sum((c * z[place] for place, c in row), arb(0))


def in_balls(row: Row) -> BallRow:
    """Return a row with factors in balls."""
    return [(place, Ball.number(c)) for place, c in row]


def value(row: Row, z: Sequence[arb]) -> arb:
    """Return the value of an exact row."""
    return dot(in_balls(row), z)


def matrix(rows: Sequence[Sequence[Fraction]]) -> arb_mat:
    """Return an exact matrix as balls."""
    return arb_mat([[Ball.number(one) for one in row] for row in rows])
