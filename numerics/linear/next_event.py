"""The next event of a mode over a step: its guards, their first root, and how far off that may be."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, times, two_product, two_sum
from numerics.linear.columns import Constants, Now, Problem, Room, counted, place_of, wide_product
from numerics.linear.first_root import CLEAR, ROOT, first_root
from numerics.linear.table import PRECISE, UNIT, WIDE_UNIT


class Step(NamedTuple):
    """A step: its end in units of h, and whether the piece ends there; up to `clear` no event is possible."""

    end: TwoFloats
    is_last: bool
    clear: float


class Next(NamedTuple):
    """What the next step is: to s in units of h; CLEAR, ROOT or UNDECIDED; and of a root the rest.

    `side` of stick; by how much s is alone; the guard's slope; how far off its zero may be by the path's own numbers.
    """

    how: int
    s: TwoFloats
    side: int
    room: float
    slope: float
    window: float
    own: float


@compilable
def form_guard(room: Room, mode: int, order: int, side: int, edge: float) -> None:
    """Form the guard in g, and without its first coefficients, which are exactly 0, in q.

    It is h s (v1 - v2) of a slip, (b - side Lambda) h^2/m2 of stick.
    """
    one, two, g, q = room.X[0, 0], room.X[0, 1], room.g[0], room.q
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
def form_wide_guard(room: Room, mode: int, order: int, side: int, edge: TwoFloats) -> None:
    """Form the first terms of the guard in pairs; the others are those of `form_guard`."""
    X, g = room.X, room.g
    for k in range(order, PRECISE):
        if mode != 0:
            gap = plus(TwoFloats(X[0, 0, k + 1], X[1, 0, k + 1]), TwoFloats(-X[0, 1, k + 1], -X[1, 1, k + 1]))
            value = times(gap, mode * (k + 1.0))
        else:
            value = times(TwoFloats(X[0, 1, k + 2], X[1, 1, k + 2]), -side * room.twice[k])
            value = plus(value, edge) if k == 0 else value
        g[0, k], g[1, k] = value.high, value.low


@compilable_with(forceinline=False)
def refined(g: Any, order: int, s: float, alone: float) -> tuple[TwoFloats, float]:
    """Return a root of g/s^order, by Newton's steps in pairs, and what that may be there.

    The first `order` terms are 0. The value is formed at a float, so that one step is enough where it changes no more
    than the last bits; what is left is the square of the change times half of g'', which is at most g'/(4 alone), and
    the change times the rounding of the slope.
    """
    change = left = 0.0
    for again in range(2, -1, -1):
        value, slope, size, steep = TwoFloats(0.0, 0.0), 0.0, 0.0, 0.0
        for k in range(g.shape[1] - 1, order - 1, -1):
            slope, steep = slope * s + value.high, steep * s + size
            size = size * s + abs(g[0, k])
            if k >= PRECISE:
                value = TwoFloats(value.high * s + g[0, k], 0.0)
            else:
                value = plus(times(value, s), TwoFloats(g[0, k], g[1, k]))
        change = value.high / slope
        left = abs(change) * (abs(change * slope) / (8.0 * alone) + 4.0 * g.shape[1] * UNIT * steep)
        if again == 0 or change * change <= 8.0 * alone * s * UNIT * UNIT:
            break
        s -= change
    return two_sum(s, -change), left


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
def edge_of(pair: Constants, h: float, b: Any, wide: bool) -> TwoFloats:
    """Return b h^2/m2."""
    if not wide:
        return TwoFloats(h * h / pair.m2 * b[0], 0.0)
    return two_product(h, h) / TwoFloats(pair.m2, pair.m2_low) * pair_of(b)


@compilable
def step_from(problem: Problem, room: Room, now: Now, is_calm: bool, clear_until: float) -> Step:
    """Return the step from here, to the end of the piece if that is nearer; no event comes up to `clear_until`."""
    h, clock = problem.tables.h[place_of(problem, now)], pair_of(room.clock[0])
    left = plus(pair_of(problem.drive.length[now.piece]), TwoFloats(-clock.high, -clock.low))
    end = left / h if left.high <= h else TwoFloats(1.0, 0.0)
    clear = 2.0 if is_calm else 0.0
    if clear_until > clock.high + 1e-9 * h:
        clear = (clear_until - clock.high) / h
    return Step(end, left.high <= h, clear)


@compilable
def next_event(problem: Problem, room: Room, now: Now, step: Step) -> Next:
    """Return how a mode goes on: to the end of a step, or to an event."""
    (pair, drive, tables, wide, _), (mode, order), to = problem, (now.mode, now.order), step.end.high
    if step.clear > 0.0 or (mode == 0 and pair.literal):
        if mode != 0:  # what a slip without an event loses is formed from its guard, too
            form_guard(room, mode, order, now.edge, 0.0)
        return no_event(CLEAR, min(to, step.clear) if step.clear > 0.0 else to, step)
    at = place_of(problem, now)
    h, count, edge, top = tables.h[at], tables.count[at[0]], TwoFloats(0.0, 0.0), math.inf
    unit = h if mode != 0 else h * h / pair.m2  # of the guard
    sums = tables.sums[at]
    off = rounding(room, sums[order], count)
    if mode != 0:
        margins = slip_margins(pair, h, order, off, now.since, now.N, to)
    else:
        edge = edge_of(pair, h, drive.b[now.piece], wide)
        plain = rounding(room, sums[0], count) if order > 0 else off
        top, margin = 2.0 * edge.high, pair.lam * now.N * unit + 4.0 * UNIT * edge.high
        margins = off + margin, 0.0, 0.0, plain + margin + 8.0 * UNIT * edge.high  # top less the guard is rounded, too
    form_guard(room, mode, order, now.edge, edge.high)
    how, root, alone, which, value, slope = first_root(room.q, order, top, margins, to, room.bernstein)
    if how != ROOT:
        return no_event(how, root, step)
    exit_side, s = now.edge if which == 0 else -now.edge, TwoFloats(root, 0.0)
    if wide:
        wide_product(tables.rows[at], tables.degrees[at], room, count)
        form_guard(room, mode, order, exit_side, edge.high)
        form_wide_guard(room, mode, order, exit_side, edge)
        s, value = refined(room.g, order, root, alone)
    power = s.high**order
    # the rounding of the coefficients that were not dropped, at the root
    own = counted(tables.own[at][order], room.size, count, s.high) * power + (6.0 * edge.high if order == 0 else 0.0)
    own *= WIDE_UNIT if wide else UNIT
    steep = abs(slope) * power
    window = (abs(value) * power + own) / steep * h
    return Next(how, s, exit_side, alone, steep / unit / h, window, own / unit)


@compilable
def no_event(how: int, s: float, step: Step) -> Next:
    """Return that there is none up to s, which may be the end of the step."""
    return Next(how, step.end if s == step.end.high else TwoFloats(s, 0.0), 0, 0.0, 0.0, 0.0, 0.0)
