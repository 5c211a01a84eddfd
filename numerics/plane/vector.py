"""Numbers by axes, as one: sums, products and quotients act on each component, @ adds the products up.

A matrix is the vector of its columns: then @ is its product with a vector.
"""

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
    """Components of one kind: balls, polynomials, power series, exact numbers, or columns.

    >>> v = Vector([3, 4])
    >>> v * v, v * 2 - v, 12 / v, v @ v, abs(v - 4), Vector([v, v * 2]) @ v
    ((9, 16), (3, 4), (4.0, 3.0), 25, (1, 0), (33, 44))
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

    def __matmul__(self, other: Sequence[Any]) -> Any:
        """Return the sum of the products; of columns row by row, without zeros, which is quicker."""
        if self and isinstance(self[0], Vector):
            rows = zip(*self, strict=True)
            return Vector(sum((x * y for x, y in zip(row, other, strict=True) if x), other[0] * 0) for row in rows)
        return sum(map(mul, self, other))


def exact(numbers: Iterable[Any]) -> Vector:
    """Return exact numbers as balls, also those of columns."""
    return Vector(exact(one) if isinstance(one, tuple) else Ball.number(one) for one in numbers)


def wide(x: Any, by: Any) -> Any:
    """Return x with a radius that is larger by something, of numbers or of vectors."""
    return Vector(map(wide, x, by)) if isinstance(x, Vector) else x + arb(0, by.upper())
