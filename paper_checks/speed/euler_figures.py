"""The paper's figures and their scenes, each run by forward Euler with every step."""

from __future__ import annotations

from functools import cache

from numerics.scene.file import load_scene
from numerics.trade.euler import EulerFigure, euler_figure

SCENES = {
    "4 (a)": "start-at-6mm",
    "4 (b), and 5 (b) with b = 0.5 N": "start-with-speed",
    "5 (a), and 5 (b) with b = 0.05 N": "velocities",
    "5 (b) with b = 0.2 N": "relative-motion-b02",
    "3 (a)": "itinerary-that-merges",
    "3 (b)": "itinerary-that-creeps",
}
"""The shipped scene that a figure of the paper shows."""


@cache
def euler_figures() -> tuple[EulerFigure, ...]:
    """Return what forward Euler makes of every figure; takes seconds, once a process."""
    return tuple(euler_figure(figure, load_scene(name)) for figure, name in SCENES.items())
