"""From the rows that kernels write to a Trajectory: events, motions and segments are made when they are looked at."""

from __future__ import annotations

import sys
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.kernel.compilation import can_compile, compiled
from numerics.kernel.packed import ANSWER, HORIZON, HOW
from numerics.kernel.state import EVENT_LIMIT, OUT_OF_RANGE, ROWS_FULL, STUCK, Bounds, End
from numerics.motion.frame import Frame
from numerics.motion.modes import event_kind
from numerics.old.motion import Motion
from numerics.scene import Scene
from numerics.trajectory.deferred import Deferred
from numerics.trajectory.trajectory import Event, Segment, Status, Trajectory

Table = NDArray[np.float64]
Progress = Callable[[int, float], None]
_ROWS, _FIRST_ROWS = 2048, 256


def written_rows(
    advance: Callable[..., int],
    state: Table,
    how: int,
    columns: int,
    max_events: int,
    told: Callable[[Table, int], None] | None,
) -> Table | None:
    """Run a packed state to its end, which its column `how` tells, and return all rows; None if it left the range.

    numba takes a second to come, so the first rows are left to Python unless it is here already. `told(row, count)` is
    called now and then with the last row so far.
    """
    kept: list[Table] = []
    while True:
        fast = can_compile() and (bool(kept) or "numba" in sys.modules)
        rows = np.empty((min(max_events + 1, _ROWS if fast else _FIRST_ROWS), columns))
        try:
            count = compiled(advance)(state, max_events, rows) if fast else _plainly(advance, state, max_events, rows)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            return None
        kept.append(rows[:count])
        if state[how] != ROWS_FULL:
            break
        if told is not None:
            told(rows[count - 1], sum(map(len, kept)))
    return None if state[how] == OUT_OF_RANGE else np.concatenate(kept)


def _plainly(advance: Callable[..., int], state: Table, max_events: int, rows: Table) -> int:
    """Advance a row by plain Python, on plain floats: NumPy's own are slower, and warn where those raise."""
    plain = state.tolist()
    count = advance(plain, max_events, rows)
    state[:] = plain
    return count


def answered(answer: Callable[..., None], state: Table, length: int) -> list[float] | None:
    """Return the answer of a state that is at its end; None if a number of it left the range."""
    end = [0.0] * length
    try:
        answer(state.tolist(), end)
    except (ArithmeticError, ValueError):
        return None
    return end


class KernelRun(ABC):
    """What a run wrote, turned into events, motions and segments one by one, where somebody asks for them."""

    def __init__(self, scene: Scene, frame: Frame, motion: Motion, rows: Table, state: Table) -> None:
        """Keep the rows, the state at the end and the first motion."""
        self.scene, self.frame, self.rows, self.state = scene, frame, rows, state
        self._motions: dict[int, Motion] = {0: motion}

    @abstractmethod
    def number(self, index: int, name: str) -> Number:
        """Return a number of a row, exactly."""

    @abstractmethod
    def motion_after(self, index: int) -> Motion:
        """Return the motion that an event starts."""

    @abstractmethod
    def last_stretch(self) -> tuple[Number, Number]:
        """Return the reduced horizon, and how long the last motion lasts up to it."""

    def motion(self, index: int) -> Motion:
        """Return a motion: the first, or the one that event index - 1 starts."""
        if index not in self._motions:
            with self.frame.arithmetic.context():
                self._motions[index] = self.motion_after(index - 1)
        return self._motions[index]

    def segment(self, index: int) -> Segment:
        """Return a segment; the last one, after all events, ends at the horizon."""
        start = self.number(index - 1, "tau") if index else self.frame.arithmetic.number(0)
        if index < len(self.rows):
            return Segment(self.motion(index), start, self.number(index, "tau"), self.number(index, "length"))
        return Segment(self.motion(index), start, *self.last_stretch())

    def event(self, index: int) -> Event:
        """Return an event."""
        before, after = self.motion(index), self.motion(index + 1)
        with self.frame.arithmetic.context():
            t, y = self.frame.si_time(self.number(index, "tau")), self.frame.si_state(after.start)
        return Event(t, event_kind(before.mode, after.mode), before.mode, after.mode, y, after.start)

    def trajectory(self, how: float, bounds: Bounds) -> Trajectory:
        """Return the trajectory of a run that ended so (the codes of kernel/state.py)."""
        endings: dict[int, Any] = {STUCK: Status.STUCK_FOR_EVER, EVENT_LIMIT: Status.EVENT_LIMIT}
        status, events = endings.get(int(how), Status.REACHED_HORIZON), len(self.rows)
        segments = Deferred(self.segment, events + (status is not Status.EVENT_LIMIT))
        return Trajectory(self.scene, self.frame, segments, Deferred(self.event, events), status, bounds=bounds)


class FloatRun(KernelRun):
    """The rows of a binary64 run, undamped or viscous; `columns` names what they hold, `start` unpacks the last one."""

    columns: tuple[str, ...]
    start: Callable[[list[float]], Any]

    def number(self, index: int, name: str) -> float:
        """Return a number of a row."""
        return float(self.rows[index, self.columns.index(name)])

    def last_stretch(self) -> tuple[float, float]:
        """Return the reduced horizon, and how long the last motion lasts up to it."""
        horizon, start = float(self.state[HORIZON]), type(self).start(self.state.tolist())
        return horizon, (horizon - start.tau) - start.rest


def solved_in_floats(
    run: type[FloatRun],
    start: tuple[Scene, Frame, Motion, Table],
    kernels: tuple[Callable[..., int], Callable[..., None]],
    length: int,
    max_events: int,
    progress: Progress | None,
) -> Trajectory | None:
    """Return the trajectory that the kernels (advance, answer) find from a start, None if a number leaves the range.

    An answer of `length` numbers is that of packed.py; what is longer ends in the error of the viscous loss.
    """
    state, columns, (advance, answer) = start[-1], run.columns, kernels
    tau, horizon = columns.index("tau"), float(state[HORIZON])
    told = None if progress is None else lambda row, count: progress(count, row[tau] / horizon)
    rows = written_rows(advance, state, HOW, len(columns), max_events, told)
    end = None if rows is None else answered(answer, state, length)
    if rows is None or end is None:
        return None
    numbers, errors = end[: len(End._fields)], slice(columns.index("late"), columns.index("place") + 1)
    found = End._make([int(numbers[0]), *numbers[1:-1], bool(numbers[-1])])
    bounds = Bounds(rows[:, errors], found, end[-1] if length > ANSWER else 0.0)
    scene, frame, motion, _ = start
    return run(scene, frame, motion, rows, state).trajectory(state[HOW], bounds)
