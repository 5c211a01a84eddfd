"""What the paper models: body 1 on a spring and a damper, body 2 on top of it, and between them nothing but dry friction."""

from __future__ import annotations

from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

from paper_checks.drawing.style import BODY_1, BODY_2, panels

COIL = (0, 0, *(0.2, -0.2) * 9, 0, 0)
"""Heights of a spring's turns."""
LINES = (
    ([0, 0], [0, 2.2]),
    ([0, 0.45, *(0.51 + 0.128 * n for n in range(18)), 2.75, 3.2], [1.14 + one for one in COIL]),
    ([0.0, 1.2], [0.52, 0.52]),
    ([2.1, 1.2, 1.2, 2.1], [0.32, 0.32, 0.72, 0.72]),
    ([1.7, 1.7, 1.7, 3.2], [0.38, 0.66, 0.52, 0.52]),
)
"""The wall, the spring, and the damper: a piston in a cylinder that is open towards body 1."""
ARROWS = {"force $u$": (8.8, 10.2, 0.86, BODY_1), "$x_2$": (5.9, 7.1, 2.95, BODY_2), "$x_1$": (3.2, 4.6, -0.42, BODY_1)}
"""Arrows by their texts: from where to where, at which height, in which colour."""
TEXTS = {
    "body 1, $m_1$ (driving)": (6.0, 0.86),
    "body 2, $m_2$\n(driven)": (5.9, 2.02),
    "spring $a_2$": (1.6, 1.62),
    "damper $a_1$": (1.6, -0.42),
}


def two_bodies() -> Figure:
    """Draw the two bodies with their coordinates and forces."""
    figure, axes = panels(4.9, 2.3)  # narrow, so that its letters read on a telephone
    axes.set_axis_off()
    axes.set(xlim=(-0.4, 11.2), ylim=(-0.85, 4.1), aspect="equal")
    axes.add_patch(Rectangle((-0.35, 0), 0.35, 2.2, fc="none", ec="#777777", hatch="////", lw=0))
    axes.add_patch(Rectangle((3.2, 0.32), 5.6, 1.1, fc="#dbe6f4", ec=BODY_1, lw=1.6))
    axes.add_patch(Rectangle((4.6, 1.52), 2.6, 1.0, fc="#f8e3d3", ec=BODY_2, lw=1.6))
    axes.plot([0, 10.6], [0, 0], color="#777777")
    axes.plot([4.6, 7.2], [1.47, 1.47], color="black", lw=2.2, ls=(0, (1, 1)))
    for x in (4.0, 6.0, 8.0):
        axes.add_patch(Circle((x, 0.16), 0.16, fc="none", ec="#777777"))
    for line in LINES:
        axes.plot(*line, color="black")
    for text, place in TEXTS.items():
        axes.text(*place, text, ha="center", va="center")
    leader = {"arrowstyle": "-", "color": "black", "lw": 0.8}
    axes.annotate("friction, at most $b$", (7.2, 1.47), (8.0, 2.35), va="center", arrowprops=leader)
    for text, (start, end, height, colour) in ARROWS.items():
        arrow = {"arrowstyle": "-|>", "color": colour, "lw": 1.4}
        axes.annotate("", (end, height), (start, height), arrowprops=arrow)
        axes.text(end + 0.12, height, text, va="center")
    return figure
