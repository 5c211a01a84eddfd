"""The direction in which a slip ends: it runs down psi(e) = h(e) - Lam.e on e.kap^-1 e = 1, to f - Lam = psi kap^-1 e.

With Lam outside K a slip gets to s = 0 only if e is near a minimum e* with psi(e*) > 0. All e within a of e* are drawn
to it, and psi > 0 there, if the matrix D^2 h - (psi* + psi)/2 kap^-1, with something added along kap^-1 e*, is positive
for all of them: e* - e grows shorter then, and |s| falls at the rate psi.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_mat

from numerics.plane.system import Balls, Drive, System

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
    return [x + arb(0, (change + y).upper()) for x, y in zip(e, off, strict=True)]


def hessian(drive: Drive, e: Sequence[arb], f: Balls, size: arb) -> list[Balls]:
    """Return D^2 h(e)."""
    n = range(len(e))
    return [[((drive.b_squared[i] if i == j else 0) - f[i] * f[j]) / size for j in n] for i in n]


def drawn_to(system: System, drive: Drive, load: Balls, s: Balls) -> tuple[Balls, arb] | None:
    """Return the direction in which a slip passes through s = 0 and its least psi, None if it may turn instead."""
    inverse = [1 / k for k in system.kappa]
    e = [x.mid() for x in _critical(system, drive, load, s)]
    length = sum((c * x * x for c, x in zip(inverse, s, strict=True)), arb(0)).sqrt()
    far = sum((c.sqrt() * abs(x / length - y) for c, x, y in zip(inverse, s, e, strict=True)), arb(0))
    a = (2 * far + arb(1) / 32).upper()  # twice: what the path may be off
    wide = [x + arb(0, (a / c.sqrt()).upper()) for x, c in zip(e, inverse, strict=True)]
    f, size = drive.friction(wide)
    psi = sum(((x - y) * z for x, y, z in zip(f, load, wide, strict=True)), arb(0))
    if not (psi > 0 and a < 1):
        return None
    if system.n > 1:
        bent, much = hessian(drive, wide, f, size), 4 * psi.mid()
        normal = [c * x for c, x in zip(inverse, e, strict=True)]
        taken = psi + much * a * a / 4
        rows = [
            [bent[i][j] + much * normal[i] * normal[j] - (taken * inverse[i] if i == j else 0) for j in system.axes]
            for i in system.axes
        ]
        minors = [arb_mat([row[:k] for row in rows[:k]]).det() for k in range(1, system.n + 1)]
        if not all(one > 0 for one in minors):
            return None
    ends = sum((x * x for x in e), arb(0)).sqrt()
    return [x / ends for x in e], psi.lower()
