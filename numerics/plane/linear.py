"""Modes between whose events all is linear: groups of axes stick, or an axis slips with a constant friction.

Each axis of a box |f_i| <= b_i is a group, which sticks or slips by itself: a mode is a word of + 0 -, f_i = +-b_i, or
f_i = Lam_i where it sticks. An ellipsoid is one group of all axes, of which here is what it does while it sticks
(run.py has the rest). An axis that slips stops where s_i falls to 0, a group leaves where its load gets out of K.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_poly

from numerics.arithmetic.ball import sqrt
from numerics.plane.defect import Defect, defect
from numerics.plane.path import OUTSIDE, PlanePath
from numerics.plane.polynomial import first_root, least
from numerics.plane.series import Expansion
from numerics.plane.vector import Vector

SIGNS = {"+": 1, "0": 0, "-": -1}
AT_FIRST = "does the load leave the friction set at t = 0"
SHORT = 2.0**-20
"""The part of a step after which a load that falls from the edge into K is seen inside."""


class LinearPath(PlanePath):
    """A path as it sticks, or slips with constant friction.

    `young` are the groups that begin to slip at the point, with the order of the zero of s; `on_edge` those whose load
    falls inside from the edge of K; `held`: nothing but another piece of force or friction ends this stick.
    """

    young: dict[int, int]
    on_edge: Sequence[int] = ()
    held = False
    clear = arb(0)
    """Until when after the point no other event is allowed for, s."""
    after = arb(0)
    """By how much the event here may be misplaced, s."""

    def start(self) -> None:
        """Slip where the bodies do at t = 0, and where the load is outside of K, or goes out of it from its edge."""
        given, groups, (_, v1, v2) = self.system.given, self.system.groups, self.system.given.start
        self.young = {}
        for k in range(len(groups)):
            self.put(k, v1 - v2)
        self.held = set(self.mode) == {"0"} and given.sticks_for_ever(groups)
        stuck = [k for k, axes in enumerate(groups) if self.mode[axes[0]] == "0" and given.is_on_edge(axes)]
        self.release(stuck)
        ways = {} if self.held else {k: self.outward(k, arb(0)) for k in stuck}
        if not all(way > 0 or way < 0 for way in ways.values()):
            raise self.undecided(AT_FIRST)
        self.on_edge, load = [k for k, way in ways.items() if way < 0], self.load
        for k in ways.keys() - self.on_edge:
            self.let_go(k, load, 2)

    def release(self, kept: Sequence[int] = ()) -> None:
        """Let go of the groups whose load is outside of K, but of those that are `kept`."""
        load = self.load
        for k, axes in enumerate(self.system.groups):
            if not (self.held or k in kept or self.mode[axes[0]] != "0" or self.drive.strain(load, axes) < 1):
                self.let_go(k, load, 1)

    def jump(self) -> None:
        """Go on where another piece of force or friction begins."""
        before, self.held = self.mode, False
        self.release()
        if self.mode != before:
            self.tell(before, arb(0), "jump")

    def outward(self, k: int, window: arb) -> arb:
        """Return half the rate of |B^-1 Lam|^2 of a group that sticks, within a window."""
        near, b_squared = self.around(window, self.friction), self.drive.b_squared
        return sum((near.load[i] * near.drift[i] / b_squared[i] for i in self.system.groups[k]), arb(0))

    def let_go(self, k: int, load: Vector, order: int, question: str = "is the load inside the friction set") -> None:
        """Let a group slip the way of a load; of order 1, if that is outside."""
        if order == 1 and not self.drive.strain(load, self.system.groups[k]) > 1:
            raise self.undecided(question)
        self.put(k, load)
        self.young[k] = order

    def put(self, k: int, way: Vector) -> None:
        """Let a group slip the way of a vector, or stick if that is 0."""
        axes, letters = self.system.groups[k], [*self.mode]
        signs = ["+" if way[i] > 0 else "-" if way[i] < 0 else "0" for i in axes]
        for i in axes:
            letters[i] = signs[0] if len(axes) == 1 else "*" if {*signs} != {"0"} else "0"
        self.mode = "".join(letters)

    def tell(self, before: str, late: arb, cause: str) -> None:
        """Record an event: the direction is that of the axes that slip after it, of a line also of what slipped."""
        slips = before if self.mode == "0" else self.mode
        self.record(before, Vector(arb(SIGNS[one]) for one in slips), late, cause)

    @property
    def friction(self) -> list[arb | None]:
        """Return the friction on the axes that slip, N."""
        return [None if one == "0" else x * SIGNS[one] for x, one in zip(self.drive.b, self.mode, strict=True)]

    def one_step(self) -> None:
        """Go on for a step, or to the first event in it."""
        system, expansion = self.system, Expansion(self.system, self.at, self.friction)
        reach = expansion.reach(system.speed)
        for k, order in self.young.items():  # what is dropped is seen in the defect
            whole = expansion.polynomials[k].coeffs()
            expansion.polynomials[k] = arb_poly([0] * order + whole[order:])
        while True:
            h, ends = self.fitted(reach)
            if not all(self.outward(k, h * SHORT) < 0 for k in self.on_edge):
                raise self.undecided(AT_FIRST)
            step = expansion.drawn(h)
            found = defect(system, step, system.still)
            norm = (self.norm + found.norm).upper()
            if all(self.has_begun(i, step.curve.s[i], norm, h) for i in self.young):
                break
            reach = (h / 2).mid()
            if reach < system.period * system.eps:
                raise self.undecided(OUTSIDE)
        event = self.next_event(step.curve.s, found, norm, h)
        self.young, self.on_edge, self.after = {}, (), arb(0)
        x, late, k = (arb(1), arb(0), 0) if event is None else event
        self.go_on(step.curve, x, norm, ends=ends and event is None)
        self.clear = arb(0)
        if event is not None:
            self.resolve(k, (late * h).upper())

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

    def next_event(self, s: Vector, found: Defect, norm: arb, h: arb) -> tuple[arb, arb, int] | None:
        """Return where in a step a group changes first, how far that may be off, and which; None if none does."""
        roots = [(*root, k) for k in range(len(self.system.groups)) if (root := self.end_of(k, s, found, norm))]
        if not roots:
            return None
        x, off, k = min(roots, key=lambda one: float(one[0]))
        others = [y - other for y, other, j in roots if j != k]
        if not all(x + off < one for one in others) or not (x - off) * h > self.clear:
            raise self.undecided("which axis has its event first")
        return x, off, k

    def end_of(self, k: int, s: Vector, found: Defect, norm: arb) -> tuple[arb, arb] | None:
        """Return where a group ends to slip or to stick in a step, and how far that may be off; None if it does not."""
        axes, drive = self.system.groups[k], self.drive
        if k in self.young or self.held:
            return None
        sign = SIGNS[self.mode[axes[0]]]
        if sign:
            root = first_root(s[k] * sign, (self.system.apart[k] * norm).upper())
        else:  # of |B^-1 Lam| <= 1 the square is off by 2 |B^-1 off| + |B^-1 off|^2
            strain = drive.strain(self.system.load_error * norm + found.load_error, axes)
            inside, off = 1 - drive.strain(found.load, axes), (2 * sqrt(strain) + strain).upper()
            root = first_root(inside, off, SHORT if k in self.on_edge else 0.0)
        if isinstance(root, bool):
            raise self.undecided("does the slip turn or end" if sign else OUTSIDE)
        return root

    def resolve(self, k: int, late: arb) -> None:
        """Change the mode of a group at the point, which its event is within `late` (s) of."""
        before, axes = self.mode, self.system.groups[k]
        if before[axes[0]] == "0":
            self.let_go(k, self.load, 2)
        else:
            self.halt(Vector(s if j in axes else arb(0) for j, s in enumerate(self.at.s)))
            load = self.around(late).load
            if self.drive.strain(load, axes) < 1:
                self.put(k, self.system.still)
            else:
                self.let_go(k, load, 1, "is the load inside the friction set where the slip ends")
        self.after = late
        self.tell(before, late, "guard")
