"""Many scenes on a surface: every one as by solve(scene), in processes; arrays out."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from importlib.util import find_spec
from typing import Any

import numpy as np

from numerics.errors import NumericsError, OutOfRange
from numerics.scene.plane import AXES, PlaneScene
from numerics.solver.batch import Batch
from numerics.solver.inputs import ended, floats_of, inputs_of, together
from numerics.solver.solve import DIGITS, Limits, solve_to_digits
from numerics.tasks import available_cores, run_tasks
from numerics.trajectory.columns import STATE, room
from numerics.trajectory.status import Status

_FEW = 8
"""So many scenes are solved before other processes have started."""


def _solved(keep: int, max_events: int, scene: PlaneScene) -> dict[str, Any]:
    """Return the answers of a scene by their names; numbers are nan where there is no run."""
    nothing, modes = np.full((2, keep + 1, 2 + 4 * scene.pair.axes), np.nan), [""] * keep
    found = +nothing  # t, energy and state at the first events and at the end; their errors
    try:
        run = solve_to_digits(scene, DIGITS, Limits(max_events))
        kept = min(keep, len(run.events))
        with run.context():
            numbers = np.array([run.t, run.energy, *run.y]).T[[*range(1, kept + 1), -1]]
            found[:, [*range(kept), -1]] = floats_of(numbers)
        if not np.isfinite(found[:, -1]).all():
            raise OutOfRange(Status.OUT_OF_RANGE.sentence)
        modes[:kept] = run.modes[1 : kept + 1]
        answers = ended(run) | {"mode": run.final_mode, "digits": run.digits}
    except NumericsError as error:
        found, answers = nothing, ended(error) | {"mode": "", "digits": 0}
    for end, (t, energy, *states) in zip(("", "_error"), found.swapaxes(1, 2), strict=True):
        y = np.reshape(states, (4, -1, keep + 1)).swapaxes(1, 2)
        answers |= {f"t{end}": t[-1], f"energy{end}": energy[-1], f"y{end}": y[:, -1]}
        answers |= {f"event_t{end}": t[:-1], f"event_y{end}": y[:, :-1]}
    return answers | {"event_mode": np.array(modes, object)}  # texts also where none is kept


def solve_surfaces(
    scenes: Sequence[PlaneScene], max_events: int, keep_events: int, jobs: int | None, progress: Any
) -> Batch:
    """Solve scenes with one number of axes, in turn or in processes (default: on all cores, if joblib is there)."""
    room(f"{len(scenes)} scenes with keep_events = {keep_events}", 2, 13, len(scenes), keep_events)
    if jobs is None:
        jobs = available_cores() if len(scenes) > _FEW and find_spec("joblib") else 1
    solved = partial(_solved, keep_events, max_events)
    rows = [*run_tasks(solved, scenes, jobs=jobs, progress=progress)]
    states = (f"{name}_{axis}" for name in STATE for axis in AXES[: scenes[0].pair.axes])
    drawn = "energy", "events", "digits", "t", *states
    return Batch((len(scenes),), drawn, partial(inputs_of, scenes), partial(together, rows))
