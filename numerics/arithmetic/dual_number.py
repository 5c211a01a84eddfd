"""A number with its gradient: the chain rule for + - * / and powers."""

from __future__ import annotations

from typing import Any

from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number

Gradient = NDArray[Any] | None
"""Partial derivatives, shape (n,); None stands for zeros."""


def weighted_sum(*terms: tuple[Gradient, Number]) -> Gradient:
    """Return the sum of gradient times factor."""
    total: Gradient = None
    for gradient, factor in terms:
        if gradient is not None:
            # the array comes first: flint and mpmath do not know how to multiply by one
            total = gradient * factor if total is None else total + gradient * factor
    return total


class DualNumber:
    """A value with its gradient; behaves as a number of the base arithmetic, and is ordered by its value."""

    __slots__ = ("gradient", "value")
    __hash__ = None  # type: ignore[assignment]
    __array_ufunc__ = None
    """Arrays leave arithmetic with these numbers to them."""

    def __init__(self, value: Number, gradient: Gradient = None) -> None:
        """Join a value and its partial derivatives."""
        self.value, self.gradient = value, gradient

    def __repr__(self) -> str:
        """Return both parts as text."""
        return f"DualNumber({self.value!r}, {self.gradient!r})"

    def __neg__(self) -> DualNumber:
        """Return the negative."""
        return DualNumber(-self.value, weighted_sum((self.gradient, -1)))

    def __abs__(self) -> DualNumber:
        """Return the absolute value; at 0 with the derivatives of the number itself."""
        return -self if self.value < 0 else self

    def __add__(self, other: Any) -> DualNumber:
        """Return the sum."""
        if not isinstance(other, DualNumber):
            return DualNumber(self.value + other, self.gradient)
        one, two = self.gradient, other.gradient
        return DualNumber(self.value + other.value, two if one is None else one if two is None else one + two)

    __radd__ = __add__

    def __sub__(self, other: Any) -> DualNumber:
        """Return the difference."""
        if not isinstance(other, DualNumber):
            return DualNumber(self.value - other, self.gradient)
        one, two = self.gradient, other.gradient
        gradient = one if two is None else -two if one is None else one - two
        return DualNumber(self.value - other.value, gradient)

    def __rsub__(self, other: Any) -> DualNumber:
        """Return other - self."""
        return DualNumber(other - self.value, weighted_sum((self.gradient, -1)))

    def __mul__(self, other: Any) -> DualNumber:
        """Return the product."""
        if not isinstance(other, DualNumber):
            return DualNumber(self.value * other, weighted_sum((self.gradient, other)))
        gradient = weighted_sum((self.gradient, other.value), (other.gradient, self.value))
        return DualNumber(self.value * other.value, gradient)

    def __rmul__(self, other: Any) -> DualNumber:
        """Return other * self."""
        return DualNumber(other * self.value, weighted_sum((self.gradient, other)))

    def __truediv__(self, other: Any) -> DualNumber:
        """Return the quotient."""
        if not isinstance(other, DualNumber):
            gradient = self.gradient
            return DualNumber(self.value / other, None if gradient is None else gradient / other)
        value = self.value / other.value
        gradient = weighted_sum((self.gradient, 1), (other.gradient, -value))
        return DualNumber(value, None if gradient is None else gradient / other.value)

    def __rtruediv__(self, other: Any) -> DualNumber:
        """Return other / self."""
        return DualNumber(other) / self

    def __pow__(self, power: int) -> DualNumber:
        """Return the power, for a whole exponent >= 1."""
        return DualNumber(self.value**power, weighted_sum((self.gradient, power * self.value ** (power - 1))))

    def __bool__(self) -> bool:
        """Return whether the value is not 0."""
        return bool(self.value != 0)

    def __float__(self) -> float:
        """Return the value in binary64."""
        return float(self.value)

    def __round__(self) -> int:
        """Return the whole number nearest to an exact value: it has no derivatives."""
        return round(self.value)

    def __eq__(self, other: object) -> bool:
        """Compare the values."""
        return bool(self.value == _value(other))

    def __lt__(self, other: Any) -> bool:
        """Compare the values."""
        return bool(self.value < _value(other))

    def __le__(self, other: Any) -> bool:
        """Compare the values."""
        return bool(self.value <= _value(other))

    def __gt__(self, other: Any) -> bool:
        """Compare the values."""
        return bool(self.value > _value(other))

    def __ge__(self, other: Any) -> bool:
        """Compare the values."""
        return bool(self.value >= _value(other))


def _value(x: Any) -> Any:
    return x.value if isinstance(x, DualNumber) else x


def linear(value: DualNumber, *terms: tuple[DualNumber, DualNumber]) -> DualNumber:
    """Return the value with the gradient sum of partial derivative times argument's gradient: the chain rule."""
    return DualNumber(value.value, weighted_sum(*((argument.gradient, partial.value) for partial, argument in terms)))
