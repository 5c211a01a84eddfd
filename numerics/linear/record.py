"""What a run leaves behind: a row for the start of every segment, and one for the end.

Both engines write it and everything else reads it. A segment starts at the start of the run, at an event, or where a
piece of force or friction begins. In float64 rows are arrays of floats, in other arithmetics they are `Knot`s. SI
units; every number is that of its arithmetic, for balls an enclosure of the true one.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

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
END = ("how", "events", "friction", "viscous", "force", "force_2", "belt", "wall", "ledger_error")
"""What the row of the end has after these: a `How`, the number of events; and, nan until somebody asks (ledger.py),
what friction and damper took, what forces on body 1 and 2, belt and wall gave (J), and a bound on the error of all
these."""
AT = {name: index for index, name in enumerate((*COLUMNS, *END))}
"""The index of each column."""
ROW, END_ROW = len(COLUMNS), len(COLUMNS) + len(END)
UNKNOWN = -1
"""How a row of a batch ended that compiled code leaves to a run of its own."""


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
