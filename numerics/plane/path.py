"""What a path is made of: legs, events, the point that was reached, the bound N, and questions about the load there."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import mul
from typing import NamedTuple

from flint import arb, arb_poly

from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided
from numerics.plane.defect import Curve, Defect
from numerics.plane.polynomial import first_root, midpoints, total
from numerics.plane.series import Point
from numerics.plane.system import Balls, System

STICK, SLIP = "stick", "slip"


class Leg(NamedTuple):
    """A curve from x = 0 to x = `end`; bounds at its end on N and on the errors of z."""

    curve: Curve
    mode: str
    end: arb
    norm: arb
    apart: Balls


@dataclass(frozen=True)
class Happening:
    """A change of mode at a point of the path: the true one comes within `late` (s) of it.

    `direction` (n,) of s, right after it, or right before a stick; `load` (n,) there; both along the reduced axes.
    """

    at: Point
    late: arb
    before: str
    after: str
    direction: Balls
    load: Balls
    cause: str
    norm: arb
    apart: Balls


class Path:
    """A path that is followed: legs and events so far, the point that was reached, its bounds."""

    def __init__(
        self, system: System, max_events: int, max_legs: int, progress: Callable[[int, float], None] | None = None
    ) -> None:
        """Begin at t = 0."""
        self.system, self.max_events, self.max_legs, self.progress = system, max_events, max_legs, progress
        self.legs: list[Leg] = []
        self.events: list[Happening] = []
        self.eps = arb((1, -system.bits))
        with system.fine():
            q1, v1, v2 = ([arb_of(x) for x in one] for one in system.given.start)
            s = [x - y for x, y in zip(v1, v2, strict=True)]
            self.norm = arb(0)
            self.apart = [arb(0) for _ in system.axes]
            self.set(Point(0, arb(0), q1, v2, s, [arb(0) for _ in system.axes]))
            b = system.pieces[0].b
            stiff = [(x.sqrt(), system.a2[i][i]) for i, x in enumerate(system.mass)]
            self.sizes = [max_of([*q1, *(one / a for one, (_, a) in zip(b, stiff, strict=True))])]
            self.sizes.append(max_of([*v1, *v2, *(one / (m * a.sqrt()) for one, (m, a) in zip(b, stiff, strict=True))]))
            self.sizes.append(max_of([m / a.sqrt() for m, a in stiff]))
        self.mode, self.on_edge = SLIP, False
        self.doubt: arb | None = None
        self.reached = False

    @property
    def time(self) -> float:
        """Return the time that was reached, s, for messages."""
        pieces = self.system.given.pieces
        start = pieces[min(self.at.piece, len(pieces) - 1)].start
        return float(start) + float(self.at.t.mid())

    def undecided(self, question: str) -> EventUndecided:
        """Return the error for a point after which these digits do not tell what happens."""
        return EventUndecided(f"{question} near t = {self.time:.6g} s", f"N <= {self.norm.str(3)}", self.system.digits)

    def set(self, point: Point) -> None:
        """Go to a point: enclosures become their midpoints, and N grows by their radii."""
        with self.system.coarse():
            kept = [[(+x).mid() for x in one] for one in point[2:]]
        with self.system.fine():
            radii = [
                [(x - y).abs_upper() for x, y in zip(a, b, strict=True)] for a, b in zip(point[2:], kept, strict=True)
            ]
            q1, v2, s, z = radii
            self.norm = (self.norm + self.system.norm(q1, [x + y for x, y in zip(s, v2, strict=True)], v2)).upper()
            self.apart = [(x + y).upper() for x, y in zip(self.apart, z, strict=True)]
        self.at = Point(point.piece, point.t.mid(), *kept)

    def go_on(self, curve: Curve, mode: str, end: arb, norm: arb, *, ends: bool) -> None:
        """Record a curve and go to its end, or to the next piece of force if it `ends` there."""
        with self.system.fine():
            t = curve.t(end)
            passed = (t - curve.t(arb(0))).abs_upper()
            if mode == SLIP:
                self.apart = [
                    (x + root * norm * passed).upper() for x, root in zip(self.apart, self.system.apart, strict=True)
                ]
            self.norm = norm
            self.set(Point(curve.piece, t, *([p(end) for p in part] for part in curve[2:6])))
            true = self.system.pieces[curve.piece].length if ends else self.at.t
            # the curve is there a little earlier or later
            self.norm = (self.norm + self.speed() * abs(t - true)).upper()
            self.legs.append(Leg(curve, mode, end, self.norm, self.apart))
            if ends:
                self.at = self.at._replace(piece=curve.piece + 1, t=arb(0))
                if self.at.piece < len(self.system.pieces) and mode == STICK:
                    self.released("jump")

    def released(self, cause: str | None) -> None:
        """Choose the mode where a piece of force begins."""
        raise NotImplementedError

    def rates(self) -> tuple[Balls, Balls, Balls]:
        """Return bounds near the point on the rates of v1, v2 and Lam, whatever the friction in K is."""
        system, at = self.system, self.at
        drive = system.pieces[min(at.piece, len(system.pieces) - 1)]
        u, v1 = drive.force(at.t), at.v1
        steep = [abs(arb_poly(one).derivative()(at.t)) if one else arb(0) for one in drive.polynomial]
        for omega, _, amplitudes in drive.sines:
            steep = [x + omega * abs(a) for x, a in zip(steep, amplitudes, strict=True)]
        first = [2 * (abs(system.push(u, at.q1, v1, i)) + drive.b[i]) / system.m1[i] for i in system.axes]
        second = [b / m for b, m in zip(drive.b, system.m2, strict=True)]
        load = [
            2
            * system.share[i]
            * (steep[i] + system.row_sum(system.a2[i], [*map(abs, v1)]) + system.row_sum(system.a1[i], first))
            for i in system.axes
        ]
        return first, second, load

    def speed(self) -> arb:
        """Return a bound on N of the rate of the state near the point."""
        first, second, _ = self.rates()
        return self.system.norm(self.at.v1, first, second)

    def load(self, late: arb | None = None) -> Balls:
        """Return an enclosure of the true motion's Lam at the point, or within `late` (s) of it."""
        if late is not None:
            return [x + arb(0, (late * r).upper()) for x, r in zip(self.load(), self.rates()[2], strict=True)]
        system, at = self.system, self.at
        found = system.load(system.pieces[at.piece].force(at.t), at.q1, at.v1)
        return [x + arb(0, (e * self.norm).upper()) for x, e in zip(found, system.load_error, strict=True)]

    def loads_along(self, found: Defect) -> Balls:
        """Return enclosures of the true motion's Lam along a short curve that begins or ends at the point."""
        return [
            x + arb(0, (total(p - p[0]) + e).upper())
            for x, p, e in zip(self.load(), found.load, found.load_error, strict=True)
        ]

    def step(self, groups: Sequence[tuple[Sequence[arb], arb]]) -> arb:
        """Return how far coefficients reach: there their last two terms are 2^-bits of a size."""
        found = math.inf
        for coefficients, size in groups:
            top = len(coefficients) - 1
            for k in (top, top - 1):
                if k > 0 and coefficients[k] != 0:
                    found = min(found, (log2(size) - self.system.bits - log2(coefficients[k])) / k)
        return two_to(found) if found < math.inf else arb("inf")

    def apart_of(self, s: Sequence[arb_poly], t: arb_poly) -> tuple[arb_poly, ...]:
        """Return z = q1 - q2 along a slip."""
        rate = t.derivative()
        return tuple(midpoints((x * rate).integral() + z) for x, z in zip(s, self.at.z, strict=True))

    def exit(
        self, curve: Curve, found: Defect, norm: arb, h: arb, of: Sequence[int] | None = None
    ) -> tuple[arb, arb] | None:
        """Return where the load leaves K first, None if it does not; of some axes only, if they are given."""
        system, drive = self.system, self.system.pieces[curve.piece]
        inside, error, steep = arb_poly([1]), arb(0), arb(0)
        for i in system.axes if of is None else of:
            load = found.load[i]
            b, square = drive.b[i], drive.b_squared[i]
            inside = inside - load * load * (1 / square)
            off = system.load_error[i] * norm + found.load_error[i]
            error += off * (2 * b + off) / square
            bent = [
                system.row_sum(system.a2[j], system.soft) * norm / system.mass[j]
                + system.row_sum(system.a1[j], [1 / m for m in system.root_m1]) * norm / system.mass[j]
                for j in system.axes
            ]
            rate = system.row_sum(system.a2[i], [norm / m for m in system.root_m1]) + system.row_sum(system.a1[i], bent)
            steep += 2 * (h * system.share[i] * rate * (b + off) + off * total(load.derivative())) / square
        root = first_root(inside, error.upper(), steep.upper(), rises=self.on_edge)
        if isinstance(root, bool):
            raise self.undecided("does the load leave the friction set, or only touch its edge")
        return root

    def leaves(self, found: Defect, normal: Balls, window: arb, h: arb, m: int) -> bool:
        """Return whether n.Lam > h(n) surely lasts for a time, n.Lam = h(n) at its beginning for m = 2."""
        system, drive = self.system, self.system.pieces[self.at.piece]
        sizes, rates = [abs(x) for x in normal], self.rates()[2]
        if m == 1:
            most = sum((b * x * x for b, x in zip(drive.b_squared, normal, strict=True)), arb(0)).sqrt()
            gap = sum(map(mul, normal, self.load()), arb(0)) - most - sum(map(mul, sizes, rates), arb(0)) * window
            return bool(gap > 0)
        x = arb(0).union((window / h).upper())
        off = [
            system.share[i] * system.row_sum(system.a2[i], [self.norm / r for r in system.root_m1]) for i in system.axes
        ]
        steep = sum((n * p.derivative()(x) for n, p in zip(normal, found.load, strict=True)), arb(0)) / h
        steep = steep - sum(map(mul, sizes, off), arb(0))
        # with a damper the slip itself enters Lam, to second order in the time
        weighted = sum((r * k.sqrt() for r, k in zip(rates, system.kappa, strict=True)), arb(0))
        damp = [system.share[i] * system.row_sum(system.a1[i], system.apart) for i in system.axes]
        late = sum(map(mul, sizes, damp), arb(0)) * weighted * window if system.damped else arb(0)
        return bool(steep > 2 * late) and bool(steep > 0)

    def happened(self, before: str, direction: Balls, late: arb, cause: str) -> None:
        """Record a change of mode."""
        load = self.load(late)
        self.events.append(Happening(self.at, late, before, self.mode, direction, load, cause, self.norm, self.apart))


def arb_of(x: Fraction) -> arb:
    """Return a ball of a rational."""
    return Ball.number(x)


def max_of(values: Sequence[arb]) -> arb:
    """Return the largest size, as a point."""
    return max((abs(one).mid() for one in values), key=lambda one: one)


def log2(x: arb) -> float:
    """Return the logarithm of the size of a number, -inf for 0."""
    size = abs(x).mid()
    if size.is_zero():
        return -math.inf
    mantissa, exponent = size.man_exp()
    bits = int(mantissa).bit_length()
    return math.log2(int(mantissa) >> max(0, bits - 53)) + max(0, bits - 53) + int(exponent)


def two_to(power: float) -> arb:
    """Return 2^power, about."""
    whole = math.floor(power)
    return arb(2.0 ** (power - whole)) * arb((1, whole))
