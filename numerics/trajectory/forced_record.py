"""What a run under a force left behind: a row for the start of every segment, and one for the end, read by name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.double_numbers import exact_sum
from numerics.arithmetic.protocol import Number
from numerics.trajectory.pickled import plain, restored

CODES = ("mode", "event", "jump", "piece", "order")
"""Floats of a segment: the sign of v1 - v2; whether the mode changed at its start, and whether u or b jumped there (or
a piece was cut); the piece; how many derivatives of the guard vanish at the start."""
NUMBERS = ("local", "x1", "v1", "x2", "v2", "norm", "place", "late", "x1_error", "v1_error", "x2_error", "v2_error")
"""Numbers of a segment: the time in its piece and the state at its start, a point; bounds on the distance to the true
motion in N and on the error of x2; and on the errors of an event at its start: of its time and of the state there."""


def row_length(width: int) -> int:
    """Return how long a row is, where a number takes `width` columns."""
    return len(CODES) + width * len(NUMBERS)


class ForcedRecord:
    """Rows of all segments and the row for the end, which has the same columns; `how` the run ended (codes.py)."""

    __slots__ = ("end_row", "how", "rows", "width")

    def __init__(self, rows: Any, end_row: Any, how: int, width: int) -> None:
        """Keep what a run wrote; a number takes `width` columns."""
        self.rows, self.end_row, self.how, self.width = rows, end_row, how, width

    def plain(self) -> tuple[Any, Any, int, int]:
        """Return what can be compared and pickled."""
        return plain(self.rows), plain(self.end_row), self.how, self.width

    @classmethod
    def restored(cls, rows: Any, end_row: Any, how: int, width: int) -> ForcedRecord:
        """Return a record from its plain form."""
        if isinstance(end_row, list):  # of an array of floats
            return cls(np.array(rows, dtype=float).reshape(-1, row_length(width)), np.array(end_row), how, width)
        return cls(restored(rows), restored(end_row), how, width)

    def __len__(self) -> int:
        """Return how many events there were."""
        return int(self.codes("event").sum())

    def codes(self, name: str) -> NDArray[np.float64]:
        """Return a float of all segments."""
        column = CODES.index(name)
        if isinstance(self.rows, np.ndarray):
            return self.rows[:, column]
        return np.array([row[column] for row in self.rows], dtype=float)

    def number(self, index: int, name: str) -> Number:
        """Return a number of a segment; -1: of the end."""
        return self._at(self.end_row if index < 0 else self.rows[index], name)

    def numbers(self, name: str, indices: Sequence[int]) -> list[Number]:
        """Return a number of some segments."""
        return [self.number(int(index), name) for index in indices]

    def column(self, name: str) -> NDArray[np.float64]:
        """Return a number of all segments, in binary64; of a run in binary64."""
        found: NDArray[np.float64] = self.rows[:, len(CODES) + NUMBERS.index(name)]
        return found

    def _at(self, row: Any, name: str) -> Number:
        column = len(CODES) + self.width * NUMBERS.index(name)
        if self.width == 2:
            return exact_sum(float(row[column]), float(row[column + 1]))
        return float(row[column]) if type(row) is np.ndarray else row[column]
