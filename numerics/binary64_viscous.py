"""One viscous scene through the binary64 kernels: exact rationals in, a Trajectory with error bounds out."""

from __future__ import annotations

import sys
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import Float64
from numerics.kernel.compilation import can_compile, compiled
from numerics.kernel.motion import EVENT_LIMIT, OUT_OF_RANGE, ROWS_FULL, STUCK, Bounds, End
from numerics.kernel.viscous_bounds import initial_errors
from numerics.kernel.viscous_motion import COLUMNS
from numerics.kernel.viscous_packed import DAMPED_ANSWER, HORIZON, HOW, STATE, advance, answer, pack, viscous_pair
from numerics.kernel.viscous_state import Start, ViscousPair
from numerics.modes import event_kind
from numerics.motion import Motion
from numerics.scaling import Frame, ReducedState
from numerics.scene import Law, Scene
from numerics.start import initial_motion
from numerics.trajectory import Event, Segment, Status, Trajectory
from numerics.viscous import ViscousSlip, ViscousStick, slip_oscillator, stick_oscillator

_ROWS = 1000
_REST = 17


def viscous_start(scene: Scene) -> tuple[Frame, Motion, NDArray[np.float64]]:
    """Return the frame, the first motion, and the packed row that the viscous kernels start from.

    Conversions of exact rationals are off by an ulp or two. Raises OutOfRange; ValueError for a1 = 0.
    """
    if scene.pair.a1 <= 0:
        raise ValueError("these kernels solve viscous scenes; a1 must be > 0")
    frame = Frame(Float64(), scene.pair)
    motion = initial_motion(frame, scene)
    assert isinstance(motion, ViscousSlip | ViscousStick)
    at, mode = motion.start, motion.mode.sign
    rising = isinstance(motion, ViscousSlip) and motion.rising
    start = Start(mode, at.X, at.V1, at.V2, at.Z, at.w, rising, motion.level, 0.0, 0.0, 0.0, 0.0)
    state = np.zeros(STATE)
    errors = initial_errors(frame.q, frame.r, at.X, at.V1, at.V2, at.Z, at.w)
    pack(state, _pair(frame, scene.law), start, errors, 0.0)
    state[HORIZON] = frame.rate * frame.arithmetic.number(scene.until)
    return frame, motion, state


def _pair(frame: Frame, law: Law) -> ViscousPair:
    stick, slip = stick_oscillator(frame), slip_oscillator(frame)
    regimes = (stick.regime, stick.frequency), (slip.regime, slip.frequency)
    return viscous_pair(frame.q, frame.r, frame.two_zeta, law is Law.THREE_VALUED_SGN, *regimes)


def solve_viscous(
    scene: Scene, max_events: int, progress: Callable[[int, float], None] | None = None
) -> Trajectory | None:
    """Return the trajectory of a viscous scene, compiled where numba is here; None if it leaves the range."""
    frame, motion, state = viscous_start(scene)
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
    end = [0.0] * DAMPED_ANSWER
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
    how, horizon = int(state[HOW]), float(state[HORIZON])
    segments, events, start = [], [], 0.0
    for row in rows.tolist():
        tau, length = row[2], row[3]
        following = _motion(frame, scene.law, row)
        segments.append(Segment(motion, start, tau, length))
        kind, at = event_kind(motion.mode, following.mode), following.start
        events.append(Event(frame.si_time(tau), kind, motion.mode, following.mode, frame.si_state(at), at))
        motion, start = following, tau
    status = {STUCK: Status.STUCK_FOR_EVER, EVENT_LIMIT: Status.EVENT_LIMIT}.get(how, Status.REACHED_HORIZON)
    if status is not Status.EVENT_LIMIT:
        segments.append(Segment(motion, start, horizon, (horizon - start) - float(state[_REST])))
    numbers = end[: len(End._fields)]
    found = End._make([int(numbers[0]), *numbers[1:-1], bool(numbers[-1])])
    bounds = Bounds(rows[:, 11:15], found, end[-1])
    return Trajectory(scene, frame, tuple(segments), tuple(events), status, bounds=bounds)


def _motion(frame: Frame, law: Law, row: list[float]) -> Motion:
    """Return the motion that an event starts, from its row (viscous_motion.COLUMNS)."""
    mode, _, _, _, X, V, Z, w, *_ = row
    at = ReducedState(X, V, V, Z, w)
    return ViscousSlip(frame, law, int(mode), at, rising=True) if mode else ViscousStick(frame, law, at)
