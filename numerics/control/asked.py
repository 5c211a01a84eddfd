"""Answers to as many digits as are asked for: the working precision is raised until the balls are narrow enough."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided, PrecisionExhausted
from numerics.trajectory.digits import digits_within

MAX_DIGITS = 2_000
"""Cap on the working digits of what takes milliseconds."""
_MOST_TIMES = 16
_SPARE_DIGITS = 12

Answer = TypeVar("Answer")
Tell = Callable[[str], None]
"""Told what is being done, for who waits."""


def most_digits(digits: int, max_digits: int | None) -> int:
    """Return the cap on the working digits of what takes seconds: as given, else 16 times as many as are asked for."""
    return max_digits or _MOST_TIMES * (digits + _SPARE_DIGITS)


def silent(_: str) -> None:
    """Tell nobody."""


def to_digits(
    attempt: Callable[[Ball], tuple[Answer, Iterable[arb]]], digits: int, max_digits: int | None = None
) -> Answer:
    """Return the answer of the first attempt whose balls have `digits` right digits each.

    An attempt runs in the context of the arithmetic that it is given. A ball that may be 0 counts as right below
    10^(-4 digits); one that is not finite is never right. The cap is MAX_DIGITS unless
    another is given. Raises what the last attempt raised (EventUndecided), PrecisionExhausted.
    """
    working, most = digits + _SPARE_DIGITS, max_digits or MAX_DIGITS
    undecided: EventUndecided | None = None
    while working <= most:
        arithmetic = Ball(working)
        try:
            with arithmetic.context():
                answer, balls = attempt(arithmetic)
                reached = min((_right_digits(one) for one in balls), default=digits)
        except EventUndecided as error:
            undecided, reached = error, 0
        else:
            undecided = None
            if reached >= digits:
                return answer
        working = 2 * working if undecided or reached <= 0 else working + digits - reached + _SPARE_DIGITS
    if undecided is not None:
        raise undecided
    raise PrecisionExhausted(f"{digits} right digits need more than {most} working digits; raise max_digits")


def _right_digits(one: arb) -> int:
    """Return how many digits of a ball are right; none of an infinity, whose radius is 0, or of a nan."""
    return digits_within(one.rad(), one, arb(1)) if one.is_finite() else 0
