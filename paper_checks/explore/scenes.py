"""The scenes behind the buttons of the interactive page: the paper's, read from their files, and ours under a force."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from fractions import Fraction
from typing import Any

from numerics.scene import Scene
from numerics.scene.file import load_scene
from numerics.scene.model import Law
from numerics.scene.pieces import Sine


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


@dataclass(frozen=True)
class Button:
    """Label of a button, the scene that it loads, and its units in SI, if it has such."""

    label: str
    scene: ReducedScene
    units: str = ""

    def data(self) -> dict[str, Any]:
        """Return what the page needs of it."""
        return {"scene": asdict(self.scene), "units": self.units}


PAPER = (
    ("Fig. 3 (a): merges", "itinerary-that-merges"),
    ("Fig. 3 (b): creeps", "itinerary-that-creeps"),
    ("Fig. 4 (a): from 6 mm", "start-at-6mm"),
    ("Fig. 4 (b): with speed", "start-with-speed"),
    ("Fig. 5: b = 0.05 N", "velocities"),
    ("Fig. 5 (b): b = 0.2 N", "relative-motion-b02"),
    ("Fig. 5 (b): b = 0.5 N", "relative-motion-b05"),
)
"""The paper's scenes by their shipped names; numbered as printed."""

OWN = (
    Button("Sticks permanently", ReducedScene(X=0.5, until=30)),
    Button("Next to the critical orbit", ReducedScene(X=1, V1=-0.1, V2=-0.1, until=120)),
    Button("Light driving body: merges", ReducedScene(ratio=0.1, X=1, V1=2, V2=2, until=40)),
    Button("Damped", ReducedScene(zeta=0.1, V1=8, V2=-4, until=40)),
    Button("Constant force", ReducedScene(constant=4, until=60)),
    Button("Sine: entrained", ReducedScene(zeta=0.1, amplitude=1.5, omega=0.7, V1=3, until=120)),
    Button("Sine: stick and slip", ReducedScene(zeta=0.1, amplitude=3, omega=0.7, until=120)),
    Button("Sine: never sticks", ReducedScene(zeta=0.1, amplitude=10, omega=0.7, until=120)),
    Button("Sine at resonance", ReducedScene(amplitude=2, omega=2**0.5, until=120)),
)
"""Scenes of ours, round numbers in reduced coordinates."""


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


def paper_buttons() -> tuple[Button, ...]:
    """Return the buttons of the paper's scenes."""
    return tuple(_paper_button(label, load_scene(name)) for label, name in PAPER)


def _paper_button(label: str, scene: Scene) -> Button:
    length, rate = float(scene.pair.half_width), float(scene.pair.a2 / scene.pair.mass) ** 0.5
    units = f"One unit of length is L = {1000 * length:g} mm, of speed {1000 * length * rate:g} mm/s, of time {1 / rate:g} s."
    return Button(label, reduced(scene), units)
