"""One scene with a force, solved once in one arithmetic: begun exactly, followed in numbers, told as a Trajectory."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import EventUndecided, OutOfRange
from numerics.flows.forced_records import Drive, Pair, Start
from numerics.motion.codes import EVENT_LIMIT, OUT_OF_RANGE
from numerics.motion.forced_exact import ExactKnot, exact_knots
from numerics.motion.forced_pair import pair_of
from numerics.motion.forced_pieces import drive_of, pieces_of
from numerics.run.forced_loop import OPEN, at_horizon, record, rounded_start, run_forced
from numerics.run.rows import Growing
from numerics.scene import Scene
from numerics.trajectory.forced import ForcedTrajectory
from numerics.trajectory.forced_record import ForcedRecord, row_length

Progress = Callable[[int, float], None]


def run_forced_scene(
    scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None
) -> ForcedTrajectory:
    """Solve a scene with a force once, at the arithmetic's working precision. Raises EventUndecided, OutOfRange."""
    pieces = pieces_of(scene, with_seams=arithmetic.name == "float64")
    knots = exact_knots(scene, pieces)
    telling = arithmetic.telling

    def told(index: int) -> None:
        if progress is not None:
            piece = pieces[int(room.rows[-1][3])]
            progress(int(sum(row[1] for row in room.rows[-index:])), float(piece.start / scene.until))

    with arithmetic.context():
        pair, drive = pair_of(scene, arithmetic), drive_of(scene, pieces, arithmetic)
        begun = [_start(knot, pair, arithmetic) for knot in knots]
        events = [index for index, knot in enumerate(knots) if knot.is_event]
        cut = len(events) > max_events
        if cut:
            begun = begun[: events[max_events]]
        room = Growing(row_length(1), 2**62)
        for index, start in enumerate(begun):
            telling(record)(
                room, index, start, telling(at_horizon)(pair, start), knots[index].is_event, knots[index].is_jump
            )
        if cut:
            how, last, errors = EVENT_LIMIT, begun[-1], telling(at_horizon)(pair, begun[-1])
        else:
            rows = _After(room, len(begun), told)
            how, _, _, last, errors = telling(run_forced)(pair, drive, begun[-1], max_events, len(events), rows)
        end = Growing(row_length(1), 1)
        telling(record)(end, 0, last, errors, False, False)
    if how == OUT_OF_RANGE:
        raise OutOfRange(
            f'a number of this scene left the range of {arithmetic.name} on the way; use arithmetic="ball"'
        )
    if how == OPEN:
        raise EventUndecided(
            "which event comes next under this force, or does the guard only touch?",
            f"after t = {_time(drive, last, arithmetic)} s",
            arithmetic.digits,
        )
    return ForcedTrajectory(
        scene, arithmetic, ForcedRecord(room.rows, end.rows[0], how, 1), bounded=_bounded(arithmetic)
    )


class _After:
    """Rows after those that are there already; `progress` hears of every thousandth."""

    def __init__(self, rows: Growing, first: int, progress: Callable[[int], None] | None) -> None:
        self._rows, self._first, self._progress = rows, first, progress

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, index: int) -> list[Any]:
        if self._progress is not None and index % 1000 == 999:
            self._progress(index)
        return self._rows[self._first + index]


def _bounded(arithmetic: Arithmetic) -> bool:
    return arithmetic.name in {"float64", "double-double"}


def _start(knot: ExactKnot, pair: Pair, arithmetic: Arithmetic) -> Start:
    """Return an exact knot in numbers: points, and the errors of their rounding."""
    number = arithmetic.number
    x1, v1, x2, v2 = (one.number(arithmetic) for one in (knot.x1, knot.v1, knot.x2, knot.v2))
    return arithmetic.telling(rounded_start)(
        pair, knot.mode, min(knot.order, 3), knot.piece, (number(knot.local), number(knot.quiet)), (x1, v1, x2, v2)
    )


def _time(drive: Drive, at: Start, arithmetic: Arithmetic) -> str:
    return arithmetic.text(drive.numbers[drive.places[at.piece][0]] + at.local)
