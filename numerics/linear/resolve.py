"""Resolve: which mode follows at an event, and what the event does to the errors.

The event of the true motion is within late = 1.25 (error of the guard/slope + window) of the one that was found.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.compiled import compilable
from numerics.linear.columns import Constants, Now, Problem, Room
from numerics.linear.error_set import box, norm_of, take_in, width
from numerics.linear.modes import UNDECIDED, mode_on_surface
from numerics.linear.next_event import Next
from numerics.linear.table import UNIT

NOTHING, PIECE, CONTACT, SLIP_END, EXIT = 0, 1, 2, 3, 4
"""At the end of a step: the mode goes on; it does so in a new piece, or in a run whose mode is known; bodies that are

together start, or b or u jumps; a slip comes to v1 = v2; the load of stick comes to b.
"""


class StepEnd(NamedTuple):
    """What happens, how late it may be, the guard's slope there, and in stick how far off the guard may be."""

    kind: int
    late: float
    slope: float
    off: float


@compilable
def resolve(problem: Problem, room: Room, now: Now, event: StepEnd, u: tuple[float, float, float]) -> Now:
    """Return where a run is after an event, in which mode; UNDECIDED if the error bounds leave a doubt."""
    pair, b = problem.pair, problem.drive.b[now.piece]
    (piece, mode, order, _, since, N), late = now, event.late
    load = u[0] - pair.a2 * room.y[0] - pair.a1 * room.y[1]
    edge = (1 if load > 0.0 else 0) - (1 if load < 0.0 else 0)
    if event.kind == EXIT:
        N += errors_after_stick(pair, room, u, late, event.slope, event.off)
    elif event.kind != PIECE:
        mode = mode_after(pair, room, u, b, N, late)
        if event.kind == SLIP_END:
            if mode in (UNDECIDED, now.mode):
                return Now(piece, UNDECIDED, 0, edge, since, N)
            room.ledger[2] += b * late * errors_after_slip(pair, room, now.mode, mode, u, b, late, event.slope)
            N = min(N, norm_of(room.E, room.R))
        order, since = (1 if mode != 0 else 0), 1e300
    return Now(piece, mode, order, edge, since, N)


@compilable
def lateness(
    pair: Constants, room: Room, ahead: Next, mode: int, b: float, since: float, N: float
) -> tuple[float, float, float]:
    """Return by how much the true event may be late, how far off the guard is there, and what the event adds to N.

    At the end of a slip both velocities become that of body 2, a polynomial of degree 1.
    """
    y, scale = room.y, room.scale
    if mode == 0:
        share = pair.m2 / pair.mass
        off = share * width(room.E, room.R, pair.a2 / scale[0], pair.a1 / scale[1], 0.0)
        off = min(off, pair.lam * N) + ahead.own
        return 1.25 * (off / ahead.slope + ahead.window), max(off, 5e-324), 0.0
    gap = abs(y[1] - y[3])
    off = min(width(room.E, room.R, 0.0, 1.0 / scale[1], -1.0 / scale[3]), min(pair.kappa, pair.kappa1 * since) * N)
    off += gap + ahead.own
    room.R[0] += scale[1] * gap
    y[1] = y[3]
    late = 1.25 * (off / ahead.slope + ahead.window)
    return late, 0.0, 2.0 * b * pair.kappa * ahead.window + scale[1] * gap


@compilable
def mode_after(pair: Constants, room: Room, u: tuple[float, float, float], b: float, N: float, late: float) -> int:
    """Return the mode that follows where v1 = v2 within `late` of now."""
    share = pair.m2 / pair.mass
    x, v = room.y[0], room.y[1]
    load = share * (u[0] - pair.a2 * x - pair.a1 * v)
    off = 16.0 * UNIT * (share * (u[2] + pair.a2 * abs(x) + pair.a1 * abs(v)) + b)
    off += min(share * width(room.E, room.R, pair.a2 / room.scale[0], pair.a1 / room.scale[1], 0.0), pair.lam * N)
    change = (abs(u[0] - pair.a2 * x - pair.a1 * v) + b) / pair.m1  # of v1, per second
    off += 1.25 * share * late * (u[1] + pair.a2 * (abs(v) + change * late) + pair.a1 * change)
    return mode_on_surface(load, b, off, pair.literal)


@compilable
def errors_after_slip(
    pair: Constants,
    room: Room,
    before: int,
    after: int,
    u: tuple[float, float, float],
    b: float,
    late: float,
    slope: float,
) -> float:
    """Turn the errors by what the end of a slip does to them; return how far apart the velocities may have been.

    m1 v1 + m2 v2 goes on; the error of w is multiplied by w'(new)/w'(old), in [0, 1], to first order in `late`.
    """
    E, R, scale = room.E, room.R, room.scale
    share, v = pair.m1 / pair.mass, room.y[1]
    force = u[0] - pair.a2 * room.y[0] - pair.a1 * v
    kept = 0.0
    if after != 0:
        kept = ((force - after * b) / pair.m1 - after * b / pair.m2) / (-before * slope)
    drift = pair.a2 * box(E, R, 0) / scale[0] + pair.a1 * box(E, R, 1) / scale[1]
    for j in range(4):
        d1, d2 = E[1, j] / scale[1], E[3, j] / scale[3]
        E[1, j] = scale[1] * ((share + (1.0 - share) * kept) * d1 + (1.0 - share) * (1.0 - kept) * d2)
        E[3, j] = scale[3] * (share * (1.0 - kept) * d1 + (1.0 - share + share * kept) * d2)
    bend = 2.0 * (u[1] + pair.a1 * (abs(force) + b) / pair.m1 + pair.a2 * abs(v)) / pair.m1
    bend += 2.0 * math.sqrt(pair.a2 / pair.m1) * (abs(force) + b) / pair.m1
    apart = late * (2.0 * slope + bend * late)
    rest = (pair.a1 * apart + pair.a2 * apart * late) * late / pair.mass
    if after != 0:
        rest += 2.0 * late * drift / pair.m1 + bend * late * late
    R[0] += (scale[1] + scale[3]) * rest + scale[0] * apart * late
    R[1] += scale[2] * apart * late
    take_in(E, R, room.basis, room.column)
    return apart


@compilable
def errors_after_stick(
    pair: Constants, room: Room, u: tuple[float, float, float], late: float, slope: float, off: float
) -> float:
    """Add what a late exit does to the errors: w and w' are 0 in both motions at their times; return what N gains."""
    E, R, scale = room.E, room.R, room.scale
    drift = pair.a2 * box(E, R, 0) / scale[0] + pair.a1 * box(E, R, 1) / scale[1]
    third = slope / pair.m2 * pair.mass / pair.m1
    fourth = 2.0 * (
        third * (pair.a1 + math.sqrt(pair.a2 * pair.m1)) / pair.m1 + u[1] / pair.m1 * math.sqrt(pair.a2 / pair.m1)
    )
    apart = late * (pair.mass / (pair.m1 * pair.m2) * (2.0 * off + 2.0 * slope * late) + (third + fourth * late) * late)
    R[0] += scale[0] * apart * late + scale[3] * apart
    R[0] += scale[1] * (apart + (drift + pair.a1 * apart) * late / pair.m1 * late)
    R[1] += scale[2] * apart * late
    return apart * math.sqrt(pair.m1 + pair.m2)
