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

from typing import NamedTuple

from flint import arb, arb_poly

from numerics.plane.candidate import Candidate
from numerics.plane.defect import Curve, force_along
from numerics.plane.polynomial import integral_bound, least, total
from numerics.plane.series import Point
from numerics.plane.system import System


class Step(NamedTuple):
    """A step of a slip, N at its end, and a lower bound of h(s); N is infinite where there is none."""

    curve: Curve
    norm: arb
    slowest: arb


def own_clock(system: System, at: Point, slip: Candidate, h: arb, norm: arb) -> Step:
    """Return the step of a slip along a candidate, sigma = h x, from a point where N <= `norm`."""
    drive, (t, q1, v2, s, swing) = system.pieces[at.piece], slip
    rate, v1, (u, u_off) = t.derivative(), v2 + s, force_along(drive, t, swing)
    curve = Curve.of(at, t, q1, v2, s, s * (drive.b_squared * h))

    smallest = least(rate)
    if not smallest > 0:
        return Step(curve, arb("inf"), arb(0))
    strayed = total(rate * rate - s * s @ (drive.b_squared * (h * h))) / smallest  # |t' - h h(s)|
    slowest = ((smallest - strayed) / h).lower()  # of h(s) and of t'/h
    if not slowest > 0:
        return Step(curve, arb("inf"), arb(0))
    momentum = v2 * system.mass + s * system.m1
    pushed = momentum.each(arb_poly.derivative) - system.push(u, q1, v1) * rate
    pushed = pushed.each(integral_bound) + u_off * integral_bound(rate)
    moved = (q1.each(arb_poly.derivative) - v1 * rate).each(integral_bound)
    other = system.norm(moved, pushed / system.m1, system.still) + drive.reach * strayed
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
