"""Double-double: numbers of 106 bits as unevaluated sums of two binary64 numbers (Dekker, Knuth).

With u = 2^-53 a sum is off by 3 u^2 of its value, a product by 5 u^2, a root by 4 u^2, a quotient by 10 u^2 or less
(Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", 2017).
In UNIT = 2 u^2 that is 1.5, 2.5, 2 and 5. Beyond 1e290 or below 1e-270 the error terms are not numbers any more: the
callers check the range. Compiled code has the same operators (compiled.py).
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

UNIT = 2.0**-105
"""What errors are counted in, relative to the result; the tests hold each function below so many of it.

Sums 1.5, roots 2, products 2.5, quotients 5 (proved, see above). Sine, cosine and arcus tangent 3, versine,
x - sin x 4, depth 8, x^2/2 - 1 + cos x 16: tested against balls, not proved. Sine and cosine are
off by |x| 2^-160 more, absolutely, as pi/2 has three parts: next to a zero that counts. The angle of a contact 32, its
depth 64.
"""


class TwoFloats(NamedTuple):
    """high + low, |low| at most half an ulp of high. Pairs are compared as tuples, which orders them right."""

    high: float
    low: float

    def __add__(self, other: Any) -> TwoFloats:
        """Return the sum with another, or with a float."""
        return add(self, as_pair(other))

    def __radd__(self, other: Any) -> TwoFloats:
        """Return other + self."""
        return self + other

    def __sub__(self, other: Any) -> TwoFloats:
        """Return the difference."""
        return add(self, -as_pair(other))

    def __rsub__(self, other: Any) -> TwoFloats:
        """Return other - self."""
        return as_pair(other) - self

    def __mul__(self, other: Any) -> TwoFloats:
        """Return the product; with a power of 2 it is exact."""
        return product(self, as_pair(other))

    def __rmul__(self, other: Any) -> TwoFloats:
        """Return other self."""
        return self * other

    def __truediv__(self, other: Any) -> TwoFloats:
        """Return the quotient."""
        by = as_pair(other)
        first = self.high / by.high
        back = times(by, first)
        return fast_two_sum(first, ((self.high - back.high) + (self.low - back.low)) / by.high)

    def __rtruediv__(self, other: Any) -> TwoFloats:
        """Return other / self."""
        return as_pair(other) / self

    def __neg__(self) -> TwoFloats:
        """Return the negative."""
        return TwoFloats(-self.high, -self.low)

    def __abs__(self) -> TwoFloats:
        """Return the absolute value."""
        return -self if self.high < 0.0 else self


def as_pair(x: Any) -> TwoFloats:
    """Return a pair, or a float as one."""
    return x if isinstance(x, TwoFloats) else TwoFloats(float(x), 0.0)


def nearest(value: Fraction, exponent: int = 0) -> TwoFloats:
    """Return the double-double number nearest to value 2^-exponent: its binary64 number, and that of what is left.

    Raises OverflowError beyond binary64.
    """
    n, d = value.numerator, value.denominator
    if exponent < 0:
        n <<= -exponent
    else:
        d <<= exponent
    high = n / d  # of whole numbers: rounded once, and faster than by fractions
    p, q = high.as_integer_ratio()
    return TwoFloats(high, (n * q - p * d) / (d * q))


def pair_of(numbers: Any) -> TwoFloats:
    """Return what stands in a row of two floats."""
    return TwoFloats(numbers[0], numbers[1])


def put(numbers: Any, pair: TwoFloats) -> None:
    """Write a pair as a row of two floats."""
    numbers[0], numbers[1] = pair.high, pair.low


def two_sum(a: float, b: float) -> TwoFloats:
    """Return a + b exactly."""
    total = a + b
    back = total - a
    return TwoFloats(total, (a - (total - back)) + (b - back))


def fast_two_sum(a: float, b: float) -> TwoFloats:
    """Return a + b exactly for |a| >= |b|."""
    total = a + b
    return TwoFloats(total, b - (total - a))


def two_product(a: float, b: float) -> TwoFloats:
    """Return a b exactly."""
    product = a * b
    scaled_a, scaled_b = 134217729.0 * a, 134217729.0 * b
    high_a, high_b = scaled_a - (scaled_a - a), scaled_b - (scaled_b - b)
    low_a, low_b = a - high_a, b - high_b
    return TwoFloats(product, ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b)


def add(a: TwoFloats, b: TwoFloats) -> TwoFloats:
    """Return a + b."""
    high, low = two_sum(a.high, b.high), two_sum(a.low, b.low)
    middle = fast_two_sum(high.high, high.low + low.high)
    return fast_two_sum(middle.high, middle.low + low.low)


def plus(a: TwoFloats, b: TwoFloats) -> TwoFloats:
    """Return a + b to 2^-104 of its terms, not of itself where they cancel: at half of what `add` costs."""
    total = two_sum(a.high, b.high)
    return fast_two_sum(total.high, total.low + (a.low + b.low))


def times(a: TwoFloats, b: float) -> TwoFloats:
    """Return a b for a binary64 number b."""
    product = two_product(a.high, b)
    return fast_two_sum(product.high, product.low + a.low * b)


def product(a: TwoFloats, b: TwoFloats) -> TwoFloats:
    """Return a b."""
    high = two_product(a.high, b.high)
    return fast_two_sum(high.high, high.low + (a.high * b.low + a.low * b.high))
