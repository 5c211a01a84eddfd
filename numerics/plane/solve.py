"""Solve a scene on a surface: in balls whose precision is raised until the digits are there, or on the float64 road."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.arithmetic.attempts import exhausted
from numerics.errors import EventUndecided, InvalidScene
from numerics.plane.answer import Working
from numerics.plane.box import joined
from numerics.plane.linear import LinearRun
from numerics.plane.reduced import line_at_first, reduced
from numerics.plane.run import PlaneRun
from numerics.plane.system import System
from numerics.plane.trajectory import PlaneTrajectory
from numerics.scene import Scene
from numerics.scene.decimals import shown
from numerics.scene.plane import PlaneScene
from numerics.trajectory.status import Status

_GUARD, _FLOAT, _MOST_TRIES = 6, 19, 2
"""Working digits beyond those asked for; those of the float64 road, 64 bits; how often they are doubled (there +1)."""
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

    Without digits and arithmetic: 64 bits, answers in floats with proved bounds, more bits only where these leave the
    sequence open. With `digits`, or "ball" (15): as many proved digits, relative to each number, near 0 to the largest
    of its axis along the run. (A direction that is not known is 0 with the radius 1.)
    "float64" does not climb. Raises EventUndecided, PrecisionExhausted, InvalidScene.
    """
    if arithmetic not in (None, "float64", "ball"):
        raise InvalidScene(f"arithmetic = {shown(arithmetic)} is available on a line only; use float64 or ball")
    limits: dict[str, Any] = {"max_events": max_events, "progress": progress}
    floats, wanted = arithmetic == "float64" or (arithmetic is None and digits is None), digits or 15
    working, tried = _FLOAT if floats else wanted + _GUARD, list[str]()
    while floats or working <= max_digits:
        try:
            found = _once(scene, line, working, "float64" if floats else "ball", limits)
        except EventUndecided as error:
            tried.append(str(error))
            if arithmetic == "float64" or len(tried) > _MOST_TRIES + floats or 2 * working > max_digits:
                raise
            working *= 2
            continue
        if floats or found.digits >= wanted:
            tried, right = tried if floats else [], found.digits if floats else wanted
            return found.but(t_eval=t_eval, tried="; ".join(tried), digits=right)
        working += wanted - found.digits + 3
    raise exhausted(wanted, max_digits)


def _once(scene: PlaneScene, line: Line, working: int, name: str, limits: dict[str, Any]) -> PlaneTrajectory:
    """Solve a scene once: a box part by part."""
    if scene.pair.shape == "ellipsoid" or len(scene.pair.parts) == 1:
        return followed(scene, working, name, limits)

    def alone(part: Scene | PlaneScene) -> Any:
        if isinstance(part, PlaneScene):
            return followed(part, working, "ball", limits)
        return line(part, digits=working - _SPARE, arithmetic="ball", **limits)

    return PlaneTrajectory(scene, *joined(scene, alone, name, limits["max_events"]))


def followed(scene: PlaneScene, working: int, name: str, limits: dict[str, Any]) -> PlaneTrajectory:
    """Return the motion of an ellipsoid or of a box, along its path. Raises EventUndecided, NotSettled."""
    system = System(reduced(scene), working)
    kind = LinearRun if scene.pair.shape == "box" or system.n == 1 else PlaneRun
    most = limits["max_events"], _MAX_LEGS, limits["progress"]
    run, line = kind(system, *most), None
    if isinstance(run, PlaneRun) and (given := line_at_first(scene)) is not None:
        share = float(given.pieces[-1].end / scene.until)
        tell = most[2] and (lambda events, fraction: most[2](events, fraction * share))
        line = LinearRun(System(given, working), *most[:2], tell)
        line.follow()
        with system.fine():
            run.go_on_from(line)
    if line is None or line.reached:
        run.follow()
    with system.fine():
        first = run.events[0].before if run.events else run.states.word(run.mode)
        status = Status.REACHED_HORIZON if run.reached else Status.EVENT_LIMIT
    return PlaneTrajectory(scene, Working(working, name), status, first, tuple(run.events), run.states)
