"""Scenes on a line: chunk by chunk every one to its end, by compiled code or one by one, and what their rows answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import can_compile, compiled
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.precision import is_held
from numerics.errors import EventUndecided, OutOfRange
from numerics.linear.batch import Columns
from numerics.linear.errors_of import errors_of_rows
from numerics.linear.ledger import TINY
from numerics.linear.pieces import starts_of
from numerics.linear.record import AT, BOUNDS, END_ROW, ROW, UNKNOWN, How
from numerics.meter import meter
from numerics.scene import Scene
from numerics.solver.batch import Batch
from numerics.solver.inputs import floats_of
from numerics.solver.solve import solve
from numerics.tasks import available_cores
from numerics.trajectory.columns import STATE, Counts, Floats, room
from numerics.trajectory.digits import FEW_DIGITS, ROUNDING
from numerics.trajectory.events import taken_in
from numerics.trajectory.rendering import MOST_DIGITS
from numerics.trajectory.run import run_scene
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory

_CHUNK = 128
"""Scenes in a chunk: what it takes to begin one does not show beside them, and an interruption waits for its end."""
_DRAWN = ("dissipated", "energy_excess", "events", "mode", "digits", "t", *STATE)
_SENTENCES = np.array([one.sentence for one in sorted(Status)], dtype=object)
_TAKEN = AT["friction"]
_FLOAT64 = Float64()


Progress = Callable[[int, int], None]


class BatchLimits(NamedTuple):
    """What bounds a batch, and how it is worked on."""

    max_events: int
    keep_events: int
    jobs: int | None


class Work(NamedTuple):
    """The scenes of a batch, each by its place, with their SI numbers (n, 10), and the shape of all answers.

    Where compiled code solves them, their columns. `walls` says where a wall moves. Rows (record.py) are of ends, and
    of start and first events; in these the time counts from the start of the run.
    """

    scene_of: Callable[[int], Scene]
    limits: BatchLimits
    shape: tuple[int, ...]
    numbers: Floats
    walls: Any = np.False_
    columns: Columns | None = None
    goes_on: bool = True
    """Whether a scene that float64 leaves open goes on in balls."""

    def batch(self, inputs: Callable[[], dict[str, Any]], progress: Progress | None) -> Batch:
        """Solve all scenes; return what forms their answers when they are looked at."""
        kept, ends = self.solved(progress)
        return Batch(self.shape, _DRAWN, inputs, partial(self.answers, kept, ends), partial(self.taken, ends))

    def solved(self, progress: Progress | None) -> tuple[Floats, Floats]:
        """Return the rows of first events and those of ends; what compiled code leaves is solved one by one."""
        count = len(self.numbers)
        what = f"{count} scenes with keep_events = {self.limits.keep_events}"
        kept, ends, done = room(what, count, self.limits.keep_events + 1, ROW), room(what, count, END_ROW), 0
        kept[:], ends[:] = np.nan, 0.0

        def solve(part: slice) -> int:
            hows = ends[part, AT["how"]]
            hows[:] = UNKNOWN
            if self.columns is not None:
                self.columns.follow(part, self.limits.max_events, kept[part], ends[part])
            for row in part.start + np.flatnonzero(hows == UNKNOWN):
                solve_one(self.scene_of(int(row)), self.limits.max_events, kept[row], ends[row], self.goes_on)
            return len(hows)

        with meter("solving", progress, ticks=count > 1) as line:
            for some in in_chunks(solve, count, self.limits.jobs, self.columns.at_once if self.columns else _CHUNK):
                done += some
                if line is not None:
                    line(done, count)
        return kept, ends

    def form_ledgers(self, ends: Floats) -> None:
        """Run once more the rows of which nobody has formed what was taken and given; by compiled code if it can."""

        def form(columns: Columns, part: slice) -> int:
            some = part.start + _without_ledger(ends[part])
            own = ends[some]
            if len(some):
                columns.take(some, self.limits.max_events, own)
            held = own[:, AT["how"]] != UNKNOWN  # what was taken may be more than floats hold
            ends[some[held], _TAKEN:] = own[held, _TAKEN:]
            return len(some)

        if self.columns is not None:
            list(in_chunks(partial(form, self.columns), len(ends), self.limits.jobs, self.columns.at_once))
        for row in _without_ledger(ends):
            run = run_scene(self.scene_of(int(row)), _FLOAT64, self.limits.max_events)
            ends[row, _TAKEN:] = taken_in(run, range(len(run.row_lengths)))

    def taken(self, ends: Floats) -> Floats:
        """Return what friction and viscosity took, J, and its bound, (2, *shape)."""
        self.form_ledgers(ends)
        friction, viscous, error, how = ends.T[[AT[name] for name in ("friction", "viscous", "ledger_error", "how")]]
        found = np.where(how == How.OUT_OF_RANGE, np.nan, [friction + viscous, 2.0 * error + TINY])
        return found.reshape(2, *self.shape)

    def answers(self, kept: Floats, ends: Floats) -> dict[str, Any]:
        """Return the arrays of a batch by their names, from the rows of first events and of ends."""
        shape = self.shape
        how = ends[:, AT["how"]].astype(np.int64).reshape(shape)
        out, given = how == How.OUT_OF_RANGE, (one.reshape(shape) for one in self.numbers.T)
        m1, m2, a2, b, _, v1_begun, _, v2_begun, until, _ = given

        def end(*names: str) -> Floats:
            return np.where(out, np.nan, ends.T[[AT[name] for name in names]].reshape(len(names), *shape))

        def event(*names: str) -> Floats:
            found = kept.T[[AT[name] for name in names], 1:].swapaxes(1, 2)
            return found.reshape(len(names), *shape, kept.shape[1] - 1)

        y, certain = end(*STATE), how < How.OUT_OF_RANGE
        x1, v1, _, v2 = y
        with np.errstate(all="ignore"):
            excess_error, worst = np.reshape(compiled(errors_of_rows)(self.numbers, kept, ends, ROUNDING), (2, *shape))
            right = np.clip(np.floor(-np.log10(np.maximum(worst, ROUNDING))), 0, MOST_DIGITS)
            energy = a2 * x1**2 / 2 + m1 * v1**2 / 2 + np.where(np.isinf(m2), 0.0, m2 * v2**2 / 2)
            excess = energy / ((b * (1 + m1 / m2)) ** 2 / (2 * a2)) - 1
        digits = np.where(certain, right, 0).astype(np.int64)
        status = np.where((how < How.EVENT_LIMIT) & (digits == 0), int(Status.NO_RIGHT_DIGIT), how)
        status = np.where(how == How.DOUBT, int(Status.SEQUENCE_OPEN), status)
        message, t = np.array(_SENTENCES[status], dtype=object), event("local")[0]
        moves = np.abs([v1_begun, v2_begun, *y[1::2]]).max(axis=0) > 0  # of velocities that are 0 few digits count
        few = (status <= Status.STUCK_FOR_EVER) & (digits <= FEW_DIGITS) & moves
        message[few] = [
            f"{one}; right digits: only {n}; use solve(scene, digits=N)"
            for one, n in zip(message[few], digits[few], strict=True)
        ]
        return {
            "status": status,
            "message": message,
            "events": whole(end("events")[0]),
            "mode": whole(end("mode")[0]),
            "t": np.where(how < How.EVENT_LIMIT, until, end("local")[0]),
            "y": y,
            "y_error": end(*BOUNDS[1:5]),
            "digits": digits,
            "certain": certain,
            "energy_excess": np.where((a2 * b > 0) & ~self.walls, excess, np.nan),
            "energy_excess_error": np.where(out | self.walls, np.nan, excess_error),
            "event_t": t,
            "event_y": event(*STATE),
            "event_mode": whole(event("mode")[0]),
            "event_t_error": event("late")[0] + 4 * ROUNDING * t,
            "event_y_error": event(*BOUNDS[1:5]),
        }


def whole(numbers: Floats) -> Counts:
    """Return whole numbers, 0 for nan."""
    return np.nan_to_num(numbers).astype(np.int64)


def _without_ledger(ends: Floats) -> Counts:
    """Return the rows that were solved, but of which what was taken and given is not known."""
    return np.flatnonzero(np.isnan(ends[:, _TAKEN]) & (ends[:, AT["how"]] < How.OUT_OF_RANGE))


def in_chunks(task: Callable[[slice], int], count: int, jobs: int | None, most: int = _CHUNK) -> Iterator[int]:
    """Yield what a task says of each chunk of rows, in order; compiled code runs in threads, Python in turn."""
    size = min(_CHUNK, most)
    cores = (jobs or available_cores()) if can_compile() else 1
    parts = [slice(start, start + size) for start in range(0, count, size)]
    if cores == 1 or len(parts) <= 1 or is_held():
        yield from map(task, parts)
        return
    with ThreadPoolExecutor(min(cores, len(parts))) as pool:
        yield from pool.map(task, parts)  # who stops reading cancels those that have not begun


def solve_one(scene: Scene, max_events: int, kept: Floats, end: Floats, goes_on: bool) -> None:
    """Solve one scene, and write its first events and its end; their times count from the start of the run.

    A scene that float64 leaves open or that leaves its range `goes_on` in balls, as in `solve`; what these find must
    fit in floats.
    """
    kept[:] = end[:] = np.nan  # also what compiled code wrote, in units of its own, before it left the row to this
    try:
        try:
            found = run_scene(scene, _FLOAT64, max_events)
        except (EventUndecided, OutOfRange):
            if not goes_on:
                raise
            found = solve(scene, max_events=max_events)
        rows, last = (found.record.rows, found.record.end) if found.bounded else _in_floats(found)
    except (EventUndecided, OutOfRange) as error:
        end[AT["how"]] = How.OUT_OF_RANGE if isinstance(error, OutOfRange) else How.DOUBT
        end[AT["mode"]] = end[AT["events"]] = 0.0
        return
    at = [0, *np.flatnonzero(rows[:, AT["event"]])[: len(kept) - 1]]
    kept[: len(at)], end[:] = rows[at], last
    for row in (*kept[: len(at)], end):
        row[AT["local"]] += starts_of(scene)[0, int(row[AT["piece"]])]
        row[AT["piece"]] = 0.0
    if scene.changes_later and found.record.how == How.STUCK:
        end[AT["how"]] = How.REACHED


def _in_floats(found: Trajectory) -> tuple[Floats, Floats]:
    """Return rows and the end of a run in balls as floats, with their distances from the true numbers as bounds.

    Raises OutOfRange where floats do not hold them.
    """
    record, names, late = found.record, ("local", *STATE), AT["late"]
    knots = (*record.rows, record.end)
    table = np.zeros((len(knots), END_ROW))
    table[:, : AT["cell"]] = [one[: AT["cell"]] for one in knots]
    with found.context():
        near, off = floats_of([[getattr(one, name) for name in names] for one in knots])
        took, error = floats_of([found.ledger.friction, found.ledger.viscous, found.ledger.work])
    table[:, [AT[name] for name in names]], table[:, late : late + len(names)] = near, off
    table[-1, ROW:] = record.how, record.events, len(record.rows), *took, 0.0, 0.0, 0.0, error.sum()
    if not (np.isfinite(table).all() and np.isfinite(floats_of(found.energy)).all()):
        raise OutOfRange("a number of this scene does not fit in float64; solve(scene) has it in balls")
    return table[:-1, :ROW], table[-1]
