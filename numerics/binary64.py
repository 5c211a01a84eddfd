"""One undamped scene through the binary64 kernels: exact rationals in, a Trajectory with error bounds out."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import Float64
from numerics.kernel.bounds import ULP, Errors, no_linear
from numerics.kernel.compilation import can_compile, compiled
from numerics.kernel.motion import (
    COLUMNS,
    EVENT_LIMIT,
    FREE,
    OUT_OF_RANGE,
    RAY,
    ROWS_FULL,
    STICK,
    STUCK,
    SURFACE,
    Bounds,
    End,
    Pair,
    Start,
)
from numerics.kernel.packed import ANSWER, HORIZON, HOW, STATE, advance, answer, pack
from numerics.modes import Mode, event_kind, slip_mode
from numerics.motion import Motion
from numerics.scaling import Frame, ReducedState
from numerics.scene import Law, Scene
from numerics.slip_flow import SlipFlow
from numerics.start import initial_motion
from numerics.trajectory import Event, Segment, Status, Trajectory
from numerics.undamped import UndampedSlip, UndampedStick

_ROWS = 1000


def kernel_start(scene: Scene) -> tuple[Frame, Motion, NDArray[np.float64]]:
    """Return the frame, the first motion, and the packed row that the kernels start from.

    Conversions of exact rationals are off by an ulp or two. Raises OutOfRange; ValueError for a1 > 0.
    """
    if scene.pair.a1 > 0:
        raise ValueError("these kernels solve undamped scenes; a1 must be 0")
    frame = Frame(Float64(), scene.pair)
    motion = initial_motion(frame, scene)
    if isinstance(motion, UndampedStick):
        start = _stick(motion)
    else:
        assert isinstance(motion, UndampedSlip)
        start = _slip(motion)
    errors = _initial_errors(frame, start, motion.start)
    state = np.zeros(STATE)
    pair = Pair(frame.q, frame.r, frame.sqrt_q, scene.law is Law.THREE_VALUED_SGN)
    pack(state, pair, start, errors, no_linear(errors), 0.0)
    state[HORIZON] = frame.rate * frame.arithmetic.number(scene.until)
    return frame, motion, state


def _stick(motion: UndampedStick) -> Start:
    at = motion.start
    return Start(STICK, float(motion.edge), at.X, 0.0, motion.offset, at.V1, 0.0, True, at.Z, at.w, 0.0, 0.0, 0.0)


def _slip(motion: UndampedSlip) -> Start:
    at, flow, kind = motion.start, motion.flow, SURFACE if motion.on_surface else FREE
    side, driven = float(motion.side), motion.driven_at_start
    guard, gap, push = flow.guard_at_start, flow.gap_at_start, flow.push_at_start
    return Start(kind, side, at.X, guard, gap, push, driven, flow.turns, at.Z, at.w, 0.0, 0.0, 0.0)


def _initial_errors(frame: Frame, start: Start, at: ReducedState) -> Errors:
    norm = 4 * ULP * (abs(at.X) + frame.sqrt_q * abs(at.V1) + frame.arithmetic.sqrt(frame.r) * abs(at.V2))
    gap, push = 2 * ULP * abs(start.gap), 4 * ULP * abs(start.push)
    return Errors(0.0, gap, push, 2 * ULP * abs(at.w), 0.0, 2 * ULP * abs(at.Z), 0.0, norm)


def solve_binary64(
    scene: Scene, max_events: int, progress: Callable[[int, float], None] | None = None
) -> Trajectory | None:
    """Return the trajectory of an undamped scene, compiled where numba is installed; None if it leaves the range."""
    frame, motion, state = kernel_start(scene)
    horizon = float(state[HORIZON])
    kept: list[NDArray[np.float64]] = []
    rows = np.empty((min(max_events + 1, _ROWS), len(COLUMNS)))
    while True:
        # numba takes a second to come, so the first rows are left to Python unless it is here already
        fast = can_compile() and (kept or "numba" in sys.modules)
        try:
            count = compiled(advance)(state, max_events, rows) if fast else _advance(state, max_events, rows)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            return None
        kept.append(rows[:count].copy())
        if state[HOW] != ROWS_FULL:
            break
        if progress is not None:
            progress(sum(map(len, kept)), kept[-1][-1, 2] / horizon)
    if state[HOW] == OUT_OF_RANGE:
        return None
    end = [0.0] * ANSWER
    answer(state.tolist(), end)
    return _trajectory(scene, frame, motion, np.concatenate(kept), state, end)


def _advance(state: NDArray[np.float64], max_events: int, rows: NDArray[np.float64]) -> int:
    """Advance a row by plain Python, on plain floats: NumPy's own are slower, and warn where those raise."""
    plain = state.tolist()
    count = advance(plain, max_events, rows)
    state[:] = plain
    return count


def _trajectory(
    scene: Scene, frame: Frame, motion: Motion, rows: NDArray[np.float64], state: NDArray[np.float64], end: list[float]
) -> Trajectory:
    how, horizon, rest = int(state[HOW]), float(state[HORIZON]), float(state[15])
    segments, events, start = [], [], 0.0
    motions = _motions(frame, scene.law, rows)
    for (tau, length), following in zip(rows[:, 2:4].tolist(), motions, strict=True):
        segments.append(Segment(motion, start, tau, length))
        kind = event_kind(motion.mode, following.mode)
        at = following.start
        events.append(Event(frame.si_time(tau), kind, motion.mode, following.mode, frame.si_state(at), at))
        motion, start = following, tau
    status = {STUCK: Status.STUCK_FOR_EVER, EVENT_LIMIT: Status.EVENT_LIMIT}.get(how, Status.REACHED_HORIZON)
    if status is not Status.EVENT_LIMIT:
        segments.append(Segment(motion, start, horizon, (horizon - start) - rest))
    numbers = end[: len(End._fields)]
    found = End._make([int(numbers[0]), *numbers[1:-1], bool(numbers[-1])])
    bounds = Bounds(rows[:, 11:15], found)
    return Trajectory(scene, frame, tuple(segments), tuple(events), status, bounds=bounds)


def _motions(frame: Frame, law: Law, rows: NDArray[np.float64]) -> Iterator[Motion]:
    """Yield the motion that each event starts, from its row (motion.COLUMNS)."""
    for row in rows.tolist():
        _, kind, _, _, X, push, Z, w, gap, side, V, *_ = row
        if kind == STICK:
            yield UndampedStick(frame, law, ReducedState(X, push, push, Z, w), int(side), gap)
        elif kind == RAY:
            yield UndampedSlip.from_exit_ray(frame, law, int(side), Z, w)
        else:
            flow = SlipFlow(frame.arithmetic, 0.0, gap, push)
            yield UndampedSlip(frame, law, int(side), flow, ReducedState(X, V, V, Z, w))


def mode_of(code: float) -> Mode:
    """Return the mode that a row names by -1, 0 or +1."""
    return slip_mode(int(code)) if code else Mode.STICK
