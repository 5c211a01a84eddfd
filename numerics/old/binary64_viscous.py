"""One viscous scene through the binary64 kernels: exact rationals in, a Trajectory with error bounds out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import Float64
from numerics.kernel.packed import HORIZON, STATE
from numerics.kernel.viscous_bounds import initial_errors
from numerics.kernel.viscous_motion import COLUMNS
from numerics.kernel.viscous_packed import DAMPED_ANSWER, advance, answer, pack, start_of, viscous_pair
from numerics.kernel.viscous_state import Start, ViscousPair
from numerics.motion.frame import Frame, ReducedState
from numerics.old.kernel_run import FloatRun, Progress, solved_in_floats
from numerics.old.motion import Motion
from numerics.old.start import initial_motion
from numerics.old.viscous import ViscousSlip, ViscousStick, slip_oscillator, stick_oscillator
from numerics.scene import Law, Scene
from numerics.trajectory.trajectory import Trajectory


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


def solve_viscous(scene: Scene, max_events: int, progress: Progress | None = None) -> Trajectory | None:
    """Return the trajectory of a viscous scene, compiled where numba is installed; None if it leaves the range."""
    start = scene, *viscous_start(scene)
    return solved_in_floats(_Run, start, (advance, answer), DAMPED_ANSWER, max_events, progress)


class _Run(FloatRun):
    """The rows of a viscous scene."""

    columns, start = COLUMNS, staticmethod(start_of)

    def motion_after(self, index: int) -> Motion:
        """Return the motion that an event starts."""
        mode, _, _, _, X, V, Z, w, *_ = self.rows[index].tolist()
        at = ReducedState(X, V, V, Z, w)
        if mode:
            return ViscousSlip(self.frame, self.scene.law, int(mode), at, rising=True)
        return ViscousStick(self.frame, self.scene.law, at)
