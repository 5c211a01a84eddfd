"""Evolve: the state, the clock and the errors over a step, or to an event."""

from __future__ import annotations

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, put, two_product
from numerics.linear.first_root import value_slope
from numerics.linear.model import Norm
from numerics.linear.room import Now, Problem, Room, dot, place_of, polynomial_of
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
    own = tables.own[at][is_part]
    sizes = room.size
    added = UNIT * dot(own[0], sizes, count), UNIT * dot(own[1], sizes, count), UNIT * dot(own[2], sizes, count)
    return moved(problem.norm, room, now, two_product(s, h), added)


@compilable
def moved(norm: Norm, room: Room, now: Now, time: TwoFloats, own: tuple[float, float, float]) -> Now:
    """Move clock and errors by a step of the state, which was rounded by `own` in N, x1 and x2."""
    if now.mode == 0:
        room.y[3] = room.y[1]
    for i in range(2):
        put(room.clock[i], plus(pair_of(room.clock[i]), time))
    N = now.N + own[0]
    apart = now.apart + own[1] + own[2] + (norm.kappa * N * time.high if now.mode != 0 else 0.0)
    far = now.far + own[1] + N / norm.root_m1 * time.high
    far_2 = now.far_2 + own[2] + (N / norm.root_m2 * time.high if norm.root_m2 > 0.0 else 0.0)
    return Now(now.piece, now.mode, 0, now.edge, now.late, now.since + time.high, N, far, far_2, apart)
