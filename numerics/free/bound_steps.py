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

from numerics.arithmetic.compiled import compilable


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


@compilable
def no_linear(q: float, errors: Errors) -> Linear:
    """Return the first-order part of a stick phase that does not follow a slip from a ray: there is none."""
    return Linear(0.0, 0.0, 0.0, 1.0, 0.0, errors.late, q * errors.gap, math.sqrt(q) * errors.push, errors.w)


@compilable
def lost() -> Errors:
    """Return the errors of a trajectory of which not even the next mode is certain."""
    return Errors(math.inf, math.inf, math.inf, math.inf, math.inf, math.inf, math.inf, math.inf)


@compilable
def passing(error: float, rate: float, bend: float) -> float:
    """Return by how much a guard that is off by `error` and passes 0 at this rate is late, if it bends by `bend`.

    rate s - bend s^2/2 = error; infinite where the guard may turn round before it gets to 0 (a graze).
    """
    rest = rate * rate - 2.0 * bend * error
    return 2.0 * error / (rate + math.sqrt(rest)) if rest > 0.0 else math.inf


@compilable
def speed(q: float, r: float, reach: float, motion: float) -> float:
    """Return a bound of |dz/dtau| in the energy norm during a slip: V1 <= sqrt(q) A, q V1' <= q A, V2' = 1."""
    return math.sqrt(q) * (reach + motion) + math.sqrt(q) * reach + math.sqrt(r)


@compilable
def after_ray(
    q: float,
    r: float,
    unit: float,
    errors: Errors,
    excess: tuple[float, float],
    landing: tuple[float, float, float],
    placed: float,
) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip from an exit ray, of which all is a function of w = q u^2.

    excess = w before and after, landing = (theta, depth, versine), `placed` the rounding of Z itself.
    """
    w, w_after = excess
    theta, depth, versine = landing
    sqrt_q, push = math.sqrt(q), math.sqrt(w / q)
    push_w = 0.5 * push / w
    theta_w = push_w * versine / depth
    depth_w = push * theta_w
    taken = r * q * depth * depth
    own_w = unit * (w + w_after + 56.0 * taken + 6.0 * w * r * versine)
    own_gap, own_push = 24.0 * unit * depth, unit * (8.0 * theta + 3.0 * push)
    own_late = 8.0 * unit * sqrt_q * theta
    excess_w = 1.0 - r * versine
    gap, turn = own_gap + depth_w * errors.w, own_push + abs(push_w - theta_w) * errors.w
    late = errors.late + own_late + sqrt_q * theta_w * errors.w
    slid = q * depth * (depth_w * errors.w + 24.0 * unit * depth)
    norm = q * gap + sqrt_q * turn + 4.0 * unit
    w_error = own_w + abs(excess_w) * errors.w
    ended = Errors(late, gap, turn, w_error, errors.slide + slid, errors.place + slid + placed, late, norm)
    return ended, Linear(
        sqrt_q * theta_w,
        -q * depth_w,
        sqrt_q * (push_w - theta_w),
        excess_w,
        errors.w,
        errors.late + own_late,
        q * own_gap,
        sqrt_q * own_push,
        own_w,
    )


@compilable
def after_surface(
    q: float,
    r: float,
    unit: float,
    errors: Errors,
    start: tuple[float, float, float],
    w_after: float,
    landing: tuple[float, float, float],
    placed: float,
) -> Errors:
    """Return the errors at the end of a slip from S; start = (gap, push, w), landing = (theta, depth, versine)."""
    gap, push, w = start
    theta, depth, versine = landing
    sqrt_q, rise = math.sqrt(q), push + gap * (2.0 - depth) / theta  # h = u + d cot(theta/2)
    # the linear map of this slip: dtheta = (du + cot dd) (1 - cos)/(c + d)
    slope = versine / (depth + gap)
    by_gap = abs(2.0 - depth) / theta * slope
    turned = by_gap * errors.gap + slope * errors.push + 4.0 * unit * theta
    deeper = abs(rise) * turned + 8.0 * unit * depth
    taken = r * q * depth * (depth + 2.0 * gap)
    w_by_map = errors.w + 2.0 * r * q * ((depth + gap) * deeper + depth * errors.gap) + 16.0 * unit * taken
    reach, motion = (1.0 + gap) + abs(push), abs(push) + theta
    own = unit * (8.0 * q * (reach + depth) + 8.0 * sqrt_q * motion + 4.0)
    norm, rate = errors.norm + own, depth + gap
    late = passing(norm * math.sqrt(1.0 / q + 1.0 / r), rate, reach / sqrt_q)
    section = norm + late * speed(q, r, reach, motion)
    slid = q * ((depth + gap) * deeper + depth * errors.gap + 8.0 * unit * depth * (depth + 2.0 * gap))
    size = 1.0 + math.sqrt(abs(1.0 + w_after))
    return Errors(
        min(errors.shift + late, errors.late + sqrt_q * turned) + 4.0 * unit * sqrt_q * theta,
        min(section / q, errors.gap + deeper + 4.0 * unit * (gap + depth)),
        min(section / sqrt_q, errors.push + turned + 4.0 * unit * motion),
        min(4.0 * size * norm, w_by_map) + 8.0 * unit * (w if w <= 1.0 else size * size),
        errors.slide + slid,
        errors.place + slid + placed,
        errors.shift,
        norm,
    )


@compilable
def after_free(
    q: float,
    r: float,
    unit: float,
    errors: Errors,
    start: tuple[float, float, float, float],
    landing: tuple[float, float, float],
    placed: float,
) -> Errors:
    """Return the errors at the end of a slip from off the surface; start = (guard, gap, push, driven push).

    landing = (theta, depth, how far above 0 the lowest minimum of the guard stayed).
    """
    guard, gap, push, driven = start
    theta, rate, spared = landing
    sqrt_q, reach = math.sqrt(q), abs(1.0 + gap) + abs(push)
    motion = abs(driven) + theta + reach
    own = unit * (8.0 * q * reach + 8.0 * sqrt_q * (motion + guard) + 4.0)
    norm = errors.norm + own
    error = norm * math.sqrt(1.0 / q + 1.0 / r)
    late = math.inf if 4.0 * error >= sqrt_q * spared else passing(error, rate, reach / sqrt_q)
    section = norm + late * speed(q, r, reach, motion)
    slid = 2.0 * error * sqrt_q * theta + 8.0 * unit * q * (guard + reach + theta) * theta
    size = 1.0 + abs(gap) * q + sqrt_q * motion
    return Errors(
        errors.shift + late + 4.0 * unit * sqrt_q * theta,
        section / q,
        section / sqrt_q,
        4.0 * size * norm + 8.0 * unit * size * size,
        errors.slide + slid,
        errors.place + slid + placed,
        errors.shift,
        norm,
    )


@compilable
def after_stick(
    unit: float,
    errors: Errors,
    linear: Linear,
    reached: tuple[float, float, float],
    sqrt_q: float,
    same_edge: bool,
) -> Errors:
    """Return the errors on the exit ray: duration 2 atan2(below, reach), reached = (below, root, reach).

    reach = side V + root, root = sqrt w. After a slip from a ray the durations of slip and stick depend on w in
    opposite ways: their sum is what counts.
    """
    below, root, reach = reached
    offset_w = -linear.offset if same_edge else linear.offset
    reach_w = (linear.velocity if same_edge else -linear.velocity) + linear.excess / (2.0 * root)
    square = below * below + reach * reach
    length = math.pi * below / math.sqrt(square)  # at least 2 atan2(below, reach), as reach > 0
    length_w = linear.length + 2.0 * (reach * offset_w - below * reach_w) / square
    own = reach * linear.own_offset + below * (linear.own_velocity + linear.own_w / (2.0 * root))
    late = linear.late + abs(length_w) * linear.w + 2.0 * own / square + 8.0 * unit * length
    if not errors.w < 0.5 * root * root:
        late = math.inf
    norm = errors.w / root + 4.0 * unit
    push = (errors.w / root + 4.0 * unit * root) / sqrt_q
    return Errors(late, 0.0, push, errors.w, errors.slide, errors.place, late, norm)


@compilable
def in_crossing(unit: float, errors: Errors, q: float, beyond: float) -> Errors:
    """Return the same errors for the gap beyond the other edge, -(2 + offset)/q, rounded."""
    gap = errors.gap + 4.0 * unit * (4.0 / q + beyond)
    return Errors(errors.late, gap, errors.push, errors.w, errors.slide, errors.place, errors.shift, errors.norm)
