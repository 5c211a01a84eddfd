"""A run as its rows: when the segments begin, in which state, and where it ends; all read off the record."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compiled, compiles_now
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.frame import Frame
from numerics.linear.cells import PLAIN, mode_in
from numerics.linear.modes import MODES, Mode
from numerics.linear.pieces import ExactPiece, pieces_of, starts_of
from numerics.linear.record import How, Record, tabulate
from numerics.linear.system import LinearMode
from numerics.scene import Scene
from numerics.trajectory.answer import Answer
from numerics.trajectory.columns import STATE, Array, Columns, Counts, Floats


class Rows(Answer):
    """A scene, the arithmetic it was solved in, and the rows of its record, in SI units and in numbers."""

    def __init__(self, scene: Scene | Callable[[], Scene], arithmetic: Arithmetic, record: Record) -> None:
        """Keep what a run wrote."""
        self._given, self.arithmetic, self.record = scene, arithmetic, record
        self.bounded = arithmetic.name in {"float64", "double-double"}
        self._in_floats, self._is_ball = arithmetic.name == "float64", arithmetic.name == "ball"

    @property
    def scene(self) -> Scene:
        """Return the scene; a prepared solver makes it when it is looked at."""
        if not isinstance(self._given, Scene):
            self._given = self._given()
        return self._given

    @cached_property
    def columns(self) -> Columns:
        """Return the record by its columns."""
        return Columns(self.record, wide=self.arithmetic.name == "double-double")

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
        return self.columns.code("mode").astype(np.int64)

    @cached_property
    def row_pieces(self) -> Counts:
        """Return the piece in which each row is."""
        return self.columns.code("piece").astype(np.int64)

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
        return self.floats(self.columns.numbers("local")), self.floats(self.row_states)

    @cached_property
    def row_times(self) -> Array:
        """Return when each row's segment begins, s."""
        local = self.columns.numbers("local")
        if not self.row_pieces.any():
            return local
        if self._in_floats:
            return np.asarray(starts_of(self.scene)[self.row_pieces] + local)
        with self.context():
            starts = np.array([self.arithmetic.number(piece.start) for piece in self.pieces], dtype=object)
            return np.asarray(starts[self.row_pieces] + local)

    @cached_property
    def row_states(self) -> Array:
        """Return x1, v1, x2, v2 at each row, shape (4, n)."""
        return self.columns.table(*STATE)

    @cached_property
    def row_lengths(self) -> Array:
        """Return how long the segment of each row lasts, s."""
        after, last = self.columns.numbers("length")[1:], self.columns.last("length")
        return np.append(after, last) if self.reached else after

    @cached_property
    def event_rows(self) -> Counts:
        """Return the rows at which the mode has changed: the events."""
        return np.flatnonzero(self.columns.code("event") == 1.0)

    @cached_property
    def _table(self) -> tuple[Counts, Array]:
        """Return the rows at which segments start, and t, x1, v1, x2, v2 there and at a horizon that was reached."""
        record, count = self.record, self.record.events + 1
        if self._in_floats:
            read = compiled(tabulate) if compiles_now() else tabulate
            return read(record.rows, record.end, count, starts_of(self.scene), float(self.scene.until), self.reached)
        at = np.append(0, self.event_rows)
        table = np.vstack([self.row_times[at], self.row_states[:, at]])
        return at, np.column_stack([table, [self.end_time, *self.final_state]]) if self.reached else table

    @property
    def signs(self) -> list[float]:
        """Return the sign of v1 - v2 in every segment, and in the motion after the last event."""
        signs: list[float] = self.columns.code("mode")[self._table[0]].tolist()
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
        return MODES[float(self.columns.end[self.columns.at["mode"]])]

    @cached_property
    def final_state(self) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) at the end."""
        x1, v1, x2, v2 = self.columns.last(*STATE)
        return x1, v1, x2, v2

    @cached_property
    def final_energy(self) -> Number:
        """Return the energy at the end, J, formed from the state."""
        with self.context():
            return self.energy_of(self.final_state)

    @cached_property
    def end_time(self) -> Number:
        """Return the time at the end, s."""
        with self.context():
            return self.arithmetic.number(self.scene.until) if self.reached else self.row_times[-1]

    def energy_of(self, y: Any) -> Any:
        """Return (a2 x1^2 + m1 v1^2 + m2 v2^2)/2 of states (4, ...), J."""
        pair, number = self.scene.pair, self.arithmetic.number
        x1, v1, _, v2 = y
        return (x1 * x1 * number(pair.a2) + v1 * v1 * number(pair.m1) + v2 * v2 * number(pair.m2)) / 2

    @cached_property
    def frame(self) -> Frame:
        """Return the constants of the pair, between SI units and reduced coordinates of its own b."""
        with self.context():
            return Frame(self.arithmetic, self.scene.pair)
