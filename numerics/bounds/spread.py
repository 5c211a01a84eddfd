"""A set of errors that linear maps carry on: Lohner's method, a box in a basis that turns with what it holds."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
SLACK = 1.0 + 1e-9
"""For the rounding of these bounds themselves."""


class Spread:
    """The set of errors: basis @ c + d with |c| <= 1, |d| <= rest in each component; in units in which N is a length.

    The columns of the basis are made orthogonal, and the rest is taken in, once a mode: that is what costs.
    """

    def __init__(self, units: Vector, off: Vector) -> None:
        """Begin with a box."""
        self.units, self.basis, self.rest = units, np.diag(off * units), np.zeros(4)

    @property
    def box(self) -> Vector:
        """Return a bound on each component."""
        found: Vector = (np.abs(self.basis).sum(axis=1) + self.rest) / self.units
        return found

    def width(self, weights: Vector) -> float:
        """Return a bound on a linear function of the errors."""
        scaled = weights / self.units
        return float(np.abs(scaled @ self.basis).sum() + np.abs(scaled) @ self.rest)

    def mapped(self, matrix: Vector, local: Vector) -> None:
        """Map all errors, and add local ones."""
        scaled = matrix * (self.units[:, None] / self.units)
        self.basis, self.rest = scaled @ self.basis, (np.abs(scaled) @ self.rest + local * self.units) * SLACK

    def carried(self, matrix: Vector, local: Vector) -> None:
        """Map all errors, add local ones, and tell all by a new basis."""
        self.mapped(matrix, local)
        order = np.argsort(-np.abs(self.basis).sum(axis=0))
        turned, _ = np.linalg.qr(self.basis[:, order])
        reach = np.abs(turned.T @ self.basis).sum(axis=1) + np.abs(turned.T) @ self.rest
        self.basis, self.rest = turned * (reach * SLACK), np.zeros(4)
