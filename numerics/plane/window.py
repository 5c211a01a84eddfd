"""What holds of the true motion for a short time before and after a point of the path, whatever friction does in it.

Twice the rate of v1 at the point, V, bounds |v1'| as long as |u - A2 q1 - A1 v1| + b < m1 V with all that q1 and v1
can come to at such rates: that is checked, so V cannot be exceeded first, and all that follows from it is proved.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import arb

from numerics.plane.series import Point
from numerics.plane.system import Balls, System


class Around(NamedTuple):
    """Enclosures and bounds by axes, for all of a window.

    `first`, `second`, `steep`: bounds on |v1'|, |v2'|, |Lam'|; `load`: Lam; `drift`: the rate of what Lam is without
    the part of s, share (u - A2 q1 - A1 V), V the velocity of the common mass, in which no friction is.
    """

    first: Balls
    second: Balls
    load: Balls
    drift: Balls
    steep: Balls


def around(system: System, at: Point, norm: arb, window: arb, slips: Sequence[arb | None] = ()) -> Around | None:
    """Return what holds within `window` (s) of a point from which the true motion is N <= norm; None if it is too long.

    `slips`: friction on axes that slip with a constant one (else None); there the rate of v1 replaces that of V.
    """
    drive = system.pieces[min(at.piece, len(system.pieces) - 1)]
    v1, u = at.v1, drive.force(at.t)
    first = [
        2 * (abs(system.push(u, at.q1, v1, i)) + b) / m for i, b, m in zip(system.axes, drive.b, system.m1, strict=True)
    ]
    v1 = [wide(x, norm / root + r * window) for x, root, r in zip(v1, system.root_m1, first, strict=True)]
    q1 = [wide(x, soft * norm + abs(v) * window) for x, soft, v in zip(at.q1, system.soft, v1, strict=True)]
    t = wide(at.t, window)
    u, turn = drive.force(t), drive.force_rate(t)
    push = [system.push(u, q1, v1, i) for i in system.axes]
    if not all(abs(p) + b < m * r for p, b, m, r in zip(push, drive.b, system.m1, first, strict=True)):
        return None
    pull = [p / m for p, m in zip(push, system.mass, strict=True)]
    for i, f in enumerate(slips):
        if f is not None:
            pull[i] = (push[i] - f) / system.m1[i]
    still = [arb(0)] * system.n
    steep = [
        share * (abs(system.push(turn, v1, still, i)) + system.row_sum(system.a1[i], first))
        for i, share in enumerate(system.share)
    ]
    second = [b / m for b, m in zip(drive.b, system.m2, strict=True)]
    load = [x * share for x, share in zip(push, system.share, strict=True)]
    return Around(first, second, load, system.load(turn, v1, pull), steep)


def wide(x: arb, by: arb) -> arb:
    """Return x with a radius that is larger by something."""
    return x + arb(0, by.upper())
