"""The arithmetics by their names."""

from __future__ import annotations

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.protocol import Arithmetic


def arithmetic_named(name: str, digits: int) -> Arithmetic:
    """Return an arithmetic; float64 has its own digits."""
    if name == "float64":
        return Float64()
    return Ball(digits) if name == "ball" else Multiprecision(digits)
