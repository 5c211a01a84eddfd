"""The scenes behind the buttons of the interactive page: the paper's, read from their files, and ours under a force."""

from __future__ import annotations

import tomllib
from dataclasses import asdict, dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from numerics.scene import Scene
from numerics.scene.file import load_scene
from numerics.scene.model import Law
from numerics.scene.pieces import Sine

SCENES = tomllib.loads(Path(__file__).with_suffix(".toml").read_text("utf-8"))


@dataclass(frozen=True)
class ReducedScene:
    """A scene in reduced coordinates (theory/scaling.py), binary64: mass ratio m1/m2, damping ratio, state, horizon
    Omega until, and the force over b: constant + amplitude sin(omega tau)."""

    ratio: float = 1.0
    zeta: float = 0.0
    X: float = 0.0
    V1: float = 0.0
    V2: float = 0.0
    until: float = 50.0
    constant: float = 0.0
    amplitude: float = 0.0
    omega: float = 1.0
    literal: bool = False


def reduced(scene: Scene) -> ReducedScene:
    """Return a scene in reduced coordinates: X = x1/L, V = v/(L Omega), tau = Omega t.

    Raises ValueError unless its force is a constant and at most one sine of phase 0, from the start on.
    """
    pair, at = scene.pair, scene.initial
    omega, length = float(pair.a2 / pair.mass) ** 0.5, pair.half_width
    speed, acting = float(length) * omega, scene.force.piece_at(Fraction(0))
    sine = acting.sines[0] if acting.sines else Sine(0, 1)
    simple = len(acting.polynomial) <= 1 and len(acting.sines) <= 1 and sine.phase == 0
    if not simple or scene.force.starts not in ((), (Fraction(0),)) or scene.friction.steps:
        raise ValueError("the page supports a constant force and one sine of phase 0, from t = 0 on, and one b")
    return ReducedScene(
        ratio=float(pair.m1 / pair.m2),
        zeta=float(pair.a1 / pair.mass) / (2 * omega),
        X=float(at.x1 / length),
        V1=float(at.v1) / speed,
        V2=float(at.v2) / speed,
        until=float(scene.until) * omega,
        constant=float(sum(acting.polynomial) / pair.b),
        amplitude=float(sine.amplitude / pair.b),
        omega=float(sine.omega) / omega if acting.sines else 1.0,
        literal=scene.law is Law.THREE_VALUED_SGN,
    )


def buttons() -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Return the buttons of `scenes.toml`, the paper's and ours: label, scene, and its units in SI, if it has such."""
    paper = [{"label": label, **_of_paper(load_scene(name))} for label, name in SCENES["paper"].items()]
    own = [
        {"label": label, "scene": asdict(ReducedScene(**scene)), "units": ""} for label, scene in SCENES["own"].items()
    ]
    return paper, own


def _of_paper(scene: Scene) -> dict[str, Any]:
    length, rate = float(scene.pair.half_width), float(scene.pair.a2 / scene.pair.mass) ** 0.5
    units = f"One unit of length is L = {1000 * length:g} mm, of speed {1000 * length * rate:g} mm/s, of time {1 / rate:g} s."
    return {"scene": asdict(reduced(scene)), "units": units}
