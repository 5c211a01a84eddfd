"""How many digits are right: read off the radii of balls, or off the distance to balls."""

from __future__ import annotations

import math
from collections.abc import Iterator

from flint import arb

from numerics.arithmetic.protocol import Number
from numerics.scaling import ReducedState
from numerics.trajectory import Trajectory

EXACT = 10**9
"""Stands for "all digits": the number is exact."""


def digits_within(error: arb, value: arb, scale: arb) -> int:
    """Return how many leading digits an error leaves right, relative to |value|.

    A value that may be 0 has none, unless it is below 10^(-4 n) of its `scale`: then it counts as 0 to n digits.
    """
    if error.is_zero():
        return EXACT
    if not (error.is_finite() and value.is_finite()):
        return 0
    size = scale if value.contains(0) else abs(value)
    ratio = error.upper() / size.lower()
    if not ratio > 0 or not ratio.is_finite():
        return 0
    # log10 through exponent and mantissa: the ratio itself may be far below the range of a float
    digits = max(0, math.floor(-float((ratio.log() / arb(10).log()).mid())))
    return digits // 4 if value.contains(0) else digits


def proved_digits(trajectory: Trajectory) -> int:
    """Return the right digits that every event (t, x1, v1, x2, v2) and the final state and energy have; for balls."""
    with trajectory.arithmetic.context():
        return min(digits_within(value.rad(), value, scale) for value, scale in checked_values(trajectory))


def checked_values(trajectory: Trajectory) -> Iterator[tuple[Number, Number]]:
    """Yield every number a trajectory states, with the scale to which an exact zero is compared."""
    frame = trajectory.frame
    position, speed = frame.length, frame.speed
    for event in trajectory.events:
        yield event.t, event.t
        yield from zip(event.y, (position, speed, position, speed), strict=True)
    final: ReducedState = trajectory.final
    yield from zip(frame.si_state(final), (position, speed, position, speed), strict=True)
    yield frame.energy(final), frame.critical_energy
    yield final.w, frame.arithmetic.number(1)
