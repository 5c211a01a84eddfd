"""The path of a scene on a surface: stick, slip, and what joins them; N bounds how far the true motion is from it.

A motion sticks while Lam = M2 (M1+M2)^-1 (u - A2 q1 - A1 v1) is in K. Where the bound N leaves no doubt that s is not 0
(or that Lam is inside K), the true motion is in the path's mode; between, short windows remain, in which (window.py
says what holds all through one):

- a slip ends, if Lam is inside K: |s|_{kap^-1} is at most N where the path has s = 0, it falls at a rate of at least
  (1 - |B^-1 Lam|) min b sqrt(kap), since s.(Lam - f) <= -(1 - |B^-1 Lam|) h(s), and then the motion sticks;
- a slip begins, if n.Lam > h(n) with one n: n.kap^-1 s rises then, whatever f is;
- with Lam outside K it passes through s = 0, if no direction near its own is drawn away (passage.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate

from flint import arb, arb_poly

from numerics.arithmetic.ball import sqrt
from numerics.errors import NotSettled
from numerics.plane.defect import Curve, Defect, Polynomials, defect, onset_defect, slip_defect
from numerics.plane.onset import Onset, onset
from numerics.plane.passage import drawn_to, end_direction
from numerics.plane.path import SLIP, STICK, Path, log2, max_of, two_to
from numerics.plane.polynomial import at_one, first_root, midpoints, rise, scaled
from numerics.plane.series import Point, Series, slip_series, stick_series
from numerics.plane.slow import slow_series
from numerics.plane.system import Balls, System
from numerics.plane.window import wide

_FALL = 2.0**-7
"""A step takes no more of h(s) than that: where a slip ends is known that well."""
_OFTEN = 8
"""Steps of a slip between two questions whether it has settled."""
_SHORT = 2.0**-20
"""The part of a step after which a load that falls from the edge into K is seen inside."""


class Run(Path):
    """The path of an ellipsoid; `steps` counts those of a slip since one that had settled was tried."""

    steps = 0

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
        with system.fine():
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
            root = self.exit(curve, found, norm, start=_SHORT if self.falls_inside(h) else 0.0)
            if root is None:
                self.go_on(curve, STICK, arb(1), norm, ends=ends)
                return
            x, off = root
            self.go_on(curve, STICK, x, norm, ends=False)
            self.begin(2, "guard", STICK, (off * h).upper())

    def falls_inside(self, h: arb) -> bool:
        """Return whether the step begins on the edge of K: the load falls inside then, till _SHORT of it at least."""
        if not self.on_edge:
            return False
        self.on_edge = False
        near = self.around(h * _SHORT)
        if not self.outward(near.drift, near.load) < 0:
            raise self.undecided("does the load leave the friction set at t = 0")
        return True

    def outward(self, turn: Balls, load: Balls) -> arb:
        """Return half the rate of |B^-1 Lam|^2, at the rate `turn` of Lam."""
        b_squared = self.system.pieces[self.at.piece].b_squared
        return sum((x * y / b for x, y, b in zip(turn, load, b_squared, strict=True)), arb(0))

    def slip_on(self) -> None:
        """Slip for a step, and on to what follows if s gets to 0 in it; a slip that has settled, for a long one."""
        self.steps += 1
        if self.steps % _OFTEN == 0 and self.settled():
            self.steps = -1
            return
        system, at = self.system, self.at
        drive, (q, v, time) = system.pieces[at.piece], self.sizes
        with system.fine():
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
        for halving in range(60):
            with system.fine():
                t, parts = clock(at, series, h), [tuple(scaled(x, h) for x in part) for part in series[1:]]
            with system.fine():
                q1, v2, s = parts
                impulse = tuple(x * (b * h) for x, b in zip(s, drive.b_squared, strict=True))
                curve = Curve(at.piece, t, q1, v2, s, self.apart_of(s, t), impulse)
                found, slowest = slip_defect(system, curve, h)
                norm = (self.norm + found.norm).upper()
            if slowest > drive.reach * norm:
                break
            if slowest > 0 and halving > 5:
                self.stop()
                return
            h, ends = (h / 2).mid(), False
        else:
            raise self.undecided("does the slip turn or end")
        with system.fine():
            self.go_on(curve, SLIP, arb(1), norm, ends=ends)
            if not ends:
                self.land()

    @property
    def narrow(self) -> arb:
        """Return how well the direction of a slip is to be known where its end is decided."""
        return arb((1, -(self.system.bits // 6)))

    @property
    def enough(self) -> arb:
        """Return what N may grow by where a slip begins or ends: a rounding of velocities, some bits larger."""
        return self.eps * 2**12 * self.sizes[1] * max_of(self.system.root_m1 + self.system.root_m2)

    def settled(self) -> bool:
        """Go on with the series of a slip that has settled, to its end if it comes in it; return whether that is it."""
        system = self.system
        with system.fine():
            series = slow_series(system, self.at, system.degree, 0)
            if series is None:
                return False
            h, top = self.reach(series.slip, 0)
        return any(self.settle(series, (h / 2**k).mid(), top) for k in range(3))

    def settle(self, series: Onset, h: arb, top: int) -> bool:
        """Go on with a series for a time h, if it is as good as a step."""
        system, at = self.system, self.at
        drive, still = system.pieces[at.piece], [arb(0)] * system.n
        with system.fine():
            left = (drive.length - at.t).mid()
            h, ends = (left, True) if h >= left else (h, False)
            root = first_root(scaled(series.size[:top], h), arb(0))
            if isinstance(root, bool):
                return False
            if root is not None:
                h, ends = (h * root[0]).mid(), False
            size, *slip = (scaled(x[:top], h) for x in (series.size, *series.slip))
            if root is not None:  # s = (1 - x) S
                size, *slip = (arb_poly(list(accumulate(one.coeffs()))[:-1]) for one in (size, *slip))
        with system.fine():
            weight = arb_poly([1] if root is None else [1, -1])
            curve, found, slowest = self.along(series, h, top, tuple(slip), size, weight)
            jump = [abs(x[0] - y) for x, y in zip(curve.s, at.s, strict=True)]
            added = found.norm + system.norm(still, jump, still)
            norm = (self.norm + added).upper()
            if not (added < self.enough / 2**7 + self.norm / 8 and self.narrow * slowest > 4 * drive.reach * norm):
                return False
            if root is None:
                self.go_on(curve, SLIP, arb(1), norm, ends=ends)
            else:
                self.end(curve, norm, slip, slowest)
        return True

    def along(
        self, series: Onset, h: arb, top: int, slip: Polynomials, size: arb_poly, weight: arb_poly
    ) -> tuple[Curve, Defect, arb]:
        """Return the curve of a slip s = weight S on [0, h], its defect, and a lower bound of h(S) (0: none)."""
        at, system = self.at, self.system
        q1, v2 = (tuple(scaled(x[: top + 1], h) for x in part) for part in series[:2])
        s, t = tuple(x * weight for x in slip), arb_poly([at.t, h])
        impulse = tuple(p.derivative() * w for p, w in zip(v2, system.m2, strict=True))
        curve = Curve(at.piece, t, q1, v2, s, self.apart_of(s, t), impulse)
        return curve, *onset_defect(system, curve, slip, size, h)

    def land(self) -> None:
        """Slip straight to s = 0, if that is a motion as good as any: with f constant s falls linearly."""
        system, at = self.system, self.at
        drive, load, left = system.pieces[at.piece], self.load(), self.system.pieces[at.piece].length - at.t
        f, size = drive.friction(at.s)
        weight = sum((x * x / k for x, k in zip(at.s, system.kappa, strict=True)), arb(0))
        fall = sum(((x - y) * s for x, y, s in zip(f, load, at.s, strict=True)), arb(0))
        enough = self.norm / 64 + self.enough / 2**12
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
        if not (found.norm < 2 * enough and 4 * drive.reach * norm < size * self.narrow):
            return
        if drive.strain(load) < 1 or drawn_to(system, drive, load, at.s) is not None:
            self.end(curve, norm, [arb_poly([x]) for x in at.s], size)

    def end(self, curve: Curve, norm: arb, slip: Sequence[arb_poly], slowest: arb) -> None:
        """Go along s = (1 - x) S to s = 0; the motion slips up to a time `early` before, when h(s) is 2 sup h(N).

        At a time early/narrow its direction is that of S up to `narrow`.
        """
        system, drive = self.system, self.system.pieces[curve.piece]
        self.go_on(curve, SLIP, arb(1), norm, ends=False)
        self.at = self.at._replace(s=[arb(0)] * system.n)
        part = (2 * drive.reach * self.norm / slowest).upper()
        near_end = arb(1) - arb(0).union(part / self.narrow)
        self.arrive(part * curve.t[1], [p(near_end) for p in slip])

    def stop(self) -> None:
        """Put s = 0 where it is no larger than N allows: the motion slips up to here."""
        system, at = self.system, self.at
        with system.fine():
            if not system.pieces[at.piece].strain(self.load()) < 1:
                raise self.undecided("does the slip turn around s = 0 or pass through it")
            first = [y / m * s for y, m, s in zip(system.m2, system.mass, at.s, strict=True)]
            second = [s - x for s, x in zip(at.s, first, strict=True)]
            self.norm = (self.norm + system.norm([arb(0)] * system.n, first, second)).upper()
            v2 = [v + x for v, x in zip(at.v2, second, strict=True)]
            self.set(at._replace(v2=v2, s=[arb(0)] * system.n))
            self.arrive(arb(0), at.s)

    def arrive(self, early: arb, s: Balls) -> None:
        """Go on from s = 0, where |s|_{kap^-1} <= N: it sticks if the load is inside K, and passes if it is outside."""
        system, drive = self.system, self.system.pieces[self.at.piece]
        length = sum((x * x / k for x, k in zip(s, system.kappa, strict=True)), arb(0)).sqrt()
        s_wide = [wide(x, length * self.narrow * root) for x, root in zip(s, system.apart, strict=True)]
        weak = min_of([b * root for b, root in zip(drive.b, system.apart, strict=True)])
        inside = drive.strain(self.load()) < 1

        def rate(load: Balls) -> arb | None:
            if not inside:
                return drawn_to(system, drive, load, s_wide)
            strain = drive.strain(load)
            return (1 - sqrt(strain)) * weak if strain < 1 else None

        about = rate(self.load())
        window = early / self.narrow + 2 * self.norm / about if about is not None else arb(0)
        near = self.load(window)
        fall = rate(near)
        outside = bool(drive.strain(near) > 1)
        if fall is None or inside == outside or not (late := early + self.norm / fall) < window:
            raise self.undecided("does the slip end, turn around s = 0 or pass through it")
        self.apart = [(x + r * self.norm * late).upper() for x, r in zip(self.apart, system.apart, strict=True)]
        if inside:
            self.mode = STICK
            self.happened(SLIP, end_direction(system, drive, self.load(late), s), late, "guard")
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
            near = self.around(arb(0))
            way = self.outward(near.drift, near.load)
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
        with system.fine():
            series: Onset | None
            if m == 1:
                series = onset(system, at, [x.mid() for x in load], system.degree)
            else:
                series = slow_series(system, at, int(0.75 * system.bits) + 8, 2)
            if series is None:
                raise self.undecided("how does the slip begin")
            h, top = self.reach(series.slip, m)
            left = (drive.length - at.t).mid()
            ends = bool(h >= left)
            h = left if ends else h
        first = [one[0] for one in series.slip]
        with system.fine():
            direction = self.first_direction(first, self.load(late), m)
        self.mode, self.steps = SLIP, 0 if m == 1 else -1
        if cause is not None:
            self.happened(before, direction, late, cause)
        for _ in range(60):
            with system.fine():
                size, *slip = (scaled(x[:top], h) for x in (series.size, *series.slip))
            with system.fine():
                curve, found, slowest = self.along(
                    series, h, top, tuple(slip), size, arb_poly([0] * m + [(h**m).mid()])
                )
            if found.norm < self.enough:
                break
            h, ends = (h / 2).mid(), False
        else:
            raise self.undecided("how does the slip begin")
        with system.fine():
            norm = (self.norm + found.norm).upper()
            window = (2 * drive.reach * norm / slowest).upper().root(m) + 2 * late
            if not (window < h / 2 and self.leaves(first if m == 1 else direction, window, m)):
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
        size, least = log2(max_of([one[0] for one in slip])), 4
        reach = [
            (size - self.system.bits - max(log2(one[k]) for one in slip)) / k
            if any(one[k] != 0 for one in slip)
            else 64.0
            for k in range(1, len(slip[0]) - 1)
        ]
        if m == 1:
            found, top = min(reach[-2:]), len(reach) + 1
        else:
            found = max(min(reach[k - 1], reach[k]) for k in range(least, len(reach)))
            top = 1 + max(k for k in range(least, len(reach)) if min(reach[k - 1], reach[k]) >= found)
        return two_to(min(found, log2(self.sizes[2]) + 4) - (0.1 if m == 1 else 0.4)), top


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
