"""The numbers of many scenes by their names: what a sweep varies. And what is read off single runs."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations_with_replacement, product
from typing import Any

import numpy as np
from flint import arb

from numerics.errors import InvalidScene, NumericsError, OutOfRange
from numerics.scene import Scene
from numerics.scene.model import MOST_PIECES, numbers_of, parameters
from numerics.scene.plane import AXES, PlaneScene
from numerics.trajectory.columns import STATE, Floats
from numerics.trajectory.status import Status

SI = ("m1", "m2", "a2", "b", "x1", "v1", "x2", "v2", "until", "a1")
"""The numbers of a scene, as compiled code takes them (linear/batch.py)."""


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


def inputs_of(scenes: Sequence[Scene | PlaneScene], shape: tuple[int, ...] = (-1,)) -> dict[str, Floats]:
    """Return the numbers that all of some scenes have, by their names, in a shape; none of tables of samples."""
    found = [*map(_numbers_of, scenes)]
    common = (name for name in (found[0] if found else ()) if all(name in one for one in found))
    return {name: np.reshape([near(one[name]) for one in found], shape) for name in common}


def _numbers_of(scene: Scene | PlaneScene) -> dict[str, Fraction]:
    """Return the numbers of a scene by their names; on a surface with its axis, or axes, behind them."""
    if not isinstance(scene, PlaneScene):
        return parameters(scene, tables=False) | {"until": scene.until}
    pair, axes, found = scene.pair, AXES[: scene.pair.axes], {"until": scene.until}
    for name in ("m1", "m2", "b", *STATE):
        given = getattr(scene if name in STATE else pair, name)
        found |= {f"{name}_{axis}": one for axis, one in zip(axes, given, strict=True)}
    for name, (i, j) in product(("a1", "a2"), combinations_with_replacement(range(pair.axes), 2)):
        found[f"{name}_{axes[i]}{axes[j] if i < j else ''}"] = getattr(pair, name)[i][j]
    for axis, force in zip(axes, scene.force, strict=True):
        for k, piece in enumerate(force.pieces if len(force.pieces) <= MOST_PIECES else ()):
            found |= numbers_of(f"force_{axis}[{k}]", piece)
    for k, (start, b) in enumerate(scene.friction):
        found |= {f"friction[{k}].from": start}
        found |= {f"friction[{k}].b_{axis}": one for axis, one in zip(axes, b, strict=True)}
    return found


def ended(run: Any) -> dict[str, Any]:
    """Return how a run of a batch ended; of one without an answer, its error: a part of a box may have many events."""
    if not isinstance(run, NumericsError):
        return {"status": run.status, "message": run.message, "events": len(run.events)}
    beyond = Status.EVENT_LIMIT if isinstance(run, InvalidScene) else Status.SEQUENCE_OPEN
    status = Status.OUT_OF_RANGE if isinstance(run, OutOfRange) else beyond
    return {"status": status, "message": str(run), "events": 0}


def together(rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return what was read off each run as arrays by its names; those of states have x1, v1, x2, v2 in front."""
    found = dict[str, Any]()
    for name in rows[0] if rows else ():
        axis = int(name.startswith(("y", "event_y")))
        one = np.stack([np.asarray(row[name]) for row in rows], axis)
        found[name] = one.astype(object) if one.dtype.kind == "U" else one  # texts are those of Python
    return found


def is_of_state(name: str) -> bool:
    """Return whether a name is that of a part of the state, on a surface with its axis behind it."""
    return name.partition("_")[0] in STATE


def varying(inputs: dict[str, Floats]) -> dict[str, Floats]:
    """Return the inputs that are not the same everywhere, each once: a sine in a sum is in several of its pieces."""
    found, known = dict[str, Floats](), dict[str, list[Floats]]()
    for name, one in inputs.items():
        alike = known.setdefault(re.sub(r"\[\d+\]", "", name), [])
        if one.size and (one != one.flat[0]).any() and not any(np.array_equal(one, other) for other in alike):
            found[name] = one
            alike.append(one)
    return found
