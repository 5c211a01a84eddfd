"""A box |f_i| <= b_i whose axes are coupled: every axis sticks or slips by itself, and between events all is linear.

A mode is a word of + 0 -: f_i = +-b_i, or f_i = Lam_i where the axis sticks. The path, the bound N and the windows are
those of an ellipsoid, axis by axis: a slipping axis ends where s_i falls to 0, a stuck one where |Lam_i| rises to b_i.
Since modes are linear, errors are carried on by components, too, and N never is more than these say (spread.py).
"""

from __future__ import annotations

from itertools import chain

from flint import arb, arb_poly

from numerics.plane.defect import Curve, Defect
from numerics.plane.path import AGAIN, LATE, SHORT, SLIP, Path, exactly_on_edge
from numerics.plane.polynomial import least
from numerics.plane.spread import Spread
from numerics.plane.vector import Vector, exact
from numerics.plane.window import BEYOND

SIGNS = {"+": 1, "0": 0, "-": -1}
_LETTER = {one: letter for letter, one in SIGNS.items()}


class BoxRun(Path):
    """The path of a box; `young` are the axes that begin to slip at the point, with the order of the zero of s_i.

    `on_edge` are those whose load falls from b_i at the point.
    """

    young: dict[int, int]
    on_edge: list[int]
    clear = arb(0)
    """Until when after the point no other event is allowed for, s."""
    after = arb(0)
    """By how much the event here may be misplaced, s."""
    over = arb(0)
    """Until when in the piece the last event may come, s."""
    spread: Spread

    def released(self, cause: str | None) -> None:
        """Let the axes go whose load a piece of force, or the start, puts outside."""
        if cause is None:
            self.young, self.on_edge, (_, v1, v2) = {}, [], self.system.given.start
            self.mode = "".join(_LETTER[(x > y) - (x < y)] for x, y in zip(v1, v2, strict=True))
            self.spread, (q1, v1, v2) = Spread(self.system), map(exact, self.system.given.start)
            q1, v2, s = (one.each(arb.rad) for one in (q1, v2, v1 - v2))
            self.spread = self.spread.grown(self.mode, self.norm, self.known((q1, s + v2, v2), self.norm))
        load, drive, before = self.load(), self.system.pieces[self.at.piece], self.mode
        on_edge = []
        for i in self.system.axes:
            if before[i] == "0" and not abs(load[i]) < drive.b[i]:
                if cause is None and exactly_on_edge(self.system, [i]):
                    on_edge.append(i)
                else:
                    self.let_go(i, load[i], 1, "is the load inside the friction set")
        for i in on_edge:
            way = self.outward(i, arb(0))
            if way > 0:
                self.let_go(i, load[i], 2)
            elif way < 0:
                self.on_edge.append(i)
            else:
                raise self.undecided("does the load leave the friction set at t = 0")
        if cause is not None and self.mode != before:
            self.tell(before, arb(0), cause)

    def outward(self, i: int, window: arb) -> arb:
        """Return the rate at which the load of an axis that sticks goes out, within a window."""
        near = self.around(window, self.friction)
        found: arb = near.drift[i] * near.load[i]
        return found

    def let_go(self, i: int, load: arb, order: int, question: str = "") -> None:
        """Let an axis slip the way of a load; of order 1, if that is outside."""
        if order == 1 and not abs(load) > self.system.pieces[self.at.piece].b[i]:
            raise self.undecided(question)
        self.put(i, "+" if load > 0 else "-")
        self.young[i] = order

    def put(self, i: int, letter: str) -> None:
        """Change the letter of an axis."""
        self.mode = self.mode[:i] + letter + self.mode[i + 1 :]

    def tell(self, before: str, late: arb, cause: str) -> None:
        """Record an event: the direction is that of the axes that slip after it."""
        self.happened(before, Vector(arb(SIGNS[one]) for one in self.mode), late, cause)

    @property
    def friction(self) -> list[arb | None]:
        """Return the friction on the axes that slip, N."""
        b = self.system.pieces[self.at.piece].b
        return [x * SIGNS[one] if one != "0" else None for x, one in zip(b, self.mode, strict=True)]

    def one_step(self) -> None:
        """Go on for a step, or to the first event in it."""
        friction = self.friction
        series, reach = self.linear(friction, self.system.degree)
        for i, order in self.young.items():
            series.slip[i][:order] = [arb(0)] * order  # what is dropped is seen in the defect
        while True:
            h, ends = self.fitted(reach)
            if not all(self.outward(i, h * SHORT) < 0 for i in self.on_edge):
                raise self.undecided("does the load leave the friction set at t = 0")
            curve, found, norm = self.drawn(series, h, friction)
            if not all(self.has_begun(i, curve.s[i], norm, h) for i in self.young):
                reach = (h / 2).mid()
                if reach < self.period * self.eps:
                    raise self.undecided("does the load leave the friction set, or only touch its edge")
                continue
            event = self.first_event(curve, found, norm, h)
            if event is None or event[0] > LATE:
                break
            reach = (h * event[0] * AGAIN).mid()
        self.young, self.on_edge, self.after = {}, [], arb(0)
        if event is None:
            self.passed(curve, found, arb(1), norm, ends=ends)
            self.norm, self.clear = self.norm.min(self.spread.norm), arb(0)
        else:
            x, off, i = event
            self.passed(curve, found, x, norm, ends=False)
            self.change(i, (off * h).upper())

    def drift(self, norm: arb, passed: arb) -> None:
        """Let z be off by what v1 - v2 is off for a time, on the axes that slip."""
        slips = Vector(arb(one != "0") for one in self.mode)
        self.apart = (self.apart + self.system.apart * slips * (norm * passed)).each(arb.upper)

    def passed(self, curve: Curve, found: Defect, end: arb, norm: arb, *, ends: bool) -> None:
        """Go to the end of a curve; the spread goes on, too."""
        before, start = self.norm, self.at.t
        self.go_on(curve, SLIP, end, norm, ends=ends)
        time = (self.system.pieces[curve.piece].length if ends else self.at.t) - start
        q1, v2, s = (part.each(lambda p: p(end).rad()) for part in curve[2:5])
        parts = self.known((q1, s + v2, v2), self.norm - norm)
        self.spread = self.spread.stepped(self.mode, time, (self.norm - before).upper(), found.parts, parts)
        self.over = arb(0) if ends else self.over

    def known(self, rounded: tuple[Vector, Vector, Vector], by: arb) -> Vector:
        """Return bounds on the components of what is rounded, and of what else is up to `by` in N."""
        rest = (by - self.system.norm(*rounded)).max(arb(0))
        return Vector(x + y * rest for x, y in zip(chain(*rounded), self.spread.weights, strict=True))

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

    def first_event(self, curve: Curve, found: Defect, norm: arb, h: arb) -> tuple[arb, arb, int] | None:
        """Return where in a step an axis changes first, how far that may be off, and the axis; None if none does."""
        roots = [(root, i) for i in self.system.axes if (root := self.end_of(i, curve, found, norm)) is not None]
        if not roots:
            return None
        (x, off), i = min(roots, key=lambda one: float(one[0][0]))
        others = [y - other for (y, other), j in roots if j != i]
        if not all(x + off < one for one in others) or not (x - off) * h > self.clear:
            raise self.undecided("which axis has its event first")
        return x, off, i

    def change(self, i: int, late: arb) -> None:
        """Change the mode of an axis at the point, which its event is within `late` (s) of.

        With the rate of s_i or of the load in that window the spread says it better.
        """
        system, drive, before = self.system, self.system.pieces[self.at.piece], self.mode
        alone, reached, self.clear = bool(self.at.t - late > self.over), self.norm, arb(0)
        self.drift(reached, late)
        if before[i] == "0":
            near, load, middle = self.around(late, self.friction), self.load()[i], self.load_there[i]
            rate, off = near.drift[i], self.spread.of_load(i) + abs(abs(middle) - drive.b[i])
            self.let_go(i, load, 2)
        else:
            self.halt(Vector(s if j == i else arb(0) for j, s in enumerate(self.at.s)))
            self.spread = self.spread.grown(before, (self.norm - reached).upper())
            near, slips = self.around(late), drive.b[i] * SIGNS[before[i]]
            load = near.load[i]
            rate, off = system.kappa[i] * (load - slips), self.spread.of_slip(i)
            if abs(load) < drive.b[i]:
                self.put(i, "0")
            else:
                self.let_go(i, load, 1, "is the load inside the friction set where the slip ends")
        stuck = [j for j in system.axes if "0" in (before[j], self.mode[j])]
        if alone and not rate.contains(0) and all(abs(near.load[j]) < drive.b[j] * BEYOND for j in stuck):
            late, earlier = late.min((off / abs(rate)).upper()), self.spread.norm
            if before[i] == "0":  # what slips lacks at most steep |t - t_event| of friction
                second = system.apart[i] * near.steep[i] * late * late
                self.spread = self.spread.grown(self.mode, second.upper())
            else:
                held = load if self.mode[i] == "0" else drive.b[i] * SIGNS[self.mode[i]]
                self.spread = self.spread.switched(before, i, late, held - slips, rate)
            self.norm = self.norm.min(earlier.max(self.spread.norm))
        else:
            self.spread = Spread(system).grown("+" * system.n, self.norm)
        self.drift(reached, late)
        self.after, self.over = late, self.at.t + late
        self.tell(before, late, "guard")

    def end_of(self, i: int, curve: Curve, found: Defect, norm: arb) -> tuple[arb, arb] | None:
        """Return where an axis ends to slip or to stick in a step, and how far that may be off; None if it does not."""
        if i in self.young:
            return None
        if self.mode[i] == "0":
            return self.exit(curve, found, norm, (i,), SHORT if i in self.on_edge else 0.0)
        return self.root(curve.s[i] * SIGNS[self.mode[i]], self.system.apart[i] * norm, "does the slip turn or end")
