"""Scenes in reduced coordinates, for the page as numbers and for `numerics.solve` as exact rationals."""

from dataclasses import asdict
from fractions import Fraction
from typing import NamedTuple

from sixty_digits import FORCED, HERE, forced_scene

from numerics import Force, Pair, Piece, Scene, Sine, State
from numerics.trajectory.trajectory import Trajectory
from paper_checks.explore.scenes import reduced


class Answer(NamedTuple):
    """The modes of a run, and of events by their number (tau, X, V1); the final (x1, v1, x2, v2) is -1."""

    modes: list[int]
    rows: dict[int, list[float]]

    @classmethod
    def of(cls, run: Trajectory) -> "Answer":
        """The answer of the integrator, whose units are reduced ones."""
        rows = {n: [float(one) for one in (event.t, *event.y[:2])] for n, event in enumerate(run.events)}
        return cls([mode.sign for mode in run.modes], {**rows, -1: [*map(float, run.final_state)]})

    @property
    def mirrored(self) -> "Answer":
        """The answer to the scene in which everything points the other way."""
        turned = {number: [tau, -X, -V1] for number, (tau, X, V1) in self.rows.items()}
        return Answer([-mode for mode in self.modes], turned)


def scene_of(ratio, zeta, X, V1, V2, constant=0, amplitude=0, omega=1, law="filippov") -> Scene:
    """The pair with L = Omega = M = 1: its SI numbers are the reduced ones. The force is over b."""
    ratio, zeta, constant, amplitude = map(Fraction, (ratio, zeta, constant, amplitude))
    q = ratio / (1 + ratio)
    pair = Pair(q, 1 - q, 1, 1 - q, 2 * zeta)
    force = Force([Piece(0, [pair.b * constant], [Sine(pair.b * amplitude, omega)])])
    return Scene(pair, State(X, V1, 0, V2), 40, law, force=force if constant or amplitude else Force())


LINES = (HERE / "explored.txt").read_text("utf-8").splitlines()
SCENES = [scene_of(*line.split()) for line in LINES if line[0] != "#"]

NAMES = """constant-force huge-omega mass-ratio-1e-6 mass-ratio-1e6 near-resonance-in-stick resonance-in-slip
resonance-in-slip-damped resonance-in-stick sine-at-threshold sine-at-threshold-damped
sine-barely-below-threshold sine-below-threshold sine-below-threshold-damped sine-just-above-threshold
sine-just-below-threshold sine-non-stop sine-stick-slip"""
FORCED_NAMES = NAMES.split()
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
