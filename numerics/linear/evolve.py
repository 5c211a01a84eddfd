"""Evolve: the state, the clock, the set of errors and the ledger over a step, or to an event."""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, put, two_product
from numerics.linear.columns import FAST, Constants, Now, Problem, Room, counted, place_of
from numerics.linear.error_set import carry
from numerics.linear.first_root import value_slope
from numerics.linear.ledger import Taken, enter, slid_and_damped
from numerics.linear.next_event import Next
from numerics.linear.table import UNIT, V1, X1


@compilable_with(**FAST)
def full_step(room: Room, whole: Any, count: int, unit: float) -> None:
    """Move the state by exp(A h); form what that adds to its errors."""
    z, size = room.z, room.size
    for i in range(4):
        row, value, most = whole[i], 0.0, 0.0
        for j in range(count):
            value += row[j] * z[j]
            most += abs(row[j]) * size[j]
        room.y[i], room.column[i] = value, (count + 4) * most * unit


@compilable
def partial_step(problem: Problem, room: Room, at: tuple[int, int], s: float) -> tuple[float, float]:
    """Move the state by a part s of a step; form what that adds to its errors; return how x1 and v1 go with v1."""
    tables, y, own, h = problem.tables, room.y, room.column, problem.tables.h[at]
    sums, count = tables.state_own[at], tables.count[at[0]]
    for i in range(2):
        X = room.X[i, :4] if i == 1 and at[1] == 0 else room.X[i, :]  # body 2 goes on a parabola in a slip
        x, slope = value_slope(X, s)
        y[2 * i], y[2 * i + 1] = x, slope / h
        own[2 * i] = UNIT * counted(sums[2 * i], room.size, count, s)
        own[2 * i + 1] = UNIT / h * counted(sums[2 * i + 1], room.size, count, s)
    value, slope = value_slope(tables.rows[at][0, V1], s)
    return value, slope / h


@compilable
def evolve(problem: Problem, room: Room, now: Now, ahead: Next) -> Now:
    """Move state, errors, clock and ledger to what is ahead; return where the run is."""
    tables, at, s = problem.tables, place_of(problem, now), ahead.s
    count, whole = tables.count[at[0]], tables.ends[at][0]
    taken = slid_and_damped(problem, room, now, s) if problem.has_ledger else Taken(0.0, 0.0, 0.0)
    if s == 1.0:
        full_step(room, whole, count, UNIT)
        reach, turn = whole[X1, V1], whole[V1, V1]
    else:
        reach, turn = partial_step(problem, room, at, s)
    time = two_product(s, tables.h[at])
    N = now.N + end_step(problem.pair, room, now.mode, time, reach, turn)
    if problem.has_ledger:
        enter(problem, room, now, taken, N, time.high)
    return Now(now.piece, now.mode, 0, now.edge, now.since + time.high, N)


@compilable
def end_step(pair: Constants, room: Room, mode: int, time: TwoFloats, reach: float, turn: float) -> float:
    """Move clock and errors by a step of the state; return what it adds to N. reach, turn: how x1 and v1 go with v1."""
    own, scale = room.column, room.scale
    if mode == 0:
        room.y[3] = room.y[1]
        own[3] = own[1]
    for i in range(2):
        put(room.clock[i], plus(pair_of(room.clock[i]), time))
    added = own[0] * scale[0] + own[1] * scale[1] + own[3] * scale[3]
    carry(room.E, room.R, pair, mode, time.high, (reach, turn), added, own[2] * scale[2])
    return added
