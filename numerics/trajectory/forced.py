"""The answer under a force: the same interface as that of a free pair; jumps of u and b may lie in its segments."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.ball_words import widened
from numerics.arithmetic.protocol import Number
from numerics.flows.forced_records import Drive, Pair
from numerics.motion.codes import EVENT_LIMIT, STUCK
from numerics.motion.forced_pair import pair_of
from numerics.motion.forced_pieces import ExactPieces, drive_of, has_seams, pieces_of
from numerics.motion.modes import MODES, Mode, event_kind
from numerics.motion.records import ReducedState
from numerics.trajectory.deferred import Deferred
from numerics.trajectory.dense import Side
from numerics.trajectory.digits import Accuracy
from numerics.trajectory.forced_accuracy import accuracy_of
from numerics.trajectory.forced_dense import ForcedDense
from numerics.trajectory.forced_record import ForcedRecord
from numerics.trajectory.forced_segment import ForcedSegment, Parts, ledger_of, parts_of
from numerics.trajectory.forced_table import table_of
from numerics.trajectory.forced_units import in_seconds, in_unit, unit_of_time
from numerics.trajectory.segment import EnergyLedger, Event
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory

_STATE = ("x1", "v1", "x2", "v2")


class ForcedTrajectory(Trajectory):
    """A solved scene with a force. Enclosures for balls: the path, and all within the bounds of the contraction."""

    record: Any

    @property
    def certain(self) -> bool:
        """Return True: a run that is in doubt is refused."""
        return True

    @property
    def right_digits(self) -> int:
        """Return how many digits of every number its error bounds leave right."""
        return 0 if self.accuracy is None else self.accuracy.digits

    @property
    def reached(self) -> bool:
        """Return whether the run got to its horizon."""
        return bool(self.record.how != EVENT_LIMIT)

    @property
    def status(self) -> Status:
        """Return how the solve ended."""
        if not self.reached:
            return Status.EVENT_LIMIT
        later = (*self.scene.force.starts, *self.scene.friction.starts)
        for_ever = self.record.how == STUCK and max(later) < self.scene.until
        return Status.STUCK_FOR_EVER if for_ever else Status.REACHED_HORIZON

    @property
    def phase_lost(self) -> bool:
        """Return False: what is lost shows in the bounds."""
        return False

    @staticmethod
    def restored_record(parts: tuple[Any, ...]) -> ForcedRecord:
        """Return the record from its plain form."""
        return ForcedRecord.restored(*parts)

    @cached_property
    def pieces(self) -> ExactPieces:
        """Return the pieces of force and friction as the run saw them, exact."""
        return pieces_of(self.scene, with_seams=has_seams(self.arithmetic))

    @cached_property
    def tables(self) -> tuple[Pair, Drive]:
        """Return the pair and the table of pieces, in numbers of the arithmetic."""
        with self.arithmetic.context():
            return pair_of(self.scene, self.arithmetic), drive_of(self.scene, self.pieces, self.arithmetic)

    @cached_property
    def knots(self) -> NDArray[np.int64]:
        """Return the rows at which the mode has changed: the events."""
        return np.flatnonzero(self.record.codes("event") == 1.0)

    @cached_property
    def signs(self) -> list[float]:
        """Return the sign of v1 - v2 in every segment, and in the motion after the last event."""
        modes = self.record.codes("mode")
        return [float(modes[0]), *modes[self.knots].tolist()]

    @property
    def final_mode(self) -> Mode:
        """Return the mode at the end."""
        return MODES[float(self.record.end_row[0])]

    @cached_property
    def final_state(self) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) at the end."""
        with self.arithmetic.context():
            return self.enclosed(-1)

    def enclosed(self, row: int) -> Any:
        """Return the state at the start of a segment, with its bounds where the arithmetic has radii."""
        number = self.record.number
        if self.arithmetic.name != "ball":
            return tuple(number(row, name) for name in _STATE)
        return tuple(widened(number(row, name), number(row, f"{name}_error")) for name in _STATE)

    def time_of(self, row: int) -> Number:
        """Return when the segment of a row begins, s; -1: the end. In the arithmetic's context."""
        record, number = self.record, self.arithmetic.number
        code = record.end_row if row < 0 else record.rows[row]
        if row < 0 and self.reached:
            return number(self.scene.until)
        at = number(self.pieces[int(code[3])].start) + record.number(row, "local")
        return widened(at, record.number(row, "late")) if self.arithmetic.name == "ball" else at

    @property
    def end_time(self) -> Number:
        """Return the time at the end, s."""
        with self.arithmetic.context():
            return self.time_of(-1)

    @cached_property
    def _table(self) -> tuple[NDArray[Any], NDArray[np.int64]]:
        """Return t, x1, v1, x2, v2 at start, events and, if it was reached, horizon, shape (5, m); events by kind."""
        rows = [0, *self.knots.tolist(), *([-1] if self.reached else [])]
        table = table_of(self, rows)
        signs = np.array(self.signs)
        kinds = np.where(signs[1:] == 0, 0, np.where(signs[:-1] == 0, 1, 2))  # entry, exit, crossing
        entries, exits = np.count_nonzero(kinds == 0), np.count_nonzero(kinds < 2)
        return table, np.array([entries, exits, *np.argsort(kinds, kind="stable")], dtype=np.int64)

    @property
    def event_times(self) -> NDArray[Any]:
        """Return the times of all events, s, shape (k,)."""
        return self._table[0][0, 1 : len(self.knots) + 1]

    @property
    def event_states(self) -> NDArray[Any]:
        """Return x1, v1, x2, v2 at all events, shape (4, k)."""
        return self._table[0][1:, 1 : len(self.knots) + 1]

    def as_reduced(self, y: Any) -> ReducedState:
        """Return a state (x1, v1, x2, v2) in reduced coordinates, of the pair's own b."""
        x1, v1, x2, v2 = y
        length, speed = self.frame.length, self.frame.speed
        X, V1, V2 = x1 / length, v1 / speed, v2 / speed
        return ReducedState(X, V1, V2, (x1 - x2) / length, self.frame.energy_ratio(X, V1, V2) - 1)

    @property
    def units(self) -> tuple[Number, Number, Number]:
        """Return L (m), Omega (1/s) and E_cr (J) of the pair's own b."""
        return self.frame.units

    @property
    def final(self) -> ReducedState:
        """Return the reduced state at the end."""
        with self.arithmetic.context():
            return self.as_reduced(self.final_state)

    @property
    def initial(self) -> ReducedState:
        """Return the reduced state at the start."""
        with self.arithmetic.context():
            return self.as_reduced(self.enclosed(0))

    @cached_property
    def final_energy(self) -> Number:
        """Return the energy at the end, J, formed from the state."""
        with self.arithmetic.context():
            return self._energy(self.final_state)

    def _energy(self, y: Any) -> Number:
        pair, number = self.scene.pair, self.arithmetic.number
        x1, v1, _, v2 = y
        return (x1 * x1 * number(pair.a2) + v1 * v1 * number(pair.m1) + v2 * v2 * number(pair.m2)) / number(2)

    @cached_property
    def events(self) -> Any:
        """Return the events, each made when it is looked at."""
        return Deferred(self._event, len(self.knots))

    def _event(self, index: int) -> Event:
        before, after = (MODES[sign] for sign in self.signs[index : index + 2])
        t, y = self.event_times[index], tuple(self.event_states[:, index])
        if self.arithmetic.name == "float64":
            t, y = float(t), tuple(map(float, y))
        cause = "jump" if self.record.codes("jump")[self.knots[index]] else "guard"
        with self.arithmetic.context():
            return Event(t, event_kind(before, after), before, after, y, self.as_reduced(y), cause)

    @cached_property
    def segments(self) -> Any:
        """Return the segments, each made when it is looked at."""
        return Deferred(self._segment, len(self.knots) + self.reached)

    def _segment(self, index: int) -> ForcedSegment:
        t = [*self._table[0][0], self.end_time]
        return ForcedSegment(MODES[self.signs[index]], t[index], t[index + 1], self)

    @cached_property
    def in_unit(self) -> ForcedTrajectory:
        """Return the same trajectory with its times in the unit in which it was followed; itself, mostly."""
        unit = unit_of_time(self.scene)
        if unit == 1:
            return self
        with self.arithmetic.context():
            record = in_seconds(self.record, 1 / unit, self.arithmetic)
        return ForcedTrajectory(in_unit(self.scene, unit), self.arithmetic, record, bounded=self.bounded)

    @cached_property
    def dense(self) -> ForcedDense:
        """Return the evaluation at any time."""
        return ForcedDense(self)

    @cached_property
    def _dense(self) -> Any:
        return self.dense

    def _in_si(self, state: Any) -> Any:
        return state  # it is

    def reduced(self, t: Any, side: Side = "right") -> ReducedState:
        """Return the reduced state at time t (s), of the pair's own b."""
        with self.arithmetic.context():
            return self.as_reduced(self._dense.state(t, side))

    @cached_property
    def accuracy(self) -> Accuracy | None:
        """Return the error bounds of a float64 or double-double trajectory, else None (balls carry their own)."""
        return accuracy_of(self) if self.bounded else None

    @cached_property
    def parts(self) -> Parts:
        """Return what friction and viscosity took and u put in, in the unit of time in which it was followed."""
        with self.arithmetic.context():
            return parts_of(self.in_unit)

    @cached_property
    def ledger(self) -> EnergyLedger:
        """Return the energy ledger of the whole run, with the work of u."""
        with self.arithmetic.context():
            return ledger_of(self)
