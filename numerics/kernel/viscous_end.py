"""The state at the horizon of a viscous run, or at its last event, with bounds on its errors."""

from __future__ import annotations

import math
from typing import NamedTuple

from numerics.kernel.bounds import ULP
from numerics.kernel.compilation import kernel
from numerics.kernel.state import End
from numerics.kernel.viscous_bounds import UNDERFLOW, Errors, excess_error, lost, slip_spread, stick_map
from numerics.kernel.viscous_errors import damped_error, energy_size, slide_error, slip_rounding
from numerics.kernel.viscous_motion import flow
from numerics.kernel.viscous_oscillator import rounding
from numerics.kernel.viscous_state import Start, ViscousPair


class ViscousEnd(NamedTuple):
    """The end as undamped runs have it, with what viscosity has taken from E/E_cr and a bound on its error."""

    end: End
    damped: float
    damped_error: float


@kernel
def spent_error(pair: ViscousPair, slide: float, spent: float) -> float:
    """Return a bound on the error of what friction took."""
    return 2.0 * pair.r * slide + 8.0 * ULP * spent + UNDERFLOW


@kernel
def at_horizon(pair: ViscousPair, start: Start, errors: Errors, horizon: float, worst: float) -> ViscousEnd:
    """Return the state at the horizon, which lies in the motion with this start."""
    if start.tau > 0.0 and not horizon - start.tau >= errors.late + 4.0 * ULP * horizon:
        errors = lost()
    tau = max((horizon - start.tau) - start.rest, 0.0)  # the rounding of an event at the horizon may lie beyond it
    at = flow(pair, start, tau, 0.0)
    shift = 4.0 * ULP * horizon
    if start.mode == 0:
        stick = pair.stick
        x_own, v_own = rounding(stick, start.X, start.V1, tau)
        whole, sine, rest = stick_map(stick, tau)
        x = errors.norm * min(1.0, 1.01 * math.sqrt(whole * whole + sine * sine))
        v = errors.norm * min(1.0, 1.01 * math.sqrt(rest * rest + sine * sine))
        x += x_own + shift * abs(at.V1)
        v1 = v2 = v + v_own + shift * abs(pair.two_zeta * at.V1 + at.X)
        norm, slide = x + v1, 0.0
    else:
        slip, sqrt_q = pair.slip, math.sqrt(pair.q)
        x_own, v_own, driven_own = slip_rounding(pair, start, at, tau)
        x, v1 = slip_spread(slip, pair.q, errors, tau)
        pull = abs(pair.two_zeta * at.V1 + at.X + float(start.mode) * pair.r) / pair.q
        x += x_own + shift * abs(at.V1)
        v1 += v_own + shift * pull
        v2 = errors.norm / math.sqrt(pair.r) + driven_own + shift
        norm = min(errors.norm + x_own + sqrt_q * (v_own + shift * pull) + shift * (abs(at.V1) + 1.0), x + v1 + v2)
        slide = slide_error(pair, start, at, errors.norm, x_own, tau + errors.late)
    damped = errors.damped + damped_error(pair, start, at.damped - start.damped, errors.norm, tau)
    damped += shift * 2.0 * pair.two_zeta * at.V1 * at.V1 + 8.0 * ULP * at.damped + UNDERFLOW
    slide += shift * abs(at.V1 - at.V2)
    size = energy_size(pair, at.X, at.V1, at.V2)
    w_error = excess_error(size, norm, size * size)
    place = errors.place + slide + 2.0 * ULP * (abs(start.Z) + abs(at.Z))
    x, v1, v2 = x + 4.0 * ULP * abs(at.X), v1 + 4.0 * ULP * abs(at.V1), v2 + 4.0 * ULP * abs(at.V2)
    spent, certain = spent_error(pair, errors.slide + slide, at.spent), math.isfinite(errors.late)
    end = End(start.mode, at.X, at.V1, at.V2, at.Z, at.w, at.spent, x, v1, v2, place, w_error, spent, worst, certain)
    return ViscousEnd(end, at.damped, damped)


@kernel
def at_event(pair: ViscousPair, start: Start, errors: Errors, worst: float) -> ViscousEnd:
    """Return the state at the event that a motion starts with, where a run has stopped."""
    X, V = start.X, start.V2
    x, v = errors.x + 2.0 * ULP * abs(X), errors.v + 2.0 * ULP * abs(V)
    place, spent = errors.place + 2.0 * ULP * abs(start.Z), spent_error(pair, errors.slide, start.spent)
    certain = math.isfinite(errors.late)
    end = End(
        start.mode, X, start.V1, V, start.Z, start.w, start.spent, x, v, v, place, errors.w, spent, worst, certain
    )
    return ViscousEnd(end, start.damped, errors.damped + 8.0 * ULP * start.damped + UNDERFLOW)
