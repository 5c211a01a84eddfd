"""The one loop over precisions: more digits are worked with until an answer has those that are asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

from flint import arb

from numerics.arithmetic.ball import Ball, digits_within
from numerics.errors import EventUndecided, PrecisionExhausted

MAX_DIGITS = 2_000
"""Cap on the working digits of what takes milliseconds."""
SPARE_DIGITS = 12
Answer = TypeVar("Answer")


def to_digits(
    attempt: Callable[[Ball], tuple[Answer, Iterable[arb] | int]],
    digits: int,
    max_digits: int | None = None,
    spare: int = SPARE_DIGITS,
    doublings: int = MAX_DIGITS,
) -> Answer:
    """Return the answer of the first attempt whose balls have `digits` right digits each, or that says that it has.

    An attempt runs in the context of the arithmetic that it is given, the first one with `spare` digits more. A ball
    that may be 0 counts as right below 10^(-4 digits); one that is not finite is never right. The cap is MAX_DIGITS
    unless another is given; of attempts that decide nothing so many `doublings` come after. Raises what the last
    attempt raised (EventUndecided), PrecisionExhausted.
    """
    working, most = digits + spare, max_digits or MAX_DIGITS
    failure: EventUndecided | None = None
    while working <= most:
        arithmetic, failure, reached = Ball(working), None, 0
        try:
            with arithmetic.context():
                answer, known = attempt(arithmetic)
                reached = known if isinstance(known, int) else min(map(_right_digits, known), default=digits)
        except EventUndecided as error:
            failure, doublings = error, doublings - 1
            if doublings < 0:
                break
        else:
            if reached >= digits:
                return answer
        working = working + digits - reached + SPARE_DIGITS if reached > 0 else 2 * working
    if failure is not None:
        raise failure
    raise exhausted(digits, most)


def exhausted(digits: int, most: int) -> PrecisionExhausted:
    """Return what says that the cap on working digits comes before so many right ones."""
    return PrecisionExhausted(
        f"{digits} right digits need more than max_digits = {most} working digits; raise max_digits, or ask for fewer"
    )


def _right_digits(one: arb) -> int:
    """Return how many digits of a ball are right; none of an infinity, whose radius is 0, or of a nan."""
    return digits_within(one.rad(), one, arb(1)) if one.is_finite() else 0
