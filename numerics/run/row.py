"""One run as compiled code knows it: from a row of SI numbers, or a start, to rows of events and a row for the end."""

from __future__ import annotations

import math
from typing import Any

from numerics.arithmetic.double_double import Double
from numerics.arithmetic.float64 import UNIT, WIDTH, put, rough
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.bounds.records import EndErrors
from numerics.bounds.undamped import at_horizon, at_last_event, initial
from numerics.motion.codes import EVENT_LIMIT, OUT_OF_RANGE
from numerics.motion.records import At
from numerics.motion.start import SI, Reduced, Units, undamped_start
from numerics.motion.undamped import mode_of
from numerics.run.loop import run

SI_NUMBERS = 10
_SMALLEST, _LARGEST = 1e-70, 1e70
"""Beyond them a product of four SI numbers may leave the range of binary64: convert exactly."""
_SMALLEST_UNIT = 1e-250


@text
def si_of(row: Any) -> SI:
    """Return the SI numbers of a row: ten, each as its high and low half."""
    return SI(
        Double(row[0], row[1]),
        Double(row[2], row[3]),
        Double(row[4], row[5]),
        Double(row[6], row[7]),
        Double(row[8], row[9]),
        Double(row[10], row[11]),
        Double(row[12], row[13]),
        Double(row[14], row[15]),
        Double(row[16], row[17]),
        Double(row[18], row[19]),
    )


@text
def in_range(row: Any) -> bool:
    """Return whether double-double keeps its digits in products of these numbers."""
    for index in range(0, 2 * SI_NUMBERS, 2):  # noqa: SIM110 - numba has no generators in `all`
        if not (row[index] == 0.0 or _SMALLEST < abs(row[index]) < _LARGEST):
            return False
    return True


@text
def solve_row(row: Any, literal: bool, most: int, rows: Any, end: Any) -> int:
    """Solve a row of SI numbers; return the number of events, -1 where it must be converted exactly."""
    if not in_range(row):
        return -1
    pair, start, at, known = undamped_start(si_of(row), literal)
    if not known or not math.isfinite(at.w + at.horizon):
        return -1
    return solve_start(pair, start, at, most, rows, end)


@text
def solve_start(pair: Any, start: Any, at: Reduced, most: int, rows: Any, end: Any) -> int:
    """Run from a start to the end, write the first events and the end (trajectory/record.py); return their number."""
    first_mode, errors = mode_of(start), initial(pair, start, at.V1, at.V2)
    how, count, start, errors, worst = run(pair, start, errors, at.horizon, most, rows)
    here, off, tau, length = ending(how, pair, start, errors, at.horizon)
    certain = off.certain and how != OUT_OF_RANGE
    end[0], end[1], end[2], end[3], end[4] = how, count, mode_of(start), first_mode, 1.0 if certain else 0.0
    end[5] = right_digits(pair, here, off, worst) if certain and keeps_digits(at.units) else 0.0
    end[6], end[7], end[8], end[9], end[10] = worst, off.x, off.v1, off.v2, off.place
    end[11], end[12], end[13] = off.w, off.spent, off.damped
    put(end, 14, (tau, length, here.X, here.V1, here.V2, here.Z, here.w, here.spent, here.damped))
    put(end, 14 + 9 * WIDTH, (at.X, at.V1, at.V2, at.Z, at.w, at.units.length, at.units.rate, at.units.energy))
    return count


@text
def ending(how: int, pair: Any, start: Any, errors: Any, horizon: Number) -> tuple[At, EndErrors, Number, Number]:
    """Return the state at the end and its errors, the time there, and how long the last motion lasts up to it."""
    if how == EVENT_LIMIT:
        at, off = at_last_event(pair, start, errors)
        return at, off, start.tau, start.rest - start.rest
    at, off = at_horizon(pair, start, errors, horizon)
    return at, off, horizon, (horizon - start.tau) - start.rest


@text
def right_digits(pair: Any, at: At, off: EndErrors, worst: float) -> float:
    """Return how many digits of every event, and of state, energy and excess at the end, the bounds leave right.

    An exact number has all digits, a 0 that is not exact none.
    """
    q, r, w = rough(pair.q), rough(pair.r), abs(rough(at.w))
    X, V1, V2, x2 = rough(at.X), rough(at.V1), rough(at.V2), rough(at.X - at.Z)
    energy = X * X + q * V1 * V1 + r * V2 * V2
    worst = max(worst, share(off.x, 8.0, X), share(off.v1, 8.0, V1), share(off.x + off.place, 8.0, x2))
    worst = max(worst, share(off.v2, 8.0, V2), share(off.w, 4.0, w))
    # of E = E_cr (1 + w) the state forms the left side, and w stands beside it: both bound its error
    by_state = off.x * (2 * abs(X) + off.x) + q * off.v1 * (2 * abs(V1) + off.v1) + r * off.v2 * (2 * abs(V2) + off.v2)
    worst = max(worst, share(min(off.w + 16.0 * UNIT * w, by_state), 16.0, energy))
    worst = max(worst, UNIT / 8.0)
    return max(0.0, math.floor(-math.log10(worst))) if worst < 1.0 else 0.0


@text
def keeps_digits(units: Units) -> bool:
    """Return whether the units are so far above the least numbers that products with them lose nothing."""
    length, rate, energy = rough(units.length), rough(units.rate), rough(units.energy)
    return min(length, length * rate, energy) > _SMALLEST_UNIT


@text
def share(error: float, roundings: float, value: float) -> float:
    """Return the relative error of a value in SI units, which takes so many roundings; 0 for an exact one."""
    error = error + roundings * UNIT * abs(value)
    if not error > 0.0:
        return 0.0
    return error / abs(value) if value != 0.0 else math.inf
