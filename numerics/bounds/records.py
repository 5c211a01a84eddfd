"""What both kinds of motion say of their errors; all dimensionless, in binary64 whatever the numbers are."""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.float64 import UNIT
from numerics.arithmetic.telling import text

UNDERFLOW = 1e-290
"""What products below the normal numbers may have dropped from a sum."""


ErrorsThere = tuple[float, float, float, float, float]
"""Bounds on the errors of tau, X, V, Z and w at an event."""


class EventErrors(NamedTuple):
    """Bounds on the errors of tau, X, V, Z and w at an event, and on the relative error of t, x1, v and x2."""

    late: float
    x: float
    v: float
    place: float
    w: float
    relative: float


class EndErrors(NamedTuple):
    """Bounds on the errors at the end of a run; `certain`: they leave no doubt about the sequence of events."""

    x: float
    v1: float
    v2: float
    place: float
    w: float
    spent: float
    damped: float
    certain: bool


@text
def relative(error: float, value: float) -> float:
    """Return error/|value|; 0 for an exact 0."""
    if error == 0.0:
        return 0.0
    return error / abs(value) if value != 0.0 else math.inf


@text
def event_errors(tau: float, X: float, V: float, x2: float, Z: float, at: ErrorsThere) -> EventErrors:
    """Return the errors at an event with the relative one, the rounding of SI units included."""
    late, x, v, place, w = at
    times_and_places = max(relative(late, tau), relative(x, X), relative(x + place + UNIT * abs(Z), x2))
    return EventErrors(late, x, v, place, w, max(times_and_places, relative(v, V)) + 8.0 * UNIT)
