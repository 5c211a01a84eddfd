"""The functions of binary64 numbers (functions.py): each to a few units in the last place (ulp).

The bounds count u = 2^-53 for each rounding, 1.1 u for a sine or cosine of the C library (0.55 ulp); an error of e u
before the last rounding is at most e ulp of the result, and the last rounding adds 0.5 ulp.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.pair import two_product, two_sum

UNIT = 2.0**-53
"""What errors are counted in, relative to the result."""
LONGEST, SHORTEST = 1e12, 1e-97
"""Angles that binary64 resolves: beyond the first no phase is left, below the second the cube has no digits."""
sqrt, sin, atan2, finite = math.sqrt, math.sin, math.atan2, math.isfinite
_SERIES_BELOW = 1.2
"""From 1.2 on x - sin x loses less than two bits, and the subtraction itself next to nothing."""
_COSINE_SERIES_BELOW = 2.0
_QUOTIENT_SERIES_BELOW = 3.0


def _depth_series(order: int) -> list[Fraction]:
    """Return c_1, c_2, ... of c(x) = 2 - x cot(x/2) = sum c_k x^(2k); x c' + c = (x^2 + c^2)/2 gives them, all > 0."""
    terms = [Fraction(1, 6)]
    for k in range(2, order + 1):
        square = sum((terms[i] * terms[-1 - i] for i in range(k - 1)), Fraction(0))
        terms.append(square / (2 * (2 * k + 1)))
    return terms


# Coefficients run from the highest power of x^2 down. Of the alternating series, what is left out after 12 terms is
# below 2^-70 of the leading term.
_SINE_TERMS = tuple((-1) ** k * 6 / math.factorial(2 * k + 5) for k in reversed(range(12)))
_COSINE_TERMS = tuple((-1) ** k * 24 / math.factorial(2 * k + 6) for k in reversed(range(12)))
# The radius of convergence of the quotients is 2 pi: 14 terms below 1.2, 20 below 2 and 34 below 3 leave out less than
# 2^-60 of the first.
DEPTH_SERIES = _depth_series(34)


def _quotient(terms: list[Fraction]) -> tuple[Any, ...]:
    """Return the first 14, 20 and 34 terms of a series: those of even and of odd powers, the highest first."""
    floats = [float(one) for one in terms]
    return tuple((tuple(floats[:n:2][::-1]), tuple(floats[1:n:2][::-1])) for n in (14, 20, 34))


_DEPTH = _quotient(DEPTH_SERIES)
_RISE = _quotient([2 * k * term for k, term in enumerate(DEPTH_SERIES, start=1)])


@compilable
def horner(coefficients: tuple[float, ...], x: float) -> float:
    """Return the polynomial with these coefficients, the highest power first."""
    total = 0.0
    for coefficient in coefficients:
        total = total * x + coefficient
    return total


@compilable
def two_horners(terms: tuple[tuple[float, ...], tuple[float, ...]], x: float) -> float:
    """Return the polynomial with these even and odd coefficients: two chains that a processor runs side by side."""
    square = x * x
    return horner(terms[0], square) + x * horner(terms[1], square)


@compilable
def _quotient_series(terms: tuple[Any, ...], x: float) -> float:
    """Return the series of a quotient at x < 3 over its power before the sum, from as few terms as x allows."""
    if x < 1.2:
        return two_horners(terms[0], x * x)
    if x < 2.0:
        return two_horners(terms[1], x * x)
    return two_horners(terms[2], x * x)


@compilable
def versine(x: float) -> float:
    """Return 1 - cos x as 2 sin^2(x/2), which does not cancel.

    Within 2.1 ulp: for a sine of mantissa m its square has the error (2.2/m + 0.5) u. Normal from |x| = 1e-153 on.
    """
    half = math.sin(0.5 * x)
    return 2.0 * half * half


@compilable
def sine_deficit(x: float) -> float:
    """Return x - sin x; by its series x^3 (1 - x^2/20 + ...)/6 for |x| < 1.2. Normal from |x| = 1e-102 on.

    Within 3.8 ulp: x^3 has 2 u, the terms below it weigh 0.072 with 4 u, their subtraction adds 1 u. From 1.2 on
    within 1.6 ulp: sin x errs by 0.55 ulp of a number below 1, the value is above 1/4.
    """
    if abs(x) >= _SERIES_BELOW:
        return x - math.sin(x)
    square = x * x
    cube = square * x
    return (cube - cube * (square * horner(_SINE_TERMS, square))) / 6.0


@compilable
def cosine_deficit(x: float) -> float:
    """Return x^2/2 - 1 + cos x; by its series x^4 (1 - x^2/30 + ...)/24 for |x| < 2. Normal from |x| = 1e-76 on.

    Within 3.1 ulp: x^4 would inherit 2 u from x^2, whose rounding error is therefore put back; then its own
    rounding 1 u, the terms below it 0.134 of 4 u, their subtraction 1 u. From 2 on within 2.9 ulp: the
    rounding of x^2 is at most 2 ulp of the value, the subtraction of 1 is exact, cos x errs by 0.3 ulp of it.
    """
    square = x * x
    if abs(x) >= _COSINE_SERIES_BELOW:
        return (0.5 * square - 1.0) + math.cos(x)
    fourth, lower = square * square, square * horner(_COSINE_TERMS, square)
    return (fourth - (fourth * lower - 2.0 * square * two_product(x, x).low)) / 24.0


@compilable
def rise(x: float) -> float:
    """Return (x - sin x)/(1 - cos x); by its series x (1/3 + x^2/90 + ...) for x < 3. All its terms are > 0.

    Within 2.8 ulp: the last addition 1 u, the rounded 1/3 0.4 u, the further terms at most 0.3 of 3 u. From 3 on
    within 4 ulp: numerator 1.2 u, 1 - cos at most 3.2 u and 2.4 u where the quotient's mantissa is near 2.
    """
    if x < _QUOTIENT_SERIES_BELOW:
        return x * _quotient_series(_RISE, x)
    return (x - math.sin(x)) / versine(x)


@compilable
def depth(x: float) -> float:
    """Return 2 - x cot(x/2); by its series x^2/6 + x^4/360 + ... for x < 3. All its terms are > 0.

    Within 3.4 ulp: x^2 1 u, the last addition 1 u, the rounded 1/6 0.4 u, the further terms at most 0.16 of 3 u.
    From 3 on within 4 ulp: sin - (x/2) cos at most 2.5 u, the other sine 1.1 u. Normal from x = 1e-153 on.
    """
    if x < _QUOTIENT_SERIES_BELOW:
        return x * x * _quotient_series(_DEPTH, x)
    half = 0.5 * x
    return 2.0 * (math.sin(half) - half * math.cos(half)) / math.sin(half)


@compilable
def depth_and_cotangent(x: float) -> tuple[float, float]:
    """Return 2 - x cot(x/2) and cot(x/2), for 0 < x <= 2 pi - 1."""
    value = depth(x)
    return value, (2.0 - value) / x


@compilable
def clock(total: float, rest: float, term: float) -> tuple[float, float]:
    """Return total + rest + term, rounded, and what the rounding left out."""
    total, rest = two_sum(total, term + rest)
    return total, rest


@compilable
def like(x: float, value: float) -> float:  # noqa: ARG001
    """Return a float as a number."""
    return value


@compilable
def as_float(x: float) -> float:
    """Return x."""
    return x


@compilable
def rounding(x: float) -> float:  # noqa: ARG001
    """Return the unit of errors."""
    return UNIT


@compilable
def two_pi(x: float) -> float:  # noqa: ARG001
    """Return 2 pi."""
    return 2.0 * math.pi


@compilable
def sine_cosine(x: float) -> tuple[float, float]:
    """Return (sin x, cos x)."""
    return math.sin(x), math.cos(x)


@compilable
def sign(x: float, question: int) -> int:  # noqa: ARG001
    """Return the sign of x; 0 for nan."""
    return 1 if x > 0.0 else (-1 if x < 0.0 else 0)


@compilable
def resolved(angle: float) -> bool:
    """Return whether 53 bits keep the phase of an angle > 0, and its cube has digits; False for nan."""
    return SHORTEST <= angle <= LONGEST


@compilable
def ceiling(x: float, question: int) -> int:  # noqa: ARG001
    """Return the least whole number >= x, 0 for x <= 0."""
    return math.ceil(x) if x > 0.0 else 0


@compilable
def nonnegative(x: float) -> float:
    """Return max(x, 0)."""
    return max(x, 0.0)


@compilable
def tolerance(x: float) -> float:  # noqa: ARG001
    """Return the relative step at which a search ends."""
    return UNIT
