"""Where an undamped slip that starts on the switching surface ends, in closed form but for one monotone equation.

With gap d >= 0 and push u at the start (slip_flow.py), h(theta) = sine_deficit/versine and depth
c(theta) = 2 - theta cot(theta/2), the slip ends at the one angle in (0, 2 pi) with

    u + d cot(theta/2) - h(theta) = 0                the guard over 1 - cos: its root at the start is divided out
    d' = -(d + c),   u' = u - theta,   w' = w - q r c (c + 2 d)

The left side falls strictly from +infinity (or u > 0, if d = 0) to -infinity: there is one root and it is the first.
Close to a full turn (u > 1) the angle eta that is missing to 2 pi is the variable, which theta would round away.
Here any arithmetic solves it by its own `root`; binary64 and balls have faster ways to the same root.
"""

from __future__ import annotations

from numerics.arithmetic.protocol import Arithmetic, Contact, Number


def contact_by_root(arithmetic: Arithmetic, gap: Number, push: Number) -> Contact:
    """Return where a slip from the surface with gap >= 0 and push (> 0 if the gap is 0) ends. Raises EventUndecided.

    On a ray a point arithmetic takes over into theta at most the relative errors of push and rise, and the tolerance
    of the root: h is convex and h(0) = 0, so d ln theta <= d ln h.
    """
    if arithmetic.to_float(push) > 1:
        return _late_contact(arithmetic, gap, push)
    lower, upper = early_bracket(arithmetic, gap, push)

    def lead(theta: Number) -> Number:
        cosine, sine = arithmetic.cos_sin(theta / 2)
        return push + (gap * cosine / sine - arithmetic.rise(theta))

    def slope(theta: Number) -> Number:
        _, sine = arithmetic.cos_sin(theta / 2)
        return -(arithmetic.lag(theta / 2) / sine + gap / 2) / (sine * sine)

    theta = arithmetic.root(lead, slope, lower, upper)
    return Contact(theta, arithmetic.depth(theta), arithmetic.versine(theta))


def early_bracket(arithmetic: Arithmetic, gap: Number, push: Number) -> tuple[Number, Number]:
    """Return angles on either side of the root for push <= 1, a factor of a few apart however small they are.

    On (0, pi]: theta/3 <= h <= theta/2 and 2/theta - 2/pi <= cot(theta/2) <= 2/theta, so the root lies between the
    positive roots of theta^2/2 - (u - 2 d/pi) theta - 2 d and of theta^2/3 - u theta - 2 d; both are widened by 1/16,
    as they touch the root for small angles. Beyond pi the root cannot lie: h(3.3) > 1 >= u and cot < 0 there.
    """
    low = positive_root(arithmetic, push - 2 * gap / arithmetic.pi(), 4 * gap)
    high = 3 * positive_root(arithmetic, push, 8 * gap / 3) / 2
    high = 33 * arithmetic.pi() / 32 if arithmetic.to_float(high) > 3 else 17 * high / 16
    return 15 * low / 16, high


def positive_root(arithmetic: Arithmetic, b: Number, c: Number) -> Number:
    """Return b + sqrt(b^2 + c), c >= 0, without cancellation.

    In float64 within 3.5 ulp, u = 2^-53: the root 2 u, its difference from b < 0 1 u more, c over it 0.5 ulp.
    """
    root = arithmetic.sqrt(b * b + c)
    return b + root if arithmetic.to_float(b) >= 0 else c / (root - b)


def _late_contact(arithmetic: Arithmetic, gap: Number, push: Number) -> Contact:
    """Return the contact for push > 1 in terms of eta = 2 pi - theta, which lies in (0, 3 pi/2).

    There the guard is u versine(eta) - d sin(eta) + sine_deficit(eta) - 2 pi, and c = 2 + theta cot(eta/2).
    """
    turn = 2 * arithmetic.pi()

    def missing(eta: Number) -> Number:
        _, sine = arithmetic.cos_sin(eta)
        return (turn + gap * sine) - (push * arithmetic.versine(eta) + arithmetic.sine_deficit(eta))

    def slope(eta: Number) -> Number:
        cosine, sine = arithmetic.cos_sin(eta)
        return (gap * cosine - push * sine) - arithmetic.versine(eta)

    # versine >= 2 eta^2/pi^2 and sin <= eta on (0, pi]: the root lies below that of 2 u eta^2/pi^2 - d eta - 2 pi
    square = arithmetic.pi() * arithmetic.pi() / (4 * push)
    high = square * (gap + arithmetic.sqrt(gap * gap + 16 * push / arithmetic.pi()))
    high = 3 * arithmetic.pi() / 2 if arithmetic.to_float(high) > 3 else 17 * high / 16
    eta = arithmetic.root(missing, slope, arithmetic.number(0), high)
    cosine, sine = arithmetic.cos_sin(eta / 2)
    theta = turn - eta
    return Contact(theta, 2 + theta * cosine / sine, arithmetic.versine(eta))
