"""What a trajectory consists of: segments in one mode, the events between them, and where the energy went.

Powers are integrated anew between the rows of a record, each time from the state of a row over the length that the run
says (flow.py, in float64 linear/ledger.py): an engine that put an event, or the state at it, in a wrong place leaves a
residual.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball, as_float
from numerics.arithmetic.protocol import Number
from numerics.free.frame import ReducedState
from numerics.linear.engine import taken_of_floats
from numerics.linear.model import WALL
from numerics.linear.modes import EventKind, Mode
from numerics.linear.record import NUMBERS, ROW, How, Record
from numerics.linear.system import value
from numerics.scene import Signal
from numerics.scene.short_repr import ShortRepr, record
from numerics.trajectory.columns import STATE, Array, Counts
from numerics.trajectory.flow import enclosed, taken
from numerics.trajectory.rows import RecordedRun

if TYPE_CHECKING:
    from numerics.scene.decimals import Quantity

_LONG = Ball(20)
"""For segments that are too long for steps in float64."""
_ROUNDED = 2.0**-51
"""A sum of two floats, both rounded, is off by so much of its size."""


@record
class Event(ShortRepr):
    """A change of mode at the time t (s), from `before` to `after`, at y = (x1, v1, x2, v2) in SI units.

    `kind`: crossing, entry of a stick or exit; `cause`: "guard", a velocity or a load got there; or "jump", of the
    force or of b; `reduced`: the state in the engine's own units.

    >>> from numerics import load_scene, solve
    >>> event = solve(load_scene("velocities")).events[20]
    >>> round(event.t, 6), event.kind.name, event.before.value, event.after.value, event.cause
    (4.549769, 'ENTRY', 'slip+', 'stick', 'guard')
    >>> [round(float(one), 5) for one in event.y]
    [0.00035, 0.00555, -0.0002, 0.00555]
    """

    t: Quantity
    kind: EventKind
    before: Mode
    after: Mode
    y: tuple[Quantity, Quantity, Quantity, Quantity]
    reduced: ReducedState = field(repr=False)
    cause: str = "guard"


@record
class Segment(ShortRepr):
    """One mode of motion from `start` to `end` (s); u and b may jump in it.

    `length` (s) is kept apart: next to a late start the difference of both would round a short slip away.

    >>> from numerics import load_scene, solve
    >>> run = solve(load_scene("velocities"))
    >>> stuck, slip = run.segments[21:23]
    >>> stuck.mode.value, round(stuck.start, 6), float(round(stuck.length, 6)), slip.start == stuck.end
    ('stick', 4.549769, 0.029769, True)
    >>> with run.arithmetic.context():
    ...     [round(float(one), 6) for one in (*slip.state(0.1), slip.losses()[0])]
    [0.000587, -0.002827, 0.000129, -0.000732, 1.3e-05]
    """

    mode: Mode
    start: Quantity
    end: Quantity
    length: Quantity
    rows: range = field(repr=False)
    run: RecordedRun = field(repr=False, compare=False)

    def state(self, since: Quantity) -> tuple[Quantity, Quantity, Quantity, Quantity]:
        """Return (x1, v1, x2, v2) at `since` (s) after the start, m and m/s; in the arithmetic's context."""
        row = self.rows[0]
        for later in self.rows[1:]:  # pieces of force begin within
            before = self.run.row_lengths[row]
            if self.run.arithmetic.to_float(since - before) <= 0:
                break
            row, since = later, since - before
        x1, v1, x2, v2 = self.run.row_flow(np.array([row]), np.array([since]))[:, 0].tolist()
        return x1, v1, x2, v2

    def losses(self) -> tuple[Quantity, Quantity]:
        """Return what friction and viscosity take in it, b int |v1 - v2| and a1 int v1^2, J."""
        friction, viscous, *_ = taken_in(self.run, self.rows)
        return friction, viscous


@record
class EnergyLedger(ShortRepr):
    """Where the energy went, J: initial - final against what friction and damper took and what acts put in.

    `friction` is b int |v1 - v2| dt (on a belt too), `viscous` a1 int (v1 - y')^2 dt. `force`, `force_2`, `belt` and
    `wall` are the works of what acts, `work` their sum. `residual` = initial + work - final - friction - viscous:
    rounding only, and an enclosure of 0 for balls. The integrals start anew from the state at each event, so that an
    event at the wrong place shows.

    >>> from numerics import load_scene, solve
    >>> books = solve(load_scene("velocities")).ledger
    >>> [round(float(one), 6) for one in (books.initial, books.final, books.friction, books.viscous, books.work)]
    [0.01125, 2.9e-05, 0.011221, 0.0, 0.0]
    >>> abs(books.residual) < 1e-15, books.force, books.force_2, books.belt, books.wall
    (True, 0.0, 0.0, 0.0, 0.0)
    """

    initial: Quantity
    final: Quantity
    friction: Quantity
    viscous: Quantity
    residual: Quantity
    work: Quantity
    force: Quantity
    force_2: Quantity
    belt: Quantity
    wall: Quantity
    error: float
    """A bound on the errors of what is integrated, in float64; 0 for balls and mpmath."""


def ledger_of(run: RecordedRun) -> EnergyLedger:
    """Return the ledger of the whole run; in the arithmetic's context."""
    rows = range(len(run.row_lengths))
    friction, viscous, force, force_2, belt, wall, error = taken_in(run, rows)
    wall = wall + _by_jumps_of_the_wall(run)
    times, states = run._own_moments
    initial, final = energy_of(run, times[[0, -1]], states[:, [0, -1]], np.array([0, -1])).tolist()
    work = force + force_2 + belt + wall
    residual = initial + work - final - friction - viscous
    return EnergyLedger(initial, final, friction, viscous, residual, work, force, force_2, belt, wall, error)


def taken_in(run: RecordedRun, rows: range) -> list[Number]:
    """Return what is taken and given (model.TAKEN) in some rows, J, and in floats a bound on the error of each."""
    if not run.bounded:
        zero, lengths = run.arithmetic.number(0), run.row_lengths[rows.start : rows.stop]
        return [*(sum(part.tolist(), zero) for part in run.row_taken(np.array(rows, dtype=int), lengths)), 0.0]
    record, end = run.record, run.record.end.copy()
    if rows.stop < len(record.rows):
        end[:ROW] = record.rows[rows.stop]
    taken, left = taken_of_floats(run.scene, Record(record.rows[rows.start : rows.stop], end, How.REACHED, 0))
    for row in left:
        enclosed = _enclosed(run, rows[row])
        off = sum(float(one.rad() + one.abs_upper() * _ROUNDED) for one in enclosed)
        taken += [*map(as_float, enclosed), off]
    found: list[Number] = taken.tolist()
    return found


def _enclosed(run: RecordedRun, row: int) -> Sequence[arb]:
    """Return what is taken in a row's segment in float64, from all starts within their bounds."""
    local, rest, length, *state = (run.row_column(name) for name in NUMBERS)
    begun = Ball.number(run.pieces[run.row_pieces[row]].start) + local[row] + rest[row]
    errors = (run.row_column(f"{name}_error")[row] for name in STATE)
    with _LONG.context():
        start = [arb(float(x[row]), float(off)) for x, off in zip(state, errors, strict=True)]
        return enclosed(_LONG, run.row_mode(row), start, begun, arb(float(length[row + 1])), taken)


def energy_of(run: RecordedRun, t: Array, y: Array, rows: Counts | None = None) -> Array:
    """Return the energy of states at times, J, in rows if they are known: of the spring by its length.

    In the arithmetic's context.
    """
    x1, *others = y
    if run.scene.wall.pieces:
        if rows is None and not run.bounded:
            found = run.row_values(lambda at, since: wall_of(run, at, run.row_times[at] + since), t, "right")
        else:
            found = wall_of(run, run.row_at(t) if rows is None else rows, t)
        x1 = x1 - found[0]
    return np.asarray(run.scene.pair.energy((x1, *others), float if run.bounded else run.arithmetic.number))


def wall_of(run: RecordedRun, rows: Counts, t: Array) -> Array:
    """Return the displacement of the wall at times, m, each by the piece of its row, shape (1, n)."""
    found = []
    for row, time in zip(rows.tolist(), t, strict=True):
        if run.bounded:
            piece = run.pieces[run.row_pieces[row]]
            at = max(Fraction(time), piece.start)  # a start is rounded
            found.append(float(Signal((piece.signals[WALL],))(at)))
        else:
            mode = run.row_mode(row)
            z = mode.begin(run.row_states[:, row].tolist(), time)
            found.append(value(mode.signal(WALL), z))
    return np.array([found])


def _by_jumps_of_the_wall(run: RecordedRun) -> Number:
    """Return what jumps of the wall put into the spring, J."""
    total, half = run.arithmetic.number(0), run.arithmetic.number(run.scene.pair.a2 / 2)
    for k in np.flatnonzero(np.diff(run.row_pieces)) + 1:
        if run.pieces[run.row_pieces[k]].start in run.scene.wall.starts:
            before, after = run.row_states[0, k] - wall_of(run, np.array([k - 1, k]), run.row_times[[k, k]])[0]
            total += half * (after - before) * (after + before)
    return total
