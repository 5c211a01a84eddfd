"""python-flint balls: the rigorous arithmetic. Every number encloses the true one; comparisons mean "proven"."""

from __future__ import annotations

import copyreg
import math
from collections.abc import Callable
from contextlib import AbstractContextManager
from fractions import Fraction

import flint
from flint import acb, arb, arb_mat, arb_poly

from numerics.arithmetic.precision import precision
from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import EventUndecided

BITS_PER_DIGIT = math.log2(10)
GUARD_BITS = 8
_RADIUS_BITS = 30
EXACT = 10**9
"""Stands for "all digits": the number is exact."""
atan2, sine_cosine, midpoint = arb.atan2, arb.sin_cos, arb.mid


def working_digits() -> int:
    """Return the decimal digits of flint's present precision."""
    return math.floor((flint.ctx.prec - GUARD_BITS) / BITS_PER_DIGIT)


def as_float(x: arb) -> float:
    """Return the binary64 number nearest to the midpoint of x."""
    return float(x.mid())


def two_pi(x: arb) -> arb:  # noqa: ARG001
    """Return an enclosure of 2 pi."""
    return 2 * arb.pi()


def tolerance(x: arb) -> arb:  # noqa: ARG001
    """Return the relative step at which a search among midpoints ends."""
    return arb(2) ** (24 - flint.ctx.prec)


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
    return mean_value(lambda p: p - p.sin(), versine, x, cancelled=2)


def depth_and_cotangent(x: arb) -> tuple[arb, arb]:
    """Return enclosures of c = 2 - x cot(x/2) and cot(x/2), for 0 < x < 2 pi; c' = (x - sin x)/(1 - cos x)."""
    depth = mean_value(lambda p: 2 - p * (p / 2).cot(), lambda p: sine_deficit(p) / versine(p), x, cancelled=2)
    return depth, (x / 2).cot()


def mean_value(function: Callable[[arb], arb], slope: Callable[[arb], arb], x: arb, cancelled: int = 0) -> arb:
    """Return function(mid x) +- rad(x) max|slope(x)|, an enclosure of function(x) for a differentiable function.

    The first with the bits added that cancel near 0, `cancelled` for each one that |x| is below 1. Direct evaluation of
    x - sin x on a ball would double its radius; the true variation is only rad * (1 - cos x).
    """
    if not x.is_finite():
        return function(x)
    middle = x.mid()
    missing = cancelled * max(0, -magnitude_bits(middle))
    if missing > 64 * cancelled * flint.ctx.prec:  # far below the working precision: the plain ball is honest and cheap
        return function(x)
    with precision(flint.ctx.prec + missing + (16 if cancelled else 0)):
        value = function(middle)
    return +value if x.is_exact() else widened(+value, x.rad() * slope(x))


def magnitude_bits(x: arb) -> int:
    """Return e with |x| < 2^e and |x| >= 2^(e-3), for an exact finite x; 0 for zero."""
    near = float(x)
    if near and near - near == 0.0:  # neither below nor above the range of binary64
        return math.frexp(near)[1] + 1
    if x.is_zero():
        return 0
    mantissa, exponent = x.man_exp()
    return int(abs(mantissa)).bit_length() + int(exponent)


def require_phase(angle: arb) -> None:
    """Do nothing: a phase that is lost shows in the radius."""


def proved_sign(x: arb, question: str) -> int:
    """Return the sign of x, 0 only for the exact zero; raises EventUndecided(question) if x straddles it."""
    if x.is_finite():
        if x > 0:
            return 1
        if x < 0:
            return -1
        if x.is_zero():
            return 0
    raise undecided(question, x)


sign = proved_sign


def undecided(question: str, found: arb | str) -> EventUndecided:
    """Return what says that a ball, or what was found, leaves a question open at the present precision."""
    return EventUndecided(question, found if isinstance(found, str) else str(found.str(6)), working_digits())


def ceiling(x: arb, question: str) -> int:
    """Return the least whole number >= every point of x, 0 for x <= 0; raises EventUndecided if they do not agree."""
    if x <= 0:
        return 0
    value = x.ceil().unique_fmpz() if x.is_finite() else None
    if value is None:
        raise undecided(question, x)
    return max(0, int(value))


def digits_within(error: arb, value: arb, scale: arb) -> int:
    """Return how many leading digits an error leaves right, relative to |value|.

    A value that may be 0 has none, unless it is below 10^(-4 n) of its `scale`: then it counts as 0 to n digits.
    """
    if error.is_zero():
        return EXACT
    if not (error.is_finite() and value.is_finite()):
        return 0
    size = scale if value.contains(0) else abs(value)
    ratio = error.upper() / size.lower()
    if not ratio > 0 or not ratio.is_finite():
        return 0
    # log10 through exponent and mantissa: the ratio itself may be far below the range of a float
    digits = max(0, math.floor(-float((ratio.log() / arb(10).log()).mid())))
    return digits // 4 if value.contains(0) else digits


def exact_middle(x: arb) -> Fraction:
    """Return the midpoint of a ball, exact."""
    middle = x.mid().fmpq()
    return Fraction(int(middle.p), int(middle.q))


Parts = tuple[int, int] | float
"""Mantissa and exponent of a point; of what is not finite a float."""


def ball_of(middle: Parts, radius: Parts) -> arb:
    """Return the ball with this midpoint and this radius, the very same one as that of which these are the parts."""
    if isinstance(radius, tuple) and radius[0]:
        # a radius is rounded up to the next of 30 bits, even if it has no more: it comes back from just below
        shift = _RADIUS_BITS + 1 - radius[0].bit_length()
        radius = (radius[0] << shift) - 1, radius[1] - shift
    return arb(arb(middle), arb(radius))


def parts_of(x: arb) -> tuple[Parts, Parts]:
    """Return what `ball_of` makes a ball of."""
    return _parts(x.mid()), _parts(x.rad())


def _parts(x: arb) -> Parts:
    if not x.is_finite():
        return float(x)
    mantissa, exponent = x.man_exp()
    return int(mantissa), int(exponent)


# python-flint has no pickles of its own: with these every answer can be copied, and sent to another process
copyreg.pickle(arb, lambda x: (ball_of, parts_of(x)))
copyreg.pickle(acb, lambda x: (acb, (x.real, x.imag)))
copyreg.pickle(arb_poly, lambda x: (arb_poly, (x.coeffs(),)))
copyreg.pickle(arb_mat, lambda x: (arb_mat, (x.tolist(),)))


def widened(x: arb, by: arb) -> arb:
    """Return a ball that holds all points within `by` of those of x."""
    return x + arb(0, by.abs_upper())


class Ball(Arithmetic):
    """flint.arb balls with `digits` working decimal digits."""

    name = "ball"
    to_float = staticmethod(as_float)

    def __init__(self, digits: int, radius: arb | int = 0) -> None:
        """Fix the working precision in decimal digits.

        With a `radius` (m and m/s) the engine (enclosed.py) follows at once all motions that start within it.
        """
        self.digits, self.radius = digits, arb(radius)
        self.bits = math.ceil(digits * BITS_PER_DIGIT) + GUARD_BITS

    def context(self) -> AbstractContextManager[None]:
        """Return the context of this precision (precision.py)."""
        return precision(self.bits)

    @staticmethod
    def number(value: Fraction | int) -> arb:
        """Return a ball that contains an exact rational."""
        if isinstance(value, int):
            return +arb(value)  # rounded, as a rational would be
        return arb(flint.fmpq(value.numerator, value.denominator))

    def text(self, x: arb, digits: int = 6) -> str:
        """Return x as text with its radius."""
        return str(x.str(digits))
