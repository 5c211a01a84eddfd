"""The relative velocity about the time that the paper prints for synchronisation: exact, and by forward Euler."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from matplotlib.figure import Figure

from numerics.linear.modes import Mode
from numerics.trajectory.trajectory import Trajectory
from paper_checks.drawing.style import MM, SLIDING, STEP_TEXT, euler, panels, samples, solved

UNTIL = Fraction(6)
PRINTED = 4.7
"""The paper's time of synchronisation, s."""


def relative_velocity() -> Figure:
    """Draw z' about the printed 4.7 s: exact, and by forward Euler; grey where the exact solution sticks."""
    figure, axes = panels(4.9, 2.8)  # narrow, so that its letters read on a telephone
    draw_relative_velocity(axes, solved("velocities", UNTIL))
    return figure


def draw_relative_velocity(axes: Any, exact: Trajectory, columns: int = 1) -> None:
    """Draw that into these axes, its legend in so many columns."""
    t, y = samples(exact)
    run = euler("velocities-literal", UNTIL)
    axes.plot(t, MM * (y[1] - y[3]), color="black", lw=1.6, label="exact")
    axes.plot(run.t, MM * (run.y[1] - run.y[3]), color="#2e8b3d", ls=(0, (4, 1.2)), label=f"Euler, {STEP_TEXT}")
    label: str | None = "exact solution sticks"
    for segment, start, end in zip(exact.modes, exact.t, exact.t[1:], strict=False):
        if segment is Mode.STICK:
            axes.axvspan(start, end, color=SLIDING, zorder=0, linewidth=0, label=label)
            label = None
    axes.axvline(PRINTED, color="#b3007d", lw=3, zorder=1.5, label="printed: $t\\approx 4.7$ s")
    axes.set(xlim=(4.4, 5.6), ylim=(-6, 6), xlabel="$t$ (s)", ylabel="$\\dot z$ (mm/s)")
    axes.legend(loc="lower right", ncols=columns)
