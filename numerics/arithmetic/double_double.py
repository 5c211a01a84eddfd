"""Double-double: numbers of 106 bits as unevaluated sums of two binary64 numbers (Dekker, Knuth).

With u = 2^-53 a sum is off by 3 u^2 of its value, a product by 5 u^2, a root by 4 u^2, a quotient by 10 u^2 or less
(Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", 2017).
In UNIT = 2 u^2 (double_words.py) that is 1.5, 2.5, 2 and 5.
Beyond 1e290 or below 1e-270 the error terms are not numbers any more: the callers check the range.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, NamedTuple


class Double(NamedTuple):
    """high + low, |low| at most half an ulp of high; with the operators that texts use, also in compiled code."""

    high: float
    low: float

    def __add__(self, other: Any) -> Double:
        """Return the sum with another, or with a small whole number."""
        return add(self, other if isinstance(other, Double) else Double(float(other), 0.0))

    def __radd__(self, other: Any) -> Double:
        """Return other + self."""
        return add(Double(float(other), 0.0), self)

    def __sub__(self, other: Any) -> Double:
        """Return the difference."""
        return subtract(self, other if isinstance(other, Double) else Double(float(other), 0.0))

    def __rsub__(self, other: Any) -> Double:
        """Return other - self."""
        return subtract(Double(float(other), 0.0), self)

    def __mul__(self, other: Any) -> Double:
        """Return the product; with a power of 2 it is exact."""
        return product(self, other) if isinstance(other, Double) else times(self, float(other))

    def __rmul__(self, other: Any) -> Double:
        """Return other self."""
        return times(self, float(other))

    def __truediv__(self, other: Any) -> Double:
        """Return the quotient."""
        return divide(self, other if isinstance(other, Double) else Double(float(other), 0.0))

    def __rtruediv__(self, other: Any) -> Double:
        """Return other / self."""
        return divide(Double(float(other), 0.0), self)

    def __neg__(self) -> Double:
        """Return the negative."""
        return Double(-self.high, -self.low)


ZERO, ONE = Double(0.0, 0.0), Double(1.0, 0.0)


def nearest(value: Fraction) -> Double:
    """Return the double-double number nearest to a rational: its binary64 number, and that of what is left."""
    high = float(value)
    return Double(high, float(value - Fraction(high)))


def two_sum(a: float, b: float) -> Double:
    """Return a + b exactly."""
    total = a + b
    back = total - a
    return Double(total, (a - (total - back)) + (b - back))


def fast_two_sum(a: float, b: float) -> Double:
    """Return a + b exactly for |a| >= |b|."""
    total = a + b
    return Double(total, b - (total - a))


def two_product(a: float, b: float) -> Double:
    """Return a b exactly."""
    product = a * b
    scaled_a, scaled_b = 134217729.0 * a, 134217729.0 * b
    high_a, high_b = scaled_a - (scaled_a - a), scaled_b - (scaled_b - b)
    low_a, low_b = a - high_a, b - high_b
    return Double(product, ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b)


def add(a: Double, b: Double) -> Double:
    """Return a + b."""
    high, low = two_sum(a.high, b.high), two_sum(a.low, b.low)
    middle = fast_two_sum(high.high, high.low + low.high)
    return fast_two_sum(middle.high, middle.low + low.low)


def subtract(a: Double, b: Double) -> Double:
    """Return a - b."""
    return add(a, Double(-b.high, -b.low))


def negative(a: Double) -> Double:
    """Return -a."""
    return Double(-a.high, -a.low)


def scaled(a: Double, factor: float) -> Double:
    """Return a times a power of two (or 0, or -1): exact."""
    return Double(factor * a.high, factor * a.low)


def times(a: Double, b: float) -> Double:
    """Return a b for a binary64 number b."""
    product = two_product(a.high, b)
    return fast_two_sum(product.high, product.low + a.low * b)


def product(a: Double, b: Double) -> Double:
    """Return a b."""
    high = two_product(a.high, b.high)
    return fast_two_sum(high.high, high.low + (a.high * b.low + a.low * b.high))


def quotient(a: Double, b: Double) -> float:
    """Return a/b rounded to binary64."""
    first = a.high / b.high
    rest = add(a, times(b, -first))
    return first + rest.high / b.high


def divide(a: Double, b: Double) -> Double:
    """Return a/b."""
    first = a.high / b.high
    back = times(b, first)
    return fast_two_sum(first, ((a.high - back.high) + (a.low - back.low)) / b.high)


def square_root(a: Double) -> Double:
    """Return the square root of a >= 0."""
    if a.high == 0.0:
        return a
    root = math.sqrt(a.high)
    square = two_product(root, root)
    return fast_two_sum(root, (((a.high - square.high) - square.low) + a.low) / (2.0 * root))


def less(a: Double, b: Double) -> bool:
    """Return a < b; False where one is nan."""
    return a.high < b.high or (a.high == b.high and a.low < b.low)


def clock(total: Double, rest: Double, term: Double) -> tuple[Double, Double]:
    """Return total + rest + term, and what its rounding left out: so many sums are as accurate as one."""
    term = add(term, rest)
    new = add(total, term)
    return new, subtract(term, subtract(new, total))
