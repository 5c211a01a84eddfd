"""One undamped scene in double-double: the loop of motion.py, its state to 104 bits, its error bounds in binary64.

The formulas and their order are those of motion.py, which says why; the bounds are those of bounds.py with the unit of
double-double in the place of an ulp.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.kernel.bounds import (
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
from numerics.kernel.double_contact import (
    double_contact,
    double_first_contact,
    double_gap,
    double_slid,
)
from numerics.kernel.double_double import (
    ZERO,
    Double,
    add,
    clock,
    divide,
    less,
    negative,
    product,
    scaled,
    square_root,
    subtract,
)
from numerics.kernel.double_elementary import arctangent
from numerics.kernel.double_ends import event_errors, one_plus, two_plus
from numerics.kernel.double_state import UNIT, DoubleLanding, DoublePair, DoubleStart
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
)

_LONGEST, _SHORTEST = 1e14, 1e-60
"""Slip angles that double-double resolves: beyond them no phase is left, or the error of a fourth power is lost."""


@kernel
def stick_reach(start: DoubleStart) -> tuple[float, Double, Double, Double]:
    """Return (side of the exit, distance to it, side V + sqrt w, sqrt w) of a stick phase that ends."""
    velocity = start.push
    side = 1.0 if velocity.high > 0.0 else -1.0
    below = negative(start.gap) if side == start.side else two_plus(start.gap)
    root = square_root(start.w)
    return side, below, add(scaled(velocity, side), root), root


@kernel
def no_landing() -> DoubleLanding:
    """Return what stands for the landing of a stick phase."""
    return DoubleLanding(ZERO, ZERO, ZERO, ZERO, 0.0, 0.0)


@kernel
def landing(pair: DoublePair, start: DoubleStart) -> DoubleLanding:
    """Return the end of a slip."""
    q, gap = pair.q, start.gap
    loss = product(pair.r, q)
    if start.kind == RAY:
        theta, depth, drop = double_contact(ZERO, start.push)
        square = product(depth, depth)
        w = subtract(start.w, product(loss, square))
        return DoubleLanding(theta, negative(depth), scaled(square, 0.5), w, drop, math.inf)
    if start.kind == SURFACE:
        theta, depth, drop = double_contact(gap, start.push)
        end, moved, spared = negative(add(gap, depth)), product(depth, add(scaled(depth, 0.5), gap)), math.inf
    else:
        theta, spared = double_first_contact(start.guard, gap, start.push, start.turns)
        end, drop = double_gap(theta, gap, start.push), 0.0
        moved = double_slid(theta, start.guard, gap, start.push)
    if start.w.high <= 1.0:
        w = subtract(start.w, scaled(product(loss, moved), 2.0))
    else:
        V, beyond = product(pair.sqrt_q, subtract(start.driven, theta)), product(q, end)
        w = add(product(V, V), product(beyond, two_plus(beyond)))
    return DoubleLanding(theta, end, moved, w, drop, spared)


@kernel
def run(
    pair: DoublePair,
    start: DoubleStart,
    errors: Errors,
    linear: Linear,
    horizon: Double,
    left: int,
    rows: Any,
    worst: float,
) -> tuple[int, int, DoubleStart, Errors, Linear, float]:
    """Follow the modes until the horizon, a last stick phase, `left` events, or the last row (motion.run)."""
    count, keep = 0, len(rows)
    q, sqrt_q = pair.q.high, pair.sqrt_q.high
    while True:
        how, length, landed = locate(pair, start)
        if how != MOVING:
            return how, count, start, errors, linear, worst
        tau, rest = clock(start.tau, start.rest, length)
        if less(horizon, tau) or not math.isfinite(tau.high):
            break
        if count == left or (keep > 0 and count == keep):
            return (EVENT_LIMIT if count == left else ROWS_FULL), count, start, errors, linear, worst
        if start.kind == STICK:
            start, errors = leave(pair, start, errors, linear, tau, rest)
        else:
            errors, linear = errors_at_landing(pair, start, errors, linear, landed)
            start = after_landing(pair, start, landed, tau, rest)
            if start.kind == STICK:
                errors = in_stick(errors, q, sqrt_q)
                if linear.w < 0.0:
                    linear = no_linear(errors)
            else:
                errors = in_crossing(errors, q, start.gap.high, UNIT)
        at = event_errors(pair, start, errors)
        worst = max(worst, at.relative)
        if keep > 0:
            record(rows, count, length, start, errors, at)
        count += 1
    late = lateness(pair, start, errors, linear, tau, rest, landed)
    if not subtract(tau, horizon).high > late + 4.0 * UNIT * horizon.high:
        errors = lost()
    return (REACHED if math.isfinite(tau.high) else OUT_OF_RANGE), count, start, errors, linear, worst


@kernel
def lateness(
    pair: DoublePair,
    start: DoubleStart,
    errors: Errors,
    linear: Linear,
    tau: Double,
    rest: Double,
    at: DoubleLanding,
) -> float:
    """Return how late the event that ends a motion may be."""
    if start.kind == STICK:
        return leave(pair, start, errors, linear, tau, rest)[1].late
    return after_slip(pair, start, errors, linear, at)[0].late


@kernel
def locate(pair: DoublePair, start: DoubleStart) -> tuple[int, Double, DoubleLanding]:
    """Return (how it goes on, duration, landing) of a motion: MOVING until its event, STUCK, or OUT_OF_RANGE."""
    if start.kind == STICK:
        if pair.literal or start.w.high <= 0.0:
            return STUCK, ZERO, no_landing()
        _, below, reach, _ = stick_reach(start)
        return MOVING, scaled(arctangent(below, reach), 2.0), no_landing()
    at = landing(pair, start)
    if not _SHORTEST <= at.theta.high <= _LONGEST:
        return OUT_OF_RANGE, ZERO, at
    return MOVING, product(pair.sqrt_q, at.theta), at


@kernel
def leave(
    pair: DoublePair, start: DoubleStart, errors: Errors, linear: Linear, tau: Double, rest: Double
) -> tuple[DoubleStart, Errors]:
    """Return the slip from an exit ray that follows a stick phase, and its errors."""
    side, below, reach, root = stick_reach(start)
    errors = after_stick(errors, linear, below.high, root.high, reach.high, pair.sqrt_q.high, side == start.side, UNIT)
    push = divide(root, pair.sqrt_q)
    X = Double(side, 0.0)
    return DoubleStart(RAY, side, X, ZERO, ZERO, push, push, True, start.Z, start.w, tau, rest, start.spent), errors


@kernel
def after_slip(
    pair: DoublePair, start: DoubleStart, errors: Errors, linear: Linear, at: DoubleLanding
) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip, and their linear part; w < 0 there says that it has none."""
    q, r, theta, w = pair.q.high, pair.r.high, at.theta.high, start.w.high
    if start.kind == RAY:
        return after_ray(q, r, errors, w, at.w.high, theta, -at.gap.high, at.versine, UNIT)
    linear = Linear(0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0)
    if start.kind == SURFACE:
        depth, variables = -add(at.gap, start.gap).high, (start.gap.high, start.push.high, w)
        return after_surface(q, r, errors, variables, at.w.high, (theta, depth, at.versine), UNIT), linear
    free = (start.guard.high, start.gap.high, start.push.high, start.driven.high)
    return after_free(q, r, errors, free, theta, -at.gap.high, at.spared, UNIT), linear


@kernel
def errors_at_landing(
    pair: DoublePair, start: DoubleStart, errors: Errors, linear: Linear, at: DoubleLanding
) -> tuple[Errors, Linear]:
    """Return the errors at the end of a slip, lost where it is not certain what follows."""
    errors, linear = after_slip(pair, start, errors, linear, at)
    place = errors.place + 4.0 * UNIT * abs(start.Z.high)
    errors = Errors(errors.late, errors.gap, errors.push, errors.w, errors.slide, place, errors.shift, errors.norm)
    beyond = -two_plus(product(pair.q, at.gap)).high
    unsure = not abs(beyond) > pair.q.high * errors.gap or (beyond < 0.0 and not abs(at.w.high) > errors.w)
    return (lost() if unsure and not pair.literal else errors), linear


@kernel
def after_landing(pair: DoublePair, start: DoubleStart, at: DoubleLanding, tau: Double, rest: Double) -> DoubleStart:
    """Return the start of the motion after a slip: stick inside the sliding region, else the slip of the other sign."""
    q, side = pair.q, start.side
    turned, offset, slid = subtract(start.driven, at.theta), product(q, at.gap), product(q, at.slid)
    back, X = negative(turned), scaled(one_plus(offset), side)
    Z, beyond = subtract(start.Z, scaled(slid, side)), negative(two_plus(offset))
    spent = add(start.spent, scaled(product(pair.r, slid), 2.0))
    if not pair.literal and (beyond.high > 0.0 or (beyond.high == 0.0 and back.high > 0.0)):
        gap = divide(beyond, q)
        return DoubleStart(SURFACE, -side, X, ZERO, gap, back, back, True, Z, at.w, tau, rest, spent)
    V = scaled(product(pair.sqrt_q, turned), side)
    return DoubleStart(STICK, side, X, ZERO, offset, V, ZERO, True, Z, at.w, tau, rest, spent)


@kernel
def record(rows: Any, index: int, length: Double, start: DoubleStart, errors: Errors, at: EventErrors) -> None:
    """Write one event to its row (COLUMNS)."""
    row, stuck = rows[index], start.kind == STICK
    row[0], row[1], row[2] = (0.0 if stuck else -start.side), start.kind, start.side
    row[3], row[4] = start.tau
    row[5], row[6] = length
    row[7], row[8] = start.X
    row[9], row[10] = start.push
    row[11], row[12] = start.Z
    row[13], row[14] = start.w
    row[15], row[16] = start.gap
    row[17], row[18] = start.driven
    row[19], row[20], row[21], row[22], row[23] = errors.late, at.x, at.v, errors.place, errors.w
