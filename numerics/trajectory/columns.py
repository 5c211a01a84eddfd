"""A record (numerics/linear/record.py) read by the names of its columns, whatever its numbers are."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from mpmath.libmp import MPZ, fzero
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.linear.record import AT, Knot, Record

Array = NDArray[Any]
"""Of floats, or of the numbers of an arithmetic."""
Floats = NDArray[np.float64]
Counts = NDArray[np.int64]
STATE = ("x1", "v1", "x2", "v2")
_WIDE_BITS = 106


class Columns:
    """The columns of one record; `wide` where two floats are a number of double-double."""

    def __init__(self, record: Record, *, wide: bool) -> None:
        """Read this record; of knots a table is made."""
        self.wide, self.at, self.rows, self.end = wide, AT, record.rows, record.end
        if not isinstance(record.rows, np.ndarray):
            self.at = {name: place for place, name in enumerate(Knot._fields)}
            *table, end = (one[:-1] for one in (*record.rows, record.end))
            self.rows, self.end = np.array(table, dtype=object), np.array(end, dtype=object)

    def code(self, name: str) -> Counts:
        """Return a code of all rows."""
        return np.asarray(self.rows[:, self.at[name]].astype(np.int64))

    def table(self, *names: str) -> Array:
        """Return some numbers of all rows, a line each: floats, or an object array."""
        return self._read(self.rows, names)

    def last(self, *names: str) -> list[Number]:
        """Return numbers of the end; of floats also what friction or viscosity took up to there (J)."""
        found: list[Number] = self._read(self.end.reshape(1, -1), names).ravel().tolist()
        return found

    def _read(self, rows: Array, names: tuple[str, ...]) -> Array:
        high = [self.at[name] for name in names]
        if not self.wide:
            return np.asarray(rows.T[high])
        found = np.empty((len(names), len(rows)), dtype=object)
        found.ravel()[:] = sums(rows.T[high].ravel(), rows.T[[one + 1 for one in high]].ravel())
        return found


def sums(high: Floats, low: Floats) -> list[mpmath.mpf]:
    """Return numbers of double-double, which may have more than 106 bits, rounded to these."""
    places = np.frexp(high)[1]
    tops, tails = np.ldexp(high, 53 - places).tolist(), np.rint(np.ldexp(low, _WIDE_BITS - places)).tolist()
    return [
        mpmath.make_mpf(_raw((int(top) << 53) + int(tail), place - _WIDE_BITS)) if top - top == 0 else mpmath.mpf(top)
        for top, tail, place in zip(tops, tails, places.tolist(), strict=True)
    ]


def _raw(mantissa: int, exponent: int) -> tuple[int, Any, int, int]:
    """Return sign, odd mantissa, exponent, bits, as from_man_exp does: most of what an answer in 20 digits costs."""
    size = abs(mantissa)
    if not size:
        return fzero
    zeros = (size & -size).bit_length() - 1
    return int(mantissa < 0), MPZ(size >> zeros), exponent + zeros, size.bit_length() - zeros
