"""Double-double numbers as two floats, for compiled loops: sums and products of pairs (high, low).

A sum is off by 2^-104 of its terms at most (not of itself, where they cancel), a product by 2^-103 and a quotient by
2^-102 of the result.
"""

from __future__ import annotations

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.pair import two_product, two_sum


@compilable
def add(ah: float, al: float, bh: float, bl: float) -> tuple[float, float]:
    """Return the sum of two pairs."""
    s, e = two_sum(ah, bh)
    e += al + bl
    h = s + e
    return h, e - (h - s)


@compilable
def multiply(ah: float, al: float, bh: float, bl: float) -> tuple[float, float]:
    """Return the product of two pairs."""
    p, e = two_product(ah, bh)
    e += ah * bl + al * bh
    h = p + e
    return h, e - (h - p)


@compilable
def times(ah: float, al: float, b: float) -> tuple[float, float]:
    """Return the product of a pair and a float."""
    p, e = two_product(ah, b)
    e += al * b
    h = p + e
    return h, e - (h - p)


@compilable
def divide(ah: float, al: float, bh: float, bl: float) -> tuple[float, float]:
    """Return the quotient of two pairs."""
    q = ah / bh
    p, e = multiply(bh, bl, q, 0.0)
    r = ((ah - p) - e + al) / bh
    h = q + r
    return h, r - (h - q)
