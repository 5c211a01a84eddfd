"""The error bounds of a damped run: carried from event to event, read at events and at the end. In binary64 only."""

from __future__ import annotations

import math

from numerics.arithmetic.float64 import UNIT, nonnegative
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.bounds.damped_ends import (
    after_slip,
    after_stick,
    damped_error,
    energy_size,
    keeps_off,
    slide_error,
    slip_rounding,
    stays,
)
from numerics.bounds.damped_steps import Errors, excess_error, initial_errors, lost, rounding, slip_spread, stick_map
from numerics.bounds.records import UNDERFLOW, EndErrors, EventErrors, event_errors
from numerics.motion.damped import Arrival, End, Pair, Start, arrive, flow, follow
from numerics.motion.records import At


@text
def initial(pair: Pair, start: Start, V1: Number, V2: Number) -> Errors:
    """Return the errors of a start whose numbers are exact rationals, rounded."""
    return initial_errors(pair.q, pair.r, start.X, V1, V2, start.Z, start.w)


@text
def gone(errors: Errors) -> Errors:  # noqa: ARG001
    """Return the errors of a trajectory of which not even the next mode is certain."""
    return lost()


@text
def when_stuck(pair: Pair, start: Start, errors: Errors) -> Errors:
    """Return the errors of a last stick phase, lost where it may end."""
    return errors if stays(pair, start, errors) else lost()


@text
def after_event(pair: Pair, before: Start, errors: Errors, at: Arrival, after: Start, duration: Number) -> Errors:
    """Return the errors at the start of the motion `after`, which follows `before`."""
    if before.mode == 0:
        return after_stick(pair, before, errors, at.at, after, duration)
    return after_slip(pair, before, errors, at.at, at.spared, after, duration)


@text
def before_horizon(
    pair: Pair, start: Start, errors: Errors, end: End, duration: Number, tau: Number, rest: Number, horizon: Number
) -> Errors:
    """Return the errors, lost where the event that was found at tau, after the horizon, may come before it."""
    until, shift = (horizon - start.tau) - start.rest, 4.0 * UNIT * horizon
    here, found = flow(pair, start, until), end.side if start.mode == 0 else end.spared
    if keeps_off(pair, start, errors, here, until, shift, found):
        return errors
    at = arrive(pair, start, end, duration)
    following = follow(pair, start, at, duration, tau, rest)
    late = after_event(pair, start, errors, at, following, duration).late
    return errors if duration - until > late + shift else lost()


@text
def at_event(pair: Pair, start: Start, errors: Errors, velocity: Number) -> EventErrors:  # noqa: ARG001
    """Return the errors at the event that a motion starts with, the rounding of SI units included."""
    x, v = errors.x + 2.0 * UNIT * abs(start.X), errors.v + 2.0 * UNIT * abs(velocity)
    at = errors.late, x, v, errors.place, errors.w
    return event_errors(start.tau, start.X, velocity, start.X - start.Z, start.Z, at)


@text
def at_horizon(pair: Pair, start: Start, errors: Errors, horizon: Number) -> tuple[At, EndErrors]:
    """Return the state at the horizon, which lies in the motion with this start."""
    if start.tau > 0.0 and not horizon - start.tau >= errors.late + 4.0 * UNIT * horizon:
        errors = lost()
    tau = nonnegative((horizon - start.tau) - start.rest)  # the rounding of an event at the horizon may lie beyond it
    at = flow(pair, start, tau)
    if start.mode == 0:
        return at, in_stick(pair, start, errors, at, tau, 4.0 * UNIT * horizon)
    return at, in_slip(pair, start, errors, at, tau, 4.0 * UNIT * horizon)


@text
def in_stick(pair: Pair, start: Start, errors: Errors, at: At, tau: float, shift: float) -> EndErrors:
    """Return the errors during a stick phase."""
    stick = pair.stick
    x_own, v_own = rounding(stick, start.X, start.V1, tau)
    whole, sine, rest = stick_map(stick, tau)
    x = errors.norm * min(1.0, 1.01 * math.sqrt(whole * whole + sine * sine))
    v = errors.norm * min(1.0, 1.01 * math.sqrt(rest * rest + sine * sine))
    x += x_own + shift * abs(at.V1)
    v = v + v_own + shift * abs(pair.two_zeta * at.V1 + at.X)
    return at_end(pair, start, errors, at, tau, shift, (x, v, v, x + v, 0.0))


@text
def in_slip(pair: Pair, start: Start, errors: Errors, at: At, tau: float, shift: float) -> EndErrors:
    """Return the errors during a slip."""
    sqrt_q = math.sqrt(pair.q)
    x_own, v_own, driven_own = slip_rounding(pair, start, at, tau)
    x, v1 = slip_spread(pair.slip, pair.q, errors, tau)
    pull = abs(pair.two_zeta * at.V1 + at.X + float(start.mode) * pair.r) / pair.q
    x += x_own + shift * abs(at.V1)
    v1 += v_own + shift * pull
    v2 = errors.norm / math.sqrt(pair.r) + driven_own + shift
    norm = min(errors.norm + x_own + sqrt_q * (v_own + shift * pull) + shift * (abs(at.V1) + 1.0), x + v1 + v2)
    slide = slide_error(pair, start, at, errors.norm, x_own, tau + errors.late)
    return at_end(pair, start, errors, at, tau, shift, (x, v1, v2, norm, slide))


@text
def at_end(
    pair: Pair,
    start: Start,
    errors: Errors,
    at: At,
    tau: float,
    shift: float,
    bounds: tuple[float, float, float, float, float],
) -> EndErrors:
    """Return the errors at the end from those of X, V1, V2, of the norm, and of |dZ| in the last motion."""
    x, v1, v2, norm, slide = bounds
    damped = errors.damped + damped_error(pair, start, at.damped - start.damped, errors.norm, tau)
    damped += shift * 2.0 * pair.two_zeta * at.V1 * at.V1 + 8.0 * UNIT * at.damped + UNDERFLOW
    slide += shift * abs(at.V1 - at.V2)
    size = energy_size(pair, at.X, at.V1, at.V2)
    w_error = excess_error(size, norm, size * size)
    place = errors.place + slide + 2.0 * UNIT * (abs(start.Z) + abs(at.Z))
    x, v1, v2 = x + 4.0 * UNIT * abs(at.X), v1 + 4.0 * UNIT * abs(at.V1), v2 + 4.0 * UNIT * abs(at.V2)
    spent = spent_error(pair, errors.slide + slide, at.spent)
    return EndErrors(x, v1, v2, place, w_error, spent, damped, math.isfinite(errors.late))


@text
def spent_error(pair: Pair, slide: float, spent: float) -> float:
    """Return a bound on the error of what friction took."""
    return 2.0 * pair.r * slide + 8.0 * UNIT * spent + UNDERFLOW


@text
def at_last_event(pair: Pair, start: Start, errors: Errors) -> tuple[At, EndErrors]:
    """Return the state at the event that a motion starts with, where a run has stopped."""
    X, V = start.X, start.V2
    x, v = errors.x + 2.0 * UNIT * abs(X), errors.v + 2.0 * UNIT * abs(V)
    place, spent = errors.place + 2.0 * UNIT * abs(start.Z), spent_error(pair, errors.slide, start.spent)
    damped = errors.damped + 8.0 * UNIT * start.damped + UNDERFLOW
    state = At(X, start.V1, V, start.Z, start.w, start.spent, start.damped)
    return state, EndErrors(x, v, v, place, errors.w, spent, damped, math.isfinite(errors.late))
