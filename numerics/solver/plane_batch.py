"""Many scenes on a surface: every one as by solve(scene), in processes; arrays out."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from importlib.util import find_spec
from typing import Any

import numpy as np

from numerics.errors import NumericsError, OutOfRange
from numerics.scene.plane import PlaneScene
from numerics.solver.batch import Batch
from numerics.solver.inputs import ended_by, floats_of, inputs_of
from numerics.solver.solve import DIGITS, Limits, solve_to_digits
from numerics.tasks import available_cores, run_tasks
from numerics.trajectory.columns import room
from numerics.trajectory.status import Status

_FEW = 8
"""So many scenes are solved before other processes have started."""


def _solved(keep: int, max_events: int, task: tuple[int, PlaneScene]) -> tuple[int, tuple[Any, ...]]:
    """Return the number of a scene, how its run ended, and t, energy and state at the first events and at the end.

    These with their errors, (2, keep + 1, 2 + 4 n); all is nan where there is no run.
    """
    row, scene = task
    found, modes = np.full((2, keep + 1, 2 + 4 * scene.pair.axes), np.nan), [""] * keep
    try:
        run = solve_to_digits(scene, DIGITS, Limits(max_events))
        kept = min(keep, len(run.events))
        with run.context():
            numbers = np.array([run.t, run.energy, *run.y]).T[[*range(1, kept + 1), -1]]
            found[:, [*range(kept), -1]] = floats_of(numbers)
        if not np.isfinite(found[:, -1]).all():
            raise OutOfRange(Status.OUT_OF_RANGE.sentence)
        modes[:kept] = run.modes[1 : kept + 1]
        return row, (run.status, run.message, len(run.events), run.final_mode, run.digits, modes, found)
    except NumericsError as error:
        return row, (ended_by(error), str(error), 0, "", 0, modes, np.full_like(found, np.nan))


def _answers(rows: Sequence[tuple[Any, ...]], axes: int) -> dict[str, Any]:
    """Return the arrays of a batch by their names; those of states have x1, v1, x2, v2 along the first axis."""
    *words, found = zip(*rows, strict=True)
    kinds = {"status": int, "message": object, "events": int, "mode": object, "digits": int, "event_mode": object}
    answers: dict[str, Any] = {
        name: np.array(one, kind) for (name, kind), one in zip(kinds.items(), words, strict=True)
    }
    for end, numbers in zip(("", "_error"), np.array(found).swapaxes(0, 1), strict=True):
        y = np.moveaxis(numbers[..., 2:].reshape(*numbers.shape[:2], 4, axes), 2, 0)
        answers |= {f"t{end}": numbers[:, -1, 0], f"energy{end}": numbers[:, -1, 1], f"y{end}": y[:, :, -1]}
        answers |= {f"event_t{end}": numbers[:, :-1, 0], f"event_y{end}": y[:, :, :-1]}
    return answers


def solve_surfaces(
    scenes: Sequence[PlaneScene], max_events: int, keep_events: int, jobs: int | None, progress: Any
) -> Batch:
    """Solve scenes with one number of axes, in turn or in processes (default: on all cores, if joblib is there)."""
    room(f"{len(scenes)} scenes with keep_events = {keep_events}", 2, 13, len(scenes), keep_events)
    if jobs is None:
        jobs = available_cores() if len(scenes) > _FEW and find_spec("joblib") else 1
    solved = partial(_solved, keep_events, max_events)
    rows = dict(run_tasks(solved, [*enumerate(scenes)], jobs=jobs, progress=progress))
    answers = partial(_answers, [rows[row] for row in range(len(scenes))], scenes[0].pair.axes)
    return Batch((len(scenes),), ("energy", "events", "digits", "t"), partial(inputs_of, scenes), answers)
