"""The flow of a mode, z' = A z, in balls: Taylor polynomials of rows.

A row of z has the Taylor coefficients (row A^k/k!) z. The rows in front of z depend on the pair and on the layout of
the signals only; so they are built once and serve every start, amplitude and phase. What a polynomial leaves out is
bounded by what a derivative of z can become (LocalNorm.sizes). Longer times are left to exp(A t).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from flint import arb, arb_mat, arb_poly

from numerics.arithmetic.ball import Ball, widened
from numerics.arithmetic.precision import precision
from numerics.linear.model import CONSTANT, V1, X1, X2, Cell, Layout
from numerics.linear.system import LinearMode, LocalNorm, Motion, Row, Z, matrix, sparse
from numerics.scene import Pair

REACH = 2
"""A Taylor polynomial is used while the fastest rate turns through so many radians."""
BEND = -1
"""Stands in rows for v1'."""
FEW = 14
"""So many coefficients of a guard are scanned."""
_SLOWEST = arb((1, -2_000))
"""The rate of what has none, 1/s."""


class Curve(NamedTuple):
    """A function of time by a polynomial of so many terms, which leaves out `rest` t^terms at most.

    A guard is positive in a mode; its derivative of an `order`, of which all lower ones vanish at 0, is off by `margin`
    from that of the true motion. `row` says of which row it is, `kind` what it means (cells.py).
    """

    polynomial: arb_poly
    rest: arb
    terms: int
    margin: arb = arb(0)
    order: int = 0
    row: int = 0
    kind: int = 0

    def left_out(self, t: arb, order: int) -> arb:
        """Return a bound on what a derivative leaves out up to t."""
        return self.rest * (t ** (self.terms - order) * math.perm(self.terms, order))

    def derived(self, order: int) -> arb_poly:
        """Return a derivative of the polynomial."""
        found = self.polynomial
        for _ in range(order):
            found = found.derivative()
        return found

    def at(self, t: arb, order: int = 0) -> arb:
        """Return an enclosure of a derivative over a ball of times."""
        return widened(self.derived(order)(t), self.left_out(t.abs_upper(), order))


class Flow:
    """The flow of stick, or of slip + in one cell of friction, under signals of one layout.

    Guards are w = v1 - v2 in a slip, and where friction depends on the state x1 - x2 and F besides; b_static - Lambda
    and b_static + Lambda in stick.
    """

    def __init__(self, bits: int, pair: Pair, slips: bool, layout: Layout, cell: Cell | None = None) -> None:
        """Build the tables, with so many bits."""
        self.bits, self.slips, number = bits, slips, Ball.number
        self.mode = LinearMode.like(pair, int(slips), layout, cell or CONSTANT)
        self.norm = LocalNorm(self.mode)
        A = self.mode.generator()
        self.A, self.generator = matrix(A), [_in_balls(sparse(row)) for row in A]
        self.size, self.places = self.mode.size, list(self.mode.sine_places)
        self.turns = [self.generator[place][0][1] for place in self.places]
        self.fastest = self.norm.fastest.max(_SLOWEST)
        self.reach = (REACH / self.fastest).lower()
        self.load, self.edge, _, self.belt = (_in_balls(sparse(row)) for row in self.mode.rows.others)
        guarded = [*self.mode.guards, *((Z, self.mode.friction) if cell else ())]
        self.guarded = list(map(_in_balls, guarded))
        stiff = A[V1][X1]
        self.bent = []
        for row in map(dict, guarded):
            bend = row.get(X1, Fraction(0)) / stiff if stiff else Fraction(0)
            rest = [row.get(place, Fraction(0)) - bend * c for place, c in enumerate(A[V1])]
            self.bent.append([(place, number(c)) for place, c in (*sparse(rest), (BEND, bend)) if c])
        self.bodies = (X1, X2) if slips else (X1,)
        """The places of the bodies: in stick x2 goes with x1."""
        self.expand(max(_terms(bits + 8), FEW + 3, self.size))

    def column(self, z: Sequence[arb]) -> arb_mat:
        """Return z as a matrix."""
        return arb_mat(self.size, 1, z)

    def expand(self, terms: int) -> None:
        """Form so many rows in front of z, A^k/k! behind each row, and two more, which bound what is left out."""
        rows = [dict(row) for row in (*([(place, arb(1))] for place in self.bodies), *self.guarded)]
        powers, faded = [arb_mat([[row.get(k, arb(0)) for k in range(self.size)] for row in rows])], 0.0
        for k in range(1, terms + 2):
            # what counts little within the reach needs few bits
            faded = max(0.0, faded + math.log2(k / REACH)) if self.norm.fastest > 0 else 0.0
            with precision(max(64, self.bits + 16 - int(faded))):
                powers.append(powers[-1] * self.A / k)
        tables = list(zip(*(one.tolist() for one in powers), strict=True))
        self.terms, self.matrix = terms, arb_mat([row for table in tables for row in table])
        self.apart = [
            [self.norm.most(row) * math.factorial(k) for k, row in enumerate(table[: self.size + 2])]
            for table in tables[len(self.bodies) :]
        ]
        """By how much each derivative of each guard can differ for motions of one mode whose N differs by 1."""


class Expansion:
    """The motion from a point on up to h as Taylor polynomials of a flow's rows, all cut before the same order."""

    def __init__(self, flow: Flow, z: Sequence[arb], h: arb) -> None:
        """Form the polynomials, and of each a bound on what it leaves out up to h, over t^order."""
        self.flow, self.z, self.order, count = flow, z, flow.terms, flow.terms + 2
        found = (flow.matrix * flow.column(z)).entries()
        self.found = [found[start : start + count] for start in range(0, len(found), count)]
        self.rests = self.sizes(self.order, h)
        self.bodies = [
            Curve(arb_poly(row[: self.order]), self.rests[place], self.order)
            for place, row in zip(flow.bodies, self.found, strict=False)
        ]

    def sizes(self, order: int, h: arb) -> list[arb]:
        """Return bounds on the derivative of this order of z over order!, from the point on for a time h."""
        flow, z, whole = self.flow, self.z, math.factorial(order)
        further = [
            one for x in (self.found[0], self.found[flow.slips]) for one in (x[order], x[order + 1] * (order + 1))
        ]
        for block in flow.norm.blocks:
            terms = z[block.start + order : block.stop]
            further += [one / whole for one in terms] + [arb(0)] * (len(block) - len(terms))
        for place, omega in zip(flow.places, flow.turns, strict=True):
            power = omega**order / whole
            further += [z[place] * power, z[place + 1] * power]
        return flow.norm.sizes(further, h)

    def guards(self, h: arb | None = None) -> list[Curve]:
        """Return the guards; with h only FEW terms of each, and what they leave out up to then."""
        order, sizes = (self.order, self.rests) if h is None else (FEW, self.sizes(FEW, h))
        rests = [sum((abs(c) * sizes[place] for place, c in row), arb(0)).upper() for row in self.flow.guarded]
        return [
            Curve(arb_poly(row[:order]), rest, order, row=k)
            for k, (row, rest) in enumerate(zip(self.found[len(self.bodies) :], rests, strict=True))
        ]

    def state(self, t: arb) -> list[arb]:
        """Return the state at a time after the point; after many radians by exp(A t)."""
        flow, z = self.flow, self.z
        if flow.fastest * t.abs_upper() > 1.01 * REACH:
            found = list(Motion(flow.mode, flow.A, flow.column(z)).state(t))
        else:
            found = [x.at(t, order) for x in self.bodies for order in (0, 1)]
        # stick keeps the bodies together, to more digits than what does not know it
        return found if flow.slips else [*found[:X2], found[X1] + (z[X2] - z[X1]), found[V1]]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        return [self.bodies[k].at(t, 2).abs_upper() for k in (0, -1)]


def _in_balls(row: Row) -> list[tuple[int, arb]]:
    return [(place, Ball.number(c)) for place, c in row]


flow_of = lru_cache(maxsize=256)(Flow)
"""A flow, built once."""


def _terms(bits: int) -> int:
    """Return how many terms leave less than 2^-bits of exp(REACH)."""
    terms, size = 1, 0.0
    while size < bits:
        terms += 1
        size += math.log2(terms / REACH)
    return terms
