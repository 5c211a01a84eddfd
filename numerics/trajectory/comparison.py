"""A trajectory of points held against one of balls, event by event: what of it is right."""

from __future__ import annotations

from fractions import Fraction
from itertools import zip_longest
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.protocol import Number
from numerics.errors import NumericsError
from numerics.linear.modes import MODES
from numerics.trajectory.checked import Difference


class SequenceDiffers(NumericsError):
    """A point arithmetic lost or invented an event; the balls' sequence is the proved one."""


def as_fraction(value: Number) -> Fraction:
    """Return the exact rational value of a float of any format, of a rational or of an mpmath number."""
    if hasattr(value, "man_exp"):
        mantissa, exponent = value.man_exp
        sign = -1 if value < 0 else 1
        return sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return Fraction(*value.as_integer_ratio())


def as_ball(value: Number) -> arb:
    """Return a ball that holds a number of any arithmetic, in the present precision; a ball as it is."""
    return value if isinstance(value, arb) else Ball.number(as_fraction(value))


def require_same_sequence(points: Any, balls: Any) -> None:
    """Raise SequenceDiffers, naming the first event at which the two itineraries part."""
    if difference := first_difference(points, balls):
        raise SequenceDiffers(f"{points.arithmetic.name}: {difference}; use ball arithmetic")


def first_difference(run: Any, truth: Any) -> Difference | None:
    """Return the first event after which the modes of two runs differ, or which one of them does not have."""
    for event, (one, two) in enumerate(zip_longest(run.signs, truth.signs)):
        if one != two:
            return Difference(event, *_after(run, event), *_after(truth, event))
    return None


def _after(run: Any, event: int) -> tuple[float | None, str | None]:
    """Return when an event is, s, and the mode from then on; None for one that is not there."""
    if event > len(run.event_times):
        return None, None
    return float(as_ball(run.event_times[event - 1]).mid()) if event else 0.0, MODES[run.signs[event]].value


def distance(value: Number, ball: arb) -> arb:
    """Return an enclosure of |value - true|, for a point number and the ball that holds the true one."""
    return abs(ball - as_ball(value))
