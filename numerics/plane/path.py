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
from numerics.plane.polynomial import first_root, midpoints
from numerics.plane.series import Point
from numerics.plane.system import Balls, System
from numerics.plane.window import Around, around, wide

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
        with self.system.fine():
            kept = [[(+x).mid() for x in one] for one in point[2:]]
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
            # the curve is there a little earlier or later: as a motion that rests meanwhile it lacks all its rates
            self.norm = (self.norm + self.speed(true) * abs(t - true)).upper()
            self.legs.append(Leg(curve, mode, end, self.norm, self.apart))
            if ends:
                self.at = self.at._replace(piece=curve.piece + 1, t=arb(0))
                if self.at.piece < len(self.system.pieces) and mode == STICK:
                    self.released("jump")

    def released(self, cause: str | None) -> None:
        """Choose the mode where a piece of force begins."""
        raise NotImplementedError

    def around(self, window: arb, slips: Sequence[arb | None] = ()) -> Around:
        """Return what holds of the true motion within `window` (s) of the point, proved. Raises EventUndecided."""
        found = around(self.system, self.at, self.norm, window, slips)
        if found is None:
            raise self.undecided("how far does the motion get in a window")
        return found

    def speed(self, true: arb) -> arb:
        """Return a bound on the rate of N by which a path that rests at the point, until a time, leaves the motion."""
        system, at = self.system, self.at
        drive = system.pieces[at.piece]
        u = drive.force(at.t.union(true))
        first = [(abs(system.push(u, at.q1, at.v1, i)) + drive.b[i]) / system.m1[i] for i in system.axes]
        return system.norm(at.v1, first, [b / m for b, m in zip(drive.b, system.m2, strict=True)])

    def load(self, late: arb | None = None) -> Balls:
        """Return an enclosure of the true motion's Lam at the point, or within `late` (s) of it."""
        if late is not None:
            return self.around(late).load
        system, at = self.system, self.at
        found = system.load(system.pieces[at.piece].force(at.t), at.q1, at.v1)
        return [wide(x, e * self.norm) for x, e in zip(found, system.load_error, strict=True)]

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
        self, curve: Curve, found: Defect, norm: arb, of: Sequence[int] | None = None, start: float = 0.0
    ) -> tuple[arb, arb] | None:
        """Return where the load leaves K first, None if it does not; of some axes only, if they are given."""
        system, drive = self.system, self.system.pieces[curve.piece]
        inside, error = arb_poly([1]), arb(0)
        for i in system.axes if of is None else of:
            load, square = found.load[i], drive.b_squared[i]
            inside = inside - load * load * (1 / square)
            off = system.load_error[i] * norm + found.load_error[i]
            error += off * (2 * drive.b[i] + off) / square
        root = first_root(inside, error.upper(), start)
        if isinstance(root, bool):
            raise self.undecided("does the load leave the friction set, or only touch its edge")
        return root

    def leaves(self, normal: Balls, window: arb, m: int, slips: Sequence[arb | None] = ()) -> bool:
        """Return whether n.Lam > h(n) from the beginning of a slip to the end of a window: then s != 0 in it.

        n.kap^-1 s rises, n.kap^-1 s' = n.(Lam - f) >= n.Lam - h(n). For m = 2, n.Lam = h(n) at the beginning, n its
        normal there: without a damper n.Lam rises by n.drift. With one the slip itself enters Lam; but |s|_{kap^-1}
        grows no faster than the kap-distance of Lam from K, so to second order: at most by sum_i sqrt(kap_i) steep_i
        t^2/2 in a time t < 2 window.
        """
        system, near = self.system, self.around(window, slips)
        if m == 1:
            size = self.system.pieces[self.at.piece].friction(normal)[1]
            return bool(sum(map(mul, normal, near.load), arb(0)) > size)
        far = system.row_sum(system.apart, near.steep) * window
        damp = [system.share[i] * system.row_sum(system.a1[i], system.apart) for i in system.axes]
        return bool(sum(map(mul, normal, near.drift), arb(0)) > far * system.row_sum(normal, damp))

    def happened(self, before: str, direction: Balls, late: arb, cause: str) -> None:
        """Record a change of mode, which comes before or after a piece of force, not perhaps the one or the other."""
        length = self.system.pieces[self.at.piece].length
        if late > 0 and not (late < self.at.t and self.at.t + late < length):
            raise self.undecided("does the event come before the force changes, or the run ends")
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
