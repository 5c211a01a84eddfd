"""The next event of a mode over a step: its guards, their first root, and how far off that may be."""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import two_sum
from numerics.linear.columns import Constants, Drive, Room, counted, wide_product
from numerics.linear.first_root import CLEAR, ROOT, first_root
from numerics.linear.pairs import add, divide, multiply, times
from numerics.linear.table import PRECISE, UNIT, WIDE_UNIT, Tables


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
def slip_guard(room: Room, mode: int, order: int) -> None:
    """Form the guard h s (v1 - v2) of a slip, less its first coefficients, which are exactly 0."""
    one, two, g, q, sign = room.X[0, 0], room.X[0, 1], room.g[0], room.q, float(mode)
    terms = q.shape[0]
    for k in range(terms - 1):
        g[k] = (k + 1.0) * sign * (one[k + 1] - two[k + 1])
    g[terms - 1] = 0.0
    for k in range(terms - order):
        q[k] = g[k + order]
    if order > 0:
        g[:order] = 0.0
        q[terms - order :] = 0.0


@compilable
def wide_slip_guard(room: Room, mode: int, order: int) -> None:
    """Form the same in pairs."""
    X, g = room.X, room.g
    g[1, :] = 0.0
    for k in range(order, PRECISE):
        h, low = add(X[0, 0, k + 1], X[1, 0, k + 1], -X[0, 1, k + 1], -X[1, 1, k + 1])
        g[0, k], g[1, k] = times(h, low, mode * (k + 1.0))


@compilable
def stick_guards(room: Room, edge: tuple[float, float], order: int, side: int) -> None:
    """Form the guards (b -+ Lambda) h^2/m2 of stick; the one of `side` without its first coefficients, if order > 0."""
    x2, q, other, sign = room.X[0, 1], room.q, room.other, float(side)
    terms = q.shape[0]
    for k in range(terms - 2):
        other[k] = sign * room.twice[k] * x2[k + 2]
        q[k] = -other[k]
    q[terms - 2] = q[terms - 1] = other[terms - 2] = other[terms - 1] = 0.0
    q[0] += edge[0]
    other[0] += edge[0]
    if order > 0:
        for k in range(terms):
            q[k] = q[k + order] if k + order < terms else 0.0


@compilable
def load_guard(room: Room, edge: tuple[float, float], order: int, side: int) -> None:
    """Form the guard (b - side Lambda) h^2/m2 in pairs."""
    X, g = room.X, room.g
    for k in range(g.shape[1]):
        g[0, k], g[1, k] = 0.0, 0.0
        if order <= k < g.shape[1] - 2:
            g[0, k], g[1, k] = times(X[0, 1, k + 2], X[1, 1, k + 2], -side * (k + 2.0) * (k + 1.0))
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
def next_in_slip(
    pair: Constants,
    tables: Tables,
    room: Room,
    at: tuple[int, int],
    mode: int,
    order: int,
    since: float,
    N: float,
    theta: float,
    wide: bool,
) -> Next:
    """Return how a slip goes on: its guard is s (v1 - v2), and `order` coefficients of it vanish at its start."""
    kind, side = at
    h, count = tables.h[kind, side], tables.count[kind]
    slip_guard(room, mode, order)
    off = rounding(room, tables.slip_sums[kind, order], count)
    m0, m1, m2 = off, 0.0, 0.0
    if order == 0 and pair.kappa1 * (since + theta * h) < pair.kappa:
        m0, m1 = off + 2.0 * pair.kappa1 * since * N * h, 2.0 * pair.kappa1 * N * h * h
    elif order == 0:
        m0 = off + 2.0 * pair.kappa * N * h
    elif order == 1:
        m0 = off + 2.0 * pair.kappa1 * N * h * h
    else:
        m2 = 16.0 * pair.kappa1 * N * h * h
    how, s, alone, _, value, slope = first_root(room.q, room.q[:0], (m0, m1, m2, 0.0), theta, room.bernstein)
    if how != ROOT:
        return Next(how, s, 0.0, mode, 0.0, 0.0, 0.0, 0.0)
    low = 0.0
    if wide:
        wide_product(tables.rows[kind, side], tables.degrees[kind, side], room.z, count, room.X)
        wide_slip_guard(room, mode, order)
        s, low, value = refined(room.g, order, s, alone)
    # the rounding of the coefficients that were not dropped, at the root
    own = counted(tables.slip_own[kind, order], room.size, count, s) * (WIDE_UNIT if wide else UNIT)
    power = s**order
    steep = abs(slope) * power
    window = (abs(value) + own) * power / steep * h
    return Next(how, s, low, mode, alone, steep / (h * h), window, own * power / h)


@compilable
def next_in_stick(
    pair: Constants,
    tables: Tables,
    room: Room,
    at: tuple[int, int],
    b: Any,
    edge_side: int,
    order: int,
    N: float,
    theta: float,
    wide: bool,
) -> Next:
    """Return how stick goes on: its guards are b -+ Lambda; on an edge `order` coefficients of one of them vanish."""
    kind, side = at
    h, count = tables.h[kind, side], tables.count[kind]
    to_load = h * h / pair.m2
    edge = multiply(h, 0.0, h, 0.0)
    edge = divide(edge[0], edge[1], pair.m2, pair.m2_low)
    edge = multiply(edge[0], edge[1], b[0], b[1])
    stick_guards(room, edge, order, edge_side)
    off = rounding(room, tables.load_sums[kind, order], count) + 2.0 * UNIT * edge[0]
    plain = rounding(room, tables.load_sums[kind, 0], count) + 2.0 * UNIT * edge[0]
    margin = pair.lam * N * to_load
    how, s, alone, which, value, slope = first_root(
        room.q, room.other, (off + margin, 0.0, 0.0, plain + margin), theta, room.bernstein
    )
    if how != ROOT:
        return Next(how, s, 0.0, 0, 0.0, 0.0, 0.0, 0.0)
    dropped = order if which == 0 else 0
    exit_side = edge_side if which == 0 else -edge_side
    low = 0.0
    if wide:
        wide_product(tables.rows[kind, side], tables.degrees[kind, side], room.z, count, room.X)
        load_guard(room, edge, dropped, exit_side)
        s, low, value = refined(room.g, dropped, s, alone)
    power = s**dropped
    own = (2.0 * edge[0] if dropped == 0 else 0.0) + counted(
        tables.load_own[kind, dropped], room.size, count, s
    ) * power
    own *= WIDE_UNIT if wide else UNIT
    steep = abs(slope) * power
    window = (abs(value) * power + own) / steep * h
    return Next(how, s, low, exit_side, alone, steep / to_load / h, window, own / to_load)


@compilable
def next_event(
    pair: Constants,
    drive: Drive,
    tables: Tables,
    room: Room,
    piece: int,
    state: tuple[int, int, int],
    since: float,
    N: float,
    to: float,
    clear_to: float,
    wide: bool,
) -> Next:
    """Return how a mode goes on: to the end `to` of a step, or to an event; up to `clear_to` none is possible.

    `state`: the mode, how many coefficients of its guard vanish at its start, and the side of the edge it begins on.
    """
    mode, order, edge_side = state
    at = drive.places[piece, 4], 1 if mode == 0 else 0
    if clear_to > 0.0 or (mode == 0 and pair.literal):
        return Next(CLEAR, min(to, clear_to) if clear_to > 0.0 else to, 0.0, 0, 0.0, 0.0, 0.0, 0.0)
    if mode != 0:
        return next_in_slip(pair, tables, room, at, mode, order, since, N, to, wide)
    return next_in_stick(pair, tables, room, at, drive.b[piece], edge_side, order, N, to, wide)
