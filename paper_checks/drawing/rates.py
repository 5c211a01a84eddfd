"""The pictures of the theorems about the 1/t law: between explicit bounds, and what E(0) fixes."""

from __future__ import annotations

import numpy as np
import sympy as sp
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sympy import lambdify

from numerics.linear.modes import EventKind
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.trajectory import Trajectory
from paper_checks.drawing.style import panels
from theory import rate_bounds, uniform_rate
from theory.excursion import h
from theory.return_map import depth
from theory.symbols import q, r, tau, theta, w

UNTIL, SHARE = 1000, 0.5
LIMIT = 4 * np.pi / 9
"""Of tau w, for equal masses; L = Omega = M = 1."""
TIME = r"$\tau=\Omega t$ (dimensionless)"
STARTS = (((0, 1, 1), "#1b4f8f", "-"), ((0, 1, 3), "#c8641e", "--"), ((2, 1, -1), "#2e8b3d", "-."))
"""Starts x1 : v1 : v2 on one level of the energy."""


def _run(x1: float, v1: float, v2: float) -> Trajectory:
    return solve(Scene(Pair("1/2", "1/2", 1, "1/2"), State(*map(repr, (x1, v1, 0.0, v2))), until=UNTIL))


def _first_slip(excess: float, near: float) -> dict[sp.Symbol, float]:
    """Return angle and depth of the slip that leaves a ray with the excess y, its angle near a given one."""
    angle = float(sp.nsolve(h() ** 2 - excess, theta, near))
    known = {rate_bounds.first_excess: excess, rate_bounds.first_angle: angle, q: SHARE, r: 1 - SHARE}
    return {**known, rate_bounds.first_depth: float(depth().subs(theta, angle))}


def rate_bounds_figure() -> Figure:
    """Draw w at the exits over its limit law between the two bounds, from an exit with y = 0.15."""
    start = 0.15
    speed = (SHARE * start) ** 0.5
    exits = [one for one in _run(1.0, speed, speed).events if one.kind is EventKind.EXIT and one.t > 0]
    times, excesses = np.array([(float(one.t), float(one.reduced.w)) for one in exits]).T
    slip = _first_slip(start, 1.1)
    low, high = (lambdify(rate_bounds.elapsed, one.subs(slip))(times) for one in rate_bounds.excess_bounds())
    figure, axes = panels(5.4, 3.0)
    scale = times / LIMIT
    axes.fill_between(times, low * scale, high * scale, color="#dbe6f4", lw=0, label="between the bounds")
    axes.plot(times, excesses * scale, color="black", marker="o", ms=2.5, lw=0.8, label="$w$ at the exits")
    axes.axhline(1, color="#777777", lw=0.8, ls=":")
    axes.set(xscale="log", xlabel=TIME, ylabel=r"$\tau w$ over its limit (dimensionless)", ylim=(0, 1.6))
    axes.legend(loc="lower right")
    return figure


def uniform_rate_figure() -> Figure:
    """Draw w of several motions with one E(0) = 2 E_cr, below the bound that E(0) fixes."""
    times = np.geomspace(1, UNTIL, 400)
    figure, axes = panels(5.4, 3.0)
    axes.plot(times, _uniform(2.0, times), color="black", lw=1.6, label="bound from $E(0)$")
    for (x1, v1, v2), colour, dashes in STARTS:
        size = (2 / (x1**2 + (v1**2 + v2**2) / 2)) ** 0.5
        events = [one for one in _run(size * x1, size * v1, size * v2).events if one.reduced.w > 0]
        found = np.array([(float(one.t), float(one.reduced.w)) for one in events]).T
        axes.plot(*found, color=colour, ls=dashes, label=f"from $x_1:v_1:v_2={x1}:{v1}:{v2}$")
    axes.set(xscale="log", yscale="log", xlabel=TIME, ylabel="$w$ (dimensionless)")
    axes.legend()
    return figure


def _uniform(first: float, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the bound of w at the times for y = first at the start."""
    slip = _first_slip(first, 3.0)
    known = {**slip, uniform_rate.crossings: uniform_rate.crossings_bound().subs(slip), w: SHARE * first}
    return np.asarray(lambdify(tau, uniform_rate.upper_bound().subs(known))(times), dtype=float)
