"""IEEE binary64: the fast arithmetic. Approximate, each function to a few units in the last place (ulp)."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from fractions import Fraction

from numerics.arithmetic.newton import bracketed_newton
from numerics.arithmetic.protocol import Contact, Sign
from numerics.errors import OutOfRange
from numerics.kernel import elementary
from numerics.kernel.contact import contact
from numerics.kernel.elementary import clock


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

    def log1p(self, x: float) -> float:
        """Return the natural logarithm of 1 + x."""
        return math.log1p(x)

    def cos_sin(self, x: float) -> tuple[float, float]:
        """Return (cos x, sin x)."""
        return math.cos(x), math.sin(x)

    def atan2(self, y: float, x: float) -> float:
        """Return the angle of the point (x, y)."""
        return math.atan2(y, x)

    def pi(self) -> float:
        """Return pi rounded to binary64."""
        return math.pi

    versine = staticmethod(elementary.versine)
    sine_deficit = staticmethod(elementary.sine_deficit)
    cosine_deficit = staticmethod(elementary.cosine_deficit)
    lag = staticmethod(elementary.lag)
    rise = staticmethod(elementary.rise)
    depth = staticmethod(elementary.depth)

    def root(
        self,
        function: Callable[[float], float],
        slope: Callable[[float], float],
        lower: float,
        upper: float,
        guess: float | None = None,  # noqa: ARG002
    ) -> float:
        """Return the root of a decreasing function, bracketed throughout, to the last bits."""
        return bracketed_newton(function, slope, lower, upper, tolerance=2.0**-53)

    def contact(self, gap: float, push: float) -> Contact:
        """Return the end of a slip from S, by the kernel that is also compiled."""
        return Contact(*contact(gap, push))

    def centre(self, x: float) -> float:
        """Return x."""
        return x

    def accumulate(self, total: float, rest: float, term: float) -> tuple[float, float]:
        """Return the sum and its rounding error, so that a long run's time is as good as a short one's."""
        return clock(total, rest, term)

    def mean_value(self, function: Callable[[float], float], slope: Callable[[float], float], x: float) -> float:  # noqa: ARG002
        """Return function(x): a point needs no mean value."""
        return function(x)

    def to_float(self, x: float) -> float:
        """Return x."""
        return x

    def text(self, x: float, digits: int = 6) -> str:
        """Return x with `digits` significant digits."""
        return f"{x:.{digits}g}"
