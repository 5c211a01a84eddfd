"""The paper's figures and their scenes, each run by forward Euler with every step."""

from __future__ import annotations

from functools import cache

from numerics.scene.file import load_scene
from numerics.trade.euler import EulerFigure, euler_figure

SCENES = {
    "3 (a)": "figure-3a",
    "3 (b), and 4 (b) with b = 0.5 N": "figure-3b",
    "4 (a), and 4 (b) with b = 0.05 N": "figure-4a",
    "4 (b) with b = 0.2 N": "figure-4b-b02",
    "5 (a)": "figure-5a",
    "5 (b)": "figure-5b",
}
"""The shipped scene that a figure of the paper shows."""


@cache
def euler_figures() -> tuple[EulerFigure, ...]:
    """Return what forward Euler makes of every figure; takes seconds, once a process."""
    return tuple(euler_figure(figure, load_scene(name)) for figure, name in SCENES.items())
