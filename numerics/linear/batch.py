"""Many scenes in one compiled call, in float64: first events and ends out.

In come rows of numbers, of one piece of force and the same pieces of friction; or scenes with pieces of any kind.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compilable, compilable_with, compiled
from numerics.arithmetic.pair import Pair, plus, times, two_sum
from numerics.linear.columns import Constants, Drive, Problem, Room, constants, make_room
from numerics.linear.kernel import OUT_OF_RANGE, Log, follow_in
from numerics.linear.prepare import REACH, Prepared, most_terms
from numerics.linear.record import AT, END_ROW, ROW, finish
from numerics.linear.table import FIRST, Tables, form, make_tables

_MODE, _X1, _EVENT, _PIECE, _LOCAL = (AT[name] for name in ("mode", "x1", "event", "piece", "local"))
Floats = NDArray[np.float64]


class Columns(Protocol):
    """What a batch gives: the table (n, 20) of SI numbers as halves, polynomial (n, p), sines (n, s, 3).

    `frictions` (k, 4), the same for all rows: when a piece of friction begins (s), the first one at 0, and its b (N),
    as halves; nan for the row's own b. With more than one piece the polynomial is a constant at most.
    """

    table: Any
    polynomial: Any
    sines: Any
    frictions: Any


class Drives(NamedTuple):
    """Drives of many scenes one after another (columns.Drive): scene i has count[i] pieces from first[i] on."""

    first: Any
    count: Any
    begin: Any
    """When each piece begins, s."""
    drive: Drive


@np.errstate(all="ignore")  # what is out of range is seen by the kernel
def run_rows(columns: Columns, literal: bool, max_events: int, has_ledger: bool, kept: Floats, ends: Floats) -> None:
    """Solve rows of scenes; write start and first events of each to `kept` (n, k, ROW), its end to `ends` (n, END_ROW).

    Rows that are in doubt, or out of range, keep the `how` that they had. Without `has_ledger` an end says nan of what
    friction and viscosity took: that costs a fifth of the time, and not everybody asks. Releases Python's lock.
    """
    table, terms, waves = columns.table, columns.polynomial.shape[1], columns.sines.shape[1]
    m1, m2, a2, b, until, a1 = table[:, [0, 2, 4, 6, 16, 18]].T
    mass = np.frexp(m1 + m2)[1]
    time, length = (mass - np.frexp(a2)[1]) // 2, np.frexp(b * (m1 + m2) / (a2 * m2))[1]
    bodies: Any = np.zeros((len(table), 5, 2))
    starts = np.zeros((len(table), ROW))
    for place, value, power in ((0, m1, 0), (2, m2, 0), (3, a1, 1), (4, a2, 2)):
        bodies[:, place, 0] = np.ldexp(value, power * time - mass)
    bodies[:, 1] = np.transpose(two_sum(bodies[:, 0, 0], bodies[:, 2, 0]))
    for k in range(4):
        starts[:, _X1 + 2 * k] = np.ldexp(table[:, 8 + 2 * k], k % 2 * time - length)
    starts[:, _MODE] = np.sign(table[:, 10] - table[:, 14])
    drives, is_lost = _drives_of(columns, b, until, time, mass + length - 2 * time)
    starts[is_lost, _X1] = np.nan
    tables, any_pair = make_tables(1, FIRST + terms + 2 * waves, most_terms(terms)), constants(np.ones((5, 2)), literal)
    units, decided = np.transpose([mass, time, length]).astype(np.int64), starts[:, _MODE] != 0.0
    run = compiled(follow_many)
    run(any_pair, bodies, tables, drives, starts, decided, max_events, has_ledger, units, kept, ends)


def _drives_of(columns: Columns, own_b: Any, until: Any, time: Any, force: Any) -> tuple[Drives, Any]:
    """Return the drives of rows, in units of 2^time s and 2^force N, where each piece of friction begins a piece.

    And in which of them a phase is not good to its own size, as its terms cancel.
    """
    frictions, polynomial, sines = columns.frictions, columns.polynomial, columns.sines
    rows, pieces, terms, waves = len(until), len(frictions), polynomial.shape[1], sines.shape[1]
    begin: Any = Pair(*frictions[:, :2].T)
    until, each = until[:, None], time[:, None]
    begins = (begin.high < until) | ((begin.high == until) & (begin.low < 0.0))
    is_last = ~np.pad(begins[:, 1:], ((0, 0), (0, 1)))
    high: Any = np.where(is_last, until, np.roll(begin.high, -1))
    low: Any = np.where(is_last, 0.0, np.roll(begin.low, -1))
    length = np.ldexp(np.stack(plus(Pair(high, low), -begin), axis=-1), -each[:, :, None])
    b = np.broadcast_to(frictions[:, 2:], (rows, pieces, 2)).copy()
    b[:, :, 0] = np.where(np.isnan(b[:, :, 0]), own_b[:, None], b[:, :, 0])
    amplitude, omega, phase = np.moveaxis(sines[:, None], -1, 0)
    turned = times(Pair(begin.high[:, None], begin.low[:, None]), omega)
    sine: Any = np.zeros((rows, pieces, waves, 3, 2))
    sine[..., 2, :] = np.stack(plus(turned, Pair(phase, 0.0)), axis=-1)
    is_lost = (2.0 * abs(sine[..., 2, 0]) < abs(turned.high)).any(axis=2) & begins
    sine[..., 0, 0] = np.ldexp(amplitude, -force[:, None, None])
    sine[..., 1, 0] = np.ldexp(omega, each[:, :, None])
    coefficients = np.zeros((rows, terms, 2))
    coefficients[:, :, 0] = np.ldexp(polynomial, np.arange(terms) * each - force[:, None])
    places = np.zeros((rows * pieces, 6), dtype=np.int64)
    places[:, 0], places[:, 1] = np.repeat(terms * np.arange(rows), pieces), terms
    places[:, 2], places[:, 3], places[:, 5] = waves * np.arange(rows * pieces), waves, 1
    drive = Drive(
        places,
        np.ldexp(b, -force[:, None, None]).reshape(-1, 2),
        length.reshape(-1, 2),
        coefficients.reshape(-1, 2),
        sine.reshape(-1, 3, 2),
    )
    return Drives(pieces * np.arange(rows), begins.sum(axis=1), np.tile(begin.high, rows), drive), is_lost.any(axis=1)


def run_prepared(given: Sequence[Prepared], max_events: int, kept: Floats, ends: Floats) -> None:
    """Do for scenes as they are prepared what `run_rows` does for rows; all of one pair and with the same tables."""
    drives = [one.drive for one in given]
    places, *numbers = (np.concatenate(parts) for parts in zip(*drives, strict=True))
    counts = np.array([(len(one.places), len(one.coefficients), len(one.sines)) for one in drives])
    before = np.cumsum(counts, axis=0) - counts
    places[:, [0, 2]] += np.repeat(before[:, 1:], counts[:, 0], axis=0)
    begin = np.array([float(piece.start) for one in given for piece in one.pieces])
    of_all = Drives(before[:, 0], counts[:, 0], begin, Drive(places, *numbers))
    starts, decided = np.array([one.start for one in given]), np.array([one.is_decided for one in given])
    pair, tables, units = given[0].pair, given[0].tables, np.array([one.units for one in given])
    run = compiled(follow_many)
    run(pair, np.zeros((0, 5, 2)), tables, of_all, starts, decided, max_events, True, units, kept, ends)


@compilable_with(makes_arrays=True, forceinline=False)
def follow_many(
    pair: Constants,
    bodies: Any,
    tables: Tables,
    drives: Drives,
    starts: Any,
    decided: Any,
    max_events: int,
    has_ledger: bool,
    units: Any,
    kept: Any,
    ends: Any,
) -> None:
    """Solve many scenes; of the rows that are kept only events count, and times from the run's start.

    All have the pair; or if there are `bodies` (n, 5, 2), as `form` takes them, each its own, and one kind of force:
    tables are then formed, anew where they change.
    """
    first, count, begin, (places, _, length, _, sines) = drives
    room, end = make_room(tables.rows.shape[4], tables.rows.shape[5]), np.zeros(END_ROW)
    rows, limits = np.empty((kept.shape[1] + count.max(), ROW)), (max_events, kept.shape[1], has_ledger)
    for n in range(starts.shape[0]):
        of = slice(first[n], first[n] + count[n])
        if bodies.shape[0] > 0:
            pair, place = constants(bodies[n], pair.literal), places[first[n]]
            omegas = np.ascontiguousarray(sines[place[2] : place[2] + place[3], 1])
            form(tables, 0, bodies[n], place[1], omegas, length[of, 0].max(), REACH, False)
        how, written = follow_one(pair, tables, drives, n, room, starts[n], decided[n], limits, rows, end)
        if how < OUT_OF_RANGE and finish(rows[:written], end, units[n, 0], units[n, 1], units[n, 2]):
            ends[n] = end
            keep(rows[:written], begin[of], kept[n], ends[n])


@compilable
def follow_one(
    pair: Constants,
    tables: Tables,
    drives: Drives,
    n: int,
    room: Room,
    start: Any,
    is_decided: bool,
    limits: tuple[int, int, bool],
    rows: Any,
    end: Any,
) -> tuple[int, int]:
    """Follow one scene; return (how, rows written): as many as are kept, and those of pieces in between.

    `limits`: how many events, how many rows to keep, whether with a ledger. Tuples of arrays are made here, where no
    references are counted, which would cost some percent of a row.
    """
    (max_events, kept, has_ledger), given, count = limits, drives.drive, drives.count[n]
    of = slice(drives.first[n], drives.first[n] + count)
    drive = Drive(given.places[of], given.b[of], given.length[of], given.coefficients, given.sines)
    most = kept - 1 + count if kept > 1 else 1
    problem, log = Problem(pair, drive, tables, False, has_ledger), Log(rows[:most], end, max_events, False)
    how, written = follow_in(problem, room, start, is_decided, -1.0, log)
    return how, min(written, most)


@compilable_with(makes_arrays=True, forceinline=False)
def keep(rows: Any, begin: Any, kept: Any, end: Any) -> None:
    """Keep the rows of start and events, with times from the start of the run; begin[i]: when a piece begins, s."""
    done = 0
    for k in range(rows.shape[0]):
        if (k == 0 or rows[k, _EVENT] == 1.0) and done < kept.shape[0]:
            kept[done] = rows[k]
            kept[done, _LOCAL] += begin[int(rows[k, _PIECE])]
            kept[done, _PIECE] = 0.0
            done += 1
    end[_LOCAL] += begin[int(end[_PIECE])]
    end[_PIECE] = 0.0
