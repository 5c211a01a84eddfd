"""The flow of a mode, z' = A z, in balls: Taylor polynomials of rows, or exp(A t).

A row of z has the Taylor coefficients (row A^k/k!) z. The rows in front of z depend on the pair and on the layout of
the signals only; so they are built once and serve every start, amplitude and phase. What a polynomial leaves out is
bounded by what a derivative of z can become (LocalNorm.sizes). Everything that takes many steps of that length is left
to exp(A t), one sine at a time, since answers add up.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache

from flint import arb, arb_mat, arb_poly, ctx

from numerics.arithmetic.ball import Ball, widened
from numerics.arithmetic.precision import precision
from numerics.linear.model import DRIVEN, EDGE, FIRST, LOAD, V1, V2, X1, X2, Layout
from numerics.linear.system import CONSTANT, BallRow, Cell, LinearMode, LocalNorm, Z, matrix, sparse
from numerics.scene import Pair

REACH = 2
"""A Taylor polynomial is used while the fastest rate turns through so many radians."""
BEND = -1
"""Stands in rows for v1'."""
FEW = 14
"""The degree of the polynomials by which a guard is scanned."""
_SLOWEST = arb((1, -2_000))
"""The rate of what has none, 1/s."""


def exponential(generator: list[list[Fraction]], t: arb, z: list[arb]) -> list[arb]:
    """Return exp(A t) z; long times are formed with more bits, since errors double with each squaring."""
    size = Ball.number(max(sum(map(abs, row)) for row in generator)) * t.abs_upper()
    squarings = max(0, math.ceil(float(size.mid().log().mid()) / math.log(2))) if size > 1 else 0
    with precision(ctx.prec + 3 * squarings + 16):
        flow = (matrix(generator) * t).exp()
    return (flow * arb_mat(len(z), 1, z)).entries()


class Flow:
    """The flow of stick, or of slip + in one cell of friction, under signals of one layout.

    `rows` are those of which there are guards: b_static - Lambda and b_static + Lambda in stick, w = v1 - v2 in a slip,
    and where friction depends on the state x1 - x2 and F besides.
    """

    def __init__(self, bits: int, pair: Pair, slips: bool, layout: Layout, cell: Cell | None = None) -> None:
        """Build the tables, with so many bits."""
        self.bits, self.slips, number = bits, slips, Ball.number
        self.mode = LinearMode.like(pair, int(slips), layout, cell or CONSTANT)
        self.norm = LocalNorm(self.mode)
        self.generator = [[(j, number(c)) for j, c in sparse(row)] for row in self.mode.generator()]
        self.size, self.places = self.mode.size, list(self.mode.sine_places)
        self.turns = [self.generator[place][0][1] for place in self.places]
        self.rate, self.fastest = self.norm.rate, self.norm.fastest.max(_SLOWEST)
        self.reach = (REACH / self.fastest).lower()
        others = [[(place, number(c)) for place, c in sparse(row)] for row in self.mode.rows.others]
        self.load, self.edge, self.belt = others[LOAD], others[EDGE], others[DRIVEN]
        guarded = [*self.mode.guards, *((Z, self.mode.friction) if cell else ())]
        self.guarded = [[(place, number(c)) for place, c in row] for row in guarded]
        rates = self.mode.generator()[V1]
        stiff = rates[X1]
        self.bent = []
        for row in map(dict, guarded):
            bend = row.get(X1, Fraction(0)) / stiff if stiff else Fraction(0)
            rest = [row.get(place, Fraction(0)) - bend * c for place, c in enumerate(rates)]
            self.bent.append([(place, number(c)) for place, c in (*sparse(rest), (BEND, bend)) if c])
        self.expand(max(_terms(bits + 8), FEW + 3))

    def expand(self, terms: int) -> None:
        """Form so many rows in front of z for x1 and x2, and some for every row of which there are guards."""
        own = [self.powers(row, terms) for row in ([(X1, arb(1))], [(X2, arb(1))])[: 1 + self.slips]]
        self.terms, self.order = terms, max(len(one) for one in own)
        self.order -= self.order == terms  # the last one only bounds what is left out
        nothing = [arb(0)] * self.size
        self.own = [one + [nothing] * (terms + 1 - len(one)) for one in own]
        self.all_terms = [_products(one[: self.order]) for one in self.own]
        few = [self.powers(row, FEW + 2) for row in self.guarded]
        self.before_guards = [one + [nothing] * (FEW + 2 - len(one)) for one in few]
        self._guards = _products([row for one in self.before_guards for row in one])
        self._derivatives: dict[int, Callable[[Sequence[arb]], list[arb]]] = {}

    def powers(self, row: BallRow, terms: int) -> list[list[arb]]:
        """Return a row times A^k/k! for so many k, as long as that does not vanish."""
        at, zero, faded = dict(row), arb(0), 0.0
        found: list[list[arb]] = []
        while len(found) < terms and at:
            found.append([at.get(place, zero) for place in range(self.size)])
            after: dict[int, arb] = {}
            # what counts little within the reach needs few bits
            faded = max(0.0, faded + math.log2(len(found) / REACH)) if self.norm.fastest > 0 else 0.0
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
        sizes, whole = self.sizes(z, h, order), math.factorial(order)
        return [sum((abs(c) * sizes[place] for place, c in row), arb(0)) / whole for row in self.guarded]

    def sizes(self, z: Sequence[arb], h: arb, order: int) -> list[arb]:
        """Return bounds on the order-th derivative of z, order >= 1, from z on for a time h."""
        return self.norm.sizes(self.derivative(z, order), h)

    def derivative(self, z: Sequence[arb], order: int) -> list[arb]:
        """Return the order-th derivative of z; of sines and cosines something of its size."""
        if order not in self._derivatives:
            ends = (one[order : order + 2] for one in (self.own[0], self.own[-1]))
            self._derivatives[order] = _products([row for pair in ends for row in pair])
        whole = math.factorial(order)
        x1, v1, x2, v2 = self._derivatives[order](z)
        found = [x1 * whole, v1 * (whole * (order + 1)), x2 * whole, v2 * (whole * (order + 1))]
        for block in self.norm.blocks:
            found += ([*z[block.start : block.stop], *[arb(0)] * order])[order:][: len(block)]
        for place, omega in zip(self.places, self.turns, strict=True):
            power = omega**order
            found += [z[place] * power, z[place + 1] * power]
        return found

    def apart(self, which: int, order: int) -> arb:
        """Return by how much this derivative of a row can differ for motions of one mode whose N differs by 1."""
        before = self.before_guards[which] if order < FEW + 2 else self.powers(self.guarded[which], order + 1)
        return self.norm.most(before[order]) * math.factorial(order) if order < len(before) else arb(0)


class Expansion:
    """The motion from a point on up to h as Taylor polynomials, all cut before the same order."""

    def __init__(self, flow: Flow, z: Sequence[arb], h: arb) -> None:
        """Form the polynomials."""
        self.flow, self.z, self.order = flow, z, flow.order
        sizes = flow.sizes(z, h, self.order - 1)
        whole = math.factorial(self.order)
        self.rests = sizes[V1] / whole, sizes[V2] / whole
        x1, *others = (arb_poly(product(z)) for product in flow.all_terms)
        # in stick body 2 goes with body 1
        x2 = others[0] if others else x1 + (z[X2] - z[X1])
        v1 = x1.derivative()
        self.curves: dict[int, arb_poly] = {X1: x1, V1: v1, X2: x2, V2: x2.derivative() if others else v1}

    def curve(self, place: int) -> arb_poly:
        """Return the polynomial of what stands in z at a place."""
        if place not in self.curves:
            self._expand_signals()
        return self.curves[place]

    def _expand_signals(self) -> None:
        for block in self.flow.norm.blocks:
            for k in block:
                self.curves[k] = arb_poly([self.z[m] / math.factorial(m - k) for m in range(k, block.stop)])
        for k, omega in zip(self.flow.places, self.flow.turns, strict=True):
            sines, cosines = [self.z[k]], [self.z[k + 1]]
            for n in range(1, self.flow.terms):
                one, two = cosines[-1] * omega / n, sines[-1] * omega / -n
                sines.append(one)
                cosines.append(two)
            self.curves[k], self.curves[k + 1] = arb_poly(sines), arb_poly(cosines)

    def row(self, which: int) -> arb_poly:
        """Return a row of which there is a guard."""
        return sum((self.curve(place) * c for place, c in self.flow.guarded[which]), arb_poly([]))

    def left_out(self, place: int, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of what stands at a place leaves out up to h."""
        if place in {V1, V2}:
            return self.left_out(place - 1, h, derivative + 1)
        flow, rest, order = self.flow, arb(0), self.order
        if place < FIRST:
            rest = self.rests[place == X2]
        elif place >= flow.mode.sine_places.start:
            pair = (place - flow.mode.sine_places.start) // 2
            first, omega = flow.places[pair], flow.turns[pair]
            order = flow.terms
            rest = (abs(self.z[first]) + abs(self.z[first + 1])) * omega**order / math.factorial(order)
        return (rest * math.perm(order, derivative) * h ** (order - derivative)).upper()

    def row_off(self, which: int, h: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of a row leaves out up to h."""
        return sum((abs(c) * self.left_out(k, h, derivative) for k, c in self.flow.guarded[which]), arb(0)).upper()

    def state(self, t: arb) -> list[arb]:
        """Return the state at a time after the point."""
        h = t.abs_upper()
        return [widened(self.curves[k](t), self.left_out(k, h, 0)) for k in (X1, V1, X2, V2)]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        h = t.upper()
        return [self.curves[k].derivative()(t).abs_upper() + self.left_out(k, h, 1) for k in (V1, V2)]


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
