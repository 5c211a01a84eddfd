"""The events of a run under a force in binary64 as one table: thousands of rows at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

_NUMBERS = ("local", "x1", "v1", "x2", "v2")


def table_of(trajectory: Any, rows: list[int]) -> NDArray[Any]:
    """Return t, x1, v1, x2, v2 of these rows, shape (5, m); the first is the start, -1 the end."""
    if trajectory.arithmetic.name == "float64":
        return _table_of_floats(trajectory, rows)
    table = np.empty((5, len(rows)), dtype=object)
    with trajectory.arithmetic.context():
        for column, row in enumerate(rows):
            t = trajectory.time_of(row) if row else trajectory.arithmetic.number(0)
            table[:, column] = [t, *trajectory.enclosed(row)]
    return table


def _table_of_floats(trajectory: Any, rows: list[int]) -> NDArray[np.float64]:
    record, starts = trajectory.record, np.array(trajectory.pieces.float_starts())
    table = np.array([np.append(record.column(name), record.number(-1, name))[rows] for name in _NUMBERS])
    table[0] += np.append(starts[record.codes("piece").astype(np.int64)], starts[int(record.end_row[3])])[rows]
    table[0, 0] = 0.0
    if trajectory.reached:
        table[0, -1] = trajectory.time_of(-1)
    return table
