"""The first contact of a slip that starts off the switching surface, in binary64 (the algorithm: slip_flow.py)."""

from __future__ import annotations

import math

from numerics.kernel.compilation import kernel
from numerics.kernel.elementary import cosine_deficit, sine_deficit, versine

_MAX_STEPS = 4000
_TOLERANCE = 2.0**-53
_SETTLED = math.sqrt(_TOLERANCE) / 4


@kernel
def guard(theta: float, g: float, d: float, u: float) -> float:
    """Return k(theta) = g + d sin + u (1 - cos) - (theta - sin)."""
    turning = d * math.sin(theta) + u * versine(theta)
    return (turning - sine_deficit(theta)) + g


@kernel
def gap(theta: float, d: float, u: float) -> float:
    """Return d(theta), the slope of the guard."""
    return d + (u * math.sin(theta) - (1 + d) * versine(theta))


@kernel
def push(theta: float, d: float, u: float) -> float:
    """Return u(theta)."""
    return u * math.cos(theta) - (1 + d) * math.sin(theta)


@kernel
def slid(theta: float, g: float, d: float, u: float) -> float:
    """Return K(theta), the integral of the guard."""
    grown = d * versine(theta) + u * sine_deficit(theta)
    return (grown - cosine_deficit(theta)) + g * theta


@kernel
def first_contact(g: float, d: float, u: float, turns: bool) -> tuple[float, float]:
    """Return the first theta > 0 with k = 0, g > 0, and how far above 0 the lowest minimum before it lies.

    `turns`: the guard has extrema, (1 + d)^2 + u^2 > 1 exactly. nan where a number left the range.
    """
    excess = d * (2 + d) + u * u
    if not math.isfinite(excess):
        return math.nan, 0.0
    if not turns or excess <= 0.0:
        return guard_root(g, d, u, 0.0, g + u + 3), math.inf
    lean = math.atan2(math.sqrt(excess), 1.0)
    phase = math.atan2(u, 1 + d)
    turn = 2 * math.pi
    minimum_at_zero = g + u - math.sqrt(excess) + (lean - phase)
    count = minimum_at_zero / turn
    if not count < 1e15:
        return math.nan, 0.0
    least = 1 if phase - lean <= 0.0 else 0
    index = least if count <= 0.0 else max(least, math.ceil(count))
    minimum = phase - lean + turn * index
    maximum = minimum - turn + 2 * lean
    spared = turn * (count - (index - 1)) if index > least else math.inf
    return guard_root(g, d, u, 0.0 if maximum <= 0.0 else maximum, minimum), spared


@kernel
def guard_root(g: float, d: float, u: float, lower: float, upper: float) -> float:
    """Return the root of the guard on a piece where it falls: Newton's method in a bracket (arithmetic/newton.py)."""
    theta, previous, width = (lower + upper) / 2, upper - lower, upper - lower
    for _ in range(_MAX_STEPS):
        value = guard(theta, g, d, u)
        if value == 0:
            return theta
        if value > 0:
            lower = theta
        else:
            upper = theta
        slope = gap(theta, d, u)
        step = -value / slope if slope < 0 else previous
        candidate = theta + step
        if lower <= candidate <= upper and abs(step) <= previous <= _SETTLED * min(abs(theta), width):
            return candidate  # next to a step so small for the piece it is on: right to the last bits, or noise
        if not lower < candidate < upper or abs(step) * 2 > previous:
            candidate = (lower + upper) / 2
            step = candidate - theta
        if abs(step) <= _TOLERANCE * abs(candidate) or candidate in (lower, upper):
            return candidate
        theta, previous = candidate, abs(step)
    return theta
