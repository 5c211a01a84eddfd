"""Taylor polynomials of a path; a slip's own clock makes its end, and every reversal, regular.

Where friction is given, or holds an axis at rest, they are those by the time. In slip dt = h(s) dsigma, h(s) = |B s|:
then f dt = B^2 s dsigma, and

    q1' = h v1,   M2 v2' = B^2 s,   s' = M1^-1 (h (u - A2 q1 - A1 v1)) - kap B^2 s,   t' = h

is analytic wherever s != 0, and s = 0 is at infinity: no step runs past it. Nothing is proved here: the midpoints of
balls are taken, and what they are off is seen in the defect (defect.py).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain
from operator import mul
from typing import Any, NamedTuple

from flint import arb, arb_mat, arb_poly

from numerics.plane.polynomial import log2, scaled, two_to
from numerics.plane.system import PlaneDrive, System
from numerics.plane.vector import Vector

Friction = Sequence[arb | None]
"""Friction by axes: constant where it slips, None where it holds the axis at rest."""
_MORE = {True: 6, False: 2}
"""Terms beyond those of s with which the rest follows from it, by its own clock or not; loads are as good as these."""
_FARTHEST = 2.0**20
"""log2 of how far a series reaches that ends, as at rest."""


class Point(NamedTuple):
    """A point of the path: the piece, the time in it, q1, v2, s = v1 - v2 and z = q1 - q2 - (q1 - q2)(0).

    They are numbers; of a whole curve, polynomials on [0, 1].
    """

    piece: int
    t: Any
    q1: Vector
    v2: Vector
    s: Vector
    z: Vector

    @property
    def v1(self) -> Vector:
        """Return the velocity of body 1."""
        found: Vector = self.v2 + self.s
        return found

    def each(self, of: Callable[[Any], Any]) -> Point:
        """Return a function of each number."""
        return Point(self.piece, of(self.t), *(part.each(of) for part in self[2:]))

    def at(self, x: Any) -> Point:
        """Return the point of a curve at x."""
        return self.each(lambda p: p(x))


class Series(NamedTuple):
    """Coefficients by axes of q1 and v2, of S, s = S or a power of the time times S, and of h(S)."""

    q1: Sequence[Sequence[arb]]
    v2: Sequence[Sequence[arb]]
    slip: Sequence[list[arb]]
    size: list[arb]


class CurveStep(NamedTuple):
    """A curve, with `impulse` f dt/dx on it, and polynomials that are about sine and cosine of each phase."""

    curve: Point
    impulse: Vector
    swing: Sequence[tuple[arb_poly, arb_poly]]


def step_from(at: Point, t: arb_poly, q1: Vector, v2: Vector, s: Vector, impulse: Vector, swing: Any) -> CurveStep:
    """Return a curve from a point, with z along it."""
    rate = t.derivative()
    z = Vector((x * rate).integral() + z for x, z in zip(s, at.z, strict=True))
    return CurveStep(Point(at.piece, t, q1, v2, s, z), impulse, swing)


class Expansion:
    """Taylor polynomials from a point: of a slip by its own clock sigma, else by the time, with friction that is given.

    `polynomials`: of s, v2, q1, t, sines and cosines.
    """

    def __init__(self, system: System, at: Point, friction: Friction | None = None) -> None:
        """Form the series."""
        self.system, self.at, self.friction, drive = system, at, friction, system.pieces[at.piece]
        waves = [*chain(*drive.swing(at.t))]
        powers = [at.t**p for p in range(2, len(drive.polynomial))]
        self.start = [*at.s, *at.v2, *at.q1, at.t, *waves, *powers, arb(1)]
        rows = [[x.mid()] for x in self.start]
        expand(rows, system, drive, friction)
        self.polynomials = [*map(arb_poly, rows)]

    def reach(self, fast: arb) -> arb:
        """Return how far they reach: there the last two terms are 2^-bits of sizes, `fast` that of s."""
        system, n = self.system, self.system.n
        last, sizes = (system.degree, system.degree - 1), [fast] * n + [system.speed] * n + [system.size] * n
        found = _FARTHEST
        for p, size in zip(self.polynomials, [*sizes, system.period], strict=False):
            enough = log2(size) - system.bits
            found = min([found, *((enough - log2(p[k])) / k for k in last if p[k] != 0)])
        return two_to(found)

    def drawn(self, h: arb) -> CurveStep:
        """Return a step sigma = h x, 0 <= x <= 1."""
        n, drive = self.system.n, self.system.pieces[self.at.piece]
        given = zip(self.polynomials, self.start, strict=True)
        found = [arb_poly([x, *scaled(one, h).coeffs()[1:]]) for one, x in given]
        s, v2, q1 = (Vector(found[k : k + n]) for k in (0, n, 2 * n))
        waves = found[3 * n + 1 :][: 2 * len(drive.sines)]
        swing = [*zip(waves[::2], waves[1::2], strict=True)]
        if self.friction is None:
            impulse = s * (drive.b_squared * h)
        else:
            held = v2.each(arb_poly.derivative) * self.system.m2
            impulse = Vector(x if f is None else arb_poly([f * h]) for x, f in zip(held, self.friction, strict=True))
        return step_from(self.at, found[3 * n], q1, v2, s, impulse, swing)


def rates(system: System, drive: PlaneDrive) -> arb_mat:
    """Return the matrix of the rates by the time: u - A2 q1 - A1 v1 for s, none for v2, ...

    Rows are n of s, v2 and q1 each, t, a sine and a cosine for each phase, t^2, t^3, ... and 1.
    """
    n = system.n
    q1, t = 2 * n, 3 * n
    first = t + 1 + 2 * len(drive.sines)
    one = first + max(0, len(drive.polynomial) - 2)
    powers, found = [one, t, *range(first, one)], arb_mat(one + 1, one + 1)
    for i in system.axes:
        found[q1 + i, i] = found[q1 + i, n + i] = 1
        for j in system.axes:
            found[i, q1 + j] = -system.a2[j][i]
            if system.a1:
                found[i, j] = found[i, n + j] = -system.a1[j][i]
        for x, row in zip(drive.polynomial, powers, strict=False):
            found[i, row] = x[i]
        for j, (*_, amplitudes) in enumerate(drive.sines):
            found[i, t + 1 + 2 * j] = amplitudes[i]
    for p, row in enumerate(powers[1:], start=1):
        found[row, powers[p - 1]] = p
    for j, (omega, *_) in enumerate(drive.sines):
        sine = t + 1 + 2 * j
        found[sine, sine + 1], found[sine + 1, sine] = omega, -omega
    return found


def expand(rows: list[list[arb]], system: System, drive: PlaneDrive, friction: Friction | None) -> None:
    """Append coefficients of sigma^k to rows with the first (see `rates`).

    Beyond the degree s ends, and all else goes on with that, as where an axis sticks.
    """
    n, own, h, by_time = system.n, friction is None, [arb(1)], rates(system, drive)
    found, changes = [list[arb]() for _ in rows], [any(row) for row in by_time.tolist()]

    def product(one: list[arb], two: list[arb], k: int) -> arb:
        return sum(map(mul, one[: k + 1], two[k::-1]), arb(0))

    for k in range(system.degree + _MORE[own]):
        if own:
            square = sum(b * product(s, s, k) for b, s in zip(drive.b_squared, rows, strict=False))
            h[k:] = [(square.sqrt() if k == 0 else (square - product(h[1:], h[1:], k - 2)) / (2 * h[0])).mid()]
        for rate, x in zip(found, (by_time * arb_mat([[row[k]] for row in rows])).entries(), strict=True):
            rate.append(x.mid())
        taken = [product(rate, h, k) if own and does else rate[k] for rate, does in zip(found, changes, strict=True)]
        for i in system.axes:
            if k < system.degree and (friction is None or friction[i] is not None):
                f = drive.b_squared[i] * rows[i][k] if friction is None else friction[i] if k == 0 else arb(0)
                taken[i], taken[n + i] = (taken[i] - f) / system.m1[i] - f / system.m2[i], f / system.m2[i]
            else:
                taken[i], taken[n + i] = arb(0), taken[i] / system.mass[i]
        for row, x in zip(rows, taken, strict=True):
            row.append((x / (k + 1)).mid())
