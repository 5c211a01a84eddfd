"""A number as the unevaluated sum of two floats (Dekker, Knuth): what a rounding left out is kept beside the result.

For times, phases and powers of exp(A h), whose roundings would add up over a long run. With u = 2^-53 a product is off
by 5 u^2, a quotient by 10 u^2 or less (Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building
blocks of double-word arithmetic", 2017). Beyond 1e290 or below 1e-270 the second part is no number any more.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from numerics.arithmetic.compiled import compilable


class TwoFloats(NamedTuple):
    """high + low, |low| at most half an ulp of high."""

    high: float
    low: float


def nearest(value: Fraction, exponent: int = 0) -> TwoFloats:
    """Return the pair nearest to value 2^-exponent: its binary64 number, and that of what is left.

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


@compilable
def pair_of(numbers: Any) -> TwoFloats:
    """Return what stands in a row of two floats."""
    return TwoFloats(numbers[0], numbers[1])


@compilable
def put(numbers: Any, pair: TwoFloats) -> None:
    """Write a pair as a row of two floats."""
    numbers[0], numbers[1] = pair.high, pair.low


@compilable
def two_sum(a: float, b: float) -> TwoFloats:
    """Return a + b exactly."""
    total = a + b
    back = total - a
    return TwoFloats(total, (a - (total - back)) + (b - back))


@compilable
def fast_two_sum(a: float, b: float) -> TwoFloats:
    """Return a + b exactly for |a| >= |b|."""
    total = a + b
    return TwoFloats(total, b - (total - a))


@compilable
def two_product(a: float, b: float) -> TwoFloats:
    """Return a b exactly."""
    product = a * b
    scaled_a, scaled_b = 134217729.0 * a, 134217729.0 * b
    high_a, high_b = scaled_a - (scaled_a - a), scaled_b - (scaled_b - b)
    low_a, low_b = a - high_a, b - high_b
    return TwoFloats(product, ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b)


@compilable
def plus(a: TwoFloats, b: TwoFloats) -> TwoFloats:
    """Return a + b to 2^-104 of its terms, not of itself where they cancel."""
    total = two_sum(a.high, b.high)
    return fast_two_sum(total.high, total.low + (a.low + b.low))


@compilable
def times(a: TwoFloats, b: float) -> TwoFloats:
    """Return a b for a binary64 number b."""
    product = two_product(a.high, b)
    return fast_two_sum(product.high, product.low + a.low * b)


@compilable
def product(a: TwoFloats, b: TwoFloats) -> TwoFloats:
    """Return a b."""
    high = two_product(a.high, b.high)
    return fast_two_sum(high.high, high.low + (a.high * b.low + a.low * b.high))


@compilable
def quotient(a: TwoFloats, by: TwoFloats) -> TwoFloats:
    """Return a/by."""
    first = a.high / by.high
    back = times(by, first)
    return fast_two_sum(first, ((a.high - back.high) + (a.low - back.low)) / by.high)
