"""A run in double-double in one row of an array, as packed.py has it for binary64.

Columns of a state: 0 kind, 1 side, 2 turns, 3 literal, then high and low of q, r, sqrt_q (4-9), X, guard, gap, push,
driven, Z, w, tau, rest, spent (10-29); 30-37 the errors, 38-46 their linear part, 47 the worst relative error, 48-49
the reduced horizon, 50 the events so far, 51 how the run ended.
Columns of an answer: 0 mode, then high and low of X, V1, V2, Z, w, spent (1-12), 13-18 the bounds of the errors of X,
V1, V2, Z, w, spent, 19 the worst relative error at an event, 20 certain, 21 events, 22 how it ended, 23-24 the time.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.kernel.bounds import Errors, Linear
from numerics.kernel.compilation import kernel
from numerics.kernel.double_double import Double
from numerics.kernel.double_ends import at_event, at_horizon
from numerics.kernel.double_motion import run
from numerics.kernel.double_state import DoublePair, DoubleStart
from numerics.kernel.state import EVENT_LIMIT, OUT_OF_RANGE, ROWS_FULL

_Q, _X, _ERRORS, _LINEAR = 4, 10, 30, 38
WORST, HORIZON, EVENTS, HOW, STATE = 47, 48, 50, 51, 52
ANSWER = 25


@kernel
def double_at(row: Any, index: int) -> Double:
    """Return the number whose halves are in this column and the next."""
    return Double(row[index], row[index + 1])


@kernel
def put(row: Any, index: int, number: Double) -> None:
    """Write both halves of a number."""
    row[index], row[index + 1] = number.high, number.low


@kernel
def pack(s: Any, pair: DoublePair, start: DoubleStart, errors: Errors, linear: Linear, worst: float) -> None:
    """Write a run into a row; horizon, events and ending are left as they are."""
    s[0], s[1] = start.kind, start.side
    s[2], s[3] = 1.0 if start.turns else 0.0, 1.0 if pair.literal else 0.0
    put(s, _Q, pair.q)
    put(s, _Q + 2, pair.r)
    put(s, _Q + 4, pair.sqrt_q)
    put(s, _X, start.X)
    put(s, _X + 2, start.guard)
    put(s, _X + 4, start.gap)
    put(s, _X + 6, start.push)
    put(s, _X + 8, start.driven)
    put(s, _X + 10, start.Z)
    put(s, _X + 12, start.w)
    put(s, _X + 14, start.tau)
    put(s, _X + 16, start.rest)
    put(s, _X + 18, start.spent)
    for index in range(8):
        s[_ERRORS + index] = errors[index]
    for index in range(9):
        s[_LINEAR + index] = linear[index]
    s[WORST] = worst


@kernel
def pair_of(s: Any) -> DoublePair:
    """Return the pair of a row."""
    return DoublePair(double_at(s, _Q), double_at(s, _Q + 2), double_at(s, _Q + 4), s[3] != 0.0)


@kernel
def start_of(s: Any) -> DoubleStart:
    """Return the start of the present motion of a row."""
    X, guard, gap, push = double_at(s, _X), double_at(s, _X + 2), double_at(s, _X + 4), double_at(s, _X + 6)
    driven, Z, w, tau = double_at(s, _X + 8), double_at(s, _X + 10), double_at(s, _X + 12), double_at(s, _X + 14)
    rest, spent = double_at(s, _X + 16), double_at(s, _X + 18)
    return DoubleStart(int(s[0]), s[1], X, guard, gap, push, driven, s[2] != 0.0, Z, w, tau, rest, spent)


@kernel
def errors_of(s: Any) -> Errors:
    """Return the errors at the start of the present motion of a row."""
    return Errors(s[30], s[31], s[32], s[33], s[34], s[35], s[36], s[37])


@kernel
def linear_of(s: Any) -> Linear:
    """Return the linear part of the errors of a row."""
    return Linear(s[38], s[39], s[40], s[41], s[42], s[43], s[44], s[45], s[46])


@kernel
def advance(s: Any, max_events: int, rows: Any) -> int:
    """Run a row until it ends or `rows` is full; return how many rows were written (double_motion.run)."""
    pair, start, errors, linear = pair_of(s), start_of(s), errors_of(s), linear_of(s)
    left, horizon = max_events - int(s[EVENTS]), double_at(s, HORIZON)
    how, count, start, errors, linear, worst = run(pair, start, errors, linear, horizon, left, rows, s[WORST])
    pack(s, pair, start, errors, linear, worst)
    s[EVENTS] += count
    s[HOW] = how
    return count


@kernel
def answer(s: Any, end: Any) -> None:
    """Write the end of a run that is over; nan where it left the range."""
    how, start, errors, horizon = int(s[HOW]), start_of(s), errors_of(s), double_at(s, HORIZON)
    if how in (EVENT_LIMIT, ROWS_FULL):
        at, tau = at_event(pair_of(s), start, errors, s[WORST]), start.tau
    else:
        at, tau = at_horizon(pair_of(s), start, errors, horizon, s[WORST]), horizon
    bounds = at.bounds
    end[0] = bounds.mode
    put(end, 1, at.X)
    put(end, 3, at.V1)
    put(end, 5, at.V2)
    put(end, 7, at.Z)
    put(end, 9, at.w)
    put(end, 11, at.spent)
    end[13], end[14], end[15], end[16] = bounds.x_error, bounds.v1_error, bounds.v2_error, bounds.place_error
    end[17], end[18], end[19] = bounds.w_error, bounds.spent_error, bounds.worst
    if how == OUT_OF_RANGE:
        for column in range(20):
            end[column] = math.nan
    end[20], end[21], end[22] = 1.0 if bounds.certain and how != OUT_OF_RANGE else 0.0, s[EVENTS], how
    put(end, 23, tau)


@kernel
def run_one(first: Any, s: Any, max_events: int, rows: Any, end: Any) -> int:
    """Run the row `first` to its end in the row `s`, `rows` being long enough; return the number of events."""
    for column in range(STATE):
        s[column] = first[column]
    count = advance(s, max_events, rows)
    answer(s, end)
    return count
