"""Dual numbers over another arithmetic, seen from Python."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.dual_number import DualNumber
from numerics.arithmetic.protocol import Arithmetic, Sign
from numerics.arithmetic.telling import Telling


class Dual:
    """Dual numbers over another arithmetic; name and digits are those of the base, as values are its numbers."""

    def __init__(self, base: Arithmetic, telling: Telling) -> None:
        """Differentiate over this arithmetic; `telling` is how duals tell the texts (sensitivity/duals.py)."""
        self.base, self.name, self.digits, self.telling = base, base.name, base.digits, telling

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

    def sqrt(self, x: DualNumber) -> DualNumber:
        """Return the square root."""
        root: DualNumber = self.telling.words["sqrt"](x)
        return root

    def to_float(self, x: DualNumber) -> float:
        """Return the binary64 number nearest to the value."""
        return self.base.to_float(x.value)

    def text(self, x: DualNumber, digits: int = 6) -> str:
        """Return the value as text."""
        return self.base.text(x.value, digits)
