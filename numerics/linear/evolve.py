"""Evolve: the state, the clock and the errors over a step, or to an event."""

from __future__ import annotations

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, put, two_product
from numerics.linear.first_root import value_slope
from numerics.linear.model import X1, X2, Norm
from numerics.linear.room import Now, Problem, Room, between, dot, place_of, polynomial_of
from numerics.linear.table import STATE, UNIT


@compilable
def evolve(problem: Problem, room: Room, now: Now, s: float) -> Now:
    """Move state, clock and errors by a part s of a step; return where the run is."""
    tables, at, is_part = problem.tables, place_of(problem, now), 1 if s != 1.0 else 0
    count, h = tables.count[at[0]], tables.h[at]
    for i in range(STATE):
        if is_part:
            polynomial_of(tables.rows[at][i], tables.degrees[at][i], room.z, count, 0, room.q[0])
            room.y[i], _ = value_slope(room.q[0], s)
        else:
            room.y[i] = dot(tables.flow[at][i], room.z, count)
    own, size = tables.own[at], room.size
    if is_part:
        added = between(own[1, 0], own[2, 0], s, size, count), between(own[1, 1], own[2, 1], s, size, count)
        last = between(own[1, 2], own[2, 2], s, size, count)
    else:
        added, last = (
            (UNIT * dot(own[0, 0], size, count), UNIT * dot(own[0, 1], size, count)),
            UNIT * dot(own[0, 2], size, count),
        )
    both_stick = now.mode == 0 and not is_part and now.since > now.late
    factor = tables.shrink[at[0]] if both_stick else 1.0
    return moved(problem.norm, room, now, two_product(s, h), (added[0], added[1], last), factor)


@compilable
def moved(norm: Norm, room: Room, now: Now, time: TwoFloats, own: tuple[float, float, float], factor: float) -> Now:
    """Move clock and errors by a step of the state, which was rounded by `own` in N, x1 and x2.

    N shrinks by a factor; until then positions may part as fast as before.
    """
    y, z = room.y, room.z
    most, N, parted = now.N + own[0], now.N * factor + own[0], own[1] + own[2]
    if now.mode == 0:  # body 2 goes where body 1 does
        y[3] = y[1]
        y[2] = z[X2] + (y[0] - z[X1])
        parted = 2.0 * UNIT * (abs(y[0]) + abs(z[X1]) + abs(z[X2]) + abs(y[2]))
    else:
        parted += norm.kappa * most * time.high
    for i in range(2):
        put(room.clock[i], plus(pair_of(room.clock[i]), time))
    apart = now.apart + parted
    far = now.far + own[1] + most / norm.root_m1 * time.high
    own_2 = own[1] + parted if now.mode == 0 else own[2]
    far_2 = now.far_2 + own_2 + (most / norm.root_m2 * time.high if norm.root_m2 > 0.0 else 0.0)
    return Now(now.piece, now.mode, 0, now.edge, now.late, now.since + time.high, N, far, far_2, apart)
