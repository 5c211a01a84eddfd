"""The direction in which a slip ends: it runs down psi(e) = h(e) - Lam.e on e.kap^-1 e = 1, to f - Lam = psi kap^-1 e.

With Lam outside K a slip gets to s = 0 only if e is near a minimum e* with psi(e*) > 0. Then it gets there if no e goes
farther from e* than a, which is so if the matrix D^2 h - (psi* + psi)/2 kap^-1 - |r|/a kap^-1, with something added
along n = kap^-1 e*, is positive for all of them and all loads in question: for d = e - e*, dt = |s| dsigma,

    -(|d|^2)'/2 = d.[D^2 h - (psi* + psi)/2 kap^-1] d + r.d,   n.d = -|d|^2/2,   r = f(e*) - Lam - psi* kap^-1 e*,

D^2 h a mean over the way from e* to e, psi* = psi(e*); e* need not be critical, nor the same for all loads.
"""

from __future__ import annotations

from flint import arb, arb_mat

from numerics.plane.system import Drive, System
from numerics.plane.vector import Vector, wide

_STEPS = 60


def end_direction(system: System, drive: Drive, load: Vector, s: Vector) -> Vector:
    """Return the unit direction of a slip where it ends; round: along the load."""
    found = _critical(system, drive, load, s)
    return Vector(found / (found @ found).sqrt())


def _critical(system: System, drive: Drive, load: Vector, s: Vector) -> Vector:
    """Return the critical e that Newton's method finds from s, e.kap^-1 e = 1; its radius is the last change.

    An iteration without a proof: the direction of an end is no more than that. Without a load it is s itself.
    """
    inverse, n = 1 / system.kappa, system.n
    start = e = Vector(s / system.length(s)).each(arb.mid)
    change, middle = arb(0), load.each(arb.mid)
    for _ in range(_STEPS):
        f, size = drive.friction(e)
        psi = ((f - middle) @ e).mid()
        normal = inverse * e
        bent = hessian(drive, f, size, inverse * psi)
        rows = [[*row, -x] for row, x in zip(bent, normal, strict=True)] + [[*(normal * 2), arb(0)]]
        gap = [*(f - middle - normal * psi), normal @ e - 1]
        try:
            matrix = arb_mat([[x.mid() for x in row] for row in rows])
            moved = matrix.solve(arb_mat([[x.mid()] for x in gap]))
        except ZeroDivisionError:
            return start
        step = Vector(moved[i, 0] for i in range(n))
        before, e = change, Vector(e - step).each(arb.mid)
        change = max(abs(step).each(arb.upper), key=lambda one: one)
        if change < arb((1, 8 - system.bits)) or (before and change >= before and change < arb((1, -system.bits // 2))):
            break
    if not system.length(e - start) ** 2 < 0.5:
        return start
    inverted = matrix.inv()  # how far the critical point moves with the load, to first order, twice
    radii = load.each(arb.rad)
    off = Vector(abs(Vector(inverted[i, j] for j in range(n))) @ radii for i in range(n))
    return Vector(wide(e, off * 2 + change))


def hessian(drive: Drive, f: Vector, size: arb, less: Vector) -> list[Vector]:
    """Return D^2 h where h is a size, without a diagonal matrix."""
    n = range(len(f))
    rows = (Vector(drive.b_squared[i] if i == j else arb(0) for j in n) - f * f[i] for i in n)
    return [Vector(x - (less[i] if i == j else 0) for j, x in enumerate(row / size)) for i, row in enumerate(rows)]


def drawn_to(system: System, drive: Drive, load: Vector, s: Vector) -> arb | None:
    """Return the least psi with which a slip surely gets to s = 0, None if it may turn instead.

    `load`: the loads from a time on at which s points in a direction of these, until it is there; enclosures.
    """
    inverse, root = 1 / system.kappa, system.apart
    e = _critical(system, drive, load, s.each(arb.mid)).each(arb.mid)
    e = Vector(e / system.length(e))
    a = (abs(s / system.length(s) - e) @ (1 / root) * 2).upper()
    around = wide(e, root * a)
    (f, size), (end, _) = drive.friction(around), drive.friction(e)
    psi = size - load @ around
    if not (psi > 0 and a < 1):
        return None
    normal = inverse * e
    r = abs(end - load - normal * ((end - load) @ e)) @ root
    much = 4 * psi.mid()
    rows = hessian(drive, f, size, inverse * (psi + much * a * a / 4 + r / a))
    rows = [row + normal * (much * x) for row, x in zip(rows, normal, strict=True)]
    minors = [arb_mat([row[:k] for row in rows[:k]]).det() for k in range(1, system.n + 1)]
    return psi.lower() if system.n == 1 or all(one > 0 for one in minors) else None
