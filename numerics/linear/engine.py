"""The engine: any scene, solved once in one arithmetic, as a Record.

float64 runs the compiled kernel (kernel.py), balls the loop of enclosed.py. Where the kernel is in doubt the run starts
again from what is known exactly: ties, touches, jumps that meet an event.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.compiled import compiled
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import EventUndecided, InvalidScene, OutOfRange
from numerics.linear.cells import Cells
from numerics.linear.exact_start import ExactKnot, exact_knots
from numerics.linear.kernel import TOO_MANY, Log, follow_all
from numerics.linear.ledger import TINY, ledger
from numerics.linear.model import Norm
from numerics.linear.prepare import Prepared, halves, prepare, rounded
from numerics.linear.record import AT, CODES, END_ROW, ROW, UNKNOWN, How, Record, factors_of, finish
from numerics.linear.room import space_for
from numerics.linear.table import ORDERS, UNIT
from numerics.scene import Scene

Progress = Callable[[int, float], None]
_HOWS = tuple(How)
_MOST_ORDER = ORDERS - 1
"""Derivatives of a guard that may vanish at an exact start."""
_STATE = slice(AT["x1"], AT["x1"] + 4)
_OF_EXACT = [AT[name] for name in ("order", "event", "jump", "length")]
"""What the kernel does not know of a start that is exact."""


def run_linear(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene once, at the arithmetic's working precision. Raises EventUndecided, OutOfRange."""
    if isinstance(arithmetic, Float64):
        return run_floats(scene, max_events, progress)
    if not isinstance(arithmetic, Ball):
        raise InvalidScene(
            f'{arithmetic.name} solves the free pair only (a1 = 0, no force, constant b); use arithmetic="ball"'
        )
    from numerics.linear.enclosed import run_enclosed

    return run_enclosed(scene, arithmetic, max_events, progress)


def run_floats(scene: Scene, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene in float64. Raises EventUndecided, OutOfRange."""
    prepared, how = prepare(scene), int(How.DOUBT)
    if prepared.cells is None:
        how, rows, end = _run(prepared, prepared.starts, -1.0, max_events)
    if how == How.DOUBT:
        known = exact_knots(scene, prepared.pieces)
        if prepared.cells or len(known) > 1 or known[-1].order > 0 or known[-1].quiet > known[-1].local:
            how, rows, end = _from_exact(prepared, known, max_events)
    end[AT["how"]] = how
    _require_answer(how, prepared, end)
    if progress is not None:
        progress(int(end[AT["events"]]), 1.0)
    compiled(finish)(rows[None], end[None], prepared.to_si)
    if end[AT["how"]] == UNKNOWN:
        raise OutOfRange.of("a position, a velocity or an energy on the way", "float64")
    return Record(rows, end, _HOWS[how], int(end[AT["events"]]))


def taken_of_floats(scene: Scene, record: Record) -> tuple[NDArray[np.float64], list[int]]:
    """Return what was taken and given in a run in float64 (model.TAKEN), J, and a bound on the error of each, (7,).

    Without the rows, returned too, whose segments are too long for steps.
    """
    prepared = prepare(scene)
    (mass, time, length), rows, ends = prepared.units, record.rows[None].copy(), record.end[None].copy()
    ends[0, AT["how"]], ends[0, AT["rows"]] = record.how, len(record.rows)  # it may be a part of a run
    compiled(finish)(rows, ends, factors_of([[-mass, -time, -length]]))
    problems, taken, is_long = prepared.problems, np.zeros((1, 7)), np.zeros(rows.shape[:2], dtype=bool)
    compiled(ledger)(problems, space_for(problems.tables), rows, ends, taken, is_long)
    found = np.ldexp(taken[0], mass + 2 * length - 2 * time)
    found[6] += TINY if taken[0, 6] > 0.0 else 0.0
    return found, np.flatnonzero(is_long[0]).tolist()


def _run(
    prepared: Prepared, starts: NDArray[np.float64], clear: float, most: int
) -> tuple[int, NDArray[np.float64], NDArray[np.float64]]:
    """Return how the kernel ended, its rows, and the row of the end."""
    problems, room, ends = prepared.problems, prepared.room(most), np.zeros((1, END_ROW))
    while True:
        rows = np.empty((1, room, ROW))
        try:
            compiled(follow_all)(problems, space_for(problems.tables), starts, clear, Log(rows, ends, most, True))
        except (ZeroDivisionError, OverflowError, ValueError):  # plain Python has no nan to carry on with
            return How.OUT_OF_RANGE, rows[0, :0], ends[0]
        how, count = int(ends[0, AT["how"]]), int(ends[0, AT["rows"]])
        if count <= room:
            return how, rows[0, :count], ends[0]
        room = count


def _from_exact(
    prepared: Prepared, known: Sequence[ExactKnot], most: int
) -> tuple[int, NDArray[np.float64], NDArray[np.float64]]:
    """Return the run from the last start that is known exactly, the exact ones before it."""
    events = [index for index, one in enumerate(known) if one.is_event]
    is_cut = len(events) > most
    if is_cut:
        known = known[: events[most - 1] + 1]
    rows, last = _exact_rows(prepared, known), known[-1]
    order = int(rows[-1, AT["order"]])
    if not is_cut and abs(order) > _MOST_ORDER and not last.quiet > last.local:
        return How.DOUBT, rows[:0], np.zeros(END_ROW)
    starts = np.zeros((1, END_ROW))
    start = starts[0]
    start[:ROW] = rows[-1]
    if is_cut:
        start[ROW:] = np.nan  # nobody has formed the ledger yet
        start[AT["events"]], start[AT["rows"]] = most, len(rows)
        return How.EVENT_LIMIT, rows, start
    start[AT["order"]], start[AT["jump"]] = min(order, _MOST_ORDER), 0.0
    how, found, end = _run(prepared, starts, halves(last.quiet, prepared.units.time)[0], most - len(events))
    found[:1, _OF_EXACT] = rows[-1, _OF_EXACT]
    piece = prepared.pieces[-1]
    if how == How.REACHED and last.mode == 0 and last.quiet == piece.length and len(piece.polynomial) <= 1:
        how = How.STUCK if last.piece + 1 == len(prepared.pieces) else how  # what holds it there holds it later, too
    end[AT["events"]], end[AT["rows"]] = end[AT["events"]] + len(events), len(rows) - 1 + len(found)
    return how, np.concatenate([rows[:-1], found]), end


def _exact_rows(prepared: Prepared, known: Sequence[ExactKnot]) -> NDArray[np.float64]:
    """Return the rows of starts that are known exactly, in the kernel's units; their states are rounded once."""
    rows, units, cells = np.zeros((len(known), ROW)), prepared.units, prepared.cells
    times, speed = [prepared.pieces[one.piece].start + one.local for one in known], units.of(length=1, time=-1)
    for row, one, t, before in zip(rows, known, times, [times[0], *times], strict=False):
        cell, (floor, ceiling) = 0 if cells is None else _begun(cells, one), one.orders
        row[: len(CODES)] = one.mode, floor or -ceiling, one.is_event, one.is_jump, one.piece, cell
        row[AT["local"] : AT["length"]] = halves(one.local, units.time)
        row[AT["length"]] = rounded(t - before, units.time)
        state = (form.rounded(256) for form in one.state)
        row[_STATE] = [rounded(x, unit) for x, unit in zip(state, [units.length, speed] * 2, strict=True)]
    rows[:, AT["x1_error"] : AT["speed_error"]] = UNIT * np.abs(rows[:, _STATE])
    norm, (x1, v1, _, v2) = Norm(*prepared.problems.norms[0]), rows[:, AT["x1_error"] : AT["speed_error"]].T
    rows[:, AT["speed_error"]] = (norm.root_a2 * x1 + norm.root_m1 * v1 + norm.root_m2 * v2) / norm.root_m1
    return rows


def _begun(cells: Cells, knot: ExactKnot) -> int:
    """Return where in `all` the cell of an exact knot is. Raises OutOfRange if friction may vanish there."""
    if not all(map(cells.is_open, [knot.cell] if knot.mode else [(0, j) for j in cells.begun])):
        raise OutOfRange('friction may vanish in the cell in which this run begins; use arithmetic="ball"')
    return cells.all.index((knot.mode, knot.cell)) if knot.mode else len(cells.all) - 1


def _require_answer(how: int, prepared: Prepared, end: NDArray[np.float64]) -> None:
    """Raise what says why a run could not go on."""
    if how <= How.EVENT_LIMIT:
        return
    if how == How.OUT_OF_RANGE:
        raise OutOfRange('a number of this scene left the range of float64 on the way; use arithmetic="ball"')
    local = np.ldexp(end[AT["local"]], prepared.units.time)
    at = float(prepared.pieces[int(end[AT["piece"]])].start) + local
    if how == TOO_MANY:
        raise OutOfRange(
            f"the mode at t = {at:.6g} s would take more than 400000 steps; shorten the horizon, leave a fast sine "
            'out, start exactly on the tie that is next to this start, or use arithmetic="ball"'
        )
    if how == How.DOUBT:
        raise EventUndecided(
            "which event comes next under this force, or does its guard only touch?",
            f"after t = {at:.6g} s",
            15,
        )
