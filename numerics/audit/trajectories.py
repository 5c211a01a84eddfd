"""Trajectories of extreme scenes in every arithmetic, compared event by event; what their energy ledgers leave.

The ball trajectory is proved, so it is the reference. A typed refusal is an answer, and so is a run that says of itself
that its error bounds leave the sequence of events open; an event that is missed or invented without a word is not.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from random import Random

from flint import arb

from numerics.audit.draws import KINDS
from numerics.audit.table import Progress, Row
from numerics.errors import NumericsError
from numerics.scene import Scene
from numerics.solver.solve import solve
from numerics.trajectory.comparison import SequenceDiffers, as_fraction, require_same_sequence
from numerics.trajectory.trajectory import Trajectory

Solver = Callable[[Scene], Trajectory]
BALL_DIGITS = 20
MAX_EVENTS = 30
_MAX_DIGITS = 2000
MOST_RESIDUAL = {
    "float64": 1e-13,
    "double-double": 1e-28,
    "mpmath": 1e-38,
    "ball": 10.0 ** (2 - BALL_DIGITS),
}
"""Largest energy residual, relative to all the energy that changed hands; mpmath works with 42 digits here."""
_KEPT = 5
_PATIENCE = 20
"""So many more scenes of a kind are drawn at most, until every arithmetic has answered one."""

SOLVERS: dict[str, Solver] = {
    "float64": lambda scene: solve(scene, max_events=MAX_EVENTS),
    "double-double": lambda scene: solve(scene, arithmetic="double-double", max_events=MAX_EVENTS),
    "mpmath": lambda scene: solve(scene, arithmetic="mpmath", max_events=MAX_EVENTS),
    "ball": lambda scene: solve(
        scene, digits=BALL_DIGITS, arithmetic="ball", max_events=MAX_EVENTS, max_digits=_MAX_DIGITS
    ),
}


def audit_trajectories(
    seed: int, cases: int, progress: Progress, solvers: Mapping[str, Solver] | None = None
) -> Iterator[Row]:
    """Yield a row for each kind of scene, `cases` scenes or some more, then the rows of the energy ledger."""
    ledgers = {name: Ledgers(name) for name in SOLVERS}
    for kind, draw in KINDS.items():
        comparison, random = Comparison(kind), Random(f"{seed} {kind}")
        while comparison.scenes < cases or (comparison.silent and comparison.scenes < cases + _PATIENCE):
            progress(f"trajectories: {kind}, scene {comparison.scenes + 1} of {cases}")
            comparison.compare(draw(random), solvers or SOLVERS, ledgers)
        yield comparison.row()
    yield from (ledger.row() for ledger in ledgers.values())


class Comparison:
    """The event sequences of one kind of scene."""

    def __init__(self, kind: str) -> None:
        """Start counting."""
        self.kind, self.scenes, self.answered, self.events = kind, 0, Counter[str](), 0
        self.refused, self.differing, self.open = Counter[str](), list[str](), Counter[str]()

    @property
    def silent(self) -> bool:
        """Return whether some arithmetic has not answered yet."""
        return not all(self.answered[name] for name in SOLVERS)

    def compare(self, scene: Scene, solvers: Mapping[str, Solver], ledgers: Mapping[str, Ledgers]) -> None:
        """Solve a scene in every arithmetic and hold the points against the balls."""
        self.scenes += 1
        found = {name: self._solved(name, solver, scene) for name, solver in solvers.items()}
        balls = found["ball"]
        for name, trajectory in found.items():
            if trajectory is None:
                continue
            ledgers[name].add(trajectory)
            if balls is None or name == "ball":
                continue
            self.events += len(balls.events)
            try:
                require_same_sequence(trajectory, balls)
            except SequenceDiffers as error:
                if trajectory.certain:
                    self.differing.append(f"{error} ({scene})")
                else:
                    self.open[name] += 1

    def _solved(self, name: str, solver: Solver, scene: Scene) -> Trajectory | None:
        try:
            trajectory = solver(scene)
        except NumericsError as error:
            self.refused[f"{name}: {type(error).__name__}"] += 1
            return None
        self.answered[name] += 1
        return trajectory

    def row(self) -> Row:
        """Return what was found; every kind of scene must also be answered by every arithmetic now and then."""
        measured = {"events compared": self.events, "missed or invented": len(self.differing)}
        measured |= {f"other than proved, and said so, {name}": count for name, count in sorted(self.open.items())}
        measured |= {f"refused by {name}": count for name, count in sorted(self.refused.items())}
        details = [
            {"answered": dict(self.answered), "refused": dict(self.refused), "differing": self.differing[:_KEPT]}
        ]
        passed = self.events > 0 and not self.differing and not self.silent
        required = "missed or invented = 0, where not said"
        return Row("trajectories", self.kind, self.scenes, measured, required, passed, details)


class Ledgers:
    """The energy residuals of one arithmetic, relative to the energy that there was, came and went."""

    def __init__(self, name: str) -> None:
        """Start measuring."""
        self.name, self.tried, self.worst, self.total, self.excluding_zero = name, 0, 0.0, 0.0, 0

    def add(self, trajectory: Trajectory) -> None:
        """Add the residual of one trajectory; balls must enclose 0 in it."""
        residual = relative_residual(trajectory)
        self.tried, self.total = self.tried + 1, self.total + residual
        self.worst = residual if not residual <= self.worst else self.worst
        if self.name == "ball" and not trajectory.ledger.residual.contains(0):
            self.excluding_zero += 1

    def row(self) -> Row:
        """Return the largest and the mean residual."""
        limit = MOST_RESIDUAL[self.name]
        measured = {"max": self.worst, "mean": self.total / max(1, self.tried)}
        required = f"max <= {limit:g} of the energy"
        if self.name == "ball":
            measured["without 0"] = self.excluding_zero
            required += ", 0 enclosed"
        passed = self.tried > 0 and self.worst <= limit and not self.excluding_zero
        return Row("energy", f"ledger residual, {self.name}", self.tried, measured, required, passed)


def relative_residual(trajectory: Trajectory) -> float:
    """Return |residual|/(initial + final + friction + viscous), each at most as large as it may be; inf if not finite.

    Through exact rationals for points and in balls for balls, so that the division neither over- nor underflows.
    """
    ledger = trajectory.ledger
    parts = (ledger.residual, ledger.initial, ledger.final, ledger.friction, ledger.viscous)
    if trajectory.arithmetic.name == "ball":
        with trajectory.arithmetic.context():
            whole = sum((abs(part).upper() for part in parts[1:]), arb(0))
            return float(abs(parts[0]).upper() / whole) if whole > 0 else 0.0
    if not all(math.isfinite(trajectory.arithmetic.to_float(part)) for part in parts):
        return math.inf
    exact = [abs(as_fraction(part)) for part in parts]
    whole_exact = sum(exact[1:], Fraction(0))
    return float(exact[0] / whole_exact) if whole_exact else 0.0
