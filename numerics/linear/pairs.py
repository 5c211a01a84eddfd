"""Double-double numbers as two floats, for compiled loops: sums and products of pairs (high, low).

A sum is off by 2^-104 of its terms at most (not of itself, where they cancel), a product by 2^-103 and a quotient by
2^-102 of the result.
"""

from __future__ import annotations

import math

import numpy as np

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
def divide(ah: float, al: float, bh: float, bl: float) -> tuple[float, float]:
    """Return the quotient of two pairs."""
    q = ah / bh
    p, e = multiply(bh, bl, q, 0.0)
    r = ((ah - p) - e + al) / bh
    h = q + r
    return h, r - (h - q)


TURN = (6.283185307179586, 2.4492935982947064e-16, -5.989539619436679e-33)
"""2 pi in three parts."""
_PARTS = 16


def _sines() -> tuple[np.ndarray, np.ndarray]:
    """Return sin and cos of n pi/8 as pairs, rows (sin high, sin low, cos high, cos low), and 1/n! as pairs."""
    from fractions import Fraction

    from mpmath import mp

    with mp.workdps(60):
        table = np.empty((_PARTS, 4))
        for n in range(_PARTS):
            for k, value in enumerate((mp.sinpi(mp.mpf(n) / 8), mp.cospi(mp.mpf(n) / 8))):
                table[n, 2 * k] = float(value)
                table[n, 2 * k + 1] = float(value - float(value))
    inverse = np.empty((30, 2))
    for n in range(30):
        exact = Fraction(1, math.factorial(n))
        inverse[n] = float(exact), float(exact - Fraction(float(exact)))
    return table, inverse


SINES, INVERSE_FACTORIALS = _sines()


@compilable
def sine_cosine(h: float, low: float) -> tuple[float, float, float, float]:
    """Return the sine and the cosine of a pair, each a pair; within 2^-100, absolutely, for |angle| <= 2^20."""
    n = np.rint(h / (TURN[0] / _PARTS))
    part = n / _PARTS  # exact
    p0, e0 = two_product(part, TURN[0])
    p1, e1 = two_product(part, TURN[1])
    rh, rl = add(h, low, -p0, -e0)
    rh, rl = add(rh, rl, -p1, -(e1 + part * TURN[2]))
    square_h, square_l = multiply(rh, rl, rh, rl)
    sh, sl, ch, cl = INVERSE_FACTORIALS[25, 0], 0.0, INVERSE_FACTORIALS[24, 0], 0.0
    for k in range(23, 0, -2):
        sh, sl = multiply(sh, sl, square_h, square_l)
        sh, sl = add(-sh, -sl, INVERSE_FACTORIALS[k, 0], INVERSE_FACTORIALS[k, 1])
        ch, cl = multiply(ch, cl, square_h, square_l)
        ch, cl = add(-ch, -cl, INVERSE_FACTORIALS[k - 1, 0], INVERSE_FACTORIALS[k - 1, 1])
    sh, sl = multiply(sh, sl, rh, rl)
    at = int(n) % _PARTS
    a, b, c, d = SINES[at, 0], SINES[at, 1], SINES[at, 2], SINES[at, 3]
    p, q = multiply(sh, sl, c, d)
    r, s = multiply(ch, cl, a, b)
    sine_h, sine_l = add(p, q, r, s)
    p, q = multiply(ch, cl, c, d)
    r, s = multiply(sh, sl, a, b)
    cosine_h, cosine_l = add(p, q, -r, -s)
    return sine_h, sine_l, cosine_h, cosine_l
