"""The direction in which a slip ends: it runs down psi(e) = h(e) - Lam.e on e.kap^-1 e = 1, to f - Lam = psi kap^-1 e.

Where psi > 0, as for every e if Lam is inside K, a slip gets to s = 0. If s points near some e* then, no e goes farther
from e* than a if the matrix D^2 h - (psi* + psi)/2 kap^-1 - |r|/a kap^-1, with something added along n = kap^-1 e*, is
positive for all of them and all loads in question: for d = e - e*, dt = |s| dsigma,

    -(|d|^2)'/2 = d.[D^2 h - (psi* + psi)/2 kap^-1] d + r.d,   n.d = -|d|^2/2,   r = f(e*) - Lam - psi* kap^-1 e*,

D^2 h a mean over the way from e* to e, psi* = psi(e*); e* need not be critical, nor the same for all loads. Then the
slip ends at a critical e among these, and a step of interval Newton encloses all that are.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, arb_mat

from numerics.plane.system import PlaneDrive, System
from numerics.plane.vector import Vector, wide


class Drawn(NamedTuple):
    """The least psi on the way of a slip to s = 0, and all directions e that it may have on it, e.kap^-1 e = 1."""

    psi: arb
    around: Vector


def end_direction(system: System, drive: PlaneDrive, load: Vector, drawn: Drawn | None) -> Vector:
    """Return the unit direction of a slip where it ends; in [-1, 1] where it is not known."""
    if drawn is None:
        return Vector([arb(0, 1)] * system.n)
    e, psi = drawn.around, drive.friction(drawn.around)[1] - load @ drawn.around
    try:
        for _ in range(system.bits.bit_length()):
            found, least = _newton(system, drive, load, e, psi)
            e, psi = Vector(x.intersection(y) for x, y in zip(e, found, strict=True)), psi.intersection(least)
    except ZeroDivisionError:  # all that is known is that it is drawn there
        pass
    return Vector(e / (e @ e).sqrt())


def _newton(system: System, drive: PlaneDrive, load: Vector, e: Vector, psi: arb) -> tuple[Vector, arb]:
    """Return where all solutions of f(e) - Lam = psi kap^-1 e, e.kap^-1 e = 1 are that are in a ball; near a point."""
    inverse, middle, at = 1 / system.kappa, e.each(arb.mid), psi.mid()
    f, size = drive.friction(e)
    bent = hessian(drive, f, size, inverse * psi)
    rows = [[*row, -x] for row, x in zip(bent, inverse * e, strict=True)] + [[*(inverse * e), arb(0)]]
    gap = [*(drive.friction(middle)[0] - load - inverse * middle * at), (system.length(middle) ** 2 - 1) / 2]
    moved = arb_mat(rows).solve(arb_mat([[x] for x in gap]))
    return Vector(x - moved[i, 0] for i, x in enumerate(middle)), at - moved[system.n, 0]


def diagonal(numbers: Vector) -> Vector:
    """Return a diagonal matrix."""
    return Vector(Vector(x if i == j else arb(0) for j in range(len(numbers))) for i, x in enumerate(numbers))


def square(v: Vector) -> Vector:
    """Return the matrix v v^T."""
    return Vector(v * x for x in v)


def hessian(drive: PlaneDrive, f: Vector, size: arb, less: Vector) -> Vector:
    """Return D^2 h where h is a size, without a diagonal matrix."""
    found: Vector = (diagonal(drive.b_squared) - square(f)) / size - diagonal(less)
    return found


def drawn_to(system: System, drive: PlaneDrive, load: Vector, s: Vector) -> Drawn | None:
    """Return how a slip surely gets to s = 0, None if it may turn instead.

    `load`: the loads from a time on at which s points in a direction of these, until it is there; enclosures.
    """
    inverse, root = 1 / system.kappa, system.apart
    e = Vector(s / system.length(s)).each(arb.mid)
    a = (abs(s / system.length(s) - e) @ (1 / root) * 2).upper()
    around = wide(e, root * a)
    (f, size), (end, _) = drive.friction(around), drive.friction(e)
    psi = size - load @ around
    if not (a < 1 and (psi > 0 or drive.strain(load, system.axes) < 1)):
        return None
    normal = inverse * e
    r = abs(end - load - normal * ((end - load) @ e)) @ root
    taken = psi + r / a
    much = 4 * abs(taken).upper()
    rows = hessian(drive, f, size, inverse * (taken + much * a * a / 4)) + square(normal) * much
    minors = [arb_mat([row[:k] for row in rows[:k]]).det() for k in range(1, system.n + 1)]
    return Drawn(psi.lower(), around) if all(one > 0 for one in minors) else None
