"""Centred forms: a function over a whole cell of parameters, enclosed by its value at the centre and its derivatives.

By the mean value theorem f(p) lies in f(centre) + sum_k f_k(cell) (p_k - c_k) for every point p of the cell. Over small
cells the excess width is of second order, where plain balls would lose all correlation.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb, arb_mat

from numerics.arithmetic.ball import Ball


class Centred:
    """A differentiable function of the parameters p of one cell; everything enclosed.

    `centre` is its value at the centre c, `slopes` (1, n) its derivatives over the cell, `value` its range there;
    `cell` (n, 1) is the range of p - c.
    """

    __slots__ = ("cell", "centre", "slopes", "value")

    def __init__(self, centre: arb, slopes: arb_mat, value: arb, cell: arb_mat) -> None:
        """Intersect the range with the mean value enclosure."""
        self.centre, self.slopes, self.cell = centre, slopes, cell
        enclosure = centre + (slopes * cell)[0, 0]
        if enclosure.is_finite():
            value = enclosure.intersection(value) if value.is_finite() else enclosure
        self.value = value

    def __add__(self, other: Centred) -> Centred:
        """Return the sum."""
        return Centred(self.centre + other.centre, self.slopes + other.slopes, self.value + other.value, self.cell)

    def __sub__(self, other: Centred) -> Centred:
        """Return the difference."""
        return Centred(self.centre - other.centre, self.slopes - other.slopes, self.value - other.value, self.cell)

    def __mul__(self, other: Centred) -> Centred:
        """Return the product."""
        slopes = self.slopes * other.value + other.slopes * self.value
        return Centred(self.centre * other.centre, slopes, self.value * other.value, self.cell)

    def sqrt(self) -> Centred:
        """Return the square root of a function that is positive over the cell."""
        root = self.value.sqrt()
        return Centred(self.centre.sqrt(), self.slopes / (2 * root), root, self.cell)

    def constant(self, value: arb) -> Centred:
        """Return a constant over the same cell."""
        return Centred(value, self.slopes * 0, value, self.cell)


def parameters(*sides: tuple[Fraction, Fraction]) -> list[Centred]:
    """Return the coordinates of a box of exact rational sides, as functions over it."""
    cell = arb_mat([[arb(0, Ball.number((high - low) / 2).upper())] for low, high in sides])
    middles = [Ball.number((high + low) / 2) for low, high in sides]
    units = [arb_mat([[int(k == n) for n in range(len(sides))]]) for k in range(len(sides))]
    return [
        Centred(middle, unit, middle + cell[k, 0], cell)
        for k, (middle, unit) in enumerate(zip(middles, units, strict=True))
    ]
