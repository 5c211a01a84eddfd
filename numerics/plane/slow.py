"""A slow slip: f has settled to what the load and the slip's own change ask for, and no clock need follow how it did.

Where |s| is small the direction of a slip settles at the rate kap b/|s|: steps of a Taylor series would be as short.
What it settles to solves the same equations, read the other way round, by iteration. With g = B^-1 f, |g| = 1,

    s = h B^-1 g,   g = B^-1 (Lam - kap^-1 s') = C - h' D g,   D = (B kap B)^-1,   C = B^-1 Lam - h D g',

|C - h' D g| = 1 gives h' and so the next g. Each turn gains the factor (settling time)/(time in which things change);
at an edge of K, where h begins as tau^2, a coefficient. The series diverges in general: it is cut where its terms are
least, and the defect says how good it is.
"""

from __future__ import annotations

from operator import mul
from typing import Any

import flint
from flint import arb, arb_series

from numerics.plane.onset import Onset
from numerics.plane.series import Point, force_series
from numerics.plane.system import System


def slow_series(system: System, at: Point, degree: int, m: int) -> Onset | None:
    """Return the series of a slip that has settled (m = 0), or that begins at rest on the edge of K (m = 2).

    None if the iteration does not settle.
    """
    before, flint.ctx.cap = flint.ctx.cap, degree
    try:
        return _settled(system, at, degree, m)
    finally:
        flint.ctx.cap = before


def _settled(system: System, at: Point, degree: int, m: int) -> Onset | None:
    drive = system.pieces[at.piece]

    def kept(p: Any) -> Any:
        return arb_series([x.mid() for x in p.coeffs()], flint.ctx.cap)

    def numbers(of: list[arb]) -> list[Any]:
        return [arb_series([x.mid()], degree) for x in of]

    u = force_series(drive, at.t, degree)
    heavy = [1 / (k * b) for k, b in zip(system.kappa, drive.b_squared, strict=True)]
    s, v2, q1 = numbers(at.s), numbers(at.v2), numbers(at.q1)
    if m == 0:
        f, first = drive.friction(at.s)
    else:  # the load is on the edge: f is the load
        f, first = [x[0] for x in system.load(u, q1, v2)], arb(0)
        strain = drive.strain(f).sqrt()
        f = [x / strain for x in f]
    (size,), g = numbers([first]), numbers([x / b for x, b in zip(f, drive.b, strict=True)])
    change = arb("inf")
    for turn in range(degree):
        flint.ctx.cap = min(degree, turn + 4) if m else degree
        v1 = [x + y for x, y in zip(v2, s, strict=True)]
        q1 = [kept(v.integral() + x) for x, v in zip(at.q1, v1, strict=True)]
        load = system.load(u, q1, v1)
        across = [x * d for x, d in zip(g, heavy, strict=True)]
        free = [kept(x / b - size * y.derivative()) for x, b, y in zip(load, drive.b, across, strict=True)]
        over, along, square = (
            sum(map(mul, x, y), arb_series([one], degree))
            for x, y, one in ((free, free, -1), (free, across, 0), (across, across, 0))
        )
        root = along * along - square * over
        if not root[0] > 0:
            return None
        root = root.sqrt()  # the smaller h' of the two, without cancellation
        rate = kept(over / (along + root) if along[0] > 0 else (along - root) / square)
        if m:
            rate = rate - rate[0]
        size = kept(rate.integral() + first)
        before, g = g, [kept(x - rate * y) for x, y in zip(free, across, strict=True)]
        s = [kept(size * x / b) for x, b in zip(g, drive.b, strict=True)]
        v2 = [kept((x * b / w).integral() + y) for x, b, w, y in zip(g, drive.b, system.m2, at.v2, strict=True)]
        last, change = change, max((abs(x[0] - y[0]) for x, y in zip(g, before, strict=True)), key=lambda one: one)
        if m == 0 and turn > 8 and not (change < last or change < arb((1, -system.bits // 2))):
            return None
    slip, (whole,) = ([list(p.coeffs())[m:] for p in part] for part in (s, [size]))
    return Onset([list(p.coeffs()) for p in q1], [list(p.coeffs()) for p in v2], slip, whole)
