"""Pictures of what a control engineer asks, each a matplotlib figure: response, thresholds, reference."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball
from numerics.control.linear import X2, Motion, value
from numerics.control.non_stop import non_stop_edge
from numerics.control.orbit import Drive, Orbit
from numerics.control.response import Regime, Response
from numerics.control.signals import Derivative
from numerics.control.stuck import entrained, flattened_state, stuck_state
from numerics.control.thresholds import non_stop_threshold, stiffness
from numerics.control.tracking import Tracking
from numerics.scene import Pair
from numerics.trajectory.figures import BLUE, GRAY, GREEN, ORANGE

Floats = NDArray[np.float64]
_DIGITS = 16
_POINTS = 240
ENTRAINED, BETWEEN, NON_STOP = "sticks for ever", "slips, with stops or more reversals", "never stops"
"""What a motion does below U*, between the lines, and above the upper one."""
REGIME_COLOURS = {ENTRAINED: "#dbe7f3", BETWEEN: "#f6e3c5", NON_STOP: "#e3cfe3"}


def sampled_motion(motion: Motion, length: arb, count: int = _POINTS) -> Floats:
    """Return time since its start, x1, v1, x2, v2 and the load of a motion, shape (6, count)."""
    step = motion.flow(length / (count - 1))
    z, rows = motion.begin, []
    for k in range(count):
        state = [float(z[place, 0]) for place in range(X2 + 2)]
        rows.append([float(length) * k / (count - 1), *state, float(value(motion.mode.load, z))])
        z = (step * z).mid()
    return np.array(rows).T


def sampled_orbit(orbit: Orbit) -> tuple[Floats, NDArray[np.bool_]]:
    """Return t from the first event, x1, v1, x2, v2 and the friction force on body 2 over a period; where it sticks."""
    parts, stuck, x2 = [], [], 0.0
    with Ball(_DIGITS).context():
        for leg, after in orbit.turns:
            part = sampled_motion(orbit.motion(leg), after.t - leg.t, _POINTS // len(orbit.legs) + 8)
            part[0] += float(leg.t - orbit.legs[0].t)
            part[3] += x2
            x2 = part[3, -1]
            if leg.side:
                part[5] = leg.side * float(orbit.drive.b)
            parts.append(part)
            stuck.append(np.full(part.shape[1], leg.side == 0))
    return np.concatenate(parts, axis=1), np.concatenate(stuck)


def draw_response(found: Response) -> Figure:
    """Return the velocities and the friction force over a period; for one sine the thresholds over frequency too."""
    panels = 3 if found.thresholds is not None else 2
    figure = Figure(figsize=(4.2 * panels, 4.4), layout="constrained")
    axes = figure.subplots(1, panels)
    drive, table, stuck = found.drive, *_over_a_period(found)
    t, clock = table[0], _clock(found)
    axes[0].plot(t, table[2], color=BLUE, label="$v_1$")
    axes[0].plot(t, table[4], color=ORANGE, ls="--", label="$v_2$")
    axes[0].set(xlabel=clock, ylabel="velocity (m/s)", title="The periodic motion, one period")
    axes[1].plot(t, table[5] / float(drive.b), color=GREEN, label="friction on body 2 over b")
    for side in (-1, 1):
        axes[1].axhline(side, color=GRAY, lw=0.8, ls=":")
    axes[1].set(xlabel=clock, ylabel="friction force / b", title="What the interface carries", ylim=(-1.15, 1.15))
    for ax in axes[:2]:
        ax.fill_between(
            t, 0, 1, where=stuck, transform=ax.get_xaxis_transform(), color=GRAY, alpha=0.25, lw=0, label="stick"
        )
        _legend_below(ax)
    if found.thresholds is not None:
        sine = drive.piece.sines[0]
        centre = float(sine.omega)
        draw_thresholds(drive.pair, np.geomspace(centre / 4, 4 * centre, 400), axes[2])
        axes[2].plot(centre, abs(float(sine.amplitude)), "o", color="black", label="this force")
        _legend_below(axes[2])
    figure.suptitle(found.regime.value)
    return figure


def _clock(found: Response) -> str:
    """Return what the time axis counts: an orbit begins with its first event, a stuck motion with the force."""
    if found.orbit is None:
        return "t (s)"
    return f"t since the first {'slip' if found.orbit.legs[0].side else 'stick'} begins (s)"


def _legend_below(ax: Any) -> None:
    """Put the legend under the axes, where it covers no curve."""
    ax.legend(fontsize=9, loc="upper center", bbox_to_anchor=(0.5, -0.16))


def _over_a_period(found: Response) -> tuple[Floats, NDArray[np.bool_]]:
    if found.orbit is not None:
        return sampled_orbit(found.orbit)
    with Ball(_DIGITS).context():
        state = stuck_state(found.drive, arb(0))
        if found.regime is Regime.GROWS or state is None:
            return np.zeros((6, 2)), np.zeros(2, dtype=bool)
        if not entrained(found.drive):
            state = flattened_state(found.drive, arb(0))
        table = sampled_motion(found.drive.mode(0).motion(state, arb(0)), found.drive.period)
    return table, np.full(table.shape[1], True)


def threshold_curves(pair: Pair, omegas: Sequence[float]) -> tuple[Floats, Floats, Floats]:
    """Return U*, U** and the least U >= U** of a motion that slips for ever (N) at frequencies (rad/s), in binary64.

    Both last are infinite where U** is. The last is approximate: w is looked at on a grid of times (`non_stop_edge`).
    """
    low, high, edge = [], [], []
    with Ball(_DIGITS).context():
        for one in omegas:
            omega = Fraction(float(one))
            low.append(float(pair.b / pair.m2 / omega**2) * float(stiffness(pair, pair.mass, omega)))
            high.append(float(non_stop_threshold(pair, omega)))
            edge.append(max(high[-1], non_stop_edge(pair, Ball.number(omega))))
    return np.array(low), np.array(high), np.array(edge)


def draw_thresholds(pair: Pair, omegas: Any, ax: Any) -> Any:
    """Draw U*, U** and the edge of the non-stop regime over frequency into axes, and return the axes.

    The regimes are shaded between U* and that edge, which is approximate as `threshold_curves` says.
    """
    low, high, edge = threshold_curves(pair, omegas)
    top = 4 * float(np.nanquantile(edge[np.isfinite(edge)], 0.85))
    bottom = min(low.min(), np.nanmin(high)) / 3
    bottom = max(bottom, top / 1e4)
    between = np.maximum(low, edge)
    ax.fill_between(omegas, bottom, np.clip(low, bottom, top), color=REGIME_COLOURS[ENTRAINED], lw=0)
    ax.fill_between(
        omegas, np.clip(low, bottom, top), np.clip(between, bottom, top), color=REGIME_COLOURS[BETWEEN], lw=0
    )
    ax.fill_between(omegas, np.clip(between, bottom, top), top, color=REGIME_COLOURS[NON_STOP], lw=0)
    ax.plot(omegas, low, color=BLUE, label="$U_*$: none sticks for ever above it")
    ax.plot(omegas, edge, color="black", label="without a stop from here on")
    ax.plot(omegas, high, color=ORANGE, ls="--", label="$U_{**}$: none without a stop below it")
    ax.set(xscale="log", yscale="log", ylim=(bottom, top), xlim=(omegas[0], omegas[-1]))
    plain_decades(ax)
    ax.set(xlabel=r"frequency $\omega$ (rad/s)", ylabel="amplitude U (N)", title="Thresholds over frequency")
    return ax


def plain_decades(ax: Any) -> None:
    """Label a logarithmic frequency axis by plain numbers that do not meet each other."""
    ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    ax.xaxis.set_minor_formatter(NullFormatter())


def draw_tracking(found: Tracking, pair: Pair) -> Figure:
    """Return the reference, what it asks of the interface beside what that holds, and the force if there is one."""
    figure = Figure(figsize=(8, 7.2), layout="constrained")
    rows = figure.subplots(3, 1, sharex=True)
    last = max(one.end for one in found.demands)
    forces = found.scene.force if found.scene is not None else None
    for one in found.demands:
        t = np.linspace(float(one.start), float(one.end), 400)
        piece = found.reference[one.number - 1]
        with Ball(_DIGITS).context():
            path, bend = ([float(Derivative.of(piece, k)(arb(at)).mid()) for at in t] for k in (0, 2))
        colour = BLUE if one.possible else ORANGE
        rows[0].plot(t, path, color=colour, ls="-" if one.possible else "--")
        rows[1].plot(t, float(pair.m2) * np.array(bend), color=colour, ls="-" if one.possible else "--")
        rows[1].fill_between(t, -float(one.b), float(one.b), color=GRAY, alpha=0.25, lw=0)
        if forces is not None:
            side = [float(forces(Fraction(at))) for at in t[:-1]]
            rows[2].plot(t[:-1], side, color=GREEN)
    rows[0].set(ylabel="r (m)", title="The reference of body 2")
    rows[1].set(ylabel="friction needed (N)", title="What it asks of friction; grey: what friction can give")
    rows[2].set(
        ylabel="u (N)", xlabel="t (s)", xlim=(0, float(last)), title="The force on body 1 that makes body 2 follow"
    )
    if forces is None:
        rows[2].set_title("No force makes body 2 follow: the dashed pieces ask too much")
    return figure


def drift_of_orbits(drive: Drive, orbits: Sequence[Orbit]) -> Floats:
    """Return the mean velocity of body 2 (m/s) in each of some periodic motions, binary64."""
    with Ball(_DIGITS).context():
        return np.array([float((one.travel / drive.period).mid()) for one in orbits])
