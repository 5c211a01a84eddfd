"""Derivatives of events and ends by the numbers of a scene: by which of them, and of what."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from numerics.scene import Scene
from numerics.trajectory.variation import Array

WRT = ("x1", "v1", "x2", "v2", "m1", "m2", "a2", "b", "a1")
"""The initial state and the parameters of a free pair, in the order of the last axis of every array."""


@dataclass(frozen=True)
class Sensitivity:
    """Partial derivatives in SI units with respect to `wrt`, the last axis; enclosed, if the trajectory is of balls.

    Float arrays for float64, otherwise object arrays of the arithmetic's numbers.
    """

    wrt: tuple[str, ...]
    t: Array
    """Of the time of every event, shape (k, p), with p = 9 without a force."""
    y: Array
    """Of x1, v1, x2, v2 at every event, shape (k, 4, p): total derivatives, the time of the event moves too."""
    final: Array
    """Of x1, v1, x2, v2 at the fixed horizon, shape (4, p); at the last event if the cap on events ended the run."""
    energy: Array
    """Of the energy there, shape (p,)."""

    def __repr__(self) -> str:
        """Return a short summary."""
        return f"Sensitivity of {len(self.t)} events and the final state by {', '.join(self.wrt)}"


def parameters(scene: Scene) -> dict[str, Fraction]:
    """Return every number of a scene by its name, in the order of the last axis of all derivatives; exact.

    Without a force those of `WRT`, else `until` too. Pieces and what is in them are counted from 0, as in Python:
    `force[0].from`, `force[0].polynomial[1]`, `force[0].sines[0].amplitude` (`omega`, `phase`), `friction[0].from`,
    `friction[0].b`; `weakening.speed[0].w` (`b`), `weakening.place[0].z` (`c`), `weakening.last_slope`.
    """
    found = {name: getattr(scene.initial if name in WRT[:4] else scene.pair, name) for name in WRT}
    if not scene.is_forced:
        return found
    found["until"] = scene.until
    for index, piece in enumerate(scene.force.pieces):
        name = f"force[{index}]"
        found[f"{name}.from"] = piece.start
        found |= {f"{name}.polynomial[{k}]": one for k, one in enumerate(piece.polynomial)}
        for k, sine in enumerate(piece.sines):
            found |= {f"{name}.sines[{k}].{key}": getattr(sine, key) for key in ("amplitude", "omega", "phase")}
    for index, (start, b) in enumerate(scene.friction.pieces):
        found |= {f"friction[{index}].from": start, f"friction[{index}].b": b}
    if scene.friction.weakening is not None:
        given = scene.friction.weakening
        for name, keys, points in (("speed", "wb", given.speed), ("place", "zc", given.place)):
            for index, point in enumerate(points):
                found |= {f"weakening.{name}[{index}].{key}": one for key, one in zip(keys, point, strict=True)}
        found["weakening.last_slope"] = given.last_slope
    return found
