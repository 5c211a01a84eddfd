"""Draw the pictures of README and of these pages: python docs/pictures.py."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.figure import Figure

from numerics import load_scene, solve
from numerics.trajectory.figures import explain_below
from paper_checks.drawing.ellipse_in_strip import ellipse_in_strip
from paper_checks.drawing.model import two_bodies
from paper_checks.drawing.style import house_style

HERE = Path(__file__).resolve().parent
GALLERY = HERE / "gallery.md"
matplotlib.rcParams["svg.hashsalt"] = "inertial-pair"  # the same bytes every time


def velocities() -> Figure:
    """Draw both velocities of the paper's Fig. 5 (a), solved by events."""
    figure = Figure(figsize=(7, 2.9), layout="constrained")
    solve(load_scene("velocities")).plot("velocities", figure.subplots())
    explain_below(figure)
    return figure


def gallery() -> Iterator[tuple[str, Any]]:
    """Yield the names of the pictures of the gallery, and what its blocks of code draw."""
    found: dict[str, Any] = {}
    for name, code in re.findall(
        r"\(gallery-(\w+)\.png\).*?```python\n(.*?)```", GALLERY.read_text("utf-8"), re.DOTALL
    ):
        exec(compile(code, GALLERY.name, "exec"), found)
        picture = found["picture"]
        yield name, picture.flat[0].figure if hasattr(picture, "flat") else getattr(picture, "figure", picture)


if __name__ == "__main__":
    for name, figure in gallery():
        if len(figure.axes) < 3:
            figure.set_size_inches(6, 3.8)
        figure.savefig(HERE / f"gallery-{name}.png", dpi=90, facecolor="white", metadata={"Software": None})
    with house_style():
        ellipse = ellipse_in_strip()
    for name, figure in (("model", two_bodies()), ("velocities", velocities()), ("ellipse-in-strip", ellipse)):
        figure.savefig(HERE / f"{name}.svg", metadata={"Date": None}, facecolor="white")
