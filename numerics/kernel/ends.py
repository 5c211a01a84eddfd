"""The state and its error bounds where somebody looks: at an event, and at the horizon (undamped scenes)."""

from __future__ import annotations

import math

from numerics.kernel.bounds import ULP, Errors, lost, relative, speed
from numerics.kernel.compilation import kernel
from numerics.kernel.elementary import cosine_deficit, sine_deficit, versine
from numerics.kernel.first_contact import gap, push, slid
from numerics.kernel.state import RAY, STICK, End, EventErrors, Pair, Start

_UNDERFLOW = 1e-290
"""What products below the normal numbers may have dropped from a sum of squares."""


@kernel
def velocity(pair: Pair, start: Start) -> float:
    """Return V = V1 = V2 at the start of a motion on the switching surface."""
    if start.kind == STICK:
        return start.push
    return start.side * (math.sqrt(start.w) if start.kind == RAY else pair.sqrt_q * start.driven)


@kernel
def event_errors(pair: Pair, start: Start, errors: Errors) -> EventErrors:
    """Return the errors at the event that a motion starts with, the rounding of SI units included."""
    V, x2 = velocity(pair, start), start.X - start.Z
    scale_x, scale_v = (1.0, 1.0) if start.kind == STICK else (pair.q, pair.sqrt_q)
    x = scale_x * errors.gap + 2.0 * ULP * abs(start.X)
    v = scale_v * errors.push + 2.0 * ULP * abs(V)
    x2_error = x + errors.place + ULP * abs(start.Z)
    times_and_places = max(relative(errors.late, start.tau), relative(x, start.X), relative(x2_error, x2))
    return EventErrors(x, v, max(times_and_places, relative(v, V)) + 8.0 * ULP)


@kernel
def at_horizon(pair: Pair, start: Start, errors: Errors, horizon: float, worst: float) -> End:
    """Return the state at the horizon, which lies in the motion with this start."""
    if not horizon - start.tau >= errors.late + (4.0 * ULP * horizon if start.tau > 0.0 else 0.0):
        errors = lost()
    tau = max((horizon - start.tau) - start.rest, 0.0)  # the rounding of an event at the horizon may lie beyond it
    late, shift = errors.late + 4.0 * ULP * horizon, errors.shift + 4.0 * ULP * horizon
    if start.kind == STICK:
        return in_stick_at(pair, start, errors, tau, late, shift, worst)
    return in_slip_at(pair, start, errors, tau, late, shift, worst)


@kernel
def in_stick_at(
    pair: Pair, start: Start, errors: Errors, tau: float, late: float, shift: float, worst: float, unit: float = ULP
) -> End:
    """Return the state at tau after the start of a stick phase, by one rotation."""
    cosine, sine = math.cos(tau), math.sin(tau)
    X, V = start.X * cosine + start.push * sine, start.push * cosine - start.X * sine
    turning = math.sqrt(start.X * start.X + start.push * start.push)
    error = min(errors.norm + turning * shift, errors.gap + errors.push + turning * late) + 8.0 * unit * turning
    place, spent = (
        errors.place + 2.0 * unit * abs(start.Z),
        2.0 * pair.r * errors.slide + 8.0 * unit * start.spent + _UNDERFLOW,
    )
    certain = math.isfinite(errors.late)
    return End(0, X, V, V, start.Z, start.w, start.spent, error, error, error, place, errors.w, spent, worst, certain)


@kernel
def in_slip_at(
    pair: Pair, start: Start, errors: Errors, tau: float, late: float, shift: float, worst: float, unit: float = ULP
) -> End:
    """Return the state at tau after the start of a slip, by its closed form."""
    q, r, sqrt_q, _ = pair
    theta, side, d0, u0 = tau / sqrt_q, start.side, start.gap, start.push
    d, u = gap(theta, d0, u0), push(theta, d0, u0)
    moved, turned = slid(theta, start.guard, d0, u0), start.driven - theta
    X, V1, V2 = side * (1 + q * d), side * sqrt_q * u, side * sqrt_q * turned
    Z, w, spent = start.Z - side * q * moved, start.w - 2 * r * q * moved, start.spent + 2 * r * q * moved
    # the contraction of the energy norm, or the closed form of this slip: the smaller bound
    drop, sine_drop = versine(theta), sine_deficit(theta)
    bent, late = abs(1.0 + d0) + abs(u0), late / sqrt_q + 2.0 * unit * theta
    norm = errors.norm + 8.0 * unit * (q * bent + sqrt_q * (abs(start.driven) + theta + start.guard))
    norm += shift * speed(q, r, bent, abs(start.driven) + theta + bent)
    x = q * (3.0 * errors.gap + errors.push + abs(u) * late + 8.0 * unit * (abs(d0) + abs(u0) + bent * drop))
    v1 = sqrt_q * (
        errors.push + errors.gap + bent * late + 8.0 * unit * (abs(u0) + abs(1.0 + d0) * abs(math.sin(theta)))
    )
    v2 = sqrt_q * (errors.push + late + 4.0 * unit * (abs(start.driven) + theta))
    rounding = start.guard * theta + abs(d0) * drop + abs(u0) * sine_drop + cosine_deficit(theta)
    slide = q * (drop * errors.gap + sine_drop * errors.push + abs(u - turned) * late + 16.0 * unit * rounding)
    place = errors.place + slide + 4.0 * unit * (abs(start.Z) + abs(Z))
    w_error = errors.w + 2.0 * r * slide + 2.0 * unit * (abs(start.w) + abs(w))
    spent_error, certain = (
        2.0 * r * (errors.slide + slide) + 8.0 * unit * spent + _UNDERFLOW,
        math.isfinite(errors.late),
    )
    x, v1, v2 = min(norm, x), min(norm / sqrt_q, v1), min(norm / math.sqrt(r), v2)
    x, v1, v2 = x + 4.0 * unit * abs(X), v1 + 4.0 * unit * abs(V1), v2 + 4.0 * unit * abs(V2)
    return End(-int(side), X, V1, V2, Z, w, spent, x, v1, v2, place, w_error, spent_error, worst, certain)


@kernel
def at_event(pair: Pair, start: Start, errors: Errors, worst: float) -> End:
    """Return the state at the event that a motion starts with, where a run has stopped."""
    at, V = event_errors(pair, start, errors), velocity(pair, start)
    mode, certain = (0 if start.kind == STICK else -int(start.side)), math.isfinite(errors.late)
    place, spent = (
        errors.place + 2.0 * ULP * abs(start.Z),
        2.0 * pair.r * errors.slide + 8.0 * ULP * start.spent + _UNDERFLOW,
    )
    return End(
        mode, start.X, V, V, start.Z, start.w, start.spent, at.x, at.v, at.v, place, errors.w, spent, worst, certain
    )
