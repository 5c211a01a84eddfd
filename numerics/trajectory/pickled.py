"""Numbers in a form that can be compared and pickled: flint has neither for balls."""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import arb

from numerics.arithmetic.ball_words import precision

_RADIUS_BITS = 30


def plain(value: Any) -> Any:
    """Return rows or numbers with every ball as whole numbers: mantissas and exponents of midpoint and radius."""
    if isinstance(value, arb):
        return ("ball", *_parts(value.mid()), *_parts(value.rad()))
    if isinstance(value, np.ndarray) and value.dtype != object:
        return value.tolist()
    if isinstance(value, (list, tuple, np.ndarray)):
        return tuple(plain(one) for one in value)
    return value


def restored(value: Any) -> Any:
    """Return rows or numbers from their plain form, as lists; the very same balls."""
    if isinstance(value, tuple) and len(value) == 5 and value[0] == "ball":
        return _ball(*value[1:])
    return [restored(one) for one in value] if isinstance(value, (tuple, list)) else value


def _parts(point: arb) -> tuple[int, int]:
    mantissa, exponent = point.man_exp()
    return int(mantissa), int(exponent)


def _ball(middle: int, middle_exponent: int, radius: int, radius_exponent: int) -> arb:
    with precision(max(53, middle.bit_length())):  # flint rounds what it is given
        point = arb((middle, middle_exponent))
        if radius == 0:
            return point
        # a radius is rounded up to the next of 30 bits, even if it has no more: it comes back from just below
        shift = _RADIUS_BITS + 1 - radius.bit_length()
        return arb(point, arb(((radius << shift) - 1, radius_exponent - shift)))
