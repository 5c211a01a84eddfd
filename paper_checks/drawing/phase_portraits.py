"""Fig. 4 (a), (b) and Fig. 5 (b): phase portraits, the exact solution beside forward Euler."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from matplotlib.figure import Figure

from numerics.linear.modes import EventKind
from numerics.trade.forward_euler import EulerRun
from numerics.trajectory.trajectory import Trajectory
from paper_checks.drawing.style import (
    BODY_1,
    BODY_2,
    MM,
    STEP_TEXT,
    euler,
    mark_events,
    marker_style,
    panels,
    samples,
    shade_sliding_region,
    solved,
    thinned,
)

SHOWN = Fraction(3, 2)
"""How long Fig. 4 is drawn, s: more would fill the picture with ever the same."""
FRICTIONS = (
    ("relative-motion-b005", "#1b4f8f", "-"),
    ("relative-motion-b02", "#c8641e", "--"),
    ("relative-motion-b05", "#2e8b3d", "-."),
)


def start_at_6mm() -> Figure:
    """Draw both bodies from x1(0) = 0.006 m, b = 0.5 N."""
    return _bodies(
        solved("start-at-6mm", SHOWN),
        euler("start-at-6mm-literal", SHOWN),
        "Fig. 4 (a): $b=0.5$ N, $x_1(0)=6$ mm, else 0; up to $t=1.5$ s",
        "exact: slips at once, never sticks for good",
        "forward Euler on (11), (12), step " + STEP_TEXT + ": stuck",
    )


def start_with_speed() -> Figure:
    """Draw both bodies from v1(0) = 0.15 m/s, b = 0.5 N."""
    return _bodies(
        solved("start-with-speed", SHOWN),
        euler("start-with-speed-literal", SHOWN),
        "Fig. 4 (b): $b=0.5$ N, $\\dot x_1(0)=150$ mm/s, else 0; up to $t=1.5$ s",
        "exact: stick and slip alternate permanently",
        "forward Euler on (11), (12), step " + STEP_TEXT + ": chatter",
    )


def _bodies(exact: Trajectory, run: EulerRun, title: str, left: str, right: str) -> Figure:
    figure, (first, second) = panels(8.2, 4.4, 1, 2, sharex=True, sharey=True)
    _, y = samples(exact)
    _, *rows = thinned(run, (0, 1, 2, 3))
    for axes, name, (x1, v1, x2, v2) in ((first, left, MM * y), (second, right, rows)):
        shade_sliding_region(axes, exact)
        axes.plot(x1, v1, color=BODY_1, label="body 1: $(x_1,\\dot x_1)$")
        axes.plot(x2, v2, color=BODY_2, ls=(0, (5, 1.5)), label="body 2: $(x_2,\\dot x_2)$")
        axes.plot([x1[0], x2[0]], [v1[0], v2[0]], linestyle="none", marker="s", ms=4.5, color="black", label="start")
        axes.set(xlabel="position (mm)", ylabel="velocity (mm/s)", title=name)
    mark_events(first, exact, 1, against=0)
    figure.suptitle(title, fontsize=10)
    figure.legend(*first.get_legend_handles_labels(), loc="outside lower center", ncols=7)
    return figure


def relative_motion() -> Figure:
    """Draw z' against z for the three values of b, from v1(0) = 0.15 m/s, and the end of it in close-up."""
    figure, grid = panels(8.2, 7.0, 2, 2, sharex="row", sharey="row")
    until = Fraction(6)
    for name, colour, dashes in FRICTIONS:
        exact, run = solved(name, until), euler(name, until)
        _, y = samples(exact)
        _, x1, v1, x2, v2 = thinned(run, (0, 1, 2, 3), every=5)
        for left, right in grid:
            label = f"$b={float(exact.scene.pair.b):g}$ N"
            left.plot(MM * (y[0] - y[2]), MM * (y[1] - y[3]), color=colour, ls=dashes, label=label)
            right.plot(x1 - x2, v1 - v2, color=colour, ls=dashes)
    for name, _, _ in FRICTIONS:
        _mark(grid[1, 0], solved(name, until))
    for axes in grid.flat:
        axes.axhline(0, color="black", lw=0.6, zorder=1)
        axes.set(xlabel="$z=x_1-x_2$ (mm)", ylabel="$\\dot z=\\dot x_1-\\dot x_2$ (mm/s)")
    for row, what in zip(grid, ("", ", close-up"), strict=True):
        row[0].set_title(f"exact{what}")
        row[1].set_title(f"forward Euler on (11), (12), step {STEP_TEXT}{what}")
    grid[1, 0].set(xlim=(-1.0, 3.0), ylim=(-14, 24))
    figure.suptitle("Fig. 5 (b): $\\dot x_1(0)=150$ mm/s, else 0; up to $t=6$ s", fontsize=10)
    handles, labels = grid[1, 0].get_legend_handles_labels()
    unique = dict(zip(labels, handles, strict=True))
    figure.legend(unique.values(), unique.keys(), loc="outside lower center", ncols=6)
    return figure


def _mark(axes: Any, trajectory: Trajectory) -> None:
    """Mark the events up to the second exit on z' = 0: later ones would hide each other.

    In stick z does not change: an exit lies on its entry, so the mark of an exit fits into that of an entry.
    """
    size = {EventKind.ENTRY: 8.5, EventKind.EXIT: 4.0, EventKind.CROSSING: 6.0}
    exits = [n for n, kind in enumerate(trajectory.event_kinds) if kind is EventKind.EXIT]
    for event in trajectory.events[: exits[1] + 1]:
        z = MM * (event.y[0] - event.y[2])
        axes.plot(z, 0, linestyle="none", label=event.kind.value, **marker_style(event.kind, size[event.kind]))
