"""The mode state machine in binary64, with its error bounds, straight into rows (linear/record.py).

next_event -> bounds -> resolve -> record; it never samples. Compiled where numba is installed, one scene or many in one
call; the same functions, interpreted, give the same bits.
"""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import as_float, clock, finite, sign
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import BEFORE_HORIZON
from numerics.free.bounds import ROW_UNIT, Errors, Off, after_event, at_horizon, at_start, before_horizon, initial
from numerics.free.frame import Begun, begin, in_si, is_known
from numerics.free.motion import (
    MOVING,
    OUT_OF_RANGE,
    MotionState,
    event_state,
    mode_of,
    next_event,
    order_of,
    resolve,
    state_at,
)
from numerics.free.slip import Start
from numerics.linear.record import AT, UNKNOWN, How

REACHED, EVENT_LIMIT = int(How.REACHED), int(How.EVENT_LIMIT)
_LOCAL, _ERRORS, _END = (AT[name] for name in ("local", "x1_error", "how"))
_FRICTION, _DISSIPATED = AT["friction"], AT["ledger_error"]
_SMALLEST, _LARGEST = 1e-70, 1e70
"""Beyond them a product of four SI numbers may leave the range of binary64: convert exactly."""
_SUBNORMAL, _TINY = 1e-290, 2.0**-1060
"""Below the first, products lose digits to underflow; never more than the second."""


@compilable
def _record(row: Any, start: Start, event: float, numbers: tuple[Number, ...], errors: Any) -> None:
    """Write a row: local, length, x1, v1, x2, v2, excess, and bounds on the errors of all but length."""
    row[0], row[1], row[2], row[3], row[4] = mode_of(start), order_of(start), event, 0.0, 0.0
    row[_LOCAL], row[_LOCAL + 1] = numbers[0], 0.0
    column = _LOCAL + 2
    for number in numbers[1:]:
        row[column] = number
        column += 1
    for error in errors:
        row[column] = error
        column += 1


@compilable
def _bound(error: float, x: Number, unit: float) -> float:
    """Return a bound with the roundings of the conversion to x, and what products below the normal numbers lost."""
    size = abs(as_float(x))
    lost = _TINY if size < _SUBNORMAL and (size != 0.0 or error > 0.0) else 0.0
    return error + 8 * unit * size + lost


@compilable
def _record_state(
    row: Any, start: Start, event: float, begun: Begun, t: Number, length: Number, here: MotionState, off: Off
) -> None:
    """Write a state at the time t in SI units; the motion with this start begins or lasts there."""
    (x1, v1, x2, v2), unit = in_si(begun.units, here), begun.at.unit
    by_x, by_t = as_float(begun.units.length), as_float(begun.units.rate)
    errors = (
        _bound(off.late / by_t, t, unit),
        _bound(by_x * off.x, x1, unit),
        _bound(by_x * by_t * off.v1, v1, unit),
        _bound(by_x * (off.x + off.place), x2, unit),
        _bound(by_x * by_t * off.v2, v2, unit),
        off.w + 4 * unit * abs(as_float(here.w)),
    )
    _record(row, start, event, (t, length / begun.units.rate, x1, v1, x2, v2, here.w), errors)


@compilable
def _run(begun: Begun, errors: Errors, most: int, rows: Any) -> tuple[int, int, Start, Errors]:
    """Follow the modes until the horizon, a last stick phase, or `most` events, and record the first ones in `rows`.

    Returns how it ended, the number of events, the start of the last mode and its errors; where even the sequence of
    events is uncertain these say so.
    """
    at, start, count = begun.at, begun.start, 0
    while True:
        how, duration, end = next_event(at, start)
        if how != MOVING:
            return how, count, start, errors
        tau, rest = clock(start.tau, start.rest, duration)
        if sign(tau - begun.horizon, BEFORE_HORIZON) > 0:
            break
        if count == most:
            return EVENT_LIMIT, count, start, errors
        after = resolve(at, start, end, tau, rest)
        if not finite(after.w):
            return OUT_OF_RANGE, count, start, errors
        errors = after_event(at, start, errors, end, after)
        start, count = after, count + 1
        if count < len(rows):
            here = event_state(at, start)
            off = at_start(at, start, errors, here)
            _record_state(rows[count], start, 1.0, begun, tau / begun.units.rate, duration, here, off)
    if not finite(tau):
        return OUT_OF_RANGE, count, start, errors
    return REACHED, count, start, before_horizon(at, start, errors, end, tau, begun.horizon)


@compilable
def solve_start(begun: Begun, errors: Errors, given: tuple[Number, ...], most: int, rows: Any, end: Any) -> int:
    """Run to the end and write the first rows, that of the start before all, and the end; return the number of events.

    errors: those at the start (bounds.initial). given: x1, v1, x2, v2 and the horizon in SI units.
    """
    at, start, units, unit = begun.at, begun.start, begun.units, begun.at.unit
    if len(rows) > 0:
        zero, w, row = start.tau, start.w, rows[0]
        _record(row, start, 0.0, (zero, zero, given[0], given[1], given[2], given[3], w), (0.0,) * 6)
        for k in range(4):
            row[_ERRORS + k] = unit * abs(as_float(given[k]))
        row[_ERRORS + 4] = 2 * unit * abs(as_float(w))
    how, count, start, errors = _run(begun, errors, most, rows)
    if how == EVENT_LIMIT:
        t, length, here = start.tau / units.rate, start.rest - start.rest, event_state(at, start)
        off = at_start(at, start, errors, here)
    else:
        t, length = given[4], (begun.horizon - start.tau) - start.rest
        # the rounding of an event at the horizon may lie beyond it
        tau = length if as_float(length) > 0.0 else start.tau - start.tau
        here = state_at(at, start, tau)
        off = at_horizon(at, start, errors, here, tau, begun.horizon)
    _record_state(end, start, 0.0, begun, t, length, here, off)
    spent, energy = as_float(here.spent), as_float(units.energy)
    taken = energy * (off.spent + 16 * unit * spent)
    lost = _TINY + 2.0**-1070 * energy
    end[_END], end[_END + 1] = how, count
    end[_END + 2] = 1.0 if off.certain and how != OUT_OF_RANGE else 0.0
    end[_FRICTION], end[_FRICTION + 1] = as_float(units.energy * here.spent), 0.0
    end[_DISSIPATED] = taken + (lost if taken > 0.0 or spent > 0.0 else 0.0)
    return count


@compilable
def _in_range(row: Any) -> bool:
    """Return whether binary64 keeps its digits in products of these numbers."""
    for index in range(10):  # noqa: SIM110 - numba has no generators in `all`
        if not (row[index] == 0.0 or _SMALLEST < abs(row[index]) < _LARGEST):
            return False
    return True


@compilable
def solve_row(row: Any, literal: bool, most: int, rows: Any, end: Any) -> int:
    """Solve ten SI numbers (engine.si_numbers) in binary64: write the first rows and the end.

    Returns the number of events; UNKNOWN where the numbers must be converted exactly.
    """
    if not _in_range(row):
        return UNKNOWN
    si = (
        float(row[0]),
        float(row[1]),
        float(row[2]),
        float(row[3]),
        float(row[4]),
        float(row[5]),
        float(row[6]),
        float(row[7]),
        float(row[8]),
    )
    begun = begin(si, literal, as_float, ROW_UNIT)
    if not is_known(begun):
        return UNKNOWN
    return solve_start(begun, initial(begun, 1.0), si[4:], most, rows, end)


@compilable
def solve_rows(table: Any, literal: bool, most: int, kept: Any, ends: Any) -> None:
    """Solve every row of table (n, 10): keep its first rows in kept (n, k, ROW), its end in ends (n, END_ROW).

    Where a row must be converted exactly its end says UNKNOWN in the place of how it ended.
    """
    for index in range(len(table)):
        if solve_row(table[index], literal, most, kept[index], ends[index]) == UNKNOWN:
            ends[index][_END] = UNKNOWN
