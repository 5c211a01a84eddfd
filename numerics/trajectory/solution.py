"""Results of a run: events, segments, any time, error bounds and ledger; each computed on first access."""

from __future__ import annotations

from typing import Any

import numpy as np

from numerics.arithmetic.precision import cached_property
from numerics.arithmetic.protocol import Number
from numerics.free.frame import ReducedState
from numerics.linear.modes import MODES, EventKind, Mode, event_kind
from numerics.linear.record import How
from numerics.trajectory.columns import Array
from numerics.trajectory.digits import ROUNDING, Accuracy, Judged, accuracy_of, judged, judged_balls
from numerics.trajectory.events import EnergyLedger, Event, Segment, ledger_of
from numerics.trajectory.rows import Rows, Side
from numerics.trajectory.status import Status


class Solution(Rows):
    """A run with the attribute names of SciPy's solution objects (trajectory.py)."""

    def look_up_times(self) -> None:
        """Raise ValueError for times in t_eval that are outside the run."""
        if self.t_eval is not None:
            with self.context():
                self._asked_times = self._times(self.t_eval)

    @property
    def status(self) -> Status:  # type: ignore[override]
        """Return how the solve ended."""
        if not self.reached:
            return Status.EVENT_LIMIT
        if not self.certain:
            return Status.SEQUENCE_OPEN
        if self.without_digits:
            return Status.NO_RIGHT_DIGIT
        is_stuck = self.record.how == How.STUCK and not self.scene.changes_later
        return Status.STUCK_FOR_EVER if is_stuck else Status.REACHED_HORIZON

    @property
    def message(self) -> str:
        """Return the sentence that says how the solve ended, of what no digit is right, whether the phase was lost."""
        if self.status is Status.EVENT_LIMIT and not (self.scene.is_forced or self.scene.pair.a1):
            return super().message.replace("shorten until", "use `inertial-pair energy` for a late time")
        said = super().message.replace("a quantity", " and ".join(self.without_digits))
        if not self.phase_lost:
            return said
        return (
            f"{said}; {self.arithmetic.digits} digits keep no phase over the last segment: at the end the mode and the "
            "energy are known, x1, v1, x2 and v2 are not; use ball arithmetic"
        )

    @property
    def phase_lost(self) -> bool:
        """Whether the last segment of a free motion is too long for the digits of its phase; always False for balls."""
        if self._is_ball or self.scene.is_forced:
            return False
        with self.context():
            angle = self.frame.rate * self.row_end("length")[0]
            # what has decayed is no rounding yet
            damped = self.arithmetic.to_float(self.frame.two_zeta * angle)
        return bool(angle > 10 ** (self.arithmetic.digits - 3) and damped < 5 * self.arithmetic.digits)

    @cached_property
    def accuracy(self) -> Accuracy | None:
        """Return the error bounds of a float64 trajectory, else None (balls carry their own)."""
        return accuracy_of(self, self._judged) if self.bounded else None

    @cached_property
    def _judged(self) -> Judged:
        return judged(self)

    @cached_property
    def _known(self) -> tuple[int, tuple[str, ...]]:
        if self.bounded:
            return self._judged.digits, self._judged.without
        return judged_balls(self) if self._is_ball else (0, ())

    @property
    def right_digits(self) -> int:
        """Return how many digits its error bounds or balls leave right (digits.py); 0 without either."""
        return self._known[0]

    @property
    def without_digits(self) -> tuple[str, ...]:
        """Return the quantities of which no digit is right: an error bound, or a radius, is as large as they are."""
        return self._known[1]

    @cached_property
    def modes(self) -> tuple[Mode, ...]:
        """Return the itinerary: the mode of every segment."""
        return self._all_modes[: self.record.events + self.reached]

    @property
    def _all_modes(self) -> tuple[Mode, ...]:
        """Return the modes, with that after the last event, where the cap on events ended the run."""
        return tuple(map(MODES.__getitem__, self.signs))

    @property
    def event_kinds(self) -> tuple[EventKind, ...]:
        """Return the kinds of the events in their order."""
        modes = self._all_modes
        return tuple(map(event_kind, modes, modes[1:]))

    @property
    def t(self) -> Array:
        """Return the times of start, events and end, or t_eval, s, shape (m,)."""
        return self._table[1][0] if self.t_eval is None else self._asked_times

    @property
    def y(self) -> Array:
        """Return the states at `t`, shape (4, m)."""
        return self._table[1][1:] if self.t_eval is None else self._asked_states

    @cached_property
    def _asked_states(self) -> Array:
        return self.sol(self.t_eval)

    @property
    def t_events(self) -> tuple[Array, ...]:
        """Return the event times by kind, in the order of EventKind (entry, exit, crossing), each of shape (k,)."""
        return self._by_kind(self.event_times)

    @property
    def y_events(self) -> tuple[Array, ...]:
        """Return the event states by kind, each of shape (k, 4)."""
        return self._by_kind(self.event_states.T)

    def _by_kind(self, events: Array) -> tuple[Array, ...]:
        sticks = self.row_signs[self._table[0]] == 0
        before, after = sticks[:-1], sticks[1:]
        return events[after], events[before], events[~(before | after)]

    @cached_property
    def energy(self) -> Array:
        """Return the energy at `t`, J, shape (m,), formed from the states."""
        with self.context():
            return np.asarray(self.scene.pair.energy(self.y, self.arithmetic.number))

    @cached_property
    def energy_excess(self) -> Array:
        """Return E/E_cr - 1 at `t`, shape (m,), accurate in itself."""
        if self.t_eval is not None:
            return np.array([self.reduced(one).w for one in self.t], dtype=object)
        end = [self.final.w] if self.reached else []
        return np.array([self.initial.w, *(event.reduced.w for event in self.events), *end], dtype=object)

    def end_numbers(self) -> tuple[Number, ...]:
        """Return x1, v1, x2, v2, energy and excess at the end."""
        return *self.final_state, self.final_energy, self.final.w

    def end_bounds(self) -> tuple[float, ...]:
        """Return bounds on the errors of time, state, energy and excess at the end, of numbers that have them."""
        found, late = accuracy_of(self, self._judged), abs(float(self.end_time)) * 4 * ROUNDING
        late += 0.0 if self.reached else float(found.t[-1])
        return late, *found.final, found.energy, found.energy_excess

    @property
    def final(self) -> ReducedState:
        """Return the reduced state at the end: of the last event, where the cap on events ended the run."""
        with self.context():
            excess = None if self.row_excess is None else self.row_end("excess")[0]
            return self.frame.reduced(self.final_state, excess)

    @property
    def initial(self) -> ReducedState:
        """Return the reduced state at the start."""
        with self.context():
            return self.frame.reduced(self.row_states[:, 0], self.arithmetic.number(self.scene.energy_excess))

    @property
    def units(self) -> tuple[Number, Number, Number]:
        """Return L (m), Omega (1/s) and E_cr (J)."""
        return self.frame.length, self.frame.rate, self.frame.critical_energy

    @property
    def dissipated(self) -> Number:
        """Return what friction and viscosity took, J: summed by the run where it has bounds, else by the ledger."""
        with self.context():
            if self.bounded:
                return float(self.taken[:2].sum())
            return self.ledger.friction + self.ledger.viscous

    @cached_property
    def ledger(self) -> EnergyLedger:
        """Return the energy ledger of the whole run, with the work of u."""
        with self.context():
            return ledger_of(self)

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """Return the events."""
        rows, modes = self.event_rows, self._all_modes
        causes = ["jump" if jump else "guard" for jump in self.row_code("jump")[rows]]
        states, carried = self.event_states, self.row_excess
        excesses = np.full(len(rows), None) if carried is None else carried[rows]
        with self.context():
            reduced = [self.frame.reduced(*one) for one in zip(states.T.tolist(), excesses, strict=True)]
        kinds, y = self.event_kinds, map(tuple, states.T.tolist())
        return tuple(map(Event, self.event_times.tolist(), kinds, modes, modes[1:], y, reduced, causes))

    @cached_property
    def segments(self) -> tuple[Segment, ...]:
        """Return the segments."""
        first = [0, *self.event_rows.tolist(), *([len(self.record.rows)] if self.reached else [])]
        t, lengths = [*self._table[1][0].tolist(), self.end_time], self.row_lengths
        found = []
        with self.context():
            for k, (mode, start, after) in enumerate(zip(self.modes, first, first[1:], strict=False)):
                length = sum(lengths[start + 1 : after], lengths[start])
                found.append(Segment(mode, t[k], t[k + 1], length, range(start, after), self))
        return tuple(found)

    def reduced(self, t: Any, side: Side = "right") -> ReducedState:
        """Return the reduced state at time t (s), of the pair's own b; as `sol`."""
        with self.context():
            return self.frame.reduced(self.sol(t, side), self._excess(t, side))
