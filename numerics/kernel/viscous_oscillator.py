"""The damped harmonic oscillator of oscillator.py in binary64: the same operations in the same order, and their errors.

None is inf here, and what oscillator.py refuses as out of range is nan.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.kernel.bounds import ULP
from numerics.kernel.compilation import kernel


class Oscillator(NamedTuple):
    """y'' + 2 decay y' + stiffness y = 0; regime = sign of stiffness - decay^2, frequency^2 = |stiffness - decay^2|.

    `slow` and `fast` are the rates decay -+ frequency of the overdamped regime.
    """

    decay: float
    stiffness: float
    regime: int
    frequency: float
    slow: float
    fast: float


@kernel
def oscillator(decay: float, stiffness: float, regime: int, frequency: float) -> Oscillator:
    """Return the oscillator with these constants."""
    fast = decay + frequency
    return Oscillator(decay, stiffness, regime, frequency, stiffness / fast, fast)


@kernel
def basis(of: Oscillator, t: float) -> tuple[float, float]:
    """Return e^(-dt) (cos nt, sin(nt)/n), their limits (1, t), or cosh and sinh instead."""
    if of.regime > 0:
        envelope = math.exp(-of.decay * t)
        return envelope * math.cos(of.frequency * t), envelope * math.sin(of.frequency * t) / of.frequency
    if of.regime == 0:
        envelope = math.exp(-of.decay * t)
        return envelope, envelope * t
    slow = math.exp(-of.slow * t)
    drop = -math.expm1(-2 * of.frequency * t)
    return slow * (2 - drop) / 2, slow * drop / (2 * of.frequency)


@kernel
def propagate(of: Oscillator, y: float, v: float, t: float) -> tuple[float, float]:
    """Return (y, y') after time t from (y, v)."""
    if of.regime < 0 and of.frequency * t > 1:
        first = (v + of.fast * y) / (2 * of.frequency) * math.exp(-of.slow * t)
        second = -(v + of.slow * y) / (2 * of.frequency) * math.exp(-of.fast * t)
        return first + second, -of.slow * first - of.fast * second
    cosine, sine = basis(of, t)
    return y * cosine + (v + of.decay * y) * sine, v * cosine - (of.decay * v + of.stiffness * y) * sine


@kernel
def acceleration(of: Oscillator, y: float, v: float) -> float:
    """Return y''; the same linear map takes (y', y'') to y'''."""
    return -(2 * of.decay * v + of.stiffness * y)


@kernel
def first_zero(of: Oscillator, y: float, v: float, horizon: float) -> float:
    """Return the first t > 0 with y = 0, not overdamped; inf if there is none (up to the horizon)."""
    lean = v + of.decay * y
    if not math.isfinite(y):
        return math.nan
    side = 1.0 if y > 0.0 else -1.0
    if of.regime > 0:
        return (math.atan2(side * y * of.frequency, -side * lean) if y != 0.0 else math.pi) / of.frequency
    reach = lean * horizon
    larger = y * y - reach * reach
    if not (math.isfinite(larger) and math.isfinite(lean)):
        return math.nan
    if larger > 0.0 or y == 0.0 or not -side * lean > 0.0:
        return math.inf
    return -y / lean


@kernel
def log_quotient(base: float, other: float, excess: float) -> float:
    """Return log(other/base), other = base + excess."""
    ratio = excess / base
    if ratio > -0.5:
        return math.log1p(ratio)
    quotient = other / base
    return math.log(quotient) if quotient > 0.0 else math.nan


@kernel
def first_jerk_zero(of: Oscillator, y: float, v: float, horizon: float, level: bool) -> float:
    """Return the first t in (0, horizon] with y''' = 0, or a later one, or inf; `level`: it is 0 exactly at t = 0."""
    if of.regime >= 0:
        pull = acceleration(of, y, v)
        jerk = 0.0 if level else acceleration(of, v, pull)
        return first_zero(of, jerk, acceleration(of, pull, jerk), horizon)
    return math.inf if level else overdamped_jerk_zero(of, y, v, horizon)


@kernel
def overdamped_jerk_zero(of: Oscillator, y: float, v: float, horizon: float) -> float:
    """Return first_jerk_zero from the two exponentials."""
    ratio = of.fast / of.slow
    slow_part, fast_part = v + of.fast * y, v + of.slow * y
    faded = ratio * ratio * ratio * fast_part * math.exp(-2 * of.frequency * horizon)
    larger = faded * faded - slow_part * slow_part
    if not (math.isfinite(larger) and math.isfinite(slow_part)):
        return math.nan
    if larger > 0.0 or slow_part == 0.0:
        return math.inf
    excess = (1.0 if slow_part > 0.0 else -1.0) * (ratio * ratio * ratio * fast_part - slow_part)
    if not math.isfinite(excess):
        return math.nan
    if excess <= 0.0:
        return math.inf
    twice = 2 * of.frequency
    logarithms = 3 * log_quotient(of.slow, of.fast, twice) + log_quotient(slow_part, fast_part, -twice * y)
    return logarithms / twice


@kernel
def in_exponentials(of: Oscillator) -> bool:
    """Return whether damping is so far above critical that squares are integrated by exponentials."""
    return of.regime < 0 and 2 * of.frequency - of.decay > 0


@kernel
def faded(rate: float, t: float) -> float:
    """Return the integral of e^(-rate s) over 0 <= s <= t."""
    return -math.expm1(-rate * t) / rate


@kernel
def integral_of_square(of: Oscillator, y: float, v: float, t: float) -> float:
    """Return the integral of y(s)^2 over 0 <= s <= t for the solution from (y, v)."""
    if in_exponentials(of):
        c1, c2 = (v + of.fast * y) / (2 * of.frequency), -(v + of.slow * y) / (2 * of.frequency)
        mixed = c1 * c1 * faded(2 * of.slow, t) + 2 * c1 * c2 * faded(of.slow + of.fast, t)
        return mixed + c2 * c2 * faded(2 * of.fast, t)
    y_end, v_end = propagate(of, y, v, t)
    k, d = of.stiffness, of.decay
    square_rate = (v * v - v_end * v_end + k * (y * y - y_end * y_end)) / (4 * d)
    return (square_rate + (y * v - y_end * v_end) + d * (y * y - y_end * y_end)) / k


@kernel
def rounding(of: Oscillator, y: float, v: float, t: float) -> tuple[float, float]:
    """Return bounds on the errors of propagate, those of the constants (up to 3.5 u each) included.

    e^(-rate t) errs by u times rate t, sin and cos of n t by u times n t, each times what they are multiplied with.
    """
    d, k, n = of.decay, of.stiffness, of.frequency
    lean, pull = abs(v) + d * abs(y), d * abs(v) + k * abs(y)
    if of.regime < 0:
        if n * t > 1.0:
            slow, fast = math.exp(-of.slow * t), math.exp(-of.fast * t)
            first = (abs(v) + of.fast * abs(y)) / (2.0 * n) * slow * (14.0 + 9.0 * of.slow * t)
            second = (abs(v) + of.slow * abs(y)) / (2.0 * n) * fast * (14.0 + 7.0 * of.fast * t)
            return ULP * (first + second), ULP * (1.7 * (of.slow * first + of.fast * second))
        slow = math.exp(-of.slow * t)
        weight = ULP * slow * (14.0 + 9.0 * of.slow * t)
        return weight * (abs(y) + lean * t), weight * (abs(v) + pull * t)
    envelope = ULP * math.exp(-d * t)
    size, phase = 7.0 + 5.0 * d * t, n * t
    if phase <= 1.0:
        size += 5.0 * phase
        return envelope * size * (abs(y) + lean * t), envelope * size * (abs(v) + pull * t)
    size += 5.0 * phase
    return envelope * size * (abs(y) + lean / n), envelope * size * (abs(v) + pull / n)


@kernel
def rounding_of_integral(of: Oscillator, y: float, v: float, v_size: float, t: float) -> float:
    """Return a bound on the error of integral_of_square, where v itself is a sum of terms up to v_size in all."""
    d, k, n = of.decay, of.stiffness, of.frequency
    if in_exponentials(of):
        c1, c2 = (v_size + of.fast * abs(y)) / (2.0 * n), (v_size + of.slow * abs(y)) / (2.0 * n)
        mixed = c1 * c1 * faded(2.0 * of.slow, t) + 2.0 * c1 * c2 * faded(of.slow + of.fast, t)
        return 40.0 * ULP * (mixed + c2 * c2 * faded(2.0 * of.fast, t))
    y_end, v_end = propagate(of, y, v, t)
    y_error, v_error = rounding(of, y, v_size, t)
    y_end, v_end = abs(y_end), abs(v_end)
    by_rate = 8.0 * ULP * (v_size * v_size + k * y * y) + 2.0 * (v_end * v_error + k * y_end * y_error)
    own = 8.0 * ULP * (abs(y) * v_size + d * y * y) + y_end * v_error + v_end * y_error + 2.0 * d * y_end * y_error
    return (by_rate / (4.0 * d) + own) / k
