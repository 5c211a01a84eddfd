"""A motion on a surface, seen from above: both bodies' paths and the relative velocity, with start and end; a film."""

from __future__ import annotations

from functools import partial
from typing import Any, NamedTuple

import numpy as np

from numerics.trajectory.columns import Floats
from numerics.trajectory.figures import BLUE, FIRST, ORANGE, SECOND, Drawn, course, draw, draw_path, film, together

__all__ = ["KINDS", "draw", "film", "filmed", "overview", "sampled"]

_POINTS = 3000


class Seen(NamedTuple):
    """Times (m,), s, x1, v1, x2, v2 by axes (4, n, m), and whether the bodies stick."""

    t: Floats
    y: Floats
    stick: Any


def sampled(trajectory: Any) -> Seen:
    """Return points for drawing, those of the events among them."""
    every = np.linspace(0, trajectory.arithmetic.to_float(trajectory.end_time), _POINTS)
    t = np.sort([*every, *trajectory.floats(trajectory.event_times)])
    y = trajectory.floats(trajectory.sol(t)).reshape(4, -1, len(t))
    return Seen(t, y, np.array([mode == "stick" or set(mode) == {"0"} for mode in trajectory.mode_at(t)]))


def overview(trajectory: Any) -> Any:
    """Return a figure: x1 and x2 from above, and v1 - v2 (m/s)."""
    seen = sampled(trajectory)
    return together([partial(draw, trajectory, kind, curve=seen) for kind in KINDS], (10, 5.5), course(trajectory))


def _paths(across: str, is_above: bool, _: Any, seen: Seen, ax: Any) -> None:
    """Draw x1 and x2 from above, or v1 - v2."""
    x1, v1, x2, v2 = seen.y
    for (x, y, *_), style in ((x1, FIRST), (x2, SECOND)) if is_above else ((v1 - v2, {}),):
        draw_path(ax, x, y, seen.stick, **style)
        turn = np.degrees(np.arctan2(y[-1] - y[-2], x[-1] - x[-2])) - 90
        ax.plot(x[-1], y[-1], color="black", marker=(3, 0, turn), ms=9, ls="none", label="end")
    ax.set_xlabel(across)
    ax.set_aspect("equal", "datalim")
    ax.locator_params(nbins=6)


KINDS = {
    "above": ("Both bodies from above", "y (m)", partial(_paths, "x (m)", True)),
    "relative": (
        "Relative velocity",
        "$v_1 - v_2$ along y (m/s)",
        partial(_paths, "$v_1 - v_2$ along x (m/s)", False),
    ),
}


def filmed(trajectory: Any, _: Any, y: Any) -> Drawn:
    """Draw both bodies on their paths."""
    axes = draw(trajectory, "above")
    marks = [axes.plot([], [], style, color=color, ms=8)[0] for style, color in (("o", BLUE), ("s", ORANGE))]

    def show(k: int) -> None:
        for mark, place in zip(marks, y[..., k].reshape(4, -1)[::2], strict=True):
            mark.set_data(place[:1], place[1:2])

    return axes.figure, show
