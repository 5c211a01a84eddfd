"""The words of dual numbers over another arithmetic (words.py): forward differentiation of whatever is told in them.

Values are computed by the words of the base, in the same order: decisions and digits are the same. Over balls the
gradients enclose the derivatives at every point of the values.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from numerics.arithmetic.dual_number import DualNumber, Gradient, weighted_sum
from numerics.arithmetic.protocol import Number


def dual_words(base: Mapping[str, Any]) -> dict[str, Any]:
    """Return the words of dual numbers over an arithmetic with these words; what is not here works on both alike."""
    words = _Words(base)
    names = [name for name in dir(words) if not name.startswith("_")]
    return {**base, "WIDTH": 1, "ZERO": DualNumber(base["ZERO"]), **{name: getattr(words, name) for name in names}}


class _Words:
    """Each method is the word of its name."""

    def __init__(self, base: Mapping[str, Any]) -> None:
        self._base = base

    def _quotient(self, gradient: Gradient, divisor: Number) -> Gradient:
        """Return gradient/divisor; nan where the divisor is 0, as the function has no derivative there."""
        if gradient is None:
            return None
        if not self._base["positive"](divisor * divisor) and divisor == 0:
            return np.full_like(gradient, divisor * float("nan"))
        return gradient / divisor

    @staticmethod
    def _chain(value: Number, x: DualNumber, slope: Callable[[], Number]) -> DualNumber:
        return DualNumber(value, None if x.gradient is None else x.gradient * slope())

    def _constant(self, name: str, *arguments: Any) -> DualNumber:
        return DualNumber(self._base[name](*arguments))

    def exactly(self, n: float) -> DualNumber:
        return self._constant("exactly", n)

    def undefined(self) -> DualNumber:
        return self._constant("undefined")

    def infinite(self) -> DualNumber:
        return self._constant("infinite")

    def turn(self) -> DualNumber:
        return self._constant("turn")

    def half_turn(self) -> DualNumber:
        return self._constant("half_turn")

    @staticmethod
    def signed(side: float, x: DualNumber) -> DualNumber:
        return x if side > 0 else -x

    def sqrt(self, x: DualNumber) -> DualNumber:
        root = self._base["sqrt"](x.value)
        return DualNumber(root, self._quotient(x.gradient, 2 * root))

    def exp(self, x: DualNumber) -> DualNumber:
        value = self._base["exp"](x.value)
        return self._chain(value, x, lambda: value)

    def expm1(self, x: DualNumber) -> DualNumber:
        value = self._base["expm1"](x.value)
        return self._chain(value, x, lambda: 1 + value)

    def log(self, x: DualNumber) -> DualNumber:
        return DualNumber(self._base["log"](x.value), self._quotient(x.gradient, x.value))

    def log1p(self, x: DualNumber) -> DualNumber:
        return DualNumber(self._base["log1p"](x.value), self._quotient(x.gradient, 1 + x.value))

    def sin(self, x: DualNumber) -> DualNumber:
        return self.sine_cosine(x)[0]

    def sine_cosine(self, x: DualNumber) -> tuple[DualNumber, DualNumber]:
        sine, cosine = self._base["sine_cosine"](x.value)
        return self._chain(sine, x, lambda: cosine), self._chain(cosine, x, lambda: -sine)

    def atan2(self, y: DualNumber, x: DualNumber) -> DualNumber:
        gradient = weighted_sum((y.gradient, x.value), (x.gradient, -y.value))
        square = x.value * x.value + y.value * y.value
        return DualNumber(self._base["atan2"](y.value, x.value), self._quotient(gradient, square))

    def versine(self, x: DualNumber) -> DualNumber:
        return self._chain(self._base["versine"](x.value), x, lambda: self._base["sin"](x.value))

    def sine_deficit(self, x: DualNumber) -> DualNumber:
        return self._chain(self._base["sine_deficit"](x.value), x, lambda: self._base["versine"](x.value))

    def cosine_deficit(self, x: DualNumber) -> DualNumber:
        return self._chain(self._base["cosine_deficit"](x.value), x, lambda: self._base["sine_deficit"](x.value))

    def sign(self, x: DualNumber, question: int) -> int:
        return self._base["sign"](x.value, question)

    def positive(self, x: DualNumber) -> bool:
        return self._base["positive"](x.value)

    def below(self, x: DualNumber, y: DualNumber) -> bool:
        return self._base["below"](x.value, y.value)

    def rough(self, x: DualNumber) -> float:
        return self._base["rough"](x.value)

    @staticmethod
    def leading(x: DualNumber) -> DualNumber:
        return x

    @staticmethod
    def part(x: DualNumber) -> DualNumber:
        return x

    @staticmethod
    def middle(x: DualNumber) -> DualNumber:
        return x

    def size(self, x: DualNumber) -> DualNumber:
        """It bounds, and has no derivatives."""
        return self._constant("size", x.value)

    def spread(self, x: DualNumber) -> DualNumber:
        return self._constant("spread", x.value)

    def widened(self, x: DualNumber, by: DualNumber) -> DualNumber:
        return DualNumber(self._base["widened"](x.value, by.value), x.gradient)

    def finite(self, x: DualNumber) -> bool:
        return self._base["finite"](x.value)

    def resolved(self, angle: DualNumber) -> bool:
        return self._base["resolved"](angle.value)

    def ceiling(self, x: DualNumber, question: int) -> int:
        return self._base["ceiling"](x.value, question)

    def nonnegative(self, x: DualNumber) -> DualNumber:
        return DualNumber(self._base["nonnegative"](x.value), x.gradient)

    def clock(self, total: DualNumber, rest: DualNumber, term: DualNumber) -> tuple[DualNumber, DualNumber]:
        """The rounding that a sum leaves out has no derivatives."""
        value, left = self._base["clock"](total.value, rest.value, term.value)
        return DualNumber(value, (total + term).gradient), DualNumber(left)
