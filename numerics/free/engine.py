"""Solve one scene of the free pair (a1 = 0, no force, b constant) in balls or mpmath: `run_free`.

No step and no sample: every motion is known in closed form, so a run costs as many evaluations as it has events.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.arithmetic.functions import sign
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.free.frame import Frame, begin
from numerics.free.motion import event_state, mode_of, motions, order_of, state_at
from numerics.free.slip import Start
from numerics.linear.record import How, Knot, Record
from numerics.scene import Law, Scene

Progress = Callable[[int, float], None]


def run_free(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene with a1 = 0, no force and constant b. Raises EventUndecided, OutOfRange, NoForceHere."""
    at, number = scene.initial, arithmetic.number
    with arithmetic.context():
        frame = Frame(arithmetic, scene.pair)
        first, until = begin(scene, frame), number(scene.until)
        horizon, knots = frame.rate * until, list[Knot]()
        length = zero = first.tau
        given = number(at.x1), number(at.v1), number(at.x2), number(at.v2)
        for start, duration in motions(frame, first, scene.law is Law.THREE_VALUED_SGN):
            here = frame.in_si(event_state(frame, start)) if knots else given
            knots.append(_knot(start, bool(knots), start.tau / frame.rate, length, here, start.w))
            if progress is not None and len(knots) % 1000 == 0:
                progress(len(knots), arithmetic.to_float(start.tau / horizon))
            left = horizon - start.tau
            if duration is None or sign(duration - left, "does the next event come before the horizon?") > 0:
                last = state_at(frame, start, left)
                end = _knot(start, False, until, left / frame.rate, frame.in_si(last), last.w)
                how = How.STUCK if duration is None else How.REACHED
                return Record(knots, end, how, len(knots) - 1)
            if len(knots) > max_events:
                break
            length = duration / frame.rate
        return Record(knots, knots[-1]._replace(length=zero), How.EVENT_LIMIT, len(knots) - 1)


def _knot(start: Start, event: bool, t: Number, length: Number, state: Any, w: Number) -> Knot:
    x1, v1, x2, v2 = state
    return Knot(mode_of(start), order_of(start), event, False, 0, t, length, x1, v1, x2, v2, w)
