"""One undamped scene through the double-double kernels: exact rationals in, a Trajectory with error bounds out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.double_double import DoubleDouble, exactly
from numerics.errors import OutOfRange
from numerics.kernel.bounds import Errors, no_linear
from numerics.kernel.double_double import ZERO, Double, subtract
from numerics.kernel.double_packed import ANSWER, HORIZON, HOW, STATE, advance, answer, double_at, pack, start_of
from numerics.kernel.double_state import COLUMNS, UNIT, DoublePair, DoubleStart
from numerics.kernel.state import FREE, RAY, STICK, SURFACE, Bounds, End
from numerics.motion.frame import Frame, ReducedState
from numerics.old.kernel_run import KernelRun, Progress, answered, written_rows
from numerics.old.motion import Motion
from numerics.old.slip_flow import SlipFlow
from numerics.old.start import initial_motion
from numerics.old.undamped import UndampedSlip, UndampedStick
from numerics.scene import Law, Scene
from numerics.trajectory.trajectory import Trajectory

_HALVES = {name: index for index, name in enumerate(COLUMNS) if f"{name} low" in COLUMNS}
_ERRORS = slice(COLUMNS.index("late"), COLUMNS.index("late") + 4)


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


def solve_double_double(scene: Scene, max_events: int, progress: Progress | None = None) -> Trajectory | None:
    """Return the trajectory of an undamped scene, compiled where numba is installed; None if it leaves the range."""
    try:
        frame, motion, state = double_start(scene)
    except OutOfRange:
        return None
    horizon = float(state[HORIZON])
    told = None if progress is None else lambda row, count: progress(count, row[_HALVES["tau"]] / horizon)
    rows = written_rows(advance, state, HOW, len(COLUMNS), max_events, told)
    end = None if rows is None else answered(answer, state, ANSWER)
    if rows is None or end is None:
        return None
    found = End._make((int(end[0]), *end[1:13:2], *end[13:20], bool(end[20])))
    return _Run(scene, frame, motion, rows, state).trajectory(state[HOW], Bounds(rows[:, _ERRORS], found))


class _Run(KernelRun):
    """The rows of an undamped scene in halves (double_state.COLUMNS)."""

    def number(self, index: int, name: str) -> Any:
        """Return a number of a row, exactly."""
        at = _HALVES[name]
        return exactly(*self.rows[index, at : at + 2].tolist())

    def motion_after(self, index: int) -> Motion:
        """Return the motion that an event starts."""
        frame, law, (kind, side) = self.frame, self.scene.law, self.rows[index, 1:3].tolist()
        X, push, Z, w, gap, driven = (self.number(index, name) for name in ("X", "push", "Z", "w", "gap", "driven"))
        if kind == STICK:
            return UndampedStick(frame, law, ReducedState(X, push, push, Z, w), int(side), gap)
        V = side * frame.sqrt_q * driven
        flow, at = SlipFlow(frame.arithmetic, frame.arithmetic.number(0), gap, push), ReducedState(X, V, V, Z, w)
        return UndampedSlip(frame, law, int(side), flow, at, from_ray=kind == RAY)

    def last_stretch(self) -> tuple[Any, Any]:
        """Return the reduced horizon, and how long the last motion lasts up to it."""
        horizon, start = double_at(self.state, HORIZON), start_of(self.state)
        length = subtract(subtract(horizon, start.tau), start.rest)
        return exactly(*horizon), exactly(*length)
