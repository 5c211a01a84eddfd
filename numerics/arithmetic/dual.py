"""Numbers that carry their gradient: forward differentiation of whatever is written over the Arithmetic protocol.

A DualNumber has a value of the base arithmetic and its partial derivatives with respect to a few independent
quantities. Values are computed by the operations of the base, in the same order: decisions and digits are the same.
Where the value is found by a search, or by formulas that hold at one point only, the derivatives come from the
equation that is solved (`root`, `contact`) or from a formula that may be differentiated (`differentiated`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.dual_number import DualNumber, Gradient, Recording, kept, values_only, weighted_sum
from numerics.arithmetic.protocol import Arithmetic, Contact, Number, Sign


def differentiated(arithmetic: Arithmetic, values: Callable[[], Any], formula: Callable[[Any], Any]) -> Any:
    """Return values(), a number or a tuple of numbers; with duals, with the gradients of formula(values()).

    The formula need only agree with the values mathematically; it receives them as constants.
    """
    if not (isinstance(arithmetic, Dual) and Recording.on):
        return values()
    with values_only():
        found = values()
    if not isinstance(found, tuple):
        return DualNumber(found.value, formula(DualNumber(found.value)).gradient)
    make = getattr(type(found), "_make", tuple)
    formed = formula(make(DualNumber(one.value) for one in found))
    return make(DualNumber(one.value, two.gradient) for one, two in zip(found, formed, strict=True))


class Dual:
    """Dual numbers over another arithmetic, behind the Arithmetic protocol.

    Name and digits are those of the base, as what holds for its numbers holds for the values. Enclosures stay
    enclosures: over balls the gradients enclose the derivatives at every point of the values.
    """

    def __init__(self, base: Arithmetic) -> None:
        """Differentiate over this arithmetic."""
        self.base, self.name, self.digits = base, base.name, base.digits

    @contextmanager
    def context(self) -> Iterator[None]:
        """Set the precision of the base; what leaves the range of binary64 in a gradient is found at the end."""
        with ExitStack() as stack:
            stack.enter_context(self.base.context())
            stack.enter_context(np.errstate(all="ignore"))
            yield

    def array(self, values: Any) -> NDArray[Any]:
        """Return numbers of the base as an array: of floats for float64, else of objects."""
        return np.array(values, dtype=float if self.name == "float64" else object)

    def number(self, value: Fraction | int | DualNumber) -> DualNumber:
        """Convert an exact rational, or a dual number over exact rationals, which is differentiated exactly."""
        if not isinstance(value, DualNumber):
            return DualNumber(self.base.number(value))
        gradient = None
        if value.gradient is not None:
            gradient = self.array([self.base.number(partial) for partial in value.gradient])
        return DualNumber(self.base.number(value.value), gradient)

    def sign(self, x: DualNumber) -> Sign:
        """Return the sign of the value."""
        return self.base.sign(x.value)

    def ceiling(self, x: DualNumber) -> int | None:
        """Return the least integer >= the value."""
        return self.base.ceiling(x.value)

    def _chain(self, value: Number, x: DualNumber, slope: Callable[[], Number]) -> DualNumber:
        differentiates = Recording.on and x.gradient is not None
        return DualNumber(value, x.gradient * slope() if differentiates else None)

    def _quotient(self, gradient: Gradient, divisor: Number) -> Gradient:
        """Return gradient/divisor; nan where the divisor is 0, as the function has no derivative there."""
        if gradient is None:
            return None
        if self.base.sign(divisor) is Sign.ZERO:
            return np.full_like(gradient, self.base.number(0) * float("nan"))
        return gradient / divisor

    def sqrt(self, x: DualNumber) -> DualNumber:
        """Return the square root; at 0 its derivatives are nan."""
        root = self.base.sqrt(x.value)
        return DualNumber(root, self._quotient(kept(x.gradient), 2 * root))

    def exp(self, x: DualNumber) -> DualNumber:
        """Return e^x."""
        value = self.base.exp(x.value)
        return self._chain(value, x, lambda: value)

    def expm1(self, x: DualNumber) -> DualNumber:
        """Return e^x - 1."""
        value = self.base.expm1(x.value)
        return self._chain(value, x, lambda: 1 + value)

    def log(self, x: DualNumber) -> DualNumber:
        """Return the natural logarithm."""
        return DualNumber(self.base.log(x.value), self._quotient(kept(x.gradient), x.value))

    def log1p(self, x: DualNumber) -> DualNumber:
        """Return the natural logarithm of 1 + x."""
        return DualNumber(self.base.log1p(x.value), self._quotient(kept(x.gradient), 1 + x.value))

    def cos_sin(self, x: DualNumber) -> tuple[DualNumber, DualNumber]:
        """Return (cos x, sin x)."""
        cosine, sine = self.base.cos_sin(x.value)
        return self._chain(cosine, x, lambda: -sine), self._chain(sine, x, lambda: cosine)

    def atan2(self, y: DualNumber, x: DualNumber) -> DualNumber:
        """Return the angle of the point (x, y)."""
        gradient = weighted_sum((y.gradient, x.value), (x.gradient, -y.value))
        square = x.value * x.value + y.value * y.value
        return DualNumber(self.base.atan2(y.value, x.value), self._quotient(gradient, square))

    def pi(self) -> DualNumber:
        """Return pi."""
        return DualNumber(self.base.pi())

    def versine(self, x: DualNumber) -> DualNumber:
        """Return 1 - cos x."""
        return self._chain(self.base.versine(x.value), x, lambda: self.base.cos_sin(x.value)[1])

    def sine_deficit(self, x: DualNumber) -> DualNumber:
        """Return x - sin x."""
        return self._chain(self.base.sine_deficit(x.value), x, lambda: self.base.versine(x.value))

    def cosine_deficit(self, x: DualNumber) -> DualNumber:
        """Return x^2/2 - 1 + cos x."""
        return self._chain(self.base.cosine_deficit(x.value), x, lambda: self.base.sine_deficit(x.value))

    def lag(self, x: DualNumber) -> DualNumber:
        """Return sin x - x cos x."""
        return self._chain(self.base.lag(x.value), x, lambda: x.value * self.base.cos_sin(x.value)[1])

    def rise(self, x: DualNumber) -> DualNumber:
        """Return h(x) = (x - sin x)/(1 - cos x); h' = c/(1 - cos x)."""
        value = self.base.rise(x.value)
        return self._chain(value, x, lambda: self.base.depth(x.value) / self.base.versine(x.value))

    def depth(self, x: DualNumber) -> DualNumber:
        """Return c(x) = 2 - x cot(x/2); c' = h."""
        return self._chain(self.base.depth(x.value), x, lambda: self.base.rise(x.value))

    def root(
        self,
        function: Callable[[DualNumber], DualNumber],
        slope: Callable[[DualNumber], DualNumber],
        lower: DualNumber,
        upper: DualNumber,
        guess: float | None = None,
    ) -> DualNumber:
        """Return the root that the base finds; its derivatives follow from those of the function at a fixed argument.

        The ends of the bracket do not count: the root is the same for all that hold it.
        """
        with values_only():
            x = self.base.root(
                lambda p: function(DualNumber(p)).value,
                lambda p: slope(DualNumber(p)).value,
                lower.value,
                upper.value,
                guess,
            )
            steepness = slope(DualNumber(x)).value
        gradient = function(DualNumber(x)).gradient if Recording.on else None
        return DualNumber(x, self._quotient(gradient, -steepness))

    def contact(self, gap: DualNumber, push: DualNumber) -> Contact:
        """Return the end of a slip from S: dtheta = (du (1 - cos) + dd sin)/(c + d), dc = h dtheta."""
        theta, depth, versine = self.base.contact(gap.value, push.value)
        _, sine = self.base.cos_sin(theta)
        gradient = self._quotient(weighted_sum((push.gradient, versine), (gap.gradient, sine)), depth + gap.value)
        angle = DualNumber(theta, gradient)
        return Contact(
            angle,
            self._chain(depth, angle, lambda: self.base.rise(theta)),
            self._chain(versine, angle, lambda: sine),
        )

    def centre(self, x: DualNumber) -> DualNumber:
        """Return the centre of the value, without derivatives: it is one fixed point."""
        return DualNumber(self.base.centre(x.value))

    def accumulate(self, total: DualNumber, rest: DualNumber, term: DualNumber) -> tuple[DualNumber, DualNumber]:
        """Return the sum and what its rounding leaves out, which has no derivatives."""
        value, left = self.base.accumulate(total.value, rest.value, term.value)
        return DualNumber(value, (total + term).gradient), DualNumber(left)

    def mean_value(
        self,
        function: Callable[[DualNumber], DualNumber],
        slope: Callable[[DualNumber], DualNumber],
        x: DualNumber,
    ) -> DualNumber:
        """Return function(x) with the value of the mean value form."""
        with values_only():
            value = self.base.mean_value(
                lambda p: function(DualNumber(p)).value, lambda p: slope(DualNumber(p)).value, x.value
            )
        return DualNumber(value, function(x).gradient)

    def to_float(self, x: DualNumber) -> float:
        """Return the binary64 number nearest to the value."""
        return self.base.to_float(x.value)

    def text(self, x: DualNumber, digits: int = 6) -> str:
        """Return the value as text."""
        return self.base.text(x.value, digits)
