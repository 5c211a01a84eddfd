"""The scenes behind the buttons of the page's second tab, the pair on a surface: shipped ones from their files, and ours."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any, cast

from numerics.scene.file import load_scene
from numerics.scene.plane import PlaneScene

Vector = tuple[float, float]


@dataclass(frozen=True)
class ReducedSurface:
    """A round pair on a surface in reduced coordinates, binary64: X = x1/L, V = v/(L Omega), and the force over b,
    `size` (cos, sin)(omega tau + angle); constant where omega is 0."""

    ratio: float = 1.0
    zeta: float = 0.0
    X: Vector = (0.0, 0.0)
    V1: Vector = (0.0, 0.0)
    V2: Vector = (0.0, 0.0)
    until: float = 30.0
    size: float = 0.0
    angle: float = 0.0
    omega: float = 0.0


@dataclass(frozen=True)
class SurfaceButton:
    """What a button says, and the scene that it loads."""

    label: str
    scene: ReducedSurface

    def data(self) -> dict[str, Any]:
        """Return what the page needs of it."""
        kind = "none" if not self.scene.size else "turning" if self.scene.omega else "constant"
        return {"scene": asdict(self.scene), "kind": kind}


SHIPPED = (("Circle: merges in one slip", "plane-circle-merges"), ("Ellipse: creeps", "plane-ellipse-creeps"))
"""Shipped scenes by their names."""
_STUCK = (0.0, 0.7)
OWN_SURFACES = (
    SurfaceButton("Ellipse: sticks permanently", ReducedSurface(X=(0.98, 0.1), V1=_STUCK, V2=_STUCK, until=20)),
    SurfaceButton("From a push", ReducedSurface(X=(0.5, 0), V1=(-1, 3), V2=(1, 0), until=20)),
    SurfaceButton("A slip that turns", ReducedSurface(X=(2, 0.5), V1=(-6, 0.3), size=4, until=12)),
    SurfaceButton("Damped", ReducedSurface(zeta=0.1, X=(4, 1), V1=(0, 3), V2=(0, -2), until=20)),
    SurfaceButton("Rotating force: sticks", ReducedSurface(zeta=0.5, V1=(2, 0), size=1.5, omega=1, until=40)),
    SurfaceButton("Rotating force: slips", ReducedSurface(zeta=0.5, size=10, omega=1, until=60)),
)
"""Scenes of ours, round numbers in reduced coordinates."""


def reduced_surface(scene: PlaneScene) -> ReducedSurface:
    """Return a round pair without a force in reduced coordinates. Raises ValueError for another one."""
    pair = scene.pair
    m1, m2, a1, a2, b = ({*one} for one in (pair.m1, pair.m2, _diagonal(pair.a1), _diagonal(pair.a2), pair.b))
    if scene.is_forced or not pair.is_diagonal or max(map(len, (m1, m2, a1, a2, b))) > 1 or pair.axes != 2:
        raise ValueError("the page supports isotropic pairs on a surface only")
    first, second, damper, spring, friction = (float(*one) for one in (m1, m2, a1, a2, b))
    mass = first + second
    omega, length = (spring / mass) ** 0.5, friction * mass / (spring * second)

    def vector(values: Any, unit: float) -> Vector:
        return cast("Vector", tuple(float(one) / unit for one in values))

    return ReducedSurface(
        ratio=first / second,
        zeta=damper / mass / (2 * omega),
        X=vector(scene.x1, length),
        V1=vector(scene.v1, length * omega),
        V2=vector(scene.v2, length * omega),
        until=float(scene.until) * omega,
    )


def _diagonal(matrix: Any) -> tuple[Any, ...]:
    return tuple(row[i] for i, row in enumerate(matrix))


def surface_buttons() -> tuple[SurfaceButton, ...]:
    """Return the buttons of the second tab."""
    shipped = (SurfaceButton(label, reduced_surface(cast("PlaneScene", load_scene(name)))) for label, name in SHIPPED)
    return (*shipped, *OWN_SURFACES)
