"""Pictures of a periodic motion and of thresholds over frequency, and what all pictures of this room share."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import cycle
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball
from numerics.control.thresholds import NonStop, entrainment_threshold, non_stop_threshold
from numerics.scene import Pair
from numerics.solver.solve import solve
from numerics.trajectory.curve import Curve, sampled
from numerics.trajectory.figures import BLUE, FIRST, GRAY, GREEN, ORANGE, SECOND, friction_on_body_2

Floats = NDArray[np.float64]
DIGITS = 16
_POINTS = 400
SHADES = ("#dbe7f3", "#f6e3c5", "#e3cfe3")
"""Of what a motion does below U*, between the lines, and above the upper one; they differ in grey too."""


def draw_response(found: Any) -> Figure:
    """Return the velocities and the friction over a period of a Response, and for one sine the thresholds."""
    drive, scene, known = found.drive, found.one_period(), found.thresholds
    figure = Figure(figsize=(12.6 if known else 8.4, 4.4), layout="constrained")
    axes = figure.subplots(1, 3 if known else 2)
    if scene is not None:
        solved = solve(scene)
        curve = sampled(solved)
        both_bodies(axes[0], curve, 1, "velocity (m/s)")
        axes[1].plot(curve.t, friction_on_body_2(solved, curve), color=GREEN, label="friction on body 2")
        for ax in axes[:2]:
            shade(ax, curve, curve.stick, "stick")
    mark_limits(axes[1], drive.pair)
    axes[0].set(xlabel="t (s)", title="The periodic motion, one period")
    axes[1].set(xlabel="t (s)", ylabel="force (N)", title="What the interface carries")
    if known is not None:
        centre = float(known.omega)
        draw_thresholds(drive.pair, np.geomspace(centre / 4, 4 * centre, _POINTS), axes[2])
        axes[2].plot(centre, abs(float(drive.piece.sines[0].amplitude)), "o", color="black", label="this force")
    for ax in axes:
        legend_below(ax)
    figure.suptitle(found.regime.value)
    return figure


def draw_motions(found: Any) -> Figure:
    """Return friction against the speed of the slip, and the cycles of PeriodicMotions as x1 against v1 - v2."""
    figure = Figure(figsize=(10.4, 5), layout="constrained")
    law, plane = figure.subplots(1, 2)
    fastest = 0.0
    for number, (one, colour) in enumerate(zip(found.motions, cycle((BLUE, ORANGE, GREEN, "black"))), start=1):
        scene = one.one_period()
        if scene is None:
            continue
        solved = solve(scene)
        curve = sampled(solved)
        w, leaves = curve.y[1] - curve.y[3], any(abs(size) > 1 for size in one.multipliers or ())
        name = f"{number}: {one.regime.value.split(':')[0]}{', which others leave' if leaves else ''}"
        size = float(abs(w).max())
        # the widest lies below the others
        how: dict[str, Any] = {
            "color": colour,
            "ls": "--" if leaves else "-",
            "label": name,
            "zorder": 2 + 1 / (1 + size),
        }
        law.plot(w, friction_on_body_2(solved, curve), **how)
        plane.plot(curve.y[0], w, **how)
        fastest = max(fastest, size)
    speeds = np.linspace(0, 1.15 * fastest or 1, _POINTS)
    given = float(found.drive.pair.b) * found.drive.cells.relative(speeds, 0 * speeds)
    both = np.concatenate([-speeds[::-1], speeds]), np.concatenate([-given[::-1], given])
    law.plot(*both, color=GRAY, lw=6, alpha=0.4, zorder=0, label="what friction can be")
    law.set(xlabel="$v_1 - v_2$ (m/s)", ylabel="friction on body 2 (N)", title="Friction against the speed")
    plane.set(xlabel="$x_1$ (m)", ylabel="$v_1 - v_2$ (m/s)", title="The periodic motions")
    for ax in (law, plane):
        ax.locator_params(axis="x", nbins=6)
        legend_below(ax)
    figure.suptitle(found.sentence)
    return figure


def both_bodies(ax: Any, curve: Curve, row: int, label: str) -> None:
    """Draw a coordinate of both bodies, x (row 0) or v (row 1)."""
    ax.plot(curve.t, curve.y[row], **FIRST)
    ax.plot(curve.t, curve.y[row + 2], **SECOND)
    ax.set_ylabel(label)


def mark_limits(ax: Any, pair: Pair) -> None:
    """Draw -b and b."""
    for edge in (-1, 1):
        ax.axhline(edge * float(pair.b), color=GRAY, lw=0.8, ls=":")


def shade(ax: Any, curve: Curve, where: NDArray[np.bool_], label: str) -> None:
    """Shade times over the whole height of the axes."""
    over = ax.get_xaxis_transform()
    ax.fill_between(curve.t, 0, 1, where=where, transform=over, color=GRAY, alpha=0.22, lw=0, label=label)


def legend_below(ax: Any) -> None:
    """Put the legend where it covers no curve."""
    ax.legend(fontsize=9, loc="upper center", bbox_to_anchor=(0.5, -0.16))


def threshold_curves(pair: Pair, omegas: Sequence[float]) -> tuple[Floats, Floats, Floats]:
    """Return U*, U** and the least U >= U** of a motion that slips for ever (N) at frequencies (rad/s), in binary64.

    Both last are infinite where U** is. The last is approximate: w is looked at on a grid of times (`NonStop.edge`).
    """
    with Ball(DIGITS).context():
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
    for below, above, colour in zip(borders, borders[1:], SHADES, strict=False):
        ax.fill_between(omegas, below, above, color=colour, lw=0)
    draw_lines(ax, omegas, (low, high, edge))
    logarithmic(ax, (omegas[0], omegas[-1]), (bottom, top))
    ax.set(title="Thresholds over frequency")
    return ax


def draw_lines(ax: Any, omegas: Any, curves: tuple[Floats, Floats, Floats]) -> list[Any]:
    """Draw the `threshold_curves` over frequency and return the lines."""
    low, high, edge = curves
    lines = ax.plot(omegas, low, color=BLUE, label="$U_*$: up to it a motion sticks for ever")
    lines += ax.plot(omegas, edge, color="black", label="no stops from this line on (drawn, not proved)")
    lines += ax.plot(omegas, high, color=ORANGE, ls="--", label="$U_{**}$: none without a stop below it")
    return list(lines)


def logarithmic(ax: Any, omegas: Any, amplitudes: Any) -> None:
    """Make axes of frequency and amplitude; frequencies are plain numbers that do not meet each other."""
    ax.set(xscale="log", yscale="log", xlim=omegas, ylim=amplitudes)
    ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.set(xlabel=r"frequency $\omega$ (rad/s)", ylabel="amplitude U (N)")
