"""The free pair (a1 = 0, no force, b constant) from event to event, in balls or mpmath: `run_free`, `excursions`.

Every motion is known in closed form, in variables in which nothing cancels: a slip in those of slip.py, a stick phase
is one rotation. So a run takes no step and no sample, and costs as many evaluations as it has events. Every number is
dimensionless (frame.py).

On an exit ray the state is one number, w = E/E_cr - 1 > 0. The slip ends at the angle theta with h(theta) = sqrt(w/q);
then w drops by 2 r q K(theta), and the pair sticks until it reaches a ray again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from numerics.arithmetic.functions import as_float, atan2, require_phase, sign, sine_cosine, sqrt
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.contact import contact, ray_contact
from numerics.free.frame import RAY, STICK, SURFACE, Frame, ReducedState, begin
from numerics.free.slip import Start, first_contact, guard_and_gap, push_at, slid_at
from numerics.linear.record import How, Knot, Record
from numerics.scene import Law, Scene


class Landing(NamedTuple):
    """The end of a slip: its angle, the gap there, K up to there, and the excess w."""

    theta: Number
    gap: Number
    slid: Number
    w: Number


def motions(frame: Frame, start: Start, literal: bool = False) -> Iterator[tuple[Start, Number | None]]:
    """Yield each motion's start and its reduced time to the next event, None for a stick that lasts for ever: the last.

    `literal`: by the law three-valued-sgn, under which v1 = v2 is never left. Inside the arithmetic's context. Raises
    EventUndecided and OutOfRange, each for what is asked.
    """
    while True:
        duration, end = next_event(frame, start, literal)
        yield start, duration
        if duration is None:
            return
        start = resolve(frame, start, end, start.tau + duration, literal)


def mode_of(start: Start) -> int:
    """Return the sign of V1 - V2 in a motion."""
    return 0 if start.kind == STICK else -start.side


def order_of(start: Start) -> int:
    """Return how many derivatives of its guard vanish at the start of a slip: v1 - v2 = 0, and on a ray its slope."""
    return 3 - start.kind if start.kind != STICK else 0


def exit_side(start: Start) -> int:
    """Return the side by which a stick phase leaves S0."""
    return 1 if sign(start.push, "which way does the stuck pair move?") > 0 else -1


def next_event(frame: Frame, start: Start, literal: bool) -> tuple[Number | None, Landing | None]:
    """Return how long a motion lasts, None for a stick for ever, and where a slip lands.

    The exit of a stick phase on side sigma is at e = (1, sqrt w) in (sigma X, sigma V), as far from 0 as the start
    p = (a, v). So p - e is at right angles to p + e, and the tangent of half the angle between p and e is
    (1 - a)/(v + sqrt w).
    """
    if start.kind == STICK:
        if literal or sign(start.w, "is the energy above the critical energy?") <= 0:
            return None, None
        side = exit_side(start)
        below = -start.gap if side == start.side else 2 + start.gap
        return 2 * atan2(below, side * start.push + sqrt(start.w)), None
    end = landing(frame, start)
    require_phase(end.theta)
    return frame.sqrt_q * end.theta, end


def landing(frame: Frame, start: Start) -> Landing:
    """Return where and how the bodies of a slip meet in velocity again.

    w is w - 2 r q K near E_cr, and V^2 + (X^2 - 1) from far above it: there the difference would keep the rounding of
    the large w through every later crossing.
    """
    q, r = frame.q, frame.r
    if start.kind == RAY:
        theta, depth, w = ray_contact(start.w, start.push, q, r)
        return Landing(theta, -depth, depth * depth / 2, w)
    if start.kind == SURFACE:
        theta, depth, _ = contact(start.gap, start.push)
        gap, slid = -(start.gap + depth), depth * (depth / 2 + start.gap)
    else:
        theta = first_contact(start)
        gap, slid = guard_and_gap(start, theta)[1], slid_at(theta, start)
    if as_float(start.w) <= 1.0:
        w = start.w - 2 * r * q * slid
    else:
        V, beyond = frame.sqrt_q * (start.driven - theta), q * gap
        w = V * V + beyond * (2 + beyond)
    return Landing(theta, gap, slid, w)


def resolve(frame: Frame, start: Start, end: Landing | None, tau: Number, literal: bool) -> Start:
    """Return the start of the motion that follows a motion at time tau."""
    if end is None:
        return on_ray(frame, exit_side(start), start.Z, start.w, tau)
    q, side, zero = frame.q, start.side, tau * 0
    turned, offset = start.driven - end.theta, q * end.gap
    X, Z = side * (1 + offset), start.Z - side * (q * end.slid)
    beyond = -(2 + offset)
    if not literal:
        outside = sign(beyond, "does the slip end inside the sliding region, or cross beyond its edge?")
        if outside == 0:
            outside = sign(-turned, "does the pair leave the edge of the sliding region at once?")
        if outside > 0:
            return Start(SURFACE, -side, X, zero, beyond / q, -turned, -turned, True, Z, end.w, tau)
    V = side * (frame.sqrt_q * turned)
    return Start(STICK, side, X, zero, offset, V, zero, True, Z, end.w, tau)


def on_ray(frame: Frame, side: int, Z: Number, w: Number, tau: Number) -> Start:
    """Return the slip that leaves S0 by the ray on this side, where X = side and V = side sqrt(w) exactly."""
    push, zero = sqrt(w) / frame.sqrt_q, tau * 0
    return Start(RAY, side, zero + side, zero, zero, push, push, True, Z, w, tau)


def event_state(frame: Frame, start: Start) -> ReducedState:
    """Return the state in which a motion starts on the switching surface."""
    V = start.push
    if start.kind != STICK:
        V = start.side * (sqrt(start.w) if start.kind == RAY else frame.sqrt_q * start.driven)
    return ReducedState(start.X, V, V, start.Z, start.w)


def state_at(frame: Frame, start: Start, tau: Number) -> ReducedState:
    """Return the state at tau after the start of a motion."""
    if start.kind == STICK:
        sine, cosine = sine_cosine(tau)
        X, V = start.X * cosine + start.push * sine, start.push * cosine - start.X * sine
        return ReducedState(X, V, V, start.Z, start.w)
    q, side, theta = frame.q, start.side, tau / frame.sqrt_q
    slid, gap = slid_at(theta, start), guard_and_gap(start, theta)[1]
    V1, V2 = side * (frame.sqrt_q * push_at(start, theta)), side * (frame.sqrt_q * (start.driven - theta))
    return ReducedState(side * (1 + q * gap), V1, V2, start.Z - side * (q * slid), start.w - 2 * frame.r * q * slid)


class Excursion(NamedTuple):
    """One excursion: its excess energy w on the exit ray, the side of that ray, the reduced times of slip and stick.

    `w_after` is the excess after the slip; `stick` is None if the pair has merged (w_after <= 0). Dimensionless.
    """

    w: Number
    side: int
    slip: Number
    w_after: Number
    stick: Number | None


def excursions(frame: Frame, w: Number, side: int = 1) -> Iterator[Excursion]:
    """Yield the excursions of a pair that leaves S0 by the ray `side` with excess w > 0, until it merges.

    Crossings of S outside S0 belong to the excursion in which they happen. Raises EventUndecided, OutOfRange. Call it
    inside the arithmetic's context.
    """
    zero = frame.arithmetic.number(0)
    ray, slip = on_ray(frame, side, zero, w, zero), zero
    for start, duration in motions(frame, ray):
        if start.kind == RAY:
            ray, slip = start, zero
        if start.kind != STICK:
            slip = slip + duration
        else:
            yield Excursion(ray.w, ray.side, slip, start.w, duration)


State4 = tuple[Number, Number, Number, Number]
Progress = Callable[[int, float], None]


def run_free(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene with a1 = 0, no force and constant b. Raises EventUndecided, OutOfRange."""
    at, number = scene.initial, arithmetic.number
    with arithmetic.context():
        frame = Frame(arithmetic, scene.pair)
        first, until = begin(scene, frame), number(scene.until)
        horizon, knots = frame.rate * until, list[Knot]()
        length = zero = first.tau
        given = number(at.x1), number(at.v1), number(at.x2), number(at.v2)
        for start, duration in motions(frame, first, scene.law is Law.THREE_VALUED_SGN):
            here = frame.in_si(event_state(frame, start)) if knots else given
            knots.append(_knot(start, bool(knots), start.tau / frame.rate, length, here, start.w))
            if progress is not None and len(knots) % 1000 == 0:
                progress(len(knots), arithmetic.to_float(start.tau / horizon))
            left = horizon - start.tau
            if duration is None or sign(duration - left, "does the next event come before the horizon?") > 0:
                last = state_at(frame, start, left)
                end = _knot(start, False, until, left / frame.rate, frame.in_si(last), last.w)
                how = How.STUCK if duration is None else How.REACHED
                return Record(knots, end, how, len(knots) - 1)
            if len(knots) > max_events:
                break
            length = duration / frame.rate
        return Record(knots, knots[-1]._replace(length=zero), How.EVENT_LIMIT, len(knots) - 1)


def _knot(start: Start, event: bool, t: Number, length: Number, state: State4, w: Number) -> Knot:
    return Knot(mode_of(start), order_of(start), event, False, 0, t, length, *state, excess=w)
