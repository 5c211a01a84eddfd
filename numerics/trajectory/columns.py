"""Types of arrays, and the numbers of double-double in a record (numerics/linear/record.py)."""

from __future__ import annotations

import math
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


def room(what: str, *shape: int) -> Floats:
    """Return an array that is not filled yet. Raises ValueError, naming what takes more memory than there is."""
    try:
        return np.empty(shape)
    except (MemoryError, ValueError):
        size = f"{8 * math.prod(shape) / 2**30:.3g} GiB"
        raise ValueError(f"{what} take {size}, more memory than there is; ask for fewer at a time") from None


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
