"""What a run left behind: a row an event, and a row for the end, read by the names of their columns."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.double_numbers import exact_sum
from numerics.arithmetic.protocol import Number
from numerics.trajectory.pickled import plain, restored

CODES = ("mode", "kind", "side", "late", "x", "v", "place", "relative")
"""Floats of an event: mode (-1, 0, +1), kind of motion and side after it; bounds on the errors of tau, X, V and Z, and
on the relative error of t, x1, v and x2."""
NUMBERS = ("tau", "length", "X", "V", "Z", "w", "gap", "push")
"""Numbers of an event: its time, how long the motion before it lasted, the state, how the motion after it starts."""
END_CODES = (
    *("how", "events", "mode", "first_mode", "certain", "digits", "worst"),
    *("x_error", "v1_error", "v2_error", "place_error", "w_error", "spent_error", "damped_error"),
)
"""Floats of the end: how the run ended (codes.py), how many events it had, the mode there and at the start, whether the
bounds leave no doubt about the sequence of events, right digits and the relative error of all events by the bounds;
bounds on the errors."""
END_NUMBERS = (
    *("tau", "length", "X", "V1", "V2", "Z", "w", "spent", "damped"),
    *("X0", "V10", "V20", "Z0", "w0", "length_unit", "rate", "energy_unit"),
)
"""The reduced time at the end, how long the last motion lasts up to it, the state, and what was taken from E/E_cr; the
state at the start; L in m, Omega in 1/s, E_cr in J."""


_CODE = {name: index for index, name in enumerate(CODES)}
_NUMBER = {name: index for index, name in enumerate(NUMBERS)}
_END_CODE = {name: index for index, name in enumerate(END_CODES)}
_END_NUMBER = {name: index for index, name in enumerate(END_NUMBERS)}


def row_length(width: int) -> int:
    """Return how long the row of an event is, where a number takes `width` columns."""
    return len(CODES) + width * len(NUMBERS)


def end_length(width: int) -> int:
    """Return how long the row for the end is."""
    return len(END_CODES) + width * len(END_NUMBERS)


class Record:
    """Rows (n, row_length) and the row for the end: arrays of floats, halves of double-double numbers, or lists."""

    __slots__ = ("end_row", "rows", "width")

    def __init__(self, rows: Any, end_row: Any, width: int) -> None:
        """Keep what a run wrote; a number takes `width` columns."""
        self.rows, self.end_row, self.width = rows, end_row, width

    def plain(self) -> tuple[Any, Any, int]:
        """Return what can be compared and pickled."""
        return plain(self.rows), plain(self.end_row), self.width

    @classmethod
    def restored(cls, rows: Any, end_row: Any, width: int) -> Record:
        """Return a record from its plain form."""
        if isinstance(end_row, list):  # of an array of floats
            return cls(np.array(rows, dtype=float).reshape(len(rows), row_length(width)), np.array(end_row), width)
        return cls(restored(rows), restored(end_row), width)

    def __len__(self) -> int:
        """Return how many events there were."""
        return len(self.rows)

    def code(self, index: int, name: str) -> float:
        """Return a float of an event."""
        return float(self.rows[index][_CODE[name]])

    def codes(self, name: str) -> NDArray[np.float64]:
        """Return a float of all events."""
        if isinstance(self.rows, np.ndarray):
            return self.rows[:, _CODE[name]]
        return np.array([row[_CODE[name]] for row in self.rows], dtype=float)

    def number(self, index: int, name: str) -> Number:
        """Return a number of an event, exactly."""
        return self._at(self.rows[index], len(CODES) + self.width * _NUMBER[name])

    def numbers(self, name: str) -> NDArray[Any]:
        """Return a number of all events: floats, or objects."""
        if self.width == 1 and isinstance(self.rows, np.ndarray):
            return self.rows[:, len(CODES) + _NUMBER[name]]
        return _objects([self.number(index, name) for index in range(len(self.rows))])

    def in_numbers(self) -> tuple[Any, Any]:
        """Return the rows and the end with one number a column: as they are, or double-double ones joined."""
        if self.width == 1:
            return self.rows, self.end_row
        rows = [self._joined(row, len(CODES)) for row in self.rows]
        return rows, self._joined(self.end_row, len(END_CODES))

    def _joined(self, row: Any, codes: int) -> list[Any]:
        return [*row[:codes], *(exact_sum(float(row[i]), float(row[i + 1])) for i in range(codes, len(row), 2))]

    def end_code(self, name: str) -> float:
        """Return a float of the end."""
        return float(self.end_row[_END_CODE[name]])

    def end(self, name: str) -> Number:
        """Return a number of the end, exactly."""
        return self._at(self.end_row, len(END_CODES) + self.width * _END_NUMBER[name])

    def _at(self, row: Any, column: int) -> Number:
        if self.width == 2:
            return exact_sum(float(row[column]), float(row[column + 1]))
        return float(row[column]) if type(row) is np.ndarray else row[column]


def _objects(values: Sequence[Any]) -> NDArray[Any]:
    array = np.empty(len(values), dtype=object)
    array[:] = values
    return array
