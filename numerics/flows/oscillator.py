"""The damped harmonic oscillator y'' + 2 d y' + k y = 0 in its three regimes, free of cancellation at their borders.

Which regime holds is decided on exact rationals by the caller; near the border both neighbours stay accurate, since
sin(n t)/n and (1 - e^(-2 n t))/(2 n) are formed whole (n^2 = |k - d^2|).
"""

from __future__ import annotations

from typing import NamedTuple

from numerics.arithmetic.float64 import (
    atan2,
    exp,
    expm1,
    finite,
    half_turn,
    infinite,
    log,
    log1p,
    positive,
    rough,
    sign,
    signed,
    sine_cosine,
    undefined,
)
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import HAS_SLOW_PART, HEADS_FOR_ZERO, SIDE_OF_ZERO, TURNS_LATER
from numerics.arithmetic.telling import text

_NEAR_CRITICAL = 2.0**-20
"""Below this 2 n over the slow rate, the rates of both exponentials are told apart by their difference only."""


class Oscillator(NamedTuple):
    """y'' + 2 decay y' + stiffness y = 0; regime = sign of stiffness - decay^2, frequency^2 = |stiffness - decay^2|.

    `slow` and `fast` are the rates decay -+ frequency of the overdamped regime; slow = stiffness/fast does not cancel.
    """

    decay: Number
    stiffness: Number
    regime: int
    frequency: Number
    slow: Number
    fast: Number


@text
def oscillator(decay: Number, stiffness: Number, regime: int, frequency: Number) -> Oscillator:
    """Return the oscillator with these constants."""
    fast = decay + frequency
    return Oscillator(decay, stiffness, regime, frequency, stiffness / fast, fast)


@text
def smooth_in_damping(of: Oscillator, t: Number, found: tuple[Number, Number]) -> tuple[Number, Number]:  # noqa: ARG001
    """Return what `basis` found; over dual numbers its gradients are replaced (sensitivity/gradients.py)."""
    return found


@text
def basis(of: Oscillator, t: Number) -> tuple[Number, Number]:
    """Return e^(-dt) (cos nt, sin(nt)/n), their limits (1, t), or cosh and sinh instead."""
    if of.regime > 0:
        envelope = exp(-of.decay * t)
        sine, cosine = sine_cosine(of.frequency * t)
        return smooth_in_damping(of, t, (envelope * cosine, envelope * sine / of.frequency))
    if of.regime == 0:
        envelope = exp(-of.decay * t)
        return smooth_in_damping(of, t, (envelope, envelope * t))
    slow = exp(-of.slow * t)
    drop = -expm1(-2 * of.frequency * t)
    return smooth_in_damping(of, t, (slow * (2 - drop) / 2, slow * drop / (2 * of.frequency)))


@text
def propagate(of: Oscillator, y: Number, v: Number, t: Number) -> tuple[Number, Number]:
    """Return (y, y') after time t from (y, v)."""
    if of.regime < 0 and rough(of.frequency * t) > 1.0:
        first = (v + of.fast * y) / (2 * of.frequency) * exp(-of.slow * t)
        second = -(v + of.slow * y) / (2 * of.frequency) * exp(-of.fast * t)
        return first + second, -of.slow * first - of.fast * second
    cosine, sine = basis(of, t)
    return y * cosine + (v + of.decay * y) * sine, v * cosine - (of.decay * v + of.stiffness * y) * sine


@text
def acceleration(of: Oscillator, y: Number, v: Number) -> Number:
    """Return y''; the same linear map takes (y', y'') to y'''."""
    return -(2 * of.decay * v + of.stiffness * y)


@text
def smaller(x: Number, y: Number) -> bool:
    """Return whether |x| < |y| is certain."""
    return positive(y * y - x * x)


@text
def first_zero(of: Oscillator, y: Number, v: Number, horizon: Number) -> Number:
    """Return the first t > 0 with y = 0, not overdamped; infinite if there is none up to the horizon.

    The horizon settles starts on an eigenline, whose zero at infinity balls cannot tell from one that is very late.
    """
    if not (finite(y) and finite(v)):
        return undefined()
    lean = v + of.decay * y
    if of.regime > 0:
        side = sign(y, SIDE_OF_ZERO)
        if side == 0:
            return half_turn() / of.frequency
        return atan2(signed(side, y) * of.frequency, -signed(side, lean)) / of.frequency
    if smaller(lean * horizon, y):
        return infinite()
    side = sign(y, SIDE_OF_ZERO)
    if side == 0 or sign(-signed(side, lean), HEADS_FOR_ZERO) <= 0:
        return infinite()
    return -y / lean


@text
def log_quotient(base: Number, other: Number, excess: Number) -> Number:
    """Return log(other/base), other = base + excess; next to critical damping the quotient would round to 1.

    The logarithm of 1 + ratio takes over no more than twice the relative error of a ratio > -1/2.
    """
    ratio = excess / base
    if rough(ratio) > -0.5:
        return log1p(ratio)
    quotient = other / base
    return log(quotient) if rough(quotient) > 0.0 else undefined()


@text
def first_jerk_zero(of: Oscillator, y: Number, v: Number, horizon: Number, level: bool) -> Number:
    """Return the first t in (0, horizon] with y''' = 0, or a later one, or infinity; `level`: it is 0 exactly at t = 0.

    It obeys the same equation; its overdamped zero is taken from the two exponentials of y, since far above critical
    damping the slow one cancels in the derivatives at 0.
    """
    if of.regime >= 0:
        pull = acceleration(of, y, v)
        jerk = 0 * pull if level else acceleration(of, v, pull)
        return first_zero(of, jerk, acceleration(of, pull, jerk), horizon)
    return infinite() if level else overdamped_jerk_zero(of, y, v, horizon)


@text
def overdamped_jerk_zero(of: Oscillator, y: Number, v: Number, horizon: Number) -> Number:
    """Return first_jerk_zero from the two exponentials: where e^(2 n t) slow_part = ratio^3 fast_part."""
    ratio, twice = of.fast / of.slow, 2 * of.frequency
    slow_part, fast_part = v + of.fast * y, v + of.slow * y
    near = twice / of.slow  # ratio - 1
    is_near = rough(near) < _NEAR_CRITICAL
    # as n -> 0 both parts and the ratio tend to one number: what they differ by is formed instead
    growth, part, kept = near * (3 + near * (3 + near)), -twice * y, exp(-twice * horizon)
    if is_near:
        slow_side, fast_side = slow_part * (growth * kept - expm1(-twice * horizon)), part * kept
    else:
        slow_side, fast_side = slow_part, ratio * ratio * ratio * fast_part * kept
    if not (finite(fast_side * fast_side) and finite(slow_part * slow_part)):
        return undefined()
    if smaller(slow_side, fast_side):
        return infinite()  # the slow part is too small, or exactly 0, to take over before the horizon
    side = sign(slow_part, HAS_SLOW_PART)
    if side == 0:
        return infinite()
    # a fast part that has died away has no sign, but it is proved to be too small
    beyond = growth * fast_part + part if is_near else ratio * ratio * ratio * fast_part - slow_part
    excess = signed(side, beyond)
    if not finite(excess):
        return undefined()
    if sign(excess, TURNS_LATER) <= 0:
        return infinite()
    logarithms = 3 * log_quotient(of.slow, of.fast, twice) + log_quotient(slow_part, fast_part, -twice * y)
    return logarithms / twice


@text
def in_exponentials(of: Oscillator) -> bool:
    """Return whether damping is so far above critical that squares are integrated by exponentials."""
    return of.regime < 0 and rough(2 * of.frequency - of.decay) > 0.0


@text
def faded(rate: Number, t: Number) -> Number:
    """Return the integral of e^(-rate s) over 0 <= s <= t."""
    return -expm1(-rate * t) / rate


@text
def integral_of_square(of: Oscillator, y: Number, v: Number, t: Number) -> Number:
    """Return the integral of y(s)^2 over 0 <= s <= t for the solution from (y, v).

    From the end values: (y'^2 + k y^2)' = -4 d y'^2 gives the integral of y'^2, then (y y' + d y^2)' = y'^2 - k y^2
    that of y^2. The absolute rounding error is a few ulp of (y^2 + y'^2/k)/d, which is too much where damping is
    far above critical: there the squares of the two exponentials are integrated.
    """
    if in_exponentials(of):
        c1, c2 = (v + of.fast * y) / (2 * of.frequency), -(v + of.slow * y) / (2 * of.frequency)
        mixed = c1 * c1 * faded(2 * of.slow, t) + 2 * c1 * c2 * faded(of.slow + of.fast, t)
        return mixed + c2 * c2 * faded(2 * of.fast, t)
    y_end, v_end = propagate(of, y, v, t)
    k, d = of.stiffness, of.decay
    square_rate = (v * v - v_end * v_end + k * (y * y - y_end * y_end)) / (4 * d)
    return (square_rate + (y * v - y_end * v_end) + d * (y * y - y_end * y_end)) / k
