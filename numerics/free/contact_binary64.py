"""Where a slip that starts on the switching surface ends, in binary64: the equation of contact.py, by Halley's method.

Every other arithmetic starts from here.

With y = theta/2 and cot = cos y/sin y one sine and one cosine give everything that a step of Halley's method needs:

    lead = u + d cot - h            lead' = -(d/2)/sin^2 y - h'        lead'' = (d/2) cot/sin^2 y - h''
    h' = 1 - h cot,                 h'' = h/(2 sin^2 y) - h' cot,      c' = h

The bracket of the one root is kept throughout: a step that would leave it is replaced by bisection.
"""

from __future__ import annotations

import math

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.elementary import depth, rise, two_horners, versine
from numerics.arithmetic.functions import as_float, sqrt, two_pi
from numerics.arithmetic.protocol import Number

TURN = 2.0 * math.pi
_SMALL_STEP = 2.0**-19
"""Halley's steps shrink cubically: after one so much smaller than the angle the error is below its last bit."""
_STEPS = 200
_INVERSE_RISE = (
    (0.0065409791, 0.070592857, 0.17257569, 0.99999944),
    (-0.030933036, -0.11482952, -0.29994229),
)
"""theta/(3 u) as a polynomial in u^2 where h(theta) = u <= 1, fitted to 6e-7: the first guess on an exit ray."""


@compilable
def binary64_contact(gap: float, push: float) -> tuple[float, float, float]:
    """Return (theta, depth, versine) at the end of a slip from S with gap d >= 0 and push u (> 0 if d = 0).

    Approximate, the angle to some 2 ulp times the condition of the equation; nan where the arguments are.
    """
    if push > 1.0:
        eta = late_angle(gap, push)
        theta = TURN - eta
        return theta, 2.0 + theta * math.cos(0.5 * eta) / math.sin(0.5 * eta), versine(eta)
    if gap == 0.0:
        guess = 3.0 * push * two_horners(_INVERSE_RISE, push * push)
        return early_contact(gap, push, guess, 2.0 * push, 3.3 * push)
    lower, upper = early_bracket(gap, push)
    # the root of (1/3 + d/6) theta^2 - u theta - 2 d, to which the equation tends for small angles
    third = 1.0 / 3.0 + gap / 6.0
    guess = positive_root(0.5 * push / third, 2.0 * gap / third)
    return early_contact(gap, push, min(max(guess, lower), upper), lower, upper)


@compilable
def early_contact(gap: float, push: float, guess: float, lower: float, upper: float) -> tuple[float, float, float]:
    """Return the contact for push <= 1 from a guess in its bracket."""
    theta = guess
    shift = previous = upper - lower
    sine = cosine = slope = height = 0.0
    for _ in range(_STEPS):
        sine, cosine = math.sin(0.5 * theta), math.cos(0.5 * theta)
        cosecant = 1.0 / sine
        cotangent, half_square = cosine * cosecant, 0.5 * cosecant * cosecant
        height = rise(theta)
        slope = 1.0 - height * cotangent
        lead = push + (gap * cotangent - height)
        if lead > 0.0:
            lower = theta
        elif lead < 0.0:
            upper = theta
        first = gap * half_square + slope  # -lead'
        second = gap * half_square * cotangent - (height * half_square - slope * cotangent)
        shift = lead / first
        bend = 0.5 * shift * second / first
        # 1/(1 - bend) next to the root, and a step that is still safe far from it
        shift = shift * (1.0 + bend * (1.0 + bend)) if abs(bend) < 0.5 else shift
        if abs(shift) <= _SMALL_STEP * theta:
            break
        candidate = theta + shift
        if not lower < candidate < upper or 2.0 * abs(shift) > previous:
            candidate = 0.5 * (lower + upper)
        if candidate in (lower, upper):
            shift = 0.0
            break
        previous = abs(candidate - theta)
        theta = candidate
    half = 0.5 * shift
    end_sine = sine + half * (cosine - 0.5 * half * sine)
    return theta + shift, depth(theta) + shift * (height + 0.5 * shift * slope), 2.0 * end_sine * end_sine


@compilable
def early_bracket(gap: Number, push: Number) -> tuple[Number, Number]:
    """Return angles on either side of the root for push <= 1, a factor of a few apart however small they are.

    On (0, pi]: theta/3 <= h <= theta/2 and 2/theta - 2/pi <= cot(theta/2) <= 2/theta, so the root lies between the
    positive roots of theta^2/2 - (u - 2 d/pi) theta - 2 d and of theta^2/3 - u theta - 2 d; both are widened by 1/16,
    as they touch the root for small angles. Beyond pi the root cannot lie: h(3.3) > 1 >= u and cot < 0 there.
    """
    half_turn = two_pi(gap) / 2
    low = positive_root(push - 2 * gap / half_turn, 4 * gap)
    high = 3 * positive_root(push, 8 * gap / 3) / 2
    high = 33 * half_turn / 32 if as_float(high) > 3.0 else 17 * high / 16
    return 15 * low / 16, high


@compilable
def late_bound(gap: Number, push: Number) -> Number:
    """Return an angle missing to 2 pi beyond the root for push > 1.

    versine >= 2 eta^2/pi^2 and sin <= eta on (0, pi]: the root lies below that of 2 u eta^2/pi^2 - d eta - 2 pi.
    """
    half_turn = two_pi(gap) / 2
    upper = half_turn * half_turn / (4 * push) * (gap + sqrt(gap * gap + 16 * push / half_turn))
    return 3 * half_turn / 2 if as_float(upper) > 3.0 else 17 * upper / 16


@compilable
def positive_root(b: Number, c: Number) -> Number:
    """Return b + sqrt(b^2 + c), c >= 0, without cancellation.

    Within 3.5 ulp, u = 2^-53: the root 2 u, its difference from b < 0 1 u more, c over it 0.5 ulp.
    """
    root = sqrt(b * b + c)
    return b + root if as_float(b) >= 0.0 else c / (root - b)


@compilable
def late_angle(gap: float, push: float) -> float:
    """Return, for push > 1, the angle eta = 2 pi - theta that is missing to a full turn, by Halley's method.

    f = (2 pi - eta) + (d + 1) sin eta - u (1 - cos eta) falls on 0 < eta < 3 pi/2, f'' = -(d + 1) sin - u cos.
    """
    lower, upper = 0.0, late_bound(gap, push)
    eta = late_guess(gap, push, upper)
    previous = upper
    for _ in range(_STEPS):
        half_sine, half_cosine = math.sin(0.5 * eta), math.cos(0.5 * eta)
        sine, drop = 2.0 * half_sine * half_cosine, 2.0 * half_sine * half_sine
        missing = (TURN - eta) + ((gap + 1.0) * sine - push * drop)
        if missing > 0.0:
            lower = eta
        elif missing < 0.0:
            upper = eta
        steepness = push * sine + drop - gap * (1.0 - drop)  # -f'
        shift = missing / steepness if steepness > 0.0 else upper - lower
        if steepness > 0.0:
            bend = -0.5 * shift * ((gap + 1.0) * sine + push * (1.0 - drop)) / steepness
            shift = shift * (1.0 + bend * (1.0 + bend)) if abs(bend) < 0.5 else shift
        if abs(shift) <= _SMALL_STEP * eta:
            return eta + shift
        candidate = eta + shift
        if not lower < candidate < upper or 2.0 * abs(shift) > previous:
            candidate = 0.5 * (lower + upper)
        if candidate in (lower, upper):
            return candidate
        previous = abs(candidate - eta)
        eta = candidate
    return eta


@compilable
def late_guess(gap: float, push: float, upper: float) -> float:
    """Return a first guess of the angle missing to 2 pi, for push > 1.

    With y = eta/2, C = cot y and p = pi - y the equation is p C^2 + (d + 1) C + p - u = 0; p is taken from the equation
    for small angles, and one of Newton's steps allows for dp = -dy.
    """
    y = min(0.5 * (gap + math.sqrt(gap * gap + 2.0 * TURN * push)) / push, 0.25 * upper)
    rest = 0.5 * TURN - y
    root = math.sqrt(max((gap + 1.0) * (gap + 1.0) + 4.0 * rest * (push - rest), 0.0))
    turned = math.atan2(gap + 1.0 + root, 2.0 * (push - rest))  # arccot C
    return min(2.0 * (y + (turned - y) * root / (root + 1.0)), 0.98 * upper)
