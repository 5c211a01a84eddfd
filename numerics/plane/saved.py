"""A trajectory on a surface in a file, without a pickle: what comes back equals what was saved, to the last bit.

The archive is that of the line (trajectory/saved.py). The header has the legs of the path with their bounds, so that
any time is answered as before; of a box in parts, the header of each part's own trajectory.
"""

from __future__ import annotations

from typing import Any

from numerics.plane.answer import PlaneEvent, PlaneSolution, PlaneState, Working
from numerics.plane.box import Parts
from numerics.plane.defect import Curve
from numerics.plane.path import Leg
from numerics.plane.reduced import reduced
from numerics.plane.states import States
from numerics.plane.system import System
from numerics.plane.vector import Vector
from numerics.scene.decimals import require_whole
from numerics.scene.file import parse_scene
from numerics.scene.plane import PlaneScene
from numerics.trajectory import saved
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory

FORMAT = "inertial-pair surface trajectory 2"


def contents(trajectory: PlaneSolution) -> dict[str, Any]:
    """Return the header of a trajectory. Raises InvalidScene for a scene that no text of 1000 characters holds."""
    motion = trajectory.motion
    return {
        "format": FORMAT,
        "scene": saved.kept_scene(trajectory.scene),
        "arithmetic": (trajectory.arithmetic.name, trajectory.arithmetic.digits),
        "status": int(trajectory.status),
        "events": [
            saved.plain([getattr(one, name) for name in PlaneEvent.__annotations__]) for one in trajectory.events
        ],
        "modes": list(trajectory.modes),
        "end": saved.plain((trajectory.end_time, trajectory.final_state)),
        "digits": trajectory.digits,
        "tried": trajectory.tried,
        "t_eval": None if trajectory.t_eval is None else saved.plain(trajectory.t_eval),
        "legs": saved.plain(motion.legs) if isinstance(motion, States) else None,
        "parts": [_part(one) for one in motion.answers] if isinstance(motion, Parts) else None,
    }


def restored(header: dict[str, Any], _: Any = None) -> PlaneSolution:
    """Return the trajectory of a header. Raises ValueError, and what else a file that nobody saved can bring about."""
    saved.require_format(header, FORMAT)
    scene: Any = parse_scene(header["scene"])
    if not isinstance(scene, PlaneScene):
        raise ValueError("its scene is on a line")
    name, digits = header["arithmetic"]
    if name not in {"float64", "ball"}:
        raise ValueError(f"its arithmetic is {str(name)[:40]!r}")
    for what, count, least in (("digits", digits, 1), ("right digits", header["digits"], 0)):
        require_whole(what, count, least)
    arithmetic, n = Working(digits, name), scene.pair.axes
    with arithmetic.context():
        motion: Any
        if header["parts"] is None:
            motion = States(scene, System(reduced(scene), digits), [*map(_leg, header["legs"])])
        else:
            motion = Parts(scene, [*map(_restored_part, header["parts"])])
        time, state = header["end"]
        found = PlaneSolution(
            scene,
            arithmetic,
            Status(header["status"]),
            [_event(one, n) for one in header["events"]],
            [str(one) for one in header["modes"]],
            (time, _state(state, n)),
            motion,
            header["t_eval"],
        )
    found.digits, found.tried = header["digits"], str(header["tried"])
    if len(found.modes) != len(found.events) + 1:
        raise ValueError("its count of events is not that of its modes")
    return found


def _part(answer: Any) -> dict[str, Any]:
    return contents(answer) if isinstance(answer, PlaneSolution) else saved.contents(answer)[0]


def _restored_part(header: dict[str, Any]) -> Any:
    return restored(header) if header["format"] == FORMAT else saved.restored(header, {}, Trajectory)


def _state(given: Any, n: int) -> PlaneState:
    found = PlaneState(*map(tuple, given))
    if any(len(one) != n for one in found):
        raise ValueError(f"its states have not {n} axes")
    return found


def _event(given: Any, n: int) -> PlaneEvent:
    t, before, after, y, direction, load, cause = given
    return PlaneEvent(t, str(before), str(after), _state(y, n), tuple(direction), tuple(load), str(cause))


def _leg(given: Any) -> Leg:
    (piece, t, *parts), mode, end, norm, apart = given
    return Leg(Curve(piece, t, *map(Vector, parts)), mode, end, norm, Vector(apart))
