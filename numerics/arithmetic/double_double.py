"""Double-double: 31 digits from pairs of binary64 numbers. The kernels work with the pairs, Python with their sums."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from mpmath.libmp import from_man_exp
from numpy.typing import NDArray

from numerics.arithmetic.multiprecision import Multiprecision
from numerics.errors import OutOfRange
from numerics.kernel.double_double import Double, two_sum

LARGEST, SMALLEST = 1e100, 1e-130
"""The range in which products of a few numbers keep their 106 bits."""


class DoubleDouble(Multiprecision):
    """mpmath numbers with the 106 bits of double-double, into which the kernels' results are turned exactly."""

    name = "double-double"

    def __init__(self) -> None:
        """Take the digits that double-double has."""
        super().__init__(31)

    def halves(self, x: Any) -> Double:
        """Return a number as its binary64 number and that of the rest; raises OutOfRange."""
        high = float(x)
        if x != 0 and not SMALLEST < abs(high) < LARGEST:
            raise OutOfRange(
                "a number of this scene is beyond the range of double-double (1e-130 to 1e100); use --arithmetic ball"
            )
        return two_sum(high, float(mpmath.fsub(x, high, exact=True)))

    @staticmethod
    def numbers(high: NDArray[np.float64], low: NDArray[np.float64]) -> list[Any]:
        """Return the numbers high + low, exactly."""
        (high_digits, high_exponents), (low_digits, low_exponents) = _integers(high), _integers(low)
        shifts, exponents = (high_exponents - low_exponents).tolist(), low_exponents.tolist()
        pairs = zip(high_digits.tolist(), low_digits.tolist(), shifts, exponents, strict=True)
        return [mpmath.mp.make_mpf(from_man_exp((above << shift) + below, at)) for above, below, shift, at in pairs]


def _integers(x: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return integers n and k with x = n 2^k, the least possible k for a zero being that of the smallest numbers."""
    mantissas, exponents = np.frexp(x)
    return np.ldexp(mantissas, 53).astype(np.int64), np.where(x == 0, -2000, exponents - 53).astype(np.int64)
