"""A run as its rows, read off the record: when the segments begin, in which state, where it ends; and any time between.

Which row's segment holds a time, and the flow from that row's state (flow.py).
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any, Literal

import numpy as np

from numerics.arithmetic.compiled import compiled, compiles_now
from numerics.arithmetic.precision import cached_property
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.frame import Frame
from numerics.linear.cells import PLAIN, mode_in
from numerics.linear.engine import ledger_of
from numerics.linear.modes import MODES, Mode
from numerics.linear.pieces import ExactPiece, pieces_of, starts_of
from numerics.linear.record import AT, How, Knot, Record, tabulate
from numerics.linear.system import LinearMode
from numerics.scene import Scene
from numerics.scene.decimals import short, shown
from numerics.trajectory.answer import Answer
from numerics.trajectory.columns import STATE, Array, Counts, Floats
from numerics.trajectory.flow import Moving, changes

Side = Literal["left", "right"]
_KNOT = {name: place for place, name in enumerate(Knot._fields)}
_union = np.frompyfunc(lambda one, two: one.union(two), 2, 1)


class Rows(Answer):
    """A scene, the arithmetic it was solved in, and the rows of its record, in SI units and in numbers."""

    def __init__(self, scene: Scene, arithmetic: Arithmetic, record: Record) -> None:
        """Keep what a run wrote."""
        self.scene, self.arithmetic, self.record = scene, arithmetic, record
        self.bounded, self._is_ball = arithmetic.name == "float64", arithmetic.name == "ball"

    @cached_property
    def _tables(self) -> tuple[dict[str, int], Array, Array]:
        """Return where columns stand in the rows of the record and in that of the end; of knots both are made."""
        rows, end, *_ = self.record
        if isinstance(rows, np.ndarray):
            return AT, rows, end
        *table, end = (one[:-1] for one in (*rows, end))
        return _KNOT, np.array(table, dtype=object), np.array(end, dtype=object)

    def row_code(self, name: str) -> Array:
        """Return a code of all rows."""
        at, rows, _ = self._tables
        return rows[:, at[name]]

    def row_table(self, *names: str) -> Array:
        """Return some numbers of all rows, a line each: floats, or an object array."""
        return self._read(self._tables[1], names)

    def row_end(self, *names: str) -> list[Number]:
        """Return numbers of the end; of floats also what friction or viscosity took up to there (J)."""
        found: list[Number] = self._read(self._tables[2].reshape(1, -1), names).ravel().tolist()
        return found

    def _read(self, rows: Array, names: tuple[str, ...]) -> Array:
        return np.asarray(rows.T[[self._tables[0][name] for name in names]])

    @cached_property
    def taken(self) -> Floats:
        """Return what was taken and given in a run in floats (linear/model.py TAKEN), J, and a bound on their errors."""
        return ledger_of(self.scene, self.record)

    @property
    def reached(self) -> bool:
        """Return whether the run got to its horizon."""
        return self.record.how != How.EVENT_LIMIT

    @property
    def certain(self) -> bool:
        """Return whether the error bounds leave no doubt about the sequence of events; without bounds True."""
        return bool(self.record.certain) or not self.bounded

    @property
    def pieces(self) -> Sequence[ExactPiece]:
        """Return the pieces of force and friction, exact."""
        return pieces_of(self.scene)

    @cached_property
    def row_signs(self) -> Counts:
        """Return the mode that starts at each row, the sign of v1 - v2."""
        return self.row_code("mode").astype(np.int64)

    @cached_property
    def row_pieces(self) -> Counts:
        """Return the piece in which each row is."""
        return self.row_code("piece").astype(np.int64)

    @cached_property
    def row_modes(self) -> tuple[Array, Counts]:
        """Return all (piece, sign, cell of friction) in which rows begin (linear/cells.py), and each row's one."""
        rows = self.record.rows
        cells = np.array([PLAIN] * len(rows) if isinstance(rows, np.ndarray) else [one.cell for one in rows])
        all_rows = np.column_stack([self.row_pieces, self.row_signs, cells])
        modes, which = np.unique(all_rows, axis=0, return_inverse=True)
        return modes, which.ravel()

    def row_mode(self, which: int) -> LinearMode:
        """Return one of the linear modes in which rows begin."""
        piece, sign, *cell = self.row_modes[0][which].tolist()
        return mode_in(self.scene, self.pieces[piece], sign, (cell[0], cell[1]))

    @cached_property
    def row_numbers(self) -> tuple[Floats, Floats]:
        """Return when each row begins in its piece, s, and its state, shape (4, n), in binary64."""
        return self.floats(self.row_table("local")[0]), self.floats(self.row_states)

    @cached_property
    def row_times(self) -> Array:
        """Return when each row's segment begins, s."""
        return self._begun(slice(None))

    def _begun(self, which: slice | Counts) -> Array:
        """Return when the segments of some rows begin, s."""
        rows, pieces = self._tables[1][which], self.row_pieces[which]
        if not self.row_pieces.any():
            return self._read(rows, ("local",))[0]
        if self.bounded:
            return np.asarray(starts_of(self.scene)[0, pieces] + rows[:, AT["local"]])
        with self.context():
            starts = np.array([self.arithmetic.number(piece.start) for piece in self.pieces], dtype=object)
            return np.asarray(starts[pieces] + self._read(rows, ("local",))[0])

    @cached_property
    def row_states(self) -> Array:
        """Return x1, v1, x2, v2 at each row, shape (4, n)."""
        return self.row_table(*STATE)

    @cached_property
    def row_excess(self) -> Array | None:
        """Return E/E_cr - 1 at each row, accurate in itself; None where a run does not carry it (free/ alone does)."""
        if self.bounded:
            return None
        found = self.row_table("excess")[0]
        return None if found[0] is None else found

    @cached_property
    def row_lengths(self) -> Array:
        """Return how long the segment of each row lasts, s."""
        after, last = self.row_table("length")[0, 1:], self.row_end("length")
        return np.append(after, last) if self.reached else after

    @cached_property
    def event_rows(self) -> Counts:
        """Return the rows at which the mode has changed: the events."""
        return np.flatnonzero(self.row_code("event"))

    @cached_property
    def _table(self) -> tuple[Counts, Array]:
        """Return the rows at which segments start, and t, x1, v1, x2, v2 there and at a horizon that was reached."""
        record, count = self.record, self.record.events + 1
        if self.bounded:
            read = compiled(tabulate) if compiles_now() else tabulate
            return read(record.rows, record.end, count, starts_of(self.scene)[0], float(self.scene.until), self.reached)
        at = np.append(0, self.event_rows)
        table = np.vstack([self._begun(at), self._read(self._tables[1][at], STATE)])
        return at, np.column_stack([table, [self.end_time, *self.final_state]]) if self.reached else table

    @property
    def signs(self) -> list[int]:
        """Return the sign of v1 - v2 in every segment, and in the motion after the last event."""
        signs: list[int] = self.row_code("mode")[self._table[0]].tolist()
        return signs

    @property
    def event_times(self) -> Array:
        """Return the times of all events, s, shape (k,)."""
        return self._table[1][0, 1 : self.record.events + 1]

    @property
    def event_states(self) -> Array:
        """Return x1, v1, x2, v2 at all events, shape (4, k)."""
        return self._table[1][1:, 1 : self.record.events + 1]

    @property
    def final_mode(self) -> Mode:
        """Return the mode at the end: after the last event, where the cap on events ended the run."""
        return MODES[float(self._tables[2][self._tables[0]["mode"]])]

    @cached_property
    def final_state(self) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) at the end."""
        x1, v1, x2, v2 = self.row_end(*STATE)
        return x1, v1, x2, v2

    @cached_property
    def final_energy(self) -> Number:
        """Return the energy at the end, J, formed from the state."""
        with self.context():
            return self.scene.pair.energy(self.final_state, self.arithmetic.number)

    @cached_property
    def end_time(self) -> Number:
        """Return the time at the end, s."""
        with self.context():
            return self.arithmetic.number(self.scene.until) if self.reached else self.row_times[-1]

    @cached_property
    def frame(self) -> Frame:
        """Return the constants of the pair, between SI units and reduced coordinates of its own b."""
        with self.context():
            return Frame(self.arithmetic, self.scene.pair)

    def _times(self, t: Any) -> Array:
        """Return times (s) as numbers of the arithmetic, in their shape. Raises ValueError outside [0, end]."""
        try:
            given = np.asarray(t)
        except ValueError:
            raise ValueError("t must be a time in seconds or an array of times; its rows differ in length") from None
        if self.bounded and given.dtype.kind in "fiu" and ((given >= 0) & (given <= self.end_time)).all():
            return given.astype(float)
        each = np.vectorize(self._time, otypes=[float if self.bounded else object])
        return np.asarray(each(np.asarray(t, dtype=object)))

    def _time(self, t: Any) -> Number:
        """Return a time as a number of the arithmetic: exact from rationals and floats, its own numbers as they are."""
        own, to_float = not self.bounded and isinstance(t, type(self.end_time)), self.arithmetic.to_float
        end, until = to_float(self.end_time), self.scene.until if self.reached else Fraction(0)
        exact: Any = to_float(t) if own else exact_time(t)
        if not 0 <= exact <= max(until, Fraction(end)):
            shown = self.arithmetic.text(t) if own else str(t)[:40]
            raise ValueError(
                f"t = {shown} s is outside the solved time [0, {end:g}] s; give one within it, or solve further"
            )
        return t if own else self.arithmetic.number(exact)

    def _middles(self, times: Array) -> Array:
        """Return times themselves, or midpoints of balls: floats would not tell the ends of a short slip apart."""
        return np.array([one.mid() for one in times], dtype=object) if self._is_ball else times

    @cached_property
    def _row_points(self) -> Array:
        """Return when each row's segment begins, s, as points: those of the events, so that each finds its segments."""
        return self._middles(self.row_times)

    def _rows(self, times: Array, side: Side) -> Counts:
        require_side(side)
        return np.maximum(np.searchsorted(self._row_points, self._middles(times), side=side) - 1, 0)

    def row_at(self, t: Any, side: Side = "right") -> Counts:
        """Return the rows whose segments hold time(s) t (s), flat; at an event that on the given side."""
        with self.context():
            return self._rows(self._times(t).ravel(), side)

    def sol(self, t: Any, side: Side = "right") -> Array:
        """Return (x1, v1, x2, v2) at the time(s) t (s): shape (4,) for a number, (4, ...) for an array.

        t is exact (int, Fraction, decimal text, or a float taken as its binary value) or a number of the arithmetic,
        such as the time of an event; `side` says which segment answers at an event, where the state is continuous but
        the accelerations jump. Enclosures for balls: where the segment is not decided, both answer. Raises ValueError
        outside [0, end].
        """
        with self.context():
            given = self._times(t)
            return self.row_values(self.row_flow, given.ravel(), side).reshape(4, *given.shape)

    def mode_at(self, t: Any, side: Side = "right") -> Any:
        """Return the mode at time t (s), an object array for a sequence; at an event that on the given side."""
        found = [MODES[sign] for sign in self.row_signs[self.row_at(t, side)]]
        return np.array(found, dtype=object).reshape(np.shape(t))[()]

    def _excess(self, t: Any, side: Side) -> Number:
        """Return E/E_cr - 1 at one time, accurate in itself, of a run that carries it; None where it does not.

        What friction took since the last event is subtracted from what it was there: such a pair has no damper.
        """
        carried, unit = self.row_excess, self.frame.critical_energy
        if carried is None:
            return None

        def left(rows: Counts, since: Array) -> Array:
            return np.asarray(carried[rows] - self.row_losses(rows, since)[0] / unit)

        found: Number = self.row_values(left, self._times(t).reshape(1), side).tolist()[0]
        return found

    def row_values(self, function: Callable[..., Array], times: Array, side: Side) -> Array:
        """Return a function of rows and of the times since they began at times of the run.

        Where balls leave open which segment holds a time, all that may hold it answer.
        """
        rows, starts, found = self._rows(times, side), self.row_times, []
        if not self._is_ball:
            return function(rows, self._since(times, rows))
        for time, row in zip(times, rows.tolist(), strict=True):
            first, after = row, row + 1  # this one holds its middle
            while first > 0 and not (starts[first] < time or starts[first] == time):  # both exact
                first -= 1
            while after < len(starts) and not (time < starts[after] or time == starts[after]):
                after += 1
            held = np.arange(first, after)
            found.append(reduce(_union, function(held, time - starts[held]).T))
        return _columns(found)

    def _since(self, times: Array, rows: Counts) -> Array:
        """Return how long after the starts of their rows times are, s."""
        if not self.bounded:
            return np.asarray(times - self.row_times[rows])
        starts = np.array([float(piece.start) for piece in self.pieces])
        return np.asarray(np.maximum((times - starts[self.row_pieces[rows]]) - self.row_table("local")[0][rows], 0.0))

    def row_flow(self, rows: Counts, since: Array) -> Array:
        """Return the states at times (s) after the starts of rows, shape (4, n); in the arithmetic's context."""
        if self.bounded:
            return np.asarray(self.row_states[:, rows] + self.row_changes(rows, since)[:4])
        return _columns([self.row_motion(row).after(tau) for row, tau in zip(rows, since, strict=True)])

    def row_losses(self, rows: Counts, since: Array) -> Array:
        """Return b int |v1 - v2|, a1 int v1^2 and int u v1 from the starts of rows on for times (s), J, (3, n)."""
        if self.bounded:
            return self.row_changes(rows, since, integrals=True)[4:7]
        return _columns([self.row_motion(row).losses(tau) for row, tau in zip(rows, since, strict=True)])

    def row_motion(self, row: int) -> Moving:
        """Return the motion of a row's segment; not for binary64."""
        mode, state = self.row_mode(self.row_modes[1][row]), self.row_states[:, row].tolist()
        return Moving(self.arithmetic, mode, state, self.row_times[row])

    def row_changes(self, rows: Counts, tau: Floats, *, integrals: bool = False) -> Floats:
        """Return `changes` (flow.py) of the motions from rows on, row by row for a time (s); in binary64."""
        (local, y), found, which = self.row_numbers, np.zeros((8, len(tau))), self.row_modes[1][rows]
        for one in np.unique(which):
            chosen = which == one
            begun = local[rows[chosen]], y[:, rows[chosen]]
            found[:, chosen] = changes(self.row_mode(one), begun, tau[chosen], integrals)
        return found


def _columns(found: list[Any]) -> Array:
    return np.array(found, dtype=object).T if found else np.empty((4, 0), dtype=object)


def exact_time(t: Any, name: str = "t") -> Fraction:
    """Return a time as an exact rational: text as a decimal, a float as its binary value. Raises ValueError."""
    try:
        if isinstance(t, bool):
            raise TypeError
        if hasattr(t, "as_integer_ratio"):
            return Fraction(*t.as_integer_ratio())
        return Fraction(t if isinstance(t, str) else operator.index(t))
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        raise ValueError(f"{name} = {shown(t)} is not a time in seconds; give a finite number >= 0") from None


def require_side(side: Any) -> None:
    """Raise ValueError for what is no side of an event."""
    if not isinstance(side, str) or side not in ("left", "right"):
        raise ValueError(f"side = {shown(side)} is not one of left, right")


def require_times(t_eval: Any, until: Fraction) -> None:
    """Raise ValueError unless these are times (s) of a run, in order; balls and mpmath's are looked at later."""
    try:
        given = np.asarray(t_eval)
    except ValueError:  # rows that differ in length
        given = np.asarray(None)
    except MemoryError:
        raise ValueError(f"t_eval = {shown(t_eval)} has more times than memory holds; give fewer at once") from None
    if given.ndim != 1:
        raise ValueError(f"t_eval = {shown(t_eval)} must be a sequence of times in seconds; give one such as [0, 0.5]")
    last = float(min(until, Fraction(10**300)))
    if given.dtype.kind in "fiu":  # all at once; only a wrong one is looked for exactly
        times = given.astype(float)
        if ((times >= 0) & (times <= last)).all() and (times[1:] >= times[:-1]).all():
            return
    end, before = max(until, Fraction(last)), Fraction(0)  # type: Fraction, Any
    for k, one in enumerate(t_eval):
        point = one if hasattr(one, "man_exp") else exact_time(one, f"t_eval[{k}]")
        if isinstance(point, Fraction) and not 0 <= point <= end:
            outside = f"t_eval[{k}] = {str(one)[:40]} s is outside the run, [0, {short(until)}] s"
            raise ValueError(f"{outside}; give times within it, or a later until")
        if type(point) is type(before) and point < before:
            raise ValueError(f"t_eval[{k}] = {str(one)[:40]} s comes after a later time; put the times in order")
        before = point
