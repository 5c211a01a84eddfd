"""The functions of numbers, by the type of the number: float, Pair (double-double), mpmath's mpf, flint's arb.

A formula is written once, with operators and these, and works in every arithmetic. Each is accurate relative to its own
value; for balls every answer encloses the true one, and comparisons mean "proven". Where compiled code calls one of
them, it takes that of elementary.py or of pair_elementary.py (compiled.py).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from flint import arb
from mpmath import mpf

from numerics.arithmetic import ball, elementary, multiprecision, pair_elementary
from numerics.arithmetic.compiled import by_type, compilable
from numerics.arithmetic.pair import Pair
from numerics.arithmetic.protocol import Number

_Function = TypeVar("_Function", bound=Callable[..., Any])
_OF: dict[type, Any] = {float: elementary, Pair: pair_elementary, mpf: multiprecision, arb: ball}
"""The modules that have them all, by the type of a number."""


def _compiled_by_type(function: _Function) -> _Function:
    name = function.__name__
    return by_type(getattr(elementary, name), getattr(pair_elementary, name))(function)


@_compiled_by_type
def like(x: Number, value: float) -> Number:
    """Return a float, exactly, as a number of the type of x."""
    return _OF[type(x)].like(x, value)


@_compiled_by_type
def as_float(x: Number) -> float:
    """Return the float nearest to x, or to the midpoint of a ball: it chooses, it never decides."""
    return _OF[type(x)].as_float(x)


@_compiled_by_type
def rounding(x: Number) -> float:
    """Return what errors of one operation are counted in, relative to its result; 0 where nobody counts."""
    return _OF[type(x)].rounding(x)


@_compiled_by_type
def two_pi(x: Number) -> Number:
    """Return 2 pi as a number of the type of x."""
    return _OF[type(x)].two_pi(x)


@compilable
def signed(side: float, x: Number) -> Number:
    """Return side x, for side = -1.0 or +1.0."""
    return x if side > 0.0 else -x


@_compiled_by_type
def sqrt(x: Number) -> Number:
    """Return the square root of x >= 0; of a ball, of its points that are >= 0."""
    return _OF[type(x)].sqrt(x)


@_compiled_by_type
def sin(x: Number) -> Number:
    """Return sin x."""
    return _OF[type(x)].sin(x)


@_compiled_by_type
def sine_cosine(x: Number) -> tuple[Number, Number]:
    """Return (sin x, cos x)."""
    return _OF[type(x)].sine_cosine(x)


@_compiled_by_type
def atan2(y: Number, x: Number) -> Number:
    """Return the angle of the point (x, y)."""
    return _OF[type(y)].atan2(y, x)


@_compiled_by_type
def versine(x: Number) -> Number:
    """Return 1 - cos x."""
    return _OF[type(x)].versine(x)


@_compiled_by_type
def sine_deficit(x: Number) -> Number:
    """Return x - sin x."""
    return _OF[type(x)].sine_deficit(x)


@_compiled_by_type
def cosine_deficit(x: Number) -> Number:
    """Return x^2/2 - 1 + cos x."""
    return _OF[type(x)].cosine_deficit(x)


@_compiled_by_type
def depth_and_cotangent(x: Number) -> tuple[Number, Number]:
    """Return 2 - x cot(x/2) and cot(x/2), for 0 < x < 2 pi (points: up to 2 pi - 1)."""
    return _OF[type(x)].depth_and_cotangent(x)


@_compiled_by_type
def sign(x: Number, question: int) -> int:
    """Return -1, 0 or +1; raises EventUndecided(question) where a ball leaves it open; 0 for nan."""
    return _OF[type(x)].sign(x, question)


@_compiled_by_type
def ceiling(x: Number, question: int) -> int:
    """Return the least whole number >= x, 0 for x <= 0; raises EventUndecided where the points of a ball differ."""
    return _OF[type(x)].ceiling(x, question)


@_compiled_by_type
def finite(x: Number) -> bool:
    """Return whether x is a number."""
    return _OF[type(x)].finite(x)


@_compiled_by_type
def resolved(angle: Number) -> bool:
    """Return whether the digits keep the phase of an angle > 0."""
    return _OF[type(angle)].resolved(angle)


@_compiled_by_type
def nonnegative(x: Number) -> Number:
    """Return max(x, 0)."""
    return _OF[type(x)].nonnegative(x)


@_compiled_by_type
def tolerance(x: Number) -> Number:
    """Return the relative step at which a search among numbers of the type of x ends."""
    return _OF[type(x)].tolerance(x)


@_compiled_by_type
def clock(total: Number, rest: Number, term: Number) -> tuple[Number, Number]:
    """Return total + rest + term, and what its rounding left out: so many sums are as accurate as one."""
    return _OF[type(total)].clock(total, rest, term)
