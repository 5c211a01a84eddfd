"""Solve a scene on a surface: in balls whose precision is raised until the digits are there."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.arithmetic.attempts import exhausted
from numerics.errors import EventUndecided, InvalidScene
from numerics.plane.answer import Working
from numerics.plane.box import joined
from numerics.plane.reduced import reduced
from numerics.plane.run import PlaneRun
from numerics.plane.system import System
from numerics.plane.trajectory import PlaneTrajectory
from numerics.scene import Scene
from numerics.scene.decimals import shown
from numerics.scene.plane import PlaneScene
from numerics.trajectory.status import Status

DIGITS, _GUARD, _MOST_TRIES = 15, 6, 2
"""Proved digits where none are asked for; working digits beyond these; how often they are doubled."""
_SPARE = 4
"""Working digits of a path that a part of one axis, solved to right digits by the line's engines, does without."""
_MAX_LEGS = 200_000
Line = Callable[..., Any]


def solve_plane(
    scene: PlaneScene,
    line: Line,
    *,
    digits: int | None = None,
    arithmetic: str | None = None,
    t_eval: Any = None,
    max_events: int = 250_000,
    max_digits: int = 20_000,
    progress: Any = None,
) -> PlaneTrajectory:
    """Solve a scene on a surface; an axis of a box that no other acts on by `line`, the solve of a pair on a line.

    As many proved digits as `digits` (15) says, relative to each number, near 0 to the largest of its axis along the
    run. (A direction that is not known is 0 with the radius 1.)

    Raises EventUndecided, PrecisionExhausted, InvalidScene.
    """
    if arithmetic not in (None, "ball"):
        raise InvalidScene(
            f"arithmetic = {shown(arithmetic)} is available on a line only: a surface is solved in balls; leave it out"
        )
    limits: dict[str, Any] = {"max_events": max_events, "progress": progress}
    wanted, undecided = digits or DIGITS, 0
    working = wanted + _GUARD
    while working <= max_digits:
        try:
            found = _once(scene, line, working, limits)
        except EventUndecided:
            undecided += 1
            if undecided > _MOST_TRIES or 2 * working > max_digits:
                raise
            working *= 2
            continue
        if found.digits >= wanted:
            return found.but(t_eval=t_eval, digits=wanted)
        working += wanted - found.digits + 3
    raise exhausted(wanted, max_digits)


def _once(scene: PlaneScene, line: Line, working: int, limits: dict[str, Any]) -> PlaneTrajectory:
    """Solve a scene once: a box part by part."""
    if scene.pair.shape == "ellipsoid" or len(scene.pair.parts) == 1:
        return followed(scene, working, limits)

    def alone(part: Scene | PlaneScene) -> Any:
        if isinstance(part, PlaneScene):
            return followed(part, working, limits)
        return line(part, digits=working - _SPARE, arithmetic="ball", **limits)

    return PlaneTrajectory(scene, *joined(scene, alone, limits["max_events"]))


def followed(scene: PlaneScene, working: int, limits: dict[str, Any]) -> PlaneTrajectory:
    """Return the motion of an ellipsoid or of a box, along its path. Raises EventUndecided, NotSettled."""
    run = PlaneRun(
        [System(one, working) for one in reduced(scene)], limits["max_events"], _MAX_LEGS, limits["progress"]
    )
    run.follow()
    first = run.events[0].before if run.events else run.system.word(run.mode)
    status = Status.REACHED_HORIZON if run.reached else Status.EVENT_LIMIT
    return PlaneTrajectory(scene, Working(working), status, first, tuple(run.events), run.motion)
