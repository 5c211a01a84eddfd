"""A run in one row of an array: what compiled code reads and writes without a look at Python, one row or many.

Columns of a state: 0-3 the pair, 4-16 the start of the present motion, 17-24 its errors, 25-33 their linear part,
34 the worst relative error, 35 the reduced horizon, 36 the events so far, 37 how the run ended.
Columns of an answer: those of state.End, then the events, how the run ended, and the reduced time it got to.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.kernel.bounds import Errors, Linear
from numerics.kernel.compilation import kernel
from numerics.kernel.ends import at_event, at_horizon
from numerics.kernel.motion import run
from numerics.kernel.state import COLUMNS, EVENT_LIMIT, OUT_OF_RANGE, ROWS_FULL, End, Pair, Start

WORST, HORIZON, EVENTS, HOW, STATE = 34, 35, 36, 37, 38
ANSWER = len(End._fields) + 3
_TAU, _X, _V, _Z = (COLUMNS.index(name) for name in ("tau", "X", "V", "Z"))


@kernel
def pack(s: Any, pair: Pair, start: Start, errors: Errors, linear: Linear, worst: float) -> None:
    """Write a run into a row; horizon, events and ending are left as they are."""
    s[0], s[1], s[2], s[3] = pair.q, pair.r, pair.sqrt_q, 1.0 if pair.literal else 0.0
    s[4], s[5], s[6], s[7], s[8], s[9] = start.kind, start.side, start.X, start.guard, start.gap, start.push
    s[10], s[11], s[12], s[13] = start.driven, 1.0 if start.turns else 0.0, start.Z, start.w
    s[14], s[15], s[16] = start.tau, start.rest, start.spent
    s[17], s[18], s[19], s[20] = errors.late, errors.gap, errors.push, errors.w
    s[21], s[22], s[23], s[24] = errors.slide, errors.place, errors.shift, errors.norm
    s[25], s[26], s[27], s[28], s[29] = linear.length, linear.offset, linear.velocity, linear.excess, linear.w
    s[30], s[31], s[32], s[33] = linear.late, linear.own_offset, linear.own_velocity, linear.own_w
    s[WORST] = worst


@kernel
def pair_of(s: Any) -> Pair:
    """Return the pair of a row."""
    return Pair(s[0], s[1], s[2], s[3] != 0.0)


@kernel
def start_of(s: Any) -> Start:
    """Return the start of the present motion of a row."""
    return Start(int(s[4]), s[5], s[6], s[7], s[8], s[9], s[10], s[11] != 0.0, s[12], s[13], s[14], s[15], s[16])


@kernel
def errors_of(s: Any) -> Errors:
    """Return the errors at the start of the present motion of a row."""
    return Errors(s[17], s[18], s[19], s[20], s[21], s[22], s[23], s[24])


@kernel
def advance(s: Any, max_events: int, rows: Any) -> int:
    """Run a row until it ends or `rows` is full; return how many rows were written (motion.run)."""
    pair, start, errors = pair_of(s), start_of(s), errors_of(s)
    linear = Linear(s[25], s[26], s[27], s[28], s[29], s[30], s[31], s[32], s[33])
    left = max_events - int(s[EVENTS])
    how, count, start, errors, linear, worst = run(pair, start, errors, linear, s[HORIZON], left, rows, s[WORST])
    pack(s, pair, start, errors, linear, worst)
    s[EVENTS] += count
    s[HOW] = how
    return count


@kernel
def answer(s: Any, end: Any) -> None:
    """Write the end of a run that is over; nan where it left the range."""
    how, start, errors, horizon = int(s[HOW]), start_of(s), errors_of(s), s[HORIZON]
    if how in (EVENT_LIMIT, ROWS_FULL):
        at, tau = at_event(pair_of(s), start, errors, s[WORST]), start.tau
    else:
        at, tau = at_horizon(pair_of(s), start, errors, horizon, s[WORST]), horizon
    end[0], end[1], end[2], end[3], end[4], end[5], end[6] = at.mode, at.X, at.V1, at.V2, at.Z, at.w, at.spent
    end[7], end[8], end[9], end[10] = at.x_error, at.v1_error, at.v2_error, at.place_error
    end[11], end[12], end[13] = at.w_error, at.spent_error, at.worst
    if how == OUT_OF_RANGE:
        for column in range(14):
            end[column] = math.nan
    end[14], end[15], end[16], end[17] = 1.0 if at.certain and how != OUT_OF_RANGE else 0.0, s[EVENTS], how, tau


@kernel
def run_one(first: Any, s: Any, max_events: int, rows: Any, end: Any) -> int:
    """Run the row `first` to its end in the row `s`, `rows` being long enough; return the number of events."""
    for column in range(STATE):
        s[column] = first[column]
    count = advance(s, max_events, rows)
    answer(s, end)
    return count


@kernel
def run_in_si(first: Any, s: Any, max_events: int, rows: Any, end: Any, units: Any, si: Any) -> int:
    """Run the row `first` as run_one does and write (t, x1, v, x2) of each event, and of the end (x1, v1, x2, v2).

    units = (length m, rate 1/s); the last row of `si` that is written has the end.
    """
    count, length, rate = run_one(first, s, max_events, rows, end), units[0], units[1]
    speed = length * rate
    for index in range(count):
        row, written = rows[index], si[index]
        written[0], written[1] = row[_TAU] / rate, length * row[_X]
        written[2], written[3] = speed * row[_V], length * (row[_X] - row[_Z])
    last = si[count]
    last[0], last[1], last[2], last[3] = length * end[1], speed * end[2], length * (end[1] - end[4]), speed * end[3]
    return count


@kernel
def run_keeping(states: Any, max_events: int, answers: Any, kept: Any, nothing: Any) -> None:
    """Run every row of `states` to its end and keep its first events in `kept` (rows, events, state.COLUMNS).

    `nothing` is an empty array of rows.
    """
    for index in range(len(states)):
        if states[index, HOW] >= 0.0:  # a row that could not be prepared has -1
            advance(states[index], max_events, kept[index])
            if states[index, HOW] == ROWS_FULL:
                advance(states[index], max_events, nothing)
            answer(states[index], answers[index])
