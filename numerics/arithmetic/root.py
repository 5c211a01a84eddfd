"""The root of a falling function in its bracket, approximate among points, proved in balls; where one falls first.

Newton's method, kept inside the bracket, approximates it. In balls the root is then enclosed by one interval Newton
step: it exists, and is the only one in the bracket.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import flint
from flint import arb

from numerics.arithmetic.ball import undecided
from numerics.arithmetic.functions import midpoint, sqrt, tolerance
from numerics.arithmetic.precision import precision
from numerics.arithmetic.protocol import Number

Function = Callable[[Number], tuple[Number, Number]]
"""The value and the slope of a function at a number."""
_STEPS = 4000


def falling_root(lower: Number, upper: Number, function: Function) -> Number:
    """Return the root between lower and upper of a function that falls there; for balls an enclosure of it.

    It is approximated among midpoints, to half of the bits, and enclosed by one interval Newton step: it exists, and is
    the only one where the function falls from end to end. Raises EventUndecided where that is not proved.
    """
    if type(lower) is not arb:
        return approximate_root(lower, upper, function)
    with precision(flint.ctx.prec // 2 + 56):
        near = approximate_root(lower.mid(), upper.mid(), function)
    return _enclosed(near, lower, upper, function)


def first_fall(
    low: arb, high: arb, function: Function, error: arb, least: arb
) -> tuple[arb, arb] | Literal[False] | None:
    """Return points between which a function of balls first falls from above `error` to below -error, once.

    None if it stays above `error`; False if that is not decided on a part as short as `least`.
    """
    waiting = [(low, high)]
    while waiting:
        low, high = waiting.pop()
        value, slope = function(low.union(high))
        if value > error:
            continue
        if slope > 0 or slope < 0:
            left, right = function(low)[0], function(high)[0]
            if (left if slope > 0 else right) > error:
                continue
            if slope < 0 and left > error and right < -error:
                return low, high
        if high - low < least:
            return False
        middle = ((low + high) / 2).mid()
        waiting += [(middle, high), (low, middle)]
    return None


def approximate_root(lower: Number, upper: Number, function: Function) -> Number:
    """Return the root of a function that falls from lower to upper to the last bits, or to where balls hold 0, a point.

    The bracket shrinks with every evaluation; a Newton step that would leave it, or that shrinks it too slowly, is
    replaced by bisection, so convergence never depends on the shape of the function.
    """
    x, previous, width = midpoint((lower + upper) / 2), abs(upper - lower), abs(upper - lower)
    enough = tolerance(lower)
    last = sqrt(enough) / 4
    for _ in range(_STEPS):
        value, slope = function(x)
        if value > 0:
            lower = x
        elif value < 0:
            upper = x
        else:
            break
        candidate = midpoint(x - value / slope) if slope < 0 else upper
        moved = abs(candidate - x)
        if lower <= candidate <= upper and moved <= previous <= last * min(abs(x), width):
            return candidate  # next to a step so small for the piece it is on: right to the last bits, or noise
        if not lower < candidate < upper or previous < 2 * moved:
            candidate = midpoint((lower + upper) / 2)
            moved = abs(candidate - x)
        if moved <= enough * abs(candidate) or not lower < candidate < upper:
            return candidate
        x, previous = candidate, moved
    return x


def _enclosed(x: arb, lower: arb, upper: arb, function: Function) -> arb:
    """Return the root next to an exact point by one interval Newton step. Raises EventUndecided."""
    bits = flint.ctx.prec
    value, slope = function(x)
    few = min(bits, bits // 2 + 96)
    with precision(few):
        width = 2 * (abs(value) / abs(slope)).upper() + abs(x) * arb(2) ** -bits
    for _ in range(8):
        region = arb(x, width.upper())
        if not lower < region < upper:
            break
        with precision(few):  # the step is as short as half of the bits: more of its slope would be lost in it
            derivative = function(region)[1]
        if derivative < 0:
            step = x - value / derivative
            if region.contains_interior(step):
                return step
        width = 4 * width
    raise undecided("existence of the guard's root near its approximation", x)
