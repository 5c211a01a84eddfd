"""What all figures share: sizes, colours that survive without colour, event markers, samples of trajectories."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib import style as mpl_style
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from numerics.linear.modes import EventKind, Mode
from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trade.forward_euler import EulerRun, forward_euler
from numerics.trajectory.trajectory import Trajectory

Vector = NDArray[np.float64]
Figures = Mapping[str, Callable[[], Figure]]
"""How each figure is drawn, by the name that findings and sections give it."""
STEP = 1e-4
"""Step of the forward Euler runs that are drawn, s."""
STEP_TEXT = "$10^{-4}$ s"
MM = 1000.0
"""Millimetres in a metre."""
BODY_1, BODY_2 = "#1b4f8f", "#c8641e"
SLIDING = "#e4e4e4"
FRICTIONS = (
    ("velocities", "0.05", "#1b4f8f", "-"),
    ("relative-motion-b02", "0.2", "#c8641e", "--"),
    ("relative-motion-b05", "0.5", "#2e8b3d", "-."),
)
"""The scenes of Fig. 5 (b): name, b in N, colour, line."""
MODE_COLOURS = {Mode.SLIP_PLUS: "#1f5fd0", Mode.SLIP_MINUS: "#cc2222", Mode.STICK: "black"}
MARKERS = {EventKind.ENTRY: "o", EventKind.EXIT: "^", EventKind.CROSSING: "X"}
_RC = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.labelsize": 9,
    "axes.titlesize": 9.5,
    "legend.fontsize": 9,
    "legend.framealpha": 0.92,
    "axes.grid": True,
    "grid.color": "#d9d9d9",
    "grid.linewidth": 0.5,
    "axes.axisbelow": True,
    "lines.linewidth": 1.1,
    "lines.solid_joinstyle": "round",
}


@contextmanager
def house_style() -> Iterator[None]:
    """Draw with matplotlib's defaults and the settings above, whatever the reader's own are; also a decorator."""
    with mpl_style.context("default"), mpl.rc_context(_RC):
        yield


def panels(width: float, height: float, rows: int = 1, columns: int = 1, **shared: Any) -> tuple[Figure, Any]:
    """Return a figure of this size in inches, with a layout that keeps labels apart, and its axes as `subplots` has them."""
    figure = Figure(figsize=(width, height), layout="constrained")
    return figure, figure.subplots(rows, columns, **shared)


@cache
def solved(name: str, until: int | Fraction = 5) -> Trajectory:
    """Return a shipped scene, up to a time in s, solved in float64: ample for the eye; the checks enclose the numbers."""
    return solve(replace(load_scene(name), until=Fraction(until)))


@cache
def euler(name: str, until: int | Fraction = 5) -> EulerRun:
    """Return forward Euler of a shipped scene, up to a time in s, binary64."""
    return forward_euler(replace(load_scene(name), until=Fraction(until)), STEP)


def segment_samples(trajectory: Trajectory, points: int = 60) -> Iterator[tuple[Mode, Vector, Vector]]:
    """Yield each segment's mode, times (s) and states (4, points); the ends are the events, so no corner is cut."""
    for mode, start, end in zip(trajectory.modes, trajectory.t, trajectory.t[1:], strict=False):
        t = np.linspace(start, end, points)
        first, last = trajectory.sol(float(start)), trajectory.sol(float(end), side="left")
        yield mode, t, np.column_stack([first, trajectory.sol(t[1:-1]), last])


def samples(trajectory: Trajectory, points: int = 60) -> tuple[Vector, Vector]:
    """Return times (n,) and states (4, n) of the whole trajectory."""
    _, times, states = zip(*segment_samples(trajectory, points), strict=True)
    return np.concatenate(times), np.concatenate(states, axis=1)


def mark_events(axes: Axes, trajectory: Trajectory, row: int, against: int | None = None) -> None:
    """Mark entries, exits and crossings by shape; `row` of the state against time, or against another row, in mm."""
    for kind in MARKERS:
        events = [event for event in trajectory.events if event.kind is kind]
        if events:
            across = [event.t if against is None else MM * event.y[against] for event in events]
            up = [MM * event.y[row] for event in events]
            axes.plot(across, up, linestyle="none", label=kind.value, **marker_style(kind))


def marker_style(kind: EventKind) -> dict[str, Any]:
    """Return how an event of this kind is marked."""
    white = {"markerfacecolor": "white", "markeredgecolor": "black", "markeredgewidth": 0.9}
    return {"marker": MARKERS[kind], "markersize": 6, "zorder": 5, **white}
