"""Many scenes on a surface: every one as by solve(scene), in processes; arrays out."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from importlib.util import find_spec
from typing import Any

import numpy as np

from numerics.errors import InvalidScene, NumericsError, OutOfRange
from numerics.plane.solve import solve_plane
from numerics.scene.plane import AXES, PlaneScene
from numerics.solver.batch import Ends
from numerics.solver.inputs import floats_of, near
from numerics.solver.solve import solve
from numerics.tasks import available_cores, run_tasks
from numerics.trajectory.columns import STATE, Array, Counts, Floats, room
from numerics.trajectory.status import Status

_FEW = 8
"""So many scenes are solved before other processes have started."""


class PlaneBatch(Ends):
    """Final states of many runs on a surface of n axes, one row per scene; `y`, `y_error` (4, rows, n): x1, v1, x2, v2.

    status         a Status; SEQUENCE_OPEN where balls leave the next event open, all else is nan then
    message        the same as a sentence, (rows,)     events    number of events
    mode           "stick", "slip", or signs of a box  t         s, the horizon or the last event
    energy         J                                   digits    proved digits of all events and of the end
    *_error        proved bounds on the errors of these floats
    event_t, event_y, event_mode   the first `keep_events` events, (rows, k), (4, rows, k, n), (rows, k); nan, "" beyond
    event_t_error, event_y_error   bounds on their errors

    >>> from numerics import PlanePair, PlaneScene, solve_scenes
    >>> pair = PlanePair(1, 1, 200, "0.5")
    >>> found = solve_scenes([PlaneScene(pair, 1, x1=[x, "0.002"]) for x in ("0.006", "0.012")], keep_events=1, jobs=1)
    >>> found
    Batch of 2 scenes, shape (2,): 2 REACHED_HORIZON; 13 events
    >>> x1, v1, x2, v2 = found.y
    >>> x1.shape, found.mode.tolist(), found.event_t.round(4).tolist(), bool((found.y_error < 1e-15).all())
    ((2, 2), ['slip', 'stick'], [[0.1081], [0.1735]], True)
    >>> found.success.tolist(), found.message[0], found.digits.tolist(), found.inputs["x1 x"].tolist(), found.ANSWERS
    ([True, True], 'reached the horizon', [15, 15], [0.006, 0.012], ('energy', 'events', 'digits', 't'))
    >>> [*found.results], found.values("t").tolist()
    (['status', 'success', 'energy', 'events', 'digits', 't'], [1.0, 1.0])
    """

    mode: Array
    t: Floats
    energy: Floats
    energy_error: Floats
    y_error: Floats
    digits: Counts
    event_t: Floats
    event_y: Floats
    event_mode: Array
    event_t_error: Floats
    event_y_error: Floats
    ANSWERS = "energy", "events", "digits", "t"
    """What can be drawn."""

    def __init__(self, scenes: Sequence[PlaneScene], rows: Sequence[dict[str, object]]) -> None:
        """Take scenes with one number of axes, and the answers of each by the names of arrays."""
        self.scenes, self.shape = scenes, (len(scenes),)
        for name in rows[0]:
            kind = object if name in {"mode", "message", "event_mode"} else None
            array = np.array([row[name] for row in rows], dtype=kind)
            setattr(self, name, np.moveaxis(array, -2, 0) if "y" in name.split("_") else array)

    @property
    def inputs(self) -> dict[str, Floats]:  # type: ignore[override]  # formed when it is asked for
        """Return "m1 x", "m1 y", ..., m2, b, x1, v1, x2, v2 by axes, and until, (rows,) each, SI units."""
        named = {"until": [one.until for one in self.scenes]}
        for k in range(self.scenes[0].pair.axes):
            for name in ("m1", "m2", "b", *STATE):
                of = [one if name in STATE else one.pair for one in self.scenes]
                named[f"{name} {AXES[k]}"] = [getattr(one, name)[k] for one in of]
        return {name: np.array([near(x) for x in given]) for name, given in named.items()}


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
        events = [one.after for one in run.events]
    except NumericsError as error:
        capped = isinstance(error, InvalidScene)  # of a part of a box, which has no answer of its own
        ended = Status.EVENT_LIMIT if capped else Status.SEQUENCE_OPEN
        ended = Status.OUT_OF_RANGE if isinstance(error, OutOfRange) else ended
        found, events = {"status": ended, "message": str(error), "mode": "", "digits": 0}, []
        t = late = energy = energy_off = np.full(1, np.nan)
        y = off = np.full((1, 4, scene.pair.axes), np.nan)
    modes = events[:keep]
    found |= {"t": t[-1], "energy": energy.flat[0], "energy_error": energy_off.flat[0], "y": y[-1], "y_error": off[-1]}
    found |= {"events": len(events), "event_mode": modes + [""] * (keep - len(modes))}
    for name, values in (("event_t", t), ("event_t_error", late), ("event_y", y), ("event_y_error", off)):
        found[name] = np.full((keep, *values.shape[1:]), np.nan)
        found[name][: len(modes)] = values[1 : len(modes) + 1]
    return row, found


def solve_surfaces(
    scenes: Sequence[PlaneScene], max_events: int, keep_events: int, jobs: int | None, progress: Any
) -> PlaneBatch:
    """Solve scenes with one number of axes, in turn or in processes (default: on all cores, if joblib is there)."""
    room(f"{len(scenes)} scenes with keep_events = {keep_events}", 2, 13, len(scenes), keep_events)
    if jobs is None:
        jobs = available_cores() if len(scenes) > _FEW and find_spec("joblib") else 1
    rows: dict[int, dict[str, Any]] = {}
    for row, found in run_tasks(partial(_solved, keep_events, max_events), [*enumerate(scenes)], jobs=jobs):
        rows[row] = found
        if progress is not None:
            progress(len(rows), len(scenes))
    return PlaneBatch(scenes, [rows[row] for row in range(len(scenes))])
