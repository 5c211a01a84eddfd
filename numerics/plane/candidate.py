"""What a slip may be for a step, on 0 <= x <= 1: the polynomials whose defect slip.py bounds. Nothing is proved here.

All else follows from s, which is cut at the degree, by quadrature. Of few digits compiled double-double does it; where
there are more, or numbers leave its range, it is formed in balls, of which the midpoints are taken.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_poly, arb_series

from numerics.arithmetic.compiled import can_compile, compiled
from numerics.plane.defect import Swing, swing_along
from numerics.plane.polynomial import midpoints, scaled
from numerics.plane.series import Point, slip_series
from numerics.plane.series_in_pairs import Table, expand, stretch
from numerics.plane.system import Drive, System, highest
from numerics.plane.vector import Vector

_MORE = 6
"""Terms beyond those of s with which the rest follows from it."""
_BITS = 88
"""Up to so many bits double-double has some to spare."""
_RANGE = 2.0**240
"""Of numbers up to this size, and down to its inverse, products of three have low halves."""


class Candidate(NamedTuple):
    """A slip for a time sigma = h x: t, q1, v2, s, and sine and cosine of each phase."""

    t: arb_poly
    q1: Vector
    v2: Vector
    s: Vector
    swing: Swing


class InBalls:
    """Candidates from a series in balls; `rows` of s, q1, v2 and t are coefficients of (sigma/unit)^k."""

    unit = 1.0

    def __init__(self, system: System, at: Point) -> None:
        """Form the series at a point."""
        self.system, self.at = system, at
        self.q1, self.v2, self.s, size = slip_series(system, at, system.degree)
        self.rows: Any = self.s, self.q1, self.v2, [[at.t, *(x / k for k, x in enumerate(size, start=1))]]

    def drawn(self, h: arb) -> Candidate:
        """Return a step, with the load along the series."""
        system, at = self.system, self.at
        drive, top = system.pieces[at.piece], system.degree + 1 + _MORE
        q1, v2, s = (Vector(scaled(x, h) for x in part) for part in (self.q1, self.v2, self.s))

        def followed(rates: Vector, start: Vector) -> Vector:
            return Vector(midpoints(x.truncate(top).integral() + y) for x, y in zip(rates, start, strict=True))

        size = midpoints(arb_series((s * s @ drive.b_squared).coeffs(), top).sqrt())
        t = midpoints((size * h).integral() + at.t)
        rate, swing = t.derivative(), swing_along(drive, t, top)
        push = system.push(drive.force(t, swing), q1, v2 + s)
        v2 = followed((push * rate - s.each(arb_poly.derivative) * system.m1) * (1 / system.mass), at.v2)
        return Candidate(t, followed((v2 + s) * rate, at.q1), v2, s, swing)


class InPairs:
    """The same from a series in compiled double-double (series_in_pairs.py)."""

    is_good = False
    """Whether all numbers are in range."""

    def __init__(self, system: System, at: Point) -> None:
        """Form the series at a point."""
        drive, n, length = system.pieces[at.piece], system.n, system.degree + 1
        known, self.after = constants(system, drive), [at.t, *chain(*drive.swing(at.t))]
        self.at, self.n, self.length, self.clock = at, n, length, 5 * n + 1
        size = float(drive.friction(at.s)[1].mid())
        begin, after = halves([*at.s, *at.v2, *at.q1]), halves(self.after)
        if known is None or not _in_range(begin, after, size):
            return
        self.table = np.zeros((2, self.clock + len(self.after) + max(0, len(drive.polynomial) - 2), length + _MORE))
        self.table[:, : 3 * n, 0], self.table[:, self.clock : self.clock + len(self.after), 0] = begin, after
        self.unit = 2.0 ** -round(math.log2(known.pace + size / known.period))
        compiled(expand)(self.table, *known.tables, system.degree, self.unit)
        self.is_good = bool(np.isfinite(self.table).all())
        shown = self.table[0, :, :length]
        self.rows = shown[:n], shown[2 * n : 3 * n], shown[n : 2 * n], shown[self.clock : self.clock + 1]

    def drawn(self, h: arb) -> Candidate:
        """Return a step."""
        at, n, table = self.at, self.n, self.table.copy()
        compiled(stretch)(table, *halves([h / self.unit])[:, 0].tolist())
        high, low = table.tolist()

        def these(first: int, start: Sequence[arb], top: int | None = None) -> Vector:
            rows = enumerate(start, start=first)
            return Vector(arb_poly([x, *high[row][1:top]]) + arb_poly([0, *low[row][1:top]]) for row, x in rows)

        t, *waves = these(self.clock, self.after)
        s, v2, q1 = these(0, at.s, self.length), these(n, at.v2), these(2 * n, at.q1)
        return Candidate(t, q1, v2, s, [*zip(waves[::2], waves[1::2], strict=True)])


class Constants(NamedTuple):
    """What `expand` reads of a piece of force; how fast a direction settles by sigma; and a period, s."""

    tables: tuple[Table, Table, Table, Table]
    pace: float
    period: float


@lru_cache(maxsize=8)
def constants(system: System, drive: Drive) -> Constants | None:
    """Return the constants, None if one is out of range."""
    held = [[dict(row).get(j, arb(0)) for j in range(2 * system.n)] for row in system.held]
    waves = [[*amplitudes, omega] for omega, _, amplitudes in drive.sines]
    masses = [system.m1, system.m2, system.mass, drive.b_squared]
    rows = masses, held, drive.polynomial, waves
    tables = [np.stack([*map(halves, one)], axis=1) if one else np.zeros((2, 0, 1)) for one in rows]
    pace, period = highest(system.kappa * drive.b_squared), highest((system.mass / system.stiff).each(arb.sqrt))
    found = Constants(tuple(tables), float(pace), float(period))  # type: ignore[arg-type]
    return found if _in_range(*tables, found.pace, found.period) else None


def candidates(system: System, at: Point) -> InBalls | InPairs:
    """Return the candidates for a step from a point."""
    if system.bits <= _BITS and can_compile():
        found = InPairs(system, at)
        if found.is_good:
            return found
    return InBalls(system, at)


def halves(numbers: Sequence[arb]) -> Table:
    """Return numbers as pairs of floats, (2, len)."""
    high = [float(x.mid()) for x in numbers]
    return np.array([high, [float((x - arb(y)).mid()) for x, y in zip(numbers, high, strict=True)]])


def _in_range(*given: Any) -> bool:
    """Return whether high halves are 0 or of a size that leaves room."""
    highs = [abs(x[0] if isinstance(x, np.ndarray) else np.array(x)) for x in given]
    return all(bool(((x == 0) | ((x < _RANGE) & (x * _RANGE > 1))).all()) for x in highs)
