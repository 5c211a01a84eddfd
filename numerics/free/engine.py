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
from numerics.linear.record import AT, END_ROW, ROW, How, Knot, Record
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
    room = _room(row.item(16) * math.sqrt(row.item(4) / row.item(0)), max_events)
    rows = _with_room(room, lambda rows: solve(row, literal, max_events, rows, end))
    return None if rows is None else _record(rows, end, Float64(), progress)


def _room(angle: float, max_events: int) -> int:
    """Return for how many events there is room at first, if body 1 alone turns by so many radians."""
    return int(min(max_events, 16 + _EVENTS_PER_TURN * min(angle / math.pi, 1e6)))


def _with_room(room: int, solve: Callable[[NDArray[np.float64]], int]) -> NDArray[np.float64] | None:
    """Return the rows of a run that is made again where there is no room for all its events; None for UNKNOWN."""
    while True:
        rows = np.empty((room + 1, ROW))
        room = solve(rows)
        if room < len(rows):
            return rows[: room + 1] if room != UNKNOWN else None


def _run_in_rows(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None) -> Record:
    """Run in binary64, by its row where it can be, or in double-double."""
    if isinstance(arithmetic, DoubleDouble):
        _runs[0] += _WIDE_RUN
        begun, given, carried = _begun_wide(scene, arithmetic)
    else:
        _runs[0] += 1
        row = scene_row(scene) if compiles_now() or (_runs[0] > _MANY and can_compile()) else None
        found = None if row is None else run_row(row, scene.law is Law.THREE_VALUED_SGN, max_events, progress)
        if found is not None:
            return found
        begun, given = begin_exactly(scene, arithmetic)
        carried = initial(begun.at, begun.start, begun.V1, begun.V2)
    rows, end = _from_start(begun, carried, given, max_events, scene, progress)
    return _record(rows, end, arithmetic, progress)


def _begun_wide(scene: Scene, arithmetic: DoubleDouble) -> tuple[Begun, tuple[Pair, ...], Carried]:
    """Return how a scene begins, its given numbers, and the errors of these; made once and kept with the scene."""
    if "wide" not in scene.made:
        with arithmetic.context():
            begun, given = (in_halves(one, arithmetic.halves) for one in begin_exactly(scene, arithmetic))
        scene.made["wide"] = begun, given, initial(begun.at, begun.start, begun.V1, begun.V2)
    found: tuple[Begun, tuple[Pair, ...], Carried] = scene.made["wide"]
    return found


def in_halves(record: Any, halves: Callable[[Any], Any]) -> Any:
    """Return a record with every number as a pair."""
    if isinstance(record, (bool, int, float)):
        return record
    if not isinstance(record, tuple):
        return Pair(*halves(record))
    made = [in_halves(one, halves) for one in record]
    return type(record)(*made) if hasattr(record, "_fields") else tuple(made)


def _from_start(
    begun: Begun,
    carried: Carried,
    given: tuple[Number, ...],
    max_events: int,
    scene: Scene,
    progress: Progress | None,
) -> tuple[NDArray[np.float64] | None, NDArray[np.float64]]:
    """Return the rows of a run from a start: a short one by Python, which would wait for numba longer than it runs."""
    end = np.empty(END_ROW)
    if not (compiles_now() or (_runs[0] > _MANY and can_compile())):
        few = min(_FEW, max_events) if can_compile() else max_events
        growing, plain = _Growing(few + 1, float(scene.until), progress), end.tolist()
        try:
            count = solve_start(begun, carried, given, few, growing, plain)
        except (ArithmeticError, ValueError):  # plain Python has no nan to carry on with
            end[AT["how"]] = How.OUT_OF_RANGE
            return np.empty((0, ROW)), end
        if count < few or few == max_events:
            return np.array(growing.rows), np.array(plain)
    solve = compiled(solve_start)
    room = _room(as_float(begun.horizon) / as_float(begun.at.sqrt_q), max_events)
    return _with_room(room, lambda rows: solve(begun, carried, given, max_events, rows, end)), end


class _Growing:
    """Rows for interpreted code: a row is made when it is first written; `progress` hears of every thousandth."""

    def __init__(self, most: int, until: float, progress: Progress | None) -> None:
        self.rows: list[list[float]] = []
        self._most, self._until, self._progress = most, until, progress

    def __len__(self) -> int:
        return self._most

    def __getitem__(self, index: int) -> list[float]:
        if self._progress is not None and index % 1000 == 999:
            self._progress(index, self.rows[-1][AT["local"]] / self._until)
        self.rows.append([0.0] * ROW)
        return self.rows[index]


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
