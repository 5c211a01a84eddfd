"""The ledger of a run in float64: what friction and damper took, and what forces, belt and wall gave, J.

Powers are products of two rows of z (model.TAKEN), integrated over every step of a segment by Gauss's rule, and asked
for after a run only: most runs are not.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with, inlined
from numerics.arithmetic.pair import pair_of, plus, put, two_product
from numerics.linear.first_root import value_slope
from numerics.linear.kernel import EVENT_LIMIT, OUT_OF_RANGE
from numerics.linear.model import V1, V2, X1, X2, Norm
from numerics.linear.record import AT
from numerics.linear.room import Problems, Run, dot, enter, form_z, has_cells, meeting, polynomial_of, run_of, size_of
from numerics.linear.table import LINES, POWERS, STATE, UNIT

NODES, WEIGHTS = (np.polynomial.legendre.leggauss(20)[0] + 1.0) / 2.0, np.polynomial.legendre.leggauss(20)[1] / 2.0
"""Of Gauss's rule on [0, 1]: exact up to degree 39, and what a step has beyond that is below rounding, in `parts`."""
TINY = 2.0**-1060
"""More than energies can lose below the normal numbers, J."""
LONG = 256.0
"""Segments of more steps are left to an enclosure (trajectory/events.py)."""
_MODE, _PIECE, _CELL, _LOCAL, _REST = (AT[name] for name in ("mode", "piece", "cell", "local", "local_rest"))
_LENGTH, _X1, _LATE, _X1_ERROR, _ERROR = (AT[name] for name in ("length", "x1", "late", "x1_error", "speed_error"))
_HOW, _ROWS = AT["how"], AT["rows"]


@compilable
def parts(terms: int) -> int:
    """Return into how many equal parts a step of series of so many terms is cut for Gauss's rule."""
    return 1 + (terms - 1) // 36


@compilable_with(forceinline=False)
def ledger(problems: Problems, space: Any, rows: Any, ends: Any, taken: Any, is_long: Any) -> None:
    """Add to `taken` (n, 7) what is TAKEN in runs, from their rows (n, k, ROW) and ends, and a bound on all errors.

    A segment that is too long for steps is left out, and marked in `is_long` (n, k).
    """
    for one in range(len(ends)):
        run, end, found = run_of(problems, one, space), ends[one], taken[one]
        count = int(end[_ROWS]) - (1 if end[_HOW] == EVENT_LIMIT else 0)
        for k in range(count + 1 if end[_HOW] < OUT_OF_RANGE else 0):
            row = rows[one, k] if k < count else end
            found[6] += at_event(run, row)  # which starts from there
            if k == count:
                break
            after = rows[one, k + 1] if k + 1 < count else end
            piece, mode = int(row[_PIECE]), int(row[_MODE])
            here = piece, mode, run.drive.places[piece, 0] + int(row[_CELL])
            h, left, N = run.tables.steps[here[2], 1 if mode == 0 else 0], after[_LENGTH], off_in(run, after)
            is_long[one, k] = left > LONG * h
            while left > 0.0 and not is_long[one, k]:
                s = min(1.0, left / h)
                step(run, here, s, N, found)
                left = left - h if s == 1.0 else 0.0


@compilable
def off_in(run: Run, row: Any) -> float:
    """Return N of the error in a row; where friction has cells the root of m1 times what x1 - x2 is off by, if more."""
    off = row[_ERROR]
    if has_cells(run.tables, run.drive.places[0, 0]):
        off = max(off, row[_X1_ERROR] + row[_X1_ERROR + 2])
    return off * run.norm.root_m1


@inlined
def step(run: Run, here: tuple[int, int, int], s: float, N: float, taken: Any) -> None:
    """Add what is taken over a part of a step (in a piece, mode and kind), and move on by it; N of the error."""
    tables, (piece, mode, kind) = run.tables, here
    side = 1 if mode == 0 else 0
    h, powers, cut = tables.steps[kind, side], tables.lines[kind, side, POWERS:LINES], parts(tables.rows.shape[4])
    form_z(run, piece)
    enter(run, piece, mode)
    for body in range(2):
        x = X2 * body
        polynomial_of(tables.rows[kind, side, x], tables.degrees[kind, side, x], run.z, 0, run.series[body])
    begun = pair_of(run.clock[0])
    for part in range(cut):
        for n in range(NODES.shape[0]):
            place = s * (part + NODES[n]) / cut
            put(run.clock[0], plus(begun, two_product(place, h)))
            put_state(run, place, h)
            form_z(run, piece)
            enter(run, piece, mode)
            weight = WEIGHTS[n] / cut * s * h
            for k in range(6):
                one, a = factor(run.norm, powers[2 * k], run.z, run.size, N)
                two, b = factor(run.norm, powers[2 * k + 1], run.z, run.size, N)
                taken[k] += weight * one * two
                taken[6] += weight * (abs(one) * b + abs(two) * a + a * b)
    put(run.clock[0], plus(begun, two_product(s, h)))
    put_state(run, s, h)


@compilable
def put_state(run: Run, s: float, h: float) -> None:
    """Write the state from its Taylor polynomials."""
    for body in range(2):
        run.y[X2 * body], slope = value_slope(run.series[body], s)
        run.y[X2 * body + 1] = slope / h


@compilable
def at_event(run: Run, row: Any) -> float:
    """Return twice what is at most taken while it is open whether a row's event has come: its mode may be any."""
    piece, N, total = int(row[_PIECE]), off_in(run, row), 0.0
    for i in range(STATE):
        run.y[i] = row[_X1 + i]
    run.clock[0, 0], run.clock[0, 1] = row[_LOCAL], row[_REST]
    tables, kind = run.tables, meeting(run.tables, run.drive.places[piece, 0] + int(row[_CELL]), 0)
    form_z(run, piece)
    for side in range(2):
        for k in range(6):
            one, a = factor(run.norm, tables.lines[kind, side, POWERS + 2 * k], run.z, run.size, N)
            two, b = factor(run.norm, tables.lines[kind, side, POWERS + 2 * k + 1], run.z, run.size, N)
            total += 2.0 * (abs(one) + a) * (abs(two) + b)
    return float(row[_LATE] * total)


@compilable_with(forceinline=False)
def factor(norm: Norm, row: Any, z: Any, size: Any, N: float) -> tuple[float, float]:
    """Return the value of a row, and by how much it may be off."""
    return dot(row, z), reach(norm, row) * N + 32.0 * UNIT * size_of(row, size)


@compilable
def reach(norm: Norm, row: Any) -> float:
    """Return by how much a row may be off for N = 1."""
    found = (abs(row[V1]) + abs(row[X2])) / norm.root_m1
    if norm.root_a2 > 0.0:
        found += abs(row[X1]) / norm.root_a2
    if norm.root_m2 > 0.0:
        found += abs(row[V2]) / norm.root_m2
    return found
