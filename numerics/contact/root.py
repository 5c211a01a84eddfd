"""Newton's method kept inside a bracket: one loop for every point arithmetic, handed the function whose root it finds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.arithmetic.float64 import ZERO, below, part, settled, size, tolerance
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text

_STEPS = 4000
Pair = Callable[[Any, Number], tuple[Number, Number]]
"""A function of a record and a number: its value and its slope."""


@text
def guessed(pair: Pair, at: Any, lower: Number, upper: Number) -> Number:  # noqa: ARG001
    """Return where the search in a bracket starts: its middle; balls say more (enclosed_root.py)."""
    return (lower + upper) / 2


@text
def root(pair: Pair, at: Any, lower: Number, upper: Number, guess: Number) -> Number:
    """Return the root between lower and upper of a function that falls there; pair(at, x) is its value and its slope.

    The bracket shrinks with every evaluation; a Newton step that would leave it, or that shrinks it too slowly, is
    replaced by bisection, so convergence never depends on the shape of the function. Approximate, to the last bits.
    """
    x, previous, width, enough, last = guess, size(upper - lower), size(upper - lower), tolerance(), settled()
    for _ in range(_STEPS):
        value, slope = pair(at, x)
        if below(ZERO, value):
            lower = x
        elif below(value, ZERO):
            upper = x
        else:
            return x
        step = -value / slope if below(slope, ZERO) else part(previous)
        candidate, moved = x + step, size(step)
        inside = not below(candidate, lower) and not below(upper, candidate)
        if inside and moved <= previous <= last * min(size(x), width):
            return candidate  # next to a step so small for the piece it is on: right to the last bits, or noise
        if not (below(lower, candidate) and below(candidate, upper)) or moved * 2 > previous:
            candidate = (lower + upper) / 2
            moved = size(candidate - x)
        if moved <= enough * size(candidate) or not (below(lower, candidate) and below(candidate, upper)):
            return candidate
        x, previous = candidate, moved
    return x
