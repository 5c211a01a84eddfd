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

from fractions import Fraction
from itertools import accumulate, pairwise

from flint import arb, arb_poly

from numerics.arithmetic.ball import sqrt
from numerics.plane.candidate import candidates
from numerics.plane.defect import Curve, Defect, defect, slip_defect
from numerics.plane.onset import onset, slow_series
from numerics.plane.passage import Drawn, drawn_to, end_direction
from numerics.plane.path import AGAIN, LATE, SHORT, SLIP, STICK, Path, exactly_on_edge, log2, two_to
from numerics.plane.polynomial import first_root, midpoints, rise, scaled
from numerics.plane.series import Series
from numerics.plane.slip import own_clock
from numerics.plane.system import System, highest
from numerics.plane.vector import Vector, wide

_FALL = 2.0**-7
"""A step takes no more of h(s) than that: where a slip ends is known that well."""
_OFTEN = 8
"""Steps of a slip between two questions whether it has settled."""
_QUICK = 256
"""It is asked where a direction settles so many times in the time in which things change."""
_QUICKER = 64
"""So many times quicker some axes settle than the last, if these alone are asked."""


class Run(Path):
    """The path of an ellipsoid; `steps` counts those of a slip since one that had settled was tried.

    `held`: nothing but another piece of force or friction ends this stick.
    """

    steps, on_edge, held, stride = 0, False, False, arb(0)

    def one_step(self) -> None:
        """Stick or slip for a step, or to the first event in it."""
        (self.stick_on if self.mode == STICK else self.slip_on)()

    def stick_on(self) -> None:
        """Stick for a step, or until the load leaves K."""
        held = [None] * self.system.n
        series, reach = self.linear(held, self.system.degree)
        h, ends = self.fitted(reach)
        start = SHORT if not self.held and self.falls_inside(h) else 0.0
        while True:
            curve, found, norm = self.drawn(series, h, held)
            root = None if self.held else self.exit(curve, found, norm, self.system.axes, start)
            if root is None or root[0] > LATE:
                break
            h, ends = (h * root[0] * AGAIN).mid(), False
        if root is None:
            self.go_on(curve, STICK, arb(1), norm, ends=ends)
            return
        x, off = root
        self.go_on(curve, STICK, x, norm, ends=False)
        self.begin(2, "guard", STICK, (off * h).upper())

    def falls_inside(self, h: arb) -> bool:
        """Return whether the step begins on the edge of K: the load falls inside then, till SHORT of it at least."""
        if not self.on_edge:
            return False
        self.on_edge = False
        if not self.outward(h * SHORT) < 0:
            raise self.undecided("does the load leave the friction set at t = 0")
        return True

    def outward(self, window: arb) -> arb:
        """Return half the rate of |B^-1 Lam|^2 while both bodies stick, within a window."""
        near = self.around(window)
        found: arb = near.load / self.system.pieces[self.at.piece].b_squared @ near.drift
        return found

    def slip_on(self) -> None:
        """Slip for a step, and on to what follows if s gets to 0 in it; a slip that has settled, for a long one."""
        self.steps += 1
        if (self.steps % _OFTEN == 0 or self.system.n == 1) and self.settled():
            self.steps = -1
            return
        system, at = self.system, self.at
        drive, slips = system.pieces[at.piece], candidates(system, at)
        sizes = highest(at.s), self.place, self.speed, self.period
        h = (self.step(*zip(slips.rows, sizes, strict=True)) * slips.unit).mid()
        drawn, x = slips.drawn(h), arb(1)
        rate = drawn.t.derivative()
        while not rate(x) > rate[0] * _FALL:
            x = (x * 0.75).mid()
        if drawn.t(x) > drive.length:
            x = x.min(rise(drawn.t, drive.length) * AGAIN)
        for halving in range(60):
            if x < 1:
                h = (h * x).mid()
                drawn = slips.drawn(h)
            found, x = own_clock(system, at, drawn, h, self.norm), arb(0.5)
            if found.slowest > drive.reach * found.norm:
                break
            if found.slowest > 0 and halving > 5:
                self.stop()
                return
        else:
            raise self.undecided("does the slip turn or end")
        clock = found.curve.t
        ends = bool(clock(1) >= drive.length)
        end = rise(clock, drive.length) if ends else arb(1)
        self.stride = clock(end) - at.t
        self.go_on(found.curve, SLIP, end, found.norm, ends=ends)
        if not ends:
            self.land()

    @property
    def narrow(self) -> arb:
        """Return how well the direction of a slip is to be known where its end is decided."""
        return arb((1, -(self.system.bits // 6)))

    @property
    def enough(self) -> arb:
        """Return what N may grow by where a slip begins or ends: a rounding of velocities, some bits larger."""
        return self.eps * 2**12 * self.speed * self.heaviest

    @property
    def heaviest(self) -> arb:
        """Return the largest root of a mass: N of a velocity of 1."""
        return highest(Vector((*self.system.root_m1, *self.system.root_m2)))

    def settled(self) -> bool:
        """Go on with the series of a slip that has settled, to its end if it comes in it; return whether that is it."""
        drive = self.system.pieces[self.at.piece]
        size, n = drive.friction(self.at.s)[1], self.system.n
        quick = [n == 1 or bool(x * size * _QUICK < self.period) for x in drive.heavy]
        quicker = [one and bool(x * _QUICKER < highest(drive.heavy)) for x, one in zip(drive.heavy, quick, strict=True)]
        for axes in (quick, quicker):
            if any(axes):
                series = slow_series(self.system, self.at, self.system.degree, axes)
                if series is not None:
                    h, top = self.reach(series, 0)
                    if any(self.settle(series, (h / 2**k).mid(), top) for k in range(3)):
                        return True
        return False

    def settle(self, series: Series, h: arb, top: int) -> bool:
        """Go on with a series for a time h, if it is as good as a step, and much longer or the last one."""
        system, at, (h, ends) = self.system, self.at, self.fitted(h)
        root = first_root(scaled(series.size[:top], h), arb(0))
        if isinstance(root, bool) or (root is None and h < 4 * self.stride):
            return False
        if root is not None:
            h, ends = (h * root[0]).mid(), False
        size, *slip = (scaled(x[:top], h) for x in (series.size, *series.slip))
        if root is not None:  # s = (1 - x) S
            size, *slip = (arb_poly(list(accumulate(one.coeffs()))[:-1]) for one in (size, *slip))
        curve, found, slowest = self.along(
            series, h, top, Vector(slip), size, arb_poly([1] if root is None else [1, -1])
        )
        jump = curve.s.order(0) - at.s
        added = found.norm + system.norm(system.still, jump, system.still)
        norm = (self.norm + added).upper()
        reach = system.pieces[at.piece].reach
        if not (added < self.enough / 2**7 + self.norm / 8 and self.narrow * slowest > 4 * reach * norm):
            return False
        if root is None:
            self.go_on(curve, SLIP, arb(1), norm, ends=ends)
        else:
            self.end(curve, norm, Vector(slip), slowest)
        return True

    def along(
        self, series: Series, h: arb, top: int, slip: Vector, size: arb_poly, weight: arb_poly
    ) -> tuple[Curve, Defect, arb]:
        """Return the curve of a slip s = weight S on [0, h], its defect, and a lower bound of h(S) (0: none)."""
        q1, v2 = (Vector(scaled(x[: top + 1], h) for x in part) for part in series[:2])
        impulse = v2.each(arb_poly.derivative) * self.system.m2
        curve = Curve.of(self.at, arb_poly([self.at.t, h]), q1, v2, slip * weight, impulse)
        return curve, *slip_defect(self.system, curve, slip, size)

    def land(self) -> None:
        """Slip straight to s = 0, if that is a motion as good as any: with f constant s falls linearly."""
        system, at = self.system, self.at
        drive, load = system.pieces[at.piece], self.load()
        f, size = drive.friction(at.s)
        fall = (f - load) @ at.s
        enough = self.norm / 64 + self.enough / 2**12
        if not (fall > 0 and (h := (at.s * at.s @ (1 / system.kappa) / fall).mid()) < drive.length - at.t):
            return
        if not highest((at.s / (system.kappa * h) + load - f) * h) < enough * self.heaviest:
            return
        middle = f.each(arb.mid)
        v2 = Vector(arb_poly([x, (y * h).mid()]) for x, y in zip(at.v2, middle / system.m2, strict=True))
        s = at.s.each(lambda x: arb_poly([x, -x]))
        q1 = ((v2 + s).each(lambda x: midpoints((x * h).integral())) + at.q1).each(midpoints)
        curve = Curve.of(at, arb_poly([at.t, h]), q1, v2, s, middle.each(lambda x: arb_poly([x * h])))
        found = defect(system, curve, f.each(arb.rad) * h)
        norm = (self.norm + found.norm).upper()
        if not (found.norm < 2 * enough and 4 * drive.reach * norm < size * self.narrow):
            return
        if drive.strain(load) < 1 or drawn_to(system, drive, load, at.s) is not None:
            self.end(curve, norm, at.s.each(lambda x: arb_poly([x])), size)

    def end(self, curve: Curve, norm: arb, slip: Vector, slowest: arb) -> None:
        """Go along s = (1 - x) S to s = 0; the motion slips up to a time `early` before, when |s|_{kap^-1} is N.

        Up to a time early/narrow before, its direction is that of S up to `narrow`; |s| is a multiple of N then.
        """
        self.go_on(curve, SLIP, arb(1), norm, ends=False)
        self.at = self.at._replace(s=self.system.still)
        part = (self.system.pieces[curve.piece].reach * self.norm / slowest).upper()
        near_end = arb(1) - arb(0).union(part / self.narrow)
        s = slip.each(lambda p: p(near_end))
        size = self.system.length(s)
        early = part.min(self.norm / size.lower()) * curve.t[1]
        self.arrive(early.upper(), wide(s, self.system.apart * (size * self.narrow)))

    def stop(self) -> None:
        """Put s = 0 where it is no larger than N allows: the motion slips up to here."""
        system, at = self.system, self.at
        if not system.pieces[at.piece].strain(self.load()) < 1:
            raise self.undecided("does the slip turn around s = 0 or pass through it")
        self.halt(at.s)
        self.arrive(arb(0), None)

    def arrive(self, early: arb, s: Vector | None) -> None:
        """Go on from s = 0, where |s|_{kap^-1} <= N: it sticks if the load is inside K, and passes if it is outside.

        `s`: the directions before, if they are known.
        """
        system, drive = self.system, self.system.pieces[self.at.piece]
        inside = drive.strain(self.load()) < 1

        def fate(load: Vector) -> tuple[arb | None, Drawn | None]:
            drawn = drawn_to(system, drive, load, s) if s is not None else None
            if not inside:
                return drawn and drawn.psi, drawn
            if not (strain := drive.strain(load)) < 1:
                return None, drawn
            slowest = (1 - sqrt(strain)) * drive.weak  # in any direction; it may be known better where s points
            return slowest if drawn is None else slowest.max(drawn.psi), drawn

        about, _ = fate(self.load())
        window = early / self.narrow + 2 * self.norm / about if about is not None else arb(0)
        near = self.load(window)
        fall, drawn = fate(near)
        outside = bool(drive.strain(near) > 1)
        if fall is None or inside == outside or not (late := early.max(self.norm / fall)) < window:
            raise self.undecided("does the slip end, turn around s = 0 or pass through it")
        self.drift(self.norm, late)
        if inside:
            self.mode = STICK
            self.happened(SLIP, end_direction(system, drive, self.load(late), drawn), late, "guard")
        else:
            self.begin(1, "guard", SLIP, late)

    def released(self, cause: str | None) -> None:
        """Choose the mode of bodies that move together where a piece of force begins, or at the start."""
        _, v1, v2 = self.system.given.start
        if cause is None:
            self.mode = STICK if v1 == v2 else SLIP
        self.held = cause is None and self.mode == STICK and never_leaves(self.system)
        if self.mode != STICK or self.held:
            return
        strain = self.system.pieces[self.at.piece].strain(self.load())
        if strain > 1:
            self.begin(1, cause, STICK, arb(0))
        elif not strain < 1:
            if cause is not None or not exactly_on_edge(self.system, self.system.axes):
                raise self.undecided("is the load inside the friction set")
            way = self.outward(arb(0))
            if way > 0:
                self.begin(2, None, STICK, arb(0))
            elif not way < 0:
                raise self.undecided("does the load leave the friction set at t = 0")
            self.on_edge = bool(way < 0)

    def begin(self, m: int, cause: str | None, before: str, late: arb) -> None:
        """Begin a slip, s = tau^m S(tau); without a cause it is how the run begins."""
        system = self.system
        drive, load = system.pieces[self.at.piece], self.load().each(arb.mid)
        series = onset(system, self.at, load, system.degree if m == 1 else int(0.75 * system.bits) + 8, m)
        h, top = self.reach(series, m)
        h, ends = self.fitted(h)
        first = Vector(one[0] for one in series.slip)
        direction = self.first_direction(first, self.load(late), m)
        self.mode, self.steps = SLIP, 0 if m == 1 else -1
        if cause is not None:
            self.happened(before, direction, late, cause)
        for _ in range(60):
            size, *slip = (scaled(x[:top], h) for x in (series.size, *series.slip))
            curve, found, slowest = self.along(series, h, top, Vector(slip), size, arb_poly([0] * m + [(h**m).mid()]))
            if found.norm < self.enough:
                break
            h, ends = (h / 2).mid(), False
        else:
            raise self.undecided("how does the slip begin")
        norm = (self.norm + found.norm).upper()
        window = (2 * drive.reach * norm / slowest).upper().root(m) + 2 * late
        if not (window < h / 2 and self.leaves(first if m == 1 else direction, window, m)):
            raise self.undecided("does the load leave the friction set, or only touch its edge")
        self.stride = h
        self.go_on(curve, SLIP, arb(1), norm, ends=ends)

    def first_direction(self, first: Vector, load: Vector, m: int) -> Vector:
        """Return S_0 of the true motion, not normalised: kap (Lam - P Lam) moves no more than Lam."""
        if m == 2:
            return Vector(load / self.system.pieces[self.at.piece].b_squared)
        radii = load.each(arb.rad)
        off = (radii * radii @ self.system.kappa).sqrt() + self.eps
        return Vector(wide(first, self.system.apart * off))

    def reach(self, series: Series, m: int) -> tuple[arb, int]:
        """Return how far the series of a slip reaches, and how many of its terms: for m != 1 it diverges."""
        first, *logs = (max(map(log2, one)) for one in zip(*series.slip, strict=True))
        reach = [min(64.0, (first - self.system.bits - one) / k) for k, one in enumerate(logs[:-1], start=1)]
        both = [min(two) for two in pairwise(reach)]
        found = both[-1] if m == 1 else max(both[3:])
        top = 2 + max(k for k, one in enumerate(both) if one >= found and (k > 2 or m == 1))
        return two_to(min(found, log2(self.period) + 4) - (0.1 if m == 1 else 0.4)), top + (m == 1)


def never_leaves(system: System) -> bool:
    """Return whether the load of bodies that stick at t = 0 stays in K as long as the first piece lasts, on exact data.

    Asked where it swings with one frequency, Lam = C cos W t + W^-1 Lam' sin W t: then K has the whole ellipse if and
    only if the larger root of B^-1 (C C^T + W^-2 Lam' Lam'^T) B^-1 is at most 1.
    """
    given, acting = system.given, system.given.pieces[0]
    if acting.sines or len(acting.polynomial) > 1 or any(map(any, given.a1)):
        return False
    q1, v1, m1, m2 = map(Vector, (*given.start[:2], given.m1, given.m2))

    def pull(x: Vector) -> Vector:
        return Vector(Vector(row) @ x for row in given.a2)

    push, rate = Vector(acting.polynomial[0] if acting.polynomial else [0] * system.n) - pull(q1), pull(v1)
    bends = [(one, pull(one / (m1 + m2))) for one in (push, rate)]
    square = next((y / x for pair in bends for x, y in zip(*pair, strict=True) if x), Fraction(1))
    if any(list(two) != list(one * square) for one, two in bends):
        return False
    weight = m2 * m2 / ((m1 + m2) * (m1 + m2) * Vector(acting.b_squared))
    place, mixed, speed = (weight * one @ two for one, two in ((push, push), (push, rate), (rate, rate)))
    return bool(place <= 1 and speed <= square and (1 - place) * (square - speed) >= mixed * mixed)
