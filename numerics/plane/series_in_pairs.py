"""The series of a slip (series.py) in compiled double-double: nothing is proved here, a defect sees every digit.

Rows are n of s, v2, q1, v1 and the push u - A2 q1 - A1 v1 each, those of h(s) and t, a sine and a cosine for each
phase, and t^2, t^3, ... A coefficient k is that of (sigma/unit)^k, `unit` a power of 2 about as long as a step.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import sqrt
from numerics.arithmetic.pair import Pair

Table = NDArray[np.float64]
"""High halves, then low ones."""


@compilable
def number(table: Table, row: int, k: int) -> Pair:
    """Return an entry."""
    return Pair(table[0, row, k], table[1, row, k])


@compilable
def put(table: Table, row: int, k: int, x: Pair) -> None:
    """Write an entry."""
    table[0, row, k], table[1, row, k] = x.high, x.low


@compilable
def product(table: Table, one: int, two: int, k: int) -> Pair:
    """Return the coefficient k of the product of two rows."""
    total = Pair(0.0, 0.0)
    for j in range(k + 1):
        total = total + number(table, one, j) * number(table, two, k - j)
    return total


@compilable
def expand(table: Table, masses: Table, held: Table, polynomial: Table, waves: Table, degree: int, unit: float) -> None:
    """Fill a table (2, rows, top + 1) whose column 0 has s, v2, q1, t, sines and cosines; the rest is 0.

    Beyond the degree s ends, and all else goes on with that. `masses`: rows m1, m2, m1 + m2, b^2; `held`: A2, A1 side
    by side; `polynomial`: rows of u by powers of t; `waves`: by phases, the amplitudes, then omega.
    """
    n, top, powers = held.shape[1], table.shape[2] - 1, polynomial.shape[1]
    second, place, first, push, rate = n, 2 * n, 3 * n, 4 * n, 5 * n
    clock, wave = rate + 1, rate + 2
    still = wave + 2 * waves.shape[1] - 2  # t^p is row still + p
    for k in range(top):
        step = Pair(unit, 0.0) / float(k + 1)
        square = Pair(0.0, 0.0)
        for i in range(n):
            square = square + number(masses, 3, i) * product(table, i, i, k)
            put(table, first + i, k, number(table, second + i, k) + number(table, i, k))
        if k == 0:
            put(table, rate, 0, sqrt(square))
        else:
            put(table, rate, k, (square - product(table, rate, rate, k)) / (number(table, rate, 0) * 2.0))
        put(table, clock, k + 1, number(table, rate, k) * step)
        for p in range(2, powers):
            put(table, still + p, k, product(table, clock if p == 2 else still + p - 1, clock, k))
        for i in range(n):
            u = number(polynomial, 0, i) if k == 0 and powers > 0 else Pair(0.0, 0.0)
            for p in range(1, powers):
                u = u + number(polynomial, p, i) * number(table, clock if p == 1 else still + p, k)
            for j in range(waves.shape[1]):
                u = u + number(waves, j, i) * number(table, wave + 2 * j, k)
            for j in range(n):
                u = u - number(held, i, j) * number(table, place + j, k)
                u = u - number(held, i, n + j) * number(table, first + j, k)
            put(table, push + i, k, u)
            given, taken = number(masses, 3, i) * number(table, i, k), product(table, push + i, rate, k)
            if k < degree:
                off = (taken - given) / number(masses, 0, i) - given / number(masses, 1, i)
                put(table, i, k + 1, off * step)
                put(table, second + i, k + 1, given / number(masses, 1, i) * step)
            else:
                put(table, second + i, k + 1, taken / number(masses, 2, i) * step)
            put(table, place + i, k + 1, product(table, first + i, rate, k) * step)
        for j in range(waves.shape[1]):
            turn, sine = number(waves, j, n) * step, wave + 2 * j
            put(table, sine, k + 1, turn * product(table, sine + 1, rate, k))
            put(table, sine + 1, k + 1, -(turn * product(table, sine, rate, k)))


@compilable
def stretch(table: Table, high: float, low: float) -> None:
    """Multiply the coefficients k by the power k of a number."""
    power = by = Pair(high, low)
    for k in range(1, table.shape[2]):
        for row in range(table.shape[1]):
            put(table, row, k, number(table, row, k) * power)
        power = power * by
