"""The flow of a mode, z' = A z, in balls: Taylor polynomials of rows, or exp(A t).

A row of z has the Taylor coefficients (row A^k/k!) z. The rows in front of z depend on the pair and on the layout of
the signals only; so they are built once and serve every start, amplitude and phase. What a polynomial leaves out is
bounded by what a derivative of z can become (LocalNorm.sizes). Everything that takes many steps of that length is left
to exp(A t), one sine at a time, since answers add up.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import accumulate, pairwise

from flint import arb, arb_mat, arb_poly, ctx

from numerics.arithmetic.ball import Ball, widened
from numerics.arithmetic.precision import precision
from numerics.linear.model import CONSTANT, V1, X1, X2, Cell, Layout
from numerics.linear.search import Polynomial
from numerics.linear.system import BallRow, LinearMode, LocalNorm, Row, Z, matrix, sparse
from numerics.scene import Pair

REACH = 2
"""A Taylor polynomial is used while the fastest rate turns through so many radians."""
BEND = -1
"""Stands in rows for v1'."""
FEW = 14
"""So many coefficients of a guard are scanned."""
_OF_SLIP = (1, ((0, 1), (1, -1))), (0, ((0, 1), (1, -1))), (0, ((2, 1),))
_OF_STICK = (0, ((1, 1),)), (0, ((2, 1),))
"""Of each guard, of which derivative of rows it is a sum: their indices and signs."""
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

    Guards are w = v1 - v2 in a slip, and where friction depends on the state x1 - x2 and F besides; b_static - Lambda
    and b_static + Lambda in stick. Its polynomials are those of `rows`: x1, x2 and F in a slip; x1 and both guards in
    stick, where body 2 goes with body 1.
    """

    def __init__(self, bits: int, pair: Pair, slips: bool, layout: Layout, cell: Cell | None = None) -> None:
        """Build the tables, with so many bits."""
        self.bits, self.slips, number = bits, slips, Ball.number
        self.mode = LinearMode.like(pair, int(slips), layout, cell or CONSTANT)
        self.norm = LocalNorm(self.mode)
        A = self.mode.generator()
        self.generator = [_in_balls(sparse(row)) for row in A]
        self.size, self.places = self.mode.size, list(self.mode.sine_places)
        self.turns = [self.generator[place][0][1] for place in self.places]
        self.fastest = self.norm.fastest.max(_SLOWEST)
        self.reach = (REACH / self.fastest).lower()
        self.load, self.edge, _, self.belt = (_in_balls(sparse(row)) for row in self.mode.rows.others)
        guarded = [*self.mode.guards, *((Z, self.mode.friction) if cell else ())]
        self.guarded = list(map(_in_balls, guarded))
        x1, x2 = [(X1, arb(1))], [(X2, arb(1))]
        self.rows = [x1, x2, *self.guarded[2:]] if slips else [x1, *self.guarded]
        self.guards = (_OF_SLIP if slips else _OF_STICK)[: len(guarded)]
        stiff = A[V1][X1]
        self.bent = []
        for row in map(dict, guarded):
            bend = row.get(X1, Fraction(0)) / stiff if stiff else Fraction(0)
            rest = [row.get(place, Fraction(0)) - bend * c for place, c in enumerate(A[V1])]
            self.bent.append([(place, number(c)) for place, c in (*sparse(rest), (BEND, bend)) if c])
        self._apart: dict[tuple[int, int], arb] = {}
        self.expand(max(_terms(bits + 8), FEW + 3))

    def expand(self, terms: int) -> None:
        """Form so many rows in front of z for each polynomial, and two more, which bound what it leaves out."""
        tables = [self.powers(row, terms + 2) for row in self.rows]
        self.terms, self.ends = terms, [0, *accumulate(map(len, tables))]
        self.matrix = arb_mat([row for table in tables for row in table])

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

    def apart(self, which: int, order: int) -> arb:
        """Return by how much this derivative of a guard can differ for motions of one mode whose N differs by 1."""
        if (which, order) not in self._apart:
            rows = self.powers(self.guarded[which], order + 1)
            self._apart[which, order] = self.norm.most(rows[order]) * math.factorial(order) if rows[order:] else arb(0)
        return self._apart[which, order]


class Expansion:
    """The motion from a point on up to h as Taylor polynomials of a flow's rows, all cut before the same order."""

    def __init__(self, flow: Flow, z: Sequence[arb], h: arb) -> None:
        """Form the polynomials, and of each a bound on what it leaves out up to h, over t^order."""
        self.flow, self.z, self.order = flow, z, flow.terms
        found = (flow.matrix * arb_mat(flow.size, 1, z)).entries()
        self.found = [found[start:end] for start, end in pairwise(flow.ends)]
        self.curves = [arb_poly(row[: self.order]) for row in self.found]
        sizes = self.sizes(self.order, h)
        self.rests = [_most(row, sizes) for row in flow.rows]

    def sizes(self, order: int, h: arb) -> list[arb]:
        """Return bounds on the derivative of this order of z over order!, from the point on for a time h."""
        flow, z, whole = self.flow, self.z, math.factorial(order)
        last = [(row[order:] + [arb(0)] * 2)[:2] for row in self.found[: 1 + flow.slips]]
        further = [one for x, v in (last[0], last[-1]) for one in (x, v * (order + 1))]
        for block in flow.norm.blocks:
            terms = z[block.start + order : block.stop]
            further += [one / whole for one in terms] + [arb(0)] * (len(block) - len(terms))
        for place, omega in zip(flow.places, flow.turns, strict=True):
            power = omega**order / whole
            further += [z[place] * power, z[place + 1] * power]
        return flow.norm.sizes(further, h)

    def guard(self, which: int, terms: int = 0) -> Polynomial:
        """Return a guard, which leaves out as much up to h; or so many of its terms, and of the rest nothing."""
        (derivative, parts), found, rest = self.flow.guards[which], arb_poly([]), arb(0)
        for row, sign in parts:
            found += sign * (arb_poly(self.found[row][: terms + derivative]) if terms else self.curves[row])
            rest += self.rests[row]
        if derivative:
            found, rest = found.derivative(), rest * self.order
        return Polynomial(found, rest.upper(), terms or self.order - derivative)

    def short(self, h: arb) -> list[Polynomial]:
        """Return FEW terms of each guard, and what they leave out up to h."""
        rests = [_most(row, sizes) for sizes in [self.sizes(FEW, h)] for row in self.flow.guarded]
        return [self.guard(which, FEW)._replace(rest=rest) for which, rest in enumerate(rests)]

    def left_out(self, row: int, t: arb, derivative: int) -> arb:
        """Return a bound on what this derivative of a row leaves out up to t."""
        n = self.order - derivative
        return (self.rests[row] * (math.perm(self.order, derivative) * t**n)).upper()

    def state(self, t: arb) -> list[arb]:
        """Return the state at a time after the point."""
        h, z = t.abs_upper(), self.z
        found = [
            widened(curve(t), self.left_out(body, h, n))
            for body, x in enumerate(self.curves[: 1 + self.flow.slips])
            for n, curve in enumerate((x, x.derivative()))
        ]
        return found if self.flow.slips else [*found, found[X1] + (z[X2] - z[X1]), found[V1]]

    def bends(self, t: arb) -> list[arb]:
        """Return bounds on |v1'| and |v2'| over a ball of times."""
        bodies, h = (0, int(self.flow.slips)), t.upper()
        return [
            self.curves[body].derivative().derivative()(t).abs_upper() + self.left_out(body, h, 2) for body in bodies
        ]


def _most(row: BallRow, sizes: Sequence[arb]) -> arb:
    """Return a bound on a row."""
    return sum((abs(c) * sizes[place] for place, c in row), arb(0)).upper()


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
