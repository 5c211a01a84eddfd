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
from numerics.kernel.elementary import clock, cosine_deficit, sine_deficit, versine
from numerics.kernel.first_contact import first_contact, gap, push, slid

STICK, RAY, SURFACE, FREE = 0, 1, 2, 3
"""Kinds of motion: stick; slips from an exit ray, from elsewhere on the switching surface, from off it."""
REACHED, STUCK, EVENT_LIMIT, ROWS_FULL, OUT_OF_RANGE, MOVING = 0, 1, 2, 3, 4, 5
"""How a run ended; or that it has not."""
_LONGEST, _SHORTEST = 1e12, 1e-97
"""Slip angles that binary64 resolves (slip_flow.py)."""
_UNDERFLOW = 1e-290
"""What products below the normal numbers may have dropped from a sum of squares."""

COLUMNS = (
    "mode",
    "kind",
    "tau",
    "length",
    "X",
    "push",
    "Z",
    "w",
    "gap",
    "side",
    "V",
    "late",
    "x",
    "v",
    "place",
    "excess",
)
"""A recorded event: mode (-1, 0, +1) and kind of motion after it, its time, how long the motion before it lasted,
how the motion after it starts (Start), and bounds on the errors of tau, X, V, Z and w there."""


class Pair(NamedTuple):
    """The reduced parameters, and whether v1 = v2 is never left (the law three-valued-sgn)."""

    q: float
    r: float
    sqrt_q: float
    literal: bool


class Start(NamedTuple):
    """The start of a mode of motion. In stick X = side (1 + gap) and V = push; in a slip the variables of slip_flow.py.

    `driven` is side V2/sqrt(q); `turns` belongs to a free slip; tau (with its rounding `rest`) is the reduced time;
    `spent` is what friction has taken from E/E_cr so far, a sum of positive terms that never cancels.
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
    spent: float


class Landing(NamedTuple):
    """The end of a slip: its angle, the gap there, K, the excess w, 1 - cos theta (from S), the lowest minimum left."""

    theta: float
    gap: float
    slid: float
    w: float
    versine: float
    spared: float


class EventErrors(NamedTuple):
    """Bounds on the errors of X and V at an event, and on the relative error of t, x1, v and x2."""

    x: float
    v: float
    relative: float


class End(NamedTuple):
    """The state at the horizon (or at the last event, where the run stopped there), with bounds on its errors."""

    mode: int
    X: float
    V1: float
    V2: float
    Z: float
    w: float
    spent: float
    x_error: float
    v1_error: float
    v2_error: float
    place_error: float
    w_error: float
    spent_error: float
    worst: float
    """A bound on the relative error of every t, x1, v and x2 at an event."""
    certain: bool
    """Whether these bounds leave no doubt about the sequence of events."""


class Bounds(NamedTuple):
    """What the kernels say of their own rounding: `events` (k, 4), errors of tau, X, V and Z at each event; the end.

    `damped` is the error of what viscosity has taken from E/E_cr.
    """

    events: Any
    end: End
    damped: float = 0.0


@kernel
def stick_reach(start: Start) -> tuple[float, float, float, float]:
    """Return (side of the exit, distance to it, side V + sqrt w, sqrt w) of a stick phase that ends."""
    velocity = start.push
    side = 1.0 if velocity > 0.0 else -1.0
    below = -start.gap if side == start.side else 2.0 + start.gap
    root = math.sqrt(start.w)
    return side, below, side * velocity + root, root


@kernel
def no_landing() -> Landing:
    """Return what stands for the landing of a stick phase."""
    return Landing(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@kernel
def landing(pair: Pair, start: Start) -> Landing:
    """Return the end of a slip; undamped.py has the same operations."""
    q, r, sqrt_q = pair.q, pair.r, pair.sqrt_q
    if start.kind == RAY:
        theta, depth, drop = contact(0.0, start.push)
        return Landing(theta, -depth, depth * depth / 2, start.w - r * q * depth * depth, drop, math.inf)
    if start.kind == SURFACE:
        theta, depth, drop = contact(start.gap, start.push)
        end, moved, spared = -(start.gap + depth), depth * (depth / 2 + start.gap), math.inf
    else:
        theta, spared = first_contact(start.guard, start.gap, start.push, start.turns)
        end, drop = gap(theta, start.gap, start.push), 0.0
        moved = slid(theta, start.guard, start.gap, start.push)
    if start.w <= 1:
        return Landing(theta, end, moved, start.w - 2 * r * q * moved, drop, spared)
    V, beyond = sqrt_q * (start.driven - theta), q * end
    return Landing(theta, end, moved, V * V + beyond * (2 + beyond), drop, spared)


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
        how, length, landed = locate(pair, start)
        if how != MOVING:
            return how, count, start, errors, linear, worst
        tau, rest = clock(start.tau, start.rest, length)
        if not tau <= horizon:
            break
        if count == left or (keep > 0 and count == keep):
            return (EVENT_LIMIT if count == left else ROWS_FULL), count, start, errors, linear, worst
        if start.kind == STICK:
            start, errors = leave(pair, start, errors, linear, tau, rest)
        else:
            errors, linear = errors_at_landing(pair, start, errors, linear, landed)
            start = after_landing(pair, start, landed, tau, rest)
            if start.kind == STICK:
                errors = in_stick(errors, pair.q, pair.sqrt_q)
                if linear.w < 0.0:
                    linear = no_linear(errors)
            else:
                errors = in_crossing(errors, pair.q, start.gap)
        at = event_errors(pair, start, errors)
        worst = max(worst, at.relative)
        if keep > 0:
            record(rows, count, length, pair, start, errors, at)
        count += 1
    if not tau - horizon > lateness(pair, start, errors, linear, landed) + 4.0 * ULP * horizon:
        errors = lost()
    return (REACHED if math.isfinite(tau) else OUT_OF_RANGE), count, start, errors, linear, worst


@kernel
def lateness(pair: Pair, start: Start, errors: Errors, linear: Linear, at: Landing) -> float:
    """Return how late the event that ends a motion may be."""
    if start.kind == STICK:
        side, below, reach, root = stick_reach(start)
        return after_stick(errors, linear, below, root, reach, pair.sqrt_q, side == start.side).late
    return after_slip(pair, start, errors, linear, at)[0].late


@kernel
def locate(pair: Pair, start: Start) -> tuple[int, float, Landing]:
    """Return (how it goes on, duration, landing) of a motion: MOVING until its event, STUCK, or OUT_OF_RANGE."""
    if start.kind == STICK:
        if pair.literal or start.w <= 0.0:
            return STUCK, 0.0, no_landing()
        _, below, reach, _ = stick_reach(start)
        return MOVING, 2 * math.atan2(below, reach), no_landing()
    at = landing(pair, start)
    if not _SHORTEST <= at.theta <= _LONGEST:
        return OUT_OF_RANGE, 0.0, at
    return MOVING, pair.sqrt_q * at.theta, at


@kernel
def leave(pair: Pair, start: Start, errors: Errors, linear: Linear, tau: float, rest: float) -> tuple[Start, Errors]:
    """Return the slip from an exit ray that follows a stick phase, and its errors."""
    side, below, reach, root = stick_reach(start)
    errors = after_stick(errors, linear, below, root, reach, pair.sqrt_q, side == start.side)
    push = root / pair.sqrt_q
    return Start(RAY, side, side, 0.0, 0.0, push, push, True, start.Z, start.w, tau, rest, start.spent), errors


@kernel
def after_slip(pair: Pair, start: Start, errors: Errors, linear: Linear, at: Landing) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip, and their linear part; w < 0 there says that it has none."""
    q, r = pair.q, pair.r
    if start.kind == RAY:
        return after_ray(q, r, errors, start.w, at.w, at.theta, -at.gap, at.versine)
    linear = Linear(0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0)
    if start.kind == SURFACE:
        landed = (at.theta, -at.gap - start.gap, at.versine)
        return after_surface(q, r, errors, (start.gap, start.push, start.w), at.w, landed), linear
    variables = (start.guard, start.gap, start.push, start.driven)
    return after_free(q, r, errors, variables, at.theta, -at.gap, at.spared), linear


@kernel
def errors_at_landing(pair: Pair, start: Start, errors: Errors, linear: Linear, at: Landing) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip, lost where it is not certain what follows."""
    errors, linear = after_slip(pair, start, errors, linear, at)
    place = errors.place + 4.0 * ULP * abs(start.Z)  # Z is rounded once more
    errors = Errors(errors.late, errors.gap, errors.push, errors.w, errors.slide, place, errors.shift, errors.norm)
    beyond = -(2 + pair.q * at.gap)
    unsure = not abs(beyond) > pair.q * errors.gap or (beyond < 0.0 and not abs(at.w) > errors.w)
    return (lost() if unsure and not pair.literal else errors), linear


@kernel
def after_landing(pair: Pair, start: Start, at: Landing, tau: float, rest: float) -> Start:
    """Return the start of the motion after a slip: stick inside the sliding region, else the slip of the other sign."""
    q, side = pair.q, start.side
    turned, offset = start.driven - at.theta, q * at.gap
    V, X, Z = side * pair.sqrt_q * turned, side * (1 + offset), start.Z - side * q * at.slid
    beyond, spent = -(2 + offset), start.spent + 2 * pair.r * q * at.slid
    if not pair.literal and (beyond > 0.0 or (beyond == 0.0 and -turned > 0.0)):
        return Start(SURFACE, -side, X, 0.0, beyond / q, -turned, -turned, True, Z, at.w, tau, rest, spent)
    return Start(STICK, side, X, 0.0, offset, V, 0.0, True, Z, at.w, tau, rest, spent)


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
def record(rows: Any, index: int, length: float, pair: Pair, start: Start, errors: Errors, at: EventErrors) -> None:
    """Write one event to its row (COLUMNS)."""
    row, stuck = rows[index], start.kind == STICK
    row[0], row[1], row[2], row[3] = (0.0 if stuck else -start.side), start.kind, start.tau, length
    row[4], row[5], row[6], row[7] = start.X, start.push, start.Z, start.w
    row[8], row[9], row[10] = start.gap, start.side, velocity(pair, start)
    row[11], row[12], row[13], row[14], row[15] = errors.late, at.x, at.v, errors.place, errors.w


@kernel
def at_horizon(pair: Pair, start: Start, errors: Errors, horizon: float, worst: float) -> End:
    """Return the state at the horizon, which lies in the motion with this start."""
    if not horizon - start.tau >= errors.late + (4.0 * ULP * horizon if start.tau > 0.0 else 0.0):
        errors = lost()
    tau = (horizon - start.tau) - start.rest
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
