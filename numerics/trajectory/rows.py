"""A run as its rows, read off the record: when segments begin, in which state, where it ends; and any time between.

Which row's segment holds a time, and the motion from that row's state (flow.py).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import reduce
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb

from numerics.arithmetic.precision import cached_property
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.frame import Frame
from numerics.linear.cells import Cells, mode_in
from numerics.linear.flow import Motion
from numerics.linear.model import CONSTANT, EDGE, FIRST, FORCE, KINETIC, LOAD, add_signal
from numerics.linear.modes import Mode
from numerics.linear.pieces import ExactPiece, pieces_of, starts_of
from numerics.linear.record import AT, How, Record
from numerics.linear.system import LinearMode
from numerics.scene import Scene
from numerics.scene.decimals import require_one_of
from numerics.trajectory.answer import Answer, Side
from numerics.trajectory.columns import STATE, Array, Counts, Floats, Moment
from numerics.trajectory.flow import after, enclosed, signals_of, steps_of, taken

if TYPE_CHECKING:
    from numerics.scene.decimals import Quantity, Times

_union = np.frompyfunc(lambda one, two: one.union(two), 2, 1)


class RecordedRun(Answer[Mode]):
    """A scene, the arithmetic it was solved in, and the rows of its record, in SI units."""

    scene: Scene

    def __init__(self, scene: Scene, arithmetic: Arithmetic, record: Record) -> None:
        """Keep what a run wrote."""
        self.scene, self.arithmetic, self.record = scene, arithmetic, record
        self.bounded, self._is_ball = arithmetic.name == "float64", arithmetic.name == "ball"

    # ------------------------------------------------------------------ rows
    def row_column(self, name: str) -> Array:
        """Return a column of all rows, that of the end last: floats, or an object array."""
        if self._in_floats is not None:
            return self._in_floats[:, AT[name]]
        return np.array([getattr(one, name) for one in (*self.record.rows, self.record.end)], dtype=object)

    @cached_property
    def _in_floats(self) -> Floats | None:
        """Return the rows of a run in floats, that of the end last; None for other numbers."""
        rows, end = self.record.rows, self.record.end
        return np.concatenate([rows, end[None, : rows.shape[1]]]) if isinstance(rows, np.ndarray) else None

    @property
    def reached(self) -> bool:  # type: ignore[override]
        """Return whether the run got to its horizon."""
        return self.record.how != How.EVENT_LIMIT

    @property
    def certain(self) -> bool:
        """Return whether the error bounds leave no doubt about the sequence of events; without bounds True."""
        return bool(self.record.certain) or not self.bounded

    @property
    def pieces(self) -> Sequence[ExactPiece]:
        """Return the pieces of all signals, exact."""
        return pieces_of(self.scene)

    @cached_property
    def row_signs(self) -> Counts:
        """Return the mode that starts at each row, the sign of v1 - v2."""
        return self.row_column("mode")[:-1].astype(np.int64)

    @cached_property
    def row_pieces(self) -> Counts:
        """Return the piece in which each row is."""
        return self.row_column("piece")[:-1].astype(np.int64)

    @cached_property
    def row_times(self) -> Array:
        """Return when each row's segment begins, s."""
        local = self.row_column("local")[:-1]
        if len(self.pieces) == 1 or not self.row_pieces.any():
            return local
        if self.bounded:
            return np.asarray(starts_of(self.scene)[0, self.row_pieces] + local)
        with self.context():
            starts = np.array([self.arithmetic.number(piece.start) for piece in self.pieces], dtype=object)
            return np.asarray(starts[self.row_pieces] + local)

    @cached_property
    def _states(self) -> Array:
        if self._in_floats is not None:
            return self._in_floats[:, AT["x1"] : AT["x1"] + len(STATE)].T
        return np.array([self.row_column(name) for name in STATE])

    @property
    def row_states(self) -> Array:
        """Return x1, v1, x2, v2 at each row, shape (4, n)."""
        return self._states[:, :-1]

    @property
    def final_state(self) -> Moment:  # type: ignore[override]
        """Return (x1, v1, x2, v2) at the end, as `run.final.x1`; `final_mode` is its mode."""
        return Moment(*self._states[:, -1].tolist())

    final = final_state

    @property
    def initial(self) -> Moment:  # type: ignore[override]
        """Return (x1, v1, x2, v2) at the start."""
        return Moment(*self._states[:, 0].tolist())

    @cached_property
    def row_excess(self) -> Array | None:
        """Return E/E_cr - 1 at each row and at the end; None where a run does not carry it (free/ alone does)."""
        found = None if self.bounded else self.row_column("excess")
        return None if found is None or found[0] is None else found

    @cached_property
    def row_lengths(self) -> Array:
        """Return how long the segment of each row lasts, s."""
        after = self.row_column("length")[1:]
        return after if self.reached else after[:-1]

    @cached_property
    def _starts(self) -> Counts:
        """Return the rows at which segments start: the first one, and those at which the mode has changed."""
        begins = self.row_column("event")[:-1].astype(bool)
        begins[0] = True
        return np.flatnonzero(begins)

    @property
    def event_rows(self) -> Counts:
        """Return the rows at which the mode has changed: the events."""
        return self._starts[1:]

    @cached_property
    def _own_rows(self) -> Counts:
        """Return the rows of start and events, and -1 for the end: its segment, or what is known there."""
        return np.concatenate([self._starts, [-1]]) if self.reached else self._starts

    @cached_property
    def _own_moments(self) -> tuple[Array, Array]:
        """Return the times of start, events and end, and the states there; of a run that was cut off no end."""
        rows = self._own_rows
        times = self.row_times[rows]
        if self.reached:
            times[-1] = self.end_time
        return times, self._states[:, rows]

    @property
    def event_times(self) -> Array:  # type: ignore[override]
        """Return the times of all events, s, shape (k,)."""
        return self.row_times[self.event_rows]

    @property
    def event_states(self) -> Array:  # type: ignore[override]
        """Return x1, v1, x2, v2 at all events, shape (4, k)."""
        return self.row_states[:, self.event_rows]

    @cached_property
    def end_time(self) -> Quantity:  # type: ignore[override]
        """Return the time at the end, s."""
        with self.context():
            return self.arithmetic.number(self.scene.until) if self.reached else self.row_times[-1]

    @property
    def has_critical_energy(self) -> bool:
        """Whether the pair has L and E_cr: a spring and friction."""
        return bool(self.scene.pair.a2 and self.scene.pair.b)

    @property
    def has_frame(self) -> bool:
        """Whether the pair has reduced coordinates: L, E_cr, and a total mass."""
        return self.has_critical_energy and not self.scene.pair.is_fixed

    @cached_property
    def frame(self) -> Frame:
        """Return the constants of the pair, between SI units and reduced coordinates of its own b.

        Raises InvalidScene where the pair has none.
        """
        with self.context():
            _ = self.scene.pair.mass, self.scene.pair.critical_energy
            return Frame(self.arithmetic, self.scene.pair)

    @property
    def _critical(self) -> Number:
        return self.arithmetic.number(self.scene.pair.critical_energy)

    # ------------------------------------------------------------------ times
    @cached_property
    def _begun(self) -> dict[Fraction, Number]:
        rows = zip(self.row_pieces, self.row_column("local"), self.row_times, strict=False)
        return {self.pieces[piece].start: t for piece, local, t in rows if local == 0}

    @cached_property
    def _row_points(self) -> Array:
        """Return when each row's segment begins, s, as points: those of the events, so that each finds its segments."""
        return self._points(self.row_times)

    def _rows(self, times: Array, side: Side) -> Counts:
        require_one_of("side", side, ("left", "right"))
        return np.maximum(np.searchsorted(self._row_points, self._points(times), side=side) - 1, 0)

    def row_at(self, t: Times, side: Side = "right") -> Counts:
        """Return the rows whose segments hold time(s) t (s), flat; at an event that on the given side."""
        with self.context():
            return self._rows(self._times(t).ravel(), side)

    def _states_at(self, times: Array, side: Side) -> Array:
        return self.row_values(self.row_flow, times, side)

    def row_values(self, function: Callable[..., Array], times: Array, side: Side) -> Array:
        """Return a function of rows and of the times since they began at times of the run.

        Where balls leave open which segment holds a time, all that may answer; the ball of an event is that event.
        """
        rows, starts, found = self._rows(times, side), self.row_times, []
        if not self._is_ball:
            return function(rows, self._since(times, rows))
        for time, row in zip(times, rows.tolist(), strict=True):
            first, after = row, row + 1  # this one holds its middle
            while first > 0 and not (starts[first] < time or same_ball(starts[first], time)):
                first -= 1
            while after < len(starts) and not (time < starts[after] or same_ball(time, starts[after])):
                after += 1
            held = np.arange(first, after)
            found.append(reduce(_union, function(held, time - starts[held]).T))
        return _columns(found)

    def _since(self, times: Array, rows: Counts) -> Array:
        """Return how long after the starts of their rows times are, s."""
        if not self.bounded:
            return np.asarray(times - self.row_times[rows])
        start, below = starts_of(self.scene)[:, self.row_pieces[rows]]
        local, rest = (self.row_column(name)[rows] for name in ("local", "local_rest"))
        return np.asarray(np.maximum((times - start) - local - (below + rest), 0.0))

    # ------------------------------------------------------------------ the motion
    @cached_property
    def _modes(self) -> tuple[list[LinearMode], Counts]:
        """Return the linear modes in which rows begin, and the index of each row's one."""
        rows = self.record.rows
        if isinstance(rows, np.ndarray):
            known = Cells(self.scene).all
            cells = np.array([known[int(n)][1] for n in rows[:, AT["cell"]]])
        else:
            cells = np.array([one.cell for one in rows])
        all_rows = np.column_stack([self.row_pieces, self.row_signs, cells])
        kinds, which = np.unique(all_rows, axis=0, return_inverse=True)
        found = [mode_in(self.scene, self.pieces[k], sign, (i, j)) for k, sign, i, j in kinds.tolist()]
        return found, which.ravel()

    def row_mode(self, row: int) -> LinearMode:
        """Return the linear mode in which a row begins."""
        return self._modes[0][self._modes[1][row]]

    def _motions(self, rows: Counts, since: Array, function: Callable[[Motion, Any], Any]) -> Array:
        """Return a function of the motions after rows, and of times (s) after their starts; not for binary64."""
        found = []
        for row, tau in zip(rows, since, strict=True):
            at = self.row_states[:, row].tolist(), self.row_times[row]
            found.append(enclosed(self.arithmetic, self.row_mode(row), *at, tau, function))
        return _columns(found)

    def row_flow(self, rows: Counts, since: Array) -> Array:
        """Return the states at times (s) after the starts of rows, shape (4, n); in the arithmetic's context."""
        if self.bounded:
            return np.asarray(self.row_states[:, rows] + self.row_changes(rows, since)[:FIRST])
        return self._motions(rows, since, after)

    def row_taken(self, rows: Counts, since: Array) -> Array:
        """Return what is taken and given (model.TAKEN) from the starts of rows on for times (s), J; not in binary64."""
        return self._motions(rows, since, taken)

    def row_excess_at(self, t: Any, side: Side) -> Number:
        """Return E/E_cr - 1 at one time, accurate in itself, of a run that carries it; None where it does not.

        What friction took since the last event is subtracted from what it was there: such a pair has no damper.
        """
        carried = self.row_excess
        if carried is None:
            return None

        def left(rows: Array, since: Array) -> Array:
            return np.asarray(carried[rows] - self.row_taken(rows, since)[0] / self._critical)

        found: Number = self.row_values(left, self._times(t).reshape(1), side).tolist()[0]
        return found

    def row_changes(self, rows: Counts, since: Floats) -> Floats:
        """Return by how much the state changes from rows on for a time (s), and what acts then, (8, n), in binary64.

        What acts: u, the friction force that sticking needs, that in slip, and the edge, N.
        """
        local, y = self.floats(self.row_column("local")), self.floats(self.row_states)
        rest = self.row_column("local_rest") if self.bounded else 0.0 * local
        found, (modes, all_modes) = np.zeros((FIRST + 4, len(since))), self._modes
        which, kinds = all_modes[rows], dict[Any, list[int]]()
        for k in np.unique(which).tolist():  # one matrix moves all modes of a kind
            kinds.setdefault((modes[k].layout, bool(modes[k].side), modes[k].cell), []).append(k)
        for (layout, slips, cell), its in kinds.items():
            chosen = np.flatnonzero(np.isin(which, its))
            tau, (own, at) = since[chosen], np.unique(rows[chosen], return_inverse=True)
            z, pair = np.zeros((layout.size, len(own))), self.scene.pair
            for k in its:
                z[FIRST:, all_modes[own] == k] = signals_of(modes[k])[:, None]
            if max(layout.terms) > 1 or any(layout.omegas):
                for late in (local[own], rest[own]):  # the signals are those of a stick, in which nothing grows
                    z += steps_of(pair, layout, False, CONSTANT, _bits(local[own])).over(z, late)
            z[:FIRST] = y[:, own]
            z = z[:, at.ravel()]
            changed = steps_of(pair, layout, slips, cell, _bits(tau)).over(z, tau)
            found[:FIRST, chosen], found[FIRST:, chosen] = changed[:FIRST], _acting(modes[its[0]]) @ (z + changed)
        return found


def _bits(times: Floats) -> int:
    """Return e with all times below 2^e."""
    return int(np.frexp(times.max())[1])


def _acting(mode: LinearMode) -> Floats:
    """Return the rows of u, of the load that sticking needs, of the friction force in slip, and of the edge, (4, n)."""
    force, others = np.zeros(mode.size), mode.rows.others
    add_signal(force, mode.layout.blocks[FORCE], 1.0)
    return np.array([force, *others[[LOAD, KINETIC, EDGE]].astype(float)])


def same_ball(one: arb, two: arb) -> bool:
    """Return whether two balls are the same ball; flint's == is about their points."""
    return bool(one.mid() == two.mid() and one.rad() == two.rad())


def _columns(found: list[Any]) -> Array:
    return np.array(found, dtype=object).T if found else np.empty((4, 0), dtype=object)
