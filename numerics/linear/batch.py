"""Many scenes in one compiled call, in float64: first events and ends out.

In come rows of numbers, of one piece of force and the same pieces of friction.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, negative, pair_of, plus, put, times, two_sum
from numerics.linear.columns import Constants, Drive, Problem, Room, constants, make_room
from numerics.linear.kernel import OUT_OF_RANGE, Log, follow_in
from numerics.linear.record import AT, END_ROW, UNKNOWN, finish
from numerics.linear.table import FIRST, Tables, form, make_tables, most_terms

_MODE, _JUMP, _PIECE, _LOCAL, _X1, _HOW = (AT[name] for name in ("mode", "jump", "piece", "local", "x1", "how"))


class Columns(NamedTuple):
    """Rows of scenes as compiled code reads them, all numbers binary64.

    `numbers` (n, 10): those of a scene in SI units (solver/batch.py). u = sum_k polynomial[:, k] t^k
    + sum amplitude sin(omega t + phase), with `polynomial` (n, p) and `sines` (n, s, 3). `frictions` (k, 3), the same
    for all rows: when a piece begins (s), the first one at 0, what its rounding left out, and its b (N); nan for the
    row's own b. With more than one piece the polynomial is a constant at most.
    """

    numbers: NDArray[np.float64]
    polynomial: NDArray[np.float64]
    sines: NDArray[np.float64]
    frictions: NDArray[np.float64]

    def part(self, rows: Any) -> Columns:
        """Return some of the rows."""
        return Columns(self.numbers[rows], self.polynomial[rows], self.sines[rows], self.frictions)


@compilable
def follow_row(
    pair: Constants,
    drive: Drive,
    tables: Tables,
    room: Room,
    start: Any,
    max_events: int,
    has_ledger: bool,
    kept: Any,
    end: Any,
) -> tuple[int, int]:
    """Follow one row; return (how, rows written or left out).

    Tuples of arrays are made here, where no references are counted, which would cost some percent of a row.
    """
    problem, log = Problem(pair, drive, tables, has_ledger), Log(kept, end, max_events, False)
    return follow_in(problem, room, start, -1.0, log)


@compilable_with(makes_arrays=True, forceinline=False)
def follow_rows(given: Columns, literal: bool, max_events: int, has_ledger: bool, kept: Any, ends: Any) -> None:
    """Solve rows of scenes; write start and first events of each to `kept` (n, k, ROW), its end to `ends` (n, END_ROW).

    Each is solved in units that are powers of 2; tables are formed anew only where they change. Rows that are in doubt,
    or out of range, are UNKNOWN at the end. Without `has_ledger` an end says nan of what friction and viscosity took:
    that costs a fifth of the time, and not everybody asks.
    """
    numbers, polynomial, sines, frictions = given
    terms, waves, pieces = polynomial.shape[1], sines.shape[1], frictions.shape[0]
    columns, coefficients = FIRST + terms + 2 * waves, most_terms(terms)
    tables, room = make_tables(1, columns, coefficients), make_room(columns, coefficients)
    pair, whole, start = np.zeros((5, 2)), make_drive(terms, waves, pieces), np.zeros(END_ROW)
    for row in range(numbers.shape[0]):
        mass, time, length = put_bodies(numbers[row], pair, start)
        force, own_b, until = mass + length - 2 * time, numbers[row, 3], numbers[row, 8]
        for k in range(terms):
            whole.coefficients[k] = math.ldexp(polynomial[row, k], k * time - force)
        count, longest = put_pieces(frictions, own_b, until, sines[row], (time, force), whole)
        how, rows, end = OUT_OF_RANGE, kept[row], ends[row]
        if count > 0:
            form(tables, 0, pair, terms, whole.sines[:waves, 1], longest)
            drive = Drive(whole.places[:count], whole.b[:count], whole.length[:count], whole.coefficients, whole.sines)
            own = constants(pair, literal)
            how, count = follow_row(own, drive, tables, room, start, max_events, has_ledger, rows, end)
        if how >= OUT_OF_RANGE or not finish(rows[:count], end, mass, time, length):
            end[_HOW] = UNKNOWN
            continue
        for n in range(min(count, rows.shape[0])):
            from_start(rows[n], frictions)
        from_start(end, frictions)


@compilable_with(makes_arrays=True, forceinline=False)
def make_drive(terms: int, waves: int, pieces: int) -> Drive:
    """Return room for a drive whose pieces have one polynomial, sines of their own, and jumps between them."""
    places = np.zeros((pieces, 6), dtype=np.int64)
    places[:, 1], places[:, 2], places[:, 3], places[:, 5] = terms, waves * np.arange(pieces), waves, 1
    b, length = np.zeros(pieces), np.zeros((pieces, 2))
    return Drive(places, b, length, np.zeros(terms), np.zeros((pieces * waves, 3, 2)))


@compilable
def put_bodies(numbers: Any, pair: Any, start: Any) -> tuple[int, int, int]:
    """Write a row's pair and start in its units; return the exponents of mass, time and length."""
    m1, m2, a2, b, a1 = numbers[0], numbers[1], numbers[2], numbers[3], numbers[9]
    mass = math.frexp(m1 + m2)[1]
    time, length = (mass - math.frexp(a2)[1]) // 2, math.frexp(b * (m1 + m2) / (a2 * m2))[1]
    pair[0, 0], pair[2, 0] = math.ldexp(m1, -mass), math.ldexp(m2, -mass)
    put(pair[1], two_sum(pair[0, 0], pair[2, 0]))
    pair[3, 0], pair[4, 0] = math.ldexp(a1, time - mass), math.ldexp(a2, 2 * time - mass)
    for i in range(4):
        start[_X1 + i] = math.ldexp(numbers[4 + i], -length + (time if i % 2 else 0))
    start[_MODE] = np.sign(numbers[5] - numbers[7])
    start[_JUMP] = 1.0 if start[_MODE] == 0.0 else 0.0
    return mass, time, length


@compilable
def put_pieces(
    frictions: Any, own_b: float, until: float, sines: Any, units: tuple[int, int], drive: Drive
) -> tuple[int, float]:
    """Write b, length, and sines with their phases at the beginning of each piece; return how many pieces there are and

    how long the longest one is; no piece where a phase is not good to its own size, as its terms cancel.
    """
    time_unit, force_unit = units
    count, longest, waves, (_, b, length, _, moved) = 0, 0.0, sines.shape[0], drive
    while count < frictions.shape[0] and is_before(frictions[count], until):
        begin, given_b, after = pair_of(frictions[count]), frictions[count, 2], TwoFloats(until, 0.0)
        if count + 1 < frictions.shape[0] and is_before(frictions[count + 1], until):
            after = pair_of(frictions[count + 1])
        lasts = plus(after, negative(begin))
        length[count, 0], length[count, 1] = math.ldexp(lasts.high, -time_unit), math.ldexp(lasts.low, -time_unit)
        longest = max(longest, length[count, 0])
        b[count] = math.ldexp(own_b if math.isnan(given_b) else given_b, -force_unit)
        for k in range(waves):
            sine = moved[count * waves + k]
            sine[0, 0], sine[1, 0] = math.ldexp(sines[k, 0], -force_unit), math.ldexp(sines[k, 1], time_unit)
            turned = times(begin, sines[k, 1])
            put(sine[2], plus(turned, TwoFloats(sines[k, 2], 0.0)))
            if 2.0 * abs(sine[2, 0]) < abs(turned.high):
                return 0, longest
        count += 1
    return count, longest


@compilable
def is_before(piece: Any, until: float) -> bool:
    """Return whether a piece begins before a time."""
    return piece[0] < until or (piece[0] == until and piece[1] < 0.0)


@compilable
def from_start(row: Any, begin: Any) -> None:
    """Let the time of a row count from the start of the run; begin[i, 0]: when a piece begins, s."""
    row[_LOCAL] += begin[int(row[_PIECE]), 0]
    row[_PIECE] = 0.0
