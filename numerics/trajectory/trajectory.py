"""The result of solving a scene: segments joined by events. Nothing is sampled, or made, until somebody asks."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from flint import arb

from numerics.arithmetic.by_name import arithmetic_named
from numerics.arithmetic.precision import cached_property
from numerics.arithmetic.protocol import Number
from numerics.linear.errors_of import JUDGED
from numerics.linear.modes import MODES, Mode
from numerics.linear.record import How, Knot, Record
from numerics.trajectory.columns import Array, Counts
from numerics.trajectory.comparison import Check
from numerics.trajectory.digits import FEW_DIGITS, ROUNDING, Accuracy, Judged, accuracy_of, judged
from numerics.trajectory.events import EnergyLedger, Event, Segment, energy_of, ledger_of
from numerics.trajectory.in_units import Reduced
from numerics.trajectory.rendering import MOST_DIGITS
from numerics.trajectory.rows import RecordedRun
from numerics.trajectory.saved import plain
from numerics.trajectory.status import Status

if TYPE_CHECKING:
    from numerics.scene.decimals import Quantity


class Trajectory(RecordedRun):
    """A solved scene, with the attribute names of SciPy's solution objects, and modes, events and energies.

    Rows of `y` are x1, v1 (m, m/s) and x2, v2; columns belong to `t` (s): start, events, end; with t_eval, those times
    instead. With float64 they are float arrays, otherwise object arrays of the arithmetic's numbers (enclosures for
    balls). Two trajectories are equal if every number is.

    Status, events (k of them, m = k + 2 columns), evaluation at any time, error bounds, and energy (J):

    >>> from numerics import Pair, Scene, State, solve
    >>> run = solve(Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(v1="0.15"), until=5))
    >>> run.success, run.status.name, run.message, run.reached, run.tried
    (True, 'REACHED_HORIZON', 'reached the horizon', True, '')
    >>> run.t.shape, run.y.shape, run.energy.shape, run.event_times.shape, run.event_states.shape
    ((34,), (4, 34), (34,), (32,), (4, 32))
    >>> run.events[0].kind.value, run.event_kinds[1].value, run.modes[0].value, run.final_mode.value
    ('crossing', 'entry', 'slip+', 'stick')
    >>> run.segments[0]
    Segment(mode='slip+', start=0, end=0.0768788, length=0.0768788)
    >>> [len(one) for one in run.t_events], [one.shape for one in run.y_events]  # entries, exits, crossings
    ([16, 15, 1], [(16, 4), (15, 4), (1, 4)])
    >>> run.sol([[0.5, 1.0], [1.5, 2.0]]).shape, run.mode_at(0.5).value
    ((4, 2, 2), 'slip+')
    >>> run.arithmetic.name, run.right_digits == run.accuracy.digits, run.without_digits, run.certain
    ('float64', True, (), True)
    >>> run.check().right  # what its numbers are really off by is within its bounds
    True
    >>> solve(run.scene, digits=20).digits, solve(run.scene, t_eval=[0, 1]).t_eval
    (20, [0, 1])
    >>> round(run.dissipated, 9), round(run.final_energy, 9), abs(run.ledger.residual) < 1e-15
    (0.00868247, 0.00256753, True)
    >>> run.end_time, [round(one, 6) for one in run.final_state]
    (5.0, [0.002483, 0.044169, 0.001745, 0.044169])
    >>> run.has_critical_energy, run.has_frame
    (True, True)
    >>> [round(one, 6) for one in run.units]  # L (m), Omega (1/s) and E_cr (J) of reduced coordinates
    [0.005, 10.0, 0.0025]
    >>> round(run.reduced.final.w, 6), float(run.reduced.initial.X), run.energy_excess.shape, float(run.initial.v1)
    (0.027012, 0.0, (34,), 0.15)
    >>> run.final == run.final_state, run["t"].shape, run["x1"].shape
    (True, (34,), (34,))

    Tables, and a file from which it is restored to the last bit:

    >>> run.to_csv()[:22], len(run.to_dataframe())
    ('from,to,t (s),x1 (m),v', 34)
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     run.save(f"{folder}/run.npz")
    ...     Trajectory.load(f"{folder}/run.npz") == run
    True
    """

    FORMAT = "inertial-pair trajectory 6"
    ENERGIES = ("energy", "energy_excess")
    _PICTURES = "numerics.trajectory.figures"

    # ------------------------------------------------------------------ how it ended
    @property
    def status(self) -> Status:  # type: ignore[override]
        """Return how the solve ended."""
        if not self.reached:
            return Status.EVENT_LIMIT
        if not self.certain:
            return Status.SEQUENCE_OPEN
        if self.digits is None and self.without_digits:
            return Status.NO_RIGHT_DIGIT
        is_stuck = self.record.how == How.STUCK and not self.scene.changes_later
        return Status.STUCK_FOR_EVER if is_stuck else Status.REACHED_HORIZON

    @property
    def message(self) -> str:
        """Return the sentence that says how the solve ended, of what no digit is right, whether the phase was lost."""
        said = super().message.replace("a quantity", " and ".join(self.without_digits))
        if 0 < self.right_digits <= FEW_DIGITS and any(float(one) for one in self.y[1::2].ravel()):
            least = " and ".join(self._with_digits(self.right_digits))
            said += f"; right digits of the {least}: only {self.right_digits}; request digits"
        if self.bounded or self._is_ball:
            return said
        with self.context():  # in mpmath, which solves free pairs alone, nothing else tells
            is_lost = self.frame.rate * self.row_column("length")[-1] > 10 ** (self.arithmetic.digits - 3)
        lost = "keep no phase over the last segment: at the end x1, v1, x2 and v2 are not known; use ball arithmetic"
        return f"{said}; {self.arithmetic.digits} digits {lost}" if is_lost else said

    @cached_property
    def accuracy(self) -> Accuracy | None:
        """Return bounds on the errors: those of float64, or the radii of balls; None in mpmath, which has neither."""
        return accuracy_of(self, self._judged) if self.bounded or self._is_ball else None

    @cached_property
    def _judged(self) -> Judged:
        return judged(self)

    @property
    def right_digits(self) -> int:
        """Return how many digits its error bounds or balls leave right (digits.py); 0 without either."""
        most = MOST_DIGITS if self.bounded else self.arithmetic.digits
        return min(most, *self._judged.right) if self.certain and self._judged.right else 0

    @property
    def without_digits(self) -> tuple[str, ...]:
        """Return the quantities of which no digit is right: an error bound, or a radius, is as large as they are."""
        return self._with_digits(0) if 0 in self._judged.right else ()

    def _with_digits(self, most: int) -> tuple[str, ...]:
        return tuple(name for name, right in zip(JUDGED, self._judged.right, strict=False) if right <= most)

    # ------------------------------------------------------------------ events and segments
    @property
    def signs(self) -> list[int]:
        """Return the sign of v1 - v2 in every segment, and in the motion after the last event."""
        signs: list[int] = self.row_signs[self._starts].tolist()
        return signs

    @cached_property
    def _all_modes(self) -> tuple[Mode, ...]:  # type: ignore[override]
        return tuple(map(MODES.__getitem__, self.signs))

    @cached_property
    def events(self) -> tuple[Event, ...]:  # type: ignore[override]
        """Return the events."""
        rows, modes = self.event_rows, self._all_modes
        causes = ["jump" if jump else "guard" for jump in self.row_column("jump")[rows]]
        reduced = [self.reduced.row(self.row_states[:, k], k) if self.has_frame else None for k in rows]
        y = map(tuple, self.event_states.T.tolist())
        return tuple(map(Event, self.event_times.tolist(), self.event_kinds, modes, modes[1:], y, reduced, causes))

    @cached_property
    def segments(self) -> tuple[Segment, ...]:
        """Return the segments."""
        first = [*self._starts.tolist(), *([len(self.record.rows)] if self.reached else [])]
        t, lengths, found = [*self.row_times[self._starts].tolist(), self.end_time], self.row_lengths, []
        with self.context():
            for k, (mode, start, after) in enumerate(zip(self.modes, first, first[1:], strict=False)):
                length = sum(lengths[start + 1 : after], lengths[start])
                found.append(Segment(mode, t[k], t[k + 1], length, range(start, after), self))
        return tuple(found)

    # ------------------------------------------------------------------ at t
    def _energies(self, t: Array, y: Array, rows: Counts | None) -> Array:
        return energy_of(self, t, y, rows)

    @cached_property
    def energy_excess(self) -> Array:
        """Return E/E_cr - 1 at `t`, shape (m,), accurate in itself; nan where there is no E_cr."""
        with self.context():
            if not self.has_critical_energy:
                return np.full(self.t.shape, math.nan if self.bounded else arb("nan"))
            formed = self.energy / self._critical - 1
            if self.row_excess is None:
                return np.asarray(formed)
            if self.t_eval is not None:
                return np.array([self.row_excess_at(one, "right") for one in self.t], dtype=object)
            return self.row_excess[self._own_rows]

    def end_numbers(self) -> tuple[Number, ...]:
        """Return x1, v1, x2, v2, energy and, where there is E_cr, excess at the end."""
        found = super().end_numbers()
        if not self.has_critical_energy:
            return found
        with self.context():
            return *found, found[-1] / self._critical - 1 if self.row_excess is None else self.row_excess[-1]

    def end_bounds(self) -> tuple[float, ...]:
        """Return bounds on the errors of time, state, energy and excess at the end, of numbers that have them."""
        found, late = accuracy_of(self, self._judged), abs(float(self.end_time)) * 4 * ROUNDING
        late += 0.0 if self.reached else float(found.t[-1])
        return late, *found.final, found.energy, found.energy_excess

    # ------------------------------------------------------------------ reduced coordinates
    @property
    def units(self) -> tuple[Number, Number, Number]:
        """Return L (m), Omega (1/s) and E_cr (J)."""
        return self.frame.length, self.frame.rate, self.frame.critical_energy

    @property
    def reduced(self) -> Reduced:
        """Return the run in reduced coordinates: `.initial`, `.final`, and called with a time, as `sol`."""
        return Reduced(self)

    # ------------------------------------------------------------------ where the energy went
    @property
    def dissipated(self) -> Quantity:
        """Return what friction and viscosity took, J."""
        with self.context():
            return self.ledger.friction + self.ledger.viscous

    @cached_property
    def ledger(self) -> EnergyLedger:
        """Return the energy ledger of the whole run, with the works of forces, belt and wall."""
        with self.context():
            return ledger_of(self)

    # ------------------------------------------------------------------ text and files
    def check(self) -> Check:
        """Return what every number of the run is really off by: `numerics.check` solves its scene again, in balls."""
        import numerics

        return numerics.check(self)

    def kept(self) -> dict[str, Any]:
        """Return what the run wrote, as what JSON holds."""
        return {"record": plain(self.record)}

    @classmethod
    def restored(cls, scene: Any, header: dict[str, Any]) -> Self:
        """Return the trajectory of a scene with what its run wrote."""
        rows, end, how, *rest = header["record"]
        if not isinstance(rows, np.ndarray):
            *rows, end = (Knot(*one) for one in (*rows, end))
        return cls(scene, arithmetic_named(*header["arithmetic"]), Record(rows, end, How(how), *rest))
