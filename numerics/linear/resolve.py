"""Resolve: which mode follows at an event, and what the event does to the errors.

The event of the true motion is within late = 1.25 (error of the guard/slope) of the one that was found.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with, inlined
from numerics.linear.evolve import parting
from numerics.linear.model import AHEAD, CEILING, EDGE, FLOOR, KINETIC, SLIP, STICK, V1, V2, X1, X2
from numerics.linear.next_event import Next
from numerics.linear.room import Now, Run, dot, has_cells, load_off, meeting, place_of, size_of
from numerics.linear.table import BEHIND, GUARDS, OF_V1, OTHERS, RATES, SIGNED, UNIT

NOTHING, PIECE, CONTACT, SLIP_END, EXIT, NEXT_CELL = 0, 1, 2, 3, 4, 5
"""At the end of a step: the mode goes on; it does so in a new piece, or in a run whose mode is known; bodies that are
together start, or something jumps; a slip comes to v1 = v2; the load of stick comes to the edge; a slip goes on in
another cell of friction."""
NO_MODE = 2
"""As a mode: the bounds leave open which one follows."""


class StepEnd(NamedTuple):
    """What happens, and how late it may be."""

    kind: int
    late: float


@inlined
def lateness(run: Run, now: Now, ahead: Next) -> tuple[float, float]:
    """Return by how much the true event may be late, and by how much rounding alone may have misplaced it."""
    if now.mode == 0:
        off = load_off(run, now.kind, now)
    elif ahead.guard == AHEAD:
        off = now.apart
    else:
        off = now.speed_apart
    return 1.25 * (off + ahead.own) / ahead.slope, 1.25 * ahead.own / ahead.slope


@compilable
def arrived(run: Run, now: Now, ahead: Next) -> tuple[Now, StepEnd]:
    """Return where the run is when a guard has vanished; the errors grow by what the event may be misplaced.

    During that time friction is off by 2 b, where static friction lets go or takes hold by b_static - b; at an exit
    both motions leave v1 = v2 with w' = 0, so that little comes of it. They may be in different cells: N then grows by
    the steepest of their slopes and pulls.
    """
    norm, tables, y, z, piece, far, far_2 = run.norm, run.tables, run.y, run.z, now.piece, now.far, now.far_2
    late, window = lateness(run, now, ahead)
    lines, steep, pull = tables.lines[place_of(now)], norm.steep, norm.pull
    factor, N = 1.0 + 4.0 * steep * late, now.N + 4.0 * pull * now.apart * late
    apart = now.apart + 2.0 * norm.kappa * now.N * late
    if now.mode != 0 and (ahead.guard != FLOOR or tables.ends[now.kind, FLOOR] != 0.0):
        behind, order = int(tables.neighbours[now.kind, BEHIND, ahead.guard]), 0 if ahead.guard == AHEAD else 1
        mode, edge = now.mode if behind >= 0 else NO_MODE, CEILING if ahead.guard == FLOOR else FLOOR
        kind = behind if behind >= 0 else now.kind
        N = factor * (N + 8.0 * (steep / norm.kappa + pull) * ahead.own * window)
        return Now(piece, mode, kind, order, edge, late, N, far, far_2, apart, norm.kappa * N), StepEnd(NEXT_CELL, 0.0)
    z[X1], z[V1], z[X2], z[V2] = y[0], 0.0, y[2], 0.0  # at v1 = v2
    b = abs(dot(lines[OTHERS + KINETIC], z))
    above = abs(dot(lines[OTHERS + EDGE], z)) - b
    N += norm.kappa * above * late
    if now.mode == 0:
        parted = 4.0 * norm.kappa * window * (ahead.own + ahead.slope * window)
        N = factor * (N + parted)
        mode, order, kind = 1 - 2 * ahead.guard, 1, meeting(tables, now.kind, 1 - 2 * ahead.guard)
        speed_apart = norm.kappa * N
        if above <= 0.0:  # whichever leaves first does so with w' = 0
            order, speed_apart = 2, min(speed_apart, norm.kappa * parted + parting(run, now, N, apart) * late)
        return Now(piece, mode, kind, order, FLOOR, late, N, far, far_2, apart, speed_apart), StepEnd(EXIT, late)
    gap = abs(y[1] - y[3])
    y[1] = y[3]
    N = factor * (N + 2.0 * norm.kappa * b * window) + norm.root_m1 * gap
    after = Now(piece, now.mode, now.kind, 0, FLOOR, late, N, far, far_2, apart, norm.kappa * N)
    return after, StepEnd(SLIP_END, late)


@inlined
def resolve(run: Run, now: Now, event: StepEnd) -> Now:
    """Return where a run is after an event, in which mode; NO_MODE if the error bounds leave a doubt.

    z is that of the event, with b unsigned.
    """
    mode, order, y = now.mode, now.order, run.y
    lines = run.tables.lines[meeting(run.tables, now.kind, 0), STICK]
    one, two = dot(lines[GUARDS], run.z), dot(lines[GUARDS + 1], run.z)
    gap = y[1] - y[3]
    if event.kind == CONTACT and gap != 0.0:  # the belt's velocity has jumped
        off = run.norm.kappa * now.N + 32.0 * UNIT * run.size[V2]
        mode = NO_MODE if abs(gap) <= off or has_cells(run.tables, now.kind) else 1 if gap > 0.0 else -1
    elif event.kind in (CONTACT, SLIP_END):
        mode = mode_after(run, now, (one, two), event.late)
        if event.kind == SLIP_END and mode == now.mode:
            mode = NO_MODE
        order = 1 if mode != 0 else 0
    late = event.late if mode != now.mode or event.kind == EXIT else now.late
    edge = now.edge if mode == now.mode and mode != 0 else 0 if mode != 0 or one <= two else 1
    kind = now.kind if mode in (now.mode, NO_MODE) else meeting(run.tables, now.kind, mode)
    parted = now.speed_apart if mode == now.mode else run.norm.kappa * now.N
    return Now(now.piece, mode, kind, order, edge, late, now.N, now.far, now.far_2, now.apart, parted)


@compilable
def mode_after(run: Run, now: Now, values: tuple[float, float], late: float) -> int:
    """Return the mode that follows where v1 = v2 within `late` of now, from the values of the guards of stick."""
    if run.literal:
        return 0
    tables, kind = run.tables, meeting(run.tables, now.kind, 0)
    at_edge, fast = 0, max(fastest(run, now, 0, late), fastest(run, now, 1, late))
    for g in range(2):
        off = load_off(run, kind, now) + 32.0 * UNIT * size_of(tables.lines[kind, STICK, GUARDS + g], run.size)
        off += 1.25 * late * fast
        if values[g] < -off:
            return 1 - 2 * g
        at_edge += 0 if values[g] > off else 1
    return NO_MODE if at_edge > 0 else 0


@compilable
def reach_of(row: Any, z: Any, signed: Any) -> float:
    """Return the greatest value of a row for either sign of b."""
    own, of_friction = 0.0, 0.0
    for j in range(len(z)):
        term = row[j] * z[j]
        of_friction += signed[j] * term
        own += (1.0 - signed[j]) * term
    return abs(own) + abs(of_friction)


@compilable_with(forceinline=False)
def most_of(row: Any, signed: Any, A: Any, z: Any, late: float) -> float:
    """Return the greatest value of a row for either sign of b, within `late` of where z stands in the mode of A."""
    most = reach_of(row, z, signed)
    if late > 0.0:
        for j in range(len(A)):
            most += 2.0 * late * abs(row[j]) * reach_of(A[j], z, signed)
    return most


@compilable
def fastest(run: Run, now: Now, rate: int, late: float) -> float:
    """Return the greatest of one of the RATES in any mode within `late` of where a run is."""
    tables, most = run.tables, 0.0
    for mode in range(-1 if has_cells(tables, now.kind) else 0, 2):  # one cell serves both slips
        at = meeting(tables, now.kind, mode), SLIP if mode != 0 else STICK
        if mode != 0 or run.literal or rate < OF_V1:  # else stick's is between those of the slips
            lines = tables.lines[at]
            moved = late if late > 1e-8 * tables.steps[at] else 0.0  # else less than rounding
            most = max(most, most_of(lines[RATES + rate], lines[SIGNED], tables.A[at], run.z, moved))
    return most
