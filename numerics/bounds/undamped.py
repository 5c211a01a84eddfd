"""The error bounds of an undamped run: carried from event to event, read at events and at the end."""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.elementary import cosine_deficit as float_cosine_deficit
from numerics.arithmetic.elementary import sine_deficit as float_sine_deficit
from numerics.arithmetic.elementary import versine as float_versine
from numerics.arithmetic.float64 import UNIT, nonnegative, rough
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.bounds.records import UNDERFLOW, EndErrors, EventErrors, event_errors
from numerics.bounds.undamped_steps import (
    Errors,
    Linear,
    after_free,
    after_ray,
    after_stick,
    after_surface,
    in_crossing,
    in_stick,
    lost,
    no_linear,
    speed,
)
from numerics.motion.codes import RAY, STICK, SURFACE
from numerics.motion.records import At, no_damping
from numerics.motion.undamped import Landing, Pair, Start, flow, stick_reach, velocity

_NO_LINEAR = Linear(0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0)


class Carried(NamedTuple):
    """The errors at the start of a motion, and the first-order part of those of a slip from a ray."""

    errors: Errors
    linear: Linear


@text
def initial(pair: Pair, start: Start, V1: Number, V2: Number) -> Carried:
    """Return the errors of a start whose numbers are exact rationals, rounded."""
    norm = (
        4
        * UNIT
        * (abs(rough(start.X)) + rough(pair.sqrt_q) * abs(rough(V1)) + math.sqrt(rough(pair.r)) * abs(rough(V2)))
    )
    gap, push = 2 * UNIT * abs(rough(start.gap)), 4 * UNIT * abs(rough(start.push))
    w, place = 2 * UNIT * abs(rough(start.w)), 2 * UNIT * abs(rough(start.Z))
    errors = Errors(0.0, gap, push, w, 0.0, place, 0.0, norm)
    return Carried(errors, no_linear(errors))


@text
def gone(carried: Carried) -> Carried:
    """Return the errors of a trajectory of which not even the next mode is certain."""
    return Carried(lost(), carried.linear)


@text
def when_stuck(pair: Pair, start: Start, carried: Carried) -> Carried:  # noqa: ARG001
    """Return the errors of a last stick phase: w <= 0 by more than its error was decided when it began."""
    return carried


@text
def after_event(pair: Pair, before: Start, carried: Carried, at: Landing, after: Start, duration: Number) -> Carried:  # noqa: ARG001
    """Return the errors at the start of the motion `after`, which follows `before`."""
    q, sqrt_q = rough(pair.q), rough(pair.sqrt_q)
    if before.kind == STICK:
        return Carried(leaving(pair, before, carried), carried.linear)
    errors, linear = at_landing(pair, before, carried, at)
    if after.kind == STICK:
        errors = in_stick(errors, q, sqrt_q)
        return Carried(errors, no_linear(errors) if linear.w < 0.0 else linear)
    return Carried(in_crossing(errors, q, rough(after.gap)), linear)


@text
def leaving(pair: Pair, start: Start, carried: Carried) -> Errors:
    """Return the errors on the exit ray that ends a stick phase."""
    at = stick_reach(start)
    below, root, reach = rough(at.below), rough(at.root), rough(at.reach)
    return after_stick(carried.errors, carried.linear, below, root, reach, rough(pair.sqrt_q), at.side == start.side)


@text
def after_slip(pair: Pair, start: Start, errors: Errors, at: Landing) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip, and their linear part; w < 0 there says that it has none."""
    q, r, theta, w, w_after = rough(pair.q), rough(pair.r), rough(at.theta), rough(start.w), rough(at.w)
    placed = 4.0 * UNIT * abs(rough(start.Z))
    if start.kind == RAY:
        return after_ray(q, r, errors, w, w_after, theta, rough(-at.gap), at.versine, placed)
    gap, push = rough(start.gap), rough(start.push)
    if start.kind == SURFACE:
        landing = theta, rough(-at.gap - start.gap), at.versine
        return after_surface(q, r, errors, (gap, push, w), w_after, landing, placed), _NO_LINEAR
    variables = (rough(start.guard), gap, push, rough(start.driven))
    return after_free(q, r, errors, variables, theta, rough(-at.gap), at.spared, placed), _NO_LINEAR


@text
def at_landing(pair: Pair, start: Start, carried: Carried, at: Landing) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip, lost where it is not certain what follows."""
    errors, linear = after_slip(pair, start, carried.errors, at)
    beyond = rough(-(2 + pair.q * at.gap))
    unsure = not abs(beyond) > rough(pair.q) * errors.gap or (beyond < 0.0 and not abs(rough(at.w)) > errors.w)
    return (lost() if unsure and not pair.literal else errors), linear


@text
def before_horizon(
    pair: Pair,
    start: Start,
    carried: Carried,
    at: Landing,
    duration: Number,  # noqa: ARG001
    tau: Number,
    rest: Number,  # noqa: ARG001
    horizon: Number,
) -> Carried:
    """Return the errors, lost where the event that was found at tau, after the horizon, may come before it."""
    if start.kind == STICK:
        late = leaving(pair, start, carried).late
    else:
        late = after_slip(pair, start, carried.errors, at)[0].late
    return carried if rough(tau - horizon) > late + 4.0 * UNIT * rough(horizon) else gone(carried)


@text
def at_event(pair: Pair, start: Start, carried: Carried, velocity: Number) -> EventErrors:
    """Return the errors at the event that a motion starts with, the rounding of SI units included."""
    errors, in_slip = carried.errors, start.kind != STICK
    X, V = rough(start.X), rough(velocity)
    scale_x, scale_v = (rough(pair.q), rough(pair.sqrt_q)) if in_slip else (1.0, 1.0)
    x = scale_x * errors.gap + 2.0 * UNIT * abs(X)
    v = scale_v * errors.push + 2.0 * UNIT * abs(V)
    x2, Z = rough(start.X - start.Z), rough(start.Z)
    return event_errors(rough(start.tau), X, V, x2, Z, (errors.late, x, v, errors.place, errors.w))


@text
def at_horizon(pair: Pair, start: Start, carried: Carried, horizon: Number) -> tuple[At, EndErrors]:
    """Return the state at the horizon, which lies in the motion with this start."""
    errors, rounding = carried.errors, 4.0 * UNIT * rough(horizon)
    since = horizon - start.tau
    if not rough(since) >= errors.late + (rounding if rough(start.tau) > 0.0 else 0.0):
        errors = lost()
    tau = nonnegative(since - start.rest)  # the rounding of an event at the horizon may lie beyond it
    at, late, shift = flow(pair, start, tau), errors.late + rounding, errors.shift + rounding
    if start.kind == STICK:
        return at, in_stick_at(pair, start, errors, late, shift)
    return at, in_slip_at(pair, start, errors, at, rough(tau), late, shift)


@text
def in_stick_at(pair: Pair, start: Start, errors: Errors, late: float, shift: float) -> EndErrors:
    """Return the errors during a stick phase: one rotation."""
    X, V = rough(start.X), rough(start.push)
    turning = math.sqrt(X * X + V * V)
    error = min(errors.norm + turning * shift, errors.gap + errors.push + turning * late) + 8.0 * UNIT * turning
    place = errors.place + 2.0 * UNIT * abs(rough(start.Z))
    spent = 2.0 * rough(pair.r) * errors.slide + 8.0 * UNIT * rough(start.spent) + UNDERFLOW
    return EndErrors(error, error, error, place, errors.w, spent, 0.0, math.isfinite(errors.late))


@text
def in_slip_at(pair: Pair, start: Start, errors: Errors, at: At, tau: float, late: float, shift: float) -> EndErrors:
    """Return the errors during a slip: by the contraction of the energy norm or by its closed form, the smaller one."""
    q, r, sqrt_q = rough(pair.q), rough(pair.r), rough(pair.sqrt_q)
    d0, u0, driven, guard = rough(start.gap), rough(start.push), rough(start.driven), rough(start.guard)
    X, V1, V2, Z, w = rough(at.X), rough(at.V1), rough(at.V2), rough(at.Z), rough(at.w)
    theta = tau / sqrt_q
    u, turned = u0 * math.cos(theta) - (1.0 + d0) * math.sin(theta), driven - theta
    drop, sine_drop = float_versine(theta), float_sine_deficit(theta)
    bent, late = abs(1.0 + d0) + abs(u0), late / sqrt_q + 2.0 * UNIT * theta
    norm = errors.norm + 8.0 * UNIT * (q * bent + sqrt_q * (abs(driven) + theta + guard))
    norm += shift * speed(q, r, bent, abs(driven) + theta + bent)
    x = q * (3.0 * errors.gap + errors.push + abs(u) * late + 8.0 * UNIT * (abs(d0) + abs(u0) + bent * drop))
    turning = abs(u0) + abs(1.0 + d0) * abs(math.sin(theta))
    v1 = sqrt_q * (errors.push + errors.gap + bent * late + 8.0 * UNIT * turning)
    v2 = sqrt_q * (errors.push + late + 4.0 * UNIT * (abs(driven) + theta))
    rounding = guard * theta + abs(d0) * drop + abs(u0) * sine_drop + float_cosine_deficit(theta)
    slide = q * (drop * errors.gap + sine_drop * errors.push + abs(u - turned) * late + 16.0 * UNIT * rounding)
    place = errors.place + slide + 4.0 * UNIT * (abs(rough(start.Z)) + abs(Z))
    w_error = errors.w + 2.0 * r * slide + 2.0 * UNIT * (abs(rough(start.w)) + abs(w))
    spent_error = 2.0 * r * (errors.slide + slide) + 8.0 * UNIT * rough(at.spent) + UNDERFLOW
    x, v1, v2 = min(norm, x), min(norm / sqrt_q, v1), min(norm / math.sqrt(r), v2)
    x, v1, v2 = x + 4.0 * UNIT * abs(X), v1 + 4.0 * UNIT * abs(V1), v2 + 4.0 * UNIT * abs(V2)
    return EndErrors(x, v1, v2, place, w_error, spent_error, 0.0, math.isfinite(errors.late))


@text
def at_last_event(pair: Pair, start: Start, carried: Carried) -> tuple[At, EndErrors]:
    """Return the state at the event that a motion starts with, where a run has stopped."""
    errors, V = carried.errors, velocity(pair, start)
    at = at_event(pair, start, carried, V)
    place = errors.place + 2.0 * UNIT * abs(rough(start.Z))
    spent = 2.0 * rough(pair.r) * errors.slide + 8.0 * UNIT * rough(start.spent) + UNDERFLOW
    certain = math.isfinite(errors.late)
    state = At(start.X, V, V, start.Z, start.w, start.spent, no_damping())
    return state, EndErrors(at.x, at.v, at.v, place, errors.w, spent, 0.0, certain)
