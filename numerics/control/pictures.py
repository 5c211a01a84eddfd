"""Pictures of what a control engineer asks, each a matplotlib figure."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, Patch

from numerics.arithmetic.ball import Ball
from numerics.control.response_map import Regimes, ResponseMap
from numerics.control.response_picture import (
    DIGITS,
    SHADES,
    both_bodies,
    draw_lines,
    draw_motions,
    draw_response,
    draw_thresholds,
    legend_below,
    logarithmic,
    mark_limits,
    shade,
    threshold_curves,
)
from numerics.control.ring import Ring
from numerics.control.tracking import Derivative, Tracking
from numerics.control.transfer import Transfer
from numerics.free.quadtree import raster
from numerics.scene import Pair
from numerics.solver.solve import solve
from numerics.trajectory.curve import sampled
from numerics.trajectory.figures import BLUE, GRAY, GREEN, ORANGE, friction_on_body_2
from numerics.trajectory.trajectory import Trajectory

__all__ = [
    "draw_motions",
    "draw_response",
    "draw_response_map",
    "draw_ring",
    "draw_thresholds",
    "draw_tracking",
    "draw_transfer",
]
_POINTS = 400
_TOGETHER = 1e-12
"""Velocities that are the same to so many parts count as one: a force in decimals leaves 10^-20 of a slip."""
LABELS = {
    Regimes.ENTRAINED: "sticks for ever",
    Regimes.BETWEEN: "slips, with stops or more reversals",
    Regimes.NON_STOP: "never stops",
    Regimes.UNDECIDED: "undecided at this depth",
}
"""What a motion does below U*, between the lines, and above the upper one."""
COLOURS = dict(zip(LABELS, (*SHADES, "#777777"), strict=True))
REGIME_COLOURS = {LABELS[one]: COLOURS[one] for one in LABELS if one is not Regimes.UNDECIDED}


def draw_response_map(found: ResponseMap) -> Figure:
    """Return a matplotlib figure of the map: proved cells, U*, U**, and from where on a motion without stops exists.

    That last line is approximate, as `threshold_curves` says; where it lies above U**, a cell between is not non-stop.
    """
    edges = [np.geomspace(float(low), float(high), 2**found.depth + 1) for low, high in (found.omega, found.amplitude)]
    figure = Figure(figsize=(7.6, 6.4), layout="constrained")
    axes = figure.subplots()
    grid, colours = raster(found.leaves, found.depth, list(COLOURS)), ListedColormap(list(COLOURS.values()))
    axes.pcolormesh(*edges, grid, cmap=colours, vmin=-0.5, vmax=len(COLOURS) - 0.5, rasterized=True)
    omegas = np.geomspace(edges[0][0], edges[0][-1], 600)
    lines = draw_lines(axes, omegas, threshold_curves(found.pair, omegas.tolist()))
    logarithmic(axes, *(one[[0, -1]] for one in edges))
    handles: list[Any] = []
    for one, share in found.shares().items():
        proved = "" if one is Regimes.UNDECIDED else "proved: "
        handles.append(Patch(fc=COLOURS[one], ec="black", lw=0.5, label=f"{proved}{LABELS[one]} ({share:.1%})"))
    figure.legend(handles=[*handles, *lines], loc="outside lower center", ncols=2, fontsize=9, frameon=False)
    axes.set_title("What a sine does to the pair: every decided cell is proved")
    return figure


def draw_tracking(found: Tracking, pair: Pair) -> Figure:
    """Return the reference, what it asks of the interface beside what that holds, and the force if there is one."""
    figure = Figure(figsize=(8, 7.2), layout="constrained")
    rows = figure.subplots(3, 1, sharex=True)
    for one in found.demands:
        t = np.linspace(float(one.start), float(one.end), _POINTS)
        piece = found.reference[one.number - 1]
        with Ball(DIGITS).context():
            path, bend = ([float(Derivative(piece, k)(arb(at)).mid()) for at in t] for k in (0, 2))
        style: dict[str, Any] = {"color": BLUE} if one.possible else {"color": ORANGE, "ls": "--"}
        rows[0].plot(t, path, **style)
        rows[1].plot(t, float(pair.m2) * np.array(bend), **style)
        rows[1].fill_between(t, -float(one.b), float(one.b), color=GRAY, alpha=0.25, lw=0)
        if found.scene is not None:
            rows[2].plot(t[:-1], [float(found.scene.force(float(at))) for at in t[:-1]], color=GREEN)
    rows[0].set(ylabel="r (m)", title="The reference of body 2")
    rows[1].set(ylabel="friction needed (N)", title="What it asks of friction; grey: what friction can give")
    title = "The force on body 1 that makes body 2 follow"
    if found.scene is None:
        title = "No force makes body 2 follow: the dashed pieces ask too much"
    rows[2].set(ylabel="u (N)", xlabel="t (s)", xlim=(0, float(found.demands[-1].end)), title=title)
    return figure


def draw_transfer(found: Transfer, solved: Trajectory) -> Figure:
    """Return both positions, both velocities, and the force beside the friction that it asks for, of a solved scene."""
    curve = sampled(solved)
    figure = Figure(figsize=(8, 7.2), layout="constrained")
    rows = figure.subplots(3, 1, sharex=True)
    both_bodies(rows[0], curve, 0, "position (m)")
    both_bodies(rows[1], curve, 1, "velocity (m/s)")
    rows[0].set_title(found.road.value, fontsize="medium")
    rows[2].plot(curve.t, curve.u, color=GREEN, label="force u on body 1")
    rows[2].plot(curve.t, friction_on_body_2(solved, curve), color="black", ls="-.", label="friction on body 2")
    mark_limits(rows[2], solved.scene.pair)
    rows[2].set(xlabel="t (s)", ylabel="force (N)", xlim=(0, curve.t[-1]))
    for ax in rows:
        ax.axvline(float(found.bound), color=GRAY, lw=1, label="no control arrives before")
        if found.time is not None:
            ax.axvline(float(found.time), color="black", lw=0.8, ls=":")
        apart = abs(curve.y[1] - curve.y[3])
        shade(ax, curve, apart <= _TOGETHER * abs(curve.y[1]).max(), "$v_1=v_2$")
        ax.legend(fontsize=9, loc="best")
    return figure


def draw_ring(found: Ring) -> Figure:
    """Return Fig. 1 for a scene: the relative plane and the distance from the limit over time, in float64."""
    entry, radius, rate = (float(one) for one in (found.entry, found.radius, found.rate))
    until = max(float(found.scene.until), 1.3 * entry)
    solved = solve(replace(found.scene, until=Fraction(until)))
    curve = sampled(solved)
    y = np.concatenate([curve.y, solved.sol(entry)[:, None]], axis=1)
    z, w = y[0] - y[2] - float(found.centre), y[1] - y[3]
    distance, inside = np.hypot(z, w / rate)[:-1], curve.t >= entry
    figure = Figure(figsize=(10.5, 5.2), layout="constrained")
    plane, time = figure.subplots(1, 2)
    for part, colour, width, label in ((~inside, ORANGE, 0.9, "before"), (inside, BLUE, 1.6, "inside for good")):
        kept = (np.where(part, one[:-1], np.nan) for one in (z, w))
        plane.plot(*kept, color=colour, lw=width, label=label)
    plane.add_patch(Ellipse((0, 0), 2 * radius, 2 * radius * rate, fill=False, ec="black", ls="--", label="ring"))
    plane.plot(z[-1], w[-1], "o", color="black", ms=5, label=f"t = {entry:.6g} s")
    plane.set(xlabel="$z - z^*$ (m)", ylabel="$w = v_1 - v_2$ (m/s)", title="The relative motion and its ring")
    plane.locator_params(axis="x", nbins=5)
    legend_below(plane)
    time.semilogy(curve.t, np.where(distance > 0, distance, np.nan), color=BLUE, lw=0.9)
    time.axhline(radius, color="black", ls="--", lw=0.9)
    time.axvline(entry, color=GRAY, lw=1)
    time.set(xlabel="t (s)", ylabel="distance from the limit (m)", title="From the line on inside for good")
    return figure
