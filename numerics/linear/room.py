"""What the engine works with in float64: the pieces of a scene, room for a run, and the components of z."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, product, times
from numerics.linear.model import DRIVEN, EDGE, FIRST, SLIP, STICK, V1, V2, X2, Norm
from numerics.linear.table import MEET, OTHERS, SIGNED, STATE, Tables

FAST: dict[str, Any] = {"fastmath": {"contract", "reassoc"}}


class Drive(NamedTuple):
    """The signals by pieces.

    places (n, 5): kind, first coefficient, first sine, 1 where a stick may end as the piece begins, 1 where the belt's
    velocity may jump. Coefficients (k,) and sines (k, 3, 2), amplitude, omega and phase where the piece begins, in the
    order of the signals; these and length (n, 2) with what their rounding left out, which counts in long runs.
    """

    places: Any
    length: Any
    coefficients: Any
    sines: Any


class Problems(NamedTuple):
    """What runs follow, one beside another: the numbers of their norms (n, 8), and arrays of their drives, (n, ...).

    `literal`: sgn(0) = 0, so that a stick never ends.
    """

    norms: Any
    drives: Drive
    tables: Tables
    literal: bool


class Run(NamedTuple):
    """One of several problems, and arrays to work in, made once for a run."""

    norm: Norm
    drive: Drive
    tables: Tables
    literal: bool
    y: Any
    """(4,) x1, v1, x2, v2."""
    clock: Any
    """(2, 2) time in the piece, time since the last row; each with what its rounding left out."""
    z: Any
    """(n,)"""
    size: Any
    """(n,) what the roundings of z are counted in."""
    series: Any
    """(3, terms): Taylor coefficients of a guard without those that are exactly 0, or of a number of the state; the
    last in Bernstein's basis."""
    counts: Any
    """(3,) how many rows there were, also those left out, how many events, and which row was that of the last one."""


class Now(NamedTuple):
    """Where a run is, beside what stands in its room: the piece, the mode from here on, and its errors."""

    piece: int
    mode: int
    kind: int
    """That of the piece and of the cell of friction (Tables)."""
    order: int
    """How many coefficients of the guard `edge` vanish here."""
    edge: int
    """The guard of stick that is nearer, or was where the segment began; that of a slip which vanished there."""
    late: float
    """By how much later the true motion may begin this segment, s; 0 once it surely has."""
    N: float
    """A bound on N of the error (model.py)."""
    far: float
    """A bound on the error of x1, where time gives a better one than N."""
    far_2: float
    """The same of x2."""
    apart: float
    """A bound on the error of x1 - x2."""
    speed_apart: float
    """The same of v1 - v2 in a slip."""


def space_for(tables: Tables) -> NDArray[np.float64]:
    """Return room for the arrays of a run."""
    n, terms = tables.rows.shape[3:]
    return np.zeros((9, max(terms, n + n % 2)))


@compilable
def run_of(problems: Problems, one: int, space: Any) -> Run:
    """Return a run of one of several problems in some space, where no references are counted."""
    (norms, drives, tables, literal), n = problems, problems.tables.rows.shape[3]
    own = norms[one]
    norm = Norm(own[0], own[1], own[2], own[3], own[4], own[5], own[6], own[7])
    drive = Drive(drives.places[one], drives.length[one], drives.coefficients[one], drives.sines[one])
    y, clock, z, size, counts = space[0, :STATE], space[1:3, :2], space[3, :n], space[4, :n], space[5, :3]
    return Run(norm, drive, tables, literal, y, clock, z, size, space[6:9], counts)


@compilable
def place_of(now: Now) -> tuple[int, int]:
    """Return where the tables of the mode are: its kind, and SLIP or STICK."""
    return now.kind, STICK if now.mode == 0 else SLIP


@compilable
def meeting(tables: Tables, kind: int, mode: int) -> int:
    """Return the kind of the mode that meets another one at v1 = v2."""
    return int(tables.neighbours[kind, MEET, 1 + mode])


@compilable
def has_cells(tables: Tables, kind: int) -> bool:
    """Return whether friction depends on the state: else one cell serves both slips."""
    return bool(tables.neighbours[kind, MEET, 0] != tables.neighbours[kind, MEET, 2])


@compilable
def load_off(run: Run, kind: int, now: Now) -> float:
    """Return by how much a guard of stick may be off."""
    return run.norm.load * now.N + abs(run.tables.lines[kind, STICK, OTHERS + EDGE, X2]) * now.apart


@compilable_with(**FAST)
def dot(row: Any, z: Any) -> float:
    """Return the value of a row."""
    total = 0.0
    for j in range(len(z)):
        total += row[j] * z[j]
    return total


@compilable_with(**FAST)
def size_of(row: Any, size: Any) -> float:
    """Return the sum of the sizes of its terms."""
    total = 0.0
    for j in range(len(size)):
        total += abs(row[j]) * size[j]
    return total


@compilable
def form_z(run: Run, piece: int) -> None:
    """Form z at the time of the clock, in no mode: b has no sign, and the bodies need not be together."""
    drive, tables, z, size, time = run.drive, run.tables, run.z, run.size, pair_of(run.clock[0])
    kind, coefficient, sine = drive.places[piece, 0], drive.places[piece, 1], drive.places[piece, 2]
    for i in range(STATE):
        z[i], size[i] = run.y[i], abs(run.y[i])
    for signal in range(tables.blocks.shape[1]):
        first, terms, sines, waves = tables.blocks[kind, signal]
        for k in range(terms):
            derivative(drive.coefficients[coefficient : coefficient + terms], k, time.high, first + k, z, size)
        for k in range(waves):
            swing(drive.sines[sine + k], time, sines + 2 * k, z, size)
        coefficient += terms
        sine += waves
    if run.norm.root_m2 == 0.0:
        driven = tables.lines[kind, 0, OTHERS + DRIVEN]
        z[V2] = run.y[3] = dot(driven, z)
        size[V2] = size_of(driven, size)


@compilable
def enter(run: Run, piece: int, mode: int) -> None:
    """Bring z into a mode: b gets the sign of a slip, and in stick body 1 goes with the belt."""
    z, signed = run.z, run.tables.lines[run.drive.places[piece, 0], 0, SIGNED]
    if mode < 0:
        for j in range(FIRST, len(z)):
            if signed[j] == 1.0:
                z[j] = -z[j]
    elif mode == 0 and run.norm.root_m2 == 0.0:
        z[V1], run.size[V1] = z[V2], run.size[V2]
        run.y[1] = z[V2]


@compilable
def derivative(coefficients: Any, order: int, t: float, at: int, z: Any, size: Any) -> None:
    """Write a derivative of a polynomial at t into z."""
    value, most = 0.0, 0.0
    for n in range(coefficients.shape[0] - 1, order - 1, -1):
        own = coefficients[n]
        for i in range(order):
            own *= n - i
        most = most * t + abs(own) * (2.0 + 2.0 * n)
        value = value * t + own
    z[at], size[at] = value, most


@compilable
def swing(sine: Any, time: TwoFloats, at: int, z: Any, size: Any) -> None:
    """Write amplitude times sine and cosine of a phase into z."""
    phase = plus(product(pair_of(sine[1]), time), pair_of(sine[2]))
    turns = np.rint(phase.high * 0.15915494309189535)
    rest = plus(phase, times(TwoFloats(6.283185307179586, 2.4492935982947064e-16), -turns))
    s, c = math.sin(rest.high), math.cos(rest.high)
    z[at], z[at + 1] = sine[0, 0] * (s + c * rest.low), sine[0, 0] * (c - s * rest.low)
    # the phase is off by 2^-101 of its own size, so that a small sine stays sharp
    one, two, turned = abs(z[at]), abs(z[at + 1]), abs(phase.high) * 2.0**-48
    size[at], size[at + 1] = 2.0 * one + turned * two, 2.0 * two + turned * one


@compilable_with(**FAST)
def polynomial_of(rows: Any, degrees: Any, z: Any, order: int, q: Any) -> None:
    """Form the Taylor polynomial of a row over a step, divided by (t/h)^order: its first coefficients are dropped."""
    for k in range(q.shape[0]):
        q[k] = 0.0
    for j in range(len(z)):
        row, factor = rows[j, order : degrees[j]], z[j]
        for k in range(row.shape[0]):
            q[k] += row[k] * factor
