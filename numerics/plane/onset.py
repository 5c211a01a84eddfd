"""How a slip begins: s = tau^m S(tau), tau the time since. Outside K m = 1, and S is analytic; at its edge m = 2.

There S is a divergent series (its equation is singular at tau = 0, irregularly): it is cut before its least term, and
the defect says how good that is. Orders of kap^-1 s' = Lam - f(S), with H = D^2 h(S_0):

    m = 1:   ((k+1) kap^-1 + H) S_k = Lam_k - (what is known of f_k)
    m = 2:   H S_k = Lam_k - (what is known of f_k) - (k+1) kap^-1 S_{k-1};   H n = 0 gives the part of S_{k-1} along n.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb

from numerics.plane.series import Forcing, Point, convolved
from numerics.plane.system import Balls, System


class Onset(NamedTuple):
    """Coefficients by tau of q1, v2, S (of s = tau^m S) by axes, and of h(S)."""

    q1: list[Balls]
    v2: list[Balls]
    slip: list[Balls]
    size: Balls


class _Friction:
    """The series of f = B^2 S/h(S), order by order, and of h(S)."""

    def __init__(self, b_squared: Balls) -> None:
        self.b_squared, self.axes = b_squared, range(len(b_squared))
        self.slip: list[Balls] = [[] for _ in self.axes]
        self.f: list[Balls] = [[] for _ in self.axes]
        self.size: Balls = []

    def order(self, k: int) -> tuple[Balls, arb]:
        """Return coefficient k >= 1 of f and of h(S) from the S that stand."""
        square = sum((b * convolved(s, s, k) for b, s in zip(self.b_squared, self.slip, strict=True)), arb(0))
        size = ((square - convolved(self.size, self.size, k, 1)) / (2 * self.size[0])).mid()
        sizes, found = [*self.size[:k], size], []
        for b, s, f in zip(self.b_squared, self.slip, self.f, strict=True):
            known = convolved([*f[:k], arb(0)], sizes, k)
            found.append(((b * s[k] - known) / self.size[0]).mid())
        return found, size

    def keep(self, k: int, f: Balls, size: arb) -> None:
        for one, value in zip(self.f, f, strict=True):
            one[k:] = [value.mid()]
        self.size[k:] = [size.mid()]


def onset(system: System, at: Point, load: Balls, m: int, degree: int) -> Onset:
    """Return the series of a slip from s = 0 at a point where the load is outside K (m = 1) or leaves it (m = 2)."""
    drive, axes = system.pieces[at.piece], system.axes
    q1, v2, t = [[x] for x in at.q1], [[x] for x in at.v2], [at.t]
    v1 = [[x] for x in at.v2]
    forcing, friction = Forcing(drive, t), _Friction(drive.b_squared)
    inverse = [1 / one for one in system.kappa]
    forcing.next(0)
    start, f = first_slip(system, drive.b_squared, load, m)
    for one, value in zip(friction.slip, start, strict=True):
        one.append(value)
    friction.keep(0, f, drive.friction(start)[1])
    for k in range(1, degree):
        t.append(arb(1) if k == 1 else arb(0))
        forcing.swing_on(k - 1, [arb(1)] + [arb(0)] * k)
        u = forcing.next(k)
        for i in axes:
            q1[i].append((v1[i][k - 1] / k).mid())
            v2[i].append((friction.f[i][k - 1] / (system.m2[i] * k)).mid())
            v1[i].append((v2[i][k] + (friction.slip[i][k - m] if k >= m else 0)).mid())
        now = system.load(u, [one[k] for one in q1], [one[k] for one in v1])
        (_at_once if m == 1 else _at_edge)(friction, drive.b_squared, inverse, now, k)
    return Onset(q1, v2, friction.slip, friction.size)


def first_slip(system: System, b_squared: Balls, load: Balls, m: int) -> tuple[Balls, Balls]:
    """Return S_0 and f_0: outside K kap (Lam - f_0), f_0 nearest to Lam; at the edge the normal, to be scaled."""
    if m == 2:
        strain = sum((x * x / b for x, b in zip(load, b_squared, strict=True)), arb(0)).sqrt()
        return [(x / b).mid() for x, b in zip(load, b_squared, strict=True)], [x / strain for x in load]

    def slip(size: arb) -> Balls:
        return [x / (1 / k + b / size) for x, k, b in zip(load, system.kappa, b_squared, strict=True)]

    def missing(size: arb) -> arb:
        return sum((b * x * x for b, x in zip(b_squared, slip(size), strict=True)), arb(0)).sqrt() - size

    low, high = (
        arb(0),
        sum((b * k * k * x * x for b, k, x in zip(b_squared, system.kappa, load, strict=True)), arb(0)).sqrt(),
    )
    high = high.mid() * 2
    one = high / 2
    for _ in range(4 * system.bits):
        gap = missing(one).mid()
        low, high = (one, high) if gap > 0 else (low, one)
        step = high * arb((1, -(system.bits // 2)))
        slope = (missing(one + step) - gap) / step
        after = (one - gap / slope).mid()
        after = after if low < after < high else ((low + high) / 2).mid()
        if abs(after - one) <= abs(one) * arb((1, 4 - system.bits)):
            break
        one = after
    found = [x.mid() for x in slip(one)]
    return found, [b * x / one for b, x in zip(b_squared, found, strict=True)]


def _at_once(friction: _Friction, b_squared: Balls, inverse: Balls, load: Balls, k: int) -> None:
    """Add S_k outside K: (D - g g^T/h^3) S_k = r with D = (k+1) kap^-1 + B^2/h and g = B^2 S_0."""
    for one in friction.slip:
        one.append(arb(0))
    known, size = friction.order(k)
    whole = friction.size[0]
    diagonal = [(k + 1) * c + b / whole for c, b in zip(inverse, b_squared, strict=True)]
    g = [b * one[0] for b, one in zip(b_squared, friction.slip, strict=True)]
    r = [x - y for x, y in zip(load, known, strict=True)]
    bent = sum((x * y / d for x, y, d in zip(g, r, diagonal, strict=True)), arb(0))
    room = whole**3 - sum((x * x / d for x, d in zip(g, diagonal, strict=True)), arb(0))
    for i, one in enumerate(friction.slip):
        one[k] = ((r[i] + g[i] * bent / room) / diagonal[i]).mid()
    size = size + sum((x * one[k] for x, one in zip(g, friction.slip, strict=True)), arb(0)) / whole
    f = [x - (k + 1) * c * one[k] for x, c, one in zip(load, inverse, friction.slip, strict=True)]
    friction.keep(k, f, size)


def _at_edge(friction: _Friction, b_squared: Balls, inverse: Balls, load: Balls, k: int) -> None:
    """Add the part of S_{k-1} along n, and the rest of S_k, where the load leaves K."""
    slip = friction.slip
    if k == 1:
        normal = [one[0] for one in slip]
        weight = sum((n * n * c for n, c in zip(normal, inverse, strict=True)), arb(0))
        scale = sum((n * x for n, x in zip(normal, load, strict=True)), arb(0)) / (2 * weight)
        for one, n in zip(slip, normal, strict=True):
            one[0] = (n * scale).mid()
        friction.keep(0, [one[0] for one in friction.f], friction.size[0] * scale)
    else:
        normal = [one[0] for one in slip]
        for one in slip:
            one.append(arb(0))
        known, _ = friction.order(k)
        left = arb(0)
        for n, c, x, y, one in zip(normal, inverse, load, known, slip, strict=True):
            left += n * (x - y - (k + 1) * c * one[k - 1])
        by = left / ((k + 1) * sum((n * n * c for n, c in zip(normal, inverse, strict=True)), arb(0)))
        for one, n in zip(slip, normal, strict=True):
            one[k - 1] = (one[k - 1] + by * n).mid()
        friction.size[k - 1] = (friction.size[k - 1] + by * friction.size[0]).mid()
    for one in slip:
        one[k:] = [arb(0)]
    known, size = friction.order(k)
    r = [x - y - (k + 1) * c * one[k - 1] for x, y, c, one in zip(load, known, inverse, slip, strict=True)]
    along = sum((n[0] * y for n, y in zip(slip, r, strict=True)), arb(0))
    square = sum((one[0] * one[0] for one in slip), arb(0))
    for b, one, y in zip(b_squared, slip, r, strict=True):
        one[k] = (friction.size[0] * (y - along * one[0] / square) / b).mid()
    f = [x - (k + 1) * c * one[k - 1] for x, c, one in zip(load, inverse, slip, strict=True)]
    friction.keep(k, f, size)
