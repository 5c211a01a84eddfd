"""A box |f_i| <= b_i whose axes are coupled: every axis sticks or slips by itself, and between events all is linear.

A mode is a word of + 0 -: f_i = +-b_i, or f_i = Lam_i where the axis sticks. The path, the bound N and the windows are
those of run.py, axis by axis: a slipping axis ends where s_i falls to 0, a stuck one where |Lam_i| rises to b_i.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from flint import arb, arb_poly

from numerics.arithmetic.ball import Ball
from numerics.errors import NotSettled
from numerics.plane.answer import PlaneSolution, Working
from numerics.plane.defect import Curve, Defect, defect
from numerics.plane.path import SLIP, Path
from numerics.plane.polynomial import first_root, least, scaled
from numerics.plane.reduced import reduced
from numerics.plane.series import Forcing, Point, Series
from numerics.plane.states import States
from numerics.plane.system import Balls, System
from numerics.scene.plane import PlaneScene
from numerics.trajectory.status import Status

SIGNS = {"+": 1, "0": 0, "-": -1}
_LETTER = {one: letter for letter, one in SIGNS.items()}
_MAX_LEGS = 200_000


def coupled(
    scene: PlaneScene, line: Callable[..., Any], working: int, name: str, limits: dict[str, Any]
) -> PlaneSolution:
    """Return the motion of a box with couplings. Raises EventUndecided, NotSettled."""
    del line
    run = BoxRun(System(reduced(scene), working), limits["max_events"], _MAX_LEGS, limits["progress"])
    run.follow()
    kept = [i for i, row in enumerate(run.system.given.place) if any(row)]

    def whole(word: str) -> str:
        letters = dict(zip(kept, word, strict=True))
        return "".join(letters.get(i, "0") for i in range(scene.pair.axes))

    with run.system.fine():
        states = States(scene, run)
        events = [states.event(one, whole) for one in run.events]
        modes = [whole(run.first), *(one.after for one in events)]
        status = Status.REACHED_HORIZON if run.reached else Status.EVENT_LIMIT
        return PlaneSolution(scene, Working(working, name), status, events, modes, states.end(), states)


class BoxRun(Path):
    """The path of a box; `young` are the axes that begin to slip at the point, with the order of the zero of s_i."""

    first = ""

    def follow(self) -> None:
        """Follow the path to the end, or to the cap on events."""
        self.young: dict[int, int] = {}
        v1, v2 = self.system.given.start[1:]
        self.mode = "".join(_LETTER[(x > y) - (x < y)] for x, y in zip(v1, v2, strict=True))
        with self.system.fine():
            self.released(None)
        self.first = self.mode
        while self.at.piece < len(self.system.pieces):
            if len(self.events) >= self.max_events:
                return
            if len(self.legs) >= self.max_legs:
                raise NotSettled(f"{len(self.legs)} steps end at t = {self.time:.6g} s; give an earlier horizon")
            piece = self.at.piece
            self.one_step()
            if piece < self.at.piece < len(self.system.pieces):
                with self.system.fine():
                    self.released("jump")
        self.reached = True

    def released(self, cause: str | None) -> None:
        """Let the axes go whose load a piece of force, or the start, puts outside."""
        load, drive, before = self.load(), self.system.pieces[self.at.piece], self.mode
        for i in self.system.axes:
            if before[i] == "0" and not abs(load[i]) < drive.b[i]:
                if not abs(load[i]) > drive.b[i]:
                    raise self.undecided("is the load inside the friction set")
                self.let_go(i, 1 if load[i] > 0 else -1, 1)
        if cause is not None and self.mode != before:
            self.tell(before, arb(0), cause)

    def let_go(self, i: int, sign: int, order: int) -> None:
        """Change the letter of an axis to that of a sign."""
        self.mode = self.mode[:i] + _LETTER[sign] + self.mode[i + 1 :]
        if order:
            self.young[i] = order

    def tell(self, before: str, late: arb, cause: str) -> None:
        """Record an event: the direction is that of the axes that slip after it."""
        self.happened(before, [arb(SIGNS[one]) for one in self.mode], late, cause)

    def series(self, degree: int) -> Series:
        """Return the coefficients by time (s)."""
        system, at, one = self.system, self.at, arb(1)
        drive, word = system.pieces[at.piece], [SIGNS[letter] for letter in self.mode]
        t, q1, v2, s = [at.t], [[x] for x in at.q1], [[x] for x in at.v2], [[x] for x in at.s]
        forcing, rate = Forcing(drive, t), [one]
        for k in range(degree):
            t.append(one if k == 0 else arb(0))
            u = forcing.next(k)
            now_q, now_v = [x[k] for x in q1], [x[k] + y[k] for x, y in zip(v2, s, strict=True)]
            for i in system.axes:
                push, f = system.push(u, now_q, now_v, i), drive.b[i] * word[i] if k == 0 else arb(0)
                if word[i] == 0:
                    v2[i].append((push / (system.mass[i] * (k + 1))).mid())
                    s[i].append(arb(0))
                else:
                    v2[i].append((f / (system.m2[i] * (k + 1))).mid())
                    s[i].append((((push - f) / system.m1[i] - f / system.m2[i]) / (k + 1)).mid())
                q1[i].append((now_v[i] / (k + 1)).mid())
            forcing.swing_on(k, rate)
            rate.append(arb(0))
        for i, order in self.young.items():
            s[i][:order] = [arb(0)] * order  # what is dropped is seen in the defect
        return Series(t, q1, v2, s)

    def one_step(self) -> None:
        """Go on for a step, or to the first event in it."""
        system, at = self.system, self.at
        drive, (q, v, _) = system.pieces[at.piece], self.sizes
        with system.fine():
            series = self.series(2 * system.degree)
            groups = [*((x, q) for x in series.q1), *((x, v) for x in series.v2), *((x, v) for x in series.s)]
            h, left = self.step(groups), (drive.length - at.t).mid()
        while True:
            ends = bool(h >= left)
            h = left if ends else h
            with system.fine():
                q1, v2, s = (tuple(scaled(x, h) for x in part) for part in series[1:])
            with system.fine():
                curve = self.curve(h, q1, v2, s)
                found = defect(system, curve, [arb(0)] * system.n)
                norm = (self.norm + found.norm).upper()
                if all(self.has_begun(i, s[i], norm, h) for i in self.young):
                    break
            h = (h / 2).mid()
            if h < left * self.eps and h < self.sizes[2] * self.eps:
                raise self.undecided("does the load leave the friction set, or only touch its edge")
        with system.fine():
            self.go_to_event(curve, found, norm, h, ends=ends)

    def curve(self, h: arb, q1: Any, v2: Any, s: Any) -> Curve:
        """Return a piece of the path."""
        system, at = self.system, self.at
        drive, t = system.pieces[at.piece], arb_poly([at.t, h])
        impulse = tuple(
            arb_poly([drive.b[i] * (h * SIGNS[self.mode[i]])])
            if self.mode[i] != "0"
            else v2[i].derivative() * system.m2[i]
            for i in system.axes
        )
        return Curve(at.piece, t, q1, v2, s, self.apart_of(s, t), impulse)

    def has_begun(self, i: int, s: arb_poly, norm: arb, h: arb) -> bool:
        """Return whether an axis surely slips, and goes on to, from where it begins to the end of a step.

        In a window that ends before another event the friction of all other axes that slip is known.
        """
        order, sign = self.young[i], SIGNS[self.mode[i]]
        shape = arb_poly([x * sign for x in s.coeffs()[order:]])
        low = least(shape)
        if not low > 0:
            return False
        window = (2 * self.system.apart[i] * norm / low).upper().root(order) * h + 2 * self.after
        self.clear = self.clear.max(window)
        normal = [arb(sign if j == i else 0) for j in self.system.axes]
        slips = [self.friction(j) if self.mode[j] != "0" and j != i else None for j in self.system.axes]
        return bool(window < h / 2) and self.leaves(normal, window, order, slips)

    def friction(self, i: int) -> arb:
        """Return the friction on an axis that slips, N."""
        return self.system.pieces[self.at.piece].b[i] * SIGNS[self.mode[i]]

    clear = arb(0)
    """Until when after the point no other event is allowed for, s."""
    after = arb(0)
    """By how much the event here may be misplaced, s."""

    def go_to_event(self, curve: Curve, found: Defect, norm: arb, h: arb, *, ends: bool) -> None:
        """Go to the end of a step or to the first event in it."""
        system, drive = self.system, self.system.pieces[curve.piece]
        roots = [(root, i) for i in system.axes if (root := self.end_of(i, curve, found, norm)) is not None]
        self.young, self.after = {}, arb(0)
        if not roots:
            self.go_on(curve, SLIP, arb(1), norm, ends=ends)
            self.clear = arb(0)
            return
        (x, off), i = min(roots, key=lambda one: float(one[0][0]))
        for (y, other), j in roots:
            if j != i and not x + off < y - other:
                raise self.undecided("which axis has its event first")
        if not (x - off) * h > self.clear:
            raise self.undecided("which axis has its event first")
        self.clear = arb(0)
        self.go_on(curve, SLIP, x, norm, ends=False)
        before, late, load = self.mode, (off * h).upper(), self.load()[i]
        if before[i] == "0":
            self.let_go(i, 1 if load > 0 else -1, 2)
        else:
            self.halt(i)
            load = self.around(late).load[i]
            if abs(load) < drive.b[i]:
                self.let_go(i, 0, 0)
            elif abs(load) > drive.b[i]:
                self.let_go(i, 1 if load > 0 else -1, 1)
            else:
                raise self.undecided("is the load inside the friction set where the slip ends")
        self.after = late
        self.tell(before, late, "guard")

    def end_of(self, i: int, curve: Curve, found: Defect, norm: arb) -> tuple[arb, arb] | None:
        """Return where an axis ends to slip or to stick in a step, and how far that may be off; None if it does not."""
        if i in self.young:
            return None
        if self.mode[i] == "0":
            return self.exit(curve, found, norm, (i,))
        root = first_root(curve.s[i] * SIGNS[self.mode[i]], (self.system.apart[i] * norm).upper())
        if isinstance(root, bool):
            raise self.undecided("does the slip turn or end")
        return root

    def halt(self, i: int) -> None:
        """Put s_i = 0 where the path has it, up to its errors."""
        system, at = self.system, self.at
        s = at.s[i]
        with system.fine():
            v2 = at.v2[i] + system.m1[i] / system.mass[i] * s
            self.norm = (self.norm + (system.root_m1[i] + system.root_m2[i]) * abs(s)).upper()
            self.set(Point(at.piece, at.t, at.q1, _put(at.v2, i, v2), _put(at.s, i, arb(0)), at.z))


def _put(values: Balls, i: int, value: arb) -> Balls:
    return [value if k == i else one for k, one in enumerate(values)]


def force_at(scene: PlaneScene, t: arb) -> Balls:
    """Return u at a time, N by axes."""
    found = []
    for force in scene.force:
        middle = Fraction(float(t.mid()))
        piece, value = force.piece_at(middle), arb(0)
        for one in reversed(piece.polynomial):
            value = value * (t - Ball.number(piece.start)) + Ball.number(one)
        for sine in piece.sines:
            value += Ball.number(sine.amplitude) * (Ball.number(sine.omega) * t + Ball.number(sine.phase)).sin()
        found.append(value)
    return found
