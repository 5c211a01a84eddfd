"""Tables of Taylor coefficients: what a step of a mode does to every component of z, for z' = A z.

    z(t) = sum_k (h A)^k z(0)/k! (t/h)^k

so the coefficients of x1 and x2 over a step h are linear in z(0), with a table that depends on the pair, the
frequencies and the degree of u, and on nothing else: not on the start, amplitudes, phases or b. It is formed in pairs
by the recurrence z_(k+1) = h A z_k/(k+1), of unit vectors, and serves every step. No regimes of damping, no resonance.

z = (x1, v1, x2, v2, f, c_0 ... c_d, s_1, c_1, ...): the state, the signed friction force on body 2, the Taylor
coefficients of the polynomial of u, and amplitude times sine and cosine of each phase.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.linear.first_root import value_slope
from numerics.linear.pairs import add, divide, multiply

X1, V1, X2, V2, FRICTION, FIRST = 0, 1, 2, 3, 4, 5
UNIT, WIDE_UNIT = 2.0**-53, 2.0**-101
"""A rounding of float64; one of double-double, with what its operations lose."""
PRECISE = 22
"""So many terms of a series are formed in pairs: later ones, 1.5^22/22! and less, weigh so little that floats do."""
NODES, WEIGHTS = (np.polynomial.legendre.leggauss(20)[0] + 1.0) / 2.0, np.polynomial.legendre.leggauss(20)[1] / 2.0
"""Of Gauss's rule on [0, 1]: exact up to degree 39, and what a step has beyond that is below rounding, in `parts`."""
ORDERS = 8
"""A guard starts with so many vanishing coefficients at most, less one."""


class Tables(NamedTuple):
    """Tables for every kind of force of a scene (first index) in slip and in stick (second index: 0, 1).

    A kind is the number of coefficients of the polynomial and the frequencies; n columns at most, k < terms.
    """

    h: Any
    """(kinds, 2): the step, s."""
    count: Any
    """(kinds,): the number of columns."""
    rows: Any
    """(kinds, 2, 2, 2, n, terms): high and low parts of the coefficients of x1 and x2 in (t/h)^k of each component."""
    degrees: Any
    """(kinds, 2, 2, n): how many terms of each there are, rounded up to an even number; later ones are 0."""
    ends: Any
    """(kinds, 2, 2, n, n): high and low parts of exp(A h)."""
    sums: Any
    """(kinds, 2, ORDERS, n): what rounding and truncation do to h (v1 - v2), in stick to h^2 x2'', less p coefficients,

    in roundings."""
    own: Any
    """(kinds, 2, ORDERS, 2, n): what rounding alone does to them over s^p at s = 0 and 1 (columns.counted)."""
    state_own: Any
    """(kinds, 2, 4, 2, n): the same of x1, h v1, x2, h v2."""
    squares: Any
    """(kinds, 2, n, n): int v1^2 dt over the step, as a quadratic form of z; 0 without damping."""


@compilable_with(makes_arrays=True, forceinline=False)
def make_tables(kinds: int, n: int, terms: int) -> Tables:
    """Return empty tables; n columns at most."""
    return Tables(
        np.zeros((kinds, 2)),
        np.zeros(kinds, dtype=np.int64),
        np.zeros((kinds, 2, 2, 2, n, terms)),
        np.zeros((kinds, 2, 2, n), dtype=np.int64),
        np.zeros((kinds, 2, 2, n, n)),
        np.zeros((kinds, 2, ORDERS, n)),
        np.zeros((kinds, 2, ORDERS, 2, n)),
        np.zeros((kinds, 2, 4, 2, n)),
        np.zeros((kinds, 2, n, n)),
    )


@compilable_with(makes_arrays=True, forceinline=False)
def form(
    tables: Tables, kind: int, pair: Any, terms: int, omegas: Any, longest: float, reach: float, wide: bool
) -> None:
    """Form the tables of one kind of force: so many coefficients of a polynomial, and frequencies (k, 2) as pairs.

    `pair` (5, 2): m1, m1 + m2, m2, a1, a2 as pairs. A step is `reach` over the fastest rate, or `longest`.
    """
    waves = omegas.shape[0]
    n = FIRST + terms + 2 * waves
    tables.count[kind] = n
    places, entries = np.zeros((12 + terms + 4 * waves, 2), dtype=np.int64), np.zeros((12 + terms + 4 * waves, 2))
    for side in range(2):
        count = generator(pair, terms, omegas, side == 1, places, entries)
        rate = pair[3, 0] / pair[side, 0] + math.sqrt(pair[4, 0] / pair[side, 0])
        for k in range(waves):
            rate = max(rate, omegas[k, 0])
        fraction, exponent = math.frexp(min(longest, reach / rate))
        h = math.ldexp(math.floor(math.ldexp(fraction, 20)), exponent - 20)  # of 20 bits: steps of it add up exactly
        tables.h[kind, side] = h
        at = kind, side
        rows, degrees, end, sums = tables.rows[at], tables.degrees[at], tables.ends[at], tables.sums[at]
        fill(entries[:count], places[:count], h, n, side == 1, rows, degrees, end, sums)
        count_roundings(tables, kind, side, wide)
        if pair[3, 0] > 0.0:
            square(rows[0, 0], h, n, tables.squares[at])


@compilable_with(makes_arrays=True, forceinline=False)
def count_roundings(tables: Tables, kind: int, side: int, wide: bool) -> None:
    """Count the roundings of each series, c_k s^k with 2 k + n + 4, at s = 0 (of its first term) and at s = 1 (of all).

    Where `wide`, later terms are formed in floats.
    """
    rows, n = tables.rows[kind, side, 0], tables.count[kind]
    own, guard = tables.state_own[kind, side], tables.own[kind, side]
    own[:, :, :] = 0.0
    guard[:, :, :] = 0.0
    for k in range(rows.shape[2]):
        weight = (2 * k + n + 4) * (UNIT / WIDE_UNIT if wide and k >= PRECISE else 1.0)
        for j in range(n):
            one, two = weight * abs(rows[0, j, k]), weight * abs(rows[1, j, k])
            for i in range(2):
                value = two if i == 1 else one
                for end in range(2):
                    own[2 * i, end, j] += value if end == 1 or k == 0 else 0.0
                    own[2 * i + 1, end, j] += k * value if end == 1 or k == 1 else 0.0
            of_guard, order = (k * (one + two), k - 1) if side == 0 else (k * (k - 1) * two, k - 2)
            for p in range(min(order + 1, ORDERS)):
                guard[p, 1, j] += of_guard
                guard[p, 0, j] += of_guard if p == order else 0.0


@compilable
def parts(terms: int) -> int:
    """Return into how many equal parts a step of series of so many terms is cut for Gauss's rule.

    A power t^p in u makes v1^2 one of 2 p + 2, of which one part alone takes no more than p = 20 to rounding.
    """
    return 1 + (terms - 1) // 36


@compilable_with(makes_arrays=True, forceinline=False)
def square(rows: Any, h: float, count: int, form: Any) -> None:
    """Form int v1^2 dt over a step as a quadratic form of z."""
    form[:, :] = 0.0
    slopes, cut = np.zeros((NODES.shape[0], count)), parts(rows.shape[1])
    for part in range(cut):
        for n in range(NODES.shape[0]):
            for j in range(count):
                slopes[n, j] = value_slope(rows[j], (part + NODES[n]) / cut)[1]
        for i in range(count):
            for j in range(count):
                for n in range(NODES.shape[0]):
                    form[i, j] += WEIGHTS[n] / (cut * h) * slopes[n, i] * slopes[n, j]


@compilable_with(forceinline=False)
def generator(pair: Any, terms: int, omegas: Any, is_stick: bool, places: Any, entries: Any) -> int:
    """Write the nonzero elements of A: where they stand, and as pairs; return how many there are."""
    mh, ml = pair[1 if is_stick else 0, 0], pair[1 if is_stick else 0, 1]
    one, waves = divide(1.0, 0.0, mh, ml), FIRST + terms
    drag, spring = divide(-pair[3, 0], -pair[3, 1], mh, ml), divide(-pair[4, 0], -pair[4, 1], mh, ml)
    count = put(places, entries, 0, X1, V1, (1.0, 0.0))
    count = put(places, entries, count, X2, V2, (1.0, 0.0))
    for to in range(V1, V2 + 1, V2 - V1):
        if to == V1 or is_stick:
            count = put(places, entries, count, to, X1, spring)
            count = put(places, entries, count, to, V1, drag)
            if terms > 0:
                count = put(places, entries, count, to, FIRST, one)
            for k in range(omegas.shape[0]):
                count = put(places, entries, count, to, waves + 2 * k, one)
    if not is_stick:
        count = put(places, entries, count, V1, FRICTION, (-one[0], -one[1]))
        count = put(places, entries, count, V2, FRICTION, divide(1.0, 0.0, pair[2, 0], pair[2, 1]))
    for k in range(terms - 1):
        count = put(places, entries, count, FIRST + k, FIRST + k + 1, (k + 1.0, 0.0))
    for k in range(omegas.shape[0]):
        at, omega = waves + 2 * k, omegas[k]
        count = put(places, entries, count, at, at + 1, (omega[0], omega[1]))
        count = put(places, entries, count, at + 1, at, (-omega[0], -omega[1]))
    return count


@compilable
def put(places: Any, entries: Any, count: int, to: int, of: int, entry: tuple[float, float]) -> int:
    """Write one element, and return how many there are now."""
    places[count, 0], places[count, 1], (entries[count, 0], entries[count, 1]) = to, of, entry
    return count + 1


@compilable_with(makes_arrays=True, forceinline=False)
def fill(
    entries: Any,
    places: Any,
    h: float,
    count: int,
    is_stick: bool,
    rows: Any,
    degrees: Any,
    end: Any,
    sums: Any,
) -> None:
    """Fill a table; entries (k, 2) are the nonzero elements of A as pairs, places (k, 2) where they stand."""
    terms, side = rows.shape[3], 1 if is_stick else 0
    z, after, total = np.zeros((count, 2)), np.zeros((count, 2)), np.zeros((count, 2))
    scaled = np.empty(entries.shape)
    for e in range(entries.shape[0]):
        scaled[e, 0], scaled[e, 1] = multiply(entries[e, 0], entries[e, 1], h, 0.0)
    for j in range(count):
        z[:, :] = 0.0
        z[j, 0] = 1.0
        total[:, :] = z
        cut1, cut2 = 0.0, 0.0
        for k in range(terms + 2):
            if k < terms:
                for i in range(2):
                    rows[0, i, j, k], rows[1, i, j, k] = z[2 * i, 0], z[2 * i, 1]
            else:  # the first two that are left out; all later ones are less than these again
                cut1 += 2.0 * abs(z[0, 0])
                cut2 += 2.0 * abs(z[2, 0])
            after[:, :] = 0.0
            for e in range(entries.shape[0]):
                to, of = places[e, 0], places[e, 1]
                if z[of, 0] != 0.0:
                    p, q = multiply(scaled[e, 0], scaled[e, 1], z[of, 0], z[of, 1])
                    after[to, 0], after[to, 1] = add(after[to, 0], after[to, 1], p, q)
            z[:, :] = 0.0
            for i in range(count):
                if after[i, 0] != 0.0:  # most are 0, and divisions take half of the time
                    z[i, 0], z[i, 1] = divide(after[i, 0], after[i, 1], float(k + 1), 0.0)
                    total[i, 0], total[i, 1] = add(total[i, 0], total[i, 1], z[i, 0], z[i, 1])
        for i in range(count):
            end[0, i, j], end[1, i, j] = total[i, 0], total[i, 1]
        for i in range(2):
            degree = terms
            while degree > 0 and rows[0, i, j, degree - 1] == 0.0:
                degree -= 1
            degrees[i, j] = degree + degree % 2
        cut = (cut1 + cut2) * terms * 2.0**53
        for p in range(ORDERS):
            sums[p, j] = cut * terms if is_stick else cut
            for k in range(p, terms - 1 - side):
                one, two = abs(rows[0, 0, j, k + 1 + side]), abs(rows[0, 1, j, k + 1 + side])
                size, power = (two, (k + 2) * (k + 1)) if is_stick else (one + two, k + 1)
                sums[p, j] += (2 * k + count + 8) * power * size
