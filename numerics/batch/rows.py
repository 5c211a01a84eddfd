"""A chunk of a batch: every row of SI numbers to its end, in one compiled call."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.arithmetic.telling import can_compile, text
from numerics.errors import OutOfRange
from numerics.motion.begin import begin
from numerics.motion.codes import OUT_OF_RANGE
from numerics.run.families import run_telling
from numerics.run.row import solve_row, solve_start
from numerics.scene import Scene
from numerics.trajectory.record import end_length, row_length

Table = NDArray[np.float64]
UNKNOWN = -1.0
"""How a row ended that must be converted exactly."""


class Chunk(NamedTuple):
    """Rows of scenes (n, 20) as halves, what stands behind each of them, and where the answers go."""

    table: Table
    exact: Any
    """exact(i) returns the scene of row i."""
    ends: Table
    kept: Table
    literal: bool
    max_events: int


@text
def solve_rows(table: Any, literal: bool, most: int, kept: Any, ends: Any) -> None:
    """Solve every row, keep its first events in `kept` and its end in `ends`; UNKNOWN where it must be exact."""
    for index in range(len(table)):
        count = solve_row(table[index], literal, most, kept[index], ends[index])
        if count < 0:
            ends[index][0] = UNKNOWN


def solve_chunk(chunk: Chunk) -> int:
    """Solve a chunk and return how many scenes it has."""
    damped = chunk.table[:, -2] > 0
    if damped.all() or not damped.any():
        _solve(chunk.table, chunk.kept, chunk.ends, chunk, bool(len(damped) and damped[0]))
    else:
        for is_damped in (False, True):
            rows = np.flatnonzero(damped == is_damped)
            kept, ends = chunk.kept[rows], chunk.ends[rows]
            _solve(chunk.table[rows], kept, ends, chunk, is_damped)
            chunk.kept[rows], chunk.ends[rows] = kept, ends
    unknown = chunk.ends[:, 0] == UNKNOWN
    if unknown.any():
        for index in np.flatnonzero(unknown):
            _solve_exactly(chunk.exact(index), chunk, chunk.kept[index], chunk.ends[index])
    return len(chunk.table)


def _solve(table: Table, kept: Table, ends: Table, chunk: Chunk, is_damped: bool) -> None:
    """Solve rows of one kind."""
    telling = run_telling(FLOAT64, is_damped=is_damped)
    fast = telling.compiled(solve_rows)
    if fast is not telling(solve_rows):
        fast(table, chunk.literal, chunk.max_events, kept, ends)
        return
    for row, rows, end in zip(table.tolist(), kept, ends, strict=True):
        plain = end.tolist()
        try:
            if telling(solve_row)(row, chunk.literal, chunk.max_events, rows, plain) < 0:
                plain[0] = UNKNOWN
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            plain[0] = OUT_OF_RANGE
        end[:] = plain


def _solve_exactly(scene: Scene, chunk: Chunk, rows: Table, end: Table) -> None:
    """Solve one scene from its exact numbers."""
    telling = run_telling(FLOAT64, is_damped=scene.pair.a1 > 0)
    try:
        begun = begin(scene, Float64())
        if can_compile():
            telling.compiled(solve_start)(*begun, chunk.max_events, rows, end)
        else:
            plain = end.tolist()
            telling(solve_start)(*begun, chunk.max_events, rows, plain)
            end[:] = plain
    except (OutOfRange, ArithmeticError, ValueError):
        end[:] = np.nan
        end[0] = OUT_OF_RANGE


def room(count: int, keep: int) -> tuple[Table, Table]:
    """Return the arrays for the ends of so many runs and for the first events of each, nan where there are none."""
    return np.zeros((count, end_length(1))), np.full((count, keep, row_length(1)), np.nan)
