"""The engine in float64 and in double-double: one loop over pieces, steps and events, compiled where numba is there.

    next event    the guard's first root over a step, from Taylor coefficients that are linear in z (next_event.py)
    evolve        the state, and the set of its errors, to the event or to the end of the step (evolve.py)
    resolve       which mode follows on v1 = v2, if the error bounds leave no doubt (resolve.py)
    record        a row for the start of every segment (record.py)

Both precisions are one loop: where `wide`, numbers carry a low part, roots are isolated in float64 all the same, and
only coefficients, values and Newton's last steps are formed in pairs. A step has so many Taylor terms that truncation
is below rounding. Nothing is sampled; what the bounds leave open ends the run as DOUBT. What a number may be off by is
counted in roundings of the terms that it is a sum of, and carried by error_set.py.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.linear.columns import Constants, Drive, Room, begin, expand, force_columns, make_room
from numerics.linear.error_set import box, norm_of
from numerics.linear.evolve import evolve, long_step, rest_is_calm, slid_and_damped
from numerics.linear.first_root import ROOT, UNDECIDED
from numerics.linear.modes import UNDECIDED as UNDECIDED_MODE
from numerics.linear.next_event import next_event
from numerics.linear.pairs import add, divide
from numerics.linear.record import AT, ROW
from numerics.linear.resolve import errors_after_slip, errors_after_stick, lateness, resolve
from numerics.linear.table import UNIT, WIDE_UNIT, Tables

REACHED, STUCK, EVENT_LIMIT, OUT_OF_RANGE, DOUBT, NO_ROOM, TOO_MANY = 0, 1, 2, 3, 4, 5, 6
"""How a call ended: the first five as in record.How; or more rows, or more steps, are needed."""
MOST_STEPS = 400_000
_MODE, _ORDER, _EVENT, _JUMP, _PIECE = (AT[name] for name in ("mode", "order", "event", "jump", "piece"))
_LOCAL, _LENGTH, _X1, _EXCESS, _LATE = (AT[name] for name in ("local", "length", "x1", "excess", "late"))
_ERRORS = AT["x1_error"]
_HOW, _EVENTS, _CERTAIN, _FRICTION, _VISCOUS, _LOST = (
    AT[name] for name in ("how", "events", "certain", "friction", "viscous", "dissipated_error")
)


@compilable
def record(
    pair: Constants,
    room: Room,
    row: Any,
    codes: tuple[int, int, bool, bool, int],
    u: tuple[float, float, float],
    b: float,
    N: float,
    late: float,
) -> None:
    """Write a row: the state at the clock, its bounds, and what else record.py says."""
    mode, order, is_event, is_jump, piece = codes
    row[_MODE], row[_ORDER], row[_PIECE] = mode, order, piece
    row[_EVENT], row[_JUMP] = 1.0 if is_event else 0.0, 1.0 if is_jump else 0.0
    for i in range(2):
        row[_LOCAL + i], row[_LENGTH + i], row[_EXCESS + i] = room.clock[0, i], room.clock[1, i], math.nan
        for k in range(4):
            row[_X1 + 2 * k + i] = room.y[k, i]
    row[_LATE] = late
    E, R, scale, v = room.E, room.R, room.scale, abs(room.y[1, 0])
    # within `late` of an event either mode may act; only the stick of the literal law may need more than b
    force = u[2] + pair.a2 * abs(room.y[0, 0]) + pair.a1 * v
    most = (force + b) / pair.m1 + b / pair.m2
    push = max(b / pair.m2, force / pair.mass) if pair.literal else b / pair.m2
    far = (v + most * late) * late
    v1, v2 = min(box(E, R, 1), N) / scale[1], min(box(E, R, 3), N) / scale[3]
    if late > 0.0:
        v1 = v2 = min(v1 + most * late, v2 + push * late)
    row[_ERRORS], row[_ERRORS + 1] = min(box(E, R, 0), N) / scale[0] + far, v1
    row[_ERRORS + 2], row[_ERRORS + 3] = box(E, R, 2) / scale[2] + far, v2
    row[_ERRORS + 4] = 0.0


@compilable
def calm_rest(
    pair: Constants, drive: Drive, tables: Tables, room: Room, piece: int, b: float, N: float, wide: bool
) -> tuple[bool, float, float, float]:
    """Stick through the rest of a piece at once, if nothing can end it; return whether it did, the work of damping,

    a bound on its error, and N.
    """
    if not (pair.literal or rest_is_calm(pair, drive, room, piece, b, N)):
        return False, 0.0, 0.0, N
    damped, size, added = long_step(pair, tables, room, drive, piece, (drive.places[piece, 4], 1), wide)
    N += added
    # of the difference of two motions damping takes at most N^2/2, all told
    lost = 64.0 * UNIT * pair.a1 * size + N * (math.sqrt(2.0 * pair.a1 * abs(damped)) + N / 2.0)
    expand(room, drive, tables, piece, 0)
    return True, pair.a1 * damped, lost, norm_of(room.E, room.R)


@compilable
def loss_error(
    pair: Constants, room: Room, mode: int, b: float, N: float, step: tuple[float, float, float, float]
) -> float:
    """Return a bound on the error of what friction and viscosity take over a step of this time, and int v1^2 dt."""
    time, size, damped, terms = step
    lost = (b * pair.kappa if mode != 0 else 0.0) * N * time + UNIT * (8.0 * b * size + 64.0 * pair.a1 * terms)
    if pair.a1 > 0.0:
        speed = math.sqrt(damped / time) + (abs(room.y[1, 0]) if damped > 0.0 else 0.0)
        lost += pair.a1 * time * N / room.scale[1] * (4.0 * speed + N / room.scale[1])
    return lost


@compilable_with(makes_arrays=True, forceinline=False)
def follow(
    pair: Constants,
    drive: Drive,
    tables: Tables,
    start: Any,
    is_decided: bool,
    clear_until: float,
    most: int,
    wide: bool,
    rows: Any,
    end: Any,
) -> tuple[int, int]:
    """Follow the modes (follow_in), all rows kept, in a room of its own."""
    room, spare = make_room(tables.rows.shape[4], tables.rows.shape[5]), np.empty(ROW)
    return follow_in(
        room, spare, pair, drive, tables, start, is_decided, clear_until, most, wide, True, True, rows, end
    )


@compilable_with(forceinline=False)
def follow_in(
    room: Room,
    spare: Any,
    pair: Constants,
    drive: Drive,
    tables: Tables,
    start: Any,
    is_decided: bool,
    clear_until: float,
    most: int,
    wide: bool,
    keeps_all: bool,
    has_ledger: bool,
    rows: Any,
    end: Any,
) -> tuple[int, int]:
    """Follow the modes from a start (a row) to the end of the last piece; return (how, rows written).

    `is_decided`: the mode and the order of the start are known; else they follow from its velocities and load. Up to
    `clear_until` (time in the first piece) no event happens. `most` events at most. Where rows have no room for one
    more, NO_ROOM if `keeps_all`, else it is left out. Without `has_ledger` what friction and viscosity took is nan.
    """
    y, clock = room.y, room.clock
    N = begin(room, pair, start, WIDE_UNIT if wide else UNIT)
    mode, order, piece, edge_side = int(start[_MODE]), int(start[_ORDER]), int(start[_PIECE]), 1
    if not is_decided and (y[1, 0] != y[3, 0] or y[1, 1] != y[3, 1]):
        gap = (y[1, 0] - y[3, 0]) + (y[1, 1] - y[3, 1])
        mode, order, is_decided = (1 if gap > 0.0 else -1), 0, True
    decide, is_new, is_event, is_jump, ended = not is_decided, True, False, True, 0
    late = slope = off = 0.0
    since = 1e300  # time since an exit, if this slip began with one
    count = events = steps = last_event = 0
    slid_work = damped_work = lost = 0.0 if has_ledger else math.nan
    slid = size = damped = terms = 0.0
    is_calm, look, entered = False, 0, 0  # is the rest of the piece stick; when to look next, and since when it sticks
    how = DOUBT
    while True:
        b, u = drive.b[piece, 0], force_columns(room, drive, piece, late, wide)
        # resolve
        if decide:  # v1 = v2: at the start, after a slip, or where u or b has jumped in stick
            after = resolve(pair, room, u, b, N, late)
            if after == UNDECIDED_MODE or (ended != 0 and after == ended):
                break
            if ended != 0:
                lost += b * late * errors_after_slip(pair, room, ended, after, u, b, late, slope)
                N = min(N, norm_of(room.E, room.R))
            is_event = is_decided and after != mode
            mode, order, decide, is_decided, is_new = after, (1 if after != 0 else 0), False, True, True
            since = 1e300
        elif off > 0.0:  # an exit
            N += errors_after_stick(pair, room, u, late, slope, off)
            off = 0.0
        # record
        if is_new:
            if is_event and events == most:
                how = EVENT_LIMIT
                break
            if keeps_all and count == rows.shape[0]:
                return NO_ROOM, count
            events += 1 if is_event else 0
            may_end = events == most and (is_event or count == 0)
            if count < rows.shape[0] or may_end:
                row = rows[count] if count < rows.shape[0] else spare
                record(pair, room, row, (mode, order, is_event, is_jump, piece), u, b, N, late)
                if may_end:
                    for k in range(ROW):
                        end[k] = row[k]
                    end[_FRICTION], end[_VISCOUS], end[_LOST] = slid_work, damped_work, lost
            if is_event or count == 0:
                last_event = count
            count += 1
            clock[1, 0] = clock[1, 1] = 0.0
            is_new, is_event, is_jump, ended, late = False, False, False, 0, 0.0
            is_calm, look, entered = False, steps + 1, steps
            edge_side = 1 if u[0] - pair.a2 * y[0, 0] - pair.a1 * y[1, 0] > 0.0 else -1
        # next event
        steps += 1
        if steps > MOST_STEPS:
            how = TOO_MANY
            break
        kind, side = drive.places[piece, 4], 1 if mode == 0 else 0
        h = tables.h[kind, side]
        expand(room, drive, tables, piece, mode)
        if mode == 0 and order == 0 and steps >= look and drive.length[piece, 0] - clock[0, 0] > 8.0 * h:
            look = 2 * steps - entered + 1  # seldom, where it stays in vain
            is_calm, taken, error, N = calm_rest(pair, drive, tables, room, piece, b, N, wide)
            damped_work, lost = damped_work + taken, lost + error
        left, left_low = add(drive.length[piece, 0], drive.length[piece, 1], -clock[0, 0], -clock[0, 1])
        is_last = left <= h
        to, to_low = (1.0, 0.0) if not is_last else divide(left, left_low, h, 0.0)
        clear_to = 2.0 if is_calm else 0.0
        if count == 1 and clear_until > clock[0, 0] + 1e-9 * h:
            clear_to = (clear_until - clock[0, 0]) / h
        ahead = next_event(pair, drive, tables, room, piece, (mode, order, edge_side), since, N, to, clear_to, wide)
        if ahead.how == UNDECIDED:
            break
        is_root = ahead.how == ROOT
        s = (to, to_low) if not is_root and ahead.high == to else (ahead.high, ahead.low)
        is_last = is_last and not is_root and ahead.high == to
        # evolve
        if has_ledger:
            slid, size, damped, terms = slid_and_damped(pair, tables, room, (kind, side), mode, s[0])
        time, added = evolve(pair, tables, room, (kind, side), mode, s, is_root, wide)
        N, since, order = N + added, since + time, 0
        if has_ledger:
            slid_work, damped_work = slid_work + b * slid, damped_work + pair.a1 * damped
            its_error = loss_error(pair, room, mode, b, N, (time, size, damped, terms))
            lost += its_error + 2.0 * UNIT * (slid_work + damped_work)
        if not abs(y[0, 0]) + abs(y[1, 0]) + abs(y[2, 0]) + abs(y[3, 0]) + N < 1e300:
            how = OUT_OF_RANGE
            break
        if is_root:
            slope = ahead.slope
            late, off, added = lateness(pair, room, ahead, mode, b, since, N)
            N += added
            if mode != 0:
                ended, decide = mode, True
            else:
                mode, order, since, is_event, is_new = ahead.side, 2, 0.0, True, True
            if ahead.room * h < 16.0 * late or (to - s[0]) * h < 4.0 * late:
                break
        elif is_last:
            if piece + 1 == drive.places.shape[0]:
                how = STUCK if is_calm or (mode == 0 and pair.literal) else REACHED
                break
            piece += 1
            clock[0, 0] = clock[0, 1] = 0.0
            decide, is_new, is_jump = mode == 0 and drive.places[piece, 5] == 1, True, True
    if how == EVENT_LIMIT:
        count = last_event + 1
    else:
        record(pair, room, end, (mode, 0, False, False, piece), (0.0, 0.0, 0.0), 0.0, N, 0.0)
        end[_FRICTION], end[_VISCOUS], end[_LOST] = slid_work, damped_work, lost
    end[_HOW], end[_EVENTS], end[_CERTAIN] = how, events, 1.0
    end[_FRICTION + 1] = end[_VISCOUS + 1] = 0.0
    return how, count
