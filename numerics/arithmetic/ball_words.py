"""The words of python-flint balls (words.py): every number encloses the true one; comparisons mean "proven"."""

from __future__ import annotations

import math
import operator
import sys
from collections.abc import Callable

import flint
from flint import arb

from numerics.arithmetic import float64
from numerics.arithmetic.questions import QUESTIONS
from numerics.arithmetic.telling import Telling
from numerics.arithmetic.words import words_of
from numerics.errors import EventUndecided

ZERO, UNIT, WIDTH = arb(0), 0.0, 1
BITS_PER_DIGIT = math.log2(10)
GUARD_BITS = 8
leading = part = operator.pos
put = float64.put
exp, expm1, log, log1p, sin, atan2 = arb.exp, arb.expm1, arb.log, arb.log1p, arb.sin, arb.atan2
sine_cosine, half_turn, size, finite = arb.sin_cos, arb.pi, arb.__abs__, arb.is_finite


def working_digits() -> int:
    """Return the decimal digits of flint's present precision."""
    return math.floor((flint.ctx.prec - GUARD_BITS) / BITS_PER_DIGIT)


class precision:  # noqa: N801 - read as a verb, like the context managers of contextlib, at a third of their cost
    """Set flint's process-wide precision, and restore it whatever happens."""

    __slots__ = ("before", "bits")

    def __init__(self, bits: int) -> None:
        """Keep the precision that is to be set."""
        self.bits = bits

    def __enter__(self) -> None:
        """Set it."""
        self.before = flint.ctx.prec
        flint.ctx.prec = self.bits

    def __exit__(self, *_: object) -> None:
        """Restore what was set before."""
        flint.ctx.prec = self.before


def exactly(n: float) -> arb:
    """Return a small whole number, or a power of 2, as a number."""
    return arb(n)


def undefined() -> arb:
    """Return what stands for a number that left the range."""
    return arb.nan()


def infinite() -> arb:
    """Return infinity."""
    return arb.pos_inf()


def turn() -> arb:
    """Return an enclosure of 2 pi."""
    return 2 * arb.pi()


def signed(side: float, x: arb) -> arb:
    """Return side x, for side = -1.0 or +1.0."""
    return x if side > 0.0 else -x


def sqrt(x: arb) -> arb:
    """Return an enclosure of the square root of the points of x that are >= 0."""
    if x > 0 or x.is_zero() or not x.is_finite():
        return x.sqrt()
    # the ball max(x, 0) may dip below zero by its own rounding, where sqrt answers nan
    return arb(0).union(x.upper().max(arb(0)).sqrt())


def versine(x: arb) -> arb:
    """Return an enclosure of 1 - cos x = 2 sin^2(x/2)."""
    half = (x / 2).sin()
    return 2 * half * half


def sine_deficit(x: arb) -> arb:
    """Return an enclosure of x - sin x that is tight relative to its value (mean value form)."""
    return _centred(x, lambda p: p - p.sin(), versine, cancelled=2)


def cosine_deficit(x: arb) -> arb:
    """Return an enclosure of x^2/2 - 1 + cos x that is tight relative to its value (mean value form)."""
    return _centred(x, lambda p: p * p / 2 - 1 + p.cos(), sine_deficit, cancelled=4)


def depth_and_cotangent(x: arb) -> tuple[arb, arb]:
    """Return enclosures of c = 2 - x cot(x/2) and cot(x/2), for 0 < x < 2 pi; c' = (x - sin x)/(1 - cos x)."""
    middle, bits = x.mid(), flint.ctx.prec
    try:
        flint.ctx.prec = bits + 2 * max(0, -magnitude_bits(middle)) + 16
        sine, cosine = (middle / 2).sin_cos()
        cotangent = cosine / sine
        value = 2 - middle * cotangent
    finally:
        flint.ctx.prec = bits
    radius = x.rad()
    if radius.is_zero():
        return value, cotangent
    value = value + arb(0, (radius * abs(sine_deficit(x) / versine(x))).upper())
    return value, (x / 2).cot()


def mean_value(function: Callable[[arb], arb], slope: Callable[[arb], arb], x: arb) -> arb:
    """Return function(mid x) +- rad(x) max|slope(x)|, an enclosure of function(x) for a differentiable function."""
    if not x.is_finite():
        return function(x)
    return function(x.mid()) + arb(0, (x.rad() * abs(slope(x))).upper())


def _centred(x: arb, function: Callable[[arb], arb], slope: Callable[[arb], arb], cancelled: int) -> arb:
    """Return function(mid x) +- rad(x) max|slope(x)|, the first with the bits that cancel near 0 added.

    Direct evaluation of x - sin x on a ball would double its radius; the true variation is only rad * (1 - cos x).
    """
    if not x.is_finite():
        return function(x)
    middle = x.mid()
    missing = max(0, -magnitude_bits(middle))
    if missing > 64 * flint.ctx.prec:  # far below the working precision: the plain ball is honest and cheap
        return function(x)
    with precision(flint.ctx.prec + cancelled * missing + 16):
        value = function(middle)
    radius = x.rad()
    return +value if radius.is_zero() else +value + arb(0, (radius * abs(slope(x))).upper())


def magnitude_bits(x: arb) -> int:
    """Return e with |x| < 2^e and |x| >= 2^(e-3), for an exact finite x; 0 for zero."""
    near = float(x)
    if near and near - near == 0.0:  # neither below nor above the range of binary64
        return math.frexp(near)[1] + 1
    if x.is_zero():
        return 0
    mantissa, exponent = x.man_exp()
    return int(abs(mantissa)).bit_length() + int(exponent)


def sign(x: arb, question: int) -> int:
    """Return the proven sign of x, 0 only for the exact zero; raises EventUndecided if x straddles it."""
    if x.is_finite():
        if x > 0:
            return 1
        if x < 0:
            return -1
        if x.is_zero():
            return 0
    raise EventUndecided(QUESTIONS[question], str(x.str(6)), working_digits())


def positive(x: arb) -> bool:
    """Return whether x > 0 is proved."""
    return bool(x.is_finite() and x > 0)


def below(x: arb, y: arb) -> bool:
    """Return whether x < y is proved."""
    return bool(x < y)


def rough(x: arb) -> float:
    """Return the binary64 number nearest to the midpoint of x."""
    return float(x.mid())


def tolerance() -> arb:
    """Return the relative step at which a search among midpoints ends."""
    return arb(2) ** (24 - flint.ctx.prec)


def settled() -> arb:
    """Return the relative step after which Newton's next one is the last."""
    return arb(2) ** (10 - flint.ctx.prec // 2)


def fading() -> float:
    """Return after how many decay times an oscillation has died away below the last digit."""
    return math.inf


def resolved(angle: arb) -> bool:
    """Return True: a phase that is lost shows in the radius."""
    return bool(angle.is_finite())


def ceiling(x: arb, question: int) -> int:
    """Return the least whole number >= every point of x, 0 for x <= 0; raises EventUndecided if they do not agree."""
    if x <= 0:
        return 0
    value = x.ceil().unique_fmpz() if x.is_finite() else None
    if value is None:
        raise EventUndecided(QUESTIONS[question], str(x.str(6)), working_digits())
    return max(0, int(value))


def nonnegative(x: arb) -> arb:
    """Return an enclosure of max(x, 0)."""
    return x.max(ZERO)


def middle(x: arb) -> arb:
    """Return the midpoint, an exact ball."""
    return x.mid()


def spread(x: arb) -> arb:
    """Return the radius, an exact ball."""
    return x.rad()


def widened(x: arb, by: arb) -> arb:
    """Return a ball that holds all points within `by` of those of x."""
    return x + arb(0, abs(by).upper())


def clock(total: arb, rest: arb, term: arb) -> tuple[arb, arb]:
    """Return the sum; its rounding is small enough."""
    return total + term, rest


BALL = Telling("ball", words_of(sys.modules[__name__]), words_of(float64))
