"""A reduced scene in balls: masses, springs, what acts; the norm in which two motions never part."""

from __future__ import annotations

import math
from collections.abc import Sequence
from operator import mul
from typing import Any

from flint import arb, arb_mat, arb_poly

from numerics.arithmetic.ball import BITS_PER_DIGIT, Ball, precision
from numerics.plane.reduced import Acting, Reduced

SPARE_BITS = 40
"""Bits beyond those to which series are cut: the terms of a long step are larger than their sum."""
Balls = list[arb]


class System:
    """A pair on n axes. With N^2 = q1.A2 q1 + v1.M1 v1 + v2.M2 v2 of the difference of two motions N never grows."""

    def __init__(self, given: Reduced, digits: int) -> None:
        """Take the data, and the working precision in decimal digits."""
        self.given, self.digits, self.bits = given, digits, math.ceil(digits * BITS_PER_DIGIT)
        self.n, self.degree = len(given.m1), max(12, int(0.4 * self.bits))
        self.axes = range(self.n)
        number = Ball.number
        with self.fine():
            self.m1, self.m2 = (list(map(number, one)) for one in (given.m1, given.m2))
            self.a1, self.a2 = ([list(map(number, row)) for row in one] for one in (given.a1, given.a2))
            self.mass = [x + y for x, y in zip(self.m1, self.m2, strict=True)]
            self.kappa = [m / (x * y) for m, x, y in zip(self.mass, self.m1, self.m2, strict=True)]
            self.share = [y / m for y, m in zip(self.m2, self.mass, strict=True)]
            self.damped = any(any(row) for row in given.a1)
            self.root_m1, self.root_m2 = ([m.sqrt() for m in one] for one in (self.m1, self.m2))
            # q.A2 q <= sum_i r_i q_i^2, and |q_i| <= N sqrt((A2^-1)_ii)
            self.spring = [sum(map(abs, row), arb(0)).sqrt() for row in self.a2]
            inverse = arb_mat(self.a2).inv()
            self.soft = [inverse[i, i].sqrt() for i in self.axes]
            # an error N moves component i of the load by load_error[i] N at most, and of v1 - v2 by apart[i] N
            self.load_error = [
                self.share[i] * (self.a2[i][i].sqrt() + self.row_sum(self.a1[i], [1 / m for m in self.root_m1]))
                for i in self.axes
            ]
            self.apart = [one.sqrt() for one in self.kappa]
            self.pieces = [Drive(self, piece) for piece in given.pieces]

    def fine(self) -> precision:
        """Return the context in which all is computed: what defects show is where series are cut, no rounding."""
        return precision(self.bits + SPARE_BITS)

    def row_sum(self, row: Sequence[arb], of: Sequence[arb]) -> arb:
        """Return sum |row_j| of_j."""
        return sum(map(mul, map(abs, row), of), arb(0))

    def push(self, u: Sequence[Any], q1: Sequence[Any], v1: Sequence[Any], i: int) -> Any:
        """Return component i of u - A2 q1 - A1 v1, of numbers or of polynomials."""
        found = u[i]
        for j in self.axes:
            if self.given.a2[i][j]:
                found = found - q1[j] * self.a2[i][j]
            if self.given.a1[i][j]:
                found = found - v1[j] * self.a1[i][j]
        return found

    def load(self, u: Sequence[Any], q1: Sequence[Any], v1: Sequence[Any]) -> list[Any]:
        """Return Lam = M2 (M1 + M2)^-1 (u - A2 q1 - A1 v1)."""
        return [self.push(u, q1, v1, i) * self.share[i] for i in self.axes]

    def norm(self, q1: Sequence[arb], v1: Sequence[arb], v2: Sequence[arb]) -> arb:
        """Return a bound on N of a difference with these components, given by their sizes."""
        found = arb(0)
        for i in self.axes:
            found += self.spring[i] * abs(q1[i]) + self.root_m1[i] * abs(v1[i]) + self.root_m2[i] * abs(v2[i])
        return found.upper()


class Drive:
    """What acts in a piece: u of the time from its beginning, and b."""

    def __init__(self, system: System, acting: Acting) -> None:
        """Take what acts, exact."""
        number = Ball.number
        self.acting = acting
        self.length = number(acting.end - acting.start)
        self.polynomial = [[number(one[i]) for one in acting.polynomial] for i in system.axes]
        self.sines = [(number(w), number(at), list(map(number, a))) for w, at, a in acting.sines]
        self.b_squared = list(map(number, acting.b_squared))
        self.b = [one.sqrt() for one in self.b_squared]
        self.reach = max(float((b * k).mid()) for b, k in zip(self.b, system.apart, strict=True)) * arb(1 + 1e-9)
        """h of a difference of two slips is at most that times N."""

    def force(self, t: arb) -> Balls:
        """Return u at a time from the beginning of the piece."""
        found = [arb_poly(one)(t) if one else arb(0) for one in self.polynomial]
        for omega, phase, amplitudes in self.sines:
            sine = (omega * t + phase).sin()
            found = [x + a * sine for x, a in zip(found, amplitudes, strict=True)]
        return found

    def force_rate(self, t: arb) -> Balls:
        """Return du/dt at a time from the beginning of the piece."""
        found = [arb_poly(one).derivative()(t) if one else arb(0) for one in self.polynomial]
        for omega, phase, amplitudes in self.sines:
            cosine = (omega * t + phase).cos()
            found = [x + a * omega * cosine for x, a in zip(found, amplitudes, strict=True)]
        return found

    def swing(self, t: arb) -> list[tuple[arb, arb]]:
        """Return cosine and sine of each phase at a time."""
        found = []
        for omega, phase, _ in self.sines:
            sine, cosine = (omega * t + phase).sin_cos()
            found.append((cosine, sine))
        return found

    def friction(self, s: Sequence[arb]) -> tuple[Balls, arb]:
        """Return f(s) and h(s) of a slip s != 0."""
        size = sum((b * x * x for b, x in zip(self.b_squared, s, strict=True)), arb(0)).sqrt()
        return [b * x / size for b, x in zip(self.b_squared, s, strict=True)], size

    def strain(self, load: Sequence[arb]) -> arb:
        """Return |B^-1 Lam|^2, at most 1 where the load is in K."""
        return sum((x * x / b for x, b in zip(load, self.b_squared, strict=True)), arb(0))
