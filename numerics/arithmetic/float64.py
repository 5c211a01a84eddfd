"""IEEE binary64: the fast arithmetic. Approximate, each function to a few units in the last place (ulp).

What the texts import from here are its words (words.py): as they stand, the texts speak binary64.
"""

from __future__ import annotations

import math
import operator
from contextlib import AbstractContextManager, nullcontext
from fractions import Fraction
from typing import Any

from numerics.arithmetic import elementary
from numerics.arithmetic.double_compiled import declare_operators
from numerics.arithmetic.protocol import Number, Sign
from numerics.arithmetic.telling import Telling
from numerics.errors import OutOfRange

sqrt, exp, expm1, log, log1p, finite = math.sqrt, math.exp, math.expm1, math.log, math.log1p, math.isfinite
sin, atan2, versine, clock = math.sin, math.atan2, elementary.versine, elementary.clock
sine_deficit, cosine_deficit = elementary.sine_deficit, elementary.cosine_deficit
depth_and_cotangent = elementary.depth_and_cotangent
# words that do nothing, or one operation, are functions of C: interpreted texts call them by the dozen an event
exactly, signed, below, size = float, operator.mul, operator.lt, abs
rough = leading = part = middle = operator.pos
ZERO, UNIT, WIDTH = 0.0, 2.0**-53, 1
_SETTLED = math.sqrt(2.0**-53) / 4
LONGEST, SHORTEST = 1e12, 1e-97
"""Angles that binary64 resolves: beyond the first no phase is left, below the second the cube has no digits."""


def undefined() -> Number:
    """Return what stands for a number that left the range."""
    return math.nan


def infinite() -> Number:
    """Return infinity."""
    return math.inf


def turn() -> Number:
    """Return 2 pi."""
    return 2.0 * math.pi


def half_turn() -> Number:
    """Return pi."""
    return math.pi


def sine_cosine(x: Number) -> tuple[Number, Number]:
    """Return (sin x, cos x)."""
    return math.sin(x), math.cos(x)


def sign(x: Number, question: int) -> int:  # noqa: ARG001
    """Return the sign of x; 0 for nan."""
    return 1 if x > 0.0 else (-1 if x < 0.0 else 0)


def positive(x: Number) -> bool:
    """Return whether x > 0."""
    return x > 0.0


def tolerance() -> Number:
    """Return the relative step at which a search ends."""
    return 2.0**-53


def settled() -> Number:
    """Return the relative step after which Newton's next one is the last."""
    return _SETTLED


def fading() -> float:
    """Return after how many decay times an oscillation has died away below the last digit."""
    return 37.5


def resolved(angle: Number) -> bool:
    """Return whether 53 bits keep the phase of an angle > 0, and its cube has digits; False for nan."""
    return SHORTEST <= angle <= LONGEST


def ceiling(x: Number, question: int) -> int:  # noqa: ARG001
    """Return the least whole number >= x, 0 for x <= 0."""
    return math.ceil(x) if x > 0.0 else 0


def nonnegative(x: Number) -> Number:
    """Return max(x, 0)."""
    return max(x, 0.0)


def spread(x: Number) -> Number:  # noqa: ARG001
    """Return 0: points know no radius."""
    return 0.0


def widened(x: Number, by: Number) -> Number:  # noqa: ARG001
    """Return x: points know no radius."""
    return x


def put(row: Any, index: int, numbers: tuple[Number, ...]) -> None:
    """Write numbers to a row, from a column on."""
    for number in numbers:
        row[index] = number
        index += 1


FLOAT64 = Telling("float64", {}, {}, prepare=declare_operators)


class Float64:
    """Python floats, seen from Python: how they are read, decided and written."""

    name = "float64"
    digits = 15
    telling = FLOAT64
    sqrt = staticmethod(sqrt)

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
                'a number of this scene is beyond the range of float64 (1e-308 to 1e308); use arithmetic="ball"'
            )
        return number

    def sign(self, x: float) -> Sign:
        """Return the sign of x; raises OutOfRange for nan and infinities, which no decision may rest on."""
        if not math.isfinite(x):
            raise OutOfRange('a number of this scene left the range of float64 on the way; use arithmetic="ball"')
        return Sign((x > 0) - (x < 0))

    def to_float(self, x: float) -> float:
        """Return x."""
        return x

    def text(self, x: float, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return f"{x:.{digits}g}"
