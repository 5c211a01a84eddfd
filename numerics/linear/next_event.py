"""The next event of a mode over a step: its guards, their first root, and how far off that may be."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable
from numerics.linear.columns import Constants, Now, Problem, Room, counted, place_of
from numerics.linear.first_root import CLEAR, ROOT, first_root
from numerics.linear.table import UNIT


class Step(NamedTuple):
    """A step: its end in units of h, and whether the piece ends there; up to `clear` no event is possible."""

    end: float
    is_last: bool
    clear: float


class Next(NamedTuple):
    """What the next step is: to s in units of h; CLEAR, ROOT or UNDECIDED; and of a root the rest.

    `side` of stick; by how much s is alone; the guard's slope; how far off its zero may be by the path's own numbers.
    """

    how: int
    s: float
    side: int
    room: float
    slope: float
    window: float
    own: float


@compilable
def first_side(room: Room) -> int:
    """Return the side to which a load that is 0 goes, in stick: mirrored motions have mirrored guards there, too."""
    for c in room.X[1, 2:]:
        if c != 0.0:
            return 1 if c > 0.0 else -1
    return 1


@compilable
def form_guard(room: Room, mode: int, order: int, side: int, edge: float) -> None:
    """Form the guard in g, and without its first coefficients, which are exactly 0, in q.

    It is h s (v1 - v2) of a slip, (b - side Lambda) h^2/m2 of stick.
    """
    one, two, g, q = room.X[0], room.X[1], room.g, room.q
    terms = q.shape[0]
    if mode != 0:
        sign = float(mode)
        for k in range(terms - 1):
            g[k] = (k + 1.0) * sign * (one[k + 1] - two[k + 1])
        g[terms - 1] = 0.0
    else:
        sign = -float(side)
        for k in range(terms - 2):
            g[k] = sign * room.twice[k] * two[k + 2]
        g[terms - 2] = g[terms - 1] = 0.0
        g[0] += edge
    g[:order] = 0.0
    rest = g[order:]
    for k in range(rest.shape[0]):
        q[k] = rest[k]
    q[rest.shape[0] :] = 0.0


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
def step_from(problem: Problem, room: Room, now: Now, is_calm: bool, clear_until: float) -> Step:
    """Return the step from here, to the end of the piece if that is nearer; no event comes up to `clear_until`."""
    h, length, time = problem.tables.h[place_of(problem, now)], problem.drive.length[now.piece], room.clock[0, 0]
    left = (length[0] - time) + (length[1] - room.clock[0, 1])
    clear = 2.0 if is_calm else 0.0
    if clear_until > time + 1e-9 * h:
        clear = (clear_until - time) / h
    return Step(left / h if left <= h else 1.0, left <= h, clear)


@compilable
def next_event(problem: Problem, room: Room, now: Now, step: Step) -> Next:
    """Return how a mode goes on: to the end of a step, or to an event."""
    (pair, drive, tables, _), (mode, order), to = problem, (now.mode, now.order), step.end
    if step.clear > 0.0 or (mode == 0 and pair.literal):
        if mode != 0:  # what a slip without an event loses is formed from its guard, too
            form_guard(room, mode, order, now.edge, 0.0)
        return Next(CLEAR, min(to, step.clear) if step.clear > 0.0 else to, 0, 0.0, 0.0, 0.0, 0.0)
    at = place_of(problem, now)
    h, count, edge, top = tables.h[at], tables.count[at[0]], 0.0, math.inf
    unit = h if mode != 0 else h * h / pair.m2  # of the guard
    sums = tables.sums[at]
    off = rounding(room, sums[order], count)
    if mode != 0:
        margins = slip_margins(pair, h, order, off, now.since, now.N, to)
    else:
        edge = unit * drive.b[now.piece]
        plain = rounding(room, sums[0], count) if order > 0 else off
        top, margin = 2.0 * edge, pair.lam * now.N * unit + 4.0 * UNIT * edge
        margins = off + margin, 0.0, 0.0, plain + margin + 8.0 * UNIT * edge  # top less the guard is rounded, too
    side = now.edge if now.edge != 0 else first_side(room)
    form_guard(room, mode, order, side, edge)
    how, s, alone, which, value, slope = first_root(room.q, order, top, margins, to, room.bernstein)
    if how != ROOT:
        return Next(how, s, 0, 0.0, 0.0, 0.0, 0.0)
    exit_side, power = side if which == 0 else -side, s**order
    # the rounding of the coefficients that were not dropped, at the root
    own = UNIT * (counted(tables.own[at][order], room.size, count, s) * power + (6.0 * edge if order == 0 else 0.0))
    steep = abs(slope) * power
    window = (abs(value) * power + own) / steep * h
    return Next(how, s, exit_side, alone, steep / unit / h, window, own / unit)
