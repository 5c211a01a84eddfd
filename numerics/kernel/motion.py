"""One undamped scene in binary64, from start to horizon, in reduced coordinates: locate, flow, snap, record.

It is the algorithm of undamped.py in plain numbers, the same operations in the same order: both give the same bits,
which the tests compare event by event. Error bounds (bounds.py) are carried along.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from numerics.kernel.bounds import (
    ULP,
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
    relative,
    speed,
)
from numerics.kernel.compilation import kernel
from numerics.kernel.contact import contact
from numerics.kernel.elementary import clock
from numerics.kernel.first_contact import first_contact, gap, push, slid

STICK, RAY, SURFACE, FREE = 0, 1, 2, 3
"""Kinds of motion: stick; slips from an exit ray, from elsewhere on the switching surface, from off it."""
REACHED, STUCK, EVENT_LIMIT, ROWS_FULL, OUT_OF_RANGE = 0, 1, 2, 3, 4
"""How a run ended."""
_LONGEST, _SHORTEST = 1e12, 1e-97
"""Slip angles that binary64 resolves (slip_flow.py)."""

COLUMNS = ("mode", "kind", "tau", "length", "X", "V", "Z", "w", "gap", "push", "late", "x", "v", "slide", "excess")
"""A recorded event: mode (-1, 0, +1) and kind of motion after it, its time, how long the motion before it lasted, the
state, the variables gap and push of the motion after it, and bounds on the errors of tau, X, V, Z and w."""


class Pair(NamedTuple):
    """The reduced parameters, and whether v1 = v2 is never left (the law three-valued-sgn)."""

    q: float
    r: float
    sqrt_q: float
    literal: bool


class Start(NamedTuple):
    """The start of a mode of motion. In stick X = side (1 + gap) and V = push; in a slip the variables of slip_flow.py.

    `driven` is side V2/sqrt(q); `turns` belongs to a free slip; tau (with its rounding `rest`) is the reduced time.
    """

    kind: int
    side: float
    X: float
    guard: float
    gap: float
    push: float
    driven: float
    turns: bool
    Z: float
    w: float
    tau: float
    rest: float


class End(NamedTuple):
    """The state at the horizon (or at the last event, where the run stopped there), with bounds on its errors."""

    mode: int
    X: float
    V1: float
    V2: float
    Z: float
    w: float
    x_error: float
    v1_error: float
    v2_error: float
    slide_error: float
    w_error: float
    worst: float
    """A bound on the relative error of every t, x1, v and x2 at an event."""
    certain: bool
    """Whether these bounds leave no doubt about the sequence of events."""


@kernel
def stick_reach(start: Start) -> tuple[float, float, float, float]:
    """Return (side of the exit, distance to it, side V + sqrt w, sqrt w) of a stick phase that ends."""
    velocity = start.push
    side = 1.0 if velocity > 0.0 else -1.0
    below = -start.gap if side == start.side else 2.0 + start.gap
    root = math.sqrt(start.w)
    return side, below, side * velocity + root, root


@kernel
def landing(pair: Pair, start: Start) -> tuple[float, float, float, float, float, float]:
    """Return (theta, gap', K, w', 1 - cos theta, spared) at the end of a slip; undamped.py has the same operations."""
    q, r, sqrt_q = pair.q, pair.r, pair.sqrt_q
    if start.kind == RAY:
        theta, depth, versine = contact(0.0, start.push)
        return theta, -depth, depth * depth / 2, start.w - r * q * depth * depth, versine, math.inf
    if start.kind == SURFACE:
        theta, depth, versine = contact(start.gap, start.push)
        end, moved, spared = -(start.gap + depth), depth * (depth / 2 + start.gap), math.inf
    else:
        theta, spared = first_contact(start.guard, start.gap, start.push, start.turns)
        end, versine = gap(theta, start.gap, start.push), 0.0
        moved = slid(theta, start.guard, start.gap, start.push)
    if start.w <= 1:
        return theta, end, moved, start.w - 2 * r * q * moved, versine, spared
    V, beyond = sqrt_q * (start.driven - theta), q * end
    return theta, end, moved, V * V + beyond * (2 + beyond), versine, spared


@kernel
def run(
    pair: Pair, start: Start, errors: Errors, linear: Linear, horizon: float, left: int, rows: Any, worst: float
) -> tuple[int, int, Start, Errors, Linear, float]:
    """Follow the modes until the horizon, a last stick phase, `left` events, or the last row.

    Returns (how it ended, events, start of the last mode, its errors, its linear part, worst): run again from there to
    go on. `rows` (n, len(COLUMNS)) keeps the events; with n = 0 nothing is kept. `worst` is a bound on the relative
    error of every t, x1, v and x2 at an event so far; where even the sequence is uncertain errors.late is infinite.
    """
    count, keep = 0, len(rows)
    while True:
        if start.kind == STICK:
            if pair.literal or start.w <= 0.0:
                return STUCK, count, start, errors, linear, worst
            side, below, reach, root = stick_reach(start)
            length = 2 * math.atan2(below, reach)
        else:
            theta, end, moved, w, versine, spared = landing(pair, start)
            if not _SHORTEST <= theta <= _LONGEST:
                return OUT_OF_RANGE, count, start, errors, linear, worst
            length = pair.sqrt_q * theta
        tau, rest = clock(start.tau, start.rest, length)
        if not tau <= horizon:
            break
        if count == left:
            return EVENT_LIMIT, count, start, errors, linear, worst
        if keep > 0 and count == keep:
            return ROWS_FULL, count, start, errors, linear, worst
        if start.kind == STICK:
            errors = after_stick(errors, linear, below, root, reach, pair.sqrt_q, side == start.side)
            pushed = root / pair.sqrt_q
            start = Start(RAY, side, side, 0.0, 0.0, pushed, pushed, True, start.Z, start.w, tau, rest)
            V, x_error, v_error = side * root, 0.0, errors.push * pair.sqrt_q
        else:
            errors, linear = errors_at_landing(pair, start, errors, linear, (theta, end, w, versine, spared))
            offset_error, v_error = pair.q * errors.gap, pair.sqrt_q * errors.push
            start = after_landing(pair, start, (theta, end, moved, w), (tau, rest))
            V = start.push if start.kind == STICK else start.side * pair.sqrt_q * start.push
            if start.kind == STICK:
                errors = in_stick(errors, offset_error, v_error)
                if linear.w < 0.0:
                    linear = no_linear(errors)
            else:
                errors = in_crossing(pair.q, errors, pair.q * end)
            x_error, v_error = offset_error + 2.0 * ULP * abs(start.X), v_error + 2.0 * ULP * abs(V)
        at_event = event_error(start, V, errors, x_error, v_error)
        worst = max(worst, at_event)
        if keep > 0:
            record(rows, count, length, start, V, errors, x_error, v_error)
        count += 1
    if not tau - horizon > errors.late:
        errors = lost()
    return (REACHED if math.isfinite(tau) else OUT_OF_RANGE), count, start, errors, linear, worst


@kernel
def errors_at_landing(
    pair: Pair, start: Start, errors: Errors, linear: Linear, at: tuple[float, float, float, float, float]
) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip, lost where it is not certain what follows; at = (theta, gap', w', ...)."""
    theta, end, w, versine, spared = at
    q, r = pair.q, pair.r
    if start.kind == RAY:
        errors, linear = after_ray(q, r, errors, start.w, w, theta, -end, versine)
    else:
        if start.kind == SURFACE:
            landed = (theta, -end - start.gap, versine)
            errors = after_surface(q, r, errors, (start.gap, start.push, start.w), w, landed)
        else:
            variables = (start.guard, start.gap, start.push, start.driven)
            errors = after_free(q, r, errors, variables, theta, -end, spared)
        linear = Linear(0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0)
    moved = 4.0 * ULP * abs(start.Z)  # Z is rounded once more
    errors = Errors(errors.late, errors.gap, errors.push, errors.w, errors.slide + moved, errors.shift, errors.norm)
    if not pair.literal:
        beyond = -(2 + q * end)
        if not abs(beyond) > q * errors.gap or (beyond < 0.0 and not abs(w) > errors.w):
            errors = lost()
    return errors, linear


@kernel
def after_landing(pair: Pair, start: Start, at: tuple[float, float, float, float], time: tuple[float, float]) -> Start:
    """Return the start of the motion after a slip: stick inside the sliding region, else the slip of the other sign."""
    theta, end, moved, w = at
    q, side = pair.q, start.side
    turned, offset = start.driven - theta, q * end
    V, X, Z = side * pair.sqrt_q * turned, side * (1 + offset), start.Z - side * q * moved
    beyond = -(2 + offset)
    if not pair.literal and (beyond > 0.0 or (beyond == 0.0 and -turned > 0.0)):
        return Start(SURFACE, -side, X, 0.0, beyond / q, -turned, -turned, True, Z, w, time[0], time[1])
    return Start(STICK, side, X, 0.0, offset, V, 0.0, True, Z, w, time[0], time[1])


@kernel
def event_error(start: Start, V: float, errors: Errors, x_error: float, v_error: float) -> float:
    """Return the largest relative error of t, x1, v and x2 at the start of a motion, the units' own rounding included."""
    x2 = start.X - start.Z
    x2_error = x_error + errors.slide + ULP * abs(start.Z)
    largest = max(relative(errors.late, start.tau), relative(x_error, start.X))
    return max(max(largest, relative(v_error, V)), relative(x2_error, x2)) + 8.0 * ULP


@kernel
def record(
    rows: Any, index: int, length: float, start: Start, V: float, errors: Errors, x_error: float, v_error: float
) -> None:
    """Write one event to its row (COLUMNS)."""
    row = rows[index]
    row[0], row[1] = (0.0 if start.kind == STICK else -start.side), start.kind
    row[2], row[3], row[4], row[5], row[6], row[7] = start.tau, length, start.X, V, start.Z, start.w
    row[8], row[9] = start.gap, start.push
    row[10], row[11], row[12] = errors.late, x_error, v_error
    row[13], row[14] = errors.slide, errors.w


@kernel
def at_horizon(pair: Pair, start: Start, errors: Errors, horizon: float, worst: float) -> End:
    """Return the state at the horizon, which lies in the motion with this start."""
    q, r, sqrt_q, _ = pair
    if not horizon - start.tau >= errors.late:
        errors = lost()
    tau = (horizon - start.tau) - start.rest
    timing = errors.shift + 4.0 * ULP * horizon
    if start.kind == STICK:
        cosine, sine = math.cos(tau), math.sin(tau)
        X, V = start.X * cosine + start.push * sine, start.push * cosine - start.X * sine
        moving = math.sqrt(start.X * start.X + start.push * start.push)
        error = errors.norm + moving * (timing + 8.0 * ULP)
        certain = math.isfinite(errors.late)
        return End(0, X, V, V, start.Z, start.w, error, error, error, errors.slide, errors.w, worst, certain)
    theta, side = tau / sqrt_q, start.side
    d, u = gap(theta, start.gap, start.push), push(theta, start.gap, start.push)
    moved, turned = slid(theta, start.guard, start.gap, start.push), start.driven - theta
    reach = abs(1.0 + start.gap) + abs(start.push)
    motion = abs(start.driven) + theta + reach
    own = ULP * (16.0 * q * reach + 8.0 * sqrt_q * (motion + start.guard) + 4.0)
    norm = errors.norm + own + timing * speed(q, r, reach, motion)
    relative_speed = sqrt_q * (abs(u) + abs(turned))
    spread = norm * math.sqrt(1.0 / q + 1.0 / r)
    slide = (
        errors.slide + spread * tau + relative_speed * timing + 8.0 * ULP * q * (start.guard + reach + theta) * theta
    )
    w = start.w - 2 * r * q * moved
    w_error = errors.w + 2.0 * r * (slide - errors.slide) + ULP * (abs(start.w) + abs(w))
    X, V1, V2 = side * (1 + q * d), side * sqrt_q * u, side * sqrt_q * turned
    Z = start.Z - side * q * moved
    root_q, root_r = math.sqrt(q), math.sqrt(r)
    certain = math.isfinite(errors.late)
    return End(-int(side), X, V1, V2, Z, w, norm, norm / root_q, norm / root_r, slide, w_error, worst, certain)


@kernel
def at_event(pair: Pair, start: Start, errors: Errors, worst: float) -> End:
    """Return the state at the start of a motion, where a run has stopped."""
    stuck = start.kind == STICK
    V = start.push if stuck else start.side * pair.sqrt_q * start.driven
    scale_x, scale_v = (1.0, 1.0) if stuck else (pair.q, pair.sqrt_q)
    x_error, v_error = scale_x * errors.gap, scale_v * errors.push
    mode = 0 if stuck else -int(start.side)
    x_error, v_error = x_error + 2.0 * ULP * abs(start.X), v_error + 2.0 * ULP * abs(V)
    certain = math.isfinite(errors.late)
    return End(mode, start.X, V, V, start.Z, start.w, x_error, v_error, v_error, errors.slide, errors.w, worst, certain)
