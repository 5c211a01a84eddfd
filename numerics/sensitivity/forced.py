"""Sensitivities under a force: the run's own segments once more, over dual numbers, from knot to knot.

A segment's numbers (state and time at its start, how long it lasts, the parameters of its piece) are dual; the texts of
the motion give the state at its end with its partial derivatives, and the chain rule joins segments:

    guard    the guard stays 0 there, which gives the derivatives of the event's time
    piece    its time is kept, and a start that moves by d adds (y'(t-) - y'(t+)) d to the state
    horizon  its time is kept; by `until` the derivatives are y'(t-)

In balls a state encloses the true one, and so do partial derivatives. What joining them adds is kept as the motion
keeps its errors: at a fixed time two solutions of the linearised equations never part in N, across all events, as two
motions do not. So derivatives are points, with bounds that are sums of local radii and do not grow by themselves.

By a start at t = 0 derivatives are one-sided, towards a later one; by `until`, if u or b jumps there, towards a shorter
run. Where a piece of force and one of friction begin together, each is moved alone.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.ball_words import widened
from numerics.arithmetic.dual import Dual
from numerics.errors import NotDifferentiable
from numerics.motion.forced_corners import corner
from numerics.motion.forced_pieces import pieces_of
from numerics.sensitivity.duals import dual
from numerics.sensitivity.forced_parameters import LOCAL, OWN, TAU, parameters
from numerics.sensitivity.forced_segments import Partial, Segments
from numerics.sensitivity.forced_starts import Starts

_STATE = ("x1", "v1", "x2", "v2")
_radius = np.frompyfunc(lambda x: x.rad(), 1, 1)
_middle = np.frompyfunc(lambda x: x.mid(), 1, 1)
_widened = np.frompyfunc(widened, 2, 1)


class Derivatives(NamedTuple):
    """By `wrt`, the last axis: of every event's time and state, of the state at the end, and of its energy."""

    wrt: tuple[str, ...]
    t: list[Any]
    y: list[Any]
    final: Any
    energy: Any


class _Carried(NamedTuple):
    """Derivatives at the start of a segment, with that start: of the state (4, p) and of the time in the piece (p,).

    In balls they are points, and `norm` and `place` (p,) bound their errors at a fixed time: in N, and of x1 - x2.
    """

    y: Any
    t: Any
    norm: Any
    place: Any


class _Ended(NamedTuple):
    """Derivatives at the end of a segment, with that end; `field` is y' there, `late` bounds what t takes over."""

    y: Any
    t: Any
    field: Any
    late: Any


def derivatives_of(trajectory: Any) -> Derivatives:
    """Return the derivatives of a trajectory under a force, in its arithmetic. Raises NotDifferentiable."""
    number = trajectory.arithmetic.to_float
    until = math.inf if trajectory.reached else number(trajectory.event_times[-1])
    what = corner(trajectory.scene, pieces_of(trajectory.scene), until)
    if what is not None:
        raise NotDifferentiable(f"this scene has no derivatives: {what}; move it by a little")
    arithmetic = dual(trajectory.arithmetic)
    with arithmetic.context():
        return _Chain(trajectory, arithmetic).followed()


class _Chain:
    """The chain rule along one trajectory."""

    def __init__(self, trajectory: Any, arithmetic: Dual) -> None:
        self.of, self.scene, self.number = trajectory, trajectory.scene, arithmetic.base.number
        self.segments = Segments(trajectory, arithmetic)
        self.starts, self.array = Starts(self.segments), arithmetic.array
        self.wrt = tuple(parameters(self.scene))
        self.column = {name: index for index, name in enumerate(self.wrt)}
        self.in_balls = arithmetic.name == "ball"

    def followed(self) -> Derivatives:
        """Return all derivatives."""
        of, t, y = self.segments, [], []
        carried = self._into_piece(self._begun(), 0)
        for row in range(len(of.modes) - 1):
            ended, after = self._ended(carried, row), row + 1
            crosses = of.pieces[after] != of.pieces[row]
            if of.events[after]:
                shown = self._shown(carried, ended, row)
                found = self._at_jump(*shown, after) if crosses else shown
                t.append(found[0])
                y.append(found[1])
            carried = self._rested(carried, ended, row)
            if crosses:
                carried = self._into_piece(carried, after)
        if not self.of.reached:
            return Derivatives(self.wrt, t, y, y[-1], self._energy(y[-1]))
        last = len(of.modes) - 1
        ended = self._ended(carried, last)
        _, final = self._shown(carried, ended, last)
        final[:, self.column["until"]] += ended.field
        return Derivatives(self.wrt, t, y, final, self._energy(final))

    def _zeros(self, *rows: int) -> Any:
        return self.array(np.full((*rows, len(self.wrt)), self.segments.zero))

    def _begun(self) -> _Carried:
        """Return the derivatives of the initial state; stuck neighbours share their momentum at once."""
        y, pair = self._zeros(4), self.scene.pair
        for index, name in enumerate(_STATE):
            y[index, self.column[name]] = self.number(1)
        if self.segments.modes[0] == 0:
            y[[1, 3], self.column["v1"]] = self.number(pair.m1 / pair.mass)
            y[[1, 3], self.column["v2"]] = self.number(pair.m2 / pair.mass)
        return self._pointed(y, self._zeros(), (self._zeros(), self._zeros()), self.array([self.segments.zero] * 4))

    def _into_piece(self, carried: _Carried, row: int) -> _Carried:
        """Return the derivatives at the start of a row that begins a piece."""
        y = +carried.y
        for name, (before, after) in self.starts.columns(row).items():
            y[:, self.column[name]] += before - after
        return self._pointed(y, self._zeros(), (carried.norm, carried.place), self.array([self.segments.zero] * 4))

    def _ended(self, carried: _Carried, row: int) -> _Ended:
        """Return the derivatives at the end of a segment."""
        of, after = self.segments, row + 1
        is_event = after < len(of.modes) and bool(of.events[after])
        is_guard = is_event and of.pieces[after] == of.pieces[row]
        found = of.partial(row, of.modes[after] if is_guard else 0)
        fixed = self._chained(found.guard, carried, found)
        longer = -fixed / found.guard[TAU] if is_guard else -carried.t
        y = self.array([self._chained(one, carried, found) + longer * one[TAU] for one in found.state])
        if is_guard and of.modes[row] != 0:
            y[1] = y[3]  # a slip ends where both velocities are one
        late = self._zeros()
        if self.in_balls and is_guard:
            pair = of.pair
            late = carried.norm * (pair.guard_norm if of.modes[row] else pair.load_norm) / abs(found.guard[TAU])
        return _Ended(y, carried.t + longer if is_guard else self._zeros(), found.state[:, TAU], late)

    def _chained(self, partial: Any, carried: _Carried, found: Partial) -> Any:
        """Return the derivatives of a quantity of which a segment has these partial ones, at its fixed length."""
        total = partial[:4] @ carried.y + partial[LOCAL] * carried.t
        for name, one in zip(found.names, partial[OWN:], strict=True):
            total[self.column[name]] += one
        return total

    def _rested(self, carried: _Carried, ended: _Ended, row: int) -> _Carried:
        """Return the derivatives with which the next segment starts, in the same piece or at the end of it."""
        of, after, place = self.segments, row + 1, carried.place
        if not self.in_balls:
            return _Carried(ended.y, ended.t, carried.norm, place)
        if of.modes[row]:  # x1 - x2 slides apart by |w| at most
            place = place + of.pair.guard_norm * carried.norm * of.length(row)
        field = self.array([of.zero] * 4)
        if of.pieces[after] == of.pieces[row]:  # else its time is fixed
            u, b = of.force(of.pieces[after], of.local(after)), of.friction(of.pieces[after])
            field = of.field(self.of.enclosed(after), u, b, of.modes[after])
        return self._pointed(ended.y, ended.t, (carried.norm, place), field)

    def _pointed(self, y: Any, t: Any, bounds: tuple[Any, Any], field: Any) -> _Carried:
        """Return derivatives as points, their radii added to the bounds; y' follows."""
        norm, place = bounds
        if not self.in_balls:
            return _Carried(y, t, norm, place)
        pair = self.segments.pair
        x1, v1, x2, v2 = (_radius(one) + abs(rate) * _radius(t) for one, rate in zip(y, field, strict=True))
        norm = norm + x1 * pair.root_a2 + v1 * pair.root_m1 + v2 * pair.root_m2
        return _Carried(_middle(y), _middle(t), norm, place + x1 + x2)

    def _shown(self, carried: _Carried, ended: _Ended, row: int) -> tuple[Any, Any]:
        """Return the derivatives of time and state at the end of a segment, enclosed in balls."""
        if not self.in_balls:
            return ended.t, +ended.y
        pair, norm, place = self.segments.pair, carried.norm, carried.place
        if self.segments.modes[row]:
            place = place + pair.guard_norm * norm * self.segments.length(row)
        x1 = norm / pair.root_a2
        off = (x1, norm / pair.root_m1, place + x1, norm / pair.root_m2)
        bounds = [one + abs(rate) * ended.late for one, rate in zip(off, ended.field, strict=True)]
        return _widened(ended.t, ended.late), _widened(ended.y, self.array(bounds))

    def _at_jump(self, t: Any, y: Any, row: int) -> tuple[Any, Any]:
        """Return the same at an event that comes with the start of a piece, and moves with it."""
        for name, (before, _) in self.starts.columns(row).items():
            t[self.column[name]] += self.number(1)
            y[:, self.column[name]] += before
        return t, y

    def _energy(self, final: Any) -> Any:
        """Return the derivatives of E = (a2 x1^2 + m1 v1^2 + m2 v2^2)/2 at the end."""
        x1, v1, _, v2 = self.of.final_state
        pair = self.segments.pair
        total = final[0] * (pair.a2 * x1) + final[1] * (pair.m1 * v1) + final[3] * (pair.m2 * v2)
        for name, value in (("a2", x1), ("m1", v1), ("m2", v2)):
            total[self.column[name]] += value * value / 2
        return total
