"""Beyond the paper's pair: friction that jumps or falls, and stuck ellipses on a surface."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from numpy.typing import NDArray

from numerics.linear.modes import EventKind
from numerics.scene import Friction, Pair, Scene, State, Weakening
from numerics.solver.solve import solve
from paper_checks.drawing.style import BODY_1, BODY_2, SLIDING, panels

HALF = Fraction(1, 2)
FRICTIONS = (
    ("rises, $k=-1.5$", ("0.1", "0.575"), "#8a8a8a"),
    ("constant", None, "black"),
    ("falls, $k=0.3$", ("0.1", "0.485"), "#2e8b3d"),
    ("falls, $k=1.5$", ("0.1", "0.425"), BODY_2),
)
"""Friction in slip beside 1/2 at rest: a point of it by the speed, in units L Omega."""


def exits(pair: Pair, friction: Friction, until: int = 500) -> NDArray[np.float64]:
    """Return the times of the exits from one start with w = 0.04, and tau w over its limit there; L = Omega = M = 1."""
    run = solve(Scene(pair, State(1, "0.2", 0, "0.2"), until, friction=friction))
    times = np.array([float(one.t) for one in run.events if one.kind is EventKind.EXIT])
    x1, v1, _, _ = (np.array([float(value) for value in row]) for row in run.sol(times))
    return np.array([times, times * (x1**2 + v1**2 - 1) * 9 / (4 * math.pi)])


def static_friction() -> Figure:
    """Draw t (E - E_cr) over its limit for friction that is constant, falls with the speed, or jumps."""
    figure, axes = panels(4.8, 3.4)
    for label, point, colour in FRICTIONS:
        friction = Friction((), Weakening(speed=[point])) if point else Friction()
        axes.semilogx(*exits(Pair(HALF, HALF, 1, HALF), friction), color=colour, label=label)
    jumping = Pair(HALF, HALF, 1, "0.499", b_static=HALF)
    axes.semilogx(*exits(jumping, Friction()), color=BODY_1, label="jumps by 0.2 %")
    axes.axhline(1, color="#777777", lw=0.8, ls=":")
    axes.set(xlabel=r"$\tau=\Omega t$ (dimensionless)", ylabel="$t\\,(E-E_{cr})$ over its limit (dimensionless)")
    axes.legend(loc="best")
    return figure


def stuck_ellipses() -> Figure:
    """Draw stuck paths that fit into the disc of the radius L, and one that does not, with their energies."""
    figure, axes = panels(4.4, 4.4)
    axes.add_patch(Circle((0, 0), 1, color=SLIDING, zorder=0, label="load within friction"))
    angle = np.linspace(0, 2 * np.pi, 200)
    for long, short, colour in ((1, 0, "black"), (1, 0.5, BODY_2), (1, 1, BODY_1), (1.25, 0.5, "#cc2222")):
        label = f"$E={long**2 + short**2:g}\\,E_{{cr}}$"
        axes.plot(long * np.cos(angle), short * np.sin(angle), color=colour, label=label)
    axes.set(xlabel="$x/L$ (dimensionless)", ylabel="$y/L$ (dimensionless)", aspect="equal")
    axes.set(xlim=(-1.6, 1.6), ylim=(-1.5, 2.3))
    axes.legend(loc="upper center", ncols=2)
    return figure
