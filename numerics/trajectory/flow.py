"""The motion after a knot in binary64, for thousands of knots and times at once: exponentials of small matrices.

A body on its spring and what drives it form z' = J z, z = (omega x1, v1 + slow x1, drive), omega = sqrt(a2/m). With the
oscillator's slow rate split off J is triangular where it is overdamped: a slow rate keeps its digits beside a fast one.
Body 2 has a constant acceleration in slip, and moves with body 1 in stick; where friction depends on the state it is
part of z. Approximate, without a bound: the enclosed evaluation is that of motions.py.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from numerics.linear.system import FIRST, LinearMode
from numerics.trajectory.columns import Counts, Floats
from numerics.trajectory.rows import Rows

_TERMS = 14
"""Terms of Taylor for matrices of norm 1/2: the next one is below 2^-53 of their size."""


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


def over_rows(function: Callable[..., Floats], run: Rows, rows: Counts, tau: Floats) -> Floats:
    """Return `moved` or `losses` of a run's motions from its rows on, row by row for a time (s)."""
    (local, y), found = run.row_numbers, np.zeros((3 if function is losses else 4, len(tau)))
    which = run.row_modes[1][rows]
    modes, counts = np.unique(which, return_counts=True)
    parts = np.split(np.argsort(which, kind="stable"), np.cumsum(counts)[:-1])
    for mode, chosen in zip(modes, parts, strict=False):  # of no rows there is one part, and no mode
        at = rows[chosen]
        found[:, chosen] = function(run.row_mode(mode), (local[at], y[:, at]), tau[chosen])
    return found
