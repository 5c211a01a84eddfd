"""The motion after a row, z' = A z: enclosed, one by one, or in binary64 for thousands of rows and times at once.

In binary64 a time is a sum of intervals h 2^k, by its binary digits, and of a rest; over h the fastest rate turns
through 1/2. exp(A h 2^k) comes from balls and is rounded once, what happens within h is Taylor's; approximate, without
a bound. Signals flow so from where their piece begins. In every other arithmetic a motion is that of LinearMode, for
balls as it is, for mpmath its midpoint.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache

import flint
import mpmath
import numpy as np
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, as_float, exact_middle, magnitude_bits
from numerics.arithmetic.precision import precision
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.linear.flow import Motion, flow_of, motion_in
from numerics.linear.model import FIRST, SLIP, STICK, TAKEN, Cell, Layout
from numerics.linear.system import LinearMode, matrix, sparse
from numerics.scene import Pair
from numerics.trajectory.columns import Floats
from numerics.trajectory.comparison import as_ball

_TERMS = 14
"""Terms of Taylor while a rate turns through 1/2: the next one is below 2^-53 of their size."""
_SPARE_BITS = 24
BITS_PER_SQUARING = 5
"""What an exponential may lose each time that it is squared: entries are sums of a few products."""
_STATE = tuple(((place, Fraction(1)),) for place in range(FIRST))
_PHASE_BITS = 384
"""For the phase of a sine where a piece begins, however many turns that is."""


# ------------------------------------------------------------------ in binary64
class Steps:
    """exp(A t) of stick or of slip in binary64, for times below 2^top s."""

    def __init__(self, pair: Pair, layout: Layout, slips: bool, cell: Cell, top: int) -> None:
        """Form exp(A h 2^k) in balls."""
        with precision(64):
            given = flow_of(64, pair, slips, layout, cell, 1)
            mode, fastest = given.mode, given.norm.fastest.upper()
        shortest = min(top, -1 - magnitude_bits(fastest)) if fastest > 0 else top
        unit, self.h = Fraction(2) ** shortest, np.ldexp(1.0, shortest)
        self.taylor = np.array([[float(one * unit) for one in row] for row in mode.generator()])
        largest = max(0, int(np.frexp(np.abs(self.taylor).max())[1]))
        self.longer: list[Floats] = []
        with precision(144 + BITS_PER_SQUARING * (top - shortest) + 2 * largest):
            flow = given.over(arb(2) ** shortest)
            for _ in range(top - shortest):
                self.longer.append(np.array([*map(as_float, (flow - 1).entries())]).reshape(mode.size, mode.size))
                flow = flow * flow

    def over(self, z: Floats, tau: Floats) -> Floats:
        """Return by how much z changes within tau (s)."""
        rest, changed, term = np.fmod(tau, self.h), np.zeros_like(z), z
        for k in range(1, _TERMS + 1):
            term = (self.taylor @ term) * (rest / self.h / k)
            changed += term
        for k, less_one in enumerate(self.longer):
            if tau.max(initial=0.0) < np.ldexp(self.h, k):
                break
            on = np.fmod(tau, np.ldexp(self.h, k + 1)) >= np.ldexp(self.h, k)
            changed[:, on] += less_one @ (z[:, on] + changed[:, on])
        return changed


steps_of = lru_cache(64)(Steps)


@lru_cache(1024)
def signals_of(mode: LinearMode) -> Floats:
    """Return the blocks of z where the piece of a mode begins, in binary64."""
    with precision(_PHASE_BITS):
        z = mode.begin([arb(0)] * FIRST, Ball.number(mode.piece.start))
    return np.array([*map(as_float, z[FIRST:])])


# ------------------------------------------------------------------ in the other arithmetics
def enclosed(
    arithmetic: Arithmetic,
    mode: LinearMode,
    state: Sequence[Number],
    begin: Number,
    tau: Number,
    function: Callable[[Motion, arb], Sequence[arb]],
) -> tuple[Number, ...]:
    """Return a function of a motion, from a state (m, m/s) at a time of the run (s), and of tau (s) since; in context.

    It is computed with the bits that squarings may lose, or that small powers of the time need: as often as a power is
    high, as in the derivatives of a force of high degree.
    """
    is_ball = arithmetic.name == "ball"
    bits = flint.ctx.prec if is_ball else mpmath.mp.prec + _SPARE_BITS
    with precision(bits):
        start, since = ([as_ball(one) for one in state], as_ball(begin)), as_ball(tau)
        small = -magnitude_bits(since.abs_upper()) * (2 + max(mode.layout.terms))
        spare = 2 * max(mode.size * mode.squarings(since), small)
    with precision(bits + spare):
        found = function(motion_in(mode, *start), since)
    return tuple(+one if is_ball else arithmetic.number(exact_middle(one)) for one in found)


def after(motion: Motion, tau: arb) -> Sequence[arb]:
    """Return (x1, v1, x2, v2) at tau (s) after the start; for a ball at every point of it."""
    ((x1, v1, x2, v2),) = motion.ranges(_STATE, tau, 0)
    return x1, v1, x2, v2 if motion.flow.slips else v1


def taken(motion: Motion, tau: arb) -> Sequence[arb]:
    """Return what is TAKEN up to tau (s) after the start, J.

    By Van Loan's block exponential; a ball of times adds what a power may be there.
    """
    flow, begun, found = motion.flow, motion.column, [arb(0)] * len(TAKEN)
    halved = flow.mode.squarings(tau)
    short = tau.mid() / arb(2) ** halved
    for place, (one, two) in enumerate(flow.mode.rows.powers[SLIP if flow.slips else STICK].tolist()):
        if any(one) and any(two):
            form = matrix([one]).transpose() * matrix([two])
            # symmetric, which balls bound more sharply
            ahead, total = _van_loan(flow.A, short, (form + form.transpose()) / 2)
            for _ in range(halved):
                total += ahead.transpose() * total * ahead
                ahead = ahead * ahead
            (factors,) = motion.ranges((sparse(one), sparse(two)), tau, 0)
            power = tau.rad() * arb(0, 1) * factors[0] * factors[1]
            found[place] = (begun.transpose() * total * begun)[0, 0] + power
    return found


def _van_loan(A: arb_mat, tau: arb, Q: arb_mat) -> tuple[arb_mat, arb_mat]:
    """Return exp(A tau) and int_0^tau exp(A' s) Q exp(A s) ds, for a short time: exp(-A' tau) grows where z decays."""
    n, adjoint, nothing = A.nrows(), (-A.transpose()).tolist(), [arb(0)] * A.nrows()
    above = [[*one, *two] for one, two in zip(adjoint, Q.tolist(), strict=True)]
    block = (arb_mat([*above, *([*nothing, *one] for one in A.tolist())]) * tau).exp().tolist()
    flow = arb_mat([row[n:] for row in block[n:]])
    return flow, flow.transpose() * arb_mat([row[n:] for row in block[:n]])
