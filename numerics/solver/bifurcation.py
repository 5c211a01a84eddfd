"""Stroboscopic points of many scenes: the states once a period, after the transient; drawn, a bifurcation diagram."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from numerics.errors import InvalidScene, NumericsError
from numerics.meter import meter
from numerics.scene import Piece, Scene
from numerics.scene.decimals import Exact, listed, positive, require_whole
from numerics.scene.model import require_kind
from numerics.solver.batch import Batch
from numerics.solver.inputs import ended, inputs_of, together
from numerics.solver.solve import solve
from numerics.tasks import run_tasks
from numerics.trajectory.columns import Floats

_DRAWN = ("v1", "v1 - v2", "x1 - x2", "x1", "v2", "x2", "t")


class Bifurcation(Batch):
    """States once a period: `t` (n, keep) s, `y` (4, n, keep); all else as in Batch.

    Points that a run did not reach are nan.

    >>> from numerics import Force, Pair, Scene, State
    >>> base = Scene(Pair(1, 1, 200, "0.5", a1=1), State(), until=60)
    >>> found = bifurcation([base.replace(force=Force.sine(one, 12)) for one in (2, 8, 14)], keep=20)
    >>> found
    Bifurcation of 3 scenes, shape (3,): 3 REACHED_HORIZON; 691 events
    >>> found.y.shape, found.t[0, -1].round(3).item(), found.success.tolist()
    ((4, 3, 20), 59.69, [True, True, True])
    >>> found.inputs["force[0].sines[0].amplitude"].tolist(), found.values("v1 - v2").shape
    ([2.0, 8.0, 14.0], (3, 20))
    >>> bool(np.ptp(found["v1"], axis=1).max() < 1e-3), found.ANSWERS[:3], found.to_dataframe().shape
    (True, ('v1', 'v1 - v2', 'x1 - x2'), (60, 23))
    >>> found.shape, [*found.results]
    ((3,), ['status', 'success', 'v1', 'v1 - v2', 'x1 - x2', 'x1', 'v2', 'x2', 't'])
    >>> found.plot("v1 - v2").get_xlabel()
    'force[0].sines[0].amplitude (N)'
    """


def bifurcation(
    scenes: Sequence[Scene],
    *,
    keep: int = 60,
    period: Exact | None = None,
    jobs: int = 1,
) -> Bifurcation:
    """Solve scenes and return their states once a period, the last `keep` times before the end: a bifurcation diagram.

    `period` in s; left out, 2 pi/omega of the sines that act on each scene; times are multiples of it. What comes
    before the last `keep` periods is left to the transient, so `until` should be some hundred periods. `jobs`
    processes need joblib; a chaotic motion is solved in balls, in a second rather than a millisecond. Raises TypeError,
    InvalidScene (no scene, one without a period, or with a shorter run), ValueError.

    >>> from numerics import load_scene
    >>> bifurcation([load_scene("forced-sine-stick-slip").replace(until=40)], keep=10).y.shape
    (4, 1, 10)
    """
    require_whole("keep", keep, 1)
    scenes = list(listed("scenes", scenes))
    if not scenes:
        raise InvalidScene("scenes = [] holds no scene; give at least one")
    for one in scenes:
        require_kind("bifurcation", one, Scene, "give a list of Scenes on a line")
    require_whole("jobs", jobs, 1)
    tasks = [(scene, _times(scene, keep, period)) for scene in scenes]
    with meter("solving") as progress:
        rows = [*run_tasks(_points, tasks, jobs=jobs, progress=progress)]
    return Bifurcation((len(scenes),), _DRAWN, partial(inputs_of, scenes), partial(together, rows))


def _points(task: tuple[Scene, Floats]) -> dict[str, Any]:
    """Return the answers of a scene by their names: how its run ended, and the states at some times."""
    scene, times = task
    y = np.full((4, len(times)), np.nan)
    try:
        run = solve(scene)
        found = ended(run) | {"digits": run.right_digits}
        if run.reached or run.floats(run.end_time) >= times[-1]:
            y = run.floats(run.sol(times))
    except NumericsError as error:
        found = ended(error) | {"digits": 0}
    return found | {"t": times, "y": y}


def _times(scene: Scene, keep: int, period: Exact | None) -> Floats:
    """Return the last times of a run that are whole periods > 0, s. Raises InvalidScene."""
    sines = [one for pieces in scene.pieces.values() for piece in pieces for one in piece.sines]
    if period is None and not sines:
        raise InvalidScene("no sine acts on this scene; give a period in seconds")
    omega = Piece(0, (), sines).frequency or 0  # of which all are multiples
    if period is None:
        length = 2 * math.pi / float(omega)
        count = math.floor(float(scene.until) / length)
    else:  # exact: the end may be a whole number of periods
        exact = positive(period, "period")
        length, count = float(exact), scene.until // exact
    times = length * (count - np.arange(keep - 1, -1, -1))
    if times[0] <= 0:  # the start is no point
        least = f"keep = {keep} periods of {length:g} s"
        raise InvalidScene(f"until = {float(scene.until):g} s is shorter than {least}; raise it")
    return np.asarray(times)
