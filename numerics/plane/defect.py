"""What a polynomial motion lacks to be one, bounded in balls: by the defect theorem it is what it is off, at most.

A curve with q1' = v1 + d0, M1 v1' = u - A1 v1 - A2 q1 - f + d1, M2 v2' = f + d2, f in dh(s), leaves the motion from
the same start by N <= int |A2^1/2 d0| + |M1^-1/2 d1| + |M2^-1/2 d2|, across all events. On 0 <= x <= 1 everything
here is a polynomial, the defects too: no remainder is estimated.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, arb_poly

from numerics.plane.polynomial import integral_bound, least, total
from numerics.plane.series import CurveStep
from numerics.plane.system import System
from numerics.plane.vector import Vector


class Defect(NamedTuple):
    """What a curve adds to N; loads along it, and what they are off."""

    norm: arb
    load: Vector
    load_error: Vector


def defect(system: System, step: CurveStep, friction_off: Vector) -> Defect:
    """Return the defect of a curve; friction_off: bounds on int |impulse - f dt|, f in dh(s), by axes."""
    curve, (u, u_off) = step.curve, force_along(system, step)
    rate, v1 = curve.t.derivative(), curve.v1
    push = system.push(u, curve.q1, v1)
    slopes = (part.each(arb_poly.derivative) for part in (curve.q1, v1, curve.v2))
    owed = v1 * rate, push * rate - step.impulse, step.impulse
    masses = (Vector([1] * system.n), system.m1, system.m2)
    d0, d1, d2 = ((slope * m - due).each(integral_bound) for slope, m, due in zip(slopes, masses, owed, strict=True))
    d1 = d1 + u_off * integral_bound(rate)
    norm = system.norm(d0, (d1 + friction_off) / system.m1, (d2 + friction_off) / system.m2)
    return Defect(norm, push * system.share, system.share * u_off)


def force_along(system: System, step: CurveStep) -> tuple[Vector, Vector]:
    """Return u(t(x)) as polynomials on [0, 1], and bounds on what they are off, by axes.

    A cosine and a sine are polynomials that may be anything; their defect bounds their errors.
    """
    drive, t, errors = system.pieces[step.curve.piece], step.curve.t, system.still
    for (omega, _, amplitudes), (s, c), (sine, cosine) in zip(drive.sines, step.swing, drive.swing(t[0]), strict=True):
        turn = t.derivative() * omega
        off = (c[0] - cosine).abs_upper() + (s[0] - sine).abs_upper()
        off += integral_bound(c.derivative() + turn * s) + integral_bound(s.derivative() - turn * c)
        errors = (errors + abs(amplitudes) * off).each(arb.upper)
    return drive.force(t, step.swing), errors


def slip_defect(system: System, step: CurveStep, slip: Vector, size: arb_poly) -> tuple[Defect, arb]:
    """Return the defect of a slip along S, size g about h(S), and a lower bound of h(S), 0 if there is none.

    With r = g^2 - h(S)^2: |impulse - f t'| <= |impulse g - B^2 S t'|/g + b (t'/g) |r|/g, and |g - h(S)| <= |r|/g.
    """
    drive, rate, smallest = system.pieces[step.curve.piece], step.curve.t.derivative(), least(size)
    if not smallest > 0:
        return Defect(arb("inf"), system.still, system.still), arb(0)
    missing = size * size - slip * slip @ drive.b_squared
    off = drive.b * (integral_bound(missing) * total(rate) / smallest)
    off = (off + (step.impulse * size - slip * drive.b_squared * rate).each(integral_bound)) / smallest
    return defect(system, step, off), (smallest - total(missing) / smallest).lower()
