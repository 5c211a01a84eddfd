"""Double-double, seen from Python: compiled code has pairs of floats, Python the mpmath numbers they are."""

from __future__ import annotations

import math
from typing import Any

import mpmath
from mpmath.libmp import from_man_exp

from numerics.arithmetic.double_double import Double, two_sum
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.errors import OutOfRange

LARGEST, SMALLEST = 1e100, 1e-130
"""The range in which products of a few numbers keep their 106 bits."""


class DoubleDouble(Multiprecision):
    """mpmath numbers with the 106 bits of double-double, into which its results are turned exactly."""

    name = "double-double"

    def __init__(self) -> None:
        """Take the digits that double-double has."""
        super().__init__(31)

    @staticmethod
    def halves(x: Any) -> Double:
        """Return a number as its binary64 number and that of the rest, in this context; raises OutOfRange."""
        high = float(x)
        if x != 0 and not SMALLEST < abs(high) < LARGEST:
            raise OutOfRange(
                'a number of this scene is beyond the range of double-double (1e-130 to 1e100); use arithmetic="ball"'
            )
        return two_sum(high, float(x - high))


def exact_sum(high: float, low: float) -> Any:
    """Return the mpmath number high + low, not rounded; nan where one is no number."""
    if not (math.isfinite(high) and math.isfinite(low)):
        return mpmath.nan
    (above, at_above), (below, at_below) = _integer(high), _integer(low)
    lowest = min(at_above, at_below)
    return mpmath.mp.make_mpf(from_man_exp((above << at_above - lowest) + (below << at_below - lowest), lowest))


def _integer(x: float) -> tuple[int, int]:
    """Return integers n and k with x = n 2^k."""
    mantissa, exponent = math.frexp(x)
    return int(mantissa * 2.0**53), exponent - 53
