"""Double-double, seen from Python: runs have pairs of floats, what reads them the mpmath numbers they are."""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.pair import TwoFloats, two_sum
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
    def halves(x: Any) -> TwoFloats:
        """Return a number as its binary64 number and that of the rest, in this context; raises OutOfRange."""
        high = float(x)
        if x != 0 and not SMALLEST < abs(high) < LARGEST:
            raise OutOfRange.of(f"a number, {high:g},", "double-double", SMALLEST, LARGEST)
        return two_sum(high, float(x - high))
