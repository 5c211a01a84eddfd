"""Proof that a periodic motion is in the mode that each of its legs says, for all times between its events."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from flint import arb

from numerics.arithmetic.ball_words import working_digits
from numerics.control.linear import MOST_CUTS, ONE, Motion, Row, W, is_positive_on
from numerics.errors import EventUndecided


class Effort(NamedTuple):
    """Into how many parts an interval is cut, and how often a stretch at its ends is halved, before it is given up."""

    cuts: int
    halvings: int


THOROUGH, QUICK = Effort(MOST_CUTS, 40), Effort(64, 12)
"""For a point, whose proof needs it; for a whole box of states, where a smaller box is the better way."""


def is_positive_inside(
    motion: Motion, row: Row, end: arb, zero_at_start: int = 0, zero_at_end: int = 0, effort: Effort = THOROUGH
) -> bool:
    """Return whether a row of z is proved positive for 0 < t < end.

    At the start it vanishes with its first `zero_at_start` - 1 derivatives, likewise at the end: there the next
    derivative decides, over a stretch that is halved until it does.
    """
    left, right = arb(0), end
    if zero_at_start:
        found = _stretch(lambda long: (arb(0), long), motion, row, zero_at_start, end, effort)
        if found is None:
            return False
        left = found
    if zero_at_end:
        other = _stretch(
            lambda long: (end - long, end), motion, _times(row, (-1) ** zero_at_end), zero_at_end, end, effort
        )
        if other is None:
            return False
        right = end - other
    return bool(left >= right) or is_positive_on(lambda t: motion.range(row, t), left, right, effort.cuts)


def _stretch(
    part: Callable[[arb], tuple[arb, arb]], motion: Motion, row: Row, order: int, end: arb, effort: Effort
) -> arb | None:
    """Return a length over which the order-th derivative is proved positive; None if none is found."""
    long = (end / 4).mid()
    for _ in range(effort.halvings):
        if is_positive_on(lambda t: motion.range(row, t, order), *part(long), most=8):
            return long
        long /= 2
    return None


def _times(row: Row, factor: int) -> Row:
    return tuple((place, factor * one) for place, one in row)


def require_slip(motion: Motion, end: arb, *, from_stick: bool, effort: Effort = THOROUGH) -> None:
    """Raise EventUndecided unless s w > 0 is proved inside a slip that begins and ends with w = 0."""
    row = _times(W, motion.mode.side)
    if not is_positive_inside(motion, row, end, 2 if from_stick else 1, 1, effort):
        raise EventUndecided("do the bodies slip all the time between these events?", "w near 0", working_digits())


def require_stick(motion: Motion, end: arb, exit_side: int, effort: Effort = THOROUGH) -> None:
    """Raise EventUndecided unless |Lambda| < b is proved inside a stick phase that ends with Lambda = exit_side b."""
    for side in (1, -1):
        row = (*_times(motion.mode.load, -side), (ONE, motion.mode.b))
        if not is_positive_inside(motion, row, end, 0, int(side == exit_side), effort):
            raise EventUndecided("does friction hold the pair between these events?", "load near b", working_digits())
