"""Where the bodies of a free pair end up: the limit of z = x1 - x2, also after infinitely many slips.

A pair that sticks for ever keeps its z. One that creeps (a1 = 0) slips to one side and the other in turn, ever less: a
slip from a ray with y = w/q moves z by E_cr q (y - F(y))/b, and the Abel functions (abel.py) add up all that are left.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.errors import PrecisionExhausted
from numerics.long_time.energy import abel_functions, order_for, reach_of
from numerics.motion.modes import EventKind
from numerics.trajectory.status import Status


@dataclass(frozen=True)
class RestingPlace:
    """The limit of x1 - x2 (m), an enclosure, and what is known from some event on.

    From event `index` (counted from 0; -1: the start) on |z - limit| <= `reach` (m) and |w| <= `speed` (m/s), for ever.
    """

    limit: arb
    index: int
    reach: arb
    speed: arb


def resting_place(trajectory: Any, near: float) -> RestingPlace | None:
    """Return the resting place of a free trajectory in balls; None if its horizon comes before it is known.

    `near`: from the event on reach and speed are at most this, each in its SI unit. In the arithmetic's context.
    """
    if trajectory.status is Status.STUCK_FOR_EVER:
        x1, _, x2, _ = trajectory.final_state
        return RestingPlace(x1 - x2, len(trajectory.events) - 1, arb(0), arb(0))
    if trajectory.scene.pair.a1 > 0:
        return None
    for index, event in enumerate(trajectory.events):
        if event.kind is EventKind.EXIT:
            found = _from_ray(trajectory, index, event)
            if found is not None and found.reach.max(found.speed) < near:
                return found
    return None


def _from_ray(trajectory: Any, index: int, event: Any) -> RestingPlace | None:
    """Return what follows from one exit by a ray, None as long as y is too large for the series."""
    pair, digits, frame = trajectory.scene.pair, trajectory.arithmetic.digits, trajectory.frame
    y = event.reduced.w / frame.q
    if not y < reach_of(digits):
        return None
    abel = abel_functions(pair.share, order_for(digits))
    if not y <= Ball.number(abel.largest_argument):
        return None
    unit = frame.critical_energy * frame.q / Ball.number(pair.b)
    x1, _, x2, _ = event.y
    limit = x1 - x2 + event.after.sign * unit * abel.slide(y)
    # c(y) <= 3 y/2 bounds a slip's way; its angle is at most 3 sqrt(y), and w'' <= (a2/m1)|v1| while body 1 moves
    # outwards
    reach = unit * frame.r * (9 * y * y / 4)
    speed = abs(event.y[1]) * 9 * y / 2
    return RestingPlace(limit, index, reach.upper(), speed.upper())


def require_known(found: RestingPlace | None, digits: int) -> RestingPlace:
    """Return it, or raise PrecisionExhausted."""
    if found is None:
        raise PrecisionExhausted(f"{digits} right digits of the resting place are not reached; raise max_events")
    return found
