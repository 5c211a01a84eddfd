"""A record (numerics/linear/record.py) read by the names of its columns; balls taken apart and put together again."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from flint import arb
from mpmath.libmp import MPZ, fzero
from numpy.typing import NDArray

from numerics.arithmetic.ball import precision
from numerics.arithmetic.protocol import Number
from numerics.linear.record import AT, Record

STATE = ("x1", "v1", "x2", "v2")
_RADIUS_BITS, _WIDE_BITS = 30, 106


class Columns:
    """The columns of one record; `wide` where two floats are a number of double-double."""

    def __init__(self, record: Record, *, wide: bool) -> None:
        """Read this record."""
        self.record, self.wide, self.in_floats = record, wide, isinstance(record.rows, np.ndarray)

    def code(self, name: str) -> NDArray[Any]:
        """Return a code of all rows, a float."""
        if self.in_floats:
            column: NDArray[Any] = self.record.rows[:, AT[name]]
            return column
        return np.array([getattr(row, name) for row in self.record.rows], dtype=float)

    def numbers(self, name: str) -> NDArray[Any]:
        """Return a number of all rows: floats, or an object array."""
        return np.asarray(self.table(name)[0])

    def table(self, *names: str) -> NDArray[Any]:
        """Return some numbers of all rows, a line each."""
        rows, at = self.record.rows, [AT[name] for name in names]
        if isinstance(rows, np.ndarray) and not self.wide:
            return np.asarray(rows.T[at])
        found = np.empty((len(names), len(rows)), dtype=object)
        if isinstance(rows, np.ndarray):
            found.ravel()[:] = sums(rows.T[at].ravel(), rows.T[[one + 1 for one in at]].ravel())
        else:
            found[:] = [[getattr(row, name) for row in rows] for name in names]
        return found

    def halves(self, name: str) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return a number of all rows as its high and its low half; of floats."""
        at = AT[name]
        return np.asarray(self.record.rows[:, at]), np.asarray(self.record.rows[:, at + 1])

    @property
    def last_mode(self) -> float:
        """Return the mode at the end, the sign of v1 - v2."""
        return float(self.record.end[AT["mode"]] if self.in_floats else self.record.end.mode)

    def last(self, name: str) -> Number:
        """Return a number of the end, or what friction or viscosity took up to there (J)."""
        end, at = self.record.end, AT[name]
        if not self.in_floats:
            return getattr(end, name)
        return sums(end[at : at + 1], end[at + 1 : at + 2])[0] if self.wide else float(end[at])


def sums(high: NDArray[np.float64], low: NDArray[np.float64]) -> list[mpmath.mpf]:
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


def parts_of(point: arb) -> tuple[int, int]:
    """Return mantissa and exponent of 2 of a ball without a radius."""
    mantissa, exponent = point.man_exp()
    return int(mantissa), int(exponent)


def ball_of(middle: int, middle_exponent: int, radius: int, radius_exponent: int) -> arb:
    """Return the ball of these parts of its middle and its radius, the very same one."""
    with precision(max(53, middle.bit_length())):  # flint rounds what it is given
        point = arb((middle, middle_exponent))
        if radius == 0:
            return point
        # a radius is rounded up to the next of 30 bits, even if it has no more: it comes back from just below
        shift = _RADIUS_BITS + 1 - radius.bit_length()
        return arb(point, arb(((radius << shift) - 1, radius_exponent - shift)))
