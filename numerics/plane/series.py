"""Taylor coefficients of stick and of slip; a slip's own clock makes its end, and every reversal, regular.

In slip dt = h(s) dsigma, h(s) = |B s|: then f dt = B^2 s dsigma, and

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
from flint import arb, arb_poly, arb_series

from numerics.arithmetic.compiled import by_type, can_compile, compilable, compiled
from numerics.arithmetic.functions import like, sqrt
from numerics.arithmetic.pair import Pair
from numerics.plane.polynomial import log2, scaled, two_to
from numerics.plane.system import Drive, System, highest
from numerics.plane.vector import Vector

_MORE = 6
"""Terms beyond those of s with which the rest follows from it."""
_BITS = 91
"""Up to so many bits double-double has some to spare."""
_RANGE = 2.0**240
"""Of numbers up to this size, and down to its inverse, products of three have low halves."""


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


class Curve(NamedTuple):
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


def curve_of(at: Point, t: arb_poly, q1: Vector, v2: Vector, s: Vector, impulse: Vector, swing: Any) -> Curve:
    """Return a piece of the path from a point, with z = q1 - q2 along it."""
    rate = t.derivative()
    z = Vector((x * rate).integral() + z for x, z in zip(s, at.z, strict=True))
    return Curve(at.piece, t, q1, v2, s, z, impulse, swing)


class Series(NamedTuple):
    """Coefficients by axes of q1 and v2, of S, s = S or a power of the time times S, and of h(S)."""

    q1: Sequence[Sequence[arb]]
    v2: Sequence[Sequence[arb]]
    slip: Sequence[list[arb]]
    size: list[arb]


def linear_series(system: System, at: Point, friction: Sequence[arb | None]) -> Series:
    """Return the coefficients by time (s) where friction on an axis is constant, or (None) holds it at rest."""
    drive, rows = system.pieces[at.piece], [(at.q1, at.v2, at.s)]
    u = drive.force(arb_series([at.t, 1], system.degree))
    slips = Vector(arb(f is not None) for f in friction)
    for k in range(system.degree):
        q1, v2, s = rows[-1]
        load = system.load(u.order(k), q1, v2 + s)
        given = Vector(x if f is None else f * (k == 0) for x, f in zip(load, friction, strict=True))
        after = (v2 + s, given / system.m2, (load - given) * system.kappa * slips)
        rows.append(tuple((one / (k + 1)).each(arb.mid) for one in after))
    parts = ([list(one) for one in zip(*part, strict=True)] for part in zip(*rows, strict=True))
    return Series(*parts, [])  # type: ignore[call-arg]


class Slip:
    """A slip from a point: `rows` of s, q1, v2, t are coefficients of (sigma/unit)^k, a unit about a step."""

    def __init__(self, system: System, at: Point) -> None:
        """Form the series."""
        self.at, self.drive = at, system.pieces[at.piece]
        drive, n, top = self.drive, system.n, system.degree + _MORE
        known, pairs, rate, period = constants(system, drive)
        self.n, self.start = n, [*at.s, *at.v2, *at.q1, at.t, *chain(*drive.swing(at.t))]
        count, powers = len(self.start), len(drive.polynomial)
        self.unit = two_to(-round(log2(rate + drive.friction(at.s)[1] / period)))
        sizes = n, system.degree, top, powers, len(drive.sines)
        column = [x.mid() for x in self.start] + [arb(0)] * (2 * n + 1 + max(0, powers - 2))
        shown: Any = np.zeros((2, len(column), top + 1))
        if pairs is not None and _in_range(begin := halves([[x] for x in column])):
            shown[..., :1] = begin
            compiled(expand)(shown, *(*pairs, *sizes, float(self.unit)))
        if shown.any() and np.isfinite(shown).all():
            self.polynomials = [
                arb_poly(high) + arb_poly(low) for high, low in zip(*shown[:, :count].tolist(), strict=True)
            ]
            shown = shown[0]
        else:
            shown = [[x, *[arb(0)] * top] for x in column]
            expand(shown, *(*known, *sizes, self.unit))
            self.polynomials = [*map(arb_poly, shown[:count])]
        s, v2, q1 = ([row[: system.degree + 1] for row in shown[k : k + n]] for k in (0, n, 2 * n))
        self.rows = s, q1, v2, [shown[3 * n][: system.degree + 1]]

    def drawn(self, h: arb) -> Curve:
        """Return a step sigma = h x, 0 <= x <= 1."""
        n, polynomials = self.n, zip(self.polynomials, self.start, strict=True)
        found = [arb_poly([x, *scaled(one, h / self.unit).coeffs()[1:]]) for one, x in polynomials]
        s, v2, q1 = (Vector(found[k : k + n]) for k in (0, n, 2 * n))
        t, *waves = found[3 * n :]
        swing = [*zip(waves[::2], waves[1::2], strict=True)]
        return curve_of(self.at, t, q1, v2, s, s * (self.drive.b_squared * h), swing)


@lru_cache(maxsize=8)
def constants(system: System, drive: Drive) -> tuple[Any, ...]:
    """Return what `expand` reads of a piece of force, in balls and in pairs (None: out of their range), and two sizes.

    The sizes: how fast a direction settles by sigma, and a period, s.
    """
    held = [[dict(row).get(j, arb(0)) for j in range(2 * system.n)] for row in system.held]
    waves = [[*amplitudes, omega] for omega, _, amplitudes in drive.sines]
    rows = [system.m1, system.m2, system.mass, drive.b_squared], held, drive.polynomial, waves
    pairs = [*map(halves, rows)]
    good = system.bits <= _BITS and can_compile() and all(map(_in_range, pairs))
    rate, period = highest(system.kappa * drive.b_squared), highest((system.mass / system.stiff).each(arb.sqrt))
    return rows, pairs if good else None, rate, period


def halves(rows: Sequence[Sequence[arb]]) -> Any:
    """Return numbers as pairs of floats, (2, ...): high halves, then low ones."""
    high = [[float(x.mid()) for x in row] for row in rows]
    low = [[float((x - arb(y)).mid()) for x, y in zip(*both, strict=True)] for both in zip(rows, high, strict=True)]
    return np.array([high, low], ndmin=3)


def _in_range(pairs: Any) -> bool:
    """Return whether high halves are 0 or of a size that leaves room."""
    size = abs(pairs[0])
    return bool(((size == 0) | ((size < _RANGE) & (size * _RANGE > 1))).all())


def _pair_of(table: Any, row: int, k: int) -> Pair:
    return Pair(table[0, row, k], table[1, row, k])


def _put_pair(table: Any, row: int, k: int, x: Pair) -> None:
    table[0, row, k], table[1, row, k] = x.high, x.low


def _product_of_pairs(table: Any, one: int, two: int, k: int) -> Pair:
    total = Pair(0.0, 0.0)
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
def expand(
    table: Any,
    masses: Any,
    held: Any,
    polynomial: Any,
    waves: Any,
    n: int,
    degree: int,
    top: int,
    powers: int,
    phases: int,
    unit: Any,
) -> None:
    """Fill a table of top + 1 columns whose column 0 has s, v2, q1, t, sines and cosines; the rest is 0.

    A column k has the coefficients of (sigma/unit)^k. Rows are n of s, v2 and q1 each, that of t, a sine and a cosine
    for each phase, n of v1 and of the push u - A2 q1 - A1 v1, h(s), and t^2, t^3, ... Beyond the degree s ends, and all
    else goes on with that. `masses`: rows m1, m2, m1 + m2, b^2; `held`: A2, A1 side by side; `polynomial`: rows of u by
    powers of t; `waves`: by phases, the amplitudes, then omega.
    """
    second, place, clock, wave = n, 2 * n, 3 * n, 3 * n + 1
    first, push, rate = wave + 2 * phases, wave + 2 * phases + n, wave + 2 * phases + 2 * n
    still = rate - 1  # t^p is row still + p
    one = like(number(table, clock, 0), 1.0)
    for k in range(top):
        step = one * unit / float(k + 1)
        square = one * 0.0
        for i in range(n):
            square = square + number(masses, 3, i) * product(table, i, i, k)
            put(table, first + i, k, number(table, second + i, k) + number(table, i, k))
        if k == 0:
            put(table, rate, 0, sqrt(square))
        else:
            put(table, rate, k, (square - product(table, rate, rate, k)) / (number(table, rate, 0) * 2.0))
        put(table, clock, k + 1, number(table, rate, k) * step)
        for p in range(2, powers):
            put(table, still + p, k, product(table, clock if p == 2 else still + p - 1, clock, k))
        for i in range(n):
            u = number(polynomial, 0, i) if k == 0 and powers > 0 else one * 0.0
            for p in range(1, powers):
                u = u + number(polynomial, p, i) * number(table, clock if p == 1 else still + p, k)
            for j in range(phases):
                u = u + number(waves, j, i) * number(table, wave + 2 * j, k)
            for j in range(n):
                u = u - number(held, i, j) * number(table, place + j, k)
                u = u - number(held, i, n + j) * number(table, first + j, k)
            put(table, push + i, k, u)
            given, taken = number(masses, 3, i) * number(table, i, k), product(table, push + i, rate, k)
            if k < degree:
                off = (taken - given) / number(masses, 0, i) - given / number(masses, 1, i)
                put(table, i, k + 1, off * step)
                put(table, second + i, k + 1, given / number(masses, 1, i) * step)
            else:
                put(table, second + i, k + 1, taken / number(masses, 2, i) * step)
            put(table, place + i, k + 1, product(table, first + i, rate, k) * step)
        for j in range(phases):
            turn, sine = number(waves, j, n) * step, wave + 2 * j
            put(table, sine, k + 1, turn * product(table, sine + 1, rate, k))
            put(table, sine + 1, k + 1, -(turn * product(table, sine, rate, k)))
