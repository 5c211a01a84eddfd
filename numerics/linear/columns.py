"""What the engine works with in float64: a pair, its drive, room for a run; and the columns of z.

Taylor coefficients over a step are linear in z (table.py).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, product, times
from numerics.linear.table import FIRST, FRICTION, NODES, Tables

FAST: dict[str, Any] = {"fastmath": {"contract", "reassoc"}}


class Constants(NamedTuple):
    """The pair, in units of which every power is a float, and what turns N into bounds on guards.

    kappa: |v1 - v2| <= kappa N; kappa1: |v1'| <= kappa1 N within one mode; lam: |Lambda| <= lam N in stick.
    """

    m1: float
    m2: float
    mass: float
    a1: float
    a2: float
    kappa: float
    kappa1: float
    lam: float
    literal: bool


@compilable
def constants(pair: Any, literal: bool) -> Constants:
    """Return the constants of a pair: m1, m1 + m2, m2, a1, a2 (5, 2), each with the rest."""
    m1, mass, m2, a1, a2 = pair[0, 0], pair[1, 0], pair[2, 0], pair[3, 0], pair[4, 0]
    pull, slack = math.hypot(math.sqrt(a2), a1 / math.sqrt(m1)), 1.0 + 1e-12  # for the rounding of the bounds
    kappa, share = math.sqrt(mass / (m1 * m2)) * slack, m2 / mass
    return Constants(m1, m2, mass, a1, a2, kappa, pull / m1 * slack, share * pull * slack, literal)


class Drive(NamedTuple):
    """Force and friction by pieces: b (n,) and coefficients (k,).

    places (n, 6): first coefficient, their number, first sine, their number, kind of force, 1 where u or b may jump.
    length (n, 2) and sines (k, 3, 2), amplitude, omega and phase where the piece begins: each with what its rounding
    left out, which counts in long runs.
    """

    places: Any
    b: Any
    length: Any
    coefficients: Any
    sines: Any


class Problem(NamedTuple):
    """What a run follows; `has_ledger`: what friction and viscosity take is formed, too."""

    pair: Constants
    drive: Drive
    tables: Tables
    has_ledger: bool


class Now(NamedTuple):
    """Where a run is, beside what stands in its room: the piece, and the mode from here on."""

    piece: int
    mode: int
    order: int
    """How many coefficients of the mode's guard vanish here."""
    edge: int
    """The side of the load when the segment began, and so of the edge of stick that is nearer; 0 without a load."""
    since: float
    """Time since the exit that this slip began with, 1e300 if it began otherwise."""
    N: float
    """A bound on N of the error (error_set.py)."""


class Room(NamedTuple):
    """Arrays to work in, made once for a run."""

    y: Any
    """(4,) x1, v1, x2, v2."""
    clock: Any
    """(2, 2) time in the piece, time since the last row; each with what its rounding left out."""
    z: Any
    """(n,)"""
    size: Any
    """(n,) what the roundings of z are counted in."""
    X: Any
    """(2, terms) coefficients of x1 and x2."""
    g: Any
    """(terms,) a guard, and that without the coefficients that are exactly 0."""
    q: Any
    inverse: Any
    """(terms,) 1/(k + 1)."""
    twice: Any
    """(terms,) (k + 1) (k + 2), of a second derivative."""
    bernstein: Any
    E: Any
    R: Any
    scale: Any
    basis: Any
    column: Any
    nodes: Any
    """(2, n) Gauss's nodes in a part of a step, and v1 there."""
    ledger: Any
    """(3,) what friction and what viscosity took, and a bound on the error of their sum."""
    counts: Any
    """(3,) how many rows there were, also those left out, how many events, and which row was that of the last one."""


@compilable_with(makes_arrays=True, forceinline=False)
def make_room(count: int, terms: int) -> Room:
    """Return room for n columns."""
    return Room(
        np.zeros(4),
        np.zeros((2, 2)),
        np.zeros(count),
        np.zeros(count),
        np.zeros((2, terms)),
        np.zeros(terms),
        np.zeros(terms),
        1.0 / np.arange(1, terms + 1),
        np.arange(1.0, terms + 1) * np.arange(2.0, terms + 2),
        np.zeros(8),
        np.zeros((4, 4)),
        np.zeros(2),
        np.zeros(4),
        np.zeros((4, 4)),
        np.zeros(4),
        np.zeros((2, NODES.shape[0])),
        np.zeros(3),
        np.zeros(3, dtype=np.int64),
    )


@compilable
def force_columns(room: Room, drive: Drive, piece: int, late: float) -> tuple[float, float, float]:
    """Form the columns of z that belong to u at the time of the clock; return u, a bound on |u'| within `late` of it,

    and the size of u's terms.
    """
    place, z, size, time = drive.places[piece], room.z, room.size, pair_of(room.clock[0])
    first, terms, first_sine, sines = place[0], place[1], place[2], place[3]
    for k in range(terms):
        value, most = 0.0, 0.0
        for n in range(terms - 1, k - 1, -1):
            factor = 1.0  # n over k
            for i in range(k):
                factor = factor * (n - i) / (i + 1)
            own = drive.coefficients[first + n] * factor
            most = most * time.high + abs(own) * (2.0 + 2.0 * n)
            value = value * time.high + own
        z[FIRST + k], size[FIRST + k] = value, most
    u0, u1, height = 0.0, 0.0, 0.0
    if terms > 0:
        u0, height = z[FIRST], size[FIRST]
    for k in range(terms - 1, 0, -1):
        u1 = u1 * late + k * abs(z[FIRST + k])
    for i in range(sines):
        sine, at = drive.sines[first_sine + i], FIRST + terms + 2 * i
        phase = plus(product(pair_of(sine[1]), time), pair_of(sine[2]))
        turns = np.rint(phase.high * 0.15915494309189535)
        rest = plus(phase, times(TwoFloats(6.283185307179586, 2.4492935982947064e-16), -turns))
        s, c = math.sin(rest.high), math.cos(rest.high)
        z[at], z[at + 1] = sine[0, 0] * (s + c * rest.low), sine[0, 0] * (c - s * rest.low)
        # the phase is off by 2^-101 of its own size, so that a small sine stays sharp
        one, two, turned = abs(z[at]), abs(z[at + 1]), abs(phase.high) * 2.0**-48
        size[at], size[at + 1] = 2.0 * one + turned * two, 2.0 * two + turned * one
        u0 += z[at]
        u1 += sine[1, 0] * (two + min(1.0, sine[1, 0] * late) * one)
        height += size[at]
    return u0, u1, height


@compilable
def state_columns(room: Room, mode: int, b: float) -> None:
    """Put the state and the friction force into z."""
    for i in range(4):
        room.z[i], room.size[i] = room.y[i], abs(room.y[i])
    room.z[FRICTION], room.size[FRICTION] = mode * b, b if mode != 0 else 0.0


@compilable_with(**FAST)
def coefficients_of(rows: Any, degrees: Any, z: Any, count: int, bodies: int, X: Any) -> None:
    """Form X = W z, of both bodies or of the first one."""
    for i in range(bodies):
        x, first, factor = X[i], rows[i, 0], z[0]
        for k in range(x.shape[0]):
            x[k] = first[k] * factor
        for j in range(1, count):
            row, factor = rows[i, j], z[j]
            for k in range(degrees[i, j]):
                x[k] += row[k] * factor


@compilable
def counted(sums: Any, size: Any, count: int, s: float) -> float:
    """Return what is counted of a series at s in [0, 1], in roundings; `sums` (2, n): of each column at 0 and 1.

    All its terms are positive, so that between 0 and 1 it is below its chord.
    """
    total = 0.0
    for j in range(count):
        total += size[j] * (sums[0, j] + s * (sums[1, j] - sums[0, j]))
    return total


@compilable
def place_of(problem: Problem, now: Now) -> tuple[int, int]:
    """Return where the tables of the mode are: the kind of force, and 0 for slip, 1 for stick."""
    return problem.drive.places[now.piece, 4], 1 if now.mode == 0 else 0


@compilable
def expand(problem: Problem, room: Room, now: Now) -> None:
    """Form z, and the Taylor coefficients of x1 and x2 over a step of the mode."""
    tables, at, X = problem.tables, place_of(problem, now), room.X
    state_columns(room, now.mode, problem.drive.b[now.piece])
    bodies = 1 if now.mode == 0 else 2
    coefficients_of(tables.rows[at], tables.degrees[at], room.z, tables.count[at[0]], bodies, X)
    if now.mode == 0:  # body 2 goes as body 1 does, bit by bit
        X[1, 0] = room.y[2]
        for k in range(1, X.shape[1]):
            X[1, k] = X[0, k]
