"""python-flint balls: the rigorous arithmetic. Every number encloses the true one; comparisons mean "proven"."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

import flint
from flint import arb

from numerics.arithmetic.ball_contact import ball_contact
from numerics.arithmetic.newton import bracketed_newton
from numerics.arithmetic.protocol import Contact, Sign
from numerics.arithmetic.slip_contact import contact_by_root
from numerics.errors import EventUndecided

_BITS_PER_DIGIT = math.log2(10)
_START_BITS = 64


class Ball:
    """flint.arb balls with `digits` working decimal digits, behind the Arithmetic protocol."""

    name = "ball"

    def __init__(self, digits: int) -> None:
        """Fix the working precision in decimal digits."""
        self.digits = digits
        self.bits = math.ceil(digits * _BITS_PER_DIGIT) + 8

    @contextmanager
    def context(self) -> Iterator[None]:
        """Set flint's process-wide precision, and restore it whatever happens."""
        with _precision(self.bits):
            yield

    def number(self, value: Fraction | int) -> arb:
        """Return a ball that contains an exact rational."""
        if isinstance(value, int):
            return +arb(value)  # rounded, as a rational would be
        return arb(flint.fmpq(value.numerator, value.denominator))

    def sign(self, x: arb) -> Sign:
        """Return the proven sign of x; ZERO only for the exact zero; UNDECIDED if x straddles it or is not finite."""
        if x.is_finite():
            if x > 0:
                return Sign.POSITIVE
            if x < 0:
                return Sign.NEGATIVE
            if x.is_zero():
                return Sign.ZERO
        return Sign.UNDECIDED

    def ceiling(self, x: arb) -> int | None:
        """Return the least integer >= every point of x, None if the points of x do not agree on it."""
        if not x.is_finite():
            return None
        value = x.ceil().unique_fmpz()
        return None if value is None else int(value)

    def sqrt(self, x: arb) -> arb:
        """Return an enclosure of the square root of the points of x that are >= 0."""
        if x > 0 or x.is_zero() or not x.is_finite():
            return x.sqrt()
        # the ball max(x, 0) may dip below zero by its own rounding, where sqrt answers nan
        return arb(0).union(x.upper().max(arb(0)).sqrt())

    def exp(self, x: arb) -> arb:
        """Return an enclosure of e^x."""
        return x.exp()

    def expm1(self, x: arb) -> arb:
        """Return an enclosure of e^x - 1."""
        return x.expm1()

    def log(self, x: arb) -> arb:
        """Return an enclosure of the natural logarithm."""
        return x.log()

    def log1p(self, x: arb) -> arb:
        """Return an enclosure of the natural logarithm of 1 + x."""
        return x.log1p()

    def cos_sin(self, x: arb) -> tuple[arb, arb]:
        """Return enclosures of (cos x, sin x)."""
        sine, cosine = x.sin_cos()
        return cosine, sine

    def atan2(self, y: arb, x: arb) -> arb:
        """Return an enclosure of the angle of the point (x, y)."""
        return arb.atan2(y, x)

    def pi(self) -> arb:
        """Return an enclosure of pi."""
        return arb.pi()

    def versine(self, x: arb) -> arb:
        """Return an enclosure of 1 - cos x = 2 sin^2(x/2)."""
        half = (x / 2).sin()
        return 2 * half * half

    def sine_deficit(self, x: arb) -> arb:
        """Return an enclosure of x - sin x that is tight relative to its value (mean value form)."""
        return _mean_value(x, lambda p: p - p.sin(), self.versine, cancelled=2)

    def cosine_deficit(self, x: arb) -> arb:
        """Return an enclosure of x^2/2 - 1 + cos x that is tight relative to its value (mean value form)."""
        return _mean_value(x, lambda p: p * p / 2 - 1 + p.cos(), self.sine_deficit, cancelled=4)

    def lag(self, x: arb) -> arb:
        """Return an enclosure of sin x - x cos x that is tight relative to its value (mean value form)."""
        return _mean_value(x, lambda p: p.sin() - p * p.cos(), lambda p: p * p.sin(), cancelled=2)

    def rise(self, x: arb) -> arb:
        """Return an enclosure of (x - sin x)/(1 - cos x)."""
        return self.sine_deficit(x) / self.versine(x)

    def depth(self, x: arb) -> arb:
        """Return an enclosure of 2 - x cot(x/2) as 2 (sin - y cos)/sin at y = x/2."""
        return 2 * self.lag(x / 2) / (x / 2).sin()

    def root(
        self,
        function: Callable[[arb], arb],
        slope: Callable[[arb], arb],
        lower: arb,
        upper: arb,
        guess: float | None = None,
    ) -> arb:
        """Return an enclosure of the root, proved to exist and to be the only one between lower and upper.

        The function must be decreasing between lower and upper; its signs there are proved here, the root is
        approximated with doubling precision, and one interval Newton step encloses it.
        Raises EventUndecided if a sign, the slope or the inclusion is not proved at this precision.
        """
        for end, expected in ((lower, Sign.POSITIVE), (upper, Sign.NEGATIVE)):
            with _precision(min(self.bits, _START_BITS)):
                proved = self.sign(function(end)) is expected
            if not proved and self.sign(value := function(end)) is not expected:
                raise EventUndecided("sign of the guard at an end of its bracket", self.text(value), self.digits)
        if guess is not None and lower < guess < upper:
            try:
                return self._enclose(function, slope, self._refined(function, slope, arb(guess), 44), lower, upper)
            except EventUndecided:
                pass  # it was not as near as it should be
        try:
            return self._enclose(function, slope, self._approximate(function, slope, lower, upper), lower, upper)
        except EventUndecided:
            # close to a graze low precision cannot tell the root from the extremum: bracket at the full one instead
            x = _bracketed(function, slope, lower, upper, arb(2) ** (24 - self.bits))
            return self._enclose(function, slope, x, lower, upper)

    def _approximate(self, function: Any, slope: Any, lower: arb, upper: arb) -> arb:
        """Return an exact point near the root, to a little more than half of the bits: an interval step does the rest.

        Bracketed at low precision, then Newton's method with doubling precision.
        """
        # a root far from zero needs more: the guard varies over distances of order 1, and over its bracket
        size = _magnitude_bits(upper.mid())
        far = max(0, size, size - _magnitude_bits((upper - lower).mid()))
        start = min(self.bits, _START_BITS + far)
        with _precision(start):
            # a tolerance below the rounding of these few bits would never be met
            x = _bracketed(function, slope, lower, upper, arb(2) ** max(-40 - far, 12 - start))
        return self._refined(function, slope, x, 36 + far, far)

    def _refined(self, function: Any, slope: Any, x: arb, bits: int, far: int = 0) -> arb:
        """Return an exact point near the root from one that has so many right bits, by Newton's method."""
        enough = self.bits // 2 + 32 + far
        while bits < enough:
            bits = min(2 * bits, enough)
            with _precision(min(self.bits, bits + 32)):
                correction = (function(x) / slope(x)).mid()
                if correction.is_finite():
                    x = (x - correction).mid()
        return x

    def _enclose(self, function: Any, slope: Any, x: arb, lower: arb, upper: arb) -> arb:
        value = function(x)
        few = min(self.bits, self.bits // 2 + 96)
        with _precision(few):
            width = 2 * (abs(value) / abs(slope(x))).upper() + abs(x) * arb(2) ** -self.bits
        for _ in range(8):
            region = arb(x, width.upper())
            inside = region > lower and region < upper
            with _precision(few):  # the step is as short as half of the bits: more of its slope would be lost in it
                derivative = slope(region)
            if inside and derivative < 0:
                step = x - value / derivative
                if region.contains_interior(step):
                    return step
            width = 4 * width
        raise EventUndecided("existence of the guard's root near its approximation", self.text(x), self.digits)

    def contact(self, gap: arb, push: arb) -> Contact:
        """Return the enclosed end of a slip from S. Raises EventUndecided."""
        return ball_contact(gap, push) or contact_by_root(self, gap, push)

    def centre(self, x: arb) -> arb:
        """Return the midpoint of x."""
        return x.mid()

    def accumulate(self, total: arb, rest: arb, term: arb) -> tuple[arb, arb]:
        """Return the sum; its rounding is small enough."""
        return total + term, rest

    def mean_value(self, function: Callable[[arb], arb], slope: Callable[[arb], arb], x: arb) -> arb:
        """Return function(mid x) +- rad(x) max|slope(x)|, an enclosure of function(x) for a differentiable function."""
        if not x.is_finite():
            return function(x)
        return function(x.mid()) + arb(0, (x.rad() * abs(slope(x))).upper())

    def to_float(self, x: arb) -> float:
        """Return the binary64 number nearest to the midpoint of x."""
        return float(x.mid())

    def text(self, x: arb, digits: int = 6) -> str:
        """Return x as text with its radius."""
        return str(x.str(digits))


def _bracketed(function: Any, slope: Any, lower: arb, upper: arb, tolerance: arb) -> arb:
    """Return an exact point near the root, found with the midpoints of balls at the present precision."""
    middle = bracketed_newton(
        lambda p: function(p).mid(), lambda p: slope(p).mid(), lower.mid(), upper.mid(), tolerance
    )
    return middle.mid()


@contextmanager
def _precision(bits: int) -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = bits
    try:
        yield
    finally:
        flint.ctx.prec = before


def _mean_value(x: arb, function: Any, slope: Any, cancelled: int) -> arb:
    """Return function(mid x) +- rad(x) max|slope(x)|, the first with the bits that cancel near 0 added.

    Direct evaluation of x - sin x on a ball would double its radius; the true variation is only rad * (1 - cos x).
    """
    if not x.is_finite():
        return function(x)
    middle = x.mid()
    missing = max(0, -_magnitude_bits(middle))
    if missing > 64 * flint.ctx.prec:  # far below the working precision: the plain ball is honest and cheap
        return function(x)
    with _precision(flint.ctx.prec + cancelled * missing + 16):
        value = function(middle)
    radius = x.rad()
    return +value if radius.is_zero() else +value + arb(0, (radius * abs(slope(x))).upper())


def _magnitude_bits(x: arb) -> int:
    """Return e with |x| < 2^e and |x| >= 2^(e-2), for an exact finite x; 0 for zero."""
    if x.is_zero():
        return 0
    mantissa, exponent = x.man_exp()
    return int(abs(mantissa)).bit_length() + int(exponent)
