"""Taylor coefficients of stick and of slip; a slip's own clock makes its end, and every reversal, regular.

Where friction is given, or holds an axis at rest, they are those by the time. In slip dt = h(s) dsigma, h(s) = |B s|:
then f dt = B^2 s dsigma, and

    q1' = h v1,   M2 v2' = B^2 s,   s' = M1^-1 (h (u - A2 q1 - A1 v1)) - kap B^2 s,   t' = h

is analytic wherever s != 0, and s = 0 is at infinity: no step runs past it. Nothing is proved here: the midpoints of
balls are taken, and what they are off is seen in the defect (defect.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, pairwise
from operator import mul
from typing import Any, NamedTuple

from flint import arb, arb_poly

from numerics.plane.polynomial import log2, scaled, two_to
from numerics.plane.system import PlaneDrive, System, highest
from numerics.plane.vector import Vector

_MORE = {True: 6, False: 2}
"""Terms beyond those of s with which the rest follows from it, by its own clock or not; loads are as good as these."""
Row = list[arb]
"""Coefficients, of order 0 first."""


class SeriesPoint(NamedTuple):
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

    def middle(self, system: System) -> tuple[SeriesPoint, arb, Vector]:
        """Return the midpoints; bounds on N of the radii, and on those of z."""
        q1, v2, s, z = (part.each(arb.rad) for part in self[2:])
        point = SeriesPoint(self.piece, self.t.mid(), *(part.each(arb.mid) for part in self[2:]))
        return point, system.norm(q1, s + v2, v2), z


class TaylorCurve(NamedTuple):
    """A piece of the path: the time in the piece of force, q1, v2, s, z by axes, on [0, 1]; `impulse` is f dt/dx.

    `swing`: polynomials that are about sine and cosine of each phase.
    """

    piece: int
    t: arb_poly
    q1: Vector
    v2: Vector
    s: Vector
    z: Vector
    impulse: Vector
    swing: Sequence[tuple[arb_poly, arb_poly]] = ()

    def at(self, x: arb) -> SeriesPoint:
        """Return a point of it."""
        return SeriesPoint(self.piece, self.t(x), *(part.each(lambda p: p(x)) for part in self[2:6]))


def curve_of(
    at: SeriesPoint, t: arb_poly, q1: Vector, v2: Vector, s: Vector, impulse: Vector, swing: Any
) -> TaylorCurve:
    """Return a piece of the path from a point, with z = q1 - q2 along it."""
    rate = t.derivative()
    z = Vector((x * rate).integral() + z for x, z in zip(s, at.z, strict=True))
    return TaylorCurve(at.piece, t, q1, v2, s, z, impulse, swing)


class Series(NamedTuple):
    """Coefficients by axes of q1 and v2, of S, s = S or a power of the time times S, and of h(S)."""

    q1: Sequence[Sequence[arb]]
    v2: Sequence[Sequence[arb]]
    slip: Sequence[list[arb]]
    size: list[arb]


class PlaneExpansion:
    """Taylor polynomials from a point: of a slip by its own clock sigma, else by the time, with friction that is given.

    `friction` by axes: constant where it slips, None where it holds the axis at rest. `polynomials` of s, v2, q1, t,
    sines and cosines are those of sigma/unit, a unit about a step.
    """

    def __init__(self, system: System, at: SeriesPoint, friction: Sequence[arb | None] | None = None) -> None:
        """Form the series."""
        self.system, self.at, self.friction = system, at, friction
        drive = system.pieces[at.piece]
        self.start = [*at.s, *at.v2, *at.q1, at.t, *chain(*drive.swing(at.t))]
        rate = 1 / system.period
        if friction is None:
            rate = highest(1 / drive.heavy) + drive.friction(at.s)[1] / system.period
        self.unit = two_to(-round(log2(rate)))
        rows = [[x.mid()] for x in self.start]
        expand(rows, system, drive, friction, self.unit)
        self.polynomials = [*map(arb_poly, rows)]

    def drawn(self, h: arb) -> TaylorCurve:
        """Return a step sigma = h x, 0 <= x <= 1."""
        n, polynomials = self.system.n, zip(self.polynomials, self.start, strict=True)
        found = [arb_poly([x, *scaled(one, h / self.unit).coeffs()[1:]]) for one, x in polynomials]
        s, v2, q1 = (Vector(found[k : k + n]) for k in (0, n, 2 * n))
        t, *waves = found[3 * n :]
        swing = [*zip(waves[::2], waves[1::2], strict=True)]
        if self.friction is None:
            impulse = s * (self.system.pieces[self.at.piece].b_squared * h)
        else:
            held = v2.each(arb_poly.derivative) * self.system.m2
            impulse = Vector(x if f is None else arb_poly([f * h]) for x, f in zip(held, self.friction, strict=True))
        return curve_of(self.at, t, q1, v2, s, impulse, swing)


def product(one: Row, two: Row, k: int) -> arb:
    """Return the coefficient k of the product of two rows."""
    return sum(map(mul, one[: k + 1], two[k::-1]))


def expand(
    table: list[Row], system: System, drive: PlaneDrive, friction: Sequence[arb | None] | None, unit: arb
) -> None:
    """Append coefficients of (sigma/unit)^k to rows with those of k = 0.

    Rows are n of s, v2 and q1 each, that of t, a sine and a cosine for each phase. Beyond the degree s ends, and all
    else goes on with that, as where an axis sticks.
    """
    n, own, degree = system.n, friction is None, system.degree
    s, v2, q1, t, waves = table[:n], table[n : 2 * n], table[2 * n : 3 * n], table[3 * n], table[3 * n + 1 :]
    v1, push, rate = ([Row() for _ in range(n)], [Row() for _ in range(n)], Row())
    powers = [t, *([t[0] ** p] for p in range(2, len(drive.polynomial)))]
    acting = [_acting(system, drive, i, q1, v1, powers, waves[::2]) for i in system.axes]

    def by_clock(row: Row, k: int) -> arb:
        """Return the coefficient k of what a rate by time is by the clock: the slip's own one, or the time itself."""
        return product(row, rate, k) if own else row[k]

    for k in range(degree + _MORE[own]):
        step = unit / (k + 1)
        for i in system.axes:
            v1[i].append((v2[i][k] + s[i][k]).mid())
        rate.append(_speed(drive, s, rate, k) if own else arb(k == 0))
        t.append((rate[k] * step).mid())
        for p, (before, row) in enumerate(pairwise(powers), start=2):
            row.append((by_clock(before, k) * step * p).mid())
        for i in system.axes:
            u = drive.polynomial[0][i] if k == 0 and drive.polynomial else arb(0)
            push[i].append(sum((x * row[k] for x, row in acting[i]), u).mid())
            taken = by_clock(push[i], k)
            if k < degree and (friction is None or friction[i] is not None):
                held = drive.b_squared[i] * s[i][k] if friction is None else friction[i] if k == 0 else arb(0)
                s[i].append((((taken - held) / system.m1[i] - held / system.m2[i]) * step).mid())
                v2[i].append((held / system.m2[i] * step).mid())
            else:
                s[i].append(arb(0))
                v2[i].append((taken / system.mass[i] * step).mid())
            q1[i].append((by_clock(v1[i], k) * step).mid())
        for sine, cosine, (omega, *_) in zip(waves[::2], waves[1::2], drive.sines, strict=True):
            grown, fallen = by_clock(cosine, k), by_clock(sine, k)
            sine.append((omega * grown * step).mid())
            cosine.append((-omega * fallen * step).mid())


def _acting(
    system: System, drive: PlaneDrive, i: int, q1: list[Row], v1: list[Row], powers: list[Row], sines: list[Row]
) -> list[tuple[arb, Row]]:
    """Return the rows of which the push u - A2 q1 - A1 v1 on an axis is a sum, each with its factor."""
    pairs = [(-x[i], row) for x, row in zip(system.a2, q1, strict=True)]
    pairs += [(-x[i], row) for x, row in zip(system.a1 or (), v1, strict=False)]
    pairs += [(x[i], row) for x, row in zip(drive.polynomial[1:], powers, strict=False)]
    pairs += [(wave[-1][i], row) for wave, row in zip(drive.sines, sines, strict=True)]
    return [(x, row) for x, row in pairs if x != 0]


def _speed(drive: PlaneDrive, s: list[Row], rate: Row, k: int) -> arb:
    """Return the coefficient k of h(s), given those before."""
    square = sum((b * product(row, row, k) for b, row in zip(drive.b_squared, s, strict=True)), arb(0))
    if k == 0:
        return square.sqrt().mid()
    return ((square - sum(map(mul, rate[1:], rate[:0:-1]))) / (2 * rate[0])).mid()
