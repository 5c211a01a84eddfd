"""Exact rationals next to irrational numbers: what is written into a scene must be a number that a scene can hold."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

from flint import arb

KEPT_DIGITS, TIME_DIGITS = 40, 20
"""Significant digits of a number that a scene cannot hold exactly, and of a time that a plan may choose."""


def rounded(x: arb, digits: int = KEPT_DIGITS) -> Fraction:
    """Return the decimal of so many significant digits next to the midpoint of a ball."""
    return Fraction(Decimal(x.mid().str(digits, radius=False)))


def rounded_up(x: arb, digits: int = KEPT_DIGITS) -> Fraction:
    """Return a decimal of so many digits that no point of a positive ball exceeds."""
    near = Decimal(x.upper().str(digits, radius=False))
    return Fraction(near) + Fraction(2) * Fraction(10) ** (near.adjusted() + 1 - digits)
