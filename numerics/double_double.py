"""One undamped scene through the double-double kernels: exact rationals in, a Trajectory with error bounds out."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.double_double import DoubleDouble
from numerics.errors import OutOfRange
from numerics.kernel.bounds import Errors, no_linear
from numerics.kernel.compilation import compiled
from numerics.kernel.double_double import ZERO, Double
from numerics.kernel.double_motion import COLUMNS, UNIT, DoublePair, DoubleStart
from numerics.kernel.double_packed import ANSWER, HORIZON, HOW, STATE, advance, answer, pack
from numerics.kernel.motion import EVENT_LIMIT, FREE, OUT_OF_RANGE, RAY, ROWS_FULL, STICK, STUCK, SURFACE, Bounds, End
from numerics.modes import event_kind
from numerics.motion import Motion
from numerics.scaling import Frame, ReducedState
from numerics.scene import Law, Scene
from numerics.slip_flow import SlipFlow
from numerics.start import initial_motion
from numerics.trajectory import Event, Segment, Status, Trajectory
from numerics.undamped import UndampedSlip, UndampedStick

_ROWS = 4096
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
    run, kept = compiled(advance), []
    rows = np.empty((min(max_events + 1, _ROWS), len(COLUMNS)))
    end = np.zeros(ANSWER)
    try:
        while True:
            count = run(state, max_events, rows)
            kept.append(rows[:count].copy())
            if state[HOW] != ROWS_FULL:
                break
            if progress is not None:
                progress(sum(map(len, kept)), kept[-1][-1, 3] / state[HORIZON])
        compiled(answer)(state, end)
    except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
        return None
    if state[HOW] == OUT_OF_RANGE:
        return None
    with frame.arithmetic.context():
        return _trajectory(scene, frame, motion, np.concatenate(kept), state, end)


def _trajectory(
    scene: Scene,
    frame: Frame,
    motion: Motion,
    rows: NDArray[np.float64],
    state: NDArray[np.float64],
    end: NDArray[np.float64],
) -> Trajectory:
    arithmetic, how = DoubleDouble(), int(state[HOW])
    columns = {name: arithmetic.numbers(rows[:, at], rows[:, at + 1]) for name, at in _HALVES.items()}
    segments, events, start = [], [], arithmetic.number(0)
    following = _motions(frame, scene.law, rows, columns)
    for tau, length, then in zip(columns["tau"], columns["length"], following, strict=True):
        segments.append(Segment(motion, start, tau, length))
        kind, at = event_kind(motion.mode, then.mode), then.start
        events.append(Event(frame.si_time(tau), kind, motion.mode, then.mode, frame.si_state(at), at))
        motion, start = then, tau
    status = {STUCK: Status.STUCK_FOR_EVER, EVENT_LIMIT: Status.EVENT_LIMIT}.get(how, Status.REACHED_HORIZON)
    if status is not Status.EVENT_LIMIT:
        horizon, rest = arithmetic.numbers(state[[HORIZON, 28]], state[[HORIZON + 1, 29]])
        segments.append(Segment(motion, start, horizon, (horizon - start) - rest))
    return Trajectory(scene, frame, tuple(segments), tuple(events), status, bounds=Bounds(rows[:, 19:23], _end(end)))


def _motions(frame: Frame, law: Law, rows: NDArray[np.float64], columns: dict[str, list[Any]]) -> Iterator[Motion]:
    """Yield the motion that each event starts, from its row."""
    zero = frame.arithmetic.number(0)
    names = ("X", "push", "Z", "w", "gap", "driven")
    numbers = zip(*(columns[name] for name in names), strict=True)
    for (kind, side), (X, push, Z, w, gap, driven) in zip(rows[:, 1:3].tolist(), numbers, strict=True):
        if kind == STICK:
            yield UndampedStick(frame, law, ReducedState(X, push, push, Z, w), int(side), gap)
        elif kind == RAY:
            yield UndampedSlip.from_exit_ray(frame, law, int(side), Z, w)
        else:
            V = side * frame.sqrt_q * driven
            yield UndampedSlip(
                frame, law, int(side), SlipFlow(frame.arithmetic, zero, gap, push), ReducedState(X, V, V, Z, w)
            )


def _end(end: NDArray[np.float64]) -> End:
    """Return the end of a run in binary64 with the bounds on its errors, from an answer of the kernels."""
    mode, X, V1, V2, Z, w, spent = end[[0, 1, 3, 5, 7, 9, 11]].tolist()
    return End(int(mode), X, V1, V2, Z, w, spent, *end[13:20].tolist(), bool(end[20]))
