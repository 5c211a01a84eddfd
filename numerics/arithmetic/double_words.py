"""The words of double-double (words.py): texts told with numbers of 31 digits, interpreted or compiled."""

from __future__ import annotations

import math
import sys
from typing import Any

from numerics.arithmetic import double_double, double_elementary, double_exponential, float64
from numerics.arithmetic.double_compiled import declare_operators
from numerics.arithmetic.double_double import ZERO, Double, less, square_root
from numerics.arithmetic.double_elementary import PI, TURN, arctangent, sine_cosine
from numerics.arithmetic.telling import Telling
from numerics.arithmetic.words import words_of

clock, versine, sine_deficit = double_double.clock, double_elementary.versine, double_elementary.sine_deficit
cosine_deficit, depth_and_cotangent = double_elementary.cosine_deficit, double_elementary.depth_and_cotangent
exp, expm1, log, log1p = (getattr(double_exponential, name) for name in ("exp", "expm1", "log", "log1p"))
UNIT = 2.0**-105
"""What errors are counted in, relative to the result; the tests hold each below so many of it.

Sums 1.5, roots 2, products 2.5, quotients 5 (proved, see double_double.py). Sine, cosine and arcus tangent 3, versine,
x - sin x 4, depth 8, x^2/2 - 1 + cos x 16 (next to 2 it cancels), exponentials and logarithms 8: tested against balls,
not proved. Sine and cosine are off by |x| 2^-160 more, absolutely, as pi/2 has three parts: next to a zero that counts.
The angle of a contact 32, its depth 64.
"""
WIDTH = 2
LONGEST, SHORTEST = 1e14, 1e-60
"""Angles that double-double resolves: beyond them no phase is left, or the error of a fourth power is lost."""
sqrt, below = square_root, less


def exactly(n: float) -> Double:
    """Return a small whole number, or a power of 2, as a number."""
    return Double(float(n), 0.0)


def undefined() -> Double:
    """Return what stands for a number that left the range."""
    return Double(math.nan, 0.0)


def infinite() -> Double:
    """Return infinity."""
    return Double(math.inf, 0.0)


def turn() -> Double:
    """Return 2 pi."""
    return TURN


def half_turn() -> Double:
    """Return pi."""
    return PI


def signed(side: float, x: Double) -> Double:
    """Return side x, for side = -1.0 or +1.0."""
    return Double(side * x.high, side * x.low)


def sin(x: Double) -> Double:
    """Return sin x."""
    return sine_cosine(x)[0]


def atan2(y: Double, x: Double) -> Double:
    """Return the angle of the point (x, y)."""
    return arctangent(y, x)


def sign(x: Double, question: int) -> int:  # noqa: ARG001
    """Return the sign of x, which is that of its high part; 0 for nan."""
    return 1 if x.high > 0.0 else (-1 if x.high < 0.0 else 0)


def positive(x: Double) -> bool:
    """Return whether x > 0."""
    return x.high > 0.0


def rough(x: Double) -> float:
    """Return the nearest float."""
    return x.high


def leading(x: Double) -> float:
    """Return x to half of its digits."""
    return x.high


def part(x: float) -> Double:
    """Return a float as a number."""
    return Double(x, 0.0)


def size(x: Double) -> float:
    """Return |x|, rounded: it is compared with steps only."""
    return abs(x.high)


def tolerance() -> float:
    """Return the relative step at which a search ends."""
    return 2.0**-104


def settled() -> float:
    """Return 0: every step is checked by one more."""
    return 0.0


def finite(x: Double) -> bool:
    """Return whether x is a number."""
    return math.isfinite(x.high)


def fading() -> float:
    """Return after how many decay times an oscillation has died away below the last digit."""
    return 77.5


def resolved(angle: Double) -> bool:
    """Return whether 106 bits keep the phase of an angle > 0, and its fourth power has digits; False for nan."""
    return SHORTEST <= angle.high <= LONGEST


def ceiling(x: Double, question: int) -> int:  # noqa: ARG001
    """Return the least whole number >= x, 0 for x <= 0."""
    if not x.high > 0.0:
        return 0
    whole = math.ceil(x.high)
    return whole + 1 if float(whole) == x.high and x.low > 0.0 else whole


def middle(x: Double) -> Double:
    """Return x."""
    return x


def spread(x: Double) -> Double:  # noqa: ARG001
    """Return 0: points know no radius."""
    return ZERO


def widened(x: Double, by: Double) -> Double:  # noqa: ARG001
    """Return x: points know no radius."""
    return x


def nonnegative(x: Double) -> Double:
    """Return max(x, 0)."""
    return x if x.high > 0.0 else ZERO


def put(row: Any, index: int, numbers: tuple[Double, ...]) -> None:
    """Write the halves of numbers to a row, from a column on."""
    for number in numbers:
        row[index], row[index + 1] = number.high, number.low
        index += 2


DOUBLE_DOUBLE = Telling("double-double", words_of(sys.modules[__name__]), words_of(float64), prepare=declare_operators)
