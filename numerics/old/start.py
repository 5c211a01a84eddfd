"""The motion that an initial state starts with; which one is decided on exact rationals."""

from __future__ import annotations

from fractions import Fraction

from numerics.motion.frame import Frame, ReducedState
from numerics.motion.modes import Mode, mode_at_start
from numerics.old.motion import Motion
from numerics.old.slip_flow import SlipFlow
from numerics.old.undamped import UndampedSlip, UndampedStick
from numerics.old.viscous import ViscousSlip, ViscousStick
from numerics.scene import Scene


def initial_motion(frame: Frame, scene: Scene) -> Motion:
    """Return the motion that follows the initial state of a scene. Raises OutOfRange."""
    mode, start = mode_at_start(scene), frame.initial(scene)
    if scene.pair.a1 > 0:
        level = _starts_level(scene, mode.sign)
        if mode is Mode.STICK:
            return ViscousStick(frame, scene.law, start, level=level)
        rising = _guard_rises(scene, mode.sign)
        return ViscousSlip(frame, scene.law, mode.sign, start, rising, level=level)
    width = scene.pair.half_width
    X = scene.initial.x1 / width
    if mode is Mode.STICK:
        edge = -1 if X < 0 else 1
        return UndampedStick(frame, scene.law, start, edge, frame.arithmetic.number(edge * X - 1))
    return _undamped_slip(frame, scene, mode.sign, X, width, start)


def _undamped_slip(
    frame: Frame, scene: Scene, sign: int, X: Fraction, width: Fraction, start: ReducedState
) -> UndampedSlip:
    arithmetic, pair, at, side = frame.arithmetic, scene.pair, scene.initial, -sign
    relative = arithmetic.number(sign * (at.v1 - at.v2) / width) / frame.rate
    gap = (side * X - 1) * pair.mass / pair.m1
    push_squared = at.v1**2 * pair.mass**2 / (width**2 * pair.a2 * pair.m1)
    flow = SlipFlow(
        arithmetic,
        guard_at_start=relative / frame.sqrt_q,
        gap_at_start=arithmetic.number(gap),
        push_at_start=side * start.V1 / frame.sqrt_q,
        turns=gap * (2 + gap) + push_squared > 0,
    )
    return UndampedSlip(frame, scene.law, side, flow, start, on_surface=at.v1 == at.v2)


def _guard_rises(scene: Scene, sign: int) -> bool:
    """Return whether s (v1 - v2) grows right after the start of a viscous slip of sign s; exact.

    With P the load, q f' = -(s P + 1); where that vanishes f'' has the sign of -(a1 L/M + s v1); where that vanishes
    too, f''' < 0.
    """
    pair, at = scene.pair, scene.initial
    load = (pair.a2 * at.x1 + pair.a1 * at.v1) / (pair.a2 * pair.half_width)
    slope = -(sign * load + 1)
    curvature = -(pair.a1 * pair.half_width / pair.mass + sign * at.v1)
    return slope > 0 or (slope == 0 and curvature > 0)


def _starts_level(scene: Scene, sign: int) -> bool:
    """Return whether dP/dt = 0 exactly at the start: then f'' = 0 in a slip, and P is at its extremum in stick."""
    pair, at = scene.pair, scene.initial
    moved = pair.m1 if sign else pair.mass
    return pair.a2 * at.v1 * moved == pair.a1 * (pair.a2 * at.x1 + pair.a1 * at.v1 + pair.b * sign)
