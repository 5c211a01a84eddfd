"""What an arithmetic is, seen from Python: how its numbers are read and written."""

from __future__ import annotations

from contextlib import AbstractContextManager
from fractions import Fraction
from typing import Any, Protocol

Number = Any
"""float, mpmath.mpf or flint.arb: what an arithmetic computes with."""


class Arithmetic(Protocol):
    """Numbers at a fixed working precision, with + - * / and unary minus among themselves and with int.

    Their functions go by the type of a number (functions.py).
    """

    name: str
    digits: int

    def __repr__(self) -> str:
        """Return the name and the working digits."""
        return f"<{self.name}, {self.digits} working digits>"

    def context(self) -> AbstractContextManager[object]:
        """Return a context manager under which numbers of this arithmetic may be computed with."""

    def number(self, value: Fraction | int) -> Number:
        """Return the number nearest to an exact rational, or an enclosure of it. Raises OutOfRange."""

    def to_float(self, x: Number) -> float:
        """Return the binary64 number nearest to x (to its midpoint, for a ball)."""

    def text(self, x: Number, digits: int = 6) -> str:
        """Return x as text for a message, with its radius if it has one."""
