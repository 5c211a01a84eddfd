"""One scene with a force, solved once in one arithmetic: begun exactly, followed in numbers, told as a Trajectory."""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.double_words import DOUBLE_DOUBLE
from numerics.arithmetic.protocol import Arithmetic
from numerics.arithmetic.telling import Telling, can_compile
from numerics.errors import EventUndecided, OutOfRange
from numerics.flows.forced_records import Drive, Pair, Start
from numerics.motion.begin import in_halves
from numerics.motion.codes import EVENT_LIMIT, MOVING, OUT_OF_RANGE
from numerics.motion.forced_exact import ExactKnot, exact_knots
from numerics.motion.forced_pair import pair_of
from numerics.motion.forced_pieces import ExactPieces, drive_of, has_seams, pieces_of
from numerics.run.forced_loop import OPEN, TOO_FAST, at_horizon, record, rounded_start, run_forced
from numerics.scene import Scene
from numerics.trajectory.forced import ForcedTrajectory
from numerics.trajectory.forced_record import ForcedRecord, row_length
from numerics.trajectory.forced_units import in_seconds, in_unit, unit_of_time

Progress = Callable[[int, float], None]
_FEW, _MANY = 6000, 65536
"""Rows that Python writes before it is worth to wait for numba; rows between two words to `progress`."""
_HAS_BOUNDS = {"float64", "double-double"}


class _Told(NamedTuple):
    """A scene in numbers: how texts are told, the pair and its table, the starts that are known exactly."""

    arithmetic: Arithmetic
    telling: Telling
    width: int
    pair: Pair
    drive: Drive
    begun: list[Start]


def run_forced_scene(
    scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None
) -> ForcedTrajectory:
    """Solve a scene with a force once, at the arithmetic's working precision. Raises EventUndecided, OutOfRange."""
    unit = unit_of_time(scene)
    try:
        record = _recorded(scene if unit == 1 else in_unit(scene, unit), arithmetic, max_events, progress)
    except OutOfRange:
        raise
    except (ZeroDivisionError, OverflowError):
        raise OutOfRange(
            "rates of this scene lie so far apart that floats cannot choose steps; bring a1/m1, sqrt(a2/m1), omega and "
            "1/until within 1e+-60 of each other"
        ) from None
    if unit != 1:
        with arithmetic.context():
            record = in_seconds(record, unit, arithmetic)
    return ForcedTrajectory(scene, arithmetic, record, bounded=arithmetic.name in _HAS_BOUNDS)


def _recorded(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None) -> ForcedRecord:
    """Return what a run leaves behind, its times in the unit in which the scene counts them."""
    pieces = pieces_of(scene, with_seams=has_seams(arithmetic))
    knots = exact_knots(scene, pieces)
    with arithmetic.context():
        told = _in_numbers(scene, pieces, knots, arithmetic)
        events = [index for index, knot in enumerate(knots) if knot.is_event]
        limit = events[max_events] if len(events) > max_events else len(knots)
        known = list(zip(told.begun, knots, strict=True))[:limit]
        parts: list[Any] = [[_row(told, start, is_event=knot.is_event, is_jump=knot.is_jump) for start, knot in known]]
        how, last, errors = EVENT_LIMIT, told.begun[limit - 1], None
        if limit == len(knots):
            hear = _heard(progress, pieces, scene)
            how, last, errors = _followed(told, parts, (max_events, len(events)), hear)
        end: Any = _row(told, last, errors=errors)
    _require_answer(how, told, last)
    if how == EVENT_LIMIT:
        parts, end = _up_to_last_event(parts)
    kept, end = (_joined(parts), np.array(end)) if arithmetic.name == "float64" else (list(chain(*parts)), end)
    return ForcedRecord(kept, end, how, told.width)


def _up_to_last_event(parts: list[Any]) -> tuple[list[Any], Any]:
    """Return the rows up to the last event, where a cap on events ends a run, and that row again for the end."""
    rows = [row for part in parts for row in part]
    while len(rows) > 1 and rows[-1][1] == 0.0:
        rows.pop()
    return [rows], rows[-1]


def _joined(parts: list[Any]) -> Any:
    """Return rows of binary64 as one array."""
    return np.concatenate([np.array(part, dtype=float).reshape(-1, row_length(1)) for part in parts])


def _in_numbers(scene: Scene, pieces: ExactPieces, knots: list[ExactKnot], arithmetic: Arithmetic) -> _Told:
    """Return what a run starts from; double-double numbers as their halves."""
    pair, drive = pair_of(scene, arithmetic), drive_of(scene, pieces, arithmetic)
    if not isinstance(arithmetic, DoubleDouble):
        begun = [_start(knot, pair, arithmetic, arithmetic.telling) for knot in knots]
        return _Told(arithmetic, arithmetic.telling, 1, pair, drive, begun)
    halves = arithmetic.halves
    pair, drive = in_halves(pair, halves), Drive([halves(one) for one in drive.numbers], drive.places)
    begun = [_start(knot, pair, arithmetic, DOUBLE_DOUBLE, halves) for knot in knots]
    return _Told(arithmetic, DOUBLE_DOUBLE, 2, pair, drive, begun)


def _start(
    knot: ExactKnot, pair: Pair, arithmetic: Arithmetic, telling: Telling, halves: Callable[[Any], Any] | None = None
) -> Start:
    """Return an exact knot in numbers: points, and the errors of their rounding."""
    numbers = [arithmetic.number(knot.local), arithmetic.number(knot.quiet)]
    numbers += [one.number(arithmetic) for one in (knot.x1, knot.v1, knot.x2, knot.v2)]
    local, quiet, x1, v1, x2, v2 = numbers if halves is None else map(halves, numbers)
    begun: Start = telling(rounded_start)(
        pair, knot.mode, min(knot.order, 3), knot.piece, (local, quiet), (x1, v1, x2, v2)
    )
    return begun


def _row(told: _Told, at: Start, errors: Any = None, *, is_event: bool = False, is_jump: bool = False) -> list[Any]:
    """Return the row of a start whose time is exact, or has these errors."""
    row = [[0.0] * row_length(told.width)]
    bounds = told.telling(at_horizon)(told.pair, at) if errors is None else errors
    told.telling(record)(row, 0, at, bounds, is_event, is_jump)
    return row[0]


def _followed(
    told: _Told, parts: list[Any], counts: tuple[int, int], hear: Callable[[int, Any], None]
) -> tuple[int, Start, Any]:
    """Add the rows, in parts, of a run from the last exact start on; return how it ended, the last state, its errors.

    binary64 is compiled where that has been done already, or after many rows; the bits are the same.
    """
    most, events = counts
    last, how, errors = told.begun[-1], MOVING, None
    compiles, size = told.telling.name == "float64" and can_compile(), row_length(told.width)
    while how == MOVING:
        if compiles and (sum(map(len, parts)) >= _FEW or told.telling.has_compiled(run_forced)):
            drive = Drive(np.array(told.drive.numbers), np.array(told.drive.places, dtype=np.int64))
            told = told._replace(drive=drive) if isinstance(told.drive.numbers, list) else told
            part: Any = np.empty((_MANY, size))
            run = told.telling.compiled(run_forced)
        else:
            part, run = [[0.0] * size for _ in range(min(_FEW, 1000))], told.telling(run_forced)
        try:
            how, count, events, last, errors = run(told.pair, told.drive, last, most, events, part)
        except (ZeroDivisionError, OverflowError, ValueError):  # plain Python has no nan to carry on with
            return OUT_OF_RANGE, last, errors
        parts.append(part[:count])
        hear(events, part[:count])
    return how, last, errors


def _heard(progress: Progress | None, pieces: ExactPieces, scene: Scene) -> Callable[[int, Any], None]:
    """Return what tells `progress` how far a run is."""

    def hear(events: int, rows: Any) -> None:
        if progress is not None and len(rows):
            progress(events, float(pieces[int(rows[-1][3])].start / scene.until))

    return hear


def _require_answer(how: int, told: _Told, last: Start) -> None:
    """Raise what says why a run could not go on."""
    name, digits = told.arithmetic.name, told.arithmetic.digits
    if how == OUT_OF_RANGE:
        raise OutOfRange(f'a number of this scene left the range of {name} on the way; use arithmetic="ball"')
    at = told.drive.numbers[told.drive.places[last.piece][0]] + last.local
    shown = f"{told.telling.words['rough'](at):.6g}" if name != "float64" else f"{at:.6g}"
    if how == TOO_FAST:
        raise OutOfRange(
            f"the mode at t = {shown} s would take more than a million steps; shorten the horizon, leave a fast sine "
            "out, or begin on the tie that it begins next to"
        )
    if how == OPEN:
        raise EventUndecided(
            "which event comes next under this force, or does its guard only touch?", f"after t = {shown} s", digits
        )
