"""The motion after a knot, z' = A z: enclosed, one by one, or in binary64 for thousands of knots and times at once.

What the ledger needs are integrals of quadratic forms of z, over a short interval, and then doubled. In binary64 a time
is a sum of intervals h 2^k, by its binary digits, and of a rest; over h the fastest rate turns through 1/2. The flow
over every such interval comes from balls and is rounded once, what happens within h is Taylor's; approximate, without a
bound. In every other arithmetic a motion is that of LinearMode, for balls as it is, for mpmath its midpoint.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import chain

import flint
import mpmath
import numpy as np
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, as_float, exact_middle, magnitude_bits
from numerics.arithmetic.precision import precision
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.linear.model import FIRST, FRICTION, V1, X1, X2, Layout
from numerics.linear.system import LinearMode, LocalNorm, Motion, Row, W, matrix, value
from numerics.scene import Pair
from numerics.trajectory.columns import Floats
from numerics.trajectory.comparison import as_ball

_TERMS = 14
"""Terms of Taylor while a rate turns through 1/2: the next one is below 2^-53 of their size."""
_SPARE_BITS = 24
_BITS_PER_DOUBLING = 5
"""What a flow may lose each time that it is squared."""
_KEPT, _DOUBLINGS = 32, 6
_STATE = tuple(((place, Fraction(1)),) for place in range(4))
_PRODUCTS = 1.0 / np.add.outer(np.arange(_TERMS + 1), np.arange(1, _TERMS + 2))
"""int_0^1 s^i s^j ds."""

Begun = tuple[Floats, Floats]
"""Where n motions in one mode begin: the times in its piece (s), and x1, v1, x2, v2, shape (4, n)."""


def _products(mode: LinearMode) -> dict[int, tuple[Row, Row]]:
    """Return the rows of z whose products over time are lost to friction (0), to viscosity (1), or put in (2), W.

    Only those that act; friction that is one number b takes |b| times what is slid, no product.
    """
    a1, v1 = mode.pair.a1, _STATE[V1]
    acts = any(mode.cell), bool(a1), bool(mode.force)
    products = (mode.friction, W), (((V1, a1),), v1), (mode.force, v1)
    return {k: one for k, one in enumerate(products) if acts[k]}


def _form(size: int, one: Row, two: Row) -> arb_mat:
    """Return Q with z' Q z = one two."""
    Q = arb_mat(size, size)
    for place, f in one:
        for other, g in two:
            half = Ball.number(f * g / 2)
            Q[place, other] += half
            Q[other, place] += half
    return Q


def _van_loan(A: arb_mat, tau: arb, Q: arb_mat) -> tuple[arb_mat, arb_mat]:
    """Return exp(A tau) and int_0^tau exp(A' s) Q exp(A s) ds, for a short time: exp(-A' tau) grows where z decays."""
    n, adjoint, nothing = A.nrows(), (-A.transpose()).tolist(), [arb(0)] * A.nrows()
    above = [[*one, *two] for one, two in zip(adjoint, Q.tolist(), strict=True)]
    block = (arb_mat([*above, *([*nothing, *one] for one in A.tolist())]) * tau).exp().tolist()
    flow = arb_mat([row[n:] for row in block[n:]])
    return flow, flow.transpose() * arb_mat([row[n:] for row in block[:n]])


def _halvings(A: list[list[Fraction]], tau: arb) -> int:
    """Return how often a time must be halved for the flow over it to be a small matrix."""
    largest, upper = max(abs(one) for row in A for one in row), abs(tau).upper()
    bits = largest.numerator.bit_length() - largest.denominator.bit_length() + 7
    return max(0, bits + magnitude_bits(upper)) if upper > 0 and upper.is_finite() else 0


class Steps:
    """Flows of stick, or of slip, in binary64 over times below 2^top s, under one kind of force.

    A kind is a layout of the signals; `cell` is slope and pull of friction that depends on the state. z is that of
    LinearMode, in units (powers of 2) in which all rates are alike and no power of a time leaves the range.
    """

    def __init__(
        self,
        pair: Pair,
        slips: bool,
        layout: Layout,
        cell: tuple[Fraction, Fraction],
        top: int,
        integrals: bool,
    ) -> None:
        """Form them: as answers add up, flows with one sine at a time."""
        mode = LinearMode.like(pair, int(slips), layout, cell)
        own = LocalNorm(mode).rate
        fastest = own + Ball.number(max(chain(*layout.omegas), default=Fraction(0)))
        shortest, rate = min(top, -1 - magnitude_bits(fastest.upper())), magnitude_bits(own.upper())
        push = -rate - magnitude_bits(Ball.number(mode.mass).mid())
        orders = [*chain(*map(range, layout.terms)), *[0] * len(mode.sine_places) * 2]
        self.scale = np.array([[rate], [0], [rate], [0], *([push + top * order] for order in orders)])
        units = [Fraction(2) ** int(one) for one in self.scale.ravel()]
        generator = [
            [one * to / of if one else one for one, of in zip(row, units, strict=True)]
            for row, to in zip(mode.generator(), units, strict=True)
        ]
        step, doublings, size = arb(2) ** shortest, top - shortest, mode.size
        self.h, self.longer = np.ldexp(1.0, shortest), np.zeros((doublings, size, size))
        unit = Fraction(2) ** shortest
        self.taylor = np.array([[float(one * unit) if one else 0.0 for one in row] for row in generator])
        alone = [*range(mode.sine_places.start)]
        largest = max(0, int(np.frexp(np.abs(self.taylor).max())[1]))
        with precision(144 + _BITS_PER_DOUBLING * doublings + 2 * largest):
            for sine in [[place, place + 1] for place in mode.sine_places] or [[]]:
                kept = alone + sine
                flow = (matrix([[generator[k][n] for n in kept] for k in kept]) * step).exp()
                for found in self.longer:
                    found[np.ix_(kept, kept)] = np.reshape([*map(as_float, (flow - 1).entries())], (len(kept), -1))
                    flow = flow * flow
        self.products = _products(mode) if integrals else {}
        self.rows = np.zeros((2 * len(self.products), size))
        for row, one in zip(self.rows, chain(*self.products.values()), strict=True):
            row[[place for place, _ in one]] = [float(factor / units[place]) for place, factor in one]
        self.sums = [*self._sums()] if integrals else [np.empty(0)] * doublings

    def _sums(self) -> Iterator[Floats]:
        """Yield the quadratic forms that products add up to over h, 2 h, 4 h, ..."""
        terms = [self.rows]
        for k in range(1, _TERMS + 1):
            terms.append(terms[-1] @ self.taylor / k)
        along = np.array(terms).transpose(1, 0, 2)
        sums = self.h * along[::2].swapaxes(1, 2) @ _PRODUCTS @ along[1::2]
        for less_one in self.longer:
            yield sums
            flow = less_one + np.eye(len(less_one))
            sums = sums + flow.T @ sums @ flow

    def over(self, z: Floats, tau: Floats) -> tuple[Floats, Floats]:
        """Return by how much z changes within tau (s), and what friction, viscosity and force take and give, (3, n)."""
        z, rest = np.ldexp(z, self.scale), np.fmod(tau, self.h)
        changed, taken, term, along = np.zeros_like(z), np.zeros((3, len(tau))), z, [self.rows @ z]
        for k in range(1, _TERMS + 1):
            term = (self.taylor @ term) * (rest / self.h / k)
            changed += term
            along.append(self.rows @ term)
        for place, one, two in zip(self.products, *(np.swapaxes(along, 0, 1)[k::2] for k in (0, 1)), strict=True):
            taken[place] = rest * np.einsum("in,ij,jn->n", one, _PRODUCTS, two)
        for k, (less_one, sums) in enumerate(zip(self.longer, self.sums, strict=True)):
            on = np.fmod(tau, np.ldexp(self.h, k + 1)) >= np.ldexp(self.h, k)
            now = z[:, on] + changed[:, on]
            for place, one in zip(self.products, sums, strict=True):
                taken[place, on] += np.einsum("in,in->n", now, one @ now)
            changed[:, on] += less_one @ now
        return np.ldexp(changed, -self.scale), taken


_steps = lru_cache(_KEPT)(Steps)


def changes(mode: LinearMode, at: Begun, tau: Floats, integrals: bool) -> Floats:
    """Return by how much x1, v1, x2, v2 change within tau (s), and the force after it, N, in binary64, shape (8, n).

    Between them b int |v1 - v2|, and where `integrals` a1 int v1^2 and int u v1, J.
    """
    piece, (local, y), held = mode.piece, at, mode.side * float(mode.b)
    top = int(np.frexp(tau.max(initial=0.0))[1])
    z = np.zeros((mode.size, len(tau)))
    z[:FIRST] = y
    for which, (signal, (first, terms, sines, _)) in enumerate(zip(piece.signals, mode.layout.blocks, strict=True)):
        sign = mode.side or 1 if which == FRICTION else 1
        coefficients = sign * np.array([float(one) for one in signal.polynomial])
        for place in range(first, first + terms):
            z[place] = np.polynomial.polynomial.polyval(local, coefficients)
            coefficients = np.polynomial.polynomial.polyder(coefficients)
        for place, sine in zip(range(sines, mode.size, 2), signal.sines, strict=False):
            phase = float(sine.omega) * local + float(sine.omega * piece.start + sine.phase)
            z[place : place + 2] = sign * float(sine.amplitude) * np.array([np.sin(phase), np.cos(phase)])
    steps = _steps(mode.pair, bool(mode.side), mode.layout, mode.cell, top, integrals)
    changed, taken = steps.over(z, tau)
    if not mode.side:
        changed[X2:FIRST] = changed[X1:X2]
    if 0 not in steps.products:
        taken[0] = held * (changed[X1] - changed[X2])
    force = (z + changed)[[place for place, _ in mode.force]].sum(axis=0)
    return np.vstack([changed[:FIRST], taken, force])


class Moving:
    """One motion, enclosed: from a state (m, m/s) at a time of the run (s), in a mode."""

    def __init__(self, arithmetic: Arithmetic, mode: LinearMode, state: Sequence[Number], begin: Number) -> None:
        """Keep where it begins; to be used in the arithmetic's context."""
        self.arithmetic, self.mode, self.is_ball = arithmetic, mode, arithmetic.name == "ball"
        self.generator = mode.generator()
        self.bits = flint.ctx.prec if self.is_ball else mpmath.mp.prec + _SPARE_BITS
        with precision(self.bits):
            self.start = [as_ball(one) for one in state], as_ball(begin)

    def after(self, tau: Number) -> tuple[Number, ...]:
        """Return (x1, v1, x2, v2) at tau (s) after the start; for balls at every point of tau."""
        return self._enclosed(self._state, tau)

    def losses(self, tau: Number) -> tuple[Number, ...]:
        """Return what friction (b int |v1 - v2|) and viscosity (a1 int v1^2) took and int u v1 up to tau (s), J.

        Enclosures for balls.
        """
        return self._enclosed(self._taken, tau)

    def _enclosed(self, function: Callable[[Motion, arb], Sequence[arb]], tau: Number) -> tuple[Number, ...]:
        """Return a function of the motion and of a time after its start, with the bits that squarings may lose.

        Powers of the time lose more, as k! in the derivatives of a force of high degree: bits are doubled until what is
        left is a rounding, or half of the bits of balls, or more bits are of no help.
        """
        with precision(self.bits):
            since = as_ball(tau)
        bits, before = self.bits + 2 * _halvings(self.generator, since), arb("inf")
        for _ in range(_DOUBLINGS):
            with precision(bits):
                found = function(self.mode.motion(*self.start), since)
                off, size = max(one.rad() for one in found), self._size(found)
                if off * 2 > before or off <= size * arb(2) ** -(self.bits // 2 if self.is_ball else mpmath.mp.prec):
                    break
            bits, before = 2 * bits, off
        return tuple(+one if self.is_ball else self.arithmetic.number(exact_middle(one)) for one in found)

    def _size(self, found: Sequence[arb]) -> arb:
        """Return how large the numbers are that are found, or those of the start."""
        return max(abs(one.mid()) for one in (*found, *self.start[0]))

    def _state(self, motion: Motion, tau: arb) -> Sequence[arb]:
        over = motion.over(tau)
        x1, v1, x2, v2 = (over.range(row) for row in _STATE)
        return x1, v1, x2, v2 if self.mode.side else v1

    def _taken(self, motion: Motion, tau: arb) -> Sequence[arb]:
        """Return the integrals; a ball of times adds what a product may be there."""
        mode, over, found = self.mode, motion.over(tau), [arb(0), arb(0), arb(0)]
        products, halvings = _products(mode), _halvings(self.generator, tau)
        short = tau.mid() / arb(2) ** halvings
        for place, (one, two) in products.items():
            flow, total = _van_loan(motion.matrix, short, _form(mode.size, one, two))
            for _ in range(halvings):
                total += flow.transpose() * total * flow
                flow = flow * flow
            middle = (motion.begin.transpose() * total * motion.begin)[0, 0]
            found[place] = middle + tau.rad() * arb(0, 1) * over.range(one) * over.range(two)
        if 0 not in products:
            slid = [over.range(row) - value(row, motion.begin) for row in (_STATE[X1], _STATE[X2])]
            found[0] = Ball.number(mode.side * mode.b) * (slid[0] - slid[1])
        return found
