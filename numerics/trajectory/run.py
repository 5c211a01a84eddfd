"""One scene, solved once in one arithmetic, by the engine that it needs."""

from __future__ import annotations

from collections.abc import Callable

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import OutOfRange
from numerics.free.motion import run_free
from numerics.linear.engine import run_linear
from numerics.scene import Scene
from numerics.scene.decimals import short
from numerics.scene.model import parameters
from numerics.trajectory.trajectory import Trajectory

MAX_EVENTS = 250_000
Progress = Callable[[int, float], None]


def free_scene(scene: Scene) -> bool:
    """Return whether the free engine solves a scene: a1 = 0, no force, one b; the linear engine solves every scene."""
    return scene.pair.a1 == 0 and not scene.is_forced


def run_scene(
    scene: Scene, arithmetic: Arithmetic, max_events: int = MAX_EVENTS, progress: Progress | None = None
) -> Trajectory:
    """Solve a scene once, at the arithmetic's working precision. Raises EventUndecided, OutOfRange.

    In float64, and from a box of starts, every scene runs in the linear engine; else the free pair has an exact road of
    its own.
    """
    is_box = isinstance(arithmetic, Ball) and not arithmetic.radius.is_zero()
    run = run_linear if isinstance(arithmetic, Float64) or is_box or not free_scene(scene) else run_free
    try:
        return Trajectory(scene, arithmetic, run(scene, arithmetic, max_events, progress))
    except OutOfRange as error:
        raise _named(scene, error) from None


def _named(scene: Scene, error: OutOfRange) -> OutOfRange:
    """Return the error with the name of the number of a scene or of its start that is out of range, if one is."""
    if error.beyond is None:
        return error
    (_, least, most), pair = error.beyond, scene.pair
    made = parameters(scene) | {"until": scene.until, "E at t = 0": scene.energy}
    if pair.a2 and pair.b:
        made |= {"L = b (m1 + m2)/(a2 m2)": pair.half_width, "E_cr": pair.critical_energy}
        made |= {"E/E_cr - 1 at t = 0": scene.energy_excess}
    for is_beyond in (lambda size: size > most, lambda size: 0 < size < least):  # what is too large fails oftener
        for name, value in made.items():
            if is_beyond(abs(value)):
                return OutOfRange.of(f"{name} = {short(value)}", *error.beyond)
    return error
