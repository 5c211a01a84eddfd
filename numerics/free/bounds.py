"""The error bounds of a free run: carried from event to event (bound_steps.py), read at events and at the end."""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic import elementary
from numerics.arithmetic.compiled import compilable
from numerics.arithmetic.functions import as_float, rounding
from numerics.arithmetic.protocol import Number
from numerics.free.bound_steps import (
    Errors,
    Linear,
    after_free,
    after_ray,
    after_stick,
    after_surface,
    in_crossing,
    lost,
    no_linear,
    speed,
)
from numerics.free.motion import RAY, STICK, SURFACE, Landing, Parameters, Start, State, stick_reach

UNDERFLOW = 1e-290
"""What products below the normal numbers may have dropped from a sum."""


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
def initial(at: Parameters, start: Start, V1: Number, V2: Number) -> Carried:
    """Return the errors of a start whose numbers are exact rationals, rounded."""
    unit = rounding(at.q)
    X_part, V1_part = abs(as_float(start.X)), as_float(at.sqrt_q) * abs(as_float(V1))
    norm = 4 * unit * (X_part + V1_part + math.sqrt(as_float(at.r)) * abs(as_float(V2)))
    q, gap, push = as_float(at.q), 2 * unit * abs(as_float(start.gap)), 4 * unit * abs(as_float(start.push))
    if start.kind == STICK:
        gap, push = gap / q, push / math.sqrt(q)
    w, place = 2 * unit * abs(as_float(start.w)), 2 * unit * abs(as_float(start.Z))
    errors = Errors(0.0, gap, push, w, 0.0, place, 0.0, norm)
    return Carried(errors, no_linear(q, errors))


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
    if after.kind != STICK:
        errors = in_crossing(rounding(at.q), errors, q, as_float(after.gap))
    return Carried(errors, linear)


@compilable
def _ended(at: Parameters, start: Start, carried: Carried, end: Landing) -> Carried:
    """Return the errors at the end of a motion."""
    q, r, unit, w, w_after = as_float(at.q), as_float(at.r), rounding(at.q), as_float(start.w), as_float(end.w)
    errors = carried.errors
    if start.kind == STICK:
        exit_at = stick_reach(start)
        reached = as_float(exit_at.below), as_float(exit_at.root), as_float(exit_at.reach)
        same_edge = exit_at.side == start.side
        errors = after_stick(unit, errors, carried.linear, reached, as_float(at.sqrt_q), same_edge)
        return Carried(errors, carried.linear)
    theta, depth, placed = as_float(end.theta), as_float(-end.gap), 4.0 * unit * abs(as_float(start.Z))
    if start.kind == RAY:
        errors, linear = after_ray(q, r, unit, errors, (w, w_after), (theta, depth, end.versine), placed)
        return Carried(errors, linear)
    gap, push = as_float(start.gap), as_float(start.push)
    if start.kind == SURFACE:
        landing = theta, as_float(-end.gap - start.gap), end.versine
        errors = after_surface(q, r, unit, errors, (gap, push, w), w_after, landing, placed)
    else:
        variables = (as_float(start.guard), gap, push, as_float(start.driven))
        errors = after_free(q, r, unit, errors, variables, (theta, depth, end.spared), placed)
    return Carried(errors, no_linear(q, errors))


@compilable
def before_horizon(
    at: Parameters, start: Start, carried: Carried, end: Landing, tau: Number, horizon: Number
) -> Carried:
    """Return the errors, lost where the event that was found at tau, after the horizon, may come before it."""
    late = _ended(at, start, carried, end).errors.late
    sure = as_float(tau - horizon) > late + 4.0 * rounding(at.q) * as_float(horizon)
    return carried if sure else Carried(lost(), carried.linear)


@compilable
def at_start(at: Parameters, start: Start, errors: Errors, here: State) -> Off:
    """Return the errors of the state with which a motion starts at an event."""
    unit = rounding(at.q)
    x = as_float(at.q) * errors.gap + 2.0 * unit * abs(as_float(start.X))
    v = as_float(at.sqrt_q) * errors.push + 2.0 * unit * abs(as_float(here.V1))
    spent = 2.0 * as_float(at.r) * errors.slide + 8.0 * unit * as_float(start.spent) + UNDERFLOW
    return Off(errors.late, x, v, v, errors.place, errors.w, spent, math.isfinite(errors.late))


@compilable
def at_horizon(at: Parameters, start: Start, errors: Errors, end: State, tau: Number, horizon: Number) -> Off:
    """Return the errors of the state at the horizon, tau after the start of the last motion."""
    rounded = 4.0 * rounding(at.q) * as_float(horizon)
    since = as_float(horizon - start.tau)
    if not since >= errors.late + (rounded if as_float(start.tau) > 0.0 else 0.0):
        errors = lost()
    late, shift = errors.late + rounded, errors.shift + rounded
    if start.kind == STICK:
        return _in_stick_at(at, start, errors, late, shift)
    return _in_slip_at(at, start, errors, end, as_float(tau), late, shift)


@compilable
def _in_stick_at(at: Parameters, start: Start, errors: Errors, late: float, shift: float) -> Off:
    """Return the errors during a stick phase: one rotation."""
    unit, X, V = rounding(at.q), as_float(start.X), as_float(start.push)
    turning = math.sqrt(X * X + V * V)
    moved = as_float(at.q) * errors.gap + as_float(at.sqrt_q) * errors.push
    error = min(errors.norm + turning * shift, moved + turning * late) + 8.0 * unit * turning
    place = errors.place + 2.0 * unit * abs(as_float(start.Z))
    spent = 2.0 * as_float(at.r) * errors.slide + 8.0 * unit * as_float(start.spent) + UNDERFLOW
    return Off(0.0, error, error, error, place, errors.w, spent, math.isfinite(errors.late))


@compilable
def _in_slip_at(at: Parameters, start: Start, errors: Errors, end: State, tau: float, late: float, shift: float) -> Off:
    """Return the errors during a slip: by the contraction of the energy norm or by its closed form, the smaller one."""
    q, r, sqrt_q, unit = as_float(at.q), as_float(at.r), as_float(at.sqrt_q), rounding(at.q)
    d0, u0, driven, guard = as_float(start.gap), as_float(start.push), as_float(start.driven), as_float(start.guard)
    X, V1, V2, Z, w = as_float(end.X), as_float(end.V1), as_float(end.V2), as_float(end.Z), as_float(end.w)
    theta = tau / sqrt_q
    u, turned = u0 * math.cos(theta) - (1.0 + d0) * math.sin(theta), driven - theta
    drop, sine_drop = elementary.versine(theta), elementary.sine_deficit(theta)
    bent, late = abs(1.0 + d0) + abs(u0), late / sqrt_q + 2.0 * unit * theta
    norm = errors.norm + 8.0 * unit * (q * bent + sqrt_q * (abs(driven) + theta + guard))
    norm += shift * speed(q, r, bent, abs(driven) + theta + bent)
    x = q * (3.0 * errors.gap + errors.push + abs(u) * late + 8.0 * unit * (abs(d0) + abs(u0) + bent * drop))
    turning = abs(u0) + abs(1.0 + d0) * abs(math.sin(theta))
    v1 = sqrt_q * (errors.push + errors.gap + bent * late + 8.0 * unit * turning)
    v2 = sqrt_q * (errors.push + late + 4.0 * unit * (abs(driven) + theta))
    rounded = guard * theta + abs(d0) * drop + abs(u0) * sine_drop + elementary.cosine_deficit(theta)
    slide = q * (drop * errors.gap + sine_drop * errors.push + abs(u - turned) * late + 16.0 * unit * rounded)
    place = errors.place + slide + 4.0 * unit * (abs(as_float(start.Z)) + abs(Z))
    w_error = errors.w + 2.0 * r * slide + 2.0 * unit * (abs(as_float(start.w)) + abs(w))
    spent = 2.0 * r * (errors.slide + slide) + 8.0 * unit * as_float(end.spent) + UNDERFLOW
    x, v1, v2 = min(norm, x), min(norm / sqrt_q, v1), min(norm / math.sqrt(r), v2)
    x, v1, v2 = x + 4.0 * unit * abs(X), v1 + 4.0 * unit * abs(V1), v2 + 4.0 * unit * abs(V2)
    return Off(0.0, x, v1, v2, place, w_error, spent, math.isfinite(errors.late))
