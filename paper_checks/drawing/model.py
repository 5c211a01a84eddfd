"""What the paper models: body 1 on a spring and a damper, body 2 on top of it, and between them nothing but dry friction."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

from paper_checks.drawing.style import BODY_1, BODY_2, panels

_COIL = 9
"""Turns of the spring that is drawn."""
_SPRING, _DAMPER = 1.14, 0.52
"""Their heights above the ground."""


def two_bodies() -> Figure:
    """Draw the two bodies with their coordinates and forces."""
    figure, axes = panels(4.9, 2.3)  # narrow, so that its letters read on a telephone
    axes.set_axis_off()
    axes.set(xlim=(-0.4, 11.2), ylim=(-0.85, 4.1), aspect="equal")
    axes.add_patch(Rectangle((-0.35, 0), 0.35, 2.2, fc="none", ec="#777777", hatch="////", lw=0))
    axes.plot([0, 0], [0, 2.2], color="black", lw=1.4)
    axes.plot([0, 10.6], [0, 0], color="#777777", lw=1)
    _spring(axes)
    _damper(axes)
    axes.add_patch(Rectangle((3.2, 0.32), 5.6, 1.1, fc="#dbe6f4", ec=BODY_1, lw=1.6))
    axes.add_patch(Rectangle((4.6, 1.52), 2.6, 1.0, fc="#f8e3d3", ec=BODY_2, lw=1.6))
    axes.plot([4.6, 7.2], [1.47, 1.47], color="black", lw=2.2, ls=(0, (1, 1)))
    for x in (4.0, 6.0, 8.0):
        axes.add_patch(Circle((x, 0.16), 0.16, fc="none", ec="#777777", lw=1))
    axes.text(3.55, 0.86, "body 1, $m_1$ (driving)", va="center", fontsize=9.5)
    axes.text(5.9, 2.02, "body 2, $m_2$\n(driven)", ha="center", va="center", fontsize=9)
    axes.text(1.6, 1.5, "spring $a_2$", ha="center", fontsize=9.5)
    axes.text(1.6, -0.42, "damper $a_1$", ha="center", va="center", fontsize=9.5)
    axes.annotate("friction, at most $b$", (7.2, 1.47), (8.0, 2.35), fontsize=9.5, va="center",
                  arrowprops={"arrowstyle": "-", "color": "black", "lw": 0.8})  # fmt: skip
    _arrow(axes, (8.8, 0.86), (10.2, 0.86), "force $u$", BODY_1)
    _arrow(axes, (5.9, 2.95), (7.1, 2.95), "$x_2$", BODY_2)
    _arrow(axes, (3.2, -0.42), (4.6, -0.42), "$x_1$", BODY_1)
    return figure


def _spring(axes: Any) -> None:
    ends, heights = [0.0, 0.45], [_SPRING, _SPRING]
    for turn in range(_COIL):
        ends += [0.45 + (turn + 0.25) * 2.3 / _COIL, 0.45 + (turn + 0.75) * 2.3 / _COIL]
        heights += [_SPRING + 0.2, _SPRING - 0.2]
    axes.plot([*ends, 2.75, 3.2], [*heights, _SPRING, _SPRING], color="black", lw=1.1)


def _damper(axes: Any) -> None:
    """Draw a piston in a cylinder that is open towards body 1."""
    for x, y in (
        ([0.0, 1.2], [_DAMPER, _DAMPER]),
        ([2.1, 1.2, 1.2, 2.1], [_DAMPER - 0.2, _DAMPER - 0.2, _DAMPER + 0.2, _DAMPER + 0.2]),
        ([1.7, 1.7], [_DAMPER - 0.14, _DAMPER + 0.14]),
        ([1.7, 3.2], [_DAMPER, _DAMPER]),
    ):
        axes.plot(x, y, color="black", lw=1.1)


def _arrow(axes: Any, start: tuple[float, float], end: tuple[float, float], text: str, colour: str) -> None:
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.4})
    axes.text(end[0] + 0.12, end[1], text, va="center", fontsize=9.5)
