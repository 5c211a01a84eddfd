"""What an arithmetic is, seen from Python: how its numbers are read, decided and written."""

from __future__ import annotations

from contextlib import AbstractContextManager
from enum import Enum
from fractions import Fraction
from typing import Any, Protocol

from numerics.errors import EventUndecided

Number = Any
"""float, Pair (double-double), mpmath.mpf or flint.arb: what an arithmetic computes with."""


class Sign(Enum):
    """The only answers to "what sign has this number?"; an enclosure that straddles zero has no proven one."""

    NEGATIVE = -1
    ZERO = 0
    POSITIVE = 1
    UNDECIDED = None


class Arithmetic(Protocol):
    """Numbers at a fixed working precision, with + - * / and unary minus among themselves and with int.

    Their functions go by the type of a number (functions.py).
    """

    name: str
    digits: int

    def context(self) -> AbstractContextManager[object]:
        """Return a context manager under which numbers of this arithmetic may be computed with."""

    def number(self, value: Fraction | int) -> Number:
        """Return the number nearest to an exact rational, or an enclosure of it. Raises OutOfRange."""

    def sign(self, x: Number) -> Sign:
        """Return the sign of x, UNDECIDED if it is not proven (or x is not finite)."""

    def sqrt(self, x: Number) -> Number:
        """Return the square root of x >= 0."""

    def to_float(self, x: Number) -> float:
        """Return the binary64 number nearest to x (to its midpoint, for a ball)."""

    def text(self, x: Number, digits: int = 6) -> str:
        """Return x as text for a message, with its radius if it has one."""


def decide_sign(arithmetic: Arithmetic, x: Number, question: str) -> int:
    """Return -1, 0 or +1, the proven sign of x; raises EventUndecided carrying the question otherwise."""
    sign = arithmetic.sign(x)
    if sign is Sign.POSITIVE:
        return 1
    if sign is Sign.UNDECIDED:
        raise EventUndecided(question, arithmetic.text(x), arithmetic.digits)
    return -1 if sign is Sign.NEGATIVE else 0
