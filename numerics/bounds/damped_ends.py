"""The error bounds at the end of a viscous slip, of a stick phase, and of a stick phase that never ends."""

from __future__ import annotations

import math

from numerics.arithmetic.float64 import UNIT
from numerics.arithmetic.telling import text
from numerics.bounds.damped_steps import (
    Errors,
    excess_error,
    late_by,
    load_error,
    lost,
    reach,
    rounding,
    rounding_of_integral,
    shrunk,
    slip_spread,
)
from numerics.bounds.records import UNDERFLOW
from numerics.flows.oscillator import acceleration, first_jerk_zero, propagate
from numerics.motion.damped import Pair, Start
from numerics.motion.records import At


@text
def energy_size(pair: Pair, X: float, V1: float, V2: float) -> float:
    """Return the energy norm of a state."""
    return math.sqrt(X * X + pair.q * V1 * V1 + pair.r * V2 * V2)


@text
def slip_rounding(pair: Pair, start: Start, at: At, tau: float) -> tuple[float, float, float]:
    """Return bounds on what one slip adds to the errors of X, V1 and V2."""
    y, v = abs(float(start.mode) * start.X + pair.r), abs(start.V1)
    x_error, v_error = rounding(pair.slip, y, v, tau)
    x_error += UNIT * (2.0 * abs(start.X) + 3.0 * pair.r + abs(at.X)) + UNDERFLOW
    return x_error, v_error + UNDERFLOW, UNIT * abs(at.V2)


@text
def slide_error(pair: Pair, start: Start, at: At, norm: float, x_error: float, time: float) -> float:
    """Return a bound on the error of |dZ| in one slip: the distance of V1 - V2 times its duration, and rounding."""
    driven = (abs(start.V2) + time) * time
    return reach(pair.q, pair.r, norm) * time + x_error + UNIT * (2.0 * abs(at.X) + abs(start.X) + 4.0 * driven)


@text
def damped_error(pair: Pair, start: Start, taken: float, norm: float, tau: float) -> float:
    """Return a bound on the error of what viscosity took in one mode: 4 zeta int dV1^2 <= norm^2, and rounding."""
    if start.mode == 0:
        of, y, mass = pair.stick, start.X, 1.0
    else:
        of, y, mass = pair.slip, float(start.mode) * start.X + pair.r, pair.q
    v = abs(start.V1)
    pull = -(pair.two_zeta * (start.V1 if start.mode >= 0 else -start.V1) + y) / mass
    side = 1.0 if start.V1 * (start.mode if start.mode != 0 else 1) >= 0.0 else -1.0
    own = max(rounding_of_integral(of, v, side * pull, (pair.two_zeta * v + abs(y)) / mass, tau), 0.0)
    return norm * (2.0 * math.sqrt(max(taken, 0.0) + 2.0 * pair.two_zeta * own) + norm) + 2.0 * pair.two_zeta * own


@text
def after_slip(pair: Pair, start: Start, errors: Errors, at: At, spared: float, following: Start, tau: float) -> Errors:
    """Return the errors at the end of a slip, lost where it is not certain that it ends so."""
    q, r, slip, sign = pair.q, pair.r, pair.slip, float(start.mode)
    sqrt_q, sqrt_r = math.sqrt(q), math.sqrt(r)
    x_own, v_own, driven_own = slip_rounding(pair, start, at, tau)
    snapped = 2.0 * abs(at.V1 - at.V2)
    norm = errors.norm + x_own + sqrt_q * (v_own + snapped) + sqrt_r * driven_own
    y, v = sign * at.X + r, sign * at.V1
    pull = acceleration(slip, y, v)
    jerk = acceleration(slip, v, pull)
    bend = abs(jerk) + math.sqrt(slip.stiffness) * abs(pull)
    by_x, by_v = slip_spread(slip, q, errors, tau)
    by_x, by_v, by_driven = by_x + x_own, by_v + v_own, errors.norm / sqrt_r + driven_own
    error = min(reach(q, r, norm), by_v + by_driven + snapped)
    late = late_by(error, 1.0 - pull, bend, slip.decay) if pull < 1.0 else math.inf
    if not 2.0 * error < spared:
        late = math.inf
    V = following.V2
    x = min(norm, by_x) + late * (abs(V) + late * abs(pull))
    velocity = min(by_driven + late, by_v + snapped + late * (abs(pull) + late * bend))
    load = at.X + pair.two_zeta * V
    load_off = x + pair.two_zeta * velocity + 2.0 * UNIT * (abs(at.X) + pair.two_zeta * abs(V))
    if not pair.literal and not abs(sign * load - 1.0) > load_off:
        late = math.inf
    if not math.isfinite(late):
        return lost()
    slide = slide_error(pair, start, at, norm, x_own, tau + errors.late + late)
    damped = damped_error(pair, start, at.damped - start.damped, norm, tau)
    size = energy_size(pair, at.X, V, V)
    w = excess_error(size, norm, size * size) + late * 2.0 * pair.two_zeta * V * V
    w += q * snapped * (abs(V) + snapped)  # w is that of the state before it is snapped
    if pair.literal:  # the law that never lets go is no contraction: both trajectories stick at different times
        norm += late * (sqrt_q * abs(sign * pull + load) + sqrt_r * abs(sign + load))
    return Errors(
        late + 2.0 * UNIT * following.tau,
        norm,
        x,
        velocity,
        errors.place + slide + UNIT * (abs(start.Z) + 2.0 * abs(at.Z)),
        w,
        errors.slide + slide,
        errors.damped + damped,
    )


@text
def after_stick(pair: Pair, start: Start, errors: Errors, at: At, following: Start, tau: float) -> Errors:
    """Return the errors where a stick phase leaves the sliding region, lost where it is not certain that it does."""
    stick, side = pair.stick, -float(following.mode)
    x_own, v_own = rounding(stick, start.X, start.V1, tau)
    snapped = abs(at.X - following.X)
    norm = shrunk(stick, errors, tau) + x_own + v_own + snapped + UNDERFLOW
    load_off = load_error(stick, errors.norm, tau) + x_own + pair.two_zeta * v_own + snapped
    load_off = min(load_off, norm * math.sqrt(1.0 + pair.two_zeta * pair.two_zeta))
    V = following.V2
    rate = side * (V - pair.two_zeta * side)
    bend = abs(side + pair.two_zeta * rate) + abs(rate)
    late = late_by(load_off, rate, bend, stick.decay) if rate > 0.0 else math.inf
    if not math.isfinite(late):
        return lost()
    velocity = norm + late * (1.0 + late * (abs(rate) + 1.0))
    x = min(norm + late * (abs(V) + late), pair.two_zeta * velocity)
    x += UNIT * (abs(following.X) + 2.0 * pair.two_zeta * abs(V))
    damped = damped_error(pair, start, at.damped - start.damped, norm, tau)
    size = energy_size(pair, at.X, V, V)
    w = excess_error(size, norm, size * size) + late * 2.0 * pair.two_zeta * V * V
    place = errors.place + UNIT * abs(at.Z)
    return Errors(late + 2.0 * UNIT * following.tau, norm, x, velocity, place, w, errors.slide, errors.damped + damped)


@text
def stays(pair: Pair, start: Start, errors: Errors) -> bool:
    """Return whether it is certain that a stick phase in which no exit was found has none."""
    if pair.literal:
        return True
    stick, norm, two_zeta = pair.stick, errors.norm, pair.two_zeta
    load = start.X + two_zeta * start.V1
    rate = 0.0 if start.level else start.V1 - two_zeta * load
    load_off = norm * math.sqrt(1.0 + two_zeta * two_zeta) + 2.0 * UNIT * (abs(start.X) + two_zeta * abs(start.V1))
    rate_off = norm * (two_zeta + abs(1.0 - two_zeta * two_zeta)) + two_zeta * load_off
    if 1.0 - load * load - rate * rate > 2.0 * (abs(load) * load_off + abs(rate) * rate_off) + rate_off * rate_off:
        return True
    if abs(load) >= 1.0 - load_off and abs(rate) <= rate_off and not start.level:
        return False
    late = (64.0 + load * load + rate * rate) / (stick.slow if stick.regime < 0 else stick.decay)
    turning = first_jerk_zero(stick, start.X, start.V1, late, start.level)
    if not math.isfinite(turning):
        return True
    extremum, _ = propagate(stick, load, rate, turning)
    x_own, v_own = rounding(stick, load, rate, turning)
    return abs(extremum) + load_error(stick, norm, turning) + x_own + v_own < 1.0


@text
def keeps_off(pair: Pair, start: Start, errors: Errors, at: At, tau: float, shift: float, found: float) -> bool:
    """Return whether the guard has certainly not passed zero until tau (off by `shift`), where the state is `at`.

    In stick `found` is the edge that the load heads for, and its distance from that edge is the guard; in a slip it is
    how far above 0 the guard stayed.
    """
    if start.mode == 0:
        x_own, v_own = rounding(pair.stick, start.X, start.V1, tau)
        load = at.X + pair.two_zeta * at.V1
        off = load_error(pair.stick, errors.norm, tau) + x_own + pair.two_zeta * v_own
        return found * load < 1.0 - off - shift * abs(at.V1 - pair.two_zeta * load)
    q, r, sign = pair.q, pair.r, float(start.mode)
    x_own, v_own, driven_own = slip_rounding(pair, start, at, tau)
    norm = errors.norm + x_own + math.sqrt(q) * v_own + math.sqrt(r) * driven_own
    pull = acceleration(pair.slip, sign * at.X + r, sign * at.V1)
    off = reach(q, r, norm) + shift * (1.0 + abs(pull))
    return sign * (at.V1 - at.V2) > 2.0 * off and found > 2.0 * off
