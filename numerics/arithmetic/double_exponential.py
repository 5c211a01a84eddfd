"""Exponentials and logarithms in double-double; how accurate they are says double_words.UNIT."""

from __future__ import annotations

import math
from fractions import Fraction

from numerics.arithmetic.double_double import ONE, Double, add, divide, nearest, product, scaled, subtract, two_product
from numerics.arithmetic.double_elementary import polynomial, series_split

_LN2 = Fraction("0.693147180559945309417232121458176568075500134360255254120680009493393621969694715605863326996418687")
_LN2_1, _LN2_2 = nearest(_LN2)
_LN2_3 = float(_LN2 - Fraction(_LN2_1) - Fraction(_LN2_2))
_SMALL = 0.34657359027997264
"""ln(2)/2: the exponent that is left after whole powers of 2, and the largest argument of the series."""
_SERIES, _TAIL = series_split([Fraction(1, math.factorial(k)) for k in range(1, 25)], 17)
"""(e^x - 1)/x, of which the terms from x^17 on weigh less than 2^-53 of the first."""
_LARGEST = 700.0


def expm1(x: Double) -> Double:
    """Return e^x - 1: by its series next to 0."""
    if abs(x.high) <= _SMALL:
        return product(x, polynomial(_SERIES, _TAIL, x))
    return subtract(exp(x), ONE)


def exp(x: Double) -> Double:
    """Return e^x; 0 below -700, where the halves would not be numbers any more, inf above 700."""
    if not abs(x.high) <= _LARGEST:
        return Double(math.inf if x.high > 0.0 else (0.0 if x.high < 0.0 else math.nan), 0.0)
    powers = float(math.floor(x.high / _LN2_1 + 0.5))
    rest = subtract(subtract(x, two_product(powers, _LN2_1)), two_product(powers, _LN2_2))
    rest = subtract(rest, Double(powers * _LN2_3, 0.0))
    return scaled(add(ONE, product(rest, polynomial(_SERIES, _TAIL, rest))), 2.0**powers)


def log(x: Double) -> Double:
    """Return the natural logarithm of x > 0: that of binary64, and what is left by one step of Halley's method."""
    guess = Double(math.log(x.high), 0.0)
    grown = exp(guess)
    return add(guess, scaled(divide(subtract(x, grown), add(x, grown)), 2.0))


def log1p(x: Double) -> Double:
    """Return the natural logarithm of 1 + x."""
    guess = Double(math.log1p(x.high), 0.0)
    grown = expm1(guess)
    return add(guess, scaled(divide(subtract(x, grown), add(scaled(ONE, 2.0), add(x, grown))), 2.0))
