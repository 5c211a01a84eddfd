"""What bounds leave of the numbers of a record in floats: errors of times, states and energy, and the worst of them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.linear.ledger import TINY
from numerics.linear.record import AT

_EVENT, _PIECE, _LOCAL, _X1, _LATE = (AT[name] for name in ("event", "piece", "local", "x1", "late"))
_EVENTS = AT["events"]
_ERRORS = AT["x1_error"]
JUDGED = ("times", "positions", "velocities", "energy", "energy excess")
"""Of what the worst errors are given."""


@compilable_with(makes_arrays=True, forceinline=False)
def errors_of(
    rows: Any, end: Any, starts: Any, weights: tuple[float, float, float], critical: float, rounding: float
) -> tuple[float, float, tuple[float, float, float, float, float]]:
    """Return bounds on energy (J) and excess at the end, and the worst relative errors.

    These are of what JUDGED names; `weights` are a2, m1 and m2; inf where a bound is no number. The largest velocity
    and energy are those of the rows, or of a mean velocity between them, which is attained on the way.
    """
    count, late = len(rows), 0.0
    sizes, errors, highest, last, before, earlier = np.zeros(2), np.zeros(2), 0.0, 0.0, end, 0.0
    fast = np.zeros(2)  # of body 1 and 2
    for index in range(count + 1):
        row = rows[index] if index < count else end
        for k in range(4):
            error = row[_ERRORS + k]
            sizes[k % 2] = max(sizes[k % 2], abs(row[_X1 + k]))
            errors[k % 2] = max(errors[k % 2], math.inf if math.isnan(error) else error)
        x1, v1, v2 = row[_X1], row[_X1 + 1], row[_X1 + 3]
        last = (weights[0] * x1 * x1 + weights[1] * v1 * v1 + weights[2] * v2 * v2) / 2
        highest, t = max(highest, last), earlier
        if row[_LOCAL] >= 0.0:  # no nan
            t = starts[int(row[_PIECE])] + row[_LOCAL]
        if index > 0:
            lasted = t - earlier + row[_LATE] + before[_LATE] + 8 * rounding * t
            for k in range(2):
                fast[k] = max(fast[k], mean_speed(row, before, 2 * k, lasted))
        before, earlier = row, t
        if index < count and row[_EVENT] == 1.0:
            # 4 roundings: of where the piece begins, and of the sum
            late = max(late, relative(row[_LATE] + 4 * rounding * t, t))
    energy = 8 * rounding * last
    if end[_X1] != 0 or end[_X1 + 1] != 0 or end[_X1 + 3] != 0:
        energy += TINY
    for k, weight in ((0, weights[0]), (1, weights[1]), (3, weights[2])):
        error = end[_ERRORS + k]
        energy += weight * error * (abs(end[_X1 + k]) + error / 2)
    rate = math.sqrt(weights[0] / (weights[1] + weights[2]))
    if weights[0] == 0.0 and earlier > 0.0:
        rate = 1.0 / earlier
    slow = rate * sizes[0]
    place, speed = relative(errors[0], sizes[0]), moved(errors[1], sizes[1], max(fast[0], fast[1]), slow)
    taken = moved(energy, highest, weights[1] * fast[0] * fast[0] / 2, weights[1] * slow * slow / 2)
    # the excess is formed from the energy
    return energy, energy / critical + 8 * rounding * (1 + last / critical), (late, place, speed, taken, 0.0)


@compilable
def relative(error: float, size: float) -> float:
    """Return an error relative to a size; inf where there is none, or no number."""
    ratio = 0.0 if error == 0.0 else error / size if size > 0.0 else math.inf
    return math.inf if math.isnan(ratio) else ratio


@compilable
def mean_speed(row: Any, before: Any, place: int, lasted: float) -> float:
    """Return the least mean speed of a body between two rows, as far as their errors leave one."""
    gone = abs(row[_X1 + place] - before[_X1 + place]) - row[_ERRORS + place] - before[_ERRORS + place]
    return gone / lasted if gone > 0.0 and lasted > 0.0 else 0.0


@compilable
def moved(error: float, size: float, on_the_way: float, scale: float) -> float:
    """Return an error of velocities or energy relative to the larger of their sizes at rows and on the way.

    Of ones that may all be 0 at rows it is no more than the fourth root of that to a scale.
    """
    found = relative(error, max(size, on_the_way))
    return min(found, relative(error, scale) ** 0.25) if size <= error < 1e-4 * scale else found


@compilable_with(makes_arrays=True, forceinline=False)
def errors_of_rows(numbers: Any, kept: Any, ends: Any, rounding: float) -> Any:
    """Return bounds on the excess at the ends of a batch, and the worst errors of what is kept of each run: (2, n)."""
    found, at_once = np.empty((2, len(ends))), np.zeros(1)
    for n in range(len(ends)):
        m1, m2, a2, b = numbers[n, 0], numbers[n, 1], numbers[n, 2], numbers[n, 3]
        count, push = 1 + min(int(ends[n, _EVENTS]), kept.shape[1] - 1), b * (1.0 + m1 / m2)
        critical, weight_2 = push * push / (2 * a2) if a2 * b > 0.0 else math.nan, m2 if math.isfinite(m2) else 0.0
        judged = errors_of(kept[n, :count], ends[n], at_once, (a2, m1, weight_2), critical, rounding)
        found[0, n], found[1, n] = judged[1], max(judged[2])
    return found
