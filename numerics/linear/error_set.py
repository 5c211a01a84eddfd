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

from numerics.arithmetic.compiled import compilable_with
from numerics.linear.columns import Constants

SLACK = 1.0 + 1e-9
"""The bounds' own rounding."""
SMALL = 1e-150
"""What is smaller has squares that floats do not hold."""
_CONTRACT: dict[str, Any] = {"fastmath": {"contract"}}


@compilable_with(**_CONTRACT)
def carry(
    E: Any,
    R: Any,
    pair: Constants,
    mode: int,
    time: float,
    motion: tuple[float, float],
    own: float,
    own2: float,
) -> None:
    """Map the errors by the flow of a mode over a time; own, own2: what the step adds, in N and to x2.

    `motion`: x and v of the body that moves freely, m x'' + a1 x' + a2 x = 0, from x = 0 and v = 1. From x = 1 and
    v = 0 it has x = v + (a1/m) x and v = -(a2/m) x of these. Body 2 goes on as it is, or in stick as body 1: there both
    velocities of an error are one, so that E may be projected on these, at right angles in N, where R does not grow.
    """
    m = pair.m1 if mode != 0 else pair.mass
    across, turn = motion[0] * math.sqrt(pair.a2 / pair.m1), motion[1]
    back, stay = -pair.m1 / m * across, turn + pair.a1 / m * motion[0]
    far, share, part = time * math.sqrt(pair.a2 / pair.m2), math.sqrt(pair.m2 / pair.m1), pair.m1 / pair.mass
    for j in range(4):
        x, v = E[0, j], E[1, j]
        if mode == 0:
            v = part * (v + share * E[3, j])
        E[0, j] = stay * x + across * v
        E[1, j] = back * x + turn * v
        if mode == 0:
            E[2, j] += E[0, j] - x
            E[3, j] = share * E[1, j]
        else:
            E[2, j] += far * E[3, j]
    R[1] = (R[1] + (far if mode != 0 else 2.0) * R[0] + own2) * SLACK
    R[0] = (R[0] + own) * SLACK


@compilable_with(**_CONTRACT)
def box(E: Any, R: Any, i: int) -> float:
    """Return a bound on component i, in its unit."""
    total = R[1] if i == 2 else R[0]
    for j in range(E.shape[1]):
        total += abs(E[i, j])
    return total * SLACK


@compilable_with(**_CONTRACT)
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
    if max(a, b, c) < SMALL:
        return (a + b + c) * SLACK
    return math.sqrt(a * a + b * b + c * c) * SLACK


@compilable_with(forceinline=False, **_CONTRACT)
def take_in(E: Any, R: Any, Q: Any, v: Any) -> None:
    """Take the rest R into E: an orthogonal basis by Gram and Schmidt, longest column first, each as long as needed."""
    for j in range(4):
        v[j] = abs(E[0, j]) + abs(E[1, j]) + abs(E[2, j]) + abs(E[3, j])
    for k in range(4):
        pick = 0
        for j in range(1, 4):
            if v[j] > v[pick]:
                pick = j
        size, v[pick] = v[pick], -1.0
        for i in range(4):
            Q[i, k] = E[i, pick]
        length = orthogonal(Q, k)
        if length <= 1e-12 * size or length < SMALL:  # a direction that is left: along the axis with the least in Q
            least, axis = 2.0, 0
            for n in range(4):
                taken = 0.0
                for i in range(k):
                    taken += Q[n, i] * Q[n, i]
                if taken < least:
                    least, axis = taken, n
            Q[:, k] = 0.0
            Q[axis, k] = 1.0
            length = orthogonal(Q, k)
        inverse = 1.0 / length
        for i in range(4):
            Q[i, k] *= inverse
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
def orthogonal(Q: Any, k: int) -> float:
    """Make column k of Q orthogonal to those before it, again where rounding may count; return its length."""
    square = square_of(Q, k)
    for _ in range(2):
        before = square
        for n in range(k):
            dot = 0.0
            for i in range(4):
                dot += Q[i, k] * Q[i, n]
            for i in range(4):
                Q[i, k] -= dot * Q[i, n]
        square = square_of(Q, k)
        if square > 0.01 * before:  # lost no more than a digit
            break
    return math.sqrt(square)


@compilable_with(**_CONTRACT)
def square_of(Q: Any, k: int) -> float:
    """Return the square of the length of a column."""
    total = 0.0
    for i in range(4):
        total += Q[i, k] * Q[i, k]
    return total
