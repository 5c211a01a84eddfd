"""Many scenes in one compiled call, in float64: first events and ends out.

In come rows of numbers, of one piece of force and one friction number.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with, compiled
from numerics.linear.kernel import EVENT_LIMIT, OUT_OF_RANGE, Log, follow
from numerics.linear.ledger import ledger
from numerics.linear.model import FIRST, Bodies, Layout, Rows, make_rows, norm_of, put_rows
from numerics.linear.record import AT, END_ROW, UNKNOWN, finish
from numerics.linear.room import Drive, Problem, space_for
from numerics.linear.table import Tables, form, make_tables, most_terms

_MODE, _JUMP, _X1, _HOW = (AT[name] for name in ("mode", "jump", "x1", "how"))
_TAKEN = AT["friction"]
_ROUNDINGS = 4.0
"""By so many is an entry of the matrices off that compiled code forms."""


NUMBERS = 10
"""So many of a scene stand in front of those of its force (solver/batch.py)."""


class Work(NamedTuple):
    """What compiled code solves one row after another in."""

    blocks: Any
    rows: Rows
    tables: Tables
    drive: Drive
    space: Any
    start: Any
    asked: Any
    """(n + 5,) the numbers of which tables are made: the frequency of each sine at its cosine, then the rest."""
    made_of: Any
    """Those of which they were made last."""


def work_for(terms: int, waves: int) -> Work:
    """Return room for rows of u and one friction number behind its polynomial."""
    n, layout = FIRST + terms + 2 * waves + 1, Layout((terms, 0, 0, 0, 1), ((np.nan,) * waves, (), (), (), ()))
    tables, places = make_tables(1, n, most_terms(terms)), np.array([[0, 0, 0, 1, 0]])
    drive = Drive(places, np.zeros((1, 2)), np.zeros(terms + 1), np.zeros((waves, 3, 2)))
    arrays = space_for(tables), np.zeros(END_ROW), np.zeros(n + 5), np.zeros(n + 5)
    return Work(layout.blocks, make_rows(n), tables, drive, *arrays)


def follow_many(given: Any, terms: int, literal: bool, max_events: int, has_ledger: bool, kept: Any, ends: Any) -> None:
    """Solve rows of scenes; write start and first events of each to `kept` (n, k, ROW), its end to `ends` (n, END_ROW).

    A row is NUMBERS of a scene in SI units, the coefficients of u in powers of t, so many `terms`, and amplitude, omega
    and phase of each of its sines; all binary64. Each is solved in units that are powers of 2; tables are formed anew
    only where they change. Rows that are in doubt, or out of range, are UNKNOWN at the end. With `has_ledger`, `kept`
    is (1, k, ROW) with room for all rows of any scene, and the end says what was taken and given.
    """
    work = work_for(terms, (given.shape[1] - NUMBERS - terms) // 3)
    compiled(follow_rows)(given, work, literal, max_events, has_ledger, kept, ends)


@compilable_with(forceinline=False)
def follow_rows(given: Any, work: Work, literal: bool, max_events: int, has_ledger: bool, kept: Any, ends: Any) -> None:
    """Solve rows of scenes (follow_many)."""
    drive, start, tables = work.drive, work.start, work.tables
    for row in range(given.shape[0]):
        bodies, units = put_bodies(given[row], start)
        put_signals(given[row], units, work)
        found, end, norm, longest = kept[row % kept.shape[0]], ends[row], norm_of(bodies), drive.length[0, 0]
        if is_new(work, bodies, longest):
            clear(work.rows)
            put_rows(bodies, work.blocks, work.asked[:-5], (0.0, 0.0, 1.0), work.rows)
            form(tables, drive.places[0, 0], norm, work.blocks, work.rows, _ROUNDINGS, longest)
        problem, log = Problem(norm, drive, tables, literal), Log(found, end, max_events, False)
        how, count = follow(problem, work.space, start, -1.0, log)
        if has_ledger and how < OUT_OF_RANGE:
            segments, taken = count - (1 if how == EVENT_LIMIT else 0), end[_TAKEN:]
            taken[:] = 0.0
            if ledger(problem, work.space, found, 0, segments, end, taken) < segments:
                taken[:] = np.nan
        if how >= OUT_OF_RANGE or not finish(found[:count], end, units[0], units[1], units[2]):
            end[_HOW] = UNKNOWN


@compilable
def put_bodies(numbers: Any, start: Any) -> tuple[Bodies, tuple[int, int, int]]:
    """Write a row's start in its units; return its bodies, and the exponents of mass, time and length."""
    m1, m2, a2, b, a1 = numbers[0], numbers[1], numbers[2], numbers[3], numbers[9]
    mass = 0 + math.frexp(m1 + m2)[1]  # of 64 bits, as are the units of a scene
    time, length = (mass - math.frexp(a2)[1]) // 2, 0 + math.frexp(b * (m1 + m2) / (a2 * m2))[1]
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
def is_new(work: Work, bodies: Bodies, longest: float) -> bool:
    """Return whether tables depend on other numbers than before, and keep these."""
    asked, made_of, found = work.asked, work.made_of, False
    asked[-5], asked[-4], asked[-3], asked[-2], asked[-1] = bodies.m1, bodies.a1, bodies.a2, bodies.share_2, longest
    for k in range(len(asked)):
        found, made_of[k] = found or made_of[k] != asked[k], asked[k]
    return found


@compilable
def put_signals(numbers: Any, units: tuple[int, int, int], work: Work) -> None:
    """Write the length, the coefficients and the sines of a row."""
    (mass, time, place), drive, terms = units, work.drive, work.drive.coefficients.shape[0] - 1
    force = mass + place - 2 * time
    drive.length[0, 0] = math.ldexp(numbers[8], -time)
    for k in range(terms):
        drive.coefficients[k] = math.ldexp(numbers[NUMBERS + k], k * time - force)
    drive.coefficients[terms] = math.ldexp(numbers[3], -force)
    for k in range(drive.sines.shape[0]):
        sine, first = drive.sines[k], NUMBERS + terms + 3 * k
        sine[0, 0], sine[2, 0] = math.ldexp(numbers[first], -force), numbers[first + 2]
        sine[1, 0] = work.asked[FIRST + terms + 2 + 2 * k] = math.ldexp(numbers[first + 1], time)
