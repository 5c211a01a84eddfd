"""Tables of Taylor coefficients: what a step of a mode does to rows of z, for z' = A z.

    row z(t) = sum_k (row (h A)^k/k!) z(0) (t/h)^k

so a row has a table that depends on the pair, the frequencies and the degrees of the signals, and on nothing else: not
on the start, amplitudes or phases. It is formed by the recurrence r_(k+1) = r_k h A/(k+1), in pairs of floats so that
every coefficient is rounded once, and serves every step. No regimes of damping, no resonance.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, pair_of, plus, product, put, quotient, two_product
from numerics.linear.model import FIRST, FRICTION, STICK, V1, V2, X1, X2, Layout, ModeRows

UNIT = 2.0**-53
"""A rounding of float64."""
REACH, TERMS = 2.0, 26
"""rate h of a step, and how many Taylor terms make truncation smaller than rounding."""
ORDERS = 8
"""A guard starts with so many vanishing coefficients at most, less one."""
STATE = 4
"""So many rows are those of x1, v1, x2 and v2; the guards stand behind them."""


LINES = 68
SIGNED, GUARDS, OTHERS, RATES, FLOW, OWN, SUMS, POWERS = 0, 1, 3, 7, 11, 15, 24, 56
OF_V1, OF_V2 = 2, 3
"""Where rows of each kind begin in Tables.lines."""
BEHIND, MEET = 0, 1
"""In Tables.neighbours."""


class Tables(NamedTuple):
    """Tables for every kind of piece of a scene (first index) in slip + and in stick (second index: 0, 1).

    A kind is a layout of the signals and a cell of friction; the kinds of the cells of a piece follow each other. n
    columns at most, what a kind has no column for is 0; k < terms.
    """

    steps: Any
    """(kinds, 3): the step in slip and in stick; by which factor a step of two motions that stick makes N of their
    difference smaller, if it does."""
    blocks: Any
    """(kinds, 5, 4): where the signals stand in z (model.Layout.blocks)."""
    A: Any
    """(kinds, 2, n, n)"""
    lines: Any
    """(kinds, 2, LINES, n) rows of z: SIGNED 1 in the block of b, which changes its sign with that of a slip, else 0;
    GUARDS (2) those of the mode; OTHERS (4) LOAD, EDGE, KINETIC, DRIVEN; RATES (4) derivatives of stick's guards, v1
    and v2; FLOW (4) the state at the end of a step; OWN (3, 3) what rounding and truncation do to the state in N, of x1
    and of x2, by a whole step and by a part of it, the latter at the start and at the end; SUMS (2, ORDERS, 2) what
    they do to a guard without its first p coefficients, in roundings: at the start of a step, and at its end; POWERS
    (6, 2) what is taken and given, as products of two rows (model.ModeRows)."""
    rows: Any
    """(kinds, 2, 6, n, terms): the coefficients of x1, v1, x2, v2 and the guards in (t/h)^k by components of z."""
    degrees: Any
    """(kinds, 2, 6, n): how many terms of each there are, rounded up to an even number; later ones are 0."""
    ends: Any
    """(kinds, 3): what the guards of a slip are where v1 - v2 and x1 - x2 are 0; inf if its cell has no such end."""
    neighbours: Any
    """(kinds, 2, 3): BEHIND each end, -1 if that is not followed, as friction may vanish there; and which MEET at
    v1 = v2, slip -, stick and slip +."""


def most_terms(coefficients: int) -> int:
    """Return how many Taylor terms a table has: an even number, 14 beyond the degree of the polynomials or more."""
    return max(TERMS, coefficients + 14 + coefficients % 2)


def make_tables(kinds: int, n: int, terms: int) -> Tables:
    """Return empty tables, of one cell each; n columns at most."""
    steps, blocks = np.ones((kinds, 3)), np.zeros((kinds, 5, 4), dtype=np.int64)
    A, lines, rows = np.zeros((kinds, 2, n, n)), np.zeros((kinds, 2, LINES, n)), np.zeros((kinds, 2, 6, n, terms))
    degrees, ends = np.zeros((kinds, 2, 6, n), dtype=np.int64), np.tile([0.0, np.inf, np.inf], (kinds, 1))
    neighbours = np.full((kinds, 2, 3), -1)
    neighbours[:, MEET] = np.arange(kinds)[:, None]
    return Tables(steps, blocks, A, lines, rows, degrees, ends, neighbours)


def put_matrices(tables: Tables, kind: int | slice, layout: Layout, rows: ModeRows) -> None:
    """Write the matrices of a kind, or with a leading axis of several kinds of one layout."""
    n, (first, terms, sines, waves) = layout.size, layout.blocks[FRICTION]
    lines = tables.lines[kind, ..., :n]
    lines[..., SIGNED, first : first + terms] = lines[..., SIGNED, sines : sines + 2 * waves] = 1.0
    lines[..., GUARDS:OTHERS, :] = rows.guards
    lines[..., OTHERS:RATES, :] = rows.others[..., None, :, :]
    lines[..., POWERS:, :] = rows.powers.reshape(*lines.shape[:-2], LINES - POWERS, n)
    tables.blocks[kind], tables.A[kind, :, :n, :n] = layout.blocks, rows.A


@compilable_with(makes_arrays=True, forceinline=False)
def form(tables: Tables, norms: Any, longest: Any, exactness: float) -> None:
    """Form the tables of all kinds from their matrices, each entry of which is off by so many roundings.

    With the norms (kinds, 8); a step is REACH over the fastest rate, or `longest` (kinds,).
    """
    for kind in range(len(norms)):
        n, scale = FIRST, (norms[kind, 0], norms[kind, 1], 0.0, norms[kind, 2])
        for block in tables.blocks[kind]:
            n += block[1] + 2 * block[3]
        for mode in range(2):
            form_mode(tables, kind, mode, n, scale, exactness, longest[kind])
        tables.steps[kind, 2] = shrinking(tables.lines[kind, STICK, FLOW:OWN], scale)


@compilable_with(makes_arrays=True, inline="always")
def form_mode(
    tables: Tables, kind: int, mode: int, n: int, scale: tuple[float, ...], exactness: float, longest: float
) -> None:
    """Form the tables of one mode of n columns; x1, v1, x2 and v2 count in N by `scale`."""
    A, lines, of_stick = tables.A[kind, mode, :n, :n], tables.lines[kind, mode], tables.lines[kind, STICK]
    places = places_of(A)
    h = step_of(A, places, longest)
    tables.steps[kind, mode] = h
    own, row, cut, total = lines[OWN:SUMS], np.zeros(n), np.zeros(n), np.zeros((n, 2))
    of_state = np.zeros((2 * ORDERS, n))
    for index in range(STATE + 2):
        for j in range(n):
            row[j] = lines[GUARDS + index - STATE, j] if index >= STATE else 1.0 if j == index else 0.0
        table, counts = tables.rows[kind, mode, index], of_state
        if index >= STATE:
            counts = lines[SUMS + 2 * ORDERS * (index - STATE) : POWERS]
        expand(A, places, h, row, table, total, cut)
        count_roundings(table, n, exactness, cut, counts, tables.degrees[kind, mode, index])
        if index >= STATE:
            continue
        for j in range(n):
            lines[FLOW + index, j] = total[j, 0]
            whole = (n + 4) * abs(total[j, 0]) + cut[j] / UNIT
            last = 2.0 * abs(table[j, table.shape[1] - 1]) / UNIT if index % 2 else 0.0  # velocities are slopes
            for k, size in enumerate((whole, counts[0, j], counts[1, j] + last)):
                own[3 * k, j] += scale[index] * size
                if index % 2 == 0:
                    own[3 * k + 1 + index // 2, j] += size
    for j in range(n):  # what an entry of A is off by is a force
        bent = 3.0 * exactness * h * (scale[1] * abs(A[V1, j]) + scale[3] * abs(A[V2, j]))
        for k in (0, 6):
            own[k, j] += bent
            own[k + 1, j] += h * bent / scale[1]
            own[k + 2, j] += h * 3.0 * exactness * h * abs(A[V2, j])
        for g in range(2):
            rate = 0.0
            for i in range(n):
                rate += of_stick[GUARDS + g, i] * A[i, j]
            lines[RATES + g, j] = rate
        lines[RATES + OF_V1, j], lines[RATES + OF_V2, j] = A[V1, j], A[V2, j]


@compilable
def shrinking(flow: Any, scale: tuple[float, ...]) -> float:
    """Return the norm of the flow of (x1, v1) in stick, in which N^2 is a2 x1^2 + M v1^2; at most 1."""
    root_a2, root_mass = scale[0], math.hypot(scale[1], scale[3])
    one, four = flow[X1, X1], flow[V1, V1]
    if scale[3] == 0.0 or root_a2 == 0.0:
        return 1.0
    two, three = flow[X1, V1] * root_a2 / root_mass, flow[V1, X1] * root_mass / root_a2
    square, determinant = one * one + two * two + three * three + four * four, one * four - two * three
    inner = max(square * square - 4.0 * determinant * determinant, 0.0)
    return min(1.0, math.sqrt((square + math.sqrt(inner)) / 2.0) * (1.0 + 1e-12) + 1e-15)


@compilable_with(makes_arrays=True, forceinline=False)
def places_of(A: Any) -> Any:
    """Return where a matrix is not 0, (k, 2); argwhere takes longer to compile."""
    found, count = np.zeros((A.size, 2), dtype=np.int64), 0
    for i in range(A.shape[0]):
        for j in range(A.shape[1]):
            if A[i, j] != 0.0:
                found[count, 0], found[count, 1] = i, j
                count += 1
    return found[:count]


@compilable
def step_of(A: Any, places: Any, longest: float) -> float:
    """Return the length of a step, of 20 bits: steps of it add up exactly."""
    stiff = max(abs(A[V1, X1]), abs(A[V1, X2])) + abs(A[V2, X2])
    rate = abs(A[V1, V1]) + abs(A[V2, V2]) + math.sqrt(stiff)
    for e in range(len(places)):
        i, j = places[e]
        if i >= FIRST and A[j, i] == -A[i, j]:  # of a sine
            rate = max(rate, abs(A[i, j]))
    fraction, exponent = math.frexp(min(longest, REACH / rate) if rate > 0.0 else longest)
    return math.ldexp(math.floor(math.ldexp(fraction, 20)), exponent - 20)


@compilable_with(makes_arrays=True, forceinline=False)
def expand(A: Any, places: Any, h: float, row: Any, table: Any, total: Any, cut: Any) -> None:
    """Write the Taylor coefficients of a row over a step h, its value at the end (n, 2), and what is cut off."""
    n, terms = A.shape[0], table.shape[1]
    r, after = np.zeros((n, 2)), np.zeros((n, 2))
    for j in range(n):
        r[j, 0] = row[j]
    total[:, :] = 0.0
    cut[:] = 0.0
    for k in range(terms + 2):
        for j in range(n):
            if k < terms:
                table[j, k] = r[j, 0]
            else:  # the first two that are left out; all later ones are less than these again
                cut[j] += 2.0 * abs(r[j, 0])
            if r[j, 0] != 0.0:
                put(total[j], plus(pair_of(total[j]), pair_of(r[j])))
        after[:, :] = 0.0
        for e in range(len(places)):
            i, j = places[e]
            if r[i, 0] != 0.0:
                put(after[j], plus(pair_of(after[j]), product(two_product(A[i, j], h), pair_of(r[i]))))
        r[:, :] = 0.0
        for j in range(n):
            if after[j, 0] != 0.0:  # most are 0, and divisions take half of the time
                put(r[j], quotient(pair_of(after[j]), TwoFloats(k + 1.0, 0.0)))


@compilable
def count_roundings(table: Any, n: int, exactness: float, cut: Any, counts: Any, degrees: Any) -> None:
    """Count the terms of each series, and its roundings without the first p terms, at the start and end of a step.

    The term of (t/h)^k is rounded 2 k + n + 6 times in all sums, and off by k entries of A and one of the row.
    """
    for j in range(n):
        degrees[j] = 0
        for p in range(ORDERS):
            counts[2 * p, j], counts[2 * p + 1, j] = 0.0, cut[j] / UNIT
        for k in range(table.shape[1]):
            term = abs(table[j, k])
            if term > 0.0:
                degrees[j] = k + 2 - k % 2
                weighted = (2 * k + n + 6 + exactness * (k + 1)) * term
                if k < ORDERS:
                    counts[2 * k, j] = weighted
                for p in range(min(k + 1, ORDERS)):
                    counts[2 * p + 1, j] += weighted
