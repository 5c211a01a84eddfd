"""A step of a slip by its own clock, and N after it: what turns a slip is damped, so it adds up by squares.

Of a polynomial s, t' = h(s), f t' = B^2 s, the momentum and q1 follow by quadrature. So all that is missing is an e in
the equation of s: M1 v1' = ... - f t' - e, M2 v2' = f t' + e. With a = B s, b = B (s of the motion), y the part of b
across a,

    Df.Ds = (|a| + |b|)(1 - cos) >= y^2/(|a| + 2 h(Ds)),   since 1 - cos >= sin^2/2 and |b| <= |a| + h(Ds);

e = k + c kap^-1 s with k.s = 0 gives |e.Ds| <= |B^-1 k| y + |e.s|/|s|_{kap^-1} N, and so

    (N^2)' <= 2 (|e.s|/|s|_{kap^-1} + other defects) N + |B^-1 k|^2 (h(s) + 2 h(Ds))/(2 t'),
    N(1) <= sqrt(N(0)^2 + int |B^-1 k|^2 (h(s) + 2 h(Ds))/(2 t')) + int |e.s|/|s|_{kap^-1} + other defects,

and never more than by the defect theorem, N(0) + int |e| + other defects.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import arb, arb_poly, arb_series

from numerics.plane.defect import Curve, force_along
from numerics.plane.polynomial import integral_bound, least, midpoints, total
from numerics.plane.series import Point
from numerics.plane.system import System
from numerics.plane.vector import Vector

_MORE = 6
"""Terms beyond those of s with which the rest follows from it."""


class Step(NamedTuple):
    """A step of a slip, N at its end, and a lower bound of h(s); N is infinite where there is none."""

    curve: Curve
    norm: arb
    slowest: arb


def own_clock(system: System, at: Point, q1: Vector, v2: Vector, s: Vector, h: arb, norm: arb) -> Step:
    """Return the step of a slip along s, sigma = h x, from a point where N <= `norm`.

    `q1`, `v2`: about what they are along it; with these the load is found.
    """
    drive, top = system.pieces[at.piece], max(x.length() for x in s) + _MORE

    def followed(rates: Vector, start: Vector) -> Vector:
        return Vector(midpoints(_cut(x, top).integral() + y) for x, y in zip(rates, start, strict=True))

    square = s * s @ drive.b_squared
    size = _cut(arb_series(square.coeffs(), top).sqrt(), top)
    t = midpoints((size * h).integral() + at.t)
    rate, (u, u_off) = t.derivative(), force_along(drive, t, top)
    gained = system.push(u, q1, v2 + s) * rate - s.each(arb_poly.derivative) * system.m1
    v2 = followed(gained * (1 / system.mass), at.v2)
    v1 = v2 + s
    flow = v1 * rate
    q1 = followed(flow, at.q1)
    curve = Curve.of(at, t, q1, v2, s, s * (drive.b_squared * h))

    smallest, missing = least(size), total(size * size - square)
    strayed = total(size * h - rate) + h * missing / smallest  # |t' - h h(s)|
    slowest = (smallest - 2 * strayed / h).lower()  # of h(s) and of t'/h
    if not slowest > 0:
        return Step(curve, arb("inf"), arb(0))
    momentum = v2 * system.mass + s * system.m1
    pushed = momentum.each(arb_poly.derivative) - system.push(u, q1, v1) * rate
    pushed = pushed.each(total) + u_off * total(rate)
    other = system.norm((q1.each(arb_poly.derivative) - flow).each(total), pushed / system.m1, system.still)
    other += drive.reach * strayed
    return Step(curve, _after(system, curve, norm, other, slowest, h), slowest)


def _after(system: System, curve: Curve, norm: arb, other: arb, slowest: arb, h: arb) -> arb:
    """Return N at the end, from N at the beginning and the other defects; h(s) >= `slowest`, t' about h h(s)."""
    drive, s = system.pieces[curve.piece], curve.s
    missing = curve.v2.each(arb_poly.derivative) * system.m2 - curve.impulse
    shortest = (slowest / drive.reach).max(least(s * s @ (1 / system.kappa)).max(arb(0)).sqrt())
    along = missing @ s
    straight = integral_bound(along) / shortest
    squares = (missing * (1 / drive.b_squared) @ missing).integral()(arb(1)).abs_upper()
    across = squares.sqrt() + (straight * total(along) / shortest).abs_upper().sqrt() / drive.weak
    off = missing.each(integral_bound)
    linear = norm + other + system.norm(system.still, off / system.m1, off / system.m2)
    # reach |t' - h h(s)| is one of the other defects
    loose = 1 + (other / (drive.reach * h) + 2 * drive.reach * linear) / slowest
    by_squares = (norm * norm + across * across * loose / (2 * h)).sqrt() + other + straight
    return linear.min(by_squares).upper()


def _cut(p: Any, top: int) -> arb_poly:
    """Return the first terms, with midpoints."""
    return arb_poly([x.mid() for x in p.coeffs()[:top]])
