"""Solve one scene of the free pair (a1 = 0, no force, b constant) in one arithmetic: `run_free`.

O(1) in the horizon. Binary64 and double-double carry error bounds (rows.py), mpmath and balls do without.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic import elementary, pair
from numerics.arithmetic.compiled import can_compile, compiled, compiles_now
from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.functions import as_float, sign
from numerics.arithmetic.pair import TwoFloats, nearest
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.arithmetic.questions import BEFORE_HORIZON
from numerics.errors import NoForceHere
from numerics.free.bounds import Errors, initial
from numerics.free.excursions import left_range, motions
from numerics.free.frame import Begun, begin, in_si, narrowing, wide
from numerics.free.motion import event_state, mode_of, order_of, state_at
from numerics.free.rows import solve_row, solve_start
from numerics.free.slip import Start
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
_UNITS = {"float64": elementary.UNIT, "double-double": pair.UNIT}
"""What errors of one operation are counted in, where they are counted."""
_HOWS = tuple(How)
_runs = [0]


def run_free(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene with a1 = 0, no force and constant b. Raises EventUndecided, OutOfRange, NoForceHere."""
    if arithmetic.name not in {"float64", "double-double"}:
        return _run_exactly(scene, arithmetic, max_events, progress)
    found = _run_in_rows(scene, arithmetic, max_events)
    if progress is not None:
        progress(found.events, 1.0)
    return found


def si_numbers(scene: Scene) -> tuple[Fraction, ...]:
    """Return m1, m2, a2, b, x1, v1, x2, v2, until and a1 = 0 of a scene, exact, in SI units. Raises NoForceHere."""
    if scene.is_forced or scene.pair.a1:
        raise NoForceHere(
            "this scene has a force, a damper, or a friction that changes; solve it up to the time asked for"
        )
    of, at = scene.pair, scene.initial
    return of.m1, of.m2, of.a2, of.b, at.x1, at.v1, at.x2, at.v2, scene.until, of.a1


def begin_exactly(scene: Scene, arithmetic: Arithmetic) -> tuple[Begun, tuple[Number, ...]]:
    """Return how a scene begins, and x1, v1, x2, v2 and its horizon, in numbers of an arithmetic, in its context.

    Every sign is decided on exact rationals. Raises OutOfRange.
    """
    si = si_numbers(scene)
    given = tuple(map(arithmetic.number, si[4:9]))
    is_literal, unit = scene.law is Law.THREE_VALUED_SGN, _UNITS.get(arithmetic.name, 0.0)
    return begin(tuple(map(wide, si[:9])), is_literal, narrowing(arithmetic), unit), given


def scene_row(scene: Scene) -> NDArray[np.float64] | None:
    """Return a scene as compiled code reads it, ten SI numbers as high and low halves; None if it must be exact.

    It is made once and kept with the scene.
    """
    if "row" not in scene.made:
        si = si_numbers(scene)
        try:
            halves = [half for number in si for half in nearest(number)]
            # the halves may make two velocities equal that are not
            row = np.array(halves) if (halves[10:12] == halves[14:16]) == (si[5] == si[7]) else None
        except OverflowError:
            row = None
        scene.made["row"] = row
    found: NDArray[np.float64] | None = scene.made["row"]
    return found


def run_row(row: NDArray[np.float64], literal: bool, max_events: int) -> Record | None:
    """Solve ten SI numbers as halves in compiled binary64; None where they must be converted exactly."""
    room = _room_for(row.item(16) * math.sqrt(row.item(4) / row.item(0)), max_events)
    rows, end = _with_room(compiled(solve_row), (row, literal), room, max_events)
    return _record(rows, end, Float64()) if len(rows) else None


def _room_for(angle: float, most: int) -> int:
    """Return how many events are given room for at first, in a run in which body 1 alone turns by so many radians."""
    return int(min(most, 16 + _EVENTS_PER_TURN * min(angle / math.pi, 1e6)))


def _with_room(solve: Callable[..., int], given: tuple[Any, ...], room: int, most: int) -> tuple[Any, Any]:
    """Return the rows of a run, none for UNKNOWN, and its end; it is made again where all its events had no room."""
    end, rows = np.empty(END_ROW), np.empty((0, ROW))
    while room >= len(rows):
        rows = np.empty((room + 1, ROW))  # memory that no event reaches is never touched
        room = solve(*given, most, rows, end)
    return rows[: room + 1], end


def _run_in_rows(scene: Scene, arithmetic: Arithmetic, max_events: int) -> Record:
    """Run in binary64, by its row where it can be, or in double-double.

    A short run is made by Python, which would wait for numba longer than it runs.
    """
    is_wide = arithmetic.name == "double-double"  # to ask for its type is slower: it follows a Protocol
    _runs[0] += _WIDE_RUN if is_wide else 1
    fast = compiles_now() or (_runs[0] > _MANY and can_compile())
    row = scene_row(scene) if fast and not is_wide else None
    found = None if row is None else run_row(row, scene.law is Law.THREE_VALUED_SGN, max_events)
    if found is not None:
        return found
    given = begin_in_rows(scene, arithmetic)
    if not fast:
        few = min(_FEW, max_events) if can_compile() else max_events
        try:
            rows, end = _with_room(solve_start, given, few, few)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            raise left_range(arithmetic) from None
        if len(rows) <= few or few == max_events:
            return _record(rows.copy(), end, arithmetic)
    room = _room_for(as_float(given[0].horizon) / as_float(given[0].at.sqrt_q), max_events)
    return _record(*_with_room(compiled(solve_start), given, room, max_events), arithmetic)


def _record(rows: Any, end: NDArray[np.float64], arithmetic: Arithmetic) -> Record:
    """Return the record of a run with bounds. Raises OutOfRange."""
    how, events, certain, *_ = end[ROW:].tolist()
    if how == How.OUT_OF_RANGE:
        raise left_range(arithmetic)
    return Record(rows, end, _HOWS[int(how)], int(events), certain == 1.0)


def begin_in_rows(scene: Scene, arithmetic: Arithmetic) -> tuple[Begun, Errors, tuple[Number, ...]]:
    """Return how a scene begins in binary64 or double-double, its errors and given numbers; kept with the scene."""
    if arithmetic.name not in scene.made:
        with arithmetic.context():
            begun, given = begin_exactly(scene, arithmetic)
            if isinstance(arithmetic, DoubleDouble):
                begun, given = (_in_halves(one, arithmetic.halves) for one in (begun, given))
        scene.made[arithmetic.name] = begun, initial(begun), given
    found: tuple[Begun, Errors, tuple[Number, ...]] = scene.made[arithmetic.name]
    return found


def _in_halves(record: Any, halves: Callable[[Any], Any]) -> Any:
    """Return a record with every number as a pair."""
    if isinstance(record, (bool, int, float)):
        return record
    if not isinstance(record, tuple):
        return TwoFloats(*halves(record))
    made = [_in_halves(one, halves) for one in record]
    return type(record)(*made) if hasattr(record, "_fields") else tuple(made)


def _run_exactly(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None) -> Record:
    """Run in mpmath or balls, one Knot an event."""
    with arithmetic.context():
        begun, given = begin_exactly(scene, arithmetic)
        at, units, horizon = begun.at, begun.units, begun.horizon
        knots: list[Knot] = []
        length = zero = begun.start.tau
        for start, duration in motions(arithmetic, at, begun.start):
            here = in_si(units, event_state(at, start)) if knots else given[:4]
            knots.append(_knot(start, bool(knots), start.tau / units.rate, length, here, start.w))
            if progress is not None and len(knots) % 1000 == 0:
                progress(len(knots), arithmetic.to_float(start.tau / horizon))
            if duration is None or sign(start.tau + duration - horizon, BEFORE_HORIZON) > 0:
                how, left = How.STUCK if duration is None else How.REACHED, (horizon - start.tau) - start.rest
                last = state_at(at, start, left)
                end = _knot(start, False, given[4], left / units.rate, in_si(units, last), last.w)
                break
            if len(knots) > max_events:
                how, end = How.EVENT_LIMIT, knots[-1]._replace(length=zero)
                break
            length = duration / units.rate
        return Record(knots, end, how, len(knots) - 1)


def _knot(start: Start, event: bool, t: Number, length: Number, state: Any, w: Number) -> Knot:
    x1, v1, x2, v2 = state
    return Knot(mode_of(start), order_of(start), event, False, 0, t, length, x1, v1, x2, v2, w)
