"""Newton's method kept inside a bracket: one loop for every point arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

_MAX_STEPS = 4000


def bracketed_newton(
    function: Callable[[Any], Any], slope: Callable[[Any], Any], lower: Any, upper: Any, tolerance: Any
) -> Any:
    """Return the root of a decreasing function in [lower, upper], to `tolerance` relative to the root.

    The bracket shrinks with every evaluation; a Newton step that would leave it, or that shrinks it too slowly,
    is replaced by bisection, so convergence never depends on the shape of the function.
    """
    x, previous, width, settled = (lower + upper) / 2, upper - lower, upper - lower, tolerance**0.5 / 4
    for _ in range(_MAX_STEPS):
        value = function(x)
        if value == 0:
            return x
        if value > 0:
            lower = x
        else:
            upper = x
        derivative = slope(x)
        step = -value / derivative if derivative < 0 else previous
        candidate = x + step
        if lower <= candidate <= upper and abs(step) <= previous <= settled * min(abs(x), width):
            return candidate  # next to a step so small for the piece it is on: right to the last bits, or noise
        if not lower < candidate < upper or abs(step) * 2 > previous:
            candidate = (lower + upper) / 2
            step = candidate - x
        if abs(step) <= tolerance * abs(candidate) or candidate in (lower, upper):
            return candidate
        x, previous = candidate, abs(step)
    return x
