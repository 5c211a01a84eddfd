"""The flow of a mode, z' = A z, in balls: Taylor polynomials of rows of z, and exp(A t).

The Taylor coefficients of z are A^k z/k!. What a polynomial leaves out is bounded by what a derivative of z can become
(LocalNorm.sizes). Longer times are left to exp(A t), and a ball of them to the polynomial from its lower end on.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from flint import arb, arb_mat, arb_poly, ctx

from numerics.arithmetic.ball import Ball, widened
from numerics.arithmetic.precision import cached_property, precision
from numerics.linear.model import CONSTANT, FIRST, V1, X1, X2, Cell, Layout
from numerics.linear.system import BallRow, LinearMode, LocalNorm, Row, Z, dot, in_balls, matrix, sparse
from numerics.scene import Pair

REACH = 2
"""A Taylor polynomial is used while the fastest rate turns through so many radians."""
BEND = -1
"""Stands in rows for v1'."""
FEW = 14
"""So many coefficients of a guard are scanned."""
_FURTHER = 4
"""Further terms of Taylor over a short ball of times."""
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

    def __init__(
        self, bits: int, pair: Pair, slips: bool, layout: Layout, cell: Cell | None = None, terms: int = 0
    ) -> None:
        """Build the tables, with so many bits, and as many terms as these need if nothing else is said."""
        self.bits, self.slips, number = bits, slips, Ball.number
        self.mode = LinearMode.like(pair, int(slips), layout, cell or CONSTANT)
        self.norm, A, size = LocalNorm(self.mode), self.mode.generator(), self.mode.size
        self.A, self.generator = matrix(A), [in_balls(sparse(row)) for row in A]
        self.fastest = self.norm.fastest.max(_SLOWEST)
        self.reach = (REACH / self.fastest).lower()
        self.load, self.edge, _, self.belt = (in_balls(sparse(row)) for row in self.mode.rows.others)
        guarded = [*self.mode.guards, *((Z, self.mode.friction) if cell else ())]
        self.bodies = 1 + slips
        """Of which x is followed: in stick x2 goes with x1."""
        followed = [((x, Fraction(1)),) for x in (X1, X2)][: self.bodies]
        self.rows, stiff = [in_balls(row) for row in (*followed, *guarded)], A[V1][X1]
        self.guarded = self.rows[self.bodies :]
        self.bent = []
        for row in map(dict, guarded):
            bend = row.get(X1, Fraction(0)) / stiff if stiff else Fraction(0)
            rest = [row.get(place, Fraction(0)) - bend * c for place, c in enumerate(A[V1])]
            self.bent.append([(place, number(c)) for place, c in (*sparse(rest), (BEND, bend)) if c])
        self.expand(terms or max(_terms(bits + 8), FEW + 3, size))

    def expand(self, terms: int) -> None:
        """Form so many rows in front of z, A^k/k! behind each row, and those that bound what is left out."""
        dense = [[dict(row).get(k, arb(0)) for k in range(self.mode.size)] for row in self.rows]
        behind, faded = [arb_mat(dense)], 0.0
        for k in range(1, terms):
            # what counts little within the reach needs few bits
            faded = max(0.0, faded + math.log2(k / REACH)) if self.norm.fastest > 0 else 0.0
            with precision(max(64, self.bits + 16 - int(faded))):
                behind.append(behind[-1] * self.A / k)
        with precision(64):
            self.ahead = {k: self.A**k / math.factorial(k) for k in (FEW, terms)}
        tables = list(zip(*(one.tolist() for one in behind), strict=True))
        self.terms, self.matrix = terms, arb_mat([row for table in tables for row in table])
        self.apart = [
            [self.norm.most(row) * math.factorial(k) for k, row in enumerate(table[: self.mode.size + 2])]
            for table in tables[self.bodies :]
        ]
        """By how much each derivative of each guard can differ for motions of one mode whose N differs by 1."""

    def over(self, t: arb) -> arb_mat:
        """Return exp(A t); long times are formed with more bits, since errors double with each squaring."""
        with precision(ctx.prec + 3 * self.mode.squarings(t) + 16):
            return (matrix(self.mode.generator()) * t).exp()


class Motion:
    """z(t) = exp(A t) z(0), t (s) from the start of the motion; everything enclosed."""

    def __init__(self, flow: Flow, z: Sequence[arb]) -> None:
        """Keep where it begins; the present precision is that of its polynomials."""
        self.flow, self.z, self.bits, self.column = flow, z, ctx.prec, arb_mat(flow.mode.size, 1, z)

    @cached_property
    def coefficients(self) -> list[list[arb]]:
        """Return those of x1, x2 and the guards."""
        with precision(self.bits):
            found, terms = (self.flow.matrix * self.column).entries(), self.flow.terms
        return [found[first : first + terms] for first in range(0, len(found), terms)]

    def curves(self, terms: int, h: arb) -> list[Curve]:
        """Return x1, x2 and the guards as polynomials of so many terms, and what they leave out up to h."""
        flow = self.flow
        sizes = flow.norm.sizes((flow.ahead[terms] * self.column).entries(), h)
        return [
            _curve(row[:terms], own, sizes, k)
            for k, (row, own) in enumerate(zip(self.coefficients, flow.rows, strict=True), -flow.bodies)
        ]

    @cached_property
    def whole(self) -> list[Curve]:
        """Return the polynomials of all terms, up to twice the reach."""
        with precision(self.bits):
            return self.curves(self.flow.terms, 2 * self.flow.reach)

    def guards(self, h: arb | None = None) -> list[Curve]:
        """Return the guards; with h only FEW terms of each, and what they leave out up to then."""
        return (self.whole if h is None else self.curves(FEW, h))[self.flow.bodies :]

    def at(self, t: arb) -> arb_mat:
        """Return z(t)."""
        return self.flow.over(t) * self.column

    def state(self, t: arb) -> list[arb]:
        """Return (x1, v1, x2, v2) at a time after the start; after many radians by exp(A t)."""
        flow, z = self.flow, self.z
        if flow.fastest * t.abs_upper() > 1.01 * REACH:
            found = self.at(t).entries()[:FIRST]
        else:
            found = [x.at(t, order) for x in self.whole[: flow.bodies] for order in (0, 1)]
        # stick keeps the bodies together, to more digits than what does not know it
        return found if flow.slips else [*found[:X2], found[X1] + (z[X2] - z[X1]), found[V1]]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        return [self.whole[k].at(t, 2).abs_upper() for k in (0, self.flow.bodies - 1)]

    def ranges(self, rows: Sequence[Row], t: arb, *orders: int) -> list[list[arb]]:
        """Return enclosures of rows over a ball of times, of each of these derivatives."""
        begin = t.lower()
        derivatives, h, found, given = [self.at(begin)], t - begin, list[list[arb]](), [in_balls(row) for row in rows]
        # further terms are sharp on a short ball, the bound by energy on a long one
        further = 2 + _FURTHER if self.flow.fastest * h < 1 else 2
        for k in range(1, max(orders) + further + 1):
            derivatives.append(self.flow.A * derivatives[-1] / k)
        for order in orders:
            *begun, last = (one.entries() for one in derivatives[: order + further + 1])
            sizes = self.flow.norm.sizes(last, h.abs_upper())
            found.append([_curve([dot(row, z) for z in begun], row, sizes).at(h, order) for row in given])
        return found


def _curve(coefficients: list[arb], row: BallRow, sizes: Sequence[arb], place: int = 0) -> Curve:
    """Return a row as a polynomial, from bounds on what follows in z."""
    rest = sum((abs(c) * sizes[k] for k, c in row), arb(0)).upper()
    return Curve(arb_poly(coefficients), rest, len(coefficients), row=place)


def motion_in(mode: LinearMode, state: Sequence[arb], t: arb) -> Motion:
    """Return the motion, for `at` and `ranges`, that starts in a mode at time t (s) with the state (x1, v1, x2, v2)."""
    return Motion(_short_flow_of(ctx.prec, mode.pair, bool(mode.side), mode.layout, mode.cell, 1), mode.begin(state, t))


flow_of, _short_flow_of = (lru_cache(maxsize=most)(Flow) for most in (256, 4096))
"""A flow, built once; those of one term take little room, and many precisions need them."""


def _terms(bits: int) -> int:
    """Return how many terms leave less than 2^-bits of exp(REACH)."""
    terms, size = 1, 0.0
    while size < bits:
        terms += 1
        size += math.log2(terms / REACH)
    return terms
