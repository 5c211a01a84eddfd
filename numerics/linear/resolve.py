"""Resolve: which mode follows at an event, and what the event does to the errors.

The event of the true motion is within late = 1.25 (error of the guard/slope) of the one that was found.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.linear.model import EDGE, KINETIC, SLIP, STICK, V1, V2
from numerics.linear.next_event import Next
from numerics.linear.room import Now, Run, dot, place_of, size_of
from numerics.linear.table import GUARDS, OTHERS, RATES, SIGNED, UNIT

NOTHING, PIECE, CONTACT, SLIP_END, EXIT = 0, 1, 2, 3, 4
"""At the end of a step: the mode goes on; it does so in a new piece, or in a run whose mode is known; bodies that are
together start, or something jumps; a slip comes to v1 = v2; the load of stick comes to the edge."""
UNDECIDED = 2
"""As a mode: the bounds leave open which one follows."""


class StepEnd(NamedTuple):
    """What happens, and how late it may be."""

    kind: int
    late: float


@compilable
def lateness(run: Run, now: Now, ahead: Next) -> tuple[float, float]:
    """Return by how much the true event may be late, and by how much rounding alone may have misplaced it."""
    norm = run.norm
    reach = norm.load if now.mode == 0 else min(norm.kappa, norm.bend * now.since)
    return 1.25 * (reach * now.N + ahead.own) / ahead.slope, 1.25 * ahead.own / ahead.slope


@compilable
def arrived(run: Run, now: Now, ahead: Next) -> tuple[Now, StepEnd]:
    """Return where the run is when a guard has vanished; the errors grow by what the event may be misplaced.

    During that time friction is off by 2 b, where static friction lets go or takes hold by b_static - b; at an exit
    both motions leave v1 = v2 with w' = 0, so that little comes of it.
    """
    norm, y = run.norm, run.y
    late, window = lateness(run, now, ahead)
    lines = run.tables.lines[place_of(run, now)]
    b = abs(dot(lines[OTHERS + KINETIC], run.z))
    above = abs(dot(lines[OTHERS + EDGE], run.z)) - b
    N, apart = now.N + norm.kappa * above * late, now.apart + 2.0 * norm.kappa * now.N * late
    if now.mode == 0:
        N += 4.0 * norm.kappa * window * (ahead.own + ahead.slope * window)
        mode, order, since = 1 - 2 * ahead.guard, 2 if above <= 0.0 else 1, 0.0 if above <= 0.0 else 1e300
        return Now(now.piece, mode, order, now.edge, late, since, N, now.far, now.far_2, apart), StepEnd(EXIT, late)
    gap = abs(y[1] - y[3])
    y[1] = y[3]
    N += 2.0 * norm.kappa * b * window + norm.root_m1 * gap
    return Now(now.piece, now.mode, 0, now.edge, late, now.since, N, now.far, now.far_2, apart), StepEnd(SLIP_END, late)


@compilable
def resolve(run: Run, now: Now, event: StepEnd) -> Now:
    """Return where a run is after an event, in which mode; UNDECIDED if the error bounds leave a doubt.

    z is that of the event, with b unsigned.
    """
    mode, order, since = now.mode, now.order, now.since
    lines = run.tables.lines[run.drive.places[now.piece, 0], STICK]
    one, two = dot(lines[GUARDS], run.z), dot(lines[GUARDS + 1], run.z)
    edge = 0 if one <= two else 1
    gap = run.y[1] - run.y[3]
    if event.kind == CONTACT and gap != 0.0:  # the belt's velocity has jumped
        off = run.norm.kappa * now.N + 32.0 * UNIT * run.size[V2]
        mode = UNDECIDED if abs(gap) <= off else 1 if gap > 0.0 else -1
    elif event.kind in (CONTACT, SLIP_END):
        mode = mode_after(run, now, (one, two), event.late)
        if event.kind == SLIP_END and mode == now.mode:
            mode = UNDECIDED
        order = 1 if mode != 0 else 0
        if mode != now.mode:
            since = 1e300 if mode != 0 else 0.0
    late = event.late if mode != now.mode or event.kind == EXIT else now.late
    return Now(now.piece, mode, order, edge, late, since, now.N, now.far, now.far_2, now.apart)


@compilable
def mode_after(run: Run, now: Now, values: tuple[float, float], late: float) -> int:
    """Return the mode that follows where v1 = v2 within `late` of now, from the values of the guards of stick."""
    if run.literal:
        return 0
    tables, kind = run.tables, run.drive.places[now.piece, 0]
    at_edge = 0
    for g in range(2):
        off = run.norm.load * now.N + 32.0 * UNIT * size_of(tables.lines[kind, STICK, GUARDS + g], run.size)
        if late > 0.0:
            fast = 0.0
            for mode in range(2):
                fast = max(fast, most_of(run, (kind, mode), tables.lines[kind, mode, RATES + g], late))
            off += 1.25 * late * fast
        if values[g] < -off:
            return 1 - 2 * g
        at_edge += 0 if values[g] > off else 1
    return UNDECIDED if at_edge > 0 else 0


@compilable
def reach_of(row: Any, z: Any, signed: Any) -> float:
    """Return the greatest value of a row for either sign of b."""
    own, of_friction = 0.0, 0.0
    for j in range(len(z)):
        if signed[j] == 1.0:
            of_friction += row[j] * z[j]
        else:
            own += row[j] * z[j]
    return abs(own) + abs(of_friction)


@compilable_with(forceinline=False)
def most_of(run: Run, at: tuple[int, int], row: Any, late: float) -> float:
    """Return the greatest value of a row for either sign of b, within `late` of where z stands in a mode."""
    tables, (kind, mode) = run.tables, at
    signed, A = tables.lines[kind, mode, SIGNED], tables.A[kind, mode]
    most = reach_of(row, run.z, signed)
    if late > 1e-8 * tables.steps[kind, mode]:  # else less than rounding
        for j in range(len(A)):
            most += 2.0 * late * abs(row[j]) * reach_of(A[j], run.z, signed)
    return most


@compilable
def fastest(run: Run, now: Now, body: int, late: float) -> float:
    """Return the greatest |v1'| (body 0) or |v2'| (body 1) of any mode within `late` of where a run is."""
    tables, kind = run.tables, run.drive.places[now.piece, 0]
    place, most = V2 if body == 1 else V1, 0.0
    for mode in (SLIP, STICK):
        if mode == SLIP or run.literal:  # else stick's is between those of the slips
            most = max(most, most_of(run, (kind, mode), tables.A[kind, mode, place], late))
    return most
