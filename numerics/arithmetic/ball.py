"""python-flint balls: the rigorous arithmetic, seen from Python."""

from __future__ import annotations

import math
from contextlib import AbstractContextManager
from fractions import Fraction

import flint
from flint import arb

from numerics.arithmetic import ball_words
from numerics.arithmetic.ball_words import BALL, BITS_PER_DIGIT, GUARD_BITS, precision
from numerics.arithmetic.protocol import Sign


class Ball:
    """flint.arb balls with `digits` working decimal digits, seen from Python."""

    name = "ball"
    telling = BALL
    sqrt = staticmethod(ball_words.sqrt)

    def __init__(self, digits: int) -> None:
        """Fix the working precision in decimal digits."""
        self.digits = digits
        self.bits = math.ceil(digits * BITS_PER_DIGIT) + GUARD_BITS

    def context(self) -> AbstractContextManager[None]:
        """Return a context that sets flint's process-wide precision, and restores it whatever happens."""
        return precision(self.bits)

    @staticmethod
    def number(value: Fraction | int) -> arb:
        """Return a ball that contains an exact rational."""
        if isinstance(value, int):
            return +arb(value)  # rounded, as a rational would be
        return arb(flint.fmpq(value.numerator, value.denominator))

    def sign(self, x: arb) -> Sign:
        """Return the proven sign of x; ZERO only for the exact zero; UNDECIDED if x straddles it or is not finite."""
        if x.is_finite():
            if x > 0:
                return Sign.POSITIVE
            if x < 0:
                return Sign.NEGATIVE
            if x.is_zero():
                return Sign.ZERO
        return Sign.UNDECIDED

    def to_float(self, x: arb) -> float:
        """Return the binary64 number nearest to the midpoint of x."""
        return float(x.mid())

    def text(self, x: arb, digits: int = 6) -> str:
        """Return x as text with its radius."""
        return str(x.str(digits))
