"""Roots of one real function in balls: opposite signs proved at both ends of a bracket of the width asked for."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import arb

from paper_checks.decide.balls import DIGITS, point


def enclosed_root(
    function: Callable[[arb], arb], lower: Fraction | int, upper: Fraction | int, digits: int = DIGITS
) -> arb:
    """Return a ball, of radius below 10^-digits/100, in which a continuous function changes its sign.

    That there is no other root between lower and upper is the caller's to prove. Raises ArithmeticError where the
    signs at the ends are not proved to be opposite, or a midpoint's sign is not decided.
    """
    low, high = Fraction(lower), Fraction(upper)
    first = _sign(function, low)
    if _sign(function, high) != -first:
        raise ArithmeticError(f"no change of sign between {lower} and {upper}")
    while high - low > Fraction(1, 10 ** (digits + 2)):
        middle = (low + high) / 2
        low, high = (middle, high) if _sign(function, middle) == first else (low, middle)
    return point(low).union(point(high))


def _sign(function: Callable[[arb], arb], at: Fraction) -> int:
    value = function(point(at))
    if value > 0:
        return 1
    if value < 0:
        return -1
    raise ArithmeticError(f"the sign at {at} is not decided: {value.str(6)}")
