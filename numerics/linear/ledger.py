"""The ledger of a run in float64: what friction and damper took, and what forces, belt and wall gave, J.

Powers are products of two rows of z (model.TAKEN), integrated over every step of a segment by Gauss's rule, and asked
for after a run only: most runs are not.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, put, two_product
from numerics.linear.calm import doubled, matrix_product
from numerics.linear.first_root import value_slope
from numerics.linear.model import V1, V2, X1, Norm
from numerics.linear.record import AT
from numerics.linear.room import Problem, Room, dot, form_z, polynomial_of, size_of
from numerics.linear.table import STATE, UNIT

NODES, WEIGHTS = (np.polynomial.legendre.leggauss(20)[0] + 1.0) / 2.0, np.polynomial.legendre.leggauss(20)[1] / 2.0
"""Of Gauss's rule on [0, 1]: exact up to degree 39, and what a step has beyond that is below rounding, in `parts`."""
TINY = 2.0**-1060
"""More than energies can lose below the normal numbers, J."""
_LONG, _MOST_LEVELS, _MOST_STEPS = 256.0, 36, 1_000_000
"""From so many steps on a segment is taken by powers of its flow, each the square of the one before it, of so many at
most; further steps are not waited for."""
_MODE, _PIECE, _LOCAL, _LENGTH = (AT[name] for name in ("mode", "piece", "local", "length"))
_REST, _X1, _ERROR, _LATE = (AT[name] for name in ("local_rest", "x1", "speed_error", "late"))


@compilable
def parts(terms: int) -> int:
    """Return into how many equal parts a step of series of so many terms is cut for Gauss's rule."""
    return 1 + (terms - 1) // 36


@compilable_with(makes_arrays=True, forceinline=False)
def ledger(problem: Problem, room: Room, rows: Any, count: int, end: Any, taken: Any) -> None:
    """Write to `taken` (7,) what is TAKEN in a run, from its rows and that of its end, and a bound on all its errors.

    nan where a segment has more steps than anybody waits for.
    """
    X = np.zeros((STATE, problem.tables.rows.shape[4]))
    taken[:] = 0.0
    steps = 0
    for k in range(count):
        row, after = rows[k], rows[k + 1] if k + 1 < count else end
        piece, mode = int(row[_PIECE]), int(row[_MODE])
        kind, side = problem.drive.places[piece, 0], 1 if mode == 0 else 0
        for i in range(STATE):
            room.y[i] = row[_X1 + i]
        room.clock[0, 0], room.clock[0, 1] = row[_LOCAL], row[_REST]
        taken[6] += row[_LATE] * at_event(problem, room, piece, row[_ERROR] * problem.norm.root_m1)
        h, left, N = problem.tables.h[kind, side], after[_LENGTH], after[_ERROR]
        if left > _LONG * h:
            left = by_powers(problem, room, (piece, mode), left, N * problem.norm.root_m1, taken)
        while left > 0.0 and steps < _MOST_STEPS:
            s = min(1.0, left / h)
            step(problem, room, (piece, mode), s, X, N * problem.norm.root_m1, taken)
            left = left - h if s == 1.0 else 0.0
            steps += 1
    if count > 0:
        taken[6] += end[_LATE] * at_event(problem, room, int(end[_PIECE]), end[_ERROR] * problem.norm.root_m1)
    if steps == _MOST_STEPS:
        taken[:] = np.nan


@compilable
def step(
    problem: Problem,
    room: Room,
    here: tuple[int, int],
    s: float,
    X: Any,
    N: float,
    taken: Any,
) -> None:
    """Add what is taken over a part of a step, and move the state to its end; N of the error."""
    tables, (piece, mode) = problem.tables, here
    kind, side = problem.drive.places[piece, 0], 1 if mode == 0 else 0
    count, h, cut = tables.count[kind], tables.h[kind, side], parts(X.shape[1])
    form_z(problem, room, piece, mode, False)
    for i in range(STATE):
        polynomial_of(tables.rows[kind, side, i], tables.degrees[kind, side, i], room.z, count, 0, X[i])
    begun = pair_of(room.clock[0])
    for part in range(cut):
        for n in range(NODES.shape[0]):
            place = s * (part + NODES[n]) / cut
            put(room.clock[0], plus(begun, two_product(place, h)))
            for i in range(STATE):
                room.y[i], _ = value_slope(X[i], place)
            form_z(problem, room, piece, mode, False)
            weight = WEIGHTS[n] / cut * s * h
            for k in range(6):
                one, a = factor(problem, room, tables.powers[kind, side, k, 0], count, N)
                two, b = factor(problem, room, tables.powers[kind, side, k, 1], count, N)
                taken[k] += weight * one * two
                taken[6] += weight * (abs(one) * b + abs(two) * a + a * b)
    put(room.clock[0], plus(begun, two_product(s, h)))
    for i in range(STATE):
        room.y[i], _ = value_slope(X[i], s)


@compilable_with(makes_arrays=True, forceinline=False)
def by_powers(problem: Problem, room: Room, here: tuple[int, int], left: float, N: float, taken: Any) -> float:
    """Add what is taken over most of a long segment, and move the state there; return how much of it is left.

    The integral of a product of rows over a time is a quadratic form F of z, and F(2 t) = F(t) + E F(t) E with the flow
    E(t). What is integrated of |p| is at most sqrt(t int p^2).
    """
    tables, (piece, mode) = problem.tables, here
    kind, side = problem.drive.places[piece, 0], 1 if mode == 0 else 0
    count, h, powers = tables.count[kind], tables.h[kind, side], tables.powers[kind, side]
    A = tables.A[kind, side, :count, :count] * h
    levels = min(_MOST_LEVELS, 1 + math.floor(math.log2(left / h)))
    flows = doubled(A, levels)
    forms = doubled_forms(A, powers, h, flows)
    while left > _LONG * h:
        level = min(levels - 1, math.floor(math.log2(left / h)))
        form_z(problem, room, piece, mode, False)
        time = math.ldexp(h, level)
        for k in range(6):
            p, q = max(form_at(forms[level, k, 1], room.z), 0.0), max(form_at(forms[level, k, 2], room.z), 0.0)
            taken[k] += form_at(forms[level, k, 0], room.z)
            a, b = reach(problem.norm, powers[k, 0]), reach(problem.norm, powers[k, 1])
            taken[6] += N * (b * math.sqrt(time * p) + a * math.sqrt(time * q) + a * b * N * time)
            taken[6] += math.ldexp((count + 64) * UNIT, level + 2) * math.sqrt(p * q)
        for i in range(STATE):
            room.y[i] = dot(flows[level, i], room.z, count)
        put(room.clock[0], plus(pair_of(room.clock[0]), TwoFloats(time, 0.0)))
        left -= time
    return left


@compilable_with(makes_arrays=True, forceinline=False)
def doubled_forms(A: Any, powers: Any, h: float, flows: Any) -> Any:
    """Return F of every power, of its first row squared and of its second, for the time of each of these flows."""
    levels, count = flows.shape[0], A.shape[0]
    forms, rows = np.zeros((levels, 6, 3, count, count)), np.zeros((2, count))
    for n in range(NODES.shape[0]):
        flow = doubled(A * NODES[n], 1)[0]
        for k in range(6):
            for i in range(2):
                for j in range(count):
                    rows[i, j] = dot(powers[k, i], flow[:, j], count)
            for c, (a, b) in enumerate(((0, 1), (0, 0), (1, 1))):
                for i in range(count):
                    for j in range(count):
                        forms[0, k, c, i, j] += WEIGHTS[n] * h * rows[a, i] * rows[b, j]
    for level in range(1, levels):
        flow = flows[level - 1]
        for k in range(6):
            for c in range(3):
                before = forms[level - 1, k, c]
                forms[level, k, c] = before + matrix_product(matrix_product(flow.T.copy(), before), flow)
    return forms


@compilable
def form_at(form: Any, z: Any) -> float:
    """Return z F z."""
    total = 0.0
    for i in range(form.shape[0]):
        total += z[i] * dot(form[i], z, form.shape[0])
    return total


@compilable
def at_event(problem: Problem, room: Room, piece: int, N: float) -> float:
    """Return twice the greatest powers in any mode where the room is: about an event it may be either."""
    tables, kind, total = problem.tables, problem.drive.places[piece, 0], 0.0
    form_z(problem, room, piece, 1, True)
    for side in range(2):
        for k in range(6):
            one, a = factor(problem, room, tables.powers[kind, side, k, 0], tables.count[kind], N)
            two, b = factor(problem, room, tables.powers[kind, side, k, 1], tables.count[kind], N)
            total += 2.0 * (abs(one) + a) * (abs(two) + b)
    return total


@compilable_with(forceinline=False)
def factor(problem: Problem, room: Room, row: Any, count: int, N: float) -> tuple[float, float]:
    """Return the value of a row, and by how much it may be off."""
    off = reach(problem.norm, row) * N + 32.0 * UNIT * size_of(row, room.size, count)
    return dot(row, room.z, count), off


@compilable
def reach(norm: Norm, row: Any) -> float:
    """Return by how much a row may be off for N = 1."""
    found = abs(row[V1]) / norm.root_m1
    if norm.root_a2 > 0.0:
        found += abs(row[X1]) / norm.root_a2
    if norm.root_m2 > 0.0:
        found += abs(row[V2]) / norm.root_m2
    return found
