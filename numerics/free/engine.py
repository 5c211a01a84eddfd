"""Solve one scene of the free pair (a1 = 0, no force, b constant) in one arithmetic: `run_free`.

O(1) in the horizon. Binary64 carries error bounds (rows.py), mpmath and balls do without.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import can_compile, compiled, compiles_now
from numerics.arithmetic.elementary import UNIT
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.functions import as_float, sign
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.arithmetic.questions import BEFORE_HORIZON
from numerics.errors import NoForceHere
from numerics.free.bounds import Errors, initial
from numerics.free.excursions import left_range, motions
from numerics.free.frame import Begun, as_fmpq, begin, in_si, narrowing
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
_EVENTS_PER_TURN = 3.0
"""Events that a half turn of body 1 alone is given room for at first; with more the run is made again."""
_HOWS = tuple(How)
_FLOAT64 = Float64()
_runs = [0]


def run_free(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene with a1 = 0, no force and constant b. Raises EventUndecided, OutOfRange, NoForceHere."""
    if arithmetic.name != "float64":
        return _run_exactly(scene, arithmetic, max_events, progress)
    found = _run_in_rows(scene, max_events)
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
    is_literal, unit = scene.law is Law.THREE_VALUED_SGN, UNIT if arithmetic.name == "float64" else 0.0
    return begin(tuple(map(as_fmpq, si[:9])), is_literal, narrowing(arithmetic), unit), given


def scene_row(scene: Scene) -> NDArray[np.float64] | None:
    """Return a scene as compiled code reads it, ten SI numbers; None if it must be exact.

    It is made once and kept with the scene.
    """
    if "row" not in scene.made:
        si = si_numbers(scene)
        try:
            row = [*map(float, si)]
        except OverflowError:
            row = [math.inf]
        # rounding may make two velocities equal that are not, or a number 0
        same = len(row) == len(si) and (row[5] == row[7]) == (si[5] == si[7]) and all(map(_same_sign, row, si))
        scene.made["row"] = np.array(row) if same else None
    found: NDArray[np.float64] | None = scene.made["row"]
    return found


def _same_sign(x: float, exact: Fraction) -> bool:
    """Return whether a float is 0 only where the exact number is."""
    return bool(x) == bool(exact)


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


def _run_in_rows(scene: Scene, max_events: int) -> Record:
    """Run in binary64, by its row where it can be. Raises OutOfRange."""
    _runs[0] += 1
    row, found = scene_row(scene), None
    if row is not None:
        angle = row.item(8) * math.sqrt(row.item(2) / row.item(0))
        found = _run_by(solve_row, (row, scene.law is Law.THREE_VALUED_SGN), angle, max_events)
    if found is None:
        given = begin_in_rows(scene)
        angle = as_float(given[0].horizon) / as_float(given[0].at.sqrt_q)
        found = _run_by(solve_start, given, angle, max_events)
    return found


def _run_by(solve: Callable[..., int], given: tuple[Any, ...], angle: float, most: int) -> Any:
    """Return the record of a run by its row or its start, None for UNKNOWN. Raises OutOfRange.

    A short run is made by Python, which would wait for numba longer than it runs.
    """
    if not (compiles_now() or (_runs[0] > _MANY and can_compile())):
        few = min(_FEW, most) if can_compile() else most
        try:
            rows, end = _with_room(solve, given, few, few)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            raise left_range(_FLOAT64) from None
        if len(rows) <= few or few == most:
            return _record(rows.copy(), end) if len(rows) else None
    rows, end = _with_room(compiled(solve), given, _room_for(angle, most), most)
    return _record(rows, end) if len(rows) else None


def _record(rows: Any, end: NDArray[np.float64]) -> Record:
    """Return the record of a run with bounds. Raises OutOfRange."""
    how, events, certain, *_ = end[ROW:].tolist()
    if how == How.OUT_OF_RANGE:
        raise left_range(_FLOAT64)
    return Record(rows, end, _HOWS[int(how)], int(events), certain == 1.0)


def begin_in_rows(scene: Scene) -> tuple[Begun, Errors, tuple[Number, ...]]:
    """Return how a scene begins in binary64, each number rounded once, its errors and given numbers.

    It is made once and kept with the scene.
    """
    if "begun" not in scene.made:
        begun, given = begin_exactly(scene, _FLOAT64)
        scene.made["begun"] = begun, initial(begun, 0.0), given
    found: tuple[Begun, Errors, tuple[Number, ...]] = scene.made["begun"]
    return found


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
