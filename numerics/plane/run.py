"""The path of a scene on a surface: stick, slip, and what joins them; N bounds how far the true motion is from it.

A motion sticks while Lam = M2 (M1+M2)^-1 (u - A2 q1 - A1 v1) is in K. Where the bound N leaves no doubt that s is not 0
(or that Lam is inside K), the true motion is in the path's mode; between, short windows remain, in which:

- a slip whose h(s) has come down to N ends, if Lam is inside K: |s| falls at a rate of at least (1 - |B^-1 Lam|) h;
- a slip begins, if n.Lam > h(n) with one n: n.kap^-1 s rises then, whatever f is;
- with Lam outside K it passes through s = 0, if all directions near it are drawn to one (passage.py).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import mul
from typing import NamedTuple

from flint import arb, arb_poly

from numerics.errors import EventUndecided, NotSettled
from numerics.plane.defect import Curve, Defect, defect, onset_defect, slip_defect
from numerics.plane.onset import onset
from numerics.plane.passage import drawn_to, end_direction
from numerics.plane.polynomial import at_one, first_root, rise, scaled, total
from numerics.plane.series import Point, slip_series, stick_series
from numerics.plane.system import Balls, System

STICK, SLIP = "stick", "slip"
_FALL = 2.0**-7
"""A step takes no more of h(s) than that: where a slip ends is known that well."""


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


class Run:
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

    def follow(self) -> None:
        """Follow the path to the end, or to the cap on events. Raises EventUndecided, NotSettled."""
        if not any(x != y for x, y in zip(*self.system.given.start[1:], strict=True)):
            self.released(None)
        while self.at.piece < len(self.system.pieces):
            if len(self.events) >= self.max_events:
                return
            if len(self.legs) >= self.max_legs:
                raise NotSettled(f"{len(self.legs)} steps end at t = {self.time:.6g} s; give an earlier horizon")
            (self.stick_on if self.mode == STICK else self.slip_on)()
            if self.progress is not None and len(self.legs) % 32 == 0:
                self.progress(len(self.events), self.time / float(self.system.given.pieces[-1].end))
        self.reached = True

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

    def load(self) -> Balls:
        """Return an enclosure of the true motion's Lam at the point."""
        system, at = self.system, self.at
        found = system.load(system.pieces[at.piece].force(at.t), at.q1, at.v1)
        return [x + arb(0, (e * self.norm).upper()) for x, e in zip(found, system.load_error, strict=True)]

    def step(self, groups: Sequence[tuple[Sequence[arb], arb]]) -> arb:
        """Return how far coefficients reach: there their last two terms are 2^-bits of a size."""
        found = math.inf
        for coefficients, size in groups:
            top = len(coefficients) - 1
            for k in (top, top - 1):
                if k > 0 and coefficients[k] != 0:
                    found = min(found, (log2(size) - self.system.bits - log2(coefficients[k])) / k)
        return two_to(found) if found < math.inf else arb("inf")

    def stick_on(self) -> None:
        """Stick for a step, or until the load leaves K."""
        system, at = self.system, self.at
        drive = system.pieces[at.piece]
        with system.coarse():
            series = stick_series(system, at, 2 * system.degree)
            q, v = self.sizes[:2]
            h, left = (
                self.step([*((x, q) for x in series.q1), *((x, v) for x in series.v2)]),
                (drive.length - at.t).mid(),
            )
            ends = bool(h >= left)
            h = left if ends else h
            q1, v2 = (tuple(scaled(x, h) for x in part) for part in (series.q1, series.v2))
        with system.fine():
            none, zeros = tuple(arb_poly([0]) for _ in system.axes), [arb(0) for _ in system.axes]
            impulse = tuple(p.derivative() * m for p, m in zip(v2, system.m2, strict=True))
            z = tuple(arb_poly([x]) for x in at.z)
            curve = Curve(at.piece, arb_poly([at.t, h]), q1, v2, none, z, impulse)
            found = defect(system, curve, zeros)
            norm = (self.norm + found.norm).upper()
            root = self.exit(curve, found, norm, h)
            self.on_edge = False
            if root is None:
                self.go_on(curve, STICK, arb(1), norm, ends=ends)
                return
            x, off = root
            self.go_on(curve, STICK, x, norm, ends=False)
            self.begin(2, "guard", STICK, (off * h).upper())

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

    def slip_on(self) -> None:
        """Slip for a step, and on to what follows if s gets to 0 in it."""
        system, at = self.system, self.at
        drive, (q, v, time) = system.pieces[at.piece], self.sizes
        with system.coarse():
            series = slip_series(system, at, system.degree)
            size = max_of(at.s)
            groups = [*((x, size) for x in series.s), *((x, q) for x in series.q1), *((x, v) for x in series.v2)]
            h = self.step([*groups, (series.t, time)])
            rates = [one * k for k, one in enumerate(series.t)][1:]
            while not at_one(scaled(rates, h)) > rates[0] * _FALL:
                h = (h * 0.75).mid()
            t = scaled(series.t, h)
            ends = bool(at_one(t) > drive.length)
            if ends:
                h = (h * rise(t, drive.length)).mid()
        for _ in range(60):
            with system.coarse():
                t, parts = scaled(series.t, h), [tuple(scaled(x, h) for x in part) for part in series[1:]]
            with system.fine():
                q1, v2, s = parts
                impulse = tuple(x * (b * h) for x, b in zip(s, drive.b_squared, strict=True))
                curve = Curve(at.piece, t, q1, v2, s, self.apart_of(s, t), impulse)
                found, slowest = slip_defect(system, curve, h)
            if found.norm.is_finite() and slowest > 0:
                break
            h, ends = (h / 2).mid(), False
        else:
            raise self.undecided("does the slip turn or end")
        with system.fine():
            norm = (self.norm + found.norm).upper()
            limit = 2 * drive.reach * norm
            if slowest > limit and self.doubt is None:
                self.go_on(curve, SLIP, arb(1), norm, ends=ends)
                return
            self.doubt = at.t if self.doubt is None else self.doubt
            before = drive.friction(at.s)[1]
            self.go_on(curve, SLIP, arb(1), norm, ends=False)
            after = drive.friction(self.at.s)[1]
            if ends or slowest > limit or not after < before:
                raise self.undecided("does the slip turn or end")
            if after < limit:
                late, self.doubt = abs(self.at.t - self.doubt), None
                self.meet(found, late)

    def apart_of(self, s: Sequence[arb_poly], t: arb_poly) -> tuple[arb_poly, ...]:
        """Return z = q1 - q2 along a slip."""
        rate = t.derivative()
        return tuple(
            arb_poly([one.mid() for one in ((x * rate).integral() + z).coeffs()])
            for x, z in zip(s, self.at.z, strict=True)
        )

    def meet(self, found: Defect, late: arb) -> None:
        """Go on from s = 0, which a slip has come to: it sticks if the load is inside K, and passes if outside."""
        system, drive = self.system, self.system.pieces[self.at.piece]
        at, load = self.at, self.load()
        left = sum((x * x / k for x, k in zip(at.s, system.kappa, strict=True)), arb(0)).sqrt() + self.norm
        weak = min_of([b * root for b, root in zip(drive.b, system.apart, strict=True)])
        near = [
            x + arb(0, (total(p - p[0]) + e).upper())
            for x, p, e in zip(load, found.load, found.load_error, strict=True)
        ]
        strain = drive.strain(near)
        if strain < 1:
            rate = (1 - strain.sqrt()) * weak
            direction = end_direction(system, drive, load, at.s)
        elif strain > 1:
            drawn = drawn_to(system, drive, near, at.s)
            if drawn is None:
                raise self.undecided("does the slip turn around s = 0 or pass through it")
            direction, rate = drawn
        else:
            raise self.undecided("is the load inside the friction set where the slip ends")
        late = (late + left / rate).upper()
        moved = [late * r for r in self.rates()[2]]
        wide = drive.strain([x + arb(0, m.upper()) for x, m in zip(near, moved, strict=True)])
        if not (wide < 1 if strain < 1 else wide > 1):
            raise self.undecided("is the load inside the friction set where the slip ends")
        jump = system.norm(
            at.q1 and [arb(0)] * system.n,
            [y / m * s for y, m, s in zip(system.m2, system.mass, at.s, strict=True)],
            [y / m * s for y, m, s in zip(system.m1, system.mass, at.s, strict=True)],
        )
        self.norm = (self.norm + jump).upper()
        v2 = [v + m / w * s for v, m, w, s in zip(at.v2, system.m1, system.mass, at.s, strict=True)]
        self.apart = [(x + r * self.norm * late).upper() for x, r in zip(self.apart, system.apart, strict=True)]
        self.set(at._replace(v2=v2, s=[arb(0)] * system.n))
        if strain < 1:
            self.mode = STICK
            self.happened(SLIP, direction, late, "guard")
        else:
            self.begin(1, "guard", SLIP, late)

    def happened(self, before: str, direction: Balls, late: arb, cause: str) -> None:
        """Record a change of mode."""
        load = [x + arb(0, (late * r).upper()) for x, r in zip(self.load(), self.rates()[2], strict=True)]
        self.events.append(Happening(self.at, late, before, self.mode, direction, load, cause, self.norm, self.apart))

    def released(self, cause: str | None) -> None:
        """Choose the mode of bodies that move together where a piece of force begins."""
        system, drive = self.system, self.system.pieces[self.at.piece]
        strain = drive.strain(self.load())
        self.mode = STICK
        if strain > 1:
            self.begin(1, cause, STICK, arb(0))
        elif not strain < 1:
            if cause is not None or not exactly_on_edge(system):
                raise self.undecided("is the load inside the friction set")
            at, acting = self.at, system.given.pieces[0]
            u = [p[1] if len(p) > 1 else arb(0) for p in drive.polynomial]
            for (omega, phase, amplitudes), _ in zip(drive.sines, acting.sines, strict=True):
                u = [x + a * omega * phase.cos() for x, a in zip(u, amplitudes, strict=True)]
            pull = [system.push(drive.force(at.t), at.q1, at.v1, i) / system.mass[i] for i in system.axes]
            turn = system.load(u, at.v1, pull)
            way = sum((x * y / b for x, y, b in zip(turn, self.load(), drive.b_squared, strict=True)), arb(0))
            if way > 0:
                self.begin(2, None, STICK, arb(0))
            elif way < 0:
                self.on_edge = True
            else:
                raise self.undecided("does the load leave the friction set at t = 0")

    def begin(self, m: int, cause: str | None, before: str, late: arb) -> None:
        """Begin a slip, s = tau^m S(tau); without a cause it is how the run begins."""
        system, at = self.system, self.at
        drive, load = system.pieces[at.piece], self.load()
        with system.coarse():
            degree = system.degree if m == 1 else int(0.75 * system.bits) + 8
            series = onset(system, at, [x.mid() for x in load], m, degree)
            h, top = self.reach(series.slip, m)
            left = (drive.length - at.t).mid()
            ends = bool(h >= left)
            h = left if ends else h
        first = [one[0] for one in series.slip]
        length = sum(map(mul, first, first), arb(0)).sqrt()
        self.mode = SLIP
        if cause is not None:
            self.happened(before, [x / length for x in first], late, cause)
        for _ in range(60):
            with system.coarse():
                q1, v2, slip = (tuple(scaled(x[:top], h) for x in part) for part in series[:3])
                size = scaled(series.size[:top], h)
            with system.fine():
                power = arb_poly([0] * m + [(h**m).mid()])
                s = tuple(x * power for x in slip)
                impulse = tuple(p.derivative() * w for p, w in zip(v2, system.m2, strict=True))
                t = arb_poly([at.t, h])
                curve = Curve(at.piece, t, q1, v2, s, self.apart_of(s, t), impulse)
                found, slowest = onset_defect(system, curve, slip, size, h)
                bound = self.eps * 2**16 * self.sizes[1] * max_of(system.root_m1 + system.root_m2)
            if found.norm < bound:
                break
            h, ends = (h / 2).mid(), False
        else:
            raise self.undecided("how does the slip begin")
        with system.fine():
            norm = (self.norm + found.norm).upper()
            window = (2 * drive.reach * norm / slowest).upper().root(m) + 2 * late
            if not (window < h / 2 and self.leaves(found, first, window, h, m)):
                raise self.undecided("does the load leave the friction set, or only touch its edge")
            self.go_on(curve, SLIP, arb(1), norm, ends=ends)

    def reach(self, slip: Sequence[Balls], m: int) -> tuple[arb, int]:
        """Return how far the series of a beginning slip reaches, and how many of its terms: for m = 2 it diverges."""
        size, count = log2(max_of([one[0] for one in slip])), len(slip[0]) - (m == 2)
        reach = [
            (size - self.system.bits - max(log2(one[k]) for one in slip)) / k
            if any(one[k] != 0 for one in slip)
            else 64.0
            for k in range(1, count)
        ]
        found = max(min(reach[k - 1], reach[k]) for k in range(4, len(reach))) if m == 2 else min(reach[-2:])
        top = 1 + max(k for k in range(4, len(reach)) if min(reach[k - 1], reach[k]) >= found) if m == 2 else count
        return two_to(min(found, log2(self.sizes[2]) + 4)), top

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


def exactly_on_edge(system: System) -> bool:
    """Return whether |B^-1 Lam| = 1 at t = 0, on exact data; False where a sine is not exactly known."""
    given, acting = system.given, system.given.pieces[0]
    if any(phase for _, phase, _ in acting.sines):
        return False
    q1, v1, _ = given.start
    total_strain = Fraction(0)
    for i in system.axes:
        push = (acting.polynomial[0][i] if acting.polynomial else Fraction(0)) - sum(
            given.a2[i][j] * q1[j] + given.a1[i][j] * v1[j] for j in system.axes
        )
        total_strain += (given.m2[i] / (given.m1[i] + given.m2[i]) * push) ** 2 / acting.b_squared[i]
    return total_strain == 1


def arb_of(x: Fraction) -> arb:
    """Return a ball of a rational."""
    from numerics.arithmetic.ball import Ball

    return Ball.number(x)


def max_of(values: Sequence[arb]) -> arb:
    """Return the largest size, as a point."""
    return max((abs(one).mid() for one in values), key=lambda one: one)


def min_of(values: Sequence[arb]) -> arb:
    """Return a lower bound of the least."""
    found = values[0]
    for one in values[1:]:
        found = found.min(one)
    return found


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
