"""A chunk of a batch: every row of SI numbers to its end, by compiled code, or scene by scene."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.compiled import can_compile, compiled
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.pair import nearest
from numerics.errors import EventUndecided, OutOfRange
from numerics.free.rows import UNKNOWN, solve_rows
from numerics.linear.batch import run_prepared, run_rows
from numerics.linear.pieces import Known, starts_of
from numerics.linear.prepare import Prepared, prepare
from numerics.linear.record import AT, BOUNDS, CODES, END_ROW, ROW, How, Knot
from numerics.scene import Friction, Scene
from numerics.scene.plane import PlaneScene
from numerics.trajectory.run import free_scene, run_scene

Table = NDArray[np.float64]
_FLOAT64, _DIGITS = Float64(), 68
"""Where friction depends on the state a batch, too, is solved in balls, of so many digits."""


def of_one_kind(given: Any) -> Any:
    """Return what was given as a list of scenes of one kind. Raises TypeError."""
    kept = list(given) if isinstance(given, Iterable) else [given]
    if not isinstance(given, Iterable) or not all(isinstance(one, Scene | PlaneScene) for one in kept):
        raise TypeError("solve_scenes takes a list of Scenes, or of PlaneScenes; for one scene there is solve")
    kinds = {f"{one.pair.axes} axes" if isinstance(one, PlaneScene) else "one line" for one in kept}
    if len(kinds) > 1:
        raise TypeError(
            f"these scenes have {' and '.join(sorted(kinds))}; solve those of each kind in a call of its own"
        )
    return kept


@dataclass
class Columns:
    """Rows of scenes as compiled code reads them, all numbers binary64.

    `table` (n, 20): SI numbers as halves (answer.SI). u = sum_k polynomial[:, k] t^k + sum amplitude sin(omega t +
    phase), with `polynomial` (n, p) and `sines` (n, s, 3). All have the same pieces of friction.
    """

    table: Table
    polynomial: Table
    sines: Table
    frictions: Table
    """frictions_of what friction they have."""

    def part(self, rows: Any) -> Columns:
        """Return some of the rows."""
        return replace(self, table=self.table[rows], polynomial=self.polynomial[rows], sines=self.sines[rows])

    @property
    def free(self) -> NDArray[np.bool_]:
        """Return which rows are those of the free pair: a1 = 0 and no force."""
        still = (self.table[:, -2] == 0) & (len(self.frictions) == 1 and bool(np.isnan(self.frictions[0, 2])))
        for forces in (self.polynomial, self.sines[:, :, 0]):
            if forces.size:
                still &= ~np.any(forces, axis=1)
        return np.asarray(still)


def frictions_of(friction: Friction) -> Table:
    """Return the pieces of a friction without weakening as linear/batch.py reads them."""
    pieces = [(*nearest(start), *nearest(b)) for start, b in friction.pieces]
    first = [] if pieces and pieces[0][0] == 0.0 else [(0.0, 0.0, np.nan, 0.0)]
    return np.array([*first, *pieces])


@dataclass(frozen=True)
class Chunk:
    """Scenes as columns, what stands behind each of them, and where the answers go."""

    columns: Columns | None
    """None: scene by scene."""
    exact: Callable[[int], Scene]
    """exact(i) returns the scene of row i."""
    ends: Table
    kept: Table
    literal: bool
    max_events: int

    def solve(self) -> int:
        """Solve the scenes and return how many there are."""
        self.ends[:, AT["how"]] = UNKNOWN
        if self.columns is not None and can_compile():
            free = self.columns.free
            for its, run in ((free, _free_rows), (~free, _rows_without_ledger)):
                if its.all():
                    run(self.columns, self.literal, self.max_events, self.kept, self.ends)
                elif its.any():
                    kept, ends = self.kept[its], self.ends[its]
                    run(self.columns.part(its), self.literal, self.max_events, kept, ends)
                    self.kept[its], self.ends[its] = kept, ends
        elif can_compile():
            self._solve_linear()
        for row in np.flatnonzero(self.ends[:, AT["how"]] == UNKNOWN):
            _solve_one(self.exact(int(row)), self.max_events, self.kept[row], self.ends[row])
        return len(self.ends)

    def _solve_linear(self) -> None:
        """Solve the scenes that the linear engine solves in float64: those of one pair, and of like forces, at once."""
        alike: dict[tuple[int, int], list[tuple[int, Prepared]]] = {}
        known = Known()
        for row in range(len(self.ends)):
            scene = self.exact(row)
            if not free_scene(scene) and not scene.friction.weakening:
                with suppress(OutOfRange):
                    one = prepare(scene, wide=False, known=known)
                    alike.setdefault((id(one.pair), id(one.tables)), []).append((row, one))
        for group in alike.values():
            rows = [row for row, _ in group]
            kept, ends = self.kept[rows], self.ends[rows]
            run_prepared([one for _, one in group], self.max_events, kept, ends)
            self.kept[rows], self.ends[rows] = kept, ends


def _free_rows(columns: Columns, literal: bool, max_events: int, kept: Table, ends: Table) -> None:
    compiled(solve_rows)(columns.table, literal, max_events, kept, ends)


def _rows_without_ledger(columns: Columns, literal: bool, max_events: int, kept: Table, ends: Table) -> None:
    run_rows(columns, literal, max_events, False, kept, ends)


def form_ledgers(columns: Columns, literal: bool, max_events: int, ends: Table) -> int:
    """Run once more the rows of which nobody has formed what friction and viscosity took; return how many there are."""
    rows = np.flatnonzero(np.isnan(ends[:, AT["friction"]]) & (ends[:, AT["how"]] < How.OUT_OF_RANGE))
    if len(rows):
        own = ends[rows]
        run_rows(columns.part(rows), literal, max_events, True, np.empty((len(rows), 1, ROW)), own)
        ends[rows] = own
    return len(rows)


def _solve_one(scene: Scene, max_events: int, kept: Table, end: Table) -> None:
    """Solve one scene, and write its first events and its end."""
    try:
        if scene.friction.weakening:
            _solve_in_balls(scene, max_events, kept, end)
            return
        found = run_scene(scene, _FLOAT64, max_events)
    except (EventUndecided, OutOfRange) as error:
        kept[:] = end[:] = np.nan  # also what a run wrote, in units of its own, before it ended so
        end[AT["how"]] = How.OUT_OF_RANGE if isinstance(error, OutOfRange) else How.DOUBT
        end[AT["mode"]] = end[AT["events"]] = end[AT["certain"]] = 0.0
        return
    end[:] = found.record.end
    rows = np.append(0, found.event_rows)[: len(kept)]
    kept[: len(rows)] = found.record.rows[rows]
    starts = starts_of(scene)
    if len(starts) > 1:  # times count from the start of the run
        for row in (*kept[: len(rows)], end):
            row[AT["local"]] += starts[int(row[AT["piece"]])]
            row[AT["piece"]] = 0.0


def _solve_in_balls(scene: Scene, max_events: int, kept: Table, end: Table) -> None:
    """Do the same for a scene that has no other arithmetic: the middles, and as bounds radii and rounding."""
    found = run_scene(scene, Ball(_DIGITS), max_events)
    with found.arithmetic.context():
        taken = found.ledger
        end[AT["how"]], end[AT["events"]], end[AT["certain"]] = found.record.how, found.record.events, 1.0
        end[AT["friction"]], end[AT["viscous"]] = float(taken.friction), float(taken.viscous)
        end[AT["dissipated_error"]] = 2.0**-50 * (end[AT["friction"]] + end[AT["viscous"]])
        knots = [found.record.rows[row] for row in np.append(0, found.event_rows)[: len(kept)]]
        for row, knot in [*zip(kept, knots, strict=False), (end, found.record.end)]:
            _write(row, knot, float(found.pieces[knot.piece].start))


def _write(row: Table, knot: Knot, start: float) -> None:
    """Write one row of balls as floats; its time counts from the start of the run."""
    for name in CODES:
        row[AT[name]] = float(getattr(knot, name))
    for name, bound in zip(("local", "length", "x1", "v1", "x2", "v2"), ("late", "", *BOUNDS[1:5]), strict=True):
        value = getattr(knot, name)
        row[AT[name]], row[AT[f"{name}_low"]] = float(value.mid()), 0.0
        if bound:
            row[AT[bound]] = float(value.rad()) + abs(float(value.mid())) * 2.0**-52
    row[AT["local"]], row[AT["piece"]] = row[AT["local"]] + start, 0.0
    row[AT["excess"]] = row[AT["excess_low"]] = row[AT["excess_error"]] = np.nan


def room(count: int, keep: int) -> tuple[Table, Table]:
    """Return the arrays for the ends of so many runs, and for start and first events of each; nan where none is."""
    return np.zeros((count, END_ROW)), np.full((count, keep + 1, ROW), np.nan)
