"""Stick and slip for a1 > 0. The load P = X + 2 zeta V takes the place of X: the sliding region is |P| <= 1."""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.float64 import (
    ZERO,
    exactly,
    finite,
    nonnegative,
    positive,
    rough,
    sign,
    signed,
    undefined,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import DIED_AWAY, ENDS_INSIDE, EXCEEDS_FRICTION, LEAVES_AT_ONCE
from numerics.arithmetic.telling import text
from numerics.contact.damped import exit_root, first_contact
from numerics.flows.oscillator import Oscillator, first_jerk_zero, integral_of_square, propagate
from numerics.motion.codes import MOVING, OUT_OF_RANGE, STUCK
from numerics.motion.records import At


class Pair(NamedTuple):
    """The reduced parameters, whether v1 = v2 is never left (the law three-valued-sgn), and both oscillators.

    stick: X'' + 2 zeta X' + X = 0;  slip: q y'' + 2 zeta y' + y = 0, the flow of y = X + r s in a slip of sign s.
    """

    q: Number
    r: Number
    two_zeta: Number
    literal: bool
    stick: Oscillator
    slip: Oscillator


class Start(NamedTuple):
    """The start of a mode of motion: -1, 0, +1 is the sign of V1 - V2; tau (with its rounding `rest`) the time.

    `rising` says whether the guard of a slip grows right after the start, `level` that its second derivative (in
    stick: dP/dt) vanishes exactly there, which balls cannot see; `spent` and `damped` are what friction and viscosity
    have taken from E/E_cr so far, sums of positive terms.
    """

    mode: int
    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number
    rising: bool
    level: bool
    tau: Number
    rest: Number
    spent: Number
    damped: Number


class End(NamedTuple):
    """The end of a motion: the side of the exit of a stick phase; how far above 0 the guard of a slip stayed."""

    side: float
    spared: float


class Arrival(NamedTuple):
    """The state at the end of a motion, and its End."""

    at: At
    side: float
    spared: float


@text
def mode_of(start: Start) -> int:
    """Return the sign of V1 - V2 in a motion."""
    return start.mode


@text
def velocity(pair: Pair, start: Start) -> Number:  # noqa: ARG001
    """Return V = V1 = V2 at the start of a motion on the switching surface."""
    return start.V2


@text
def energy_ratio(pair: Pair, X: Number, V1: Number, V2: Number) -> Number:
    """Return E/E_cr."""
    return X * X + pair.q * V1 * V1 + pair.r * V2 * V2


@text
def flow(pair: Pair, start: Start, tau: Number) -> At:
    """Return the state at tau after the start of a motion, and what friction and viscosity have taken until then."""
    if start.mode == 0:
        X, V = propagate(pair.stick, start.X, start.V1, tau)
        pull = -(pair.two_zeta * start.V1 + start.X)
        damped = start.damped + damping(pair.stick, pair.two_zeta, start.V1, pull, tau)
        return At(X, V, V, start.Z, energy_ratio(pair, X, V, V) - 1, start.spent, damped)
    side = float(start.mode)
    y_start, v_start = signed(side, start.X) + pair.r, signed(side, start.V1)
    y, v = propagate(pair.slip, y_start, v_start, tau)
    X, V1, V2 = signed(side, y - pair.r), signed(side, v), start.V2 + signed(side, tau)
    slid = y - y_start - (signed(side, start.V2) + tau / 2) * tau
    pull = -(pair.two_zeta * v_start + y_start) / pair.q
    damped = start.damped + damping(pair.slip, pair.two_zeta, v_start, pull, tau)
    spent, Z = start.spent + nonnegative(2 * pair.r * slid), start.Z + signed(side, slid)
    return At(X, V1, V2, Z, energy_ratio(pair, X, V1, V2) - 1, spent, damped)


@text
def damping(of: Oscillator, two_zeta: Number, v: Number, pull: Number, tau: Number) -> Number:
    """Return what viscosity takes in one motion, 4 zeta int V1^2."""
    return nonnegative(2 * two_zeta * integral_of_square(of, v, pull, tau))


@text
def locate(pair: Pair, start: Start) -> tuple[int, Number, End]:
    """Return (how it goes on, duration, end) of a motion: MOVING until its event, STUCK, or OUT_OF_RANGE."""
    if start.mode == 0:
        return locate_exit(pair, start)
    side = float(start.mode)
    y, v, c = signed(side, start.X) + pair.r, signed(side, start.V1), signed(side, start.V2)
    tau, spared = first_contact(pair.slip, y, v, c, start.level, start.rising)
    return (MOVING if finite(tau) else OUT_OF_RANGE), tau, End(0.0, spared)


@text
def locate_exit(pair: Pair, start: Start) -> tuple[int, Number, End]:
    """Return (MOVING, time, side) of the exit from |P| <= 1; STUCK if there is none, OUT_OF_RANGE.

    P obeys the same damped equation, so its first extremum is its largest: if that stays inside, all do.
    """
    nowhere = End(0.0, 0.0)
    if pair.literal:
        return STUCK, ZERO, nowhere
    stick, load = pair.stick, start.X + pair.two_zeta * start.V1
    rate = 0 * load if start.level else start.V1 - pair.two_zeta * load
    inside = 1 - load * load - rate * rate  # P^2 + P'^2 never grows
    if positive(inside) or not finite(inside):
        return (STUCK if finite(inside) else OUT_OF_RANGE), ZERO, nowhere
    # by then the load has died away, which is proved below
    late = (64 + load * load + rate * rate) / (stick.slow if stick.regime < 0 else stick.decay)
    turning = first_jerk_zero(stick, start.X, start.V1, late, start.level)  # P = -X'': the load turns there
    if not rough(turning) < math.inf:
        left, speed = propagate(stick, load, rate, late)
        rest = 1 - left * left - speed * speed
        proved = rough(turning) > 0.0 and finite(rest) and sign(rest, DIED_AWAY) >= -1
        return (STUCK if proved else OUT_OF_RANGE), ZERO, nowhere
    extremum, _ = propagate(stick, load, rate, turning)
    side = 1.0 if rough(extremum) > 0.0 else -1.0
    beyond = signed(side, extremum) - 1
    if not finite(beyond):
        return OUT_OF_RANGE, ZERO, nowhere
    if sign(beyond, EXCEEDS_FRICTION) <= 0:
        return STUCK, ZERO, nowhere
    return MOVING, exit_root(stick, load, rate, side, turning), End(side, 0.0)


@text
def arrive(pair: Pair, start: Start, end: End, duration: Number) -> Arrival:
    """Return the state at the end of a motion, not snapped yet."""
    return Arrival(flow(pair, start, duration), end.side, end.spared)


@text
def follow(pair: Pair, start: Start, here: Arrival, duration: Number, tau: Number, rest: Number) -> Start:  # noqa: ARG001
    """Return the start of the motion that follows at time tau, the state snapped to what it is exactly."""
    if start.mode == 0:
        return leave(pair, here.at, here.side, tau, rest)
    return land(pair, start, here.at, tau, rest)


@text
def leave(pair: Pair, here: At, side: float, tau: Number, rest: Number) -> Start:
    """Return the slip that starts on the edge P = side, which X is snapped to exactly."""
    X = exactly(side) - pair.two_zeta * here.V1
    return Start(-int(side), X, here.V1, here.V2, here.Z, here.w, True, False, tau, rest, here.spent, here.damped)


@text
def land(pair: Pair, start: Start, here: At, tau: Number, rest: Number) -> Start:
    """Return the start of the motion after a slip, V1 = V2: stick, or the slip of the other sign (modes.py)."""
    side, V, following = float(start.mode), here.V2, 0
    load = here.X + pair.two_zeta * V
    beyond = signed(side, load) - 1
    if not pair.literal:
        outside = sign(beyond, ENDS_INSIDE) if finite(beyond) else 0
        if outside == 0:
            outside = sign(signed(side, V - pair.two_zeta * load), LEAVES_AT_ONCE) if finite(beyond) else 0
        following = -start.mode if outside > 0 else 0
    w = here.w if pair.literal or finite(beyond) else undefined()
    return Start(following, here.X, V, V, here.Z, w, True, False, tau, rest, here.spent, here.damped)
