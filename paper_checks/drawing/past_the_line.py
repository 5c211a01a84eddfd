"""Beyond the paper's pair: friction that jumps or falls, two motions of one force, stuck ellipses, a rotating force."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cache

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from numpy.typing import NDArray

from numerics.control.rotating import rotating_response
from numerics.control.thresholds import thresholds
from numerics.linear.modes import EventKind
from numerics.scene import Force, Friction, Pair, Scene, State, Weakening
from numerics.scene.plane import PlanePair
from numerics.solver.solve import solve
from paper_checks.drawing.style import BODY_1, BODY_2, MM, SLIDING, panels

FRICTIONS = (
    ("rises, $k=-1.5$", (("0.1", "0.575"),), "#8a8a8a"),
    ("constant", (), "black"),
    ("falls, $k=0.3$", (("0.1", "0.485"),), "#2e8b3d"),
    ("falls, $k=1.5$", (("0.1", "0.425"),), BODY_2),
    ("jumps by 0.2 %", None, BODY_1),
)
"""Friction in slip beside 1/2 at rest: its points by the speed, in units L Omega; None is the jump."""
_COLOURS = ("black", "#2e8b3d", BODY_2, BODY_1)


@cache
def exits(points: tuple[tuple[str, str], ...] | None, until: int = 500) -> NDArray[np.float64]:
    """Return the times of the exits from one start with w = 0.04, and tau w over its limit there; L = Omega = M = 1."""
    half, start = Fraction(1, 2), State(1, "0.2", 0, "0.2")
    friction = Friction((), Weakening(speed=points)) if points else Friction()
    pair = Pair(half, half, 1, half) if points is not None else Pair(half, half, 1, "0.499", b_static=half)
    run = solve(Scene(pair, start, until, friction=friction))
    times = np.array([float(one.t) for one in run.events if one.kind is EventKind.EXIT])
    x1, v1, _, _ = (np.array([float(value) for value in row]) for row in run.sol(times))
    return np.array([times, times * (x1**2 + v1**2 - 1) * 9 / (4 * math.pi)])


def static_friction() -> Figure:
    """Draw t (E - E_cr) over its limit for friction that is constant, falls with the speed, or jumps."""
    figure, axes = panels(4.8, 3.4)
    for label, points, colour in FRICTIONS:
        axes.semilogx(*exits(points), color=colour, label=label)
    axes.axhline(1, color="#777777", lw=0.8, ls=":")
    axes.set(xlabel=r"$\tau=\Omega t$ (dimensionless)", ylabel="$t\\,(E-E_{cr})$ over its limit (dimensionless)")
    axes.legend(loc="best")
    return figure


def two_motions() -> Figure:
    """Draw the distance N of two motions under one force, with a constant friction and with one that falls."""
    figure, axes = panels(4.4, 3.4)
    pair, force, times = Pair(1, 1, 200, "0.5"), Force.sine(3, 12), np.linspace(0, 3, 400)
    falling = Weakening(speed=[("0.5", "0.1")])
    for weakening, label, colour in ((None, "constant", BODY_1), (falling, "falls with the speed", BODY_2)):
        friction = Friction((), weakening)
        one, two = (
            _path(Scene(pair, start, 3, force=force, friction=friction), times) for start in (State(), State(v1="0.01"))
        )
        x1, v1, _, v2 = one - two
        distance = np.sqrt(200 * x1**2 + v1**2 + v2**2)
        axes.semilogy(times, distance / distance[0], color=colour, label=f"friction {label}")
    axes.set(xlabel="$t$ (s)", ylabel="$N$ of the difference over its first value (dimensionless)")
    axes.legend(loc="best")
    return figure


def _path(scene: Scene, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (x1, v1, x2, v2) at many times, binary64."""
    return np.vectorize(float, otypes=[float])(solve(scene).sol(times))


def stuck_ellipses() -> Figure:
    """Draw stuck paths that fit into the disc of the radius L, and one that does not, with their energies."""
    figure, axes = panels(4.4, 4.4)
    axes.add_patch(Circle((0, 0), 1, color=SLIDING, zorder=0, label="load within friction"))
    angle = np.linspace(0, 2 * np.pi, 200)
    for long, short, colour in ((1, 0, "black"), (1, 0.5, BODY_2), (1, 1, BODY_1), (1.25, 0.5, "#cc2222")):
        axes.plot(
            long * np.cos(angle), short * np.sin(angle), color=colour, label=f"$E={long**2 + short**2:g}\\,E_{{cr}}$"
        )
    axes.set(
        xlabel="$x/L$ (dimensionless)",
        ylabel="$y/L$ (dimensionless)",
        aspect="equal",
        xlim=(-1.6, 1.6),
        ylim=(-1.5, 2.3),
    )
    axes.legend(loc="upper center", ncols=2)
    return figure


def rotating_force() -> Figure:
    """Draw the constant speed of slip by the amplitude of a force that goes round, for three dampers."""
    figure, axes = panels(4.4, 3.4)
    for a1, colour in zip((1, 4, 16), _COLOURS[1:], strict=True):
        pair = PlanePair(1, 1, 200, "0.5", a1)
        least = float(thresholds(pair, 12).entrainment)
        amplitudes = least * np.linspace(0.5, 3, 60)
        speeds = [MM * float(rotating_response(pair, Fraction(float(one)), 12, 8).speed) for one in amplitudes]
        axes.plot(amplitudes, speeds, color=colour, label=f"$a_1={a1}$ N s/m")
        axes.plot([least], [0], "o", color=colour)
    axes.set(xlabel="amplitude $U$ (N)", ylabel="speed of slip (mm/s)")
    axes.legend(loc="lower right")
    return figure
