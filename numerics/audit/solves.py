"""Scenes of every kind solved in every arithmetic, each held against balls of more digits.

The sequence of events, every number of events and end against its stated bound, and what the energy ledger leaves. A
typed refusal is an answer, and so is a run that says of itself that its bounds leave the sequence open; an event that
is missed or invented without a word, and a bound that is exceeded, is not. How much larger bounds are than what the
run's errors can do (slack) is shown, and on a surface it must be below 10^4: a bound that is always true may say
nothing. (Not of a box in parts: such a part may be a pair on a line.)

N^2 = x1.A2 x1 + v1.M1 v1 + v2.M2 v2 of an error never grows of itself, and every bound follows from one on N. A single
error may be far below its own: it passes through 0, an event does not feel the axis that is off, friction forgets. So a
bound is held against what E, the largest N of an error of its run, can do to the same number:

    |x1_i| <= E sqrt((A2^-1)_ii),  |v_i| <= E/sqrt(m_i),  |x1_i - x2_i| <= t E sqrt(1/m1_i + 1/m2_i),

and a time: in E/(W Y) a motion of the run's largest N, Y, at its slowest rate W goes as far as E; or the largest error
of a time, if that is more. What is not asked: whether a bound knows on which axis an error is, and from when on.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from random import Random
from statistics import median
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.ball import exact_middle
from numerics.audit.draws import KINDS
from numerics.errors import NumericsError
from numerics.shown import print_table
from numerics.solver.solve import solve
from numerics.trajectory.comparison import as_fraction

Progress: TypeAlias = Callable[[str], None]
"""Hears now and then, in a few words, what is being tried."""
Solver: TypeAlias = Callable[[Any], Any]
Figure: TypeAlias = tuple[Fraction, Fraction | None]
"""A value, and the bound on its error, None where there is none; exact."""
SOLVERS: dict[str, Solver] = {
    name: partial(solve, arithmetic=name, digits=15 if name == "ball" else None, max_events=30, max_digits=2000)
    for name in ("float64", "double-double", "mpmath", "ball")
}
SURFACES = ("ellipsoid", "box")
KNOWN = (
    dict.fromkeys(("damping", "force", "sines", "force and friction"), ("float64", "double-double", "ball"))
    | {"friction of the state": ("ball",)}
    | dict.fromkeys(SURFACES, ("float64", "ball"))
)
"""The arithmetics of a kind, where not all of them know it, or mpmath's numbers are the middles of balls."""
MOST_RESIDUAL = {"float64": 1e-9, "double-double": 1e-24, "mpmath": 1e-33, "ball": 1e-10}
"""Largest energy residual, relative to all the energy that there was, came and went."""
MOST_SLACK, MOST = 1e4, 1e300
"""Of a bound over what the errors of its run can do; and what stands for more than any number, since JSON has none."""
SIZES = {"small": (5, 10), "default": (60, 300), "large": (600, 10_000)}
"""How many scenes of a kind in all arithmetics, and in float64 on a line."""


class AuditRow(NamedTuple):
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
) -> Iterator[AuditRow]:
    """Yield a row for each kind of scene and arithmetic: `cases` scenes each, in float64 on a line `more`."""
    for kind, draw in kinds.items():
        random, surface = Random(f"{seed} {kind}"), kind in SURFACES
        answers: dict[str, list[Any]] = {name: [] for name in KNOWN.get(kind, solvers) if name in solvers}
        most = cases if surface else max(cases, more)
        for case in range(most):
            progress(f"scenes: {kind}, {case + 1} of {most}")
            scene = draw(random)
            try:
                truth: Any = solve(
                    scene, arithmetic="ball", digits=30 if surface else 60, max_events=30, max_digits=2000
                )
            except NumericsError:
                continue
            for name, found in answers.items():
                if case < (more if name == "float64" else cases):
                    found.append(compared(scene, solvers[name], truth))
        yield from (_row(kind, name, found) for name, found in answers.items())


def compared(scene: Any, solver: Solver, truth: Any) -> str | dict[str, Any]:
    """Return what an answer to a scene is, held against the truth; or in a word why there is none."""
    try:
        run = solver(scene)
    except NumericsError as error:
        return type(error).__name__
    if not getattr(run, "certain", True):
        return "left open"
    if (*run.modes, run.final_mode) != (*truth.modes, truth.final_mode):
        return {"wrong": True, "scene": repr(scene)}
    rows = list(zip(figures(run), figures(truth), strict=True))
    pairs = [pair for one, two in rows for pair in zip(one, two, strict=True)]
    numbers = 1 + 4 * getattr(scene.pair, "axes", 1)
    floats = [
        [(float(x), float(abs(x - true)), float(bound or 0)) for (x, bound), (true, _) in zip(*row, strict=True)]
        for row in ((one[:numbers], two[:numbers]) for one, two in rows)
    ]
    with run.context():
        return {
            "wrong": False,
            "error/bound": max(excess(abs(x - true) - (radius or 0), bound) for (x, bound), (true, radius) in pairs),
            "bound/error": slack(scene.pair, *np.array(floats).transpose(2, 0, 1)),
            "residual": relative_residual(run),
            "digits": run.accuracy.digits if getattr(run, "accuracy", None) else run.digits or 0,
            "asked": getattr(scene.pair, "shape", "") == "ellipsoid" or len(getattr(scene.pair, "parts", ())) == 1,
            "scene": repr(scene),
        }


def excess(error: Fraction, bound: Fraction | None) -> float:
    """Return an error by its bound; 0 where there is none."""
    if bound is None or error <= 0:
        return 0.0
    return float(min(error / bound, Fraction(MOST))) if bound else MOST


def figures(run: Any) -> Iterator[list[Figure]]:
    """Yield t and state of each event, on a surface direction and load too; then the end, with the energies."""
    known: Any = getattr(run, "accuracy", None)
    for k, event in enumerate(run.events):
        more = (getattr(event, name) for name in run.EVENT_COLUMNS)
        yield _figures((event.t, *event.y, *more), known and (known.t[k], *known.y[k]))
    bounds = known and (0.0, *known.final, known.energy, known.energy_excess)
    yield _figures((run.scene.until, *run.end_numbers()), bounds)


def _figures(values: Sequence[Any], bounds: Sequence[float] | None) -> list[Figure]:
    found = list[Figure]()
    for value, bound in zip(values, bounds or [math.inf] * len(values), strict=True):
        for x in value if isinstance(value, tuple) else (value,):
            if isinstance(x, arb):
                found.append((exact_middle(x), exact_middle(x.rad())))
            else:
                found.append((as_fraction(x), Fraction(bound) if math.isfinite(bound) else None))
    return found


def relative_residual(run: Any) -> float:
    """Return |residual| over all the energy that there was, came and went, less its radius; 0 on a surface."""
    books = getattr(run, "ledger", None)
    if books is None:
        return 0.0
    parts = [books.residual, books.initial, books.final, books.friction, books.viscous, books.work]
    if not np.isfinite(run.floats(parts)).all():
        return MOST
    (residual, radius), *rest = _figures(parts, None)
    return excess(abs(residual) - (radius or 0), sum((abs(size) for size, _ in rest), Fraction(0)))


def slack(pair: Any, values: NDArray[np.float64], errors: NDArray[np.float64], bounds: NDArray[np.float64]) -> float:
    """Return the largest bound over what the largest error in N can do.

    A row of each is t, x1, v1, x2, v2, each by axes, at an event or the end of a run of a pair on a line or a surface.
    """
    m1, m2 = (np.atleast_1d(np.array(given, dtype=float)) for given in (pair.m1, pair.m2))
    a2 = np.atleast_2d(np.array(pair.a2, dtype=float))
    soft, apart = np.sqrt(np.diag(np.linalg.inv(a2))), np.sqrt(1 / m1 + 1 / m2)
    slowest = np.sqrt(np.linalg.eigvalsh(a2 / np.sqrt(np.outer(m1 + m2, m1 + m2)))[0])

    def norm(rows: NDArray[np.float64]) -> float:
        x1, v1, _, v2 = np.split(rows[:, 1:], 4, axis=1)
        return float(np.sqrt(np.max(np.sum(x1 @ a2 * x1 + m1 * v1**2 + m2 * v2**2, axis=1))))

    most, off = norm(values), norm(errors)
    late = max(off / (slowest * most) if most else 0.0, errors[:, 0].max())
    able = np.array([[late, *soft * off, *off / np.sqrt(m1), *(soft + apart * t) * off, *off / np.sqrt(m2)]
                     for t in values[:, 0]])  # fmt: skip
    return float(np.max(bounds[able > 0] / able[able > 0], initial=0.0))


def _row(kind: str, arithmetic: str, answers: Sequence[str | dict[str, Any]]) -> AuditRow:
    """Return what the answers in one arithmetic are; a kind of which no scene was compared has not passed."""
    found, most = [one for one in answers if isinstance(one, dict)], MOST_RESIDUAL[arithmetic]
    right = [one for one in found if not one["wrong"]]
    beyond = [one for one in right if one["error/bound"] > 1]
    failed = [one for one in right if (one["asked"] and one["bound/error"] > MOST_SLACK) or one["residual"] > most]
    failed += [one for one in found if one["wrong"]] + beyond
    measured: dict[str, Any] = {"wrong": len(found) - len(right), "beyond": len(beyond)}
    for name in ("error/bound", "bound/error", "residual"):
        measured[name] = max((one[name] for one in right), default=0.0)
    measured |= {"digits": median([one["digits"] for one in right] or [0])}
    measured |= Counter(one for one in answers if isinstance(one, str))
    last = f"bound/error <= {MOST_SLACK:g}" if kind in SURFACES else f"residual <= {most:g}"
    required, passed = f"no sequence wrong, none beyond a bound, {last}", bool(found) and not failed
    return AuditRow(f"{kind}, {arithmetic}", len(found), measured, required, passed, failed[:5])


def as_record(rows: Sequence[AuditRow], seed: int, size: str) -> dict[str, Any]:
    """Return the audit as the JSON object of the interface; `passed` is whether every row has."""
    shown = [row._asdict() for row in rows]
    return {"seed": seed, "size": size, "passed": all(row.passed for row in rows), "rows": shown}


def print_rows(rows: Sequence[AuditRow]) -> None:
    """Print one line a row."""
    lines = []
    for row in rows:
        found = ", ".join(f"{k} {x:.3g}" if isinstance(x, float) else f"{k} {x}" for k, x in row.measured.items())
        lines.append((row.name, str(row.tried), found, row.required, "pass" if row.passed else "FAIL"))
    print_table(("what", "tried", "found", "required", ""), lines)
