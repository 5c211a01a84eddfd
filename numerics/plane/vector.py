"""Numbers by axes, as one: sums, products and quotients act on each component, @ adds the products up."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import repeat
from operator import add, mul, sub, truediv
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball


def _acting(operation: Callable[[Any, Any], Any]) -> Any:
    """Return an operator with a vector, or with a number that stands for equal ones."""

    def act(one: Vector, other: Any) -> Vector:
        return Vector(map(operation, one, other if isinstance(other, Vector) else repeat(other)))

    return act


class Vector(tuple[Any, ...]):
    """Components of one kind: balls, polynomials, power series, or exact numbers.

    >>> v = Vector([3, 4])
    >>> v * v, v * 2 - v, 12 / v, v @ v, abs(v - 4)
    ((9, 16), (3, 4), (4.0, 3.0), 25, (1, 0))
    """

    __slots__ = ()
    __add__ = __radd__ = _acting(add)
    __sub__ = _acting(sub)
    __mul__ = __rmul__ = _acting(mul)
    __truediv__ = _acting(truediv)
    __rtruediv__ = _acting(lambda one, other: other / one)

    def each(self, of: Callable[[Any], Any]) -> Vector:
        """Return a function of each component."""
        return Vector(map(of, self))

    def order(self, k: int) -> Vector:
        """Return the coefficients of one order."""
        return Vector(one[k] for one in self)

    def __abs__(self) -> Vector:
        """Return the size of each component."""
        return self.each(abs)

    def __matmul__(self, other: Iterable[Any]) -> Any:
        """Return the sum of the products."""
        return sum(map(mul, self, other))


class Matrix(tuple[Any, ...]):
    """A matrix of balls by rows, without its zeros: pairs of a column and a number."""

    __slots__ = ()

    @classmethod
    def of(cls, rows: Iterable[Iterable[Any]]) -> Matrix:
        """Return the matrix of exact rows."""
        return cls(tuple((j, Ball.number(x)) for j, x in enumerate(row) if x) for row in rows)

    def __matmul__(self, vector: Sequence[Any]) -> Vector:
        """Return the matrix times a vector, of numbers or of polynomials."""
        return Vector(sum((x * vector[j] for j, x in row), arb(0)) for row in self)

    def __abs__(self) -> Matrix:
        """Return the matrix of the sizes."""
        return Matrix(tuple((j, abs(x)) for j, x in row) for row in self)


def exact(numbers: Iterable[Any]) -> Vector:
    """Return exact numbers as balls."""
    return Vector(map(Ball.number, numbers))


def wide(x: Any, by: Any) -> Any:
    """Return x with a radius that is larger by something, of numbers or of vectors."""
    return Vector(map(wide, x, by)) if isinstance(x, Vector) else x + arb(0, by.upper())
