"""Scenes of every kind solved in every arithmetic, each held against balls of more digits.

The sequence of events, every number of events and end against its stated bound, and what the energy ledger leaves. A
typed refusal is an answer, and so is a run that says of itself that its bounds leave the sequence open; an event that
is missed or invented without a word, and a bound that is exceeded, is not. On a surface the bounds of every run must
be below 10^4 times what its errors can do (slack.py): a bound that is always true may say nothing. (Not of a box in
parts: such a part may be a pair on a line. There bounds are only shown, over the largest errors of times, places or
velocities along the run.)
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from random import Random
from statistics import median
from typing import Any, NamedTuple, TypeAlias

from flint import arb

from numerics.arithmetic.ball import exact_middle
from numerics.audit.draws import KINDS
from numerics.audit.slack import Figure, slack
from numerics.errors import NumericsError
from numerics.plane.trajectory import PlaneTrajectory
from numerics.shown import print_table
from numerics.solver.solve import solve
from numerics.trajectory.columns import STATE
from numerics.trajectory.comparison import as_fraction

Progress: TypeAlias = Callable[[str], None]
"""Hears now and then, in a few words, what is being tried."""
Solver: TypeAlias = Callable[[Any], Any]
MAX_EVENTS, BALL_DIGITS = 30, 15
SOLVERS: dict[str, Solver] = {
    "float64": partial(solve, arithmetic="float64", max_events=MAX_EVENTS),
    "double-double": partial(solve, arithmetic="double-double", max_events=MAX_EVENTS),
    "mpmath": partial(solve, arithmetic="mpmath", max_events=MAX_EVENTS),
    "ball": partial(solve, arithmetic="ball", digits=BALL_DIGITS, max_events=MAX_EVENTS, max_digits=2000),
}
SURFACES = ("ellipsoid", "box")
KNOWN = {"friction of the state": ("mpmath", "ball")} | dict.fromkeys(SURFACES, ("float64", "ball"))
"""The arithmetics of a kind, where not all of them know it."""
solve_truly: Any = partial(solve, arithmetic="ball", max_events=MAX_EVENTS, max_digits=2000)
MOST_RESIDUAL = {"float64": 1e-9, "double-double": 1e-24, "mpmath": 1e-33, "ball": 1e-10}
"""Largest energy residual, relative to all the energy that there was, came and went."""
MOST_SLACK, _KEPT = 1e4, 5
SIZES = {"small": (5, 10), "default": (60, 300), "large": (600, 10_000)}
"""How many scenes of a kind in all arithmetics, and in float64 on a line."""
_REFUSED = NumericsError


class Row(NamedTuple):
    """One property: how many cases were tried, the figures that came out, the requirement, and the answer to it.

    `passed` is computed where the row is made; a row for which nothing was tried has not passed. `details` are the
    first few failures, for --json.
    """

    name: str
    tried: int
    measured: Mapping[str, Any]
    required: str
    passed: bool
    details: Sequence[Mapping[str, Any]] = ()


def audit(
    seed: int,
    cases: int,
    more: int,
    progress: Progress,
    solvers: Mapping[str, Solver] = SOLVERS,
    kinds: Mapping[str, Callable[[Random], Any]] = KINDS,
) -> Iterator[Row]:
    """Yield a row for each kind of scene and arithmetic: `cases` scenes each, in float64 on a line `more`."""
    for kind, draw in kinds.items():
        random, surface = Random(f"{seed} {kind}"), kind in SURFACES
        found = {name: Comparison(name, kind) for name in KNOWN.get(kind, solvers) if name in solvers}
        for case in counted(cases if surface else max(cases, more), f"scenes: {kind}", progress):
            scene = draw(random)
            try:
                truth = solve_truly(scene, digits=30 if surface else 60)
            except _REFUSED:
                continue
            for name, one in found.items():
                if case < (more if name == "float64" else cases):
                    one.compare(scene, solvers[name], truth)
        yield from (one.row() for one in found.values())


class Comparison:
    """The scenes of one kind in one arithmetic."""

    def __init__(self, arithmetic: str, kind: str) -> None:
        """Start counting."""
        self.arithmetic, self.kind, self.tried, self.unanswered = arithmetic, kind, 0, Counter[str]()
        self.failed: dict[str, list[str]] = {"wrong": [], "beyond": []}
        self.worst, self.residual, self.loosest, self.asked, self.digits = 0.0, 0.0, 0.0, 0.0, [0]

    def compare(self, scene: Any, solver: Solver, truth: Any) -> None:
        """Solve a scene and hold what comes out against the truth."""
        try:
            found = solver(scene)
        except _REFUSED as error:
            self.unanswered[type(error).__name__] += 1
            return
        if not getattr(found, "certain", True):
            self.unanswered["left open"] += 1
            return
        self.tried += 1
        if sequence(found) != sequence(truth):
            self.failed["wrong"].append(f"{sequence(found)}: {scene!r}")
            return
        worst, loosest = held(found, truth)
        if self.kind in SURFACES and (scene.pair.shape == "ellipsoid" or len(scene.pair.parts) == 1):
            loosest = slack(scene, figures(found), figures(truth))
            self.asked = max(self.asked, loosest)
        if worst > 1:
            self.failed["beyond"].append(f"{worst:.3g} times the bound: {scene!r}")
        self.worst = max(self.worst, worst)
        self.loosest = max(self.loosest, loosest)
        self.digits.append(found.accuracy.digits if getattr(found, "accuracy", None) else found.digits or 0)
        try:
            self.residual = max(self.residual, relative_residual(found))
        except _REFUSED:
            self.unanswered["without a ledger"] += 1

    def row(self) -> Row:
        """Return what was found; a kind of which no scene was compared has not passed."""
        most = MOST_RESIDUAL[self.arithmetic]
        measured: dict[str, float | int | str] = {name: len(some) for name, some in self.failed.items()}
        measured |= {"error/bound": self.worst, "bound/error": self.loosest, "residual": self.residual}
        measured |= {"digits": median(self.digits), **self.unanswered}
        loose = self.asked > MOST_SLACK
        passed = self.tried > 0 and not any(self.failed.values()) and self.residual <= most and not loose
        details = [{name: some[:_KEPT] for name, some in self.failed.items()}]
        last = f"bound/error <= {MOST_SLACK:g}" if self.kind in SURFACES else f"residual <= {most:g}"
        required = f"no sequence wrong, none beyond a bound, {last}"
        return Row(f"{self.kind}, {self.arithmetic}", self.tried, measured, required, passed, details)


def sequence(trajectory: Any) -> tuple[Any, ...]:
    """Return the modes, on a line by the signs of v1 - v2; with the one after the last event."""
    if isinstance(trajectory, PlaneTrajectory):
        return tuple(trajectory.modes)
    return (*(event.before.sign for event in trajectory.events), trajectory.final_mode.sign)


def held(found: Any, truth: Any) -> tuple[float, float]:
    """Return the largest |error|/bound, and the largest bound by the largest error of times, places or velocities."""
    worst, sizes = 0.0, defaultdict[str, list[Fraction]](lambda: [Fraction(0)] * 2)
    for (name, value, bound), (_, true, radius) in zip(figures(found), figures(truth), strict=True):
        error = max(abs(value - true) - (radius or 0), Fraction(0))
        if bound is not None:
            worst = max(worst, float(error / bound) if bound else math.inf if error else 0.0)
            kind = name[0]
            sizes[kind] = [max(pair) for pair in zip(sizes[kind], (bound, abs(value - true)), strict=True)]
    return worst, max((float(b / e) for kind, (b, e) in sizes.items() if e and kind in "txv"), default=0.0)


def figures(trajectory: Any) -> Iterator[Figure]:
    """Yield t and the state of every event and the state at the end; energies on a line, direction and load off it."""
    accuracy: Any = getattr(trajectory, "accuracy", None)
    off_line = isinstance(trajectory, PlaneTrajectory)
    for index, event in enumerate(trajectory.events):
        yield _figure("t", event.t, accuracy and accuracy.t[index])
        yield from _state(event.y, accuracy and accuracy.y[index])
        if off_line:
            yield from (_figure("direction", x, None) for x in event.direction)
            yield from (_figure("load", x, None) for x in event.load)
    yield from _state(trajectory.final_state, accuracy and accuracy.final)
    if not off_line:
        yield _figure("energy", trajectory.final_energy, accuracy and accuracy.energy)
        yield _figure("excess", trajectory.final.w, accuracy and accuracy.energy_excess)


def _state(state: Any, bounds: Any) -> Iterator[Figure]:
    for name, part, bound in zip(STATE, state, [None] * 4 if bounds is None else bounds, strict=True):
        yield from (_figure(name, x, bound) for x in (part if isinstance(part, tuple) else (part,)))


def _figure(name: str, value: Any, bound: Any) -> Figure:
    if isinstance(value, arb):
        return name, exact_middle(value), exact_middle(value.rad())
    return name, as_fraction(value), None if bound is None or not math.isfinite(bound) else Fraction(bound)


def relative_residual(trajectory: Any) -> float:
    """Return |residual| over all the energy that there was, came and went, less its radius; 0 on a surface."""
    if isinstance(trajectory, PlaneTrajectory):
        return 0.0
    with trajectory.arithmetic.context():
        books = trajectory.ledger
        parts = (books.residual, books.initial, books.final, books.friction, books.viscous, books.work)
        if not all(math.isfinite(trajectory.arithmetic.to_float(part)) for part in parts):
            return math.inf
        (_, residual, radius), *rest = (_figure("", part, None) for part in parts)
    whole = sum((abs(size) for _, size, _ in rest), Fraction(0))
    return float(max(abs(residual) - (radius or 0), Fraction(0)) / whole) if whole else 0.0


def counted(cases: int, what: str, progress: Progress) -> Iterator[int]:
    """Yield 0, ..., cases - 1, and say now and then how many of what were tried."""
    for case in range(cases):
        if case % 100 == 0:
            progress(f"{what}, {case + 1} of {cases}")
        yield case


def as_record(rows: Sequence[Row], seed: int, size: str) -> dict[str, Any]:
    """Return the audit as the JSON object of the interface; `passed` is whether every row has. JSON has no infinity."""
    finite = [{name: str(x) if x in {math.inf} else x for name, x in row.measured.items()} for row in rows]
    shown = [row._asdict() | {"measured": measured} for row, measured in zip(rows, finite, strict=True)]
    return {"seed": seed, "size": size, "passed": all(row.passed for row in rows), "rows": shown}


def print_rows(rows: Sequence[Row]) -> None:
    """Print one line a row."""
    lines = []
    for row in rows:
        found = ", ".join(f"{k} {x:.3g}" if isinstance(x, float) else f"{k} {x}" for k, x in row.measured.items())
        lines.append((row.name, str(row.tried), found, row.required, "pass" if row.passed else "FAIL"))
    print_table(("what", "tried", "found", "required", ""), lines)
