"""A trajectory at any time: which row's segment holds it, and the linear flow from that row's state.

In binary64 many motions are followed at once (flow.py); in every other arithmetic one by one, enclosed: for balls as
they are, for mpmath and double-double their middles.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache, cached_property, reduce
from typing import Any, Literal

import flint
import mpmath
import numpy as np
from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball, exact_middle, precision
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.linear.modes import MODES
from numerics.linear.record import AT
from numerics.linear.system import V1, LinearMode, Motion, Row, W, matrix, value
from numerics.scene.decimals import short
from numerics.trajectory.columns import Array, Counts
from numerics.trajectory.comparison import as_ball
from numerics.trajectory.flow import losses, moved, over_rows
from numerics.trajectory.rows import Rows

Side = Literal["left", "right"]
_SPARE_BITS = 24
_STATE = tuple(((place, Fraction(1)),) for place in range(4))
_union = np.frompyfunc(lambda one, two: one.union(two), 2, 1)


class Evaluated(Rows):
    """A run at any time."""

    def _times(self, t: Any) -> Array:
        """Return times (s) as numbers of the arithmetic, in their shape. Raises ValueError outside [0, end]."""
        try:
            given = np.asarray(t)
        except ValueError:
            raise ValueError("t must be a time in seconds or an array of times; its rows differ in length") from None
        if self._in_floats and given.dtype.kind in "fiu" and ((given >= 0) & (given <= self.end_time)).all():
            return given.astype(float)
        each = np.vectorize(self._time, otypes=[float if self._in_floats else object])
        return np.asarray(each(np.asarray(t, dtype=object)))

    def _time(self, t: Any) -> Number:
        """Return a time as a number of the arithmetic: exact from rationals and floats, its own numbers as they are."""
        own, to_float = not self._in_floats and isinstance(t, type(self.end_time)), self.arithmetic.to_float
        end, until = to_float(self.end_time), self.scene.until if self.reached else Fraction(0)
        exact: Any = to_float(t) if own else exact_time(t)
        if not 0 <= exact <= max(until, Fraction(end)):
            shown = self.arithmetic.text(t) if own else str(t)[:40]
            raise ValueError(f"t = {shown} s is outside the solved time [0, {end:g}] s; solve further")
        return t if own else self.arithmetic.number(exact)

    def _middles(self, times: Array) -> Array:
        """Return times themselves, or midpoints of balls: floats would not tell the ends of a short slip apart."""
        return np.array([one.mid() for one in times], dtype=object) if self._is_ball else times

    @cached_property
    def _row_points(self) -> Array:
        """Return when each row's segment begins, s, as points: those of the events, so that each finds its segments."""
        return self._middles(self.row_times)

    def _rows(self, times: Array, side: Side) -> Counts:
        """Return the row whose segment holds each time; at an event that on the given side."""
        require_side(side)
        return np.maximum(np.searchsorted(self._row_points, self._middles(times), side=side) - 1, 0)

    def sol(self, t: Any, side: Side = "right") -> Array:
        """Return (x1, v1, x2, v2) at the time(s) t (s): shape (4,) for a number, (4, ...) for an array.

        t is exact (int, Fraction, decimal text, or a float taken as its binary value) or a number of the arithmetic,
        such as the time of an event; `side` says which segment answers at an event, where the state is continuous but
        the accelerations jump. Enclosures for balls: where the segment is not decided, both answer. Raises ValueError
        outside [0, end].
        """
        with self.context():
            given = self._times(t)
            return self._at(self.row_flow, given.ravel(), side).reshape(4, *given.shape)

    def mode_at(self, t: Any, side: Side = "right") -> Any:
        """Return the mode at time t (s), an object array for a sequence; at an event that on the given side."""
        with self.context():
            given = self._times(t)
            found = [MODES[sign] for sign in self.row_signs[self._rows(given.ravel(), side)]]
        return np.array(found, dtype=object).reshape(given.shape)[()]

    def _excess(self, t: Any, side: Side) -> Number:
        """Return E/E_cr - 1 at one time, accurate in itself, of a run that carries it; None where it does not.

        What friction and viscosity took since the last event is subtracted from what it was there.
        """
        times, unit = self._times(t).reshape(1), self.frame.critical_energy
        carried = self.columns.numbers("excess")
        first = carried[self._rows(times, side)[0]]
        if first is None or (self.bounded and math.isnan(first)):
            return None

        def left(rows: Counts, since: Array) -> Array:
            friction, viscous, _ = self.row_losses(rows, since)
            return np.asarray(carried[rows] - (friction + viscous) / unit)

        found: Number = self._at(left, times, side).tolist()[0]
        return found

    def _at(self, function: Callable[..., Array], times: Array, side: Side) -> Array:
        """Return a function of rows and of the times since they began at times of the run.

        Where balls leave open which segment holds a time, all that may hold it answer.
        """
        rows, starts, found = self._rows(times, side), self.row_times, []
        if not self._is_ball:
            return function(rows, self._since(times, rows))
        for time, row in zip(times, rows.tolist(), strict=True):
            first, after = row, row + 1  # this one holds its middle
            while first > 0 and not starts[first] < time:
                first -= 1
            while after < len(starts) and not time < starts[after]:
                after += 1
            held = np.arange(first, after)
            found.append(reduce(_union, function(held, time - starts[held]).T))
        return _columns(found)

    def _since(self, times: Array, rows: Counts) -> Array:
        """Return how long after the starts of their rows times are, s."""
        if not self._in_floats:
            return np.asarray(times - self.row_times[rows])
        starts = np.array([float(piece.start) for piece in self.pieces])
        local, low = self.record.rows[rows, AT["local"] : AT["length"]].T  # low halves keep short slips apart
        return np.asarray(np.maximum((times - starts[self.row_pieces[rows]]) - local - low, 0.0))

    def row_flow(self, rows: Counts, since: Array) -> Array:
        """Return the states at times (s) after the starts of rows, shape (4, n); in the arithmetic's context."""
        if self._in_floats:
            return np.asarray(self.row_states[:, rows] + over_rows(moved, self, rows, since))
        return _columns([self.row_motion(row).after(tau) for row, tau in zip(rows.tolist(), since, strict=True)])

    def row_losses(self, rows: Counts, since: Array) -> Array:
        """Return b int |v1 - v2|, a1 int v1^2 and int u v1 from the starts of rows on for times (s), J, (3, n)."""
        if self._in_floats:
            return over_rows(losses, self, rows, since)
        return _columns([self.row_motion(row).losses(tau) for row, tau in zip(rows.tolist(), since, strict=True)])

    @cached_property
    def row_motion(self) -> Callable[[int], Moving]:
        """Return what gives the motion of a row's segment; not for binary64."""

        def motion(row: int) -> Moving:
            mode, state = self.row_mode(self.row_modes[1][row]), self.row_states[:, row].tolist()
            return Moving(self.arithmetic, mode, state, self.row_times[row])

        return cache(motion)


def _columns(found: list[Any]) -> Array:
    return np.array(found, dtype=object).T if found else np.empty((4, 0), dtype=object)


class Moving:
    """One motion, enclosed: from a state (m, m/s) at a time of the run (s), in a mode."""

    def __init__(self, arithmetic: Arithmetic, mode: LinearMode, state: Sequence[Number], begin: Number) -> None:
        """Keep where it begins; to be used in the arithmetic's context."""
        self.arithmetic, self.mode, self.is_ball = arithmetic, mode, arithmetic.name == "ball"
        self.bits = flint.ctx.prec if self.is_ball else mpmath.mp.prec + _SPARE_BITS
        with precision(self.bits):
            self.start = [as_ball(one) for one in state], as_ball(begin)

    def after(self, tau: Number) -> tuple[Number, ...]:
        """Return (x1, v1, x2, v2) at tau (s) after the start; for balls at every point of tau."""
        return self._enclosed(self._state, tau)

    def losses(self, tau: Number) -> tuple[Number, ...]:
        """Return what friction (b int |v1 - v2|) and viscosity (a1 int v1^2) took and int u v1 up to tau (s), J.

        Enclosures for balls.
        """
        return self._enclosed(self._taken, tau)

    def _enclosed(self, function: Callable[[Motion, arb], tuple[arb, ...]], tau: Number) -> tuple[Number, ...]:
        """Return a function of the motion and of a time after its start, with the bits that squarings may lose."""
        with precision(self.bits):
            since = as_ball(tau)
        with precision(self.bits + 2 * self._halvings(since)):
            found = function(self.mode.motion(*self.start), since)
        return tuple(+one if self.is_ball else self.arithmetic.number(exact_middle(one)) for one in found)

    def _halvings(self, tau: arb) -> int:
        """Return how often a time must be halved for the flow over it to be a small matrix."""
        largest, upper = max(abs(one) for row in self.mode.generator() for one in row), abs(tau).upper()
        bits = largest.numerator.bit_length() - largest.denominator.bit_length() + 8
        if upper.is_zero() or not upper.is_finite():
            return 0
        mantissa, exponent = upper.man_exp()
        return max(0, bits + int(mantissa).bit_length() + int(exponent))

    def _state(self, motion: Motion, tau: arb) -> tuple[arb, ...]:
        over = motion.over(tau)
        x1, v1, x2, v2 = (over.range(row) for row in _STATE)
        return x1, v1, x2, v2 if self.mode.side else v1

    def _taken(self, motion: Motion, tau: arb) -> tuple[arb, ...]:
        mode, a1 = self.mode, self.mode.pair.a1
        if mode.slope or mode.pull:
            friction = self._product(mode.friction, W, motion, tau)
        else:
            over = motion.over(tau)
            slid = [over.range(row) - value(row, motion.begin) for row in _STATE]
            friction = Ball.number(mode.side * mode.b) * (slid[0] - slid[2])
        damping = ((V1, a1),) if a1 else ()
        return friction, *(self._product(one, _STATE[V1], motion, tau) for one in (damping, mode.force))

    def _product(self, one: Row, two: Row, motion: Motion, tau: arb) -> arb:
        """Return int one two dt up to tau, of two rows: the integral of z' Q z.

        Van Loan's block exponential over a short interval, then doubled: exp(-A' t) alone would grow where z decays. A
        ball of times adds what the product may be there.
        """
        if not one:
            return arb(0)
        A, halvings, over = self.mode.generator(), self._halvings(tau), motion.over(tau)
        n = len(A)
        Q = [[Fraction(0)] * n for _ in range(n)]
        for place, f in one:
            for other, g in two:
                Q[place][other] += f * g / 2
                Q[other][place] += f * g / 2
        rows = [[*(-A[c][r] for c in range(n)), *Q[r]] for r in range(n)] + [[Fraction(0)] * n + row for row in A]
        E = (matrix(rows) * (tau.mid() / (arb(2) ** halvings))).exp()
        flow = arb_mat([[E[n + r, n + c] for c in range(n)] for r in range(n)])
        found = flow.transpose() * arb_mat([[E[r, n + c] for c in range(n)] for r in range(n)])
        for _ in range(halvings):
            found += flow.transpose() * found * flow
            flow = flow * flow
        middle = (motion.begin.transpose() * found * motion.begin)[0, 0]
        return middle + tau.rad() * arb(0, 1) * over.range(one) * over.range(two)


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
    end, before = until if last == math.inf else max(until, Fraction(last)), Fraction(0)  # type: Fraction, Any
    for k, one in enumerate(t_eval):
        point = one if hasattr(one, "man_exp") else exact_time(one, f"t_eval[{k}]")
        if isinstance(point, Fraction) and not 0 <= point <= end:
            shown = f"t_eval[{k}] = {str(one)[:40]} s is outside the run, [0, {short(until)}] s"
            raise ValueError(f"{shown}; give times within it, or a later until")
        if type(point) is type(before) and point < before:
            raise ValueError(f"t_eval[{k}] comes after a later time; put the times in order")
        before = point
