"""One mode under one piece of force as a linear system z' = A z, its flow by the exponential of a ball matrix.

z = (x1, v1, x2, v2, 1, p0, ..., pd, s1, c1, ...): the state in SI units, the constant, the polynomial of the piece with
its derivatives, and each sine beside its cosine. A is exact, resonance is no special case, and a flow over a ball of
times encloses the flow at each of them. Friction on body 2 in a slip is side b + slope (v1 - v2) + pull (x1 - x2),
where it depends on the state (cells.py).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, sqrt
from numerics.arithmetic.precision import cached_property
from numerics.linear.pieces import ExactPiece
from numerics.scene import Pair, Piece

X1, V1, X2, V2, ONE, FIRST = range(6)
Row = tuple[tuple[int, Fraction], ...]
"""A linear function of z: pairs (place, coefficient)."""
W: Row = ((V1, Fraction(1)), (V2, Fraction(-1)))
Z: Row = ((X1, Fraction(1)), (X2, Fraction(-1)))
"""The relative velocity w = v1 - v2, and x1 - x2."""
_FURTHER = 4
"""Further terms of Taylor in a bound on a remainder."""


class BallDrive(NamedTuple):
    """A piece in balls: its polynomial, and of each sine amplitude, omega and the phase where the piece begins."""

    polynomial: list[arb]
    sines: list[tuple[arb, arb, arb]]

    @classmethod
    def of(cls, piece: Piece | ExactPiece) -> BallDrive:
        """Return a piece in balls."""
        number = Ball.number
        sines = [(number(s.amplitude), number(s.omega), number(s.omega * piece.start + s.phase)) for s in piece.sines]
        return cls([number(c) for c in piece.polynomial], sines)

    def force(self, local: arb) -> list[arb]:
        """Return what of z is the force: its polynomial with its derivatives, and each sine beside its cosine."""
        parts, terms = [], self.polynomial
        for order in range(len(terms)):
            value = arb(0)
            for k in range(len(terms) - 1, order - 1, -1):
                value = value * local + terms[k] * math.perm(k, order)
            parts.append(value)
        for amplitude, omega, phase in self.sines:
            parts += [amplitude * one for one in (phase + omega * local).sin_cos()]
        return parts


@dataclass(frozen=True)
class LinearMode:
    """A pair in the mode `side` (+1, -1: the sign of w; 0: stick) at friction b, under one piece of force.

    `slope` (N s/m) and `pull` (N/m, for this side) are those of friction by w and by x1 - x2 in a slip.
    """

    pair: Pair
    b: Fraction
    side: int
    piece: Piece | ExactPiece
    slope: Fraction = Fraction(0)
    pull: Fraction = Fraction(0)

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
    def friction(self) -> Row:
        """Return F, the friction force on body 2, N; of a slip."""
        by_state = ((V1, self.slope), (V2, -self.slope), (X1, self.pull), (X2, -self.pull))
        return (ONE, self.side * self.b), *(one for one in by_state if one[1])

    @property
    def load(self) -> Row:
        """Return Lambda = m2 (u - a2 x1 - a1 v1)/M, the friction force that sticking needs, N."""
        share = self.pair.m2 / self.pair.mass
        own = (X1, -share * self.pair.a2), (V1, -share * self.pair.a1)
        return (*((place, share * factor) for place, factor in self.force), *own)

    @property
    def mass(self) -> Fraction:
        """Return the mass that the spring moves, kg: body 1 alone in slip, both in stick."""
        return self.pair.m1 if self.side else self.pair.mass

    def generator(self) -> list[list[Fraction]]:
        """Return A, exact."""
        rows = [[Fraction(0)] * self.size for _ in range(self.size)]
        pair = self.pair
        rows[X1][V1] = rows[X2][V2] = Fraction(1)
        for place, factor in ((X1, -pair.a2), (V1, -pair.a1), *self.force):
            rows[V1][place] += factor / self.mass
        if self.side:
            for place, factor in self.friction:
                rows[V1][place] -= factor / pair.m1
                rows[V2][place] += factor / pair.m2
        else:
            rows[V2] = list(rows[V1])
        for k in range(len(self.piece.polynomial) - 1):
            rows[FIRST + k][FIRST + k + 1] = Fraction(1)
        for place, sine in zip(self.sine_places, self.piece.sines, strict=True):
            rows[place][place + 1], rows[place + 1][place] = sine.omega, -sine.omega
        return rows

    @property
    def polynomial_places(self) -> range:
        """Return where the polynomial and its derivatives stand in z."""
        return range(FIRST, FIRST + len(self.piece.polynomial))

    @property
    def sine_places(self) -> range:
        """Return where each sine stands in z, its cosine one place on."""
        return range(FIRST + len(self.piece.polynomial), self.size, 2)

    def motion(self, state: Sequence[arb], t: arb) -> Motion:
        """Return the motion that starts at time t (s) with the state (x1, v1, x2, v2)."""
        z = [*state, arb(1), *BallDrive.of(self.piece).force(t - Ball.number(self.piece.start))]
        return Motion(self, matrix(self.generator()), arb_mat(self.size, 1, z))


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
        begin = t.lower()
        return Stretched(self, self.at(begin), t - begin)

    @cached_property
    def norm(self) -> LocalNorm:
        """Return N of its mode."""
        return LocalNorm(self.mode)

    def range(self, row: Row, t: arb, order: int = 0) -> arb:
        """Return an enclosure of the order-th derivative of a row over a ball of times, by Taylor's theorem."""
        return self.over(t).range(row, order)


class Stretched:
    """A motion over a ball of times: z where it begins, and enclosures of derivatives of rows over the whole of it.

    The remainder is bounded by N of a derivative (LocalNorm), not by exp(A h): a light body 1, whose own rates are
    large, then costs no finer parts for ever.
    """

    def __init__(self, motion: Motion, begin: arb_mat, h: arb) -> None:
        """Keep z where the ball begins; `h` is the ball of times, counted from there."""
        self.motion, self.h, self.derivatives = motion, h, [begin]
        self.bends: dict[int, arb_mat] = {}

    def derivative(self, order: int) -> arb_mat:
        """Return the order-th derivative of z where the ball begins."""
        while len(self.derivatives) <= order:
            self.derivatives.append(self.motion.rate(self.derivatives[-1]))
        return self.derivatives[order]

    def range(self, row: Row, order: int = 0) -> arb:
        """Return an enclosure of the order-th derivative of a row over the ball of times: by Taylor's theorem."""
        here, slope = (value(row, self.derivative(order + n)) for n in (0, 1))
        if self.h.is_zero():
            return here
        return here + self.h * slope + (self.h * self.h / 2) * value(row, self._bend(order + 2))

    def _bend(self, order: int) -> arb_mat:
        """Return an enclosure of the order-th derivative of z, order >= 2, over the ball of times.

        Further terms of Taylor are sharp on a short ball, the bound by energy on a long one.
        """
        if order not in self.bends:
            further = _FURTHER if self.motion.norm.fastest * self.h < 1 else 0
            found = self._bounded(order + further)
            for k in range(further, 0, -1):
                found = self.derivative(order + k - 1) + found * (self.h / k)
            self.bends[order] = found
        return self.bends[order]

    def _bounded(self, order: int) -> arb_mat:
        """Return an enclosure of the order-th derivative of z, order >= 2, over the ball of times by its N."""
        z = self.derivative(order)
        mode, norm, bent = self.motion.mode, self.motion.norm, arb_mat(z)
        places = mode.polynomial_places
        for k, place in enumerate(places):
            powers = (z[later, 0] * (self.h**n / math.factorial(n)) for n, later in enumerate(places[k:]))
            bent[place, 0] = sum(powers, arb(0))
        for place in mode.sine_places:
            amplitude = sqrt(z[place, 0] * z[place, 0] + z[place + 1, 0] * z[place + 1, 0]).upper()
            bent[place, 0] = bent[place + 1, 0] = arb(0, amplitude)
        reached = norm.grown(abs(self.h).upper(), norm.of(z.entries()[:4]), abs(value(mode.force, bent)))
        x1, v1, v2 = ((reached * one).upper() for one in (1 / norm.root_a2, *norm.speeds))
        sizes = {X1: x1, V1: v1}
        if not mode.side:
            sizes |= {X2: x1, V2: v2}
        elif norm.is_coupled:  # else body 2 has a constant acceleration, and z says all
            apart = abs(z[X1, 0] - z[X2, 0]) + norm.apart * reached * abs(self.h)
            sizes |= {X2: (x1 + apart).upper(), V2: v2}
        for place, size in sizes.items():
            bent[place, 0] = arb(0, size)
        return bent


class LocalNorm:
    """N^2 = a2 x1^2 + m1 v1^2 + m2 v2^2 + g (x1 - x2)^2 of a derivative of a motion in one mode and cell; g = |pull|.

    With kappa^2 = M/(m1 m2): |v1 - v2| <= kappa N, and (N^2/2)' = -a1 v1^2 - slope w^2 + (g - pull) w z + v1 u. So N
    grows like exp(mu t) at most, mu = kappa^2 max(0, -slope) + kappa (g - pull)/(2 sqrt(g)), with any g >= |pull|, and
    by int |u| dt/sqrt(m), where m is the mass that the spring moves. A itself is at most `rate` in N; `fastest` is
    that, or a sine's.

    `speeds` are the greatest v1 and v2 for N = 1, `apart` is that of w. Where friction is one number b, v2 has no
    derivatives in a slip but the first.
    """

    def __init__(self, mode: LinearMode, g: Fraction | None = None) -> None:
        """Form the constants, in the present precision."""
        g = abs(mode.pull) if g is None else g
        pair, number = mode.pair, Ball.number
        self.root_a2, self.root_m1, self.root_m2 = (number(one).sqrt() for one in (pair.a2, pair.m1, pair.m2))
        self.root_g, kappa = number(g).sqrt(), number(pair.mass / (pair.m1 * pair.m2)).sqrt()
        self.root_mass, self.is_coupled = number(mode.mass).sqrt(), bool(mode.slope or mode.pull)
        one = 1 / self.root_mass
        self.speeds = one, 1 / self.root_m2 if self.is_coupled else arb(0) if mode.side else one
        self.apart = kappa if self.is_coupled else one
        square, pulled = kappa * kappa, kappa * number((g - mode.pull) / 2) / self.root_g if g else arb(0)
        self.mu = square * number(max(Fraction(0), -mode.slope)) + pulled
        own = number(pair.a1 / mode.mass) + number(pair.a2 / mode.mass).sqrt()
        self.rate = self.fastest = own + square * number(abs(mode.slope)) + kappa * self.root_g
        for sine in mode.piece.sines:
            self.fastest = self.fastest.max(number(sine.omega))

    def of(self, state: Sequence[arb]) -> arb:
        """Return N of (x1, v1, x2, v2)."""
        x1, v1, x2, v2 = state
        a, b, c, d = self.root_a2 * x1, self.root_m1 * v1, self.root_m2 * v2, self.root_g * (x1 - x2)
        return (a * a + b * b + c * c + d * d).abs_upper().sqrt().upper()

    def growth(self, h: arb) -> arb:
        """Return by which factor N may grow in a time h."""
        return arb(1) if self.mu.is_zero() else (self.mu * h).exp().upper()

    def grown(self, h: arb, norm: arb, pushed: arb) -> arb:
        """Return a bound on N after a time up to h, under a force of `pushed` at most."""
        return (self.growth(h) * (norm + h * pushed / self.root_mass)).upper()


def value(row: Row, z: arb_mat) -> arb:
    """Return the value of a linear function of z."""
    total = arb(0)
    for place, factor in row:
        total += Ball.number(factor) * z[place, 0]
    return total


def matrix(rows: Sequence[Sequence[Fraction]]) -> arb_mat:
    """Return an exact matrix as balls."""
    return arb_mat([[Ball.number(one) for one in row] for row in rows])
