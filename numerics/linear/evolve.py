"""Evolve: the state, the clock and the errors over a step, or to an event."""

from __future__ import annotations

import math
from typing import Any

from numerics.arithmetic.compiled import compilable, compilable_with, inlined
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, put, two_product
from numerics.linear.first_root import value_slope
from numerics.linear.model import KINETIC, V1, X1, X2
from numerics.linear.room import Now, Run, dot, place_of, polynomial_of
from numerics.linear.table import FLOW, OTHERS, OWN, STATE, UNIT


@inlined
def evolve(run: Run, now: Now, s: float) -> Now:
    """Move state, clock and errors by a part s of a step; return where the run is."""
    tables, at, is_part = run.tables, place_of(now), 1 if s != 1.0 else 0
    h, lines, q = tables.steps[at], tables.lines[at], run.series[0]
    if is_part:
        for x in range(X1, STATE if now.mode != 0 else V1, X2 - X1):
            polynomial_of(tables.rows[at][x], tables.degrees[at][x], run.z, 0, q)
            run.y[x], slope = value_slope(q, s)
            run.y[x + 1] = slope / h
        if now.mode == 0 and run.norm.root_m2 == 0.0:  # exactly the velocity of a steady belt
            polynomial_of(tables.rows[at][V1], tables.degrees[at][V1], run.z, 0, q)
            run.y[V1], _ = value_slope(q, s)
    else:
        for i in range(STATE):
            run.y[i] = dot(lines[FLOW + i], run.z)
    own = rounded(lines, 0, s, run.size), rounded(lines, 1, s, run.size), rounded(lines, 2, s, run.size)
    both_stick = now.mode == 0 and not is_part and now.late == 0.0
    factor = tables.steps[at[0], 2] if both_stick else 1.0
    return moved(run, now, two_product(s, h), own, factor)


@compilable
def rounded(lines: Any, which: int, s: float, size: Any) -> float:
    """Return what is rounded of N, x1 or x2 over a part s of a step: positive terms are below their chord."""
    if s == 1.0:
        return UNIT * dot(lines[OWN + which], size)
    begun, ended = dot(lines[OWN + 3 + which], size), dot(lines[OWN + 6 + which], size)
    return UNIT * (begun + s * (ended - begun))


@compilable
def moved(run: Run, now: Now, time: TwoFloats, own: tuple[float, float, float], factor: float) -> Now:
    """Move clock and errors by a step of the state, which was rounded by `own` in N, x1 and x2.

    N of a stick shrinks by a factor; until then positions may part as fast as before.
    """
    norm, y, z, parted = run.norm, run.y, run.z, own[1] + own[2]
    N, apart = grown(run, now, now.N + own[0], time.high)
    most = N
    if now.mode == 0:  # body 2 goes where body 1 does
        N = now.N * factor + own[0]
        y[3] = y[1]
        y[2] = z[X2] + (y[0] - z[X1])
        parted = 2.0 * UNIT * (abs(y[0]) + abs(z[X1]) + abs(z[X2]) + abs(y[2]))
    for i in range(2):
        put(run.clock[i], plus(pair_of(run.clock[i]), time))
    far = now.far + own[1] + most / norm.root_m1 * time.high
    own_2 = own[1] + parted if now.mode == 0 else own[2]
    far_2 = now.far_2 + own_2 + (most / norm.root_m2 * time.high if norm.root_m2 > 0.0 else 0.0)
    speed_apart = now.speed_apart + parting(run, now, most, apart) * time.high + norm.kappa * own[0]
    speed_apart, late = min(norm.kappa * most, speed_apart), max(0.0, now.late - time.high)
    return Now(now.piece, now.mode, now.kind, 0, now.edge, late, N, far, far_2, apart + parted, speed_apart)


@compilable
def parting(run: Run, now: Now, N: float, apart: float) -> float:
    """Return by how much two motions in one cell may part in v1' - v2', with these bounds on their difference."""
    kappa, friction = run.norm.kappa, run.tables.lines[place_of(now)][OTHERS + KINETIC]
    return run.norm.bend * N + kappa * kappa * (abs(friction[V1]) * kappa * N + abs(friction[X2]) * apart)


@compilable
def grown(run: Run, now: Now, N: float, t: float) -> tuple[float, float]:
    """Return bounds on N and on the error of x1 - x2 after a time in a mode, from N now."""
    kappa, friction = run.norm.kappa, run.tables.lines[place_of(now)][OTHERS + KINETIC]
    fall, pull = max(0.0, -friction[V1]), abs(friction[X2])
    if now.mode == 0:
        return N, now.apart
    if fall == 0.0 and pull == 0.0:
        return N, now.apart + kappa * N * t
    return grown_in_cell(kappa, (kappa * kappa * fall, kappa * pull), (N, now.apart), t)


@compilable_with(forceinline=False)
def grown_in_cell(
    kappa: float, rates: tuple[float, float], begun: tuple[float, float], t: float
) -> tuple[float, float]:
    """Return N and P after a time from those of its start, where N' = fall N + pull P and P' = kappa N.

    With kappa^2 = 1/m1 + 1/m2: of the difference of two motions in a cell, w and z of it,
    (N^2/2)' = -a1 v1^2 - slope w^2 - pull z w, and |w| <= kappa N.
    """
    (fall, pull), (N, P) = rates, begun
    root = math.sqrt(fall * fall + 4.0 * kappa * pull)
    all_at, half = math.exp(0.5 * fall * t), 0.5 * root * t
    slow, part = all_at * math.exp(-half), all_at * t
    if root > 0.0:  # else the squares of both rates are below all floats
        part = 2.0 * all_at * math.sinh(half) / root
    up, down = slow + 0.5 * (root + fall) * part, slow + 0.5 * (root - fall) * part
    return up * N + pull * part * P, kappa * part * N + down * P
