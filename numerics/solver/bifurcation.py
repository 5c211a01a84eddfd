"""Stroboscopic points of many scenes: the states once a period, after the transient; drawn, a bifurcation diagram."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from numerics.errors import InvalidScene, NumericsError
from numerics.meter import meter
from numerics.scene import Piece, Scene
from numerics.scene.decimals import Exact, listed, positive, require_one_of, require_whole
from numerics.scene.model import require_kind
from numerics.scene.short_repr import ShortRepr
from numerics.solver.inputs import inputs_of
from numerics.solver.solve import solve
from numerics.solver.tables import Tabled
from numerics.tasks import run_tasks
from numerics.trajectory.columns import STATE, Array, Floats

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike


@dataclass(frozen=True, eq=False, repr=False)
class Bifurcation(ShortRepr, Tabled):
    """States once a period: `t` (n, keep) s, `y` (4, n, keep), `inputs` by their names, `success` (n,).

    Points that a run did not reach are nan.

    >>> from numerics import Force, Pair, Scene, State
    >>> base = Scene(Pair(1, 1, 200, "0.5", a1=1), State(), until=60)
    >>> found = bifurcation([base.replace(force=Force.sine(one, 12)) for one in (2, 8, 14)], keep=20)
    >>> found
    Bifurcation(scenes=(Scene(...), Scene(...), Scene(...)), t=array of shape (3, 20), y=array of shape (4, 3, 20), ...)
    >>> found.y.shape, found.success.tolist()
    ((4, 3, 20), [True, True, True])
    >>> found.inputs["force[0].sines[0].amplitude"].tolist(), found.values("v1 - v2").shape
    ([2.0, 8.0, 14.0], (3, 20))
    >>> bool(np.ptp(found.values("v1"), axis=1).max() < 1e-3), found.t[0, -1].round(3).item(), found.ANSWERS[0]
    (True, 59.69, 'v1')
    >>> found.shape, len(found.scenes), [*found.results], found.to_dataframe().shape
    ((3,), 3, ['success', 't', 'x1', 'v1', 'x2', 'v2'], (60, 20))
    >>> found.plot("v1 - v2").get_xlabel()
    'force[0].sines[0].amplitude (N)'
    """

    scenes: list[Scene]
    t: Floats
    y: Floats
    success: Array
    ANSWERS = ("v1", "v1 - v2", "x1 - x2", "x1", "v2", "x2")
    """What can be drawn."""

    @property
    def shape(self) -> tuple[int, ...]:  # type: ignore[override]  # of a frozen record
        """Return (n,)."""
        return self.success.shape

    @property
    def inputs(self) -> dict[str, Floats]:  # type: ignore[override]
        """Return the numbers of the scenes by their names, (n,) each, SI units."""
        return inputs_of(self.scenes)

    @property
    def results(self) -> dict[str, Array]:  # type: ignore[override]
        """Return success, and t, x1, v1, x2 and v2 at the points, by their names."""
        return {"success": self.success, "t": self.t, **dict(zip(STATE, self.y, strict=True))}

    def values(self, answer: str) -> Floats:
        """Return one of `ANSWERS` at the points, (n, keep). Raises ValueError."""
        require_one_of("answer", answer, self.ANSWERS)
        one, *two = (self.y[STATE.index(name)] for name in answer.split(" - "))
        return np.asarray(one - two[0] if two else one)

    @meter("drawing")
    def plot(self, answer: str = "v1", along: str | ArrayLike | None = None, ax: Axes | None = None) -> Axes:
        """Draw one of `ANSWERS` over the input that varies, or `along` (a name, or an array); return the axes.

        Raises ValueError, MissingTool.
        """
        from numerics.solver.batch_picture import draw_bifurcation

        return draw_bifurcation(self, answer, along, ax)


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
    InvalidScene (a scene without a period, or with a shorter run), ValueError.

    >>> from numerics import load_scene
    >>> bifurcation([load_scene("forced-sine-stick-slip").replace(until=40)], keep=10).y.shape
    (4, 1, 10)
    """
    require_whole("keep", keep, 1)
    scenes = list(listed("scenes", scenes))
    for one in scenes:
        require_kind("bifurcation", one, Scene, "give a list of Scenes on a line")
    require_whole("jobs", jobs, 1)
    t, y = np.full((len(scenes), keep), np.nan), np.full((4, len(scenes), keep), np.nan)
    success = np.zeros(len(scenes), bool)
    tasks = [(k, scene, _times(scene, keep, period)) for k, scene in enumerate(scenes)]
    with meter("solving") as progress:
        for k, success[k], y[:, k] in run_tasks(_points, tasks, jobs=jobs, progress=progress):
            t[k] = tasks[k][2]
    return Bifurcation(scenes, t, y, success)


def _points(task: tuple[int, Scene, Floats]) -> tuple[int, bool, Floats]:
    """Return the number of a scene, whether its run succeeded, and the states at some times."""
    k, scene, times = task
    try:
        run = solve(scene)
        return k, run.success, run.floats(run.sol(times))
    except (NumericsError, ValueError):  # undecided, or stopped before these times
        return k, False, np.full((4, len(times)), np.nan)


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
