"""The first contact of a viscous slip in binary64, certified (the algorithm: numerics/viscous_contact.py).

The guard is f(tau) = y'(tau) - c - tau from (y, v). What is refused as out of range is nan here.
"""

from __future__ import annotations

import math

from numerics.kernel.compilation import kernel
from numerics.kernel.viscous_oscillator import Oscillator, acceleration, first_jerk_zero, propagate

GUARD, SLOPE, LOAD = 0, 1, 2
"""Functions that roots are found of: f, +-f', and 1 -+ the load of a stick phase."""
_MAX_STEPS = 4000
_TOLERANCE = 2.0**-53
_SETTLED = math.sqrt(_TOLERANCE) / 4
_MAX_PIECES = 100_000
_LOST_PHASE, _SMALLEST_PHASE = 1e12, 1e-97
_DEAD = 37.5
"""An oscillation has died away below the last digit after that many decay times."""
_FLAT = 1e-6


@kernel
def value_and_slope(
    which: int, of: Oscillator, y: float, v: float, c: float, sign: float, tau: float
) -> tuple[float, float]:
    """Return one of the functions above and its derivative at tau."""
    y_end, v_end = propagate(of, y, v, tau)
    if which == LOAD:
        return 1 - sign * y_end, -sign * v_end
    pull = acceleration(of, y_end, v_end)
    if which == GUARD:
        return v_end - c - tau, pull - 1
    return sign * (pull - 1), sign * acceleration(of, v_end, pull)


@kernel
def root(which: int, of: Oscillator, y: float, v: float, c: float, sign: float, lower: float, upper: float) -> float:
    """Return the root of a function that falls: Newton's method in a bracket (arithmetic/newton.py)."""
    x, previous, width = (lower + upper) / 2, upper - lower, upper - lower
    for _ in range(_MAX_STEPS):
        value, slope = value_and_slope(which, of, y, v, c, sign, x)
        if value == 0:
            return x
        if value > 0:
            lower = x
        else:
            upper = x
        step = -value / slope if slope < 0 else previous
        candidate = x + step
        if lower <= candidate <= upper and abs(step) <= previous <= _SETTLED * min(abs(x), width):
            return candidate  # next to a step so small for the piece it is on: right to the last bits, or noise
        if not lower < candidate < upper or abs(step) * 2 > previous:
            candidate = (lower + upper) / 2
            step = candidate - x
        if abs(step) <= _TOLERANCE * abs(candidate) or candidate in (lower, upper):
            return candidate
        x, previous = candidate, abs(step)
    return x


@kernel
def speed_bound(of: Oscillator, y: float, v: float) -> float:
    """Return a bound of |y'| from now on: y'^2 + stiffness y^2 never grows."""
    return math.sqrt(v * v + of.stiffness * y * y)


@kernel
def first_contact(of: Oscillator, y: float, v: float, c: float, level: bool, rising: bool) -> tuple[float, float]:
    """Return the first root of the guard after the start, where f > 0, or f = 0 and it is `rising`.

    With it, how far above 0 the guard stayed at the lowest point where it might have come down before.
    """
    wait, spared = certain_wait(of, y, v, c)
    if not wait > 0.0:
        return first_fall(of, y, v, c, level, rising)
    if of.regime > 0 and of.decay * wait < _DEAD:
        phase = of.frequency * wait
        if phase > _LOST_PHASE or phase < _SMALLEST_PHASE:
            return math.nan, 0.0
    y_late, v_late = propagate(of, y, v, wait)
    slope = acceleration(of, y_late, v_late) - 1
    if not math.isfinite(slope):
        return math.nan, 0.0
    rest, near = first_fall(of, y_late, v_late, c + wait, False, slope > 0.0)
    return wait + rest, min(spared, near)


@kernel
def certain_wait(of: Oscillator, y: float, v: float, c: float) -> tuple[float, float]:
    """Return a time up to which f > 0 is certain, 0 if that is a few oscillations only, and a bound of f until then."""
    wait, spared = 0.0, math.inf
    for _ in range(60):
        y_then, v_then = propagate(of, y, v, wait)
        certain = -c - speed_bound(of, y_then, v_then)
        if (certain - wait) * of.stiffness * (certain - wait) < 1000 or certain - wait <= 0:
            break
        spared = min(spared, (certain - wait) / 16)
        wait = wait + 15 * (certain - wait) / 16
    return wait, spared


@kernel
def first_fall(of: Oscillator, y: float, v: float, c: float, level: bool, rising: bool) -> tuple[float, float]:
    """Return the first root by visiting the pieces on which f' is monotone, and the lowest minimum before it."""
    left, rose, spared = 0.0, rising, math.inf
    bound, steepest = speed_bound(of, y, v), 2 * of.decay + math.sqrt(of.stiffness)
    last = bound - c + 1
    calm = 1 - steepest * bound
    if not rising and not calm <= 0.0:
        return (root(GUARD, of, y, v, c, 1.0, left, last) if math.isfinite(calm) else math.nan), spared
    point = first_jerk_zero(of, y, v, last, level)
    step = math.pi / of.frequency if of.regime > 0 else math.inf
    for _ in range(0 if math.isnan(point) else _MAX_PIECES + 1):
        is_last = not last - point > 0
        right = last if is_last else point
        value, slope = value_and_slope(GUARD, of, y, v, c, 1.0, right)
        rises = slope >= 0.0
        if not (rose and rises):
            lower, upper, value = falling_part(of, y, v, c, left, rose, right, rises, value)
            if value < 0.0 and math.isfinite(slope):
                return root(GUARD, of, y, v, c, 1.0, lower, upper), spared
            spared = min(spared, value)
        elif slope <= _FLAT * (1.0 + steepest * bound):  # it may have come down next to here
            spared = min(spared, max(value, 0.0))
        if is_last or not (math.isfinite(slope) and math.isfinite(value)):
            break
        point = point + step
        left, rose = right, rises
    return math.nan, 0.0


@kernel
def falling_part(
    of: Oscillator, y: float, v: float, c: float, left: float, rose: bool, right: float, rises: bool, value: float
) -> tuple[float, float, float]:
    """Return the part of [left, right], on which f' is monotone, where f falls, and f at its end; value = f(right)."""
    if rose == rises:
        return left, right, value
    turn = root(SLOPE, of, y, v, c, 1.0 if rose else -1.0, left, right)
    if rose:
        return turn, right, value
    return left, turn, value_and_slope(GUARD, of, y, v, c, 1.0, turn)[0]
