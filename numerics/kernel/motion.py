"""One undamped scene in binary64, from start to horizon, in reduced coordinates: locate, flow, snap, record.

It is the algorithm of undamped.py in plain numbers, the same operations in the same order: both give the same bits,
which the tests compare event by event. Error bounds (bounds.py) are carried along.
"""

from __future__ import annotations

import math
from typing import Any

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
)
from numerics.kernel.compilation import kernel
from numerics.kernel.contact import contact
from numerics.kernel.elementary import clock
from numerics.kernel.ends import event_errors, velocity
from numerics.kernel.first_contact import first_contact, gap, slid
from numerics.kernel.state import (
    EVENT_LIMIT,
    MOVING,
    OUT_OF_RANGE,
    RAY,
    REACHED,
    ROWS_FULL,
    STICK,
    STUCK,
    SURFACE,
    EventErrors,
    Landing,
    Pair,
    Start,
)

_LONGEST, _SHORTEST = 1e12, 1e-97
"""Slip angles that binary64 resolves (slip_flow.py)."""


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
def record(rows: Any, index: int, length: float, pair: Pair, start: Start, errors: Errors, at: EventErrors) -> None:
    """Write one event to its row (COLUMNS)."""
    row, stuck = rows[index], start.kind == STICK
    row[0], row[1], row[2], row[3] = (0.0 if stuck else -start.side), start.kind, start.tau, length
    row[4], row[5], row[6], row[7] = start.X, start.push, start.Z, start.w
    row[8], row[9], row[10] = start.gap, start.side, velocity(pair, start)
    row[11], row[12], row[13], row[14], row[15] = errors.late, at.x, at.v, errors.place, errors.w
