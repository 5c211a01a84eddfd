"""The motion after a knot by numerics/linear, enclosed: for balls as it is, for mpmath and double-double its middle."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import flint
import mpmath
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, exact_middle, precision
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.linear.system import V1, LinearMode, Motion, Row, W, matrix, value
from numerics.trajectory.comparison import as_ball

_SPARE_BITS = 24
_STATE = tuple(((place, Fraction(1)),) for place in range(4))


class Moving:
    """One motion: from a state (m, m/s) at a time of the run (s), in a mode."""

    def __init__(self, arithmetic: Arithmetic, mode: LinearMode, start: tuple[Number, Sequence[Number]]) -> None:
        """Keep where it begins; to be used in the arithmetic's context."""
        self.arithmetic, self.is_ball = arithmetic, arithmetic.name == "ball"
        self.bits = flint.ctx.prec if self.is_ball else mpmath.mp.prec + _SPARE_BITS
        with precision(self.bits):
            self.begin, self.state = as_ball(start[0]), [as_ball(one) for one in start[1]]
        self.mode, self.pair = mode, mode.pair

    def _numbers(self, found: Sequence[arb]) -> tuple[Number, ...]:
        return tuple(+one if self.is_ball else self.arithmetic.number(exact_middle(one)) for one in found)

    def _ball(self, tau: Number) -> arb:
        with precision(self.bits):
            return as_ball(tau)

    def _lost(self, tau: arb) -> int:
        """Return how many bits the squarings of a flow over tau may lose."""
        largest = max(abs(one) for row in self.mode.generator() for one in row)
        bits = largest.numerator.bit_length() - largest.denominator.bit_length() + 8
        upper = abs(tau).upper()
        if upper.is_zero() or not upper.is_finite():
            return 0
        mantissa, exponent = upper.man_exp()
        return max(0, 2 * (bits + int(mantissa).bit_length() + int(exponent)))

    def after(self, tau: Number) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) at tau (s) after the start; for balls at every point of tau."""
        since = self._ball(tau)
        with precision(self.bits + self._lost(since)):
            over = self.mode.motion(self.state, self.begin).over(since)
            x1, v1, x2, v2 = (over.range(row) for row in _STATE)
        x1, v1, x2, v2 = self._numbers((x1, v1, x2, v2))
        return x1, v1, x2, v2 if self.mode.side else v1

    def losses(self, tau: Number) -> tuple[Number, Number, Number]:
        """Return what friction (b int |v1 - v2|) and viscosity (a1 int v1^2) took and int u v1 up to tau (s), J.

        Enclosures for balls.
        """
        mode, since = self.mode, self._ball(tau)
        own, driven = bool(self.pair.a1), bool(mode.force)
        with precision(self.bits + self._lost(since)):
            motion = mode.motion(self.state, self.begin)
            friction = viscous = work = arb(0)
            over = motion.over(since)
            if mode.side and (mode.slope or mode.pull):
                friction = self._product(mode.friction, W, motion, since)
            elif mode.side:
                slid = [over.range(row) - value(row, motion.begin) for row in _STATE]
                friction = Ball.number(mode.side * mode.b) * (slid[0] - slid[2])
            if own:
                viscous = self._integral(motion.begin, since, [(V1, V1, self.pair.a1)])
                viscous += since.rad() * arb(0, 1) * Ball.number(self.pair.a1) * over.range(_STATE[V1]) ** 2
            if driven:
                work = self._product(mode.force, _STATE[V1], motion, since)
        friction, viscous, work = self._numbers((friction, viscous, work))
        return friction, viscous, work

    def _product(self, one: Row, two: Row, motion: Motion, tau: arb) -> arb:
        """Return int one two dt up to tau, of two rows; a ball of times adds what the product may be there."""
        form = [(p, q, f * g / 2) for place, f in one for other, g in two for p, q in ((place, other), (other, place))]
        over = motion.over(tau)
        return self._integral(motion.begin, tau, form) + tau.rad() * arb(0, 1) * over.range(one) * over.range(two)

    def _integral(self, z: arb_mat, tau: arb, form: list[tuple[int, int, Fraction]]) -> arb:
        """Return int_0^tau z' Q z dt up to the middle of tau, Q given by its entries.

        Van Loan's block exponential over a short interval, then doubled: exp(-A' t) alone would grow where z decays.
        """
        A, middle = self.mode.generator(), tau.mid()
        n, halvings = len(A), max(0, self._lost(tau) // 2)
        Q = [[Fraction(0)] * n for _ in range(n)]
        for p, q, factor in form:
            Q[p][q] += factor
        rows = [[*(-A[c][r] for c in range(n)), *Q[r]] for r in range(n)] + [[Fraction(0)] * n + row for row in A]
        E = (matrix(rows) * (middle / (arb(2) ** halvings))).exp()
        flow = arb_mat([[E[n + r, n + c] for c in range(n)] for r in range(n)])
        found = flow.transpose() * arb_mat([[E[r, n + c] for c in range(n)] for r in range(n)])
        for _ in range(halvings):
            found += flow.transpose() * found * flow
            flow = flow * flow
        return (z.transpose() * found * z)[0, 0]
