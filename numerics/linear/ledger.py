"""The ledger: what friction and viscosity take over a step, and a bound on its error."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.linear.columns import FAST, Now, Problem, Room, place_of
from numerics.linear.table import NODES, UNIT, WEIGHTS, parts


class Taken(NamedTuple):
    """How far the bodies slide, int v1^2 dt and its size."""

    slid: float
    damped: float
    damped_size: float


@compilable_with(**FAST)
def slid_and_damped(problem: Problem, room: Room, now: Now, s: float) -> Taken:
    """Return what a step takes up to s: damping by a quadratic form of z for a whole one, else by Gauss's rule."""
    pair, tables, at = problem.pair, problem.tables, place_of(problem, now)
    slid, damped, terms, h = 0.0, 0.0, room.q.shape[0], tables.h[at]
    if now.mode != 0:
        g, square, odd = room.g, s * s, 0.0
        for k in range(terms - 2, -1, -2):
            slid = slid * square + g[k] * room.inverse[k]
            odd = odd * square + g[k + 1] * room.inverse[k + 1]
        slid = s * (slid + s * odd)
    if pair.a1 > 0.0 and s == 1.0:
        damped, size = of_square(tables.squares[at], room.z, tables.count[at[0]])
        return Taken(slid, damped, size)
    if pair.a1 > 0.0:
        X, place, v, cut = room.X[0], room.nodes[0], room.nodes[1], parts(terms)
        for part in range(cut):
            for n in range(NODES.shape[0]):
                place[n], v[n] = s / cut * (part + NODES[n]), (terms - 1) * X[terms - 1]
            for k in range(terms - 3, 0, -2):  # two powers at a time: v is read and written half as often
                high, low = (k + 1) * X[k + 1], k * X[k]
                for n in range(NODES.shape[0]):
                    v[n] = (v[n] * place[n] + high) * place[n] + low
            for n in range(NODES.shape[0]):
                damped += WEIGHTS[n] * v[n] * v[n]
        damped *= s / (cut * h)
    return Taken(slid, damped, damped)


@compilable_with(forceinline=False, **FAST)
def of_square(form: Any, z: Any, count: int) -> tuple[float, float]:
    """Return z F z, at least 0, and what its terms are at most together: n sum_i F_ii z_i^2, as F is one of squares."""
    value, size = 0.0, 0.0
    for i in range(count):
        total = 0.0
        for j in range(count):
            total += form[i, j] * z[j]
        value += total * z[i]
        size += form[i, i] * z[i] * z[i]
    return max(value, 0.0), count * size


@compilable
def enter(problem: Problem, room: Room, now: Now, taken: Taken, N: float, time: float) -> None:
    """Enter a step of this time; N at its end."""
    pair, ledger, piece = problem.pair, room.ledger, problem.drive.places[now.piece]
    b, count = problem.drive.b[now.piece], problem.tables.count[piece[4]]
    ledger[0] += b * taken.slid
    ledger[1] += pair.a1 * taken.damped
    lost = 2.0 * UNIT * (ledger[0] + ledger[1])
    if now.mode != 0:
        lost += b * time * 2.0 * pair.kappa * N
    if pair.a1 > 0.0:
        speed = (
            math.sqrt(taken.damped / time) + abs(room.y[1]) if taken.damped > 0.0 else 0.0
        )  # a last step may take no time
        off = N / room.scale[1] + 2.0 * UNIT * (count + 6) * speed
        lost += pair.a1 * (64.0 * UNIT * taken.damped_size + time * off * (4.0 * speed + off))
    ledger[2] += lost
