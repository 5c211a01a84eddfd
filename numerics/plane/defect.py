"""What a polynomial motion lacks to be one, bounded in balls: by the defect theorem it is what it is off, at most.

A curve with q1' = v1 + d0, M1 v1' = u - A1 v1 - A2 q1 - f + d1, M2 v2' = f + d2, f in dh(s), leaves the motion from
the same start by N <= int |A2^1/2 d0| + |M1^-1/2 d1| + |M2^-1/2 d2|, across all events. On 0 <= x <= 1 everything
here is a polynomial, the defects too: no remainder is estimated. With f = B^2 s/h(s) and r = g^2 - h(s)^2 for a
polynomial g > 0, |g - h(s)| <= |r|/min g.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, arb_poly

from numerics.plane.polynomial import integral_bound, least, total
from numerics.plane.series import poly_force
from numerics.plane.system import System

Polynomials = tuple[arb_poly, ...]


class Curve(NamedTuple):
    """A piece of the path: the time in the piece of force, q1, v2, s, z by axes, on [0, 1]; `impulse` is f dt/dx."""

    piece: int
    t: arb_poly
    q1: Polynomials
    v2: Polynomials
    s: Polynomials
    z: Polynomials
    impulse: Polynomials


class Defect(NamedTuple):
    """What a curve adds to N, and the loads along it with what they are off beside what N says."""

    norm: arb
    load: list[arb_poly]
    load_error: list[arb]


def defect(system: System, curve: Curve, friction_off: list[arb]) -> Defect:
    """Return the defect of a curve; friction_off: bounds on int |impulse - f dt|, f in dh(s), by axes."""
    drive, rate = system.pieces[curve.piece], curve.t.derivative()
    u, u_off = poly_force(drive, curve.t, max(system.degree, curve.q1[0].length()) + 2)
    v1 = [x + y for x, y in zip(curve.v2, curve.s, strict=True)]
    norm, passed = arb(0), integral_bound(rate)
    for i in system.axes:
        d0 = curve.q1[i].derivative() - v1[i] * rate
        push = system.push(u, curve.q1, v1, i)
        d1 = v1[i].derivative() * system.m1[i] - push * rate + curve.impulse[i]
        d2 = curve.v2[i].derivative() * system.m2[i] - curve.impulse[i]
        norm += system.spring[i] * integral_bound(d0)
        norm += (integral_bound(d1) + passed * u_off[i] + friction_off[i]) / system.root_m1[i]
        norm += (integral_bound(d2) + friction_off[i]) / system.root_m2[i]
    load = system.load(u, curve.q1, v1)
    return Defect(norm.upper(), load, [x * y for x, y in zip(system.share, u_off, strict=True)])


def square_of(b_squared: list[arb], s: Polynomials) -> arb_poly:
    """Return h(s)^2."""
    return sum((x * x * b for b, x in zip(b_squared, s, strict=True)), arb_poly([0]))


def slip_defect(system: System, curve: Curve, by: arb) -> tuple[Defect, arb]:
    """Return the defect of a slip with t' = by h(s), impulse = by B^2 s, and a lower bound of h(s)."""
    drive, rate = system.pieces[curve.piece], curve.t.derivative()
    missing = rate * rate - square_of(drive.b_squared, curve.s) * (by * by)
    slowest = least(rate)
    if not slowest > 0:
        return Defect(arb("inf"), [], []), arb(0)
    off = integral_bound(missing) / slowest
    found = defect(system, curve, [b * off for b in drive.b])
    return found, ((slowest - total(missing) / slowest) / by).lower()


def onset_defect(system: System, curve: Curve, slip: Polynomials, size: arb_poly, duration: arb) -> tuple[Defect, arb]:
    """Return the defect of a beginning slip, s = (duration x)^m S, size about h(S); and a lower bound of h(S)."""
    drive, smallest = system.pieces[curve.piece], least(size)
    if not smallest > 0:
        return Defect(arb("inf"), [], []), arb(0)
    missing = total(size * size - square_of(drive.b_squared, slip)) / smallest
    off = []
    for b, root, s, impulse in zip(drive.b_squared, drive.b, slip, curve.impulse, strict=True):
        gap = integral_bound(impulse * size - s * (b * duration)) / smallest
        off.append(gap + root * missing / smallest * duration)
    return defect(system, curve, off), (smallest - missing).lower()
