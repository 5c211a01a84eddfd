"""The next event of a mode over a step: the first root of its guards, and how far off that may be."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, inlined
from numerics.linear.evolve import grown, parting
from numerics.linear.first_root import CLEAR, ROOT, first_root
from numerics.linear.model import AHEAD, FLOOR
from numerics.linear.room import Now, Run, dot, load_off, place_of, polynomial_of
from numerics.linear.table import ORDERS, STATE, SUMS, UNIT


class Step(NamedTuple):
    """A step: its end in units of h, and whether the piece ends there; up to `clear` no event is possible."""

    end: float
    is_last: bool
    clear: float


class Next(NamedTuple):
    """What the next step is: to s in units of h; CLEAR, ROOT or UNDECIDED; and of a root the rest.

    Which guard; by how much s is alone; the guard's slope (per second); how far off the guard may be by rounding alone.
    """

    how: int
    s: float
    guard: int
    alone: float
    slope: float
    own: float


@inlined
def step_from(run: Run, now: Now, is_calm: bool, clear_until: float) -> Step:
    """Return the step from here, to the end of the piece if that is nearer; no event comes up to `clear_until`."""
    h, length, time = run.tables.steps[place_of(now)], run.drive.length[now.piece], run.clock[0, 0]
    left = (length[0] - time) + (length[1] - run.clock[0, 1])
    clear = 2.0 if is_calm else 0.0
    if clear_until > time + 1e-9 * h:
        clear = (clear_until - time) / h
    return Step(left / h if left <= h else 1.0, left <= h, clear)


@inlined
def next_event(run: Run, now: Now, step: Step) -> Next:
    """Return how a mode goes on: to the end of a step, or to an event."""
    is_stick = now.mode == 0
    if step.clear > 0.0 or (is_stick and run.literal):
        return Next(CLEAR, min(step.end, step.clear) if step.clear > 0.0 else step.end, 0, 0.0, 0.0, 0.0)
    count, first = 2 if is_stick else 3, Next(CLEAR, step.end, 0, 0.0, 0.0, 0.0)
    for n in range(count):  # all over the whole step, so that mirrored motions have mirrored events
        found = first_of_guard(run, now, (now.edge + n) % count, now.order if n == 0 else 0, step.end)
        if found.s < first.s or (found.s == first.s and first.how == CLEAR):
            first = found
    return first


@compilable
def first_of_guard(run: Run, now: Now, guard: int, order: int, end: float) -> Next:
    """Return the first root of a guard, of which so many coefficients vanish here, up to an end."""
    tables, at, q = run.tables, place_of(now), run.series[0]
    value = 0.0 if now.mode == 0 else tables.ends[now.kind, guard]
    if value == math.inf:
        return Next(CLEAR, end, guard, 0.0, 0.0, 0.0)
    which = guard if now.mode == 0 else guard // AHEAD
    h, row, sums = tables.steps[at], STATE + which, SUMS + 2 * (ORDERS * which + order)
    polynomial_of(tables.rows[at][row], tables.degrees[at][row], run.z, order, q)
    if now.mode * (1 if guard == FLOOR else -1) < 0:
        for k in range(q.shape[0]):
            q[k] = -q[k]
    if order == 0:
        q[0] += value
    off = UNIT * dot(tables.lines[at][sums], run.size)
    rise = UNIT * dot(tables.lines[at][sums + 1], run.size) - off
    off += 4.0 * UNIT * abs(value)
    if now.mode == 0:
        margins = off + load_off(run, at[0], now), rise, 0.0
    else:
        margins = slip_margins(run, now, guard, order, (off, rise), end * h)
    if order > 0 and now.late > 0.0:  # the true segment began up to `late` away: as much as its guard changes meanwhile
        shift = (1.0 + order) * now.late / h * abs_slope(q)
        margins = margins[0] + shift, margins[1], margins[2]
    how, s, alone, value, slope = first_root(q, margins, end, run.series[2])
    if how != ROOT:
        return Next(how, s, guard, 0.0, 0.0, 0.0)
    power = s**order
    return Next(ROOT, s, guard, alone, -slope * power / h, (abs(value) + off + s * rise) * power)


@compilable
def abs_slope(q: Any) -> float:
    """Return a bound on the derivative of a polynomial on [0, 1]."""
    total = 0.0
    for k in range(1, q.shape[0]):
        total += k * abs(q[k])
    return total


@compilable
def slip_margins(
    run: Run, now: Now, guard: int, order: int, own: tuple[float, float], end: float
) -> tuple[float, float, float]:
    """Return the margin of a guard of a slip, up to a time, for `first_root`.

    Where both began at v1 = v2, or at the same end, two motions part in v1 - v2 by what they part in its rate.
    """
    (off, rise), kappa, h = own, run.norm.kappa, run.tables.steps[place_of(now)]
    N, apart = grown(run, now, now.N, end)
    bend = parting(run, now, N, apart)
    if guard == AHEAD:
        return off + 2.0 * apart, rise, 0.0
    if order >= 2:
        return off, rise, 16.0 * bend * h
    if order == 1:
        return off + 2.0 * bend * h, rise, 0.0
    if now.speed_apart + bend * end < kappa * N:
        return off + 2.0 * now.speed_apart, rise + 2.0 * bend * h, 0.0
    return off + 2.0 * kappa * N, rise, 0.0
