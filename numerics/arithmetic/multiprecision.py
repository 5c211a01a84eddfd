"""mpmath at any precision: a second, independent point arithmetic. Approximate; it encloses nothing."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from fractions import Fraction
from typing import Any

import mpmath

from numerics.arithmetic.newton import bracketed_newton
from numerics.arithmetic.protocol import Contact, Sign
from numerics.arithmetic.slip_contact import contact_by_root


class Multiprecision:
    """mpmath numbers with `digits` working decimal digits, behind the Arithmetic protocol."""

    name = "mpmath"

    def __init__(self, digits: int) -> None:
        """Fix the working precision in decimal digits."""
        self.digits = digits

    def context(self) -> AbstractContextManager[object]:
        """Return a context that sets mpmath's process-wide precision and restores it."""
        return mpmath.workdps(self.digits)

    def number(self, value: Fraction | int) -> Any:
        """Return the number nearest to an exact rational."""
        return mpmath.mpf(value.numerator) / value.denominator

    def sign(self, x: Any) -> Sign:
        """Return the sign of x; UNDECIDED for nan and infinities."""
        return Sign(int(mpmath.sign(x))) if mpmath.isfinite(x) else Sign.UNDECIDED

    def ceiling(self, x: Any) -> int | None:
        """Return the least integer >= x, None if x is not finite."""
        return int(mpmath.ceil(x)) if mpmath.isfinite(x) else None

    def sqrt(self, x: Any) -> Any:
        """Return the square root."""
        return mpmath.sqrt(x)

    def exp(self, x: Any) -> Any:
        """Return e^x."""
        return mpmath.exp(x)

    def expm1(self, x: Any) -> Any:
        """Return e^x - 1."""
        return mpmath.expm1(x)

    def log(self, x: Any) -> Any:
        """Return the natural logarithm."""
        return mpmath.log(x)

    def log1p(self, x: Any) -> Any:
        """Return the natural logarithm of 1 + x."""
        return mpmath.log1p(x)

    def cos_sin(self, x: Any) -> tuple[Any, Any]:
        """Return (cos x, sin x)."""
        return mpmath.cos_sin(x)

    def atan2(self, y: Any, x: Any) -> Any:
        """Return the angle of the point (x, y)."""
        return mpmath.atan2(y, x)

    def pi(self) -> Any:
        """Return pi at the working precision."""
        return +mpmath.pi

    def versine(self, x: Any) -> Any:
        """Return 1 - cos x as 2 sin^2(x/2)."""
        return 2 * mpmath.sin(x / 2) ** 2

    def sine_deficit(self, x: Any) -> Any:
        """Return x - sin x, with the bits that cancel added to the working precision."""
        with mpmath.extraprec(2 * _cancelled_bits(x)):
            value = x - mpmath.sin(x)
        return +value

    def cosine_deficit(self, x: Any) -> Any:
        """Return x^2/2 - 1 + cos x, with the bits that cancel added to the working precision."""
        with mpmath.extraprec(4 * _cancelled_bits(x)):
            value = x * x / 2 - 1 + mpmath.cos(x)
        return +value

    def lag(self, x: Any) -> Any:
        """Return sin x - x cos x, with the bits that cancel added to the working precision."""
        with mpmath.extraprec(2 * _cancelled_bits(x)):
            cosine, sine = mpmath.cos_sin(x)
            value = sine - x * cosine
        return +value

    def rise(self, x: Any) -> Any:
        """Return (x - sin x)/(1 - cos x)."""
        return self.sine_deficit(x) / self.versine(x)

    def depth(self, x: Any) -> Any:
        """Return 2 - x cot(x/2) as 2 (sin - y cos)/sin at y = x/2."""
        return 2 * self.lag(x / 2) / mpmath.sin(x / 2)

    def root(
        self,
        function: Callable[[Any], Any],
        slope: Callable[[Any], Any],
        lower: Any,
        upper: Any,
        guess: float | None = None,  # noqa: ARG002
    ) -> Any:
        """Return the root of a decreasing function, bracketed throughout."""
        return bracketed_newton(function, slope, lower, upper, tolerance=mpmath.ldexp(1, 1 - mpmath.mp.prec))

    def contact(self, gap: Any, push: Any) -> Contact:
        """Return the end of a slip from S, by `root`."""
        return contact_by_root(self, gap, push)

    def centre(self, x: Any) -> Any:
        """Return x."""
        return x

    def accumulate(self, total: Any, rest: Any, term: Any) -> tuple[Any, Any]:
        """Return the sum; its rounding is small enough."""
        return total + term, rest

    def mean_value(self, function: Callable[[Any], Any], slope: Callable[[Any], Any], x: Any) -> Any:  # noqa: ARG002
        """Return function(x): a point needs no mean value."""
        return function(x)

    def to_float(self, x: Any) -> float:
        """Return the binary64 number nearest to x."""
        return float(x)

    def text(self, x: Any, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return str(mpmath.nstr(x, digits))


def _cancelled_bits(x: Any) -> int:
    """Return how many leading bits |x| falls short of 1, plus a guard."""
    return max(0, -int(mpmath.mag(x))) + 8 if x != 0 else 8
