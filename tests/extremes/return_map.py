"""A million excursions by the return map alone, in fixed-point integers: the reference for late times (a1 = 0).

From ray to ray y = w/q goes to y - r c^2 and the cycle takes the reduced time pi + t, where with h(theta) = sqrt(y)
c = 2 - theta cot(theta/2); slip and stick times are the angles of the flow. c/y and t/y^(3/2) are analytic in y at 0:
both are interpolated in Chebyshev points and evaluated as polynomials.
"""

from fractions import Fraction

import mpmath
from mpmath import mpf

DIGITS = 240
BITS = 320
NODES = 40


def slip_angle(y):
    """The theta in (0, 2 pi) with (theta - sin theta)/(1 - cos theta) = sqrt(y)."""
    u = mpmath.sqrt(y)
    return mpmath.findroot(
        lambda t: t - mpmath.sin(t) - u * (1 - mpmath.cos(t)), (mpf("2.9") * u, mpf("3.1") * u), tol=mpf(10) ** -400
    )


def depth_ratio(y, q):
    theta = slip_angle(y)
    return (2 - theta * mpmath.cot(theta / 2)) / y


def extra_time(y, q):
    """(slip + stick - pi)/y^(3/2): from (1, eps) by the slip, then by rotation to (-1, -eps')."""
    r, theta = 1 - q, slip_angle(y)
    eps = mpmath.sqrt(q * y)
    after = mpmath.sqrt(q * (y - r * (depth_ratio(y, q) * y) ** 2))
    x = 1 - q * (1 - mpmath.cos(theta)) + mpmath.sqrt(q) * eps * mpmath.sin(theta)
    v = eps - mpmath.sqrt(q) * theta
    turn = mpmath.atan2(v, x) + mpmath.atan2(after, -1)
    return (mpmath.sqrt(q) * theta + turn - mpmath.pi) / y ** mpf("1.5")


def polynomial(function, top, q):
    """Coefficients of the interpolating polynomial on [0, top], as fixed-point integers in y/top."""
    nodes = [(1 + mpmath.cos(mpmath.pi * (2 * j + 1) / (2 * NODES))) / 2 for j in range(NODES)]
    matrix = mpmath.matrix([[node**k for k in range(NODES)] for node in nodes])
    values = mpmath.matrix([function(node * top, q) for node in nodes])
    return [int(mpmath.nint(c * mpf(2) ** BITS)) for c in mpmath.lu_solve(matrix, values)]


def horner(coefficients, z):
    total = 0
    for c in reversed(coefficients):
        total = (total * z >> BITS) + c
    return total


def after_time(q: Fraction, w: Fraction, tau: Fraction) -> tuple[int, str]:
    """(full cycles before the reduced time tau, w of the stick phase there) from the exit ray with excess w."""
    with mpmath.workdps(DIGITS):
        share, top = mpf(q.numerator) / q.denominator, mpf((w / q).numerator) / (w / q).denominator
        depths, times = polynomial(depth_ratio, top, share), polynomial(extra_time, top, share)
        factor = int(mpmath.nint((1 - share) * top * mpf(2) ** BITS))  # of z^2 in z' = z - r top (c/y)^2 z^2
        half_turn = int(mpmath.nint(mpmath.pi * mpf(2) ** BITS))
        unit = int(mpmath.nint(top ** mpf("1.5") * mpf(2) ** BITS))
        end = int(tau * 2**BITS)
        z, elapsed, count = 1 << BITS, 0, 0
        while True:
            terms = min(NODES, 2 + int(BITS / max(1, BITS - z.bit_length() + 1)) + 2)
            c = horner(depths[:terms], z)
            root = mpmath.libmp.isqrt(z << BITS)
            cycle = half_turn + (((horner(times[:terms], z) * z >> BITS) * root >> BITS) * unit >> BITS)
            drop = ((c * z >> BITS) ** 2 >> BITS) * factor >> BITS
            if elapsed + cycle > end:
                return count, mpmath.nstr(share * top * mpf(z - drop) / mpf(2) ** BITS, 50)
            z, elapsed, count = z - drop, elapsed + cycle, count + 1
