"""The direction in which a slip ends: it runs down psi(e) = h(e) - Lam.e on e.kap^-1 e = 1, to f - Lam = psi kap^-1 e.

With Lam outside K a slip gets to s = 0 only if e is near a minimum e* with psi(e*) > 0. Then it gets there if no e goes
farther from e* than a, which is so if the matrix D^2 h - (psi* + psi)/2 kap^-1 - |r|/a kap^-1, with something added
along n = kap^-1 e*, is positive for all of them and all loads in question: for d = e - e*, dt = |s| dsigma,

    -(|d|^2)'/2 = d.[D^2 h - (psi* + psi)/2 kap^-1] d + r.d,   n.d = -|d|^2/2,   r = f(e*) - Lam - psi* kap^-1 e*,

D^2 h a mean over the way from e* to e, psi* = psi(e*); e* need not be critical, nor the same for all loads.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_mat

from numerics.plane.system import Balls, Drive, System
from numerics.plane.window import wide

_STEPS = 60


def end_direction(system: System, drive: Drive, load: Balls, s: Balls) -> Balls:
    """Return the unit direction of a slip where it ends; round: along the load."""
    found = _critical(system, drive, load, s)
    length = sum((x * x for x in found), arb(0)).sqrt()
    return [x / length for x in found]


def _critical(system: System, drive: Drive, load: Balls, s: Balls) -> Balls:
    """Return the critical e that Newton's method finds from s, e.kap^-1 e = 1; its radius is the last change.

    An iteration without a proof: the direction of an end is no more than that. Without a load it is s itself.
    """
    inverse = [1 / k for k in system.kappa]
    length = sum((c * x * x for c, x in zip(inverse, s, strict=True)), arb(0)).sqrt()
    start = e = [(x / length).mid() for x in s]
    change = arb(0)
    for _ in range(_STEPS):
        f, size = drive.friction(e)
        psi = sum(((x - y.mid()) * z for x, y, z in zip(f, load, e, strict=True)), arb(0)).mid()
        bent = hessian(drive, e, f, size)
        n = system.n
        rows = [
            [bent[i][j] - (psi * inverse[i] if i == j else 0) for j in range(n)] + [-inverse[i] * e[i]]
            for i in range(n)
        ]
        rows.append([2 * c * x for c, x in zip(inverse, e, strict=True)] + [arb(0)])
        gap = [f[i] - load[i].mid() - psi * inverse[i] * e[i] for i in range(n)]
        gap.append(sum((c * x * x for c, x in zip(inverse, e, strict=True)), arb(0)) - 1)
        try:
            matrix = arb_mat([[x.mid() for x in row] for row in rows])
            moved = matrix.solve(arb_mat([[x.mid()] for x in gap]))
        except ZeroDivisionError:
            return start
        before, e = change, [(x - moved[i, 0]).mid() for i, x in enumerate(e)]
        change = max((abs(moved[i, 0]).upper() for i in range(n)), key=lambda one: one)
        if change < arb((1, 8 - system.bits)) or (before and change >= before and change < arb((1, -system.bits // 2))):
            break
    far = sum((c * (x - y) * (x - y) for c, x, y in zip(inverse, e, start, strict=True)), arb(0))
    if not far < 0.5:
        return start
    bent = matrix.inv()  # how far the critical point moves with the load, to first order, twice
    off = [2 * system.row_sum([bent[i, j] for j in range(system.n)], [x.rad() for x in load]) for i in range(system.n)]
    return [wide(x, change + y) for x, y in zip(e, off, strict=True)]


def hessian(drive: Drive, e: Sequence[arb], f: Balls, size: arb) -> list[Balls]:
    """Return D^2 h(e)."""
    n = range(len(e))
    return [[((drive.b_squared[i] if i == j else 0) - f[i] * f[j]) / size for j in n] for i in n]


def drawn_to(system: System, drive: Drive, load: Balls, s: Balls) -> arb | None:
    """Return the least psi with which a slip surely gets to s = 0, None if it may turn instead.

    `load`: the loads from a time on at which s points in a direction of these, until it is there; enclosures.
    """
    inverse, axes = [1 / k for k in system.kappa], system.axes

    def unit(x: Balls) -> Balls:
        length = sum((c * y * y for c, y in zip(inverse, x, strict=True)), arb(0)).sqrt()
        return [y / length for y in x]

    e = unit([x.mid() for x in _critical(system, drive, load, s)])
    far = sum((c.sqrt() * abs(x - y) for c, x, y in zip(inverse, unit(s), e, strict=True)), arb(0))
    a = (2 * far).upper()
    around = [wide(x, a / c.sqrt()) for x, c in zip(e, inverse, strict=True)]
    (f, size), (end, _) = drive.friction(around), drive.friction(e)
    psi = size - sum((x * y for x, y in zip(load, around, strict=True)), arb(0))
    if not (psi > 0 and a < 1):
        return None
    least = sum(((x - y) * z for x, y, z in zip(end, load, e, strict=True)), arb(0))
    normal = [c * x for c, x in zip(inverse, e, strict=True)]
    r = [k.sqrt() * abs(x - y - least * n) for k, x, y, n in zip(system.kappa, end, load, normal, strict=True)]
    bent, much = hessian(drive, around, f, size), 4 * psi.mid()
    taken = psi + much * a * a / 4 + sum(r, arb(0)) / a
    rows = [
        [bent[i][j] + much * normal[i] * normal[j] - (taken * inverse[i] if i == j else 0) for j in axes] for i in axes
    ]
    minors = [arb_mat([row[:k] for row in rows[:k]]).det() for k in range(1, system.n + 1)]
    if system.n > 1 and not all(one > 0 for one in minors):
        return None
    return psi.lower()
