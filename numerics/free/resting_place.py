"""Where the bodies of a free pair end up: the limit of z = x1 - x2, also after infinitely many slips.

A pair that sticks for ever keeps its z. One that creeps (a1 = 0) slips to one side and the other in turn, ever less: a
slip from a ray with y = w/q moves z by E_cr q (y - F(y))/b, and the Abel functions (abel.py) add up all that are left.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.free.abel import abel_functions
from numerics.linear.modes import EventKind
from numerics.scene import Pair


@dataclass(frozen=True)
class RestingPlace:
    """The limit of x1 - x2 (m), an enclosure, and what is known from some event on.

    From event `index` (counted from 0; -1: the start) on |z - limit| <= `reach` (m) and |w| <= `speed` (m/s), for ever.
    """

    limit: arb
    index: int
    reach: arb
    speed: arb


def creeping_place(trajectory: Any, pair: Pair, near: float, since: Fraction) -> RestingPlace | None:
    """Return the resting place of a pair that creeps, read from an exit after the time `since` (s), or None.

    From then on no force acts on the pair, or a constant one, which only shifts x1. a1 = 0. `near`: from the event on
    reach and speed are at most this, each in its SI unit. The trajectory is of balls; in the arithmetic's context.
    """
    if pair.a1 > 0:
        return None
    number, digits = Ball.number, trajectory.arithmetic.digits
    unit = number(pair.critical_energy * pair.share / pair.b)
    for index, event in enumerate(trajectory.events):
        x1, v1, x2, _ = event.y
        # on the ray the spring has the energy E_cr, a constant force shifts x1 only: the excess is that of the velocity
        y = number(pair.mass / (2 * pair.critical_energy * pair.share)) * v1 * v1
        is_exit = event.kind is EventKind.EXIT and event.t > number(since)
        abel = abel_functions(pair.share, digits, y) if is_exit else None
        if abel is None:
            continue
        # c(y) <= 3 y/2 bounds a slip's way; its angle is at most 3 sqrt(y), and w'' <= (a2/m1)|v1| while body 1 moves
        # outwards
        reach = (unit * number(1 - pair.share) * (9 * y * y / 4)).upper()
        speed = (abs(v1) * 9 * y / 2).upper()
        if reach.max(speed) < near:
            limit = x1 - x2 + event.after.sign * unit * abel.slide(y)
            return RestingPlace(limit, index, reach, speed)
    return None
