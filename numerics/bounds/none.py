"""No bounds: for arithmetics that carry their own errors, or none. Each text stands in the place of its namesake."""

from __future__ import annotations

import math
from typing import Any

from numerics.arithmetic.float64 import nonnegative
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text
from numerics.bounds.records import EndErrors, EventErrors
from numerics.motion.records import At, no_damping
from numerics.motion.undamped import flow
from numerics.motion.undamped import velocity as velocity_at

_EVENT = EventErrors(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
_END = EndErrors(math.inf, math.inf, math.inf, math.inf, math.inf, math.inf, math.inf, False)


@text
def initial(pair: Any, start: Any, V1: Number, V2: Number) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return _EVENT


@text
def when_stuck(pair: Any, start: Any, errors: EventErrors) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return errors


@text
def after_event(pair: Any, before: Any, errors: EventErrors, at: Any, after: Any, duration: Number) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return errors


@text
def before_horizon(
    pair: Any,  # noqa: ARG001
    start: Any,  # noqa: ARG001
    errors: EventErrors,
    end: Any,  # noqa: ARG001
    duration: Number,  # noqa: ARG001
    tau: Number,  # noqa: ARG001
    rest: Number,  # noqa: ARG001
    horizon: Number,  # noqa: ARG001
) -> EventErrors:
    """Return nothing."""
    return errors


@text
def at_event(pair: Any, start: Any, errors: EventErrors, velocity: Number) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return errors


@text
def at_horizon(pair: Any, start: Any, errors: EventErrors, horizon: Number) -> tuple[At, EndErrors]:  # noqa: ARG001
    """Return the state at the horizon, which lies in the motion with this start."""
    return flow(pair, start, nonnegative((horizon - start.tau) - start.rest)), _END


@text
def at_last_event(pair: Any, start: Any, errors: EventErrors) -> tuple[At, EndErrors]:  # noqa: ARG001
    """Return the state at the event that a motion starts with, where a run has stopped."""
    V = velocity_at(pair, start)
    return At(start.X, V, V, start.Z, start.w, start.spent, no_damping()), _END
