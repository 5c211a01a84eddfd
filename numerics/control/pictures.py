"""Pictures of what a control engineer asks, each a matplotlib figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, Patch
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball
from numerics.control.response import Response
from numerics.control.response_map import Regimes, ResponseMap
from numerics.control.ring import Ring
from numerics.control.thresholds import NonStop, entrainment_threshold, non_stop_threshold
from numerics.control.tracking import Derivative, Tracking
from numerics.control.transfer import Transfer
from numerics.free.quadtree import raster
from numerics.scene import Pair
from numerics.solver.solve import solve
from numerics.trajectory.curve import Curve, sampled
from numerics.trajectory.figures import BLUE, FIRST, GRAY, GREEN, ORANGE, SECOND
from numerics.trajectory.trajectory import Trajectory

Floats = NDArray[np.float64]
_DIGITS = 16
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
COLOURS = dict(zip(LABELS, ("#dbe7f3", "#f6e3c5", "#e3cfe3", "#777777"), strict=True))
"""They differ in grey too."""
REGIME_COLOURS = {LABELS[one]: COLOURS[one] for one in LABELS if one is not Regimes.UNDECIDED}


def draw_response(found: Response) -> Figure:
    """Return the velocities and the friction force over a period; for one sine the thresholds over frequency too."""
    drive, scene, known = found.drive, found.one_period(), found.thresholds
    figure = Figure(figsize=(12.6 if known else 8.4, 4.4), layout="constrained")
    axes = figure.subplots(1, 3 if known else 2)
    if scene is not None:
        solved = solve(scene)
        curve = sampled(solved)
        _two(axes[0], curve, 1, "velocity (m/s)")
        axes[1].plot(curve.t, _friction(solved, curve), color=GREEN, label="friction on body 2")
        for ax in axes[:2]:
            _shade(ax, curve, curve.stick, "stick")
    _limits(axes[1], drive.pair)
    axes[0].set(xlabel="t (s)", title="The periodic motion, one period")
    axes[1].set(xlabel="t (s)", ylabel="force (N)", title="What the interface carries")
    if known is not None:
        centre = float(known.omega)
        draw_thresholds(drive.pair, np.geomspace(centre / 4, 4 * centre, _POINTS), axes[2])
        axes[2].plot(centre, abs(float(drive.piece.sines[0].amplitude)), "o", color="black", label="this force")
    for ax in axes:
        _legend_below(ax)
    figure.suptitle(found.regime.value)
    return figure


def _two(ax: Any, curve: Curve, row: int, label: str) -> None:
    """Draw a coordinate of both bodies, x (row 0) or v (row 1)."""
    ax.plot(curve.t, curve.y[row], **FIRST)
    ax.plot(curve.t, curve.y[row + 2], **SECOND)
    ax.set_ylabel(label)


def _friction(solved: Trajectory, curve: Curve) -> Floats:
    """Return the friction force on body 2, N."""
    signs = np.array([mode.sign for mode in solved.modes])[curve.segment]
    return np.where(curve.stick, curve.load(solved.scene.pair), curve.b * signs)


def _limits(ax: Any, pair: Pair) -> None:
    for edge in (-1, 1):
        ax.axhline(edge * float(pair.b), color=GRAY, lw=0.8, ls=":")


def _shade(ax: Any, curve: Curve, where: NDArray[np.bool_], label: str) -> None:
    over = ax.get_xaxis_transform()
    ax.fill_between(curve.t, 0, 1, where=where, transform=over, color=GRAY, alpha=0.22, lw=0, label=label)


def _legend_below(ax: Any) -> None:
    """Put the legend where it covers no curve."""
    ax.legend(fontsize=9, loc="upper center", bbox_to_anchor=(0.5, -0.16))


def threshold_curves(pair: Pair, omegas: Sequence[float]) -> tuple[Floats, Floats, Floats]:
    """Return U*, U** and the least U >= U** of a motion that slips for ever (N) at frequencies (rad/s), in binary64.

    Both last are infinite where U** is. The last is approximate: w is looked at on a grid of times (`NonStop.edge`).
    """
    with Ball(_DIGITS).context():
        rates = [Fraction(float(one)) for one in omegas]
        low = np.array([float(entrainment_threshold(pair, one)) for one in rates])
        high = np.array([float(non_stop_threshold(pair, one)) for one in rates])
        return low, high, np.maximum(high, [NonStop(pair, one).edge() for one in rates])


def draw_thresholds(pair: Pair, omegas: Any, ax: Any) -> Any:
    """Draw U*, U** and the edge of the non-stop regime over frequency into axes, and return the axes.

    The regimes are shaded between U* and that edge, which is approximate as `threshold_curves` says.
    """
    low, high, edge = threshold_curves(pair, omegas)
    top = 4 * float(np.nanquantile(edge[np.isfinite(edge)], 0.85))
    bottom = max(min(low.min(), np.nanmin(high)) / 3, top / 1e4)
    borders = [np.clip(one, bottom, top) for one in (0 * low, low, np.maximum(low, edge), np.inf * low)]
    for below, above, colour in zip(borders, borders[1:], REGIME_COLOURS.values(), strict=False):
        ax.fill_between(omegas, below, above, color=colour, lw=0)
    _draw_lines(ax, omegas, (low, high, edge))
    _logarithmic(ax, (omegas[0], omegas[-1]), (bottom, top))
    ax.set(title="Thresholds over frequency")
    return ax


def _draw_lines(ax: Any, omegas: Any, curves: tuple[Floats, Floats, Floats]) -> list[Any]:
    low, high, edge = curves
    lines = ax.plot(omegas, low, color=BLUE, label="$U_*$: up to it a motion sticks for ever")
    lines += ax.plot(omegas, edge, color="black", label="no stops from this line on (drawn, not proved)")
    lines += ax.plot(omegas, high, color=ORANGE, ls="--", label="$U_{**}$: none without a stop below it")
    return list(lines)


def _logarithmic(ax: Any, omegas: Any, amplitudes: Any) -> None:
    """Make axes of frequency and amplitude; frequencies are plain numbers that do not meet each other."""
    ax.set(xscale="log", yscale="log", xlim=omegas, ylim=amplitudes)
    ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.set(xlabel=r"frequency $\omega$ (rad/s)", ylabel="amplitude U (N)")


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
    lines = _draw_lines(axes, omegas, threshold_curves(found.pair, omegas.tolist()))
    _logarithmic(axes, *(one[[0, -1]] for one in edges))
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
        with Ball(_DIGITS).context():
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
    _two(rows[0], curve, 0, "position (m)")
    _two(rows[1], curve, 1, "velocity (m/s)")
    rows[0].set_title(found.road.value, fontsize="medium")
    rows[2].plot(curve.t, curve.u, color=GREEN, label="force u on body 1")
    rows[2].plot(curve.t, _friction(solved, curve), color="black", ls="-.", label="friction on body 2")
    _limits(rows[2], solved.scene.pair)
    rows[2].set(xlabel="t (s)", ylabel="force (N)", xlim=(0, curve.t[-1]))
    for ax in rows:
        ax.axvline(float(found.bound), color=GRAY, lw=1, label="no control arrives before")
        if found.time is not None:
            ax.axvline(float(found.time), color="black", lw=0.8, ls=":")
        apart = abs(curve.y[1] - curve.y[3])
        _shade(ax, curve, apart <= _TOGETHER * abs(curve.y[1]).max(), "$v_1=v_2$")
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
    _legend_below(plane)
    time.semilogy(curve.t, np.where(distance > 0, distance, np.nan), color=BLUE, lw=0.9)
    time.axhline(radius, color="black", ls="--", lw=0.9)
    time.axvline(entry, color=GRAY, lw=1)
    time.set(xlabel="t (s)", ylabel="distance from the limit (m)", title="From the line on inside for good")
    return figure
