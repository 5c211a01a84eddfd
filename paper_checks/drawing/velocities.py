"""Fig. 5 (a): both velocities against time, the exact solution beside forward Euler, and the printed 4.7 s in close-up."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from numerics.trajectory.trajectory import Trajectory
from paper_checks.drawing.relative_velocity import PRINTED, UNTIL, draw_relative_velocity
from paper_checks.drawing.style import (
    BODY_1,
    BODY_2,
    MM,
    STEP_TEXT,
    euler,
    mark_events,
    panels,
    samples,
    solved,
    thinned,
)


def velocities() -> Figure:
    """Draw v1 and v2 for b = 0.05 N from v1(0) = 0.15 m/s."""
    figure, rows = panels(8.2, 7.2, 3, 1)
    exact, run = solved("velocities", UNTIL), euler("velocities-literal", UNTIL)
    t, y = samples(exact)
    euler_t, euler_v1, euler_v2 = thinned(run, (1, 3))
    for axes, title, at, v1, v2 in (
        (rows[0], "exact", t, MM * y[1], MM * y[3]),
        (rows[1], f"forward Euler on (11), (12), step {STEP_TEXT}", euler_t, euler_v1, euler_v2),
    ):
        axes.plot(at, v1, color=BODY_1, label="$\\dot x_1$")
        axes.plot(at, v2, color=BODY_2, ls=(0, (5, 1.2)), label="$\\dot x_2$")
        axes.set(title=title, xlim=(0, float(UNTIL)), ylim=(-160, 225), xlabel="$t$ (s)", ylabel="velocity (mm/s)")
        axes.axvline(PRINTED, color="#b3007d", lw=3, zorder=1.5, label="printed: $t\\approx 4.7$ s")
    _linear_decay(rows[0], exact)
    mark_events(rows[0], exact, 3)
    draw_relative_velocity(rows[2], exact, columns=2)
    rows[2].set_title("close-up: the relative velocity about the printed time")
    rows[0].legend(loc="upper right", ncols=4)
    figure.suptitle("Fig. 5 (a): $b=0.05$ N, $\\dot x_1(0)=150$ mm/s, else 0", fontsize=10)
    return figure


def _linear_decay(axes: Any, exact: Trajectory) -> None:
    """Draw what an oscillator loses to Coulomb friction in a cycle, 4b/sqrt(a2 m1), from the first positive peak of v1 on."""
    pair = exact.scene.pair
    rate, cycle = MM * 4 * float(pair.b) / float(pair.a2 * pair.m1) ** 0.5, 2 * np.pi / float(pair.a2 / pair.m1) ** 0.5
    t, y = samples(exact)
    first = np.argmax(np.where(t > cycle / 2, y[1], -np.inf))
    peak = MM * y[1, first]
    end = t[first] + cycle * peak / rate
    axes.plot([t[first], end], [peak, 0], color="#777777", lw=0.9, label=r"$-4b/\sqrt{a_2m_1}$ a cycle")
