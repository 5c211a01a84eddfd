"""The first root of a guard over a step: excluded by Bernstein coefficients, or bracketed and proved to be the first.

A guard is a polynomial q in s = t/h with float coefficients (terms of it, the rest is in the margin), positive right
after s = 0. In Bernstein's basis of degree 7 its minimum over [0, theta] is at least the least coefficient, less the
absolute sum of all higher terms. If that exceeds the margin (rounding, truncation, and how far the true motion may be
away), the true guard has no root there. Otherwise the first sign change of the coefficients starts Newton's method; a
root r counts if q falls there, keeps its sign in a bracket [r - D, r + D] by a bound on q'', and exceeds the margin
up to r - D: so it is the first one, and the only one in the bracket.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with

DEGREE = 7
CLEAR, ROOT, UNDECIDED = 0, 1, 2
"""No root up to where it was looked; one, isolated; not decided by these numbers."""
_HALVINGS, _NEWTON = 40, 12
_FREE: dict[str, Any] = {"fastmath": {"contract", "reassoc", "nnan", "nsz"}}
"""Sums may be taken in any order: the margin counts every rounding."""

BERNSTEIN = np.array(
    [[math.comb(i, k) / math.comb(DEGREE, k) if k <= i else 0.0 for i in range(DEGREE + 1)] for k in range(DEGREE + 1)]
)
"""[power, coefficient]."""


@compilable_with(forceinline=False, **_FREE)
def lower_bound(q: Any, theta: float, c: Any) -> float:
    """Return a lower bound on q over [0, theta], and in c its coefficients in Bernstein's basis.

    q has an even number of terms, and DEGREE is 7: its terms by name stay in registers, which takes half of the time.
    """
    two = theta * theta
    three, four = two * theta, two * two
    q0, q1, q2, q3, q4 = q[0], q[1] * theta, q[2] * two, q[3] * three, q[4] * four
    q5, q6, q7 = q[5] * (four * theta), q[6] * (four * two), q[7] * (four * three)
    even = odd = 0.0
    for k in range(q.shape[0] - 2, DEGREE, -2):
        even = even * two + abs(q[k])
        odd = odd * two + abs(q[k + 1])
    tail = four * four * (even + theta * odd) * 1.0000001
    B = BERNSTEIN
    for i in range(DEGREE + 1):
        c[i] = (B[0, i] * q0 + B[1, i] * q1) + (B[2, i] * q2 + B[3, i] * q3)
        c[i] += (B[4, i] * q4 + B[5, i] * q5) + (B[6, i] * q6 + B[7, i] * q7)
    low = c[0]
    for i in range(1, DEGREE + 1):
        low = min(low, c[i])
    return low - tail


@compilable
def crossing(c: Any, theta: float) -> float:
    """Return where the coefficients first fall to 0, or -1."""
    for i in range(1, DEGREE + 1):
        if c[i] <= 0.0:
            return theta * (i - 1 + c[i - 1] / (c[i - 1] - c[i])) / DEGREE
    return -1.0


@compilable_with(forceinline=False, **_FREE)
def bend_bound(q: Any, theta: float) -> float:
    """Return a bound on |q''| over [0, theta]."""
    even, odd, square = 0.0, 0.0, theta * theta
    for k in range(q.shape[0] - 2, 1, -2):
        even = even * square + (k * (k - 1)) * abs(q[k])
        odd = odd * square + ((k + 1) * k) * abs(q[k + 1])
    return even + theta * odd


@compilable_with(forceinline=False, fastmath={"contract"})
def value_slope(q: Any, s: float) -> tuple[float, float]:
    """Return a polynomial and its derivative at s, even and odd powers apart."""
    square = s * s
    v, d, w, e = 0.0, 0.0, 0.0, 0.0
    for k in range(q.shape[0] // 2 - 1, -1, -1):
        d = d * square + v
        v = v * square + q[2 * k]
        e = e * square + w
        w = w * square + q[2 * k + 1]
    return v + s * w, w + 2.0 * s * (d + s * e)


@compilable
def newton(q: Any, guess: float, theta: float, close: float) -> float:
    """Return where q falls through 0 next to a guess in (0, theta], or -1; steps end below so much of it."""
    s = guess
    for _ in range(_NEWTON):
        value, slope = value_slope(q, s)
        if not slope < 0.0:
            return -1.0
        change = value / slope
        s = s - change
        if not 0.0 < s <= theta:
            return -1.0
        if abs(change) <= close * s:
            return s
    return -1.0


@compilable
def first_root(
    q: Any, margins: tuple[float, float, float], theta: float, c: Any
) -> tuple[int, float, float, float, float]:
    """Return (how, s, D, value, slope): the first root of q in (0, theta], and what q is there.

    CLEAR: none up to s. ROOT: at s, alone within D of it. The margin of q up to s is m0 + m1 s + m2/s of `margins`.
    """
    m0, m1, m2 = margins
    at = theta
    for _ in range(_HALVINGS):
        low = lower_bound(q, at, c)
        if low > m0 + m1 * at + m2 / at:
            return CLEAR, at, 0.0, 0.0, 0.0
        guess = crossing(c, at)
        s = -1.0
        if guess >= 0.0:
            near = newton(q[: 2 * DEGREE], guess, at, 1e-6)  # of few terms, which cost little
            s = newton(q, near if near > 0.0 else guess, at, 1e-9)
        if s > 0.0:
            value, slope = value_slope(q, s)
            bend, alone = bend_bound(q, at), 0.5 * s
            if bend > 0.0:
                alone = min(alone, 0.25 * abs(slope) / bend)
            before = s - alone
            if lower_bound(q, before, c) > m0 + m1 * before + m2 / before and slope < 0.0:
                return ROOT, s, alone, value, slope
        at *= 0.5
    return UNDECIDED, at, 0.0, 0.0, 0.0
