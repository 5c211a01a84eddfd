"""What holds of the true motion for a short time before and after a point of the path, whatever friction does in it.

Twice the rate of v1 at the point, V, bounds |v1'| as long as |u - A2 q1 - A1 v1| + b < m1 V with all that q1 and v1
can come to at such rates: that is checked, so V cannot be exceeded first, and all that follows from it is proved.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import arb, arb_series

from numerics.plane.series import Point
from numerics.plane.system import System
from numerics.plane.vector import Vector, wide

BEYOND = 1 + 2.0**-10
"""So far beyond K friction may be: that of a mode which is followed on to where the true motion has left it."""


class Around(NamedTuple):
    """Enclosures and bounds by axes, for all of a window.

    `first`, `second`, `steep`: bounds on |v1'|, |v2'|, |Lam'|; `load`: Lam; `drift`: the rate of what Lam is without
    the part of s, share (u - A2 q1 - A1 V), V the velocity of the common mass, in which no friction is.
    """

    first: Vector
    second: Vector
    load: Vector
    drift: Vector
    steep: Vector


def around(system: System, at: Point, norm: arb, window: arb, slips: Sequence[arb | None] = ()) -> Around:
    """Return what holds within `window` (s) of a point from which the true motion is N <= norm. Raises EventUndecided.

    `slips`: friction on axes that slip with a constant one (else None); there the rate of v1 replaces that of V.
    """
    drive = system.drive(at)
    first = (abs(system.push(drive.force(at.t), at.q1, at.v1)) + drive.b) * 2 / system.m1
    v1 = wide(at.v1, norm / system.root_m1 + first * window)
    q1 = wide(at.q1, system.soft * norm + abs(v1) * window)
    both = drive.force(arb_series([wide(at.t, window), 1], 2))
    u, turn = both.order(0), both.order(1)
    push = system.push(u, q1, v1)
    if not all(x < y for x, y in zip(abs(push) + drive.b * BEYOND, system.m1 * first, strict=True)):
        raise system.undecided("how far does the motion get in a window", at, norm)
    pull = list(push / system.mass)
    for i, f in enumerate(slips):
        if f is not None:
            pull[i] = (push[i] - f) / system.m1[i]
    steep = system.share * (abs(turn - system.a2 @ v1) + abs(system.a1) @ first)
    drift = system.load(turn, v1, Vector(pull))
    return Around(first, drive.b * BEYOND / system.m2, push * system.share, drift, steep)
