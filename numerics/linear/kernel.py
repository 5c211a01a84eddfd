"""The engine in float64: one loop over steps and events, compiled where numba is there.

    resolve       which mode follows an event, if the error bounds leave no doubt (resolve.py)
    record        a row for the start of every segment (record.py)
    next event    the guard's first root over a step, from Taylor coefficients that are linear in z (next_event.py)
    evolve        the state, and the set of its errors, to the event or to the end of the step (evolve.py)

A step has so many Taylor terms that truncation is below rounding. Nothing is sampled; what the bounds leave open ends
the run as DOUBT. What a number may be off by is counted in roundings of the terms that it is a sum of, and carried by
error_set.py. Only the clock keeps what its roundings leave out: over a long run these would add up.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.linear.calm_stick import Calm, step_over
from numerics.linear.columns import Now, Problem, Room, expand, force_columns, make_room, place_of
from numerics.linear.error_set import box
from numerics.linear.evolve import evolve
from numerics.linear.first_root import ROOT, UNDECIDED
from numerics.linear.modes import UNDECIDED as UNDECIDED_MODE
from numerics.linear.next_event import Next, Step, next_event, step_from
from numerics.linear.record import AT, ROW
from numerics.linear.resolve import CONTACT, EXIT, NOTHING, PIECE, SLIP_END, StepEnd, lateness, resolve
from numerics.linear.table import UNIT

GOES_ON, REACHED, STUCK, EVENT_LIMIT, OUT_OF_RANGE, DOUBT, TOO_MANY = -1, 0, 1, 2, 3, 4, 5
"""How a call ended, if it did: the first five as in record.How; or more steps are needed."""
MOST_STEPS = 400_000
_MODE, _ORDER, _EVENT, _JUMP, _PIECE = (AT[name] for name in ("mode", "order", "event", "jump", "piece"))
_LOCAL, _REST, _LENGTH = (AT[name] for name in ("local", "local_rest", "length"))
_X1, _EXCESS, _LATE = (AT[name] for name in ("x1", "excess", "late"))
_ERRORS = AT["x1_error"]
_HOW, _EVENTS, _CERTAIN, _FRICTION, _VISCOUS, _LOST = (
    AT[name] for name in ("how", "events", "certain", "friction", "viscous", "dissipated_error")
)


class Log(NamedTuple):
    """Where a run is recorded: its rows, the row of its end; and of how many events at most.

    A row for the start and for every event; if `keeps_all` for every piece, too. What has no room is left out.
    """

    rows: Any
    end: Any
    most: int
    keeps_all: bool


@compilable_with(makes_arrays=True, forceinline=False)
def follow(problem: Problem, start: Any, clear_until: float, log: Log) -> tuple[int, int]:
    """Follow the modes (follow_in) in a room of its own."""
    rows = problem.tables.rows
    return follow_in(problem, make_room(rows.shape[3], rows.shape[4]), start, clear_until, log)


@compilable_with(forceinline=False)
def follow_in(problem: Problem, room: Room, start: Any, clear_until: float, log: Log) -> tuple[int, int]:
    """Follow the modes from a start to the end of the last piece; return (how, rows written or left out).

    A start is a row like that of an end: its ledger goes on from what was taken before it.
    Where the start says `jump` its mode follows from velocities and load; else mode and order are known. Up to
    `clear_until` (time in the first piece) no event happens.
    """
    now, event = begin(problem, room, start)
    calm, how = Calm(False, 0, 0), DOUBT
    for step in range(MOST_STEPS):
        u = force_columns(room, problem.drive, now.piece, event.late)
        if event.kind != NOTHING:
            after = resolve(problem, room, now, event, u)
            if after.mode == UNDECIDED_MODE:
                how = DOUBT
                break
            is_event = event.kind == EXIT or (room.counts[0] > 0 and after.mode != now.mode)
            now, calm = after, Calm(False, step, step)
            how = record(problem, room, now, event, is_event, u, log)
            if how != GOES_ON:
                break
        now, calm = step_over(problem, room, now, calm, step)
        to = step_from(problem, room, now, calm.is_calm, clear_until if room.counts[0] == 1 else -1.0)
        expand(problem, room, now)
        ahead = next_event(problem, room, now, to)
        if ahead.how == UNDECIDED:
            how = DOUBT
            break
        now = evolve(problem, room, now, ahead)
        now, event, how = arrive(problem, room, now, ahead, to, calm.is_calm)
        if how != GOES_ON:
            break
    else:
        how = TOO_MANY
    return how, close(problem, room, now, how, log)


@compilable
def begin(problem: Problem, room: Room, start: Any) -> tuple[Now, StepEnd]:
    """Put a start into the room; return where the run is, and what is to be resolved first."""
    pair, y, scale, E = problem.pair, room.y, room.scale, room.E
    scale[0] = scale[2] = math.sqrt(pair.a2)
    scale[1], scale[3] = math.sqrt(pair.m1), math.sqrt(pair.m2)
    E[:, :] = 0.0
    room.R[:] = 0.0
    room.counts[:] = 0
    for i, column in enumerate((_FRICTION, _VISCOUS, _LOST)):
        room.ledger[i] = start[column] if problem.has_ledger else math.nan
    for i in range(4):
        y[i] = start[_X1 + i]
        E[i, i] = (UNIT * abs(y[i]) + start[_ERRORS + i]) * scale[i]
    room.clock[0, 0], room.clock[0, 1] = start[_LOCAL], start[_REST]
    room.clock[1, :] = 0.0
    now = Now(int(start[_PIECE]), int(start[_MODE]), int(start[_ORDER]), 1, 1e300, E[0, 0] + E[1, 1] + E[3, 3])
    return now, StepEnd(CONTACT if start[_JUMP] == 1.0 else PIECE, 0.0, 0.0, 0.0)


@compilable
def arrive(problem: Problem, room: Room, now: Now, ahead: Next, step: Step, is_calm: bool) -> tuple[Now, StepEnd, int]:
    """Return where the run is at the end of a step, what happens there, and how it ends there if it does."""
    (piece, mode, order, edge, since, N), nothing, y = now, StepEnd(NOTHING, 0.0, 0.0, 0.0), room.y
    if not abs(y[0]) + abs(y[1]) + abs(y[2]) + abs(y[3]) + N < 1e300:
        return now, nothing, OUT_OF_RANGE
    if ahead.how == ROOT:
        h = problem.tables.h[place_of(problem, now)]
        late, off, added = lateness(problem.pair, room, ahead, mode, problem.drive.b[piece], since, N)
        is_near = ahead.room * h < 16.0 * late or (step.end - ahead.s) * h < 4.0 * late
        kind = SLIP_END if mode != 0 else EXIT
        if mode == 0:
            mode, order, since = ahead.side, 2, 0.0
        now = Now(piece, mode, order, edge, since, N + added)
        return now, StepEnd(kind, late, ahead.slope, off), DOUBT if is_near else GOES_ON
    if not step.is_last or ahead.s != step.end:
        return now, nothing, GOES_ON
    if piece + 1 == problem.drive.places.shape[0]:
        return now, nothing, STUCK if is_calm or (mode == 0 and problem.pair.literal) else REACHED
    room.clock[0, :] = 0.0
    kind = CONTACT if mode == 0 and problem.drive.places[piece + 1, 5] == 1 else PIECE
    return Now(piece + 1, mode, order, edge, since, N), StepEnd(kind, 0.0, 0.0, 0.0), GOES_ON


@compilable
def record(
    problem: Problem, room: Room, now: Now, event: StepEnd, is_event: bool, u: tuple[float, float, float], log: Log
) -> int:
    """Record the start of a segment, if the log has room for it; the last event that is asked for is an end, too."""
    counts, room_for, may_end = room.counts, log.rows.shape[0], False
    count = counts[0]
    if is_event and counts[1] == log.most:
        return EVENT_LIMIT
    begins = is_event or count == 0
    if begins:
        counts[1], counts[2] = counts[1] + (1 if is_event else 0), count
        may_end = counts[1] == log.most
    if may_end or (count < room_for and (begins or log.keeps_all)):
        row = log.end if may_end else log.rows[count]
        write(problem, room, row, now, event.late, u)
        row[_ORDER], row[_EVENT] = now.order, 1.0 if is_event else 0.0
        row[_JUMP] = 1.0 if event.kind in (PIECE, CONTACT) else 0.0
        for k in range(ROW if may_end and count < room_for else 0):
            log.rows[count, k] = row[k]
    room.clock[1, :] = 0.0
    counts[0] += 1 if begins or log.keeps_all else 0
    return GOES_ON


@compilable
def write(problem: Problem, room: Room, row: Any, now: Now, late: float, u: tuple[float, float, float]) -> None:
    """Write the state at the clock, its bounds, what else record.py says of a row, and what was taken up to an end."""
    pair, b = problem.pair, problem.drive.b[now.piece]
    row[_MODE], row[_PIECE] = now.mode, now.piece
    row[_LOCAL], row[_REST], row[_LENGTH] = room.clock[0, 0], room.clock[0, 1], room.clock[1, 0]
    for i in range(4):
        row[_X1 + i] = room.y[i]
    row[_EXCESS] = math.nan
    row[_LATE] = late
    E, R, scale, v = room.E, room.R, room.scale, abs(room.y[1])
    # within `late` of an event either mode may act; only the stick of the literal law may need more than b
    force = u[2] + pair.a2 * abs(room.y[0]) + pair.a1 * v
    most = (force + b) / pair.m1 + b / pair.m2
    push = max(b / pair.m2, force / pair.mass) if pair.literal else b / pair.m2
    far = (v + most * late) * late
    v1, v2 = min(box(E, R, 1), now.N) / scale[1], min(box(E, R, 3), now.N) / scale[3]
    if late > 0.0:
        v1 = v2 = min(v1 + most * late, v2 + push * late)
    row[_ERRORS], row[_ERRORS + 1] = min(box(E, R, 0), now.N) / scale[0] + far, v1
    row[_ERRORS + 2], row[_ERRORS + 3] = box(E, R, 2) / scale[2] + far, v2
    row[_ERRORS + 4] = 0.0
    if row.shape[0] > ROW:
        row[_FRICTION], row[_VISCOUS], row[_LOST] = room.ledger[0], room.ledger[1], room.ledger[2]


@compilable
def close(problem: Problem, room: Room, now: Now, how: int, log: Log) -> int:
    """Write the row of the end, and return how many rows there are."""
    end, counts = log.end, room.counts
    if how != EVENT_LIMIT:
        write(problem, room, end, now, 0.0, (0.0, 0.0, 0.0))
        end[_ORDER] = end[_EVENT] = end[_JUMP] = 0.0
    end[_HOW], end[_EVENTS], end[_CERTAIN] = how, counts[1], 1.0
    return counts[2] + 1 if how == EVENT_LIMIT else counts[0]
