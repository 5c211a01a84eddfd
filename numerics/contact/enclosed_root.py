"""The root of a falling function in balls: proved to exist, and to be the only one in its bracket."""

from __future__ import annotations

from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball import BALL, magnitude_bits, positive, precision, rough, working_digits
from numerics.arithmetic.float64 import FLOAT64
from numerics.arithmetic.telling import text_of
from numerics.contact.root import Pair, root
from numerics.errors import EventUndecided

_START_BITS = 64
_SEED_BITS = 44


def ball_guess(pair: Pair, at: Any, lower: arb, upper: arb) -> arb:
    """Return the root that binary64 finds, an exact point; nan where it has no digits for it."""
    ends, record = (rough(lower), rough(upper)), _roughly(at)
    if not all(1e-9 < abs(one) < 1e4 for one in (*_numbers(record), *ends) if one):
        return arb.nan()
    try:
        return arb(FLOAT64(root)(FLOAT64(text_of(pair)), record, *ends, (ends[0] + ends[1]) / 2))
    except (ArithmeticError, ValueError):
        return arb.nan()


def _roughly(record: Any) -> Any:
    """Return a record with binary64 numbers in the place of balls."""
    if isinstance(record, arb):
        return rough(record)
    return type(record)._make(_roughly(one) for one in record) if isinstance(record, tuple) else record


def _numbers(record: Any) -> list[float]:
    if isinstance(record, tuple):
        return [number for one in record for number in _numbers(one)]
    return [record] if isinstance(record, float) else []


def enclosed_root(pair: Pair, at: Any, lower: arb, upper: arb, guess: arb) -> arb:
    """Return an enclosure of the root, proved to exist and to be the only one between lower and upper.

    The function must fall between lower and upper; its signs there are proved here, the root is approximated with
    doubling precision, and one interval Newton step encloses it.
    Raises EventUndecided if a sign, the slope or the inclusion is not proved at this precision.
    """
    bits = flint.ctx.prec
    for end, side in ((lower, 1), (upper, -1)):
        with precision(min(bits, _START_BITS)):
            proved = positive(side * pair(at, end)[0])
        if not proved and not positive(side * (value := pair(at, end)[0])):
            raise _undecided("sign of the guard at an end of its bracket", value)
    if lower < guess < upper:
        try:
            return _enclosed(pair, at, _refined(pair, at, guess, _SEED_BITS), lower, upper)
        except EventUndecided:
            pass  # it was not as near as it should be
    try:
        return _enclosed(pair, at, _approximate(pair, at, lower, upper), lower, upper)
    except EventUndecided:
        # close to a graze low precision cannot tell the root from the extremum: bracket at the full one instead
        return _enclosed(pair, at, _bracketed(pair, at, lower, upper), lower, upper)


def _undecided(question: str, value: arb) -> EventUndecided:
    return EventUndecided(question, str(value.str(6)), working_digits())


def _bracketed(pair: Pair, at: Any, lower: arb, upper: arb) -> arb:
    """Return an exact point near the root, found with the midpoints of balls at the present precision."""

    def middles(_: Any, x: arb) -> tuple[arb, arb]:
        value, slope = pair(at, x)
        return value.mid(), slope.mid()

    lower, upper = lower.mid(), upper.mid()
    return BALL(root)(middles, at, lower, upper, ((lower + upper) / 2).mid()).mid()


def _approximate(pair: Pair, at: Any, lower: arb, upper: arb) -> arb:
    """Return an exact point near the root, to a little more than half of the bits: an interval step does the rest.

    Bracketed at low precision, then Newton's method with doubling precision.
    """
    # a root far from zero needs more: the guard varies over distances of order 1, and over its bracket
    size = magnitude_bits(upper.mid())
    far = max(0, size, size - magnitude_bits((upper - lower).mid()))
    with precision(min(flint.ctx.prec, _START_BITS + far)):
        x = _bracketed(pair, at, lower, upper)
    return _refined(pair, at, x, 36 + far, far)


def _refined(pair: Pair, at: Any, x: arb, right: int, far: int = 0) -> arb:
    """Return an exact point near the root from one that has so many right bits, by Newton's method."""
    bits = flint.ctx.prec
    enough = bits // 2 + 32 + far
    while right < enough:
        right = min(2 * right, enough)
        with precision(min(bits, right + 32)):
            value, slope = pair(at, x)
            correction = (value / slope).mid()
            if correction.is_finite():
                x = (x - correction).mid()
    return x


def _enclosed(pair: Pair, at: Any, x: arb, lower: arb, upper: arb) -> arb:
    """Return the root next to an exact point by one interval Newton step."""
    bits = flint.ctx.prec
    value, slope = pair(at, x)
    few = min(bits, bits // 2 + 96)
    with precision(few):
        width = 2 * (abs(value) / abs(slope)).upper() + abs(x) * arb(2) ** -bits
    for _ in range(8):
        region = arb(x, width.upper())
        inside = region > lower and region < upper
        with precision(few):  # the step is as short as half of the bits: more of its slope would be lost in it
            derivative = pair(at, region)[1]
        if inside and derivative < 0:
            step = x - value / derivative
            if region.contains_interior(step):
                return step
        width = 4 * width
    raise _undecided("existence of the guard's root near its approximation", x)
