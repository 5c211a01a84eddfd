"""IEEE binary64, seen from Python: how its numbers are read and written."""

from __future__ import annotations

import math
from contextlib import AbstractContextManager, nullcontext
from fractions import Fraction

from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import OutOfRange
from numerics.scene.decimals import short

sqrt = math.sqrt


def midpoint(x: float) -> float:
    """Return x."""
    return x


def tolerance(_: float) -> float:
    """Return the relative step at which a search among floats ends."""
    return 2.0**-52


class Float64(Arithmetic):
    """Python floats: the fast arithmetic. What runs in it says by how much it may be off."""

    name = "float64"
    digits = 15

    def context(self) -> AbstractContextManager[object]:
        """Return a context that does nothing: binary64 needs none."""
        return nullcontext()

    @staticmethod
    def number(value: Fraction | int) -> float:
        """Return the binary64 number nearest to an exact rational; raises OutOfRange beyond its range."""
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isinf(number) or (number == 0 and value != 0):
            raise OutOfRange.of(f"a number, {short(Fraction(value))},", "float64")
        return number

    def to_float(self, x: float) -> float:
        """Return x."""
        return x

    def text(self, x: float, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return f"{x:.{digits}g}"
