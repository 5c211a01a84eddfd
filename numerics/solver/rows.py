"""A chunk of a batch: every row of SI numbers to its end, by compiled code, or scene by scene."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import suppress
from functools import partial
from typing import Any

import numpy as np

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.compiled import can_compile, compiled
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.pair import nearest
from numerics.errors import EventUndecided, OutOfRange
from numerics.free.engine import scene_row
from numerics.free.rows import solve_rows
from numerics.linear.batch import Columns, run_prepared, run_rows
from numerics.linear.pieces import starts_of
from numerics.linear.prepare import prepare
from numerics.linear.record import AT, ROW, How
from numerics.scene import Friction, Law, Scene
from numerics.scene.plane import PlaneScene
from numerics.tasks import available_cores
from numerics.trajectory.columns import STATE, Floats
from numerics.trajectory.run import free_scene, run_scene
from numerics.trajectory.trajectory import Trajectory

_CHUNK = 4096
"""Scenes in a chunk at most: their rows fit into a core's cache."""
_TOO_FEW = 256
"""Scenes that one thread solves before another has started."""
_FLOAT64, _DIGITS = Float64(), 68
"""Where friction depends on the state a batch, too, is solved in balls, of so many digits."""


def of_one_kind(given: Any) -> Any:
    """Return what was given as a list of scenes of one kind. Raises TypeError."""
    kept = list(given) if isinstance(given, Iterable) else [given]
    if not isinstance(given, Iterable) or not all(isinstance(one, Scene | PlaneScene) for one in kept):
        raise TypeError("solve_scenes takes a list of Scenes, or of PlaneScenes; for one scene there is solve")
    kinds = {f"{one.pair.axes} axes" if isinstance(one, PlaneScene) else "one line" for one in kept}
    if len(kinds) > 1:
        raise TypeError(
            f"these scenes have {' and '.join(sorted(kinds))}; solve those of each kind in a call of its own"
        )
    return kept


def frictions_of(friction: Friction) -> Floats:
    """Return the pieces of a friction without weakening as linear/batch.py reads them."""
    pieces = [(*nearest(start), *nearest(b)) for start, b in friction.pieces]
    first = [] if pieces and pieces[0][0] == 0.0 else [(0.0, 0.0, np.nan, 0.0)]
    return np.array([*first, *pieces])


def solve_columns(columns: Columns, literal: bool, max_events: int, kept: Floats, ends: Floats) -> None:
    """Solve rows by compiled code, each by the engine that it needs; what is in doubt keeps the `how` that it had."""
    # those of the free pair: a1 = 0 and no force
    free = (columns.table[:, -2] == 0) & (len(columns.frictions) == 1 and bool(np.isnan(columns.frictions[0, 2])))
    free &= ~columns.polynomial.any(axis=1) & ~columns.sines[:, :, 0].any(axis=1)
    for its in (free, ~free):
        if its.any():
            rows = slice(None) if its.all() else its
            own = columns.part(rows)
            if its is free:
                _on(rows, kept, ends, partial(compiled(solve_rows), own.table, literal, max_events))
            else:
                _on(rows, kept, ends, partial(run_rows, own, literal, max_events, False))


def solve_prepared(scenes: Sequence[Scene], max_events: int, kept: Floats, ends: Floats) -> None:
    """Do the same for scenes: those of the free pair at once, and those of one pair under like forces."""
    alike: dict[object, list[tuple[int, Any]]] = {}
    before: Scene | None = None
    for row, scene in enumerate(scenes):
        if free_scene(scene):
            numbers = scene_row(scene)
            if numbers is not None:
                alike.setdefault(scene.law, []).append((row, numbers))
        elif not scene.friction.weakening:
            with suppress(OutOfRange):
                one, before = prepare(scene, wide=False, before=before), scene
                alike.setdefault((id(one.pair), id(one.tables)), []).append((row, one))
    for kind, group in alike.items():
        rows, given = zip(*group, strict=True)
        run = partial(run_prepared, given)
        if isinstance(kind, Law):
            run = partial(compiled(solve_rows), np.array(given), kind is Law.THREE_VALUED_SGN)
        _on([*rows], kept, ends, partial(run, max_events))


def _on(rows: Any, kept: Floats, ends: Floats, run: Callable[[Floats, Floats], None]) -> None:
    """Run some of the rows."""
    own = kept[rows], ends[rows]
    run(*own)
    kept[rows], ends[rows] = own


def form_ledgers(columns: Columns, how: tuple[bool, int], jobs: int | None, ends: Floats) -> None:
    """Run once more the rows of which nobody has formed what friction and viscosity took."""
    left_out = np.flatnonzero(np.isnan(ends[:, AT["friction"]]) & (ends[:, AT["how"]] < How.OUT_OF_RANGE))

    def form(part: slice) -> int:
        rows = left_out[part]
        own = ends[rows]
        run_rows(columns.part(rows), *how, True, np.empty((len(rows), 1, ROW)), own)
        ends[rows] = own
        return len(rows)

    list(in_chunks(form, len(left_out), jobs))


def in_chunks(task: Callable[[slice], int], count: int, jobs: int | None) -> Iterator[int]:
    """Yield what a task says of each chunk of rows, as they finish; compiled code runs in threads, Python in turn.

    There are four chunks for every core, so that all end at about the same time.
    """
    cores = jobs or available_cores()
    size = max(_TOO_FEW, min(_CHUNK, -(-count // (4 * cores))))
    parts = [slice(start, start + size) for start in range(0, count, size)]
    if cores == 1 or len(parts) <= 1 or not can_compile():
        yield from map(task, parts)
        return
    pool = ThreadPoolExecutor(min(cores, len(parts)))
    try:
        for future in as_completed([pool.submit(task, part) for part in parts]):
            yield future.result()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def solve_one(scene: Scene, max_events: int, kept: Floats, end: Floats) -> None:
    """Solve one scene, and write its first events and its end; their times count from the start of the run."""
    in_balls = bool(scene.friction.weakening)
    try:
        found = run_scene(scene, Ball(_DIGITS) if in_balls else _FLOAT64, max_events)
    except (EventUndecided, OutOfRange) as error:
        kept[:] = end[:] = np.nan  # also what a run wrote, in units of its own, before it ended so
        end[AT["how"]] = How.OUT_OF_RANGE if isinstance(error, OutOfRange) else How.DOUBT
        end[AT["mode"]] = end[AT["events"]] = end[AT["certain"]] = 0.0
        return
    rows = np.append(0, found.event_rows)[: len(kept)]
    if in_balls:
        _write_balls(found, rows, kept, end)
    else:
        kept[: len(rows)], end[:] = found.record.rows[rows], found.record.end
    for row in (*kept[: len(rows)], end):
        row[AT["local"]] += starts_of(scene)[int(row[AT["piece"]])]
        row[AT["piece"]] = 0.0


def _write_balls(found: Trajectory, rows: Floats, kept: Floats, end: Floats) -> None:
    """Write rows and the end of a run in balls as floats: the middles, and as bounds radii and rounding."""
    record, late = found.record, AT["late"]
    with found.arithmetic.context():
        taken = float(found.ledger.friction), float(found.ledger.viscous)
        end[ROW:] = record.how, record.events, 1.0, taken[0], 0.0, taken[1], 0.0, 2.0**-50 * sum(taken)
        for row, knot in zip((*kept[: len(rows)], end), (*map(record.rows.__getitem__, rows), record.end), strict=True):
            row[:ROW], row[AT["excess"] : late] = 0.0, np.nan
            row[AT["mode"]], row[AT["piece"]], row[AT["excess_error"]] = knot.mode, knot.piece, np.nan
            for place, name in enumerate(("local", *STATE)):
                value = getattr(knot, name)
                row[AT[name]] = float(value.mid())
                row[late + place] = float(value.rad()) + abs(row[AT[name]]) * 2.0**-52
