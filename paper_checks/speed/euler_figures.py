"""The paper's figures and their scenes, each run by forward Euler with every step."""

from __future__ import annotations

from functools import cache

from numerics.scene.file import load_scene
from numerics.trade.euler import EulerFigure, euler_figure

SCENES = {
    "3 (a)": "start-at-6mm",
    "3 (b), and 4 (b) with b = 0.5 N": "start-with-speed",
    "4 (a), and 4 (b) with b = 0.05 N": "velocities",
    "4 (b) with b = 0.2 N": "relative-motion-b02",
    "5 (a)": "itinerary-that-merges",
    "5 (b)": "itinerary-that-creeps",
}
"""The shipped scene that a figure of the paper shows."""


@cache
def euler_figures() -> tuple[EulerFigure, ...]:
    """Return what forward Euler makes of every figure; takes seconds, once a process."""
    return tuple(euler_figure(figure, load_scene(name)) for figure, name in SCENES.items())
