"""One undamped scene through the binary64 kernels: exact rationals in, a Trajectory with error bounds out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import Float64
from numerics.kernel.bounds import ULP, Errors, no_linear
from numerics.kernel.packed import ANSWER, HORIZON, STATE, advance, answer, pack, start_of
from numerics.kernel.state import COLUMNS, FREE, RAY, STICK, SURFACE, Pair, Start
from numerics.motion.frame import Frame, ReducedState
from numerics.motion.modes import Mode, slip_mode
from numerics.old.kernel_run import FloatRun, Progress, solved_in_floats
from numerics.old.motion import Motion
from numerics.old.slip_flow import SlipFlow
from numerics.old.start import initial_motion
from numerics.old.undamped import UndampedSlip, UndampedStick
from numerics.scene import Law, Scene
from numerics.trajectory.trajectory import Trajectory


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


def solve_binary64(scene: Scene, max_events: int, progress: Progress | None = None) -> Trajectory | None:
    """Return the trajectory of an undamped scene, compiled where numba is installed; None if it leaves the range."""
    start = scene, *kernel_start(scene)
    return solved_in_floats(_Run, start, (advance, answer), ANSWER, max_events, progress)


class _Run(FloatRun):
    """The rows of an undamped scene."""

    columns, start = COLUMNS, staticmethod(start_of)

    def motion_after(self, index: int) -> Motion:
        """Return the motion that an event starts."""
        frame, law = self.frame, self.scene.law
        _, kind, _, _, X, push, Z, w, gap, side, V, *_ = self.rows[index].tolist()
        if kind == STICK:
            return UndampedStick(frame, law, ReducedState(X, push, push, Z, w), int(side), gap)
        if kind == RAY:
            return UndampedSlip.from_exit_ray(frame, law, int(side), Z, w)
        flow = SlipFlow(frame.arithmetic, 0.0, gap, push)
        return UndampedSlip(frame, law, int(side), flow, ReducedState(X, V, V, Z, w))


def mode_of(code: float) -> Mode:
    """Return the mode that a row names by -1, 0 or +1."""
    return slip_mode(int(code)) if code else Mode.STICK
