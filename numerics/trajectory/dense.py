"""A trajectory at any time: which row's segment holds it, and the linear flow from that row's state."""

from __future__ import annotations

import operator
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.linear.modes import MODES
from numerics.scene.decimals import short
from numerics.trajectory.flow import losses, moved, over_rows
from numerics.trajectory.motions import Moving
from numerics.trajectory.rows import Rows

Side = Literal["left", "right"]


class Dense:
    """The dense evaluation of one trajectory; to be used in its arithmetic's context."""

    def __init__(self, trajectory: Rows) -> None:
        """Evaluate this trajectory."""
        self.of, self.arithmetic = trajectory, trajectory.arithmetic
        self.in_floats, self.is_ball = self.arithmetic.name == "float64", self.arithmetic.name == "ball"
        self._motions: dict[int, Moving] = {}

    def times(self, t: Any) -> NDArray[Any]:
        """Return times (s) as numbers of the arithmetic, in their shape. Raises ValueError outside [0, end]."""
        try:
            given = np.asarray(t)
        except ValueError:
            raise ValueError("t must be a time in seconds or an array of times; its rows differ in length") from None
        if self.in_floats and given.dtype.kind in "fiu":
            given = given.astype(float)
            end = self.of.end_time
            wrong = given[~((given >= 0) & (given <= end))]
            if wrong.size:
                self._refuse(f"{wrong.flat[0]:g}")
            return given
        given = np.asarray(t, dtype=object)
        found = np.empty(given.shape, dtype=float if self.in_floats else object)
        for index in np.ndindex(given.shape):
            found[index] = self.time(given[index])
        return found

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
            self._refuse(f"{float(exact):g}")
        return self.arithmetic.number(exact)

    def _refuse(self, t: str) -> None:
        end = self.arithmetic.to_float(self.of.end_time)
        raise ValueError(f"t = {t} s is outside the solved time [0, {end:g}] s")

    def middle(self, x: Number) -> Number:
        """Return x itself, or the midpoint of a ball: a float would not tell the ends of a short slip apart."""
        return x.mid() if self.is_ball else x

    @cached_property
    def starts(self) -> NDArray[Any]:
        """Return when each row's segment begins, s, as points: those of the events, so that each finds its segments."""
        starts = self.of.row_times
        return np.array([self.middle(one) for one in starts], dtype=object) if self.is_ball else starts

    def rows(self, times: NDArray[Any], side: Side) -> NDArray[np.int64]:
        """Return the row whose segment holds each time; at an event that on the given side."""
        require_side(side)
        points = np.array([self.middle(one) for one in times], dtype=object) if self.is_ball else times
        return np.maximum(np.searchsorted(self.starts, points, side=side) - 1, 0)

    def states(self, t: Any, side: Side) -> NDArray[Any]:
        """Return (x1, v1, x2, v2) at the times, shape (4, ...)."""
        given = self.times(t)
        times = given.ravel()
        rows = self.rows(times, side)
        if self.in_floats:
            found = self.floats(rows, self.since(times, rows))
        else:
            found = np.empty((4, len(times)), dtype=object)
            for at, (time, row) in enumerate(zip(times, rows.tolist(), strict=True)):
                found[:, at] = _union([self.motion(one).after(since) for one, since in self._held(time, row)])
        return found.reshape(4, *given.shape)

    def excess(self, t: Any, side: Side) -> Number:
        """Return E/E_cr - 1 at one time, accurate in itself, of a run that carries it; None where it does not.

        What friction and viscosity took since the last event is subtracted from what it was there.
        """
        time = self.time(t)
        row = int(self.rows(np.array([time], dtype=None if self.in_floats else object), side)[0])
        carried, unit = self.of.columns.numbers("excess"), self.of.frame.critical_energy
        if carried[row] is None or (self.of.bounded and carried[row] != carried[row]):  # nan
            return None
        if self.in_floats:
            since = self.since(np.array([time]), np.array([row]))
            return float(carried[row] - over_rows(losses, self.of, np.array([row]), since)[:2].sum() / unit)
        return _union(
            [(carried[one] - sum(self.motion(one).losses(since)[:2]) / unit,) for one, since in self._held(time, row)]
        )[0]

    def since(self, times: NDArray[Any], rows: NDArray[np.int64]) -> NDArray[Any]:
        """Return how long after the starts of their rows times are, s: the low halves keep short slips apart."""
        starts = np.array([float(piece.start) for piece in self.of.pieces])
        local, low = self.of.columns.halves("local")
        return np.asarray(np.maximum((times - starts[self.of.row_pieces[rows]]) - local[rows] - low[rows], 0.0))

    def _held(self, time: Number, row: int) -> list[tuple[int, Number]]:
        """Return the rows that may hold a time (for balls all that are not excluded), and the time since each began."""
        first = last = row
        if self.is_ball:
            while first > 0 and self._may_hold(first - 1, time):
                first -= 1
            while last + 1 < len(self.starts) and self._may_hold(last + 1, time):
                last += 1
        return [(one, time - self.of.row_times[one]) for one in range(first, last + 1)]

    def _may_hold(self, row: int, time: Number) -> bool:
        """Return whether it is not excluded that the segment of a row holds a time."""
        starts, last = self.of.row_times, row == len(self.starts) - 1
        return not time < starts[row] and (last or not starts[row + 1] < time)

    def motion(self, row: int) -> Moving:
        """Return the motion of a row's segment; not for binary64."""
        if row not in self._motions:
            of = self.of
            start = of.row_times[row], of.row_states[:, row].tolist()
            self._motions[row] = Moving(self.arithmetic, of.row_mode(of.row_modes[1][row]), start)
        return self._motions[row]

    def floats(self, rows: NDArray[np.int64], since: NDArray[Any]) -> NDArray[np.float64]:
        """Return the states at times after the starts of rows, in binary64, shape (4, n)."""
        return self.of.row_states[:, rows] + over_rows(moved, self.of, rows, since)

    def after(self, rows: range, since: Number) -> tuple[Number, Number, Number, Number]:
        """Return the state at `since` (s) after the start of a segment that consists of rows."""
        row = rows[0]
        for later in rows[1:]:  # pieces of force begin within
            before = self.of.row_lengths[row]
            if self.middle(since) <= self.middle(before):
                break
            row, since = later, since - before
        if self.in_floats:
            x1, v1, x2, v2 = self.floats(np.array([row]), np.array([since]))[:, 0].tolist()
            return x1, v1, x2, v2
        return self.motion(row).after(since)

    def mode(self, t: Any, side: Side) -> Any:
        """Return the modes at the times: a Mode, or an object array."""
        given = self.times(t)
        rows = self.rows(given.ravel(), side)
        found = np.empty(len(rows), dtype=object)
        found[:] = [MODES[self.of.row_signs[row]] for row in rows]
        return found[0] if given.ndim == 0 else found.reshape(given.shape)


def _union(found: list[tuple[Number, ...]]) -> tuple[Number, ...]:
    """Return the unions of what several rows say, number by number; mostly there is one row."""
    first, *rest = found
    for other in rest:
        first = tuple(one.union(two) for one, two in zip(first, other, strict=True))
    return first


def exact_time(t: Any, name: str = "t") -> Fraction:
    """Return a time as an exact rational: text as a decimal, a float as its binary value. Raises ValueError."""
    try:
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
    if _depth(t_eval) != 1:
        raise ValueError(f"t_eval = {str(t_eval)[:40]!r} must be a sequence of times in seconds")
    end = max(until, Fraction(float(until))) if until < 10**300 else until
    given = np.asarray(t_eval)
    if given.dtype.kind in "fiu":  # all at once; only the first wrong one is looked at exactly
        times = given.astype(float)
        wrong = ~((times >= 0) & (times <= (float(until) if until < 10**300 else np.inf)))
        wrong[1:] |= times[1:] < times[:-1]
        if not wrong.any():
            return
        t_eval = given[: int(np.argmax(wrong)) + 1]
    asked = list(t_eval)
    points = [one if hasattr(one, "man_exp") else exact_time(one, f"t_eval[{k}]") for k, one in enumerate(asked)]
    for k, one in enumerate(points):
        if isinstance(one, Fraction) and not 0 <= one <= end:
            shown = f"t_eval[{k}] = {str(asked[k])[:40]} s is outside the run, [0, {short(until)}] s"
            raise ValueError(f"{shown}; give times within it, or a later until")
    for k, (one, two) in enumerate(pairwise(points), start=1):
        if type(one) is type(two) and two < one:
            raise ValueError(f"t_eval[{k}] comes after a later time; put the times in order")


def _depth(values: Any) -> int:
    """Return the number of dimensions; 2 for rows that differ in length."""
    try:
        return np.ndim(values)
    except ValueError:
        return 2
