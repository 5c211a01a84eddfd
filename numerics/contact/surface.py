"""Where an undamped slip that starts on the switching surface ends, in closed form but for one monotone equation.

With gap d >= 0 and push u at the start (flows/slip.py), h(theta) = (theta - sin theta)/(1 - cos theta) and depth
c(theta) = 2 - theta cot(theta/2), the slip ends at the one angle in (0, 2 pi) with

    u + d cot(theta/2) - h(theta) = 0                the guard over 1 - cos: its root at the start is divided out
    d' = -(d + c),   u' = u - theta,   w' = w - q r c (c + 2 d)

The left side falls strictly from +infinity (or u > 0, if d = 0) to -infinity: there is one root and it is the first.
Close to a full turn (u > 1) the angle eta that is missing to 2 pi is the variable, which theta would round away:

    2 pi + d sin eta - u (1 - cos eta) - (eta - sin eta) = 0,        c = 2 + theta cot(eta/2)

Binary64 solves it in seed.py; a finer arithmetic takes steps of Halley's method from there, `early_step` or
`late_step`, each of which triples the right digits.
"""

from __future__ import annotations

from typing import NamedTuple

from numerics.arithmetic.float64 import (
    ZERO,
    depth_and_cotangent,
    exactly,
    half_turn,
    leading,
    part,
    rough,
    sine_cosine,
    sqrt,
    turn,
    versine,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.contact.root import root_of
from numerics.contact.seed import binary64_contact, late_angle


class Contact(NamedTuple):
    """The end of a slip: its angle theta, the depth c(theta) and 1 - cos theta, each accurate relative to itself.

    In double-double 1 - cos theta serves the error bounds only and is a float.
    """

    theta: Number
    depth: Number
    versine: Number


@text
def contact(gap: Number, push: Number) -> Contact:
    """Return the end of a slip from S with gap d >= 0 and push u (> 0 if d = 0): in binary64, and for others to say."""
    theta, depth, drop = binary64_contact(gap, push)
    return Contact(theta, depth, drop)


@text
def refined_contact(gap: Number, push: Number) -> Contact:
    """Return the contact of an arithmetic with up to three times the digits of binary64: one step from its root."""
    if rough(push) > 1.0:
        missing = late_angle(rough(gap), rough(push))
        at = late_step(late_point(gap, push, exactly(missing)))
        return Contact(at.theta, at.depth, rough(at.versine))
    theta, _, drop = binary64_contact(rough(gap), rough(push))
    at = early_step(early_point(gap, push, exactly(theta)))
    return Contact(at.theta, at.depth, drop)


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


@text
def early_point(gap: Number, push: Number, theta: Number) -> EarlyPoint:
    """Return the equation for push <= 1 at an angle; from one sine and cosine."""
    depth, cotangent = depth_and_cotangent(theta)
    # the Riccati equation of the depth c: in h = c' = ((theta^2 + c^2)/2 - c)/theta at most one bit cancels
    rise = ((theta * theta + depth * depth) / 2 - depth) / theta
    reciprocal = (1 + cotangent * cotangent) / 2
    value, steepness = (push + gap * cotangent) - rise, (gap + depth) * reciprocal
    return EarlyPoint(gap, theta, depth, cotangent, rise, reciprocal, value, steepness)


@text
def early_shift(at: EarlyPoint) -> Number:
    """Return the step of Halley's method from a point next to the root."""
    shift = at.value / at.steepness
    near, cotangent = leading(shift), leading(at.cotangent)
    bend = (leading(at.gap + at.depth) * cotangent - leading(at.rise)) * leading(at.reciprocal)
    return shift + part(near * near * (bend / leading(at.steepness)) / 2)


@text
def early_step(at: EarlyPoint) -> Contact:
    """Return the contact by one step: c' = h, h' = 1 - h cot."""
    shift = early_shift(at)
    near, rise = leading(shift), leading(at.rise)
    grown = shift * at.rise + part(near * near * (1 - rise * leading(at.cotangent)) / 2)
    return Contact(at.theta + shift, at.depth + grown, 1 / at.reciprocal)


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


@text
def late_point(gap: Number, push: Number, eta: Number) -> LatePoint:
    """Return the equation for push > 1 at an angle missing to a full turn; from one sine and cosine."""
    half_sine, half_cosine = sine_cosine(eta / 2)
    sine, drop = 2 * (half_sine * half_cosine), 2 * (half_sine * half_sine)
    value = (turn() + gap * sine) - (push * drop + (eta - sine))
    steepness = (push * sine + drop) - gap * (1 - drop)
    return LatePoint(gap, push, eta, half_sine, half_cosine, sine, drop, value, steepness)


@text
def late_shift(at: LatePoint) -> Number:
    """Return the step of Halley's method from a point next to the root."""
    shift = at.value / at.steepness
    near, drop = leading(shift), leading(at.versine)
    bend = -leading(at.gap + 1) * leading(at.sine) - leading(at.push) * (1 - drop)
    return shift + part(near * near * (bend / leading(at.steepness)) / 2)


@text
def late_step(at: LatePoint) -> Contact:
    """Return the contact by one step: dc/d eta = -h, h' = 1 - h cot(theta/2) = 1 + h cot(eta/2)."""
    shift = late_shift(at)
    theta = turn() - at.eta
    depth = 2 + (theta * at.half_cosine) / at.half_sine
    rise = (theta + at.sine) / at.versine
    near = leading(shift)
    slope = 1 + leading(rise) * leading(at.half_cosine) / leading(at.half_sine)
    grown = shift * rise - part(near * near * slope / 2)
    return Contact(theta - shift, depth - grown, at.versine + shift * at.sine)


class Edge(NamedTuple):
    """Gap and push at the start of a slip from S."""

    gap: Number
    push: Number


@text
def early_equation(at: Edge, theta: Number) -> tuple[Number, Number]:
    """Return the equation for push <= 1 and its slope."""
    point = early_point(at.gap, at.push, theta)
    return point.value, -point.steepness


@text
def late_equation(at: Edge, eta: Number) -> tuple[Number, Number]:
    """Return the equation for push > 1 and its slope."""
    point = late_point(at.gap, at.push, eta)
    return point.value, -point.steepness


early_root, late_root = root_of(early_equation, "early_root"), root_of(late_equation, "late_root")


@text
def bracketed_contact(gap: Number, push: Number) -> Contact:
    """Return the contact without binary64's root: by a bracket, for arguments of any size (early_bracket: seed.py)."""
    at = Edge(gap, push)
    if rough(push) > 1.0:
        # versine >= 2 eta^2/pi^2 and sin <= eta on (0, pi]: the root lies below that of 2 u eta^2/pi^2 - d eta - 2 pi
        square = half_turn() * half_turn() / (4 * push)
        upper = square * (gap + sqrt(gap * gap + 16 * push / half_turn()))
        upper = 3 * half_turn() / 2 if rough(upper) > 3.0 else 17 * upper / 16
        eta = late_root(at, ZERO, upper, upper / 2)
        point, theta = late_point(gap, push, eta), turn() - eta
        return Contact(theta, 2 + theta * point.half_cosine / point.half_sine, point.versine)
    lower = 15 * positive_root(push - 2 * gap / half_turn(), 4 * gap) / 16
    upper = 3 * positive_root(push, 8 * gap / 3) / 2
    upper = 33 * half_turn() / 32 if rough(upper) > 3.0 else 17 * upper / 16
    theta = early_root(at, lower, upper, (lower + upper) / 2)
    return Contact(theta, depth_and_cotangent(theta)[0], versine(theta))


@text
def positive_root(b: Number, c: Number) -> Number:
    """Return b + sqrt(b^2 + c), c >= 0, without cancellation."""
    height = sqrt(b * b + c)
    return b + height if rough(b) >= 0.0 else c / (height - b)
