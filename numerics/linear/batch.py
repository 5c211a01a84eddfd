"""Many scenes in one compiled call, in float64: first events and ends out.

In come rows of numbers, of one piece of force and the same pieces of friction; or scenes with pieces of any kind.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compilable, compilable_with, compiled
from numerics.arithmetic.pair import Pair, pair_of, plus, put, times, two_sum
from numerics.linear.columns import Constants, Drive, Problem, Room, constants, make_room
from numerics.linear.kernel import OUT_OF_RANGE, Log, follow_in
from numerics.linear.prepare import REACH, Prepared, Units, most_terms
from numerics.linear.record import AT, END_ROW, ROW, finish
from numerics.linear.table import FIRST, Tables, form, make_tables

_MODE, _X1, _EVENT, _PIECE, _LOCAL = (AT[name] for name in ("mode", "x1", "event", "piece", "local"))


class Columns(NamedTuple):
    """Rows of scenes as compiled code reads them, all numbers binary64.

    `table` (n, 20): SI numbers as halves. u = sum_k polynomial[:, k] t^k + sum amplitude sin(omega t + phase), with
    `polynomial` (n, p) and `sines` (n, s, 3). `frictions` (k, 4), the same for all rows: when a piece begins (s), the
    first one at 0, and its b (N), as halves; nan for the row's own b. With more than one piece the polynomial is a
    constant at most.
    """

    table: NDArray[np.float64]
    polynomial: NDArray[np.float64]
    sines: NDArray[np.float64]
    frictions: NDArray[np.float64]

    def part(self, rows: Any) -> Columns:
        """Return some of the rows."""
        return Columns(self.table[rows], self.polynomial[rows], self.sines[rows], self.frictions)


def run_rows(
    columns: Columns,
    literal: bool,
    max_events: int,
    has_ledger: bool,
    kept: NDArray[np.float64],
    ends: NDArray[np.float64],
) -> None:
    """Solve rows of scenes; write start and first events of each to `kept` (n, k, ROW), its end to `ends` (n, END_ROW).

    Rows that are in doubt, or out of range, keep the `how` that they had. Without `has_ledger` an end says nan of what
    friction and viscosity took: that costs a fifth of the time, and not everybody asks. Releases Python's lock.
    """
    terms = most_terms(columns.polynomial.shape[1])
    compiled(follow_rows)(columns, literal, max_events, has_ledger, terms, kept, ends)


class Drives(NamedTuple):
    """Drives of many scenes one after another (columns.Drive): scene i has the pieces from first[i] to first[i + 1]."""

    first: Any
    begin: Any
    """(n, 1) when each piece begins, s."""
    drive: Drive


def run_prepared(
    given: Sequence[Prepared], max_events: int, kept: NDArray[np.float64], ends: NDArray[np.float64]
) -> None:
    """Do for scenes as they are prepared what `run_rows` does for rows; all of one pair and with the same tables."""
    drives = [one.drive for one in given]
    places, b, length, coefficients, sines = (np.concatenate(parts) for parts in zip(*drives, strict=True))
    counts = np.array([(len(one.places), len(one.coefficients), len(one.sines)) for one in drives])
    before = np.cumsum(counts, axis=0) - counts
    places[:, [0, 2]] += np.repeat(before[:, 1:], counts[:, 0], axis=0)
    begin = np.array([[float(piece.start)] for one in given for piece in one.pieces])
    of_all = Drives(np.append(before[:, 0], len(places)), begin, Drive(places, b, length, coefficients, sines))
    starts, decided = np.array([one.start for one in given]), np.array([one.is_decided for one in given])
    first = given[0]
    compiled(follow_drives)(first.pair, first.tables, of_all, starts, decided, max_events, first.units, kept, ends)


@compilable_with(makes_arrays=True, forceinline=False)
def follow_drives(
    pair: Constants,
    tables: Tables,
    drives: Drives,
    starts: Any,
    decided: Any,
    max_events: int,
    units: Units,
    kept: Any,
    ends: Any,
) -> None:
    """Solve the scenes of many drives; of the rows that are kept only events count, and times from the run's start."""
    first, begin, (places, b, length, coefficients, sines) = drives
    room, end = make_room(tables.rows.shape[4], tables.rows.shape[5]), np.zeros(END_ROW)
    rows = np.empty((kept.shape[1] + places.shape[0], ROW))
    for n in range(starts.shape[0]):
        of = slice(first[n], first[n + 1])
        drive = Drive(places[of], b[of], length[of], coefficients, sines)
        how, count = follow_one(
            pair, drive, tables, room, starts[n], decided[n], max_events, True, rows, end, kept.shape[1]
        )
        written = rows[:count]
        if how < OUT_OF_RANGE and finish(written, end, units.mass, units.time, units.length):
            ends[n] = end
            keep(written, begin[of], kept[n], ends[n])


@compilable
def follow_one(
    pair: Constants,
    drive: Drive,
    tables: Tables,
    room: Room,
    start: Any,
    is_decided: bool,
    max_events: int,
    has_ledger: bool,
    rows: Any,
    end: Any,
    kept: int,
) -> tuple[int, int]:
    """Follow one scene; return (how, rows written): as many as are kept, and those of pieces in between.

    Tuples of arrays are made here, where no references are counted, which would cost some percent of a row.
    """
    most = kept - 1 + drive.places.shape[0] if kept > 1 else 1
    problem, log = Problem(pair, drive, tables, False, has_ledger), Log(rows[:most], end, max_events, False)
    how, count = follow_in(problem, room, start, is_decided, -1.0, log)
    return how, min(count, most)


@compilable_with(makes_arrays=True, forceinline=False)
def follow_rows(
    given: Columns,
    literal: bool,
    max_events: int,
    has_ledger: bool,
    coefficients: int,
    kept: Any,
    ends: Any,
) -> None:
    """Solve rows of scenes, each in units that are powers of 2; tables are formed anew only where they change."""
    table, polynomial, sines, frictions = given
    terms, waves, pieces = polynomial.shape[1], sines.shape[1], frictions.shape[0]
    columns = FIRST + terms + 2 * waves
    tables, room = make_tables(1, columns, coefficients), make_room(columns, coefficients)
    pair, whole, start = np.zeros((5, 2)), make_drive(terms, waves, pieces), np.zeros(ROW)
    end, rows = np.zeros(END_ROW), np.empty((kept.shape[1] + pieces, ROW))
    for row in range(table.shape[0]):
        mass, time, length = put_bodies(table[row], pair, start)
        force, own_b, until = mass + length - 2 * time, table[row, 6], table[row, 16]
        for k in range(terms):
            whole.coefficients[k, 0] = math.ldexp(polynomial[row, k], k * time - force)
        count, longest = put_pieces(frictions, own_b, until, sines[row], (time, force), whole)
        if count == 0:
            continue
        form(tables, 0, pair, terms, whole.sines[:waves, 1], longest, REACH, False)
        drive = Drive(whole.places[:count], whole.b[:count], whole.length[:count], whole.coefficients, whole.sines)
        own, decided = constants(pair, literal), start[_MODE] != 0.0
        how, count = follow_one(
            own, drive, tables, room, start, decided, max_events, has_ledger, rows, end, kept.shape[1]
        )
        if how < OUT_OF_RANGE and finish(rows[:count], end, mass, time, length):
            ends[row] = end
            keep(rows[:count], frictions, kept[row], ends[row])


@compilable_with(makes_arrays=True, forceinline=False)
def make_drive(terms: int, waves: int, pieces: int) -> Drive:
    """Return room for a drive whose pieces have one polynomial, sines of their own, and jumps between them."""
    places = np.zeros((pieces, 6), dtype=np.int64)
    places[:, 1], places[:, 2], places[:, 3], places[:, 5] = terms, waves * np.arange(pieces), waves, 1
    b, length = np.zeros((pieces, 2)), np.zeros((pieces, 2))
    return Drive(places, b, length, np.zeros((terms, 2)), np.zeros((pieces * waves, 3, 2)))


@compilable
def put_bodies(numbers: Any, pair: Any, start: Any) -> tuple[int, int, int]:
    """Write a row's pair and start in its units; return the exponents of mass, time and length."""
    m1, m2, a2, b, a1 = numbers[0], numbers[2], numbers[4], numbers[6], numbers[18]
    mass = math.frexp(m1 + m2)[1]
    time, length = (mass - math.frexp(a2)[1]) // 2, math.frexp(b * (m1 + m2) / (a2 * m2))[1]
    pair[0, 0], pair[2, 0] = math.ldexp(m1, -mass), math.ldexp(m2, -mass)
    put(pair[1], two_sum(pair[0, 0], pair[2, 0]))
    pair[3, 0], pair[4, 0] = math.ldexp(a1, time - mass), math.ldexp(a2, 2 * time - mass)
    for i in range(4):
        start[_X1 + 2 * i] = math.ldexp(numbers[8 + 2 * i], -length + (time if i % 2 else 0))
    start[_MODE] = np.sign(numbers[10] - numbers[14])
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
        begin, given_b, after = pair_of(frictions[count]), frictions[count, 2], Pair(until, 0.0)
        if count + 1 < frictions.shape[0] and is_before(frictions[count + 1], until):
            after = pair_of(frictions[count + 1])
        lasts = plus(after, Pair(-begin.high, -begin.low))
        length[count, 0], length[count, 1] = math.ldexp(lasts.high, -time_unit), math.ldexp(lasts.low, -time_unit)
        longest = max(longest, length[count, 0])
        b[count, 0] = math.ldexp(own_b if math.isnan(given_b) else given_b, -force_unit)
        b[count, 1] = math.ldexp(frictions[count, 3], -force_unit)
        for k in range(waves):
            sine = moved[count * waves + k]
            sine[0, 0], sine[1, 0] = math.ldexp(sines[k, 0], -force_unit), math.ldexp(sines[k, 1], time_unit)
            turned = times(begin, sines[k, 1])
            put(sine[2], plus(turned, Pair(sines[k, 2], 0.0)))
            if 2.0 * abs(sine[2, 0]) < abs(turned.high):
                return 0, longest
        count += 1
    return count, longest


@compilable
def is_before(piece: Any, until: float) -> bool:
    """Return whether a piece begins before a time."""
    return piece[0] < until or (piece[0] == until and piece[1] < 0.0)


@compilable_with(makes_arrays=True, forceinline=False)
def keep(rows: Any, begin: Any, kept: Any, end: Any) -> None:
    """Keep the rows of start and events, with times from the start of the run; begin[i, 0]: when a piece begins, s."""
    done = 0
    for k in range(rows.shape[0]):
        if (k == 0 or rows[k, _EVENT] == 1.0) and done < kept.shape[0]:
            kept[done] = rows[k]
            kept[done, _LOCAL] += begin[int(rows[k, _PIECE]), 0]
            kept[done, _PIECE] = 0.0
            done += 1
    end[_LOCAL] += begin[int(end[_PIECE]), 0]
    end[_PIECE] = 0.0
