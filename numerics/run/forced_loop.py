"""The loop under a force: locate, arrive, decide, record, from knot to knot. It never samples.

One text for every arithmetic. A row is the start of a segment; an event is a row at which the mode has changed.
"""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.float64 import UNIT, WIDTH, ZERO, finite, middle, put, rough, size, spread
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text, text_apart
from numerics.flows.forced_records import Drive, Pair, Start
from numerics.motion.codes import EVENT_LIMIT, MOVING, OUT_OF_RANGE, REACHED, STUCK
from numerics.motion.forced import (
    CALM,
    DOUBTFUL,
    GUARD,
    TOO_FAR,
    Knot,
    Seen,
    after_jump,
    after_slip,
    after_stick,
    arrive,
    locate,
    next_piece,
    norm_of,
    seen,
    slid,
    with_window,
)

OPEN, TOO_FAST = 5, 6
"""How a run ended: in front of something that these numbers do not decide, or that is too many steps away."""


@text
def run_forced(
    pair: Pair, drive: Drive, start: Start, most: int, events: int, rows: Any
) -> tuple[int, int, int, Start, Seen]:
    """Follow the modes from a start to the end of the last piece; `most` events at most, of which `events` were before.

    Returns (how it ended, rows written, events, the state there, its errors); MOVING where there is no more room for
    rows: call it again from there.
    """
    count, keep, last = 0, len(rows), len(drive.places) - 1
    while True:
        knot = locate(pair, drive, start)
        if knot.kind in (DOUBTFUL, TOO_FAR):
            return (OPEN if knot.kind == DOUBTFUL else TOO_FAST), count, events, start, at_horizon(pair, start)
        if knot.kind == GUARD and events == most:
            return EVENT_LIMIT, count, events, start, at_horizon(pair, start)
        how, is_event, at, errors = step(pair, drive, start, knot, last)
        if how == MOVING and is_event and events == most:
            return EVENT_LIMIT, count, events, start, at_horizon(pair, start)
        if how != MOVING:
            if how == REACHED and knot.kind == CALM:
                how = STUCK
            return how, count, events, at, errors
        start = at
        record(rows, count, start, errors, is_event, knot.kind != GUARD)
        count += 1
        if is_event:
            events += 1
        if count == keep:
            return MOVING, count, events, start, errors


@text_apart
def step(pair: Pair, drive: Drive, start: Start, knot: Knot, last: int) -> tuple[int, bool, Start, Seen]:
    """Return how the run goes on after a knot, whether the mode changed there, the next start, and its errors."""
    at, here = arrive(pair, drive, start, knot)
    at = rounded(pair, drive, start, at, knot.tau)
    if not finite(at.norm + at.x1 + at.v1 + at.x2 + at.v2):
        return OUT_OF_RANGE, False, at, at_horizon(pair, at)
    b = drive.numbers[drive.places[start.piece][0] + 2]
    if knot.kind == GUARD:
        at = with_window(pair, at, 2 * b, knot.window)
        if start.mode != 0:
            decided, after = after_slip(pair, drive, at, here)
        else:
            decided, after = after_stick(pair, drive, at, knot, here)
        errors = seen(pair, drive, after, knot, start.mode == 0)
        after = slid(pair, after, errors.late)
        return (MOVING if decided else OPEN), True, after, errors
    if start.piece == last:
        return REACHED, False, at, at_horizon(pair, at)
    has_jump = drive.places[start.piece + 1][3] == 1
    at = next_piece(pair, drive, at, knot)
    errors = at_horizon(pair, at)
    if start.mode != 0 or not has_jump:
        return MOVING, False, at, errors
    decided, after = after_jump(pair, drive, at, here)
    return (MOVING if decided else OPEN), after.mode != start.mode, after, errors


@text
def rounded(pair: Pair, drive: Drive, start: Start, at: Start, tau: Number) -> Start:
    """Return a start whose errors include that the parameters are rounded: forces are off by their roundings."""
    x, v = max(abs(rough(start.x1)), abs(rough(at.x1))), max(abs(rough(start.v1)), abs(rough(at.v1)))
    swing = pair.stick if start.mode == 0 else pair.slip
    b, reach = rough(drive.numbers[drive.places[start.piece][0] + 2]), v * min(rough(tau), 1.0 / swing.rate)
    force = 4.0 * UNIT * (rough(pair.a2) * (x + reach) + 2.0 * rough(pair.a1) * v + 2.0 * b)
    return with_window(pair, at, force + ZERO, tau)


@text
def rounded_start(
    pair: Pair,
    mode: int,
    order: int,
    piece: int,
    times: tuple[Number, Number],
    state: tuple[Number, Number, Number, Number],
) -> Start:
    """Return a start from numbers that were rounded once: the time in the piece, `quiet`, and the state."""
    x1, v1, x2, v2 = state
    off = norm_of(pair, spread(x1) + UNIT * size(x1), spread(v1) + UNIT * size(v1), spread(v2) + UNIT * size(v2))
    local, quiet = times
    place = spread(x2) + UNIT * size(x2) + spread(x1) + UNIT * size(x1)
    return Start(
        mode, order, piece, middle(local), middle(x1), middle(v1), middle(x2), middle(v2), off, place, middle(quiet)
    )


@text
def at_horizon(pair: Pair, at: Start) -> Seen:
    """Return the errors of a state whose time is exact."""
    v2 = at.norm / pair.root_m2
    return Seen(0 * at.norm, at.norm / pair.root_a2, at.norm / pair.root_m1, at.place + at.norm / pair.root_a2, v2)


@text
def record(rows: Any, index: int, at: Start, errors: Seen, is_event: bool, is_jump: bool) -> None:
    """Write the start of a segment to its row (trajectory/forced_record.py)."""
    row = rows[index]
    row[0], row[1], row[2] = float(at.mode), 1.0 if is_event else 0.0, 1.0 if is_jump else 0.0
    row[3], row[4] = float(at.piece), float(at.order)
    put(row, 5, (at.local, at.x1, at.v1, at.x2, at.v2, at.norm, at.place))
    put(row, 5 + 7 * WIDTH, (errors.late, errors.x1, errors.v1, errors.x2, errors.v2))
