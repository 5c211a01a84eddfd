"""The functions of double-double numbers (functions.py), those that would cancel next to 0 among them.

How accurate each is says pair.UNIT: the tests compare with balls.
Sums of series are run from their small end; terms that weigh less than 2^-53 of the first need binary64 only.
"""

from __future__ import annotations

import math
from fractions import Fraction

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.elementary import DEPTH_SERIES, horner
from numerics.arithmetic.pair import (
    TwoFloats,
    fast_two_sum,
    nearest,
    product,
    two_product,
    two_sum,
)

LONGEST, SHORTEST = 1e14, 1e-60
"""Angles that double-double resolves: beyond them no phase is left, or the error of a fourth power is lost."""
_Series = tuple[tuple[tuple[float, float], ...], tuple[float, ...]]
_PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534")
_TURN = nearest(2 * _PI)
_QUARTER_1, _QUARTER_2 = nearest(_PI / 2)
_QUARTER_3 = float(_PI / 2 - Fraction(_QUARTER_1) - Fraction(_QUARTER_2))
_PER_QUARTER = float(2 / _PI)
_LARGEST = 1e15
"""Next to 1e15 the product with 2/pi, rounded, may be off by an eighth of a quarter turn."""
_CELLS = 16.0
_SERIES_BELOW, _DEPTH_SERIES_BELOW = 1.2, 1.5


def _exact_sine_and_cosine(x: Fraction) -> tuple[Fraction, Fraction]:
    """Return sin x and cos x of a rational |x| < 1.1 to 2^-130."""
    powers = [x**k / math.factorial(k) for k in range(36)]
    sine = sum((-1) ** k * term for k, term in enumerate(powers[1::2]))
    return Fraction(sine), Fraction(sum((-1) ** k * term for k, term in enumerate(powers[0::2])))


_TABLE = tuple(
    tuple(half for value in _exact_sine_and_cosine(Fraction(k, 16)) for half in nearest(value)) for k in range(18)
)
"""sin(k/16) and cos(k/16), each as high and low: up to pi/4, and some more."""


def _split(terms: list[Fraction], precise: int) -> _Series:
    """Return the first `precise` terms in double-double, the others in binary64; highest power first."""
    exact = tuple((high, low) for high, low in map(nearest, reversed(terms[:precise])))
    return exact, tuple(float(term) for term in reversed(terms[precise:]))


def _alternating(first: int, count: int, precise: int) -> _Series:
    """Return `count` terms (-1)^k/(first + 2 k)! of a series in x^2."""
    return _split([Fraction((-1) ** k, math.factorial(first + 2 * k)) for k in range(count)], precise)


# For |t| <= 1/32 the terms from t^8 on weigh less than 2^-53
_SMALL_SINE = _alternating(3, 7, 3)
_SMALL_VERSINE = _alternating(2, 7, 3)
# x - sin x = x^3 sum for |x| < 1.2
_SINE = _alternating(3, 16, 9)
# 2 - x cot(x/2) = x^2 sum, of convergence radius 2 pi
_DEPTH = _split(DEPTH_SERIES[:27], 14)


@compilable
def _polynomial(series: _Series, x: TwoFloats) -> TwoFloats:
    """Return the sum of a series of which each term outweighs those of higher powers."""
    total = TwoFloats(horner(series[1], x.high), 0.0)
    for high, low in series[0]:
        further = product(total, x)
        top = two_sum(high, further.high)
        total = fast_two_sum(top.high, top.low + (low + further.low))
    return total


@compilable
def two_pi(x: TwoFloats) -> TwoFloats:  # noqa: ARG001
    """Return 2 pi."""
    return _TURN


@compilable
def sine_cosine(x: TwoFloats) -> tuple[TwoFloats, TwoFloats]:
    """Return (sin x, cos x) for |x| < 1e15, nan beyond; next to 0 the sine is accurate relative to itself."""
    if not abs(x.high) < _LARGEST:
        return TwoFloats(math.nan, 0.0), TwoFloats(math.nan, 0.0)
    quarters = 0.0
    if abs(x.high) > 0.7853981633974483:
        quarters = float(math.floor(x.high * _PER_QUARTER + 0.5))
        x = x - two_product(quarters, _QUARTER_1) - two_product(quarters, _QUARTER_2)
        x = x - two_product(quarters, _QUARTER_3)
    sine, cosine = _near_zero(x)
    quadrant = int(quarters - 4.0 * math.floor(0.25 * quarters))
    if quadrant == 1:
        return cosine, -sine
    if quadrant == 2:
        return -sine, -cosine
    if quadrant == 3:
        return -cosine, sine
    return sine, cosine


@compilable
def _near_zero(x: TwoFloats) -> tuple[TwoFloats, TwoFloats]:
    """Return (sin x, cos x) for |x| <= pi/4: those of the nearest c = k/16, turned by t = x - c."""
    cell = math.floor(x.high * _CELLS + 0.5)
    t = x + TwoFloats(-cell / _CELLS, 0.0)
    square = t * t
    sine_t = t - t * square * _polynomial(_SMALL_SINE, square)
    versine_t = square * _polynomial(_SMALL_VERSINE, square)
    if cell == 0:
        return sine_t, TwoFloats(1.0, 0.0) - versine_t
    sine_high, sine_low, cosine_high, cosine_low = _TABLE[abs(int(cell))]
    sign = 1.0 if cell > 0 else -1.0
    sine_c, cosine_c = TwoFloats(sign * sine_high, sign * sine_low), TwoFloats(cosine_high, cosine_low)
    sine = sine_c + (cosine_c * sine_t - sine_c * versine_t)
    return sine, cosine_c - (sine_c * sine_t + cosine_c * versine_t)


@compilable
def atan2(y: TwoFloats, x: TwoFloats) -> TwoFloats:
    """Return the angle of the point (x, y): that of binary64, turned back by it and read off once more."""
    angle = math.atan2(y.high, x.high)
    sine, cosine = sine_cosine(TwoFloats(angle, 0.0))
    across = y * cosine - x * sine
    along = x.high * cosine.high + y.high * sine.high
    return two_sum(angle, across.high / along) if along > 0.0 else TwoFloats(angle, 0.0)


@compilable
def sine_deficit(x: TwoFloats) -> TwoFloats:
    """Return x - sin x; by its series for |x| < 1.2."""
    if abs(x.high) >= _SERIES_BELOW:
        return x - sine_cosine(x)[0]
    square = x * x
    return square * x * _polynomial(_SINE, square)


@compilable
def depth_and_cotangent(x: TwoFloats) -> tuple[TwoFloats, TwoFloats]:
    """Return c = 2 - x cot(x/2) for 0 < x <= 2 pi - 1, and cot(x/2) = (2 - c)/x; by the series of c for x < 1.5."""
    if x.high < _DEPTH_SERIES_BELOW:
        square = x * x
        depth = square * _polynomial(_DEPTH, square)
        return depth, (TwoFloats(2.0, 0.0) - depth) / x
    sine, cosine = sine_cosine(x * 0.5)
    cotangent = cosine / sine
    return TwoFloats(2.0, 0.0) - x * cotangent, cotangent


@compilable
def sqrt(a: TwoFloats) -> TwoFloats:
    """Return the square root of a >= 0."""
    if a.high == 0.0:
        return a
    root = math.sqrt(a.high)
    square = two_product(root, root)
    return fast_two_sum(root, (((a.high - square.high) - square.low) + a.low) / (2.0 * root))


@compilable
def like(x: TwoFloats, value: float) -> TwoFloats:  # noqa: ARG001
    """Return a float as a pair."""
    return TwoFloats(value, 0.0)


@compilable
def as_float(x: TwoFloats) -> float:
    """Return the nearest float."""
    return x.high


@compilable
def sign(x: TwoFloats, question: int) -> int:  # noqa: ARG001
    """Return the sign of x, which is that of its high part; 0 for nan."""
    return 1 if x.high > 0.0 else (-1 if x.high < 0.0 else 0)


@compilable
def finite(x: TwoFloats) -> bool:
    """Return whether x is a number."""
    return math.isfinite(x.high)


@compilable
def resolved(angle: TwoFloats) -> bool:
    """Return whether 106 bits keep the phase of an angle > 0, and its fourth power has digits; False for nan."""
    return SHORTEST <= angle.high <= LONGEST


@compilable
def ceiling(x: TwoFloats, question: int) -> int:  # noqa: ARG001
    """Return the least whole number >= x, 0 for x <= 0."""
    if not x.high > 0.0:
        return 0
    whole = math.ceil(x.high)
    return whole + 1 if float(whole) == x.high and x.low > 0.0 else whole


@compilable
def tolerance(x: TwoFloats) -> TwoFloats:  # noqa: ARG001
    """Return the relative step at which a search ends."""
    return TwoFloats(2.0**-104, 0.0)


@compilable
def clock(total: TwoFloats, rest: TwoFloats, term: TwoFloats) -> tuple[TwoFloats, TwoFloats]:
    """Return total + rest + term, and what its rounding left out: so many sums are as accurate as one."""
    term = term + rest
    new = total + term
    return new, term - (new - total)
