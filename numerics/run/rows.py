"""How a run records an event: its row, the columns of which have their names in trajectory/record.py."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.arithmetic.float64 import put
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.bounds.records import EventErrors
from numerics.motion.undamped import mode_of


@text
def remembered(start: Any) -> tuple[float, float, Number, Number]:
    """Return kind, side, gap and push of a motion: what its start has beside the state."""
    return float(start.kind), start.side, start.gap, start.push


@text
def damped_remembered(start: Any) -> tuple[float, float, Number, Number]:
    """Return the same of a damped motion: its mode, and the state again."""
    return float(start.mode), 0.0, start.V2, start.V2


@text
def record(rows: Any, index: int, length: Number, start: Any, V: Number, at: EventErrors) -> None:
    """Write one event to its row."""
    row = rows[index]
    kind, side, gap, push = remembered(start)
    row[0], row[1], row[2] = mode_of(start), kind, side
    row[3], row[4], row[5], row[6], row[7] = at.late, at.x, at.v, at.place, at.relative
    put(row, 8, (start.tau, length, start.X, V, start.Z, start.w, gap, push))


class Growing:
    """Rows for interpreted texts: a row is made when it is first written; `told` hears of every thousandth."""

    def __init__(self, length: int, most: int, told: Callable[[int, Any], None] | None = None) -> None:
        """Make rows of this length, as many as `most` of them."""
        self.rows: list[list[Any]] = []
        self._length, self._most, self._told = length, most, told

    def __len__(self) -> int:
        """Return how many rows there may be."""
        return self._most

    def __getitem__(self, index: int) -> list[Any]:
        """Return a new row, which must be the next one."""
        if self._told is not None and index % 1000 == 999:
            self._told(index, self.rows[-1])
        self.rows.append([0.0] * self._length)
        return self.rows[index]
