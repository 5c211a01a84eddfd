"""The next event of a mode over a step: its guards, their first root, and how far off that may be."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import two_sum
from numerics.linear.columns import Constants, Now, Problem, Room, counted, place_of, wide_product
from numerics.linear.first_root import CLEAR, ROOT, first_root
from numerics.linear.pairs import add, divide, multiply, times
from numerics.linear.table import PRECISE, UNIT, WIDE_UNIT


class Step(NamedTuple):
    """A step: its end in units of h, a pair, and whether the piece ends there; up to `clear` no event is possible."""

    high: float
    low: float
    is_last: bool
    clear: float


class Next(NamedTuple):
    """What the next step is: to s (a pair) in units of h; CLEAR, ROOT or UNDECIDED; and of a root the rest.

    `side` of stick; by how much s is alone; the guard's slope; how far off its zero may be by the path's own numbers.
    """

    how: int
    high: float
    low: float
    side: int
    room: float
    slope: float
    window: float
    own: float


@compilable
def leave_out(order: int, g: Any, q: Any) -> None:
    """Put a guard's coefficients into q without the first ones."""
    rest = g[order:]
    for k in range(rest.shape[0]):
        q[k] = rest[k]
    q[rest.shape[0] :] = 0.0


@compilable
def slip_guard(room: Room, mode: int, order: int) -> None:
    """Form the guard h s (v1 - v2) of a slip, less its first coefficients, which are exactly 0."""
    one, two, g, sign = room.X[0, 0, 1:], room.X[0, 1, 1:], room.g[0], float(mode)
    for k in range(one.shape[0]):
        g[k] = (k + 1.0) * sign * (one[k] - two[k])
    g[one.shape[0]] = 0.0
    leave_out(order, g, room.q)
    g[:order] = 0.0


@compilable
def stick_guard(room: Room, edge: float, order: int, side: int) -> None:
    """Form the guard (b - side Lambda) h^2/m2 of stick, less its first coefficients, which are exactly 0."""
    x2, q, sign = room.X[0, 1, 2:], room.q, float(side)
    for k in range(x2.shape[0]):
        q[k] = -sign * room.twice[k] * x2[k]
    q[x2.shape[0] :] = 0.0
    q[0] += edge
    if order > 0:
        leave_out(order, q, q)


@compilable
def wide_guard(room: Room, mode: int, order: int, edge: tuple[float, float], side: int) -> None:
    """Form the guard of a mode in pairs, that of a side in stick; its first coefficients are left 0."""
    X, g = room.X, room.g
    g[0, :order] = 0.0
    g[1, :] = 0.0
    if mode != 0:
        for k in range(order, PRECISE):
            h, low = add(X[0, 0, k + 1], X[1, 0, k + 1], -X[0, 1, k + 1], -X[1, 1, k + 1])
            g[0, k], g[1, k] = times(h, low, mode * (k + 1.0))
        return
    for k in range(order, g.shape[1] - 2):
        g[0, k], g[1, k] = times(X[0, 1, k + 2], X[1, 1, k + 2], -side * room.twice[k])
    g[0, g.shape[1] - 2 :] = 0.0
    if order == 0:
        g[0, 0], g[1, 0] = add(g[0, 0], g[1, 0], edge[0], edge[1])


@compilable_with(forceinline=False)
def refined(g: Any, order: int, s: float, alone: float) -> tuple[float, float, float]:
    """Return a root of g/s^order as a pair, by Newton's steps in pairs, and what that may be there.

    The first `order` terms are 0. The value is formed at a float, so that one step is enough where it changes no more
    than the last bits; what is left is the square of the change times half of g'', which is at most g'/(4 alone), and
    the change times the rounding of the slope.
    """
    change = left = 0.0
    for again in range(2, -1, -1):
        slope = size = steep = al = 0.0
        ah, k = 0.0, g.shape[1] - 1
        while k >= PRECISE:
            slope, steep = slope * s + ah, steep * s + size
            ah, size = ah * s + g[0, k], size * s + abs(g[0, k])
            k -= 1
        while k >= order:
            slope, steep = slope * s + ah, steep * s + size
            size = size * s + abs(g[0, k])
            ah, al = times(ah, al, s)
            ah, al = add(ah, al, g[0, k], g[1, k])
            k -= 1
        change = ah / slope
        left = abs(change) * (abs(change * slope) / (8.0 * alone) + 4.0 * g.shape[1] * UNIT * steep)
        if again == 0 or change * change <= 8.0 * alone * s * UNIT * UNIT:
            break
        s -= change
    high, low = two_sum(s, -change)
    return high, low, left


@compilable
def rounding(room: Room, sums: Any, count: int) -> float:
    """Return what rounding in float64 and truncation do to a guard anywhere in a step."""
    total = 0.0
    for j in range(count):
        total += room.size[j] * sums[j]
    return UNIT * total


@compilable
def slip_margins(
    pair: Constants, h: float, order: int, off: float, since: float, N: float, theta: float
) -> tuple[float, float, float, float]:
    """Return the margin of the guard of a slip, up to s = theta, for `first_root`."""
    if order >= 2:
        return off, 0.0, 16.0 * pair.kappa1 * N * h * h, 0.0
    if order == 1:
        return off + 2.0 * pair.kappa1 * N * h * h, 0.0, 0.0, 0.0
    if pair.kappa1 * (since + theta * h) < pair.kappa:
        return off + 2.0 * pair.kappa1 * since * N * h, 2.0 * pair.kappa1 * N * h * h, 0.0, 0.0
    return off + 2.0 * pair.kappa * N * h, 0.0, 0.0, 0.0


@compilable
def edge_of(pair: Constants, h: float, b: Any, wide: bool) -> tuple[float, float]:
    """Return b h^2/m2."""
    if not wide:
        return h * h / pair.m2 * b[0], 0.0
    high, low = multiply(h, 0.0, h, 0.0)
    high, low = divide(high, low, pair.m2, pair.m2_low)
    return multiply(high, low, b[0], b[1])


@compilable
def step_from(problem: Problem, room: Room, now: Now, is_calm: bool, clear_until: float) -> Step:
    """Return the step from here, to the end of the piece if that is nearer; no event comes up to `clear_until`."""
    h, length, clock = problem.tables.h[place_of(problem, now)], problem.drive.length[now.piece], room.clock[0]
    left, left_low = add(length[0], length[1], -clock[0], -clock[1])
    high, low = divide(left, left_low, h, 0.0) if left <= h else (1.0, 0.0)
    clear = 2.0 if is_calm else 0.0
    if clear_until > clock[0] + 1e-9 * h:
        clear = (clear_until - clock[0]) / h
    return Step(high, low, left <= h, clear)


@compilable
def next_event(problem: Problem, room: Room, now: Now, step: Step) -> Next:
    """Return how a mode goes on: to the end of a step, or to an event."""
    (pair, drive, tables, wide, _), (mode, order), to = problem, (now.mode, now.order), step.high
    if step.clear > 0.0 or (mode == 0 and pair.literal):
        return no_event(CLEAR, min(to, step.clear) if step.clear > 0.0 else to, step)
    at = place_of(problem, now)
    h, count, edge, top = tables.h[at], tables.count[at[0]], (0.0, 0.0), math.inf
    unit = h if mode != 0 else h * h / pair.m2  # of the guard
    sums = tables.sums[at]
    off = rounding(room, sums[order], count)
    if mode != 0:
        slip_guard(room, mode, order)
        margins = slip_margins(pair, h, order, off, now.since, now.N, to)
    else:
        edge = edge_of(pair, h, drive.b[now.piece], wide)
        stick_guard(room, edge[0], order, now.edge)
        plain = rounding(room, sums[0], count) if order > 0 else off
        top, margin = 2.0 * edge[0], pair.lam * now.N * unit + 4.0 * UNIT * edge[0]
        margins = off + margin, 0.0, 0.0, plain + margin + 8.0 * UNIT * edge[0]  # top less the guard is rounded, too
    how, s, alone, which, value, slope = first_root(room.q, order, top, margins, to, room.bernstein)
    if how != ROOT:
        return no_event(how, s, step)
    exit_side, low = now.edge if which == 0 else -now.edge, 0.0
    if wide:
        wide_product(tables.rows[at], tables.degrees[at], room, count)
        wide_guard(room, mode, order, edge, exit_side)
        s, low, value = refined(room.g, order, s, alone)
    power = s**order
    # the rounding of the coefficients that were not dropped, at the root
    own = counted(tables.own[at][order], room.size, count, s) * power + (6.0 * edge[0] if order == 0 else 0.0)
    own *= WIDE_UNIT if wide else UNIT
    steep = abs(slope) * power
    window = (abs(value) * power + own) / steep * h
    return Next(how, s, low, exit_side, alone, steep / unit / h, window, own / unit)


@compilable
def no_event(how: int, s: float, step: Step) -> Next:
    """Return that there is none up to s, which may be the end of the step."""
    return Next(how, s, step.low if s == step.high else 0.0, 0, 0.0, 0.0, 0.0, 0.0)
