"""The engine in float64: one loop over steps and events, compiled where numba is there.

    next event    the first root of a guard over a step, from Taylor coefficients that are linear in z (next_event.py)
    evolve        the state and its error to the event, or to the end of the step (evolve.py)
    resolve       which mode follows an event, if the error leaves no doubt (resolve.py)
    record        a row for the start of every segment (record.py)

A step has so many Taylor terms that truncation is below rounding. Nothing is sampled; what the bound leaves open ends
the run as DOUBT. The error of the state is one number N: no mode and no event makes it larger, but for friction of the
state (evolve.grown), so that it is the sum of what the steps round and of what events are misplaced. Only the clock
keeps what its roundings leave out.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with, inlined
from numerics.linear.calm import Calm, look_ahead, step_over
from numerics.linear.evolve import evolve
from numerics.linear.first_root import ROOT, UNDECIDED
from numerics.linear.model import V2
from numerics.linear.next_event import Next, Step, next_event, step_from
from numerics.linear.record import AT, CODES, ROW, How
from numerics.linear.resolve import (
    CONTACT,
    EXIT,
    NO_MODE,
    NOTHING,
    PIECE,
    StepEnd,
    arrived,
    fastest,
    resolve,
)
from numerics.linear.room import Now, Problems, Run, enter, form_z, place_of, run_of
from numerics.linear.table import OF_V1, OF_V2, STATE, UNIT

REACHED, STUCK, EVENT_LIMIT, OUT_OF_RANGE, DOUBT = map(int, How)
GOES_ON, TOO_MANY = -1, len(How)
"""A call may not have ended yet, or have needed too many steps."""
MOST_STEPS = 400_000
_MODE, _ORDER, _EVENT, _JUMP, _PIECE, _CELL = (AT[name] for name in CODES)
_LOCAL, _REST, _LENGTH = (AT[name] for name in ("local", "local_rest", "length"))
_X1, _LATE, _ERRORS = (AT[name] for name in ("x1", "late", "x1_error"))
_HOW, _EVENTS, _ROWS = AT["how"], AT["events"], AT["rows"]


class Log(NamedTuple):
    """Where a run is recorded: its rows (k, ROW), the row of its end; and of how many events at most.

    A row for the start and for every event; if `keeps_all` for every piece, too. What has no room is left out, but
    counted at the end.
    """

    rows: Any
    end: Any
    most: int
    keeps_all: bool


@compilable_with(forceinline=False)
def follow_all(problems: Problems, space: Any, starts: Any, clear_until: float, logs: Log) -> None:
    """Follow every problem from its start (n, ROW); each has its part of the logs, (n, k, ROW) and (n, END_ROW)."""
    for one in range(len(starts)):
        log = Log(logs.rows[one], logs.end[one], logs.most, logs.keeps_all)
        follow(run_of(problems, one, space), starts[one], clear_until, log)


@inlined
def follow(run: Run, start: Any, clear_until: float, log: Log) -> None:
    """Follow the modes from a start to the end of the last piece.

    Where the start says `jump` its mode follows from velocities and load; else mode and order are known. Up to
    `clear_until` (time in the first piece) no event happens.
    """
    now, event = begin(run, start)
    calm, how = Calm(False, 0, 0), GOES_ON
    for step in range(MOST_STEPS):
        form_z(run, now.piece)
        if event.kind != NOTHING and how == GOES_ON:
            before, now = now, resolve(run, now, event)
            is_event = event.kind == EXIT or (run.counts[0] > 0 and now.mode != before.mode)
            how = DOUBT if now.mode == NO_MODE else record(run, now, event, is_event, log)
            calm = Calm(False, step, step)
        enter(run, now.piece, now.mode)
        calm = look_ahead(run, now, calm, step, how == REACHED)
        if how != GOES_ON:
            break
        now = step_over(run, now, calm)
        to = step_from(run, now, calm.is_calm, clear_until if run.counts[0] == 1 else -1.0)
        ahead = next_event(run, now, to)
        if ahead.how == UNDECIDED:
            how = DOUBT
            break
        now = evolve(run, now, ahead.s)
        now, event, how = arrive(run, now, ahead, to)
    else:
        how = TOO_MANY
    close(run, now, STUCK if how == REACHED and calm.is_calm else how, log)


@compilable
def off_at(start: Any, i: int) -> float:
    """Return by how much a number of a start is off, its rounding included."""
    return UNIT * abs(start[_X1 + i]) + start[_ERRORS + i]


@inlined
def begin(run: Run, start: Any) -> tuple[Now, StepEnd]:
    """Put a start into the room; return where the run is, and what is to be resolved first."""
    norm, N = run.norm, 0.0
    run.counts[:] = 0
    for i, root in enumerate((norm.root_a2, norm.root_m1, 0.0, norm.root_m2)):
        run.y[i] = start[_X1 + i]
        N += root * off_at(start, i)
    x1, x2 = off_at(start, 0), off_at(start, 2)
    run.clock[0, 0], run.clock[0, 1] = start[_LOCAL], start[_REST]
    run.clock[1, :] = 0.0
    order, kind = int(start[_ORDER]), run.drive.places[int(start[_PIECE]), 0] + int(start[_CELL])
    edge = 0 if order >= 0 else 1  # a slip that starts below its ceiling has a negative order
    parted = norm.kappa * N
    now = Now(int(start[_PIECE]), int(start[_MODE]), kind, abs(order), edge, 0.0, N, x1, x2, x1 + x2, parted)
    return now, StepEnd(CONTACT if start[_JUMP] == 1.0 and start[_MODE] == 0.0 else PIECE, 0.0)


@inlined
def arrive(run: Run, now: Now, ahead: Next, step: Step) -> tuple[Now, StepEnd, int]:
    """Return where the run is at the end of a step, what happens there, and how it ends there if it does."""
    y, nothing = run.y, StepEnd(NOTHING, 0.0)
    if not abs(y[0]) + abs(y[1]) + abs(y[2]) + abs(y[3]) + now.N < 1e300:
        return now, nothing, OUT_OF_RANGE
    if ahead.how == ROOT:
        h = run.tables.steps[place_of(now)]
        now, event = arrived(run, now, ahead)
        # of an end of a cell also where a contact may have come before it: then x1 - x2 turns next to it
        is_near = ahead.alone * h < 16.0 * now.late or (step.end - ahead.s) * h < 4.0 * now.late
        return now, event, DOUBT if is_near or run.norm.steep * now.late > 0.25 else GOES_ON
    if not step.is_last or ahead.s != step.end:
        return now, nothing, GOES_ON
    places, piece = run.drive.places, now.piece + 1
    if piece == places.shape[0]:
        return now, nothing, STUCK if now.mode == 0 and run.literal else REACHED
    run.clock[0, :] = 0.0
    kind = places[piece, 0] + now.kind - places[now.piece, 0]  # of the same cell
    what = CONTACT if places[piece, 4] == 1 or (now.mode == 0 and places[piece, 3] == 1) else PIECE
    return (
        Now(piece, now.mode, kind, 0, now.edge, now.late, now.N, now.far, now.far_2, now.apart, now.speed_apart),
        StepEnd(what, 0.0),
        GOES_ON,
    )


@inlined
def record(run: Run, now: Now, event: StepEnd, is_event: bool, log: Log) -> int:
    """Record the start of a segment, if the log has room for it; the last event that is asked for is an end, too."""
    counts, room_for, may_end = run.counts, log.rows.shape[0], False
    count = int(counts[0])
    if is_event and counts[1] == log.most:
        return EVENT_LIMIT
    begins = is_event or count == 0
    if begins:
        counts[1], counts[2] = counts[1] + (1 if is_event else 0), count
        may_end = counts[1] == log.most
    if may_end or (count < room_for and (begins or log.keeps_all)):
        row = log.end if may_end else log.rows[count]
        write(run, row, now, event.late)
        row[_ORDER], row[_EVENT] = now.order, 1.0 if is_event else 0.0
        row[_JUMP] = 1.0 if event.kind in (PIECE, CONTACT) else 0.0
        for k in range(ROW if may_end and count < room_for else 0):
            log.rows[count, k] = row[k]
    run.clock[1, :] = 0.0
    counts[0] += 1 if begins or log.keeps_all else 0
    return GOES_ON


@compilable
def write(run: Run, row: Any, now: Now, late: float) -> None:
    """Write the state at the clock, and its bounds: within `late` of an event either mode may act."""
    norm, y = run.norm, run.y
    row[_MODE], row[_PIECE], row[_CELL] = now.mode, now.piece, now.kind - run.drive.places[now.piece, 0]
    row[_LOCAL], row[_REST], row[_LENGTH] = run.clock[0, 0], run.clock[0, 1], run.clock[1, 0]
    for i in range(STATE):
        row[_X1 + i] = y[i]
    row[_LATE] = late
    x1 = min(now.N / norm.root_a2, now.far) if norm.root_a2 > 0.0 else now.far
    v1, v2, far = now.N / norm.root_m1, now.N / norm.root_m2 if norm.root_m2 > 0.0 else 0.0, 0.0
    if norm.root_m2 == 0.0:  # the velocity of the belt, rounded, at a time that is rounded
        rounded = fastest(run, now, OF_V2, 0.0) * abs(run.clock[0, 0])
        v2 = UNIT * (8.0 * run.size[V2] + 2.0 * rounded)
    elif now.mode == 0:  # both velocities are off by the same
        v1 = v2 = now.N / math.sqrt(norm.root_m1 * norm.root_m1 + norm.root_m2 * norm.root_m2)
    if late > 0.0:
        one, two = fastest(run, now, OF_V1, late), fastest(run, now, OF_V2, late)
        v1 = v2 = min(v1 + one * late, v2 + two * late) + abs(y[1] - y[3])
        far = (abs(y[1]) + one * late) * late
    row[_ERRORS], row[_ERRORS + 1], row[_ERRORS + 2], row[_ERRORS + 3] = (
        x1 + far,
        v1,
        min(x1 + now.apart, now.far_2) + far,
        v2,
    )
    row[_ERRORS + 4] = now.N / norm.root_m1


@inlined
def close(run: Run, now: Now, how: int, log: Log) -> None:
    """Write the row of the end, where z is, and how the run ended."""
    end, counts = log.end, run.counts
    if how != EVENT_LIMIT:
        write(run, end, now, 0.0)
        end[_ORDER] = end[_EVENT] = end[_JUMP] = 0.0
    end[_HOW], end[_EVENTS], end[_ROWS] = how, counts[1], counts[2] + 1.0 if how == EVENT_LIMIT else counts[0]
    for k in range(_ROWS + 1, len(end)):
        end[k] = math.nan
