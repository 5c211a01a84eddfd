"""IEEE binary64: the fast arithmetic. Approximate, each function to a few units in the last place (ulp)."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from fractions import Fraction

from numerics.arithmetic.newton import bracketed_newton
from numerics.arithmetic.protocol import Sign
from numerics.errors import OutOfRange

# Below 2 the deficits are summed from their alternating series: 13 terms leave less than 2^29/29! < 2^-73 of the
# leading term. From 2 on the direct expression loses less than one bit, as the value is then > 1/2.
_SERIES_BELOW = 2.0
_SINE_TERMS = tuple((-1) ** k / math.factorial(2 * k + 3) for k in range(13))
_LAG_TERMS = tuple((-1) ** k * (2 * k + 2) / math.factorial(2 * k + 3) for k in range(13))
_COSINE_TERMS = tuple((-1) ** k / math.factorial(2 * k + 4) for k in range(13))


class Float64:
    """Python floats behind the Arithmetic protocol."""

    name = "float64"
    digits = 15

    def context(self) -> AbstractContextManager[object]:
        """Return a context that does nothing: binary64 needs none."""
        return nullcontext()

    def number(self, value: Fraction | int) -> float:
        """Return the binary64 number nearest to an exact rational; raises OutOfRange beyond its range."""
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isinf(number) or (number == 0 and value != 0):
            raise OutOfRange(
                "a number of this scene is beyond the range of float64 (1e-308 to 1e308); use --arithmetic ball"
            )
        return number

    def sign(self, x: float) -> Sign:
        """Return the sign of x; raises OutOfRange for nan and infinities, which no decision may rest on."""
        if not math.isfinite(x):
            raise OutOfRange("a number of this scene left the range of float64 on the way; use --arithmetic ball")
        return Sign((x > 0) - (x < 0))

    def ceiling(self, x: float) -> int | None:
        """Return the least integer >= x, None if x is not finite."""
        return math.ceil(x) if math.isfinite(x) else None

    def sqrt(self, x: float) -> float:
        """Return the square root, correctly rounded."""
        return math.sqrt(x)

    def exp(self, x: float) -> float:
        """Return e^x; raises OutOfRange on overflow."""
        try:
            return math.exp(x)
        except OverflowError:
            raise OutOfRange(f"exp({x:g}) is beyond the range of float64; use --arithmetic ball") from None

    def expm1(self, x: float) -> float:
        """Return e^x - 1 for x <= 0, where it cannot overflow."""
        return math.expm1(x)

    def log(self, x: float) -> float:
        """Return the natural logarithm."""
        return math.log(x)

    def cos_sin(self, x: float) -> tuple[float, float]:
        """Return (cos x, sin x)."""
        return math.cos(x), math.sin(x)

    def atan2(self, y: float, x: float) -> float:
        """Return the angle of the point (x, y)."""
        return math.atan2(y, x)

    def pi(self) -> float:
        """Return pi rounded to binary64."""
        return math.pi

    def versine(self, x: float) -> float:
        """Return 1 - cos x as 2 sin^2(x/2), which does not cancel."""
        half = math.sin(0.5 * x)
        return 2.0 * half * half

    def sine_deficit(self, x: float) -> float:
        """Return x - sin x; by its series for |x| < 2."""
        if abs(x) >= _SERIES_BELOW:
            return x - math.sin(x)
        return x * x * x * _horner(_SINE_TERMS, x * x)

    def cosine_deficit(self, x: float) -> float:
        """Return x^2/2 - 1 + cos x; by its series for |x| < 2."""
        square = x * x
        if abs(x) >= _SERIES_BELOW:
            return (0.5 * square - 1.0) + math.cos(x)
        return square * square * _horner(_COSINE_TERMS, square)

    def lag(self, x: float) -> float:
        """Return sin x - x cos x; by its series for |x| < 2."""
        if abs(x) >= _SERIES_BELOW:
            return math.sin(x) - x * math.cos(x)
        return x * x * x * _horner(_LAG_TERMS, x * x)

    def root(
        self, function: Callable[[float], float], slope: Callable[[float], float], lower: float, upper: float
    ) -> float:
        """Return the root of a decreasing function, bracketed throughout, to the last bits."""
        return bracketed_newton(function, slope, lower, upper, tolerance=2.0**-53)

    def mean_value(self, function: Callable[[float], float], slope: Callable[[float], float], x: float) -> float:  # noqa: ARG002
        """Return function(x): a point needs no mean value."""
        return function(x)

    def to_float(self, x: float) -> float:
        """Return x."""
        return x

    def text(self, x: float, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return f"{x:.{digits}g}"


def _horner(coefficients: tuple[float, ...], x: float) -> float:
    total = 0.0
    for coefficient in reversed(coefficients):
        total = total * x + coefficient
    return total
