"""What the step of forward Euler does: time of the first adhesion in Figs. 4 (b) and 5, energy of the stuck pair of 4 (a)."""

from __future__ import annotations

from typing import Any

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
    """Draw the error of the first adhesion time against the step, and the energy gained in stick against time."""
    figure, (error, energy) = panels(8.2, 3.9, 1, 2)
    _draw_errors(error)
    _draw_energy(energy)
    return figure


def _draw_errors(axes: Any) -> None:
    steps = np.array([float(step) for step in STEPS])
    for name, label, colour, marker in SCENES:
        exact = solved(name)
        true = next(float(event.t) for event in exact.events if event.after is Mode.STICK)
        times = [run(name, step).adhesion_time for step in STEPS]
        errors = [NEVER if time is None else abs(float(time) - true) for time in times]
        axes.loglog(steps, errors, color=colour, marker=marker, ms=5, lw=1, label=label)
    axes.loglog(steps, steps, color="black", lw=0.8, ls=":", label="one step")
    axes.axhline(NEVER, color="#777777", lw=0.8, ls="--")
    axes.text(1.1e-5, 0.72 * NEVER, "never sticks", va="top", color="#555555")
    axes.set(
        xlabel="Euler step $h$ (s)",
        ylabel="error of the first adhesion time (s)",
        ylim=(3e-6, 30),
        title="when the bodies first stick",
    )
    axes.legend(loc="lower right")


def _draw_energy(axes: Any) -> None:
    pair = solved("start-at-6mm").scene.pair
    square = float(pair.a2 / pair.mass)  # Omega^2, 1/s^2
    t = np.linspace(0, 5, 200)
    for step, dashes in ((1e-3, "-"), (1e-4, "--"), (1e-5, "-.")):
        growth = np.exp(t / step * np.log1p(step**2 * square))
        axes.plot(t, growth, color="#1b4f8f", ls=dashes, label=f"$h=10^{{{round(np.log10(step))}}}$ s")
    axes.axhline(1, color="black", lw=0.8, ls=":", label="exact")
    axes.set(xlabel="$t$ (s)", ylabel="$E(t)/E(0)$ (dimensionless)", title="energy of the stuck pair, Fig. 4 (a)")
    axes.legend(loc="upper left")
