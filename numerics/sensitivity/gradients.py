"""Gradients of the undamped motions, whose values are found by formulas that hold at one point only.

Those chain their values through what is free of cancellation, with guard 0, gap 0 or damping 0 exactly. Derivatives
need the neighbours too: all formulas here are right to first order in

    g      the guard at the start of a slip, 0 on the switching surface
    d      the gap on an exit ray, which a damper makes -2 zeta sqrt(w)/q: the region is |X + 2 zeta V| <= 1
    eta    2 zeta, which is 0 for a1 = 0: y'' + eta y' + y = 0 turns the solution (y, v) = R(t) (y0, v0) into
           y + eta (y0 sin t - t y)/2,  v - eta (v0 sin t + t v)/2;  energy is lost at the rate 2 eta v^2

They are texts for dual numbers: each returns the values that were found, with the gradients of its own formula.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.dual_number import DualNumber, linear
from numerics.arithmetic.float64 import (
    cosine_deficit,
    exactly,
    rough,
    signed,
    sin,
    sine_cosine,
    sine_deficit,
    sqrt,
    versine,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.flows.slip import Variables
from numerics.motion.codes import RAY, STICK
from numerics.motion.records import At
from numerics.motion.undamped import Landing, Pair, Start


class Slipped(NamedTuple):
    """Guard, gap, push and K of a slip at an angle, and the reduced energy that a damper took."""

    guard: Number
    gap: Number
    push: Number
    slid: Number
    damped: Number


def constant(found: Any) -> Any:
    """Return numbers without their gradients."""
    if isinstance(found, DualNumber):
        return DualNumber(found.value)
    return type(found)(*map(constant, found)) if isinstance(found, tuple) else found


def with_gradients(found: Any, formed: Any) -> Any:
    """Return the values found with the gradients of what was formed."""
    if isinstance(found, DualNumber):
        return DualNumber(found.value, formed.gradient)
    pairs = zip(found, formed, strict=True)
    return type(found)(*(with_gradients(one, two) if isinstance(one, DualNumber) else one for one, two in pairs))


@text
def slipped(pair: Pair, at: Variables, theta: Number) -> Slipped:
    """Return the slip at angle theta; in terms of it the damping is eta/sqrt(q)."""
    damping, (g, d, u), level = pair.two_zeta / pair.sqrt_q, at, 1 + at.gap
    (sine, cosine), drop, deficit = sine_cosine(theta), versine(theta), sine_deficit(theta)
    gap, push = d + (u * sine - level * drop), u * cosine - level * sine
    gap_lost, push_lost = (theta * (1 + gap) - level * sine) / 2, (theta * push + u * sine) / 2
    # the integral of push^2, as (push (1 + gap))' = push^2 - (1 + gap)^2 and the sum of both squares is constant
    square = ((level * level + u * u) * theta + push * (1 + gap) - u * level) / 2
    return Slipped(
        guard=((d * sine + u * drop) - deficit) + g + damping * push_lost,
        gap=gap - damping * gap_lost,
        push=push - damping * push_lost,
        slid=((d * drop + u * deficit) - cosine_deficit(theta)) + g * theta + damping * gap_lost,
        damped=2 * damping * pair.q * pair.q * square,
    )


@text
def landing(pair: Pair, start: Start, found: Landing) -> Landing:
    """Return the end of a slip: its angle by one step of Newton's method from where it is known to be.

    What follows from the step: the gap grows with the push, and K with the guard, which is 0 there.
    """
    at, known = Variables(start.guard, start.gap, start.push), constant(found)
    one: Number = exactly(1.0)
    there = slipped(pair, at, known.theta)
    theta = known.theta - there.guard / known.gap
    gap = linear(known.gap, (one, there.gap), (there.push, theta))
    if rough(start.w) <= 1.0:
        w = start.w - 2 * pair.r * pair.q * there.slid - there.damped
    else:
        V, beyond = pair.sqrt_q * (start.driven - theta), pair.q * gap
        w = V * V + beyond * (2 + beyond)
    return with_gradients(found, found._replace(theta=theta, gap=gap, slid=there.slid, w=w, versine=versine(theta)))


@text
def ray_landing(pair: Pair, start: Start, found: Landing) -> Landing:
    """Return the end of a slip from an exit ray: what depends on w apart, by its slope dw'/dw = 1 - r (1 - cos theta).

    It lies in [-1, 1]: formed whole, enclosures do not grow from one excursion to the next.
    """
    w, known = start.w, constant(found)
    one: Number = exactly(1.0)
    theta, fixed_w = known.theta, constant(w)
    push = (sqrt(fixed_w) + pair.two_zeta) / pair.sqrt_q  # at fixed w
    there = slipped(pair, Variables(0 * push, -pair.two_zeta * sqrt(fixed_w) / pair.q, push), theta)
    push_by_w: Number = 1 / (2 * pair.q * push)
    drop: Number = versine(theta)
    theta_by_w: Number = -drop * push_by_w / known.gap
    gap_by_w: Number = sin(theta) * push_by_w + there.push * theta_by_w
    fixed = theta - there.guard / known.gap
    lost = 2 * pair.r * pair.q * there.slid + there.damped
    formed = found._replace(
        theta=linear(theta, (one, fixed), (theta_by_w, w)),
        gap=linear(known.gap, (one, there.gap), (there.push, fixed), (gap_by_w, w)),
        slid=linear(known.slid, (one, there.slid), (sine_deficit(theta) * push_by_w, w)),
        w=linear(known.w, (-one, lost), (1 - pair.r * drop, w)),
    )
    return with_gradients(found, formed)


@text
def on_ray(pair: Pair, start: Start) -> Start:
    """Return the start of a slip from an exit ray, where X + 2 zeta V = side."""
    root = sqrt(start.w)
    gap, push = -pair.two_zeta * root / pair.q, (root + pair.two_zeta) / pair.sqrt_q
    formed = start._replace(X=signed(start.side, 1 + pair.q * gap), gap=gap, push=push, driven=push)
    return with_gradients(start, formed)


@text
def velocity(pair: Pair, start: Start) -> Number:
    """Return V = V1 = V2 at the start of a motion on the switching surface."""
    if start.kind == STICK:
        return start.push
    formed = signed(start.side, pair.sqrt_q * start.driven)
    return with_gradients(signed(start.side, sqrt(start.w)), formed) if start.kind == RAY else formed


@text
def exit_time(pair: Pair, start: Start, side: float, duration: Number) -> Number:
    """Return the time of the exit with what a damper adds to it: there X + eta V = side and V = side sqrt(w)."""
    tau, speed = constant(duration), signed(side, sqrt(start.w))
    added = -pair.two_zeta * ((start.X * sin(tau) - signed(side, tau)) / (2 * speed) + 1)
    return with_gradients(duration, duration + added)


@text
def excess_at_exit(pair: Pair, start: Start, duration: Number) -> Number:
    """Return the energy excess at the exit; the integral of V^2 is (tau (X^2 + V^2) + X V)/2 between the ends."""
    w = constant(start.w)
    lost = duration * (1 + w) + sqrt(w) - start.X * start.push
    return with_gradients(start.w, start.w - pair.two_zeta * lost)


@text
def flow(pair: Pair, start: Start, tau: Number, found: At) -> At:
    """Return the state at reduced time tau after the start of a motion."""
    if start.kind == STICK:
        return with_gradients(found, in_stick(pair, start, tau, found))
    side, theta = start.side, tau / pair.sqrt_q
    there = slipped(pair, Variables(start.guard, start.gap, start.push), theta)
    lost = 2 * pair.r * pair.q * there.slid
    formed = found._replace(
        X=signed(side, 1 + pair.q * there.gap),
        V1=signed(side, pair.sqrt_q * there.push),
        V2=signed(side, pair.sqrt_q * (start.driven - theta)),
        Z=start.Z - signed(side, pair.q * there.slid),
        w=start.w - lost - there.damped,
    )
    return with_gradients(found, formed)


@text
def in_stick(pair: Pair, start: Start, tau: Number, found: At) -> At:
    """Return the state of a stick phase at reduced time tau."""
    eta, (sine, cosine) = pair.two_zeta, sine_cosine(tau)
    X, V = start.X * cosine + start.push * sine, start.push * cosine - start.X * sine
    speed = V - eta * (start.push * sine + tau * V) / 2
    lost = eta * ((start.X * start.X + start.push * start.push) * tau + X * V - start.X * start.push)
    place = X + eta * (start.X * sine - tau * X) / 2
    return found._replace(X=place, V1=speed, V2=speed, Z=start.Z, w=start.w - lost)
