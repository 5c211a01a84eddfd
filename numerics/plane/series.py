"""Taylor coefficients of stick and of slip; a slip's own clock makes its end, and every reversal, regular.

In slip dt = h(s) dsigma, h(s) = |B s|: then f dt = B^2 s dsigma, and

    q1' = h v1,   M2 v2' = B^2 s,   s' = M1^-1 (h (u - A2 q1 - A1 v1)) - kap B^2 s,   t' = h

is analytic wherever s != 0, and s = 0 is at infinity: no step runs past it. Numbers are points here; what they are off
is seen in the defect (defect.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul
from typing import Any, NamedTuple

from flint import arb, arb_poly, arb_series

from numerics.plane.system import Drive, System


class Series(NamedTuple):
    """Coefficients of the time in the piece, of q1, v2, s by axes."""

    t: list[arb]
    q1: list[list[arb]]
    v2: list[list[arb]]
    s: list[list[arb]]


class Point(NamedTuple):
    """A point of the path: the piece, the time in it, q1, v2, s = v1 - v2 and z = q1 - q2, as exact numbers."""

    piece: int
    t: arb
    q1: list[arb]
    v2: list[arb]
    s: list[arb]
    z: list[arb]

    @property
    def v1(self) -> list[arb]:
        """Return the velocity of body 1."""
        return [x + y for x, y in zip(self.v2, self.s, strict=True)]


def convolved(one: Sequence[arb], two: Sequence[arb], k: int, first: int = 0) -> arb:
    """Return the coefficient k of a product, without the terms in one[j], j < first, and those it mirrors."""
    return sum(map(mul, one[first : k + 1 - first], two[k - first : (first - 1 if first else None) : -1]), arb(0))


class Forcing:
    """The coefficients of u(t(x)), one after the other."""

    def __init__(self, drive: Drive, t: list[arb]) -> None:
        """Begin with coefficient 0 of t, a list that grows."""
        self.drive, self.t = drive, t
        self.swing: list[tuple[list[arb], list[arb]]] = [([c.mid()], [s.mid()]) for c, s in drive.swing(t[0])]
        self.horner: list[list[list[arb]]] = [[[] for _ in one[1:]] for one in drive.polynomial]

    def next(self, k: int) -> list[arb]:
        """Return coefficient k of u, when t has its coefficients up to k and the swing has."""
        found = []
        for i, coefficients in enumerate(self.drive.polynomial):
            value = arb(0) if k or not coefficients else coefficients[-1]
            for j in range(len(coefficients) - 2, -1, -1):
                below = self.horner[i][j]
                below.append(value)
                value = convolved(below, self.t, k) + (0 if k else coefficients[j])
            for (_, _, amplitudes), (_, sines) in zip(self.drive.sines, self.swing, strict=True):
                value = value + amplitudes[i] * sines[k]
            found.append(value.mid())
        return found

    def swing_on(self, k: int, rate: list[arb]) -> None:
        """Append coefficient k + 1 of each cosine and sine; `rate` are the coefficients of t'."""
        for (omega, _, _), (cosines, sines) in zip(self.drive.sines, self.swing, strict=True):
            c, s = convolved(cosines, rate, k), convolved(sines, rate, k)
            cosines.append((-omega * s / (k + 1)).mid())
            sines.append((omega * c / (k + 1)).mid())


def force_series(drive: Drive, start: arb, degree: int) -> list[Any]:
    """Return u by the time from a start, by axes, as power series."""
    t = [start, arb(1)] + [arb(0)] * degree
    forcing, rows = Forcing(drive, t), []
    for k in range(degree):
        rows.append(forcing.next(k))
        forcing.swing_on(k, t[1:])
    return [arb_series(list(one), degree) for one in zip(*rows, strict=True)]


def slip_series(system: System, at: Point, degree: int) -> Series:
    """Return the coefficients of a slip by sigma."""
    drive, axes = system.pieces[at.piece], system.axes
    t, q1, v2, s = [at.t], [[x] for x in at.q1], [[x] for x in at.v2], [[x] for x in at.s]
    v1: list[list[arb]] = [[] for _ in axes]
    pushes: list[list[arb]] = [[] for _ in axes]
    rate: list[arb] = []
    forcing = Forcing(drive, t)
    for k in range(degree):
        square = sum((b * convolved(one, one, k) for b, one in zip(drive.b_squared, s, strict=True)), arb(0))
        rate.append(_next_root(square, rate, k))
        t.append((rate[k] / (k + 1)).mid())
        u = forcing.next(k)
        for i in axes:
            v1[i].append((v2[i][k] + s[i][k]).mid())
        now_q, now_v = [one[k] for one in q1], [one[k] for one in v1]
        for i in axes:
            pushes[i].append(system.push(u, now_q, now_v, i).mid())
            given = drive.b_squared[i] * s[i][k]
            taken = convolved(pushes[i], rate, k)
            s[i].append((((taken - given) / system.m1[i] - given / system.m2[i]) / (k + 1)).mid())
            v2[i].append((given / (system.m2[i] * (k + 1))).mid())
            q1[i].append((convolved(v1[i], rate, k) / (k + 1)).mid())
        forcing.swing_on(k, rate)
    return Series(t, q1, v2, s)


def _next_root(square: arb, root: list[arb], k: int) -> arb:
    """Return coefficient k of the square root of a series, from that of the series and those before."""
    if k == 0:
        return square.sqrt().mid()
    return ((square - convolved(root, root, k, 1)) / (2 * root[0])).mid()


def stick_series(system: System, at: Point, degree: int) -> Series:
    """Return the coefficients of a stuck motion by time (s)."""
    drive, axes, one = system.pieces[at.piece], system.axes, arb(1)
    t, q1, v2 = [at.t], [[x] for x in at.q1], [[x] for x in at.v2]
    forcing, rate = Forcing(drive, t), [one]
    for k in range(degree):
        t.append(one if k == 0 else arb(0))
        u = forcing.next(k)
        now_q, now_v = [x[k] for x in q1], [x[k] for x in v2]
        for i in axes:
            v2[i].append((system.push(u, now_q, now_v, i) / (system.mass[i] * (k + 1))).mid())
            q1[i].append((now_v[i] / (k + 1)).mid())
        forcing.swing_on(k, rate)
        rate.append(arb(0))
    return Series(t, q1, v2, [[arb(0)] for _ in axes])


def poly_force(drive: Drive, t: arb_poly, degree: int) -> tuple[list[arb_poly], list[arb]]:
    """Return u(t(x)) as polynomials on [0, 1], and bounds on what they are off, by axes.

    A cosine and a sine are the Taylor polynomials of the path; their defect bounds their errors.
    """
    rate = t.derivative()
    coefficients = list(t.coeffs())
    forcing = Forcing(drive, coefficients)
    rates = [*rate.coeffs(), *[arb(0)] * degree]
    for k in range(degree if drive.sines else 0):
        forcing.swing_on(k, rates)
    found, errors = [], []
    for poly in drive.polynomial:
        value = arb_poly([0])
        for one in reversed(poly):
            value = value * t + one
        found.append(value)
        errors.append(arb(0))
    for (omega, phase, amplitudes), (cosines, sines) in zip(drive.sines, forcing.swing, strict=True):
        c, s = arb_poly(cosines), arb_poly(sines)
        off = (c[0] - (omega * t[0] + phase).cos()).abs_upper() + (s[0] - (omega * t[0] + phase).sin()).abs_upper()
        for one in (c.derivative() + rate * s * omega, s.derivative() - rate * c * omega):
            off += sum((abs(x) / k for k, x in enumerate(one.coeffs(), start=1)), arb(0))
        for i, amplitude in enumerate(amplitudes):
            found[i] = found[i] + s * amplitude
            errors[i] = (errors[i] + abs(amplitude) * off).upper()
    return found, errors
