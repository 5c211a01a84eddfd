"""The functions of binary64 numbers (functions.py): each to a few units in the last place (ulp).

The bounds count u = 2^-53 for each rounding, 1.1 u for a sine or cosine of the C library (0.55 ulp); an error of e u
before the last rounding is at most e ulp of the result, and the last rounding adds 0.5 ulp.
"""

from __future__ import annotations

import math
from fractions import Fraction

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.pair import two_sum

UNIT = 2.0**-53
"""What errors are counted in, relative to the result."""
LONGEST, SHORTEST = 1e12, 1e-97
"""Angles that binary64 resolves: beyond the first no phase is left, below the second the cube has no digits."""
sqrt, atan2, finite = math.sqrt, math.atan2, math.isfinite
_SERIES_BELOW = 1.2
"""From 1.2 on x - sin x loses less than two bits, and the subtraction itself next to nothing."""
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
DEPTH_SERIES = _depth_series(34)
"""Its radius of convergence is 2 pi: 34 terms leave out less than 2^-60 of the first below 3, 27 less than 2^-110 below
1.5."""
_DEPTH = tuple(tuple(float(one) for one in DEPTH_SERIES[first::4][::-1]) for first in range(4))


@compilable
def horner(coefficients: tuple[float, ...], x: float) -> float:
    """Return the polynomial with these coefficients, the highest power first."""
    total = 0.0
    for coefficient in coefficients:
        total = total * x + coefficient
    return total


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
def depth_and_cotangent(x: float) -> tuple[float, float]:
    """Return 2 - x cot(x/2) and cot(x/2), for 0 < x <= 2 pi - 1; by the series x^2/6 + x^4/360 + ... for x < 3.

    The first is within 3.4 ulp: x^2 1 u, the last addition 1 u, the rounded 1/6 0.4 u, the further terms at most 0.16
    of 3 u. From 3 on within 4 ulp: sin - (x/2) cos at most 2.5 u, the other sine 1.1 u. Normal from x = 1e-153 on.
    """
    if x < _QUOTIENT_SERIES_BELOW:
        # four chains of operations, which a processor runs side by side
        square = x * x
        fourth = square * square
        eighth = fourth * fourth
        early = horner(_DEPTH[0], eighth), horner(_DEPTH[1], eighth)
        late = horner(_DEPTH[2], eighth), horner(_DEPTH[3], eighth)
        value = square * (early[0] + (square * early[1] + fourth * (late[0] + square * late[1])))
    else:
        half = 0.5 * x
        value = 2.0 * (math.sin(half) - half * math.cos(half)) / math.sin(half)
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
def tolerance(x: float) -> float:  # noqa: ARG001
    """Return the relative step at which a search ends."""
    return UNIT
