"""A transfer as a picture: both positions, both velocities, and the force beside the friction that it asks for."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from numerics.control.transfer import Transfer
from numerics.scene.decimals import exact_decimal
from numerics.trajectory.figures import BLUE, GRAY, GREEN, ORANGE
from numerics.trajectory.trajectory import Trajectory

_POINTS = 500
_TOGETHER = 1e-12
"""Velocities that are the same to so many parts count as one: a force in decimals leaves 10^-20 of a slip."""


def draw_transfer(found: Transfer, solved: Trajectory) -> Figure:
    """Return the figure of a transfer and its solved scene."""
    scene, time = solved.scene, found.time
    assert time is not None
    pair = scene.pair
    t = float(scene.until) * np.linspace(0, 1 - 1e-12, _POINTS)
    y = np.vectorize(solved.arithmetic.to_float, otypes=[float])(solved.sol(t))
    # the mode says which way friction acts: a slip may be so slow that the velocities are the same floats
    sides = np.array([mode.sign for mode in solved.modes])
    side = sides[np.searchsorted(solved.event_times.astype(float), t, side="right")]
    together = abs(y[1] - y[3]) <= _TOGETHER * abs(y[1]).max()
    u = np.array([float(scene.force(exact_decimal(float(one), "t"))) for one in t])
    load = float(pair.m2 / pair.mass) * (u - float(pair.a2) * y[0] - float(pair.a1) * y[1])
    friction = np.where(side == 0, load, float(pair.b) * side)
    figure = Figure(figsize=(8, 7.2), layout="constrained")
    rows = figure.subplots(3, 1, sharex=True)
    for ax, row, name, unit in ((rows[0], 0, "x", "m"), (rows[1], 1, "v", "m/s")):
        ax.plot(t, y[row], color=BLUE, label=f"${name}_1$")
        ax.plot(t, y[row + 2], color=ORANGE, ls="--", label=f"${name}_2$")
        ax.set_ylabel(f"{'position' if name == 'x' else 'velocity'} ({unit})")
    rows[0].set_title(found.road.value, fontsize="medium")
    rows[2].plot(t, u, color=GREEN, label="force u on body 1")
    rows[2].plot(t, friction, color="black", ls="-.", label="friction on body 2")
    for edge in (-1, 1):
        rows[2].axhline(edge * float(pair.b), color=GRAY, lw=0.8, ls=":")
    rows[2].set(xlabel="t (s)", ylabel="force (N)", xlim=(0, float(scene.until)))
    for ax in rows:
        ax.axvline(float(found.bound), color=GRAY, lw=1, label="no control arrives before")
        ax.axvline(float(time), color="black", lw=0.8, ls=":")
        _shade(ax, t, together)
        ax.legend(fontsize=9, loc="best")
    return figure


def _shade(ax: Any, t: Any, together: Any) -> None:
    ax.fill_between(
        t, 0, 1, where=together, transform=ax.get_xaxis_transform(), color=GRAY, alpha=0.2, lw=0, label="$v_1=v_2$"
    )
