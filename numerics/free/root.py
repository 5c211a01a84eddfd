"""The root of a falling function in its bracket: approximate among points, proved in balls.

Newton's method, kept inside the bracket, serves every point arithmetic. In balls its root is then enclosed by one
interval Newton step: it exists, and is the only one in the bracket.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball import magnitude_bits, precision, undecided
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
        return _Enclosed(function, at).root(lower, upper)
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


class _Enclosed:
    """A function in balls, and the proof of its root."""

    def __init__(self, function: Function, at: Any) -> None:
        self._function, self._record = function, at

    def _value(self, x: arb) -> tuple[arb, arb]:
        return self._function(self._record, x)

    def root(self, lower: arb, upper: arb) -> arb:
        """Return an enclosure of the root, proved to exist and to be the only one between lower and upper.

        The signs at the ends are proved here, the root is approximated with doubling precision, and one interval Newton
        step encloses it.
        """
        for end, side in ((lower, 1), (upper, -1)):
            self._prove_sign(end, side)
        near = self._guess(lower, upper)
        if lower < near < upper:
            try:
                return self._enclosed(self._refined(near, _SEED_BITS), lower, upper)
            except EventUndecided:
                pass  # it was not as near as it should be
        try:
            return self._enclosed(self._approximate(lower, upper), lower, upper)
        except EventUndecided:
            # close to a graze low precision cannot tell the root from the extremum: search at the full one instead
            return self._enclosed(self._searched(lower, upper), lower, upper)

    def _prove_sign(self, end: arb, side: int) -> None:
        for bits in (min(flint.ctx.prec, _START_BITS), flint.ctx.prec):
            with precision(bits):
                value = self._value(end)[0]
                if value.is_finite() and side * value > 0:
                    return
        raise undecided("sign of the guard at an end of its bracket", value)

    def _guess(self, lower: arb, upper: arb) -> arb:
        """Return the root that binary64 finds, an exact point; nan where it has no digits for it."""
        ends, record = (as_float(lower), as_float(upper)), _in_floats(self._record)
        if not all(1e-9 < abs(one) < 1e4 for one in (*record, *ends) if one):
            return arb.nan()
        try:
            return arb(search(self._function, record, *ends, (ends[0] + ends[1]) / 2))
        except (ArithmeticError, ValueError):
            return arb.nan()

    def _approximate(self, lower: arb, upper: arb) -> arb:
        """Return an exact point near the root, to a little more than half of the bits: an interval step does the rest.

        Searched at low precision, then Newton's method with doubling precision.
        """
        # a root far from zero needs more: the guard varies over distances of order 1, and over its bracket
        size = magnitude_bits(upper.mid())
        far = max(0, size, size - magnitude_bits((upper - lower).mid()))
        with precision(min(flint.ctx.prec, _START_BITS + far)):
            x = self._searched(lower, upper)
        return self._refined(x, 36 + far, far)

    def _searched(self, lower: arb, upper: arb) -> arb:
        """Return an exact point near the root, found among points at the present precision."""

        def points(_: None, x: arb) -> tuple[arb, arb]:
            value, slope = self._value(x)
            return value.mid(), slope.mid()

        lower, upper = lower.mid(), upper.mid()
        return search(points, None, lower, upper, ((lower + upper) / 2).mid()).mid()

    def _refined(self, x: arb, right: int, far: int = 0) -> arb:
        """Return an exact point near the root from one that has so many right bits, by Newton's method."""
        bits = flint.ctx.prec
        enough = bits // 2 + 32 + far
        while right < enough:
            right = min(2 * right, enough)
            with precision(min(bits, right + 32)):
                value, slope = self._value(x)
                correction = (value / slope).mid()
                if correction.is_finite():
                    x = (x - correction).mid()
        return x

    def _enclosed(self, x: arb, lower: arb, upper: arb) -> arb:
        """Return the root next to an exact point by one interval Newton step."""
        bits = flint.ctx.prec
        value, slope = self._value(x)
        few = min(bits, bits // 2 + 96)
        with precision(few):
            width = 2 * (abs(value) / abs(slope)).upper() + abs(x) * arb(2) ** -bits
        for _ in range(8):
            region = arb(x, width.upper())
            inside = region > lower and region < upper
            with precision(few):  # the step is as short as half of the bits: more of its slope would be lost in it
                derivative = self._value(region)[1]
            if inside and derivative < 0:
                step = x - value / derivative
                if region.contains_interior(step):
                    return step
            width = 4 * width
        raise undecided("existence of the guard's root near its approximation", x)


def _in_floats(record: Any) -> Any:
    """Return a record of balls in binary64."""
    floats = map(as_float, record)
    return type(record)._make(floats) if hasattr(record, "_make") else tuple(floats)
