"""The root of a falling function in balls: proved to exist, and to be the only one in its bracket."""

from __future__ import annotations

from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball_words import BALL, magnitude_bits, positive, precision, rough, working_digits
from numerics.arithmetic.float64 import FLOAT64
from numerics.arithmetic.telling import text_of
from numerics.contact.root import Pair, root_of
from numerics.errors import EventUndecided

_START_BITS, _SEED_BITS = 64, 44


class EnclosedRoot:
    """The text `root` of one function, in balls: a search among points, and a proof."""

    def __init__(self, pair: Pair) -> None:
        """Take a function that is told in balls: its value and its slope."""
        self._pair = pair
        self._in_floats = FLOAT64(root_of(text_of(pair), "root_in_floats"))
        self._among_points = BALL(root_of(_points_of(pair), "root_among_points"))

    def __call__(self, at: Any, lower: arb, upper: arb, guess: arb) -> arb:  # noqa: ARG002 - binary64 guesses better
        """Return an enclosure of the root, proved to exist and to be the only one between lower and upper.

        The function must fall between lower and upper; its signs there are proved here, the root is approximated with
        doubling precision, and one interval Newton step encloses it.
        Raises EventUndecided if a sign, the slope or the inclusion is not proved at this precision.
        """
        for end, side in ((lower, 1), (upper, -1)):
            self._prove_sign(at, end, side)
        near = self._guess(at, lower, upper)
        if lower < near < upper:
            try:
                return self._enclosed(at, self._refined(at, near, _SEED_BITS), lower, upper)
            except EventUndecided:
                pass  # it was not as near as it should be
        try:
            return self._enclosed(at, self._approximate(at, lower, upper), lower, upper)
        except EventUndecided:
            # close to a graze low precision cannot tell the root from the extremum: search at the full one instead
            return self._enclosed(at, self._searched(at, lower, upper), lower, upper)

    def _prove_sign(self, at: Any, end: arb, side: int) -> None:
        with precision(min(flint.ctx.prec, _START_BITS)):
            if positive(side * self._pair(at, end)[0]):
                return
        value = self._pair(at, end)[0]
        if not positive(side * value):
            raise _undecided("sign of the guard at an end of its bracket", value)

    def _guess(self, at: Any, lower: arb, upper: arb) -> arb:
        """Return the root that binary64 finds, an exact point; nan where it has no digits for it."""
        ends, record = (rough(lower), rough(upper)), _roughly(at)
        if not all(1e-9 < abs(one) < 1e4 for one in (*_numbers(record), *ends) if one):
            return arb.nan()
        try:
            return arb(self._in_floats(record, *ends, (ends[0] + ends[1]) / 2))
        except (ArithmeticError, ValueError):
            return arb.nan()

    def _approximate(self, at: Any, lower: arb, upper: arb) -> arb:
        """Return an exact point near the root, to a little more than half of the bits: an interval step does the rest.

        Searched at low precision, then Newton's method with doubling precision.
        """
        # a root far from zero needs more: the guard varies over distances of order 1, and over its bracket
        size = magnitude_bits(upper.mid())
        far = max(0, size, size - magnitude_bits((upper - lower).mid()))
        with precision(min(flint.ctx.prec, _START_BITS + far)):
            x = self._searched(at, lower, upper)
        return self._refined(at, x, 36 + far, far)

    def _searched(self, at: Any, lower: arb, upper: arb) -> arb:
        """Return an exact point near the root, found among points at the present precision."""
        lower, upper = lower.mid(), upper.mid()
        return self._among_points(at, lower, upper, ((lower + upper) / 2).mid()).mid()

    def _refined(self, at: Any, x: arb, right: int, far: int = 0) -> arb:
        """Return an exact point near the root from one that has so many right bits, by Newton's method."""
        bits = flint.ctx.prec
        enough = bits // 2 + 32 + far
        while right < enough:
            right = min(2 * right, enough)
            with precision(min(bits, right + 32)):
                value, slope = self._pair(at, x)
                correction = (value / slope).mid()
                if correction.is_finite():
                    x = (x - correction).mid()
        return x

    def _enclosed(self, at: Any, x: arb, lower: arb, upper: arb) -> arb:
        """Return the root next to an exact point by one interval Newton step."""
        bits = flint.ctx.prec
        value, slope = self._pair(at, x)
        few = min(bits, bits // 2 + 96)
        with precision(few):
            width = 2 * (abs(value) / abs(slope)).upper() + abs(x) * arb(2) ** -bits
        for _ in range(8):
            region = arb(x, width.upper())
            inside = region > lower and region < upper
            with precision(few):  # the step is as short as half of the bits: more of its slope would be lost in it
                derivative = self._pair(at, region)[1]
            if inside and derivative < 0:
                step = x - value / derivative
                if region.contains_interior(step):
                    return step
            width = 4 * width
        raise _undecided("existence of the guard's root near its approximation", x)


def _points_of(pair: Pair) -> Pair:
    """Return the same function, its values and slopes as exact points."""

    def points(at: Any, x: arb) -> tuple[arb, arb]:
        value, slope = pair(at, x)
        return value.mid(), slope.mid()

    return points


def _roughly(record: Any) -> Any:
    """Return a record with binary64 numbers in the place of balls."""
    if isinstance(record, arb):
        return rough(record)
    make = getattr(type(record), "_make", tuple)
    return make(_roughly(one) for one in record) if isinstance(record, tuple) else record


def _numbers(record: Any) -> list[float]:
    if isinstance(record, tuple):
        return [number for one in record for number in _numbers(one)]
    return [record] if isinstance(record, float) else []


def _undecided(question: str, value: arb) -> EventUndecided:
    return EventUndecided(question, str(value.str(6)), working_digits())
