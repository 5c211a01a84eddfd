"""One viscous scene in binary64, from start to horizon, in reduced coordinates: locate, flow, snap, record.

It is the algorithm of viscous.py in plain numbers, the same operations in the same order: both give the same bits,
which the tests compare event by event. Error bounds (viscous_bounds.py) are carried along.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.kernel.bounds import ULP, relative
from numerics.kernel.compilation import kernel
from numerics.kernel.elementary import clock
from numerics.kernel.state import EVENT_LIMIT, MOVING, OUT_OF_RANGE, REACHED, ROWS_FULL, STUCK
from numerics.kernel.viscous_bounds import Errors, lost
from numerics.kernel.viscous_contact import LOAD, first_contact, root
from numerics.kernel.viscous_errors import after_slip, after_stick, keeps_off, stays
from numerics.kernel.viscous_oscillator import first_jerk_zero, integral_of_square, propagate
from numerics.kernel.viscous_state import Landing, Start, ViscousPair

COLUMNS = (
    "mode",
    "kind",
    "tau",
    "length",
    "X",
    "V",
    "Z",
    "w",
    "load",
    "spent",
    "damped",
    "late",
    "x",
    "v",
    "place",
    "excess",
)
"""A recorded event: mode (-1, 0, +1) after it (kind: the same), its time, how long the motion before it lasted, the
state and P there, what friction and viscosity have taken so far, and bounds on the errors of tau, X, V, Z and w."""


@kernel
def energy_ratio(pair: ViscousPair, X: float, V1: float, V2: float) -> float:
    """Return E/E_cr."""
    return X * X + pair.q * V1 * V1 + pair.r * V2 * V2


@kernel
def flow(pair: ViscousPair, start: Start, tau: float, spared: float) -> Landing:
    """Return the state at tau after the start of a motion, and what friction and viscosity have taken until then."""
    if start.mode == 0:
        X, V = propagate(pair.stick, start.X, start.V1, tau)
        pull = -(pair.two_zeta * start.V1 + start.X)
        damped = 2 * pair.two_zeta * integral_of_square(pair.stick, start.V1, pull, tau)
        w = energy_ratio(pair, X, V, V) - 1
        return Landing(X, V, V, start.Z, w, start.spent, start.damped + max(damped, 0.0), spared)
    sign = float(start.mode)
    y_start, v_start = sign * start.X + pair.r, sign * start.V1
    y, v = propagate(pair.slip, y_start, v_start, tau)
    X, V1, V2 = sign * (y - pair.r), sign * v, start.V2 + sign * tau
    slid = y - y_start - (sign * start.V2 + tau / 2) * tau
    pull = -(pair.two_zeta * v_start + y_start) / pair.q
    damped = 2 * pair.two_zeta * integral_of_square(pair.slip, v_start, pull, tau)
    spent = start.spent + max(2 * pair.r * slid, 0.0)
    w = energy_ratio(pair, X, V1, V2) - 1
    return Landing(X, V1, V2, start.Z + sign * slid, w, spent, start.damped + max(damped, 0.0), spared)


@kernel
def locate(pair: ViscousPair, start: Start) -> tuple[int, float, float]:
    """Return (how it goes on, duration, a number) of a motion: MOVING until its event, STUCK, or OUT_OF_RANGE.

    The number is the side of the exit of a stick phase; of a slip how far above 0 its guard stayed (first_contact).
    """
    if start.mode == 0:
        return locate_exit(pair, start)
    sign = float(start.mode)
    y, v, c = sign * start.X + pair.r, sign * start.V1, sign * start.V2
    tau, spared = first_contact(pair.slip, y, v, c, start.level, start.rising)
    return (MOVING if math.isfinite(tau) else OUT_OF_RANGE), tau, spared


@kernel
def locate_exit(pair: ViscousPair, start: Start) -> tuple[int, float, float]:
    """Return (MOVING, time, side) of the exit from |P| <= 1; STUCK if there is none, OUT_OF_RANGE."""
    if pair.literal:
        return STUCK, 0.0, 0.0
    stick, load = pair.stick, start.X + pair.two_zeta * start.V1
    rate = 0.0 if start.level else start.V1 - pair.two_zeta * load
    inside = 1 - load * load - rate * rate
    if not -math.inf < inside <= 0.0:
        return (STUCK if math.isfinite(inside) else OUT_OF_RANGE), 0.0, 0.0
    late = (64 + load * load + rate * rate) / (stick.slow if stick.regime < 0 else stick.decay)
    turning = first_jerk_zero(stick, start.X, start.V1, late, start.level)
    if not turning < math.inf:
        left, speed = propagate(stick, load, rate, late)
        proved = turning == math.inf and math.isfinite(1 - left * left - speed * speed)
        return (STUCK if proved else OUT_OF_RANGE), 0.0, 0.0
    extremum, _ = propagate(stick, load, rate, turning)
    side = 1.0 if extremum > 0 else -1.0
    beyond = side * extremum - 1
    if not 0.0 < beyond < math.inf:
        return (STUCK if math.isfinite(beyond) else OUT_OF_RANGE), 0.0, 0.0
    return MOVING, root(LOAD, stick, load, rate, 0.0, side, 0.0, turning), side


@kernel
def run(
    pair: ViscousPair, start: Start, errors: Errors, horizon: float, left: int, rows: Any, worst: float
) -> tuple[int, int, Start, Errors, float]:
    """Follow the modes until the horizon, a last stick phase, `left` events, or the last row.

    Returns (how it ended, events, start of the last mode, its errors, worst): run again from there to go on. `rows`
    (n, len(COLUMNS)) keeps the events; with n = 0 nothing is kept. `worst` is a bound on the relative error of every
    t, x1, v and x2 at an event so far; where even the sequence is uncertain errors.late is infinite.
    """
    count, keep = 0, len(rows)
    while True:
        how, length, found = locate(pair, start)
        if how == STUCK and not stays(pair, start, errors):
            errors = lost()
        if how != MOVING:
            return how, count, start, errors, worst
        tau, rest = clock(start.tau, start.rest, length)
        if not tau <= horizon:
            break
        if count == left or (keep > 0 and count == keep):
            return (EVENT_LIMIT if count == left else ROWS_FULL), count, start, errors, worst
        at = flow(pair, start, length, found)
        if start.mode == 0:
            following = leave(pair, at, tau, rest, found)
            errors = after_stick(pair, start, errors, at, following, length)
        else:
            following = land(pair, start, at, tau, rest)
            if not math.isfinite(following.w):
                return OUT_OF_RANGE, count, start, errors, worst
            errors = after_slip(pair, start, errors, at, following, length)
        start = following
        worst = max(worst, event_error(start, errors))
        if keep > 0:
            record(pair, rows, count, length, start, errors)
        count += 1
    if math.isfinite(tau) and not ends_before(pair, start, errors, horizon, length, found):
        errors = lost()
    return (REACHED if math.isfinite(tau) else OUT_OF_RANGE), count, start, errors, worst


@kernel
def ends_before(pair: ViscousPair, start: Start, errors: Errors, horizon: float, length: float, found: float) -> bool:
    """Return whether it is certain that the horizon comes before the next event, which was found after it."""
    until, shift = (horizon - start.tau) - start.rest, 4.0 * ULP * horizon
    here = flow(pair, start, until, found)
    if keeps_off(pair, start, errors, here, until, shift, found):
        return True
    at, (tau, rest) = flow(pair, start, length, found), clock(start.tau, start.rest, length)
    if start.mode == 0:
        late = after_stick(pair, start, errors, at, leave(pair, at, tau, rest, found), length).late
    else:
        late = after_slip(pair, start, errors, at, land(pair, start, at, tau, rest), length).late
    return length - until > late + shift


@kernel
def leave(pair: ViscousPair, at: Landing, tau: float, rest: float, side: float) -> Start:
    """Return the slip that starts on the edge P = side, which X is snapped to exactly."""
    X = side - pair.two_zeta * at.V1
    return Start(-int(side), X, at.V1, at.V2, at.Z, at.w, True, False, tau, rest, at.spent, at.damped)


@kernel
def land(pair: ViscousPair, start: Start, at: Landing, tau: float, rest: float) -> Start:
    """Return the start of the motion after a slip, V1 = V2: stick, or the slip of the other sign (modes.py)."""
    sign, V = float(start.mode), at.V2
    load = at.X + pair.two_zeta * V
    beyond, leaving = sign * load - 1, sign * (V - pair.two_zeta * load)
    outside = not pair.literal and (beyond > 0.0 or (beyond == 0.0 and leaving > 0.0))
    w = at.w if pair.literal or math.isfinite(beyond) else math.nan
    return Start(-start.mode if outside else 0, at.X, V, V, at.Z, w, True, False, tau, rest, at.spent, at.damped)


@kernel
def event_error(start: Start, errors: Errors) -> float:
    """Return a bound on the relative error of t, x1, v and x2 at the event that a motion starts with, in SI units."""
    x, v = errors.x + 2.0 * ULP * abs(start.X), errors.v + 2.0 * ULP * abs(start.V2)
    x2 = x + errors.place + ULP * abs(start.Z)
    times_and_places = max(relative(errors.late, start.tau), relative(x, start.X), relative(x2, start.X - start.Z))
    return max(times_and_places, relative(v, start.V2)) + 8.0 * ULP


@kernel
def record(pair: ViscousPair, rows: Any, index: int, length: float, start: Start, errors: Errors) -> None:
    """Write one event to its row (COLUMNS)."""
    row = rows[index]
    row[0], row[1], row[2], row[3] = start.mode, start.mode, start.tau, length
    row[4], row[5], row[6], row[7] = start.X, start.V2, start.Z, start.w
    row[8], row[9], row[10] = start.X + pair.two_zeta * start.V2, start.spent, start.damped
    row[11], row[12], row[13] = errors.late, errors.x, errors.v
    row[14], row[15] = errors.place, errors.w
