"""The pair in motion, ten seconds of Fig. 5 (a) from the exact trajectory, as a piece of a page: no network, the same bytes every time."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np

from numerics.linear.modes import Mode
from numerics.scene.file import load_scene
from numerics.solver.solve import solve

SCENE, UNTIL, PRINTED = "velocities", 10, 4.7
"""The scene, how long it is shown, and when the paper sees both bodies synchronise (both in s)."""
RATE = 50
"""Samples a second; between them a page draws straight lines."""


def samples() -> dict[str, object]:
    """Return x1, x2 (um) and v1 - v2 (um/s) at `RATE` samples a second, and from when to when the pair sticks (s)."""
    run = solve(replace(load_scene(SCENE), until=Fraction(UNTIL)))
    x1, v1, x2, v2 = (1e6 * run.sol(np.linspace(0, UNTIL, RATE * UNTIL + 1))).round().astype(int)
    times = [*map(float, run.t)]
    stuck = [
        [round(a, 4), round(b, 4)]
        for mode, a, b in zip(run.modes, times, times[1:], strict=False)
        if mode is Mode.STICK
    ]
    rows = {"x1": x1.tolist(), "x2": x2.tolist(), "slip": (v1 - v2).tolist()}
    return {**rows, "stuck": stuck, "rate": RATE, "until": UNTIL, "printed": PRINTED}


def section() -> str:
    """Return picture, buttons and program as one `<figure id="motion">`."""
    text = Path(__file__).with_name("motion.html").read_text(encoding="utf-8")
    return text.replace("{samples}", json.dumps(samples(), separators=(",", ":")))
