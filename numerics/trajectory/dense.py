"""A trajectory at any time: which row's segment holds it, and the linear flow from that row's state.

In binary64 many motions are followed at once (flow.py), in every other arithmetic one by one (motions.py); nothing else
here knows the difference.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from fractions import Fraction
from functools import cached_property, reduce
from itertools import pairwise
from typing import Any, Literal

import numpy as np

from numerics.arithmetic.protocol import Number
from numerics.linear.modes import MODES
from numerics.linear.record import AT
from numerics.scene.decimals import short
from numerics.trajectory.columns import Array, Counts
from numerics.trajectory.flow import losses, moved, over_rows
from numerics.trajectory.motions import Moving
from numerics.trajectory.rows import Rows

Side = Literal["left", "right"]
_union = np.frompyfunc(lambda one, two: one.union(two), 2, 1)


class Dense:
    """The dense evaluation of one trajectory; to be used in its arithmetic's context."""

    def __init__(self, trajectory: Rows) -> None:
        """Evaluate this trajectory."""
        self.of, self.arithmetic = trajectory, trajectory.arithmetic
        self.in_floats, self.is_ball = self.arithmetic.name == "float64", self.arithmetic.name == "ball"
        self._motions: dict[int, Moving] = {}

    def times(self, t: Any) -> Array:
        """Return times (s) as numbers of the arithmetic, in their shape. Raises ValueError outside [0, end]."""
        try:
            given = np.asarray(t)
        except ValueError:
            raise ValueError("t must be a time in seconds or an array of times; its rows differ in length") from None
        if self.in_floats and given.dtype.kind in "fiu":
            given = given.astype(float)
            for wrong in given[~((given >= 0) & (given <= self.of.end_time))]:
                self._refuse(str(wrong).removesuffix(".0"))
            return given
        each = np.vectorize(self.time, otypes=[float if self.in_floats else object])
        return np.asarray(each(np.asarray(t, dtype=object)))

    def time(self, t: Any) -> Number:
        """Return a time as a number of the arithmetic: exact from rationals and floats, its own numbers as they are."""
        end, until = self.of.end_time, self.of.scene.until if self.of.reached else Fraction(0)
        to_float = self.arithmetic.to_float
        if not self.in_floats and isinstance(t, type(end)):
            if not 0 <= to_float(t) <= max(to_float(end), float(until)):
                self._refuse(self.arithmetic.text(t))
            return t
        exact = exact_time(t)
        if not 0 <= exact <= max(until, Fraction(to_float(end))):
            self._refuse(str(t)[:40])
        return self.arithmetic.number(exact)

    def _refuse(self, t: str) -> None:
        end = self.arithmetic.to_float(self.of.end_time)
        raise ValueError(f"t = {t} s is outside the solved time [0, {end:g}] s; solve further")

    def middles(self, times: Array) -> Array:
        """Return times themselves, or midpoints of balls: floats would not tell the ends of a short slip apart."""
        return np.array([one.mid() for one in times], dtype=object) if self.is_ball else times

    @cached_property
    def starts(self) -> Array:
        """Return when each row's segment begins, s, as points: those of the events, so that each finds its segments."""
        return self.middles(self.of.row_times)

    def rows(self, times: Array, side: Side) -> Counts:
        """Return the row whose segment holds each time; at an event that on the given side."""
        require_side(side)
        return np.maximum(np.searchsorted(self.starts, self.middles(times), side=side) - 1, 0)

    def states(self, t: Any, side: Side) -> Array:
        """Return (x1, v1, x2, v2) at the times, shape (4, ...)."""
        given = self.times(t)
        return self._at(self.flow, given.ravel(), side).reshape(4, *given.shape)

    def excess(self, t: Any, side: Side) -> Number:
        """Return E/E_cr - 1 at one time, accurate in itself, of a run that carries it; None where it does not.

        What friction and viscosity took since the last event is subtracted from what it was there.
        """
        times, unit = self.times(t).reshape(1), self.of.frame.critical_energy
        carried = self.of.columns.numbers("excess")
        first = carried[self.rows(times, side)[0]]
        if first is None or (self.of.bounded and math.isnan(first)):
            return None

        def left(rows: Counts, since: Array) -> Array:
            friction, viscous, _ = self.losses(rows, since)
            return np.asarray(carried[rows] - (friction + viscous) / unit)

        found: Number = self._at(left, times, side).tolist()[0]
        return found

    def _at(self, function: Callable[..., Array], times: Array, side: Side) -> Array:
        """Return a function of rows and of the times since they began at times of the run.

        Where balls leave open which segment holds a time, all that may hold it answer.
        """
        rows = self.rows(times, side)
        if not self.is_ball:
            return function(rows, self.since(times, rows))
        found = []
        for time, row in zip(times, rows.tolist(), strict=True):
            held = self._held(time, row)
            found.append(reduce(_union, function(held, time - self.of.row_times[held]).T))
        return np.array(found, dtype=object).T if found else np.empty((4, 0), dtype=object)

    def since(self, times: Array, rows: Counts) -> Array:
        """Return how long after the starts of their rows times are, s."""
        if not self.in_floats:
            return np.asarray(times - self.of.row_times[rows])
        starts = np.array([float(piece.start) for piece in self.of.pieces])
        local, low = self.of.record.rows[rows, AT["local"] : AT["length"]].T  # low halves keep short slips apart
        return np.asarray(np.maximum((times - starts[self.of.row_pieces[rows]]) - local - low, 0.0))

    def _held(self, time: Number, row: int) -> Counts:
        """Return the rows that are not excluded to hold a ball of times; one of them holds its middle."""
        starts, first, last = self.of.row_times, row, row
        while first > 0 and not starts[first] < time:
            first -= 1
        while last + 1 < len(starts) and not time < starts[last + 1]:
            last += 1
        return np.arange(first, last + 1)

    def flow(self, rows: Counts, since: Array) -> Array:
        """Return the states at times (s) after the starts of rows, shape (4, n)."""
        if self.in_floats:
            return np.asarray(self.of.row_states[:, rows] + over_rows(moved, self.of, rows, since))
        return self._one_by_one(Moving.after, rows, since)

    def losses(self, rows: Counts, since: Array) -> Array:
        """Return b int |v1 - v2|, a1 int v1^2 and int u v1 from the starts of rows on for times (s), J, (3, n)."""
        if self.in_floats:
            return over_rows(losses, self.of, rows, since)
        return self._one_by_one(Moving.losses, rows, since)

    def _one_by_one(self, function: Callable[..., Any], rows: Counts, since: Array) -> Array:
        found = [function(self.motion(row), tau) for row, tau in zip(rows.tolist(), since, strict=True)]
        return np.array(found, dtype=object).T if found else np.empty((4, 0), dtype=object)

    def motion(self, row: int) -> Moving:
        """Return the motion of a row's segment; not for binary64."""
        if row not in self._motions:
            of = self.of
            start = of.row_times[row], of.row_states[:, row].tolist()
            self._motions[row] = Moving(self.arithmetic, of.row_mode(of.row_modes[1][row]), start)
        return self._motions[row]

    def after(self, rows: range, since: Number) -> tuple[Number, Number, Number, Number]:
        """Return the state at `since` (s) after the start of a segment that consists of rows."""
        row = rows[0]
        for later in rows[1:]:  # pieces of force begin within
            before = self.of.row_lengths[row]
            here, last = self.middles(np.array([since, before]))
            if here <= last:
                break
            row, since = later, since - before
        x1, v1, x2, v2 = self.flow(np.array([row]), np.array([since]))[:, 0].tolist()
        return x1, v1, x2, v2

    def mode(self, t: Any, side: Side) -> Any:
        """Return the modes at the times: a Mode, or an object array."""
        given = self.times(t)
        found = [MODES[sign] for sign in self.of.row_signs[self.rows(given.ravel(), side)]]
        return np.array(found, dtype=object).reshape(given.shape)[()]


def exact_time(t: Any, name: str = "t") -> Fraction:
    """Return a time as an exact rational: text as a decimal, a float as its binary value. Raises ValueError."""
    try:
        if isinstance(t, bool):
            raise TypeError
        if hasattr(t, "as_integer_ratio"):
            return Fraction(*t.as_integer_ratio())
        return Fraction(t if isinstance(t, str) else operator.index(t))
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        raise ValueError(f"{name} = {str(t)[:40]!r} is not a time in seconds; give a finite number >= 0") from None


def require_side(side: Any) -> None:
    """Raise ValueError for what is no side of an event."""
    if not isinstance(side, str) or side not in ("left", "right"):
        raise ValueError(f"side = {str(side)[:40]!r} is not one of left, right")


def require_times(t_eval: Any, until: Fraction) -> None:
    """Raise ValueError unless these are times (s) of a run, in order; balls and mpmath's are looked at later."""
    try:
        is_list = np.ndim(t_eval) == 1
    except ValueError:  # rows that differ in length
        is_list = False
    if not is_list:
        raise ValueError(f"t_eval = {str(t_eval)[:40]!r} must be a sequence of times in seconds")
    last = float(until) if until < 10**300 else math.inf
    given = np.asarray(t_eval)
    if given.dtype.kind in "fiu":  # all at once; only a wrong one is looked for exactly
        times = given.astype(float)
        if ((times >= 0) & (times <= last)).all() and (times[1:] >= times[:-1]).all():
            return
    asked, end = list(t_eval), until if last == math.inf else max(until, Fraction(last))
    points = [one if hasattr(one, "man_exp") else exact_time(one, f"t_eval[{k}]") for k, one in enumerate(asked)]
    for k, one in enumerate(points):
        if isinstance(one, Fraction) and not 0 <= one <= end:
            shown = f"t_eval[{k}] = {str(asked[k])[:40]} s is outside the run, [0, {short(until)}] s"
            raise ValueError(f"{shown}; give times within it, or a later until")
    for k, (one, two) in enumerate(pairwise(points), start=1):
        if type(one) is type(two) and two < one:
            raise ValueError(f"t_eval[{k}] comes after a later time; put the times in order")
