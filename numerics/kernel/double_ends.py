"""The double-double state and its error bounds where somebody looks: at an event, and at the horizon (ends.py)."""

from __future__ import annotations

import math

from numerics.kernel.bounds import Errors, lost, relative
from numerics.kernel.compilation import kernel
from numerics.kernel.double_contact import double_gap, double_push, double_slid
from numerics.kernel.double_double import (
    ONE,
    Double,
    add,
    divide,
    product,
    scaled,
    square_root,
    subtract,
)
from numerics.kernel.double_elementary import sine_cosine
from numerics.kernel.double_state import (
    UNIT,
    DoubleEnd,
    DoublePair,
    DoubleStart,
    rounded_pair,
    rounded_start,
)
from numerics.kernel.ends import in_slip_at, in_stick_at
from numerics.kernel.state import RAY, STICK, End, EventErrors


@kernel
def one_plus(a: Double) -> Double:
    """Return 1 + a."""
    return add(ONE, a)


@kernel
def two_plus(a: Double) -> Double:
    """Return 2 + a."""
    return add(Double(2.0, 0.0), a)


@kernel
def velocity(pair: DoublePair, start: DoubleStart) -> Double:
    """Return V = V1 = V2 at the start of a motion on the switching surface."""
    if start.kind == STICK:
        return start.push
    return scaled(square_root(start.w) if start.kind == RAY else product(pair.sqrt_q, start.driven), start.side)


@kernel
def event_errors(pair: DoublePair, start: DoubleStart, errors: Errors) -> EventErrors:
    """Return the errors at the event that a motion starts with, the rounding of SI units included."""
    X, V, x2 = start.X.high, velocity(pair, start).high, subtract(start.X, start.Z).high
    scale_x, scale_v = (1.0, 1.0) if start.kind == STICK else (pair.q.high, pair.sqrt_q.high)
    x = scale_x * errors.gap + 2.0 * UNIT * abs(X)
    v = scale_v * errors.push + 2.0 * UNIT * abs(V)
    x2_error = x + errors.place + UNIT * abs(start.Z.high)
    times_and_places = max(relative(errors.late, start.tau.high), relative(x, X), relative(x2_error, x2))
    return EventErrors(x, v, max(times_and_places, relative(v, V)) + 8.0 * UNIT)


@kernel
def at_horizon(pair: DoublePair, start: DoubleStart, errors: Errors, horizon: Double, worst: float) -> DoubleEnd:
    """Return the state at the horizon, which lies in the motion with this start."""
    since = subtract(horizon, start.tau)
    if not since.high >= errors.late + (4.0 * UNIT * horizon.high if start.tau.high > 0.0 else 0.0):
        errors = lost()
    tau = subtract(since, start.rest)
    late, shift = errors.late + 4.0 * UNIT * horizon.high, errors.shift + 4.0 * UNIT * horizon.high
    rough_pair, rough = rounded_pair(pair), rounded_start(start)
    if start.kind == STICK:
        bounds = in_stick_at(rough_pair, rough, errors, tau.high, late, shift, worst, UNIT)
        sine, cosine = sine_cosine(tau)
        X = add(product(start.X, cosine), product(start.push, sine))
        V = subtract(product(start.push, cosine), product(start.X, sine))
        return DoubleEnd(X, V, V, start.Z, start.w, start.spent, bounds)
    bounds = in_slip_at(rough_pair, rough, errors, tau.high, late, shift, worst, UNIT)
    theta, side = divide(tau, pair.sqrt_q), start.side
    offset = product(pair.q, double_gap(theta, start.gap, start.push))
    V1 = product(pair.sqrt_q, double_push(theta, start.gap, start.push))
    V2 = product(pair.sqrt_q, subtract(start.driven, theta))
    moved = product(pair.q, double_slid(theta, start.guard, start.gap, start.push))
    loss, Z = scaled(product(pair.r, moved), 2.0), subtract(start.Z, scaled(moved, side))
    X, V1, V2 = scaled(one_plus(offset), side), scaled(V1, side), scaled(V2, side)
    return DoubleEnd(X, V1, V2, Z, subtract(start.w, loss), add(start.spent, loss), bounds)


@kernel
def at_event(pair: DoublePair, start: DoubleStart, errors: Errors, worst: float) -> DoubleEnd:
    """Return the state at the event that a motion starts with, where a run has stopped."""
    at, V, rough = event_errors(pair, start, errors), velocity(pair, start), rounded_start(start)
    mode, certain = (0 if start.kind == STICK else -int(start.side)), math.isfinite(errors.late)
    place = errors.place + 2.0 * UNIT * abs(rough.Z)
    spent = 2.0 * pair.r.high * errors.slide + 8.0 * UNIT * rough.spent + 1e-290
    end = End(
        mode,
        rough.X,
        V.high,
        V.high,
        rough.Z,
        rough.w,
        rough.spent,
        at.x,
        at.v,
        at.v,
        place,
        errors.w,
        spent,
        worst,
        certain,
    )
    return DoubleEnd(start.X, V, V, start.Z, start.w, start.spent, end)
