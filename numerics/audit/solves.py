"""Scenes of every kind solved in every arithmetic, each held against balls of 60 digits.

The sequence of events, every number of events and end against its stated bound (in balls: they must meet), and what the
energy ledger leaves. A typed refusal is an answer, and so is a run that says of itself that its bounds leave the
sequence open; an event that is missed or invented without a word, and a bound that is exceeded, is not.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from random import Random
from statistics import median
from typing import Any

from flint import arb

from numerics.arithmetic.protocol import Number
from numerics.audit.draws import KINDS
from numerics.audit.table import Progress, Row, counted
from numerics.errors import NumericsError
from numerics.scene import Scene
from numerics.solver.solve import solve
from numerics.trajectory.comparison import as_fraction, distance
from numerics.trajectory.trajectory import Trajectory

Solver = Callable[[Scene], Trajectory]
MAX_EVENTS, BALL_DIGITS = 30, 15
_ALWAYS, _KEPT = "float64", 5
SOLVERS: dict[str, Solver] = {
    "float64": partial(solve, arithmetic="float64", max_events=MAX_EVENTS),
    "double-double": partial(solve, arithmetic="double-double", max_events=MAX_EVENTS),
    "mpmath": partial(solve, arithmetic="mpmath", max_events=MAX_EVENTS),
    "ball": partial(solve, arithmetic="ball", digits=BALL_DIGITS, max_events=MAX_EVENTS, max_digits=2000),
}
solve_truly: Solver = partial(solve, arithmetic="ball", digits=60, max_events=MAX_EVENTS, max_digits=2000)
MOST_RESIDUAL = {"float64": 1e-9, "double-double": 1e-24, "mpmath": 1e-33, "ball": 1e-10}
"""Largest energy residual, relative to all the energy that there was, came and went."""


def audit_solves(
    seed: int, cases: int, more: int, progress: Progress, solvers: Mapping[str, Solver] = SOLVERS
) -> Iterator[Row]:
    """Yield a row for each kind of scene and arithmetic: `cases` scenes each, in float64 `more`."""
    for kind, draw in KINDS.items():
        random, found = Random(f"{seed} {kind}"), [Comparison(name, kind) for name in solvers]
        for case in counted(max(cases, more), f"scenes: {kind}", progress):
            scene = draw(random)
            try:
                truth = solve_truly(scene)
            except NumericsError:
                continue
            for one in found:
                if case < (more if one.arithmetic == _ALWAYS else cases):
                    one.compare(scene, solvers[one.arithmetic], truth)
        yield from (one.row() for one in found)


class Comparison:
    """The scenes of one kind in one arithmetic."""

    def __init__(self, arithmetic: str, kind: str) -> None:
        """Start counting."""
        self.arithmetic, self.kind, self.tried = arithmetic, kind, 0
        self.unanswered, self.wrong, self.beyond = Counter[str](), list[str](), list[str]()
        self.worst = self.residual = 0.0
        self.digits = [0]

    def compare(self, scene: Scene, solver: Solver, truth: Trajectory) -> None:
        """Solve a scene and hold what comes out against the truth."""
        try:
            found = solver(scene)
        except NumericsError as error:
            self.unanswered[type(error).__name__] += 1
            return
        if not found.certain:
            self.unanswered["left open"] += 1
            return
        self.tried += 1
        if sequence(found) != sequence(truth):
            self.wrong.append(f"{sequence(found)}: {scene}")
            return
        worst = max(ratios(found, truth))
        self.beyond += [f"{worst:.3g} times the bound: {scene}"] if worst > 1 else []
        self.worst = max(self.worst, worst)
        try:
            self.residual = max(self.residual, relative_residual(found))
        except NumericsError:
            self.unanswered["without a ledger"] += 1
        self.digits.append(found.accuracy.digits if found.accuracy else found.digits or 0)

    def row(self) -> Row:
        """Return what was found; a kind of which no scene was compared has not passed."""
        most = MOST_RESIDUAL[self.arithmetic]
        measured: dict[str, float | int | str] = {
            "wrong": len(self.wrong),
            "beyond": len(self.beyond),
            "error/bound": self.worst,
            "residual": self.residual,
            "digits": median(self.digits),
            **self.unanswered,
        }
        passed = self.tried > 0 and not self.wrong and not self.beyond and self.residual <= most
        details = [{"wrong": self.wrong[:_KEPT], "beyond": self.beyond[:_KEPT]}]
        required = f"no sequence wrong, none beyond a bound, residual <= {most:g}"
        return Row("scenes", f"{self.kind}, {self.arithmetic}", self.tried, measured, required, passed, details)


def sequence(trajectory: Trajectory) -> tuple[int, ...]:
    """Return the signs of v1 - v2 in all modes, with the one after the last event."""
    return (*(event.before.sign for event in trajectory.events), trajectory.final_mode.sign)


def ratios(found: Trajectory, truth: Trajectory) -> Iterator[float]:
    """Yield |error|/bound of every number that has a bound; in balls 0 or inf, as they meet or not."""
    with truth.arithmetic.context():
        for value, bound, true in zip(numbers(found), bounds(found), numbers(truth), strict=True):
            if isinstance(value, arb):
                yield 0.0 if value.overlaps(true) else math.inf
            else:
                error = distance(value, true).lower()
                yield float(error / arb(float(bound))) if bound > 0 else math.inf if error > 0 else 0.0


def numbers(trajectory: Trajectory) -> Iterator[Number]:
    """Yield t, x1, v1, x2, v2 of every event, the state at the end, its energy, and E/E_cr - 1."""
    for event in trajectory.events:
        yield event.t
        yield from event.y
    yield from trajectory.final_state
    yield trajectory.final_energy
    yield trajectory.final.w


def bounds(trajectory: Trajectory) -> Iterator[float]:
    """Yield the stated bounds in the same order; infinite where there are none."""
    accuracy: Any = trajectory.accuracy
    for index in range(len(trajectory.events)):
        yield from (math.inf,) * 5 if accuracy is None else (accuracy.t[index], *accuracy.y[index])
    yield from (math.inf,) * 6 if accuracy is None else (*accuracy.final, accuracy.energy, accuracy.energy_excess)


def relative_residual(trajectory: Trajectory) -> float:
    """Return |residual| over all the energy that there was, came and went; of a ball, inf if it does not contain 0.

    Through exact rationals, so that nothing over- or underflows.
    """
    with trajectory.arithmetic.context():
        ledger = trajectory.ledger
        parts: Any = (ledger.residual, ledger.initial, ledger.final, ledger.friction, ledger.viscous, ledger.work)
        if isinstance(parts[0], arb):
            whole = sum((abs(arb(part)).upper() for part in parts[1:]), arb(0))
            return math.inf if not parts[0].contains(0) else float(abs(parts[0]).upper() / whole) if whole > 0 else 0.0
        if not all(math.isfinite(trajectory.arithmetic.to_float(part)) for part in parts):
            return math.inf
    residual, *rest = (abs(as_fraction(part)) for part in parts)
    return float(residual / sum(rest, Fraction(0))) if any(rest) else 0.0
