"""A record in SI units: t, x1, v1, x2, v2 at start, events and horizon, and the events by their kinds."""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.telling import text
from numerics.trajectory.record import CODES, END_CODES, END_NUMBERS, NUMBERS

_TAU, _X, _V, _Z = (len(CODES) + NUMBERS.index(name) for name in ("tau", "X", "V", "Z"))
_END_TAU, _END, _START, _UNITS = (
    len(END_CODES) + END_NUMBERS.index(name) for name in ("tau", "X", "X0", "length_unit")
)
_FIRST_MODE = END_CODES.index("first_mode")


@text
def si_table(rows: Any, end: Any, table: Any, order: Any) -> None:
    """Fill table (5, m) from the rows of k events and of the end; m = k + 2, or k + 1 without it.

    order (k + 2,): how many entries there are, how many entries and exits, and the indices of the events by their kind.
    """
    length, rate, count = end[_UNITS], end[_UNITS + 1], len(rows)
    speed = length * rate
    _place(table, 0, 0 * rate, (end[_START], end[_START + 1], end[_START + 2], end[_START + 3]), length, speed)
    for index in range(count):
        row = rows[index]
        _place(table, index + 1, row[_TAU] / rate, (row[_X], row[_V], row[_V], row[_Z]), length, speed)
    if len(table[0]) > count + 1:
        at = end[_END], end[_END + 1], end[_END + 2], end[_END + 3]
        _place(table, count + 1, end[_END_TAU] / rate, at, length, speed)
    place = 2
    for kind in range(3):  # entries, exits, crossings, as in modes.EventKind
        mode = end[_FIRST_MODE]
        for index in range(count):
            after = rows[index][0]
            if kind == (0 if after == 0.0 else (1 if mode == 0.0 else 2)):
                order[place] = index
                place += 1
            mode = after
        if kind < 2:
            order[kind] = place - 2


@text
def _place(table: Any, column: int, t: Any, at: Any, length: Any, speed: Any) -> None:
    """Write one column from the time and (X, V1, V2, Z)."""
    X, V1, V2, Z = at
    table[0, column] = t
    table[1, column] = length * X
    table[2, column] = speed * V1
    table[3, column] = length * (X - Z)
    table[4, column] = speed * V2
