"""How a slip begins where the load is outside K: s = tau S(tau), tau the time since; S is analytic.

With H = D^2 h(S_0):   ((k+1) kap^-1 + H) S_k = Lam_k - (what is known of f_k).
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb

from numerics.plane.series import Point, convolved, force_series
from numerics.plane.system import Balls, System


class Onset(NamedTuple):
    """Coefficients by tau of q1, v2, S by axes, and of h(S): s = tau S, tau^2 S where it begins at the edge, or S."""

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


def onset(system: System, at: Point, load: Balls, degree: int) -> Onset:
    """Return the series of a slip from s = 0 at a point where the load is outside K."""
    drive, axes = system.pieces[at.piece], system.axes
    q1, v2, v1 = [[x] for x in at.q1], [[x] for x in at.v2], [[x] for x in at.v2]
    friction, u = _Friction(drive.b_squared), force_series(drive, at.t, degree)
    inverse = [1 / one for one in system.kappa]
    start, f = first_slip(system, drive.b_squared, load)
    for one, value in zip(friction.slip, start, strict=True):
        one.append(value)
    friction.keep(0, f, drive.friction(start)[1])
    for k in range(1, degree):
        for i in axes:
            q1[i].append((v1[i][k - 1] / k).mid())
            v2[i].append((friction.f[i][k - 1] / (system.m2[i] * k)).mid())
            v1[i].append((v2[i][k] + friction.slip[i][k - 1]).mid())
        now = system.load([one[k] for one in u], [one[k] for one in q1], [one[k] for one in v1])
        _next(friction, drive.b_squared, inverse, now, k)
    return Onset(q1, v2, friction.slip, friction.size)


def first_slip(system: System, b_squared: Balls, load: Balls) -> tuple[Balls, Balls]:
    """Return S_0 = kap (Lam - f_0) and f_0, the point of K nearest to Lam."""

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


def _next(friction: _Friction, b_squared: Balls, inverse: Balls, load: Balls, k: int) -> None:
    """Add S_k: (D - g g^T/h^3) S_k = r with D = (k+1) kap^-1 + B^2/h and g = B^2 S_0."""
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
