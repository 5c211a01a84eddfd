"""One undamped scene through the double-double kernels: exact rationals in, a Trajectory with error bounds out."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.double_double import DoubleDouble, exactly
from numerics.deferred import Deferred
from numerics.errors import OutOfRange
from numerics.kernel.bounds import Errors, no_linear
from numerics.kernel.compilation import can_compile, compiled
from numerics.kernel.double_double import ZERO, Double, subtract
from numerics.kernel.double_motion import COLUMNS, UNIT, DoublePair, DoubleStart
from numerics.kernel.double_packed import ANSWER, HORIZON, HOW, STATE, advance, answer, double_at, pack, start_of
from numerics.kernel.motion import EVENT_LIMIT, FREE, OUT_OF_RANGE, RAY, ROWS_FULL, STICK, STUCK, SURFACE, Bounds, End
from numerics.modes import event_kind
from numerics.motion import Motion
from numerics.scaling import Frame, ReducedState
from numerics.scene import Law, Scene
from numerics.slip_flow import SlipFlow
from numerics.start import initial_motion
from numerics.trajectory import Event, Segment, Status, Trajectory
from numerics.undamped import UndampedSlip, UndampedStick

_ROWS, _FIRST_ROWS = 4096, 256
_HALVES = {name: index for index, name in enumerate(COLUMNS) if f"{name} low" in COLUMNS}


def double_start(scene: Scene) -> tuple[Frame, Motion, NDArray[np.float64]]:
    """Return the frame, the first motion, and the packed row that the kernels start from (double_packed.py).

    Raises OutOfRange; ValueError for a1 > 0.
    """
    if scene.pair.a1 > 0:
        raise ValueError("these kernels solve undamped scenes; a1 must be 0")
    arithmetic = DoubleDouble()
    with arithmetic.context():
        frame = Frame(arithmetic, scene.pair)
        motion = initial_motion(frame, scene)
        halves, at = arithmetic.halves, motion.start
        state = np.zeros(STATE)
        start = _start(motion, halves)
        pair = DoublePair(halves(frame.q), halves(frame.r), halves(frame.sqrt_q), scene.law is Law.THREE_VALUED_SGN)
        norm = abs(at.X) + frame.sqrt_q * abs(at.V1) + arithmetic.sqrt(frame.r) * abs(at.V2)
        gap, push = 2 * UNIT * abs(start.gap.high), 4 * UNIT * abs(start.push.high)
        w, place = 2 * UNIT * abs(start.w.high), 2 * UNIT * abs(start.Z.high)
        errors = Errors(0.0, gap, push, w, 0.0, place, 0.0, 4 * UNIT * float(norm))
        pack(state, pair, start, errors, no_linear(errors), 0.0)
        state[HORIZON : HORIZON + 2] = halves(frame.rate * arithmetic.number(scene.until))
    return frame, motion, state


def _start(motion: Motion, halves: Callable[[Any], Double]) -> DoubleStart:
    at = motion.start
    X, Z, w = halves(at.X), halves(at.Z), halves(at.w)
    if isinstance(motion, UndampedStick):
        gap, V, side = halves(motion.offset), halves(at.V1), float(motion.edge)
        return DoubleStart(STICK, side, X, ZERO, gap, V, ZERO, True, Z, w, ZERO, ZERO, ZERO)
    assert isinstance(motion, UndampedSlip)
    flow, side, kind = motion.flow, float(motion.side), SURFACE if motion.on_surface else FREE
    guard, gap, push = (halves(one) for one in (flow.guard_at_start, flow.gap_at_start, flow.push_at_start))
    driven = halves(motion.driven_at_start)
    return DoubleStart(kind, side, X, guard, gap, push, driven, flow.turns, Z, w, ZERO, ZERO, ZERO)


def solve_double_double(
    scene: Scene, max_events: int, progress: Callable[[int, float], None] | None = None
) -> Trajectory | None:
    """Return the trajectory of an undamped scene, compiled where numba is installed; None if it leaves the range."""
    try:
        frame, motion, state = double_start(scene)
    except OutOfRange:
        return None
    kept: list[NDArray[np.float64]] = []
    while True:
        # numba takes a second to come, so the first rows are left to Python unless it is here already
        fast = can_compile() and (bool(kept) or "numba" in sys.modules)
        rows = np.empty((min(max_events + 1, _ROWS if fast else _FIRST_ROWS), len(COLUMNS)))
        try:
            count = compiled(advance)(state, max_events, rows) if fast else _advance(state, max_events, rows)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            return None
        kept.append(rows[:count])
        if state[HOW] != ROWS_FULL:
            break
        if progress is not None:
            progress(sum(map(len, kept)), kept[-1][-1, 3] / state[HORIZON])
    if state[HOW] == OUT_OF_RANGE:
        return None
    end = np.zeros(ANSWER)
    if fast:
        compiled(answer)(state, end)
    else:
        answer(state.tolist(), end)
    return _trajectory(_Run(scene, frame, motion, np.concatenate(kept), state), end.tolist())


def _advance(state: NDArray[np.float64], max_events: int, rows: NDArray[np.float64]) -> int:
    """Advance a row by plain Python, on plain floats: NumPy's own are slower, and warn where those raise."""
    plain = state.tolist()
    count = advance(plain, max_events, rows)
    state[:] = plain
    return count


class _Run:
    """What a run wrote, turned into events, motions and segments one by one, where somebody asks for them."""

    def __init__(
        self, scene: Scene, frame: Frame, motion: Motion, rows: NDArray[np.float64], state: NDArray[np.float64]
    ) -> None:
        self.scene, self.frame, self.rows, self.state = scene, frame, rows, state
        self.motions: dict[int, Motion] = {0: motion}

    def number(self, index: int, name: str) -> Any:
        """Return a number of a row, exactly."""
        at = _HALVES[name]
        return exactly(*self.rows[index, at : at + 2].tolist())

    def motion(self, index: int) -> Motion:
        """Return a motion: the first, or the one that event index - 1 starts."""
        if index not in self.motions:
            with self.frame.arithmetic.context():
                self.motions[index] = self._motion_after(index - 1)
        return self.motions[index]

    def _motion_after(self, index: int) -> Motion:
        frame, law, (kind, side) = self.frame, self.scene.law, self.rows[index, 1:3].tolist()
        X, push, Z, w, gap, driven = (self.number(index, name) for name in ("X", "push", "Z", "w", "gap", "driven"))
        if kind == STICK:
            return UndampedStick(frame, law, ReducedState(X, push, push, Z, w), int(side), gap)
        V = side * frame.sqrt_q * driven
        flow, at = SlipFlow(frame.arithmetic, frame.arithmetic.number(0), gap, push), ReducedState(X, V, V, Z, w)
        return UndampedSlip(frame, law, int(side), flow, at, from_ray=kind == RAY)

    def segment(self, index: int) -> Segment:
        """Return a segment; the last one, after all events, ends at the horizon."""
        start = self.number(index - 1, "tau") if index else exactly(0.0, 0.0)
        if index < len(self.rows):
            return Segment(self.motion(index), start, self.number(index, "tau"), self.number(index, "length"))
        horizon, rest = double_at(self.state, HORIZON), start_of(self.state).rest
        length = subtract(subtract(horizon, start_of(self.state).tau), rest)
        return Segment(self.motion(index), start, exactly(*horizon), exactly(*length))

    def event(self, index: int) -> Event:
        """Return an event."""
        before, after = self.motion(index), self.motion(index + 1)
        with self.frame.arithmetic.context():
            t, y = self.frame.si_time(self.number(index, "tau")), self.frame.si_state(after.start)
        return Event(t, event_kind(before.mode, after.mode), before.mode, after.mode, y, after.start)


def _trajectory(run: _Run, end: list[float]) -> Trajectory:
    """Return the trajectory of a run; `end` is an answer of the kernels."""
    how, events = int(run.state[HOW]), len(run.rows)
    status = {STUCK: Status.STUCK_FOR_EVER, EVENT_LIMIT: Status.EVENT_LIMIT}.get(how, Status.REACHED_HORIZON)
    segments = Deferred(run.segment, events + (status is not Status.EVENT_LIMIT))
    found = End._make((int(end[0]), *end[1:13:2], *end[13:20], bool(end[20])))
    bounds = Bounds(run.rows[:, 19:23], found)
    return Trajectory(run.scene, run.frame, segments, Deferred(run.event, events), status, bounds=bounds)
