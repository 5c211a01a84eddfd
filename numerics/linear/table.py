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
from numerics.arithmetic.pair import TwoFloats, negative, pair_of, plus, product, put, quotient, times
from numerics.linear.first_root import value_slope

X1, V1, X2, V2, FRICTION, FIRST = 0, 1, 2, 3, 4, 5
UNIT, PAIR_UNIT = 2.0**-53, 2.0**-101
"""A rounding of float64; one of a pair of floats, with what its operations lose."""
NODES, WEIGHTS = (np.polynomial.legendre.leggauss(20)[0] + 1.0) / 2.0, np.polynomial.legendre.leggauss(20)[1] / 2.0
"""Of Gauss's rule on [0, 1]: exact up to degree 39, and what a step has beyond that is below rounding, in `parts`."""
REACH, TERMS = 2.0, 28
"""rate h of a step, and how many Taylor terms make truncation smaller than rounding."""
ORDERS = 8
"""A guard starts with so many vanishing coefficients at most, less one."""


class Tables(NamedTuple):
    """Tables for every kind of force of a scene (first index) in slip and in stick (second index: 0, 1).

    A kind is the number of coefficients of the polynomial and the frequencies; n columns at most, k < terms.
    """

    made_of: Any
    """(kinds, 7 + n): what they were formed of: the pair, both steps, frequencies."""
    h: Any
    """(kinds, 2): the step, s."""
    count: Any
    """(kinds,): the number of columns."""
    rows: Any
    """(kinds, 2, 2, n, terms): the coefficients of x1 and x2 in (t/h)^k of each component."""
    degrees: Any
    """(kinds, 2, 2, n): how many terms of each there are, rounded up to an even number; later ones are 0."""
    ends: Any
    """(kinds, 2, 2, n, n): exp(A h), and what its rounding left out, which its powers take (calm_stick.py)."""
    sums: Any
    """(kinds, 2, ORDERS, n): what rounding and truncation do to h (v1 - v2), in stick to h^2 x2'', less p coefficients,

    in roundings."""
    own: Any
    """(kinds, 2, ORDERS, 2, n): what rounding alone does to them over s^p at s = 0 and 1 (columns.counted)."""
    state_own: Any
    """(kinds, 2, 4, 2, n): the same of x1, h v1, x2, h v2."""
    squares: Any
    """(kinds, 2, n, n): int v1^2 dt over the step, as a quadratic form of z; 0 without damping."""


@compilable
def most_terms(coefficients: int) -> int:
    """Return how many Taylor terms a table has: an even number, 14 beyond the degree of the polynomial of u or more."""
    return max(TERMS, coefficients + 14 + coefficients % 2)


@compilable_with(makes_arrays=True, forceinline=False)
def make_tables(kinds: int, n: int, terms: int) -> Tables:
    """Return empty tables; n columns at most."""
    return Tables(
        np.zeros((kinds, 7 + n)),
        np.zeros((kinds, 2)),
        np.zeros(kinds, dtype=np.int64),
        np.zeros((kinds, 2, 2, n, terms)),
        np.zeros((kinds, 2, 2, n), dtype=np.int64),
        np.zeros((kinds, 2, 2, n, n)),
        np.zeros((kinds, 2, ORDERS, n)),
        np.zeros((kinds, 2, ORDERS, 2, n)),
        np.zeros((kinds, 2, 4, 2, n)),
        np.zeros((kinds, 2, n, n)),
    )


@compilable_with(makes_arrays=True, forceinline=False)
def form(tables: Tables, kind: int, pair: Any, terms: int, omegas: Any, longest: float) -> None:
    """Form the tables of one kind of force: so many coefficients of a polynomial, and frequencies (k, 2) as pairs;

    if they were not formed of these numbers before.

    `pair` (5, 2): m1, m1 + m2, m2, a1, a2 as pairs. A step is REACH over the fastest rate, or `longest`.
    """
    n, made_of, is_new = FIRST + terms + 2 * omegas.shape[0], tables.made_of[kind], False
    for k in range(5):
        is_new = differs(made_of, k, pair[k, 0]) or is_new
    for side in range(2):
        rate = pair[3, 0] / pair[side, 0] + math.sqrt(pair[4, 0] / pair[side, 0])
        for k in range(omegas.shape[0]):
            rate = max(rate, omegas[k, 0])
            is_new = differs(made_of, 7 + k, omegas[k, 0]) or is_new
        fraction, exponent = math.frexp(min(longest, REACH / rate))  # of 20 bits: steps of it add up exactly
        h = math.ldexp(math.floor(math.ldexp(fraction, 20)), exponent - 20)
        is_new = differs(made_of, 5 + side, h) or is_new
    if not is_new:
        return
    tables.count[kind] = n
    for side in range(2):
        at, h = (kind, side), made_of[5 + side]
        tables.h[at] = h
        cut = expand_units(generator(pair, terms, omegas, side == 1), h, tables.rows[at], tables.ends[at])
        count_roundings(tables, kind, side, cut)
        if pair[3, 0] > 0.0:
            square(tables.rows[at][0], h, n, tables.squares[at])


@compilable
def differs(numbers: Any, k: int, number: float) -> bool:
    """Write a number, and return whether another one stood there."""
    before, numbers[k] = numbers[k], number
    return before != number


@compilable_with(makes_arrays=True, forceinline=False)
def generator(pair: Any, terms: int, omegas: Any, is_stick: bool) -> Any:
    """Return A (n, n, 2), of pairs."""
    waves, n = FIRST + terms, FIRST + terms + 2 * omegas.shape[0]
    A, one, mass = np.zeros((n, n, 2)), TwoFloats(1.0, 0.0), pair_of(pair[1 if is_stick else 0])
    A[X1, V1, 0] = A[X2, V2, 0] = 1.0
    for to in (V1, V2) if is_stick else (V1, V1):
        put(A[to, X1], negative(quotient(pair_of(pair[4]), mass)))
        put(A[to, V1], negative(quotient(pair_of(pair[3]), mass)))
        if terms > 0:
            put(A[to, FIRST], quotient(one, mass))
        for of in range(waves, n, 2):
            put(A[to, of], quotient(one, mass))
    if not is_stick:
        put(A[V1, FRICTION], negative(quotient(one, mass)))
        put(A[V2, FRICTION], quotient(one, pair_of(pair[2])))
    for k in range(terms - 1):
        A[FIRST + k, FIRST + k + 1, 0] = k + 1.0
    for k in range(omegas.shape[0]):
        at = waves + 2 * k
        put(A[at, at + 1], pair_of(omegas[k]))
        put(A[at + 1, at], negative(pair_of(omegas[k])))
    return A


@compilable_with(makes_arrays=True, forceinline=False)
def expand_units(A: Any, h: float, rows: Any, end: Any) -> Any:
    """Write Taylor coefficients and value of every unit vector over a step h; return what the first leave out (n,)."""
    count, terms, places = A.shape[0], rows.shape[2], np.argwhere(A[:, :, 0])
    z, after, total, cut = np.zeros((count, 2)), np.zeros((count, 2)), np.zeros((count, 2)), np.zeros(count)
    for e in range(len(places)):
        to, of = places[e, 0], places[e, 1]
        put(A[to, of], times(pair_of(A[to, of]), h))
    for j in range(count):
        z[:, :] = 0.0
        z[j, 0] = 1.0
        total[:, :] = z
        for k in range(terms + 2):
            for i in range(2):
                if k < terms:
                    rows[i, j, k] = z[2 * i, 0]
                else:  # the first two that are left out; all later ones are less than these again
                    cut[j] += 2.0 * abs(z[2 * i, 0])
            after[:, :] = 0.0
            for e in range(len(places)):
                to, of = places[e, 0], places[e, 1]
                if z[of, 0] != 0.0:
                    put(after[to], plus(pair_of(after[to]), product(pair_of(A[to, of]), pair_of(z[of]))))
            z[:, :] = 0.0
            for i in range(count):
                if after[i, 0] != 0.0:  # most are 0, and divisions take half of the time
                    put(z[i], quotient(pair_of(after[i]), TwoFloats(k + 1.0, 0.0)))
                    put(total[i], plus(pair_of(total[i]), pair_of(z[i])))
        for i in range(count):
            end[0, i, j], end[1, i, j] = total[i, 0], total[i, 1]
    return cut


@compilable_with(makes_arrays=True, forceinline=False)
def count_roundings(tables: Tables, kind: int, side: int, cut: Any) -> None:
    """Count the terms of each series, and its roundings, 2 k + n + 4 of c_k s^k, at s = 0 (of its first term) and at

    s = 1 (of all). A guard's sums have what is cut, too.
    """
    at, terms = (kind, side), tables.rows.shape[4]
    rows, n, degrees, sums = tables.rows[at], tables.count[kind], tables.degrees[at], tables.sums[at]
    own, guard = tables.state_own[at], tables.own[at]
    degrees[:, :] = 0
    own[:, :, :] = 0.0
    guard[:, :, :] = 0.0
    for j in range(n):
        sums[:, j] = cut[j] * terms * 2.0**53 * (terms if side == 1 else 1)
    for k in range(terms):
        weight = 2 * k + n + 4
        order, power = (k - 1, k) if side == 0 else (k - 2, k * (k - 1))
        for j in range(n):
            for i in range(2):
                value = weight * abs(rows[i, j, k])
                if value > 0.0:
                    degrees[i, j] = k + 2 - k % 2
                for end in range(2):
                    own[2 * i, end, j] += value if end == 1 or k == 0 else 0.0
                    own[2 * i + 1, end, j] += k * value if end == 1 or k == 1 else 0.0
            one, two = abs(rows[0, j, k]) if side == 0 else 0.0, abs(rows[1, j, k])
            of_guard = power * (weight * one + weight * two)
            for p in range(min(order + 1, ORDERS)):
                sums[p, j] += (2 * order + n + 8) * power * (one + two)
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
