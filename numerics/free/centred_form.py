"""Centred forms: a function over a whole cell of parameters, enclosed by its value at the centre and its derivatives.

By the mean value theorem f(p) lies in f(centre) + sum_k f_k(cell) (p_k - c_k) for every point p of the cell. Over small
cells the excess width is of second order, where plain balls would lose all correlation.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball

Slopes = tuple[arb, ...]


@dataclass(frozen=True, slots=True)
class Centred:
    """A differentiable function of the parameters of one cell; everything enclosed.

    `centre` is its value at the centre, `slopes` its partial derivatives over the cell, `value` its range there.
    """

    centre: arb
    slopes: Slopes
    value: arb

    def __add__(self, other: Centred) -> Centred:
        """Return the sum."""
        slopes = tuple(a + b for a, b in zip(self.slopes, other.slopes, strict=True))
        return Centred(self.centre + other.centre, slopes, self.value + other.value)

    def __sub__(self, other: Centred) -> Centred:
        """Return the difference."""
        return self + other * -1

    def __mul__(self, other: Centred | arb | int) -> Centred:
        """Return the product with another function, or with a constant."""
        if not isinstance(other, Centred):
            return Centred(self.centre * other, tuple(one * other for one in self.slopes), self.value * other)
        slopes = (self.value * b + other.value * a for a, b in zip(self.slopes, other.slopes, strict=True))
        return Centred(self.centre * other.centre, tuple(slopes), self.value * other.value)

    def chain(self, centre: arb, derivative: arb, value: arb) -> Centred:
        """Return g of this function, given g at its centre, g' over its range, and the range of g."""
        return Centred(centre, tuple(derivative * one for one in self.slopes), value)

    def sqrt(self) -> Centred:
        """Return the square root of a function that is positive over the cell."""
        root = self.value.sqrt()
        return self.chain(self.centre.sqrt(), 1 / (2 * root), root)


class Cell:
    """A box of exact rational sides; it tightens the ranges of what is computed over it."""

    def __init__(self, *sides: tuple[Fraction | int, Fraction | int]) -> None:
        """Enclose the sides in balls around their midpoints; `parameters` are the coordinates as functions."""
        self._radii = tuple(Ball.number(Fraction(high - low) / 2).upper() for low, high in sides)
        middles = [Ball.number(Fraction(high + low) / 2) for low, high in sides]
        self.parameters = tuple(
            Centred(middle, tuple(arb(int(k == n)) for n in range(len(sides))), middle + arb(0, self._radii[k]))
            for k, middle in enumerate(middles)
        )

    def constant(self, value: arb) -> Centred:
        """Return a constant as a function."""
        return Centred(value, tuple(arb(0) for _ in self._radii), value)

    def tight(self, form: Centred) -> Centred:
        """Return the form with its range intersected with the mean value enclosure."""
        reach = arb(0)
        for slope, radius in zip(form.slopes, self._radii, strict=True):
            reach += abs(slope) * radius
        enclosure = form.centre + arb(0, reach.upper())
        if not enclosure.is_finite():
            return form
        value = enclosure.intersection(form.value) if form.value.is_finite() else enclosure
        return Centred(form.centre, form.slopes, value)

    def without(self, index: int, form: Centred) -> Centred:
        """Return the form without its dependence on one parameter, which widens its value at the centre instead."""
        moved = arb(0, (abs(form.slopes[index]) * self._radii[index]).upper())
        slopes = (*form.slopes[:index], arb(0), *form.slopes[index + 1 :])
        return Centred(form.centre + moved, slopes, form.value)
