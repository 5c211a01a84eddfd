"""The flow of a mode, z' = A z, in balls: Taylor polynomials of rows, or exp(A t).

A row of z has the Taylor coefficients (row A^k/k!) z. The rows in front of z depend on masses, damping, spring,
frequencies and the degree of the polynomial only; so they are built once and serve every start, amplitude and phase.
What a polynomial leaves out is bounded by N of a derivative of the state (LocalNorm), with m the mass on the spring:

    N(y) <= exp(mu h) (N(y(0)) + h |u^(n)|/sqrt(m))    up to h,    y the n-th derivative, n >= 1,

and |v1| <= N/sqrt(m). Where friction is one number b, body 2 adds a polynomial only and |w| is <= N/sqrt(m), too; where
it depends on the state |w| <= kappa N, kappa^2 = M/(m1 m2).

Everything that takes many steps of that length is left to exp(A t), one sine at a time, since answers add up.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache

from flint import arb, arb_mat, arb_poly, ctx

from numerics.arithmetic.ball import Ball, widened
from numerics.arithmetic.precision import precision
from numerics.linear.system import FIRST, ONE, X1, X2, LinearMode, LocalNorm, Row, W, Z, matrix
from numerics.scene import Pair, Piece, Sine

_X1, _X2 = ((X1, Fraction(1)),), ((X2, Fraction(1)),)
REACH = 2
"""A Taylor polynomial is used while the fastest rate turns through so many radians."""
FEW = 14
"""The degree of the polynomials by which a guard is scanned."""
_FINEST = 1_100
"""Intervals that are shorter by so many bits than a turn are not looked at."""


def exponential(generator: list[list[Fraction]], t: arb, z: list[arb]) -> list[arb]:
    """Return exp(A t) z; long times are formed with more bits, since errors double with each squaring."""
    size = Ball.number(max(sum(map(abs, row)) for row in generator)) * t.abs_upper()
    squarings = max(0, math.ceil(float(size.mid().log().mid()) / math.log(2))) if size > 1 else 0
    with precision(ctx.prec + 3 * squarings + 16):
        flow = (matrix(generator) * t).exp()
    return (flow * arb_mat(len(z), 1, z)).entries()


class Flow:
    """The flow of stick, or of a slip in one cell of friction, under polynomials of one degree and given frequencies.

    z is that of LinearMode for side b = 1, so that the constant in it is side b (0 in stick). `coupling` is slope and
    pull of friction that depends on the state, empty where it is one number b. Rows of which there are guards are the
    load in stick, w = v1 - v2 in a slip, and where it is coupled x1 - x2 and F besides.
    """

    def __init__(
        self,
        bits: int,
        pair: Pair,
        slips: bool,
        count: int,
        omegas: tuple[Fraction, ...],
        coupling: tuple[Fraction, ...] = (),
    ) -> None:
        """Build the tables, with so many bits."""
        self.bits, self.pair, self.slips, self.count, self.coupling = bits, pair, slips, count, coupling
        number = Ball.number
        piece = Piece(0, (1,) * count, [Sine(1, one) for one in omegas])
        self.mode = LinearMode(pair, Fraction(1), int(slips), piece, *coupling)
        self.norm = LocalNorm(self.mode)
        self.generator = [[(j, number(c)) for j, c in enumerate(row) if c] for row in self.mode.generator()]
        self.size, self.places = self.mode.size, list(self.mode.sine_places)
        self.m2, self.root_stiff = number(pair.m2), number(pair.a2 / self.mode.mass).sqrt()
        self.rate, self.fastest, self.turns = self.norm.rate, self.norm.fastest, [number(one) for one in omegas]
        self.reach, self.tiny = (REACH / self.fastest).lower(), (arb((1, -min(bits, _FINEST))) / self.fastest).mid()
        self.expand(max(_terms(bits + 8), FEW + 3))

    def expand(self, terms: int) -> None:
        """Form so many rows in front of z for x1 and x2, and some for every row of which there are guards."""
        self.own = [self.powers(row, terms) for row in ((_X1, _X2) if self.slips else (_X1,))]
        self.all_terms = [_products(one) for one in self.own]
        guarded = (W, Z, self.mode.friction)[: 3 if self.coupling else 1] if self.slips else (self.mode.load,)
        self._guards = _products([one for row in guarded for one in self.powers(row, FEW + 2)])
        self._ends: dict[int, Callable[[Sequence[arb]], list[arb]]] = {}

    def powers(self, row: Row, terms: int) -> list[list[arb]]:
        """Return a row times A^k/k! for so many k, as long as that does not vanish."""
        at, zero, faded = {place: Ball.number(factor) for place, factor in row}, arb(0), 0.0
        found: list[list[arb]] = []
        while len(found) < terms and at:
            found.append([at.get(place, zero) for place in range(self.size)])
            after: dict[int, arb] = {}
            # what counts little within the reach needs few bits
            faded = max(0.0, faded + math.log2(len(found) / REACH))
            with precision(max(64, self.bits + 16 - int(faded))):
                for i, one in at.items():
                    for j, c in self.generator[i]:
                        after[j] = after[j] + one * c if j in after else one * c
                # a ball that holds 0 and more is neither equal nor unequal to 0
                at = {j: one / len(found) for j, one in after.items() if not one == 0}  # noqa: SIM201
        return found

    def rows(self, z: Sequence[arb]) -> list[list[arb]]:
        """Return the first coefficients of every row of which there are guards."""
        found = self._guards(z)
        return [found[k : k + FEW + 2] for k in range(0, len(found), FEW + 2)]

    def rests(self, z: Sequence[arb], h: arb, order: int = FEW) -> list[arb]:
        """Return R of every row of which there are guards: without its terms from t^order on it is off by R t^order."""
        whole = math.factorial(order)
        return self.of_rows(lambda k: self.reached(order + k - 1, z, h) / whole)

    def of_rows(self, bound: Callable[[int], arb]) -> list[arb]:
        """Return bounds on these rows from those on the k-th derivative of places, which are multiples of N."""
        if not self.slips:
            return [self.m2 * self.norm.speeds[0] * bound(2)]
        speed = self.norm.apart * bound(1)
        if not self.coupling:
            return [speed]
        place, (slope, pull) = self.norm.apart * bound(0), map(Ball.number, self.coupling)
        return [speed, place, abs(slope) * speed + abs(pull) * place]

    def reached(self, order: int, z: Sequence[arb], h: arb) -> arb:
        """Return a bound on N of the order-th derivative of the state, order >= 1, up to h."""
        if order not in self._ends:
            none = [arb(0)] * self.size
            ends = ([*own[order : order + 2], none, none][:2] for own in (self.own[0], self.own[-1]))
            self._ends[order] = _products([row for pair in ends for row in pair])
        a, c, b, d = self._ends[order](z)
        norm = self.norm.of((a, (order + 1) * c, b, (order + 1) * d)) * math.factorial(order)
        return self.norm.grown(h, norm, self.pushed(z, order, h))

    def pushed(self, z: Sequence[arb], order: int, h: arb) -> arb:
        """Return a bound on |u^(order)| from z on for a time h."""
        total, places = arb(0), range(FIRST + order, FIRST + self.count)
        for later, place in enumerate(places):
            total += abs(z[place]) * h**later / math.factorial(later)
        for place, omega in zip(self.places, self.turns, strict=True):
            total += (abs(z[place]) + abs(z[place + 1])) * omega**order
        return total


class Expansion:
    """The motion from a point on up to h as Taylor polynomials: x1 is `x`, x2 `y`, their derivatives `v` and `w`."""

    def __init__(self, flow: Flow, z: Sequence[arb], h: arb) -> None:
        """Form the polynomials, both cut before the same order."""
        self.flow, self.z = flow, z
        one, *two = (product(z) for product in flow.all_terms)
        self.order = len(one) - 1
        self.rest = flow.reached(self.order - 1, z, h) / math.factorial(self.order)
        self.x = arb_poly(one[: self.order])
        # in stick body 2 goes with body 1
        self.y = arb_poly(two[0][: self.order]) if two else self.x + (z[X2] - z[X1])
        self.v = self.x.derivative()
        self.w = self.y.derivative() if two else self.v

    def row(self, which: int) -> arb_poly:
        """Return a row of which there is a guard."""
        flow = self.flow
        if not flow.slips:
            return self.w.derivative() * flow.m2
        speed, apart = self.v - self.w, self.x - self.y
        if which < 2:
            return apart if which else speed
        slope, pull = map(Ball.number, flow.coupling)
        return speed * slope + apart * pull + self.z[ONE]

    def left_out(self, h: arb, order: int) -> arb:
        """Return in units of N a bound on what this derivative of x1 and x2 leaves out up to h."""
        return (self.rest * math.perm(self.order, order) * h ** (self.order - order)).upper()

    def row_off(self, which: int, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of a row leaves out up to h."""
        return self.flow.of_rows(lambda k: self.left_out(h, derivative + k))[which].upper()

    def state(self, t: arb) -> list[arb]:
        """Return the state at a time after the point."""
        h, bodies = t.abs_upper(), zip(((self.x, self.v), (self.y, self.w)), self.flow.norm.speeds, strict=True)
        return [widened(one(t), size * self.left_out(h, k)) for body, size in bodies for k, one in enumerate(body)]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        off, bodies = self.left_out(t.upper(), 2), zip((self.v, self.w), self.flow.norm.speeds, strict=True)
        return [one.derivative()(t).abs_upper() + size * off for one, size in bodies]


def _products(rows: list[list[arb]]) -> Callable[[Sequence[arb]], list[arb]]:
    """Return what multiplies a matrix by a vector."""
    found, columns = arb_mat(rows), len(rows[0])
    return lambda z: (found * arb_mat(columns, 1, z)).entries()


flow_of = lru_cache(maxsize=256)(Flow)
"""A flow, built once."""


def _terms(bits: int) -> int:
    """Return how many terms leave less than 2^-bits of exp(REACH)."""
    terms, size = 1, 0.0
    while size < bits:
        terms += 1
        size += math.log2(terms / REACH)
    return terms
