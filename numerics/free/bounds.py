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
from numerics.arithmetic.elementary import UNIT
from numerics.arithmetic.functions import as_float, cosine_deficit, sine_deficit, versine
from numerics.arithmetic.protocol import Number
from numerics.free.frame import Begun
from numerics.free.motion import FREE, RAY, STICK, Landing, MotionState, Parameters, Reach, stick_reach
from numerics.free.slip import Start

ROW_UNIT = 4 * UNIT
"""What errors are counted in where a run begins with binary64 numbers."""
UNDERFLOW = 1e-290
"""What products below the normal numbers may have dropped from a sum."""


class Errors(NamedTuple):
    """Bounds on the errors at the start of a mode of motion.

    Of its time; of the slip variables d and u (in stick: of the offset from the edge over q, and of V over sqrt q); of
    w; of the sum of |dZ| over all slips; of Z. The state is within `norm` of the true trajectory, shifted in time by at
    most `shift`. In a stick phase that is left, of the time of its exit.
    """

    late: float
    gap: float
    push: float
    w: float
    slide: float
    place: float
    shift: float
    norm: float
    exit: float


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
    return Parameters(as_float(at.q), as_float(at.r), as_float(at.sqrt_q), at.literal, at.unit), numbers


@compilable
def lost() -> Errors:
    """Return the errors of a trajectory of which not even the next mode is certain."""
    inf = math.inf
    return Errors(inf, inf, inf, inf, inf, inf, inf, inf, inf)


@compilable
def initial(begun: Begun, formed: float) -> Errors:
    """Return the errors of a start formed of exact rationals, for `formed` = 0, or of binary64 numbers, for 1.

    Of rationals every number is rounded once. Of binary64 numbers, each off by a rounding, differences are off by
    roundings of their terms besides: X by 10, E/E_cr by 32. `at.unit` is four of these roundings there (ROW_UNIT), as
    q and r have up to four of them, not one.
    """
    unit, (at, start) = begun.at.unit, in_floats(begun.at, begun.start)
    moving = at.sqrt_q * abs(as_float(begun.V1)) + math.sqrt(at.r) * abs(as_float(begun.V2))
    gap, push = 2 * unit * abs(start.gap), (4 + formed) * unit * abs(start.push)
    if start.kind == STICK:
        gap, push = gap / at.q, push / at.sqrt_q
    gap += formed * 3 * unit * abs(start.X) / at.q
    w = 2 * unit * abs(start.w) + formed * 9 * unit * abs(1 + start.w)
    place = (2 + formed) * unit * abs(start.Z) + formed * unit * abs(start.X)
    norm = 4 * unit * (abs(start.X) + moving)
    return with_exit(at, Errors(0.0, gap, push, w, 0.0, place, 0.0, norm, 0.0), start)


@compilable
def with_exit(at: Parameters, errors: Errors, start: Start) -> Errors:
    """Return the errors at the start of a motion, in stick with that of its exit; all in binary64."""
    late, gap, push, w, slide, place, shift, norm, leaves = errors
    if start.kind == STICK and start.w > 0.0:
        leaves = _exit(at, late, gap, push, w, stick_reach(start))
    return Errors(late, gap, push, w, slide, place, shift, norm, leaves)


@compilable
def _exit(at: Parameters, late: float, gap: float, push: float, w: float, to: Reach) -> float:
    """Return the error of the time at which a stick phase ends, 2 atan2(below, reach) after its start."""
    square = to.below * to.below + to.reach * to.reach
    own = to.reach * (at.q * gap) + to.below * (at.sqrt_q * push + w / (2.0 * to.root))
    length = math.pi * to.below / math.sqrt(square)  # at least 2 atan2(below, reach), as reach > 0
    return late + 2.0 * own / square + 8.0 * at.unit * length


@compilable
def after_event(at: Parameters, before: Start, errors: Errors, end: Landing, after: Start) -> Errors:
    """Return the errors at the start of the motion `after`, which follows `before`."""
    pair, start = in_floats(at, after)
    errors = _ended(at, before, errors, end, start)
    if before.kind == STICK:
        return errors
    beyond = as_float(-(2 + at.q * end.gap))
    unsure = not abs(beyond) > pair.q * errors.gap or (beyond < 0.0 and not abs(start.w) > errors.w)
    if unsure and not at.literal:
        return lost()
    if start.kind == STICK:
        return errors if before.kind == RAY else with_exit(pair, errors, start)
    # the gap is that beyond the other edge, -(2 + offset)/q, rounded
    gap = errors.gap + 4.0 * at.unit * (4.0 / pair.q + start.gap)
    late, _, push, w, slide, place, shift, norm, leaves = errors
    return Errors(late, gap, push, w, slide, place, shift, norm, leaves)


@compilable
def _ended(at: Parameters, before: Start, errors: Errors, end: Landing, after: Start) -> Errors:
    """Return the errors at the end of a motion."""
    pair, start = in_floats(at, before)
    if start.kind == STICK:
        return _after_stick(pair, errors, start.w)
    landed = Landing(
        as_float(end.theta), as_float(end.gap), as_float(end.slid), as_float(end.w), end.versine, end.spared
    )
    if start.kind == RAY:
        return _after_ray(pair, errors, start, landed, after)
    return _after_slip(pair, errors, start, landed, as_float(-end.gap - before.gap))


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
def _after_ray(at: Parameters, errors: Errors, start: Start, end: Landing, after: Start) -> Errors:
    """Return the errors at the end of a slip from an exit ray, of which all is a function of w = q u^2.

    The durations of the slip and of a stick phase after it depend on w in opposite ways: their sum is what counts.
    """
    unit, q, r, sqrt_q, w = at.unit, at.q, at.r, at.sqrt_q, start.w
    theta, depth, push = end.theta, -end.gap, math.sqrt(w / q)
    push_w = 0.5 * push / w
    theta_w = push_w * end.versine / depth
    depth_w, turn_w, excess_w = push * theta_w, push_w - theta_w, 1.0 - r * end.versine
    own_w = unit * (w + end.w + 56.0 * (r * q * depth * depth) + 6.0 * w * r * end.versine)
    own_gap, own_push = 24.0 * unit * depth, unit * (8.0 * theta + 3.0 * push)
    own_late, leaves = errors.late + 8.0 * unit * sqrt_q * theta, 0.0
    if after.kind == STICK and after.w > 0.0:
        to = stick_reach(after)
        side = to.side * after.side  # 1 if it leaves by the edge next to which it began
        reach_w = side * sqrt_q * turn_w + excess_w / (2.0 * to.root)
        turned_w = (to.reach * side * q * depth_w - to.below * reach_w) / (to.below * to.below + to.reach * to.reach)
        leaves = abs(sqrt_q * theta_w + 2.0 * turned_w) * errors.w + _exit(at, own_late, own_gap, own_push, own_w, to)
    gap, turn = own_gap + depth_w * errors.w, own_push + abs(turn_w) * errors.w
    late, slid = own_late + sqrt_q * theta_w * errors.w, q * depth * gap
    return Errors(
        late,
        gap,
        turn,
        own_w + abs(excess_w) * errors.w,
        errors.slide + slid,
        errors.place + slid + 4.0 * unit * abs(start.Z),
        late,
        q * gap + sqrt_q * turn + 4.0 * unit,
        leaves,
    )


@compilable
def _after_slip(at: Parameters, errors: Errors, start: Start, end: Landing, depth: float) -> Errors:
    """Return the errors at the end of any other slip: by the contraction; from S also by its linear map."""
    unit, q, r, sqrt_q, gap, push, theta = at.unit, at.q, at.r, at.sqrt_q, start.gap, start.push, end.theta
    is_free, reach = start.kind == FREE, abs(1.0 + gap) + abs(push)
    motion, grown = (abs(start.driven) + theta + reach, 0.0) if is_free else (abs(push) + theta, depth)
    norm = errors.norm + unit * (8.0 * q * (reach + grown) + 8.0 * sqrt_q * (motion + start.guard) + 4.0)
    error = norm * math.sqrt(1.0 / q + 1.0 / r)
    late = math.inf if 4.0 * error >= sqrt_q * end.spared else _passing(error, -end.gap, reach / sqrt_q)
    section, late = norm + late * _speed(at, reach, motion), errors.shift + late
    gap_error, push_error = section / q, section / sqrt_q
    if is_free:
        size = 1.0 + abs(gap) * q + sqrt_q * motion
        w, slid = (
            4.0 * size * norm,
            2.0 * error * sqrt_q * theta + 8.0 * unit * q * (start.guard + reach + theta) * theta,
        )
    else:
        # dtheta = (du + cot dd) (1 - cos)/(c + d), and c' = h = u + d cot(theta/2)
        slope, cotangent = end.versine / (depth + gap), (2.0 - depth) / theta
        turned = abs(cotangent) * slope * errors.gap + slope * errors.push + 4.0 * unit * theta
        deeper = abs(push + gap * cotangent) * turned + 8.0 * unit * depth
        lost_more, way = (depth + gap) * deeper + depth * errors.gap, depth * (depth + 2.0 * gap)
        size, slid = 1.0 + math.sqrt(abs(1.0 + end.w)), q * (lost_more + 8.0 * unit * way)
        late = min(late, errors.late + sqrt_q * turned)
        gap_error = min(gap_error, errors.gap + deeper + 4.0 * unit * (depth + gap))
        push_error = min(push_error, errors.push + turned + 4.0 * unit * motion)
        w = min(4.0 * size * norm, errors.w + 2.0 * r * q * lost_more + 16.0 * unit * (r * q * way))
    return Errors(
        late + 4.0 * unit * sqrt_q * theta,
        gap_error,
        push_error,
        w + 8.0 * unit * (start.w if start.w <= 1.0 and not is_free else size * size),
        errors.slide + slid,
        errors.place + slid + 4.0 * unit * abs(start.Z),
        errors.shift,
        norm,
        0.0,
    )


@compilable
def _after_stick(at: Parameters, errors: Errors, w: float) -> Errors:
    """Return the errors on the exit ray."""
    root, leaves = math.sqrt(w), errors.exit if errors.w < 0.5 * w else math.inf
    push = errors.w / root + 4.0 * at.unit * root
    norm = errors.w / root + 4.0 * at.unit
    return Errors(leaves, 0.0, push / at.sqrt_q, errors.w, errors.slide, errors.place, leaves, norm, 0.0)


@compilable
def before_horizon(at: Parameters, start: Start, errors: Errors, end: Landing, tau: Number, horizon: Number) -> Errors:
    """Return the errors, lost where the event that was found at tau, after the horizon, may come before it."""
    late = _ended(at, start, errors, end, in_floats(at, start)[1]).late
    sure = as_float(tau - horizon) > late + 4.0 * at.unit * as_float(horizon)
    return errors if sure else lost()


@compilable
def _spent(at: Parameters, slide: float, spent: Number) -> float:
    """Return a bound on the error of what friction has taken."""
    return 2.0 * as_float(at.r) * slide + 8.0 * at.unit * as_float(spent) + UNDERFLOW


@compilable
def at_start(at: Parameters, start: Start, errors: Errors, here: MotionState) -> Off:
    """Return the errors of the state with which a motion starts at an event."""
    unit = at.unit
    x = as_float(at.q) * errors.gap + 2.0 * unit * abs(as_float(start.X))
    v = as_float(at.sqrt_q) * errors.push + 2.0 * unit * abs(as_float(here.V1))
    spent = _spent(at, errors.slide, start.spent)
    return Off(errors.late, x, v, v, errors.place, errors.w, spent, math.isfinite(errors.late))


@compilable
def at_horizon(at: Parameters, start: Start, errors: Errors, end: MotionState, tau: Number, horizon: Number) -> Off:
    """Return the errors of the state at the horizon, tau after the start of the last motion."""
    rounded = 4.0 * at.unit * as_float(horizon)
    since = as_float(horizon - start.tau)
    if not since >= errors.late + (rounded if as_float(start.tau) > 0.0 else 0.0):
        errors = lost()
    late, shift = errors.late + rounded, errors.shift + rounded
    pair, begun = in_floats(at, start)
    if start.kind != STICK:
        return _in_slip_at(pair, begun, errors, end, as_float(tau), late, shift)
    # one rotation
    turning = math.sqrt(begun.X * begun.X + begun.push * begun.push)
    moved = pair.q * errors.gap + pair.sqrt_q * errors.push
    error = min(errors.norm + turning * shift, moved + turning * late) + 8.0 * at.unit * turning
    place, spent = errors.place + 2.0 * at.unit * abs(begun.Z), _spent(at, errors.slide, begun.spent)
    return Off(0.0, error, error, error, place, errors.w, spent, math.isfinite(errors.late))


@compilable
def _in_slip_at(
    at: Parameters, start: Start, errors: Errors, end: MotionState, tau: float, late: float, shift: float
) -> Off:
    """Return the errors during a slip: by the contraction of the energy norm or by its closed form, the smaller one."""
    unit, q, r, sqrt_q, d0, u0 = at.unit, at.q, at.r, at.sqrt_q, start.gap, start.push
    driven, guard, theta = start.driven, start.guard, tau / sqrt_q
    u, turned = u0 * math.cos(theta) - (1.0 + d0) * math.sin(theta), driven - theta
    drop, sine_drop = versine(theta), sine_deficit(theta)
    bent, late = abs(1.0 + d0) + abs(u0), late / sqrt_q + 2.0 * unit * theta
    norm = errors.norm + 8.0 * unit * (q * bent + sqrt_q * (abs(driven) + theta + guard))
    norm += shift * _speed(at, bent, abs(driven) + theta + bent)
    x = q * (3.0 * errors.gap + errors.push + abs(u) * late + 8.0 * unit * (abs(d0) + abs(u0) + bent * drop))
    turning = abs(u0) + abs(1.0 + d0) * abs(math.sin(theta))
    v1 = sqrt_q * (errors.push + errors.gap + bent * late + 8.0 * unit * turning)
    v2 = sqrt_q * (errors.push + late + 4.0 * unit * (abs(driven) + theta))
    rounded = guard * theta + abs(d0) * drop + abs(u0) * sine_drop + cosine_deficit(theta)
    slide = q * (drop * errors.gap + sine_drop * errors.push + abs(u - turned) * late + 16.0 * unit * rounded)
    return Off(
        0.0,
        min(norm, x) + 4.0 * unit * abs(as_float(end.X)),
        min(norm / sqrt_q, v1) + 4.0 * unit * abs(as_float(end.V1)),
        min(norm / math.sqrt(r), v2) + 4.0 * unit * abs(as_float(end.V2)),
        errors.place + slide + 4.0 * unit * (abs(start.Z) + abs(as_float(end.Z))),
        errors.w + 2.0 * r * slide + 2.0 * unit * (abs(start.w) + abs(as_float(end.w))),
        _spent(at, errors.slide + slide, end.spent),
        math.isfinite(errors.late),
    )
