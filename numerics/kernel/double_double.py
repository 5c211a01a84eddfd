"""Numbers of 106 bits as unevaluated sums of two binary64 numbers (Dekker, Knuth): to convert scenes without loss.

A sum or product is off by a few 2^-104 of its terms. Beyond 1e290 or below 1e-290 the error terms are not numbers any
more: the callers check the range.
"""

from __future__ import annotations

from typing import NamedTuple

from numerics.kernel.compilation import kernel


class Double(NamedTuple):
    """high + low, |low| at most half an ulp of high."""

    high: float
    low: float


@kernel
def two_sum(a: float, b: float) -> Double:
    """Return a + b exactly."""
    total = a + b
    back = total - a
    return Double(total, (a - (total - back)) + (b - back))


@kernel
def two_product(a: float, b: float) -> Double:
    """Return a b exactly."""
    product = a * b
    scaled_a, scaled_b = 134217729.0 * a, 134217729.0 * b
    high_a, high_b = scaled_a - (scaled_a - a), scaled_b - (scaled_b - b)
    low_a, low_b = a - high_a, b - high_b
    return Double(product, ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b)


@kernel
def add(a: Double, b: Double) -> Double:
    """Return a + b."""
    high, low = two_sum(a.high, b.high), two_sum(a.low, b.low)
    middle = two_sum(high.high, high.low + low.high)
    return two_sum(middle.high, middle.low + low.low)


@kernel
def times(a: Double, b: float) -> Double:
    """Return a b for a binary64 number b."""
    product = two_product(a.high, b)
    return two_sum(product.high, product.low + a.low * b)


@kernel
def product(a: Double, b: Double) -> Double:
    """Return a b."""
    high = two_product(a.high, b.high)
    return two_sum(high.high, high.low + (a.high * b.low + a.low * b.high))


@kernel
def quotient(a: Double, b: Double) -> float:
    """Return a/b rounded to binary64."""
    first = a.high / b.high
    rest = add(a, times(b, -first))
    return first + rest.high / b.high
