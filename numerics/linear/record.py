"""What a run leaves behind: a row for the start of every segment, and one for the end.

Both engines write it and everything else reads it. A segment starts at the start of the run, at an event, or where a
piece of force or friction begins. In float64 rows are arrays of floats, in other arithmetics they are `Knot`s. SI
units; every number is that of its arithmetic, for balls an enclosure of the true one.
"""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable_with

CODES = ("mode", "order", "event", "jump", "piece", "cell")
"""Floats: the mode that starts (-1, 0, +1: the sign of v1 - v2), how many derivatives of its guard vanish at its start,
whether the mode changed, whether a piece begins here (the cause of an event is then a jump), which piece it is in, and
which cell of friction (Tables.ends)."""
NUMBERS = ("local", "local_rest", "length", "x1", "v1", "x2", "v2")
"""Numbers: the time since the piece began, what its rounding left out (for a run that starts again there), how long the
segment before was (s), the state (m, m/s)."""
BOUNDS = ("late", "x1_error", "v1_error", "x2_error", "v2_error", "speed_error")
"""Floats: bounds on the errors of the time (s) and of the state (m, m/s); N of these over the root of m1 (m/s)."""
COLUMNS = (*CODES, *NUMBERS, *BOUNDS)
"""The columns of a row."""
END = ("how", "events", "rows", "friction", "viscous", "force", "force_2", "belt", "wall", "ledger_error")
"""What the row of the end has after these: a `How`, the number of events, that of rows; and, nan until somebody asks
(ledger.py), what friction and damper took, what forces on body 1 and 2, belt and wall gave (J), and a bound on the
error of all these."""
AT = {name: index for index, name in enumerate((*COLUMNS, *END))}
"""The index of each column."""
ROW, END_ROW = len(COLUMNS), len(COLUMNS) + len(END)
UNKNOWN = -1
"""How a run ended that does not fit in floats; in a batch also one that compiled code leaves to a run of its own."""


_HOW, _ROWS, _FRICTION, _X1, _V2 = (AT[name] for name in ("how", "rows", "friction", "x1", "v2"))
_LARGEST = 2.0**1020
"""Energies up to this (J) are numbers of binary64."""
_OF_DIMENSION = (
    (),
    ("local", "local_rest", "length", "late"),
    ("x1", "x2"),
    ("v1", "v2", "speed"),
    ("friction", "viscous", "force", "force_2", "belt", "wall", "ledger"),
)
_DIMENSION = {name: index for index, names in enumerate(_OF_DIMENSION) for name in names}
DIMENSION = np.array([_DIMENSION.get(name.removesuffix("_error"), 0) for name in AT])
"""Of each column: 0 none, 1 time, 2 length, 3 speed, 4 energy; of bounds, that of their number."""


def factors_of(units: Any) -> Any:
    """Return what brings numbers of each DIMENSION into SI units, (n, 5, 2), from the exponents of units (n, 3).

    A unit of mass is 2^mass kg, and so on. Two factors each: a power may be too large for a float, its root is not.
    """
    mass, time, length = np.transpose(units).astype(np.intc)
    exponents = np.stack([0 * time, time, length, length - time, mass + 2 * length - 2 * time], axis=-1)
    with np.errstate(all="ignore"):  # energies may be out of range, which `finish` finds
        return np.ldexp(1.0, np.stack([exponents // 2, (exponents + 1) // 2], axis=-1))


@compilable_with(forceinline=False)
def finish(rows: Any, ends: Any, factors: Any) -> None:
    """Bring runs, their rows (n, k, ROW) and the rows of their ends (n, END_ROW), into other units; exact.

    UNKNOWN is how a run ends of which a number, or an energy on the way, is not finite then; a ledger may be nan.
    """
    for run in range(len(ends)):
        most, is_finite, count = 1.0, True, min(int(ends[run, _ROWS]), rows.shape[1])
        for n in range(count + 1):
            row = rows[run, n] if n < count else ends[run]
            for k in range(len(row)):
                if _X1 <= k <= _V2:
                    most = max(most, abs(row[k]))
                one, two = factors[run, DIMENSION[k]]
                row[k] = row[k] * one * two
                is_finite = is_finite and (math.isfinite(row[k]) or (k >= _FRICTION and math.isnan(row[k])))
        energy = most * factors[run, -1, 0] * (most * factors[run, -1, 1])
        if not (is_finite and energy <= _LARGEST):
            ends[run, _HOW] = UNKNOWN


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
