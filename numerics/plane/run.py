"""The path of a scene on a surface: stick, slip, and what joins them; N bounds how far the true motion is from it.

A motion sticks while Lam = M2 (M1+M2)^-1 (u - A2 q1 - A1 v1) is in K. Where the bound N leaves no doubt that s is not 0
(or that Lam is inside K), the true motion is in the path's mode; between, short windows remain, in which:

- a slip whose h(s) has come down to N ends, if Lam is inside K: |s| falls at a rate of at least (1 - |B^-1 Lam|) h;
- a slip begins, if n.Lam > h(n) with one n: n.kap^-1 s rises then, whatever f is;
- with Lam outside K it passes through s = 0, if all directions near it are drawn to one (passage.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from flint import arb, arb_poly

from numerics.arithmetic.ball import sqrt
from numerics.errors import NotSettled
from numerics.plane.defect import Curve, Defect, defect, onset_defect, slip_defect
from numerics.plane.onset import onset
from numerics.plane.passage import drawn_to, end_direction
from numerics.plane.path import SLIP, STICK, Path, log2, max_of, two_to
from numerics.plane.polynomial import at_one, midpoints, rise, scaled
from numerics.plane.series import Point, Series, slip_series, stick_series
from numerics.plane.system import Balls, System

_FALL = 2.0**-7
"""A step takes no more of h(s) than that: where a slip ends is known that well."""


class Run(Path):
    """The path of an ellipsoid."""

    def follow(self) -> None:
        """Follow the path to the end, or to the cap on events. Raises EventUndecided, NotSettled."""
        if not any(x != y for x, y in zip(*self.system.given.start[1:], strict=True)):
            with self.system.fine():
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

    def stick_on(self) -> None:
        """Stick for a step, or until the load leaves K."""
        system, at = self.system, self.at
        drive = system.pieces[at.piece]
        with system.coarse():
            series = stick_series(system, at, system.degree)
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
            t = clock(at, series, h)
            ends = bool(at_one(t) > drive.length)
            if ends:
                h = (h * rise(t, drive.length)).mid()
        for _ in range(60):
            with system.coarse():
                t, parts = clock(at, series, h), [tuple(scaled(x, h) for x in part) for part in series[1:]]
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
                if not ends:
                    self.land()
                return
            self.doubt = at.t if self.doubt is None else self.doubt
            before = drive.friction(at.s)[1]
            self.go_on(curve, SLIP, arb(1), norm, ends=False)
            after = drive.friction(self.at.s)[1]
            if ends or slowest > limit or not after < before:
                raise self.undecided("does the slip turn or end")
            if after < limit:
                late, self.doubt = abs(self.at.t - self.doubt), None
                self.meet(found, late, self.at.s)

    def land(self) -> None:
        """Slip straight to s = 0, if that is a motion as good as any: with f constant s falls linearly."""
        system, at = self.system, self.at
        drive, load, left = system.pieces[at.piece], self.load(), self.system.pieces[at.piece].length - at.t
        f, size = drive.friction(at.s)
        weight = sum((x * x / k for x, k in zip(at.s, system.kappa, strict=True)), arb(0))
        fall = sum(((x - y) * s for x, y, s in zip(f, load, at.s, strict=True)), arb(0))
        enough = self.norm / 64 + self.eps * self.sizes[1] * max_of(system.root_m1 + system.root_m2)
        if not (fall > 0 and (h := (weight / fall).mid()) < left):
            return
        off = [abs(s / (k * h) + x - y) * h for s, k, x, y in zip(at.s, system.kappa, load, f, strict=True)]
        if not max_of(off) < enough * max_of(system.root_m1 + system.root_m2):
            return
        t, s = arb_poly([at.t, h]), tuple(arb_poly([x, -x]) for x in at.s)
        impulse = tuple(arb_poly([x.mid() * h]) for x in f)
        v2 = tuple(arb_poly([x, (y * h / m).mid()]) for x, y, m in zip(at.v2, f, system.m2, strict=True))
        v1 = [x + y for x, y in zip(v2, s, strict=True)]
        q1 = tuple(midpoints((x * h).integral() + q) for x, q in zip(v1, at.q1, strict=True))
        curve = Curve(at.piece, t, q1, v2, s, self.apart_of(s, t), impulse)
        found = defect(system, curve, [h * x.rad() for x in f])
        norm = (self.norm + found.norm).upper()
        limit = 2 * drive.reach * norm
        if not (found.norm < 2 * enough and limit < size):
            return
        near = self.loads_along(found)
        if not drive.strain(near) < 1 and drawn_to(system, drive, near, at.s) is None:
            return
        direction = at.s
        self.go_on(curve, SLIP, arb(1), norm, ends=False)
        self.at = self.at._replace(s=[arb(0)] * system.n)
        self.meet(found, h * limit / size, direction)

    def meet(self, found: Defect, late: arb, s: Balls) -> None:
        """Go on from s = 0, which a slip has come to: it sticks if the load is inside K, and passes if outside."""
        system, drive = self.system, self.system.pieces[self.at.piece]
        at = self.at
        left = sum((x * x / k for x, k in zip(at.s, system.kappa, strict=True)), arb(0)).sqrt() + self.norm
        weak = min_of([b * root for b, root in zip(drive.b, system.apart, strict=True)])
        near = self.loads_along(found)
        strain = drive.strain(near)
        if strain < 1:
            rate, direction = (1 - sqrt(strain)) * weak, s
        elif strain > 1:
            drawn = drawn_to(system, drive, near, s)
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
        if strain < 1:
            direction = end_direction(system, drive, self.load(late), s)
        jump = system.norm(
            [arb(0)] * system.n,
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
        with system.fine():
            direction = self.first_direction(first, self.load(late), m)
        self.mode = SLIP
        if cause is not None:
            self.happened(before, direction, late, cause)
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
                bound = self.eps * 2**12 * self.sizes[1] * max_of(system.root_m1 + system.root_m2)
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

    def first_direction(self, first: Balls, load: Balls, m: int) -> Balls:
        """Return S_0 of the true motion, not normalised: kap (Lam - P Lam) moves no more than Lam."""
        system, drive = self.system, self.system.pieces[self.at.piece]
        if m == 2:
            return [x / b for x, b in zip(load, drive.b_squared, strict=True)]
        off = sum((k * x.rad() * x.rad() for k, x in zip(system.kappa, load, strict=True)), arb(0)).sqrt() + self.eps
        return [x + arb(0, (root * off).upper()) for x, root in zip(first, system.apart, strict=True)]

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
        return two_to(min(found, log2(self.sizes[2]) + 4) - (0.4 if m == 2 else 0.1)), top


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


def clock(at: Point, series: Series, h: arb) -> arb_poly:
    """Return the time along a slip, from exactly where the path is: the working precision has less digits of it."""
    t = scaled(series.t, h)
    t[0] = at.t
    return t


def min_of(values: Sequence[arb]) -> arb:
    """Return a lower bound of the least."""
    found = values[0]
    for one in values[1:]:
        found = found.min(one)
    return found
