"""What an arithmetic must offer. Algorithms take the arithmetic first and are written once for all three."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from enum import Enum
from fractions import Fraction
from typing import Any, NamedTuple, Protocol

from numerics.errors import EventUndecided

Number = Any
"""float, mpmath.mpf or flint.arb: what an arithmetic computes with."""


class Sign(Enum):
    """The only answers to "what sign has this number?"; an enclosure that straddles zero has no proven one."""

    NEGATIVE = -1
    ZERO = 0
    POSITIVE = 1
    UNDECIDED = None


class Contact(NamedTuple):
    """The end of a slip: its angle theta, the depth c(theta) and 1 - cos theta, each accurate relative to itself."""

    theta: Number
    depth: Number
    versine: Number


class Arithmetic(Protocol):
    """Numbers and the functions that the flow needs, at a fixed working precision.

    Every function is accurate relative to its own value over its whole range; the ball arithmetic encloses.
    Numbers support + - * / and unary minus among themselves and with int.
    """

    name: str
    digits: int

    def context(self) -> AbstractContextManager[object]:
        """Return a context manager under which numbers of this arithmetic may be computed with."""

    def number(self, value: Fraction | int) -> Number:
        """Return the number nearest to an exact rational, or an enclosure of it. Raises OutOfRange."""

    def sign(self, x: Number) -> Sign:
        """Return the sign of x, UNDECIDED if it is not proven (or x is not finite)."""

    def ceiling(self, x: Number) -> int | None:
        """Return the least integer >= x, None if that is not decided."""

    def sqrt(self, x: Number) -> Number:
        """Return the square root of x >= 0."""

    def exp(self, x: Number) -> Number:
        """Return e^x."""

    def expm1(self, x: Number) -> Number:
        """Return e^x - 1 without cancellation."""

    def log(self, x: Number) -> Number:
        """Return the natural logarithm of x > 0."""

    def log1p(self, x: Number) -> Number:
        """Return the natural logarithm of 1 + x > 0 without cancellation."""

    def cos_sin(self, x: Number) -> tuple[Number, Number]:
        """Return (cos x, sin x)."""

    def atan2(self, y: Number, x: Number) -> Number:
        """Return the angle of the point (x, y) in (-pi, pi]."""

    def pi(self) -> Number:
        """Return pi."""

    def versine(self, x: Number) -> Number:
        """Return 1 - cos x without cancellation."""

    def sine_deficit(self, x: Number) -> Number:
        """Return x - sin x without cancellation."""

    def cosine_deficit(self, x: Number) -> Number:
        """Return x^2/2 - 1 + cos x without cancellation."""

    def lag(self, x: Number) -> Number:
        """Return sin x - x cos x without cancellation, for |x| <= pi."""

    def rise(self, x: Number) -> Number:
        """Return h(x) = (x - sin x)/(1 - cos x) for 0 < x < 2 pi, without cancellation."""

    def depth(self, x: Number) -> Number:
        """Return c(x) = 2 - x cot(x/2) for 0 < x < 2 pi, without cancellation; c' = h."""

    def root(
        self,
        function: Callable[[Number], Number],
        slope: Callable[[Number], Number],
        lower: Number,
        upper: Number,
        guess: float | None = None,
    ) -> Number:
        """Return the root of a decreasing function between lower and upper, where it is > 0 and < 0.

        `guess` may be a binary64 number next to it: an arithmetic is free to start there, and to end elsewhere.
        """

    def contact(self, gap: Number, push: Number) -> Contact:
        """Return the end of an undamped slip that starts on S with gap >= 0 and push (> 0 if the gap is 0).

        Its angle is the one root of slip_contact.py in (0, 2 pi). Raises EventUndecided.
        """

    def centre(self, x: Number) -> Number:
        """Return x for a point arithmetic, the midpoint of a ball."""

    def accumulate(self, total: Number, rest: Number, term: Number) -> tuple[Number, Number]:
        """Return total + rest + term and what its rounding leaves out, where an arithmetic can tell; else 0."""

    def mean_value(self, function: Callable[[Number], Number], slope: Callable[[Number], Number], x: Number) -> Number:
        """Return function(x); for a ball by the mean value form, whose radius is rad(x) max|slope(x)| and no more."""

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
