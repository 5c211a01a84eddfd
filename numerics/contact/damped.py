"""Where a damped motion ends, certified: the first contact of a slip, and the exit from the sliding region.

With y = s X + r, the guard of a slip is f(tau) = y'(tau) - c - tau, c = s V2 at the start: a damped sinusoid, a line.
The zeros of f'' = y''' are closed-form; between two of them f' is monotone and has at most one zero, which a bracket
encloses; between two zeros of f' the guard is monotone and has at most one root. Nothing is sampled.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.float64 import (
    ZERO,
    fading,
    finite,
    half_turn,
    infinite,
    positive,
    resolved,
    rough,
    sign,
    signed,
    sqrt,
    undefined,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import GRAZES, GUARD_RISES
from numerics.arithmetic.telling import text
from numerics.contact.root import root_of
from numerics.flows.oscillator import Oscillator, acceleration, first_jerk_zero, propagate

MAX_PIECES = 100_000
"""Half oscillations in one slip that are inspected; beyond them the scene is out of range."""
_FLAT = 1e-6


class Guard(NamedTuple):
    """f(tau) = y'(tau) - c - tau from (y, v); `side` turns the sign of f' where that rises."""

    of: Oscillator
    y: Number
    v: Number
    c: Number
    side: float


class Load(NamedTuple):
    """The load (P, P') on the interface at the start of a stick phase, which obeys the stick flow, and the edge."""

    of: Oscillator
    load: Number
    rate: Number
    side: float


@text
def guard_and_slope(at: Guard, tau: Number) -> tuple[Number, Number]:
    """Return f and f'."""
    y, v = propagate(at.of, at.y, at.v, tau)
    return v - at.c - tau, acceleration(at.of, y, v) - 1


@text
def slope_and_curvature(at: Guard, tau: Number) -> tuple[Number, Number]:
    """Return f' and f'', both times `side`."""
    y, v = propagate(at.of, at.y, at.v, tau)
    pull = acceleration(at.of, y, v)
    return signed(at.side, pull - 1), signed(at.side, acceleration(at.of, v, pull))


@text
def room_and_slope(at: Load, tau: Number) -> tuple[Number, Number]:
    """Return 1 - side P and its slope."""
    load, rate = propagate(at.of, at.load, at.rate, tau)
    return 1 - signed(at.side, load), -signed(at.side, rate)


@text
def speed_bound(of: Oscillator, y: Number, v: Number) -> Number:
    """Return a bound of |y'| from now on: y'^2 + stiffness y^2 never grows."""
    return sqrt(v * v + of.stiffness * y * y)


guard_root = root_of(guard_and_slope, "damped_guard_root")
slope_root = root_of(slope_and_curvature, "slope_root")
load_root = root_of(room_and_slope, "load_root")


@text
def first_contact(of: Oscillator, y: Number, v: Number, c: Number, level: bool, rising: bool) -> tuple[Number, float]:
    """Return the first root of the guard after the start, where f > 0, or f = 0 and it is `rising`.

    `level`: f''(0) = 0 exactly. With the root, how far above 0 the guard stayed at the lowest point where it might
    have come down before. Undefined where a number left the range, or there are too many pieces.
    """
    wait, spared = certain_wait(of, y, v, c)
    if not rough(wait) > 0.0:
        return first_fall(of, y, v, c, level, rising)
    if of.regime > 0 and rough(of.decay * wait) < fading() and not resolved(of.frequency * wait):
        return undefined(), 0.0
    y_late, v_late = propagate(of, y, v, wait)
    slope = acceleration(of, y_late, v_late) - 1
    if not finite(slope):
        return undefined(), 0.0
    rest, near = first_fall(of, y_late, v_late, c + wait, False, sign(slope, GUARD_RISES) > 0)
    return wait + rest, min(spared, near)


@text
def certain_wait(of: Oscillator, y: Number, v: Number, c: Number) -> tuple[Number, float]:
    """Return a time up to which f > 0 is certain, 0 if that is a few oscillations only, and a bound of f until then.

    f(tau) >= -speed_bound(t) - c - tau for tau >= t; as the oscillation decays the bound is taken again and again.
    """
    wait, spared = ZERO, math.inf
    for _ in range(60):
        y_then, v_then = propagate(of, y, v, wait)
        left = -c - speed_bound(of, y_then, v_then) - wait
        if rough(left * of.stiffness * left) < 1000.0 or rough(left) <= 0.0:
            break
        spared = min(spared, rough(left / 16))
        wait = wait + 15 * left / 16
    return wait, spared


@text
def first_fall(of: Oscillator, y: Number, v: Number, c: Number, level: bool, rising: bool) -> tuple[Number, float]:
    """Return the first root by visiting the pieces on which f' is monotone, and the lowest minimum before it."""
    at = Guard(of, y, v, c, 1.0)
    left, rose, spared = ZERO, rising, math.inf
    bound, steepest = speed_bound(of, y, v), 2 * of.decay + sqrt(of.stiffness)
    last, calm = bound - c + 1, 1 - steepest * bound  # f < 0 is certain from `last` on, f' < 0 where it is calm
    if not rising and positive(calm):
        return guard_root(at, left, last, (left + last) / 2), spared
    point, count = first_jerk_zero(of, y, v, last, level), 0
    step = half_turn() / of.frequency if of.regime > 0 else infinite()
    while finite(calm) and rough(point) == rough(point) and count <= MAX_PIECES:  # not nan
        is_last = not rough(last - point) > 0.0
        right = last if is_last else point
        value, slope = guard_and_slope(at, right)
        if not (finite(value) and finite(slope)):
            break
        rises = sign(slope, GUARD_RISES) >= 0
        if not (rose and rises):
            lower, upper, value = falling_part(at, left, rose, right, rises, value)
            if sign(value, GRAZES) < 0:
                return guard_root(at, lower, upper, (lower + upper) / 2), spared
            spared = min(spared, rough(value))
        elif rough(slope) <= _FLAT * (1.0 + rough(steepest * bound)):  # it may have come down next to here
            spared = min(spared, max(rough(value), 0.0))
        if is_last:
            break
        point = point + step if of.regime > 0 else step
        left, rose, count = right, rises, count + 1
    return undefined(), 0.0


@text
def falling_part(
    at: Guard, left: Number, rose: bool, right: Number, rises: bool, value: Number
) -> tuple[Number, Number, Number]:
    """Return the part of [left, right], on which f' is monotone, where f falls, and f at its end; value = f(right)."""
    if rose == rises:
        return left, right, value
    of = Guard(at.of, at.y, at.v, at.c, 1.0 if rose else -1.0)
    turn = slope_root(of, left, right, (left + right) / 2)
    if rose:
        return turn, right, value
    return left, turn, guard_and_slope(at, turn)[0]


@text
def exit_root(of: Oscillator, load: Number, rate: Number, side: float, turning: Number) -> Number:
    """Return when the load of a stick phase meets the edge that it passes before it turns."""
    return load_root(Load(of, load, rate, side), ZERO, turning, turning / 2)
