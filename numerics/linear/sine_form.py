"""Exact numbers q + sum (s_j sin alpha_j + c_j cos alpha_j), everything rational: forces and states in time.

By Lindemann's theorem the exponentials of different rational numbers are linearly independent over the rationals. So
such a number is 0 only if all its coefficients are, once angles are >= 0 and those that are equal are joined; and the
sign of any other one is settled by enclosures, sooner or later.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball, exact_middle
from numerics.arithmetic.precision import precision

_FIRST_BITS = 128


class SineForm:
    """One such number; `parts` maps an angle > 0 (rad) to the coefficients of its sine and cosine."""

    __slots__ = ("constant", "parts")

    def __init__(
        self, constant: Fraction | int = 0, parts: Mapping[Fraction, tuple[Fraction, Fraction]] | None = None
    ) -> None:
        """Keep what is not 0."""
        self.constant = Fraction(constant)
        self.parts = {angle: pair for angle, pair in (parts or {}).items() if any(pair)}

    @classmethod
    def turned(cls, angle: Fraction, sine: Fraction, cosine: Fraction) -> SineForm:
        """Return sine sin(angle) + cosine cos(angle)."""
        if angle == 0:
            return cls(cosine)
        return cls(0, {abs(angle): (sine if angle > 0 else -sine, cosine)})

    @property
    def rational(self) -> Fraction | None:
        """Return the number if it is rational, else None."""
        return None if self.parts else self.constant

    def __add__(self, other: SineForm | Fraction | int) -> SineForm:
        """Return the sum."""
        if not isinstance(other, SineForm):
            return SineForm(self.constant + other, self.parts)
        parts = dict(self.parts)
        for angle, (sine, cosine) in other.parts.items():
            before = parts.get(angle, (Fraction(0), Fraction(0)))
            parts[angle] = (before[0] + sine, before[1] + cosine)
        return SineForm(self.constant + other.constant, parts)

    def __mul__(self, factor: Fraction | int) -> SineForm:
        """Return the product with a rational number."""
        parts = {angle: (sine * factor, cosine * factor) for angle, (sine, cosine) in self.parts.items()}
        return SineForm(self.constant * factor, parts)

    def __sub__(self, other: SineForm | Fraction | int) -> SineForm:
        """Return the difference."""
        return self + other * -1

    def __eq__(self, other: object) -> bool:
        """Return whether both are the same number."""
        if not isinstance(other, (SineForm, Fraction, int)):
            return NotImplemented
        return (self - other).sign() == 0

    def __lt__(self, other: SineForm | Fraction | int) -> bool:
        """Return whether the number is less, exact."""
        return (self - other).sign() < 0

    __hash__ = None  # type: ignore[assignment]

    def sign(self) -> int:
        """Return the sign, exact."""
        if not self.parts:
            return (self.constant > 0) - (self.constant < 0)
        bits = _FIRST_BITS
        while True:
            value = self.enclosed(bits)
            if value > 0 or value < 0:
                return 1 if value > 0 else -1
            bits *= 2

    def enclosed(self, bits: int) -> arb:
        """Return an enclosure, formed with so many bits."""
        with precision(bits):
            total = Ball.number(self.constant)
            for angle, (sine, cosine) in self.parts.items():
                s, c = Ball.number(angle).sin_cos()
                total += Ball.number(sine) * s + Ball.number(cosine) * c
            return total

    def rounded(self, bits: int) -> Fraction:
        """Return the number, approximate to so many bits; itself if it is rational."""
        if not self.parts:
            return self.constant
        return exact_middle(self.enclosed(bits))
