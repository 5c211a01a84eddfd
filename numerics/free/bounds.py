"""How far rounding can have moved a free trajectory: bounds carried from event to event beside the numbers.

They rest on two facts. The friction law contracts the energy norm |z|^2 = X^2 + q V1^2 + r V2^2: two solutions never
move apart, whatever events they meet. So the distance at a fixed time is at most the sum of the roundings so far; an
event then is off by that distance over the rate at which its guard passes zero, its conditioning. Next to the critical
orbit, where that quotient would be useless, the closed forms of each slip and stick give the derivatives of its end
with respect to its start, which keep what is small in relation to itself. Of two bounds the smaller one is taken.

All is binary64 and dimensionless; `unit` is the rounding of one operation of the arithmetic, relative to its result.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic import elementary
from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import as_float, rounding
from numerics.arithmetic.protocol import Number
from numerics.free.motion import RAY, STICK, SURFACE, Landing, Parameters, State, stick_reach
from numerics.free.slip import Start

UNDERFLOW = 1e-290
"""What products below the normal numbers may have dropped from a sum."""


class Errors(NamedTuple):
    """Bounds on the errors at the start of a mode of motion.

    Of its time; of the slip variables d and u (in stick: of the offset from the edge over q, and of V over sqrt q); of
    w; of the sum of |dZ| over all slips; of Z. The state is within `norm` of the true trajectory, shifted in time by at
    most `shift`.
    """

    late: float
    gap: float
    push: float
    w: float
    slide: float
    place: float
    shift: float
    norm: float


class Linear(NamedTuple):
    """A slip from an exit ray to first order in w: what the stick phase after it needs to add both durations up.

    d(duration)/dw, d(offset)/dw, d(side V)/dw and d(w')/dw; the error of w before, and the roundings of the slip alone.
    """

    length: float
    offset: float
    velocity: float
    excess: float
    w: float
    late: float
    own_offset: float
    own_velocity: float
    own_w: float


class Carried(NamedTuple):
    """The errors at the start of a motion, and the first-order part of those of a slip from a ray."""

    errors: Errors
    linear: Linear


class Off(NamedTuple):
    """Bounds on the errors of tau and of a State; `certain`: they leave no doubt about the sequence of events."""

    late: float
    x: float
    v1: float
    v2: float
    place: float
    w: float
    spent: float
    certain: bool


@compilable
def in_floats(at: Parameters, start: Start) -> tuple[Parameters, Start]:
    """Return parameters and the start of a motion in binary64."""
    numbers = Start(
        start.kind,
        start.side,
        as_float(start.X),
        as_float(start.guard),
        as_float(start.gap),
        as_float(start.push),
        as_float(start.driven),
        start.turns,
        as_float(start.Z),
        as_float(start.w),
        as_float(start.tau),
        as_float(start.rest),
        as_float(start.spent),
    )
    return Parameters(as_float(at.q), as_float(at.r), as_float(at.sqrt_q), at.literal), numbers


@compilable
def without_linear(at: Parameters, errors: Errors) -> Carried:
    """Return the errors of a stick phase that does not follow a slip from a ray: there is no first-order part."""
    own_offset, own_velocity = at.q * errors.gap, at.sqrt_q * errors.push
    return Carried(errors, Linear(0.0, 0.0, 0.0, 1.0, 0.0, errors.late, own_offset, own_velocity, errors.w))


@compilable
def lost() -> Errors:
    """Return the errors of a trajectory of which not even the next mode is certain."""
    inf = math.inf
    return Errors(inf, inf, inf, inf, inf, inf, inf, inf)


@compilable
def initial(at: Parameters, start: Start, V1: Number, V2: Number) -> Carried:
    """Return the errors of a start whose numbers are exact rationals, rounded."""
    unit, (pair, begun) = rounding(at.q), in_floats(at, start)
    moving = pair.sqrt_q * abs(as_float(V1)) + math.sqrt(pair.r) * abs(as_float(V2))
    gap, push = 2 * unit * abs(begun.gap), 4 * unit * abs(begun.push)
    if start.kind == STICK:
        gap, push = gap / pair.q, push / pair.sqrt_q
    w, place, norm = 2 * unit * abs(begun.w), 2 * unit * abs(begun.Z), 4 * unit * (abs(begun.X) + moving)
    return without_linear(pair, Errors(0.0, gap, push, w, 0.0, place, 0.0, norm))


@compilable
def after_event(at: Parameters, before: Start, carried: Carried, end: Landing, after: Start) -> Carried:
    """Return the errors at the start of the motion `after`, which follows `before`."""
    errors, linear = _ended(at, before, carried, end)
    if before.kind == STICK:
        return Carried(errors, linear)
    q, beyond = as_float(at.q), as_float(-(2 + at.q * end.gap))
    unsure = not abs(beyond) > q * errors.gap or (beyond < 0.0 and not abs(as_float(end.w)) > errors.w)
    if unsure and not at.literal:
        errors = lost()
    if after.kind != STICK:  # the gap is that beyond the other edge, -(2 + offset)/q, rounded
        gap = errors.gap + 4.0 * rounding(at.q) * (4.0 / q + as_float(after.gap))
        late, _, push, w, slide, place, shift, norm = errors
        errors = Errors(late, gap, push, w, slide, place, shift, norm)
    return Carried(errors, linear)


@compilable
def _ended(at: Parameters, before: Start, carried: Carried, end: Landing) -> Carried:
    """Return the errors at the end of a motion."""
    unit, errors, (pair, start) = rounding(at.q), carried.errors, in_floats(at, before)
    if start.kind == STICK:
        exit_at = stick_reach(before)
        below, reach, root = as_float(exit_at.below), as_float(exit_at.reach), as_float(exit_at.root)
        turned = 1.0 if exit_at.side == start.side else -1.0
        return Carried(_after_stick(pair, unit, carried, below, reach, root, turned), carried.linear)
    landed = Landing(
        as_float(end.theta), as_float(end.gap), as_float(end.slid), as_float(end.w), end.versine, end.spared
    )
    if start.kind == RAY:
        return _after_ray(pair, unit, errors, start, landed)
    if start.kind == SURFACE:
        depth = as_float(-end.gap - before.gap)
        return without_linear(pair, _after_surface(pair, unit, errors, start, landed, depth))
    return without_linear(pair, _after_free(pair, unit, errors, start, landed))


@compilable
def _passing(error: float, rate: float, bend: float) -> float:
    """Return by how much a guard that is off by `error` and passes 0 at this rate is late, if it bends by `bend`.

    rate s - bend s^2/2 = error; infinite where the guard may turn round before it gets to 0 (a graze).
    """
    rest = rate * rate - 2.0 * bend * error
    return 2.0 * error / (rate + math.sqrt(rest)) if rest > 0.0 else math.inf


@compilable
def _speed(at: Parameters, reach: float, motion: float) -> float:
    """Return a bound of |dz/dtau| in the energy norm during a slip: V1 <= sqrt(q) A, q V1' <= q A, V2' = 1."""
    return at.sqrt_q * (reach + motion) + at.sqrt_q * reach + math.sqrt(at.r)


@compilable
def _after_ray(at: Parameters, unit: float, errors: Errors, start: Start, end: Landing) -> Carried:
    """Return the errors at the end of a slip from an exit ray, of which all is a function of w = q u^2."""
    q, r, sqrt_q, w = at.q, at.r, at.sqrt_q, start.w
    theta, depth, push = end.theta, -end.gap, math.sqrt(w / q)
    push_w = 0.5 * push / w
    theta_w = push_w * end.versine / depth
    depth_w = push * theta_w
    excess_w = 1.0 - r * end.versine
    own_w = unit * (w + end.w + 56.0 * (r * q * depth * depth) + 6.0 * w * r * end.versine)
    own_gap, own_push = 24.0 * unit * depth, unit * (8.0 * theta + 3.0 * push)
    own_late = errors.late + 8.0 * unit * sqrt_q * theta
    gap, turn = own_gap + depth_w * errors.w, own_push + abs(push_w - theta_w) * errors.w
    late = own_late + sqrt_q * theta_w * errors.w
    slid = q * depth * (depth_w * errors.w + 24.0 * unit * depth)
    norm = q * gap + sqrt_q * turn + 4.0 * unit
    w_error, place = own_w + abs(excess_w) * errors.w, errors.place + slid + 4.0 * unit * abs(start.Z)
    linear = Linear(
        sqrt_q * theta_w,
        -q * depth_w,
        sqrt_q * (push_w - theta_w),
        excess_w,
        errors.w,
        own_late,
        q * own_gap,
        sqrt_q * own_push,
        own_w,
    )
    return Carried(Errors(late, gap, turn, w_error, errors.slide + slid, place, late, norm), linear)


@compilable
def _after_surface(at: Parameters, unit: float, errors: Errors, start: Start, end: Landing, depth: float) -> Errors:
    """Return the errors at the end of a slip from S: by its linear map, or by the contraction."""
    q, r, sqrt_q, gap, push, theta = at.q, at.r, at.sqrt_q, start.gap, start.push, end.theta
    rate = depth + gap
    rise = push + gap * (2.0 - depth) / theta  # h = u + d cot(theta/2)
    # the linear map of this slip: dtheta = (du + cot dd) (1 - cos)/(c + d)
    slope = end.versine / rate
    by_gap = abs(2.0 - depth) / theta * slope
    turned = by_gap * errors.gap + slope * errors.push + 4.0 * unit * theta
    deeper = abs(rise) * turned + 8.0 * unit * depth
    lost_more = rate * deeper + depth * errors.gap
    w_by_map = errors.w + 2.0 * r * q * lost_more + 16.0 * unit * (r * q * depth * (depth + 2.0 * gap))
    reach, motion = (1.0 + gap) + abs(push), abs(push) + theta
    norm = errors.norm + unit * (8.0 * q * (reach + depth) + 8.0 * sqrt_q * motion + 4.0)
    late = _passing(norm * math.sqrt(1.0 / q + 1.0 / r), rate, reach / sqrt_q)
    section = norm + late * _speed(at, reach, motion)
    slid = q * (lost_more + 8.0 * unit * depth * (depth + 2.0 * gap))
    size = 1.0 + math.sqrt(abs(1.0 + end.w))
    return Errors(
        min(errors.shift + late, errors.late + sqrt_q * turned) + 4.0 * unit * sqrt_q * theta,
        min(section / q, errors.gap + deeper + 4.0 * unit * rate),
        min(section / sqrt_q, errors.push + turned + 4.0 * unit * motion),
        min(4.0 * size * norm, w_by_map) + 8.0 * unit * (start.w if start.w <= 1.0 else size * size),
        errors.slide + slid,
        errors.place + slid + 4.0 * unit * abs(start.Z),
        errors.shift,
        norm,
    )


@compilable
def _after_free(at: Parameters, unit: float, errors: Errors, start: Start, end: Landing) -> Errors:
    """Return the errors at the end of a slip from off the surface."""
    q, sqrt_q, theta, reach = at.q, at.sqrt_q, end.theta, abs(1.0 + start.gap) + abs(start.push)
    motion = abs(start.driven) + theta + reach
    norm = errors.norm + unit * (8.0 * q * reach + 8.0 * sqrt_q * (motion + start.guard) + 4.0)
    error = norm * math.sqrt(1.0 / q + 1.0 / at.r)
    late = math.inf if 4.0 * error >= sqrt_q * end.spared else _passing(error, -end.gap, reach / sqrt_q)
    section = norm + late * _speed(at, reach, motion)
    slid = 2.0 * error * sqrt_q * theta + 8.0 * unit * q * (start.guard + reach + theta) * theta
    size = 1.0 + abs(start.gap) * q + sqrt_q * motion
    return Errors(
        errors.shift + late + 4.0 * unit * sqrt_q * theta,
        section / q,
        section / sqrt_q,
        4.0 * size * norm + 8.0 * unit * size * size,
        errors.slide + slid,
        errors.place + slid + 4.0 * unit * abs(start.Z),
        errors.shift,
        norm,
    )


@compilable
def _after_stick(
    at: Parameters, unit: float, carried: Carried, below: float, reach: float, root: float, turned: float
) -> Errors:
    """Return the errors on the exit ray: duration 2 atan2(below, reach), reach = side V + root, root = sqrt w.

    turned: 1 if it leaves by the edge next to which it began, else -1. After a slip from a ray the durations of slip
    and stick depend on w in opposite ways: their sum is what counts.
    """
    errors, linear = carried
    offset_w, reach_w = -turned * linear.offset, turned * linear.velocity + linear.excess / (2.0 * root)
    square = below * below + reach * reach
    length = math.pi * below / math.sqrt(square)  # at least 2 atan2(below, reach), as reach > 0
    length_w = linear.length + 2.0 * (reach * offset_w - below * reach_w) / square
    own = reach * linear.own_offset + below * (linear.own_velocity + linear.own_w / (2.0 * root))
    late = linear.late + abs(length_w) * linear.w + 2.0 * own / square + 8.0 * unit * length
    if not errors.w < 0.5 * root * root:
        late = math.inf
    push = (errors.w / root + 4.0 * unit * root) / at.sqrt_q
    return Errors(late, 0.0, push, errors.w, errors.slide, errors.place, late, errors.w / root + 4.0 * unit)


@compilable
def before_horizon(
    at: Parameters, start: Start, carried: Carried, end: Landing, tau: Number, horizon: Number
) -> Carried:
    """Return the errors, lost where the event that was found at tau, after the horizon, may come before it."""
    late = _ended(at, start, carried, end).errors.late
    sure = as_float(tau - horizon) > late + 4.0 * rounding(at.q) * as_float(horizon)
    return carried if sure else Carried(lost(), carried.linear)


@compilable
def _spent(at: Parameters, unit: float, slide: float, spent: Number) -> float:
    """Return a bound on the error of what friction has taken."""
    return 2.0 * as_float(at.r) * slide + 8.0 * unit * as_float(spent) + UNDERFLOW


@compilable
def at_start(at: Parameters, start: Start, errors: Errors, here: State) -> Off:
    """Return the errors of the state with which a motion starts at an event."""
    unit = rounding(at.q)
    x = as_float(at.q) * errors.gap + 2.0 * unit * abs(as_float(start.X))
    v = as_float(at.sqrt_q) * errors.push + 2.0 * unit * abs(as_float(here.V1))
    spent = _spent(at, unit, errors.slide, start.spent)
    return Off(errors.late, x, v, v, errors.place, errors.w, spent, math.isfinite(errors.late))


@compilable
def at_horizon(at: Parameters, start: Start, errors: Errors, end: State, tau: Number, horizon: Number) -> Off:
    """Return the errors of the state at the horizon, tau after the start of the last motion."""
    rounded = 4.0 * rounding(at.q) * as_float(horizon)
    since = as_float(horizon - start.tau)
    if not since >= errors.late + (rounded if as_float(start.tau) > 0.0 else 0.0):
        errors = lost()
    late, shift = errors.late + rounded, errors.shift + rounded
    pair, begun = in_floats(at, start)
    if start.kind == STICK:
        return _in_stick_at(pair, begun, errors, late, shift, rounding(at.q))
    return _in_slip_at(pair, begun, errors, end, as_float(tau), late, shift, rounding(at.q))


@compilable
def _in_stick_at(at: Parameters, start: Start, errors: Errors, late: float, shift: float, unit: float) -> Off:
    """Return the errors during a stick phase: one rotation."""
    turning = math.sqrt(start.X * start.X + start.push * start.push)
    moved = at.q * errors.gap + at.sqrt_q * errors.push
    error = min(errors.norm + turning * shift, moved + turning * late) + 8.0 * unit * turning
    place, spent = errors.place + 2.0 * unit * abs(start.Z), _spent(at, unit, errors.slide, start.spent)
    return Off(0.0, error, error, error, place, errors.w, spent, math.isfinite(errors.late))


@compilable
def _in_slip_at(
    at: Parameters, start: Start, errors: Errors, end: State, tau: float, late: float, shift: float, unit: float
) -> Off:
    """Return the errors during a slip: by the contraction of the energy norm or by its closed form, the smaller one."""
    q, r, sqrt_q, d0, u0, driven, guard = at.q, at.r, at.sqrt_q, start.gap, start.push, start.driven, start.guard
    theta = tau / sqrt_q
    u, turned = u0 * math.cos(theta) - (1.0 + d0) * math.sin(theta), driven - theta
    drop, sine_drop = elementary.versine(theta), elementary.sine_deficit(theta)
    bent, late = abs(1.0 + d0) + abs(u0), late / sqrt_q + 2.0 * unit * theta
    norm = errors.norm + 8.0 * unit * (q * bent + sqrt_q * (abs(driven) + theta + guard))
    norm += shift * _speed(at, bent, abs(driven) + theta + bent)
    x = q * (3.0 * errors.gap + errors.push + abs(u) * late + 8.0 * unit * (abs(d0) + abs(u0) + bent * drop))
    turning = abs(u0) + abs(1.0 + d0) * abs(math.sin(theta))
    v1 = sqrt_q * (errors.push + errors.gap + bent * late + 8.0 * unit * turning)
    v2 = sqrt_q * (errors.push + late + 4.0 * unit * (abs(driven) + theta))
    rounded = guard * theta + abs(d0) * drop + abs(u0) * sine_drop + elementary.cosine_deficit(theta)
    slide = q * (drop * errors.gap + sine_drop * errors.push + abs(u - turned) * late + 16.0 * unit * rounded)
    return Off(
        0.0,
        min(norm, x) + 4.0 * unit * abs(as_float(end.X)),
        min(norm / sqrt_q, v1) + 4.0 * unit * abs(as_float(end.V1)),
        min(norm / math.sqrt(r), v2) + 4.0 * unit * abs(as_float(end.V2)),
        errors.place + slide + 4.0 * unit * (abs(start.Z) + abs(as_float(end.Z))),
        errors.w + 2.0 * r * slide + 2.0 * unit * (abs(start.w) + abs(as_float(end.w))),
        _spent(at, unit, errors.slide + slide, end.spent),
        math.isfinite(errors.late),
    )
