"""The result of solving a scene: exact segments joined by events. Nothing is sampled until somebody asks."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property, partial
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import FLOAT64
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import compiles_now
from numerics.motion.modes import MODES, EventKind, Mode, event_kind
from numerics.motion.records import ReducedState
from numerics.trajectory.deferred import Deferred
from numerics.trajectory.dense import Dense, Side
from numerics.trajectory.run import Run
from numerics.trajectory.segment import EnergyLedger, Event, Segment, event_of, segment_of
from numerics.trajectory.si_table import si_table

Kind = Literal["velocities", "positions", "load", "force", "phase", "excess", "energy"]


class Trajectory(Run):
    """A solved scene, in the words of SciPy's solution objects and with the physics beside them.

    Rows of `y` are x1, v1 (m, m/s) and x2, v2; columns belong to `t` (s): start, events, end; with t_eval, those times
    instead. With float64 they are float arrays, otherwise object arrays of the arithmetic's numbers (enclosures for
    balls). Everything is made when it is looked at. Two trajectories are equal if every number is.
    """

    @cached_property
    def modes(self) -> tuple[Mode, ...]:
        """Return the itinerary: the mode of every segment."""
        return tuple(map(MODES.__getitem__, self.signs if self.reached else self.signs[:-1]))

    @property
    def event_kinds(self) -> tuple[EventKind, ...]:
        """Return the kinds of the events in their order."""
        modes = [MODES[sign] for sign in self.signs]
        return tuple(map(event_kind, modes, modes[1:]))

    @property
    def final_mode(self) -> Mode:
        """Return the mode at the end: after the last event, where the cap on events ended the run."""
        return MODES[self.record.end_code("mode")]

    @property
    def final(self) -> ReducedState:
        """Return the reduced state at the end: of the last event, where the cap on events ended the run."""
        return ReducedState(*(self.record.end(name) for name in ReducedState._fields))

    @cached_property
    def final_state(self) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) at the end."""
        with self.arithmetic.context():
            return self._in_si(self.final)

    @cached_property
    def final_energy(self) -> Number:
        """Return the energy at the end, J, formed from the state."""
        with self.arithmetic.context():
            return self.frame.energy(self.final)

    def _in_si(self, state: Any) -> Any:
        length, rate, _ = self.units
        speed = length * rate
        return state.X * length, state.V1 * speed, (state.X - state.Z) * length, state.V2 * speed

    @property
    def end_time(self) -> Number:
        """Return the time at the end, s."""
        with self.arithmetic.context():
            return self.record.end("tau") / self.units[1]

    @cached_property
    def _table(self) -> tuple[NDArray[Any], NDArray[np.int64]]:
        """Return t, x1, v1, x2, v2 at start, events and, if it was reached, horizon, shape (5, m); events by kind."""
        count, floats = len(self.record), self.arithmetic.name == "float64"
        table = np.empty((5, count + 1 + self.reached), dtype=float if floats else object)
        order = np.empty(count + 2, dtype=np.int64)
        rows, end = self.record.in_numbers()
        if floats:
            (FLOAT64.compiled if compiles_now() else FLOAT64)(si_table)(rows, end, table, order)
        else:
            with self.arithmetic.context():
                si_table(rows, end, table, order)
        return table, order

    @property
    def event_times(self) -> NDArray[Any]:
        """Return the times of all events, s, shape (k,)."""
        return self._table[0][0, 1 : len(self.record) + 1]

    @property
    def event_states(self) -> NDArray[Any]:
        """Return x1, v1, x2, v2 at all events, shape (4, k)."""
        return self._table[0][1:, 1 : len(self.record) + 1]

    @property
    def t(self) -> NDArray[Any]:
        """Return the times of start, events and end, or t_eval, s, shape (m,)."""
        return self._table[0][0] if self.t_eval is None else self._at_t_eval[0]

    @property
    def y(self) -> NDArray[Any]:
        """Return the states at `t`, shape (4, m)."""
        return self._table[0][1:] if self.t_eval is None else self._at_t_eval[1]

    @cached_property
    def _at_t_eval(self) -> tuple[NDArray[Any], NDArray[Any]]:
        with self.arithmetic.context():
            times = [self._dense.time(one) for one in self.t_eval]
        return self._array(times), self.sol(self.t_eval)

    @property
    def initial(self) -> ReducedState:
        """Return the reduced state at the start."""
        return ReducedState(*(self.record.end(f"{name}0") for name in ReducedState._fields))

    @cached_property
    def energy(self) -> NDArray[Any]:
        """Return the energy at `t`, J, shape (m,), formed from the states."""
        pair, number = self.scene.pair, self.arithmetic.number
        with self.arithmetic.context():
            x1, v1, _, v2 = self.y
            return (x1 * x1 * number(pair.a2) + v1 * v1 * number(pair.m1) + v2 * v2 * number(pair.m2)) / number(2)

    @property
    def t_events(self) -> tuple[NDArray[Any], ...]:
        """Return the event times by kind, in the order of EventKind (entry, exit, crossing), each of shape (k,)."""
        return self._by_kind(self.event_times)

    @property
    def y_events(self) -> tuple[NDArray[Any], ...]:
        """Return the event states by kind, each of shape (k, 4)."""
        return self._by_kind(self.event_states.T)

    def _by_kind(self, events: NDArray[Any]) -> tuple[NDArray[Any], ...]:
        order = self._table[1]
        entries, exits, ordered = order[0], order[1], events[order[2:]]
        return ordered[:entries], ordered[entries:exits], ordered[exits:]

    @cached_property
    def segments(self) -> Sequence[Segment]:
        """Return the segments, each made when it is looked at."""
        return Deferred(partial(segment_of, self), len(self.record) + self.reached)

    @cached_property
    def events(self) -> Sequence[Event]:
        """Return the events, each made when it is looked at."""
        return Deferred(partial(event_of, self), len(self.record))

    @cached_property
    def ledger(self) -> EnergyLedger:
        """Return the energy ledger of the whole run."""
        with self.arithmetic.context():
            losses = [segment.losses(segment.length) for segment in self.segments]
            zero, unit = self.arithmetic.number(0), self.units[2]
            friction, viscous = (unit * sum((one[k] for one in losses), zero) for k in (0, 1))
            initial, final = self.arithmetic.number(self.scene.energy), self.final_energy
            return EnergyLedger(initial, final, friction, viscous, initial - final - friction - viscous)

    @cached_property
    def _dense(self) -> Any:
        return Dense(self)

    def sol(self, t: Any, side: Side = "right") -> NDArray[Any]:
        """Return (x1, v1, x2, v2) at the time(s) t (s): shape (4,) for a number, (4, n) for a sequence.

        t is exact (int, Fraction, decimal text, or a float taken as its binary value) or a number of the arithmetic,
        such as the time of an event; `side` says which segment answers at an event, where the state is continuous but
        the accelerations jump. Enclosures for balls: where the segment is not decided, both answer. Raises ValueError
        outside [0, end].
        """
        with self.arithmetic.context():
            if np.ndim(t) == 0:
                return self._array(self._in_si(self._dense.state(t, side)))
            columns = [self._in_si(self._dense.state(one, side)) for one in t]
            return self._array(columns).reshape(-1, 4).T

    def reduced(self, t: Any, side: Side = "right") -> ReducedState:
        """Return the reduced state at time t (s); as `sol`."""
        with self.arithmetic.context():
            return self._dense.state(t, side)

    def mode_at(self, t: Any, side: Side = "right") -> Any:
        """Return the mode at time t (s), an object array for a sequence; at an event that on the given side."""
        with self.arithmetic.context():
            if np.ndim(t) == 0:
                return self._dense.mode(t, side)
            found = np.empty(len(t), dtype=object)
            found[:] = [self._dense.mode(one, side) for one in t]
            return found

    def plot(self, kind: Kind = "velocities", ax: Any = None) -> Any:
        """Draw into matplotlib axes (new ones, if none are given) and return them; stick phases are shaded."""
        from numerics.trajectory.figures import draw

        return draw(self, kind, ax)

    def to_dataframe(self) -> Any:
        """Return t, mode, x1, v1, x2, v2 and energy at start, events and end as a pandas DataFrame."""
        from numerics.trajectory.export import dataframe

        return dataframe(self)

    def _array(self, values: Any) -> NDArray[Any]:
        return np.array(values, dtype=float if self.arithmetic.name == "float64" else object)
