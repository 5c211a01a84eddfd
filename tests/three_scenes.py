"""A pair that slips, one with a damper, one that sticks; and the arithmetics in which `solve` answers."""

from typing import Any

from numerics import Pair, Scene, State

PAPER = Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), until=3)
DAMPED = Scene(Pair(1, 1, 200, "0.5", a1=4), State(v1="0.45"), until=3)
STUCK = Scene(PAPER.pair, State(x1="0.001"), until=3)
ARITHMETICS: list[dict[str, Any]] = [
    {},
    {"arithmetic": "mpmath"},
    {"arithmetic": "ball", "digits": 20},
]
SCENE = "[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = 0.5\n[initial]\nv1 = 0.15\n[run]\nuntil = 2\n"
"""The text of the first, for two seconds."""
HOW = [*ARITHMETICS, {"digits": 12}, {"max_events": 3}]
"""Ways to solve a scene, as arguments of `solve`."""
