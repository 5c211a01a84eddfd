"""How far rounding can have moved a viscous trajectory: bounds carried from event to event.

The flow contracts the energy norm |z|^2 = X^2 + q V1^2 + r V2^2, damping or not. So the distance from the true
trajectory at a fixed time is at most the sum of the roundings so far, of what was snapped, and of nothing else; in
stick, where both obey one linear equation, it shrinks with its solutions. An event is off by that distance over the
rate at which its guard passes zero; where the guard may not pass zero at all, the sequence of events is uncertain.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.arithmetic.float64 import UNIT
from numerics.arithmetic.telling import text
from numerics.bounds.records import UNDERFLOW
from numerics.bounds.undamped_steps import passing
from numerics.flows.oscillator import Oscillator, basis, faded, in_exponentials, propagate


class Errors(NamedTuple):
    """Bounds on the errors at the start of a mode of motion.

    `late` is that of its time, infinite where even the sequence is uncertain, `norm` the distance of the states at a
    fixed time; `x`, `v`, `place` (Z) and `w` hold for the state at the event itself; `slide` is the error of the sum of
    |dZ| over all slips, `damped` of what viscosity took.
    """

    late: float
    norm: float
    x: float
    v: float
    place: float
    w: float
    slide: float
    damped: float


@text
def lost() -> Errors:
    """Return the errors of a trajectory of which not even the next mode is certain."""
    return Errors(math.inf, math.inf, math.inf, math.inf, math.inf, math.inf, math.inf, math.inf)


@text
def initial_errors(q: float, r: float, X: float, V1: float, V2: float, Z: float, w: float) -> Errors:
    """Return the errors of a start whose numbers are exact rationals, rounded."""
    norm = 4.0 * UNIT * (abs(X) + math.sqrt(q) * abs(V1) + math.sqrt(r) * abs(V2)) + UNDERFLOW
    x, v = UNIT * abs(X), 4.0 * UNIT * max(abs(V1), abs(V2))
    return Errors(0.0, norm, x, v, 2.0 * UNIT * abs(Z), 2.0 * UNIT * abs(w), 0.0, 0.0)


@text
def late_by(error: float, rate: float, bend: float, decay: float) -> float:
    """Return by how much a guard that is off by `error` and passes 0 at this rate is early or late.

    `bend` bounds its second derivative afterwards; before, that was larger by e^(2 decay) per unit of time at most.
    """
    late = passing(error, rate, 2.0 * bend)
    if 4.0 * decay * late <= 0.6:
        return late
    if not decay * late < 100.0:
        return math.inf
    again = passing(error, rate, bend * math.exp(6.0 * decay * late))
    return again if again <= 1.5 * late else math.inf


@text
def reach(q: float, r: float, norm: float) -> float:
    """Return a bound of |V1 - V2| for a state with this energy norm."""
    return norm * math.sqrt(1.0 / q + 1.0 / r)


@text
def stick_map(stick: Oscillator, tau: float) -> tuple[float, float, float]:
    """Return C + zeta S, S and C - zeta S of (X, V) -> ((C + zeta S) X + S V, (C - zeta S) V - S X)."""
    cosine, sine = basis(stick, tau)
    return cosine + stick.decay * sine, sine, cosine - stick.decay * sine


@text
def shrunk(stick: Oscillator, errors: Errors, tau: float) -> float:
    """Return the bound on the norm after a stick phase, its own rounding apart."""
    if not stick.decay * errors.late < 1e-3:
        return errors.norm
    whole, sine, rest = stick_map(stick, tau)
    size = math.sqrt(whole * whole + rest * rest + 2.0 * sine * sine)
    return errors.norm * min(1.0, 1.01 * size + 1e-13)


@text
def slip_spread(slip: Oscillator, q: float, errors: Errors, tau: float) -> tuple[float, float]:
    """Return bounds on what the errors at the start of a slip make of X and V1 at tau: its linear map of both."""
    norm, sqrt_q = errors.norm, math.sqrt(q)
    if not slip.decay * errors.late < 1e-3:
        return norm, norm / sqrt_q
    cosine, sine = basis(slip, tau)
    whole, rest = cosine + slip.decay * sine, cosine - slip.decay * sine
    by_x, by_v = 1.01 * math.sqrt(whole * whole + sine * sine / q), 1.01 * math.sqrt(rest * rest + sine * sine / q)
    return norm * min(1.0, by_x + 1e-13), norm * min(1.0, by_v + 1e-13) / sqrt_q


@text
def load_error(stick: Oscillator, norm: float, tau: float) -> float:
    """Return a bound on the error of the load P = X + 2 zeta V, tau after a stick phase began with this norm."""
    _, sine, rest = stick_map(stick, tau)
    zeta = stick.decay
    by_velocity = sine + 2.0 * zeta * rest
    return norm * (math.sqrt(rest * rest + by_velocity * by_velocity) + 1e-14 * (1.0 + zeta))


@text
def excess_error(size: float, norm: float, ratio: float) -> float:
    """Return a bound on the error of w = |z|^2 - 1 for a state of this size whose norm is off by `norm`."""
    return (2.0 * size + norm) * norm + 6.0 * UNIT * (ratio + 1.0)


@text
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
            return UNIT * (first + second), UNIT * (1.7 * (of.slow * first + of.fast * second))
        slow = math.exp(-of.slow * t)
        weight = UNIT * slow * (14.0 + 9.0 * of.slow * t)
        return weight * (abs(y) + lean * t), weight * (abs(v) + pull * t)
    envelope = UNIT * math.exp(-d * t)
    size, phase = 7.0 + 5.0 * d * t, n * t
    if phase <= 1.0:
        size += 5.0 * phase
        return envelope * size * (abs(y) + lean * t), envelope * size * (abs(v) + pull * t)
    size += 5.0 * phase
    return envelope * size * (abs(y) + lean / n), envelope * size * (abs(v) + pull / n)


@text
def rounding_of_integral(of: Oscillator, y: float, v: float, v_size: float, t: float) -> float:
    """Return a bound on the error of integral_of_square, where v itself is a sum of terms up to v_size in all."""
    d, k, n = of.decay, of.stiffness, of.frequency
    if in_exponentials(of):
        c1, c2 = (v_size + of.fast * abs(y)) / (2.0 * n), (v_size + of.slow * abs(y)) / (2.0 * n)
        mixed = c1 * c1 * faded(2.0 * of.slow, t) + 2.0 * c1 * c2 * faded(of.slow + of.fast, t)
        return 40.0 * UNIT * (mixed + c2 * c2 * faded(2.0 * of.fast, t))
    y_end, v_end = propagate(of, y, v, t)
    y_error, v_error = rounding(of, y, v_size, t)
    y_end, v_end = abs(y_end), abs(v_end)
    by_rate = 8.0 * UNIT * (v_size * v_size + k * y * y) + 2.0 * (v_end * v_error + k * y_end * y_error)
    own = 8.0 * UNIT * (abs(y) * v_size + d * y * y) + y_end * v_error + v_end * y_error + 2.0 * d * y_end * y_error
    return (by_rate / (4.0 * d) + own) / k
