"""`solve --plot F`: one figure that shows a trajectory from four sides."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from numerics.trajectory.export import whole_file
from numerics.trajectory.figures import draw, sampled
from numerics.trajectory.trajectory import Trajectory

KINDS = ("velocities", "positions", "phase", "excess")


def overview(trajectory: Trajectory) -> Any:
    """Return a matplotlib figure: velocities, positions, phase portrait and energy excess, titled by the scene."""
    from matplotlib.figure import Figure

    figure, curve = Figure(figsize=(11, 7.5), layout="constrained"), sampled(trajectory)
    for kind, ax in zip(KINDS, figure.subplots(2, 2).flat, strict=True):
        draw(trajectory, kind, ax, curve)
    pair = trajectory.scene.pair
    named = (("m_1", pair.m1, "kg"), ("m_2", pair.m2, "kg"), ("a_1", pair.a1, "N s/m"), ("a_2", pair.a2, "N/m"))
    given = ", ".join(f"${name}$ = {float(value):g} {unit}" for name, value, unit in (*named, ("b", pair.b, "N")))
    count = len(trajectory.events)
    figure.suptitle(f"{given}: {count} event{'' if count == 1 else 's'}")
    return figure


def write_plot(trajectory: Trajectory, path: Path) -> None:
    """Write the overview to a .svg, .pdf or .png file."""
    figure = overview(trajectory)
    with whole_file(path) as file:
        figure.savefig(file, format=path.suffix[1:])
