"""IEEE binary64, seen from Python: how its numbers are read, decided and written. Its functions: elementary.py."""

from __future__ import annotations

import math
from contextlib import AbstractContextManager, nullcontext
from fractions import Fraction

from numerics.arithmetic.protocol import Sign
from numerics.errors import OutOfRange


class Float64:
    """Python floats: the fast arithmetic. Approximate, each function to a few units in the last place (ulp)."""

    name = "float64"
    digits = 15
    sqrt = staticmethod(math.sqrt)

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
            raise OutOfRange(
                "a number of this scene is beyond the range of float64 (1e-308 to 1e308); use ball arithmetic"
            )
        return number

    def sign(self, x: float) -> Sign:
        """Return the sign of x; raises OutOfRange for nan and infinities, which no decision may rest on."""
        if not math.isfinite(x):
            raise OutOfRange("a number of this scene left the range of float64 on the way; use ball arithmetic")
        return Sign((x > 0) - (x < 0))

    def to_float(self, x: float) -> float:
        """Return x."""
        return x

    def text(self, x: float, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return f"{x:.{digits}g}"
