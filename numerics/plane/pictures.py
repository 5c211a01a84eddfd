"""A motion on a surface, seen from above: both bodies' paths and the relative velocity; what sticks is grey; a film."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from numerics.trajectory.figures import BLUE, GRAY, ORANGE, Drawn, axes_for, film

_POINTS, _ALL_POINTS = 30, 3000
_TITLES = {"above": "bodies 1 (blue), 2 (orange); both grey while they stick", "relative": "$v_1-v_2$"}
_UNITS = {"above": "m", "relative": "m/s"}


def overview(trajectory: Any) -> Any:
    """Return a figure: x1 and x2 from above, and v1 - v2 (m/s), by segments."""
    import matplotlib.pyplot as plt

    figure, both = plt.subplots(1, 2, figsize=(9, 4.5), layout="constrained")
    for kind, axes in zip(_TITLES, both, strict=True):
        draw(trajectory, kind, axes)
    return figure


def draw(trajectory: Any, kind: str, axes: Any = None) -> Any:
    """Draw x1 and x2 from above, or v1 - v2, into axes (new ones, if none are given) and return them."""
    axes = axes_for(kind, _TITLES, axes)
    times = [0.0, *trajectory.floats(trajectory.event_times), trajectory.arithmetic.to_float(trajectory.end_time)]
    for (start, end), mode in zip(pairwise(times), trajectory.modes, strict=False):
        count = _POINTS + int(_ALL_POINTS * (end - start) / times[-1])
        within = np.minimum(np.linspace(start, end, count), np.nextafter(times[-1], 0))
        x1, v1, x2, v2 = trajectory.floats(trajectory.sol(within)).reshape(4, -1, count)
        stuck = set(mode) <= {"0"} or mode == "stick"
        lines = [(x1, BLUE), (x2, ORANGE)] if kind == "above" else [(v1 - v2, "C2")]
        for (x, y, *_), color in lines:
            axes.plot(x, y, color=GRAY if stuck else color, lw=1.2)
    axes.set_title(_TITLES[kind], fontsize="medium")
    axes.set_xlabel(f"first component, {_UNITS[kind]}")
    axes.set_ylabel(f"second component, {_UNITS[kind]}")
    axes.set_aspect("equal", "datalim")
    return axes


def animate(trajectory: Any, file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return a matplotlib animation from above; see PlaneTrajectory.animate."""

    def drawn(_: Any, y: Any) -> Drawn:
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(figsize=(5, 5), layout="constrained")
        draw(trajectory, "above", axes)
        marks = [axes.plot([], [], "o", color=BLUE, ms=9)[0], axes.plot([], [], "s", color=ORANGE, ms=6)[0]]

        def show(k: int) -> None:
            x1, _, x2, _ = y[..., k].reshape(4, -1)
            for mark, place in zip(marks, (x1, x2), strict=True):
                mark.set_data(place[:1], place[1:2])

        return figure, marks, show

    return film(trajectory, drawn, file, duration, frames_per_second)
