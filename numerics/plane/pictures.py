"""A motion on a surface, seen from above: both bodies' paths and the relative velocity, with start and end; a film."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from numerics.trajectory.figures import (
    BLUE,
    FIRST,
    ORANGE,
    SECOND,
    Drawn,
    axes_for,
    course,
    draw_path,
    film,
    legend_below,
    moved_out,
)

_POINTS, _ALL_POINTS = 30, 3000
_KINDS = {
    "above": ("Both bodies from above", "{} (m)"),
    "relative": ("Relative velocity", "$v_1 - v_2$ along {} (m/s)"),
}
"""Title and label of an axis."""


def overview(trajectory: Any) -> Any:
    """Return a figure: x1 and x2 from above, and v1 - v2 (m/s)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 5.5), layout="constrained")
    common: dict[str, Any] = {}
    for kind, axes in zip(_KINDS, figure.subplots(1, 2), strict=True):
        common |= moved_out(draw(trajectory, kind, axes))
    legend_below(figure, common)
    figure.suptitle(course(trajectory), fontsize="medium")
    return figure


def draw(trajectory: Any, kind: str, axes: Any = None) -> Any:
    """Draw x1 and x2 from above, or v1 - v2, into axes (new ones, if none are given) and return them."""
    axes = axes_for(kind, _KINDS, axes)
    times = [0.0, *trajectory.floats(trajectory.event_times), trajectory.arithmetic.to_float(trajectory.end_time)]
    parts, stick = [], []
    for (start, end), mode in zip(pairwise(times), trajectory.modes, strict=False):
        count = _POINTS + int(_ALL_POINTS * (end - start) / times[-1])
        within = np.minimum(np.linspace(start, end, count), np.nextafter(times[-1], 0))
        parts.append(trajectory.floats(trajectory.sol(within)).reshape(4, -1, count))
        stick += [set(mode) <= {"0"} or mode == "stick"] * count
    x1, v1, x2, v2 = np.concatenate(parts, axis=2)
    for (x, y, *_), style in ((x1, FIRST), (x2, SECOND)) if kind == "above" else ((v1 - v2, {}),):
        draw_path(axes, x, y, np.array(stick), **style)
        turn = np.degrees(np.arctan2(y[-1] - y[-2], x[-1] - x[-2]))
        axes.plot(x[-1], y[-1], color="black", marker=(3, 0, turn - 90), ms=9, ls="none", label="end")
    title, label = _KINDS[kind]
    axes.set_title(title, fontsize="medium")
    axes.set(xlabel=label.format("x"), ylabel=label.format("y"))
    axes.set_aspect("equal", "datalim")
    axes.locator_params(nbins=6)
    marks = moved_out(axes)
    axes.legend(marks.values(), marks, fontsize="small")
    return axes


def animate(trajectory: Any, file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return a matplotlib animation from above; see PlaneTrajectory.animate."""

    def drawn(_: Any, y: Any) -> Drawn:
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(figsize=(5, 5), layout="constrained")
        legend_below(figure, moved_out(draw(trajectory, "above", axes)))
        marks = [axes.plot([], [], "o", color=BLUE, ms=9)[0], axes.plot([], [], "s", color=ORANGE, ms=6)[0]]

        def show(k: int) -> None:
            x1, _, x2, _ = y[..., k].reshape(4, -1)
            for mark, place in zip(marks, (x1, x2), strict=True):
                mark.set_data(place[:1], place[1:2])

        return figure, marks, show

    return film(trajectory, drawn, file, duration, frames_per_second)
