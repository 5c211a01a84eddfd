"""The mode state machine: locate -> flow -> snap -> record. It never samples.

One text for every arithmetic and every kind of motion. As it stands it follows undamped motions in binary64; told
otherwise, the texts that it calls are those of damped motions, or those of an arithmetic without error bounds.
"""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.float64 import clock, finite, sign
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import BEFORE_HORIZON
from numerics.arithmetic.telling import text
from numerics.bounds.undamped import after_event, at_event, before_horizon, when_stuck
from numerics.motion.codes import EVENT_LIMIT, MOVING, OUT_OF_RANGE, REACHED, STUCK
from numerics.motion.undamped import arrive, follow, locate, velocity
from numerics.run.rows import record


@text
def run(pair: Any, start: Any, errors: Any, horizon: Number, most: int, rows: Any) -> tuple[int, int, Any, Any, float]:
    """Follow the modes until the horizon, a last stick phase, or `most` events.

    Returns (how it ended, events, start of the last mode, its errors, worst). `rows` keeps the first events (rows.py),
    as many as it has. `worst` is a bound on the relative error of every t, x1, v and x2 at an event; where even the
    sequence is uncertain the errors say so.
    """
    count, keep, worst = 0, len(rows), 0.0
    while True:
        how, duration, end = locate(pair, start)
        if how == STUCK:
            errors = when_stuck(pair, start, errors)
        if how != MOVING:
            return how, count, start, errors, worst
        tau, rest = clock(start.tau, start.rest, duration)
        if sign(tau - horizon, BEFORE_HORIZON) > 0:
            break
        if count == most:
            return EVENT_LIMIT, count, start, errors, worst
        here = arrive(pair, start, end, duration)
        after = follow(pair, start, here, duration, tau, rest)
        if not finite(after.w):
            return OUT_OF_RANGE, count, start, errors, worst
        errors = after_event(pair, start, errors, here, after, duration)
        start, V = after, velocity(pair, after)
        at = at_event(pair, start, errors, V)
        worst = max(worst, at.relative)
        if count < keep:
            record(rows, count, duration, start, V, at)
        count += 1
    if not finite(tau):
        return OUT_OF_RANGE, count, start, errors, worst
    return REACHED, count, start, before_horizon(pair, start, errors, end, duration, tau, rest, horizon), worst
