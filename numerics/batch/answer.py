"""The answers of a batch: arrays in the shape of its inputs, each made when it is looked at."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.float64 import UNIT
from numerics.motion.codes import EVENT_LIMIT, OUT_OF_RANGE
from numerics.trajectory.record import CODES, END_CODES, END_NUMBERS, NUMBERS
from numerics.trajectory.status import Status

Table = NDArray[np.float64]
_TINY = 2.0**-1060
"""More than products with SI units can lose below the normal numbers."""


class Batch:
    """The ends of many runs; every array has the broadcast shape of the inputs, `y` and `y_error` (4, ...) in front.

    status         a Status                       events    how many there were
    mode           -1, 0, +1: sign of v1 - v2     t         s, the horizon or the last event
    y              x1, v1, x2, v2 (m, m/s)        energy_excess   E/E_cr - 1, accurate in itself
    dissipated     J, the sum of what friction and viscosity took in every mode, which never cancels
    *_error        bounds on the errors of these  digits    right digits of every event and of the end, by the bounds
    certain        whether no bound reaches as far as another sequence of events
    event_t, event_y, event_mode   the first `keep_events` events: (..., k), (4, ..., k), (..., k); nan and 0 beyond
    event_t_error, event_y_error   bounds on their errors
    """

    def __init__(self, ends: Table, kept: Table, shape: tuple[int, ...]) -> None:
        """Keep what the runs wrote: a row for each end, and its first events (trajectory/record.py)."""
        self.ends, self.kept, self.shape = ends, kept, shape

    def __len__(self) -> int:
        """Return how many scenes there were."""
        return len(self.ends)

    def __repr__(self) -> str:
        """Return a short summary."""
        ends = ", ".join(f"{np.sum(self.status == one)} {one.name}" for one in Status if np.any(self.status == one))
        return f"Batch of {len(self)} scenes, shape {self.shape}: {ends}; {int(np.sum(self.events))} events"

    def _end(self, name: str) -> Table:
        return self.ends[:, END_CODES.index(name)].reshape(self.shape)

    def _number(self, name: str) -> Table:
        column = len(END_CODES) + END_NUMBERS.index(name)
        return np.where(self._gone, np.nan, self.ends[:, column].reshape(self.shape))

    @cached_property
    def _gone(self) -> NDArray[np.bool_]:
        return self._end("how") == OUT_OF_RANGE

    @cached_property
    def status(self) -> NDArray[np.int64]:
        """Return how each run ended, a Status."""
        how = self._end("how").astype(np.int64)
        return np.where((how < EVENT_LIMIT) & ~self.certain, int(Status.SEQUENCE_OPEN), how)

    @property
    def success(self) -> NDArray[np.bool_]:
        """Return which runs got to their horizon, by events that are certain."""
        return (self.status == Status.REACHED_HORIZON) | (self.status == Status.STUCK_FOR_EVER)

    @cached_property
    def events(self) -> NDArray[np.int64]:
        """Return how many events each run had."""
        return np.where(self._gone, 0, self._end("events")).astype(np.int64)

    @cached_property
    def mode(self) -> NDArray[np.int64]:
        """Return the sign of v1 - v2 at the end."""
        return np.where(self._gone, 0, self._end("mode")).astype(np.int64)

    @cached_property
    def certain(self) -> NDArray[np.bool_]:
        """Return whether no bound reaches as far as another sequence of events."""
        return (self._end("certain") == 1.0) & ~self._gone

    @cached_property
    def digits(self) -> NDArray[np.int64]:
        """Return the right digits of every event, and of state, excess and energy at the end."""
        return np.where(self.certain, self._end("digits"), 0).astype(np.int64)

    @property
    def energy_excess(self) -> Table:
        """Return E/E_cr - 1 at the end."""
        return self._number("w")

    @property
    def energy_excess_error(self) -> Table:
        """Return a bound on its error."""
        return self._end("w_error")

    @cached_property
    def _units(self) -> tuple[Table, Table, Table]:
        length, rate, energy = (self._number(name) for name in ("length_unit", "rate", "energy_unit"))
        return length, length * rate, energy

    @cached_property
    def t(self) -> Table:
        """Return the time at the end, s."""
        return self._number("tau") / self._number("rate")

    @cached_property
    def y(self) -> Table:
        """Return x1, v1, x2, v2 at the end."""
        (length, speed, _), X, Z = self._units, self._number("X"), self._number("Z")
        return np.stack([length * X, speed * self._number("V1"), length * (X - Z), speed * self._number("V2")])

    @cached_property
    def y_error(self) -> Table:
        """Return bounds on the errors of y."""
        (length, speed, _), x, place = self._units, self._end("x_error"), self._end("place_error")
        v1, v2 = speed * self._end("v1_error"), speed * self._end("v2_error")
        error = np.stack([length * x, v1, length * (x + place), v2]) + 8 * UNIT * abs(self.y)
        # what decays may be below every number and not be zero; only viscosity has an error of what it took
        faded = np.where(self._end("damped_error") > 0, _TINY + 2.0**-1070 * (length + speed), 0.0)
        return error + faded + np.where((abs(self.y) < 1e-290) & (self.y != 0), _TINY, 0.0)

    @cached_property
    def dissipated(self) -> Table:
        """Return what friction and viscosity took, J."""
        return self._units[2] * (self._number("spent") + self._number("damped"))

    @cached_property
    def dissipated_error(self) -> Table:
        """Return a bound on its error."""
        error = self._units[2] * (self._end("spent_error") + self._end("damped_error")) + 8 * UNIT * self.dissipated
        return error + np.where((self.dissipated < 1e-290) & (self.dissipated > 0), _TINY, 0.0)

    def _event(self, name: str) -> Any:
        column = CODES.index(name) if name in CODES else len(CODES) + NUMBERS.index(name)
        return self.kept[:, :, column].reshape(*self.shape, self.kept.shape[1])

    @cached_property
    def event_t(self) -> Table:
        """Return the times of the first events, s."""
        return self._event("tau") / self._number("rate")[..., None]

    @cached_property
    def event_y(self) -> Table:
        """Return x1, v1, x2, v2 at the first events."""
        length, speed = (unit[..., None] for unit in self._units[:2])
        X, v = self._event("X"), speed * self._event("V")
        return np.stack([length * X, v, length * (X - self._event("Z")), v])

    @cached_property
    def event_mode(self) -> NDArray[np.int64]:
        """Return the sign of v1 - v2 after the first events."""
        return np.nan_to_num(self._event("mode")).astype(np.int64)

    @cached_property
    def event_t_error(self) -> Table:
        """Return bounds on the errors of event_t."""
        return self._event("late") / self._number("rate")[..., None] + 8 * UNIT * self.event_t

    @cached_property
    def event_y_error(self) -> Table:
        """Return bounds on the errors of event_y."""
        length, speed = (unit[..., None] for unit in self._units[:2])
        x, v = self._event("x"), speed * self._event("v")
        return np.stack([length * x, v, length * (x + self._event("place")), v]) + 8 * UNIT * abs(self.event_y)
