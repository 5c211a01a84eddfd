"""Solve one scene of the free pair (a1 = 0, no force, b constant) in one arithmetic: `run_free`.

O(1) in the horizon. Binary64 and double-double carry error bounds (rows.py), mpmath and balls do without.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import can_compile, compiled, compiles_now
from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.functions import as_float, nonnegative, sign
from numerics.arithmetic.pair import Pair, nearest
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.arithmetic.questions import BEFORE_HORIZON
from numerics.errors import NoForceHere
from numerics.free.bounds import Carried, initial
from numerics.free.excursions import left_range, motions
from numerics.free.motion import Start, event_state, mode_of, order_of, state_at
from numerics.free.rows import UNKNOWN, solve_row, solve_start
from numerics.free.start import SI, Begun, begin, in_si, narrowing, wide
from numerics.linear.record import END_ROW, ROW, How, Knot, Record
from numerics.scene import Law, Scene

Progress = Callable[[int, float], None]
_FEW = 256
"""numba takes a second to come: so many events are left to Python first."""
_MANY = 200
"""So many short runs cost Python what it takes numba to come."""
_WIDE_RUN = 20
"""A short run in double-double costs Python as much as so many in binary64."""
_EVENTS_PER_TURN = 3.0
"""Events that a half turn of body 1 alone is given room for at first; with more the run is made again."""
_HOWS = tuple(How)
_runs = [0]


def run_free(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene with a1 = 0, no force and constant b. Raises EventUndecided, OutOfRange, NoForceHere."""
    by_rows = arithmetic.name in {"float64", "double-double"}
    return (_run_in_rows if by_rows else _run_exactly)(scene, arithmetic, max_events, progress)


def si_numbers(scene: Scene) -> SI:
    """Return the SI numbers of a scene, exact. Raises NoForceHere."""
    if scene.is_forced or scene.pair.a1:
        raise NoForceHere(
            "this scene has a force, a damper, or a friction that changes in time; solve it up to the time asked for"
        )
    pair, at = scene.pair, scene.initial
    return SI(pair.m1, pair.m2, pair.a2, pair.b, at.x1, at.v1, at.x2, at.v2, scene.until, pair.a1)


def begin_exactly(scene: Scene, arithmetic: Arithmetic) -> tuple[Begun, tuple[Number, ...]]:
    """Return how a scene begins, and x1, v1, x2, v2 and its horizon, in numbers of an arithmetic, in its context.

    Every sign is decided on exact rationals. Raises OutOfRange.
    """
    si = si_numbers(scene)
    given = tuple(arithmetic.number(one) for one in (si.x1, si.v1, si.x2, si.v2, si.until))
    return begin(SI(*map(wide, si)), scene.law is Law.THREE_VALUED_SGN, narrowing(arithmetic)), given


def scene_row(scene: Scene) -> NDArray[np.float64] | None:
    """Return a scene as compiled code reads it, ten SI numbers as high and low halves; None if it must be exact.

    It is made once and kept with the scene.
    """
    if "row" not in scene.made:
        si = si_numbers(scene)
        try:
            halves = [half for number in si for half in nearest(number)]
            # the halves may make two velocities equal that are not
            row = np.array(halves) if (halves[10:12] == halves[14:16]) == (si.v1 == si.v2) else None
        except OverflowError:
            row = None
        scene.made["row"] = row
    found: NDArray[np.float64] | None = scene.made["row"]
    return found


def run_row(row: NDArray[np.float64], literal: bool, max_events: int, progress: Progress | None) -> Record | None:
    """Solve ten SI numbers as halves in compiled binary64; None where they must be converted exactly."""
    solve, end = compiled(solve_row), np.empty(END_ROW)
    angle = row.item(16) * math.sqrt(row.item(4) / row.item(0))
    rows = _with_room(angle, max_events, lambda rows: solve(row, literal, max_events, rows, end))
    return None if rows is None else _record(rows, end, Float64(), progress)


def _with_room(angle: float, most: int, solve: Callable[[NDArray[np.float64]], int]) -> NDArray[np.float64] | None:
    """Return the rows of a run in which body 1 alone turns by so many radians; None for UNKNOWN.

    It is made again where there is no room for all its events.
    """
    room = int(min(most, 16 + _EVENTS_PER_TURN * min(angle / math.pi, 1e6)))
    while True:
        rows = np.empty((room + 1, ROW))
        room = solve(rows)
        if room < len(rows):
            return rows[: room + 1] if room != UNKNOWN else None


def _run_in_rows(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None) -> Record:
    """Run in binary64, by its row where it can be, or in double-double.

    A short run is made by Python, which would wait for numba longer than it runs.
    """
    is_wide = isinstance(arithmetic, DoubleDouble)
    _runs[0] += _WIDE_RUN if is_wide else 1
    fast = compiles_now() or (_runs[0] > _MANY and can_compile())
    row = scene_row(scene) if fast and not is_wide else None
    found = None if row is None else run_row(row, scene.law is Law.THREE_VALUED_SGN, max_events, progress)
    if found is not None:
        return found
    begun, carried, given = begin_in_rows(scene, arithmetic)
    end, rows = np.empty(END_ROW), None
    if not fast:
        few = min(_FEW, max_events) if can_compile() else max_events
        room = np.empty((few + 1, ROW))  # memory that no event reaches is never touched
        try:
            count = solve_start(begun, carried, given, few, room, end)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            raise left_range(arithmetic) from None
        rows = room[: count + 1].copy() if count < few or few == max_events else None
    if rows is None:
        solve, angle = compiled(solve_start), as_float(begun.horizon) / as_float(begun.at.sqrt_q)
        rows = _with_room(angle, max_events, lambda rows: solve(begun, carried, given, max_events, rows, end))
    return _record(rows, end, arithmetic, progress)


def begin_in_rows(scene: Scene, arithmetic: Arithmetic) -> tuple[Begun, Carried, tuple[Number, ...]]:
    """Return how a scene begins in binary64 or double-double, its errors and given numbers; kept with the scene."""
    if arithmetic.name not in scene.made:
        with arithmetic.context():
            begun, given = begin_exactly(scene, arithmetic)
            if isinstance(arithmetic, DoubleDouble):
                begun, given = (_in_halves(one, arithmetic.halves) for one in (begun, given))
        scene.made[arithmetic.name] = begun, initial(begun.at, begun.start, begun.V1, begun.V2), given
    found: tuple[Begun, Carried, tuple[Number, ...]] = scene.made[arithmetic.name]
    return found


def _in_halves(record: Any, halves: Callable[[Any], Any]) -> Any:
    """Return a record with every number as a pair."""
    if isinstance(record, (bool, int, float)):
        return record
    if not isinstance(record, tuple):
        return Pair(*halves(record))
    made = [_in_halves(one, halves) for one in record]
    return type(record)(*made) if hasattr(record, "_fields") else tuple(made)


def _record(rows: Any, end: NDArray[np.float64], arithmetic: Arithmetic, progress: Progress | None) -> Record:
    """Return the record of a run with bounds. Raises OutOfRange."""
    how, events, certain, high, low, *_, off = end[ROW:].tolist()
    if how == How.OUT_OF_RANGE:
        raise left_range(arithmetic)
    if progress is not None:
        progress(int(events), 1.0)
    friction = high if arithmetic.name == "float64" else Pair(high, low)
    return Record(rows, end, _HOWS[int(how)], int(events), certain == 1.0, friction, 0, off)


def _run_exactly(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None) -> Record:
    """Run in mpmath or balls, one Knot an event."""
    with arithmetic.context():
        begun, given = begin_exactly(scene, arithmetic)
        at, units, horizon = begun.at, begun.units, begun.horizon
        knots: list[Knot] = []
        length = zero = begun.start.tau
        for start, duration in motions(arithmetic, at, begun.start):
            here = in_si(units, event_state(at, start)) if knots else given[:4]
            knots.append(_knot(start, start.tau / units.rate, length, here)._replace(event=bool(knots)))
            if progress is not None and len(knots) % 1000 == 0:
                progress(len(knots), arithmetic.to_float(start.tau / horizon))
            if duration is None:
                how = How.STUCK
                break
            if sign(start.tau + duration - horizon, BEFORE_HORIZON) > 0:
                how = How.REACHED
                break
            if len(knots) > max_events:
                how = How.EVENT_LIMIT
                break
            length = duration / units.rate
        if how is How.EVENT_LIMIT:
            end, spent = knots[-1]._replace(length=zero), start.spent
        else:
            left = nonnegative((horizon - start.tau) - start.rest)
            last = state_at(at, start, left)
            end = _knot(start, given[4], left / units.rate, in_si(units, last))._replace(excess=last.w)
            spent = last.spent
        return Record(knots, end, how, len(knots) - 1, True, units.energy * spent, zero)


def _knot(start: Start, t: Number, length: Number, state: tuple[Number, ...]) -> Knot:
    x1, v1, x2, v2 = state
    return Knot(mode_of(start), order_of(start), False, False, 0, t, length, x1, v1, x2, v2, start.w)
