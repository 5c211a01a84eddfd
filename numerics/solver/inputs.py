"""The numbers of many scenes by their names, with units: what a sweep varies."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from numerics.scene import Scene
from numerics.scene.model import parameters
from numerics.scene.plane import AXES
from numerics.trajectory.columns import Floats
from numerics.trajectory.export import OF_ANGLE

SI = ("m1", "m2", "a2", "b", "x1", "v1", "x2", "v2", "until", "a1")
"""The numbers of a scene, as the compiled engines take them (free/frame.py)."""
_MOST_PIECES = 100
"""A signal of more pieces is a table of samples, which nobody varies one by one."""
_UNITS = (
    "m1: kg, m2: kg, a1: N s/m, a2: N/m, b: N, b_static: N, until: s, x1: m, v1: m/s, x2: m, v2: m/s, from: s, "
    "omega: rad/s, phase: rad, last_slope: N s/m, w: m/s, c: N, z: m, t: s, energy: J, dissipated: J, "
    "mode: sign of v1 - v2"
)
UNITS = dict(one.split(": ") for one in _UNITS.split(", "))
_OF_SIGNALS = {"belt": "m/s", "wall": "m"}


def unit(name: str) -> str:
    """Return the unit of a number of a scene, or of a result; a signal without another name is a force.

    >>> unit("a2"), unit("sines[0].amplitude"), unit("wall[1].polynomial[2]"), unit("belt[0].sines[0].omega")
    ('N/m', 'N', 'm/s^2', 'rad/s')
    >>> unit("v1 - v2"), unit("x1_at_t"), unit("m1 phi"), unit("events")
    ('m/s', 'm', 'kg m^2', '')
    """
    whole, _, axis = name.removesuffix("_at_t").partition(" ")
    last = whole.rpartition(".")[2]
    own, (key, _, order) = _OF_SIGNALS.get(whole.partition("[")[0], "N"), last.rstrip("]").partition("[")
    if key != "polynomial":
        found = own if last == "amplitude" else UNITS.get(last, "")
        return OF_ANGLE.get(found, found) if axis == AXES[2] else found
    return own + ("" if order == "0" else "/s" if order == "1" else f"/s^{order}")


def near(x: object) -> float:
    """Return the float next to an exact number, nan beyond their range."""
    try:
        return float(x)  # type: ignore[arg-type]
    except OverflowError:
        return np.nan


def inputs_of(scenes: Sequence[Scene]) -> dict[str, Floats]:
    """Return the numbers that all of some scenes have, by their names, but for those of tables of samples."""
    tables = {name for one in scenes for name, some in one.pieces.items() if len(some) > _MOST_PIECES}
    found = [parameters(one) | {"until": one.until} for one in scenes]
    names = [name for name in (found[0] if found else ()) if name.partition("[")[0] not in tables]
    return {name: np.array([near(one[name]) for one in found]) for name in names if all(name in one for one in found)}


def varying(inputs: dict[str, Floats]) -> dict[str, Floats]:
    """Return the inputs that are not the same everywhere."""
    return {name: one for name, one in inputs.items() if one.size and (one != one.flat[0]).any()}
