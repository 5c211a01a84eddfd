"""mpmath at any precision: a second, independent point arithmetic. Approximate; it encloses nothing."""

from __future__ import annotations

import operator
import sys
from contextlib import AbstractContextManager
from fractions import Fraction
from typing import Any

import mpmath

from numerics.arithmetic import float64
from numerics.arithmetic.protocol import Number, Sign
from numerics.arithmetic.telling import Telling
from numerics.arithmetic.words import words_of

sqrt, exp, expm1, log, log1p = mpmath.sqrt, mpmath.exp, mpmath.expm1, mpmath.log, mpmath.log1p
sin, atan2, signed, positive = mpmath.sin, mpmath.atan2, float64.signed, float64.positive
leading = part = middle = operator.pos
put = float64.put
ZERO, UNIT, WIDTH = mpmath.mpf(0), 0.0, 1


def exactly(n: float) -> Number:
    """Return a small whole number, or a power of 2, as a number."""
    return mpmath.mpf(n)


def undefined() -> Number:
    """Return what stands for a number that left the range."""
    return mpmath.nan


def infinite() -> Number:
    """Return infinity."""
    return mpmath.inf


def turn() -> Number:
    """Return 2 pi."""
    return 2 * mpmath.pi


def half_turn() -> Number:
    """Return pi at the working precision."""
    return +mpmath.pi


def sine_cosine(x: Number) -> tuple[Number, Number]:
    """Return (sin x, cos x)."""
    cosine, sine = mpmath.cos_sin(x)
    return sine, cosine


def versine(x: Number) -> Number:
    """Return 1 - cos x as 2 sin^2(x/2)."""
    return 2 * mpmath.sin(x / 2) ** 2


def sine_deficit(x: Number) -> Number:
    """Return x - sin x, with the bits that cancel added to the working precision."""
    with mpmath.extraprec(2 * _cancelled_bits(x)):
        value = x - mpmath.sin(x)
    return +value


def cosine_deficit(x: Number) -> Number:
    """Return x^2/2 - 1 + cos x, with the bits that cancel added to the working precision."""
    with mpmath.extraprec(4 * _cancelled_bits(x)):
        value = x * x / 2 - 1 + mpmath.cos(x)
    return +value


def depth_and_cotangent(x: Number) -> tuple[Number, Number]:
    """Return 2 - x cot(x/2), with the bits that cancel added to the working precision, and cot(x/2)."""
    with mpmath.extraprec(2 * _cancelled_bits(x)):
        cotangent = mpmath.cot(x / 2)
        value = 2 - x * cotangent
    return +value, +cotangent


def _cancelled_bits(x: Any) -> int:
    """Return how many leading bits |x| falls short of 1, plus a guard."""
    return max(0, -int(mpmath.mag(x))) + 8 if x and mpmath.isfinite(x) else 8


def sign(x: Number, question: int) -> int:  # noqa: ARG001
    """Return the sign of x; 0 for nan."""
    return (x > 0) - (x < 0)


def below(x: Number, y: Number) -> bool:
    """Return whether x < y."""
    return bool(x < y)


def rough(x: Number) -> float:
    """Return the binary64 number nearest to x."""
    return float(x)


def size(x: Number) -> Number:
    """Return |x|."""
    return abs(x)


def tolerance() -> Number:
    """Return the relative step at which a search ends."""
    return mpmath.ldexp(1, 1 - mpmath.mp.prec)


def settled() -> Number:
    """Return the relative step after which Newton's next one is the last."""
    return mpmath.sqrt(tolerance()) / 4


def finite(x: Number) -> bool:
    """Return whether x is a number."""
    return bool(mpmath.isfinite(x))


def fading() -> float:
    """Return after how many decay times an oscillation has died away below the last digit."""
    return 2.5 * float(mpmath.mp.dps)


def resolved(angle: Number) -> bool:
    """Return whether the digits keep the phase of an angle > 0."""
    return bool(0 < angle <= mpmath.mpf(10) ** (mpmath.mp.dps - 3))


def ceiling(x: Number, question: int) -> int:  # noqa: ARG001
    """Return the least whole number >= x, 0 for x <= 0."""
    return int(mpmath.ceil(x)) if x > 0 else 0


def nonnegative(x: Number) -> Number:
    """Return max(x, 0)."""
    return max(x, ZERO)


def spread(x: Number) -> Number:  # noqa: ARG001
    """Return 0: points know no radius."""
    return ZERO


def widened(x: Number, by: Number) -> Number:  # noqa: ARG001
    """Return x: points know no radius."""
    return x


def clock(total: Number, rest: Number, term: Number) -> tuple[Number, Number]:
    """Return the sum; its rounding is small enough."""
    return total + term, rest


MPMATH = Telling("mpmath", words_of(sys.modules[__name__]), words_of(float64))


class Multiprecision:
    """mpmath numbers with `digits` working decimal digits, seen from Python."""

    name = "mpmath"
    telling = MPMATH
    sqrt = staticmethod(sqrt)

    def __init__(self, digits: int) -> None:
        """Fix the working precision in decimal digits."""
        self.digits = digits

    def context(self) -> AbstractContextManager[object]:
        """Return a context that sets mpmath's process-wide precision and restores it."""
        return mpmath.workdps(self.digits)

    @staticmethod
    def number(value: Fraction | int) -> Any:
        """Return the number nearest to an exact rational."""
        return mpmath.mpf(value.numerator) / value.denominator

    def sign(self, x: Any) -> Sign:
        """Return the sign of x; UNDECIDED for nan and infinities."""
        return Sign(int(mpmath.sign(x))) if mpmath.isfinite(x) else Sign.UNDECIDED

    def to_float(self, x: Any) -> float:
        """Return the binary64 number nearest to x."""
        return float(x)

    def text(self, x: Any, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return str(mpmath.nstr(x, digits))
