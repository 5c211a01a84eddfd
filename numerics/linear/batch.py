"""Many scenes in float64: numbers in columns become what the kernel reads, and chunks of them are solved by its code.

Each scene has one piece of force and one friction number.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compiled
from numerics.linear.kernel import OUT_OF_RANGE, Log, follow_all
from numerics.linear.ledger import ledger
from numerics.linear.model import Bodies, Layout, ModeRows, make_rows, norm_of, put_rows
from numerics.linear.record import AT, END_ROW, ROW, UNKNOWN, factors_of, finish
from numerics.linear.room import Drive, Problems, space_for
from numerics.linear.table import Tables, form, make_tables, most_terms, put_matrices

Floats = NDArray[np.float64]
NUMBERS = 10
"""So many of a scene stand in front of those of its force (solver/batch.py)."""
_MODE, _JUMP, _X1, _HOW, _EVENTS = (AT[name] for name in ("mode", "jump", "x1", "how", "events"))
_TAKEN = AT["friction"]
_ROUNDINGS = 4.0
"""By so many is an entry of the matrices off that is formed in floats."""
_MOST_ROWS = 100_000
"""Rows of ledgers that are kept at a time."""


class Columns:
    """Scenes as the kernel reads them, each in units that are powers of 2."""

    def __init__(self, given: Floats, terms: int, literal: bool) -> None:
        """Read rows of binary64 numbers in SI units.

        A row is NUMBERS of a scene, the coefficients of u in powers of t, so many `terms`, and amplitude, omega and
        phase of each of its sines.
        """
        m1, m2, a2, b, *_, a1 = given[:, :NUMBERS].T
        with np.errstate(all="ignore"):  # of what is out of range, which the kernel finds
            mass, time, length = (np.frexp(one)[1] for one in (m1 + m2, a2, b * (m1 + m2) / (a2 * m2)))
            time = (mass - time) // 2
            m1, m2, whole = (np.ldexp(one, -mass) for one in (m1, m2, m1 + m2))
            a1, a2, one = np.ldexp(a1, time - mass), np.ldexp(a2, 2 * time - mass), np.ones(len(given))
            self.bodies = Bodies(m1, a1, a2, 1.0 / m1, 1.0 / m2, 1.0 / whole, m1 / whole, m2 / whole, one)
            units, self.norms = np.column_stack([mass, time, length]), np.column_stack(norm_of(self.bodies))
            self.starts, self.drives = _starts(given, time, length), _drives(given, terms, units)
            self.to_si = factors_of(units)
            self.longest = np.minimum(self.drives.length[:, 0, 0], 4.0 / np.sqrt(a2 / whole))
            """A step is at most half as long as the second of these."""
        self.literal, self.omegas = literal, self.drives.sines[:, :, 1, 0]
        self.layout = Layout((terms, 0, 0, 0, 1), ((np.nan,) * self.omegas.shape[1], (), (), (), ()))
        of_tables = np.column_stack([*self.bodies, self.longest, self.omegas])
        self.kinds = np.append(0, np.cumsum((of_tables[1:] != of_tables[:-1]).any(axis=1)))
        """Scenes of one kind follow each other and share their tables."""
        self._made: tuple[int, Tables] | None = None

    def follow(self, rows: slice, max_events: int, kept: Floats, ends: Floats) -> None:
        """Solve a slice of the scenes; write start and first events of each to `kept` (n, k, ROW), its end to `ends`.

        Those that are in doubt, or out of range, are UNKNOWN at the end (n, END_ROW).
        """
        self._run(self._problems(rows), rows, max_events, kept, ends)
        self._finish(rows, kept, ends)

    def take(self, some: Any, max_events: int, ends: Floats) -> None:
        """Solve some scenes again, with all their events; write what was taken and given to their ends, J.

        The ends (n, END_ROW) say how many events there are; nan is what segments have that are too long for steps.
        """
        most = 2 + int(ends[:, _EVENTS].max())
        at_once = max(1, _MOST_ROWS // most)
        for first in range(0, len(some), at_once):
            rows, own = some[first : first + at_once], ends[first : first + at_once]
            problems, kept = self._problems(rows), np.empty((len(rows), most, ROW))
            self._run(problems, rows, max_events, kept, own)
            taken, is_long = np.zeros((len(rows), END_ROW - _TAKEN)), np.zeros(kept.shape[:2], dtype=bool)
            compiled(ledger)(problems, space_for(problems.tables), kept, own, taken, is_long)
            taken[is_long.any(axis=1)] = np.nan
            own[:, _TAKEN:] = taken
            self._finish(rows, kept, own)

    @property
    def at_once(self) -> int:
        """Return how many scenes' tables are made at once at most: they take 50 MB then."""
        return max(1, 2**20 // self.layout.size**2)

    def _problems(self, rows: Any) -> Problems:
        """Return what the kernel follows in some of the scenes, in their order."""
        kinds, drives = self.kinds[rows], Drive(*(one[rows] for one in self.drives))
        places = drives.places.copy()
        places[:, 0, 0] = kinds - kinds[0]
        tables = self._tables(int(kinds[0]), int(kinds[-1]))
        return Problems(self.norms[rows], drives._replace(places=places), tables, self.literal)

    def _tables(self, first: int, last: int) -> Tables:
        """Return the tables of some kinds; those of one kind are kept."""
        made = self._made
        if made is not None and made[0] == first == last:
            return made[1]
        chosen, n = np.searchsorted(self.kinds, np.arange(first, last + 1)), self.layout.size
        omegas = np.zeros((n, len(chosen)))
        omegas[n + 1 - 2 * self.omegas.shape[1] :: 2] = self.omegas[chosen].T
        rows = ModeRows(*(np.zeros((*one.shape, len(chosen))) for one in make_rows(n)))
        with np.errstate(all="ignore"):
            put_rows(Bodies(*(one[chosen] for one in self.bodies)), self.layout.blocks, omegas, (0.0, 0.0, 1.0), rows)
        tables = make_tables(len(chosen), n, most_terms(self.layout.terms[0]))
        put_matrices(tables, slice(None), self.layout, ModeRows(*(np.moveaxis(one, -1, 0) for one in rows)))
        compiled(form)(tables, self.norms[chosen], self.longest[chosen], _ROUNDINGS)
        if first == last:  # else no other chunk has them all
            self._made = first, tables
        return tables

    def _run(self, problems: Problems, rows: Any, max_events: int, kept: Floats, ends: Floats) -> None:
        log = Log(kept, ends, max_events, False)
        compiled(follow_all)(problems, space_for(problems.tables), self.starts[rows], -1.0, log)

    def _finish(self, rows: Any, kept: Floats, ends: Floats) -> None:
        compiled(finish)(kept, ends, self.to_si[rows])
        ends[ends[:, _HOW] >= OUT_OF_RANGE, _HOW] = UNKNOWN


def _starts(given: Floats, time: Any, length: Any) -> Floats:
    """Return the starts of rows of numbers in their units."""
    x1, v1, x2, v2 = given[:, 4:8].T
    found, speed = np.zeros((len(given), ROW)), length - time
    for k, (number, exponent) in enumerate(((x1, length), (v1, speed), (x2, length), (v2, speed))):
        found[:, _X1 + k] = np.ldexp(number, -exponent)
    found[:, _MODE], found[:, _JUMP] = np.sign(v1 - v2), v1 == v2
    return found


def _drives(given: Floats, terms: int, units: Any) -> Drive:
    """Return the signals of rows of numbers in their units."""
    (mass, time, length), waves = units.T, given[:, NUMBERS + terms :].reshape(len(given), -1, 3)
    force, lengths = mass + length - 2 * time, np.zeros((len(given), 1, 2))
    lengths[:, 0, 0] = np.ldexp(given[:, 8], -time)
    coefficients, sines = np.zeros((len(given), terms + 1)), np.zeros((*waves.shape, 2))
    for k in range(terms):
        coefficients[:, k] = np.ldexp(given[:, NUMBERS + k], k * time - force)
    coefficients[:, terms] = np.ldexp(given[:, 3], -force)
    sines[..., 0, 0], sines[..., 2, 0] = np.ldexp(waves[..., 0], -force[:, None]), waves[..., 2]
    sines[..., 1, 0] = np.ldexp(waves[..., 1], time[:, None])
    return Drive(np.tile([0, 0, 0, 1, 0], (len(given), 1, 1)), lengths, coefficients, sines)
