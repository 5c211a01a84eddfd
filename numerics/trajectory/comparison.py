"""A trajectory of points held against one of balls, event by event: what of it is right."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.protocol import Number
from numerics.errors import NumericsError


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
    for number, (one, two) in enumerate(zip(points.events, balls.events, strict=False), start=1):
        if (one.before, one.after) != (two.before, two.after):
            raise SequenceDiffers(
                f"{points.arithmetic.name} goes to {one.after.value} at event {number}, the proved mode is "
                f"{two.after.value} (t = {float(two.t.mid()):.17g} s); use ball arithmetic"
            )
    if len(points.events) != len(balls.events):
        raise SequenceDiffers(
            f"{points.arithmetic.name} finds {len(points.events)} events, the proved number is "
            f"{len(balls.events)}; use ball arithmetic"
        )


def distance(value: Number, ball: arb) -> arb:
    """Return an enclosure of |value - true|, for a point number and the ball that holds the true one."""
    return abs(ball - as_ball(value))
