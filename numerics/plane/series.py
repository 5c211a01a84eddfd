"""Taylor coefficients of stick and of slip; a slip's own clock makes its end, and every reversal, regular.

In slip dt = h(s) dsigma, h(s) = |B s|: then f dt = B^2 s dsigma, and

    q1' = h v1,   M2 v2' = B^2 s,   s' = M1^-1 (h (u - A2 q1 - A1 v1)) - kap B^2 s,   t' = h

is analytic wherever s != 0, and s = 0 is at infinity: no step runs past it. Numbers are points here; what they are off
is seen in the defect (defect.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul
from typing import NamedTuple

from flint import arb, arb_series

from numerics.plane.system import Drive, System
from numerics.plane.vector import Vector

Coefficients = list[arb]


class Point(NamedTuple):
    """A point of the path: the piece, the time in it, q1, v2, s = v1 - v2 and z = q1 - q2, as exact numbers."""

    piece: int
    t: arb
    q1: Vector
    v2: Vector
    s: Vector
    z: Vector

    @property
    def v1(self) -> Vector:
        """Return the velocity of body 1."""
        found: Vector = self.v2 + self.s
        return found


class Series(NamedTuple):
    """Coefficients by axes of q1 and v2, of S, s = S or a power of the time times S, and of h(S)."""

    q1: Sequence[Coefficients]
    v2: Sequence[Coefficients]
    slip: Sequence[Coefficients]
    size: Coefficients


def convolved(one: Sequence[arb], two: Sequence[arb], k: int) -> arb:
    """Return the coefficient k of a product."""
    return sum(map(mul, one[: k + 1], two[k::-1]), arb(0))


def squared(one: Sequence[arb], k: int, first: int = 0) -> arb:
    """Return the coefficient k of a square, without the terms in one[j], j < first, and those they mirror."""
    half = sum(map(mul, one[first : (k + 1) // 2], one[k - first : k // 2 : -1]), arb(0))
    return 2 * half if k % 2 else 2 * half + one[k // 2] * one[k // 2]


class Forcing:
    """The coefficients of u(t(x)), one after the other."""

    def __init__(self, drive: Drive, t: Coefficients) -> None:
        """Begin with coefficient 0 of t, a list that grows."""
        self.drive, self.t = drive, t
        self.swing = [([s.mid()], [c.mid()]) for s, c in drive.swing(t[0])]
        self.powers: list[Coefficients] = [t, *([] for _ in drive.polynomial[2:])]

    def next(self, k: int) -> Vector:
        """Return coefficient k of u, when t has its coefficients up to k and the swing has."""
        found = self.drive.still(self.t[0])
        for below, power in zip(self.powers, self.powers[1:], strict=False):
            power.append(convolved(below, self.t, k))
        for one, power in zip(self.drive.polynomial, [[arb(k == 0)] * (k + 1), *self.powers], strict=False):
            found += one * power[k]
        for (*_, amplitudes), (sines, _) in zip(self.drive.sines, self.swing, strict=True):
            found += amplitudes * sines[k]
        return found.each(arb.mid)

    def swing_on(self, k: int, rate: Coefficients) -> None:
        """Append coefficient k + 1 of each sine and cosine; `rate` are the coefficients of t'."""
        for (omega, _, _), (sines, cosines) in zip(self.drive.sines, self.swing, strict=True):
            s, c = convolved(sines, rate, k), convolved(cosines, rate, k)
            cosines.append((-omega * s / (k + 1)).mid())
            sines.append((omega * c / (k + 1)).mid())


def slip_series(system: System, at: Point, degree: int) -> Series:
    """Return the coefficients of a slip by sigma."""
    drive, axes, rate = system.pieces[at.piece], system.axes, list[arb]()
    t, (q1, v2, s) = [at.t], ([[x] for x in one] for one in (at.q1, at.v2, at.s))
    v1, pushes = ([list[arb]() for _ in axes] for _ in range(2))
    forcing = Forcing(drive, t)
    for k in range(degree):
        square = sum((b * squared(one, k) for b, one in zip(drive.b_squared, s, strict=True)), arb(0))
        if k:
            rate.append(((square - squared(rate, k, 1)) / (2 * rate[0])).mid())
        else:
            rate.append(square.sqrt().mid())
        t.append((rate[k] / (k + 1)).mid())
        for one, x, y in zip(v1, v2, s, strict=True):
            one.append((x[k] + y[k]).mid())
        now_q, now_v = (Vector(x[k] for x in one) for one in (q1, v1))
        for i, push in enumerate(system.push(forcing.next(k), now_q, now_v)):
            pushes[i].append(push.mid())
            given = drive.b_squared[i] * s[i][k]
            taken = convolved(pushes[i], rate, k)
            s[i].append((((taken - given) / system.m1[i] - given / system.m2[i]) / (k + 1)).mid())
            v2[i].append((given / (system.m2[i] * (k + 1))).mid())
            q1[i].append((convolved(v1[i], rate, k) / (k + 1)).mid())
        forcing.swing_on(k, rate)
    return Series(q1, v2, s, rate)


def linear_series(system: System, at: Point, friction: Sequence[arb | None], degree: int) -> Series:
    """Return the coefficients by time (s) where friction on an axis is constant, or (None) holds it at rest."""
    drive, rows = system.pieces[at.piece], [(at.q1, at.v2, at.s)]
    u = drive.force(arb_series([at.t, 1], degree))
    slips = Vector(arb(f is not None) for f in friction)
    for k in range(degree):
        q1, v2, s = rows[-1]
        load = system.load(u.order(k), q1, v2 + s)
        given = Vector(x if f is None else f * (k == 0) for x, f in zip(load, friction, strict=True))
        after = (v2 + s, given / system.m2, (load - given) * system.kappa * slips)
        rows.append(tuple((one / (k + 1)).each(arb.mid) for one in after))
    parts = ([list(one) for one in zip(*part, strict=True)] for part in zip(*rows, strict=True))
    return Series(*parts, [])  # type: ignore[call-arg]
