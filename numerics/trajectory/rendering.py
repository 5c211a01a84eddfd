"""Numbers as decimal text that carries the digits that are right, no more.

A ball is printed with its radius, rounded outwards: [text - radius, text + radius] contains the true value. A point is
printed as the ball that its error bound makes of it, or its distance from a ball of an independent solve: the true
value lies within one unit of the last place.
"""

from __future__ import annotations

import math
from decimal import Decimal

from flint import arb

MOST_DIGITS = 17
"""The most digits that a float can show."""
_LEAST_RADIUS = arb(10) ** -(10**12)
"""What is smaller is printed as this: Python's decimals have no exponents below -10^18."""
_SPARE_DIGITS = 3
"""Printed beyond the digits asked for, so that rounding the text costs none of them."""


def with_radius(name: str, x: arb, digits: int, spare: int = _SPARE_DIGITS) -> dict[str, str]:
    """Return the text of a ball under a name, and its radius beside it, under `name_radius`.

    `digits` significant digits and `spare` ones, or as many as the radius leaves; the radius in 3 digits upwards.

    >>> with_radius("v1", arb(0.125, 0.25), 15), with_radius("v1", arb(1, 0.0625), 15)["v1"]
    ({'v1': '0', 'v1_radius': '0.376'}, '1.0')
    >>> with_radius("v1", arb(0, (-arb("1e50")).exp()), 15)["v1_radius"]
    '1.01E-1000000000000'
    """
    bits = x.rel_accuracy_bits()
    known = math.floor(bits * math.log10(2)) + 2
    text = str(x.mid().str(min(digits + spare, known), radius=False)) if bits > 0 else "0"
    return {name: text, f"{name}_radius": _upwards(abs(x - arb(text)).upper())}


def _upwards(bound: arb) -> str:
    """Return an exact ball >= 0 as decimal text of 3 digits, or 4, that is not smaller."""
    if bound.is_zero():
        return "0"
    bound = bound.max(_LEAST_RADIUS)
    place = math.floor(float((bound.log() / arb(10).log()).mid())) - 2
    digits = (bound / arb(10) ** place).upper().ceil().unique_fmpz()
    return str(Decimal(f"{digits}E{place}"))
