"""Newton's method kept inside a bracket: one loop for every point arithmetic, handed the function it is for."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.arithmetic.float64 import ZERO, below, part, settled, size, tolerance
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import handed, text

_STEPS = 4000
Pair = Callable[[Any, Number], tuple[Number, Number]]
"""A function of a record and a number: its value and its slope."""


@text
def handed_function(at: Any, x: Number) -> tuple[Number, Number]:
    """Return the value and the slope at x of the function that a root is of; it falls between lower and upper."""
    raise NotImplementedError(f"{at}, {x}: root_of puts a function here")


@text
def root(at: Any, lower: Number, upper: Number, guess: Number) -> Number:
    """Return the root between lower and upper of a function that falls there, searched from a guess.

    The bracket shrinks with every evaluation; a Newton step that would leave it, or that shrinks it too slowly, is
    replaced by bisection, so convergence never depends on the shape of the function. Approximate, to the last bits.
    """
    x, previous, width, enough, last = guess, size(upper - lower), size(upper - lower), tolerance(), settled()
    for _ in range(_STEPS):
        value, slope = handed_function(at, x)
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


def root_of(pair: Pair, name: str) -> Callable[[Any, Number, Number, Number], Number]:
    """Return the text `root` of one function, which is a text too."""
    found: Callable[[Any, Number, Number, Number], Number] = handed(root, pair, name)
    return found
