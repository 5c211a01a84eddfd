"""Stick and slip for a1 = 0, chained through the variables in which each is free of cancellation: locate, flow, snap.

Every number is dimensionless (frame.py). A slip lives in the variables of flows/slip.py; a stick phase is one rotation.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.float64 import (
    ZERO,
    atan2,
    exactly,
    resolved,
    rough,
    sign,
    signed,
    sine_cosine,
    sqrt,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import ABOVE_CRITICAL, ENDS_INSIDE, LEAVES_AT_ONCE, WHICH_WAY
from numerics.arithmetic.telling import text
from numerics.contact.free import first_contact
from numerics.contact.surface import contact
from numerics.flows.slip import Variables, gap_at, push_at, slid_at
from numerics.motion.codes import MOVING, OUT_OF_RANGE, RAY, STICK, STUCK, SURFACE
from numerics.motion.records import At, no_damping
from numerics.motion.seen import (
    seen_excess_at_exit,
    seen_exit_time,
    seen_flow,
    seen_landing,
    seen_on_ray,
    seen_ray_landing,
)


class Pair(NamedTuple):
    """The reduced parameters, and whether v1 = v2 is never left (the law three-valued-sgn).

    two_zeta is exactly 0; the sensitivities see the damper through it.
    """

    q: Number
    r: Number
    sqrt_q: Number
    two_zeta: Number
    literal: bool


class Start(NamedTuple):
    """The start of a mode of motion. In stick X = side (1 + gap) and V = push; in a slip the variables of slip.py.

    `driven` is side V2/sqrt(q); `turns` belongs to a free slip; tau (with its rounding `rest`) is the reduced time;
    `spent` is what friction has taken from E/E_cr so far, a sum of positive terms that never cancels.
    """

    kind: int
    side: float
    X: Number
    guard: Number
    gap: Number
    push: Number
    driven: Number
    turns: bool
    Z: Number
    w: Number
    tau: Number
    rest: Number
    spent: Number


class Landing(NamedTuple):
    """The end of a slip: its angle, the gap there, K up to there, and the excess w.

    For the error bounds: 1 - cos theta of a slip from S, and how far above 0 the lowest minimum of its guard stayed.
    """

    theta: Number
    gap: Number
    slid: Number
    w: Number
    versine: Number
    spared: float


class Reach(NamedTuple):
    """How a stick phase ends: the side of the exit, 1 - (side X) at its start, side V + sqrt w, and sqrt w."""

    side: float
    below: Number
    reach: Number
    root: Number


@text
def mode_of(start: Start) -> int:
    """Return the sign of V1 - V2 in a motion."""
    return 0 if start.kind == STICK else -int(start.side)


@text
def exit_side(start: Start) -> float:
    """Return the side by which a stick phase leaves S0."""
    return 1.0 if sign(start.push, WHICH_WAY) > 0 else -1.0


@text
def stick_reach(start: Start) -> Reach:
    """Return how a stick phase with w > 0 ends."""
    side = exit_side(start)
    below = -start.gap if side == start.side else 2 + start.gap
    root = sqrt(start.w)
    return Reach(side, below, signed(side, start.push) + root, root)


@text
def locate(pair: Pair, start: Start) -> tuple[int, Number, Landing]:
    """Return (how it goes on, duration, landing) of a motion: MOVING until its event, STUCK, or OUT_OF_RANGE.

    The exit of a stick phase on side sigma is at e = (1, sqrt w) in (sigma X, sigma V), as far from 0 as the start
    p = (a, v). So p - e is at right angles to p + e, and the tangent of half the angle between p and e is
    (1 - a)/(v + sqrt w).
    """
    if start.kind == STICK:
        if pair.literal or sign(start.w, ABOVE_CRITICAL) <= 0:
            return STUCK, ZERO, no_landing()
        exit_at = stick_reach(start)
        duration = 2 * atan2(exit_at.below, exit_at.reach)
        return MOVING, seen_exit_time(pair, start, exit_at.side, duration), no_landing()
    at = landing(pair, start)
    if not resolved(at.theta):
        return OUT_OF_RANGE, ZERO, at
    return MOVING, pair.sqrt_q * at.theta, at


@text
def no_landing() -> Landing:
    """Return what stands for the landing of a stick phase."""
    return Landing(ZERO, ZERO, ZERO, ZERO, 0.0, 0.0)


@text
def landing(pair: Pair, start: Start) -> Landing:
    """Return where and how the bodies of a slip meet in velocity again.

    w is w - 2 r q K near E_cr, and V^2 + (X^2 - 1) from far above it: there the difference would keep the rounding of
    the large w through every later crossing.
    """
    if start.kind == RAY:
        return seen_ray_landing(pair, start, ray_landing(pair, start))
    q, r, at = pair.q, pair.r, Variables(start.guard, start.gap, start.push)
    if start.kind == SURFACE:
        theta, depth, versine = contact(start.gap, start.push)
        gap, slid, spared = -(start.gap + depth), depth * (depth / 2 + start.gap), math.inf
    else:
        theta, spared = first_contact(at, start.turns)
        gap, slid, versine = gap_at(at, theta), slid_at(at, theta), 0.0
    if rough(start.w) <= 1.0:
        w = start.w - 2 * r * q * slid
    else:
        V, beyond = pair.sqrt_q * (start.driven - theta), q * gap
        w = V * V + beyond * (2 + beyond)
    return seen_landing(pair, start, Landing(theta, gap, slid, w, versine, spared))


@text
def ray_landing(pair: Pair, start: Start) -> Landing:
    """Return the end of a slip from an exit ray: everything is a function of the excess w = q u^2."""
    theta, depth, versine = contact(ZERO, start.push)
    w = start.w - pair.r * pair.q * depth * depth
    return Landing(theta, -depth, depth * depth / 2, w, versine, math.inf)


@text
def arrive(pair: Pair, start: Start, end: Landing, duration: Number) -> Landing:  # noqa: ARG001
    """Return the end of a motion: a slip's landing says all."""
    return end


@text
def follow(pair: Pair, start: Start, at: Landing, duration: Number, tau: Number, rest: Number) -> Start:
    """Return the start of the motion that follows at time tau."""
    if start.kind == STICK:
        side = exit_side(start)
        return on_ray(pair, side, start.Z, seen_excess_at_exit(pair, start, duration), tau, rest, start.spent)
    return after_landing(pair, start, at, tau, rest)


@text
def on_ray(pair: Pair, side: float, Z: Number, w: Number, tau: Number, rest: Number, spent: Number) -> Start:
    """Return the slip that leaves S0 by the ray on this side, where X = side and V = side sqrt(w) exactly."""
    push = sqrt(w) / pair.sqrt_q
    return seen_on_ray(pair, Start(RAY, side, exactly(side), ZERO, ZERO, push, push, True, Z, w, tau, rest, spent))


@text
def after_landing(pair: Pair, start: Start, at: Landing, tau: Number, rest: Number) -> Start:
    """Return the start of the motion after a slip: stick inside the sliding region, else the slip of the other sign."""
    q, side = pair.q, start.side
    turned, offset = start.driven - at.theta, q * at.gap
    X, Z = signed(side, 1 + offset), start.Z - signed(side, q * at.slid)
    beyond, spent = -(2 + offset), start.spent + 2 * pair.r * q * at.slid
    if not pair.literal:
        outside = sign(beyond, ENDS_INSIDE)
        if outside == 0:
            outside = sign(-turned, LEAVES_AT_ONCE)
        if outside > 0:
            return Start(SURFACE, -side, X, ZERO, beyond / q, -turned, -turned, True, Z, at.w, tau, rest, spent)
    return Start(
        STICK, side, X, ZERO, offset, signed(side, pair.sqrt_q * turned), ZERO, True, Z, at.w, tau, rest, spent
    )


@text
def velocity(pair: Pair, start: Start) -> Number:
    """Return V = V1 = V2 at the start of a motion on the switching surface."""
    if start.kind == STICK:
        return start.push
    return signed(start.side, sqrt(start.w) if start.kind == RAY else pair.sqrt_q * start.driven)


@text
def flow(pair: Pair, start: Start, tau: Number) -> At:
    """Return the state at tau after the start of a motion, and what friction has taken from E/E_cr until then."""
    if start.kind == STICK:
        sine, cosine = sine_cosine(tau)
        X, V = start.X * cosine + start.push * sine, start.push * cosine - start.X * sine
        return seen_flow(pair, start, tau, At(X, V, V, start.Z, start.w, start.spent, no_damping()))
    q, side, theta = pair.q, start.side, tau / pair.sqrt_q
    at = Variables(start.guard, start.gap, start.push)
    slid, turned = slid_at(at, theta), start.driven - theta
    X, V1 = signed(side, 1 + q * gap_at(at, theta)), signed(side, pair.sqrt_q * push_at(at, theta))
    V2, Z, lost = signed(side, pair.sqrt_q * turned), start.Z - signed(side, q * slid), 2 * pair.r * q * slid
    return seen_flow(pair, start, tau, At(X, V1, V2, Z, start.w - lost, start.spent + lost, no_damping()))
