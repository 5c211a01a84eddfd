"""Where a slip ends, in double-double: the root of binary64 is corrected once, the equation evaluated to 104 bits.

A step of Halley's method from an error e leaves some e^3. A slip from the switching surface has the equations of
arithmetic/slip_contact.py, where binary64 is right to some 2^-50: one step is enough. For the first contact of a slip
from elsewhere the steps go on, as binary64 may have lost most of its digits on a long slip or next to a graze.
"""

from __future__ import annotations

import math

from numerics.kernel.compilation import kernel
from numerics.kernel.contact import contact, late_angle
from numerics.kernel.double_double import (
    ONE,
    ZERO,
    Double,
    add,
    divide,
    less,
    negative,
    product,
    scaled,
    square_root,
    subtract,
    times,
)
from numerics.kernel.double_elementary import (
    TURN,
    arctangent,
    cosine_deficit,
    depth_and_cotangent,
    rise_of,
    sine_cosine,
    sine_deficit,
    versine,
)
from numerics.kernel.first_contact import guard_root

_TWO = Double(2.0, 0.0)
_STEPS = 400
_TOLERANCE = 2.0**-104


@kernel
def double_contact(gap: Double, push: Double) -> tuple[Double, Double, float]:
    """Return (theta, depth, versine in binary64) at the end of a slip from S with gap d >= 0, push u (> 0 if d = 0)."""
    return _late(gap, push) if push.high > 1.0 else _early(gap, push)


@kernel
def _early(gap: Double, push: Double) -> tuple[Double, Double, float]:
    """Return the contact for push <= 1: lead = u + d cot(theta/2) - h(theta), lead' = -(d + c)/(1 - cos theta)."""
    seed, _, drop = contact(gap.high, push.high)
    theta = Double(seed, 0.0)
    depth, cotangent = depth_and_cotangent(theta)
    rise = rise_of(theta, depth)
    lead = subtract(add(push, product(gap, cotangent)), rise)
    # 1/(1 - cos theta) = (1 + cot^2(theta/2))/2
    reciprocal = scaled(add(ONE, product(cotangent, cotangent)), 0.5)
    shift = divide(lead, product(add(gap, depth), reciprocal))
    slope = (gap.high + depth.high) * reciprocal.high
    bend = ((gap.high + depth.high) * cotangent.high - rise.high) * reciprocal.high
    shift = add(shift, Double(0.5 * shift.high * shift.high * (bend / slope), 0.0))
    rise_slope = 1.0 - rise.high * cotangent.high
    grown = add(product(shift, rise), Double(0.5 * shift.high * shift.high * rise_slope, 0.0))
    return add(theta, shift), add(depth, grown), drop


@kernel
def _late(gap: Double, push: Double) -> tuple[Double, Double, float]:
    """Return the contact for push > 1 by eta = 2 pi - theta: 2 pi + d sin - u (1 - cos) - (eta - sin eta) = 0."""
    seed = late_angle(gap.high, push.high)
    eta = Double(seed, 0.0)
    half_sine, half_cosine = sine_cosine(Double(0.5 * seed, 0.0))
    sine = scaled(product(half_sine, half_cosine), 2.0)
    drop = scaled(product(half_sine, half_sine), 2.0)
    missing = subtract(add(TURN, product(gap, sine)), add(product(push, drop), subtract(eta, sine)))
    steepness = subtract(add(product(push, sine), drop), product(gap, subtract(ONE, drop)))
    shift = divide(missing, steepness)
    bend = -(gap.high + 1.0) * sine.high - push.high * (1.0 - drop.high)
    shift = add(shift, Double(0.5 * shift.high * shift.high * (bend / steepness.high), 0.0))
    theta = subtract(TURN, eta)
    depth = add(_TWO, divide(product(theta, half_cosine), half_sine))
    # dc/d eta = -h, h' = 1 - h cot(theta/2) = 1 + h cot(eta/2)
    rise = divide(add(theta, sine), drop)
    rise_slope = 1.0 + rise.high * half_cosine.high / half_sine.high
    grown = add(product(shift, rise), Double(-0.5 * shift.high * shift.high * rise_slope, 0.0))
    return subtract(theta, shift), subtract(depth, grown), drop.high


@kernel
def double_guard(theta: Double, g: Double, d: Double, u: Double) -> Double:
    """Return k(theta) = g + d sin + u (1 - cos) - (theta - sin)."""
    turning = add(product(d, sine_cosine(theta)[0]), product(u, versine(theta)))
    return add(subtract(turning, sine_deficit(theta)), g)


@kernel
def double_gap(theta: Double, d: Double, u: Double) -> Double:
    """Return d(theta), the slope of the guard."""
    return add(d, subtract(product(u, sine_cosine(theta)[0]), product(add(ONE, d), versine(theta))))


@kernel
def double_push(theta: Double, d: Double, u: Double) -> Double:
    """Return u(theta)."""
    sine, cosine = sine_cosine(theta)
    return subtract(product(u, cosine), product(add(ONE, d), sine))


@kernel
def double_slid(theta: Double, g: Double, d: Double, u: Double) -> Double:
    """Return K(theta), the integral of the guard."""
    grown = add(product(d, versine(theta)), product(u, sine_deficit(theta)))
    return add(subtract(grown, cosine_deficit(theta)), product(g, theta))


@kernel
def double_first_contact(g: Double, d: Double, u: Double, turns: bool) -> tuple[Double, float]:
    """Return the first theta > 0 with k = 0, g > 0, and how far above 0 the lowest minimum before it lies.

    The algorithm and its reasons: slip_flow.py. nan where a number left the range.
    """
    excess = add(product(d, add(_TWO, d)), product(u, u))
    if not math.isfinite(excess.high):
        return Double(math.nan, 0.0), 0.0
    if not turns or excess.high <= 0.0:
        return _guard_root(g, d, u, ZERO, add(add(g, u), Double(3.0, 0.0))), math.inf
    height = square_root(excess)
    lean, phase = arctangent(height, ONE), arctangent(u, add(ONE, d))
    first = subtract(phase, lean)
    count = divide(subtract(subtract(add(g, u), height), first), TURN)
    if not count.high < 1e15:
        return Double(math.nan, 0.0), 0.0
    least = 1 if first.high <= 0.0 else 0
    whole = math.ceil(max(count.high, -1.0))  # far below zero there are no minima to pass
    if float(whole) == count.high and count.low > 0.0:
        whole += 1
    index = max(least, whole)
    minimum = add(first, times(TURN, float(index)))
    maximum = add(subtract(minimum, TURN), scaled(lean, 2.0))
    spared = math.inf
    if index > least:
        spared = product(TURN, subtract(count, Double(float(index - 1), 0.0))).high
    return _guard_root(g, d, u, ZERO if maximum.high <= 0.0 else maximum, minimum), spared


@kernel
def _guard_root(g: Double, d: Double, u: Double, lower: Double, upper: Double) -> Double:
    """Return the root of the guard on a piece where it falls, by Newton's method in a bracket, from binary64's root."""
    theta = Double(guard_root(g.high, d.high, u.high, lower.high, upper.high), 0.0)
    if not (less(lower, theta) and less(theta, upper)):
        theta = scaled(add(lower, upper), 0.5)
    previous = subtract(upper, lower).high
    for _ in range(_STEPS):
        value = double_guard(theta, g, d, u)
        if value.high == 0.0:
            return theta
        if value.high > 0.0:
            lower = theta
        else:
            upper = theta
        slope = double_gap(theta, d, u)
        step = divide(negative(value), slope) if slope.high < 0.0 else Double(previous, 0.0)
        candidate = add(theta, step)
        if not (less(lower, candidate) and less(candidate, upper)) or 2.0 * abs(step.high) > previous:
            candidate = scaled(add(lower, upper), 0.5)
            step = subtract(candidate, theta)
        if abs(step.high) <= _TOLERANCE * abs(candidate.high) or not (
            less(lower, candidate) and less(candidate, upper)
        ):
            return candidate
        theta, previous = candidate, abs(step.high)
    return theta
