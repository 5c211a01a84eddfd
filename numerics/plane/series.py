"""Taylor coefficients of stick and of slip; a slip's own clock makes its end, and every reversal, regular.

Where friction is given, or holds an axis at rest, they are those by the time. In slip dt = h(s) dsigma, h(s) = |B s|:
then f dt = B^2 s dsigma, and

    q1' = h v1,   M2 v2' = B^2 s,   s' = M1^-1 (h (u - A2 q1 - A1 v1)) - kap B^2 s,   t' = h

is analytic wherever s != 0, and s = 0 is at infinity: no step runs past it. Nothing is proved here: numbers are points,
and what they are off is seen in the defect (defect.py). So compiled double-double does where few digits are asked for;
where there are more, or numbers leave its range, the same lines (`expand`) are run on balls, of which the midpoints
are taken.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import chain
from operator import mul
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_poly

from numerics.arithmetic.compiled import by_type, can_compile, compilable, compiled
from numerics.arithmetic.functions import like, sqrt
from numerics.arithmetic.pair import TwoFloats
from numerics.plane.polynomial import log2, scaled, two_to
from numerics.plane.system import PlaneDrive, System, highest
from numerics.plane.vector import Vector

_MORE = {True: 6, False: 2}
"""Terms beyond those of s with which the rest follows from it, by its own clock or not; loads are as good as these."""
_BITS = 91
"""Up to so many bits double-double has some to spare."""
_RANGE = 2.0**240
"""Of numbers up to this size, and down to its inverse, products of three have low halves."""


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
        drive, n, degree = system.pieces[at.piece], system.n, system.degree
        top = degree + _MORE[friction is None]
        known, pairs = constants(system, drive)
        self.start = [*at.s, *at.v2, *at.q1, at.t, *chain(*drive.swing(at.t))]
        count, powers = len(self.start), len(drive.polynomial)
        rate = (
            highest(1 / drive.heavy) + drive.friction(at.s)[1] / system.period
            if friction is None
            else 1 / system.period
        )
        self.unit = two_to(-round(log2(rate)))
        given = friction or [arb(0)] * n
        slips, forces = np.array([f is not None for f in given]), [[f or arb(0) for f in given]]
        sizes = slips, friction is None, degree, top, powers, len(drive.sines)
        column = [*self.start, *[arb(0)] * (2 * n + 1), *(at.t**p for p in range(2, powers))]
        shown: Any = np.zeros((2, len(column), top + 1))
        if pairs is not None:
            begin, push = halves([[x] for x in column]), halves(forces)
            if _in_range(begin[:, :count]) and _in_range(push):
                shown[..., :1] = begin
                compiled(expand)(shown, pairs, push, *sizes, float(self.unit))
        if shown.any() and np.isfinite(shown).all():
            high, low = shown[:, :count].tolist()
            self.polynomials = [arb_poly(x) + arb_poly(y) for x, y in zip(high, low, strict=True)]
        else:
            shown = [[x.mid(), *[arb(0)] * top] for x in column]
            expand(shown, known, forces, *sizes, self.unit)
            self.polynomials = [*map(arb_poly, shown[:count])]

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


@lru_cache(maxsize=8)
def constants(system: System, drive: PlaneDrive) -> tuple[Any, ...]:
    """Return what `expand` reads of a piece of force, in balls and in pairs (None: out of their range)."""
    still = [arb(0)] * (system.n - 1)
    waves = [one for omega, _, amplitudes in drive.sines for one in (amplitudes, [omega, *still])]
    rows = [
        system.m1,
        system.m2,
        system.mass,
        drive.b_squared,
        *system.a2,
        *(system.a1 or system.a2 * 0),
        *drive.polynomial,
        *waves,
    ]
    good = system.bits <= _BITS and can_compile() and _in_range(pairs := halves(rows))
    return rows, pairs if good else None


def halves(rows: Sequence[Sequence[arb]]) -> Any:
    """Return numbers as pairs of floats, (2, ...): high halves, then low ones."""
    high = [[float(x.mid()) for x in row] for row in rows]
    low = [[float((x - arb(y)).mid()) for x, y in zip(*both, strict=True)] for both in zip(rows, high, strict=True)]
    return np.array([high, low], ndmin=3)


def _in_range(pairs: Any) -> bool:
    """Return whether high halves are 0 or of a size that leaves room."""
    size = abs(pairs[0])
    return bool(((size == 0) | ((size < _RANGE) & (size * _RANGE > 1))).all())


def _pair_of(table: Any, row: int, k: int) -> TwoFloats:
    return TwoFloats(table[0, row, k], table[1, row, k])


def _put_pair(table: Any, row: int, k: int, x: TwoFloats) -> None:
    table[0, row, k], table[1, row, k] = x.high, x.low


def _product_of_pairs(table: Any, one: int, two: int, k: int) -> TwoFloats:
    total = TwoFloats(0.0, 0.0)
    for j in range(k + 1):
        total = total + number(table, one, j) * number(table, two, k - j)
    return total


@by_type(_pair_of, _pair_of)
def number(table: Any, row: int, k: int) -> Any:
    """Return an entry of a table: of rows of balls; where it is compiled, of arrays of high and of low halves."""
    return table[row][k]


@by_type(_put_pair, _put_pair)
def put(table: Any, row: int, k: int, x: Any) -> None:
    """Write an entry."""
    table[row][k] = x.mid()


@by_type(_product_of_pairs, _product_of_pairs)
def product(table: Any, one: int, two: int, k: int) -> Any:
    """Return the coefficient k of the product of two rows."""
    return sum(map(mul, table[one][: k + 1], table[two][k::-1]))


@compilable
def by_clock(table: Any, row: int, rate: int, k: int, own: bool) -> Any:
    """Return the coefficient k of what a rate by time is by the clock: the slip's own one, or the time itself."""
    if own:
        return product(table, row, rate, k)
    return number(table, row, k)


@compilable
def expand(
    table: Any,
    given: Any,
    friction: Any,
    slips: Any,
    own: bool,
    degree: int,
    top: int,
    powers: int,
    phases: int,
    unit: Any,
) -> None:
    """Fill a table of top + 1 columns whose column 0 has s, v2, q1, t, waves and powers; the rest is 0.

    A column k has the coefficients of (sigma/unit)^k. Rows are n of s, v2 and q1 each, that of t, a sine and a cosine
    for each phase, n of v1 and of the push u - A2 q1 - A1 v1, dt/dsigma, and t^2, t^3, ... Beyond the degree s ends,
    and all else goes on with that, as where an axis sticks. Rows of `given`: m1, m2, m1 + m2, b^2, those of A2, of A1,
    of u by powers of t, and for each phase the amplitudes and (omega, 0, ...); `friction` has one.
    """
    n = len(slips)
    second, place, clock, wave = n, 2 * n, 3 * n, 3 * n + 1
    first, push, rate = wave + 2 * phases, wave + 2 * phases + n, wave + 2 * phases + 2 * n
    still, fixed, waves = rate - 1, 4 + 2 * n, 4 + 2 * n + powers  # t^p is row still + p
    one = like(number(table, clock, 0), 1.0)
    for k in range(top):
        step = one * unit / float(k + 1)
        for i in range(n):
            put(table, first + i, k, number(table, second + i, k) + number(table, i, k))
        if own:
            square = one * 0.0
            for i in range(n):
                square = square + number(given, 3, i) * product(table, i, i, k)
            if k == 0:
                put(table, rate, 0, sqrt(square))
            else:
                put(table, rate, k, (square - product(table, rate, rate, k)) / (number(table, rate, 0) * 2.0))
        elif k == 0:
            put(table, rate, 0, one)
        put(table, clock, k + 1, number(table, rate, k) * step)
        for p in range(2, powers):
            before = clock if p == 2 else still + p - 1
            put(table, still + p, k + 1, by_clock(table, before, rate, k, own) * step * float(p))
        for i in range(n):
            u = number(given, fixed, i) if k == 0 and powers > 0 else one * 0.0
            for p in range(1, powers):
                u = u + number(given, fixed + p, i) * number(table, clock if p == 1 else still + p, k)
            for j in range(phases):
                u = u + number(given, waves + 2 * j, i) * number(table, wave + 2 * j, k)
            for j in range(n):
                u = u - number(given, 4 + i, j) * number(table, place + j, k)
                u = u - number(given, 4 + n + i, j) * number(table, first + j, k)
            put(table, push + i, k, u)
            taken = by_clock(table, push + i, rate, k, own)
            if k < degree and slips[i]:
                if own:
                    held = number(given, 3, i) * number(table, i, k)
                else:
                    held = number(friction, 0, i) if k == 0 else one * 0.0
                off = (taken - held) / number(given, 0, i) - held / number(given, 1, i)
                put(table, i, k + 1, off * step)
                put(table, second + i, k + 1, held / number(given, 1, i) * step)
            else:
                put(table, second + i, k + 1, taken / number(given, 2, i) * step)
            put(table, place + i, k + 1, by_clock(table, first + i, rate, k, own) * step)
        for j in range(phases):
            turn, sine = number(given, waves + 2 * j + 1, 0) * step, wave + 2 * j
            put(table, sine, k + 1, turn * by_clock(table, sine + 1, rate, k, own))
            put(table, sine + 1, k + 1, -(turn * by_clock(table, sine, rate, k, own)))
