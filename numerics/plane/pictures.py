"""A motion on a surface, seen from above: both bodies' paths and the relative velocity; what sticks is grey; a film."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from numerics.trajectory.figures import BLUE, GRAY, ORANGE, axes_for, film

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
        x1, v1, x2, v2 = _at(trajectory, np.minimum(np.linspace(start, end, count), np.nextafter(times[-1], 0)))
        stuck = set(mode) <= {"0"} or mode == "stick"
        lines = [(x1, BLUE), (x2, ORANGE)] if kind == "above" else [(v1 - v2, "C2")]
        for (x, y, *_), color in lines:
            axes.plot(x, y, color=GRAY if stuck else color, lw=1.2)
    axes.set_title(_TITLES[kind], fontsize="medium")
    axes.set_xlabel(f"first component, {_UNITS[kind]}")
    axes.set_ylabel(f"second component, {_UNITS[kind]}")
    axes.set_aspect("equal", "datalim")
    return axes


def _at(trajectory: Any, times: Any) -> Any:
    """Return x1, v1, x2, v2 at times (s): (4, n, m), in binary64."""
    return trajectory.floats(trajectory.sol(times)).reshape(4, -1, len(times))


def animate(trajectory: Any, file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return a matplotlib animation from above; see PlaneTrajectory.animate."""

    def drawn(count: int) -> Any:
        import matplotlib.pyplot as plt

        times = np.linspace(0.0, trajectory.arithmetic.to_float(trajectory.end_time), count)
        (x1, _, x2, _), modes = _at(trajectory, times), trajectory.mode_at(times)
        figure, axes = plt.subplots(figsize=(5, 5), layout="constrained")
        draw(trajectory, "above", axes)
        marks = [axes.plot([], [], "o", color=BLUE, ms=9)[0], axes.plot([], [], "s", color=ORANGE, ms=6)[0]]

        def show(k: int) -> tuple[Any, ...]:
            for mark, (x, y, *_) in zip(marks, (x1, x2), strict=True):
                mark.set_data([x[k]], [y[k]])
            axes.set_title(f"t = {times[k]:.3f} s, {modes[k]}", fontsize="medium")
            return tuple(marks)

        return figure, show

    return film(drawn, file, duration, frames_per_second)
