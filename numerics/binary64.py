"""One undamped scene through the binary64 kernels: exact rationals in, the kernels' numbers out."""

from __future__ import annotations

from numerics.arithmetic.float64 import Float64
from numerics.kernel.bounds import ULP, Errors, Linear, no_linear
from numerics.kernel.motion import FREE, STICK, SURFACE, Pair, Start
from numerics.scaling import Frame, ReducedState
from numerics.scene import Law, Scene
from numerics.start import initial_motion
from numerics.undamped import UndampedSlip, UndampedStick


def kernel_start(scene: Scene) -> tuple[Frame, Pair, Start, Errors, Linear, float]:
    """Return the frame and what kernel.motion.run takes: pair, start, errors, their linear part, reduced horizon.

    Conversions of exact rationals are off by an ulp or two. Raises OutOfRange; ValueError for a1 > 0.
    """
    if scene.pair.a1 > 0:
        raise ValueError("the kernels solve undamped scenes; a1 must be 0")
    frame = Frame(Float64(), scene.pair)
    motion = initial_motion(frame, scene)
    pair = Pair(frame.q, frame.r, frame.sqrt_q, scene.law is Law.THREE_VALUED_SGN)
    if isinstance(motion, UndampedStick):
        start = _stick(motion)
    else:
        assert isinstance(motion, UndampedSlip)
        start = _slip(motion)
    errors = _initial_errors(frame, start, motion.start)
    return frame, pair, start, errors, no_linear(errors), frame.rate * frame.arithmetic.number(scene.until)


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
