"""Types of arrays, and the numbers of double-double in a record (numerics/linear/record.py)."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from mpmath.libmp import MPZ, fzero
from numpy.typing import NDArray

Array = NDArray[Any]
"""Of floats, or of the numbers of an arithmetic."""
Floats = NDArray[np.float64]
Counts = NDArray[np.int64]
STATE = ("x1", "v1", "x2", "v2")
_WIDE_BITS = 106


def sums(high: Any, low: Any) -> list[mpmath.mpf]:
    """Return numbers of double-double, arrays of floats, which may have more than 106 bits, rounded to these."""
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
