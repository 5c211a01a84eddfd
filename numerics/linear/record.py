"""What a run leaves behind: a row for the start of every segment, and one for the end.

Both engines write it and everything else reads it. A segment starts at the start of the run, at an event, or where a
piece of force or friction begins. In binary64 and double-double rows are arrays of floats, a number takes two columns
(in binary64 only a clock has a low half, others 0); in other arithmetics they are `Knot`s. SI units; every number is
that of its arithmetic, for balls an enclosure of the true one.
"""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable_with, compiled, compiles_now

CODES = ("mode", "order", "event", "jump", "piece")
"""Floats: the mode that starts (-1, 0, +1: the sign of v1 - v2), how many derivatives of its guard vanish at its start,
whether the mode changed, whether a piece begins here (the cause of an event is then a jump), which piece it is in."""
NUMBERS = ("local", "length", "x1", "v1", "x2", "v2", "excess")
"""Numbers, a high and a low half each: the time since the piece began and how long the segment before was (s), the
state (m, m/s), and E/E_cr - 1 where an engine carries it as a variable of its own (nan: form it from the state)."""
BOUNDS = ("late", "x1_error", "v1_error", "x2_error", "v2_error", "excess_error")
"""Floats: bounds on the errors of the time (s), of the state (m, m/s) and of the excess."""
COLUMNS = (*CODES, *(column for name in NUMBERS for column in (name, f"{name}_low")), *BOUNDS)
"""The columns of a row."""
END = ("how", "events", "certain", "friction", "friction_low", "viscous", "viscous_low", "dissipated_error")
"""What the row of the end has after these: a `How`, the number of events, whether the bounds leave no doubt about their
sequence, what friction and viscosity took (J, sums of positive terms), a bound on the error of their sum."""
AT = {name: index for index, name in enumerate((*COLUMNS, *END))}
"""The index of each column."""
ROW, END_ROW = len(COLUMNS), len(COLUMNS) + len(END)
UNKNOWN = -1
"""How a row of a batch ended that compiled code leaves to a run of its own."""


_EVENT, _PIECE, _LOCAL, _LENGTH = (AT[name] for name in ("event", "piece", "local", "length"))
_X1, _EXCESS, _FRICTION = (AT[name] for name in ("x1", "excess", "friction"))
_OF_DIMENSION = (), ("local", "length", "late"), ("x1", "x2"), ("v1", "v2"), ("friction", "viscous", "dissipated")
_DIMENSION = {name: index for index, names in enumerate(_OF_DIMENSION) for name in names}
DIMENSION = np.array([_DIMENSION.get(name.removesuffix("_low").removesuffix("_error"), 0) for name in AT])
"""Of each column: 0 none, 1 time, 2 length, 3 speed, 4 energy; of bounds and low halves, that of their number."""
_BOUND = {"local": "late", "friction": "dissipated_error", "viscous": "dissipated_error"}
HALVES = np.array(
    [(AT[name], AT[_BOUND.get(name, f"{name}_error")]) for name in AT if f"{name}_low" in AT and name != "length"]
)
"""Where the numbers stand that have bounds, and these."""


@compilable_with(makes_arrays=True, forceinline=False)
def finish(rows: Any, end: Any, mass: int, time: int, length: int) -> bool:
    """Bring a run, its rows and the row of its end, from units of 2^mass kg, 2^time s and 2^length m into SI units.

    Exact; return whether all its numbers are finite: no excess is carried by nan, and no ledger.
    """
    is_finite, exponents = True, np.array([0, time, length, length - time, mass + 2 * length - 2 * time])
    # a power may be too large for a float, its root is not
    root, rest = np.ldexp(1.0, exponents // 2), np.ldexp(1.0, (exponents + 1) // 2)
    for table in (rows, end.reshape(1, -1)):
        for k in range(table.shape[1]):
            one, two, may_miss = root[DIMENSION[k]], rest[DIMENSION[k]], _EXCESS <= k < _EXCESS + 2 or k >= _FRICTION
            for n in range(table.shape[0]):
                number = table[n, k] * one * two
                is_finite = is_finite and (math.isfinite(number) or (may_miss and math.isnan(number)))
                table[n, k] = number
    return is_finite


@compilable_with(makes_arrays=True, forceinline=False)
def tabulate(rows: Any, end: Any, count: int, starts: Any, until: float, reached: bool) -> tuple[Any, Any]:
    """Return the rows (count,) at which segments start, and t, x1, v1, x2, v2 at these and at the end, if `reached`.

    Of binary64; `starts` are those of the pieces, s. The table has the shape (5, count), or one column more.
    """
    at, table = np.empty(count, np.int64), np.empty((5, count + (1 if reached else 0)))
    found = 0
    for index in range(len(rows)):
        if index == 0 or rows[index, _EVENT] == 1.0:
            at[found] = index
            table[0, found] = starts[int(rows[index, _PIECE])] + rows[index, _LOCAL]
            for k in range(4):
                table[1 + k, found] = rows[index, _X1 + 2 * k]
            found += 1
    if reached:
        table[0, count] = until
        for k in range(4):
            table[1 + k, count] = end[_X1 + 2 * k]
    return at, table


@compilable_with(makes_arrays=True, forceinline=False)
def round_off(rows: Any) -> None:
    """Leave out the low halves of rows (n, ROW), or of an end; what they were is added to the bounds of the errors."""
    for k in range(len(HALVES)):
        number, bound = HALVES[k, 0], HALVES[k, 1]
        if number < rows.shape[1]:
            rows[:, bound] += np.fmax(np.abs(rows[:, number + 1]), 0.0)  # 0 for nan: it is formed from the state
            rows[:, number + 1] *= 0.0
    rows[:, _LENGTH + 1] = 0.0


def rounded(record: Record) -> Record:
    """Return a record of double-double without low halves; what they were is added to the bounds of the errors."""
    rows, end = record.rows.copy(), record.end.copy()
    for table in (rows, end.reshape(1, -1)):
        (compiled(round_off) if compiles_now() else round_off)(table)
    return record._replace(rows=rows, end=end)


class How(IntEnum):
    """How a run ended."""

    REACHED = 0
    """At its horizon."""
    STUCK = 1
    """At its horizon, in a stick that nothing ends later."""
    EVENT_LIMIT = 2
    """At the last event that the cap on events allows; the end is that event."""
    OUT_OF_RANGE = 3
    """A number left the range of the arithmetic."""
    DOUBT = 4
    """In front of something that this arithmetic does not decide; the end is the last start that is sure."""


class Knot(NamedTuple):
    """One row in the numbers of an arithmetic that has no columns for them; the names are those of the columns.

    It has no bounds: the numbers of balls are their own, those of mpmath have none.
    """

    mode: int
    order: int
    event: bool
    jump: bool
    piece: int
    local: Any
    length: Any
    x1: Any
    v1: Any
    x2: Any
    v2: Any
    excess: Any = None
    cell: Any = (0, 0)
    """Of a slip whose friction depends on the state (cells.py); a row starts at a crossing of a knot, too."""


class Record(NamedTuple):
    """A run: `rows` (n, ROW) or a list of Knots, the first one at t = 0; `end`, a row of END_ROW columns or a Knot."""

    rows: Any
    end: Any
    how: How
    events: int
    certain: bool = True
