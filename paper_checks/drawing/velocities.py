"""Fig. 5 (a): both velocities against time, exact and by forward Euler; and the relative velocity about the printed 4.7 s."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from numerics.linear.modes import Mode
from numerics.trajectory.trajectory import Trajectory
from paper_checks.drawing.style import (
    BODY_1,
    BODY_2,
    MM,
    SLIDING,
    STEP_TEXT,
    euler,
    mark_events,
    panels,
    samples,
    solved,
)

UNTIL = Fraction(6)
PRINTED = 4.7
"""The paper's time of synchronisation, s."""


def velocities() -> Figure:
    """Draw v1 and v2 for b = 0.05 N from v1(0) = 0.15 m/s."""
    figure, (first, second) = panels(8.2, 5, 2, 1)
    exact, run = solved("velocities", UNTIL), euler("velocities-literal", UNTIL)
    of_euler = f"forward Euler on (11), (12), step {STEP_TEXT}"
    for axes, title, t, y in ((first, "exact", *samples(exact)), (second, of_euler, run.t[::10], run.y[:, ::10])):
        axes.plot(t, MM * y[1], color=BODY_1, label="$\\dot x_1$")
        axes.plot(t, MM * y[3], color=BODY_2, ls=(0, (5, 1.2)), label="$\\dot x_2$")
        axes.set(title=title, xlim=(0, float(UNTIL)), ylim=(-160, 225), xlabel="$t$ (s)", ylabel="velocity (mm/s)")
        axes.axvline(PRINTED, color="#b3007d", lw=3, zorder=1.5, label="printed: $t\\approx 4.7$ s")
    _linear_decay(first, exact)
    mark_events(first, exact, 3)
    first.legend(loc="upper right", ncols=4)
    figure.suptitle("Fig. 5 (a): $b=0.05$ N, $\\dot x_1(0)=150$ mm/s, else 0", fontsize=10)
    return figure


def _linear_decay(axes: Axes, exact: Trajectory) -> None:
    """Draw what an oscillator loses to Coulomb friction in a cycle, 4b/sqrt(a2 m1), from the first positive peak of v1 on."""
    pair, (t, y) = exact.scene.pair, samples(exact)
    rate, cycle = MM * 4 * float(pair.b) / float(pair.a2 * pair.m1) ** 0.5, 2 * np.pi / float(pair.a2 / pair.m1) ** 0.5
    first = np.argmax(np.where(t > cycle / 2, y[1], -np.inf))
    ends = t[first], t[first] + cycle * MM * y[1, first] / rate
    axes.plot(ends, [MM * y[1, first], 0], color="#777777", lw=0.9, label=r"$-4b/\sqrt{a_2m_1}$ a cycle")


def relative_velocity() -> Figure:
    """Draw z' about the printed 4.7 s: exact, and by forward Euler; grey where the exact solution sticks."""
    figure, axes = panels(4.9, 2.8)  # narrow, so that its letters read on a telephone
    exact, run = solved("velocities", UNTIL), euler("velocities-literal", UNTIL)
    t, y = samples(exact)
    axes.plot(t, MM * (y[1] - y[3]), color="black", lw=1.6, label="exact")
    axes.plot(run.t, MM * (run.y[1] - run.y[3]), color="#2e8b3d", ls=(0, (4, 1.2)), label=f"Euler, {STEP_TEXT}")
    stuck = [ends for mode, *ends in zip(exact.modes, exact.t, exact.t[1:], strict=False) if mode is Mode.STICK]
    for place, ends in enumerate(stuck):
        axes.axvspan(*ends, color=SLIDING, zorder=0, linewidth=0, label=None if place else "exact solution sticks")
    axes.axvline(PRINTED, color="#b3007d", lw=3, zorder=1.5, label="printed: $t\\approx 4.7$ s")
    axes.set(xlim=(4.4, 5.6), ylim=(-6, 6), xlabel="$t$ (s)", ylabel="$\\dot z$ (mm/s)")
    axes.legend(loc="lower right")
    return figure
