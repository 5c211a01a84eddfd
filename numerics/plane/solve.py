"""One scene on a surface, solved once in balls: an ellipsoid along its path, a box part by part."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.plane.box import joined
from numerics.plane.motion import Working
from numerics.plane.reduced import reduced
from numerics.plane.run import PlaneRun
from numerics.plane.system import System
from numerics.plane.trajectory import PlaneTrajectory
from numerics.scene import Scene
from numerics.scene.plane import PlaneScene
from numerics.trajectory.status import Status

_SPARE = 4
"""Working digits of a path that a part of one axis, solved to right digits by the line's engines, does without."""
_MAX_LEGS = 200_000


def run_plane(scene: PlaneScene, working: int, max_events: int, progress: Any, line: Callable[..., Any]) -> Any:
    """Solve a scene once; an axis of a box that no other acts on by `line`, to right digits as a pair on a line.

    Numbers count relative to themselves, near 0 to the largest of their axis along the run, or where that is 0 to what
    friction holds. (A direction that is not known is 0 with the radius 1.)
    Raises EventUndecided, NotSettled, InvalidScene.
    """

    def alone(part: Scene | PlaneScene) -> Any:
        is_line = isinstance(part, Scene)
        return line(part, working - _SPARE) if is_line else followed(part, working, max_events, progress)

    if scene.pair.shape == "ellipsoid" or len(scene.pair.parts) == 1:
        return followed(scene, working, max_events, progress)
    return PlaneTrajectory(scene, *joined(scene, alone, max_events))


def followed(scene: Any, working: int, max_events: int, progress: Any = None) -> PlaneTrajectory:
    """Return the motion of an ellipsoid or of a box, along its path. Raises EventUndecided, NotSettled."""
    run = PlaneRun([System(one, working) for one in reduced(scene)], max_events, _MAX_LEGS, progress)
    run.follow()
    first = run.events[0].before if run.events else run.system.word(run.mode)
    status = Status.REACHED_HORIZON if run.reached else Status.EVENT_LIMIT
    return PlaneTrajectory(scene, Working(working), status, first, tuple(run.events), run.motion)
