"""The motion after a knot: in binary64 for thousands of knots and times at once, else one by one, enclosed.

In binary64 a body on its spring and what drives it form z' = J z, z = (omega x1, v1 + slow x1, drive), omega =
sqrt(a2/m). With the slow rate of the oscillator split off J is triangular where it is overdamped: a slow rate keeps its
digits beside a fast one.
Body 2 has a constant acceleration in slip, and moves with body 1 in stick; where friction depends on the state it is
part of z: approximate, without a bound. In every other arithmetic it is the flow of LinearMode, for balls as it is, for
mpmath and double-double its middle.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction

import flint
import mpmath
import numpy as np
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, exact_middle, precision
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.linear.system import FIRST, V1, LinearMode, Motion, Row, W, matrix, value
from numerics.trajectory.columns import Counts, Floats
from numerics.trajectory.comparison import as_ball

_TERMS = 14
"""Terms of Taylor for matrices of norm 1/2: the next one is below 2^-53 of their size."""
_SPARE_BITS = 24
_STATE = tuple(((place, Fraction(1)),) for place in range(4))

Begun = tuple[Floats, Floats]
"""Where n motions in one mode begin: the times in its piece (s), and x1, v1, x2, v2, shape (4, n)."""


class _Numbers:
    """The numbers of a mode: rates of body 1 (1/s) with the mass (kg) that the spring moves, friction over z."""

    def __init__(self, mode: LinearMode) -> None:
        """Convert them."""
        self.mass, self.m2, self.a1 = float(mode.mass), float(mode.pair.m2), float(mode.pair.a1)
        self.held = mode.side * float(mode.b)
        self.omega, half = math.sqrt(float(mode.pair.a2) / self.mass), self.a1 / self.mass / 2
        self.slow, self.fast, self.coupling = 0.0, 2 * half, self.omega
        if half > self.omega:
            self.fast = half + math.sqrt((half - self.omega) * (half + self.omega))
            self.slow, self.coupling = self.omega / self.fast * self.omega, 0.0
        self.reach = self.omega + self.fast
        slope, pull = float(mode.slope), float(mode.pull)
        self.bodies = 4 if mode.slope or mode.pull else 2
        self.v1 = np.array([-self.slow / self.omega, 1.0, 0.0, 0.0])
        self.w = self.v1 - [0.0, 0.0, 0.0, 1.0]
        self.friction = slope * self.w + np.array([pull, 0.0, -pull, 0.0]) / self.omega
        """Without its constant."""


def _system(mode: LinearMode, at: Begun, tau: Floats, own: bool, chosen: slice) -> tuple[Floats, Floats]:
    """Return J tau (n, k, k) and z (n, k): the bodies with b and the polynomial, or at rest; and some of the sines."""
    of, piece, (local, y) = _Numbers(mode), mode.piece, at
    terms, sines = (piece.polynomial if own else ()), piece.sines[chosen]
    constant, first = of.bodies, of.bodies + 1
    size = first + len(terms) + 2 * len(sines)
    A, z = np.zeros((size, size)), np.zeros((len(tau), size))
    A[0, :2], A[1, :2] = (-of.slow, of.omega), (-of.coupling, -of.fast)
    A[1, constant] = -of.reach
    if terms:
        A[1, first] = of.reach
    if of.bodies == 4:
        A[1, :4] -= of.friction / of.mass
        A[2, 3], A[3, :4], A[3, constant] = of.omega, of.friction / of.m2, of.reach * of.mass / of.m2
    unit = 1.0 / (of.mass * of.reach)
    if own:
        x1, v1, x2, v2 = y
        bodies = of.omega * x1, v1 + of.slow * x1, of.omega * x2, v2
        z[:, :constant], z[:, constant] = np.transpose(bodies[:constant]), of.held * unit
    span, coefficients = np.where(tau > 0, tau, 1.0), np.array([float(one) for one in terms])
    for k in range(len(terms)):
        value = np.polynomial.polynomial.polyval(local, coefficients) * unit
        for _ in range(k):  # one by one, so that no power of a time leaves the range
            value = value * span
        z[:, first + k], coefficients = value, np.polynomial.polynomial.polyder(coefficients)
    for place, sine in zip(range(first + len(terms), size, 2), sines, strict=True):
        omega, height = float(sine.omega), float(sine.amplitude) * unit
        phase = omega * local + float(sine.omega * piece.start + sine.phase)
        z[:, place], z[:, place + 1] = height * np.sin(phase), height * np.cos(phase)
        A[1, place], A[place, place + 1], A[place + 1, place] = of.reach, omega, -omega
    J = A * tau[:, None, None]
    for k in range(first, first + len(terms) - 1):
        J[:, k, k + 1] = tau > 0
    return J, z


def _halvings(A: Floats) -> Counts:
    """Return how often each matrix must be halved for its norm to be 1/2 at most."""
    norm = np.abs(A).sum(axis=-1).max(axis=-1)
    return np.asarray(np.maximum(np.frexp(np.where(np.isfinite(norm), norm, 0.0))[1] + 1, 0), dtype=np.int64)


def _less_one(A: Floats, halvings: Counts) -> Floats:
    """Return exp(A/2^halvings) - 1 by Taylor, for norms of 1/2 at most."""
    A = np.ldexp(A, -halvings[:, None, None])
    E, one = A / _TERMS, np.eye(A.shape[-1])
    for k in range(_TERMS - 1, 0, -1):
        E = A @ (one + E) / k
    return E


def exponential_less_one(A: Floats) -> Floats:
    """Return exp(A) - 1 of a stack of matrices: what is small keeps its digits."""
    halvings = _halvings(A)
    E = _less_one(A, halvings)
    for k in range(int(halvings.max(initial=0))):
        E = np.where((k < halvings)[:, None, None], 2 * E + E @ E, E)
    return E


def _gramian(A: Floats, Q: Floats) -> Floats:
    """Return int_0^1 exp(A s)' Q exp(A s) ds for stacks: Van Loan's block exponential of a short interval, doubled."""
    n, halvings = A.shape[-1], _halvings(A)
    block = np.zeros((len(A), 2 * n, 2 * n))
    block[:, :n, :n], block[:, :n, n:], block[:, n:, n:] = -A.swapaxes(1, 2), Q, A
    E = _less_one(block, halvings)
    flow = E[:, n:, n:] + np.eye(n)
    found = flow.swapaxes(1, 2) @ E[:, :n, n:]
    for k in range(int(halvings.max(initial=0))):
        on = (k < halvings)[:, None, None]
        found = np.where(on, found + flow.swapaxes(1, 2) @ found @ flow, found)
        flow = np.where(on, flow @ flow, flow)
    return found


def moved(mode: LinearMode, at: Begun, tau: Floats) -> Floats:
    """Return by how much x1, v1, x2, v2 change within tau (s), shape (4, n)."""
    of, by = _Numbers(mode), np.zeros((4, len(tau)))
    for part in ((True, slice(0)), *((False, slice(k, k + 1)) for k in range(len(mode.piece.sines)))):
        J, z = _system(mode, at, tau, *part)
        by[: of.bodies] += np.einsum("nij,nj->in", exponential_less_one(J)[:, : of.bodies], z)
    x1 = by[0] / of.omega
    v1 = by[1] - of.slow * x1
    if of.bodies == 4:
        return np.stack([x1, v1, by[2] / of.omega, by[3]])
    if not mode.side:
        return np.stack([x1, v1, x1, v1])
    gained = of.held / of.m2 * tau
    return np.stack([x1, v1, (at[1][3] + gained / 2) * tau, gained])


def losses(mode: LinearMode, at: Begun, tau: Floats) -> Floats:
    """Return b int |v1 - v2|, a1 int v1^2 and int u v1 within tau (s), J, shape (3, n)."""
    of, (x1, _, x2, _) = _Numbers(mode), moved(mode, at, tau)
    found = np.zeros((3, len(tau)))
    found[0], forces = of.held * (x1 - x2), bool(mode.force)
    if of.bodies == 2 and not (of.a1 or forces):
        return found
    J, z = _system(mode, at, tau, True, slice(None))
    v1, w, friction, drive = np.zeros((4, z.shape[1]))
    for row, over in ((v1, of.v1), (w, of.w), (friction, of.friction)):
        row[: of.bodies] = over[: of.bodies]
    drive[of.bodies + 1 :][[place - FIRST for place, _ in mode.force]] = 1.0
    products = (1.0, friction, w, of.bodies == 4), (of.a1, v1, v1, of.a1), (of.mass * of.reach, drive, v1, forces)
    for k, (factor, one, two, acts) in enumerate(products):
        if acts:
            form = (np.outer(one, two) + np.outer(two, one)) / 2
            found[k] += factor * tau * np.einsum("ni,nij,nj->n", z, _gramian(J, np.broadcast_to(form, J.shape)), z)
    return found


class Moving:
    """One motion, enclosed: from a state (m, m/s) at a time of the run (s), in a mode."""

    def __init__(self, arithmetic: Arithmetic, mode: LinearMode, state: Sequence[Number], begin: Number) -> None:
        """Keep where it begins; to be used in the arithmetic's context."""
        self.arithmetic, self.mode, self.is_ball = arithmetic, mode, arithmetic.name == "ball"
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

    def _enclosed(self, function: Callable[[Motion, arb], tuple[arb, ...]], tau: Number) -> tuple[Number, ...]:
        """Return a function of the motion and of a time after its start, with the bits that squarings may lose."""
        with precision(self.bits):
            since = as_ball(tau)
        with precision(self.bits + 2 * self._halvings(since)):
            found = function(self.mode.motion(*self.start), since)
        return tuple(+one if self.is_ball else self.arithmetic.number(exact_middle(one)) for one in found)

    def _halvings(self, tau: arb) -> int:
        """Return how often a time must be halved for the flow over it to be a small matrix."""
        largest, upper = max(abs(one) for row in self.mode.generator() for one in row), abs(tau).upper()
        bits = largest.numerator.bit_length() - largest.denominator.bit_length() + 8
        if upper.is_zero() or not upper.is_finite():
            return 0
        mantissa, exponent = upper.man_exp()
        return max(0, bits + int(mantissa).bit_length() + int(exponent))

    def _state(self, motion: Motion, tau: arb) -> tuple[arb, ...]:
        over = motion.over(tau)
        x1, v1, x2, v2 = (over.range(row) for row in _STATE)
        return x1, v1, x2, v2 if self.mode.side else v1

    def _taken(self, motion: Motion, tau: arb) -> tuple[arb, ...]:
        mode, a1 = self.mode, self.mode.pair.a1
        if mode.slope or mode.pull:
            friction = self._product(mode.friction, W, motion, tau)
        else:
            over = motion.over(tau)
            slid = [over.range(row) - value(row, motion.begin) for row in _STATE]
            friction = Ball.number(mode.side * mode.b) * (slid[0] - slid[2])
        damping = ((V1, a1),) if a1 else ()
        return friction, *(self._product(one, _STATE[V1], motion, tau) for one in (damping, mode.force))

    def _product(self, one: Row, two: Row, motion: Motion, tau: arb) -> arb:
        """Return int one two dt up to tau, of two rows: the integral of z' Q z.

        Van Loan's block exponential over a short interval, then doubled: exp(-A' t) alone would grow where z decays. A
        ball of times adds what the product may be there.
        """
        if not one:
            return arb(0)
        A, halvings, over = np.array(self.mode.generator()), self._halvings(tau), motion.over(tau)
        n, Q = len(A), 0 * A
        for place, f in one:
            for other, g in two:
                Q[place, other] += f * g / 2
                Q[other, place] += f * g / 2
        block = matrix(np.block([[-A.T, Q], [0 * A, A]]).tolist()) * (tau.mid() / (arb(2) ** halvings))
        E = np.array(block.exp().tolist())
        flow = arb_mat(E[n:, n:].tolist())
        found = flow.transpose() * arb_mat(E[:n, n:].tolist())
        for _ in range(halvings):
            found += flow.transpose() * found * flow
            flow = flow * flow
        middle = (motion.begin.transpose() * found * motion.begin)[0, 0]
        return middle + tau.rad() * arb(0, 1) * over.range(one) * over.range(two)
