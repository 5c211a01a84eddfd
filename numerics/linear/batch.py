"""Many scenes in one compiled call, in float64: first events and ends out.

In come rows of numbers, of one piece of force and the same pieces of friction.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, negative, pair_of, plus, put, times
from numerics.linear.kernel import EVENT_LIMIT, OUT_OF_RANGE, Log, follow_in
from numerics.linear.ledger import ledger
from numerics.linear.model import FIRST, FORCE, FRICTION, Bodies, Rows, make_rows, norm_of, put_rows
from numerics.linear.record import AT, END_ROW, UNKNOWN, finish
from numerics.linear.room import Drive, Problem, Room, make_room
from numerics.linear.table import form, make_tables, most_terms

_MODE, _JUMP, _PIECE, _LOCAL, _X1, _HOW = (AT[name] for name in ("mode", "jump", "piece", "local", "x1", "how"))
_TAKEN = AT["friction"]
_ROUNDINGS = 4.0
"""By so many is an entry of the matrices off that compiled code forms."""


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


@compilable_with(makes_arrays=True, forceinline=False)
def follow_rows(given: Columns, literal: bool, max_events: int, has_ledger: bool, kept: Any, ends: Any) -> None:
    """Solve rows of scenes; write start and first events of each to `kept` (n, k, ROW), its end to `ends` (n, END_ROW).

    Each is solved in units that are powers of 2; tables are formed anew only where they change. Rows that are in doubt,
    or out of range, are UNKNOWN at the end. With `has_ledger`, `kept` has room for all rows of each, also those at
    which a piece begins, and the end says what was taken and given.
    """
    numbers, polynomial, sines, frictions = given
    terms, waves, pieces = polynomial.shape[1], sines.shape[1], frictions.shape[0]
    blocks, n = blocks_of(terms, waves), FIRST + terms + 2 * waves + 1
    tables, room = make_tables(1, n, most_terms(terms)), make_room(n, most_terms(terms))
    rows = make_rows(n)
    whole, start, omegas, made_of = make_drive(terms, waves, pieces), np.zeros(END_ROW), np.zeros(n), np.zeros(n + 5)
    for row in range(numbers.shape[0]):
        bodies, units = put_bodies(numbers[row], start)
        count, longest = put_pieces(given, row, units, whole)
        how, found, end, norm = OUT_OF_RANGE, kept[row], ends[row], norm_of(bodies)
        for k in range(waves):
            omegas[FIRST + terms + 1 + 2 * k + 1] = whole.sines[k, 1, 0]
        if count > 0:
            if is_new(made_of, bodies, longest, omegas):
                clear(rows)
                put_rows(bodies, blocks, omegas, (0.0, 0.0), rows)
                form(tables, 0, norm, blocks, rows, _ROUNDINGS, longest)
            log = Log(found, end, max_events, has_ledger)
            how, count = follow_row(Problem(norm, whole, tables, literal), count, room, start, log)
        if how >= OUT_OF_RANGE or not finish(found[:count], end, units[0], units[1], units[2]):
            end[_HOW] = UNKNOWN
            continue
        for k in range(min(count, found.shape[0])):
            from_start(found[k], frictions)
        from_start(end, frictions)


@compilable
def follow_row(problem: Problem, pieces: int, room: Room, start: Any, log: Log) -> tuple[int, int]:
    """Follow one row of so many pieces; return (how, rows written or left out).

    Tuples of arrays are made here, where no references are counted, which would cost some percent of a row.
    """
    whole = problem.drive
    drive = Drive(whole.places[:pieces], whole.length[:pieces], whole.coefficients, whole.sines)
    own = Problem(problem.norm, drive, problem.tables, problem.literal)
    how, count = follow_in(own, room, start, -1.0, log)
    if log.keeps_all and how < OUT_OF_RANGE:
        ledger(own, room, log.rows, count - (1 if how == EVENT_LIMIT else 0), log.end, log.end[_TAKEN:])
    return how, count


@compilable_with(makes_arrays=True, forceinline=False)
def blocks_of(terms: int, waves: int) -> Any:
    """Return where the signals stand in z: u, and one friction number behind its polynomial."""
    blocks = np.zeros((5, 4), dtype=np.int64)
    blocks[:, 0] = FIRST + terms
    blocks[:, 2] = FIRST + terms + 1
    blocks[FORCE, 0], blocks[FORCE, 1], blocks[FORCE, 3] = FIRST, terms, waves
    blocks[FRICTION, 1], blocks[FRICTION, 2] = 1, FIRST + terms + 1 + 2 * waves
    return blocks


@compilable_with(makes_arrays=True, forceinline=False)
def make_drive(terms: int, waves: int, pieces: int) -> Drive:
    """Return room for a drive whose pieces have one polynomial, a friction number and sines of their own."""
    places, length = np.zeros((pieces, 5), dtype=np.int64), np.zeros((pieces, 2))
    places[:, 1], places[:, 2], places[:, 3] = (terms + 1) * np.arange(pieces), waves * np.arange(pieces), 1
    return Drive(places, length, np.zeros(pieces * (terms + 1)), np.zeros((pieces * waves, 3, 2)))


@compilable
def put_bodies(numbers: Any, start: Any) -> tuple[Bodies, tuple[int, int, int]]:
    """Write a row's start in its units; return its bodies, and the exponents of mass, time and length."""
    m1, m2, a2, b, a1 = numbers[0], numbers[1], numbers[2], numbers[3], numbers[9]
    mass = math.frexp(m1 + m2)[1]
    time, length = (mass - math.frexp(a2)[1]) // 2, math.frexp(b * (m1 + m2) / (a2 * m2))[1]
    m1, m2 = math.ldexp(m1, -mass), math.ldexp(m2, -mass)
    for i in range(4):
        start[_X1 + i] = math.ldexp(numbers[4 + i], -length + (time if i % 2 else 0))
    start[_MODE] = np.sign(numbers[5] - numbers[7])
    start[_JUMP] = 1.0 if start[_MODE] == 0.0 else 0.0
    a1, a2, whole = math.ldexp(a1, time - mass), math.ldexp(a2, 2 * time - mass), m1 + m2
    bodies = Bodies(m1, a1, a2, 1.0 / m1, 1.0 / m2, 1.0 / whole, m1 / whole, m2 / whole, 1.0)
    return bodies, (mass, time, length)


@compilable
def clear(rows: Rows) -> None:
    """Write zeros."""
    rows.A[:] = 0.0
    rows.guards[:] = 0.0
    rows.others[:] = 0.0
    rows.powers[:] = 0.0


@compilable
def is_new(made_of: Any, bodies: Bodies, longest: float, omegas: Any) -> bool:
    """Return whether tables depend on other numbers than before, and write these."""
    found = False
    for k, number in enumerate((bodies.m1, bodies.a1, bodies.a2, bodies.share_2, longest)):
        found = differs(made_of, k, number) or found
    for k in range(omegas.shape[0]):
        found = differs(made_of, 5 + k, omegas[k]) or found
    return found


@compilable
def differs(numbers: Any, k: int, number: float) -> bool:
    """Write a number, and return whether another one stood there."""
    before, numbers[k] = numbers[k], number
    return before != number


@compilable
def put_pieces(given: Columns, row: int, units: tuple[int, int, int], drive: Drive) -> tuple[int, float]:
    """Write length, signals, and sines with their phases at the beginning of each piece of a row.

    Return how many pieces there are and how long the longest one is; no piece where a phase is not good to its own
    size, as its terms cancel.
    """
    numbers, polynomial, sines, frictions = given
    (mass, time, place), own_b, until = units, numbers[row, 3], numbers[row, 8]
    force, terms, waves = mass + place - 2 * time, polynomial.shape[1], sines.shape[1]
    count, longest = 0, 0.0
    while count < frictions.shape[0] and is_before(frictions[count], until):
        begin, b, after = pair_of(frictions[count]), frictions[count, 2], TwoFloats(until, 0.0)
        if count + 1 < frictions.shape[0] and is_before(frictions[count + 1], until):
            after = pair_of(frictions[count + 1])
        lasts = plus(after, negative(begin))
        drive.length[count, 0], drive.length[count, 1] = math.ldexp(lasts.high, -time), math.ldexp(lasts.low, -time)
        longest = max(longest, drive.length[count, 0])
        first = count * (terms + 1)
        for k in range(terms):
            drive.coefficients[first + k] = math.ldexp(polynomial[row, k], k * time - force)
        drive.coefficients[first + terms] = math.ldexp(own_b if math.isnan(b) else b, -force)
        for k in range(waves):
            sine, given_sine = drive.sines[count * waves + k], sines[row, k]
            sine[0, 0], sine[1, 0] = math.ldexp(given_sine[0], -force), math.ldexp(given_sine[1], time)
            turned = times(begin, given_sine[1])
            put(sine[2], plus(turned, TwoFloats(given_sine[2], 0.0)))
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
