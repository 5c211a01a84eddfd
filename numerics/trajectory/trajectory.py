"""The result of solving a scene: exact segments joined by events. Nothing is sampled until somebody asks."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.by_name import arithmetic_named
from numerics.arithmetic.float64 import FLOAT64
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.arithmetic.telling import compiles_now
from numerics.motion.begin import Begun, begin
from numerics.motion.codes import EVENT_LIMIT, STICK, STUCK
from numerics.motion.damped import Start as DampedStart
from numerics.motion.frame import Frame
from numerics.motion.modes import EventKind, Mode, event_kind, mode_of_sign
from numerics.motion.records import ReducedState
from numerics.motion.tellings import motion_telling
from numerics.motion.undamped import Start
from numerics.scene import Scene
from numerics.trajectory.deferred import Deferred
from numerics.trajectory.dense import Dense, Side
from numerics.trajectory.digits import Accuracy, bounds_in_si
from numerics.trajectory.pickled import plain, restored
from numerics.trajectory.record import Record
from numerics.trajectory.segment import EnergyLedger, Event, Segment
from numerics.trajectory.si_table import CROSSING, ENTRY, EXIT, si_table
from numerics.trajectory.status import Status

_MODES = {-1.0: Mode.SLIP_MINUS, 0.0: Mode.STICK, 1.0: Mode.SLIP_PLUS}
Kind = Literal["velocities", "positions", "phase", "excess", "energy"]


class Trajectory:
    """A solved scene, in the words of SciPy's solution objects and with the physics beside them.

    Rows of `y` are x1, v1 (m, m/s) and x2, v2; columns belong to `t` (s): start, events, end; with t_eval, those times
    instead. With float64 they are float arrays, otherwise object arrays of the arithmetic's numbers (enclosures for
    balls). Everything is made when it is looked at. Two trajectories are equal if every number is.
    """

    def __init__(
        self,
        scene: Scene,
        arithmetic: Arithmetic,
        record: Record,
        *,
        bounded: bool,
        digits: int | None = None,
        tried: str = "",
        t_eval: Any = None,
    ) -> None:
        """Keep what a run wrote. `bounded`: it carried error bounds; `digits`: right digits that were asked for and

        reached; `tried`: why the arithmetic was chosen, where `solve` chose it.
        """
        self.scene, self.arithmetic, self.record = scene, arithmetic, record
        self.bounded, self.digits, self.tried, self.t_eval = bounded, digits, tried, t_eval

    def but(self, **changed: Any) -> Trajectory:
        """Return the same trajectory with other `digits`, `tried` or `t_eval`."""
        kept = {name: getattr(self, name) for name in ("bounded", "digits", "tried", "t_eval")}
        return Trajectory(self.scene, self.arithmetic, self.record, **(kept | changed))

    @property
    def certain(self) -> bool:
        """Return whether the error bounds leave no doubt about the sequence of events; without bounds True."""
        return not self.bounded or self.record.end_code("certain") == 1.0

    @property
    def reached(self) -> bool:
        """Return whether the run got to its horizon."""
        return self.record.end_code("how") != EVENT_LIMIT

    @property
    def status(self) -> Status:
        """Return how the solve ended."""
        if not self.reached:
            return Status.EVENT_LIMIT
        if not self.certain:
            return Status.SEQUENCE_OPEN
        return Status.STUCK_FOR_EVER if self.record.end_code("how") == STUCK else Status.REACHED_HORIZON

    @property
    def success(self) -> bool:
        """Return whether the horizon was reached, by events that are certain."""
        return self.status.success

    @property
    def message(self) -> str:
        """Return the sentence that says how the solve ended, and whether the phase was lost on the way to the end."""
        if not self.phase_lost:
            return self.status.sentence
        return (
            f"{self.status.sentence}; {self.arithmetic.digits} digits keep no phase over the last segment: at the end "
            'the mode and the energy are known, x1, v1, x2 and v2 are not; use arithmetic="ball"'
        )

    @property
    def phase_lost(self) -> bool:
        """Return whether the last segment turns through more radians than a point arithmetic has digits for."""
        if self.arithmetic.name == "ball":
            return False
        number, length = self.arithmetic.to_float, self.record.end("length")
        if length <= 10 ** (self.arithmetic.digits - 3):
            return False
        # e^(-zeta length) is no rounding yet
        return bool(number(self.frame.two_zeta * length) < 5 * self.arithmetic.digits)

    @cached_property
    def units(self) -> tuple[Number, Number, Number]:
        """Return L (m), Omega (1/s) and E_cr (J)."""
        end = self.record.end
        return end("length_unit"), end("rate"), end("energy_unit")

    @cached_property
    def frame(self) -> Frame:
        """Return the constants of the pair, between SI units and reduced coordinates."""
        with self.arithmetic.context():
            return Frame(self.arithmetic, self.scene.pair)

    @cached_property
    def _begun(self) -> Begun:
        with self.arithmetic.context():
            return begin(self.scene, self.arithmetic)

    @cached_property
    def _signs(self) -> list[float]:
        """Return the sign of v1 - v2 in every segment, and in the motion after the last event."""
        return [self.record.end_code("first_mode"), *self.record.codes("mode").tolist()]

    @cached_property
    def modes(self) -> tuple[Mode, ...]:
        """Return the itinerary: the mode of every segment."""
        return tuple(map(_MODES.__getitem__, self._signs if self.reached else self._signs[:-1]))

    @property
    def event_kinds(self) -> tuple[EventKind, ...]:
        """Return the kinds of the events in their order."""
        modes = [_MODES[sign] for sign in self._signs]
        return tuple(map(event_kind, modes, modes[1:]))

    @property
    def final_mode(self) -> Mode:
        """Return the mode at the end: after the last event, where the cap on events ended the run."""
        return _MODES[self.record.end_code("mode")]

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
        """Return t, x1, v1, x2, v2 at start, events and, if it was reached, horizon, shape (5, m); kinds of events."""
        count, floats = len(self.record), self.arithmetic.name == "float64"
        table = np.empty((5, count + 1 + self.reached), dtype=float if floats else object)
        kinds = np.empty(count, dtype=np.int64)
        if floats:
            (FLOAT64.compiled if compiles_now() else FLOAT64)(si_table)(*self.record.in_numbers(), table, kinds)
        else:
            with self.arithmetic.context():
                si_table(*self.record.in_numbers(), table, kinds)
        return table, kinds

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
        times, kinds = self.event_times, self._table[1]
        return times[kinds == ENTRY], times[kinds == EXIT], times[kinds == CROSSING]

    @property
    def y_events(self) -> tuple[NDArray[Any], ...]:
        """Return the event states by kind, each of shape (k, 4)."""
        states, kinds = self.event_states.T, self._table[1]
        return states[kinds == ENTRY], states[kinds == EXIT], states[kinds == CROSSING]

    @cached_property
    def segments(self) -> Sequence[Segment]:
        """Return the segments, each made when it is looked at."""
        return Deferred(self._segment, len(self.record) + self.reached)

    @cached_property
    def events(self) -> Sequence[Event]:
        """Return the events, each made when it is looked at."""
        return Deferred(self._event, len(self.record))

    def _segment(self, index: int) -> Segment:
        """Return a segment; the last one, after all events, ends at the horizon."""
        number, with_end = self.record.number, index < len(self.record)
        start = number(index - 1, "tau") if index else self.arithmetic.number(0)
        end = number(index, "tau") if with_end else self.record.end("tau")
        length = number(index, "length") if with_end else self.record.end("length")
        mode = mode_of_sign(self._signs[index])
        telling = motion_telling(self.arithmetic.telling, is_damped=self.scene.pair.a1 > 0)
        return Segment(mode, start, end, length, self._begun.pair, self._motion(index), telling)

    def _motion(self, index: int) -> Any:
        """Return the start of a motion: the first, or the one that event index - 1 starts."""
        if index == 0:
            return self._begun.start
        names = ("X", "V", "Z", "w", "tau", "gap", "push")
        X, V, Z, w, tau, gap, push = (self.record.number(index - 1, name) for name in names)
        zero, kind, side = self.arithmetic.number(0), *(self.record.code(index - 1, name) for name in ("kind", "side"))
        if self.scene.pair.a1 > 0:
            return DampedStart(int(kind), X, V, V, Z, w, True, False, tau, zero, zero, zero)
        driven = zero if kind == STICK else push
        return Start(int(kind), side, X, zero, gap, push, driven, True, Z, w, tau, zero, zero)

    def _event(self, index: int) -> Event:
        """Return an event."""
        before, after = (_MODES[sign] for sign in self._signs[index : index + 2])
        X, V, Z, w = (self.record.number(index, name) for name in ("X", "V", "Z", "w"))
        t, reduced = self.event_times[index], ReducedState(X, V, V, Z, w)
        y = tuple(self.event_states[:, index])
        if self.arithmetic.name == "float64":
            t, y = float(t), tuple(map(float, y))
        return Event(t, event_kind(before, after), before, after, y, reduced)

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
    def accuracy(self) -> Accuracy | None:
        """Return the error bounds of a float64 or double-double trajectory, else None (balls carry their own)."""
        return bounds_in_si(self) if self.bounded else None

    @cached_property
    def _dense(self) -> Dense:
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
        """Return the mode at time t (s), an object array of modes for a sequence; at an event that on the given side."""
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

    def __eq__(self, other: object) -> bool:
        """Return whether another trajectory answers the same scene with the same numbers."""
        return isinstance(other, Trajectory) and self.__getstate__() == other.__getstate__()

    __hash__ = None  # type: ignore[assignment]

    def __getstate__(self) -> tuple[Any, ...]:
        """Return what is pickled: the scene and what the run wrote, without what was made of it since."""
        record = plain(self.record.rows), plain(self.record.end_row), self.record.width
        arithmetic = self.arithmetic.name, self.arithmetic.digits
        return self.scene, arithmetic, record, self.bounded, self.digits, self.tried

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Restore a pickled trajectory."""
        scene, (name, digits), (rows, end, width), bounded, asked, tried = state
        arithmetic = arithmetic_named(name, digits)
        if name in {"float64", "double-double"}:
            rows, end = np.array(rows, dtype=float).reshape(len(rows), -1), np.array(end)
        record = Record(restored(rows), restored(end), width) if isinstance(rows, tuple) else Record(rows, end, width)
        self.__init__(scene, arithmetic, record, bounded=bounded, digits=asked, tried=tried)  # type: ignore[misc]

    def __repr__(self) -> str:
        """Return a short summary, as SciPy's solutions have."""
        events, digits = len(self.record), self.arithmetic.digits
        accuracy = self.accuracy
        right = self.digits or (digits if accuracy is None else accuracy.digits)
        return (
            f"     message: {self.message}\n     success: {self.success}\n      status: {int(self.status)}\n"
            f"  arithmetic: {self.arithmetic.name}, {right} right digits\n      events: {events}\n"
            f"           t: [0, {self.arithmetic.text(self.end_time)}] s\n  final mode: {self.final_mode.value}"
        )

    def _repr_html_(self) -> str:
        """Return the same as a small table, for notebooks."""
        rows = (line.split(":", 1) for line in repr(self).splitlines())
        cells = "".join(f"<tr><th>{name.strip()}</th><td>{value.strip()}</td></tr>" for name, value in rows)
        return f"<table>{cells}</table>"
