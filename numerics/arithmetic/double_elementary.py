"""Sine, cosine, arcus tangent and the functions that would cancel next to 0, in double-double.

How accurate each is says double_words.UNIT: the tests compare with balls.
Sums of series are run from their small end; terms that weigh less than 2^-53 of the first need binary64 only.
"""

from __future__ import annotations

import math
from fractions import Fraction

from numerics.arithmetic.double_double import (
    ONE,
    Double,
    add,
    divide,
    fast_two_sum,
    nearest,
    product,
    scaled,
    subtract,
    two_product,
    two_sum,
)
from numerics.arithmetic.elementary import DEPTH_SERIES, horner

_Terms = tuple[tuple[float, float], ...]
_PI_EXACT = Fraction("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534")
TURN, PI = nearest(2 * _PI_EXACT), nearest(_PI_EXACT)
_QUARTER = nearest(_PI_EXACT / 2)
_QUARTER_1, _QUARTER_2 = _QUARTER
_QUARTER_3 = float(_PI_EXACT / 2 - Fraction(_QUARTER_1) - Fraction(_QUARTER_2))
_PER_QUARTER = float(2 / _PI_EXACT)
_LARGEST = 1e15
_CELLS = 16.0
"""The table below has the sines and cosines of multiples of 1/16 up to pi/4, and some more.

Next to 1e15 the product with 2/pi, rounded, may be off by an eighth of a quarter turn.
"""
_SERIES_BELOW, _COSINE_SERIES_BELOW, _DEPTH_SERIES_BELOW = 1.2, 2.0, 1.5


def _exact_sine_and_cosine(x: Fraction) -> tuple[Fraction, Fraction]:
    """Return sin x and cos x of a rational |x| < 1 to 2^-150."""
    powers = [x**k / math.factorial(k) for k in range(36)]
    sine = sum((-1) ** k * term for k, term in enumerate(powers[1::2]))
    return Fraction(sine), Fraction(sum((-1) ** k * term for k, term in enumerate(powers[0::2])))


_TABLE = tuple(
    tuple(number for value in _exact_sine_and_cosine(Fraction(k, 16)) for number in nearest(value)) for k in range(18)
)
"""sin(k/16) and cos(k/16), each as high and low."""


def series_split(terms: list[Fraction], precise: int) -> tuple[_Terms, tuple[float, ...]]:
    """Return the first `precise` terms in double-double, the others in binary64; highest power first."""
    exact = tuple(tuple(nearest(term)) for term in reversed(terms[:precise]))
    return exact, tuple(float(term) for term in reversed(terms[precise:]))  # type: ignore[return-value]


def _alternating(numerators: list[int], first: int) -> list[Fraction]:
    """Return (-1)^k numerator_k/(first + 2 k)! of a series in x^2."""
    return [Fraction((-1) ** k * n, math.factorial(first + 2 * k)) for k, n in enumerate(numerators)]


# For |t| <= 1/32 the terms from t^8 on weigh less than 2^-53
_SMALL_SINE, _SMALL_SINE_TAIL = series_split(_alternating([1] * 7, 3), 3)
_SMALL_VERSINE, _SMALL_VERSINE_TAIL = series_split(_alternating([1] * 7, 2), 3)
# x - sin x = x^3 sum for |x| < 1.2; x^2/2 - 1 + cos x = x^4 sum for |x| < 2
_SINE, _SINE_TAIL = series_split(_alternating([1] * 16, 3), 9)
_COSINE, _COSINE_TAIL = series_split(_alternating([1] * 18, 4), 11)
# 2 - x cot(x/2) = x^2 sum, of convergence radius 2 pi
_DEPTH_BELOW_1_5, _DEPTH_TAIL_BELOW_1_5 = series_split(DEPTH_SERIES[:27], 14)
_DEPTH_BELOW_1, _DEPTH_TAIL_BELOW_1 = series_split(DEPTH_SERIES[:21], 11)
_DEPTH_NEAR_0, _DEPTH_TAIL_NEAR_0 = series_split(DEPTH_SERIES[:12], 7)


def polynomial(precise: _Terms, tail: tuple[float, ...], x: Double) -> Double:
    """Return precise + x^n tail for polynomials of which each term outweighs those of higher powers."""
    total = Double(horner(tail, x.high), 0.0)
    for high, low in precise:
        further = product(total, x)
        top = two_sum(high, further.high)
        total = fast_two_sum(top.high, top.low + (low + further.low))
    return total


def sine_cosine(x: Double) -> tuple[Double, Double]:
    """Return (sin x, cos x) for |x| < 1e15, nan beyond; next to 0 the sine is accurate relative to itself."""
    if not abs(x.high) < _LARGEST:
        return Double(math.nan, 0.0), Double(math.nan, 0.0)
    quarters = 0.0
    if abs(x.high) > 0.7853981633974483:
        quarters = float(math.floor(x.high * _PER_QUARTER + 0.5))
        x = subtract(subtract(x, two_product(quarters, _QUARTER_1)), two_product(quarters, _QUARTER_2))
        x = subtract(x, two_product(quarters, _QUARTER_3))
    sine, cosine = _near_zero(x)
    quadrant = int(quarters - 4.0 * math.floor(0.25 * quarters))
    if quadrant == 1:
        return cosine, scaled(sine, -1.0)
    if quadrant == 2:
        return scaled(sine, -1.0), scaled(cosine, -1.0)
    if quadrant == 3:
        return scaled(cosine, -1.0), sine
    return sine, cosine


def _near_zero(x: Double) -> tuple[Double, Double]:
    """Return (sin x, cos x) for |x| <= pi/4: those of the nearest c = k/16, turned by t = x - c."""
    cell = math.floor(x.high * _CELLS + 0.5)
    t = add(x, Double(-cell / _CELLS, 0.0))
    square = product(t, t)
    sine_t = subtract(t, product(product(t, square), polynomial(_SMALL_SINE, _SMALL_SINE_TAIL, square)))
    versine_t = product(square, polynomial(_SMALL_VERSINE, _SMALL_VERSINE_TAIL, square))
    if cell == 0:
        return sine_t, subtract(ONE, versine_t)
    sine_high, sine_low, cosine_high, cosine_low = _TABLE[abs(int(cell))]
    sign = 1.0 if cell > 0 else -1.0
    sine_c, cosine_c = Double(sign * sine_high, sign * sine_low), Double(cosine_high, cosine_low)
    sine = add(sine_c, subtract(product(cosine_c, sine_t), product(sine_c, versine_t)))
    return sine, subtract(cosine_c, add(product(sine_c, sine_t), product(cosine_c, versine_t)))


def arctangent(y: Double, x: Double) -> Double:
    """Return the angle of the point (x, y): that of binary64, turned back by it and read off once more."""
    angle = math.atan2(y.high, x.high)
    sine, cosine = sine_cosine(Double(angle, 0.0))
    across = subtract(product(y, cosine), product(x, sine))
    along = x.high * cosine.high + y.high * sine.high
    return two_sum(angle, across.high / along) if along > 0.0 else Double(angle, 0.0)


def versine(x: Double) -> Double:
    """Return 1 - cos x = 2 sin^2(x/2)."""
    sine, _ = sine_cosine(scaled(x, 0.5))
    return scaled(product(sine, sine), 2.0)


def sine_deficit(x: Double) -> Double:
    """Return x - sin x; by its series for |x| < 1.2."""
    if abs(x.high) >= _SERIES_BELOW:
        sine, _ = sine_cosine(x)
        return subtract(x, sine)
    square = product(x, x)
    return product(product(square, x), polynomial(_SINE, _SINE_TAIL, square))


def cosine_deficit(x: Double) -> Double:
    """Return x^2/2 - 1 + cos x; by its series for |x| < 2."""
    square = product(x, x)
    if abs(x.high) >= _COSINE_SERIES_BELOW:
        return subtract(scaled(square, 0.5), versine(x))
    return product(product(square, square), polynomial(_COSINE, _COSINE_TAIL, square))


def depth_and_cotangent(x: Double) -> tuple[Double, Double]:
    """Return c = 2 - x cot(x/2) for 0 < x <= 2 pi - 1, and cot(x/2) = (2 - c)/x; by the series of c for x < 1.5."""
    square = product(x, x)
    if x.high < 0.25:
        depth = product(square, polynomial(_DEPTH_NEAR_0, _DEPTH_TAIL_NEAR_0, square))
    elif x.high < 1.0:
        depth = product(square, polynomial(_DEPTH_BELOW_1, _DEPTH_TAIL_BELOW_1, square))
    elif x.high < _DEPTH_SERIES_BELOW:
        depth = product(square, polynomial(_DEPTH_BELOW_1_5, _DEPTH_TAIL_BELOW_1_5, square))
    else:
        sine, cosine = sine_cosine(scaled(x, 0.5))
        cotangent = divide(cosine, sine)
        return subtract(Double(2.0, 0.0), product(x, cotangent)), cotangent
    return depth, divide(subtract(Double(2.0, 0.0), depth), x)
