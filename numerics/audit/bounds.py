"""Are the error bounds of float64 honest? Each against the true error, which balls of 60 digits tell."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from random import Random
from statistics import median
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.audit.draws import KINDS
from numerics.audit.table import Progress, Row, counted
from numerics.errors import NumericsError
from numerics.run.one import run_scene
from numerics.scene import Scene
from numerics.solver.solve import solve
from numerics.trajectory.comparison import SequenceDiffers, distance, require_same_sequence
from numerics.trajectory.digits import Accuracy
from numerics.trajectory.trajectory import Trajectory

Solver = Callable[[Scene], Trajectory]
MAX_EVENTS = 30
_DIGITS = 60
_KEPT = 5
ALLOWED = 1e-5
"""Share of scenes in which some bound may be exceeded, and then by less than a digit."""


def audit_bounds(seed: int, cases: int, progress: Progress, solver: Solver | None = None) -> Iterator[Row]:
    """Yield a row for each kind of scene, `cases` scenes each."""
    for kind, draw in KINDS.items():
        honesty, random = Honesty(kind), Random(f"bounds {seed} {kind}")
        for _ in counted(cases, f"error bounds: {kind}, scene", progress):
            honesty.compare(draw(random), solver or _float64)
        yield honesty.row()


def _float64(scene: Scene) -> Trajectory:
    return solve(scene, max_events=MAX_EVENTS)


class Honesty:
    """The bounds of one kind of scene held against the truth."""

    def __init__(self, kind: str) -> None:
        """Start counting."""
        self.kind, self.tried, self.numbers, self.refused, self.open = kind, 0, 0, 0, 0
        self.worst, self.beyond, self.digits = 0.0, list[str](), list[int]()

    def compare(self, scene: Scene, solver: Solver) -> None:
        """Solve a scene in float64 and in balls; compare every number that carries a bound."""
        try:
            floats = solver(scene)
            balls = run_scene(scene, Ball(_DIGITS), MAX_EVENTS)
        except NumericsError:
            self.refused += 1
            return
        accuracy = floats.accuracy
        if accuracy is None or not accuracy.certain:
            self.open += 1
            return
        self.tried += 1
        self.digits.append(accuracy.digits)
        try:
            require_same_sequence(floats, balls)
        except SequenceDiffers as error:
            self.worst = math.inf
            self.beyond.append(f"{error} ({scene})")
            return
        worst = max(self._ratios(floats, balls, accuracy))
        self.worst = max(self.worst, worst)
        if worst > 1:
            self.beyond.append(f"{worst:.3g} times the bound ({scene})")

    def _ratios(self, floats: Trajectory, balls: Trajectory, accuracy: Accuracy) -> Iterator[float]:
        """Yield |error|/bound for every number."""
        with floats.arithmetic.context(), balls.arithmetic.context():
            for index, (one, two) in enumerate(zip(floats.events, balls.events, strict=True)):
                bounds = (accuracy.t[index], *accuracy.y[index])
                for value, truth, bound in zip((one.t, *one.y), (two.t, *two.y), bounds, strict=True):
                    yield self._ratio(value, truth, bound)
            for value, truth, bound in zip(floats.final_state, balls.final_state, accuracy.final, strict=True):
                yield self._ratio(value, truth, bound)
            energy = floats.final_energy, balls.final_energy, accuracy.energy
            excess = floats.final.w, balls.final.w, accuracy.energy_excess
            spent = _spent(floats), _spent(balls), accuracy.dissipated
            for value, truth, bound in (energy, excess, spent):
                yield self._ratio(value, truth, bound)

    def _ratio(self, value: float, truth: arb, bound: float) -> float:
        self.numbers += 1
        error = distance(value, truth).upper()
        if error == 0 or bound == math.inf:
            return 0.0
        return float(error / arb(float(bound))) if bound > 0 else math.inf

    def row(self) -> Row:
        """Return what was found; a kind of which no scene was compared has not passed."""
        measured: dict[str, float | int | str] = {
            "numbers compared": self.numbers,
            "scenes beyond a bound": len(self.beyond),
            "largest error/bound": self.worst,
            "median digits claimed": median(self.digits) if self.digits else 0,
            "sequence left open": self.open,
            "refused": self.refused,
        }
        passed = self.tried > 0 and len(self.beyond) <= ALLOWED * self.tried and self.worst <= 10
        required = f"beyond in at most {ALLOWED:g} of the scenes, by less than a digit"
        return Row("error bounds", self.kind, self.tried, measured, required, passed, [{"beyond": self.beyond[:_KEPT]}])


def _spent(trajectory: Trajectory) -> Any:
    ledger = trajectory.ledger
    return ledger.friction + ledger.viscous
