"""The flow of a slip whose friction depends on the state: x1 and x2 are coupled, and N may grow.

What a Taylor polynomial leaves out is bounded by N of a derivative of the whole state (LocalNorm): with y the order-th
one, N(y) <= exp(mu h) (N(y(0)) + h |u^(order)|/sqrt(m1)) up to h, and |w| <= kappa N, |v1| <= N/sqrt(m1), z' = w.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import zip_longest
from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.linear.cells import Branch
from numerics.linear.flow import FEW, BallNumbers, Expansion, Flow, Numbers
from numerics.linear.system import X1, X2, LinearMode, LocalNorm
from numerics.scene import Pair, Piece

SPEED, PLACE, FORCE = range(3)
"""The rows of which there are guards: v1 - v2, x1 - x2, and friction."""


class CoupledFlow(Flow):
    """The flow of a slip in one cell; z is that of LinearMode with side b = 1: the constant in it is side offset."""

    def __init__(self, numbers: Numbers, pair: Pair, count: int, omegas: tuple[Fraction, ...], branch: Branch) -> None:
        """Build the tables."""
        self.branch = branch
        super().__init__(numbers, pair, True, count, omegas)

    def mode_of(self, piece: Piece) -> LinearMode:
        """Return the mode."""
        mode = LinearMode(self.pair, Fraction(1), 1, piece, self.branch.slope, self.branch.pull)
        self.norm = LocalNorm(mode)
        return mode

    def rate_of(self, rate: arb) -> arb:  # noqa: ARG002
        """Return a bound on A in N."""
        return self.norm.rate

    def begin_rows(self) -> None:
        """Form the rows of x1 and x2 in front of z."""
        self.own = [self.powers(((place, Fraction(1)),), self.terms) for place in (X1, X2)]
        self.x1, self.x2 = (self.numbers.products(one) for one in self.own)
        self._both: dict[int, list[Callable[[list[arb]], list[arb]]]] = {}

    def rows(self, z: list[Any], bits: int) -> list[list[arb]]:
        """Return the first coefficients of w, x1 - x2 and F, and those of x1 and x2."""
        with flint.ctx.workprec(bits):
            if bits not in self._both:
                first = ([[+arb(c) for c in row] for row in own[: FEW + 2]] for own in self.own)
                self._both[bits] = [BallNumbers.products(one) for one in first]
            numbers = [+arb(c) for c in z]
            x1, x2 = (filled(products(numbers), FEW + 2, arb(0)) for products in self._both[bits])
            place = [one - two for one, two in zip(x1, x2, strict=True)]
            speed = [k * one for k, one in enumerate(place)][1:]
            slope, pull = map(Ball.number, self.branch[1:])
            force = [slope * w + pull * apart for w, apart in zip(speed, place, strict=False)]
            force[0] += numbers[4]
            return [speed, place, force, x1, x2]

    def rests(self, rows: Sequence[Sequence[arb]], z: list[Any], h: arb) -> list[arb]:
        """Return R of w, x1 - x2 and F from order FEW on, up to h."""
        x1, x2 = rows[3:]
        speed, place = self.reached(x1, x2, FEW, z, h), self.reached(x1, x2, FEW - 1, z, h) / FEW
        return self.of_rows(speed, place)

    def of_rows(self, speed: arb, place: arb) -> list[arb]:
        """Return bounds on w, x1 - x2 and F from those on N of the rate of the state, and on N of the state."""
        w, apart = self.norm.kappa * speed, self.norm.kappa * place
        slope, pull = map(Ball.number, self.branch[1:])
        return [w, apart, abs(slope) * w + abs(pull) * apart]

    def reached(self, x1: Sequence[Any], x2: Sequence[Any], order: int, z: Sequence[Any], h: arb) -> arb:
        """Return a bound on N of the order-th derivative of the state over order!, up to h, from coefficients."""
        a, c, b, d = (arb(one) for one in (x1[order], x1[order + 1], x2[order], x2[order + 1]))
        norm = self.norm.of((a, (order + 1) * c, b, (order + 1) * d))
        # pushed counts h/m1: N takes h/sqrt(m1)
        return ((self.norm.mu * h).exp() * (norm + self.pushed(z, order, 0, h) * self.norm.root_m1)).upper()

    def expansion(self, z: list[Any]) -> CoupledExpansion:
        """Return the motion from z on."""
        return CoupledExpansion(self, z)


class CoupledExpansion(Expansion):
    """The motion from a point on as Taylor polynomials of x1 and x2, both cut before the same order."""

    flow: CoupledFlow

    def __init__(self, flow: CoupledFlow, z: list[Any]) -> None:
        """Form the polynomials."""
        curve, zero = flow.numbers.curve, 0 * z[0]
        one, two = (filled(product(z), flow.terms, zero) for product in (flow.x1, flow.x2))
        self.flow, self.z, self.order, self.both = flow, z, flow.terms - 1, (one, two)
        self.x, self.y = curve(one[:-1]), curve(two[:-1])
        self.v, self.w = self.x.derivative(), self.y.derivative()

    def row(self, which: int) -> Any:
        """Return a row: w, x1 - x2, or F."""
        numbers, apart = self.flow.numbers, self.x + self.y * -1
        speed, (slope, pull) = apart.derivative(), map(numbers.number, self.flow.branch[1:])
        return (speed, apart, speed * slope + apart * pull + numbers.curve([self.z[4]]))[which]

    def rest(self, h: arb) -> arb:
        """Return R for kappa = 1: the rate of the state, over the order."""
        n = self.order
        return (self.flow.reached(*self.both, n - 1, self.z, h) / n).upper()

    def left_out(self, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of x1 leaves out up to h, and of x2."""
        return self._cut(h, derivative) / self.flow.norm.root_m1.min(self.flow.norm.root_m2)

    def _cut(self, h: arb, derivative: int) -> arb:
        return (self.rest(h) * math.perm(self.order, derivative) * h ** (self.order - derivative)).upper()

    def row_off(self, which: int, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of a row leaves out up to h."""
        return self.flow.of_rows(self._cut(h, derivative + 1), self._cut(h, derivative))[which].upper()

    def state(self, t: Any) -> list[Any]:
        """Return the state at a time after the point."""
        within, h = self.flow.numbers.within, arb(t).abs_upper()
        place, speed = self.left_out(h, 0), self.left_out(h, 1)
        return [
            within(one(t), off) for one, off in ((self.x, place), (self.v, speed), (self.y, place), (self.w, speed))
        ]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        off = self.left_out(t.upper(), 2)
        return [one.derivative()(t).abs_upper() + off for one in (self.v, self.w)]


def filled(row: list[Any], count: int, zero: Any) -> list[Any]:
    """Return coefficients, those that vanish for ever included."""
    return [one for one, _ in zip_longest(row, range(count), fillvalue=zero)]


coupled_flow_of = lru_cache(maxsize=256)(CoupledFlow)
"""A flow, built once."""
