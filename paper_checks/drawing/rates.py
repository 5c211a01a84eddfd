"""The pictures of the theorems about the 1/t law: explicit bounds, the logarithm after it, its error, what E(0) fixes."""

from __future__ import annotations

from functools import cache

import numpy as np
import sympy as sp
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sympy import lambdify

from numerics.linear.modes import EventKind
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from paper_checks.drawing.style import panels
from theory import rate_bounds, uniform_rate
from theory.excursion import h
from theory.return_map import depth
from theory.symbols import q, r, tau, theta, w

STARTS = ((0.05, "#1b4f8f", "o"), (0.15, "#2e8b3d", "s"), (0.3, "#c8641e", "D"))
"""y at the first exit; the pair has equal masses, L = Omega = M = 1."""
UNTIL = 1000
PAIR = Pair(m1="1/2", m2="1/2", a2=1, b="1/2")
SHARE = 0.5
C, B = 4 * np.pi / 9, 1 - 2 / (5 * SHARE)
TIME = r"$\tau=\Omega t$ (dimensionless)"


@cache
def exits(start: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return times and excesses w at the exits of a pair that leaves by a ray with y = start, binary64; the first at 0."""
    speed = str((SHARE * start) ** 0.5)
    run = solve(Scene(PAIR, State(x1=1, v1=speed, v2=speed), until=UNTIL))
    found = [(float(one.t), float(one.reduced.w)) for one in run.events if one.kind is EventKind.EXIT and one.t > 0]
    times, excesses = np.array([(0.0, SHARE * start), *found]).T
    return times, excesses


def rate_bounds_figure() -> Figure:
    """Draw w over its limit law between the two bounds, from an exit with y = 0.15."""
    start = STARTS[1][0]
    times, excesses = exits(start)
    angle = float(sp.nsolve(h() ** 2 - start, theta, 1.1))
    values = {rate_bounds.first_excess: start, rate_bounds.first_angle: angle}
    values |= {rate_bounds.first_depth: float(depth().subs(theta, angle))}
    low, high = (
        lambdify(rate_bounds.elapsed, bound.subs(values).subs({q: SHARE, r: 1 - SHARE}))(times)
        for bound in rate_bounds.excess_bounds()
    )
    figure, axes = panels(5.4, 3.0)
    axes.fill_between(
        times[1:], (low * times / C)[1:], (high * times / C)[1:], color="#dbe6f4", lw=0, label="between the bounds"
    )
    axes.plot(
        times[1:], (excesses * times / C)[1:], color="black", marker="o", ms=2.5, lw=0.8, label="$w$ at the exits"
    )
    axes.axhline(1, color="#777777", lw=0.8, ls=":")
    axes.set(xscale="log", xlabel=TIME, ylabel=r"$\tau w$ over its limit (dimensionless)", ylim=(0, 1.6))
    axes.legend(loc="lower right")
    return figure


def long_time() -> Figure:
    """Draw what is left of the 1/t law after its logarithm: it tends to one number for each start."""
    figure, axes = panels(5.4, 3.0)
    for start, colour, marker in STARTS:
        times, excesses = (one[2:] for one in exits(start))
        left = (1 - excesses * times / C) * times - np.pi * B * np.log(9 * SHARE / 4 * times / np.pi)
        axes.plot(times, left, color=colour, marker=marker, ms=2.5, lw=0.8, label=f"first $y={start}$")
    axes.set(xscale="log", xlabel=TIME, ylabel="what is left, $\\to K$ (dimensionless)")
    axes.legend()
    return figure


def rate_with_error() -> Figure:
    """Draw the rest R_n of the law with its logarithm, within the bounds that the start fixes."""
    figure, axes = panels(5.4, 3.0)
    for start, colour, marker in STARTS:
        times, excesses = exits(start)
        rest = C / excesses + np.pi * B * np.log(excesses / excesses[0]) - C / excesses[0] - times
        axes.plot(
            np.arange(len(rest)), rest, color=colour, marker=marker, ms=2.5, lw=0.8, label=f"$R_n$, first $y={start}$"
        )
        for bound in ((-0.45 * start**0.5 - 0.45 * start) / SHARE, (0.1 * start**0.5 + 5 * start) / SHARE):
            axes.axhline(bound, color=colour, lw=0.9, ls=":")
    axes.set(xlabel="exit $n$ (dimensionless)", ylabel="$R_n$ and its bounds (dimensionless)", xlim=(0, 60))
    axes.legend(title="dotted: the bounds", loc="upper right")
    return figure


def uniform_rate_figure() -> Figure:
    """Draw w of several motions with one E(0), below the bound that E(0) fixes."""
    first = 2.0  # y of the start: w = 1, so E(0) = 2 E_cr
    times = np.geomspace(1, UNTIL, 400)
    figure, axes = panels(5.4, 3.0)
    axes.plot(times, _uniform(first, times), color="black", lw=1.6, label="bound from $E(0)$")
    for (x1, v1, v2), colour, dashes in (
        ((0, 1, 1), "#1b4f8f", "-"),
        ((0, 1, 3), "#c8641e", "--"),
        ((2, 1, -1), "#2e8b3d", "-."),
    ):
        size = (2 / (x1**2 + (v1**2 + v2**2) / 2)) ** 0.5
        run = solve(Scene(PAIR, State(*(repr(size * one) for one in (x1, v1, 0, v2))), until=UNTIL))
        found = np.array([(float(one.t), float(one.reduced.w)) for one in run.events if one.reduced.w > 0])
        label = f"from $x_1:v_1:v_2={x1}:{v1}:{v2}$"
        axes.plot(found[:, 0], found[:, 1], color=colour, ls=dashes, lw=1.1, label=label)
    axes.set(xscale="log", yscale="log", xlabel=TIME, ylabel="$w$ (dimensionless)")
    axes.legend()
    return figure


def _uniform(first: float, times: NDArray[np.float64]) -> NDArray[np.float64]:
    angle = float(sp.nsolve(h() ** 2 - first, theta, 3.0))
    values = {rate_bounds.first_excess: first, rate_bounds.first_depth: float(depth().subs(theta, angle))}
    number = uniform_rate.crossings_bound().subs(values).subs({q: SHARE, r: 1 - SHARE})
    bound = (
        uniform_rate.upper_bound()
        .subs(uniform_rate.crossings, number)
        .subs(values)
        .subs({q: SHARE, r: 1 - SHARE, w: SHARE * first})
    )
    return np.asarray(lambdify(tau, bound)(times), dtype=float)
