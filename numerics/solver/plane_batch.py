"""Many scenes on a surface: every one as by solve(scene), in processes; arrays out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from typing import Any, ClassVar

import numpy as np

from numerics.errors import InvalidScene, NumericsError, OutOfRange
from numerics.plane.solve import solve_plane
from numerics.scene.plane import AXES, PlaneScene
from numerics.solver.batch import Batch
from numerics.solver.inputs import floats_of, near
from numerics.solver.solve import solve
from numerics.tasks import available_cores, run_tasks
from numerics.trajectory.columns import STATE, room
from numerics.trajectory.status import Status

_FEW = 8
"""So many scenes are solved before other processes have started."""


@dataclass(frozen=True, eq=False)
class Surfaces:
    """Scenes with one number of axes, and the answers of each by the names of arrays."""

    scenes: Sequence[PlaneScene]
    rows: Sequence[dict[str, Any]]
    NAMES: ClassVar = ("energy", "events", "digits", "t")

    def inputs(self) -> dict[str, Any]:
        """Return "m1 x", "m1 y", ..., m2, b, x1, v1, x2, v2 by axes, and until, (rows,) each, SI units."""
        named = {"until": [one.until for one in self.scenes]}
        for k in range(self.scenes[0].pair.axes):
            for name in ("m1", "m2", "b", *STATE):
                of = [one if name in STATE else one.pair for one in self.scenes]
                named[f"{name} {AXES[k]}"] = [getattr(one, name)[k] for one in of]
        return {name: np.array([near(x) for x in given]) for name, given in named.items()}

    def answers(self) -> dict[str, Any]:
        """Return the arrays of a batch by their names; those of states have x1, v1, x2, v2 along the first axis."""
        words = {"mode", "message", "event_mode"}
        found = {
            name: np.array([row[name] for row in self.rows], dtype=object if name in words else None)
            for name in self.rows[0]
        }
        return {name: np.moveaxis(one, -2, 0) if "y" in name.split("_") else one for name, one in found.items()}


def _solved(keep: int, max_events: int, task: tuple[int, PlaneScene]) -> tuple[int, dict[str, Any]]:
    """Return the answers of a scene, by the names of arrays."""
    row, scene = task
    found: dict[str, Any]
    try:
        run = solve_plane(scene, solve, max_events=max_events)
        with run.context():
            (t, late), (energy, energy_off), both = (floats_of(x) for x in (run.t, run.final_energy, run.y))
        y, off = (x.reshape(4, scene.pair.axes, -1).transpose(2, 0, 1) for x in both)
        if not np.isfinite(off).all():
            raise OutOfRange(Status.OUT_OF_RANGE.sentence)
        found = {"status": run.status, "message": run.message, "mode": run.final_mode, "digits": run.digits}
        modes = [one.after for one in run.events]
    except NumericsError as error:
        capped = isinstance(error, InvalidScene)  # of a part of a box, which has no answer of its own
        ended = Status.EVENT_LIMIT if capped else Status.SEQUENCE_OPEN
        ended = Status.OUT_OF_RANGE if isinstance(error, OutOfRange) else ended
        found, modes = {"status": ended, "message": str(error), "mode": "", "digits": 0}, []
        t = late = energy = energy_off = np.full(1, np.nan)
        y = off = np.full((1, 4, scene.pair.axes), np.nan)
    found |= {"t": t[-1], "energy": energy.flat[0], "energy_error": energy_off.flat[0], "y": y[-1], "y_error": off[-1]}
    found |= {"events": len(modes), "event_mode": (modes + [""] * keep)[:keep]}
    for name, values in (("event_t", t), ("event_t_error", late), ("event_y", y), ("event_y_error", off)):
        beyond = np.full((keep, *values.shape[1:]), np.nan)
        found[name] = np.concatenate([values[1:-1], beyond])[:keep]
    return row, found


def solve_surfaces(
    scenes: Sequence[PlaneScene], max_events: int, keep_events: int, jobs: int | None, progress: Any
) -> Batch:
    """Solve scenes with one number of axes, in turn or in processes (default: on all cores, if joblib is there)."""
    room(f"{len(scenes)} scenes with keep_events = {keep_events}", 2, 13, len(scenes), keep_events)
    if jobs is None:
        jobs = available_cores() if len(scenes) > _FEW and find_spec("joblib") else 1
    solved = partial(_solved, keep_events, max_events)
    rows = dict(run_tasks(solved, [*enumerate(scenes)], jobs=jobs, progress=progress))
    return Batch((len(scenes),), Surfaces(scenes, [rows[row] for row in range(len(scenes))]))
