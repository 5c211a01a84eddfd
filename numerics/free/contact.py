"""Where an undamped slip that starts on the switching surface ends, in closed form but for one monotone equation.

With gap d >= 0 and push u at the start (slip.py), h(theta) = (theta - sin theta)/(1 - cos theta) and depth
c(theta) = 2 - theta cot(theta/2), the slip ends at the one angle in (0, 2 pi) with

    u + d cot(theta/2) - h(theta) = 0                the guard over 1 - cos: its root at the start is divided out
    d' = -(d + c),   u' = u - theta,   w' = w - q r c (c + 2 d)

The left side falls strictly from +infinity (or u > 0, if d = 0) to -infinity: there is one root and it is the first.
Close to a full turn (u > 1) the angle eta that is missing to 2 pi is the variable, which theta would round away.

Binary64 solves it in contact_binary64.py. A finer arithmetic takes steps of Halley's method from there, each of which
triples the right digits: double-double takes one. Balls do so up to half of the bits asked for, the precision tripled
with each step; there the function is evaluated once at full precision, at the price of one sine-cosine, and one
interval Newton step encloses the root: its slope need only be known to half of the bits. The inclusion proves the root;
that it is the only one in (0, 2 pi), hence the first, is a theorem.
"""

from __future__ import annotations

import math
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
_NARROW_BITS = 20


class Point(NamedTuple):
    """The equation at an angle: c, k = cot(theta/2), h, 1/(1 - cos), its value, and its slope with the sign turned."""

    gap: Number
    theta: Number
    depth: Number
    cotangent: Number
    rise: Number
    reciprocal: Number
    value: Number
    steepness: Number


@compilable
def _refined_contact(gap: Pair, push: Pair) -> tuple[Pair, Pair, Pair]:
    """Return the contact in double-double, by one step from the root of binary64."""
    if push.high > 1.0:
        at = late_point(gap, push, Pair(late_angle(gap.high, push.high), 0.0))
    else:
        at = early_point(gap, push, Pair(binary64_contact(gap.high, push.high)[0], 0.0))
    shift = halley_shift(at)  # c' = h, h' = 1 - h k
    grown = shift * at.rise + shift * shift * (1 - at.rise * at.cotangent) / 2
    return at.theta + shift, at.depth + grown, 1 / at.reciprocal


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
def early_point(gap: Number, push: Number, theta: Number) -> Point:
    """Return the equation at an angle; from one sine and cosine."""
    depth, cotangent = depth_and_cotangent(theta)
    # the Riccati equation of the depth c: in h = c' = ((theta^2 + c^2)/2 - c)/theta at most one bit cancels
    rise = ((theta * theta + depth * depth) / 2 - depth) / theta
    reciprocal = (1 + cotangent * cotangent) / 2
    value = (push + gap * cotangent) - rise
    return Point(gap, theta, depth, cotangent, rise, reciprocal, value, (gap + depth) * reciprocal)


@compilable
def late_point(gap: Number, push: Number, eta: Number) -> Point:
    """Return the equation at an angle that is missing to a full turn; from one sine and cosine."""
    theta, (sine, cosine) = two_pi(gap) - eta, sine_cosine(eta / 2)
    cotangent, reciprocal = -cosine / sine, 1 / (2 * (sine * sine))
    depth, rise = 2 - theta * cotangent, theta * reciprocal - cotangent
    value = (push + gap * cotangent) - rise
    return Point(gap, theta, depth, cotangent, rise, reciprocal, value, (gap + depth) * reciprocal)


@compilable
def halley_shift(at: Point) -> Number:
    """Return the step of Halley's method, in theta, from a point next to the root."""
    shift = at.value / at.steepness
    bend = ((at.gap + at.depth) * at.cotangent - at.rise) * at.reciprocal
    return shift + shift * shift * (bend / at.steepness) / 2


def bracketed_contact(gap: Number, push: Number) -> tuple[Number, Number, Number]:
    """Return the contact without binary64's root: by a bracket, for arguments of any size (see early_bracket)."""
    is_late = as_float(push) > 1.0
    lower, upper = (like(gap, 0.0), late_bound(gap, push)) if is_late else early_bracket(gap, push)
    point_at = late_point if is_late else early_point

    def value_and_slope(_: None, x: Number) -> tuple[Number, Number]:
        point = point_at(gap, push, x)
        return -point.value if is_late else point.value, -point.steepness

    at = point_at(gap, push, falling_root(lower, upper, value_and_slope, None))
    return at.theta, at.depth, 1 / at.reciprocal


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
            x = (x + halley_shift(early_point(gap, push, x))).mid()
    with precision(bits + spare):
        at = early_point(gap, push, x)
        # a first guess of the distance: half the bits are right, more where the inputs are wide
        width = (2 * abs(at.value / at.steepness)).upper() + x * arb(2) ** -(bits + _SPARE_BITS)
        for _ in range(3):
            region = arb(x, width.upper())
            if not (region > 0 and region < 2 * arb.pi()):
                return None
            with precision(half + spare):
                steepness, bend = _over(at, push, region)
            shift = at.value / steepness
            if steepness > 0 and region.contains_interior(x + shift):
                square = shift * shift / 2
                depth = at.depth + at.rise * shift + bend * square
                return x + shift, depth, widened((1 + at.cotangent * shift) / at.reciprocal, square)
            width = 4 * width
    return None


def _over(at: Point, push: arb, region: arb) -> tuple[arb, arb]:
    """Return minus the slope of the equation and h' over a ball of angles about a point.

    c' = h, and c, h and h' = 1 - h cot > 0 grow there. Of a narrow ball, 1 + k h >= h' bounds the growth of h from its
    middle; of a wide one the ends say more.
    """
    if region.rel_accuracy_bits() > _NARROW_BITS:
        spread, k = region.rad(), abs((region / 2).cot()).upper()
        most = (at.rise + spread) * (k * spread).exp()
        depth, bend = at.depth + arb(0, (most * spread).upper()), 1 + k * most
    else:
        low, high = (early_point(at.gap, push, end) for end in (region.lower(), region.upper()))
        depth, bend = low.depth.union(high.depth), 1 - high.rise * high.cotangent
    return (depth + at.gap) / versine(region), arb(0).union(bend)
