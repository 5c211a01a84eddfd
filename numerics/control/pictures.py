"""Pictures of what a control engineer asks, each a matplotlib figure; motions are those of trajectory/figures.py."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import pairwise
from textwrap import fill
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse
from matplotlib.ticker import LogLocator

from numerics.arithmetic.ball import Ball
from numerics.control.thresholds import edges
from numerics.control.tracking import Tracking, acceleration
from numerics.control.transfer import Transfer
from numerics.scene import Force, Pair
from numerics.solver.solve import solve
from numerics.trajectory.curve import sampled
from numerics.trajectory.figures import (
    FIRST,
    GRAY,
    GREEN,
    PURPLE,
    SECOND,
    draw,
    draw_path,
    explain_below,
    together,
)
from numerics.trajectory.trajectory import Trajectory

_DIGITS, _POINTS = 40, 400
_TOGETHER = 1e-12
"""Velocities that are the same to so many parts count as one: a force in decimals leaves 10^-20 of a slip."""
_REGIMES = {
    "a motion sticks permanently": "#dbe7f3",
    "slips, with stops or more reversals": "#f6e3c5",
    "never stops": "#e3cfe3",
}
"""What a motion does below U*, between the lines, and above the upper one; the colours differ in grey too."""


def _panels(width: float, height: float, *grid: int, **how: Any) -> tuple[Figure, Any]:
    """Return a figure (inches) and its axes, in a grid."""
    figure = Figure(figsize=(width, height), layout="constrained")
    return figure, figure.subplots(*grid, **how)


def draw_response(found: Any) -> Figure:
    """Return the velocities and the friction over a period of a Response, and for one sine the thresholds."""
    scene, known = found.one_period(), found.thresholds
    figure, axes = _panels(13.5, 5.6, 1, 3) if known else _panels(8.4, 4.4, 1, 2)
    if scene is not None:
        solved = solve(scene)
        for kind, ax in zip(("velocities", "load"), axes, strict=False):
            draw(solved, kind, ax)
    if known is not None:
        centre = float(known.omega)
        draw_thresholds(found.drive.pair, np.geomspace(centre / 4, 4 * centre, _POINTS), axes[2])
        axes[2].plot(centre, abs(float(found.drive.piece.sines[0].amplitude)), "o", color="black", label="this force")
    _legends_below(axes)
    figure.suptitle(found.regime.value)
    return figure


def draw_rotating(found: Any) -> Figure:
    """Return the circles of both bodies, each about its own centre; u starts along x."""
    figure, ax = _panels(6, 6.5, 1)
    sense, way = (-1j, "clockwise") if found.clockwise else (1j, "counterclockwise")
    turn = np.exp(sense * np.linspace(0, 2 * np.pi, _POINTS)) / (sense * float(found.omega))
    for v, style in ((found.v1, FIRST), (found.v2, SECOND)):
        circle = complex(v) * turn
        draw_path(ax, circle.real, circle.imag, np.zeros(1), **style)
    ax.set(title=f"Both bodies from above, {way}", xlabel="x (m)", ylabel="y (m)", aspect="equal")
    ax.locator_params(nbins=5)
    explain_below(figure)
    figure.suptitle(fill(found.sentence, 60))
    return figure


def draw_thresholds(pair: Pair, omegas: Any, ax: Any) -> Any:
    """Draw U*, U** and the edge of the non-stop regime over frequency into logarithmic axes, and return the axes.

    The regimes are shaded between U* and that edge, which is approximate (`NonStop.edge`).
    """
    with Ball(_DIGITS).context():
        curves = [[float(one) for one in edges(pair, Fraction(float(omega)))] for omega in omegas]
    low, high, edge = np.array(curves).T
    ax.plot(omegas, low, color=PURPLE, label="$U_*$: permanent stick is possible up to it")
    ax.plot(omegas, edge, color="black", label="no stops above this line (drawn, not proved)")
    ax.plot(omegas, high, color=PURPLE, ls="--", label="$U_{**}$: no permanent slip with two reversals below it")
    ax.set(xscale="log", yscale="log", xlim=(omegas[0], omegas[-1]))
    ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter("{x:g}")
    ax.xaxis.set_minor_formatter("")
    ax.set(xlabel=r"frequency $\omega$ (rad/s)", ylabel="amplitude U (N)", title="Thresholds over frequency")
    top = 4 * float(np.nanquantile(edge[np.isfinite(edge)], 0.85))
    bottom = max(min(low.min(), np.nanmin(high)) / 3, top / 1e4)
    borders = [np.clip(one, bottom, top) for one in (0 * low, low, np.maximum(low, edge), np.inf * low)]
    for (below, above), (name, colour) in zip(pairwise(borders), _REGIMES.items(), strict=True):
        ax.fill_between(omegas, below, above, fc=colour, ec="black", lw=0, label=name)
    ax.set(ylim=(bottom, top))
    return ax


def draw_tracking(found: Tracking, pair: Pair) -> Figure:
    """Return the reference, what it asks of the interface beside what that holds, and the force if there is one."""
    figure, axes = _panels(8, 7.2, 3, 1, sharex=True)
    path, bend, end = Force(found.reference), Force(map(acceleration, found.reference)), found.demands[-1].end
    curves = [(path, 1.0, "black"), (bend, float(pair.m2), GREEN)]
    title = "No force makes body 2 follow: the dashed pieces require too much friction"
    if found.scene is not None:
        title = "The force on body 1 that makes body 2 follow"
        curves.append((found.scene.force, 1.0, PURPLE))
    for one in found.demands:
        t = np.linspace(float(one.start), float(one.end), _POINTS, endpoint=False)
        axes[1].fill_between(t, -float(one.b), float(one.b), color=GREEN, alpha=0.2, lw=0)
        for ax, (curve, factor, colour) in zip(axes, curves, strict=False):
            values = [factor * float(curve(at)) for at in t.tolist()]
            ax.plot(t, values, color=colour, ls="-" if one.possible else "--")
    axes[0].set(ylabel="r (m)", title="The reference of body 2")
    axes[1].set(ylabel="friction needed (N)", title="Friction required; shaded: friction available")
    axes[2].set(ylabel="u (N)", xlabel="t (s)", xlim=(0, float(end)), title=title)
    return figure


def draw_transfer(found: Transfer, solved: Trajectory) -> Figure:
    """Return the solved scene of a transfer, with the times before which none arrives, and at which it does."""
    curve = sampled(solved)
    apart = abs(curve.y[1] - curve.y[3])
    curve = curve._replace(stick=apart <= _TOGETHER * abs(curve.y[1]).max())
    drawings = [partial(draw, solved, kind, curve=curve) for kind in ("positions", "velocities", "force", "load")]
    title = f"{fill(found.road.value, 90)}\ndotted: it arrives; dashed: no force arrives before"
    figure = together(drawings, (10, 7), title)
    for ax in figure.axes:
        for time, style in ((found.bound, "--"), (found.time, ":")):
            if time is not None:
                ax.axvline(float(time), color="black", lw=0.8, ls=style)
    return figure


def draw_ring(found: Any) -> Figure:
    """Return Fig. 1 for the scene of a Ring: the relative plane, in float64."""
    entry, radius, rate, centre = (float(one) for one in (found.entry, found.radius, found.rate, found.centre))
    curve = sampled(solve(replace(found.scene, until=max(found.scene.until, Fraction(1.3 * entry)))))
    z, w = curve.y[0] - curve.y[2] - centre, curve.y[1] - curve.y[3]
    figure, ax = _panels(7, 5.2, 1)
    late = curve.t >= entry
    first = int(np.argmax(late))
    ax.plot(z, w, color=GRAY, lw=0.9, label="before")
    ax.plot(z[late], w[late], color="black", lw=1.6, label="inside permanently")
    ax.add_patch(Ellipse((0, 0), 2 * radius, 2 * radius * rate, fill=False, ec="black", ls="--", label="ring"))
    ax.plot(z[first], w[first], "o", color="black", ms=5, label=f"t = {entry:.6g} s")
    ax.set(xlabel="$z - z^*$ (m)", ylabel="$w = v_1 - v_2$ (m/s)", title="The relative motion and its ring")
    _legends_below([ax])
    return figure


def draw_damping(found: Any) -> Figure:
    """Return both times of a Damping over a1, in float64; the damper of the scene, and the best one."""
    a1, times = zip(*found.sampled, strict=True)
    figure, ax = _panels(8, 5.6, 1)
    names = "stuck permanently", f"at rest within {float(found.tolerance):g} m"
    for name, several, color in zip(names, np.array(times, float).T, (PURPLE, GREEN), strict=True):
        ax.plot(a1, np.where(several > 0, several, np.nan), color=color, label=name)
    for damper, style in ((found.scene.pair.a1, "-."), (found.best, ":")):
        if damper:
            ax.axvline(float(damper), color=GRAY, ls=style, label=f"$a_1$ = {float(damper):g} N s/m")
    ax.set(xscale="log", xlabel="$a_1$ (N s/m)", ylabel="time from which it does (s)")
    if any(time > 0 for one in times for time in one):
        ax.set_yscale("log")
    ax.set_title("When the pair sticks for good and when it rests, by its damper")
    _legends_below([ax])
    return figure


def _legends_below(axes: Iterable[Any]) -> None:
    """Put legends where they cover no curve, and few numbers below the curves."""
    for ax in axes:
        if ax.get_legend_handles_labels()[0]:
            ax.legend(fontsize=9, loc="upper center", bbox_to_anchor=(0.5, -0.16))
        if ax.get_xscale() == "linear":
            ax.locator_params(axis="x", nbins=6)
