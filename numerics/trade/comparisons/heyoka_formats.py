"""The number types that heyoka compiles for, each with correctly rounded constants and all its digits as text."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Literal

import numpy as np

from numerics.trade.comparisons.peer import Extra

Precision = Literal["double", "long double", "quadruple", "real"]
_TEXT_DIGITS = 40


@dataclass(frozen=True)
class Format:
    """A floating point format of heyoka."""

    kind: Extra
    """What heyoka calls fp_type."""
    bits: int
    """Of the significand."""
    read: Callable[[Any], Extra]
    """Takes a float, or an integer as text."""
    text: Callable[[Extra], str]
    """Writes a number with at least as many digits as it has."""
    options: dict[str, int] = field(default_factory=dict)
    """What an integrator has to be told besides."""

    def number(self, value: Fraction) -> Extra:
        """Return the number of this format that is nearest to a rational; both halves of the division are exact."""
        near = nearest(value, self.bits)
        return self.read(str(near.numerator)) / self.read(str(near.denominator))


def nearest(value: Fraction, bits: int) -> Fraction:
    """Return the dyadic rational with so many bits that is nearest to a rational, ties to even.

    >>> nearest(Fraction(1, 10), 53) == Fraction(0.1), nearest(Fraction(-5), 2), nearest(Fraction(0), 8)
    (True, Fraction(-4, 1), Fraction(0, 1))
    """
    if value == 0:
        return value
    exponent = abs(value.numerator).bit_length() - value.denominator.bit_length() - bits
    if abs(value) >= Fraction(2) ** (exponent + bits):  # the estimate is right, or one too low
        exponent += 1
    unit = Fraction(2) ** exponent
    return round(value / unit) * unit


def format_of(precision: Precision, digits: int) -> Format:
    """Return a format; `digits` are those of "real", whose precision can be chosen."""
    if precision == "double":
        return Format(float, 53, float, lambda value: _scientific(np.float64(value)))
    if precision == "long double":
        return Format(np.longdouble, np.finfo(np.longdouble).nmant + 1, np.longdouble, _scientific)
    import heyoka

    if precision == "quadruple":
        return Format(heyoka.real128, 113, heyoka.real128, str)
    bits = math.ceil(digits * math.log2(10))
    return Format(heyoka.real, bits, lambda value: heyoka.real(value, bits), str, {"prec": bits})


def _scientific(value: Any) -> str:
    """Return the decimal expansion: the shortest text of a number may be half an ulp off."""
    return np.format_float_scientific(value, precision=_TEXT_DIGITS, unique=False)
