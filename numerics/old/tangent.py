"""Formulas that may be differentiated, where the values are found by others: one for every motion.

The undamped motions chain their values through what is free of cancellation, by formulas that hold with guard 0, gap 0
or damping 0 exactly. Their derivatives need the neighbours too: all formulas here are right to first order in

    g      the guard at the start of a slip, 0 on the switching surface
    d      the gap on an exit ray, which a damper makes -2 zeta sqrt(w)/q: the region is |X + 2 zeta V| <= 1
    eta    2 zeta, which is 0 for a1 = 0: y'' + eta y' + y = 0 turns the solution (y, v) = R(t) (y0, v0) into
           y + eta (y0 sin t - t y)/2,  v - eta (v0 sin t + t v)/2;  energy is lost at the rate 2 eta v^2
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from numerics.arithmetic.dual_number import DualNumber, linear
from numerics.arithmetic.protocol import Number
from numerics.motion.frame import Frame, ReducedState
from numerics.old.slip_flow import SlipFlow

if TYPE_CHECKING:
    from numerics.old.oscillator import Oscillator
    from numerics.old.undamped import Landing, UndampedSlip, UndampedStick


class _Slipped(NamedTuple):
    """Guard, gap, push and K of a slip at an angle, and the reduced energy that a damper took."""

    guard: Number
    gap: Number
    push: Number
    slid: Number
    damped: Number


def _slipped(frame: Frame, flow: SlipFlow, theta: Number) -> _Slipped:
    """Return the slip at angle theta; in terms of it the damping is eta/sqrt(q)."""
    arithmetic, damping = frame.arithmetic, frame.two_zeta / frame.sqrt_q
    g, d, u, level = flow.guard_at_start, flow.gap_at_start, flow.push_at_start, 1 + flow.gap_at_start
    (cosine, sine), versine, deficit = (
        arithmetic.cos_sin(theta),
        arithmetic.versine(theta),
        arithmetic.sine_deficit(theta),
    )
    gap, push = d + (u * sine - level * versine), u * cosine - level * sine
    gap_lost, push_lost = (theta * (1 + gap) - level * sine) / 2, (theta * push + u * sine) / 2
    # the integral of push^2, as (push (1 + gap))' = push^2 - (1 + gap)^2 and the sum of both squares is constant
    square = ((level * level + u * u) * theta + push * (1 + gap) - u * level) / 2
    return _Slipped(
        guard=((d * sine + u * versine) - deficit) + g + damping * push_lost,
        gap=gap - damping * gap_lost,
        push=push - damping * push_lost,
        slid=((d * versine + u * deficit) - arithmetic.cosine_deficit(theta)) + g * theta + damping * gap_lost,
        damped=2 * damping * frame.q * frame.q * square,
    )


def slip_landing(slip: UndampedSlip, found: Landing) -> Landing:
    """Return the end of a slip: its angle by one step of Newton's method from where it is known to be.

    What follows from the step: the gap grows with the push, and K with the guard, which is 0 there.
    """
    frame, one = slip.frame, slip.frame.arithmetic.number(1)
    at = _slipped(frame, slip.flow, found.theta)
    theta = found.theta - at.guard / found.gap
    gap = linear(found.gap, (one, at.gap), (at.push, theta))
    if frame.arithmetic.to_float(slip.w) <= 1:
        w = slip.w - 2 * frame.r * frame.q * at.slid - at.damped
    else:
        w = slip.excess_from_above(theta, gap)
    return found._replace(theta=theta, gap=gap, slid=at.slid, w=w)


def ray_landing(slip: UndampedSlip, found: Landing) -> Landing:
    """Return the end of a slip from an exit ray: what depends on w apart, by its slope dw'/dw = 1 - r (1 - cos theta).

    It lies in [-1, 1]: formed whole, enclosures do not grow from one excursion to the next.
    """
    frame, w, theta = slip.frame, slip.w, found.theta
    one, arithmetic = frame.arithmetic.number(1), frame.arithmetic
    gap, push = on_ray(frame, DualNumber(w.value))  # at fixed w
    at = _slipped(frame, SlipFlow(arithmetic, arithmetic.number(0), gap, push), theta)
    push_by_w, versine = 1 / (2 * frame.q * push), arithmetic.versine(theta)
    theta_by_w = -versine * push_by_w / found.gap
    gap_by_w = arithmetic.cos_sin(theta)[1] * push_by_w + at.push * theta_by_w
    fixed = theta - at.guard / found.gap
    lost = 2 * frame.r * frame.q * at.slid + at.damped
    return found._replace(
        theta=linear(theta, (one, fixed), (theta_by_w, w)),
        gap=linear(found.gap, (one, at.gap), (at.push, fixed), (gap_by_w, w)),
        slid=linear(found.slid, (one, at.slid), (arithmetic.sine_deficit(theta) * push_by_w, w)),
        w=linear(found.w, (-one, lost), (1 - frame.r * versine, w)),
    )


def slip_state(slip: UndampedSlip, tau: Number) -> ReducedState:
    """Return the state of a slip at reduced time tau."""
    frame, side = slip.frame, slip.side
    theta = tau / frame.sqrt_q
    at = _slipped(frame, slip.flow, theta)
    return ReducedState(
        X=side * (1 + frame.q * at.gap),
        V1=side * frame.sqrt_q * at.push,
        V2=side * frame.sqrt_q * (slip.driven_at_start - theta),
        Z=slip.start.Z - side * frame.q * at.slid,
        w=slip.w - 2 * frame.r * frame.q * at.slid - at.damped,
    )


def on_ray(frame: Frame, w: Number) -> tuple[Number, Number]:
    """Return gap and push on an exit ray, where X + 2 zeta V = side."""
    root = frame.arithmetic.sqrt(w)
    return -frame.two_zeta * root / frame.q, (root + frame.two_zeta) / frame.sqrt_q


def stick_exit(stick: UndampedStick, tau: Number, side: int) -> Number:
    """Return what a damper adds to the time of the exit, at tau: there X + eta V = side and V = side sqrt(w)."""
    _, sine = stick.frame.arithmetic.cos_sin(tau)
    velocity = side * stick.frame.arithmetic.sqrt(stick.start.w)
    return -stick.frame.two_zeta * ((stick.start.X * sine - tau * side) / (2 * velocity) + 1)


def excess_at_exit(stick: UndampedStick, w: Number) -> Number:
    """Return the energy excess at the exit; the integral of V^2 is (tau (X^2 + V^2) + X V)/2 between the ends."""
    start, root = stick.start, stick.frame.arithmetic.sqrt(w)
    lost = stick.duration() * (1 + w) + root - start.X * start.V1
    return start.w - stick.frame.two_zeta * lost


def stick_state(stick: UndampedStick, tau: Number) -> ReducedState:
    """Return the state of a stick phase at reduced time tau."""
    start, eta = stick.start, stick.frame.two_zeta
    cosine, sine = stick.frame.arithmetic.cos_sin(tau)
    X, V = start.X * cosine + start.V1 * sine, start.V1 * cosine - start.X * sine
    velocity = V - eta * (start.V1 * sine + tau * V) / 2
    lost = eta * ((start.X * start.X + start.V1 * start.V1) * tau + X * V - start.X * start.V1)
    return ReducedState(X + eta * (start.X * sine - tau * X) / 2, velocity, velocity, start.Z, start.w - lost)


def basis(oscillator: Oscillator, t: DualNumber, found: tuple[DualNumber, DualNumber]) -> tuple[DualNumber, DualNumber]:
    """Return e^(-dt) (cos nt, sin(nt)/n) as functions of d, t and n^2 = k - d^2, smooth through critical damping."""
    cosine, sine = found
    decay, squared = oscillator.decay, oscillator.stiffness - oscillator.decay * oscillator.decay
    signed = oscillator.regime * oscillator.frequency * oscillator.frequency
    return (
        linear(cosine, (-t * cosine, decay), (-t * sine / 2, squared), (-decay * cosine - signed * sine, t)),
        linear(
            sine,
            (-t * sine, decay),
            (_sine_by_square(oscillator, t, cosine, sine), squared),
            (cosine - decay * sine, t),
        ),
    )


def _sine_by_square(oscillator: Oscillator, t: DualNumber, cosine: DualNumber, sine: DualNumber) -> DualNumber:
    """Return the derivative of e^(-dt) sin(nt)/n with respect to n^2, (t cos - sin/n)/(2 n^2), next to n = 0 by series.

    It is -t^3 (1/3! - 2 z/5! + 3 z^2/7! - ...) with z = n^2 t^2.
    """
    arithmetic = oscillator.arithmetic
    squared = oscillator.regime * oscillator.frequency * oscillator.frequency
    z = squared * t * t
    if oscillator.regime and abs(arithmetic.to_float(z)) > 1:
        return (t * cosine - sine) / (2 * squared)
    enough = arithmetic.number(Fraction(1, 10 ** (arithmetic.digits + 5)))
    total = term = arithmetic.number(Fraction(1, 6))
    j = 1
    while oscillator.regime and abs(term) > enough:
        j += 1
        term = -term * z * j / ((j - 1) * 2 * j * (2 * j + 1))
        total = total + term
    if oscillator.regime and arithmetic.name == "ball":
        total = total + DualNumber(term.value.union(-term.value))  # what is left out is less than the last term
    return -t * t * t * total * arithmetic.exp(-oscillator.decay * t)
