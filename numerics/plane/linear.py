"""Modes between whose events all is linear: groups of axes stick, or an axis slips with a constant friction.

Each axis of a box |f_i| <= b_i is a group, which sticks or slips by itself: a mode is a word of + 0 -, f_i = +-b_i, or
f_i = Lam_i where it sticks. An ellipsoid is one group of all axes, of which here is what it does while it sticks
(run.py has the rest). An axis that slips stops where s_i falls to 0, a group leaves where its load gets out of K.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_poly

from numerics.errors import NotSettled
from numerics.plane.defect import Defect, defect
from numerics.plane.path import OUTSIDE, PlanePath
from numerics.plane.polynomial import least
from numerics.plane.series import PlaneExpansion, TaylorCurve
from numerics.plane.vector import Vector

SIGNS = {"+": 1, "0": 0, "-": -1}
LETTERS = {sign: letter for letter, sign in SIGNS.items()}
AT_FIRST = "does the load leave the friction set at t = 0"
LATE, AGAIN = 31 / 32, 65 / 64
"""An event before that part of a step has it drawn again, so much longer than to the event: with the defect of that."""
SHORT = 2.0**-20
"""The part of a step after which a load that falls from the edge into K is seen inside."""


class LinearRun(PlanePath):
    """The path of a box; `young` are the groups that begin to slip at the point, with the order of the zero of s.

    `on_edge` are those whose load falls inside from the edge of K at the point; `held`: nothing but another piece of
    force or friction ends this stick.
    """

    young: dict[int, int]
    on_edge: list[int]
    held = False
    clear = arb(0)
    """Until when after the point no other event is allowed for, s."""
    after = arb(0)
    """By how much the event here may be misplaced, s."""

    @property
    def groups(self) -> Sequence[Sequence[int]]:
        """Return the axes that stick and slip together."""
        return [[i] for i in self.system.axes]

    def follow(self) -> None:
        """Follow the path to the end, or to the cap on events. Raises EventUndecided, NotSettled."""
        pieces = self.system.pieces
        with self.system.fine():
            self.released("jump" if self.at.piece else None)
            while self.at.piece < len(pieces):
                if len(self.events) >= self.max_events:
                    return
                if len(self.legs) >= self.max_legs:
                    raise NotSettled(f"{len(self.legs)} steps end at t = {self.time:.6g} s; give an earlier horizon")
                piece = self.at.piece
                self.one_step()
                if piece < self.at.piece < len(pieces):
                    self.released("jump")
                if self.progress is not None and len(self.legs) % 32 == 0:
                    self.progress(len(self.events), self.time / float(self.system.given.pieces[-1].end))
            self.reached = True

    def put(self, k: int, way: Vector) -> None:
        """Let a group slip the way of a vector, or stick if that is 0."""
        axes, letters = self.groups[k], [*self.mode]
        signs = [(way[i] > 0) - (way[i] < 0) for i in axes]
        for i in axes:
            letters[i] = "0" if not any(signs) else "*" if len(axes) > 1 else LETTERS[signs[0]]
        self.mode = "".join(letters)

    def released(self, cause: str | None) -> None:
        """Let go of what the load, where a piece of force begins or at the start, is outside of K."""
        given, groups = self.system.given, range(len(self.groups))
        if cause is None:
            self.young, self.on_edge, (_, v1, v2) = {}, [], map(Vector, given.start)
            self.mode = "0" * self.system.n
            for k in groups:
                self.put(k, v1 - v2)
        self.held = cause is None and set(self.mode) == {"0"} and given.sticks_for_ever(self.groups)
        load, before, on_edge = self.load, self.mode, []
        for k in groups:
            axes = self.groups[k]
            if before[axes[0]] == "0" and not self.held and not self.drive.strain(load, axes) < 1:
                if cause is None and given.is_on_edge(axes):
                    on_edge.append(k)
                else:
                    self.let_go(k, load, 1)
        for k in on_edge:
            way = self.outward(k, arb(0))
            if way > 0:
                self.let_go(k, load, 2)
            elif way < 0:
                self.on_edge.append(k)
            else:
                raise self.undecided(AT_FIRST)
        if cause is not None and self.mode != before:
            self.tell(before, arb(0), cause)

    def outward(self, k: int, window: arb) -> arb:
        """Return half the rate of |B^-1 Lam|^2 of a group that sticks, within a window."""
        near, b_squared = self.around(window, self.friction), self.drive.b_squared
        return sum((near.load[i] * near.drift[i] / b_squared[i] for i in self.groups[k]), arb(0))

    def let_go(self, k: int, load: Vector, order: int, question: str = "is the load inside the friction set") -> None:
        """Let a group slip the way of a load; of order 1, if that is outside."""
        if order == 1 and not self.drive.strain(load, self.groups[k]) > 1:
            raise self.undecided(question)
        self.put(k, load)
        self.young[k] = order

    def tell(self, before: str, late: arb, cause: str) -> None:
        """Record an event: the direction is that of the axes that slip after it, of a line also of what slipped."""
        slips = before if self.mode == "0" else self.mode
        self.happened(before, Vector(arb(SIGNS[one]) for one in slips), late, cause)

    @property
    def friction(self) -> list[arb | None]:
        """Return the friction on the axes that slip, N."""
        return [None if one == "0" else x * SIGNS[one] for x, one in zip(self.drive.b, self.mode, strict=True)]

    def one_step(self) -> None:
        """Go on for a step, or to the first event in it."""
        friction = self.friction
        expansion = PlaneExpansion(self.system, self.at, friction)
        reach = self.step(expansion, self.speed)
        for k, order in self.young.items():  # what is dropped is seen in the defect
            whole = expansion.polynomials[k].coeffs()
            expansion.polynomials[k] = arb_poly([0] * order + whole[order:])
        while True:
            h, ends = self.fitted(reach)
            if not all(self.outward(k, h * SHORT) < 0 for k in self.on_edge):
                raise self.undecided(AT_FIRST)
            curve = expansion.drawn(h)
            found = defect(self.system, curve, self.system.still)
            norm = (self.norm + found.norm).upper()
            if not all(self.has_begun(i, curve.s[i], norm, h) for i in self.young):
                reach = (h / 2).mid()
                if reach < self.system.period * self.eps:
                    raise self.undecided(OUTSIDE)
                continue
            event = self.first_event(curve, found, norm, h)
            if event is None or event[0] > LATE:
                break
            reach = (h * event[0] * AGAIN).mid()
        self.young, self.on_edge, self.after = {}, [], arb(0)
        x, late, k = (arb(1), arb(0), 0) if event is None else event
        self.go_on(curve, x, norm, ends=ends and event is None)
        if event is None:
            self.clear = arb(0)
        else:
            self.change(k, (late * h).upper())

    def has_begun(self, i: int, s: arb_poly, norm: arb, h: arb) -> bool:
        """Return whether an axis surely slips, and goes on to, from where it begins to the end of a step.

        In a window that ends before another event the friction of all other axes that slip is known.
        """
        order, sign = self.young[i], SIGNS[self.mode[i]]
        low = least(arb_poly([x * sign for x in s.coeffs()[order:]]))
        if not low > 0:
            return False
        window = (2 * self.system.apart[i] * norm / low).upper().root(order) * h + 2 * self.after
        self.clear = self.clear.max(window)
        normal = Vector(arb(sign if j == i else 0) for j in self.system.axes)
        slips = [None if j == i else f for j, f in enumerate(self.friction)]
        return bool(window < h / 2) and self.leaves(normal, window, order, slips)

    def first_event(self, curve: TaylorCurve, found: Defect, norm: arb, h: arb) -> tuple[arb, arb, int] | None:
        """Return where in a step a group changes first, how far that may be off, and which; None if none does."""
        roots = [(root, k) for k in range(len(self.groups)) if (root := self.end_of(k, curve, found, norm)) is not None]
        if not roots:
            return None
        (x, off), k = min(roots, key=lambda one: float(one[0][0]))
        others = [y - other for (y, other), j in roots if j != k]
        if not all(x + off < one for one in others) or not (x - off) * h > self.clear:
            raise self.undecided("which axis has its event first")
        return x, off, k

    def end_of(self, k: int, curve: TaylorCurve, found: Defect, norm: arb) -> tuple[arb, arb] | None:
        """Return where a group ends to slip or to stick in a step, and how far that may be off; None if it does not."""
        axes, load, b_squared = self.groups[k], found.load, self.drive.b_squared
        if k in self.young or self.held:
            return None
        if (sign := SIGNS[self.mode[axes[0]]]) != 0:
            error = (self.system.apart[k] * norm).upper()
            return self.root(curve.s[k] * sign, error, "does the slip turn or end")
        off = self.system.load_error * norm + found.load_error
        inside = arb_poly([1]) - sum(load[i] * load[i] * (1 / b_squared[i]) for i in axes)

        def unsure(size: Vector) -> arb:
            """Return what |B^-1 Lam|^2 is off, where the load is not larger."""
            return sum((off[i] * (2 * size[i] + off[i]) / b_squared[i] for i in axes), arb(0)).upper()

        root = self.root(inside, unsure(self.drive.b), OUTSIDE, SHORT if k in self.on_edge else 0.0)
        if root is None:
            return None
        (x, far), there = root, root[0] + arb(0, root[1])
        off_there = unsure(Vector(abs(one(there)) for one in load)) + abs(inside(x))
        steep = -inside.derivative()(there)
        return x, far.min((off_there / steep).upper()) if steep > 0 else far

    def change(self, i: int, late: arb) -> None:
        """Change the mode of a group at the point, which its event is within `late` (s) of."""
        before, reached = self.mode, self.norm
        self.drift(reached, late)
        if before[i] == "0":
            self.let_go(i, self.load, 2)
        else:
            self.halt(Vector(s if j == i else arb(0) for j, s in enumerate(self.at.s)))
            load = self.around(late).load
            if abs(load[i]) < self.drive.b[i]:
                self.put(i, self.system.still)
            else:
                self.let_go(i, load, 1, "is the load inside the friction set where the slip ends")
        self.drift(reached, late)
        self.after, self.clear = late, arb(0)
        self.tell(before, late, "guard")
