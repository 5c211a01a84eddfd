"""Slips that begin, and slips that have settled: f is what the load and the slip's own change ask for.

With g = B^-1 f, |g| = 1, D = (B kap B)^-1 and h = h(s) by the time a slip is s = h B^-1 g with

    g + (h D g)' = B^-1 Lam.

A slip from s = 0 has h = tau^m (...), m = 1 where the load is outside K, m = 2 on its edge: what is missing of order k
gives g_k and h_{k+1}, (1 + (k+1) h_1 D) g_k + (k+1) h_{k+1} D g_0 and g_0.g_k. For m = 1 the series converges.

Where |s| is small the direction settles at the rate kap b/|s|: steps of a Taylor series would be as short. What it
settles to solves the same equation, read the other way round, by iteration: g = C - h' D g with C = B^-1 Lam - h D g',
|C - h' D g| = 1 gives h' and so the next g. Each turn gains the factor (settling time)/(time in which things change).
Both series diverge in general: they are cut where their terms are least, and the defect says how good they are.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from flint import arb, arb_series

from numerics.arithmetic.root import approximate_root
from numerics.plane.series import Point, Series
from numerics.plane.system import PlaneDrive, System
from numerics.plane.vector import Vector

_PART = 2.0**-7
"""The part of |g|^2 from which on axes that have not settled hold h."""


def onset(system: System, at: Point, load: Vector, m: int) -> Series:
    """Return the series of a slip from s = 0, at a point where the load is outside K (m = 1), or on its edge (2)."""
    drive, first = system.pieces[at.piece], arb(0)
    degree = system.degree if m == 1 else int(0.75 * system.bits) + 8
    u = drive.force(arb_series([at.t, 1], degree))
    if m == 1:
        g, first = first_slip(system, drive, load)
    else:
        g = load / drive.b / drive.strain(load, system.axes).sqrt()
    start, h, rows = g.each(arb.mid), [arb(0), first.mid()], [[x.mid()] for x in g]
    for k in range(1, degree):
        size, g = arb_series(h, k + 2), Vector(arb_series(row, k + 2) for row in rows)
        q1, v2, _, load = _moved(system, drive, at, u, size, g)
        missing = load / drive.b - (size * g * drive.heavy).each(arb_series.derivative) - g
        r, over = missing.order(k), (g @ g)[k] / 2
        eased = 1 / (drive.heavy * first * (k + 1) + 1)
        bent = drive.heavy * start * (k + 1)
        rise = (start * eased @ r + over) / (start * eased @ bent)
        h.append(rise.mid())
        for row, x in zip(rows, (r - bent * rise) * eased, strict=True):
            row.append(x.mid())
    slip = arb_series(h, degree + 1) * Vector(arb_series(row, degree + 1) for row in rows) / drive.b
    return Series(_listed(q1, degree), _listed(v2, degree), [row[m:] for row in _listed(slip, degree + 1)], h[m:])


def first_slip(system: System, drive: PlaneDrive, load: Vector) -> tuple[Vector, arb]:
    """Return g and the rate of h where a slip begins: B g is the point of K nearest to Lam, s' = kap (Lam - B g)."""
    c = system.kappa * drive.b_squared
    p = c * load / drive.b

    def beyond(h: arb) -> tuple[arb, arb]:
        g = p / (c + h)
        return g @ g - 1, -2 * (g * g @ (1 / (c + h)))

    h = approximate_root(arb(0), (p @ p).sqrt(), beyond)
    return (p / (c + h)).each(arb.mid), h


def slow_series(system: System, at: Point, quick: Sequence[bool]) -> Series | None:
    """Return the series of a slip that has settled on the `quick` axes, None if the iteration does not settle.

    On the others h D g goes on from its beginning, by B^-1 Lam - g. If they have a part in h it is what |g| = 1 asks
    for; else the quick axes alone say how it changes.
    """
    drive, degree = system.pieces[at.piece], system.degree
    u = drive.force(arb_series([at.t, 1], degree))
    f, first = drive.friction(at.s)
    size, g = arb_series([first.mid()], degree), (f / drive.b).each(lambda x: arb_series([x.mid()], degree))
    change, began = arb("inf"), at.s / drive.b / system.kappa
    settles, rests = (Vector(arb(one == part) for one in quick) for part in (True, False))
    held = bool((g * g @ rests)[0] > _PART)

    def kept(p: Any) -> Any:
        return arb_series([x.mid() for x in p.coeffs()], degree)

    for turn in range(degree):
        q1, v2, s, load = _moved(system, drive, at, u, size, g)
        across, push, before = g * drive.heavy * settles, load / drive.b, g
        slow = ((push - g).each(arb_series.integral) + began) / drive.heavy * rests
        free = push * settles - size * across.each(arb_series.derivative)
        if held:
            free = free - across * size.derivative()
            left = 1 - free @ free
            if not left[0] > 0:
                return None
            size = kept((slow @ slow / left).sqrt())
            g = (free + slow / size).each(kept)
        else:
            free = free + slow / size
            rate = (g @ free - (g @ g + 1) / 2) / (g @ across)  # so that the next |g| is 1
            size = kept(rate.integral() + first)
            g = (free - rate * across).each(kept)
        last, change = change, max((abs(x[0] - y[0]) for x, y in zip(g, before, strict=True)), key=lambda one: one)
        if not change < 2 or (turn > 8 and not (change < last or change < arb((1, -system.bits // 2)))):  # |g| is 1
            return None
    q1, v2, s, _ = _moved(system, drive, at, u, size, g)
    return Series(*(_listed(part, degree) for part in (q1, v2, s)), *_listed([size], degree))


def _moved(system: System, drive: PlaneDrive, at: Point, u: Vector, size: Any, g: Vector) -> tuple[Vector, ...]:
    """Return q1, v2, s and the load of a slip by the time, from h(s) and g."""
    s = size * g / drive.b
    v2 = (g * drive.b / system.m2).each(arb_series.integral) + at.v2
    q1 = (v2 + s).each(arb_series.integral) + at.q1
    return q1, v2, s, system.load(u, q1, v2 + s)


def _listed(series: Iterable[Any], degree: int) -> list[list[arb]]:
    return [[p[k] for k in range(degree)] for p in series]
