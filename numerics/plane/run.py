"""The run of a scene: a box, and an ellipsoid, whose slips are not linear; N bounds how far the true motion is.

A motion sticks while Lam = M2 (M1+M2)^-1 (u - A2 q1 - A1 v1) is in K. Where the bound N leaves no doubt that s is not 0
(or that Lam is inside K), the true motion is in the path's mode; between, short windows remain, in which (motion.py
says what holds all through one):

- a slip ends, if Lam is inside K: |s|_{kap^-1} is at most N where the path has s = 0, it falls at a rate of at least
  (1 - |B^-1 Lam|) min b sqrt(kap), since s.(Lam - f) <= -(1 - |B^-1 Lam|) h(s), and then the motion sticks;
- a slip begins, if n.Lam > h(n) with one n: n.kap^-1 s rises then, whatever f is;
- with Lam outside K it passes through s = 0, if no direction near its own is drawn away (passage.py).
"""

from __future__ import annotations

from itertools import accumulate, pairwise

from flint import arb, arb_poly, arb_series

from numerics.arithmetic.ball import sqrt
from numerics.errors import NotSettled
from numerics.plane.defect import Defect, slip_defect
from numerics.plane.linear import LinearPath
from numerics.plane.onset import first_slip, onset, slow_series
from numerics.plane.passage import Drawn, drawn_to, end_direction
from numerics.plane.path import OUTSIDE
from numerics.plane.polynomial import first_root, log2, midpoints, rise, scaled, two_to
from numerics.plane.series import CurveStep, Expansion, Point, Series, step_from
from numerics.plane.system import highest
from numerics.plane.vector import Vector, wide

_FALL = 2.0**-7
"""A step takes no more of h(s) than that: where a slip ends is known that well."""
_MANY = 12
"""A step of a slip is shortened so many times before its bound is asked whether s may be 0."""
_OFTEN = 8
"""Steps of a slip between two questions whether it has settled."""
_QUICK = 256
"""It is asked where a direction settles so many times in the time in which things change."""
_QUICKER = 64
"""So many times quicker some axes settle than the last, if these alone are asked."""


class PlaneRun(LinearPath):
    """A path with slips of an ellipsoid; `steps` counts those of a slip since one that had settled was tried."""

    steps, stride = 0, arb(0)

    def follow(self) -> None:
        """Follow the path to the end, or to the cap on events. Raises EventUndecided, NotSettled."""
        with self.system.fine():
            self.start()
            while not self.reached and len(self.events) < self.max_events:
                piece, time = self.at.piece, self.system.time(self.at)
                if len(self.legs) >= self.max_legs:
                    raise NotSettled(f"{len(self.legs)} steps end at t = {time:.6g} s; give an earlier horizon")
                self.one_step()
                if self.at.piece > piece and not self.reached:
                    self.jump()
                if self.progress is not None and len(self.legs) % 32 == 0:
                    self.progress(len(self.events), time / float(self.systems[-1].given.pieces[-1].end))

    def jump(self) -> None:
        """Go on in another piece of force or friction, on all axes if it leads away from the line."""
        if self.at.piece == len(self.system.pieces):
            line, self.system = self.system, self.systems[-1]
            d = Vector(n @ line.place[0] for n in self.system.force)
            self.mode = self.system.n * ("0" if self.mode == "0" else "*")
            self.set(Point(self.at.piece, self.at.t, *(d * part[0] for part in self.at[2:])))
        super().jump()

    def one_step(self) -> None:
        """Stick or slip for a step, or to the first event in it; a slip that has settled, for a long one."""
        if "*" not in self.mode:
            super().one_step()
        elif self.young:
            self.begin()
        else:
            self.steps += 1
            if self.steps % _OFTEN or not self.settled():
                self.slip_on()

    def tell(self, before: str, late: arb, cause: str) -> None:
        """Record an event; a slip whose friction changes begins in the direction in which it is drawn."""
        if "*" in self.mode:
            self.record(before, self.first_direction(), late, cause)
        else:
            super().tell(before, late, cause)

    def slip_on(self) -> None:
        """Slip for a step, and on to what follows if s gets to 0 in it."""
        system, at, drive = self.system, self.at, self.drive
        slip = Expansion(system, at)
        h = slip.reach(highest(at.s)).mid()
        for tries in range(60):
            step = slip.drawn(h)
            t, rate = step.curve.t, step.curve.t.derivative()
            shorter = 0.75
            if rate(1) > rate[0] * _FALL:
                shorter = 0.5
                found, slowest = slip_defect(system, step, step.curve.s, rate * (1 / h))
                norm = (self.norm + found.norm).upper()
                if slowest > drive.reach * norm:
                    break
                if slowest > 0 and tries > _MANY:
                    self.stop()
                    return
            h = (h * shorter).mid()
        else:
            raise self.undecided("does the slip turn or end")
        ends = bool(t(1) >= drive.length)
        end = rise(t, drive.length) if ends else arb(1)
        self.stride = t(end) - at.t
        self.go_on(step.curve, end, norm, ends=ends)

    @property
    def narrow(self) -> arb:
        """Return how well the direction of a slip is to be known where its end is decided."""
        return arb((1, -(self.system.bits // 6)))

    @property
    def enough(self) -> arb:
        """Return what N may grow by where a slip begins or ends: a rounding of velocities, some bits larger."""
        system = self.system
        return system.eps * 2**12 * system.speed * highest(Vector((*system.root_m1, *system.root_m2)))

    def settled(self) -> bool:
        """Go on with the series of a slip that has settled, to its end if it comes in it; return whether that is it."""
        drive = self.drive
        size, slowest = drive.friction(self.at.s)[1], highest(drive.heavy)
        quick = [bool(x * size * _QUICK < self.system.period) for x in drive.heavy]
        quicker = [one and bool(x * _QUICKER < slowest) for x, one in zip(drive.heavy, quick, strict=True)]
        for axes in (quick, quicker):
            series = slow_series(self.system, self.at, axes) if any(axes) else None
            if series is not None:
                h, top = self.reach(series, 0)
                if any(self.settle(series, (h / 2**k).mid(), top) for k in range(3)):
                    self.steps = -1
                    return True
        return False

    def settle(self, series: Series, h: arb, top: int) -> bool:
        """Go on with a series for a time h, if it is as good as a step, and much longer or the last one."""
        h, ends = self.fitted(h)
        root = first_root(scaled(series.size[:top], h), arb(0))
        if isinstance(root, bool) or (root is None and h < 4 * self.stride):
            return False
        if root is not None:
            h, ends = (h * root[0]).mid(), False
        step, slip, found, slowest = self.along(series, h, top, 0 if root is None else -1)
        jump = step.curve.s.order(0) - self.at.s
        added = found.norm + self.system.norm(self.system.still, jump, self.system.still)
        norm = (self.norm + added).upper()
        if not (added < self.enough / 2**7 + self.norm / 8 and self.narrow * slowest > 4 * self.drive.reach * norm):
            return False
        if root is None:
            self.go_on(step.curve, arb(1), norm, ends=ends)
        else:
            self.end(step.curve, norm, slip, slowest)
        return True

    def along(self, series: Series, h: arb, top: int, m: int) -> tuple[CurveStep, Vector, Defect, arb]:
        """Return the step of a slip s = tau^m S on [0, h], of s = (1 - x) S for m = -1, and S.

        Its defect, and a lower bound of h(S) (0: none).
        """
        q1, v2 = (Vector(scaled(x[: top + 1], h) for x in part) for part in series[:2])
        size, *slip = (scaled(x[:top], h) for x in (series.size, *series.slip))
        if m < 0:
            size, *slip = (arb_poly(list(accumulate(one.coeffs()))[:-1]) for one in (size, *slip))
        t, swing = arb_poly([self.at.t, h]), self.drive.swing(arb_series([self.at.t, h], top + 2))
        s = Vector(slip) * arb_poly([1, -1] if m < 0 else [0] * m + [(h**m).mid()])
        impulse = v2.each(arb_poly.derivative) * self.system.m2
        step = step_from(self.at, t, q1, v2, s, impulse, [tuple(map(midpoints, one)) for one in swing])
        return step, Vector(slip), *slip_defect(self.system, step, Vector(slip), size)

    def end(self, curve: Point, norm: arb, slip: Vector, slowest: arb) -> None:
        """Go along s = (1 - x) S to s = 0; the motion slips up to a time `early` before, when |s|_{kap^-1} is N.

        Up to a time early/narrow before, its direction is that of S up to `narrow`; |s| is a multiple of N then.
        """
        self.go_on(curve, arb(1), norm, ends=False)
        self.at = self.at._replace(s=self.system.still)
        part = (self.drive.reach * self.norm / slowest).upper()
        near_end = arb(1) - arb(0).union(part / self.narrow)
        s = slip.each(lambda p: p(near_end))
        size = self.system.length(s)
        early = part.min(self.norm / size.lower()) * curve.t[1]
        self.arrive(early.upper(), wide(s, self.system.apart * (size * self.narrow)))

    def stop(self) -> None:
        """Put s = 0 where it is no larger than N allows: the motion slips up to here."""
        if not self.drive.strain(self.load, self.system.axes) < 1:
            raise self.undecided("does the slip turn around s = 0 or pass through it")
        self.halt(self.at.s)
        self.arrive(arb(0), None)

    def arrive(self, early: arb, s: Vector | None) -> None:
        """Go on from s = 0, where |s|_{kap^-1} <= N: it sticks if the load is inside K, and passes if it is outside.

        `s`: the directions before, if they are known.
        """
        before, (fall, _) = self.mode, self.fate(self.load, s)
        window = arb(0) if fall is None else early / self.narrow + 2 * self.norm / fall
        near = self.around(window).load
        (fall, drawn), strain = self.fate(near, s), self.drive.strain(near, self.system.axes)
        late = window if fall is None else early.max(self.norm / fall)
        if not (late < window and (strain < 1 or strain > 1)):
            raise self.undecided("does the slip end, turn around s = 0 or pass through it")
        if strain < 1:
            self.put(0, self.system.still)
            direction = end_direction(self.system, self.drive, self.around(late).load, drawn)
            self.record(before, direction, late, "guard")
        else:
            self.let_go(0, self.load, 1)
            self.after = late
            self.tell(before, late, "guard")

    def fate(self, load: Vector, s: Vector | None) -> tuple[arb | None, Drawn | None]:
        """Return how fast a slip under these loads surely falls to s = 0, None if it may turn; how it is drawn."""
        drawn, strain = None, self.drive.strain(load, self.system.axes)
        if s is not None:
            drawn = drawn_to(self.system, self.drive, load, s)
        falls = [drawn.psi] if drawn else []
        if strain < 1:  # in any direction; it may be known better where s points
            falls.append((1 - sqrt(strain)) * self.drive.weak)
        return max(falls, default=None), drawn

    def first_direction(self) -> Vector:
        """Return S_0 of the motion that begins to slip, not normalised: kap (Lam - P Lam) moves no more than Lam."""
        drive, load = self.drive, self.around(self.after).load
        if self.young[0] == 2:
            return Vector(load / drive.b_squared)
        g, h = first_slip(self.system, drive, self.load.each(arb.mid))
        radii = load.each(arb.rad)
        off = (radii * radii @ self.system.kappa).sqrt() + self.system.eps
        return Vector(wide(g * h / drive.b, self.system.apart * off))

    def begin(self) -> None:
        """Go on from s = 0: s = tau^m S(tau)."""
        system, drive, m, load = self.system, self.drive, self.young[0], self.load.each(arb.mid)
        direction = self.first_direction()
        self.young, self.steps = {}, 0 if m == 1 else -1
        series = onset(system, self.at, load, m)
        h, top = self.reach(series, m)
        h, ends = self.fitted(h)
        for _ in range(60):
            step, _, found, slowest = self.along(series, h, top, m)
            if found.norm < self.enough:
                break
            h, ends = (h / 2).mid(), False
        else:
            raise self.undecided("how does the slip begin")
        norm = (self.norm + found.norm).upper()
        window = (2 * drive.reach * norm / slowest).upper().root(m) + 2 * self.after
        if not (window < h / 2 and self.leaves(direction, window, m)):
            raise self.undecided(OUTSIDE)
        self.stride, self.after = h, arb(0)
        self.go_on(step.curve, arb(1), norm, ends=ends)

    def reach(self, series: Series, m: int) -> tuple[arb, int]:
        """Return how far the series of a slip reaches, and how many of its terms: for m != 1 it diverges."""
        first, *logs = (max(map(log2, one)) for one in zip(*series.slip, strict=True))
        reach = [min(64.0, (first - self.system.bits - one) / k) for k, one in enumerate(logs[:-1], start=1)]
        both = [min(two) for two in pairwise(reach)]
        found = both[-1] if m == 1 else max(both[3:])
        top = 2 + max(k for k, one in enumerate(both) if one >= found and (k > 2 or m == 1))
        return two_to(min(found, log2(self.system.period) + 4) - (0.1 if m == 1 else 0.4)), top + (m == 1)
