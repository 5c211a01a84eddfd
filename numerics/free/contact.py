"""Where an undamped slip that starts on the switching surface ends, in closed form but for one monotone equation.

With gap d >= 0 and push u at the start (slip.py), h(theta) = (theta - sin theta)/(1 - cos theta) and depth
c(theta) = 2 - theta cot(theta/2), the slip ends at the one angle in (0, 2 pi) with

    u + d cot(theta/2) - h(theta) = 0                the guard over 1 - cos: its root at the start is divided out
    d' = -(d + c),   u' = u - theta,   w' = w - q r c (c + 2 d)

The left side falls strictly from +infinity (or u > 0, if d = 0) to -infinity: there is one root and it is the first.
Close to a full turn (u > 1) the angle that is missing to 2 pi is the variable, which theta would round away.

Halley's method, which triples the right digits with each step, finds the root among points from a guess. Balls take
steps up to half of the bits asked for, the precision tripled with each; there the function is evaluated once at full
precision, at the price of one sine-cosine, and one interval Newton step encloses the root: its slope need only be known
to half of the bits. The inclusion proves the root; that it is the only one in (0, 2 pi), hence the first, is a theorem.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, ctx

from numerics.arithmetic.ball import undecided, widened
from numerics.arithmetic.functions import (
    as_float,
    depth_and_cotangent,
    midpoint,
    sine_cosine,
    sqrt,
    tolerance,
    two_pi,
    versine,
)
from numerics.arithmetic.precision import precision
from numerics.arithmetic.protocol import Number

_STEPS = 40
_SEARCH_BITS = 64
"""Precision of the search from the guess; Halley's last step leaves more right bits than those below."""
_RIGHT_BITS = 38
_SPARE_BITS = 12


class ContactPoint(NamedTuple):
    """The equation at an angle: c, k = cot(theta/2), h, 1/(1 - cos), its value, and its slope with the sign turned."""

    gap: Number
    theta: Number
    depth: Number
    cotangent: Number
    rise: Number
    reciprocal: Number
    value: Number
    steepness: Number


def is_late(push: Number) -> bool:
    """Return whether the variable is what is missing to a full turn."""
    return bool(midpoint(push) > 1)


def point_at(gap: Number, push: Number, x: Number) -> ContactPoint:
    """Return the equation at an angle, or at what is missing to a full turn; from one sine and cosine."""
    if is_late(push):
        theta, (sine, cosine) = two_pi(gap) - x, sine_cosine(x / 2)
        cotangent, reciprocal = -cosine / sine, 1 / (2 * (sine * sine))
        depth, rise = 2 - theta * cotangent, theta * reciprocal - cotangent
    else:
        theta, (depth, cotangent) = x, depth_and_cotangent(x)
        # the Riccati equation of the depth c: in h = c' = ((theta^2 + c^2)/2 - c)/theta at most one bit cancels
        rise = ((theta * theta + depth * depth) / 2 - depth) / theta
        reciprocal = (1 + cotangent * cotangent) / 2
    value = (push + gap * cotangent) - rise
    return ContactPoint(gap, theta, depth, cotangent, rise, reciprocal, value, (gap + depth) * reciprocal)


def halley_shift(at: ContactPoint) -> Number:
    """Return the step of Halley's method, in theta, from a point next to the root."""
    shift = at.value / at.steepness
    bend = ((at.gap + at.depth) * at.cotangent - at.rise) * at.reciprocal
    return shift + shift * shift * (bend / at.steepness) / 2


def _guess(gap: Number, push: Number) -> Number:
    """Return x next to the root: that of (1/3 + d/6) theta^2 - u theta - 2 d; for push > 1 of u x^2/2 - d x - 2 pi."""
    half_turn = two_pi(gap) / 2
    if is_late(push):
        x = (gap + sqrt(gap * gap + 4 * half_turn * push)) / push
        return x if as_float(x) < 4.7 else 3 * half_turn / 4
    third = (2 + gap) / 3  # twice the coefficient of the square
    b, c = push / third, 4 * gap / third
    root = sqrt(b * b + c)
    x = b + root if as_float(b) >= 0.0 else c / (root - b)
    square = x * x
    return x / (1 + square * (1 / 30 - square / 970))


def _searched(gap: Number, push: Number) -> tuple[Number, ContactPoint]:
    """Return the root among points, and the equation one step from there.

    The steps of Halley's method shrink cubically: after one that is below the cube root of the last bit the error is
    below that.
    """
    x, small, way = midpoint(_guess(gap, push)), midpoint(tolerance(gap) ** 0.34), -1 if is_late(push) else 1
    for _ in range(_STEPS):
        at = point_at(gap, push, x)
        shift = midpoint(halley_shift(at))
        x = midpoint(x + way * shift)
        if abs(shift) <= small * x:
            return x, at
    raise undecided("where does a slip from the switching surface end?", str(x))


def contact(gap: Number, push: Number) -> tuple[Number, Number, Number]:
    """Return theta, c(theta) and 1 - cos theta at the end of a slip from S with gap d >= 0 and push u (> 0 if d = 0).

    Each is accurate relative to itself; in mpmath 1 - cos theta has few digits. Raises EventUndecided.
    """
    if type(gap) is arb:
        return _enclosed(gap, push)
    at = _searched(gap, push)[1]
    shift = halley_shift(at)  # c' = h, h' = 1 - h k
    grown = shift * at.rise + shift * shift * (1 - at.rise * at.cotangent) / 2
    return at.theta + shift, at.depth + grown, (1 + at.cotangent * shift) / at.reciprocal


def ray_contact(w: Number, push: Number, q: Number, r: Number) -> tuple[Number, Number, Number]:
    """Return theta, depth and the excess after it of a slip from an exit ray with excess w = q u^2.

    In balls the contact is located at the centre of w; along w, theta/u falls (h is convex), c' = h and
    dw'/dw = 1 - r (1 - cos theta), which lies in (-1, 1): so enclosures of w do not grow from one excursion to the
    next, however many there are.
    """
    if type(w) is not arb:
        theta, depth, _ = contact(w * 0, push)
        return theta, depth, w - r * q * depth * depth
    centre = w.mid()
    push = sqrt(centre) / sqrt(q)
    theta_there, depth_there, versine_there = contact(arb(0), push)
    stretch = sqrt(w / centre)
    theta = theta_there * stretch
    depth = depth_there + push * stretch * (theta - theta_there)
    # 1 - cos changes by less than |theta - theta at the centre|; 3 makes the ball cover both signs of that difference,
    # of which it lacks a part, as sqrt bends: sqrt 2 - 1 > 1/3
    slope = 1 - r * (versine_there + 3 * (theta - theta_there))
    return theta, depth, (centre - r * q * depth_there * depth_there) + (w - centre) * slope


def _enclosed(gap: arb, push: arb) -> tuple[arb, arb, arb]:
    """Return the contact in balls, proved next to that of the midpoints. Raises EventUndecided."""
    centre, way, half = (gap.mid(), push.mid()), -1 if is_late(push) else 1, ctx.prec // 2 + _SPARE_BITS
    if centre[0] >= 0 and gap.is_finite() and push.is_finite() and (centre[0] > 0 or centre[1] > 0):
        with precision(_SEARCH_BITS):
            x, right = _searched(*centre)[0], _RIGHT_BITS
        while right < half:
            right = min(3 * right - 4, half)
            with precision(right + _SPARE_BITS):
                x = (x + way * halley_shift(point_at(gap, push, x))).mid()
        with precision(ctx.prec + _SPARE_BITS):
            found = _proved(point_at(gap, push, x), push, x, half + _SPARE_BITS)
        if found is not None:
            return found
    raise undecided("existence of a contact next to its approximation", push)


def _proved(at: ContactPoint, push: arb, x: arb, few: int) -> tuple[arb, arb, arb] | None:
    """Return the contact by one interval Newton step from a point, its slope from a `few` bits; None if it fails."""
    # a first guess of the distance: half the bits are right, more where the inputs are wide
    width = (2 * abs(at.value / at.steepness)).upper() + x * arb(2) ** -ctx.prec
    for _ in range(3):
        region = arb(x, width.upper())
        if not (region > 0 and region < 2 * arb.pi()):
            return None
        with precision(few):
            steepness, bend = _over(at, region)
        shift = at.value / steepness
        if steepness > 0 and region.contains_interior(x - shift if is_late(push) else x + shift):
            square = shift * shift / 2
            depth = widened(at.depth + at.rise * shift, bend * square)
            return at.theta + shift, depth, widened((1 + at.cotangent * shift) / at.reciprocal, square)
        width = 4 * width
    return None


def _over(at: ContactPoint, region: arb) -> tuple[arb, arb]:
    """Return minus the slope of the equation and a bound on h' > 0 over a ball of the variable about a point.

    c' = h, and c, h and h' = 1 - h cot > 0 grow with theta; 1 + k h >= h' bounds the growth of h from its middle.
    """
    spread, k = region.rad(), abs((region / 2).cot()).upper()
    most = (at.rise + spread) * (k * spread).exp()
    return (widened(at.depth, most * spread) + at.gap) / versine(region), 1 + k * most
