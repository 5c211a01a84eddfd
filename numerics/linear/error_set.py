"""How far the followed motion may be from the true one, in float64: a bound in N, and a sharper one by components.

Two motions under the same force never part in N = sqrt(a2 x1^2 + m1 v1^2 + m2 v2^2) of their difference, across all
events; so N of the error is at most the sum of the local errors. By components the error lies in

    {E c + r: |c_k| <= 1, |r| <= R0 in (x1, v1, v2), |r_x2| <= R1}

in the order x1, v1, x2, v2, in units in which N is a length (rows times root a2, root m1, root a2, root m2). A mode
maps E by its flow; R only adds up, because N contracts; where a slip ends R is taken into E by an orthogonal basis.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.arithmetic.compiled import compilable, compilable_with

SLACK = 1.0 + 1e-9
"""The bounds' own rounding."""
_CONTRACT: dict[str, Any] = {"fastmath": {"contract"}}


@compilable_with(forceinline=False, **_CONTRACT)
def carry(E: Any, R: Any, flow: Any, scale: Any, apart: float, own: float, own2: float) -> None:
    """Map the errors by the flow (4, 4) of a mode over a step; the flow is left in the units of the errors.

    `scale` are the units of the components; `apart` how far x2 goes for a unit of R0; own, own2: what the step adds, in
    N and to x2.
    """
    for k in range(4):
        inverse = 1.0 / scale[k]
        for i in range(4):
            flow[i, k] *= scale[i] * inverse
    p, q, r, s = row_of(flow, 0), row_of(flow, 1), row_of(flow, 2), row_of(flow, 3)
    for j in range(4):  # all four at once, with the flow in registers
        a, b, c, d = E[0, j], E[1, j], E[2, j], E[3, j]
        E[0, j] = p[0] * a + p[1] * b + p[2] * c + p[3] * d
        E[1, j] = q[0] * a + q[1] * b + q[2] * c + q[3] * d
        E[2, j] = r[0] * a + r[1] * b + r[2] * c + r[3] * d
        E[3, j] = s[0] * a + s[1] * b + s[2] * c + s[3] * d
    R[1] = (R[1] + apart * R[0] + own2) * SLACK
    R[0] = (R[0] + own) * SLACK


@compilable
def row_of(flow: Any, i: int) -> tuple[float, float, float, float]:
    """Return a row."""
    return flow[i, 0], flow[i, 1], flow[i, 2], flow[i, 3]


@compilable_with(**_CONTRACT)
def box(E: Any, R: Any, i: int) -> float:
    """Return a bound on component i, in its unit."""
    total = R[1] if i == 2 else R[0]
    for j in range(E.shape[1]):
        total += abs(E[i, j])
    return total * SLACK


@compilable_with(forceinline=False, **_CONTRACT)
def width(E: Any, R: Any, w0: float, w1: float, w3: float) -> float:
    """Return a bound on w0 x1 + w1 v1 + w3 v2 of the errors, in their units."""
    total = R[0] * math.sqrt(w0 * w0 + w1 * w1 + w3 * w3)
    for j in range(E.shape[1]):
        total += abs(w0 * E[0, j] + w1 * E[1, j] + w3 * E[3, j])
    return total * SLACK


@compilable_with(forceinline=False, **_CONTRACT)
def norm_of(E: Any, R: Any) -> float:
    """Return a bound on N of the errors."""
    a, b, c = box(E, R, 0), box(E, R, 1), box(E, R, 3)
    return math.sqrt(a * a + b * b + c * c) * SLACK


@compilable_with(forceinline=False, **_CONTRACT)
def take_in(E: Any, R: Any, Q: Any, v: Any) -> None:
    """Take the rest R into E: an orthogonal basis by Gram and Schmidt, longest column first, each as long as needed."""
    used = 0  # a bit for each column
    for k in range(4):
        most, pick = -1.0, 0
        for j in range(4):
            size = abs(E[0, j]) + abs(E[1, j]) + abs(E[2, j]) + abs(E[3, j])
            if not (used >> j) & 1 and size > most:
                most, pick = size, j
        used |= 1 << pick
        a, b, c, d, length = orthogonal(Q, k, E[0, pick], E[1, pick], E[2, pick], E[3, pick])
        if length <= 1e-12 * most or length == 0.0:  # a direction that is left
            for n in range(4):
                v[:] = 0.0
                v[n] = 1.0
                a, b, c, d, length = orthogonal(Q, k, v[0], v[1], v[2], v[3])
                if length > 0.4:
                    break
        Q[0, k], Q[1, k], Q[2, k], Q[3, k] = a / length, b / length, c / length, d / length
    for k in range(4):
        reach = R[0] + abs(Q[2, k]) * R[1]
        for j in range(4):
            reach += abs(Q[0, k] * E[0, j] + Q[1, k] * E[1, j] + Q[2, k] * E[2, j] + Q[3, k] * E[3, j])
        v[k] = reach * SLACK
    for i in range(4):
        for k in range(4):
            E[i, k] = Q[i, k] * v[k]
    R[0] = R[1] = 0.0


@compilable_with(**_CONTRACT)
def orthogonal(Q: Any, k: int, a: float, b: float, c: float, d: float) -> tuple[float, float, float, float, float]:
    """Return a vector made orthogonal to the first k columns of Q, again where rounding may count, and its length."""
    square = a * a + b * b + c * c + d * d
    for _ in range(2):
        before = square
        for n in range(k):
            p, q, r, s = Q[0, n], Q[1, n], Q[2, n], Q[3, n]
            dot = a * p + b * q + c * r + d * s
            a, b, c, d = a - dot * p, b - dot * q, c - dot * r, d - dot * s
        square = a * a + b * b + c * c + d * d
        if square > 0.01 * before:  # lost no more than a digit
            break
    return a, b, c, d, math.sqrt(square)
