"""Scenes in reduced coordinates, for the page as numbers and for `numerics.solve` as exact rationals."""

from dataclasses import asdict
from fractions import Fraction
from itertools import product
from typing import NamedTuple

from sixty_digits import FORCED, forced_scene

from numerics import Force, Pair, Piece, Scene, Sine, State
from paper_checks.explore.scenes import reduced

GRID = [
    (Fraction(ratio), Fraction(zeta), *(Fraction(one) for one in start))
    for ratio, zeta, start in product(
        ("1/20", "1/3", "1", "4"),
        ("0", "1/50", "0.4", "1", "5/2"),
        (("0", "3", "0"), ("-1.6", "0", "-1.6"), ("2.5", "-1", "-1"), ("1", "0.01", "0.01"), ("0.3", "-7", "11")),
    )
]
TIES = [
    # ratio, zeta, X, V1, V2: on the edge at rest (sticks for ever), on a ray, turning back from the edge, outside
    (Fraction(ratio), Fraction(0), Fraction(x), Fraction(v), Fraction(v))
    for ratio in ("1", "1/4")
    for x, v in (("1", "0"), ("-1", "0"), ("1", "0.001"), ("1", "-0.25"), ("-1", "-2"), ("-1", "1"), ("1.2", "0"))
]
EDGES = [
    # ratio, zeta, X, V1, V2: 1e-9 inside the edge or outside it, at rest and moving either way
    (Fraction(1), Fraction(0), Fraction(x), Fraction(v), Fraction(v))
    for x, v in product(("0.999999999", "1.000000001", "-0.999999999"), ("0", "0.25", "-0.25"))
] + [
    # on the edge with a damper, X + 2 zeta V = 1 or -1 in binary64 too, where spring and damper pull either way
    (Fraction(1), Fraction(zeta), side - 2 * Fraction(zeta) * Fraction(v), Fraction(v), Fraction(v))
    for zeta, side, v in product(("1/4", "3/2"), (1, -1), ("-2", "-1/4", "1/4", "2"))
]
CRITICAL = [
    # next to the critical damping of stick, zeta = 1, and of slip, zeta^2 = q = 1/4
    (Fraction(ratio), base + Fraction(beside), Fraction("0.5"), Fraction(3), Fraction(-2))
    for ratio, base in (("1", Fraction(1)), ("1/3", Fraction(1, 2)))
    for beside in ("0", "1e-10", "1e-9", "-1e-9", "1e-6", "-1e-6")
]
DRIVEN_EDGES = [
    # on the edge under a sine: p = -X - 2 zeta V = 1, and p' = r A omega - V - 2 zeta is positive, 0, negative
    (Fraction(1), zeta, -1 - 2 * zeta * v, v, v, Fraction(0), Fraction(amplitude), Fraction(1, 2))
    for zeta, v in ((Fraction(0), Fraction(1, 4)), (Fraction(1, 4), Fraction(-1, 4)))
    for amplitude in ("1.5", "1", "0.5", "-1")
]
DRIVEN = [
    (Fraction(ratio), Fraction(zeta), *(Fraction(one) for one in start), *(Fraction(one) for one in force))
    for ratio, zeta, start, force in product(
        ("1/3", "1", "4"),
        ("0", "0.05", "3/2"),
        (("0", "3", "0"), ("2.5", "-1", "-1")),
        (("0", "1.5", "0.7"), ("0", "3", "1"), ("0.4", "-8", "2.3")),
    )
]


class Answer(NamedTuple):
    """The modes of a run, and of some of its events, by their number, (tau, X, V1)."""

    modes: list[int]
    rows: dict[int, list[float]]

    @property
    def mirrored(self) -> "Answer":
        """The answer to the scene in which everything points the other way."""
        turned = {number: [tau, -X, -V1] for number, (tau, X, V1) in self.rows.items()}
        return Answer([-mode for mode in self.modes], turned)


def scene_of(ratio, zeta, X, V1, V2, constant=0, amplitude=0, omega=1, law="filippov") -> Scene:
    """The pair with L = Omega = M = 1: its SI numbers are the reduced ones. The force is over b."""
    q = ratio / (1 + ratio)
    pair = Pair(q, 1 - q, 1, 1 - q, 2 * zeta)
    force = Force([Piece(0, [pair.b * constant], [Sine(pair.b * amplitude, omega)])])
    return Scene(pair, State(X, V1, 0, V2), 40, law, force=force if constant or amplitude else Force())


SCENES = [scene_of(*row) for row in (*GRID, *TIES, *EDGES, *CRITICAL, *DRIVEN, *DRIVEN_EDGES)] + [
    scene_of(*row, law="three-valued-sgn") for row in (GRID[0], TIES[-1])
]

FORCED_NAMES = (
    "constant-force",
    "huge-omega",
    "mass-ratio-1e-6",
    "mass-ratio-1e6",
    "near-resonance-in-stick",
    "resonance-in-slip",
    "resonance-in-slip-damped",
    "resonance-in-stick",
    "sine-at-threshold",
    "sine-at-threshold-damped",
    "sine-barely-below-threshold",
    "sine-below-threshold",
    "sine-below-threshold-damped",
    "sine-just-above-threshold",
    "sine-just-below-threshold",
    "sine-non-stop",
    "sine-stick-slip",
)
"""Scenes under a constant or a sine, with answers in 60 digits (tests/forced). Left out: forces of 1e9 b and more,
where binary64 has few digits, and one that is above the threshold by 1e-20."""


def for_page(scene: Scene) -> dict[str, float | bool]:
    """A scene as the page reads it."""
    return asdict(reduced(scene))


def explored(name: str) -> tuple[dict[str, float | bool], Answer]:
    """One of them for the page, and the events that it must find, reduced."""
    scene, answer = forced_scene(name), FORCED[name]
    omega, length = float(scene.pair.a2 / scene.pair.mass) ** 0.5, float(scene.pair.half_width)
    units = omega, 1 / length, 1 / (length * omega)
    rows = {
        event["n"]: [float(one) * unit for one, unit in zip(event["row"], units, strict=False)]
        for event in answer["events"]
    }
    return for_page(scene), Answer([{"0": 0, "+": 1, "-": -1}[mode] for mode in answer["modes"]], rows)
