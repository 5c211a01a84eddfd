"""The motion after a knot in binary64, for thousands of knots and times at once: exponentials of small matrices.

Body 1 and what drives it form z' = J z, z = (omega x1, v1 + slow x1, drive), omega = sqrt(a2/m). With the oscillator's
slow rate split off J is triangular where it is overdamped: a slow rate keeps its digits beside a fast one. Body 2 has a
constant acceleration in slip, and moves with body 1 in stick. Approximate, without a bound: the enclosed
evaluation is that of motions.py.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.linear.pieces import ExactPiece
from numerics.linear.system import V1, LinearMode, Row, W
from numerics.scene import Pair

Floats = NDArray[np.float64]
_TERMS = 14
"""Terms of Taylor for matrices of norm 1/2: the next one is below 2^-53 of their size."""


class Knots(NamedTuple):
    """Where n motions under one piece begin: the sign of v1 - v2 (0 in stick), the time in the piece, the state."""

    sign: Floats
    local: Floats
    y: Floats
    """x1, v1, x2, v2, shape (4, n)."""


class _Rates(NamedTuple):
    """Of body 1 with the mass (kg) that the spring moves: rates in 1/s, all of shape (n,)."""

    mass: Floats
    omega: Floats
    slow: Floats
    fast: Floats
    coupling: Floats
    size: Floats


def _rates(pair: Pair, sign: Floats) -> _Rates:
    mass = np.where(sign == 0, float(pair.mass), float(pair.m1))
    omega, half = np.sqrt(float(pair.a2) / mass), float(pair.a1) / mass / 2
    over = half > omega
    root = np.sqrt(np.where(over, (half - omega) * (half + omega), 0.0))
    fast = np.where(over, half + root, 2 * half)
    slow = np.where(over, omega / np.where(over, fast, 1.0) * omega, 0.0)
    return _Rates(mass, omega, slow, fast, np.where(over, 0.0, omega), omega + fast)


def _system(pair: Pair, piece: ExactPiece, at: Knots, tau: Floats, parts: tuple[bool, slice]) -> tuple[Floats, Floats]:
    """Return J tau (n, k, k) and z (n, k): body 1 itself with b and the polynomial, or not; and some of the sines."""
    rates, (own, chosen) = _rates(pair, at.sign), parts
    coefficients = np.array([float(one) for one in piece.polynomial] or [0.0])
    count, sines = len(coefficients) if own else 0, piece.sines[chosen]
    size = 2 + count + 2 * len(sines)
    J, z = np.zeros((len(tau), size, size)), np.zeros((len(tau), size))
    J[:, 0, 0], J[:, 0, 1], J[:, 1, 0], J[:, 1, 1] = -rates.slow, rates.omega, -rates.coupling, -rates.fast
    unit = 1.0 / (rates.mass * rates.size)
    span = np.where(tau > 0, tau, 1.0)
    if own:
        z[:, 0], z[:, 1] = rates.omega * at.y[0], at.y[1] + rates.slow * at.y[0]
        J[:, 1, 2] = rates.size
        for k in range(count):
            value = np.polynomial.polynomial.polyval(at.local, coefficients) * unit
            for _ in range(k):  # one by one, so that no power of a time leaves the range
                value = value * span
            z[:, 2 + k] = value
            coefficients = np.polynomial.polynomial.polyder(coefficients)
            if k:
                J[:, 1 + k, 2 + k] = 1.0 / span
        z[:, 2] -= at.sign * float(piece.b) * unit
    for k, sine in enumerate(sines):
        place, omega, height = 2 + count + 2 * k, float(sine.omega), float(sine.amplitude) * unit
        phase = omega * at.local + float(sine.omega * piece.start + sine.phase)
        z[:, place], z[:, place + 1] = height * np.sin(phase), height * np.cos(phase)
        J[:, 1, place], J[:, place, place + 1], J[:, place + 1, place] = rates.size, omega, -omega
    return J * tau[:, None, None], z


def _halvings(A: Floats) -> NDArray[np.int64]:
    """Return how often each matrix must be halved for its norm to be 1/2 at most."""
    norm = np.abs(A).sum(axis=-1).max(axis=-1)
    return np.asarray(np.maximum(np.frexp(np.where(np.isfinite(norm), norm, 0.0))[1] + 1, 0), dtype=np.int64)


def _halved(A: Floats, halvings: NDArray[np.int64]) -> Floats:
    return np.asarray(np.ldexp(A, -halvings[:, None, None]))


def _less_one(A: Floats) -> Floats:
    """Return exp(A) - 1 by Taylor, for norms of 1/2 at most."""
    E, one = A / _TERMS, np.eye(A.shape[-1])
    for k in range(_TERMS - 1, 0, -1):
        E = A @ (one + E) / k
    return E


def exponential_less_one(A: Floats) -> Floats:
    """Return exp(A) - 1 of a stack of matrices: what is small keeps its digits."""
    halvings = _halvings(A)
    E = _less_one(_halved(A, halvings))
    for k in range(int(halvings.max(initial=0))):
        E = np.where((k < halvings)[:, None, None], 2 * E + E @ E, E)
    return E


def _gramian(A: Floats, Q: Floats) -> Floats:
    """Return int_0^1 exp(A s)' Q exp(A s) ds for stacks: Van Loan's block exponential of a short interval, doubled."""
    n, halvings = A.shape[-1], _halvings(A)
    block = np.zeros((len(A), 2 * n, 2 * n))
    block[:, :n, :n], block[:, :n, n:], block[:, n:, n:] = -A.swapaxes(1, 2), Q, A
    E = _less_one(_halved(block, halvings))
    flow = E[:, n:, n:] + np.eye(n)
    found = flow.swapaxes(1, 2) @ E[:, :n, n:]
    for k in range(int(halvings.max(initial=0))):
        on = (k < halvings)[:, None, None]
        found = np.where(on, found + flow.swapaxes(1, 2) @ found @ flow, found)
        flow = np.where(on, flow @ flow, flow)
    return found


def moved(pair: Pair, piece: ExactPiece, at: Knots, tau: Floats) -> Floats:
    """Return by how much x1, v1, x2, v2 change within tau (s), shape (4, n)."""
    rates, pulled = _rates(pair, at.sign), at.sign * float(piece.b / pair.m2)
    by = np.zeros((2, len(tau)))
    for part in ((True, slice(0)), *((False, slice(k, k + 1)) for k in range(len(piece.sines)))):
        J, z = _system(pair, piece, at, tau, part)
        by += np.einsum("nij,nj->in", exponential_less_one(J)[:, :2], z)
    x1 = by[0] / rates.omega
    v1 = by[1] - rates.slow * x1
    slips = at.sign != 0
    x2 = np.where(slips, (at.y[3] + pulled * tau / 2) * tau, x1)
    return np.stack([x1, v1, x2, np.where(slips, pulled * tau, v1)])


def losses(pair: Pair, piece: ExactPiece, at: Knots, tau: Floats) -> Floats:
    """Return b int |v1 - v2|, a1 int v1^2 and int u v1 within tau (s), J, shape (3, n)."""
    x1, _, x2, _ = moved(pair, piece, at, tau)
    found = np.zeros((3, len(tau)))
    found[0] = float(piece.b) * at.sign * (x1 - x2)
    acts = bool(piece.polynomial or piece.sines)
    if pair.a1 == 0 and not acts:
        return found
    J, z = _system(pair, piece, at, tau, (True, slice(None)))
    rates, n = _rates(pair, at.sign), z.shape[1]
    v1, drive = np.zeros((len(tau), n)), np.zeros(n)
    v1[:, 0], v1[:, 1] = -rates.slow / rates.omega, 1.0
    drive[[2, *range(2 + max(1, len(piece.polynomial)), n, 2)]] = 1.0
    if pair.a1:
        found[1] = float(pair.a1) * tau * _integral(J, v1[:, :, None] * v1[:, None, :], z)
    if acts:  # the drive is u - sign b, over mass and size
        both = v1[:, :, None] * drive
        work = rates.mass * rates.size * tau * _integral(J, (both + both.swapaxes(1, 2)) / 2, z)
        found[2] = work + at.sign * float(piece.b) * x1
    return found


def coupled(mode: LinearMode, at: Knots, tau: Floats) -> tuple[Floats, Floats]:
    """Return the same two, `moved` and `losses`, for motions in one mode whose friction depends on the state."""
    A, z = np.array(mode.generator(), dtype=float), np.zeros((len(tau), mode.size))
    z[:, :4], z[:, 4] = at.y.T, 1.0
    terms = np.array([float(one) for one in mode.piece.polynomial] or [0.0])
    for place in mode.polynomial_places:
        z[:, place], terms = np.polynomial.polynomial.polyval(at.local, terms), np.polynomial.polynomial.polyder(terms)
    for place, sine in zip(mode.sine_places, mode.piece.sines, strict=True):
        phase = float(sine.omega) * at.local + float(sine.omega * mode.piece.start + sine.phase)
        z[:, place], z[:, place + 1] = float(sine.amplitude) * np.sin(phase), float(sine.amplitude) * np.cos(phase)
    J, found = A * tau[:, None, None], np.zeros((3, len(tau)))
    w, v, force, friction = (_vector(row, mode.size) for row in (W, ((V1, Fraction(1)),), mode.force, mode.friction))
    for k, (one, two) in enumerate(((friction, w), (float(mode.pair.a1) * v, v), (force, v))):
        form = np.outer(one, two) * (mode.side != 0 or k > 0)
        found[k] = tau * _integral(J, np.broadcast_to((form + form.T) / 2, J.shape), z)
    return np.einsum("nij,nj->in", exponential_less_one(J)[:, :4], z), found


def _vector(row: Row, size: int) -> Floats:
    found = np.zeros(size)
    for place, factor in row:
        found[place] += float(factor)
    return found


def _integral(A: Floats, Q: Floats, z: Floats) -> Floats:
    return np.asarray(np.einsum("ni,nij,nj->n", z, _gramian(A, Q), z))
