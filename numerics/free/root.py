"""The root of a falling function in its bracket: approximate among points, proved in balls.

Newton's method, kept inside the bracket, serves every point arithmetic. In balls its root is then enclosed by one
interval Newton step: it exists, and is the only one in the bracket.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball import precision, undecided
from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import as_float, like, sqrt, tolerance
from numerics.arithmetic.protocol import Number
from numerics.errors import EventUndecided

Function = Callable[[Any, Number], tuple[Number, Number]]
"""A function of a record and a number: its value and its slope."""
_STEPS = 4000
_START_BITS, _SEED_BITS = 64, 44


def falling_root(lower: Number, upper: Number, function: Function, at: Any) -> Number:
    """Return the root between lower and upper of a function that falls there; for balls an enclosure of it.

    Raises EventUndecided if in balls a sign, the slope or the inclusion is not proved at this precision.
    """
    if type(lower) is arb:
        return _enclosed_root(lower, upper, function, at)
    return search(function, at, lower, upper, (lower + upper) / 2)


@compilable
def search(function: Function, at: Any, lower: Number, upper: Number, guess: Number) -> Number:
    """Return the root between lower and upper of a function that falls there, searched from a guess; to the last bits.

    The bracket shrinks with every evaluation; a Newton step that would leave it, or that shrinks it too slowly, is
    replaced by bisection, so convergence never depends on the shape of the function.
    """
    x, previous, width, zero = guess, abs(upper - lower), abs(upper - lower), like(guess, 0.0)
    enough = tolerance(guess)
    last = sqrt(enough) / 4
    for _ in range(_STEPS):
        value, slope = function(at, x)
        if zero < value:
            lower = x
        elif value < zero:
            upper = x
        else:
            return x
        step = -value / slope if slope < zero else previous
        candidate, moved = x + step, abs(step)
        inside = not candidate < lower and not upper < candidate
        if inside and moved <= previous <= last * abs(x) and previous <= last * width:
            return candidate  # next to a step so small for the piece it is on: right to the last bits, or noise
        if not lower < candidate < upper or previous < moved * 2:
            candidate = (lower + upper) / 2
            moved = abs(candidate - x)
        if moved <= enough * abs(candidate) or not lower < candidate < upper:
            return candidate
        x, previous = candidate, moved
    return x


def _enclosed_root(lower: arb, upper: arb, function: Function, at: Any) -> arb:
    """Return an enclosure of the root, proved to exist and to be the only one between lower and upper.

    The signs at the ends are proved here; from the root of binary64 it is approximated with doubling precision, and one
    interval Newton step encloses it. Where that fails it is searched at full precision: binary64 has no digits for it,
    or is too far off close to a graze.
    """

    def refined(x: arb) -> arb:
        """Return an exact point near the root, right to half of the bits and some more, by Newton's method."""
        right, enough = _SEED_BITS, flint.ctx.prec // 2 + 32
        while right < enough:
            right = min(2 * right, enough)
            with precision(min(flint.ctx.prec, right + 32)):
                value, slope = function(at, x)
                correction = (value / slope).mid()
                x = (x - correction).mid() if correction.is_finite() else x
        return x

    def searched() -> arb:
        """Return an exact point near the root, found among points."""

        def points(_: None, x: arb) -> tuple[arb, arb]:
            value, slope = function(at, x)
            return value.mid(), slope.mid()

        return search(points, None, lower.mid(), upper.mid(), ((lower + upper) / 2).mid()).mid()

    for end, side in ((lower, 1), (upper, -1)):
        _prove_sign(end, side, function, at)
    near = _guess(lower, upper, function, at)
    if lower < near < upper:
        try:
            return _enclosed(refined(near), lower, upper, function, at)
        except EventUndecided:
            pass
    return _enclosed(searched(), lower, upper, function, at)


def _prove_sign(end: arb, side: int, function: Function, at: Any) -> None:
    for bits in (min(flint.ctx.prec, _START_BITS), flint.ctx.prec):
        with precision(bits):
            value = function(at, end)[0]
            if value.is_finite() and side * value > 0:
                return
    raise undecided("sign of the guard at an end of its bracket", value)


def _guess(lower: arb, upper: arb, function: Function, at: Any) -> arb:
    """Return the root that binary64 finds, an exact point; nan where it has no digits for it."""
    record, ends = getattr(type(at), "_make", tuple)(map(as_float, at)), (as_float(lower), as_float(upper))
    if not all(1e-9 < abs(one) < 1e4 for one in (*record, *ends) if one):
        return arb.nan()
    try:
        return arb(search(function, record, *ends, (ends[0] + ends[1]) / 2))
    except (ArithmeticError, ValueError):
        return arb.nan()


def _enclosed(x: arb, lower: arb, upper: arb, function: Function, at: Any) -> arb:
    """Return the root next to an exact point by one interval Newton step. Raises EventUndecided."""
    bits = flint.ctx.prec
    value, slope = function(at, x)
    few = min(bits, bits // 2 + 96)
    with precision(few):
        width = 2 * (abs(value) / abs(slope)).upper() + abs(x) * arb(2) ** -bits
    for _ in range(8):
        region = arb(x, width.upper())
        with precision(few):  # the step is as short as half of the bits: more of its slope would be lost in it
            derivative = function(at, region)[1]
        if lower < region < upper and derivative < 0:
            step = x - value / derivative
            if region.contains_interior(step):
                return step
        width = 4 * width
    raise undecided("existence of the guard's root near its approximation", x)
