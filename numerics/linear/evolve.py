"""Evolve: the state, the clock, the set of errors and the ledger over a step, or to an event."""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, product, put, times
from numerics.linear.columns import FAST, Constants, Now, Problem, Room, counted, place_of, wide_product
from numerics.linear.error_set import carry
from numerics.linear.first_root import ROOT, value_slope
from numerics.linear.ledger import Taken, enter, slid_and_damped
from numerics.linear.next_event import Next
from numerics.linear.table import PRECISE, UNIT, V1, WIDE_UNIT, X1


@compilable_with(forceinline=False)
def evaluate(X: Any, s: TwoFloats, h: float, wide: bool) -> tuple[TwoFloats, TwoFloats]:
    """Return x and v of a body with coefficients X (2, terms) at s = t/h.

    Where `wide`, at s.high, and from there by first derivatives: |s.low| <= 2^-53 s.high, and a term of second order,
    k^2/2 2^-106 of that of s^k, is within the 2 k 2^-101 that are counted for this one.
    """
    if not wide:
        value, slope = value_slope(X[0], s.high)
        return TwoFloats(value, 0.0), TwoFloats(slope / h, 0.0)
    value, slope = value_slope(X[0, PRECISE:], s.high)
    x, v, bend = TwoFloats(value, 0.0), TwoFloats(slope, 0.0), 0.0
    for k in range(min(PRECISE, X.shape[1]) - 1, -1, -1):
        bend = bend * s.high + v.high
        v = plus(times(v, s.high), x)
        x = plus(times(x, s.high), TwoFloats(X[0, k], X[1, k]))
    x = plus(x, TwoFloats(s.low * v.high, 0.0))
    v = plus(v, TwoFloats(2.0 * s.low * bend, 0.0))
    return x, v / h


@compilable_with(**FAST)
def full_step(room: Room, whole: Any, count: int, unit: float) -> None:
    """Move the state by exp(A h) in float64; form what that adds to its errors."""
    z, size = room.z, room.size
    for i in range(4):
        row, value, most = whole[0, i], 0.0, 0.0
        for j in range(count):
            value += row[j] * z[0, j]
            most += abs(row[j]) * size[j]
        room.y[i, 0], room.column[i] = value, (count + 4) * most * unit


@compilable_with(forceinline=False)
def wide_step(room: Room, whole: Any, count: int) -> None:
    """Move the state by exp(A h) in pairs: not from a function with fastmath, which compiles what it calls so, too."""
    y, z = room.y, room.z
    y[:, :] = 0.0
    for j in range(count):
        for i in range(4):  # four sums at once
            put(
                y[i],
                plus(pair_of(y[i]), product(TwoFloats(whole[0, i, j], whole[1, i, j]), TwoFloats(z[0, j], z[1, j]))),
            )


@compilable
def partial_step(problem: Problem, room: Room, at: tuple[int, int], s: TwoFloats, unit: float) -> tuple[float, float]:
    """Move the state by a part s of a step; form what that adds to its errors; return how x1 and v1 go with v1."""
    tables, y, own, h = problem.tables, room.y, room.column, problem.tables.h[at]
    sums, count = tables.state_own[at], tables.count[at[0]]
    for i in range(2):
        X = room.X[:, i, :4] if i == 1 and at[1] == 0 else room.X[:, i, :]  # body 2 goes on a parabola in a slip
        x, v = evaluate(X, s, h, problem.wide)
        put(y[2 * i], x)
        put(y[2 * i + 1], v)
        own[2 * i] = unit * counted(sums[2 * i], room.size, count, s.high)
        own[2 * i + 1] = unit / h * counted(sums[2 * i + 1], room.size, count, s.high)
    value, slope = value_slope(tables.rows[at][0, 0, V1], s.high)
    return value, slope / h


@compilable
def evolve(problem: Problem, room: Room, now: Now, ahead: Next) -> Now:
    """Move state, errors, clock and ledger to what is ahead; return where the run is."""
    tables, at, s = problem.tables, place_of(problem, now), ahead.s
    count, unit, whole = tables.count[at[0]], WIDE_UNIT if problem.wide else UNIT, tables.ends[at]
    taken = slid_and_damped(problem, room, now, s.high) if problem.has_ledger else Taken(0.0, 0.0, 0.0)
    if s.high == 1.0 and s.low == 0.0:
        full_step(room, whole, count, unit)
        if problem.wide:
            wide_step(room, whole, count)
        reach, turn = whole[0, X1, V1], whole[0, V1, V1]
    else:
        if problem.wide and ahead.how != ROOT:  # else they have been formed with the guard
            wide_product(tables.rows[at], tables.degrees[at], room, count)
        reach, turn = partial_step(problem, room, at, s, unit)
    time = times(s, tables.h[at])
    N = now.N + end_step(problem.pair, room, now.mode, time, reach, turn)
    if problem.has_ledger:
        enter(problem, room, now, taken, N, time.high)
    return Now(now.piece, now.mode, 0, now.edge, now.since + time.high, N)


@compilable
def end_step(pair: Constants, room: Room, mode: int, time: TwoFloats, reach: float, turn: float) -> float:
    """Move clock and errors by a step of the state; return what it adds to N. reach, turn: how x1 and v1 go with v1."""
    own, scale = room.column, room.scale
    if mode == 0:
        put(room.y[3], pair_of(room.y[1]))
        own[3] = own[1]
    for i in range(2):
        put(room.clock[i], plus(pair_of(room.clock[i]), time))
    added = own[0] * scale[0] + own[1] * scale[1] + own[3] * scale[3]
    carry(room.E, room.R, pair, mode, time.high, (reach, turn), added, own[2] * scale[2])
    return added
