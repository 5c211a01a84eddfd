"""The numbers of many scenes by their names: what a sweep varies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from flint import arb

from numerics.scene import Scene
from numerics.scene.model import parameters
from numerics.trajectory.columns import Floats

SI = ("m1", "m2", "a2", "b", "x1", "v1", "x2", "v2", "until", "a1")
"""The numbers of a scene, as the compiled engines take them (free/frame.py)."""
_MOST_PIECES = 100
"""A signal of more pieces is a table of samples, which nobody varies one by one."""


def near(x: object) -> float:
    """Return the float next to an exact number, nan beyond their range."""
    try:
        return float(x)  # type: ignore[arg-type]
    except OverflowError:
        return np.nan


def floats_of(balls: Any) -> tuple[Floats, Floats]:
    """Return the floats next to balls, and how far they may be off."""
    near = np.vectorize(lambda x: float(x.mid()), otypes=[float])(balls)
    off = np.vectorize(lambda x, y: float(abs(x - arb(y)).upper()), otypes=[float])(balls, near)
    return near, off * (1 + 1e-15)


def inputs_of(scenes: Sequence[Scene], shape: tuple[int, ...] = (-1,)) -> dict[str, Floats]:
    """Return the numbers that all of some scenes have, by their names, in a shape; none of tables of samples."""
    tables = {name for one in scenes for name, some in one.pieces.items() if len(some) > _MOST_PIECES}
    found = [parameters(one) | {"until": one.until} for one in scenes]
    names = [name for name in (found[0] if found else ()) if name.partition("[")[0] not in tables]
    common = (name for name in names if all(name in one for one in found))
    return {name: np.reshape([near(one[name]) for one in found], shape) for name in common}


def varying(inputs: dict[str, Floats]) -> dict[str, Floats]:
    """Return the inputs that are not the same everywhere."""
    return {name: one for name, one in inputs.items() if one.size and (one != one.flat[0]).any()}
