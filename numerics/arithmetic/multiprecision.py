"""mpmath at any precision: a second, independent point arithmetic. Approximate; it encloses nothing."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from fractions import Fraction
from typing import Any

import mpmath
from mpmath.libmp import dps_to_prec

from numerics.arithmetic.precision import mpmath_precision
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.errors import OutOfRange

sqrt, atan2 = mpmath.sqrt, mpmath.atan2


def midpoint(x: Number) -> Number:
    """Return x."""
    return x


def as_float(x: Number) -> float:
    """Return the binary64 number nearest to x."""
    return float(x)


def two_pi(x: Number) -> Number:  # noqa: ARG001
    """Return 2 pi."""
    return 2 * mpmath.pi


def sine_cosine(x: Number) -> tuple[Number, Number]:
    """Return (sin x, cos x)."""
    cosine, sine = mpmath.cos_sin(x)
    return sine, cosine


def sine_deficit(x: Number) -> Number:
    """Return x - sin x, with the bits that cancel added to the working precision."""
    return _precisely(lambda: x - mpmath.sin(x), x)


def depth_and_cotangent(x: Number) -> tuple[Number, Number]:
    """Return 2 - x cot(x/2), with the bits that cancel added to the working precision, and cot(x/2)."""
    return _precisely(lambda: 2 - x * mpmath.cot(x / 2), x), mpmath.cot(x / 2)


def _precisely(function: Callable[[], Number], x: Any) -> Number:
    """Return a value with the bits added that cancel near 0, two for each one that |x| is below 1, and a guard."""
    cancelled = max(0, -int(mpmath.mag(x))) if x and mpmath.isfinite(x) else 0
    with mpmath_precision(mpmath.mp.prec + 2 * (cancelled + 8)):
        value = function()
    return +value


def sign(x: Number, question: str) -> int:  # noqa: ARG001
    """Return the sign of x; 0 for nan."""
    return (x > 0) - (x < 0)


def ceiling(x: Number, question: str) -> int:  # noqa: ARG001
    """Return the least whole number >= x, 0 for x <= 0."""
    return int(mpmath.ceil(x)) if x > 0 else 0


def require_phase(angle: Number) -> None:
    """Raise OutOfRange if the digits do not keep the phase of an angle > 0."""
    if not 0 < angle <= mpmath.mpf(10) ** (mpmath.mp.dps - 3):
        raise OutOfRange(
            f"one slip of this scene turns through an angle that {mpmath.mp.dps} digits of mpmath do not resolve; "
            'use arithmetic="ball"'
        )


def tolerance(x: Number) -> Number:  # noqa: ARG001
    """Return the relative step at which a search ends."""
    return mpmath.ldexp(1, 1 - mpmath.mp.prec)


class Multiprecision(Arithmetic):
    """mpmath numbers with `digits` working decimal digits, seen from Python."""

    name = "mpmath"
    to_float = staticmethod(as_float)

    def __init__(self, digits: int) -> None:
        """Fix the working precision in decimal digits."""
        self.digits = digits

    def context(self) -> AbstractContextManager[object]:
        """Return the context of this precision (precision.py)."""
        return mpmath_precision(dps_to_prec(self.digits))

    @staticmethod
    def number(value: Fraction | int) -> Any:
        """Return the number nearest to an exact rational."""
        return mpmath.mpf(value.numerator) / value.denominator

    def text(self, x: Any, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return str(mpmath.nstr(x, digits))
