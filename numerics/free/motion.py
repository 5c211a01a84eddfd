"""Stick and slip for a1 = 0, each in the variables in which it is free of cancellation: `next_event`, `resolve`.

Every number is dimensionless (frame.py). A slip lives in the variables of slip.py; a stick phase is one rotation.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import as_float, atan2, like, resolved, sign, signed, sine_cosine, sqrt
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import ABOVE_CRITICAL, ENDS_INSIDE, LEAVES_AT_ONCE, WHICH_WAY
from numerics.free.contact import contact, ray_contact
from numerics.free.slip import Start, first_contact, guard_and_gap, push_at, slid_at

STICK, RAY, SURFACE, FREE = 0, 1, 2, 3
"""Kinds of motion: stick; slips from an exit ray, from elsewhere on the switching surface, from off it."""
MOVING, STUCK, OUT_OF_RANGE = -1, 1, 3
"""How a motion goes on: until its event, for ever, or not in this arithmetic; the last two as in record.How."""


class Parameters(NamedTuple):
    """The reduced parameters; whether v1 = v2 is never left (the law three-valued-sgn); one operation's rounding."""

    q: Number
    r: Number
    sqrt_q: Number
    literal: bool
    unit: float


class Landing(NamedTuple):
    """The end of a slip: its angle, the gap there, K up to there, and the excess w.

    For the error bounds: 1 - cos theta of a slip from S, and how far above 0 the lowest minimum of its guard stayed.
    """

    theta: Number
    gap: Number
    slid: Number
    w: Number
    versine: float
    spared: float


class Reach(NamedTuple):
    """How a stick phase ends: the side of the exit, 1 - (side X) at its start, side V + sqrt w, and sqrt w."""

    side: float
    below: Number
    reach: Number
    root: Number


class MotionState(NamedTuple):
    """A reduced state, and what friction has taken from E/E_cr since the start of the run."""

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number
    spent: Number


@compilable
def mode_of(start: Start) -> int:
    """Return the sign of V1 - V2 in a motion."""
    return 0 if start.kind == STICK else -int(start.side)


@compilable
def order_of(start: Start) -> int:
    """Return how many derivatives of its guard vanish at the start of a slip: v1 - v2 = 0, and on a ray its slope."""
    return 3 - start.kind if start.kind != STICK else 0


@compilable
def exit_side(start: Start) -> float:
    """Return the side by which a stick phase leaves S0."""
    return 1.0 if sign(start.push, WHICH_WAY) > 0 else -1.0


@compilable
def stick_reach(start: Start) -> Reach:
    """Return how a stick phase with w > 0 ends."""
    side = exit_side(start)
    below = -start.gap if side == start.side else 2 + start.gap
    root = sqrt(start.w)
    return Reach(side, below, signed(side, start.push) + root, root)


@compilable
def next_event(at: Parameters, start: Start) -> tuple[int, Number, Landing]:
    """Return (how it goes on, duration, landing) of a motion: MOVING until its event, STUCK, or OUT_OF_RANGE.

    The exit of a stick phase on side sigma is at e = (1, sqrt w) in (sigma X, sigma V), as far from 0 as the start
    p = (a, v). So p - e is at right angles to p + e, and the tangent of half the angle between p and e is
    (1 - a)/(v + sqrt w).
    """
    zero = like(start.w, 0.0)
    if start.kind == STICK:
        none = Landing(zero, zero, zero, zero, 0.0, 0.0)
        if at.literal or sign(start.w, ABOVE_CRITICAL) <= 0:
            return STUCK, zero, none
        exit_at = stick_reach(start)
        return MOVING, 2 * atan2(exit_at.below, exit_at.reach), none
    end = landing(at, start)
    if not resolved(end.theta):
        return OUT_OF_RANGE, zero, end
    return MOVING, at.sqrt_q * end.theta, end


@compilable
def landing(at: Parameters, start: Start) -> Landing:
    """Return where and how the bodies of a slip meet in velocity again.

    w is w - 2 r q K near E_cr, and V^2 + (X^2 - 1) from far above it: there the difference would keep the rounding of
    the large w through every later crossing.
    """
    if start.kind == RAY:
        theta, depth, w, drop = ray_contact(start.w, start.push, at.q, at.r, at.sqrt_q)
        return Landing(theta, -depth, depth * depth / 2, w, as_float(drop), math.inf)
    q, r = at.q, at.r
    if start.kind == SURFACE:
        theta, depth, drop = contact(start.gap, start.push)
        gap, slid, versine, spared = -(start.gap + depth), depth * (depth / 2 + start.gap), as_float(drop), math.inf
    else:
        theta, spared = first_contact(start)
        gap, slid, versine = guard_and_gap(start, theta)[1], slid_at(theta, start), 0.0
    if as_float(start.w) <= 1.0:
        w = start.w - 2 * r * q * slid
    else:
        V, beyond = at.sqrt_q * (start.driven - theta), q * gap
        w = V * V + beyond * (2 + beyond)
    return Landing(theta, gap, slid, w, versine, spared)


@compilable
def resolve(at: Parameters, start: Start, end: Landing, tau: Number, rest: Number) -> Start:
    """Return the start of the motion that follows a motion at time tau."""
    if start.kind == STICK:
        return on_ray(at, exit_side(start), start.Z, start.w, tau, rest, start.spent)
    q, side, zero = at.q, start.side, like(start.w, 0.0)
    turned, offset = start.driven - end.theta, q * end.gap
    X, Z = signed(side, 1 + offset), start.Z - signed(side, q * end.slid)
    beyond, spent = -(2 + offset), start.spent + 2 * at.r * q * end.slid
    if not at.literal:
        outside = sign(beyond, ENDS_INSIDE)
        if outside == 0:
            outside = sign(-turned, LEAVES_AT_ONCE)
        if outside > 0:
            return Start(SURFACE, -side, X, zero, beyond / q, -turned, -turned, True, Z, end.w, tau, rest, spent)
    V = signed(side, at.sqrt_q * turned)
    return Start(STICK, side, X, zero, offset, V, zero, True, Z, end.w, tau, rest, spent)


@compilable
def on_ray(at: Parameters, side: float, Z: Number, w: Number, tau: Number, rest: Number, spent: Number) -> Start:
    """Return the slip that leaves S0 by the ray on this side, where X = side and V = side sqrt(w) exactly."""
    push, zero = sqrt(w) / at.sqrt_q, like(w, 0.0)
    return Start(RAY, side, like(w, side), zero, zero, push, push, True, Z, w, tau, rest, spent)


@compilable
def event_state(at: Parameters, start: Start) -> MotionState:
    """Return the state in which a motion starts on the switching surface."""
    if start.kind == STICK:
        V = start.push
    else:
        V = signed(start.side, sqrt(start.w) if start.kind == RAY else at.sqrt_q * start.driven)
    return MotionState(start.X, V, V, start.Z, start.w, start.spent)


@compilable
def state_at(at: Parameters, start: Start, tau: Number) -> MotionState:
    """Return the state at tau after the start of a motion."""
    if start.kind == STICK:
        sine, cosine = sine_cosine(tau)
        X, V = start.X * cosine + start.push * sine, start.push * cosine - start.X * sine
        return MotionState(X, V, V, start.Z, start.w, start.spent)
    q, side, theta = at.q, start.side, tau / at.sqrt_q
    slid, turned = slid_at(theta, start), start.driven - theta
    gap, push = guard_and_gap(start, theta)[1], push_at(start, theta)
    X, V1 = signed(side, 1 + q * gap), signed(side, at.sqrt_q * push)
    V2, Z, lost = signed(side, at.sqrt_q * turned), start.Z - signed(side, q * slid), 2 * at.r * q * slid
    return MotionState(X, V1, V2, Z, start.w - lost, start.spent + lost)
