"""What all figures share: sizes, colours that survive without colour, event markers, samples of trajectories."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib import style as mpl_style
from matplotlib.figure import Figure
from numpy.typing import NDArray

from numerics.linear.modes import EventKind, Mode
from numerics.scene import Scene
from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trade.forward_euler import EulerRun, forward_euler
from numerics.trajectory.trajectory import Trajectory

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
def solved(name: str, until: Fraction | None = None) -> Trajectory:
    """Return a shipped scene solved in float64, which is ample for the eye; the checks enclose the numbers."""
    return solve(_scene(name, until))


@cache
def euler(name: str, until: Fraction | None = None) -> EulerRun:
    """Return forward Euler of a shipped scene, binary64."""
    return forward_euler(_scene(name, until), STEP)


def _scene(name: str, until: Fraction | None) -> Scene:
    scene = load_scene(name)
    return scene if until is None else replace(scene, until=until)


def segment_samples(
    trajectory: Trajectory, points: int = 60
) -> Iterator[tuple[Mode, NDArray[np.float64], NDArray[np.float64]]]:
    """Yield each segment's mode, times (s) and states (4, points); the ends are the events, so no corner is cut."""
    times = trajectory.t
    for mode, start, end in zip(trajectory.modes, times, times[1:], strict=False):
        t = np.linspace(start, end, points)
        inner = trajectory.sol(t[1:-1])
        first, last = trajectory.sol(float(start)), trajectory.sol(float(end), side="left")
        yield mode, t, np.column_stack([first, inner, last])


def samples(trajectory: Trajectory, points: int = 60) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return times (n,) and states (4, n) of the whole trajectory."""
    parts = list(segment_samples(trajectory, points))
    return np.concatenate([t for _, t, _ in parts]), np.concatenate([y for _, _, y in parts], axis=1)


def mark_events(
    axes: Any,
    trajectory: Trajectory,
    row: int,
    *,
    against: int | None = None,
) -> None:
    """Mark entries, exits and crossings by shape; `row` of the state against time, or against another row, in mm."""
    for kind in MARKERS:
        events = [event for event in trajectory.events if event.kind is kind]
        if events:
            across = [event.t if against is None else MM * event.y[against] for event in events]
            axes.plot(
                across,
                [MM * event.y[row] for event in events],
                linestyle="none",
                label=kind.value,
                **marker_style(kind),
            )


def marker_style(kind: EventKind, size: float = 5.5) -> dict[str, Any]:
    """Return how an event of this kind is marked."""
    return {
        "marker": MARKERS[kind],
        "markersize": size,
        "markerfacecolor": "white",
        "markeredgecolor": "black",
        "markeredgewidth": 0.9,
        "zorder": 5,
    }


def shade_sliding_region(axes: Any, trajectory: Trajectory) -> None:
    """Shade |x1| <= L, in mm."""
    half = MM * float(trajectory.scene.pair.half_width)
    axes.axvspan(-half, half, color=SLIDING, zorder=0, linewidth=0, label="$S_0$: $|x_1|\\leq L$")


def thinned(run: EulerRun, rows: Sequence[int], every: int = 10) -> list[NDArray[np.float64]]:
    """Return t (s) and the given rows (mm, mm/s) of every tenth Euler step: more than the eye can tell apart."""
    return [run.t[::every], *(MM * run.y[row, ::every] for row in rows)]
