"""Draw the pictures of README and of these pages: python docs/pictures.py."""

from __future__ import annotations

from pathlib import Path

import matplotlib
from matplotlib.figure import Figure

from numerics import load_scene, solve
from numerics.trajectory.figures import explain_below
from paper_checks.drawing.ellipse_in_strip import ellipse_in_strip
from paper_checks.drawing.model import two_bodies
from paper_checks.drawing.style import house_style

HERE = Path(__file__).resolve().parent
matplotlib.rcParams["svg.hashsalt"] = "inertial-pair"  # the same bytes every time


def velocities() -> Figure:
    """Draw both velocities of the paper's Fig. 5 (a), solved by events."""
    figure = Figure(figsize=(7, 2.9), layout="constrained")
    solve(load_scene("velocities")).plot("velocities", figure.subplots())
    explain_below(figure)
    return figure


if __name__ == "__main__":
    with house_style():
        ellipse = ellipse_in_strip()
    for name, figure in (("model", two_bodies()), ("velocities", velocities()), ("ellipse-in-strip", ellipse)):
        figure.savefig(HERE / f"{name}.svg", metadata={"Date": None}, facecolor="white")
