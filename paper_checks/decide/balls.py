"""Numbers as balls: flint's process-wide settings, set and restored; a rational as a ball, a ball as text."""

from __future__ import annotations

import math
from contextlib import AbstractContextManager
from fractions import Fraction

from flint import arb, fmpq
from sympy import Rational

from numerics.arithmetic.precision import precision as bits_of_precision

DIGITS = 50
"""Digits that a constant is enclosed to."""


def precision(digits: int = DIGITS) -> AbstractContextManager[None]:
    """Return the context in which balls have so many digits, with guard digits."""
    return bits_of_precision(math.ceil((2 * digits + 20) * math.log2(10)))


def point(value: Fraction | Rational | int) -> arb:
    """Return a ball around a rational number."""
    return arb(fmpq(int(value.numerator), int(value.denominator)))
