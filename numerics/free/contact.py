"""Where an undamped slip that starts on the switching surface ends, in closed form but for one monotone equation.

With gap d >= 0 and push u at the start (slip.py), h(theta) = (theta - sin theta)/(1 - cos theta) and depth
c(theta) = 2 - theta cot(theta/2), the slip ends at the one angle in (0, 2 pi) with

    u + d cot(theta/2) - h(theta) = 0                the guard over 1 - cos: its root at the start is divided out
    d' = -(d + c),   u' = u - theta,   w' = w - q r c (c + 2 d)

The left side falls strictly from +infinity (or u > 0, if d = 0) to -infinity: there is one root and it is the first.
Close to a full turn (u > 1) the angle eta that is missing to 2 pi is the variable, which theta would round away:

    2 pi + d sin eta - u (1 - cos eta) - (eta - sin eta) = 0,        c = 2 + theta cot(eta/2)

Binary64 solves it in contact_binary64.py. A finer arithmetic takes steps of Halley's method from there, each of which
triples the right digits: double-double takes one. Balls do so up to half of the bits asked for, the precision tripled
with each step; there the function is evaluated once at full precision, at the price of one sine-cosine, and one
interval Newton step encloses the root: its slope need only be known to half of the bits. The inclusion proves the root;
that it is the only one in (0, 2 pi), hence the first, is a theorem.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from flint import arb, ctx

from numerics.arithmetic.ball import magnitude_bits, precision, widened
from numerics.arithmetic.compiled import by_type, compilable
from numerics.arithmetic.functions import (
    as_float,
    depth_and_cotangent,
    like,
    sine_cosine,
    sqrt,
    two_pi,
    versine,
)
from numerics.arithmetic.pair import Pair
from numerics.arithmetic.protocol import Number
from numerics.free.contact_binary64 import binary64_contact, early_bracket, late_angle, late_bound
from numerics.free.root import falling_root

_SEED_BITS = 44
_SMALLEST_SEED = 1e-90
_SPARE_BITS = 12


class EarlyPoint(NamedTuple):
    """The equation at an angle theta: cot(theta/2), h, 1/(1 - cos), its value, and its slope with the sign turned."""

    gap: Number
    theta: Number
    depth: Number
    cotangent: Number
    rise: Number
    reciprocal: Number
    value: Number
    steepness: Number


class LatePoint(NamedTuple):
    """The equation at an angle eta: half its sine and cosine, sin eta, 1 - cos eta, its value, and minus its slope."""

    gap: Number
    push: Number
    eta: Number
    half_sine: Number
    half_cosine: Number
    sine: Number
    versine: Number
    value: Number
    steepness: Number


@compilable
def _refined_contact(gap: Pair, push: Pair) -> tuple[Pair, Pair, Pair]:
    """Return the contact in double-double, by one step from the root of binary64."""
    if push.high > 1.0:
        late = late_point(gap, push, Pair(late_angle(gap.high, push.high), 0.0))
        # dc/d eta = -h, h' = 1 - h cot(theta/2) = 1 + h cot(eta/2)
        shift, theta = late_shift(late), two_pi(gap) - late.eta
        depth, rise = 2 + (theta * late.half_cosine) / late.half_sine, (theta + late.sine) / late.versine
        slope = 1 + rise * late.half_cosine / late.half_sine
        return theta - shift, depth - (shift * rise - shift * shift * slope / 2), late.versine + shift * late.sine
    theta, _, _ = binary64_contact(gap.high, push.high)
    early = early_point(gap, push, Pair(theta, 0.0))
    shift = early_shift(early)  # c' = h, h' = 1 - h cot
    grown = shift * early.rise + shift * shift * (1 - early.rise * early.cotangent) / 2
    return early.theta + shift, early.depth + grown, 1 / early.reciprocal


@by_type(binary64_contact, _refined_contact)
def contact(gap: Number, push: Number) -> tuple[Number, Number, Number]:
    """Return theta, c(theta) and 1 - cos theta at the end of a slip from S with gap d >= 0 and push u (> 0 if d = 0).

    Each is accurate relative to itself; in double-double 1 - cos theta serves the error bounds only and has the digits
    of binary64. Raises EventUndecided in balls.
    """
    if type(gap) is float:
        return binary64_contact(gap, push)
    if type(gap) is Pair:
        return _refined_contact(gap, push)
    found = contact_next_to_binary64(gap, push) if type(gap) is arb else None
    return found or bracketed_contact(gap, push)


@compilable
def early_point(gap: Number, push: Number, theta: Number) -> EarlyPoint:
    """Return the equation for push <= 1 at an angle; from one sine and cosine."""
    depth, cotangent = depth_and_cotangent(theta)
    # the Riccati equation of the depth c: in h = c' = ((theta^2 + c^2)/2 - c)/theta at most one bit cancels
    rise = ((theta * theta + depth * depth) / 2 - depth) / theta
    reciprocal = (1 + cotangent * cotangent) / 2
    value, steepness = (push + gap * cotangent) - rise, (gap + depth) * reciprocal
    return EarlyPoint(gap, theta, depth, cotangent, rise, reciprocal, value, steepness)


@compilable
def early_shift(at: EarlyPoint) -> Number:
    """Return the step of Halley's method from a point next to the root."""
    shift = at.value / at.steepness
    bend = ((at.gap + at.depth) * at.cotangent - at.rise) * at.reciprocal
    return shift + shift * shift * (bend / at.steepness) / 2


@compilable
def late_point(gap: Number, push: Number, eta: Number) -> LatePoint:
    """Return the equation for push > 1 at an angle missing to a full turn; from one sine and cosine."""
    half_sine, half_cosine = sine_cosine(eta / 2)
    sine, drop = 2 * (half_sine * half_cosine), 2 * (half_sine * half_sine)
    value = (two_pi(gap) + gap * sine) - (push * drop + (eta - sine))
    steepness = (push * sine + drop) - gap * (1 - drop)
    return LatePoint(gap, push, eta, half_sine, half_cosine, sine, drop, value, steepness)


@compilable
def late_shift(at: LatePoint) -> Number:
    """Return the step of Halley's method from a point next to the root."""
    shift = at.value / at.steepness
    bend = -(at.gap + 1) * at.sine - at.push * (1 - at.versine)
    return shift + shift * shift * (bend / at.steepness) / 2


def bracketed_contact(gap: Number, push: Number) -> tuple[Number, Number, Number]:
    """Return the contact without binary64's root: by a bracket, for arguments of any size (see early_bracket)."""

    def root(point_at: Callable[..., EarlyPoint | LatePoint], lower: Number, upper: Number) -> Number:
        def value_and_slope(at: tuple[Number, Number], x: Number) -> tuple[Number, Number]:
            point = point_at(*at, x)
            return point.value, -point.steepness

        return falling_root(lower, upper, value_and_slope, (gap, push))

    if as_float(push) > 1.0:
        eta = root(late_point, like(gap, 0.0), late_bound(gap, push))
        point, theta = late_point(gap, push, eta), two_pi(gap) - eta
        return theta, 2 + theta * point.half_cosine / point.half_sine, point.versine
    theta = root(early_point, *early_bracket(gap, push))
    return theta, depth_and_cotangent(theta)[0], versine(theta)


@compilable
def _ray_contact_of_points(w: Number, push: Number, q: Number, r: Number, _: Number) -> tuple[Number, ...]:
    theta, depth, drop = contact(like(w, 0.0), push)
    return theta, depth, w - r * q * depth * depth, drop


@by_type(_ray_contact_of_points, _ray_contact_of_points)
def ray_contact(w: Number, push: Number, q: Number, r: Number, sqrt_q: Number) -> tuple[Number, ...]:
    """Return theta, depth, the excess after it, and 1 - cos theta of a slip from an exit ray with excess w = q u^2."""
    if type(w) is not arb:
        return _ray_contact_of_points(w, push, q, r, sqrt_q)
    return _enclosed_ray_contact(w, q, r, sqrt_q)


def _enclosed_ray_contact(w: arb, q: arb, r: arb, sqrt_q: arb) -> tuple[arb, arb, arb, arb]:
    """Return the same in balls.

    The contact is located at the centre of w; along w, theta/u falls (h is convex), c' = h and
    dw'/dw = 1 - r (1 - cos theta), which lies in (-1, 1): so enclosures of w do not grow from one excursion to the
    next, however many there are.
    """
    centre = w.mid()
    push = sqrt(centre) / sqrt_q
    theta_there, depth_there, versine_there = contact(arb(0), push)
    stretch = sqrt(w / centre)
    theta = theta_there * stretch
    depth = depth_there + push * stretch * (theta - theta_there)
    # 1 - cos changes by less than |theta - theta at the centre|; 3 makes the ball cover both signs of that difference,
    # of which it lacks a part, as sqrt bends: sqrt 2 - 1 > 1/3
    slope = 1 - r * (versine_there + 3 * (theta - theta_there))
    return theta, depth, (centre - r * q * depth_there * depth_there) + (w - centre) * slope, versine_there


def contact_next_to_binary64(gap: arb, push: arb) -> tuple[arb, arb, arb] | None:
    """Return the enclosed contact, proved next to the one that binary64 finds for the midpoints; None if it fails."""
    d, u, bits = as_float(gap), as_float(push), ctx.prec
    if not (0.0 <= d < math.inf and abs(u) < math.inf and (d > 0.0 or u > 0.0)):
        return None
    try:
        near = late_angle(d, u) if u > 1.0 else binary64_contact(d, u)[0]
    except ArithmeticError:
        return None
    if not near > _SMALLEST_SEED:
        return None
    # next to a full turn the digits of what is missing to it count
    spare = _SPARE_BITS + (2 * max(0, -magnitude_bits(arb(near))) if u > 1.0 else 0)
    half, right = bits // 2 + _SPARE_BITS, _SEED_BITS
    with precision(bits + spare):
        x = (2 * arb.pi() - near).mid() if u > 1.0 else arb(near)
    while right < half:
        right = min(3 * right - 4, half)
        with precision(right + spare):
            x = (x + early_shift(early_point(gap, push, x))).mid()
    with precision(bits + spare):
        at = early_point(gap, push, x)
        # a first guess of the distance: half the bits are right, more where the inputs are wide
        width = (2 * abs(at.value / at.steepness)).upper() + x * arb(2) ** -(bits + _SPARE_BITS)
        for _ in range(3):
            region = arb(x, width.upper())
            if not (region > 0 and region < 2 * arb.pi()):
                return None
            with precision(half + spare):
                steepness, bend = _over(gap, push, region)
            shift = at.value / steepness
            if steepness > 0 and region.contains_interior(x + shift):
                square = shift * shift / 2
                depth = at.depth + at.rise * shift + bend * square
                return x + shift, depth, widened((1 + at.cotangent * shift) / at.reciprocal, square)
            width = 4 * width
    return None


def _over(gap: arb, push: arb, region: arb) -> tuple[arb, arb]:
    """Return minus the slope of the equation and h' over a ball of angles; c, h and h' = 1 - h cot > 0 grow there."""
    low, high = (early_point(gap, push, end) for end in (region.lower(), region.upper()))
    steepness = (low.depth.union(high.depth) + gap) / versine(region)
    return steepness, arb(0).union(1 - high.rise * high.cotangent)
