"""What the step of forward Euler does: the time of the first adhesion in Figs. 4 (b) and 5."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from numerics.linear.modes import Mode
from paper_checks.decide.euler_in_balls import STEPS, run
from paper_checks.drawing.style import panels, solved

SCENES = (
    ("start-with-speed", "Fig. 4 (b): $b=0.5$ N", "#2e8b3d", "s"),
    ("relative-motion-b02", "Fig. 5 (b): $b=0.2$ N", "#c8641e", "D"),
    ("velocities", "Fig. 5 (a): $b=0.05$ N", "#1b4f8f", "o"),
)
NEVER = 12.0
"""Where a run that never sticks is drawn, s."""


def euler_convergence() -> Figure:
    """Draw the error of the first adhesion time against the step."""
    figure, axes = panels(4.9, 3.9)
    steps = np.array([float(step) for step in STEPS])
    for name, label, colour, marker in SCENES:
        true = next(float(event.t) for event in solved(name).events if event.after is Mode.STICK)
        times = [run(name, step).adhesion_time for step in STEPS]
        errors = [NEVER if time is None else abs(float(time) - true) for time in times]
        axes.loglog(steps, errors, color=colour, marker=marker, ms=5, lw=1, label=label)
    axes.loglog(steps, steps, color="black", lw=0.8, ls=":", label="one step")
    axes.axhline(NEVER, color="#777777", lw=0.8, ls="--")
    axes.text(1.1e-5, 0.72 * NEVER, "never sticks", va="top", color="#555555")
    axes.set(xlabel="Euler step $h$ (s)", ylabel="error of the first adhesion time (s)", ylim=(3e-6, 30))
    axes.legend(loc="lower right")
    return figure
