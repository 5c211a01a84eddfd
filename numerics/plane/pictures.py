"""A motion on a surface, seen from above: both bodies' paths and the relative velocity, with start and end; a film."""

from __future__ import annotations

from functools import partial
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
    explained,
    film,
    together,
)

_POINTS = 3000
_KINDS = {
    "above": ("Both bodies from above", "{} (m)"),
    "relative": ("Relative velocity", "$v_1 - v_2$ along {} (m/s)"),
}
"""Title and label of an axis."""


def overview(trajectory: Any) -> Any:
    """Return a figure: x1 and x2 from above, and v1 - v2 (m/s)."""
    return together([partial(draw, trajectory, kind) for kind in _KINDS], (10, 5.5), course(trajectory))


def draw(trajectory: Any, kind: str, ax: Any = None) -> Any:
    """Draw x1 and x2 from above, or v1 - v2, into axes (new ones, if none are given) and return them."""
    is_new, ax = ax is None, axes_for(kind, _KINDS, ax)
    title, label = _KINDS[kind]
    every = np.linspace(0, float(trajectory.end_time), _POINTS)
    times = np.sort([*every, *trajectory.floats(trajectory.event_times)])
    x1, v1, x2, v2 = trajectory.floats(trajectory.sol(times)).reshape(4, -1, len(times))
    stick = np.array([mode == "stick" or set(mode) == {"0"} for mode in trajectory.mode_at(times)])
    for (x, y, *_), style in ((x1, FIRST), (x2, SECOND)) if kind == "above" else ((v1 - v2, {}),):
        draw_path(ax, x, y, stick, **style)
        turn = np.degrees(np.arctan2(y[-1] - y[-2], x[-1] - x[-2])) - 90
        ax.plot(x[-1], y[-1], color="black", marker=(3, 0, turn), ms=9, ls="none", label="end")
    ax.set_title(title, fontsize="medium")
    ax.set(xlabel=label.format("x"), ylabel=label.format("y"))
    ax.set_aspect("equal", "datalim")
    ax.locator_params(nbins=6)
    return explained(ax, is_new=is_new)


def animate(trajectory: Any, file: str | Path | None, duration: float, frames_per_second: int) -> Any:
    """Return a matplotlib animation from above; see PlaneTrajectory.animate."""

    def drawn(_: Any, y: Any) -> Drawn:
        axes = draw(trajectory, "above")
        marks = [axes.plot([], [], style, color=color, ms=8)[0] for style, color in (("o", BLUE), ("s", ORANGE))]

        def show(k: int) -> None:
            for mark, place in zip(marks, y[..., k].reshape(4, -1)[::2], strict=True):
                mark.set_data(place[:1], place[1:2])

        return axes.figure, show

    return film(trajectory, drawn, file, duration, frames_per_second)
